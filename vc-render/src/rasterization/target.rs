//! The visibility buffer: inverse depth and triangle of every pixel of some rows.

use std::ops::Range;

use crate::mesh::Mesh;
use crate::scene::Instance;

/// Triangle of an empty pixel.
pub(crate) const NONE: u32 = u32::MAX;

/// Number of pixels drawn together.
pub(super) const LANES: usize = 8;

/// Side of the tiles of the coarse depth buffer, pixels.
const TILE: usize = 16;

/// A triangle that may be visible.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Visible {
    pub(crate) instance: u32,
    /// Level of detail and index in the mesh.
    pub(super) triangle: u32,
}

impl Visible {
    /// Bits of the triangle's number; the level of detail is stored above.
    const BITS: u32 = 29;

    pub(super) fn new(instance: u32, level: u8, triangle: u32) -> Self {
        Self { instance, triangle: u32::from(level) << Self::BITS | triangle }
    }

    /// The mesh that the triangle belongs to.
    #[inline(always)]
    pub(crate) fn mesh(self, instances: &[Instance]) -> &Mesh {
        &instances[self.instance as usize].link.levels[self.level() as usize]
    }

    /// Level of detail of its mesh.
    #[inline(always)]
    pub(crate) fn level(self) -> u32 {
        self.triangle >> Self::BITS
    }

    /// Index of the triangle in the mesh.
    #[inline(always)]
    pub(crate) fn index(self) -> usize {
        (self.triangle & ((1 << Self::BITS) - 1)) as usize
    }
}

/// Inverse depth and triangle of every pixel of a band of rows.
#[derive(Debug, Default, Clone)]
pub(crate) struct Target {
    /// Pixels across.
    pub(crate) width: usize,
    /// The rows of the image.
    pub(crate) rows: Range<i32>,
    /// Number of pixel blocks in a row.
    pub(super) stride: usize,
    /// Inverse depth; zero for empty pixels.
    pub(super) inverse: Vec<[f32; LANES]>,
    /// Triangles as indices into a list of [`Visible`].
    pub(super) triangles: Vec<[u32; LANES]>,
    tiles: Tiles,
}

/// Rows of the opaque triangles; where nothing clear was drawn, these are all triangles.
#[derive(Clone, Copy)]
pub(crate) struct Solid<'a> {
    pub(super) front: &'a Target,
    pub(super) behind: &'a Target,
}

impl<'a> Solid<'a> {
    #[inline(always)]
    fn at(self, y: i32) -> &'a Target {
        if self.behind.rows.contains(&y) { self.behind } else { self.front }
    }

    /// Like [`Target::inverse_row`].
    #[inline(always)]
    pub(crate) fn inverse_row(self, y: i32) -> &'a [f32] {
        self.at(y).inverse_row(y)
    }

    /// Like [`Target::triangle_row`].
    #[inline(always)]
    pub(crate) fn triangle_row(self, y: i32) -> &'a [u32] {
        self.at(y).triangle_row(y)
    }
}

/// The coarse depth buffer: the least inverse depth in every tile, updated when it is asked for.
#[derive(Debug, Default, Clone)]
struct Tiles {
    across: usize,
    least: Vec<f32>,
    stale: Vec<bool>,
}

impl Target {
    /// Clears it for some rows of an image of this width.
    pub(crate) fn reset(&mut self, width: usize, rows: Range<i32>) {
        // Rows are padded to whole tiles.
        self.stride = width.div_ceil(TILE) * TILE / LANES;
        self.width = width;
        let height = rows.len();
        self.rows = rows;
        refill(&mut self.inverse, [0.0; LANES], self.stride * height);
        refill(&mut self.triangles, [NONE; LANES], self.stride * height);
        self.close_margin(height);
        self.tiles.across = width.div_ceil(TILE);
        let tiles = self.tiles.across * height.div_ceil(TILE);
        refill(&mut self.tiles.least, 0.0, tiles);
        refill(&mut self.tiles.stale, false, tiles);
    }

    /// Makes it a copy of some rows of another; it cannot be drawn into afterwards.
    pub(super) fn copy(&mut self, other: &Self, rows: Range<i32>) {
        let rows = rows.start.max(other.rows.start)..rows.end.min(other.rows.end).max(rows.start.max(other.rows.start));
        let row = |y: i32| (y - other.rows.start) as usize * other.stride;
        let part = row(rows.start)..row(rows.end);
        (self.width, self.stride) = (other.width, other.stride);
        self.inverse.clear();
        self.inverse.extend_from_slice(&other.inverse[part.clone()]);
        self.triangles.clear();
        self.triangles.extend_from_slice(&other.triangles[part]);
        self.rows = rows;
    }

    /// Clears a rectangle of the image, given as ranges of columns and rows.
    pub(crate) fn erase(&mut self, columns: Range<i32>, rows: Range<i32>) {
        let columns =
            columns.start.max(0) as usize / LANES..(columns.end.max(0) as usize).div_ceil(LANES).min(self.stride);
        let rows = rows.start.max(self.rows.start)..rows.end.min(self.rows.end);
        for y in rows.clone() {
            let at = (y - self.rows.start) as usize * self.stride;
            self.inverse[at + columns.start..at + columns.end].fill([0.0; LANES]);
            self.triangles[at + columns.start..at + columns.end].fill([NONE; LANES]);
        }
        if !rows.is_empty() && !columns.is_empty() {
            self.mark(
                [(columns.start * LANES) as i32, rows.start],
                [(columns.end * LANES - 1).min(self.width - 1) as i32, rows.end - 1],
            );
        }
    }

    /// Makes the columns past the image nearer than anything, so that nothing is drawn there and tiles may
    /// count as full without them.
    fn close_margin(&mut self, height: usize) {
        for x in self.width..self.stride * LANES {
            for y in 0..height {
                self.inverse[y * self.stride + x / LANES][x % LANES] = f32::INFINITY;
            }
        }
    }

    /// Inverse depths of a row of the image, which must be one of the band's.
    #[inline]
    pub(crate) fn inverse_row(&self, y: i32) -> &[f32] {
        let at = (y - self.rows.start) as usize * self.stride;
        &self.inverse[at..at + self.stride].as_flattened()[..self.width]
    }

    /// Triangles of a row of the image, which must be one of the band's.
    #[inline]
    pub(crate) fn triangle_row(&self, y: i32) -> &[u32] {
        let at = (y - self.rows.start) as usize * self.stride;
        &self.triangles[at..at + self.stride].as_flattened()[..self.width]
    }

    /// Triangles of all rows, and the distance from one row to the next.
    #[inline]
    pub(crate) fn all_triangles(&self) -> (&[u32], usize) {
        (self.triangles.as_flattened(), self.stride * LANES)
    }

    /// Marks the pixels of a rectangle, both corners included, as changed.
    #[inline(always)]
    pub(super) fn mark(&mut self, low: [i32; 2], high: [i32; 2]) {
        let row = |y: i32| (y - self.rows.start) as usize / TILE;
        for ty in row(low[1])..=row(high[1]) {
            for tx in low[0] as usize / TILE..=high[0] as usize / TILE {
                self.tiles.stale[ty * self.tiles.across + tx] = true;
            }
        }
    }

    /// Whether all pixels of a rectangle, both corners included, are nearer than this.
    #[inline(always)]
    pub(super) fn hides(&mut self, low: [i32; 2], high: [i32; 2], inverse: f32) -> bool {
        let row = |y: i32| (y - self.rows.start) as usize / TILE;
        for ty in row(low[1])..=row(high[1]) {
            for tx in low[0] as usize / TILE..=high[0] as usize / TILE {
                if self.least(tx, ty) <= inverse {
                    return false;
                }
            }
        }
        true
    }

    #[inline(always)]
    fn least(&mut self, tx: usize, ty: usize) -> f32 {
        let tile = ty * self.tiles.across + tx;
        if self.tiles.stale[tile] {
            self.tiles.stale[tile] = false;
            self.tiles.least[tile] = self.measured(tx, ty);
        }
        self.tiles.least[tile]
    }

    #[inline(always)]
    fn measured(&self, tx: usize, ty: usize) -> f32 {
        let mut least = [f32::INFINITY; LANES];
        for y in ty * TILE..((ty + 1) * TILE).min(self.rows.len()) {
            let at = y * self.stride + tx * (TILE / LANES);
            for block in &self.inverse[at..at + TILE / LANES] {
                for (l, v) in least.iter_mut().zip(block) {
                    *l = if *v < *l { *v } else { *l };
                }
            }
        }
        least.into_iter().fold(f32::INFINITY, f32::min)
    }
}

/// Refills a list with `count` copies of `value`, reusing its memory.
pub(crate) fn refill<T: Clone>(list: &mut Vec<T>, value: T, count: usize) {
    list.clear();
    list.resize(count, value);
}
