//! Fitted kitchens: units of one design, made to measure, side by side under one worktop.

use vc_graph::{Asset, Bounds, Seed};

use super::fitting::{RUN, worktop};
use super::heat::built_in_cooker;
use super::sink::sink_unit;
use super::unit::{inner, plinth, shelved, unit_look};
use super::wash::dish_machine;
use crate::facts::ClassFacts;
use crate::object::Object;
use crate::object::joinery::{Fitted, Panel, Swing, cupboard_door, cupboard_doors, drawers, gapped, panel};
use crate::solid::{Build, P, case, fit, half_dims, tiers};
use crate::style::Style;

/// The height of the toe-kick, metres.
const KICK: f32 = 0.1;
/// A unit wider than this between its blanks has two doors, metres.
const LEAF: f32 = 0.6;
/// The same beside a corner, where a door must swing away from it.
const CORNER_LEAF: f32 = 0.75;
/// A blank wider than this is the part of a corner unit behind the next run, metres.
const CORNER: f32 = 0.2;

/// The purpose of a fitted unit.
///
/// ```
/// use vc_shapes::object::fitted::Purpose;
/// assert_eq!(Purpose::Cooker.class(), "stove");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Purpose {
    /// A base unit with doors.
    Doors,
    /// A base unit with drawers.
    Drawers,
    /// A sink set into the worktop.
    Sink,
    /// A dishwasher behind a front.
    Dishwasher,
    /// A hob on the worktop, with the oven below.
    Cooker,
    /// A cabinet on the wall.
    Wall,
}

impl Purpose {
    /// The class of its objects.
    pub fn class(self) -> &'static str {
        match self {
            Self::Doors | Self::Drawers => "kitchen_cabinet",
            Self::Sink => "kitchen_sink",
            Self::Dishwasher => "dishwasher",
            Self::Cooker => "stove",
            Self::Wall => "kitchen_wall_cabinet",
        }
    }
}

/// A unit of a fitted kitchen. It faces X; its right end is at low Y.
///
/// ```
/// use vc_graph::{Seed, nalgebra::Vector3};
/// use vc_shapes::Style;
/// use vc_shapes::object::fitted::{Purpose, Unit};
/// let style = Style::from_seed(Seed(1));
/// // A corner unit: the next run stands before its right end.
/// let corner = Unit { blank: [0.65, 0.0], ..Unit::new(Purpose::Doors) };
/// let object = corner.object(Vector3::new(0.6, 1.1, 0.9), &style, (Seed(2), Seed(3)));
/// assert_eq!(object.class, "kitchen_cabinet");
/// assert!((object.size().z - 0.9).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// The purpose.
    pub purpose: Purpose,
    /// The widths at the right and the left end where a cabinet has a fixed front, metres: a strip that lets drawers pass
    /// the handles of the next run, or all that is behind that run.
    pub blank: [f32; 2],
    /// Whether a cabinet has a panel down to the floor at its right and left end, which are seen.
    pub ends: [bool; 2],
}

impl Unit {
    /// A unit between others.
    pub fn new(purpose: Purpose) -> Self {
        Self { purpose, blank: [0.0; 2], ends: [false; 2] }
    }

    /// Makes the unit: `size` is depth, width and height of the worktop, metres; hobs rise above that by up to 4 cm. The
    /// first seed is that of the kitchen, whose units share fronts and handles; the second is the unit's own.
    pub fn object(self, size: vc_graph::nalgebra::Vector3<f32>, style: &Style, seeds: (Seed, Seed)) -> Object {
        let class = self.purpose.class();
        let facts = ClassFacts::builtin(class);
        let (kitchen, own) = (seeds.0.child("kitchen").stream(), seeds.1.child("object").stream());
        let mut b = Build::with_facts(class, facts, size, style, kitchen);
        let u = fit(&b, [0.3, 0.25, 0.3]);
        let look = unit_look(&mut b, u);
        b.rng = own;
        self.build(&mut b, u, &look);
        let (asset, bounds): (Asset, Bounds) = b.finish();
        Object { class, role: facts.role, asset, bounds }
    }

    fn build(self, b: &mut Build<'_>, u: f32, look: &Fitted) {
        match self.purpose {
            Purpose::Doors | Purpose::Drawers => self.base(b, u, look),
            Purpose::Sink => sink_unit(b, u, look),
            Purpose::Dishwasher => dish_machine(b, u, true, &Fitted { t: 0.03 * u, ..*look }),
            Purpose::Cooker => built_in_cooker(b, u, look),
            Purpose::Wall => self.wall(b, u, look),
        }
    }

    fn base(self, b: &mut Build<'_>, u: f32, look: &Fitted) {
        let (x, y, _) = half_dims(b);
        let under = worktop(b, u);
        let (t, face) = (look.t, x - RUN * u);
        let (mut right, mut left) = (-y, y);
        if self.ends[0] {
            b.block("end_panel", [-x, right, 0.0], [face, right + t, under], look.mat);
            right += t;
        }
        if self.ends[1] {
            b.block("end_panel", [-x, left - t, 0.0], [face, left, under], look.mat);
            left -= t;
        }
        let (low, high) = ([-x, right, KICK * u], [face - t, left, under]);
        plinth(b, low, high, u);
        case(b, low, high, t, look.mat);
        let front = self.opening(b, look, low, high);
        if self.purpose == Purpose::Drawers {
            let count = b.rng.count(3, 4);
            let deep = b.vary(1.0, 1.6);
            let space = ([low[0] + t, front.0[1], low[2] + t * 0.5], front.1);
            drawers(b, look, "drawer", space, (count, deep));
            return;
        }
        let mat = look.mat;
        let shelf = move |b: &mut Build<'_>, l: P, h: P| b.block("shelf", l, [h[0] - 0.02 * u, h[1], h[2]], mat);
        tiers(b, "shelf", inner(low, high, t), 2, t, shelf);
        self.doors(b, look, front, LEAF, false);
    }

    fn wall(self, b: &mut Build<'_>, u: f32, look: &Fitted) {
        let (x, y, h) = half_dims(b);
        let mut look = *look;
        if b.rng.chance(0.15) {
            look.panel = Panel::Glazed;
        }
        let (low, high) = ([-x, -y, 0.0], [x - RUN * u - look.t, y, h]);
        shelved(b, &look, (low, high));
        let front = self.opening(b, &look, low, high);
        self.doors(b, &look, front, 0.5, true);
    }

    /// Closes the blank ends of the front of a case; returns the rest of the front.
    fn opening(self, b: &mut Build<'_>, look: &Fitted, low: P, high: P) -> (P, P) {
        let (right, left) = (low[1] + self.blank[0], high[1] - self.blank[1]);
        let (x0, x1) = (high[0], high[0] + look.t);
        let how = if look.panel == Panel::Glazed { Panel::Framed } else { look.panel };
        for (y0, y1) in [(low[1], right), (left, high[1])].into_iter().filter(|(y0, y1)| y1 > y0) {
            let (from, to) = gapped([x0, y0, low[2]], [x1, y1, high[2]], look.t * 0.04);
            let how = if y1 - y0 > CORNER { how } else { Panel::Slab };
            panel(b, how, "blank", (from, to), look.mat);
        }
        ([x0, right, low[2]], [x1, left, high[2]])
    }

    /// Doors in a front; beside a corner a single one that swings away from it.
    fn doors(self, b: &mut Build<'_>, look: &Fitted, front: (P, P), widest: f32, high_up: bool) {
        let corner = self.blank.map(|blank| blank > CORNER);
        let wide = front.1[1] - front.0[1];
        match corner {
            [true, false] if wide < CORNER_LEAF => cupboard_door(b, look, "door", front, Swing::Left, high_up),
            [false, true] if wide < CORNER_LEAF => cupboard_door(b, look, "door", front, Swing::Right, high_up),
            _ => cupboard_doors(b, look, front, widest, high_up),
        }
    }
}
