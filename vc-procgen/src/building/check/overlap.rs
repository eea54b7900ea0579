//! Things of different regions that share space.

use nalgebra::Point3;
use vc_graph::space::RegionId;
use vc_graph::{Aabb, NodeId, Pose, SceneGraph};

use super::BuildingViolation;
use crate::area::Area;

/// The depth by which things of two regions may share space: slabs and thresholds touch, metres.
const TOUCH: f32 = 0.002;

/// A region with its scene and the boxes of all parts of its things, in the frame of the building.
pub(crate) struct Made {
    pub(crate) region: RegionId,
    pub(crate) scene: SceneGraph,
    pub(crate) boxes: Vec<Piece>,
}

/// The box around a part of a thing.
pub(crate) struct Piece {
    pub(crate) node: NodeId,
    around: Aabb,
}

impl Piece {
    pub(crate) fn area(&self) -> Area {
        let Aabb { min, max } = self.around;
        Area { x0: min.x, y0: min.y, x1: max.x, y1: max.y }
    }
}

impl Made {
    /// A scene that is in some frames, one after the other.
    pub(crate) fn new(region: RegionId, scene: SceneGraph, frames: Vec<Pose>) -> Self {
        let boxes = frames.iter().flat_map(|frame| pieces(&scene, frame)).collect();
        Self { region, scene, boxes }
    }

    fn hull(&self) -> Option<Aabb> {
        let hulls = self.boxes.iter().map(|piece| (piece.around.min, piece.around.max));
        hulls.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))).map(|(min, max)| Aabb { min, max })
    }
}

fn pieces(scene: &SceneGraph, frame: &Pose) -> Vec<Piece> {
    let of = |node: &vc_graph::Node| {
        let (asset, pose) = (scene.assets().get(node.spec().asset?)?, frame * node.pose()?);
        let piece = |part: &vc_graph::asset::Part| {
            let (min, max) = part.shape.extent();
            Piece { node: node.id(), around: turned(&Aabb { min, max }, &(pose * part.pose)) }
        };
        Some(asset.parts.iter().map(piece).collect::<Vec<_>>())
    };
    scene.nodes().filter_map(of).flatten().collect()
}

/// The upright box around a box at a pose.
fn turned(around: &Aabb, pose: &Pose) -> Aabb {
    let corners = around.corners().map(|corner: Point3<f32>| pose * corner);
    let first = (corners[0], corners[0]);
    let (min, max) = corners.iter().fold(first, |(low, high), corner| (low.inf(corner), high.sup(corner)));
    Aabb { min, max }
}

/// Pairs of regions with things that share space.
pub(crate) fn overlaps(made: &[Made]) -> Vec<BuildingViolation> {
    let hulls: Vec<Option<Aabb>> = made.iter().map(Made::hull).collect();
    let near = |a: usize, b: usize| hulls[a].zip(hulls[b]).is_some_and(|(a, b)| shares(&a, &b));
    let pairs = (0..made.len()).flat_map(|a| (a + 1..made.len()).map(move |b| (a, b)));
    let near = pairs.filter(|&(a, b)| near(a, b));
    near.filter_map(|(a, b)| {
        let (one, other) = meeting(&made[a], &made[b])?;
        let nodes = [made[a].scene.label(one), made[b].scene.label(other)];
        Some(BuildingViolation::Overlap { regions: [made[a].region, made[b].region], nodes })
    })
    .collect()
}

/// The first things of two regions that share space.
fn meeting(a: &Made, b: &Made) -> Option<(NodeId, NodeId)> {
    let with = |one: &Piece| b.boxes.iter().find(|other| shares(&one.around, &other.around)).map(|other| other.node);
    a.boxes.iter().find_map(|one| Some((one.node, with(one)?)))
}

fn shares(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|axis| a.min[axis] < b.max[axis] - TOUCH && b.min[axis] < a.max[axis] - TOUCH)
}
