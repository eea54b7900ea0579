//! The body of a node, and the mesh instances it consists of.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::{NodeId, ObjectRole, Pose};

use super::cover::Drawn;
use super::liquid::SPECK;
use crate::math::{Affine, Ball, Bounds, Narrow};
use crate::mesh::Link;
use crate::surface::Coat;

/// Room index of bodies that are in no room.
pub(crate) const NO_ROOM: u16 = u16::MAX;

/// How a body relates to its room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stands {
    Within,
    /// It bounds the room, as walls and windows do: its outer side is not in the room.
    Around,
    /// It belongs to two rooms, as doors do.
    Between,
    /// It bounds a room of which only the outside is drawn.
    Outside,
}

impl Stands {
    pub(super) fn from_role(role: ObjectRole) -> Self {
        match role {
            ObjectRole::Door => Self::Between,
            _ if role.is_built_in() => Self::Around,
            _ => Self::Within,
        }
    }
}

/// The light that a thing gives when it is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gives {
    /// That of a lamp, which lights a room.
    Lamplight,
    /// That of a candle.
    Candlelight,
    /// The glow of a screen or an indicator.
    Glow,
}

/// A node with a visible shape.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) node: NodeId,
    /// Index in the snapshot's list of classes.
    pub(crate) class: u16,
    /// Index in the scene's list of rooms.
    pub(crate) room: u16,
    pub(crate) role: ObjectRole,
    /// How it relates to its room.
    pub(crate) stands: Stands,
    /// The light that it gives when it is on.
    pub(crate) gives: Gives,
    /// Whether its luminous parts are switched on.
    pub(crate) lit: bool,
    pub(crate) pose: Pose,
    pub(crate) scale: Vector3<f32>,
    pub(crate) instances: Range<u32>,
    /// The bounding box in the body's own frame, scale included, with joints in their current positions.
    pub(crate) bounds: Bounds,
}

/// A mesh placed in the world.
#[derive(Debug, Clone)]
pub(crate) struct Instance {
    pub(crate) link: Arc<Link>,
    /// Index of its body.
    pub(crate) body: u32,
    /// Position of its joint, radians or metres.
    pub(crate) joint: f32,
    /// The map from the mesh to the world.
    pub(crate) world: Affine,
    /// The map from the world to the mesh.
    pub(crate) inverse: Narrow,
    /// Bounding sphere in the world.
    pub(crate) ball: Ball,
    /// Whether the map reverses the winding of triangles.
    pub(crate) mirrored: bool,
    /// The frame in which the textures of floors and walls lie, if it is not the world's.
    pub(crate) ground: Option<Arc<Ground>>,
    /// The coat that lies on it.
    pub(crate) coat: Coat,
    /// For the liquid in a vessel: whether it is there.
    pub(super) liquid: Option<Poured>,
    /// For part of a blind or curtain: the maps that draw it over its window and set it apart from others.
    pub(super) drawn: Option<Drawn>,
    /// For part of a curtain that can be tied: when it is there.
    pub(super) tied: Option<Tied>,
    /// Whether its body is hidden.
    pub(super) hidden: bool,
}

/// The frame of a scene that is drawn beside others: textures of its floors and walls lie in it as in pictures of it alone.
#[derive(Debug, Clone)]
pub(crate) struct Ground {
    /// The map from it to the world.
    pub(crate) world: Affine,
    /// The map from the world to it.
    pub(crate) inverse: Narrow,
}

impl Ground {
    pub(super) fn new(world: Affine) -> Self {
        let inverse = world.inverse().unwrap_or(Affine::IDENTITY).narrow();
        Self { world, inverse }
    }
}

/// A liquid in a vessel, which may be empty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Poured {
    pub(super) there: bool,
    /// A point inside the vessel's bottom.
    pub(super) bottom: [f64; 3],
}

/// A part of a curtain that exists either only tied or only drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tied {
    /// Whether it is there when the curtain is drawn, or otherwise when it is not.
    pub(super) drawn: bool,
    /// A point inside the part that is there otherwise.
    pub(super) hidden: [f64; 3],
}

impl Instance {
    /// Places it according to its body's pose and its joint; false if it is then flat in some direction.
    pub(crate) fn put(&mut self, pose: &Pose, scale: &Vector3<f32>) -> bool {
        let own = self.link.joint.map_or_else(Pose::identity, |joint| joint.motion(self.joint));
        self.arrange(pose, scale, &own)
    }

    /// Whether it is drawn over a window.
    pub(crate) fn covers(&self) -> bool {
        self.drawn.as_ref().is_some_and(|drawn| drawn.closed && drawn.stretch.is_some())
    }

    /// The point, in the mesh's frame, to which it is shrunk while it is not to be seen.
    fn speck(&self) -> Option<[f64; 3]> {
        match self.liquid {
            _ if self.hidden => Some([0.0; 3]),
            Some(Poured { there: false, bottom }) => Some(bottom),
            _ => self.tied.filter(|tied| tied.drawn != self.covers()).map(|tied| tied.hidden),
        }
    }

    /// Whether it can be seen at all.
    pub(super) fn is_there(&self) -> bool {
        self.speck().is_none()
    }

    /// Places it according to its body's pose and its own motion.
    pub(crate) fn arrange(&mut self, pose: &Pose, scale: &Vector3<f32>, own: &Pose) -> bool {
        let placed = match self.drawn.as_ref().and_then(Drawn::map) {
            Some(map) => Affine::from_pose(pose).after(map).after(&Affine::placed(&Pose::identity(), scale)),
            None => Affine::placed(pose, scale),
        };
        let placed = placed.after(&Affine::from_pose(own));
        // A hidden instance shrinks to an invisible speck: nothing is seen of it, but every holder of the scene
        // keeps the same list of instances.
        self.world = self.speck().map_or(placed, |at| placed.after(&Affine::shrunk(at, SPECK)));
        self.settle()
    }

    /// Moves it by a map, wherever it is.
    pub(super) fn shift(&mut self, by: &Arc<Ground>) {
        let ground = self.ground.as_ref().map(|own| Arc::new(Ground::new(by.world.after(&own.world))));
        self.ground = Some(ground.unwrap_or_else(|| by.clone()));
        self.world = by.world.after(&self.world);
        self.settle();
    }

    /// Works out what follows from where it is; false if it is flat in some direction.
    fn settle(&mut self) -> bool {
        self.ball = self.link.levels[0].bounds.ball(&self.world);
        self.mirrored = self.world.determinant() < 0.0;
        let inverse = self.world.inverse();
        self.inverse = inverse.unwrap_or(Affine::IDENTITY).narrow();
        inverse.is_some()
    }
}

impl Body {
    /// Whether it is drawn over a window, given the instances of all bodies.
    pub(crate) fn covers(&self, instances: &[Instance]) -> bool {
        let own = self.instances.start as usize..self.instances.end as usize;
        instances[own].iter().any(Instance::covers)
    }

    /// The box around the body's instances in the body's own frame.
    pub(crate) fn measured(&self, instances: &[Instance]) -> Bounds {
        let Some(back) = Affine::from_pose(&self.pose).inverse() else { return Bounds::default() };
        let mut all: Option<Bounds> = None;
        for instance in instances {
            let own = back.after(&instance.world).narrow();
            let bounds = instance.link.levels[0].bounds.mapped(&own);
            all = Some(all.map_or(bounds, |a| a.joined(&bounds)));
        }
        all.unwrap_or_default()
    }
}
