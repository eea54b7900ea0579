//! Goals with words of time: the agent pursues one stage after the other, and takes no plan that breaks what must stay.

use vc_graph::goal::Situation;
use vc_graph::{Action, Event, Goal, SceneGraph, rule};

use super::{Agent, Decision};
use crate::agenda::{Agenda, Aim, Guard, Moment};
use crate::open_condition::Unreachable;

/// Most stages and alternatives that are gone through for one decision.
const STAGES: usize = 64;

/// The reason for which a plan is not taken.
pub(super) struct ConstraintViolation {
    pub(super) why: Unreachable,
    /// The action that breaks a part; none if the plan only takes too long.
    pub(super) action: Option<Action>,
}

impl Agent {
    /// Decides by what the goal asks for next.
    pub(super) fn decide_in_time(&mut self, agenda: &mut Agenda) -> Decision {
        for _ in 0..STAGES {
            let knows_all = self.belief.knows_all();
            let now = Situation { graph: self.belief.graph(), agent: self.id, events: self.history.events() };
            let aim = match agenda.aim(&Moment::new(now, self.belief.known(), knows_all)) {
                Ok(aim) => aim,
                Err(broken) => return Decision::GiveUp(broken),
            };
            match self.decide_for(aim) {
                Decision::GiveUp(_) if agenda.go_otherwise() => {}
                decision => return decision,
            }
        }
        Decision::GiveUp(Unreachable::NoPlan(agenda.goal().to_string()))
    }

    fn decide_for(&mut self, aim: Aim) -> Decision {
        if self.goal != aim.goal {
            self.goal = aim.goal.clone();
            self.forget_plans();
            (self.unproved, self.idle) = (None, 0);
            self.tried.clear();
        }
        // Actions barred to keep a condition are allowed again when the condition has ended.
        if self.aim.as_ref().is_none_or(|before| before.guards != aim.guards) {
            self.belief.unbar(self.bars);
            (self.bars, self.breach) = (self.belief.bars(), None);
        }
        self.aim = Some(aim);
        let decision = self.think_twice();
        match (decision, &self.aim) {
            // The agent believes that a stage is reached, and cannot tell that it is.
            (Decision::Done, Some(aim)) if !aim.is_last => Decision::GiveUp(Unreachable::NoPlan(aim.goal.to_string())),
            (Decision::Done, Some(Aim { beyond: Some(part), .. })) => {
                Decision::GiveUp(Unreachable::Beyond(part.clone()))
            }
            // It looked elsewhere because of a condition, in vain.
            (Decision::GiveUp(why), _) => Decision::GiveUp(self.breach.clone().unwrap_or(why)),
            (decision, _) => decision,
        }
    }

    /// Actions before this number do not count for the present goal.
    pub(super) fn since(&self) -> usize {
        self.aim.as_ref().map_or(0, |aim| aim.since)
    }

    /// Whether a plan breaks what must stay so until the aim is reached, or reaches it too late.
    pub(super) fn breach(&self, plan: &[Action]) -> Option<ConstraintViolation> {
        let aim = self.aim.as_ref().filter(|aim| aim.by.is_some() || !aim.guards.is_empty())?;
        let mut graph = self.belief.graph().clone();
        let mut events = self.history.events().get(self.since()..).unwrap_or_default().to_vec();
        let mut held: Vec<bool> = aim.guards.iter().map(|guard| self.keeps(guard, &graph, &[])).collect();
        for (number, action) in plan.iter().enumerate() {
            if rule::step(&mut graph, self.id, action).is_err() {
                return None;
            }
            let event = Event { agent: self.id, action: *action };
            events.push(event);
            let reached = aim.goal.holds(&Situation { graph: &graph, agent: self.id, events: &events });
            for (guard, held) in aim.guards.iter().zip(&mut held) {
                let holds = self.keeps(guard, &graph, &[event]);
                if *held && !holds && (guard.to_the_end || !reached) {
                    return Some(self.broken(&aim.goal, guard, action));
                }
                *held = holds;
            }
            if reached {
                return self.too_late(aim, number + 1);
            }
        }
        None
    }

    fn keeps(&self, guard: &Guard, graph: &SceneGraph, events: &[Event]) -> bool {
        guard.goal.holds(&Situation { graph, agent: self.id, events })
    }

    fn broken(&self, goal: &Goal, guard: &Guard, action: &Action) -> ConstraintViolation {
        let described = action.describe(self.belief.graph()).to_string();
        let why = Unreachable::Breaks { goal: goal.to_string(), part: guard.part.clone(), action: described };
        ConstraintViolation { why, action: Some(*action) }
    }

    fn too_late(&self, aim: &Aim, more: usize) -> Option<ConstraintViolation> {
        let (by, part) = aim.by.as_ref()?;
        let steps = self.history.events().len() + more;
        (steps > *by)
            .then(|| ConstraintViolation { why: Unreachable::TooLate { part: part.clone(), steps }, action: None })
    }
}
