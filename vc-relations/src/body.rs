//! A body: the geometry of one node in the world.

use std::sync::Arc;

use nalgebra::{Isometry3, Matrix3, UnitQuaternion, Vector3};
use vc_graph::{Aabb, BoundsFrame, Node, NodeId, ObjectRole, Property, State};

use crate::form::{Form, Piece};
use crate::solid::{Round, Solid};
use crate::threshold::LYING_TILT;

/// Posture of an agent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Posture {
    Sitting,
    Lying,
    /// Not stated; geometry decides.
    Unsaid,
}

/// Properties of a node, beside its geometry, that the rules use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Traits {
    /// Walls, floors and ceilings.
    pub(crate) structure: bool,
    /// Structure, doors and windows: they rest on nothing.
    pub(crate) fixed: bool,
    pub(crate) door: bool,
    pub(crate) agent: bool,
    /// People can move it, or it moves by itself.
    pub(crate) moves: bool,
    pub(crate) sittable: bool,
    pub(crate) lieable: bool,
    pub(crate) lookable: bool,
    /// Only its box is known.
    pub(crate) boxed: bool,
    /// Only its box is known and things can be put on it, at an unknown height.
    pub(crate) vague: bool,
}

impl Traits {
    fn new(node: &Node) -> Self {
        let role = node.role();
        let boxed = node.spec().asset.is_none();
        let carries = [Property::Surface, Property::Sittable, Property::Lieable].into_iter().any(|p| node.affords(p));
        let agent = node.kind() == vc_graph::NodeKind::Agent;
        Self {
            structure: role.is_building(),
            fixed: role.is_built_in(),
            door: matches!(role, ObjectRole::Door | ObjectRole::DoorFrame),
            agent,
            moves: agent || node.affords(Property::Graspable) || node.affords(Property::Movable),
            sittable: node.affords(Property::Sittable),
            lieable: node.affords(Property::Lieable),
            lookable: node.affords(Property::Lookable),
            boxed,
            vague: boxed && carries,
        }
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) id: NodeId,
    pub(crate) traits: Traits,
    pub(crate) posture: Posture,
    pub(crate) form: Arc<Form>,
    pub(crate) solids: Vec<Solid>,
    /// The oriented bounding box of the whole body.
    pub(crate) whole: Solid,
    /// The axis-aligned box in the world around everything.
    pub(crate) region: Aabb,
    /// The node's own axes.
    pub(crate) heading: Matrix3<f32>,
    /// Whether its box is upright and aligned with these axes.
    pub(crate) level: bool,
    /// The map from the world to the asset's frame.
    inverse: Isometry3<f32>,
    pub(crate) scale: Vector3<f32>,
    /// Positions of its joints.
    positions: Vec<f32>,
    pub(crate) room: Option<NodeId>,
}

impl Body {
    /// The geometry of a node; `None` if it has no pose.
    pub(crate) fn new(node: &Node, form: Arc<Form>, positions: Vec<f32>) -> Option<Self> {
        let pose = node.pose()?;
        let spec = node.spec();
        let own = *pose.rotation.to_rotation_matrix().matrix();
        // A world-aligned box does not turn with its node.
        let still = spec.asset.is_none() && spec.bounds.is_some_and(|b| b.frame == BoundsFrame::World);
        let (rotation, turn) =
            if still { (UnitQuaternion::identity(), Matrix3::identity()) } else { (pose.rotation, own) };
        let frame = Isometry3::from_parts(pose.translation, rotation);
        let scale = if spec.asset.is_some() { spec.scale.abs() } else { Vector3::repeat(1.0) };
        let (centre, half) = ((form.low + form.high) / 2.0, (form.high - form.low) / 2.0);
        let whole = Piece { centre, axes: Matrix3::identity(), half, round: Round::No, link: None };
        let mut body = Self {
            id: node.id(),
            traits: Traits::new(node),
            posture: posture(node),
            solids: Vec::with_capacity(form.pieces.len()),
            whole: put(&whole, &turn, &frame.translation.vector, &scale),
            region: Aabb::EMPTY,
            heading: own,
            level: false,
            inverse: frame.inverse(),
            scale,
            positions,
            room: None,
            form,
        };
        body.level = body.whole.upright && body.whole.axes == own;
        body.put_solids(&frame, &turn);
        Some(body)
    }

    /// The point that determines its room: its centre; for an agent the point at that height above its feet,
    /// which stays in place when the body turns.
    pub(crate) fn midst(&self) -> Vector3<f32> {
        let centre = self.whole.centre;
        if !self.traits.agent {
            return centre;
        }
        let feet = self.inverse.inverse().translation.vector;
        Vector3::new(feet.x, feet.y, centre.z)
    }

    fn put_solids(&mut self, frame: &Isometry3<f32>, turn: &Matrix3<f32>) {
        let mut region = self.whole.region();
        for piece in &self.form.pieces {
            let solid = match self.motion(piece.link) {
                Some(motion) => placed(piece, &(frame * motion), &self.scale),
                None => put(piece, turn, &frame.translation.vector, &self.scale),
            };
            region = region.joined(&solid.region());
            self.solids.push(solid);
        }
        self.region = region;
    }

    /// Motion of a joint's parts, in the asset's frame.
    fn motion(&self, link: Option<u32>) -> Option<Isometry3<f32>> {
        let link = link? as usize;
        let position = self.positions.get(link).copied().filter(|&p| p != 0.0)?;
        Some(self.form.joints.get(link)?.motion(position))
    }

    /// A point of the world in the asset's frame.
    pub(crate) fn to_own(&self, point: &Vector3<f32>) -> Vector3<f32> {
        (self.inverse.rotation * point + self.inverse.translation.vector).component_div(&self.scale)
    }

    /// Position of a point of the asset's frame before a joint moved it.
    pub(crate) fn before_motion(&self, link: Option<u32>, point: Vector3<f32>) -> Vector3<f32> {
        self.motion(link).map_or(point, |m| (m.inverse() * nalgebra::Point3::from(point)).coords)
    }

    /// Positions of its hooks in the world.
    pub(crate) fn hooks(&self) -> impl Iterator<Item = Vector3<f32>> + '_ {
        let frame = self.inverse.inverse();
        self.form.hooks.iter().map(move |(at, link)| {
            let at = self.motion(*link).map_or(*at, |m| m.rotation * at + m.translation.vector);
            frame.rotation * at.component_mul(&self.scale) + frame.translation.vector
        })
    }

    /// Height of its lowest point, metres.
    pub(crate) fn base(&self) -> f32 {
        self.region.min.z
    }

    pub(crate) fn lies(&self) -> bool {
        self.posture == Posture::Lying || (self.posture == Posture::Unsaid && self.heading[(2, 2)].abs() < LYING_TILT)
    }
}

fn posture(node: &Node) -> Posture {
    match (node.is(State::Sitting), node.is(State::Lying)) {
        (true, _) => Posture::Sitting,
        (_, true) => Posture::Lying,
        _ => Posture::Unsaid,
    }
}

fn placed(piece: &Piece, frame: &Isometry3<f32>, scale: &Vector3<f32>) -> Solid {
    put(piece, frame.rotation.to_rotation_matrix().matrix(), &frame.translation.vector, scale)
}

/// Places a piece in the world. Scaling is along the asset's axes; a piece turned against them keeps its right
/// angles and gets the lengths of its scaled axes.
fn put(piece: &Piece, turn: &Matrix3<f32>, at: &Vector3<f32>, scale: &Vector3<f32>) -> Solid {
    if *scale == Vector3::repeat(1.0) {
        return Solid::new(turn * piece.centre + at, turn * piece.axes, piece.half, piece.round);
    }
    let stretch = Vector3::from_fn(|i, _| piece.axes.column(i).component_mul(scale).norm());
    let half = piece.half.component_mul(&stretch);
    Solid::new(turn * piece.centre.component_mul(scale) + at, turn * piece.axes, half, piece.round)
}
