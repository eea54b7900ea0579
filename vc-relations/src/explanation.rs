//! Why a relation holds between two things, or does not: as data and in sentences.

use std::fmt;

use nalgebra::{Point3, Vector3};
use vc_graph::{Edge, NodeId, Relation};

use crate::box_trace::Trace;
use crate::near::Side;
use crate::support::{Ground, Support};
use crate::threshold::{CORNERS_WITHIN, NEAR_REACH, TOUCH_GAP};

/// What became of a hit, a look, a seat or a hook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Verdict {
    /// It makes the relation.
    Counts,
    /// It is farther than it may be.
    TooFar,
    /// It is sunk in deeper than a support gives.
    TooDeep,
    /// The contact is too steep to carry: the thing leans there.
    TooSteep,
    /// What was hit is inside the traced thing, or in its hull.
    Content,
    /// Something else is a nearer support or seat, or joints, contacts or hands decide.
    Outranked,
    /// What was hit rests on the traced thing.
    Carried,
    /// What was hit holds or carries the traced thing, or is the building.
    Shade,
    /// Something nearer is above.
    Shaded,
    /// It is outside the field that is faced, or not under who might sit on it.
    Aside,
    /// Part of the building is between.
    Walled,
    /// The seat is not at the height of the hips, or the hook at the lower half.
    WrongHeight,
    /// One of the two is not made for it: no seat, nothing to look at, nobody who looks.
    Unfit,
}

/// Where a vertical trace met something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// What it met.
    pub what: NodeId,
    /// Number of the traced thing's convex piece, none where the middle of its box was traced,
    /// and of the one that was met.
    pub pieces: (Option<usize>, usize),
    /// How far it went from the face (down) or from the middle (up), metres; negative where
    /// one is sunk into the other.
    pub distance: f32,
    /// About where, in the world, metres.
    pub at: Point3<f32>,
    /// The contact's normal, towards the traced thing.
    pub normal: Vector3<f32>,
    /// What became of it.
    pub verdict: Verdict,
}

/// How far a thing is within one of another's hollows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Within {
    /// Whether its centre is in it, or over its rim by no more than content may be.
    pub centre: bool,
    /// How many of its eight corners are in it; four are needed.
    pub corners: u32,
}

/// How one thing is to another's front, from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Angle between the front and the way to the other, radians; half a turn where the front
    /// points straight up or down.
    pub angle: f32,
    /// From centre to centre, metres.
    pub distance: f32,
    /// Whether it is faced.
    pub verdict: Verdict,
}

/// How something is to sit or lie on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seat {
    /// Where its top is under the agent's middle, as a share of the agent's height from below;
    /// none where it is not under the middle.
    pub share: Option<f32>,
    /// Whether the agent sits or lies there.
    pub verdict: Verdict,
}

/// The hook of another thing on which one hangs, or comes nearest to hanging.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hook {
    /// Where it is, metres.
    pub at: Point3<f32>,
    /// How far from the box of what might hang on it, metres.
    pub distance: f32,
    /// Whether it hangs there.
    pub verdict: Verdict,
}

/// One of the thesis's six traces, and what it hit first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traced {
    /// Which way it went.
    pub trace: Trace,
    /// What it hit, and after how many metres; zero for what overlapped at the start.
    pub hit: Option<(NodeId, f32)>,
}

/// Everything that decides about the relations from one thing to another. What only the
/// repaired rule asks is empty by another rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// The thing asked about.
    pub from: NodeId,
    /// The other.
    pub to: NodeId,
    /// The relations that hold from one to the other.
    pub holds: Vec<Relation>,
    /// By the thesis's rule, its six traces.
    pub traces: Vec<Traced>,
    /// What the traces down from the thing's pieces met, nearest first: for each other
    /// thing its best contact. By the repaired rule.
    pub down: Vec<Hit>,
    /// What the trace up from its middle met, nearest first. By the repaired rule.
    pub up: Vec<Hit>,
    /// What it rests on in the end, and how that is known. By the repaired rule.
    pub supports: Vec<Support>,
    /// The hands and bodies that hold or wear it: then it rests on nothing.
    pub held: Vec<Edge>,
    /// How an agent is on the other as on a seat or bed; none for what is no agent. By the
    /// repaired rule.
    pub seat: Option<Seat>,
    /// How it is to the nearest hook of the other, if that has any. By the repaired rule.
    pub hook: Option<Hook>,
    /// How the other is to its front; none between a thing and a room. By the repaired rule.
    pub sight: Option<Sight>,
    /// How far its centre is within rooms, metres, negative outside, the deepest first: those
    /// that it may be in, and the one asked about.
    pub rooms: Vec<(NodeId, f32)>,
    /// For a door, where rooms are looked for on its two sides, metres, and those that are there.
    pub sides: Vec<(Point3<f32>, Option<NodeId>)>,
    /// How far it is within each hollow of the other.
    pub within: Vec<Within>,
    /// Gap between the nearest parts, metres; none beyond the distance at which things hang.
    pub gap: Option<f32>,
    /// Distance of the boxes, metres; none beyond reach or behind a wall.
    pub distance: Option<f32>,
    /// At which side of the thing the other is.
    pub side: Option<Side>,
    /// Whether part of the building stands between them.
    pub walled: bool,
}

fn because(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Counts => "counts",
        Verdict::TooFar => "too far",
        Verdict::TooDeep => "too deep to rest on",
        Verdict::TooSteep => "too steep to rest on",
        Verdict::Content => "is in it",
        Verdict::Outranked => "something else decides",
        Verdict::Carried => "rests on it",
        Verdict::Shade => "holds it or is the building",
        Verdict::Shaded => "something is between",
        Verdict::Aside => "off to the side",
        Verdict::Walled => "a wall is between",
        Verdict::WrongHeight => "at the wrong height",
        Verdict::Unfit => "not made for it",
    }
}

fn how(ground: Ground) -> &'static str {
    match ground {
        Ground::Joint => "a joint holds it",
        Ground::Contact => "a contact pushes it up",
        Ground::Trace => "by the trace down",
        Ground::Hook => "it hangs on a hook",
        Ground::Container => "it is inside, and nothing is found below",
        Ground::Hanging => "nothing is below, and they touch",
    }
}

/// Centimetres with a tenth; none are shown as none, not as minus none.
fn cm(metres: f32) -> f32 {
    (metres * 1000.0).round() / 10.0 + 0.0
}

fn way(trace: Trace) -> &'static str {
    match trace {
        Trace::Side(Side::Front) => "to the front",
        Trace::Side(Side::Back) => "to the back",
        Trace::Side(Side::Left) => "to the left",
        Trace::Side(Side::Right) => "to the right",
        Trace::Up => "up",
        Trace::Down => "down",
    }
}

/// Some sentences for people.
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
                let (what, at) = (hit.what, hit.at);
                write!(f, "  trace {way} meets {what} after {:.1} cm ", cm(hit.distance))?;
                writeln!(f, "at {:.2} {:.2} {:.2}: {}", at.x, at.y, at.z, because(hit.verdict))?;
            }
        }
        self.supports.iter().try_for_each(|s| writeln!(f, "  it rests on {}: {}", s.by, how(s.ground)))
    }

    fn tell_people(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for edge in &self.held {
            let by = if edge.relation == Relation::WornBy { edge.to } else { edge.from };
            writeln!(f, "  {by} holds or wears it: it rests on nothing")?;
        }
        if let Some(seat) = self.seat.filter(|s| s.verdict != Verdict::Unfit) {
            let share =
                seat.share.map_or("not under the middle".to_owned(), |s| format!("at {:.0}% of the height", s * 100.0));
            writeln!(f, "  as a seat or bed, {share}: {}", because(seat.verdict))?;
        }
        if let Some(hook) = self.hook {
            writeln!(f, "  a hook is {:.1} cm from its box: {}", cm(hook.distance), because(hook.verdict))?;
        }
        if let Some(sight) = self.sight.filter(|s| s.verdict != Verdict::Unfit) {
            let (angle, far) = (sight.angle.to_degrees(), sight.distance);
            writeln!(f, "  looked at {angle:.0} degrees off the front, {far:.2} m away: {}", because(sight.verdict))?;
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
