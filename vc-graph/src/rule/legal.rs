//! All actions that an agent can perform in a state.

use std::cmp::Reverse;

use crate::rule::check::{NoReason, judge_of};
use crate::rule::condition::Condition;
use crate::rule::effect::Argument;
use crate::rule::judge::Judge;
use crate::rule::table::ActionRule;
use crate::vocabulary::{Set, Word};
use crate::{Action, Node, NodeId, SceneGraph, Verb};

/// All actions that an agent can perform now: those without [`refusals`](super::refusals), of every verb with
/// every object. They are ordered by verb, own verbs last by name, then by the numbers of the objects.
///
/// Each precondition is checked once per object for all verbs that share it, and only while a verb still
/// depends on it: some tens of microseconds for a home.
///
/// ```
/// use vc_graph::{Action, Draft, SceneBuilder, Verb, rule};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let legal = rule::legal_actions(&graph, me);
/// assert!(legal.contains(&Action::one(Verb::Walk, fridge)));
/// assert!(legal.iter().all(|action| rule::refusals(&graph, me, action).is_empty()));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
pub fn legal_actions(graph: &SceneGraph, agent: NodeId) -> Vec<Action> {
    legal_actions_with(graph, agent, &graph.nodes().map(Node::id).collect::<Vec<_>>())
}

/// As [`legal_actions`], for some objects only, for instance those within reach or in view. The actions are in
/// the order of the given objects.
pub fn legal_actions_with(graph: &SceneGraph, agent: NodeId, things: &[NodeId]) -> Vec<Action> {
    let Some(now) = judge_of(graph, agent) else { return Vec::new() };
    let words = graph.vocabulary();
    let needs = words.shared_needs();
    let verbs = needs.of_agent.iter().fold(needs.verbs, |verbs, (need, having)| {
        if need.ground(&NOTHING).is_some_and(|need| now.meets(&need)) { verbs } else { verbs.minus(*having) }
    });
    let open = Open::new(&now, needs, verbs, things);
    let mut found = Vec::with_capacity(open.first.iter().map(Vec::len).sum());
    for rule in words.rules().filter(|rule| verbs.contains(rule.verb)) {
        match rule.arity {
            0 => found.push(Action::zero(rule.verb)),
            1 => found.extend(open.first[rule.verb.index()].iter().map(|&id| Action::one(rule.verb, id))),
            _ => found.extend(open.pairs(&now, rule)),
        }
    }
    found
}

use Condition as C;

type Verbs = Set<Verb>;

/// A precondition on one object, and the verbs that require it of their first and of their second object.
struct OfThing {
    need: Condition<Argument>,
    first: Verbs,
    second: Verbs,
}

/// The preconditions of a vocabulary's verbs, each once; those on two objects at once are left out.
#[derive(Default)]
pub(crate) struct Needs {
    verbs: Verbs,
    /// The number of places in a list by the indices of verbs.
    places: usize,
    of_agent: Vec<(Condition<Argument>, Verbs)>,
    without_first: Verbs,
    without_second: Verbs,
    /// Those that are told by the node of the thing, which costs least.
    of_node: Vec<OfThing>,
    of_thing: Vec<OfThing>,
}

/// An action without objects, for grounding preconditions on the agent alone.
const NOTHING: Action = Action::zero(Verb::Dance);

/// An action with one object in both roles, so that a precondition is grounded on it whichever role it names.
fn both(id: NodeId) -> Action {
    Action { object: Some(id), target: Some(id), ..NOTHING }
}

/// Whether a precondition concerns two objects at once: neither alone grounds it.
fn is_of_two(need: Condition<Argument>) -> bool {
    let one = both(NodeId(0));
    [Action { object: None, ..one }, Action { target: None, ..one }].iter().all(|a| need.ground(a).is_none())
}

impl Needs {
    pub(crate) fn read<'r, R: Iterator<Item = &'r ActionRule>>(rules: impl Fn() -> R) -> Self {
        let verbs = |below: usize| rules().filter(|rule| rule.arity < below).map(|rule| rule.verb).collect::<Verbs>();
        let places = rules().map(|rule| rule.verb.index() + 1).max().unwrap_or(0);
        let (without_first, without_second) = (verbs(1), verbs(2));
        let mut needs = Self { verbs: verbs(usize::MAX), places, without_first, without_second, ..Self::default() };
        for (need, verb) in rules().flat_map(|rule| rule.preconditions.iter().map(|need| (*need, rule.verb))) {
            match need.ground(&NOTHING) {
                Some(_) => needs.note_of_agent(need, verb),
                None if is_of_two(need) => {}
                None => needs.note_of_thing(need, verb),
            }
        }
        // The precondition that most verbs share comes first: if it fails, the fewest checks remain.
        needs.of_thing.sort_by_key(|shared| Reverse(shared.first.len() + shared.second.len()));
        let is_told = |of: &mut OfThing| matches!(of.need, C::Affords(..) | C::In(..) | C::NotIn(..));
        needs.of_node = needs.of_thing.extract_if(.., is_told).collect();
        needs
    }

    fn note_of_agent(&mut self, need: Condition<Argument>, verb: Verb) {
        match self.of_agent.iter_mut().find(|(known, _)| *known == need) {
            Some((_, verbs)) => *verbs = verbs.with(verb),
            None => self.of_agent.push((need, Verbs::from_words(&[verb]))),
        }
    }

    fn note_of_thing(&mut self, need: Condition<Argument>, verb: Verb) {
        let thing = both(NodeId(0));
        let of_first = need.ground(&Action { target: None, ..thing }).is_some();
        let at = self.of_thing.iter().position(|known| known.need.ground(&thing) == need.ground(&thing));
        let at = at.unwrap_or_else(|| {
            self.of_thing.push(OfThing { need, first: Verbs::EMPTY, second: Verbs::EMPTY });
            self.of_thing.len() - 1
        });
        let verbs = if of_first { &mut self.of_thing[at].first } else { &mut self.of_thing[at].second };
        *verbs = verbs.with(verb);
    }
}

/// For each verb the objects that can be its first, and those that can be its second.
struct Open {
    first: Vec<Vec<NodeId>>,
    second: Vec<Vec<NodeId>>,
}

impl Open {
    fn new(now: &Judge<'_, NoReason>, needs: &Needs, verbs: Verbs, things: &[NodeId]) -> Self {
        let none = || vec![Vec::new(); needs.places];
        let mut open = Self { first: none(), second: none() };
        for node in things.iter().filter_map(|id| now.graph.node(*id)) {
            let (first, second) = open_to(now, needs, verbs, node);
            first.iter().for_each(|verb| open.first[verb.index()].push(node.id()));
            second.iter().for_each(|verb| open.second[verb.index()].push(node.id()));
        }
        open
    }

    /// The actions of a verb with two objects.
    fn pairs<'a>(&'a self, now: &'a Judge<'_, NoReason>, rule: &ActionRule) -> impl Iterator<Item = Action> + 'a {
        let (verb, needs) = (rule.verb, rule.preconditions.iter());
        let of_two: Vec<Condition<Argument>> = needs.filter(|need| is_of_two(**need)).copied().collect();
        let met = move |a: &Action| of_two.iter().filter_map(|need| need.ground(a)).all(|need| now.meets(&need));
        let seconds = &self.second[verb.index()];
        let with = move |&x: &NodeId| seconds.iter().filter(move |y| **y != x).map(move |&y| Action::two(verb, x, y));
        self.first[verb.index()].iter().flat_map(with).filter(met)
    }
}

/// The verbs that can have an object as their first and as their second. Each precondition is checked at most
/// once, and not at all if no remaining verb depends on it.
fn open_to(now: &Judge<'_, NoReason>, needs: &Needs, verbs: Verbs, node: &Node) -> (Verbs, Verbs) {
    let thing = both(node.id());
    let (mut first, mut second) = (verbs.minus(needs.without_first), verbs.minus(needs.without_second));
    for of in &needs.of_node {
        if !is_met_by(node, of.need) {
            (first, second) = (first.minus(of.first), second.minus(of.second));
        }
    }
    for of in &needs.of_thing {
        let matters = first.intersects(of.first) || second.intersects(of.second);
        if matters && !of.need.ground(&thing).is_some_and(|need| now.meets(&need)) {
            (first, second) = (first.minus(of.first), second.minus(of.second));
        }
    }
    (first, second)
}

/// Whether a node meets a need that it tells itself; others it does not refuse.
fn is_met_by(node: &Node, need: Condition<Argument>) -> bool {
    match need {
        C::Affords(_, property) => node.affords(property),
        C::In(_, state) => node.is(state),
        C::NotIn(_, state) => !node.is(state),
        _ => true,
    }
}
