//! The built-in class table, and tables of one's own.

use vc_graph::{ClassTable, Property, Relation};

#[test]
fn builtin_text_is_well_formed() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/classes");
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    names.sort();
    let all: String = names.iter().map(|p| std::fs::read_to_string(p).unwrap() + "\n").collect();
    let table =
        ClassTable::parse("all", &all).unwrap_or_else(|e| panic!("{e}\n{}", all.lines().nth(e.line - 1).unwrap()));
    assert_eq!(table.len(), ClassTable::builtin().len());
}
