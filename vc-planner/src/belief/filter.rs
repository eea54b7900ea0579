//! The belief against a brute-force filter: all homes there could be are listed with
//! their chances, those that what is seen contradicts are struck out, and what is left
//! is summed.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, NodeId, Place, Relation, SceneBuilder, SceneGraph, Scope, Seed, Simulator};

use super::{Belief, places};
use crate::Prior;
use crate::prior::{self, CAUTION, HYPOTHESES, Kinds};

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

/// A home there could be: the number of the hypothesis, how likely it is by that, and the number
/// of the place of each item.
type Possible = (usize, f64, Vec<usize>);

fn possible(home: &Home, places: &[Place], prior: &Prior) -> Vec<Possible> {
    let even = 1.0 / places.len() as f64;
    let kinds = Kinds::of(&home.scene, places);
    let mut all = Vec::new();
    for (number, (parts, _)) in HYPOTHESES.into_iter().enumerate() {
        let mut homes: Vec<Possible> = vec![(number, 1.0, Vec::new())];
        for &item in &home.items {
            let likely = prior.weights(&home.scene, item, &kinds).map(|w| w.likely(&kinds));
            let likely = |p: usize| likely.as_ref().map_or(even, |l| prior::chance(parts, l[p], even));
            let with = |(n, c, at): &Possible, p: usize| (*n, c * likely(p), [at.as_slice(), &[p]].concat());
            homes = homes.iter().flat_map(|h| (0..places.len()).map(|p| with(h, p)).collect::<Vec<_>>()).collect();
        }
        all.extend(homes);
    }
    all
}

#[test]
fn marginals_are_those_of_a_brute_force_filter() {
    for (seed, prior) in (0..24).flat_map(|seed| [(seed, Prior::Kept), (seed, Prior::Uniform)]) {
        let home = home(seed);
        let places = places::all(&home.scene);
        let mut homes = possible(&home, &places, &prior);
        let mut belief = Belief::by_prior(&home.scene, home.me, seed, prior);
        let mut world = Simulator::new(home.scene.clone());
        let mut stream = Seed(seed).child("walk").stream();
        for _ in 0..5 {
            let seen = world.graph().observe(home.me, Scope::Room);
            belief.observe(&seen);
            strike_out(&mut homes, &home, &places, world.graph());
            // Once all is seen the belief may widen.
            if homes.len() <= HYPOTHESES.len() {
                break;
            }
            compare(&belief, &homes, &home, &places, seed);
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
    homes.retain(|(_, _, at)| agrees(at));
}

fn compare(belief: &Belief, homes: &[Possible], home: &Home, places: &[Place], seed: u64) {
    // What is seen tells for a hypothesis with caution, and within it in full.
    let by: Vec<f64> = (0..HYPOTHESES.len()).map(|n| homes.iter().filter(|h| h.0 == n).map(|h| h.1).sum()).collect();
    let weight = |n: usize| HYPOTHESES[n].1 * by[n].powf(CAUTION) / by[n];
    let all: f64 = homes.iter().map(|(n, chance, _)| weight(*n) * chance).sum();
    for (index, &item) in home.items.iter().enumerate() {
        for (number, &place) in places.iter().enumerate() {
            let here: f64 =
                homes.iter().filter(|h| h.2[index] == number).map(|(n, chance, _)| weight(*n) * chance).sum();
            let (filtered, believed) = (here / all, belief.probability(item, place));
            assert!(
                (filtered - believed).abs() < 1e-9,
                "{seed} {item} {place:?}: {believed}, by the filter {filtered}"
            );
        }
    }
}
