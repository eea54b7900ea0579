//! The light in a scene, made once and kept while nothing moves that matters.

use std::sync::Arc;

use arrayvec::ArrayVec;
use nalgebra::Point3;

use super::ambient::Ambient;
use super::grid::Grid;
use super::lamp::{Lamp, Shining, lamps};
use super::shadow::ShadowMap;
use super::{Daylight, extent::rooms, room};
use crate::RenderError;
use crate::affine::{scaled, three};
use crate::camera::STREWN;
use crate::renderer::Renderer;
use crate::scene::{Snapshot, Store};
use crate::surface::{Role, Surface};
use crate::trace::Tracer;

/// Light in a scene at one moment: shadow maps of the sun and the lamps that are on, and
/// the light that rooms throw back. Made by [`Renderer::light`], good for any number
/// of cameras, cheap to clone; when lamps are switched, or doors, blinds and large things move, [`Renderer::relight`]
/// brings it up to date.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// // The light of two moments, both kept.
/// let mut moved = snapshot.clone();
/// moved.place(fridge, &Pose::translation(2.5, 0.0, 0.0))?;
/// let before = renderer.light(&snapshot, &Daylight::overcast());
/// let mut after = before.clone();
/// renderer.relight(&mut after, &moved)?;
/// let mut frame = Frame::new();
/// for (snapshot, lighting) in [(&snapshot, &before), (&moved, &after)] {
///     renderer.render(&Shot::new(snapshot, &camera, Modality::Rgb).lit(lighting), &mut frame)?;
///     assert_eq!(frame.rgb.len(), 64 * 48);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Lighting {
    pub(crate) daylight: Daylight,
    pub(crate) tracer: Tracer,
    // What is large is shared by clones.
    pub(crate) sun: Option<Arc<ShadowMap>>,
    pub(crate) lamps: Arc<Vec<Lamp>>,
    /// By body: what its glow and its shade's glow are multiplied with.
    pub(super) gains: Vec<[f32; 2]>,
    /// By body that glows and is no lamp, how much the brightest of it is to be turned up.
    pub(super) screens: Vec<(u32, f32)>,
    pub(super) grids: Arc<Vec<Grid>>,
    /// By room, what share of the sun's light panes leave.
    pub(super) sunlight: Vec<f32>,
    /// By body, what comes through drawn covers.
    pub(super) cloth: Vec<(u32, [f32; 3])>,
    /// Boxes of rooms, to tell in which an eye is.
    pub(super) rooms: Vec<([f32; 3], [f32; 3])>,
    /// The moment whose shadows these are.
    pub(super) cast: Arc<Snapshot>,
}

/// How far a picture's white is that of the light in its room: lamps stay warm, and do not make all yellow.
const BALANCE: f32 = 0.6;
/// How many times brighter than the mean of all rooms in view a room counts at most.
const BRIGHTER: f32 = 4.0;
/// Levels of light below which an eye does not adapt: in rooms, and outside.
const DARK: [f32; 2] = [1e-7, 5e-4];
/// The level of light below which an eye adapts to a part only, so that what is dim looks dim, and to which part.
const DIM: f32 = 0.01;
const PART: f32 = 0.75;
/// A level of light below this part of the mean of all in view is as good as black: no eye gets used to it.
const BLACK: f32 = 1e-3;
/// The brightest that a screen is shown, as often as middle grey: an eye that looks at it gets used to it.
const SCREEN: f32 = 1.6;

/// How bright a colour is to the eye (Rec. 709).
#[inline(always)]
pub(crate) fn brightness([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

impl Renderer {
    /// The light in a scene: about a microsecond a triangle for the tree of rays, tens of milliseconds for
    /// shadows, and some for each room; of a home of 130,000 triangles 0.4 seconds on two processors
    /// (`benches/README.md`).
    ///
    /// Light from all sides is kept as ambient cubes (McTaggart 2004) on a grid in each room, found by rays to all
    /// sides, and thrown on between the places that these meet. The tree of rays is cut by the surface area heuristic
    /// over bins (Wald 2007).
    ///
    /// Of a snapshot of another renderer, or by a daylight of numbers that are not finite, there is no light:
    /// what is made then says so when it is used.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// # let snapshot = renderer.snapshot(&scene)?;
    /// // Made once, for any number of cameras.
    /// let lighting = renderer.light(&snapshot, &Daylight::noon());
    /// let mut frame = Frame::new();
    /// for camera in Camera::with_fov(64, 48, 1.0).around(Point3::new(2.0, 0.0, 1.0), 3.0, 0.3, 2) {
    ///     renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame)?;
    ///     assert!(frame.rgb.iter().any(|colour| *colour != [0; 3]));
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn light(&self, snapshot: &Snapshot, daylight: &Daylight) -> Lighting {
        let mut lighting = Lighting {
            daylight: *daylight,
            tracer: Tracer::new(snapshot),
            sun: None,
            lamps: Arc::default(),
            gains: Vec::new(),
            screens: Vec::new(),
            grids: Arc::default(),
            sunlight: Vec::new(),
            cloth: Vec::new(),
            rooms: Vec::new(),
            cast: Arc::new(snapshot.clone()),
        };
        if snapshot.is_in(&self.store) && daylight.check().is_ok() {
            self.shine(&mut lighting);
        }
        lighting
    }

    /// Brings light up to another moment of the same scene: lamps have been switched, doors, blinds or
    /// furniture moved.
    ///
    /// It is then as [`Self::light`] would make it, but for rays that graze an edge. The tree of rays is kept, and
    /// where nothing has moved shadows are; what rooms throw back is found anew everywhere, as light goes
    /// from room to room. Takes two thirds to three quarters of what it takes to make it.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use vc_graph::asset::{Material, Part, Shape};
    /// # use vc_graph::{Asset, AssetLibrary, Draft, Pose, SceneBuilder};
    /// use vc_render::{Daylight, Renderer};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let material = Material {
    /// #     name: "warm_bulb".into(),
    /// #     colour: [0.9; 3],
    /// #     density: 500.0,
    /// #     friction: 0.5,
    /// #     restitution: 0.1,
    /// #     roughness: 0.5,
    /// #     metallic: 0.0,
    /// #     transmission: 0.0,
    /// #     emission: [30.0; 3],
    /// #     texture: None,
    /// # };
    /// # let mut library = AssetLibrary::default();
    /// # let material = library.add_material(material)?;
    /// # let shape = Shape::Sphere { radius: 0.12 };
    /// # let bulb = Part { name: "bulb".into(), shape, material, pose: Pose::identity(), joint: None };
    /// # let bulb = library.add(Asset { name: "lamp".into(), parts: vec![bulb], ..Asset::default() })?;
    /// # scene.assets(Arc::new(library));
    /// # let lamp = Draft { asset: Some(bulb), ..Draft::new("ceiling_lamp").at(Pose::translation(1.0, 0.0, 2.2)) };
    /// # let lamp = scene.add_in(kitchen, lamp)?;
    /// # let mut renderer = Renderer::new();
    /// let mut snapshot = renderer.snapshot(&scene.build())?;
    /// let mut lighting = renderer.light(&snapshot, &Daylight::night());
    /// assert!(lighting.sources().is_empty()); // no sun, and the lamp is off
    /// snapshot.switch(lamp, true)?;
    /// renderer.relight(&mut lighting, &snapshot)?;
    /// assert_eq!(lighting.sources().len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::OtherScene`] if bodies have come or gone, [`RenderError::OtherRenderer`],
    /// [`RenderError::BadDaylight`]; the light is then as it was.
    pub fn relight(&self, lighting: &mut Lighting, snapshot: &Snapshot) -> Result<(), RenderError> {
        lighting.check(&self.store)?;
        lighting.tracer.snapshot.with("snapshot to follow", snapshot)?;
        let moved = !lighting.cast.stands_as(snapshot);
        lighting.tracer.follow(snapshot)?;
        if moved {
            lighting.sun = None;
            lighting.lamps = Arc::default();
        }
        lighting.cast = Arc::new(snapshot.clone());
        self.shine(lighting);
        Ok(())
    }

    /// Finds the light in the scene of its tracer; shadows that are there are right.
    fn shine(&self, lighting: &mut Lighting) {
        let (snapshot, daylight) = (&lighting.tracer.snapshot, &lighting.daylight);
        let Shining { gains, screens, lamps } = lamps(self, &lighting.tracer, &lighting.lamps);
        if lighting.sun.is_none() && daylight.sun.norm() > 0.0 {
            let (middle, radius) = ball(snapshot);
            let map = ShadowMap::sun(self, snapshot, daylight.towards_sun, middle, radius);
            lighting.sun = Some(Arc::new(map));
        }
        lighting.rooms = rooms(snapshot);
        (lighting.gains, lighting.screens, lighting.lamps) = (gains, screens, Arc::new(lamps));
        let (grids, sunlight) = room::grids(self, lighting);
        (lighting.grids, lighting.sunlight) = (Arc::new(grids), sunlight);
        lighting.cloth = super::cloth::lit(self, lighting);
    }
}

/// A ball around everything.
fn ball(snapshot: &Snapshot) -> (Point3<f32>, f32) {
    let corners = snapshot.instances.iter().map(|i| crate::scene::turned(&i.world.narrow(), &i.link.levels[0].bounds));
    let all = corners.reduce(|a, b| a.joined(&b)).unwrap_or_default();
    let radius = nalgebra::Vector3::from(all.half).norm();
    (all.centre.into(), radius.clamp(0.5, 200.0))
}

impl Lighting {
    /// That it was made, and with meshes in this store.
    pub(crate) fn check(&self, store: &Store) -> Result<(), RenderError> {
        if !self.tracer.snapshot.is_in(store) {
            return Err(RenderError::OtherRenderer("light"));
        }
        self.daylight.check()?;
        // There is a grid even for what is in no room.
        if self.grids.is_empty() { Err(RenderError::OtherRenderer("light")) } else { Ok(()) }
    }

    /// Lets mirrors and reference pictures see another moment of the same scene, as
    /// [`RayCaster::follow`](crate::RayCaster::follow) does, at its cost. The light of fast pictures and
    /// the exposure stay as they were; [`Renderer::relight`] makes them anew too.
    ///
    /// # Errors
    /// [`RenderError::OtherScene`] if bodies have come or gone.
    pub fn follow(&mut self, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.tracer.follow(snapshot)
    }

    /// Light from all sides that falls on a surface, from the grid of its room.
    #[inline(always)]
    pub(crate) fn around(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> [f32; 3] {
        self.sides(at, normal, room).falls(normal)
    }

    /// Light from all sides at a surface.
    #[inline(always)]
    pub(crate) fn sides(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> Ambient {
        let index = usize::from(room).min(self.grids.len() - 1);
        self.grids[index].at(three(|i| at[i] + 0.12 * normal[i]))
    }

    /// How much of the sun is seen from a surface, by the cosine; none where there is no sun.
    pub(super) fn sunshine(&self, at: [f32; 3], normal: [f32; 3]) -> Option<f32> {
        let map = self.sun.as_ref()?;
        let facing = dot(self.daylight.towards_sun.into(), normal);
        Some(if facing > 0.0 { facing * map.lit(at, normal) } else { 0.0 })
    }

    /// The share of the sun's light that panes leave in a room.
    #[inline(always)]
    pub(crate) fn sunlight(&self, room: u16) -> f32 {
        self.sunlight[usize::from(room).min(self.sunlight.len() - 1)]
    }

    /// Light that falls straight from the sun, of which panes leave a share, and the room's lamps on a surface,
    /// with shadows.
    pub(crate) fn direct(&self, at: [f32; 3], normal: [f32; 3], room: u16, panes: f32) -> [f32; 3] {
        let share = if panes > 0.0 { panes * self.sunshine(at, normal).unwrap_or(0.0) } else { 0.0 };
        let mut sum: [f32; 3] = self.daylight.sun.map(|sun| share * sun).into();
        for lamp in self.lamps.iter().filter(|l| l.room == room) {
            let (to, light) = lamp.falls(at);
            let facing = dot(to, normal);
            if facing > 0.0 {
                let share = facing * light * lamp.seen(at, normal);
                sum = three(|i| sum[i] + share * lamp.flux[i]);
            }
        }
        sum
    }

    /// Light a surface of a body gives of itself; where its picture is white, if it has one.
    #[inline(always)]
    pub(crate) fn glow(&self, surface: &Surface, body: u32) -> [f32; 3] {
        let [gain, shade] = self.gains[body as usize];
        match surface.role {
            Role::Shade => scaled(surface.colour, shade),
            _ => scaled(surface.emission, gain),
        }
    }

    /// The same as it is shown by an exposure.
    pub(crate) fn shown(&self, surface: &Surface, body: u32, exposure: [f32; 3]) -> [f32; 3] {
        let glow = self.glow(surface, body);
        let Ok(at) = self.screens.binary_search_by_key(&body, |(body, _)| *body) else { return glow };
        let most = self.screens[at].1 * self.gains[body as usize][0] * brightness(exposure);
        scaled(glow, (SCREEN / most.max(1e-9)).min(1.0))
    }

    /// The factors that bring the light that an eye sees to a picture's middle grey, and its colour partly to white.
    /// They are for the light of the rooms in view, weighted by how much is seen of each, so that they change with the
    /// view and do not jump in a doorway; where nothing is seen, for the light of the eye's own room. In dim light they
    /// go a part of the way only.
    pub(crate) fn exposure(&self, eye: [f32; 3], seen: impl IntoIterator<Item = u16>) -> [f32; 3] {
        use vc_graph::portable::Portable;
        // Outside is as bright as it is; a little of a sunny balcony does not make its room dark.
        let outdoors = self.room_for(eye) + 1 == self.rooms.len();
        let dark = DARK[usize::from(outdoors)];
        let inside = |room: &usize| outdoors || room + 1 < self.rooms.len();
        let levels = seen.into_iter().map(|r| usize::from(r).min(self.rooms.len() - 1)).filter(inside);
        let mut levels: ArrayVec<_, STREWN> = levels.map(|room| self.level(room)).take(STREWN).collect();
        if levels.is_empty() {
            levels.push(self.level(self.room_for(eye)));
        }
        let count = levels.len() as f32;
        let dark = dark.max(BLACK * levels.iter().map(|(level, _)| level / count).sum::<f32>());
        let first = levels[0].0.max(dark);
        // Relative to the first level, so that the mean of equal levels is exactly that level.
        let off = levels.iter().map(|(level, _)| (level.max(dark) / first).logarithm()).sum::<f32>() / count;
        let most = BRIGHTER * first * off.exponential();
        let mean = levels.iter().map(|(level, _)| level.min(most)).sum::<f32>() / count;
        let colour = levels.iter().fold([0.0; 3], |sum, (_, c)| {
            let share = 1.0 / brightness(*c);
            three(|i| sum[i] + share * c[i])
        });
        let mean = mean.max(dark);
        let adapted = if mean < DIM { DIM * (mean / DIM).power(PART) } else { mean };
        three(|c| 0.8 / adapted / (colour[c] / count).max(0.1).power(BALANCE))
    }

    /// Mean radiance of a room if it were grey, thrown back and straight from its lamps, and its colour.
    pub(super) fn level(&self, room: usize) -> (f32, [f32; 3]) {
        let lamps = self.lamps.iter().filter(|l| usize::from(l.room) == room);
        let own = lamps.fold([0.0; 3], |sum, lamp| three(|c| sum[c] + lamp.flux[c]));
        let (grid, share) = (&self.grids[room], 0.25 / (self.floor(room) * 4.0).max(1.0));
        (grid.middling + brightness(own) * share, three(|c| grid.colour[c] + own[c] * share + 1e-6))
    }

    /// Area of a room's floor.
    pub(super) fn floor(&self, room: usize) -> f32 {
        let (low, high) = self.rooms[room];
        (high[0] - low[0]) * (high[1] - low[1])
    }

    /// The room for whose light a picture is exposed: the one the eye is in; from above, the
    /// one below if it fills half of the view, else the largest.
    fn room_for(&self, eye: [f32; 3]) -> usize {
        if let Some(around) = self.room_around(eye) {
            return around;
        }
        let outside = self.rooms.len() - 1;
        let over = |i: &usize| {
            let (low, high) = self.rooms[*i];
            (0..2).all(|k| eye[k] >= low[k] && eye[k] <= high[k])
        };
        let by_floor = |a: &usize, b: &usize| self.floor(*a).total_cmp(&self.floor(*b));
        let fills = |i: &usize| {
            let (low, high) = self.rooms[*i];
            (high[0] - low[0]).max(high[1] - low[1]) >= 0.65 * (eye[2] - high[2])
        };
        let under = || (0..outside).filter(|i| over(i) && fills(i)).min_by(by_floor);
        let is_above = (0..outside).any(|i| over(&i) && eye[2] > self.rooms[i].1[2]);
        let seen = if is_above { under().or_else(|| (0..outside).max_by(by_floor)) } else { None };
        seen.unwrap_or(outside)
    }
}

#[inline(always)]
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
