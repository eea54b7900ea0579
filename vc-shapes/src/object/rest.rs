//! Settling: an object built roughly in its lying pose is rotated until it lies as it would fall,
//! with its centre of mass above the points that touch the ground.

use std::sync::LazyLock;

use nalgebra::{Isometry3, Point3, Quaternion, UnitQuaternion, Vector2, Vector3};
use vc_graph::asset::{Joint, JointKind, Part, Shape};
use vc_graph::portable::Portable;
use vc_graph::{Asset, Pose};

use crate::solid::Build;
use crate::solid::circle;

/// The greatest number of turns: round objects roll in many.
const STEPS: usize = 120;

/// The number of directions in which it may fall.
const WAYS: usize = 64;

/// Generates an object and lets it settle; if it then exceeds its size, it is generated smaller.
///
/// ```
/// use vc_graph::{ClassTable, Seed};
/// use vc_shapes::object::settled;
/// use vc_shapes::{Build, Generator, Generators, Realm, Style, material::OAK};
///
/// fn leaning(b: &mut Build<'_>) {
///     let (from, to) = ([0.0; 3], [b.size.x / 2.0, 0.0, b.size.z]);
///     b.rod("staff", from, to, 0.01, OAK);
/// }
///
/// let row = "staff | sports_gear | | sport | graspable | 0.9 0.1 0.9 | 1 | | | garage:1";
/// let classes = ClassTable::builtin().extended("mine.txt", row)?;
/// let mut generators = Generators::default();
/// generators.register(&classes, Generator::new("staff", Realm::Indoor, 1, |b| settled(b, leaning)))?;
/// let staff = generators.get("staff").ok_or("not registered")?.object(&Style::from_seed(Seed(1)), Seed(1));
/// assert!(staff.size().z < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn settled(b: &mut Build<'_>, make: fn(&mut Build<'_>)) {
    const TRIES: usize = 6;
    let (room, rng) = (b.size, b.rng.clone());
    for attempt in 1..TRIES {
        make(b);
        settle(b.asset());
        let over = extent(b.asset()).component_div(&room).map(|k| k.max(1.0));
        if over.add_scalar(-1.0).component_mul(&room).max() < 5e-4 {
            return;
        }
        b.clear();
        // An object that falls differently each time is finally made smaller as a whole.
        let over = if attempt < TRIES / 2 { over } else { Vector3::repeat(over.max()) };
        (b.size, b.rng) = (b.size.component_div(&over), rng.clone());
    }
    make(b);
    settle(b.asset());
}

/// The depth, width and height of all parts.
fn extent(asset: &Asset) -> Vector3<f32> {
    let both = asset.parts.iter().map(Part::extent).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    both.map_or_else(Vector3::zeros, |(low, high)| high - low)
}

/// Lets an asset settle on the ground below it.
fn settle(asset: &mut Asset) {
    let mut body = Body::new(asset);
    let mut turned = Pose::identity();
    for _ in 0..STEPS {
        let Some(fall) = body.fall() else { break };
        body.corners.iter_mut().for_each(|p| *p = fall * *p);
        body.middle = fall * body.middle;
        turned = fall * turned;
    }
    if turned == Pose::identity() {
        return;
    }
    for part in asset.parts.iter_mut().chain(&mut asset.collision) {
        part.pose = turned * part.pose;
        turn_joint(&mut part.joint, &turned);
    }
    for surface in &mut asset.surfaces {
        surface.centre = turned * surface.centre;
        turn_joint(&mut surface.joint, &turned);
    }
}

fn turn_joint(joint: &mut Option<Joint>, turned: &Pose) {
    if let Some(joint) = joint {
        joint.axis = turned * joint.axis;
        if joint.kind == JointKind::Hinge {
            joint.anchor = turned * joint.anchor;
        }
    }
}

/// The direction in which points extend least, and their extent in it.
fn least_reach(points: &[Vector2<f32>]) -> (Vector2<f32>, f32) {
    static TURNS: LazyLock<[(f32, f32); WAYS]> = LazyLock::new(|| std::array::from_fn(|i| circle::part(i, WAYS)));
    let (sines, cosines) = (TURNS.map(|t| t.0), TURNS.map(|t| t.1));
    let mut reach = [f32::NEG_INFINITY; WAYS];
    for p in points {
        // All directions at once, vectorised.
        for i in 0..WAYS {
            let along = p.x * cosines[i] + p.y * sines[i];
            reach[i] = if along > reach[i] { along } else { reach[i] };
        }
    }
    let least = (0..WAYS).min_by(|&a, &b| reach[a].total_cmp(&reach[b])).unwrap_or(0);
    (Vector2::new(cosines[least], sines[least]), reach[least])
}

/// An asset as the corners that can touch the ground, and its centre of mass.
struct Body {
    corners: Vec<Point3<f32>>,
    middle: Point3<f32>,
    /// The distance from the ground within which a corner touches it.
    slack: f32,
}

impl Body {
    fn new(asset: &Asset) -> Self {
        let size = extent(asset).max();
        let (mut corners, mut sum, mut all) = (Vec::new(), Vector3::zeros(), 0.0);
        for part in &asset.parts {
            let from = corners.len();
            let mut add = |positions: &[Point3<f32>], triangles: &[[u32; 3]]| {
                corners.extend(positions.iter().map(|p| part.pose * p));
                for [a, b, c] in triangles.iter().map(|t| t.map(|v| corners[from + v as usize].coords)) {
                    let volume = a.dot(&b.cross(&c));
                    sum += (a + b + c) / 4.0 * volume;
                    all += volume;
                }
            };
            match &part.shape {
                Shape::Mesh { vertices, triangles, .. } => add(vertices, triangles),
                shape => {
                    let mesh = shape.mesh((size * 0.004).max(1e-5));
                    add(&mesh.positions, &mesh.triangles);
                }
            }
        }
        let middle = if all > 0.0 { Point3::from(sum / all) } else { Point3::origin() };
        Self { corners, middle, slack: (size * 0.008).clamp(2e-4, 2e-3) }
    }

    /// The rotation by which it falls until another point touches the ground; `None` if it rests.
    fn fall(&self) -> Option<Pose> {
        let low = self.corners.iter().map(|p| p.z).fold(f32::INFINITY, f32::min);
        let aside = |p: &Point3<f32>| p.xy() - self.middle.xy();
        let feet: Vec<Vector2<f32>> = self.corners.iter().filter(|p| p.z <= low + self.slack).map(aside).collect();
        let (way, edge) = least_reach(&feet);
        if edge >= 0.0 {
            return None;
        }
        // The point with the least slope is the first to touch the ground.
        let slope = |p: &Point3<f32>| {
            let (out, up) = (aside(p).dot(&way) - edge, p.z - low);
            (out > 0.0 && up > self.slack).then(|| up / out)
        };
        let angle = self.corners.iter().filter_map(slope).min_by(f32::total_cmp)?.angle_to(1.0);
        let (s, c) = (angle * 0.5).sine_cosine();
        let turn = UnitQuaternion::new_normalize(Quaternion::new(c, -way.y * s, way.x * s, 0.0));
        let pivot = Point3::new(self.middle.x + way.x * edge, self.middle.y + way.y * edge, low);
        Some(Isometry3::rotation_wrt_point(turn, pivot))
    }
}
