//! Small things where people keep them: on surfaces, in cupboards, drawers and the
//! fridge, on hooks and shelves.
//!
//! First what a piece cannot do without (bedding on the bed, a tap at the sink, the
//! television on its stand), then what people keep there, drawn by the weights of the
//! class table. Every thing lies within a surface of its carrier, and no two on one
//! surface meet.

mod habits;
mod keeper;
mod set;

use vc_graph::Seed;
use vc_graph::asset::Hold;

use crate::apartment::Apartment;
use crate::furnish::Rest;
use habits::Habits;
use keeper::Keeper;

/// Fills an apartment; `amount` from 0 (only what belongs to the furniture) to 1.
pub(crate) fn fill(home: &mut Apartment, amount: f32, seed: Seed) {
    let carriers = home.items.len();
    let habits = Habits::known();
    for index in 0..carriers {
        if home.items[index].rest == Rest::Built || home.items[index].object.asset.surfaces.is_empty() {
            continue;
        }
        let own = seed.child("clutter").nth(index as u64);
        let mut keeper = Keeper::new(home, index, own);
        set::dress(&mut keeper, amount);
        for surface in 0..keeper.surfaces() {
            keep(&mut keeper, surface, habits, amount);
        }
    }
}

/// Puts what people keep there on a surface, as many as its area and the amount ask.
fn keep(keeper: &mut Keeper<'_>, surface: usize, habits: &Habits, amount: f32) {
    let (class, room) = (keeper.class(), keeper.room_class());
    let Some((hold, area, name)) = keeper.surface(surface).map(|s| (s.hold, 4.0 * s.half.0 * s.half.1, s.name.clone()))
    else {
        return;
    };
    let kept = habits.of(class, &name, hold, room);
    let density = match hold {
        Hold::Inside => 20.0,
        Hold::On if matches!(class, "sofa" | "armchair" | "chair" | "dining_chair" | "office_chair") => 0.4,
        Hold::On if class.contains("bed") => 0.3,
        Hold::On => 7.0,
        Hold::Hook => return,
    };
    if kept.is_empty() || amount <= 0.0 {
        return;
    }
    let sums: Vec<f32> = kept
        .iter()
        .scan(0.0, |sum, k| {
            *sum += k.1;
            Some(*sum)
        })
        .collect();
    let all = sums.last().copied().unwrap_or(0.0);
    let most = if hold == Hold::Inside { 7.0 } else { 8.0 };
    let mean = (area * density).min(most) * amount * 1.3;
    let mut left = (mean * keeper.rng.between(0.4, 1.5) + keeper.rng.unit()) as usize;
    while left > 0 {
        left -= 1;
        let drawn = keeper.rng.unit() * all;
        let Some(&(class, _)) = kept.get(sums.partition_point(|&sum| sum <= drawn)) else { continue };
        let Some(first) = keeper.put(class, surface) else { continue };
        // Some things are kept by the several.
        let more = set::together(class, &mut keeper.rng);
        for _ in 0..more.min(left + 2) {
            if keeper.put_beside(first, surface).is_none() {
                break;
            }
            left = left.saturating_sub(1);
        }
    }
}
