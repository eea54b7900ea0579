//! Open subgoals of a literal: the things for which it is to become true or false.

use vc_graph::goal::{Goal, Literal, Predicate, Term};
use vc_graph::{Action, Node, NodeId, Place, Property, Relation, Verb};

use super::number::Limit;
use super::{Bindings, Found, View};
use crate::open_condition::{OpenCondition, Subgoal, Unreachable};

impl View<'_> {
    /// At least, or at most, a number of different things has to satisfy a literal.
    pub(super) fn literals(&self, goal: &Goal, literal: &Literal, limit: Limit, bound: &Bindings<'_>) -> Found {
        match limit {
            Limit::AtLeast(number) => self.at_least(goal, literal, number, bound),
            Limit::AtMost(number) => self.at_most(goal, literal, number, bound),
        }
    }

    /// At least a number of different things has to satisfy a literal.
    pub(super) fn at_least(&self, goal: &Goal, literal: &Literal, number: usize, bound: &Bindings<'_>) -> Found {
        if literal.terms.is_empty() {
            let done = self.now.holds(literal.predicate, [None, None]);
            let options = self.conditions(literal.predicate, [None, None]);
            return Ok((!done).then_some(Subgoal { options }).into_iter().collect());
        }
        let choices = self.choices(literal, bound);
        if choices.len() < number {
            return Err(Unreachable::NoInstance(goal.to_string()));
        }
        let mut met = 0;
        let mut options: Vec<OpenCondition> = Vec::new();
        for (_, things) in &choices {
            let holding = || things.iter().filter(|t| self.now.holds(literal.predicate, **t));
            if holding().any(|t| self.is_known(literal, t)) {
                met += 1;
            } else if let Some(guessed) = holding().next() {
                options.extend(self.to_see(literal, guessed));
            } else {
                options.extend(things.iter().flat_map(|t| self.conditions(literal.predicate, *t)));
            }
        }
        if met >= number {
            return Ok(Vec::new());
        }
        if options.is_empty() {
            return Err(Unreachable::NoPlan(goal.to_string()));
        }
        options.sort_by_cached_key(|w| self.cost(w));
        // One subgoal for all missing things: the rest is counted anew after each.
        Ok(vec![Subgoal { options }])
    }

    /// At most a number of things may satisfy a literal.
    pub(super) fn at_most(&self, goal: &Goal, literal: &Literal, number: usize, bound: &Bindings<'_>) -> Found {
        let (mut holding, mut carried) = (Vec::new(), Vec::new());
        let mut looks: Vec<OpenCondition> = Vec::new();
        for (_, things) in self.choices(literal, bound) {
            for t in things {
                if self.now.holds(literal.predicate, t) {
                    holding.push(t);
                } else {
                    carried.extend(t[0].filter(|_| self.is_carried_out(literal.predicate, t)));
                    let doubts = self.to_rule_out(literal, &t);
                    looks.extend(doubts.into_iter().filter(|condition| !looks.contains(condition)).collect::<Vec<_>>());
                }
            }
        }
        let excess = holding.len().saturating_sub(number);
        if excess > 0 {
            let mut options: Vec<OpenCondition> =
                holding.iter().flat_map(|t| self.undo(literal.predicate, *t)).collect();
            options.sort_by_cached_key(|w| self.cost(w));
            let irrevocable = options.is_empty();
            return if irrevocable {
                Err(Unreachable::Irrevocable(goal.to_string()))
            } else {
                Ok(vec![Subgoal { options }])
            };
        }
        // A thing that has been carried out of a room is dropped first, lest the agent carry it back in when it
        // looks further.
        if let Some(&id) = carried.first().filter(|_| !looks.is_empty()) {
            return Ok(vec![Subgoal { options: vec![OpenCondition::Do(Action::one(Verb::Drop, id))] }]);
        }
        looks.sort_by_cached_key(|condition| self.cost(condition));
        Ok(looks.into_iter().map(|condition| Subgoal { options: vec![condition] }).collect())
    }

    /// Whether a thing that is not to be in a room is in the agent's hand.
    fn is_carried_out(&self, predicate: Predicate, things: [Option<NodeId>; 2]) -> bool {
        let (Predicate::Relation(Relation::Inside | Relation::InRoom), [Some(id), Some(at)]) = (predicate, things)
        else {
            return false;
        };
        self.graph().rooms().contains(&at) && self.graph().holder(id).is_some_and(|hand| hand.at == self.now.agent)
    }

    /// For each counted thing, all argument tuples with it.
    fn choices(&self, literal: &Literal, bound: &Bindings<'_>) -> Vec<(NodeId, Vec<[Option<NodeId>; 2]>)> {
        let lists: Vec<Vec<NodeId>> =
            literal.terms.iter().enumerate().map(|(i, t)| self.candidates(literal.predicate, i, t, bound)).collect();
        let counted = literal.counted().unwrap_or(0);
        let Some(first) = lists.get(counted) else { return Vec::new() };
        let others = lists.get(1 - counted).filter(|_| lists.len() > 1);
        let pair = |a: NodeId| match others {
            None => vec![[Some(a), None]],
            Some(others) if counted == 0 => others.iter().map(|&b| [Some(a), Some(b)]).collect(),
            Some(others) => others.iter().map(|&b| [Some(b), Some(a)]).collect(),
        };
        first.iter().map(|&a| (a, pair(a))).collect()
    }

    fn candidates(&self, predicate: Predicate, position: usize, term: &Term, bound: &Bindings<'_>) -> Vec<NodeId> {
        match (term, predicate) {
            (Term::Variable(name), _) => {
                bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| id).into_iter().collect()
            }
            (Term::Anything, Predicate::Did(verb)) => self.fit_for(verb, position),
            // An agent in an unknown home knows no thing by its number before seeing it.
            (Term::Node(_, id), _) => self.graph().node(*id).map(Node::id).into_iter().collect(),
            _ => self.now.candidates(term),
        }
    }

    /// The things to which a verb can be applied, by their properties.
    fn fit_for(&self, verb: Verb, position: usize) -> Vec<NodeId> {
        let fits = |node: &&Node| {
            let id = node.id();
            let second = Action { target: Some(id), ..Action::zero(verb) };
            let probe = if position == 0 { Action::one(verb, id) } else { second };
            let needs = vc_graph::rule::preconditions(self.graph().vocabulary(), &probe);
            needs.iter().filter(|c| c.is_lasting()).all(|c| c.holds(self.graph(), self.now.agent))
        };
        self.graph().nodes().filter(|n| n.kind() == vc_graph::NodeKind::Object).filter(fits).map(Node::id).collect()
    }

    fn is_known(&self, literal: &Literal, things: &[Option<NodeId>; 2]) -> bool {
        matches!(literal.predicate, Predicate::Did(_)) || things.iter().flatten().all(|&id| self.known.contains(id))
    }

    /// The things to look at to be certain of a literal.
    fn to_see(&self, literal: &Literal, things: &[Option<NodeId>; 2]) -> Vec<OpenCondition> {
        if matches!(literal.predicate, Predicate::Did(_)) {
            return Vec::new();
        }
        things
            .iter()
            .flatten()
            .filter(|&&id| !self.known.contains(id))
            .take(1)
            .map(|&id| OpenCondition::See(id))
            .collect()
    }

    /// The things to look at to be certain that a literal does not hold: for the place of a thing, the unseen
    /// places that the literal names.
    fn to_rule_out(&self, literal: &Literal, things: &[Option<NodeId>; 2]) -> Vec<OpenCondition> {
        let (
            Predicate::Relation(relation @ (Relation::On | Relation::Inside | Relation::InRoom)),
            [Some(id), Some(at)],
        ) = (literal.predicate, *things)
        else {
            return self.to_see(literal, things);
        };
        let graph = self.graph();
        // A fixed thing stays where it is, and a thing that has been seen is not elsewhere.
        if self.known.contains(id) || !graph.node(id).is_some_and(|n| n.affords(Property::Graspable)) {
            return Vec::new();
        }
        let there = |place: &&Place| match relation {
            Relation::On => place.relation == relation && place.at == at,
            _ => place.at == at || graph.room_of(place.at) == Some(at) || graph.support_chain(place.at).contains(&at),
        };
        let look = |place: &Place| match place.relation {
            Relation::Inside => OpenCondition::LookInto(place.at),
            _ => OpenCondition::See(place.at),
        };
        self.unseen.iter().filter(there).map(look).collect()
    }
}
