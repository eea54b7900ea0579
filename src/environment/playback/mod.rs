//! Actions in time: every tick can be observed and rendered.
//!
//! An action is done at once first, which gives its [`Course`]; then a copy of the environment as
//! it was plays that course tick by tick. [`walk`] moves feet and doors, [`hands`] what hands do,
//! [`rest`] bodies that sit down or get up, [`gaze`] is where eyes are turned, and [`gesture`] is what is only seen.

mod gaze;
mod gesture;
mod hands;
mod rest;
mod walk;

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use vc_graph::{Action, ChangeSet, Effect, NodeId, Pose, rule};
use vc_physics::{Hand, Posture};

use super::act::{self, Done};
use super::course::{BodyMotion, Course, is_on_foot};
use super::{ActionError, Environment, observe};
use vc_people::Skeleton;
use walk::Passage;

/// Seconds for what is only seen as done: dressing, letting go.
const PAUSE: f32 = 0.8;
/// Ticks after which a show ends whatever happens: two minutes.
const LONGEST: u32 = 7200;
/// How far a step may take somebody who does not walk by it, metres: onto the floor.
const PUSHED: f32 = 1e-3;

impl Environment {
    /// Lets agents act side by side, tick by tick: `watch` is shown the environment after
    /// every tick, with poses, doors, limbs, relations and states as they are then, so that it can
    /// be observed and rendered, and at last as it is in the end. The end is that of
    /// [`set_actions`](Self::set_actions), bit for bit.
    ///
    /// Walkers are taken along their way at 1.2 m/s (3 m/s when they run), which keeps clear
    /// of everything that stands on the floor; doors swing open before them and shut behind
    /// them. Hands go to what they take, put down, wipe or eat, and what they hold goes with them.
    /// What motors drive, what falls and what is put down moves by `World::step`; after each tick
    /// comes `Relations::update_with`. A tick costs some tenths of a millisecond.
    pub fn set_actions_in_time(
        &mut self,
        actions: &[(NodeId, Action)],
        mut watch: impl FnMut(&Self),
    ) -> Vec<Result<ChangeSet, ActionError>> {
        let mut show = self.clone();
        let done = self.in_order(actions, |home, agent, action| home.act(agent, action));
        let mut players: Vec<Player> = Vec::new();
        let mut outcomes = Vec::with_capacity(done.len());
        for ((agent, _), outcome) in actions.iter().zip(done) {
            outcomes.push(outcome.map(|Done { changes, course }| {
                players.push(Player::new(*agent, course));
                changes
            }));
        }
        players.sort_by_key(|p| p.agent);
        for _ in 0..LONGEST {
            let busy = players.iter_mut().fold(false, |busy, player| player.tick(&mut show) | busy);
            if !busy {
                break;
            }
            show.step_around_people();
            let changed: Vec<NodeId> = players.iter_mut().flat_map(|p| std::mem::take(&mut p.changed)).collect();
            show.look(&changed);
            watch(&show);
        }
        if !players.is_empty() {
            watch(self);
        }
        outcomes
    }

    /// One agent's action in time; see [`set_actions_in_time`](Self::set_actions_in_time).
    ///
    /// # Errors
    /// As [`set_action`](Self::set_action).
    ///
    /// ```no_run
    /// use virtualcity::Environment;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let fridge = home.graph().of_class("fridge")[0];
    /// let mut way = Vec::new();
    /// home.set_action_in_time(me, format!("walk fridge.{}", fridge.0).parse()?, |now| {
    ///     way.extend(now.world().pose(me).map(|feet| feet.translation.vector));
    /// })?;
    /// println!("{} ticks of a sixtieth of a second", way.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_action_in_time(
        &mut self,
        agent: NodeId,
        action: Action,
        watch: impl FnMut(&Self),
    ) -> Result<ChangeSet, ActionError> {
        let mut outcomes = self.set_actions_in_time(&[(agent, action)], watch);
        outcomes.pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }

    /// A step in which nobody is pushed: where people stand is known, and a door that swings
    /// before one moves nobody beside it.
    fn step_around_people(&mut self) {
        let stands = |agent: &NodeId| self.world.posture(*agent) == Some(Posture::Standing);
        let standing = self.agents().iter().copied().filter(stands);
        let feet: Vec<(NodeId, Pose)> = standing.filter_map(|a| Some((a, self.world.pose(a)?))).collect();
        self.world.step();
        for (agent, before) in feet {
            let now = self.world.pose(agent).unwrap_or(before);
            if (now.translation.vector - before.translation.vector).xy().norm() > PUSHED {
                let _ = self.world.teleport(agent, before);
            }
        }
    }

    /// Observes what has moved in a tick, and what the rule has changed.
    fn look(&mut self, changed: &[NodeId]) {
        // For the moment between two ticks things may be where no relation can be told; then those
        // before hold.
        let _ = observe::look_again(&mut self.graph, &self.start, &self.world, &mut self.relations, changed);
    }
}

/// An agent that shows what it did.
pub(super) struct Player {
    agent: NodeId,
    course: Course,
    next: usize,
    /// Since the beat began, seconds.
    time: f32,
    /// Doors that it opens in passing.
    doors: BTreeMap<NodeId, Passage>,
    /// What its hands are at.
    handling: hands::Handling,
    /// How its body was as the beat began.
    from: Option<Skeleton>,
    /// Between which postures it is.
    settling: Option<rest::Settling>,
    /// What the rule has changed in this tick.
    changed: Vec<NodeId>,
}

impl Player {
    /// Shows a motion at a time since it began, seconds; a hand that comes back brings a thing from a pose against the feet.
    pub(super) fn at(agent: NodeId, time: f32, out: Option<Pose>) -> Self {
        let mut player = Self::new(agent, Course::default());
        (player.time, player.handling.out) = (time, out);
        player
    }

    fn new(agent: NodeId, course: Course) -> Self {
        let (doors, handling, changed) = (BTreeMap::new(), hands::Handling::default(), Vec::new());
        Self { agent, course, next: 0, time: 0.0, doors, handling, from: None, settling: None, changed }
    }

    /// Does what is due in a tick; gives whether there is more to come.
    fn tick(&mut self, show: &mut Environment) -> bool {
        let Some(beat) = self.course.motions.get(self.next).cloned() else {
            show.poses.remove(&self.agent);
            return false;
        };
        let before = self.time;
        if before == 0.0 {
            self.from = show.skeleton(self.agent);
        }
        self.time += show.world.settings().dt;
        if self.play(show, &beat, before) {
            self.come_true(show);
            show.poses.remove(&self.agent);
            self.handling = hands::Handling::default();
            (self.next, self.time) = (self.next + 1, 0.0);
        }
        true
    }

    /// What the rule says of this beat is the case from now on.
    fn come_true(&mut self, show: &mut Environment) {
        let last = self.next + 1 == self.course.motions.len();
        let due = |at: &Option<usize>| at.map_or(last, |at| at == self.next);
        let effects: Vec<_> = self.course.effects.extract_if(.., |(at, _)| due(at)).collect();
        for (_, effect) in effects {
            // Where somebody goes, feet say; where a thing is put, the thing.
            if matches!(effect, Effect::GoTo(_) | Effect::Approach(_) | Effect::PoseAs(..)) || is_on_foot(&effect) {
                continue;
            }
            // The end of the action is known already: what cannot be shown is skipped.
            let changes = rule::carry_out(&mut show.graph, self.agent, &effect).unwrap_or_default();
            self.changed.extend(changes.changes().iter().filter_map(act::holder));
            self.changed.push(self.agent);
        }
    }

    /// Plays a beat; gives whether it is over. What cannot be shown is skipped: the end of
    /// the action is known already.
    fn play(&mut self, show: &mut Environment, beat: &BodyMotion, before: f32) -> bool {
        let agent = self.agent;
        match beat {
            BodyMotion::Walk { points, doors, feet, run } => self.walk(show, points, doors, feet, *run),
            BodyMotion::Turn(feet) => self.turn(show, feet),
            BodyMotion::Take(hand, id, side) => self.take(show, (*hand, *side), *id, before),
            BodyMotion::Nudge(parts) => {
                parts.iter().for_each(|(id, part, open)| drop(show.world.put_open(*id, Some(*part), *open)));
                true
            }
            BodyMotion::Steady(things) => {
                things.iter().for_each(|id| drop(show.world.pin(*id, None)));
                true
            }
            BodyMotion::Push(moved) => {
                for (id, pose) in moved {
                    drop(show.world.place(*id, *pose).and_then(|()| show.world.wake(*id)));
                }
                true
            }
            BodyMotion::Fold(id, scale) => {
                fold(show, *id, *scale);
                true
            }
            BodyMotion::Put(put) => self.put(show, put, before),
            // A course has only the one that succeeded.
            BodyMotion::PutAgain(..) | BodyMotion::ClearAway(..) | BodyMotion::PutBack(_) => true,
            BodyMotion::ComeToRest | BodyMotion::Fill(..) => true,
            BodyMotion::LetGo(hand) => self.at_once(show, before, |show| drop(show.world.drop(agent, *hand))),
            BodyMotion::Dress(id) => self.at_once(show, before, |show| drop(show.world.remove(*id))),
            BodyMotion::Undress(hand, id) => self.at_once(show, before, |show| undress(show, agent, *hand, *id)),
            BodyMotion::Drive(drive) => self.drive(show, drive, before),
            BodyMotion::Rest(id, lying, seat) => self.settle(show, before, |show| {
                let world = &mut show.world;
                drop(match seat {
                    Some(seat) => world.sit(agent, *id, Some(*seat)),
                    None if *lying => world.lie(agent, *id),
                    None => world.sit(agent, *id, None),
                });
            }),
            BodyMotion::GetUp(feet) => self.settle(show, before, |show| drop(show.world.teleport(agent, *feet))),
            BodyMotion::Gesture(action, seconds) => self.gesture(show, action, *seconds),
        }
    }

    fn at_once(&mut self, show: &mut Environment, before: f32, act: impl FnOnce(&mut Environment)) -> bool {
        if before == 0.0 {
            act(show);
            self.come_true(show);
        }
        self.time >= PAUSE
    }

    /// An agent's feet, or its seat.
    fn feet(&self, show: &Environment) -> Pose {
        show.world.pose(self.agent).unwrap_or_else(Pose::identity)
    }

    /// Where a hand is when it does nothing, about: from there one reaches.
    fn side(&self, show: &Environment, hand: Hand) -> Point3<f32> {
        let side = if hand == Hand::Right { -0.2 } else { 0.2 };
        let up = if show.world.posture(self.agent) == Some(Posture::Standing) { 1.05 } else { 0.4 };
        self.feet(show) * Point3::new(0.3, side, up)
    }
}

/// A share of the way from one pose to another.
fn between(from: &Pose, to: &Pose, share: f32) -> Pose {
    let turn = from.rotation.try_slerp(&to.rotation, share, 1e-6).unwrap_or(to.rotation);
    Pose::from_parts(from.translation.vector.lerp(&to.translation.vector, share).into(), turn)
}

fn fold(show: &mut Environment, id: NodeId, scale: Vector3<f32>) {
    let mut edit = show.graph.edit();
    // It is there, and the scale is sound.
    let _ = edit.set_scale(id, scale);
    edit.commit();
    let _ = show.world.reshape(&show.graph, id, &show.start.shapes);
    show.look_anew();
}

fn undress(show: &mut Environment, agent: NodeId, hand: Hand, id: NodeId) {
    let feet = show.world.pose(agent).unwrap_or_else(Pose::identity);
    let inserted = show.world.insert(&show.graph, id, &show.start.shapes).is_ok();
    if inserted && show.world.place(id, feet * Pose::translation(0.3, 0.0, 1.0)).is_ok() {
        drop(show.world.grab(agent, hand, id));
    }
}
