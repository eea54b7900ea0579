//! Surface normals.

use crate::camera::Camera;
use crate::frame::Strip;
use crate::math::{self, Narrow, three, unit};
use crate::rasterization::{Layers, Visible};
use crate::scene::{Instance, Snapshot};

/// Normals interpolated across a triangle in the image.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bent {
    /// Normal times inverse depth at the image's corner, and its change across and down.
    start: [f32; 3],
    across: [f32; 3],
    down: [f32; 3],
}

impl Bent {
    /// Interpolates over a triangle, given its corners as pixels and inverse depth, and the normals there.
    #[inline(always)]
    fn new(corners: [[f32; 3]; 3], normals: [[f32; 3]; 3]) -> Self {
        let [a, b, c] = corners;
        let (bx, by, cx, cy) = (b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]);
        let over = 1.0 / (bx * cy - by * cx);
        let part = |i: usize| {
            let value = |k: usize| normals[k][i] * corners[k][2];
            let (db, dc) = (value(1) - value(0), value(2) - value(0));
            let (across, down) = ((db * cy - dc * by) * over, (dc * bx - db * cx) * over);
            [value(0) - across * a[0] - down * a[1], across, down]
        };
        let parts = [part(0), part(1), part(2)];
        let [start, across, down] = three(|k| three(|i| parts[i][k]));
        Self { start, across, down }
    }

    /// A constant normal.
    pub(crate) fn flat(normal: [f32; 3]) -> Self {
        Self { start: normal, across: [0.0; 3], down: [0.0; 3] }
    }

    /// The normal at a place in the image, not of unit length.
    #[inline(always)]
    pub(crate) fn at(&self, x: f32, y: f32) -> [f32; 3] {
        three(|i| self.start[i] + self.across[i] * x + self.down[i] * y)
    }
}

/// The world normal of a flat triangle, or the interpolated normals of a smooth one. `map` leads from its mesh
/// to the image.
#[inline(always)]
pub(crate) fn bent(
    map: impl FnOnce() -> Narrow,
    near: f32,
    instances: &[Instance],
    visible: Visible,
) -> Result<[f32; 3], Bent> {
    let instance = &instances[visible.instance as usize];
    let mesh = visible.mesh(instances);
    let normals = &mesh.normals[visible.index()];
    let turned = |n: [f32; 3]| unit(math::normal(&instance.inverse, n));
    if mesh.faces[visible.index()].is_flat() {
        return Ok(turned(normals[0]));
    }
    let map = map();
    let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index()).map(|p| {
        let [x, y, z] = math::point(&map, p);
        (z >= near, [x / z, y / z, 1.0 / z])
    });
    let normals = normals.map(turned);
    if corners.iter().all(|c| c.0) {
        Err(Bent::new(corners.map(|c| c.1), normals))
    } else {
        // Triangles that reach behind the eye are taken as flat.
        Ok(unit(three(|i| normals[0][i] + normals[1][i] + normals[2][i])))
    }
}

/// Writes normals, if they are requested.
pub(crate) fn normals(camera: &Camera, snapshot: &Snapshot, layers: &Layers, strip: &mut Strip<'_>) {
    if strip.normal.is_empty() {
        return;
    }
    let frustum = crate::rasterization::Frustum::new(camera, &strip.rows);
    for y in strip.rows.clone() {
        let row = strip.row(y);
        let mut column = 0;
        let normals = &mut strip.normal[row];
        for same in layers.front.triangle_row(y).chunk_by(|a, b| a == b) {
            let pixels = &mut normals[column..column + same.len()];
            let first = column as f32 + 0.5;
            column += same.len();
            let instances = &snapshot.instances;
            let map = |v: Visible| frustum.map.after(&instances[v.instance as usize].world).narrow();
            let found = layers.visible.get(same[0] as usize);
            match found.map(|v| bent(|| map(*v), frustum.near, instances, *v)) {
                None => pixels.fill([0.0; 3]),
                Some(Ok(flat)) => pixels.fill(flat),
                Some(Err(bent)) => {
                    let at = |i: usize| unit(bent.at(first + i as f32, y as f32 + 0.5));
                    pixels.iter_mut().enumerate().for_each(|(i, n)| *n = at(i));
                }
            }
        }
    }
}
