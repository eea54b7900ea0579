//! Uses of a node that follow from several of its affordances: what can be put on it, in it, taken along.

use super::Node;
use crate::class::SlotKind;
use crate::{ClassTable, Property};

impl Node {
    fn affords_any(&self, properties: &[Property]) -> bool {
        properties.iter().any(|property| self.affords(*property))
    }

    /// Whether a person can pick it up. Water is scooped up with the hands, since VirtualHome's programs grab it.
    pub fn is_graspable(&self) -> bool {
        &**self.class() == "water" || self.affords(Property::Graspable)
    }

    /// Whether things may rest on it: on surfaces, on seats and beds, on the lid or the rim of a container, on heaters,
    /// and on books.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// for (class, carries, encloses) in [("table", true, false), ("bowl", true, true), ("apple", false, false)] {
    ///     let id = scene.add(Draft::new(class))?;
    ///     let graph = scene.graph();
    ///     let node = graph.node(id).ok_or("gone")?;
    ///     assert_eq!((node.carries(), node.encloses(graph.classes())), (carries, encloses), "{class}");
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn carries(&self) -> bool {
        self.affords_any(Property::CARRYING) || self.is_leaves()
    }

    /// Whether things may be in it: the author or the class table says that it is a container, a vessel or a vehicle. A
    /// node of a class that is not in the table counts as a container if it opens; known classes that open may be doors
    /// or books.
    pub fn encloses(&self, classes: &ClassTable) -> bool {
        self.affords_any(&[Property::Container, Property::Recipient, Property::Drivable])
            || (self.affords(Property::Openable) && classes.get(self.class()).is_none())
    }

    /// Whether liquids can be poured into it or onto it.
    pub fn receives_liquids(&self) -> bool {
        self.affords(Property::Recipient) || self.soaks()
    }

    /// The number of agents that can sit or lie on it at once: its places of a kind, and one if none are given.
    ///
    /// ```
    /// use vc_graph::class::SlotKind;
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let sofa = scene.add(Draft::new("sofa"))?;
    /// assert_eq!(scene.graph().node(sofa).map(|sofa| sofa.capacity(SlotKind::Seat)), Some(3));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn capacity(&self, kind: SlotKind) -> u32 {
        self.slots(kind).max(1)
    }

    /// Whether it is a book, a magazine or a sheet of paper: a flat object of no larger size can lie on it.
    pub(crate) fn is_leaves(&self) -> bool {
        [Property::Readable, Property::Paper, Property::Graspable].into_iter().all(|p| self.affords(p))
    }

    /// Whether it absorbs liquids poured on it: a sponge, hands.
    pub(crate) fn soaks(&self) -> bool {
        self.affords_any(&[Property::Wiper, Property::BodyPart])
    }
}
