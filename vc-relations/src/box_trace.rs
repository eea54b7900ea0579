//! The thesis's rule: six box traces for each object.
//!
//! "For each object, six box traces are drawn and the collisions are recorded. Four traces
//! are drawn relative to the object's orientation, in its +X, -X, +Y, -Y directions. Two
//! traces are drawn relative to the world's orientation, +Z and -Z. We determine that the
//! object is supported by the object hit by the -Z trace. If +Z and -Z hit the same object,
//! then it is inside of it, otherwise it is under what the +Z trace hits. The rest of the
//! box traces are used to determine an object's proximity to other objects."
//!
//! As in the game engine, the whole box is swept, the first hit counts, and anything that overlaps the box at
//! the start is hit at once.

use nalgebra::Vector3;
use vc_graph::{Aabb, Edge, NodeId, Relation};

use crate::body::Body;
use crate::near::NearSide;
use crate::solid::{Solid, sweep};
use crate::threshold::{NEAR_REACH, UNDER_REACH};
use crate::world::World;

/// One of the thesis's six box traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BoxTrace {
    /// Towards a side of the object.
    Side(NearSide),
    /// Up in the world, however the object is turned.
    Up,
    /// Down in the world, however the object is turned.
    Down,
}

impl BoxTrace {
    /// All six traces.
    pub const ALL: [Self; 6] = [
        Self::Side(NearSide::Front),
        Self::Side(NearSide::Back),
        Self::Side(NearSide::Left),
        Self::Side(NearSide::Right),
        Self::Up,
        Self::Down,
    ];

    fn way(self, body: &Body) -> (Vector3<f32>, f32) {
        let axis = |i: usize| -> Vector3<f32> { body.heading.column(i).into() };
        match self {
            Self::Side(NearSide::Front) => (axis(0), NEAR_REACH),
            Self::Side(NearSide::Back) => (-axis(0), NEAR_REACH),
            Self::Side(NearSide::Left) => (axis(1), NEAR_REACH),
            Self::Side(NearSide::Right) => (-axis(1), NEAR_REACH),
            Self::Up => (Vector3::z(), UNDER_REACH),
            Self::Down => (-Vector3::z(), UNDER_REACH),
        }
    }
}

/// The first body that a trace hits, and the distance to it, metres.
pub(crate) fn trace(world: &World, index: usize, trace: BoxTrace) -> Option<(usize, f32)> {
    let body = world.bodies[index].as_deref()?;
    let (along, limit) = trace.way(body);
    let start = body.whole.region();
    let end = Aabb { min: start.min + along * limit, max: start.max + along * limit };
    let region = start.joined(&end);
    let mut best: Option<(f32, usize)> = None;
    world.tree.for_each(&region, |other| {
        let Some(target) = world.bodies[other].as_deref().filter(|_| other != index) else { return };
        let farthest = best.map_or(limit, |b| b.0);
        if let Some(way) = nearest(&body.whole, target, &along, farthest, &region)
            && best.is_none_or(|b| (way, other) < b)
        {
            best = Some((way, other));
        }
    });
    best.map(|(way, other)| (other, way))
}

fn nearest(whole: &Solid, target: &Body, along: &Vector3<f32>, limit: f32, region: &Aabb) -> Option<f32> {
    let near = target.solids.iter().filter(|s| s.meets(region, 0.0));
    let hits = near.filter_map(|s| sweep(whole, s, along, limit)).map(|hit| hit.way.max(0.0));
    hits.min_by(f32::total_cmp)
}

/// All relations by the thesis's rule, sorted. The building has no supports.
pub(crate) fn edges(world: &World) -> Vec<Edge> {
    let mut edges = Vec::new();
    for index in 0..world.ids.len() {
        let Some(body) = world.bodies[index].as_deref().filter(|b| !b.traits.structure) else { continue };
        let id = |hit: Option<(usize, f32)>| hit.map(|(other, _)| world.ids[other]);
        let [up, down] = [BoxTrace::Up, BoxTrace::Down].map(|t| id(trace(world, index, t)));
        let mut add = |relation, to: NodeId| edges.push(Edge::new(body.id, relation, to));
        down.into_iter().for_each(|by| add(Relation::On, by));
        up.into_iter().for_each(|by| add(if up == down { Relation::Inside } else { Relation::Under }, by));
        body.room.into_iter().for_each(|room| add(Relation::InRoom, room));
        for side in [NearSide::Front, NearSide::Back, NearSide::Left, NearSide::Right] {
            if let Some(to) = id(trace(world, index, BoxTrace::Side(side))) {
                let near = [Edge::new(body.id, Relation::Near, to), Edge::new(to, Relation::Near, body.id)];
                edges.extend(near);
                edges.push(Edge::new(body.id, side.relation(), to));
            }
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}
