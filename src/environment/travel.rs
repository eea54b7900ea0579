//! Agents who leave an environment for another, with what they carry: how one gets from region to region of a city.

use nalgebra::Point2;
use vc_graph::clock::Span;
use vc_graph::space::{Load, PassError, RegionId};
use vc_graph::{Action, ChangeSet, Event, Label, NodeId, Pose, SceneGraph, Verb};
use vc_physics::{PhysicsWorld, Posture, Traveller};

use super::clock::DISTANCES;
use super::{Environment, PhysicalRefusal, make};

/// An agent that has left an environment, with its body and all that it carries.
#[derive(Clone)]
pub(crate) struct Departure {
    body: Traveller,
    load: Load,
}

/// Why an agent does not leave an environment or enter another one; then nothing has changed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TravelError {
    /// The agent is acting or under control.
    #[error("{0} is acting or under control: let it finish, or `interrupt` it")]
    Busy(Label),
    /// There is nowhere to stand beyond the threshold.
    #[error("there is no free floor within {within} m of the threshold of {region}")]
    NoFloor {
        /// The region that was to be entered.
        region: RegionId,
        /// How far from the threshold free floor was sought, metres.
        within: f32,
    },
    /// Nodes cannot go from one scene to the other.
    #[error(transparent)]
    Scene(#[from] PassError),
    /// Bodies do not allow it.
    #[error(transparent)]
    Bodies(#[from] PhysicalRefusal),
}

/// The distance between the middles of two who stand side by side, metres.
pub(crate) const APART: f32 = super::execute::APART;
/// How far from a threshold one looks for free floor to stand on, metres.
pub(crate) const BEYOND: f32 = 1.5;
/// How far from a threshold the floor is not free as its walls are near, metres: half a body and the depth of a wall. No
/// wall beside an opening is as thin as to end before that.
const IN_WALLS: f32 = 0.5;
/// The rings of half a metre in which one looks for a place to which one walks to make way, and the longest way to it, metres.
const RINGS: i32 = 8;
const FARTHEST: f32 = 6.0;
/// The opennesses at which a leaf that swings is looked at.
const SWING: [f32; 6] = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
/// The distance of the points of a straight way that are looked at, metres: a cell of the floor.
const FINE: f32 = 0.05;

/// The distance that somebody on a way keeps who has waited for a time, metres, here as within a region.
pub(crate) fn apart_after(waited: Span) -> f32 {
    let fits = DISTANCES.iter().rev().find(|(_, least)| waited >= *least);
    fits.map_or(APART, |(apart, _)| *apart).min(APART)
}

impl Departure {
    /// The agent and all that it carries.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.load.ids()
    }

    /// Somebody who has not been anywhere: the agent of a scene that has been made for it alone.
    pub(crate) fn of(scene: &SceneGraph, world: &mut PhysicsWorld, region: RegionId) -> Result<Self, TravelError> {
        let agent = scene.agents().first().copied().unwrap_or(NodeId(0));
        let load = Load::new(scene, agent, region)?;
        let body = world.depart(agent).map_err(|why| PhysicalRefusal::from(why).in_scene(scene))?;
        Ok(Self { body, load })
    }
}

impl Environment {
    /// Takes an agent that stands and does nothing out of the environment of a region; returns the changes of the graph,
    /// too.
    pub(crate) fn depart(&mut self, agent: NodeId, region: RegionId) -> Result<(Departure, ChangeSet), TravelError> {
        if self.current_action(agent).is_some() || self.controlled(agent).is_some() {
            return Err(TravelError::Busy(self.graph.label(agent)));
        }
        self.catch_up();
        let load = Load::new(&self.graph, agent, region)?;
        let body = self.world.depart(agent).map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        self.poses.remove(&agent);
        self.let_go(&load)?;
        // As the end of an action tells what has changed since the one before.
        Ok((Departure { body, load }, self.clock.take_journal()))
    }

    /// Lets an agent enter at a pose of its feet, in the frame of this region; the poses of what it carries are taken over by
    /// `shift`. Returns the free floor nearest to a point where it is going that fits, and the changes of the graph.
    pub(crate) fn arrive(
        &mut self,
        who: &Departure,
        (region, room): (RegionId, NodeId),
        shift: &Pose,
        feet: Pose,
        (towards, fits): (Point2<f32>, impl Fn(&Self, &Point2<f32>) -> bool),
    ) -> Result<(Point2<f32>, ChangeSet), TravelError> {
        self.catch_up();
        let before = self.graph.clone();
        self.clock.about_to_change(&self.graph);
        let changes = who.load.enter((&mut self.graph, region), shift, room)?;
        let asset = |id| self.graph.node(id).and_then(|node| node.spec().asset);
        let body = who.body.clone().with_assets(asset);
        let agent = body.agent();
        let arrived = self.world.arrive(&body, feet).map_err(PhysicalRefusal::from);
        let spot = arrived.map_err(TravelError::from).and_then(|()| {
            self.floor.update(&self.world);
            self.spot_near(agent, towards, |spot| fits(self, spot))
                .ok_or(TravelError::NoFloor { region, within: BEYOND })
        });
        let spot = match spot {
            Ok(spot) => spot,
            Err(why) => {
                // It has just come, so it can leave.
                let _ = self.world.depart(agent);
                self.graph = before;
                return Err(why);
            }
        };
        self.let_in(&who.load, &changes)?;
        Ok((spot, self.clock.take_journal()))
    }

    /// Whether a point is apart from all others who are here.
    fn is_apart(&self, agent: NodeId) -> impl Fn(&Point2<f32>) -> bool + use<> {
        let others: Vec<Point2<f32>> = self.people_but(agent).map(|(_, at)| at).collect();
        move |spot| others.iter().all(|other| (spot - other).norm() > APART)
    }

    /// The free floor nearest to a point, at most 1.5 m away, that is apart from others and fits.
    pub(crate) fn spot_near(
        &self,
        agent: NodeId,
        at: Point2<f32>,
        fits: impl Fn(&Point2<f32>) -> bool,
    ) -> Option<Point2<f32>> {
        let is_apart = self.is_apart(agent);
        let near = self.free_near_where(agent, &at, |spot| is_apart(spot) && fits(spot)).map(Point2::from);
        near.filter(|spot| (spot - at).norm() <= BEYOND)
    }

    /// A free place some metres away, apart from others, that fits, and to which one gets over the floor; the nearest, by
    /// rings of half a metre.
    pub(crate) fn spot_on_foot(
        &self,
        agent: NodeId,
        at: Point2<f32>,
        fits: impl Fn(&Point2<f32>) -> bool,
    ) -> Option<Point2<f32>> {
        let is_apart = self.is_apart(agent);
        let is_near = |spot| self.floor.route(at, spot).is_some_and(|way| way.length < FARTHEST);
        let mut spots = (1..=RINGS).flat_map(|ring| make::around(&at, ring));
        spots.find(|spot| self.stands_at(agent, spot) && is_apart(spot) && fits(spot) && is_near(*spot))
    }

    /// Sees where the floor is free now: things have moved since.
    pub(crate) fn see_floor(&mut self) {
        self.floor.update(&self.world);
    }

    /// The free floor nearest to a point, at most 1.5 m away, that fits, whoever stands there.
    pub(crate) fn free_floor_near(&self, at: Point2<f32>, fits: impl Fn(&Point2<f32>) -> bool) -> Option<Point2<f32>> {
        // Of nobody who is here.
        let near = self.free_near_where(NodeId(0), &at, fits).map(Point2::from);
        near.filter(|spot| (spot - at).norm() <= BEYOND)
    }

    /// Whether a straight way over the free floor of a room leads to a spot from a threshold, or from where somebody stands.
    pub(crate) fn leads_straight(&self, from: &Point2<f32>, spot: &Point2<f32>) -> bool {
        let way = spot - from;
        let begin = from + way.cap_magnitude(IN_WALLS);
        let steps = ((spot - begin).norm() / FINE).ceil().max(1.0);
        let points = (0..=steps as usize).map(|step| begin + (spot - begin) * (step as f32 / steps));
        points.into_iter().all(|point| self.floor.is_free(point))
            && self.start.room_at(begin) == self.start.room_at(*spot)
    }

    /// The others who are here, and where they are.
    pub(crate) fn people_but(&self, agent: NodeId) -> impl Iterator<Item = (NodeId, Point2<f32>)> + '_ {
        let others = self.agents().iter().copied().filter(move |other| *other != agent);
        others.filter_map(|other| Some((other, self.world.pose(other)?.translation.vector.xy().into())))
    }

    /// Whether an agent stands and does nothing, so that it can make way.
    pub(crate) fn is_free_to_move(&self, agent: NodeId) -> bool {
        self.is_idle(agent) && self.posture(agent) == Some(Posture::Standing)
    }

    /// Whether a leaf that swings would meet an agent where it stands.
    pub(crate) fn is_swept_by(&self, agent: NodeId, leaf: NodeId) -> bool {
        let there = self.world.pose(agent).and_then(|feet| self.world.standing(agent, &feet).ok());
        let is_free =
            |open: &[f32]| there.as_ref().is_none_or(|there| there.is_free_with_open(leaf, open).unwrap_or(true));
        !is_free(&SWING) && is_free(&[])
    }

    /// A room that one can enter, and a free place near its middle: one from where a way leads to one of some points, if there
    /// is such a room.
    pub(crate) fn room_to_enter(&self, points: &[Point2<f32>]) -> Option<(NodeId, Point2<f32>)> {
        let rooms = || self.graph.rooms().iter().filter_map(|room| make::middle(&self.graph, &self.floor, *room));
        let reaches = |(_, spot): &(NodeId, Point2<f32>)| points.iter().any(|point| self.has_way(*spot, *point));
        rooms().find(reaches).or_else(|| rooms().next())
    }

    /// Whether a way over the floor leads from a point to another one if nobody is in the way.
    pub(crate) fn has_way(&self, from: Point2<f32>, to: Point2<f32>) -> bool {
        self.floor.route(from, to).is_some()
    }

    /// Puts feet somewhere on the way between two regions.
    pub(crate) fn place_feet(&mut self, agent: NodeId, feet: Pose) {
        if self.world.teleport(agent, feet).is_ok() {
            self.clock.about_to_change(&self.graph);
            let passers: Vec<NodeId> = std::iter::once(agent).chain(self.graph.held(agent)).collect();
            self.excuse(&passers);
            self.clock.changed.extend(passers);
            (self.clock.stirred, self.clock.unseen) = (true, true);
        }
    }

    /// Puts feet where a way between two regions ends, and reads that, as at the end of a walk.
    pub(crate) fn stand_at(&mut self, agent: NodeId, feet: Pose) {
        self.place_feet(agent, feet);
        // If it cannot be told now, it is read when all rests.
        drop(self.read_moved());
    }

    /// Opens or shuts the leaf of a door that somebody passes, unless it would meet something on its way: things are pushed by
    /// it from now on, people are not, but for some who give way.
    pub(crate) fn swing_leaf(
        &mut self,
        leaf: NodeId,
        open: bool,
        give_way: &[NodeId],
    ) -> Result<ChangeSet, PhysicalRefusal> {
        let (to, graph) = (openness(open), self.graph.clone());
        let in_scene = |why: vc_physics::PhysicsError| PhysicalRefusal::from(why).in_scene(&graph);
        if self.world.parts(leaf).plan(to, give_way).map_err(in_scene)?.is_some() {
            self.world.set_openness(leaf, to, give_way).map_err(in_scene)?;
            return Ok(self.leaf_moved(leaf));
        }
        let parts = self.world.parts(leaf);
        let (now, all) = (parts.openness().unwrap_or_default(), parts.all());
        let met: Vec<NodeId> =
            parts.blockers(to).map_err(in_scene)?.into_iter().filter(|id| !give_way.contains(id)).collect();
        if !met.iter().any(|id| self.agents().contains(id)) {
            for (part, _) in all.iter().enumerate().filter(|(_, part)| part.has_motor) {
                self.world.drive(leaf, part, to).map_err(in_scene)?;
            }
            (self.clock.stirred, self.clock.unseen) = (true, true);
            self.excuse(&[&[leaf], &met[..]].concat());
        }
        let by = met.into_iter().map(|id| graph.label(id)).collect();
        Err(PhysicalRefusal::Stuck { thing: graph.label(leaf), open: 100.0 * now, by })
    }

    /// Opens or shuts the leaf of a lift.
    pub(crate) fn set_leaf(&mut self, leaf: NodeId, open: bool) -> Result<ChangeSet, PhysicalRefusal> {
        let moved = self.world.put_open(leaf, None, openness(open));
        moved.map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        Ok(self.leaf_moved(leaf))
    }

    /// Takes note of a leaf that has moved.
    fn leaf_moved(&mut self, leaf: NodeId) -> ChangeSet {
        self.excuse(&[leaf]);
        self.clock.about_to_change(&self.graph);
        // Whoever ends something in the next tick has not done it.
        let changes = self.write_open(&[leaf]);
        self.clock.changed.push(leaf);
        (self.clock.stirred, self.clock.unseen) = (true, true);
        changes
    }

    /// Opens or shuts the door that an action is about, or touches it only, which somebody on its other side does.
    pub(crate) fn move_leaf_from_outside(
        &mut self,
        agent: NodeId,
        action: Action,
    ) -> Result<ChangeSet, PhysicalRefusal> {
        let changes = match action.object {
            Some(leaf) if matches!(action.verb, Verb::Open | Verb::Close) => {
                self.swing_leaf(leaf, action.verb == Verb::Open, &[agent])?
            }
            _ => ChangeSet::default(),
        };
        self.past.push(Event { agent, action });
        Ok(changes)
    }

    /// Whether nobody does anything here and all rests.
    pub(crate) fn is_still(&self) -> bool {
        !self.is_busy() && self.clock.controls.all.is_empty() && !self.clock.stirred && self.world.awake() == 0
    }

    /// Whether all is as it was when the environment was made.
    pub(crate) fn is_as_made(&self) -> bool {
        self.graph.digest() == self.start.graph.digest() && are_open_alike(&self.world, &self.start.world)
    }

    /// Whether everything stands where it stands in another environment, to the bit.
    pub(crate) fn stands_as(&self, other: &Self) -> bool {
        let stands = |id: NodeId| self.world.pose(id) == other.world.pose(id);
        self.graph == other.graph
            && are_open_alike(&self.world, &other.world)
            && self.world.nodes().into_iter().all(stands)
    }
}

/// How far open a leaf is, 0 to 1.
fn openness(open: bool) -> f32 {
    if open { 1.0 } else { 0.0 }
}

/// Whether the parts of all things of a world are as far open as in another one.
fn are_open_alike(one: &PhysicsWorld, other: &PhysicsWorld) -> bool {
    let position = |world: &PhysicsWorld, id: NodeId| {
        world.parts(id).all().into_iter().map(|part| part.position).collect::<Vec<f32>>()
    };
    one.nodes().into_iter().all(|id| position(one, id) == position(other, id))
}
