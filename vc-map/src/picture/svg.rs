//! Drawings as SVG.

use std::fmt::{Display, Write};

use super::{Colour, Drawing, GROUND, Paint, Shape, Text};
use crate::Point;
use crate::format::xml::Xml;

/// The size of the legend's letters, pixels.
const LETTERS: f64 = 13.0;
/// The colour of its letters.
const INK: Colour = [0x20, 0x20, 0x24];

fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

impl Drawing {
    /// The drawing as SVG, with a scale in pixels for a metre: names can be read from 3 on. Costs a line of text for each
    /// shape; [`Self::within`] has an example.
    pub fn svg(&self, scale: f64) -> String {
        let [low, high] = self.bounds;
        let (width, height) = ((high.x - low.x) * scale, (high.y - low.y) * scale);
        let view = format!("0 0 {width:.1} {height:.1}");
        let mut xml = Xml::new(
            "svg",
            &[
                ("xmlns", &"http://www.w3.org/2000/svg"),
                ("width", &format!("{width:.1}")),
                ("height", &format!("{height:.1}")),
                ("viewBox", &view),
            ],
        );
        xml.text("title", &[], &self.title);
        xml.tag("rect", &[("width", &"100%"), ("height", &"100%"), ("fill", &hex(GROUND))]);
        self.shapes.iter().for_each(|shape| self.write_shape(&mut xml, shape, scale));
        self.texts.iter().for_each(|text| self.write_text(&mut xml, text, scale));
        self.write_legend(&mut xml, height, scale);
        xml.finish()
    }

    fn write_shape(&self, xml: &mut Xml, shape: &Shape, scale: f64) {
        let path = self.path(&shape.paths, scale, matches!(shape.paint, Paint::Fill(_)));
        let (colour, width, dash, round) = match &shape.paint {
            Paint::Fill(colour) => {
                return xml.tag("path", &[("d", &path), ("fill", &hex(*colour)), ("fill-rule", &"evenodd")]);
            }
            Paint::Line { colour, width, dash, round } => (colour, width, dash, round),
        };
        let width = format!("{:.2}", width * scale);
        let dash = dash.map_or("none".to_owned(), |[on, off]| format!("{:.2} {:.2}", on * scale, off * scale));
        let attributes: [(&str, &dyn Display); 7] = [
            ("d", &path),
            ("fill", &"none"),
            ("stroke", &hex(*colour)),
            ("stroke-width", &width),
            ("stroke-dasharray", &dash),
            ("stroke-linecap", if *round { &"round" } else { &"butt" }),
            ("stroke-linejoin", &"round"),
        ];
        xml.tag("path", &attributes);
    }

    /// A point in pixels from the upper left corner, with a scale in pixels for a metre.
    pub fn pixel(&self, point: &Point, scale: f64) -> [f64; 2] {
        [(point.x - self.bounds[0].x) * scale, (self.bounds[1].y - point.y) * scale]
    }

    fn path(&self, paths: &[Vec<Point>], scale: f64, closed: bool) -> String {
        let mut text = String::new();
        for points in paths {
            for (index, point) in points.iter().enumerate() {
                let [x, y] = self.pixel(point, scale);
                let _ = write!(text, "{}{x:.2} {y:.2}", if index == 0 { "M" } else { "L" });
            }
            if closed {
                text.push('Z');
            }
        }
        text
    }

    fn write_text(&self, xml: &mut Xml, text: &Text, scale: f64) {
        let [x, y] = self.pixel(&text.at, scale);
        let turn = format!("translate({x:.1} {y:.1}) rotate({:.1})", -text.heading.to_degrees());
        let size = format!("{:.1}", text.size * scale);
        xml.text(
            "text",
            &[
                ("transform", &turn),
                ("font-family", &"sans-serif"),
                ("font-size", &size),
                ("text-anchor", &"middle"),
                ("fill", &hex(text.colour)),
                ("stroke", &"#ffffff"),
                ("stroke-width", &format!("{:.1}", 0.25 * text.size * scale)),
                ("paint-order", &"stroke"),
            ],
            &text.text,
        );
    }

    /// The legend in the lower left corner, with a scale.
    fn write_legend(&self, xml: &mut Xml, height: f64, scale: f64) {
        let step = LETTERS * 1.4;
        let tall = step * (self.legend.len() as f64 + 2.0);
        let top = height - tall - 10.0;
        xml.tag(
            "rect",
            &[
                ("x", &10),
                ("y", &format!("{top:.1}")),
                ("width", &(60.0 + self.bar * scale).max(230.0)),
                ("height", &format!("{tall:.1}")),
                ("fill", &"#ffffff"),
                ("fill-opacity", &0.85),
            ],
        );
        for (row, entry) in self.legend.iter().enumerate() {
            bar(xml, top + step * row as f64 + 5.0, &16, &LETTERS, entry.colour);
            words(xml, top + step * (row as f64 + 1.0) - 3.0, entry.meaning);
        }
        bar(xml, height - 16.0, &format!("{:.1}", self.bar * scale), &3, INK);
        words(xml, top + step * (self.legend.len() as f64 + 1.0) - 3.0, &format!("{} m", self.bar));
    }
}

/// A bar of the legend.
fn bar(xml: &mut Xml, y: f64, width: &dyn Display, height: &dyn Display, colour: Colour) {
    let y = format!("{y:.1}");
    xml.tag("rect", &[("x", &18), ("y", &y), ("width", width), ("height", height), ("fill", &hex(colour))]);
}

/// A text of the legend.
fn words(xml: &mut Xml, y: f64, text: &str) {
    let y = format!("{y:.1}");
    let attributes: [(&str, &dyn Display); 5] =
        [("x", &42), ("y", &y), ("font-family", &"sans-serif"), ("font-size", &LETTERS), ("fill", &hex(INK))];
    xml.text("text", &attributes, text);
}
