//! The reasons why a goal cannot make sense in a scene.

mod contradiction;
mod demand;
mod find;
mod size;

use std::fmt;

use vc_graph::goal::DerivedPredicate;
use vc_graph::{NameMismatch, Relation, State, did_you_mean};

pub(crate) use find::{lost, obstacles};
pub(crate) use size::too_large;

/// A reason why a goal cannot be reached in a scene by any agent.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Obstacle {
    /// The scene has too few objects of a class.
    TooFew {
        /// The part of the goal.
        part: String,
        /// The class.
        class: String,
        /// The number of objects needed.
        needs: usize,
        /// The number of objects in the scene.
        has: usize,
        /// Classes of the scene that may have been meant, if the class table does not know the class.
        nearest: Vec<String>,
        /// If the scene has none, a class of which it is a kind and of which the scene has objects, and their number.
        wider: Option<BroaderClass>,
    },
    /// Neither the class table nor the scene knows the class.
    UnknownClass {
        /// The name, which no class has.
        class: String,
        /// Classes that may have been meant.
        nearest: Vec<String>,
    },
    /// The scene has objects of the class, but too few with the affordance that is asked for.
    NotAfforded {
        /// The part of the goal.
        part: String,
        /// The class.
        class: String,
        /// The affordance that they lack.
        must_be: &'static str,
    },
    /// Too few things are in the state that is asked for, and neither an action nor a process brings others into it.
    NoAction {
        /// The part of the goal.
        part: String,
        /// The class or label.
        thing: String,
        /// The state.
        state: State,
    },
    /// The vocabulary of the scene does not define a predicate of the goal.
    NoDefinition(DerivedPredicate),
    /// A label of the goal is of another class than its node.
    NameMismatch(NameMismatch),
    /// The scene has no node of a number that the goal names.
    NoSuchNode(String),
    /// A part ranges over so many choices of objects that nobody would wait for its evaluation.
    TooManyChoices {
        /// The part of the goal.
        part: String,
        /// The number of choices.
        choices: f64,
    },
    /// Two parts never hold at the same time: one is the negation of the other, or they ask for states of one thing that
    /// exclude each other.
    Contradiction {
        /// A part of the goal.
        part: String,
        /// The other part.
        other: String,
    },
    /// An agent is to hold more at once than it has hands.
    TooManyHeld {
        /// The parts of the goal that say so.
        parts: String,
        /// The number of objects to be held, at least.
        held: usize,
    },
}

/// A class that another one is a kind of, and of which a scene has objects.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BroaderClass {
    /// The class.
    pub class: String,
    /// The name in the class table of the one that is a kind of it: of `lamp` that is `table_lamp`.
    pub of: String,
    /// The number of objects in the scene.
    pub has: usize,
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { part, class, needs, has, nearest, wider } => {
                let near = did_you_mean(class, nearest.iter().map(String::as_str));
                write!(f, "`{part}` needs {needs} of `{class}`{near}, the scene has {has}")?;
                wider.as_ref().map_or(Ok(()), |BroaderClass { class, of, has }| {
                    write!(f, "; it has {has} of `{class}`, of which `{of}` is a kind")
                })
            }
            Self::UnknownClass { class, nearest } => {
                write!(f, "there is no class `{class}`{}", did_you_mean(class, nearest.iter().map(String::as_str)))
            }
            Self::NotAfforded { part, class, must_be } => {
                write!(f, "`{part}` needs `{class}` to be {must_be}, which it is not in this scene")
            }
            Self::NoAction { part, thing, state } => {
                write!(
                    f,
                    "`{part}` needs `{thing}` to be {state}, which it is not here, and no action or process makes it so"
                )
            }
            Self::NoDefinition(predicate) => {
                let name = predicate.as_str();
                write!(
                    f,
                    "the vocabulary of this scene does not define the predicate `{name}`: declare it there, or define it in a goal of your own"
                )
            }
            Self::NameMismatch(mismatch) => mismatch.fmt(f),
            Self::NoSuchNode(label) => write!(f, "there is no `{label}` in this scene"),
            Self::TooManyChoices { part, choices } => {
                write!(
                    f,
                    "`{part}` ranges over {choices:.0e} choices of objects; let its variables range over smaller classes"
                )
            }
            Self::Contradiction { part, other } => write!(f, "`{part}` and `{other}` never hold at the same time"),
            Self::TooManyHeld { parts, held } => {
                write!(f, "`{parts}` needs {held} things to be held at once, and an agent has {HANDS} hands")
            }
        }
    }
}

/// The number of things that an agent can hold at once.
const HANDS: usize = Relation::hands().len();

/// The reason why a goal is lost while an attempt goes on: no action from now on makes it hold.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::{Lost, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut progress = Task::new("eat", "always Dirty(apple)".parse()?).begin(&world, me);
/// assert!(matches!(progress.lost(&world), Some(Lost::Broken(part)) if part == "always Dirty(apple)"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Lost {
    /// The goal cannot be judged in this scene: names in it stand for nothing, a predicate is not defined, it ranges over
    /// too many objects, or two parts of it never hold together. See [`Task::lost`](crate::Task::lost).
    #[error("{}", .0.iter().map(Obstacle::to_string).collect::<Vec<_>>().join("; "))]
    Meaningless(Vec<Obstacle>),
    /// A part of it with words of time has been broken.
    #[error("`{0}` does not hold any more, and nothing that is done can change that")]
    Broken(String),
}
