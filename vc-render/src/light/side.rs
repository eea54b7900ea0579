//! The room whose light falls on a surface.

use super::Lighting;
use crate::bvh::Ray;
use crate::math::{self, dot, three, unit};
use crate::rasterization::Visible;
use crate::scene::{Body, Instance, NO_ROOM, Snapshot, Stands};

/// Distance from the surface of a door or wall to a point that is in the room before it, metres.
const AHEAD: f32 = 0.3;
/// Cosine between the normal of a level face and the vertical, at least.
const LEVEL: f32 = 0.7;
/// Cosine between a face's normal and a door leaf's below which the face looks along the leaf.
const ALONG: f32 = 0.3;

impl Lighting {
    /// The room whose light falls on a visible triangle.
    pub(crate) fn room_seen(&self, snapshot: &Snapshot, seen: &Visible, eye: [f32; 3]) -> u16 {
        let instance = &snapshot.instances[seen.instance as usize];
        let body = &snapshot.bodies[instance.body as usize];
        if body.stands == Stands::Within {
            return body.room;
        }
        let (mesh, index) = (seen.mesh(&snapshot.instances), seen.index());
        let [a, b, c] = mesh.triangle(mesh.cluster_of(index), index);
        let at = math::point(&instance.world.narrow(), three(|i| (a[i] + b[i] + c[i]) / 3.0));
        let normal = unit(math::normal(&instance.inverse, mesh.normals[index][0]));
        match body.stands {
            // The eye sees only the near side of a body that reaches through a wall.
            Stands::Between => self.room_beside(instance, (at, eye), normal).unwrap_or(body.room),
            _ => self.room_of(body, instance, at, normal),
        }
    }

    /// The room whose light falls on a face of a body: the body's own, or, if the body stands between two rooms
    /// or bounds its room, the one that the face looks into.
    pub(crate) fn room_of(&self, body: &Body, instance: &Instance, at: [f32; 3], normal: [f32; 3]) -> u16 {
        match body.stands {
            Stands::Within => body.room,
            Stands::Around => self.room_before(body.room, at, normal),
            Stands::Outside => {
                self.room_around(three(|i| at[i] + AHEAD * normal[i])).map_or(NO_ROOM, |room| room as u16)
            }
            Stands::Between => self.room_beside(instance, (at, at), normal).unwrap_or(body.room),
        }
    }

    /// The room before a face of a door leaf or frame, wherever its joint has moved it. A face that looks along
    /// the leaf, such as one at the edge of a panel, belongs to the room on the side of the leaf where the
    /// point `from` lies.
    fn room_beside(&self, leaf: &Instance, (at, from): ([f32; 3], [f32; 3]), normal: [f32; 3]) -> Option<u16> {
        let world = leaf.world.narrow();
        let out = unit(math::vector(&world, [1.0, 0.0, 0.0]));
        let middle = math::point(&world, leaf.link.levels[0].bounds.centre);
        let side = dot(three(|i| from[i] - middle[i]), out).signum();
        let ahead = |along: [f32; 3]| three(|i| at[i] + AHEAD * along[i]);
        let room = |at: [f32; 3]| self.room_around(at).map(|room| room as u16);
        let aside = || room(ahead(out.map(|v| v * side)));
        if dot(normal, out).abs() < ALONG
            && let Some(room) = aside()
        {
            return Some(room);
        }
        let open = || self.is_open(at, normal).then_some(NO_ROOM);
        room(ahead(normal)).or_else(open).or_else(aside)
    }

    /// The room before a face of a room's wall: its own room, another, or none if the face looks out into the
    /// open.
    fn room_before(&self, own: u16, at: [f32; 3], normal: [f32; 3]) -> u16 {
        let ahead = three(|i| at[i] + AHEAD * normal[i]);
        if self.rooms.get(usize::from(own)).is_none_or(|(low, high)| holds(low, high, ahead)) {
            return own;
        }
        // Above its ceiling and below its floor is the outside, even if another home stands there.
        let room = self.rooms.get(usize::from(own)).filter(|_| self.tracer.snapshot.is_joined);
        if room.is_some_and(|(low, high)| is_beyond(low, high, ahead, normal)) {
            return NO_ROOM;
        }
        let open = || if self.is_open(at, normal) { NO_ROOM } else { own };
        self.room_around(ahead).map_or_else(open, |room| room as u16)
    }

    /// Whether there is open sky above a point before a face, beyond the wall that the face may be set in. Of homes above each
    /// other, also one that is seen past the storey above.
    fn is_open(&self, at: [f32; 3], normal: [f32; 3]) -> bool {
        let from = three(|i| at[i] + 2.0 * AHEAD * normal[i]);
        let sees_sky = |out: f32, up: f32| {
            let along = three(|i| out * normal[i] + if i == 2 { up } else { 0.0 });
            dot(along, along) > 0.1 && !self.tracer.blocked(&Ray { from, along: unit(along), end: 1e4 })
        };
        let aslant = || [(1.0, 1.0), (2.0, 1.0), (1.0, 0.0)].iter().any(|(out, up)| sees_sky(*out, *up));
        sees_sky(0.0, 1.0) || (self.tracer.snapshot.is_joined && aslant())
    }

    /// The room that contains a point.
    pub(super) fn room_around(&self, at: [f32; 3]) -> Option<usize> {
        let within = |room: &usize| {
            let (low, high) = &self.rooms[*room];
            holds(low, high, at)
        };
        // Boxes of rooms that are not convex reach over their neighbours, so the smallest box wins.
        let rooms = (0..self.rooms.len().saturating_sub(1)).filter(within);
        rooms.min_by(|a, b| self.floor(*a).total_cmp(&self.floor(*b)))
    }
}

/// Whether a point before a level face is above a box, or below it.
fn is_beyond(low: &[f32; 3], high: &[f32; 3], at: [f32; 3], normal: [f32; 3]) -> bool {
    (normal[2] > LEVEL && at[2] > high[2]) || (normal[2] < -LEVEL && at[2] < low[2])
}

/// Whether a box contains a point.
fn holds(low: &[f32; 3], high: &[f32; 3], at: [f32; 3]) -> bool {
    (0..3).all(|k| at[k] >= low[k] && at[k] <= high[k])
}
