//! The renderer: it owns uploaded meshes and renders scenes with them.

use rayon::prelude::*;
use vc_graph::asset::Joint;
use vc_graph::{NodeId, SceneGraph};

use crate::affine::{self, three};
use crate::frame::{Band, Frame, Memory, Strip};
use crate::label::{self, Other};
use crate::light::{Lighting, Patch, Spot, dot};
use crate::modality::Modality;
use crate::raster::{Drawing, Frustum, Layers, Visible};
use crate::scene::{Snapshot, Store};
use crate::shade::{self, Shading};
use crate::view::{Shot, View};
use crate::{RenderError, simd};

/// Owns uploaded meshes and surface materials, and renders with them.
///
/// [`snapshot`](Self::snapshot) uploads meshes, once for each asset. Rendering takes `&self`, so many threads
/// may share a renderer. It runs on the threads of the [rayon](https://docs.rs/rayon) pool it is called in, and
/// its result does not depend on their number.
#[derive(Debug)]
pub struct Renderer {
    pub(crate) store: Store,
    pub(crate) detail: f32,
}

impl Default for Renderer {
    fn default() -> Self {
        Self { store: Store::default(), detail: 0.25 }
    }
}

/// Modalities that are written run by run: neighbouring pixels of a row that show one instance.
const RUNS: [Modality; 8] = [
    Modality::Instance,
    Modality::Class,
    Modality::FlowForward,
    Modality::FlowBackward,
    Modality::Occlusion,
    Modality::Boxes,
    Modality::Masks,
    Modality::Amodal,
];

impl Renderer {
    /// A renderer without uploaded meshes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the largest screen-space error of a curved outline at which a coarser mesh may be drawn, pixels: a
    /// quarter by default. At zero the finest mesh is always drawn.
    ///
    /// Depth and ids agree with a ray caster on the finest meshes (depth to a relative error of 1e-4) only at
    /// zero: coarser meshes deviate from curves by up to this many pixels in the image, and their depth is off
    /// by more.
    #[must_use]
    pub fn with_detail(self, pixels: f32) -> Self {
        Self { detail: pixels, ..self }
    }

    /// Takes a snapshot of a scene in its current state: all nodes with a pose and a shape, or at least a box,
    /// and joints open or closed according to the nodes' states.
    ///
    /// Assets not seen before are uploaded. This takes time proportional to their triangles, most of it for
    /// simplifying meshes; the rest takes about a microsecond for each node. Each asset gets five levels of
    /// detail: curves are tessellated finer or coarser, and meshes are simplified by edge collapse in the order
    /// of the quadric error, the distance to the original planes (Garland and Heckbert 1997). [`Snapshot`] has
    /// an example.
    ///
    /// # Errors
    /// [`RenderError::BadPose`], [`RenderError::NoSuchAsset`], [`RenderError::TooManyClasses`].
    pub fn snapshot(&mut self, graph: &SceneGraph) -> Result<Snapshot, RenderError> {
        self.snapshot_with(graph, |_, _| None)
    }

    /// Like [`Self::snapshot`], with joint positions (radians or metres) from a callback, for callers that know
    /// them more exactly than the nodes' states say. Where it returns `None` or a number that is not finite,
    /// the state decides.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::asset::{Joint, JointKind, Material, Part, Shape};
    /// # use vc_graph::{Asset, AssetLibrary, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
    /// # let material = Material {
    /// #     name: "oak".into(),
    /// #     colour: [0.5, 0.3, 0.15],
    /// #     density: 500.0,
    /// #     friction: 0.5,
    /// #     restitution: 0.1,
    /// #     roughness: 0.5,
    /// #     metallic: 0.0,
    /// #     transmission: 0.0,
    /// #     emission: [0.0; 3],
    /// #     texture: None,
    /// # };
    /// # let mut library = AssetLibrary::default();
    /// # let material = library.add_material(material)?;
    /// # let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    /// # let part = |name: &str, half: Vector3<f32>, height: f32, joint: Option<Joint>| Part {
    /// #     name: name.into(),
    /// #     shape: Shape::Box { half },
    /// #     material,
    /// #     pose: Pose::translation(0.0, 0.0, height),
    /// #     joint,
    /// # };
    /// # let body = part("body", Vector3::new(0.2, 0.4, 0.25), 0.25, None);
    /// # let drawer = part("drawer", Vector3::new(0.2, 0.35, 0.1), 0.6, Some(slide));
    /// # let asset = library.add(Asset { name: "dresser".into(), parts: vec![body, drawer], ..Asset::default() })?;
    /// # let mut scene = SceneBuilder::new("flat");
    /// # scene.assets(Arc::new(library));
    /// # let room = scene.add(Draft::new("bedroom"))?;
    /// # let dresser = Draft { asset: Some(asset), ..Draft::new("dresser").at(Pose::identity()) };
    /// # let dresser = scene.add_in(room, dresser)?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(3.0, 0.0, 0.6), Point3::new(0.0, 0.0, 0.6));
    /// // The drawer is 0.2 metres out, whatever the node's state says.
    /// let snapshot = renderer.snapshot_with(&scene, |node, _| (node == dresser).then_some(0.2))?;
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut frame)?;
    /// assert!((frame.depth[24 * 64 + 32] - (3.0 - 0.2 - 0.2)).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::snapshot`].
    pub fn snapshot_with(
        &mut self,
        graph: &SceneGraph,
        mut joint: impl FnMut(NodeId, &Joint) -> Option<f32>,
    ) -> Result<Snapshot, RenderError> {
        Snapshot::new(&mut self.store, graph, &mut joint)
    }

    /// Number of uploaded triangles of assets at the finest level of detail, and bytes of all levels. Boxes
    /// that stand for nodes without an asset, and the liquids that vessels may be filled with, are not counted.
    pub fn size(&self) -> (usize, usize) {
        self.store.size()
    }

    /// Renders a shot into a frame. Modalities that are not requested cost nothing, and a frame that is reused
    /// for pictures of the same size allocates nothing.
    ///
    /// For 130,000 triangles at 640 by 480 pixels, labels, depth and flow took 3.2 to 4.7 ms on one core and
    /// all six modalities 15.8 to 23 ms, on two shared machines; both times grow about linearly with the number
    /// of pixels. `benches/README.md` has the tables, and these times scaled to the speed of a third machine.
    /// Modalities that need light take it from [`Self::light`]. [`Frame`] and [`Shot`] have examples.
    ///
    /// Labels are read from a visibility buffer (Burns and Hunt 2013), which is filled with edge functions
    /// (Pineda 1988) after clusters have been culled against a coarse depth buffer (Greene, Kass and Miller
    /// 1993). For colours, the widths of penumbrae are found by a blocker search (Fernando 2005) and shadows
    /// filtered by averaging (Reeves, Salesin and Cook 1987); ambient occlusion compares depth with the
    /// surface's plane (after Bavoil and Sainz 2009); reflections of the surroundings use Karis's fit (2014);
    /// the tone curve is that of Naka and Rushton (1966); and edges are smoothed by how far triangles reach
    /// between pixels (after Persson 2011).
    ///
    /// # Errors
    /// [`RenderError::BadSize`], [`RenderError::BadCamera`], [`RenderError::Missing`],
    /// [`RenderError::OtherScene`], [`RenderError::OtherRenderer`], [`RenderError::BadDaylight`]; the frame is
    /// then unchanged.
    pub fn render(&self, shot: &Shot<'_>, frame: &mut Frame) -> Result<(), RenderError> {
        if shot.finer > 1 && shot.wanted.has(Modality::Rgb) {
            return self.render_finer(shot, frame);
        }
        shot.check(&self.store)?;
        let View { snapshot, camera } = shot.view;
        let wanted = shot.wanted;
        let moments = [shot.after, shot.before].map(|view| view.is_some());
        frame.prepare(camera.width as usize, camera.height as usize, wanted, moments);
        let (strip, memory) = Strip::of(frame);
        let Memory { bands, other, .. } = memory;
        if wanted.has(Modality::Occlusion) {
            self.others([shot.after, shot.before], other);
        }
        bands.resize_with(count(camera.height), Band::default);
        self.bands(shot, strip, bands, other);
        if [Modality::Boxes, Modality::Masks, Modality::Amodal].iter().any(|m| wanted.has(*m)) {
            label::boxes(camera, snapshot, frame);
        }
        if wanted.has(Modality::Amodal) {
            label::amodal(camera, snapshot, self.detail, frame);
        }
        if let (true, Some(lighting)) = (wanted.has(Modality::Rgb), shot.lighting) {
            self.colours(lighting, shot, frame);
        }
        Ok(())
    }

    /// Renders labels at the shot's size and colours at a finer one, which are then shrunk.
    fn render_finer(&self, shot: &Shot<'_>, frame: &mut Frame) -> Result<(), RenderError> {
        let View { snapshot, camera } = shot.view;
        let camera = camera.finer(shot.finer);
        let view = View { snapshot, camera: &camera };
        let colours = Shot { view, before: None, after: None, wanted: Modality::Rgb.into(), finer: 1, ..*shot };
        shot.check(&self.store)?;
        colours.check(&self.store)?;
        let mut fine = frame.memory.finer.take().unwrap_or_default();
        self.render(&Shot { wanted: shot.wanted.without(Modality::Rgb), finer: 1, ..*shot }, frame)?;
        self.render(&colours, &mut fine)?;
        shade::shrink(&fine.rgb, shot.finer as usize, (frame.width, &mut frame.rgb));
        frame.holds = shot.wanted;
        frame.exposure = fine.exposure;
        frame.memory.finer = Some(fine);
        Ok(())
    }

    /// Renders several shots in parallel, each into its own frame. Each takes the time of [`Self::render`];
    /// many small pictures rendered side by side keep threads busier than one after the other.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// # let snapshot = renderer.snapshot(&scene)?;
    /// let cameras = Camera::with_fov(32, 24, 1.0).around(Point3::new(2.0, 0.0, 1.0), 3.0, 0.3, 4);
    /// let shot = |camera| Shot::new(&snapshot, camera, Modality::Instance);
    /// let shots: Vec<Shot<'_>> = cameras.iter().map(shot).collect();
    /// let mut frames: Vec<Frame> = shots.iter().map(|_| Frame::new()).collect();
    /// renderer.render_all(&shots, &mut frames)?;
    /// assert!(frames.iter().all(|frame| frame.instance[12 * 32 + 16] == fridge));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::render`], for the first shot that fails; [`RenderError::FrameCount`].
    pub fn render_all(&self, shots: &[Shot<'_>], frames: &mut [Frame]) -> Result<(), RenderError> {
        if shots.len() != frames.len() {
            return Err(RenderError::FrameCount { shots: shots.len(), frames: frames.len() });
        }
        let results: Vec<_> = shots.par_iter().zip(frames).map(|(shot, frame)| self.render(shot, frame)).collect();
        results.into_iter().collect()
    }

    /// Renders bands of rows, splitting them in half recursively among the threads.
    fn bands(&self, shot: &Shot<'_>, strip: Strip<'_>, bands: &mut [Band], other: &[Other; 2]) {
        if let [band] = bands {
            return self.band(shot, strip, band, other);
        }
        let [(upper, first), (lower, last)] = halves(strip, bands);
        rayon::join(|| self.bands(shot, upper, first, other), || self.bands(shot, lower, last, other));
    }

    /// Shades the visible surfaces of all bands.
    fn colours(&self, lighting: &Lighting, shot: &Shot<'_>, frame: &mut Frame) {
        let view = shot.view;
        let (strip, memory) = Strip::of(frame);
        let Memory { bands, open, .. } = memory;
        let open = (!shot.plain).then(|| shade::occlusion(view.camera, bands, open));
        let exposure = lighting.exposure(view.camera.eye().into(), self.spots(lighting, view, bands));
        let exposure = shot.adapts.map_or(exposure, |adapts| adapts.towards(exposure));
        shade_bands(&Shading { renderer: self, lighting, view, open, exposure }, strip, bands);
        frame.exposure = exposure;
        shade::smooth(frame);
    }

    /// Meters the light at pixels scattered over a picture, of opaque surfaces, including those seen through glass.
    fn spots<'a>(
        &'a self,
        lighting: &'a Lighting,
        View { snapshot, camera }: View<'a>,
        bands: &'a [Band],
    ) -> impl Iterator<Item = Spot> + 'a {
        camera.strewn().filter_map(move |[x, y]| {
            let band = bands.iter().find(|band| band.rows.contains(&(y as i32)))?;
            let solid = band.layers.solid();
            let triangle = *solid.triangle_row(y as i32).get(x as usize)?;
            let seen = band.layers.visible.get(triangle as usize)?;
            let depth = 1.0 / *solid.inverse_row(y as i32).get(x as usize)?;
            Some(self.metered(lighting, snapshot, (seen, camera.unproject(x, y, depth).into()), camera.eye().into()))
        })
    }

    /// Meters the light at a point of a visible triangle.
    fn metered(
        &self,
        lighting: &Lighting,
        snapshot: &Snapshot,
        (seen, at): (&Visible, [f32; 3]),
        eye: [f32; 3],
    ) -> Spot {
        let instance = &snapshot.instances[seen.instance as usize];
        let (mesh, index) = (seen.mesh(&snapshot.instances), seen.index());
        let normal = label::unit(affine::normal(&instance.inverse, mesh.normals[index][0]));
        let faces = dot(normal, three(|i| eye[i] - at[i])) >= 0.0;
        lighting.metered(&Patch {
            surface: &self.store.surfaces[usize::from(mesh.faces[index].surface)],
            coat: &instance.coat,
            body: instance.body,
            at,
            normal: if faces { normal } else { normal.map(|v| -v) },
            room: lighting.room_seen(snapshot, seen, eye),
        })
    }

    fn band(&self, shot: &Shot<'_>, mut strip: Strip<'_>, band: &mut Band, other: &[Other; 2]) {
        let View { snapshot, camera } = shot.view;
        let wanted = shot.wanted;
        // Colours need one more row, for the smoothing of edges.
        let rgb = wanted.has(Modality::Rgb);
        let last = if rgb { (strip.rows.end + 1).min(camera.height as i32) } else { strip.rows.end };
        let rows = strip.rows.start..last;
        band.rows = strip.rows.clone();
        self.draw(shot.view, rows, &mut band.layers, rgb);
        simd::widest(
            #[inline(always)]
            || label::depths(camera, &band.layers, &mut strip),
        );
        label::normals(camera, snapshot, &band.layers, &mut strip);
        band.runs.clear();
        if RUNS.iter().any(|m| wanted.has(*m)) || wanted.has(Modality::Part) {
            label::runs(&band.layers, strip.rows.clone(), &mut band.runs);
            label::ids(snapshot, &band.layers, &band.runs, &mut strip);
        }
        flow(shot, &mut strip, band, other);
    }

    /// Draws all instances into some rows of an image.
    fn draw(&self, view: View<'_>, rows: std::ops::Range<i32>, layers: &mut Layers, apart: bool) {
        let View { snapshot, camera } = view;
        let frustum = Frustum::new(camera, &rows);
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: self.detail };
        let all = 0..snapshot.instances.len() as u32;
        layers.draw(&drawing, all, (camera.width as usize, rows), apart);
    }

    /// Draws the moments after and before, to find what is hidden there.
    fn others(&self, views: [Option<View<'_>>; 2], other: &mut [Other; 2]) {
        let draw = |other: &mut Other, view: Option<View<'_>>| {
            if let Some(view) = view {
                self.draw(view, 0..view.camera.height as i32, &mut other.layers, false);
            }
        };
        let ([after, before], [next, last]) = (views, other);
        rayon::join(|| draw(next, after), || draw(last, before));
    }
}

/// Computes a band's optical flow and its occlusion at the other moments.
fn flow(shot: &Shot<'_>, strip: &mut Strip<'_>, band: &mut Band, other: &[Other; 2]) {
    let Band { layers, runs, motion, faces, .. } = band;
    let (width, seen) = (strip.width, (&*layers, runs.as_slice()));
    let ways = [
        (shot.after, Modality::FlowForward, &mut *strip.flow_forward, &mut *strip.occluded_forward),
        (shot.before, Modality::FlowBackward, &mut *strip.flow_backward, &mut *strip.occluded_backward),
    ];
    for ((then, modality, flow, occluded), other) in ways.into_iter().zip(other) {
        let Some(then) = then else { continue };
        if shot.wanted.has(modality) {
            simd::widest(
                #[inline(always)]
                || label::flows(shot.view, then, seen, motion, (width, flow)),
            );
        }
        if shot.wanted.has(Modality::Occlusion) {
            label::hidden(shot.view, then, seen, (motion, faces, other), (width, occluded));
        }
    }
}

fn shade_bands(shading: &Shading<'_>, mut strip: Strip<'_>, bands: &mut [Band]) {
    if let [band] = bands {
        return shading.band(band, &mut strip);
    }
    let [(upper, first), (lower, last)] = halves(strip, bands);
    rayon::join(|| shade_bands(shading, upper, first), || shade_bands(shading, lower, last));
}

/// Splits a strip and its bands into an upper and a lower half, at a row where the lattice of light samples may
/// start.
fn halves<'a, 'b>(strip: Strip<'a>, bands: &'b mut [Band]) -> [(Strip<'a>, &'b mut [Band]); 2] {
    let middle = bands.len() / 2;
    let rows = strip.rows.len() * middle / bands.len() / shade::ALIGNED * shade::ALIGNED;
    let (upper, lower) = strip.split(rows as i32);
    let (first, last) = bands.split_at_mut(middle);
    [(upper, first), (lower, last)]
}

/// Number of bands for an image: one on a single thread, and none lower than 32 rows.
fn count(height: u32) -> usize {
    let threads = rayon::current_num_threads();
    let most = if threads == 1 { 1 } else { 2 * threads };
    most.min(height as usize / 32).max(1)
}
