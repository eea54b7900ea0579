//! A thesis scene that parses is written, and the result parses. Names with spaces or with words for relations
//! in them do not come back the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::format::thesis;
use vc_graph::{ClassTable, Node, SceneGraph};

fn plain(node: &Node) -> bool {
    let name = node.spec().name.as_deref().unwrap_or_default();
    name.chars().all(|c| c.is_alphanumeric() || c == '_')
}

fn look(graph: &SceneGraph) -> Vec<(u32, String, String)> {
    graph.nodes().map(|n| (n.id().0, n.class().to_string(), n.states().to_string())).collect()
}

fuzz_target!(|text: &str| {
    let classes = ClassTable::builtin();
    let Ok(graph) = thesis::read(text, &classes) else { return };
    let _ = graph.validate();
    let written = thesis::write(&graph);
    if graph.nodes().all(plain) {
        let again = thesis::read(&written, &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
        assert_eq!(look(&again), look(&graph));
        assert!(again.edges().eq(graph.edges()), "{written}");
    }
});
