//! Getting up from a seat or a bed.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::{NodeId, Pose};

use crate::AgentError;
use crate::state::{Agent, Posture};
use crate::world::PhysicsWorld;

/// Distances from the place at which an agent may get up, metres, and their step.
const EXITS: (f32, f32) = (0.45, 1.75);

const EXIT_STEP: f32 = 0.05;

/// Number of directions to each side in which exits are searched.
const EXIT_TURNS: usize = 12;

/// # Getting up
impl PhysicsWorld {
    /// Gets an agent up from where it sits or lies, to the nearest free place around the seat, places in front
    /// first.
    ///
    /// # Errors
    /// [`AgentError::Posture`] if the agent stands, [`AgentError::NoExit`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.6, 1.5, 0.0))?;
    /// world.sit(home.person, home.chair, None)?;
    /// world.stand_up(home.person)?;
    /// assert_eq!(world.posture(home.person), Some(vc_physics::Posture::Standing));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stand_up(&mut self, agent: NodeId) -> Result<(), AgentError> {
        let exit = self.exit_where(agent, |_| true)?;
        self.teleport(agent, exit)
    }

    /// Gets up all agents that sit or lie on a thing: to the nearest free place, or where they are.
    pub(crate) fn clear_seat(&mut self, id: NodeId) {
        let on_it = |(agent, body): (&NodeId, &Agent)| {
            body.posture.seat().is_some_and(|(seat, _)| seat == id).then_some((*agent, body.feet))
        };
        for (agent, feet) in self.agents.iter().filter_map(on_it).collect::<Vec<_>>() {
            let exit = self.exit_where(agent, |_| true).unwrap_or(feet);
            // It is there, and its pose is sound.
            let _ = self.teleport(agent, exit);
        }
    }

    /// The nearest free place beside the seat of an agent that a condition admits, to which it can get up.
    pub(crate) fn exit_where(&self, agent: NodeId, admits: impl Fn(&Pose) -> bool) -> Result<Pose, AgentError> {
        let body = self.agent_state(agent)?;
        let Some((seat, _)) = body.posture.seat() else {
            return Err(AgentError::Posture { agent, posture: Posture::Standing.as_str() });
        };
        let good = |spot: &Pose| self.is_exit(body, seat, spot) && admits(spot);
        self.exits(body).find(good).ok_or(AgentError::NoExit(seat))
    }

    /// Spots around a seat: near before far, in front of the seat first.
    fn exits(&self, body: &Agent) -> impl Iterator<Item = Pose> + use<> {
        let (place, floor) = (body.feet, body.floor);
        let steps = ((EXITS.1 - EXITS.0) / EXIT_STEP).round() as usize;
        let turn = |step: usize| std::f32::consts::PI * step as f32 / EXIT_TURNS as f32;
        let turns = (0..=EXIT_TURNS).flat_map(move |step| [turn(step), -turn(step)]);
        (0..=steps).map(|i| EXITS.0 + EXIT_STEP * i as f32).flat_map(move |far| {
            turns.clone().map(move |angle: f32| {
                let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
                let mut spot = place * Pose::from_parts((turn * Vector3::x() * far).into(), turn);
                spot.translation.z = floor;
                spot
            })
        })
    }

    /// Whether an agent can get up to a spot: the body fits, there is a floor, and no wall is between.
    fn is_exit(&self, body: &Agent, seat: NodeId, spot: &Pose) -> bool {
        let at = Point3::from(spot.translation.vector);
        let ground = self.ray(at + Vector3::z() * 0.3, at - Vector3::z() * 0.3, &[]);
        let (from, to) = (body.shoulder(), at + Vector3::z() * (body.shoulder().z - at.z).max(0.5));
        let ignored: Vec<NodeId> = self.agents.keys().copied().chain([seat]).collect();
        ground.is_some() && self.ray(from, to, &ignored).is_none() && self.fits(body, spot)
    }
}
