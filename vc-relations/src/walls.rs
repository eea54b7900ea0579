//! Walls between things.

use vc_geometry::tree::BoxTree;
use vc_graph::Aabb;

use crate::body::Body;
use crate::solid::Solid;

/// Solids of walls, floors and ceilings.
#[derive(Debug, Clone, Default)]
pub(crate) struct Walls {
    pieces: Vec<Solid>,
    tree: BoxTree,
}

impl Walls {
    pub(crate) fn new<'b>(bodies: impl Iterator<Item = &'b Body>) -> Self {
        let building = bodies.filter(|b| b.traits.structure);
        let pieces: Vec<Solid> = building.flat_map(|b| &b.solids).copied().collect();
        let tree = BoxTree::new(&pieces.iter().map(Solid::region).collect::<Vec<_>>());
        Self { pieces, tree }
    }

    /// Whether part of the building is between the centres of two bodies that are not in one room.
    pub(crate) fn between(&self, a: &Body, b: &Body) -> bool {
        let mut among = Among::new(self);
        among.gather(a, std::iter::once(b));
        among.between(a, b)
    }

    /// Whether part of the building is between the centres of two bodies, whatever rooms they are in.
    pub(crate) fn is_between(&self, a: &Body, b: &Body) -> bool {
        let (from, to) = (a.whole.centre, b.whole.centre);
        let (way, region) = (to - from, Aabb::around(&from.into(), &to.into()));
        let mut crossed = false;
        self.tree.for_each(&region, |wall| {
            let wall = &self.pieces[wall];
            crossed |= wall.meets(&region, 0.0) && wall.is_crossed(&from, &way);
        });
        crossed
    }
}

/// The wall solids that can be between one body and some others.
#[derive(Debug)]
pub(crate) struct Among<'w> {
    walls: &'w Walls,
    near: Vec<u32>,
}

impl<'w> Among<'w> {
    pub(crate) fn new(walls: &'w Walls) -> Self {
        Self { walls, near: Vec::new() }
    }

    /// Collects them.
    pub(crate) fn gather<'b>(&mut self, a: &Body, others: impl Iterator<Item = &'b Body>) {
        let middle = |b: &Body| Aabb { min: b.whole.centre.into(), max: b.whole.centre.into() };
        let apart = others.filter(|b| are_apart(a, b) && !b.traits.structure);
        let ways = apart.map(middle).reduce(|all, b| all.joined(&b));
        self.near.clear();
        if let Some(ways) = ways {
            self.walls.tree.for_each(&ways.joined(&middle(a)), |wall| self.near.push(wall as u32));
        }
    }

    /// Whether one of them is between the centres of the two, if these are not in one room.
    pub(crate) fn between(&self, a: &Body, b: &Body) -> bool {
        if self.near.is_empty() || !are_apart(a, b) {
            return false;
        }
        let (from, to) = (a.whole.centre, b.whole.centre);
        let (way, region) = (to - from, Aabb::around(&from.into(), &to.into()));
        let crosses = |wall: &Solid| wall.meets(&region, 0.0) && wall.is_crossed(&from, &way);
        self.near.iter().any(|&wall| crosses(&self.walls.pieces[wall as usize]))
    }
}

fn are_apart(a: &Body, b: &Body) -> bool {
    a.room.is_none() || a.room != b.room
}
