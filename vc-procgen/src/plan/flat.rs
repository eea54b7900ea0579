//! Plans of flats on sites: rooms side by side along the main facade, the kitchen, wet rooms and the entrance along the corridor,
//! and between both a strip that belongs to the hall.
//!
//! The living room lies at one end and reaches through the strip to the kitchen. Walls between rooms of the facade lie between
//! places of windows, and a site is filled to its borders. A candidate costs a few microseconds, so some hundreds are drawn and
//! the best of the first sound ones is taken.

use vc_graph::portable::Portable;
use vc_graph::{Seed, Stream};

use super::site::{Side, Site};
use super::{FloorPlan, Rect, Room, RoomKind, Scheme, openings};
use crate::error::SpecificationError;

/// Candidates that are drawn for a site, and sound ones among which the best is taken. Few sites need more than some hundred.
const CANDIDATES: u64 = 8000;
const ENOUGH: usize = 8;
/// Candidates after which a flat has a bedroom fewer, and how many fewer at most.
const PATIENCE: u64 = 200;
const FEWER: u64 = 4;
/// The least length of wall for a door with its frame, cells.
const DOOR: i32 = 24;
/// A wall keeps so far from a place of a window, cells.
const BESIDE: i32 = 4;
/// A site that is no deeper has no strip between its bands, cells.
const SHALLOW: i32 = 148;
/// The least and the greatest depth of the rooms at the facade, and of the band along the corridor, cells.
const FRONT: (i32, i32) = (66, 126);
const BACK: (i32, i32) = (38, 98);
/// The area that flats have by their number of bedrooms, square metres.
const AREAS: [f32; 5] = [28.0, 56.0, 82.0, 110.0, 140.0];
/// The least width of a living room and of a bedroom at the facade, cells.
const LIVING: i32 = 62;
const BEDROOM: i32 = 54;
/// The least area of a room in which one lives, cooks and sleeps, square metres.
const ONE_ROOM: f32 = 19.0;
/// A rest that is narrower goes to a neighbour, cells.
const NICHE: i32 = 26;

/// The least, usual and greatest area of a room, square metres.
fn areas(kind: RoomKind) -> [f32; 3] {
    match kind {
        RoomKind::Living => [13.0, 23.0, 60.0],
        RoomKind::Kitchen => [5.4, 9.0, 17.0],
        RoomKind::Bedroom => [9.5, 14.5, 27.0],
        RoomKind::Kids => [8.5, 12.5, 23.0],
        RoomKind::Bathroom => [3.2, 5.0, 10.0],
        RoomKind::Wc => [1.5, 1.9, 4.2],
        RoomKind::Laundry => [2.6, 4.0, 9.0],
        RoomKind::Storage => [1.8, 3.0, 9.5],
        RoomKind::Hall => [2.2, 6.5, 22.0],
        RoomKind::Study | RoomKind::Balcony => [6.0, 9.0, 15.0],
    }
}

impl FloorPlan {
    /// The plan of a flat on a site, filled to its borders. All windows are at places of the site; a seed always has the same plan.
    ///
    /// Costs some hundred microseconds.
    ///
    /// # Errors
    /// [`SpecificationError::OutOfRange`] for measures that no flat can have; [`SpecificationError::NoPlan`] where none is found: the
    /// facade has too few places for windows, or no hall can be where the door is.
    pub fn on(site: &Site, seed: Seed) -> Result<Self, SpecificationError> {
        site.check()?;
        let (seed, mirrored) = (seed.child("flat"), site.mirrored());
        let attempt = |candidate| {
            let mut rng = seed.nth(candidate).stream();
            // Where no flat of the usual number of bedrooms is found, one of fewer is.
            let fewer = (candidate / PATIENCE % FEWER) as usize;
            if rng.chance(0.5) {
                return Draft::attempt(site, fewer, &mut rng);
            }
            Draft::attempt(&mirrored, fewer, &mut rng).map(|(cost, plan)| (cost, plan.turned(1)))
        };
        let sound = (0..CANDIDATES).filter_map(attempt).take(ENOUGH);
        let best = sound.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, plan)| plan);
        best.ok_or(SpecificationError::NoPlan { rooms: 1, area: site.rect().area() })
    }
}

/// A plan in the making, its living room in the west.
struct Draft<'a> {
    site: &'a Site,
    /// Where the strip between the bands begins and ends, from the facade.
    strip: (i32, i32),
    rooms: Vec<Room>,
}

impl<'a> Draft<'a> {
    /// A candidate, with how far its rooms are from usual sizes.
    fn attempt(site: &'a Site, fewer: usize, rng: &mut Stream) -> Option<(f32, FloorPlan)> {
        let bedrooms = bedrooms(site, rng).saturating_sub(fewer);
        let mut draft = Self { site, strip: bands(site.depth, bedrooms, rng)?, rooms: Vec::new() };
        draft.add(RoomKind::Living, &[]);
        if bedrooms == 0 {
            draft.studio(rng)?;
        } else {
            draft.rooms_of(bedrooms, rng)?;
        }
        let cost = draft.cost()?;
        let rooms = draft.rooms;
        let scheme = if bedrooms == 0 { Scheme::Studio } else { Scheme::Bar };
        let facades = [Side::West, Side::East, Side::South, Side::North].map(|side| site.is_open(side));
        let mut plan =
            FloorPlan { scheme, rooms, openings: Vec::new(), facades, shell: site.shell, ceiling: site.ceiling };
        openings::open_on(&mut plan, site, rng)?;
        Some((cost, plan))
    }

    /// Adds a room, and returns its index.
    fn add(&mut self, kind: RoomKind, rects: &[Rect]) -> usize {
        self.rooms.push(Room { kind, rects: rects.to_vec(), of: None });
        self.rooms.len() - 1
    }

    fn enlarge(&mut self, room: usize, rect: Rect) {
        self.rooms[room].rects.push(rect);
    }

    /// A rectangle of the facade's rooms, of the strip, of the band along the corridor.
    fn front(&self, x0: i32, x1: i32) -> Rect {
        Rect { x0, x1, y0: 0, y1: self.strip.0 }
    }

    fn between(&self, x0: i32, x1: i32) -> Rect {
        Rect { x0, x1, y0: self.strip.0, y1: self.strip.1 }
    }

    fn back(&self, x0: i32, x1: i32) -> Rect {
        Rect { x0, x1, y0: self.strip.1, y1: self.site.depth }
    }

    /// One room for everything, with a bathroom, a hall and perhaps a store along the corridor.
    fn studio(&mut self, rng: &mut Stream) -> Option<()> {
        let width = self.site.width;
        let (bath, hall) = (rng.count(34, 48) as i32, rng.count(27, 38) as i32);
        let store = if rng.chance(0.4) { rng.count(22, 34) as i32 } else { 0 };
        let mut rest = width - bath - hall - store;
        self.enlarge(0, self.front(0, width));
        // The rest of the band is part of the room, or makes the hall wider.
        let mut x = 0;
        if rest >= NICHE {
            self.enlarge(0, self.back(0, rest));
            x = rest;
            rest = 0;
        }
        if !(0..NICHE).contains(&rest) {
            return None;
        }
        let bath_first = rng.chance(0.5);
        let mut pieces = vec![(RoomKind::Bathroom, bath), (RoomKind::Hall, hall + rest), (RoomKind::Storage, store)];
        if bath_first {
            pieces.reverse();
        }
        for (kind, width) in pieces.into_iter().filter(|(_, width)| *width > 0) {
            self.add(kind, &[self.back(x, x + width)]);
            x += width;
        }
        Some(())
    }

    /// Kitchen, bedrooms, wet rooms and hall.
    fn rooms_of(&mut self, bedrooms: usize, rng: &mut Stream) -> Option<()> {
        let (width, deep) = (self.site.width, self.strip.1 > self.strip.0);
        let side = bedrooms > 1 && deep && self.has_side_window() && rng.chance(0.6);
        let walls = self.walls(bedrooms - usize::from(side), rng)?;
        let kitchen = self.add(RoomKind::Kitchen, &[]);
        let mut beds = Vec::new();
        for (i, pair) in walls.windows(2).enumerate() {
            let rect = self.front(pair[0], pair[1]);
            if i == 0 {
                self.enlarge(0, rect);
                continue;
            }
            let kind = if i > 1 && rng.chance(0.45) { RoomKind::Kids } else { RoomKind::Bedroom };
            beds.push(self.add(kind, &[rect]));
        }
        let end = if side { width - rng.count(BEDROOM as usize, 84) as i32 } else { width };
        if side {
            let kind = if rng.chance(0.45) { RoomKind::Kids } else { RoomKind::Bedroom };
            self.add(kind, &[self.back(end, width)]);
        }
        let last = walls[walls.len() - 2];
        let hall = if deep { (0, 0) } else { (walls[1] - rng.count(25, 32) as i32, last + rng.count(26, 34) as i32) };
        let (from, to) = self.along_corridor(kitchen, (end, hall), rng)?;
        if !deep {
            self.add(RoomKind::Hall, &[self.back(from, to)]);
            return Some(());
        }
        // The living room reaches through the strip to the kitchen, the hall to the last door, and the last bedroom has the rest.
        let begin = from.min(walls[2] - DOOR);
        self.enlarge(0, self.between(0, begin));
        let behind =
            self.rooms.iter().flat_map(|room| &room.rects).filter(|rect| rect.y0 == self.strip.1 && rect.x0 > to);
        let last_door = behind.map(|rect| rect.x0).fold(last, i32::max);
        let mut reach = (last_door + DOOR).max(to) + rng.count(0, 8) as i32;
        if width - reach < NICHE {
            reach = width;
        }
        self.add(RoomKind::Hall, &[self.between(begin, reach), self.back(from, to)]);
        if reach < width {
            let bed = *beds.last()?;
            self.enlarge(bed, self.between(reach, width));
        }
        Some(())
    }

    /// Whether a facade in the east has a place for a window behind the strip.
    fn has_side_window(&self) -> bool {
        let behind = |from: i32| from >= self.strip.1 + BESIDE;
        self.site.windows.iter().any(|place| place.side == Side::East && behind(place.from))
    }

    /// The walls across the facade's rooms: where each begins, and the end.
    fn walls(&self, bedrooms: usize, rng: &mut Stream) -> Option<Vec<i32>> {
        let mut places: Vec<(i32, i32)> =
            self.site.windows.iter().filter(|p| p.side == Side::South).map(|p| (p.from, p.to)).collect();
        places.sort_unstable();
        let gaps = places.windows(2).map(|pair| (pair[0].1 + BESIDE, pair[1].0 - BESIDE));
        let mut gaps: Vec<(i32, i32)> = gaps.filter(|(low, high)| low <= high).collect();
        if gaps.len() < bedrooms {
            return None;
        }
        rng.shuffle(&mut gaps);
        gaps.truncate(bedrooms);
        gaps.sort_unstable();
        let mut walls = vec![0];
        walls.extend(gaps.into_iter().map(|(low, high)| low + rng.below((high - low) as usize + 1) as i32));
        walls.push(self.site.width);
        let least = |i: usize| if i == 0 { LIVING } else { BEDROOM };
        walls.windows(2).enumerate().all(|(i, pair)| pair[1] - pair[0] >= least(i)).then_some(walls)
    }

    /// Divides the band along the corridor, up to where a bedroom has the rest: the kitchen, the hall, and columns of wet rooms
    /// and stores. Returns where the hall begins and ends. Beside the hall two rooms may lie behind each other.
    fn along_corridor(
        &mut self,
        kitchen: usize,
        (end, hall): (i32, (i32, i32)),
        rng: &mut Stream,
    ) -> Option<(i32, i32)> {
        let deep = self.strip.1 > self.strip.0;
        let depth = self.site.depth - self.strip.1;
        let dining = if end > 210 && rng.chance(0.5) { rng.count(40, 90) as i32 } else { 0 };
        let (from, to) = if deep {
            let from = dining + rng.count(42, 78) as i32;
            (from, from + rng.count(25, 36) as i32)
        } else {
            hall
        };
        if from - dining < 40 || to > end || self.site.door.1.min(to) - self.site.door.0.max(from) < DOOR {
            return None;
        }
        if dining > 0 {
            self.enlarge(0, self.back(0, dining));
        }
        // Beside the kitchen, and beside the hall, a store or a toilet may lie at the corridor.
        let own = self.column((dining, from), Some(8.0..13.5), rng);
        self.rooms[kitchen].rects.push(own.0);
        if let Some(behind) = own.1 {
            self.add(RoomKind::Storage, &[behind]);
        }
        let mut left = end - to;
        let mut count = (left as f32 / rng.between(36.0, 48.0)).round().max(1.0) as i32;
        if !deep {
            count = 1;
        }
        let mut x = to;
        let mut kinds = vec![RoomKind::Storage, RoomKind::Laundry];
        let large = self.rooms.iter().filter(|room| room.kind.is_bedroom()).count() > 1;
        if large {
            kinds.push(RoomKind::Bathroom);
            kinds.push(RoomKind::Wc);
        }
        rng.shuffle(&mut kinds);
        let bath = if deep { rng.below(count as usize) as i32 } else { 0 };
        for column in 0..count {
            let even = left / (count - column);
            let wide = if column + 1 == count { left } else { even + rng.count(0, 12) as i32 - 6 };
            if wide < 23 {
                return None;
            }
            let kind = if column == bath { RoomKind::Bathroom } else { kinds.pop()? };
            let area = (wide * depth) as f32 / 400.0;
            let split = column == 0 && area > areas(kind)[1] * 1.5;
            let (rect, behind) =
                self.column((x, x + wide), split.then(|| areas(kind)[0] + 0.8..areas(kind)[1] * 1.3), rng);
            self.add(kind, &[rect]);
            if let Some(behind) = behind {
                let small = behind.area() < 3.6 && large && kinds.contains(&RoomKind::Wc);
                kinds.retain(|kind| !(small && *kind == RoomKind::Wc));
                self.add(if small { RoomKind::Wc } else { RoomKind::Storage }, &[behind]);
            }
            x += wide;
            left -= wide;
        }
        Some((from, to))
    }

    /// A column of the band; where its room is to have an area, and enough is left, with another room at the corridor.
    fn column(
        &self,
        (x0, x1): (i32, i32),
        area: Option<std::ops::Range<f32>>,
        rng: &mut Stream,
    ) -> (Rect, Option<Rect>) {
        let whole = self.back(x0, x1);
        let Some(area) = area else { return (whole, None) };
        let depth = (rng.between(area.start, area.end) * 400.0 / (x1 - x0) as f32).round() as i32;
        if whole.depth() - depth < NICHE || depth < 30 {
            return (whole, None);
        }
        let wall = whole.y0 + depth;
        (Rect { y1: wall, ..whole }, Some(Rect { y0: wall, ..whole }))
    }

    /// How far the rooms are from usual sizes; `None` if one is too small, too large or too narrow.
    fn cost(&self) -> Option<f32> {
        let studio = self.rooms.iter().all(|room| !room.kind.is_bedroom());
        let rooms = self.rooms.iter().map(|room| {
            let (area, [mut least, usual, most]) = (room.area(), areas(room.kind));
            if studio && room.kind == RoomKind::Living {
                // A bed and a kitchen are in it, too.
                least = ONE_ROOM;
            }
            let sound = (least..=most).contains(&area) && room.widest() >= room.kind.least_side();
            sound.then(|| (area / usual).logarithm().raised(2))
        });
        rooms.sum()
    }
}

/// The number of bedrooms for a site, by its area and the places of its windows.
fn bedrooms(site: &Site, rng: &mut Stream) -> usize {
    let area = site.rect().area() * rng.normal(0.0, 0.14).exponential();
    let nearest = |count: &usize| (area / AREAS[*count]).logarithm().abs();
    let wished = (0..AREAS.len()).min_by(|a, b| nearest(a).total_cmp(&nearest(b))).unwrap_or(0);
    let front = site.windows.iter().filter(|place| place.side == Side::South).count();
    let sides = usize::from(site.is_open(Side::East)) + usize::from(site.is_open(Side::West));
    wished
        .min((front + sides.min(1)).saturating_sub(1))
        .min((site.width - LIVING) as usize / BEDROOM as usize + sides.min(1))
}

/// Where the strip begins and ends; there is none on a shallow site and in a studio.
fn bands(depth: i32, bedrooms: usize, rng: &mut Stream) -> Option<(i32, i32)> {
    if bedrooms == 0 || depth < SHALLOW {
        let back = rng.count(BACK.0 as usize, 50) as i32;
        let front = depth - back;
        return (front >= FRONT.0).then_some((front, front));
    }
    let strip = rng.count(24, 29) as i32;
    let (low, high) = (BACK.0.max(depth - strip - FRONT.1), BACK.1.min(depth - strip - FRONT.0));
    let back = (low <= high).then(|| rng.count(low as usize, high as usize) as i32)?;
    Some((depth - strip - back, depth - back))
}
