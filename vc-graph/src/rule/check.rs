//! Whether what actions need is the case, and if not, why.

use crate::class::SlotKind;
use crate::node::{Kind, Node};
use crate::rule::condition::Condition;
use crate::rule::refusal::Refusal;
use crate::validate::{carries, encloses, soaks};
use crate::{Action, Edge, NodeId, Place, Property, Relation, SceneGraph, State};

/// Whether the action's agent and things exist and are as many as the verb takes.
pub(super) fn check_things(graph: &SceneGraph, agent: NodeId, action: &Action) -> Option<Refusal> {
    let Some(body) = graph.node(agent) else { return Some(Refusal::NoSuchThing(agent)) };
    if body.kind() != Kind::Agent {
        return Some(Refusal::NoAgent(body.label()));
    }
    let (verb, takes, given) = (action.verb, action.verb.arity(), action.things().count());
    if takes != given {
        return Some(Refusal::Arity { verb, takes, given });
    }
    if let Some(missing) = action.things().find(|&id| graph.node(id).is_none()) {
        return Some(Refusal::NoSuchThing(missing));
    }
    let itself = action.object.filter(|_| action.object == action.target);
    itself.map(|id| Refusal::WithItself(graph.label(id)))
}

/// Classes besides clothes that can be squeezed.
const SOFT: &[&str] = &[
    "toothpaste",
    "shampoo",
    "food_peanut_butter",
    "dish_soap",
    "soap",
    "bar_soap",
    "towel",
    "rag",
    "paper",
    "sponge",
    "lemon",
    "check",
    "condiment_bottle",
    "cleaning_solution",
    "washing_sponge",
    "lotion_bottle",
];

impl Condition {
    /// Whether the condition holds for an agent.
    pub fn holds(&self, graph: &SceneGraph, agent: NodeId) -> bool {
        self.check(graph, agent).is_ok()
    }

    /// Whether the condition holds for an agent, and if not, why.
    ///
    /// # Errors
    /// The [`Refusal`] an action that needs it meets.
    pub fn check(&self, graph: &SceneGraph, agent: NodeId) -> Result<(), Refusal> {
        let scene = Scene { graph, agent, body: find(graph, agent)? };
        match *self {
            Self::Affords(t, p) => scene.affords(t, &[p]),
            Self::In(t, s) => require(find(graph, t)?.is(s), || Refusal::NotInState(graph.label(t), s)),
            Self::NotIn(t, s) => require(!find(graph, t)?.is(s), || Refusal::InState(graph.label(t), s)),
            Self::Near(t) => scene.near(t),
            Self::Reachable(t) => require(graph.room_of(t).is_some(), || Refusal::NoWay(graph.label(t))),
            Self::Accessible(t) => scene.accessible(t),
            Self::Graspable(t) => scene.graspable(t),
            Self::NotElsewhereHeld(t) => scene.not_elsewhere_held(t),
            Self::FreeHand => require(graph.free_hand(agent).is_some(), || Refusal::NoFreeHand),
            Self::FreeHandOrHolding(t) => {
                require(graph.free_hand(agent).is_some() || scene.holds(t), || Refusal::NoFreeHand)
            }
            Self::Holding(t) => require(scene.holds(t), || Refusal::NotHeld(graph.label(t))),
            Self::HoldingSomething => require(graph.held(agent).next().is_some(), || Refusal::EmptyHands),
            Self::HoldingKind(p) => scene.holds_tool(p),
            Self::Carries(t) => require(carries(find(graph, t)?), || Refusal::NotAfforded(graph.label(t), "a surface")),
            Self::Encloses(t) => {
                require(encloses(find(graph, t)?), || Refusal::NotAfforded(graph.label(t), "a container"))
            }
            Self::Accepts(t) => require(!find(graph, t)?.hides_contents(), || Refusal::Shut(graph.label(t))),
            Self::Fits(t, at) => fits(graph, t, at),
            Self::OriginNear(t) => scene.origin_near(t),
            Self::Upright => require(!scene.at_rest(), || Refusal::NotUpright),
            Self::UprightOrNear(t) => require(!scene.at_rest() || graph.near(agent, t), || Refusal::NotUpright),
            Self::AtRest => require(scene.at_rest(), || Refusal::NotAtRest),
            Self::NotSitting => scene.not_yet(State::Sitting),
            Self::NotLying => scene.not_yet(State::Lying),
            Self::SeatFree(t) => free_place(graph, t, Relation::SittingOn, SlotKind::Seat),
            Self::BedFree(t) => free_place(graph, t, Relation::LyingOn, SlotKind::Lie),
            Self::SeatInside(t) => scene.seat_inside(t),
            Self::Aboard => require(vehicle_of(graph, agent).is_some(), || Refusal::NotAboard("any vehicle".into())),
            Self::AboardOf(t) => {
                require(vehicle_of(graph, agent) == Some(t), || Refusal::NotAboard(graph.label(t).to_string()))
            }
            Self::Facing(t) => require(graph.facing(agent, t), || Refusal::NotFacing(graph.label(t))),
            Self::SameRoom(t) => scene.same_room(t),
            Self::Worn(t) => {
                let worn = graph.related(t, Relation::WornBy).any(|by| by == agent);
                require(worn, || Refusal::NotWorn(graph.label(t)))
            }
            Self::Edible(t) => scene.edible(t),
            Self::Potable(t) => scene.affords(t, &[Property::Drinkable, Property::Recipient]),
            Self::Liquid(t) => scene.liquid(t),
            Self::Receives(t) => scene.receives(t),
            Self::Cuttable(t) => scene.affords(t, &[Property::Eatable]).and(scene.affords(t, &[Property::Cuttable])),
            Self::OnHeat(t) => scene.on_heat(t),
            Self::Mobile(t) => scene.affords(t, &[Property::Movable, Property::Graspable, Property::Sittable]),
            Self::Soft(t) => scene.soft(t),
            Self::Typable(t) => scene.typable(t),
            Self::SafeToOpen(t) => {
                let node = find(graph, t)?;
                let harmless = node.affords(Property::Cooler) || node.affords(Property::Heater);
                require(harmless || !node.is(State::On), || Refusal::InState(node.label(), State::On))
            }
            Self::Personal(t) => {
                let node = find(graph, t)?;
                let person = node.kind() == Kind::Agent || node.affords(Property::Person);
                require(person, || Refusal::NotAfforded(node.label(), "a person"))
            }
            Self::Related(t, relation, u) => {
                let refusal = || Refusal::NotRelated(graph.label(t), relation, graph.label(u));
                require(graph.has(Edge::new(t, relation, u)), refusal)
            }
        }
    }
}

fn require(holds: bool, refusal: impl FnOnce() -> Refusal) -> Result<(), Refusal> {
    if holds { Ok(()) } else { Err(refusal()) }
}

fn find(graph: &SceneGraph, id: NodeId) -> Result<&Node, Refusal> {
    graph.node(id).ok_or(Refusal::NoSuchThing(id))
}

/// The vehicle an agent is in.
pub(super) fn vehicle_of(graph: &SceneGraph, agent: NodeId) -> Option<NodeId> {
    let drivable = |id: &NodeId| graph.node(*id).is_some_and(|n| n.affords(Property::Drivable));
    graph.related(agent, Relation::Inside).find(drivable)
}

/// A graph seen by an agent.
struct Scene<'a> {
    graph: &'a SceneGraph,
    agent: NodeId,
    body: &'a Node,
}

impl Scene<'_> {
    fn affords(&self, id: NodeId, any: &[Property]) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        let word = any.first().map_or("", |p| crate::vocabulary::Word::as_str(*p));
        require(any.iter().any(|&p| node.affords(p)), || Refusal::NotAfforded(node.label(), word))
    }

    fn holds(&self, id: NodeId) -> bool {
        Relation::hands().into_iter().any(|hand| self.body.has(hand, id))
    }

    fn at_rest(&self) -> bool {
        self.body.is(State::Sitting) || self.body.is(State::Lying)
    }

    fn not_yet(&self, posture: State) -> Result<(), Refusal> {
        require(!self.body.is(posture), || Refusal::PostureAlready(posture))
    }

    fn near(&self, id: NodeId) -> Result<(), Refusal> {
        let refusal = || {
            let distance = self.graph.distance(self.agent, id);
            Refusal::NotNear { thing: self.graph.label(id), distance }
        };
        require(self.graph.near(self.agent, id), refusal)
    }

    fn accessible(&self, id: NodeId) -> Result<(), Refusal> {
        match self.graph.hidden_in(id) {
            Some(inside) => {
                let (thing, inside) = (self.graph.label(id), self.graph.label(inside));
                Err(Refusal::Hidden { thing, inside })
            }
            None => Ok(()),
        }
    }

    fn graspable(&self, id: NodeId) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        // Water is scooped up; VirtualHome's programs grab it.
        let scooped = &**node.class() == "water";
        require(scooped || node.affords(Property::Graspable), || Refusal::NotAfforded(node.label(), "graspable"))
    }

    fn not_elsewhere_held(&self, id: NodeId) -> Result<(), Refusal> {
        if let Some(place) = self.graph.holder(id).filter(|p| p.at != self.agent) {
            let (thing, by) = (self.graph.label(id), self.graph.label(place.at));
            return Err(Refusal::HeldByOther { thing, by });
        }
        if let Some(by) = self.graph.related(id, Relation::WornBy).find(|&by| by != self.agent) {
            let (thing, by) = (self.graph.label(id), self.graph.label(by));
            return Err(Refusal::WornByOther { thing, by });
        }
        require(!self.graph.rests_at(self.agent, id), || Refusal::RestingOnIt(self.graph.label(id)))
    }

    fn holds_tool(&self, property: Property) -> Result<(), Refusal> {
        let tool = |id| self.graph.node(id).is_some_and(|n| n.affords(property));
        require(self.graph.held(self.agent).any(tool), || Refusal::NoTool(property))
    }

    fn origin_near(&self, id: NodeId) -> Result<(), Refusal> {
        let Some(origin) = origin(self.graph, id) else { return Ok(()) };
        fits(self.graph, id, origin.at)?;
        self.accessible(origin.at)?;
        if origin.relation == Relation::Inside && find(self.graph, origin.at)?.hides_contents() {
            return Err(Refusal::Shut(self.graph.label(origin.at)));
        }
        self.near(origin.at)
    }

    fn seat_inside(&self, id: NodeId) -> Result<(), Refusal> {
        let places = find(self.graph, id)?.slots(SlotKind::Seat).max(1);
        let agent = |n: &NodeId| self.graph.node(*n).is_some_and(|n| n.kind() == Kind::Agent);
        let taken = self.graph.relating(Relation::Inside, id).filter(agent).count();
        require(taken < places as usize, || Refusal::Occupied { seat: self.graph.label(id), places })
    }

    fn same_room(&self, id: NodeId) -> Result<(), Refusal> {
        let room = self.graph.room_of(id).ok_or_else(|| Refusal::NoWay(self.graph.label(id)))?;
        let refusal = || Refusal::OtherRoom { thing: self.graph.label(id), room: self.graph.label(room) };
        require(self.graph.room_of(self.agent) == Some(room), refusal)
    }

    fn edible(&self, id: NodeId) -> Result<(), Refusal> {
        let eatable = |n: NodeId| self.graph.node(n).is_some_and(|n| n.affords(Property::Eatable));
        let on_it = eatable(id) || self.graph.resting_at(id).any(eatable);
        require(on_it, || Refusal::NotAfforded(self.graph.label(id), "eatable"))
    }

    fn liquid(&self, id: NodeId) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        let full = node.contents().is_some();
        if full { Ok(()) } else { self.affords(id, &[Property::Pourable, Property::Drinkable]) }
    }

    fn receives(&self, id: NodeId) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        require(soaks(node) || node.affords(Property::Recipient), || Refusal::NotAfforded(node.label(), "a recipient"))
    }

    fn on_heat(&self, id: NodeId) -> Result<(), Refusal> {
        let hot = |id: &NodeId| self.graph.node(*id).is_some_and(|n| n.affords(Property::Heater) && n.is(State::On));
        let heated = self.graph.support_chain(id).iter().any(hot);
        require(heated, || Refusal::NoHeat(self.graph.label(id)))
    }

    fn soft(&self, id: NodeId) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        let known = SOFT.iter().any(|&name| crate::vocabulary::same_word(name, node.class()));
        let soft = known || [Property::Wearable, Property::Wiper, Property::Cream].into_iter().any(|p| node.affords(p));
        require(soft, || Refusal::NotAfforded(node.label(), "soft"))
    }

    fn typable(&self, id: NodeId) -> Result<(), Refusal> {
        let node = find(self.graph, id)?;
        let keys = &**node.class() == "keyboard" || node.affords(Property::Switchable);
        require(keys, || Refusal::NotAfforded(node.label(), "something to type on"))
    }
}

fn free_place(graph: &SceneGraph, id: NodeId, relation: Relation, kind: SlotKind) -> Result<(), Refusal> {
    let places = find(graph, id)?.slots(kind).max(1);
    let taken = graph.relating(relation, id).count();
    require(taken < places as usize, || Refusal::Occupied { seat: graph.label(id), places })
}

/// Where a held thing was taken from.
pub(super) fn origin(graph: &SceneGraph, id: NodeId) -> Option<Place> {
    let off = graph.related(id, Relation::TakenOff).next().map(|at| Place { relation: Relation::On, at });
    off.or_else(|| graph.related(id, Relation::TakenOut).next().map(|at| Place { relation: Relation::Inside, at }))
}

/// Whether a thing has room on or in another, where the sizes of both are known.
/// What has a lid must take the thing in some turn, with what is in it already;
/// out of what is open at the top things may stick; surfaces may be overhung.
fn fits(graph: &SceneGraph, id: NodeId, at: NodeId) -> Result<(), Refusal> {
    let (thing, target) = (find(graph, id)?, find(graph, at)?);
    let no = |why| Err(Refusal::DoesNotFit { thing: thing.label(), at: target.label(), why });
    if id == at || graph.rests_at(at, id) {
        return no("rests on or in it");
    }
    let inside = || graph.relating(Relation::Inside, at).filter(|&n| n != id);
    let slots = target.slots(SlotKind::Slot);
    if slots > 0 && inside().count() >= slots as usize {
        return no("has no free slot");
    }
    let (Some(size), Some(space)) = (thing.spec().bounds, target.spec().bounds) else { return Ok(()) };
    if target.affords(Property::Surface) || !target.affords(Property::Openable) {
        return Ok(());
    }
    let taken = |n: NodeId| graph.node(n).and_then(|n| n.spec().bounds).map_or(0.0, |b| b.volume());
    match () {
        () if sorted(size.size()).iter().zip(sorted(space.size())).any(|(s, room)| *s > room + SLACK) => {
            no("is too small")
        }
        () if inside().map(taken).sum::<f32>() + size.volume() > space.volume() => no("is full"),
        () => Ok(()),
    }
}

/// By how much a box may be larger than the space its shape still fits, metres.
const SLACK: f32 = 0.02;

fn sorted(size: nalgebra::Vector3<f32>) -> [f32; 3] {
    let mut all = [size.x, size.y, size.z];
    all.sort_unstable_by(f32::total_cmp);
    all
}
