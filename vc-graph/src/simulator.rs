//! A symbolic simulator: a scene graph and the history of actions in it.

use std::sync::Arc;

use crate::rule::Memory;
use crate::{Action, ChangeSet, NodeId, Refusal, SceneGraph, Semantics, Verb, rule};

/// An action performed by an agent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Event {
    /// The agent.
    pub agent: NodeId,
    /// The action.
    pub action: Action,
}

/// The actions performed so far, oldest first. Goals such as `Eat(apple)` refer to it. Cloning is cheap.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator, Verb};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let mut world = Simulator::new(graph);
/// world.step(me, &"walk apple.3".parse()?).map_err(|why| why[0].clone())?;
/// assert!(world.history().has(Verb::Walk, Some(apple)) && !world.history().has(Verb::Grab, None));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct History {
    events: Arc<Vec<Event>>,
}

impl History {
    /// All events, oldest first.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Appends the latest event.
    pub fn push(&mut self, event: Event) {
        Arc::make_mut(&mut self.events).push(event);
    }

    /// Removes and returns the latest event.
    pub fn pop(&mut self) -> Option<Event> {
        Arc::make_mut(&mut self.events).pop()
    }

    /// Whether a verb has been performed on an object, or at all if `object` is `None`.
    pub fn has(&self, verb: Verb, object: Option<NodeId>) -> bool {
        let same = |e: &Event| e.action.verb == verb && (object.is_none() || e.action.object == object);
        self.events.iter().any(same)
    }
}

/// A scene in which agents act according to the transition rule.
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
    /// State that only VirtualHome's transition rule uses.
    memory: Memory,
}

impl Simulator {
    /// A simulator of a scene, with an empty history.
    pub fn new(graph: SceneGraph) -> Self {
        Self::with(graph, Semantics::VirtualCity)
    }

    /// As [`Simulator::new`], with the transition rule of a given simulator; a table of the differences is in
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

    /// The transition rule that is applied.
    pub fn semantics(&self) -> Semantics {
        self.semantics
    }

    /// The current scene.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// The actions performed so far.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Performs an agent's action.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut world = Simulator::new(graph);
    /// let refused = world.step(me, &"open fridge.2".parse()?).unwrap_err();
    /// assert!(!refused.is_empty(), "it is not near");
    /// world.step(me, &"walk fridge.2".parse()?).map_err(|why| why[0].clone())?;
    /// assert!(world.step(me, &"open fridge.2".parse()?).is_ok());
    /// assert_eq!(world.history().events().len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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

    /// Every reason why an agent cannot perform an action now; empty if it can.
    pub fn refusals(&self, agent: NodeId, action: &Action) -> Vec<Refusal> {
        match self.semantics {
            Semantics::VirtualCity => rule::refusals(&self.graph, agent, action),
            Semantics::VirtualHome => self.memory.refusals(&self.graph, agent, action),
        }
    }

    /// Performs actions of several agents in one step, in order: each sees the effects of those before it.
    ///
    /// # Errors
    /// The first refused action, with every [`Refusal`]; then nothing has changed.
    pub fn step_together(&mut self, actions: &[Event]) -> Result<(), (Event, Vec<Refusal>)> {
        let before = (actions.len() > 1).then(|| self.clone());
        let refused = actions.iter().find_map(|event| Some((*event, self.step(event.agent, &event.action).err()?)));
        if let (Some(before), Some(_)) = (before, &refused) {
            *self = before;
        }
        refused.map_or(Ok(()), Err)
    }

    /// The scene, without the history.
    pub fn into_graph(self) -> SceneGraph {
        self.graph
    }
}
