//! PDDL problems for external planners, and the results of their plans in our simulator.
//!
//! `cargo run --release -p vc-tasks --example pddl_problems -- write FOLDER [SCENE]` writes a
//! folder with a domain and a problem for each of some everyday goals, in a small home or in the
//! scene of a file. `peers/pddl_plans.py FOLDER` lets planners solve them. `... -- check FOLDER
//! [SCENE]` reads every `*.plan` next to a problem back and executes it: a plan is valid if no step
//! is refused and the goal holds.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use vc_graph::format::read_scene;
use vc_graph::goal::Situation;
use vc_graph::{ClassTable, Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, Simulator};
use vc_tasks::format::pddl::{self, Keep};

/// The goals in the small home.
const GOALS: &[&str] = &[
    "Open(fridge)",
    "Holds(me, apple)",
    "On(apple, kitchen_table)",
    "On(apple, kitchen_table), 2",
    "Inside(milk, fridge) & Closed(fridge)",
    "Clean(plate) & On(plate, kitchen_table)",
    "SwitchedOn(stove) & !Open(fridge)",
    "Cooked(potato)",
    "Sliced(bread)",
    "Sit(sofa) & Holds(me, book)",
    "did drink(milk) | did eat(apple)",
    "forall ?a: apple. On(?a, kitchen_table)",
    "exists ?p: plate. (On(?p, kitchen_table) & exists ?a: apple. On(?a, ?p))",
    "Wear(coat)",
    "Filled(cup) & SwitchedOff(faucet)",
    "SwitchedOn(floor_lamp) & On(book, coffee_table)",
    "SwitchedOn(tv) & Sit(sofa)",
    "Inside(plate, sink)",
    "Inside(apple, garbage_can)",
    "Open(fridge) & Holds(me, milk)",
    "Near(me, stove)",
    "On(bread, kitchen_counter)",
    "On(cup, kitchen_table) & On(plate, kitchen_table)",
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (command, folder) = match arguments.as_slice() {
        [command, folder, ..] => (command.as_str(), PathBuf::from(folder)),
        _ => return Err("say `write FOLDER` or `check FOLDER`".into()),
    };
    let (graph, me) = match arguments.get(2) {
        Some(file) => {
            let graph = read_scene(&fs::read_to_string(file)?, &ClassTable::builtin())?;
            let me = *graph.agents().first().ok_or("the scene has no character")?;
            (graph, me)
        }
        None => home()?,
    };
    for (i, text) in GOALS.iter().enumerate() {
        let (goal, folder) = (text.parse::<Goal>()?, folder.join(format!("{i:02}")));
        match command {
            "write" => write(&graph, me, &goal, &folder)?,
            _ => check(&graph, me, &goal, &folder)?,
        }
    }
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example prints")]
fn write(graph: &SceneGraph, me: NodeId, goal: &Goal, folder: &Path) -> Result<(), Box<dyn Error>> {
    for (name, keep) in [("relevant", Keep::Relevant), ("everything", Keep::Everything)] {
        let folder = folder.join(name);
        fs::create_dir_all(&folder)?;
        match pddl::planning(graph, me, goal, keep) {
            Ok(planning) => {
                fs::write(folder.join("domain.pddl"), planning.domain.to_string())?;
                fs::write(folder.join("problem.pddl"), planning.problem.to_string())?;
            }
            Err(error) => println!("{}: {error}", folder.display()),
        }
    }
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example prints")]
fn check(graph: &SceneGraph, me: NodeId, goal: &Goal, folder: &Path) -> Result<(), Box<dyn Error>> {
    for keep in ["relevant", "everything"] {
        let Ok(entries) = fs::read_dir(folder.join(keep)) else { continue };
        let mut plans: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
        plans.retain(|p| p.extension().is_some_and(|e| e == "plan"));
        plans.sort();
        for plan in plans {
            let actions = pddl::read_plan(&fs::read_to_string(&plan)?).map_err(|e| e.in_file(&plan))?;
            let mut world = Simulator::new(graph.clone());
            let refused = actions.iter().find_map(|a| world.step(me, a).err().map(|why| (a, why)));
            let history: &History = world.history();
            let holds = goal.holds(&Situation::new(world.graph(), me, history));
            match refused {
                Some((action, why)) => println!("{}: REFUSED {action}: {}", plan.display(), why[0]),
                None if holds => println!("{}: {} steps, the goal holds", plan.display(), actions.len()),
                None => println!("{}: {} steps, NOT MET {goal}", plan.display(), actions.len()),
            }
        }
    }
    Ok(())
}

/// A kitchen and a living room with the objects that the goals need.
fn home() -> Result<(SceneGraph, NodeId), Box<dyn Error>> {
    let mut scene = SceneBuilder::new("home");
    let kitchen = scene.add(Draft::new("kitchen"))?;
    let living = scene.add(Draft::new("living_room"))?;
    let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    let counter = scene.add_in(kitchen, Draft::new("kitchen_counter"))?;
    let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    for class in ["stove", "faucet", "sink", "garbage_can"] {
        scene.add_in(kitchen, Draft::new(class))?;
    }
    for class in ["sofa", "floor_lamp", "tv"] {
        scene.add_in(living, Draft::new(class))?;
    }
    let low = scene.add_in(living, Draft::new("coffee_table"))?;
    let place = |at, relation| vc_graph::Place { relation, at };
    for (class, at) in [
        ("apple", place(fridge, vc_graph::Relation::Inside)),
        ("apple", place(low, vc_graph::Relation::On)),
        ("milk", place(counter, vc_graph::Relation::On)),
        ("plate", place(counter, vc_graph::Relation::On)),
        ("plate", place(low, vc_graph::Relation::On)),
        ("cup", place(counter, vc_graph::Relation::On)),
        ("knife", place(counter, vc_graph::Relation::On)),
        ("bread", place(table, vc_graph::Relation::On)),
        ("potato", place(counter, vc_graph::Relation::On)),
        ("frying_pan", place(counter, vc_graph::Relation::On)),
        ("book", place(low, vc_graph::Relation::On)),
        ("coat", place(low, vc_graph::Relation::On)),
    ] {
        let id = scene.add_in(kitchen, Draft::new(class))?;
        let mut edit = scene.edit();
        edit.place(id, at)?;
        edit.commit();
    }
    let me = scene.add_in(living, Draft::new("character"))?;
    Ok((scene.build(), me))
}
