//! Reads a scene in any format, recognised by its structure; a scene that parses is written in the native
//! format and in VirtualHome's, and both parse back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::ClassTable;
use vc_graph::format::{native, read_scene, virtualhome};

fuzz_target!(|text: &str| {
    let classes = ClassTable::builtin();
    let Ok(graph) = read_scene(text, &classes) else { return };
    let written = native::write(&graph);
    let again = native::read(&written, &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert!(again == graph, "{written}");
    assert!(read_scene(&written, &classes) == Ok(again), "{written}");
    let written = virtualhome::write(&graph);
    virtualhome::read(&written, &classes).unwrap_or_else(|e| panic!("{e}\n{written}"));
});
