//! Meshes as uploaded once for each asset: clusters of nearby triangles.

mod build;
mod cluster;
mod link;
mod simplify;

use std::sync::OnceLock;

pub(crate) use build::Source;
pub(crate) use cluster::Cluster;
pub(crate) use link::{Finish, Link, TOLERANCES, links, single};

use crate::bvh::Bvh;
use crate::math::{Bounds, three};

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
