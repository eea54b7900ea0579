//! Checks whether an apartment is sound: every violation, with the items it concerns.

mod overlap;
mod references;
mod swing;

use crate::apartment::Apartment;
use crate::area::Area;
use crate::item::{Item, Support};
use crate::plan::{OpeningKind, RoomKind};
use crate::reach::Reach;
use crate::violation::{ApartmentViolation, ItemLabel};

use overlap::collisions;
pub(crate) use overlap::{carries, shares_space};

impl Apartment {
    /// Lists every violation; an apartment returned by [`Apartment::generate`] has none. If an edit has left a
    /// reference to a room, an item or a surface that there is not, only the broken references are listed: the other
    /// rules rely on them.
    ///
    /// Costs about a millisecond.
    ///
    /// ```
    /// use vc_graph::{Pose, Seed};
    /// use vc_procgen::Apartment;
    /// let mut home = Apartment::from_seed(Seed(7))?;
    /// assert!(home.check().is_empty());
    /// let fridge = home.items.iter().position(|item| item.object.class == "fridge").unwrap_or(0);
    /// home.items[fridge].pose = Pose::translation(0.0, 0.0, 50.0);
    /// assert!(!home.check().is_empty());
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn check(&self) -> Vec<ApartmentViolation> {
        let broken = self.broken_references();
        if broken.is_empty() { self.broken_rules() } else { broken }
    }

    fn broken_rules(&self) -> Vec<ApartmentViolation> {
        let mut found = Vec::new();
        let items = &self.items;
        let pairs = collisions(items);
        found.extend(pairs.into_iter().map(|(a, b)| ApartmentViolation::Overlap(self.named(a), self.named(b))));
        let nets: Vec<Vec<Area>> =
            self.plan.rooms.iter().map(|r| r.net().iter().map(Area::from_rect).collect()).collect();
        found.extend((0..items.len()).filter_map(|i| self.outside(i, &nets[items[i].room])));
        found.extend((0..items.len()).filter_map(|i| self.unsupported(i)));
        found.extend(self.blocked());
        let jams = swing::jams(items);
        found.extend(jams.into_iter().map(|(a, b)| ApartmentViolation::Jammed(self.named(a), self.named(b))));
        let reach = Reach::new(&self.plan, items);
        for (index, room) in self.plan.rooms.iter().enumerate() {
            if !reach.enters(&self.plan, index) {
                found.push(ApartmentViolation::UnreachableRoom(index, room.kind));
            }
            let missing = missing(room.kind, self.is_studio(), items.iter().filter(|i| i.room == index));
            found.extend(missing.into_iter().map(|what| ApartmentViolation::Incomplete(index, room.kind, what)));
        }
        let unreached =
            (0..items.len()).filter(|&i| is_used(&items[i]) && !reach.touches(items[i].room, &items[i].area()));
        found.extend(unreached.map(|i| ApartmentViolation::Unreachable(self.named(i))));
        found.extend(self.passages());
        found
    }

    fn named(&self, item: usize) -> ItemLabel {
        ItemLabel { item, node: self.item_id(item), class: self.items[item].object.class }
    }

    fn is_studio(&self) -> bool {
        !self.plan.rooms.iter().any(|r| r.kind.is_bedroom())
    }

    /// Whether an item reaches beyond its room's net area; parts of the building may.
    fn outside(&self, index: usize, net: &[Area]) -> Option<ApartmentViolation> {
        let item = &self.items[index];
        if item.support == Support::Built {
            return None;
        }
        let area = item.area();
        let (low, high) = item.corners();
        let slack = 1e-3;
        let corners = [(area.x0, area.y0), (area.x0, area.y1), (area.x1, area.y0), (area.x1, area.y1)];
        let holds = |n: &Area, x, y| x >= n.x0 - slack && x <= n.x1 + slack && y >= n.y0 - slack && y <= n.y1 + slack;
        let inside = |&(x, y): &(f32, f32)| net.iter().any(|n| holds(n, x, y));
        let upright = low.z > -slack && high.z < self.plan.ceiling + slack;
        (!corners.iter().all(inside) || !upright).then(|| ApartmentViolation::Outside(self.named(index), item.room))
    }

    /// Whether an item's base is off the surface it rests on.
    fn unsupported(&self, index: usize) -> Option<ApartmentViolation> {
        let item = &self.items[index];
        let base = item.corners().0.z;
        let off = match item.support {
            Support::Floor => base,
            Support::On(at, surface) | Support::Inside(at, surface) => {
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
        (off.abs() > 0.004).then(|| ApartmentViolation::Unsupported(self.named(index), off))
    }

    fn blocked(&self) -> Vec<ApartmentViolation> {
        let mut standing = Vec::new();
        for (index, item) in self.items.iter().enumerate().filter(|(_, i)| i.support != Support::Built) {
            let (low, high) = item.corners();
            if low.z < 2.0 && high.z > 0.03 {
                standing.push((index, item.room, item.area()));
            }
        }
        let mut found = Vec::new();
        for (door, opening) in self.plan.openings.iter().enumerate().filter(|(_, o)| o.is_way()) {
            let zones = opening.swing().into_iter().chain([opening.before(true, 5), opening.before(false, 5)]);
            let zones: Vec<_> = zones.map(|z| Area::from_rect(&z).grown(-0.03)).collect();
            let blocks = |(_, room, area): &&(usize, usize, Area)| {
                opening.touches(*room) && zones.iter().any(|z| z.overlaps(area))
            };
            let items = standing.iter().filter(blocks);
            found.extend(items.map(|&(index, ..)| ApartmentViolation::BlockedDoor(door, self.named(index))));
        }
        found
    }

    /// Rooms reached only through a bedroom or a bathroom, except for a bedroom's own bathroom, store or
    /// balcony.
    fn passages(&self) -> Vec<ApartmentViolation> {
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
        (0..rooms.len())
            .filter(|&i| !seen[i] && !bound(i))
            .map(|i| ApartmentViolation::Passage(i, rooms[i].kind))
            .collect()
    }
}

/// Whether an item has to be reachable: not the building, nor items on the ceiling.
pub(crate) fn is_used(item: &Item) -> bool {
    !matches!(item.support, Support::Built | Support::Ceiling) || item.object.role.is_opening()
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
            needs.push(("seat", &["sofa", "armchair", "loveseat", "sofa_bed", "recliner", "rocking_chair"]));
            needs.push(("table", &["coffee_table", "low_table", "dining_table", "kitchen_table", "side_table"]));
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
