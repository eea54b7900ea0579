//! Meshes, materials and bytes of a file in the making.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use vc_graph::asset::{Joint, Part};
use vc_graph::{Asset, AssetLibrary, Pose, TriangleMesh};

use super::document::{self as json, Document};
use super::{GltfError, glb, paint};

const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Parts of an asset that move together.
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
    /// Positions and normals, indices of four bytes, indices of two.
    bytes: [Vec<u8>; 3],
    materials: BTreeMap<u32, usize>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(library: &'a AssetLibrary, tolerance: f32) -> Self {
        let asset = json::Head { version: "2.0".into(), generator: "VirtualCity".into() };
        let document = Document { asset, ..Document::default() };
        Self { library, tolerance, document, bytes: Default::default(), materials: BTreeMap::new() }
    }

    /// Adds a node and returns its number.
    pub(super) fn node(&mut self, node: json::Node) -> usize {
        self.document.nodes.push(node);
        self.document.nodes.len() - 1
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
        let mut meshes: BTreeMap<u32, TriangleMesh> = BTreeMap::new();
        for part in parts {
            let pose = Pose::from_parts((part.pose.translation.vector - anchor).into(), part.pose.rotation);
            meshes.entry(part.material).or_default().append(&part.shape.mesh(self.tolerance).transformed(&pose));
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

    fn primitive(&mut self, material: u32, mesh: &TriangleMesh) -> Result<json::Primitive, GltfError> {
        let material = self.material(material)?;
        let positions = self.vectors(mesh.positions.iter().map(|p| &p.coords));
        if let Some(bounds) = mesh.bounds() {
            let accessor = &mut self.document.accessors[positions];
            accessor.min = Some(bounds.min.iter().copied().collect());
            accessor.max = Some(bounds.max.iter().copied().collect());
        }
        let normals = self.vectors(mesh.normals.iter());
        Ok(json::Primitive {
            attributes: json::Attributes { position: Some(positions), normal: Some(normals) },
            indices: Some(self.indices(mesh)),
            material: Some(material),
            mode: None,
        })
    }

    fn material(&mut self, index: u32) -> Result<usize, GltfError> {
        let material = self.library.material(index).ok_or(GltfError::NoSuchMaterial(index))?;
        Ok(*self.materials.entry(index).or_insert_with(|| {
            self.document.materials.push(paint::write(material));
            self.document.materials.len() - 1
        }))
    }

    fn vectors<'v>(&mut self, vectors: impl ExactSizeIterator<Item = &'v Vector3<f32>>) -> usize {
        let (offset, count) = (self.bytes[0].len(), vectors.len());
        self.bytes[0].extend(vectors.flat_map(|v| v.iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>()));
        self.accessor(0, offset, json::FLOAT, count, "VEC3")
    }

    fn indices(&mut self, mesh: &TriangleMesh) -> usize {
        let all = mesh.triangles.iter().flatten();
        let (view, kind) = if mesh.positions.len() < 0xffff { (2, json::SHORT) } else { (1, json::INT) };
        let offset = self.bytes[view].len();
        if view == 2 {
            self.bytes[2].extend(all.flat_map(|&v| (v as u16).to_le_bytes()));
        } else {
            self.bytes[1].extend(all.flat_map(|v| v.to_le_bytes()));
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

    /// The file, with these nodes at its root.
    pub(super) fn finish(mut self, name: &str, roots: Vec<usize>) -> Result<Vec<u8>, GltfError> {
        self.document.scene = Some(0);
        self.document.scenes = vec![json::Scene { name: name.into(), nodes: roots }];
        self.document.extensions_used = paint::extensions(&self.document.materials);
        if self.document.extensions.is_some() {
            self.document.extensions_used.push(super::stage::LIGHTS.to_owned());
        }
        let mut numbers = [None; 3];
        let mut all = Vec::new();
        for (i, bytes) in self.bytes.iter().enumerate().filter(|(_, bytes)| !bytes.is_empty()) {
            numbers[i] = Some(self.document.buffer_views.len());
            self.document.buffer_views.push(json::View {
                buffer: Some(0),
                byte_offset: all.len(),
                byte_length: bytes.len(),
                byte_stride: (i == 0).then_some(12),
                target: Some(if i == 0 { VERTICES } else { INDICES }),
            });
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
