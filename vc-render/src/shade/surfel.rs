//! What is seen at every pixel, before there is light.

use crate::affine::{self, Affine, Narrow};
use crate::frame::Strip;
use crate::label::bent;
use crate::raster::{Frustum, Layers, NONE, Visible, refill};
use crate::renderer::Renderer;
use crate::scene::Instance;
use crate::shade::look;
use crate::surface::{Pattern, Role, Surface};
use crate::view::View;

/// The surface at a pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Surfel {
    /// One over depth; zero where there is nothing.
    pub(crate) inverse: f32,
    normal: [i16; 3],
    colour: [u16; 3],
    roughness: u8,
    metallic: u8,
    pub(crate) surface: u16,
    pub(crate) body: u32,
}

/// Something clear in front of a pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pane {
    pub(crate) pixel: u32,
    pub(crate) surface: u16,
    pub(crate) body: u32,
    pub(crate) inverse: f32,
    pub(crate) normal: [f32; 3],
}

/// What shading a band needs.
#[derive(Default)]
pub(crate) struct Scratch {
    /// By instance, the position of its maps in the list below.
    known: Vec<u32>,
    /// From a mesh to the image, and from (x, y, 1) times depth to the mesh.
    maps: Vec<[Narrow; 2]>,
    pub(crate) panes: Vec<Pane>,
    pub(crate) mirrors: Vec<u32>,
}

impl Surfel {
    pub(crate) const NOTHING: Self =
        Self { inverse: 0.0, normal: [0; 3], colour: [0; 3], roughness: 0, metallic: 0, surface: 0, body: 0 };

    #[inline(always)]
    pub(crate) fn normal(&self) -> [f32; 3] {
        self.normal.map(|v| f32::from(v) * (1.0 / 32767.0))
    }

    #[inline(always)]
    pub(crate) fn colour(&self) -> [f32; 3] {
        self.colour.map(|v| f32::from(v) * (1.0 / 65535.0))
    }

    #[inline(always)]
    pub(crate) fn roughness(&self) -> f32 {
        f32::from(self.roughness) * (1.0 / 255.0)
    }

    #[inline(always)]
    pub(crate) fn metallic(&self) -> f32 {
        f32::from(self.metallic) * (1.0 / 255.0)
    }
}

#[inline(always)]
fn packed(look: &look::Look, inverse: f32, metallic: f32, surface: u16, body: u32) -> Surfel {
    Surfel {
        inverse,
        normal: look.normal.map(|v| (v * 32767.0) as i16),
        colour: look.colour.map(|v| (v.min(1.0) * 65535.0) as u16),
        roughness: (look.roughness * 255.0) as u8,
        metallic: (metallic * 255.0) as u8,
        surface,
        body,
    }
}

impl Scratch {
    /// An instance's maps to the image and back, made when they are first asked for.
    #[inline(always)]
    pub(super) fn maps(&mut self, index: u32, instances: &[Instance], frustum: &Frustum) -> &[Narrow; 2] {
        let known = &mut self.known[index as usize];
        if *known == NONE {
            *known = self.maps.len() as u32;
            let map = frustum.map.after(&instances[index as usize].world);
            self.maps.push([map.narrow(), map.inverse().unwrap_or(Affine::IDENTITY).narrow()]);
        }
        &self.maps[*known as usize]
    }
}

/// Writes down the surfaces of a band: the solid ones, and apart what is clear.
#[inline(always)]
pub(crate) fn surfels(
    renderer: &Renderer,
    view: View<'_>,
    layers: &Layers,
    scratch: &mut Scratch,
    strip: &mut Strip<'_>,
) {
    let frustum = Frustum::new(view.camera, &strip.rows);
    let world = frustum.map.inverse().unwrap_or(Affine::IDENTITY).narrow();
    refill(&mut scratch.known, NONE, view.snapshot.instances.len());
    scratch.maps.clear();
    scratch.panes.clear();
    scratch.mirrors.clear();
    let solid = if layers.clear { &layers.behind } else { &layers.front };
    for y in strip.rows.clone() {
        let row = strip.row(y);
        // Panes and mirrors are finished when the whole frame is there.
        let first = y as usize * strip.width;
        let out = &mut strip.surfels[row.clone()];
        let inverse = solid.inverse_row(y);
        let mut column = 0;
        for same in solid.triangle_row(y).chunk_by(|a, b| a == b) {
            let columns = column..column + same.len();
            column = columns.end;
            let Some(&visible) = layers.visible.get(same[0] as usize) else {
                out[columns].fill(Surfel::NOTHING);
                continue;
            };
            let place = Place { renderer, view, frustum: &frustum, world: &world, y, first: first as u32 };
            place.run(visible, scratch, &inverse[columns.clone()], (columns.start, &mut out[columns]));
        }
        if layers.clear {
            panes(view, &frustum, layers, (y, first), scratch);
        }
    }
}

/// A row of a band that is written down.
struct Place<'a> {
    renderer: &'a Renderer,
    view: View<'a>,
    frustum: &'a Frustum,
    world: &'a Narrow,
    y: i32,
    first: u32,
}

const UNMOVED: Narrow = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

impl Place<'_> {
    #[inline(always)]
    fn run(&self, visible: Visible, scratch: &mut Scratch, inverse: &[f32], (column, out): (usize, &mut [Surfel])) {
        let instances = &self.view.snapshot.instances;
        let instance = &instances[visible.instance as usize];
        let face = &visible.mesh(instances).faces[visible.index()];
        let surface: &Surface = &self.renderer.store.surfaces[usize::from(face.surface)];
        let bend =
            bent(|| scratch.maps(visible.instance, instances, self.frustum)[0], self.frustum.near, instances, visible);
        let (x, y) = (column as f32 + 0.5, self.y as f32 + 0.5);
        let normal = |i: usize| match &bend {
            Ok(flat) => *flat,
            Err(bend) => crate::label::unit(bend.at(x + i as f32, y)),
        };
        if surface.is_mirror() {
            let first = self.first + column as u32;
            scratch.mirrors.extend((0..out.len() as u32).map(|i| first + i));
        }
        if surface.pattern == Pattern::Plain {
            let same = packed(&plain(surface, normal(0)), 0.0, surface.metallic, face.surface, instance.body);
            for (i, (out, inverse)) in out.iter_mut().zip(inverse).enumerate() {
                *out = Surfel { inverse: *inverse, ..same };
                if bend.is_err() {
                    out.normal = normal(i).map(|v| (v * 32767.0) as i16);
                }
            }
            return;
        }
        let built = matches!(surface.role, Role::Built | Role::Floor);
        let (back, axes) = if built {
            (*self.world, UNMOVED)
        } else {
            (scratch.maps(visible.instance, instances, self.frustum)[1], instance.world.narrow())
        };
        for (i, (out, inverse)) in out.iter_mut().zip(inverse).enumerate() {
            let depth = 1.0 / inverse;
            let local = affine::point(&back, [(x + i as f32) * depth, y * depth, depth]);
            let n = normal(i);
            let facing = if built { n } else { face.normals[0] };
            let close = look::look(surface, (local, facing, face.grain), &axes, n, depth / self.frustum.focal);
            *out = packed(&close, *inverse, surface.metallic, face.surface, instance.body);
        }
    }
}

fn plain(surface: &Surface, normal: [f32; 3]) -> look::Look {
    look::Look { colour: surface.colour, roughness: surface.roughness, normal }
}

/// Notes what is clear in front of a row's pixels.
fn panes(view: View<'_>, frustum: &Frustum, layers: &Layers, (y, first): (i32, usize), scratch: &mut Scratch) {
    let instances = &view.snapshot.instances;
    let (front, behind) = (layers.front.triangle_row(y), layers.behind.triangle_row(y));
    let inverse = layers.front.inverse_row(y);
    for x in (0..front.len()).filter(|&x| front[x] != behind[x]) {
        let visible = layers.visible[front[x] as usize];
        let normal =
            match bent(|| scratch.maps(visible.instance, instances, frustum)[0], frustum.near, instances, visible) {
                Ok(flat) => flat,
                Err(bend) => crate::label::unit(bend.at(x as f32 + 0.5, y as f32 + 0.5)),
            };
        scratch.panes.push(Pane {
            pixel: (first + x) as u32,
            surface: visible.mesh(instances).faces[visible.index()].surface,
            body: instances[visible.instance as usize].body,
            inverse: inverse[x],
            normal,
        });
    }
}
