//! Maps as drawings: shapes with colours in metres, as SVG here and as pixels by whoever has a rasteriser.
//!
//! ```
//! use vc_map::picture::Drawing;
//! use vc_map::{Building, MapDraft};
//! let mut draft = MapDraft::new("house", 48.1, 11.6);
//! draft.buildings.push(Building::new(vec![[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]], 2));
//! let drawing = Drawing::of(&draft.build()?);
//! assert!(drawing.svg(4.0).starts_with("<?xml"));
//! # Ok::<(), vc_map::MapError>(())
//! ```

mod layers;
mod legend;
mod marks;
mod svg;

use std::collections::BTreeSet;

use crate::{Point, StreetMap};

/// Red, green and blue, sRGB.
pub type Colour = [u8; 3];

/// How the inside or the line of a shape is drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Paint {
    /// Filled; holes are those rings that follow the first.
    Fill(Colour),
    /// A line of a width in metres, with dashes and gaps of some lengths or without.
    Line {
        /// Its colour.
        colour: Colour,
        /// Its width, metres.
        width: f64,
        /// The lengths of dash and gap, metres.
        dash: Option<[f64; 2]>,
        /// Whether its ends are round.
        round: bool,
    },
}

impl Paint {
    fn colour(&self) -> Colour {
        match self {
            Self::Fill(colour) | Self::Line { colour, .. } => *colour,
        }
    }
}

/// A shape of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Its rings, or its line.
    pub paths: Vec<Vec<Point>>,
    /// How it is drawn.
    pub paint: Paint,
}

/// A text of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// The middle of its base line.
    pub at: Point,
    /// Its direction, radians.
    pub heading: f64,
    /// The height of its letters, metres.
    pub size: f64,
    /// Its colour.
    pub colour: Colour,
    /// The text.
    pub text: String,
}

/// A line of the legend: a colour with its meaning.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// The colour.
    pub colour: Colour,
    /// The meaning.
    pub meaning: &'static str,
}

/// A map as shapes, from the lowest to the uppermost, with a legend.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Drawing {
    /// The lower left and upper right corner, metres.
    pub bounds: [Point; 2],
    /// Shapes in the order in which they are drawn.
    pub shapes: Vec<Shape>,
    /// Texts over the shapes.
    pub texts: Vec<Text>,
    /// The legend: colours that occur, with their meaning.
    pub legend: Vec<Entry>,
    /// The length of the scale below the legend, metres.
    pub bar: f64,
    /// The name of the map.
    pub title: String,
}

/// The length of the scale of a map, metres.
const BAR: f64 = 50.0;

/// The colour of the ground.
pub const GROUND: Colour = [242, 239, 233];

impl Drawing {
    /// A drawing without shapes, between two corners.
    ///
    /// ```
    /// use vc_map::picture::Drawing;
    /// let empty = Drawing::empty("storey", [[0.0, 0.0].into(), [20.0, 10.0].into()]);
    /// assert!(empty.shapes.is_empty() && empty.svg(2.0).contains("storey"));
    /// ```
    pub fn empty(title: impl Into<String>, bounds: [Point; 2]) -> Self {
        Self { bounds, shapes: Vec::new(), texts: Vec::new(), legend: Vec::new(), bar: BAR, title: title.into() }
    }

    /// The drawing of a whole map, with a margin of 10 m. Costs some shapes for each road, area and building.
    pub fn of(map: &StreetMap) -> Self {
        let everywhere = [[f64::NEG_INFINITY; 2].into(), [f64::INFINITY; 2].into()];
        let mut drawing = Self::within(map, everywhere);
        // Around everything that is drawn: railways under the ground are not, and reach far.
        let points = || drawing.shapes.iter().flat_map(|shape| &shape.paths).flatten();
        let first = points().next().copied().unwrap_or_else(Point::origin);
        let [low, high] = points().fold([first; 2], |[low, high], point| [low.inf(point), high.sup(point)]);
        let margin = nalgebra::Vector2::new(10.0, 10.0);
        drawing.bounds = [low - margin, high + margin];
        drawing
    }

    /// The drawing of a part of a map, between two corners. Costs a drawing of the whole.
    ///
    /// ```
    /// # use vc_map::picture::Drawing;
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("streets", 48.1, 11.6);
    /// # for y in [0.0, 500.0] {
    /// #     let ends = [[0.0, y], [100.0, y]].map(|at| draft.junction(at, Control::Priority));
    /// #     let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3)], ..CrossSection::default() };
    /// #     draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # }
    /// # let map = draft.build()?; // two streets, 500 m apart
    /// let part = Drawing::within(&map, [[-10.0, -10.0].into(), [110.0, 90.0].into()]);
    /// assert!(part.shapes.len() < Drawing::of(&map).shapes.len());
    /// // Pixels are counted from the upper left corner, here two for a metre.
    /// assert_eq!(part.pixel(&[0.0, 0.0].into(), 2.0), [20.0, 180.0]);
    /// assert!(part.svg(2.0).contains(r#"width="240.0" height="200.0""#));
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn within(map: &StreetMap, bounds: [Point; 2]) -> Self {
        let mut drawing = Self {
            bounds,
            shapes: Vec::new(),
            texts: Vec::new(),
            legend: legend::entries(),
            bar: BAR,
            title: map.name().to_owned(),
        };
        layers::draw(map, &mut drawing);
        let [low, high] = bounds;
        let near = |p: &Point| p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
        drawing.shapes.retain(|shape| shape.paths.iter().flatten().any(near) || crosses(&shape.paths, &bounds));
        drawing.texts.retain(|text| near(&text.at));
        let drawn: BTreeSet<Colour> = drawing.shapes.iter().map(|shape| shape.paint.colour()).collect();
        drawing.legend.retain(|entry| drawn.contains(&entry.colour));
        drawing
    }

    fn fill(&mut self, colour: Colour, paths: Vec<Vec<Point>>) {
        self.shapes.push(Shape { paths, paint: Paint::Fill(colour) });
    }

    fn line(&mut self, colour: Colour, width: f64, points: &[Point]) {
        self.shapes.push(Shape {
            paths: vec![points.to_vec()],
            paint: Paint::Line { colour, width, dash: None, round: false },
        });
    }

    fn dashes(&mut self, colour: Colour, width: f64, dash: [f64; 2], points: &[Point]) {
        let paint = Paint::Line { colour, width, dash: Some(dash), round: false };
        self.shapes.push(Shape { paths: vec![points.to_vec()], paint });
    }
}

/// Whether the box around some paths and another box overlap.
fn crosses(paths: &[Vec<Point>], bounds: &[Point; 2]) -> bool {
    let all = || paths.iter().flatten();
    let Some(first) = all().next() else { return false };
    let (low, high) = all().fold((*first, *first), |(low, high), p| (low.inf(p), high.sup(p)));
    low.x <= bounds[1].x && low.y <= bounds[1].y && high.x >= bounds[0].x && high.y >= bounds[0].y
}
