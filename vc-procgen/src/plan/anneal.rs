//! Floor plans by simulated annealing, for programmes that no template accommodates: a rectangle is
//! divided recursively into rooms, and the cuts are changed until every room has its size, its door
//! and its window.
//!
//! After Wong and Liu, "A new algorithm for floorplan design" (1986). Costs some milliseconds, a
//! thousand times as much as a template's candidate.

use vc_graph::Stream;
use vc_graph::portable::Portable;

use super::programme::Programme;
use super::{Arrangement, Rect, Room, RoomKind};

/// The number of changes tried before giving up.
const STEPS: usize = 8000;
/// The temperatures at the start and at the end, in units of the cost.
const HEAT: (f32, f32) = (1.5, 0.03);
/// The least length of wall for a door with its frame, and for a window, in cells.
const DOOR: i32 = 24;
const WINDOW: i32 = 30;
/// The sides that may have windows: west, east, south, north.
const FACADES: [bool; 4] = [false, true, true, true];

/// A plan with one rectangle for every room; `None` if none was found.
pub(super) fn lay_out(programme: &Programme, rng: &mut Stream) -> Option<Arrangement> {
    let mut rooms: Vec<Room> =
        programme.wishes.iter().map(|w| Room { kind: w.kind, rects: Vec::new(), of: w.of }).collect();
    rooms.push(Room { kind: RoomKind::Hall, rects: Vec::new(), of: None });
    let hall = 2.5 + 0.05 * programme.area();
    let areas: Vec<f32> = programme.wishes.iter().map(|w| w.area).chain([hall]).collect();
    let all = areas.iter().copied().map(gross).collect();
    let mut site = Site { rooms: &rooms, gross: all, open: programme.open_kitchen, shape: rng.between(0.75, 1.6) };
    let mut cuts = Cuts::straight(rooms.len(), rng);
    site.anneal(&mut cuts, rng)?;
    if let Some(wished) = programme.wished_area {
        // Walls take more or less area than was allowed for.
        let net: f32 = site.place(&cuts, &mut Sheet::default()).iter().map(|r| r.grown(-1).area()).sum();
        site.gross = areas.iter().map(|area| gross(area * (wished / net))).collect();
    }
    let mut sheet = Sheet::default();
    let rects = site.place(&cuts, &mut sheet);
    if site.cost(rects) > 0.0 {
        return None;
    }
    rooms.iter_mut().zip(rects).for_each(|(room, rect)| room.rects.push(*rect));
    Some(Arrangement { rooms, facades: FACADES })
}

/// A slicing tree in postfix order (a Polish expression): two parts, then their arrangement.
#[derive(Debug, Clone)]
struct Cuts(Vec<Token>);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token {
    Room(usize),
    /// The second part lies east of the first.
    Beside,
    /// The second part lies north of the first.
    Above,
}

impl Token {
    fn is_room(self) -> bool {
        matches!(self, Self::Room(_))
    }

    fn turned(self) -> Self {
        match self {
            Self::Beside => Self::Above,
            Self::Above => Self::Beside,
            room => room,
        }
    }
}

impl Cuts {
    /// All rooms in a row, in random order.
    fn straight(rooms: usize, rng: &mut Stream) -> Self {
        let mut order: Vec<usize> = (0..rooms).collect();
        rng.shuffle(&mut order);
        let tokens = order.iter().enumerate().flat_map(|(i, &room)| {
            let cut = if i % 2 == 0 { Token::Beside } else { Token::Above };
            std::iter::once(Token::Room(room)).chain((i > 0).then_some(cut))
        });
        Self(tokens.collect())
    }

    /// Makes one random change: swaps two rooms, turns a cut, or moves a cut past a room.
    fn change(&mut self, rng: &mut Stream) {
        let pick = |rng: &mut Stream, rooms: bool, tokens: &[Token]| {
            let all = (0..tokens.len()).filter(|&i| tokens[i].is_room() == rooms);
            let chosen = rng.below(all.clone().count());
            all.clone().nth(chosen).unwrap_or(0)
        };
        match rng.below(3) {
            0 => {
                let (a, b) = (pick(rng, true, &self.0), pick(rng, true, &self.0));
                self.0.swap(a, b);
            }
            1 => {
                let at = pick(rng, false, &self.0);
                self.0[at] = self.0[at].turned();
            }
            _ => {
                let at = rng.below(self.0.len() - 1);
                if self.0[at].is_room() != self.0[at + 1].is_room() {
                    self.0.swap(at, at + 1);
                    if !self.is_whole() {
                        self.0.swap(at, at + 1);
                    }
                }
            }
        }
    }

    /// Whether every cut has two parts before it.
    fn is_whole(&self) -> bool {
        let mut parts = 0;
        self.0.iter().all(|token| {
            parts += if token.is_room() { 1 } else { -1 };
            parts > 0
        })
    }
}

/// The requirements of the rooms.
struct Site<'a> {
    rooms: &'a [Room],
    /// The areas including half of the surrounding walls, square cells.
    gross: Vec<f32>,
    /// Whether the kitchen is open to the living room.
    open: bool,
    /// The ratio of width to depth of the whole.
    shape: f32,
}

impl Site<'_> {
    /// Changes cuts until the cost is zero.
    fn anneal(&self, cuts: &mut Cuts, rng: &mut Stream) -> Option<()> {
        let mut sheet = Sheet::default();
        let mut cost = self.cost(self.place(cuts, &mut sheet));
        let mut other = cuts.clone();
        for step in 0..STEPS {
            if cost == 0.0 {
                return Some(());
            }
            other.0.clone_from(&cuts.0);
            other.change(rng);
            let new = self.cost(self.place(&other, &mut sheet));
            let heat = || HEAT.0 * (HEAT.1 / HEAT.0).power(step as f32 / STEPS as f32);
            if new <= cost || rng.chance(((cost - new) / heat()).exponential()) {
                std::mem::swap(cuts, &mut other);
                cost = new;
            }
        }
        None
    }

    /// Computes the rooms' rectangles: every cut divides in proportion to the areas.
    fn place<'s>(&self, cuts: &Cuts, sheet: &'s mut Sheet) -> &'s [Rect] {
        let Sheet { parts, rects, open } = sheet;
        parts.clear();
        for (at, token) in cuts.0.iter().enumerate() {
            parts.push(match *token {
                Token::Room(room) => (at, self.gross[room]),
                _ => {
                    let second = parts[at - 1];
                    let first = parts[second.0 - 1];
                    (first.0, first.1 + second.1)
                }
            });
        }
        let last = cuts.0.len() - 1;
        let depth = (parts[last].1 / self.shape).sqrt();
        let hull = Rect::sized(0, 0, (parts[last].1 / depth).round() as i32, depth.round() as i32);
        rects.resize(self.rooms.len(), Rect::default());
        open.clear();
        open.push((last, hull));
        while let Some((at, rect)) = open.pop() {
            let token = cuts.0[at];
            if let Token::Room(room) = token {
                rects[room] = rect;
                continue;
            }
            let second = at - 1;
            let first = parts[second].0 - 1;
            let share = parts[first].1 / parts[at].1;
            let (low, high) = halves(rect, token == Token::Beside, share);
            open.extend([(first, low), (second, high)]);
        }
        rects
    }

    /// The cost of violated requirements, about one for each that is missed entirely.
    fn cost(&self, rects: &[Rect]) -> f32 {
        let hull = rects.iter().copied().reduce(Rect::around).unwrap_or_default();
        (0..rects.len()).map(|room| self.shape(room, &rects[room]) + self.place_of(room, rects, &hull)).sum()
    }

    /// The cost of a room's side lengths.
    fn shape(&self, room: usize, rect: &Rect) -> f32 {
        let kind = self.rooms[room].kind;
        let (short, long) = (rect.short(), rect.width().max(rect.depth()));
        let least = kind.least_side() + 2;
        let most = match kind {
            RoomKind::Hall => 8.0,
            RoomKind::Bathroom | RoomKind::Wc | RoomKind::Storage | RoomKind::Laundry => 2.6,
            _ => 2.2,
        };
        missing(short, least) + (long as f32 / short.max(1) as f32 - most).max(0.0)
    }

    /// The cost of a room's position: its access and its window.
    fn place_of(&self, room: usize, rects: &[Rect], hull: &Rect) -> f32 {
        let own = &self.rooms[room];
        let hall = rects.len() - 1;
        let meets = |other: usize| contact(&rects[room], &rects[other]);
        let way = match own.kind {
            RoomKind::Hall => {
                let entrance = outer(&rects[room], hull, [true; 4]).max(outer(&rects[0], hull, [true; 4]));
                missing(entrance, DOOR)
            }
            RoomKind::Living => missing(meets(hall), DOOR),
            RoomKind::Kitchen if self.open => missing(meets(0), WINDOW).min(missing(meets(hall), WINDOW)),
            _ => missing(own.of.map_or_else(|| meets(hall).max(meets(0)), meets), DOOR),
        };
        let lit = own.kind.is_bedroom() || matches!(own.kind, RoomKind::Living | RoomKind::Kitchen | RoomKind::Study);
        way + if lit { missing(outer(&rects[room], hull, FACADES), WINDOW) } else { 0.0 }
    }
}

/// The working memory for placing rooms, reused.
#[derive(Default)]
struct Sheet {
    /// The start and the area of each part of the tree.
    parts: Vec<(usize, f32)>,
    rects: Vec<Rect>,
    /// The parts still to be divided.
    open: Vec<(usize, Rect)>,
}

/// The area in square cells including half of the surrounding walls, for a net area in square
/// metres.
fn gross(area: f32) -> f32 {
    (area.sqrt() + 0.1).raised(2) * 400.0
}

/// The missing share of a length, 0 to 1.
fn missing(length: i32, least: i32) -> f32 {
    (least - length).max(0) as f32 / least as f32
}

/// Divides a rectangle in two; `share` is the first part's share of the area.
fn halves(rect: Rect, beside: bool, share: f32) -> (Rect, Rect) {
    let length = if beside { rect.width() } else { rect.depth() };
    let first = (length as f32 * share).round() as i32;
    if beside {
        let cut = rect.x0 + first;
        (Rect { x1: cut, ..rect }, Rect { x0: cut, ..rect })
    } else {
        let cut = rect.y0 + first;
        (Rect { y1: cut, ..rect }, Rect { y0: cut, ..rect })
    }
}

/// The length of the side that two rectangles share.
fn contact(a: &Rect, b: &Rect) -> i32 {
    let both = a.shared(*b);
    let (width, depth) = (both.width(), both.depth());
    if width == 0 || depth == 0 { width.max(depth).max(0) } else { 0 }
}

/// The longest side of a rectangle on the given sides of the whole.
fn outer(rect: &Rect, hull: &Rect, sides: [bool; 4]) -> i32 {
    let upright = (sides[0] && rect.x0 == hull.x0) || (sides[1] && rect.x1 == hull.x1);
    let level = (sides[2] && rect.y0 == hull.y0) || (sides[3] && rect.y1 == hull.y1);
    let upright = if upright { rect.depth() } else { 0 };
    upright.max(if level { rect.width() } else { 0 })
}
