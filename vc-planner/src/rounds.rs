//! Policies that act in one world in rounds.

use vc_graph::{Event, NodeId, Seed};
use vc_tasks::{Outcome, Task, World};

use crate::policy::{EpisodeStart, Policy};
use crate::reason::{explained, refusal};
use crate::{Decision, TeamEpisode, Unreachable};

/// After so many rounds in which nobody does anything it is over.
const IDLE: usize = 4;

/// Lets several policies act in one world, in rounds, each for an agent of its own, until
/// the task's goal holds for the first of them, nobody does anything any more, or the
/// step limit is reached. Each agent sees what the agents in its view do. Without a policy, or if the goal has a name
/// that stands for nothing or somebody is no agent of the scene, the task is lost at once.
pub fn run_together(
    policies: &mut [(NodeId, &mut dyn Policy)],
    task: &Task,
    world: &mut dyn World,
    seed: Seed,
) -> TeamEpisode {
    let ids: Vec<NodeId> = policies.iter().map(|(id, _)| *id).collect();
    if let Some(lost) = TeamEpisode::hopeless(&ids, task, world.graph()) {
        return lost;
    }
    for (agent, policy) in policies.iter_mut() {
        policy.begin(&EpisodeStart { scene: world.graph(), agent: *agent, task, seed });
    }
    let mut progress = task.begin(world, policies[0].0);
    let (mut rounds, mut actions, mut idle, mut reasons) = (0, 0, 0, Vec::new());
    while rounds < task.step_limit && idle < IDLE && !progress.holds(world) {
        reasons.clear();
        let mut done = 0;
        for index in 0..policies.len() {
            match turn(policies, index, world) {
                Turn::Done => done += 1,
                Turn::Waited => {}
                Turn::GaveUp(why) => reasons.push(explained(&why, task, world.graph())),
                Turn::Refused(why) => reasons.push(why),
            }
            progress.note(world);
        }
        (rounds, actions) = (rounds + 1, actions + done);
        idle = if done == 0 { idle + 1 } else { 0 };
    }
    let lost = if rounds < task.step_limit { Outcome::Lost } else { Outcome::TimedOut };
    let outcome = if progress.holds(world) { Outcome::Won } else { lost };
    TeamEpisode::ended(outcome, (rounds, actions), reasons, &mut progress, world)
}

/// The result of a policy's turn.
enum Turn {
    Done,
    Waited,
    GaveUp(Unreachable),
    Refused(String),
}

/// One policy looks, decides and acts; the others see it, if they can.
fn turn(policies: &mut [(NodeId, &mut dyn Policy)], index: usize, world: &mut dyn World) -> Turn {
    let (agent, policy) = &mut policies[index];
    let agent = *agent;
    policy.see(&world.graph().observe(agent, policy.scope()));
    let action = match policy.decide() {
        Decision::Act(action, _) => action,
        Decision::Done => return Turn::Waited,
        Decision::GiveUp(why) => return Turn::GaveUp(why),
    };
    let words = action.describe(world.graph()).to_string();
    // An agent that goes out of view has been seen going.
    let witnesses = |world: &dyn World, policies: &[(NodeId, &mut dyn Policy)]| -> Vec<bool> {
        policies.iter().map(|(id, p)| *id != agent && world.graph().observe(*id, p.scope()).sees(agent)).collect()
    };
    let before = witnesses(world, policies);
    match world.step(agent, &action) {
        Ok(_) => {
            policies[index].1.did(&action);
            let after = witnesses(world, policies);
            for (i, (_, other)) in policies.iter_mut().enumerate().filter(|(i, _)| before[*i] || after[*i]) {
                debug_assert_ne!(i, index);
                other.saw(&Event { agent, action });
            }
            Turn::Done
        }
        Err(why) => {
            policies[index].1.refused(&action, &why);
            Turn::Refused(refusal(&words, &why))
        }
    }
}
