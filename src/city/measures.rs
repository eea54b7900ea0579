//! The speeds, times and sizes of ways between regions, in one place, each with its unit and its reason.

use vc_graph::clock::Span;

/// On level ground, metres a second: as in walks within a region, so that nobody changes pace at a door.
pub(super) const LEVEL: f32 = 1.2;
/// Over stairs, along their slope, metres a second: people climb at half their pace.
pub(super) const STAIRS: f32 = 0.6;
/// Turning on the spot, radians a second: as in walks, a right angle in a quarter of a second.
pub(super) const TURNING: f32 = 6.3;

/// How far before or behind a threshold one stands, metres: the leaf of a door, 0.1 m thick, and a body have room between.
pub(super) const INWARD: f32 = 0.7;
/// How far into a cabin one goes, metres: to its back, so that others find room after one.
pub(super) const DEEP: f32 = 1.5;
/// How far beside the opening of a lift one waits, metres: half a body and a hand's breadth, so that who comes out has the
/// opening.
pub(super) const BESIDE: f32 = 0.4;
/// Where a way through a portal is kept free by whoever waits or makes way, metres behind its threshold.
pub(super) const MOUTH: f32 = 1.2;
/// Whoever is as near to a place need not go there, metres: the width of a foot and a step.
pub(super) const THERE: f32 = 0.3;
/// Whoever stands as near to a threshold is between the doors of a lift, metres: the two doors are 0.25 m apart, and a body
/// is 0.25 m deep.
pub(super) const BETWEEN: f32 = 0.4;
/// Whoever stands as near to the line of a threshold is in its doorway, metres: half a wall and half a body with its arms.
pub(super) const DOORWAY: f32 = 0.35;
/// Nobody stops as near to the middle of a threshold, metres: the corner of a doorway 0.9 m wide, and as deep as a body.
pub(super) const OFF: f32 = 0.6;
/// How near to a threshold the doors of a cabin stand, metres: half the gap between the doors and a leaf's thickness.
pub(super) const AT_THRESHOLD: f32 = 0.3;
/// From how far a door is opened and shut, metres from its threshold: an arm's reach and half the depth of a wall.
pub(super) const REACH: f32 = 1.5;
/// The coordinates that a saved way has at most, metres: what is farther is no place.
pub(super) const FARTHEST: f32 = 1e6;

/// How long a hand takes for the leaf of a portal: 0.9 s, as for doors within a region.
pub(super) const LEAF: Span = Span(54);
/// How long one waits before one tries again where somebody is in the way: 1 s.
pub(super) const PATIENCE: Span = Span(60);
/// How often one tries: it takes a minute, and longer before a full lift, which takes a try only where it stands open.
pub(super) const TRIES: u32 = 60;
/// How often one tries to open or shut a door where somebody stands in the doorway: it takes five to ten seconds.
pub(super) const HANDLES: u32 = 5;
/// How long one stands in a doorway for want of room beyond before one goes back: 2 s.
pub(super) const RETREATS: Span = Span(120);
/// How long one waits there who comes out of a lift or over stairs, as others come behind: 60 s, the time that tries take.
pub(super) const STAYS: Span = Span(3600);
/// How long one waits for somebody in the way who does not make way, before one gets past all the same: 10 s, when walkers within
/// a region give up. Nobody is held for ever.
pub(super) const HELD: Span = Span(600);
/// An action that takes longer is given up: a day.
pub(super) const LONGEST: Span = Span(24 * 3600 * 60);

/// The doors of a lift open or shut: 2.5 s, for leaves of 0.55 m at the speed of those of homes.
pub(super) const DOOR: Span = Span(150);
/// They stay open, at least: 5 s, the time in which somebody slow gets through.
pub(super) const OPEN: Span = Span(300);
/// The speed of a cabin, metres a second: that of lifts in houses of up to eight storeys.
pub(super) const SPEED: f64 = 1.0;
/// Its acceleration, metres per second squared: what passengers do not mind.
pub(super) const ACCELERATION: f64 = 0.8;

/// How thick what is in the way on a shut threshold is, metres: a leaf.
pub(super) const BAR: f32 = 0.05;
/// How far open a leaf is past which things get, 0 to 1.
pub(super) const AJAR: f32 = 0.1;
/// How far over a threshold a thing's middle is when it goes over to the region beyond, metres: what lies on the line does
/// not go to and fro.
pub(super) const OVER: f32 = 0.02;
/// How near to the line the floor below a thing decides in which region it is, metres: floors end up to a quarter of a metre beyond it, and
/// their edges hold what is nearer than two ledges; and how far from the height of the threshold that floor may be.
pub(super) const ON_LINE: f32 = 0.4;
pub(super) const FLUSH: f32 = 0.1;
/// How far from the edge of a floor it is still said to be over it, metres.
pub(super) const EDGE: f32 = 0.03;
/// How far beyond the edge of a floor the middle of what lies on it may be, metres: that of something small that leans over it.
pub(super) const LEDGE: f32 = 0.1;
/// How far over it goes with those that it touches, metres; what stands beyond is in the way for as far again.
pub(super) const TOGETHER: f32 = 1.0;
/// How far beyond a threshold, or beside it, a thing has come through it, metres.
pub(super) const BEHIND: f32 = 2.2;
pub(super) const ASIDE: f32 = 0.5;
/// How near two things are that may touch in this tick, metres; and how far apart those are that are so no longer: what has come over
/// does not go back at once.
pub(super) const TOUCHING: f32 = 0.05;
pub(super) const NEAR: f32 = 0.15;

/// A thing that is slower than this along the ground does not move, metres a second: a millimetre in three ticks; nor what is slower up or down,
/// which is what gravity makes in two.
pub(super) const CREEPS: f32 = 0.02;
pub(super) const WAKES: f32 = 0.33;

/// Through how many doors and windows one sees, one behind the other: what is farther has a few pixels.
pub(super) const PORTALS: u32 = 3;
/// How far away a portal is seen, metres: a door is ten pixels high there.
pub(super) const FAR: f32 = 60.0;
/// How many regions are kept as they were made: those of a small building.
pub(super) const MADE: usize = 24;
/// The figures of how many agents are known to saves without being written: those of a household or two.
pub(super) const FIGURES: usize = 8;
/// The speed, in metres a second, beyond which something falls, and the greatest depth to which it may, metres.
pub(super) const FALLS: f32 = 1.0;
pub(super) const DEEPEST: f32 = 1000.0;
/// Nothing of a region is lower than its frame by so much, metres.
pub(super) const STEP: f32 = 0.5;
