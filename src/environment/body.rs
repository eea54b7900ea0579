//! How an agent's figure is posed, by what its body does.

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Pose};
use vc_people::{Activity, BodyPosture, Skeleton};
use vc_physics::{Hand, PhysicsWorld, Posture};

use crate::Environment;

impl Environment {
    /// How an agent's figure is posed.
    pub(crate) fn skeleton(&self, agent: NodeId) -> Option<Skeleton> {
        let (world, attitude) = (self.world(), self.attitude(agent)?);
        let pose = world.pose(agent)?;
        let mut doing = self.doing(agent);
        if doing == Activity::default() {
            doing.gaze = self.attention(agent);
        }
        doing = self.under_control(agent, doing);
        let own = |point: &mut Point3<f32>| *point = pose.inverse_transform_point(point);
        doing.gaze.iter_mut().for_each(own);
        doing.reach.iter_mut().for_each(|reach| own(&mut reach.point));
        let hands = Hand::BOTH.map(|hand| grip(world, &pose, hand, world.held(agent, hand)?));
        Some(Skeleton::new(attitude, &doing, hands))
    }

    /// The posture of an agent's figure.
    pub(super) fn attitude(&self, agent: NodeId) -> Option<BodyPosture> {
        let level = || Some(self.world().pose(agent)?.translation.z - self.floor().options().level);
        Some(match self.world().posture(agent)? {
            Posture::Standing => BodyPosture::Standing,
            Posture::Sitting(..) => BodyPosture::Sitting(level()?),
            Posture::Lying(..) => BodyPosture::Lying,
        })
    }

    /// Where an agent's palm is on a thing that it takes hold of or holds.
    pub(crate) fn palm_on(&self, agent: NodeId, hand: Hand, id: NodeId) -> Option<Point3<f32>> {
        let feet = self.world().pose(agent)?;
        Some(feet * grip(self.world(), &feet, hand, id)?)
    }
}

/// How far ahead hands hold things by their middle, metres; farther away by what is nearest of them.
const AHEAD: f32 = 0.45;
/// Widest thing that is held at its side, half, metres; a wider one is held at its front, so far from its middle.
const WIDE: f32 = 0.3;
/// From the middle of the palm to the surface of what is in it, metres: fingers close around edges.
const PALM: f32 = 0.012;

/// Where the palm is on a thing, in the body's frame: at the point of its shapes that is nearest to a point beside it.
fn grip(world: &PhysicsWorld, feet: &Pose, hand: Hand, id: NodeId) -> Option<Point3<f32>> {
    let beside = beside(world, feet, hand, id)?;
    let touched = feet.inverse_transform_point(&world.body(id).ok()?.nearest_point(feet * beside)?);
    let out = (beside - touched).try_normalize(1e-4).unwrap_or_else(Vector3::zeros);
    Some(touched + out * PALM)
}

/// A point at the outer side of a thing, or before a wide one, in the body's frame.
fn beside(world: &PhysicsWorld, feet: &Pose, hand: Hand, id: NodeId) -> Option<Point3<f32>> {
    let (low, high) = world.body(id).ok()?.local_bounds();
    let side = if hand == Hand::Right { -1.0 } else { 1.0 };
    let own = feet.inverse() * world.pose(id)?;
    let (centre, half) = (own * nalgebra::center(&low, &high), (high - low) / 2.0);
    // Half its width across and ahead, as it is turned.
    let along = |axis: Vector3<f32>| (own.rotation.inverse() * axis).abs().dot(&half);
    let (across, ahead) = (along(Vector3::y()), along(Vector3::x()));
    let x = AHEAD.clamp((centre.x - ahead).min(centre.x - 0.01), centre.x - 0.01);
    Some(match across > WIDE {
        false => Point3::new(x, centre.y + side * (across + 2.0 * PALM), centre.z),
        true => Point3::new(centre.x - ahead - 2.0 * PALM, centre.y + side * WIDE, centre.z),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::clock::Span;
    use vc_graph::{Action, Node, Property, Verb};
    use vc_people::{BodySide, Bone, palm};
    use vc_physics::BodyRole;

    use super::*;

    /// How far the palm is from what it holds, at worst, of all hands that hold.
    fn away(home: &Environment, agent: NodeId) -> f32 {
        let skeleton = home.skeleton(agent).unwrap();
        let feet = home.world().pose(agent).unwrap();
        let off = BodySide::BOTH.into_iter().zip(Hand::BOTH).filter_map(|(side, hand)| {
            let held = home.world().held(agent, hand)?;
            let own = feet * (skeleton.motion(Bone::Hand(side)) * palm(side));
            Some((own - home.world().body(held).ok()?.nearest_point(own)?).norm())
        });
        off.fold(0.0, f32::max)
    }

    /// A hand is at what it holds while that is fetched, carried and put down, as far as bodies reach.
    #[test]
    fn hands_are_where_things_are() {
        let mut home = Environment::make("apartment/42", 1).unwrap();
        let me = home.agents()[0];
        let of = |keep: &dyn Fn(&Node) -> bool| {
            home.graph().nodes().filter(|n| keep(n)).map(Node::id).collect::<Vec<NodeId>>()
        };
        let things = of(&|n| n.affords(Property::Graspable));
        let tops = of(&|n| n.affords(Property::Surface) && home.world().role(n.id()) == Some(BodyRole::Fixed));
        let mut done = 0;
        for (thing, top) in things.into_iter().step_by(vc_testkit::amount(18, 3)).zip(tops.into_iter().cycle()) {
            let put = Action::with(Verb::Place, &[thing, top]).unwrap();
            for action in
                [Action::one(Verb::Walk, thing), Action::one(Verb::Grab, thing), Action::one(Verb::Walk, top), put]
            {
                let mut most = 0.0_f32;
                let outcome = home.set_action_in_time(me, action, Span(1), |now| most = most.max(away(now, me)));
                assert!(most < 0.11, "{}: the hand is {most} m away", action.describe(home.graph()));
                done += usize::from(outcome.is_ok());
            }
            for held in Hand::BOTH.into_iter().filter_map(|hand| home.world().held(me, hand)).collect::<Vec<_>>() {
                home.set_action(me, Action::one(Verb::Drop, held)).unwrap();
            }
        }
        assert!(done > 10, "{done} actions were done");
    }
}
