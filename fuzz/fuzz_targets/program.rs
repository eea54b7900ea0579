//! A program that parses is written and parses back equal, except for the labels of its objects.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::format::program::{self, Program};
use vc_graph::{Action, ClassTable, SceneGraph};

/// The title, and each action with its character.
fn said(program: &Program) -> (&[String], Vec<Vec<(u32, Action)>>) {
    let steps = program.steps.iter().map(|step| step.iter().map(|parsed| (parsed.character, parsed.action)).collect());
    (&program.heading, steps.collect())
}

fuzz_target!(|text: &str| {
    let Ok(read) = program::read(text) else { return };
    let nothing = SceneGraph::new("nothing", ClassTable::builtin());
    let _ = read.cast(&nothing);
    let Ok(written) = program::write(&read, &nothing) else { return };
    let again = program::read(&written).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert_eq!(said(&again), said(&read), "{written}");
});
