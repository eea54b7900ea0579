//! Classes of your own, from a text: a scene with them, a goal about them, and a plan.
//!
//! `cargo run --release --example own_classes`

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use std::sync::Arc;

use support::{Complaint, say};
use vc_graph::{ClassTable, Draft, SceneBuilder, Simulator};
use vc_planner::{PlannerPolicy, run_episode};
use vc_tasks::{Outcome, Task};

/// Name, ancestors, aliases, category, affordances, size, mass, first states, slots, habitual places.
const CLASSES: &str = "
pill_box | box | pills | prop | graspable | 0.06 0.1 0.03 | 0.05 | | | bathroom/in/bathroom_cabinet:2
robot_dock | | robot_charger | furniture | surface | 0.4 0.4 0.1 | 2 | | | livingroom:1
";

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let classes = Arc::new(ClassTable::builtin().extended("mine.txt", CLASSES)?);
    let mut scene = SceneBuilder::with_classes("flat", classes);
    let (bathroom, living) = (scene.add(Draft::new("bathroom"))?, scene.add(Draft::new("livingroom"))?);
    let cabinet = scene.add_in(bathroom, Draft::new("bathroom_cabinet"))?;
    scene.add_in(cabinet, Draft::new("pill_box"))?;
    scene.add_in(living, Draft::new("robot_dock"))?;
    scene.add_in(living, Draft::new("character"))?;

    let task = Task::new("bring the pills", "On(pills, robot_dock)".parse()?);
    let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut Simulator::new(scene.build()));
    say!("{:?} after {} steps", episode.outcome, episode.steps);
    if episode.outcome == Outcome::Won { Ok(()) } else { Err(Complaint::new("the pills were not brought")) }
}
