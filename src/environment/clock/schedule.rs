//! The schedule of an agent's action.

use std::collections::VecDeque;

use vc_graph::clock::{Span, Tick};
use vc_graph::{Action, ChangeSet, Effect, NodeId, Pose, SceneGraph, rule};

use super::track::{REACHING, Track};
use crate::environment::course::{BodyMotion, is_on_foot};
use crate::environment::execute::Task;
use crate::environment::step::RetryOptions;

/// Time in which a body sits down, lies down or gets up.
const SETTLING: Span = Span(60);

/// The schedule of an action. It grows by its events: what comes next is planned when a motion has been done.
#[derive(Debug, Clone)]
pub(super) struct Schedule {
    pub(super) action: Action,
    pub(super) care: RetryOptions,
    pub(super) tasks: VecDeque<Task>,
    /// Planned motions, which follow the current one.
    pub(super) motions: VecDeque<BodyMotion>,
    /// The motion that is under way.
    pub(super) motion: Option<BodyMotion>,
    /// The last motion that has been done, from which the hand comes back.
    pub(super) done: Option<BodyMotion>,
    /// Where the thing was that a hand has taken, against the feet.
    pub(super) picked: Option<Pose>,
    pub(super) phase: Phase,
    /// The tick in which the phase began.
    pub(super) begin: Tick,
    pub(super) track: Track,
    /// The tick of the next event; [`NEVER`] while it waits for bodies.
    pub(super) until: Tick,
    pub(super) truth: Option<Truth>,
    /// A thing that does not stay where it was put, and is held still.
    pub(super) balanced: Option<NodeId>,
}

/// The tick of an event that bodies decide.
pub(super) const NEVER: Tick = Tick(u64::MAX);

/// How far the motion under way has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    /// Before its event: feet walk, a hand goes out.
    Out,
    /// A hand moves doors or drawers.
    Leaf,
    /// A hand pushes them against what is in the way, for at most so many ticks.
    Pushes(u32),
    /// After its event: the hand comes back, the body settles.
    Back,
    /// Waits until what was moved rests.
    Rests,
    /// All is done; waits until what was moved rests.
    Ends,
}

/// An action's effects once they have come true: the scene before and after by the rule.
#[derive(Debug, Clone)]
pub(super) struct Truth {
    pub(super) before: SceneGraph,
    pub(super) ruled: SceneGraph,
    pub(super) changes: ChangeSet,
    /// Nodes whose relations may have changed since.
    pub(super) met: Vec<NodeId>,
    /// Whether bystanders have been put back already.
    pub(super) steadied: bool,
}

impl Schedule {
    pub(super) fn new(action: Action, care: RetryOptions) -> Self {
        let (motions, motion, phase) = (VecDeque::new(), None, Phase::Back);
        let (begin, track, until) = (Tick::default(), Track::Still, Tick::default());
        let (tasks, done, picked) = (Task::of(&action), None, None);
        let (truth, balanced) = (None, None);
        Self { tasks, action, care, motions, motion, done, picked, phase, begin, track, until, truth, balanced }
    }

    /// Whether the action's effects come true with a motion.
    pub(super) fn comes_true_with(&self, motion: &BodyMotion) -> bool {
        let effects = rule::effects(&self.action);
        let goes =
            |e: &Effect<_>| matches!(e, Effect::GoTo(_) | Effect::Approach(_) | Effect::Face(_)) || is_on_foot(e);
        match motion {
            BodyMotion::Take(..)
            | BodyMotion::Put(_)
            | BodyMotion::LetGo(_)
            | BodyMotion::Rest(..)
            | BodyMotion::Dress(_)
            | BodyMotion::Undress(..)
            | BodyMotion::Fill(..)
            | BodyMotion::Gesture(..) => true,
            BodyMotion::GetUp(_) => effects.contains(&Effect::StandUp),
            BodyMotion::Walk { .. } | BodyMotion::Turn(_) => !effects.is_empty() && effects.iter().all(goes),
            _ => false,
        }
    }
}

/// The time before a motion's event, and after it. Ways, turns and doors have times of their own. An action may take a
/// time before its effects come true.
pub(super) fn lasts(motion: &BodyMotion, takes: Option<Span>) -> (Span, Span) {
    let (before, after) = by_hand(motion);
    match (motion, takes) {
        (BodyMotion::Gesture(..), Some(takes)) => (takes, after),
        _ => (before.max(takes.unwrap_or_default()), after),
    }
}

fn by_hand(motion: &BodyMotion) -> (Span, Span) {
    match motion {
        BodyMotion::Take(..)
        | BodyMotion::Put(_)
        | BodyMotion::LetGo(_)
        | BodyMotion::Dress(_)
        | BodyMotion::Undress(..)
        | BodyMotion::Drive(_) => (REACHING, REACHING),
        BodyMotion::Rest(..) | BodyMotion::GetUp(_) => (Span(0), SETTLING),
        BodyMotion::Gesture(_, seconds) => (Span::from_seconds(f64::from(*seconds)), Span(0)),
        _ => (Span(0), Span(0)),
    }
}
