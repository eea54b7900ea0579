//! Attributes derived for a triangle when it is first seen.

use super::{BENT, Known, NONE, Paint, SurfaceGroup, UNMOVED, Writer};
use crate::labels::{Bent, bent};
use crate::math;
use crate::shading::texture::Texture;
use crate::surface::{Coat, Pattern, Role, Surface, Tile};

impl Paint {
    fn new(group: u32, (of, coat): (&Surface, &Coat), texture: Option<Texture>) -> Self {
        let (colour, roughness) = (coat.over(of.colour), coat.rough(of.roughness));
        Self { group, colour, roughness, metallic: of.metallic, texture }
    }
}

impl Writer<'_> {
    /// The paint of a triangle that is seen for the first time.
    #[inline(never)]
    pub(super) fn mixed(&self, triangle: u32, known: &mut Known) -> u32 {
        let visible = self.visible[triangle as usize];
        let instances = &self.view.snapshot.instances;
        let instance = &instances[visible.instance as usize];
        let mesh = visible.mesh(instances);
        let face = &mesh.faces[visible.index()];
        let surface = &self.store.surfaces[usize::from(face.surface)];
        let group = self.group(triangle, (face.surface, face.facet), known);
        let number = if face.is_flat() { group } else { group | BENT };
        if let Some(picture) = &surface.picture {
            let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index());
            let uvs = mesh.uvs.get(visible.index()).copied().unwrap_or_default();
            let back = known.maps(visible.instance, instances, &self.frustum)[1];
            let texture = Texture::picture(picture, (corners, uvs), (&back, &instance.world.narrow()));
            return known.paint(triangle, Paint::new(number, (surface, &instance.coat), Some(texture)));
        }
        let built = matches!(surface.role, Role::Built | Role::Floor);
        let plain = surface.pattern == Pattern::Plain;
        let ground = instance.ground.as_deref();
        let turned = || {
            let normal = math::normal(&instance.inverse, mesh.normals[visible.index()][0]);
            math::longest(ground.map_or(normal, |ground| math::vector(&ground.inverse, normal)))
        };
        let facing = if built { turned() } else { face.axis };
        let (u, v) = if plain { (0, 0) } else { crate::surface::texture_axes(surface.pattern, (facing, face.grain)) };
        let way = 3 * u + v;
        if known.groups[group as usize].paints[way] == NONE {
            let texture = (!plain).then(|| {
                let (back, axes) = match ground.filter(|_| built) {
                    Some(ground) => (math::composed(&ground.inverse, &self.world), ground.world.narrow()),
                    None if built => (self.world, UNMOVED),
                    None => (known.maps(visible.instance, instances, &self.frustum)[1], instance.world.narrow()),
                };
                Texture::tile(Tile::for_pattern(surface.pattern), (u, v), (&back, &axes))
            });
            known.groups[group as usize].paints[way] =
                known.paint(triangle, Paint::new(number, (surface, &instance.coat), texture));
        }
        let paint = known.groups[group as usize].paints[way];
        known.triangles[triangle as usize] = paint;
        paint
    }

    #[inline(never)]
    pub(super) fn bend(&self, triangle: u32, known: &mut Known) {
        let (visible, instances) = (self.visible[triangle as usize], &self.view.snapshot.instances);
        let map = || known.maps(visible.instance, instances, &self.frustum)[0];
        let found = bent(map, self.frustum.near, instances, visible);
        known.bent[triangle as usize] = known.bends.len() as u32;
        known.bends.push(match found {
            Ok(flat) => Bent::flat(flat),
            Err(bent) => bent,
        });
    }

    /// The group of an instance's surface, given one of its triangles.
    fn group(&self, triangle: u32, (surface, facet): (u16, u16), known: &mut Known) -> u32 {
        let (snapshot, seen) = (self.view.snapshot, &self.visible[triangle as usize]);
        let instance = seen.instance;
        let own = &snapshot.instances[instance as usize];
        let index = own.body;
        let body = &snapshot.bodies[index as usize];
        // A wall or a door has faces in several rooms, and the panel edges of a door face the same direction on
        // both sides.
        let room = self.lighting.room_seen(snapshot, seen, self.view.camera.eye().into());
        let mut at = known.heads[instance as usize];
        while let Some(group) = known.groups.get(at as usize)
            && (group.surface, group.facet, group.room) != (surface, facet, room)
        {
            at = group.next;
        }
        if at != NONE {
            return at;
        }
        let of = &self.store.surfaces[usize::from(surface)];
        let glow = if body.lit { self.lighting.shown(of, index, self.exposure) } else { [0.0; 3] };
        // A texture colours the light that falls on it, and likewise light that comes from behind.
        let (glow, shine) = match of.picture {
            Some(_) => ([0.0; 3], of.as_fallen(glow)),
            None => (glow, [0.0; 3]),
        };
        let shine = self.lighting.through(of, own).unwrap_or(shine);
        let next = known.heads[instance as usize];
        known.heads[instance as usize] = known.groups.len() as u32;
        let mirror = of.is_mirror();
        known.groups.push(SurfaceGroup { surface, facet, room, mirror, glow, shine, next, paints: [NONE; 9] });
        known.groups.len() as u32 - 1
    }
}
