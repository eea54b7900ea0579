//! Goal recognition: the goal of an agent, inferred from its actions.

use vc_graph::portable::Portable;
use vc_graph::{Event, Goal, SceneGraph, Verb};

use crate::{Planner, SearchLimits};

/// Infers which of some goals an agent pursues, from its actions in view: an action
/// that brings a goal nearer speaks for it (Ramirez and Geffner, AAAI 2010; inverse
/// planning, Baker, Saxe and Tenenbaum 2009).
///
/// ```
/// use vc_graph::Goal;
/// use vc_planner::GoalRecognizer;
/// let goals: Vec<Goal> = vec!["Open(fridge)".parse()?, "Open(stove)".parse()?];
/// let recognizer = GoalRecognizer::new(goals);
/// assert!(recognizer.likely().iter().all(|(_, chance)| (*chance - 0.5).abs() < 1e-9), "nothing was watched yet");
/// # Ok::<(), vc_graph::goal::GoalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct GoalRecognizer {
    goals: Vec<Goal>,
    /// Logarithms of how well each explains what was seen.
    weights: Vec<f64>,
    planner: Planner,
}

/// How much an action that does not bring a goal nearer speaks against it: something was
/// taken, put or used.
const AGAINST: f64 = 2.5;
/// How much going somewhere or looking into something does: an agent that does not know where
/// things are has to.
const ASTRAY: f64 = 0.2;

impl GoalRecognizer {
    /// A recognizer to which all of these goals are equally likely at first.
    pub fn new(goals: Vec<Goal>) -> Self {
        let weights = vec![0.0; goals.len()];
        Self { goals, weights, planner: Planner { limits: SearchLimits::FIRST_ANSWER, ..Planner::default() } }
    }

    /// Takes note of an action that another did: the scene before it and after it.
    pub fn watch(&mut self, before: &SceneGraph, after: &SceneGraph, event: &Event) {
        for (goal, weight) in self.goals.iter().zip(&mut self.weights) {
            let mut left = |graph: &SceneGraph, events: &[Event]| {
                self.planner
                    .plan(&mut graph.clone(), event.agent, goal, events)
                    .map_or(f64::INFINITY, |p| p.actions.len() as f64)
            };
            let (was, is) = (left(before, &[]), left(after, std::slice::from_ref(event)));
            // A goal that cannot be planned for is left as it is.
            if was.is_finite() && is >= was {
                let looking =
                    matches!(event.action.verb, Verb::Walk | Verb::Run | Verb::Find | Verb::Open | Verb::Close);
                *weight -= if looking { ASTRAY } else { AGAINST };
            }
        }
    }

    /// The goals with how likely they are; they sum to one. Likeliest first, then in
    /// the order given.
    pub fn likely(&self) -> Vec<(&Goal, f64)> {
        let most = self.weights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let raw: Vec<f64> = self.weights.iter().map(|w| (w - most).exponential()).collect();
        let sum: f64 = raw.iter().sum();
        let mut all: Vec<(&Goal, f64)> = self.goals.iter().zip(raw.iter().map(|w| w / sum)).collect();
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        all
    }
}
