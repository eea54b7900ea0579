//! What can be wrong with a glTF file.

use vc_graph::AssetId;
use vc_graph::asset::AssetError;

/// Why something could not be written as glTF or read from it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GltfError {
    /// Neither a binary nor a text glTF file.
    #[error("not a glTF 2.0 file ({0}): export the model as .glb")]
    NotGltf(&'static str),
    /// The JSON in it is not glTF's.
    #[error("the JSON of the file cannot be read: {0}")]
    Json(String),
    /// The vertices are in another file.
    #[error("buffer {0} is not in the file: export as .glb, with everything in one file")]
    ExternalBuffer(usize),
    /// It cannot be understood without an extension.
    #[error("the file requires `{0}`, which is not read: export without it")]
    Extension(String),
    /// A number leads nowhere.
    #[error("{what} {index} does not exist")]
    Missing {
        /// Accessor, node, mesh...
        what: &'static str,
        /// Its number.
        index: usize,
    },
    /// A buffer view has no data.
    #[error("buffer view {0} reaches beyond its buffer")]
    BadView(usize),
    /// An accessor's data cannot be used.
    #[error("accessor {index} {reason}")]
    BadAccessor {
        /// Its number.
        index: usize,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A texture has no picture of a kind that is read.
    #[error("texture {0} has no picture that is read: export it as PNG or JPEG")]
    NoPicture(usize),
    /// A picture cannot be used.
    #[error("image `{name}` {reason}")]
    BadImage {
        /// Its name in the file.
        name: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A node is its own ancestor, or has two parents.
    #[error("node {0} has more than one parent: every node may be listed once")]
    NotATree(usize),
    /// A node's rotation is no quaternion that turns anything.
    #[error("the rotation of node {0} has no length: glTF asks for a quaternion of length 1")]
    NoRotation(usize),
    /// An annotation is not as documented.
    #[error("the annotation `vc` of {place} {reason}")]
    BadNote {
        /// Which node or material.
        place: String,
        /// What is wrong.
        reason: String,
    },
    /// There are no triangles.
    #[error("there are no triangles in the default scene")]
    Empty,
    /// A position is not a number, or farther than 100 km away.
    #[error("a vertex is not finite or more than 100 km from the origin: check the export's unit")]
    TooFar,
    /// The model has more than ten million triangles.
    #[error("the model has more than {most} triangles: simplify it")]
    TooMany {
        /// The most that are read.
        most: usize,
    },
    /// A target size cannot be met.
    #[error("size must be finite and above zero, and the model as large along that axis")]
    BadSize,
    /// An asset to be written is not in the scene's library.
    #[error("asset {} is not in the library", .0.0)]
    NoSuchAsset(AssetId),
    /// An asset to be written uses a material that is not in the library.
    #[error("material {0} is not in the library")]
    NoSuchMaterial(u32),
    /// More than four gigabytes, which a .glb cannot hold.
    #[error("the file would be larger than 4 GiB: write fewer objects or use a larger tolerance")]
    TooLarge,
    /// The library refuses what was read.
    #[error(transparent)]
    Asset(#[from] AssetError),
}

impl GltfError {
    pub(super) fn missing(what: &'static str, index: usize) -> Self {
        Self::Missing { what, index }
    }
}
