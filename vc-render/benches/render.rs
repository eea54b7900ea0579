//! Costs of pictures: sixteen views of a home of 130,000 and of a million triangles, in four sizes. Run with
//! `cargo bench -p vc-render --bench render`; `-- first` leaves out the million. The light is the sun and three
//! lamps; separate rows have two lamps alone, and fifty things that have moved by the next moment. Another row
//! is for occlusion at the next moment, which is not among the six modalities.
//!
//! Times are CPU time of one thread, wall-clock time if all threads make one picture together, and wall-clock
//! time if they make many pictures side by side: the mean over the views of the median of seven runs. Light is
//! computed once and not counted, and frames are reused.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "support/home.rs"]
mod home;
#[path = "support/stage.rs"]
mod stage;

use std::time::Instant;

use home::{Home, cameras, home};
use nalgebra::Translation3;
use stage::{HEAD, LABELS, SIX, Stage, row, rows};
use vc_graph::NodeKind;
use vc_render::{Daylight, Modality};
use vc_testkit::page::{Page, time};

/// Cells along an edge of each mesh: 130,000 and a million triangles.
const FINE: [i32; 2] = [6, 17];

fn main() {
    let first = std::env::args().any(|word| word == "first");
    let poses: Vec<_> = cameras(64, 64).iter().map(|camera| camera.pose).collect();
    let mut page = Page::new("render");
    for fine in FINE.into_iter().take(if first { 1 } else { 2 }) {
        let home = home(fine, 300);
        let mut stage = Stage::new(&home.graph, &home.lamps);
        let mut costs = rows("300 objects", &stage, &poses);
        let hidden = (LABELS.0 | Modality::Occlusion, false);
        costs.push(row(&stage, &poses, ("labels, and occlusion at the next moment", hidden)));
        let seen = Modality::Depth | Modality::Instance | Modality::Rgb;
        let lamps = Stage::lit(&home.graph, &home.lamps[..2], &Daylight::overcast());
        costs.push(row(&lamps, &poses, ("colours of two lamps, depth, nodes", (seen, false))));
        let moved = move_some(&mut stage, &home);
        costs.push(row(&stage, &poses, (&format!("all six, fifty objects move (placed in {})", time(moved)), SIX)));
        page.table(&HEAD, &costs);
    }
    page.finish();
}

/// Moves fifty things by a few centimetres, and returns how long that took, seconds.
fn move_some(stage: &mut Stage, home: &Home) -> f64 {
    let things = home.graph.nodes().filter(|node| node.kind() == NodeKind::Object);
    let moved: Vec<_> = things
        .filter_map(|node| Some((node.id(), Translation3::new(0.03, 0.02, 0.0) * node.pose()?)))
        .step_by(6)
        .take(50)
        .collect();
    let start = Instant::now();
    moved.iter().for_each(|(thing, pose)| stage.next.place(*thing, pose).unwrap());
    start.elapsed().as_secs_f64()
}
