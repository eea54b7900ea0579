//! A verb of your own, with a state, an affordance and a predicate: the planner plans with them, and an agent with a body
//! does it.
//!
//! `cargo run --release --example own_verb`

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use support::{Complaint, say};
use virtualcity::Environment;
use virtualcity::graph::{Property, Seed, Vocabulary};
use virtualcity::planner::{PlannerPolicy, run_episode};
use virtualcity::procgen::Apartment;
use virtualcity::tasks::{Outcome, Task};

/// `x` is polished with `y`, a wiper in hand.
const WORDS: &str = "
property polishable
state shiny | excludes: dusty dirty | needs: polishable
verb polish 2 | needs: affords x polishable; affords y wiper; holding y; accessible x; near x | effects: enter x shiny | motion: use_at
predicate inviting ?x | is: Shiny(?x) & exists ?b: book. On(?b, ?x)
";

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let mut scene = Apartment::from_seed(Seed(9))?.scene();
    scene.set_vocabulary(Vocabulary::parse("words.txt", WORDS)?);
    let (polishable, tables): (Property, _) = ("polishable".parse()?, scene.of_class("table"));
    let mut edit = scene.edit();
    for table in tables {
        edit.allow(table, polishable)?;
    }
    edit.commit();

    let mut home = Environment::builder_from_scene(scene).make()?;
    let task = Task::new("polish the coffee table", "Inviting(coffee_table)".parse()?);
    let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut home);
    for event in home.history().events() {
        say!("{}", event.action.describe(home.graph()));
    }
    say!("{:?} after {} steps", episode.outcome, episode.steps);
    if episode.outcome == Outcome::Won { Ok(()) } else { Err(Complaint::new("the table is not inviting")) }
}
