//! Boxes and masks as COCO has them.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::RenderError;
use crate::frame::Frame;
use crate::modality::Modality;
use crate::scene::Snapshot;

/// Boxes and masks of pictures, of one scene or of many, as a COCO document for `pycocotools`, picture by
/// picture: it keeps the text of the document and not the pictures.
///
/// Category numbers are class numbers. If the number of a class that the class table lacks is taken by another
/// class, it gets a number of its own. `supercategory` is the class's category. COCO's `area` counts pixels that
/// are seen. It keeps some hundred bytes for each object seen in a picture, and the text of its mask.
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
    /// Number and category of every class that was seen, by name.
    classes: BTreeMap<Arc<str>, (u32, Arc<str>)>,
}

impl Coco {
    /// Adds the objects seen in a frame under the name of its picture's file; a snapshot of its scene has the names
    /// of the classes. Linear in the pixels of all boxes, as [`Mask::rle`](crate::Mask::rle) is.
    ///
    /// # Errors
    /// [`RenderError::Missing`] for a frame without boxes or masks; then nothing is added.
    pub fn add(&mut self, file_name: impl Into<String>, frame: &Frame, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.push(CocoPicture::of(file_name, frame, snapshot)?);
        Ok(())
    }

    /// Adds a picture by what was seen in it.
    pub fn push(&mut self, picture: CocoPicture) {
        let image_id = self.images.len() + 1;
        let CocoPicture { file_name, width, height, objects } = picture;
        self.images.push(Image { id: image_id, file_name, width, height });
        for seen in objects {
            let category_id = self.category(seen.class, seen.name, seen.category);
            let SeenObject { node, segmentation, area, bbox, .. } = seen;
            let (id, iscrowd) = (self.annotations.len() + 1, 0);
            let one = Annotation { id, image_id, category_id, node, segmentation, area, bbox, iscrowd };
            self.annotations.push(one);
        }
    }

    /// The number of a class's category, which is the class's own unless another class has it.
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

    /// How many pictures it has. Costs nothing.
    pub fn pictures(&self) -> usize {
        self.images.len()
    }

    /// The document, JSON. Linear in all that has been added.
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

/// All that a document says of one picture. It can be kept as JSON and added later, also by another process.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CocoPicture {
    file_name: String,
    width: usize,
    height: usize,
    objects: Vec<SeenObject>,
}

impl CocoPicture {
    /// The objects seen in a frame, under the name of its picture's file; a snapshot of its scene has the names of
    /// the classes. Costs as [`Coco::add`].
    ///
    /// # Errors
    /// [`RenderError::Missing`] for a frame without boxes or masks.
    pub fn of(file_name: impl Into<String>, frame: &Frame, snapshot: &Snapshot) -> Result<Self, RenderError> {
        if ![Modality::Boxes, Modality::Masks].iter().all(|modality| frame.holds.has(*modality)) {
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
        Ok(Self { file_name: file_name.into(), width: frame.width, height: frame.height, objects: objects.collect() })
    }

    /// The name of the picture's file.
    pub fn file_name(&self) -> &str {
        &self.file_name
    }
}

/// An object seen in a picture.
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

/// The document's `info`, without a date: the same pictures give the same bytes.
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
