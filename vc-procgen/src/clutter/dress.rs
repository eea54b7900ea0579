//! Dressing with small things on, in and from furniture, by the lines of a table.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Isometry3, Point3, Vector3};
use vc_graph::asset::Hold;
use vc_graph::portable::Portable;
use vc_graph::{Pose, Property, Seed, Stream};
use vc_shapes::Generators;

use super::set;
use super::surface_filler::{SurfaceFiller, Taken};
use super::surroundings::Surroundings;
use crate::apartment::Apartment;
use crate::area::Area;
use crate::draft::Draft;
use crate::dressing::{Anchor, Household, Place, Rule, Side};
use crate::item::Support;

/// The places tried beside a thing.
const TRIES: usize = 14;
/// The farthest that a chair stands from the table it is for, metres.
const AT_TABLE: f32 = 0.3;

/// Puts the small things of all rules into a home. `taken` has for each item the occupied areas of its surfaces.
pub(super) fn dress(
    home: &mut Apartment,
    generators: &Generators,
    household: &Household,
    (taken, surroundings): (&mut Vec<Option<Taken>>, &mut Surroundings),
) {
    for room in 0..home.plan.rooms.len() {
        let kind = home.plan.rooms[room].kind;
        let here = (0..home.items.len()).filter(|&i| home.items[i].room == room).collect::<Vec<_>>();
        let mut dresser = Dresser { home, generators, household, taken, surroundings, here: BTreeMap::new() };
        here.into_iter().for_each(|item| dresser.note(item));
        for (rule, seed) in household.rules(room, kind) {
            if rule.place.is_furniture() {
                dresser.furnish(rule, seed);
            } else {
                dresser.apply(rule, seed, None);
            }
        }
    }
}

/// Dresses one room.
struct Dresser<'a> {
    home: &'a mut Apartment,
    generators: &'a Generators,
    household: &'a Household,
    taken: &'a mut Vec<Option<Taken>>,
    surroundings: &'a mut Surroundings,
    /// The items of the room by class.
    here: BTreeMap<&'static str, Vec<usize>>,
}

impl Dresser<'_> {
    /// Applies the rules about pieces of furniture that a rule names.
    fn furnish(&mut self, rule: &Rule, seed: Seed) {
        if rule.then.is_empty() {
            return;
        }
        for piece in self.pieces(&rule.things.classes) {
            self.go_on(rule, self.home.items[piece].seed(seed), piece);
        }
    }

    /// Counts an item as one of the room.
    fn note(&mut self, item: usize) {
        self.here.entry(self.home.items[item].object.class).or_default().push(item);
    }

    /// The items of the room that are of some classes.
    fn pieces(&self, classes: &[Arc<str>]) -> Vec<usize> {
        classes.iter().filter_map(|class| self.here.get(&**class)).flatten().copied().collect()
    }

    /// Applies a rule, about a thing if it is below another rule.
    fn apply(&mut self, rule: &Rule, seed: Seed, it: Option<usize>) {
        let mut rng = seed.stream();
        if !self.household.is_met(rule) {
            return;
        }
        let anchor = match &rule.place {
            Place::On { anchor, .. } | Place::In(anchor) | Place::Hang(anchor) => anchor,
            Place::Row(anchor) | Place::Seat(anchor) => anchor,
            _ => &Anchor::It,
        };
        let (mut carriers, each) = match anchor {
            Anchor::It => (Vec::from_iter(it), false),
            Anchor::Piece { classes, each } => (self.pieces(classes), *each),
        };
        if carriers.is_empty() {
            return;
        }
        if each {
            for carrier in carriers {
                if rng.chance(rule.chance) {
                    self.put_all(rule, self.home.items[carrier].seed(seed), &[carrier], &mut rng);
                }
            }
        } else if rng.chance(rule.chance) {
            rng.shuffle(&mut carriers);
            self.put_all(rule, seed, &carriers, &mut rng);
        }
    }

    /// Puts the things of a rule on the first of some carriers that have space.
    fn put_all(&mut self, rule: &Rule, seed: Seed, carriers: &[usize], rng: &mut Stream) {
        let count = rng.count(rule.things.count.0, rule.things.count.1);
        let mut first: Option<usize> = None;
        let mut from = 0;
        for number in 0..count {
            let own = seed.nth(number as u64);
            let Some(class) = rng.pick(&rule.things.classes) else { return };
            let like = first.filter(|_| rule.things.alike);
            let put = (from..carriers.len()).find_map(|at| Some((at, self.put(rule, own, carriers[at], class, like)?)));
            let Some((at, item)) = put else { continue };
            (from, first) = (at, Some(item));
            self.go_on(rule, own, item);
        }
    }

    /// Applies the rules below a rule to a thing that it has put.
    fn go_on(&mut self, rule: &Rule, seed: Seed, item: usize) {
        for below in &rule.then {
            self.apply(below, below.seed(seed.child("then")), Some(item));
        }
    }

    /// Puts one thing; an object like another one if there is one to be like.
    fn put(&mut self, rule: &Rule, seed: Seed, anchor: usize, class: &Arc<str>, like: Option<usize>) -> Option<usize> {
        if let Place::Beside(side) = rule.place {
            return self.put_beside(side, seed, anchor, class);
        }
        let chairs = if matches!(rule.place, Place::Seat(_)) { self.chairs_at(anchor) } else { Vec::new() };
        let before = self.home.items.len();
        self.filled(anchor, seed, |k| {
            let like = like.map(|item| k.copy_of(item));
            match &rule.place {
                Place::On { back: true, .. } => {
                    let object = like.or_else(|| k.make(class, None))?;
                    k.holding(Hold::On).into_iter().find_map(|surface| k.put_back(&object, surface))
                }
                Place::On { .. } => put_inside_or_on(k, Hold::On, class, like),
                Place::In(_) => put_inside_or_on(k, Hold::Inside, class, like),
                Place::Hang(_) => k.holding(Hold::Hook).into_iter().find_map(|surface| hang(k, class, surface)),
                Place::Row(_) => {
                    let filled = k.rng.between(0.35, 0.9);
                    let shelves: Vec<usize> = [Hold::Inside, Hold::On].into_iter().flat_map(|h| k.holding(h)).collect();
                    shelves.into_iter().find_map(|surface| set::row(k, surface, &rule.things.classes, filled))
                }
                Place::Seat(_) => {
                    let object = like.or_else(|| k.make(class, None))?;
                    chairs.iter().find_map(|chair| k.put_before_seat(&object, chair))
                }
                _ => None,
            }
        })
        .inspect(|_| (before..self.home.items.len()).for_each(|item| self.note(item)))
    }

    /// The places of the chairs at a table, in the table's frame.
    fn chairs_at(&self, table: usize) -> Vec<Area> {
        let (top, own) = (self.home.items[table].area(), self.home.items[table].pose.inverse());
        let at_table = |item: &&usize| {
            let chair = &self.home.items[**item];
            let ahead = chair.facing().before(&chair.area(), AT_TABLE);
            chair.support == Support::Floor && (ahead.overlaps(&top) || chair.area().overlaps(&top))
        };
        let seen = |item: &usize| {
            let item = &self.home.items[*item];
            let bounds = item.object.bounds.aabb(&(own * item.pose));
            Area { x0: bounds.min.x, y0: bounds.min.y, x1: bounds.max.x, y1: bounds.max.y }
        };
        let chairs = self.here.iter().filter(|(class, _)| class.ends_with("chair"));
        chairs.flat_map(|(_, items)| items).filter(at_table).map(seen).collect()
    }

    /// Puts a thing on the surface on which another one is.
    fn put_beside(&mut self, side: Side, seed: Seed, it: usize, class: &Arc<str>) -> Option<usize> {
        let item = &self.home.items[it];
        let (Support::On(carrier, surface) | Support::Inside(carrier, surface)) = item.support else { return None };
        let local = self.home.items[carrier].pose.inverse() * item.pose;
        let (size, centre) = (item.object.size(), local * Point3::from(item.object.bounds.offset));
        let before = self.home.items.len();
        self.filled(carrier, seed, |k| {
            let object = lying(k, class)?;
            (0..TRIES).find_map(|step| {
                let (to, turn) = offset(side, &size, &object, step, &mut k.rng);
                let yaw = yaw_of(&local);
                let (sin, cos) = (yaw.sine(), yaw.cosine());
                let at = (centre.x + cos * to.0 - sin * to.1, centre.y + sin * to.0 + cos * to.1);
                k.place(&object, surface, at, yaw + turn)
            })
        })
        .inspect(|_| (before..self.home.items.len()).for_each(|item| self.note(item)))
    }

    /// Works on the surfaces of an item with what is on them so far.
    fn filled<T>(&mut self, carrier: usize, seed: Seed, work: impl FnOnce(&mut SurfaceFiller<'_>) -> T) -> T {
        let room = self.home.items.len().max(self.taken.len());
        self.taken.resize(room, None);
        let surfaces = self.home.items[carrier].object.asset.surfaces.len();
        let taken = self.taken[carrier].take().unwrap_or_else(|| vec![Vec::new(); surfaces]);
        let filler = SurfaceFiller::resume(self.home, self.generators, carrier, seed, taken);
        let mut filler = filler.among(self.surroundings);
        let done = work(&mut filler);
        self.taken[carrier] = Some(filler.into_taken());
        done
    }
}

/// Puts an object on one of the surfaces that hold in a way, beginning with a random one.
fn put_inside_or_on(k: &mut SurfaceFiller<'_>, hold: Hold, class: &str, like: Option<Draft>) -> Option<usize> {
    let standing = like.is_none() && hold == Hold::Inside;
    let upright = if standing { k.make(class, None) } else { None };
    let put = upright.and_then(|object| put_somewhere(k, hold, &object));
    put.or_else(|| {
        let object = like.or_else(|| lying(k, class))?;
        put_somewhere(k, hold, &object)
    })
}

fn put_somewhere(k: &mut SurfaceFiller<'_>, hold: Hold, object: &Draft) -> Option<usize> {
    k.holding(hold).into_iter().find_map(|surface| k.put_object(object, surface))
}

/// An object as it lies: clothes on their back, others as they stand.
fn lying(k: &mut SurfaceFiller<'_>, class: &str) -> Option<Draft> {
    let object = k.make(class, None)?;
    let size = object.size();
    if !k.affords(class, Property::Wearable) || size.z < 3.0 * size.x {
        return Some(object);
    }
    Some(k.upright(object, Isometry3::rotation(-Vector3::y() * std::f32::consts::FRAC_PI_2)))
}

/// Hangs an object of a class from a hook or a rod, a cloth as long as there is space for.
fn hang(k: &mut SurfaceFiller<'_>, class: &str, surface: usize) -> Option<usize> {
    /// The shortest cloth, metres.
    const SHORT: f32 = 0.2;
    let drop = k.surface(surface).and_then(|s| s.clearance).unwrap_or(1.0) - 0.01;
    let wide = k.rng.between(0.2, 0.26);
    let size = match class {
        "toilet_paper" => {
            let roll = k.make(class, None)?;
            let lying = k.upright(roll, Isometry3::rotation(Vector3::x() * std::f32::consts::FRAC_PI_2));
            return k.hang(&lying, surface);
        }
        "bath_towel" | "towel" | "dish_towel" | "washcloth" => {
            let long = if class == "bath_towel" { 0.62 } else { 0.45 };
            let cloth = k.make(class, Some([0.05, wide, drop.min(long)])).filter(|_| drop > SHORT)?;
            return k.hang_turned(&cloth, surface, false);
        }
        "keys" | "leash" | "bag" | "purse" | "backpack" | "apron" | "oven_mitts" | "cap" | "belt" | "tie" => {
            let object = k.make(class, None)?;
            return k.hang(&object, surface);
        }
        _ => set::hung_size(class),
    };
    if size[2] > drop {
        return None;
    }
    let object = k.make(class, Some(size))?;
    k.hang(&object, surface)
}

/// The place of an object beside another of a size, in that one's frame, and its turn there.
fn offset(side: Side, size: &Vector3<f32>, object: &Draft, step: usize, rng: &mut Stream) -> ((f32, f32), f32) {
    /// The gap between things that lie side by side, metres.
    const GAP: f32 = 0.012;
    let own = object.size();
    // Spoons lie along the plate.
    let turn = if own.y > own.x { std::f32::consts::FRAC_PI_2 } else { 0.0 };
    let (long, short) = (own.x.max(own.y), own.x.min(own.y));
    let aside = size.y / 2.0 + short / 2.0 + GAP * (1.0 + step as f32);
    match side {
        Side::Left => ((0.0, aside), turn),
        Side::Right => ((0.0, -aside), turn),
        Side::Far => ((size.x / 2.0 + own.x / 2.0 + GAP * (1.0 + step as f32), rng.between(-0.1, 0.1)), 0.0),
        Side::Near => {
            let angle = rng.between(0.0, std::f32::consts::TAU);
            let away = size.xy().norm() / 2.0 + long / 2.0 * rng.between(0.8, 1.2) + GAP * step as f32;
            ((away * angle.cosine(), away * angle.sine()), rng.between(-0.4, 0.4))
        }
    }
}

/// The turn about Z of a pose.
fn yaw_of(pose: &Pose) -> f32 {
    let ahead = pose.rotation * Vector3::x();
    ahead.y.angle_to(ahead.x)
}
