//! A scene and a goal as a planning problem.

use std::collections::BTreeSet;

use vc_graph::goal::{Goal, Term};
use vc_graph::rule::Condition;
use vc_graph::{Action, Node, NodeId, Property, Relation, SceneGraph, State, Verb, Word};

use super::goal::{Way, class_fact, met, ways};
use super::rules::{AIR, HANDS, HERE, LeftOut, Rules, STILL, UNSWITCHED, atoms, is, is_not};
use super::{AtomicFormula, Domain, Formula, Operator, OperatorEffect, PlanningProblem, TypedName};
use crate::format::Unwritable;

/// The choice of the objects and actions that a problem contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Keep {
    /// Those relevant to the goal: the objects it names, the ones these are on, in or by,
    /// and the tools of actions that lead to it.
    #[default]
    Relevant,
    /// All of them.
    Everything,
}

/// A domain, a problem in it, and the verbs the domain leaves out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Planning {
    /// The domain.
    pub domain: Domain,
    /// The problem.
    pub problem: PlanningProblem,
    /// The verbs that the domain leaves out.
    pub left_out: Vec<LeftOut>,
}

/// The name of a node in problems, `cup_12`.
pub(super) fn name(graph: &SceneGraph, id: NodeId) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let class: String = graph.node(id).map(|n| n.class().chars().map(plain).collect()).unwrap_or_default();
    let letter = if class.starts_with(|c: char| c.is_ascii_alphabetic()) { "" } else { "x" };
    format!("{letter}{class}_{}", id.0)
}

/// The problem of reaching a goal in a scene, with its domain. Plans for it obey the transition
/// rules, but see the limits in the description of [`super::domain`]: not every possible plan is
/// found.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_tasks::format::pddl::{Keep, planning};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let mut scene = SceneBuilder::from_graph(graph);
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let planning = planning(&scene.build(), me, &"Holds(apple)".parse()?, Keep::Relevant)?;
/// assert!(planning.domain.operators.iter().any(|operator| operator.name == "grab"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Unwritable`] for goals that cannot be expressed here: counts other than `at least`, pairs,
/// temporal operators, rooms. Derived predicates are written as their definitions.
pub fn planning(graph: &SceneGraph, agent: NodeId, goal: &Goal, keep: Keep) -> Result<Planning, Unwritable> {
    let goal = &*goal.expanded(graph.vocabulary());
    let mut ways = ways(goal, graph, agent)?;
    let mut rules = Rules::new(graph.vocabulary(), &graph.vocabulary().verbs().collect::<Vec<_>>());
    let plain = ways.len() == 1 && ways[0].facts.iter().all(|f| f.arguments.iter().all(|a| !a.starts_with('?')));
    let wanted = if plain { ways.remove(0).facts } else { vec![AtomicFormula::new("met", &[])] };
    rules.operators.extend(ways.iter().enumerate().filter(|_| !plain).map(|(i, way)| met(way, i)));
    if keep == Keep::Relevant {
        let operators = leading_to(&wanted, std::mem::take(&mut rules.operators));
        rules.operators = operators;
    }
    let nodes = match keep {
        Keep::Everything => graph.nodes().map(Node::id).filter(|&id| id != agent).collect(),
        Keep::Relevant => relevant(graph, agent, goal, &rules),
    };
    let scene = Scene { graph, agent, nodes, rules: &rules, ways: &ways };
    let domain = rules.domain("virtualcity");
    let mut problem = scene.problem(&domain, wanted);
    let mut domain = with_goal(domain, &problem);
    let named: BTreeSet<&str> = ways.iter().flat_map(Way::named).collect();
    let (constants, objects) = problem.objects.into_iter().partition(|o| named.contains(o.name.as_str()));
    problem.objects = objects;
    declare(&mut domain, constants);
    Ok(Planning { domain, problem, left_out: rules.left_out })
}

/// Moves objects that an action names to the constants of the domain.
fn declare(domain: &mut Domain, constants: Vec<TypedName>) {
    domain.constants.splice(0..0, constants);
    // Constants of one type are adjacent.
    domain.constants.sort_by_key(|constant| constant.kind != "thing".into());
}

/// Adds predicates of the goal that no action uses to the domain.
fn with_goal(mut domain: Domain, problem: &PlanningProblem) -> Domain {
    if let Formula::And(parts) | Formula::Or(parts) = &problem.goal {
        for part in parts {
            let Formula::Atom(atom) = part else { continue };
            if domain.predicates.iter().all(|p| p.name != atom.predicate) {
                let parameters = ["?x", "?y"].iter().take(atom.arguments.len());
                let parameters = parameters.map(|name| TypedName::new(*name, "thing")).collect();
                domain.predicates.push(super::Signature { name: atom.predicate.clone(), parameters });
            }
        }
    }
    domain
}

/// The action schemas that can be a step towards some facts.
fn leading_to(wanted: &[AtomicFormula], operators: Vec<Operator>) -> Vec<Operator> {
    let mut needed: BTreeSet<String> = wanted.iter().map(|a| a.predicate.clone()).collect();
    let mut kept = vec![false; operators.len()];
    loop {
        let before = kept.iter().filter(|k| **k).count();
        for (operator, kept) in operators.iter().zip(&mut kept) {
            let adds = |c: &OperatorEffect| matches!(c, OperatorEffect::Add(atom) if needed.contains(&atom.predicate));
            if !*kept && operator.effect.iter().any(adds) {
                *kept = true;
                if let Formula::And(needs) = &operator.precondition {
                    needed.extend(needs.iter().filter_map(|f| match f {
                        Formula::Atom(atom) => Some(atom.predicate.clone()),
                        _ => None,
                    }));
                }
            }
        }
        if kept.iter().filter(|k| **k).count() == before {
            break;
        }
    }
    let kept = operators.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(operator, _)| operator);
    kept.map(|operator| without_idle(operator, &needed)).collect()
}

/// Removes effects on facts that are never needed.
fn without_idle(mut operator: Operator, needed: &BTreeSet<String>) -> Operator {
    operator.effect.retain(|change| match change {
        OperatorEffect::Add(atom) | OperatorEffect::Delete(atom) => needed.contains(&atom.predicate),
        _ => true,
    });
    operator
}

/// The objects that can matter: those the goal names, all they are on, in or by, the tools of the
/// actions, and the objects held at the start.
fn relevant(graph: &SceneGraph, agent: NodeId, goal: &Goal, rules: &Rules) -> Vec<NodeId> {
    let mut nodes = BTreeSet::new();
    for term in goal.terms() {
        match term {
            Term::Class(class) => nodes.extend(graph.of_class(&class)),
            Term::Node(_, id) => nodes.extend(graph.node(id).map(Node::id)),
            Term::Anything => nodes.extend(graph.nodes().map(Node::id)),
            _ => {}
        }
    }
    let tools = [Property::Cutter, Property::Heater, Property::WaterSource];
    for tool in tools {
        let fact = format!("affords_{tool}");
        if rules.operators.iter().any(|o| atoms(o).any(|a| a.predicate == fact)) {
            nodes.extend(graph.nodes().filter(|n| n.affords(tool)).map(Node::id));
        }
    }
    if rules.operators.iter().any(|o| atoms(o).any(|a| a.arguments == ["?k", "?hk"])) {
        nodes.extend(graph.nodes().filter(|n| n.affords(Property::Wiper)).map(Node::id));
    }
    nodes.extend(graph.held(agent));
    let under: Vec<NodeId> = nodes.iter().flat_map(|&id| graph.support_chain(id)).collect();
    nodes.extend(under);
    nodes.remove(&agent);
    nodes.into_iter().collect()
}

struct Scene<'a> {
    graph: &'a SceneGraph,
    agent: NodeId,
    nodes: Vec<NodeId>,
    rules: &'a Rules,
    ways: &'a [Way],
}

/// The placement of an object.
struct Placed {
    rests: Option<(Relation, NodeId)>,
    /// The innermost support or container that cannot be picked up, or the object itself.
    spot: NodeId,
    /// The openable containers that the object is within.
    covers: Vec<NodeId>,
}

impl Scene<'_> {
    fn name(&self, id: NodeId) -> String {
        name(self.graph, id)
    }

    fn affords(&self, id: NodeId, property: Property) -> bool {
        self.graph.node(id).is_some_and(|n| n.affords(property))
    }

    fn movable(&self, id: NodeId) -> bool {
        Condition::Graspable(id).holds(self.graph, self.agent)
    }

    fn problem(&self, domain: &Domain, wanted: Vec<AtomicFormula>) -> PlanningProblem {
        let declared: BTreeSet<&str> = domain.predicates.iter().map(|p| p.name.as_str()).collect();
        let wanted_names: BTreeSet<&str> = wanted.iter().map(|a| a.predicate.as_str()).collect();
        let mut facts = BTreeSet::new();
        self.agent_facts(&mut facts);
        for &id in &self.nodes {
            self.place_facts(id, &mut facts);
            self.state_facts(id, &mut facts);
            self.lasting_facts(id, &mut facts);
        }
        self.goal_facts(&mut facts);
        facts.retain(|fact| {
            declared.contains(fact.predicate.as_str()) || wanted_names.contains(fact.predicate.as_str())
        });
        PlanningProblem {
            name: "task".to_owned(),
            domain: domain.name.clone(),
            objects: self.nodes.iter().map(|&id| TypedName::new(self.name(id), "thing")).collect(),
            initial: facts.into_iter().collect(),
            denied: Vec::new(),
            values: Vec::new(),
            goal: Formula::And(wanted.into_iter().map(Formula::Atom).collect()),
            metric: None,
        }
    }

    fn agent_facts(&self, facts: &mut BTreeSet<AtomicFormula>) {
        facts.extend([
            AtomicFormula::new("at", &[HERE]),
            AtomicFormula::new("at", &[HANDS]),
            AtomicFormula::new("leaves", &[HERE]),
        ]);
        facts.extend([AtomicFormula::new("lets_in", &[AIR]), AtomicFormula::new(STILL, &[AIR])]);
        for (relation, hand) in Relation::hands().into_iter().zip(["right", "left"]) {
            let mut held = self.graph.related(self.agent, relation).peekable();
            if held.peek().is_none() {
                facts.insert(AtomicFormula::new("free_hand", &[hand]));
            }
            facts.extend(held.map(|id| AtomicFormula::new("held", &[&self.name(id), hand])));
        }
        let body = self.graph.node(self.agent);
        let seats = [(Relation::SittingOn, "sitting_on"), (Relation::LyingOn, "lying_on")];
        let mut upright = true;
        for (relation, predicate) in seats {
            for id in self.graph.related(self.agent, relation) {
                facts.insert(AtomicFormula::new(predicate, &[&self.name(id)]));
                upright = false;
            }
        }
        if upright {
            facts.insert(AtomicFormula::new("upright", &[]));
        }
        if body.is_some_and(|b| b.is(State::Asleep)) {
            facts.insert(AtomicFormula::new(is(State::Asleep), &[HANDS]));
        }
    }

    fn placed(&self, id: NodeId) -> Placed {
        let place = |id: NodeId| {
            let mut places = self.graph.places(id);
            places.find(|p| matches!(p.relation, Relation::On | Relation::Inside)).map(|p| (p.relation, p.at))
        };
        let (mut covers, mut at) = (Vec::new(), id);
        let mut spot = (!self.movable(id)).then_some(id);
        for _ in self.graph.support_chain(id) {
            let Some((relation, next)) = place(at) else { break };
            if relation == Relation::Inside && self.affords(next, Property::Openable) {
                covers.push(next);
            }
            at = next;
            spot = spot.or_else(|| (!self.movable(at)).then_some(at));
        }
        Placed { rests: place(id), spot: spot.unwrap_or(at), covers }
    }

    fn place_facts(&self, id: NodeId, facts: &mut BTreeSet<AtomicFormula>) {
        let thing = self.name(id);
        if self.graph.places(self.agent).all(|place| place.at != id) {
            facts.insert(AtomicFormula::new("vacant", &[&thing]));
        }
        if self.graph.resting_at(id).all(|other| other == self.agent) {
            facts.insert(AtomicFormula::new("free", &[&thing]));
        }
        let by_me = self.graph.holder(id).is_some_and(|p| p.at == self.agent);
        let worn = self.graph.related(id, Relation::WornBy).any(|at| at == self.agent);
        if worn {
            facts.insert(AtomicFormula::new("worn", &[&thing]));
        }
        if by_me || worn {
            facts.extend([AtomicFormula::new("by", &[&thing, HANDS]), AtomicFormula::new("within", &[&thing, AIR])]);
            return;
        }
        let placed = self.placed(id);
        let in_hand = self.graph.rests_at(id, self.agent);
        let spot = if in_hand { HANDS.to_owned() } else { self.name(placed.spot) };
        facts.insert(AtomicFormula::new("by", &[&thing, &spot]));
        match *placed.covers {
            [] => drop(facts.insert(AtomicFormula::new("within", &[&thing, AIR]))),
            [cover] => drop(facts.insert(AtomicFormula::new("within", &[&thing, &self.name(cover)]))),
            // A fact cannot express two closed covers at once: the object stays inaccessible.
            _ => {}
        }
        if self.graph.holder(id).is_none() {
            let support = placed.rests.map_or_else(|| AIR.to_owned(), |(_, at)| self.name(at));
            facts.insert(AtomicFormula::new("rests", &[&thing, &support]));
        }
        if let Some((relation, at)) = placed.rests {
            let how = if relation == Relation::On { "on" } else { "in" };
            facts.insert(AtomicFormula::new(how, &[&thing, &self.name(at)]));
        }
        if placed.spot == id && self.graph.room_of(id).is_some() {
            facts.extend([AtomicFormula::new("spot", &[&thing]), AtomicFormula::new("leaves", &[&thing])]);
        }
    }

    fn state_facts(&self, id: NodeId, facts: &mut BTreeSet<AtomicFormula>) {
        let Some(node) = self.graph.node(id) else { return };
        let thing = self.name(id);
        let own = self.graph.vocabulary().own_states().iter().map(|own| own.state);
        for state in State::ALL.iter().copied().chain(own) {
            let predicate = if node.is(state) { is(state) } else { is_not(state) };
            facts.insert(AtomicFormula::new(predicate, &[&thing]));
        }
        if !node.hides_contents() {
            facts.insert(AtomicFormula::new("lets_in", &[&thing]));
        }
    }

    /// The static facts, evaluated in the scene by the conditions of the rules.
    fn lasting_facts(&self, id: NodeId, facts: &mut BTreeSet<AtomicFormula>) {
        let thing = self.name(id);
        for (fact, condition) in &self.rules.lasting {
            let grounded = condition.ground(&Action::one(Verb::Touch, id));
            let holds = |c: Option<Condition>| c.is_some_and(|c| c.holds(self.graph, self.agent));
            let yes = match fact.as_str() {
                "spot" => false,
                "always_open" => !self.affords(id, Property::Openable),
                STILL => !self.movable(id) && holds(grounded),
                UNSWITCHED => !self.affords(id, Property::Switchable),
                "fits" => {
                    self.fits(id, condition, facts);
                    false
                }
                _ => holds(grounded),
            };
            if yes {
                facts.insert(AtomicFormula::new(fact.clone(), &[&thing]));
            }
        }
    }

    fn fits(&self, id: NodeId, condition: &Condition<vc_graph::rule::Argument>, facts: &mut BTreeSet<AtomicFormula>) {
        if !self.movable(id) {
            return;
        }
        let target = |at: &&NodeId| {
            let takes = [Condition::Carries(**at), Condition::Encloses(**at)];
            takes.into_iter().any(|c| c.holds(self.graph, self.agent))
        };
        for &at in self.nodes.iter().filter(target) {
            let both = condition.ground(&Action::two(Verb::Place, id, at));
            if both.is_some_and(|c| c.holds(self.graph, self.agent)) {
                facts.insert(AtomicFormula::new("fits", &[&self.name(id), &self.name(at)]));
            }
        }
    }

    /// Adds the facts about which objects are of the goal's classes, and an order of all objects.
    fn goal_facts(&self, facts: &mut BTreeSet<AtomicFormula>) {
        let asked: BTreeSet<&str> = self.ways.iter().flat_map(|w| &w.facts).map(|f| f.predicate.as_str()).collect();
        for &id in &self.nodes {
            let Some(node) = self.graph.node(id) else { continue };
            for class in self.classes(node) {
                let fact = class_fact(&class, &self.name(id));
                if asked.contains(fact.predicate.as_str()) {
                    facts.insert(fact);
                }
            }
        }
        if asked.contains("before") {
            for (i, &a) in self.nodes.iter().enumerate() {
                for &b in &self.nodes[i + 1..] {
                    facts.insert(AtomicFormula::new("before", &[&self.name(a), &self.name(b)]));
                }
            }
        }
    }

    /// The goal's classes that a node belongs to.
    fn classes(&self, node: &Node) -> Vec<String> {
        let kinds = self.ways.iter().flat_map(|w| &w.facts).filter_map(|f| f.predicate.strip_prefix("kind_"));
        let kinds: BTreeSet<&str> = kinds.collect();
        kinds.into_iter().filter(|k| self.graph.of_class(k).contains(&node.id())).map(str::to_owned).collect()
    }
}
