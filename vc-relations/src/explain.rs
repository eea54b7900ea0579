//! Why a relation holds between two things, or does not.

use std::fmt;

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Relation};

use crate::body::Body;
use crate::edges::Reader;
use crate::near::Side;
use crate::pair::{self, Contact};
use crate::relations::Relations;
use crate::support::{Ground, Support};
use crate::threshold::{CORNERS_WITHIN, NEAR_REACH, SUPPORT_NORMAL, SUPPORT_SINK, TOUCH_GAP, UNDER_REACH};

/// What became of a hit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Verdict {
    /// It makes the relation.
    Counts,
    /// It is farther than a support may be.
    TooFar,
    /// It is sunk in deeper than a support gives.
    TooDeep,
    /// The contact is too steep to carry: the thing leans there.
    TooSteep,
    /// What was hit is inside the traced thing, or in its hull.
    Content,
    /// Something else is a nearer support, or joints, contacts or hands decide.
    Outranked,
    /// What was hit rests on the traced thing.
    Carried,
    /// What was hit holds or carries the traced thing, or is the building.
    Shade,
    /// Something nearer is above.
    Shaded,
}

/// Where a vertical trace met something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// What it met.
    pub what: NodeId,
    /// Number of the traced thing's convex piece, and of the one that was met.
    pub pieces: (usize, usize),
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

/// Everything that decides about the relations from one thing to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// The thing asked about.
    pub from: NodeId,
    /// The other.
    pub to: NodeId,
    /// The relations that hold from one to the other.
    pub holds: Vec<Relation>,
    /// What the traces down from the thing's pieces met, nearest first: for each other
    /// thing its best contact.
    pub down: Vec<Hit>,
    /// What the trace up from its middle met, nearest first.
    pub up: Vec<Hit>,
    /// What it rests on in the end, and how that is known.
    pub supports: Vec<Support>,
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

impl Relations {
    /// Why relations hold from one thing to another, by the repaired rule, or do not. `None`
    /// if one of them has no pose or no shape. Costs some ten microseconds.
    pub fn explain(&self, from: NodeId, to: NodeId) -> Option<Explanation> {
        let (i, j) = (self.world.index(from)?, self.world.index(to)?);
        let (a, b) = (self.world.bodies[i].as_ref()?, self.world.bodies[j].as_ref()?);
        let pair = self.world.pair(i, j);
        let finite = |v: Option<f32>| v.filter(|v| v.is_finite());
        let within = b.cavities_with(a).into_iter().map(|(centre, corners)| Within { centre, corners });
        Some(Explanation {
            from,
            to,
            holds: self.between(from, to),
            down: self.down(i, a),
            up: self.up(i, a),
            supports: self.supports(from),
            within: within.collect(),
            gap: finite(pair.map(|p| p.gap)),
            distance: finite(pair.map(|p| p.distance)),
            side: pair.and_then(|p| p.side),
            walled: self.world.walls.between(a, b),
        })
    }

    fn down(&self, index: usize, body: &Body) -> Vec<Hit> {
        let supports = self.supports(body.id);
        let mut hits = Vec::new();
        for index in self.world.below(index) {
            let Some(other) = &self.world.bodies[index] else { continue };
            let mut best: Option<Contact> = None;
            pair::contacts(body, other, UNDER_REACH, |c| {
                let rank = |c: &Contact| (c.normal.z < SUPPORT_NORMAL, c.down.abs());
                if best.is_none_or(|b| rank(&c) < rank(&b)) {
                    best = Some(c);
                }
            });
            let Some(contact) = best else { continue };
            let inner = pair::holds(body, other) || pair::is_within(other, body);
            let verdict = match contact {
                _ if supports.iter().any(|s| s.by == other.id) => Verdict::Counts,
                _ if inner => Verdict::Content,
                c if c.normal.z < SUPPORT_NORMAL => Verdict::TooSteep,
                _ if pair::rest(body, other).is_finite() => Verdict::Outranked,
                c if c.down < -SUPPORT_SINK => Verdict::TooDeep,
                _ => Verdict::TooFar,
            };
            let (s, t) = (&body.solids[contact.parts.0], &other.solids[contact.parts.1]);
            let (low, high) = (s.low.sup(&t.low), s.high.inf(&t.high));
            let at = Point3::new(f32::midpoint(low.x, high.x), f32::midpoint(low.y, high.y), s.low.z - contact.down);
            let (pieces, normal) = (contact.parts, contact.normal);
            hits.push(Hit { what: other.id, pieces, distance: contact.down, at, normal, verdict });
        }
        hits.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.what.cmp(&b.what)));
        hits
    }

    fn up(&self, index: usize, body: &Body) -> Vec<Hit> {
        let reader = Reader::new(&self.world, &self.facts);
        let under = reader.over(index);
        let mut above: Vec<(f32, usize)> =
            self.world.pairs[index].iter().filter(|p| p.over.is_finite()).map(|p| (p.over, p.other as usize)).collect();
        above.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut open = true;
        let judge = |(over, other): (f32, usize)| {
            let verdict = match under {
                Some(u) if u == other => Verdict::Counts,
                _ if reader.is_carried(other, index) => Verdict::Carried,
                _ if open => Verdict::Shade,
                _ => Verdict::Shaded,
            };
            open &= verdict == Verdict::Carried;
            let at = Point3::from(body.whole.centre + Vector3::z() * over);
            Hit { what: self.world.ids[other], pieces: (0, 0), distance: over, at, normal: -Vector3::z(), verdict }
        };
        above.into_iter().map(judge).collect()
    }
}

fn because(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Counts => "counts",
        Verdict::TooFar => "too far to rest on",
        Verdict::TooDeep => "too deep to rest on",
        Verdict::TooSteep => "too steep to rest on",
        Verdict::Content => "is in it",
        Verdict::Outranked => "something else carries it",
        Verdict::Carried => "rests on it",
        Verdict::Shade => "holds it or is the building",
        Verdict::Shaded => "something is between",
    }
}

/// Some sentences for people.
impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let holds: Vec<&str> = self.holds.iter().map(|&r| vc_graph::Word::as_str(r)).collect();
        let holds = if holds.is_empty() { "nothing".to_owned() } else { holds.join(", ") };
        writeln!(f, "from {} to {}: {holds}", self.from, self.to)?;
        for (way, hits) in [("down", &self.down), ("up", &self.up)] {
            for hit in hits {
                let (what, at) = (hit.what, hit.at);
                // Tenths of millimetres are shown as none, not as minus none.
                let way_long = (hit.distance * 1000.0).round() / 10.0 + 0.0;
                write!(f, "  trace {way} meets {what} after {way_long:.1} cm ")?;
                writeln!(f, "at {:.2} {:.2} {:.2}: {}", at.x, at.y, at.z, because(hit.verdict))?;
            }
        }
        for support in &self.supports {
            let how = match support.ground {
                Ground::Joint => "a joint holds it",
                Ground::Contact => "a contact pushes it up",
                Ground::Trace => "by the trace down",
                Ground::Hook => "it hangs on a hook",
                Ground::Container => "it is inside, and nothing is found below",
                Ground::Hanging => "nothing is below, and they touch",
            };
            writeln!(f, "  it rests on {}: {how}", support.by)?;
        }
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
