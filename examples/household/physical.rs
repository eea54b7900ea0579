//! The run with bodies.

use std::io::Write;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use nalgebra::Point2;
use vc_graph::goal::Situation;
use vc_graph::{Action, ChangeSet, History, Node, NodeId, Property, SceneGraph, State};
use vc_planner::{Run, Step, objects_of_interest};
use vc_tasks::{Outcome, Task, World, WorldError};
use virtualcity::Environment;

use crate::film::Film;
use crate::support::{Complaint, say};
use crate::symbolic::summary;
use crate::{Options, page};

/// How a run with bodies went.
pub(crate) struct Story {
    pub(crate) home: String,
    pub(crate) task: Task,
    pub(crate) outcome: Outcome,
    pub(crate) reason: Option<String>,
    /// Every action, as it is written, and seconds of the home's time after it.
    pub(crate) actions: Vec<(String, f64)>,
    /// The way the agent went, metres.
    pub(crate) way: Vec<Point2<f32>>,
    pub(crate) score: f64,
    /// What the agent believed in the end of the things that the goal is about.
    pub(crate) belief: Option<String>,
}

/// Most things of a picture of a belief.
const BELIEVED: usize = 16;

/// Makes the home, lets the agent act, and writes the folder.
pub(crate) fn main(options: &Options) -> Result<(), Complaint> {
    let start = Instant::now();
    std::fs::create_dir_all(&options.out).map_err(Complaint::new)?;
    let name = match &options.scene {
        Some(file) => format!("scene:{}", file.display()),
        None => format!("apartment/{}", options.seed),
    };
    let mut home = Environment::make(&name, options.agents.max(1)).map_err(Complaint::new)?;
    for (id, class) in home.left_out() {
        say!("left out  {class}.{}, which fell out of the home", id.0);
    }
    light_up(&mut home)?;
    let me = home.agents()[0];
    let task = choose(options, &home)?;
    say!("home   {name}: {} rooms, {} nodes", home.graph().rooms().len(), home.graph().len());
    say!("agent  {} in {}", home.graph().label(me), room(&home, me));
    say!("task   {}: {}\n", task.title, task.goal);
    let mut film = Film::new(&home, me, options.width);
    let run = act(options, home.clone(), me, task, &mut film)?;
    page::write(&options.out, &run, &film, &home)?;
    let metres: f32 = run.way.windows(2).fold(0.0, |sum, p| sum + (p[1] - p[0]).norm());
    say!(
        "\n{:?}: {} actions, {metres:.1} m, {:.0} s in the home, {:.0}% of the goal holds; {:.1} s here",
        run.outcome,
        run.actions.len(),
        run.actions.last().map_or(0.0, |a| a.1),
        100.0 * run.score,
        start.elapsed().as_secs_f32()
    );
    say!("look at {}", options.out.join("index.html").display());
    match (run.outcome, run.reason) {
        (Outcome::Won, _) => Ok(()),
        (_, reason) => Err(Complaint::new(reason.unwrap_or_else(|| "the goal was not reached".into()))),
    }
}

/// Switches the lamps of the home on, so that there is something to see in rooms without
/// windows.
fn light_up(home: &mut Environment) -> Result<(), Complaint> {
    let mut graph = home.graph().clone();
    let lamp = |n: &&Node| n.affords(Property::Switchable) && ["lamp", "light"].iter().any(|w| n.class().ends_with(w));
    let lamps: Vec<NodeId> = graph.nodes().filter(lamp).map(Node::id).collect();
    let mut edit = graph.edit();
    lamps.into_iter().try_for_each(|id| edit.enter_state(id, State::On)).map_err(Complaint::new)?;
    edit.commit();
    home.reset(&graph).map(drop).map_err(Complaint::new)
}

/// The task asked for, or the first of the library that makes sense in the home and is not
/// done already.
fn choose(options: &Options, home: &Environment) -> Result<Task, Complaint> {
    if let Some(goal) = &options.goal {
        let task =
            Task { title: "as told".into(), goal: goal.parse().map_err(Complaint::new)?, step_limit: options.steps };
        let obstacles: Vec<String> = task.obstacles(home.graph()).iter().map(ToString::to_string).collect();
        return match obstacles.is_empty() {
            true => Ok(task),
            false => Err(Complaint::new(format!("this goal makes no sense here:\n  {}", obstacles.join("\n  ")))),
        };
    }
    let me = home.agents()[0];
    let open = |t: &Task| {
        let now = Situation::new(home.graph(), me, home.history());
        t.obstacles(home.graph()).is_empty() && !t.goal.holds(&now)
    };
    let wanted = |t: &Task| options.task.as_ref().is_none_or(|title| t.title.starts_with(title.as_str()));
    let all = vc_tasks::household();
    // Of several the one with most to do, so that there is something to see.
    let fitting = all.iter().filter(|t| wanted(t) && open(t));
    let long = |t: &&Task| t.goal.to_string().len();
    let task = fitting.max_by_key(long).ok_or_else(|| {
        let titles: Vec<&str> = all.iter().filter(|t| open(t)).map(|t| t.title.as_str()).collect();
        Complaint::new(format!("no such task makes sense in this home; these do: {}", titles.join(", ")))
    })?;
    Ok(Task { step_limit: options.steps, ..task.clone() })
}

fn room(home: &Environment, id: NodeId) -> String {
    home.graph().room_of(id).map_or_else(|| "no room".into(), |r| home.graph().label(r).to_string())
}

/// Lets the policy act until it stops.
fn act(options: &Options, home: Environment, me: NodeId, task: Task, film: &mut Film) -> Result<Story, Complaint> {
    let name = home.graph().name().to_owned();
    let bar = ProgressBar::new_spinner();
    bar.set_style(ProgressStyle::with_template("{spinner} {msg}").map_err(Complaint::new)?);
    let record = Record::create(options, &home, &task)?;
    let way = vec![film.feet(&home)];
    let mut filmed = Filmed { home, film, record, bar: bar.clone(), way, time: 0.0, actions: Vec::new(), failed: None };
    let run = Run { agent: Some(me), ..Run::seeded(options.seed) };
    let mut policy = options.policy.policy();
    let episode = run.episode(policy.as_mut(), &task, &mut filmed, &mut |step| bar.suspend(|| say!("{}", line(step))));
    bar.finish_and_clear();
    let Filmed { home, film, mut record, way, actions, failed, .. } = filmed;
    if let Some(error) = failed {
        return Err(error);
    }
    film.last(&home)?;
    record.line(&serde_json::json!(episode.summary()))?;
    let (outcome, reason, score) = (episode.outcome, episode.reason, episode.score);
    let mut things = objects_of_interest(home.graph(), &task.goal);
    things.retain(|id| home.graph().node(*id).is_some_and(|n| n.affords(Property::Graspable)));
    things.truncate(BELIEVED);
    let belief = policy.belief().filter(|_| !things.is_empty()).map(|b| b.to_svg(&things));
    Ok(Story { home: name, task, outcome, reason, actions, way, score, belief })
}

/// A home that is filmed while somebody acts in it.
struct Filmed<'a> {
    home: Environment,
    film: &'a mut Film,
    record: Record,
    bar: ProgressBar,
    way: Vec<Point2<f32>>,
    /// The home's time, seconds.
    time: f64,
    actions: Vec<(String, f64)>,
    /// The first thing that went wrong with pictures and files.
    failed: Option<Complaint>,
}

impl Filmed<'_> {
    fn note(&mut self, outcome: Result<(), Complaint>) {
        self.failed = self.failed.take().or(outcome.err());
    }
}

impl World for Filmed<'_> {
    fn graph(&self) -> &SceneGraph {
        self.home.graph()
    }

    fn history(&self) -> &History {
        self.home.history()
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        let words = action.describe(self.home.graph()).to_string();
        self.bar.set_message(format!("{words}: {} pictures", self.film.len()));
        self.film.title(&words);
        let mut ticks = 0_u32;
        let mut failed = None;
        let done = self.home.set_action_in_time(agent, *action, |now| {
            ticks += 1;
            self.way.push(self.film.feet(now));
            failed = failed.take().or(self.film.tick(now).err());
        });
        self.note(failed.map_or(Ok(()), Err));
        self.time += f64::from(ticks) * f64::from(self.home.world().settings().dt);
        self.way.push(self.film.feet(&self.home));
        let why = done.as_ref().err().map(ToString::to_string);
        let noted = self.record.step(&self.home, agent, &words, self.time, why.as_deref());
        self.note(noted);
        let shown = if why.is_some() { format!("{words} (could not)") } else { words };
        self.actions.push((shown, self.time));
        done.map_err(WorldError::from)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.home, graph)
    }
}

fn line(step: &Step) -> String {
    let news = if step.found.is_empty() { String::new() } else { format!("; new: {}", summary(&step.found)) };
    let why = step.refused.as_ref().map(|why| format!("\n     {why}")).unwrap_or_default();
    let room = step.room.as_deref().unwrap_or("no room");
    format!("{:>3}  {:<34} in {room}{news}{why}", step.step, step.described)
}

/// The trajectory: a line about the run, one for each action, and the result.
struct Record {
    file: std::io::BufWriter<std::fs::File>,
}

impl Record {
    fn create(options: &Options, home: &Environment, task: &Task) -> Result<Self, Complaint> {
        let path = options.out.join("trajectory.jsonl");
        let file = std::fs::File::create(&path).map_err(|e| Complaint::new(format!("{}: {e}", path.display())))?;
        let mut record = Self { file: std::io::BufWriter::new(file) };
        record.line(&serde_json::json!({
            "scene": home.graph().name(), "digest": home.digest().to_string(),
            "task": task.title, "goal": task.goal, "seed": options.seed,
        }))?;
        Ok(record)
    }

    fn step(
        &mut self,
        home: &Environment,
        me: NodeId,
        action: &str,
        time: f64,
        refused: Option<&str>,
    ) -> Result<(), Complaint> {
        let pose = home.graph().node(me).and_then(|n| n.pose());
        let at = pose.map(|p| [p.translation.x, p.translation.y, p.translation.z]);
        let held: Vec<String> = home.graph().held(me).map(|id| home.graph().label(id).to_string()).collect();
        self.line(&serde_json::json!({
            "step": home.history().events().len(), "time": time, "action": action, "refused": refused,
            "at": at, "room": room(home, me), "held": held, "digest": home.digest().to_string(),
        }))
    }

    fn line(&mut self, value: &serde_json::Value) -> Result<(), Complaint> {
        writeln!(self.file, "{value}").and_then(|()| self.file.flush()).map_err(Complaint::new)
    }
}
