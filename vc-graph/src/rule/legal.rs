//! All actions that an agent can do now.

use std::cmp::Reverse;
use std::sync::LazyLock;

use crate::node::Kind;
use crate::rule::condition::Condition;
use crate::rule::effect::Role;
use crate::rule::table::RULES;
use crate::vocabulary::{Set, Word};
use crate::{Action, Node, NodeId, SceneGraph, Verb};

/// Everything an agent can do now: the actions that have no
/// [`refusals`](super::refusals), of every verb with every thing there is. They come in the
/// order of the verbs, then of the numbers of the things.
///
/// Each need is checked once for each thing, for all verbs that share it, and only while a verb still depends
/// on it: some tens of microseconds for a home.
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

/// As [`legal_actions`], with some things only: those at hand, say, or those in view. They come
/// in the order of the things given.
pub fn legal_actions_with(graph: &SceneGraph, agent: NodeId, things: &[NodeId]) -> Vec<Action> {
    if graph.node(agent).is_none_or(|n| n.kind() != Kind::Agent) {
        return Vec::new();
    }
    let now = Now { graph, agent };
    let verbs = now.open(&NEEDS.of_agent, Verbs::of(Verb::ALL), &NOTHING);
    let known: Vec<NodeId> = things.iter().copied().filter(|&id| graph.node(id).is_some()).collect();
    let firsts = now.ask(&NEEDS.of_first, verbs, &known, first);
    let begun = firsts.iter().fold(Verbs::EMPTY, |all, (_, verbs)| all.union(*verbs));
    let paired: Verbs = begun.iter().filter(|verb| verb.arity() == 2).collect();
    let seconds = if paired.is_empty() { Vec::new() } else { now.ask(&NEEDS.of_second, paired, &known, second) };
    let mut found = Vec::new();
    for verb in verbs.iter() {
        match verb.arity() {
            0 => found.push(Action::zero(verb)),
            1 => found.extend(open_to(&firsts, verb).map(|id| Action::one(verb, id))),
            _ => found.extend(now.pairs(verb, &firsts, &seconds)),
        }
    }
    found
}

type Verbs = Set<Verb>;

/// A need, and the verbs that have it.
type Shared = (Condition<Role>, Verbs);

/// The needs of the verbs, each once; needs of two things at once are left out.
#[derive(Default)]
struct Needs {
    of_agent: Vec<Shared>,
    of_first: Vec<Shared>,
    of_second: Vec<Shared>,
}

static NEEDS: LazyLock<Needs> = LazyLock::new(Needs::read);

/// An action with nothing to ground a need on.
const NOTHING: Action = Action::zero(Verb::Dance);

fn first(id: NodeId) -> Action {
    Action { object: Some(id), ..NOTHING }
}

fn second(id: NodeId) -> Action {
    Action { target: Some(id), ..NOTHING }
}

impl Needs {
    fn read() -> Self {
        let mut needs = Self::default();
        for (need, verb) in RULES.iter().flat_map(|rule| rule.needs.iter().map(|need| (*need, rule.verb))) {
            let told_by = |action: Action| need.ground(&action).is_some();
            match (told_by(NOTHING), told_by(first(NodeId(0))), told_by(second(NodeId(0)))) {
                (true, _, _) => note(&mut needs.of_agent, need, verb),
                (_, true, _) => note(&mut needs.of_first, need, verb),
                (_, _, true) => note(&mut needs.of_second, need, verb),
                _ => {}
            }
        }
        // The need that most verbs share comes first: where it is not met, least is left to ask.
        for shared in [&mut needs.of_first, &mut needs.of_second] {
            shared.sort_by_key(|(_, verbs)| Reverse(verbs.len()));
        }
        needs
    }
}

fn note(shared: &mut Vec<Shared>, need: Condition<Role>, verb: Verb) {
    match shared.iter_mut().find(|(known, _)| *known == need) {
        Some((_, verbs)) => *verbs = verbs.with(verb),
        None => shared.push((need, Verbs::of(&[verb]))),
    }
}

/// A scene and the agent that is to act in it.
struct Now<'a> {
    graph: &'a SceneGraph,
    agent: NodeId,
}

/// A thing, and the verbs that can have it.
type Asked = (NodeId, Verbs);

/// The things a verb can have.
fn open_to(things: &[Asked], verb: Verb) -> impl Iterator<Item = NodeId> + '_ {
    things.iter().filter(move |(_, verbs)| verbs.contains(verb)).map(|(id, _)| *id)
}

impl Now<'_> {
    /// The verbs whose shared needs are all met. A need is not asked after once no verb depends
    /// on it.
    fn open(&self, needs: &[Shared], verbs: Verbs, action: &Action) -> Verbs {
        needs.iter().fold(verbs, |verbs, (need, having)| {
            let met = || need.ground(action).is_some_and(|need| need.holds(self.graph, self.agent));
            if verbs.intersects(*having) && !met() { verbs.minus(*having) } else { verbs }
        })
    }

    fn ask(&self, needs: &[Shared], verbs: Verbs, things: &[NodeId], role: fn(NodeId) -> Action) -> Vec<Asked> {
        things.iter().map(|&id| (id, self.open(needs, verbs, &role(id)))).collect()
    }

    /// The actions of a verb with two things.
    fn pairs(&self, verb: Verb, firsts: &[Asked], seconds: &[Asked]) -> Vec<Action> {
        let apart = |need: &&Condition<Role>| {
            [NOTHING, first(NodeId(0)), second(NodeId(0))].iter().all(|action| need.ground(action).is_none())
        };
        let of_both: Vec<Condition<Role>> = verb.rule().needs.iter().filter(apart).copied().collect();
        let met = |a: &Action| of_both.iter().filter_map(|c| c.ground(a)).all(|c| c.holds(self.graph, self.agent));
        let with = |x: NodeId| open_to(seconds, verb).filter(move |y| *y != x).map(move |y| Action::two(verb, x, y));
        open_to(firsts, verb).flat_map(with).filter(met).collect()
    }
}
