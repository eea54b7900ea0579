//! Plans a city from a seed: pictures with legends of the city and of a storey with its flats, figures beside those of real cities,
//! the rules, its streets for SUMO and OpenDRIVE, views at street level by day and by night, and a block as glTF.
//!
//! ```text
//! cargo run --release --example city -- --seed 7 --out out/city
//! ```
#![allow(clippy::disallowed_methods, reason = "a program says how long it takes")]

#[path = "../map/raster.rs"]
mod raster;
#[path = "../support/mod.rs"]
mod support;
mod views;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;
use support::{Complaint, say};
use virtualcity::graph::Seed;
use virtualcity::map::format::{geojson, native, opendrive, sumo};
use virtualcity::map::route::{Mode, Router};
use virtualcity::map::{Point, StreetMap};
use virtualcity::procgen::city::{CityPlan, CitySpecification, StreetPattern, UnitKind};

/// Pixels for a metre in the drawing of a storey.
const STOREY: f64 = 32.0;

#[derive(Parser)]
#[command(about = "Plans a city from a seed")]
struct Arguments {
    /// The seed.
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// The area within its outermost street, square kilometres.
    #[arg(long, default_value_t = 1.0)]
    area: f64,
    /// The pattern of its streets, instead of drawing one: grid, radial or mixed.
    #[arg(long, value_parser = ["grid", "radial", "mixed"])]
    pattern: Option<String>,
    /// Pixels for a metre.
    #[arg(long, default_value_t = 2.0)]
    scale: f64,
    /// The number of views at street level, each by day and by night.
    #[arg(long, default_value_t = 1)]
    views: u64,
    /// The folder for pictures and files; nothing is written without one.
    #[arg(long)]
    out: Option<PathBuf>,
}

fn main() -> Result<(), Complaint> {
    let arguments = Arguments::parse();
    let named = |word: &String| StreetPattern::ALL.into_iter().find(|pattern| pattern.word() == word);
    let pattern = arguments.pattern.as_ref().and_then(named);
    let wishes = CitySpecification { area: arguments.area, pattern, ..CitySpecification::default() };
    let begun = Instant::now();
    let plan = CityPlan::generate(&wishes, Seed(arguments.seed))?;
    say!("city {}, {} streets, in {:.3} s", arguments.seed, plan.pattern().word(), begun.elapsed().as_secs_f64());
    contents(&plan);
    figures(&plan);
    places(&plan);
    rules(&plan);
    if let Some(folder) = &arguments.out {
        std::fs::create_dir_all(folder)?;
        write(&plan, folder, arguments.scale)?;
        views::block(&plan, folder)?;
        views::write(&plan, folder, arguments.views)?;
        say!("written to {}", folder.display());
    }
    Ok(())
}

fn contents(plan: &CityPlan) {
    let map = plan.map();
    let units: usize =
        plan.buildings().iter().map(|b| (0..b.storeys).map(|storey| b.units(storey).len()).sum::<usize>()).sum();
    let trees = plan.trees().len() + plan.parks().iter().map(|park| park.trees.len()).sum::<usize>();
    let rows = [
        ("streets", plan.streets().len()),
        ("junctions, of them", map.junctions().len()),
        ("with lights", map.signals().len()),
        ("blocks", plan.blocks().len()),
        ("parcels", plan.parcels().len()),
        ("buildings", plan.buildings().len()),
        ("units, of them", units),
        ("homes", plan.buildings().iter().map(|building| building.homes()).sum()),
        ("parks", plan.parks().len()),
        ("things along streets", plan.items().len()),
        ("trees in gardens and parks", trees),
        ("parked cars", plan.cars().len()),
    ];
    rows.iter().for_each(|(what, count)| say!("{count:7}  {what}"));
}

fn figures(plan: &CityPlan) {
    say!("{:>10}  {:22} {:9} real cities", "", "figure", "unit");
    for figure in plan.figures() {
        let mark = if figure.is_within() { ' ' } else { '*' };
        say!("{:10.2}{mark} {:22} {:9} {}-{}", figure.value, figure.name, figure.unit, figure.band[0], figure.band[1]);
    }
}

/// The nearest place of each kind, on foot from the middle of the city.
fn places(plan: &CityPlan) {
    let router = Router::new(plan.map(), Mode::Foot);
    let mut doors: BTreeMap<UnitKind, Vec<Point>> = BTreeMap::new();
    for unit in
        plan.buildings().iter().flat_map(|building| building.units(0)).filter(|unit| unit.kind.hours().is_some())
    {
        doors.entry(unit.kind).or_default().push(unit.door);
    }
    say!("{:>7}  {:>5}  places, the nearest on foot from the middle", "number", "m");
    for (kind, mut doors) in doors {
        doors.sort_by(|a, b| a.coords.norm().total_cmp(&b.coords.norm()));
        let route = doors.first().and_then(|door| router.route(&Point::origin(), door));
        let metres = route.map_or("none".to_owned(), |route| format!("{:.0}", route.metres));
        say!("{:7}  {metres:>5}  {}", doors.len(), kind.word());
    }
}

fn rules(plan: &CityPlan) {
    let begun = Instant::now();
    let wrong = plan.violations();
    wrong.iter().take(20).for_each(|violation| say!("{violation}"));
    say!("{} violations of the rules, checked in {:.3} s", wrong.len(), begun.elapsed().as_secs_f64());
}

fn write(plan: &CityPlan, folder: &Path, scale: f64) -> Result<(), Complaint> {
    let map: &StreetMap = plan.map();
    let put = |name: &str, text: &str| std::fs::write(folder.join(name), text);
    let drawing = plan.drawing();
    std::fs::write(folder.join("plan.png"), raster::png(&drawing, raster::scale(&drawing, scale))?)?;
    put("plan.svg", &drawing.svg(scale))?;
    let most = (0..plan.buildings().len()).max_by_key(|index| plan.buildings()[*index].homes());
    if let Some(storey) = most.and_then(|building| plan.storey_drawing(building, 1)) {
        std::fs::write(folder.join("storey.png"), raster::png(&storey, raster::scale(&storey, STOREY))?)?;
        put("storey.svg", &storey.svg(STOREY))?;
    }
    put("plan.txt", &plan.text())?;
    put("city.xodr", &opendrive::write(map))?;
    put("city.geojson", &geojson::write(map))?;
    put("city.map.json", &native::write(map))?;
    sumo::write(map, "city").all().into_iter().try_for_each(|(end, text)| put(&format!("city.{end}"), text))?;
    Ok(())
}
