//! Motions done at once by the bodies of a world.

use vc_graph::{NodeId, Pose, SceneGraph};
use vc_physics::{BodyRole, PhysicsWorld};

use super::load_of;
use super::spot::{AWAY, scaled};
use crate::environment::motion::{BodyMotion, Put};
use crate::environment::settle::come_to_rest;
use crate::environment::{PhysicalRefusal, Start};

type Done = Result<(), PhysicalRefusal>;

/// The bodies that an agent moves.
pub(in crate::environment) struct Bodies<'a> {
    pub(in crate::environment) world: &'a mut PhysicsWorld,
    pub(in crate::environment) start: &'a Start,
    /// The scene before the action.
    pub(in crate::environment) before: &'a SceneGraph,
    pub(in crate::environment) agent: NodeId,
}

impl Bodies<'_> {
    /// Does a motion.
    pub(in crate::environment) fn perform(&mut self, motion: &BodyMotion) -> Done {
        let agent = self.agent;
        match motion {
            BodyMotion::Walk { feet, .. } | BodyMotion::StepAside { feet, .. } | BodyMotion::GetUp(feet) => {
                self.world.teleport(agent, *feet)?;
            }
            BodyMotion::Turn(feet) => self.world.turn(agent, feet.rotation)?,
            BodyMotion::Take(hand, id, side) => {
                let load = load_of(self.before, *id);
                match side {
                    Some(side) => self.world.grab_by_side(agent, (*hand, *side), *id, &load)?,
                    None => self.world.grab_with_load(agent, *hand, *id, &load)?,
                }
            }
            BodyMotion::Fold(id, scale) => {
                let graph = scaled(self.before, *id, *scale)?;
                self.world.reshape(&graph, *id, &self.start.shapes)?;
            }
            BodyMotion::Nudge(parts) => {
                parts.iter().try_for_each(|(id, part, open)| self.world.put_open(*id, Some(*part), *open))?;
            }
            BodyMotion::Push(moved) => self.push(moved)?,
            BodyMotion::Put(put) => self.put(put)?,
            // The clock holds still what has to be, once bodies have been stepped.
            BodyMotion::PutAgain(id, pose, _) => self.world.place(*id, *pose)?,
            BodyMotion::ClearAway(id, around) => self.clear_away(*id, around)?,
            BodyMotion::PutBack(poses) => self.world.put_at(poses)?,
            BodyMotion::LetGo(hand) => self.world.drop(agent, *hand).map(|_| ())?,
            // Nothing is in the way of what a hand holds; the clock moves other doors.
            BodyMotion::Drive(drive) => self.world.put_open(drive.id, None, drive.open)?,
            BodyMotion::Rest(id, false, Some(seat)) => self.world.sit(agent, *id, Some(*seat))?,
            BodyMotion::Rest(id, true, _) => self.world.lie(agent, *id)?,
            BodyMotion::Rest(id, false, None) => self.world.sit(agent, *id, None)?,
            BodyMotion::Dress(id) => self.world.remove(*id)?,
            BodyMotion::Undress(hand, id) => {
                self.world.insert(self.before, *id, &self.start.shapes)?;
                let feet = self.world.pose(agent).unwrap_or_else(Pose::identity);
                self.world.place(*id, feet * Pose::translation(0.3, 0.0, 1.0))?;
                self.world.grab(agent, *hand, *id)?;
            }
            BodyMotion::Fill(id, level) => {
                // A vessel without a body has no fill level.
                let _ = self.world.fill(*id, *level);
            }
            BodyMotion::ComeToRest => come_to_rest(self.world),
            BodyMotion::Gesture(..) => {}
        }
        Ok(())
    }

    fn push(&mut self, moved: &[(NodeId, Pose)]) -> Done {
        moved.iter().try_for_each(|(thing, spot)| self.world.place(*thing, *spot))?;
        Ok(moved.iter().try_for_each(|(thing, _)| self.world.wake(*thing))?)
    }

    fn put(&mut self, put: &Put) -> Done {
        match (put.tight, put.with) {
            (Some(at), _) => self.world.put_back(&self.start.world, (self.agent, put.hand), put.pose, at)?,
            (None, Some(at)) => self.world.put_with(self.agent, put.hand, put.pose, at)?,
            (None, None) => self.world.put(self.agent, put.hand, put.pose)?,
        };
        Ok(())
    }

    /// Takes a thing out of the way, and brings back those around it. All of them are loose again: one that was pinned
    /// to the drawer that it came to rest in would stay behind when the drawer moves.
    fn clear_away(&mut self, id: NodeId, around: &[(NodeId, Pose)]) -> Done {
        self.world.place(id, Pose::translation(0.0, 0.0, AWAY))?;
        around.iter().try_for_each(|(id, was)| self.world.place(*id, *was))?;
        let all = around.iter().map(|(id, _)| *id).chain([id]);
        let pinned: Vec<NodeId> = all.filter(|id| self.world.role(*id) == Some(BodyRole::Hung)).collect();
        Ok(pinned.into_iter().try_for_each(|id| self.world.wake(id))?)
    }
}
