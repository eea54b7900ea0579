//! A process: a line of the table, and the line for one thing.

use std::sync::Arc;

use super::kind::Kinds;
use super::needs::{Signed, Site};
use super::tick::{Span, Tick};
use crate::{Node, NodeId, Relation, SceneGraph, StateSet};

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
