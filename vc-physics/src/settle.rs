//! Settling of a scene, and a report about it.

use rapier3d::math::Vector;
use vc_graph::{Aabb, NodeId, Place, Pose, Relation};

use crate::state::Thing;
use crate::world::{HEADROOM, PhysicsWorld};
use crate::{BodyRole, convert};

/// The largest distance of a thing that counts as not moved, metres.
const STILL: f32 = 0.02;
/// The largest angle, radians.
const STRAIGHT: f32 = 0.1;
/// The smallest drop of a thing that has fallen, metres.
const DROP: f32 = 0.05;
/// The smallest penetration of two things that overlap, metres. At rest the engine leaves up to 5 mm.
const DEEP: f32 = 0.01;
/// The largest distance outside every room's box for things in a doorway, metres.
const DOORSTEP: f32 = 0.3;
/// What hangs farther than this from every room has strayed, metres.
const STRAYS: f32 = 5.0;

/// A thing that has moved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Displacement {
    /// The thing.
    pub id: NodeId,
    /// The distance of its origin from the former position, metres.
    pub distance: f32,
    /// The angle by which it has turned, radians.
    pub angle: f32,
    /// The drop of its centre of mass, metres.
    pub drop: f32,
}

/// The report about settling a scene.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Settling {
    /// Number of steps.
    pub steps: u32,
    /// Whether everything sleeps.
    pub at_rest: bool,
    /// Things that moved by more than 2 cm or 0.1 rad.
    pub moved: Vec<Displacement>,
    /// Things whose centre of mass is more than 5 cm lower than before.
    pub fell: Vec<NodeId>,
    /// Things that no longer rest on their support, or no longer are in their container, by the graph from
    /// which they were built.
    pub left: Vec<(NodeId, Place)>,
    /// Things outside every room, or below the floor.
    pub outside: Vec<NodeId>,
    /// Pairs of overlapping things, with their penetration depth, metres.
    pub overlapping: Vec<(NodeId, NodeId, f32)>,
    /// Things that became non-finite and were stopped.
    pub stopped: Vec<NodeId>,
}

impl Settling {
    /// Whether the scene came to rest with everything in its place.
    pub fn is_sound(&self) -> bool {
        let nothing = self.fell.is_empty() && self.left.is_empty() && self.outside.is_empty();
        self.at_rest && nothing && self.overlapping.is_empty() && self.stopped.is_empty()
    }
}

/// # Settling
impl PhysicsWorld {
    /// Steps until everything sleeps, at most `limit` times, and reports the changes.
    ///
    /// Bodies fall asleep a quarter of a second after they have come to rest, so a scene that is awake takes at
    /// least some twenty steps.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let report = world.settle(300);
    /// assert!(report.at_rest && report.is_sound());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn settle(&mut self, limit: u32) -> Settling {
        let before: Vec<(NodeId, Pose, Vector)> = self.loose().filter_map(|t| self.whereabouts(t)).collect();
        let known = self.stopped.len();
        let mut steps = 0;
        while steps < limit && (steps == 0 || !self.engine.is_at_rest()) {
            self.step();
            steps += 1;
        }
        let moved: Vec<Displacement> = before.iter().filter_map(|b| self.change(b)).collect();
        Settling {
            steps,
            at_rest: self.engine.is_at_rest(),
            fell: moved.iter().filter(|m| m.drop > DROP).map(|m| m.id).collect(),
            moved: moved.into_iter().filter(|m| m.distance > STILL || m.angle > STRAIGHT).collect(),
            left: self
                .things
                .iter()
                .filter(|t| matches!(t.state.role, BodyRole::Loose | BodyRole::Stopped))
                .filter_map(|t| Some((t.id, self.lost_place(t)?)))
                .collect(),
            outside: self.outside(),
            overlapping: self.overlapping(),
            stopped: self.stopped[known..].to_vec(),
        }
    }

    pub(crate) fn loose(&self) -> impl Iterator<Item = &Thing> {
        self.things.iter().filter(|t| t.state.role == BodyRole::Loose)
    }

    fn whereabouts(&self, thing: &Thing) -> Option<(NodeId, Pose, Vector)> {
        let body = self.engine.bodies.get(thing.state.base)?;
        Some((thing.id, convert::isometry(body.position()), body.center_of_mass()))
    }

    fn change(&self, (id, before, centre): &(NodeId, Pose, Vector)) -> Option<Displacement> {
        let (_, now, lower) = self.whereabouts(self.thing(*id).ok()?)?;
        let distance = (now.translation.vector - before.translation.vector).norm();
        let angle = now.rotation.angle_to(&before.rotation);
        Some(Displacement { id: *id, distance, angle, drop: centre.z - lower.z })
    }

    /// The place that the graph gave a thing, if the thing has left it.
    fn lost_place(&self, thing: &Thing) -> Option<Place> {
        let place = thing.state.rests?;
        self.index(place.at).ok()?;
        let kept = match place.relation {
            Relation::On => self.supports(thing.id).contains(&place.at),
            Relation::Inside => {
                let centre = self.centre_of_mass(thing)?;
                self.aabb(place.at).is_none_or(|b| grown(&b, 0.02).contains(&centre))
            }
            _ => true,
        };
        (!kept).then_some(place)
    }

    /// Loose and stopped things that are outside every room and over no ground around it, below the lowest floor, or in the ground below a
    /// floor; without rooms, those outside the bounding box of everything fixed. Hanging things are listed only
    /// if they are below all rooms, or more than five metres from each.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.place(home.cup, vc_graph::Pose::translation(9.0, 0.0, 1.0))?;
    /// assert_eq!(world.outside(), [home.cup]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn outside(&self) -> Vec<NodeId> {
        let (boxes, grounds) = (self.inside(), self.grounds());
        self.things.iter().filter(|t| self.is_beyond(t, &boxes, &grounds)).map(|t| t.id).collect()
    }

    /// Whether a thing is outside.
    pub(crate) fn is_outside(&self, thing: &Thing) -> bool {
        self.is_beyond(thing, &self.inside(), &self.grounds())
    }

    fn is_beyond(&self, thing: &Thing, boxes: &[Aabb], grounds: &[Aabb]) -> bool {
        let Some(centre) = self.centre_of_mass(thing) else { return false };
        let inside = boxes.is_empty() || boxes.iter().any(|b| b.contains(&centre));
        match thing.state.role {
            BodyRole::Loose | BodyRole::Stopped => !inside || grounds.iter().any(|b| b.contains(&centre)),
            BodyRole::Hung => {
                let strays = |room: &Aabb| centre.z < room.min.z || !grown(room, STRAYS).contains(&centre);
                !boxes.is_empty() && boxes.iter().all(strays)
            }
            BodyRole::Fixed | BodyRole::Carried => false,
        }
    }

    /// The boxes that contain the scene.
    fn inside(&self) -> Vec<Aabb> {
        // Grounds have bodies, which may reach farther than they are seen.
        let above = |ground: Aabb| Aabb { max: ground.max + nalgebra::Vector3::z() * HEADROOM, ..ground };
        let space = |(id, room): &(NodeId, Aabb)| self.aabb(*id).map_or_else(|| grown(room, DOORSTEP), above);
        let mut boxes: Vec<Aabb> = self.rooms.iter().map(space).collect();
        if boxes.is_empty() {
            let fixed = self.things.iter().filter(|t| t.state.role == BodyRole::Fixed).filter_map(|t| self.aabb(t.id));
            boxes.extend(fixed.reduce(|a, b| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) }));
            boxes.iter_mut().for_each(|b| b.max.z = f32::INFINITY);
        }
        boxes.extend(self.around());
        boxes
    }

    /// Pairs of things with a penetration depth beyond that which the engine leaves at rest, as of the last
    /// step.
    fn overlapping(&self) -> Vec<(NodeId, NodeId, f32)> {
        let deep = self.contacts().into_iter().filter(|c| c.depth > DEEP);
        deep.map(|c| (c.a, c.b, c.depth)).collect()
    }
}

fn grown(aabb: &Aabb, by: f32) -> Aabb {
    let by = nalgebra::Vector3::repeat(by);
    Aabb { min: aabb.min - by, max: aabb.max + by }
}
