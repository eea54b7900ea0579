//! A small z-buffer renderer for sketches of objects.

use nalgebra::{Point3, Unit, Vector3};
use vc_graph::asset::{Joint, Material};
use vc_graph::portable::Portable;
use vc_graph::{Aabb, Asset, AssetLibrary, Pose};

use super::canvas::encoded;
use super::image::Image;

type V = Vector3<f32>;

/// The projection of a view.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Projection {
    /// Perspective, with the tangent of half the vertical field of view.
    Perspective(f32),
    /// Orthographic, with half the visible height, metres.
    Orthographic(f32),
}

/// The viewpoint of a sketch.
///
/// ```
/// use nalgebra::Point3;
/// use vc_procgen::picture::SketchView;
/// let view = SketchView::around(Point3::origin(), Point3::new(1.0, 1.0, 1.0), 1.0);
/// assert_eq!(view.target, Point3::new(0.5, 0.5, 0.5));
/// assert!(view.eye.z > 1.0, "seen from above");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SketchView {
    /// The position of the camera, metres.
    pub eye: Point3<f32>,
    /// The point at the centre of the image, metres.
    pub target: Point3<f32>,
    /// The projection.
    pub projection: Projection,
    /// How far doors and drawers are open, 0 to 1.
    pub open: f32,
}

/// The number of samples along each side of a pixel.
const FINE: usize = 2;
/// The background colour, sRGB.
const PAPER: [u8; 3] = [236, 237, 238];

impl SketchView {
    /// A view from the front, a little to the left and above, in which the box between two corners
    /// fills an image with the given ratio of width to height.
    pub fn around(low: Point3<f32>, high: Point3<f32>, aspect: f32) -> Self {
        Self::from_direction(Vector3::new(0.8, 0.5, 0.42), low, high, aspect)
    }

    /// The same from any direction, given as the vector towards the camera.
    pub fn from_direction(direction: Vector3<f32>, low: Point3<f32>, high: Point3<f32>, aspect: f32) -> Self {
        let tangent = 0.2;
        let target = nalgebra::center(&low, &high);
        let [right, up, ahead] = frame(-direction);
        let fits = |c: V| {
            let (x, y) = (c.dot(&right).abs() / aspect.min(100.0), c.dot(&up).abs());
            x.max(y) / (tangent * 0.92) - c.dot(&ahead)
        };
        let half = (high - low) / 2.0;
        let corners = Aabb { min: Point3::from(-half), max: Point3::from(half) }.corners();
        let distance = corners.map(|corner| fits(corner.coords)).into_iter().fold(0.01, f32::max);
        let eye = target + direction.normalize() * distance;
        Self { eye, target, projection: Projection::Perspective(tangent), open: 0.0 }
    }
}

/// The right, up and forward axes of a camera that looks along a direction.
fn frame(ahead: V) -> [V; 3] {
    let ahead = ahead.try_normalize(1e-9).unwrap_or(-V::z());
    let right = ahead.cross(&V::z()).try_normalize(1e-3).unwrap_or(-V::y());
    [right, right.cross(&ahead), ahead]
}

/// Renders objects, each at its pose, on a pale ground at their lowest point.
///
/// Uses two lights and a grey sky, without shadows except one on the ground; glass is drawn last,
/// from back to front. The time is proportional to the numbers of triangles and pixels.
///
/// ```
/// use vc_graph::{Pose, Seed};
/// use vc_procgen::picture::{SketchView, sketch};
/// use vc_shapes::{Style, material, object};
///
/// let table = object::generator("dining_table").ok_or("no generator")?;
/// let table = table.object(&Style::from_seed(Seed(1)), Seed(2));
/// let (low, high) = table.asset.extent().ok_or("empty")?;
/// let view = SketchView::around(low, high, 4.0 / 3.0);
/// let image = sketch(&[(&table.asset, Pose::identity())], &material::library(), &view, 160, 120);
/// assert_eq!(image.rgb.len(), 160 * 120 * 3);
/// # Ok::<(), &str>(())
/// ```
pub fn sketch(
    objects: &[(&Asset, Pose)],
    library: &AssetLibrary,
    view: &SketchView,
    width: usize,
    height: usize,
) -> Image {
    let mut faces = faces(objects, library, view.open);
    let mut film = Film::new(view, width * FINE, height * FINE);
    let ground = faces.iter().flat_map(|f| f.at).map(|p| p.z).fold(f32::INFINITY, f32::min);
    film.shadow(&faces, ground, 2 * FINE);
    let depth = |f: &Face<'_>| (f.at[0] + f.at[1].coords + f.at[2].coords - view.eye.coords * 3.0).coords.norm();
    faces.sort_by(|a, b| a.clear.cmp(&b.clear).then(depth(b).total_cmp(&depth(a))));
    faces.iter().for_each(|face| film.face(face));
    film.developed(width, height)
}

/// A triangle to draw.
struct Face<'a> {
    at: [Point3<f32>; 3],
    normals: [V; 3],
    material: &'a Material,
    /// Whether it is transparent.
    clear: bool,
    /// The index of its part, from 1.
    part: u32,
}

fn faces<'a>(objects: &[(&Asset, Pose)], library: &'a AssetLibrary, open: f32) -> Vec<Face<'a>> {
    let mut faces = Vec::new();
    let mut count = 0;
    for (part, pose) in objects.iter().flat_map(|(asset, pose)| asset.parts.iter().map(move |p| (p, pose))) {
        let Some(material) = library.material(part.material) else { continue };
        count += 1;
        let (low, high) = part.shape.extent();
        let moved = part.joint.map_or(Pose::identity(), |j| j.motion(opened(&j, open)));
        let mesh = part.shape.mesh((high - low).norm() * 0.004).transformed(&(pose * moved * part.pose));
        let clear = material.transmission > 0.3;
        faces.extend(mesh.triangles.iter().map(|t| Face {
            at: t.map(|v| mesh.positions[v as usize]),
            normals: t.map(|v| mesh.normals[v as usize]),
            material,
            clear,
            part: count,
        }));
    }
    faces
}

/// The position of a joint opened by a share.
fn opened(joint: &Joint, share: f32) -> f32 {
    let (low, high) = joint.limits;
    share * if high >= -low { high } else { low }
}

/// The image so far.
struct Film {
    view: SketchView,
    axes: [V; 3],
    width: usize,
    height: usize,
    /// Linear colour, inverse depth (greater is nearer) and part index of each sample.
    colour: Vec<V>,
    near: Vec<f32>,
    part: Vec<u32>,
}

impl Film {
    fn new(view: &SketchView, width: usize, height: usize) -> Self {
        let paper = V::from(PAPER.map(|c| (f32::from(c) / 255.0).power(2.2)));
        let pixels = width * height;
        let axes = frame(view.target - view.eye);
        let (colour, near, part) = (vec![paper; pixels], vec![f32::NEG_INFINITY; pixels], vec![0; pixels]);
        Self { view: *view, axes, width, height, colour, near, part }
    }

    /// The pixel position and inverse depth of a point; `None` behind the camera. Inverse depth is
    /// linear in the image.
    fn project(&self, p: &Point3<f32>) -> Option<V> {
        let from = p - self.view.eye;
        let [x, y, z] = self.axes.map(|a| from.dot(&a));
        let half = self.height as f32 / 2.0;
        let (scale, near) = match self.view.projection {
            Projection::Perspective(tangent) => (half / (z * tangent), 1.0 / z),
            Projection::Orthographic(tall) => (half / tall, -z),
        };
        (z > 1e-3).then(|| V::new(self.width as f32 / 2.0 + x * scale, half - y * scale, near))
    }

    /// Calls back with sample index, inverse depth and barycentric weights.
    fn raster(&self, at: &[Point3<f32>; 3], mut pixel: impl FnMut(usize, f32, V)) {
        let [Some(a), Some(b), Some(c)] = at.each_ref().map(|p| self.project(p)) else { return };
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if area.abs() < 1e-9 {
            return;
        }
        let (low, high) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
        let clip = |v: f32, most: usize| (v.max(0.0) as usize).min(most);
        for y in clip(low.y, self.height)..clip(high.y + 1.0, self.height) {
            for x in clip(low.x, self.width)..clip(high.x + 1.0, self.width) {
                let (px, py) = (x as f32 + 0.5, y as f32 + 0.5);
                let wb = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
                let wc = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
                let weights = V::new(1.0 - wb - wc, wb, wc);
                if weights.min() >= 0.0 {
                    pixel(y * self.width + x, weights.dot(&V::new(a.z, b.z, c.z)), weights);
                }
            }
        }
    }

    /// Darkens the ground where objects block the light from above and behind the camera.
    fn shadow(&mut self, faces: &[Face<'_>], ground: f32, soft: usize) {
        let mut dark = vec![0.0_f32; self.colour.len()];
        let slope = Vector3::new(-0.25, -0.35, 0.0);
        for face in faces.iter().filter(|f| !f.clear) {
            let fallen = face.at.map(|p| Point3::new(p.x, p.y, ground) + slope * (p.z - ground).min(0.6));
            self.raster(&fallen, |i, _, _| dark[i] = 1.0);
        }
        for step in [1, self.width] {
            (0..3).for_each(|_| dark = blurred(&dark, step, soft));
        }
        self.colour.iter_mut().zip(dark).for_each(|(c, d)| *c *= 1.0 - 0.35 * d);
    }

    fn face(&mut self, face: &Face<'_>) {
        let (eye, mut seen) = (self.view.eye, Vec::new());
        self.raster(&face.at, |i, near, weights| {
            if near > self.near[i] {
                seen.push((i, near, weights));
            }
        });
        for (i, near, w) in seen {
            let blend = |v: [V; 3]| v[0] * w.x + v[1] * w.y + v[2] * w.z;
            let out = eye - Point3::from(blend(face.at.map(|p| p.coords)));
            let out = out.try_normalize(1e-9).unwrap_or_else(V::z);
            let normal = blend(face.normals).try_normalize(1e-9).unwrap_or_else(V::z);
            let lit = shade(face.material, normal, out);
            if face.clear {
                let edge = (1.0 - normal.dot(&out).abs()).raised(3);
                self.colour[i] = self.colour[i].lerp(&lit, 0.22 + 0.4 * edge);
            } else {
                (self.colour[i], self.near[i], self.part[i]) = (lit, near, face.part);
            }
        }
    }

    /// Averages the samples of each pixel; draws a thin line between parts.
    fn developed(&self, width: usize, height: usize) -> Image {
        let mut image = Image::new(width, height, PAPER);
        for (i, pixel) in image.rgb.chunks_exact_mut(3).enumerate() {
            let corner = (i / width) * FINE * self.width + (i % width) * FINE;
            let fine = (0..FINE * FINE).map(|k| corner + k / FINE * self.width + k % FINE);
            let sum: V = fine.map(|f| self.colour[f] * self.line(f)).sum();
            pixel.copy_from_slice(&<[f32; 3]>::from(sum / (FINE * FINE) as f32).map(encoded));
        }
        image
    }

    fn line(&self, fine: usize) -> f32 {
        let differs = |other: usize| self.part.get(other).is_some_and(|p| *p != self.part[fine]);
        if differs(fine + 1) || differs(fine + self.width) { 0.62 } else { 1.0 }
    }
}

/// The average of each value and `reach` neighbours on both sides, `step` apart.
fn blurred(values: &[f32], step: usize, reach: usize) -> Vec<f32> {
    let at = |i: usize, k: usize| values.get((i + k * step).wrapping_sub(reach * step)).copied().unwrap_or(0.0);
    let count = 2 * reach + 1;
    (0..values.len()).map(|i| (0..count).map(|k| at(i, k)).sum::<f32>() / count as f32).collect()
}

/// Lambertian light of two lamps and the sky, plus specular reflection.
fn shade(material: &Material, normal: V, out: V) -> V {
    let normal = if normal.dot(&out) < 0.0 { -normal } else { normal };
    let colour = V::from(material.colour);
    if material.emission.iter().any(|e| *e > 0.0) {
        return colour;
    }
    let lamps = [(V::new(0.45, 0.7, 1.0), 0.62), (V::new(0.9, -0.6, 0.35), 0.26)];
    let lamps = lamps.map(|(way, power)| (Unit::new_normalize(way), power));
    let lambert: f32 = lamps.iter().map(|(way, power)| normal.dot(way).max(0.0) * power).sum();
    let light = lambert + 0.24 + 0.14 * normal.z;
    let shine = |way: &V| normal.dot(&(way + out).normalize()).max(0.0).raised(40);
    let gloss = (1.0 - material.roughness).raised(2) * 0.4;
    let mirrored = normal * (2.0 * normal.dot(&out)) - out;
    let sky = 0.3 + 0.6 * (mirrored.z * 0.5 + 0.5) + lamps.iter().map(|(way, power)| shine(way) * power).sum::<f32>();
    let metal = colour * (0.35 * light + 0.65 * sky);
    let plain = colour * light + V::repeat(gloss * lamps.iter().map(|(way, p)| shine(way) * p).sum::<f32>());
    plain.lerp(&metal, material.metallic)
}
