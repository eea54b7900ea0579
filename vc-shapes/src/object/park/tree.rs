//! Trees: a trunk, branches and a crown of leaf blobs, tiers or fronds.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Build, P, Sketch, blob, limb, mix, polar};

/// Outlines of crowns.
#[derive(Clone, Copy)]
enum Crown {
    Round,
    Egg,
    Column,
    Spreading,
    Cone,
}

impl Crown {
    /// The radius at a height from 0 (bottom) to 1 (top), as a fraction of the largest radius.
    fn radius(self, t: f32) -> f32 {
        match self {
            Self::Round => (1.0 - (2.0 * t - 1.0).raised(2)).max(0.0).sqrt(),
            Self::Egg => (1.0 - (1.6 * t - 0.6).raised(2)).max(0.0).sqrt(),
            Self::Column => 0.75 - 0.35 * t,
            Self::Spreading => 0.55 + 0.45 * t,
            Self::Cone => 1.0 - 0.85 * t,
        }
    }
}

/// Growth parameters of a species of broad-leaved tree.
struct Habit {
    /// Range of the fraction of the height below the crown.
    clear: (f32, f32),
    /// Range of the trunk's radius per metre of height.
    girth: (f32, f32),
    /// Range of the number of leaf blobs.
    blobs: (usize, usize),
    /// Largest dent of a leaf blob, as a fraction of its radius.
    ragged: f32,
    crowns: &'static [Crown],
    bark: MaterialId,
    leaves: &'static [MaterialId],
}

/// A street or garden tree of any broad-leaved species.
pub(super) fn tree(b: &mut Build<'_>) {
    let habit = Habit {
        clear: (0.18, 0.42),
        girth: (0.014, 0.024),
        blobs: (7, 20),
        ragged: 0.28,
        crowns: &[Crown::Round, Crown::Egg, Crown::Column, Crown::Spreading, Crown::Cone, Crown::Egg],
        bark: BARK,
        leaves: &[LEAF, LEAF, DARK_LEAF, LIGHT_LEAF, GRASS, AUTUMN_LEAF],
    };
    broadleaf(b, &habit).1.fill(b);
}

/// An oak: a stout trunk under a wide crown of many lobes.
pub(super) fn oak(b: &mut Build<'_>) {
    let habit = Habit {
        clear: (0.14, 0.28),
        girth: (0.024, 0.036),
        blobs: (14, 26),
        ragged: 0.35,
        crowns: &[Crown::Round, Crown::Spreading, Crown::Egg],
        bark: BARK,
        leaves: &[DARK_LEAF, LEAF, DARK_LEAF, AUTUMN_LEAF],
    };
    broadleaf(b, &habit).1.fill(b);
}

/// A birch: a slim white trunk with dark marks and an airy crown.
pub(super) fn birch(b: &mut Build<'_>) {
    let habit = Habit {
        clear: (0.2, 0.4),
        girth: (0.009, 0.014),
        blobs: (9, 18),
        ragged: 0.4,
        crowns: &[Crown::Egg, Crown::Cone, Crown::Column],
        bark: PALE_BARK,
        leaves: &[LIGHT_LEAF, LIGHT_LEAF, GRASS, LEAF],
    };
    let (trunk, mut sketch) = broadleaf(b, &habit);
    for _ in 0..b.rng.count(5, 10) {
        // The mark lies on one of the trunk's six sides.
        let (t, side) = (b.vary(0.15, 0.85), 0.3 + TAU * (b.rng.below(6) as f32 + 0.5) / 6.0);
        let radius = trunk.girth * (1.0 - 0.35 * t);
        let (dx, dy) = polar(side, radius * 0.25);
        let low = mix([0.0; 3], trunk.top, t);
        let low = [low[0] + dx, low[1] + dy, low[2]];
        let high = [low[0], low[1], low[2] + b.vary(0.012, 0.05)];
        sketch.add("mark", limb(low, high, radius * 0.9, radius * 0.88), IRON);
    }
    sketch.fill(b);
}

/// A fruit tree: a short trunk, a round crown, and fruit or blossom on it.
pub(super) fn fruit(b: &mut Build<'_>) {
    let habit = Habit {
        clear: (0.2, 0.36),
        girth: (0.018, 0.028),
        blobs: (7, 14),
        ragged: 0.25,
        crowns: &[Crown::Round, Crown::Egg, Crown::Spreading],
        bark: BARK,
        leaves: &[LEAF, GRASS, LIGHT_LEAF],
    };
    let (trunk, mut sketch) = broadleaf(b, &habit);
    let fruits = [RED_SKIN, YELLOW_SKIN, ORANGE_SKIN, PURPLE_SKIN, GREEN_SKIN, PETAL_PINK, PETAL_WHITE];
    let (mat, radius) = (b.choose(&fruits), b.vary(0.055, 0.085) * (b.size.z / 4.0).clamp(0.6, 1.3));
    let last = sketch.count();
    for _ in 0..b.rng.count(14, 30) {
        let at = outermost(b, &sketch, (trunk.crown, last - 1), trunk.top);
        let points = blob(b, at, [radius; 3], 12, 0.05);
        sketch.add("fruit", points, mat);
    }
    sketch.fill(b);
}

/// Samples a few points on the leaves and returns the one farthest from the centre, where fruit is
/// visible.
fn outermost(b: &mut Build<'_>, sketch: &Sketch, solids: (usize, usize), middle: P) -> P {
    let distance = |p: &P| (0..3).map(|i| (p[i] - middle[i]).raised(2)).sum::<f32>();
    let mut any = || sketch.point(b.rng.count(solids.0, solids.1), b.rng.below(64));
    let (first, rest) = (any(), [any(), any(), any()]);
    rest.into_iter().fold(first, |best, p| if distance(&p) > distance(&best) { p } else { best })
}

/// The trunk below the crown.
struct Trunk {
    girth: f32,
    top: P,
    /// The index of the first solid that is a leaf blob.
    crown: usize,
}

fn broadleaf(b: &mut Build<'_>, habit: &Habit) -> (Trunk, Sketch) {
    let height = b.size.z;
    let clear = height * b.vary(habit.clear.0, habit.clear.1);
    let girth = height * b.vary(habit.girth.0, habit.girth.1);
    let crown = b.one_of(habit.crowns);
    let (reach, tall) = (b.size.x.min(b.size.y) / 2.0, height - clear);
    let lean = polar(b.vary(0.0, TAU), height * b.vary(0.0, 0.04));
    let top = [lean.0, lean.1, clear + tall * 0.55];
    let mut sketch = Sketch::default();
    sketch.add("trunk", limb([0.0; 3], mix([0.0; 3], top, 0.12), girth * b.vary(1.3, 1.9), girth), habit.bark);
    sketch.add("trunk", limb(mix([0.0; 3], top, 0.08), top, girth, girth * 0.55), habit.bark);
    let count = b.rng.count(habit.blobs.0, habit.blobs.1);
    let share = (1.75 / (count as f32).sqrt()).clamp(0.34, 0.7);
    let start = b.vary(0.0, TAU);
    let mut blobs = Vec::new();
    for i in 0..count {
        let t = ((i as f32 + b.vary(0.1, 0.9)) / count as f32).clamp(0.0, 1.0);
        let size = share * b.vary(0.75, 1.15);
        let out = crown.radius(t) * (1.0 - size * 0.8) * reach * b.vary(0.75, 1.0);
        let (x, y) = polar(start + 2.399_963 * i as f32, out);
        let upright = size * 0.42;
        let centre = [x + lean.0, y + lean.1, clear + tall * (upright + (1.0 - 2.0 * upright) * t)];
        let wide = size * reach * crown.radius(t).max(0.45);
        blobs.push((centre, [wide, wide, upright * tall]));
    }
    for (centre, _) in &blobs {
        let from = mix([0.0; 3], top, (clear / top[2] * b.vary(0.7, 1.0)).clamp(0.2, 0.9));
        sketch.add("branch", limb(from, *centre, girth * 0.45, girth * 0.12), habit.bark);
    }
    let first = sketch.count();
    let leaves = b.one_of(habit.leaves);
    for (centre, radii) in blobs {
        let points = b.rng.count(24, 40);
        let points = blob(b, centre, radii, points, habit.ragged);
        sketch.add("leaves", points, leaves);
    }
    (Trunk { girth, top, crown: first }, sketch)
}

/// A conifer: a spruce of tiers, a pine with plates of needles, or a slim cypress.
pub(super) fn pine(b: &mut Build<'_>) {
    let leaves = b.choose(&[DARK_LEAF, DARK_LEAF, DARK_LEAF, LEAF]);
    match b.rng.below(5) {
        0 => plates(b, leaves),
        1 => spindle(b, leaves),
        _ => tiers(b, leaves),
    }
}

/// Tiers of drooping branches, each smaller than the one below.
fn tiers(b: &mut Build<'_>, leaves: MaterialId) {
    let (height, reach) = (b.size.z, b.size.x.min(b.size.y) / 2.0);
    let (count, clear) = (b.rng.count(4, 9), height * b.vary(0.05, 0.16));
    let mut sketch = Sketch::default();
    let girth = height * b.vary(0.014, 0.022);
    sketch.add("trunk", limb([0.0; 3], [0.0, 0.0, height * 0.8], girth, girth * 0.3), BARK);
    let step = (height - clear) / (count as f32 + 0.6);
    let (droop, slim) = (b.vary(0.1, 0.5), b.vary(0.75, 1.1));
    for i in 0..count {
        let low = clear + step * i as f32;
        let radius = reach * (1.0 - i as f32 / count as f32).power(slim).max(0.12);
        let corners = b.rng.count(9, 13);
        let mut points = vec![[0.0, 0.0, low + step * b.vary(1.5, 1.7)]];
        let start = b.vary(0.0, TAU);
        for k in 0..corners {
            let angle = start + TAU * (k as f32 + b.vary(-0.25, 0.25)) / corners as f32;
            let (x, y) = polar(angle, radius * b.vary(0.78, 1.0));
            points.push([x, y, low + step * b.vary(0.0, droop)]);
            points.push([x * 0.5, y * 0.5, low + step * 0.8]);
        }
        sketch.add("needles", points, leaves);
    }
    sketch.fill(b);
}

/// A tall bare trunk whose branches end in flat clouds of needles.
fn plates(b: &mut Build<'_>, leaves: MaterialId) {
    let (height, reach) = (b.size.z, b.size.x.min(b.size.y) / 2.0);
    let girth = height * b.vary(0.016, 0.026);
    let bend = polar(b.vary(0.0, TAU), reach * b.vary(0.05, 0.35));
    let waist = [bend.0, bend.1, height * b.vary(0.35, 0.5)];
    let top = [bend.0 * 0.4, bend.1 * 0.4, height * 0.85];
    let mut sketch = Sketch::default();
    sketch.add("trunk", limb([0.0; 3], waist, girth * 1.3, girth * 0.9), RUST);
    sketch.add("trunk", limb(waist, top, girth * 0.9, girth * 0.4), RUST);
    let (count, start) = (b.rng.count(5, 9), b.vary(0.0, TAU));
    for i in 0..count {
        let t = i as f32 / (count - 1) as f32;
        let (x, y) = polar(start + 2.4 * i as f32, reach * 0.6 * (1.0 - 0.9 * t));
        let z = height * (0.52 + 0.4 * t);
        let wide = reach * b.vary(0.35, 0.5) * (1.1 - 0.3 * t);
        let from = mix(waist, top, (t * 0.9).min(0.9));
        sketch.add("branch", limb(from, [x, y, z], girth * 0.4, girth * 0.15), RUST);
        let tall = height * b.vary(0.05, 0.08);
        let points = blob(b, [x, y, z], [wide, wide, tall], 32, 0.3);
        sketch.add("needles", points, leaves);
    }
    sketch.fill(b);
}

/// A slim flame-shaped crown of dense needles almost from the ground.
fn spindle(b: &mut Build<'_>, leaves: MaterialId) {
    let (height, reach) = (b.size.z, b.size.x.min(b.size.y) / 2.0);
    let mut sketch = Sketch::default();
    sketch.add("trunk", limb([0.0; 3], [0.0, 0.0, height * 0.4], height * 0.02, height * 0.015), BARK);
    let count = b.rng.count(3, 6);
    let widest = b.vary(0.25, 0.4);
    for i in 0..count {
        let t = (i as f32 + 0.5) / count as f32;
        let wide = reach * (1.0 - ((t - widest) / (1.05 - widest)).raised(2)).max(0.1).sqrt();
        let tall = height * 0.85 / count as f32;
        let (x, y) = polar(b.vary(0.0, TAU), reach * 0.06);
        let points = blob(b, [x, y, height * (0.06 + 0.9 * t)], [wide, wide, tall], 40, 0.14);
        sketch.add("needles", points, leaves);
    }
    sketch.fill(b);
}

/// A palm: a ringed trunk, often bent, and arching fronds.
pub(super) fn palm(b: &mut Build<'_>) {
    let (height, reach) = (b.size.z, b.size.x.min(b.size.y) / 2.0);
    let crown = (height - reach * b.vary(0.25, 0.45)).max(height * 0.35);
    let girth = (0.05 + 0.014 * height) * b.vary(0.8, 1.2);
    let bend = polar(b.vary(0.0, TAU), reach * b.vary(0.0, 0.35));
    let mut sketch = Sketch::default();
    let rings = b.rng.count(5, 10);
    let at = |t: f32| [bend.0 * t * t, bend.1 * t * t, crown * t];
    for i in 0..rings {
        let (low, high) = (i as f32 / rings as f32, (i + 1) as f32 / rings as f32);
        let radius = girth * (1.0 - 0.35 * low);
        sketch.add("trunk", limb(at(low), at(high), radius * 0.86, radius * 1.05), BARK);
    }
    let leaves = b.choose(&[LEAF, DARK_LEAF, GRASS]);
    let (count, start, droop) = (b.rng.count(10, 17), b.vary(0.0, TAU), b.vary(0.2, 0.8));
    for i in 0..count {
        let lift = b.vary(0.15, 0.75);
        frond(
            b,
            &mut sketch,
            at(1.0),
            start + TAU * i as f32 / count as f32,
            (reach, lift, droop + lift * 0.4),
            leaves,
        );
    }
    if b.rng.chance(0.5) {
        for i in 0..b.rng.count(2, 5) {
            let (x, y) = polar(start + 1.9 * i as f32, girth);
            let centre = [at(1.0)[0] + x, at(1.0)[1] + y, crown - girth * 0.6];
            let points = blob(b, centre, [girth * 0.7; 3], 20, 0.05);
            sketch.add("coconut", points, BROWN_SKIN);
        }
    }
    sketch.fill(b);
}

/// A frond in three ridged strips; `form` is its reach, rise and droop.
fn frond(b: &mut Build<'_>, sketch: &mut Sketch, root: P, angle: f32, form: (f32, f32, f32), mat: MaterialId) {
    let (reach, lift, droop) = form;
    let (reach, wide) = (reach * b.vary(0.8, 1.0), reach * b.vary(0.15, 0.24));
    let (cos, sin) = polar(angle + b.vary(-0.15, 0.15), 1.0);
    let section = |t: f32| {
        let out = reach * t;
        let z = root[2] + reach * (lift * t * 1.6 - (lift + droop) * t * t);
        let half = wide * (1.0 - (2.0 * t - 0.8).raised(2)).max(0.03);
        let edge =
            |s: f32| [root[0] + cos * out - sin * half * s, root[1] + sin * out + cos * half * s, z - half * 0.45];
        [edge(1.0), edge(-1.0), [root[0] + cos * out, root[1] + sin * out, z]]
    };
    for pair in [0.02_f32, 0.35, 0.68, 1.0].windows(2) {
        let mut points: Vec<P> = pair.iter().flat_map(|&t| section(t)).collect();
        // A flat section would not be a solid.
        points.extend(pair.iter().map(|&t| {
            let [.., ridge] = section(t);
            [ridge[0], ridge[1], ridge[2] - wide * 0.12]
        }));
        sketch.add("frond", points, mat);
    }
}
