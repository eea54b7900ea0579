//! Floor plans: walls, doors with their swing, windows, room names and areas.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use super::canvas::{Anchor, Canvas, Colour, Ink, Point};
use super::top;
use crate::apartment::Apartment;
use crate::area::Area;
use crate::plan::{FloorPlan, OpeningKind, PlanOpening, Rect, Room, RoomKind, Scheme, metres};
use crate::reach::doorway;

/// The margin around the building, metres.
pub(super) const MARGIN: f32 = 0.7;
/// The height of the strips for the title above and the scale below, metres.
pub(super) const STRIP: f32 = 0.9;
/// The least width of a drawing relative to its height.
const SLIMMEST: f32 = 0.85;

pub(super) const WALL: Colour = Colour::hex(0x2b2e33);
pub(super) const LINE: Colour = Colour::hex(0x3c4046);
const FAINT: Colour = Colour::hex(0x8d939b);
/// The width of thin lines, metres.
const THIN: f32 = 0.015;
/// The text heights tried for room names, metres.
const SIZES: [f32; 5] = [0.26, 0.21, 0.17, 0.13, 0.09];

impl FloorPlan {
    /// Draws the plan seen from above, in metres: walls, doors, windows, names and areas of rooms,
    /// a scale.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::FloorPlan;
    /// let plan = FloorPlan::generate(&Specification::with_bedrooms(2), Seed(42))?;
    /// assert!(plan.drawing().to_svg(1000).contains("Living room"));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn drawing(&self) -> Canvas {
        draw(self, &summary(self), &[], |_| {})
    }
}

impl Apartment {
    /// Draws the floor plan with the furniture, seen from above, in metres. Objects high above the
    /// floor are dashed; objects inside others are not shown.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(42))?;
    /// assert!(home.floor_plan().to_svg(1000).contains("Apartment 42"));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn floor_plan(&self) -> Canvas {
        let title = format!("Apartment {} · {}", self.seed.0, summary(&self.plan));
        draw(&self.plan, &title, &top::areas(self), |canvas| top::draw(canvas, self))
    }
}

impl Scheme {
    /// The name for display.
    pub fn title(self) -> &'static str {
        match self {
            Self::Studio => "studio",
            Self::Bar => "bar",
            Self::Corridor => "corridor",
            Self::CentralHall => "central hall",
            Self::OpenPlan => "open plan",
            Self::LPlan => "L-plan",
            Self::Irregular => "irregular",
            Self::Annealed => "annealed",
        }
    }
}

/// The scheme, the area, and the numbers of bedrooms and bathrooms.
fn summary(plan: &FloorPlan) -> String {
    let count = |f: fn(RoomKind) -> bool| plan.rooms.iter().filter(|r| f(r.kind)).count();
    let (beds, baths) = (count(RoomKind::is_bedroom), count(|k| k == RoomKind::Bathroom));
    format!("{} · {:.1} m² · {beds} bed · {baths} bath", plan.scheme.title(), plan.area())
}

/// Draws everything in order, from the floors to the names; `furnish` draws on the floors, and the
/// names avoid `furniture` as far as possible.
fn draw(plan: &FloorPlan, title: &str, furniture: &[Area], furnish: impl FnOnce(&mut Canvas)) -> Canvas {
    let (low, high) = frame(plan);
    let mut canvas = Canvas::new(low, high);
    rooms(&mut canvas, plan, furniture, furnish);
    heading(&mut canvas, low, high, title);
    scale(&mut canvas, [low[0] + MARGIN, low[1] + 0.4]);
    canvas
}

/// Draws all but heading and scale.
fn rooms(canvas: &mut Canvas, plan: &FloorPlan, furniture: &[Area], furnish: impl FnOnce(&mut Canvas)) {
    balconies(canvas, plan);
    walls(canvas, plan);
    plan.openings.iter().for_each(|o| cut(canvas, plan, o));
    furnish(canvas);
    plan.openings.iter().for_each(|o| leaf(canvas, o));
    let swings = plan.openings.iter().filter_map(PlanOpening::swing).map(|s| Area::from_rect(&s));
    let taken: Vec<Area> = furniture.iter().copied().chain(swings).collect();
    plan.rooms.iter().for_each(|r| label(canvas, r, &taken));
}

/// Draws a home without heading and scale.
pub(super) fn home(canvas: &mut Canvas, home: &Apartment) {
    rooms(canvas, &home.plan, &top::areas(home), |canvas| top::draw(canvas, home));
}

/// The visible area: the building with its outer walls and a margin, no narrower than [`SLIMMEST`]
/// of its height.
fn frame(plan: &FloorPlan) -> (Point, Point) {
    let hull = plan.hull().grown(plan.shell);
    let (south, north) = (metres(hull.y0) - MARGIN - STRIP, metres(hull.y1) + MARGIN + STRIP);
    let side = (SLIMMEST * (north - south) - metres(hull.width())) / 2.0;
    let side = side.max(MARGIN);
    ([metres(hull.x0) - side, south], [metres(hull.x1) + side, north])
}

fn fill(canvas: &mut Canvas, rect: &Rect, ink: Ink) {
    canvas.rectangle([metres(rect.x0), metres(rect.y0)], [metres(rect.x1), metres(rect.y1)], ink);
}

/// A light tint by a room's purpose.
fn tint(kind: RoomKind) -> Colour {
    Colour::hex(match kind {
        RoomKind::Living => 0xfbf5e9,
        RoomKind::Bedroom | RoomKind::Kids => 0xf6f1f5,
        RoomKind::Kitchen => 0xf1f5ea,
        RoomKind::Bathroom | RoomKind::Wc | RoomKind::Laundry => 0xe9f2f6,
        RoomKind::Study => 0xf2f2ea,
        RoomKind::Hall | RoomKind::Storage => 0xf4f3f1,
        RoomKind::Balcony => 0xf3f6ef,
    })
}

/// Draws balconies with dashed outlines.
fn balconies(canvas: &mut Canvas, plan: &FloorPlan) {
    for rect in plan.rooms.iter().filter(|r| r.kind == RoomKind::Balcony).flat_map(|r| &r.rects) {
        fill(canvas, rect, Ink::filled(tint(RoomKind::Balcony)).outlined(LINE, 2.0 * THIN).dashed(0.12));
    }
}

/// Draws walls: the area within the outer line that is in no room's net area.
fn walls(canvas: &mut Canvas, plan: &FloorPlan) {
    let indoors = || plan.rooms.iter().filter(|r| r.kind != RoomKind::Balcony);
    for rect in indoors().flat_map(|r| &r.rects) {
        fill(canvas, &rect.grown(plan.shell), Ink::filled(WALL));
    }
    for room in indoors() {
        room.net().iter().for_each(|r| fill(canvas, r, Ink::filled(tint(room.kind))));
    }
}

/// A point at an opening: along its wall and across it, metres.
fn at(opening: &PlanOpening, along: f32, across: f32) -> Point {
    if opening.vertical { [across, along] } else { [along, across] }
}

/// Draws the gap of an opening in its wall, with the panes of a window.
fn cut(canvas: &mut Canvas, plan: &FloorPlan, opening: &PlanOpening) {
    let hole = doorway(plan, opening);
    let inside = [opening.low, opening.high].into_iter().filter_map(|room| plan.kind_of(room));
    let floor = inside.filter(|&k| k != RoomKind::Balcony).map(tint).next().unwrap_or(Colour::WHITE);
    let glazed = matches!(opening.kind, OpeningKind::Window | OpeningKind::BalconyDoor);
    fill(canvas, &hole, Ink::filled(if glazed { Colour::WHITE } else { floor }));
    let (near, far) = if opening.vertical { (hole.x0, hole.x1) } else { (hole.y0, hole.y1) };
    let (near, far) = (metres(near), metres(far));
    let mut line = |across: f32, ink: Ink| {
        canvas.line(&[at(opening, metres(opening.from), across), at(opening, metres(opening.to), across)], ink);
    };
    match opening.kind {
        OpeningKind::Passage => [near, far].into_iter().for_each(|v| line(v, Ink::line(FAINT, THIN).dashed(0.08))),
        OpeningKind::Window => {
            let middle = (near + far) / 2.0;
            [near, far, middle - 0.025, middle + 0.025].into_iter().for_each(|v| line(v, Ink::line(LINE, THIN)));
        }
        OpeningKind::BalconyDoor => [near, far].into_iter().for_each(|v| line(v, Ink::line(LINE, THIN))),
        OpeningKind::Door | OpeningKind::Entrance => {}
    }
}

/// Draws an open leaf and the quarter circle it sweeps.
fn leaf(canvas: &mut Canvas, opening: &PlanOpening) {
    if !opening.has_leaf() {
        return;
    }
    let away = if opening.opens_high { 1.0 } else { -1.0 };
    let face = metres(opening.at) + away * metres(1);
    let (hinge, latch) = match opening.hinge_low {
        true => (metres(opening.from), metres(opening.to)),
        false => (metres(opening.to), metres(opening.from)),
    };
    let width = metres(opening.width());
    let (centre, tip) = (at(opening, hinge, face), at(opening, hinge, face + away * width));
    sweep(canvas, centre, at(opening, latch, face), tip);
    let thick = at(opening, hinge + 0.04 * (latch - hinge).signum(), face);
    let corner = [tip[0] + thick[0] - centre[0], tip[1] + thick[1] - centre[1]];
    canvas.polygon(&[centre, tip, corner, thick], Ink::filled(Colour::WHITE).outlined(LINE, THIN));
    if opening.kind == OpeningKind::Entrance {
        arrow(canvas, opening);
    }
}

/// Draws the shorter arc around a centre from one point to another.
fn sweep(canvas: &mut Canvas, centre: Point, from: Point, to: Point) {
    let angle = |p: Point| (p[1] - centre[1]).angle_to(p[0] - centre[0]);
    let (start, mut turn) = (angle(from), angle(to) - angle(from));
    if turn > PI {
        turn -= TAU;
    } else if turn < -PI {
        turn += TAU;
    }
    let radius = (from[0] - centre[0]).hypotenuse(from[1] - centre[1]);
    canvas.arc(centre, radius, start, start + turn, Ink::line(FAINT, THIN));
}

/// Draws an arrow in front of the entrance that points inwards.
fn arrow(canvas: &mut Canvas, opening: &PlanOpening) {
    let inward = if opening.high.is_some() { 1.0 } else { -1.0 };
    let middle = metres(opening.from + opening.to) / 2.0;
    let tip = metres(opening.at) - inward * 0.4;
    let base = tip - inward * 0.28;
    let corners = [at(opening, middle - 0.17, base), at(opening, middle + 0.17, base), at(opening, middle, tip)];
    canvas.polygon(&corners, Ink::filled(Colour::hex(0xb03a2e)));
}

/// Draws the name and area of a room: at the centre of its largest rectangle, or where the text
/// covers the least furniture.
fn label(canvas: &mut Canvas, room: &Room, taken: &[Area]) {
    let (name, area) = (room.kind.title(), format!("{:.1} m²", room.area()));
    let one = Canvas::text_width(1.0, name).max(0.8 * Canvas::text_width(1.0, &area));
    let places = SIZES.iter().filter_map(|&size| {
        let half = (one * size / 2.0 + 0.04, 1.15 * size);
        free_place(room, half, taken).map(|(covered, place)| (covered / (half.0 * half.1), size, place))
    });
    // A smaller text is used only if it covers much less.
    let cost = |&(covered, size, _): &(f32, f32, Point)| covered + 3.0 * (SIZES[0] - size);
    let Some((_, size, [x, y])) = places.min_by(|a, b| cost(a).total_cmp(&cost(b))) else { return };
    let half = [one * size / 2.0 + 0.03, 1.15 * size];
    let paper = Ink::filled(Colour::WHITE.faded(0.7));
    canvas.rectangle([x - half[0], y - half[1]], [x + half[0], y + half[1]], paper);
    canvas.text([x, y + 0.12 * size], size, Anchor::Middle, Colour::BLACK, name);
    canvas.text([x, y - 0.92 * size], 0.8 * size, Anchor::Middle, LINE, &area);
}

/// The position where a label of this half width and height covers the least, with the covered
/// area, m². `None` if it does not fit.
fn free_place(room: &Room, half: (f32, f32), taken: &[Area]) -> Option<(f32, Point)> {
    let largest = room.net().into_iter().max_by_key(|r| (r.width() * r.depth(), r.x0, r.y0))?;
    let middle = Area::from_rect(&largest).centre();
    let rated = room.net().into_iter().flat_map(|r| places(&Area::from_rect(&r), half)).map(|[x, y]| {
        let own = Area::around(x, y, half.0, half.1);
        let covered: f32 = taken.iter().map(|t| covered_by(t, &own)).sum();
        (covered + 0.01 * (x - middle.0).hypotenuse(y - middle.1), covered, [x, y])
    });
    let best = rated.min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, covered, place)| (covered, place))
}

/// The possible centres of a label in a rectangle, ten centimetres apart.
fn places(net: &Area, half: (f32, f32)) -> Vec<Point> {
    let along = |low: f32, high: f32| {
        let spare = (high - low).max(-0.01);
        let steps = if spare < 0.0 { 0 } else { (spare / 0.1) as usize + 1 };
        let from = (low + high - 0.1 * (steps as f32 - 1.0)) / 2.0;
        (0..steps).map(move |i| from + 0.1 * i as f32)
    };
    let across = || along(net.y0 + half.1, net.y1 - half.1);
    along(net.x0 + half.0, net.x1 - half.0).flat_map(|x| across().map(move |y| [x, y])).collect()
}

/// The area of the intersection of two rectangles, m².
fn covered_by(a: &Area, b: &Area) -> f32 {
    let overlap = |low: f32, high: f32| (high - low).max(0.0);
    overlap(a.x0.max(b.x0), a.x1.min(b.x1)) * overlap(a.y0.max(b.y0), a.y1.min(b.y1))
}

/// Draws the title, as large as it fits.
pub(super) fn heading(canvas: &mut Canvas, low: Point, high: Point, title: &str) {
    let room = high[0] - low[0] - 2.0 * MARGIN;
    let size = (room / Canvas::text_width(1.0, title)).min(0.34);
    canvas.text([low[0] + MARGIN, high[1] - 0.75], size, Anchor::Start, Colour::BLACK, title);
}

/// Draws a scale bar of three metres.
pub(super) fn scale(canvas: &mut Canvas, from: Point) {
    let metre = |i: usize| from[0] + 0.5 * i as f32;
    for i in 0..6 {
        let fill = if i % 2 == 0 { LINE } else { Colour::WHITE };
        canvas.rectangle([metre(i), from[1]], [metre(i + 1), from[1] + 0.1], Ink::filled(fill).outlined(LINE, THIN));
    }
    for (i, text) in [(0, "0"), (2, "1"), (4, "2"), (6, "3 m")] {
        canvas.text([metre(i) - 0.06, from[1] + 0.18], 0.2, Anchor::Start, LINE, text);
    }
}
