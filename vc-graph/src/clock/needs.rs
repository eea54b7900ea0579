//! States that a process needs, states that it brings about, and the place where it goes on.

use super::error::ClockProblem;
use super::kind::Kinds;
use crate::class::ClassTable;
use crate::spelling::clip;
use crate::vocabulary::Word;
use crate::{Node, NodeId, Place, Property, Relation, SceneGraph, State, StateSet};

/// The word for a machine that is on or, as an old fridge, has no switch.
const RUNNING: &str = "running";

/// States with and without a minus sign: those that hold or begin, and those that do not or end.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Signed {
    pub(super) with: StateSet,
    pub(super) without: StateSet,
}

impl Signed {
    /// Reads states that are separated by spaces.
    pub(super) fn parse(text: &str) -> Result<Self, ClockProblem> {
        let mut states = Self::default();
        for word in text.split_whitespace() {
            match word.strip_prefix('-') {
                _ if word == RUNNING => return Err(ClockProblem::Running),
                Some(word) => states.without = states.without.with(State::parse(word)?),
                None => states.with = states.with.with(State::parse(word)?),
            }
        }
        states.checked()
    }

    fn checked(self) -> Result<Self, ClockProblem> {
        match (self.with.conflicts().next(), self.with.iter().find(|state| self.without.contains(*state))) {
            (Some(both), _) => Err(ClockProblem::Exclusive(both)),
            (None, Some(state)) => Err(ClockProblem::Both(state)),
            (None, None) => Ok(self),
        }
    }

    pub(super) fn is_empty(self) -> bool {
        self.with.is_empty() && self.without.is_empty()
    }

    /// Whether a thing with some states has those with and none of those without a minus sign.
    pub(super) fn hold(self, states: StateSet) -> bool {
        self.with.minus(states).is_empty() && !self.without.intersects(states)
    }

    /// Whether things that meet these needs also meet others.
    pub(super) fn include(self, others: Self) -> bool {
        others.with.minus(self.with).is_empty() && others.without.minus(self.without).is_empty()
    }

    /// The states afterwards.
    pub(super) fn after(self, states: StateSet) -> StateSet {
        self.with.iter().fold(states.minus(self.without), StateSet::entering)
    }
}

/// How a thing is to stand to a place.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Side {
    In,
    At,
    Away,
}

/// A place where a process goes on: in, on or away from things of some kinds that are in some states.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Site {
    side: Side,
    kinds: Kinds,
    states: Signed,
    running: bool,
}

impl Site {
    /// Reads the kinds of places and how a thing stands to them.
    pub(super) fn parse(text: &str, classes: &ClassTable) -> Result<Self, ClockProblem> {
        let (side, kinds) = text.split_once(' ').ok_or_else(|| ClockProblem::Place(clip(text)))?;
        let side = match side {
            "in" => Side::In,
            "at" => Side::At,
            "away" => Side::Away,
            _ => return Err(ClockProblem::Place(clip(text))),
        };
        let (states, running) = (Signed::default(), false);
        Ok(Self { side, kinds: Kinds::parse(kinds, classes)?, states, running })
    }

    /// The same place, in the states of a text.
    pub(super) fn in_states(self, text: &str) -> Result<Self, ClockProblem> {
        let states: Vec<&str> = text.split_whitespace().filter(|word| *word != RUNNING).collect();
        let running = text.split_whitespace().any(|word| word == RUNNING);
        Ok(Self { states: Signed::parse(&states.join(" "))?, running, ..self })
    }

    /// The kinds of places that a thing is to be in or at, if it is not to be away from them.
    pub(super) fn wanted(&self) -> Option<&Kinds> {
        (self.side != Side::Away).then_some(&self.kinds)
    }

    pub(super) fn holds(&self, graph: &SceneGraph, id: NodeId) -> bool {
        let here = |place: Place| {
            let inside = place.relation == Relation::Inside || self.side != Side::In;
            inside && graph.node(place.at).is_some_and(|node| self.is(graph, node))
        };
        graph.climb(id, &mut { here }).is_some() == (self.side != Side::Away)
    }

    fn is(&self, graph: &SceneGraph, node: &Node) -> bool {
        let runs = node.is(State::On) || !node.affords(Property::Switchable);
        self.states.hold(node.states()) && (runs || !self.running) && self.kinds.have(graph, node)
    }
}
