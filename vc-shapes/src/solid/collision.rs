//! Simplified collision shapes: a small object that holds no others is a single convex body for physics,
//! however many buttons and seams are visible on it, and so is an object that hangs flat on a wall.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Joint, Part, Shape};
use vc_graph::{Asset, Pose};

use super::flush::{Corners, extent};
use crate::facts::ClassFacts;

/// The number of costly parts from which a hull pays off.
const PARTS: usize = 2;
/// The number of corners up to which an outline is decomposed into few pieces.
const CORNERS: usize = 16;
/// The greatest side of a hand-held object, metres.
const SMALL: f32 = 1.4;
/// The distance from the lowest and the highest point within which a corner belongs to the base or the top,
/// metres.
const LEVEL: f32 = 0.002;
/// The greatest distance between a curved surface and its polygonal approximation, metres.
const COARSE: f32 = 0.002;
/// The number of sample points along each axis in the test whether a box is filled.
const PLACES: u8 = 4;
/// The percentage of sample points inside a part at which the object counts as filling its box.
const FULL: usize = 75;

/// The tolerance, relative to the radius, for parts that protrude from a sphere and for the roundness of the
/// whole.
const ROUND: f32 = 0.08;

/// Gives an asset of such a class one collision shape for all parts that move together, where that is simpler
/// than the parts.
pub(super) fn simplify(class: &ClassFacts, asset: &mut Asset, size: Vector3<f32>) {
    let flat = class.is_flat();
    let small = size.max() <= SMALL && asset.surfaces.is_empty();
    if !asset.collision.is_empty() {
        return;
    }
    if let Some(ball) = ball(&asset.parts) {
        asset.collision = vec![ball];
        return;
    }
    if !(flat || small && class.is_only_carried()) {
        return;
    }
    let mut joints: Vec<Option<Joint>> = Vec::new();
    asset.parts.iter().for_each(|p| joints.extend((!joints.contains(&p.joint)).then_some(p.joint)));
    let links = joints.iter().map(|&joint| Link::new(&asset.parts, joint));
    let pieces: Vec<Option<Shaped>> = links.map(|link| link.piece(flat)).collect();
    if pieces.iter().all(Option::is_none) {
        return;
    }
    let own = |joint: Option<Joint>| asset.parts.iter().filter(move |p| p.joint == joint);
    let felt = joints.iter().zip(pieces).flat_map(|(&joint, piece)| match piece {
        Some((shape, pose)) => {
            let material = own(joint).next().map_or(0, |p| p.material);
            vec![Part { name: "lump".into(), shape, material, pose, joint }]
        }
        None => own(joint).cloned().collect(),
    });
    asset.collision = felt.collect();
}

/// The single sphere that the parts form: one of them is a sphere, the others are seams, patches and stripes
/// on it. A hull in its place would roll no farther than from one face to the next.
fn ball(parts: &[Part]) -> Option<Part> {
    let all: Vec<&Part> = parts.iter().collect();
    let (low, high) = extent(&all).filter(|_| all.len() > 1 && all.iter().all(|p| p.joint.is_none()))?;
    let (middle, half) = (nalgebra::center(&low, &high), (high - low) / 2.0);
    let slack = ROUND * half.max();
    let is_core = |part: &&Part| {
        let Shape::Sphere { radius } = part.shape else { return false };
        let aside = (part.pose.translation.vector - middle.coords).norm();
        aside <= slack && radius >= half.max() - slack && half.max() - half.min() <= slack
    };
    let core = parts.iter().find(is_core)?;
    let radius = half.min();
    let pose = Pose::translation(middle.x, middle.y, low.z + radius);
    Some(Part { name: "lump".into(), shape: Shape::Sphere { radius }, pose, ..core.clone() })
}

/// A shape and its pose in the asset's frame.
type Shaped = (Shape, Pose);

/// The parts that move together.
struct Link<'a> {
    parts: Vec<&'a Part>,
}

impl<'a> Link<'a> {
    fn new(parts: &'a [Part], joint: Option<Joint>) -> Self {
        Self { parts: parts.iter().filter(|p| p.joint == joint).collect() }
    }

    /// The single shape that replaces them: their bounding box if they fill it or are flat, the hull if
    /// several are costly.
    fn piece(&self, flat: bool) -> Option<Shaped> {
        if self.parts.len() < 2 {
            return None;
        }
        if flat || self.parts.iter().any(|p| is_upright_box(p)) {
            let (low, high) = extent(&self.parts)?;
            if flat || self.fills(low, high) {
                let pose = Pose::from_parts(nalgebra::center(&low, &high).into(), UnitQuaternion::identity());
                return Some((Shape::Box { half: (high - low) / 2.0 }, pose));
            }
        }
        if self.parts.iter().filter(|p| is_costly(p)).count() < PARTS {
            return None;
        }
        Some((Shape::Hull { points: outermost(&self.parts) }, Pose::identity()))
    }

    /// Whether parts that are boxes fill the bounding box of all.
    fn fills(&self, low: Point3<f32>, high: Point3<f32>) -> bool {
        let boxes: Vec<_> = self.parts.iter().filter(|p| is_upright_box(p)).map(|p| p.extent()).collect();
        let place = |i: u8| (f32::from(i) + 0.5) / f32::from(PLACES);
        let all = || (0..PLACES).map(place);
        let places = all().flat_map(|x| all().flat_map(move |y| all().map(move |z| Vector3::new(x, y, z))));
        let full = places.filter(|at| {
            let at = low + (high - low).component_mul(at);
            boxes.iter().any(|(least, most)| (0..3).all(|k| least[k] <= at[k] && at[k] <= most[k]))
        });
        full.count() * 100 >= usize::from(PLACES).pow(3) * FULL
    }
}

fn is_upright_box(part: &Part) -> bool {
    let is_box = matches!(part.shape, Shape::Box { .. } | Shape::RoundedBox { .. });
    is_box && part.pose.rotation == UnitQuaternion::identity()
}

/// Whether it needs convex hulls, or decomposition into many pieces.
fn is_costly(part: &Part) -> bool {
    match &part.shape {
        Shape::Mesh { .. } | Shape::Hull { .. } => true,
        Shape::Extrusion { outline, .. } => outline.len() > CORNERS,
        _ => false,
    }
}

/// Points stored axis by axis, so that several can be processed at once.
#[derive(Default)]
struct Points([Vec<f32>; 3]);

impl Points {
    /// Points of a part's surface in the asset's frame, including the outermost ones.
    fn of(part: &Part) -> Self {
        match &part.shape {
            Shape::Mesh { vertices: all, .. } | Shape::Hull { points: all } => Self::posed(part, all),
            round => Self::posed(part, &round.mesh(COARSE).positions),
        }
    }

    fn posed(part: &Part, all: &[Point3<f32>]) -> Self {
        let (turn, shift) = (part.pose.rotation, part.pose.translation.vector);
        // Most parts are not turned.
        if turn == UnitQuaternion::identity() {
            return Self([0, 1, 2].map(|axis| all.iter().map(|point| point[axis] + shift[axis]).collect()));
        }
        let mut points = Self([0, 1, 2].map(|_| Vec::with_capacity(all.len())));
        all.iter().for_each(|point| points.push(part.pose * point));
        points
    }

    fn push(&mut self, point: Point3<f32>) {
        self.0.iter_mut().zip(point.iter()).for_each(|(axis, v)| axis.push(*v));
    }

    fn at(&self, i: usize) -> Point3<f32> {
        Point3::from(self.0.each_ref().map(|axis| axis[i]))
    }

    /// How far the farthest point in a direction is.
    fn reach(&self, way: &Vector3<f32>) -> f32 {
        const LANES: usize = 8;
        let [x, y, z] = self.0.each_ref().map(Vec::as_slice);
        let far = |i: usize| x[i] * way.x + y[i] * way.y + z[i] * way.z;
        let more = |a: f32, b: f32| if b > a { b } else { a };
        let mut most = [f32::NEG_INFINITY; LANES];
        let (xs, ys, zs) = (x.chunks_exact(LANES), y.chunks_exact(LANES), z.chunks_exact(LANES));
        for ((x, y), z) in xs.zip(ys).zip(zs) {
            for k in 0..LANES {
                most[k] = more(most[k], x[k] * way.x + y[k] * way.y + z[k] * way.z);
            }
        }
        let rest = (x.len() / LANES * LANES..x.len()).map(far);
        most.into_iter().chain(rest).fold(f32::NEG_INFINITY, more)
    }

    /// The first of the points that are that far in a direction.
    fn first(&self, way: &Vector3<f32>, reach: f32) -> Option<Point3<f32>> {
        let [x, y, z] = self.0.each_ref().map(Vec::as_slice);
        let far = |i: usize| x[i] * way.x + y[i] * way.y + z[i] * way.z;
        (0..x.len()).find(|&i| far(i) == reach).map(|i| self.at(i))
    }

    /// The least and the greatest height.
    fn heights(&self) -> [f32; 2] {
        let [low, high] = [-1.0, 1.0].map(|up| self.0[2].iter().map(|z| up * z).fold(f32::NEG_INFINITY, f32::max));
        [-low, high]
    }
}

/// The horizontal ways along the axes and their diagonals.
fn around() -> [Vector3<f32>; 8] {
    let ways = [(-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)];
    ways.map(|(x, y)| Vector3::new(x as f32, y as f32, 0.0))
}

/// The points of parts farthest along the axes and their diagonals, and those around a level base and a level top.
///
/// The largest parts come first: the points of one that lies within what is reached so far are not made.
fn outermost(parts: &[&Part]) -> Vec<Point3<f32>> {
    let slanted = around().into_iter().flat_map(|way| [-1.0, 1.0].map(|z| way + Vector3::z() * z));
    let ways: Vec<Vector3<f32>> = around().into_iter().chain(slanted.filter(|way| way.x * way.y != 0.0)).collect();
    let boxes: Vec<Corners> = parts.iter().filter_map(|part| extent(&[*part])).collect();
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| (boxes[b].1 - boxes[b].0).norm().total_cmp(&(boxes[a].1 - boxes[a].0).norm()));
    let mut reached = Reached { far: vec![f32::NEG_INFINITY; ways.len()], heights: [f32::INFINITY, f32::NEG_INFINITY] };
    let mut outer: Vec<Outer> = Vec::with_capacity(boxes.len());
    for index in order {
        if !reached.holds(&ways, &boxes[index]) {
            let points = Points::of(parts[index]);
            let far = reached.add(&ways, &points);
            outer.push(Outer { index, points, far });
        }
    }
    // Of points equally far that of the first part counts.
    outer.sort_unstable_by_key(|part| part.index);
    let first = |(k, far)| outer.iter().find(|part| part.far[k] == far)?.points.first(&ways[k], far);
    let mut found: Vec<Point3<f32>> = reached.far.iter().copied().enumerate().filter_map(first).collect();
    for (up, height) in [-1.0, 1.0].into_iter().zip(reached.heights) {
        let mut level = Points::default();
        for Outer { points, .. } in &outer {
            let heights = points.0[2].iter().enumerate();
            let near = heights.filter(|(_, z)| up * **z > up * height - LEVEL).map(|(i, _)| points.at(i));
            near.for_each(|p| level.push(Point3::new(p.x, p.y, height)));
        }
        found.extend(around().iter().filter_map(|way| level.first(way, level.reach(way))));
    }
    found.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    found.dedup();
    found
}

/// A part that may be outermost somewhere: its place in the list, its points, and how far it reaches along each way.
struct Outer {
    index: usize,
    points: Points,
    far: Vec<f32>,
}

/// How far some parts reach: along each way, and down and up.
struct Reached {
    far: Vec<f32>,
    heights: [f32; 2],
}

impl Reached {
    /// Whether a part in a box adds nothing.
    fn holds(&self, ways: &[Vector3<f32>], (low, high): &Corners) -> bool {
        /// What rounding may add, metres.
        const SLACK: f32 = 1e-5;
        let (middle, half) = (nalgebra::center(low, high).coords, (high - low) / 2.0);
        let level = low.z > self.heights[0] + LEVEL + SLACK && high.z < self.heights[1] - LEVEL - SLACK;
        let within = |(way, far): (&Vector3<f32>, &f32)| middle.dot(way) + half.dot(&way.abs()) < far - SLACK;
        level && ways.iter().zip(&self.far).all(within)
    }

    /// Adds a part; returns how far it reaches along each way.
    fn add(&mut self, ways: &[Vector3<f32>], points: &Points) -> Vec<f32> {
        let own: Vec<f32> = ways.iter().map(|way| points.reach(way)).collect();
        self.far.iter_mut().zip(&own).for_each(|(far, own)| *far = far.max(*own));
        if !points.0[0].is_empty() {
            let [low, high] = points.heights();
            self.heights = [self.heights[0].min(low), self.heights[1].max(high)];
        }
        own
    }
}
