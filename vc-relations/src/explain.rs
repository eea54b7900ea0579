//! Explanations of why a relation between two things holds or does not.

use nalgebra::{Point3, Vector3};
use vc_graph::{Aabb, Edge, NodeId};

use crate::body::Body;
use crate::box_trace::{self, BoxTrace};
use crate::containment;
use crate::edges::Reader;
use crate::explanation::{BoxTraceHit, Containment, Explanation, Hit, Hook, Seat, TraceOutcome};
use crate::pair::{self, Contact, Hooked};
use crate::relations::Relations;
use crate::rule::RelationRule;
use crate::sight;
use crate::support::SupportKind;
use crate::threshold::{HOOK_REACH, ROOM_MARGIN, SUPPORT_NORMAL, SUPPORT_SINK, UNDER_REACH};

impl Relations {
    /// Explains which relations hold from one thing to another or to a room, and why others do not. `None` if
    /// the thing has no pose or no shape, or if the other is neither a room nor a thing with both. Costs some
    /// ten microseconds.
    ///
    /// Hits, supports, seats, hooks and sights are those of [`RelationRule::Contacts`], and empty under another rule;
    /// [`RelationRule::BoxTrace`] has its six traces instead.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// let why = relations.explain(home.cup, home.table).ok_or("no such nodes")?;
    /// assert!(why.holds.contains(&vc_graph::Relation::On));
    /// assert_eq!(why.down[0].node, home.table); // The trace down from the cup hits the table.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn explain(&self, from: NodeId, to: NodeId) -> Option<Explanation> {
        let (i, j) = (self.world.index(from)?, self.world.index(to)?);
        let (a, b) = (self.world.bodies[i].as_deref()?, self.world.bodies[j].as_deref());
        let mut why = self.alone(i, a, to);
        match b {
            Some(b) => self.beside((i, a), (j, b), &mut why),
            None if !why.rooms.iter().any(|r| r.0 == to) => return None,
            None => {}
        }
        Some(why)
    }

    /// The facts about one thing by itself and among all others.
    fn alone(&self, index: usize, body: &Body, to: NodeId) -> Explanation {
        let contacts = self.rule() == RelationRule::Contacts;
        let reader = Reader::new(&self.world, &self.facts);
        let mut held: Vec<Edge> = reader.supports.held(body.id).copied().collect();
        held.sort_unstable();
        let rooms = &self.world.rooms;
        let mut depths = rooms.depths(&body.midst());
        depths.retain(|(room, depth)| *depth >= -ROOM_MARGIN || *room == to);
        let sides = body.traits.door.then(|| rooms.sides(body).map(|(at, room)| (Point3::from(at), room)));
        Explanation {
            from: body.id,
            to,
            holds: self.between(body.id, to),
            traces: if self.rule() == RelationRule::BoxTrace { self.traces(index) } else { Vec::new() },
            down: if contacts { self.down(index, body) } else { Vec::new() },
            up: if contacts { self.up(index, body) } else { Vec::new() },
            supports: if contacts { self.supports(body.id) } else { Vec::new() },
            held,
            seat: None,
            hook: None,
            sight: None,
            rooms: depths,
            sides: sides.into_iter().flatten().collect(),
            within: Vec::new(),
            gap: None,
            distance: None,
            side: None,
            walled: false,
        }
    }

    /// Adds the facts about the pair of the two things.
    fn beside(&self, (i, a): (usize, &Body), (j, b): (usize, &Body), why: &mut Explanation) {
        let pair = self.world.pair(i, j);
        let finite = |v: Option<f32>| v.filter(|v| v.is_finite());
        why.within = b.cavities_with(a).into_iter().map(|(centre, corners)| Containment { centre, corners }).collect();
        why.gap = finite(pair.map(|p| p.gap));
        why.distance = finite(pair.map(|p| p.distance));
        why.side = pair.and_then(|p| p.side);
        why.walled = self.world.walls.between(a, b);
        if self.rule() == RelationRule::Contacts {
            why.seat = self.seat((i, a), (j, b));
            why.hook = self.hook(a, b);
            why.sight = Some(sight::sight(a, b, &self.world.walls));
        }
    }

    fn traces(&self, index: usize) -> Vec<BoxTraceHit> {
        let hit = |trace| box_trace::trace(&self.world, index, trace).map(|(other, way)| (self.world.ids[other], way));
        BoxTrace::ALL.map(|trace| BoxTraceHit { trace, hit: hit(trace) }).to_vec()
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
            let inner = containment::holds(body, other) || containment::is_within(other, body);
            let outcome = match contact {
                _ if supports.iter().any(|s| s.by == other.id) => TraceOutcome::Counts,
                _ if inner => TraceOutcome::Content,
                c if c.normal.z < SUPPORT_NORMAL => TraceOutcome::TooSteep,
                _ if pair::rest(body, other, self.world.tolerance).is_finite() => TraceOutcome::Outranked,
                c if c.down < -SUPPORT_SINK => TraceOutcome::TooDeep,
                _ => TraceOutcome::TooFar,
            };
            let (s, t) = (&body.solids[contact.parts.0], &other.solids[contact.parts.1]);
            let at = over_both(&s.region(), &t.region(), s.low.z - contact.down);
            let (pieces, normal) = ((Some(contact.parts.0), contact.parts.1), contact.normal);
            hits.push(Hit { node: other.id, pieces, distance: contact.down, at, normal, outcome });
        }
        hits.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.node.cmp(&b.node)));
        hits
    }

    fn up(&self, index: usize, body: &Body) -> Vec<Hit> {
        let reader = Reader::new(&self.world, &self.facts);
        let under = reader.over(index);
        let met = |other: usize| Some((pair::over(body, self.world.bodies[other].as_deref()?)?, other));
        let mut above: Vec<((f32, usize), usize)> =
            self.world.pairs[index].iter().filter_map(|p| met(p.other as usize)).collect();
        above.sort_by(|a, b| a.0.0.total_cmp(&b.0.0).then(a.1.cmp(&b.1)));
        let (middle, mut open) = (pair::middle_of(body).region(), true);
        let judge = |((over, piece), other): ((f32, usize), usize)| {
            let outcome = match under {
                Some(u) if u == other => TraceOutcome::Counts,
                _ if reader.is_carried(other, index) => TraceOutcome::Carried,
                _ if open => TraceOutcome::Shade,
                _ => TraceOutcome::Shaded,
            };
            open &= outcome == TraceOutcome::Carried;
            let solid = self.world.bodies[other].as_deref()?.solids.get(piece)?;
            let at = over_both(&middle, &solid.region(), body.whole.centre.z + over);
            let (node, normal) = (self.world.ids[other], -Vector3::z());
            Some(Hit { node, pieces: (None, piece), distance: over, at, normal, outcome })
        };
        above.into_iter().filter_map(judge).collect()
    }

    fn seat(&self, (i, a): (usize, &Body), (j, b): (usize, &Body)) -> Option<Seat> {
        if !a.traits.agent {
            return None;
        }
        let taken = Reader::new(&self.world, &self.facts).seat(i, a);
        let share = pair::seat_share(a, b);
        let pair = self.world.pair(i, j);
        let (lies, rests) = (a.lies(), pair.is_some_and(|p| p.rest.is_finite()));
        let outcome = match share {
            _ if taken.is_some_and(|t| t.1 == j) => TraceOutcome::Counts,
            _ if !(if lies { b.traits.lieable } else { b.traits.sittable }) => TraceOutcome::Unfit,
            _ if pair.is_some_and(|p| p.seated) || (rests && taken.is_some()) => TraceOutcome::Outranked,
            _ if lies => TraceOutcome::TooFar,
            Some(_) => TraceOutcome::WrongHeight,
            None => TraceOutcome::Aside,
        };
        Some(Seat { share, outcome })
    }

    fn hook(&self, a: &Body, b: &Body) -> Option<Hook> {
        let rank = |h: &Hooked| (!h.holds(), h.distance);
        let best = pair::hooks(a, b).min_by(|g, h| {
            let (g, h) = (rank(g), rank(h));
            g.0.cmp(&h.0).then(g.1.total_cmp(&h.1))
        })?;
        let hangs = self.supports(a.id).iter().any(|s| s.by == b.id && s.kind == SupportKind::Hook);
        let outcome = match best.distance {
            _ if hangs => TraceOutcome::Counts,
            _ if a.traits.fixed => TraceOutcome::Unfit,
            far if far > HOOK_REACH => TraceOutcome::TooFar,
            _ if !best.is_high => TraceOutcome::WrongHeight,
            _ => TraceOutcome::Outranked,
        };
        Some(Hook { at: best.at.into(), distance: best.distance, outcome })
    }
}

/// Centre of the overlap of two regions in plan, at a given height.
fn over_both(a: &Aabb, b: &Aabb, height: f32) -> Point3<f32> {
    let (low, high) = (a.min.sup(&b.min), a.max.inf(&b.max));
    Point3::new(f32::midpoint(low.x, high.x), f32::midpoint(low.y, high.y), height)
}
