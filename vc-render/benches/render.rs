//! What pictures cost: CPU time of one thread for sixteen views of a home, in turn. Run with
//! `cargo bench -p vc-render`.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../../benches/support/cpu.rs"]
mod cpu;
#[path = "support/home.rs"]
mod home;

use cpu::Cpu;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use home::{cameras, home};
use vc_render::{Daylight, Frame, Modalities, Modality, Renderer, Shot};

/// Cells along an edge of each mesh: 130,000 and a million triangles.
const FINE: [i32; 2] = [6, 17];
const SIZES: [(u32, u32); 4] = [(84, 84), (300, 300), (640, 480), (1920, 1080)];

fn views(c: &mut Criterion<Cpu>) {
    let labels = Modalities::SIX.without(Modality::Rgb);
    let sets = [
        ("depth and nodes", Modality::Depth | Modality::Instance),
        ("labels, depth and flow", labels),
        ("all six", Modalities::SIX),
    ];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for fine in FINE {
        let home = home(fine, 300);
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&home.graph).unwrap();
        home.lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
        // The sun through the windows, and a lamp in each room.
        let lighting = renderer.light(&snapshot, &Daylight::clear(0.6, 1.2));
        let mut group = c.benchmark_group(format!("sixteen views, {} triangles", snapshot.triangles()));
        for (name, wanted) in sets {
            for (width, height) in SIZES {
                let cameras = cameras(width, height);
                group.bench_function(BenchmarkId::new(name, format!("{width}x{height}")), |b| {
                    let mut frame = Frame::new();
                    let mut turn = cameras.iter().cycle();
                    pool.install(|| {
                        b.iter(|| {
                            let camera = turn.next().unwrap_or(&cameras[0]);
                            let shot = Shot::new(&snapshot, camera, wanted).lit(&lighting).after(&snapshot, camera);
                            renderer.render(&shot, &mut frame).unwrap();
                        });
                    });
                });
            }
        }
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().with_measurement(Cpu).sample_size(20);
    targets = views
}
criterion_main!(benches);
