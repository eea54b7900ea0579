//! Building of meshes: triangles are split into clusters.

use std::collections::HashMap;

use vc_graph::TriangleMesh;

use super::cluster::cone;
use super::{Cluster, Face, MOST, Mesh};
use crate::math;
use crate::math::Bounds;

/// A part's triangles, in the asset's frame, with its surface.
pub(crate) struct Source {
    pub(crate) mesh: TriangleMesh,
    pub(crate) part: u16,
    pub(crate) surface: u16,
    pub(crate) clear: bool,
    /// Whether it is a sheet, whose two sides are in the same place.
    pub(crate) sheet: bool,
}

/// A triangle before clustering.
struct Loose {
    corners: [[f32; 3]; 3],
    middle: [f32; 3],
    /// Its normal; zero if it has no area.
    normal: [f32; 3],
    face: Face,
    normals: [[f32; 3]; 3],
    uvs: [[f32; 2]; 3],
}

impl Mesh {
    /// Builds clusters of the parts' triangles, opaque parts first.
    pub(crate) fn build(sources: &[Source]) -> Self {
        let mut mesh = Self::default();
        for clear in [false, true] {
            let mut loose: Vec<Loose> = sources.iter().filter(|s| s.clear == clear).flat_map(triangles).collect();
            mesh.split(&mut loose);
            if !clear {
                mesh.opaque = mesh.clusters.len();
            }
        }
        if sources.iter().all(|s| s.mesh.uvs.is_empty()) {
            mesh.uvs = Vec::new();
        }
        mesh.bounds = mesh.clusters.iter().map(|c| c.bounds).reduce(|a, b| a.joined(&b)).unwrap_or_default();
        mesh
    }

    /// Splits at the median along the longest side until clusters are small enough.
    fn split(&mut self, loose: &mut [Loose]) {
        if loose.len() <= MOST {
            return self.push(loose);
        }
        let around = Bounds::around(loose.iter().map(|t| t.middle));
        let axis = (0..3).fold(0, |best, i| if around.half[i] > around.half[best] { i } else { best });
        let middle = loose.len() / 2;
        loose.sort_by(|a, b| a.middle[axis].total_cmp(&b.middle[axis]));
        let (low, high) = loose.split_at_mut(middle);
        self.split(low);
        self.split(high);
    }

    fn push(&mut self, loose: &[Loose]) {
        if loose.is_empty() {
            return;
        }
        let (vertices, triangles) = (self.axes[0].len() as u32, self.corners.len() as u32);
        let mut known: HashMap<[u32; 3], u8> = HashMap::with_capacity(3 * loose.len());
        for triangle in loose {
            let corners = triangle.corners.map(|p| {
                let next = (self.axes[0].len() as u32 - vertices) as u8;
                *known.entry(p.map(|v| (v + 0.0).to_bits())).or_insert_with(|| {
                    self.axes.iter_mut().zip(p).for_each(|(axis, v)| axis.push(v));
                    next
                })
            });
            self.corners.push(corners);
            self.faces.push(triangle.face);
            self.normals.push(triangle.normals);
            self.uvs.push(triangle.uvs);
        }
        let normals: Vec<[f32; 3]> = loose.iter().map(|t| t.normal).filter(|n| *n != [0.0; 3]).collect();
        let (axis, spread) = cone(&normals);
        self.clusters.push(Cluster {
            vertices: vertices..self.axes[0].len() as u32,
            triangles: triangles..self.corners.len() as u32,
            bounds: Bounds::around(loose.iter().flat_map(|t| t.corners)),
            axis,
            spread,
        });
    }
}

fn triangles(source: &Source) -> impl Iterator<Item = Loose> + '_ {
    let mesh = &source.mesh;
    let grain = mesh.bounds().map_or(0, |b| math::longest((b.max - b.min).into()));
    mesh.triangles.iter().enumerate().filter_map(move |(number, triangle)| {
        let at = triangle.map(|v| v as usize);
        let [a, b, c] = [mesh.positions.get(at[0])?, mesh.positions.get(at[1])?, mesh.positions.get(at[2])?];
        let normals = [mesh.normals.get(at[0])?, mesh.normals.get(at[1])?, mesh.normals.get(at[2])?];
        let normals = normals.map(|n| [n.x, n.y, n.z]);
        let flat = normals[0] == normals[1] && normals[1] == normals[2];
        let facet = if flat { facet(normals[0]) } else { 0 };
        let across = (b.cast::<f64>() - a.cast()).cross(&(c.cast::<f64>() - a.cast()));
        let normal = across.try_normalize(0.0).unwrap_or_default().cast::<f32>();
        let middle = (a.coords + b.coords + c.coords) / 3.0;
        Some(Loose {
            corners: [a, b, c].map(|p| [p.x, p.y, p.z]),
            middle: middle.into(),
            normal: normal.into(),
            face: Face {
                part: source.part,
                surface: source.surface,
                facet,
                sheet: source.sheet,
                grain,
                axis: math::longest(normals[0]),
            },
            normals,
            uvs: mesh.uvs.get(number).copied().unwrap_or_default(),
        })
    })
}

/// The direction of a normal, quantized in steps of an eighth; never zero.
fn facet(normal: [f32; 3]) -> u16 {
    let [x, y, z] = normal.map(|v| ((v * 8.0).round() as i32 + 9) as u16);
    x << 10 | y << 5 | z
}
