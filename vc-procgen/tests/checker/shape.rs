//! The depth of a point inside a shape: exact for each kind, in double precision.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Shape;

pub(crate) type P = Point3<f64>;
pub(crate) type V = Vector3<f64>;
type Flat = (f64, f64);

/// The greatest distance of a curve from its chords, metres.
const TOLERANCE: f32 = 0.001;

/// A shape prepared for queries, in its own frame.
pub(crate) struct Form {
    kind: Kind,
    pub(crate) points: Vec<P>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

enum Kind {
    Rounded {
        half: V,
        radius: f64,
    },
    Cylinder {
        radius: f64,
        half: f64,
    },
    Cone {
        radius: f64,
        half: f64,
    },
    Capsule {
        radius: f64,
        half: f64,
    },
    /// Outward planes: normal and distance from the origin.
    Hull(Vec<(V, f64)>),
    /// The edges of the profile including those on the axis, and those that are part of the
    /// surface.
    Lathe {
        ring: Vec<Flat>,
    },
    Extrusion {
        outline: Vec<Flat>,
        height: f64,
    },
    Mesh(Vec<[P; 3]>),
}

impl Form {
    pub(crate) fn new(shape: &Shape) -> Self {
        let mesh = shape.mesh(TOLERANCE);
        let points: Vec<P> = mesh.positions.iter().map(|p| p.cast()).collect();
        let kind = kind(shape, &points, &mesh.triangles);
        Self { kind, points, triangles: mesh.triangles }
    }

    /// The distance to the surface from inside, metres; not positive outside.
    pub(crate) fn depth(&self, p: &P) -> f64 {
        let rho = p.x.hypot(p.y);
        match &self.kind {
            Kind::Rounded { half, radius } => {
                let q = p.coords.abs() - half.add_scalar(-radius);
                radius - q.sup(&V::zeros()).norm() - q.max().min(0.0)
            }
            Kind::Cylinder { radius, half } => (radius - rho).min(half - p.z.abs()),
            Kind::Cone { radius, half } => {
                let slope = radius / (2.0 * half);
                let side = ((half - p.z) * slope - rho) / (1.0 + slope * slope).sqrt();
                side.min(p.z + half)
            }
            Kind::Capsule { radius, half } => radius - rho.hypot((p.z.abs() - half).max(0.0)),
            Kind::Hull(planes) => planes.iter().map(|(n, d)| d - n.dot(&p.coords)).fold(f64::INFINITY, f64::min),
            Kind::Lathe { ring } => signed(ring, (rho, p.z), true),
            Kind::Extrusion { outline, height } => {
                let ends = p.z.min(height - p.z);
                if ends <= 0.0 { ends } else { ends.min(signed(outline, (p.x, p.y), false)) }
            }
            Kind::Mesh(faces) => in_mesh(faces, p),
        }
    }
}

fn kind(shape: &Shape, points: &[P], triangles: &[[u32; 3]]) -> Kind {
    let flat = |list: &[(f32, f32)]| -> Vec<Flat> { list.iter().map(|p| (p.0.into(), p.1.into())).collect() };
    let faces = || triangles.iter().map(|t| t.map(|v| points[v as usize])).collect::<Vec<_>>();
    match shape {
        Shape::Box { half } => Kind::Rounded { half: half.cast(), radius: 0.0 },
        Shape::RoundedBox { half, radius } => Kind::Rounded { half: half.cast(), radius: (*radius).into() },
        Shape::Cylinder { radius, half_height } => {
            Kind::Cylinder { radius: (*radius).into(), half: (*half_height).into() }
        }
        Shape::Cone { radius, half_height } => Kind::Cone { radius: (*radius).into(), half: (*half_height).into() },
        Shape::Capsule { radius, half_height } => {
            Kind::Capsule { radius: (*radius).into(), half: (*half_height).into() }
        }
        Shape::Sphere { radius } => Kind::Capsule { radius: (*radius).into(), half: 0.0 },
        Shape::Hull { .. } => Kind::Hull(faces().iter().filter_map(plane).collect()),
        Shape::Lathe { profile } => Kind::Lathe { ring: ring(flat(profile)) },
        Shape::Extrusion { outline, height } => Kind::Extrusion { outline: flat(outline), height: (*height).into() },
        _ => Kind::Mesh(faces()),
    }
}

/// A profile closed along the axis, unless it is closed by itself.
fn ring(mut profile: Vec<Flat>) -> Vec<Flat> {
    let (first, last) = (profile[0], profile[profile.len() - 1]);
    if first != last {
        profile.extend([(0.0, last.1), (0.0, first.1)]);
    }
    profile
}

fn plane(t: &[P; 3]) -> Option<(V, f64)> {
    let normal = (t[1] - t[0]).cross(&(t[2] - t[0])).try_normalize(1e-12)?;
    Some((normal, normal.dot(&t[0].coords)))
}

/// The distance to a polygon's boundary, negative outside; edges on the axis are not part of the
/// surface of a solid of revolution.
fn signed(polygon: &[Flat], p: Flat, turned: bool) -> f64 {
    let (mut inside, mut nearest) = (false, f64::INFINITY);
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        if (a.1 > p.1) != (b.1 > p.1) && p.0 < a.0 + (p.1 - a.1) / (b.1 - a.1) * (b.0 - a.0) {
            inside = !inside;
        }
        if !(turned && a.0 == 0.0 && b.0 == 0.0) {
            nearest = nearest.min(from_stretch(p, a, b));
        }
    }
    if inside { nearest } else { -nearest }
}

fn from_stretch(p: Flat, a: Flat, b: Flat) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let length = dx * dx + dy * dy;
    let share = if length > 0.0 { (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (p.0 - a.0 - share * dx).hypot(p.1 - a.1 - share * dy)
}

/// Tested by a ray that leaves more often than it enters, and by the nearest triangle.
fn in_mesh(faces: &[[P; 3]], p: &P) -> f64 {
    // A direction that is unlikely to lie in the plane of any face.
    let way = V::new(0.113_71, 0.071_93, 1.0);
    let crossings: i32 = faces.iter().filter_map(|t| hit(t, p, &way)).filter(|h| h.0 > 0.0).map(|h| h.1).sum();
    if crossings <= 0 {
        return -1.0;
    }
    faces.iter().map(|t| from_triangle(p, t)).fold(f64::INFINITY, f64::min)
}

/// The intersection of a ray and a triangle, in lengths of `way`, and 1 where the ray leaves the
/// solid or -1 where it enters (Möller and Trumbore 1997).
pub(crate) fn hit([a, b, c]: &[P; 3], from: &P, way: &V) -> Option<(f64, i32)> {
    let (ab, ac) = (b - a, c - a);
    let cross = way.cross(&ac);
    let turn = ab.dot(&cross);
    if turn.abs() < 1e-15 {
        return None;
    }
    let to = from - a;
    let u = to.dot(&cross) / turn;
    let other = to.cross(&ab);
    let v = way.dot(&other) / turn;
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    inside.then(|| (ac.dot(&other) / turn, if turn < 0.0 { 1 } else { -1 }))
}

/// The distance from a point to a triangle.
fn from_triangle(p: &P, t: &[P; 3]) -> f64 {
    let stretch = |a: &P, b: &P| {
        let way = b - a;
        let share = ((p - a).dot(&way) / way.norm_squared().max(1e-30)).clamp(0.0, 1.0);
        (p - a - way * share).norm()
    };
    let border = stretch(&t[0], &t[1]).min(stretch(&t[1], &t[2])).min(stretch(&t[2], &t[0]));
    let Some((normal, _)) = plane(t) else { return border };
    match hit(t, p, &normal) {
        Some((at, _)) => border.min(at.abs()),
        None => border,
    }
}
