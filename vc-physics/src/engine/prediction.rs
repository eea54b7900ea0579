//! Preparation of a step: contact prediction and continuous collision detection where bodies are fast.

use rapier3d::dynamics::RigidBody;
use vc_graph::portable::Portable;

use super::{Engine, PREDICTION};
use crate::convert;

/// The contact prediction distance of a fast body, metres, if it moves that far in one step.
const AHEAD: f32 = 0.25;
/// Bodies faster than this use continuous collision detection, metres per second.
const FAST: f32 = 2.5;
/// So do bodies that turn faster, radians per second.
const WHIRLING: f32 = 15.0;
/// The speed beyond which a body is taken as lost, metres or radians per second: the engine's distance
/// computations fail long before the range of floats ends.
const WILD: f32 = 1e4;
/// Below this angular speed a body's gyroscopic moment is ignored. The moment grows with the square of the
/// speed and is computed in every substep. Radians per second.
const TURNING: f32 = 1.0;

impl Engine {
    /// Enables contact prediction for fast bodies and disables it for slow ones, since it costs time. A body is
    /// slow if it moves less in a step than the general prediction distance. Bodies that turn slowly get no
    /// gyroscopic moment, bodies that are too fast are stopped, and continuous collision detection is on only
    /// in steps with a body for which prediction may not suffice.
    pub(super) fn predict_contacts(&mut self) {
        let slow = (PREDICTION / self.parameters.dt).raised(2);
        let ahead = |body: &RigidBody| if body.linvel().length_squared() > slow { AHEAD } else { 0.0 };
        let turns = |body: &RigidBody| body.angvel().length_squared() > TURNING * TURNING;
        let (mut differing, mut wild, mut swept) = (Vec::new(), Vec::new(), false);
        for handle in self.islands.active_bodies() {
            let Some(body) = self.bodies.get(handle) else { continue };
            let (speed, spin) = (body.linvel().length_squared(), body.angvel().length_squared());
            let place = body.position().translation;
            if speed > WILD * WILD || spin > WILD * WILD || place.abs().max_element() > convert::FARTHEST {
                wild.push(handle);
            }
            swept |= speed > FAST * FAST || spin > WHIRLING * WHIRLING;
            if body.soft_ccd_prediction() != ahead(body) || body.gyroscopic_forces_enabled() != turns(body) {
                differing.push(handle);
            }
        }
        for handle in differing {
            if let Some(body) = self.body_mut(handle) {
                body.set_soft_ccd_prediction(ahead(body));
                body.enable_gyroscopic_forces(turns(body));
            }
        }
        for handle in wild {
            if let Some(body) = self.body_mut(handle) {
                // The engine stops bodies with NaN and reports them.
                body.set_linvel(rapier3d::math::Vector::splat(f32::NAN), false);
            }
        }
        self.parameters.max_ccd_substeps = usize::from(swept);
    }
}
