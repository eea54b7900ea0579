//! The scan of a lidar.

use nalgebra::Point3;
use vc_graph::{NodeId, Pose};
use vc_render::{NOTHING, RenderError, format};

/// A lidar's distances: line by line from the lowest, each ray by ray.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LidarScan {
    /// Number of lines.
    pub lines: usize,
    /// Rays of each line.
    pub columns: usize,
    /// Where the lidar was.
    pub pose: Pose,
    /// Distance along each ray, metres; infinite where nothing came back.
    pub distance: Vec<f32>,
    /// The graph's node; [`NOTHING`] where nothing came back.
    pub instance: Vec<NodeId>,
    /// Measured points in the lidar's own frame, metres; infinite where nothing came back.
    pub points: Vec<[f32; 3]>,
}

impl LidarScan {
    /// The measured points in the home with their nodes.
    pub fn in_home(&self) -> impl Iterator<Item = (Point3<f32>, NodeId)> + '_ {
        let all = self.points.iter().zip(&self.instance);
        all.filter(|(_, node)| **node != NOTHING).map(|(point, node)| (self.pose * Point3::from(*point), *node))
    }

    /// The measured points in the home as a file: [`format::ply`].
    ///
    /// # Errors
    /// As [`format::ply`], of which none occurs here.
    pub fn ply(&self) -> Result<Vec<u8>, RenderError> {
        let points: Vec<[f32; 3]> = self.in_home().map(|(point, _)| point.into()).collect();
        let nodes: Vec<NodeId> = self.in_home().map(|(_, node)| node).collect();
        format::ply(&points, &nodes)
    }
}
