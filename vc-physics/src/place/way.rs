//! Ways to put things down.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::Hold;

use super::SupportSurface;

/// Heights above the bottom of a container at which things are let down on what is in it,
/// metres.
const HEAPED: [f32; 8] = [0.04, 0.08, 0.12, 0.16, 0.2, 0.25, 0.3, 0.4];
/// Heights above a surface at which things are laid across what rises beside it, the lowest first, metres.
pub(super) const ACROSS: [f32; 8] = [0.04, 0.08, 0.12, 0.16, 0.2, 0.24, 0.28, 0.32];
/// How much of its half width may be over the edges of what is put down with its middle over them.
const POISED: f32 = 0.9;
/// How things are put into containers, the better ways first: as they stand, or on their side.
pub(super) const INTO: [Way; 2] = [WITHIN, Way { tips: &Tip::ALL, ..WITHIN }];
/// How they are put in there otherwise: on what is in there, leaning, over the edge of a turntable.
pub(super) const HEAP: [Way; 4] = [
    Way { heights: &HEAPED, ..WITHIN },
    Way { tips: &Tip::ALL, heights: &HEAPED, ..WITHIN },
    Way { tips: &Tip::ALL, slender: 0.0, ..WITHIN },
    TURNTABLE,
];
pub(super) const TURNTABLE: Way = Way { over: 0.4, ..WITHIN };
/// How things are put on others: within the edges, a little over them, as a pan on a burner, or as far as
/// their middle stays over them: a cushion on a chair. At last across what rises beside the surface, as the
/// arms of a chair.
pub(super) const ONTO: [Way; 4] = [
    WITHIN,
    Way { over: 0.4, ..WITHIN },
    Way { over: POISED, ..WITHIN },
    Way { over: POISED, heights: &ACROSS, across: true, ..WITHIN },
];
/// As they stand, within the edges.
pub(super) const WITHIN: Way =
    Way { tips: &[Tip::Upright], heights: &[0.0], over: 0.0, slender: SLENDER, across: false };

/// A surface that reaches no farther from its middle is no larger than a seat, metres.
const SEAT: f32 = 0.35;
/// A thing with two sides shorter than this may lean, metres.
const THIN: f32 = 0.1;
/// Least width of what is laid on its side, as a part of its height then.
const SLENDER: f32 = 0.25;

/// A way to put things down.
pub(super) struct Way {
    pub(super) tips: &'static [Tip],
    /// Heights above the surface, metres.
    pub(super) heights: &'static [f32],
    /// How much of its half width may be over the edges.
    pub(super) over: f32,
    /// Least width of what is laid on its side, as a part of its height then.
    pub(super) slender: f32,
    /// Whether it is carried by what rises beside the surface.
    pub(super) across: bool,
}

impl Way {
    /// Whether a thing of an extent may be put so: over the edge of a board in a container goes only what is wider than
    /// the board, far over an edge otherwise also what lies on something no larger than a seat, and leaning only
    /// what is as slender as a tube of toothpaste.
    pub(super) fn is_for(&self, (low, high): (Point3<f32>, Point3<f32>), shelf: &SupportSurface) -> bool {
        let sides = high - low;
        let (wide, long) = (sides.x.min(sides.y) / 2.0, sides.x.max(sides.y) / 2.0);
        let (width, length) = (shelf.half.0.min(shelf.half.1), shelf.half.0.max(shelf.half.1));
        let is_wider = wide > width || long > length;
        let overhangs = match shelf.hold {
            Hold::Inside => self.over == 0.0 || is_wider,
            _ => self.over < POISED || is_wider || length < SEAT,
        };
        let leans = self.slender < SLENDER;
        overhangs && (!leans || [sides.x, sides.y, sides.z].into_iter().filter(|side| *side < THIN).count() > 1)
    }
}

/// How a thing is put down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Tip {
    /// As it stands.
    Upright,
    /// On the side of its X.
    OnX,
    /// On the side of its Y.
    OnY,
}

impl Tip {
    pub(super) const ALL: [Self; 3] = [Self::Upright, Self::OnX, Self::OnY];

    /// Whether what has some sides stays so: a plate does not stand on its rim.
    pub(super) fn stands(self, sides: Vector3<f32>, slender: f32) -> bool {
        let (height, along, across) = match self {
            Self::Upright => (sides.z, sides.x, sides.y),
            Self::OnX => (sides.x, sides.y, sides.z),
            Self::OnY => (sides.y, sides.x, sides.z),
        };
        along.min(across) >= slender * height
    }

    /// The turns by which it comes to lie so, a quarter apart.
    pub(super) fn turns(self) -> [UnitQuaternion<f32>; 2] {
        let quarter = |axis| UnitQuaternion::from_axis_angle(&axis, std::f32::consts::FRAC_PI_2);
        let tip = match self {
            Self::Upright => UnitQuaternion::identity(),
            Self::OnX => quarter(Vector3::y_axis()),
            Self::OnY => quarter(Vector3::x_axis()),
        };
        [tip, quarter(Vector3::z_axis()) * tip]
    }
}
