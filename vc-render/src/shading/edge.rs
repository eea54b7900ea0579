//! Edge detection: where edges of triangles cross pixels, so that colours can be smoothed there.
//!
//! The nearer triangle of two neighbouring pixels determines how far it reaches between their centres, or else
//! the other one does (after Persson's geometry buffer anti-aliasing, 2011). Steep edges are searched between
//! neighbours in a row and flat ones between rows, so that no edge is found twice.

use super::smooth::Edge;
use super::surfel::{Known, Writer};
use crate::math::three;
use crate::rasterization::{NONE, Solid};

/// Three lines in an image, as coefficients of x, y and one.
pub(super) type Lines = [[f32; 3]; 3];

/// Finds edges in rows of an image.
pub(super) struct Find<'a> {
    pub(super) writer: &'a Writer<'a>,
    pub(super) solid: Solid<'a>,
}

/// Channel differences up to this count as equal colours.
const SAME: u8 = 3;
/// Number of pixels compared together.
const LANES: usize = 32;

/// Colours of some pixels of a row, and of their neighbours.
type Colours<'a> = [&'a [[u8; 3]]; 2];

/// A bit mask of pixels whose group differs from their neighbour's, or that are curved and show another
/// triangle.
#[inline(always)]
fn turns([here, there]: [&[u32; LANES]; 2], [group, groups]: [&[u32; LANES]; 2]) -> u32 {
    let mut all = 0;
    for i in 0..LANES {
        // All bits are set for curved surfaces.
        let bent = (group[i] as i32 >> 31) as u32;
        let turn = (group[i] ^ groups[i]) | (bent & (here[i] ^ there[i]));
        all |= u32::from(turn != 0) << i;
    }
    all
}

/// All elements but the first.
#[inline(always)]
fn after<T>(list: &[T]) -> &[T] {
    list.get(1..).unwrap_or(&[])
}

impl Find<'_> {
    /// Finds edges between neighbouring pixels of a row.
    #[inline(always)]
    pub(super) fn across(&self, groups: &[u32], y: i32, colours: &[[u8; 3]], known: &mut Known, edges: &mut Vec<Edge>) {
        let (here, width) = (self.solid.triangle_row(y), groups.len() as u32);
        self.pairs(
            [here, after(here)],
            [groups, after(groups)],
            [colours, after(colours)],
            #[inline(always)]
            |x| {
                let inverse = self.solid.inverse_row(y);
                let share = self.between((here[x], inverse[x]), (here[x + 1], inverse[x + 1]), (x, y, 0), known);
                let nearer = self.nearer([here[x], here[x + 1]], [inverse[x], inverse[x + 1]]);
                push(edges, y as u32 * width + x as u32, 1, (share, nearer));
            },
        );
    }

    /// Finds edges between a row and the next, which must be in the planes too.
    #[inline(always)]
    pub(super) fn down(
        &self,
        groups: [&[u32]; 2],
        y: i32,
        colours: Colours<'_>,
        known: &mut Known,
        edges: &mut Vec<Edge>,
    ) {
        let width = groups[0].len() as u32;
        let (here, next) = (self.solid.triangle_row(y), self.solid.triangle_row(y + 1));
        self.pairs(
            [here, next],
            groups,
            colours,
            #[inline(always)]
            |x| {
                let (inverse, deeper) = (self.solid.inverse_row(y), self.solid.inverse_row(y + 1));
                let share = self.between((here[x], inverse[x]), (next[x], deeper[x]), (x, y, 1), known);
                let nearer = self.nearer([here[x], next[x]], [inverse[x], deeper[x]]);
                push(edges, y as u32 * width + x as u32, width, (share, nearer));
            },
        );
    }

    /// Visits pixels that show something else than their neighbour, in another colour.
    #[inline(always)]
    fn pairs(
        &self,
        [here, there]: [&[u32]; 2],
        [group, groups]: [&[u32]; 2],
        [own, beside]: Colours<'_>,
        mut edge: impl FnMut(usize),
    ) {
        let mut look_at = |x: usize| {
            let same = |k: usize| own[x][k].abs_diff(beside[x][k]) <= SAME;
            let seen = here[x] != there[x]
                && !(same(0) && same(1) && same(2))
                && !(group[x] == groups[x] && self.writer.smooth([here[x], there[x]]));
            if seen {
                edge(x);
            }
        };
        let count = here.len().min(there.len());
        let chunks = [here, there, group, groups].map(|list| list[..count].as_chunks::<LANES>().0.iter());
        let [here, there, group, groups] = chunks;
        for (part, ((here, there), (group, groups))) in here.zip(there).zip(group.zip(groups)).enumerate() {
            let mut turns = turns([here, there], [group, groups]);
            while turns != 0 {
                look_at(part * LANES + turns.trailing_zeros() as usize);
                turns &= turns - 1;
            }
        }
        (count / LANES * LANES..count).for_each(look_at);
    }

    /// Which of two triangles is nearer, if they belong to different bodies.
    fn nearer(&self, triangles: [u32; 2], [first, second]: [f32; 2]) -> Option<u32> {
        let [a, b] = triangles.map(|triangle| {
            let visible = self.writer.visible.get(triangle as usize)?;
            Some(self.writer.view.snapshot.instances[visible.instance as usize].body)
        });
        (a != b).then_some(u32::from(first < second))
    }

    /// Position of the edge between two neighbouring pixels, the second one after the first along an axis: if
    /// positive, the share of the first pixel that the second one's surface covers.
    ///
    /// The nearer triangle determines it; if that one continues, as a floor does under a thing standing on it,
    /// the other one does.
    fn between(
        &self,
        first: (u32, f32),
        second: (u32, f32),
        (x, y, axis): (usize, i32, usize),
        known: &mut Known,
    ) -> f32 {
        let mut tells = |forward: bool| {
            let triangle = if forward { first.0 } else { second.0 };
            let mut from = [x as f32 + 0.5, y as f32 + 0.5];
            from[axis] += if forward { 0.0 } else { 1.0 };
            let step = if forward { 1.0 } else { -1.0 };
            let reach = if triangle == NONE { None } else { self.reach(triangle, from, (axis, step), known) };
            // The edge's owner ends within its own pixel.
            reach.map(|(reach, across)| if across { (0.5 - reach) * step } else { 0.0 })
        };
        let forward = first.1 >= second.1;
        tells(forward).or_else(|| tells(!forward)).unwrap_or(0.0)
    }

    /// How far a triangle reaches from a point inside it along an axis, up to one pixel, and whether its edge
    /// there lies across the axis rather than along it.
    #[inline(always)]
    fn reach(
        &self,
        triangle: u32,
        from: [f32; 2],
        (axis, step): (usize, f32),
        known: &mut Known,
    ) -> Option<(f32, bool)> {
        let mut best: Option<(f32, bool)> = None;
        for line in known.lines(triangle, self.writer) {
            let here = (line[0] * from[0] + line[1] * from[1] + line[2]).max(0.0);
            let change = line[axis] * step;
            if here + change < 0.0 {
                let (at, beside) = (here / -change, line[1 - axis]);
                // Edges at equal angles to both axes count between neighbours in a row.
                let across = if axis == 0 { change.abs() >= beside.abs() } else { change.abs() > beside.abs() };
                if best.is_none_or(|best| at < best.0) {
                    best = Some((at, across));
                }
            }
        }
        best
    }
}

/// The lines along a triangle's edges in the image, positive inside.
pub(super) fn lines(corners: [[f32; 3]; 3]) -> Lines {
    let area = homogeneous(corners[0], corners[1], corners[2]).signum();
    three(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let line = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        three(|i| line[i] * area)
    })
}

fn homogeneous(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> f32 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Adds an edge between a pixel and the one `step` after it.
#[inline(always)]
fn push(edges: &mut Vec<Edge>, pixel: u32, step: u32, (share, nearer): (f32, Option<u32>)) {
    let (into, from) = if share > 0.0 { (pixel, pixel + step) } else { (pixel + step, pixel) };
    if share.abs() > 0.01 {
        edges.push(Edge { into, from, share: share.abs(), before: nearer.map(|which| pixel + which * step) });
    }
}
