//! Walking along a path, and the doors on it.

use nalgebra::{Point2, Translation3};
use vc_graph::{NodeId, Pose, Relation};
use vc_people::Activity;

use super::Player;
use crate::environment::Environment;
use crate::environment::clock::along;
use crate::environment::execute::towards;

/// Distance to a door at which a walker opens it, and at which it shuts it, metres.
const AT_DOOR: (f32, f32) = (1.1, 1.2);
/// Share of its range that a door moves per second while somebody walks through.
const SWING: f32 = 1.6;
/// Longest wait for a door, seconds.
const PATIENCE: f32 = 1.0;
/// Duration of the transition from standing to walking, seconds.
const SETTLING: f32 = 0.3;
/// Tolerance for the position of a door, as a share of its range.
const STILL: f32 = 1e-3;
/// Distance of the points along a path that are tested for doors, metres.
const FINE: f32 = 0.1;
/// Turning speed, radians per second: a right angle in a quarter of a second.
const TURN: f32 = 6.3;

/// A door that is passed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage {
    /// Its opening before.
    was: f32,
    /// Its opening while somebody passes.
    wide: f32,
    /// Its position along the path, metres.
    at: f32,
}

impl Player {
    pub(super) fn walk(
        &mut self,
        show: &mut Environment,
        points: &[Point2<f32>],
        doors: &[NodeId],
        feet: &Pose,
        run: bool,
    ) -> bool {
        let plan = show.world.agent(self.agent).map(|agent| *agent.plan()).unwrap_or_default();
        let way = self.time * if run { plan.run } else { plan.walk };
        if self.doors.is_empty() {
            self.doors = doors.iter().filter_map(|door| Some((*door, passage(show, points, *door)?))).collect();
        }
        let Some((at, front)) = along(points, way) else {
            show.poses.remove(&self.agent);
            let turned = self.turn(show, feet);
            // The walker waits until the door behind it is shut, or jams.
            self.handling.waited += show.world.settings().dt;
            let swings = self.handling.waited < PATIENCE && self.swing_doors(show, f32::INFINITY);
            if swings || !turned {
                return false;
            }
            let left = std::mem::take(&mut self.doors);
            left.into_iter().for_each(|(door, passage)| drop(show.world.put_open(door, None, passage.was)));
            return true;
        };
        self.swing_doors(show, way);
        self.turn(show, &Pose::from_parts(Translation3::new(at.x, at.y, feet.translation.z), towards(front)));
        let from = self.from.clone().filter(|_| self.time < SETTLING);
        let transition = from.map(|from| (from, self.time / SETTLING));
        show.poses.insert(self.agent, Activity { walked: Some(way), transition, ..Activity::default() });
        false
    }

    /// Puts the feet at a pose's position and turns them towards its orientation; returns whether they have
    /// reached it.
    pub(super) fn turn(&self, show: &mut Environment, feet: &Pose) -> bool {
        let now = self.feet(show);
        let most = TURN * show.world.settings().dt;
        let left = now.rotation.angle_to(&feet.rotation);
        let turned = now.rotation.try_slerp(&feet.rotation, most / left.max(most), 1e-6);
        let rotation = turned.filter(|_| left > most).unwrap_or(feet.rotation);
        let _ = show.world.teleport(self.agent, Pose::from_parts(feet.translation, rotation));
        left <= most
    }

    /// Opens doors that are near and returns those behind to their former opening; returns whether any door
    /// moves.
    fn swing_doors(&self, show: &mut Environment, way: f32) -> bool {
        let (step, mut moving) = (SWING * show.world.settings().dt, false);
        for (&door, passage) in &self.doors {
            let Some(now) = show.world.parts(door).openness() else { continue };
            let wanted = if way > passage.at + AT_DOOR.1 {
                passage.was
            } else if way > passage.at - AT_DOOR.0 {
                passage.wide
            } else {
                now
            };
            let next = now + (wanted - now).clamp(-step, step);
            moving |= (wanted - now).abs() > STILL && show.world.put_open(door, None, next).is_ok();
        }
        moving
    }
}

/// The position at which a path passes a door. Anything but a door between rooms is shut before the walker
/// arrives.
fn passage(show: &Environment, points: &[Point2<f32>], door: NodeId) -> Option<Passage> {
    let (middle, was) = (show.world.aabb(door)?.centre().xy(), show.world.parts(door).openness()?);
    let length: f32 = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let far = |at: f32| along(points, at).map(|(p, _)| ((p - middle).norm(), at));
    let all = (0..=(length / FINE) as u32).filter_map(|i| far(i as f32 * FINE));
    let (_, at) = all.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
    let is_room_door = show.graph.related(door, Relation::Between).next().is_some();
    Some(Passage { was, wide: if is_room_door { 1.0 } else { 0.0 }, at })
}
