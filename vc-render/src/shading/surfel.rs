//! Surface attributes at every pixel, before shading.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

mod first;

use super::edge::{Lines, lines};
use super::planes::{Row, gloss_of};
use super::texture::Texture;
use crate::labels::Bent;
use crate::light::Lighting;
use crate::math::simd::stretches;
use crate::math::{self, Affine, Narrow, three};
use crate::rasterization::{Frustum, Layers, NONE, Solid, Visible, refill};
use crate::scene::Store;
use crate::scene::{Instance, NO_ROOM};
use crate::shot::View;
use crate::surface::SPAN;

/// Attributes that all pixels of an instance's surface share.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SurfaceGroup {
    surface: u16,
    /// Direction it faces; sharply curved surfaces have several groups.
    facet: u16,
    pub(super) room: u16,
    pub(super) mirror: bool,
    /// Emission.
    pub(super) glow: [f32; 3],
    /// Emission through its texture, expressed as light that falls on the surface and is reflected.
    pub(super) shine: [f32; 3],
    /// The next group of the same instance.
    next: u32,
    /// Its paint for each orientation of the texture.
    paints: [u32; 9],
}

/// Flag in the group numbers of curved surfaces.
pub(super) const BENT: u32 = 1 << 31;

/// Group and paint of pixels where nothing is visible.
pub(super) const NOTHING: u32 = 0;

/// Colours and texture of pixels.
#[derive(Debug, Clone)]
struct Paint {
    group: u32,
    colour: [f32; 3],
    roughness: f32,
    metallic: f32,
    texture: Option<Texture>,
}

/// Cached data of a band's instances and triangles.
#[derive(Default)]
pub(crate) struct Known {
    /// For each instance, the index of its maps.
    maps: Vec<u32>,
    /// Maps from a mesh to the image, and from (x, y, 1) times depth to the mesh.
    pairs: Vec<[Narrow; 2]>,
    /// For each visible triangle, the index of its paint.
    triangles: Vec<u32>,
    paints: Vec<Paint>,
    /// Stretches of a row with the same paint: the first pixel of each, and the paint.
    painted: Vec<(u32, u32)>,
    /// For each visible triangle, the index of its normals.
    bent: Vec<u32>,
    bends: Vec<Bent>,
    /// For each visible triangle, the index of its edges.
    edged: Vec<u32>,
    lines: Vec<Lines>,
    /// For each instance, the first of its groups.
    heads: Vec<u32>,
    groups: Vec<SurfaceGroup>,
}

/// A view whose surface attributes are written.
pub(super) struct Writer<'a> {
    pub(super) store: &'a Store,
    pub(super) lighting: &'a Lighting,
    pub(super) view: View<'a>,
    pub(super) exposure: [f32; 3],
    pub(super) visible: &'a [Visible],
    pub(super) frustum: Frustum,
    /// Map from (x, y, 1) times depth to the world.
    pub(super) world: Narrow,
}

const UNMOVED: Narrow = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

impl Known {
    pub(super) fn reset(&mut self, instances: usize, visible: usize) {
        refill(&mut self.maps, NONE, instances);
        refill(&mut self.heads, NONE, instances);
        refill(&mut self.triangles, NONE, visible);
        refill(&mut self.bent, NONE, visible);
        refill(&mut self.edged, NONE, visible);
        self.lines.clear();
        self.pairs.clear();
        self.bends.clear();
        self.groups.clear();
        self.paints.clear();
        let group = SurfaceGroup {
            surface: 0,
            facet: 0,
            room: NO_ROOM,
            mirror: false,
            glow: [0.0; 3],
            shine: [0.0; 3],
            next: NONE,
            paints: [NONE; 9],
        };
        self.groups.push(group);
        let colour = [0.0; 3];
        self.paints.push(Paint { group: NOTHING, colour, roughness: 1.0, metallic: 0.0, texture: None });
    }

    /// An instance's maps to the image and back, computed on first use.
    pub(super) fn maps(&mut self, index: u32, instances: &[Instance], frustum: &Frustum) -> &[Narrow; 2] {
        let known = &mut self.maps[index as usize];
        if *known == NONE {
            *known = self.pairs.len() as u32;
            let map = frustum.map.after(&instances[index as usize].world);
            self.pairs.push([map.narrow(), map.inverse().unwrap_or(Affine::IDENTITY).narrow()]);
        }
        &self.pairs[*known as usize]
    }

    /// The edges of a triangle in the image.
    #[inline(always)]
    pub(super) fn lines(&mut self, triangle: u32, writer: &Writer<'_>) -> &Lines {
        if self.edged[triangle as usize] == NONE {
            self.edge(triangle, writer);
        }
        &self.lines[self.edged[triangle as usize] as usize]
    }

    #[inline(never)]
    fn edge(&mut self, triangle: u32, writer: &Writer<'_>) {
        let (visible, instances) = (writer.visible[triangle as usize], &writer.view.snapshot.instances);
        let (mesh, index) = (visible.mesh(instances), visible.index());
        let map = self.maps(visible.instance, instances, &writer.frustum)[0];
        let corners = mesh.triangle(mesh.cluster_of(index), index).map(|p| math::point(&map, p));
        self.edged[triangle as usize] = self.lines.len() as u32;
        self.lines.push(lines(corners));
    }
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        store: &'a Store,
        (lighting, exposure): (&'a Lighting, [f32; 3]),
        view: View<'a>,
        layers: &'a Layers,
        rows: &std::ops::Range<i32>,
    ) -> Self {
        let frustum = Frustum::new(view.camera, rows);
        let world = frustum.map.inverse().unwrap_or(Affine::IDENTITY).narrow();
        Self { store, lighting, view, exposure, visible: &layers.visible, frustum, world }
    }

    /// Writes the surface attributes of a row of the image.
    #[inline(always)]
    pub(super) fn row(&self, solid: Solid<'_>, y: i32, known: &mut Known, row: &mut Row) {
        let triangles = solid.triangle_row(y);
        row.cells.inverse[..triangles.len()].copy_from_slice(solid.inverse_row(y));
        known.painted.clear();
        stretches(
            triangles,
            #[inline(always)]
            |triangle, from, _| {
                let paint = self.paint(triangle, known);
                if known.painted.last().is_none_or(|last| last.1 != paint) {
                    known.painted.push((from as u32, paint));
                }
            },
        );
        known.painted.push((triangles.len() as u32, NOTHING));
        for ((from, paint), (to, _)) in known.painted.iter().zip(known.painted.iter().skip(1)) {
            known.write(*paint, row, *from as usize..*to as usize, (y, self.frustum.focal));
        }
    }

    /// The paint of a triangle.
    #[inline(always)]
    fn paint(&self, triangle: u32, known: &mut Known) -> u32 {
        match known.triangles.get(triangle as usize) {
            None => NOTHING,
            Some(&NONE) => self.mixed(triangle, known),
            Some(paint) => *paint,
        }
    }

    /// The normal at a place in the image, of the triangle visible there; not of unit length.
    #[inline(always)]
    pub(super) fn normal(&self, triangle: u32, (x, y): (f32, f32), known: &mut Known) -> [f32; 3] {
        if triangle == NONE {
            return [0.0, 0.0, 1.0];
        }
        if known.bent[triangle as usize] == NONE {
            self.bend(triangle, known);
        }
        known.bends[known.bent[triangle as usize] as usize].at(x, y)
    }

    /// Whether two triangles of one group meet without a crease.
    #[inline(always)]
    pub(super) fn smooth(&self, triangles: [u32; 2]) -> bool {
        if triangles.contains(&NONE) {
            return true;
        }
        let instances = &self.view.snapshot.instances;
        let normal = |triangle: u32| {
            let visible = self.visible[triangle as usize];
            &visible.mesh(instances).normals[visible.index()][0]
        };
        let (a, b) = (normal(triangles[0]), normal(triangles[1]));
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0.8
    }
}

impl Known {
    /// The group of a number.
    #[inline(always)]
    pub(super) fn group(&self, number: u32) -> &SurfaceGroup {
        &self.groups[(number & !BENT) as usize]
    }

    /// Whether any group is a mirror.
    pub(super) fn mirrors(&self) -> bool {
        self.groups.iter().any(|group| group.mirror)
    }

    /// Stores the paint of a triangle, and returns its number.
    fn paint(&mut self, triangle: u32, paint: Paint) -> u32 {
        self.paints.push(paint);
        self.triangles[triangle as usize] = self.paints.len() as u32 - 1;
        self.paints.len() as u32 - 1
    }

    /// Writes pixels of a row that have the same paint, and some after them.
    #[inline(always)]
    fn write(&self, paint: u32, row: &mut Row, at: std::ops::Range<usize>, (y, focal): (i32, f32)) {
        let Paint { group, colour, roughness, metallic, texture } = &self.paints[paint as usize];
        let Some(texture) = texture else {
            let gloss = gloss_of(*roughness, *metallic);
            at.step_by(SPAN).for_each(|from| row.even(from, (*group, *colour, gloss)));
            return;
        };
        for from in at.clone().step_by(SPAN) {
            let (seen, count) = (part(&row.cells.inverse, from), (at.end - from).min(SPAN));
            let footprint = 1.0 / (seen[count / 2 % SPAN] * focal);
            if let Some(touch) = texture.even(footprint) {
                let gloss = gloss_of(roughness * touch.roughness, *metallic);
                row.even(from, (*group, three(|c| (colour[c] * touch.tint[c]).min(1.0)), gloss));
                continue;
            }
            let place = (from as u32 as f32 + 0.5, y as f32 + 0.5);
            let (span, lean) = texture.touch((seen, count), place, footprint);
            let (mut colours, mut gloss) = ([[0.0; SPAN]; 3], [0; SPAN]);
            for c in 0..3 {
                for i in 0..SPAN {
                    colours[c][i] = (colour[c] * span.tint[c][i]).min(1.0);
                }
            }
            for i in 0..SPAN {
                gloss[i] = gloss_of(roughness * span.roughness[i], *metallic);
            }
            *part_mut(&mut row.cells.group, from) = [*group; SPAN];
            *part_mut(&mut row.gloss, from) = gloss;
            *part_mut(&mut row.lean, from) = lean;
            (0..3).for_each(|c| *part_mut(&mut row.colour[c], from) = colours[c]);
        }
    }
}

impl Row {
    /// Writes a span of identical pixels.
    #[inline(always)]
    fn even(&mut self, from: usize, (group, colour, gloss): (u32, [f32; 3], u32)) {
        *part_mut(&mut self.cells.group, from) = [group; SPAN];
        *part_mut(&mut self.gloss, from) = [gloss; SPAN];
        *part_mut(&mut self.lean, from) = [0; SPAN];
        (0..3).for_each(|c| *part_mut(&mut self.colour[c], from) = [colour[c]; SPAN]);
    }
}

/// A span of a list.
#[inline(always)]
fn part<T>(list: &[T], from: usize) -> &[T; SPAN] {
    list[from..].first_chunk().expect("rows go on past their end")
}

/// A mutable span of a list.
#[inline(always)]
fn part_mut<T>(list: &mut [T], from: usize) -> &mut [T; SPAN] {
    list[from..].first_chunk_mut().expect("rows go on past their end")
}
