//! All modalities of a room, side by side, from a generated home or a scene file.
//!
//! `cargo run --release --example render -- --seed 42 --room livingroom --out out/render` writes one sheet.
//! `--dressed` dresses the rooms by use, `--dressing FILE` by a table of your own; `--fitted` makes a fitted kitchen.
//! `--daylight evening` or `night` is another time; at night the lamps are on. `--time` prints the cost of each
//! modality. `--reference` adds a path-traced picture, `--files` depth and flow as OpenEXR and NPY, boxes and
//! masks as COCO, and the scene with the camera and the lights as glTF. `--scene FILE` takes the home from a
//! file.

#[path = "../support/remark.rs"]
mod remark;
#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;

mod files;
mod home;
mod sheet;
mod time;

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use home::Home;
use support::{Complaint, say};
use virtualcity::graph::{Node, Property, SceneGraph};
use virtualcity::procgen::Dressing;
use virtualcity::render::{Daylight, Frame, PathTracing, Renderer, Snapshot, picture};

/// All modalities of a room.
#[derive(Parser)]
struct Options {
    /// The home's seed.
    #[arg(long, default_value_t = 42, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// A scene file with the home (may be gzipped), instead of a generated one; things without shapes get those of
    /// their class.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// Dress the generated home by the built-in table.
    #[arg(long, conflicts_with = "scene")]
    dressed: bool,
    /// Dress the generated home by a table of your own.
    #[arg(long, conflicts_with = "scene")]
    dressing: Option<PathBuf>,
    /// Make the generated home with a fitted kitchen, if there is space for one.
    #[arg(long, conflicts_with = "scene")]
    fitted: bool,
    /// Class of the room.
    #[arg(long, default_value = "livingroom")]
    room: String,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/render")]
    out: PathBuf,
    /// Width, pixels.
    #[arg(long, default_value_t = 640, value_parser = clap::value_parser!(u32).range(16..=4096))]
    width: u32,
    /// Height, pixels.
    #[arg(long, default_value_t = 480, value_parser = clap::value_parser!(u32).range(16..=4096))]
    height: u32,
    /// The daylight.
    #[arg(long, value_enum, default_value_t = Hour::Day)]
    daylight: Hour,
    /// Also make the path-traced reference picture, with this number of paths per pixel.
    #[arg(long, num_args = 0..=1, default_missing_value = "48",
        value_parser = clap::value_parser!(u32).range(1..=100_000))]
    reference: Option<u32>,
    /// Do not denoise the reference picture.
    #[arg(long)]
    raw: bool,
    /// Seed of the reference picture's noise.
    #[arg(long, default_value_t = 0)]
    noise: u32,
    /// Also write files for other programs.
    #[arg(long)]
    files: bool,
    /// Print the cost of each modality.
    #[arg(long)]
    time: bool,
}

/// Time of day, or weather.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Hour {
    Day,
    Evening,
    Overcast,
    Night,
}

impl Hour {
    fn daylight(self) -> Daylight {
        match self {
            Self::Day => Daylight::noon(),
            Self::Evening => Daylight::clear(0.2, 3.6),
            Self::Overcast => Daylight::overcast(),
            Self::Night => Daylight::night(),
        }
    }
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let dressing = match &options.dressing {
        Some(path) => Some(Dressing::parse(&path.display().to_string(), &std::fs::read_to_string(path)?)?),
        None => options.dressed.then(Dressing::builtin),
    };
    let home = match &options.scene {
        Some(path) => Home::read(path)?,
        None => Home::generated(options.seed, dressing, options.fitted)?,
    };
    remark::on_walls(&home.scene);
    let room = home.room(&options.room)?;
    virtualcity::files::create_folder(&options.out)?;
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&home.scene).map_err(Complaint::new)?;
    switch_lamps(&home.scene, &mut snapshot, options.daylight == Hour::Night)?;
    let camera = home.camera(room, (&renderer, &snapshot), (options.width, options.height))?;
    let start = std::time::Instant::now();
    let lighting = renderer.light(&snapshot, &options.daylight.daylight());
    say!("{} triangles; light made in {:.0} ms", snapshot.triangles(), 1e3 * start.elapsed().as_secs_f64());
    if options.time {
        return time::table(&renderer, &snapshot, &camera, &lighting);
    }
    let mut frame = Frame::new();
    let sheet = sheet::all(&renderer, &snapshot, &camera, &lighting, &mut frame).map_err(Complaint::new)?;
    let file = options.scene.as_ref().and_then(|path| path.file_stem()).map(|name| name.to_string_lossy().into_owned());
    let name = format!("{}_{}", options.room, file.unwrap_or_else(|| options.seed.to_string()));
    write(&options.out.join(format!("{name}.png")), &picture::rgb(&frame))?;
    write(&options.out.join(format!("{name}_sheet.png")), &sheet)?;
    if options.files {
        files::all(&options.out.join(&name), (&home.scene, &snapshot), &camera, &lighting, &frame)?;
    }
    let Some(samples) = options.reference else { return Ok(()) };
    let how = PathTracing { samples, denoise: !options.raw, seed: options.noise, ..PathTracing::default() };
    let progress = indicatif::ProgressBar::new(u64::from(samples));
    let start = cpu_time::ProcessTime::now();
    let reference_picture = renderer.reference_picture(&lighting, &camera, &how, |made| {
        progress.set_position(u64::from(made.rounds));
        true
    });
    progress.finish_and_clear();
    let reference_picture = reference_picture.map_err(Complaint::new)?;
    say!("{samples} paths for each pixel: {:.2} s CPU", start.elapsed().as_secs_f64());
    if options.files {
        files::light(&options.out.join(format!("{name}_reference")), &reference_picture)?;
    }
    write(&options.out.join(format!("{name}_reference.png")), &reference_picture.picture())
}

fn write(path: &std::path::Path, image: &picture::Picture) -> Result<(), Complaint> {
    let bytes = picture::png(image).map_err(Complaint::new)?;
    virtualcity::files::write(path, bytes)?;
    say!("wrote {}", path.display());
    Ok(())
}

/// Switches on all lamps: at night everywhere, by day in rooms without a window. Spare bulbs and torches stay
/// off.
fn switch_lamps(scene: &SceneGraph, snapshot: &mut Snapshot, night: bool) -> Result<(), Complaint> {
    let lit = |room| scene.nodes().any(|n| **n.class() == *"window" && scene.room_of(n.id()) == room);
    for lamp in snapshot.lamps().collect::<Vec<_>>() {
        let spare = |n: &Node| n.affords(Property::Graspable) && !n.affords(Property::Plug);
        if (night || !lit(scene.room_of(lamp))) && !scene.node(lamp).is_some_and(spare) {
            snapshot.switch(lamp, true).map_err(Complaint::new)?;
        }
    }
    Ok(())
}
