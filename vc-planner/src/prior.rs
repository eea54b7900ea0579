//! Prior probabilities of the places of things.

mod kinds;
mod related_classes;
mod stray;
mod tidiness;
mod weights;

use std::sync::Arc;

use vc_graph::{NodeId, Relation, SceneGraph};

pub(crate) use kinds::Kinds;
use related_classes::RelatedClasses;
#[cfg(test)]
pub(crate) use tidiness::{CAUTION, HYPOTHESES, chance};
pub(crate) use tidiness::{Supposed, Tidiness};
pub(crate) use weights::{HABIT, Likely, STRAY, Weights};

/// The prior over the places of things that have not been seen.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub enum Prior {
    /// Every place is equally likely, as in the thesis.
    Uniform,
    /// Things are where people keep them, by the `kept` column of the scene's class table, or anywhere else.
    /// The fraction that is where people keep it is learned from the places of found things.
    #[default]
    Kept,
    /// As [`Prior::Kept`], with custom habits.
    Habits(Arc<[Habit]>),
}

/// The habit of keeping things of a class at a place. Among the things that are at their habitual places, a
/// place with weight `w` holds `w` times as many as a place with weight 1.
///
/// Things that are not at a habitual place are near one or anywhere, so no probability is zero: the weights add
/// to that.
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
/// let belief = Belief::with_prior(&scene.build(), me, 0, Prior::Habits(habits.into()));
/// let chance = |relation, at| belief.probability(mug, Place { relation, at });
/// let astray = chance(Relation::On, table);
/// let (often, seldom) = (chance(Relation::Inside, cupboard), chance(Relation::On, counter));
/// assert!(often > seldom && seldom > astray && astray > 0.0);
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Habit {
    /// Class of the thing, such as `mug`; its subclasses are included.
    pub class: String,
    /// Class of the room; any room if `None`.
    pub room: Option<String>,
    /// On or inside.
    pub relation: Relation,
    /// Class of the support or container.
    pub at: String,
    /// Relative weight.
    pub weight: f64,
}

impl Prior {
    /// The weights of places for a thing; `None` if all places are equally likely.
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

/// A habit in the form used for queries.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    room: Option<Arc<str>>,
    /// `None` means on the floor.
    at: Option<(Relation, Arc<str>)>,
    weight: f64,
}

/// The habits in the class table.
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
