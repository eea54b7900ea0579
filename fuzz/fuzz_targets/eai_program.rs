//! A record of the Embodied Agent Interface that parses gives scenes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::ClassTable;
use vc_graph::format::{eai, virtualhome::EnvironmentGraph};

fuzz_target!(|text: &str| {
    let Ok(record) = eai::read_record(text) else { return };
    for graph in [&record.initial, &record.last] {
        let Ok(scene) = graph.build("EAI", &ClassTable::builtin()) else { continue };
        let _ = scene.validate();
        assert_eq!(EnvironmentGraph::from_scene(&scene).nodes.len(), graph.nodes.len());
    }
    for action in record.program.actions() {
        assert_eq!(action.to_string().parse(), Ok(action));
    }
});
