//! Where things are likely to be before anything has been seen.

use std::sync::Arc;

use vc_graph::{Kind, NodeId, Place, Relation, SceneGraph};

/// How tidy a home may be: the share of its things that are where habit puts them (the
/// others are anywhere), and how likely each share is before anything has been seen.
/// None is one, so that no place is ever ruled out by habit alone.
pub(crate) const SHARES: [(f64, f64); 4] = [(0.0, 0.25), (0.5, 0.15), (0.8, 0.25), (0.95, 0.35)];

/// What is supposed about the places of things that have not been seen.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub enum Prior {
    /// Every place is equally likely, as in the thesis.
    Uniform,
    /// Things are where people keep them, by the `kept` column of the scene's class
    /// table, or anywhere. How many are is learned from where things are found.
    #[default]
    Kept,
    /// As [`Prior::Kept`], by habits of your own.
    Habits(Arc<[Habit]>),
}

/// That things of a class are found at a place, so many times as likely as at one
/// with weight 1.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Habit {
    /// Class of the thing, `mug`; kinds of it are meant as well.
    pub class: String,
    /// Class of the room; any, if none.
    pub room: Option<String>,
    /// On or inside.
    pub relation: Relation,
    /// Class of what it is on or in.
    pub at: String,
    /// Relative weight.
    pub weight: f64,
}

impl Prior {
    /// How likely each place is by habit for a thing; they sum to one. `None` where
    /// habit says nothing.
    pub(crate) fn habit(&self, graph: &SceneGraph, id: NodeId, places: &[Place]) -> Option<Vec<f64>> {
        let mut raw: Vec<f64> = match self {
            Self::Uniform => return None,
            Self::Kept => kept(graph, id, places),
            Self::Habits(habits) => by_habits(habits, graph, id, places),
        };
        let sum: f64 = raw.iter().sum();
        raw.iter_mut().for_each(|w| *w /= sum);
        (sum > 0.0).then_some(raw)
    }
}

/// What is supposed about the things of one class that have not been found.
#[derive(Debug, Clone)]
pub(crate) struct Supposed {
    /// How likely each place is by habit, if habit says anything.
    pub(crate) habit: Option<Arc<[f64]>>,
    /// How much of that is left in places not seen.
    pub(crate) left: f64,
    /// How many of the class are missing.
    pub(crate) missing: usize,
}

/// How likely each share of tidy things is after what has been found and not found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tidiness {
    /// Logarithms of how well each share explains what has been found.
    found: [f64; SHARES.len()],
    /// The chance of each share, what was not found taken into account.
    chances: [f64; SHARES.len()],
}

impl Default for Tidiness {
    fn default() -> Self {
        Self { found: [0.0; SHARES.len()], chances: SHARES.map(|(_, chance)| chance) }
    }
}

impl Tidiness {
    /// Takes note that a thing was found where habit and chance put it so often.
    pub(crate) fn found(&mut self, habit: f64, even: f64) {
        for (weight, (share, _)) in self.found.iter_mut().zip(SHARES) {
            *weight += (share * habit / even + 1.0 - share).ln();
        }
    }

    /// Weighs what is still missing, with the share of places not seen.
    pub(crate) fn settle<'a>(&mut self, classes: impl Iterator<Item = &'a Supposed>, unseen: f64) {
        let mut logs = self.found;
        for class in classes.filter(|c| c.habit.is_some() && c.missing > 0) {
            for (log, (share, _)) in logs.iter_mut().zip(SHARES) {
                *log += class.missing as f64 * (share * class.left + (1.0 - share) * unseen).max(LEAST).ln();
            }
        }
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let raw: [f64; SHARES.len()] = std::array::from_fn(|i| SHARES[i].1 * (logs[i] - most).exp());
        let sum: f64 = raw.iter().sum();
        self.chances = raw.map(|w| w / sum);
    }

    /// The chances of places for a class: `even` for each, and so much for each unit of
    /// habit.
    pub(crate) fn mix(&self, class: &Supposed, unseen: f64, even: f64) -> (f64, f64) {
        if class.habit.is_none() {
            return (even / unseen.max(LEAST), 0.0);
        }
        let mut mixed = (0.0, 0.0);
        for (chance, (share, _)) in self.chances.iter().zip(SHARES) {
            let all = (share * class.left + (1.0 - share) * unseen).max(LEAST);
            mixed.0 += chance * (1.0 - share) * even / all;
            mixed.1 += chance * share / all;
        }
        mixed
    }
}

/// Guards a logarithm and a division.
const LEAST: f64 = 1e-12;

fn class(graph: &SceneGraph, id: NodeId) -> &str {
    graph.node(id).map_or("", |n| n.class())
}

/// By the class table. The weight of a habit is shared by the places it fits.
fn kept(graph: &SceneGraph, id: NodeId, places: &[Place]) -> Vec<f64> {
    let classes = graph.classes();
    let Some(own) = classes.get(class(graph, id)) else { return Vec::new() };
    let mut weights = vec![0.0; places.len()];
    for habit in &own.kept {
        let fits = |place: &Place| {
            let room = graph.room_of(place.at).map_or("", |r| class(graph, r));
            habit.room.as_ref().is_none_or(|wanted| classes.is_a(room, wanted))
                && match &habit.at {
                    Some((relation, at)) => *relation == place.relation && classes.is_a(class(graph, place.at), at),
                    None => is_open_floor(graph, place),
                }
        };
        share(&mut weights, places, fits, f64::from(habit.weight));
    }
    weights
}

fn by_habits(habits: &[Habit], graph: &SceneGraph, id: NodeId, places: &[Place]) -> Vec<f64> {
    let classes = graph.classes();
    let mut weights = vec![0.0; places.len()];
    for habit in habits.iter().filter(|h| h.weight > 0.0 && classes.is_a(class(graph, id), &h.class)) {
        let fits = |place: &Place| {
            let room = graph.room_of(place.at).map_or("", |r| class(graph, r));
            habit.room.as_ref().is_none_or(|wanted| classes.is_a(room, wanted))
                && habit.relation == place.relation
                && classes.is_a(class(graph, place.at), &habit.at)
        };
        share(&mut weights, places, fits, habit.weight);
    }
    weights
}

fn share(weights: &mut [f64], places: &[Place], fits: impl Fn(&Place) -> bool, weight: f64) {
    let fitting: Vec<usize> = (0..places.len()).filter(|&i| fits(&places[i])).collect();
    for &i in &fitting {
        weights[i] += weight / fitting.len() as f64;
    }
}

fn is_open_floor(graph: &SceneGraph, place: &Place) -> bool {
    let node = graph.node(place.at);
    node.is_some_and(|n| n.kind() == Kind::Room || &**n.class() == "floor")
}
