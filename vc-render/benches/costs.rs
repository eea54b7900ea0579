//! Costs of pictures by number of triangles, objects and pixels, and the memory they take.
//!
//! `cargo bench -p vc-render --bench costs` prints tables and plots them as `costs.svg` in the folder named by
//! `VC_OUT`, or in the working folder; it also writes the home of 300 objects as `reference.obj`, for
//! `benches/peers/render.py --obj`. Times are CPU time of one thread: the mean over sixteen views of the median
//! of seven runs. Light is computed once and not counted.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "support/home.rs"]
mod home;
#[path = "support/plot.rs"]
mod plot;
#[path = "support/stage.rs"]
mod stage;

use std::time::Instant;

use home::{cameras, home, obj};
use plot::{Panel, svg};
use rayon::ThreadPool;
use stage::{LABELS, SIX, Stage, single, sky};
use vc_graph::Pose;
use vc_testkit::page::Page;

/// The sets of modalities that are timed.
const SETS: [&str; 2] = ["labels, depth, flow", "all six"];

/// A stage with a home of `objects` objects, whose meshes have `fine` cells along an edge.
fn ready(fine: i32, objects: usize) -> Stage {
    let home = home(fine, objects);
    Stage::new(&home.graph, &home.lamps)
}

/// Milliseconds of a picture, for both sets.
fn times(stage: &Stage, (width, height): (u32, u32), threads: &ThreadPool) -> [f64; 2] {
    [LABELS, SIX].map(|wanted| stage.one(&cameras(width, height), wanted, threads))
}

/// Peak memory of the process in megabytes, where the system reports it.
fn peak() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

/// A row of a table and a point of its plot.
fn row(panel: &mut Panel, at: f64, times: [f64; 2], more: String) -> Vec<String> {
    panel.points.push((at, times));
    vec![at.to_string(), format!("{:.2} ms", times[0]), format!("{:.2} ms", times[1]), more]
}

fn of_homes(
    title: &'static str,
    homes: &[(i32, usize)],
    threads: &ThreadPool,
    at: impl Fn(&Stage, usize) -> f64,
    page: &mut Page,
) -> Panel {
    let (mut panel, mut rows) = (Panel::new(title), Vec::new());
    for (fine, objects) in homes {
        let stage = ready(*fine, *objects);
        let bytes = stage.renderer.size().1 as f64 / 1e6;
        let times = times(&stage, (640, 480), threads);
        rows.push(row(&mut panel, at(&stage, *objects), times, format!("{bytes:.1} MB")));
    }
    page.table(&[&format!("{title}, 640x480 pixels"), SETS[0], SETS[1], "memory of meshes"], &rows);
    panel
}

fn of_pixels(threads: &ThreadPool, page: &mut Page) -> Panel {
    let (mut panel, mut rows) = (Panel::new("pixels"), Vec::new());
    let stage = ready(6, 300);
    for size in [(84, 84), (160, 120), (300, 300), (640, 480), (1280, 960), (1920, 1080)] {
        let times = times(&stage, size, threads);
        rows.push(row(&mut panel, f64::from(size.0 * size.1), times, format!("{}x{}", size.0, size.1)));
    }
    page.table(&["pixels, 300 objects of 432 triangles", SETS[0], SETS[1], "size"], &rows);
    panel
}

/// Wall-clock milliseconds, on all threads, for computing light and for updating it.
fn of_light(page: &mut Page) {
    let home = home(6, 300);
    let Stage { renderer, mut snapshot, mut lighting, .. } = Stage::new(&home.graph, &home.lamps);
    let timed = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        1e3 * start.elapsed().as_secs_f64()
    };
    let anew = timed(&mut || drop(renderer.light(&snapshot, &sky())));
    snapshot.switch(home.lamps[0], false).unwrap();
    let switched = timed(&mut || renderer.relight(&mut lighting, &snapshot).unwrap());
    let table = home.graph.of_class("table")[0];
    let pose = *home.graph.node(table).unwrap().pose().unwrap();
    snapshot.place(table, &(pose * Pose::translation(0.0, 0.0, 0.1))).unwrap();
    let moved = timed(&mut || renderer.relight(&mut lighting, &snapshot).unwrap());
    let row = [anew, switched, moved].map(|ms| format!("{ms:.0} ms"));
    page.table(&["light of 300 objects, all threads", "a lamp switched", "a table moved"], &[row.to_vec()]);
}

fn main() {
    let (threads, mut page) = (single(), Page::new("costs"));
    let triangles = |stage: &Stage, _: usize| stage.snapshot.triangles() as f64;
    let homes = [2, 3, 4, 6, 9, 12, 17].map(|fine| (fine, 300));
    let fine = of_homes("triangles", &homes, &threads, triangles, &mut page);
    let homes = [50, 100, 200, 300, 600, 1200].map(|objects| (6, objects));
    let many = of_homes("objects", &homes, &threads, |_, objects| objects as f64, &mut page);
    let panels = [fine, many, of_pixels(&threads, &mut page)];
    of_light(&mut page);
    if let Some(peak) = peak() {
        page.table(&["peak memory of the process"], &[vec![format!("{peak:.0} MB")]]);
    }
    let folder = std::env::var("VC_OUT").unwrap_or_else(|_| ".".into());
    let folder = std::path::Path::new(&folder);
    std::fs::write(folder.join("reference.obj"), obj(&home(6, 300), sky().towards_sun)).unwrap();
    let path = folder.join("costs.svg");
    std::fs::write(&path, svg(&panels, &SETS)).unwrap();
    println!("plotted in {}", path.display());
    page.finish();
}
