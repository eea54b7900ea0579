//! Where cameras of an environment are.

use nalgebra::{Point3, Translation3};
use vc_graph::{Aabb, Anthropometry, Label, NodeId, NodeKind, ObjectRole, SceneGraph};
use vc_render::{Camera, Frame, Modality, RenderError, Shot};

use super::{CameraError, CameraId, Lens, Mount, PictureError};
use crate::Environment;

/// Vertical field of view of eyes and of cameras in rooms unless the options say otherwise, radians.
pub(super) const FIELD: f32 = 1.15;
/// The height up to which eyes may be set, metres.
const HIGHEST_EYES: f32 = 10.0;
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
/// Pixels of the pictures by which it is found how well somebody is seen, those of a body that is seen well, and how
/// much that counts, as things.
pub(crate) const GLANCE: (u32, u32) = (80, 60);
const SEEN: f32 = 60.0;
const WITNESS: f32 = 100.0;

/// Where a camera is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Viewpoint {
    /// An agent's eyes. They look ahead; at what it acted on last, however low, while that is right before it.
    Agent(NodeId),
    /// Fixed in a room, in the corner from which most of it is seen as the home begins.
    Room(NodeId),
    /// Above a room, its ceiling taken off.
    Above(NodeId),
    /// Above the whole home, ceilings taken off.
    Overhead,
    /// Anywhere; [resized](Camera::resized) to the width and height asked for.
    Free(Camera),
    /// A camera of the environment by its number: [`Environment::cameras`].
    Camera(CameraId),
}

impl From<CameraId> for Viewpoint {
    fn from(id: CameraId) -> Self {
        Self::Camera(id)
    }
}

impl Viewpoint {
    /// The viewpoint in words, with labels: `eyes of character.460`, `in kitchen.1`, `overhead`.
    pub fn describe(&self, graph: &SceneGraph) -> String {
        match self {
            Self::Agent(agent) => format!("eyes of {}", graph.label(*agent)),
            Self::Room(room) => format!("in {}", graph.label(*room)),
            Self::Above(room) => format!("above {}", graph.label(*room)),
            Self::Overhead => "overhead".into(),
            Self::Camera(id) => id.to_string(),
            Self::Free(camera) => {
                let at = camera.pose.translation;
                format!("at {:.2} {:.2} {:.2}", at.x, at.y, at.z)
            }
        }
    }
}

impl Environment {
    /// The camera of a viewpoint, for pictures of a size in pixels: `Camera::mounted` on an agent's
    /// eyes, `Camera::looking` from a corner of a room, `Camera::overhead`, `Camera::resized`.
    ///
    /// # Errors
    /// [`CameraError::NotAnAgent`] for the eyes or hands of something else, [`RenderError::NoRoom`] for a view of
    /// something else than a room, [`RenderError::NoBody`] for an agent or thing without a body,
    /// [`CameraError::NoSuchNumber`].
    pub fn camera(&self, view: Viewpoint, width: u32, height: u32) -> Result<Camera, PictureError> {
        if let Viewpoint::Free(free) = view {
            return Ok(free.resized(width, height));
        }
        let (mount, lens) = self.mount_of(view)?;
        self.mounted(&mount, lens.camera(&self.pictures, width, height))
    }

    /// The mount and lens of every viewpoint but a free one.
    fn mount_of(&self, view: Viewpoint) -> Result<(Mount, Lens), PictureError> {
        match (view, Mount::of(view)) {
            (_, Some(mount)) => Ok((mount, Lens::Options)),
            (Viewpoint::Camera(id), None) => Ok(self.device(id).ok_or_else(|| CameraError::unknown(id))?),
            (_, None) => Err(PictureError::Render(RenderError::BadCamera("viewpoint is free"))),
        }
    }

    /// Whether a view is from above rooms whose ceilings are taken off.
    pub(crate) fn is_plan(&self, view: Viewpoint) -> bool {
        self.mount_of(view).is_ok_and(|(mount, _)| mount.is_plan())
    }

    /// A camera straight above a room.
    pub(super) fn above(&self, room: NodeId, lens: Camera) -> Result<Camera, PictureError> {
        let aabb = self.bounds_of(room)?;
        Ok(above(lens, aabb.min, aabb.max))
    }

    /// A camera straight above the home.
    pub(super) fn overhead(&self, lens: Camera) -> Camera {
        let boxes = self.graph().rooms().iter().filter_map(|r| self.graph().node(*r)?.aabb());
        let all = boxes.map(|b| (b.min, b.max)).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
        let (low, high) = all.unwrap_or((Point3::new(-5.0, -5.0, 0.0), Point3::new(5.0, 5.0, 2.5)));
        above(lens, low, high)
    }

    /// The box around a room.
    pub(super) fn bounds_of(&self, room: NodeId) -> Result<Aabb, RenderError<Label>> {
        let node = self.graph().node(room).filter(|n| n.kind() == NodeKind::Room);
        node.and_then(|n| n.aabb()).ok_or_else(|| RenderError::NoRoom(self.graph().label(room)))
    }

    /// How far the eyes of a figure are raised so that they are as high as the options say.
    pub(super) fn raised_eyes(&self) -> Result<Translation3<f32>, PictureError> {
        let Some(height) = self.pictures.eye_height else { return Ok(Translation3::identity()) };
        if !(height > 0.0 && height <= HIGHEST_EYES) {
            return Err(RenderError::<Label>::BadCamera("eye height is to be above 0 and at most 10 metres").into());
        }
        Ok(Translation3::new(0.0, 0.0, height - Anthropometry::ADULT.view))
    }

    /// A camera in the corner of a room from which most things in it are seen as the home begins.
    pub(super) fn corner(&self, room: NodeId, camera: Camera) -> Result<Camera, PictureError> {
        let places = self.places(room, camera)?;
        // A thread that panicked left nothing half done here. The lock is not held while pictures are made.
        let known = || self.picture_cache().corners.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(place) = known().get(&room) {
            return Ok(places[*place]);
        }
        let base = self.base()?;
        let mut frame = Frame::new();
        let mut scores = Vec::new();
        for small in self.places(room, Camera::with_fov(LOOK.0, LOOK.1, FIELD))? {
            base.renderer.render(&Shot::new(&base.stage.snapshot, &small, Modality::Instance), &mut frame)?;
            scores.push(self.shown(room, &frame) - WEIGHTS[0] * self.blocked(&small));
        }
        let best = first_best(&scores);
        known().insert(room, best);
        Ok(places[best])
    }

    /// A camera in a corner of a room, or in the middle of a wall, from which an agent is seen best as the home is now:
    /// all of it, large enough, and much of the room around it.
    pub(crate) fn witness(&self, agent: NodeId, room: NodeId, size: (u32, u32)) -> Result<Camera, PictureError> {
        let places = self.places(room, Camera::with_fov(size.0, size.1, FIELD))?;
        let mut scores = Vec::new();
        for camera in &places {
            let frame = self.render(Viewpoint::Free(*camera), Modality::Instance, GLANCE.0, GLANCE.1)?;
            let view = self.shown(room, &frame) - WEIGHTS[0] * self.blocked(camera);
            scores.push(WITNESS * sight_of(&frame, agent) + view);
        }
        Ok(places[first_best(&scores)])
    }

    /// Cameras in the corners of a room and in the middles of its walls, which look across it.
    fn places(&self, room: NodeId, camera: Camera) -> Result<[Camera; 8], RenderError<Label>> {
        let bounds = self.bounds_of(room)?;
        let (low, high, middle) = (bounds.min, bounds.max, bounds.centre());
        let target = |eye: &Point3<f32>| {
            let far = (middle.xy() - eye.xy()).norm();
            Point3::new(middle.x, middle.y, (low.z + CORNER.1).max(eye.z - STEEP * far))
        };
        let along = |i: i32, low: f32, high: f32| match i {
            0 => low + 0.22,
            1 => high - 0.22,
            _ => (low + high) / 2.0,
        };
        Ok([(0, 0), (0, 1), (1, 0), (1, 1), (0, 2), (1, 2), (2, 0), (2, 1)].map(|(x, y)| {
            let eye = Point3::new(along(x, low.x, high.x), along(y, low.y, high.y), low.z + CORNER.0);
            camera.looking(eye, target(&eye))
        }))
    }

    /// Which share of a camera's view something is in that is close to it, panes too; the floor does not count.
    fn blocked(&self, camera: &Camera) -> f32 {
        let eye = camera.eye();
        let (graph, world) = self.origin();
        let is_floor = |id: NodeId| graph.node(id).is_some_and(|n| n.role() == ObjectRole::Floor);
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
        let is_floor = |id: &&NodeId| graph.node(**id).is_some_and(|n| n.role() == ObjectRole::Floor) && !foreign(id);
        let floor = (seen.iter().filter(is_floor).count() as f32 / pixels).min(FLOOR);
        seen.sort_unstable();
        seen.dedup();
        let own: Vec<&NodeId> = seen.iter().filter(|id| !foreign(id)).collect();
        let people = own.iter().filter(|id| graph.agents().contains(id)).count() as f32;
        own.len() as f32 + PERSON * people + WEIGHTS[2] * floor - WEIGHTS[1] * others
    }
}

/// How well a picture of [`GLANCE`] shows somebody, 0 to 1: it is large enough, and half as well if the border cuts
/// it off.
pub(crate) fn sight_of(frame: &Frame, who: NodeId) -> f32 {
    let (width, height) = (frame.width, frame.height);
    let pixels = || (0..frame.instance.len()).filter(|i| frame.instance[*i] == who).map(|i| (i % width, i / width));
    let inside = |(x, y): (usize, usize)| x > 0 && y > 0 && x + 1 < width && y + 1 < height;
    let large = (pixels().count() as f32 / SEEN).min(1.0);
    if pixels().all(inside) { large } else { 0.5 * large }
}

/// The position of the highest score, the first of equal ones.
fn first_best(scores: &[f32]) -> usize {
    (1..scores.len()).fold(0, |best, i| if scores[i] > scores[best] { i } else { best })
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::{Action, Verb};

    use super::*;

    /// Wherever an agent stands, a camera that looks for it sees it.
    #[test]
    fn witnesses_see_agents() {
        let mut home = Environment::make("apartment/44756", 1).unwrap();
        let me = home.agents()[0];
        let (mut seen, mut all) = (0, 0);
        for class in ["fridge", "stove", "sofa", "double_bed", "washbasin", "wardrobe"] {
            let Some(at) = home.graph().of_class(class).first().copied() else { continue };
            if home.set_action(me, Action::one(Verb::Walk, at)).is_err() {
                continue;
            }
            let room = home.graph().room_of(me).unwrap();
            let sight = |view| sight_of(&home.render(view, Modality::Instance, GLANCE.0, GLANCE.1).unwrap(), me);
            let (own, best) = (sight(Viewpoint::Room(room)), home.witness(me, room, (160, 120)).unwrap());
            let best = sight(Viewpoint::Free(best));
            assert!(best >= own.min(0.5), "{class}: {best} instead of {own}");
            (seen, all) = (seen + usize::from(best >= 1.0), all + 1);
        }
        assert!(all > 3 && seen + 1 >= all, "seen whole in {seen} of {all} places");
    }
}
