//! A room's grid of ambient light: its points, interpolation between them, and filling in of unknown points.

use super::Ambient;
use crate::math::simd::whole;
use crate::math::three;

/// Spacing of the grid's points along the floor and upwards, metres.
const STEP: [f32; 3] = [0.5, 0.5, 0.6];
/// Greatest number of points of all rooms together, unless that is less than eight for each room: in huge
/// scenes points are farther apart. Each takes 14 kB while light is computed.
const MOST: usize = 1 << 14;

/// The grid of ambient light in a room.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    low: [f32; 3],
    over: [f32; 3],
    counts: [usize; 3],
    pub(super) points: Vec<Ambient>,
    /// Median of the mean radiance at its points. The few points by a window or a lit door do not tell how
    /// bright a room is.
    pub(super) middling: f32,
    /// The mean colour of the ambient light.
    pub(super) colour: [f32; 3],
}

impl Grid {
    /// A grid over a room, with its points `apart` times the usual spacing.
    fn over((low, high): ([f32; 3], [f32; 3]), apart: f32) -> Self {
        // Points keep away from walls; the floor goes on below half of them.
        const OFF: [f32; 3] = [0.3, 0.3, 0.12];
        let low = three(|i| low[i] + OFF[i]);
        let size = three(|i| (high[i] - OFF[i] - low[i]).max(0.05));
        let counts: [usize; 3] = three(|i| ((size[i] / (apart * STEP[i])).ceil() as usize).clamp(1, 63) + 1);
        let over = three(|i| (counts[i] - 1) as f32 / size[i]);
        Self { low, over, counts, points: Vec::new(), middling: 0.0, colour: [0.0; 3] }
    }

    /// Grids over all rooms, with points as dense as their greatest number allows.
    /// Those that are closed have the fewest.
    pub(super) fn over_all(rooms: &[([f32; 3], [f32; 3])], is_closed: impl Fn(usize) -> bool) -> Vec<Self> {
        let apart = |room: usize, apart: f32| if is_closed(room) { f32::MAX } else { apart };
        let grids = |by: f32| -> Vec<Self> {
            rooms.iter().enumerate().map(|(number, room)| Self::over(*room, apart(number, by))).collect()
        };
        let (mut apart, mut all) = (1.0, grids(1.0));
        while all.iter().map(Self::count).sum::<usize>() > MOST.max(8 * rooms.len()) {
            apart *= 1.1;
            all = grids(apart);
        }
        all.iter_mut().for_each(|grid| grid.points = vec![Ambient::default(); grid.count()]);
        all
    }

    /// The same grid with all light multiplied by a factor, and radiance from above added.
    pub(super) fn dimmed(&self, by: f32, more: f32) -> Self {
        let dimmed = |point: &Ambient| {
            let mut light = Ambient::from_above(more);
            light.mix(point, by);
            light
        };
        let colour = three(|c| self.colour[c] * by + more);
        let middling = self.middling * by + more;
        Self { points: self.points.iter().map(dimmed).collect(), middling, colour, ..self.clone() }
    }

    /// Gives all points the same light.
    pub(super) fn fill(&mut self, light: &Ambient) {
        self.points.fill(*light);
    }

    fn count(&self) -> usize {
        self.counts.iter().product()
    }

    pub(super) fn place(&self, index: usize) -> [f32; 3] {
        let [nx, ny, _] = self.counts;
        let cell = [index % nx, index / nx % ny, index / (nx * ny)];
        three(|i| self.low[i] + cell[i] as f32 / self.over[i])
    }

    /// Ambient light at a point, interpolated.
    #[inline(always)]
    pub(crate) fn at(&self, p: [f32; 3]) -> Ambient {
        let mut cell = [0_usize; 3];
        let mut share = [0.0_f32; 3];
        for i in 0..3 {
            let most = (self.counts[i] - 1) as f32;
            let x = ((p[i] - self.low[i]) * self.over[i]).max(0.0).min(most - 0.001);
            cell[i] = whole(x.floor()) as usize;
            share[i] = x - x.floor();
        }
        let [nx, ny, _] = self.counts;
        let mut sum = Ambient::default();
        for (z, high) in [(0, 1.0 - share[2]), (1, share[2])] {
            for (y, deep) in [(0, high * (1.0 - share[1])), (1, high * share[1])] {
                let first = ((cell[2] + z) * ny + cell[1] + y) * nx + cell[0];
                let pair = &self.points[first..first + 2];
                sum.mix(&pair[0], deep * (1.0 - share[0]));
                sum.mix(&pair[1], deep * share[0]);
            }
        }
        sum
    }

    /// Fills in points inside of things with the mean of their neighbours, repeatedly until all are known.
    pub(super) fn mend(&mut self) {
        let [nx, ny, nz] = self.counts;
        for _ in 0..nx.max(ny).max(nz) {
            let before = self.points.clone();
            let known = |x: usize, y: usize, z: usize| {
                // Points beyond the grid do not exist.
                let p = (x < nx && y < ny && z < nz).then(|| &before[(z * ny + y) * nx + x])?;
                p.is_known().then_some(p)
            };
            for (index, point) in self.points.iter_mut().enumerate().filter(|(_, p)| !p.is_known()) {
                let (x, y, z) = (index % nx, index / nx % ny, index / (nx * ny));
                let down = |v: usize| v.wrapping_sub(1);
                let around =
                    [(down(x), y, z), (x + 1, y, z), (x, down(y), z), (x, y + 1, z), (x, y, down(z)), (x, y, z + 1)];
                let found: Vec<&Ambient> = around.into_iter().filter_map(|(x, y, z)| known(x, y, z)).collect();
                if !found.is_empty() {
                    *point = Ambient::default();
                    found.iter().for_each(|f| point.mix(f, 1.0 / found.len() as f32));
                }
            }
            if before.iter().all(Ambient::is_known) {
                return;
            }
        }
        // A room without any free point is dark.
        self.points.iter_mut().filter(|p| !p.is_known()).for_each(|p| *p = Ambient::default());
    }

    /// By how much the light has increased in total.
    pub(super) fn more(&self, before: &[Ambient]) -> f32 {
        self.points.iter().zip(before).map(|(point, before)| point.mean() - before.mean()).sum()
    }

    /// Extrapolates the remaining bounces as a geometric series, each bringing `share` of the last one's light.
    pub(super) fn go_on(&mut self, before: &[Ambient], share: f32) {
        let sum = share / (1.0 - share);
        for (point, before) in self.points.iter_mut().zip(before) {
            let now = *point;
            point.mix(&now, sum);
            point.mix(before, -sum);
        }
    }

    /// Smooths the finished light, and finds its median brightness and mean colour.
    pub(super) fn settle(&mut self) {
        self.smooth();
        self.middling = self.middle();
        self.colour = self.mean();
    }

    /// Averages with neighbours along each axis in turn: rays are few, and the things they miss differ from
    /// point to point.
    fn smooth(&mut self) {
        let [nx, ny, _] = self.counts;
        for (axis, stride) in [(0, 1), (1, nx), (2, nx * ny)] {
            let before = self.points.clone();
            for (index, point) in self.points.iter_mut().enumerate() {
                let cell = index / stride % self.counts[axis];
                let low = if cell > 0 { index - stride } else { index };
                let high = if cell + 1 < self.counts[axis] { index + stride } else { index };
                *point = Ambient::default();
                for (index, share) in [(low, 0.25), (high, 0.25), (index, 0.5)] {
                    point.mix(&before[index], share);
                }
            }
        }
    }

    /// The mean colour of its points' light from all directions.
    fn mean(&self) -> [f32; 3] {
        let share = 1.0 / self.points.len() as f32;
        self.points.iter().fold([0.0; 3], |sum, point| {
            let light = point.colour();
            three(|c| sum[c] + share * light[c])
        })
    }

    /// The median of its points' mean radiances.
    fn middle(&self) -> f32 {
        let mut means: Vec<f32> = self.points.iter().map(Ambient::mean).collect();
        let middle = means.len() / 2;
        *means.select_nth_unstable_by(middle, f32::total_cmp).1
    }
}
