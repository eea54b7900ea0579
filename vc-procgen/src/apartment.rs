//! An apartment: its floor plan and all items in it.

use vc_graph::{NodeId, Seed};
use vc_shapes::Style;

use crate::item::Item;
use crate::plan::FloorPlan;

/// An apartment: its rooms and all items in them.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Apartment, Support};
/// let home = Apartment::from_seed(Seed(5))?;
/// assert!(home.plan.area() > 15.0);
/// assert!(home.items.iter().any(|item| item.object.class == "fridge" && item.support == Support::Floor));
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Apartment {
    /// The seed that it was generated from.
    pub seed: Seed,
    /// The floor plan: rooms, doors and windows.
    pub plan: FloorPlan,
    /// Its materials.
    pub style: Style,
    /// All items: the building first, then furniture, then clutter. A support or container precedes
    /// the items on or in it.
    pub items: Vec<Item>,
}

impl Apartment {
    /// The node of a room in [`Apartment::scene`].
    pub fn room_id(&self, room: usize) -> NodeId {
        NodeId(room as u32)
    }

    /// The node of an item in [`Apartment::scene`].
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(7))?;
    /// let fridge = home.items.iter().position(|item| item.object.class == "fridge").unwrap_or(0);
    /// assert_eq!(home.scene().label(home.item_id(fridge)).class.as_ref(), "fridge");
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn item_id(&self, item: usize) -> NodeId {
        NodeId((self.plan.rooms.len() + item) as u32)
    }
}
