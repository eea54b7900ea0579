//! Observations as they are recorded.

use serde_json::{Value, json};
use vc_graph::{NodeKind, Observation};

/// An observation as JSON: `{"agent": "character.3", "room": "kitchen.1", "things": [["cup.4", "CLEAN"]],
/// "relations": [["cup.4", "ON", "table.2"]]}`.
pub(crate) fn as_json(seen: &Observation) -> Value {
    let label = |id| seen.get(id).map(|n| n.label().to_string());
    let things = seen.nodes().filter(|n| n.kind() == NodeKind::Object).map(|node| {
        let states = node.states().iter().map(|s| s.to_string().into());
        Value::Array(std::iter::once(node.label().to_string().into()).chain(states).collect())
    });
    let relations =
        seen.relations().filter_map(|e| Some(json!([label(e.from)?, e.relation.to_string(), label(e.to)?])));
    json!({
        "agent": label(seen.agent()),
        "room": seen.room().and_then(label),
        "things": things.collect::<Vec<_>>(),
        "relations": relations.collect::<Vec<_>>(),
    })
}
