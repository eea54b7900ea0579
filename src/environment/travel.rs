//! Agents who leave an environment for another, with what they carry: how one gets from region to region of a city.

use nalgebra::Point2;
use vc_graph::clock::Span;
use vc_graph::space::{Load, PassError, RegionId};
use vc_graph::{Action, ChangeSet, Event, Label, NodeId, Pose, SceneGraph, Verb};
use vc_physics::{PhysicsWorld, Posture, Traveller};

use super::clock::DISTANCES;
use super::{Ending, Environment, PhysicalRefusal, make, observe};

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
        let load = Load::new(&self.graph, agent, region)?;
        let body = self.world.depart(agent).map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        self.clock.about_to_change(&self.graph);
        let changes = load.leave(&mut self.graph)?;
        self.poses.remove(&agent);
        self.clock.note(changes.clone());
        self.read_anew(&load.ids().collect::<Vec<NodeId>>())?;
        Ok((Departure { body, load }, changes))
    }

    /// Lets an agent enter at a pose of its feet, in the frame of this region; the poses of what it carries are taken over by
    /// `shift`. Returns the free floor nearest to a point where it is going that fits, and the changes of the graph.
    pub(crate) fn arrive(
        &mut self,
        who: &Departure,
        (region, room): (RegionId, NodeId),
        shift: &Pose,
        feet: Pose,
        (towards, fits): (Point2<f32>, impl Fn(&Point2<f32>) -> bool),
    ) -> Result<(Point2<f32>, ChangeSet), TravelError> {
        let before = self.graph.clone();
        self.clock.about_to_change(&self.graph);
        let changes = who.load.enter((&mut self.graph, region), shift, room)?;
        let asset = |id| self.graph.node(id).and_then(|node| node.spec().asset);
        let body = who.body.clone().with_assets(asset);
        let agent = body.agent();
        let arrived = self.world.arrive(&body, feet).map_err(PhysicalRefusal::from);
        let spot = arrived.map_err(TravelError::from).and_then(|()| {
            self.floor.update(&self.world);
            self.spot_near(agent, towards, fits).ok_or(TravelError::NoFloor { region, within: BEYOND })
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
        self.clock.note(changes.clone());
        self.read_anew(&who.nodes().collect::<Vec<NodeId>>())?;
        Ok((spot, changes))
    }

    /// The free floor nearest to a point, at most 1.5 m away, that is apart from others and fits.
    pub(crate) fn spot_near(
        &self,
        agent: NodeId,
        at: Point2<f32>,
        fits: impl Fn(&Point2<f32>) -> bool,
    ) -> Option<Point2<f32>> {
        let others: Vec<Point2<f32>> = self.people_but(agent).map(|(_, at)| at).collect();
        let is_apart = |spot: &Point2<f32>| others.iter().all(|other| (spot - other).norm() > APART) && fits(spot);
        let near = self.free_near_where(agent, &at, is_apart).map(Point2::from);
        near.filter(|spot| (spot - at).norm() <= BEYOND)
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

    /// A room that one can enter, and a free place near its middle.
    pub(crate) fn room_to_enter(&self) -> Option<(NodeId, Point2<f32>)> {
        let mut rooms = self.graph.rooms().iter().filter_map(|room| make::middle(&self.graph, &self.floor, *room));
        rooms.next()
    }

    /// Lets time pass while an agent is doing something, at most a span; returns the actions that have ended.
    pub(crate) fn step_while_acting(&mut self, agent: NodeId, most: Span) -> Vec<Ending> {
        self.advance_while(self.tick() + most, |home| home.current_action(agent).is_some());
        self.take_endings()
    }

    /// Puts feet somewhere on the way between two regions.
    pub(crate) fn place_feet(&mut self, agent: NodeId, feet: Pose) {
        if self.world.teleport(agent, feet).is_ok() {
            self.clock.about_to_change(&self.graph);
            self.clock.changed.push(agent);
            self.clock.changed.extend(self.graph.held(agent));
            (self.clock.stirred, self.clock.unseen) = (true, true);
        }
    }

    /// Opens or shuts the leaf of a door that somebody passes.
    pub(crate) fn set_leaf(&mut self, leaf: NodeId, open: bool) -> Result<ChangeSet, PhysicalRefusal> {
        let moved = self.world.put_open(leaf, None, if open { 1.0 } else { 0.0 });
        moved.map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        self.excuse(&[leaf]);
        self.clock.about_to_change(&self.graph);
        // Whoever ends something in the next tick has not done it.
        let changes = self.write_open(&[leaf]);
        self.clock.changed.push(leaf);
        (self.clock.stirred, self.clock.unseen) = (true, true);
        Ok(changes)
    }

    /// Opens or shuts the door that an action is about, which somebody on its other side does.
    pub(crate) fn move_leaf_from_outside(
        &mut self,
        agent: NodeId,
        action: Action,
    ) -> Result<ChangeSet, PhysicalRefusal> {
        let changes = match action.object {
            Some(leaf) => self.set_leaf(leaf, action.verb == Verb::Open)?,
            None => ChangeSet::default(),
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
        let position = |world: &PhysicsWorld, id: NodeId| {
            world.parts(id).all().into_iter().map(|part| part.position).collect::<Vec<f32>>()
        };
        let start = &self.start;
        self.graph.digest() == start.graph.digest()
            && self.world.nodes().into_iter().all(|id| position(&self.world, id) == position(&start.world, id))
    }

    /// Reads relations anew, since nodes have come or gone.
    fn read_anew(&mut self, nodes: &[NodeId]) -> Result<(), PhysicalRefusal> {
        let here: Vec<NodeId> = nodes.iter().copied().filter(|id| self.graph.node(*id).is_some()).collect();
        let (_, poses) = observe::write_poses(&mut self.graph, &self.world)?;
        self.clock.note(poses);
        self.relations.set_evidence(&self.graph, observe::evidence(&self.world))?;
        self.relations.rebuild(&self.graph)?;
        let (graph, world) = (&mut self.graph, &mut self.world);
        let (_, seen) = observe::look_again(graph, &self.start, world, &mut self.relations, &here)?;
        self.clock.note(seen);
        self.clock.scene_changed();
        self.clock.stirred = true;
        self.look_anew();
        Ok(())
    }
}
