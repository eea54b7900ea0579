//! The run with bodies.

use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use vc_graph::{Action, ChangeSet, History, Label, NodeId, ObjectRole, Property, SceneGraph};
use vc_planner::{EpisodeOptions, Policy, Step, Summary, Team, objects_of_interest};
use vc_tasks::{Outcome, Task, World, WorldError};
use virtualcity::render::Daylight;
use virtualcity::{Environment, RecordOptions, Recorder};

use crate::choose::choose;
use crate::remark;
use crate::support::{Complaint, say};
use crate::symbolic;
use crate::{Lamps, Options, Who};

/// Largest number of objects in a picture of a belief.
const BELIEVED: usize = 16;
/// Largest number of newly seen objects that are named per action.
const NAMED: usize = 3;

/// Makes the home, lets the agent act, and writes the folder.
pub(crate) fn main(options: &Options) -> Result<(), Complaint> {
    let start = Instant::now();
    let name = match &options.scene {
        Some(file) => format!("scene:{}", file.display()),
        None => format!("apartment/{}", options.seed()),
    };
    let mut home = Environment::make(&name, options.agents).map_err(Complaint::new)?;
    let daylight = options.hour.map(Daylight::at);
    if options.lamps == Lamps::AtDark {
        // By day people switch on the light where there is no window.
        let dark = daylight.is_some_and(|daylight| daylight.is_dark());
        let graph = home.graph().clone();
        let has_window = |room| graph.of_role(ObjectRole::Window).any(|n| graph.room_of(n.id()) == room);
        let lit = home.switch_lamps_where(true, |lamp| dark || !has_window(graph.room_of(lamp)));
        lit.map_err(Complaint::new)?;
    }
    home.left_out().iter().for_each(|left| say!("left out  {left}"));
    remark::on_walls(home.graph());
    let me = home.agents()[0];
    if options.list {
        symbolic::list(home.graph(), me);
        return Ok(());
    }
    let task = choose(options, &home, me)?;
    say!("home   {name}: {} rooms, {} nodes", home.graph().rooms().len(), home.graph().len());
    home.agents().iter().for_each(|agent| say!("agent  {} in {}", home.graph().label(*agent), room(&home, *agent)));
    say!("task   {}: {}\n", task.title, task.goal);
    let usual = RecordOptions::default();
    let (width, finer) = (options.width.unwrap_or(usual.width), options.finer.unwrap_or(usual.finer));
    let wanted = RecordOptions { width, dataset: options.dataset, finer, daylight };
    let first = home.clone();
    let mut recorder = Recorder::create(options.folder(), home, me, &task, wanted).map_err(Complaint::new)?;
    let mut policy = options.policy.policy();
    let episode = match team(options, recorder.environment().graph(), &task) {
        Some(team) => act_together(options, team, &task, &mut recorder)?,
        None => act(options, me, &task, policy.as_mut(), &mut recorder)?,
    };
    let (metres, seconds) = (recorder.metres(), recorder.seconds());
    let same = leads_there(first, &recorder);
    let belief = belief(recorder.environment().graph(), &task, policy.as_ref());
    let page = recorder.finish(episode.clone(), belief.as_deref()).map_err(Complaint::new)?;
    say!(
        "\n{:?}: {} actions, {metres:.1} m, {seconds:.0} s in the home, {:.0}% of the goal holds",
        episode.outcome,
        episode.steps,
        100.0 * episode.score
    );
    say!("done again from the beginning: the home is {}", if same { "the same" } else { "ANOTHER" });
    say!("look at {}, made in {:.1} s", page.display(), start.elapsed().as_secs_f32());
    match (episode.outcome, episode.reason) {
        (Outcome::Won, _) if same => Ok(()),
        (Outcome::Won, _) => Err(Complaint::new("the same actions do not lead to the same home")),
        (_, reason) => Err(Complaint::new(reason.unwrap_or_else(|| "the goal was not reached".into()))),
    }
}

fn room(home: &Environment, id: NodeId) -> String {
    home.graph().room_of(id).map_or_else(|| "no room".into(), |r| home.graph().label(r).to_string())
}

fn bar(options: &Options) -> Result<ProgressBar, Complaint> {
    let bar = ProgressBar::new(options.steps as u64);
    bar.set_style(ProgressStyle::with_template("{spinner} {pos} actions: {msg}").map_err(Complaint::new)?);
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    Ok(bar)
}

/// Lets the policy act until it stops, and reports its actions.
fn act(
    options: &Options,
    me: NodeId,
    task: &Task,
    policy: &mut dyn Policy,
    recorder: &mut Recorder,
) -> Result<Summary, Complaint> {
    let bar = bar(options)?;
    let run = EpisodeOptions { agent: Some(me), ..EpisodeOptions::seeded(options.seed()) };
    let mut lines = Lines::of(recorder.graph());
    let episode = run.episode(policy, task, recorder, &mut |step| {
        bar.inc(1);
        bar.set_message(step.described.clone());
        bar.suspend(|| lines.next(step));
    });
    bar.finish_and_clear();
    lines.end(recorder.environment(), me);
    Ok(episode.summary())
}

/// The agents as a team, if there are several and they plan.
fn team(options: &Options, graph: &SceneGraph, task: &Task) -> Option<Team> {
    let ids = graph.agents();
    match options.policy {
        _ if ids.len() < 2 => None,
        Who::Planner => Some(Team::in_known_home(graph, ids, &task.goal, options.seed())),
        Who::Oracle => Some(Team::oracles(graph, ids, &task.goal)),
        Who::Faithful | Who::Random => None,
    }
}

/// Lets a team act until it stops, and reports each agent's actions.
fn act_together(options: &Options, mut team: Team, task: &Task, recorder: &mut Recorder) -> Result<Summary, Complaint> {
    let bar = bar(options)?;
    let done = team.run(task, &mut Told { recorder: &mut *recorder, bar: &bar });
    bar.finish_and_clear();
    Ok(Summary::from(&done))
}

/// A world that reports the actions in it.
struct Told<'a> {
    recorder: &'a mut Recorder,
    bar: &'a ProgressBar,
}

impl World for Told<'_> {
    fn graph(&self) -> &SceneGraph {
        self.recorder.graph()
    }

    fn history(&self) -> &History {
        self.recorder.history()
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        self.step_together(&[(agent, *action)]).pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }

    fn step_together(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, WorldError>> {
        let words = |(agent, action): &(NodeId, Action)| {
            format!("{}: {}", self.recorder.graph().label(*agent), action.describe(self.recorder.graph()))
        };
        let words: Vec<String> = actions.iter().map(words).collect();
        let done = self.recorder.step_together(actions);
        for (words, done) in words.into_iter().zip(&done) {
            self.bar.inc(1);
            self.bar.set_message(words.clone());
            let (number, why) = (self.bar.position(), done.as_ref().err().map(|why| format!("\n     {why}")));
            self.bar.suspend(|| say!("{number:>3}  {words}{}", why.unwrap_or_default()));
        }
        done
    }

    fn has_clock(&self) -> bool {
        self.recorder.has_clock()
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        self.recorder.reset(graph)
    }
}

/// Whether trying the actions of a record again from the initial state leads to the same home.
fn leads_there(mut first: Environment, record: &Recorder) -> bool {
    for actions in record.attempts() {
        // An action that failed then fails now.
        let _ = first.set_actions(actions);
    }
    first.digest() == record.environment().digest()
}

/// The final belief about the objects in the goal, as a picture.
pub(crate) fn belief(graph: &SceneGraph, task: &Task, policy: &dyn Policy) -> Option<String> {
    let mut things = objects_of_interest(graph, &task.goal);
    things.retain(|id| graph.node(*id).is_some_and(|n| n.affords(Property::Graspable)));
    things.truncate(BELIEVED);
    policy.belief().filter(|_| !things.is_empty()).map(|b| b.to_svg(&things))
}

/// Prints for each action where it led and which objects were first seen then; both are known when the next
/// action begins.
struct Lines {
    graph: SceneGraph,
    waiting: Option<Step>,
}

impl Lines {
    fn of(graph: &SceneGraph) -> Self {
        Self { graph: graph.clone(), waiting: None }
    }

    fn next(&mut self, step: &Step) {
        let news = self.news(&step.found);
        match self.waiting.replace(step.clone()) {
            Some(done) => say!("{}", line(&done, step.room.as_deref(), &news)),
            None => say!("  0  {:<42} in {}{news}", "look around", step.room.as_deref().unwrap_or("no room")),
        }
    }

    fn end(self, home: &Environment, me: NodeId) {
        if let Some(done) = self.waiting {
            say!("{}", line(&done, Some(&room(home, me)), ""));
        }
    }

    /// Names the new objects, graspable ones first.
    fn news(&self, found: &[String]) -> String {
        let is_small = |label: &Label| self.graph.node(label.id).is_some_and(|n| n.affords(Property::Graspable));
        let mut labels: Vec<Label> = found.iter().filter_map(|text| text.parse().ok()).collect();
        labels.sort_by_key(|label| !is_small(label));
        let mut named: Vec<String> = labels.iter().take(NAMED).map(ToString::to_string).collect();
        match labels.len() {
            0 => return String::new(),
            all if all > NAMED => named.push(format!("{} more", all - NAMED)),
            _ => {}
        }
        format!("; new: {}", named.join(", "))
    }
}

fn line(step: &Step, room: Option<&str>, news: &str) -> String {
    let why = step.refused.as_ref().map(|why| format!("\n     {why}")).unwrap_or_default();
    format!("{:>3}  {:<42} in {}{news}{why}", step.step, step.described, room.unwrap_or("no room"))
}
