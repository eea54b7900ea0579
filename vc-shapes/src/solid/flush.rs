//! Coplanar faces: a part that would share a plane with an earlier one is made slightly smaller on that side, as a
//! joiner sets a panel slightly behind its frame, so that it is never arbitrary which of the two is visible.

use nalgebra::{Matrix3, Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Part, Shape};
use vc_graph::{Asset, Pose};

/// The distance by which a part is set back, metres; a quarter of the asset's thickness if that is
/// less.
const HAIR: f32 = 4e-4;

/// The greatest number of sides set back for one part.
const TURNS: usize = 8;

/// Sets back parts that would share a plane; returns the asset's extent. O(n²) in the parts, but
/// almost every pair is decided by one test of two words.
pub(super) fn set_back(asset: &mut Asset) -> Option<Corners> {
    let mut boxes: Vec<Around> = asset.parts.iter().map(Around::new).collect();
    let mut corners: Vec<Corners> = asset.parts.iter().zip(&boxes).map(|(p, b)| b.corners(p)).collect();
    let (low, high) = around(&corners)?;
    let hair = HAIR.min((high - low).min() * 0.25);
    let cells = Cells::new((low, high), hair);
    let mut flat: Vec<(usize, u64)> = Vec::with_capacity(boxes.len());
    let mut near = Vec::new();
    for j in 0..asset.parts.len() {
        if !boxes[j].flat {
            continue;
        }
        // A part that is set back comes near no further parts.
        let own = cells.of_part(&corners[j]);
        near.clear();
        near.extend(flat.iter().filter(|(_, other)| Cells::share(own, *other)).map(|(i, _)| *i));
        flat.push((j, own));
        for _ in 0..TURNS {
            let still = near.iter().filter(|&&i| meet(&corners[i], &corners[j], hair));
            let flush = still.filter_map(|&i| boxes[j].flush(&boxes[i], hair * 0.75)).next();
            let Some((axis, high)) = flush else { break };
            if !set_back_side(&mut asset.parts[j], axis, high, hair) {
                break;
            }
            boxes[j] = Around::new(&asset.parts[j]);
            corners[j] = boxes[j].corners(&asset.parts[j]);
        }
    }
    around(&corners)
}

/// The bounding box of parts.
pub(super) fn extent(parts: &[&Part]) -> Option<Corners> {
    around(&parts.iter().map(|part| Around::new(part).corners(part)).collect::<Vec<_>>())
}

fn around(corners: &[Corners]) -> Option<Corners> {
    corners.iter().copied().reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
}

fn meet(a: &Corners, b: &Corners, same: f32) -> bool {
    // Without branches, because almost all pairs fail, each at another axis.
    (0..3).fold(true, |all, k| all & (a.0[k] <= b.1[k] + same) & (b.0[k] <= a.1[k] + same))
}

/// An asset's extent divided into cells along each axis: almost all pairs of parts are separated by
/// one word each.
struct Cells {
    low: Point3<f32>,
    /// The number of cells a metre.
    density: Vector3<f32>,
    hair: f32,
}

impl Cells {
    const COUNT: usize = 21;

    fn new((low, high): Corners, hair: f32) -> Self {
        let density = (high - low).map(|length| Self::COUNT as f32 / length.max(f32::MIN_POSITIVE));
        Self { low, density, hair }
    }

    /// The cells of a part including a small margin: one bit for each cell along X, Y and Z.
    fn of_part(&self, (low, high): &Corners) -> u64 {
        let cell = |v: f32, k: usize| (((v - self.low[k]) * self.density[k]) as usize).min(Self::COUNT - 1);
        (0..3).fold(0, |bits, k| {
            let (from, to) = (cell(low[k] - self.hair, k), cell(high[k] + self.hair, k));
            bits | ((2 << (to - from)) - 1) << (from + k * Self::COUNT)
        })
    }

    /// Whether two parts share a cell along every axis.
    fn share(a: u64, b: u64) -> bool {
        const AXIS: u64 = (1 << Cells::COUNT) - 1;
        let both = a & b;
        (0..3).all(|k| both & AXIS << (k * Self::COUNT) != 0)
    }
}

/// The smallest and largest corner.
pub(super) type Corners = (Point3<f32>, Point3<f32>);

/// The bounding box of a part in the part's own frame, and that frame.
struct Around {
    centre: Point3<f32>,
    half: Vector3<f32>,
    axes: Matrix3<f32>,
    pose: Pose,
    straight: bool,
    /// Whether it has flat sides: spheres and capsules have none.
    flat: bool,
}

impl Around {
    fn new(part: &Part) -> Self {
        let (least, most) = part.shape.extent();
        let (centre, half) = (nalgebra::center(&least, &most), (most - least) / 2.0);
        let straight = part.pose.rotation == UnitQuaternion::identity();
        let axes = if straight { Matrix3::identity() } else { part.pose.rotation.to_rotation_matrix().into_inner() };
        let flat = !matches!(part.shape, Shape::Sphere { .. } | Shape::Capsule { .. });
        Self { centre, half, axes, pose: part.pose, straight, flat }
    }

    /// The part's extent; for a part that is not rotated, without reading its points again.
    fn corners(&self, part: &Part) -> Corners {
        let middle = self.centre + self.pose.translation.vector;
        if self.straight { (middle - self.half, middle + self.half) } else { part.extent() }
    }

    /// Another box in this one's frame: the axes that are parallel to one of its own, its centre,
    /// and its half extents.
    fn own_frame(&self, other: &Self) -> ([bool; 3], Vector3<f32>, Vector3<f32>) {
        if self.straight && other.straight {
            let way = other.pose.translation.vector + other.centre.coords - self.pose.translation.vector;
            return ([true; 3], way - self.centre.coords, other.half);
        }
        let turn = self.axes.tr_mul(&other.axes);
        let middle = self.pose.inverse_transform_point(&(other.pose * other.centre)) - self.centre;
        let upright = [0, 1, 2].map(|k| turn.row(k).iter().any(|v| v.abs() > 0.9999));
        (upright, middle, turn.abs() * other.half)
    }

    /// A side of this box, as axis and whether it is the higher one, that lies in a plane with the
    /// same side of another box and overlaps it.
    fn flush(&self, other: &Self, same: f32) -> Option<(usize, bool)> {
        let (upright, middle, reach) = self.own_frame(other);
        (0..3).find_map(|k| {
            let beside = |m: usize| m != k && middle[m].abs() > self.half[m] + reach[m] - same;
            if !upright[k] || (0..3).any(beside) {
                return None;
            }
            let side = |sign: f32| (middle[k] * sign + reach[k] - self.half[k]).abs() <= same;
            if side(1.0) { Some((k, true)) } else { side(-1.0).then_some((k, false)) }
        })
    }
}

/// Moves one side of a part inwards by `by`, unless the part is too thin for that.
fn set_back_side(part: &mut Part, axis: usize, high: bool, by: f32) -> bool {
    let (least, most) = part.shape.extent();
    let length = most[axis] - least[axis];
    if length < 4.0 * by {
        return false;
    }
    let (fixed, scale) = (if high { least[axis] } else { most[axis] }, 1.0 - by / length);
    let shift = if high { -by / 2.0 } else { by / 2.0 };
    let scaled = |v: &mut f32| *v = fixed + (*v - fixed) * scale;
    let mut moved = Vector3::zeros();
    match &mut part.shape {
        Shape::Box { half } => {
            half[axis] -= by / 2.0;
            moved[axis] = shift;
        }
        Shape::RoundedBox { half, radius } => {
            half[axis] -= by / 2.0;
            *radius = radius.min(half[axis]);
            moved[axis] = shift;
        }
        Shape::Cylinder { radius, half_height } | Shape::Cone { radius, half_height } => {
            if axis == 2 {
                *half_height -= by / 2.0;
                moved.z = shift;
            } else {
                *radius -= by;
            }
        }
        Shape::Lathe { profile } if axis == 2 => profile.iter_mut().for_each(|p| scaled(&mut p.1)),
        Shape::Lathe { profile } => profile.iter_mut().for_each(|p| p.0 *= 1.0 - 2.0 * by / length),
        Shape::Extrusion { height, .. } if axis == 2 => {
            *height -= by;
            moved.z = if high { 0.0 } else { by };
        }
        Shape::Extrusion { outline, .. } => {
            outline.iter_mut().for_each(|p| scaled(if axis == 0 { &mut p.0 } else { &mut p.1 }));
        }
        Shape::Hull { points } | Shape::Mesh { vertices: points, .. } => {
            points.iter_mut().for_each(|p| scaled(&mut p[axis]));
        }
        _ => return false,
    }
    part.pose.translation.vector += part.pose.rotation * moved;
    true
}
