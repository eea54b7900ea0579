//! Scenes of several regions as one, for questions that are about all of them.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::{ClassTable, Node, NodeId, SceneGraph};

/// The nodes of several scenes, and those that some nodes of other scenes carry, as one scene in which a
/// [goal](crate::Goal) is judged. No relation leads from one scene to another; poses stay those of each region's own frame, and
/// what is carried has none. Classes are those of the first scene. Costs a pointer for each node.
///
/// ```
/// use vc_graph::{Draft, Goal, History, SceneBuilder, goal::Situation, space::gather};
/// let mut scenes = Vec::new();
/// for number in [1, 100] {
///     let mut scene = SceneBuilder::new("flat");
///     scene.number_from(number);
///     let kitchen = scene.add(Draft::new("kitchen"))?;
///     let table = scene.add_in(kitchen, Draft::new("table"))?;
///     scene.add_on(table, Draft::new("cup"))?;
///     scenes.push(scene.build());
/// }
/// let both = gather(&scenes, []);
/// let (me, history) = (vc_graph::NodeId(900), History::default());
/// let goal: Goal = "On(cup, table), 2".parse()?;
/// assert!(goal.holds(&Situation::new(&both, me, &history)));
/// assert!(!goal.holds(&Situation::new(&scenes[0], me, &history)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gather<'a>(
    scenes: impl IntoIterator<Item = &'a SceneGraph>,
    carriers: impl IntoIterator<Item = (&'a SceneGraph, NodeId)>,
) -> SceneGraph {
    let (scenes, carriers): (Vec<_>, Vec<_>) = (scenes.into_iter().collect(), carriers.into_iter().collect());
    let all = || scenes.iter().copied().chain(carriers.iter().map(|(scene, _)| *scene));
    let classes = all().next().map_or_else(ClassTable::builtin, |scene| scene.classes().clone());
    let mut whole = SceneGraph::new("regions", classes);
    let nodes = scenes.iter().flat_map(|scene| scene.nodes.iter());
    nodes.for_each(|node| whole.insert(node.clone()));
    for (scene, carrier) in carriers {
        for node in load(scene, carrier) {
            whole.insert(Arc::new(node));
        }
    }
    whole
}

/// A node and all that it carries, with the relations among these.
fn load(scene: &SceneGraph, carrier: NodeId) -> Vec<Node> {
    let all: BTreeSet<NodeId> = scene.carried_with(carrier).into_iter().collect();
    let alone = |id: &NodeId| {
        let mut node = Node::clone(scene.node(*id)?);
        node.out.retain(|link| all.contains(&link.node()));
        node.inc.retain(|link| all.contains(&link.node()));
        node.pose = None;
        Some(node)
    };
    all.iter().filter_map(alone).collect()
}
