//! Where cameras and other sensors are mounted.

use nalgebra::{Point3, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose};
use vc_people::{BodySide, Bone, Skeleton, palm};
use vc_physics::Hand;
use vc_render::{Camera, RenderError};

use super::{CameraError, PictureError, Viewpoint};
use crate::Environment;

/// Near plane of cameras on bodies, metres: closer than it is what they are fastened to.
const NEAR: f32 = 0.03;
/// Offset from the origin up to which mounts are accepted, metres.
const FARTHEST: f32 = 1e6;
/// Longest way from somebody to a camera that follows, metres.
const TETHER: f32 = 100.0;
/// From the palm of a hand to a camera on its wrist: behind it and on the thumb's side, metres.
const WRIST: (f32, f32) = (-0.12, 0.07);
/// Angles around somebody at which a camera that follows may be, radians from straight behind.
const AROUND: [f32; 11] = [0.0, 0.3, -0.3, 0.6, -0.6, 1.0, -1.0, 1.5, -1.5, 2.2, -2.2];
/// Distance that is enough for such a camera, metres, and the shares of it that it gives up to be a radian nearer to
/// straight behind, and to be as high as it is to be instead of half as high as it is far.
const ENOUGH: f32 = 2.0;
const ASTRAY: f32 = 0.25;
const RAISED: f32 = 0.3;
/// Distance that it keeps from what is in its way, metres.
const KEPT: f32 = 0.15;

/// Where a camera or another [sensor](crate::sensors::Sensor) is mounted. Sensors look along X, their left is along Y and
/// their top along Z; offsets are from the frame that each variant names, in metres.
///
/// ```
/// use virtualcity::{Environment, Lens, Mount, Viewpoint, render::Modality};
/// let mut home = Environment::make("apartment/42", 1)?;
/// let me = home.agents()[0];
/// let behind = home.add_camera("behind me", Mount::Following { agent: me, behind: 2.0, above: 0.6 }, Lens::Options)?;
/// let frame = home.render(Viewpoint::Camera(behind), Modality::Instance, 64, 48)?;
/// assert!(frame.instance.contains(&me));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Mount {
    /// At a pose of the home.
    Fixed(#[serde(with = "vc_graph::serial::pose")] Pose),
    /// On an agent's head: between its eyes, looking where they look.
    Head {
        /// The agent.
        agent: NodeId,
        /// From the eyes.
        #[serde(default, with = "vc_graph::serial::pose")]
        offset: Pose,
    },
    /// On an agent's hand: in the middle of the palm, X along the fingers, Z towards the thumb.
    Hand {
        /// The agent.
        agent: NodeId,
        /// The hand.
        hand: Hand,
        /// From the palm.
        #[serde(default, with = "vc_graph::serial::pose")]
        offset: Pose,
    },
    /// On any other thing, in its own frame.
    Thing {
        /// The thing.
        thing: NodeId,
        /// From its origin.
        #[serde(default, with = "vc_graph::serial::pose")]
        offset: Pose,
    },
    /// Behind an agent's shoulders, looking at them, wherever it goes. Where a wall or something else is in the way, the
    /// camera is nearer, higher or more to the side: it depends on the present state alone, and jumps where that is
    /// better.
    Following {
        /// The agent.
        agent: NodeId,
        /// Distance behind, metres.
        behind: f32,
        /// Height above the shoulders, metres.
        above: f32,
    },
    /// In a corner of a room: [`Viewpoint::Room`].
    Room(NodeId),
    /// Above a room, its ceiling taken off: [`Viewpoint::Above`].
    Above(NodeId),
    /// Above the whole home, ceilings taken off: [`Viewpoint::Overhead`].
    Overhead,
}

impl Mount {
    /// Between an agent's eyes.
    pub fn head(agent: NodeId) -> Self {
        Self::Head { agent, offset: Pose::identity() }
    }

    /// On the wrist of an agent's hand, above its thumb: the hand and what it holds are in view.
    pub fn wrist(agent: NodeId, hand: Hand) -> Self {
        Self::Hand { agent, hand, offset: Pose::translation(WRIST.0, 0.0, WRIST.1) }
    }

    /// The mount of a viewpoint that has one.
    pub(super) fn of(view: Viewpoint) -> Option<Self> {
        match view {
            Viewpoint::Agent(agent) => Some(Self::head(agent)),
            Viewpoint::Room(room) => Some(Self::Room(room)),
            Viewpoint::Above(room) => Some(Self::Above(room)),
            Viewpoint::Overhead => Some(Self::Overhead),
            Viewpoint::Free(_) | Viewpoint::Camera(_) => None,
        }
    }

    /// Whether it is above rooms whose ceilings are taken off.
    pub(super) fn is_plan(&self) -> bool {
        matches!(self, Self::Above(_) | Self::Overhead)
    }

    /// Refuses numbers that are no place.
    pub(super) fn check(&self) -> Result<(), CameraError> {
        match *self {
            Self::Fixed(pose) if !is_sound(&pose) => Err(CameraError::Pose),
            Self::Head { offset, .. } | Self::Hand { offset, .. } | Self::Thing { offset, .. }
                if !is_sound(&offset) =>
            {
                Err(CameraError::Pose)
            }
            Self::Following { behind, above, .. }
                if !(behind > 0.0 && behind <= TETHER) || above.is_nan() || above.abs() > TETHER =>
            {
                Err(CameraError::Tether { behind, above, most: TETHER })
            }
            _ => Ok(()),
        }
    }
}

fn is_sound(pose: &Pose) -> bool {
    pose.translation.vector.iter().all(|v| v.abs() <= FARTHEST) && (pose.rotation.norm() - 1.0).abs() < 1e-3
}

impl Environment {
    /// Refuses a mount on what is not there, or that is no place.
    pub(crate) fn check_mount(&self, mount: &Mount) -> Result<(), CameraError> {
        mount.check()?;
        match *mount {
            Mount::Head { agent, .. } | Mount::Hand { agent, .. } | Mount::Following { agent, .. } => {
                let known = self.graph().agents().contains(&agent);
                known.then_some(()).ok_or_else(|| CameraError::NotAnAgent(self.graph().label(agent)))
            }
            Mount::Thing { thing, .. } => {
                let posed = self.graph().node(thing).is_some_and(|n| n.pose().is_some());
                posed.then_some(()).ok_or_else(|| CameraError::NoBody(self.graph().label(thing)))
            }
            Mount::Room(room) | Mount::Above(room) => {
                self.bounds_of(room).map(drop).map_err(|_| CameraError::NotARoom(self.graph().label(room)))
            }
            Mount::Fixed(_) | Mount::Overhead => Ok(()),
        }
    }

    /// A camera on a mount.
    pub(crate) fn mounted(&self, mount: &Mount, lens: Camera) -> Result<Camera, PictureError> {
        match *mount {
            Mount::Fixed(pose) => Ok(lens.mounted(&pose)),
            Mount::Head { agent, offset } => {
                let raised = self.raised_eyes()?;
                self.on_body(agent, lens, |s| raised * s.eyes() * offset)
            }
            Mount::Hand { agent, hand, offset } => self.on_body(agent, lens, |s| palm_frame(s, hand) * offset),
            Mount::Thing { thing, offset } => {
                let pose = self.graph().node(thing).and_then(|n| n.pose());
                let pose = pose.ok_or_else(|| RenderError::NoBody(self.graph().label(thing)))?;
                Ok(lens.mounted(&(pose * offset)))
            }
            Mount::Following { agent, behind, above } => self.following(agent, (behind, above), lens),
            Mount::Room(room) => self.corner(room, lens),
            Mount::Above(room) => self.above(room, lens),
            Mount::Overhead => Ok(self.overhead(lens)),
        }
    }

    /// An agent's pose and skeleton.
    fn figure(&self, agent: NodeId) -> Result<(Pose, Skeleton), PictureError> {
        let label = || self.graph().label(agent);
        if !self.graph().agents().contains(&agent) {
            return Err(CameraError::NotAnAgent(label()).into());
        }
        let pose = self.graph().node(agent).and_then(|n| n.pose());
        Ok(pose.copied().zip(self.skeleton(agent)).ok_or_else(|| RenderError::NoBody(label()))?)
    }

    fn on_body(&self, agent: NodeId, lens: Camera, at: impl Fn(&Skeleton) -> Pose) -> Result<Camera, PictureError> {
        let (feet, skeleton) = self.figure(agent)?;
        Ok(Camera { near: NEAR, ..lens.mounted(&(feet * at(&skeleton))) })
    }

    /// A camera behind somebody, as far as there is room.
    fn following(&self, agent: NodeId, (behind, above): (f32, f32), lens: Camera) -> Result<Camera, PictureError> {
        let (feet, skeleton) = self.figure(agent)?;
        let shoulders = feet * (skeleton.motion(Bone::Head) * Bone::Head.anchor());
        let past: Vec<NodeId> = std::iter::once(agent).chain(self.graph().held(agent)).collect();
        let ahead = feet.rotation * Vector3::x();
        let heading = ahead.y.angle_to(ahead.x) + std::f32::consts::PI;
        let place = |(turn, height, cost): (f32, f32, f32)| {
            let (sine, cosine) = (heading + turn).sine_cosine();
            let way = Vector3::new(behind * cosine, behind * sine, height);
            let share = self.free_share(shoulders, shoulders + way, &past);
            let enough = way.norm().min(ENOUGH);
            let score = (share * way.norm()).min(enough) / enough - ASTRAY * turn.abs() - cost;
            (score, shoulders + way * share)
        };
        let heights = [(above, 0.0), (above.max(0.5 * behind), RAISED)];
        let places = heights.into_iter().flat_map(|(height, cost)| AROUND.map(|turn| place((turn, height, cost))));
        let best = places.reduce(|best, place| if place.0 > best.0 { place } else { best });
        let eye = best.map_or(shoulders, |(_, eye)| eye);
        Ok(lens.looking(eye, shoulders))
    }

    /// Which share of a way is free.
    fn free_share(&self, from: Point3<f32>, to: Point3<f32>, past: &[NodeId]) -> f32 {
        let length = (to - from).norm();
        let met = self.world().ray(from, to, past);
        met.map_or(1.0, |(_, at)| (((at - from).norm() - KEPT) / length).clamp(0.05, 1.0))
    }
}

/// The frame of a palm in its body's: X along the fingers, Z towards the thumb.
fn palm_frame(skeleton: &Skeleton, hand: Hand) -> Pose {
    let side = match hand {
        Hand::Right => BodySide::Right,
        Hand::Left => BodySide::Left,
    };
    // An arm that hangs down has its fingers down and its thumb ahead.
    let down = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f32::consts::FRAC_PI_2);
    skeleton.motion(Bone::Hand(side)) * Pose::from_parts(Translation3::from(palm(side).coords), down)
}
