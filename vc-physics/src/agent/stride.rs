//! One step of an agent: the engine's character controller, with the things in its way.

use nalgebra::{Point3, Vector2, Vector3};
use rapier3d::control::{CharacterAutostep, CharacterCollision, CharacterLength, KinematicCharacterController};
use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::math::Vector;
use rapier3d::parry::query::ShapeCastOptions;
use rapier3d::parry::shape::Capsule;
use rapier3d::pipeline::QueryFilter;
use vc_graph::NodeId;

use crate::convert::facing;
use crate::state::{Agent, BodyPlan, PUSH};
use crate::world::PhysicsWorld;
use crate::{convert, group};

/// The largest depth by which the feet of a placed agent are lifted onto a thing on the floor, metres.
/// Otherwise the agent would throw up a rug with everything on it.
const SUNK: f32 = 0.05;

/// Penetration depth that does not count as being in the ground, metres.
const TOUCH: f32 = 1e-3;

impl PhysicsWorld {
    /// Moves one agent for one step, as far as it gets.
    pub(super) fn stride(&mut self, id: NodeId, wish: Vector2<f32>) {
        let dt = self.settings.dt;
        let Some(agent) = self.agents.get(&id) else { return };
        let fall = if agent.grounded { 0.0 } else { agent.fall + self.settings.gravity * dt };
        let desired = Vector::new(wish.x * dt, wish.y * dt, -fall * dt);
        let (mut moved, mut grounded, hits) = self.slide(agent, desired);
        // A standing agent never steps, and a jumping agent never falls, to where there is no ground. An agent
        // that is placed there does fall, until the fall ends.
        let over_nothing = |way: Vector3<f32>| self.is_over_nothing(&(agent.feet * Point3::from(way)), agent.body);
        let ends = self.is_in_abyss(agent);
        let stays = || ends || agent.grounded || !over_nothing(Vector3::zeros());
        if !grounded && fall >= 0.0 && over_nothing(moved) && stays() {
            (moved, grounded) = (Vector3::zeros(), true);
        }
        if ends && !self.stopped.contains(&id) {
            self.stopped.push(id);
        }
        hits.iter().for_each(|hit| self.push_aside(id, hit, wish));
        // An agent that moves up has left the ground, however near it is.
        let grounded = grounded && fall >= 0.0;
        let Some(agent) = self.agents.get_mut(&id) else { return };
        agent.feet.translation.vector += moved;
        (agent.grounded, agent.fall) = (grounded, if grounded { 0.0 } else { fall });
        agent.velocity = [moved.x / dt, moved.y / dt];
        if grounded && !ends {
            agent.floor = agent.feet.translation.z;
        }
        if wish.norm() > 0.05 && agent.walk.is_ahead() {
            agent.feet.rotation = facing(wish.x, wish.y);
        }
        let at = agent.feet.translation.vector.xy().into();
        agent.walk.advance(at, moved.xy().norm());
    }

    /// How far an agent gets, whether it then stands on something, and what it hit.
    fn slide(&self, agent: &Agent, desired: Vector) -> (Vector3<f32>, bool, Vec<CharacterCollision>) {
        // Agents in one place, such as scripted walkers, separate as they move and do not climb each other.
        let own = |c: &Collider| self.agents.get(&group::marked(c.user_data).0).is_some_and(|a| a.is_with(agent));
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && !own(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let plan = &agent.plan;
        let middle = agent.feet * vc_graph::Pose::translation(0.0, 0.0, plan.height / 2.0);
        let mut hits = Vec::new();
        let legs = legs(plan, desired.z > 0.0);
        let moved =
            legs.move_shape(self.settings.dt, &queries, &upright(plan), &convert::pose(&middle), desired, |hit| {
                hits.push(hit)
            });
        (convert::vector3(moved.translation), moved.grounded, hits)
    }

    /// Lifts an agent that was placed inside something low onto it, but not onto people.
    pub(super) fn step_up(&mut self, id: NodeId) {
        let Some(agent) = self.agents.get(&id) else { return };
        let is_person = |c: &Collider| self.agents.contains_key(&group::marked(c.user_data).0);
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && !is_person(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let above = agent.feet * vc_graph::Pose::translation(0.0, 0.0, agent.plan.height / 2.0 + SUNK);
        let options = ShapeCastOptions { max_time_of_impact: SUNK, ..ShapeCastOptions::default() };
        let ground = queries.cast_shape(&convert::pose(&above), -Vector::Z, &upright(&agent.plan), options);
        // Anything that overlaps the raised body at once is not ground.
        let depth = ground.map(|(_, hit)| hit.time_of_impact).filter(|gap| *gap > 0.0).map(|gap| SUNK - gap);
        let Some(agent) = self.agents.get_mut(&id) else { return };
        agent.feet.translation.z += depth.filter(|depth| *depth > TOUCH).unwrap_or(0.0);
        agent.floor = agent.feet.translation.z;
    }

    /// Pushes a loose thing that a walker has run into.
    fn push_aside(&mut self, id: NodeId, hit: &CharacterCollision, wish: Vector2<f32>) {
        let Some(limit) = self.agents.get(&id).map(|a| a.plan.pushes) else { return };
        let Some(body) = self.engine.colliders.get(hit.handle).and_then(|c| c.parent()) else { return };
        let dt = self.settings.dt;
        let Some(rigid) = self.engine.body_mut(body).filter(|b| b.is_dynamic() && b.mass() <= limit) else {
            return;
        };
        let Some(way) = wish.try_normalize(1e-3) else { return };
        let way = Vector::new(way.x, way.y, 0.0);
        let missing = wish.norm() - rigid.linvel().dot(way);
        let impulse = (rigid.mass() * missing).clamp(0.0, PUSH * dt);
        rigid.apply_impulse(way * impulse, true);
    }
}

/// The shape of a standing body.
fn upright(plan: &BodyPlan) -> Capsule {
    Capsule::new_z(plan.height / 2.0 - plan.radius, plan.radius)
}

/// The controller for an agent's legs, which keep to the ground unless they jump.
fn legs(plan: &BodyPlan, jumping: bool) -> KinematicCharacterController {
    KinematicCharacterController {
        up: Vector::Z,
        offset: CharacterLength::Absolute(0.01),
        slide: true,
        autostep: (!jumping).then_some(CharacterAutostep {
            max_height: CharacterLength::Absolute(plan.step),
            min_width: CharacterLength::Absolute(0.1),
            include_dynamic_bodies: false,
        }),
        max_slope_climb_angle: plan.slope,
        min_slope_slide_angle: plan.slope,
        snap_to_ground: (!jumping).then_some(CharacterLength::Absolute(plan.step)),
        ..KinematicCharacterController::default()
    }
}
