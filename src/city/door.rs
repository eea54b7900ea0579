//! Doors between two regions as things of both: a front door stands in its home, and is seen, opened, shut and walked to
//! from the gallery as well.

use nalgebra::{Point2, Point3, distance};
use vc_graph::portable::Portable;
use vc_graph::space::{PortalId, RegionId, gather};
use vc_graph::{Action, ChangeSet, NodeId, Refusal, Verb, rule};

use super::journey::{Journey, Leg, Stage};
use super::leg::walk_to;
use super::measures::{DOORWAY, LEAF, REACH};
use super::time::{is_done_at_a_door, opens_or_shuts};
use super::{City, CityError, way};
use crate::{ActionError, Interruption};

impl City {
    /// Every action that an agent can do now by the transition rule: those of its region, as
    /// [`Environment::legal_actions`](crate::Environment::legal_actions) lists them, then those with the doors of regions
    /// beyond portals. One may also walk to what is farther away.
    ///
    /// ```
    /// use virtualcity::City;
    /// use virtualcity::graph::{Action, Seed};
    /// use virtualcity::procgen::Building;
    /// let building = Building::from_seed(Seed(7))?;
    /// let (gallery, front_door) = (building.storeys()[0].gallery, building.storeys()[0].front_doors[1]);
    /// let mut city = City::of(building).make()?;
    /// let me = city.agents().next().ok_or("nobody")?;
    /// city.go(me, gallery)?;
    /// let neighbours = city.space().portal(front_door).and_then(|portal| portal.leaf).ok_or("no door")?;
    /// assert!(city.legal_actions(me)?.contains(&Action::walk(neighbours)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`]; reasons for which a region cannot be made.
    pub fn legal_actions(&self, agent: NodeId) -> Result<Vec<Action>, CityError> {
        let mut legal = self.environment_with(agent)?.legal_actions(agent);
        let region = self.region_of(agent).into_iter();
        for (_, door) in region.flat_map(|region| self.doors_beyond(region)) {
            for verb in [Verb::Walk, Verb::Run, Verb::Find, Verb::Open, Verb::Close, Verb::Touch, Verb::Push] {
                let action = Action::one(verb, door);
                legal.extend(self.refusals_beyond(agent, &action)?.is_empty().then_some(action));
            }
        }
        Ok(legal)
    }

    /// The portals of a region whose doors stand in the regions beyond, and these doors.
    pub(super) fn doors_beyond(&self, region: RegionId) -> impl Iterator<Item = (PortalId, NodeId)> + '_ {
        self.space().portals_of(region).filter_map(move |portal| Some((portal, self.door_beyond(portal, region)?)))
    }

    /// The door of a portal, if it stands in the region beyond. Those of lifts are on both sides.
    pub(super) fn door_beyond(&self, portal: PortalId, region: RegionId) -> Option<NodeId> {
        let plan = self.space().portal(portal).filter(|plan| self.lifts.at(plan).is_none())?;
        let across = plan.across(region)?.region;
        plan.leaf.filter(|leaf| self.region_of(*leaf) == Some(across))
    }

    /// The portal whose door is the object of an action, for somebody on the side where the door does not stand.
    pub(super) fn door_of(&self, agent: NodeId, action: &Action) -> Option<PortalId> {
        let (here, _) = self.begins_at(agent)?;
        let mut doors = self.doors_beyond(here);
        doors.find(|(_, door)| Some(*door) == action.object).map(|(portal, _)| portal)
    }

    /// The last portal of a way, if the object of an action is its door and stands in the region beyond.
    pub(super) fn ends_before(&self, way: &[PortalId], action: &Action) -> Option<PortalId> {
        let (portal, door) = (*way.last()?, action.object?);
        let beyond = self.region_of(door)?;
        let near = self.space().portal(portal)?.across(beyond)?.region;
        (self.door_beyond(portal, near) == Some(door)).then_some(portal)
    }

    /// The reasons why an action with something of another region is refused, as the rule has them; a door is near whose
    /// threshold is.
    pub(super) fn refusals_beyond(&self, agent: NodeId, action: &Action) -> Result<Vec<Refusal>, CityError> {
        let own = self.environment_with(agent)?.graph();
        let region = action.object.and_then(|object| self.region_of(object));
        let there = region.filter(|region| self.region_of(agent) != Some(*region));
        let there = there.map(|region| self.seen(region)).transpose()?;
        let both = gather(std::iter::once(own).chain(there.as_ref().map(|there| there.graph())), []);
        let mut refusals = rule::refusals(&both, agent, action);
        if let Some(portal) = self.door_of(agent, action).filter(|_| is_done_at_a_door(action.verb)) {
            refusals.retain(|why| !matches!(why, Refusal::NotNear { .. }));
            let far = self.far_from(agent, portal).filter(|far| *far > REACH && !self.is_crossing(agent));
            let thing = both.label(action.object.unwrap_or(agent));
            refusals.extend(far.map(|far| Refusal::NotNear { thing, distance: Some(far) }));
        }
        Ok(refusals)
    }

    /// How far somebody is from the threshold of a portal of its region, metres.
    fn far_from(&self, agent: NodeId, portal: PortalId) -> Option<f32> {
        let (plan, region) = self.space().portal(portal).zip(self.region_of(agent))?;
        let threshold = Point3::from(plan.side(region)?.pose.translation.vector);
        Some(distance(&Point3::from(self.feet(agent)?.translation.vector), &threshold))
    }

    /// The walk that brings somebody before a portal, looking at it.
    pub(super) fn walk_before(&self, agent: NodeId, portal: PortalId) -> Result<Option<Action>, CityError> {
        let Some((plan, region)) = self.space().portal(portal).zip(self.region_of(agent)) else { return Ok(None) };
        let no_floor = || CityError::of_no_floor(self.region_label(region));
        let threshold =
            Point2::from(plan.side(region).map_or_else(Default::default, |side| side.pose.translation.vector.xy()));
        let spot = self.spot_before(agent, plan, region).filter(|spot| distance(spot, &threshold) < REACH);
        let spot = spot.ok_or_else(no_floor)?;
        let to = threshold - spot;
        let heading = f64::from(to.y.angle_to(to.x).to_degrees());
        Ok(walk_to(&spot).and_then(|walk| walk.turned(heading).ok()))
    }

    /// Begins to open or shut the door of a portal from outside.
    pub(super) fn reach_for(&self, agent: NodeId, action: &Action) -> Result<Stage, CityError> {
        if self.is_pushed_there(agent, action) {
            return Ok(Stage::Handling(self.tick));
        }
        let refusals = self.refusals_beyond(agent, action)?;
        let until = self.tick + LEAF;
        if refusals.is_empty() { Ok(Stage::Handling(until)) } else { Err(ActionError::Refused(refusals).into()) }
    }

    /// Whether a door that met something when somebody first moved it is by now as it was to be.
    fn is_pushed_there(&self, agent: NodeId, action: &Action) -> bool {
        let tried = self.journeys.get(&agent).is_some_and(Journey::has_tried);
        let is = |door| self.is_open(door) == (action.verb == Verb::Open);
        tried && opens_or_shuts(action.verb) && action.object.is_some_and(is)
    }

    /// Opens and shuts the doors at which hands have been for long enough. None is moved through somebody.
    pub(super) fn doors_pass(&mut self) {
        let now = self.tick;
        let crosses = |portal: PortalId| {
            self.journeys.values().filter_map(Journey::crossing).any(|crossing| crossing.portal == portal)
        };
        let due = self.journeys.iter().filter_map(|(agent, journey)| match (&journey.stage, journey.legs.front()) {
            (Stage::Handling(until), Some(Leg::Leaf(portal, action))) if *until <= now && !crosses(*portal) => {
                Some((*agent, *portal, *action))
            }
            _ => None,
        });
        for (agent, portal, action) in due.collect::<Vec<(NodeId, PortalId, Action)>>() {
            let met = || self.in_doorway(portal).or_else(|| self.in_swing(portal));
            let met = if opens_or_shuts(action.verb) { met() } else { None };
            let free = self.clear_doorway(agent, &action, met);
            match free.and_then(|()| self.move_door(agent, action)) {
                Ok(changes) => {
                    self.changed(agent, changes);
                    self.leg_done(agent);
                }
                Err(why) => self.leg_failed(agent, why),
            }
        }
    }

    /// Somebody on the other side of a door of one's region, in whose doorway one opens or shuts it.
    pub(super) fn behind_door(&self, agent: NodeId, action: &Action) -> Option<(RegionId, NodeId)> {
        let (region, door) = self.region_of(agent).zip(action.object.filter(|_| opens_or_shuts(action.verb)))?;
        let mut portals = self.space().portals_of(region);
        let portal = portals.find(|id| self.space().portal(*id).is_some_and(|plan| plan.leaf == Some(door)))?;
        self.in_doorway(portal).filter(|(beyond, _)| *beyond != region)
    }

    /// Refuses if somebody is in a doorway, who is asked to make way.
    pub(super) fn clear_doorway(
        &mut self,
        agent: NodeId,
        action: &Action,
        met: Option<(RegionId, NodeId)>,
    ) -> Result<(), CityError> {
        let Some(((region, by), door)) = met.zip(action.object) else { return Ok(()) };
        let space = self.space().clone();
        let portals = space.portals_of(region).filter_map(|portal| space.portal(portal));
        let plan = portals.filter(|plan| plan.leaf == Some(door)).last();
        plan.into_iter().for_each(|plan| self.make_way(agent, region, &way::mouth(plan, region)));
        let why = Interruption::InDoorway { door: self.label(door), by: self.label(by) };
        Err(self.environment_with(agent)?.interrupted(action, why).into())
    }

    /// Somebody who stands in the doorway of a portal, and on which side.
    fn in_doorway(&self, portal: PortalId) -> Option<(RegionId, NodeId)> {
        let plan = self.space().portal(portal)?;
        plan.sides.iter().find_map(|side| {
            let is_in = |at: &Point2<f32>| {
                let at = side.pose.inverse_transform_point(&Point3::new(at.x, at.y, side.pose.translation.z));
                at.x.abs() < DOORWAY && at.y.abs() < plan.width / 2.0
            };
            let mut people = self.environment(side.region)?.people_but(NodeId(0));
            people.find(|(_, at)| is_in(at)).map(|(id, _)| (side.region, id))
        })
    }

    /// Somebody who stands where the leaf of a portal swings, in its region.
    fn in_swing(&self, portal: PortalId) -> Option<(RegionId, NodeId)> {
        let leaf = self.space().portal(portal)?.leaf?;
        let region = self.region_of(leaf)?;
        let there = self.environment(region)?;
        let met = there.people_but(NodeId(0)).find(|(id, _)| there.is_swept_by(*id, leaf));
        met.map(|(id, _)| (region, id))
    }

    fn move_door(&mut self, agent: NodeId, action: Action) -> Result<ChangeSet, CityError> {
        let is_there = self.is_pushed_there(agent, &action);
        let refusals = if is_there { Vec::new() } else { self.refusals_beyond(agent, &action)? };
        let door = action.object.and_then(|door| Some((self.region_of(door)?, door)));
        let Some((region, door)) = door.filter(|_| refusals.is_empty()) else {
            return Err(ActionError::Refused(refusals).into());
        };
        self.wake(region)?;
        self.draw_to_leaf(region, door);
        Ok(self.wake(region)?.move_leaf_from_outside(agent, action)?)
    }
}
