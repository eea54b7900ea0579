//! An agent that pursues a goal in a scene of which it sees only a part.

use std::collections::VecDeque;

use vc_graph::goal::{Situation, Term};
use vc_graph::{Action, Event, Goal, History, NodeId, Observation, Place, Refusal, SceneGraph, State, Verb, rule};

use crate::compile::{Compiled, anchor};
use crate::demand::Choice;
use crate::look::{Look, best_look};
use crate::manners::Manners;
use crate::packed::Way;
use crate::plan::{Horizon, Planner, Sketch, plan_in_belief};
use crate::search::Effort;
use crate::team::next_trip;
use crate::want::{Unreachable, Want};
use crate::{Belief, Learned, Plan, Prior};

/// After so many searches of everything a faithful agent gives up.
const PATIENCE: usize = 4;
/// So many decisions without learning anything are a sign of going in circles.
const CIRCLES: usize = 300;
/// How often it does the same before it takes that for going in circles.
const AGAIN: usize = 2;
/// How many ways to take a goal's alternatives are tried.
const ALTERNATIVES: usize = 12;
/// How many actions it takes, roughly, to find something.
const SEARCH: usize = 6;

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
    mind: Mind,
    horizon: Horizon,
    planner: Planner,
    /// What it is in the middle of: kept until settled, or proved no longer open.
    pursued: Option<Want>,
    /// What it will do as long as nothing new is learned.
    next: VecDeque<Action>,
    /// Decisions since it last learned something.
    idle: usize,
    /// What it has done since then.
    tried: Vec<Action>,
    /// What others have promised to bring where, and what it promises itself.
    counted_on: Vec<(NodeId, Place)>,
    promises: Vec<(NodeId, Place)>,
}

impl Agent {
    /// An agent that knows the plan of the home and no more, and supposes that things
    /// are where people keep them.
    pub fn newcomer(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::by_prior(graph, id, seed, Prior::Kept), Mind::Best)
    }

    /// As [`Agent::newcomer`], with suppositions of your own.
    pub fn supposing(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64, prior: Prior) -> Self {
        Self::with(id, goal, Belief::by_prior(graph, id, seed, prior), Mind::Best)
    }

    /// The human-like agent of the thesis: every place is equally likely, one state is
    /// sampled, and one subgoal after the other is pursued.
    pub fn faithful(graph: &SceneGraph, id: NodeId, goal: Goal, seed: u64) -> Self {
        Self::with(id, goal, Belief::of_newcomer(graph, id, seed), Mind::Faithful)
    }

    /// An agent that knows everything there is.
    pub fn resident(graph: &SceneGraph, id: NodeId, goal: Goal) -> Self {
        Self::with(id, goal, Belief::of_resident(graph, id), Mind::Best)
    }

    fn with(id: NodeId, goal: Goal, belief: Belief, mind: Mind) -> Self {
        let concerns = concerns(&goal, belief.graph());
        let planner = Planner { effort: Effort { first: 2_000, improve: 500 }, ..Planner::default() };
        Self {
            id,
            goal,
            concerns,
            belief,
            history: History::default(),
            mind,
            horizon: Horizon::NextSubgoal,
            planner,
            pursued: None,
            next: VecDeque::new(),
            idle: 0,
            tried: Vec::new(),
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
    pub fn mannered(mut self, manners: Manners) -> Self {
        self.planner.manners = manners;
        self
    }

    /// How much it searches for each plan.
    #[must_use]
    pub fn trying(mut self, effort: Effort) -> Self {
        self.planner.effort = effort;
        self
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

    /// Takes up another goal, with all it knows.
    pub fn pursue(&mut self, goal: Goal) {
        self.concerns = concerns(&goal, self.belief.graph());
        self.goal = goal;
        self.forget_plans();
        self.idle = 0;
    }

    /// Takes in what it sees.
    pub fn see(&mut self, seen: &Observation) -> Learned {
        let learned = self.belief.observe(seen);
        let matters = |id: &NodeId| self.concerns.binary_search(id).is_ok();
        if learned.found.iter().any(matters) || learned.disproved.iter().any(matters) {
            self.next.clear();
            self.idle = 0;
            self.tried.clear();
        }
        learned
    }

    /// Takes in what another sees and tells.
    pub fn hear(&mut self, told: &Observation) -> Learned {
        self.belief.hear(told)
    }

    /// What others have promised to bring where: that counts as done.
    pub(crate) fn count_on(&mut self, promised: Vec<(NodeId, Place)>) {
        self.planner.awaited = promised.iter().map(|(_, place)| place.at).collect();
        self.counted_on = promised;
        self.next.clear();
    }

    /// What it will bring where on its next trip.
    pub(crate) fn promises(&self) -> &[(NodeId, Place)] {
        &self.promises
    }

    /// The sampled state, with what others have promised done.
    fn imagined(&self) -> SceneGraph {
        let mut graph = self.belief.graph().clone();
        let mut edit = graph.edit();
        for (item, place) in &self.counted_on {
            // What cannot be imagined is not counted on.
            let _ = edit.place(*item, *place);
        }
        edit.commit();
        graph
    }

    /// What it would do now.
    pub fn decide(&mut self) -> Decision {
        let decision = self.think_on();
        self.promises = match &decision {
            Decision::Act(_, plan) => {
                let held: Vec<NodeId> = self.belief.graph().held(self.id).collect();
                next_trip(&held, &plan.actions)
            }
            _ => Vec::new(),
        };
        decision
    }

    /// As [`Agent::think`], but who goes round in circles goes on as the thesis's agent
    /// does: one subgoal after the other.
    fn think_on(&mut self) -> Decision {
        let decision = self.think();
        let Decision::Act(action, _) = &decision else { return decision };
        let again = action.verb != Verb::Walk && self.tried.iter().filter(|a| *a == action).count() >= AGAIN;
        self.tried.push(*action);
        if self.mind == Mind::Faithful || !again {
            return decision;
        }
        self.mind = Mind::Faithful;
        self.next.clear();
        self.decide_by_regression()
    }

    fn think(&mut self) -> Decision {
        let patience = if self.mind == Mind::Faithful { PATIENCE } else { 1 };
        if self.belief.widened() > patience && self.is_missing_something() {
            return Decision::GiveUp(Unreachable::Searched(self.belief.widened()));
        }
        self.idle += 1;
        if self.idle > CIRCLES {
            return Decision::GiveUp(Unreachable::NoPlan(self.goal.to_string()));
        }
        if self.mind == Mind::Faithful {
            return self.decide_by_regression();
        }
        if let Some(action) = self.next.pop_front() {
            if self.refusals(&action).is_empty() {
                let plan = std::iter::once(action).chain(self.next.iter().copied()).collect();
                return Decision::Act(action, Plan { actions: plan, ..Plan::default() });
            }
            self.next.clear();
        }
        self.decide_best()
    }

    fn is_missing_something(&self) -> bool {
        self.concerns.iter().any(|&id| self.belief.is_missing(id))
    }

    fn decide_by_regression(&mut self) -> Decision {
        let intent = (self.pursued, self.planner.tidy());
        let plan = plan_in_belief(&mut self.belief, self.id, &self.goal, self.history.events(), self.horizon, intent);
        self.pursued = plan.as_ref().ok().and_then(|p| p.wants.first()).map(|(want, _)| *want);
        match plan {
            Ok(plan) => match plan.actions.first() {
                Some(&action) => Decision::Act(action, plan),
                None => Decision::Done,
            },
            Err(reason) => Decision::GiveUp(reason),
        }
    }

    /// Plans for what is known; where something is lacking, looks for it unless there
    /// is something to do at hand or the hands are full.
    fn decide_best(&mut self) -> Decision {
        let sketch = match self.best_sketch() {
            Ok(sketch) => sketch,
            Err(reason) => {
                return match self.decide_by_regression() {
                    Decision::GiveUp(_) => Decision::GiveUp(reason),
                    other => other,
                };
            }
        };
        let lacks = &sketch.compiled.lacks;
        if lacks.is_empty() {
            if sketch.compiled.rest {
                return self.decide_with_rest(sketch.actions);
            }
            return self.start(sketch.actions);
        }
        // What is still to be filled is neither closed nor switched on.
        let early = |a: &Action| {
            let ending = matches!(a.verb, Verb::Close | Verb::SwitchOn | Verb::SwitchOff);
            ending && a.object.is_some_and(|id| doors_lacking(&sketch).any(|d| d == id))
        };
        let known = sketch.actions.first().copied().filter(|a| !early(a) && self.is_at_hand(a));
        if let Some(action) = known.or_else(|| self.put_back(&sketch)) {
            return self.act(action, sketch.actions);
        }
        match best_look(&self.belief, self.id, &sketch.compiled, self.planner.manners) {
            Some(Look::Visit(at)) => self.act(Action::one(Verb::Walk, at), Vec::new()),
            Some(Look::Open(at)) => self.go_and(Action::one(Verb::Open, at)),
            Some(Look::Do(action)) => self.go_and(action),
            None => self.decide_by_regression(),
        }
    }

    /// For those with manners, the closing of what was opened in vain, while it is at hand.
    fn put_back(&self, sketch: &Sketch) -> Option<Action> {
        let Compiled { problem, start, .. } = &sketch.compiled;
        let useful = |id: NodeId| {
            let door = problem.doors.iter().position(|d| d.node == id);
            door.and_then(|d| problem.index.doors.get(d))
                .is_some_and(|p| start.piles & p.behind | start.needs & p.through != 0)
        };
        let mut amiss = self.planner.tidy()?.amiss(self.belief.graph());
        amiss.find_map(|(id, was)| {
            let close = Action::one(Verb::Close, id);
            let idle = was == State::Closed && !useful(id) && doors_lacking(sketch).all(|d| d != id);
            (idle && self.is_at_hand(&close)).then_some(close)
        })
    }

    /// Does something after the walk it takes, unless that shows something new.
    fn go_and(&mut self, action: Action) -> Decision {
        let decision = self.act(action, Vec::new());
        if matches!(decision, Decision::Act(first, _) if first.verb == Verb::Walk) {
            self.next = [action].into();
        }
        decision
    }

    /// The alternative of the goal that promises the least to do.
    fn best_sketch(&mut self) -> Result<Sketch, Unreachable> {
        let (mut best, mut reason) = (None::<(usize, Sketch)>, None);
        let mut choice = Choice::default();
        let imagined = (!self.counted_on.is_empty()).then(|| self.imagined());
        let graph = imagined.as_ref().unwrap_or(self.belief.graph());
        let now = Situation { graph, agent: self.id, events: self.history.events() };
        for _ in 0..ALTERNATIVES {
            match self.planner.sketch(&self.goal, &now, self.belief.known(), &mut choice) {
                Ok(sketch) => {
                    let lacking: usize = sketch.compiled.lacks.iter().map(|l| l.number).sum();
                    let cost = sketch.actions.len() + SEARCH * lacking;
                    if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                        best = Some((cost, sketch));
                    }
                }
                Err(why) => reason = reason.or(Some(why)),
            }
            if !choice.advance() {
                break;
            }
        }
        best.map(|(_, sketch)| sketch)
            .ok_or_else(|| reason.unwrap_or_else(|| Unreachable::NoPlan(self.goal.to_string())))
    }

    /// What the packed plan leaves is left to regression, once the plan is done.
    fn decide_with_rest(&mut self, actions: Vec<Action>) -> Decision {
        if actions.is_empty() { self.decide_by_regression() } else { self.start(actions) }
    }

    /// Begins a plan whose rest is kept for the next decisions.
    fn start(&mut self, actions: Vec<Action>) -> Decision {
        match actions.first() {
            // What is left is what others have promised.
            None if !self.counted_on.is_empty() => Decision::Done,
            None => self.decide_by_regression(),
            Some(&first) => {
                let decision = self.act(first, actions.clone());
                if let Decision::Act(action, _) = &decision {
                    // What was put before the plan does not use it up.
                    let used = actions.iter().position(|a| a == action).map_or(0, |i| i + 1);
                    self.next = actions[used..].iter().copied().collect();
                }
                decision
            }
        }
    }

    /// Acts, after what the action needs first: a walk, an opening, a free hand.
    fn act(&mut self, action: Action, plan: Vec<Action>) -> Decision {
        // A walk that is not needed for what comes after it is left out.
        let spared = match plan.as_slice() {
            [walk, then, ..] if walk.verb == Verb::Walk && *walk == action && then.verb != Verb::Walk => {
                self.refusals(then).is_empty().then_some(*then)
            }
            _ => None,
        };
        let first = spared.or_else(|| self.doable(action));
        match first {
            Some(first) => {
                let rest = if plan.is_empty() { vec![action] } else { plan };
                let actions = if rest.first() == Some(&first) { rest } else { [&[first], rest.as_slice()].concat() };
                Decision::Act(first, Plan { actions, ..Plan::default() })
            }
            None => self.decide_by_regression(),
        }
    }

    fn refusals(&self, action: &Action) -> Vec<Refusal> {
        rule::refusals(self.belief.graph(), self.id, action)
    }

    /// Whether an action can be done at once and does not lead away.
    fn is_at_hand(&self, action: &Action) -> bool {
        action.verb != Verb::Walk && self.refusals(action).is_empty()
    }

    /// An action, or what has to be done before it.
    fn doable(&self, mut action: Action) -> Option<Action> {
        for _ in 0..6 {
            let Some(refusal) = self.refusals(&action).into_iter().next() else { return Some(action) };
            action = match refusal {
                Refusal::NotUpright => Action::zero(Verb::Stand),
                Refusal::NotNear { thing, .. } => Action::one(Verb::Walk, anchor(self.belief.graph(), thing.id)),
                Refusal::Hidden { inside, .. } => Action::one(Verb::Open, inside.id),
                Refusal::Shut(container) => Action::one(Verb::Open, container.id),
                Refusal::NoFreeHand => self.put_down()?,
                Refusal::InState(thing, State::On) => Action::one(Verb::SwitchOff, thing.id),
                _ => return None,
            };
        }
        None
    }

    /// Frees a hand: on a surface at hand, else on the floor.
    fn put_down(&self) -> Option<Action> {
        let held = self.belief.graph().held(self.id).last()?;
        let graph = self.belief.graph();
        let near = graph.related(self.id, vc_graph::Relation::Near).filter(|id| {
            graph
                .node(*id)
                .is_some_and(|n| n.affords(vc_graph::Property::Surface) && !n.affords(vc_graph::Property::Graspable))
        });
        let on = near.map(|at| Action::two(Verb::Place, held, at)).find(|a| self.refusals(a).is_empty());
        Some(on.unwrap_or(Action::one(Verb::Drop, held)))
    }

    /// Takes note of what it has done.
    pub fn did(&mut self, action: &Action) {
        self.belief.expect(action);
        self.planner.touched.note(action);
        self.history.push(Event { agent: self.id, action: *action });
    }

    /// Takes note that an action was refused: what it planned does not hold.
    pub fn refused(&mut self, _: &Action) {
        self.forget_plans();
    }

    fn forget_plans(&mut self) {
        self.next.clear();
        self.pursued = None;
    }
}

/// Containers that what is lacking will be put into.
fn doors_lacking(sketch: &Sketch) -> impl Iterator<Item = NodeId> {
    sketch.compiled.lacks.iter().flat_map(|l| &l.ways).filter_map(|way| door(sketch, way))
}

fn door(sketch: &Sketch, way: &Way) -> Option<NodeId> {
    match way {
        Way::Put { door: Some(d), .. } => sketch.compiled.problem.doors.get(*d as usize).map(|d| d.node),
        _ => None,
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
