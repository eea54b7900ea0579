//! The renderer: uploaded meshes, and what is made of them.

use rayon::prelude::*;
use vc_graph::asset::Joint;
use vc_graph::{NodeId, SceneGraph};

use crate::frame::{Band, Frame, Memory, Strip};
use crate::label::{self, Other};
use crate::light::Lighting;
use crate::modality::Modality;
use crate::raster::{Drawing, Frustum, Layers};
use crate::scene::{Snapshot, Store};
use crate::shade::{self, Shading};
use crate::view::{Shot, View};
use crate::{RenderError, simd};

/// Owns uploaded meshes and surfaces, and renders with them.
///
/// Uploading happens in [`snapshot`](Self::snapshot), once for each asset. Rendering takes `&self`: many
/// threads may share a renderer. A picture does not depend on how many threads make it;
/// they are those of the [rayon](https://docs.rs/rayon) pool it is called in.
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

/// What stands for pixels, of nodes and their bodies.
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
    /// A renderer that knows no meshes yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the largest error of a curve's outline when a coarser mesh is drawn, pixels:
    /// a quarter if not said. Zero draws the finest mesh always.
    ///
    /// Depth and ids agree with a ray caster on the finest meshes, depth within 1e-4 of itself, only at zero:
    /// coarser ones cut curves short, by up to this much in the image, and depth there is off by more.
    #[must_use]
    pub fn with_detail(self, pixels: f32) -> Self {
        Self { detail: pixels, ..self }
    }

    /// A scene as it is now: nodes with a pose and a shape, or at least a box, and
    /// joints open or closed as the nodes' states say.
    ///
    /// Assets not seen before are uploaded, which takes time with their triangles, and most where meshes are made
    /// coarser; the rest takes about a microsecond for each node. Curves are cut finer or coarser for each of five
    /// levels of detail; meshes get coarser by collapsing edges, cheapest first by the distance to the planes that
    /// were there (Garland and Heckbert 1997). [`Snapshot`] has an example.
    ///
    /// # Errors
    /// [`RenderError::BadPose`], [`RenderError::NoSuchAsset`], [`RenderError::TooManyClasses`].
    pub fn snapshot(&mut self, graph: &SceneGraph) -> Result<Snapshot, RenderError> {
        self.snapshot_with(graph, |_, _| None)
    }

    /// As [`Self::snapshot`], with positions of joints (radians or metres) from who knows
    /// them better than the nodes' states: `None` leaves a joint to these, and so does what is not finite.
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
    /// // A drawer that is 0.2 metres out, whatever the node's state says.
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

    /// Uploaded triangles of assets at the finest level of detail, and bytes of all levels. Boxes that stand for nodes
    /// without an asset, and what vessels may be filled with, are not counted.
    pub fn size(&self) -> (usize, usize) {
        self.store.size()
    }

    /// Renders a shot into a frame. What is not wanted costs nothing, and a frame that is used again for pictures of
    /// its size allocates nothing.
    ///
    /// Of 130,000 triangles in 640 by 480 pixels labels, depth and flow took 3.2 to 4.7 ms of one core and all six
    /// modalities 15.8 to 23 ms, on two shared machines; both grow about as pixels do. `benches/README.md` has the
    /// tables, and what that is at the pace of a third. What needs light has it from [`Self::light`]. [`Frame`] and
    /// [`Shot`] have examples.
    ///
    /// Labels are read off a visibility buffer (Burns and Hunt 2013), filled by edge functions (Pineda 1988) after
    /// clusters were culled against a coarse depth buffer (Greene, Kass and Miller 1993). Of colours the edges of
    /// shadows are found by what is in the way (Fernando 2005) and averaged (Reeves, Salesin and Cook 1987), occlusion
    /// by comparing depth with a plane's (after Bavoil and Sainz 2009), the reflection of what is around by Karis's
    /// fit (2014), the film's response by Naka and Rushton (1966), and edges are smoothed by how far triangles
    /// reach between pixels (after Persson 2011).
    ///
    /// # Errors
    /// [`RenderError::BadSize`], [`RenderError::BadCamera`], [`RenderError::Missing`],
    /// [`RenderError::OtherScene`], [`RenderError::OtherRenderer`], [`RenderError::BadDaylight`]; the frame is then as
    /// it was.
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

    /// Labels as ever, and colours from more pixels.
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

    /// Renders several shots, each into its frame, on the threads there are. Takes the time of [`Self::render`] for
    /// each; many small pictures side by side keep threads busier than one after the other.
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
    /// As [`Self::render`], for the first shot that fails; [`RenderError::FrameCount`].
    pub fn render_all(&self, shots: &[Shot<'_>], frames: &mut [Frame]) -> Result<(), RenderError> {
        if shots.len() != frames.len() {
            return Err(RenderError::FrameCount { shots: shots.len(), frames: frames.len() });
        }
        let results: Vec<_> = shots.par_iter().zip(frames).map(|(shot, frame)| self.render(shot, frame)).collect();
        results.into_iter().collect()
    }

    /// Bands of rows, halved among the threads.
    fn bands(&self, shot: &Shot<'_>, strip: Strip<'_>, bands: &mut [Band], other: &[Other; 2]) {
        if let [band] = bands {
            return self.band(shot, strip, band, other);
        }
        let [(upper, first), (lower, last)] = halves(strip, bands);
        rayon::join(|| self.bands(shot, upper, first, other), || self.bands(shot, lower, last, other));
    }

    /// Colours of what has been drawn.
    fn colours(&self, lighting: &Lighting, shot: &Shot<'_>, frame: &mut Frame) {
        let view = shot.view;
        let (strip, memory) = Strip::of(frame);
        let Memory { bands, open, .. } = memory;
        let open = (!shot.plain).then(|| shade::occlusion(view.camera, bands, open));
        let exposure = lighting.exposure(view.camera.eye().into(), seen_rooms(lighting, view, bands));
        let exposure = shot.adapts.map_or(exposure, |adapts| adapts.towards(exposure));
        shade_bands(&Shading { renderer: self, lighting, view, open, exposure }, strip, bands);
        frame.exposure = exposure;
        shade::smooth(frame);
    }

    fn band(&self, shot: &Shot<'_>, mut strip: Strip<'_>, band: &mut Band, other: &[Other; 2]) {
        let View { snapshot, camera } = shot.view;
        let wanted = shot.wanted;
        // One row more for colours, whose edges are smoothed.
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

    /// Draws everything into some rows of an image.
    fn draw(&self, view: View<'_>, rows: std::ops::Range<i32>, layers: &mut Layers, apart: bool) {
        let View { snapshot, camera } = view;
        let frustum = Frustum::new(camera, &rows);
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: self.detail };
        let all = 0..snapshot.instances.len() as u32;
        layers.draw(&drawing, all, (camera.width as usize, rows), apart);
    }

    /// What is seen at the moments after and before.
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

/// The rooms seen at places strewn over a picture, through glass.
fn seen_rooms<'a>(
    lighting: &'a Lighting,
    View { snapshot, camera }: View<'a>,
    bands: &'a [Band],
) -> impl Iterator<Item = u16> + 'a {
    camera.strewn().filter_map(move |[x, y]| {
        let band = bands.iter().find(|band| band.rows.contains(&(y as i32)))?;
        let triangle = *band.layers.solid().triangle_row(y as i32).get(x as usize)?;
        Some(lighting.room_seen(snapshot, band.layers.visible.get(triangle as usize)?, camera.eye().into()))
    })
}

/// Flow of a band, and what is hidden at the other moments.
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

/// The upper and the lower half of some bands, at a row from which light may be found.
fn halves<'a, 'b>(strip: Strip<'a>, bands: &'b mut [Band]) -> [(Strip<'a>, &'b mut [Band]); 2] {
    let middle = bands.len() / 2;
    let rows = strip.rows.len() * middle / bands.len() / shade::ALIGNED * shade::ALIGNED;
    let (upper, lower) = strip.split(rows as i32);
    let (first, last) = bands.split_at_mut(middle);
    [(upper, first), (lower, last)]
}

/// Bands for an image: one on one thread, and none lower than 32 rows.
fn count(height: u32) -> usize {
    let threads = rayon::current_num_threads();
    let most = if threads == 1 { 1 } else { 2 * threads };
    most.min(height as usize / 32).max(1)
}
