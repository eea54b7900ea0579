//! An agent that pursues a goal in a scene of which it sees only a part.

use vc_graph::{Action, Event, Goal, History, NodeId, Observation, Place, SceneGraph, goal::Term};

use crate::plan::{Horizon, plan_in_belief};
use crate::want::{Unreachable, Want};
use crate::{Belief, Learned, Plan};

/// After so many searches of everything an agent gives up.
const PATIENCE: usize = 4;

/// What an agent decides.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Decision {
    /// To do something; the plan begins with it.
    Act(Action, Plan),
    /// The goal holds, as far as it can tell.
    Done,
    /// There is no way.
    GiveUp(Unreachable),
}

/// The human-like agent of the thesis: it believes, plans, does the first action,
/// looks, and plans again.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Scope, Simulator};
/// use vc_planner::{Agent, Decision};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
///
/// let mut agent = Agent::newcomer(world.graph(), me, "Holds(milk)".parse()?, 7);
/// loop {
///     let seen = world.graph().observe(me, Scope::Room);
///     agent.see(&seen);
///     match agent.decide() {
///         Decision::Act(action, _) => {
///             world.step(me, &action).map_err(|r| r[0].clone())?;
///             agent.did(&action);
///         }
///         _ => break,
///     }
/// }
/// assert!(world.graph().held(me).any(|h| h == milk));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Agent {
    id: NodeId,
    goal: Goal,
    /// The things the goal is about.
    concerns: Vec<NodeId>,
    belief: Belief,
    history: History,
    horizon: Horizon,
    /// What it is in the middle of: kept until settled, or proved no longer open.
    pursued: Option<Want>,
}

impl Agent {
    /// An agent that knows the plan of the home and no more.
    pub fn newcomer(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::of_newcomer(graph, id, seed))
    }

    /// An agent that knows everything there is.
    pub fn resident(graph: &SceneGraph, id: NodeId, goal: Goal) -> Self {
        Self::with(id, goal, Belief::of_resident(graph, id))
    }

    fn with(id: NodeId, goal: Goal, belief: Belief) -> Self {
        let concerns = concerns(&goal, belief.graph());
        Self { id, goal, concerns, belief, history: History::default(), horizon: Horizon::NextSubgoal, pursued: None }
    }

    /// Makes it plan to the goal each time, not only to the next subgoal.
    #[must_use]
    pub fn planning(self, horizon: Horizon) -> Self {
        Self { horizon, ..self }
    }

    /// What it believes.
    pub fn belief(&self) -> &Belief {
        &self.belief
    }

    /// The things the goal is about whose place it can only guess, with the guess;
    /// `None` for somewhere in a room.
    pub fn guesses(&self) -> Vec<(NodeId, Option<Place>)> {
        let graph = self.belief.graph();
        let missing = self.concerns.iter().filter(|&&id| self.belief.is_missing(id));
        missing.map(|&id| (id, graph.place(id))).collect()
    }

    /// What it pursues.
    pub fn goal(&self) -> &Goal {
        &self.goal
    }

    /// Takes in what it sees.
    pub fn see(&mut self, seen: &Observation) -> Learned {
        self.belief.observe(seen)
    }

    /// What it would do now.
    pub fn decide(&mut self) -> Decision {
        if self.belief.widened() > PATIENCE {
            return Decision::GiveUp(Unreachable::Searched(self.belief.widened()));
        }
        let plan =
            plan_in_belief(&mut self.belief, self.id, &self.goal, self.history.events(), self.horizon, self.pursued);
        self.pursued = plan.as_ref().ok().and_then(|p| p.wants.first()).map(|(want, _)| *want);
        match plan {
            Ok(plan) => match plan.actions.first() {
                Some(&action) => Decision::Act(action, plan),
                None => Decision::Done,
            },
            Err(reason) => Decision::GiveUp(reason),
        }
    }

    /// Takes note of what it has done.
    pub fn did(&mut self, action: &Action) {
        self.belief.expect(action);
        self.history.push(Event { agent: self.id, action: *action });
    }
}

/// The things the literals of a goal can be about.
fn concerns(goal: &Goal, graph: &SceneGraph) -> Vec<NodeId> {
    let mut found: Vec<NodeId> = goal
        .terms()
        .iter()
        .flat_map(|term| match term {
            Term::Class(class) => graph.of_class(class),
            Term::Node(_, id) => vec![*id],
            _ => Vec::new(),
        })
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}
