//! Why a goal does not hold, what would make it hold, and since when it has held.

mod sets;

use vc_graph::goal::{EpisodeTrace, Quantified, Situation};
use vc_graph::{Goal, NodeId};

use crate::compile::{CompileError, Compiler, Monitor, Things};
pub use sets::{MinimalSets, Unmet};

/// The number of sets of missing conditions that [`explain`] returns at most.
pub const SETS: usize = 16;

/// The explanation of one conjunct of a goal.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let parts = vc_tasks::explain(&"On(apple, kitchen_table) & Holds(apple)".parse()?, &now)?;
/// assert_eq!(parts.iter().map(|part| part.holds).collect::<Vec<_>>(), [true, false]);
/// assert_eq!(parts[1].unmet[0][0].to_string(), "Holds(#4, #3)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GoalPart {
    /// The conjunct.
    pub goal: Goal,
    /// Whether it holds.
    pub holds: bool,
    /// The minimal sets of missing conditions, at most [`SETS`] and smallest first; one empty set
    /// if the conjunct holds, no set if nothing can make it hold.
    pub unmet: Vec<Vec<Unmet>>,
    /// For a quantified conjunct, the objects for which its body holds and those for which it does
    /// not.
    pub bindings: Option<Bindings>,
}

/// The objects that a quantified goal ranges over.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let parts = vc_tasks::explain(&"exists ?a: apple. On(?a, kitchen_table)".parse()?, &now)?;
/// let bindings = parts[0].bindings.as_ref().ok_or("no quantifier")?;
/// assert_eq!((bindings.satisfied.as_slice(), bindings.unsatisfied.len()), ([apple].as_slice(), 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bindings {
    /// The objects for which the body holds.
    pub satisfied: Vec<NodeId>,
    /// The objects for which it does not hold.
    pub unsatisfied: Vec<NodeId>,
}

/// Explains for each conjunct of a goal whether it holds in a situation, which conditions are
/// missing, and for which objects it holds.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// scene.add_on(table, Draft::new("plate"))?;
/// scene.add_in(kitchen, Draft::new("plate"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let parts = vc_tasks::explain(&"forall ?p: plate. On(?p, table)".parse()?, &now)?;
/// let unmet: Vec<String> = parts[0].unmet[0].iter().map(|u| u.to_string()).collect();
/// assert_eq!(unmet, ["On(#4, #2)"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CompileError`]: the goal is temporal or too large.
pub fn explain(goal: &Goal, now: &Situation<'_>) -> Result<Vec<GoalPart>, CompileError> {
    let mut compiler = Compiler::new();
    let program = compiler.compile(goal, now)?;
    let bits = program.read(now);
    let conjuncts = goal.conjuncts().iter().enumerate();
    let part = |(head, part): (usize, &Goal)| GoalPart {
        goal: part.clone(),
        holds: program.head_holds(&bits, head),
        unmet: program.unmet_of_head(&bits, head, SETS).sets,
        bindings: quantified(&part.expanded(now.graph.vocabulary())).map(|q| bindings(q, now)),
    };
    Ok(conjuncts.map(part).collect())
}

fn quantified(goal: &Goal) -> Option<&Quantified> {
    match goal {
        Goal::ForAll(q) | Goal::Exists(q) | Goal::ForN { of: q, .. } => Some(q),
        _ => None,
    }
}

fn bindings(q: &Quantified, now: &Situation<'_>) -> Bindings {
    let mut things = Vec::new();
    now.each(q.class.as_deref(), &mut things);
    let mut found = Bindings::default();
    for thing in things {
        match q.holds_of(thing, now) {
            true => found.satisfied.push(thing),
            false => found.unsatisfied.push(thing),
        }
    }
    found
}

/// For each conjunct of a goal the first step after which it held, if there was one, evaluated on
/// the trace up to that step.
///
/// Costs as much as a [`Monitor`]; where objects are added or removed, or variables range over too
/// many, the goal is evaluated directly at each step.
///
/// ```
/// use vc_graph::goal::EpisodeTrace;
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("fridge"))?;
/// let me = scene.add(Draft::new("character"))?;
/// let trace = EpisodeTrace::new(scene.build(), me);
/// assert_eq!(vc_tasks::first_held(&"Closed(fridge) & Open(fridge)".parse()?, &trace), [Some(0), None]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn first_held(goal: &Goal, trace: &EpisodeTrace) -> Vec<Option<usize>> {
    if let Some(monitor) = Monitor::from_constant_nodes(goal, trace) {
        return monitor.first_held().to_vec();
    }
    let conjuncts = goal.conjuncts().iter();
    conjuncts.map(|part| (0..=trace.steps()).find(|&step| part.holds_by(trace, step))).collect()
}
