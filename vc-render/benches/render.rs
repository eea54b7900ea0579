//! Costs of pictures: sixteen views of a home of 130,000 and of a million triangles, in four sizes. Run with
//! `cargo bench -p vc-render --bench render`; `-- first` leaves out the million. The light is the sun and three
//! lamps; separate rows have two lamps alone, and fifty things that have moved by the next moment. Another row
//! is for occlusion at the next moment, which is not among the six modalities.
//!
//! Times are CPU time of one thread, wall-clock time if all threads make one picture together, and wall-clock
//! time if they make many pictures side by side: the mean over the views of the median of seven runs. Light is
//! computed once and not counted, and frames are reused.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "support/home.rs"]
mod home;
#[path = "support/stage.rs"]
mod stage;

use std::time::Instant;

use home::{Home, cameras, home};
use nalgebra::Translation3;
use stage::{LABELS, SIX, Stage, row, table};
use vc_graph::NodeKind;
use vc_render::{Daylight, Modality};

/// Cells along an edge of each mesh: 130,000 and a million triangles.
const FINE: [i32; 2] = [6, 17];

fn main() {
    let first = std::env::args().any(|word| word == "first");
    let poses: Vec<_> = cameras(64, 64).iter().map(|camera| camera.pose).collect();
    for fine in FINE.into_iter().take(if first { 1 } else { 2 }) {
        let home = home(fine, 300);
        let mut stage = Stage::new(&home.graph, &home.lamps);
        table("a home of 300 objects", &stage, &poses);
        let hidden = (LABELS.0 | Modality::Occlusion, false);
        row(&stage, &poses, ("labels, and what is hidden", hidden));
        let seen = Modality::Depth | Modality::Instance | Modality::Rgb;
        let lamps = Stage::lit(&home.graph, &home.lamps[..2], &Daylight::overcast());
        row(&lamps, &poses, ("colours of two lamps, the same", (seen, false)));
        move_some(&mut stage, &home);
        row(&stage, &poses, ("all six, fifty things move", SIX));
    }
}

/// Moves fifty things by a few centimetres, and prints the cost of that.
fn move_some(stage: &mut Stage, home: &Home) {
    let things = home.graph.nodes().filter(|node| node.kind() == NodeKind::Object);
    let moved: Vec<_> = things
        .filter_map(|node| Some((node.id(), Translation3::new(0.03, 0.02, 0.0) * node.pose()?)))
        .step_by(6)
        .take(50)
        .collect();
    let start = Instant::now();
    moved.iter().for_each(|(thing, pose)| stage.next.place(*thing, pose).unwrap());
    println!("{} things placed in {:.1} us", moved.len(), 1e6 * start.elapsed().as_secs_f64());
}
