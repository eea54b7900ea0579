//! Tasks of ALFRED: one of seven types, and its parameters.
//!
//! ```
//! use vc_tasks::format::alfred::Template;
//! let text = r#"{"task_type": "pick_cool_then_place_in_recep", "pddl_params": {
//!     "object_target": "Tomato", "parent_target": "CounterTop", "object_sliced": true,
//!     "mrecep_target": "", "toggle_target": ""}}"#;
//! let task = Template::read(text)?;
//! assert_eq!(task.to_goal().to_string(), "exists ?r: CounterTop. exists ?o: Tomato. \
//!     (On(?o, ?r) | Inside(?o, ?r)) & Cold(?o) & Sliced(?o)");
//! assert_eq!(Template::from_goal(&task.to_goal())?, task);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Trajectory files of ALFRED can be read as they are: other keys are ignored.

use serde::{Deserialize, Serialize};
use vc_graph::goal::{Comparison, Goal, Predicate, Quantified, Term};
use vc_graph::{Relation, State};

use super::error::from_json;
use super::{ReadError, Unwritable};

const FORMAT: &str = "ALFRED task";

/// The type of a task.
///
/// ```
/// use vc_tasks::format::alfred::{TaskType, Template};
/// let text = r#"{"task_type": "pick_clean_then_place_in_recep",
///     "pddl_params": {"object_target": "Cup", "parent_target": "Shelf"}}"#;
/// assert_eq!(Template::read(text)?.task_type, TaskType::Clean);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[non_exhaustive]
pub enum TaskType {
    /// Look at an object in the light of a lamp.
    #[serde(rename = "look_at_obj_in_light")]
    LookInLight,
    /// Put an object somewhere.
    #[serde(rename = "pick_and_place_simple")]
    Place,
    /// Put two objects of one class into the same place.
    #[serde(rename = "pick_two_obj_and_place")]
    PlaceTwo,
    /// Put an object into a vessel and the vessel somewhere.
    #[serde(rename = "pick_and_place_with_movable_recep")]
    PlaceWithVessel,
    /// Put a clean object somewhere.
    #[serde(rename = "pick_clean_then_place_in_recep")]
    Clean,
    /// Put a hot object somewhere.
    #[serde(rename = "pick_heat_then_place_in_recep")]
    Heat,
    /// Put a cold object somewhere.
    #[serde(rename = "pick_cool_then_place_in_recep")]
    Cool,
}

impl TaskType {
    /// All seven types.
    pub const ALL: [Self; 7] =
        [Self::LookInLight, Self::Place, Self::PlaceTwo, Self::PlaceWithVessel, Self::Clean, Self::Heat, Self::Cool];
}

/// A task: its type and its parameters.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Template {
    /// The type.
    pub task_type: TaskType,
    /// The parameters.
    #[serde(rename = "pddl_params")]
    pub about: Parameters,
}

/// The classes of a task, empty where its type takes none.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(default)]
pub struct Parameters {
    /// The object.
    #[serde(rename = "object_target")]
    pub object: String,
    /// Whether it is to be sliced.
    #[serde(rename = "object_sliced")]
    pub sliced: bool,
    /// The vessel that the object is to be put into.
    #[serde(rename = "mrecep_target")]
    pub vessel: String,
    /// The receptacle it is to be put in or on.
    #[serde(rename = "parent_target")]
    pub receptacle: String,
    /// The lamp.
    #[serde(rename = "toggle_target")]
    pub lamp: String,
}

impl Template {
    /// Reads a task, or the task of a trajectory file.
    ///
    /// # Errors
    /// [`ReadError`] if the text is not such JSON, or lacks classes that its type needs.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        let task: Self = from_json(FORMAT, text)?;
        let missing = task.takes().into_iter().find(|(_, class)| class.is_empty());
        missing.map_or(Ok(task.clone()), |(name, _)| {
            let at = text.find("pddl_params").unwrap_or(0);
            Err(ReadError::at(FORMAT, text, at, format!("a class for `{name}`"), "none"))
        })
    }

    /// Writes it as JSON.
    pub fn write(&self) -> String {
        // Serialising strings and one flag cannot fail.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// The classes that its type needs.
    fn takes(&self) -> Vec<(&'static str, &str)> {
        let about = &self.about;
        let object = ("object_target", about.object.as_str());
        let receptacle = ("parent_target", about.receptacle.as_str());
        match self.task_type {
            TaskType::LookInLight => vec![object, ("toggle_target", &about.lamp)],
            TaskType::PlaceWithVessel => vec![object, ("mrecep_target", &about.vessel), receptacle],
            _ => vec![object, receptacle],
        }
    }

    /// The goal. An object is in a receptacle if it is on it or inside it; it is hot, cold or clean
    /// if it is so at the end.
    pub fn to_goal(&self) -> Goal {
        let about = &self.about;
        let sliced = about.sliced.then(|| state(State::Sliced, "o"));
        let placed = |with: Option<State>| {
            let kept = with.map(|s| state(s, "o"));
            all([Some(within("o", "r")), kept, sliced.clone()])
        };
        match self.task_type {
            TaskType::LookInLight => {
                let near = Goal::literal(Predicate::Relation(Relation::Near), vec![Term::Me, variable("l")]);
                let held = Goal::literal(Predicate::Holds, vec![Term::Me, variable("o")]);
                let body = all([Some(held), Some(state(State::On, "l")), Some(near), sliced]);
                exists("l", &about.lamp, exists("o", &about.object, body))
            }
            TaskType::Place => exists("r", &about.receptacle, exists("o", &about.object, placed(None))),
            TaskType::Clean => exists("r", &about.receptacle, exists("o", &about.object, placed(Some(State::Clean)))),
            TaskType::Heat => exists("r", &about.receptacle, exists("o", &about.object, placed(Some(State::Hot)))),
            TaskType::Cool => exists("r", &about.receptacle, exists("o", &about.object, placed(Some(State::Cold)))),
            TaskType::PlaceTwo => {
                let of = quantified("o", &about.object, placed(None));
                exists("r", &about.receptacle, Goal::ForN { comparison: Comparison::AtLeast, number: 2, of })
            }
            TaskType::PlaceWithVessel => {
                let body = all([Some(within("o", "v")), Some(within("v", "r")), sliced]);
                let vessel = exists("v", &about.vessel, exists("o", &about.object, body));
                exists("r", &about.receptacle, vessel)
            }
        }
    }

    /// Finds the task whose goal this is.
    ///
    /// # Errors
    /// [`Unwritable`] if it is not a goal of ALFRED.
    pub fn from_goal(goal: &Goal) -> Result<Self, Unwritable> {
        let classes = classes(goal);
        let class = |i: usize| classes.get(i).copied().unwrap_or_default().to_owned();
        for task_type in TaskType::ALL {
            for sliced in [false, true] {
                let about = match task_type {
                    TaskType::LookInLight => Parameters { lamp: class(0), object: class(1), ..Parameters::default() },
                    TaskType::PlaceWithVessel => {
                        let [receptacle, vessel, object] = [0, 1, 2].map(class);
                        Parameters { receptacle, vessel, object, ..Parameters::default() }
                    }
                    _ => Parameters { receptacle: class(0), object: class(1), ..Parameters::default() },
                };
                let task = Self { task_type, about: Parameters { sliced, ..about } };
                if task.to_goal() == *goal {
                    return Ok(task);
                }
            }
        }
        Err(Unwritable::new(FORMAT, goal, "it is none of the seven types"))
    }
}

/// The classes of the quantifiers, outermost first.
fn classes(mut goal: &Goal) -> Vec<&str> {
    let mut found = Vec::new();
    while let Goal::Exists(q) | Goal::ForN { of: q, .. } = goal {
        found.extend(q.class.as_deref());
        goal = &q.body;
    }
    found
}

fn variable(name: &str) -> Term {
    Term::Variable(name.to_owned())
}

fn state(state: State, name: &str) -> Goal {
    Goal::literal(Predicate::State(state), vec![variable(name)])
}

/// On it or inside it.
fn within(a: &str, b: &str) -> Goal {
    let how = |relation| Goal::literal(Predicate::Relation(relation), vec![variable(a), variable(b)]);
    Goal::Or(vec![how(Relation::On), how(Relation::Inside)])
}

fn all<const N: usize>(parts: [Option<Goal>; N]) -> Goal {
    let mut parts: Vec<Goal> = parts.into_iter().flatten().collect();
    if parts.len() == 1 { parts.remove(0) } else { Goal::And(parts) }
}

fn quantified(name: &str, class: &str, body: Goal) -> Quantified {
    Quantified { variable: name.to_owned(), class: Some(class.to_owned()), body: Box::new(body) }
}

fn exists(name: &str, class: &str, body: Goal) -> Goal {
    Goal::Exists(quantified(name, class, body))
}
