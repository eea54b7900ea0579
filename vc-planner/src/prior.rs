//! Where things are likely to be before anything has been seen.

mod kin;
mod kinds;
mod stray;
mod tidiness;
mod weights;

use std::sync::Arc;

use vc_graph::{NodeId, Relation, SceneGraph};

use kin::Kin;
pub(crate) use kinds::Kinds;
#[cfg(test)]
pub(crate) use tidiness::{CAUTION, HYPOTHESES, chance};
pub(crate) use tidiness::{Supposed, Tidiness};
pub(crate) use weights::{HABIT, Likely, STRAY, Weights};

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

/// That people keep things of a class at a place: of those that are where habit puts them so many times as many
/// as at one with weight 1.
///
/// Things that are not where habit puts them are somewhere near it or anywhere, so no chance is
/// zero: the weights say how much is added to that.
///
/// ```
/// use vc_graph::{Draft, Place, Relation, SceneBuilder};
/// use vc_planner::{Belief, Habit, Prior};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let [cupboard, counter, table] = ["kitchen_cabinet", "kitchen_counter", "kitchen_table"];
/// let cupboard = scene.add_in(kitchen, Draft::new(cupboard))?;
/// let counter = scene.add_in(kitchen, Draft::new(counter))?;
/// let table = scene.add_in(kitchen, Draft::new(table))?;
/// let mug = scene.add_in(cupboard, Draft::new("mug"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
///
/// let habit = |relation, at: &str, weight| Habit {
///     class: "mug".into(),
///     room: Some("kitchen".into()),
///     relation,
///     at: at.into(),
///     weight,
/// };
/// let habits = [habit(Relation::Inside, "kitchen_cabinet", 3.0), habit(Relation::On, "kitchen_counter", 1.0)];
/// let belief = Belief::by_prior(&scene.build(), me, 0, Prior::Habits(habits.into()));
/// let chance = |relation, at| belief.probability(mug, Place { relation, at });
/// let astray = chance(Relation::On, table);
/// let (often, seldom) = (chance(Relation::Inside, cupboard), chance(Relation::On, counter));
/// assert!(often > seldom && seldom > astray && astray > 0.0);
/// # Ok::<(), vc_graph::EditError>(())
/// ```
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
    /// The weights of places for a thing; `None` where all places are alike.
    pub(crate) fn weights(&self, graph: &SceneGraph, id: NodeId, kinds: &Kinds) -> Option<Weights> {
        let rows = match self {
            Self::Uniform => return None,
            Self::Kept => kept(graph, id),
            Self::Habits(habits) => by_habits(habits, graph, id),
        };
        let mut weights = Weights::new(rows);
        weights.meet(graph, id, kinds);
        weights.is_habitual().then_some(weights)
    }
}

/// A habit as it is asked for.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    room: Option<Arc<str>>,
    /// `None`: on the floor.
    at: Option<(Relation, Arc<str>)>,
    weight: f64,
}

/// By the class table.
fn kept(graph: &SceneGraph, id: NodeId) -> Vec<Row> {
    let Some(own) = graph.node(id).and_then(|n| graph.classes().get(n.class())) else { return Vec::new() };
    let rows = own.kept.iter().map(|habit| Row {
        room: habit.room.clone(),
        at: habit.at.clone(),
        weight: f64::from(habit.weight),
    });
    rows.collect()
}

fn by_habits(habits: &[Habit], graph: &SceneGraph, id: NodeId) -> Vec<Row> {
    let Some(node) = graph.node(id) else { return Vec::new() };
    let own = |h: &&Habit| h.weight > 0.0 && graph.classes().is_a(node.class(), &h.class);
    let row = |h: &Habit| Row {
        room: h.room.as_deref().map(Into::into),
        at: Some((h.relation, h.at.as_str().into())),
        weight: h.weight,
    };
    habits.iter().filter(own).map(row).collect()
}
