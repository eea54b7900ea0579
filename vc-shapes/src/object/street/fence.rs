//! Fences and their gates.

use std::f32::consts::FRAC_PI_2;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, at_least, limb, spaced};

/// Fillings of the space between posts.
#[derive(Clone, Copy, PartialEq)]
enum Fill {
    Pickets,
    Boards,
    Ranch,
    Railings,
    Mesh,
    Slats,
    Bamboo,
}

const WOODS: &[MaterialId] = &[PINE, OAK, TEAK, GREY_OAK, WHITE, CREAM, WALNUT, FOREST, ANTHRACITE];
const METALS: &[MaterialId] = &[IRON, GREEN_METAL, BLACK_METAL, GALVANISED, ANTHRACITE, WHITE_METAL];

impl Fill {
    fn mat(self, b: &mut Build<'_>) -> MaterialId {
        match self {
            Self::Railings | Self::Mesh => b.one_of(METALS),
            Self::Bamboo => BAMBOO,
            _ => b.one_of(WOODS),
        }
    }
}

/// A rectangle across a fence: centre and half of its width, lower and upper height.
#[derive(Clone, Copy)]
struct Bay {
    y: f32,
    half: f32,
    low: f32,
    high: f32,
}

/// A length of fence: posts and pickets, boards, rails, railings, mesh or bamboo.
pub(super) fn fence(b: &mut Build<'_>) {
    at_least(b, [0.02, 0.5, 0.3]);
    let fills = [
        Fill::Pickets,
        Fill::Pickets,
        Fill::Boards,
        Fill::Ranch,
        Fill::Railings,
        Fill::Mesh,
        Fill::Slats,
        Fill::Bamboo,
    ];
    let fill = b.choose(&fills);
    let (mat, d, y, h) = (fill.mat(b), b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let bays = ((2.0 * y / b.vary(1.5, 2.4)) as usize).clamp(1, 5);
    let post = d.min(0.05);
    let step = 2.0 * (y - post) / bays as f32;
    let caps = b.rng.below(3);
    for cy in spaced(bays + 1, -y + post, y - post) {
        b.block("post", [-post, cy - post, 0.0], [post, cy + post, h - 0.03], mat);
        match caps {
            0 => b.taper("cap", [0.0, cy, h - 0.03], (d, post), (0.004, 0.004), 0.03, mat),
            1 => b.block("cap", [-d, cy - post, h - 0.03], [d, cy + post, h], mat),
            _ => b.ball("cap", [0.0, cy, h - post.min(0.03)], post.min(0.03), mat),
        }
    }
    let (top, low) = (h * b.vary(0.9, 0.99) - 0.02, h * b.vary(0.03, 0.1));
    let form = Form::any(b);
    for i in 0..bays {
        let centre = -y + post + step * (i as f32 + 0.5);
        let bay = Bay { y: centre, half: step / 2.0 - post * 0.8, low, high: top };
        filling(b, fill, bay, d * 0.8, &form, (mat, 24 / bays + 4));
    }
}

/// A gate between two posts; the leaf is hinged.
pub(super) fn gate(b: &mut Build<'_>) {
    at_least(b, [0.02, 0.4, 0.4]);
    let fill = b.choose(&[Fill::Pickets, Fill::Pickets, Fill::Boards, Fill::Railings, Fill::Mesh, Fill::Slats]);
    let (mat, d, y, h) = (fill.mat(b), b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let post = d.min(0.045);
    for side in [-1.0, 1.0] {
        let cy = side * (y - post);
        b.block("post", [-post, cy - post, 0.0], [post, cy + post, h - 0.02], mat);
        b.taper("cap", [0.0, cy, h - 0.02], (post, post), (0.005, 0.005), 0.02, mat);
    }
    let half = y - 2.0 * post - 0.012;
    let bay = Bay { y: 0.0, half: half - 0.02, low: h * b.vary(0.05, 0.1), high: h * b.vary(0.88, 0.97) };
    let form = Form::any(b);
    let leaf = d * 0.7;
    b.hinge([-leaf, half, 0.0], [0.0, 0.0, -1.0], FRAC_PI_2 * 0.95, |b| {
        filling(b, fill, bay, leaf, &form, (mat, 14));
        for side in [-1.0, 1.0] {
            let cy = side * (half - 0.018);
            b.block("stile", [-leaf * 0.6, cy - 0.018, bay.low], [leaf * 0.6, cy + 0.018, bay.high], mat);
        }
        let brace =
            limb([0.0, half - 0.05, bay.low + 0.05], [0.0, -half + 0.05, bay.high * 0.75], leaf * 0.3, leaf * 0.3);
        b.hull("brace", &brace, mat);
        let z = h * 0.6;
        b.block("latch", [leaf * 0.6, -half + 0.005, z], [leaf * 0.6 + 0.004, -half + 0.09, z + 0.03], IRON);
    });
    for z in [0.2, 0.75] {
        b.rod("hinge", [0.0, half + 0.001, h * z], [0.0, y - post, h * z], leaf * 0.3, IRON);
    }
    let z = h * 0.6 + 0.005;
    b.block("catch", [-post * 0.5, -half - 0.014, z], [post * 0.5, -half - 0.002, z + 0.02], IRON);
}

/// Dimensions shared by all bays of a fence.
struct Form {
    width: f32,
    gap: f32,
    tip: usize,
    arch: f32,
}

impl Form {
    fn any(b: &mut Build<'_>) -> Self {
        let arch = if b.rng.chance(0.35) { b.vary(-0.18, 0.18) } else { 0.0 };
        Self { width: b.vary(0.05, 0.1), gap: b.vary(0.6, 1.4), tip: b.rng.below(3), arch }
    }
}

/// Fills a bay with at most `most` pieces.
fn filling(b: &mut Build<'_>, fill: Fill, bay: Bay, d: f32, form: &Form, (mat, most): (MaterialId, usize)) {
    let (y0, y1, tall) = (bay.y - bay.half - 0.02, bay.y + bay.half + 0.02, bay.high - bay.low);
    let rail = |b: &mut Build<'_>, share: f32, half: f32| {
        let z = bay.low + tall * share;
        b.block("rail", [-d, y0, z - half], [-d * 0.1, y1, z + half], mat);
    };
    let fits = |pitch: f32| ((2.0 * bay.half / pitch) as usize).max(2).min(most);
    match fill {
        Fill::Pickets | Fill::Boards => {
            rail(b, 0.2, 0.035);
            rail(b, 0.75, 0.035);
            let gap = if fill == Fill::Boards { 0.03 } else { form.gap };
            let count = fits(form.width * (1.0 + gap));
            let half = bay.half / count as f32 / (1.0 + gap);
            for cy in spaced(count, bay.y - bay.half + half, bay.y + bay.half - half) {
                let bent = form.arch * tall * (1.0 - ((cy - bay.y) / bay.half).raised(2));
                let top = bay.high - form.arch.max(0.0) * tall + bent;
                let shoulder = top - half.min(0.05);
                let mut outline = vec![(-half, bay.low), (half, bay.low)];
                match form.tip {
                    0 => outline.extend([(half, shoulder), (0.0, top), (-half, shoulder)]),
                    1 => outline.extend([(half, shoulder), (half * 0.5, top), (-half * 0.5, top), (-half, shoulder)]),
                    _ => outline.extend([(half, top), (-half, top)]),
                }
                b.prism("picket", Axis::X, [-d * 0.1, cy, 0.0], &outline, d * 1.1, mat);
            }
        }
        Fill::Ranch => spaced(3, 0.2, 0.88).for_each(|t| rail(b, t, form.width * 0.7)),
        Fill::Slats => {
            let count = ((tall / form.width / 1.3) as usize).clamp(3, 12);
            let half = tall / count as f32 / (2.0 + 0.3 * form.gap);
            for z in spaced(count, bay.low + half, bay.high - half) {
                b.block("slat", [-d * 0.4, y0, z - half], [d * 0.4, y1, z + half], mat);
            }
        }
        Fill::Railings => {
            rail(b, 0.08, 0.015);
            rail(b, 0.85, 0.015);
            let r = (d * 0.4).min(0.009);
            let count = fits(0.11);
            for cy in spaced(count, bay.y - bay.half * 0.93, bay.y + bay.half * 0.93) {
                b.cylinder("bar", [-d * 0.5, cy, bay.low], r, tall - 0.06, mat);
                if form.tip < 2 {
                    b.cone("tip", [-d * 0.5, cy, bay.high - 0.062], r * 1.8, 0.06, mat);
                }
            }
        }
        Fill::Mesh => {
            let r = (d * 0.15).min(0.0035);
            let level = ((tall / 0.2) as usize).clamp(3, 8);
            for z in spaced(level, bay.low, bay.high - 0.01) {
                b.rod("wire", [0.0, y0, z], [0.0, y1, z], r, mat);
            }
            for cy in spaced(fits(0.07 + 0.1 * form.width), bay.y - bay.half * 0.96, bay.y + bay.half * 0.96) {
                b.cylinder("wire", [r * 1.6, cy, bay.low], r, tall, mat);
            }
        }
        Fill::Bamboo => {
            rail(b, 0.25, 0.02);
            rail(b, 0.8, 0.02);
            let count = fits(0.05);
            let r = (bay.half / count as f32).min(d * 0.95).min(0.03);
            for (i, cy) in spaced(count, bay.y - bay.half + r, bay.y + bay.half - r).enumerate() {
                let short = 0.03 * ((i * 7) % 5) as f32 / 5.0 * tall;
                b.cylinder("cane", [d * 0.05, cy, bay.low], r * 0.95, tall - short, mat);
            }
        }
    }
}
