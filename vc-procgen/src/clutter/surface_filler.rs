//! Placing objects on the surfaces of one carrier.

use std::sync::Arc;

use nalgebra::{Point3, Translation3, Vector3};
use vc_graph::asset::{Hold, Surface};
use vc_graph::portable::Portable;
use vc_graph::{Bounds, BoundsFrame, Pose, Property, Seed, State, Stream};
use vc_shapes::{Generator, Generators, Object};

use super::habits::studio_corner;
use super::surroundings::{Near, Surroundings};
use crate::apartment::Apartment;
use crate::area::Area;
use crate::draft::Draft;
use crate::item::{Item, Support, standing};
use crate::plan::{RoomKind, Scheme};

/// The gap between objects, and to a surface's edge, metres.
const GAP: f32 = 0.004;
/// The space that stays free below the ceiling, metres.
const HEADROOM: f32 = 0.05;
/// The number of positions sampled before an object is left out: of those kept there by habit, and of those that a line
/// of a table has there.
const HABIT: usize = 12;
const MEANT: usize = 40;
/// The height of what stands in an open holder, as a multiple of the holder's depth.
const OUT: f32 = 2.6;

/// The occupied areas of each surface of an item, in its frame.
pub(super) type Taken = Vec<Vec<Area>>;

/// Fills the surfaces of one item.
pub(super) struct SurfaceFiller<'a> {
    home: &'a mut Apartment,
    generators: &'a Generators,
    carrier: usize,
    pub(super) rng: Stream,
    seed: Seed,
    made: u64,
    taken: Taken,
    /// The number of positions sampled before an object is left out.
    tries: usize,
    /// The things around it, in a dressed home.
    around: Option<(&'a Surroundings, Near)>,
}

impl<'a> SurfaceFiller<'a> {
    /// A filler for one item; `standing` lists the furniture already on it, as pairs of surface and
    /// item.
    pub(super) fn new(
        home: &'a mut Apartment,
        generators: &'a Generators,
        carrier: usize,
        seed: Seed,
        standing: impl Iterator<Item = (usize, usize)>,
    ) -> Self {
        let own = home.items[carrier].pose.inverse();
        let mut taken = vec![Vec::new(); home.items[carrier].object.asset.surfaces.len()];
        for (surface, item) in standing {
            let item = &home.items[item];
            let bounds = item.object.bounds.aabb(&(own * item.pose));
            taken[surface].push(Area { x0: bounds.min.x, y0: bounds.min.y, x1: bounds.max.x, y1: bounds.max.y });
        }
        Self { tries: HABIT, ..Self::resume(home, generators, carrier, seed, taken) }
    }

    /// A filler for an item with areas that are taken.
    pub(super) fn resume(
        home: &'a mut Apartment,
        generators: &'a Generators,
        carrier: usize,
        seed: Seed,
        taken: Taken,
    ) -> Self {
        Self { home, generators, carrier, rng: seed.stream(), seed, made: 0, taken, tries: MEANT, around: None }
    }

    /// Keeps things clear of others around the item, and within reach.
    pub(super) fn among(mut self, surroundings: &'a mut Surroundings) -> Self {
        let near = surroundings.near(self.home, self.carrier);
        self.around = Some((surroundings, near));
        self
    }

    /// Whether a box in the carrier's frame is clear of the things around, and within reach.
    fn is_clear(&self, area: &Area, (low, high): (f32, f32)) -> bool {
        let Some((surroundings, near)) = &self.around else { return true };
        let carrier = &self.home.items[self.carrier];
        let (centre, size) = (area.centre(), area.size());
        let bounds = Bounds {
            offset: Vector3::new(centre.0, centre.1, f32::midpoint(low, high)),
            half: Vector3::new(size.0, size.1, high - low) / 2.0,
            frame: BoundsFrame::Object,
        };
        let place = bounds.aabb(&carrier.pose);
        near.is_clear(&self.home.items, &place) && surroundings.reaches(carrier.room, &place)
    }

    /// Tries fewer positions for what is kept here by habit.
    pub(super) fn by_habit(mut self) -> Self {
        self.tries = HABIT;
        self
    }

    /// The areas that are taken in the end.
    pub(super) fn into_taken(self) -> Taken {
        self.taken
    }

    pub(super) fn class(&self) -> &'static str {
        self.home.items[self.carrier].object.class
    }

    /// The class of the room whose habits apply here.
    pub(super) fn room_class(&self) -> &'static str {
        let kind = self.home.plan.rooms[self.home.items[self.carrier].room].kind;
        match (self.home.plan.scheme, kind) {
            (Scheme::Studio, RoomKind::Living) => studio_corner(self.class()),
            _ => kind.class(),
        }
    }

    pub(super) fn surfaces(&self) -> usize {
        self.taken.len()
    }

    pub(super) fn surface(&self, index: usize) -> Option<&Surface> {
        self.home.items[self.carrier].object.asset.surfaces.get(index)
    }

    /// The first surface that holds objects in this way.
    pub(super) fn first(&self, hold: Hold) -> Option<usize> {
        self.home.items[self.carrier].object.asset.surfaces.iter().position(|s| s.hold == hold)
    }

    /// The surfaces that hold objects in a way, in random order.
    pub(super) fn holding(&mut self, hold: Hold) -> Vec<usize> {
        let surfaces = self.home.items[self.carrier].object.asset.surfaces.iter().enumerate();
        let mut all: Vec<usize> = surfaces.filter(|(_, s)| s.hold == hold).map(|(i, _)| i).collect();
        self.rng.shuffle(&mut all);
        all
    }

    /// The surfaces whose names begin with a prefix.
    pub(super) fn named(&self, name: &str) -> Vec<usize> {
        let surfaces = self.home.items[self.carrier].object.asset.surfaces.iter().enumerate();
        surfaces.filter(|(_, s)| s.name.starts_with(name)).map(|(i, _)| i).collect()
    }

    /// Drafts an object of a class, of its usual size or of a given one.
    pub(super) fn make(&mut self, class: &str, size: Option<[f32; 3]>) -> Option<Draft> {
        self.made += 1;
        let (generator, seed) = (self.generators.get(class)?, self.seed.child("thing").nth(self.made));
        Some(match size {
            Some(size) => Draft::sized(generator, size.into(), seed),
            None => Draft::usual(generator, seed),
        })
    }

    /// Whether objects of a class permit actions of a kind.
    pub(super) fn affords(&self, class: &str, property: Property) -> bool {
        self.generators.get(class).is_some_and(|generator| generator.affords(property))
    }

    /// Puts an object of a class somewhere on a surface.
    pub(super) fn put(&mut self, class: &str, surface: usize) -> Option<usize> {
        let place = self.surface(surface)?;
        let (longest, shortest) = (2.0 * place.half.0.max(place.half.1), 2.0 * place.half.0.min(place.half.1));
        // An object that can never fit need not be drafted.
        let [depth, width, height] = self.generators.usual_ranges(class)?.map(|range| range.low);
        let (long, short) = (depth.max(width), depth.min(width));
        if long > longest || short > shortest || place.clearance.is_some_and(|c| height * 0.8 > c) {
            return None;
        }
        let object = self.make(class, None)?;
        self.put_object(&object, surface)
    }

    /// Puts a copy of an object that is already there.
    pub(super) fn put_beside(&mut self, like: usize, surface: usize) -> Option<usize> {
        let object = self.copy_of(like);
        self.put_object(&object, surface)
    }

    /// A copy of an object that is already there.
    pub(super) fn copy_of(&self, like: usize) -> Draft {
        Draft::from_object(self.home.items[like].object.clone())
    }

    /// Puts an object along the back edge of a surface, facing the carrier's front.
    pub(super) fn put_back(&mut self, object: &Draft, surface: usize) -> Option<usize> {
        let (centre, half) = self.surface(surface).map(|s| (s.centre, s.half))?;
        let (hx, hy) = (object.size().x / 2.0, object.size().y / 2.0);
        let room = half.1 - hy;
        if room < 0.0 {
            return None;
        }
        let x = centre.x - half.0 + hx + GAP + self.rng.between(0.0, 0.03).min((half.0 - hx).max(0.0));
        (0..self.tries).find_map(|_| {
            let y = centre.y + self.rng.between(-room, room);
            self.place(object, surface, (x, y), 0.0)
        })
    }

    /// Puts an object on the top before a chair, whose area is in the carrier's frame; its front points away from the
    /// chair.
    pub(super) fn put_before_seat(&mut self, object: &Draft, chair: &Area) -> Option<usize> {
        /// The distance of a plate from the table's edge, metres.
        const EDGE: f32 = 0.03;
        let surface = self.first(Hold::On)?;
        let (centre, half) = self.surface(surface).map(|s| (s.centre, s.half))?;
        let (x, y) = chair.centre();
        let (dx, dy) = (x - centre.x, y - centre.y);
        let reach = object.size().x / 2.0 + EDGE;
        let (quarter, turn) = (std::f32::consts::FRAC_PI_2, std::f32::consts::PI);
        let ((ax, ay), yaw) = match (dx.abs() - half.0 > dy.abs() - half.1, dx > 0.0, dy > 0.0) {
            (true, true, _) => ((half.0 - reach, dy), turn),
            (true, false, _) => ((reach - half.0, dy), 0.0),
            (false, _, true) => ((dx, half.1 - reach), -quarter),
            (false, _, false) => ((dx, reach - half.1), quarter),
        };
        self.place(object, surface, (centre.x + ax, centre.y + ay), yaw)
    }

    /// Puts an object at a sampled position on a surface, rotated so that it fits.
    pub(super) fn put_object(&mut self, object: &Draft, surface: usize) -> Option<usize> {
        let (centre, half, hold) = self.surface(surface).map(|s| (s.centre, s.half, s.hold))?;
        let aligned = hold == Hold::Inside;
        let fronts = aligned && self.generators.get(object.class()).is_some_and(has_front);
        for _ in 0..self.tries {
            let drawn = [0, 1, 2, 3][self.rng.below(4)];
            let quarter = if fronts { 0 } else { drawn };
            let jitter = if aligned || self.rng.chance(0.5) { 0.0 } else { self.rng.between(-0.25, 0.25) };
            let yaw = quarter as f32 * std::f32::consts::FRAC_PI_2 + jitter;
            let (hx, hy) = extent(object, yaw);
            let (rx, ry) = (half.0 - hx, half.1 - hy);
            if rx < 0.0 || ry < 0.0 {
                continue;
            }
            let (x, y) = (self.rng.between(-rx, rx), self.rng.between(-ry, ry));
            if let Some(index) = self.place(object, surface, (centre.x + x, centre.y + y), yaw) {
                return Some(index);
            }
        }
        None
    }

    /// Puts an object at a point of a surface (in the carrier's frame), if the point is free and the
    /// clearance above is high enough.
    pub(super) fn place(&mut self, object: &Draft, surface: usize, at: (f32, f32), yaw: f32) -> Option<usize> {
        let (centre, half, hold, clearance) = self.surface(surface).map(|s| (s.centre, s.half, s.hold, s.clearance))?;
        let (hx, hy) = extent(object, yaw);
        let area = Area::around(at.0, at.1, hx + GAP / 2.0, hy + GAP / 2.0);
        let edge = Area::around(centre.x, centre.y, half.0 + GAP, half.1 + GAP);
        let height = object.size().z;
        let base = self.home.items[self.carrier].pose.translation.z + centre.z;
        let reach = if self.is_open_above(surface) { OUT } else { 1.0 };
        let tall = clearance.is_some_and(|c| height > c * reach - GAP)
            || self.headroom().is_some_and(|above| centre.z + height > above - GAP)
            || base + height > self.home.plan.ceiling - HEADROOM;
        if tall || !edge.holds(&area) || self.taken[surface].iter().any(|t| t.overlaps(&area)) {
            return None;
        }
        if !self.is_clear(&area.grown(-GAP / 2.0), (centre.z, centre.z + height)) {
            return None;
        }
        self.taken[surface].push(area);
        let local = |object: &Object| standing(object, at, centre.z + 0.001, yaw);
        let support = if hold == Hold::Inside {
            Support::Inside(self.carrier, surface)
        } else {
            Support::On(self.carrier, surface)
        };
        Some(self.add(object, local, support))
    }

    /// The free height over the surface on which the carrier itself stands, for what a table puts into a holder.
    fn headroom(&self) -> Option<f32> {
        let (Support::On(at, surface) | Support::Inside(at, surface)) = self.home.items[self.carrier].support else {
            return None;
        };
        let clearance = self.home.items[at].object.asset.surfaces.get(surface)?.clearance;
        clearance.filter(|_| self.tries == MEANT)
    }

    /// Whether things that a table puts into a hollow may look out of it: into a holder or a basket without a lid.
    fn is_open_above(&self, surface: usize) -> bool {
        let object = &self.home.items[self.carrier].object;
        if self.tries != MEANT {
            return false;
        }
        let open = self.surface(surface).is_some_and(|s| {
            let top = s.centre.z + s.clearance.unwrap_or(0.0);
            let covers = |(low, high): (Point3<f32>, Point3<f32>)| {
                low.z > s.centre.z && (0..2).all(|k| low[k] < s.centre[k] && s.centre[k] < high[k])
            };
            s.hold == Hold::Inside
                && top > object.bounds.offset.z + object.bounds.half.z - 0.03
                && !object.asset.parts.iter().any(|part| covers(part.extent()))
        });
        open && object.asset.parts.iter().all(|part| part.joint.is_none())
    }

    /// Puts an object of which only the base needs the surface: the spout of a tap reaches over the
    /// bowl in front.
    pub(super) fn place_over(&mut self, object: &Draft, surface: usize, at: (f32, f32)) -> Option<usize> {
        let (centre, half) = self.surface(surface).map(|s| (s.centre, s.half))?;
        let size = object.size();
        let back = centre.x - half.0 + GAP;
        self.taken[surface].push(Area::around(centre.x, at.1, half.0, size.y / 2.0));
        let local = |object: &Object| standing(object, (back + size.x / 2.0, at.1), centre.z + 0.001, 0.0);
        Some(self.add(object, local, Support::On(self.carrier, surface)))
    }

    /// Hangs an object from a hook, its back off the wall; on a rod with its shoulders across it.
    pub(super) fn hang(&mut self, object: &Draft, surface: usize) -> Option<usize> {
        let rod = self.surface(surface).is_some_and(|s| s.name.starts_with("rod"));
        self.hang_turned(object, surface, rod)
    }

    /// Hangs an object from a hook: its back off the wall, or, if it hangs from a rod, turned across it.
    pub(super) fn hang_turned(&mut self, object: &Draft, surface: usize, rod: bool) -> Option<usize> {
        let (point, drop) = self.surface(surface).map(|s| (s.centre, s.clearance.unwrap_or(2.0)))?;
        let size = object.size();
        let carrier = self.home.items[self.carrier].object.bounds;
        let behind = carrier.offset.x - carrier.half.x;
        let off_wall = point.x.max(behind + size.x / 2.0 + 0.002);
        let (yaw, (x, y)) = match rod {
            // On a rod clothes hang side by side, their shoulders across it.
            true => (std::f32::consts::FRAC_PI_2, (point.x, point.y)),
            // Around a pole each hangs on its own side.
            false if self.tries == MEANT && self.class() == "coat_rack" => outward(object, (point.x, point.y)),
            false => (0.0, (off_wall, point.y)),
        };
        let half = if rod { (size.y / 2.0, size.x / 2.0) } else { extent(object, yaw) };
        let area = Area::around(x, y, half.0, half.1);
        let met = self.taken.iter().flatten().any(|t| t.overlaps(&area));
        let within = !rod || (half.0 + 0.03 < carrier.half.x && point.y.abs() + half.1 + 0.02 < carrier.half.y);
        if size.z > drop || met || !within || !self.is_clear(&area, (point.z - size.z, point.z)) {
            return None;
        }
        self.taken[surface].push(area);
        let local = |object: &Object| standing(object, (x, y), point.z - object.size().z, yaw);
        Some(self.add(object, local, Support::On(self.carrier, surface)))
    }

    /// Adds an item with a pose in the carrier's frame.
    fn add(&mut self, draft: &Draft, local: impl Fn(&Object) -> Pose, support: Support) -> usize {
        let object = draft.object(&self.home.style);
        let carrier = &self.home.items[self.carrier];
        let item = Item {
            pose: carrier.pose * local(&object),
            object,
            support,
            room: carrier.room,
            states: Vec::new(),
            between: None,
            required: false,
        };
        self.home.items.push(item);
        self.home.items.len() - 1
    }

    /// Puts an item in a state.
    pub(super) fn enter(&mut self, item: usize, state: State) {
        self.home.items[item].states.push(state);
    }

    /// An object tipped by quarter turns: generated for that purpose, without surfaces.
    pub(super) fn upright(&self, draft: Draft, turn: Pose) -> Draft {
        let mut object = draft.into_object(&self.home.style);
        let aabb = object.bounds.aabb(&turn);
        let centre = nalgebra::center(&aabb.min, &aabb.max);
        let pose = Translation3::new(-centre.x, -centre.y, -aabb.min.z) * turn;
        for part in object.asset.parts.iter_mut().chain(&mut object.asset.collision) {
            part.pose = pose * part.pose;
            if let Some(joint) = &mut part.joint {
                joint.anchor = pose * joint.anchor;
                joint.axis = pose.rotation * joint.axis;
            }
        }
        object.asset.surfaces.clear();
        object.bounds = vc_graph::Bounds::standing(aabb.max - aabb.min);
        Draft::from_object(Arc::new(object))
    }
}

/// The turn of an object on a hook at a point around a pole, and its centre: its back to the pole.
fn outward(object: &Draft, (x, y): (f32, f32)) -> (f32, (f32, f32)) {
    /// The distance of its back from the middle of the pole, metres.
    const POLE: f32 = 0.03;
    let out = x.hypotenuse(y).max(f32::MIN_POSITIVE);
    let away = out.max(POLE + object.size().x / 2.0) / out;
    (y.angle_to(x), (x * away, y * away))
}

/// The half extents along X and Y of an object rotated about Z.
fn extent(object: &Draft, yaw: f32) -> (f32, f32) {
    let (sin, cos) = (yaw.sine().abs(), yaw.cosine().abs());
    let half = object.size() / 2.0;
    (half.x * cos + half.y * sin, half.x * sin + half.y * cos)
}

/// Whether an object opens to its front and is used from there: a disc player in a stand faces out of
/// it, as its tray opens there.
fn has_front(generator: &Generator) -> bool {
    generator.affords(Property::Openable) && generator.affords(Property::Switchable)
}
