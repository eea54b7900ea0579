//! Curtains of generated homes leave their windows free, or cover them without intersecting a radiator.

#![allow(clippy::unwrap_used)]

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use vc_testkit::amount;
use virtualcity::graph::{Node, NodeId, Pose, SceneGraph, Seed};
use virtualcity::procgen::Apartment;
use virtualcity::render::{RayCaster, RayHit, Renderer, Snapshot};

/// Number of sample points along a window and upwards.
const PLACES: usize = 16;

/// A window with curtains, and the radiators of its room.
struct Hung {
    pose: Pose,
    size: Vector3<f32>,
    curtains: Vec<NodeId>,
    radiators: Vec<NodeId>,
}

fn hung(graph: &SceneGraph) -> Vec<Hung> {
    let at = |node: &Node| node.pose().unwrap().translation.vector.xy();
    let of = |window: &Node| {
        let size = window.spec().bounds.unwrap().half * 2.0;
        let all = |class: &str| graph.of_class(class).into_iter().filter_map(|id| graph.node(id)).collect::<Vec<_>>();
        let inside = |n: &&Node| graph.room_of(n.id()) == graph.room_of(window.id());
        let hangs = |n: &&Node| (at(window) - at(n)).norm() < 0.5 * size.y + 0.4;
        let curtains = all("curtain").into_iter().filter(inside).filter(hangs).map(Node::id).collect();
        let radiators = all("radiator").into_iter().filter(inside).map(Node::id).collect();
        Hung { pose: *window.pose().unwrap(), size, curtains, radiators }
    };
    let windows = graph.of_class("window");
    windows.iter().map(|id| of(graph.node(*id).unwrap())).filter(|hung| !hung.curtains.is_empty()).collect()
}

/// All hits along a ray.
fn met(caster: &RayCaster, from: Point3<f32>, along: Vector3<f32>, reach: f32) -> Vec<RayHit> {
    let (mut hits, mut at) = (Vec::new(), 0.0);
    while let Some(hit) = caster.first(&(from + at * along), &along, reach - at) {
        at += hit.distance + 1e-4;
        hits.push(hit);
    }
    hits
}

fn places() -> impl Iterator<Item = [f32; 2]> {
    (0..PLACES * PLACES).map(|i| [i % PLACES, i / PLACES].map(|k| (k as f32 + 0.5) / PLACES as f32))
}

impl Hung {
    /// The fraction of the window that its curtains cover.
    fn covered(&self, caster: &RayCaster) -> f32 {
        let along = self.pose.rotation * Vector3::x();
        let covers = |[u, v]: &[f32; 2]| {
            let from = self.pose * Point3::new(-0.05, (u - 0.5) * 0.84 * self.size.y, (0.08 + 0.84 * v) * self.size.z);
            met(caster, from, along, 0.6).iter().any(|hit| self.curtains.contains(&hit.node))
        };
        places().filter(covers).count() as f32 / (PLACES * PLACES) as f32
    }

    /// The number of sample points at which a curtain is hit between the front and the back of a radiator.
    fn through(&self, caster: &RayCaster) -> usize {
        let into = self.pose.rotation * -Vector3::x();
        let meets = |[u, v]: &[f32; 2]| {
            let mut from = self.pose * Point3::new(1.0, (u - 0.5) * (self.size.y + 0.7), 0.0);
            from.z = 0.03 + v;
            let hits = met(caster, from, into, 1.2);
            let warm = |hit: &RayHit| self.radiators.contains(&hit.node);
            let (first, last) = (hits.iter().position(warm), hits.iter().rposition(warm));
            let between = first.zip(last).map(|(first, last)| &hits[first..last]).unwrap_or_default();
            between.iter().any(|hit| self.curtains.contains(&hit.node))
        };
        places().filter(meets).count()
    }
}

fn drawn(snapshot: &Snapshot, windows: &[Hung], closed: bool) -> RayCaster {
    let mut drawn = snapshot.clone();
    windows.iter().flat_map(|hung| &hung.curtains).for_each(|curtain| drawn.draw_cover(*curtain, closed).unwrap());
    RayCaster::new(&drawn)
}

/// The numbers of windows in a home with curtains, of those with radiators in their room, and of those covered.
fn counts(seed: u64) -> [usize; 3] {
    let graph = Apartment::from_seed(Seed(seed)).unwrap().scene();
    let snapshot = Renderer::new().snapshot(&graph).unwrap();
    let all = hung(&graph);
    let [open, closed] = [false, true].map(|closed| drawn(&snapshot, &all, closed));
    let covered = |window: &&Hung| {
        let place = format!("home {seed}, curtains {:?}", window.curtains);
        let [aside, over] = [&open, &closed].map(|caster| window.covered(caster));
        assert!(aside <= 0.25, "{place}: {aside} of the window are covered where they are open");
        assert_eq!(window.through(&open) + window.through(&closed), 0, "{place}: through a radiator");
        over > 0.95
    };
    let warmed = all.iter().filter(|window| !window.radiators.is_empty()).count();
    [all.len(), warmed, all.iter().filter(covered).count()]
}

#[test]
fn curtains_leave_windows_free_or_cover_them_and_go_through_no_radiator() {
    let each = (0..amount(4, 20)).into_par_iter().map(counts);
    let [windows, warmed, covered] = each.reduce(|| [0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
    eprintln!("{covered} of {windows} windows are covered by closed curtains; {warmed} have radiators in their room");
    assert!(windows > amount(6, 30) && warmed > amount(4, 20));
    assert!(20 * covered >= 19 * windows, "{covered} of {windows} windows are covered by closed curtains");
}
