//! Links: parts that move as one rigid body, with their collision shape and mass.

use std::sync::{Arc, OnceLock};

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::MassProperties;
use rapier3d::geometry::{ColliderBuilder, SharedShape};
use rapier3d::math::Pose as EnginePose;
use vc_graph::AssetLibrary;
use vc_graph::asset::{Joint, Part, Shape, Surface};

use super::footprint::{self, Footprint};
use super::mass::{self, Moments, scaled};
use super::part::surface;
use super::piece::Piece;
use super::{hollow, merge, scale};
use crate::convert;

/// Density of things of which only a box is known, kilograms per cubic metre.
const BOX_DENSITY: f32 = 150.0;

/// Friction of parts without a material.
const FRICTION: f32 = 0.5;

/// The largest protrusion of a part from a box that does not make it a piece of its own, metres before scaling:
/// prints, labels, panes.
const TRIM: f32 = 0.001;

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
    pub(super) pieces: Vec<Piece>,
    mesh: OnceLock<Vec<[Point3<f32>; 3]>>,
    hulls: OnceLock<Vec<Vec<Point3<f32>>>>,
    footprints: OnceLock<Vec<Footprint>>,
}

/// The parameters for making the links of a form.
pub(super) struct Making<'a> {
    pub(super) library: &'a AssetLibrary,
    pub(super) by: &'a Vector3<f32>,
    pub(super) surfaces: &'a [Surface],
    pub(super) joins: bool,
}

impl Link {
    pub(super) fn new(
        name: Arc<str>,
        joint: Option<Joint>,
        parts: &[&Part],
        solid: &[&Part],
        making: &Making<'_>,
    ) -> Self {
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
        let colliding = if joins { without_trim(solid) } else { solid.to_vec() };
        let pieces = colliding.iter().flat_map(pieces).collect();
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
        self.footprints.get_or_init(|| footprint::footprints(&self.pieces))
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

    /// A collider of the link, with its mass. The engine adds the mass properties of colliders and body, and
    /// loses the inertia axes of small things when there is more than one to add.
    pub(crate) fn collider(&self, shape: &SharedShape, at: &EnginePose, mass_factor: f32) -> ColliderBuilder {
        let mass = scaled(self.mass, self.mass.mass() * mass_factor).transform_by(&at.inverse());
        let builder = ColliderBuilder::new(shape.clone()).position(*at).mass_properties(mass);
        builder.friction(self.friction).restitution(self.restitution)
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
        let own = Moments::from_shape(&part.shape).moved(&part.pose).stretched(by) * f64::from(density);
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
        ((Moments::from_pieces(pieces) * f64::from(BOX_DENSITY)).properties(), FRICTION, 0.0)
    }
}
