//! Initial environments: a scene prepared for an activity.
//!
//! The objects of the scene stay. An object that an [`Activity`] needs and the scene lacks comes from a
//! [`Stock`]. Its placement is sampled from the habitual places of its class or from the places that the
//! activity names: on surfaces, in containers, on hooks and floors, wherever it fits beside the present
//! objects, can be reached and does not fulfil the goal. States are set as the activity asks. Then the
//! [`World`] is reset to this scene, and the scene that the world returns is compared with the one
//! requested: the placements and states of all added objects, the start conditions, and that the goal does
//! not hold yet. If they differ, another attempt is made with other random numbers.
//!
//! The same scene, activity and seed give the same result. No object is scaled or removed.
//!
//! ```
//! use vc_graph::{Draft, SceneBuilder, Seed, Simulator};
//! use vc_tasks::initial::{InitialGenerator, PlainStock};
//! use vc_tasks::library::Benchmark;
//!
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! scene.add_in(kitchen, Draft::new("fridge"))?;
//! scene.add_in(kitchen, Draft::new("dining_table"))?;
//! let scene = scene.build();
//!
//! let benchmark = Benchmark::v1();
//! let activity = benchmark.get("put_fridge-02").ok_or("no such task")?;
//! let mut world = Simulator::new(scene.clone());
//! let initial = InitialGenerator::new(&PlainStock).make(activity, &scene, Seed(1), &mut world)?;
//! let added: Vec<String> = initial.added.iter().map(|a| initial.scene.label(a.id).to_string()).collect();
//! assert_eq!(added, ["character.4", "apple.5", "bread.6", "wine.7"]);
//! assert_eq!(initial.credit, 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod attempt;
mod error;
mod fit;
mod site;
mod solid;
mod start;
mod stock;
mod walk;

use vc_graph::goal::Situation;
use vc_graph::{Edge, History, NodeId, Place, Relation, SceneGraph, Seed, State};

use crate::library::Activity;
use crate::{Task, World};
use attempt::{Asked, Attempt, Ground};

pub use error::{InitialError, PlacementReason};
pub use stock::{PlainStock, Stock};

/// The default number of attempts.
const TRIES: usize = 20;

/// A generator of initial environments.
#[derive(Clone, Copy)]
pub struct InitialGenerator<'a> {
    stock: &'a dyn Stock,
    tries: usize,
    distractors: usize,
}

/// A scene prepared for an activity.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Initial {
    /// The scene as the world returned it.
    pub scene: SceneGraph,
    /// The agent of the task.
    pub agent: NodeId,
    /// The task.
    pub task: Task,
    /// The added objects in the order of their insertion: the agent first, if the scene had none.
    pub added: Vec<Added>,
    /// The number of attempts made, counted from one.
    pub tries: usize,
    /// How much of the goal holds at the start, from 0 to below 1.
    pub credit: f64,
}

/// An object that was added to a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Added {
    /// Its node.
    pub id: NodeId,
    /// Its placement; `None` for an object that stands in the room.
    pub place: Option<Place>,
    /// Its room.
    pub room: NodeId,
    /// The reason why it was added.
    pub purpose: Purpose,
}

/// The reason why an object was added.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Purpose {
    /// It is the agent.
    Agent,
    /// The activity needs it.
    Need,
    /// It is a distractor: an object the activity has no use for.
    Distractor,
}

impl<'a> InitialGenerator<'a> {
    /// A generator that takes missing objects from a stock, makes up to 20 attempts and adds no
    /// distractors.
    pub fn new(stock: &'a dyn Stock) -> Self {
        Self { stock, tries: TRIES, distractors: 0 }
    }

    /// Sets the maximal number of attempts; at least one is made.
    #[must_use]
    pub fn tries(self, tries: usize) -> Self {
        Self { tries: tries.max(1), ..self }
    }

    /// Sets the number of distractors, which are objects the activity has no use for.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Seed, Simulator};
    /// use vc_tasks::initial::{InitialGenerator, PlainStock};
    /// use vc_tasks::library::Activity;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let task = r#"[{"number": 1, "title": "cool the milk", "goal": "Inside(milk, fridge)"}]"#;
    /// let activity = Activity::read_list("own", task)?.remove(0);
    /// let graph = scene.build();
    /// let mut world = Simulator::new(graph.clone());
    /// let initial = InitialGenerator::new(&PlainStock).distractors(1).make(&activity, &graph, Seed(1), &mut world)?;
    /// assert_eq!(initial.scene.of_class("milk").len(), 1);
    /// assert!(initial.credit < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn distractors(self, distractors: usize) -> Self {
        Self { distractors, ..self }
    }

    /// Prepares a scene for an activity and resets a world to it.
    ///
    /// Costs some milliseconds for a home with poses, plus the world's reset.
    ///
    /// # Errors
    /// [`InitialError`] with the object, the place and the reason. Errors that do not depend on chance are
    /// returned at once, others after the last attempt.
    pub fn make(
        &self,
        activity: &Activity,
        scene: &SceneGraph,
        seed: Seed,
        world: &mut dyn World,
    ) -> Result<Initial, InitialError> {
        let (written, activity) = (activity, &*activity.expanded(scene.vocabulary()));
        let ground = Ground::from_scene(scene);
        let own = seed.child(&activity.id);
        let mut last = InitialError::StartUnmet(activity.start.to_string());
        for attempt in 0..self.tries {
            let made = Attempt::new(activity, self.stock, scene, &ground, own.nth(attempt as u64));
            let asked = match made.run(self.distractors) {
                Ok(asked) => asked,
                Err(error) if error.is_chance() => {
                    last = error;
                    continue;
                }
                Err(error) => return Err(error),
            };
            let tries = attempt + 1;
            if let Err(error) = world.reset(&asked.scene) {
                last = InitialError::World { error, tries };
                continue;
            }
            match difference(activity, &asked, world.graph()) {
                None => return Ok(asked.confirmed(written, world.graph().clone(), tries)),
                Some(difference) => last = InitialError::Unconfirmed { difference, tries },
            }
        }
        Err(last)
    }
}

impl Asked {
    fn confirmed(self, activity: &Activity, scene: SceneGraph, tries: usize) -> Initial {
        let history = History::default();
        let credit = activity.goal.score(&Situation::new(&scene, self.agent, &history));
        Initial { scene, agent: self.agent, task: activity.task(), added: self.added, tries, credit }
    }
}

/// The first difference between the scene requested and the one that a world returned.
fn difference(activity: &Activity, asked: &Asked, got: &SceneGraph) -> Option<String> {
    let label = |id: NodeId| asked.scene.label(id);
    let misplaced = asked.added.iter().find(|a| !is_there(a, got)).map(|a| match a.place {
        Some(place) => format!("{} is not {} {}", label(a.id), place.relation, label(place.at)),
        None => format!("{} is not in {}", label(a.id), label(a.room)),
    });
    let is = |id: NodeId, state: State| got.node(id).is_some_and(|n| n.is(state));
    let other_state = || {
        let found = asked.states.iter().find(|&&(id, state)| !is(id, state));
        found.map(|&(id, state)| format!("{} is not {state}", label(id)))
    };
    let history = History::default();
    let now = Situation::new(got, asked.agent, &history);
    let unmet = || start::unmet(&now, &activity.start).map(|part| format!("`{part}` does not hold at the start"));
    let met = || activity.goal.holds(&now).then(|| format!("the goal holds already: `{}`", activity.goal));
    misplaced.or_else(other_state).or_else(unmet).or_else(met)
}

fn is_there(added: &Added, got: &SceneGraph) -> bool {
    let placed = added.place.is_none_or(|place| match place.relation {
        // An agent that sits or lies does so on the object it was placed on.
        Relation::SittingOn | Relation::LyingOn | Relation::On | Relation::Inside => {
            got.has(Edge::new(added.id, place.relation, place.at))
        }
        _ => true,
    });
    placed && got.room_of(added.id) == Some(added.room)
}
