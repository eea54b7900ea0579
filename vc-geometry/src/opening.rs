//! Openings in walls, found from doors, their frames and windows, and passages without them.

use vc_graph::{Aabb, Node, NodeId, ObjectRole, Relation, SceneGraph};

/// Height of a doorway at least, metres: boxes of doors may end at their handles.
pub(crate) const DOORWAY: f32 = 2.0;
/// A box whose shorter side is at least this part of the longer one does not tell which way it leads.
const SQUARE: f32 = 0.5;

/// An opening in the walls.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct WallOpening {
    /// The door, frame or window in it; for a passage, the wall of the first of its rooms.
    pub door: NodeId,
    /// The space that is clear, or filled by that node, metres.
    pub clear: Aabb,
    /// The axis of the world along which one goes or looks through: 0 is X, 1 is Y.
    pub across: usize,
    /// The rooms that the graph has it between.
    pub rooms: Vec<NodeId>,
    /// Whether one can walk through.
    pub is_doorway: bool,
}

/// The openings of a scene's doors, door frames and windows, by number of the node, and then its [`passages`].
///
/// A door's box may be around a leaf that stands open, and may end at its handle. So a doorway is at
/// least two metres high, and leads the way in which the frame, or the wall, at the same place is thin.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// let mut scene = SceneBuilder::new("hall");
/// let door = Draft::new("door").bounds(Bounds::standing([0.1, 0.9, 2.1].into())).at(Pose::identity());
/// let door = scene.add(door)?;
/// let openings = vc_geometry::openings(&scene.build());
/// assert_eq!((openings[0].door, openings[0].across, openings[0].is_doorway), (door, 0, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn openings(graph: &SceneGraph) -> Vec<WallOpening> {
    let mut openings = filled(graph);
    openings.extend(crate::passage::passages(graph, &openings));
    openings
}

/// The passages of a scene of boxes: holes in walls between rooms that no door, frame or other passage connects.
///
/// A box has no hole, so such a passage is a guess: it is in the widest stretch of the walls between the two rooms
/// before which nothing stands, at most 1.4 m wide and two metres high. Walls that have a shape are left as they
/// are. Costs time that grows with the square of the number of walls, and only if rooms are cut off.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// let mut scene = SceneBuilder::new("two rooms");
/// let (mut rooms, size) = (Vec::new(), |x: f32, y: f32, z: f32| Bounds::standing([x, y, z].into()));
/// for (name, middle, wall) in [("kitchen", -2.0, -0.05), ("bedroom", 2.0, 0.05)] {
///     let room = scene.add(Draft::new(name))?;
///     for (class, at, size) in [("floor", middle, size(4.0, 4.0, 0.01)), ("wall", wall, size(0.1, 4.0, 2.5))] {
///         scene.add_in(room, Draft::new(class).bounds(size).at(Pose::translation(at, 0.0, 0.0)))?;
///     }
///     rooms.push(room);
/// }
/// let passages = vc_geometry::passages(&scene.build());
/// assert_eq!(passages.len(), 1);
/// assert_eq!(passages[0].rooms, rooms);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn passages(graph: &SceneGraph) -> Vec<WallOpening> {
    crate::passage::passages(graph, &filled(graph))
}

/// The openings with a door, frame or window in them.
fn filled(graph: &SceneGraph) -> Vec<WallOpening> {
    graph.nodes().filter(|n| n.role().is_opening()).filter_map(|n| opening(graph, n)).collect()
}

fn opening(graph: &SceneGraph, node: &Node) -> Option<WallOpening> {
    let is_doorway = node.role() != ObjectRole::Window;
    let mut clear = node.aabb()?;
    if is_doorway {
        clear.max.z = clear.max.z.max(clear.min.z + DOORWAY);
    }
    let rooms = graph.related(node.id(), Relation::Between).collect();
    Some(WallOpening { door: node.id(), clear, across: across(graph, node, &clear), rooms, is_doorway })
}

/// The axis across an opening: that along which its own box is thin, or the frame's or wall's it is in.
fn across(graph: &SceneGraph, node: &Node, clear: &Aabb) -> usize {
    if let Some(axis) = thin(clear) {
        return axis;
    }
    let of = |role: ObjectRole| {
        let meets = |other: &Node| {
            let aabb = other.aabb().filter(|_| other.id() != node.id())?;
            thin(&aabb).filter(|_| overlap(&aabb, clear))
        };
        graph.of_role(role).find_map(meets)
    };
    of(ObjectRole::DoorFrame)
        .or_else(|| of(ObjectRole::Wall))
        .unwrap_or_else(|| usize::from(size(clear, 1) < size(clear, 0)))
}

/// The axis along which a box is thin.
pub(crate) fn thin(aabb: &Aabb) -> Option<usize> {
    let (x, y) = (size(aabb, 0), size(aabb, 1));
    if x < SQUARE * y { Some(0) } else { (y < SQUARE * x).then_some(1) }
}

pub(crate) fn size(aabb: &Aabb, axis: usize) -> f32 {
    aabb.max[axis] - aabb.min[axis]
}

/// Whether two boxes share some room.
pub(crate) fn overlap(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] < b.max[i] && b.min[i] < a.max[i])
}

#[cfg(test)]
mod tests {
    use vc_graph::{Bounds, Draft, EditError, Pose, SceneBuilder};

    use super::*;

    /// A door whose box is around its open leaf leads the way in which the wall is thin, and is as
    /// high as a person.
    #[test]
    fn doors_lead_through_walls() -> Result<(), EditError> {
        let mut scene = SceneBuilder::new("two rooms");
        let size = |x: f32, y: f32, z: f32| Bounds::standing([x, y, z].into());
        scene.add(Draft::new("wall").bounds(size(0.1, 4.0, 2.5)).at(Pose::identity()))?;
        let door = scene.add(Draft::new("door").bounds(size(0.9, 0.9, 1.0)).at(Pose::identity()))?;
        scene.add(Draft::new("window").bounds(size(0.1, 1.0, 1.0)).at(Pose::translation(0.0, 1.5, 1.0)))?;
        let found = openings(&scene.build());
        assert_eq!((found.len(), found[0].door, found[0].across), (2, door, 0));
        assert!(found[0].is_doorway && found[0].clear.max.z >= 2.0 && !found[1].is_doorway);
        Ok(())
    }
}
