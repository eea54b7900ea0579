//! Goals: conditions that an agent should bring about.
//!
//! ```
//! use vc_graph::Goal;
//! let goal: Goal = "On(apple, kitchentable), 3 & Closed(fridge)".parse()?;
//! assert_eq!(goal.to_string(), "On(apple, kitchentable), 3 & Closed(fridge)");
//! let goal: Goal = "forall ?p: plate. (Inside(?p, dishwasher) | Clean(?p))".parse()?;
//! let goal: Goal = "pairs ?p: plate, ?c: chair. Near(?p, ?c)".parse()?;
//! let goal: Goal = "Holds(cup) until On(cup, table) & always !Broken(cup)".parse()?;
//! # Ok::<(), vc_graph::goal::GoalError>(())
//! ```
//!
//! A literal is a predicate with terms. A term is a class in any usual spelling (`coffee_table`: some node of
//! it or of its descendants), a node (`cup.12` or `#12`), `me` (the agent), a variable (`?x`) or `_`
//! (anything). A class whose name is not a plain word is written in quotes: `"apple.n.01"`, `"apple.n.01".12`,
//! `?"a b"`.
//!
//! | predicate | holds when |
//! |---|---|
//! | `Open` `Closed` `SwitchedOn` `On(x)` `Clean` `Dirty` `Cooked` ... | the object is in that [state](crate::State) |
//! | `On(x, y)` | x rests on y, or sits or lies on it, or is worn by it |
//! | `Inside(x, y)`, `In` | x is inside y, directly or on or in something inside it, or in room y |
//! | `Covered(x, y)` `Filled(x, y)` `Attached(x, y)` ... | x stands in that [relation](crate::Relation) to y |
//! | `Near(x)`, `Walk(x)` | the agent is near x, or in room x |
//! | `Holds(x)`, `Grab(x)`, `HoldsRight`, `HoldsLeft` | the agent holds x |
//! | `Sit(x)` `Lie(x)` `Wear(x)` `Facing(x)` | the agent sits or lies on, wears, faces x |
//! | `Eat(x)` `Drink(x)` `Watch(x)` `did verb(x, y)` | the agent has performed this action |
//! | `Real(x)` | x exists: it is not in the state `future` |
//! | an own name, `Tidy(x)` | its definition holds, see [`Vocabulary::parse`](crate::Vocabulary::parse) |
//! | `?x = ?y`, `?x != ?y` | both are the same object, or are not; for variables, nodes and `me` |
//!
//! `, 3` after a literal requires at least three different objects for its first term that is a class or `_`
//! (`, = 3` and `, <= 3` require exactly and at most three).
//!
//! | form | holds when |
//! |---|---|
//! | `!a`, `a & b`, `a \| b`, `a => b` | as `not`, `and`, `or`, `imply`, which may be written instead |
//! | `forall ?x: c. a`, `exists ?x: c. a` | a holds for every, for some object of class c; `: c` may be left out |
//! | `exactly 2 ?x: c. a`, `at least`, `at most` | a holds for that number of objects |
//! | `pairs ?x: c, ?y: d. a` | objects can be paired, one x with one y, until one of the classes is used up |
//! | `at least 2 pairs ?x: c, ?y: d. a` | that number of disjoint pairs can be formed |
//! | `marginal pairs ...` | that number of x have a y, and that number of y have an x ([`Pairing::Marginal`]) |
//! | `eventually a`, `always a` | a holds at some step, at all steps from here to the end |
//! | `within 5 steps a` | a holds at some step, at most five from here |
//! | `at end a` | a holds at the end, evaluated as if it stood alone |
//! | `a until b` | b holds at some step, and a at all steps before |
//! | `a before b` | a holds at some step, and b at no step up to it |
//! | `a then b` | the steps can be cut into stretches such that each part holds on its stretch |
//!
//! `!` and the words before a single part bind tightest; then `&`, `|`, `=>`, `until` and `before`, `then`.
//! Quantifiers extend as far as possible.
//!
//! # Time
//!
//! An [`EpisodeTrace`] records an episode: a state for each step, and the actions in it. [`Goal::holds_on`] evaluates a
//! goal on it by linear temporal logic on finite traces (De Giacomo and Vardi, IJCAI 2013), with one
//! convention, by which a goal without temporal operators is about the end: a part outside all temporal
//! operators is evaluated in the last state and with all actions; a part inside one is evaluated at single
//! steps, in the state after the step and with the actions of that step. Temporal operators inside temporal
//! operators range from their step to the end. `then` cuts the remaining trace into stretches, each as short as
//! possible and the last one up to the end; each part is evaluated as a goal on its stretch.
//!
//! The state before the first action is a step of the trace, too: `Holds(cup) until On(cup, table)` asks for a cup that
//! is held from the start, and fails at once if none is.
//!
//! ```
//! use vc_graph::goal::EpisodeTrace;
//! use vc_graph::{Draft, Goal, SceneBuilder};
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let cup = scene.add_in(kitchen, Draft::new("cup"))?;
//! let me = scene.add_in(kitchen, Draft::new("character"))?;
//! let start = scene.build();
//! let mut held = start.clone();
//! let mut edit = held.edit();
//! edit.hold(me, cup)?;
//! edit.commit();
//! let mut trace = EpisodeTrace::new(start, me);
//! trace.push(held, []);
//! let goal: Goal = "Holds(cup) until Dirty(cup)".parse()?;
//! assert!(!goal.holds_on(&trace)); // at the start the cup is neither held nor dirty
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Goal::holds`] evaluates a goal in one [`Situation`], which has a single state: earlier steps are those of
//! its events, and their states are assumed to equal the present one.

mod definition;
mod derived;
pub mod eai;
mod evaluate;
mod expand;
mod judge;
mod literal;
mod names;
mod pairing;
mod read_literals;
mod read_parts;
mod replace;
mod scan;
mod score;
mod text;
mod trace;
mod write;

pub use definition::PredicateDefinition;
pub use derived::DerivedPredicate;
pub use evaluate::{BoundObjects, Situation};
pub use literal::{Comparison, Literal, Predicate, Term};
pub(crate) use names::is_predicate;
pub use pairing::{Pairing, Pairs, Variable, largest_matching};
pub use text::{GoalError, GoalProblem};
pub use trace::EpisodeTrace;

use crate::{NameMismatch, SceneGraph};

/// A goal.
///
/// ```
/// use vc_graph::Goal;
/// let goal: Goal = "On(apple, table) & Closed(fridge)".parse()?;
/// assert!(matches!(&goal, Goal::And(parts) if parts.len() == 2));
/// assert_eq!(goal.to_string().parse::<Goal>()?, goal);
/// # Ok::<(), vc_graph::goal::GoalError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Goal {
    /// At least one choice of objects satisfies the literal.
    Literal(Literal),
    /// A number of different objects satisfy the literal.
    Count {
        /// The literal.
        literal: Literal,
        /// At least, exactly or at most.
        comparison: Comparison,
        /// The number.
        number: u32,
    },
    /// Both are the same object: variables, nodes or the agent.
    Same(Term, Term),
    /// All parts hold.
    And(Vec<Goal>),
    /// Some part holds.
    Or(Vec<Goal>),
    /// The part does not hold.
    Not(Box<Goal>),
    /// The second holds if the first does.
    Imply(Box<Goal>, Box<Goal>),
    /// The part holds for every object of a class.
    ForAll(Quantified),
    /// The part holds for some object of a class.
    Exists(Quantified),
    /// The part holds for a number of objects of a class.
    ForN {
        /// At least, exactly or at most.
        comparison: Comparison,
        /// The number.
        number: u32,
        /// The variable and the part.
        of: Quantified,
    },
    /// Objects of two classes can be paired.
    ForPairs(Pairs),
    /// The steps can be cut into stretches such that each part holds on its stretch: the parts were achieved in
    /// this order.
    Then(Vec<Goal>),
    /// The part holds at some step.
    Eventually(Box<Goal>),
    /// The part holds at all steps.
    Always(Box<Goal>),
    /// The part holds at some step, at most that many from here.
    Within(u32, Box<Goal>),
    /// The part holds at the end, as a goal of its own.
    AtEnd(Box<Goal>),
    /// The second holds at some step, and the first at all steps before it.
    Until(Box<Goal>, Box<Goal>),
    /// The first holds at some step, and up to that step the second does not.
    Before(Box<Goal>, Box<Goal>),
}

/// A variable and the goal that contains it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Quantified {
    /// The variable's name, without `?`.
    pub variable: String,
    /// The class that it ranges over; `None` for all objects.
    pub class: Option<String>,
    /// The goal in which the variable occurs.
    pub body: Box<Goal>,
}

impl Goal {
    /// A literal with given terms.
    pub fn literal(predicate: Predicate, terms: Vec<Term>) -> Self {
        Self::Literal(Literal { predicate, terms })
    }

    /// The direct parts of this goal.
    pub fn parts(&self) -> Vec<&Goal> {
        match self {
            Self::Literal(_) | Self::Count { .. } | Self::Same(..) => Vec::new(),
            Self::And(parts) | Self::Or(parts) | Self::Then(parts) => parts.iter().collect(),
            Self::Not(part) | Self::Eventually(part) | Self::Always(part) => vec![part],
            Self::Within(_, part) | Self::AtEnd(part) => vec![part],
            Self::Imply(a, b) | Self::Until(a, b) | Self::Before(a, b) => vec![a, b],
            Self::ForAll(q) | Self::Exists(q) | Self::ForN { of: q, .. } => vec![&q.body],
            Self::ForPairs(pairs) => vec![&pairs.body],
        }
    }

    /// The nesting depth; 1 for a literal.
    pub fn depth(&self) -> usize {
        1 + self.parts().into_iter().map(Self::depth).max().unwrap_or(0)
    }

    /// The terms in the goal: those of its literals, and the classes that its variables range over.
    pub fn terms(&self) -> Vec<Term> {
        let mut terms: Vec<Term> = self.parts().into_iter().flat_map(Self::terms).collect();
        match self {
            Self::Literal(literal) | Self::Count { literal, .. } => terms.extend(literal.terms.iter().cloned()),
            Self::Same(a, b) => terms.extend([a.clone(), b.clone()]),
            Self::ForAll(q) | Self::Exists(q) | Self::ForN { of: q, .. } => {
                terms.extend(q.class.clone().map(Term::Class));
            }
            Self::ForPairs(pairs) => {
                terms
                    .extend([&pairs.first, &pairs.second].into_iter().filter_map(|v| v.class.clone().map(Term::Class)));
            }
            _ => {}
        }
        terms
    }

    /// The labels in the goal whose class is not that of their node, each once: `fridge.6`, where 6 is a glass.
    ///
    /// ```
    /// use vc_graph::{Draft, Goal, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let glass = scene.add(Draft::new("water_glass"))?;
    /// let goal: Goal = format!("Holds(fridge.{}) | Holds(glass.{})", glass.0, glass.0).parse()?;
    /// let wrong: Vec<String> = goal.name_mismatches(&scene.build()).iter().map(|m| m.written.to_string()).collect();
    /// assert_eq!(wrong, ["fridge.1"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn name_mismatches(&self, graph: &SceneGraph) -> Vec<NameMismatch> {
        let mut found: Vec<NameMismatch> = Vec::new();
        for term in self.terms() {
            let Term::Node(Some(class), id) = term else { continue };
            found.extend(graph.check_name(&class, id).err().filter(|mismatch| !found.contains(mismatch)));
        }
        found
    }

    /// Whether the goal concerns more than one step: it has a temporal operator.
    ///
    /// ```
    /// use vc_graph::Goal;
    /// assert!("always Closed(fridge)".parse::<Goal>()?.is_temporal());
    /// assert!(!"Closed(fridge)".parse::<Goal>()?.is_temporal());
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    pub fn is_temporal(&self) -> bool {
        let here = matches!(
            self,
            Self::Then(_)
                | Self::Eventually(_)
                | Self::Always(_)
                | Self::Within(..)
                | Self::AtEnd(_)
                | Self::Until(..)
                | Self::Before(..)
        );
        here || self.parts().into_iter().any(Self::is_temporal)
    }

    /// The parts of a conjunction, or the goal itself.
    ///
    /// ```
    /// use vc_graph::Goal;
    /// let goal: Goal = "On(apple, table) & Closed(fridge)".parse()?;
    /// let parts: Vec<String> = goal.conjuncts().iter().map(Goal::to_string).collect();
    /// assert_eq!(parts, ["On(apple, table)", "Closed(fridge)"]);
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    pub fn conjuncts(&self) -> &[Goal] {
        match self {
            Self::And(parts) => parts,
            other => std::slice::from_ref(other),
        }
    }
}

impl serde::Serialize for Goal {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Goal {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
