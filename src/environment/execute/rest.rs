//! Sitting, lying, getting up; and pouring.

use nalgebra::{Point2, Point3};
use vc_graph::{NodeId, Place, Pose, Property, Relation};
use vc_physics::AgentError;

use super::planner::{Plan, Planner, Planning};
use super::task::Task;
use super::task::gesture;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::BodyMotion;

/// The fill level of a vessel that has been filled.
pub(super) const FULL: f32 = 0.8;
/// How far from a seat one sits down on it, metres.
const BESIDE: f32 = 1.4;

impl Planner<'_> {
    /// Sits or lies down, after getting up from where the agent rests.
    pub(super) fn come_to_rest_on(&mut self, id: NodeId, lying: bool) -> Planning {
        let up = if self.stands() { Plan::default() } else { self.get_up()? };
        Ok(up.then(Task::RestOn { id, lying }))
    }

    pub(super) fn rest_on(&mut self, id: NodeId, lying: bool) -> Planning {
        let seat = self.asked_seat();
        let body = self.world.body(id)?;
        let mut places = if lying { body.beds() } else { body.seats() };
        if let Some(asked) = seat.and_then(|seat| places.get(seat as usize).copied()) {
            places = vec![asked];
        }
        let from = self.feet().translation.vector.xy();
        let nearest = places.iter().map(|p| (p.translation.vector.xy() - from).norm()).fold(f32::INFINITY, f32::min);
        let mut plan = Plan::default();
        if nearest > BESIDE {
            self.floor.update(self.world);
            let room = self.before.room_of(id);
            let stand = goals(&places, lying).find_map(|to| self.nearest_stand(room, to, BESIDE, |_| true));
            plan = self.walk(stand.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(id)))?)?;
        }
        plan.motions.push(BodyMotion::Rest(id, lying, seat));
        Ok(plan)
    }

    /// Gets up to a spot from which the floor is reached on which the agent stood before; else to where it stood.
    pub(super) fn get_up(&mut self) -> Planning {
        self.floor.update(self.world);
        let stood =
            self.world.agent(self.agent).ok().and_then(|agent| agent.stood_before()).unwrap_or_else(|| self.feet());
        let at = |feet: &Pose| Point2::from(feet.translation.vector.xy());
        let back = |feet: &Pose| self.floor.route(at(feet), at(&stood)).is_some();
        let exit = self.world.agent(self.agent).and_then(|agent| agent.exit_where(back));
        let feet = match exit {
            Err(AgentError::NoExit(_)) if self.world.standing(self.agent, &stood)?.is_free() => stood,
            exit => exit?,
        };
        Ok(BodyMotion::GetUp(feet).into())
    }

    pub(super) fn pour(&mut self, id: NodeId, into: NodeId) -> Planning {
        let is_water = self.before.node(id).is_some_and(|n| &**n.class() == "water");
        if is_water {
            return self.put(id, Place { relation: Relation::Inside, at: into });
        }
        let emptied = self.after.node(id).is_some_and(|n| n.contents().is_none());
        let empties = if emptied { self.level(id, 0.0) } else { None };
        Ok(Plan::of([gesture(self.action)].into_iter().chain(empties).chain(self.level(into, FULL))))
    }

    /// Sets the fill level of a vessel if its shape says that it holds liquids.
    pub(super) fn level(&self, id: NodeId, level: f32) -> Option<BodyMotion> {
        let holds = self.before.node(id).is_some_and(|n| n.affords(Property::Recipient));
        holds.then_some(BodyMotion::Fill(id, level))
    }
}

/// The points beside which an agent sits or lies down, best first: the middles of the places, and for lying
/// also the positions of feet and head.
fn goals(places: &[Pose], lying: bool) -> impl Iterator<Item = Point3<f32>> {
    const END: f32 = 0.8;
    let along: &[f32] = if lying { &[0.0, END, -END] } else { &[0.0] };
    along.iter().flat_map(|x| places.iter().map(move |place| place * Point3::new(*x, 0.0, 0.0)))
}
