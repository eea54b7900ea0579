//! Why a relation between two things holds or does not, as data and in sentences.

use std::fmt;

use nalgebra::{Point3, Vector3};
use vc_graph::{Edge, NodeId, Relation};

use crate::box_trace::BoxTrace;
use crate::near::NearSide;
use crate::support::{Support, SupportKind};
use crate::threshold::{CORNERS_WITHIN, NEAR_REACH, TOUCH_GAP};

/// The outcome for a hit, a sight, a seat or a hook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TraceOutcome {
    /// It establishes the relation.
    Counts,
    /// It is too far away.
    TooFar,
    /// It has sunk in deeper than a support gives way.
    TooDeep,
    /// The contact is too steep to carry: the thing leans there.
    TooSteep,
    /// The hit thing is inside the traced thing, or in its hull.
    Content,
    /// Something else is a nearer support or seat, or joints, contacts or hands decide.
    Outranked,
    /// The hit thing rests on the traced thing.
    Carried,
    /// The hit thing contains or supports the traced thing, or is part of the building.
    Shade,
    /// Something nearer is above.
    Shaded,
    /// It is outside the field of view, or not under the agent that might sit on it.
    Aside,
    /// Part of the building is in between.
    Walled,
    /// The seat is not at hip height, or the hook is at the lower half.
    WrongHeight,
    /// One of the two is unsuitable: not a seat, not lookable, or not an agent or seat that looks.
    Unfit,
}

/// A hit of a vertical trace.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Hit {
    /// The thing that it hit.
    pub node: NodeId,
    /// Index of the traced thing's convex piece (none if the centre of its box was traced), and of the piece
    /// that was hit.
    pub pieces: (Option<usize>, usize),
    /// Distance from the piece's face (down) or from the centre (up), metres; negative if one has sunk into the
    /// other.
    pub distance: f32,
    /// Approximate point in the world, metres.
    pub at: Point3<f32>,
    /// Normal of the contact, towards the traced thing.
    pub normal: Vector3<f32>,
    /// Its outcome.
    pub outcome: TraceOutcome,
}

/// The extent to which a thing is within one of another's hollows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Containment {
    /// Whether its centre is in the hollow, or above its rim by no more than content may be.
    pub centre: bool,
    /// Number of its eight corners that are in the hollow; four are needed.
    pub corners: u32,
}

/// Position of one thing relative to another's front, in plan.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Sight {
    /// Angle between the front and the direction to the other thing, radians; half a turn if the front points
    /// straight up or down.
    pub angle: f32,
    /// Distance between the centres, metres.
    pub distance: f32,
    /// Whether the thing is faced, or why not.
    pub outcome: TraceOutcome,
}

/// A seat or bed for an agent.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Seat {
    /// Height of its top under the agent's centre, as a share of the agent's height from below; none if it is
    /// not under the centre.
    pub share: Option<f32>,
    /// Whether the agent sits or lies there, or why not.
    pub outcome: TraceOutcome,
}

/// The hook of another thing on which a thing hangs, or comes nearest to hanging.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Hook {
    /// Its position, metres.
    pub at: Point3<f32>,
    /// Distance from the box of the thing that might hang on it, metres.
    pub distance: f32,
    /// Whether the thing hangs there, or why not.
    pub outcome: TraceOutcome,
}

/// One of the thesis's six traces, and its first hit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct BoxTraceHit {
    /// The direction of the trace.
    pub trace: BoxTrace,
    /// The thing it hit and the distance, metres; zero if they overlapped at the start.
    pub hit: Option<(NodeId, f32)>,
}

/// Everything that decides the relations from one thing to another. Facts used only by
/// [`RelationRule::Contacts`](crate::RelationRule::Contacts), the rule of contacts, are empty under another rule.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Explanation {
    /// The thing in question.
    pub from: NodeId,
    /// The other thing, or a room.
    pub to: NodeId,
    /// The relations that hold from the first to the second.
    pub holds: Vec<Relation>,
    /// By the thesis's rule, its six traces.
    pub traces: Vec<BoxTraceHit>,
    /// Hits of the traces down from the thing's pieces, nearest first: for each other thing the best contact.
    /// By the rule of contacts.
    pub down: Vec<Hit>,
    /// Hits of the trace up from its centre, nearest first. By the rule of contacts.
    pub up: Vec<Hit>,
    /// The supports that it rests on in the end, and how they are known. By the rule of contacts.
    pub supports: Vec<Support>,
    /// Edges of holding or wearing it; if there are any, it rests on nothing.
    pub held: Vec<Edge>,
    /// The other thing as a seat or bed of an agent; none if the thing is not an agent. By the rule of contacts.
    pub seat: Option<Seat>,
    /// The nearest hook of the other thing, if it has any. By the rule of contacts.
    pub hook: Option<Hook>,
    /// The other thing relative to the front; none between a thing and a room. By the rule of contacts.
    pub sight: Option<Sight>,
    /// Depth of its centre within rooms, metres, negative outside, the deepest first: the rooms that it may be
    /// in, and the one in question.
    pub rooms: Vec<(NodeId, f32)>,
    /// For a door, the points at which rooms are searched on its two sides, metres, and the rooms found.
    pub sides: Vec<(Point3<f32>, Option<NodeId>)>,
    /// The extent to which it is within each hollow of the other thing.
    pub within: Vec<Containment>,
    /// Gap between the nearest parts, metres; none beyond the distance at which things hang.
    pub gap: Option<f32>,
    /// Distance between the boxes, metres; none beyond reach or behind a wall.
    pub distance: Option<f32>,
    /// The side of the thing at which the other is.
    pub side: Option<NearSide>,
    /// Whether part of the building stands between them.
    pub walled: bool,
}

fn because(outcome: TraceOutcome) -> &'static str {
    match outcome {
        TraceOutcome::Counts => "counts",
        TraceOutcome::TooFar => "too far",
        TraceOutcome::TooDeep => "too deep to rest on",
        TraceOutcome::TooSteep => "too steep to rest on",
        TraceOutcome::Content => "is in it",
        TraceOutcome::Outranked => "something else decides",
        TraceOutcome::Carried => "rests on it",
        TraceOutcome::Shade => "holds it or is the building",
        TraceOutcome::Shaded => "something is between",
        TraceOutcome::Aside => "off to the side",
        TraceOutcome::Walled => "a wall is between",
        TraceOutcome::WrongHeight => "at the wrong height",
        TraceOutcome::Unfit => "not made for it",
    }
}

fn how(kind: SupportKind) -> &'static str {
    match kind {
        SupportKind::Joint => "a joint holds it",
        SupportKind::Contact => "a contact pushes it up",
        SupportKind::Trace => "by the trace down",
        SupportKind::Hook => "it hangs on a hook",
        SupportKind::Container => "it is inside, and nothing is found below",
        SupportKind::Hanging => "nothing is below, and they touch",
    }
}

/// Centimetres with one decimal; adding zero avoids minus zero.
fn cm(metres: f32) -> f32 {
    (metres * 1000.0).round() / 10.0 + 0.0
}

fn way(trace: BoxTrace) -> &'static str {
    match trace {
        BoxTrace::Side(NearSide::Front) => "to the front",
        BoxTrace::Side(NearSide::Back) => "to the back",
        BoxTrace::Side(NearSide::Left) => "to the left",
        BoxTrace::Side(NearSide::Right) => "to the right",
        BoxTrace::Up => "up",
        BoxTrace::Down => "down",
    }
}

/// A few readable sentences.
impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let holds: Vec<&str> = self.holds.iter().map(|&r| vc_graph::Word::as_str(r)).collect();
        let holds = if holds.is_empty() { "nothing".to_owned() } else { holds.join(", ") };
        writeln!(f, "from {} to {}: {holds}", self.from, self.to)?;
        self.tell_traces(f)?;
        self.tell_people(f)?;
        self.tell_rooms(f)?;
        for within in self.within.iter().filter(|w| w.centre || w.corners > 0) {
            let centre = if within.centre { "its centre" } else { "not its centre" };
            writeln!(f, "  in a hollow are {centre} and {} corners of {CORNERS_WITHIN} needed", within.corners)?;
        }
        match (self.gap, self.distance) {
            (Some(gap), _) if gap <= TOUCH_GAP => writeln!(f, "  they touch: the gap is {:.1} mm", gap * 1000.0),
            (_, Some(d)) => writeln!(f, "  they are {d:.2} m apart, near is up to {NEAR_REACH} m"),
            _ if self.walled => writeln!(f, "  a wall is between them"),
            _ => writeln!(f, "  they are not near each other"),
        }
    }
}

impl Explanation {
    fn tell_traces(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for traced in &self.traces {
            match traced.hit {
                Some((what, far)) => {
                    writeln!(f, "  box trace {} hits {what} after {:.1} cm", way(traced.trace), cm(far))
                }
                None => writeln!(f, "  box trace {} hits nothing", way(traced.trace)),
            }?;
        }
        for (way, hits) in [("down", &self.down), ("up", &self.up)] {
            for hit in hits {
                let (what, at) = (hit.node, hit.at);
                write!(f, "  trace {way} meets {what} after {:.1} cm ", cm(hit.distance))?;
                writeln!(f, "at {:.2} {:.2} {:.2}: {}", at.x, at.y, at.z, because(hit.outcome))?;
            }
        }
        self.supports.iter().try_for_each(|s| writeln!(f, "  it rests on {}: {}", s.by, how(s.kind)))
    }

    fn tell_people(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for edge in &self.held {
            let by = if edge.relation == Relation::WornBy { edge.to } else { edge.from };
            writeln!(f, "  {by} holds or wears it: it rests on nothing")?;
        }
        if let Some(seat) = self.seat.filter(|s| s.outcome != TraceOutcome::Unfit) {
            let share =
                seat.share.map_or("not under the middle".to_owned(), |s| format!("at {:.0}% of the height", s * 100.0));
            writeln!(f, "  as a seat or bed, {share}: {}", because(seat.outcome))?;
        }
        if let Some(hook) = self.hook {
            writeln!(f, "  a hook is {:.1} cm from its box: {}", cm(hook.distance), because(hook.outcome))?;
        }
        if let Some(sight) = self.sight.filter(|s| s.outcome != TraceOutcome::Unfit) {
            let (angle, far) = (sight.angle.to_degrees(), sight.distance);
            writeln!(f, "  looked at {angle:.0} degrees off the front, {far:.2} m away: {}", because(sight.outcome))?;
        }
        Ok(())
    }

    fn tell_rooms(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (room, depth) in &self.rooms {
            let side = if *depth < 0.0 { "outside of" } else { "within" };
            writeln!(f, "  its centre is {:.2} m {side} {room}", depth.abs())?;
        }
        for (at, room) in &self.sides {
            let room = room.map_or("no room".to_owned(), |r| r.to_string());
            writeln!(f, "  on a side of the door, at {:.2} {:.2}, is {room}", at.x, at.y)?;
        }
        Ok(())
    }
}
