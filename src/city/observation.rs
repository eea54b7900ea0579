//! The observation of an agent in a city: of its own region, and the rooms behind open and glazed portals.

use std::ops::Deref;

use nalgebra::{Point3, Vector3};
use vc_graph::space::{PortalId, PortalSide, RegionId};
use vc_graph::{Anthropometry, Node, NodeId, Observation, Pose, Scope};

use super::measures::{FAR, PORTALS};
use super::{City, CityError};

/// An agent's observation in a city: that of its own region, as which it can be used, and what it sees of others.
///
/// ```
/// use virtualcity::City;
/// let city = City::make("apartment/42", 1)?;
/// let me = city.agents().next().ok_or("nobody")?;
/// let seen = city.observation(me, 3.0)?;
/// // Of a region alone it is what its environment gives.
/// let home = city.environment_of(me).ok_or("nowhere")?;
/// assert!(seen.ids().eq(home.observation(me, 3.0).ids()) && seen.beyond().is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct CityObservation {
    region: RegionId,
    own: Observation,
    beyond: Vec<Beyond>,
}

/// The observation of another region through portals.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Beyond {
    /// The region.
    pub region: RegionId,
    /// The portals through which it is seen, the nearest first.
    pub portals: Vec<PortalId>,
    /// The pose of its frame in that of the agent's region: poses of nodes are in their own region's frame.
    pub pose: Pose,
    /// The observation of the room that one enters there.
    pub seen: Observation,
}

impl CityObservation {
    /// The region of the agent.
    pub fn region(&self) -> RegionId {
        self.region
    }

    /// The observation of its own region.
    pub fn own(&self) -> &Observation {
        &self.own
    }

    /// The observations of other regions, in the order of portals.
    pub fn beyond(&self) -> &[Beyond] {
        &self.beyond
    }

    /// Everything that is seen, with its region: those of the own region first.
    pub fn references(&self) -> impl Iterator<Item = (RegionId, &Node)> {
        let own = self.own.nodes().map(|node| (self.region, node));
        own.chain(self.beyond.iter().flat_map(|other| other.seen.nodes().map(|node| (other.region, node))))
    }
}

impl Deref for CityObservation {
    type Target = Observation;

    fn deref(&self) -> &Observation {
        &self.own
    }
}

/// An opening in a frame: its threshold, with X pointing through it, and its clear width and height, metres.
#[derive(Debug, Clone, Copy)]
struct Opening {
    pose: Pose,
    width: f32,
    height: f32,
}

impl Opening {
    /// Whether a line from the near side to the far side goes through.
    fn lets_see(&self, eye: &Point3<f32>, to: &Point3<f32>) -> bool {
        let [eye, to] = [eye, to].map(|at| self.pose.inverse_transform_point(at));
        if eye.x > 0.0 || to.x <= 0.0 {
            return false;
        }
        let at = eye + (to - eye) * (eye.x / (eye.x - to.x));
        at.y.abs() <= self.width / 2.0 && (0.0..=self.height).contains(&at.z)
    }
}

/// A room of a region, and the portals through which one looks into it, one behind the other.
#[derive(Debug, Clone)]
struct Way {
    region: RegionId,
    room: NodeId,
    portals: Vec<PortalId>,
    openings: Vec<Opening>,
    /// The door of the last portal, if it stands in this room.
    door: Option<NodeId>,
    /// Whether one sees past it.
    is_open: bool,
}

impl Way {
    /// No way, within a room.
    fn within(region: RegionId, room: NodeId) -> Self {
        Self { region, room, portals: Vec::new(), openings: Vec::new(), door: None, is_open: true }
    }

    /// Whether a line of sight leads by it to a node: into the room if its last door is open, else to that door.
    fn lets_see(&self, node: NodeId, eye: &Point3<f32>, to: &Point3<f32>) -> bool {
        let to_door = self.door == Some(node);
        let openings = self.openings.len() - usize::from(to_door && !self.openings.is_empty());
        (self.is_open || to_door) && self.openings[..openings].iter().all(|opening| opening.lets_see(eye, to))
    }
}

/// A look from an agent's eyes through portals.
struct Look<'a> {
    city: &'a City,
    from: RegionId,
    eye: Point3<f32>,
    radius: f32,
    ways: Vec<Way>,
}

impl City {
    /// The things that an agent sees within a radius, metres: of its own region what [`Environment::observation`] gives; and of the rooms
    /// behind open and glazed portals of the room it is in, up to three one behind the other, what is seen through these
    /// openings from its eyes and within the radius; of a shut portal the door, if it stands beyond. Nothing within a room hides other things, as in a single home, but for
    /// closed containers. Changes nothing.
    ///
    /// [`Environment::observation`]: crate::Environment::observation
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`]; reasons for which a region cannot be made.
    pub fn observation(&self, agent: NodeId, radius: f32) -> Result<CityObservation, CityError> {
        self.observed(agent, Scope::Radius(radius), radius)
    }

    /// The things that an agent sees of its room, as the planner's belief uses it, and of the rooms behind portals, as
    /// [`observation`](Self::observation) has it, up to 60 m away.
    ///
    /// # Errors
    /// As [`observation`](Self::observation).
    pub fn room_observation(&self, agent: NodeId) -> Result<CityObservation, CityError> {
        self.observed(agent, Scope::Room, FAR)
    }

    fn observed(&self, agent: NodeId, scope: Scope, radius: f32) -> Result<CityObservation, CityError> {
        let environment = self.environment_with(agent)?;
        let own = environment.graph().observe(agent, scope);
        let region = self.region_of(agent).ok_or_else(|| CityError::NoSuchAgent(self.label(agent)))?;
        let feet = environment.world().pose(agent).map(|feet| Point3::from(feet.translation.vector));
        let eye = feet.map(|feet| feet + Vector3::z() * Anthropometry::ADULT.view);
        let Some((eye, room)) = eye.zip(own.room()) else {
            return Ok(CityObservation { region, own, beyond: Vec::new() });
        };
        let mut look = Look { city: self, from: region, eye, radius, ways: Vec::new() };
        look.through_portals_of(&Way::within(region, room))?;
        Ok(CityObservation { region, own, beyond: look.seen_by(agent)? })
    }
}

impl Look<'_> {
    /// Looks through all portals of a room that one can see through, and on through those of the rooms behind them.
    fn through_portals_of(&mut self, way: &Way) -> Result<(), CityError> {
        let space = self.city.space().clone();
        for portal in space.portals_of(way.region).filter(|_| way.portals.len() < PORTALS as usize) {
            let Some(plan) = space.portal(portal) else { continue };
            let Some((near, across)) = plan.side(way.region).zip(plan.across(way.region)) else { continue };
            let leads_back = across.region == self.from || way.portals.contains(&portal);
            let is_open = self.city.portal(portal).is_some_and(|state| state.transparent);
            let door = self.city.door_beyond(portal, way.region);
            if leads_back || (!is_open && door.is_none()) || self.room(near)? != Some(way.room) {
                continue;
            }
            let Some((frame, room)) = self.city.pose_in(self.from, way.region).zip(self.room(across)?) else {
                continue;
            };
            let mut next = Way { region: across.region, room, door, is_open, ..way.clone() };
            next.openings.push(Opening { pose: frame * near.pose, width: plan.width, height: plan.height });
            next.portals.push(portal);
            if is_open {
                self.through_portals_of(&next)?;
            }
            self.ways.push(next);
        }
        Ok(())
    }

    /// What is seen of each room at the ends of ways, by any of these.
    fn seen_by(mut self, agent: NodeId) -> Result<Vec<Beyond>, CityError> {
        self.ways.sort_by(|a, b| (a.portals.len(), &a.portals).cmp(&(b.portals.len(), &b.portals)));
        let mut all: Vec<Beyond> = Vec::new();
        for way in &self.ways {
            let Some(pose) = self.city.pose_in(self.from, way.region) else { continue };
            if all.iter().any(|known| known.region == way.region && known.seen.room() == Some(way.room)) {
                continue;
            }
            let there = self.city.seen(way.region)?;
            let seen = there.graph().glimpse(agent, way.room, |node| self.sees(node, way, &pose));
            // Behind a shut door nothing is seen of a room, and the door only from near enough.
            if !way.is_open && way.door.is_none_or(|door| !seen.sees(door)) {
                continue;
            }
            all.push(Beyond { region: way.region, portals: way.portals.clone(), pose, seen });
        }
        Ok(all)
    }

    /// Whether a node of the room at the end of a way is within the radius, and the middle of its box or one of the corners
    /// is seen, by this way or another one into the room.
    fn sees(&self, node: &Node, into: &Way, frame: &Pose) -> bool {
        let corners = node.aabb().into_iter().flat_map(|bounds| bounds.corners());
        let points = node.aabb().map(|bounds| bounds.centre()).or_else(|| node.position()).into_iter().chain(corners);
        let ways = || self.ways.iter().filter(|way| (way.region, way.room) == (into.region, into.room));
        let is_seen = |at: Point3<f32>| {
            let at = frame * at;
            (at - self.eye).norm() <= self.radius && ways().any(|way| way.lets_see(node.id(), &self.eye, &at))
        };
        points.into_iter().any(is_seen)
    }

    /// The room that one enters on a side of a portal.
    fn room(&self, side: &PortalSide) -> Result<Option<NodeId>, CityError> {
        match side.room {
            Some(room) => Ok(Some(room)),
            None => Ok(self.city.seen(side.region)?.graph().rooms().first().copied()),
        }
    }
}
