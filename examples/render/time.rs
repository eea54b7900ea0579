//! The cost of each modality.

use cpu_time::ThreadTime;
use virtualcity::render::{Camera, Frame, Lighting, Modalities, Modality, Renderer, Shot, Snapshot};

use crate::support::{Complaint, say};

/// Sizes that are timed.
const SIZES: [(u32, u32); 4] = [(84, 84), (300, 300), (640, 480), (1920, 1080)];

/// Prints the CPU time of one thread, milliseconds, for sets of modalities at several sizes: the median of some
/// pictures.
pub(crate) fn table(
    renderer: &Renderer,
    snapshot: &Snapshot,
    camera: &Camera,
    lighting: &Lighting,
) -> Result<(), Complaint> {
    let labels = Modalities::SIX.without(Modality::Rgb);
    let sets = [
        ("depth and nodes", Modality::Depth | Modality::Instance),
        ("depth, nodes, classes, flow", Modality::Depth | Modality::Instance | Modality::Class | Modality::FlowForward),
        ("all labels", labels),
        ("all six", Modalities::SIX),
        ("with amodal masks", labels | Modality::Amodal),
    ];
    say!("{:<30}{}", "ms of one core", SIZES.map(|(w, h)| format!("{w:>10}x{h}")).concat());
    for (name, wanted) in sets {
        let cells = SIZES.map(|(width, height)| {
            let focal = camera.focal.1 * height as f32 / camera.height as f32;
            let centre = (0.5 * width as f32, 0.5 * height as f32);
            let camera = Camera { width, height, focal: (focal, focal), centre, ..*camera };
            median(renderer, &Shot::new(snapshot, &camera, wanted).lit(lighting).after(snapshot, &camera))
        });
        let cells: Result<Vec<f64>, Complaint> = cells.into_iter().collect();
        say!("{name:<30}{}", cells?.iter().map(|ms| format!("{ms:>13.2}")).collect::<String>());
    }
    Ok(())
}

fn median(renderer: &Renderer, shot: &Shot<'_>) -> Result<f64, Complaint> {
    // A pool of one thread, whose clock is read.
    let pool = rayon_of_one()?;
    pool.install(|| {
        let mut frame = Frame::new();
        let mut times = Vec::new();
        for _ in 0..25 {
            let start = ThreadTime::now();
            renderer.render(shot, &mut frame).map_err(Complaint::new)?;
            times.push(1e3 * start.elapsed().as_secs_f64());
        }
        times.sort_by(f64::total_cmp);
        Ok(times[times.len() / 2])
    })
}

fn rayon_of_one() -> Result<rayon::ThreadPool, Complaint> {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(Complaint::new)
}
