//! The ground facts that an activity's goal depends on.

use std::collections::HashMap;

use vc_graph::NodeId;
use vc_graph::goal::{Literal, Pairing, Term};

use super::ActivityDefinition;
use super::predicate::word;
use crate::compile::{Bits, Compiler, GoalProgram, GroundAtom, Things};
use crate::format::ReadError;

/// The limit of a goal's parts, counted for every choice of objects: BEHAVIOR's largest goal has
/// some hundred.
const LARGEST: usize = 100_000;

/// The declared objects of an activity, over which goals range: the first declared object is node
/// 1, the next node 2.
#[derive(Debug, Clone)]
pub struct Objects<'t> {
    classes: HashMap<&'t str, Vec<NodeId>>,
    all: Vec<NodeId>,
}

impl<'t> Objects<'t> {
    /// The objects of an activity; one declared repeatedly is included once.
    pub fn new(activity: &'t ActivityDefinition) -> Self {
        let mut classes: HashMap<&str, Vec<NodeId>> = HashMap::new();
        let mut all = Vec::with_capacity(activity.objects.len());
        let mut seen = std::collections::HashSet::with_capacity(activity.objects.len());
        for (object, id) in activity.objects().zip(1..) {
            if seen.insert(object.name) {
                classes.entry(object.class).or_default().push(NodeId(id));
                all.push(NodeId(id));
            }
        }
        Self { classes, all }
    }
}

impl Things for Objects<'_> {
    fn each(&self, class: Option<&str>, things: &mut Vec<NodeId>) {
        match class {
            Some(class) => things.extend(self.classes.get(class).into_iter().flatten()),
            None => things.extend(&self.all),
        }
    }

    /// An activity does not name its agent.
    fn agent(&self) -> NodeId {
        NodeId(0)
    }

    fn has(&self, id: NodeId) -> bool {
        self.all.binary_search(&id).is_ok()
    }
}

/// An activity's goal over the ground facts that matter for it: it evaluates any set of facts,
/// whether or not a scene could be so. It is a [`GoalProgram`] whose heads are those of the activity,
/// and whose atoms have the activity's names.
///
/// ```
/// use vc_graph::goal::Pairing;
/// use vc_tasks::format::bddl::{ActivityDefinition, Facts};
/// let text = "(define (problem p) (:objects a b - cup t - table) (:init (broken b))
///     (:goal (and (ontop ?a ?t) (forall (?c - cup) (not (broken ?c))))))";
/// let activity = ActivityDefinition::read(text)?;
/// let facts = Facts::from_activity(&activity, Pairing::Matching)?;
/// assert_eq!(facts.names(), ["ontop a t", "broken a", "broken b"]);
/// assert_eq!(facts.heads(|fact| fact == 0), [true, true]);
/// assert_eq!(facts.heads(|fact| fact == 2), [false, false]);
/// let start = facts.start(&activity)?;
/// assert_eq!(facts.program().credit(&start).value(), 1.0 / 3.0);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
#[derive(Debug)]
pub struct Facts {
    program: GoalProgram,
    names: Vec<String>,
}

impl Facts {
    /// Compiles an activity's goal with the given pairing. That an object is real becomes the fact
    /// that it is not in the future.
    ///
    /// # Errors
    /// [`ReadError`] for an unknown predicate or object, and for a goal of more than 100,000 parts.
    pub fn from_activity(activity: &ActivityDefinition, pairing: Pairing) -> Result<Self, ReadError> {
        let heads = activity.to_heads(pairing)?;
        let program = Compiler::limited(LARGEST).compile_all(&heads, &Objects::new(activity));
        let program = program.map_err(|_| activity.goal().error("a goal of at most 100,000 parts"))?;
        let objects: Vec<&str> = activity.objects().map(|o| o.name).collect();
        let named = |atom: &GroundAtom| {
            let object = |id: &NodeId| objects.get((id.0 as usize).checked_sub(1)?).copied();
            let things = atom.things.iter().flatten().filter_map(object);
            word(atom.predicate).into_iter().chain(things).collect::<Vec<&str>>().join(" ")
        };
        let names = program.atoms().iter().map(named).collect();
        Ok(Self { program, names })
    }

    /// The facts, `ontop a t`, in the order in which the goal mentions them.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The goal over these facts, which are its atoms.
    pub fn program(&self) -> &GoalProgram {
        &self.program
    }

    /// The facts that hold at the start of the activity.
    ///
    /// # Errors
    /// [`ReadError`] for an unknown predicate or object.
    pub fn start(&self, activity: &ActivityDefinition) -> Result<Bits, ReadError> {
        let facts = activity.to_facts()?;
        let start: Vec<GroundAtom> =
            facts.iter().filter(|(_, holds)| *holds).map(|(literal, _)| atom(literal)).collect();
        Ok(self.program.having(&start))
    }

    /// For each conjunct of the goal whether it holds with these facts.
    pub fn heads(&self, holds: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut bits = self.program.bits();
        (0..self.names.len()).for_each(|fact| bits.set(fact, holds(fact)));
        (0..self.program.heads()).map(|head| self.program.head_holds(&bits, head)).collect()
    }
}

fn atom(literal: &Literal) -> GroundAtom {
    let node = |place: usize| match literal.terms.get(place) {
        Some(Term::Node(_, id)) => Some(*id),
        _ => None,
    };
    GroundAtom { predicate: literal.predicate, things: [node(0), node(1)] }
}
