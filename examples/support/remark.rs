//! A remark on scenes without walls.

use virtualcity::graph::SceneGraph;

use crate::support::say;

/// Says that a scene has no walls: its pictures show it in the open.
pub(crate) fn on_walls(graph: &SceneGraph) {
    if graph.of_class("wall").is_empty() && !graph.rooms().is_empty() {
        say!("remark {} gives no walls: its rooms are drawn in the open", graph.name());
    }
}
