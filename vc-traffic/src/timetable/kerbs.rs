//! Where the people of each door get into their cars and out of them.

use std::collections::BTreeMap;

use vc_map::{EntranceId, RoadId, Users};

use super::walk::Pavements;
use crate::VehicleClass;
use crate::network::Network;
use crate::trip::Kerb;

/// A kerb is at most so far from the place before a door, metres.
const NEAR: f64 = 60.0;
/// A vehicle stands so far within the ends of a lane, metres.
const WITHIN: f32 = 3.0;
/// The roads that lead to most others are looked for from so many.
const TRIES: usize = 8;

/// The kerbs of doors, each found when it is first asked for.
pub(super) struct Kerbs {
    /// For each road's side: whether one comes there from everywhere, and from there everywhere.
    joined: Vec<bool>,
    found: BTreeMap<EntranceId, Option<(u32, Kerb)>>,
}

impl Kerbs {
    pub(super) fn new(network: &Network) -> Self {
        Self { joined: joined(network), found: BTreeMap::new() }
    }

    /// The lane and the place on it that are nearest to a door; `None` where cars do not come.
    pub(super) fn of(
        &mut self,
        network: &Network,
        pavements: &Pavements,
        door: EntranceId,
        class: &VehicleClass,
    ) -> Option<(u32, Kerb)> {
        *self.found.entry(door).or_insert_with(|| kerb(network, &self.joined, pavements, door, class))
    }
}

fn kerb(
    network: &Network,
    joined: &[bool],
    pavements: &Pavements,
    door: EntranceId,
    class: &VehicleClass,
) -> Option<(u32, Kerb)> {
    let before = pavements.before(door)?;
    let (near, _) = network.map.lane_near(&before, Users::CAR, NEAR)?;
    let near = network.side[near.index()];
    let side = [near, near ^ 1].into_iter().find(|side| joined[*side as usize])?;
    let cars = |lane: &&u32| network.users[**lane as usize].has(Users::CAR);
    let lane = *network.sides[side as usize].iter().rev().find(cars)?;
    let station = network.line(lane).project(&before).station as f32;
    let first = network.begin[lane as usize] + class.length + 0.2;
    let last = (network.length[lane as usize] - WITHIN).min(network.stop[lane as usize]);
    let station = if first <= last { station.clamp(first, last) } else { return None };
    Some((lane, Kerb { road: RoadId(side / 2), forward: side.is_multiple_of(2), station }))
}

/// The sides of roads that all lead to each other: the most that are found from some.
fn joined(network: &Network) -> Vec<bool> {
    let sides = network.sides.len();
    let mut ahead = vec![Vec::new(); sides];
    let mut back = vec![Vec::new(); sides];
    for (movement, (from, to)) in network.from.iter().zip(&network.to).enumerate() {
        let [from, to] = [from, to].map(|lane| network.side[*lane as usize]);
        if network.users[network.lanes + movement].has(Users::CAR) {
            ahead[from as usize].push(to);
            back[to as usize].push(from);
        }
    }
    let used: Vec<usize> = (0..sides).filter(|side| !network.sides[*side].is_empty()).collect();
    let tries = (0..TRIES).filter_map(|number| used.get(used.len() * (2 * number + 1) / (2 * TRIES)));
    let all = tries.map(|side| {
        let [to, from] = [&ahead, &back].map(|links| reached(links, *side));
        to.into_iter().zip(from).map(|(to, from)| to && from).collect::<Vec<bool>>()
    });
    let count = |joined: &Vec<bool>| joined.iter().filter(|joined| **joined).count();
    all.reduce(|best, next| if count(&next) > count(&best) { next } else { best }).unwrap_or_default()
}

fn reached(links: &[Vec<u32>], from: usize) -> Vec<bool> {
    let mut seen = vec![false; links.len()];
    seen[from] = true;
    let mut next = vec![from];
    while let Some(side) = next.pop() {
        for to in &links[side] {
            if !std::mem::replace(&mut seen[*to as usize], true) {
                next.push(*to as usize);
            }
        }
    }
    seen
}
