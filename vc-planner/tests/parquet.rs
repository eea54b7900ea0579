//! Trajectories written as a Parquet file are read back row by row.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use vc_graph::{Draft, SceneBuilder, SceneGraph, Scope, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, RandomPolicy, Trajectory, write_parquet};
use vc_tasks::Task;

fn home() -> SceneGraph {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(fridge, Draft::new("apple")).unwrap();
    scene.add_in(bedroom, Draft::new("character")).unwrap();
    scene.build()
}

fn record(policy: &mut dyn Policy, seed: u64) -> Trajectory {
    let mut task = Task::new("a snack", "On(apple, kitchen_table) & Closed(fridge)".parse().unwrap());
    task.step_limit = 12;
    Trajectory::record(&EpisodeOptions::seeded(seed), policy, &task, &mut Simulator::new(home()))
}

#[test]
fn a_table_says_what_the_trajectories_say() {
    let scene = home();
    let episodes = [record(&mut PlannerPolicy::best(), 1), record(&mut RandomPolicy::default(), 2)];
    let mut file = Vec::new();
    write_parquet(&mut file, Scope::Room, episodes.iter().map(|e| (e, &scene))).unwrap();
    if let Some(folder) = std::env::var_os("VC_PARQUET") {
        std::fs::write(std::path::Path::new(&folder).join("trajectories.parquet"), &file).unwrap();
    }

    let reader = SerializedFileReader::new(bytes::Bytes::from(file)).unwrap();
    assert_eq!(reader.num_row_groups(), 2);
    let rows: Vec<_> = reader.get_row_iter(None).unwrap().map(Result::unwrap).collect();
    assert_eq!(rows.len(), episodes.iter().map(|e| e.steps.len()).sum::<usize>());
    let (mut row, mut total) = (rows.iter(), 0.0);
    for (number, episode) in (0..).zip(&episodes) {
        let transitions = episode.transitions(&scene, Scope::Room).unwrap();
        for transition in &transitions {
            let row = row.next().unwrap();
            assert_eq!(row.get_long(0).unwrap(), number);
            assert_eq!(row.get_string(2).unwrap(), &episode.header.goal.to_string());
            assert_eq!(row.get_long(5).unwrap(), transition.step as i64);
            assert_eq!(row.get_string(6).unwrap(), &transition.observation);
            assert_eq!(row.get_string(7).unwrap(), &transition.action);
            assert_eq!(row.get_double(8).unwrap(), transition.reward);
            assert_eq!(row.get_string(9).unwrap(), &transition.next_observation);
            assert_eq!(row.get_bool(10).unwrap(), transition.terminated);
            assert_eq!(row.get_bool(11).unwrap(), transition.truncated);
            total += if number == 0 { transition.reward } else { 0.0 };
        }
        let ends: Vec<usize> =
            (0..transitions.len()).filter(|&i| transitions[i].terminated || transitions[i].truncated).collect();
        assert_eq!(ends, [transitions.len() - 1]);
    }
    // The fridge is closed at first: half of the goal holds.
    assert_eq!(total, 0.5);
}
