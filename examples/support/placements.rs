//! Everything that can be carried, taken and put back where it was.

use std::collections::BTreeMap;

use vc_graph::{Action, Node, NodeId, Place, Property, Refusal, Relation, SceneGraph, Simulator, Verb};
use virtualcity::{ActionError, Environment, PhysicalRefusal};

use crate::support::say;

/// How many of each kind of failure are named.
const NAMED: usize = 12;

/// How many things were put back, by the rule alone and with bodies, of how many.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Tally {
    all: usize,
    allowed: usize,
    done: usize,
    disagreed: usize,
}

impl Tally {
    pub(crate) fn add(&mut self, other: Self) {
        self.all += other.all;
        self.allowed += other.allowed;
        self.done += other.done;
        self.disagreed += other.disagreed;
    }

    /// How often bodies and rule disagreed, which is a fault.
    pub(crate) fn disagreed(&self) -> usize {
        self.disagreed
    }

    pub(crate) fn say(&self) {
        let share = 100.0 * self.done as f64 / self.allowed.max(1) as f64;
        say!("  of {} things, {} may be put back by the rule; {} are, {share:.1}%", self.all, self.allowed, self.done);
    }
}

/// Takes everything that can be carried and puts it back where it was, each from how the home begins, and says why
/// others were not. The first of several places counts at which the rule lets people put things: a picture that is on
/// a wall and on a shelf goes back to the shelf.
pub(crate) fn all(home: &Environment) -> Tally {
    let (graph, mut tally) = (home.graph(), Tally::default());
    let mut failed = BTreeMap::<String, Vec<String>>::new();
    let carried = graph.nodes().filter(|n| n.affords(Property::Graspable)).map(Node::id);
    let rests = |p: &Place| matches!(p.relation, Relation::On | Relation::Inside);
    for id in carried {
        let Some(first) = graph.place(id).filter(rests) else { continue };
        let others = graph.places(id).filter(rests).filter(|place| *place != first);
        let places: Vec<Place> = std::iter::once(first).chain(others).collect();
        let thing = format!("{} {} {}", graph.label(id), first.relation, graph.label(first.at));
        let mut fail = |kind: String, why: String| failed.entry(kind).or_default().push(format!("{thing}: {why}"));
        tally.all += 1;
        let allowed = |place: &Place| by_rule(graph, home.agents()[0], id, *place);
        let Some(place) = places.iter().find(|place| allowed(place).is_ok()).copied() else {
            let Err((step, why)) = allowed(&first) else { continue };
            fail(format!("not by the rule, {step}"), why);
            continue;
        };
        tally.allowed += 1;
        match with_bodies(&mut home.clone(), id, place) {
            Ok(()) => tally.done += 1,
            Err((step, error)) => {
                tally.disagreed += usize::from(matches!(*error, ActionError::Disagreement(_)));
                fail(format!("{step}, {}", kind(&error)), error.to_string());
            }
        }
    }
    tally.say();
    for (kind, things) in failed {
        say!("    {} {kind}", things.len());
        things.iter().take(NAMED).for_each(|t| say!("      {t}"));
    }
    tally
}

/// By the transition rule alone, which knows no shapes.
fn by_rule(graph: &SceneGraph, me: NodeId, id: NodeId, place: Place) -> Result<(), (&'static str, String)> {
    let mut home = Simulator::new(graph.clone());
    let listed = |all: Vec<Refusal>| all.iter().map(Refusal::to_string).collect::<Vec<_>>().join("; ");
    carry(&mut home, id, place, Simulator::graph, |home, action| home.step(me, &action).map(drop).map_err(listed))
}

fn with_bodies(home: &mut Environment, id: NodeId, place: Place) -> Result<(), (&'static str, Box<ActionError>)> {
    let me = home.agents()[0];
    carry(home, id, place, Environment::graph, |home, action| home.set_action(me, action).map(drop).map_err(Box::new))
}

/// Opens what a thing is shut in, takes it and puts it at a place. If that fails, says in which step and why.
fn carry<W, E>(
    home: &mut W,
    id: NodeId,
    place: Place,
    graph: impl Fn(&W) -> &SceneGraph,
    act: impl Fn(&mut W, Action) -> Result<(), E>,
) -> Result<(), (&'static str, E)> {
    let act = |home: &mut W, step: &'static str, action: Action| act(home, action).map_err(|why| (step, why));
    while let Some(container) = graph(home).hidden_in(id) {
        act(home, "walk", Action::one(Verb::Walk, container))?;
        act(home, "open", Action::one(Verb::Open, container))?;
    }
    act(home, "walk", Action::one(Verb::Walk, id))?;
    act(home, "grab", Action::one(Verb::Grab, id))?;
    act(home, "walk back", Action::one(Verb::Walk, place.at))?;
    if graph(home).node(place.at).is_some_and(Node::hides_contents) {
        act(home, "open", Action::one(Verb::Open, place.at))?;
    }
    let verb = if place.relation == Relation::Inside { Verb::PutIn } else { Verb::Place };
    act(home, "put", Action::two(verb, id, place.at))
}

/// The kind of a reason, without names.
fn kind(error: &ActionError) -> &'static str {
    match error {
        ActionError::Refused(_) => "refused by the rule",
        ActionError::Impossible { why: PhysicalRefusal::NoStand(_), .. } => "out of reach",
        ActionError::Impossible { why: PhysicalRefusal::NoSpot { .. }, .. } => "no free spot",
        ActionError::Impossible { why: PhysicalRefusal::KeepsOpen { .. }, .. } => "would not shut",
        ActionError::Impossible { why: PhysicalRefusal::Stuck { .. }, .. } => "stuck",
        ActionError::Impossible { .. } => "bodies cannot",
        ActionError::Disagreement(_) => "bodies and rule disagree",
        _ => "another",
    }
}
