//! Direct control of a body, tick by tick.

use nalgebra::{Point3, Vector2, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{ChangeSet, NodeId};

use super::control::WITHOUT;
use super::{ActionError, Attempt, Environment, PhysicalRefusal};

/// The control input of a body for one tick.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Steering {
    /// The wanted velocity in metres per second along X and Y of the world.
    pub velocity: Vector2<f32>,
    /// The heading: the angle from X towards Y, radians.
    pub heading: f32,
    /// Whether the body jumps, if it stands on something.
    pub jump: bool,
}

impl Environment {
    /// Lets one tick pass in which an agent's body moves as it is steered: the character controller climbs
    /// steps, slides along walls and pushes light things away. Everything else moves by itself. The relations
    /// of things that have moved are observed again.
    ///
    /// This serves a person at a keyboard, or a policy for locomotion. It is not an action: the transition rule
    /// is not asked, and the history does not record it. It uses `PhysicsWorld::go`, `PhysicsWorld::jump`,
    /// `PhysicsWorld::step`, `PhysicsWorld::turn` and `Relations::update_nodes`.
    ///
    /// # Errors
    /// [`ActionError::Impossible`] if bodies do nothing here
    /// ([`EnvironmentBuilder::bodies`](crate::EnvironmentBuilder::bodies)), there is no such agent, it does not stand, or a
    /// number is not finite,
    /// [`ActionError::Busy`] while it acts or is under [control](Self::control); in these cases no time has passed.
    ///
    /// ```
    /// use nalgebra::Vector2;
    /// use virtualcity::{Environment, Steering};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let jump = Steering { jump: true, velocity: Vector2::new(0.4, 0.0), ..Steering::default() };
    /// let before = home.world().pose(me).ok_or("no body")?;
    /// home.steer(me, &jump)?;
    /// for _ in 0..5 {
    ///     home.steer(me, &Steering { jump: false, ..jump })?;
    /// }
    /// let now = home.world().pose(me).ok_or("no body")?;
    /// assert!(now.translation.z > before.translation.z, "it is in the air");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn steer(&mut self, agent: NodeId, steering: &Steering) -> Result<ChangeSet, ActionError> {
        let labels = self.graph.clone();
        let attempt = Attempt::named("steer");
        let impossible =
            |why: PhysicalRefusal| ActionError::Impossible { attempt: attempt.clone(), why: why.in_scene(&labels) };
        if !self.start.time.bodies {
            return Err(impossible(PhysicalRefusal::NotModelled(WITHOUT)));
        }
        if !steering.heading.is_finite() {
            let refused = vc_physics::PhysicsError::NotFinite("the heading", agent);
            return Err(impossible(refused.into()));
        }
        if self.current_action(agent).is_some() || self.controlled(agent).is_some() {
            return Err(ActionError::Busy(self.graph.label(agent)));
        }
        self.world.go(agent, steering.velocity).map_err(|e| impossible(e.into()))?;
        self.stays_aside(agent);
        if steering.jump {
            self.world.jump(agent).map_err(|e| impossible(e.into()))?;
        }
        let before = self.graph.clone();
        self.pass_tick();
        let (sin, cos) = steering.heading.sine_cosine();
        if let Some(feet) = self.world.pose(agent) {
            let ahead = Point3::from(feet.translation.vector + Vector3::new(cos, sin, 0.0));
            let turned = self.world.agent(agent).and_then(|agent| agent.turned_to(ahead));
            let turned = turned.map_err(|e| impossible(e.into()))?;
            self.world.turn(agent, turned.rotation).map_err(|e| impossible(e.into()))?;
        }
        self.world.go(agent, Vector2::zeros()).map_err(|e| impossible(e.into()))?;
        self.clock.unseen = true;
        self.read_moved().map_err(impossible)?;
        Ok(ChangeSet::between(&before, &self.graph))
    }

    /// Pushes a loose thing with an impulse at a point, newton seconds and metres: a gust, a foot, whatever disturbs an
    /// experiment. It is no action; the thing moves in the ticks that follow. It uses `PhysicsWorld::push`.
    ///
    /// # Errors
    /// [`PhysicalRefusal`] for what is no loose thing, or numbers that are not finite; nothing has changed then.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use virtualcity::Environment;
    /// use virtualcity::graph::clock::Span;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let chair = home.graph().of_class("dining_chair")[0];
    /// let middle = home.world().body(chair)?.centre_of_mass();
    /// home.push(chair, Vector3::new(0.0, 0.0, 10.0), middle)?;
    /// home.step(Span(6));
    /// assert!(home.world().body(chair)?.centre_of_mass().z > middle.z + 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn push(&mut self, thing: NodeId, impulse: Vector3<f32>, at: Point3<f32>) -> Result<(), PhysicalRefusal> {
        let pushed = self.world.push(thing, impulse, at);
        pushed.map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        (self.clock.stirred, self.clock.unseen) = (true, true);
        let pushed = self.graph.carried_with(thing);
        self.set_adrift(&pushed);
        Ok(())
    }
}
