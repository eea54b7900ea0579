//! The light in a scene: computed once, and kept until things that matter to it change.

use std::sync::Arc;

use nalgebra::Point3;

use super::ambient::Ambient;
use super::grid::Grid;
use super::lamp::{Lamp, Shining, lamps};
use super::shadow::ShadowMap;
use super::{Daylight, extent::rooms, room};
use crate::RenderError;
use crate::colour::luminance;
use crate::math::{dot, scaled, three};
use crate::ray_casting::Tracer;
use crate::scene::{Snapshot, Store};
use crate::surface::{Role, Surface};

/// The light in a scene at one moment: shadow maps of the sun and of the lamps that are on, and the indirect
/// light in rooms. [`Renderer::light`](crate::Renderer::light) makes it; it serves any number of cameras and is cheap
/// to clone. When lamps are switched, or doors, blinds and large things move,
/// [`Renderer::relight`](crate::Renderer::relight) brings it up to date.
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
/// // The light of two moments; both are kept.
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
    // Clones share the large members.
    pub(crate) sun: Option<Arc<ShadowMap>>,
    pub(crate) lamps: Arc<Vec<Lamp>>,
    /// For each body, the factor for its own emission, and those for each colour of its shade's.
    pub(super) gains: Vec<[f32; 4]>,
    /// For each luminous body that is not a lamp, the greatest brightness of its materials.
    pub(super) screens: Vec<(u32, f32)>,
    pub(super) grids: Arc<Vec<Grid>>,
    /// For each room, the share of sunlight that window panes let through.
    pub(super) sunlight: Vec<f32>,
    /// For each drawn cover, by body, the light through it.
    pub(super) cloth: Vec<(u32, [f32; 3])>,
    /// Boxes of rooms, to find the room that a camera is in.
    pub(super) rooms: Vec<([f32; 3], [f32; 3])>,
    /// The moment that the shadows show.
    pub(super) cast: Arc<Snapshot>,
}

/// Greatest displayed brightness of a screen as a multiple of middle grey: eyes that look at a screen adapt to
/// it.
const SCREEN: f32 = 1.6;

/// Bounding sphere of the scene.
fn ball(snapshot: &Snapshot) -> (Point3<f32>, f32) {
    let corners = snapshot.instances.iter().map(|i| i.link.levels[0].bounds.mapped(&i.world.narrow()));
    let all = corners.reduce(|a, b| a.joined(&b)).unwrap_or_default();
    let radius = nalgebra::Vector3::from(all.half).norm();
    (all.centre.into(), radius.clamp(0.5, 200.0))
}

impl Lighting {
    /// Computes the light in a scene; none for another store's snapshot and for unusable daylight.
    pub(crate) fn new(store: &Store, snapshot: &Snapshot, daylight: &Daylight) -> Self {
        let mut lighting = Self {
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
        if snapshot.is_in(store) && daylight.check().is_ok() {
            lighting.compute(store);
        }
        lighting
    }

    /// Brings all light up to another moment of the same scene.
    pub(crate) fn update(&mut self, store: &Store, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.check(store)?;
        self.tracer.snapshot.with("snapshot to follow", snapshot)?;
        let moved = !self.cast.stands_as(snapshot);
        self.tracer.follow(snapshot)?;
        if moved {
            self.sun = None;
            self.lamps = Arc::default();
        }
        self.cast = Arc::new(snapshot.clone());
        self.compute(store);
        Ok(())
    }

    /// Computes the light for the snapshot of its tracer; shadows already present are up to date.
    fn compute(&mut self, store: &Store) {
        let (snapshot, daylight) = (&self.tracer.snapshot, &self.daylight);
        let Shining { gains, screens, lamps } = lamps(store, &self.tracer, &self.lamps);
        if self.sun.is_none() && daylight.sun.norm() > 0.0 {
            let (middle, radius) = ball(snapshot);
            let map = ShadowMap::sun(store, snapshot, daylight.towards_sun, middle, radius);
            self.sun = Some(Arc::new(map));
        }
        self.rooms = rooms(snapshot);
        (self.gains, self.screens, self.lamps) = (gains, screens, Arc::new(lamps));
        let (grids, sunlight) = room::grids(store, self);
        (self.grids, self.sunlight) = (Arc::new(grids), sunlight);
        self.cloth = super::cloth::lit(store, self);
    }

    /// Checks that the light was computed, with meshes of this store.
    pub(crate) fn check(&self, store: &Store) -> Result<(), RenderError> {
        if !self.tracer.snapshot.is_in(store) {
            return Err(RenderError::OtherRenderer("light"));
        }
        self.daylight.check()?;
        // Even things in no room have a grid, so it is only empty if the light was never computed.
        if self.grids.is_empty() { Err(RenderError::OtherRenderer("light")) } else { Ok(()) }
    }

    /// Lets mirrors and reference pictures show another moment of the same scene, like
    /// [`RayCaster::follow`](crate::RayCaster::follow) and at its cost. The light of fast pictures and the
    /// exposure stay as they were; [`Renderer::relight`](crate::Renderer::relight) computes them anew as well.
    ///
    /// # Errors
    /// [`RenderError::OtherScene`] if bodies have come or gone.
    pub fn follow(&mut self, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.tracer.follow(snapshot)
    }

    /// Ambient irradiance on a surface, from the grid of its room.
    #[inline(always)]
    pub(crate) fn around(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> [f32; 3] {
        self.sides(at, normal, room).falls(normal)
    }

    /// Ambient light at a surface.
    #[inline(always)]
    pub(crate) fn sides(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> Ambient {
        let index = usize::from(room).min(self.grids.len() - 1);
        self.grids[index].at(three(|i| at[i] + 0.12 * normal[i]))
    }

    /// The visible share of the sun from a surface, times the cosine; none if there is no sun.
    pub(super) fn sunshine(&self, at: [f32; 3], normal: [f32; 3]) -> Option<f32> {
        let map = self.sun.as_ref()?;
        let facing = dot(self.daylight.towards_sun.into(), normal);
        Some(if facing > 0.0 { facing * map.lit(at, normal) } else { 0.0 })
    }

    /// The share of sunlight that panes let into a room.
    #[inline(always)]
    pub(crate) fn sunlight(&self, room: u16) -> f32 {
        self.sunlight[usize::from(room).min(self.sunlight.len() - 1)]
    }

    /// Direct light on a surface, with shadows: from the sun, of which panes let a share through, and from the
    /// room's lamps.
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

    /// Emission of a body's surface; with an emissive texture, that of its white texels.
    #[inline(always)]
    pub(crate) fn glow(&self, surface: &Surface, body: u32) -> [f32; 3] {
        let [gain, shade @ ..] = self.gains[body as usize];
        match surface.role {
            Role::Shade => three(|i| surface.colour[i] * shade[i]),
            _ => scaled(surface.emission, gain),
        }
    }

    /// The emission as displayed at an exposure: screens are limited in brightness.
    pub(crate) fn shown(&self, surface: &Surface, body: u32, exposure: [f32; 3]) -> [f32; 3] {
        let glow = self.glow(surface, body);
        let Ok(at) = self.screens.binary_search_by_key(&body, |(body, _)| *body) else { return glow };
        let most = self.screens[at].1 * self.gains[body as usize][0] * luminance(exposure);
        scaled(glow, (SCREEN / most.max(1e-9)).min(1.0))
    }

    /// Area of a room's floor.
    pub(super) fn floor(&self, room: usize) -> f32 {
        let (low, high) = self.rooms[room];
        (high[0] - low[0]) * (high[1] - low[1])
    }
}
