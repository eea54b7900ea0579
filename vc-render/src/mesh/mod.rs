//! Meshes as uploaded once for each asset: clusters of nearby triangles.

mod build;
mod cluster;
mod link;
mod simplify;

use std::sync::OnceLock;

pub(crate) use build::Source;
pub(crate) use cluster::Cluster;
pub(crate) use link::{Finish, Link, TOLERANCES, links, single};

use crate::affine::{Affine, three};
use crate::trace::Bvh;

/// Greatest number of triangles in a cluster, so that a byte can index their corners.
pub(crate) const MOST: usize = 85;

/// Triangles of one link of an asset at one level of detail, in the asset's frame.
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    /// Clusters, the opaque ones first.
    pub(crate) clusters: Vec<Cluster>,
    /// Number of opaque clusters.
    pub(crate) opaque: usize,
    /// Vertices by cluster, one list for each axis.
    pub(crate) axes: [Vec<f32>; 3],
    /// Corners of triangles as indices relative to their cluster's first vertex.
    pub(crate) corners: Vec<[u8; 3]>,
    /// A triangle's remaining attributes.
    pub(crate) faces: Vec<Face>,
    /// Normals at the corners of triangles, unit length; stored separately, as they are rarely needed.
    pub(crate) normals: Vec<[[f32; 3]; 3]>,
    /// Texture coordinates at the corners of triangles; empty if no surface is textured.
    pub(crate) uvs: Vec<[[f32; 2]; 3]>,
    /// The bounding box in the asset's frame.
    pub(crate) bounds: Bounds,
    /// Trees for ray casting, built on first use.
    pub(crate) trees: OnceLock<[Bvh; 2]>,
}

/// A box, by its centre and half its lengths.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) centre: [f32; 3],
    pub(crate) half: [f32; 3],
}

/// A bounding sphere in the world.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Ball {
    pub(crate) middle: [f32; 3],
    pub(crate) radius: f32,
}

/// Attributes of a triangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Face {
    /// Index of the part in the asset.
    pub(crate) part: u16,
    /// Index in the renderer's list of surfaces.
    pub(crate) surface: u16,
    /// Direction of its normal in steps of an eighth; zero if its corner normals differ.
    pub(crate) facet: u16,
    /// Whether it belongs to a sheet: another triangle that faces the other way is in the same place.
    pub(crate) sheet: bool,
    /// The asset's axis along which its part is longest, and the axis along which it faces.
    pub(crate) grain: u8,
    pub(crate) axis: u8,
}

impl Face {
    /// Whether its corner normals are equal.
    #[inline(always)]
    pub(crate) fn is_flat(&self) -> bool {
        self.facet != 0
    }
}

impl Bounds {
    /// The bounding box of points; for no points, an empty box at the origin.
    pub(crate) fn around(points: impl Iterator<Item = [f32; 3]>) -> Self {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for p in points {
            low = [0, 1, 2].map(|i: usize| low[i].min(p[i]));
            high = [0, 1, 2].map(|i: usize| high[i].max(p[i]));
        }
        if low[0] > high[0] {
            return Self::default();
        }
        let half = [0, 1, 2].map(|i: usize| 0.5 * (high[i] - low[i]));
        Self { centre: [0, 1, 2].map(|i: usize| low[i] + half[i]), half }
    }

    /// The bounding sphere of the mapped box.
    pub(crate) fn ball(&self, world: &Affine) -> Ball {
        let middle = world.point(self.centre.map(f64::from)).map(|v| v as f32);
        let side = |c: usize| three(|r| world.0[r][c] as f32 * self.half[c]);
        let (a, b, c) = (side(0), side(1), side(2));
        let corner = |s: f32, t: f32| three(|i| a[i] + s * b[i] + t * c[i]);
        let corners = [corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, 1.0), corner(-1.0, -1.0)];
        let square = corners.map(|v| v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).into_iter().fold(0.0, f32::max);
        Ball { middle, radius: square.sqrt() }
    }

    /// The bounding box of two boxes.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        let corners = |b: &Self| [-1.0, 1.0].map(|s| [0, 1, 2].map(|i: usize| b.centre[i] + s * b.half[i]));
        Self::around(corners(self).into_iter().chain(corners(other)))
    }
}

impl Mesh {
    /// Number of triangles.
    pub(crate) fn len(&self) -> usize {
        self.corners.len()
    }

    /// Corners of a triangle of a cluster.
    #[inline(always)]
    pub(crate) fn triangle(&self, cluster: &Cluster, index: usize) -> [[f32; 3]; 3] {
        let corners = &self.corners[index];
        three(|k| {
            let at = cluster.vertices.start as usize + usize::from(corners[k]);
            [self.axes[0][at], self.axes[1][at], self.axes[2][at]]
        })
    }

    /// The cluster of a triangle.
    pub(crate) fn cluster_of(&self, triangle: usize) -> &Cluster {
        let after = self.clusters.partition_point(|c| c.triangles.start as usize <= triangle);
        &self.clusters[after.saturating_sub(1)]
    }

    /// Its size in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.clusters.len() * size_of::<Cluster>()
            + self.axes.iter().map(|a| a.len() * 4).sum::<usize>()
            + self.corners.len() * 3
            + self.faces.len() * (size_of::<Face>() + size_of::<[[f32; 3]; 3]>())
            + self.uvs.len() * size_of::<[[f32; 2]; 3]>()
    }
}
