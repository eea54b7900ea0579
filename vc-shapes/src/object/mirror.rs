//! Mirror images, such as a door hinged on the other side.

use std::sync::Arc;

use nalgebra::{Isometry3, Point3, Quaternion, UnitQuaternion, Vector3};
use vc_graph::asset::{Joint, JointKind, Shape};
use vc_graph::{Asset, Pose};

use super::Object;

impl Object {
    /// The mirror image of the object, with left and right exchanged.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_shapes::{Style, object};
    /// let door = object::generator("door").ok_or("no generator")?.object(&Style::from_seed(Seed(1)), Seed(1));
    /// let other = door.mirrored();
    /// assert_eq!(door.asset.parts.len(), other.asset.parts.len());
    /// assert_eq!(door.size(), other.size());
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        mirror(&mut mirrored.asset);
        mirrored.bounds.offset.y = -mirrored.bounds.offset.y;
        mirrored
    }
}

fn mirror(asset: &mut Asset) {
    asset.name = Arc::from(format!("{} (mirrored)", asset.name));
    for part in asset.parts.iter_mut().chain(&mut asset.collision) {
        part.pose = mirrored_pose(&part.pose);
        mirror_shape(&mut part.shape);
        part.joint = part.joint.map(mirrored_joint);
    }
    for surface in &mut asset.surfaces {
        surface.centre.y = -surface.centre.y;
        surface.joint = surface.joint.map(mirrored_joint);
    }
}

fn mirrored_pose(pose: &Pose) -> Pose {
    let (t, q) = (pose.translation.vector, pose.rotation.coords);
    let turn = UnitQuaternion::new_unchecked(Quaternion::new(q.w, -q.x, q.y, -q.z));
    Isometry3::from_parts(Vector3::new(t.x, -t.y, t.z).into(), turn)
}

/// The axis of a hinge is a pseudovector: it is mirrored with the opposite sign of a direction.
fn mirrored_joint(joint: Joint) -> Joint {
    let a = joint.axis;
    let axis = match joint.kind {
        JointKind::Hinge => Vector3::new(-a.x, a.y, -a.z),
        JointKind::Slide => Vector3::new(a.x, -a.y, a.z),
    };
    Joint { anchor: Point3::new(joint.anchor.x, -joint.anchor.y, joint.anchor.z), axis, ..joint }
}

/// Shapes that are their own mirror images are unchanged.
fn mirror_shape(shape: &mut Shape) {
    match shape {
        Shape::Hull { points } => points.iter_mut().for_each(|p| p.y = -p.y),
        Shape::Extrusion { outline, .. } => {
            outline.iter_mut().for_each(|p| p.1 = -p.1);
            outline.reverse();
        }
        Shape::Mesh { vertices, triangles, .. } => {
            vertices.iter_mut().for_each(|p| p.y = -p.y);
            triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        _ => {}
    }
}
