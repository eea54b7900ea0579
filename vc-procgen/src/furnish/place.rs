//! Finding a placement: against a wall, beside another piece, or free in the room.

use nalgebra::Vector3;
use vc_graph::Property;

use super::Furnisher;
use super::space::{OFF_WALL, Side, Solid};
use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::item::Support;

/// The number of spots tried for a piece, the best first.
const TRIED: usize = 8;

/// The free space that a piece needs around it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Need {
    /// The free depth in front, metres.
    pub(super) front: f32,
    /// The free width on its left.
    pub(super) left: f32,
    /// The free width on its right.
    pub(super) right: f32,
}

/// A placement against a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    pub(super) side: usize,
    pub(super) facing: Facing,
    pub(super) along: f32,
    pub(super) area: Area,
    /// The distance to the nearer end of the wall.
    pub(super) corner: f32,
    /// The lowest window sill behind it, if there is a window.
    pub(super) sill: Option<f32>,
}

impl Need {
    pub(super) fn front(front: f32) -> Self {
        Self { front, ..Self::default() }
    }

    /// The zones that must stay free around an area.
    pub(super) fn zones(self, area: &Area, facing: Facing) -> [Area; 2] {
        let wide = facing.widened(area, self.left, self.right);
        [facing.before(area, self.front), wide]
    }
}

impl Furnisher<'_> {
    /// The spots along all walls where an object can stand with its back to the wall.
    pub(super) fn spots(&self, object: &Draft, need: Need) -> Vec<Spot> {
        let size = object.size();
        let mut spots = Vec::new();
        for (index, side) in self.space.sides.iter().enumerate() {
            let room = side.length() - size.y;
            if room < 2.0 * OFF_WALL - 0.005 {
                continue;
            }
            let (first, last) = (side.from + size.y / 2.0 + OFF_WALL, side.to - size.y / 2.0 - OFF_WALL);
            let steps = ((last - first) / 0.2).ceil().max(0.0) as usize;
            let taken = self.space.taken(side, size, need.front);
            for step in 0..=steps {
                let along = if step == steps { last } else { first + 0.2 * step as f32 };
                let along = along.max(first);
                if taken.iter().all(|&(from, to)| along <= from || along >= to) {
                    spots.extend(self.spot(index, side, along, object, need));
                }
            }
        }
        spots
    }

    /// The spot at a position along a wall, if it is free.
    fn spot(&self, index: usize, side: &Side, along: f32, object: &Draft, need: Need) -> Option<Spot> {
        let size = object.size();
        let area = side.facing.area(side.point(along, OFF_WALL), size.x, size.y);
        let (from, to) = (along - size.y / 2.0, along + size.y / 2.0);
        let sill = side.sill(from, to);
        let tall = sill.is_some_and(|s| size.z > s - 0.02);
        if side.has_way(from, to) || tall || !self.fits(area, 0.0, size.z, side.facing, need) {
            return None;
        }
        let corner = (from - side.from).min(side.to - to);
        Some(Spot { side: index, facing: side.facing, along, area, corner, sill })
    }

    /// Whether an area is free for an object of the given height, including the zones it needs.
    pub(super) fn fits(&self, area: Area, low: f32, height: f32, facing: Facing, need: Need) -> bool {
        let solid = Solid { area, low, high: low + height };
        self.space.is_free(&solid) && need.zones(&area, facing).iter().all(|z| self.space.is_clear(z))
    }

    /// Places an object where `score` is highest; a small random term breaks ties.
    pub(super) fn against(&mut self, object: &Draft, need: Need, score: impl Fn(&Self, &Spot) -> f32) -> Option<usize> {
        let spots = self.spots(object, need);
        let mut rated: Vec<(f32, Spot)> =
            spots.into_iter().map(|spot| (score(self, &spot) + self.rng.between(0.0, 0.35), spot)).collect();
        rated.sort_by(|a, b| b.0.total_cmp(&a.0));
        let high = object.size().z;
        let open = |spot: &Spot| self.space.stays_open(&Solid { area: spot.area, low: 0.0, high });
        let spot = rated.into_iter().map(|(_, spot)| spot).take(TRIED).find(open)?;
        Some(self.settle(object, spot.area, spot.facing, need))
    }

    /// Places the first of several sizes of a class that fits.
    pub(super) fn first_against(
        &mut self,
        class: &str,
        sizes: &[[f32; 3]],
        need: Need,
        score: impl Fn(&Self, &Spot) -> f32,
    ) -> Option<usize> {
        sizes.iter().find_map(|size| {
            let object = self.make(class, *size)?;
            self.against(&object, need, &score)
        })
    }

    /// Places an object on an area of the floor and reserves its zones.
    pub(super) fn settle(&mut self, object: &Draft, area: Area, facing: Facing, need: Need) -> usize {
        let zones = need.zones(&area, facing);
        self.space.zones.extend(zones.into_iter().filter(|z| *z != area && z.square_metres() > 1e-4).take(2));
        self.add(object, area.centre(), 0.0, facing, Support::Floor)
    }

    /// Places an object on the floor at a point, if it is free there.
    pub(super) fn at(&mut self, object: &Draft, centre: (f32, f32), facing: Facing, need: Need) -> Option<usize> {
        let size = object.size();
        let area = Self::around(centre, size, facing);
        let open = self.space.stays_open(&Solid { area, low: 0.0, high: size.z });
        (open && self.fits(area, 0.0, size.z, facing, need)).then(|| self.settle(object, area, facing, need))
    }

    /// The area of an object of a size that faces a direction, centred on a point.
    pub(super) fn around(centre: (f32, f32), size: Vector3<f32>, facing: Facing) -> Area {
        let (hx, hy) = if facing.is_along_x() { (size.x, size.y) } else { (size.y, size.x) };
        Area::around(centre.0, centre.1, hx / 2.0, hy / 2.0)
    }

    /// Hangs an object on a wall, its lower edge at `z`, if the place is free.
    pub(super) fn hang(&mut self, object: &Draft, side: usize, along: f32, z: f32) -> Option<usize> {
        /// Objects no deeper than this hang over floor that must stay free, metres.
        const SHALLOW: f32 = 0.06;
        self.hang_within(object, side, (along, z), (SHALLOW, None))
    }

    /// As [`hang`](Self::hang), with the depth up to which an object may hang over floor that must stay free; also in the
    /// box of a piece that has space in it, such as a shower.
    pub(super) fn hang_within(
        &mut self,
        object: &Draft,
        side: usize,
        (along, z): (f32, f32),
        (shallow, open): (f32, Option<Area>),
    ) -> Option<usize> {
        let wall = &self.space.sides[side];
        let size = object.size();
        let (from, to) = (along - size.y / 2.0, along + size.y / 2.0);
        let blocked = wall.windows.iter().any(|w| w.0 < to + 0.05 && w.1 > from - 0.05 && w.2 < z + size.z)
            || wall.ways.iter().any(|w| w.0 - 0.08 < to && w.1 + 0.08 > from && z < 2.2);
        if blocked || from < wall.from + 0.01 || to > wall.to - 0.01 || z + size.z > self.space.ceiling - 0.02 {
            return None;
        }
        let facing = wall.facing;
        // A millimetre off the wall, so that faces do not coincide.
        let area = facing.area(wall.point(along, 0.001), size.x, size.y);
        let solid = Solid { area, low: z, high: z + size.z };
        // It must not be in the way of heads or doors.
        let kept = |zone: &&Area| size.x > shallow || self.opens_over(zone, z);
        let mut zones = self.space.ways.iter().chain(self.space.zones.iter().filter(kept));
        let low = z < 1.9 && size.x > 0.05 && zones.any(|q| q.overlaps(&area));
        let pane = self.space.panes.iter().any(|p| p.hits(&solid));
        let is_open = |s: &Solid| open.is_some_and(|open| open == s.area && open.grown(OFF_WALL).holds(&area));
        let empty = !low && !pane && self.space.is_floor(&solid.area);
        let empty = empty && !self.space.solids.iter().any(|s| s.hits(&solid) && !is_open(s));
        if !empty || !self.space.stays_open(&solid) {
            return None;
        }
        Some(self.add(object, area.centre(), z, facing, Support::Wall))
    }

    /// Whether a cupboard that reaches higher than `z` opens into a zone.
    fn opens_over(&self, zone: &Area, z: f32) -> bool {
        let opens = |class| {
            self.generators.get(class).is_some_and(|generator| {
                let [lid, holds, seat] = [Property::Openable, Property::Container, Property::Sittable];
                // A toilet's lid opens over itself.
                generator.affords(lid) && generator.affords(holds) && !generator.affords(seat)
            })
        };
        self.items
            .iter()
            .any(|item| item.corners().1.z > z && zone.distance(&item.area()) < 0.01 && opens(item.object.class))
    }
}
