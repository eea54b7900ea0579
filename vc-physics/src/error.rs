//! Errors of worlds, agents and snapshots.

use vc_graph::{Label, NodeId, Side};

/// The reason why a world refuses a call. Nodes are given by their numbers; [`named`](Self::named) replaces
/// them by labels.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PhysicsError<N = NodeId> {
    /// A value in the settings is invalid.
    #[error("settings: {0}")]
    BadSettings(&'static str),
    /// The node is not in the scene graph.
    #[error("there is no node {0} in the scene graph")]
    NoSuchNode(N),
    /// The node has no body in this world.
    #[error("{0} has no body; give it a pose and an asset or a box, then insert it")]
    NoBody(N),
    /// The node has a body already.
    #[error("{0} has a body already; move it instead")]
    Duplicate(N),
    /// A number is not finite, a position is more than 1,000 km away, or a rotation is invalid.
    #[error("{0} of {1} is not finite, or farther than 1,000 km")]
    NotFinite(&'static str, N),
    /// The node has no such moving part.
    #[error("{id} has {count} moving parts, asked for part {part}")]
    NoSuchPart {
        /// The node.
        id: N,
        /// The requested part.
        part: usize,
        /// The number of parts.
        count: usize,
    },
    /// The node is locked.
    #[error("{0} is locked; unlock it first")]
    Locked(N),
    /// The node would overlap another one.
    #[error("{id} would be inside {other}: put it elsewhere, or make room there first")]
    Overlap {
        /// The node that was to be placed.
        id: N,
        /// The node that is already there.
        other: N,
    },
    /// The body does not move by itself or by a push.
    #[error("{0} does not move: it is fixed, held, an agent or stopped")]
    NotFree(N),
    /// The thing is not a vehicle.
    #[error("{0} is not a vehicle; make it one with `PhysicsWorld::add_vehicle` first")]
    NoVehicle(N),
    /// A vehicle's data are invalid.
    #[error("vehicle {0}: {1}")]
    BadVehicle(N, &'static str),
    /// The data of water are invalid.
    #[error("water: {0}")]
    BadWater(&'static str),
}

/// The reason why a world cannot be recorded, or a record not be read. Nodes are given as in [`PhysicsError`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RestError<N = NodeId> {
    /// Something moves, or is about to: things, agents, or parts that are driven.
    #[error("{} still: let all come to rest first", moves(.0))]
    Moves(Vec<N>),
    /// An agent's hands are guided.
    #[error("a hand of {0} is guided; release it first")]
    Guided(N),
    /// A vehicle is not where it was at the start: records know no wheels.
    #[error("{0} is a vehicle that has driven, and records know no wheels; save the whole world")]
    Vehicle(N),
    /// A thing has been stopped since the start: nobody knows where it is.
    #[error("{0} was stopped, as it became non-finite or fell below everything; place it first")]
    Stopped(N),
    /// The world has not come from the one that was given as its start.
    #[error("the two worlds have different agents: the one has not come from the other")]
    OtherWorld,
    /// Things do not stay where they were recorded.
    #[error("{} when built anew: they are within something, or something holds them that is not recorded", moves(.0))]
    Restless(Vec<N>),
}

impl<N> RestError<N> {
    /// The same error with other names for nodes; see [`PhysicsError::named`].
    pub fn named<M>(self, name: &impl Fn(N) -> M) -> RestError<M> {
        use RestError as E;
        let names = |all: Vec<N>| all.into_iter().map(name).collect();
        match self {
            E::Moves(all) => E::Moves(names(all)),
            E::Guided(id) => E::Guided(name(id)),
            E::Vehicle(id) => E::Vehicle(name(id)),
            E::Stopped(id) => E::Stopped(name(id)),
            E::OtherWorld => E::OtherWorld,
            E::Restless(all) => E::Restless(names(all)),
        }
    }
}

fn moves<N: std::fmt::Display>(nodes: &[N]) -> String {
    let names: Vec<String> = nodes.iter().map(N::to_string).collect();
    match names.len() {
        0 => "something moves".to_owned(),
        1 => format!("{} moves", names[0]),
        _ => format!("{} move", names.join(", ")),
    }
}

/// The reason why an agent cannot do something with its body. Nodes are given as in [`PhysicsError`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AgentError<N = NodeId> {
    /// The node is not an agent of this world.
    #[error("{0} is not an agent of this world")]
    NoSuchAgent(N),
    /// The hand holds something.
    #[error("the hand of {agent} holds {held}; put it down first")]
    HandFull {
        /// The agent.
        agent: N,
        /// The held thing.
        held: N,
    },
    /// The hand holds nothing.
    #[error("the hand of {0} holds nothing; let it take something first")]
    HandEmpty(N),
    /// The thing is too far away.
    #[error("{id} is {distance:.2} m from the shoulder of {agent}, its reach is {reach:.2} m")]
    OutOfReach {
        /// The agent.
        agent: N,
        /// The thing.
        id: N,
        /// Its distance, metres.
        distance: f32,
        /// The agent's reach, metres.
        reach: f32,
    },
    /// The thing is too heavy to carry.
    #[error("{id} has {mass:.1} kg, an agent carries {limit:.1} kg")]
    TooHeavy {
        /// The thing.
        id: N,
        /// Its mass, kilograms.
        mass: f32,
        /// The limit, kilograms.
        limit: f32,
    },
    /// Somebody sits or lies on the thing.
    #[error("{by} is on {seat}, so it cannot be carried")]
    Occupied {
        /// The thing that was to be taken.
        seat: N,
        /// The agent on it.
        by: N,
    },
    /// Somebody already holds the thing.
    #[error("{0} is held already")]
    Held(N),
    /// The agent has the wrong posture.
    #[error("{agent} is {posture}; let it stand up, sit or lie down first, as the call needs")]
    Posture {
        /// The agent.
        agent: N,
        /// Its present posture: standing, sitting, lying.
        posture: &'static str,
    },
    /// There is no free place around the seat to get up to.
    #[error("there is no free place around {0} to get up to")]
    NoExit(N),
    /// The seat has no free place.
    #[error("every place on {0} is taken")]
    SeatTaken(N),
    /// Things stand on the free places of the seat.
    #[error("{by} is in the way on {seat}; put it elsewhere first")]
    SeatCovered {
        /// The seat.
        seat: N,
        /// The thing on the place nearest to the agent.
        by: N,
    },
    /// The node has no place for sitting or lying.
    #[error("{0} has nothing to sit or lie on")]
    NoSeat(N),
    /// The node has fewer seats.
    #[error("{seat} has {count} seats: there is no seat {number}")]
    NoSuchSeat {
        /// The seat.
        seat: N,
        /// The number asked for, counted from 1.
        number: u32,
        /// How many it has.
        count: usize,
    },
    /// Somebody is on that place.
    #[error("{by} sits on seat {number} of {seat}; take another one")]
    PlaceTaken {
        /// The seat.
        seat: N,
        /// The number of the place, counted from 1.
        number: u32,
        /// The agent that is there.
        by: N,
    },
    /// A thing leaves no room for a hand at a side.
    #[error("{by} is at the {side} of {id}, so no hand fits there; take it by another side")]
    SideTaken {
        /// The thing that was to be taken.
        id: N,
        /// The side.
        side: Side,
        /// The thing that is there.
        by: N,
    },
    /// The goal of a guided hand is invalid.
    #[error("a hand of {agent} cannot be guided: {why}")]
    BadGoal {
        /// The agent.
        agent: N,
        /// The fault, and its remedy.
        why: &'static str,
    },
    /// Nothing that could be held is between the fingers and the thumb.
    #[error("{0} has nothing to hold between fingers and thumb; close the grip around something first")]
    NothingBetween(N),
    /// The world refuses the call.
    #[error(transparent)]
    World(#[from] PhysicsError<N>),
}

impl<N> AgentError<N> {
    /// Whether a thing or somebody is in the way: the call may succeed once that has been moved.
    ///
    /// ```
    /// use vc_physics::AgentError;
    /// assert!(AgentError::SeatTaken("sofa.9").is_in_the_way());
    /// assert!(!AgentError::NoSeat("stove.6").is_in_the_way());
    /// ```
    pub fn is_in_the_way(&self) -> bool {
        matches!(
            self,
            Self::Occupied { .. }
                | Self::NoExit(_)
                | Self::SeatTaken(_)
                | Self::SeatCovered { .. }
                | Self::PlaceTaken { .. }
                | Self::SideTaken { .. }
        )
    }
}

impl<N> PhysicsError<N> {
    /// The same error with other names for nodes, such as their labels in a scene.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let cup = scene.add(Draft::new("cup"))?;
    /// let graph = scene.build();
    /// let error = vc_physics::PhysicsError::NoBody(cup).named(&|id| graph.label(id));
    /// assert!(error.to_string().starts_with("cup.1 has no body"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn named<M>(self, name: &impl Fn(N) -> M) -> PhysicsError<M> {
        use PhysicsError as E;
        match self {
            E::BadSettings(why) => E::BadSettings(why),
            E::NoSuchNode(id) => E::NoSuchNode(name(id)),
            E::NoBody(id) => E::NoBody(name(id)),
            E::Duplicate(id) => E::Duplicate(name(id)),
            E::NotFinite(what, id) => E::NotFinite(what, name(id)),
            E::NoSuchPart { id, part, count } => E::NoSuchPart { id: name(id), part, count },
            E::Locked(id) => E::Locked(name(id)),
            E::Overlap { id, other } => E::Overlap { id: name(id), other: name(other) },
            E::NotFree(id) => E::NotFree(name(id)),
            E::NoVehicle(id) => E::NoVehicle(name(id)),
            E::BadVehicle(id, why) => E::BadVehicle(name(id), why),
            E::BadWater(why) => E::BadWater(why),
        }
    }
}

impl<N> AgentError<N> {
    /// The same error with other names for nodes; see [`PhysicsError::named`].
    pub fn named<M>(self, name: &impl Fn(N) -> M) -> AgentError<M> {
        use AgentError as E;
        match self {
            E::NoSuchAgent(id) => E::NoSuchAgent(name(id)),
            E::HandFull { agent, held } => E::HandFull { agent: name(agent), held: name(held) },
            E::HandEmpty(id) => E::HandEmpty(name(id)),
            E::OutOfReach { agent, id, distance, reach } => {
                E::OutOfReach { agent: name(agent), id: name(id), distance, reach }
            }
            E::TooHeavy { id, mass, limit } => E::TooHeavy { id: name(id), mass, limit },
            E::Occupied { seat, by } => E::Occupied { seat: name(seat), by: name(by) },
            E::Held(id) => E::Held(name(id)),
            E::Posture { agent, posture } => E::Posture { agent: name(agent), posture },
            E::NoExit(id) => E::NoExit(name(id)),
            E::SeatTaken(id) => E::SeatTaken(name(id)),
            E::SeatCovered { seat, by } => E::SeatCovered { seat: name(seat), by: name(by) },
            E::NoSeat(id) => E::NoSeat(name(id)),
            E::NoSuchSeat { seat, number, count } => E::NoSuchSeat { seat: name(seat), number, count },
            E::PlaceTaken { seat, number, by } => E::PlaceTaken { seat: name(seat), number, by: name(by) },
            E::SideTaken { id, side, by } => E::SideTaken { id: name(id), side, by: name(by) },
            E::BadGoal { agent, why } => E::BadGoal { agent: name(agent), why },
            E::NothingBetween(id) => E::NothingBetween(name(id)),
            E::World(error) => E::World(error.named(name)),
        }
    }
}

/// The reason why bytes cannot be restored as a snapshot.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The bytes do not begin as a snapshot does.
    #[error("these bytes are not a snapshot of a world")]
    NotASnapshot,
    /// Another version of this crate wrote the bytes.
    #[error("the snapshot has format {found}, this crate reads format {expected}")]
    Version {
        /// The format of the snapshot.
        found: u32,
        /// The format of this crate.
        expected: u32,
    },
    /// The bytes have changed since they were written.
    #[error("the snapshot is damaged: its checksum does not fit")]
    Damaged,
    /// The world could not be written.
    #[error("the world cannot be written as bytes: {0}")]
    Unwritable(String),
    /// The scene graph differs from that of the snapshot.
    #[error("{0} is not in the scene graph, or has another shape than in the snapshot; restore it with its own scene")]
    OtherScene(Label),
}
