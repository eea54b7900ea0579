//! Forms: the engine's data about an asset.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, Part, Shape, Surface};
use vc_graph::class::Range;
use vc_graph::{Asset, AssetLibrary, Bounds, BoundsFrame, Pose};

use super::link::{Link, Making};
use super::piece::Piece;
use super::scale;
use crate::convert;

/// The engine's data about an asset at a scale.
pub(crate) struct Form {
    /// The rigid links; the first is the base, the others have joints.
    pub(crate) links: Vec<Link>,
    /// The scaled surfaces for placing things.
    pub(crate) surfaces: Vec<Surface>,
    /// Minimal and maximal corner of the collision shapes, with joints at zero.
    pub(crate) extent: (Point3<f32>, Point3<f32>),
}

/// The kind of form that an asset gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// One body.
    Rigid,
    /// A base, and parts that move on joints.
    Jointed,
    /// A part of the building. Its pieces are not merged, which would close its door and window openings.
    Building,
}

impl Form {
    pub(super) fn from_asset(asset: &Asset, library: &AssetLibrary, scale: &Vector3<f32>, kind: Kind) -> Self {
        let (moving, by) = (kind == Kind::Jointed, scale);
        let mut joints: Vec<Option<Joint>> = vec![None];
        for part in asset.parts.iter().chain(&asset.collision).filter(|p| moving && p.joint.is_some()) {
            if !joints.contains(&part.joint) {
                joints.push(part.joint);
            }
        }
        let surfaces: Vec<Surface> = asset.surfaces.iter().map(|s| scale::surface(s, scale)).collect();
        let mine = |part: &&Part, joint: &Option<Joint>| if moving { part.joint == *joint } else { true };
        let making = Making { library, by, surfaces: &surfaces, joins: kind != Kind::Building };
        let link = |joint: &Option<Joint>| {
            let parts: Vec<&Part> = asset.parts.iter().filter(|p| mine(p, joint)).collect();
            let given: Vec<&Part> = asset.collision.iter().filter(|p| mine(p, joint)).collect();
            let solid = if asset.collision.is_empty() { &parts } else { &given };
            let name = parts.first().map_or_else(|| "".into(), |p| p.name.clone());
            let joint = joint.as_ref().map(|j| scale::joint(j, scale));
            Link::new(name, joint, &parts, solid, &making)
        };
        Self::new(joints.iter().map(link).collect(), surfaces.clone())
    }

    /// The link that moves a surface; zero is the base.
    pub(crate) fn link_with(&self, surface: usize) -> Option<usize> {
        let joint = self.surfaces.get(surface)?.joint;
        self.links.iter().position(|link| link.joint == joint)
    }

    /// The form of a node that has only a box; hollow if it contains things.
    pub(super) fn from_box(bounds: &Bounds, pose: &Pose, hollow: bool) -> Self {
        let at = Pose::from_parts(bounds.offset.into(), nalgebra::UnitQuaternion::identity());
        let at = match bounds.frame {
            BoundsFrame::Object => at,
            BoundsFrame::World => Pose::from_parts(nalgebra::Translation3::identity(), pose.rotation.inverse()) * at,
        };
        let half = bounds.half.map(|h| h.abs().max(0.001));
        let walls = if hollow { shell(half) } else { vec![(Vector3::zeros(), half)] };
        let part = |(offset, half): (Vector3<f32>, Vector3<f32>)| Part {
            name: "box".into(),
            shape: Shape::Box { half },
            material: u32::MAX,
            pose: at * Pose::translation(offset.x, offset.y, offset.z),
            joint: None,
        };
        let parts: Vec<Part> = walls.into_iter().map(part).collect();
        let parts: Vec<&Part> = parts.iter().collect();
        let library = AssetLibrary::default();
        let making = Making { library: &library, by: &Vector3::repeat(1.0), surfaces: &[], joins: true };
        let link = Link::new("box".into(), None, &parts, &parts, &making);
        Self::new(vec![link], Vec::new())
    }

    fn new(links: Vec<Link>, surfaces: Vec<Surface>) -> Self {
        let extents = links.iter().flat_map(|l| &l.pieces).map(Piece::extent);
        let start = (Point3::from([f32::INFINITY; 3]), Point3::from([f32::NEG_INFINITY; 3]));
        let extent = extents.fold(start, |(low, high), (l, h)| (low.inf(&l), high.sup(&h)));
        let extent = if extent.0.x <= extent.1.x { extent } else { (Point3::origin(), Point3::origin()) };
        Self { links, surfaces, extent }
    }

    /// Whether its size is within the allowed limit.
    pub(crate) fn is_of_this_world(&self) -> bool {
        let (low, high) = self.extent;
        low.iter().chain(high.iter()).all(|c| c.abs() <= convert::LARGEST)
    }

    /// Mass of all links, kilograms.
    pub(crate) fn mass(&self) -> f32 {
        self.links.iter().map(|l| l.mass.mass()).sum()
    }

    /// The factor on masses that brings the total mass into the range of the class; for a scaled node the range
    /// is multiplied by the volume.
    pub(crate) fn mass_factor(&self, range: Option<Range>, volume: f32) -> f32 {
        let (mass, volume) = (self.mass(), volume.abs());
        let wanted = range.map_or(mass, |r| mass.clamp(r.low * volume, r.high.max(r.low) * volume));
        let factor = wanted / mass;
        if factor.is_finite() && factor > 0.0 { factor } else { 1.0 }
    }
}

/// The six walls of a hollow box.
fn shell(half: Vector3<f32>) -> Vec<(Vector3<f32>, Vector3<f32>)> {
    let wall = (half.min() * 0.1).clamp(0.001, 0.01);
    let side = |axis: usize, sign: f32| {
        let (mut offset, mut size) = (Vector3::zeros(), half);
        offset[axis] = sign * (half[axis] - wall);
        size[axis] = wall;
        (offset, size)
    };
    (0..3).flat_map(|axis| [side(axis, -1.0), side(axis, 1.0)]).collect()
}
