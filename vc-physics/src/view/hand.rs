//! Reading a guided hand.

use vc_graph::{NodeId, Pose};

use super::AgentView;
use crate::AgentError;
use crate::state::{Hand, HandGoal};

/// A hand that [`guide_hand`](crate::PhysicsWorld::guide_hand) guides, as it is now. Nodes in `between` and `holds` come with
/// the number of a moving part where it is that: `(fridge, Some(0))` is the first door of a fridge by its handle,
/// `(cup, None)` a cup.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GuidedHand {
    /// Its goal.
    pub goal: HandGoal,
    /// The pose of the point between fingers and thumb in the world's frame, as in [`HandGoal::pose`].
    pub pose: Pose,
    /// Distance of the fingers from the thumb, 0 to 0.1 m.
    pub opening: f32,
    /// The nodes that it touches or is about to, sorted by number.
    pub touches: Vec<NodeId>,
    /// The node between fingers and thumb, which close around it no further; [`grasp`](crate::PhysicsWorld::grasp) holds
    /// it.
    pub between: Option<(NodeId, Option<usize>)>,
    /// The reason for which `grasp` would not hold that: it is too heavy, locked, or somebody sits on it.
    pub fault: Option<AgentError>,
    /// The node that it holds: a thing, with `None`, or a moving part by its handle, with the part's number as in
    /// [`parts`](crate::PhysicsWorld::parts).
    pub holds: Option<(NodeId, Option<usize>)>,
}

impl AgentView<'_> {
    /// A hand that is guided; `None` for one that is not. Costs some microseconds.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::{Hand, HandGoal};
    /// world.guide_hand(home.person, Hand::Left, HandGoal::default())?;
    /// world.run(60);
    /// let person = world.agent(home.person)?;
    /// let hand = person.guided(Hand::Left).ok_or("not guided")?;
    /// assert!((hand.pose.translation.z - 1.2).abs() < 0.01 && (hand.opening - 0.1).abs() < 0.001);
    /// assert_eq!(person.guided(Hand::Right), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn guided(&self, hand: Hand) -> Option<GuidedHand> {
        let (world, id) = (self.world, self.id);
        let effector = world.effectors.get(&(id, hand))?;
        let touched = world.pairs_of(effector.body).filter(|pair| pair.has_any_active_contact());
        let nodes = touched.flat_map(|pair| [pair.collider1, pair.collider2]).filter_map(|c| world.node_of(c));
        let mut touches: Vec<NodeId> = nodes.filter(|node| *node != id).collect();
        touches.sort_unstable();
        touches.dedup();
        let between = world.between(id, hand);
        let part = |(id, link): (NodeId, usize)| (id, link.checked_sub(1));
        Some(GuidedHand {
            goal: effector.goal,
            pose: world.engine.pose(effector.body)?,
            opening: effector.opening(),
            touches,
            between: between.map(part),
            fault: between.and_then(|between| world.grasp_fault(id, hand, between)),
            holds: effector.grasp.map(|grasp| part((grasp.id, grasp.link))),
        })
    }
}
