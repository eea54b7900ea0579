//! Plans along a spine: two bands of rooms with a hall between them.
//!
//! The south band ends in the living room; the other rooms stand side by side in both bands.
//! Bathrooms and stores are cut out of a room's corner, which makes that room L-shaped. Widths follow
//! in closed form from areas and depths; the living room takes the remaining length. A candidate
//! costs a microsecond or two, so many are drawn, and the first is taken whose room adjacency is that
//! of the programme.

use smallvec::SmallVec;
use vc_graph::Stream;
use vc_graph::portable::Portable;

use super::programme::{Programme, Wish};
use super::{Arrangement, Rect, Room, RoomKind, Scheme, Topology, cells};

/// The number of candidates drawn before a scheme is given up.
const TRIES: usize = 300;
/// The number of candidates drawn without improvement before the best so far is taken.
const PATIENCE: usize = 120;
/// The least length of wall for a door with its frame, cells.
const DOOR: i32 = 24;

/// A corner of a cell cut out for a service room.
#[derive(Debug, Clone, Copy)]
struct Notch {
    wish: usize,
    width: i32,
    depth: i32,
    /// Whether it is at the window side, so accessible only from the cell itself.
    outside: bool,
    /// The cell's own bathroom behind this one, and its depth: both share a wall and the pipes in it.
    behind: Option<(usize, i32)>,
}

impl Notch {
    fn area(&self) -> f32 {
        (self.width * (self.depth + self.behind.map_or(0, |b| b.1))) as f32
    }
}

/// A main room in a band, with the notches at its west and east corners.
#[derive(Debug, Clone)]
struct Cell {
    /// The index of the room request; `None` for a bay of the hall.
    wish: Option<usize>,
    notches: [Option<Notch>; 2],
    x: i32,
    width: i32,
}

/// Rooms side by side, west to east. Hundreds of candidates are drawn for a plan, and such short
/// lists cost more to allocate than to fill.
type Band = SmallVec<[Cell; 8]>;
/// Indices of room requests.
type Wishes = SmallVec<[usize; 8]>;
/// The corners that a service room may be cut out of: north band or not, cell, side.
type Hosts = SmallVec<[(bool, usize, usize); 16]>;

/// The hall strip and the depths of the bands.
struct Frame {
    south: i32,
    hall: i32,
    north: i32,
    /// The start and end of the hall along the spine.
    from: i32,
    to: i32,
    /// The length of the whole.
    length: i32,
    /// The length of the north band's rooms; beyond them is the living room or the outside.
    reach: i32,
}

/// The best plan of several hundred candidates; `None` if none was sound.
pub(super) fn lay_out(programme: &Programme, scheme: Scheme, rng: &mut Stream) -> Option<Arrangement> {
    let count = |f: fn(RoomKind) -> bool| programme.wishes.iter().filter(|w| f(w.kind)).count();
    let (bedrooms, baths) = (count(RoomKind::is_bedroom), count(|k| k == RoomKind::Bathroom));
    let kitchen = count(|k| k == RoomKind::Kitchen) > 0;
    let mut best: Option<(usize, Arrangement)> = None;
    let mut scale = 1.0;
    let mut latest = 0;
    let mut rooms = Vec::new();
    for candidate in 0..TRIES {
        if best.is_some() && candidate - latest > PATIENCE {
            break;
        }
        let Some(facades) = (Draft { programme, scheme, scale }).attempt(&mut rooms, rng) else { continue };
        let area: f32 = rooms.iter().map(Room::area).sum();
        let off = programme.wished_area.map_or(0.0, |wished| {
            scale *= (wished / area).power(0.6);
            (area / wished - 1.0).abs()
        });
        if off > 0.045 {
            continue;
        }
        let missed = Topology::from_rooms(&rooms).differences(programme.topology, bedrooms, baths, kitchen);
        let cost = missed + if off > 0.02 { 10 } else { 0 };
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, Arrangement { rooms: rooms.clone(), facades }));
            latest = candidate;
        }
        if cost == 0 {
            break;
        }
    }
    best.map(|(_, layout)| layout)
}

struct Draft<'a> {
    programme: &'a Programme,
    scheme: Scheme,
    scale: f32,
}

impl Draft<'_> {
    /// Draws a candidate into `rooms`, replacing their contents.
    fn attempt(&self, rooms: &mut Vec<Room>, rng: &mut Stream) -> Option<[bool; 4]> {
        let shallow = self.scheme == Scheme::Bar;
        let hall = match self.scheme {
            Scheme::CentralHall => rng.count(32, 44),
            _ => rng.count(23, 28),
        } as i32;
        let depths = if self.programme.area() < 45.0 { (66, 92) } else { (72, 98) };
        let south = rng.count(depths.0, depths.1) as i32;
        let north = if shallow { rng.count(39, 52) } else { rng.count(depths.0, depths.1) } as i32;
        let (mut souths, mut norths) = self.assign(shallow, rng);
        self.cut(&mut souths, &mut norths, (south, north), shallow, rng)?;
        let mut frame = Frame { south, hall, north, from: 0, to: 0, length: 0, reach: 0 };
        self.measure(&mut souths, &mut norths, &mut frame, shallow, rng)?;
        let taker = self.fit_hall(&souths, &norths, &mut frame, rng)?;
        self.build(&souths, &norths, &frame, taker, rooms);
        let facades = [rng.chance(0.3), rng.chance(0.4), true, !shallow];
        self.is_sound(rooms).then_some(facades)
    }

    fn wish(&self, index: usize) -> Wish {
        self.programme.wishes[index]
    }

    /// The area up to the wall centre lines, square cells.
    fn gross(&self, index: usize) -> f32 {
        let side = (self.wish(index).area * self.scale).sqrt() + 0.1;
        side * side * 400.0
    }

    /// Distributes the main rooms over the bands, west to east; the living room is the last one in
    /// the south.
    fn assign(&self, shallow: bool, rng: &mut Stream) -> (Band, Band) {
        let (mut souths, mut norths) = (Band::new(), Band::new());
        let mut load = [self.wish(0).area, 0.0];
        let mut mains: Wishes = (1..self.programme.wishes.len())
            .filter(|&i| self.wish(i).kind.is_bedroom() || self.wish(i).kind == RoomKind::Study)
            .collect();
        rng.shuffle(&mut mains);
        let kitchen = (1..self.programme.wishes.len()).find(|&i| self.wish(i).kind == RoomKind::Kitchen);
        // The kitchen's position: beside the living room, at the opposite east end, or anywhere
        // opposite.
        let place = if self.programme.open_kitchen { rng.below(2) } else { rng.below(3) };
        if kitchen.is_some() && place > 0 {
            load[1] += kitchen.map_or(0.0, |k| self.wish(k).area);
        } else {
            load[0] += kitchen.map_or(0.0, |k| self.wish(k).area);
        }
        for main in mains {
            let north = !shallow && (load[1] + rng.between(-8.0, 8.0) < load[0]);
            load[usize::from(north)] += self.wish(main).area;
            if north { &mut norths } else { &mut souths }.push(Cell::new(main));
        }
        match (kitchen, place) {
            (Some(k), 0) => souths.push(Cell::new(k)),
            (Some(k), 1) => norths.push(Cell::new(k)),
            (Some(k), _) => norths.insert(rng.below(norths.len() + 1), Cell::new(k)),
            _ => {}
        }
        souths.push(Cell::new(0));
        (souths, norths)
    }

    /// Gives every service room a corner of a cell, or a cell of its own in a shallow band.
    fn cut(
        &self,
        souths: &mut [Cell],
        norths: &mut Band,
        depths: (i32, i32),
        shallow: bool,
        rng: &mut Stream,
    ) -> Option<()> {
        let mut services: Wishes =
            (1..self.programme.wishes.len()).filter(|&i| is_service(self.wish(i).kind)).collect();
        // An en-suite bathroom may lie behind a shared one.
        services.sort_by_key(|&i| self.wish(i).of.is_some());
        let mut hosts = Hosts::new();
        for index in services {
            let wish = self.wish(index);
            if self.stack(index, souths, depths.0, rng) || self.stack(index, norths, depths.1, rng) {
                continue;
            }
            if shallow && wish.of.is_none() {
                norths.insert(rng.below(norths.len() + 1), Cell::new(index));
                continue;
            }
            let owner = wish.of;
            hosts.clear();
            for (north, band) in [(false, &*souths), (true, &**norths)] {
                for (at, cell) in band.iter().enumerate() {
                    let fits = match (owner, cell.wish) {
                        (Some(owner), Some(main)) => owner == main,
                        (None, Some(main)) => main != 0 && !is_service(self.wish(main).kind),
                        _ => false,
                    };
                    let deep = !(shallow && north);
                    hosts.extend((0..2).filter(|&s| fits && deep && cell.notches[s].is_none()).map(|s| (north, at, s)));
                }
            }
            self.prefer(wish.kind, souths, norths, &mut hosts);
            let &(north, at, side) = rng.pick(&hosts)?;
            let depth = if north { depths.1 } else { depths.0 };
            let outside = owner.is_some() && rng.chance(0.4);
            let notch = self.notch(index, depth, outside, rng)?;
            let band = if north { &mut norths[..] } else { &mut *souths };
            band[at].notches[side] = Some(notch);
        }
        Some(())
    }

    /// Puts an en-suite bathroom behind the shared one in a corner of its bedroom, if bathrooms are
    /// to be adjacent.
    fn stack(&self, index: usize, band: &mut [Cell], depth: i32, rng: &mut Stream) -> bool {
        let Some(owner) = self.wish(index).of.filter(|_| self.programme.topology.bath_bath) else { return false };
        let notches = band.iter_mut().filter(|c| c.wish == Some(owner)).flat_map(|c| c.notches.iter_mut().flatten());
        let bath = |n: &&mut Notch| self.wish(n.wish).kind == RoomKind::Bathroom && !n.outside && n.behind.is_none();
        let Some(notch) = notches.into_iter().find(bath).filter(|_| rng.chance(0.85)) else { return false };
        let wished = (self.gross(index) / notch.width as f32).round() as i32;
        let left = depth - notch.depth;
        // The part of the bedroom left behind both must be usable.
        let deep = if left - wished < 18 { left } else { wished };
        if deep < 32 || deep > wished * 5 / 4 || deep < wished * 4 / 5 {
            return false;
        }
        notch.behind = Some((index, deep));
        true
    }

    /// Keeps, if there are any, the corners that are adjacent to a bathroom or the kitchen, or are
    /// not, as the programme says.
    fn prefer(&self, kind: RoomKind, souths: &[Cell], norths: &[Cell], hosts: &mut Hosts) {
        if kind != RoomKind::Bathroom {
            return;
        }
        let topology = self.programme.topology;
        let own = |main: Option<usize>| main.is_some() && self.programme.wishes.iter().any(|w| w.of == main);
        let suite = |h: &(bool, usize, usize)| own(if h.0 { norths } else { souths }[h.1].wish);
        if topology.bath_bath && hosts.iter().any(suite) {
            hosts.retain(|h| suite(h));
        }
        let kind_of = |wish: usize| self.wish(wish).kind;
        let meets = |&(north, at, side): &(bool, usize, usize), what: RoomKind| {
            let band = if north { norths } else { souths };
            let beside = if side == 0 { at.checked_sub(1) } else { Some(at + 1) };
            let main = |c: &Cell| c.wish.is_some_and(|w| kind_of(w) == what);
            let facing = |c: &Cell| c.notches[1 - side].is_some_and(|n| kind_of(n.wish) == what);
            (what == RoomKind::Kitchen && main(&band[at]))
                || beside.and_then(|b| band.get(b)).is_some_and(|c| main(c) || facing(c))
        };
        for (what, wanted) in [(RoomKind::Kitchen, topology.bath_kitchen), (RoomKind::Bathroom, topology.bath_bath)] {
            let fit = |h: &(bool, usize, usize)| meets(h, what) == wanted;
            if hosts.iter().any(fit) {
                hosts.retain(|h| fit(h));
            }
        }
    }

    fn notch(&self, index: usize, band: i32, outside: bool, rng: &mut Stream) -> Option<Notch> {
        let area = self.gross(index);
        let width = match self.wish(index).kind {
            RoomKind::Wc => rng.count(23, 26),
            RoomKind::Storage => rng.count(22, 32),
            RoomKind::Bathroom if self.programme.topology.bath_bath => rng.count(34, 48),
            _ => rng.count(32, 42),
        } as i32;
        let depth = (area / width as f32).round() as i32;
        (depth >= 22 && depth <= band - 18).then_some(Notch { wish: index, width, depth, outside, behind: None })
    }

    /// Computes widths in closed form, and positions.
    fn measure(
        &self,
        souths: &mut [Cell],
        norths: &mut Band,
        frame: &mut Frame,
        shallow: bool,
        rng: &mut Stream,
    ) -> Option<()> {
        self.widen(souths, frame.south);
        self.widen(norths, frame.north);
        let fixed: i32 = souths.iter().rev().skip(1).map(|c| c.width).sum();
        let living = souths.last()?.width;
        let mut north: i32 = norths.iter().map(|c| c.width).sum();
        if shallow && rng.chance(0.6) {
            let width = rng.count(25, 34) as i32;
            norths.insert(rng.below(norths.len() + 1), Cell { wish: None, notches: [None; 2], x: 0, width });
            north += width;
        }
        let width = self.living_width(living, fixed, north, frame)?;
        if let Some(last) = souths.last_mut() {
            last.width = width;
        }
        frame.length = fixed + width;
        frame.reach = north;
        for band in [souths, &mut norths[..]] {
            let mut x = 0;
            for cell in band {
                cell.x = x;
                x += cell.width;
            }
        }
        Some(())
    }

    /// Gives the rooms of a band the widths that their areas and doors need.
    fn widen(&self, band: &mut [Cell], depth: i32) {
        for cell in band {
            let Some(main) = cell.wish else { continue };
            let notches = cell.notches.iter().flatten();
            let area = self.gross(main) + notches.clone().map(Notch::area).sum::<f32>();
            let passage = notches.filter(|n| !n.outside).map(|n| n.width).sum::<i32>() + DOOR;
            cell.width = ((area / depth as f32).round() as i32).max(passage).max(least_width(self.wish(main).kind));
        }
    }

    /// The width of the living room in the south, where the other rooms there are `fixed` and those in the north
    /// `north` cells wide: as wide as makes both bands equal, if it bears that.
    fn living_width(&self, living: i32, fixed: i32, north: i32, frame: &Frame) -> Option<i32> {
        let bears = |width: i32| width >= living * 4 / 5 && width <= living * 5 / 4;
        if bears(north - fixed) {
            return Some(north - fixed);
        }
        let spare = fixed + living - north;
        let cut = matches!(self.scheme, Scheme::LPlan | Scheme::OpenPlan | Scheme::Bar);
        if spare <= 0 || !cut || spare < 30 || north == 0 {
            return None;
        }
        if self.scheme == Scheme::LPlan {
            return Some(living);
        }
        // The living room extends through the strip: less of it lies in the south.
        let through = spare as f32 * frame.north as f32 / (frame.south + frame.north) as f32;
        let width = (living - through as i32).max(60);
        (fixed + width - north >= 30).then_some(width)
    }

    /// Determines the extent of the hall, and whether the first cell of the south (`false`) or north
    /// (`true`) band takes the strip west of it.
    fn fit_hall(&self, souths: &[Cell], norths: &[Cell], frame: &mut Frame, rng: &mut Stream) -> Option<Option<bool>> {
        let length = frame.length;
        let bay = norths.iter().any(|c| c.wish.is_none());
        let (open_west, open_east) = match self.scheme {
            Scheme::OpenPlan => (rng.chance(0.6), true),
            _ if bay => (rng.chance(0.5), rng.chance(0.7)),
            _ => {
                let west = rng.chance(0.5);
                (west, !west)
            }
        };
        let first = |band: &[Cell]| {
            band.first().is_some_and(|c| {
                let main = c.wish.is_some_and(|w| w != 0 && !is_service(self.wish(w).kind));
                main && c.notches[0].is_none_or(|n| n.outside)
            })
        };
        let takers: SmallVec<[bool; 2]> =
            [false, true].into_iter().filter(|&n| first(if n { norths } else { souths })).collect();
        let taker = if open_west { rng.pick(&takers).copied() } else { None };
        let (low, mut high) = self.doors_along(souths, norths, length, (taker, open_east));
        frame.from = if taker.is_some() && low >= 22 { low } else { 0 };
        high = (high + rng.below(8) as i32).max(frame.from + DOOR);
        let living = souths.last()?;
        let strip = length - high.max(frame.from);
        frame.to = if open_east && strip >= 24 && length - living.x.max(high) >= DOOR { high } else { length };
        // Where the north band ends early, the rest of the strip belongs to the living room.
        if frame.to > frame.reach && frame.reach < length {
            if !open_east || high > frame.reach {
                return None;
            }
            frame.to = frame.reach.max(high);
        }
        (self.scheme != Scheme::OpenPlan || frame.to < length).then_some(taker.filter(|_| frame.from > 0))
    }

    /// The first and last ends of the hall with which every room can have its door, where the main room of a band takes
    /// the strip west of it, and the living room may have the east.
    fn doors_along(
        &self,
        souths: &[Cell],
        norths: &[Cell],
        length: i32,
        (taker, open_east): (Option<bool>, bool),
    ) -> (i32, i32) {
        let (mut low, mut high) = (length, 0);
        let cells = souths.iter().enumerate().map(|(at, cell)| (false, at, cell));
        for (north, at, cell) in cells.chain(norths.iter().enumerate().map(|(at, cell)| (true, at, cell))) {
            if cell.wish == Some(0) {
                continue;
            }
            let kitchen = cell.wish.is_some_and(|w| self.wish(w).kind == RoomKind::Kitchen);
            for (from, to, main) in cell.frontages() {
                if !(main && at == 0 && taker == Some(north)) {
                    low = low.min(to - DOOR);
                }
                // A kitchen may open to the living room's part of the strip.
                if !(main && kitchen && open_east) {
                    high = high.max(from + DOOR);
                }
            }
        }
        (low, high)
    }

    /// Writes the rectangles of all rooms.
    fn build(&self, souths: &[Cell], norths: &[Cell], frame: &Frame, taker: Option<bool>, rooms: &mut Vec<Room>) {
        self.empty(rooms);
        let (hall_low, hall_high) = (frame.south, frame.south + frame.hall);
        let last = rooms.len() - 1;
        rooms[last].rects.push(Rect { x0: frame.from, x1: frame.to, y0: hall_low, y1: hall_high });
        for (north, band) in [(false, souths), (true, norths)] {
            // v is measured from the hall outwards.
            let depth = if north { frame.north } else { frame.south };
            let rect = |x0: i32, x1: i32, v0: i32, v1: i32| match north {
                false => Rect { x0, x1, y0: hall_low - v1, y1: hall_low - v0 },
                true => Rect { x0, x1, y0: hall_high + v0, y1: hall_high + v1 },
            };
            for (at, cell) in band.iter().enumerate() {
                let Some(main) = cell.wish else {
                    rooms[last].rects.push(rect(cell.x, cell.x + cell.width, 0, depth));
                    continue;
                };
                cell.carve(main, depth, rooms, &rect);
                if at == 0 && taker == Some(north) {
                    rooms[main].rects.push(Rect { x0: 0, x1: frame.from, y0: hall_low, y1: hall_high });
                }
            }
        }
        if frame.to < frame.length {
            rooms[0].rects.push(Rect { x0: frame.to, x1: frame.length, y0: hall_low, y1: hall_high });
        }
        if frame.reach < frame.length && self.scheme != Scheme::LPlan {
            let top = hall_high + frame.north;
            rooms[0].rects.push(Rect { x0: frame.reach, x1: frame.length, y0: hall_high, y1: top });
        }
    }

    /// The programme's rooms and the hall, still without rectangles.
    fn empty(&self, rooms: &mut Vec<Room>) {
        if rooms.is_empty() {
            let wishes = self.programme.wishes.iter();
            rooms.extend(wishes.map(|w| Room { kind: w.kind, rects: Vec::new(), of: w.of }));
            rooms.push(Room { kind: RoomKind::Hall, rects: Vec::new(), of: None });
        }
        rooms.iter_mut().for_each(|room| room.rects.clear());
    }

    /// Whether every room has the required area and width.
    fn is_sound(&self, rooms: &[Room]) -> bool {
        rooms.iter().enumerate().all(|(index, room)| {
            let (area, short) = (room.area(), room.widest());
            match self.programme.wishes.get(index) {
                Some(wish) => {
                    let (least, most) = if wish.kind == RoomKind::Living { (0.75, 1.35) } else { (0.78, 1.3) };
                    let wished = wish.area * self.scale;
                    area >= wished * least && area <= wished * most && short >= room.kind.least_side()
                }
                None => area <= 4.0 + 0.11 * self.programme.area() * self.scale,
            }
        })
    }
}

impl Cell {
    fn new(wish: usize) -> Self {
        Self { wish: Some(wish), notches: [None; 2], x: 0, width: 0 }
    }

    /// The stretches along the hall that need a door each, and whether it is the main room's.
    fn frontages(&self) -> impl Iterator<Item = (i32, i32, bool)> {
        let [left, right] = self.notches.map(|n| n.filter(|n| !n.outside));
        let (from, to) = (self.x, self.x + self.width);
        let low = from + left.map_or(0, |n| n.width);
        let high = to - right.map_or(0, |n| n.width);
        let notches = [left.map(|_| (from, low, false)), right.map(|_| (high, to, false))];
        std::iter::once((low, high, true)).chain(notches.into_iter().flatten())
    }

    /// Adds the rectangles of the main room and of the rooms cut out of it.
    fn carve(&self, main: usize, depth: i32, rooms: &mut [Room], rect: &impl Fn(i32, i32, i32, i32) -> Rect) {
        let (from, to) = (self.x, self.x + self.width);
        // The columns of the cell: both notches, and the part between them.
        let low = from + self.notches[0].map_or(0, |n| n.width);
        let high = to - self.notches[1].map_or(0, |n| n.width);
        let columns = [(from, low, self.notches[0]), (low, high, None), (high, to, self.notches[1])];
        for (x0, x1, notch) in columns.into_iter().filter(|(x0, x1, _)| x0 < x1) {
            let Some(notch) = notch else {
                rooms[main].rects.push(rect(x0, x1, 0, depth));
                continue;
            };
            let (cut, mut rest) = match notch.outside {
                true => ((depth - notch.depth, depth), (0, depth - notch.depth)),
                false => ((0, notch.depth), (notch.depth, depth)),
            };
            rooms[notch.wish].rects.push(rect(x0, x1, cut.0, cut.1));
            if let Some((own, deep)) = notch.behind {
                rooms[own].rects.push(rect(x0, x1, rest.0, rest.0 + deep));
                rest.0 += deep;
            }
            if rest.0 < rest.1 {
                rooms[main].rects.push(rect(x0, x1, rest.0, rest.1));
            }
        }
    }
}

fn is_service(kind: RoomKind) -> bool {
    matches!(kind, RoomKind::Bathroom | RoomKind::Wc | RoomKind::Storage | RoomKind::Laundry)
}

/// The least width of a cell in a band, cells.
fn least_width(kind: RoomKind) -> i32 {
    match kind {
        RoomKind::Living => 60,
        RoomKind::Wc => 23,
        RoomKind::Storage => 24,
        _ => kind.least_side() + 2,
    }
}

impl RoomKind {
    /// The least net side of the room's widest rectangle, cells.
    pub(super) fn least_side(self) -> i32 {
        match self {
            Self::Living => cells(2.9),
            Self::Bedroom => cells(2.6),
            Self::Kids => cells(2.3),
            Self::Kitchen => cells(1.9),
            Self::Study => cells(2.1),
            Self::Bathroom => cells(1.5),
            Self::Laundry => cells(1.5),
            Self::Wc | Self::Storage | Self::Hall => cells(0.9),
            Self::Balcony => cells(0.8),
        }
    }
}
