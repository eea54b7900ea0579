//! Actions in time: every tick can be observed and rendered.

use std::collections::BTreeMap;

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Action, ChangeSet, NodeId, Pose, Verb};
use vc_physics::{Hand, Posture};

use super::act::Done;
use super::beat::Beat;
use super::deed::{comes_along, towards};
use super::{ActionError, Environment, observe};
use crate::figure::Doing;

/// Seconds in which a hand goes out and comes back.
const REACHING: f32 = 0.55;
/// Seconds for sitting down, lying down and getting up.
const RESTING: f32 = 0.8;
/// How near a walker is to a door when it opens it, metres, and how far when it shuts it.
const AT_DOOR: (f32, f32) = (1.1, 1.2);
/// Share of its way a door moves in a second as one walks through.
const SWING: f32 = 1.6;
/// Ticks after which a show ends whatever happens: two minutes.
const LONGEST: u32 = 7200;

impl Environment {
    /// Lets agents act side by side, tick by tick: `watch` is shown the environment after
    /// every tick, with poses, doors and limbs as they are, so that it can be observed and
    /// rendered. The end is that of [`set_actions`](Self::set_actions), bit for bit.
    ///
    /// Walkers are taken along their way at 1.2 m/s (3 m/s when they run), which keeps clear
    /// of everything that stands on the floor; doors swing open before them and shut behind
    /// them. What motors drive, what falls and what is put down moves by `World::step`.
    /// Relations in the graph shown are those before the actions.
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
            outcomes.push(outcome.map(|Done { changes, beats }| {
                players.push(Player { agent: *agent, beats, next: 0, time: 0.0, doors: BTreeMap::new() });
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
            // Poses of bodies are finite.
            let _ = observe::write_poses(&mut show.graph, &show.world);
            watch(&show);
        }
        outcomes
    }

    /// One agent's action in time; see [`set_actions_in_time`](Self::set_actions_in_time).
    ///
    /// # Errors
    /// As [`set_action`](Self::set_action).
    pub fn set_action_in_time(
        &mut self,
        agent: NodeId,
        action: Action,
        watch: impl FnMut(&Self),
    ) -> Result<ChangeSet, ActionError> {
        let mut outcomes = self.set_actions_in_time(&[(agent, action)], watch);
        outcomes.pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }
}

/// How far a step may take somebody who does not walk by it, metres: onto the floor.
const PUSHED: f32 = 1e-3;

impl Environment {
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
}

/// An agent that shows what it did.
struct Player {
    agent: NodeId,
    beats: Vec<Beat>,
    next: usize,
    /// Since the beat began, seconds.
    time: f32,
    /// How far open the doors were that it opens in passing.
    doors: BTreeMap<NodeId, f32>,
}

impl Player {
    /// Does what is due in a tick; gives whether there is more to come.
    fn tick(&mut self, show: &mut Environment) -> bool {
        let Some(beat) = self.beats.get(self.next).cloned() else {
            show.poses.remove(&self.agent);
            return false;
        };
        let before = self.time;
        self.time += show.world.settings().dt;
        if self.play(show, &beat, before) {
            show.poses.remove(&self.agent);
            (self.next, self.time) = (self.next + 1, 0.0);
        }
        true
    }

    /// Plays a beat; gives whether it is over. What cannot be shown is skipped: the end of
    /// the action is known already.
    fn play(&mut self, show: &mut Environment, beat: &Beat, before: f32) -> bool {
        let agent = self.agent;
        match beat {
            Beat::Walk { points, doors, feet, run } => self.walk(show, points, doors, feet, *run),
            Beat::Turn(feet) => {
                let _ = show.world.teleport(agent, *feet);
                true
            }
            Beat::Take(hand, id) => {
                let at = show.world.aabb(*id).map(|b| b.centre());
                self.by_hand(show, at, before, |show| {
                    let Environment { world, graph, .. } = show;
                    drop(world.grab_with(agent, *hand, *id, |load| comes_along(graph, load, *id)));
                })
            }
            Beat::Nudge(parts) => {
                parts.iter().for_each(|(id, part, open)| drop(show.world.put_open(*id, *part, *open)));
                true
            }
            Beat::Push(moved) => {
                moved.iter().for_each(|(id, pose)| drop(show.world.place(*id, *pose)));
                true
            }
            Beat::Fold(id, scale) => {
                fold(show, *id, *scale);
                true
            }
            Beat::Put(hand, _, pose) => {
                let at = Some(Point3::from(pose.translation.vector));
                self.by_hand(show, at, before, |show| drop(show.world.put(agent, *hand, *pose)))
            }
            Beat::LetGo(hand) => self.at_once(show, before, |show| drop(show.world.drop(agent, *hand))),
            Beat::Dress(id) => self.at_once(show, before, |show| drop(show.world.remove(*id))),
            Beat::Undress(hand, id) => self.at_once(show, before, |show| undress(show, agent, *hand, *id)),
            Beat::Drive(id, open) => self.drive(show, *id, *open, before),
            Beat::Rest(id, lying) => self.at_once(show, before, |show| {
                let world = &mut show.world;
                drop(if *lying { world.lie(agent, *id) } else { world.sit(agent, *id) });
            }),
            Beat::GetUp => self.at_once(show, before, |show| drop(show.world.stand_up(agent))),
            Beat::Gesture(verb, seconds) => self.gesture(show, *verb, *seconds),
        }
    }

    /// What a hand does when it has gone out; then it comes back.
    fn by_hand(
        &mut self,
        show: &mut Environment,
        at: Option<Point3<f32>>,
        before: f32,
        act: impl FnOnce(&mut Environment),
    ) -> bool {
        if before < REACHING && self.time >= REACHING {
            act(show);
        }
        let share = (self.time.min(2.0 * REACHING - self.time) / REACHING).clamp(0.0, 1.0);
        let doing = Doing { reach: at.map(|p| (p, share)), ..Doing::default() };
        show.poses.insert(self.agent, doing);
        self.time >= 2.0 * REACHING
    }

    fn at_once(&mut self, show: &mut Environment, before: f32, act: impl FnOnce(&mut Environment)) -> bool {
        if before == 0.0 {
            act(show);
        }
        self.time >= RESTING
    }

    fn drive(&mut self, show: &mut Environment, id: NodeId, open: f32, before: f32) -> bool {
        let at = show.world.aabb(id).map(|b| {
            let feet = show.world.pose(self.agent).unwrap_or_else(Pose::identity);
            b.nearest(&(feet * Point3::new(0.3, 0.0, 1.05)))
        });
        let parts = show.world.moving_parts(id).len();
        if show.world.is_driven(id) {
            // The hand stays at it.
            self.time = self.time.min(REACHING + show.world.settings().dt);
        }
        let held = show.world.holder(id).is_some();
        let over = self.by_hand(show, at, before, |show| match held {
            true => drop(show.world.put_all_open(id, open)),
            false => (0..parts).for_each(|part| drop(show.world.drive(id, part, open))),
        });
        over && !show.world.is_driven(id)
    }

    fn gesture(&mut self, show: &mut Environment, verb: Verb, seconds: f32) -> bool {
        let doing = Doing { gesture: Some((verb, self.time)), ..Doing::default() };
        show.poses.insert(self.agent, doing);
        self.time >= seconds
    }

    fn walk(
        &mut self,
        show: &mut Environment,
        points: &[Point2<f32>],
        doors: &[NodeId],
        feet: &Pose,
        run: bool,
    ) -> bool {
        let plan = show.world.body_plan(self.agent).copied().unwrap_or_default();
        let way = self.time * if run { plan.run } else { plan.walk };
        self.doors_on_the_way(show, points, doors, way);
        let Some((at, front)) = along(points, way) else {
            let left: Vec<(NodeId, f32)> = std::mem::take(&mut self.doors).into_iter().collect();
            left.into_iter().for_each(|(door, was)| drop(show.world.put_all_open(door, was)));
            let _ = show.world.teleport(self.agent, *feet);
            return true;
        };
        let now = show.world.pose(self.agent).unwrap_or(*feet);
        // One turns at most a right angle in a quarter of a second.
        let turn = now.rotation.angle_to(&towards(front)).max(1e-6);
        let share = (6.3 * show.world.settings().dt / turn).min(1.0);
        let rotation = now.rotation.try_slerp(&towards(front), share, 1e-6).unwrap_or_else(|| towards(front));
        let pose = Pose::from_parts(nalgebra::Translation3::new(at.x, at.y, feet.translation.z), rotation);
        let _ = show.world.teleport(self.agent, pose);
        show.poses.insert(self.agent, Doing { walked: Some(way), ..Doing::default() });
        false
    }

    /// Opens doors that are near, and brings those that are behind back to where they were.
    fn doors_on_the_way(&mut self, show: &mut Environment, points: &[Point2<f32>], doors: &[NodeId], way: f32) {
        let step = SWING * show.world.settings().dt;
        for &door in doors {
            let (Some(aabb), Some(now)) = (show.world.aabb(door), show.world.openness(door)) else { continue };
            let middle = aabb.centre().xy();
            let far = |way: f32| along(points, way).map_or(f32::INFINITY, |(p, _)| (p - middle).norm());
            let nearest = (0..200).map(|i| (i as f32 * 0.1, far(i as f32 * 0.1)));
            let crossed = nearest.reduce(|a, b| if b.1 < a.1 { b } else { a }).map_or(0.0, |(at, _)| at);
            let is_room_door = show.graph.related(door, vc_graph::Relation::Between).next().is_some();
            let wide = if is_room_door { 1.0 } else { 0.0 };
            let was = *self.doors.entry(door).or_insert(now);
            let wanted = if way > crossed + AT_DOOR.1 {
                was
            } else if way > crossed - AT_DOOR.0 {
                wide
            } else {
                now
            };
            let next = now + (wanted - now).clamp(-step, step);
            if next != now {
                drop(show.world.put_all_open(door, next));
            }
        }
    }
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

/// Where one is after so many metres of a way, and which way one goes there; `None` after
/// its end.
fn along(points: &[Point2<f32>], mut way: f32) -> Option<(Point2<f32>, nalgebra::Vector2<f32>)> {
    for pair in points.windows(2) {
        let step = pair[1] - pair[0];
        let length = step.norm();
        if way < length {
            return Some((pair[0] + step * (way / length), step / length));
        }
        way -= length;
    }
    None
}
