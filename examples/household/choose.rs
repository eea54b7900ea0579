//! Choosing the task.

use std::cmp::Reverse;

use vc_graph::{Action, NodeId, Verb};
use vc_planner::Planner;
use vc_tasks::{Task, World};

use crate::Options;
use crate::support::Complaint;

/// The requested goal or task; without one, the most varied task of the library that is meaningful in this home
/// and not done already.
pub(crate) fn choose(options: &Options, world: &dyn World, me: NodeId) -> Result<Task, Complaint> {
    if let Some(goal) = &options.goal {
        return told(options, goal, world);
    }
    let open = |task: &Task| task.obstacles(world.graph()).is_empty() && !task.holds(world, me);
    let all: Vec<Task> = vc_tasks::household().into_iter().filter(open).collect();
    let wanted_title = options.task.as_deref().unwrap_or_default().to_lowercase();
    let wanted = |task: &&Task| task.title.to_lowercase().starts_with(&wanted_title);
    // Iterates in reverse, since `max_by_key` returns the last of equals.
    let best = all.iter().filter(wanted).rev().max_by_key(|task| to_see(world, me, task));
    let task = best.ok_or_else(|| {
        let titles: Vec<&str> = all.iter().map(|task| task.title.as_str()).collect();
        Complaint::new(format!("no such task makes sense here; these do: {}", titles.join(", ")))
    })?;
    Ok(Task { step_limit: options.steps, ..task.clone() })
}

/// The goal of a text as a task, if it is meaningful in this home.
pub(crate) fn told(options: &Options, goal: &str, world: &dyn World) -> Result<Task, Complaint> {
    let goal = goal.parse().map_err(Complaint::new)?;
    let task = Task { title: "a goal of your own".into(), goal, step_limit: options.steps };
    let obstacles: Vec<String> = task.obstacles(world.graph()).iter().map(ToString::to_string).collect();
    match obstacles.is_empty() {
        true => Ok(task),
        false => Err(Complaint::new(format!("this goal makes no sense here:\n  {}", obstacles.join("\n  ")))),
    }
}

/// How much a task shows: first the number of kinds of actions (going, opening, taking, carrying, putting down)
/// in a plan by an agent that knows where everything is, then how few actions the plan has.
fn to_see(world: &dyn World, me: NodeId, task: &Task) -> (usize, Reverse<usize>) {
    let plan = Planner::default().plan(&mut world.graph().clone(), me, &task.goal, &[]);
    let actions = plan.map(|plan| plan.actions).unwrap_or_default();
    let does = |verbs: &&[Verb]| actions.iter().any(|action: &Action| verbs.contains(&action.verb));
    let of_interest: [&[Verb]; 4] = [&[Verb::Walk], &[Verb::Open], &[Verb::Grab], &[Verb::Place, Verb::PutIn]];
    let taken = actions.iter().skip_while(|action| action.verb != Verb::Grab);
    let carries = taken.skip(1).any(|action| action.verb == Verb::Walk);
    (of_interest.into_iter().filter(does).count() + usize::from(carries), Reverse(actions.len()))
}
