//! Light as other programs know it: points and directions.

use nalgebra::{Point3, Vector3};
use vc_graph::NodeId;

use super::lamp::LUMENS;
use super::{Lighting, brightness};

/// A source of light without extent, in photometric units.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Source {
    /// The sun.
    Sun {
        /// Direction to it, unit length.
        towards: Vector3<f32>,
        /// Linear RGB, the greatest of them one.
        colour: [f32; 3],
        /// Light on a surface that faces it, lux.
        lux: f32,
    },
    /// A lamp that is on.
    Lamp {
        /// Which node.
        node: NodeId,
        /// The middle of what glows.
        at: Point3<f32>,
        /// Linear RGB, the greatest of them one.
        colour: [f32; 3],
        /// Mean intensity over all directions, candela.
        candela: f32,
    },
}

impl Lighting {
    /// The sun and the lamps that are on, as points and directions. What the sky and glowing things
    /// that are no lamps bring is not among them.
    pub fn sources(&self) -> Vec<Source> {
        let hue = |c: [f32; 3]| c.map(|v| v / c.iter().fold(1e-9_f32, |m, v| m.max(*v)));
        // Of a colour whose greatest part is one, what makes that light of it.
        let strength = |c: [f32; 3]| LUMENS * brightness(c) / brightness(hue(c)).max(1e-9);
        let sun: [f32; 3] = self.daylight.sun.into();
        let shines = self.daylight.check().is_ok() && self.daylight.sun.norm_squared() > 0.0;
        let sun = Source::Sun { towards: self.daylight.towards_sun, colour: hue(sun), lux: strength(sun) };
        let lamp = |l: &super::lamp::Lamp| Source::Lamp {
            node: self.tracer.snapshot.bodies[l.body as usize].node,
            at: l.at.into(),
            colour: hue(l.flux),
            candela: strength(l.flux) / (4.0 * std::f32::consts::PI),
        };
        shines.then_some(sun).into_iter().chain(self.lamps.iter().map(lamp)).collect()
    }
}
