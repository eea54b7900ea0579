//! Converts the tree of nodes to triangles, joints and surfaces in our axes.

use std::collections::HashMap;
use std::ops::Range;

use nalgebra::{Matrix4, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, JointKind};
use vc_graph::portable::Portable;

use super::GltfError;
use super::access::{Accessors, Elements};
use super::buffers::Buffers;
use super::coordinates::TextureMap;
use super::document::{Document, Node, Primitive};
use super::note::{JointNote, NodeNote, SurfaceNote, noted};

/// The greatest number of triangles that is read.
const MOST: usize = 10_000_000;
/// The greatest distance of a vertex from the origin, metres.
const FAR: f64 = 1e5;

/// The triangles of one primitive of one node.
pub(super) struct Piece {
    pub(super) name: String,
    pub(super) joint: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) points: Vec<Point3<f64>>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// One entry per triangle, or none at all.
    pub(super) uvs: Vec<[[f32; 2]; 3]>,
}

pub(super) struct FoundJoint {
    pub(super) kind: JointKind,
    pub(super) anchor: Point3<f64>,
    pub(super) axis: Vector3<f64>,
    pub(super) limits: (f64, f64),
}

pub(super) struct FoundSurface {
    pub(super) name: String,
    pub(super) hold: Hold,
    pub(super) at: Point3<f64>,
    pub(super) half: Option<(f64, f64)>,
    pub(super) clearance: Option<f64>,
    pub(super) joint: Option<usize>,
    /// The pieces of the node's own mesh.
    pub(super) pieces: Range<usize>,
}

#[derive(Default)]
pub(super) struct Gathered {
    pub(super) pieces: Vec<Piece>,
    pub(super) joints: Vec<FoundJoint>,
    pub(super) surfaces: Vec<FoundSurface>,
    pub(super) class: Option<String>,
    triangles: usize,
}

/// Points, the triangles between them, and the triangles' texture coordinates.
type Triangles = (Vec<Point3<f64>>, Vec<[u32; 3]>, Vec<[[f32; 2]; 3]>);

/// A node to visit: its index, its parent's frame and the joint it moves with.
type Visit = (usize, Matrix4<f64>, Option<usize>);

/// Collects everything in the default scene, transformed by `frame`.
pub(super) fn gather(document: &Document, buffers: &Buffers<'_>, frame: Matrix4<f64>) -> Result<Gathered, GltfError> {
    let accessors = Accessors::new(document, buffers);
    let mut all = Gathered::default();
    let mut visited = vec![false; document.nodes.len()];
    let mut left: Vec<Visit> = roots(document)?.into_iter().rev().map(|n| (n, frame, None)).collect();
    while let Some((index, frame, joint)) = left.pop() {
        let node = document.nodes.get(index).ok_or(GltfError::missing("node", index))?;
        if std::mem::replace(&mut visited[index], true) {
            return Err(GltfError::NotATree(index));
        }
        let frame = frame * local(node).ok_or(GltfError::NoRotation(index))?;
        let joint = all.visit(&accessors, (index, node), &frame, joint)?;
        left.extend(node.children.iter().rev().map(|&child| (child, frame, joint)));
    }
    Ok(all)
}

/// The nodes of the default scene, or of the first one; without scenes, all nodes without a parent.
fn roots(document: &Document) -> Result<Vec<usize>, GltfError> {
    if let (None, true) = (document.scene, document.scenes.is_empty()) {
        let mut root = vec![true; document.nodes.len()];
        for &child in document.nodes.iter().flat_map(|n| &n.children) {
            *root.get_mut(child).ok_or(GltfError::missing("node", child))? = false;
        }
        return Ok((0..root.len()).filter(|&i| root[i]).collect());
    }
    let index = document.scene.unwrap_or(0);
    Ok(document.scenes.get(index).ok_or(GltfError::missing("scene", index))?.nodes.clone())
}

/// A node's frame in its parent's; `None` if its rotation is invalid.
fn local(node: &Node) -> Option<Matrix4<f64>> {
    if let Some(columns) = &node.matrix {
        return Some(Matrix4::from_column_slice(columns));
    }
    let wide = |v: [f32; 3]| Vector3::from(v).cast::<f64>();
    let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]).map(f64::from);
    let turn = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-6)?.to_homogeneous();
    let shift = Translation3::from(wide(node.translation.unwrap_or_default())).to_homogeneous();
    Some(shift * turn * Matrix4::new_nonuniform_scaling(&wide(node.scale.unwrap_or([1.0; 3]))))
}

impl Gathered {
    /// Collects the contents of a node, and returns the joint it moves with.
    fn visit(
        &mut self,
        accessors: &Accessors<'_>,
        (index, node): (usize, &Node),
        frame: &Matrix4<f64>,
        joint: Option<usize>,
    ) -> Result<Option<usize>, GltfError> {
        let place = || format!("node {index}");
        let note: NodeNote = noted(node.extras.as_ref(), place)?;
        self.class = self.class.take().or(note.class);
        let refuse = |reason: &str| GltfError::BadNote { place: place(), reason: reason.into() };
        let joint = match note.joint {
            Some(_) if joint.is_some() => return Err(refuse("puts a joint below another joint")),
            Some(found) => {
                let found = found_joint(&found, frame).ok_or_else(|| refuse("has no axis, or its limits swapped"))?;
                self.joints.push(found);
                Some(self.joints.len() - 1)
            }
            None => joint,
        };
        let first = self.pieces.len();
        self.mesh(accessors, node, frame, joint)?;
        if let Some(surface) = note.surface {
            let pieces = first..self.pieces.len();
            if surface.half.is_none() && pieces.is_empty() {
                return Err(refuse("has a surface without `half`, and the node has no mesh"));
            }
            let mut found =
                found_surface(&surface, frame).ok_or_else(|| refuse("has a length below zero or too long"))?;
            found.name = if node.name.is_empty() { format!("surface_{index}") } else { node.name.clone() };
            (found.joint, found.pieces) = (joint, pieces);
            self.surfaces.push(found);
        }
        Ok(joint)
    }

    fn mesh(
        &mut self,
        accessors: &Accessors<'_>,
        node: &Node,
        frame: &Matrix4<f64>,
        joint: Option<usize>,
    ) -> Result<(), GltfError> {
        let Some(index) = node.mesh else { return Ok(()) };
        let mesh = accessors.document.meshes.get(index).ok_or(GltfError::missing("mesh", index))?;
        let name = [&node.name, &mesh.name].into_iter().find(|n| !n.is_empty());
        for primitive in &mesh.primitives {
            let (points, triangles, uvs) = self.primitive(accessors, primitive, frame)?;
            if !triangles.is_empty() {
                let name = name.cloned().unwrap_or_else(|| format!("mesh_{index}"));
                self.pieces.push(Piece { name, joint, material: primitive.material, points, triangles, uvs });
            }
        }
        Ok(())
    }

    fn primitive(
        &mut self,
        accessors: &Accessors<'_>,
        primitive: &Primitive,
        frame: &Matrix4<f64>,
    ) -> Result<Triangles, GltfError> {
        let mode = primitive.mode.unwrap_or(4);
        let (4..=6, Some(position)) = (mode, primitive.attributes.position) else { return Ok(Default::default()) };
        let positions = accessors.vectors(position)?;
        let indices = primitive.indices.map(|i| accessors.indices(i)).transpose()?;
        let map = TextureMap::new(accessors, primitive)?;
        let corners = indices.as_ref().map_or(positions.count, |i| i.count);
        let count = if mode == 4 { corners / 3 } else { corners.saturating_sub(2) };
        // An empty primitive counts too, so that reading time is bounded for every file.
        self.triangles = self.triangles.saturating_add(count.max(1));
        if self.triangles > MOST {
            return Err(GltfError::TooMany { most: MOST });
        }
        let mirrored = frame.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        let mut welder = Welder { positions, frame, at: position, known: HashMap::new(), points: Vec::new() };
        let (mut triangles, mut uvs) = (Vec::new(), Vec::new());
        for t in 0..count {
            let [a, b, c] = corners_of(mode, t);
            let corner = |i: usize| indices.as_ref().map_or(Some(i), |all| all.index(i)).unwrap_or(usize::MAX);
            let turned = if mirrored { [a, c, b] } else { [a, b, c] }.map(corner);
            let [a, b, c] = [welder.vertex(turned[0])?, welder.vertex(turned[1])?, welder.vertex(turned[2])?];
            if a != b && b != c && c != a {
                triangles.push([a, b, c]);
                if let Some(map) = &map {
                    uvs.push([map.at(turned[0])?, map.at(turned[1])?, map.at(turned[2])?]);
                }
            }
        }
        Ok((welder.points, triangles, uvs))
    }
}

/// The corners of a triangle of a list, a strip or a fan.
fn corners_of(mode: u32, t: usize) -> [usize; 3] {
    match mode {
        4 => [3 * t, 3 * t + 1, 3 * t + 2],
        5 if t % 2 == 1 => [t, t + 2, t + 1],
        5 => [t, t + 1, t + 2],
        _ => [t + 1, t + 2, 0],
    }
}

/// Collects the vertices in use, those at the same place once.
struct Welder<'a> {
    positions: Elements<'a>,
    frame: &'a Matrix4<f64>,
    at: usize,
    known: HashMap<[u32; 3], u32>,
    points: Vec<Point3<f64>>,
}

impl Welder<'_> {
    fn vertex(&mut self, index: usize) -> Result<u32, GltfError> {
        let position = self
            .positions
            .numbers(index)
            .ok_or(GltfError::BadAccessor { index: self.at, reason: "has fewer vertices than the indices ask for" })?;
        if let Some(&known) = self.known.get(&position.map(|v| (v + 0.0).to_bits())) {
            return Ok(known);
        }
        let point = self.frame.transform_point(&Point3::from(position).cast());
        if !point.iter().all(|v| v.abs() <= FAR) {
            return Err(GltfError::TooFar);
        }
        self.points.push(point);
        let number = self.points.len() as u32 - 1;
        self.known.insert(position.map(|v| (v + 0.0).to_bits()), number);
        Ok(number)
    }
}

fn found_surface(note: &SurfaceNote, frame: &Matrix4<f64>) -> Option<FoundSurface> {
    let factor = frame.fixed_view::<3, 3>(0, 0).determinant().abs().cube_root();
    let half = note.half.map(|(x, y)| (f64::from(x) * factor, f64::from(y) * factor));
    let clearance = note.clearance.map(|c| f64::from(c) * factor);
    let at = frame.transform_point(&Point3::origin());
    let lengths = half.iter().flat_map(|h| [h.0, h.1]).chain(clearance).chain(at.iter().map(|v| v.abs()));
    let sound = lengths.into_iter().all(|v| (0.0..=FAR).contains(&v));
    let found = FoundSurface { name: String::new(), hold: note.hold, at, half, clearance, joint: None, pieces: 0..0 };
    sound.then_some(found)
}

fn found_joint(note: &JointNote, frame: &Matrix4<f64>) -> Option<FoundJoint> {
    let own = Vector3::from(note.axis).cast::<f64>().try_normalize(1e-9)?;
    let turned = frame.transform_vector(&own);
    let axis = turned.try_normalize(1e-9)?;
    let stretch = if note.kind == JointKind::Slide { turned.norm() } else { 1.0 };
    let limits = (f64::from(note.limits.0) * stretch, f64::from(note.limits.1) * stretch);
    let anchor = frame.transform_point(&Point3::origin());
    let finite = axis.iter().chain(anchor.iter()).chain([&limits.0, &limits.1]).all(|v| v.abs() <= FAR);
    (finite && limits.0 <= limits.1).then_some(FoundJoint { kind: note.kind, anchor, axis, limits })
}
