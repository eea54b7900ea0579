//! Where there is room for a thing, and how room is made for it.

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Node, NodeId, Place, Pose, Property, Relation, SceneGraph};
use vc_physics::{BodyRole, Packing, PhysicsWorld, SpotOrder, SpotSearch};

use super::planner::Planner;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::BodyMotion;

/// How far ahead of the body a hand puts things down, metres.
pub(super) const AHEAD: f32 = 0.45;
/// Height at which things are out of everybody's way, metres.
pub(super) const AWAY: f32 = -100.0;

/// A spot for a thing, and the motions that make room for it there.
pub(in crate::environment) struct FreeSpot {
    pub(in crate::environment) spot: Pose,
    pub(in crate::environment) first: Vec<BodyMotion>,
}

impl Planner<'_> {
    /// A free spot for a thing on or in another. If there is none, or if the thing did not stay there by itself at the
    /// start, it goes back to where it was, however tight. Else cloth is folded up, what is
    /// there is pushed together, and into containers things are put on the others at last.
    pub(in crate::environment) fn spot(&mut self, id: NodeId, place: Place) -> Result<FreeSpot, PhysicalRefusal> {
        self.floor.update(self.world);
        let held = self.start.world.role(id) == Some(BodyRole::Hung);
        let mut spot = if held { self.spot_as_begun(id, place)? } else { None };
        if spot.is_none() {
            spot = self.free_spot(id, place)?;
        }
        if spot.is_none() {
            spot = self.spot_as_begun(id, place)?;
        }
        if let Some(spot) = spot {
            return Ok(FreeSpot { spot, first: Vec::new() });
        }
        match self.folded(id)? {
            Some((world, fold)) => {
                let mut room = self.in_world(&world).spot_for_folded(id, place)?;
                room.first.insert(0, fold);
                Ok(room)
            }
            None => self.made_spot(id, place),
        }
    }

    fn spot_for_folded(&mut self, id: NodeId, place: Place) -> Result<FreeSpot, PhysicalRefusal> {
        match self.free_spot(id, place)? {
            Some(spot) => Ok(FreeSpot { spot, first: Vec::new() }),
            None => self.made_spot(id, place),
        }
    }

    /// A spot where there is none that is free: others are pushed together, or the thing is put on them.
    fn made_spot(&mut self, id: NodeId, place: Place) -> Result<FreeSpot, PhysicalRefusal> {
        if let Some(room) = self.make_room(id, place)? {
            return Ok(room);
        }
        let mut spot = None;
        if place.relation == Relation::Inside {
            let admits = |spot: &Pose| self.may_be_put(id, place, spot);
            spot = SpotSearch::new(id, place.at, true)
                .order(self.near_hands())
                .packing(Packing::Heaped)
                .find_where(self.world, admits)?;
        }
        spot.map_or_else(|| Err(self.no_spot(id, place)?), |spot| Ok(FreeSpot { spot, first: Vec::new() }))
    }

    /// The error for a thing without a spot at a place.
    pub(super) fn no_spot(&self, id: NodeId, place: Place) -> Result<PhysicalRefusal, PhysicalRefusal> {
        let (thing, at) = (self.before.label(id), self.before.label(place.at));
        let (inside, order) = (place.relation == Relation::Inside, self.near_hands());
        let mut anywhere = SpotSearch::new(id, place.at, inside).order(order).find(self.world)?;
        if inside && anywhere.is_none() {
            anywhere = SpotSearch::new(id, place.at, true).order(order).packing(Packing::Heaped).find(self.world)?;
        }
        match anywhere {
            Some(_) if inside => return Ok(PhysicalRefusal::KeepsOpen { thing, at }),
            Some(_) => return Ok(PhysicalRefusal::ShutsIn { thing, at }),
            None => {}
        }
        let by = self.before.relating(place.relation, place.at).map(|by| self.before.label(by)).collect();
        Ok(PhysicalRefusal::NoSpot { thing, where_: if inside { "in" } else { "on" }, at, by })
    }

    /// Where a thing was at its place at the start, if nothing has come there since.
    pub(super) fn spot_as_begun(&self, id: NodeId, place: Place) -> Result<Option<Pose>, PhysicalRefusal> {
        let was_there = self.start.graph.places(id).any(|p| p == place);
        Ok(if was_there { self.world.body(id)?.former_spot(&self.start.world, place.at)? } else { None })
    }

    pub(super) fn near_hands(&self) -> SpotOrder {
        SpotOrder::Near(self.feet() * Point3::new(AHEAD, 0.0, 1.0))
    }

    pub(super) fn free_spot(&self, id: NodeId, place: Place) -> Result<Option<Pose>, PhysicalRefusal> {
        self.spot_in_order(id, place, self.near_hands())
    }

    /// The first free spot at a place where the thing may be put.
    pub(super) fn spot_in_order(
        &self,
        id: NodeId,
        place: Place,
        order: SpotOrder,
    ) -> Result<Option<Pose>, PhysicalRefusal> {
        self.spot_where(id, place, order, |_| true)
    }

    /// The first free spot at a place where the thing may be put, and that a condition admits.
    pub(super) fn spot_where(
        &self,
        id: NodeId,
        place: Place,
        order: SpotOrder,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicalRefusal> {
        let inside = place.relation == Relation::Inside;
        let admits = |spot: &Pose| admits(spot) && self.may_be_put(id, place, spot);
        Ok(SpotSearch::new(id, place.at, inside).order(order).find_where(self.world, admits)?)
    }

    /// Whether a thing may be put to a spot at a place: on others it shuts nobody in, and what it is in shuts again.
    pub(super) fn may_be_put(&self, id: NodeId, place: Place, spot: &Pose) -> bool {
        match place.relation {
            Relation::Inside => self.world.parts(place.at).are_kept_open_by(id, spot).is_ok_and(|keeps| !keeps),
            _ => self.shuts_nobody_in(id, spot),
        }
    }

    /// Whether all agents, with a thing at a pose, still reach the floor that they reach now.
    fn shuts_nobody_in(&self, id: NodeId, pose: &Pose) -> bool {
        let stood = |agent| {
            self.world.agent(agent).ok().and_then(|agent| agent.stood_before()).or_else(|| self.world.pose(agent))
        };
        let feet = self.world.agents().filter_map(stood).map(|feet| feet.translation.vector.xy().into());
        let feet: Vec<Point2<f32>> = feet.collect();
        self.floor.stays_open(self.world, id, pose, &feet).unwrap_or(true)
    }

    /// Pushes together what is on or in a thing, away from the hands or to a side, the largest first, until
    /// there is room for another.
    pub(super) fn make_room(&mut self, id: NodeId, place: Place) -> Result<Option<FreeSpot>, PhysicalRefusal> {
        let things = self.movable_at(place);
        let Some(around) = self.world.aabb(place.at).filter(|_| !things.is_empty()) else { return Ok(None) };
        let (middle, hands) = (around.centre(), self.feet() * Point3::new(AHEAD, 0.0, 1.0));
        let way = middle - hands;
        let aside = Vector3::new(-way.y, way.x, 0.0);
        let mut world = self.world.clone();
        for (to, close) in [(way, false), (way, true), (aside, true), (-aside, true)] {
            if let Some(moved) = self.push_together(&mut world, &things, place, (middle + to, close))?
                && let Some(spot) = self.in_world(&world).free_spot(id, place)?
            {
                return Ok(Some(FreeSpot { spot, first: vec![BodyMotion::Push(moved)] }));
            }
            world.clone_from(self.world);
        }
        Ok(None)
    }

    /// Puts some things of a place towards a point, one after the other, loosely or as close as they stand; their
    /// poses, if there is room for all.
    fn push_together(
        &mut self,
        world: &mut PhysicsWorld,
        things: &[NodeId],
        place: Place,
        (to, close): (Point3<f32>, bool),
    ) -> Result<Option<Vec<(NodeId, Pose)>>, PhysicalRefusal> {
        for (index, thing) in things.iter().enumerate() {
            // Out of the way of those that come before it.
            world.place(*thing, Pose::translation(10.0 * index as f32, 0.0, AWAY))?;
        }
        let (inside, order, mut moved) = (place.relation == Relation::Inside, SpotOrder::Near(to), Vec::new());
        for &thing in things {
            let planner = self.in_world(world);
            let admits = |spot: &Pose| !inside || planner.may_be_put(thing, place, spot);
            let spot = if close {
                SpotSearch::new(thing, place.at, inside)
                    .order(order)
                    .packing(Packing::Close)
                    .find_where(planner.world, admits)?
            } else {
                SpotSearch::new(thing, place.at, inside).order(order).find_where(planner.world, admits)?
            };
            let Some(spot) = spot else { return Ok(None) };
            world.place(thing, spot)?;
            moved.push((thing, spot));
        }
        Ok(Some(moved))
    }

    /// Things that can be pushed about, the largest first: those that are loose, or held still where they lie, of
    /// which the graph says that they are on or in a thing and nothing else, with nothing on them.
    fn movable_at(&self, place: Place) -> Vec<NodeId> {
        let alone = |id: &NodeId| self.before.places(*id).eq([place]) && self.before.resting_at(*id).next().is_none();
        let carried = |id: NodeId| self.before.node(id).is_some_and(|n| n.affords(Property::Graspable));
        let movable = |id: &NodeId| match self.world.role(*id) {
            Some(BodyRole::Loose) => true,
            Some(BodyRole::Hung) => carried(*id),
            _ => false,
        };
        let size = |id: &NodeId| self.world.aabb(*id).map_or(0.0, |b| (b.max - b.min).xy().norm());
        let there = self.before.relating(place.relation, place.at);
        let mut things: Vec<NodeId> = there.filter(|id| movable(id) && alone(id)).collect();
        things.sort_by(|a, b| size(b).total_cmp(&size(a)).then(a.cmp(b)));
        things
    }

    /// The world with a thing of cloth folded to a flat bundle, and that motion; `None` if it is no larger as it is.
    pub(super) fn folded(&self, id: NodeId) -> Result<Option<(PhysicsWorld, BodyMotion)>, PhysicalRefusal> {
        let Some(node) = self.before.node(id).filter(|n| is_cloth(n)) else { return Ok(None) };
        let Some(by) = self.world.body(id)?.folded_scale() else { return Ok(None) };
        let scale = node.spec().scale.component_mul(&by);
        let (mut world, graph) = (self.world.clone(), scaled(self.before, id, scale)?);
        world.reshape(&graph, id, &self.start.shapes)?;
        Ok(Some((world, BodyMotion::Fold(id, scale))))
    }
}

/// A graph in which a thing has another scale.
pub(super) fn scaled(graph: &SceneGraph, id: NodeId, scale: Vector3<f32>) -> Result<SceneGraph, PhysicalRefusal> {
    let mut graph = graph.clone();
    let mut edit = graph.edit();
    edit.set_scale(id, scale)?;
    edit.commit();
    Ok(graph)
}

/// Whether a thing is of cloth and nothing else: it is folded and washed, and neither holds nor
/// carries anything.
fn is_cloth(node: &Node) -> bool {
    let has = |all: &[Property]| all.iter().filter(|p| node.affords(**p)).count();
    has(&[Property::Foldable, Property::Graspable, Property::Washable]) == 3
        && has(&[
            Property::Breakable,
            Property::Container,
            Property::Lieable,
            Property::Openable,
            Property::Sittable,
            Property::Surface,
        ]) == 0
}
