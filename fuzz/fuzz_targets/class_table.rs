//! A class table that parses finds all its classes by name.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::ClassTable;

/// Classes for a text to refer to.
const BASE: &str = "kitchen | | | room | | 3 3 2.5 | | | |\nfurniture | | | group | | | | | |\n";

fuzz_target!(|text: &str| {
    let _ = ClassTable::builtin().get(text);
    let Ok(table) = ClassTable::parse("base", BASE).and_then(|base| base.extended("mine", text)) else { return };
    for class in table.iter() {
        assert_eq!(table.get(&class.name).map(|c| &c.name), Some(&class.name));
        assert!(table.kinds_of(class).any(|kind| kind.name == class.name));
        assert!(class.parents.iter().all(|parent| table.is_a(&class.name, parent)));
    }
});
