//! Checks whether an apartment is sound: every violation, with the items it concerns.

mod overlap;
mod swing;

use std::fmt;

use crate::apartment::Apartment;
use crate::furnish::{Area, Item, Rest};
use crate::plan::{OpeningKind, RoomKind};
use crate::reach::Reach;

use overlap::collisions;

/// A violation in an apartment. Items are given by their index in [`Apartment::items`], rooms by theirs in the
/// plan.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Violation {
    /// Two solids overlap.
    Overlap(Named, Named),
    /// An item is not within its room.
    Outside(Named, usize),
    /// An item floats above its support or penetrates it, by this distance in metres.
    Unsupported(Named, f32),
    /// A room is unreachable.
    UnreachableRoom(usize, RoomKind),
    /// An item is out of reach.
    Unreachable(Named),
    /// An item stands in the swing of a door's leaf or in front of an opening.
    BlockedDoor(usize, Named),
    /// A leaf, lid or drawer of the first item hits the second, which cannot be pushed aside, before it is half
    /// open.
    Jammed(Named, Named),
    /// A room lacks a required piece.
    Incomplete(usize, RoomKind, &'static str),
    /// A room is reached only through a bedroom or a bathroom.
    Passage(usize, RoomKind),
}

/// An item, by index and class.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Named {
    /// The index in [`Apartment::items`].
    pub item: usize,
    /// Its class.
    pub class: &'static str,
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.class, self.item)
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlap(a, b) => write!(f, "{a} and {b} share space"),
            Self::Outside(a, room) => write!(f, "{a} is not within room {room}"),
            Self::Unsupported(a, by) => write!(f, "{a} is {by:.3} m off what it rests on"),
            Self::UnreachableRoom(room, kind) => write!(f, "nobody gets into the {} (room {room})", kind.title()),
            Self::Unreachable(a) => write!(f, "nobody reaches {a}"),
            Self::BlockedDoor(door, a) => write!(f, "{a} is in the way of opening {door}"),
            Self::Jammed(a, b) => write!(f, "{a} does not open: {b} is in the way"),
            Self::Incomplete(room, kind, what) => write!(f, "the {} (room {room}) has no {what}", kind.title()),
            Self::Passage(room, kind) => {
                write!(f, "the {} (room {room}) is reached only through a private room", kind.title())
            }
        }
    }
}

impl Apartment {
    /// Lists every violation; an apartment returned by [`Apartment::generate`] has none.
    ///
    /// Costs about a millisecond.
    pub fn check(&self) -> Vec<Violation> {
        let mut found = Vec::new();
        let items = &self.items;
        let pairs = collisions(items);
        found.extend(pairs.into_iter().map(|(a, b)| Violation::Overlap(self.named(a), self.named(b))));
        let nets: Vec<Vec<Area>> = self.plan.rooms.iter().map(|r| r.net().iter().map(Area::of).collect()).collect();
        found.extend((0..items.len()).filter_map(|i| self.outside(i, &nets[items[i].room])));
        found.extend((0..items.len()).filter_map(|i| self.unsupported(i)));
        found.extend(self.blocked());
        let jams = swing::jams(items);
        found.extend(jams.into_iter().map(|(a, b)| Violation::Jammed(self.named(a), self.named(b))));
        let reach = Reach::of(&self.plan, items);
        for (index, room) in self.plan.rooms.iter().enumerate() {
            if !reach.enters(&self.plan, index) {
                found.push(Violation::UnreachableRoom(index, room.kind));
            }
            let missing = missing(room.kind, self.is_studio(), items.iter().filter(|i| i.room == index));
            found.extend(missing.into_iter().map(|what| Violation::Incomplete(index, room.kind, what)));
        }
        let unreached =
            (0..items.len()).filter(|&i| is_used(&items[i]) && !reach.touches(items[i].room, &items[i].area()));
        found.extend(unreached.map(|i| Violation::Unreachable(self.named(i))));
        found.extend(self.passages());
        found
    }

    fn named(&self, item: usize) -> Named {
        Named { item, class: self.items[item].object.class }
    }

    fn is_studio(&self) -> bool {
        !self.plan.rooms.iter().any(|r| r.kind.is_bedroom())
    }

    /// Whether an item reaches beyond its room's net area; parts of the building may.
    fn outside(&self, index: usize, net: &[Area]) -> Option<Violation> {
        let item = &self.items[index];
        if item.rest == Rest::Built {
            return None;
        }
        let area = item.area();
        let (low, high) = item.corners();
        let slack = 1e-3;
        let corners = [(area.x0, area.y0), (area.x0, area.y1), (area.x1, area.y0), (area.x1, area.y1)];
        let holds = |n: &Area, x, y| x >= n.x0 - slack && x <= n.x1 + slack && y >= n.y0 - slack && y <= n.y1 + slack;
        let inside = |&(x, y): &(f32, f32)| net.iter().any(|n| holds(n, x, y));
        let upright = low.z > -slack && high.z < self.plan.ceiling + slack;
        (!corners.iter().all(inside) || !upright).then(|| Violation::Outside(self.named(index), item.room))
    }

    /// Whether an item's base is off the surface it rests on.
    fn unsupported(&self, index: usize) -> Option<Violation> {
        let item = &self.items[index];
        let base = item.corners().0.z;
        let off = match item.rest {
            Rest::Floor => base,
            Rest::On(at, surface) | Rest::Inside(at, surface) => {
                let below = &self.items[at];
                let surface = below.object.asset.surfaces.get(surface)?;
                let carrier = below.pose * surface.centre;
                match surface.hold {
                    vc_graph::asset::Hold::Hook => item.corners().1.z - carrier.z,
                    _ => base - carrier.z,
                }
            }
            _ => 0.0,
        };
        (off.abs() > 0.004).then(|| Violation::Unsupported(self.named(index), off))
    }

    fn blocked(&self) -> Vec<Violation> {
        let mut standing = Vec::new();
        for (index, item) in self.items.iter().enumerate().filter(|(_, i)| i.rest != Rest::Built) {
            let (low, high) = item.corners();
            if low.z < 2.0 && high.z > 0.03 {
                standing.push((index, item.room, item.area()));
            }
        }
        let mut found = Vec::new();
        for (door, opening) in self.plan.openings.iter().enumerate().filter(|(_, o)| o.is_way()) {
            let zones = opening.swing().into_iter().chain([opening.before(true, 5), opening.before(false, 5)]);
            let zones: Vec<_> = zones.map(|z| Area::of(&z).grown(-0.03)).collect();
            let blocks = |(_, room, area): &&(usize, usize, Area)| {
                opening.touches(*room) && zones.iter().any(|z| z.overlaps(area))
            };
            let items = standing.iter().filter(blocks);
            found.extend(items.map(|&(index, ..)| Violation::BlockedDoor(door, self.named(index))));
        }
        found
    }

    /// Rooms reached only through a bedroom or a bathroom, except for a bedroom's own bathroom, store or
    /// balcony.
    fn passages(&self) -> Vec<Violation> {
        let rooms = &self.plan.rooms;
        let private =
            |i: usize| rooms[i].kind.is_bedroom() || matches!(rooms[i].kind, RoomKind::Bathroom | RoomKind::Wc);
        let ways: Vec<_> = self.plan.openings.iter().filter(|o| o.is_way()).collect();
        let mut seen = vec![false; rooms.len()];
        let entrance = ways.iter().find(|o| o.kind == OpeningKind::Entrance);
        let mut open: Vec<usize> = entrance.and_then(|o| o.low.or(o.high)).into_iter().collect();
        while let Some(room) = open.pop() {
            if std::mem::replace(&mut seen[room], true) || private(room) {
                continue;
            }
            open.extend(ways.iter().filter(|o| o.touches(room)).filter_map(|o| o.beyond(room)));
        }
        let bound = |i: usize| rooms[i].of.is_some() || rooms[i].kind == RoomKind::Balcony;
        (0..rooms.len()).filter(|&i| !seen[i] && !bound(i)).map(|i| Violation::Passage(i, rooms[i].kind)).collect()
    }
}

/// Whether an item has to be reachable: not the building, nor items on the ceiling.
pub(crate) fn is_used(item: &Item) -> bool {
    !matches!(item.rest, Rest::Built | Rest::Ceiling) || item.object.role().is_opening()
}

/// The required pieces that a room of a kind lacks.
pub(crate) fn missing<'a>(
    kind: RoomKind,
    studio: bool,
    items: impl Iterator<Item = &'a Item> + Clone,
) -> Vec<&'static str> {
    let has = |classes: &[&str]| items.clone().any(|i| classes.contains(&i.object.class));
    let mut needs: Vec<(&'static str, &[&str])> = Vec::new();
    let bed: (&'static str, &[&str]) = ("bed", &["double_bed", "single_bed", "kids_bed", "bed"]);
    let kitchen: [(&'static str, &[&str]); 4] = [
        ("sink", &["kitchen_sink"]),
        ("hob", &["stove", "hob"]),
        ("fridge", &["fridge"]),
        ("worktop", &["kitchen_cabinet", "kitchen_counter"]),
    ];
    match kind {
        RoomKind::Bedroom | RoomKind::Kids => needs.extend([bed, ("wardrobe", &["wardrobe"][..])]),
        RoomKind::Kitchen => needs.extend(kitchen),
        RoomKind::Bathroom => needs.extend([
            ("toilet", &["toilet"][..]),
            ("basin", &["washbasin"][..]),
            ("shower or bath", &["shower", "bathtub"][..]),
        ]),
        RoomKind::Wc => needs.extend([("toilet", &["toilet"][..]), ("basin", &["washbasin"][..])]),
        RoomKind::Living => {
            needs.push(("seat", &["sofa", "armchair", "loveseat"]));
            needs.push(("table", &["coffee_table", "dining_table", "side_table"]));
            if studio {
                needs.push(bed);
                needs.extend(kitchen);
            }
        }
        RoomKind::Study => needs.push(("desk", &["desk"])),
        RoomKind::Laundry => needs.push(("washing machine", &["washing_machine"])),
        _ => {}
    }
    needs.into_iter().filter(|(_, classes)| !has(classes)).map(|(what, _)| what).collect()
}
