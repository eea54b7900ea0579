//! All actions that an agent can perform in a state.

use std::cmp::Reverse;

use crate::rule::check::{NoReason, judge_of};
use crate::rule::condition::Condition;
use crate::rule::effect::Argument;
use crate::rule::judge::Judge;
use crate::rule::table::ActionRule;
use crate::vocabulary::{Word, bits};
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
    let open = needs.open(&now, things);
    let mut found = Vec::with_capacity(open.objects.iter().map(Vec::len).sum());
    for rule in words.rules().filter(|rule| !open.is_refused(rule.verb)) {
        match rule.arity {
            0 => found.push(Action::zero(rule.verb)),
            1 => found.extend(open.objects_of(rule.verb, First).iter().map(|&id| Action::one(rule.verb, id))),
            _ => found.extend(open.pairs(&now, rule)),
        }
    }
    found
}

use Condition as C;
use Role::{First, Second};

/// The role of an object in an action.
#[derive(Clone, Copy)]
enum Role {
    First,
    Second,
}

/// The place of a verb's role in lists: both roles of a verb stand side by side.
fn place(verb: Verb, role: Role) -> usize {
    2 * verb.index() + role as usize
}

/// A precondition on one object, and the places of the roles whose objects have to meet it.
struct OfThing {
    need: Condition<Argument>,
    roles: Vec<usize>,
}

/// The preconditions of a vocabulary's verbs, each once; those on two objects at once are left out.
#[derive(Default)]
pub(crate) struct Needs {
    /// By place, whether an object takes the role.
    has_role: Vec<bool>,
    of_agent: Vec<(Condition<Argument>, Vec<Verb>)>,
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
        let mut needs = Self::default();
        let verbs = rules().map(|rule| rule.verb.index() + 1).max().unwrap_or(0);
        needs.has_role = vec![false; 2 * verbs];
        for rule in rules() {
            [First, Second].iter().take(rule.arity).for_each(|role| needs.has_role[place(rule.verb, *role)] = true);
        }
        for (need, verb) in rules().flat_map(|rule| rule.preconditions.iter().map(|need| (*need, rule.verb))) {
            match need.ground(&NOTHING) {
                Some(_) => needs.note_of_agent(need, verb),
                None if is_of_two(need) => {}
                None => needs.note_of_thing(need, verb),
            }
        }
        // The precondition that most roles share comes first: if it fails, the fewest checks remain.
        needs.of_thing.sort_by_key(|shared| Reverse(shared.roles.len()));
        let is_told = |of: &mut OfThing| matches!(of.need, C::Affords(..) | C::In(..) | C::NotIn(..));
        needs.of_node = needs.of_thing.extract_if(.., is_told).collect();
        needs
    }

    fn note_of_agent(&mut self, need: Condition<Argument>, verb: Verb) {
        match self.of_agent.iter_mut().find(|(known, _)| *known == need) {
            Some((_, verbs)) => verbs.push(verb),
            None => self.of_agent.push((need, vec![verb])),
        }
    }

    fn note_of_thing(&mut self, need: Condition<Argument>, verb: Verb) {
        let thing = both(NodeId(0));
        let is_of_first = need.ground(&Action { target: None, ..thing }).is_some();
        let role = place(verb, if is_of_first { First } else { Second });
        match self.of_thing.iter_mut().find(|known| known.need.ground(&thing) == need.ground(&thing)) {
            Some(known) => known.roles.push(role),
            None => self.of_thing.push(OfThing { need, roles: vec![role] }),
        }
    }

    /// The objects that can take each role now.
    fn open(&self, now: &Judge<'_, NoReason>, things: &[NodeId]) -> Open {
        let mut open = Open { refused: vec![false; self.has_role.len() / 2], objects: Vec::new() };
        for (need, verbs) in &self.of_agent {
            if !need.ground(&NOTHING).is_some_and(|need| now.meets(&need)) {
                verbs.iter().for_each(|verb| open.refused[verb.index()] = true);
            }
        }
        open.objects = vec![Vec::new(); self.has_role.len()];
        let nodes: Vec<&Node> = things.iter().filter_map(|id| now.graph.node(*id)).collect();
        for block in nodes.chunks(BLOCK) {
            let masks = self.masks(now, &open.refused, block);
            for (objects, mask) in open.objects.iter_mut().zip(masks) {
                objects.extend(bits(mask).map(|bit| block[bit].id()));
            }
        }
        open
    }

    /// By place, which of a block of nodes can take the role: bit `i` is node `i`. Each precondition is checked at
    /// most once per node, and not at all if no role of a verb depends on it any more.
    fn masks(&self, now: &Judge<'_, NoReason>, refused: &[bool], nodes: &[&Node]) -> Vec<u64> {
        let all = u64::MAX >> (BLOCK - nodes.len());
        let is_asked = self.has_role.iter().enumerate().map(|(place, has)| *has && !refused[place / 2]);
        let mut masks: Vec<u64> = is_asked.map(|is_asked| if is_asked { all } else { 0 }).collect();
        for of in &self.of_node {
            of.keep(&mut masks, mask_of(nodes.iter().map(|node| is_met_by(node, of.need))));
        }
        for of in &self.of_thing {
            let asked = of.roles.iter().fold(0, |asked, role| asked | masks[*role]);
            let meets = |bit: &usize| of.need.ground(&both(nodes[*bit].id())).is_some_and(|need| now.meets(&need));
            of.keep(&mut masks, bits(asked).filter(meets).fold(0, |met, bit| met | 1 << bit));
        }
        masks
    }
}

impl OfThing {
    fn keep(&self, masks: &mut [u64], met: u64) {
        self.roles.iter().for_each(|role| masks[*role] &= met);
    }
}

/// The verbs that the agent cannot perform on anything, and by place the objects that can take each role.
struct Open {
    refused: Vec<bool>,
    objects: Vec<Vec<NodeId>>,
}

impl Open {
    fn is_refused(&self, verb: Verb) -> bool {
        self.refused[verb.index()]
    }

    fn objects_of(&self, verb: Verb, role: Role) -> &[NodeId] {
        &self.objects[place(verb, role)]
    }

    /// The actions of a verb with two objects.
    fn pairs<'a>(&'a self, now: &'a Judge<'_, NoReason>, rule: &ActionRule) -> impl Iterator<Item = Action> + 'a {
        let (verb, needs) = (rule.verb, rule.preconditions.iter());
        let of_two: Vec<Condition<Argument>> = needs.filter(|need| is_of_two(**need)).copied().collect();
        let met = move |a: &Action| of_two.iter().filter_map(|need| need.ground(a)).all(|need| now.meets(&need));
        let seconds = self.objects_of(verb, Second);
        let with = move |&x: &NodeId| seconds.iter().filter(move |y| **y != x).map(move |&y| Action::two(verb, x, y));
        self.objects_of(verb, First).iter().flat_map(with).filter(met)
    }
}

/// The number of nodes that are looked at together, one bit each.
const BLOCK: usize = u64::BITS as usize;

/// The numbers of a block that is no longer than [`BLOCK`], as bits.
fn mask_of(flags: impl Iterator<Item = bool>) -> u64 {
    flags.enumerate().fold(0, |mask, (bit, flag)| mask | u64::from(flag) << bit)
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
