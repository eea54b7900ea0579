//! The task library is well formed, complete and stable.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::goal::Term;
use vc_graph::{ClassTable, Verb};
use vc_tasks::library::{Activity, Benchmark, List, Need, THESIS_VERBS, thesis_tasks};

/// Objects and places of the thesis's tasks that no generator makes yet.
const NOT_YET: [&str; 12] = [
    "bank",
    "basketball_court",
    "beach",
    "cinema_seat",
    "corner_store",
    "grocery_store",
    "library",
    "movie_theater",
    "park",
    "pharmacy",
    "sea",
    "shopping_cart",
];

fn thesis() -> Vec<Activity> {
    [List::Indoor, List::Outdoor].into_iter().flat_map(thesis_tasks).collect()
}

fn classes_of(activity: &Activity) -> BTreeSet<String> {
    let goals = [&activity.goal, &activity.natural, &activity.start];
    let named = goals.into_iter().flat_map(vc_graph::Goal::terms).filter_map(|term| match term {
        Term::Class(class) => Some(class),
        _ => None,
    });
    let spots = activity.needs.iter().flat_map(|n| &n.spots);
    let at = spots.clone().filter_map(|s| s.at.as_ref().map(|(_, class)| class.clone()));
    let rooms = spots.filter_map(|s| s.room.clone()).chain(activity.places.iter().cloned());
    named.chain(activity.needs.iter().map(|n| n.class.clone())).chain(at).chain(rooms).collect()
}

/// Whether the table has a class of exactly this name.
fn known(classes: &ClassTable, class: &str) -> bool {
    classes.get(class).is_some_and(|c| &*c.name == class || c.aliases.iter().any(|a| &**a == class))
}

#[test]
fn all_hundred_tasks_of_the_thesis_are_there_in_order() {
    for (list, text) in [
        ("indoor", include_str!("../../data/library/indoor.json")),
        ("outdoor", include_str!("../../data/library/outdoor.json")),
    ] {
        let tasks = Activity::read_list(list, text).unwrap_or_else(|e| panic!("{e}"));
        let ids: Vec<String> = tasks.into_iter().map(|t| t.id).collect();
        assert_eq!(ids, (1..=50).map(|i| format!("{list}-{i}")).collect::<Vec<_>>());
    }
}

#[test]
fn tasks_speak_of_classes_there_are_and_say_which_places_there_are_not() {
    let classes = ClassTable::builtin();
    let mut missing: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for task in thesis() {
        for class in classes_of(&task).into_iter().filter(|c| !known(&classes, c)) {
            missing.entry(class).or_default().push(task.id.clone());
        }
    }
    let unexpected: Vec<_> = missing.iter().filter(|(class, _)| !NOT_YET.contains(&class.as_str())).collect();
    assert!(unexpected.is_empty(), "{unexpected:?}");
    for (class, ids) in &missing {
        for id in ids {
            let task = thesis().into_iter().find(|t| t.id == *id).unwrap();
            assert!(task.unknown_places(&classes).next().is_some(), "{id} needs {class} and names no place without it");
        }
    }
}

#[test]
fn benchmark_speaks_only_of_classes_and_rooms_there_are() {
    let classes = ClassTable::builtin();
    for task in Benchmark::v1().activities {
        let unknown: Vec<String> = classes_of(&task).into_iter().filter(|c| !known(&classes, c)).collect();
        assert!(unknown.is_empty(), "{}: {unknown:?}", task.id);
        assert_eq!(task.unknown_places(&classes).count(), 0, "{}", task.id);
    }
}

#[test]
fn goals_are_written_as_they_are_read() {
    for task in thesis().into_iter().chain(Benchmark::v1().activities) {
        for goal in [&task.goal, &task.natural, &task.start, &task.task().goal] {
            assert_eq!(*goal, goal.to_string().parse().unwrap(), "{}: {goal}", task.id);
        }
        for need in &task.needs {
            assert_eq!(*need, need.to_string().parse().unwrap(), "{}: {need}", task.id);
        }
    }
}

#[test]
fn benchmark_has_145_tasks_from_20_bases_under_ids_of_their_own() {
    Benchmark::read(include_str!("../../data/library/benchmark.json")).unwrap_or_else(|e| panic!("{e}"));
    let benchmark = Benchmark::v1();
    let mut bases: BTreeMap<&str, usize> = BTreeMap::new();
    benchmark.activities.iter().for_each(|a| *bases.entry(a.group()).or_default() += 1);
    let ids: BTreeSet<&str> = benchmark.activities.iter().map(|a| a.id.as_str()).collect();
    let goals: BTreeSet<String> =
        benchmark.activities.iter().map(|a| format!("{} {} {:?}", a.task().goal, a.start, a.needs)).collect();
    assert_eq!((bases.len(), ids.len(), goals.len()), (20, 145, 145));
    // Rich tasks have many variants, tasks about one object few.
    assert!(bases["put_fridge"] >= 4 * bases["close_blinds"], "{bases:?}");
}

#[test]
fn version_1_of_the_benchmark_never_changes() {
    assert_eq!(Benchmark::v1().digest().to_string(), "4f42fa602d85c6f2");
}

#[test]
fn every_verb_of_the_thesis_is_asked_for() {
    let asked: BTreeSet<Verb> = Benchmark::v1().activities.iter().flat_map(Activity::verbs).collect();
    let missing: Vec<&Verb> = THESIS_VERBS.iter().filter(|v| !asked.contains(v)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn needs_are_counted_from_the_goal_where_nothing_is_written() {
    let text = r#"[{"number": 1, "title": "t", "goal": "On(apple, table), 3 & Closed(fridge)", "needs": ["2 pear"]}]"#;
    let task = Activity::read_list("own", text).unwrap().remove(0);
    let needs: Vec<String> = task.all_needs().iter().map(Need::to_string).collect();
    assert_eq!(needs, ["2 pear", "3 apple", "fridge", "table"]);
}

#[test]
fn errors_say_where() {
    let fails = |text: &str| Activity::read_list("own", text).unwrap_err().to_string();
    let goal = "[\n{\"number\": 1, \"title\": \"t\", \"goal\": \"On(apple\"}]";
    assert!(
        fails(goal).starts_with("own: goal, character 9: expected `,` or `)`, found the end at line 2"),
        "{}",
        fails(goal)
    );
    let need = "[{\"number\": 1, \"title\": \"t\", \"goal\": \"true\", \"needs\": [\"many plate\"]}]";
    assert!(fails(need).contains("`many` is no number"), "{}", fails(need));
    let base = r#"[{"base": "b", "goal": "On($1", "variants": [["apple"]]}]"#;
    let error = Benchmark::read(base).unwrap_err().to_string();
    assert_eq!(error, "b-01: `On(apple`: goal, character 9: expected `,` or `)`, found the end");
}
