//! Boxes and masks as COCO has them.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::RenderError;
use crate::frame::Frame;
use crate::scene::Snapshot;

#[derive(Serialize)]
struct Document<'a> {
    images: Vec<Image<'a>>,
    annotations: Vec<Annotation>,
    categories: Vec<Category>,
}

#[derive(Serialize)]
struct Image<'a> {
    id: usize,
    file_name: &'a str,
    width: usize,
    height: usize,
}

#[derive(Serialize)]
struct Annotation {
    id: usize,
    image_id: usize,
    category_id: u16,
    /// The graph's node.
    node: u32,
    segmentation: Segmentation,
    area: u32,
    bbox: [i32; 4],
    iscrowd: u8,
}

#[derive(Serialize)]
struct Segmentation {
    size: [u32; 2],
    counts: String,
}

#[derive(Serialize)]
struct Category {
    id: u16,
    name: String,
}

/// Boxes and masks of frames of one snapshot's scene, each with the name of its picture's
/// file, as a COCO document for `pycocotools`. Frames must hold boxes and masks.
///
/// Category numbers are class numbers; COCO's `area` counts pixels that are seen.
///
/// # Errors
/// [`RenderError::Missing`] for a frame without boxes or masks.
pub fn coco(frames: &[(&str, &Frame)], snapshot: &Snapshot) -> Result<String, RenderError> {
    let mut document = Document { images: Vec::new(), annotations: Vec::new(), categories: Vec::new() };
    let mut classes = BTreeSet::new();
    for (image, (name, frame)) in frames.iter().enumerate() {
        if frame.boxes.len() != frame.masks().len() {
            return Err(RenderError::Missing { wanted: "COCO", needs: "frame with boxes and masks" });
        }
        document.images.push(Image { id: image + 1, file_name: name, width: frame.width, height: frame.height });
        for (label, mask) in frame.boxes.iter().zip(frame.masks()) {
            classes.insert(label.class);
            let rle = mask.rle();
            document.annotations.push(Annotation {
                id: document.annotations.len() + 1,
                image_id: image + 1,
                category_id: label.class,
                node: label.node.0,
                segmentation: Segmentation { size: rle.size, counts: rle.compressed() },
                area: label.area,
                bbox: [label.visible.x, label.visible.y, label.visible.width, label.visible.height],
                iscrowd: 0,
            });
        }
    }
    let name = |class: u16| snapshot.class(class).map_or_else(String::new, |c| c.to_string());
    document.categories = classes.into_iter().map(|id| Category { id, name: name(id) }).collect();
    serde_json::to_string(&document).map_err(|e| RenderError::Encoding(e.to_string()))
}
