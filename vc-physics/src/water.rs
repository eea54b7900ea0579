//! Water: buoyancy, and fill levels of containers.
//!
//! Buoyancy is exact for the convex pieces of a body: their triangles are cut at the water's surface, and the
//! part below gives the displaced volume and its centre (Catto, "Exact buoyancy for polyhedra", Game
//! Programming Gems 6, 2006).

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBody;
use vc_graph::asset::{Hold, Surface};
use vc_graph::portable::Portable;
use vc_graph::{Aabb, NodeId, Pose};

use crate::convert::facing;
use crate::state::{Thing, Water};
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert};

/// Density of water, kilograms per cubic metre.
const DENSITY: f32 = 1000.0;
/// Drag coefficient of a body about as wide as long.
const DRAG: f32 = 1.0;
/// Rate of the damping of bobbing and rolling by waves, per second, for a body that displaces its own mass: a
/// block loses a third of its amplitude from one bob to the next.
const WAVES: f32 = 3.0;
/// The submerged share from which on a body makes no waves.
const DEEP: f32 = 0.999;
/// The speed from which on a floating body may not fall asleep, metres per second: it is then a millimetre or
/// two from equilibrium.
const RESTLESS: f32 = 0.01;
/// Added mass as a share of the displaced water: that of a sphere.
const ADDED: f32 = 0.5;

/// # Water
impl PhysicsWorld {
    /// Adds still water that fills a box: a pool, a pond, a sea.
    ///
    /// # Errors
    /// [`PhysicsError::BadWater`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let pool = vc_graph::Aabb { min: [-1.0, -2.0, 0.0].into(), max: [1.0, -1.0, 0.5].into() };
    /// world.add_water(&pool)?;
    /// world.place(home.cup, vc_graph::Pose::translation(0.0, -1.5, 0.2))?;
    /// world.run(300);
    /// assert!(world.aabb(home.cup).is_some_and(|cup| cup.max.z > 0.5)); // Wood floats.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_water(&mut self, filled: &Aabb) -> Result<(), PhysicsError> {
        let (size, centre) = (filled.max - filled.min, filled.centre());
        let at = Pose::translation(centre.x, centre.y, filled.min.z);
        self.pour(Water::new(at, [size.x / 2.0, size.y / 2.0, size.z], None)?);
        Ok(())
    }

    /// The boxes around water along the world's axes, in the order in which it was added.
    pub fn waters(&self) -> Vec<Aabb> {
        self.waters.all.iter().map(Water::aabb).collect()
    }

    /// Fills a container to a level, 0 to 1. Things float in a fixed container with space inside (a bath, a
    /// sink); for a cup the level is only a state.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`]; [`PhysicsError::BadWater`] for a container without depth.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.fill(home.cup, 0.8)?;
    /// assert_eq!(world.body(home.cup)?.level(), 0.8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fill(&mut self, id: NodeId, level: f32) -> Result<(), PhysicsError> {
        let thing = self.thing(id)?;
        if !level.is_finite() {
            return Err(PhysicsError::NotFinite("the level", id));
        }
        let level = level.clamp(0.0, 1.0);
        let basin = (thing.state.role == BodyRole::Fixed).then(|| self.basin(thing, level)).flatten();
        let basin = basin.filter(|_| level > 0.0);
        let water = basin.map(|(at, size)| Water::new(at, size, Some(id))).transpose()?;
        self.drain(id);
        self.waters.levels.insert(id, level);
        if let Some(water) = water {
            self.pour(water);
        }
        Ok(())
    }

    /// Removes the water from a container.
    pub(crate) fn drain(&mut self, id: NodeId) {
        if self.waters.drain(id) {
            self.engine.bodies.iter_mut().for_each(|(_, body)| let_go(body));
        }
    }

    /// The pose and size of the water in a container's largest inner surface at a level.
    fn basin(&self, thing: &Thing, level: f32) -> Option<(Pose, [f32; 3])> {
        let area = |s: &&Surface| s.half.0 * s.half.1;
        let inner = thing.form.surfaces.iter().filter(|s| s.hold == Hold::Inside && s.joint.is_none());
        let surface = inner.max_by(|a, b| area(a).total_cmp(&area(b)))?;
        let pose = self.engine.pose(thing.state.base)?;
        let depth = surface.clearance.unwrap_or(thing.form.extent.1.z - surface.centre.z).max(0.0) * level;
        let (bottom, front) = (pose * surface.centre, pose * Vector3::x());
        let at = Pose::from_parts(bottom.into(), facing(front.x, front.y));
        Some((at, [surface.half.0, surface.half.1, depth]))
    }

    /// Adds water, and wakes the bodies in it.
    fn pour(&mut self, water: Water) {
        let loose = self.things.iter().filter(|t| t.state.role == BodyRole::Loose).map(|t| t.state.base);
        let bodies: Vec<_> = loose.collect();
        for body in bodies {
            let is_in_it = |rigid: &RigidBody| {
                let centre = convert::point3(rigid.center_of_mass());
                water.holds(&centre) && centre.z <= water.level()
            };
            if self.engine.bodies.get(body).is_some_and(is_in_it)
                && let Some(rigid) = self.engine.body_mut(body)
            {
                rigid.wake_up(true);
            }
        }
        self.waters.all.push(water);
    }

    /// Applies forces to awake bodies in water.
    pub(crate) fn push_floating(&mut self) {
        if self.waters.all.is_empty() {
            return;
        }
        let (dt, gravity) = (self.engine.dt(), self.settings.gravity);
        let awake: Vec<_> = self.engine.awake_bodies().collect();
        for handle in awake {
            let Some(body) = self.engine.body_mut(handle).filter(|b| b.is_dynamic()) else { continue };
            let_go(body);
            let (id, link) = crate::group::marked(body.user_data);
            let (centre, pose) = (convert::point3(body.center_of_mass()), convert::isometry(body.position()));
            let Some(water) = self.waters.around(&centre) else { continue };
            let Ok(thing) = self.thing(id) else { continue };
            let Some(link) = thing.form.links.get(link) else { continue };
            let below = submerged(link.mesh(), &pose, water.level());
            if let (Some(below), Some(body)) = (below, self.engine.body_mut(handle)) {
                float(body, &below, dt, gravity);
            }
        }
    }
}

/// Removes the water's forces of the last step from a body.
fn let_go(body: &mut RigidBody) {
    body.reset_forces(false);
    body.reset_torques(false);
}

/// The part of a body below the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Submerged {
    volume: f32,
    centre: Point3<f32>,
    /// The share of the whole body.
    share: f32,
}

/// The volume below a level and its centre, by tetrahedra from a point of the surface to every triangle below
/// it: the lid has no volume in this sum and need not be built.
fn submerged(mesh: &[[Point3<f32>; 3]], pose: &Pose, level: f32) -> Option<Submerged> {
    let apex = Point3::new(pose.translation.x, pose.translation.y, level);
    let (mut volume, mut moment, mut whole) = (0.0, Vector3::zeros(), 0.0);
    for triangle in mesh {
        let corners = triangle.map(|p| pose * p - apex);
        whole += tetrahedron(corners).0;
        let (polygon, count) = below(&corners);
        for i in 1..count.saturating_sub(1) {
            let (v, m) = tetrahedron([polygon[0], polygon[i], polygon[i + 1]]);
            volume += v;
            moment += m;
        }
    }
    let centre = apex + moment / volume;
    let sound = volume > 1e-9 && whole > 0.0 && convert::is_finite(&centre.coords);
    sound.then(|| Submerged { volume, centre, share: (volume / whole).min(1.0) })
}

/// The signed volume of a tetrahedron with its fourth corner at the origin, and the volume times its centre.
fn tetrahedron([a, b, c]: [Vector3<f32>; 3]) -> (f32, Vector3<f32>) {
    let volume = a.dot(&b.cross(&c)) / 6.0;
    (volume, (a + b + c) * (volume / 4.0))
}

/// The part of a triangle at or below zero height: at most four corners.
fn below(triangle: &[Vector3<f32>; 3]) -> ([Vector3<f32>; 4], usize) {
    let (mut polygon, mut count) = ([Vector3::zeros(); 4], 0);
    for (i, a) in triangle.iter().enumerate() {
        let b = &triangle[(i + 1) % 3];
        if a.z <= 0.0 {
            polygon[count] = *a;
            count += 1;
        }
        if (a.z <= 0.0) != (b.z <= 0.0) {
            polygon[count] = a + (b - a) * (a.z / (a.z - b.z));
            count += 1;
        }
    }
    (polygon, count)
}

/// Applies buoyancy, drag, and damping by waves. The added mass of the water slows the body, which also keeps
/// light bodies from being flung up.
fn float(body: &mut RigidBody, below: &Submerged, dt: f32, gravity: f32) {
    if body.linvel().length() > RESTLESS {
        // A bobbing body is slow at every turn but does not rest yet.
        body.activation_mut().time_since_can_sleep = 0.0;
    }
    let (mass, displaced) = (body.mass(), DENSITY * below.volume);
    let slower = mass / (mass + ADDED * displaced);
    let weight = mass * gravity;
    // The engine adds gravity itself: only the difference is applied here.
    let lift = displaced * gravity - weight;
    let velocity = body.linvel();
    let area = nalgebra::ComplexField::cbrt(below.volume).raised(2);
    let drag = 0.5 * DENSITY * DRAG * area * velocity.length() * dt / (mass + ADDED * displaced);
    // Waves scale with the displaced water relative to the body's mass, not with the submerged share: otherwise
    // a light body that floats high would bob for minutes. A deeply submerged body makes none.
    let waves = if below.share < DEEP { WAVES * displaced / (mass + ADDED * displaced) * dt } else { 0.0 };
    let slow = 1.0 / (1.0 + drag + waves);
    let spin = 1.0 / (1.0 + waves + body.angvel().length() * below.share * dt);
    body.set_linvel(velocity * slow, false);
    body.set_angvel(body.angvel() * spin, false);
    // A force, as gravity, which the engine distributes over the substeps. An impulse at the start of the step
    // would leave a floating body with a speed, and it would never sleep.
    let force = Vector3::z() * (lift * slower + weight);
    body.add_force_at_point(convert::vector(force), convert::point(below.centre), false);
}
