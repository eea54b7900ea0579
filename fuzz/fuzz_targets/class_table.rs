//! A class table that reads knows all its classes by name.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::ClassTable;

fuzz_target!(|text: &str| {
    let _ = ClassTable::builtin().get(text);
    let _ = ClassTable::builtin().extended("more", text);
    let Ok(table) = ClassTable::parse("mine", text) else { return };
    for class in table.iter() {
        assert_eq!(table.get(&class.name).map(|c| &c.name), Some(&class.name));
        assert!(table.kinds_of(class).any(|kind| kind.name == class.name));
        assert!(class.parents.iter().all(|parent| table.is_a(&class.name, parent)));
    }
});
