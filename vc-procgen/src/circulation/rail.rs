//! Railings along lines, level or rising.

use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Style};

use super::parts::{P, built};
use crate::item::Item;

/// The height of the handrail above the line.
const HEIGHT: f32 = 1.05;
/// The height of the lower rail.
const LOW: f32 = 0.09;
/// The greatest distance between posts, and between bars: no head fits through.
const POSTS: f32 = 1.3;
const BARS: f32 = 0.115;
/// How far posts reach below the line, into steps and slabs.
const FOOT: f32 = 0.1;
/// Half the thickness of a railing as things meet it.
const THICK: f32 = 0.025;

/// Materials of a railing.
#[derive(Clone, Copy)]
pub(crate) struct Looks {
    pub(crate) hand: MaterialId,
    pub(crate) bars: MaterialId,
}

/// A railing along a line on the floor or on the pitch of stairs. It is drawn with its posts and bars, and is a plate
/// for each stretch to whatever hits it.
pub(crate) fn rail(class: &'static str, line: &[P], looks: Looks, style: &Style) -> Item {
    let ends = [line.first(), line.last()].map(|end| end.copied().unwrap_or_default());
    let at = [f32::midpoint(ends[0][0], ends[1][0]), f32::midpoint(ends[0][1], ends[1][1]), ends[0][2].min(ends[1][2])];
    let local: Vec<P> = line.iter().map(|point| std::array::from_fn(|axis| point[axis] - at[axis])).collect();
    built(class, at, style, |b| local.windows(2).for_each(|ends| stretch(b, (ends[0], ends[1]), looks)))
}

fn stretch(b: &mut Build<'_>, (from, to): (P, P), looks: Looks) {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = (x * x + y * y).sqrt();
    let along = |share: f32, up: f32| -> P {
        let point: P = std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
        [point[0], point[1], point[2] + up]
    };
    b.visual_only(|b| {
        b.bar("handrail", along(0.0, HEIGHT), along(1.0, HEIGHT), THICK, looks.hand);
        b.rod("lower_rail", along(0.0, LOW), along(1.0, LOW), 0.012, looks.bars);
        for share in shares(length, POSTS).chain([1.0]) {
            upright(b, "post", (along(share, -FOOT), along(share, HEIGHT)), 0.018, looks.bars);
        }
        for share in shares(length, BARS).skip(1) {
            upright(b, "bar", (along(share, LOW), along(share, HEIGHT)), 0.006, looks.bars);
        }
    });
    let aside = [-y / length * THICK, x / length * THICK];
    let corner = |share: f32, up: f32, side: f32| {
        let [x, y, z] = along(share, up);
        [x + side * aside[0], y + side * aside[1], z]
    };
    let corners = [0.0, 1.0].map(|share| [0.0, HEIGHT].map(|up| [-1.0, 1.0].map(|side| corner(share, up, side))));
    b.collision_only(|b| b.hull("plate", corners.as_flattened().as_flattened(), looks.bars));
}

/// The shares of a length at which equal pieces begin, none longer than `most`.
fn shares(length: f32, most: f32) -> impl Iterator<Item = f32> {
    let count = (length / most).ceil().max(1.0) as usize;
    (0..count).map(move |i| i as f32 / count as f32)
}

fn upright(b: &mut Build<'_>, name: &str, (low, high): (P, P), half: f32, material: MaterialId) {
    b.block(name, [low[0] - half, low[1] - half, low[2]], [high[0] + half, high[1] + half, high[2]], material);
}
