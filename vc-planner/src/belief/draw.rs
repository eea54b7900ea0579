//! Drawing a belief as SVG.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use vc_graph::{NodeId, Place};

use super::Belief;

/// Width of a column and height of a row, pixels.
const CELL: (f64, f64) = (26.0, 15.0);
/// Space for the names of places and of things, pixels.
const NAMES: (f64, f64) = (230.0, 120.0);

impl Belief {
    /// A table of places and things as SVG: a row for each place where one of the things can be, grouped by
    /// room, and a column for each thing. The darker a field, the likelier the thing is there, relative to its
    /// likeliest place; a dot marks the place in the sampled state; green fields have been seen. A tooltip on
    /// each field tells the numbers.
    ///
    /// Costs a look at all places for each thing. Things that are not in the scene are left out.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_planner::Belief;
    ///
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let svg = Belief::in_known_home(&scene.build(), me, 0).to_svg(&[milk]);
    /// assert!(svg.contains("inside fridge"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_svg(&self, things: &[NodeId]) -> String {
        let things: Vec<NodeId> = things.iter().copied().filter(|id| self.graph.node(*id).is_some()).collect();
        let chances: Vec<Vec<(Place, f64)>> = things.iter().map(|id| self.distribution(*id)).collect();
        let rows = self.rows(&chances);
        let (width, height) =
            (NAMES.0 + CELL.0 * (things.len() as f64 + 2.0), NAMES.1 + CELL.1 * (rows.len() as f64 + 1.0));
        let mut svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}' width='{width}' \
             font-family='sans-serif' font-size='11'>\n<rect width='100%' height='100%' fill='white'/>\n"
        );
        for (column, &id) in things.iter().enumerate() {
            let (x, y) = (NAMES.0 + CELL.0 * (column as f64 + 0.6), NAMES.1 - 6.0);
            let label = self.graph.label(id);
            let _ = writeln!(svg, "<text transform='translate({x} {y}) rotate(-55)'>{label}</text>");
        }
        for (number, row) in rows.iter().enumerate() {
            let y = NAMES.1 + CELL.1 * number as f64;
            let (name, x, weight) = match row {
                Row::Room(room) => (room.map_or_else(|| "no room".into(), |r| self.name(r)), 4.0, "bold"),
                Row::Place(place) => (format!("{} {}", place.relation, self.name(place.at)), 16.0, "normal"),
            };
            let _ = writeln!(svg, "<text x='{x}' y='{}' font-weight='{weight}'>{name}</text>", y + 11.0);
            if let Row::Place(place) = row {
                self.draw_row(&mut svg, y, *place, &things, &chances);
            }
        }
        svg.push_str("</svg>\n");
        svg
    }

    fn name(&self, id: NodeId) -> String {
        self.graph.label(id).to_string()
    }

    /// The rooms, each with its places where any of the things can be.
    fn rows(&self, chances: &[Vec<(Place, f64)>]) -> Vec<Row> {
        let mut rooms: BTreeMap<Option<NodeId>, Vec<Place>> = BTreeMap::new();
        for (place, _) in chances.iter().flatten().filter(|(_, chance)| *chance > 0.0) {
            rooms.entry(self.graph.room_of(place.at)).or_default().push(*place);
        }
        let mut rows = Vec::new();
        for (room, mut places) in rooms {
            places.sort_unstable_by_key(|p| (p.at, p.relation));
            places.dedup();
            rows.push(Row::Room(room));
            rows.extend(places.into_iter().map(Row::Place));
        }
        rows
    }

    fn draw_row(&self, svg: &mut String, y: f64, place: Place, things: &[NodeId], chances: &[Vec<(Place, f64)>]) {
        for (column, (&id, all)) in things.iter().zip(chances).enumerate() {
            let Some((_, chance)) = all.iter().find(|(p, _)| *p == place) else { continue };
            let most = all.first().map_or(1.0, |(_, most)| *most);
            let (x, missing) = (NAMES.0 + CELL.0 * column as f64, self.is_missing(id));
            let colour = if missing { "#1f6feb" } else { "#2da44e" };
            let _ = writeln!(
                svg,
                "<rect x='{x}' y='{y}' width='{}' height='{}' fill='{colour}' fill-opacity='{:.3}'>\
                 <title>{}: {:.1}%</title></rect>",
                CELL.0 - 2.0,
                CELL.1 - 2.0,
                chance / most,
                self.graph.label(id),
                100.0 * chance
            );
            if missing && self.graph.places(id).any(|p| p == place) {
                let (x, y) = (x + CELL.0 / 2.0 - 1.0, y + CELL.1 / 2.0 - 1.0);
                let _ = writeln!(svg, "<circle cx='{x}' cy='{y}' r='3' fill='#bc4c00'/>");
            }
        }
    }
}

/// A row of the table.
enum Row {
    Room(Option<NodeId>),
    Place(Place),
}
