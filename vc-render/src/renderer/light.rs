//! The light in a scene, as a renderer computes it.

use super::Renderer;
use crate::RenderError;
use crate::light::{Daylight, Lighting};
use crate::scene::Snapshot;

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
        Lighting::new(&self.store, snapshot, daylight)
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
    /// # let material = Material { emission: [30.0; 3], ..Material::new("warm_bulb", [0.9; 3]) };
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
        lighting.update(&self.store, snapshot)
    }

    /// Updates shadows, mirrors and reference pictures to another moment of the same scene: things that have
    /// moved cast their shadows from their new places, and lamps that were carried shine from theirs. Indirect
    /// light stays as it was; [`relight`](Self::relight) computes it anew as well.
    ///
    /// The shadows are then bit for bit those that [`light`](Self::light) would make. Only those rows of shadow
    /// maps are redrawn in which a moved thing may be the nearest: this takes some milliseconds where a person
    /// walks in the sun or below a lamp, and less than one where nothing has moved in the light
    /// (`benches/README.md`).
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};
    /// # let mut scene = SceneBuilder::new("yard");
    /// # let slab = Bounds::standing(Vector3::new(6.0, 6.0, 0.1));
    /// # scene.add(Draft::new("floor").at(Pose::translation(0.0, 0.0, -0.1)).bounds(slab))?;
    /// # let size = Bounds::standing(Vector3::new(0.4, 0.4, 1.0));
    /// # let chair = scene.add(Draft::new("chair").at(Pose::identity()).bounds(size))?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// let mut snapshot = renderer.snapshot(&scene)?;
    /// let mut lighting = renderer.light(&snapshot, &Daylight::noon());
    /// snapshot.place(chair, &Pose::translation(1.0, 0.5, 0.0))?;
    /// renderer.follow(&mut lighting, &snapshot)?;
    /// let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(3.0, -2.0, 2.0), Point3::new(0.5, 0.0, 0.0));
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`relight`](Self::relight); the light is then unchanged.
    pub fn follow(&self, lighting: &mut Lighting, snapshot: &Snapshot) -> Result<(), RenderError> {
        lighting.follow_shadows(&self.store, snapshot)
    }
}
