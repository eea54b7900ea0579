//! What a body does one after the other in the course of an action.

use nalgebra::{Point2, Vector3};
use vc_graph::{Action, Effect, NodeId, Pose, Side};
use vc_physics::Hand;

/// One thing a body does. An action at once does them all; an action in time shows them.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum BodyMotion {
    /// Walks along points, doors on the way opened and closed in passing, to a pose.
    Walk { points: Vec<Point2<f32>>, doors: Vec<NodeId>, feet: Pose, run: bool },
    /// Turns on the spot.
    Turn(Pose),
    /// Takes a thing into a hand, perhaps by a side.
    Take(Hand, NodeId, Option<Side>),
    /// Things that nobody touches are held where they are: they would fall.
    Steady(Vec<NodeId>),
    /// Folds up cloth that a hand holds, to another scale.
    Fold(NodeId, Vector3<f32>),
    /// Moves doors and drawers out of the way: which part of what, and how far open it is then.
    Nudge(Vec<(NodeId, usize, f32)>),
    /// Pushes things together, to these poses.
    Push(Vec<(NodeId, Pose)>),
    /// Puts down what a hand holds.
    Put(Put),
    /// Puts what was put down elsewhere; held still there if it would not stay.
    PutAgain(NodeId, Pose, bool),
    /// Takes what was put down out of the way, and those around it to where they were.
    ClearAway(NodeId, Vec<(NodeId, Pose)>),
    /// Takes what was pushed together back to where it rested.
    PutBack(Vec<(NodeId, Pose)>),
    /// Waits until what was disturbed rests.
    ComeToRest,
    /// Fills a vessel to a share.
    Fill(NodeId, f32),
    /// Lets go of what a hand holds.
    LetGo(Hand),
    /// Moves doors, lids, drawers.
    Drive(Drive),
    /// Sits or lies down, perhaps on one of the seats, counted from 0.
    Rest(NodeId, bool, Option<u32>),
    /// Gets up to a pose.
    GetUp(Pose),
    /// Puts on a thing.
    Dress(NodeId),
    /// Takes a thing off, into a hand.
    Undress(Hand, NodeId),
    /// Does an action of which no body knows more than how it looks, for so many seconds.
    Gesture(Action, f32),
}

/// What a hand puts down, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Put {
    pub(super) hand: Hand,
    pub(super) id: NodeId,
    pub(super) pose: Pose,
    /// Whether it would not stay there by itself and is held still.
    pub(super) balanced: bool,
    /// Where it is held as it was at the start, as it would overlap something.
    pub(super) tight: Option<NodeId>,
}

/// How the parts of a thing are moved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drive {
    pub(super) id: NodeId,
    /// To which fraction of their way, 1 open.
    pub(super) open: f32,
    /// Whether something is in the way, so that it takes force.
    pub(super) pushes: bool,
    /// How far open each part is in the end.
    pub(super) end: Vec<f32>,
}

/// What a body does in an action, and what becomes of it by the rule.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Course {
    pub(super) motions: Vec<BodyMotion>,
    /// Each effect, and the number of the motion with which it comes true; with the last one where
    /// there is none of its own.
    pub(super) effects: Vec<(Option<usize>, Effect<NodeId>)>,
}

impl Course {
    /// Records a motion. Attempts to find a place where a thing stays are not seen, only where it was put in the end.
    pub(super) fn record(&mut self, motion: BodyMotion) {
        use BodyMotion::{ClearAway, ComeToRest, Fill, Push, Put, PutAgain, PutBack};
        let (last, put) = (self.motions.len().saturating_sub(1), matches!(self.motions.last(), Some(Put(_))));
        match motion {
            PutAgain(_, pose, balanced) => {
                if let Some(Put(put)) = self.motions.last_mut() {
                    (put.pose, put.balanced) = (pose, balanced);
                }
            }
            // Others are pushed before it is put down beside them.
            Push(_) if put => self.motions.insert(last, motion),
            PutBack(_) if put && last > 0 && matches!(self.motions[last - 1], Push(_)) => {
                self.motions.remove(last - 1);
            }
            ClearAway(..) | PutBack(_) | ComeToRest | Fill(..) => {}
            motion => self.motions.push(motion),
        }
    }

    /// Records that an effect comes true with the last motion since a number of them that has to do with it.
    pub(super) fn comes_true(&mut self, effect: Effect<NodeId>, since: usize) {
        // Stepping up to a thing does nothing to it.
        let goes = matches!(effect, Effect::GoTo(_) | Effect::Approach(_) | Effect::Face(_)) || is_on_foot(&effect);
        let does = |motion: &BodyMotion| {
            goes || !matches!(motion, BodyMotion::Walk { .. } | BodyMotion::Turn(_) | BodyMotion::Nudge(_))
        };
        let motion = self.motions.iter().skip(since).rposition(does).map(|i| since + i);
        self.effects.push((motion, effect));
    }

    /// The cloth that was folded up, with its scale now.
    pub(super) fn folded(&self) -> Vec<(NodeId, Vector3<f32>)> {
        let fold = |motion: &BodyMotion| match motion {
            BodyMotion::Fold(id, scale) => Some((*id, *scale)),
            _ => None,
        };
        self.motions.iter().filter_map(fold).collect()
    }

    /// The thing that was put down last, if it would not stay where it was put.
    pub(super) fn balanced(&self) -> Option<NodeId> {
        self.motions.iter().rev().find_map(|motion| match motion {
            BodyMotion::Put(put) if put.balanced => Some(put.id),
            _ => None,
        })
    }
}

/// Whether an effect is that an agent is at a point, or turned by a heading.
pub(super) fn is_on_foot(effect: &Effect<NodeId>) -> bool {
    matches!(effect, Effect::GoToPoint(_) | Effect::StandAs(_) | Effect::TurnAs(_))
}
