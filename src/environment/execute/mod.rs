//! Execution of an action by bodies.
//!
//! The effects of the transition rule become [tasks](task), a [planner] makes motions of them by the world as it is, and
//! [bodies](perform) do those. What comes next is planned when they are done. The planner's parts: [`stand`] is about
//! where to stand, [`open`] about doors and drawers, [`put`] about hands, [`spot`] about where there is room, [`steady`]
//! about what would not stay where it was put, [`rest`] about seats, and [`aim`] about the
//! points, headings, slots and sides that an action asks for.

mod aim;
mod open;
mod perform;
mod planner;
mod put;
mod rest;
mod spot;
mod stand;
mod steady;
mod task;

use std::collections::VecDeque;

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use vc_physics::{Floor, PhysicsWorld};

use super::course::{BodyMotion, Course};
use super::step::Step;
use super::{ActionError, PhysicalRefusal, Start};

pub(super) use aim::off_aim;
pub(super) use perform::Bodies;
pub(super) use planner::{Plan, Planner};
pub(super) use put::{comes_along, load_of};
pub(super) use spot::FreeSpot;
pub(super) use task::Task;

/// The execution of an agent's action at once: moves bodies and records the course of the action.
pub(super) struct Execution<'a> {
    world: &'a mut PhysicsWorld,
    floor: &'a mut Floor,
    start: &'a Start,
    step: &'a Step,
    tasks: VecDeque<Task>,
    course: Course,
}

impl<'a> Execution<'a> {
    pub(super) fn new(world: &'a mut PhysicsWorld, floor: &'a mut Floor, start: &'a Start, step: &'a Step) -> Self {
        Self { world, floor, start, step, tasks: VecDeque::new(), course: Course::default() }
    }

    /// Executes all effects that the rule gives for an action; returns their course.
    pub(super) fn all(mut self) -> (Course, Result<(), ActionError>) {
        let (action, before) = (self.step.action, &self.step.before);
        self.tasks = Task::of(&action);
        let done = self.run().and_then(|()| {
            // Effects without a motion of bodies are shown by a gesture.
            let effects = &self.course.effects;
            let unseen = effects.is_empty() || effects.iter().any(|(motion, _)| motion.is_none());
            self.tasks.extend(unseen.then_some(Task::Gesture(action)));
            self.run()
        });
        let done = done.map_err(|why| {
            let (action, why) = (action.describe(before).to_string(), why.in_scene(before));
            ActionError::Impossible { action, why }
        });
        (self.course, done)
    }

    /// Does all tasks, and those that come of them.
    fn run(&mut self) -> Result<(), PhysicalRefusal> {
        while let Some(task) = self.tasks.pop_front() {
            if let Task::ComesTrue(effect, first) = task {
                self.course.comes_true(effect, first);
                continue;
            }
            if let Task::Effect(effect) = task {
                self.tasks.push_front(Task::ComesTrue(effect, self.course.motions.len()));
            }
            let plan = Planner::new(self.world, self.floor, self.start, self.step).plan(task)?;
            plan.tasks.into_iter().rev().for_each(|task| self.tasks.push_front(task));
            plan.motions.into_iter().try_for_each(|motion| self.perform(motion))?;
        }
        Ok(())
    }

    fn perform(&mut self, mut motion: BodyMotion) -> Result<(), PhysicalRefusal> {
        let (before, agent) = (&self.step.before, self.step.agent);
        Bodies { world: self.world, start: self.start, before, agent }.perform(&mut motion)?;
        self.course.record(motion);
        Ok(())
    }
}

/// The rotation around the vertical that turns X to the given direction.
pub(in crate::environment) fn towards(way: Vector2<f32>) -> UnitQuaternion<f32> {
    use vc_graph::portable::Portable;
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), way.y.angle_to(way.x))
}
