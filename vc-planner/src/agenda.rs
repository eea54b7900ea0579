//! Goals with words of time, taken apart into stages: what comes next, and what must stay so meanwhile.
//!
//! This is the progression of a formula (Bacchus and Kabanza, *Using temporal logics to express search control
//! knowledge for planning*, 2000): at each step what has come about is struck off, and what is left is a goal on the
//! rest of the episode.

mod part;

use vc_graph::NodeId;
use vc_graph::goal::{Goal, Situation};

use crate::KnownNodes;
use crate::open_condition::Unreachable;
use crate::subgoal::View;
use crate::subgoal::hints::Hints;
use part::Part;

/// A step as an agent sees it.
#[derive(Clone, Copy)]
pub(crate) struct Moment<'a> {
    /// The sampled state, and all that the agent has done.
    pub(crate) now: Situation<'a>,
    pub(crate) known: &'a KnownNodes,
    /// Everything is known: whether a goal holds can be seen.
    pub(crate) knows_all: bool,
    /// How many actions had been done before this step.
    since: usize,
}

impl Moment<'_> {
    /// The present step of a situation.
    pub(crate) fn new<'a>(now: Situation<'a>, known: &'a KnownNodes, knows_all: bool) -> Moment<'a> {
        Moment { now, known, knows_all, since: now.events.len().saturating_sub(1) }
    }

    /// How many actions have been done: the number of the step.
    fn step(&self) -> usize {
        self.now.events.len()
    }

    /// Whether a goal is known to hold, by what was done after so many actions.
    fn holds_since(&self, goal: &Goal, since: usize) -> bool {
        let now = Situation { events: self.now.events.get(since..).unwrap_or_default(), ..self.now };
        if self.knows_all {
            return goal.holds(&now);
        }
        let view = View { now, known: self.known, unseen: &[], hints: &Hints::new(goal) };
        view.subgoals(goal).is_ok_and(|open| open.is_empty())
    }

    /// Whether a goal is known to hold at this step, by what was done in it.
    fn holds(&self, goal: &Goal) -> bool {
        self.holds_since(goal, self.since)
    }

    /// Whether a goal is known not to hold at this step.
    fn fails(&self, goal: &Goal) -> bool {
        self.holds(&negated(goal))
    }

    /// The same state, as the first of a stretch in which nothing has been done.
    fn anew(&self) -> Self {
        Self { since: self.step(), ..*self }
    }

    fn range(&self, class: Option<&str>) -> Vec<NodeId> {
        match class {
            Some(class) => self.now.graph.of_class(class),
            None => self.now.graph.nodes().map(vc_graph::Node::id).collect(),
        }
    }
}

fn negated(goal: &Goal) -> Goal {
    Goal::Not(Box::new(goal.clone()))
}

/// A condition on each step until an aim is reached.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Guard {
    pub(crate) goal: Goal,
    /// The part of the goal that it comes from.
    pub(crate) part: String,
    /// It must hold at the step at which the aim is reached as well.
    pub(crate) to_the_end: bool,
}

/// The part of a goal to be pursued next.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Aim {
    /// A goal without words of time.
    pub(crate) goal: Goal,
    /// Actions before this number do not count.
    pub(crate) since: usize,
    /// The number of the last step at which it may be reached, and the part that says so.
    pub(crate) by: Option<(usize, String)>,
    pub(crate) guards: Vec<Guard>,
    /// When it holds, the whole goal does.
    pub(crate) is_last: bool,
    /// A part that cannot be planned for.
    pub(crate) beyond: Option<String>,
}

/// The remainder of a goal with words of time.
#[derive(Debug, Clone)]
pub(crate) struct Agenda {
    goal: Goal,
    left: Option<Part>,
    /// The last step of which it took note.
    noted: usize,
}

impl Agenda {
    pub(crate) fn new(goal: &Goal) -> Self {
        Self { goal: goal.clone(), left: None, noted: 0 }
    }

    pub(crate) fn goal(&self) -> &Goal {
        &self.goal
    }

    /// The goal to be brought about next.
    ///
    /// # Errors
    /// [`Unreachable::Broken`] if a part can no longer hold, whatever is done.
    pub(crate) fn aim(&mut self, moment: &Moment<'_>) -> Result<Aim, Unreachable> {
        let step = moment.step();
        let (left, is_new) = match self.left.take() {
            Some(left) => (left, step != self.noted),
            None => (Part::new(&self.goal, &moment.anew()), true),
        };
        let left = self.left.insert(left);
        self.noted = step;
        if is_new {
            left.note(moment).map_err(|part| Unreachable::Broken(part.to_string()))?;
        }
        Ok(left.aim(step))
    }

    /// Goes on with another alternative of the goal; `false` if there is none.
    pub(crate) fn go_otherwise(&mut self) -> bool {
        self.left.as_mut().is_some_and(Part::go_otherwise)
    }
}
