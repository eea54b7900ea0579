//! A native scene that parses is written and parses back equal.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::ClassTable;
use vc_graph::format::native;

fuzz_target!(|text: &str| {
    let classes = ClassTable::builtin();
    let Ok(graph) = native::read(text, &classes) else { return };
    let _ = graph.validate();
    let written = native::write(&graph);
    let again = native::read(&written, &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert!(again == graph, "{written}");
    assert_eq!(native::write(&again), written);
    assert_eq!(again.digest(), graph.digest());
});
