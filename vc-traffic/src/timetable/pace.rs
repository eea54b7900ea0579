//! How fast vehicles of the timetable pass each link: at its limit, less what they lose to slow down before the turns at its end and to speed up
//! after those at its start.

use super::TICKS;
use crate::VehicleClass;
use crate::network::Network;

/// Those who stood in a queue go over the junction at this speed, metres per second.
const FROM_QUEUE: f64 = 5.0;

/// The paces of all links, metres per tick. They are those of lanes, not of vehicles: two on a lane keep their distance.
pub(super) struct Paces(Vec<f64>);

impl Paces {
    pub(super) fn new(network: &Network, class: &VehicleClass) -> Self {
        let limit = |link: usize| f64::from(network.limit[link]);
        let [faster, slower] = [class.acceleration, class.deceleration].map(f64::from);
        // The time that one loses who changes between two speeds, on the way of the faster one.
        let lost = |v: f64, u: f64, change: f64| (v - u.min(v)) * (v - u.min(v)) / (2.0 * v * change);
        let over = |link: &u32| {
            let stops = network.stops[network.from[network.movement(*link)] as usize];
            if stops { 0.0 } else { limit(*link as usize) }
        };
        let mean = |links: &[u32], loss: &dyn Fn(f64) -> f64| {
            links.iter().map(|link| loss(over(link))).sum::<f64>() / links.len().max(1) as f64
        };
        let lane = |lane: usize| {
            let (v, length) = (limit(lane), f64::from(network.length[lane]));
            let loss = mean(&network.next[lane], &|u| lost(v, u, slower));
            let loss = loss + mean(&network.before[lane], &|u| lost(v, u, faster));
            length / (length / v + loss)
        };
        let movements = network.lanes..network.length.len();
        Self((0..network.lanes).map(lane).chain(movements.map(limit)).map(|speed| speed / TICKS).collect())
    }

    /// Metres per tick.
    pub(super) fn of(&self, link: u32) -> f64 {
        self.0[link as usize]
    }

    /// The pace over a junction of one who stood before it, metres per tick.
    pub(super) fn out_of_queue(&self, link: u32) -> f64 {
        self.of(link).min(FROM_QUEUE / TICKS)
    }
}
