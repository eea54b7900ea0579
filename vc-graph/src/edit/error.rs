//! The reasons why edits are refused.

use crate::{Label, NodeId, Relation};

/// The reason why an edit was refused; the graph is as it was before that call.
///
/// ```
/// use vc_graph::{Draft, Place, Relation, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let mut graph = scene.build();
/// let onto_itself = Place { relation: Relation::On, at: apple };
/// let error = graph.edit().place(apple, onto_itself).unwrap_err();
/// assert_eq!(error.to_string(), "apple.3 cannot rest at apple.3: apple.3 itself rests on or in apple.3");
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, serde::Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum EditError {
    /// There is no such node.
    #[error("there is no node {0} in this scene")]
    NoSuchNode(NodeId),
    /// A node number is taken.
    #[error("node {0} exists already; give the new node another number")]
    Duplicate(NodeId),
    /// The last node number has been used.
    #[error("all node numbers are used up")]
    NumbersExhausted,
    /// An object would rest on itself.
    #[error("{thing} cannot rest at {at}: {at} itself rests on or in {thing}")]
    SupportCycle {
        /// The object to be placed.
        thing: Label,
        /// The place.
        at: Label,
    },
    /// A node is of the wrong kind for its role.
    #[error("{node} is no {needed}")]
    WrongKind {
        /// The node.
        node: Label,
        /// The kind it should have been.
        needed: &'static str,
    },
    /// The agent's hands are full.
    #[error("{agent} has no free hand")]
    HandsFull {
        /// The agent.
        agent: Label,
    },
    /// A relation that gives a location cannot be set directly.
    #[error("`{0}` gives an object's location; use `place`, `hold` or `move_to_room`")]
    NotFree(Relation),
    /// A relation that is none of the hands'.
    #[error("`{0}` is no hand; use `holds_right` or `holds_left`")]
    NotAHand(Relation),
    /// A relation that does not give a location.
    #[error("`{0}` gives no support, container or wearer; use `relate`, `hold` or `move_to_room`")]
    NotAPlace(Relation),
    /// A room can be removed only when it is empty.
    #[error("{room} still contains {count} nodes, {first} among them; move or remove them first")]
    RoomNotEmpty {
        /// The room.
        room: Label,
        /// How many nodes are in it.
        count: usize,
        /// One of them.
        first: Label,
    },
    /// A pose has values that are not finite.
    #[error("the pose of {0} is not finite")]
    NotFinite(Label),
}
