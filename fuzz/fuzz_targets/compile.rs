//! A goal that parses is compiled for a small home: its program holds if the goal does, its credit is then one,
//! and satisfying the unmet parts makes it hold.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::goal::Situation;
use vc_graph::{Draft, EditError, Goal, History, NodeId, SceneBuilder, SceneGraph};
use vc_tasks::compile::{Compiler, Monitor};

fn home() -> Result<(SceneGraph, NodeId), EditError> {
    let mut scene = SceneBuilder::new("home");
    let kitchen = scene.add(Draft::new("kitchen"))?;
    let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    for class in ["plate", "plate", "cup"] {
        scene.add_on(table, Draft::new(class))?;
    }
    scene.add_in(kitchen, Draft::new("fridge"))?;
    let me = scene.add_in(kitchen, Draft::new("character"))?;
    Ok((scene.build(), me))
}

fuzz_target!(|text: &str| {
    let (Ok(goal), Ok((graph, me))) = (text.parse::<Goal>(), home()) else { return };
    let history = History::default();
    let now = Situation::new(&graph, me, &history);
    let Ok(program) = Compiler::limited(10_000).compile(&goal, &now) else {
        if goal.is_temporal() && goal.depth() < 6 {
            let _ = Monitor::new(&goal, &now).map(|m| assert_eq!(m.holds(), goal.holds(&now)));
        }
        return;
    };
    let bits = program.read(&now);
    assert_eq!(program.holds(&bits), goal.holds(&now));
    let credit = program.credit(&bits);
    assert!(!credit.exact || (credit.value() == 1.0) == goal.holds(&now));
    for set in program.unmet(&bits, 4).sets {
        let mut changed = bits.clone();
        for unmet in set {
            let atom = program.atoms().iter().position(|a| *a == unmet.atom);
            changed.set(atom.unwrap_or(usize::MAX), unmet.wanted);
        }
        assert!(program.holds(&changed));
    }
});
