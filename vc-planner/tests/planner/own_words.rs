//! Goals that only a verb of one's own reaches, for agents that know the home and for agents that do not.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::goal::Goal;
use vc_graph::{History, Property, SceneGraph, Simulator, State, Vocabulary, Word};
use vc_planner::{PlannerPolicy, run_episode};
use vc_tasks::{Outcome, Task};

use super::homes;

const WORDS: &str = "
    property polishable
    state shiny | excludes: dusty dirty | needs: polishable
    state blessed
    verb polish 2 | needs: affords x polishable; affords y wiper; holding y; accessible x; near x | effects: enter x shiny
    verb rub 1 | needs: affords x polishable; in x blessed; near x | effects: leave x blessed
    predicate ready ?x | is: Shiny(?x) & !Blessed(?x)
    predicate decked ?x | is: ready(?x) & exists ?y: book. On(?y, ?x)
    verb bless 1 | needs: in x shiny; upright; facing x | effects: enter_with x blessed
";

/// A home in which tables can be polished.
fn home(scene: &SceneGraph) -> SceneGraph {
    let mut scene = scene.clone();
    scene.set_vocabulary(Vocabulary::parse("words.txt", WORDS).unwrap());
    let tables = scene.of_class("table");
    let mut edit = scene.edit();
    for table in tables {
        edit.allow(table, Property::parse("polishable").unwrap()).unwrap();
        edit.enter_state(table, State::Dusty).unwrap();
    }
    edit.commit();
    scene
}

#[test]
fn own_verbs_are_planned() {
    for seed in 0..12 {
        let scene = home(&homes::home(seed));
        for goal in [
            "Shiny(table)",
            "Blessed(table)",
            "!Dusty(table), 2",
            "did polish(table, _) & did bless(table)",
            "Decked(table)",
            "Ready(table), 2",
        ] {
            let goal: Goal = goal.parse().unwrap();
            for mut policy in [PlannerPolicy::oracle(), PlannerPolicy::best()] {
                let mut world = Simulator::new(scene.clone());
                let task = Task::new(goal.to_string(), goal.clone());
                let episode = run_episode(&mut policy, &task, &mut world);
                assert_eq!(episode.outcome, Outcome::Won, "{goal}: {:?}", episode.reason);
            }
        }
    }
}

#[test]
fn a_state_without_an_opposite_is_left() {
    for seed in 0..4 {
        let mut scene = home(&homes::home(seed));
        let table = scene.of_class("table")[0];
        let mut edit = scene.edit();
        edit.enter_state(table, State::parse("blessed").unwrap()).unwrap();
        edit.enter_state(table, State::parse("shiny").unwrap()).unwrap();
        edit.commit();
        let me = scene.agents()[0];
        let plan = vc_planner::plan(&mut scene, me, &"!Blessed(table)".parse().unwrap(), &History::default()).unwrap();
        let said: Vec<String> = plan.actions.iter().map(|action| action.describe(&scene).to_string()).collect();
        assert!(said.last().is_some_and(|last| last.starts_with("rub ")), "{said:?}");
    }
}

#[test]
fn a_team_shares_a_goal_with_derived_predicates() {
    let scene = home(&homes::home(3));
    let mut world = Simulator::new(scene.clone());
    let goal: Goal = "Decked(table) & Ready(table), 2".parse().unwrap();
    let mut team = vc_planner::Team::oracles(&scene, scene.agents(), &goal);
    let episode = team.run(&Task::new("deck", goal), &mut world);
    assert_eq!(episode.outcome, Outcome::Won, "{:?}", episode.reason);
}

#[test]
fn a_goal_is_lost_in_a_scene_that_does_not_define_its_predicate() {
    let scene = homes::home(3);
    Vocabulary::parse("words.txt", "predicate unheard_of ?x | is: Clean(?x)").unwrap();
    let task = Task::new("odd", "UnheardOf(table)".parse().unwrap());
    let episode = run_episode(&mut PlannerPolicy::oracle(), &task, &mut Simulator::new(scene));
    assert_eq!(episode.outcome, Outcome::Lost);
    assert!(episode.reason.is_some_and(|reason| reason.contains("does not define the predicate `unheard_of`")));
}
