//! Named degrees of nearness between two things.

use vc_graph::NodeId;

use crate::near;
use crate::relations::Relations;
use crate::threshold::{ARMS_REACH, NEAR_REACH, TOUCHING_DISTANCE};

/// Degree of nearness between two things, by the distance of their boxes and by the walls in between.
///
/// The relation [`Near`](vc_graph::Relation::Near) holds for the first three, and for [`Proximity::BehindWall`]
/// if both are in one room.
///
/// ```
/// # let home = vc_testkit::kitchen::kitchen();
/// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
/// use vc_relations::Proximity;
/// assert!(relations.proximity(home.cup, home.table) < relations.proximity(home.cup, home.cabinet));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Proximity {
    /// Touching distance: at most [`TOUCHING_DISTANCE`](crate::threshold::TOUCHING_DISTANCE) apart, or in contact.
    TouchingDistance,
    /// Within arm's reach: at most [`ARMS_REACH`](crate::threshold::ARMS_REACH) apart.
    ArmsReach,
    /// At most [`NEAR_REACH`](crate::threshold::NEAR_REACH) apart: a step and an arm.
    Near,
    /// Equally near, but part of the building is between their centres, whether they are in one room or in two.
    BehindWall,
    /// Farther apart.
    Far,
}

impl Relations {
    /// The degree of nearness between two things; `None` if one is not in the scene, has no pose or no shape,
    /// or is part of the building. Costs a microsecond and a search of the walls in between.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_relations::{Evidence, Proximity, Relations, RelationRule};
    /// let mut scene = SceneBuilder::new("shelf");
    /// let size = Bounds::standing([0.1, 0.1, 0.1].into());
    /// let mut cup = |x| scene.add(Draft::new("cup").bounds(size).at(Pose::translation(x, 0.0, 0.0)));
    /// let cups = [cup(0.0)?, cup(0.14)?, cup(0.6)?, cup(1.0)?, cup(3.0)?];
    /// let relations = Relations::new(&scene.build(), RelationRule::Contacts, Evidence::default())?;
    /// let to = |other| relations.proximity(cups[0], other);
    /// assert_eq!(to(cups[1]), Some(Proximity::TouchingDistance));
    /// assert_eq!(to(cups[2]), Some(Proximity::ArmsReach));
    /// assert_eq!(to(cups[3]), Some(Proximity::Near));
    /// assert_eq!(to(cups[4]), Some(Proximity::Far));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn proximity(&self, a: NodeId, b: NodeId) -> Option<Proximity> {
        let body = |id| self.world.index(id).and_then(|index| self.world.bodies[index].as_deref());
        let (a, b) = (body(a)?, body(b)?);
        if a.traits.structure || b.traits.structure {
            return None;
        }
        let Some(beside) = near::beside(a, b) else { return Some(Proximity::Far) };
        Some(match beside.distance {
            _ if self.world.walls.is_between(a, b) => Proximity::BehindWall,
            distance if distance <= TOUCHING_DISTANCE => Proximity::TouchingDistance,
            distance if distance <= ARMS_REACH => Proximity::ArmsReach,
            distance if distance <= NEAR_REACH => Proximity::Near,
            _ => Proximity::Far,
        })
    }
}
