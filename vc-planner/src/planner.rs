//! Planning: the best order of macros, and what is left by regression.

use vc_graph::goal::{Goal, Situation};
use vc_graph::{Action, Event, History, Node, NodeId, Place, SceneGraph};

use crate::compile::{Compiled, compile};
use crate::demand::{Choice, Demands, Reader};
use crate::expansion::Expansion;
use crate::manners::{Leave, Manners, Touched};
use crate::open_condition::{OpenCondition, Unreachable};
use crate::packed::Op;
use crate::plan::{Horizon, Plan};
use crate::regression::Regression;
use crate::search::{Found, Search, SearchLimits};
use crate::{Belief, KnownNodes};

/// Plans for an agent in a scene it knows entirely, with the usual limits and no
/// manners; see [`Planner`].
///
/// Words of time are read as [`Goal::holds`] reads them in one situation: earlier states are taken to be as the present
/// one. An [`Agent`](crate::Agent) and the policies made of it pursue such goals by stages.
///
/// ```
/// use vc_graph::{Draft, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut graph = scene.build();
/// let goal = "On(apple, kitchen_table) & Closed(fridge)".parse()?;
/// let plan = vc_planner::plan(&mut graph, me, &goal, &History::default())?;
/// let steps: Vec<String> = plan.actions.iter().map(|a| a.describe(&graph).to_string()).collect();
/// assert_eq!(steps, [
///     "walk fridge.3", "open fridge.3", "grab apple.4", "close fridge.3",
///     "walk kitchen_table.2", "place apple.4 kitchen_table.2",
/// ]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Unreachable`] says which part of the goal cannot be brought about.
pub fn plan(graph: &mut SceneGraph, agent: NodeId, goal: &Goal, history: &History) -> Result<Plan, Unreachable> {
    Planner::default().plan(graph, agent, goal, history.events())
}

/// How many ways to take a goal's alternatives are tried.
const ALTERNATIVES: usize = 24;
/// How many parts a goal too large to be packed at once is planned in.
const PARTS: usize = 64;

/// A planner with its memory, kept from one plan to the next.
///
/// The goal is packed: deliveries, doors, switches and what is done to single things
/// become a small search problem, solved by weighted A* and then improved. The parts
/// beyond it (postures, upper bounds, orders, cooking ...) are added by regression
/// through the transition rule. Every plan is carried out on the scene by the rule and
/// taken back, so that each can be carried out as it is.
#[derive(Debug, Clone, Default)]
pub struct Planner {
    pub(crate) search: Search,
    /// How much it searches.
    pub limits: SearchLimits,
    /// How it leaves the home.
    pub manners: Manners,
    /// The things that it has opened and switched so far, with their earlier states.
    pub(crate) touched: Touched,
    /// The places to which another agent is bringing something.
    pub(crate) awaited: Vec<NodeId>,
    /// Others pursue the goal as well: one tells them what one does next, and does that.
    pub(crate) in_company: bool,
}

impl Planner {
    /// A planner that searches so much, without manners.
    pub fn with_limits(limits: SearchLimits) -> Self {
        Self { limits, ..Self::default() }
    }

    /// The things that have been touched, for planners that put them back.
    pub(crate) fn tidy(&self) -> Option<&Touched> {
        (self.manners == Manners::Tidy).then_some(&self.touched)
    }

    fn leave(&self) -> Leave<'_> {
        Leave { tidy: self.tidy(), awaited: &self.awaited, in_company: self.in_company }
    }

    /// Plans to the goal with full knowledge. The scene is put back before this
    /// returns.
    ///
    /// # Errors
    /// [`Unreachable`] says which part of the goal cannot be brought about.
    pub fn plan(
        &mut self,
        graph: &mut SceneGraph,
        agent: NodeId,
        goal: &Goal,
        events: &[Event],
    ) -> Result<Plan, Unreachable> {
        let goal = &*goal.expanded(graph.vocabulary());
        if let Some(mismatch) = goal.name_mismatches(graph).into_iter().next() {
            return Err(mismatch.into());
        }
        let is_tidy = self.tidy().is_none_or(|touched| touched.amiss(graph).next().is_none());
        if is_tidy && goal.holds(&Situation { graph, agent, events }) {
            return Ok(Plan { proved: true, ..Plan::default() });
        }
        let mut offers = Offers::default();
        let general = self.pack(graph, agent, goal, events, &mut offers);
        if general || offers.best.is_none() {
            let known: KnownNodes = graph.nodes().map(Node::id).collect();
            let mut way = Regression::new(graph, agent, &known, events, goal).tidying(self.tidy());
            let plan = way.work(goal, Horizon::Goal, None);
            offers.add(plan.map(|plan| (way.amiss().len(), plan)));
            way.rewind(0);
        }
        offers.best(goal)
    }

    /// Offers the plans by packing for the alternatives of a goal; whether some of it was regressed for one.
    fn pack(
        &mut self,
        graph: &mut SceneGraph,
        agent: NodeId,
        goal: &Goal,
        events: &[Event],
        offers: &mut Offers,
    ) -> bool {
        let (mut choice, mut general) = (Choice::default(), false);
        for _ in 0..ALTERNATIVES {
            for regress_postures in [false, true] {
                let made = self.attempt(graph, agent, goal, events, (&mut choice, regress_postures));
                let packed_posture = made.as_ref().map_or(true, |(_, left)| left.posture);
                general |= made.as_ref().is_ok_and(|(_, left)| left.rest);
                offers.add(made.map(|(plan, left)| (left.amiss, plan)));
                if !packed_posture {
                    break;
                }
            }
            if !choice.advance() {
                break;
            }
        }
        general
    }

    /// A plan for what of a goal can be packed, by the first of its alternatives and
    /// without carrying it out: microseconds, for those who plan often. It is not
    /// checked against the transition rule; [`Planner::plan`] is.
    ///
    /// # Errors
    /// [`Unreachable`] says which part of the goal cannot be brought about.
    pub fn outline(
        &mut self,
        graph: &SceneGraph,
        agent: NodeId,
        goal: &Goal,
        events: &[Event],
    ) -> Result<Vec<Action>, Unreachable> {
        let goal = &*goal.expanded(graph.vocabulary());
        let now = Situation { graph, agent, events };
        let demands = Reader::read(goal, &now, &mut Choice::default());
        let compiled = compile(&demands, &now, &|_| true, self.leave())?;
        let (ops, _) = self.solve(&compiled, goal)?;
        Ok(Expansion::write(&compiled.problem, compiled.start, &ops))
    }

    /// One choice of alternatives: packed, carried out, and what is left regressed.
    fn attempt(
        &mut self,
        graph: &mut SceneGraph,
        agent: NodeId,
        goal: &Goal,
        events: &[Event],
        (choice, regress_postures): (&mut Choice, bool),
    ) -> Result<(Plan, Left), Unreachable> {
        let now = Situation { graph, agent, events };
        let demands = Demands { regress_postures, ..Reader::read(goal, &now, choice) };
        let compiled = compile(&demands, &now, &|_| true, self.leave())?;
        let (ops, proved) = self.solve(&compiled, goal)?;
        let actions = Expansion::write(&compiled.problem, compiled.start, &ops);
        let known: KnownNodes = graph.nodes().map(Node::id).collect();
        let touched = self.tidy().cloned();
        let mut way = Regression::new(graph, agent, &known, events, goal).tidying(touched.as_ref());
        let posture = compiled.problem.last != 0;
        let mut rest = !way.follow(&actions) || compiled.rest;
        if compiled.more {
            rest = !self.go_on(&mut way, goal, choice);
        }
        if !rest && way.holds(goal) {
            way.keep_in_hand(goal);
            // A seat may be at hand without a walk, which is not packed.
            let plan = Plan { actions: way.actions(), conditions: Vec::new(), proved: proved && !posture };
            let amiss = way.amiss().len();
            way.rewind(0);
            return Ok((plan, Left { rest, posture, amiss }));
        }
        rest |= !way.holds(goal);
        let plan = way.work(goal, Horizon::Goal, None);
        let amiss = way.amiss().len();
        way.rewind(0);
        Ok((plan?, Left { rest, posture, amiss }))
    }

    /// Packs and does what is left of a goal too large to be packed at once, part by part;
    /// whether that was all of it.
    fn go_on(&mut self, way: &mut Regression<'_>, goal: &Goal, choice: &mut Choice) -> bool {
        for _ in 0..PARTS {
            let now = way.now();
            let compiled = compile(&Reader::read(goal, &now, choice), &now, &|_| true, self.leave());
            let Ok(compiled) = compiled else { return false };
            let Ok((ops, _)) = self.solve(&compiled, goal) else { return false };
            let actions = Expansion::write(&compiled.problem, compiled.start, &ops);
            if !way.follow(&actions) {
                return false;
            }
            if actions.is_empty() || !compiled.more {
                return !compiled.rest;
            }
        }
        false
    }

    /// Macros for a packed problem, and whether they are proved to be the best.
    pub(crate) fn solve(&mut self, compiled: &Compiled, goal: &Goal) -> Result<(Vec<Op>, bool), Unreachable> {
        match self.search.solve(&compiled.problem, compiled.start, self.limits) {
            Found::Way { ops, best, .. } => Ok((ops, best)),
            Found::Exhausted(_) if compiled.conflicts() => Err(Unreachable::Conflicting(goal.to_string())),
            Found::Exhausted(checked) => Err(Unreachable::SearchExhausted { goal: goal.to_string(), checked }),
            Found::Unfinished(_) => Ok((Vec::new(), false)),
        }
    }

    /// The first macros of a goal from what is known, without carrying them out: what
    /// an agent does next. Nothing of the scene is copied.
    pub(crate) fn sketch(
        &mut self,
        goal: &Goal,
        now: &Situation<'_>,
        known: &KnownNodes,
        choice: &mut Choice,
    ) -> Result<Sketch, Unreachable> {
        let compiled = compile(&demands_in_view(goal, now, choice), now, &|id| known.contains(id), self.leave())?;
        let (ops, proved) = self.solve(&compiled, goal)?;
        let actions = Expansion::write(&compiled.problem, compiled.start, &ops);
        Ok(Sketch { compiled, actions, proved })
    }

    /// The rest of a plan in fewer actions than it has, with half the effort of improving
    /// a new one.
    pub(crate) fn refine(
        &mut self,
        goal: &Goal,
        now: &Situation<'_>,
        known: &KnownNodes,
        choice: &mut Choice,
        than: usize,
    ) -> Refined {
        let compiled = compile(&demands_in_view(goal, now, choice), now, &|id| known.contains(id), self.leave());
        let Some(Compiled { problem, start, .. }) = compiled.ok().filter(|c| !c.rest && c.lacks.is_empty()) else {
            return Refined::Best;
        };
        match self.search.shorter(&problem, start, than, self.limits.improve / 2) {
            Found::Way { ops, best, .. } => Refined::Shorter(Expansion::write(&problem, start, &ops), best),
            Found::Exhausted(_) => Refined::Best,
            Found::Unfinished(_) => Refined::Unknown,
        }
    }
}

/// The demands of a goal; where poses say what is at hand, it is regression that sees it.
fn demands_in_view<'g>(goal: &'g Goal, now: &Situation<'_>, choice: &mut Choice) -> Demands<'g> {
    let regress_postures = now.graph.node(now.agent).is_some_and(|n| n.pose().is_some());
    Demands { regress_postures, ..Reader::read(goal, now, choice) }
}

/// The best of some plans, and the first reason why one was not found.
#[derive(Default)]
struct Offers {
    /// The tidiest, then the shortest: how many things are not left as they were, and the plan.
    best: Option<(usize, Plan)>,
    reason: Option<Unreachable>,
}

impl Offers {
    fn add(&mut self, made: Result<(usize, Plan), Unreachable>) {
        let better = |(amiss, plan): &(usize, Plan)| {
            let is_less = |(least, best): &(usize, Plan)| (*amiss, plan.actions.len()) < (*least, best.actions.len());
            self.best.as_ref().is_none_or(is_less)
        };
        match made {
            Ok(plan) if better(&plan) => self.best = Some(plan),
            Ok(_) => {}
            Err(why) => self.reason = self.reason.take().or(Some(why)),
        }
    }

    fn best(self, goal: &Goal) -> Result<Plan, Unreachable> {
        let none = || self.reason.unwrap_or_else(|| Unreachable::NoPlan(goal.to_string()));
        self.best.map(|(_, plan)| plan).ok_or_else(none)
    }
}

/// The packed part of an attempt and the part that it left.
struct Left {
    /// Some of the goal was regressed.
    rest: bool,
    /// A posture was packed.
    posture: bool,
    /// How many doors and switches are not left as they were.
    amiss: usize,
}

/// A plan not yet carried out, for what is known.
#[derive(Debug)]
pub(crate) struct Sketch {
    pub(crate) compiled: Compiled,
    pub(crate) actions: Vec<Action>,
    /// No plan of the packed problem is shorter.
    pub(crate) proved: bool,
}

/// The outcome of the search for a shorter plan.
#[derive(Debug)]
pub(crate) enum Refined {
    /// A shorter one, and whether none is shorter still.
    Shorter(Vec<Action>, bool),
    /// None is shorter.
    Best,
    /// None was found.
    Unknown,
}

/// Plans for an agent by regression alone, in the state that the agent believes in. The agent
/// goes on with the subgoal that it pursued before, if that is still open, and puts back the
/// things that it has touched, if it has manners.
///
/// # Errors
/// As [`plan`].
pub(crate) fn plan_in_belief(
    belief: &mut Belief,
    agent: NodeId,
    goal: &Goal,
    events: &[Event],
    horizon: Horizon,
    (pursued, touched): (Option<OpenCondition>, Option<&Touched>),
) -> Result<Plan, Unreachable> {
    let unseen: Vec<Place> = belief.possible_places().collect();
    let (graph, known) = belief.sampled_and_known();
    Regression::new(graph, agent, known, events, goal).tidying(touched).doubting(&unseen).run(goal, horizon, pursued)
}
