//! Viewpoints that show a room well.

use nalgebra::Point3;
use vc_graph::{ClassTable, NodeId, ObjectRole};

use super::Renderer;
use crate::RenderError;
use crate::camera::Camera;
use crate::frame::Frame;
use crate::math;
use crate::modality::{Modality, NOTHING};
use crate::scene::{Instance, Snapshot};
use crate::shot::Shot;

/// Height of the camera above the floor, metres: that of photographs of rooms, in which uprights stay upright as the camera
/// is level and its principal point moves instead.
const EYE: f32 = 1.3;
/// Where the horizon may lie, as parts of the picture's height from the top.
const HORIZONS: [f32; 4] = [0.42, 0.28, 0.16, 0.04];
/// Distance that the camera keeps from the walls, metres.
const OFF: f32 = 0.3;
/// Distance to keep from the boxes of things, metres, and the score of places that are nearer than this.
const CLEAR: f32 = 0.1;
const WITHIN: f32 = -1e3;
/// Surfaces farther away than this show a room, metres.
const FAR: f32 = 2.2;
/// The distance within which one surface must not fill much of a picture, metres, the share that it may fill, and the
/// penalty for what it fills beyond that.
const NEAR: f32 = 1.5;
const FILLED: f32 = 0.12;
const WALLED: f32 = 120.0;
/// Candidate places along each wall.
const PLACES: usize = 5;
/// Share of a picture that windows of the room should fill, and the factor by which their light adds to the
/// score of things.
const WINDOWS: f32 = 0.03;
const DAYLIGHT: f32 = 0.7;
/// The part of a picture that a piece of furniture should fill, and the factor by which what they fill adds to a score: most of all that
/// which tells the purpose of a room.
const SHOWN: f32 = 0.08;
const FURNISHED: f32 = 30.0;
const PURPOSE: f32 = 110.0;
const PURPOSES: [&str; 10] =
    ["bed", "sofa", "dining_table", "desk", "stove", "sink", "toilet", "bathtub", "shower", "television"];
/// Longer side of the pictures in which candidates are compared, pixels.
const SIDE: f32 = 80.0;

impl Renderer {
    /// Finds a camera in a room that shows most of it, as a photograph does: level, 1.3 m above the floor, with the principal
    /// point above the middle of the picture, so that uprights stay upright and the floor is seen. The candidates are places in the
    /// room's corners and along its walls, looking past the middle of the room or along a wall. The best one sees
    /// most things of the room and its furniture at a good size, is far from what it sees, has a window in view, and has little in
    /// view that stands close before it, fills much of the picture from nearby, or belongs to other rooms. It is inside a
    /// thing's box only where there is no other place. All but the pose and the height of the principal point is taken from
    /// `camera`.
    ///
    /// The room must have a box in the graph. The search costs 256 renderings of ids and depth, 80 pixels
    /// across.
    ///
    /// # Errors
    /// [`RenderError::NoRoom`], [`RenderError::BadSize`], [`RenderError::BadCamera`],
    /// [`RenderError::OtherRenderer`].
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Renderer};
    ///
    /// let mut scene = SceneBuilder::new("flat");
    /// let size = Bounds::standing(Vector3::new(4.0, 3.0, 2.5));
    /// let kitchen = scene.add(Draft::new("kitchen").at(Pose::identity()).bounds(size))?;
    /// let tall = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(1.6, 0.0, 0.0)).bounds(tall))?;
    ///
    /// let mut renderer = Renderer::new();
    /// let snapshot = renderer.snapshot(&scene.build())?;
    /// let camera = renderer.viewpoint(&snapshot, kitchen, &Camera::with_fov(640, 480, 1.15))?;
    /// assert!(camera.eye().x.abs() < 2.0 && camera.eye().y.abs() < 1.5);
    /// assert_eq!(camera.width, 640);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn viewpoint(&self, snapshot: &Snapshot, room: NodeId, camera: &Camera) -> Result<Camera, RenderError> {
        camera.check()?;
        let number = snapshot.rooms.iter().position(|r| *r == room).ok_or(RenderError::NoRoom(room))?;
        let around = snapshot.bounds[number].ok_or(RenderError::NoRoom(room))?;
        let small = coarse(camera);
        let mut frame = Frame::new();
        let mut best: Option<(f32, Camera)> = None;
        for eye in eyes(&around.min, &around.max) {
            let place = if is_free(snapshot, eye) { 0.0 } else { WITHIN };
            let views = targets(eye, around.centre()).into_iter().flat_map(|at| HORIZONS.map(|horizon| (at, horizon)));
            for (at, horizon) in views {
                let view = level(&small, eye, at, horizon);
                self.render(&Shot::new(snapshot, &view, Modality::Instance | Modality::Depth), &mut frame)?;
                let score = place + score(snapshot, number as u16, &frame);
                if best.is_none_or(|b| score > b.0) {
                    best = Some((score, view));
                }
            }
        }
        let full = |view: Camera| {
            let down = view.centre.1 * camera.height as f32 / view.height as f32;
            Camera { pose: view.pose, centre: (camera.centre.0, down), ..*camera }
        };
        best.map(|(_, view)| full(view)).ok_or(RenderError::NoRoom(room))
    }
}

/// A camera that looks level from a place towards a point of the plan, with its horizon at a part of the picture's height.
fn level(camera: &Camera, eye: Point3<f32>, at: [f32; 2], horizon: f32) -> Camera {
    let view = camera.looking(eye, Point3::new(at[0], at[1], eye.z));
    Camera { centre: (view.centre.0, horizon * view.height as f32), ..view }
}

/// The same view at a low resolution.
fn coarse(camera: &Camera) -> Camera {
    let by = SIDE / camera.width.max(camera.height) as f32;
    let side = |pixels: u32| ((pixels as f32 * by) as u32).max(1);
    Camera {
        width: side(camera.width),
        height: side(camera.height),
        focal: (camera.focal.0 * by, camera.focal.1 * by),
        centre: (camera.centre.0 * by, camera.centre.1 * by),
        ..*camera
    }
}

/// Candidate camera positions in the corners of a box and along its walls.
fn eyes(low: &Point3<f32>, high: &Point3<f32>) -> impl Iterator<Item = Point3<f32>> {
    let (low, high, last) = (*low, *high, PLACES - 1);
    let place = move |k: usize, low: f32, high: f32| {
        // Narrow rooms use their middle.
        let off = OFF.min(0.5 * (high - low));
        low + off + k as f32 / last as f32 * (high - low - 2.0 * off)
    };
    let all = (0..PLACES * PLACES).map(|i| (i / PLACES, i % PLACES));
    let outer = all.filter(move |(i, j)| i % last == 0 || j % last == 0);
    outer.map(move |(i, j)| Point3::new(place(i, low.x, high.x), place(j, low.y, high.y), low.z + EYE))
}

/// Whether a position is neither inside a thing nor right before one.
fn is_free(snapshot: &Snapshot, eye: Point3<f32>) -> bool {
    let within = |instance: &Instance| {
        let (bounds, own) = (&instance.link.levels[0].bounds, math::point(&instance.inverse, eye.into()));
        (0..3).all(|k| (own[k] - bounds.centre[k]).abs() <= bounds.half[k] + CLEAR)
    };
    !snapshot.instances.iter().any(within)
}

/// Points to look at from a position: the middle, a little beyond it, and along the walls, for rooms that are
/// not convex and whose middle lies in another room.
fn targets(eye: Point3<f32>, middle: Point3<f32>) -> [[f32; 2]; 4] {
    let beyond = middle + (middle - eye) * 0.35;
    [[middle.x, middle.y], [beyond.x, beyond.y], [middle.x, eye.y], [eye.x, middle.y]]
}

/// Score of a view: the number of visible things of the room, weighted up by windows, plus the share that is
/// far away, minus what stands in the way, fills much of the picture, or belongs to other rooms. The open sky belongs
/// to none.
fn score(snapshot: &Snapshot, room: u16, frame: &Frame) -> f32 {
    let mine = |n: &NodeId| snapshot.body_of(*n).is_some_and(|body| body.room == room);
    let is_window = |n: &&NodeId| snapshot.body_of(**n).is_some_and(|body| body.role == ObjectRole::Window);
    let mut seen: Vec<NodeId> = frame.instance.iter().copied().filter(mine).collect();
    let pixels = frame.depth.len() as f32;
    let sky = frame.instance.iter().filter(|n| **n == NOTHING).count();
    let foreign = (frame.instance.len() - seen.len() - sky) as f32 / pixels;
    let windows = seen.iter().filter(is_window).count() as f32 / pixels;
    let daylight = 1.0 + DAYLIGHT * (windows / WINDOWS).min(1.0);
    seen.sort_unstable();
    let shown: f32 =
        seen.chunk_by(|a, b| a == b).map(|same| purpose(snapshot, same[0], same.len() as f32 / pixels)).sum();
    seen.dedup();
    // At the sides of the picture walls are near where rooms are narrow, but they hide nothing there.
    let middle = frame.width / 4..frame.width - frame.width / 4;
    let ahead = || frame.depth.chunks(frame.width).flat_map(|row| &row[middle.clone()]);
    let nearer = |than: f32| ahead().filter(|d| **d < than).count() as f32 / ahead().count().max(1) as f32;
    let far = 1.0 - nearer(FAR);
    seen.len() as f32 * daylight + 12.0 * far + shown
        - 60.0 * nearer(0.7)
        - 15.0 * nearer(1.3)
        - 25.0 * foreign
        - WALLED * (walled(frame) - FILLED).max(0.0)
}

/// The score of the part of a picture that a thing fills, up to that which shows it well, if it is furniture.
fn purpose(snapshot: &Snapshot, node: NodeId, part: f32) -> f32 {
    let Some(body) = snapshot.body_of(node) else { return 0.0 };
    let classes = ClassTable::builtin();
    let class = snapshot.class(body.class).map_or("", |name| &**name);
    let weight = match () {
        () if PURPOSES.iter().any(|purpose| classes.is_a(class, purpose)) => PURPOSE,
        () if body.role == ObjectRole::Furniture => FURNISHED,
        () => 0.0,
    };
    weight * part.min(SHOWN)
}

/// The share of a picture that the part of one thing fills that is near.
fn walled(frame: &Frame) -> f32 {
    let near = frame.instance.iter().zip(&frame.depth).filter(|(_, depth)| **depth < NEAR);
    let mut near: Vec<NodeId> = near.map(|(id, _)| *id).collect();
    near.sort_unstable();
    let most = near.chunk_by(|a, b| a == b).map(<[NodeId]>::len).max().unwrap_or(0);
    most as f32 / frame.depth.len().max(1) as f32
}
