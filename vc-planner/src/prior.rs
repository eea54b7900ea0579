//! Where things are likely to be before anything has been seen.

use std::sync::Arc;

use vc_graph::{Kind, NodeId, Place, Relation, SceneGraph};

/// How much of the chance is spread over all places alike: nobody is so tidy that a
/// thing could not be anywhere, and no place is ever ruled out by habit alone.
const ANYWHERE: f64 = 0.25;

/// What is supposed about the places of things that have not been seen.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub enum Prior {
    /// Every place is equally likely, as in the thesis.
    Uniform,
    /// Things are where people keep them, by the `kept` column of the scene's class
    /// table; a quarter of the chance is spread evenly.
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
    /// The weights of places for a thing, each above zero; they sum to one.
    pub(crate) fn weights(&self, graph: &SceneGraph, id: NodeId, places: &[Place]) -> Vec<f64> {
        let even = 1.0 / places.len().max(1) as f64;
        let raw: Vec<f64> = match self {
            Self::Uniform => Vec::new(),
            Self::Kept => kept(graph, id, places),
            Self::Habits(habits) => by_habits(habits, graph, id, places),
        };
        let sum: f64 = raw.iter().sum();
        if sum <= 0.0 {
            return vec![even; places.len()];
        }
        raw.iter().map(|w| ANYWHERE * even + (1.0 - ANYWHERE) * w / sum).collect()
    }
}

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
