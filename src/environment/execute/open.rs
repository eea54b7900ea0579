//! Opening and closing.

use vc_graph::{NodeId, Pose, State};
use vc_physics::BodyRole;

use super::planner::{Plan, Planner, Planning};
use super::task::Task;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::{BodyMotion, Drive};

/// The smallest share of its range that a door has to open.
pub(in crate::environment) const WIDE: f32 = 0.35;
/// The share from which on it is fully open.
const FULLY: f32 = 0.999;
/// The farthest that a loose thing may shift while it is opened, metres.
const SHIFT: f32 = 0.1;

impl Planner<'_> {
    /// Opens or closes all moving parts of a thing, from a position where the agent is not in the way.
    pub(super) fn open(&mut self, id: NodeId, open: f32) -> Planning {
        let moves = !self.world.parts(id).all().is_empty();
        if self.is_mine(id) {
            return Ok(if moves { drive(id, open, false).into() } else { Plan::default() });
        }
        if !moves {
            let drawn = self.has_cord(id) && self.stands();
            return if drawn { self.stand_clear(id, open) } else { self.reach(id) };
        }
        let body = self.body_of(id)?;
        let plan = if self.stands() { self.stand_clear(body, open)? } else { Plan::default() };
        Ok(plan.then(Task::Swing { id, open }))
    }

    pub(super) fn swing(&self, id: NodeId, open: f32) -> Plan {
        Plan::from(drive(id, open, self.pushes)).then(Task::CheckOpen { id, open, before: self.world.pose(id) })
    }

    /// Whether the parts have arrived, and the thing has kept its balance.
    pub(super) fn check_open(&self, id: NodeId, open: f32, before: Option<Pose>) -> Planning {
        let now = self.world.parts(id).openness().unwrap_or(open);
        let arrived = if open > 0.5 { now >= WIDE } else { self.world.parts(id).state() == Some(State::Closed) };
        // The part may have stopped where the agent stands.
        let squeezed = now < FULLY && self.stands() && !self.world.standing(self.agent, &self.feet())?.is_free();
        if !arrived || squeezed {
            return Err(self.stuck(id, open, now)?);
        }
        let loose = self.world.role(id) == Some(BodyRole::Loose);
        Ok(before.filter(|_| loose).map_or_else(Plan::default, |before| {
            Plan::from(BodyMotion::ComeToRest).then(Task::CheckBalance { id, before })
        }))
    }

    /// The error for a thing that is stuck at its present opening.
    fn stuck(&self, id: NodeId, open: f32, now: f32) -> Result<PhysicalRefusal, PhysicalRefusal> {
        let by = self.world.parts(id).blockers(open)?.into_iter().map(|by| self.before.label(by)).collect();
        Ok(PhysicalRefusal::Stuck { thing: self.before.label(id), open: 100.0 * now, by })
    }

    /// Refuses an opening that makes the thing fall over, so that it would lie in another place or another
    /// pose.
    pub(super) fn check_balance(&self, id: NodeId, before: &Pose) -> Planning {
        let moved = self.world.pose(id).is_some_and(|now| {
            let far = (now.translation.vector - before.translation.vector).norm();
            far > SHIFT || !Self::is_upright(&now, before)
        });
        if moved { Err(PhysicalRefusal::Topples(self.before.label(id))) } else { Ok(Plan::default()) }
    }
}

fn drive(id: NodeId, open: f32, pushes: bool) -> BodyMotion {
    BodyMotion::Drive(Drive { id, open, pushes })
}
