//! Closed surfaces over rings and grids: lofts, tubes, leaves, draped sheets and cushions, one at a time or
//! gathered into one mesh.

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use super::build::{Axis, Build, P};
use super::circle;
use super::curve::oval;
use crate::material::MaterialId;

/// A mesh under construction, made of closed pieces.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::MeshBuilder;
/// // Many slats as one part.
/// let mut mesh = MeshBuilder::default();
/// for i in 0..5 {
///     let x = 0.1 * i as f32;
///     mesh.block([x, 0.0, 0.0], [x + 0.05, 0.8, 0.02]);
/// }
/// mesh.put(&mut b, "slats", OAK);
/// assert_eq!(b.finish().0.parts.len(), 1);
/// ```
#[derive(Default)]
pub struct MeshBuilder {
    vertices: Vec<P>,
    triangles: Vec<[u32; 3]>,
}

impl MeshBuilder {
    /// Adds the mesh to the object as one part.
    pub fn put(self, b: &mut Build<'_>, name: &str, mat: MaterialId) {
        if !self.triangles.is_empty() {
            b.mesh(name, self.vertices, self.triangles, mat);
        }
    }

    /// Begins a closed piece with the given numbers of points and triangles; returns the indices of
    /// its first point and first triangle for [`MeshBuilder::close`].
    fn open(&mut self, points: usize, triangles: usize) -> (u32, usize) {
        self.vertices.reserve(points);
        self.triangles.reserve(triangles);
        (self.vertices.len() as u32, self.triangles.len())
    }

    /// Ends a piece and flips its triangles if its volume is negative.
    fn close(&mut self, (first, start): (u32, usize)) {
        let at = |v: u32| Vector3::from(self.vertices[v as usize]);
        let origin = self.vertices.get(first as usize).map_or(Vector3::zeros(), |&v| Vector3::from(v));
        let volume = |t: &[u32; 3]| (at(t[0]) - origin).dot(&(at(t[1]) - origin).cross(&(at(t[2]) - origin)));
        if self.triangles[start..].iter().map(volume).sum::<f32>() < 0.0 {
            self.triangles[start..].iter_mut().for_each(|t| t.swap(1, 2));
        }
    }

    /// A box between two corners.
    pub fn block(&mut self, low: P, high: P) {
        // Corner i has the high X, Y, Z if its bits 0, 1, 2 are set.
        const FACES: [[u32; 4]; 6] =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 1 { high[k] } else { low[k] });
        let corners: [P; 8] = std::array::from_fn(corner);
        let piece = self.open(corners.len(), 2 * FACES.len());
        self.vertices.extend(corners);
        for [a, b, c, d] in FACES.map(|face| face.map(|v| piece.0 + v)) {
            self.triangles.extend([[a, b, c], [a, c, d]]);
        }
        self.close(piece);
    }

    /// A surface over rings with equal numbers of points, closed at both ends.
    pub fn loft(&mut self, rings: &[Vec<P>]) {
        if let Some(n) = rings.first().map(Vec::len) {
            self.rings(&rings.concat(), n);
        }
    }

    /// A surface over rings of `n` points, stored one after the other, closed at both ends.
    fn rings(&mut self, points: &[P], n: usize) {
        if n < 3 || points.len() < 2 * n {
            return;
        }
        let (count, last) = (points.len() / n, points.len() - n);
        let middle = |ring: &[P]| P::from(ring.iter().fold(Vector3::zeros(), |s, &p| s + Vector3::from(p)) / n as f32);
        let centres = [middle(&points[..n]), middle(&points[last..])];
        let piece = self.open(points.len() + 2, 2 * n * count);
        self.vertices.extend_from_slice(points);
        self.vertices.extend(centres);
        self.skin(piece.0, n, (count, count - 1));
        let [south, north] = [0, 1].map(|k| piece.0 + (points.len() + k) as u32);
        let edges =
            |start: usize| (0..n).map(move |j| (piece.0 + (start + j) as u32, piece.0 + (start + (j + 1) % n) as u32));
        self.triangles.extend(edges(0).map(|(p, q)| [south, q, p]));
        self.triangles.extend(edges(last).map(|(p, q)| [north, p, q]));
        self.close(piece);
    }

    /// Triangles between `pairs` pairs of neighbouring rings of `n` points, for `count` rings that
    /// start at the point `first`.
    fn skin(&mut self, first: u32, n: usize, (count, pairs): (usize, usize)) {
        for i in 0..pairs {
            let [here, next] = [i, (i + 1) % count].map(|ring| first + (ring * n) as u32);
            for j in 0..n as u32 {
                let k = if j + 1 == n as u32 { 0 } else { j + 1 };
                let [a, b, c, d] = [here + j, here + k, next + k, next + j];
                self.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }

    /// A surface over rings whose last one is joined to the first.
    pub fn torus(&mut self, rings: &[Vec<P>]) {
        if let Some(n) = rings.first().map(Vec::len) {
            self.chain(&rings.concat(), n);
        }
    }

    /// A surface over rings of `n` points, stored one after the other, whose last one is joined to
    /// the first.
    fn chain(&mut self, points: &[P], n: usize) {
        if n > 2 && points.len() > 2 * n {
            let count = points.len() / n;
            let piece = self.open(points.len(), 2 * n * count);
            self.vertices.extend_from_slice(points);
            self.skin(piece.0, n, (count, count));
            self.close(piece);
        }
    }

    /// A round tube along points, with perpendicular ends.
    pub fn tube(&mut self, points: &[P], radius: f32) {
        self.tapered(points, |_| radius);
    }

    /// A round tube whose radius changes from its start (0) to its end (1).
    pub fn tapered(&mut self, points: &[P], radius: impl Fn(f32) -> f32) {
        let (points, sides) = sections(points, false, radius);
        self.rings(&points, sides);
    }

    /// A closed round tube; the points do not repeat the first.
    pub fn hoop(&mut self, points: &[P], radius: f32) {
        let (points, sides) = sections(points, true, |_| radius);
        self.chain(&points, sides);
    }

    /// A leaf or strip along a spine: `width` is its half width from stem to tip, `lift` the amount
    /// by which its edges bend up.
    pub fn leaf(&mut self, spine: &[P], width: impl Fn(f32) -> f32, lift: f32) {
        let last = spine.len().saturating_sub(1).max(1);
        let points: Vec<P> = (0..spine.len())
            .flat_map(|i| {
                let (back, ahead) = (spine[i.saturating_sub(1)], spine[(i + 1).min(spine.len() - 1)]);
                let way = Vector3::from(ahead) - Vector3::from(back);
                let side = way.cross(&Vector3::z()).try_normalize(1e-6).unwrap_or_else(Vector3::y);
                let up = side.cross(&way).try_normalize(1e-9).unwrap_or_else(Vector3::z);
                let half = width(i as f32 / last as f32);
                let thick = (half * 0.06).max(2e-4);
                let p = Vector3::from(spine[i]);
                let edge = up * (half * lift);
                [p + side * half + edge, p + up * thick, p - side * half + edge, p - up * thick].map(P::from)
            })
            .collect();
        self.rings(&points, 4);
    }

    /// A sheet of (top, bottom) points over the unit square, closed around its edge.
    pub fn sheet(&mut self, (nu, nv): (usize, usize), at: impl Fn(f32, f32) -> (P, P)) {
        let (nu, nv) = (nu.max(1), nv.max(1));
        let points = (0..=nu).flat_map(|i| (0..=nv).map(move |j| (i as f32 / nu as f32, j as f32 / nv as f32)));
        let (top, bottom): (Vec<P>, Vec<P>) = points.map(|(u, v)| at(u, v)).unzip();
        let under = top.len() as u32;
        let index = |i: usize, j: usize| (i * (nv + 1) + j) as u32;
        let mut triangles = Vec::with_capacity(4 * nu * nv + 4 * (nu + nv));
        for (i, j) in (0..nu).flat_map(|i| (0..nv).map(move |j| (i, j))) {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            // The diagonal runs towards the nearest corner, where cushions are flat.
            let halves = if (2 * i < nu) == (2 * j < nv) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            triangles.extend(halves);
            triangles.extend(halves.map(|[p, q, r]| [p, r, q].map(|v| v + under)));
        }
        let mut wall = |a: u32, b: u32| triangles.extend([[b, a, a + under], [b, a + under, b + under]]);
        (0..nu).for_each(|i| wall(index(i, 0), index(i + 1, 0)));
        (0..nu).for_each(|i| wall(index(i + 1, nv), index(i, nv)));
        (0..nv).for_each(|j| wall(index(nu, j), index(nu, j + 1)));
        (0..nv).for_each(|j| wall(index(0, j + 1), index(0, j)));
        let piece = self.open(2 * top.len(), triangles.len());
        self.vertices.extend(top);
        self.vertices.extend(bottom);
        self.triangles.extend(triangles.iter().map(|t| t.map(|v| piece.0 + v)));
        self.close(piece);
    }

    /// A cushion: bulging in the centre, thin at its edges, which are drawn inwards by `pinch`
    /// between the corners.
    pub fn cushion(&mut self, at: P, half: P, pinch: f32) {
        let bulge = |t: f32| (1.0 - t * t).max(0.0);
        self.sheet((10, 10), |u, v| {
            let (u, v) = (ease(u), ease(v));
            let x = at[0] + half[0] * u * (1.0 - pinch * bulge(v));
            let y = at[1] + half[1] * v * (1.0 - pinch * bulge(u));
            let z = half[2] * (bulge(u) * bulge(v)).sqrt();
            ([x, y, at[2] + z], [x, y, at[2] - z])
        });
    }

    /// A sphere or ellipsoid with few triangles.
    pub fn egg(&mut self, at: P, half: P) {
        let rings: Vec<Vec<P>> = (0..=6)
            .map(|i| {
                let (s, c) = (std::f32::consts::PI * i as f32 / 6.0).sine_cosine();
                let s = if i % 6 == 0 { 0.0 } else { s };
                oval(Axis::Z, [at[0], at[1], at[2] - half[2] * c], (half[0] * s, half[1] * s), 0, 8)
            })
            .collect();
        self.loft(&rings);
    }
}

/// Maps the unit interval to -1..1, denser at the ends.
fn ease(t: f32) -> f32 {
    let t = 2.0 * t - 1.0;
    t * (1.5 - 0.5 * t * t)
}

/// The twist-free rings of a tube along points, stored one after the other, and the number of
/// points of each ring.
fn sections(points: &[P], closed: bool, radius: impl Fn(f32) -> f32) -> (Vec<P>, usize) {
    let count = points.len();
    let at = |i: usize| Vector3::from(points[i]);
    let last = count.saturating_sub(1);
    let neighbours = |i: usize| match (i, closed) {
        (0, true) => (last, 1 % count),
        (0, false) => (0, 1.min(last)),
        _ if i == last => (last - 1, if closed { 0 } else { last }),
        _ => (i - 1, i + 1),
    };
    let sides = if radius(0.5) < 0.008 { 6 } else { 8 };
    let mut normal: Vector3<f32> = Vector3::zeros();
    let mut rings = Vec::with_capacity(count * sides);
    for i in 0..count {
        let (back, ahead) = neighbours(i);
        let way = (at(ahead) - at(back)).try_normalize(1e-9).unwrap_or_else(Vector3::z);
        let kept = normal - way * normal.dot(&way);
        let start = if way.z.abs() < 0.7 { Vector3::z() } else { Vector3::x() };
        let fresh = || (start - way * start.dot(&way)).normalize();
        normal = kept.try_normalize(1e-3).unwrap_or_else(fresh);
        let other = way.cross(&normal);
        let r = radius(i as f32 / last.max(1) as f32);
        rings.extend((0..sides).map(|k| {
            let (s, c) = circle::part(k, sides);
            P::from(at(i) + (normal * c + other * s) * r)
        }));
    }
    (rings, sides)
}

/// One loft as one part.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::POTTERY;
/// use vc_shapes::solid::{level_oval, loft};
/// let rings = [(0.0, 0.1), (0.2, 0.15), (0.3, 0.05)].map(|(z, r)| level_oval([0.0, 0.0, z], (r, r)));
/// loft(&mut b, "pot", &rings, POTTERY);
/// assert!((b.finish().1.size().z - 0.3).abs() < 1e-3);
/// ```
pub fn loft(b: &mut Build<'_>, name: &str, rings: &[Vec<P>], mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    shell.loft(rings);
    shell.put(b, name, mat);
}

/// One tube as one part.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::STEEL;
/// use vc_shapes::solid::{spline, tube};
/// let path = spline(&[[0.0; 3], [0.0, 0.2, 0.1], [0.0, 0.4, 0.0]], 5);
/// tube(&mut b, "hose", &path, 0.01, STEEL);
/// assert_eq!(b.finish().0.parts.len(), 1);
/// ```
pub fn tube(b: &mut Build<'_>, name: &str, points: &[P], radius: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    shell.tube(points, radius);
    shell.put(b, name, mat);
}

/// One closed ring of round section as one part.
pub fn hoop(b: &mut Build<'_>, name: &str, points: &[P], radius: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    shell.hoop(points, radius);
    shell.put(b, name, mat);
}

/// Boxes as one part.
pub fn blocks(b: &mut Build<'_>, name: &str, boxes: &[(P, P)], mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    boxes.iter().for_each(|&(low, high)| shell.block(low, high));
    shell.put(b, name, mat);
}

/// One cushion as one part.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::WHITE;
/// use vc_shapes::solid::cushion;
/// cushion(&mut b, "pillow", [0.0, 0.0, 0.08], [0.2, 0.3, 0.08], 0.05, WHITE);
/// assert!(b.finish().1.size().z <= 0.161);
/// ```
pub fn cushion(b: &mut Build<'_>, name: &str, at: P, half: P, pinch: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    shell.cushion(at, half, pinch);
    shell.put(b, name, mat);
}

/// One sheet as one part.
pub fn sheet(b: &mut Build<'_>, name: &str, grid: (usize, usize), at: impl Fn(f32, f32) -> (P, P), mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    shell.sheet(grid, at);
    shell.put(b, name, mat);
}
