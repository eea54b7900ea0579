//! The preconditions of actions in VirtualHome's simulator.

use super::Memory;
use super::view::{Link, View};
use crate::{Action, Label, NodeId, Property, Refusal, State, Verb};

type Judged = Result<(), Refusal>;

/// The number of agents that a seat holds, by the class as it is written; one for other classes.
const SEATS: &[(&str, usize)] =
    &[("couch", 4), ("bed", 4), ("loveseat", 2), ("sofa", 4), ("pianobench", 2), ("bench", 2)];
const BEDS: &[(&str, usize)] = &[("couch", 2), ("bathtub", 2), ("bed", 3), ("loveseat", 2), ("sofa", 2)];

/// Classes apart from clothes that can be squeezed.
const SOFT: &[&str] = &[
    "cleaning_solution",
    "tooth_paste",
    "shampoo",
    "food_peanut_butter",
    "dish_soap",
    "soap",
    "towel",
    "rag",
    "paper",
    "sponge",
    "food_lemon",
    "check",
];

fn require(holds: bool, refusal: impl FnOnce() -> Refusal) -> Judged {
    if holds { Ok(()) } else { Err(refusal()) }
}

impl View<'_> {
    /// Checks the preconditions of an action; the error is the first that is not met.
    pub(super) fn needs(self, action: &Action, memory: &Memory) -> Judged {
        match (action.verb, action.object, action.target) {
            (Verb::Stand | Verb::Sleep | Verb::WakeUp, ..) => require(self.at_rest(), || Refusal::NotAtRest(self.me())),
            (verb @ (Verb::Place | Verb::PutIn | Verb::Pour), Some(x), Some(y)) => self.needs_of_two(verb, x, y),
            (verb, Some(x), None) => self.needs_of_one(verb, x, memory),
            (verb, ..) => Err(Refusal::NotInVirtualHome(verb)),
        }
    }

    fn needs_of_one(self, verb: Verb, x: NodeId, memory: &Memory) -> Judged {
        match verb {
            Verb::Walk | Verb::Run => self.walkable(x),
            Verb::Find if self.stays_to_find(x) => self.close(x),
            Verb::Find => self.walkable(x),
            Verb::TurnTo => Ok(()),
            Verb::LookAt | Verb::PointAt => self.faced(x),
            Verb::Watch => self.watchable(x),
            Verb::Grab => self.grabbable(x),
            Verb::PutBack => memory
                .taken
                .get(&x)
                .map_or_else(|| Err(Refusal::NotHeld(self.label(x))), |&(at, link)| self.puttable(x, at, link)),
            Verb::Drop => self.held_by_agent(x),
            Verb::Open => self.openable(x, State::Closed),
            Verb::Close => self.openable(x, State::Open),
            Verb::SwitchOn => self.switchable(x, State::Off, &[Property::Switchable]),
            Verb::SwitchOff => self.switchable(x, State::On, &[Property::Switchable]),
            Verb::PlugIn => self.pluggable(x, State::PluggedOut, &[Property::Plug]),
            Verb::PlugOut => self.pluggable(x, State::PluggedIn, &[Property::Plug]),
            Verb::Sit => self.seat(x, State::Sitting, Property::Sittable, SEATS),
            Verb::Lie => self.seat(x, State::Lying, Property::Lieable, BEDS),
            Verb::Eat => self.edible(x),
            Verb::Drink => {
                self.of_kind(x, &[Property::Drinkable, Property::Recipient]).and_then(|()| self.held_by_agent(x))
            }
            Verb::Read => self.of_kind(x, &[Property::Readable]).and_then(|()| self.held_by_agent(x)),
            Verb::Touch => self.close(x).and_then(|()| self.in_the_open(x)),
            Verb::Wipe => {
                self.close(x).and_then(|()| require(!self.held().is_empty(), || Refusal::EmptyHands(self.me())))
            }
            Verb::Wash | Verb::Rinse | Verb::Scrub => self.close(x),
            Verb::Cut => self.cuttable(x),
            Verb::Wear => self.held_by_agent(x).and_then(|()| self.of_kind(x, &[Property::Wearable])),
            Verb::TakeOff => self.worn(x).and_then(|()| self.of_kind(x, &[Property::Wearable])),
            Verb::Push | Verb::Pull | Verb::Move => self.movable(verb, x),
            Verb::Squeeze => self.squeezable(x),
            Verb::Type => self.close(x).and_then(|()| {
                if self.name(x) == "keyboard" { Ok(()) } else { self.of_kind(x, &[Property::Switchable]) }
            }),
            Verb::Greet => self.of_kind(x, &[Property::Person]),
            _ => Err(Refusal::NotInVirtualHome(verb)),
        }
    }

    fn needs_of_two(self, verb: Verb, x: NodeId, y: NodeId) -> Judged {
        match verb {
            Verb::Place => self.puttable(x, y, Link::On),
            Verb::PutIn => self.puttable(x, y, Link::Inside),
            _ => {
                self.of_kind(x, &[Property::Pourable, Property::Drinkable])?;
                if !matches!(self.name(y), "hands_both" | "sponge" | "face") {
                    self.of_kind(y, &[Property::Recipient])?;
                }
                self.held_by_agent(x)?;
                self.close(y)
            }
        }
    }

    fn me(self) -> Label {
        self.label(self.agent)
    }

    fn label(self, id: NodeId) -> Label {
        self.graph.label(id)
    }

    pub(super) fn at_rest(self) -> bool {
        self.is(self.agent, State::Sitting) || self.is(self.agent, State::Lying)
    }

    /// Whether `find` needs no walk: the object is worn, a body part, or near, or the agent sits or lies.
    pub(super) fn stays_to_find(self, x: NodeId) -> bool {
        self.has(x, Link::On, self.agent) || self.is_any(x, &[Property::BodyPart]) || self.near(x) || self.at_rest()
    }

    fn of_kind(self, x: NodeId, any: &[Property]) -> Judged {
        let word = any.first().map_or("", |p| crate::vocabulary::Word::as_str(*p));
        require(self.is_any(x, any), || Refusal::NotAfforded(self.label(x), word))
    }

    fn close(self, x: NodeId) -> Judged {
        require(self.near(x), || Refusal::NotNear { thing: self.label(x), distance: None })
    }

    fn in_the_open(self, x: NodeId) -> Judged {
        let shut = self.shut_in(x);
        shut.map_or(Ok(()), |at| Err(Refusal::Hidden { thing: self.label(x), inside: self.label(at) }))
    }

    fn hand_free(self) -> Judged {
        require(self.free_hand().is_some(), || Refusal::NoFreeHand(self.me()))
    }

    fn held_by_agent(self, x: NodeId) -> Judged {
        require(self.holds(x), || Refusal::NotHeld(self.label(x)))
    }

    fn in_state(self, x: NodeId, state: State) -> Judged {
        require(self.is(x, state), || Refusal::NotInState(self.label(x), state))
    }

    fn out_of_state(self, x: NodeId, state: State) -> Judged {
        require(!self.is(x, state), || Refusal::InState(self.label(x), state))
    }

    fn in_some_room(self, x: NodeId) -> Judged {
        require(self.room(x).is_some(), || Refusal::NoWay(self.label(x)))
    }

    fn walkable(self, x: NodeId) -> Judged {
        self.in_some_room(x)?;
        require(!self.at_rest(), || Refusal::NotUpright(self.me()))?;
        self.in_some_room(self.agent)
    }

    fn faced(self, x: NodeId) -> Judged {
        require(self.faces(x), || Refusal::NotFacing(self.label(x)))
    }

    fn watchable(self, x: NodeId) -> Judged {
        self.of_kind(x, &[Property::Lookable])?;
        self.in_some_room(x)?;
        self.in_some_room(self.agent)?;
        let room = self.room(x);
        let elsewhere = || Refusal::OtherRoom { thing: self.label(x), room: self.label(room.unwrap_or(x)) };
        require(room == self.room(self.agent), elsewhere)?;
        self.faced(x)?;
        let direct = self.has(self.agent, Link::Facing, x);
        require(!self.at_rest() || self.name(x) == "computer" || direct, || Refusal::NotFacing(self.label(x)))
    }

    fn grabbable(self, x: NodeId) -> Judged {
        if !matches!(self.name(x), "water" | "child") {
            self.of_kind(x, &[Property::Graspable])?;
        }
        self.close(x)?;
        self.in_the_open(x)?;
        self.hand_free()?;
        self.in_some_room(self.agent)
    }

    /// Whether an object can be put somewhere.
    fn puttable(self, x: NodeId, y: NodeId, link: Link) -> Judged {
        self.held_by_agent(x)?;
        self.close(y)?;
        let shut = link == Link::Inside && self.is_any(y, &[Property::Openable]) && !self.is(y, State::Open);
        require(!shut, || Refusal::Shut(self.label(y)))
    }

    fn openable(self, x: NodeId, from: State) -> Judged {
        if !matches!(self.name(x), "desk" | "window") {
            self.of_kind(x, &[Property::Openable])?;
        }
        self.close(x)?;
        if from == State::Closed {
            self.hand_free()?;
        }
        self.in_state(x, from)?;
        if from == State::Closed { self.out_of_state(x, State::On) } else { Ok(()) }
    }

    fn switchable(self, x: NodeId, from: State, kind: &[Property]) -> Judged {
        self.of_kind(x, kind)?;
        self.close(x)?;
        self.in_state(x, from)?;
        if from == State::Off { self.out_of_state(x, State::PluggedOut) } else { Ok(()) }
    }

    fn pluggable(self, x: NodeId, from: State, kind: &[Property]) -> Judged {
        self.of_kind(x, kind)?;
        self.close(x)?;
        self.hand_free()?;
        self.in_state(x, from)
    }

    fn seat(self, x: NodeId, posture: State, kind: Property, most: &[(&str, usize)]) -> Judged {
        self.close(x)?;
        require(!self.is(self.agent, posture), || Refusal::PostureAlready(posture))?;
        self.of_kind(x, &[kind])?;
        let places = most.iter().find(|(name, _)| *name == self.name(x)).map_or(1, |(_, places)| *places);
        let full = || Refusal::Occupied { seat: self.label(x), places: places as u32 };
        require(self.sources(Link::On, x).len() < places, full)
    }

    fn edible(self, x: NodeId) -> Judged {
        self.close(x)?;
        let eatable = [Property::Eatable];
        let there = self.is_any(x, &eatable) || self.sources(Link::On, x).into_iter().any(|n| self.is_any(n, &eatable));
        if there { Ok(()) } else { self.of_kind(x, &eatable) }
    }

    fn cuttable(self, x: NodeId) -> Judged {
        self.hand_free()?;
        self.close(x)?;
        self.of_kind(x, &[Property::Eatable])?;
        self.of_kind(x, &[Property::Cuttable])?;
        let knife = self.held().into_iter().any(|id| self.name(id).contains("knife"));
        require(knife, || Refusal::NoTool(Property::Cutter))
    }

    fn worn(self, x: NodeId) -> Judged {
        require(self.has(x, Link::On, self.agent), || Refusal::NotWorn(self.label(x)))
    }

    fn movable(self, verb: Verb, x: NodeId) -> Judged {
        if verb != Verb::Push && !matches!(self.name(x), "button" | "chair" | "curtain") {
            self.of_kind(x, &[Property::Movable])?;
        }
        self.close(x)?;
        self.in_the_open(x)?;
        self.hand_free()
    }

    fn squeezable(self, x: NodeId) -> Judged {
        self.hand_free()?;
        self.close(x)?;
        if SOFT.contains(&self.name(x)) { Ok(()) } else { self.of_kind(x, &[Property::Wearable]) }
    }
}
