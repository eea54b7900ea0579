//! Shortest walks against a search over all corners.

use proptest::prelude::*;
use vc_geometry::grid::BitGrid;
use vc_geometry::walk::{Bands, CellPoint, shortest};
use vc_graph::Seed;

const SIDE: usize = 14;

/// A free floor with some obstacles.
fn floor(seed: u64) -> BitGrid {
    let mut stream = Seed(seed).stream();
    let mut free = BitGrid::new(SIDE, SIDE);
    free.fill((0, SIDE as i32), (0, SIDE as i32), true);
    for _ in 0..stream.count(1, 7) {
        let (x, y) = (stream.below(SIDE) as i32, stream.below(SIDE) as i32);
        free.fill((x, x + stream.count(1, 5) as i32), (y, y + stream.count(1, 5) as i32), false);
    }
    // Nobody walks between two obstacles that touch at a corner; the obvious version would.
    while let Some((x, y)) = free.inverted().cells().find(|cell| is_pinched(&free, *cell)) {
        let (x, y) = (x as i32, y as i32);
        free.fill((x - 1, x + 2), (y, y + 2), false);
    }
    free
}

/// Whether a blocked cell touches another one in the row above only at a corner.
fn is_pinched(free: &BitGrid, (x, y): (usize, usize)) -> bool {
    let blocked = |x: usize, y: usize| x < SIDE && y < SIDE && !free.get(x, y);
    let side = |to: usize| to < SIDE && blocked(to, y + 1) && !blocked(to, y) && !blocked(x, y + 1);
    side(x + 1) || side(x.wrapping_sub(1))
}

/// Whether a segment stays on free cells: its middle between any two lines of the grid is in or beside one.
fn is_open(free: &BitGrid, from: CellPoint, to: CellPoint) -> bool {
    let at = |t: f64| (from.0 + (to.0 - from.0) * t, from.1 + (to.1 - from.1) * t);
    let lines =
        |a: f64, b: f64| (0..=SIDE).map(move |line| (line as f64 - a) / (b - a)).filter(|t| *t > 0.0 && *t < 1.0);
    let mut cuts: Vec<f64> = lines(from.0, to.0).chain(lines(from.1, to.1)).chain([0.0, 1.0]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.windows(2).filter(|pair| pair[1] - pair[0] > 1e-12).all(|pair| {
        let (x, y) = at(f64::midpoint(pair[0], pair[1]));
        // A segment along a line of the grid needs a free cell on one side.
        let beside = |v: f64| {
            let near = v.round();
            let on = (v - near).abs() < 1e-9;
            [if on { near - 1.0 } else { v.floor() }, if on { near } else { v.floor() }]
        };
        beside(x)
            .into_iter()
            .any(|x| beside(y).into_iter().any(|y| x >= 0.0 && y >= 0.0 && free.get(x as usize, y as usize)))
    })
}

/// The length of the shortest way over the corners of all cells, by Dijkstra's algorithm.
fn obvious(free: &BitGrid, start: CellPoint, goal: CellPoint) -> Option<f64> {
    let corners = (0..=SIDE).flat_map(|y| (0..=SIDE).map(move |x| (x as f64, y as f64)));
    let all: Vec<CellPoint> = [start, goal].into_iter().chain(corners).collect();
    let mut length = vec![f64::INFINITY; all.len()];
    let mut done = vec![false; all.len()];
    length[0] = 0.0;
    while let Some(next) = (0..all.len()).filter(|i| !done[*i]).min_by(|a, b| length[*a].total_cmp(&length[*b])) {
        if length[next].is_infinite() {
            return None;
        }
        if next == 1 {
            return Some(length[1]);
        }
        done[next] = true;
        for other in (0..all.len()).filter(|i| !done[*i]).collect::<Vec<_>>() {
            let (a, b) = (all[next], all[other]);
            let way = length[next] + (a.0 - b.0).hypot(a.1 - b.1);
            if way < length[other] && is_open(free, a, b) {
                length[other] = way;
            }
        }
    }
    None
}

proptest! {
    #![proptest_config(crate::cases(40))]
    #[test]
    fn a_walk_is_the_shortest_and_stays_on_free_cells(seed: u64) {
        let free = floor(seed);
        let mut stream = Seed(seed).child("ends").stream();
        let mut cell = || (stream.below(SIDE) as f64 + 0.5, stream.below(SIDE) as f64 + 0.5);
        let (start, goal) = (cell(), cell());
        prop_assume!([start, goal].iter().all(|p| free.get(p.0 as usize, p.1 as usize)));
        let met = free.flood(start.0 as usize, start.1 as usize).get(goal.0 as usize, goal.1 as usize);
        let found = shortest(&Bands::new(&free), start, goal);
        prop_assert_eq!(found.is_some(), met);
        if let Some((corners, length)) = found {
            prop_assert!(corners.windows(2).all(|pair| is_open(&free, pair[0], pair[1])), "{:?}", corners);
            let along: f64 = corners.windows(2).map(|p| (p[0].0 - p[1].0).hypot(p[0].1 - p[1].1)).sum();
            prop_assert!((along - length).abs() < 1e-6);
            let least = obvious(&free, start, goal).unwrap();
            prop_assert!(length <= least + 1e-6, "{} instead of {}", length, least);
        }
    }
}
