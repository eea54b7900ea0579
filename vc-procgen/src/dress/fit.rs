//! Making an object that fills a box: generated in that size, several side by side if one would be too
//! wide, stretched if it comes out smaller.

use nalgebra::{Point3, Vector3};
use vc_graph::{Asset, ClassTable, Seed};
use vc_shapes::material::*;
use vc_shapes::{Generator, Object, Style};

use super::Made;
use super::compose::{block, joined, moved};
use super::house::House;
use super::load::{self, Load};
use super::turn::Place;

/// The numbers of instances tried to find one that fills its box without stretching, and one that also
/// supports the objects that the scene has on it.
const TRIES: u64 = 4;
const LADEN: u64 = 12;
/// A scale factor too small to be noticed.
const UNSEEN: f32 = 1.04;
/// The greatest scale factor: a hanger is thin though its box is as deep as a coat.
const MOST: f32 = 3.5;
/// The least thickness of an object, metres.
const THIN: f32 = 0.004;

/// The classes of which several stand side by side in a wide box, and the greatest width of one, metres.
const ROWS: [(&str, f32); 5] = [
    ("kitchen_cabinet", 0.85),
    ("kitchen_wall_cabinet", 0.85),
    ("medicine_cabinet", 0.95),
    ("bathroom_vanity", 1.2),
    ("wall_hook_rack", 1.0),
];

/// The material of objects without a generator: the first class of which theirs is a kind decides.
const MATERIALS: [(&str, MaterialId); 9] = [
    ("firewood", OAK),
    ("stepping_stone", GRANITE),
    ("cardboard_box", CARDBOARD),
    ("paper_goods", WHITE_PAPER),
    ("towel", TOWEL_WHITE),
    ("textile", GREY_FABRIC),
    ("plant", LEAF),
    ("water", WATER),
    ("food", CRUST),
];

/// Makes the object for a box, with its origin at the box's centre.
pub(super) fn made(house: &House, place: &Place, loads: &[Load], style: &Style, seed: Seed) -> Made {
    let size = place.bounds.size().map(|v| v.max(THIN));
    let Some(generator) = house.generators.get(&place.class) else {
        return Made { asset: plain(house.graph.classes(), &place.class, size), scale: Vector3::repeat(1.0) };
    };
    let row = ROWS.iter().find(|(class, most)| *class == &*place.class && size.y > *most * 1.3);
    match row {
        Some((_, most)) => stretched(side_by_side(generator, size, (*most, &place.taken), style, seed), size),
        None => fitted(generator, size, loads, style, seed),
    }
}

fn fitted(generator: &Generator, size: Vector3<f32>, loads: &[Load], style: &Style, seed: Seed) -> Made {
    let stretch = |o: &Object| size.component_div(&o.size().map(|v| v.max(1e-4)));
    let worst = |o: &Object| stretch(o).iter().map(|s| s.max(1.0 / s)).fold(1.0, f32::max);
    let laden = |o: &Object| load::off(&o.asset, &o.bounds.offset, &stretch(o), loads);
    let tried = |n| {
        let object = generator.sized(size, style, seed.nth(n));
        (worst(&object) + laden(&object), object)
    };
    let (mut off, mut object) = tried(0);
    for n in 1..if loads.is_empty() { TRIES } else { LADEN } {
        if off < UNSEEN {
            break;
        }
        let next = tried(n);
        if next.0 < off {
            (off, object) = next;
        }
    }
    let scale = stretch(&object).map(|s| s.min(MOST));
    load::lay_on_boards(&mut object.asset, &object.bounds.offset, &scale, loads);
    Made { scale, asset: centred(object) }
}

/// An asset slightly smaller than its box, with the scale by which it fills it.
fn stretched(asset: Asset, size: Vector3<f32>) -> Made {
    let (low, high) = asset.extent().unwrap_or_default();
    let scale = size.component_div(&(high - low).map(|v| v.max(1e-4)));
    Made { asset: moved(asset, -nalgebra::center(&low, &high).coords), scale }
}

fn centred(object: Object) -> Asset {
    moved(object.asset, -object.bounds.offset)
}

/// A row of units as wide as the box. Stretches occupied by other objects have no unit and are bridged by
/// a worktop.
fn side_by_side(
    generator: &Generator,
    size: Vector3<f32>,
    (most, taken): (f32, &[(f32, f32)]),
    style: &Style,
    seed: Seed,
) -> Asset {
    const LEAST: f32 = 0.2;
    /// The greatest number of units between two appliances: no row of a home is longer.
    const UNITS: f32 = 64.0;
    let mut units = Vec::new();
    let (mut from, end) = (-size.y / 2.0, size.y / 2.0);
    let gaps = taken.iter().copied().chain([(end, end)]);
    for (low, high) in gaps {
        let (low, wide) = (low.min(end), low.min(end) - from);
        if wide > LEAST {
            let count = (wide / most).ceil().clamp(1.0, UNITS);
            for i in 0..count as usize {
                let unit = Vector3::new(size.x, wide / count, size.z);
                let made = fitted(generator, unit, &[], style, seed);
                // The size of a unit is close enough for it to be placed without scaling.
                let middle = from + wide / count * (i as f32 + 0.5);
                units.push(moved(made.asset, Vector3::new(0.0, middle, 0.0)));
            }
        }
        // Appliances may stand above each other, or reach beyond the row.
        if high - low > LEAST && high.min(end) > low.max(from) {
            units.push(bridge(size, (low.max(from), high.min(end)), style));
        }
        from = from.max(high);
    }
    joined(generator.class, units)
}

/// The worktop over an object that stands in a row.
fn bridge(size: Vector3<f32>, (low, high): (f32, f32), style: &Style) -> Asset {
    let half = size / 2.0;
    let (from, to) = (Point3::new(-half.x, low, half.z - 0.03), Point3::new(half.x, high, half.z));
    Asset { name: "worktop".into(), parts: vec![block("worktop", from, to, style.worktop)], ..Asset::default() }
}

/// A plain box of the material of its class.
fn plain(classes: &ClassTable, class: &str, size: Vector3<f32>) -> Asset {
    let mat = MATERIALS.iter().find(|(kind, _)| classes.is_a(class, kind)).map_or(BEIGE_FABRIC, |(_, mat)| *mat);
    let half = Point3::from(size / 2.0);
    Asset { name: class.into(), parts: vec![block("box", -half, half, mat)], ..Asset::default() }
}
