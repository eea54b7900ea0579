//! Goals: compiling, evaluating, scoring, and tracking one change.
//!
//! The times of Python are those of the `bddl` package, 3.6.0, on one thread of the same kind of
//! machine, for its 1,016 goals: compile 45 ms (114 with its ways), evaluate once 14.9 ms, partial
//! credit 29 ms (inexact, after 251 ms to prepare).
//!
//! `VC_BDDL=FOLDER cargo bench -p vc-tasks --bench goals` also measures those goals in their
//! initial states, where the folder holds the unpacked package.

#[path = "support/activities.rs"]
mod activities;

use std::hint::black_box;
use std::sync::Arc;

use criterion::Criterion;
use vc_graph::goal::{Pairing, Situation};
use vc_graph::{Draft, Goal, History, SceneBuilder, SceneGraph};
use vc_tasks::compile::{Bits, Compiler, GoalProgram, Tracker};
use vc_tasks::format::bddl::{ActivityDefinition, Facts, Objects};
use vc_tasks::score::Scorer;
use vc_testkit::page::Page;

/// A table with objects on it, some of them in their goal places.
fn scene() -> SceneGraph {
    let mut scene = SceneBuilder::new("table");
    let build = |scene: &mut SceneBuilder| -> Result<(), vc_graph::EditError> {
        let kitchen = scene.add(Draft::new("kitchen"))?;
        let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
        let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
        for class in ["plate", "cup", "apple", "book"] {
            for number in 0..8 {
                let at = if number % 3 == 0 { table } else { fridge };
                scene.add_on(at, Draft::new(class))?;
            }
        }
        scene.add_in(kitchen, Draft::new("character")).map(drop)
    };
    build(&mut scene).expect("the scene is sound");
    scene.build()
}

/// Goals of the same forms as those of BDDL, about as many and as large.
fn generated() -> Vec<Goal> {
    let forms = [
        "forall ?x: A. On(?x, kitchen_table.2)",
        "On(A, kitchen_table.2) & !Dirty(A)",
        "exists ?x: A. exists ?y: B. On(?x, ?y) & Closed(fridge.3)",
        "(forall ?x: A. Inside(?x, fridge.3) | Covered(?x, fridge.3)) & Closed(fridge.3)",
        "exactly 3 ?x: A. On(?x, kitchen_table.2) & !Dirty(?x)",
        "pairs ?x: A, ?y: B. On(?x, ?y)",
        "On(A, kitchen_table.2), 4 & On(B, fridge.3), 2",
        "forall ?x: A. exists ?y: B. Touching(?x, ?y) => Clean(?x)",
    ];
    let classes = ["plate", "cup", "apple", "book"];
    let with = |n: usize| {
        let (a, b) = (classes[n % 4], classes[(n + 1) % 4]);
        forms[n / 4 % forms.len()].replace('A', a).replace('B', b).parse()
    };
    (0..1016).map(|n| with(n).expect("the forms are goals")).collect()
}

/// A set of compiled goals with their states.
struct Set {
    name: &'static str,
    programs: Vec<Arc<GoalProgram>>,
    states: Vec<Bits>,
}

fn bench_set(c: &mut Criterion, set: &Set) {
    let goals = || set.programs.iter().zip(&set.states);
    let mut group = c.benchmark_group(format!("goals/{}", set.name));
    group.bench_function("evaluate all", |b| {
        b.iter(|| goals().filter(|(program, bits)| program.holds(black_box(bits))).count());
    });
    group.bench_function("credit of all", |b| {
        let mut scorer = Scorer::new();
        b.iter(|| goals().map(|(program, bits)| scorer.credit(program, black_box(bits)).value()).sum::<f64>());
    });
    group.bench_function("verdict of all", |b| {
        let known: Vec<_> = goals().map(|(program, _)| vc_tasks::compile::Known::nothing(program)).collect();
        let each = || set.programs.iter().zip(&known);
        b.iter(|| each().filter(|(p, k)| p.verdict(black_box(k)) == vc_tasks::compile::Verdict::Unknown).count());
    });
    let Some(largest) = goals().max_by_key(|(program, _)| program.atoms().len()) else { return };
    group.bench_function(format!("one changed atom of {}", largest.0.atoms().len()), |b| {
        let mut tracker = Tracker::new(largest.0.clone(), largest.1.clone());
        let (mut atom, number) = (0, largest.0.atoms().len());
        b.iter(|| {
            atom = (atom + 1) % number;
            let value = !tracker.bits().has(atom);
            tracker.set(black_box(atom), value)
        });
    });
    group.finish();
}

fn benches(c: &mut Criterion) {
    let (graph, history, goals) = (scene(), History::default(), generated());
    let now = Situation::new(&graph, graph.agents()[0], &history);
    c.bench_function("goals/generated/compile all", |b| {
        let mut compiler = Compiler::new();
        b.iter(|| {
            goals.iter().map(|g| compiler.compile(black_box(g), &now).map_or(0, |p| p.atoms().len())).sum::<usize>()
        });
    });
    let programs: Vec<Arc<GoalProgram>> =
        goals.iter().filter_map(|goal| GoalProgram::new(goal, &now).ok().map(Arc::new)).collect();
    let states = programs.iter().map(|p| p.read(&now)).collect();
    bench_set(c, &Set { name: "generated", programs, states });
}

fn behavior(c: &mut Criterion) {
    let Some(texts) = activities::texts() else { return };
    let activities: Vec<ActivityDefinition> =
        texts.iter().filter_map(|text| ActivityDefinition::read(text).ok()).collect();
    assert_eq!(activities.len(), texts.len(), "all texts are activities");
    let goals: Vec<(Goal, Objects<'_>)> =
        activities.iter().filter_map(|a| Some((a.to_goal().ok()?, Objects::new(a)))).collect();
    let mut compiler = Compiler::new();
    c.bench_function("goals/behavior/compile all", |b| {
        b.iter(|| {
            let atoms = |(goal, objects): &(Goal, Objects<'_>)| {
                compiler.compile(black_box(goal), objects).map_or(0, |program| program.atoms().len())
            };
            goals.iter().map(atoms).sum::<usize>()
        });
    });
    let compiled = activities.iter().filter_map(|a| {
        let facts = Facts::from_activity(a, Pairing::Matching).ok()?;
        Some((Arc::new(facts.program().clone()), facts.start(a).ok()?))
    });
    let (programs, states): (Vec<Arc<GoalProgram>>, Vec<Bits>) = compiled.unzip();
    assert_eq!(programs.len(), activities.len(), "every goal compiles");
    let atoms: usize = programs.iter().map(|p| p.atoms().len()).sum();
    eprintln!("{} activities, {atoms} atoms", activities.len());
    bench_set(c, &Set { name: "behavior", programs, states });
}

fn main() {
    let mut page = Page::new("goals");
    let mut criterion = Criterion::default().configure_from_args();
    [benches, behavior].into_iter().for_each(|bench| bench(&mut criterion));
    criterion.final_summary();
    page.criterion();
    page.finish();
}
