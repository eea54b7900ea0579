//! The meshes, materials and bytes of a file under construction.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use vc_graph::asset::{Joint, Material, Part};
use vc_graph::{Asset, AssetLibrary, Pose, TriangleMesh};

use super::document::{self as json, Document};
use super::{GltfError, glb, image, paint};

const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The kinds of numbers, as indices into a writer's bytes, and the byte strides of vertices.
const VECTORS: usize = 0;
const PAIRS: usize = 1;
const WORDS: usize = 2;
const SHORTS: usize = 3;
const STRIDES: [Option<usize>; 4] = [Some(12), Some(8), None, None];

/// The parts of an asset that move together.
pub(super) struct Link {
    pub(super) joint: Option<Joint>,
    pub(super) name: String,
    /// Its mesh, relative to the joint's anchor.
    pub(super) mesh: Option<usize>,
}

pub(super) struct Writer<'a> {
    library: &'a AssetLibrary,
    tolerance: f32,
    pub(super) document: Document,
    /// Positions and normals, texture coordinates, four-byte indices, two-byte indices.
    bytes: [Vec<u8>; 4],
    /// Whether the asset being written is on, so that emissive materials emit light.
    pub(super) lit: bool,
    /// By index in the library, whether textured, and whether it emits light.
    materials: BTreeMap<(u32, bool, bool), usize>,
    /// By index in the library.
    textures: BTreeMap<u32, usize>,
    /// The encoded images.
    images: Vec<Vec<u8>>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(library: &'a AssetLibrary, tolerance: f32) -> Self {
        let asset = json::Head { version: "2.0".into(), generator: "VirtualCity".into() };
        let document = Document { asset, ..Document::default() };
        let (bytes, images) = Default::default();
        let (materials, textures) = (BTreeMap::new(), BTreeMap::new());
        Self { library, tolerance, document, bytes, lit: true, materials, textures, images }
    }

    /// Adds a node and returns its index.
    pub(super) fn node(&mut self, node: json::Node) -> usize {
        self.document.nodes.push(node);
        self.document.nodes.len() - 1
    }

    /// Whether an asset has an emissive part.
    pub(super) fn glows(&self, asset: &Asset) -> bool {
        let emission = |part: &Part| self.library.material(part.material).map(|material| material.emission);
        asset.parts.iter().filter_map(emission).any(|emission| emission != [0.0; 3])
    }

    /// Writes the meshes of an asset's links, the fixed one first.
    pub(super) fn links(&mut self, asset: &Asset) -> Result<Vec<Link>, GltfError> {
        let mut groups: Vec<(Option<Joint>, Vec<&Part>)> = vec![(None, Vec::new())];
        for part in &asset.parts {
            match groups.iter_mut().find(|(joint, _)| *joint == part.joint) {
                Some((_, parts)) => parts.push(part),
                None => groups.push((part.joint, vec![part])),
            }
        }
        groups.into_iter().map(|(joint, parts)| self.link(asset, joint, &parts)).collect()
    }

    fn link(&mut self, asset: &Asset, joint: Option<Joint>, parts: &[&Part]) -> Result<Link, GltfError> {
        let anchor = joint.map_or(Vector3::zeros(), |j| j.anchor.coords);
        let mut meshes: BTreeMap<(u32, bool), TriangleMesh> = BTreeMap::new();
        for part in parts {
            let pose = Pose::from_parts((part.pose.translation.vector - anchor).into(), part.pose.rotation);
            let mesh = part.shape.mesh(self.tolerance).transformed(&pose);
            meshes.entry((part.material, !mesh.uvs.is_empty())).or_default().append(&mesh);
        }
        let filled = meshes.into_iter().filter(|(_, mesh)| !mesh.is_empty());
        let primitives =
            filled.map(|(material, mesh)| self.primitive(material, &mesh)).collect::<Result<Vec<_>, _>>()?;
        let name = match (joint, parts.first()) {
            (Some(_), Some(part)) => part.name.to_string(),
            _ => asset.name.to_string(),
        };
        let mesh = (!primitives.is_empty()).then(|| {
            self.document.meshes.push(json::Mesh { name: name.clone(), primitives });
            self.document.meshes.len() - 1
        });
        Ok(Link { joint, name, mesh })
    }

    fn primitive(
        &mut self,
        (material, textured): (u32, bool),
        mesh: &TriangleMesh,
    ) -> Result<json::Primitive, GltfError> {
        let material = self.material(material, textured)?;
        let apart;
        let (mesh, first) = match textured {
            true => {
                let places;
                (apart, places) = taken_apart(mesh);
                (&apart, Some(self.pairs(&places)))
            }
            false => (mesh, None),
        };
        let positions = self.vectors(mesh.positions.iter().map(|p| &p.coords));
        if let Some(bounds) = mesh.bounds() {
            let accessor = &mut self.document.accessors[positions];
            accessor.min = Some(bounds.min.iter().copied().collect());
            accessor.max = Some(bounds.max.iter().copied().collect());
        }
        let normals = self.vectors(mesh.normals.iter());
        Ok(json::Primitive {
            attributes: json::Attributes { position: Some(positions), normal: Some(normals), first, second: None },
            indices: Some(self.indices(mesh)),
            material: Some(material),
            mode: None,
        })
    }

    fn material(&mut self, index: u32, textured: bool) -> Result<usize, GltfError> {
        let material = self.library.material(index).ok_or(GltfError::NoSuchMaterial(index))?;
        let dark = Material { emission: [0.0; 3], ..material.clone() };
        let lit = self.lit || material.emission == [0.0; 3];
        if let Some(&known) = self.materials.get(&(index, textured, lit)) {
            return Ok(known);
        }
        let texture = material.texture.filter(|_| textured).map(|t| self.texture(t)).transpose()?;
        self.document.materials.push(paint::write(if lit { material } else { &dark }, texture.flatten()));
        self.materials.insert((index, textured, lit), self.document.materials.len() - 1);
        Ok(self.document.materials.len() - 1)
    }

    /// The index of a texture in the file; `None` if the library does not have it.
    fn texture(&mut self, index: u32) -> Result<Option<usize>, GltfError> {
        let Some(texture) = self.library.texture(index) else { return Ok(None) };
        if let Some(&known) = self.textures.get(&index) {
            return Ok(Some(known));
        }
        let number = self.images.len();
        self.images.push(image::png(texture)?);
        let (name, mime_type) = (texture.name.to_string(), Some("image/png".into()));
        self.document.images.push(json::Image { name, mime_type, ..json::Image::default() });
        self.document.textures.push(json::Texture { source: Some(number) });
        self.textures.insert(index, number);
        Ok(Some(number))
    }

    fn vectors<'v>(&mut self, vectors: impl ExactSizeIterator<Item = &'v Vector3<f32>>) -> usize {
        let (offset, count) = (self.bytes[VECTORS].len(), vectors.len());
        self.bytes[VECTORS].extend(vectors.flat_map(|v| v.iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>()));
        self.accessor(VECTORS, offset, json::FLOAT, count, "VEC3")
    }

    fn pairs(&mut self, pairs: &[[f32; 2]]) -> usize {
        let offset = self.bytes[PAIRS].len();
        self.bytes[PAIRS].extend(pairs.as_flattened().iter().flat_map(|v| v.to_le_bytes()));
        self.accessor(PAIRS, offset, json::FLOAT, pairs.len(), "VEC2")
    }

    fn indices(&mut self, mesh: &TriangleMesh) -> usize {
        let all = mesh.triangles.iter().flatten();
        let (view, kind) = if mesh.positions.len() < 0xffff { (SHORTS, json::SHORT) } else { (WORDS, json::INT) };
        let offset = self.bytes[view].len();
        if view == SHORTS {
            self.bytes[SHORTS].extend(all.flat_map(|&v| (v as u16).to_le_bytes()));
        } else {
            self.bytes[WORDS].extend(all.flat_map(|v| v.to_le_bytes()));
        }
        self.accessor(view, offset, kind, mesh.triangles.len() * 3, "SCALAR")
    }

    fn accessor(&mut self, view: usize, offset: usize, component: u32, count: usize, kind: &str) -> usize {
        self.document.accessors.push(json::Accessor {
            buffer_view: Some(view),
            byte_offset: offset,
            component_type: component,
            count,
            kind: kind.into(),
            ..json::Accessor::default()
        });
        self.document.accessors.len() - 1
    }

    /// The finished file, with these root nodes.
    pub(super) fn finish(mut self, name: &str, roots: Vec<usize>) -> Result<Vec<u8>, GltfError> {
        self.document.scene = Some(0);
        self.document.scenes = vec![json::Scene { name: name.into(), nodes: roots }];
        self.document.extensions_used = paint::extensions(&self.document.materials);
        if self.document.extensions.is_some() {
            self.document.extensions_used.push(json::LIGHTS.to_owned());
        }
        let mut numbers = [None; 4];
        let mut all = Vec::new();
        for (i, bytes) in self.bytes.iter().enumerate().filter(|(_, bytes)| !bytes.is_empty()) {
            numbers[i] = Some(self.document.buffer_views.len());
            self.document.buffer_views.push(json::View {
                buffer: Some(0),
                byte_offset: all.len(),
                byte_length: bytes.len(),
                byte_stride: STRIDES[i],
                target: Some(if STRIDES[i].is_some() { VERTICES } else { INDICES }),
            });
            all.extend(bytes);
        }
        for (bytes, image) in self.images.iter().zip(&mut self.document.images) {
            image.buffer_view = Some(self.document.buffer_views.len());
            let (byte_offset, byte_length) = (all.len(), bytes.len());
            let view = json::View { buffer: Some(0), byte_offset, byte_length, ..json::View::default() };
            self.document.buffer_views.push(view);
            all.extend(bytes);
        }
        for accessor in &mut self.document.accessors {
            accessor.buffer_view = accessor.buffer_view.and_then(|view| numbers[view]);
        }
        if !all.is_empty() {
            self.document.buffers = vec![json::Buffer { byte_length: all.len(), uri: None }];
        }
        glb::join(&self.document, all)
    }
}

/// Splits vertices so that each has one texture coordinate; returns the mesh, and the coordinates
/// by vertex.
fn taken_apart(mesh: &TriangleMesh) -> (TriangleMesh, Vec<[f32; 2]>) {
    let (mut apart, mut places) = (TriangleMesh::default(), Vec::new());
    let mut known: BTreeMap<(u32, [u32; 2]), u32> = BTreeMap::new();
    for (triangle, uvs) in mesh.triangles.iter().zip(&mesh.uvs) {
        let corner = |i: usize| {
            let (vertex, uv) = (triangle[i], uvs[i]);
            *known.entry((vertex, uv.map(f32::to_bits))).or_insert_with(|| {
                apart.positions.extend(mesh.positions.get(vertex as usize));
                apart.normals.extend(mesh.normals.get(vertex as usize));
                places.push(uv);
                places.len() as u32 - 1
            })
        };
        let corners = [0, 1, 2].map(corner);
        apart.triangles.push(corners);
    }
    (apart, places)
}
