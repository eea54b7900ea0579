//! The ground below floors, and the end of a fall past their edge.
//!
//! A floor of a scene may be as thin as paper: fast falling things pass through it within a step, and thin
//! things are pushed out at the wrong side. Therefore everything below a floor is solid, down to the next thing
//! of the scene. Things that get past the edge of the floor fall, and are soon stopped.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBodyHandle;
use vc_graph::{Aabb, Node, NodeId, ObjectRole, Pose, SceneGraph};

use crate::shapes::Form;
use crate::state::{Agent, Thing};
use crate::world::PhysicsWorld;
use crate::{BodyRole, convert, group};

/// Depth of the ground below a thin floor if nothing is there, metres: more than twice the distance that
/// anything falls in a step of a sixtieth of a second.
const DEPTH: f32 = 1.0;
/// Smallest thickness of a floor that needs no ground, metres: such a floor stops things that fall from a few
/// metres. The thinner a body is, the finer are the engine's distances to it.
const THICK: f32 = 0.19;
/// Largest overlap of boxes that count as beside each other, metres.
const BESIDE: f32 = 0.02;
/// Cosine of the tilt beyond which a floor is a ramp.
const LEVEL: f32 = 0.999;
/// Largest depth of a thing's middle in the ground, metres: the thickness of mats.
const SUNK: f32 = 0.02;
/// Distance below all fixed things at which a falling thing is stopped, metres.
const ABYSS: f32 = 2.0;

/// The boxes that may be below a floor: rooms, and other floors.
pub(crate) struct Storeys(Vec<Aabb>);

impl Storeys {
    pub(crate) fn new(graph: &SceneGraph) -> Self {
        let rooms = graph.rooms().iter().copied();
        let floors = graph.of_role(ObjectRole::Floor);
        Self(rooms.filter_map(|id| graph.node(id)).chain(floors).filter_map(Node::aabb).collect())
    }

    /// The depth of the ground below a node, metres; zero if it is not a floor.
    pub(crate) fn ground_below(&self, node: &Node, form: &Form, pose: &Pose) -> f32 {
        if node.role() != ObjectRole::Floor || (pose.rotation * Vector3::z()).z < LEVEL {
            return 0.0;
        }
        let own = around(form, pose);
        if own.max.z - own.min.z >= THICK {
            return 0.0;
        }
        let across =
            |other: &Aabb| (0..2).all(|i| other.min[i] < own.max[i] - BESIDE && own.min[i] < other.max[i] - BESIDE);
        let below = |other: &&Aabb| other.min.z < own.min.z - BESIDE && other.max.z <= own.max.z && across(other);
        let free = |other: &Aabb| (own.min.z - other.max.z).max(0.0);
        self.0.iter().filter(below).map(free).fold(DEPTH, f32::min)
    }
}

/// The bounding box of a form at a pose.
fn around(form: &Form, pose: &Pose) -> Aabb {
    let (low, high) = form.extent;
    let corner =
        |i: usize| pose * Point3::from(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
    let start = Aabb { min: corner(0), max: corner(0) };
    (1..8).map(corner).fold(start, |b, p| Aabb { min: b.min.inf(&p), max: b.max.sup(&p) })
}

impl PhysicsWorld {
    /// Records the height of the lowest fixed thing's bottom.
    pub(crate) fn find_bottom(&mut self) {
        let fixed = self.things.iter().filter(|t| t.state.role == BodyRole::Fixed);
        let low = fixed.filter_map(|t| Some(around(&t.form, &self.engine.pose(t.state.base)?).min.z));
        self.bottom = low.reduce(f32::min).unwrap_or(f32::NEG_INFINITY);
    }

    /// The ground below each floor as a bounding box, up to the height to which mats may sink in.
    pub(crate) fn grounds(&self) -> Vec<Aabb> {
        let floors = self.things.iter().filter(|t| t.state.ground > 0.0);
        let ground = |floor: &Thing| {
            let own = around(&floor.form, &self.engine.pose(floor.state.base)?);
            let (deep, sunk) = (Vector3::z() * floor.state.ground, Vector3::z() * SUNK);
            Some(Aabb { min: own.min - deep, max: own.max - sunk })
        };
        floors.filter_map(ground).collect()
    }

    /// Stops things that have fallen below all fixed things: their middles, as an origin may be far from its box.
    pub(crate) fn stop_fallen(&mut self, awake: &[RigidBodyHandle]) {
        let deep = self.bottom - ABYSS;
        let fell = |body: &RigidBodyHandle| {
            let body = self.engine.bodies.get(*body).filter(|b| b.is_dynamic() && b.center_of_mass().z < deep)?;
            Some(group::marked(body.user_data).0)
        };
        let fallen: Vec<NodeId> = awake.iter().filter_map(fell).collect();
        for id in fallen {
            // The thing has a body, since it fell, so this cannot fail.
            let _ = self.set_role(id, BodyRole::Stopped);
            if !self.stopped.contains(&id) {
                self.stopped.push(id);
            }
        }
    }

    /// Whether an agent has fallen to the end of a fall: below all fixed things or, if there are none, below
    /// its former floor.
    pub(crate) fn is_in_abyss(&self, agent: &Agent) -> bool {
        let bottom = if self.bottom.is_finite() { self.bottom } else { agent.floor };
        agent.feet.translation.z < bottom - ABYSS
    }

    /// Whether there is nothing solid anywhere below a point.
    pub(crate) fn is_over_nothing(&self, point: &Point3<f32>, but: RigidBodyHandle) -> bool {
        use rapier3d::geometry::{Collider, ColliderHandle, Ray};
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && c.parent() != Some(but);
        let filter = rapier3d::pipeline::QueryFilter::default().exclude_sensors().predicate(&solid);
        let far = (point.z - self.bottom).clamp(0.0, convert::LARGEST) + ABYSS;
        let ray = Ray::new(convert::point(*point), convert::vector(-Vector3::z()));
        self.engine.queries(filter).cast_ray(&ray, far, true).is_none()
    }
}
