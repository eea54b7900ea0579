//! A complete symbolic simulator: a graph, and what has been done in it.

use std::sync::Arc;

use crate::rule::Memory;
use crate::{Action, ChangeSet, NodeId, Refusal, SceneGraph, Semantics, Verb, rule};

/// Something an agent has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Event {
    /// Who.
    pub agent: NodeId,
    /// What.
    pub action: Action,
}

/// What has been done so far, oldest first. Goals such as `Eat(apple)` are about
/// it. Cloning is cheap.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct History {
    events: Arc<Vec<Event>>,
}

impl History {
    /// Everything done, oldest first.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Adds what was done last.
    pub fn push(&mut self, event: Event) {
        Arc::make_mut(&mut self.events).push(event);
    }

    /// Forgets what was done last.
    pub fn pop(&mut self) -> Option<Event> {
        Arc::make_mut(&mut self.events).pop()
    }

    /// Whether a verb has been done to a thing, or at all.
    pub fn has(&self, verb: Verb, object: Option<NodeId>) -> bool {
        let same = |e: &Event| e.action.verb == verb && (object.is_none() || e.action.object == object);
        self.events.iter().any(same)
    }
}

/// A scene in which agents act by the transition rule.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut simulator = Simulator::new(scene.build());
///
/// let refused = simulator.step(me, &format!("grab milk.{}", milk.0).parse()?);
/// assert_eq!(refused.unwrap_err()[0].to_string(), "milk.3 is inside fridge.2, which is closed");
/// for action in ["walk fridge.2", "open fridge.2", "grab milk.3"] {
///     simulator.step(me, &action.parse()?).map_err(|refusals| refusals[0].clone())?;
/// }
/// assert_eq!(simulator.graph().held(me).collect::<Vec<_>>(), [milk]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Simulator {
    graph: SceneGraph,
    history: History,
    semantics: Semantics,
    /// The memory of VirtualHome's simulator, which ours does not use.
    memory: Memory,
}

impl Simulator {
    /// A simulator of a scene in which nothing has been done.
    pub fn new(graph: SceneGraph) -> Self {
        Self::with(graph, Semantics::VirtualCity)
    }

    /// As [`Simulator::new`], by the transition rule of another simulator; a table of the differences is in
    /// [`virtual_home`](crate::rule::virtual_home).
    ///
    /// ```
    /// use vc_graph::{Draft, Relation, SceneBuilder, Semantics, Simulator};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let plate = scene.add_in(kitchen, Draft::new("plate"))?;
    /// let apple = scene.add_on(plate, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let scene = scene.build();
    /// for (semantics, goes_along) in [(Semantics::VirtualCity, true), (Semantics::VirtualHome, false)] {
    ///     let mut world = Simulator::with(scene.clone(), semantics);
    ///     for action in ["walk plate.2", "grab plate.2"] {
    ///         world.step(me, &action.parse()?).map_err(|refusals| refusals[0].clone())?;
    ///     }
    ///     assert_eq!(world.graph().related(apple, Relation::On).any(|at| at == plate), goes_along);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with(graph: SceneGraph, semantics: Semantics) -> Self {
        Self { graph, history: History::default(), semantics, memory: Memory::default() }
    }

    /// The transition rule by which actions are done.
    pub fn semantics(&self) -> Semantics {
        self.semantics
    }

    /// The scene as it is.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// What has been done.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Lets an agent act.
    ///
    /// # Errors
    /// Every [`Refusal`]; then nothing has changed.
    pub fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, Vec<Refusal>> {
        let changes = match self.semantics {
            Semantics::VirtualCity => rule::step(&mut self.graph, agent, action)?,
            Semantics::VirtualHome => self.memory.step(&mut self.graph, agent, action)?,
        };
        self.history.push(Event { agent, action: *action });
        Ok(changes)
    }

    /// Every reason why an agent cannot do an action now; empty if it can.
    pub fn refusals(&self, agent: NodeId, action: &Action) -> Vec<Refusal> {
        match self.semantics {
            Semantics::VirtualCity => rule::refusals(&self.graph, agent, action),
            Semantics::VirtualHome => self.memory.refusals(&self.graph, agent, action),
        }
    }

    /// Lets several agents act at once: each meets what those before it have done.
    ///
    /// # Errors
    /// The first deed that was refused, with every [`Refusal`]; then nothing has changed.
    pub fn step_together(&mut self, deeds: &[Event]) -> Result<(), (Event, Vec<Refusal>)> {
        let before = (deeds.len() > 1).then(|| self.clone());
        let refused = deeds.iter().find_map(|deed| Some((*deed, self.step(deed.agent, &deed.action).err()?)));
        if let (Some(before), Some(_)) = (before, &refused) {
            *self = before;
        }
        refused.map_or(Ok(()), Err)
    }

    /// The scene, with the history dropped.
    pub fn into_graph(self) -> SceneGraph {
        self.graph
    }
}
