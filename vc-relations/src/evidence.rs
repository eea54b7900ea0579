//! What geometry cannot tell and the caller may: contacts, joints, what is held.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use vc_graph::{Edge, NodeId};

/// One contact between two things, as a physics world reports it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// The two things.
    pub between: (NodeId, NodeId),
    /// Impulse (or force) on the second of them, in world axes, newton seconds; only
    /// ratios between contacts of one thing count.
    pub impulse: Vector3<f32>,
}

/// A thing that a joint holds to another: a door node to its wall, a drawer node to its
/// cabinet. The joint takes the place of a support.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Attachment {
    /// What is held.
    pub child: NodeId,
    /// What holds it.
    pub parent: NodeId,
}

/// Plain data beside the geometry. All of it is optional; without any, relations come
/// from poses and shapes alone, and from what the graph itself says to be held and worn.
///
/// ```
/// use vc_graph::NodeId;
/// use vc_relations::{Attachment, Evidence};
/// let door = Attachment { child: NodeId(7), parent: NodeId(3) };
/// let evidence = Evidence::default().attached(door).positioned(NodeId(3), 0, 0.35);
/// assert_eq!(evidence.attachments.len(), 1);
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Evidence {
    /// Contacts of a physics world, sleeping ones included. A thing that has contacts here
    /// rests on those that push it up, whatever the traces say.
    pub contacts: Vec<Contact>,
    /// What joints hold.
    pub attachments: Vec<Attachment>,
    /// Where the moving parts of an asset are: by node and number of the joint (in the
    /// order in which the asset's parts name different ones), metres or radians. Missing
    /// ones are at zero.
    pub positions: BTreeMap<(NodeId, u32), f32>,
    /// Edges that are so by fiat: holds right or left, worn by. They add to the graph's.
    pub held: Vec<Edge>,
}

impl Evidence {
    /// Adds what a joint holds.
    #[must_use]
    pub fn attached(mut self, attachment: Attachment) -> Self {
        self.attachments.push(attachment);
        self
    }

    /// Adds a contact.
    #[must_use]
    pub fn contact(mut self, contact: Contact) -> Self {
        self.contacts.push(contact);
        self
    }

    /// Sets where a moving part is.
    #[must_use]
    pub fn positioned(mut self, node: NodeId, joint: u32, position: f32) -> Self {
        self.positions.insert((node, joint), position);
        self
    }

    /// Adds something held or worn.
    #[must_use]
    pub fn holding(mut self, edge: Edge) -> Self {
        self.held.push(edge);
        self
    }
}
