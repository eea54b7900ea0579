//! Errors of rendering.

use vc_graph::{Label, NodeId};

use crate::scene::MOST_SURFACES;

/// The reason why nothing was rendered. It names nodes by their numbers; [`named`](Self::named) puts labels in their
/// place.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError<N = NodeId> {
    /// A side of the image is zero or longer than the longest possible,
    /// [`MAX_SIDE`](crate::camera::MAX_SIDE).
    #[error("an image of {width} x {height} pixels cannot be rendered: sides are 1 to {longest}")]
    BadSize {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// Longest possible side, pixels.
        longest: u32,
    },
    /// The camera's focal lengths, principal point, near plane or pose are not finite or out of range; the text
    /// says which, and the range.
    #[error("the camera cannot be used: its {0}")]
    BadCamera(&'static str),
    /// A node's pose, scale or joint is not finite, or the node would be farther away than 1e15 metres.
    #[error("the pose, scale or joint of {0} is not finite, or is beyond 1e15 metres: correct it where it was set")]
    BadPose(N),
    /// A node points to an asset that its library does not have.
    #[error(
        "{node} has asset {asset}, which is not in its scene's library: add it there, or let the node have a box only"
    )]
    NoSuchAsset {
        /// The node.
        node: N,
        /// Number of the missing asset.
        asset: u32,
    },
    /// A wanted modality needs an input that was not given.
    #[error("{wanted} needs {needs}, and there is none: give it, or do not ask for {wanted}")]
    Missing {
        /// The modality.
        wanted: &'static str,
        /// The input it needs, and the method that gives it.
        needs: &'static str,
    },
    /// Two things are used together that belong to different scenes.
    #[error(
        "the {what} is of another scene ({there} meshes are in it, {here} in this one, and not of the same nodes): \
         make both from one snapshot, or from snapshots of the same nodes"
    )]
    OtherScene {
        /// The thing that belongs to another scene.
        what: &'static str,
        /// Meshes in the scene that it is used with.
        here: usize,
        /// Meshes in its own scene.
        there: usize,
    },
    /// Something was made by another renderer, whose meshes and materials this one does not have.
    #[error("the {0} was made by another renderer: use it with the one that made its snapshot")]
    OtherRenderer(&'static str),
    /// A colour of the daylight is not finite or out of range, or the direction to the sun is not of unit
    /// length; the text says which, and the range.
    #[error("the daylight cannot be used: its {0}")]
    BadDaylight(&'static str),
    /// There is no such node in the snapshot, or it has no body.
    #[error("{0} has no body in this snapshot: only nodes with a pose and an asset or a box have one")]
    NoBody(N),
    /// There is no such room in the snapshot, or the graph has no box for it.
    #[error("{0} is not a room of this snapshot, or has no bounding box: ask for one of the graph's rooms")]
    NoRoom(N),
    /// The number of frames differs from the number of shots.
    #[error("{shots} shots need as many frames, but {frames} are given")]
    FrameCount {
        /// Shots given.
        shots: usize,
        /// Frames given.
        frames: usize,
    },
    /// The scene has more classes than the label format can tell apart.
    #[error("the class table has {classes} classes, and pictures can tell {most} apart: leave out some", most = 1 << 15)]
    TooManyClasses {
        /// Number of classes in the scene's table.
        classes: usize,
    },
    /// The renderer has met more different surfaces than it can number.
    #[error(
        "the materials make more than {} different surfaces: use fewer, or a new renderer for other scenes",
        MOST_SURFACES
    )]
    TooManySurfaces,
    /// Scenes with different classes were to be joined.
    #[error("the scenes to be joined have different class tables: make both with one")]
    OtherClasses,
    /// The length of an array does not match its shape.
    #[error("{numbers} numbers do not make an array of shape {shape:?}")]
    BadShape {
        /// Numbers given.
        numbers: usize,
        /// Length along each axis.
        shape: Vec<usize>,
    },
    /// A file could not be encoded.
    #[error("cannot be encoded: {0}")]
    Encoding(String),
}

impl<N> RenderError<N> {
    /// The same with other names for nodes.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let cup = scene.add(Draft::new("cup"))?;
    /// let graph = scene.build();
    /// let error = vc_render::RenderError::NoBody(cup).named(&|id| graph.label(id));
    /// assert!(error.to_string().starts_with("cup.1 has no body"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn named<M>(self, name: &impl Fn(N) -> M) -> RenderError<M> {
        use RenderError as E;
        match self {
            E::BadSize { width, height, longest } => E::BadSize { width, height, longest },
            E::BadCamera(wrong) => E::BadCamera(wrong),
            E::BadPose(id) => E::BadPose(name(id)),
            E::NoSuchAsset { node, asset } => E::NoSuchAsset { node: name(node), asset },
            E::Missing { wanted, needs } => E::Missing { wanted, needs },
            E::OtherScene { what, here, there } => E::OtherScene { what, here, there },
            E::OtherRenderer(what) => E::OtherRenderer(what),
            E::BadDaylight(wrong) => E::BadDaylight(wrong),
            E::NoBody(id) => E::NoBody(name(id)),
            E::NoRoom(id) => E::NoRoom(name(id)),
            E::FrameCount { shots, frames } => E::FrameCount { shots, frames },
            E::TooManyClasses { classes } => E::TooManyClasses { classes },
            E::TooManySurfaces => E::TooManySurfaces,
            E::OtherClasses => E::OtherClasses,
            E::BadShape { numbers, shape } => E::BadShape { numbers, shape },
            E::Encoding(why) => E::Encoding(why),
        }
    }
}

impl From<RenderError> for RenderError<Label> {
    /// Only the numbers of nodes are known yet: `node.12`.
    fn from(error: RenderError) -> Self {
        error.named(&|id| Label { class: "node".into(), id })
    }
}
