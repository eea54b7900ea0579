//! The choice of the next action.

use vc_graph::goal::{Literal, Predicate, Situation};
use vc_graph::{Action, Goal, NodeId, Relation, State, Verb, rule};
use vc_tasks::{Obstacle, Task};

use super::{Agent, Decision, Mind};
use crate::Plan;
use crate::compile::Compiled;
use crate::demand::Choice;
use crate::expansion::drops_elsewhere;
use crate::open_condition::Unreachable;
use crate::packed::Way;
use crate::planner::{Refined, Sketch, plan_in_belief};
use crate::search_step::{SearchStep, best_search_step};

/// Number of complete searches of the home after which a faithful agent gives up.
const PATIENCE: usize = 4;
/// Number of decisions without new information that indicates going in circles.
const CIRCLES: usize = 300;
/// Number of repetitions of an action that counts as going in circles.
const AGAIN: usize = 2;
/// Number of combinations of a goal's alternatives that are tried.
const ALTERNATIVES: usize = 12;
/// Approximate number of actions for finding a thing.
const SEARCH: usize = 6;

impl Agent {
    /// As [`Agent::think`], but an agent that goes in circles continues as the thesis's agent does: one subgoal
    /// after the other.
    pub(super) fn think_on(&mut self) -> Decision {
        let decision = self.think();
        let decision = if self.may_be_rash(&decision) { self.explore().unwrap_or(decision) } else { decision };
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
        if let Some(id) = self.concerns.iter().find(|&&id| self.belief.has_no_place() && self.belief.is_missing(id)) {
            return Decision::GiveUp(Unreachable::Nowhere(self.belief.graph().label(*id).to_string()));
        }
        if self.idle == 0 && self.lacks_hands() {
            return Decision::GiveUp(Unreachable::Conflicting(self.goal.to_string()));
        }
        self.idle += 1;
        if self.idle > CIRCLES {
            return Decision::GiveUp(Unreachable::NoPlan(self.goal.to_string()));
        }
        if self.mind == Mind::Faithful {
            return self.decide_by_regression();
        }
        self.refine();
        if self.is_walk_spared() {
            self.next.pop_front();
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

    /// Whether the plan goes on with a walk that is not needed for what is done after it, up to the next walk.
    fn is_walk_spared(&self) -> bool {
        let mut plan = self.next.iter().copied();
        let Some(walk) = plan.next().filter(|action| action.verb == Verb::Walk) else { return false };
        let stretch: Vec<Action> = plan.take_while(|action| action.verb != Verb::Walk).collect();
        let graph = self.belief.graph();
        if stretch.is_empty() || drops_elsewhere(graph, self.id, &walk, &stretch) {
            return false;
        }
        let mut graph = graph.clone();
        stretch.iter().all(|action| rule::step(&mut graph, self.id, action).is_ok())
    }

    /// Searches for a shorter version of the rest of a plan, at the cost of improving a new plan: the shorter
    /// the rest, the more alternatives the search covers.
    fn refine(&mut self) {
        let Some(mut choice) = self.unproved.take().filter(|_| !self.next.is_empty()) else { return };
        let events = self.history.events().get(self.since()..).unwrap_or_default();
        let now = Situation { graph: self.belief.graph(), agent: self.id, events };
        match self.planner.refine(&self.goal, &now, self.belief.known(), &mut choice, self.next.len()) {
            Refined::Shorter(actions, best) => {
                self.next = actions.into();
                self.unproved = (!best).then_some(choice);
            }
            Refined::Best => {}
            Refined::Unknown => self.unproved = Some(choice),
        }
    }

    fn is_missing_something(&self) -> bool {
        self.concerns.iter().any(|&id| self.belief.is_missing(id))
    }

    pub(super) fn decide_by_regression(&mut self) -> Decision {
        let intent = (self.pursued, self.planner.tidy());
        let events = self.history.events().get(self.since()..).unwrap_or_default();
        let plan = plan_in_belief(&mut self.belief, self.id, &self.goal, events, self.horizon, intent);
        self.pursued = plan.as_ref().ok().and_then(|p| p.conditions.first()).map(|(condition, _)| *condition);
        match plan {
            Ok(plan) => match plan.actions.first() {
                Some(&action) => Decision::Act(action, plan),
                None => Decision::Done,
            },
            Err(reason) => Decision::GiveUp(reason),
        }
    }

    /// Plans for the known things. If something is lacking, searches for it, unless there is something to do at
    /// hand or the hands are full.
    fn decide_best(&mut self) -> Decision {
        let (sketch, choice) = match self.best_sketch() {
            Ok(found) => found,
            // A goal that takes more hands than there are is not tried by turns.
            Err(reason) if self.lacks_hands() => return Decision::GiveUp(reason),
            Err(reason) => {
                return match self.decide_by_regression() {
                    // An agent with nothing else to do searches where the thing may be by now.
                    Decision::GiveUp(_) if self.has_let_go(&reason) => self.decide_best(),
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
            let decision = self.start(sketch.actions);
            self.unproved = (!sketch.proved).then_some(choice);
            return decision;
        }
        // A container that will still be filled is neither closed nor switched on.
        let early = |a: &Action| {
            let ending = matches!(a.verb, Verb::Close | Verb::SwitchOn | Verb::SwitchOff);
            ending && a.object.is_some_and(|id| doors_lacking(&sketch).any(|d| d == id))
        };
        let known = sketch.actions.first().copied().filter(|a| !early(a) && self.is_at_hand(a));
        if let Some(action) = known.or_else(|| self.put_back(&sketch)) {
            return self.act(action, sketch.actions);
        }
        let look = best_search_step(&self.belief, self.id, &sketch.compiled, self.planner.manners);
        self.promise_found(look, &sketch.actions);
        match look {
            Some(SearchStep::Visit(at)) => self.act(Action::one(Verb::Walk, at), Vec::new()),
            Some(SearchStep::Open(at)) => self.go_and(Action::one(Verb::Open, at)),
            Some(SearchStep::Do(action)) => self.go_and(action),
            None => self.decide_by_regression(),
        }
    }

    /// Whether the goal asks for more to be held at once than there are hands.
    fn lacks_hands(&self) -> bool {
        let held = |part: &Goal| match part {
            Goal::Literal(literal) => usize::from(is_held(literal)),
            Goal::Count { literal, number, .. } if is_held(literal) => *number as usize,
            _ => 0,
        };
        // Mostly that is seen at once.
        if self.goal.conjuncts().iter().map(held).sum::<usize>() <= vc_graph::Relation::hands().len() {
            return false;
        }
        let task = Task::new("", self.goal.clone());
        let obstacles = task.obstacles(self.belief.graph());
        obstacles.iter().any(|obstacle| matches!(obstacle, Obstacle::TooManyHeld { .. }))
    }

    fn has_let_go(&mut self, reason: &Unreachable) -> bool {
        matches!(reason, Unreachable::HeldByAnother(_)) && self.belief.let_go_of_held()
    }

    /// The closing of a container at hand that was opened in vain, for agents with manners.
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

    /// Does an action after the necessary walk, unless the walk shows something new.
    pub(super) fn go_and(&mut self, action: Action) -> Decision {
        let decision = self.act(action, Vec::new());
        if matches!(decision, Decision::Act(first, _) if first.verb == Verb::Walk) {
            self.next = [action].into();
        }
        decision
    }

    /// The alternative of the goal with the least estimated work.
    fn best_sketch(&mut self) -> Result<(Sketch, Choice), Unreachable> {
        let (mut best, mut reason) = (None::<(usize, Sketch, Choice)>, None);
        let mut choice = Choice::default();
        let imagined = (!self.counted_on.is_empty()).then(|| self.imagined());
        let graph = imagined.as_ref().unwrap_or(self.belief.graph());
        let events = self.history.events().get(self.since()..).unwrap_or_default();
        let now = Situation { graph, agent: self.id, events };
        for _ in 0..ALTERNATIVES {
            match self.planner.sketch(&self.goal, &now, self.belief.known(), &mut choice) {
                Ok(sketch) => {
                    let lacking: usize = sketch.compiled.lacks.iter().map(|l| l.number).sum();
                    let cost = sketch.actions.len() + SEARCH * lacking;
                    if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                        best = Some((cost, sketch, choice.clone()));
                    }
                }
                Err(why) => reason = reason.or(Some(why)),
            }
            if !choice.advance() {
                break;
            }
        }
        best.map(|(_, sketch, choice)| (sketch, choice))
            .ok_or_else(|| reason.unwrap_or_else(|| Unreachable::NoPlan(self.goal.to_string())))
    }

    /// Starts the packed plan. Regression handles the remaining parts of the goal once the plan is done.
    fn decide_with_rest(&mut self, actions: Vec<Action>) -> Decision {
        if actions.is_empty() { self.decide_by_regression() } else { self.start(actions) }
    }

    /// Begins a plan and keeps its rest for the next decisions.
    fn start(&mut self, actions: Vec<Action>) -> Decision {
        match actions.first() {
            // The promises of others cover the rest of the goal.
            None if !self.counted_on.is_empty() => Decision::Done,
            None => self.decide_by_regression(),
            Some(&first) => {
                let decision = self.act(first, actions.clone());
                if let Decision::Act(action, _) = &decision {
                    // Actions inserted before the plan do not use it up.
                    let used = actions.iter().position(|a| a == action).map_or(0, |i| i + 1);
                    self.next = actions[used..].iter().copied().collect();
                }
                decision
            }
        }
    }
}

fn is_held(literal: &Literal) -> bool {
    matches!(literal.predicate, Predicate::Holds | Predicate::Relation(Relation::HoldsRight | Relation::HoldsLeft))
}

/// The containers that lacking things will be put into.
fn doors_lacking(sketch: &Sketch) -> impl Iterator<Item = NodeId> {
    sketch.compiled.lacks.iter().flat_map(|l| &l.ways).filter_map(|way| door(sketch, way))
}

fn door(sketch: &Sketch, way: &Way) -> Option<NodeId> {
    match way {
        Way::Put { door: Some(d), .. } => sketch.compiled.problem.doors.get(*d as usize).map(|d| d.node),
        _ => None,
    }
}
