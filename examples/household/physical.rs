//! The run with bodies.

use std::io::Write;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use nalgebra::Point2;
use vc_graph::goal::Situation;
use vc_graph::{Node, NodeId, Property, Scope, State};
use vc_planner::{Agent, Decision, Horizon};
use vc_tasks::{Outcome, Task};
use virtualcity::Environment;

use crate::film::Film;
use crate::support::{Complaint, say};
use crate::symbolic::summary;
use crate::{Options, page};

/// How a run with bodies went.
pub(crate) struct Run {
    pub(crate) home: String,
    pub(crate) task: Task,
    pub(crate) outcome: Outcome,
    pub(crate) reason: Option<String>,
    /// Every action, as it is written, and seconds of the home's time after it.
    pub(crate) actions: Vec<(String, f64)>,
    /// The way the agent went, metres.
    pub(crate) way: Vec<Point2<f32>>,
    pub(crate) score: f64,
}

/// Makes the home, lets the agent act, and writes the folder.
pub(crate) fn main(options: &Options) -> Result<(), Complaint> {
    let start = Instant::now();
    std::fs::create_dir_all(&options.out).map_err(Complaint::new)?;
    let name = match &options.scene {
        Some(file) => format!("scene:{}", file.display()),
        None => format!("apartment/{}", options.seed),
    };
    let mut home = Environment::make(&name, options.agents.max(1)).map_err(Complaint::new)?;
    light_up(&mut home)?;
    let me = home.agents()[0];
    let task = choose(options, &home)?;
    say!("home   {name}: {} rooms, {} nodes", home.graph().rooms().len(), home.graph().len());
    say!("agent  {} in {}", home.graph().label(me), room(&home, me));
    say!("task   {}: {}\n", task.title, task.goal);
    let mut film = Film::new(&home, me, options.width);
    let run = act(options, home.clone(), me, task, &mut film)?;
    page::write(&options.out, &run, &film, &home)?;
    let metres: f32 = run.way.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
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

/// Looks, decides, acts, until the agent stops.
fn act(options: &Options, mut home: Environment, me: NodeId, task: Task, film: &mut Film) -> Result<Run, Complaint> {
    let name = home.graph().name().to_owned();
    let (mut agent, scope) = match options.full_knowledge {
        true => (Agent::resident(home.graph(), me, task.goal.clone()), Scope::Whole),
        false => (Agent::newcomer(home.graph(), me, task.goal.clone(), options.seed), Scope::Room),
    };
    agent = agent.planning(Horizon::Goal);
    let bar = ProgressBar::new_spinner();
    bar.set_style(ProgressStyle::with_template("{spinner} {msg}").map_err(Complaint::new)?);
    let mut record = Record::create(options, &home, &task)?;
    let (mut actions, mut way, mut time) = (Vec::new(), vec![film.feet(&home)], 0.0);
    let (mut outcome, mut reason) = loop {
        let learned = agent.see(&home.graph().observe(me, scope));
        let action = match agent.decide() {
            Decision::Act(..) if actions.len() == task.step_limit => {
                break (Outcome::TimedOut, Some("step limit reached".to_owned()));
            }
            Decision::Act(action, _) => action,
            Decision::Done => break (Outcome::Lost, None),
            Decision::GiveUp(why) => break (Outcome::Lost, Some(why.to_string())),
            _ => break (Outcome::Aborted, Some("the agent does something unheard of".to_owned())),
        };
        let words = action.describe(home.graph()).to_string();
        bar.println(step(&home, me, &learned.found, &words, actions.len() + 1));
        bar.set_message(format!("{words}: {} pictures", film.len()));
        film.title(&words);
        let mut ticks = 0_u32;
        let mut failed = None;
        let outcome = home.set_action_in_time(me, action, |now| {
            ticks += 1;
            way.push(film.feet(now));
            failed = film.tick(now).err().or(failed.take());
        });
        if let Some(error) = failed {
            return Err(error);
        }
        if let Err(why) = outcome {
            break (Outcome::Aborted, Some(why.to_string()));
        }
        agent.did(&action);
        time += f64::from(ticks) * f64::from(home.world().settings().dt);
        way.push(film.feet(&home));
        record.step(&home, me, &words, time)?;
        actions.push((words, time));
    };
    bar.finish_and_clear();
    film.last(&home)?;
    let now = Situation::new(home.graph(), me, home.history());
    if task.goal.holds(&now) {
        (outcome, reason) = (Outcome::Won, None);
    }
    let score = task.goal.score(&now);
    record.end(outcome, score, reason.as_deref())?;
    Ok(Run { home: name, task, outcome, reason, actions, way, score })
}

fn step(home: &Environment, me: NodeId, found: &[NodeId], words: &str, number: usize) -> String {
    let found: Vec<String> = found.iter().map(|id| home.graph().label(*id).to_string()).collect();
    let news = if found.is_empty() { String::new() } else { format!("; new: {}", summary(&found)) };
    format!("{number:>3}  {:<34} in {}{news}", words, room(home, me))
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

    fn step(&mut self, home: &Environment, me: NodeId, action: &str, time: f64) -> Result<(), Complaint> {
        let pose = home.graph().node(me).and_then(|n| n.pose());
        let at = pose.map(|p| [p.translation.x, p.translation.y, p.translation.z]);
        let held: Vec<String> = home.graph().held(me).map(|id| home.graph().label(id).to_string()).collect();
        self.line(&serde_json::json!({
            "step": home.history().events().len(), "time": time, "action": action, "at": at,
            "room": room(home, me), "held": held, "digest": home.digest().to_string(),
        }))
    }

    fn end(&mut self, outcome: Outcome, score: f64, reason: Option<&str>) -> Result<(), Complaint> {
        self.line(&serde_json::json!({"outcome": outcome, "score": score, "reason": reason}))
    }

    fn line(&mut self, value: &serde_json::Value) -> Result<(), Complaint> {
        writeln!(self.file, "{value}").and_then(|()| self.file.flush()).map_err(Complaint::new)
    }
}
