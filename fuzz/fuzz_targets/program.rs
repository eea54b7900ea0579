//! A program that reads is written and reads back equal.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::format::program;
use vc_graph::{ClassTable, SceneGraph};

fuzz_target!(|text: &str| {
    let Ok(read) = program::read(text) else { return };
    let nothing = SceneGraph::new("nothing", ClassTable::builtin());
    let Ok(written) = program::write(&read, &nothing) else { return };
    assert_eq!(program::read(&written).as_ref(), Ok(&read), "{written}");
});
