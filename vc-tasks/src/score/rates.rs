//! Scores that count conditions.

use std::borrow::Cow;

use vc_graph::Goal;
use vc_graph::goal::{Comparison, EpisodeTrace, Situation};

use crate::compile::{Bits, GoalProgram};

/// The number of fulfilled conditions of a goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Conditions {
    /// The fulfilled conditions.
    pub satisfied: u32,
    /// All conditions.
    pub conditions: u32,
}

impl Conditions {
    /// The share, 0 to 1; 1 if there are no conditions.
    pub fn rate(self) -> f64 {
        if self.conditions == 0 { 1.0 } else { f64::from(self.satisfied) / f64::from(self.conditions) }
    }
}

impl GoalProgram {
    /// ALFRED's goal-condition rate: the share of the goal's conjuncts that hold. (ALFRED's own
    /// conditions are the conjuncts of its templates.)
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table) & Holds(apple)".parse()?, &now)?;
    /// assert_eq!(program.conditions(&program.read(&now)).rate(), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn conditions(&self, bits: &Bits) -> Conditions {
        let satisfied = (0..self.heads()).filter(|&head| self.head_holds(bits, head)).count();
        Conditions { satisfied: satisfied as u32, conditions: self.heads() as u32 }
    }
}

/// PARTNR's percent complete: the share of the goal's propositions that were satisfied in the trace
/// and not undone where they must last. Propositions are the conjuncts; "at least n" is n of them,
/// as many of which are satisfied as objects were found. A proposition that need not last is
/// written with `eventually`, one that comes after another with `before` or `then`.
///
/// ```
/// use vc_graph::goal::EpisodeTrace;
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_tasks::score::percent_complete;
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("fridge"))?;
/// let me = scene.add(Draft::new("character"))?;
/// let trace = EpisodeTrace::new(scene.build(), me);
/// assert_eq!(percent_complete(&"Closed(fridge) & Open(fridge)".parse()?, &trace).rate(), 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn percent_complete(goal: &Goal, trace: &EpisodeTrace) -> Conditions {
    let last = trace.situation(trace.steps());
    let goal = &*last.map_or(Cow::Borrowed(goal), |now| goal.expanded(now.graph.vocabulary()));
    let mut sum = Conditions { satisfied: 0, conditions: 0 };
    for part in goal.conjuncts() {
        let (satisfied, conditions) = match counted(part).zip(last) {
            Some(((one, number), now)) => (found(&one, number, &now), number),
            None => (u32::from(part.holds_on(trace)), 1),
        };
        sum = Conditions { satisfied: sum.satisfied + satisfied, conditions: sum.conditions + conditions };
    }
    sum
}

/// A goal of the form "at least n", as a function of the number.
fn counted(goal: &Goal) -> Option<(impl Fn(u32) -> Goal, u32)> {
    let number = match goal {
        Goal::Count { comparison: Comparison::AtLeast, number, .. } => *number,
        Goal::ForN { comparison: Comparison::AtLeast, number, of } if !of.body.is_temporal() => *number,
        _ => return None,
    };
    let with = move |wanted: u32| {
        let mut goal = goal.clone();
        if let Goal::Count { number, .. } | Goal::ForN { number, .. } = &mut goal {
            *number = wanted;
        }
        goal
    };
    Some((with, number))
}

/// The largest number up to `number` for which the goal holds.
fn found(goal: &impl Fn(u32) -> Goal, number: u32, now: &Situation<'_>) -> u32 {
    (1..=number).take_while(|&n| goal(n).holds(now)).last().unwrap_or(0)
}
