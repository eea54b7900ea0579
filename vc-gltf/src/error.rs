//! The errors of reading and writing glTF.

use vc_graph::AssetId;
use vc_graph::asset::AssetError;

/// The reason why something could not be written as glTF or read from it.
///
/// ```
/// use vc_gltf::{GltfError, ImportOptions};
/// let error = vc_gltf::read(b"no model", &ImportOptions::default()).unwrap_err();
/// assert!(matches!(error, GltfError::NotGltf(_)));
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GltfError {
    /// The file is neither a binary nor a text glTF file.
    #[error("not a glTF 2.0 file ({0}): export the model as .glb")]
    NotGltf(&'static str),
    /// Its JSON is not that of glTF.
    #[error("the JSON of the file cannot be read: {0}")]
    Json(String),
    /// The vertices are in another file.
    #[error("buffer {0} is not in the file: export as .glb, with everything in one file")]
    ExternalBuffer(usize),
    /// The file cannot be read without an unsupported extension.
    #[error("the file requires `{0}`, which is not supported: export without it")]
    Extension(String),
    /// An index refers to nothing.
    #[error("{what} {index} does not exist")]
    Missing {
        /// The type of the missing object: accessor, node, mesh...
        what: &'static str,
        /// The index.
        index: usize,
    },
    /// A buffer view is of no buffer.
    #[error("buffer view {0} names no buffer: export the model again")]
    NoBuffer(usize),
    /// A buffer view lies outside its buffer.
    #[error("buffer view {0} reaches beyond its buffer")]
    BadView(usize),
    /// The data of an accessor cannot be used.
    #[error("accessor {index} {reason}")]
    BadAccessor {
        /// The accessor's index.
        index: usize,
        /// The reason.
        reason: &'static str,
    },
    /// A texture has no image in a supported format.
    #[error("texture {0} has no image that is read: export it as PNG or JPEG")]
    NoImage(usize),
    /// An image cannot be used.
    #[error("image `{name}` {reason}")]
    BadImage {
        /// Its name in the file.
        name: String,
        /// The reason.
        reason: String,
    },
    /// A node is its own ancestor, or has two parents.
    #[error("node {0} has more than one parent: every node may be listed once")]
    NotATree(usize),
    /// A node's rotation is not a valid quaternion.
    #[error("the rotation of node {0} has no length: glTF asks for a quaternion of length 1")]
    NoRotation(usize),
    /// An annotation does not have the documented form.
    #[error("the annotation `vc` of {place} {reason}")]
    BadNote {
        /// The node or material.
        place: String,
        /// The reason.
        reason: String,
    },
    /// The scene has no triangles.
    #[error("there are no triangles in the default scene")]
    Empty,
    /// A position is not a number, or farther than 100 km away.
    #[error("a vertex is not finite or more than 100 km from the origin: check the export's unit")]
    TooFar,
    /// The model has more than ten million triangles.
    #[error("the model has more than {most} triangles: simplify it")]
    TooMany {
        /// The greatest number that is read.
        most: usize,
    },
    /// A target size cannot be reached.
    #[error("size must be finite and above zero, and the model as large along that axis")]
    BadSize,
    /// An asset to be written is not in the scene's library.
    #[error("asset {} is not in the library", .0.0)]
    NoSuchAsset(AssetId),
    /// An asset to be written uses a material that is not in the library.
    #[error("material {0} is not in the library")]
    NoSuchMaterial(u32),
    /// The file would exceed four gigabytes, the limit of .glb.
    #[error("the file would be larger than 4 GiB: write fewer objects or use a larger tolerance")]
    TooLarge,
    /// The library refuses the imported asset.
    #[error(transparent)]
    Asset(#[from] AssetError),
}

impl GltfError {
    pub(super) fn missing(what: &'static str, index: usize) -> Self {
        Self::Missing { what, index }
    }
}
