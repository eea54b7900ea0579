//! What pictures cost: sixteen views of a home of 130,000 and of a million triangles, in four sizes. Run with
//! `cargo bench -p vc-render --bench render`; `-- first` leaves the million out. Light is the sun and three lamps,
//! and in a row of its own two lamps alone. Another row is for what is hidden at the next moment, which the six leave
//! out.
//!
//! CPU time of one thread, the time on the wall when all threads make a picture together, and when they make
//! many side by side. The mean over the views of the median of seven; light is made once and not
//! counted, frames are used again.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "support/home.rs"]
mod home;
#[path = "support/stage.rs"]
mod stage;

use home::{cameras, home};
use stage::{LABELS, Stage, row, table};
use vc_render::{Daylight, Modality};

/// Cells along an edge of each mesh: 130,000 and a million triangles.
const FINE: [i32; 2] = [6, 17];

fn main() {
    let first = std::env::args().any(|word| word == "first");
    let poses: Vec<_> = cameras(64, 64).iter().map(|camera| camera.pose).collect();
    for fine in FINE.into_iter().take(if first { 1 } else { 2 }) {
        let home = home(fine, 300);
        let stage = Stage::new(&home.graph, &home.lamps);
        table("a home of 300 objects", &stage, &poses);
        let hidden = (LABELS.0 | Modality::Occlusion, false);
        row(&stage, &poses, ("labels, and what is hidden", hidden));
        let seen = Modality::Depth | Modality::Instance | Modality::Rgb;
        let lamps = Stage::lit(&home.graph, &home.lamps[..2], &Daylight::overcast());
        row(&lamps, &poses, ("colours of two lamps, the same", (seen, false)));
    }
}
