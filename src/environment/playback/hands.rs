//! What hands do: they go out, to what they take, put down or open, and come back.

use nalgebra::Point3;
use vc_graph::asset::JointKind;
use vc_graph::{NodeId, Pose, Side};
use vc_people::{Activity, BodySide, Reach};
use vc_physics::Hand;

use super::{Player, between};
use crate::environment::Environment;
use crate::environment::course::{Drive, Put};
use crate::environment::execute::load_of;

/// Seconds in which a hand goes out, and in which it comes back.
const REACHING: f32 = 0.55;
/// Seconds in which a door or a drawer goes all its way, and after which it is waited for no longer.
const WHOLE_WAY: f32 = 0.9;
const PATIENCE: f32 = 4.0;
/// How near a part comes to where it is to be, as a share of its way.
const ARRIVED: f32 = 1e-3;

/// What hands are at in the course of a beat.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Handling {
    /// What is reached for, where it was at first.
    at: Option<Point3<f32>>,
    /// Where a hand holds what it holds when it does nothing with it, against the feet, and where
    /// it is brought.
    pub(super) rest: Option<Pose>,
    pub(super) out: Option<Pose>,
    /// How long somebody has waited for a door or a drawer, seconds, and whether that has arrived.
    pub(super) waited: f32,
    arrived: bool,
}

impl Player {
    /// A hand goes out, closes around a thing, and comes back with it.
    pub(super) fn take(
        &mut self,
        show: &mut Environment,
        (hand, side): (Hand, Option<Side>),
        id: NodeId,
        before: f32,
    ) -> bool {
        let (agent, feet) = (self.agent, self.feet(show));
        if self.handling.at.is_none() {
            let middle = side.and_then(|side| Some(show.world.body(id).ok()?.side(side).0));
            self.handling.at = middle.or_else(|| show.palm_on(agent, hand, id));
        }
        if before < REACHING && self.time >= REACHING {
            self.handling.out = show.world.pose(id).map(|pose| feet.inverse() * pose);
            let Environment { world, graph, .. } = &mut *show;
            let load = load_of(graph, id);
            drop(match side {
                Some(side) => world.grab_by_side(agent, (hand, side), id, &load),
                None => world.grab_with_load(agent, hand, id, &load),
            });
            self.handling.rest = world.agent(agent).ok().and_then(|agent| agent.grip(hand));
            self.come_true(show);
        }
        if self.time >= REACHING {
            self.bring(show, hand);
        }
        self.reach(show, hand, id)
    }

    /// A hand takes a thing to where it is put, and comes back without it.
    pub(super) fn put(&mut self, show: &mut Environment, put: &Put, before: f32) -> bool {
        let (agent, feet) = (self.agent, self.feet(show));
        if self.handling.at.is_none() {
            self.handling.rest = show.world.agent(agent).ok().and_then(|agent| agent.grip(put.hand));
            self.handling.out = Some(feet.inverse() * put.pose);
            self.handling.at = show.palm_on(agent, put.hand, put.id);
        }
        if self.time < REACHING {
            self.bring(show, put.hand);
        } else if before < REACHING {
            match put.tight {
                Some(at) => {
                    let start = show.start.clone();
                    drop(show.world.put_back(&start.world, (agent, put.hand), put.pose, at));
                }
                None => drop(show.world.put(agent, put.hand, put.pose)),
            }
            self.handling.at = show.palm_on(agent, put.hand, put.id);
            if put.balanced {
                drop(show.world.pin(put.id, None));
            }
            self.come_true(show);
        }
        self.reach(show, put.hand, put.id)
    }

    /// A hand goes out to a thing, or brings what it has taken.
    pub(in crate::environment) fn show_taking(&mut self, show: &mut Environment, hand: Hand, id: NodeId) {
        self.handling.at = show.palm_on(self.agent, hand, id);
        if self.time >= REACHING {
            self.handling.rest = show.world.agent(self.agent).ok().and_then(|agent| agent.grip(hand));
            self.bring(show, hand);
        }
        self.reach(show, hand, id);
    }

    /// A hand takes a thing to where it is put, or comes back without it.
    pub(in crate::environment) fn show_putting(&mut self, show: &mut Environment, put: &Put) {
        self.handling.rest = show.world.agent(self.agent).ok().and_then(|agent| agent.grip(put.hand));
        self.handling.out = Some(self.feet(show).inverse() * put.pose);
        self.handling.at = show.palm_on(self.agent, put.hand, put.id);
        if self.time < REACHING {
            self.bring(show, put.hand);
        }
        self.reach(show, put.hand, put.id);
    }

    /// A hand goes out to a door, a drawer or a lid, moves along with it, or comes back.
    pub(in crate::environment) fn show_driving(&mut self, show: &mut Environment, id: NodeId) {
        let hand = self.free_hand(show);
        let from = self.side(show, hand);
        self.handling.at = show.world.aabb(id).map(|b| b.nearest(&from));
        self.reach(show, hand, id);
    }

    /// A hand moves a door, a drawer or a lid, and stays at it until it has arrived.
    pub(super) fn drive(&mut self, show: &mut Environment, drive: &Drive, before: f32) -> bool {
        let hand = self.free_hand(show);
        let from = self.side(show, hand);
        self.handling.at = show.world.aabb(drive.id).map(|b| b.nearest(&from));
        if self.time < REACHING {
            return self.reach(show, hand, drive.id);
        }
        let moves = !self.handling.arrived
            && match drive.pushes {
                true => push(show, drive, before < REACHING),
                false => self.swing(show, drive),
            };
        if moves {
            // The hand stays where it is.
            self.handling.waited += show.world.settings().dt;
            self.time = REACHING;
        }
        self.handling.arrived = !moves;
        let over = self.reach(show, hand, drive.id);
        if over {
            let end = drive.end.iter().enumerate();
            end.for_each(|(part, open)| drop(show.world.put_open(drive.id, Some(part), *open)));
        }
        over
    }

    /// Moves what nothing is in the way of: doors open before drawers and shut after them. Gives
    /// whether anything moves still.
    fn swing(&self, show: &mut Environment, drive: &Drive) -> bool {
        let parts = show.world.parts(drive.id).all();
        let step = show.world.settings().dt / WHOLE_WAY;
        let (doors, drawers) = (JointKind::Hinge, JointKind::Slide);
        let kinds = if drive.open > 0.0 { [doors, drawers] } else { [drawers, doors] };
        let left = |part: usize| drive.end.get(part).map_or(0.0, |end| end - parts[part].open);
        let waits = |kind: JointKind| (0..parts.len()).any(|i| parts[i].kind == kind && left(i).abs() > ARRIVED);
        let Some(kind) = kinds.into_iter().find(|kind| waits(*kind)) else { return false };
        for part in (0..parts.len()).filter(|i| parts[*i].kind == kind) {
            let next = parts[part].open + left(part).clamp(-step, step);
            drop(show.world.put_open(drive.id, Some(part), next));
        }
        // What jams is not waited for.
        self.handling.waited < PATIENCE
    }

    /// A hand that holds nothing, the right one first; the right one if there is none.
    pub(super) fn free_hand(&self, show: &Environment) -> Hand {
        let free = |hand: &Hand| show.world.held(self.agent, *hand).is_none();
        Hand::BOTH.into_iter().find(free).unwrap_or(Hand::Right)
    }

    /// How far a hand has gone out, 0 to 1.
    fn share(&self) -> f32 {
        (self.time.min(2.0 * REACHING - self.time) / REACHING).clamp(0.0, 1.0)
    }

    /// Shows the body reaching for what the hand is at, or following what it holds, and keeping a thing in view;
    /// gives whether the hand is back.
    fn reach(&self, show: &mut Environment, hand: Hand, thing: NodeId) -> bool {
        let (share, side) = (self.share(), side(hand));
        let held = show.world.held(self.agent, hand).filter(|_| self.handling.out.is_some());
        let reach = match held.and_then(|id| show.palm_on(self.agent, hand, id)) {
            Some(point) => Some(Reach { side, point, share: 1.0, gaze: share }),
            None => self.handling.at.map(|point| Reach { side, point, share, gaze: share }),
        };
        let gaze = show.attended(self.agent, [thing]);
        show.poses.insert(self.agent, Activity { reach, gaze, ..Activity::default() });
        self.time >= 2.0 * REACHING
    }

    /// Brings what a hand holds as far as the hand has gone out.
    fn bring(&self, show: &mut Environment, hand: Hand) {
        self.regrip(show, hand, self.share());
    }

    pub(super) fn regrip(&self, show: &mut Environment, hand: Hand, share: f32) {
        let (Some(rest), Some(out)) = (self.handling.rest, self.handling.out) else { return };
        // It is in that hand.
        let _ = show.world.regrip(self.agent, hand, between(&rest, &out, share));
    }
}

/// Moves parts by motors, against what is in the way; gives whether any still runs.
fn push(show: &mut Environment, drive: &Drive, begins: bool) -> bool {
    if begins {
        let parts = show.world.parts(drive.id).all().len();
        (0..parts).for_each(|part| drop(show.world.drive(drive.id, part, drive.open)));
    }
    show.world.parts(drive.id).is_driven()
}

pub(super) fn side(hand: Hand) -> BodySide {
    match hand {
        Hand::Right => BodySide::Right,
        Hand::Left => BodySide::Left,
    }
}
