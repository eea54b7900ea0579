//! The schedule of an agent's action.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};
use vc_graph::clock::{Span, Tick};
use vc_graph::{Action, ChangeSet, Effect, NodeId, Pose, SceneGraph, Vocabulary, rule};

use super::show::Settling;
use super::track::{REACHING, Track};
use crate::environment::execute::Task;
use crate::environment::motion::{BodyMotion, Drive};

/// Time in which a body sits down, lies down or gets up.
pub(super) const SETTLING: Span = Span(60);

/// The schedule of an action. It grows by its events: what comes next is planned when a motion has been done.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Schedule {
    pub(super) action: Action,
    /// Whether doors and drawers are pushed all the way.
    pub(super) pushes: bool,
    pub(super) tasks: VecDeque<Task>,
    /// Planned motions, which follow the current one.
    pub(super) motions: VecDeque<BodyMotion>,
    /// The motion that is under way.
    pub(super) motion: Option<BodyMotion>,
    /// The last motion that has been done, from which the hand comes back.
    pub(super) done: Option<BodyMotion>,
    /// The posture before the last motion, if it has changed that.
    #[serde(skip)]
    pub(super) settling: Option<Settling>,
    /// Where the thing was that a hand has taken, against the feet.
    pub(super) picked: Option<Pose>,
    pub(super) phase: Phase,
    /// The tick in which the phase began.
    pub(super) begin: Tick,
    pub(super) track: Track,
    /// The tick of the next event; [`NEVER`] while it waits for bodies.
    pub(super) until: Tick,
    #[serde(skip)]
    pub(super) truth: Option<Truth>,
    /// How often it has begun anew, as somebody walked on or has taken the spot.
    pub(super) chases: u32,
    /// Since when it waits for those who stand in its way.
    pub(super) waits: Option<Tick>,
    /// A thing that does not stay where it was put, and is held still.
    pub(super) balanced: Option<NodeId>,
}

/// The tick of an event that bodies decide.
pub(super) const NEVER: Tick = Tick(u64::MAX);

/// How far the motion under way has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Phase {
    /// Before its event: feet walk, a hand goes out.
    Out,
    /// A hand moves doors or drawers.
    Leaf,
    /// A hand pushes them against what is in the way, for at most so many ticks; all of them, or doors first.
    Pushes(u32, bool),
    /// After its event: the hand comes back, the body settles.
    Back,
    /// Waits for those who stand in the way.
    Waits,
    /// Waits until what was moved rests.
    Rests,
    /// All is done; waits until what was moved rests.
    Ends,
}

/// An action's effects once they have come true: the scene before and after by the rule, with what others have brought
/// about since.
#[derive(Debug, Clone)]
pub(super) struct Truth {
    pub(super) before: SceneGraph,
    pub(super) ruled: SceneGraph,
    pub(super) changes: ChangeSet,
    /// Nodes whose relations may have changed since.
    pub(super) met: Vec<NodeId>,
    /// Nodes that others have had in hand since: these answer for them.
    pub(super) excused: Vec<NodeId>,
    /// Whether what went astray has been put back already.
    pub(super) put_back: bool,
    /// A thing that the action is about, and whoever has opened or shut it since.
    pub(super) moved: Option<(NodeId, NodeId)>,
}

impl Schedule {
    /// The schedule of an action of which nothing is done yet. Without tasks its effects come true with a gesture.
    pub(super) fn new(action: Action, tasks: VecDeque<Task>) -> Self {
        let (motions, motion, phase) = (VecDeque::new(), None, Phase::Back);
        let (begin, track, until) = (Tick::default(), Track::Still, Tick::default());
        let (done, picked, settling) = (None, None, None);
        let (truth, waits, balanced, pushes, chases) = (None, None, None, false, 0);
        Self {
            tasks,
            action,
            pushes,
            motions,
            motion,
            done,
            settling,
            picked,
            phase,
            begin,
            track,
            until,
            truth,
            chases,
            waits,
            balanced,
        }
    }

    /// The thing whose motors push.
    pub(super) fn pushing(&self) -> Option<&Drive> {
        match &self.motion {
            Some(BodyMotion::Drive(drive)) if matches!(self.phase, Phase::Pushes(..)) => Some(drive),
            _ => None,
        }
    }

    /// Whether the action's effects come true with a motion.
    pub(super) fn comes_true_with(&self, words: &Vocabulary, motion: &BodyMotion) -> bool {
        let effects = rule::effects(words, &self.action);
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
            BodyMotion::Walk { .. } | BodyMotion::Turn(_) => !effects.is_empty() && effects.iter().all(is_on_foot),
            _ => false,
        }
    }
}

impl Truth {
    /// The scenes before and after an action that the rule allows, by the rule alone.
    pub(super) fn new(before: SceneGraph, agent: NodeId, action: &Action) -> Self {
        let (mut ruled, mut changes) = (before.clone(), ChangeSet::default());
        for effect in &rule::effects(before.vocabulary(), action) {
            changes = changes.then(rule::carry_out(&mut ruled, agent, effect).unwrap_or_default());
        }
        let (met, excused) = (Vec::new(), Vec::new());
        Self { before, ruled, changes, met, excused, put_back: false, moved: None }
    }

    /// Others answer for some nodes.
    pub(super) fn excuse(&mut self, nodes: &[NodeId]) {
        let new: Vec<NodeId> = nodes.iter().filter(|id| !self.excused.contains(id)).copied().collect();
        self.excused.extend(new);
    }

    /// Takes up what somebody else has brought about meanwhile, who answers for what the action is about.
    pub(super) fn goes_on_with(&mut self, other: NodeId, action: &Action) {
        self.excused.extend(action.things());
        for effect in &rule::effects(self.before.vocabulary(), action) {
            for graph in [&mut self.before, &mut self.ruled] {
                // The rule has allowed it in a scene that may differ; bodies say what came of it.
                drop(rule::carry_out(graph, other, effect));
            }
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

/// Whether an effect is that an agent is somewhere, or turned somewhere.
fn is_on_foot(effect: &Effect<NodeId>) -> bool {
    use Effect::{Approach, Face, GoTo, GoToPoint, StandAs, TurnAs};
    matches!(effect, GoTo(_) | Approach(_) | Face(_) | GoToPoint(_) | StandAs(_) | TurnAs(_))
}
