//! Forms: the engine's data about an asset.

use std::sync::{Arc, OnceLock};

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::MassProperties;
use rapier3d::geometry::SharedShape;
use rapier3d::math::Pose as EnginePose;
use vc_geometry::cut::{self, Polygons};
use vc_graph::asset::{Joint, Part, Shape, Surface};
use vc_graph::class::Range;
use vc_graph::{Asset, AssetLibrary, Bounds, BoundsFrame, Pose};

use super::footprint::{self, Footprint};
use super::mass::{self, Moments};
use super::piece::{self, Piece};
use super::{hollow, merge, scale};
use crate::convert;

/// Density of things of which only a box is known, kilograms per cubic metre.
const BOX_DENSITY: f32 = 150.0;
/// Friction of parts without a material.
const FRICTION: f32 = 0.5;

/// The largest protrusion of a part from a box that does not make it a piece of its own, metres before scaling:
/// prints, labels, panes.
const TRIM: f32 = 0.001;

/// The engine's data about an asset at a scale.
pub(crate) struct Form {
    /// The rigid links; the first is the base, the others have joints.
    pub(crate) links: Vec<Link>,
    /// The scaled surfaces for placing things.
    pub(crate) surfaces: Vec<Surface>,
    /// Minimal and maximal corner of the collision shapes, with joints at zero.
    pub(crate) extent: (Point3<f32>, Point3<f32>),
}

/// Parts that move as one rigid body.
pub(crate) struct Link {
    pub(crate) name: Arc<str>,
    pub(crate) joint: Option<Joint>,
    /// Its shape, and the pose of the shape in the asset's frame.
    pub(crate) solid: Option<(SharedShape, EnginePose)>,
    /// The mass properties in the asset's frame.
    pub(crate) mass: MassProperties,
    pub(crate) friction: f32,
    pub(crate) restitution: f32,
    /// Whether it can roll: it has a round part, as balls, bottles and pots have.
    pub(crate) round: bool,
    pieces: Vec<Piece>,
    mesh: OnceLock<Vec<[Point3<f32>; 3]>>,
    hulls: OnceLock<Vec<Vec<Point3<f32>>>>,
    footprints: OnceLock<Vec<Footprint>>,
}

impl Link {
    /// Its surface as triangles in the asset's frame, computed on demand.
    pub(crate) fn mesh(&self) -> &[[Point3<f32>; 3]] {
        let triangles = |piece: &Piece| {
            let (vertices, triangles) = scale::mesh(piece);
            triangles.into_iter().map(move |t| t.map(|v| vertices[v as usize])).collect::<Vec<_>>()
        };
        self.mesh.get_or_init(|| self.pieces.iter().flat_map(triangles).collect())
    }

    /// Corners of each of its pieces, in the asset's frame, computed on demand.
    pub(crate) fn hulls(&self) -> &[Vec<Point3<f32>>] {
        self.hulls.get_or_init(|| self.pieces.iter().map(scale::corners).collect())
    }

    /// The footprints of its pieces while the asset stands upright, computed on demand.
    pub(crate) fn footprints(&self) -> &[Footprint] {
        self.footprints.get_or_init(|| footprint::of(&self.pieces))
    }

    /// Its shape extended downwards by a distance in metres, and the pose of the shape in the asset's frame.
    pub(crate) fn deepened(&self, by: f32) -> Option<(SharedShape, EnginePose)> {
        let deeper: Option<Vec<Piece>> = self.pieces.iter().map(|piece| scale::deepened(piece, by)).collect();
        compound(&deeper?)
    }

    /// Number of convex pieces.
    pub(crate) fn pieces(&self) -> usize {
        self.pieces.len()
    }
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

/// The parameters for making the links of a form.
struct Making<'a> {
    library: &'a AssetLibrary,
    by: &'a Vector3<f32>,
    surfaces: &'a [Surface],
    joins: bool,
}

impl Form {
    pub(super) fn of_asset(asset: &Asset, library: &AssetLibrary, scale: &Vector3<f32>, kind: Kind) -> Self {
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

    /// The form of a node that has only a box; hollow if it contains things.
    pub(super) fn of_box(bounds: &Bounds, pose: &Pose, hollow: bool) -> Self {
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

impl Link {
    fn new(name: Arc<str>, joint: Option<Joint>, parts: &[&Part], solid: &[&Part], making: &Making<'_>) -> Self {
        let Making { library, by, surfaces, joins } = *making;
        let mut sum = Sum::default();
        parts.iter().for_each(|p| sum.add(p, library, by));
        let pieces = |part: &&Part| match &part.shape {
            Shape::Mesh { vertices, triangles, .. } if !joins => {
                let (whole, polygons) = surface(part, vertices, triangles, by);
                whole.along_faces(polygons, |corners| Piece::hull(&corners, &Vector3::z()))
            }
            _ => hollow::pieces(part, by, surfaces),
        };
        let round = solid.iter().any(|p| is_round(&p.shape));
        let felt = if joins { without_trim(solid) } else { solid.to_vec() };
        let pieces = felt.iter().flat_map(pieces).collect();
        let pieces = if joins { merge::merged(pieces, surfaces) } else { pieces };
        let (mass, friction, restitution) = sum.finish(&pieces);
        Self {
            name,
            joint,
            solid: compound(&pieces),
            mass,
            friction,
            restitution,
            round,
            pieces,
            mesh: OnceLock::new(),
            hulls: OnceLock::new(),
            footprints: OnceLock::new(),
        }
    }
}

fn is_round(shape: &Shape) -> bool {
    use Shape::{Capsule, Cone, Cylinder, Lathe, Sphere};
    matches!(shape, Sphere { .. } | Capsule { .. } | Cylinder { .. } | Cone { .. } | Lathe { .. })
}

/// The parts without those that are inside a box of another part, or protrude from it by at most [`TRIM`].
fn without_trim<'a>(parts: &[&'a Part]) -> Vec<&'a Part> {
    let extents: Vec<_> = parts.iter().map(|p| p.shape.extent()).collect();
    let is_box = |i: &usize| matches!(parts[*i].shape, Shape::Box { .. } | Shape::RoundedBox { .. });
    let boxes: Vec<usize> = (0..parts.len()).filter(is_box).collect();
    let covers = |a: usize, b: usize| {
        let (pose, other) = (&parts[a].pose, &parts[b].pose);
        if a == b || pose.rotation != other.rotation {
            return false;
        }
        let way = pose.rotation.inverse_transform_vector(&(other.translation.vector - pose.translation.vector));
        let ((low, high), (least, most)) = (extents[a], extents[b]);
        (0..3).all(|k| least[k] + way[k] >= low[k] - TRIM && most[k] + way[k] <= high[k] + TRIM)
    };
    // If two parts are in each other, the first is kept.
    let is_trim = |i: usize| boxes.iter().any(|&b| covers(b, i) && (b < i || !is_box(&i) || !covers(i, b)));
    (0..parts.len()).filter(|&i| !is_trim(i)).map(|i| parts[i]).collect()
}

/// A part's triangles in the frame of the scaled asset.
pub(super) fn surface(
    part: &Part,
    vertices: &[Point3<f32>],
    triangles: &[[u32; 3]],
    by: &Vector3<f32>,
) -> (cut::Surface, Polygons) {
    let placed = vertices.iter().map(|v| Point3::from((part.pose * v).coords.component_mul(by)));
    cut::Surface::new(placed.collect(), triangles)
}

/// The pieces of a part in the frame of the scaled asset.
pub(super) fn placed(part: &Part, by: &Vector3<f32>) -> Vec<Piece> {
    let at = |pose: Pose| move |p: Piece| Piece { at: pose * p.at, ..p };
    let up = part.pose.rotation.inverse_transform_vector(&Vector3::z());
    match scale::uniform(by) {
        Some(1.0) => piece::pieces(&part.shape, &up).into_iter().map(at(part.pose)).collect(),
        Some(s) => {
            let own = piece::pieces(&scale::shape(&part.shape, s), &up);
            own.into_iter().map(at(scale::pose(&part.pose, by))).collect()
        }
        None => {
            let own = piece::pieces(&part.shape, &up).into_iter().map(at(part.pose));
            own.filter_map(|p| scale::stretched(&p, by)).collect()
        }
    }
}

/// One collider for all pieces: the piece itself, or a compound.
fn compound(pieces: &[Piece]) -> Option<(SharedShape, EnginePose)> {
    match pieces {
        [] => None,
        [one] => Some((one.shape.clone(), convert::pose(&one.at))),
        many => {
            let list = many.iter().map(|p| (convert::pose(&p.at), p.shape.clone())).collect();
            Some((SharedShape::compound(list), EnginePose::IDENTITY))
        }
    }
}

/// The masses of parts; friction and restitution weighted by mass.
#[derive(Default)]
struct Sum {
    total: Moments,
    friction: f32,
    restitution: f32,
}

impl Sum {
    fn add(&mut self, part: &Part, library: &AssetLibrary, by: &Vector3<f32>) {
        let material = library.material(part.material);
        let (density, friction, restitution) =
            material.map_or((BOX_DENSITY, FRICTION, 0.0), |m| (m.density, m.friction, m.restitution));
        let own = Moments::of(&part.shape).moved(&part.pose).stretched(by) * f64::from(density);
        if own.is_sound() {
            self.friction += friction * own.mass();
            self.restitution += restitution.min(1.0) * own.mass();
            self.total += own;
        }
    }

    fn finish(self, pieces: &[Piece]) -> (MassProperties, f32, f32) {
        let total = self.total.properties();
        if mass::is_sound(&total) {
            return (total, self.friction / total.mass(), self.restitution / total.mass());
        }
        ((Moments::of_pieces(pieces) * f64::from(BOX_DENSITY)).properties(), FRICTION, 0.0)
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
