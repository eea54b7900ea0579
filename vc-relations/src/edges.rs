//! The rule of contacts: relations from pair facts.

use vc_graph::{Edge, Relation};

use crate::body::{Body, Posture};
use crate::explanation::TraceOutcome;
use crate::facts::Facts;
use crate::near::NearSide;
use crate::pair::Pair;
use crate::sight;
use crate::support::Supports;
use crate::threshold::{FACING_REACH, TOUCH_GAP};
use crate::world::World;

pub(crate) struct Reader<'w> {
    pub(crate) supports: Supports<'w>,
}

impl<'w> Reader<'w> {
    pub(crate) fn new(world: &'w World, facts: &'w Facts) -> Self {
        Self { supports: Supports::new(world, facts) }
    }

    /// For reading all bodies.
    pub(crate) fn for_all(world: &'w World, facts: &'w Facts) -> Self {
        Self { supports: Supports::for_all(world, facts) }
    }

    fn world(&self) -> &'w World {
        self.supports.world
    }

    /// Adds all edges that start at a body, sorted. They are produced nearly in order, so that sorting is fast.
    pub(crate) fn edges(&self, index: usize, out: &mut Vec<Edge>) {
        let start = out.len();
        let Some(body) = &self.world().bodies[index] else { return };
        let mut add = |relation, to| out.push(Edge::new(body.id, relation, to));
        self.placed(index, body, &mut add);
        if let Some(room) = body.room {
            add(Relation::InRoom, room);
        }
        let held = self.supports.facts.holding(body.id).iter().filter(|e| self.world().index(e.to).is_some());
        held.for_each(|edge| add(edge.relation, edge.to));
        if let Some(over) = self.over(index) {
            add(Relation::Under, self.world().ids[over]);
        }
        self.beside(index, &mut add);
        self.facing(index, body, &mut add);
        if body.traits.door {
            self.world().rooms.beside(body).into_iter().for_each(|room| add(Relation::Between, room));
        }
        out[start..].sort_unstable();
    }

    /// On, inside, sitting and lying: at most one of these holds between two nodes.
    fn placed(&self, index: usize, body: &Body, add: &mut impl FnMut(Relation, vc_graph::NodeId)) {
        let world = self.world();
        let seat = self.seat(index, body);
        if seat.is_none() {
            let is_inside = |other: usize| world.pair(index, other).is_some_and(|p| p.inside);
            let candidates = self.supports.candidates(index);
            let on = candidates.iter().filter(|c| !is_inside(c.index) && self.supports.is_sound(index, c));
            on.for_each(|c| add(Relation::On, c.support.by));
        }
        let facts = self.supports.facts;
        let within = world.pairs[index].iter().filter(|p| p.inside).map(|p| world.ids[p.other as usize]);
        within.filter(|at| !(facts.is_carried(*at) && facts.is_left(body.id))).for_each(|at| add(Relation::Inside, at));
        if let Some((relation, other)) = seat {
            add(relation, world.ids[other]);
        }
    }

    /// The seat or bed of an agent that sits or lies.
    pub(crate) fn seat(&self, index: usize, body: &Body) -> Option<(Relation, usize)> {
        if !body.traits.agent {
            return None;
        }
        let world = self.world();
        let other = |p: &Pair| world.bodies[p.other as usize].as_deref();
        let on = |p: &&Pair| p.rest.is_finite() || p.seated;
        let candidates = world.pairs[index].iter().filter(on);
        let nearest = |p: &&Pair, q: &&Pair| p.rest.abs().total_cmp(&q.rest.abs()).then(p.other.cmp(&q.other));
        if body.lies() {
            let bed = candidates.filter(|p| other(p).is_some_and(|b| b.traits.lieable)).min_by(nearest)?;
            return Some((Relation::LyingOn, bed.other as usize));
        }
        let sits = |p: &&Pair| p.seated || body.posture == Posture::Sitting;
        let seat = candidates.filter(sits).filter(|p| other(p).is_some_and(|b| b.traits.sittable)).min_by(nearest)?;
        Some((Relation::SittingOn, seat.other as usize))
    }

    /// The body that another is under: the nearest thing above that does not rest on it or in it. A container
    /// or support above it shields it from everything further up.
    pub(crate) fn over(&self, index: usize) -> Option<usize> {
        let world = self.world();
        let above = world.pairs[index].iter().filter(|p| p.over.is_finite());
        let is_free = |p: &&Pair| !self.is_carried(p.other as usize, index);
        let first = above.filter(is_free).min_by(|a, b| a.over.total_cmp(&b.over).then(a.other.cmp(&b.other)))?;
        let other = first.other as usize;
        let shades = first.inside
            || world.bodies[other].as_deref().is_none_or(|b| b.traits.fixed)
            || self.supports.candidates(index).iter().any(|c| c.index == other);
        (!shades).then_some(other)
    }

    /// Whether one body rests on another, is in it, or is held by it.
    pub(crate) fn is_carried(&self, what: usize, by: usize) -> bool {
        let world = self.world();
        let by_id = world.ids[by];
        world.pair(what, by).is_some_and(|p| p.inside || p.seated)
            || self.supports.facts.held(world.ids[what]).iter().any(|e| e.from == by_id || e.to == by_id)
            || self.supports.reaches(what, by)
    }

    /// Touching and near, with sides.
    fn beside(&self, index: usize, add: &mut impl FnMut(Relation, vc_graph::NodeId)) {
        let (pairs, ids) = (&self.world().pairs[index], &self.world().ids);
        let to = |pair: &Pair| ids[pair.other as usize];
        pairs.iter().filter(|p| p.gap <= TOUCH_GAP).for_each(|p| add(Relation::Touching, to(p)));
        pairs.iter().filter(|p| p.distance.is_finite()).for_each(|p| add(Relation::Near, to(p)));
        for side in [NearSide::Front, NearSide::Back, NearSide::Left, NearSide::Right] {
            pairs.iter().filter(|p| p.side == Some(side)).for_each(|p| add(side.relation(), to(p)));
        }
    }

    /// Lookable things that an agent or a seat faces: within its field of view, and not behind a wall.
    fn facing(&self, index: usize, body: &Body, add: &mut impl FnMut(Relation, vc_graph::NodeId)) {
        if !sight::can_face(body) {
            return;
        }
        let world = self.world();
        let mut faced = Vec::new();
        world.targets.each(&body.region.grown(FACING_REACH, FACING_REACH), |other| {
            let Some(target) = world.bodies[other].as_deref() else { return };
            if other != index && sight::outcome(body, target, &world.walls) == TraceOutcome::Counts {
                faced.push(world.ids[other]);
            }
        });
        faced.into_iter().for_each(|to| add(Relation::Facing, to));
    }
}
