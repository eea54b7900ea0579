//! Changes that are read and fit a scene can be undone.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::format::native;
use vc_graph::{ClassTable, Draft, SceneBuilder};

fuzz_target!(|text: &str| {
    let Ok(changes) = native::read_changes(text, &ClassTable::builtin()) else { return };
    let mut scene = SceneBuilder::new("flat");
    if let Ok(kitchen) = scene.add(Draft::new("kitchen")) {
        for class in ["fridge", "cup", "character"] {
            let _ = scene.add_in(kitchen, Draft::new(class));
        }
    }
    let (before, mut graph) = (scene.graph().clone(), scene.build());
    if changes.apply(&mut graph).is_ok() {
        assert!(changes.undo(&mut graph).is_ok());
    }
    assert!(graph == before);
});
