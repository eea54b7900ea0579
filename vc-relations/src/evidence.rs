//! Evidence: facts that geometry cannot provide but the caller may, about contacts, joints and held things.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector3;
use vc_graph::{Edge, NodeId};

/// A contact between two things, as reported by a physics engine.
///
/// ```
/// # let home = vc_testkit::kitchen::kitchen();
/// use vc_relations::{ContactEvidence, Evidence, Relations, SupportKind};
/// let up = nalgebra::Vector3::new(0.0, 0.0, 0.05); // Newton seconds, on the cup.
/// let evidence = Evidence::default().contact(ContactEvidence { between: (home.table, home.cup), impulse: up });
/// let relations = Relations::new(&home.graph, Default::default(), evidence)?;
/// assert_eq!(relations.supports(home.cup)[0].kind, SupportKind::Contact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEvidence {
    /// The two things.
    pub between: (NodeId, NodeId),
    /// Impulse (or force) on the second thing, in world axes, newton seconds; only the ratios between contacts
    /// of one thing matter.
    pub impulse: Vector3<f32>,
}

/// A joint that attaches one thing to another: a door node to its wall, a drawer node to its cabinet. The joint
/// takes the place of a support.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Attachment {
    /// The attached thing.
    pub child: NodeId,
    /// The thing that it is attached to.
    pub parent: NodeId,
}

/// Plain data beside the geometry. All of it is optional: without any, relations are read only from poses and
/// shapes, and from the graph's own edges of holding and wearing.
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
    /// Contacts of a physics engine, sleeping ones included. A thing that has contacts here rests on those that
    /// push it up, regardless of the traces.
    pub contacts: Vec<ContactEvidence>,
    /// Attachments by joints.
    pub attachments: Vec<Attachment>,
    /// Positions of joints within assets, by node and joint number (in the order in which the asset's parts
    /// first use different joints), metres or radians. Missing ones are zero.
    pub positions: BTreeMap<(NodeId, u32), f32>,
    /// Given edges: held in the right or left hand, worn by. They are added to the graph's.
    pub held: Vec<Edge>,
    /// Everything that moves with somebody's hands: the things in them, and the things that rest on or in those.
    /// If it is given, nothing else rests on any of them: a held bottle that brushes the coffee maker does not
    /// carry it.
    pub carried: Option<BTreeSet<NodeId>>,
}

impl Evidence {
    /// Adds an attachment by a joint.
    #[must_use]
    pub fn attached(mut self, attachment: Attachment) -> Self {
        self.attachments.push(attachment);
        self
    }

    /// Adds a contact.
    #[must_use]
    pub fn contact(mut self, contact: ContactEvidence) -> Self {
        self.contacts.push(contact);
        self
    }

    /// Sets the position of a joint.
    #[must_use]
    pub fn positioned(mut self, node: NodeId, joint: u32, position: f32) -> Self {
        self.positions.insert((node, joint), position);
        self
    }

    /// Sets everything that moves with somebody's hands.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// let evidence = vc_relations::Evidence::default().carrying([home.table]);
    /// let relations = vc_relations::Relations::new(&home.graph, Default::default(), evidence)?;
    /// // Hands carry the table. The cup is not said to be carried, so it does not rest on the table.
    /// assert!(relations.supports(home.cup).iter().all(|support| support.by != home.table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn carrying(self, carried: impl IntoIterator<Item = NodeId>) -> Self {
        Self { carried: Some(carried.into_iter().collect()), ..self }
    }

    /// Adds an edge of holding or wearing.
    #[must_use]
    pub fn holding(mut self, edge: Edge) -> Self {
        self.held.push(edge);
        self
    }
}

/// The evidence about one node as a physics engine has it now: it takes the place of what was known of that node.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeEvidence {
    /// The node.
    pub node: NodeId,
    /// Positions of its joints by number, metres or radians; those that are left out are zero.
    pub positions: Vec<f32>,
    /// Whether it moves with somebody's hands. It counts only where [`Evidence::carried`] is given.
    pub is_carried: bool,
}

/// All that evidence says of one node: the joints that are named, with their positions, and whether hands carry it.
#[derive(Debug)]
pub(crate) struct Known {
    pub(crate) node: NodeId,
    positions: Vec<(u32, f32)>,
    is_carried: bool,
}

impl From<&NodeEvidence> for Known {
    fn from(said: &NodeEvidence) -> Self {
        let positions = (0..).zip(said.positions.iter().copied()).filter(|(_, position)| *position != 0.0).collect();
        Self { node: said.node, positions, is_carried: said.is_carried }
    }
}

impl Known {
    /// Whether two say the same: a joint that is not named is at zero.
    fn says(&self, other: &Self) -> bool {
        let moved = |known: &Self| known.positions.iter().copied().filter(|(_, at)| *at != 0.0).collect::<Vec<_>>();
        moved(self) == moved(other) && self.is_carried == other.is_carried
    }
}

impl Evidence {
    /// All that is said of one node.
    pub(crate) fn of(&self, node: NodeId) -> Known {
        let positions = self.positions.range((node, 0)..=(node, u32::MAX)).map(|((_, joint), at)| (*joint, *at));
        let is_carried = self.carried.as_ref().is_some_and(|all| all.contains(&node));
        Known { node, positions: positions.collect(), is_carried }
    }

    /// Says something else of one node; whether it is something new.
    pub(crate) fn say(&mut self, now: &Known) -> bool {
        let (node, before) = (now.node, self.of(now.node));
        for (joint, _) in &before.positions {
            self.positions.remove(&(node, *joint));
        }
        self.positions.extend(now.positions.iter().map(|(joint, at)| ((node, *joint), *at)));
        if let Some(carried) = &mut self.carried {
            if now.is_carried {
                carried.insert(node)
            } else {
                carried.remove(&node)
            };
        }
        !self.of(node).says(&before)
    }
}
