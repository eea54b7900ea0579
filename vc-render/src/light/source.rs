//! Light sources for other programs: points and directions.

use nalgebra::{Point3, Vector3};
use vc_graph::NodeId;

use super::Lighting;
use super::lamp::LUMENS;
use crate::colour::luminance;

/// A light source without extent, in photometric units, from [`Lighting::sources`].
///
/// ```
/// # use std::sync::Arc;
/// # use vc_graph::asset::{Material, Part, Shape};
/// # use vc_graph::{Asset, AssetLibrary, Draft, Pose, SceneBuilder};
/// use vc_render::{Daylight, Renderer, Source};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let material = Material { emission: [30.0; 3], ..Material::new("warm_bulb", [0.9; 3]) };
/// # let mut library = AssetLibrary::default();
/// # let material = library.add_material(material)?;
/// # let shape = Shape::Sphere { radius: 0.12 };
/// # let bulb = Part { name: "bulb".into(), shape, material, pose: Pose::identity(), joint: None };
/// # let bulb = library.add(Asset { name: "lamp".into(), parts: vec![bulb], ..Asset::default() })?;
/// # scene.assets(Arc::new(library));
/// # let lamp = Draft { asset: Some(bulb), ..Draft::new("ceiling_lamp").at(Pose::translation(1.0, 0.0, 2.2)) };
/// # let lamp = scene.add_in(kitchen, lamp)?;
/// # let mut renderer = Renderer::new();
/// let mut snapshot = renderer.snapshot(&scene.build())?;
/// snapshot.switch(lamp, true)?;
/// let lighting = renderer.light(&snapshot, &Daylight::night());
/// for source in lighting.sources() {
///     let Source::Lamp { node, candela, .. } = source else { continue };
///     assert_eq!(node, lamp);
///     assert!(candela > 100.0 && candela < 200.0); // about 2000 lumens, to all sides
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Source {
    /// The sun.
    Sun {
        /// Direction to the sun, unit length.
        towards: Vector3<f32>,
        /// Linear RGB; the greatest component is one.
        colour: [f32; 3],
        /// Illuminance on a surface that faces it, lux.
        lux: f32,
    },
    /// A lamp that is on.
    Lamp {
        /// The lamp's node.
        node: NodeId,
        /// Centre of its luminous parts.
        at: Point3<f32>,
        /// Linear RGB; the greatest component is one.
        colour: [f32; 3],
        /// Mean intensity over all directions, candela.
        candela: f32,
    },
}

impl Lighting {
    /// The sun and the lamps that are on, as directions and points. Light of the sky and of luminous things
    /// that are not lamps is not included. Costs a few operations for each lamp that is on.
    pub fn sources(&self) -> Vec<Source> {
        let hue = |c: [f32; 3]| c.map(|v| v / c.iter().fold(1e-9_f32, |m, v| m.max(*v)));
        // The intensity that gives this light when multiplied with a colour whose greatest component is one.
        let strength = |c: [f32; 3]| LUMENS * luminance(c) / luminance(hue(c)).max(1e-9);
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
