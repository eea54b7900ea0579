//! A VirtualHome graph that parses is written, and the result keeps its nodes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::format::virtualhome;
use vc_graph::{ClassTable, Node};

fuzz_target!(|text: &str| {
    let classes = ClassTable::builtin();
    let Ok(graph) = virtualhome::read(text, &classes) else { return };
    let _ = graph.validate();
    let written = virtualhome::write(&graph);
    let once = virtualhome::read(&written, &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert!(once.nodes().map(Node::label).eq(graph.nodes().map(Node::label)), "{written}");
    let again = virtualhome::read(&virtualhome::write(&once), &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert!(again.edges().eq(once.edges()), "{written}");
    let states = |n: &Node| n.states();
    assert!(again.nodes().map(states).eq(once.nodes().map(states)), "{written}");
});
