//! Motions as pure functions of the tick.

use nalgebra::{Point2, Translation3, Vector2};
use serde::{Deserialize, Serialize};
use vc_graph::asset::JointKind;
use vc_graph::clock::{Span, TICKS_PER_SECOND, Tick};
use vc_graph::{NodeId, Pose, Relation, SceneGraph};
use vc_physics::PhysicsWorld;

use crate::environment::execute::towards;
use crate::environment::whereabouts::Whereabouts;

/// Ticks in a second.
pub(super) const RATE: f32 = TICKS_PER_SECOND as f32;
/// Ticks in which a hand goes out, and in which it comes back.
pub(super) const REACHING: Span = Span(33);
/// Ticks in which a door or a drawer goes all its way, and in which one does that is opened in passing.
const WHOLE_WAY: f32 = 54.0;
const SWING: f32 = 37.5;
/// Turning speed, radians per tick: a right angle in a quarter of a second.
const TURN: f32 = 6.3 / RATE;
/// Distance before a door at which a walker opens it, and behind it at which it is shut, metres; and at which the body is
/// in the doorway.
const AT_DOOR: (f32, f32) = (1.1, 1.2);
const IN_DOOR: f32 = 0.9;
/// Distance of the points along a path that are tested for doors, metres.
const FINE: f32 = 0.1;

/// The motion of a body between two events.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum Track {
    /// Feet follow a path.
    Way(Way),
    /// Feet turn on the spot.
    Turn(Turn),
    /// Doors, lids or drawers follow a hand.
    Leaf(Leaf),
    /// A hand goes out to put something where a thing was when it began.
    Reach(Whereabouts),
    /// Feet and doors stay.
    Still,
}

impl Track {
    /// The way, if feet follow one.
    pub(super) fn way(&self) -> Option<&Way> {
        match self {
            Self::Way(way) => Some(way),
            _ => None,
        }
    }

    /// Where the feet are, if they move.
    pub(super) fn feet(&self, at: Tick) -> Option<Pose> {
        match self {
            Self::Way(way) => Some(way.feet(at)),
            Self::Turn(turn) => Some(turn.feet(at)),
            Self::Leaf(_) | Self::Reach(_) | Self::Still => None,
        }
    }
}

/// A turn on the spot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Turn {
    pub(super) from: Pose,
    pub(super) to: Pose,
    pub(super) begin: Tick,
}

impl Turn {
    pub(super) fn end(&self) -> Tick {
        self.begin + Span((self.from.rotation.angle_to(&self.to.rotation) / TURN).ceil() as u64)
    }

    pub(super) fn feet(&self, at: Tick) -> Pose {
        let all = self.from.rotation.angle_to(&self.to.rotation);
        let share = TURN * (at - self.begin).0 as f32 / all.max(1e-6);
        let between = self.from.rotation.try_slerp(&self.to.rotation, share.min(1.0), 1e-6);
        let rotation = between.filter(|_| share < 1.0).unwrap_or(self.to.rotation);
        Pose::from_parts(self.to.translation, rotation)
    }
}

/// A walk along points, then a turn on the spot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Way {
    pub(super) points: Vec<Point2<f32>>,
    pub(super) begin: Tick,
    /// Metres per second.
    pub(super) speed: f32,
    pub(super) from: Pose,
    pub(super) to: Pose,
    /// The distance from those who stand, metres.
    pub(super) apart: f32,
    pub(super) doors: Vec<Passage>,
    /// Those who make way for the walker.
    pub(super) aside: Vec<Sidestep>,
}

/// Somebody who stands, and makes way for a walker: the way aside, and the way back when the walk has ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Sidestep {
    pub(super) agent: NodeId,
    out: Way,
    back: Way,
}

impl Sidestep {
    pub(super) fn new(agent: NodeId, out: Way, until: Tick) -> Self {
        let points = out.points.iter().rev().copied().collect();
        let back = Way { points, begin: until, from: out.to, to: out.from, ..out.clone() };
        Self { agent, out, back }
    }

    pub(super) fn feet(&self, at: Tick) -> Pose {
        self.now(at).feet(at)
    }

    /// The way that is walked in a tick.
    pub(super) fn now(&self, at: Tick) -> &Way {
        if at < self.back.begin { &self.out } else { &self.back }
    }
}

/// A door that a walker opens and shuts in passing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Passage {
    pub(super) door: NodeId,
    /// How open it is by itself.
    pub(super) own: f32,
    wide: f32,
    /// Distance along the way, metres.
    at: f32,
}

impl Way {
    fn length(&self) -> f32 {
        self.points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }

    fn tick_at(&self, metres: f32) -> Tick {
        self.begin + Span((metres.max(0.0) / self.speed * RATE).ceil() as u64)
    }

    /// The tick in which the walker arrives, and turns.
    pub(super) fn arrival(&self) -> Tick {
        self.tick_at(self.length())
    }

    fn last_turn(&self) -> Turn {
        let front = self.points.windows(2).rev().map(|p| p[1] - p[0]).find(|w| w.norm() > 1e-4);
        let from = Pose::from_parts(self.to.translation, front.map_or(self.from.rotation, towards));
        Turn { from, to: self.to, begin: self.arrival() }
    }

    /// The tick at which the walker stands, the doors behind are shut, and whoever has made way is back.
    pub(super) fn end(&self) -> Tick {
        let back = self.aside.iter().map(|step| step.back.end()).max().unwrap_or_default();
        self.standing_from().max(back)
    }

    /// The tick from which on the walker stands, and the doors behind are shut.
    fn standing_from(&self) -> Tick {
        self.doors.iter().map(|passage| passage.ticks(self)[3]).fold(self.last_turn().end(), Tick::max)
    }

    pub(super) fn feet(&self, at: Tick) -> Pose {
        if at < self.begin {
            return self.from;
        }
        let walked = self.speed * (at - self.begin).0 as f32 / RATE;
        let Some((point, front)) = along(&self.points, walked) else { return self.last_turn().feet(at) };
        let ahead = Pose::from_parts(self.to.translation, towards(front));
        let turned = Turn { from: self.from, to: ahead, begin: self.begin }.feet(at).rotation;
        Pose::from_parts(Translation3::new(point.x, point.y, self.to.translation.z), turned)
    }

    /// How open the doors of this walk are in a tick, of those that the walker has begun to open by then.
    pub(super) fn passes(&self, at: Tick) -> impl Iterator<Item = (NodeId, f32)> + '_ {
        let begun = self.doors.iter().filter(move |passage| passage.ticks(self)[0] <= at);
        begun.map(move |passage| (passage.door, passage.open(self, at)))
    }

    /// The ticks in which the body is in a doorway.
    pub(super) fn in_doorway(&self, door: NodeId) -> Option<(Tick, Tick)> {
        let passage = self.doors.iter().find(|p| p.door == door)?;
        Some((self.tick_at(passage.at - IN_DOOR), self.tick_at(passage.at + IN_DOOR)))
    }
}

impl Passage {
    /// The passage of a way through a door. Anything but a door between rooms is shut before the walker arrives.
    pub(super) fn new(world: &PhysicsWorld, graph: &SceneGraph, points: &[Point2<f32>], door: NodeId) -> Option<Self> {
        let (middle, own) = (world.aabb(door)?.centre().xy(), world.parts(door).openness()?);
        let length: f32 = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        let far = |at: f32| along(points, at).map(|(p, _)| ((p - middle).norm(), at));
        let all = (0..=(length / FINE) as u32).filter_map(|i| far(i as f32 * FINE));
        let (_, at) = all.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        Some(Self { door, own, wide: if is_between_rooms(graph, door) { 1.0 } else { 0.0 }, at })
    }

    /// The ticks at which the door begins to open, is open, begins to shut, and is as before.
    fn ticks(&self, way: &Way) -> [Tick; 4] {
        let swing = Span(((self.wide - self.own).abs() * SWING).ceil() as u64);
        let (opens, shuts) = (way.tick_at(self.at - AT_DOOR.0), way.tick_at(self.at + AT_DOOR.1).min(way.arrival()));
        let shuts = shuts.max(opens + swing);
        [opens, opens + swing, shuts, shuts + swing]
    }

    pub(super) fn open(&self, way: &Way, at: Tick) -> f32 {
        let [opens, open, shuts, shut] = self.ticks(way);
        let share = |from: Tick, to: Tick| (at - from).0 as f32 / (to - from).0.max(1) as f32;
        match at {
            _ if at < opens || at >= shut => self.own,
            _ if at < open => self.own + (self.wide - self.own) * share(opens, open),
            _ if at < shuts => self.wide,
            _ => self.wide + (self.own - self.wide) * share(shuts, shut),
        }
    }
}

/// Doors, lids and drawers that a hand moves: doors open before drawers and shut after them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Leaf {
    pub(super) id: NodeId,
    pub(super) begin: Tick,
    /// In the order in which they move.
    parts: Vec<LeafPart>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct LeafPart {
    part: usize,
    from: f32,
    to: f32,
    begin: Tick,
    end: Tick,
}

impl Leaf {
    pub(super) fn new(world: &PhysicsWorld, id: NodeId, ends: &[f32], begin: Tick) -> Self {
        let all = world.parts(id).all();
        let opens = ends.iter().any(|e| *e > 0.0);
        let order = if opens { [JointKind::Hinge, JointKind::Slide] } else { [JointKind::Slide, JointKind::Hinge] };
        let (mut parts, mut now) = (Vec::new(), begin);
        for kind in order {
            let these = || (0..all.len().min(ends.len())).filter(|i| all[*i].kind == kind);
            let lasts = |i: usize| Span(((ends[i] - all[i].open).abs() * WHOLE_WAY).ceil() as u64);
            let part = |i: usize| LeafPart { part: i, from: all[i].open, to: ends[i], begin: now, end: now + lasts(i) };
            parts.extend(these().map(part));
            now += these().map(lasts).max().unwrap_or_default();
        }
        Self { id, begin, parts }
    }

    pub(super) fn end(&self) -> Tick {
        self.parts.iter().map(|p| p.end).fold(self.begin, Tick::max)
    }

    /// How open the widest part is in the end, 0 to 1.
    pub(super) fn openness(&self) -> f32 {
        self.parts.iter().map(|p| p.to).fold(0.0, f32::max)
    }

    /// Whether it moves its parts to the same openness, 0 to 1, as far as there is room for them.
    pub(super) fn ends_at(&self, open: f32) -> bool {
        (self.openness() > 0.0) == (open > 0.0)
    }

    /// How open each part is in a tick.
    pub(super) fn open(&self, at: Tick) -> Vec<(usize, f32)> {
        let open = |p: &LeafPart| {
            let share = (at - p.begin).0 as f32 / (p.end - p.begin).0.max(1) as f32;
            (p.part, if at >= p.end { p.to } else { p.from + (p.to - p.from) * share.min(1.0) })
        };
        self.parts.iter().map(open).collect()
    }
}

/// Whether a thing is a door between rooms.
pub(super) fn is_between_rooms(graph: &SceneGraph, door: NodeId) -> bool {
    graph.related(door, Relation::Between).next().is_some()
}

/// The position and direction after a distance in metres along a path; `None` beyond its end.
fn along(points: &[Point2<f32>], mut way: f32) -> Option<(Point2<f32>, Vector2<f32>)> {
    for pair in points.windows(2) {
        let step = pair[1] - pair[0];
        let length = step.norm();
        if way < length {
            return Some((pair[0] + step * (way / length), step / length));
        }
        way -= length;
    }
    None
}
