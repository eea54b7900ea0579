//! Tasks with derived predicates: obstacles, activities, and domains of planning.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, NodeId, SceneBuilder, SceneGraph, Seed, Simulator, State, Vocabulary, Word};
use vc_tasks::Task;
use vc_tasks::format::pddl::{AtomicFormula, Keep, OperatorEffect, planning};
use vc_tasks::initial::{InitialGenerator, PlainStock};
use vc_tasks::library::Activity;

const WORDS: &str = "
    state blessed
    verb rub 1 | needs: in x blessed; near x | effects: leave x blessed
    predicate spotless ?x | is: Clean(?x) & !Blessed(?x)
    predicate chilled ?x | is: exists ?f: fridge. Inside(?x, ?f)
";

fn kitchen() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    for class in ["cup", "cup"] {
        scene.add_on(table, Draft::new(class)).unwrap();
    }
    scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let mut scene = scene.build();
    scene.set_vocabulary(Vocabulary::parse("words.txt", WORDS).unwrap());
    (scene, me)
}

fn task(goal: &str) -> Task {
    Task::new("t", goal.parse().unwrap())
}

#[test]
fn obstacles_are_those_of_the_definition() {
    let (scene, _) = kitchen();
    let why = |goal: &str| task(goal).obstacles(&scene).iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(why("Spotless(cup)"), [""; 0]);
    assert!(why("Spotless(cup), 5")[0].ends_with("needs 5 of `cup`, the scene has 2"), "{:?}", why("Spotless(cup), 5"));
    assert!(why("Chilled(mug)")[0].contains("needs 1 of `mug`, the scene has 0"), "{:?}", why("Chilled(mug)"));
}

#[test]
fn a_goal_without_a_definition_is_lost_unless_there_is_an_alternative() {
    let (scene, _) = kitchen();
    Vocabulary::parse("other.txt", "predicate unheard ?x | is: Clean(?x)").unwrap();
    let is_lost = |goal: &str| task(goal).lost(&scene).is_some();
    for lost in ["Unheard(cup)", "Open(fridge) & Unheard(cup)", "!Unheard(cup)", "Unheard(cup) | Unheard(fridge)"] {
        assert!(is_lost(lost), "{lost}");
    }
    assert!(!is_lost("Open(fridge) | Unheard(cup)"));
}

#[test]
fn an_activity_begins_with_what_its_definitions_need() {
    let (scene, _) = kitchen();
    let list = r#"[{"number": 1, "title": "cool it", "goal": "Chilled(milk)", "start": "Spotless(cup)"}]"#;
    let activity = Activity::read_list("own", list).unwrap().remove(0);
    let mut world = Simulator::new(scene.clone());
    let made = InitialGenerator::new(&PlainStock).make(&activity, &scene, Seed(1), &mut world).unwrap();
    assert_eq!(made.scene.of_class("milk").len(), 1);
    assert!(made.scene.of_class("cup").iter().all(|id| made.scene.node(*id).unwrap().is(State::Clean)));
    assert_eq!(made.task.goal.to_string(), "Chilled(milk)", "the task keeps its words");
}

/// The last effect counts.
#[test]
fn a_domain_keeps_the_order_of_effects() {
    let (mut scene, me) = kitchen();
    let words = "verb smear 1 | needs: near x | effects: enter x dirty; leave x dirty
                 verb stain 1 | needs: near x | effects: leave x dirty; enter x dirty";
    scene.set_vocabulary(Vocabulary::parse("words.txt", words).unwrap());
    let goal = "Dirty(cup) & !Dirty(fridge.5)".parse().unwrap();
    let planning = planning(&scene, me, &goal, Keep::Everything).unwrap();
    for (name, expected) in [("smear", ["not_dirty", "is_dirty"]), ("stain", ["is_dirty", "not_dirty"])] {
        let operator = planning.domain.operators.iter().find(|operator| operator.name == name).unwrap();
        let about = |atom: &AtomicFormula| expected.contains(&atom.predicate.as_str());
        let said = operator.effect.iter().filter_map(|effect| match effect {
            OperatorEffect::Add(atom) if about(atom) => Some((true, atom.predicate.as_str())),
            OperatorEffect::Delete(atom) if about(atom) => Some((false, atom.predicate.as_str())),
            _ => None,
        });
        let mut said: Vec<_> = said.collect();
        said.sort_unstable();
        assert_eq!(said, [(false, expected[1]), (true, expected[0])], "{name}");
    }
}

/// The last word about a fact counts: also about one's own states, and about what lets things in.
#[test]
fn a_domain_says_of_each_fact_one_thing() {
    let (mut scene, me) = kitchen();
    let words = "state merry
                 verb cheer 0 | effects: enter_own merry; leave_own merry
                 verb flap 1 | needs: near x | effects: enter x open; enter x closed
                 verb unhinge 1 | needs: near x | effects: enter x open";
    scene.set_vocabulary(Vocabulary::parse("words.txt", words).unwrap());
    let goal = "Merry(me) & Open(fridge.5)".parse().unwrap();
    let planning = planning(&scene, me, &goal, Keep::Everything).unwrap();
    let expected = [("cheer", "is_merry", false), ("flap", "lets_in", false), ("unhinge", "lets_in", true)];
    for (name, predicate, holds) in expected {
        let operator = planning.domain.operators.iter().find(|operator| operator.name == name).unwrap();
        let said: Vec<bool> = operator
            .effect
            .iter()
            .filter_map(|effect| match effect {
                OperatorEffect::Add(atom) if atom.predicate == predicate => Some(true),
                OperatorEffect::Delete(atom) if atom.predicate == predicate => Some(false),
                _ => None,
            })
            .collect();
        assert_eq!(said, [holds], "{name} {predicate}: {:?}", operator.effect);
    }
}

#[test]
fn a_domain_says_that_a_state_is_left() {
    let (mut scene, me) = kitchen();
    let table = scene.of_class("kitchen_table")[0];
    let mut edit = scene.edit();
    edit.enter_state(table, State::parse("blessed").unwrap()).unwrap();
    edit.commit();
    for keep in [Keep::Relevant, Keep::Everything] {
        let planning = planning(&scene, me, &"Spotless(kitchen_table.2)".parse().unwrap(), keep).unwrap();
        let rub = planning.domain.operators.iter().find(|operator| operator.name == "rub").unwrap();
        let adds =
            |change: &OperatorEffect| matches!(change, OperatorEffect::Add(atom) if atom.predicate == "not_blessed");
        assert!(rub.effect.iter().any(adds), "{:?}", rub.effect);
        assert!(planning.problem.goal.to_string().contains("not_blessed"));
    }
}
