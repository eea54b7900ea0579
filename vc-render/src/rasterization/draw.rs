//! Drawing of instances into the visibility buffer, nearest first.

use std::ops::Range;

use pulp::{Simd, WithSimd};

use super::clip::Polygon;
use super::cull::{Frustum, looks_away};
use super::fill;
use super::project::{Corner, Points};
use super::setup::{EIGHT, SIFTED, Setup};
use super::target::{Solid, Target, Visible};
use crate::math::{Affine, Narrow};
use crate::mesh::{Cluster, Mesh, TOLERANCES};
use crate::scene::Instance;

/// Distance of the near plane from which on it cuts things open, as a plan does, metres: their back faces are drawn,
/// too, as one sees into them. Nearer planes only leave out what the eye is in.
const CUTS: f32 = 0.5;

/// Instances to draw, and the view.
#[derive(Clone, Copy)]
pub(crate) struct Drawing<'a> {
    pub(crate) instances: &'a [Instance],
    pub(crate) frustum: Frustum,
    /// Largest screen-space error of a curved outline, pixels.
    pub(crate) detail: f32,
}

/// The visibility buffers, with the working memory of drawing.
#[derive(Default)]
pub(crate) struct Layers {
    /// The nearest triangles, clear ones included.
    pub(crate) front: Target,
    /// The nearest opaque triangles, in the rows that contain clear ones.
    pub(crate) behind: Target,
    /// Whether something clear was drawn, so that the two buffers differ.
    pub(crate) clear: bool,
    /// Triangles that may be visible, by number.
    pub(crate) visible: Vec<Visible>,
    order: Vec<Placed>,
    points: Option<Box<Points>>,
    setup: Option<Box<Setup>>,
}

/// A drawing pass, compiled for the processor's vectors.
struct Pass<'a, 'b, I> {
    layers: &'a mut Layers,
    drawing: &'a Drawing<'b>,
    which: I,
    /// Whether to draw clear triangles, and if so whether to keep the opaque ones behind them.
    apart: Option<bool>,
}

impl<I: Iterator<Item = u32>> WithSimd for Pass<'_, '_, I> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        self.layers.pass(simd, self.drawing, self.which, self.apart);
    }
}

/// An instance in view.
struct Placed {
    nearest: f32,
    rows: Range<i32>,
    instance: u32,
    level: u8,
}

impl Layers {
    /// The nearest opaque triangles.
    pub(crate) fn solid(&self) -> Solid<'_> {
        Solid { front: &self.front, behind: &self.behind }
    }

    /// Draws instances into some rows of the image. With `apart`, the opaque triangles behind clear ones are
    /// kept too.
    pub(crate) fn draw(
        &mut self,
        drawing: &Drawing<'_>,
        which: impl Iterator<Item = u32>,
        (width, rows): (usize, Range<i32>),
        apart: bool,
    ) {
        self.front.reset(width, rows);
        self.visible.clear();
        self.add(drawing, which, apart);
    }

    /// Like [`Self::draw`], without clear triangles.
    pub(crate) fn draw_solid(
        &mut self,
        drawing: &Drawing<'_>,
        which: impl Iterator<Item = u32>,
        (width, rows): (usize, Range<i32>),
    ) {
        self.front.reset(width, rows);
        self.visible.clear();
        crate::math::simd::dispatch(Pass { layers: self, drawing, which, apart: None });
    }

    /// Like [`Self::draw`], on top of the present contents.
    pub(crate) fn add(&mut self, drawing: &Drawing<'_>, which: impl Iterator<Item = u32>, apart: bool) {
        crate::math::simd::dispatch(Pass { layers: self, drawing, which, apart: Some(apart) });
    }

    #[inline(always)]
    fn pass<S: Simd>(&mut self, simd: S, drawing: &Drawing<'_>, which: impl Iterator<Item = u32>, apart: Option<bool>) {
        self.sort(drawing, which);
        let order = std::mem::take(&mut self.order);
        for placed in &order {
            self.instance(simd, drawing, placed, false);
        }
        let glazed = |p: &Placed| {
            let mesh = &*drawing.instances[p.instance as usize].link.levels[usize::from(p.level)];
            mesh.opaque < mesh.clusters.len()
        };
        self.clear = apart.is_some() && order.iter().any(glazed);
        let rows = order.iter().filter(|p| glazed(p)).map(|p| p.rows.clone());
        let rows = rows.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end));
        let kept = rows.filter(|_| apart == Some(true)).unwrap_or(self.front.rows.start..self.front.rows.start);
        self.behind.copy(&self.front, kept);
        if self.clear {
            for placed in order.iter().filter(|p| glazed(p)) {
                self.instance(simd, drawing, placed, true);
            }
        }
        self.order = order;
    }

    /// Collects the instances in view, nearest first.
    #[inline(always)]
    fn sort(&mut self, drawing: &Drawing<'_>, which: impl Iterator<Item = u32>) {
        self.order.clear();
        for index in which {
            let instance = &drawing.instances[index as usize];
            if drawing.frustum.misses(&instance.ball) {
                continue;
            }
            let map = drawing.frustum.map.after(&instance.world).narrow();
            let bounds = &instance.link.levels[0].bounds;
            let Some(extent) = drawing.frustum.extent(&map, bounds) else { continue };
            let level = drawing.level(instance, extent.nearest);
            let rows = extent.low[1]..extent.high[1] + 1;
            self.order.push(Placed { nearest: extent.nearest, rows, instance: index, level });
        }
        self.order.sort_unstable_by(|a, b| a.nearest.total_cmp(&b.nearest).then(a.instance.cmp(&b.instance)));
    }

    #[inline(always)]
    fn instance<S: Simd>(&mut self, simd: S, drawing: &Drawing<'_>, placed: &Placed, clear: bool) {
        let instance = &drawing.instances[placed.instance as usize];
        let mesh = &*instance.link.levels[usize::from(placed.level)];
        let map = drawing.frustum.map.after(&instance.world);
        let narrow = map.narrow();
        let clusters = if clear { mesh.opaque..mesh.clusters.len() } else { 0..mesh.opaque };
        let alone = mesh.clusters.len() == 1;
        if !alone && self.hidden(drawing, &narrow, &mesh.bounds) {
            return;
        }
        let eye = crate::math::point(&instance.inverse, drawing.frustum.eye);
        let open = drawing.frustum.near >= CUTS && placed.nearest <= drawing.frustum.near;
        for cluster in &mesh.clusters[clusters] {
            if (looks_away(cluster, eye) && !open) || self.hidden(drawing, &narrow, &cluster.bounds) {
                continue;
            }
            let run = Run {
                mesh,
                cluster,
                map: &map,
                narrow: &narrow,
                near: drawing.frustum.near,
                mirrored: instance.mirrored,
                open,
            };
            let name = |triangle: u32| Visible::new(placed.instance, placed.level, triangle);
            self.cluster(simd, &run, name);
        }
    }

    /// Whether a box is out of view or hidden behind drawn triangles.
    #[inline(always)]
    fn hidden(&mut self, drawing: &Drawing<'_>, map: &Narrow, bounds: &crate::math::Bounds) -> bool {
        let Some(extent) = drawing.frustum.extent(map, bounds) else { return true };
        // A thousandth nearer, to allow for rounding.
        extent.nearest > drawing.frustum.near && self.front.hides(extent.low, extent.high, 1.001 / extent.nearest)
    }

    #[inline(always)]
    fn cluster<S: Simd>(&mut self, simd: S, run: &Run<'_>, name: impl Fn(u32) -> Visible) {
        let points = self.points.get_or_insert_with(|| Box::new(Points::new()));
        let vertices = run.cluster.vertices.start as usize..run.cluster.vertices.end as usize;
        let axes = [0, 1, 2].map(|axis: usize| &run.mesh.axes[axis][vertices.clone()]);
        let stray = points.project(axes, run.narrow, run.near);
        let first = run.cluster.triangles.start;
        let triangles = &run.mesh.corners[first as usize..run.cluster.triangles.end as usize];
        if stray || run.open {
            return self.with_strays(simd, run, triangles, name);
        }
        let setup = self.setup.get_or_insert_with(|| Box::new(Setup::new()));
        let (points, mut kept) = ((&**points, run.mirrored), [0; SIFTED]);
        let kept = setup.sift(points, triangles, &self.front, &mut kept);
        for eight in kept.chunks(EIGHT) {
            setup.load(points, eight.iter().map(|index| triangles[usize::from(*index)]), &self.front);
            for (lane, small) in setup.drawn() {
                let number = self.visible.len() as u32;
                let drawn = if small {
                    fill::small(simd, &mut self.front, setup, lane, number);
                    true
                } else {
                    fill::triangle(
                        simd,
                        &mut self.front,
                        &points.0.triangle(triangles[usize::from(eight[lane])], run.mirrored),
                        number,
                    )
                };
                if drawn {
                    self.visible.push(name(first + u32::from(eight[lane])));
                }
            }
        }
    }

    /// Draws a cluster in which some triangles need clipping.
    #[inline(always)]
    fn with_strays<S: Simd>(&mut self, simd: S, run: &Run<'_>, triangles: &[[u8; 3]], name: impl Fn(u32) -> Visible) {
        let Some(points) = &self.points else { return };
        for (corners, index) in triangles.iter().zip(run.cluster.triangles.start..) {
            let number = self.visible.len() as u32;
            let any = corners.iter().any(|&v| points.stray[usize::from(v)] != 0);
            let mut fill = |t: [Corner; 3]| {
                let [a, b, c] = t;
                fill::triangle(simd, &mut self.front, &t, number)
                    || (run.open && fill::triangle(simd, &mut self.front, &[a, c, b], number))
            };
            let drawn = if any {
                run.clipped(*corners).triangles().fold(false, |d, t| fill(t) | d)
            } else {
                fill(points.triangle(*corners, run.mirrored))
            };
            if drawn {
                self.visible.push(name(index));
            }
        }
    }
}

/// A cluster being drawn.
struct Run<'a> {
    mesh: &'a Mesh,
    cluster: &'a Cluster,
    map: &'a Affine,
    narrow: &'a Narrow,
    near: f32,
    mirrored: bool,
    /// Whether the near plane cuts the instance open.
    open: bool,
}

impl Run<'_> {
    #[cold]
    fn clipped(&self, [a, b, c]: [u8; 3]) -> Polygon {
        let corners = if self.mirrored { [a, b, c] } else { [a, c, b] };
        let point = |corner: u8| {
            let at = self.cluster.vertices.start as usize + usize::from(corner);
            let p = [0, 1, 2].map(|axis: usize| f64::from(self.mesh.axes[axis][at]));
            self.map.point(p)
        };
        Polygon::clipped(corners.map(point), self.near)
    }
}

impl Drawing<'_> {
    /// The coarsest level of detail with an allowed screen-space error.
    #[inline(always)]
    fn level(&self, instance: &Instance, nearest: f32) -> u8 {
        let stretch = instance.world.0.iter().flat_map(|row| &row[..3]).fold(0.0_f64, |m, v| m.max(v.abs())) as f32;
        let error = stretch * self.frustum.focal / nearest.max(self.frustum.near);
        (1..TOLERANCES.len()).rev().find(|&l| TOLERANCES[l] * error <= self.detail).unwrap_or(0) as u8
    }
}
