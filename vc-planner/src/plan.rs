//! The regression planner: backwards from what is wanted to what can be done now.

use vc_graph::goal::{Goal, Situation};
use vc_graph::{Action, ChangeSet, Condition, Event, NodeId, Property, SceneGraph, Verb, rule};

use crate::subgoal::View;
use crate::want::{Unreachable, Want};
use crate::weigh::Hints;
use crate::{Belief, Known};

/// How many actions a plan may hold, tried ones included.
const BUDGET: usize = 4000;
/// How deep an action may need another.
const DEPTH: usize = 12;
/// How often an action's needs are met again when meeting one undid another.
const ROUNDS: usize = 3;
/// How many options of a subgoal are tried.
const OPTIONS: usize = 48;

/// How far ahead to plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Horizon {
    /// Until the next subgoal is met: enough to know what to do now.
    NextSubgoal,
    /// Until the goal is met.
    Goal,
}

/// What to do, in order. Empty when the goal is known to hold.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Plan {
    /// The actions.
    pub actions: Vec<Action>,
    /// What each stretch of them is for, with how many actions it has.
    pub wants: Vec<(Want, usize)>,
}

/// Plans for an agent in a scene it knows entirely.
///
/// Works backwards: what the goal wants, which actions bring it about, what they
/// need, which actions bring that about, and so on, through the transition rule of
/// [`vc_graph::rule`]. Each action found is tried on the scene, so that every plan
/// can be carried out as it is; the scene is put back before this returns.
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
///     "walk fridge.3", "open fridge.3", "grab apple.4",
///     "walk kitchen_table.2", "place apple.4 kitchen_table.2",
///     "walk fridge.3", "close fridge.3",
/// ]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Unreachable`] says which part of the goal cannot be brought about.
pub fn plan(
    graph: &mut SceneGraph,
    agent: NodeId,
    goal: &Goal,
    history: &vc_graph::History,
) -> Result<Plan, Unreachable> {
    let known: Known = graph.nodes().map(vc_graph::Node::id).collect();
    Search::new(graph, agent, &known, history.events(), goal).run(goal, Horizon::Goal, None)
}

/// Plans for an agent in the state it believes in. What it pursued before it goes
/// on pursuing, if that is still open.
///
/// # Errors
/// As [`plan`].
pub(crate) fn plan_in_belief(
    belief: &mut Belief,
    agent: NodeId,
    goal: &Goal,
    events: &[Event],
    horizon: Horizon,
    pursued: Option<Want>,
) -> Result<Plan, Unreachable> {
    let (graph, known) = belief.sampled_and_known();
    Search::new(graph, agent, known, events, goal).run(goal, horizon, pursued)
}

/// A search in progress, which tries actions on the graph and takes them back.
struct Search<'a> {
    graph: &'a mut SceneGraph,
    agent: NodeId,
    known: &'a Known,
    hints: Hints,
    events: Vec<Event>,
    done_before: usize,
    trail: Vec<ChangeSet>,
    /// What is being brought about, outermost first: what is needed to bring
    /// about itself is no help.
    open: Vec<Condition>,
    budget: usize,
    /// The plan ends here: what comes next depends on what is seen.
    cut: bool,
}

impl<'a> Search<'a> {
    fn new(graph: &'a mut SceneGraph, agent: NodeId, known: &'a Known, events: &[Event], goal: &Goal) -> Self {
        Self {
            graph,
            agent,
            known,
            hints: Hints::of(goal),
            events: events.to_vec(),
            done_before: events.len(),
            trail: Vec::new(),
            open: Vec::new(),
            budget: BUDGET,
            cut: false,
        }
    }

    fn run(mut self, goal: &Goal, horizon: Horizon, pursued: Option<Want>) -> Result<Plan, Unreachable> {
        let result = self.work(goal, horizon, pursued);
        self.rewind(0);
        result
    }

    fn view(&self) -> View<'_> {
        let now = Situation { graph: self.graph, agent: self.agent, events: &self.events };
        View { now, known: self.known, hints: &self.hints }
    }

    fn work(&mut self, goal: &Goal, horizon: Horizon, mut pursued: Option<Want>) -> Result<Plan, Unreachable> {
        let mut wants = Vec::new();
        loop {
            let subgoals = self.view().subgoals(goal)?;
            if self.cut || subgoals.is_empty() || (horizon == Horizon::NextSubgoal && !self.trail.is_empty()) {
                return Ok(Plan { actions: self.actions(), wants });
            }
            let before = self.trail.len();
            let options = || subgoals.iter().flat_map(|s| s.options.iter().take(OPTIONS));
            let kept = pursued.take().filter(|want| options().any(|o| o == want));
            let Some(want) = kept.into_iter().chain(options().copied()).find(|want| self.settle(want)) else {
                let open = subgoals.iter().filter_map(|s| s.options.first()).take(3).map(|w| self.describe(w));
                return Err(Unreachable::NoPlan(open.collect::<Vec<_>>().join("; ")));
            };
            wants.push((want, self.trail.len() - before));
            // A look ends the plan: only an observation can tell what is there.
            if matches!(want, Want::See(_)) {
                return Ok(Plan { actions: self.actions(), wants });
            }
        }
    }

    fn describe(&self, want: &Want) -> String {
        match want {
            Want::Do(action) => action.describe(self.graph).to_string(),
            Want::See(id) => format!("see {}", self.graph.label(*id)),
            Want::Hold(condition) => match condition.check(self.graph, self.agent) {
                Err(refusal) => format!("({refusal})"),
                Ok(()) => want.to_string(),
            },
        }
    }

    fn actions(&self) -> Vec<Action> {
        self.events[self.done_before..].iter().map(|e| e.action).collect()
    }

    /// Settles a want by actions, or leaves everything as it was.
    fn settle(&mut self, want: &Want) -> bool {
        let mark = self.trail.len();
        let settled = match want {
            Want::Hold(condition) => self.achieve(condition) && self.trail.len() > mark,
            Want::Do(action) => self.act(action),
            Want::See(id) => self.come_to_see(*id),
        };
        if !settled {
            self.rewind(mark);
            self.cut = false;
        }
        settled
    }

    /// Goes where a thing is believed to be, and opens what it is believed in.
    fn come_to_see(&mut self, id: NodeId) -> bool {
        if self.graph.room_of(id) == self.graph.room_of(self.agent) && self.graph.hidden_in(id).is_some() {
            return self.achieve(&Condition::Accessible(id));
        }
        let room = self.graph.room_of(id);
        let walk = room.map(|room| Action::one(Verb::Walk, room));
        walk.is_some_and(|walk| self.act(&walk))
    }

    /// Makes a condition true by actions, or leaves everything as it was.
    fn achieve(&mut self, want: &Condition) -> bool {
        if want.holds(self.graph, self.agent) {
            return true;
        }
        if self.open.len() >= DEPTH || self.open.contains(want) {
            return false;
        }
        let mark = self.trail.len();
        self.open.push(*want);
        let candidates = self.ways(want);
        let mut achieved = false;
        for action in candidates {
            // Some conditions take several actions: an object that is to be in
            // another room is grabbed, carried there and put down.
            achieved = self.act(&action) && (self.cut || want.holds(self.graph, self.agent) || self.go_on(want));
            if achieved || self.budget == 0 {
                break;
            }
            self.rewind(mark);
        }
        self.open.pop();
        if !achieved {
            self.rewind(mark);
        }
        achieved
    }

    /// Actions that bring a condition about. What can be anywhere and has not been
    /// seen cannot be walked up to: one goes to the place where it is believed to
    /// be. On the floor of a room that is the room, and only there can one see on.
    fn ways(&mut self, want: &Condition) -> Vec<Action> {
        match *want {
            Condition::Near(id) if self.is_missing(id) => {
                let room = || self.graph.room_of(id).filter(|&r| Some(r) != self.graph.room_of(self.agent));
                let place = self.graph.place(id).map(|p| p.at);
                self.cut = place.is_none() && room().is_some();
                place.or_else(room).map(|at| Action::one(Verb::Walk, at)).into_iter().collect()
            }
            _ => rule::regress::achievers(self.graph, self.agent, want),
        }
    }

    /// Whether a thing is one that can be anywhere, and where it is is a guess.
    fn is_missing(&self, id: NodeId) -> bool {
        !self.known.contains(id) && self.graph.node(id).is_some_and(|n| n.affords(Property::Graspable))
    }

    /// Goes on with a condition that an action has brought nearer.
    fn go_on(&mut self, want: &Condition) -> bool {
        for _ in 0..ROUNDS {
            let Some(action) = self.ways(want).into_iter().next() else {
                return false;
            };
            if !self.act(&action) {
                return false;
            }
            if self.cut || want.holds(self.graph, self.agent) {
                return true;
            }
        }
        false
    }

    /// Does an action after making true what it needs, or leaves everything as it
    /// was.
    fn act(&mut self, action: &Action) -> bool {
        let mark = self.trail.len();
        let needs = rule::preconditions(action);
        for _ in 0..ROUNDS {
            let unmet = |s: &Self| needs.iter().find(|c| !c.holds(s.graph, s.agent)).copied();
            while let Some(need) = unmet(self) {
                let before = self.trail.len();
                if !self.achieve(&need) || self.trail.len() == before {
                    self.rewind(mark);
                    return false;
                }
                if self.cut || self.trail.len() - mark > 4 * DEPTH {
                    break;
                }
            }
            if self.cut || self.step(action) {
                return true;
            }
        }
        self.rewind(mark);
        false
    }

    fn step(&mut self, action: &Action) -> bool {
        if self.budget == 0 {
            return false;
        }
        self.budget -= 1;
        match rule::step(self.graph, self.agent, action) {
            Ok(changes) => {
                self.trail.push(changes);
                self.events.push(Event { agent: self.agent, action: *action });
                true
            }
            Err(_) => false,
        }
    }

    /// Takes back all but the first `mark` actions.
    fn rewind(&mut self, mark: usize) {
        while self.trail.len() > mark {
            if let Some(changes) = self.trail.pop() {
                // A change set always undoes on the graph it was made on.
                let undone = changes.undo(self.graph);
                debug_assert!(undone.is_ok(), "{undone:?}");
            }
            self.events.pop();
        }
    }
}
