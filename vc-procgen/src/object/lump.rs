//! Lumps: a thing in the hand that nothing is put on or in is one convex body to physics, however
//! many buttons and seams are seen on it.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, Part, Shape};
use vc_graph::{Asset, ClassTable, Pose, Property};

/// Least number of costly parts that are worth it.
const PARTS: usize = 2;
/// Corners of an outline that is one of few pieces.
const CORNERS: usize = 16;
/// Greatest side of what is carried in a hand, metres.
const SMALL: f32 = 1.4;
/// How far from the lowest and the highest point a corner belongs to foot or top, metres.
const LEVEL: f32 = 0.002;
/// How far what is round may be from the polygon it is taken for, metres.
const COARSE: f32 = 0.002;

/// Gives an asset of such a class a hull for all parts that move together, where these are many.
pub(super) fn lump(class: &str, asset: &mut Asset, size: Vector3<f32>) {
    let many = asset.parts.iter().filter(|p| is_costly(p)).count() >= PARTS;
    let small = size.max() <= SMALL && asset.surfaces.is_empty() && asset.collision.is_empty();
    if !many || !small || !is_only_carried(class) {
        return;
    }
    let mut joints: Vec<Option<Joint>> = Vec::new();
    asset.parts.iter().for_each(|p| joints.extend((!joints.contains(&p.joint)).then_some(p.joint)));
    asset.collision = joints.into_iter().flat_map(|joint| of_link(&asset.parts, joint)).collect();
}

/// Whether a class is of things that are carried, and carry nothing.
fn is_only_carried(class: &str) -> bool {
    use Property::{Container, Graspable, Lieable, Recipient, Sittable, Surface};
    let table = ClassTable::builtin();
    let has = |properties: &[Property]| {
        table.get(class).is_some_and(|c| properties.iter().any(|p| c.affordances.contains(*p)))
    };
    has(&[Graspable]) && !has(&[Container, Recipient, Surface, Sittable, Lieable])
}

/// Whether hulls have to be found for it, or many pieces made.
fn is_costly(part: &Part) -> bool {
    match &part.shape {
        Shape::Mesh { .. } | Shape::Hull { .. } => true,
        Shape::Extrusion { outline, .. } => outline.len() > CORNERS,
        _ => false,
    }
}

/// The hull of what moves on a joint, or its parts where these are simple.
fn of_link(parts: &[Part], joint: Option<Joint>) -> Vec<Part> {
    let link: Vec<&Part> = parts.iter().filter(|p| p.joint == joint).collect();
    if link.iter().filter(|p| is_costly(p)).count() < PARTS {
        return link.into_iter().cloned().collect();
    }
    let mut points = Vec::new();
    link.iter().for_each(|part| corners(part, &mut points));
    let shape = Shape::Hull { points: outermost(&points) };
    vec![Part { name: "lump".into(), shape, material: link[0].material, pose: Pose::identity(), joint }]
}

/// Points of a part's surface in the asset's frame, its outermost among them.
fn corners(part: &Part, points: &mut Vec<Point3<f32>>) {
    match &part.shape {
        Shape::Mesh { vertices: all, .. } | Shape::Hull { points: all } => {
            points.extend(all.iter().map(|p| part.pose * p));
        }
        round => points.extend(round.mesh(COARSE).positions.iter().map(|p| part.pose * p)),
    }
}

/// The points farthest out along the axes and between them, and those around a level foot and a
/// level top.
fn outermost(points: &[Point3<f32>]) -> Vec<Point3<f32>> {
    let steps = || [-1.0_f32, 0.0, 1.0].into_iter();
    let around = steps().flat_map(|x| steps().map(move |y| Vector3::new(x, y, 0.0)));
    let around: Vec<Vector3<f32>> = around.filter(|way| *way != Vector3::zeros()).collect();
    let slanted = around.iter().flat_map(|way| [-1.0, 1.0].map(|z| way + Vector3::z() * z));
    let ways = around.iter().copied().chain(slanted.filter(|way| way.x * way.y != 0.0));
    let mut found: Vec<Point3<f32>> = ways.filter_map(|way| farthest(points, &way)).collect();
    for up in [-1.0, 1.0] {
        let most = points.iter().map(|p| up * p.z).fold(f32::NEG_INFINITY, f32::max);
        let level = points.iter().filter(|p| up * p.z > most - LEVEL).map(|p| Point3::new(p.x, p.y, up * most));
        let level: Vec<Point3<f32>> = level.collect();
        found.extend(around.iter().filter_map(|way| farthest(&level, way)));
    }
    found.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    found.dedup();
    found
}

fn farthest(points: &[Point3<f32>], way: &Vector3<f32>) -> Option<Point3<f32>> {
    let (mut most, mut best) = (f32::NEG_INFINITY, None);
    for point in points {
        let far = point.coords.dot(way);
        if far > most {
            (most, best) = (far, Some(*point));
        }
    }
    best
}
