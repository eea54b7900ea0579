//! S-expressions that parse print the same again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_tasks::format::sexpr::Tree;

fuzz_target!(|text: &str| {
    let Ok(tree) = Tree::read("text", text) else { return };
    let again = Tree::read("text", &tree.root().to_string()).expect("what is printed reads");
    assert!(again.root().same(tree.root()));
});
