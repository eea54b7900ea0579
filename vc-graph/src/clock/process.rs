//! A process: a line of the table, and the line for one thing.

use std::sync::Arc;

use super::kind::Kinds;
use super::needs::{Signed, Site};
use super::tick::{Span, Tick};
use crate::{Node, NodeId, Relation, SceneGraph, State, StateSet};

/// A line of the table of processes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rule {
    /// The number of its name among all names.
    pub(super) group: usize,
    pub(super) name: Arc<str>,
    pub(super) kinds: Kinds,
    pub(super) needs: Signed,
    pub(super) site: Option<Site>,
    pub(super) becomes: Signed,
    /// Kinds of things inside, and what becomes of them.
    pub(super) inside: Option<(Kinds, Signed)>,
    pub(super) after: Span,
}

impl Rule {
    pub(super) fn applies(&self, graph: &SceneGraph, node: &Node) -> bool {
        // The cheap comparison first: few things are in any state that a line needs.
        let here = |site: &Site| site.holds(graph, node.id());
        self.needs.hold(node.states()) && self.kinds.have(graph, node) && self.site.as_ref().is_none_or(here)
    }

    /// Whether its thing enters a state in which it was not before.
    pub(super) fn enters(&self, state: State) -> bool {
        self.becomes.with.contains(state) && !self.needs.with.contains(state)
    }

    /// Whether things inside its thing enter a state.
    pub(super) fn enters_inside(&self, state: State) -> bool {
        self.inside.as_ref().is_some_and(|(_, becomes)| becomes.with.contains(state))
    }

    /// Whether a thing of a scene could be the thing of this process and enter a state.
    pub(super) fn brings_into(&self, graph: &SceneGraph, thing: &Node, state: State) -> bool {
        let place = self.site.as_ref().and_then(Site::wanted);
        let could_be_there = || place.is_none_or(|kinds| could_be_at(graph, thing, kinds));
        self.enters(state) && self.kinds.have(graph, thing) && could_be_there()
    }

    /// Whether a thing of a scene could be inside the thing of this process and enter a state.
    pub(super) fn brings_inside_into(&self, graph: &SceneGraph, thing: &Node, state: State) -> bool {
        let is_such = || self.inside.as_ref().is_some_and(|(kinds, _)| kinds.have(graph, thing));
        self.enters_inside(state) && is_such() && could_be_at(graph, thing, &self.kinds)
    }

    /// Whether it goes on with a thing wherever another process of its name does.
    pub(super) fn covers(&self, other: &Self, graph: &SceneGraph, thing: &Node) -> bool {
        let is_there = self.site.is_none() || self.site == other.site;
        self.group == other.group && is_there && other.needs.include(self.needs) && self.kinds.have(graph, thing)
    }

    /// The nodes whose states it would change, with their states afterwards.
    pub(super) fn changes(&self, graph: &SceneGraph, node: &Node) -> Vec<(NodeId, StateSet)> {
        let own = std::iter::once((node, self.becomes));
        let inside = self.inside.iter().flat_map(|(kinds, becomes)| {
            let all = graph.carried_with(node.id()).into_iter().filter(|&id| is_inside(graph, id, node.id()));
            let things = all.filter_map(|id| graph.node(id)).filter(|thing| kinds.have(graph, thing));
            things.map(|thing| (thing, *becomes))
        });
        let after = own.chain(inside).map(|(node, becomes)| (node, becomes.after(node.states())));
        after.filter(|(node, after)| node.states() != *after).map(|(node, after)| (node.id(), after)).collect()
    }
}

/// Whether a thing is on or in one of some kinds, or can be brought there.
fn could_be_at(graph: &SceneGraph, thing: &Node, kinds: &Kinds) -> bool {
    let is_place = |node: &Node| node.id() != thing.id() && kinds.have(graph, node);
    match thing.is_graspable() {
        true => graph.nodes().any(is_place),
        false => graph.support_chain(thing.id()).into_iter().filter_map(|id| graph.node(id)).any(is_place),
    }
}

/// Whether a thing is inside another, directly or through others.
fn is_inside(graph: &SceneGraph, id: NodeId, container: NodeId) -> bool {
    graph.climb(id, &mut |place| place.relation == Relation::Inside && place.at == container).is_some()
}

/// A process that goes on with a thing: a kettle boils, a soup cools. It ends after a time by itself, or before,
/// without effect, when its conditions end.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Process {
    /// The thing.
    pub node: NodeId,
    /// Name of the process in its table; a thing has one process of a name at most.
    pub name: Arc<str>,
    /// How long it takes from its begin to its end.
    pub after: Span,
    /// The nodes whose states its end would change now, the thing first, with all their states afterwards. Never empty.
    pub changes: Vec<(NodeId, StateSet)>,
}

impl Process {
    /// The tick of its end if it began at a given tick.
    ///
    /// ```
    /// use vc_graph::clock::{ProcessTable, Span, Tick};
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.add(Draft::new("soup").state(State::Hot))?;
    /// let graph = scene.build();
    /// let cooling = &ProcessTable::builtin().processes(&graph)[0];
    /// assert_eq!((&*cooling.name, cooling.after), ("cooling", "40 min".parse()?));
    /// assert_eq!(cooling.due(Tick(5)), Tick(5) + cooling.after);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn due(&self, since: Tick) -> Tick {
        since + self.after
    }
}
