//! The form of an asset: convex pieces, hollows and hooks, computed once for each asset.

use std::sync::OnceLock;

use nalgebra::{Matrix3, Point3, Vector3};
use vc_graph::Asset;
use vc_graph::asset::{Hold, Joint, Part, Shape, Surface};

use crate::carve;
use crate::hollow::{self, Cavity, Space};
use crate::solid::{Round, Solid};
use crate::threshold::{COMPARTMENT_SINK, HOLLOW_LEAST, ROOF_LEAST};

/// A convex piece in the asset's frame, with joints at zero, metres.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) centre: Vector3<f32>,
    pub(crate) axes: Matrix3<f32>,
    pub(crate) half: Vector3<f32>,
    pub(crate) round: Round,
    /// Index of the joint that it moves with.
    pub(crate) link: Option<u32>,
}

impl Piece {
    fn solid(&self) -> Solid {
        Solid::new(self.centre, self.axes, self.half, self.round)
    }
}

/// All relation-relevant geometry of an asset.
#[derive(Debug, Clone, Default)]
pub(crate) struct Form {
    pub(crate) pieces: Vec<Piece>,
    cavities: OnceLock<Vec<Cavity>>,
    pub(crate) hooks: Vec<(Vector3<f32>, Option<u32>)>,
    pub(crate) joints: Vec<Joint>,
    /// Corners of the box around all pieces, with joints at zero.
    pub(crate) low: Vector3<f32>,
    pub(crate) high: Vector3<f32>,
}

impl Form {
    pub(crate) fn new(asset: &Asset) -> Self {
        let mut form = Self::default();
        let parts = if asset.collision.is_empty() { &asset.parts } else { &asset.collision };
        for part in parts {
            let link = form.link(part.joint.as_ref());
            pieces(part, &mut |piece| form.pieces.push(Piece { link, ..piece }));
        }
        form.measure();
        let mut stated = Vec::new();
        for surface in &asset.surfaces {
            let link = form.link(surface.joint.as_ref());
            match surface.hold {
                Hold::Inside => stated.extend(form.compartment(surface, link)),
                Hold::Hook => form.hooks.push((surface.centre.coords, link)),
                Hold::On => {}
            }
        }
        if !asset.surfaces.is_empty() || form.pieces.len() < 2 {
            form.cavities = stated.into();
        }
        form
    }

    /// Its cavities: those that the asset states, otherwise those found between its parts. The search runs on
    /// first use and costs some ten microseconds.
    pub(crate) fn cavities(&self) -> &[Cavity] {
        self.cavities.get_or_init(|| {
            let solids: Vec<Solid> = self.pieces.iter().map(Piece::solid).collect();
            hollow::find(&solids, &self.low, &self.high)
        })
    }

    /// Whether a point of the asset's frame may be in some cavity or above its rim; if false, it is beside or
    /// below the whole asset.
    pub(crate) fn may_hold(&self, point: &Vector3<f32>) -> bool {
        let within = |i: usize| (self.low[i]..=self.high[i]).contains(&point[i]);
        match self.cavities.get() {
            Some(known) => !known.is_empty(),
            None => within(0) && within(1) && point.z >= self.low.z,
        }
    }

    /// The form of a node of which only the box is known.
    pub(crate) fn boxed(low: Vector3<f32>, high: Vector3<f32>, container: bool) -> Self {
        let (centre, half) = ((low + high) / 2.0, (high - low) / 2.0);
        let piece = Piece { centre, axes: Matrix3::identity(), half, round: Round::No, link: None };
        let cavity = Cavity { space: Space::Box { centre, half }, open: false, link: None };
        let cavities = if container { vec![cavity] } else { Vec::new() };
        Self { pieces: vec![piece], cavities: cavities.into(), low, high, ..Self::default() }
    }

    fn link(&mut self, joint: Option<&Joint>) -> Option<u32> {
        let joint = joint?;
        let known = self.joints.iter().position(|j| j == joint).unwrap_or_else(|| {
            self.joints.push(*joint);
            self.joints.len() - 1
        });
        Some(known as u32)
    }

    fn measure(&mut self) {
        let boxes = self.pieces.iter().map(|p| p.solid()).map(|s| (s.low, s.high));
        (self.low, self.high) = boxes.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))).unwrap_or_default();
    }

    /// The space above a surface that holds things inside.
    fn compartment(&self, surface: &Surface, link: Option<u32>) -> Option<Cavity> {
        let floor = surface.centre.z;
        let top = surface.clearance.map_or(self.high.z, |c| floor + c).max(floor + HOLLOW_LEAST);
        // A thing that is pressed into a rack is in it still.
        let half = Vector3::new(surface.half.0, surface.half.1, (top - floor + COMPARTMENT_SINK) / 2.0);
        let centre = Vector3::new(surface.centre.x, surface.centre.y, top - half.z);
        let sound = half.iter().all(|&h| h > 0.0);
        let open = surface.clearance.is_none() || !self.is_roofed(&(centre + Vector3::z() * half.z));
        sound.then_some(Cavity { space: Space::Box { centre, half }, open, link })
    }

    /// Whether a part of the asset is above a point.
    fn is_roofed(&self, point: &Vector3<f32>) -> bool {
        let over = |s: Solid| {
            (s.low.x..=s.high.x).contains(&point.x)
                && (s.low.y..=s.high.y).contains(&point.y)
                && s.high.z > point.z + ROOF_LEAST
        };
        self.pieces.iter().any(|p| over(p.solid()))
    }
}

/// Splits a part's shape into convex pieces that approximately fill it.
fn pieces(part: &Part, push: &mut dyn FnMut(Piece)) {
    let turn = *part.pose.rotation.to_rotation_matrix().matrix();
    let at = part.pose.translation.vector;
    let mut put = |centre: Vector3<f32>, axes: Matrix3<f32>, half: Vector3<f32>, round: Round| {
        push(Piece { centre: turn * centre + at, axes: turn * axes, half, round, link: None });
    };
    let plain = Matrix3::identity();
    let round = |shape: &Shape| match shape {
        Shape::Cylinder { .. } | Shape::Cone { .. } | Shape::Capsule { .. } => Round::Turned,
        Shape::Sphere { .. } => Round::Ball,
        _ => Round::No,
    };
    if !part.shape.measures_are_positive() {
        return;
    }
    match &part.shape {
        Shape::Lathe { profile } => carve::lathe(profile, &mut put),
        Shape::Extrusion { outline, height } => carve::extrusion(outline, *height, &mut put),
        Shape::Mesh { vertices, triangles, .. } => carve::mesh(vertices, triangles, &mut put),
        shape => {
            let (low, high): (Point3<f32>, Point3<f32>) = shape.extent();
            put((low.coords + high.coords) / 2.0, plain, (high - low) / 2.0, round(shape));
        }
    }
}
