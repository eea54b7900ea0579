//! Moves vehicles and people over a map, films them from above, and sums up how they fared.
//!
//! ```text
//! cargo run --release --example traffic -- --seed 7 --out out/traffic
//! ```
//!
//! FILE is OpenStreetMap's XML, plain or packed by gzip; without one the hand-drawn town of `vc-map/data` is read. Trips and walks are random
//! by the seed, from kerb to kerb and from door to door. `traffic.gif` shows the last part of the time: cars in dark blue, vans green,
//! motorcycles purple, whoever stands in red, people in orange. `summary.txt` is what is printed.

#[path = "../map/raster.rs"]
#[allow(dead_code, reason = "the example `map` needs more of it")]
mod raster;
#[path = "../support/mod.rs"]
mod support;

use std::io::Read;
use std::path::PathBuf;

use clap::Parser;
use support::{Complaint, say};
use tiny_skia::{FillRule, PathBuilder, Pixmap, Transform};
use vc_graph::Seed;
use vc_map::osm::{ImportOptions, OsmData};
use vc_map::picture::{Colour, Drawing};
use vc_map::{EntranceId, Point, StreetMap, Users};
use vc_render::picture::{self, Picture};
use vc_traffic::{Kerb, Pose, Traffic, TrafficEvent, TrafficOptions, Trip, Walk};

/// The town that is read without a file.
const OWN: &str = include_str!("../../vc-map/data/riverside.osm");

/// Pictures a second, and steps between two of them.
const RATE: u16 = 10;
const STEPS: usize = 2;
/// Kinds of vehicles on the road, and the colours of all kinds, of those who stand, and of people.
const KINDS: [u8; 5] = [0, 0, 0, 1, 4];
const COLOURS: [Colour; 5] = [[24, 54, 120], [30, 110, 70], [110, 80, 40], [150, 110, 0], [110, 40, 130]];
const STANDS: Colour = [205, 30, 40];
const PERSON: Colour = [240, 120, 0];
/// The radius of a person in the picture, metres, so that they are seen.
const SEEN: f32 = 0.45;

#[derive(Parser)]
#[command(about = "Moves vehicles and people over a map, and films them")]
struct Arguments {
    /// OpenStreetMap's XML, plain or packed by gzip.
    file: Option<PathBuf>,
    /// The folder for the film and the summary.
    #[arg(long)]
    out: PathBuf,
    /// The seed of all that is random.
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Vehicles and people that set out in ten minutes.
    #[arg(long, default_value_t = 400)]
    vehicles: usize,
    /// The people among these.
    #[arg(long, default_value_t = 300)]
    people: usize,
    /// The time that is filmed after five minutes, seconds.
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=300))]
    film: u32,
    /// Pixels for a metre.
    #[arg(long, default_value_t = 1.0)]
    scale: f64,
}

fn main() -> Result<(), Complaint> {
    let arguments = Arguments::parse();
    let map = map(&arguments)?;
    let seed = Seed(arguments.seed);
    let traffic = Traffic::new(&map, trips(&map, arguments.vehicles, seed), &TrafficOptions::default(), seed)?;
    let mut traffic = traffic.with_walks(walks(&map, arguments.people, seed))?;
    std::fs::create_dir_all(&arguments.out)?;
    let mut sums = Sums::default();
    (0..3000).for_each(|_| sums.step(&mut traffic));
    let drawing = Drawing::of(&map);
    let scale = raster::scale(&drawing, arguments.scale);
    let ground = raster::canvas(&drawing, scale)?;
    let frames = arguments.film as usize * 10 / STEPS;
    let film: Vec<Picture> = (0..frames)
        .map(|_| {
            (0..STEPS).for_each(|_| sums.step(&mut traffic));
            frame(&ground, &drawing, scale, &traffic)
        })
        .collect();
    std::fs::write(arguments.out.join("traffic.gif"), picture::gif(&film, RATE)?)?;
    while traffic.seconds() < 3600.0 && !(traffic.is_empty() && traffic.people().next().is_none() && sums.all(&traffic))
    {
        sums.step(&mut traffic);
    }
    let text = sums.text(&traffic);
    say!("{}", text.trim_end());
    std::fs::write(arguments.out.join("summary.txt"), text)?;
    say!("traffic.gif and summary.txt in {}", arguments.out.display());
    Ok(())
}

/// The map of a file, or the hand-drawn one.
fn map(arguments: &Arguments) -> Result<StreetMap, Complaint> {
    let bytes = match &arguments.file {
        Some(path) => {
            std::fs::read(path).map_err(|error| Complaint::new(format_args!("{}: {error}", path.display())))?
        }
        None => OWN.as_bytes().to_vec(),
    };
    let mut plain = Vec::new();
    if bytes.starts_with(&[0x1f, 0x8b]) {
        flate2::read::MultiGzDecoder::new(bytes.as_slice())
            .take(vc_map::osm::LARGEST as u64)
            .read_to_end(&mut plain)?;
    } else {
        plain = bytes;
    }
    Ok(OsmData::read(&plain)?.draft(&ImportOptions::default())?.0.build()?)
}

/// Random trips from kerb to kerb, which begin within ten minutes.
fn trips(map: &StreetMap, count: usize, seed: Seed) -> Vec<Trip> {
    let mut numbers = seed.child("trips").stream();
    let long = |lane: &&vc_map::Lane| lane.users.has(Users::CAR) && lane.line.length() > 30.0;
    let lanes: Vec<&vc_map::Lane> = map.lanes().iter().filter(long).collect();
    if lanes.is_empty() {
        return Vec::new();
    }
    let kerb = |numbers: &mut vc_graph::Stream| {
        let lane = lanes[numbers.below(lanes.len())];
        let station = numbers.between(15.0, lane.line.length() as f32 - 12.0);
        Kerb { road: lane.road, forward: lane.forward, station }
    };
    (0..count)
        .map(|_| {
            let (from, to) = (kerb(&mut numbers), kerb(&mut numbers));
            Trip { class: KINDS[numbers.below(KINDS.len())], departs: numbers.between(0.0, 600.0), from, to }
        })
        .collect()
}

/// Random walks from door to door, which begin within ten minutes.
fn walks(map: &StreetMap, count: usize, seed: Seed) -> Vec<Walk> {
    let mut numbers = seed.child("walks").stream();
    let doors = map.entrances().len();
    if doors < 2 {
        return Vec::new();
    }
    let walk = |_| {
        let from = numbers.below(doors);
        let to = (from + 1 + numbers.below(doors - 1)) % doors;
        let [from, to] = [from, to].map(|door| EntranceId(door as u32));
        Walk { departs: numbers.between(0.0, 600.0), from, to }
    };
    (0..count).map(walk).collect()
}

/// A picture of all who are on their way.
fn frame(ground: &Pixmap, drawing: &Drawing, scale: f64, traffic: &Traffic) -> Picture {
    let mut canvas = ground.clone();
    let mut fill = |colour: Colour, path: Option<tiny_skia::Path>| {
        if let Some(path) = path {
            canvas.fill_path(&path, &raster::brush(colour), FillRule::Winding, Transform::identity(), None);
        }
    };
    for (_, pose) in traffic.vehicles() {
        let colour = if pose.speed < 0.1 { STANDS } else { COLOURS[usize::from(pose.class) % COLOURS.len()] };
        fill(colour, body(&pose, drawing, scale));
    }
    for walker in traffic.people() {
        let [x, y] = drawing.pixel(&Point::new(f64::from(walker.at[0]), f64::from(walker.at[1])), scale);
        fill(PERSON, PathBuilder::from_circle(x as f32, y as f32, (SEEN * scale as f32).max(1.0)));
    }
    let mut picture = Picture::new(canvas.width() as usize, canvas.height() as usize, [0; 3]);
    let colours = canvas.pixels().iter().map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]);
    picture.pixels.iter_mut().zip(colours).for_each(|(to, colour)| *to = colour);
    picture
}

fn body(pose: &Pose, drawing: &Drawing, scale: f64) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for (number, corner) in pose.corners().iter().enumerate() {
        let [x, y] = drawing.pixel(corner, scale);
        if number == 0 { builder.move_to(x as f32, y as f32) } else { builder.line_to(x as f32, y as f32) }
    }
    builder.close();
    builder.finish()
}

/// How all fared.
#[derive(Default)]
struct Sums {
    departed: usize,
    arrived: usize,
    no_way: usize,
    lost: usize,
    rerouted: usize,
    stuck: usize,
    metres: f64,
    seconds: f64,
    set_off: usize,
    reached: usize,
    no_walk: usize,
    walked: f64,
    walking: f64,
    overlaps: usize,
    /// Steps of vehicles, and those of them in which they stood.
    steps: usize,
    stood: usize,
}

impl Sums {
    fn step(&mut self, traffic: &mut Traffic) {
        traffic.step();
        self.overlaps += traffic.overlaps().len();
        self.steps += traffic.len();
        self.stood += traffic.vehicles().filter(|(_, pose)| pose.speed < 0.1).count();
        for event in traffic.events() {
            match event {
                TrafficEvent::Departed { .. } => self.departed += 1,
                TrafficEvent::Arrived { seconds, metres, .. } => {
                    self.arrived += 1;
                    (self.seconds, self.metres) =
                        (self.seconds + f64::from(*seconds), self.metres + f64::from(*metres));
                }
                TrafficEvent::NoWay { .. } => self.no_way += 1,
                TrafficEvent::Lost { .. } => self.lost += 1,
                TrafficEvent::Rerouted { .. } => self.rerouted += 1,
                TrafficEvent::Stuck { .. } | TrafficEvent::StuckOnFoot { .. } => self.stuck += 1,
                TrafficEvent::SetOff { .. } => self.set_off += 1,
                TrafficEvent::Reached { seconds, metres, .. } => {
                    self.reached += 1;
                    (self.walking, self.walked) =
                        (self.walking + f64::from(*seconds), self.walked + f64::from(*metres));
                }
                TrafficEvent::NoWalk { .. } => self.no_walk += 1,
                _ => {}
            }
        }
    }

    /// Whether nobody is still to set out.
    fn all(&self, traffic: &Traffic) -> bool {
        traffic.waiting() + traffic.waiting_on_foot() == 0
    }

    fn text(&self, traffic: &Traffic) -> String {
        let part = |a: f64, b: f64| a / b.max(1.0);
        let rows = [
            ("seconds", format!("{:.0}", traffic.seconds())),
            ("trips that began", self.departed.to_string()),
            ("arrived", self.arrived.to_string()),
            ("without a way", self.no_way.to_string()),
            ("that went another way, as they did not get into their lane", self.rerouted.to_string()),
            ("that were lost there", self.lost.to_string()),
            ("mean speed of those who arrived, m/s", format!("{:.1}", part(self.metres, self.seconds))),
            ("of their time stood, %", format!("{:.0}", 100.0 * part(self.stood as f64, self.steps as f64))),
            ("walks that began", self.set_off.to_string()),
            ("that reached their door", self.reached.to_string()),
            ("without a way", self.no_walk.to_string()),
            ("mean speed on foot, waits included, m/s", format!("{:.2}", part(self.walked, self.walking))),
            ("who stood for five minutes", self.stuck.to_string()),
            ("overlaps of bodies, summed over steps", self.overlaps.to_string()),
        ];
        rows.iter().map(|(name, value)| format!("{value:>8}  {name}\n")).collect()
    }
}
