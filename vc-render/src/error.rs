//! What can be wrong with what is to be rendered.

use vc_graph::NodeId;

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// A side of the image is zero or longer than [`MAX_SIDE`](crate::camera::MAX_SIDE).
    #[error("an image of {width} x {height} pixels cannot be rendered: sides are 1 to {most}", most = crate::camera::MAX_SIDE)]
    BadSize {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// Focal lengths, principal point, near plane or pose of the camera are not finite, or a length is not positive.
    #[error("the camera's {0} is not finite or not positive")]
    BadCamera(&'static str),
    /// A node's pose or scale is not finite.
    #[error("the pose or scale of {0} is not finite")]
    BadPose(NodeId),
    /// A node points to an asset that its library does not have.
    #[error("{node} has asset {asset}, which is not in the library")]
    NoSuchAsset {
        /// Which node.
        node: NodeId,
        /// Which asset.
        asset: u32,
    },
    /// Something is asked for that needs what the shot does not have.
    #[error("{wanted} needs {needs}, and the shot has none")]
    Missing {
        /// What is asked for.
        wanted: &'static str,
        /// What it needs.
        needs: &'static str,
    },
    /// Two things are used together that are not of the same scene.
    #[error(
        "the {what} is of another scene ({there} meshes are in it, {here} in this one): \
         make both from one snapshot, or from snapshots of the same nodes"
    )]
    OtherScene {
        /// What is of another scene.
        what: &'static str,
        /// Meshes in the scene it is used with.
        here: usize,
        /// Meshes in its own.
        there: usize,
    },
    /// Something was made by another renderer, whose meshes and materials this one does not have.
    #[error("the {0} was made by another renderer: use it with the one that made its snapshot")]
    OtherRenderer(&'static str),
    /// A colour of the daylight is not finite or less than zero, or the direction to the sun has not unit length.
    #[error("the daylight's {0} is not finite, is negative, or has not unit length")]
    BadDaylight(&'static str),
    /// There is no node of this number in the snapshot, or it has no body.
    #[error("{0} has no body in this snapshot")]
    NoBody(NodeId),
    /// There is no room of this number in the snapshot, or the graph knows no box around it.
    #[error("{0} is no room of this snapshot, or has no box around it")]
    NoRoom(NodeId),
    /// As many frames as shots are needed.
    #[error("{shots} shots need as many frames, {frames} are given")]
    FrameCount {
        /// Shots given.
        shots: usize,
        /// Frames given.
        frames: usize,
    },
    /// A file could not be encoded.
    #[error("cannot be encoded: {0}")]
    Encoding(String),
}
