//! Clutter: small objects in their habitual places, on surfaces, in cupboards, drawers and the
//! fridge, on hooks and shelves.
//!
//! First come the objects that a piece needs (bedding on the bed, a tap at the sink, the television
//! on its stand), then others sampled by the habit weights of the class table. Every object lies
//! within a surface of its carrier, and no two on one surface overlap.

mod dress;
mod habits;
mod set;
mod surface_filler;
mod surroundings;

use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

use vc_graph::asset::Hold;
use vc_graph::{ClassTable, Seed};
use vc_shapes::Generators;

use crate::apartment::Apartment;
use crate::dressing::Household;
use crate::item::{Item, Support};
use habits::{Choice, Habits, Place};
use surface_filler::{SurfaceFiller, Taken};
use surroundings::Surroundings;

/// Fills an apartment; `amount` ranges from 0 (only the objects that furniture needs) to 1. With a household the lines of
/// its table come before the habits.
pub(crate) fn fill(
    home: &mut Apartment,
    generators: &Generators,
    household: Option<&Household>,
    amount: f32,
    seed: Seed,
) {
    let carriers: Vec<usize> = (0..home.items.len()).filter(|&index| carries(&home.items[index])).collect();
    let standing = standing(&home.items);
    let mut choices = Choices { habits: Habits::with(generators), known: HashMap::new() };
    let mut taken: Vec<Option<Taken>> = vec![None; home.items.len()];
    let own = |home: &Apartment, index: usize| match household {
        Some(_) => home.items[index].seed(seed.child("clutter")),
        None => seed.child("clutter").nth(index as u64),
    };
    for &index in &carriers {
        let first = standing.partition_point(|s| s.carrier < index);
        let on_it = standing[first..].iter().take_while(|s| s.carrier == index);
        let on_it = on_it.map(|s| (s.surface, s.item));
        let seed = own(home, index);
        let mut filler = SurfaceFiller::new(home, generators, index, seed, on_it);
        if household.is_some() {
            set::equip(&mut filler);
            taken[index] = Some(filler.into_taken());
        } else {
            set::dress(&mut filler, amount);
            (0..filler.surfaces()).for_each(|surface| fill_surface(&mut filler, surface, &mut choices, amount));
        }
    }
    let Some(household) = household else { return };
    let mut surroundings = Surroundings::new(home);
    dress::dress(home, generators, household, (&mut taken, &mut surroundings));
    for index in carriers {
        let on_it = taken[index].take().unwrap_or_default();
        let seed = own(home, index).child("habits");
        let filler = SurfaceFiller::resume(home, generators, index, seed, on_it).by_habit();
        let mut filler = filler.among(&mut surroundings);
        (0..filler.surfaces()).for_each(|surface| fill_surface(&mut filler, surface, &mut choices, amount));
    }
}

/// Whether things are put on or in an item.
fn carries(item: &Item) -> bool {
    item.support != Support::Built && !item.object.asset.surfaces.is_empty()
}

/// A piece of furniture that stands on another, such as a bowl on its vanity.
struct Standing {
    carrier: usize,
    surface: usize,
    item: usize,
}

/// The items that stand on other furniture, ordered by carrier.
fn standing(items: &[Item]) -> Vec<Standing> {
    let mut all: Vec<Standing> = Vec::new();
    for (item, thing) in items.iter().enumerate() {
        if let Support::On(carrier, surface) | Support::Inside(carrier, surface) = thing.support {
            all.push(Standing { carrier, surface, item });
        }
    }
    all.sort_by_key(|s| s.carrier);
    all
}

/// The choices for each kind of place, looked up once per home.
struct Choices {
    habits: Cow<'static, Habits>,
    known: HashMap<Place, Rc<Choice>>,
}

impl Choices {
    fn at(&mut self, place: Place) -> Rc<Choice> {
        self.known.entry(place).or_insert_with_key(|place| Rc::new(self.habits.choice(place))).clone()
    }
}

/// Puts habitual objects on a surface, their number depending on its area and the amount.
fn fill_surface(filler: &mut SurfaceFiller<'_>, surface: usize, choices: &mut Choices, amount: f32) {
    let (class, room) = (filler.class(), filler.room_class());
    let Some(s) = filler.surface(surface) else { return };
    let (hold, area) = (s.hold, 4.0 * s.half.0 * s.half.1);
    let kept = choices.at(Place { carrier: class, drawer: s.name.starts_with("drawer"), hold, room });
    let density = match hold {
        Hold::Inside => 20.0,
        Hold::On if matches!(class, "sofa" | "armchair" | "chair" | "dining_chair" | "office_chair") => 0.4,
        Hold::On if ClassTable::builtin().is_a(class, "bed") => 0.3,
        Hold::On => 7.0,
        Hold::Hook => return,
    };
    if kept.is_empty() || amount <= 0.0 {
        return;
    }
    let most = if hold == Hold::Inside { 7.0 } else { 8.0 };
    let mean = (area * density).min(most) * amount * 1.3;
    let mut left = (mean * filler.rng.between(0.4, 1.5) + filler.rng.unit()) as usize;
    while left > 0 {
        left -= 1;
        let Some(class) = kept.draw(filler.rng.unit()) else { continue };
        let Some(first) = filler.put(class, surface) else { continue };
        // Objects of some classes are kept in groups.
        let more = set::together(class, &mut filler.rng);
        for _ in 0..more.min(left + 2) {
            if filler.put_beside(first, surface).is_none() {
                break;
            }
            left = left.saturating_sub(1);
        }
    }
}
