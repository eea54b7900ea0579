//! A node's body, and the instances of meshes it is made of.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::class::Category;
use vc_graph::{NodeId, Pose};

use super::cover::Drawn;
use super::liquid::SPECK;
use crate::affine::{Affine, Narrow};
use crate::mesh::{Ball, Bounds, Link};
use crate::surface::Coat;

/// Room of what is in none.
pub(crate) const NO_ROOM: u16 = u16::MAX;

/// How a body stands to its room.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stands {
    Within,
    /// It bounds the room, as walls and windows do: its outer side is not in it.
    Around,
    /// It is of two rooms, as doors are.
    Between,
}

impl Stands {
    /// By the category of its class.
    pub(super) fn of(category: Option<Category>) -> Self {
        match category {
            Some(Category::Door) => Self::Between,
            Some(Category::Structure | Category::Window) => Self::Around,
            _ => Self::Within,
        }
    }
}

/// A node that can be seen.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) node: NodeId,
    /// Index in the snapshot's list of classes.
    pub(crate) class: u16,
    /// Index in the scene's list of rooms.
    pub(crate) room: u16,
    /// How it stands to its room.
    pub(crate) stands: Stands,
    /// Whether what glows in it does.
    pub(crate) lit: bool,
    pub(crate) pose: Pose,
    pub(crate) scale: Vector3<f32>,
    pub(crate) instances: Range<u32>,
    /// The box around it in its own frame, scale included, joints where they are.
    pub(crate) bounds: Bounds,
}

/// A mesh somewhere in the world.
#[derive(Debug, Clone)]
pub(crate) struct Instance {
    pub(crate) link: Arc<Link>,
    /// Index of its body.
    pub(crate) body: u32,
    /// Where its joint is, radians or metres.
    pub(crate) joint: f32,
    /// From the mesh to the world.
    pub(crate) world: Affine,
    /// From the world to the mesh.
    pub(crate) inverse: Narrow,
    /// Around it in the world.
    pub(crate) ball: Ball,
    /// Whether the map turns triangles over.
    pub(crate) mirrored: bool,
    /// What lies on it.
    pub(crate) coat: Coat,
    /// What is poured into a vessel, if it is that.
    pub(super) liquid: Option<Poured>,
    /// What draws it over a window, if it hangs at one.
    pub(super) drawn: Option<Drawn>,
    /// Of a curtain that may be tied, when it is there.
    pub(super) tied: Option<Tied>,
    /// Whether nothing of its body is to be seen.
    pub(super) hidden: bool,
}

/// A liquid that is in a vessel or not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Poured {
    pub(super) there: bool,
    /// A point in the vessel's bottom.
    pub(super) bottom: [f64; 3],
}

/// Part of a curtain that is tied where it is not drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tied {
    /// Whether it is there when the curtain is drawn, or else when it is not.
    pub(super) drawn: bool,
    /// A point within what is there otherwise.
    pub(super) hidden: [f64; 3],
}

impl Instance {
    /// Puts it where its body's pose and its joint say; false if it has no extent
    /// there in some direction.
    pub(crate) fn put(&mut self, pose: &Pose, scale: &Vector3<f32>) -> bool {
        let own = self.link.joint.map_or_else(Pose::identity, |joint| joint.motion(self.joint));
        self.arrange(pose, scale, &own)
    }

    /// Whether it is drawn over a window.
    pub(crate) fn covers(&self) -> bool {
        self.drawn.as_ref().is_some_and(|drawn| drawn.closed)
    }

    /// Where it is a speck that is not to be seen, in the mesh's frame.
    fn speck(&self) -> Option<[f64; 3]> {
        match self.liquid {
            _ if self.hidden => Some([0.0; 3]),
            Some(Poured { there: false, bottom }) => Some(bottom),
            _ => self.tied.filter(|tied| tied.drawn != self.covers()).map(|tied| tied.hidden),
        }
    }

    /// Whether there is something to be seen of it.
    pub(super) fn is_there(&self) -> bool {
        self.speck().is_none()
    }

    /// Puts it where its body's pose and its own motion say.
    pub(crate) fn arrange(&mut self, pose: &Pose, scale: &Vector3<f32>, own: &Pose) -> bool {
        let placed = match &self.drawn {
            Some(Drawn { closed: true, stretch }) => {
                Affine::of(pose).after(stretch).after(&Affine::placed(&Pose::identity(), scale))
            }
            _ => Affine::placed(pose, scale),
        };
        let placed = placed.after(&Affine::of(own));
        // A speck where nobody sees it: as good as not there, and known to all that know the scene.
        self.world = self.speck().map_or(placed, |at| placed.after(&Affine::shrunk(at, SPECK)));
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

    /// The box around the body's instances in its own frame.
    pub(crate) fn measured(&self, instances: &[Instance]) -> Bounds {
        let Some(back) = Affine::of(&self.pose).inverse() else { return Bounds::default() };
        let mut all: Option<Bounds> = None;
        for instance in instances {
            let own = back.after(&instance.world).narrow();
            let bounds = turned(&own, &instance.link.levels[0].bounds);
            all = Some(all.map_or(bounds, |a| a.joined(&bounds)));
        }
        all.unwrap_or_default()
    }
}

/// The box around a box that is mapped.
pub(crate) fn turned(map: &Narrow, bounds: &Bounds) -> Bounds {
    let half = [0, 1, 2].map(|r: usize| (0..3).map(|c| map[r][c].abs() * bounds.half[c]).sum());
    Bounds { centre: crate::affine::point(map, bounds.centre), half }
}
