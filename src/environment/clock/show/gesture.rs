//! Gestures: motions for the effects that no body shows, such as a hand on the object of an action or a cup at
//! the mouth.

use nalgebra::{Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{Aabb, Action, Anthropometry, Effect, Motion, NodeId, Pose, Property, rule};
use vc_people::{Activity, Reach};
use vc_physics::Hand;

use super::hands::side;
use super::{Figure, OUT, Settling};
use crate::environment::Environment;
use crate::environment::clock::schedule::SETTLING;
use crate::environment::execute::load_of;

/// Share of a gesture in which the hand goes out, and equally in which it comes back.
const EASE: f32 = 0.3;
/// Position of the mouth and of a book while reading, relative to the eyes, metres.
const MOUTH: Vector3<f32> = Vector3::new(0.04, 0.0, -0.1);
const BOOK: Vector3<f32> = Vector3::new(0.32, 0.0, -0.2);
/// Distance of the hand while pointing, metres.
const POINTING: f32 = 0.55;
/// Height of a vessel above the thing it is poured into, metres, and its tilt while pouring and at
/// the mouth, radians.
const ABOVE: f32 = 0.14;
const TILT: (f32, f32) = (1.5, -0.5);
/// Amplitude of wiping hands (sideways) and of knives (up and down), metres.
const STROKE: (f32, f32) = (0.09, 0.04);
/// Angular frequency of these motions, radians per second.
const BEAT: f32 = 9.0;

/// The target of a hand in a gesture, and the orientation of the held thing.
struct Aim {
    hand: Hand,
    point: Point3<f32>,
    hold: Hold,
    /// Whether the eyes follow the hand.
    looks: bool,
}

/// The orientation of a held thing.
#[derive(Debug, Clone, Copy)]
enum Hold {
    /// Tilted forwards by an angle, radians.
    Tilted(f32),
    /// With its broad side towards the eyes.
    Shown,
}

impl Figure {
    /// Shows the gesture of an action, such as a hand on the action's object or a cup at the mouth.
    pub(super) fn gesture(&mut self, home: &mut Environment, action: &Action, seconds: f32) {
        let motion = home.graph.vocabulary().rule(action.verb).map_or(Motion::Nothing, |rule| rule.motion);
        if action.object.is_some_and(|x| self.for_a_time(home, x, motion, seconds)) {
            return;
        }
        // Cups and books come to where the eyes are while the head is upright.
        let upright = matches!(motion, Motion::Drink | Motion::Eat | Motion::Read);
        let gaze = if upright { None } else { home.attended(self.agent, action.things()) };
        let doing = Activity { gesture: Some((motion, self.time)), gaze, ..Activity::default() };
        home.poses.insert(self.agent, doing);
        let share = self.eased(seconds);
        if let Some(aim) = self.aim(home, action, motion) {
            self.follow(home, &aim, share);
        }
    }

    /// The share of a gesture that is shown: all of it in the middle.
    fn eased(&self, seconds: f32) -> f32 {
        (self.time.min(seconds - self.time) / (EASE * seconds)).clamp(0.0, 1.0)
    }

    /// Shows for the time of a gesture what the effects of other verbs do for good: sitting on a thing, or holding it.
    /// Returns whether that can be done.
    fn for_a_time(&mut self, home: &mut Environment, thing: NodeId, motion: Motion, seconds: f32) -> bool {
        match motion {
            Motion::Sit => self.sit(home, thing, self.eased(seconds)),
            Motion::Hold => self.hold(home, thing, seconds),
            _ => false,
        }
    }

    /// The body sits on what is to sit on, lies on what is to lie on, and gets up again.
    fn sit(&self, home: &mut Environment, on: NodeId, share: f32) -> bool {
        let Some(settling) = Settling::begin(home, self.agent) else { return false };
        let affords = |what| home.graph.node(on).is_some_and(|node| node.affords(what));
        let (rests, shown) = match (affords(Property::Sittable), affords(Property::Lieable)) {
            (true, _) => (home.world.sit(self.agent, on, None), Effect::SitOn(on)),
            (_, true) => (home.world.lie(self.agent, on), Effect::LieOn(on)),
            _ => return false,
        };
        if rests.is_err() {
            return false;
        }
        // It is as bodies have it.
        drop(rule::carry_out(&mut home.graph, self.agent, &shown));
        settling.show(home, self.agent, share * SETTLING.seconds() as f32);
        true
    }

    /// A hand takes a thing as `grab` would, and brings it back the same way.
    fn hold(&mut self, home: &mut Environment, thing: NodeId, seconds: f32) -> bool {
        let gets_at = home.world.agent(self.agent).is_ok_and(|agent| {
            let distance = agent.reach_distance(thing);
            distance.is_ok_and(|distance| distance <= agent.plan().reach)
        });
        let mine = self.hand_of(home, thing).is_some();
        let Some(lay) = home.world.pose(thing).filter(|_| gets_at && !mine) else { return false };
        if !rule::allows(&home.graph, self.agent, &Action::grab(thing)) {
            return false;
        }
        let (hand, half) = (self.free_hand(home), self.time.min(seconds - self.time).max(0.0));
        let time = (half * (4.0 * OUT / seconds).max(1.0)).min(2.0 * OUT);
        if time > OUT {
            let load = load_of(&home.graph, thing);
            if home.world.grab_with_load(self.agent, hand, thing, &load).is_err() {
                return false;
            }
            // It is as bodies have it.
            drop(rule::carry_out(&mut home.graph, self.agent, &Effect::Hold(thing)));
            self.out = Some(self.feet(home).inverse() * lay);
        }
        self.time = time;
        self.take(home, hand, thing);
        true
    }

    /// Moves a hand and the thing it holds towards the gesture's target.
    fn follow(&mut self, home: &mut Environment, aim: &Aim, share: f32) {
        let feet = self.feet(home);
        if let Some(grip) = home.world.agent(self.agent).ok().and_then(|agent| agent.grip(aim.hand)) {
            let rest = *self.rest.get_or_insert(grip);
            let held = home.world.held(self.agent, aim.hand);
            let middle = held.and_then(|id| home.world.aabb(id)).map_or(Point3::origin(), |b| b.centre());
            // The middle of the thing in its own frame, computed from the present grip.
            let own = (feet * grip).inverse_transform_point(&middle);
            let turn = match aim.hold {
                Hold::Tilted(angle) => UnitQuaternion::from_axis_angle(&Vector3::y_axis(), angle) * rest.rotation,
                Hold::Shown => held.and_then(|id| self.shown(home, id, &rest.rotation)).unwrap_or(rest.rotation),
            };
            let at = feet.inverse_transform_point(&aim.point).coords - turn * own.coords;
            self.out = Some(Pose::from_parts(at.into(), turn));
            self.regrip(home, aim.hand, share);
        }
        let held = home.world.held(self.agent, aim.hand).and_then(|id| home.palm_on(self.agent, aim.hand, id));
        let (point, out) = held.map_or((aim.point, share), |point| (point, 1.0));
        if let Some(doing) = home.poses.get_mut(&self.agent) {
            let gaze = if aim.looks { share } else { 0.0 };
            doing.reach = Some(Reach { side: side(aim.hand), point, share: out, gaze });
        }
    }

    /// The hand that an action moves, and its target.
    fn aim(&self, home: &Environment, action: &Action, motion: Motion) -> Option<Aim> {
        if let Some(point) = action.aim.point().filter(|_| motion == Motion::Point) {
            let height = point.height().unwrap_or(self.feet(home).translation.z);
            let point = self.towards(home, &Point3::new(point.plan().x, point.plan().y, height))?;
            return Some(Aim { hand: self.free_hand(home), point, hold: Hold::Tilted(0.0), looks: true });
        }
        let (x, y) = (action.object?, action.target);
        let hand = match (self.hand_of(home, x), motion) {
            (Some(hand), Motion::Eat | Motion::Drink | Motion::Read | Motion::Pour | Motion::Fill) => hand,
            _ => self.tool_hand(home, x),
        };
        let from = self.side(home, hand);
        let box_of =
            |id: NodeId| std::iter::once(id).chain(home.graph.support_chain(id)).find_map(|id| home.world.aabb(id));
        let (swing, chop) = (STROKE.0 * (BEAT * self.time).sine(), STROKE.1 * (BEAT * self.time).sine().abs());
        let across = self.feet(home).rotation * Vector3::y();
        let level = Hold::Tilted(0.0);
        let (point, hold) = match motion {
            Motion::Drink => (self.at_mouth(home, x), Hold::Tilted(TILT.1)),
            Motion::Eat if self.hand_of(home, x).is_some() => (self.at_mouth(home, x), level),
            // The hand goes to the plate first, then to the mouth.
            Motion::Eat => {
                let bite = (2.0 * self.time - 1.0).clamp(0.0, 1.0);
                let plate = box_of(x)?.nearest(&from);
                (plate + (self.before_eyes(home, MOUTH) - plate) * bite, level)
            }
            Motion::Read => (self.before_eyes(home, BOOK), Hold::Shown),
            Motion::Pour => (above(&box_of(y?)?, ABOVE), Hold::Tilted(TILT.0)),
            Motion::Fill => (box_of(y?)?.nearest(&from), level),
            Motion::Point => (self.towards(home, &box_of(x)?.centre())?, level),
            Motion::Cut => (above(&box_of(x)?, 0.02 + chop), level),
            Motion::UseAt | Motion::Play => (box_of(x)?.nearest(&(from + across * swing)), level),
            #[rustfmt::skip]
            Motion::Nothing | Motion::Look | Motion::Go | Motion::Run
            | Motion::Wave | Motion::Dance | Motion::Exercise | Motion::Stretch => return None,
            _ => (box_of(x)?.nearest(&from), level),
        };
        // Hands find the mouth without looking.
        let looks = !matches!(motion, Motion::Drink | Motion::Eat);
        Some(Aim { hand, point, hold, looks })
    }

    /// The place of a hand that points somewhere.
    fn towards(&self, home: &Environment, to: &Point3<f32>) -> Option<Point3<f32>> {
        let shoulder = self.feet(home) * Point3::new(0.0, 0.0, 1.35);
        Some(shoulder + (to - shoulder).try_normalize(1e-3)? * POINTING)
    }

    fn before_eyes(&self, home: &Environment, offset: Vector3<f32>) -> Point3<f32> {
        let eyes = home
            .skeleton(self.agent)
            .map_or_else(|| Pose::translation(0.1, 0.0, Anthropometry::ADULT.view), |s| s.eyes());
        // Heads are taken as upright here, whatever their pose.
        self.feet(home) * (Point3::from(eyes.translation.vector) + offset)
    }

    /// The rotation, in the body's frame, that turns a thing's broad side to the eyes and its longest axis
    /// upright, with the smallest possible turn.
    fn shown(&self, home: &Environment, id: NodeId, now: &UnitQuaternion<f32>) -> Option<UnitQuaternion<f32>> {
        let half = home.graph.node(id)?.spec().bounds?.half;
        let (thin, long) = (half.imin(), half.imax());
        let along = |axis: usize, way: Vector3<f32>| way * (now * Vector3::ith(axis, 1.0)).dot(&way).signum();
        let to_eyes = (-BOOK).normalize();
        let across = along(thin, to_eyes);
        let up = along(long, (Vector3::z() - to_eyes * to_eyes.z).normalize());
        let sign = if (thin + 1) % 3 == long { 1.0 } else { -1.0 };
        let mut axes = Matrix3::zeros();
        // A cube has no broad side.
        let other = (0..3).find(|axis| thin != long && *axis != thin && *axis != long)?;
        for (axis, way) in [(thin, across), (long, up), (other, across.cross(&up) * sign)] {
            axes.set_column(axis, &way);
        }
        Some(UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes)))
    }

    /// The position of a held thing's middle while its upper rim is at the mouth.
    fn at_mouth(&self, home: &Environment, id: NodeId) -> Point3<f32> {
        let half = home.world.aabb(id).map_or_else(Vector3::zeros, |b| (b.max - b.min) / 2.0);
        self.before_eyes(home, MOUTH + Vector3::new(half.x.min(half.y), 0.0, -0.8 * half.z))
    }

    /// The hand that holds a thing.
    fn hand_of(&self, home: &Environment, id: NodeId) -> Option<Hand> {
        home.world.holder(id).filter(|(holder, _)| *holder == self.agent).map(|(_, hand)| hand)
    }

    /// The hand that holds a tool, which is any other thing than the action's object; or a free hand.
    fn tool_hand(&self, home: &Environment, thing: NodeId) -> Hand {
        let other = |hand: &Hand| home.world.held(self.agent, *hand).is_some_and(|held| held != thing);
        Hand::BOTH.into_iter().find(other).unwrap_or_else(|| self.free_hand(home))
    }
}

/// A point above the middle of a box.
fn above(aabb: &Aabb, height: f32) -> Point3<f32> {
    let middle = aabb.centre();
    Point3::new(middle.x, middle.y, aabb.max.z + height)
}
