//! Point clouds in the Polygon File Format.

use vc_graph::NodeId;

use super::NpyNumber;
use crate::RenderError;

/// Encodes points as a binary file in the Polygon File Format (PLY 1.0), which MeshLab, CloudCompare and Open3D read:
/// `x`, `y` and `z` in metres and the number of the node, `instance`. Sixteen bytes a point.
///
/// # Errors
/// [`RenderError::BadShape`] unless there are as many nodes as points.
///
/// ```
/// use vc_graph::NodeId;
/// let file = vc_render::format::ply(&[[1.0, 2.0, 0.5]], &[NodeId(7)])?;
/// assert!(file.starts_with(b"ply\nformat binary_little_endian 1.0\nelement vertex 1\n"));
/// assert!(file.ends_with(&[0, 0, 0, 63, 7, 0, 0, 0])); // 0.5 and 7
/// assert!(vc_render::format::ply(&[[1.0, 2.0, 0.5]], &[]).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn ply(points: &[[f32; 3]], instance: &[NodeId]) -> Result<Vec<u8>, RenderError> {
    if points.len() != instance.len() {
        return Err(RenderError::BadShape { numbers: instance.len(), shape: vec![points.len()] });
    }
    let properties = ["float x", "float y", "float z", "uint instance"].map(|p| format!("property {p}\n")).concat();
    let head =
        format!("ply\nformat binary_little_endian 1.0\nelement vertex {}\n{properties}end_header\n", points.len());
    let mut file = head.into_bytes();
    for (point, node) in points.iter().zip(instance) {
        point.iter().for_each(|v| v.bytes(&mut file));
        node.bytes(&mut file);
    }
    Ok(file)
}
