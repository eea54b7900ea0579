//! Hands: they take, put down, let go, dress.

use vc_graph::{Edge, NodeId, Place, Pose, Relation, SceneGraph};
use vc_physics::{BodyRole, Hand, SpotOrder};

use nalgebra::Point3;

use super::planner::{Plan, Planner, Planning};
use super::spot::{AHEAD, FreeSpot};
use super::task::Task;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::{BodyMotion, Put};

impl Planner<'_> {
    /// The hand in which a graph has a thing.
    fn hand(&self, graph: &SceneGraph, id: NodeId) -> Option<Hand> {
        Hand::BOTH.into_iter().find(|h| graph.has(Edge::new(self.agent, h.relation(), id)))
    }

    pub(super) fn hand_with(&self, id: NodeId) -> Result<Hand, PhysicalRefusal> {
        self.hand(self.before, id).ok_or(PhysicalRefusal::NotModelled("it is in no hand"))
    }

    pub(super) fn hold(&self, id: NodeId) -> Planning {
        if self.hand(self.before, id).is_some() {
            return Ok(Plan::default());
        }
        let hand = self.hand(self.after, id).ok_or(PhysicalRefusal::NotModelled("the rule gives it into no hand"))?;
        if self.world.pose(id).is_some() {
            return Ok(BodyMotion::Take(hand, id, self.asked_side()).into());
        }
        let worn = self.before.related(id, Relation::WornBy).next() == Some(self.agent);
        if worn {
            Ok(BodyMotion::Undress(hand, id).into())
        } else {
            Err(PhysicalRefusal::NoBody(self.before.label(id)))
        }
    }

    /// Puts a held thing where there is room for it, nearest to the hands; after a step, where
    /// there is room nearest to them then.
    pub(super) fn put(&mut self, id: NodeId, place: Place) -> Planning {
        self.hand_with(id)?;
        if !self.action.aim.is_nothing() {
            return self.put_as_asked(id, place);
        }
        let FreeSpot { spot, first } = self.spot(id, place)?;
        Ok(Plan::of(first).then(Task::StepTo { id, place, spot }))
    }

    pub(super) fn step_to_put(&mut self, id: NodeId, place: Place, spot: Pose) -> Planning {
        if !self.stands() || self.puts_from(&self.feet(), id, &spot) {
            return Ok(Task::PutDown { id, place, spot }.into());
        }
        let (walk, spot) = self.step_to(id, place, spot)?;
        Ok(walk.then(Task::Arrive { id, place, spot }))
    }

    /// The things that were pushed aside for a thing may have moved on meanwhile.
    pub(super) fn arrive_to_put(&mut self, id: NodeId, place: Place, spot: Pose) -> Planning {
        if self.puts_from(&self.feet(), id, &spot) && self.world.overlaps(id, &spot)?.is_empty() {
            return Ok(Task::PutDown { id, place, spot }.into());
        }
        let FreeSpot { spot, first } = self.spot(id, place)?;
        Ok(Plan::of(first).then(Task::PutDown { id, place, spot }))
    }

    pub(super) fn lay_down(&self, id: NodeId, place: Place, pose: Pose) -> Planning {
        let hand = self.hand_with(id)?;
        if self.spot_as_begun(id, place)? == Some(pose) {
            return Ok(
                BodyMotion::Put(Put { hand, id, pose, balanced: true, tight: Some(place.at), with: None }).into()
            );
        }
        let with = Some(place.at).filter(|at| self.world.role(*at) == Some(BodyRole::Carried));
        let put = BodyMotion::Put(Put { hand, id, pose, balanced: false, tight: None, with });
        Ok(if with.is_some() { Plan::of([put]) } else { self.watched(put, id, place, pose) })
    }

    pub(super) fn let_go(&mut self, id: NodeId) -> Planning {
        let hand = self.hand_with(id)?;
        if !self.action.aim.is_nothing() {
            return self.let_go_as_asked(id);
        }
        let Some(ground) = self.before.place(self.agent).filter(|_| self.stands()) else {
            return Ok(BodyMotion::LetGo(hand).into());
        };
        self.floor.update(self.world);
        // Where it falls it may hang on a table's edge until something shakes it, or lie on a
        // book: on the floor beside these it stays.
        let place = Place { relation: Relation::On, at: ground.at };
        let room = self.before.room_of(self.agent);
        let start = self.start;
        let here = |spot: &Pose| start.room_at(spot.translation.vector.xy().into()) == room;
        for ahead in [AHEAD, 0.0, -AHEAD] {
            let order = SpotOrder::Near(self.feet() * Point3::new(ahead, 0.0, 0.0));
            let spot = self.spot_in_order(id, place, order)?;
            if let Some(pose) = spot.filter(|spot| here(spot) && self.puts_from(&self.feet(), id, spot)) {
                return Ok(BodyMotion::Put(Put { hand, id, pose, balanced: false, tight: None, with: None }).into());
            }
        }
        self.step_to_let_go(id, place, here)
    }

    /// Lets go of a thing on the rest of a floor, to which the agent steps; where there is no room, it falls.
    fn step_to_let_go(&mut self, id: NodeId, ground: Place, here: impl Fn(&Pose) -> bool) -> Planning {
        let falls: Planning = Ok(BodyMotion::LetGo(self.hand_with(id)?).into());
        let Some(spot) = self.free_spot(id, ground)?.filter(&here) else {
            let why = self.no_spot(id, ground)?;
            return if matches!(why, PhysicalRefusal::ShutsIn { .. }) { Err(why) } else { falls };
        };
        match self.step_to(id, ground, spot) {
            Ok((walk, spot)) if here(&spot) => Ok(walk.then(Task::LetGoAt { id, spot })),
            Ok((walk, _)) => Ok(Plan::of(walk.motions.into_iter().chain([BodyMotion::LetGo(self.hand_with(id)?)]))),
            Err(_) => falls,
        }
    }

    pub(super) fn let_go_at(&self, id: NodeId, pose: Pose) -> Planning {
        let hand = self.hand_with(id)?;
        Ok(match self.puts_from(&self.feet(), id, &pose) {
            true => BodyMotion::Put(Put { hand, id, pose, balanced: false, tight: None, with: None }),
            false => BodyMotion::LetGo(hand),
        }
        .into())
    }

    /// Loose things at a place and on them, and where they are.
    pub(super) fn loose_around(&self, place: Place) -> Vec<(NodeId, Pose)> {
        let loose = |id: &NodeId| self.world.role(*id) == Some(BodyRole::Loose);
        let there = self.before.carried_with(place.at).into_iter().filter(|id| *id != place.at && loose(id));
        there.filter_map(|id| Some((id, self.world.pose(id)?))).collect()
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
