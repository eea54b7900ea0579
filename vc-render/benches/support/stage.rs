//! A home ready to be rendered, and the timing of its pictures.

use std::time::{Duration, Instant};

use cpu_time::ThreadTime;
use rayon::ThreadPool;
use vc_graph::{NodeId, Pose, SceneGraph};
use vc_render::{Camera, Daylight, Frame, Lighting, Modalities, Modality, Renderer, Shot, Snapshot};

/// The modalities of pictures, and whether colours are plain.
pub(crate) type Wanted = (Modalities, bool);

/// Labels, depth and flow; and all six modalities.
pub(crate) const LABELS: Wanted = (Modalities::SIX.without(Modality::Rgb), false);
pub(crate) const SIX: Wanted = (Modalities::SIX, false);

/// Number of times that each picture is made; the median counts.
const RUNS: usize = 7;

/// The daylight of the benches.
pub(crate) fn sky() -> Daylight {
    Daylight::clear(0.6, 1.2)
}

/// A home ready to be rendered, with its light computed and its lamps on.
pub(crate) struct Stage {
    pub(crate) renderer: Renderer,
    pub(crate) snapshot: Snapshot,
    /// The next moment: the same, unless something is moved in it.
    pub(crate) next: Snapshot,
    pub(crate) lighting: Lighting,
}

impl Stage {
    /// The stage in sunlight, with these lamps on.
    pub(crate) fn new(graph: &SceneGraph, lamps: &[NodeId]) -> Self {
        Self::lit(graph, lamps, &sky())
    }

    pub(crate) fn lit(graph: &SceneGraph, lamps: &[NodeId], daylight: &Daylight) -> Self {
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(graph).unwrap();
        lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
        let lighting = renderer.light(&snapshot, daylight);
        Self { renderer, next: snapshot.clone(), snapshot, lighting }
    }

    fn shot<'a>(&'a self, camera: &'a Camera, (wanted, plain): Wanted) -> Shot<'a> {
        let shot = Shot::new(&self.snapshot, camera, wanted).lit(&self.lighting).after(&self.next, camera);
        if plain { shot.unshadowed() } else { shot }
    }

    /// CPU milliseconds of a picture on one thread: the mean over the cameras of the median.
    pub(crate) fn one(&self, cameras: &[Camera], wanted: Wanted, threads: &ThreadPool) -> f64 {
        threads.install(|| self.mean(cameras, wanted, ThreadTime::now, |t| t.elapsed()))
    }

    /// Wall-clock milliseconds of a picture that all threads make together.
    pub(crate) fn together(&self, cameras: &[Camera], wanted: Wanted) -> f64 {
        self.mean(cameras, wanted, Instant::now, |t| t.elapsed())
    }

    /// Wall-clock milliseconds for each of many pictures that threads make side by side.
    #[allow(dead_code, reason = "not all benches time it")]
    pub(crate) fn beside(&self, cameras: &[Camera], wanted: Wanted) -> f64 {
        let shots: Vec<Shot<'_>> = cameras.iter().map(|camera| self.shot(camera, wanted)).collect();
        let mut frames: Vec<Frame> = cameras.iter().map(|_| Frame::new()).collect();
        let mut all = || {
            let start = Instant::now();
            self.renderer.render_all(&shots, &mut frames).unwrap();
            start.elapsed()
        };
        all();
        median((0..RUNS).map(|_| all()).collect()) / cameras.len() as f64
    }

    fn mean<T>(&self, cameras: &[Camera], wanted: Wanted, now: fn() -> T, since: fn(&T) -> Duration) -> f64 {
        let mut frame = Frame::new();
        let mut times = vec![Vec::new(); cameras.len()];
        // The first round allocates buffers, and is not counted.
        for round in 0..=RUNS {
            for (camera, times) in cameras.iter().zip(&mut times) {
                let shot = self.shot(camera, wanted);
                let start = now();
                self.renderer.render(&shot, &mut frame).unwrap();
                times.extend((round > 0).then(|| since(&start)));
            }
        }
        times.into_iter().map(median).sum::<f64>() / cameras.len() as f64
    }
}

/// The median in milliseconds.
fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    1e3 * times[times.len() / 2].as_secs_f64()
}

/// A pool of one thread.
pub(crate) fn single() -> ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap()
}

/// The heads of the columns of [`rows`] and [`row`].
#[allow(dead_code, reason = "not all benches print it")]
pub(crate) const HEAD: [&str; 5] =
    ["one thread / together / side by side, ms", "84x84", "300x300", "640x480", "1920x1080"];

/// The costs of a home's pictures from some poses, for all sets and sizes.
#[allow(dead_code, reason = "not all benches print it")]
pub(crate) fn rows(title: &str, stage: &Stage, poses: &[Pose]) -> Vec<Vec<String>> {
    let seen = Modality::Depth | Modality::Instance;
    let sets = [
        ("depth and nodes", (seen, false)),
        ("labels, depth and flow", LABELS),
        ("plain colours, depth, nodes", (seen | Modality::Rgb, true)),
        ("colours, depth, nodes", (seen | Modality::Rgb, false)),
        ("all six", SIX),
    ];
    let mut rows: Vec<_> = sets.into_iter().map(|set| row(stage, poses, set)).collect();
    rows[0][0] = format!("{title}, {} triangles: {}", stage.snapshot.triangles(), sets[0].0);
    rows
}

/// The costs of one set in all sizes.
#[allow(dead_code, reason = "not all benches print it")]
pub(crate) fn row(stage: &Stage, poses: &[Pose], (name, wanted): (&str, Wanted)) -> Vec<String> {
    let threads = single();
    let mut row = vec![name.to_owned()];
    for (width, height) in [(84, 84), (300, 300), (640, 480), (1920, 1080)] {
        let camera = Camera::with_fov(width, height, 60_f32.to_radians());
        let cameras: Vec<Camera> = poses.iter().map(|pose| Camera { pose: *pose, ..camera }).collect();
        let one = stage.one(&cameras, wanted, &threads);
        let (together, beside) = (stage.together(&cameras, wanted), stage.beside(&cameras, wanted));
        row.push(format!("{one:.2} / {together:.2} / {beside:.2}"));
    }
    row
}
