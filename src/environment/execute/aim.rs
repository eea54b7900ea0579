//! Points, headings, slots and sides that an action asks for.

use nalgebra::{Point2, Vector2};
use vc_graph::rule::Aimed;
use vc_graph::{Action, Aim, AimPart, AimPoint, NodeId, ObjectRole, Place, Pose, Relation, SceneGraph, Side};
use vc_physics::{AgentError, PhysicsWorld, Posture, SpotFault, SpotSearch, SpotWish, StandingPose};

use super::planner::{Plan, Planner, Planning};
use super::stand::APART;
use super::towards;
use crate::environment::motion::{BodyMotion, Put};
use crate::environment::{PhysicalRefusal, SpotRefusal};

/// How far beside the free floor somebody may stand who just fits there, metres.
const BESIDE: f32 = 0.1;
/// A turn that is none, radians.
const UNTURNED: f32 = 1e-4;
/// The length of a direction over the floor from which a side is beside a thing, not above or below it.
const LEVEL: f32 = 0.5;

impl Planner<'_> {
    /// The side by which a thing is to be taken.
    pub(super) fn asked_side(&self) -> Option<Side> {
        match self.action.aim.part()? {
            AimPart::Side(side) => Some(side),
            _ => None,
        }
    }

    /// The seat on which the agent is to sit, counted from 0.
    pub(super) fn asked_seat(&self) -> Option<u32> {
        match self.action.aim.part()? {
            AimPart::Seat(number) => u32::from(number).checked_sub(1),
            _ => None,
        }
    }

    /// The surface on which a thing is to be put, counted from 0.
    fn asked_slot(&self) -> Option<usize> {
        match self.action.aim.part()? {
            AimPart::Slot(number) => usize::from(number).checked_sub(1),
            _ => None,
        }
    }

    /// Goes to a point.
    pub(super) fn go_to_point(&mut self, point: AimPoint) -> Planning {
        self.floor.update(self.world);
        let spot = point.plan();
        let upright = Pose::translation(spot.x, spot.y, self.floor.options().level);
        let good = self.at_need_nudging(|planner| Ok(planner.is_good(&upright, None).then_some(())))?;
        if good.is_none() {
            return Err(self.point_taken(point, &upright)?);
        }
        let from = Point2::from(self.feet().translation.vector.xy());
        let route = self.floor.route(from, spot);
        let ends = |end: &Point2<f32>| (end - spot).norm() <= BESIDE;
        let mut route =
            route.filter(|route| route.points.last().is_some_and(ends)).ok_or(PhysicalRefusal::NoWay(point))?;
        if route.points.last() != Some(&spot) {
            route.points.push(spot);
        }
        let came = route.points.iter().rev().map(|p| spot - p).find(|way| way.norm() > 1e-3);
        let turn = self.front_at(&spot).or(came).map_or(self.feet().rotation, towards);
        let turn = self.action.aim.heading().map_or(turn, |heading| heading.rotation());
        self.walk(StandingPose { feet: Pose::from_parts(upright.translation, turn), route })
    }

    /// The direction to the object of the action from a spot.
    fn front_at(&self, spot: &Point2<f32>) -> Option<Vector2<f32>> {
        let id = self.action.object.filter(|id| !self.before.rooms().contains(id))?;
        let way = self.world.aabb(id)?.centre().xy() - spot;
        (way.norm() > BESIDE).then_some(way)
    }

    fn point_taken(&self, point: AimPoint, feet: &Pose) -> Result<PhysicalRefusal, PhysicalRefusal> {
        let spot = feet.translation.vector.xy();
        let is_there =
            |id: &NodeId| self.world.pose(*id).is_some_and(|p| (p.translation.vector.xy() - spot).norm() < APART);
        let mut by = self.world.standing(self.agent, feet)?.obstacles();
        by.extend(self.world.agents().filter(|id| *id != self.agent && is_there(id)));
        by.sort_unstable();
        by.dedup();
        Ok(PhysicalRefusal::PointTaken { point, by: by.into_iter().map(|id| self.before.label(id)).collect() })
    }

    /// Turns by a heading, or to a point; somebody who sits or lies turns no more than the head.
    pub(super) fn turn_as(&self, aim: &Aim) -> Plan {
        let feet = self.feet();
        let turn = aim.turn_from(&feet.translation.vector.xy().into()).filter(|_| self.stands());
        let turn = turn.filter(|turn| turn.angle_to(&feet.rotation) > UNTURNED);
        Plan::of(turn.map(|turn| BodyMotion::Turn(Pose::from_parts(feet.translation, turn))))
    }

    /// Turns by the heading of an aim, where the agent stands.
    pub(super) fn stand_as(&self, aim: &Aim) -> Plan {
        aim.heading().map_or_else(Plan::default, |heading| self.turn_as(&Aim::NOTHING.with_heading(heading)))
    }

    /// Puts a held thing where and as the action asks.
    pub(super) fn put_as_asked(&mut self, id: NodeId, place: Place) -> Planning {
        let hand = self.hand_with(id)?;
        self.floor.update(self.world);
        let (pose, fold) = match self.asked_spot(id, place) {
            Ok(pose) => (pose, None),
            // Cloth is folded where it is too large as it is.
            Err(why) => {
                let Some((world, fold)) = self.folded(id)? else { return Err(why) };
                (self.in_world(&world).asked_spot(id, place).map_err(|_| why)?, Some(fold))
            }
        };
        let put = BodyMotion::Put(Put { hand, id, pose, balanced: false, tight: None, with: None });
        let step = if !self.stands() || self.puts_from(&self.feet(), id, &pose) {
            self.turn_to(pose.translation.vector.into())
        } else {
            let stand = self.stand_to_put(self.before.room_of(self.agent), id, &pose)?;
            self.walk(stand.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(place.at)))?)?
        };
        Ok(Plan::of(fold.into_iter().chain(step.motions).chain([put, BodyMotion::ComeToRest])))
    }

    fn asked_spot(&self, id: NodeId, place: Place) -> Result<Pose, PhysicalRefusal> {
        let aim = self.action.aim;
        let wish = SpotWish {
            point: aim.point().map(|point| point.plan()),
            height: aim.point().and_then(|point| point.height()),
            rotation: aim.heading().map(|heading| heading.rotation()),
            surface: self.asked_slot(),
        };
        let inside = place.relation == Relation::Inside;
        let admits = |spot: &Pose| self.may_be_put(id, place, spot);
        let spot = SpotSearch::new(id, place.at, inside).order(self.near_hands()).wished(self.world, &wish, admits)?;
        spot.map_err(|fault| {
            let why = self.spot_refusal(fault, inside);
            PhysicalRefusal::NotAsAsked { thing: self.before.label(id), at: self.before.label(place.at), why }
        })
    }

    fn spot_refusal(&self, fault: SpotFault, inside: bool) -> SpotRefusal {
        match fault {
            SpotFault::TooLow => SpotRefusal::TooLow,
            SpotFault::Unsupported => SpotRefusal::WouldNotRest,
            SpotFault::NotAdmitted if inside => SpotRefusal::KeepsOpen,
            SpotFault::NotAdmitted => SpotRefusal::ShutsIn,
            SpotFault::Taken(by) => SpotRefusal::Taken(by.into_iter().map(|id| self.before.label(id)).collect()),
            _ => SpotRefusal::OffSurface,
        }
    }

    /// Lets go of a held thing at the point of the floor that the action asks for, on a rug if one is there.
    pub(super) fn let_go_as_asked(&mut self, id: NodeId) -> Planning {
        let room = self.before.room_of(self.agent);
        let role = |id: &NodeId| self.before.node(*id).map(vc_graph::Node::role);
        let there = |wanted| {
            room.into_iter().flat_map(|room| self.before.in_room(room)).filter(move |id| role(id) == Some(wanted))
        };
        let grounds: Vec<NodeId> = there(ObjectRole::Rug).chain(there(ObjectRole::Floor)).collect();
        let mut refused = PhysicalRefusal::NoStand(self.before.label(self.agent));
        for at in grounds {
            match self.put_as_asked(id, Place { relation: Relation::On, at }) {
                Err(why) if why.is_off_surface() => refused = why,
                planned => return planned,
            }
        }
        Err(refused)
    }

    /// Brings a side of a thing within reach of the hands.
    pub(super) fn reach_side(&mut self, id: NodeId, side: Side) -> Planning {
        let body = self.world.body(id).map_err(|_| PhysicalRefusal::NoBody(self.before.label(id)))?;
        let (middle, out) = body.side(side);
        if let Some(&by) = body.things_at_side(side).first() {
            return Err(AgentError::SideTaken { id, side, by }.into());
        }
        let reach = self.body().reach;
        let gets_at = |planner: &Self, feet: &Pose| {
            let before = (feet.translation.vector - middle.coords).xy().dot(&out.xy()) > 0.0;
            let there = planner.world.standing(planner.agent, feet);
            (before || out.xy().norm() < LEVEL) && there.is_ok_and(|there| there.point_distance(middle) <= reach)
        };
        if gets_at(self, &self.feet()) || !self.stands() {
            return Ok(self.face(id));
        }
        self.floor.update(self.world);
        let room = self.before.room_of(self.agent);
        let stand = self.at_need_nudging(|planner| planner.stand_where(id, room, |feet| gets_at(planner, feet)))?;
        self.walk(stand.ok_or_else(|| PhysicalRefusal::NoSide { thing: self.before.label(id), side })?)
    }
}

/// How far an agent, or a thing that it has put down, may be from where an action asks for it, metres, and how far it
/// may be turned from that, degrees.
const OFF: f32 = 0.01;
const TURNED: f32 = 2.0;

/// The refusal of an action after which what it aims at is not where and as it was asked for.
pub(in crate::environment) fn off_aim(
    world: &PhysicsWorld,
    graph: &SceneGraph,
    agent: NodeId,
    action: &Action,
) -> Option<PhysicalRefusal> {
    let (aim, places) = (action.aim, graph.vocabulary().rule(action.verb)?.aims.places?);
    let id = if places == Aimed::Object { action.object? } else { agent };
    let stands = world.posture(agent) == Some(Posture::Standing);
    let pose = world.pose(id).filter(|_| !aim.is_nothing() && (places != Aimed::Front || stands))?;
    let at = Point2::from(pose.translation.vector.xy());
    let (point, turn) = match places {
        Aimed::Front => (None, aim.turn_from(&at)),
        _ => (aim.point(), aim.heading().map(|heading| heading.rotation())),
    };
    let metres = point.map_or(0.0, |point| (at - point.plan()).norm());
    let degrees = turn.map_or(0.0, |turn| pose.rotation.angle_to(&turn).to_degrees());
    (metres > OFF || degrees > TURNED).then(|| PhysicalRefusal::OffAim { thing: graph.label(id), metres, degrees })
}
