//! The symbolic run: the transition rule alone, in the bundled apartment or any scene.

use std::path::Path;
use std::sync::Arc;

use vc_graph::format::read_scene;
use vc_graph::{Action, ClassTable, NodeId, NodeKind, SceneGraph, Simulator, Verb, Word};
use vc_planner::{Episode, EpisodeOptions, Header, Step, Trajectory};
use vc_tasks::{Outcome, Task};
use virtualcity::{JsonLines, OwnFiles, Page, RecordError};

use crate::Options;
use crate::choose::{choose, told};
use crate::physical;
use crate::support::{Complaint, say};

/// The hand-made apartment that comes with the project.
const APARTMENT: &str = include_str!("../data/apartment.json");

/// The file of the episode; a record with bodies has another one.
const EPISODE: &str = "episode.jsonl";

/// All files of a run.
const FILES: [&str; 3] = ["index.html", "belief.svg", EPISODE];

/// The default goal.
const GOAL: &str = "On(apple, kitchentable), 3 & Closed(fridge)";

/// Runs the agent in the symbolic simulator.
pub(crate) fn main(options: &Options) -> Result<(), Complaint> {
    let classes = classes(options.classes.as_deref())?;
    let scene = match &options.scene {
        Some(file) => virtualcity::read_scene(file, &classes)?,
        None => read_scene(APARTMENT, &classes).map_err(Complaint::new)?,
    };
    let Some(&me) = scene.agents().first() else {
        return Err(Complaint::new("this scene has no agent: add an object of class `character`"));
    };
    if options.list {
        list(&scene, me);
        return Ok(());
    }
    let world = Simulator::new(scene.clone());
    let task = match (&options.goal, &options.task) {
        (None, None) => told(options, GOAL, &world)?,
        _ => choose(options, &world, me)?,
    };
    run(options, &scene, me, &task)
}

fn classes(own: Option<&Path>) -> Result<Arc<ClassTable>, Complaint> {
    let builtin = ClassTable::builtin();
    let Some(path) = own else { return Ok(builtin) };
    let text = virtualcity::read_text(path)?;
    let extended = builtin.extended(&path.display().to_string(), &text);
    extended.map(Arc::new).map_err(Complaint::new)
}

fn run(options: &Options, scene: &SceneGraph, me: NodeId, task: &Task) -> Result<(), Complaint> {
    say!("scene  {}: {} rooms, {} nodes", scene.name(), scene.rooms().len(), scene.len());
    say!("agent  {} in {}", scene.label(me), room(scene, me));
    say!("task   {}: {}\n", task.title, task.goal);
    let mut policy = options.policy.policy();
    let mut world = Simulator::new(scene.clone());
    let run = EpisodeOptions { agent: Some(me), ..EpisodeOptions::seeded(options.seed()) };
    let out = options.folder();
    let mut own = OwnFiles::begin(&out, &FILES).map_err(Complaint::new)?;
    own.claim([EPISODE]).map_err(Complaint::new)?;
    let mut lines = JsonLines::create(out.join(EPISODE))?;
    let header = Header::new(&run, policy.as_ref(), task, scene);
    lines.push(&header)?;
    let (mut steps, mut failed) = (Vec::new(), None);
    let episode = run.episode(policy.as_mut(), task, &mut world, &mut |step| {
        show(step);
        failed = failed.take().or(lines.push(step).err());
        steps.push(step.clone());
    });
    if let Some(error) = failed {
        return Err(error.into());
    }
    let summary = episode.summary();
    lines.push(&summary)?;
    let belief = physical::belief(world.graph(), task, policy.as_ref());
    write_page(&mut own, &Trajectory { header, steps, summary }, belief.as_deref()).map_err(Complaint::new)?;
    verdict(scene, me, task, &world, &episode)?;
    say!("look at {}", out.join("index.html").display());
    Ok(())
}

/// Writes the page about the run, with the belief.
fn write_page(own: &mut OwnFiles, trajectory: &Trajectory, belief: Option<&str>) -> Result<(), RecordError> {
    let mut page = Page::from_trajectory(trajectory);
    if let Some(belief) = belief {
        own.write("belief.svg", belief.as_bytes())?;
        page = page.figure("belief.svg", "What it believed in the end", Page::BELIEF);
    }
    let page = page.file(EPISODE, "every step, with what was seen, believed and planned, as JSON Lines");
    own.write("index.html", page.html().as_bytes())?;
    own.settle()
}

fn room(scene: &SceneGraph, id: NodeId) -> String {
    scene.room_of(id).map_or_else(|| "no room".into(), |r| scene.label(r).to_string())
}

fn show(step: &Step) {
    say!("{:>3}  in {}", step.step, step.room.as_deref().unwrap_or_default());
    wrapped("saw", &summary(&step.found));
    if !step.believed.is_empty() {
        wrapped("believes", &format!("{} (of {} places)", summary(&step.believed), step.places));
    }
    wrapped("plans", &summary(&step.plan));
    wrapped("does", &step.described);
}

/// The first few entries of a list, and the number of the others.
fn summary(items: &[String]) -> String {
    const SHOWN: usize = 8;
    match items.len() {
        0 => "nothing new".into(),
        n if n <= SHOWN => items.join(", "),
        n => format!("{} and {} more", items[..SHOWN].join(", "), n - SHOWN),
    }
}

fn wrapped(what: &str, text: &str) {
    const WIDTH: usize = 84;
    let mut line = format!("     {what:<9}");
    for word in text.split(' ') {
        if line.chars().count() + word.chars().count() > WIDTH {
            say!("{}", line.trim_end());
            line = " ".repeat(14);
        }
        line.push_str(word);
        line.push(' ');
    }
    say!("{}", line.trim_end());
}

/// Reports the result, after replaying the actions from the initial scene.
fn verdict(scene: &SceneGraph, me: NodeId, task: &Task, world: &Simulator, episode: &Episode) -> Result<(), Complaint> {
    let mut again = Simulator::new(scene.clone());
    let mut progress = task.begin(&again, me);
    for event in world.history().events() {
        again.step(event.agent, &event.action).map_err(|r| Complaint::new(format!("replay refused: {}", r[0])))?;
        progress.note(&again);
    }
    let same = again.graph().digest() == episode.digest;
    let holds = progress.holds(&again);
    say!("\n{:?} after {} actions, {:.0}% of the goal holds", episode.outcome, episode.steps, 100.0 * episode.score);
    say!(
        "replayed from the start: goal {}, scene {}",
        yes(holds, "holds", "does not hold"),
        yes(same, "identical", "DIFFERENT")
    );
    match (episode.outcome, &episode.reason) {
        (Outcome::Won, _) if holds && same => Ok(()),
        (_, Some(reason)) => Err(Complaint::new(reason)),
        _ => Err(Complaint::new("the goal was not reached")),
    }
}

fn yes(condition: bool, then: &'static str, otherwise: &'static str) -> &'static str {
    if condition { then } else { otherwise }
}

/// Shows the contents of a scene and the possible tasks in it.
pub(crate) fn list(scene: &SceneGraph, me: NodeId) {
    say!(
        "{}: {} rooms, {} nodes, agent {} in {}\n",
        scene.name(),
        scene.rooms().len(),
        scene.len(),
        scene.label(me),
        room(scene, me)
    );
    for &room in scene.rooms() {
        let mut counts = std::collections::BTreeMap::new();
        let things = scene.in_room(room).filter_map(|id| scene.node(id)).filter(|n| n.kind() == NodeKind::Object);
        for node in things {
            *counts.entry(node.class().clone()).or_insert(0) += 1;
        }
        let words = counts.iter().map(|(class, n)| if *n > 1 { format!("{class} x{n}") } else { class.to_string() });
        say!("{}", scene.label(room));
        wrapped("", &words.collect::<Vec<_>>().join(", "));
    }
    say!("\nverbs");
    for rule in scene.vocabulary().rules() {
        say!("  {:<11} {}", rule.verb.as_str(), rule.description);
    }
    say!("\nwhat the agent could do where it is, among others");
    let able = scene
        .nodes()
        .flat_map(|n| [Verb::Walk, Verb::Grab, Verb::Open, Verb::SwitchOn, Verb::Sit].map(|v| Action::one(v, n.id())));
    let able = able.filter(|a| vc_graph::rule::refusals(scene, me, a).is_empty() && a.verb != Verb::Walk);
    wrapped("", &able.take(12).map(|a| a.describe(scene).to_string()).collect::<Vec<_>>().join(", "));
    say!("\ngoals that make sense here, for --goal");
    for task in vc_tasks::household().iter().filter(|t| t.obstacles(scene).is_empty()) {
        say!("  {}", task.goal);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use clap::Parser;
    use vc_planner::Trajectory;

    use super::*;

    #[test]
    fn options_without_a_meaning_are_refused() {
        let symbolic = ["--agents=2", "--dataset", "--hour=19", "--finer=3", "--width=320", "--list --goal=Holds(mug)"];
        let bodies = ["--classes=none", "--list --task=zzz", "--list --dataset", "--classes=none --list"];
        let cases = symbolic.map(|more| format!("--symbolic {more}")).into_iter().chain(bodies.map(str::to_owned));
        for words in cases {
            let options = Options::parse_from(std::iter::once("household").chain(words.split(' ')));
            let complaint = format!("{:?}", crate::asked::check(&options).unwrap_err());
            assert!(complaint.contains("does not apply: "), "{words}: {complaint}");
        }
        for words in ["--symbolic --seed=3", "--seed=7 --agents=2 --hour=19", "--list --seed=3", "--symbolic --list"] {
            let options = Options::parse_from(std::iter::once("household").chain(words.split(' ')));
            assert!(crate::asked::check(&options).is_ok(), "{words}");
        }
        for words in ["--agents=0", "--agents=x", "--task=a --goal=Holds(mug)"] {
            assert!(Options::try_parse_from(std::iter::once("household").chain(words.split(' '))).is_err(), "{words}");
        }
        let told = Options::try_parse_from(["household", "--seed", "-1"]).err().unwrap().to_string();
        assert!(told.contains("a seed is a whole number from 0 to "), "{told}");
    }

    #[test]
    fn what_an_earlier_run_left_is_removed() {
        let out = std::env::temp_dir().join(format!("vc-household-left-{}", std::process::id()));
        let old = ["film.gif", "map.png", "end.png", "film/000.jpg"];
        for name in old.into_iter().chain(["mine.png", "film/mine.txt"]) {
            virtualcity::files::write(out.join(name), "old").unwrap();
        }
        virtualcity::files::write(out.join("index.html"), "old").unwrap();
        let run = || super::main(&Options::parse_from(["household", "--symbolic", "--out", out.to_str().unwrap()]));
        let there = |name: &str| out.join(name).exists();
        // Files that no list names are of somebody else.
        let refused = format!("{:?}", run().unwrap_err());
        assert!(refused.contains("index.html is in the way") && old.iter().all(|name| there(name)), "{refused}");
        old.into_iter().chain(["index.html"]).for_each(|name| std::fs::remove_file(out.join(name)).unwrap());
        let mut record = OwnFiles::begin(&out, &[]).unwrap();
        old.iter().for_each(|name| record.write(name, b"old").unwrap());
        record.settle().unwrap();
        for _ in 0..2 {
            run().unwrap();
            assert!(old.iter().all(|name| !there(name)));
            assert!(["mine.png", "film/mine.txt", "index.html", EPISODE].iter().all(|name| there(name)));
        }
        // A half of a page that a finished run did not leave.
        std::fs::write(out.join("index.html.part"), "mine").unwrap();
        assert!(format!("{:?}", run().unwrap_err()).contains("index.html.part is in the way"));
        assert!(there("index.html") && there("index.html.part"));
        std::fs::remove_dir_all(out).unwrap();
    }

    #[test]
    fn what_is_written_is_read_back_and_replays() {
        let folder = std::env::temp_dir().join(format!("vc-household-{}", std::process::id()));
        let out = folder.join("symbolic");
        for who in ["planner", "oracle"] {
            let words = ["household", "--symbolic", "--policy", who, "--out", out.to_str().unwrap()];
            super::main(&Options::parse_from(words)).unwrap();
            let text = std::fs::read_to_string(out.join(EPISODE)).unwrap();
            let trajectory = Trajectory::read_json_lines(&text).unwrap();
            let scene = read_scene(APARTMENT, &ClassTable::builtin()).unwrap();
            let page = std::fs::read_to_string(out.join("index.html")).unwrap();
            assert!(trajectory.steps.iter().all(|step| page.contains(&step.described)));
            assert_eq!(trajectory.check(&scene), []);
            assert_eq!(trajectory.summary.outcome, Outcome::Won);
            assert_eq!(trajectory.header.goal, GOAL.parse().unwrap());
            assert_eq!(trajectory.replay(&scene).unwrap().len(), trajectory.steps.len() + 1);
        }
        std::fs::remove_dir_all(folder).unwrap();
    }
}
