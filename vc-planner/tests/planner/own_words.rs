//! Goals that only a verb of one's own reaches, for agents that know the home and for agents that do not.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::goal::Goal;
use vc_graph::{Property, SceneGraph, Simulator, State, Vocabulary, Word};
use vc_planner::{PlannerPolicy, run_episode};
use vc_tasks::{Outcome, Task};

use super::homes;

const WORDS: &str = "
    property polishable
    state shiny | excludes: dusty dirty | needs: polishable
    state blessed
    verb polish 2 | needs: affords x polishable; affords y wiper; holding y; accessible x; near x | effects: enter x shiny
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
        for goal in ["Shiny(table)", "Blessed(table)", "!Dusty(table), 2", "did polish(table, _) & did bless(table)"] {
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
