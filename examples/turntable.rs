//! An object from all sides, as an animated PNG.
//!
//! `cargo run --release --example turntable -- --class armchair --out out/turntable` moves the camera once
//! around an armchair from the catalogue; `--index 3` selects another one, `--open` opens doors and drawers on
//! the way and closes them again. `--labels` shows depth, normals and the moving parts beside it.
//! `--model chair.glb` shows a model of your own instead, with its textures.

#[path = "support/seed.rs"]
mod seed;
#[path = "support/mod.rs"]
mod support;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Parser;
use nalgebra::{Point3, Vector3};
use support::{Complaint, say};
use virtualcity::gltf;
use virtualcity::graph::asset::{Joint, Part, Shape};
use virtualcity::graph::portable::Portable;
use virtualcity::graph::{
    Asset, AssetId, AssetLibrary, Draft, NodeId, Pose, SceneBuilder, SceneGraph, Seed, did_you_mean,
};
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Daylight, Frame, Modality, Renderer, Shot};
use virtualcity::shapes::material;
use virtualcity::shapes::object::{generator, generators};

/// An object from all sides.
#[derive(Parser)]
struct Options {
    /// A model to show (glTF, .glb) instead of one from the catalogue.
    #[arg(long)]
    model: Option<PathBuf>,
    /// Class of the object.
    #[arg(long, default_value = "armchair")]
    class: String,
    /// Index of the object in its class.
    #[arg(long, default_value_t = 0)]
    index: usize,
    /// The seed from which objects are generated.
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/turntable")]
    out: PathBuf,
    /// Pictures per turn.
    #[arg(long, default_value_t = 48, value_parser = clap::value_parser!(u32).range(1..=720))]
    pictures: u32,
    /// Side of a picture, pixels.
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=2048))]
    side: u32,
    /// Pictures per second.
    #[arg(long, default_value_t = 16)]
    rate: u16,
    /// Open doors and drawers on the way.
    #[arg(long)]
    open: bool,
    /// Show labels beside the colours.
    #[arg(long)]
    labels: bool,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let object = match &options.model {
        Some(path) => model(path)?,
        None => catalogued(&options)?,
    };
    let (scene, node) = stage(&object)?;
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&scene).map_err(Complaint::new)?;
    let lighting = renderer.light(&snapshot, &Daylight::clear(0.9, 0.6));
    let cameras = around(&object, &options);
    let mut pictures = Vec::new();
    let mut frame = Frame::new();
    for (index, camera) in cameras.iter().enumerate() {
        let next = &cameras[(index + 1) % cameras.len()];
        let mut then = snapshot.clone();
        if options.open {
            let share = swing((index + 1) as f32 / cameras.len() as f32);
            then.articulate(node, |j| Some(farthest(j) * share)).map_err(Complaint::new)?;
        }
        let wanted = Modality::Rgb | Modality::Depth | Modality::Normal | Modality::FlowForward;
        renderer
            .render(&Shot::new(&snapshot, camera, wanted).lit(&lighting).after(&then, next).supersampled(2), &mut frame)
            .map_err(Complaint::new)?;
        pictures.push(shown(&frame, &options, &object));
        snapshot = then;
    }
    let path = options.out.join(format!("{}.png", object.file));
    let bytes = picture::apng(&pictures, options.rate).map_err(Complaint::new)?;
    virtualcity::files::write(&path, bytes)?;
    say!("{} parts, {} pictures: {}", object.asset.parts.len(), pictures.len(), path.display());
    Ok(())
}

/// The object that is shown.
struct Object {
    class: String,
    /// Name of the output file.
    file: String,
    asset: Arc<Asset>,
    id: AssetId,
    library: AssetLibrary,
}

impl Object {
    fn size(&self) -> Vector3<f32> {
        self.asset.extent().map_or_else(Vector3::zeros, |(low, high)| high - low)
    }
}

fn catalogued(options: &Options) -> Result<Object, Complaint> {
    let Options { class, index, .. } = options;
    let near = || did_you_mean(class, generators().map(|g| g.class));
    let made = generator(class).ok_or_else(|| Complaint::new(format!("no generator makes `{class}`{}", near())))?;
    let asset = Arc::new(made.instance(Seed(options.seed), *index).object.asset);
    let mut library = material::library();
    let id = library.share(asset.clone()).map_err(Complaint::new)?;
    Ok(Object { class: class.clone(), file: format!("{class}_{index}"), asset, id, library })
}

/// Reads a model from a file, with its textures.
fn model(path: &Path) -> Result<Object, Complaint> {
    let complaint = |e: String| Complaint::new(format!("{}: {e}", path.display()));
    let bytes = virtualcity::read_bytes(path).map_err(Complaint::new)?;
    let model = gltf::read(&bytes, &gltf::ImportOptions::default()).map_err(|e| complaint(e.to_string()))?;
    model.missing_images.iter().for_each(|why| say!("{}: plain where a picture is missing: {why}", path.display()));
    let mut library = material::library();
    let id = model.add_to(&mut library).map_err(|e| complaint(e.to_string()))?;
    let class = model.class.map_or_else(|| "model".to_owned(), |c| c.to_string());
    let file = path.file_stem().map_or_else(|| class.clone(), |n| n.to_string_lossy().into_owned());
    let asset = library.get(id).cloned().unwrap_or_default();
    Ok(Object { class, file, asset, id, library })
}

/// Puts the object on a floor that is wider than the picture.
fn stage(object: &Object) -> Result<(SceneGraph, NodeId), Complaint> {
    let mut library = object.library.clone();
    let wide = 10.0 * object.size().norm();
    let slab = Shape::Box { half: Vector3::new(wide, wide, 0.05) };
    let part =
        Part { name: "slab".into(), shape: slab, material: material::WHITE.0, pose: Pose::identity(), joint: None };
    let floor =
        library.add(Asset { name: "floor".into(), parts: vec![part], ..Asset::default() }).map_err(Complaint::new)?;
    let mut scene = SceneBuilder::new("turntable");
    let room = scene.add(Draft::new("livingroom")).map_err(Complaint::new)?;
    let low = object.asset.extent().map_or(0.0, |(low, _)| low.z);
    let draft =
        |class: &str, asset, z| Draft { asset: Some(asset), ..Draft::new(class).at(Pose::translation(0.0, 0.0, z)) };
    let node = scene.add_in(room, draft(&object.class, object.id, -low)).map_err(Complaint::new)?;
    scene.add_in(room, draft("floor", floor, -0.0501)).map_err(Complaint::new)?;
    scene.assets(Arc::new(library));
    Ok((scene.build(), node))
}

/// Cameras on a circle that is wide enough to see the whole object.
fn around(object: &Object, options: &Options) -> Vec<Camera> {
    let (low, high) = object.asset.extent().unwrap_or_default();
    let (size, middle) = (high - low, nalgebra::center(&low, &high));
    let target = Point3::new(middle.x, middle.y, 0.5 * size.z);
    let camera = Camera::with_fov(options.side, options.side, 0.6);
    // The distance at which a sphere around it fits into the view, including its open drawers.
    let radius = 0.5 * size.norm() * if options.open { 1.3 } else { 1.05 };
    camera.around(target, radius / 0.3_f32.sine(), 0.4, options.pictures as usize)
}

/// The opening from closed to open and back, smoothly.
fn swing(turn: f32) -> f32 {
    0.5 - 0.5 * (std::f32::consts::TAU * turn).cosine()
}

/// The joint limit that is farther from zero.
fn farthest(joint: &Joint) -> f32 {
    let (low, high) = joint.limits;
    if high >= -low { high } else { low }
}

fn shown(frame: &Frame, options: &Options, object: &Object) -> Picture {
    let rgb = picture::rgb(frame);
    if !options.labels {
        return rgb;
    }
    let far = 4.0 * object.size().norm();
    let labels = [rgb, picture::depth(frame, far), picture::normals(frame), picture::flow(frame, 12.0)];
    Picture::sheet(&labels, 2, 2)
}
