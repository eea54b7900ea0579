//! A camera's walk through a generated home, with the optical flow beside the colours.
//!
//! `cargo run --release --example flythrough -- --seed 42 --out out/flythrough` plans the shortest way from
//! room to room, opens the doors on it, and writes an animated PNG: colours and flow, and with `--labels`
//! instances and depth below. `--exr` also writes depth and flow of every picture.

#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;

mod path;

use std::path::{Path, PathBuf};

use clap::Parser;
use support::{Complaint, say};
use virtualcity::graph::Seed;
use virtualcity::procgen::Apartment;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Adaptation, Camera, Daylight, Frame, Modality, Renderer, Shot, format};

/// A walk through a home.
#[derive(Parser)]
struct Options {
    /// The home's seed.
    #[arg(long, default_value_t = 42, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/flythrough")]
    out: PathBuf,
    /// Largest number of pictures.
    #[arg(long, default_value_t = 240, value_parser = clap::value_parser!(u32).range(2..=5000))]
    pictures: u32,
    /// Width, pixels.
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=2048))]
    width: u32,
    /// Height, pixels.
    #[arg(long, default_value_t = 240, value_parser = clap::value_parser!(u32).range(16..=2048))]
    height: u32,
    /// Pictures per second.
    #[arg(long, default_value_t = 12, value_parser = clap::value_parser!(u16).range(1..=240))]
    rate: u16,
    /// Walking speed, metres per second.
    #[arg(long, default_value_t = 1.2, value_parser = speed)]
    speed: f32,
    /// Show instances and depth as well.
    #[arg(long)]
    labels: bool,
    /// Write depth and flow as OpenEXR, one file per picture.
    #[arg(long)]
    exr: bool,
}

/// Parses a speed, metres per second.
fn speed(text: &str) -> Result<f32, String> {
    let speed = text.parse().ok().filter(|speed| (0.01..=100.0).contains(speed));
    speed.ok_or_else(|| "a speed is a number from 0.01 to 100, metres a second".to_owned())
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    virtualcity::files::create_folder(&options.out)?;
    let mut scene = Apartment::from_seed(Seed(options.seed)).map_err(Complaint::new)?.scene();
    let walk = path::through(&mut scene)?;
    let step = options.speed / f32::from(options.rate);
    let camera = Camera::with_fov(options.width, options.height, 1.2);
    let cameras = walk.cameras(camera, step, options.pictures as usize + 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene).map_err(Complaint::new)?;
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let mut frame = Frame::new();
    let mut pictures = Vec::new();
    for pair in cameras.windows(2) {
        let mut wanted = Modality::Rgb | Modality::FlowForward;
        if options.labels || options.exr {
            wanted |= Modality::Instance | Modality::Depth;
        }
        let adapts = (!pictures.is_empty()).then(|| Adaptation::after(frame.exposure, 1.0 / f32::from(options.rate)));
        let shot = Shot::new(&snapshot, &pair[0], wanted).lit(&lighting).after(&snapshot, &pair[1]);
        let shot = Shot { adaptation: adapts, ..shot };
        renderer.render(&shot, &mut frame).map_err(Complaint::new)?;
        if options.exr {
            write(&options.out.join(format!("{:04}.exr", pictures.len())), &exr(&frame)?)?;
        }
        pictures.push(shown(&frame, options.labels));
    }
    let path = options.out.join(format!("flythrough_{}.png", options.seed));
    write(&path, &picture::apng(&pictures, options.rate).map_err(Complaint::new)?)?;
    say!("{:.1} m through {} rooms, {} pictures: {}", walk.length(), walk.rooms, pictures.len(), path.display());
    Ok(())
}

fn shown(frame: &Frame, labels: bool) -> Picture {
    let mut all = vec![picture::rgb(frame), picture::flow(frame, 20.0)];
    if labels {
        all.extend([picture::instances(frame), picture::depth(frame, 8.0)]);
    }
    Picture::sheet(&all, 2, 2)
}

/// Depth and flow of a picture as OpenEXR.
fn exr(frame: &Frame) -> Result<Vec<u8>, Complaint> {
    let axis = |i: usize| frame.flow_forward.iter().map(|f| f[i]).collect::<Vec<f32>>();
    let (u, v) = (axis(0), axis(1));
    let channels = [("Z", frame.depth.as_slice()), ("forward.u", &u), ("forward.v", &v)];
    format::exr(frame.width, frame.height, &channels).map_err(Complaint::new)
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    Ok(virtualcity::files::write(path, bytes)?)
}
