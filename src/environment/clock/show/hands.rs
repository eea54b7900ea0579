//! Hands go out, to what they take, put down or open, and come back.

use vc_graph::NodeId;
use vc_people::{Activity, BodySide, Reach};
use vc_physics::Hand;

use super::{Figure, OUT, between};
use crate::environment::Environment;
use crate::environment::motion::Put;

impl Figure {
    /// A hand goes out to a thing, or brings what it has taken.
    pub(super) fn take(&mut self, home: &mut Environment, hand: Hand, id: NodeId) {
        self.at = home.palm_on(self.agent, hand, id);
        if self.time >= OUT {
            self.rest = home.world.agent(self.agent).ok().and_then(|agent| agent.grip(hand));
            self.bring(home, hand);
        }
        self.reach(home, hand, id);
    }

    /// A hand takes a thing to where it is put, or comes back without it.
    pub(super) fn put(&mut self, home: &mut Environment, put: &Put) {
        self.rest = home.world.agent(self.agent).ok().and_then(|agent| agent.grip(put.hand));
        self.out = Some(self.feet(home).inverse() * put.pose);
        self.at = home.palm_on(self.agent, put.hand, put.id);
        if self.time <= OUT {
            self.bring(home, put.hand);
        }
        self.reach(home, put.hand, put.id);
    }

    /// A hand goes out to a door, a drawer or a lid, moves along with it, or comes back.
    pub(super) fn drive(&mut self, home: &mut Environment, id: NodeId) {
        let hand = self.free_hand(home);
        let from = self.side(home, hand);
        self.at = home.world.aabb(id).map(|b| b.nearest(&from));
        self.reach(home, hand, id);
    }

    /// A hand that holds nothing, the right one first; the right one if there is none.
    pub(super) fn free_hand(&self, home: &Environment) -> Hand {
        let free = |hand: &Hand| home.world.held(self.agent, *hand).is_none();
        Hand::BOTH.into_iter().find(free).unwrap_or(Hand::Right)
    }

    /// How far a hand has gone out, 0 to 1.
    fn share(&self) -> f32 {
        (self.time.min(2.0 * OUT - self.time) / OUT).clamp(0.0, 1.0)
    }

    /// Shows the body reaching for what the hand is at, or following what it holds, and keeping a thing in
    /// view.
    fn reach(&self, home: &mut Environment, hand: Hand, thing: NodeId) {
        let (share, side) = (self.share(), side(hand));
        let held = home.world.held(self.agent, hand).filter(|_| self.out.is_some());
        let reach = match held.and_then(|id| home.palm_on(self.agent, hand, id)) {
            Some(point) => Some(Reach { side, point, share: 1.0, gaze: share }),
            None => self.at.map(|point| Reach { side, point, share, gaze: share }),
        };
        let gaze = home.attended(self.agent, [thing]);
        home.poses.insert(self.agent, Activity { reach, gaze, ..Activity::default() });
    }

    /// Brings what a hand holds as far as the hand has gone out.
    fn bring(&self, home: &mut Environment, hand: Hand) {
        self.regrip(home, hand, self.share());
    }

    pub(super) fn regrip(&self, home: &mut Environment, hand: Hand, share: f32) {
        let (Some(rest), Some(out)) = (self.rest, self.out) else { return };
        // It is in that hand.
        let _ = home.world.regrip(self.agent, hand, between(&rest, &out, share));
    }
}

pub(super) fn side(hand: Hand) -> BodySide {
    match hand {
        Hand::Right => BodySide::Right,
        Hand::Left => BodySide::Left,
    }
}
