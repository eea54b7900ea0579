//! Checking an agent's preconditions in a scene.

use std::marker::PhantomData;

use crate::class::{SlotKind, Trait};
use crate::node::{Node, NodeKind};
use crate::rule::check::{Reason, origin, vehicle_of};
use crate::rule::condition::Condition;
use crate::rule::fit::misfit;
use crate::rule::refusal::Refusal;
use crate::vocabulary::Word;
use crate::{Edge, NodeId, Place, Property, Relation, SceneGraph, State};

/// A graph in which an agent's preconditions are checked; `W` determines whether reasons are given.
pub(super) struct Judge<'a, W> {
    pub(super) graph: &'a SceneGraph,
    pub(super) agent: NodeId,
    pub(super) body: &'a Node,
    pub(super) reason: PhantomData<W>,
}

impl<'a, W: Reason> Judge<'a, W> {
    pub(super) fn judge(&self, need: &Condition) -> Result<(), W> {
        use Condition as C;
        let (graph, agent) = (self.graph, self.agent);
        match *need {
            C::Affords(t, p) => self.affords(t, &[p]),
            C::In(t, s) => self.require(self.node(t)?.is(s), || Refusal::NotInState(graph.label(t), s)),
            C::NotIn(t, s) => self.require(!self.node(t)?.is(s), || Refusal::InState(graph.label(t), s)),
            C::Near(t) => self.near(t),
            C::Reachable(t) => self.require(graph.room_of(t).is_some(), || Refusal::NoWay(graph.label(t))),
            C::Tangible(t) => {
                let node = self.node(t)?;
                self.require(node.kind() != NodeKind::Room, || Refusal::IsRoom(node.label()))
            }
            C::Accessible(t) => self.accessible(t),
            C::Graspable(t) => self.graspable(t),
            C::NotElsewhereHeld(t) => self.not_elsewhere_held(t),
            C::FreeHand => self.require(graph.free_hand(agent).is_some(), || Refusal::NoFreeHand(self.body.label())),
            C::FreeHandOrHolding(t) => self
                .require(graph.free_hand(agent).is_some() || self.holds(t), || Refusal::NoFreeHand(self.body.label())),
            C::Holding(t) => self.require(self.holds(t), || Refusal::NotHeld(graph.label(t))),
            C::HoldingSomething => {
                self.require(graph.held(agent).next().is_some(), || Refusal::EmptyHands(self.body.label()))
            }
            C::HoldingKind(p) => self.holds_tool(p),
            C::Carries(t) => {
                self.require(self.node(t)?.carries(), || Refusal::NotAfforded(graph.label(t), "a surface"))
            }
            C::Encloses(t) => {
                let holds = self.node(t)?.encloses(graph.classes());
                self.require(holds, || Refusal::NotAfforded(graph.label(t), "a container"))
            }
            C::Accepts(t) => self.require(!self.node(t)?.hides_contents(), || Refusal::Shut(graph.label(t))),
            C::Fits(t, at) => self.fits(t, at),
            C::OriginNear(t) => self.origin_near(t),
            C::Upright => self.require(!self.at_rest(), || Refusal::NotUpright(self.body.label())),
            C::UprightOrNear(t) => {
                self.require(!self.at_rest() || graph.near(agent, t), || Refusal::NotUpright(self.body.label()))
            }
            C::AtRest => self.require(self.at_rest(), || Refusal::NotAtRest(self.body.label())),
            C::NotSitting => self.not_yet(State::Sitting),
            C::NotLying => self.not_yet(State::Lying),
            C::SeatFree(t) => self.free_place(t, Relation::SittingOn, SlotKind::Seat),
            C::BedFree(t) => self.free_place(t, Relation::LyingOn, SlotKind::Lie),
            C::SeatInside(t) => self.seat_inside(t),
            C::Steady(t) => self.steady(t),
            C::Aboard => self.require(vehicle_of(graph, agent).is_some(), || Refusal::NotAboard("any vehicle".into())),
            C::AboardOf(t) => {
                self.require(vehicle_of(graph, agent) == Some(t), || Refusal::NotAboard(graph.label(t).to_string()))
            }
            C::Facing(t) => self.require(graph.facing(agent, t), || Refusal::NotFacing(graph.label(t))),
            C::SameRoom(t) => self.same_room(t),
            C::Worn(t) => {
                let worn = graph.related(t, Relation::WornBy).any(|by| by == agent);
                self.require(worn, || Refusal::NotWorn(graph.label(t)))
            }
            C::Edible(t) => self.edible(t),
            C::Potable(t) => self.affords(t, &[Property::Drinkable, Property::Recipient]),
            C::Liquid(t) => self.liquid(t),
            C::Receives(t) => self.receives(t),
            C::Cuttable(t) => self.affords(t, &[Property::Eatable]).and(self.affords(t, &[Property::Cuttable])),
            C::OnHeat(t) => self.on_heat(t),
            C::InCold(t) => self.in_cold(t),
            C::Mobile(t) => self.affords(t, &[Property::Movable, Property::Graspable, Property::Sittable]),
            C::Soft(t) => self.soft(t),
            C::Typable(t) => self.typable(t),
            C::SafeToOpen(t) => {
                let node = self.node(t)?;
                let harmless = node.affords(Property::Cooler) || node.affords(Property::Heater);
                self.require(harmless || !node.is(State::On), || Refusal::InState(node.label(), State::On))
            }
            C::Personal(t) => {
                let node = self.node(t)?;
                let person = node.kind() == NodeKind::Agent || node.affords(Property::Person);
                self.require(person, || Refusal::NotAfforded(node.label(), "a person"))
            }
            C::Other(t) => self.require(t != agent, || Refusal::Oneself(graph.label(t))),
            C::Related(t, relation, u) => {
                let refusal = || Refusal::NotRelated(graph.label(t), relation, graph.label(u));
                self.require(graph.has(Edge::new(t, relation, u)), refusal)
            }
        }
    }

    fn require(&self, holds: bool, refusal: impl FnOnce() -> Refusal) -> Result<(), W> {
        if holds { Ok(()) } else { Err(W::because(refusal)) }
    }

    fn node(&self, id: NodeId) -> Result<&'a Node, W> {
        self.graph.node(id).ok_or_else(|| W::because(|| Refusal::NoSuchThing(id)))
    }

    fn affords(&self, id: NodeId, any: &[Property]) -> Result<(), W> {
        let node = self.node(id)?;
        let word = any.first().map_or("", |p| p.as_str());
        self.require(any.iter().any(|&p| node.affords(p)), || Refusal::NotAfforded(node.label(), word))
    }

    fn holds(&self, id: NodeId) -> bool {
        Relation::hands().into_iter().any(|hand| self.body.has(hand, id))
    }

    fn at_rest(&self) -> bool {
        self.body.is(State::Sitting) || self.body.is(State::Lying)
    }

    fn not_yet(&self, posture: State) -> Result<(), W> {
        self.require(!self.body.is(posture), || Refusal::PostureAlready(posture))
    }

    fn near(&self, id: NodeId) -> Result<(), W> {
        let refusal = || {
            let distance = self.graph.distance(self.agent, id);
            Refusal::NotNear { thing: self.graph.label(id), distance }
        };
        self.require(self.graph.near(self.agent, id), refusal)
    }

    fn accessible(&self, id: NodeId) -> Result<(), W> {
        match self.graph.hidden_in(id) {
            Some(inside) => {
                let label = |id| self.graph.label(id);
                Err(W::because(|| Refusal::Hidden { thing: label(id), inside: label(inside) }))
            }
            None => Ok(()),
        }
    }

    fn graspable(&self, id: NodeId) -> Result<(), W> {
        let node = self.node(id)?;
        self.require(node.is_graspable(), || Refusal::NotAfforded(node.label(), "graspable"))
    }

    fn not_elsewhere_held(&self, id: NodeId) -> Result<(), W> {
        let (graph, agent) = (self.graph, self.agent);
        if let Some(place) = graph.holder(id).filter(|p| p.at != agent) {
            return self.held_by(id, place.at);
        }
        if let Some(by) = graph.related(id, Relation::WornBy).find(|&by| by != agent) {
            let refusal = || Refusal::WornByOther { thing: graph.label(id), by: graph.label(by) };
            return self.require(false, refusal);
        }
        self.require(!graph.rests_at(agent, id), || Refusal::RestingOnIt(graph.label(id)))?;
        let other = graph.agents().iter().find(|&&other| other != agent && graph.rests_at(other, id));
        let refusal = |by: NodeId| W::because(|| Refusal::UnderOther { thing: graph.label(id), by: graph.label(by) });
        other.map_or(Ok(()), |&by| Err(refusal(by)))
    }

    fn holds_tool(&self, property: Property) -> Result<(), W> {
        let tool = |id| self.graph.node(id).is_some_and(|n| n.affords(property));
        self.require(self.graph.held(self.agent).any(tool), || Refusal::NoTool(property))
    }

    fn origin_near(&self, id: NodeId) -> Result<(), W> {
        let Some(origin) = origin(self.graph, id) else { return Ok(()) };
        self.fits(id, origin.at)?;
        self.accessible(origin.at)?;
        let shut = origin.relation == Relation::Inside && self.node(origin.at)?.hides_contents();
        self.require(!shut, || Refusal::Shut(self.graph.label(origin.at)))?;
        self.near(origin.at)
    }

    fn seat_inside(&self, id: NodeId) -> Result<(), W> {
        let places = self.node(id)?.capacity(SlotKind::Seat);
        let agent = |n: &NodeId| self.graph.node(*n).is_some_and(|n| n.kind() == NodeKind::Agent);
        let taken = self.graph.relating(Relation::Inside, id).filter(agent).count();
        self.require(taken < places as usize, || Refusal::Occupied { seat: self.graph.label(id), places })
    }

    fn same_room(&self, id: NodeId) -> Result<(), W> {
        let no_way = || W::because(|| Refusal::NoWay(self.graph.label(id)));
        let room = self.graph.room_of(id).ok_or_else(no_way)?;
        let refusal = || Refusal::OtherRoom { thing: self.graph.label(id), room: self.graph.label(room) };
        self.require(self.graph.room_of(self.agent) == Some(room), refusal)
    }

    fn edible(&self, id: NodeId) -> Result<(), W> {
        let eatable = |n: NodeId| self.graph.node(n).is_some_and(|n| n.affords(Property::Eatable));
        let in_reach = |n: NodeId| eatable(n) && self.graph.hidden_in(n).is_none();
        let on_it = eatable(id) || self.graph.resting_at(id).any(in_reach);
        self.require(on_it, || Refusal::NotAfforded(self.graph.label(id), "eatable"))
    }

    fn liquid(&self, id: NodeId) -> Result<(), W> {
        let node = self.node(id)?;
        let full = node.contents().is_some();
        if full { Ok(()) } else { self.affords(id, &[Property::Pourable, Property::Drinkable]) }
    }

    fn receives(&self, id: NodeId) -> Result<(), W> {
        let node = self.node(id)?;
        self.require(node.receives_liquids(), || Refusal::NotAfforded(node.label(), "a recipient"))
    }

    fn on_heat(&self, id: NodeId) -> Result<(), W> {
        let hot = |id: &NodeId| self.graph.node(*id).is_some_and(|n| n.affords(Property::Heater) && n.is(State::On));
        let heated = self.graph.climb(id, &mut |place| hot(&place.at)).is_some();
        self.require(heated, || Refusal::NoHeat(self.graph.label(id)))
    }

    fn in_cold(&self, id: NodeId) -> Result<(), W> {
        let cools = |n: &Node| n.affords(Property::Cooler) && (n.is(State::On) || !n.affords(Property::Switchable));
        let cold = |p: Place| p.relation == Relation::Inside && self.graph.node(p.at).is_some_and(cools);
        let cooled = self.graph.climb(id, &mut { cold }).is_some();
        self.require(cooled, || Refusal::NoCold(self.graph.label(id)))
    }

    fn soft(&self, id: NodeId) -> Result<(), W> {
        let node = self.node(id)?;
        let gives = [Property::Wearable, Property::Wiper, Property::Cream].into_iter().any(|p| node.affords(p));
        let class = || self.graph.classes().get(node.class());
        let soft = gives || class().is_some_and(|class| class.traits.contains(Trait::Squeezable));
        self.require(soft, || Refusal::NotAfforded(node.label(), "soft"))
    }

    fn typable(&self, id: NodeId) -> Result<(), W> {
        let node = self.node(id)?;
        let keys = &**node.class() == "keyboard" || node.affords(Property::Switchable);
        self.require(keys, || Refusal::NotAfforded(node.label(), "something to type on"))
    }

    fn free_place(&self, id: NodeId, relation: Relation, kind: SlotKind) -> Result<(), W> {
        let places = self.node(id)?.capacity(kind);
        let taken = self.graph.relating(relation, id).count();
        self.require(taken < places as usize, || Refusal::Occupied { seat: self.graph.label(id), places })
    }

    /// No agent carries the object, in a hand or on an object in a hand.
    fn steady(&self, id: NodeId) -> Result<(), W> {
        let is_agent = |p: Place| self.graph.node(p.at).is_some_and(|n| n.kind() == NodeKind::Agent);
        let carrier = self.graph.climb(id, &mut { is_agent });
        carrier.map_or(Ok(()), |by| self.held_by(id, by))
    }

    fn held_by(&self, thing: NodeId, by: NodeId) -> Result<(), W> {
        let label = |id| self.graph.label(id);
        self.require(false, || Refusal::HeldByOther { thing: label(thing), by: label(by) })
    }

    fn fits(&self, id: NodeId, at: NodeId) -> Result<(), W> {
        let (thing, target) = (self.node(id)?, self.node(at)?);
        let why = misfit(self.graph, thing, target);
        let refusal = |why| W::because(|| Refusal::DoesNotFit { thing: thing.label(), at: target.label(), why });
        why.map_or(Ok(()), |why| Err(refusal(why)))
    }
}
