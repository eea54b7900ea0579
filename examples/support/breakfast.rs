//! A kitchen after breakfast, and an agent that asks a model how to tidy it up.

use vc_graph::{Draft, EditError, SceneBuilder, SceneGraph, Simulator};
use vc_planner::language::Prompt;
use vc_planner::{EpisodeOptions, LanguageModel};
use vc_tasks::{Outcome, Task};

use crate::support::{Complaint, say};

/// The separator between two answers in a file.
pub(crate) const BREAK: &str = "\n---\n";

/// Lets a model tidy up: passes each prompt to `ask`, and returns all answers. An episode that does not reach
/// the goal is an error.
pub(crate) fn tidy_up(
    prompts: bool,
    mut ask: impl FnMut(&Prompt) -> Result<String, String>,
) -> Result<Vec<String>, Complaint> {
    let scene = home().map_err(Complaint::new)?;
    let goal = "Inside(milk, fridge) & Closed(fridge) & On(mug, kitchen_counter)".parse().map_err(Complaint::new)?;
    let task = Task { step_limit: 40, ..Task::new("tidy up the breakfast", goal) };
    let mut answers = Vec::new();
    let mut model = LanguageModel::new(|prompt: &Prompt| {
        if prompts {
            say!("\n{}\n\n{}", prompt.system, prompt.user);
        }
        let answer = ask(prompt)?;
        say!("model: {}", answer.trim().replace('\n', " / "));
        answers.push(answer.trim().to_owned());
        Ok(answer)
    });
    let mut world = Simulator::new(scene);
    let episode = EpisodeOptions::seeded(0).episode(&mut model, &task, &mut world, &mut |step| match &step.refused {
        Some(why) => say!("{:>4}  {}: {why}", step.step, step.described),
        None => say!("{:>4}  {}", step.step, step.described),
    });
    drop(model);
    let why = episode.reason.map_or(String::new(), |r| format!(": {r}"));
    let told = format!("{:?} after {} steps{why}", episode.outcome, episode.steps);
    if episode.outcome != Outcome::Won {
        return Err(Complaint::new(told));
    }
    say!("{told}");
    Ok(answers)
}

/// A kitchen after breakfast, and the room next to it.
fn home() -> Result<SceneGraph, EditError> {
    let mut scene = SceneBuilder::new("breakfast");
    let kitchen = scene.add(Draft::new("kitchen"))?;
    let living = scene.add(Draft::new("living_room"))?;
    scene.add_in(kitchen, Draft::new("fridge"))?;
    scene.add_in(kitchen, Draft::new("kitchen_counter"))?;
    let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    scene.add_on(table, Draft::new("milk"))?;
    let low = scene.add_in(living, Draft::new("coffee_table"))?;
    scene.add_on(low, Draft::new("mug"))?;
    scene.add_in(living, Draft::new("character"))?;
    Ok(scene.build())
}
