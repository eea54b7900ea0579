//! The floor of a gallery as cells, by the boxes of everything in its scene.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Point3, Vector3};
use vc_graph::space::RegionId;
use vc_graph::{ObjectRole, Pose, SceneGraph};
use vc_procgen::Building;

/// The side of a cell, metres.
const CELL: f32 = 0.05;
/// The radius of a person, cells.
const BODY: i32 = 5;
/// The heights between which a thing is in the way of a person.
const TALL: (f32, f32) = (0.05, 1.75);

type Cell = (i32, i32);

/// Cells with a floor, and those of them with something in the way.
pub(crate) struct Ground {
    floor: BTreeSet<Cell>,
    taken: BTreeSet<Cell>,
}

/// Where a person gets to.
pub(crate) struct Reached(BTreeSet<Cell>);

impl Reached {
    pub(crate) fn has(&self, place: Point3<f32>) -> bool {
        self.0.contains(&cell(place.x, place.y))
    }
}

fn cell(x: f32, y: f32) -> Cell {
    ((x / CELL).floor() as i32, (y / CELL).floor() as i32)
}

fn cells((low, high): (Point3<f32>, Point3<f32>)) -> impl Iterator<Item = Cell> {
    let (from, to) = (cell(low.x + 1e-3, low.y + 1e-3), cell(high.x - 1e-3, high.y - 1e-3));
    (from.0..=to.0).flat_map(move |x| (from.1..=to.1).map(move |y| (x, y)))
}

impl Ground {
    pub(crate) fn new(scene: &SceneGraph) -> Self {
        let (mut floor, mut taken) = (BTreeSet::new(), BTreeSet::new());
        for node in scene.nodes() {
            let Some(asset) = node.spec().asset.and_then(|asset| scene.assets().get(asset)) else { continue };
            let pose = node.pose().unwrap();
            let shapes = if asset.collision.is_empty() { &asset.parts } else { &asset.collision };
            // Doors open; what moves is not in the way.
            for part in shapes.iter().filter(|part| part.joint.is_none()) {
                let (low, high) = around(&(pose * part.pose), part.shape.extent());
                if node.role() == ObjectRole::Floor {
                    floor.extend(cells((low, high)));
                } else if low.z < TALL.1 && high.z > TALL.0 {
                    taken.extend(cells((low, high)));
                }
            }
        }
        Self { floor, taken }
    }

    fn is_free(&self, (x, y): Cell) -> bool {
        let near = |dx: i32, dy: i32| dx * dx + dy * dy <= BODY * BODY;
        let all = (-BODY..=BODY).flat_map(|dx| (-BODY..=BODY).map(move |dy| (dx, dy)));
        all.filter(|(dx, dy)| near(*dx, *dy)).all(|(dx, dy)| {
            let at = (x + dx, y + dy);
            self.floor.contains(&at) && !self.taken.contains(&at)
        })
    }

    /// The cells to which a person walks from a point.
    pub(crate) fn from(&self, start: Point3<f32>) -> Reached {
        let start = cell(start.x, start.y);
        let (mut seen, mut edge) = (BTreeSet::new(), Vec::new());
        if self.is_free(start) {
            seen.insert(start);
            edge.push(start);
        }
        let mut known = BTreeMap::new();
        while let Some((x, y)) = edge.pop() {
            for at in [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)] {
                if *known.entry(at).or_insert_with(|| self.is_free(at)) && seen.insert(at) {
                    edge.push(at);
                }
            }
        }
        Reached(seen)
    }

    /// Cells at the end of the floor that somebody can step beyond: with nothing in the way within a body's width, and
    /// none of some thresholds near.
    pub(crate) fn unguarded(&self, open: &[(Point3<f32>, f32)]) -> Vec<Cell> {
        let ends = |(x, y): &Cell| {
            !self.floor.contains(&(x + 1, *y))
                || !self.floor.contains(&(x - 1, *y))
                || !self.floor.contains(&(*x, y + 1))
                || !self.floor.contains(&(*x, y - 1))
        };
        let guarded =
            |(x, y): &Cell| (-3..=3).any(|dx: i32| (-3..=3).any(|dy: i32| self.taken.contains(&(x + dx, y + dy))));
        let is_open = |(x, y): &Cell| {
            let at = Vector3::new((*x as f32 + 0.5) * CELL, (*y as f32 + 0.5) * CELL, 0.0);
            open.iter().any(|(place, half)| (at - Vector3::new(place.x, place.y, 0.0)).norm() < half + 0.2)
        };
        self.floor.iter().filter(|at| ends(at) && !guarded(at) && !is_open(at)).copied().collect()
    }
}

fn around(pose: &Pose, (low, high): (Point3<f32>, Point3<f32>)) -> (Point3<f32>, Point3<f32>) {
    let corners = (0..8).map(|i| {
        let side = |bit: i32, a: f32, b: f32| if i >> bit & 1 == 0 { a } else { b };
        pose * Point3::new(side(0, low.x, high.x), side(1, low.y, high.y), side(2, low.z, high.z))
    });
    corners.map(|p| (p, p)).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))).unwrap()
}

/// Points on the gallery half a metre before each of its portals, and before the foot of its stairs.
pub(crate) fn places(building: &Building, gallery: RegionId) -> Vec<(String, Point3<f32>)> {
    let space = building.space();
    let mut places = Vec::new();
    for portal in space.portals_of(gallery) {
        let plan = space.portal(portal).unwrap();
        let side = plan.side(gallery).unwrap();
        let from_below = !plan.stairs.is_empty() && plan.sides[0].region == gallery;
        let place = if from_below {
            let way = (plan.stairs[1] - plan.stairs[0]).normalize();
            plan.stairs[0] - Vector3::new(way.x, way.y, 0.0).normalize() * 0.35
        } else {
            side.pose * Point3::new(-0.5, 0.0, 0.0)
        };
        places.push((format!("{portal}, a {}", plan.kind), place));
    }
    places
}

/// The thresholds of a gallery with half their width: portals, and the foot of its stairs.
pub(crate) fn thresholds(building: &Building, gallery: RegionId) -> Vec<(Point3<f32>, f32)> {
    let space = building.space();
    let of = |portal| {
        let plan = space.portal(portal)?;
        let side = plan.side(gallery)?;
        let foot = plan.stairs.first().filter(|_| plan.sides[0].region == gallery);
        Some((foot.copied().unwrap_or_else(|| Point3::from(side.pose.translation.vector)), plan.width / 2.0))
    };
    space.portals_of(gallery).filter_map(of).collect()
}
