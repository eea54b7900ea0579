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
///
/// Things that are not where habit puts them may be anywhere, so no chance is zero: the
/// weights say how much is added to that.
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
/// assert!(((often - astray) / (seldom - astray) - 3.0).abs() < 1e-9);
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
    /// How likely each place is for a thing that is where habit puts it, and for one that
    /// is not but in a tidy home; both sum to one. `None` where habit says nothing.
    pub(crate) fn places(&self, graph: &SceneGraph, id: NodeId, places: &[Place]) -> Option<Likely> {
        let habits: Vec<Row<'_>> = match self {
            Self::Uniform => return None,
            Self::Kept => kept(graph, id),
            Self::Habits(habits) => by_habits(habits, graph, id),
        };
        let mut likely = vec![[0.0; 2]; places.len()];
        for row in &habits {
            let fitting: Vec<usize> = (0..places.len()).filter(|&i| row.fits(graph, &places[i])).collect();
            for &i in &fitting {
                likely[i][HABIT] += row.weight / fitting.len() as f64;
            }
        }
        for (likely, place) in likely.iter_mut().zip(places) {
            let home = habits.iter().any(|row| row.is_room(graph, place));
            likely[STRAY] = if home { 1.0 } else { FOREIGN };
        }
        let sums = likely.iter().fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y]);
        likely.iter_mut().for_each(|l| *l = [l[HABIT] / sums[HABIT], l[STRAY] / sums[STRAY]]);
        (sums[HABIT] > 0.0).then(|| likely.into())
    }
}

/// For each place the chance of what is where habit puts it, and of what is astray.
pub(crate) type Likely = Arc<[[f64; 2]]>;
pub(crate) const HABIT: usize = 0;
pub(crate) const STRAY: usize = 1;

/// How much less likely something is astray in a room where things like it are not kept
/// anywhere: a plate in a bathroom.
const FOREIGN: f64 = 0.2;

/// What is supposed about the things of one class that have not been found.
#[derive(Debug, Clone)]
pub(crate) struct Supposed {
    /// How likely each place is, if habit says anything.
    pub(crate) places: Option<Likely>,
    /// How much of that is left in places not seen.
    pub(crate) left: [f64; 2],
    /// How many of the class are missing.
    pub(crate) missing: usize,
}

impl Supposed {
    /// Expects nothing at a place any more.
    pub(crate) fn leave_out(&mut self, place: usize) {
        let [habit, stray] = self.places.as_ref().map_or([0.0; 2], |places| places[place]);
        self.left = [self.left[HABIT] - habit, self.left[STRAY] - stray];
    }
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
    pub(crate) fn found(&mut self, likely: [f64; 2], even: f64) {
        for (weight, (share, _)) in self.found.iter_mut().zip(SHARES) {
            *weight += (chance(share, likely, even) / even).ln();
        }
    }

    /// Weighs what is still missing, with the share of places not seen.
    pub(crate) fn settle<'a>(&mut self, classes: impl Iterator<Item = &'a Supposed>, unseen: f64) {
        let mut logs = self.found;
        for class in classes.filter(|c| c.places.is_some() && c.missing > 0) {
            for (log, (share, _)) in logs.iter_mut().zip(SHARES) {
                *log += class.missing as f64 * chance(share, class.left, unseen).max(LEAST).ln();
            }
        }
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let raw: [f64; SHARES.len()] = std::array::from_fn(|i| SHARES[i].1 * (logs[i] - most).exp());
        let sum: f64 = raw.iter().sum();
        self.chances = raw.map(|w| w / sum);
    }

    /// The chances of places for a class: so much for each, and so much for each unit of
    /// habit and of being astray.
    pub(crate) fn mix(&self, class: &Supposed, unseen: f64, even: f64) -> (f64, [f64; 2]) {
        if class.places.is_none() {
            return (even / unseen.max(LEAST), [0.0; 2]);
        }
        let mut mixed = (0.0, [0.0; 2]);
        for (weight, (share, _)) in self.chances.iter().zip(SHARES) {
            let part = weight / chance(share, class.left, unseen).max(LEAST);
            mixed.1[HABIT] += part * share;
            if share < TIDY {
                mixed.0 += part * (1.0 - share) * even;
            } else {
                mixed.1[STRAY] += part * (1.0 - share);
            }
        }
        mixed
    }
}

/// In homes where at least this share of the things is where habit puts them the others
/// are not far, either; else they can be anywhere.
const TIDY: f64 = 0.75;

/// The chance of a place where a share of the things is where habit puts them.
pub(crate) fn chance(share: f64, likely: [f64; 2], even: f64) -> f64 {
    share * likely[HABIT] + (1.0 - share) * if share < TIDY { even } else { likely[STRAY] }
}

/// Guards a logarithm and a division.
const LEAST: f64 = 1e-12;

fn class(graph: &SceneGraph, id: NodeId) -> &str {
    graph.node(id).map_or("", |n| n.class())
}

/// A habit as it is asked for.
struct Row<'a> {
    room: Option<&'a str>,
    /// `None`: on the floor.
    at: Option<(Relation, &'a str)>,
    weight: f64,
}

impl Row<'_> {
    fn is_room(&self, graph: &SceneGraph, place: &Place) -> bool {
        let room = graph.room_of(place.at).map_or("", |r| class(graph, r));
        self.room.is_none_or(|wanted| graph.classes().is_a(room, wanted))
    }

    fn fits(&self, graph: &SceneGraph, place: &Place) -> bool {
        self.is_room(graph, place)
            && match self.at {
                Some((relation, at)) => relation == place.relation && graph.classes().is_a(class(graph, place.at), at),
                None => is_open_floor(graph, place),
            }
    }
}

/// By the class table. The weight of a habit is shared by the places it fits.
fn kept(graph: &SceneGraph, id: NodeId) -> Vec<Row<'_>> {
    let Some(own) = graph.classes().get(class(graph, id)) else { return Vec::new() };
    let rows = own.kept.iter().map(|habit| Row {
        room: habit.room.as_deref(),
        at: habit.at.as_ref().map(|(relation, at)| (*relation, &**at)),
        weight: f64::from(habit.weight),
    });
    rows.collect()
}

fn by_habits<'a>(habits: &'a [Habit], graph: &SceneGraph, id: NodeId) -> Vec<Row<'a>> {
    let own = |h: &&Habit| h.weight > 0.0 && graph.classes().is_a(class(graph, id), &h.class);
    let row = |h: &'a Habit| Row { room: h.room.as_deref(), at: Some((h.relation, &h.at)), weight: h.weight };
    habits.iter().filter(own).map(row).collect()
}

fn is_open_floor(graph: &SceneGraph, place: &Place) -> bool {
    let node = graph.node(place.at);
    node.is_some_and(|n| n.kind() == Kind::Room || &**n.class() == "floor")
}
