//! Pictures of a world: the triangles of its assets in an oblique view from above, with a depth buffer.

use std::collections::HashMap;

use nalgebra::{Point3, Vector3};
use virtualcity::graph::asset::Shape;
use virtualcity::graph::mesh::TriangleMesh;
use virtualcity::graph::{AssetId, NodeId, NodeKind, Pose, SceneGraph};
use virtualcity::physics::PhysicsWorld;

/// Size of a picture, pixels.
pub(crate) const SIZE: (u32, u32) = (1500, 1000);
/// Supersampling factor per axis.
const FINE: usize = 2;
/// Pixels per metre.
const SCALE: f32 = 96.0;
/// The point in the middle of the picture.
const MIDDLE: [f32; 3] = [1.6, -0.6, 0.6];
const SKY: [f32; 3] = [0.86, 0.9, 0.94];

struct Canvas {
    width: usize,
    height: usize,
    colour: Vec<[f32; 3]>,
    depth: Vec<f32>,
}

/// The world as rows of RGB, with trails of the moving objects.
pub(crate) fn picture(graph: &SceneGraph, world: &PhysicsWorld, trails: &[(NodeId, Vec<[f32; 3]>)]) -> Vec<u8> {
    let mut canvas = Canvas::new();
    let mut meshes: HashMap<(AssetId, usize), TriangleMesh> = HashMap::new();
    for node in graph.nodes().filter(|n| n.kind() == NodeKind::Object) {
        let (Some(id), Some(pose)) = (node.spec().asset, world.pose(node.id())) else { continue };
        let Some(asset) = graph.assets().get(id) else { continue };
        for (i, part) in asset.parts.iter().enumerate() {
            let mesh = meshes.entry((id, i)).or_insert_with(|| part.shape.mesh(0.003));
            // Every asset in this scene has at most one moving part.
            let moved = part.joint.and_then(|_| world.parts(node.id()).pose(0)).unwrap_or(pose);
            let colour = graph.assets().material(part.material).map_or([0.5; 3], |m| m.colour);
            canvas.mesh(mesh, &(moved * part.pose), colour, 1.0);
        }
    }
    for agent in world.agents().filter_map(|a| world.pose(a)) {
        let body = Shape::Capsule { radius: 0.2, half_height: 0.65 }.mesh(0.005);
        canvas.mesh(&body, &(agent * Pose::translation(0.0, 0.0, 0.85)), [0.9, 0.6, 0.2], 1.0);
    }
    for trail in trails.iter().flat_map(|(_, t)| t.windows(2)) {
        canvas.line(&trail[0].into(), &trail[1].into());
    }
    for water in world.waters() {
        let mesh = Shape::Box { half: (water.max - water.min) / 2.0 }.mesh(0.01);
        let centre = water.centre();
        canvas.mesh(&mesh, &Pose::translation(centre.x, centre.y, centre.z), [0.1, 0.4, 0.7], 0.45);
    }
    canvas.finish()
}

/// The position of a point on the canvas, and its nearness.
fn seen(p: &Point3<f32>) -> [f32; 3] {
    let p = p - Point3::from(MIDDLE);
    let (right, up) = ((p.x - p.y) * 0.707, (p.x + p.y) * 0.41 + p.z * 0.82);
    let (width, height) = (SIZE.0 as f32 / 2.0, SIZE.1 as f32 / 2.0);
    let fine = FINE as f32;
    [(width + right * SCALE) * fine, (height - up * SCALE) * fine, -(p.x + p.y) * 0.58 + p.z * 0.57]
}

impl Canvas {
    fn new() -> Self {
        let (width, height) = (SIZE.0 as usize * FINE, SIZE.1 as usize * FINE);
        Self { width, height, colour: vec![SKY; width * height], depth: vec![f32::NEG_INFINITY; width * height] }
    }

    fn mesh(&mut self, mesh: &TriangleMesh, pose: &Pose, colour: [f32; 3], opacity: f32) {
        let (eye, light) = (Vector3::new(-0.58, -0.58, 0.57), Vector3::new(-0.35, -0.6, 0.72));
        for t in &mesh.triangles {
            let corners = t.map(|v| pose * mesh.positions[v as usize]);
            let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
            let Some(normal) = normal.try_normalize(1e-12).filter(|n| n.dot(&eye) > 0.0) else { continue };
            let bright = 0.4 + 0.6 * normal.dot(&light).max(0.0);
            self.triangle(corners.map(|p| seen(&p)), colour.map(|c| c * bright), opacity);
        }
    }

    fn triangle(&mut self, [a, b, c]: [[f32; 3]; 3], colour: [f32; 3], opacity: f32) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let range = |axis: usize, most: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]).floor().max(0.0) as usize;
            low..(a[axis].max(b[axis]).max(c[axis]).ceil().max(0.0) as usize).min(most)
        };
        for y in range(1, self.height) {
            for x in range(0, self.width) {
                let (px, py) = (x as f32 + 0.5, y as f32 + 0.5);
                let side =
                    |p: [f32; 3], q: [f32; 3]| ((q[0] - p[0]) * (py - p[1]) - (q[1] - p[1]) * (px - p[0])) / area;
                let weights = [side(b, c), side(c, a), side(a, b)];
                if weights.iter().all(|w| *w >= 0.0) {
                    self.dot(x, y, weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2], colour, opacity);
                }
            }
        }
    }

    fn dot(&mut self, x: usize, y: usize, depth: f32, colour: [f32; 3], opacity: f32) {
        let at = y * self.width + x;
        if depth > self.depth[at] {
            let under = self.colour[at];
            self.colour[at] = [0, 1, 2].map(|i| colour[i] * opacity + under[i] * (1.0 - opacity));
            self.depth[at] = depth;
        }
    }

    fn line(&mut self, from: &Point3<f32>, to: &Point3<f32>) {
        let (a, b) = (seen(from), seen(to));
        let steps = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()).ceil().max(1.0);
        for i in 0..steps as usize {
            let t = i as f32 / steps;
            let [x, y, depth] = [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t);
            if x >= 0.0 && y >= 0.0 && (x as usize) < self.width && (y as usize) < self.height {
                self.dot(x as usize, y as usize, depth + 0.05, [0.75, 0.12, 0.08], 0.6);
            }
        }
    }

    /// Averages the supersamples and applies the display gamma.
    fn finish(&self) -> Vec<u8> {
        let mut rows = Vec::with_capacity((SIZE.0 * SIZE.1 * 3) as usize);
        for y in 0..SIZE.1 as usize {
            for x in 0..SIZE.0 as usize {
                let fine = (0..FINE * FINE).map(|i| (y * FINE + i / FINE) * self.width + x * FINE + i % FINE);
                let sum = fine.map(|at| self.colour[at]).fold([0.0; 3], |s, c| [s[0] + c[0], s[1] + c[1], s[2] + c[2]]);
                rows.extend(
                    sum.map(|v: f32| {
                        ((v / (FINE * FINE) as f32).clamp(0.0, 1.0).powf(1.0 / 2.2) * 255.0).round() as u8
                    }),
                );
            }
        }
        rows
    }
}
