//! Backwards from what is wanted to what can be done now, through the transition
//! rule: any predicate, any verb. It finds some way, not the shortest.

mod follow;
mod tidy;

use vc_graph::goal::{Goal, Situation};
use vc_graph::{
    Action, ChangeSet, Condition, Event, Node, NodeId, Place, Property, Relation, SceneGraph, State, Verb, rule,
};

use crate::KnownNodes;
use crate::manners::Touched;
use crate::open_condition::{OpenCondition, Unreachable};
use crate::plan::{Horizon, Plan};
use crate::subgoal::View;
use crate::subgoal::hints::Hints;

/// How many actions a plan may hold, tried ones included.
const BUDGET: usize = 4000;
/// How deep an action may need another.
const DEPTH: usize = 12;
/// How often an action's needs are met again when meeting one undid another.
const ROUNDS: usize = 3;
/// How many options of a subgoal are tried.
const OPTIONS: usize = 48;

/// A search in progress, which tries actions on the graph and takes them back.
pub(crate) struct Regression<'a> {
    graph: &'a mut SceneGraph,
    agent: NodeId,
    known: &'a KnownNodes,
    /// Everything is known: whether the goal holds can be seen.
    knows_all: bool,
    /// The things that have been opened and switched before, for agents that put them back.
    touched: Option<&'a Touched>,
    /// Where things that have not been found can be.
    unseen: &'a [Place],
    hints: Hints,
    events: Vec<Event>,
    done_before: usize,
    trail: Vec<ChangeSet>,
    /// The conditions that are being brought about, outermost first: one that is needed to bring
    /// about itself is no help.
    open: Vec<Condition>,
    budget: usize,
    /// The plan ends here: what comes next depends on what is seen.
    cut: bool,
}

impl<'a> Regression<'a> {
    pub(crate) fn new(
        graph: &'a mut SceneGraph,
        agent: NodeId,
        known: &'a KnownNodes,
        events: &[Event],
        goal: &Goal,
    ) -> Self {
        let knows_all = graph.nodes().all(|n| known.contains(n.id()));
        Self {
            graph,
            agent,
            known,
            knows_all,
            touched: None,
            unseen: &[],
            hints: Hints::new(goal),
            events: events.to_vec(),
            done_before: events.len(),
            trail: Vec::new(),
            open: Vec::new(),
            budget: BUDGET,
            cut: false,
        }
    }

    /// Makes it leave doors and switches as they were at first.
    pub(crate) fn tidying(self, touched: Option<&'a Touched>) -> Self {
        Self { touched, ..self }
    }

    /// Tells it where things that have not been found can be.
    pub(crate) fn doubting(self, unseen: &'a [Place]) -> Self {
        Self { unseen, ..self }
    }

    pub(crate) fn run(
        mut self,
        goal: &Goal,
        horizon: Horizon,
        pursued: Option<OpenCondition>,
    ) -> Result<Plan, Unreachable> {
        let result = self.work(goal, horizon, pursued);
        self.rewind(0);
        result
    }

    pub(crate) fn now(&self) -> Situation<'_> {
        Situation { graph: self.graph, agent: self.agent, events: &self.events }
    }

    fn view(&self) -> View<'_> {
        View { now: self.now(), known: self.known, unseen: self.unseen, hints: &self.hints }
    }

    pub(crate) fn work(
        &mut self,
        goal: &Goal,
        horizon: Horizon,
        mut pursued: Option<OpenCondition>,
    ) -> Result<Plan, Unreachable> {
        let mut conditions = Vec::new();
        loop {
            let ends = self.cut || (horizon == Horizon::NextSubgoal && !self.trail.is_empty());
            let reached = self.knows_all && self.holds(goal);
            let subgoals = if ends || reached { Vec::new() } else { self.view().subgoals(goal)? };
            if let Some(done) = if ends { None } else { self.put_back(goal, &subgoals) } {
                conditions.push(done);
                continue;
            }
            if ends || reached || (subgoals.is_empty() && !self.knows_all) {
                return Ok(Plan { actions: self.actions(), conditions, proved: false });
            }
            if subgoals.is_empty() {
                // The remaining parts came too late, or too early.
                return Err(Unreachable::NoPlan(goal.to_string()));
            }
            let before = self.trail.len();
            let options = || subgoals.iter().flat_map(|s| s.options.iter().take(OPTIONS));
            let kept = pursued.take().filter(|condition| options().any(|o| o == condition));
            let Some(condition) = kept.into_iter().chain(options().copied()).find(|condition| self.settle(condition))
            else {
                let open = subgoals.iter().filter_map(|s| s.options.first()).take(3).map(|w| self.describe(w));
                return Err(Unreachable::NoPlan(open.collect::<Vec<_>>().join("; ")));
            };
            conditions.push((condition, self.trail.len() - before));
            // A look ends the plan: only an observation can tell what is there.
            if condition.is_observation() {
                return Ok(Plan { actions: self.actions(), conditions, proved: false });
            }
        }
    }

    /// Whether a goal holds now.
    pub(crate) fn holds(&self, goal: &Goal) -> bool {
        goal.holds(&self.now())
    }

    fn describe(&self, open: &OpenCondition) -> String {
        match open {
            OpenCondition::Do(action) => action.describe(self.graph).to_string(),
            OpenCondition::See(id) => format!("see {}", self.graph.label(*id)),
            OpenCondition::LookInto(id) => format!("look into {}", self.graph.label(*id)),
            OpenCondition::Hold(condition) => match condition.check(self.graph, self.agent) {
                Err(refusal) => format!("({refusal})"),
                Ok(()) => open.to_string(),
            },
        }
    }

    pub(crate) fn actions(&self) -> Vec<Action> {
        self.events[self.done_before..].iter().map(|e| e.action).collect()
    }

    /// Settles a condition by actions, or leaves everything as it was.
    fn settle(&mut self, condition: &OpenCondition) -> bool {
        let mark = self.trail.len();
        let settled = match condition {
            OpenCondition::Hold(condition) => self.achieve(condition) && self.trail.len() > mark,
            OpenCondition::Do(action) => self.act(action),
            OpenCondition::See(id) => self.come_to_see(*id),
            OpenCondition::LookInto(id) if self.graph.node(*id).is_some_and(Node::hides_contents) => {
                self.achieve(&Condition::In(*id, State::Open))
            }
            OpenCondition::LookInto(id) => self.come_to_see(*id),
        };
        if !settled {
            self.rewind(mark);
            self.cut = false;
        }
        settled
    }

    /// Goes where a thing is believed to be, and opens what it is believed in.
    fn come_to_see(&mut self, id: NodeId) -> bool {
        if self.graph.hidden_in(id).is_some() {
            return self.achieve(&Condition::Accessible(id));
        }
        let room = self.graph.room_of(id);
        let walk = room.map(|room| Action::one(Verb::Walk, room));
        walk.is_some_and(|walk| self.act(&walk))
    }

    /// Makes a condition true by actions, or leaves everything as it was.
    fn achieve(&mut self, condition: &Condition) -> bool {
        if condition.holds(self.graph, self.agent) {
            return true;
        }
        if self.open.len() >= DEPTH || self.open.contains(condition) {
            return false;
        }
        let mark = self.trail.len();
        self.open.push(*condition);
        let candidates = self.ways(condition);
        let blind = self.lies_anywhere(condition);
        let mut achieved = false;
        for action in candidates {
            // Some conditions take several actions: an object that is to be in
            // another room is grabbed, carried there and put down.
            let acted = self.act(&action);
            self.cut |= acted && blind;
            achieved = acted && (self.cut || condition.holds(self.graph, self.agent) || self.go_on(condition));
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

    /// Whether a thing that is to be near is believed somewhere on the floor of another
    /// room: only there can one see on.
    fn lies_anywhere(&self, condition: &Condition) -> bool {
        matches!(*condition, Condition::Near(id) if self.is_missing(id) && self.graph.place(id).is_none())
    }

    /// Actions that bring a condition about. A thing that can be anywhere and has not been
    /// seen cannot be walked up to: the agent goes to the place where it is believed to
    /// be, or else to the room.
    fn ways(&self, condition: &Condition) -> Vec<Action> {
        match *condition {
            Condition::Near(id) if self.is_missing(id) => {
                let room = || self.graph.room_of(id).filter(|&r| Some(r) != self.graph.room_of(self.agent));
                let place = self.graph.place(id).map(|p| p.at);
                place.or_else(room).map(|at| Action::one(Verb::Walk, at)).into_iter().collect()
            }
            // The agent puts down last a thing in the hand in which the goal wants it.
            Condition::FreeHand | Condition::FreeHandOrHolding(_) => {
                let mut found = rule::regress::achievers(self.graph, self.agent, condition);
                let wanted = |a: &Action| a.object.is_some_and(|id| self.hints.is_in_its_hand(&self.now(), id));
                found.sort_by_cached_key(wanted);
                found
            }
            Condition::Related(who, Relation::HoldsRight | Relation::HoldsLeft, _) if who == self.agent => {
                let mut found = rule::regress::achievers(self.graph, self.agent, condition);
                self.hints.sort_fillers(&self.now(), &mut found);
                found
            }
            _ => rule::regress::achievers(self.graph, self.agent, condition),
        }
    }

    /// Whether a thing is one that can be anywhere, and where it is is a guess.
    fn is_missing(&self, id: NodeId) -> bool {
        !self.known.contains(id) && self.graph.node(id).is_some_and(|n| n.affords(Property::Graspable))
    }

    /// Goes on with a condition that an action has brought nearer.
    fn go_on(&mut self, condition: &Condition) -> bool {
        for _ in 0..ROUNDS {
            let Some(action) = self.ways(condition).into_iter().next() else {
                return false;
            };
            if !self.act(&action) {
                return false;
            }
            if self.cut || condition.holds(self.graph, self.agent) {
                return true;
            }
        }
        false
    }

    /// The conditions that an action needs. To do something to a thing that has not been found the agent must
    /// first come to see it, whatever it supposes about the thing; a thing to be held is seen when it is fetched, and
    /// need not be near anything else then.
    fn needs(&self, action: &Action) -> Vec<Condition> {
        let needs = rule::preconditions(self.graph.vocabulary(), action);
        let missing = action.things().filter(|&id| action.verb != Verb::Walk && self.is_missing(id));
        let sight = missing.flat_map(|id| match Condition::Holding(id) {
            held if needs.contains(&held) => vec![held],
            _ => vec![Condition::Accessible(id), Condition::Near(id)],
        });
        sight.chain(needs.iter().copied()).collect()
    }

    /// Does an action after making true what it needs, or leaves everything as it
    /// was.
    fn act(&mut self, action: &Action) -> bool {
        let mark = self.trail.len();
        let needs = self.needs(action);
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
    pub(crate) fn rewind(&mut self, mark: usize) {
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
