//! A single picture with all modalities of a camera.

use nalgebra::Vector3;
use virtualcity::render::camera::MAX_SIDE;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Frame, Lighting, Modalities, Modality, RenderError, Renderer, Shot, Snapshot};

/// Supersampling factor of the colours per axis: without it, gaps of a few millimetres between doors would
/// appear and vanish along a line.
const FINER: u32 = 4;

/// Colours, nodes, classes; depth, parts, masks; flow, normals, boxes.
pub(crate) fn all(
    renderer: &Renderer,
    snapshot: &Snapshot,
    camera: &Camera,
    lighting: &Lighting,
    frame: &mut Frame,
) -> Result<Picture, RenderError> {
    // The next frame: a step forward and to the side.
    let step = Vector3::new(0.03, 0.0, 0.06);
    let next = Camera { pose: camera.pose * nalgebra::Translation3::from(step), ..*camera };
    let wanted = Modalities::SIX | Modality::Normal | Modality::Part;
    let finer = (MAX_SIDE / camera.width.max(camera.height).max(1)).clamp(1, FINER);
    renderer
        .render(&Shot::new(snapshot, camera, wanted).lit(lighting).after(snapshot, &next).supersampled(finer), frame)?;
    let rgb = picture::rgb(frame);
    let pictures = [
        rgb.clone(),
        picture::instances(frame),
        picture::classes(frame),
        picture::depth(frame, 8.0),
        picture::parts(frame),
        picture::masks(frame),
        picture::flow(frame, 25.0),
        picture::normals(frame),
        picture::with_boxes(rgb, frame, 150),
    ];
    Ok(Picture::sheet(&pictures, 3, 4))
}
