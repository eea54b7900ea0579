//! Lorries and buses among the others: they cut corners.

use vc_graph::Seed;
use vc_map::{Control, DrivingSide};
use vc_traffic::{Traffic, TrafficOptions};

use crate::grid::{grid, trips};

#[test]
fn lorries_and_buses_overlap_nobody_and_all_arrive() {
    for control in [Control::Signals, Control::Priority, Control::AllWayStop] {
        for (lanes, side) in [(1, DrivingSide::Right), (2, DrivingSide::Left), (3, DrivingSide::Right)] {
            let map = grid(3, lanes, control, side);
            // A sixth of them buses, a sixth lorries.
            let demand = trips(&map, 400, 400.0, &[0, 0, 1, 2, 3, 4], Seed(5));
            let mut traffic = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(1)).unwrap();
            for step in 0..12_000 {
                traffic.step();
                assert_eq!(traffic.overlaps(), [], "{control:?} {lanes} {side:?} step {step}");
            }
            assert_eq!((traffic.len(), traffic.waiting()), (0, 0), "{control:?} {lanes} {side:?}");
        }
    }
}

#[test]
fn a_save_with_lorries_and_buses_goes_on_alike() {
    let map = grid(2, 2, Control::Signals, DrivingSide::Right);
    let demand = trips(&map, 200, 200.0, &[0, 2, 3], Seed(5));
    let mut traffic = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(1)).unwrap();
    let fresh = traffic.clone();
    for _ in 0..8 {
        (0..150).for_each(|_| traffic.step());
        let mut restored = fresh.clone();
        restored.restore(&traffic.save()).unwrap();
        let mut copy = traffic.clone();
        for step in 0..150 {
            copy.step();
            restored.step();
            assert_eq!(copy.digest(), restored.digest(), "step {step}");
        }
    }
}
