//! A language model as a policy. The user supplies the model as a closure from a prompt to an answer, so any
//! library, server or recording will do.

mod answer;

use std::fmt::Write as _;

use vc_graph::{Action, NodeId, NodeKind, Observation, Property, Relation, SceneGraph, Verb, Word, rule};
use vc_tasks::WorldError;

use crate::policy::{EpisodeStart, Policy, RefusalResponse};
use crate::{Decision, Learned, Plan, Unreachable};

pub use answer::{Answer, AnswerError, read_answer};

/// How often the model is asked again after an unusable answer.
const RETRIES: usize = 3;
/// The maximal nesting depth of things that is followed.
const DEEPEST: usize = 16;
/// Number of past actions in a prompt.
const REMEMBERED: usize = 30;

/// A prompt for a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Prompt {
    /// The role and the answer format; the same for a whole episode.
    pub system: String,
    /// The task, the visible things, the past actions and the possible actions.
    pub user: String,
    /// The actions that can be done now, in the syntax of answers.
    pub actions: Vec<String>,
    /// A JSON schema of answers: one of the actions, or `done`.
    pub schema: serde_json::Value,
}

/// A policy that asks a language model for each action.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{LanguageModel, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut answers = ["walk apple.3", "grab apple.3", "done"].into_iter();
/// let mut model = LanguageModel::new(|_prompt| answers.next().map(str::to_owned).ok_or("no answer".to_owned()));
/// let task = Task::new("fetch", "Holds(apple)".parse()?);
/// assert_eq!(run_episode(&mut model, &task, &mut world).outcome, Outcome::Won);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct LanguageModel<F> {
    ask: F,
    agent: NodeId,
    goal: String,
    scene: Option<SceneGraph>,
    seen: Option<Observation>,
    past: Vec<String>,
    /// The error in the last answer.
    wrong: Option<String>,
    refusals: usize,
}

impl<F: FnMut(&Prompt) -> Result<String, String>> LanguageModel<F> {
    /// A policy that asks a closure. An error of the closure ends the episode.
    pub fn new(ask: F) -> Self {
        let (goal, past) = (String::new(), Vec::new());
        Self { ask, agent: NodeId(0), goal, scene: None, seen: None, past, wrong: None, refusals: 0 }
    }

    fn prompt(&self, graph: &SceneGraph, seen: &Observation) -> Prompt {
        let actions: Vec<String> =
            legal_actions(graph, self.agent).iter().map(|a| a.describe(graph).to_string()).collect();
        let mut user = format!("Task: {}\n\nYou see:\n{}", self.goal, describe_seen(seen));
        let start = self.past.len().saturating_sub(REMEMBERED);
        let _ = write!(user, "\nYou have done:\n{}\n", self.past[start..].join("\n"));
        if let Some(wrong) = &self.wrong {
            let _ = write!(user, "\nYour last answer was not possible: {wrong}\n");
        }
        let _ = write!(user, "\nYou can:\n{}\ndone\n", actions.join("\n"));
        let mut words = actions.clone();
        words.push("done".into());
        let schema = serde_json::json!({
            "type": "object",
            "properties": { "action": { "type": "string", "enum": words } },
            "required": ["action"],
        });
        Prompt { system: SYSTEM.into(), user, actions, schema }
    }
}

const SYSTEM: &str = "You are a person in a home. You see only the room you are in, and not into closed \
containers. Answer with one action at a time, as JSON {\"action\": \"grab cup.12\"} or as plain text. Answer \
`done` when the task is done.";

/// The actions that an agent can do now at its position: those that [`rule::legal_actions_with`] lists for the
/// things in its room that are not inside closed containers, without running and finding, and walks to the
/// other rooms.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::language::legal_actions;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// assert!(legal_actions(&graph, me).contains(&"walk apple.3".parse()?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn legal_actions(graph: &SceneGraph, agent: NodeId) -> Vec<Action> {
    let Some(room) = graph.room_of(agent) else { return Vec::new() };
    let here: Vec<NodeId> = graph.in_room(room).filter(|&id| id != agent && graph.hidden_in(id).is_none()).collect();
    let other_rooms = graph.rooms().iter().copied().filter(|&r| r != room);
    let walks = other_rooms.map(|r| Action::one(Verb::Walk, r)).filter(|a| rule::allows(graph, agent, a));
    let mut all = rule::legal_actions_with(graph, agent, &here);
    all.retain(|action| !matches!(action.verb, Verb::Run | Verb::Find));
    // Actions without an object are the least likely to be meant.
    all.sort_by_key(|action| action.object.is_none());
    walks.chain(all).collect()
}

/// An observation as text: the agent's position and the things at hand, then a line for each thing with its
/// place and state.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Scope};
/// use vc_planner::language::describe_seen;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let text = describe_seen(&graph.observe(me, Scope::Room));
/// assert!(text.contains("fridge.2 (closed") && !text.contains("milk"));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
pub fn describe_seen(seen: &Observation) -> String {
    let mut text = describe_self(seen);
    for node in seen.nodes().filter(|n| n.kind() == NodeKind::Object) {
        let _ = write!(text, "{}", node.label());
        let states: Vec<&str> = node.states().iter().map(|s| s.as_str()).collect();
        if !states.is_empty() {
            let _ = write!(text, " ({})", states.join(", "));
        }
        for place in seen.places(node.id()) {
            if let Some(at) = seen.get(place.at) {
                let _ = write!(text, " {} {}", place.relation.as_str(), at.label());
            }
        }
        let room = seen.room_of(node.id()).filter(|_| seen.places(node.id()).next().is_none());
        if let Some(room) = room.and_then(|room| seen.get(room)) {
            let stands = if node.affords(Property::Graspable) { "on the floor of" } else { "in" };
            let _ = write!(text, " {stands} {}", room.label());
        }
        text.push('\n');
    }
    for edge in seen.related(seen.agent(), Relation::HoldsRight).chain(seen.related(seen.agent(), Relation::HoldsLeft))
    {
        if let Some(held) = seen.get(edge.to) {
            let _ = writeln!(text, "You hold {}.", held.label());
        }
    }
    text
}

/// The agent's room and support, and the things at hand.
fn describe_self(seen: &Observation) -> String {
    let me = seen.agent();
    let mut text = String::from("You are");
    if let Some(room) = seen.room().and_then(|room| seen.get(room)) {
        let _ = write!(text, " in {}", room.label());
    }
    for place in seen.places(me) {
        if let Some(at) = seen.get(place.at) {
            let _ = write!(text, ", {} {}", place.relation.as_str(), at.label());
        }
    }
    let near: Vec<NodeId> = seen.related(me, Relation::Near).map(|edge| edge.to).collect();
    // The contents of a thing at hand are at hand, too.
    let down = |id: &NodeId| seen.places(*id).next().map(|place| place.at);
    let within_reach = |id| std::iter::successors(Some(id), down).take(DEEPEST).any(|at| near.contains(&at));
    let objects = seen.nodes().filter(|n| n.kind() == NodeKind::Object && within_reach(n.id()));
    let at_hand: Vec<String> = objects.map(|n| n.label().to_string()).collect();
    let at_hand = if at_hand.is_empty() { "nothing".into() } else { at_hand.join(", ") };
    let _ = writeln!(text, ". At hand: {at_hand}.");
    text
}

impl<F: FnMut(&Prompt) -> Result<String, String>> Policy for LanguageModel<F> {
    fn name(&self) -> &str {
        "language model"
    }

    fn knows_when_to_stop(&self) -> bool {
        false
    }

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        self.agent = start.agent;
        self.goal = format!(
            "{}. The task is done when: {}",
            start.task.title,
            start.task.goal.expanded(start.scene.vocabulary())
        );
        self.scene = Some(start.scene.clone());
        (self.past, self.wrong, self.refusals) = (Vec::new(), None, 0);
    }

    fn see(&mut self, seen: &Observation) -> Learned {
        self.seen = Some(seen.clone());
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        let (Some(scene), Some(seen)) = (&self.scene, &self.seen) else { return Decision::Done };
        // The graph contains only observed things: a model is not told what the agent cannot know.
        let graph = seen.to_graph(scene);
        for _ in 0..=RETRIES {
            let prompt = self.prompt(&graph, seen);
            let text = match (self.ask)(&prompt) {
                Ok(text) => text,
                Err(why) => return Decision::GiveUp(Unreachable::NoAnswer(why)),
            };
            match read_answer(&text, &graph) {
                Ok(Answer::Done) => return Decision::Done,
                Ok(Answer::Act(action)) => return Decision::Act(action, Plan::default()),
                Err(why) => self.wrong = Some(why.to_string()),
            }
        }
        Decision::GiveUp(Unreachable::NoAnswer(self.wrong.clone().unwrap_or_default()))
    }

    fn did(&mut self, action: &Action) {
        let text = self.scene.as_ref().map_or_else(|| action.to_string(), |g| action.describe(g).to_string());
        self.past.push(text);
        (self.wrong, self.refusals) = (None, 0);
    }

    fn refused(&mut self, action: &Action, why: &WorldError) -> RefusalResponse {
        self.refusals += 1;
        self.wrong = Some(format!("`{action}`: {why}"));
        if self.refusals <= RETRIES { RefusalResponse::GoOn } else { RefusalResponse::Stop }
    }
}
