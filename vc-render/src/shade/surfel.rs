//! What is seen at every pixel, before there is light.

use super::edge::{Lines, lines};
use super::planes::{Planes, gloss_of};
use super::texture::Texture;
use crate::affine::{self, Affine, Narrow};
use crate::label::{Bent, bent, unit};
use crate::light::Lighting;
use crate::raster::{Frustum, Layers, NONE, Solid, Visible, refill};
use crate::renderer::Renderer;
use crate::scene::{Instance, NO_ROOM};
use crate::simd::stretches;
use crate::surface::{Pattern, Role, SPAN, Span, Surface, Tile};
use crate::view::View;

/// What all pixels of an instance's surface have in common.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Look {
    pub(super) surface: u16,
    pub(super) room: u16,
    pub(super) mirror: bool,
    /// Light it gives.
    pub(super) glow: [f32; 3],
    /// The next look of the same instance.
    next: u32,
    /// By how its texture lies, its paint.
    paints: [u32; 9],
}

/// Look and paint of pixels where nothing is seen.
pub(super) const NOTHING: u32 = 0;

/// What pixels are coloured with.
#[derive(Debug, Clone)]
struct Paint {
    look: u32,
    colour: [f32; 3],
    roughness: f32,
    metallic: f32,
    texture: Option<Texture>,
}

/// What is known of instances and triangles of a band.
#[derive(Default)]
pub(crate) struct Known {
    /// By instance, the position of its maps in the list below.
    maps: Vec<u32>,
    /// From a mesh to the image, and from (x, y, 1) times depth to the mesh.
    pairs: Vec<[Narrow; 2]>,
    /// By visible triangle, the position of its paint in the list below.
    triangles: Vec<u32>,
    paints: Vec<Paint>,
    /// By visible triangle, the position of its normals in the list below.
    bent: Vec<u32>,
    bends: Vec<Result<[f32; 3], Bent>>,
    /// By visible triangle, the position of its edges in the list below.
    edged: Vec<u32>,
    lines: Vec<Lines>,
    /// By instance, the first of its looks.
    heads: Vec<u32>,
    pub(super) looks: Vec<Look>,
    span: Span,
}

/// A view whose surfaces are written down.
pub(super) struct Writer<'a> {
    pub(super) renderer: &'a Renderer,
    pub(super) lighting: &'a Lighting,
    pub(super) view: View<'a>,
    pub(super) visible: &'a [Visible],
    pub(super) frustum: Frustum,
    /// From (x, y, 1) times depth to the world.
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
        self.looks.clear();
        self.paints.clear();
        let look = Look { surface: 0, room: NO_ROOM, mirror: false, glow: [0.0; 3], next: NONE, paints: [NONE; 9] };
        self.looks.push(look);
        let colour = [0.0; 3];
        self.paints.push(Paint { look: NOTHING, colour, roughness: 1.0, metallic: 0.0, texture: None });
    }

    /// An instance's maps to the image and back, made when they are first asked for.
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
        let corners = mesh.triangle(mesh.cluster_of(index), index).map(|p| affine::point(&map, p));
        self.edged[triangle as usize] = self.lines.len() as u32;
        self.lines.push(lines(corners));
    }
}

impl Paint {
    fn new(look: u32, of: &Surface, texture: Option<Texture>) -> Self {
        Self { look, colour: of.colour, roughness: of.roughness, metallic: of.metallic, texture }
    }
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        renderer: &'a Renderer,
        lighting: &'a Lighting,
        view: View<'a>,
        layers: &'a Layers,
        rows: &std::ops::Range<i32>,
    ) -> Self {
        let frustum = Frustum::new(view.camera, rows);
        let world = frustum.map.inverse().unwrap_or(Affine::IDENTITY).narrow();
        Self { renderer, lighting, view, visible: &layers.visible, frustum, world }
    }

    /// Writes down a row of the image, from a place in the planes on.
    #[inline(always)]
    pub(super) fn row(&self, solid: Solid<'_>, y: i32, known: &mut Known, (planes, first): (&mut Planes, usize)) {
        let (inverse, triangles) = (solid.inverse_row(y), solid.triangle_row(y));
        planes.inverse[first..first + inverse.len()].copy_from_slice(inverse);
        let (mut start, mut paint) = (0, NOTHING);
        stretches(
            triangles,
            #[inline(always)]
            |triangle, from, _| {
                let next = self.paint(triangle, known);
                if next != paint && from > 0 {
                    known.write(paint, (planes, first), start..from, (y, self.frustum.focal));
                    start = from;
                }
                paint = next;
            },
        );
        known.write(paint, (planes, first), start..triangles.len(), (y, self.frustum.focal));
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

    /// The paint of a triangle that is seen for the first time.
    #[inline(never)]
    fn mixed(&self, triangle: u32, known: &mut Known) -> u32 {
        let visible = self.visible[triangle as usize];
        let instances = &self.view.snapshot.instances;
        let instance = &instances[visible.instance as usize];
        let face = &visible.mesh(instances).faces[visible.index()];
        let surface = &self.renderer.store.surfaces[usize::from(face.surface)];
        let look = self.look(visible.instance, face.surface, known);
        if let Some(picture) = &surface.picture {
            let mesh = visible.mesh(instances);
            let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index());
            let uvs = mesh.uvs.get(visible.index()).copied().unwrap_or_default();
            let back = known.maps(visible.instance, instances, &self.frustum)[1];
            let texture = Texture::picture(picture, (corners, uvs), (&back, &instance.world.narrow()));
            return known.paint(triangle, Paint::new(look, surface, Some(texture)));
        }
        let built = matches!(surface.role, Role::Built | Role::Floor);
        let plain = surface.pattern == Pattern::Plain;
        let facing = if built { affine::normal(&instance.inverse, face.normals[0]) } else { face.normals[0] };
        let (u, v) = if plain { (0, 0) } else { super::look::plane(facing, face.grain) };
        let way = 3 * u + v;
        if known.looks[look as usize].paints[way] == NONE {
            let texture = (!plain).then(|| {
                let (back, axes) = if built {
                    (self.world, UNMOVED)
                } else {
                    (known.maps(visible.instance, instances, &self.frustum)[1], instance.world.narrow())
                };
                Texture::tile(Tile::of(surface.pattern), (u, v), (&back, &axes))
            });
            known.looks[look as usize].paints[way] = known.paint(triangle, Paint::new(look, surface, texture));
        }
        let paint = known.looks[look as usize].paints[way];
        known.triangles[triangle as usize] = paint;
        paint
    }

    /// The normal at a place in the image, of the triangle that is seen there.
    #[inline(always)]
    pub(super) fn normal(&self, triangle: u32, (x, y): (f32, f32), known: &mut Known) -> [f32; 3] {
        if triangle == NONE {
            return [0.0, 0.0, 1.0];
        }
        if known.bent[triangle as usize] == NONE {
            self.bend(triangle, known);
        }
        match &known.bends[known.bent[triangle as usize] as usize] {
            Ok(flat) => *flat,
            Err(bend) => unit(bend.at(x, y)),
        }
    }

    #[inline(never)]
    fn bend(&self, triangle: u32, known: &mut Known) {
        let (visible, instances) = (self.visible[triangle as usize], &self.view.snapshot.instances);
        let map = || known.maps(visible.instance, instances, &self.frustum)[0];
        let found = bent(map, self.frustum.near, instances, visible);
        known.bent[triangle as usize] = known.bends.len() as u32;
        known.bends.push(found);
    }

    /// Whether two triangles of one look meet without a crease.
    #[inline(always)]
    pub(super) fn smooth(&self, triangles: [u32; 2]) -> bool {
        if triangles.contains(&NONE) {
            return true;
        }
        let instances = &self.view.snapshot.instances;
        let normal = |triangle: u32| {
            let visible = self.visible[triangle as usize];
            &visible.mesh(instances).faces[visible.index()].normals[0]
        };
        let (a, b) = (normal(triangles[0]), normal(triangles[1]));
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0.8
    }

    /// The number of what pixels of an instance's surface have in common.
    fn look(&self, instance: u32, surface: u16, known: &mut Known) -> u32 {
        let mut at = known.heads[instance as usize];
        while at != NONE && known.looks[at as usize].surface != surface {
            at = known.looks[at as usize].next;
        }
        if at != NONE {
            return at;
        }
        let index = self.view.snapshot.instances[instance as usize].body;
        let body = &self.view.snapshot.bodies[index as usize];
        let of = &self.renderer.store.surfaces[usize::from(surface)];
        let glow = if body.lit { self.lighting.glow(of, index) } else { [0.0; 3] };
        let next = known.heads[instance as usize];
        known.heads[instance as usize] = known.looks.len() as u32;
        let (room, mirror) = (body.room, of.is_mirror());
        known.looks.push(Look { surface, room, mirror, glow, next, paints: [NONE; 9] });
        known.looks.len() as u32 - 1
    }
}

impl Known {
    /// Keeps the paint of a triangle, and returns its number.
    fn paint(&mut self, triangle: u32, paint: Paint) -> u32 {
        self.paints.push(paint);
        self.triangles[triangle as usize] = self.paints.len() as u32 - 1;
        self.paints.len() as u32 - 1
    }

    /// Writes pixels of a row of the image that have one paint.
    #[inline(always)]
    fn write(
        &mut self,
        paint: u32,
        (planes, first): (&mut Planes, usize),
        columns: std::ops::Range<usize>,
        (y, focal): (i32, f32),
    ) {
        let Self { paints, span, .. } = self;
        let paint = &paints[paint as usize];
        let at = first + columns.start..first + columns.end;
        let (x, y) = (columns.start as f32 + 0.5, y as f32 + 0.5);
        let [red, green, blue] = &mut planes.colour;
        let (red, green, blue) = (&mut red[at.clone()], &mut green[at.clone()], &mut blue[at.clone()]);
        planes.look[at.clone()].fill(paint.look);
        let (gloss, lean) = (&mut planes.gloss[at.clone()], &mut planes.lean[at.clone()]);
        let Some(texture) = &paint.texture else {
            gloss.fill(gloss_of(paint.roughness, paint.metallic));
            lean.fill(0);
            for (out, colour) in [red, green, blue].into_iter().zip(paint.colour) {
                out.fill(colour);
            }
            return;
        };
        let inverse = &planes.inverse[at.clone()];
        for from in (0..at.len()).step_by(SPAN) {
            let part = from..(from + SPAN).min(at.len());
            span.count = part.len();
            let level = texture.touch(span, &inverse[part.clone()], (x + from as f32, y), focal);
            for ((out, tint), colour) in [&mut *red, green, blue].into_iter().zip(&span.tint).zip(paint.colour) {
                for (out, tint) in out[part.clone()].iter_mut().zip(tint) {
                    *out = (colour * tint).min(1.0);
                }
            }
            for (out, roughness) in gloss[part.clone()].iter_mut().zip(&span.roughness) {
                *out = gloss_of(paint.roughness * roughness, paint.metallic);
            }
            texture.lean(level, span, &mut lean[part]);
        }
    }
}
