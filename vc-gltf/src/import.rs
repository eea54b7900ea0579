//! Reading a user's own model as an asset.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Matrix4, Point3, Vector3};
use vc_graph::asset::{Joint, JointKind, Material, Part, Shape, Surface, Texture};
use vc_graph::{Asset, AssetId, AssetLibrary, Pose};

use super::buffers::Buffers;
use super::gather::{FoundJoint, FoundSurface, Gathered, Piece, gather};
use super::image::Decoder;
use super::options::{ImportOptions, ModelSize};
use super::{GltfError, collision, document, glb, paint};

/// An imported model.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ImportedModel {
    /// The asset; its parts refer to materials by their index in `materials`.
    pub asset: Asset,
    /// The materials; they refer to textures by their index in `textures`.
    pub materials: Vec<Material>,
    /// The images of the materials' colours.
    pub textures: Vec<Arc<Texture>>,
    /// The class, if the file has an annotation of it.
    pub class: Option<Arc<str>>,
    /// Whether each of its parts encloses a volume.
    pub closed: bool,
    /// The reasons why images are missing; parts that would use one of these have a plain colour.
    pub missing_images: Vec<GltfError>,
}

impl ImportedModel {
    /// Adds the asset, its materials and textures to a library.
    ///
    /// # Errors
    /// [`GltfError::Asset`] if the library refuses a value; the library is then unchanged.
    pub fn add_to(&self, library: &mut AssetLibrary) -> Result<AssetId, GltfError> {
        let mut own = AssetLibrary::default();
        self.textures.iter().try_for_each(|texture| own.add_texture(texture.clone()).map(drop))?;
        self.materials.iter().try_for_each(|material| own.add_material(material.clone()).map(drop))?;
        let id = own.add(self.asset.clone())?;
        Ok(library.merge(&own)?.asset(id))
    }
}

/// Reads a glTF file as one asset: binary (.glb), or text with its data embedded (.gltf). The asset is
/// rotated to Z up and X forward, with the centre of its base at the origin, a triangle mesh for each
/// primitive, convex collision pieces, and joints, surfaces and class as [annotated](super#annotations).
///
/// The collision pieces are the convex hulls of connected parts that nearly fill their hulls; other
/// parts are decomposed by parry's V-HACD (Mamou, 2016), which takes about a second for a part. The
/// bytes need not be trusted.
///
/// # Errors
/// [`GltfError`] with the reason and advice for the export.
pub fn read(file: &[u8], options: &ImportOptions) -> Result<ImportedModel, GltfError> {
    let (document, bytes) = glb::split(file)?;
    if let Some(extension) = document.extensions_required.iter().find(|e| !paint::understands(e)) {
        return Err(GltfError::Extension(extension.clone()));
    }
    let buffers = Buffers::new(&document, bytes);
    let found = gather(&document, &buffers, upright(options.quarter_turns))?;
    let placing = Placing::new(&found, options)?;
    let mut paints = Paints::new(&document, &buffers, options);
    let joints: Vec<Joint> = found.joints.iter().map(|j| placing.joint(j)).collect();
    let mut parts = Vec::with_capacity(found.pieces.len());
    for piece in &found.pieces {
        let material = paints.number(piece.material)?;
        parts.push(part(piece, material, piece.joint.map(|j| joints[j]), &placing));
    }
    let surfaces = found.surfaces.iter().map(|s| placing.surface(s, &found.pieces, &joints)).collect();
    let collision = collision::pieces(&parts, options.hulls);
    let closed = parts.iter().all(|p| p.shape.mesh(0.0).is_closed());
    let asset = Asset { name: name(&document, options, &parts), parts, surfaces, collision };
    let Paints { all: materials, textures, missing: missing_images, .. } = paints;
    Ok(ImportedModel { asset, materials, textures, class: found.class.map(Into::into), closed, missing_images })
}

/// The rotation from Y up, Z forward to Z up, X forward, and the quarter turns.
fn upright(quarter_turns: i32) -> Matrix4<f64> {
    let (c, s) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][quarter_turns.rem_euclid(4) as usize];
    let turn = Matrix4::new(c, -s, 0., 0., s, c, 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.);
    turn * Matrix4::new(0., 0., 1., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 0., 1.)
}

fn name(document: &document::Document, options: &ImportOptions, parts: &[Part]) -> Arc<str> {
    let scene = document.scenes.get(document.scene.unwrap_or(0)).map(|s| s.name.as_str());
    let scene = scene.filter(|n| !n.is_empty()).map(Into::into);
    options.name.clone().or(scene).or_else(|| parts.first().map(|p| p.name.clone())).unwrap_or_default()
}

/// The scale and shift from the gathered triangles to the asset.
struct Placing {
    scale: f64,
    shift: Vector3<f64>,
}

impl Placing {
    fn new(found: &Gathered, options: &ImportOptions) -> Result<Self, GltfError> {
        let (low, high) = corners(found.pieces.iter()).ok_or(GltfError::Empty)?;
        let extent = high - low;
        let share = |target: f32, own: f64| f64::from(target) / own;
        let scale = match options.size {
            ModelSize::AsIs => 1.0,
            ModelSize::Times(factor) => f64::from(factor),
            ModelSize::Height(height) => share(height, extent.z),
            ModelSize::Within(size) => (0..3).map(|i| share(size[i], extent[i])).fold(f64::INFINITY, f64::min),
        };
        let reach = low.coords.abs().sup(&high.coords.abs()).max() * scale;
        if !(scale.is_finite() && scale > 0.0) {
            return Err(GltfError::BadSize);
        }
        if reach > 1e5 {
            return Err(GltfError::TooFar);
        }
        let base = Vector3::new((low.x + high.x) / 2.0, (low.y + high.y) / 2.0, low.z);
        Ok(Self { scale, shift: if options.recentre { -base * scale } else { Vector3::zeros() } })
    }

    fn point(&self, point: &Point3<f64>) -> Point3<f32> {
        Point3::from(point.coords * self.scale + self.shift).cast()
    }

    fn joint(&self, joint: &FoundJoint) -> Joint {
        let factor = if joint.kind == JointKind::Slide { self.scale } else { 1.0 };
        Joint {
            kind: joint.kind,
            anchor: self.point(&joint.anchor),
            axis: joint.axis.cast(),
            limits: ((joint.limits.0 * factor) as f32, (joint.limits.1 * factor) as f32),
        }
    }

    fn surface(&self, surface: &FoundSurface, pieces: &[Piece], joints: &[Joint]) -> Surface {
        let own = corners(pieces[surface.pieces.clone()].iter());
        let (centre, half) = match (surface.half, own) {
            (None, Some((low, high))) => {
                let middle = nalgebra::center(&low, &high);
                let half = (high - low) / 2.0;
                (Point3::new(middle.x, middle.y, high.z), (half.x, half.y))
            }
            (half, _) => (surface.at, half.unwrap_or_default()),
        };
        Surface {
            name: surface.name.as_str().into(),
            hold: surface.hold,
            centre: self.point(&centre),
            half: ((half.0 * self.scale) as f32, (half.1 * self.scale) as f32),
            clearance: surface.clearance.map(|c| (c * self.scale) as f32),
            joint: surface.joint.map(|j| joints[j]),
        }
    }
}

fn corners<'a>(pieces: impl Iterator<Item = &'a Piece>) -> Option<(Point3<f64>, Point3<f64>)> {
    let points = pieces.flat_map(|p| &p.points).map(|p| (*p, *p));
    points.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
}

/// The materials in use, and their textures.
struct Paints<'a> {
    document: &'a document::Document,
    buffers: &'a Buffers<'a>,
    options: &'a ImportOptions,
    numbers: BTreeMap<Option<usize>, u32>,
    all: Vec<Material>,
    decoder: Decoder,
    /// By image; `None` where the image cannot be read.
    pictures: BTreeMap<usize, Option<u32>>,
    textures: Vec<Arc<Texture>>,
    missing: Vec<GltfError>,
}

impl<'a> Paints<'a> {
    fn new(document: &'a document::Document, buffers: &'a Buffers<'a>, options: &'a ImportOptions) -> Self {
        let (numbers, pictures, decoder) = (BTreeMap::new(), BTreeMap::new(), Decoder::new());
        let (all, textures, missing) = (Vec::new(), Vec::new(), Vec::new());
        Self { document, buffers, options, numbers, all, decoder, pictures, textures, missing }
    }

    /// The index of a material's image; `None` where it cannot be read, with each reason recorded once.
    fn picture(&mut self, material: &document::Material) -> Option<u32> {
        let image = self.image(material.texture()?.index?);
        let known = image.as_ref().ok().and_then(|image| self.pictures.get(image));
        if let Some(&known) = known {
            return known;
        }
        let read = image.clone().and_then(|image| self.decoder.texture(self.document, self.buffers, image));
        let number = read.map(|texture| {
            self.textures.push(texture);
            self.textures.len() as u32 - 1
        });
        let number = number.map_err(|error| self.miss(error)).ok();
        image.ok().and_then(|image| self.pictures.insert(image, number));
        number
    }

    fn image(&self, texture: usize) -> Result<usize, GltfError> {
        let found = self.document.textures.get(texture).ok_or(GltfError::missing("texture", texture))?;
        found.source.ok_or(GltfError::NoImage(texture))
    }

    fn miss(&mut self, error: GltfError) {
        if !self.missing.contains(&error) {
            self.missing.push(error);
        }
    }

    fn number(&mut self, index: Option<usize>) -> Result<u32, GltfError> {
        if let Some(&known) = self.numbers.get(&index) {
            return Ok(known);
        }
        let plain = document::Material { name: "default".into(), ..document::Material::default() };
        let written = match index {
            Some(i) => self.document.materials.get(i).ok_or(GltfError::missing("material", i))?,
            None => &plain,
        };
        let texture = self.picture(written);
        self.all.push(paint::read(written, index.unwrap_or(0), texture, self.options)?);
        self.numbers.insert(index, self.all.len() as u32 - 1);
        Ok(self.all.len() as u32 - 1)
    }
}

fn part(piece: &Piece, material: u32, joint: Option<Joint>, placing: &Placing) -> Part {
    let vertices = piece.points.iter().map(|p| placing.point(p)).collect();
    let shape = Shape::Mesh { vertices, triangles: piece.triangles.clone(), uvs: piece.uvs.clone() };
    Part { name: piece.name.as_str().into(), shape, material, pose: Pose::identity(), joint }
}
