//! Renders a scene file of any format that has shapes or boxes, and says what it costs.
//!
//! `cargo run --release -p vc-render --example view -- SCENE.json OUT [ROOM [day|evening|overcast|night [SAMPLES]]]`

use std::error::Error;
use std::io::Write;

use cpu_time::ThreadTime;
use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, SceneGraph};
use vc_render::{Camera, Daylight, Exposure, Frame, Lighting, Modalities, Modality, Renderer, Shot, Snapshot, picture};

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (Some(file), Some(out)) = (words.next(), words.next()) else {
        return Err("view SCENE.json OUT [ROOM [day|evening|overcast|night]]".into());
    };
    let room = words.next().unwrap_or_else(|| "livingroom".into());
    let hour = words.next().unwrap_or_else(|| "day".into());
    let scene = vc_graph::format::native::read(&std::fs::read_to_string(&file)?, &vc_graph::ClassTable::builtin())?;
    let mut renderer = Renderer::new();
    let start = ThreadTime::now();
    let mut snapshot = renderer.snapshot(&scene)?;
    say(format_args!("{} triangles uploaded in {:.0} ms", snapshot.triangles(), ms(start)))?;
    let daylight = match hour.as_str() {
        "evening" => Daylight::clear(0.2, 3.6),
        "overcast" => Daylight::overcast(),
        "night" => {
            let lamp = |class: &str| ["lamp", "light", "chandelier"].iter().any(|w| class.contains(w));
            let lamps: Vec<NodeId> =
                snapshot.nodes().filter(|n| scene.node(*n).is_some_and(|n| lamp(n.class()))).collect();
            lamps.into_iter().try_for_each(|n| snapshot.switch(n, true))?;
            Daylight::night()
        }
        _ => Daylight::noon(),
    };
    let start = std::time::Instant::now();
    let lighting = renderer.light(&snapshot, &daylight);
    say(format_args!("light made in {:.0} ms", 1e3 * start.elapsed().as_secs_f64()))?;
    let camera = corner(&renderer, &snapshot, &scene, &room)?;
    sheet(&renderer, &snapshot, &lighting, &camera, &out)?;
    if let Some(samples) = words.next() {
        let how = Exposure { samples: samples.parse()?, ..Exposure::default() };
        let start = std::time::Instant::now();
        let photograph = renderer.photograph(&lighting, &camera, &how, |_| true)?;
        say(format_args!("reference picture in {:.1} s", start.elapsed().as_secs_f64()))?;
        std::fs::write(format!("{out}_reference.png"), picture::png(&photograph.picture())?)?;
        return Ok(());
    }
    times(&renderer, &snapshot, &lighting, &camera)
}

fn say(text: std::fmt::Arguments<'_>) -> std::io::Result<()> {
    writeln!(std::io::stdout(), "{text}")
}

fn ms(start: ThreadTime) -> f64 {
    1e3 * start.elapsed().as_secs_f64()
}

/// Of the places along the room's walls the one from which most things are seen.
fn corner(renderer: &Renderer, snapshot: &Snapshot, scene: &SceneGraph, class: &str) -> Result<Camera, Box<dyn Error>> {
    let room = *scene.of_class(class).first().ok_or("no such room")?;
    let bounds = scene.node(room).and_then(|n| n.aabb()).ok_or("the room has no extent")?;
    let (low, high, middle) = (bounds.min, bounds.max, bounds.centre());
    let place = |k: i32, low: f32, high: f32| low + 0.3 + k as f32 / 4.0 * (high - low - 0.6).max(0.0);
    let mut frame = Frame::new();
    let mut best = (f32::NEG_INFINITY, Camera::with_fov(640, 480, 1.15));
    for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))).filter(|(i, j)| i % 4 == 0 || j % 4 == 0) {
        let eye = Point3::new(place(i, low.x, high.x), place(j, low.y, high.y), low.z + 1.55);
        let target = Point3::new(middle.x, middle.y, low.z + 0.95);
        let camera = Camera::with_fov(80, 60, 1.15).looking(eye, target);
        renderer.render(&Shot::new(snapshot, &camera, Modality::Instance | Modality::Depth), &mut frame)?;
        let mut seen: Vec<NodeId> =
            frame.instance.iter().copied().filter(|n| scene.room_of(*n) == Some(room)).collect();
        let own = seen.len() as f32 / 4800.0;
        seen.sort_unstable();
        seen.dedup();
        let near = frame.depth.iter().filter(|d| **d < 0.9).count() as f32 / 4800.0;
        let score = seen.len() as f32 - 50.0 * near + 20.0 * own;
        if score > best.0 {
            best = (score, Camera::with_fov(640, 480, 1.15).looking(eye, target));
        }
    }
    Ok(best.1)
}

fn sheet(
    renderer: &Renderer,
    snapshot: &Snapshot,
    lighting: &Lighting,
    camera: &Camera,
    out: &str,
) -> Result<(), Box<dyn Error>> {
    let step = nalgebra::Translation3::from(Vector3::new(0.03, 0.0, 0.06));
    let next = Camera { pose: camera.pose * step, ..*camera };
    let mut frame = Frame::new();
    let shot = Shot::new(snapshot, camera, Modalities::SIX | Modality::Normal).lit(lighting).after(snapshot, &next);
    renderer.render(&shot, &mut frame)?;
    let rgb = picture::rgb(&frame);
    std::fs::write(format!("{out}.png"), picture::png(&rgb)?)?;
    let all = [
        rgb.clone(),
        picture::instances(&frame),
        picture::classes(&frame),
        picture::depth(&frame, 8.0),
        picture::flow(&frame, 25.0),
        picture::normals(&frame),
        picture::with_boxes(rgb, &frame, 150),
        picture::masks(&frame),
    ];
    std::fs::write(format!("{out}_sheet.png"), picture::png(&picture::Picture::sheet(&all, 4, 4))?)?;
    Ok(())
}

fn times(renderer: &Renderer, snapshot: &Snapshot, lighting: &Lighting, camera: &Camera) -> Result<(), Box<dyn Error>> {
    let labels = Modalities::SIX.without(Modality::Rgb);
    let sets = [
        ("depth, nodes", Modality::Depth | Modality::Instance),
        ("+ classes, flow", Modality::Depth | Modality::Instance | Modality::Class | Modality::FlowForward),
        ("all labels", labels),
        ("all six", Modalities::SIX),
        ("labels, amodal", labels | Modality::Amodal),
    ];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for (name, wanted) in sets {
        let mut line = format!("{name:<18}");
        for (width, height) in [(84, 84), (300, 300), (640, 480), (1920, 1080)] {
            let focal = camera.focal.1 * height as f32 / camera.height as f32;
            let centre = (0.5 * width as f32, 0.5 * height as f32);
            let camera = Camera { width, height, focal: (focal, focal), centre, ..*camera };
            let shot = Shot::new(snapshot, &camera, wanted).lit(lighting).after(snapshot, &camera);
            let time = pool.install(|| {
                let mut frame = Frame::new();
                let mut all: Vec<f64> = Vec::new();
                for _ in 0..15 {
                    let start = ThreadTime::now();
                    renderer.render(&shot, &mut frame)?;
                    all.push(ms(start));
                }
                all.sort_by(f64::total_cmp);
                Ok::<f64, vc_render::RenderError>(all[all.len() / 2])
            })?;
            line += &format!("{time:>10.2}");
        }
        say(format_args!("{line}  ms of one core at 84x84, 300x300, 640x480, 1920x1080"))?;
    }
    Ok(())
}
