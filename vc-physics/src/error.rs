//! Why something cannot be done.

use vc_graph::NodeId;

/// Why a world refuses.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PhysicsError {
    /// The settings have a figure that cannot be.
    #[error("settings: {0}")]
    BadSettings(&'static str),
    /// The node is not in the scene graph.
    #[error("there is no node {0} in the scene graph")]
    NoSuchNode(NodeId),
    /// The node has no body in this world.
    #[error("{0} has no body; give it a pose and an asset or a box, then insert it")]
    NoBody(NodeId),
    /// The node has a body already.
    #[error("{0} has a body already; move it instead")]
    Duplicate(NodeId),
    /// A number is not finite, a place is more than 1,000 km away, or a rotation is none.
    #[error("{0} of {1} is not finite, or farther than 1,000 km")]
    NotFinite(&'static str, NodeId),
    /// The node has no such moving part.
    #[error("{id} has {count} moving parts, asked for part {part}")]
    NoSuchPart {
        /// Which node.
        id: NodeId,
        /// Which part was asked for.
        part: usize,
        /// How many it has.
        count: usize,
    },
    /// It is locked.
    #[error("{0} is locked; unlock it first")]
    Locked(NodeId),
    /// The node has no such surface.
    #[error("{id} has {count} surfaces, asked for surface {surface}")]
    NoSuchSurface {
        /// Which node.
        id: NodeId,
        /// Which surface was asked for.
        surface: usize,
        /// How many it has.
        count: usize,
    },
    /// It would be inside something else.
    #[error("{id} would be inside {other}; ask for a free spot")]
    Overlap {
        /// What was to be put.
        id: NodeId,
        /// What is there already.
        other: NodeId,
    },
    /// The body does not move by itself or by a push.
    #[error("{0} does not move: it is fixed, held, an agent or stopped")]
    NotFree(NodeId),
    /// A vehicle cannot be like that.
    #[error("vehicle {0}: {1}")]
    BadVehicle(NodeId, &'static str),
    /// Water cannot be like that.
    #[error("water: {0}")]
    BadWater(&'static str),
}

/// Why an agent cannot do something with its body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AgentError {
    /// The node is no agent of this world.
    #[error("{0} is not an agent of this world")]
    NoSuchAgent(NodeId),
    /// The hand holds something.
    #[error("the hand of {agent} holds {held}; put it down first")]
    HandFull {
        /// Whose hand.
        agent: NodeId,
        /// What it holds.
        held: NodeId,
    },
    /// The hand holds nothing.
    #[error("the hand of {0} holds nothing")]
    HandEmpty(NodeId),
    /// Too far away.
    #[error("{id} is {distance:.2} m from the shoulder of {agent}, its reach is {reach:.2} m")]
    OutOfReach {
        /// Whose reach.
        agent: NodeId,
        /// What is too far.
        id: NodeId,
        /// How far, metres.
        distance: f32,
        /// How far the agent reaches, metres.
        reach: f32,
    },
    /// Too heavy to carry.
    #[error("{id} has {mass:.1} kg, an agent carries {limit:.1} kg")]
    TooHeavy {
        /// What.
        id: NodeId,
        /// Its mass, kilograms.
        mass: f32,
        /// The limit, kilograms.
        limit: f32,
    },
    /// Somebody sits or lies on it.
    #[error("{by} is on {seat}; one does not carry that off")]
    Occupied {
        /// What was to be taken.
        seat: NodeId,
        /// Who is on it.
        by: NodeId,
    },
    /// Somebody holds it already.
    #[error("{0} is held already")]
    Held(NodeId),
    /// The agent stands where it should not, or sits where it should stand.
    #[error("{agent} is {posture}")]
    Posture {
        /// Which agent.
        agent: NodeId,
        /// What it does instead: standing, sitting, lying.
        posture: &'static str,
    },
    /// No free place beside the seat to get up to.
    #[error("nowhere to get up to beside {0}")]
    NoExit(NodeId),
    /// The seat has no free place.
    #[error("every place on {0} is taken")]
    SeatTaken(NodeId),
    /// Something stands on the free places of the seat.
    #[error("{by} is in the way on {seat}; put it elsewhere first")]
    SeatCovered {
        /// What one was to sit or lie on.
        seat: NodeId,
        /// What is there, on the place nearest to the agent.
        by: NodeId,
    },
    /// Nothing one could sit or lie on.
    #[error("{0} has nothing to sit or lie on")]
    NoSeat(NodeId),
    /// No way leads there.
    #[error("no way leads {agent} there")]
    NoWay {
        /// Which agent.
        agent: NodeId,
    },
    /// The world refuses.
    #[error(transparent)]
    World(#[from] PhysicsError),
}

/// Why bytes are no snapshot.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The bytes do not begin as a snapshot does.
    #[error("these bytes are not a snapshot of a world")]
    NotASnapshot,
    /// Another version of this crate wrote them.
    #[error("the snapshot has format {found}, this crate reads format {expected}")]
    Version {
        /// Of the snapshot.
        found: u32,
        /// Of this crate.
        expected: u32,
    },
    /// The bytes have changed since they were written.
    #[error("the snapshot is damaged: its checksum does not fit")]
    Damaged,
    /// The world could not be written.
    #[error("the world cannot be written as bytes: {0}")]
    Unwritable(String),
    /// The scene graph is not the one the snapshot is of.
    #[error("the scene graph has no node {0}, or it has another shape there, than the snapshot")]
    OtherScene(NodeId),
}
