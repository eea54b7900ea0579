//! All triangles of a snapshot in the world, for ray casting.

use std::sync::Arc;

use super::layer::{self, Found, Layer, Origin};
use crate::RenderError;
use crate::bvh::{Hit, Ray};
use crate::math::{self, Affine, three};
use crate::mesh::Face;
use crate::scene::{Instance, Snapshot};
use crate::surface::{Appearance, Pattern, Picture, Role, Surface, textured};

/// All triangles of a snapshot: clear ones and opaque ones in separate layers.
#[derive(Debug, Clone)]
pub(crate) struct Tracer {
    pub(crate) snapshot: Snapshot,
    solid: Layer,
    clear: Layer,
    /// For each instance, whether it has moved since the trees were built.
    moving: Vec<bool>,
    /// For each instance, its body and whether it is mirrored.
    owners: Vec<(u32, bool)>,
}

/// The minimal data of a hit.
pub(super) struct Touched {
    pub(super) t: f32,
    pub(super) flat: [f32; 3],
    pub(super) body: u32,
    pub(super) part: u16,
}

/// Outward unit normal of a hit triangle, and its area.
#[inline(always)]
fn flat(hit: &Hit, mirrored: bool) -> ([f32; 3], f32) {
    let [b, c] = hit.edges;
    let across = math::cross(b, c);
    let out = if mirrored { -1.0 } else { 1.0 };
    let area = 0.5 * (across[0] * across[0] + across[1] * across[1] + across[2] * across[2]).sqrt();
    (crate::math::unit(across.map(|v| v * out)), area)
}

/// For each instance, its body and whether it is mirrored.
fn owners(snapshot: &Snapshot) -> Vec<(u32, bool)> {
    snapshot.instances.iter().map(|i| (i.body, i.mirrored)).collect()
}

/// A hit of a ray, with its surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SurfaceHit<'a> {
    pub(crate) t: f32,
    pub(crate) at: [f32; 3],
    pub(crate) instance: &'a Instance,
    /// Index of that instance in the snapshot.
    pub(crate) index: u32,
    pub(crate) face: &'a Face,
    /// Index of the triangle in the mesh.
    triangle: u32,
    /// Barycentric weights of the triangle's second and third corner.
    weights: [f32; 2],
    /// Area of the triangle, square metres.
    pub(crate) area: f32,
    /// Outward unit normal of the triangle.
    pub(crate) flat: [f32; 3],
    /// Outward unit normal of the surface, interpolated.
    pub(crate) normal: [f32; 3],
}

impl Tracer {
    pub(crate) fn new(snapshot: &Snapshot) -> Self {
        let layer = |clear: bool| Layer::new(&snapshot.instances, clear);
        let (solid, clear) = rayon::join(|| layer(false), || layer(true));
        let moving = vec![false; snapshot.instances.len()];
        Self { snapshot: snapshot.clone(), solid, clear, moving, owners: owners(snapshot) }
    }

    /// Switches to another moment of the same scene. An instance that moves for the first time leaves the tree
    /// of standing triangles; after that it costs a fraction of a microsecond. Nothing is done where nothing has moved.
    pub(crate) fn follow(&mut self, snapshot: &Snapshot) -> Result<(), RenderError> {
        let (own, others) = (&self.snapshot.instances, &snapshot.instances);
        if own.len() != others.len() || own.iter().zip(others).any(|(a, b)| !Arc::ptr_eq(&a.link, &b.link)) {
            let (here, there) = (own.len(), others.len());
            return Err(RenderError::OtherScene { what: "snapshot to follow", here, there });
        }
        let fresh = |((a, b), moves): ((&Instance, &Instance), &bool)| !moves && a.world != b.world;
        let gone: Vec<bool> = own.iter().zip(others).zip(&self.moving).map(fresh).collect();
        let same = own.iter().zip(others).all(|(a, b)| a.world == b.world);
        let any = gone.contains(&true);
        for layer in [&mut self.solid, &mut self.clear] {
            if any {
                layer.loosen(&gone);
            }
        }
        self.moving.iter_mut().zip(gone).for_each(|(moves, gone)| *moves |= gone);
        self.snapshot = snapshot.clone();
        self.owners = owners(snapshot);
        // Several cameras see one moment.
        if !same {
            for layer in [&mut self.solid, &mut self.clear] {
                layer.arrange(&self.snapshot.instances, &self.moving);
            }
        }
        Ok(())
    }

    /// The first opaque hit of a ray.
    pub(crate) fn first(&self, ray: &Ray) -> Option<SurfaceHit<'_>> {
        layer::first([&self.solid], &self.snapshot.instances, ray).map(|found| self.met(ray, &found))
    }

    /// The first hit of a ray, opaque or clear.
    pub(crate) fn first_of_all(&self, ray: &Ray) -> Option<SurfaceHit<'_>> {
        self.nearest(ray).map(|found| self.met(ray, &found))
    }

    /// The first hit with its distance, normal (as in [`SurfaceHit::flat`]), body and part only: this takes about a
    /// sixth less time.
    #[inline]
    pub(super) fn touched(&self, ray: &Ray) -> Option<Touched> {
        let (hit, origin) = self.nearest(ray)?;
        let (body, mirrored) = self.owners[origin.instance as usize];
        Some(Touched { t: hit.t, flat: flat(&hit, mirrored).0, body, part: origin.part })
    }

    #[inline]
    fn nearest(&self, ray: &Ray) -> Option<Found> {
        layer::first([&self.solid, &self.clear], &self.snapshot.instances, ray)
    }

    /// The first clear hit of a ray.
    pub(crate) fn first_clear(&self, ray: &Ray) -> Option<SurfaceHit<'_>> {
        layer::first([&self.clear], &self.snapshot.instances, ray).map(|found| self.met(ray, &found))
    }

    /// Whether an opaque thing blocks the ray.
    pub(crate) fn blocked(&self, ray: &Ray) -> bool {
        layer::any(&self.solid, &self.snapshot.instances, ray)
    }

    fn met(&self, ray: &Ray, (hit, origin): &Found) -> SurfaceHit<'_> {
        let Origin { instance: index, triangle, .. } = *origin;
        let instance = &self.snapshot.instances[index as usize];
        let mesh = &*instance.link.levels[0];
        let face = &mesh.faces[triangle as usize];
        let (flat, area) = flat(hit, instance.mirrored);
        let [u, v] = hit.weights;
        let [n0, n1, n2] = mesh.normals[triangle as usize];
        let bent = three(|i| n0[i] * (1.0 - u - v) + n1[i] * u + n2[i] * v);
        let normal = if face.is_flat() { n0 } else { bent };
        let normal = math::normal(&instance.inverse, normal);
        // If the corner normals cancel out, the triangle's normal is used.
        let length = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        SurfaceHit {
            t: hit.t,
            at: three(|i| ray.from[i] + hit.t * ray.along[i]),
            instance,
            index,
            face,
            triangle,
            weights: hit.weights,
            area,
            flat,
            normal: if length > 1e-20 { crate::math::unit(normal) } else { flat },
        }
    }
}

impl SurfaceHit<'_> {
    /// The hit as seen on the side that faces a direction.
    pub(crate) fn facing(&self, towards: [f32; 3]) -> Self {
        if crate::math::dot(self.flat, towards) >= 0.0 {
            return *self;
        }
        Self { flat: self.flat.map(|v| -v), normal: self.normal.map(|v| -v), ..*self }
    }

    /// The hit triangle in the world.
    pub(crate) fn corners(&self) -> [[f32; 3]; 3] {
        let (world, mesh, at) = (self.instance.world.narrow(), &*self.instance.link.levels[0], self.triangle as usize);
        mesh.triangle(mesh.cluster_of(at), at).map(|p| math::point(&world, p))
    }

    /// The surface's texture at the hit.
    fn shown(&self, picture: &Picture, footprint: f32) -> [f32; 3] {
        let uvs = self.instance.link.levels[0].uvs.get(self.triangle as usize).copied().unwrap_or_default();
        let [a, b, c] = uvs;
        let [second, third] = self.weights;
        let place = [0, 1].map(|i: usize| a[i] + (b[i] - a[i]) * second + (c[i] - a[i]) * third);
        let density = picture.texels(uvs) / self.area.sqrt().max(1e-12);
        picture.at(picture.level(footprint * density), place)
    }

    /// Factor from an emissive texture for the surface's emission.
    pub(crate) fn shine(&self, surface: &Surface, footprint: f32) -> [f32; 3] {
        surface.picture.as_ref().filter(|_| surface.glows()).map_or([1.0; 3], |p| self.shown(p, footprint))
    }

    /// The surface at the hit with its texture and coat; `footprint` is the diameter to average over, metres.
    pub(crate) fn appearance(&self, surface: &Surface, footprint: f32) -> Appearance {
        let (coat, look) = (&self.instance.coat, self.bare(surface, footprint));
        Appearance { colour: coat.over(look.colour), roughness: coat.rough(look.roughness), ..look }
    }

    /// The surface without its coat.
    fn bare(&self, surface: &Surface, footprint: f32) -> Appearance {
        if let Some(picture) = &surface.picture {
            let shown = self.shown(picture, footprint);
            let colour = three(|i| surface.colour[i] * shown[i]);
            return Appearance { colour, roughness: surface.roughness, normal: self.normal };
        }
        if surface.pattern == Pattern::Plain {
            return Appearance { colour: surface.colour, roughness: surface.roughness, normal: self.normal };
        }
        let built = matches!(surface.role, Role::Built | Role::Floor);
        let (local, facing, axes) = match self.instance.ground.as_deref().filter(|_| built) {
            Some(ground) => {
                let facing = math::longest(math::vector(&ground.inverse, self.flat));
                (math::point(&ground.inverse, self.at), facing, ground.world.narrow())
            }
            None if built => (self.at, math::longest(self.flat), Affine::IDENTITY.narrow()),
            None => (math::point(&self.instance.inverse, self.at), self.face.axis, self.instance.world.narrow()),
        };
        textured(surface, (local, facing, self.face.grain), &axes, self.normal, footprint)
    }
}
