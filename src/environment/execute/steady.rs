//! Seeing to it that what was put down stays there.

use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, Place, Pose, Relation};
use vc_physics::{BodyRole, SpotOrder};

use super::planner::{Plan, Planner, Planning};
use super::spot::{AWAY, FreeSpot};
use super::task::Task;
use crate::environment::motion::BodyMotion;
use crate::environment::whereabouts::Whereabouts;

/// How far others may be pushed aside by what is put down beside them, metres.
const ASIDE: f32 = 0.15;
/// How far a thing may roll from where it was put on another, metres.
const ROLLED: f32 = 0.04;

/// A thing that was put down and is to stay where it is, and what is beside it too.
///
/// If they come to rest elsewhere, it is put in the middle instead, or in a container where there is room once the
/// others are pushed together; and if that does not help, it is balanced where it was put. In a container the others are
/// pushed together for what has tipped over, too. In furniture that somebody has opened or shut meanwhile all stays as it
/// has come to lie.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::environment) struct Steadying {
    id: NodeId,
    place: Place,
    /// Where it was put at first, and where it has been put now.
    spot: Pose,
    now: Pose,
    /// The loose things around it, where they were before.
    around: Vec<(NodeId, Pose)>,
    /// The place as it was then.
    there: Whereabouts,
    stage: Stage,
}

/// How far the attempts have come. Out of a hand, a thing is out of the way before each next one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Stage {
    First,
    InTheMiddle,
    PutInTheMiddle,
    BesideOthers,
    /// The others have been pushed together for a spot.
    OthersPushed(Pose, Former),
    PutBesideOthers(Former),
}

/// The poses before others were pushed together. They return to them if that does not help.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Former {
    poses: Vec<(NodeId, Pose)>,
    /// Whether the thing itself is among them: it had come to rest, but tipped over.
    tipped: bool,
}

impl Planner<'_> {
    /// Puts down a thing, and sees to it that it stays.
    pub(super) fn watched(&self, put: BodyMotion, id: NodeId, place: Place, spot: Pose) -> Plan {
        let around = self.loose_around(place);
        let there = Whereabouts::of(self.world, place.at);
        let steadying = Steadying { id, place, spot, now: spot, around, there, stage: Stage::First };
        Plan::of([put, BodyMotion::ComeToRest]).then(Task::Steady(steadying))
    }

    pub(super) fn steady(&mut self, mut of: Steadying) -> Planning {
        if !self.is_movable(of.id) {
            // Somebody has taken it meanwhile.
            return Ok(Plan::default());
        }
        let waited = matches!(of.stage, Stage::First | Stage::PutInTheMiddle | Stage::PutBesideOthers(_));
        if waited && of.there.differ(self.world) {
            // Poses from before are nowhere now.
            return Ok(Plan::default());
        }
        of.around.retain(|(id, _)| self.is_movable(*id));
        if let Stage::OthersPushed(_, former) | Stage::PutBesideOthers(former) = &mut of.stage {
            former.poses.retain(|(id, _)| self.is_movable(*id));
        }
        let inside = of.place.relation == Relation::Inside;
        match of.stage {
            Stage::First if !self.rests(&of) => Ok(clear_away(of, Stage::InTheMiddle)),
            Stage::First if inside && self.has_tipped(&of) => Ok(self.beside_others(&of, true).unwrap_or_default()),
            Stage::InTheMiddle => Ok(self.in_the_middle(of)),
            Stage::PutInTheMiddle if !self.rests(&of) => Ok(clear_away(of, Stage::BesideOthers)),
            Stage::BesideOthers => {
                let plan = if inside { self.beside_others(&of, false) } else { None };
                Ok(plan.unwrap_or_else(|| Plan::of([balance(&of)])))
            }
            Stage::OthersPushed(now, former) => {
                let around = self.loose_around(of.place);
                Ok(put_again(Steadying { now, around, stage: Stage::PutBesideOthers(former), ..of }))
            }
            Stage::PutBesideOthers(ref former) if !self.rests(&of) => {
                let held = (!former.tipped).then(|| balance(&of));
                Ok(Plan::of([BodyMotion::PutBack(former.poses.clone())].into_iter().chain(held)))
            }
            Stage::First | Stage::PutInTheMiddle | Stage::PutBesideOthers(_) => Ok(Plan::default()),
        }
    }

    /// A thing that is out of the way has to be put somewhere, so that what cannot be asked counts as no room.
    fn in_the_middle(&self, of: Steadying) -> Plan {
        match self.spot_in_order(of.id, of.place, SpotOrder::Middle) {
            Ok(Some(now)) => put_again(Steadying { now, stage: Stage::PutInTheMiddle, ..of }),
            Ok(None) | Err(_) => Task::Steady(Steadying { stage: Stage::BesideOthers, ..of }).into(),
        }
    }

    /// Pushes the others together, if there is room for the thing then.
    fn beside_others(&mut self, of: &Steadying, tipped: bool) -> Option<Plan> {
        let mut without = self.world.clone();
        without.place(of.id, Pose::translation(0.0, 0.0, AWAY)).ok()?;
        let FreeSpot { spot, first } = self.in_world(&without).make_room(of.id, of.place).ok()??;
        let stage = Stage::OthersPushed(spot, Former { poses: self.poses(of, tipped), tipped });
        Some(Plan::of(first).then(Task::Steady(Steadying { stage, ..of.clone() })))
    }

    fn is_movable(&self, id: NodeId) -> bool {
        matches!(self.world.role(id), Some(BodyRole::Loose | BodyRole::Hung))
    }

    /// Whether a thing that was put to a spot stays at its place, on top of things about at the
    /// spot, and those around it about where they were.
    fn rests(&self, of: &Steadying) -> bool {
        let far = |id: NodeId, was: &Pose| {
            let now = self.world.pose(id);
            now.map_or(f32::INFINITY, |now| (now.translation.vector - was.translation.vector).norm())
        };
        let (id, at, inside) = (of.id, of.place.at, of.place.relation == Relation::Inside);
        let rolled = !inside && far(id, &of.now) > ROLLED;
        let across = || !inside && self.world.supports(id).contains(&at);
        !rolled
            && (self.world.body(id).is_ok_and(|thing| thing.is_at(at, inside)) || across())
            && of.around.iter().all(|(id, was)| far(*id, was) < ASIDE)
            && !(inside && self.is_in_the_way(id, at))
    }

    /// Whether a thing does not stand or lie as it was put.
    fn has_tipped(&self, of: &Steadying) -> bool {
        self.world.pose(of.id).is_some_and(|now| !Self::is_upright(&now, &of.now))
    }

    /// Whether a thing as it lies keeps another from being shut.
    fn is_in_the_way(&self, id: NodeId, at: NodeId) -> bool {
        let pose = self.world.pose(id);
        pose.is_some_and(|pose| self.world.parts(at).are_kept_open_by(id, &pose).unwrap_or(false))
    }

    /// Where the movable things at the place are, and the thing itself.
    fn poses(&self, of: &Steadying, with_it: bool) -> Vec<(NodeId, Pose)> {
        let there = self.before.carried_with(of.place.at).into_iter();
        let there = there.filter(|id| *id != of.place.at && self.is_movable(*id));
        there.chain(with_it.then_some(of.id)).filter_map(|id| Some((id, self.world.pose(id)?))).collect()
    }
}

fn clear_away(of: Steadying, stage: Stage) -> Plan {
    let motion = BodyMotion::ClearAway(of.id, of.around.clone());
    Plan::from(motion).then(Task::Steady(Steadying { stage, ..of }))
}

fn put_again(of: Steadying) -> Plan {
    Plan::of([BodyMotion::PutAgain(of.id, of.now, false), BodyMotion::ComeToRest]).then(Task::Steady(of))
}

fn balance(of: &Steadying) -> BodyMotion {
    BodyMotion::PutAgain(of.id, of.spot, true)
}
