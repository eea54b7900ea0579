//! The order in which subgoals are gone about, and the nearest of their options.

use vc_graph::goal::{Goal, Literal, Predicate, Situation, Term};
use vc_graph::{Action, Condition, NodeId, Relation, State, Verb};

use crate::open_condition::OpenCondition;
use crate::subgoal::View;

/// Facts about the whole goal that matter for the order in which its parts are gone about.
#[derive(Debug, Clone, Default)]
pub(crate) struct Hints {
    /// The things it names.
    terms: Vec<Term>,
    /// The nodes it names: who is to hold a novel and to read something reads it.
    named: Vec<NodeId>,
    /// It wants the agent to lie.
    pub(crate) lying: bool,
    /// The things it wants held, and in which hand if it says so.
    held: Vec<(Option<Relation>, Term)>,
}

impl Hints {
    pub(crate) fn new(goal: &Goal) -> Self {
        let terms = goal.terms();
        let node = |t: &Term| if let Term::Node(_, id) = t { Some(*id) } else { None };
        let mut hints = Self { named: terms.iter().filter_map(node).collect(), terms, ..Self::default() };
        hints.gather(goal, true);
        hints
    }

    fn gather(&mut self, goal: &Goal, wanted: bool) {
        match goal {
            Goal::Literal(literal) | Goal::Count { literal, .. } if wanted => self.read(literal),
            Goal::Not(part) => self.gather(part, !wanted),
            _ => goal.parts().into_iter().for_each(|part| self.gather(part, wanted)),
        }
    }

    fn read(&mut self, literal: &Literal) {
        self.lying |= literal.predicate == Predicate::State(State::Lying);
        let hand = match literal.predicate {
            Predicate::Holds => None,
            Predicate::Relation(hand @ (Relation::HoldsRight | Relation::HoldsLeft)) => Some(hand),
            _ => return,
        };
        self.held.extend(literal.terms.get(1).map(|thing| (hand, thing.clone())));
    }

    /// Whether the goal wants a thing in a hand.
    fn demands_in_hand(&self, now: &Situation<'_>, hand: Relation, id: NodeId) -> bool {
        let here = |wanted: Option<Relation>| wanted.is_none_or(|wanted| wanted == hand);
        self.held.iter().any(|(wanted, thing)| here(*wanted) && now.candidates(thing).contains(&id))
    }

    /// Whether a thing is in a hand in which the goal wants it.
    pub(crate) fn is_in_its_hand(&self, now: &Situation<'_>, id: NodeId) -> bool {
        let hand = now.graph.holder(id).filter(|hand| hand.at == now.agent);
        hand.is_some_and(|hand| self.demands_in_hand(now, hand.relation, id))
    }

    /// Sorts what could be taken into the free hand so that the other one is next: first what the goal wants
    /// there, last what it wants elsewhere.
    pub(crate) fn sort_fillers(&self, now: &Situation<'_>, grabs: &mut [Action]) {
        let Some(hand) = now.graph.free_hand(now.agent) else { return };
        let spoken_of: Vec<NodeId> = self.terms.iter().flat_map(|term| now.candidates(term)).collect();
        let order = |id: NodeId| (!self.demands_in_hand(now, hand, id), spoken_of.contains(&id));
        grabs.sort_by_cached_key(|grab| grab.object.map(order));
    }
}

/// The cost of doing something to a thing that the goal does not name.
const UNNAMED: u32 = 20;

impl View<'_> {
    /// When in the sequence of subgoals to go about a condition: things are carried and
    /// looked for first, doors closed and machines switched on when that is done,
    /// and only then does one sit down, turn to something and watch it.
    pub(crate) fn stage(&self, condition: &OpenCondition) -> u8 {
        let me = self.now.agent;
        match condition {
            OpenCondition::See(_) | OpenCondition::LookInto(_) => 0,
            OpenCondition::Hold(Condition::Related(from, Relation::On | Relation::Inside | Relation::InRoom, _))
                if *from != me =>
            {
                1
            }
            OpenCondition::Hold(Condition::In(id, State::Sitting | State::Lying)) if *id == me => 8,
            OpenCondition::Hold(Condition::In(_, State::Open)) => 2,
            OpenCondition::Hold(Condition::In(_, State::Closed)) => 3,
            OpenCondition::Hold(Condition::In(_, State::On)) => 4,
            OpenCondition::Hold(Condition::In(..)) => 2,
            OpenCondition::Hold(Condition::Holding(_)) => 5,
            // The right hand is filled first.
            OpenCondition::Hold(Condition::Related(_, Relation::HoldsRight, _)) => 4,
            OpenCondition::Hold(Condition::Related(_, Relation::HoldsLeft, _)) => 6,
            OpenCondition::Do(action) => self.stage_of(action.verb),
            OpenCondition::Hold(Condition::Near(_)) => 6,
            OpenCondition::Hold(Condition::Related(_, Relation::InRoom, _)) => 6,
            OpenCondition::Hold(Condition::Related(_, Relation::SittingOn | Relation::LyingOn, _)) => 7,
            OpenCondition::Hold(Condition::Facing(_)) => 9,
            OpenCondition::Hold(_) => 4,
        }
    }

    fn stage_of(&self, verb: Verb) -> u8 {
        match verb {
            Verb::LookAt | Verb::PointAt | Verb::Watch | Verb::Sleep | Verb::WakeUp => 10,
            Verb::Eat | Verb::Drink | Verb::Read => 5,
            _ => 4,
        }
    }

    /// Roughly how far away it is to bring something about.
    pub(crate) fn cost(&self, condition: &OpenCondition) -> u32 {
        match condition {
            OpenCondition::See(id) | OpenCondition::LookInto(id) => self.way(*id) + 1,
            OpenCondition::Do(action) => {
                let named = |id| self.hints.named.is_empty() || self.hints.named.contains(&id);
                action.things().map(|id| self.way(id) + UNNAMED * u32::from(!named(id))).sum()
            }
            OpenCondition::Hold(condition) => match *condition {
                Condition::Related(from, _, to) => self.way(from) + self.way(to),
                Condition::In(id, _)
                | Condition::Holding(id)
                | Condition::Near(id)
                | Condition::Facing(id)
                | Condition::Worn(id) => self.way(id),
                _ => 0,
            },
        }
    }

    /// Roughly how many actions it takes to have a thing at hand.
    fn way(&self, id: NodeId) -> u32 {
        let (graph, me) = (self.graph(), self.now.agent);
        if id == me || graph.holder(id).is_some_and(|p| p.at == me) {
            return 0;
        }
        let far = if graph.near(me, id) {
            1
        } else if graph.room_of(id) == graph.room_of(me) {
            2
        } else {
            4
        };
        far + u32::from(graph.hidden_in(id).is_some()) + 3 * u32::from(!self.known.contains(id))
    }
}
