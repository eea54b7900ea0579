//! An action or label that parses is printed and parses back equal.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::{Action, ClassTable, Label, SceneGraph};

fuzz_target!(|text: &str| {
    if let Ok(action) = text.parse::<Action>() {
        assert_eq!(action.to_string().parse(), Ok(action));
        let nothing = SceneGraph::new("nothing", ClassTable::builtin());
        if let Ok(notation) = action.to_virtualhome(&nothing) {
            assert_eq!(notation.parse(), Ok(action), "{notation}");
        }
    }
    if let Ok(label) = text.parse::<Label>() {
        assert_eq!(label.to_string().parse(), Ok(label));
    }
});
