//! Objects are drawn within their boxes, and only window covers are drawn over windows.

use rayon::prelude::*;
use virtualcity::graph::{Bounds, Draft, NodeId, Pose, SceneBuilder, State};
use virtualcity::render::Renderer;

use super::home;

/// The objects that are drawn more than a centimetre outside their boxes in a home in its initial state; three
/// centimetres are allowed for elbows.
fn drawn_out(seed: u64) -> Vec<String> {
    let home = home(seed, 1);
    let snapshot = home.snapshot().unwrap();
    let off = |id: NodeId| {
        let node = home.graph().node(id)?;
        let (own, drawn) = (node.aabb()?, snapshot.bounds(id)?);
        let out = (own.min - drawn.min).sup(&(drawn.max - own.max)).max();
        let slack = if home.agents().contains(&id) { 0.03 } else { 0.01 };
        (out > slack).then(|| format!("home {seed}: {} is drawn {out} m out of its box", node.label()))
    };
    snapshot.nodes().filter_map(off).collect()
}

#[test]
fn things_are_drawn_within_their_boxes() {
    let all: Vec<String> = [3, 8, 42].into_par_iter().flat_map_iter(drawn_out).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// The same for many homes: `proofs/drawn_bounds`.
#[test]
#[ignore = "takes minutes; proofs/drawn_bounds runs it for ten homes at a time"]
fn things_are_drawn_within_their_boxes_in_many_homes() {
    let range = std::env::var("VC_HOMES").unwrap_or_else(|_| "0..200".into());
    let (from, to) = range.split_once("..").unwrap();
    let homes = from.parse::<u64>().unwrap()..to.parse().unwrap();
    let all: Vec<String> = homes.into_par_iter().flat_map_iter(drawn_out).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// Boxes, umbrellas and bags in front of a window are covers, but not curtains.
#[test]
fn lids_are_no_curtains() {
    let mut scene = SceneBuilder::new("study");
    let window = Draft::new("window").bounds(Bounds::standing([0.1, 1.2, 1.4].into()));
    scene.add(window.at(Pose::translation(0.0, 0.0, 0.9))).unwrap();
    let names = ["box", "umbrella", "bag", "curtain"];
    let things = names.map(|class| {
        let bounds = Bounds::standing([0.1, 0.3, 0.4].into());
        scene.add(Draft::new(class).bounds(bounds).at(Pose::translation(0.12, 0.3, 1.2)).state(State::Closed)).unwrap()
    });
    let snapshot = Renderer::new().snapshot(&scene.build()).unwrap();
    for (class, thing) in names.into_iter().zip(things) {
        let drawn = snapshot.bounds(thing).unwrap();
        let wide = drawn.max.y - drawn.min.y;
        assert_eq!(wide > 0.31, class == "curtain", "{class} is {wide} m wide");
    }
}
