//! The building between things.

use std::cell::OnceCell;

use nalgebra::Vector3;

use crate::body::Body;
use crate::solid::Solid;
use crate::threshold::NEAR_REACH;
use crate::tree::{Region, Tree};

/// Pieces of walls, floors and ceilings.
#[derive(Debug, Clone, Default)]
pub(crate) struct Walls {
    pieces: Vec<Solid>,
    tree: Tree,
}

impl Walls {
    pub(crate) fn new<'b>(bodies: impl Iterator<Item = &'b Body>) -> Self {
        let building = bodies.filter(|b| b.traits.structure);
        let pieces: Vec<Solid> = building.flat_map(|b| &b.solids).copied().collect();
        let tree = Tree::new(&pieces.iter().map(Solid::region).collect::<Vec<_>>());
        Self { pieces, tree }
    }

    /// Whether part of the building is between bodies that are not in one room.
    pub(crate) fn between(&self, a: &Body, b: &Body) -> bool {
        let Some((from, way, region)) = way(a, b) else { return false };
        let mut met = false;
        self.tree.each(&region, |wall| met = met || self.pieces[wall].is_crossed(&from, &way));
        met
    }

    pub(crate) fn around(&self, body: &Body) -> Around<'_> {
        // What is near has its middle within about twice the reach.
        let region = body.region.grown(2.0 * NEAR_REACH, 2.0 * NEAR_REACH);
        Around { walls: self, region, near: OnceCell::new() }
    }
}

/// The walls around one body, looked up when first asked for: for many questions about it.
pub(crate) struct Around<'w> {
    walls: &'w Walls,
    region: Region,
    near: OnceCell<Vec<u32>>,
}

impl Around<'_> {
    /// As [`Walls::between`], where one of the two is this body.
    pub(crate) fn between(&self, a: &Body, b: &Body) -> bool {
        let Some((from, way, region)) = way(a, b) else { return false };
        if !self.region.contains(&region) {
            return self.walls.between(a, b);
        }
        let pieces = &self.walls.pieces;
        let near = self.near.get_or_init(|| {
            let mut near = Vec::new();
            self.walls.tree.each(&self.region, |wall| near.push(wall as u32));
            near
        });
        let hits = |wall: &Solid| wall.meets(&region, 0.0) && wall.is_crossed(&from, &way);
        near.iter().any(|&wall| hits(&pieces[wall as usize]))
    }
}

/// The straight way between two bodies that are not in one room, and the region it is in.
fn way(a: &Body, b: &Body) -> Option<(Vector3<f32>, Vector3<f32>, Region)> {
    let (from, to) = (a.whole.centre, b.whole.centre);
    let apart = a.room.is_none() || a.room != b.room;
    apart.then(|| (from, to - from, Region { low: from.inf(&to), high: from.sup(&to) }))
}
