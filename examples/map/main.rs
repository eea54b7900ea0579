//! Reads a map, draws it, lists what was guessed, dropped and found wrong, and writes it in all other forms.
//!
//! ```text
//! cargo run --release --example map -- FILE --out out/map
//! ```
//!
//! FILE is OpenStreetMap's XML or PBF, or VirtualCity's own map JSON, each plain or packed by gzip. Without one the hand-drawn map
//! of `vc-map/data` is read.
#![allow(clippy::disallowed_methods, reason = "a program says how long it takes")]

mod raster;
#[path = "../support/mod.rs"]
mod support;

use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;
use support::{Complaint, say};
use vc_map::format::{geojson, native, opendrive, skeleton, sumo};
use vc_map::osm::{ImportOptions, OsmData};
use vc_map::picture::Drawing;
use vc_map::route::{Mode, Router};
use vc_map::{Control, CrossSection, DrivingSide, MapDraft, RoadClass, StreetMap, Strip, Users};

/// The map that is read without a file.
const OWN: &str = include_str!("../../vc-map/data/riverside.osm");

/// A packed file may unpack to this many times its size. Maps take ten to fifteen.
const UNPACKED: usize = 40;

#[derive(Parser)]
#[command(about = "Reads a map, draws it, and writes it in all other forms")]
struct Arguments {
    /// OpenStreetMap's XML or PBF or a map JSON, plain or packed by gzip.
    file: Option<PathBuf>,
    /// The folder for pictures and files; nothing is written without one.
    #[arg(long)]
    out: Option<PathBuf>,
    /// The side on which vehicles drive, instead of guessing: left or right.
    #[arg(long, value_parser = ["left", "right"])]
    side: Option<String>,
    /// Pixels for a metre, up to 100.
    #[arg(long, default_value_t = 2.0, value_parser = scale)]
    scale: f64,
    /// Instead of a file, a grid of so many by so many junctions with lights, 110 m apart: 36 make 15 square kilometres.
    #[arg(long, value_parser = clap::value_parser!(u32).range(2..=300))]
    grid: Option<u32>,
    /// Only this part is drawn: west, south, east, north, metres from the middle.
    #[arg(long, allow_hyphen_values = true, value_parser = part)]
    part: Option<[f64; 4]>,
}

/// A number of pixels for a metre.
fn scale(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| *value > 0.0 && *value <= 100.0);
    value.ok_or_else(|| "give pixels for a metre, more than 0 and at most 100".to_owned())
}

/// The edges of a part of a map.
fn part(text: &str) -> Result<[f64; 4], String> {
    let edges: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let edges = edges.ok().and_then(|edges| <[f64; 4]>::try_from(edges).ok());
    let fits = |[west, south, east, north]: &[f64; 4]| {
        [west, south, east, north].iter().all(|e| e.is_finite()) && west < east && south < north
    };
    edges.filter(fits).ok_or_else(|| "give west, south, east and north in metres, as -100,-50,100,50".to_owned())
}

fn main() -> Result<(), Complaint> {
    let arguments = Arguments::parse();
    let (name, text) = match arguments.grid {
        Some(_) => ("grid".to_owned(), Vec::new()),
        None => text(arguments.file.as_deref())?,
    };
    let begun = Instant::now();
    let (map, account) = match arguments.grid {
        Some(count) => (grid(count)?, String::new()),
        None => read(&name, &text, arguments.side.as_deref())?,
    };
    say!("{name}: {} bytes in {:.3} s", text.len(), begun.elapsed().as_secs_f64());
    print(&map, &account);
    routes(&map);
    if let Some(folder) = &arguments.out {
        std::fs::create_dir_all(folder)?;
        write(&map, &account, folder, &name, &arguments)?;
        say!("written to {}", folder.display());
    }
    Ok(())
}

/// The name and content of a file, unpacked.
fn text(file: Option<&Path>) -> Result<(String, Vec<u8>), Complaint> {
    let Some(path) = file else { return Ok(("riverside".to_owned(), OWN.as_bytes().to_vec())) };
    let packed = std::fs::read(path).map_err(|error| Complaint::new(format_args!("{}: {error}", path.display())))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let ends = [".gz", ".osm", ".xml", ".pbf", ".json", ".map", ".osm"];
    let name =
        ends.iter().fold(&*name, |name, end| name.strip_suffix(end).filter(|rest| !rest.is_empty()).unwrap_or(name));
    let name = name.to_owned();
    if packed.starts_with(&[0x1f, 0x8b]) {
        let mut plain = Vec::new();
        let most = packed.len().saturating_mul(UNPACKED).clamp(1 << 20, vc_map::osm::LARGEST);
        flate2::read::MultiGzDecoder::new(packed.as_slice()).take(most as u64 + 1).read_to_end(&mut plain)?;
        if plain.len() > most {
            let why = format!("unpacks to more than {most} bytes, as no map does: unpack it yourself if it is one");
            return Err(Complaint::new(format_args!("{}: {why}", path.display())));
        }
        return Ok((name, plain));
    }
    Ok((name, packed))
}

/// The map of a text, and the account of its import.
fn read(name: &str, text: &[u8], side: Option<&str>) -> Result<(StreetMap, String), Complaint> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    if text.trim_ascii_start().starts_with(b"{") {
        return Ok((native::read(std::str::from_utf8(text)?)?, String::new()));
    }
    let side = side.map(|side| if side == "left" { DrivingSide::Left } else { DrivingSide::Right });
    let options = ImportOptions { name: name.to_owned(), side };
    let (draft, report) = OsmData::read(text)?.draft(&options)?;
    Ok((draft.build_of_file(text.len())?, report.to_string()))
}

/// A grid of streets, every fourth of which is a main street.
fn grid(count: u32) -> Result<StreetMap, Complaint> {
    let mut draft = MapDraft::new("grid", 48.0, 11.0);
    let cells = (0..count).flat_map(|y| (0..count).map(move |x| (x, y)));
    let at = |(x, y): (u32, u32)| [110.0 * f64::from(x) + f64::from((x + 3 * y) % 7), 110.0 * f64::from(y)];
    let ids: Vec<_> = cells.clone().map(|cell| draft.junction(at(cell), Control::Signals)).collect();
    for (x, y) in cells {
        let here = (y * count + x) as usize;
        for (next, there, line) in [(x + 1, here + 1, y), (y + 1, here + count as usize, x)] {
            let (class, limit) =
                if line % 4 == 0 { (RoadClass::Secondary, 13.9) } else { (RoadClass::Residential, 8.3) };
            let side = vec![Strip::driving(3.0, limit), Strip::pavement(2.4)];
            if next < count {
                draft.road(
                    ids[here],
                    ids[there],
                    class,
                    CrossSection { forward: side.clone(), backward: side, median: 0.0 },
                );
            }
        }
    }
    Ok(draft.build()?)
}

fn print(map: &StreetMap, account: &str) {
    let rows = [
        ("junctions", map.junctions().len()),
        ("of them with lights", map.signals().len()),
        ("roads", map.roads().len()),
        ("lanes", map.lanes().len()),
        ("movements", map.movements().len()),
        ("crossings", map.crossings().len()),
        ("buildings", map.buildings().len()),
        ("doors", map.entrances().len()),
        ("areas", map.areas().len()),
        ("stops", map.stops().len()),
        ("parking bays", map.bays().count()),
    ];
    rows.iter().for_each(|(what, count)| say!("{count:7}  {what}"));
    let drives = map.length_of(|lane, road| lane.users.any(Users::CAR | Users::BUS) && road.draft.class.is_through());
    say!("{:7.2}  km of lanes for through traffic", drives / 1000.0);
    let parts = map.walk_parts();
    let all: f64 = parts.iter().map(|(_, metres)| metres).sum();
    let main = parts.first().map_or(0.0, |(_, metres)| *metres);
    say!("{:7.2}  km to walk, {:.1} % in one piece", all / 1000.0, 100.0 * main / all.max(1.0));
    say!("{:7}  values guessed", account.lines().filter(|line| line.starts_with("guessed")).count());
    say!("{:7}  elements dropped", account.lines().filter(|line| line.starts_with("dropped")).count());
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    map.validate().iter().for_each(|violation| *kinds.entry(violation.kind()).or_default() += 1);
    kinds.iter().for_each(|(kind, count)| say!("{count:7}  violations: {kind}"));
}

/// Times routes between places all over the map.
fn routes(map: &StreetMap) {
    let ends: Vec<_> =
        map.junctions().iter().filter(|junction| junction.draft.control != Control::Edge).map(|j| j.at).collect();
    for mode in [Mode::Car, Mode::Bicycle, Mode::Foot] {
        let begun = Instant::now();
        let router = Router::new(map, mode);
        let made = begun.elapsed();
        let mut times = Vec::new();
        let mut found = 0;
        for index in 0..ends.len().min(500) {
            let (from, to) = (ends[index * 7919 % ends.len()], ends[index * 104_729 % ends.len()]);
            let begun = Instant::now();
            found += usize::from(router.route(&from, &to).is_some());
            times.push(begun.elapsed());
        }
        times.sort_unstable();
        if let Some(median) = times.get(times.len() / 2) {
            let micros = [median.as_micros(), made.as_micros()];
            say!(
                "routes {mode}: {found} of {}, median {} microseconds, prepared in {}",
                times.len(),
                micros[0],
                micros[1]
            );
        }
    }
}

/// Whether no road comes into a part of a map.
fn is_outside(map: &StreetMap, [west, south, east, north]: [f64; 4]) -> bool {
    let within = |at: &vc_map::Point| (west..=east).contains(&at.x) && (south..=north).contains(&at.y);
    let points = |line: &vc_map::Polyline| {
        (0..=(line.length() / 5.0) as u32).map(|i| line.at(f64::from(i) * 5.0)).collect::<Vec<_>>()
    };
    !map.roads().iter().any(|road| points(&road.line).iter().any(within))
}

fn write(map: &StreetMap, account: &str, folder: &Path, name: &str, arguments: &Arguments) -> Result<(), Complaint> {
    if let Some(part) = arguments.part.filter(|part| is_outside(map, *part)) {
        return Err(Complaint::new(format_args!("--part {part:?}: no road lies there")));
    }
    let drawing = match arguments.part {
        Some([west, south, east, north]) => Drawing::within(map, [[west, south].into(), [east, north].into()]),
        None => Drawing::of(map),
    };
    let put = |end: &str, text: &str| std::fs::write(folder.join(format!("{name}.{end}")), text);
    put("svg", &drawing.svg(arguments.scale))?;
    let scale = raster::scale(&drawing, arguments.scale);
    if scale < arguments.scale {
        say!("the PNG has {scale:.2} pixels for a metre, as it would be too large: --part draws a part of the map");
    }
    std::fs::write(folder.join(format!("{name}.png")), raster::png(&drawing, scale)?)?;
    sumo::write(map, name).all().into_iter().try_for_each(|(end, text)| put(end, text))?;
    put("xodr", &opendrive::write(map))?;
    put("geojson", &geojson::write(map))?;
    put("map.json", &native::write(map))?;
    put("places.json", &skeleton::write(map)?)?;
    let violations: Vec<String> = map
        .validate()
        .iter()
        .map(|violation| {
            let place = violation.place(map).map_or(String::new(), |at| format!(" at {:.1}, {:.1}", at.x, at.y));
            format!("wrong    {violation}{place}\n")
        })
        .collect();
    put("report.txt", &format!("{account}{}", violations.concat()))?;
    Ok(())
}
