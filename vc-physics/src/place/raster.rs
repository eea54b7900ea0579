//! The spots that are tried on a surface.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Hold;
use vc_graph::portable::Portable;

use super::{GAP, SpotFault, SpotOrder, SupportSurface};

/// Distance of the spots that are tried on a surface, metres.
pub(super) const PITCH: f32 = 0.04;
/// Most spots tried along one side.
const MOST: usize = 24;

/// Half width of surfaces on which things are put in the middle, metres.
const BURNER: f32 = 0.13;

/// Whether a surface is so small that what is put on it goes to its middle.
pub(super) fn is_burner(shelf: &SupportSurface) -> bool {
    shelf.half.0.min(shelf.half.1) < BURNER && shelf.hold == Hold::On
}

/// The spots of a surface where a thing between two corners fits within edges and height, best
/// first: so far above it, with a part of its half width over the edges, and so far apart or farther.
pub(super) fn spots(
    (low, high): (Point3<f32>, Point3<f32>),
    shelf: &SupportSurface,
    turn: &UnitQuaternion<f32>,
    (above, over): (f32, f32),
    pitch: f32,
    order: SpotOrder,
) -> Vec<Pose> {
    let (half, base) = (half_sides((low, high), turn), above + GAP);
    let Ok(room) = fits((low, high), shelf, turn, (above, over)) else { return Vec::new() };
    if shelf.hold == Hold::Hook {
        return Vec::new();
    }
    let centre = turn * nalgebra::center(&low, &high).coords;
    let at = |(x, y): (f32, f32)| {
        let middle = Vector3::new(x, y, base + half.z);
        shelf.pose * Pose::from_parts((middle - centre).into(), *turn)
    };
    let raster: Vec<(f32, f32)> =
        steps(room.0, pitch).flat_map(|x| steps(room.1, pitch).map(move |y| (x, y))).collect();
    ordered(raster, shelf, order).into_iter().map(at).collect()
}

/// Half the sides of a surface's part over which the middle of a thing may be, so far above it and with a part of its
/// half width over the edges; or the reason why it fits nowhere on it.
pub(super) fn fits(
    extent: (Point3<f32>, Point3<f32>),
    shelf: &SupportSurface,
    turn: &UnitQuaternion<f32>,
    (above, over): (f32, f32),
) -> Result<(f32, f32), SpotFault> {
    let half = half_sides(extent, turn);
    let room = (shelf.half.0 - half.x * (1.0 - over), shelf.half.1 - half.y * (1.0 - over));
    if shelf.clearance.is_some_and(|clearance| 2.0 * half.z + (above + GAP) > clearance) {
        return Err(SpotFault::TooLow);
    }
    if room.0 >= 0.0 && room.1 >= 0.0 { Ok(room) } else { Err(SpotFault::Unsupported) }
}

/// Half the sides of the box around a box that is turned.
pub(super) fn half_sides((low, high): (Point3<f32>, Point3<f32>), turn: &UnitQuaternion<f32>) -> Vector3<f32> {
    turn.to_rotation_matrix().matrix().abs() * (high - low) / 2.0
}

/// Offsets from -room to room, a pitch apart or wider.
fn steps(room: f32, pitch: f32) -> impl Iterator<Item = f32> {
    let count = ((2.0 * room / pitch) as usize).min(MOST);
    (0..=count).map(move |i| if count == 0 { 0.0 } else { room * (2.0 * i as f32 / count as f32 - 1.0) })
}

fn ordered(mut raster: Vec<(f32, f32)>, shelf: &SupportSurface, order: SpotOrder) -> Vec<(f32, f32)> {
    let nearest = |to: (f32, f32)| {
        move |a: &(f32, f32), b: &(f32, f32)| {
            let far = |p: &(f32, f32)| (p.0 - to.0).raised(2) + (p.1 - to.1).raised(2);
            far(a).total_cmp(&far(b))
        }
    };
    match order {
        SpotOrder::Middle => raster.sort_by(nearest((0.0, 0.0))),
        SpotOrder::Near(point) => {
            let local = shelf.pose.inverse_transform_point(&point);
            raster.sort_by(nearest((local.x, local.y)));
        }
        SpotOrder::Random(seed) => seed.child("spot").stream().shuffle(&mut raster),
    }
    raster
}
