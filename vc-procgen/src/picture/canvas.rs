//! Flat drawings, written as SVG or rasterised.

use std::fmt::Write;

use font8x8::legacy::LATIN_LEGACY;
use font8x8::{BASIC_FONTS, UnicodeFonts};
use tiny_skia::{FillRule, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};
use vc_graph::portable::Portable;
use vc_graph::srgb;

use super::image::{Image, PictureError};

/// A point of a drawing: x to the right, y up, in the drawing's own unit.
pub type Point = [f32; 2];

/// The largest side of an image, pixels.
const LARGEST: usize = 32_767;

/// The width of a letter relative to its height.
const LETTER: f32 = 0.6;

/// A colour: sRGB bytes and opacity from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Colour {
    /// Red, green, blue.
    pub rgb: [u8; 3],
    /// The opacity: 1 hides everything below, 0 is invisible.
    pub opacity: f32,
}

/// The style of a shape: filled, with an outline, or both.
///
/// ```
/// use vc_procgen::picture::{Colour, Ink};
/// let ink = Ink::filled(Colour::WHITE).outlined(Colour::BLACK, 0.02).dashed(0.1);
/// assert_eq!((ink.fill, ink.width, ink.dash), (Some(Colour::WHITE), 0.02, 0.1));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ink {
    /// The fill colour.
    pub fill: Option<Colour>,
    /// The line colour.
    pub line: Option<Colour>,
    /// The line width, in the drawing's unit.
    pub width: f32,
    /// The length of dashes and of the gaps between them; zero for a solid line.
    pub dash: f32,
}

/// The point of a text that is at the given position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Anchor {
    /// The start of the baseline.
    #[default]
    Start,
    /// The middle of the baseline.
    Middle,
    /// The end of the baseline.
    End,
}

/// A drawing: later shapes are on top.
///
/// ```
/// use vc_procgen::picture::{Anchor, Canvas, Colour, Ink};
/// let mut plan = Canvas::new([0.0, 0.0], [6.0, 4.0]);
/// plan.polygon(&[[1.0, 1.0], [5.0, 1.0], [5.0, 3.0]], Ink::filled(Colour::hex(0xd9b374)));
/// plan.text([3.0, 2.0], 0.3, Anchor::Middle, Colour::BLACK, "kitchen");
/// assert!(plan.to_svg(600).starts_with("<svg"));
/// assert_eq!(plan.to_image(600)?.height, 400);
/// # Ok::<(), vc_procgen::picture::PictureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Canvas {
    low: Point,
    high: Point,
    background: Colour,
    marks: Vec<Mark>,
}

#[derive(Debug, Clone, PartialEq)]
enum Mark {
    Rings { rings: Vec<Vec<Point>>, closed: bool, ink: Ink },
    Text { at: Point, size: f32, colour: Colour, text: String },
}

impl Mark {
    fn moved(&self, by: Point) -> Self {
        let moved = |point: &Point| [point[0] + by[0], point[1] + by[1]];
        match self {
            Self::Rings { rings, closed, ink } => {
                let rings = rings.iter().map(|ring| ring.iter().map(moved).collect()).collect();
                Self::Rings { rings, closed: *closed, ink: *ink }
            }
            Self::Text { at, size, colour, text } => {
                Self::Text { at: moved(at), size: *size, colour: *colour, text: text.clone() }
            }
        }
    }
}

impl Colour {
    /// Black.
    pub const BLACK: Self = Self::hex(0);
    /// White.
    pub const WHITE: Self = Self::hex(0xff_ffff);

    /// An opaque colour from `0xrrggbb`.
    ///
    /// ```
    /// use vc_procgen::picture::Colour;
    /// assert_eq!(Colour::hex(0x1d3f63).rgb, [0x1d, 0x3f, 0x63]);
    /// ```
    pub const fn hex(rgb: u32) -> Self {
        Self { rgb: [(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8], opacity: 1.0 }
    }

    /// The colour with another opacity.
    #[must_use]
    pub fn faded(self, opacity: f32) -> Self {
        Self { opacity: opacity.clamp(0.0, 1.0), ..self }
    }

    fn css(self) -> String {
        let [r, g, b] = self.rgb;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    fn paint(self) -> Paint<'static> {
        let [r, g, b] = self.rgb;
        let mut paint = Paint::default();
        paint.set_color_rgba8(r, g, b, (self.opacity * 255.0).round() as u8);
        paint
    }
}

/// Converts a linear value to an sRGB byte.
pub(super) fn encoded(value: f32) -> u8 {
    (srgb::from_linear(value.clamp(0.0, 1.0)) * 255.0).round() as u8
}

impl Ink {
    /// Filled, without an outline.
    pub fn filled(colour: Colour) -> Self {
        Self { fill: Some(colour), ..Self::default() }
    }

    /// A line of the given width, in the drawing's unit.
    pub fn line(colour: Colour, width: f32) -> Self {
        Self { line: Some(colour), width, ..Self::default() }
    }

    /// The same with an outline.
    #[must_use]
    pub fn outlined(self, colour: Colour, width: f32) -> Self {
        Self { line: Some(colour), width, ..self }
    }

    /// The same with a dashed line; `dash` is in the drawing's unit.
    #[must_use]
    pub fn dashed(self, dash: f32) -> Self {
        Self { dash, ..self }
    }
}

impl Canvas {
    /// An empty white drawing of the area between two corners.
    pub fn new(low: Point, high: Point) -> Self {
        Self { low, high, background: Colour::WHITE, marks: Vec::new() }
    }

    /// The ratio of width to height.
    pub fn aspect(&self) -> f32 {
        (self.high[0] - self.low[0]) / (self.high[1] - self.low[1])
    }

    /// Sets the background colour.
    pub fn background(&mut self, colour: Colour) {
        self.background = colour;
    }

    /// Draws a closed outline.
    pub fn polygon(&mut self, outline: &[Point], ink: Ink) {
        self.region(outline, &[], ink);
    }

    /// Draws a closed outline with holes.
    ///
    /// ```
    /// use vc_procgen::picture::{Canvas, Colour, Ink};
    /// let mut wall = Canvas::new([0.0, 0.0], [4.0, 3.0]);
    /// let window = vec![[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
    /// wall.region(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]], &[window], Ink::filled(Colour::BLACK));
    /// let image = wall.to_image(40)?;
    /// assert_eq!((image.pixel(15, 15), image.pixel(30, 15)), (Some([255; 3]), Some([0; 3])));
    /// # Ok::<(), vc_procgen::picture::PictureError>(())
    /// ```
    pub fn region(&mut self, outline: &[Point], holes: &[Vec<Point>], ink: Ink) {
        let rings = std::iter::once(outline.to_vec()).chain(holes.iter().cloned()).collect();
        self.marks.push(Mark::Rings { rings, closed: true, ink });
    }

    /// Draws a rectangle between two corners.
    pub fn rectangle(&mut self, low: Point, high: Point, ink: Ink) {
        self.polygon(&[low, [high[0], low[1]], high, [low[0], high[1]]], ink);
    }

    /// Draws a line through points.
    ///
    /// ```
    /// use vc_procgen::picture::{Canvas, Colour, Ink};
    /// let mut path = Canvas::new([0.0, 0.0], [2.0, 2.0]);
    /// path.line(&[[0.0, 1.0], [2.0, 1.0]], Ink::line(Colour::BLACK, 0.5));
    /// assert_eq!(path.to_image(20)?.pixel(10, 10), Some([0; 3]));
    /// # Ok::<(), vc_procgen::picture::PictureError>(())
    /// ```
    pub fn line(&mut self, points: &[Point], ink: Ink) {
        self.marks.push(Mark::Rings { rings: vec![points.to_vec()], closed: false, ink });
    }

    /// Draws a circle.
    pub fn circle(&mut self, centre: Point, radius: f32, ink: Ink) {
        self.polygon(&bow(centre, radius, 0.0, std::f32::consts::TAU), ink);
    }

    /// Draws an arc of a circle between two angles, which are counted from x towards y, radians.
    pub fn arc(&mut self, centre: Point, radius: f32, from: f32, to: f32, ink: Ink) {
        self.line(&bow(centre, radius, from, to), ink);
    }

    /// Draws one line of text; `size` is the height of its letters in the drawing's unit. Letters
    /// are 0.6 times as wide; those missing in the bitmap font appear as `?`.
    pub fn text(&mut self, at: Point, size: f32, anchor: Anchor, colour: Colour, text: &str) {
        let wide = Self::text_width(size, text);
        let back = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => wide / 2.0,
            Anchor::End => wide,
        };
        self.marks.push(Mark::Text { at: [at[0] - back, at[1]], size, colour, text: text.to_owned() });
    }

    /// Draws another drawing on top, moved by an offset; its background is left out.
    ///
    /// ```
    /// use vc_procgen::picture::{Canvas, Colour, Ink};
    /// let mut tile = Canvas::new([0.0, 0.0], [1.0, 1.0]);
    /// tile.rectangle([0.0, 0.0], [1.0, 1.0], Ink::filled(Colour::BLACK));
    /// let mut sheet = Canvas::new([0.0, 0.0], [4.0, 1.0]);
    /// sheet.paste(&tile, [2.0, 0.0]);
    /// let image = sheet.to_image(40)?;
    /// assert_eq!((image.pixel(5, 5), image.pixel(25, 5)), (Some([255; 3]), Some([0; 3])));
    /// # Ok::<(), vc_procgen::picture::PictureError>(())
    /// ```
    pub fn paste(&mut self, other: &Self, by: Point) {
        self.marks.extend(other.marks.iter().map(|mark| mark.moved(by)));
    }

    /// The width of a text, in the unit of `size`.
    ///
    /// ```
    /// use vc_procgen::picture::Canvas;
    /// assert_eq!(Canvas::text_width(1.0, "bed"), 3.0 * Canvas::text_width(1.0, "b"));
    /// ```
    pub fn text_width(size: f32, text: &str) -> f32 {
        text.chars().count() as f32 * size * LETTER
    }

    /// Pixels per unit, and the height in pixels for a width in pixels.
    fn scale(&self, width: usize) -> (f32, usize) {
        let scale = width as f32 / (self.high[0] - self.low[0]);
        (scale, (scale * (self.high[1] - self.low[1])).round() as usize)
    }

    /// The drawing as an SVG file, with a nominal width of `width` pixels.
    pub fn to_svg(&self, width: usize) -> String {
        let (scale, height) = self.scale(width);
        let size = format!("width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\"");
        let mut svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {size}>\n");
        let back = self.background.css();
        let _ = writeln!(svg, "<rect width=\"{width}\" height=\"{height}\" fill=\"{back}\"/>");
        for mark in &self.marks {
            let place = |p: Point| self.place(p, scale);
            let _ = match mark {
                Mark::Rings { rings, closed, ink } => write_rings(&mut svg, rings, *closed, *ink, scale, place),
                Mark::Text { at, size, colour, text } => write_text(&mut svg, place(*at), size * scale, *colour, text),
            };
        }
        svg.push_str("</svg>\n");
        svg
    }

    /// Rasterises the drawing, `width` pixels wide.
    ///
    /// ```
    /// use vc_procgen::picture::{Canvas, PictureError};
    /// let canvas = Canvas::new([0.0, 0.0], [2.0, 1.0]);
    /// assert_eq!(canvas.to_image(64)?.height, 32);
    /// assert!(matches!(canvas.to_image(0), Err(PictureError::Size { .. })));
    /// # Ok::<(), PictureError>(())
    /// ```
    ///
    /// # Errors
    /// [`PictureError::Size`] if it would be empty or too large.
    pub fn to_image(&self, width: usize) -> Result<Image, PictureError> {
        let (scale, height) = self.scale(width);
        let fits = (1..=LARGEST).contains(&width) && (1..=LARGEST).contains(&height);
        let pixels = if fits { Pixmap::new(width as u32, height as u32) } else { None };
        let mut pixels = pixels.ok_or(PictureError::Size { width, height })?;
        let [r, g, b] = self.background.rgb;
        pixels.fill(tiny_skia::Color::from_rgba8(r, g, b, 255));
        for mark in &self.marks {
            self.draw(mark, scale, &mut pixels);
        }
        let rgb = pixels.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
        Ok(Image { width, height, rgb })
    }

    /// The drawing as a PNG file, `width` pixels wide.
    ///
    /// # Errors
    /// [`PictureError`] if it would be empty or too large.
    pub fn to_png(&self, width: usize) -> Result<Vec<u8>, PictureError> {
        self.to_image(width)?.to_png()
    }

    /// Converts from the drawing's unit to pixels, y down.
    fn place(&self, p: Point, scale: f32) -> Point {
        [(p[0] - self.low[0]) * scale, (self.high[1] - p[1]) * scale]
    }

    fn draw(&self, mark: &Mark, scale: f32, pixels: &mut Pixmap) {
        let place = |p: Point| self.place(p, scale);
        match mark {
            Mark::Rings { rings, closed, ink } => {
                if let Some(path) = ring_path(rings, *closed, place) {
                    fill_and_line(pixels, &path, *ink, scale);
                }
            }
            Mark::Text { at, size, colour, text } => {
                if let Some(path) = text_path(place(*at), size * scale, text) {
                    pixels.fill_path(&path, &colour.paint(), FillRule::Winding, Transform::identity(), None);
                }
            }
        }
    }
}

/// Points of an arc, at most five degrees apart.
fn bow(centre: Point, radius: f32, from: f32, to: f32) -> Vec<Point> {
    let steps = ((to - from).abs().to_degrees() / 5.0).ceil().clamp(1.0, 720.0) as usize;
    let angle = |i: usize| from + (to - from) * i as f32 / steps as f32;
    let at = |a: f32| [centre[0] + radius * a.cosine(), centre[1] + radius * a.sine()];
    (0..=steps).map(|i| at(angle(i))).collect()
}

fn ring_path(rings: &[Vec<Point>], closed: bool, place: impl Fn(Point) -> Point) -> Option<Path> {
    let mut path = PathBuilder::new();
    for ring in rings {
        for (i, [x, y]) in ring.iter().map(|&p| place(p)).enumerate() {
            if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        if closed {
            path.close();
        }
    }
    path.finish()
}

fn fill_and_line(pixels: &mut Pixmap, path: &Path, ink: Ink, scale: f32) {
    let same = Transform::identity();
    if let Some(fill) = ink.fill {
        pixels.fill_path(path, &fill.paint(), FillRule::EvenOdd, same, None);
    }
    if let Some(line) = ink.line {
        let dash = ink.dash * scale;
        let dash = if dash > 0.0 { StrokeDash::new(vec![dash, dash], 0.0) } else { None };
        let stroke = Stroke { width: ink.width * scale, dash, ..Stroke::default() };
        pixels.stroke_path(path, &line.paint(), &stroke, same, None);
    }
}

/// The squares that make up a text in the bitmap font.
fn text_path(at: Point, size: f32, text: &str) -> Option<Path> {
    let (dx, dy) = (size * LETTER / 8.0, size / 7.0);
    let mut path = PathBuilder::new();
    for (i, letter) in text.chars().enumerate() {
        for (y, bits) in rows(letter).into_iter().enumerate() {
            for x in (0..8).filter(|x| bits & (1 << x) != 0) {
                let corner = (at[0] + (8 * i + x) as f32 * dx, at[1] - (7.0 - y as f32) * dy);
                let square = tiny_skia::Rect::from_xywh(corner.0, corner.1, dx, dy);
                square.into_iter().for_each(|s| path.push_rect(s));
            }
        }
    }
    path.finish()
}

/// The eight rows of bits of a letter. The table of Latin letters is indexed by position because
/// its look-up by letter does not find `²`.
fn rows(letter: char) -> [u8; 8] {
    let latin = (letter as usize).checked_sub(0xa0).and_then(|i| LATIN_LEGACY.get(i)).copied();
    latin.or_else(|| BASIC_FONTS.get(letter)).or_else(|| BASIC_FONTS.get('?')).unwrap_or_default()
}

fn write_rings(
    svg: &mut String,
    rings: &[Vec<Point>],
    closed: bool,
    ink: Ink,
    scale: f32,
    place: impl Fn(Point) -> Point,
) -> std::fmt::Result {
    write!(svg, "<path d=\"")?;
    for ring in rings {
        for (i, [x, y]) in ring.iter().map(|&p| place(p)).enumerate() {
            write!(svg, "{}{x:.2} {y:.2}", if i == 0 { "M" } else { "L" })?;
        }
        svg.push_str(if closed { "Z" } else { "" });
    }
    svg.push_str("\" fill-rule=\"evenodd\"");
    write_colour(svg, "fill", ink.fill)?;
    write_colour(svg, "stroke", ink.line)?;
    if ink.line.is_some() {
        write!(svg, " stroke-width=\"{:.2}\"", ink.width * scale)?;
    }
    if ink.dash > 0.0 {
        write!(svg, " stroke-dasharray=\"{:.2}\"", ink.dash * scale)?;
    }
    writeln!(svg, "/>")
}

fn write_colour(svg: &mut String, what: &str, colour: Option<Colour>) -> std::fmt::Result {
    let Some(colour) = colour else { return write!(svg, " {what}=\"none\"") };
    write!(svg, " {what}=\"{}\"", colour.css())?;
    if colour.opacity < 1.0 {
        write!(svg, " {what}-opacity=\"{:.3}\"", colour.opacity)?;
    }
    Ok(())
}

/// The length is specified so that the text takes as much space in the viewer's font as in ours.
fn write_text(svg: &mut String, at: Point, size: f32, colour: Colour, text: &str) -> std::fmt::Result {
    let safe = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let wide = Canvas::text_width(size, text);
    let [x, y] = at;
    write!(svg, "<text x=\"{x:.2}\" y=\"{y:.2}\" font-family=\"monospace\" font-size=\"{:.2}\"", size * 1.25)?;
    write!(svg, " textLength=\"{wide:.2}\" lengthAdjust=\"spacingAndGlyphs\"")?;
    write_colour(svg, "fill", Some(colour))?;
    writeln!(svg, ">{safe}</text>")
}
