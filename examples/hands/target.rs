//! A spoon in a drawer: where its handle is, where to stand, and how to take the spoon, all from the scene's poses.

use nalgebra::{Matrix3, Point3, Rotation3, UnitQuaternion, Vector3};
use virtualcity::Environment;
use virtualcity::graph::asset::{Joint, JointKind};
use virtualcity::graph::{Asset, NodeId, Pose};

/// The lowest handle that is reached well, metres.
const LOW: f32 = 0.45;
/// Where the feet stand in the frame of the cabinet beyond the open drawer, and how far left of the handle, metres.
const AWAY: f32 = 0.28;
const ASIDE: f32 = 0.18;

/// A spoon in a drawer with a handle.
pub(crate) struct Target {
    pub(crate) spoon: NodeId,
    pub(crate) cabinet: NodeId,
    /// The middle of the handle in the cabinet's frame, drawer shut.
    handle: Point3<f32>,
    /// How far the drawer slides, metres.
    pub(crate) way: f32,
}

impl Target {
    /// The spoon in a drawer of a handy height that will be nearest to the front.
    pub(crate) fn find(home: &Environment) -> Option<Self> {
        let graph = home.graph();
        let spoons = ["spoon", "teaspoon"].into_iter().flat_map(|class| graph.of_class(class));
        let found = spoons.filter_map(|spoon| Some((spoon, graph.place(spoon)?.at)));
        let in_drawers = found.filter_map(|(spoon, cabinet)| {
            let node = graph.node(cabinet)?;
            let own = node.pose()?.inverse() * graph.node(spoon)?.aabb()?.centre();
            let asset = graph.assets().get(node.spec().asset?)?;
            let joint = slides(asset).into_iter().find(|joint| around(asset, joint, &own))?;
            let handle = handle(asset, &joint).filter(|handle| handle.z > LOW)?;
            Some((own.x, Self { spoon, cabinet, handle, way: joint.limits.1 }))
        });
        in_drawers.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, target)| target)
    }

    fn cabinet(&self, home: &Environment) -> Pose {
        home.world().pose(self.cabinet).unwrap_or_else(Pose::identity)
    }

    /// The direction into the cabinet.
    fn inwards(&self, home: &Environment) -> UnitQuaternion<f32> {
        self.cabinet(home).rotation * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f32::consts::PI)
    }

    /// The pose of a hand around the handle: fingers ahead above it, the thumb below.
    pub(crate) fn handle(&self, home: &Environment) -> Pose {
        let at = self.cabinet(home) * self.handle;
        Pose::from_parts(at.coords.into(), self.inwards(home))
    }

    /// Where to stand: beyond the open drawer, the right shoulder before the handle.
    pub(crate) fn stand(&self, home: &Environment) -> Pose {
        let beside = Point3::new(self.handle.x + self.way + AWAY, self.handle.y - ASIDE, 0.0);
        let at = self.cabinet(home) * beside;
        Pose::from_parts([at.x, at.y, 0.0].into(), self.inwards(home))
    }

    /// The pose of a hand around the spoon: fingers down, across its length.
    pub(crate) fn around_spoon(&self, home: &Environment) -> Pose {
        let pose = home.world().pose(self.spoon).unwrap_or_else(Pose::identity);
        let Ok(body) = home.world().body(self.spoon) else { return pose };
        let (low, high) = body.local_bounds();
        let (middle, size) = (pose * nalgebra::center(&low, &high), high - low);
        let lowest = home.world().aabb(self.spoon).map_or(middle.z, |aabb| aabb.min.z);
        let along = pose.rotation * Vector3::ith(size.imax(), 1.0);
        // The back of the hand is away from the body.
        let back = Vector3::z().cross(&along).normalize();
        let ahead = self.inwards(home) * Vector3::new(0.8, -0.6, 0.0);
        let back = if back.dot(&ahead) < 0.0 { -back } else { back };
        let down = -Vector3::z();
        let turn = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[down, back.cross(&down), back]));
        let at = Vector3::new(middle.x, middle.y, lowest + TIPS);
        Pose::from_parts(at.into(), UnitQuaternion::from_rotation_matrix(&turn))
    }
}

/// Height of the point between fingers and thumb above what the fingertips touch, metres.
const TIPS: f32 = 0.017;

fn slides(asset: &Asset) -> Vec<Joint> {
    let mut joints: Vec<Joint> = asset.parts.iter().filter_map(|part| part.joint).collect();
    joints.retain(|joint| joint.kind == JointKind::Slide);
    joints.dedup();
    joints
}

/// Whether a point is within the parts on a joint, roughly.
fn around(asset: &Asset, joint: &Joint, point: &Point3<f32>) -> bool {
    let parts = asset.parts.iter().filter(|part| part.joint.as_ref() == Some(joint));
    let corners = parts.flat_map(|part| {
        let (low, high) = part.shape.extent();
        [part.pose * low, part.pose * high]
    });
    let (mut least, mut most) = (Point3::from([f32::MAX; 3]), Point3::from([f32::MIN; 3]));
    corners.for_each(|corner| (least, most) = (least.inf(&corner), most.sup(&corner)));
    (0..3).all(|axis| (least[axis]..=most[axis]).contains(&point[axis]))
}

/// The middle of the outermost part of a handle.
fn handle(asset: &Asset, joint: &Joint) -> Option<Point3<f32>> {
    let parts = asset.parts.iter().filter(|part| part.joint.as_ref() == Some(joint));
    let named = parts.filter(|part| matches!(&*part.name, "handle" | "knob"));
    let middles = named.map(|part| Point3::from(part.pose.translation.vector));
    middles.max_by(|a, b| a.x.total_cmp(&b.x))
}
