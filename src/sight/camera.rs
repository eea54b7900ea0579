//! Where cameras of an environment are.

use nalgebra::Point3;
use vc_graph::{Aabb, Kind, Label, NodeId};
use vc_render::{Camera, Frame, Modality, RenderError, Shot};

use crate::Environment;

/// Vertical field of view of eyes and of cameras in rooms, radians.
const FIELD: f32 = 1.15;
/// Height above the floor at which a view from above cuts the home open, metres.
const CUT: f32 = 2.1;
/// Pixels of the pictures by which corners are compared.
const LOOK: (u32, u32) = (64, 48);
/// Height of cameras in corners above the floor, and of what they look at, metres.
const CORNER: (f32, f32) = (2.05, 0.8);
/// How far down such a camera looks at most, as a slope: in small rooms it looks over the middle.
const STEEP: f32 = 0.5;
/// A thing or pane that is nearer than this to a camera in a room is in its way, metres.
const CLOSE: f32 = 1.0;
/// Rays by which this is found, across and down.
const RAYS: (u32, u32) = (8, 6);
/// How much the parts of a picture count against a thing that is in it: what is in the way, what is beyond the room,
/// and the room's floor, of which up to a share helps.
const WEIGHTS: [f32; 3] = [60.0, 20.0, 30.0];
const FLOOR: f32 = 0.3;
/// How much somebody counts who is in the room as the home begins, as things.
const PERSON: f32 = 5.0;

/// Where a camera is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Viewpoint {
    /// An agent's eyes.
    Agent(NodeId),
    /// Fixed in a room, in the corner from which most of it is seen as the home begins.
    Room(NodeId),
    /// Above a room, its ceiling taken off.
    Above(NodeId),
    /// Above the whole home, ceilings taken off.
    Overhead,
    /// Anywhere; [resized](Camera::resized) to the width and height asked for.
    Free(Camera),
}

impl Viewpoint {
    /// Whether it is above rooms whose ceilings are taken off.
    pub(super) fn is_plan(&self) -> bool {
        matches!(self, Self::Above(_) | Self::Overhead)
    }
}

impl Environment {
    /// The camera of a viewpoint, for pictures of a size in pixels: `Camera::mounted` on an agent's
    /// eyes, `Camera::looking` from a corner of a room, `Camera::overhead`, `Camera::resized`.
    ///
    /// # Errors
    /// [`RenderError::NoBody`] if there is no such agent or room.
    pub fn camera(&self, view: Viewpoint, width: u32, height: u32) -> Result<Camera, RenderError<Label>> {
        let camera = Camera::with_fov(width, height, FIELD);
        match view {
            Viewpoint::Free(free) => Ok(free.resized(width, height)),
            Viewpoint::Agent(agent) => self.eyes(agent, camera).ok_or_else(|| self.no_body(agent)),
            Viewpoint::Room(room) => self.corner(room, camera),
            Viewpoint::Above(room) => {
                let aabb = self.bounds_of(room)?;
                Ok(above(camera, aabb.min, aabb.max))
            }
            Viewpoint::Overhead => {
                let boxes = self.graph().rooms().iter().filter_map(|r| self.graph().node(*r)?.aabb());
                let all = boxes.map(|b| (b.min, b.max)).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
                let (low, high) = all.unwrap_or((Point3::new(-5.0, -5.0, 0.0), Point3::new(5.0, 5.0, 2.5)));
                Ok(above(camera, low, high))
            }
        }
    }

    /// The box around a room.
    fn bounds_of(&self, room: NodeId) -> Result<Aabb, RenderError<Label>> {
        let node = self.graph().node(room).filter(|n| n.kind() == Kind::Room);
        node.and_then(|n| n.aabb()).ok_or_else(|| self.no_body(room))
    }

    fn no_body(&self, id: NodeId) -> RenderError<Label> {
        RenderError::NoBody(self.graph().label(id))
    }

    fn eyes(&self, agent: NodeId, camera: Camera) -> Option<Camera> {
        let pose = self.graph().node(agent)?.pose()?;
        let mut camera = camera.mounted(&(pose * self.skeleton(agent)?.eyes()));
        camera.near = 0.03;
        Some(camera)
    }

    /// A camera in the corner of a room from which most things in it are seen as the home begins.
    fn corner(&self, room: NodeId, camera: Camera) -> Result<Camera, RenderError<Label>> {
        let bounds = self.bounds_of(room)?;
        let (low, high, middle) = (bounds.min, bounds.max, bounds.centre());
        let target = |eye: &Point3<f32>| {
            let far = (middle.xy() - eye.xy()).norm();
            Point3::new(middle.x, middle.y, (low.z + CORNER.1).max(eye.z - STEEP * far))
        };
        // A thread that panicked left nothing half done here. The lock is not held while pictures are made.
        let known = || self.sight().corners.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(eye) = known().get(&room) {
            return Ok(camera.looking(*eye, target(eye)));
        }
        let base = self.base()?;
        let small = Camera::with_fov(LOOK.0, LOOK.1, FIELD);
        let mut frame = Frame::new();
        let mut best: Option<(f32, Point3<f32>)> = None;
        for (x, y) in [(0, 0), (0, 1), (1, 0), (1, 1), (0, 2), (1, 2), (2, 0), (2, 1)] {
            let along = |i: i32, low: f32, high: f32| match i {
                0 => low + 0.22,
                1 => high - 0.22,
                _ => (low + high) / 2.0,
            };
            let eye = Point3::new(along(x, low.x, high.x), along(y, low.y, high.y), low.z + CORNER.0);
            let small = small.looking(eye, target(&eye));
            base.renderer.render(&Shot::new(&base.snapshot, &small, Modality::Instance), &mut frame)?;
            let score = self.shown(room, &frame) - WEIGHTS[0] * self.blocked(&small);
            if best.is_none_or(|b| score > b.0) {
                best = Some((score, eye));
            }
        }
        let eye = best.map_or(middle, |(_, eye)| eye);
        known().insert(room, eye);
        Ok(camera.looking(eye, target(&eye)))
    }

    /// Which share of a camera's view something is in that is close to it, panes too; the floor does not count.
    fn blocked(&self, camera: &Camera) -> f32 {
        let eye = camera.eye();
        let (graph, world) = self.origin();
        let is_floor = |id: NodeId| graph.node(id).is_some_and(|n| &**n.class() == "floor");
        let at = |i: u32, count: u32, size: u32| (i as f32 + 0.5) * size as f32 / count as f32;
        let rays = (0..RAYS.1).flat_map(|row| (0..RAYS.0).map(move |column| (column, row)));
        let met = |(column, row): &(u32, u32)| {
            let to = camera.unproject(at(*column, RAYS.0, camera.width), at(*row, RAYS.1, camera.height), CLOSE);
            world.ray(eye, to, &[]).is_some_and(|(id, _)| !is_floor(id))
        };
        rays.filter(met).count() as f32 / (RAYS.0 * RAYS.1) as f32
    }

    /// How many things of a room a picture shows, and how much of its floor, less what is beyond the room.
    fn shown(&self, room: NodeId, frame: &Frame) -> f32 {
        let mut seen: Vec<NodeId> = frame.instance.clone();
        let (pixels, graph) = (seen.len().max(1) as f32, self.origin().0);
        let foreign = |id: &&NodeId| graph.room_of(**id) != Some(room);
        let others = seen.iter().filter(foreign).count() as f32 / pixels;
        let is_floor = |id: &&NodeId| graph.node(**id).is_some_and(|n| &**n.class() == "floor") && !foreign(id);
        let floor = (seen.iter().filter(is_floor).count() as f32 / pixels).min(FLOOR);
        seen.sort_unstable();
        seen.dedup();
        let own: Vec<&NodeId> = seen.iter().filter(|id| !foreign(id)).collect();
        let people = own.iter().filter(|id| graph.agents().contains(id)).count() as f32;
        own.len() as f32 + PERSON * people + WEIGHTS[2] * floor - WEIGHTS[1] * others
    }
}

/// Straight down on a box, cut open below the ceiling.
fn above(camera: Camera, low: Point3<f32>, high: Point3<f32>) -> Camera {
    let middle = nalgebra::center(&low, &high);
    let at = Point3::new(middle.x, middle.y, low.z + CUT);
    let aspect = camera.width as f32 / camera.height.max(1) as f32;
    // North is to the right where the box is longer that way.
    let span = ((high.x - low.x) + 0.6).max(((high.y - low.y) + 0.6) / aspect);
    let mut camera = camera.overhead(at, span);
    let up = camera.pose.translation.z - at.z;
    camera.near = up.max(0.01);
    camera
}
