//! Bounding boxes and masks in the COCO format.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::RenderError;
use crate::frame::Frame;
use crate::modality::Modality;
use crate::scene::Snapshot;

/// A COCO document for `pycocotools` with the boxes and masks of pictures, of one scene or of many. It is built
/// picture by picture and keeps only the document's data, not the pictures.
///
/// Category numbers are class numbers. A class that the class table lacks gets a new number if its own is taken
/// by another class. `supercategory` is the class's category. COCO's `area` counts visible pixels. The document
/// keeps some hundred bytes for each object visible in a picture, and the text of its mask.
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
/// coco.add("000000.png", &frame, &snapshot)?;
/// assert!(coco.document()?.contains("000000.png"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Coco {
    images: Vec<Image>,
    annotations: Vec<Annotation>,
    /// Number and category of every class seen so far, by name.
    classes: BTreeMap<Arc<str>, (u32, Arc<str>)>,
}

impl Coco {
    /// Adds the objects visible in a frame under the file name of its picture. The snapshot of its scene
    /// provides the names of classes. Linear in the pixels of all boxes, like [`Mask::rle`](crate::Mask::rle).
    ///
    /// # Errors
    /// [`RenderError::Missing`] for a frame without boxes or masks; nothing is added then.
    pub fn add(&mut self, file_name: impl Into<String>, frame: &Frame, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.push(CocoPicture::new(file_name, frame, snapshot)?);
        Ok(())
    }

    /// Adds the record of a picture.
    pub fn push(&mut self, picture: CocoPicture) {
        let image_id = self.images.len() + 1;
        let CocoPicture { file_name, width, height, scene, viewpoint, files, objects } = picture;
        self.images.push(Image { id: image_id, file_name, width, height, scene, viewpoint, files });
        for seen in objects {
            let category_id = self.category(seen.class, seen.name, seen.category);
            let SeenObject { node, segmentation, area, bbox, .. } = seen;
            let (id, iscrowd) = (self.annotations.len() + 1, 0);
            let one = Annotation { id, image_id, category_id, node, segmentation, area, bbox, iscrowd };
            self.annotations.push(one);
        }
    }

    /// The category number of a class: the class's own, unless another class has it.
    fn category(&mut self, class: u16, name: Arc<str>, category: Arc<str>) -> u32 {
        if let Some((id, _)) = self.classes.get(&name) {
            return *id;
        }
        let (own, taken) = (u32::from(class), self.classes.values().map(|(id, _)| *id));
        let most = taken.clone().max().unwrap_or_default();
        let id = if taken.into_iter().any(|id| id == own) { most + 1 } else { own };
        self.classes.insert(name, (id, category));
        id
    }

    /// Number of pictures added.
    pub fn pictures(&self) -> usize {
        self.images.len()
    }

    /// The document as JSON. Linear in its contents.
    ///
    /// # Errors
    /// [`RenderError::Encoding`].
    pub fn document(&self) -> Result<String, RenderError> {
        let numbered = self.classes.iter();
        let mut categories: Vec<Category<'_>> =
            numbered.map(|(name, (id, category))| Category { id: *id, name, supercategory: category }).collect();
        categories.sort_by_key(|category| category.id);
        let document =
            Document { info: INFO, licenses: [], images: &self.images, annotations: &self.annotations, categories };
        serde_json::to_string(&document).map_err(|e| RenderError::Encoding(e.to_string()))
    }
}

/// The record of one picture in a document. It can be stored as JSON and added later, also by another process.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CocoPicture {
    file_name: String,
    width: usize,
    height: usize,
    #[serde(default)]
    scene: Option<String>,
    #[serde(default)]
    viewpoint: Option<String>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    files: BTreeMap<String, String>,
    objects: Vec<SeenObject>,
}

impl CocoPicture {
    /// Records the objects visible in a frame, under the file name of its picture. The snapshot of its scene
    /// provides the names of classes. Costs as much as [`Coco::add`].
    ///
    /// # Errors
    /// [`RenderError::Missing`] for a frame without boxes or masks.
    pub fn new(file_name: impl Into<String>, frame: &Frame, snapshot: &Snapshot) -> Result<Self, RenderError> {
        if ![Modality::Boxes, Modality::Masks].iter().all(|modality| frame.modalities.has(*modality)) {
            return Err(RenderError::Missing { wanted: "COCO", needs: "a frame with boxes and masks" });
        }
        let objects = frame.boxes.iter().zip(frame.masks()).map(|(label, mask)| {
            let rle = mask.rle();
            SeenObject {
                class: label.class,
                name: snapshot.class(label.class).cloned().unwrap_or_default(),
                category: snapshot.category(label.class).cloned().unwrap_or_default(),
                node: label.node.0,
                segmentation: Segmentation { size: rle.size, counts: rle.compressed() },
                area: label.area,
                bbox: [label.visible.x, label.visible.y, label.visible.width, label.visible.height],
            }
        });
        let (width, height, objects) = (frame.width, frame.height, objects.collect());
        let (file_name, files) = (file_name.into(), BTreeMap::new());
        Ok(Self { file_name, width, height, scene: None, viewpoint: None, files, objects })
    }

    /// Adds the name of the scene and a description of the viewpoint: `scene` and `viewpoint` of the document's
    /// `images`, which tools for COCO pass over.
    #[must_use]
    pub fn taken(self, scene: impl Into<String>, viewpoint: impl Into<String>) -> Self {
        Self { scene: Some(scene.into()), viewpoint: Some(viewpoint.into()), ..self }
    }

    /// Adds a file of the same view, such as its depth: `files` of the document's `images`, by kind.
    #[must_use]
    pub fn with_file(mut self, kind: impl Into<String>, file_name: impl Into<String>) -> Self {
        self.files.insert(kind.into(), file_name.into());
        self
    }

    /// The names of all files: the picture's, and those of the same view.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.file_name()).chain(self.files.values().map(String::as_str))
    }

    /// The name of the picture's file.
    pub fn file_name(&self) -> &str {
        &self.file_name
    }
}

/// An object visible in a picture.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct SeenObject {
    class: u16,
    /// The class's name.
    name: Arc<str>,
    category: Arc<str>,
    node: u32,
    segmentation: Segmentation,
    area: u32,
    bbox: [i32; 4],
}

/// The document's `info`; it has no date, so that the same pictures give the same bytes.
const INFO: Info =
    Info { description: "homes of VirtualCity", version: env!("CARGO_PKG_VERSION"), contributor: "VirtualCity" };

#[derive(Serialize)]
struct Info {
    description: &'static str,
    version: &'static str,
    contributor: &'static str,
}

#[derive(Serialize)]
struct Document<'a> {
    info: Info,
    licenses: [(); 0],
    images: &'a [Image],
    annotations: &'a [Annotation],
    categories: Vec<Category<'a>>,
}

#[derive(Debug, Serialize)]
struct Image {
    id: usize,
    file_name: String,
    width: usize,
    height: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    viewpoint: Option<String>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    files: BTreeMap<String, String>,
}

#[derive(Debug, Serialize)]
struct Annotation {
    id: usize,
    image_id: usize,
    category_id: u32,
    /// The graph's node.
    node: u32,
    segmentation: Segmentation,
    area: u32,
    bbox: [i32; 4],
    iscrowd: u8,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct Segmentation {
    size: [u32; 2],
    counts: String,
}

#[derive(Serialize)]
struct Category<'a> {
    id: u32,
    name: &'a str,
    supercategory: &'a str,
}
