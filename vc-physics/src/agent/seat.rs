//! Seats and beds: places for people on a thing, sitting and lying down.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::geometry::Collider;
use rapier3d::math::Pose as EnginePose;
use rapier3d::parry;
use vc_graph::asset::{Hold, Surface};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose};

use crate::convert::facing;
use crate::state::{Agent, Motion, Posture, Thing, upright};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError, convert};

/// The largest distance to the body's future position from which an agent can sit or lie down, metres: one
/// step.
const STEP: f32 = 1.5;
/// The largest number of places counted on one thing.
const MOST: u32 = 64;
/// The largest height difference between surfaces that form one seat, metres, and the smallest area of each
/// relative to the largest: cushions lie side by side, and armrests are not seats.
const STEPPED: f32 = 0.06;
const ALIKE: f32 = 0.4;
/// How far beside the middle of a body that lies a seat is free, metres.
const BROAD: f32 = 0.35;
/// How far cushions in a row may be beside one another, metres.
const ALIGNED: f32 = 0.15;
/// Half the length and width of a level on which a body fits, metres.
const LONG: f32 = 0.6;
const WIDE: f32 = 0.2;
/// Heights of surfaces for sitting, metres above the floor.
const SEATS: std::ops::Range<f32> = 0.2..0.95;
/// The largest mass of a thing on a seat that agents sit upon, kilograms.
const LIGHT: f32 = 2.0;
/// The largest height of such a thing above the seat, metres: that of a folded duvet.
const FLAT: f32 = 0.25;

/// # Seats and beds
impl PhysicsWorld {
    /// Places to sit or to lie on a thing, in the world's frame.
    pub(crate) fn places_on(&self, thing: &Thing, lying: bool) -> Vec<Pose> {
        let Some(pose) = self.engine.pose(thing.state.base) else { return Vec::new() };
        let (levels, count) = (levels(thing, lying), if lying { thing.places.beds } else { thing.places.seats });
        let shares = share_out(&levels, count);
        let each = levels.iter().zip(shares).flat_map(|(level, n)| (0..n).map(move |i| level.place(i, n)));
        each.map(|place| pose * place).collect()
    }

    /// Sits an agent down on a node: on one of its [`seats`](crate::BodyView::seats), counted from 0, or on the nearest
    /// free one. Cushions, covers and other light or flat things do not occupy a place: agents sit on them.
    ///
    /// # Errors
    /// [`AgentError::Posture`] if the agent does not stand, [`AgentError::NoSeat`], [`AgentError::OutOfReach`],
    /// [`AgentError::SeatTaken`] by other agents, [`AgentError::SeatCovered`] by things, [`AgentError::Held`]
    /// if somebody carries the node; for a seat with a number [`AgentError::NoSuchSeat`], [`AgentError::PlaceTaken`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::Posture;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.6, 1.5, 0.0))?;
    /// let none = world.sit(home.person, home.chair, Some(1)).unwrap_err();
    /// assert!(none.to_string().ends_with("has 1 seats: there is no seat 2"));
    /// world.sit(home.person, home.chair, None)?;
    /// assert_eq!(world.posture(home.person), Some(Posture::Sitting(home.chair, 0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sit(&mut self, agent: NodeId, on: NodeId, seat: Option<u32>) -> Result<(), AgentError> {
        let places = self.places_on(self.thing(on)?, false);
        if let Some(seat) = seat {
            self.check_seat(agent, on, seat, places.len())?;
        }
        self.settle_down(agent, on, &places, seat, Posture::Sitting)
    }

    /// Whether a node has a seat, and nobody else is on it.
    fn check_seat(&self, agent: NodeId, on: NodeId, seat: u32, count: usize) -> Result<(), AgentError> {
        let number = seat.saturating_add(1);
        if count <= seat as usize {
            return Err(AgentError::NoSuchSeat { seat: on, number, count });
        }
        let mut others = self.agents.iter().filter(|(other, _)| **other != agent);
        match others.find(|(_, other)| other.posture.seat() == Some((on, seat))) {
            Some((&by, _)) => Err(AgentError::PlaceTaken { seat: on, number, by }),
            None => Ok(()),
        }
    }

    /// Lays an agent down on a node.
    ///
    /// # Errors
    /// As [`Self::sit`].
    pub fn lie(&mut self, agent: NodeId, on: NodeId) -> Result<(), AgentError> {
        let places = self.places_on(self.thing(on)?, true);
        self.settle_down(agent, on, &places, None, Posture::Lying)
    }

    fn settle_down(
        &mut self,
        agent: NodeId,
        on: NodeId,
        places: &[Pose],
        only: Option<u32>,
        posture: fn(NodeId, u32) -> Posture,
    ) -> Result<(), AgentError> {
        if self.thing(on)?.state.role == BodyRole::Carried {
            return Err(AgentError::Held(on));
        }
        let body = self.standing_mut(agent)?;
        let feet = body.feet;
        let half = if matches!(posture(on, 0), Posture::Lying { .. }) { body.plan.height / 2.0 } else { 0.0 };
        let far = |p: &Pose| {
            let own = p.inverse_transform_point(&feet.translation.vector.into()).coords;
            (own.x.abs() - half).max(0.0).hypotenuse(own.y)
        };
        let lies = matches!(posture(on, 0), Posture::Lying(..));
        let taken = |i: u32| self.agents.values().any(|a| is_taken(a, on, (i, &places[i as usize], lies)));
        let each = places.iter().enumerate().map(|(i, p)| (far(p), i as u32));
        let mut order: Vec<(f32, u32)> = each.filter(|(_, i)| only.is_none_or(|only| only == *i)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let &(nearest, _) = order.first().ok_or(AgentError::NoSeat(on))?;
        if nearest > STEP {
            return Err(AgentError::OutOfReach { agent, id: on, distance: nearest, reach: STEP });
        }
        let free: Vec<u32> = order.iter().map(|(_, i)| *i).filter(|i| !taken(*i)).collect();
        let &first = free.first().ok_or(AgentError::SeatTaken(on))?;
        let covered = |i: u32| self.covers(agent, on, &places[i as usize], posture(on, i));
        let Some(&place) = free.iter().find(|i| covered(**i).is_none()) else {
            return Err(covered(first).map_or(AgentError::SeatTaken(on), |by| AgentError::SeatCovered { seat: on, by }));
        };
        let body = self.agent_mut(agent)?;
        (body.stood, body.feet) = (body.feet, upright(&places[place as usize]));
        body.posture = posture(on, place);
        body.walk = Motion::Still;
        self.embody(agent, true);
        Ok(())
    }

    /// The thing on a seat that is in the way of an agent's body.
    fn covers(&self, agent: NodeId, seat: NodeId, place: &Pose, posture: Posture) -> Option<NodeId> {
        let (body, seat) = (self.agent_state(agent).ok()?, self.thing(seat).ok()?);
        let (shape, at, _) = body.plan.body(posture);
        let at = convert::pose(&upright(place)) * at;
        let stands = |id: &NodeId| self.aabb(*id).is_some_and(|b| b.max.z > place.translation.z + FLAT);
        let heavy = |id: &NodeId| self.thing(*id).is_ok_and(|thing| thing.mass() > LIGHT);
        let meets = |id: &NodeId| {
            let bodies = self.thing(*id).into_iter().flat_map(Thing::bodies).filter_map(|b| self.engine.bodies.get(b));
            let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|c| self.engine.colliders.get(*c));
            let meets = |c: &Collider| {
                let between = at.inv_mul(c.position());
                let result = parry::query::intersection_test(&EnginePose::IDENTITY, &*shape, &between, c.shape());
                result.is_ok_and(|result| result.intersecting)
            };
            colliders.into_iter().any(meets)
        };
        self.load_of(seat.state.base).into_iter().find(|id| stands(id) && heavy(id) && meets(id))
    }

    /// Sets the pose at which an agent that sits or lies [stood before](crate::AgentView::stood_before), and with it the height at
    /// which it gets up: an agent may sit from the start.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NotFinite`].
    pub fn set_stood_before(&mut self, agent: NodeId, feet: Pose) -> Result<(), AgentError> {
        if !convert::is_sound(&feet) {
            return Err(PhysicsError::NotFinite("the pose", agent).into());
        }
        let body = self.agent_mut(agent)?;
        (body.stood, body.floor) = (upright(&feet), feet.translation.z);
        Ok(())
    }
}

/// Whether somebody on a thing has one of its places: the same one, or one across which the body lies.
fn is_taken(by: &Agent, on: NodeId, (index, place, lies): (u32, &Pose, bool)) -> bool {
    let (bed, seat) = match by.posture {
        Posture::Sitting(at, number) if at == on && !lies => return number == index,
        Posture::Lying(at, number) if at == on && lies => return number == index,
        Posture::Sitting(at, _) if at == on => (place, &by.feet),
        Posture::Lying(at, _) if at == on => (&by.feet, place),
        _ => return false,
    };
    let own = bed.inverse_transform_point(&seat.translation.vector.into());
    own.x.abs() < by.plan.height / 2.0 && own.y.abs() < BROAD
}

/// A level on which people sit or lie side by side, in the asset's frame.
struct Level {
    centre: Point3<f32>,
    half: (f32, f32),
    /// Whether bodies lie along Y, and side by side along X.
    across: bool,
}

impl Level {
    /// The half width of one of `count` places, metres.
    fn room(&self, count: u32) -> f32 {
        (if self.across { self.half.0 } else { self.half.1 }) / count as f32
    }

    /// The middle of one of `count` places.
    fn place(&self, index: u32, count: u32) -> Pose {
        let aside = self.room(count) * (2 * index + 1) as f32 - self.room(1);
        let (x, y) = if self.across { (aside, 0.0) } else { (0.0, aside) };
        let turn = if self.across { facing(0.0, 1.0) } else { UnitQuaternion::identity() };
        Pose::from_parts((self.centre.coords + Vector3::new(x, y, 0.0)).into(), turn)
    }
}

/// Distributes places over the levels: each goes where it leaves the most room.
fn share_out(levels: &[Level], count: u32) -> Vec<u32> {
    let mut shares = vec![0; levels.len()];
    for _ in 0..count.min(MOST) {
        let room = |i: &usize| levels[*i].room(shares[*i] + 1);
        let widest = (0..levels.len()).rev().max_by(|a, b| room(a).total_cmp(&room(b)));
        widest.into_iter().for_each(|i| shares[i] += 1);
    }
    shares
}

/// The levels on which people sit or lie: the largest level surface at the height of seats and the surfaces that
/// continue it; or the top of the box.
fn levels(thing: &Thing, lying: bool) -> Vec<Level> {
    let area = |s: &&Surface| s.half.0 * s.half.1;
    let level = thing.form.surfaces.iter().filter(|s| s.hold == Hold::On && SEATS.contains(&s.centre.z));
    let largest = level.clone().max_by(|a, b| area(a).total_cmp(&area(b)));
    let (low, high) = thing.form.extent;
    let Some(largest) = largest else {
        let middle = nalgebra::center(&low, &high);
        let top = high.z.min(low.z + 0.5 * (high.z - low.z).max(0.9));
        let half = ((high.x - low.x) / 2.0, (high.y - low.y) / 2.0);
        let across = lying && half.1 > half.0;
        return vec![Level { centre: Point3::new(middle.x, middle.y, top), half, across }];
    };
    let like = |s: &&Surface| (s.centre.z - largest.centre.z).abs() < STEPPED && area(s) > ALIKE * area(&largest);
    let alike: Vec<&Surface> = level.filter(like).collect();
    if lying {
        return vec![bed(&alike, &thing.form.surfaces)];
    }
    alike.into_iter().map(|s| Level { centre: s.centre, half: s.half, across: false }).collect()
}

/// The level on which a body lies: cushions in a row count as one, and whoever does not fit onto a rim lies inside.
fn bed(alike: &[&Surface], all: &[Surface]) -> Level {
    type Top = (Point3<f32>, (f32, f32));
    let fits = |(_, half): &Top| half.0.max(half.1) >= LONG && half.0.min(half.1) >= WIDE;
    let rank = |top: &Top| (fits(top), top.1.0 * top.1.1);
    let order = |a: &Top, b: &Top| rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1));
    let rows = alike.iter().flat_map(|s| [row(s, alike, 0), row(s, alike, 1)]);
    let inside = all.iter().filter(|s| s.hold == Hold::Inside && s.joint.is_none()).map(|s| (s.centre, s.half));
    let (row, inside) = (rows.max_by(order), inside.filter(fits).max_by(order));
    let best = row.filter(fits).or(inside).or(row);
    let (centre, half) = best.unwrap_or_else(|| (Point3::origin(), (0.0, 0.0)));
    Level { centre, half, across: half.1 > half.0 }
}

/// A surface together with those that continue it along an axis.
fn row(of: &Surface, alike: &[&Surface], axis: usize) -> (Point3<f32>, (f32, f32)) {
    let across = 1 - axis;
    let half = |s: &Surface, axis: usize| if axis == 0 { s.half.0 } else { s.half.1 };
    let aligned = |s: &&&Surface| {
        let off = (s.centre[across] - of.centre[across]).abs();
        off.max((half(s, across) - half(of, across)).abs()) < ALIGNED
    };
    let ends = |s: &&Surface| (s.centre[axis] - half(s, axis), s.centre[axis] + half(s, axis));
    let joined = |a: (f32, f32), b: (f32, f32)| (a.0.min(b.0), a.1.max(b.1));
    let (low, high) = alike.iter().filter(aligned).map(ends).fold(ends(&of), joined);
    let (mut centre, mut halves) = (of.centre, [of.half.0, of.half.1]);
    (centre[axis], halves[axis]) = ((low + high) / 2.0, (high - low) / 2.0);
    (centre, (halves[0], halves[1]))
}
