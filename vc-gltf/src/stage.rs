//! The cameras and lights of an exported scene.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;

use super::document as json;
use super::write::Writer;

/// The cameras of a scene, and its lights apart from emissive objects.
///
/// ```
/// use nalgebra::Vector3;
/// use vc_gltf::{LightPlace, Stage, StageLight};
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("kitchen"))?;
/// let place = LightPlace::Directional { towards: Vector3::z(), lux: 50_000.0 };
/// let sun = StageLight { name: "sun".into(), colour: [1.0; 3], place };
/// let file = vc_gltf::staged_scene(&scene.build(), &Stage { lights: vec![sun], ..Stage::default() })?;
/// assert!(String::from_utf8_lossy(&file).contains("KHR_lights_punctual"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stage {
    /// The cameras.
    pub cameras: Vec<StageCamera>,
    /// Lights.
    pub lights: Vec<StageLight>,
}

/// A pinhole camera.
#[derive(Debug, Clone, PartialEq)]
pub struct StageCamera {
    /// Its name.
    pub name: String,
    /// Its optical frame in the world: x to the right, y down, z forward.
    pub pose: Pose,
    /// Vertical field of view, radians.
    pub vertical_fov: f32,
    /// Width over height.
    pub aspect: f32,
    /// The near clipping distance, metres.
    pub near: f32,
}

/// A light source without extent.
#[derive(Debug, Clone, PartialEq)]
pub struct StageLight {
    /// Its name.
    pub name: String,
    /// Linear RGB.
    pub colour: [f32; 3],
    /// The light's direction or position.
    pub place: LightPlace,
}

/// The direction or position of a light, and its strength.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LightPlace {
    /// A directional light, such as the sun.
    Directional {
        /// The direction towards the light.
        towards: Vector3<f32>,
        /// The illuminance of a surface that faces it, lux.
        lux: f32,
    },
    /// A point light.
    Point {
        /// The point, metres.
        point: Point3<f32>,
        /// Intensity, candela.
        candela: f32,
    },
}

/// Adds the nodes of a stage and returns their indices.
pub(super) fn write(writer: &mut Writer<'_>, stage: &Stage) -> Vec<usize> {
    let cameras = stage.cameras.iter().filter(|c| c.is_sound());
    let mut nodes: Vec<usize> = cameras.map(|camera| camera.write(writer)).collect();
    nodes.extend(stage.lights.iter().filter_map(|light| light.write(writer)));
    nodes
}

impl StageCamera {
    fn is_sound(&self) -> bool {
        let positive = |v: f32| v.is_finite() && v > 0.0;
        let pose = self.pose.translation.vector.iter().chain(self.pose.rotation.coords.iter()).all(|v| v.is_finite());
        pose && [self.vertical_fov, self.aspect, self.near].into_iter().all(positive)
            && self.vertical_fov < std::f32::consts::PI
    }

    fn write(&self, writer: &mut Writer<'_>) -> usize {
        let perspective =
            json::Perspective { yfov: self.vertical_fov, aspect_ratio: Some(self.aspect), znear: self.near };
        writer.document.cameras.push(json::Camera { name: self.name.clone(), kind: "perspective".into(), perspective });
        // glTF's cameras have y up and look along -z.
        let turned =
            self.pose.rotation * UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.0, 1.0, 0.0, 0.0));
        writer.node(json::Node {
            name: self.name.clone(),
            camera: Some(writer.document.cameras.len() - 1),
            translation: Some(self.pose.translation.vector.into()),
            rotation: Some(turned.into_inner().normalize().coords.into()),
            ..json::Node::default()
        })
    }
}

impl StageLight {
    /// Writes a light; `None` if its position or strength is invalid.
    fn write(&self, writer: &mut Writer<'_>) -> Option<usize> {
        let (kind, intensity, at, turned) = match self.place {
            LightPlace::Directional { towards, lux } => {
                // A directional light shines along the node's -z.
                let up = towards.try_normalize(1e-9)?;
                let turn = UnitQuaternion::rotation_between(&Vector3::z(), &up)
                    .unwrap_or_else(|| UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.0, 1.0, 0.0, 0.0)));
                ("directional", lux, None, Some(turn.into_inner().normalize().coords.into()))
            }
            LightPlace::Point { point, candela } => ("point", candela, Some(point.coords), None),
        };
        let finite = at.iter().flatten().chain(&self.colour).all(|v| v.is_finite()) && intensity.is_finite();
        if !finite || intensity < 0.0 {
            return None;
        }
        let color = self.colour.map(|c| c.clamp(0.0, 1.0));
        let lights = &mut writer.document.extensions.get_or_insert_default().lights.lights;
        lights.push(json::Light { name: self.name.clone(), kind: kind.into(), color, intensity });
        let light = lights.len() - 1;
        Some(writer.node(json::Node {
            name: self.name.clone(),
            translation: at.map(Into::into),
            rotation: turned,
            extensions: Some(json::NodeExtensions { light: json::LightOf { light } }),
            ..json::Node::default()
        }))
    }
}
