//! Boxes and masks as COCO has them.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::RenderError;
use crate::frame::Frame;
use crate::modality::Modality;
use crate::scene::Snapshot;

/// Boxes and masks of pictures of one scene as a COCO document for `pycocotools`, picture by
/// picture: of each only what the document says of it is kept.
///
/// Category numbers are class numbers; COCO's `area` counts pixels that are seen. It keeps some hundred bytes for each
/// object seen in a picture, and the text of its mask.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::format::Coco;
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
/// let mut scene = SceneBuilder::new("table");
/// scene.add(Draft::new("cup").at(Pose::translation(1.0, 0.0, 0.0)).bounds(Bounds::standing([0.1; 3].into())))?;
/// let mut renderer = Renderer::new();
/// let snapshot = renderer.snapshot(&scene.build())?;
/// let camera = Camera::with_fov(64, 48, 1.0);
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes | Modality::Masks), &mut frame)?;
/// let mut coco = Coco::default();
/// coco.add("000000.png", &frame)?;
/// assert!(coco.document(&snapshot)?.contains("000000.png"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Coco {
    images: Vec<Image>,
    annotations: Vec<Annotation>,
    classes: BTreeSet<u16>,
}

impl Coco {
    /// Adds what is seen in a frame, which goes by the name of its picture's file. Linear in the pixels of all boxes,
    /// as [`Mask::rle`](crate::Mask::rle) is.
    ///
    /// # Errors
    /// [`RenderError::Missing`] for a frame without boxes or masks; then nothing is added.
    pub fn add(&mut self, file_name: impl Into<String>, frame: &Frame) -> Result<(), RenderError> {
        if ![Modality::Boxes, Modality::Masks].iter().all(|modality| frame.holds.has(*modality)) {
            return Err(RenderError::Missing { wanted: "COCO", needs: "a frame with boxes and masks" });
        }
        let image_id = self.images.len() + 1;
        let (width, height) = (frame.width, frame.height);
        self.images.push(Image { id: image_id, file_name: file_name.into(), width, height });
        for (label, mask) in frame.boxes.iter().zip(frame.masks()) {
            self.classes.insert(label.class);
            let rle = mask.rle();
            self.annotations.push(Annotation {
                id: self.annotations.len() + 1,
                image_id,
                category_id: label.class,
                node: label.node.0,
                segmentation: Segmentation { size: rle.size, counts: rle.compressed() },
                area: label.area,
                bbox: [label.visible.x, label.visible.y, label.visible.width, label.visible.height],
                iscrowd: 0,
            });
        }
        Ok(())
    }

    /// How many pictures it has. Costs nothing.
    pub fn pictures(&self) -> usize {
        self.images.len()
    }

    /// The document, JSON; a snapshot of the scene tells the names of classes. Linear in all that has been added.
    ///
    /// # Errors
    /// [`RenderError::Encoding`].
    pub fn document(&self, snapshot: &Snapshot) -> Result<String, RenderError> {
        let name = |class: u16| snapshot.class(class).map_or_else(String::new, |c| c.to_string());
        let categories = self.classes.iter().map(|&id| Category { id, name: name(id) }).collect();
        let document = Document { images: &self.images, annotations: &self.annotations, categories };
        serde_json::to_string(&document).map_err(|e| RenderError::Encoding(e.to_string()))
    }
}

#[derive(Serialize)]
struct Document<'a> {
    images: &'a [Image],
    annotations: &'a [Annotation],
    categories: Vec<Category>,
}

#[derive(Debug, Serialize)]
struct Image {
    id: usize,
    file_name: String,
    width: usize,
    height: usize,
}

#[derive(Debug, Serialize)]
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

#[derive(Debug, Serialize)]
struct Segmentation {
    size: [u32; 2],
    counts: String,
}

#[derive(Serialize)]
struct Category {
    id: u16,
    name: String,
}
