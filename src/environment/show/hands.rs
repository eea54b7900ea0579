//! What hands do: they go out, to what they take, open or wipe, and come back.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::JointKind;
use vc_graph::{Action, NodeId, Pose, Verb};
use vc_physics::Hand;

use super::Player;
use crate::environment::Environment;
use crate::environment::beat::{Drive, Put};
use crate::environment::deed::comes_along;
use crate::figure::{Doing, Reach, Side};

/// Seconds in which a hand goes out, and in which it comes back.
const REACHING: f32 = 0.55;
/// Share of a gesture in which a hand goes out, and in which it comes back.
const EASE: f32 = 0.3;
/// Where the mouth is, and where one reads, from the eyes, metres.
const MOUTH: Vector3<f32> = Vector3::new(0.04, 0.0, -0.1);
const BOOK: Vector3<f32> = Vector3::new(0.32, 0.0, -0.2);
/// How far one points, metres.
const POINTING: f32 = 0.55;
/// How far a vessel is held above what is poured into, metres, and how it is tilted then and at
/// the mouth, radians.
const ABOVE: f32 = 0.14;
const TILT: (f32, f32) = (1.5, -0.5);
/// How far wiping hands go to and fro, and knives up and down, metres.
const STROKE: (f32, f32) = (0.09, 0.04);
/// Radians a second in which they do.
const BEAT: f32 = 9.0;

/// Seconds in which a door or a drawer goes all its way, and after which it is waited for no longer.
const WHOLE_WAY: f32 = 0.9;
const PATIENCE: f32 = 4.0;
/// How near a part comes to where it is to be, as a share of its way.
const ARRIVED: f32 = 1e-3;

/// What hands are at in the course of a beat.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Handling {
    /// What is reached for, where it was at first.
    at: Option<Point3<f32>>,
    /// Where a hand holds what it holds when it does nothing with it, against the feet, and where
    /// it is brought.
    rest: Option<Pose>,
    out: Option<Pose>,
    /// How long somebody has waited for a door or a drawer, seconds, and whether that has arrived.
    pub(super) waited: f32,
    arrived: bool,
}

/// Where a gesture brings a hand, and how it turns what it holds.
struct Aim {
    hand: Hand,
    point: Point3<f32>,
    tilt: f32,
    /// Whether the eyes follow.
    looks: bool,
}

impl Player {
    /// A hand goes out, closes around a thing, and comes back with it.
    pub(super) fn take(&mut self, show: &mut Environment, hand: Hand, id: NodeId, before: f32) -> bool {
        let (agent, feet) = (self.agent, self.feet(show));
        if self.handling.at.is_none() {
            self.handling.at = show.world.aabb(id).map(|b| b.centre());
        }
        if before < REACHING && self.time >= REACHING {
            self.handling.out = show.world.pose(id).map(|pose| feet.inverse() * pose);
            let Environment { world, graph, .. } = &mut *show;
            drop(world.grab_with(agent, hand, id, |load| comes_along(graph, load, id)));
            self.handling.rest = world.grip(agent, hand);
            self.come_true(show);
        }
        if self.time >= REACHING {
            self.bring(show, hand);
        }
        self.reach(show, hand)
    }

    /// A hand takes a thing to where it is put, and comes back without it.
    pub(super) fn put(&mut self, show: &mut Environment, put: &Put, before: f32) -> bool {
        let (agent, feet) = (self.agent, self.feet(show));
        if self.handling.at.is_none() {
            self.handling.rest = show.world.grip(agent, put.hand);
            self.handling.out = Some(feet.inverse() * put.pose);
            let middle = show.world.aabb(put.id).zip(show.world.pose(put.id));
            let offset =
                middle.map_or_else(Vector3::zeros, |(b, pose)| b.centre() - Point3::from(pose.translation.vector));
            self.handling.at = Some(Point3::from(put.pose.translation.vector + offset));
        }
        if self.time < REACHING {
            self.bring(show, put.hand);
        } else if before < REACHING {
            drop(show.world.put(agent, put.hand, put.pose));
            if put.balanced {
                drop(show.world.pin(put.id));
            }
            self.come_true(show);
        }
        self.reach(show, put.hand)
    }

    /// A hand moves a door, a drawer or a lid, and stays at it until it has arrived.
    pub(super) fn drive(&mut self, show: &mut Environment, drive: &Drive, before: f32) -> bool {
        let hand = self.free_hand(show);
        let from = self.side(show, hand);
        self.handling.at = show.world.aabb(drive.id).map(|b| b.nearest(&from));
        if self.time < REACHING {
            return self.reach(show, hand);
        }
        let moves = !self.handling.arrived
            && match drive.pushes {
                true => push(show, drive, before < REACHING),
                false => self.swing(show, drive),
            };
        if moves {
            // The hand stays where it is.
            self.handling.waited += show.world.settings().dt;
            self.time = REACHING;
        }
        self.handling.arrived = !moves;
        let over = self.reach(show, hand);
        if over {
            let end = drive.end.iter().enumerate();
            end.for_each(|(part, open)| drop(show.world.put_open(drive.id, part, *open)));
        }
        over
    }

    /// Moves what nothing is in the way of: doors open before drawers and shut after them. Gives
    /// whether anything moves still.
    fn swing(&self, show: &mut Environment, drive: &Drive) -> bool {
        let parts = show.world.moving_parts(drive.id);
        let (step, first) =
            (show.world.settings().dt / WHOLE_WAY, if drive.open > 0.0 { JointKind::Hinge } else { JointKind::Slide });
        let left = |part: usize| drive.end.get(part).map_or(0.0, |end| end - parts[part].open);
        let waits = |kind: JointKind| (0..parts.len()).any(|i| parts[i].kind == kind && left(i).abs() > ARRIVED);
        let kinds = [first, if first == JointKind::Hinge { JointKind::Slide } else { JointKind::Hinge }];
        let Some(kind) = kinds.into_iter().find(|kind| waits(*kind)) else { return false };
        for part in (0..parts.len()).filter(|i| parts[*i].kind == kind) {
            let next = parts[part].open + left(part).clamp(-step, step);
            drop(show.world.put_open(drive.id, part, next));
        }
        // What jams is not waited for.
        self.handling.waited < PATIENCE
    }

    /// What is only seen of an action: the hand at what it is done to, a cup at the mouth.
    pub(super) fn gesture(&mut self, show: &mut Environment, action: &Action, seconds: f32) -> bool {
        let doing = Doing { gesture: Some((action.verb, self.time)), ..Doing::default() };
        show.poses.insert(self.agent, doing);
        let ease = EASE * seconds;
        let share = (self.time.min(seconds - self.time) / ease).clamp(0.0, 1.0);
        if let Some(aim) = self.aim(show, action) {
            self.follow(show, &aim, share);
        }
        if 2.0 * self.time >= seconds {
            self.come_true(show);
        }
        self.time >= seconds
    }

    /// Brings a hand to where a gesture wants it, with what it holds.
    fn follow(&mut self, show: &mut Environment, aim: &Aim, share: f32) {
        let feet = self.feet(show);
        if let Some(grip) = show.world.grip(self.agent, aim.hand) {
            let rest = *self.handling.rest.get_or_insert(grip);
            let held = show.world.held(self.agent, aim.hand);
            let middle = held.and_then(|id| show.world.aabb(id)).map_or(Point3::origin(), |b| b.centre());
            // Where its middle is in its own frame, by where it is held now.
            let own = (feet * grip).inverse_transform_point(&middle);
            let tilt = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), aim.tilt) * rest.rotation;
            let at = feet.inverse_transform_point(&aim.point).coords - tilt * own.coords;
            self.handling.out = Some(Pose::from_parts(at.into(), tilt));
            self.regrip(show, aim.hand, share);
        }
        if let Some(doing) = show.poses.get_mut(&self.agent) {
            doing.reach = Some(Reach { side: side(aim.hand), point: aim.point, share, looks: aim.looks });
        }
    }

    /// Which hand an action brings where.
    fn aim(&self, show: &Environment, action: &Action) -> Option<Aim> {
        use Verb::{Cut, Drink, Eat, Fill, PointAt, Pour, Read};
        let (x, y) = (action.object?, action.target);
        let hand = match (self.hand_of(show, x), action.verb) {
            (Some(hand), Eat | Drink | Read | Pour | Fill) => hand,
            _ => self.tool_hand(show, x),
        };
        let from = self.side(show, hand);
        let box_of =
            |id: NodeId| std::iter::once(id).chain(show.graph.support_chain(id)).find_map(|id| show.world.aabb(id));
        let (swing, chop) = (STROKE.0 * sine(BEAT * self.time), STROKE.1 * sine(BEAT * self.time).abs());
        let across = self.feet(show).rotation * Vector3::y();
        let (point, tilt) = match action.verb {
            Drink => (self.at_mouth(show, x), TILT.1),
            Eat if self.hand_of(show, x).is_some() => (self.at_mouth(show, x), 0.0),
            // First to the plate, then to the mouth.
            Eat => {
                let bite = (2.0 * self.time - 1.0).clamp(0.0, 1.0);
                let plate = box_of(x)?.nearest(&from);
                (plate + (self.before_eyes(show, MOUTH) - plate) * bite, 0.0)
            }
            Read => (self.before_eyes(show, BOOK), 0.0),
            Pour => (above(&box_of(y?)?, ABOVE), TILT.0),
            Fill => (box_of(y?)?.nearest(&from), 0.0),
            PointAt => {
                let shoulder = self.feet(show) * Point3::new(0.0, 0.0, 1.35);
                let way = (box_of(x)?.centre() - shoulder).try_normalize(1e-3)?;
                (shoulder + way * POINTING, 0.0)
            }
            Cut => (above(&box_of(x)?, 0.02 + chop), 0.0),
            Verb::Wipe | Verb::Wash | Verb::Rinse | Verb::Scrub | Verb::Play | Verb::Type | Verb::Cook => {
                (box_of(x)?.nearest(&(from + across * swing)), 0.0)
            }
            Verb::Watch | Verb::LookAt | Verb::Greet | Verb::TurnTo => return None,
            _ => (box_of(x)?.nearest(&from), 0.0),
        };
        // To the mouth one finds without.
        let looks = !matches!(action.verb, Drink | Eat);
        Some(Aim { hand, point, tilt, looks })
    }

    fn before_eyes(&self, show: &Environment, offset: Vector3<f32>) -> Point3<f32> {
        let eyes = show.skeleton(self.agent).map_or_else(|| Pose::translation(0.1, 0.0, 1.55), |s| s.eyes());
        // Heads are held upright here, however they look.
        self.feet(show) * (Point3::from(eyes.translation.vector) + offset)
    }

    /// Where a held thing's middle is while its upper rim is at the mouth.
    fn at_mouth(&self, show: &Environment, id: NodeId) -> Point3<f32> {
        let half = show.world.aabb(id).map_or_else(Vector3::zeros, |b| (b.max - b.min) / 2.0);
        self.before_eyes(show, MOUTH + Vector3::new(half.x.min(half.y), 0.0, -0.8 * half.z))
    }

    /// The hand that holds a thing.
    fn hand_of(&self, show: &Environment, id: NodeId) -> Option<Hand> {
        show.world.holder(id).filter(|(holder, _)| *holder == self.agent).map(|(_, hand)| hand)
    }

    /// A hand that holds nothing, the right one first; the right one if there is none.
    fn free_hand(&self, show: &Environment) -> Hand {
        let free = |hand: &Hand| show.world.held(self.agent, *hand).is_none();
        Hand::BOTH.into_iter().find(free).unwrap_or(Hand::Right)
    }

    /// The hand that holds something else than a thing, to do something with it to that; or a free
    /// one.
    fn tool_hand(&self, show: &Environment, thing: NodeId) -> Hand {
        let other = |hand: &Hand| show.world.held(self.agent, *hand).is_some_and(|held| held != thing);
        Hand::BOTH.into_iter().find(other).unwrap_or_else(|| self.free_hand(show))
    }

    /// How far a hand has gone out, 0 to 1.
    fn share(&self) -> f32 {
        (self.time.min(2.0 * REACHING - self.time) / REACHING).clamp(0.0, 1.0)
    }

    /// Shows the body reaching for what the hand is at; gives whether the hand is back.
    fn reach(&self, show: &mut Environment, hand: Hand) -> bool {
        let reach = self.handling.at.map(|point| Reach { side: side(hand), point, share: self.share(), looks: true });
        show.poses.insert(self.agent, Doing { reach, ..Doing::default() });
        self.time >= 2.0 * REACHING
    }

    /// Brings what a hand holds as far as the hand has gone out.
    fn bring(&self, show: &mut Environment, hand: Hand) {
        self.regrip(show, hand, self.share());
    }

    fn regrip(&self, show: &mut Environment, hand: Hand, share: f32) {
        let (Some(rest), Some(out)) = (self.handling.rest, self.handling.out) else { return };
        let turn = rest.rotation.try_slerp(&out.rotation, share, 1e-6).unwrap_or(rest.rotation);
        let at = rest.translation.vector.lerp(&out.translation.vector, share);
        // It is in that hand.
        let _ = show.world.regrip(self.agent, hand, Pose::from_parts(at.into(), turn));
    }
}

/// Moves parts by motors, against what is in the way; gives whether any still runs.
fn push(show: &mut Environment, drive: &Drive, begins: bool) -> bool {
    if begins {
        let parts = show.world.moving_parts(drive.id).len();
        (0..parts).for_each(|part| drop(show.world.drive(drive.id, part, drive.open)));
    }
    show.world.is_driven(drive.id)
}

fn sine(angle: f32) -> f32 {
    use vc_graph::portable::Portable;
    angle.sine()
}

fn side(hand: Hand) -> Side {
    match hand {
        Hand::Right => Side::Right,
        Hand::Left => Side::Left,
    }
}

/// A point above the middle of a box.
fn above(aabb: &vc_graph::Aabb, height: f32) -> Point3<f32> {
    let middle = aabb.centre();
    Point3::new(middle.x, middle.y, aabb.max.z + height)
}
