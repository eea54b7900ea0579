//! S-expressions that parse print the same again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_tasks::format::sexpr::SexprTree;

fuzz_target!(|text: &str| {
    let Ok(tree) = SexprTree::read("text", text) else { return };
    let again = SexprTree::read("text", &tree.root().to_string()).expect("what is printed reads");
    assert!(again.root().same(tree.root()));
});
