//! Hollows found from geometry: spaces in an asset with a floor below and walls around.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use crate::carve::thin_out;
use crate::solid::{Round, Solid, gap};
use crate::threshold::{
    GRID_EVENLY, GRID_FILL, GRID_PLANES, GRID_THINNEST, HOLLOW_DEPTH, HOLLOW_VOLUME, THROUGH_SHARE,
};

/// Label of a cell that contains part of the asset.
const SOLID: u16 = u16::MAX;

/// A space in an asset that can hold things.
#[derive(Debug, Clone)]
pub(crate) struct Cavity {
    pub(crate) space: Space,
    /// Whether it is open above.
    pub(crate) open: bool,
    pub(crate) link: Option<u32>,
}

#[derive(Debug, Clone)]
pub(crate) enum Space {
    /// A box with the asset's axes.
    Box { centre: Vector3<f32>, half: Vector3<f32> },
    /// The cells of a grid that have a label.
    Cells(Arc<Cells>, u16),
}

impl Cavity {
    /// Whether a point of the asset's frame is in the cavity. If the cavity is open, the point may also be up
    /// to `above` metres above its rim.
    pub(crate) fn contains(&self, point: &Vector3<f32>, above: f32) -> bool {
        let above = if self.open { above } else { 0.0 };
        match &self.space {
            Space::Box { centre, half } => {
                let off = point - centre;
                off.x.abs() <= half.x && off.y.abs() <= half.y && off.z >= -half.z && off.z <= half.z + above
            }
            Space::Cells(cells, label) => cells.contains(point, *label, above),
        }
    }

    /// Whether a content's corner may be at a point: in the cavity, or in the walls around it.
    pub(crate) fn admits(&self, point: &Vector3<f32>) -> bool {
        match &self.space {
            Space::Box { .. } => self.contains(point, 0.0),
            Space::Cells(cells, label) => cells.admits(point, *label),
        }
    }
}

/// A grid over an asset with planes where its parts begin and end, so that it is exact for box-shaped parts.
/// Each cell is free (zero), solid, or in a hollow.
#[derive(Debug, Clone)]
pub(crate) struct Cells {
    planes: [Vec<f32>; 3],
    labels: Vec<u16>,
}

impl Cells {
    fn count(&self, axis: usize) -> usize {
        self.planes[axis].len() - 1
    }

    fn at(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.count(1) + y) * self.count(0) + x
    }

    /// The cell that contains a point, if it is in the grid.
    fn find(&self, point: &Vector3<f32>) -> Option<[usize; 3]> {
        let cell: [usize; 3] = std::array::from_fn(|i| self.planes[i].partition_point(|&p| p <= point[i]));
        let inside = |i: usize| cell[i] >= 1 && cell[i] <= self.count(i);
        (0..3).all(inside).then(|| cell.map(|c| c - 1))
    }

    /// Whether a point is in the hollow with a label, or at most `above` over it with nothing in between.
    pub(crate) fn contains(&self, point: &Vector3<f32>, label: u16, above: f32) -> bool {
        let top = self.planes[2][self.count(2)];
        let low = Vector3::new(point.x, point.y, point.z.min(top - GRID_THINNEST / 2.0));
        let Some([x, y, z]) = self.find(&low) else { return false };
        let reach = point.z - above;
        for z in (0..=z).rev() {
            match self.labels[self.at([x, y, z])] {
                l if l == label => return true,
                SOLID => return false,
                _ if self.planes[2][z] <= reach => return false,
                _ => {}
            }
        }
        false
    }

    /// Whether a point is in the hollow or in its walls.
    pub(crate) fn admits(&self, point: &Vector3<f32>, label: u16) -> bool {
        let here = self.find(point).map(|cell| self.labels[self.at(cell)]);
        here.is_some_and(|l| l == label || l == SOLID)
    }

    fn over(low: &Vector3<f32>, high: &Vector3<f32>, solids: &[Solid]) -> Option<Self> {
        let planes = std::array::from_fn(|axis| planes((low[axis], high[axis]), solids, axis));
        let sound = planes.iter().all(|p| p.len() >= 4);
        let cells = planes.iter().map(|p| p.len().saturating_sub(1)).product();
        sound.then(|| Self { planes, labels: vec![0; cells] })
    }

    fn middle(&self, axis: usize, cell: usize) -> f32 {
        f32::midpoint(self.planes[axis][cell], self.planes[axis][cell + 1])
    }

    fn size(&self, cell: [usize; 3]) -> Vector3<f32> {
        Vector3::from_fn(|i, _| self.planes[i][cell[i] + 1] - self.planes[i][cell[i]])
    }

    fn cell(&self, at: usize) -> [usize; 3] {
        [at % self.count(0), at / self.count(0) % self.count(1), at / (self.count(0) * self.count(1))]
    }

    /// Marks the cells that a solid reaches into. Most solids are upright prisms; their outline is the same at
    /// every height, and is tested once for each column of cells.
    fn fill(&mut self, solid: &Solid) {
        let range = |i: usize| {
            let start = self.planes[i].partition_point(|&p| p <= solid.low[i]).saturating_sub(1);
            start..self.planes[i].partition_point(|&p| p < solid.high[i]).min(self.count(i))
        };
        let (columns, rows, layers) = (range(0), range(1), range(2));
        let met: Vec<usize> =
            layers.filter(|&z| !solid.is_prism() || self.probe([0, 0, z]).rise(solid) < 0.0).collect();
        for y in rows {
            for x in columns.clone() {
                if solid.is_prism() {
                    if self.probe([x, y, 0]).level_gap(solid, 0.0) < 0.0 {
                        met.iter().for_each(|&z| self.mark([x, y, z]));
                    }
                } else {
                    let meets = |z: &&usize| gap(&self.probe([x, y, **z]), solid, 0.0) < 0.0;
                    let own: Vec<usize> = met.iter().filter(meets).copied().collect();
                    own.into_iter().for_each(|z| self.mark([x, y, z]));
                }
            }
        }
    }

    fn mark(&mut self, cell: [usize; 3]) {
        let at = self.at(cell);
        self.labels[at] = SOLID;
    }

    /// The part of a cell that a solid must reach into: a little less than all of it.
    fn probe(&self, cell: [usize; 3]) -> Solid {
        let centre = Vector3::from_fn(|i, _| self.middle(i, cell[i]));
        Solid::new(centre, Matrix3::identity(), self.size(cell) * (0.5 - GRID_FILL), Round::No)
    }

    /// For every cell, whether something solid lies in each direction, one bit for each of -X, +X, -Y, +Y, -Z,
    /// +Z.
    fn walls(&self) -> Vec<u8> {
        let mut seen = vec![0_u8; self.labels.len()];
        let strides = [1, self.count(0), self.count(0) * self.count(1)];
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let (count, stride) = (self.count(axis), strides[axis]);
            for line in 0..self.count(u) * self.count(v) {
                let start = line % self.count(u) * strides[u] + line / self.count(u) * strides[v];
                for back in [false, true] {
                    let mut met = 0;
                    for k in 0..count {
                        let at = start + if back { count - 1 - k } else { k } * stride;
                        met |= u8::from(self.labels[at] == SOLID) << (2 * axis + usize::from(back));
                        seen[at] |= met;
                    }
                }
            }
        }
        seen
    }

    /// Labels the whole hollow around a cell, and returns its cells.
    fn flood(&mut self, start: usize, label: u16, hollow: &[bool]) -> Vec<usize> {
        let mut met = vec![start];
        self.labels[start] = label;
        let mut next = 0;
        while let Some(&at) = met.get(next) {
            next += 1;
            let cell = self.cell(at);
            for axis in 0..3 {
                let mut step = cell;
                for to in [cell[axis].wrapping_sub(1), cell[axis] + 1] {
                    step[axis] = to;
                    if to < self.count(axis) {
                        let there = self.at(step);
                        if hollow[there] && self.labels[there] == 0 {
                            self.labels[there] = label;
                            met.push(there);
                        }
                    }
                }
            }
        }
        met
    }

    /// Whether some cells span most of the asset along an axis.
    fn goes_through(&self, cells: &[usize], axis: usize) -> bool {
        let along = cells.iter().map(|&at| self.cell(at)[axis]);
        let (low, high) = along.fold((usize::MAX, 0), |(l, h), i| (l.min(i), h.max(i)));
        let planes = &self.planes[axis];
        let whole = planes[self.count(axis)] - planes[0];
        low != usize::MAX && planes[high + 1] - planes[low] >= THROUGH_SHARE * whole
    }

    /// Whether some cells are deep and large enough to hold anything.
    fn holds(&self, cells: &[usize]) -> bool {
        let layers = cells.iter().map(|&at| self.cell(at)[2]);
        let (low, high) = layers.fold((usize::MAX, 0), |(l, h), z| (l.min(z), h.max(z)));
        let deep = low != usize::MAX && self.planes[2][high + 1] - self.planes[2][low] >= HOLLOW_DEPTH;
        let volume = |&at: &usize| self.size(self.cell(at)).product();
        deep && cells.iter().map(volume).sum::<f32>() >= HOLLOW_VOLUME
    }
}

/// Planes where parts begin and end along an axis, and some planes in between.
fn planes((low, high): (f32, f32), solids: &[Solid], axis: usize) -> Vec<f32> {
    let even = (0..=GRID_EVENLY).map(|i| low + (high - low) * i as f32 / GRID_EVENLY as f32);
    let faces = solids.iter().flat_map(|s| [s.low[axis], s.high[axis]]);
    let mut planes: Vec<f32> = faces.collect();
    planes.sort_by(f32::total_cmp);
    planes.dedup_by(|b, a| *b - *a < GRID_THINNEST);
    thin_out(&mut planes, GRID_PLANES);
    // Evenly spaced planes subdivide wide free space; they never displace the planes of faces.
    let space = (high - low) / GRID_EVENLY as f32;
    let far = |p: &f32| planes.iter().all(|q| (p - q).abs() > space / 2.0);
    let more: Vec<f32> = even.filter(far).collect();
    planes.extend(more);
    planes.sort_by(f32::total_cmp);
    planes
}

/// Finds the hollows of an asset between the corners `low` and `high` of the box around its solids. These are free
/// cells with something below and either four walls, or three walls and a roof (a shelf is open in front); and of the
/// remaining cells those with a floor, a roof and two opposite walls, if they span most of the asset (a bookcase
/// without a back, but not the strip between two legs above a table's lower board). There is nothing below the space
/// under a table, and no roof above a sofa. Costs some hundred microseconds.
pub(crate) fn find(solids: &[Solid], low: &Vector3<f32>, high: &Vector3<f32>) -> Vec<Cavity> {
    let Some(mut cells) = Cells::over(low, high, solids) else { return Vec::new() };
    solids.iter().for_each(|s| cells.fill(s));
    let walls = cells.walls();
    let mut found = Vec::new();
    let mut label = 0;
    for through in [None, Some(0), Some(1)] {
        let counts = |w: u8| through.map_or(is_enclosed(w), |axis| is_tunnel(w, axis));
        let hollow: Vec<bool> = walls.iter().zip(&cells.labels).map(|(&w, &l)| l == 0 && counts(w)).collect();
        for start in 0..hollow.len() {
            if hollow[start] && cells.labels[start] == 0 && label < SOLID - 1 {
                label += 1;
                let met = cells.flood(start, label, &hollow);
                let open = met.iter().any(|&at| walls[at] & ROOF == 0);
                if cells.holds(&met) && through.is_none_or(|axis| cells.goes_through(&met, axis)) {
                    found.push((label, open));
                }
            }
        }
    }
    let cells = Arc::new(cells);
    let cavity = |(label, open)| Cavity { space: Space::Cells(cells.clone(), label), open, link: None };
    found.into_iter().map(cavity).collect()
}

const FLOOR: u8 = 0b01_0000;
const ROOF: u8 = 0b10_0000;

fn is_enclosed(walls: u8) -> bool {
    let sides = (walls & 0b1111).count_ones();
    walls & FLOOR != 0 && (sides == 4 || (sides == 3 && walls & ROOF != 0))
}

/// Whether a cell that is open along one horizontal axis has walls along the other, a floor and a roof.
fn is_tunnel(walls: u8, axis: usize) -> bool {
    let sides = 0b11 << (2 * (1 - axis));
    walls & FLOOR != 0 && walls & ROOF != 0 && walls & sides == sides
}
