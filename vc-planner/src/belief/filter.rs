//! The belief against a brute-force filter: all homes there could be are listed with
//! their chances, those that what is seen contradicts are struck out, and what is left
//! is summed.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::portable::Portable;
use vc_graph::{Draft, NodeId, Place, Relation, SceneBuilder, SceneGraph, Scope, Seed, Simulator};

use super::{Belief, places};
use crate::Prior;
use crate::prior::{self, CAUTION, HYPOTHESES, Kinds, Likely, Weights};

const ITEMS: [&str; 4] = ["apple", "mug", "mug", "book"];

struct Home {
    scene: SceneGraph,
    me: NodeId,
    items: Vec<NodeId>,
    fixed: Vec<NodeId>,
}

fn home(seed: u64) -> Home {
    let mut stream = Seed(seed).child("filter").stream();
    let mut scene = SceneBuilder::new("small");
    let rooms = ["kitchen", "bedroom"].map(|r| scene.add(Draft::new(r)).unwrap());
    let fixed: Vec<NodeId> = ["kitchen_table", "fridge", "nightstand", "desk"]
        .iter()
        .map(|class| scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(*class)).unwrap())
        .collect();
    let items = ITEMS
        .iter()
        .map(|class| match stream.pick(&fixed).copied().unwrap() {
            at if at == fixed[1] => scene.add_in(at, Draft::new(*class)).unwrap(),
            at => scene.add_on(at, Draft::new(*class)).unwrap(),
        })
        .collect();
    let me = scene.add_in(rooms[0], Draft::new("character")).unwrap();
    Home { scene: scene.build(), me, items, fixed }
}

/// A home there could be: the number of the place of each item.
type Possible = Vec<usize>;

fn possible(places: &[Place]) -> Vec<Possible> {
    let mut homes = vec![Vec::new()];
    for _ in ITEMS {
        let with = |at: &Possible, p: usize| [at.as_slice(), &[p]].concat();
        homes = homes.iter().flat_map(|h| (0..places.len()).map(|p| with(h, p)).collect::<Vec<_>>()).collect();
    }
    homes
}

/// The weights of places for each item, and how far the items that were found speak for each hypothesis.
struct Judge {
    kinds: Kinds,
    weights: Vec<Option<Weights>>,
    likely: Vec<Option<Likely>>,
    found: Vec<bool>,
    by: [f64; HYPOTHESES.len()],
    even: f64,
}

impl Judge {
    fn new(home: &Home, places: &[Place], prior: &Prior) -> Self {
        let kinds = Kinds::new(&home.scene, places);
        let weights: Vec<_> = home.items.iter().map(|&item| prior.weights(&home.scene, item, &kinds)).collect();
        let likely = weights.iter().map(|w| w.as_ref().map(|w| w.likely(&kinds))).collect();
        let (found, even) = (vec![false; weights.len()], 1.0 / places.len() as f64);
        Self { kinds, weights, likely, found, by: [1.0; HYPOTHESES.len()], even }
    }

    fn chance(&self, hypothesis: usize, item: usize, place: usize) -> f64 {
        let likely = self.likely[item].as_ref().map(|likely| likely[self.kinds.of_place(place)]);
        likely.map_or(self.even, |likely| prior::chance(HYPOTHESES[hypothesis].0, likely, self.even))
    }

    /// Items that are found tell of the home, and of others of their class.
    fn find(&mut self, new: &[(usize, usize)]) {
        for &(item, place) in new {
            let updated: [f64; HYPOTHESES.len()] = std::array::from_fn(|h| self.by[h] * self.chance(h, item, place));
            (self.by, self.found[item]) = (updated, true);
        }
        for &(item, place) in new {
            for other in (0..ITEMS.len()).filter(|&other| ITEMS[other] == ITEMS[item]) {
                let Some(weights) = &mut self.weights[other] else { continue };
                weights.find(self.kinds.of_place(place));
                self.likely[other] = Some(weights.likely(&self.kinds));
            }
        }
    }

    /// How likely a home is by a hypothesis, what has been found apart.
    fn weight(&self, hypothesis: usize, at: &Possible) -> f64 {
        let missing = at.iter().enumerate().filter(|(item, _)| !self.found[*item]);
        missing.map(|(item, &place)| self.chance(hypothesis, item, place)).product()
    }
}

#[test]
fn marginals_are_those_of_a_brute_force_filter() {
    for (seed, prior) in (0..24).flat_map(|seed| [(seed, Prior::Kept), (seed, Prior::Uniform)]) {
        let home = home(seed);
        let places = places::all(&home.scene);
        let (mut homes, mut judge) = (possible(&places), Judge::new(&home, &places, &prior));
        let mut belief = Belief::with_prior(&home.scene, home.me, seed, prior);
        let mut world = Simulator::new(home.scene.clone());
        let mut stream = Seed(seed).child("walk").stream();
        for _ in 0..5 {
            let seen = world.graph().observe(home.me, Scope::Room);
            belief.observe(&seen);
            strike_out(&mut homes, &home, &places, world.graph());
            // Once all is seen the belief may widen.
            if homes.len() <= 1 {
                break;
            }
            let new = |i: &usize| !judge.found[*i] && seen.sees(home.items[*i]);
            let new: Vec<(usize, usize)> = (0..ITEMS.len()).filter(new).map(|i| (i, homes[0][i])).collect();
            judge.find(&new);
            compare(&belief, &homes, &judge, &home, &places, seed);
            let at = *stream.pick(&home.fixed).unwrap();
            let label = world.graph().label(at).to_string();
            for verb in ["walk", "open"] {
                if let Ok(changes) = world.step(home.me, &format!("{verb} {label}").parse().unwrap()) {
                    drop(changes);
                    belief.expect(&format!("{verb} {label}").parse().unwrap());
                }
            }
        }
    }
}

/// Leaves the homes in which the places in view hold what they hold.
fn strike_out(homes: &mut Vec<Possible>, home: &Home, places: &[Place], real: &SceneGraph) {
    let room = real.room_of(home.me);
    let in_view = |p: &Place| match p.relation {
        Relation::InRoom => Some(p.at) == room,
        Relation::Inside => real.room_of(p.at) == room && !real.node(p.at).unwrap().hides_contents(),
        _ => real.room_of(p.at) == room,
    };
    let really = |item: NodeId, p: &Place| match p.relation {
        Relation::InRoom => real.place(item).is_none() && real.room_of(item) == Some(p.at),
        _ => real.place(item) == Some(*p),
    };
    let agrees = |at: &[usize]| {
        places.iter().enumerate().filter(|(_, p)| in_view(p)).all(|(number, place)| {
            home.items.iter().zip(at).all(|(&item, &supposed)| (supposed == number) == really(item, place))
        })
    };
    homes.retain(|at| agrees(at));
}

fn compare(belief: &Belief, homes: &[Possible], judge: &Judge, home: &Home, places: &[Place], seed: u64) {
    // Observations count for a hypothesis with caution, and within a hypothesis in full.
    let mut weights = vec![0.0; homes.len()];
    for (hypothesis, (_, supposed)) in HYPOTHESES.into_iter().enumerate() {
        let each: Vec<f64> = homes.iter().map(|at| judge.weight(hypothesis, at)).collect();
        let sum: f64 = each.iter().sum();
        let posterior = supposed * (judge.by[hypothesis] * sum).power(CAUTION);
        weights.iter_mut().zip(each).for_each(|(weight, each)| *weight += posterior * each / sum);
    }
    let all: f64 = weights.iter().sum();
    for (index, &item) in home.items.iter().enumerate() {
        for (number, &place) in places.iter().enumerate() {
            let here: f64 = homes.iter().zip(&weights).filter(|(at, _)| at[index] == number).map(|(_, w)| w).sum();
            let (filtered, believed) = (here / all, belief.probability(item, place));
            assert!(
                (filtered - believed).abs() < 1e-9,
                "{seed} {item} {place:?}: {believed}, by the filter {filtered}"
            );
        }
    }
}
