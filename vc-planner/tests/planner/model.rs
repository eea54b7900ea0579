//! A language model as a policy: it is told which actions the world refuses, and the number of repeated queries
//! is limited.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, SceneBuilder, SceneGraph, Simulator};
use vc_planner::language::{AnswerError, Prompt, read_answer};
use vc_planner::{Episode, LanguageModel, run_episode};
use vc_tasks::{Outcome, Task};

fn flat() -> SceneGraph {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(fridge, Draft::new("milk")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    scene.build()
}

/// An episode with the given answers, the last of which is repeated, and all prompts.
fn episode(answers: &[&str]) -> (Episode, Vec<Prompt>) {
    let task = Task::new("fetch the milk", "Holds(milk)".parse().unwrap());
    let mut asked: Vec<Prompt> = Vec::new();
    let mut model = LanguageModel::new(|prompt: &Prompt| {
        asked.push(prompt.clone());
        Ok((*answers.get(asked.len() - 1).or(answers.last()).unwrap()).to_owned())
    });
    let episode = run_episode(&mut model, &task, &mut Simulator::new(flat()));
    drop(model);
    (episode, asked)
}

const REFUSED: &str = "Your last answer was not possible";

#[test]
fn what_the_world_refuses_is_told_with_its_reason() {
    let (episode, asked) = episode(&["open fridge.2", "walk fridge.2", "open fridge.2", "grab milk.3"]);
    assert_eq!((episode.outcome, episode.steps), (Outcome::Won, 4), "{asked:#?}");
    assert!(!asked[0].user.contains(REFUSED));
    let line = asked[1].user.lines().find(|l| l.starts_with(REFUSED)).unwrap();
    assert!(line.contains("open") && line.contains("near"), "{line}");
    // A failed action is not reported as done, and a later success ends the error message.
    assert!(asked[1].user.contains("You have done:\n\n"), "{}", asked[1].user);
    assert!(!asked[2].user.contains(REFUSED) && asked[2].user.contains("You have done:\nwalk fridge.2\n"));
}

#[test]
fn after_four_refusals_it_is_over() {
    let (over, asked) = episode(&["open fridge.2"]);
    assert_eq!((over.outcome, over.steps, asked.len()), (Outcome::Aborted, 4, 4));
    let reason = over.reason.unwrap();
    assert!(reason.contains("open fridge.2") && reason.contains("near"), "{reason}");
    assert!(asked[1..].iter().all(|prompt| prompt.user.contains(REFUSED)));
    // Three failures in a row are tolerated, and counted anew after an action succeeded.
    let stubborn = ["open fridge.2", "open fridge.2", "open fridge.2", "walk fridge.2"];
    let again = ["grab milk.3", "grab milk.3", "grab milk.3", "open fridge.2", "grab milk.3"];
    let (won, asked) = episode(&[&stubborn[..], &again[..]].concat());
    assert_eq!(won.outcome, Outcome::Won, "{won:?}\n{asked:#?}");
}

#[test]
fn answers_that_say_nothing_end_it() {
    let (lost, asked) = episode(&["I would rather not."]);
    assert_eq!((lost.outcome, lost.steps, asked.len()), (Outcome::Lost, 0, 4));
    assert!(lost.reason.unwrap().starts_with("no usable answer"));
    assert!(asked[1].user.contains("is no action"));
}

/// In every notation a thing has to exist and to be what the answer calls it.
#[test]
fn answers_that_misname_things_are_refused() {
    let scene = flat();
    for answer in ["grab cup.3", "[GRAB] <cup> (3)", "place milk.3 cup.2 at 0.1 0.2", "{\"action\": \"open milk.2\"}"] {
        assert!(matches!(read_answer(answer, &scene), Err(AnswerError::Misnamed(_))), "{answer}");
    }
    for answer in ["grab milk.9", "grab #9", "[GRAB] <milk> (9)", "place milk.9 fridge.2 at 0.1 0.2"] {
        let refused = read_answer(answer, &scene);
        assert!(matches!(refused, Err(AnswerError::NoSuchThing { .. })), "{answer}: {refused:?}");
    }
    for answer in ["grab milk.3", "grab Milk.3", "[GRAB] <milk> (3)", "place milk.3 fridge.2 at 0.1 0.2", "grab #3"] {
        assert!(read_answer(answer, &scene).is_ok(), "{answer}");
    }
    // The model is told what the thing is.
    let (_, asked) = episode(&["open milk.2", "done"]);
    assert!(asked[1].user.contains("`milk.2` names a thing that is fridge.2"), "{}", asked[1].user);
}
