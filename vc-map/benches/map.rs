//! Costs of maps: from OpenStreetMap's XML to a built map, and routes across 15 square kilometres.
//!
//! Files are the hand-drawn town and, if the shared data exists (`VC_DATA` or `../shared/data`), real extracts; each time is the
//! best of five, since the machine may be busy with other things. The target is 10 MB a second to the built map. Routes lead
//! between 500 pairs of junctions of a grid; the target is a median of 1 ms. `cargo bench -p vc-map --bench map`

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

use std::hint::black_box;
use std::time::Instant;

use vc_map::osm::{ImportOptions, OsmData};
use vc_map::route::{Mode, Router};
use vc_map::{Control, CrossSection, MapDraft, Point, RoadClass, StreetMap, Strip};
use vc_testkit::page::{Page, time};

const TOWN: &str = include_str!("../data/riverside.osm");
const EXTRACTS: [&str; 3] = ["munich_altstadt", "midtown", "leeds_cycleway"];
const REPEATS: usize = 5;
/// Junctions along a side of the grid, and the distance between two, metres.
const COUNT: usize = 36;
const BLOCK: f64 = 110.0;
const ROUTES: usize = 500;

/// The result of some work, and the seconds that it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begun = Instant::now();
    let made = black_box(work());
    (made, begun.elapsed().as_secs_f64())
}

/// The seconds for reading a file, for its description, and for the map.
fn steps(text: &[u8]) -> [f64; 3] {
    let (data, read) = timed(|| OsmData::read(text).unwrap());
    let ((draft, _), described) = timed(|| data.draft(&ImportOptions::default()).unwrap());
    let (_, built) = timed(|| draft.build_of_file(text.len()).unwrap());
    [read, described, built]
}

fn reading(page: &mut Page) {
    let extract = |name| Some((name, vc_testkit::data::text(&format!("osm/{name}.osm.gz"))?));
    let files = std::iter::once(("the town", TOWN.to_owned())).chain(EXTRACTS.into_iter().filter_map(extract));
    let row = |(name, text): (&str, String)| {
        let all = (0..REPEATS).map(|_| steps(text.as_bytes()));
        let best = all.min_by(|a, b| a.iter().sum::<f64>().total_cmp(&b.iter().sum())).unwrap();
        let megabytes = text.len() as f64 / 1e6;
        let rate = format!("{:.0} MB/s", megabytes / best.iter().sum::<f64>());
        [vec![format!("{name}, {megabytes:.1} MB")], best.map(time).to_vec(), vec![rate]].concat()
    };
    page.table(&["OpenStreetMap's XML", "read", "described", "built", "in all"], &files.map(row).collect::<Vec<_>>());
}

/// A grid of streets with lights and pavements, every fourth of which is a main street.
fn grid() -> StreetMap {
    let mut draft = MapDraft::new("grid", 48.0, 11.0);
    let cells = (0..COUNT).flat_map(|y| (0..COUNT).map(move |x| (x, y)));
    // Not quite straight, so that many ways differ in length.
    let at = |(x, y): (usize, usize)| [BLOCK * x as f64 + ((x + 3 * y) % 7) as f64, BLOCK * y as f64];
    let ids: Vec<_> = cells.clone().map(|cell| draft.junction(at(cell), Control::Signals)).collect();
    for (x, y) in cells {
        let here = y * COUNT + x;
        for (next, there, line) in [(x + 1, here + 1, y), (y + 1, here + COUNT, x)] {
            let main = line % 4 == 0;
            let class = if main { RoadClass::Secondary } else { RoadClass::Residential };
            let side = vec![Strip::driving(3.0, if main { 13.9 } else { 8.3 }), Strip::pavement(2.4)];
            if next < COUNT {
                let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
                draft.road(ids[here], ids[there], class, section);
            }
        }
    }
    draft.build().unwrap()
}

fn routing(page: &mut Page) {
    let map = grid();
    let places: Vec<Point> = map.junctions().iter().map(|junction| junction.at).collect();
    let place = |number: usize| places[number % places.len()];
    let row = |mode: Mode| {
        let (router, made) = timed(|| Router::new(&map, mode));
        let route = |i: usize| timed(|| router.route(&place(i * 7919), &place(i * 104_729 + 1)).unwrap());
        let (routes, mut times): (Vec<_>, Vec<_>) = (1..=ROUTES).map(route).unzip();
        times.sort_by(f64::total_cmp);
        let metres = routes.iter().map(|route| route.metres).sum::<f64>() / ROUTES as f64;
        let costs = [times[ROUTES / 2], times[ROUTES * 99 / 100], times[ROUTES - 1], made].map(time);
        [vec![mode.to_string(), format!("{metres:.0} m")], costs.to_vec()].concat()
    };
    let rows: Vec<_> = [Mode::Car, Mode::Bicycle, Mode::Foot].map(row).into();
    let head = format!("{ROUTES} routes among {} junctions", places.len());
    page.table(&[&head, "mean length", "median", "99th percentile", "slowest", "router"], &rows);
}

fn main() {
    let mut page = Page::new("map");
    reading(&mut page);
    routing(&mut page);
    page.finish();
}
