//! Doors, passages, windows and balconies.

use serde::Serialize;
use vc_graph::Stream;

use super::boundaries::Boundary;
use super::programme::{Programme, draw_area};
use super::site::{Side, Site};
use super::{CELLS, FloorPlan, Rect, Room, RoomKind, boundaries, cells};

/// The kind of an opening in a wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum OpeningKind {
    /// The front door.
    Entrance,
    /// A door between rooms.
    Door,
    /// An opening without a leaf.
    Passage,
    /// A glazed door to a balcony.
    BalconyDoor,
    /// A window.
    Window,
}

/// An opening in a wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlanOpening {
    /// Its kind.
    pub kind: OpeningKind,
    /// Whether its wall runs along Y.
    pub vertical: bool,
    /// The wall's centre line: X if vertical, else Y, cells.
    pub at: i32,
    /// The start along the wall, cells.
    pub from: i32,
    /// The end along the wall, cells.
    pub to: i32,
    /// The room on the side of smaller coordinates.
    pub low: Option<usize>,
    /// The room on the other side.
    pub high: Option<usize>,
    /// The side that its leaf opens to: true for larger coordinates.
    pub opens_high: bool,
    /// Whether the hinge is at `from`, not at `to`.
    pub hinge_low: bool,
    /// The height of its lower edge above the floor, metres.
    pub sill: f32,
    /// The height of its upper edge, metres.
    pub head: f32,
}

impl PlanOpening {
    /// Whether it leads into a room.
    pub fn touches(&self, room: usize) -> bool {
        self.low == Some(room) || self.high == Some(room)
    }

    /// The room on the other side.
    pub fn beyond(&self, room: usize) -> Option<usize> {
        if self.low == Some(room) { self.high } else { self.low }
    }

    /// The width, cells.
    pub fn width(&self) -> i32 {
        self.to - self.from
    }

    /// Whether a person can walk through it.
    pub fn is_way(&self) -> bool {
        self.kind != OpeningKind::Window
    }

    /// Whether it has a leaf that swings.
    pub(crate) fn has_leaf(&self) -> bool {
        matches!(self.kind, OpeningKind::Entrance | OpeningKind::Door | OpeningKind::BalconyDoor)
    }

    /// The square that its leaf sweeps, cells.
    pub(crate) fn swing(&self) -> Option<Rect> {
        self.has_leaf().then(|| self.before(self.opens_high, self.width()))
    }

    /// The rectangle in front of it on one side, as wide as the opening and of the given depth.
    pub(crate) fn before(&self, high: bool, depth: i32) -> Rect {
        let (near, far) = if high { (self.at + 1, self.at + 1 + depth) } else { (self.at - 1 - depth, self.at - 1) };
        self.across(near, far)
    }

    /// The rectangle between two lines parallel to the wall, as wide as the opening.
    pub(crate) fn across(&self, near: i32, far: i32) -> Rect {
        match self.vertical {
            true => Rect { x0: near, x1: far, y0: self.from, y1: self.to },
            false => Rect { y0: near, y1: far, x0: self.from, x1: self.to },
        }
    }

    fn on(edge: &Boundary, kind: OpeningKind, from: i32, width: i32) -> Self {
        let (sill, head) = if kind == OpeningKind::Entrance { (0.0, 2.1) } else { (0.0, 2.05) };
        let Boundary { vertical, at, low, high, .. } = *edge;
        let (opens_high, hinge_low, to) = (high.is_some(), true, from + width);
        Self { kind, vertical, at, from, to, low, high, opens_high, hinge_low, sill, head }
    }
}

/// The distance from a door's opening to the centre line of the wall at the next corner, cells.
const CORNER: i32 = 3;

/// Adds doors, passages, balconies and windows to a plan. `None` if a room cannot have its door.
pub(super) fn open(plan: &mut FloorPlan, programme: &Programme, rng: &mut Stream) -> Option<()> {
    let edges = boundaries::boundaries(&plan.rooms);
    let mut openings = doors(plan, &edges, None, programme.open_kitchen, rng)?;
    balconies(plan, &edges, programme, &mut openings, rng);
    windows(plan, &edges, &mut openings, rng);
    plan.openings = openings;
    Some(())
}

/// Adds doors, passages and windows to the plan of a flat on a site. `None` if a room cannot have its door, or one for people to be in
/// has no window.
pub(super) fn open_on(plan: &mut FloorPlan, site: &Site, rng: &mut Stream) -> Option<()> {
    let edges = boundaries::boundaries(&plan.rooms);
    let open_kitchen = rng.chance(0.73);
    let mut openings = doors(plan, &edges, Some(site.door), open_kitchen, rng)?;
    for place in &site.windows {
        let behind = |edge: &&Boundary| {
            side(edge) == place.side as usize
                && edge.inner().is_some_and(|room| plan.rooms[room].kind.has_window())
                && (edge.from + CORNER..=edge.to - CORNER).contains(&place.from)
                && place.to <= edge.to - CORNER
        };
        if let Some(edge) = edges.iter().filter(|edge| edge.inner().is_some()).find(behind) {
            let window = PlanOpening::on(edge, OpeningKind::Window, place.from, place.to - place.from);
            openings.push(PlanOpening { sill: place.sill, head: place.head, ..window });
        }
    }
    let lit = |room: usize| openings.iter().any(|o| o.kind == OpeningKind::Window && o.touches(room));
    let living = |kind: RoomKind| kind.is_bedroom() || kind == RoomKind::Living;
    (0..plan.rooms.len()).all(|room| !living(plan.rooms[room].kind) || lit(room)).then_some(())?;
    plan.openings = openings;
    Some(())
}

/// The front door, within a stretch of the north side if one is given, and the doors and passages between rooms.
fn doors(
    plan: &FloorPlan,
    edges: &[Boundary],
    landing: Option<(i32, i32)>,
    open_kitchen: bool,
    rng: &mut Stream,
) -> Option<Vec<PlanOpening>> {
    let mut opener = Opener { rooms: &plan.rooms, edges, facades: plan.facades, open_kitchen, placed: Vec::new() };
    opener.entrance(landing, rng)?;
    for room in 0..opener.rooms.len() {
        opener.door_of(room, rng)?;
    }
    Some(opener.placed)
}

struct Opener<'a> {
    rooms: &'a [Room],
    edges: &'a [Boundary],
    facades: [bool; 4],
    open_kitchen: bool,
    placed: Vec<PlanOpening>,
}

impl Opener<'_> {
    fn kind(&self, room: usize) -> RoomKind {
        self.rooms[room].kind
    }

    /// Places the front door: into the hall if it reaches an outer wall, else into the living room;
    /// preferably in a wall without windows, where the landing is. A given landing is a stretch of the north side.
    fn entrance(&mut self, landing: Option<(i32, i32)>, rng: &mut Stream) -> Option<()> {
        let width = if rng.chance(0.5) { 20 } else { 21 };
        let mut walls: Vec<(usize, Boundary)> = Vec::new();
        for edge in self.edges {
            let Some(room) = edge.inner() else { continue };
            let mut edge = *edge;
            if let Some((from, to)) = landing {
                if side(&edge) != Side::North as usize {
                    continue;
                }
                (edge.from, edge.to) = (edge.from.max(from), edge.to.min(to));
            }
            let rank = match self.kind(room) {
                RoomKind::Hall => 0,
                RoomKind::Living => 2,
                _ => continue,
            };
            if edge.length() >= width + 2 * CORNER - 2 {
                walls.push((rank + usize::from(self.facades[side(&edge)]), edge));
            }
        }
        rng.shuffle(&mut walls);
        walls.sort_by_key(|(rank, _)| *rank);
        walls.iter().find_map(|(_, edge)| {
            let inward = edge.high.is_some();
            self.leaf(edge, OpeningKind::Entrance, width, inward, rng)
        })
    }

    /// Places the door or passage that connects a room to the apartment.
    fn door_of(&mut self, room: usize, rng: &mut Stream) -> Option<()> {
        let own = &self.rooms[room];
        let leaf = |sizes: &[i32], rng: &mut Stream| sizes[rng.below(sizes.len())];
        let hall = |k| k == RoomKind::Hall;
        let living = |k| k == RoomKind::Living;
        match own.kind {
            RoomKind::Hall | RoomKind::Balcony => Some(()),
            RoomKind::Living => match self.rooms.iter().position(|r| hall(r.kind)) {
                Some(hall) => self.passage(room, hall, (17, 32), rng),
                None => Some(()),
            },
            RoomKind::Kitchen if self.open_kitchen => {
                let to_living = self.passage(room, 0, (24, 56), rng);
                to_living.or_else(|| {
                    let hall = self.rooms.iter().position(|r| hall(r.kind))?;
                    self.passage(room, hall, (20, 32), rng)
                })
            }
            RoomKind::Bathroom if own.of.is_some() => {
                self.door(room, |other, _| Some(other) == own.of, leaf(&[15, 16, 17], rng), rng)
            }
            kind => {
                let width = match kind {
                    RoomKind::Bathroom | RoomKind::Laundry => leaf(&[16, 16, 17], rng),
                    RoomKind::Wc | RoomKind::Storage => leaf(&[14, 15], rng),
                    _ => leaf(&[17, 17, 18], rng),
                };
                let first = self.door(room, |_, k| hall(k), width, rng);
                first.or_else(|| self.door(room, |_, k| living(k), width, rng)).or_else(|| {
                    let through = match kind {
                        RoomKind::Storage | RoomKind::Laundry => |k| k == RoomKind::Kitchen,
                        _ => |_| false,
                    };
                    self.door(room, |_, k| through(k), width, rng)
                })
            }
        }
    }

    /// Places an opening without a leaf between two rooms, as wide as their wall and the limits
    /// allow.
    fn passage(&mut self, a: usize, b: usize, widths: (i32, i32), rng: &mut Stream) -> Option<()> {
        let mut walls: Vec<&Boundary> = self.edges.iter().filter(|e| e.joins(a, b)).collect();
        walls.sort_by_key(|e| -e.length());
        walls.into_iter().find_map(|edge| {
            let most = (edge.length() - 2 * CORNER).min(rng.count(widths.0 as usize, widths.1 as usize) as i32);
            (0..8).find_map(|_| {
                let spare = edge.length() - 2 * CORNER - most;
                if most < widths.0 || spare < 0 {
                    return None;
                }
                let from = edge.from + CORNER + rng.below(spare as usize + 1) as i32;
                let opening = PlanOpening::on(edge, OpeningKind::Passage, from, most);
                self.place(opening)
            })
        })
    }

    /// Places a door to one of the suitable rooms.
    fn door(&mut self, room: usize, fit: impl Fn(usize, RoomKind) -> bool, width: i32, rng: &mut Stream) -> Option<()> {
        let mut walls: Vec<&Boundary> = self.edges.iter().collect();
        walls.retain(|e| e.length() >= width + 4 && e.beyond(room).is_some_and(|o| fit(o, self.kind(o))));
        rng.shuffle(&mut walls);
        // Small wet rooms have no space for a leaf, so it opens outwards.
        let small =
            matches!(self.kind(room), RoomKind::Bathroom | RoomKind::Wc | RoomKind::Storage | RoomKind::Laundry);
        let outward = small && self.rooms[room].area() < 6.5;
        for way in [outward, !outward] {
            for edge in &walls {
                let inward = edge.high == Some(room);
                if let Some(done) = self.leaf(edge, OpeningKind::Door, width, inward != way, rng) {
                    return Some(done);
                }
            }
        }
        None
    }

    /// Places a leaf in a wall, hinged near a corner if possible, where no other leaf is in the
    /// way.
    fn leaf(
        &mut self,
        edge: &Boundary,
        kind: OpeningKind,
        width: i32,
        opens_high: bool,
        rng: &mut Stream,
    ) -> Option<()> {
        let margin = CORNER.min((edge.length() - width) / 2);
        let (first, last) = (edge.from + margin, edge.to - margin - width);
        let mut spots = vec![(first, true), (last, false), (last, true), (first, false)];
        spots.swap(0, rng.below(2));
        let middle = (last - first).max(0) as usize;
        spots.extend((0..4).map(|_| (first + rng.below(middle + 1) as i32, rng.chance(0.5))));
        spots.into_iter().find_map(|(from, hinge_low)| {
            self.place(PlanOpening { opens_high, hinge_low, ..PlanOpening::on(edge, kind, from, width) })
        })
    }

    /// Adds an opening unless it conflicts with another.
    fn place(&mut self, opening: PlanOpening) -> Option<()> {
        let own = opening.swing();
        let into = if opening.opens_high { opening.high } else { opening.low };
        // The leaf must have space to swing.
        if let (Some(swing), Some(into)) = (own, into) {
            let net = self.rooms[into].net();
            if !super::rect::covers(&net, swing) {
                return None;
            }
        }
        let zone = |o: &PlanOpening| [o.before(true, 4), o.before(false, 4)];
        let clash = |other: &PlanOpening| {
            let ways = zone(other);
            let swings = match (own, other.swing()) {
                (Some(a), Some(b)) => a.overlaps(&b),
                _ => false,
            };
            let crosses = own.is_some_and(|s| ways.iter().any(|w| w.overlaps(&s)));
            let crossed = other.swing().is_some_and(|s| zone(&opening).iter().any(|w| w.overlaps(&s)));
            let wall = other.vertical == opening.vertical && other.at == opening.at;
            swings || crosses || crossed || (wall && other.from < opening.to + 3 && opening.from < other.to + 3)
        };
        if self.placed.iter().any(clash) {
            return None;
        }
        self.placed.push(opening);
        Some(())
    }
}

/// The side of the building that an outer edge belongs to: west, east, south, north.
fn side(edge: &Boundary) -> usize {
    match (edge.vertical, edge.low.is_none()) {
        (true, true) => 0,
        (true, false) => 1,
        (false, true) => 2,
        (false, false) => 3,
    }
}

/// Adds balconies in front of windowed walls, with their doors.
fn balconies(
    plan: &mut FloorPlan,
    edges: &[Boundary],
    programme: &Programme,
    openings: &mut Vec<PlanOpening>,
    rng: &mut Stream,
) {
    let mut wished: Vec<bool> = vec![false; usize::from(programme.balconies.0)];
    wished.extend(vec![true; usize::from(programme.balconies.1)]);
    wished.extend((0..programme.more_balconies).map(|i| i % 2 == 0));
    for bedroom in wished {
        let fits = |room: usize| match bedroom {
            true => plan.rooms[room].kind == RoomKind::Bedroom || plan.rooms[room].kind == RoomKind::Kids,
            false => plan.rooms[room].kind == RoomKind::Living,
        };
        let mut walls: Vec<&Boundary> = edges.iter().filter(|e| e.inner().is_some_and(fits)).collect();
        walls.retain(|e| e.length() >= 36 && plan.facades[side(e)]);
        rng.shuffle(&mut walls);
        walls.sort_by_key(|e| openings.iter().any(|o| o.kind == OpeningKind::BalconyDoor && Some(o.at) == Some(e.at)));
        for edge in walls {
            if let Some((balcony, door)) = balcony(plan, edge, openings, rng) {
                plan.rooms.push(balcony);
                openings.push(door);
                break;
            }
        }
    }
}

/// A balcony in front of an outer wall: its net area begins where the wall ends.
fn balcony(
    plan: &FloorPlan,
    edge: &Boundary,
    openings: &[PlanOpening],
    rng: &mut Stream,
) -> Option<(Room, PlanOpening)> {
    let depth = rng.count(24, 34) as i32;
    let area = draw_area(RoomKind::Balcony, rng);
    let length = ((area * CELLS * CELLS / (depth - 2) as f32) as i32 + 2).clamp(32, edge.length());
    let from = edge.from + rng.below((edge.length() - length) as usize + 1) as i32;
    let outwards = edge.low.is_some();
    let wall = PlanOpening::on(edge, OpeningKind::BalconyDoor, from, length);
    let near = plan.shell - 1;
    let rect = match outwards {
        true => wall.across(edge.at + near, edge.at + near + depth),
        false => wall.across(edge.at - near - depth, edge.at - near),
    };
    let free = plan.rooms.iter().flat_map(|r| &r.rects).all(|r| !r.grown(plan.shell).overlaps(&rect.grown(-1)));
    let width = rng.count(16, 18) as i32;
    let spare = length - width - 2 * CORNER - 2;
    if !free || spare < 0 {
        return None;
    }
    let index = plan.rooms.len();
    let mut door = PlanOpening::on(
        edge,
        OpeningKind::BalconyDoor,
        from + CORNER + 1 + rng.below(spare as usize + 1) as i32,
        width,
    );
    // Balcony doors open into the room.
    door.opens_high = edge.high.is_some();
    door.hinge_low = rng.chance(0.5);
    if outwards {
        door.high = Some(index)
    } else {
        door.low = Some(index)
    }
    let clash = openings.iter().any(|o| {
        let ways = [o.before(true, 4), o.before(false, 4)];
        door.swing().is_some_and(|s| o.swing().is_some_and(|t| t.overlaps(&s)) || ways.iter().any(|w| w.overlaps(&s)))
    });
    (!clash).then(|| (Room::new(RoomKind::Balcony, rect), door))
}

/// Adds windows: in living rooms and bedrooms at least an eighth of the floor area, where the outer
/// walls allow it.
fn windows(plan: &FloorPlan, edges: &[Boundary], openings: &mut Vec<PlanOpening>, rng: &mut Stream) {
    for (index, room) in plan.rooms.iter().enumerate() {
        let (sill, head, share, most) = match room.kind {
            RoomKind::Living | RoomKind::Bedroom | RoomKind::Kids | RoomKind::Study => (0.9, 2.25, 0.125, 44),
            RoomKind::Kitchen => (1.1, 2.25, 0.1, 32),
            RoomKind::Bathroom if rng.chance(0.9) => (1.5, 2.1, 0.06, 14),
            _ => continue,
        };
        let mut walls: Vec<&Boundary> = edges.iter().filter(|e| e.inner() == Some(index)).collect();
        walls.retain(|e| plan.facades[side(e)] && e.length() >= 16);
        walls.sort_by_key(|e| -e.length());
        let mut wanted = room.area() * share / (head - sill);
        for edge in walls {
            for (from, to) in free(edge, openings) {
                let width = cells(wanted).clamp(12, most).min(to - from);
                if wanted <= 0.0 || width < 10 {
                    continue;
                }
                let spare = (to - from - width) as f32;
                let from = from + (spare * rng.between(0.35, 0.65)) as i32;
                openings.push(PlanOpening { sill, head, ..PlanOpening::on(edge, OpeningKind::Window, from, width) });
                wanted -= super::metres(width);
            }
        }
    }
}

/// The stretches of a wall without openings, excluding the corners.
fn free(edge: &Boundary, openings: &[PlanOpening]) -> Vec<(i32, i32)> {
    let mut taken: Vec<(i32, i32)> = openings
        .iter()
        .filter(|o| o.vertical == edge.vertical && o.at == edge.at)
        .map(|o| (o.from - 4, o.to + 4))
        .collect();
    taken.sort_unstable();
    let mut from = edge.from + 4;
    let mut gaps = Vec::new();
    for (low, high) in taken {
        gaps.push((from, low.min(edge.to - 4)));
        from = from.max(high);
    }
    gaps.push((from, edge.to - 4));
    gaps.retain(|(a, b)| b - a >= 10);
    gaps
}
