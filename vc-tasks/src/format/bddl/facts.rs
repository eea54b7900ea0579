//! The ground facts an activity's goal is about.

use std::collections::{HashMap, HashSet};

use vc_graph::NodeId;
use vc_graph::goal::{Literal, Pairing, Term};

use super::Activity;
use super::predicate::word;
use crate::format::ReadError;
use crate::ground::{self, Formula, Things};

/// The declared objects by class.
pub(crate) struct Universe<'t>(HashMap<&'t str, Vec<NodeId>>);

impl<'t> Universe<'t> {
    pub(crate) fn of(activity: &'t Activity) -> Self {
        let mut classes: HashMap<&str, Vec<NodeId>> = HashMap::new();
        let mut seen = HashSet::new();
        for (object, id) in activity.objects().zip(1..) {
            if seen.insert(object.name) {
                classes.entry(object.class).or_default().push(NodeId(id));
            }
        }
        Self(classes)
    }
}

impl Things for Universe<'_> {
    fn of_class(&self, class: Option<&str>) -> Option<Vec<NodeId>> {
        Some(match class {
            Some(class) => self.0.get(class).cloned().unwrap_or_default(),
            None => {
                let mut all: Vec<NodeId> = self.0.values().flatten().copied().collect();
                all.sort_unstable();
                all
            }
        })
    }
}

/// An activity's goal over the ground facts that matter for it: judges any set of
/// facts, whether a scene could be so or not.
///
/// ```
/// use vc_graph::goal::Pairing;
/// use vc_tasks::format::bddl::{Activity, Facts};
/// let text = "(define (problem p) (:objects a b - cup t - table)
///     (:goal (and (ontop ?a ?t) (forall (?c - cup) (not (broken ?c))))))";
/// let facts = Facts::of(&Activity::read(text)?, Pairing::Matching)?;
/// assert_eq!(facts.names(), ["ontop a t", "broken a", "broken b"]);
/// assert_eq!(facts.heads(|fact| fact == 0), [true, true]);
/// assert_eq!(facts.heads(|fact| fact == 2), [false, false]);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
#[derive(Debug)]
pub struct Facts {
    formula: Formula,
    names: Vec<String>,
    index: HashMap<Literal, usize>,
}

impl Facts {
    /// The facts of an activity's goal; pairs are judged as asked. That something is
    /// real stands as the fact that it is not in the future.
    ///
    /// # Errors
    /// [`ReadError`] for a predicate or an object that is not known, and for a goal
    /// of more than 100,000 parts.
    pub fn of(activity: &Activity, pairing: Pairing) -> Result<Self, ReadError> {
        let heads = activity.to_heads(pairing)?;
        let formula = ground::formula(&heads, &Universe::of(activity));
        let formula = formula.ok_or_else(|| activity.goal().error("a goal of at most 100,000 parts"))?;
        let objects: Vec<&str> = activity.objects().map(|o| o.name).collect();
        let named = |literal: &Literal| {
            let things = literal.terms.iter().filter_map(|t| match t {
                Term::Node(_, id) => objects.get((id.0 as usize).checked_sub(1)?).copied(),
                _ => None,
            });
            let words: Vec<&str> = word(literal.predicate).into_iter().chain(things).collect();
            words.join(" ")
        };
        let names = formula.atoms().map(|(_, literal)| named(literal)).collect();
        let index = formula.atoms().enumerate().map(|(i, (_, literal))| (literal.clone(), i)).collect();
        Ok(Self { formula, names, index })
    }

    /// The facts, `ontop a t`, in the order in which the goal speaks of them.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Which parts of the goal are met when these facts hold.
    pub fn heads(&self, holds: impl Fn(usize) -> bool) -> Vec<bool> {
        self.formula.heads(|literal| self.index.get(literal).is_some_and(|&i| holds(i)))
    }
}
