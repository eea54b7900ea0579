//! Liquids in vessels: a body of liquid is fitted into each vessel.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind, Part, Shape};
use vc_graph::portable::Portable;
use vc_graph::{Asset, Pose};

use crate::surface::Coat;

/// Fill levels as shares of a vessel's depth; the first at which the walls enclose the liquid is taken.
const LEVELS: [f32; 5] = [0.8, 0.65, 0.5, 0.35, 0.2];
/// Least depth of a liquid and least width of its surface, metres.
const LEAST: f32 = 0.006;
/// Number of directions in which walls are searched, and number of heights.
const AROUND: usize = 20;
const RINGS: usize = 4;
/// Width of the liquid as a share of the distance between the walls.
const WITHIN: f32 = 0.985;
/// Greatest ratio between the distances of the wall in two directions: a vessel that is open at the side holds
/// no liquid.
const LOPSIDED: f32 = 5.0;
/// Tolerance of curves from their chords, metres.
const TOLERANCE: f32 = 0.001;
/// Scale to which hidden parts shrink, such as the liquid of an empty vessel: a speck inside its bottom.
pub(super) const SPECK: f64 = 1e-3;

/// Linear reflectance of liquids by a word in the name of their class; other liquids look like water.
const COLOURS: [(&str, [f32; 3]); 13] = [
    ("milk", [0.80, 0.78, 0.72]),
    ("cream", [0.80, 0.75, 0.62]),
    ("coffee", [0.030, 0.014, 0.007]),
    ("cocoa", [0.11, 0.05, 0.025]),
    ("tea", [0.26, 0.09, 0.02]),
    ("juice", [0.80, 0.36, 0.04]),
    ("wine", [0.16, 0.008, 0.025]),
    ("beer", [0.55, 0.28, 0.04]),
    ("cola", [0.045, 0.016, 0.008]),
    ("oil", [0.60, 0.44, 0.08]),
    ("vinegar", [0.35, 0.15, 0.05]),
    ("soup", [0.48, 0.19, 0.05]),
    ("sauce", [0.38, 0.05, 0.03]),
];
const WATER: [f32; 3] = [0.30, 0.45, 0.52];

/// The place of the liquid in a vessel.
#[derive(Debug, Clone)]
pub(super) struct Liquid {
    /// Its shape, in the vessel's frame.
    pub(super) part: Part,
    /// A point inside the vessel's bottom.
    pub(super) bottom: [f64; 3],
}

/// The look of a liquid of a class.
pub(super) fn coat(class: &str) -> Coat {
    let known = |(word, _): &&(&str, [f32; 3])| class.contains(word);
    let colour = COLOURS.iter().find(known).map_or(WATER, |(_, colour)| *colour);
    Coat { colour, share: 1.0, roughness: 1.0 }
}

impl Liquid {
    /// The liquid of a vessel that is open above and has walls around; none for any other asset.
    pub(super) fn within(asset: &Asset) -> Option<Self> {
        let walls = Walls::new(asset)?;
        walls.floors().into_iter().find_map(|bottom| Self::above(bottom, &walls))
    }

    fn above(bottom: f32, walls: &Walls) -> Option<Self> {
        let depth = walls.top - bottom;
        let level = LEVELS.into_iter().map(|share| share * depth).find(|level| walls.encloses(bottom + level))?;
        let ring = |i: usize| {
            // The first ring is just above the bottom, the last at the level.
            let share = (i as f32 / (RINGS - 1) as f32).max(0.04);
            let height = bottom + share * level;
            walls.around(height).map(|ring| (height, ring))
        };
        let rings: Vec<(f32, Vec<f32>)> = (0..RINGS).map(ring).collect::<Option<_>>()?;
        let widest = rings.last()?.1.iter().copied().fold(f32::INFINITY, f32::min);
        if level < LEAST || 2.0 * widest < LEAST {
            return None;
        }
        let (x, y) = walls.axis;
        let hidden = Vector3::new(x, y, bottom - 0.0005).map(f64::from);
        // A joint of its own makes it a separate link.
        let axis = Vector3::z();
        let joint = Joint { kind: JointKind::Slide, anchor: Point3::new(x, y, bottom), axis, limits: (0.0, 0.0) };
        let shape = loft(walls.axis, &rings);
        let part =
            Part { name: "liquid".into(), shape, material: u32::MAX, pose: Pose::identity(), joint: Some(joint) };
        Some(Self { part, bottom: hidden.into() })
    }
}

/// The triangles of a vessel, and its vertical axis.
struct Walls {
    triangles: Vec<[Point3<f32>; 3]>,
    axis: (f32, f32),
    top: f32,
    farthest: f32,
}

impl Walls {
    fn new(asset: &Asset) -> Option<Self> {
        let meshes: Vec<_> = asset.parts.iter().map(|p| p.shape.mesh(TOLERANCE).transformed(&p.pose)).collect();
        let boxed = |points: &[Point3<f32>]| {
            let first = *points.first()?;
            Some(points.iter().fold((first, first), |(low, high), p| (low.inf(p), high.sup(p))))
        };
        let boxes: Vec<_> = meshes.iter().filter_map(|mesh| boxed(&mesh.positions)).collect();
        // The body is the widest part: handles and spouts are long, but narrow.
        let width = |(low, high): &(Point3<f32>, Point3<f32>)| (high.x - low.x).min(high.y - low.y);
        let (low, high) = *boxes.iter().max_by(|a, b| width(a).total_cmp(&width(b)))?;
        let all = |t: &[u32; 3], mesh: &vc_graph::TriangleMesh| t.map(|i| mesh.positions[i as usize]);
        let triangles = meshes.iter().flat_map(|mesh| mesh.triangles.iter().map(|t| all(t, mesh))).collect();
        let axis = (f32::midpoint(low.x, high.x), f32::midpoint(low.y, high.y));
        Some(Self { triangles, axis, top: high.z, farthest: (high - low).norm() })
    }

    /// Heights of the faces that look upwards on the axis, from above: for a bucket its bail, then its bottom.
    fn floors(&self) -> Vec<f32> {
        let from = Point3::new(self.axis.0, self.axis.1, self.top + 1.0);
        let upwards = |[a, b, c]: &&[Point3<f32>; 3]| (b - a).cross(&(c - a)).z > 0.0;
        let met = self.triangles.iter().filter(upwards).filter_map(|t| struck(t, &from, &-Vector3::z()));
        let mut heights: Vec<f32> = met.map(|far| from.z - far).collect();
        heights.sort_by(|a, b| b.total_cmp(a));
        heights.dedup();
        heights
    }

    fn encloses(&self, height: f32) -> bool {
        let Some(ring) = self.around(height) else { return false };
        let (least, most) = ring.iter().fold((f32::INFINITY, 0.0_f32), |(l, m), r| (l.min(*r), m.max(*r)));
        most < LOPSIDED * least
    }

    /// Distances to the wall at a height, in all directions; none if it is open somewhere.
    fn around(&self, height: f32) -> Option<Vec<f32>> {
        let from = Point3::new(self.axis.0, self.axis.1, height);
        let crosses = |t: &&[Point3<f32>; 3]| t.iter().any(|p| p.z >= height) && t.iter().any(|p| p.z <= height);
        let near: Vec<&[Point3<f32>; 3]> = self.triangles.iter().filter(crosses).collect();
        let way = |i: usize| {
            let met = near.iter().filter_map(|t| struck(t, &from, &direction(i)));
            met.reduce(f32::min).filter(|far| *far < self.farthest)
        };
        (0..AROUND).map(way).collect()
    }
}

fn direction(i: usize) -> Vector3<f32> {
    // The angle avoids the axes, on which triangles have their edges.
    let angle = std::f32::consts::TAU * (i as f32 + 0.37) / AROUND as f32;
    Vector3::new(angle.cosine(), angle.sine(), 0.0)
}

/// Distance along a ray to a triangle, hit from either side (Möller and Trumbore 1997).
fn struck([a, b, c]: &[Point3<f32>; 3], from: &Point3<f32>, way: &Vector3<f32>) -> Option<f32> {
    let (u, v) = (b - a, c - a);
    let p = way.cross(&v);
    let determinant = u.dot(&p);
    if determinant.abs() < 1e-14 {
        return None;
    }
    let s = from - a;
    let q = s.cross(&u);
    let (x, y, far) = (s.dot(&p) / determinant, way.dot(&q) / determinant, v.dot(&q) / determinant);
    (x >= 0.0 && y >= 0.0 && x + y <= 1.0 && far > 0.0).then_some(far)
}

/// A closed solid through rings around an axis, from the lowest ring to the surface.
fn loft((x, y): (f32, f32), rings: &[(f32, Vec<f32>)]) -> Shape {
    let (first, last) = (rings[0].0, rings[rings.len() - 1].0);
    let mut vertices = vec![Point3::new(x, y, first), Point3::new(x, y, last)];
    for (height, ring) in rings {
        let at = |(i, far): (usize, &f32)| Point3::new(x, y, *height) + direction(i) * (far * WITHIN);
        vertices.extend(ring.iter().enumerate().map(at));
    }
    let at = |ring: usize, i: usize| (2 + ring * AROUND + i % AROUND) as u32;
    let top = rings.len() - 1;
    let mut triangles = Vec::new();
    for i in 0..AROUND {
        triangles.extend([[0, at(0, i + 1), at(0, i)], [1, at(top, i), at(top, i + 1)]]);
        for ring in 0..top {
            let [a, b, c, d] = [at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Shape::Mesh { vertices, triangles, uvs: Vec::new() }
}
