//! Storeys of buildings as drawings: flats with their rooms, doors and windows, other units, stairs and corridors.

use vc_map::Point;
use vc_map::picture::{Colour, Drawing, Entry, Paint, Shape, Text};

use super::{Beyond, CityPlan, Convex, FlatPlan, Unit};
use crate::plan::{CELLS, OpeningKind, PlanOpening, Rect, RoomKind};

/// The margin around a building, the room below it for the legend, the length of the scale, and the thickness of outer walls, metres.
const MARGIN: f64 = 2.0;
const LEGEND: f64 = 8.0;
const BAR: f64 = 5.0;
const WALL: f64 = 0.25;
/// The heights of letters, metres.
const LETTERS: [f64; 2] = [0.42, 0.8];

const WALLS: Colour = [70, 62, 58];
const CORRIDOR: Colour = [222, 220, 216];
const STAIRS: Colour = [186, 180, 172];
const UNIT: Colour = [232, 214, 196];
const GLASS: Colour = [120, 190, 230];
const LEAF: Colour = [150, 90, 50];
const INK: Colour = [60, 60, 60];

fn floor(kind: RoomKind) -> (Colour, &'static str) {
    match kind {
        RoomKind::Living => ([252, 240, 212], "living room"),
        RoomKind::Bedroom | RoomKind::Kids => ([226, 222, 244], "bedroom"),
        RoomKind::Kitchen => ([232, 244, 210], "kitchen"),
        RoomKind::Bathroom | RoomKind::Wc | RoomKind::Laundry => ([206, 232, 244], "bathroom, laundry"),
        RoomKind::Study | RoomKind::Hall | RoomKind::Storage | RoomKind::Balcony => ([244, 244, 242], "hall, storage"),
    }
}

impl CityPlan {
    /// A storey of a building as a drawing with a legend; `None` if there is none. Costs the plans of its flats.
    ///
    /// ```
    /// use vc_procgen::city::{CityPlan, CitySpecification};
    /// let small = CitySpecification { area: 0.2, ..CitySpecification::default() };
    /// let city = CityPlan::generate(&small, vc_graph::Seed(7))?;
    /// let house = city.buildings().iter().position(|building| building.homes() > 6).ok_or("flats")?;
    /// let storey = city.storey_drawing(house, 1).ok_or("a first floor")?;
    /// assert!(storey.legend.iter().any(|entry| entry.meaning == "kitchen"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn storey_drawing(&self, building: usize, storey: usize) -> Option<Drawing> {
        let house = self.buildings.get(building)?;
        let floors: Vec<_> = house.floors(storey).collect();
        let mut corners = floors.iter().flat_map(|(wing, _)| wing.plan.corners().iter().copied());
        let first = corners.next()?;
        let [low, high] = corners.fold([first; 2], |[low, high], corner| [low.inf(&corner), high.sup(&corner)]);
        let margin = nalgebra::Vector2::new(MARGIN, MARGIN);
        let mut drawing =
            Drawing::empty(format!("building {building}, storey {storey}"), [low - margin, high + margin]);
        drawing.bounds[0].y -= LEGEND;
        drawing.bar = BAR;
        for (wing, floor) in &floors {
            fill(&mut drawing, (WALLS, "walls"), wing.plan.corners());
            let inner = wing.plan.inset(None, |beyond| if beyond == Beyond::Inside { 0.0 } else { WALL });
            inner.iter().for_each(|inner| fill(&mut drawing, (CORRIDOR, "corridor, plant"), inner.corners()));
            if let Some(core) = &floor.core {
                fill(&mut drawing, (STAIRS, "stairs, lift"), core.corners());
            }
        }
        for unit in house.units(storey) {
            match self.flat(building, &unit) {
                Some(flat) => draw_flat(&mut drawing, &unit, &flat),
                None => draw_unit(&mut drawing, &unit),
            }
        }
        Some(drawing)
    }
}

fn fill(drawing: &mut Drawing, (colour, meaning): (Colour, &'static str), ring: &[Point]) {
    drawing.shapes.push(Shape { paths: vec![ring.to_vec()], paint: Paint::Fill(colour) });
    if !drawing.legend.iter().any(|entry| entry.colour == colour) {
        drawing.legend.push(Entry { colour, meaning });
    }
}

fn write(drawing: &mut Drawing, at: Point, size: f64, text: String) {
    drawing.texts.push(Text { at, heading: 0.0, size, colour: INK, text });
}

/// A unit without a plan of its rooms.
fn draw_unit(drawing: &mut Drawing, unit: &Unit) {
    let outline: &Convex = &unit.outline;
    fill(drawing, (WALLS, "walls"), outline.corners());
    if let Some(inner) = outline.inset(None, |_| WALL) {
        fill(drawing, (UNIT, "other units"), inner.corners());
    }
    for window in unit.windows.iter().filter(|window| window.storey == unit.storey) {
        let (along, half) = (nalgebra::Vector2::new(-window.out.y, window.out.x), window.size[0] / 2.0);
        let corners = [(-half, 0.0), (half, 0.0), (half, WALL), (-half, WALL)];
        fill(drawing, (GLASS, "window"), &corners.map(|(x, y)| window.at + along * x - window.out * y));
    }
    write(drawing, outline.middle(), LETTERS[1], unit.kind.word().to_owned());
}

fn draw_flat(drawing: &mut Drawing, unit: &Unit, flat: &FlatPlan) {
    let plan = &flat.plan;
    // Beside a flat at a slanted wall there is a rest.
    fill(drawing, (WALLS, "walls"), unit.outline.corners());
    if let Some(inner) = unit.outline.inset(None, |_| WALL) {
        fill(drawing, (CORRIDOR, "corridor, plant"), inner.corners());
    }
    let metres = |cells: i32| f64::from(cells) / f64::from(CELLS);
    let ring = |rect: &Rect| {
        let corners = [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x1, rect.y1), (rect.x0, rect.y1)];
        corners.map(|(x, y)| flat.place(metres(x), metres(y)))
    };
    fill(drawing, (WALLS, "walls"), &ring(&plan.hull().grown(plan.shell)));
    for room in &plan.rooms {
        room.net().iter().for_each(|rect| fill(drawing, floor(room.kind), &ring(rect)));
    }
    for opening in &plan.openings {
        let outer = opening.low.is_none() || opening.high.is_none();
        let [before, behind] =
            [opening.low, opening.high].map(|room| if outer && room.is_none() { plan.shell } else { 1 });
        let gap = opening.across(opening.at - before, opening.at + behind);
        let look = if opening.kind == OpeningKind::Window { (GLASS, "window") } else { (CORRIDOR, "corridor, plant") };
        fill(drawing, look, &ring(&gap));
        draw_leaf(drawing, opening, &|x, y| flat.place(metres(x), metres(y)));
    }
    for room in &plan.rooms {
        let largest = room.net().into_iter().max_by(|a, b| a.area().total_cmp(&b.area())).unwrap_or_default();
        let middle = flat.place(metres(largest.x0 + largest.x1) / 2.0, metres(largest.y0 + largest.y1) / 2.0);
        if room.area() > 3.0 {
            write(drawing, middle, LETTERS[0], format!("{} {:.0}", room.kind.title(), room.area()));
        }
    }
}

/// The leaf of a door, open.
fn draw_leaf(drawing: &mut Drawing, opening: &PlanOpening, place: &dyn Fn(i32, i32) -> Point) {
    let Some(swing) = opening.swing() else { return };
    let (along, far) = (
        if opening.hinge_low { opening.from } else { opening.to },
        if opening.opens_high { opening.at + 1 + swing.short() } else { opening.at - 1 - swing.short() },
    );
    let at = |across: i32| if opening.vertical { place(across, along) } else { place(along, across) };
    let paint = Paint::Line { colour: LEAF, width: 0.06, dash: None, round: false };
    drawing.shapes.push(Shape { paths: vec![vec![at(opening.at), at(far)]], paint });
}
