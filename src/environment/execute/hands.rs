//! What hands do: take, put down, let go, dress.

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Edge, EditError, Node, NodeId, Place, Pose, Property, Relation, SceneGraph};
use vc_physics::{BodyRole, Hand, SpotOrder};

use super::{Done, Execution, UPRIGHT};
use crate::environment::PhysicalRefusal;
use crate::environment::course::{BodyMotion, Put};
use crate::environment::settle::come_to_rest;

/// How far ahead of the body a hand puts things down, metres.
const AHEAD: f32 = 0.45;
/// How far others may be pushed aside by what is put down beside them, metres.
const ASIDE: f32 = 0.15;
/// How far a thing may roll from where it was put on another, metres.
const ROLLED: f32 = 0.04;
/// Height at which things are out of everybody's way, metres.
const AWAY: f32 = -100.0;

impl Execution<'_> {
    /// The hand in which a graph has a thing.
    pub(super) fn hand(&self, graph: &SceneGraph, id: NodeId) -> Option<Hand> {
        Hand::BOTH.into_iter().find(|h| graph.has(Edge::new(self.agent, h.relation(), id)))
    }

    pub(super) fn hold(&mut self, id: NodeId) -> Done {
        if self.hand(self.before, id).is_some() {
            return Ok(());
        }
        let hand = self.hand(self.after, id).ok_or(PhysicalRefusal::NotModelled("the rule gives it into no hand"))?;
        if self.world.pose(id).is_none() {
            return self.undress(hand, id);
        }
        self.world.grab_with_load(self.agent, hand, id, &load_of(self.before, id))?;
        self.course.push(BodyMotion::Take(hand, id));
        Ok(())
    }

    pub(super) fn undress(&mut self, hand: Hand, id: NodeId) -> Done {
        let worn = self.before.related(id, Relation::WornBy).next() == Some(self.agent);
        if !worn {
            return Err(PhysicalRefusal::NoBody(self.before.label(id)));
        }
        self.world.insert(self.before, id, &self.start.shapes)?;
        self.world.place(id, self.feet() * Pose::translation(0.3, 0.0, 1.0))?;
        self.world.grab(self.agent, hand, id)?;
        self.course.push(BodyMotion::Undress(hand, id));
        Ok(())
    }

    pub(super) fn dress(&mut self, id: NodeId) -> Done {
        self.world.remove(id)?;
        self.course.push(BodyMotion::Dress(id));
        Ok(())
    }

    /// Puts a held thing where there is room for it, nearest to the hands; after a step, where
    /// there is room nearest to them then.
    pub(super) fn put(&mut self, id: NodeId, place: Place) -> Done {
        let hand = self.hand(self.before, id).ok_or(PhysicalRefusal::NotModelled("it is in no hand"))?;
        let mut spot = self.spot(id, place)?;
        if self.stands() && !self.puts_from(&self.feet(), id, &spot) {
            spot = self.step_to(id, place, spot)?;
            // The things that were pushed aside for it may have moved on meanwhile.
            if !self.puts_from(&self.feet(), id, &spot) || !self.world.overlaps(id, &spot)?.is_empty() {
                spot = self.spot(id, place)?;
            }
        }
        self.turn_to(&spot);
        if self.spot_as_begun(id, place)? == Some(spot) {
            self.world.put_back(&self.start.world, (self.agent, hand), spot, place.at)?;
            self.course.push(BodyMotion::Put(Put { hand, id, pose: spot, balanced: true, tight: Some(place.at) }));
            return Ok(());
        }
        let around = self.loose_around(place);
        self.world.put(self.agent, hand, spot)?;
        self.course.push(BodyMotion::Put(Put { hand, id, pose: spot, balanced: false, tight: None }));
        self.steady(id, place, spot, &around)
    }

    /// Sees to it that what was put down stays there, and what is beside it: if they come to rest
    /// elsewhere, it is put in the middle instead, or in a container where there is room once the others are pushed
    /// together; and if that does not help, it is balanced where it was put. In a container the others are pushed
    /// together for what has tipped over, too.
    fn steady(&mut self, id: NodeId, place: Place, spot: Pose, around: &[(NodeId, Pose)]) -> Done {
        let inside = place.relation == Relation::Inside;
        if self.comes_to_rest(id, place, spot, around) {
            if inside && self.has_tipped(id, &spot) {
                self.rests_beside_others(id, place)?;
            }
            return Ok(());
        }
        self.clear_away(id, around)?;
        if let Some(middle) = self.spot_in_order(id, place, SpotOrder::Middle)? {
            self.world.place(id, middle)?;
            self.revise(middle, false);
            if self.comes_to_rest(id, place, middle, around) {
                return Ok(());
            }
            self.clear_away(id, around)?;
        }
        if inside && self.rests_beside_others(id, place)? {
            return Ok(());
        }
        self.world.place(id, spot)?;
        self.world.rest();
        self.revise(spot, true);
        Ok(())
    }

    /// Whether a thing does not stand or lie as it was put.
    fn has_tipped(&self, id: NodeId, spot: &Pose) -> bool {
        let up = |pose: &Pose| pose.rotation * Vector3::z();
        self.world.pose(id).is_some_and(|now| up(&now).dot(&up(spot)) < UPRIGHT)
    }

    /// Puts down a thing where there is room once the others are pushed together; if it does not come to rest there
    /// either, all is as it was.
    fn rests_beside_others(&mut self, id: NodeId, place: Place) -> Result<bool, PhysicalRefusal> {
        let (before, beats) = (self.world.clone(), self.course.beats.clone());
        self.world.place(id, Pose::translation(0.0, 0.0, AWAY))?;
        let Some(room) = self.make_room(id, place)? else {
            self.world.clone_from(&before);
            return Ok(false);
        };
        // They are pushed before it is put down.
        let last = self.course.beats.len() - 1;
        self.course.beats.swap(last.saturating_sub(1), last);
        let around = self.loose_around(place);
        self.world.place(id, room)?;
        self.revise(room, false);
        let rests = self.comes_to_rest(id, place, room, &around);
        if !rests {
            self.world.clone_from(&before);
            self.course.beats = beats;
        }
        Ok(rests)
    }

    /// What was put down last has come elsewhere.
    fn revise(&mut self, at: Pose, held_still: bool) {
        if let Some(BodyMotion::Put(put)) = self.course.beats.last_mut() {
            (put.pose, put.balanced) = (at, held_still);
        }
    }

    /// Whether a thing that was put to a spot stays at its place, on top of things about at the
    /// spot, and those around it about where they were.
    fn comes_to_rest(&mut self, id: NodeId, place: Place, spot: Pose, around: &[(NodeId, Pose)]) -> bool {
        come_to_rest(self.world);
        let far = |id: NodeId, was: &Pose| {
            let now = self.world.pose(id);
            now.map_or(f32::INFINITY, |now| (now.translation.vector - was.translation.vector).norm())
        };
        let inside = place.relation == Relation::Inside;
        let rolled = !inside && far(id, &spot) > ROLLED;
        let across = || !inside && self.world.supports(id).contains(&place.at);
        !rolled
            && (self.world.is_at(id, place.at, inside) || across())
            && around.iter().all(|(id, was)| far(*id, was) < ASIDE)
            && !(inside && self.is_in_the_way(id, place.at))
    }

    /// Whether a thing as it lies keeps another from being shut.
    fn is_in_the_way(&self, id: NodeId, at: NodeId) -> bool {
        let pose = self.world.pose(id);
        pose.is_some_and(|pose| self.world.keeps_open(id, at, &pose).unwrap_or(false))
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

    /// Loose things at a place and on them, and where they are.
    fn loose_around(&self, place: Place) -> Vec<(NodeId, Pose)> {
        let loose = |id: &NodeId| self.world.role(*id) == Some(BodyRole::Loose);
        let there = self.before.carried_with(place.at).into_iter().filter(|id| *id != place.at && loose(id));
        there.filter_map(|id| Some((id, self.world.pose(id)?))).collect()
    }

    /// A free spot for a thing on or in another. If there is none, or if the thing did not stay there by itself at the
    /// start, it goes back to where it was, however tight. Else cloth is folded up, what is
    /// there is pushed together, and into containers things are put on the others at last.
    pub(in crate::environment) fn spot(&mut self, id: NodeId, place: Place) -> Result<Pose, PhysicalRefusal> {
        self.floor.update(self.world);
        let held = self.start.world.role(id) == Some(BodyRole::Hung);
        let mut spot = if held { self.spot_as_begun(id, place)? } else { None };
        if spot.is_none() {
            spot = self.free_spot(id, place)?;
        }
        if spot.is_none() {
            spot = self.spot_as_begun(id, place)?;
        }
        if spot.is_none() && self.fold_up(id)? {
            spot = self.free_spot(id, place)?;
        }
        if spot.is_none() {
            spot = self.make_room(id, place)?;
        }
        if spot.is_none() && place.relation == Relation::Inside {
            let admits = |spot: &Pose| self.may_be_put(id, place, spot);
            spot = self.world.heaped_spot_where(id, place.at, self.near_hands(), admits)?;
        }
        spot.map_or_else(|| Err(self.no_spot(id, place)?), Ok)
    }

    /// The error for a thing without a spot at a place.
    fn no_spot(&self, id: NodeId, place: Place) -> Result<PhysicalRefusal, PhysicalRefusal> {
        let (thing, at) = (self.before.label(id), self.before.label(place.at));
        let (inside, order) = (place.relation == Relation::Inside, self.near_hands());
        let mut anywhere = self.world.free_spot_at(id, place.at, inside, order)?;
        if inside && anywhere.is_none() {
            anywhere = self.world.heaped_spot_where(id, place.at, order, |_| true)?;
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
    fn spot_as_begun(&self, id: NodeId, place: Place) -> Result<Option<Pose>, PhysicalRefusal> {
        let was_there = self.start.graph.places(id).any(|p| p == place);
        Ok(if was_there { self.world.former_spot(&self.start.world, id, place.at)? } else { None })
    }

    pub(super) fn near_hands(&self) -> SpotOrder {
        SpotOrder::Near(self.feet() * Point3::new(AHEAD, 0.0, 1.0))
    }

    fn free_spot(&self, id: NodeId, place: Place) -> Result<Option<Pose>, PhysicalRefusal> {
        self.spot_in_order(id, place, self.near_hands())
    }

    /// The first free spot at a place where the thing may be put.
    fn spot_in_order(&self, id: NodeId, place: Place, order: SpotOrder) -> Result<Option<Pose>, PhysicalRefusal> {
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
        Ok(self.world.free_spot_where(id, place.at, inside, order, admits)?)
    }

    /// Whether a thing may be put to a spot at a place: on others it shuts nobody in, and what it is in shuts again.
    fn may_be_put(&self, id: NodeId, place: Place, spot: &Pose) -> bool {
        match place.relation {
            Relation::Inside => self.world.keeps_open(id, place.at, spot).is_ok_and(|keeps| !keeps),
            _ => self.shuts_nobody_in(id, spot),
        }
    }

    /// Whether all agents, with a thing at a pose, still reach the floor that they reach now.
    fn shuts_nobody_in(&self, id: NodeId, pose: &Pose) -> bool {
        let stood = |agent| self.world.stood_before(agent).or_else(|| self.world.pose(agent));
        let feet = self.world.agents().filter_map(stood).map(|feet| feet.translation.vector.xy().into());
        let feet: Vec<Point2<f32>> = feet.collect();
        self.floor.stays_open(self.world, id, pose, &feet).unwrap_or(true)
    }

    /// Pushes together what is on or in a thing, away from the hands or to a side, the largest first, until
    /// there is room for another; if there is none then, all stays where it was.
    fn make_room(&mut self, id: NodeId, place: Place) -> Result<Option<Pose>, PhysicalRefusal> {
        let things = self.movable_at(place);
        let Some(around) = self.world.aabb(place.at).filter(|_| !things.is_empty()) else { return Ok(None) };
        let (middle, hands) = (around.centre(), self.feet() * Point3::new(AHEAD, 0.0, 1.0));
        let way = middle - hands;
        let aside = Vector3::new(-way.y, way.x, 0.0);
        let before = self.world.clone();
        for (to, close) in [(way, false), (way, true), (aside, true), (-aside, true)] {
            if let Some(moved) = self.push_together(&things, place, middle + to, close)?
                && let Some(spot) = self.free_spot(id, place)?
            {
                moved.iter().try_for_each(|(thing, _)| self.world.wake(*thing))?;
                self.course.push(BodyMotion::Push(moved));
                return Ok(Some(spot));
            }
            self.world.clone_from(&before);
        }
        Ok(None)
    }

    /// Puts some things of a place towards a point, one after the other, loosely or as close as they stand; their
    /// poses, if there is room for all.
    fn push_together(
        &mut self,
        things: &[NodeId],
        place: Place,
        to: Point3<f32>,
        close: bool,
    ) -> Result<Option<Vec<(NodeId, Pose)>>, PhysicalRefusal> {
        for (index, thing) in things.iter().enumerate() {
            // Out of the way of those that come before it.
            self.world.place(*thing, Pose::translation(10.0 * index as f32, 0.0, AWAY))?;
        }
        let (inside, order, mut moved) = (place.relation == Relation::Inside, SpotOrder::Near(to), Vec::new());
        for &thing in things {
            let admits = |spot: &Pose| !inside || self.may_be_put(thing, place, spot);
            let spot = if close {
                self.world.packed_spot_where(thing, place.at, inside, order, admits)?
            } else {
                self.world.free_spot_where(thing, place.at, inside, order, admits)?
            };
            let Some(spot) = spot else { return Ok(None) };
            self.world.place(thing, spot)?;
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

    /// Makes a flat bundle of cloth; whether it was any larger.
    fn fold_up(&mut self, id: NodeId) -> Result<bool, PhysicalRefusal> {
        let Some(node) = self.before.node(id).filter(|n| is_cloth(n)) else { return Ok(false) };
        let Some(by) = self.world.folded_size(id)? else { return Ok(false) };
        let scale = node.spec().scale.component_mul(&by);
        let graph = scaled(self.before, id, scale).map_err(|e| PhysicalRefusal::Unreadable(e.to_string()))?;
        self.world.reshape(&graph, id, &self.start.shapes)?;
        self.folded.push((id, scale));
        self.course.push(BodyMotion::Fold(id, scale));
        Ok(true)
    }

    pub(super) fn let_go(&mut self, id: NodeId) -> Done {
        let hand = self.hand(self.before, id).ok_or(PhysicalRefusal::NotModelled("it is in no hand"))?;
        // Where it falls it may hang on a table's edge until something shakes it, or lie on a
        // book: on the floor beside these it stays.
        if let Some(spot) = self.floor_spot(id)?
            && self.world.put(self.agent, hand, spot).is_ok()
        {
            self.course.push(BodyMotion::Put(Put { hand, id, pose: spot, balanced: false, tight: None }));
            return Ok(());
        }
        self.world.drop(self.agent, hand)?;
        self.course.push(BodyMotion::LetGo(hand));
        Ok(())
    }

    /// A free spot for a thing on the floor before the agent's feet, or beside them or behind where
    /// only that is in the room and in reach; where it would shut somebody in, after a step, one on the rest of the
    /// floor. None where it can only fall.
    fn floor_spot(&mut self, id: NodeId) -> Result<Option<Pose>, PhysicalRefusal> {
        let Some(ground) = self.before.place(self.agent).filter(|_| self.stands()) else { return Ok(None) };
        self.floor.update(self.world);
        let place = Place { relation: Relation::On, at: ground.at };
        let room = self.before.room_of(self.agent);
        let here = |spot: &Pose| self.start.room_at(spot.translation.vector.xy().into()) == room;
        for ahead in [AHEAD, 0.0, -AHEAD] {
            let order = SpotOrder::Near(self.feet() * Point3::new(ahead, 0.0, 0.0));
            let spot = self.spot_in_order(id, place, order)?;
            if let Some(spot) = spot.filter(|spot| here(spot) && self.puts_from(&self.feet(), id, spot)) {
                return Ok(Some(spot));
            }
        }
        self.floor_spot_after_a_step(id, place, here)
    }

    /// A free spot on the rest of a floor, to which the agent steps.
    fn floor_spot_after_a_step(
        &mut self,
        id: NodeId,
        ground: Place,
        here: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicalRefusal> {
        if let Some(spot) = self.free_spot(id, ground)?.filter(&here) {
            let reached = self.step_to(id, ground, spot).ok().filter(here);
            return Ok(reached.filter(|spot| self.puts_from(&self.feet(), id, spot)));
        }
        match self.no_spot(id, ground)? {
            shut @ PhysicalRefusal::ShutsIn { .. } => Err(shut),
            _ => Ok(None),
        }
    }
}

/// Whether a load comes along when the thing it rests on is taken: it does if it rests on nothing else, or if it is
/// inside the taken thing and otherwise only on what that thing stands on. A load that touches the taken thing only
/// from above, or that the table carries as well, stays behind.
pub(in crate::environment) fn comes_along(graph: &SceneGraph, load: NodeId, taken: NodeId) -> bool {
    let on_it = |p: &Place| p.at == taken || graph.rests_at(p.at, taken);
    let inside = graph.places(load).any(|p| p.relation == Relation::Inside && on_it(&p));
    let below = |p: &Place| inside && graph.rests_at(taken, p.at);
    graph.rests_at(load, taken) && graph.places(load).all(|p| on_it(&p) || below(&p))
}

/// All that comes along when a thing is taken.
pub(in crate::environment) fn load_of(graph: &SceneGraph, taken: NodeId) -> Vec<NodeId> {
    graph.carried_with(taken).into_iter().filter(|id| *id != taken && comes_along(graph, *id, taken)).collect()
}

/// A graph in which a thing has another scale.
fn scaled(graph: &SceneGraph, id: NodeId, scale: Vector3<f32>) -> Result<SceneGraph, EditError> {
    let mut graph = graph.clone();
    let mut edit = graph.edit();
    edit.set_scale(id, scale)?;
    edit.commit();
    Ok(graph)
}

/// Whether a thing is of cloth and nothing else: it is folded and washed, and neither holds nor
/// carries anything.
fn is_cloth(node: &Node) -> bool {
    use Property::{Breakable, Container, Foldable, Graspable, Lieable, Openable, Sittable, Surface, Washable};
    let has = |all: &[Property]| all.iter().filter(|p| node.affords(**p)).count();
    has(&[Foldable, Graspable, Washable]) == 3
        && has(&[Breakable, Container, Lieable, Openable, Sittable, Surface]) == 0
}
