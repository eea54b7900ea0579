//! Ray casting against every triangle, in double precision and independent of the renderer.

use nalgebra::{Matrix4, Point3, Vector3};
use vc_graph::asset::{Joint, Shape};
use vc_graph::{NodeId, SceneGraph, State};
use vc_render::Camera;

/// All triangles of a scene, in the world.
pub struct Caster {
    triangles: Vec<(NodeId, u16, [Point3<f64>; 3])>,
    boxes: Vec<(std::ops::Range<usize>, Point3<f64>, f64)>,
}

impl Hit {
    /// Its position in the world, for a place in the image.
    pub fn point(&self, camera: &Camera, x: f64, y: f64) -> Point3<f64> {
        let f = |v: f32| f64::from(v);
        let across = (x - f(camera.centre.0)) / f(camera.focal.0);
        let down = (y - f(camera.centre.1)) / f(camera.focal.1);
        camera.pose.cast::<f64>() * Point3::new(across * self.depth, down * self.depth, self.depth)
    }
}

/// Image position of a point in pixels, and its depth.
pub fn projected(camera: &Camera, point: &Point3<f64>) -> [f64; 3] {
    let f = |v: f32| f64::from(v);
    let own = camera.pose.cast::<f64>().inverse() * point;
    let (x, y) = (own.x / own.z, own.y / own.z);
    [f(camera.focal.0) * x + f(camera.centre.0), f(camera.focal.1) * y + f(camera.centre.1), own.z]
}

/// The first hit of a ray.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    pub node: NodeId,
    pub part: u16,
    /// Depth along the optical axis.
    pub depth: f64,
    pub normal: Vector3<f64>,
}

impl Caster {
    /// Casts against meshes with a tolerance, which is that of the finest level.
    pub fn new(graph: &SceneGraph, tolerance: f32) -> Self {
        let mut made = Self { triangles: Vec::new(), boxes: Vec::new() };
        for node in graph.nodes() {
            let (Some(pose), Some(asset)) = (node.pose(), node.spec().asset) else { continue };
            for (index, part) in graph.assets().get(asset).unwrap().parts.iter().enumerate() {
                let open = |j: &Joint| if node.is(State::Open) { j.limits.1 } else { 0.0 };
                let own = part.joint.map_or(Matrix4::identity(), |j| j.motion(open(&j)).cast::<f64>().to_homogeneous());
                let scale = Matrix4::new_nonuniform_scaling(&node.spec().scale.cast::<f64>());
                let map = pose.cast::<f64>().to_homogeneous() * scale * own;
                made.add(node.id(), index as u16, &part.shape, &part.pose, &map, tolerance);
            }
        }
        made
    }

    fn add(
        &mut self,
        node: NodeId,
        part: u16,
        shape: &Shape,
        pose: &vc_graph::Pose,
        map: &Matrix4<f64>,
        tolerance: f32,
    ) {
        let mesh = shape.mesh(tolerance).transformed(pose);
        let first = self.triangles.len();
        let place = |v: u32| map.transform_point(&mesh.positions[v as usize].cast::<f64>());
        self.triangles.extend(mesh.triangles.iter().map(|t| (node, part, t.map(place))));
        self.bound(first..self.triangles.len());
    }

    /// Adds a bounding sphere around some triangles.
    fn bound(&mut self, range: std::ops::Range<usize>) {
        let corners: Vec<Point3<f64>> = self.triangles[range.clone()].iter().flat_map(|t| t.2).collect();
        let centre = corners.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / corners.len().max(1) as f64;
        let radius = corners.iter().map(|p| (p.coords - centre).norm()).fold(0.0, f64::max);
        self.boxes.push((range, centre.into(), radius));
    }

    /// The triangles of a node.
    pub fn of(&self, node: NodeId) -> impl Iterator<Item = &[Point3<f64>; 3]> {
        self.triangles.iter().filter(move |t| t.0 == node).map(|t| &t.2)
    }

    /// The same caster with all points of each node's parts moved.
    pub fn moved(&self, to: impl Fn(NodeId, u16, &Point3<f64>) -> Point3<f64>) -> Self {
        let mut made = Self { triangles: Vec::new(), boxes: Vec::new() };
        for (range, ..) in &self.boxes {
            let place = |(node, part, corners): &(NodeId, u16, [Point3<f64>; 3])| {
                (*node, *part, [0, 1, 2].map(|i: usize| to(*node, *part, &corners[i])))
            };
            made.triangles.extend(self.triangles[range.clone()].iter().map(place));
            made.bound(range.clone());
        }
        made
    }

    /// The same caster with the triangles of one node only.
    pub fn only(&self, node: NodeId) -> Self {
        let boxes = self.boxes.iter().filter(|b| self.triangles[b.0.clone()].first().is_some_and(|t| t.0 == node));
        Self { triangles: self.triangles.clone(), boxes: boxes.cloned().collect() }
    }

    /// The first hit at a place in the image, front sides only.
    pub fn cast(&self, camera: &Camera, x: f64, y: f64) -> Option<Hit> {
        self.pierce(camera, x, y).into_iter().min_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// All hits at a place in the image, front sides only.
    pub fn pierce(&self, camera: &Camera, x: f64, y: f64) -> Vec<Hit> {
        let f = |v: f32| f64::from(v);
        let own = Vector3::new(
            (x - f(camera.centre.0)) / f(camera.focal.0),
            (y - f(camera.centre.1)) / f(camera.focal.1),
            1.0,
        );
        let pose = camera.pose.cast::<f64>();
        let (eye, ray) = (Point3::from(pose.translation.vector), pose.rotation * own);
        let mut all = Vec::new();
        for (range, centre, radius) in &self.boxes {
            let to = centre - eye;
            let along = to.dot(&ray) / ray.norm_squared();
            if (to - ray * along).norm() > radius + 1e-6 {
                continue;
            }
            for (node, part, corners) in &self.triangles[range.clone()] {
                if let Some((depth, normal)) = meet(eye, ray, corners)
                    && depth >= f(camera.near)
                {
                    all.push(Hit { node: *node, part: *part, depth, normal });
                }
            }
        }
        all
    }
}

/// Intersection as in Möller and Trumbore 1997.
fn meet(eye: Point3<f64>, ray: Vector3<f64>, [a, b, c]: &[Point3<f64>; 3]) -> Option<(f64, Vector3<f64>)> {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(&ac);
    let p = ray.cross(&ac);
    let determinant = ab.dot(&p);
    if determinant <= 0.0 {
        return None;
    }
    let to = eye - a;
    let u = to.dot(&p) / determinant;
    let q = to.cross(&ab);
    let v = ray.dot(&q) / determinant;
    let t = ac.dot(&q) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then(|| (t, normal.normalize()))
}
