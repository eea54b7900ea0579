//! The things around a piece of furniture, which what lies on it or hangs from it must keep clear of, and its reach.

use nalgebra::{Point3, Vector3};
use vc_graph::Aabb;

use crate::apartment::Apartment;
use crate::area::Area;
use crate::check::{carries, shares_space};
use crate::item::{Item, Support};
use crate::reach::Reach;

/// The depth by which boxes may overlap, metres.
const TOUCH: f32 = 0.002;
/// The reach of what hangs from a piece, metres.
const DROP: f32 = 1.2;

/// The boxes of the things of a home by room, and where people stand in it.
pub(super) struct Surroundings {
    reach: Reach,
    rooms: Vec<Vec<(usize, Aabb)>>,
    /// The number of things that are among them.
    seen: usize,
}

/// The things around one piece.
#[derive(Default)]
pub(super) struct Near(Vec<(usize, Aabb)>);

impl Surroundings {
    pub(super) fn new(home: &Apartment) -> Self {
        let reach = Reach::new(&home.plan, &home.items);
        Self { reach, rooms: vec![Vec::new(); home.plan.rooms.len()], seen: 0 }
    }

    /// The things over, under and in a piece that are not on or in it.
    pub(super) fn near(&mut self, home: &Apartment, carrier: usize) -> Near {
        let items = &home.items;
        for (index, item) in items.iter().enumerate().skip(self.seen).filter(|(_, i)| i.support != Support::Built) {
            self.rooms[item.room].push((index, item.object.bounds.aabb(&item.pose)));
        }
        self.seen = items.len();
        let Aabb { min, max } = items[carrier].object.bounds.aabb(&items[carrier].pose);
        let column = Aabb { min: min - Vector3::z() * DROP, max: Point3::new(max.x, max.y, home.plan.ceiling) };
        let apart =
            |other: usize| other != carrier && !carries(items, carrier, other) && !carries(items, other, carrier);
        let here = self.rooms[items[carrier].room].iter();
        Near(here.filter(|(index, other)| meet(&column, other) && apart(*index)).copied().collect())
    }

    /// Whether a person reaches a place in a room.
    pub(super) fn reaches(&self, room: usize, place: &Aabb) -> bool {
        let (low, high) = (place.min, place.max);
        self.reach.touches(room, &Area { x0: low.x, y0: low.y, x1: high.x, y1: high.y })
    }
}

impl Near {
    /// Whether nothing is in a box.
    pub(super) fn is_clear(&self, items: &[Item], place: &Aabb) -> bool {
        !self.0.iter().any(|(index, other)| meet(place, other) && shares_space(place, &items[*index]))
    }
}

fn meet(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|k| a.min[k] < b.max[k] - TOUCH && b.min[k] < a.max[k] - TOUCH)
}
