//! What cameras see of an environment.

mod light;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, OnceLock};

use nalgebra::Point3;
use vc_graph::asset::Joint;
use vc_graph::{Aabb, Kind, Node, NodeId, Pose, Property, Relation, State};
use vc_physics::Role;
use vc_render::{Camera, Coat, Daylight, Frame, Lighting, Modalities, Modality, RenderError, Renderer, Shot, Snapshot};

use self::light::{Lit, lit, switch};
use crate::Environment;
use crate::environment::position;
use crate::figure::{Bone, clothes};

/// Vertical field of view of eyes and of cameras in rooms, radians.
const FIELD: f32 = 1.15;
/// Height above the floor at which a view from above cuts the home open, metres.
const CUT: f32 = 2.1;
/// Pixels of the pictures by which corners are compared.
const LOOK: (u32, u32) = (64, 48);
/// Height of cameras in corners above the floor, and of what they look at, metres.
const CORNER: (f32, f32) = (2.05, 0.8);

/// Categories of what lets light in.
const OPENINGS: [&str; 2] = ["door", "window"];
/// Where a camera is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Viewpoint {
    /// An agent's eyes.
    Agent(NodeId),
    /// Fixed in a room: of its corners the one from which most of it is seen as the home begins.
    Room(NodeId),
    /// Above a room, its ceiling taken off.
    Above(NodeId),
    /// Above the whole home, ceilings taken off.
    Overhead,
    /// Anywhere; [resized](Camera::resized) to the width and height asked for.
    Free(Camera),
}

/// Uploaded meshes and the light, made when first asked for and shared by clones.
#[derive(Debug, Default)]
pub(crate) struct Sight {
    base: OnceLock<Result<Base, RenderError>>,
    /// Light that was made, the last one first.
    light: Mutex<Vec<(Lit, Lighting)>>,
    /// Where cameras in rooms are.
    corners: Mutex<BTreeMap<NodeId, Point3<f32>>>,
}

#[derive(Debug)]
struct Base {
    renderer: Renderer,
    snapshot: Snapshot,
    poses: Vec<(NodeId, Pose)>,
    /// Whatever can be seen.
    seen: Vec<NodeId>,
    /// What of it is not fixed.
    loose: BTreeSet<NodeId>,
    lit: Vec<NodeId>,
    /// What can be poured into, and whether something is in it.
    vessels: Vec<(NodeId, bool)>,
    /// Nodes with moving parts.
    jointed: Vec<NodeId>,
    /// Those of them that let light into rooms.
    openings: Vec<NodeId>,
    /// Blinds, curtains and what else covers and can be opened.
    covers: Vec<NodeId>,
}

impl Environment {
    /// A picture of the environment as it is: `Renderer::render` of its
    /// [`snapshot`](Self::snapshot). Changes nothing.
    ///
    /// Meshes are uploaded and light is made when a picture is first asked for. Light is that of
    /// the home as it begins, made again when something was switched, when a door between rooms
    /// or a window comes to stand open or shut, or when a blind or a curtain is drawn: some tenths of a second, the last
    /// few are kept. What else moves, furniture and people too, is lit where it is and is seen in mirrors, but throws its light
    /// and its shadow on others from where it stood, so that no picture costs more because something moved:
    /// [`render_relit`](Self::render_relit) makes light of all that has moved. Optical flow needs a second moment: see
    /// [`render_until`](Self::render_until).
    ///
    /// # Errors
    /// [`RenderError`]: a bad size, no such node, or flow, for which there is no second
    /// moment.
    pub fn render(
        &self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, RenderError> {
        self.picture(None, view, wanted.into(), width, height, Self::lighting)
    }

    /// As [`render`](Self::render), with light that is made for where everything is now: shadows of furniture and people
    /// that have moved, and what rooms throw back, follow. Takes some tenths of a second for every picture with colours,
    /// and nothing is kept; without colours it is `render`.
    ///
    /// ```no_run
    /// use virtualcity::{Environment, Viewpoint, render::Modality};
    /// let home = Environment::make("apartment/42", 1)?;
    /// let room = home.graph().rooms()[0];
    /// let still = home.render_relit(Viewpoint::Room(room), Modality::Rgb, 640, 480)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`render`](Self::render).
    pub fn render_relit(
        &self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, RenderError> {
        let anew = |home: &Self, now: &Snapshot| Ok(home.base()?.renderer.light(now, &Daylight::noon()));
        self.picture(None, view, wanted.into(), width, height, anew)
    }

    /// As [`render`](Self::render), with the optical flow from this moment to a later one of
    /// the same environment: of the camera, of bodies and of every limb.
    ///
    /// # Errors
    /// As [`render`](Self::render); [`RenderError::OtherScene`] if things were added or
    /// removed in between.
    pub fn render_until(
        &self,
        later: &Self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, RenderError> {
        self.picture(Some(later), view, wanted.into(), width, height, Self::lighting)
    }

    fn picture(
        &self,
        later: Option<&Self>,
        view: Viewpoint,
        wanted: Modalities,
        width: u32,
        height: u32,
        light: impl Fn(&Self, &Snapshot) -> Result<Lighting, RenderError>,
    ) -> Result<Frame, RenderError> {
        let base = self.base()?;
        let (snapshot, camera) = (self.snapshot()?, self.camera(view, width, height)?);
        let then = later.map(|l| Ok::<_, RenderError>((l.snapshot()?, l.camera(view, width, height)?))).transpose()?;
        let lighting = if wanted.has(Modality::Rgb) { Some(light(self, &snapshot)?) } else { None };
        let mut shot = Shot::new(&snapshot, &camera, wanted);
        shot.lighting = lighting.as_ref();
        if let Some((snapshot, camera)) = &then {
            shot = shot.after(snapshot, camera);
        }
        let mut frame = Frame::new();
        base.renderer.render(&shot, &mut frame)?;
        Ok(frame)
    }

    /// The environment as it is for the renderer: `Renderer::snapshot_with` once, then
    /// `Snapshot::place`, `articulate`, `arrange`, `switch`, `coat`, `fill`, `draw` and `hide` of what differs.
    ///
    /// # Errors
    /// [`RenderError`] if something has no sound pose or no shape.
    pub fn snapshot(&self) -> Result<Snapshot, RenderError> {
        let base = self.base()?;
        let mut snapshot = base.snapshot.clone();
        for (id, was) in &base.poses {
            let now = self.graph().node(*id).and_then(|n| n.pose());
            if let Some(now) = now.filter(|now| *now != was) {
                snapshot.place(*id, now)?;
            }
        }
        switch(&mut snapshot, &base.lit, &lit(self.graph()))?;
        for node in &base.seen {
            // Dirt comes and goes.
            if let Some(node) = self.graph().node(*node) {
                snapshot.coat(node.id(), Coat::of(node))?;
            }
        }
        for (id, _) in &base.vessels {
            let contents = self.graph().node(*id).and_then(|n| n.contents());
            snapshot.fill(*id, contents.map(AsRef::as_ref))?;
        }
        for id in &base.covers {
            snapshot.draw(*id, self.graph().node(*id).is_some_and(|n| n.is(State::Closed)))?;
        }
        for id in &base.jointed {
            snapshot.articulate(*id, |joint| position(self.graph(), self.world(), *id, joint))?;
        }
        for &agent in self.agents() {
            if let Some(skeleton) = self.skeleton(agent) {
                snapshot.arrange(agent, |joint| Some(skeleton.motion(Bone::of(joint)?)))?;
            }
            for worn in self.graph().relating(Relation::WornBy, agent).filter_map(|id| self.graph().node(id)) {
                let colour = clothes::colour(self.graph().assets(), worn).unwrap_or([0.5; 3]);
                let coat = Coat { colour, share: 1.0, roughness: 1.0 };
                let on = |joint: &Joint| Bone::of(joint).filter(|b| clothes::covers(worn.class(), *b)).map(|_| coat);
                snapshot.coat_links(agent, on)?;
                snapshot.hide(worn.id(), true)?;
            }
        }
        Ok(snapshot)
    }

    /// The camera of a viewpoint, for pictures of a size in pixels: `Camera::mounted` on an agent's
    /// eyes, `Camera::looking` from a corner of a room, `Camera::overhead`, `Camera::resized`.
    ///
    /// # Errors
    /// [`RenderError::NoBody`] if there is no such agent or room.
    pub fn camera(&self, view: Viewpoint, width: u32, height: u32) -> Result<Camera, RenderError> {
        let camera = Camera::with_fov(width, height, FIELD);
        match view {
            Viewpoint::Free(free) => Ok(free.resized(width, height)),
            Viewpoint::Agent(agent) => self.eyes(agent, camera).ok_or(RenderError::NoBody(agent)),
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

    fn base(&self) -> Result<&Base, RenderError> {
        let base = self.sight().base.get_or_init(|| Base::of(self));
        base.as_ref().map_err(Clone::clone)
    }

    /// The box around a room.
    fn bounds_of(&self, room: NodeId) -> Result<Aabb, RenderError> {
        let node = self.graph().node(room).filter(|n| n.kind() == Kind::Room);
        node.and_then(|n| n.aabb()).ok_or(RenderError::NoBody(room))
    }

    fn eyes(&self, agent: NodeId, camera: Camera) -> Option<Camera> {
        let pose = self.graph().node(agent)?.pose()?;
        let mut camera = camera.mounted(&(pose * self.skeleton(agent)?.eyes()));
        camera.near = 0.03;
        Some(camera)
    }

    /// Of the corners of a room the one from which most things in it are seen as the home begins.
    fn corner(&self, room: NodeId, camera: Camera) -> Result<Camera, RenderError> {
        let bounds = self.bounds_of(room)?;
        let (low, high, middle) = (bounds.min, bounds.max, bounds.centre());
        let target = Point3::new(middle.x, middle.y, low.z + CORNER.1);
        // A thread that panicked left nothing half done here.
        let mut known = self.sight().corners.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(eye) = known.get(&room) {
            return Ok(camera.looking(*eye, target));
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
            let small = small.looking(eye, target);
            base.renderer
                .render(&Shot::new(&base.snapshot, &small, Modality::Instance | Modality::Depth), &mut frame)?;
            let score = self.shown(room, &frame);
            if best.is_none_or(|b| score > b.0) {
                best = Some((score, eye));
            }
        }
        let eye = best.map_or(target, |(_, eye)| eye);
        known.insert(room, eye);
        Ok(camera.looking(eye, target))
    }

    /// How many things of a room a picture shows, less what is in the way.
    fn shown(&self, room: NodeId, frame: &Frame) -> f32 {
        let mut seen: Vec<NodeId> = frame.instance.clone();
        let (pixels, graph) = (seen.len().max(1) as f32, self.origin().0);
        let foreign = |id: &&NodeId| graph.room_of(**id) != Some(room);
        let others = seen.iter().filter(foreign).count() as f32 / pixels;
        let close = frame.depth.iter().filter(|d| **d < 0.7).count() as f32 / pixels;
        seen.sort_unstable();
        seen.dedup();
        let own = seen.iter().filter(|id| !foreign(id)).count() as f32;
        own - 60.0 * close - 20.0 * others
    }
}

impl Base {
    fn of(environment: &Environment) -> Result<Self, RenderError> {
        let (graph, world) = environment.origin();
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot_with(graph, |id, joint| position(graph, world, id, joint))?;
        let body = |n: &&Node| n.kind() != Kind::Room;
        let poses = graph.nodes().filter(body).filter_map(|n| Some((n.id(), *n.pose()?)));
        let seen: Vec<NodeId> = snapshot.nodes().collect();
        let poses = poses.filter(|(id, _)| seen.binary_search(id).is_ok()).collect();
        let fixed = |id: &NodeId| world.role(*id) == Some(Role::Fixed);
        let loose = seen.iter().copied().filter(|id| !fixed(id)).collect();
        let jointed: Vec<NodeId> = world.nodes().into_iter().filter(|id| !world.moving_parts(*id).is_empty()).collect();
        let lets_in = |id: &NodeId| graph.node(*id).is_some_and(|n| OPENINGS.contains(&&*n.spec().category));
        let openings = jointed.iter().copied().filter(lets_in).collect();
        let node = |id: &NodeId| graph.node(*id).filter(|n| n.affords(Property::Recipient));
        let vessels = seen.iter().filter_map(|id| Some((*id, node(id)?.contents().is_some()))).collect();
        let is_cover =
            |id: &NodeId| graph.node(*id).is_some_and(|n| n.affords(Property::Cover) && n.affords(Property::Openable));
        let covers = seen.iter().copied().filter(is_cover).collect();
        Ok(Self { lit: lit(graph), renderer, snapshot, poses, seen, loose, vessels, jointed, openings, covers })
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
