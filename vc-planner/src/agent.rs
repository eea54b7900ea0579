//! An agent that pursues a goal in a scene of which it sees only a part.

mod act;
mod company;
mod decide;
mod explore;
mod refused;
mod stages;

use std::collections::VecDeque;

use vc_graph::goal::Term;
use vc_graph::{Action, Event, Goal, History, NodeId, NodeKind, Observation, Place, Property, SceneGraph, Verb};

use crate::agenda::{Agenda, Aim};
use crate::demand::Choice;
use crate::manners::Manners;
use crate::open_condition::{OpenCondition, Unreachable};
use crate::plan::Horizon;
use crate::planner::Planner;
use crate::search::SearchLimits;
use crate::trip::Promise;
use crate::{Belief, Learned, Plan, Prior};
use refused::Refused;

/// A decision of an agent.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::{Agent, Decision};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let mut done = Agent::oracle(&graph, me, "On(apple, kitchen_table)".parse()?);
/// assert!(matches!(done.decide(), Decision::Done));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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

/// How an agent thinks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mind {
    /// As in the thesis: a sampled state, one subgoal after the other by regression.
    Faithful,
    /// The best order of all that is known; looks where it is most worth it.
    Best,
}

/// An agent that believes, plans, does the first action, looks, and plans again.
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
/// let mut agent = Agent::in_known_home(world.graph(), me, "Holds(milk)".parse()?, 7);
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
    /// The goal that it pursues now; for a goal with words of time, the present stage.
    goal: Goal,
    /// The remainder of a goal with words of time, and its present stage.
    agenda: Option<Agenda>,
    aim: Option<Aim>,
    /// How many affordances had been taken from things when the conditions of the present stage began.
    bars: usize,
    /// Why a plan for the present stage was not taken.
    breach: Option<Unreachable>,
    /// The things the goal is about.
    concerns: Vec<NodeId>,
    belief: Belief,
    history: History,
    mind: Mind,
    horizon: Horizon,
    planner: Planner,
    /// The condition that it is bringing about: kept until settled, or proved no longer open.
    pursued: Option<OpenCondition>,
    /// The actions that follow as long as nothing new is learned.
    next: VecDeque<Action>,
    /// The alternative of the goal it is doing so by, if a shorter way is not ruled out.
    unproved: Option<Choice>,
    /// Decisions since it last learned something.
    idle: usize,
    /// The actions that it has decided on since then.
    tried: Vec<Action>,
    refused: Refused,
    /// The deliveries that others have promised, and those that it promises itself.
    counted_on: Vec<Promise>,
    promises: Vec<Promise>,
}

impl Agent {
    /// An agent that knows the plan of the home and no more, and supposes that things
    /// are where people keep them.
    pub fn in_known_home(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::with_prior(graph, id, seed, Prior::Kept), Mind::Best)
    }

    /// As [`Agent::in_known_home`], with suppositions of your own.
    pub fn with_prior(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64, prior: Prior) -> Self {
        Self::with(id, goal, Belief::with_prior(graph, id, seed, prior), Mind::Best)
    }

    /// An agent that knows the rooms and no more: what furniture there is, and which things, it
    /// learns by walking in.
    pub fn in_unknown_home(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::in_unknown_home(graph, id, seed, Prior::Kept), Mind::Best)
    }

    /// The human-like agent of the thesis: every place is equally likely, one state is
    /// sampled, and one subgoal after the other is pursued.
    pub fn faithful(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::in_known_home(graph, id, seed), Mind::Faithful)
    }

    /// An agent that knows everything there is.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_planner::{Agent, Decision};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut agent = Agent::oracle(&graph, me, "Holds(apple)".parse()?);
    /// assert!(matches!(agent.decide(), Decision::Act(_, plan) if plan.actions.len() == 2), "walk there and grab it");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn oracle(graph: &SceneGraph, id: NodeId, goal: Goal) -> Self {
        Self::with(id, goal, Belief::oracle(graph, id), Mind::Best)
    }

    fn with(id: NodeId, goal: Goal, belief: Belief, mind: Mind) -> Self {
        let goal = goal.expanded(belief.graph().vocabulary()).into_owned();
        let concerns = concerns(&goal, belief.graph());
        let agenda = goal.is_temporal().then(|| Agenda::new(&goal));
        let planner = Planner { limits: SearchLimits { first: 2_000, improve: 500 }, ..Planner::default() };
        Self {
            id,
            goal,
            agenda,
            aim: None,
            bars: 0,
            breach: None,
            concerns,
            belief,
            history: History::default(),
            mind,
            horizon: Horizon::NextSubgoal,
            planner,
            pursued: None,
            next: VecDeque::new(),
            unproved: None,
            idle: 0,
            tried: Vec::new(),
            refused: Refused::default(),
            counted_on: Vec::new(),
            promises: Vec::new(),
        }
    }

    /// Makes a faithful agent plan to the goal each time, not only to the next subgoal.
    #[must_use]
    pub fn planning(self, horizon: Horizon) -> Self {
        Self { horizon, ..self }
    }

    /// How it leaves the home.
    #[must_use]
    pub fn with_manners(mut self, manners: Manners) -> Self {
        self.planner.manners = manners;
        self
    }

    /// How much it searches for each plan.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_planner::{Agent, SearchLimits};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let agent = Agent::oracle(&graph, me, "Holds(apple)".parse()?).with_limits(SearchLimits::FIRST_ANSWER);
    /// assert_eq!(agent.goal().to_string(), "Holds(me, apple)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_limits(mut self, limits: SearchLimits) -> Self {
        self.planner.limits = limits;
        self
    }

    /// The agent's belief.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// use vc_planner::Agent;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut agent = Agent::in_known_home(&graph, me, "Holds(milk)".parse()?, 1);
    /// agent.see(&graph.observe(me, Scope::Room));
    /// let places = agent.belief().distribution(milk);
    /// assert!(!places.is_empty(), "the milk is out of sight");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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

    /// The whole goal that it pursues, with the definitions of derived predicates in their place.
    pub fn goal(&self) -> &Goal {
        self.agenda.as_ref().map_or(&self.goal, Agenda::goal)
    }

    /// Takes up another goal, with all it knows.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_planner::{Agent, Decision};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut agent = Agent::oracle(&graph, me, "Holds(apple)".parse()?);
    /// agent.pursue("On(apple, kitchen_table)".parse()?);
    /// assert!(matches!(agent.decide(), Decision::Done));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pursue(&mut self, goal: Goal) {
        let goal = goal.expanded(self.belief.graph().vocabulary()).into_owned();
        self.concerns = concerns(&goal, self.belief.graph());
        (self.agenda, self.aim) = (goal.is_temporal().then(|| Agenda::new(&goal)), None);
        self.goal = goal;
        self.promises.clear();
        self.forget_plans();
        self.idle = 0;
    }

    /// Takes in what it sees.
    pub fn see(&mut self, seen: &Observation) -> Learned {
        self.refused.see(seen);
        let learned = self.belief.observe(seen);
        if self.belief.is_in_unknown_home() && !learned.found.is_empty() {
            self.concerns = concerns(self.goal(), self.belief.graph());
        }
        let matters = |id: &NodeId| self.concerns.binary_search(id).is_ok();
        if learned.found.iter().any(matters) || learned.disproved.iter().any(matters) {
            self.next.clear();
            self.idle = 0;
            self.tried.clear();
        }
        learned
    }

    /// Takes in an observation that another agent reports.
    pub(crate) fn hear(&mut self, report: &Observation) -> Learned {
        self.belief.hear(report)
    }

    /// The decision that it would make now. For a goal with words of time it pursues the stages that these make (the
    /// parts of a `then` in their order, what is to hold at some step before what is to hold at the end), and it takes
    /// no plan that breaks an `always`, an `until` or a `before`: if it finds no other, it gives up and says which part
    /// stands in the way.
    pub fn decide(&mut self) -> Decision {
        self.keep_promises();
        let decision = match self.agenda.take() {
            None => self.think_twice(),
            Some(mut agenda) => {
                let decision = self.decide_in_time(&mut agenda);
                self.agenda = Some(agenda);
                decision
            }
        };
        if let Decision::Act(_, plan) = &decision {
            self.promise(plan);
        }
        decision
    }

    /// Takes note of what it has done.
    pub fn did(&mut self, action: &Action) {
        self.belief.expect(action);
        self.planner.touched.note(action);
        self.refused.did(action);
        self.history.push(Event { agent: self.id, action: *action });
    }

    /// Takes note that an action was refused: what it planned does not hold, and while nothing changes it does
    /// not try that again; once it was refused three times, not at all.
    pub fn refused(&mut self, action: &Action) {
        self.refused.note(action);
        self.forget_plans();
    }

    /// Walks up to what an action is done to, and does it again from there.
    pub(crate) fn go_back_to(&mut self, action: &Action) {
        let at = action.target.or(action.object).filter(|_| action.verb != Verb::Walk);
        let walk = at.map(|at| Action::one(Verb::Walk, crate::compile::anchor(self.belief.graph(), at)));
        self.next = walk.into_iter().chain([*action]).collect();
    }

    /// Expects of a thing no more what bodies could not do with it: another is taken, another
    /// place is found. Whether there was something to expect.
    pub fn bar(&mut self, action: &Action) -> bool {
        // A container that is full stands open: that it cannot be shut any more is left out of account.
        const ENCLOSES: &[Property] =
            &[Property::Container, Property::Recipient, Property::Openable, Property::Drivable];
        let (properties, id): (&[Property], NodeId) = match (action.verb, action.object, action.target) {
            (Verb::Grab, Some(id), _) => (&[Property::Graspable], id),
            (Verb::Walk | Verb::Run | Verb::Find, Some(id), _) => return self.avoid(id),
            // Nothing gets into what stays shut.
            (Verb::Open, Some(id), _) => (ENCLOSES, id),
            (Verb::Close, Some(id), _) => (&[Property::Openable], id),
            (Verb::SwitchOn | Verb::SwitchOff, Some(id), _) => (&[Property::Switchable], id),
            (Verb::Sit, Some(id), _) => (&[Property::Sittable], id),
            (Verb::Lie, Some(id), _) => (&[Property::Lieable], id),
            (Verb::Place, _, Some(at)) => (Property::CARRYING, at),
            (Verb::PutIn, _, Some(into)) => (ENCLOSES, into),
            _ => return false,
        };
        self.forget_plans();
        // Things that are shut away behind it are out of reach.
        let excluded = action.verb == Verb::Open && self.belief.exclude(id);
        properties.iter().fold(excluded, |barred, property| self.belief.bar(id, *property) | barred)
    }

    /// Plans no more with a thing there is no way to.
    fn avoid(&mut self, id: NodeId) -> bool {
        self.forget_plans();
        let excluded = self.belief.exclude(id);
        let all = Property::CARRYING.iter().copied().chain([Property::Graspable, Property::Switchable]);
        let there = self.belief.graph().node(id).is_some_and(|n| n.kind() == NodeKind::Object);
        all.filter(|_| there).fold(excluded, |barred, property| self.belief.bar(id, property) | barred)
    }

    fn forget_plans(&mut self) {
        self.next.clear();
        self.pursued = None;
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
