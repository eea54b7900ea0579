//! The light in a scene: computed once, and kept until things that matter to it change.

use std::sync::Arc;

use nalgebra::Point3;

use super::ambient::Ambient;
use super::grid::Grid;
use super::lamp::{Lamp, Shining, lamps};
use super::shadow::ShadowMap;
use super::{Daylight, extent::rooms, room};
use crate::RenderError;
use crate::affine::{scaled, three};
use crate::renderer::Renderer;
use crate::scene::{Snapshot, Store};
use crate::surface::{Role, Surface};
use crate::trace::Tracer;

/// The light in a scene at one moment: shadow maps of the sun and of the lamps that are on, and the indirect
/// light in rooms. [`Renderer::light`] makes it; it serves any number of cameras and is cheap to clone. When
/// lamps are switched, or doors, blinds and large things move, [`Renderer::relight`] brings it up to date.
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

/// Luminance of a colour (Rec. 709).
#[inline(always)]
pub(crate) fn brightness([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

impl Renderer {
    /// Computes the light in a scene. This takes about a microsecond for each triangle to build the ray tree,
    /// tens of milliseconds for shadows, and some for each room; 0.4 seconds for a home of 130,000 triangles on
    /// two processors (`benches/README.md`).
    ///
    /// Indirect light is stored as ambient cubes (McTaggart 2004) on a grid in each room. It is found by rays
    /// in all directions, and its further bounces go between the points that these rays hit. The ray tree is
    /// built with the surface area heuristic over bins (Wald 2007).
    ///
    /// If the snapshot is of another renderer, or the daylight contains numbers that are not finite, the result
    /// holds no light, and its use returns an error.
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
    /// // The light is computed once, for any number of cameras.
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

    /// Brings the light up to another moment of the same scene, in which lamps have been switched, or doors,
    /// blinds or furniture moved.
    ///
    /// The result is what [`Self::light`] would make, but for rays that graze an edge. The ray tree is kept,
    /// and so are shadows if nothing has moved; indirect light is computed anew everywhere, as light goes from
    /// room to room. Takes two thirds to three quarters of the time of [`Self::light`].
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
    /// [`RenderError::BadDaylight`]; the light is then unchanged.
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

    /// Computes the light for the snapshot of its tracer; shadows already present are up to date.
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

/// Bounding sphere of the scene.
fn ball(snapshot: &Snapshot) -> (Point3<f32>, f32) {
    let corners = snapshot.instances.iter().map(|i| crate::scene::turned(&i.world.narrow(), &i.link.levels[0].bounds));
    let all = corners.reduce(|a, b| a.joined(&b)).unwrap_or_default();
    let radius = nalgebra::Vector3::from(all.half).norm();
    (all.centre.into(), radius.clamp(0.5, 200.0))
}

impl Lighting {
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
    /// exposure stay as they were; [`Renderer::relight`] computes them anew as well.
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
        let most = self.screens[at].1 * self.gains[body as usize][0] * brightness(exposure);
        scaled(glow, (SCREEN / most.max(1e-9)).min(1.0))
    }

    /// Area of a room's floor.
    pub(super) fn floor(&self, room: usize) -> f32 {
        let (low, high) = self.rooms[room];
        (high[0] - low[0]) * (high[1] - low[1])
    }
}

#[inline(always)]
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
