//! Objects fall onto a table and shelves, a door and a drawer open, a person clears the table, a car drives up
//! a ramp, wood floats and stone sinks.
//!
//! `cargo run --release --example drop` writes to `out/drop`: `report.txt`, a summary of the events;
//! `poses.jsonl`, the poses of all objects, one line per tenth of a second; `start.png` and `end.png`,
//! pictures of the scene.

#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;

mod draw;
mod play;
mod stage;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Parser;
use indicatif::ProgressBar;
use support::{Complaint, say};
use virtualcity::graph::{NodeId, SceneGraph};
use virtualcity::physics::{PhysicsWorld, Settings, Settling, ShapeCache};

use stage::Cast;

/// Objects fall, doors open, a car drives, wood floats.
#[derive(Parser)]
struct Options {
    /// The seed, which determines where objects fall from.
    #[arg(long, default_value_t = 7, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Number of falling objects.
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u16).range(1..=2000))]
    things: u16,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/drop")]
    out: PathBuf,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    virtualcity::files::create_folder(&options.out)?;
    let (graph, cast) = stage::build(options.seed, options.things).map_err(Complaint::new)?;
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), Settings::default()).map_err(Complaint::new)?;
    play::prepare(&mut world, &cast).map_err(Complaint::new)?;
    let file = |name: &str| options.out.join(name);
    draw(&file("start.png"), &draw::picture(&graph, &world, &[]))?;

    let bar = ProgressBar::new(u64::from(play::STEPS));
    let mut lines = String::new();
    let mut trails: Vec<(NodeId, Vec<[f32; 3]>)> = cast.moving().map(|id| (id, Vec::new())).collect();
    for step in 0..play::STEPS {
        play::act(&mut world, &cast, step).map_err(Complaint::new)?;
        world.step();
        if step % 6 == 0 {
            record(&world, &graph, &mut lines, &mut trails);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let settling = world.settle(600);
    write(&file("poses.jsonl"), &lines)?;
    draw(&file("end.png"), &draw::picture(&graph, &world, &trails))?;
    let report = report(&world, &graph, &cast, &settling);
    write(&file("report.txt"), &report)?;
    say!("{report}");
    say!("written to {}", options.out.display());
    Ok(())
}

/// A line of the trajectory, and a point of each trail.
fn record(world: &PhysicsWorld, graph: &SceneGraph, lines: &mut String, trails: &mut [(NodeId, Vec<[f32; 3]>)]) {
    let pose = |(id, pose): (NodeId, virtualcity::graph::Pose)| {
        let (t, q) = (pose.translation.vector, pose.rotation.coords);
        serde_json::json!({ "id": graph.label(id).to_string(), "position": [t.x, t.y, t.z], "rotation": [q.x, q.y, q.z, q.w] })
    };
    let awake = world.poses().into_iter().filter(|(id, _)| world.body(*id).is_ok_and(|body| !body.is_asleep()));
    let line = serde_json::json!({ "time": world.time(), "moving": awake.map(pose).collect::<Vec<_>>() });
    // Writing to a string cannot fail.
    let _ = writeln!(lines, "{line}");
    for (id, trail) in trails {
        trail.extend(world.pose(*id).map(|p| [p.translation.x, p.translation.y, p.translation.z]));
    }
}

fn report(world: &PhysicsWorld, graph: &SceneGraph, cast: &Cast, settling: &Settling) -> String {
    let (bodies, pieces) = world.size();
    let name = |id: NodeId| graph.label(id).to_string();
    let mut text = format!("{bodies} bodies of {pieces} pieces, {:.1} s, digest {}\n", world.time(), world.digest());
    let mut rests: std::collections::BTreeMap<String, u32> = std::collections::BTreeMap::new();
    for &id in &cast.falling {
        let on = world.supports(id).first().map_or_else(|| "nothing".to_owned(), |&on| name(on));
        *rests.entry(on).or_default() += 1;
    }
    let mut rests: Vec<_> = rests.into_iter().collect();
    rests.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    text += "\nwhat fell rests on\n";
    for (on, count) in rests.iter().take(8) {
        let _ = writeln!(text, "  {count:4}  {on}");
    }
    let open = |id: NodeId| world.parts(id).openness().unwrap_or(0.0) * 100.0;
    let height = |id: NodeId| world.pose(id).map_or(f32::NAN, |p| p.translation.z);
    let _ = writeln!(text, "\n{}: {:.0} % open", name(cast.door), open(cast.door));
    let _ = writeln!(text, "{}: {:.0} % open", name(cast.chest), open(cast.chest));
    let _ =
        writeln!(text, "{}: at {:.2} m, driven {:.1} m", name(cast.car), height(cast.car), play::driven(world, cast));
    let _ =
        writeln!(text, "block of wood: its middle {:.3} m from the water's surface", height(cast.wood) - stage::WATER);
    let _ = writeln!(text, "stone: at {:.2} m, water at {:.2} m", height(cast.stone), stage::WATER);
    let carried = world.supports(cast.mug).first().map_or_else(|| "nothing".to_owned(), |&on| name(on));
    let _ = writeln!(text, "{}: now on {carried}", name(cast.mug));
    let _ = writeln!(
        text,
        "\nat rest: {}; outside: {}; inside each other: {}; stopped: {}",
        settling.at_rest,
        settling.outside.len(),
        settling.overlapping.len(),
        settling.stopped.len()
    );
    text
}

/// Writes rows of RGB as a PNG.
fn draw(path: &Path, rows: &[u8]) -> Result<(), Complaint> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, draw::SIZE.0, draw::SIZE.1);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().map_err(Complaint::new)?;
    writer.write_image_data(rows).map_err(Complaint::new)?;
    writer.finish().map_err(Complaint::new)?;
    Ok(virtualcity::files::write(path, bytes)?)
}

fn write(path: &Path, text: &str) -> Result<(), Complaint> {
    Ok(virtualcity::files::write(path, text)?)
}
