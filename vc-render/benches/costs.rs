//! What pictures cost against triangles, objects and pixels, and the memory they take.
//!
//! `cargo bench -p vc-render --bench costs` prints tables and writes them as a plot, `costs.svg`, into the
//! folder that `VC_OUT` names, or the working folder; beside it the home of 300 objects as `reference.obj`,
//! for `benches/peers/render.py --obj`. CPU time of one thread, the mean over sixteen views of
//! the best of five; light is made once and not counted.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "support/home.rs"]
mod home;
#[path = "support/plot.rs"]
mod plot;

use cpu_time::ThreadTime;
use home::{Home, cameras, home, obj};
use plot::{Panel, svg};
use vc_render::{Daylight, Frame, Lighting, Modalities, Modality, Renderer, Shot, Snapshot};

/// What is timed: labels, and all six modalities.
const SETS: [&str; 2] = ["labels, depth, flow", "all six"];

/// A home that is ready to be looked at.
struct Stage {
    renderer: Renderer,
    snapshot: Snapshot,
    lighting: Lighting,
}

impl Stage {
    fn new(Home { graph, lamps }: &Home) -> Self {
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(graph).unwrap();
        lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
        let lighting = renderer.light(&snapshot, &Daylight::clear(0.6, 1.2));
        Self { renderer, snapshot, lighting }
    }

    /// Milliseconds of a picture, for both sets.
    fn times(&self, (width, height): (u32, u32)) -> [f64; 2] {
        [Modalities::SIX.without(Modality::Rgb), Modalities::SIX].map(|wanted| {
            let mut frame = Frame::new();
            let cameras = cameras(width, height);
            let mut best = vec![f64::INFINITY; cameras.len()];
            for _ in 0..5 {
                for (camera, best) in cameras.iter().zip(&mut best) {
                    let shot = Shot::new(&self.snapshot, camera, wanted).lit(&self.lighting);
                    let start = ThreadTime::now();
                    self.renderer.render(&shot.after(&self.snapshot, camera), &mut frame).unwrap();
                    *best = best.min(1e3 * start.elapsed().as_secs_f64());
                }
            }
            best.iter().sum::<f64>() / best.len() as f64
        })
    }
}

/// Megabytes of the process at its peak, where the system says.
fn peak() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

fn row(panel: &mut Panel, at: f64, times: [f64; 2], more: &str) {
    println!("{at:>12}{:>12.2}{:>12.2} ms  {more}", times[0], times[1]);
    panel.points.push((at, times));
}

fn of_homes(title: &'static str, size: (u32, u32), homes: &[(i32, usize)], at: impl Fn(&Stage, usize) -> f64) -> Panel {
    let mut panel = Panel::new(title);
    println!("{title}, {}x{} pixels: {}, {}", size.0, size.1, SETS[0], SETS[1]);
    for (fine, objects) in homes {
        let stage = Stage::new(&home(*fine, *objects));
        let bytes = stage.renderer.size().1 as f64 / 1e6;
        row(&mut panel, at(&stage, *objects), stage.times(size), &format!("meshes {bytes:.1} MB"));
    }
    panel
}

fn of_pixels() -> Panel {
    let mut panel = Panel::new("pixels");
    println!("pixels, 300 objects of 432 triangles: {}, {}", SETS[0], SETS[1]);
    let stage = Stage::new(&home(6, 300));
    for size in [(84, 84), (160, 120), (300, 300), (640, 480), (1280, 960), (1920, 1080)] {
        row(&mut panel, f64::from(size.0 * size.1), stage.times(size), "");
    }
    panel
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let panels = pool.install(|| {
        let triangles = |stage: &Stage, _: usize| stage.snapshot.triangles() as f64;
        let homes = [2, 3, 4, 6, 9, 12, 17].map(|fine| (fine, 300));
        let fine = of_homes("triangles", (640, 480), &homes, triangles);
        let homes = [50, 100, 200, 300, 600, 1200].map(|objects| (6, objects));
        let many = of_homes("objects", (640, 480), &homes, |_, objects| objects as f64);
        [fine, many, of_pixels()]
    });
    if let Some(peak) = peak() {
        println!("the process took {peak:.0} MB at its peak");
    }
    let folder = std::env::var("VC_OUT").unwrap_or_else(|_| ".".into());
    let folder = std::path::Path::new(&folder);
    std::fs::write(folder.join("reference.obj"), obj(&home(6, 300))).unwrap();
    let path = folder.join("costs.svg");
    std::fs::write(&path, svg(&panels, &SETS)).unwrap();
    println!("plotted in {}", path.display());
}
