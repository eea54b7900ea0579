//! The swept paths of long vehicles: in turns their bodies cut corners, over ways that those of cars keep off.

use vc_map::Point;

use crate::network::Network;
use crate::pose::{Pose, body};

/// Longer vehicles are long, metres; the others have at most this size.
const LONG: f32 = 6.5;
const SHORT: [f32; 2] = [6.0, 2.0];
/// Bodies are looked at each so many metres of their way, and are so far from those that sweep past, metres: each may be 0.3 m beside its lane's middle.
const STEP: f64 = 1.0;
const APART: f64 = 0.6;
/// Lines are moved back by steps of this, and at most so far, metres.
const BACK: f32 = 0.5;
const MOST_BACK: f32 = 14.0;

/// For each junction and each of its rows, those rows that are in its way, as bits, if one of the two who go there is long.
pub(crate) struct Swept(Vec<Vec<Vec<u64>>>);

/// Whether a vehicle of a length in metres is long.
pub(crate) fn is_long(length: f32) -> bool {
    length > LONG
}

impl Swept {
    /// Finds the ways in the way of vehicles of a size, and moves the lines of a network back to where they sweep past nobody who waits there. Costs a comparison of
    /// bodies at each metre of each pair of ways over a junction that come near each other.
    pub(crate) fn new(network: &mut Network, size: [f32; 2]) -> Self {
        let junctions = 0..network.rows.len();
        Self(junctions.map(|junction| of_junction(network, junction, size)).collect())
    }

    /// Whether two rows are in each other's way.
    pub(crate) fn meet(&self, junction: usize, row: usize, other: usize) -> bool {
        self.0[junction]
            .get(row)
            .is_some_and(|met| met.get(other / 64).is_some_and(|bits| bits >> (other % 64) & 1 == 1))
    }

    /// Whether none of some rows, as bits, is in the way of a row.
    pub(crate) fn is_free(&self, junction: usize, row: usize, busy: &[u64]) -> bool {
        self.0[junction].get(row).is_none_or(|met| met.iter().zip(busy).all(|(met, busy)| met & busy == 0))
    }
}

/// The bodies of a vehicle on its way over a junction, and the box around them.
struct Sweep {
    bodies: Vec<Pose>,
    low: Point,
    high: Point,
}

impl Sweep {
    fn new(network: &Network, movement: usize, [length, width]: [f32; 2]) -> Self {
        let link = (network.lanes + movement) as u32;
        let [before, own, after] = [network.from[movement], link, network.to[movement]].map(|link| network.line(link));
        let at = |station: f64| match station {
            station if station < 0.0 => before.at(before.length() + station),
            station if station <= own.length() => own.at(station),
            station => after.at(station - own.length()),
        };
        let steps = ((own.length() + f64::from(length)) / STEP).ceil() as u32;
        let bodies: Vec<Pose> =
            (0..=steps).map(|step| Pose::of(body(at, f64::from(step) * STEP, length), [length, width])).collect();
        let corners = || bodies.iter().flat_map(Pose::corners);
        let start = own.start();
        let low = corners().fold(start, |low, corner| low.inf(&corner));
        let high = corners().fold(start, |high, corner| high.sup(&corner));
        Self { bodies, low, high }
    }

    fn meets(&self, other: &Self) -> bool {
        let gap = (self.low - other.high).sup(&(other.low - self.high));
        gap.x < 0.0 && gap.y < 0.0 && self.bodies.iter().any(|body| other.is_over(body))
    }

    fn is_over(&self, body: &Pose) -> bool {
        self.bodies.iter().any(|own| own.overlap(body) > -APART)
    }
}

fn of_junction(network: &mut Network, junction: usize, size: [f32; 2]) -> Vec<Vec<u64>> {
    let rows = network.rows[junction].clone();
    let sweeps = |size: [f32; 2]| -> Vec<Sweep> {
        rows.iter().map(|link| Sweep::new(network, network.movement(*link), size)).collect()
    };
    let (long, short) = (sweeps(size), sweeps(SHORT));
    let mut met = vec![vec![0_u64; rows.len().div_ceil(64)]; rows.len()];
    let from = |row: usize| network.from[network.movement(rows[row])];
    let pairs = (0..rows.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
    for (a, b) in pairs.filter(|(a, b)| from(*a) != from(*b)) {
        if long[a].meets(&long[b]) || long[a].meets(&short[b]) || short[a].meets(&long[b]) {
            met[a][b / 64] |= 1 << (b % 64);
            met[b][a / 64] |= 1 << (a % 64);
        }
    }
    let mut lanes: Vec<u32> = (0..rows.len()).map(from).collect();
    lanes.sort_unstable();
    lanes.dedup();
    let mut stops = Vec::new();
    for lane in lanes {
        let others: Vec<&Sweep> = (0..rows.len()).filter(|row| from(*row) != lane).map(|row| &long[row]).collect();
        let line = network.line(lane);
        let stop = network.stop[lane as usize];
        let waits = |station: f32| {
            let at = |station: f64| line.at(station.max(0.0));
            Pose::of(body(at, f64::from(station), SHORT[0]), [SHORT[0], size[1]])
        };
        let swept = |station: f32| {
            let body = waits(station);
            others.iter().any(|sweep| sweep.is_over(&body))
        };
        let most = (stop - size[0]).min(MOST_BACK);
        let back = (0..=(most / BACK).max(0.0) as u32).map(|step| stop - step as f32 * BACK);
        if let Some(station) = back.into_iter().find(|station| !swept(*station)).filter(|station| *station < stop) {
            stops.push((lane, station));
        }
    }
    stops.into_iter().for_each(|(lane, station)| network.stop_at(lane, station));
    for (link, _) in rows.iter().zip(&met).filter(|(_, met)| met.iter().any(|bits| *bits != 0)) {
        network.asks_at(junction, *link);
    }
    met
}
