//! Tasks: the parts of an action that are left to do.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};
use vc_graph::rule::{self, Argument};
use vc_graph::{Action, Condition, Effect, Motion, NodeId, Place, Pose, Relation, State, Vocabulary};

use super::planner::{Plan, Planner, Planning};
use super::rest::FULL;
use super::steady::Steadying;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::BodyMotion;

/// Duration of a gesture, seconds.
const GESTURE: f32 = 1.5;

/// A part of an action. It becomes motions, and further tasks for when those are done, by the world as it is by then.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::environment) enum Task {
    /// Comes within reach of what the action is about.
    ComeNear(Action),
    /// Brings about an effect of the rule.
    Effect(Effect<NodeId>),
    /// Shows an action of which no body knows more than how it looks.
    Gesture(Action),
    /// Moves the parts of a thing, from where the agent stands.
    Swing { id: NodeId, open: f32 },
    /// Looks whether a thing has opened or closed; it was at a pose before.
    CheckOpen { id: NodeId, open: f32, before: Option<Pose> },
    /// Looks whether a thing stands as it stood.
    CheckBalance { id: NodeId, before: Pose },
    /// Steps to where a spot is within reach, if it is not.
    StepTo { id: NodeId, place: Place, spot: Pose },
    /// Looks again for a spot after a step.
    Arrive { id: NodeId, place: Place, spot: Pose },
    /// Turns to a spot, and puts a held thing there.
    PutDown { id: NodeId, place: Place, spot: Pose },
    /// As the last, when the agent has turned.
    LayDown { id: NodeId, place: Place, spot: Pose },
    /// Sees to it that what was put down stays there.
    Steady(Steadying),
    /// Lets go of a thing after a step to a spot on the floor.
    LetGoAt { id: NodeId, spot: Pose },
    /// Sits or lies down, from standing.
    RestOn { id: NodeId, lying: bool },
}

impl Task {
    /// The tasks of an action.
    pub(in crate::environment) fn of(words: &Vocabulary, action: &Action) -> VecDeque<Self> {
        let effects = rule::effects(words, action).into_iter().map(Self::Effect);
        std::iter::once(Self::ComeNear(*action)).chain(effects).collect()
    }
}

impl Planner<'_> {
    /// The next motions and tasks for a task.
    pub(in crate::environment) fn plan(&mut self, task: Task) -> Planning {
        match task {
            Task::ComeNear(action) => self.come_near(&action),
            Task::Effect(effect) => self.bring_about(&effect),
            Task::Gesture(action) => Ok(gesture(&action).into()),
            Task::Swing { id, open } => Ok(self.swing(id, open)),
            Task::CheckOpen { id, open, before } => self.check_open(id, open, before),
            Task::CheckBalance { id, before } => self.check_balance(id, &before),
            Task::StepTo { id, place, spot } => self.step_to_put(id, place, spot),
            Task::Arrive { id, place, spot } => self.arrive_to_put(id, place, spot),
            Task::PutDown { id, place, spot } => {
                Ok(self.turn_to(spot.translation.vector.into()).then(Task::LayDown { id, place, spot }))
            }
            Task::LayDown { id, place, spot } => self.lay_down(id, place, spot),
            Task::Steady(steadying) => self.steady(steadying),
            Task::LetGoAt { id, spot } => self.let_go_at(id, spot),
            Task::RestOn { id, lying } => self.rest_on(id, lying),
        }
    }

    /// Moves the agent within reach of the action's objects if it stands.
    fn come_near(&mut self, action: &Action) -> Planning {
        // Actions that require nearness are done by hand.
        let Some(rule) = self.before.vocabulary().rule(action.verb) else { return Ok(Plan::default()) };
        if rule.effects.iter().any(is_in_vehicles) {
            // Before anything else of it is done.
            return Err(IN_VEHICLES);
        }
        let by_hand = rule.preconditions.iter().any(|need| matches!(need, Condition::Near(_)));
        // Where to stand then, is found later.
        let later = rule.effects.iter().any(leads);
        let on_foot = matches!(rule.motion, Motion::Go | Motion::Run) && !rule.effects.iter().any(goes);
        let about = action.things().find(|id| !self.is_mine(*id));
        if let Some((id, side)) = about.zip(self.asked_side()) {
            return self.reach_side(id, side);
        }
        match about {
            // A lamp under the ceiling is switched at the wall, wherever the switch is.
            Some(id) if rule.motion == Motion::Switch && self.is_overhead(id) => Ok(self.face(id)),
            // The rule has one stay where one is: up to what is near already.
            Some(id) if on_foot && self.stands() && self.before.near(self.agent, id) => self.go_to(id),
            Some(id) if by_hand && !later => self.reach(id),
            _ => Ok(Plan::default()),
        }
    }

    /// The motion of the action's verb.
    pub(super) fn motion(&self) -> Option<Motion> {
        self.before.vocabulary().rule(self.action.verb).map(|rule| rule.motion)
    }

    fn bring_about(&mut self, effect: &Effect<NodeId>) -> Planning {
        match *effect {
            Effect::Enter(id, State::Open) => self.open(id, 1.0),
            Effect::Enter(id, State::Closed) => self.open(id, 0.0),
            Effect::Approach(id) if self.before.near(self.agent, id) => Ok(self.face(id)),
            Effect::GoTo(id) | Effect::Approach(id) => self.go_to(id),
            Effect::GoToPoint(aim) => aim.point().map_or_else(|| Ok(Plan::default()), |point| self.go_to_point(point)),
            Effect::StandAs(aim) => Ok(self.stand_as(&aim)),
            Effect::TurnAs(aim) if self.motion() == Some(Motion::Point) => {
                Ok(self.turn_as(&aim).then(Task::Gesture(*self.action)))
            }
            Effect::TurnAs(aim) => Ok(self.turn_as(&aim)),
            Effect::Face(id) => Ok(self.face(id)),
            Effect::Hold(id) => self.hold(id),
            Effect::PutOn(id, at) => self.put(id, Place { relation: Relation::On, at }),
            Effect::PutInto(id, at) => self.put(id, Place { relation: Relation::Inside, at }),
            Effect::PutWhereItWas(id) => match self.after.place(id) {
                Some(place) => self.put(id, place),
                None => self.let_go(id),
            },
            Effect::LetGo(id) => self.let_go(id),
            Effect::SitOn(id) => self.come_to_rest_on(id, false),
            Effect::LieOn(id) => self.come_to_rest_on(id, true),
            Effect::StandUp => self.get_up(),
            Effect::PourInto(id, into) => self.pour(id, into),
            Effect::FillWithWater(id) => Ok(Plan::of([gesture(self.action)].into_iter().chain(self.level(id, FULL)))),
            Effect::PutOnBody(id) => Ok(BodyMotion::Dress(id).into()),
            Effect::Board(_) | Effect::Alight | Effect::DriveTo(..) => Err(IN_VEHICLES),
            // States such as dirt, heat and sleep have no body.
            _ => Ok(Plan::default()),
        }
    }
}

const IN_VEHICLES: PhysicalRefusal =
    PhysicalRefusal::NotModelled("nobody gets into vehicles here yet: `World::add_vehicle` drives them");

fn is_in_vehicles(effect: &Effect<Argument>) -> bool {
    matches!(effect, Effect::Board(_) | Effect::Alight | Effect::DriveTo(..))
}

/// Whether an effect itself leads the agent to where it happens: to a seat, to a spot with room for a thing, before a
/// door.
fn leads(effect: &Effect<Argument>) -> bool {
    matches!(
        effect,
        Effect::SitOn(_)
            | Effect::LieOn(_)
            | Effect::PutOn(..)
            | Effect::PutInto(..)
            | Effect::PutWhereItWas(_)
            | Effect::Enter(_, State::Open | State::Closed)
    )
}

/// Whether an effect itself makes the agent go, or needs it within reach.
fn goes(effect: &Effect<Argument>) -> bool {
    matches!(effect, Effect::GoTo(_) | Effect::Approach(_) | Effect::GoToPoint(_) | Effect::Hold(_))
}

/// The motion that shows an action.
pub(super) fn gesture(action: &Action) -> BodyMotion {
    BodyMotion::Gesture(*action, GESTURE)
}
