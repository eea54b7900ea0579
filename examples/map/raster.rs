//! Drawings as pixels.

use crate::support::Complaint;
use font8x8::UnicodeFonts;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint as Brush, Path, PathBuilder, Pixmap, Rect, Stroke, StrokeDash, Transform,
};
use vc_map::Point;
use vc_map::picture::{Colour, Drawing, GROUND, Paint, Text};

/// The largest side of a picture, pixels.
const LARGEST: f64 = 12_000.0;

/// The scale at which a whole drawing fits into the largest picture: that which is asked for, or a smaller one.
pub(crate) fn scale(drawing: &Drawing, asked: f64) -> f64 {
    let [low, high] = drawing.bounds;
    asked.min(LARGEST / (high.x - low.x).max(high.y - low.y).max(1.0))
}

/// A drawing as PNG, with a scale in pixels for a metre.
pub(crate) fn png(drawing: &Drawing, scale: f64) -> Result<Vec<u8>, Complaint> {
    encode(&canvas(drawing, scale)?)
}

/// A drawing as pixels, with so many for a metre.
pub(crate) fn canvas(drawing: &Drawing, scale: f64) -> Result<Pixmap, Complaint> {
    let [low, high] = drawing.bounds;
    let side = |metres: f64| (metres * scale).clamp(1.0, LARGEST) as u32;
    let mut canvas = Pixmap::new(side(high.x - low.x), side(high.y - low.y))
        .ok_or_else(|| Complaint::new("the picture has no pixels: give a larger --scale"))?;
    canvas.fill(tiny_skia::Color::from_rgba8(GROUND[0], GROUND[1], GROUND[2], 255));
    for shape in &drawing.shapes {
        let closed = matches!(shape.paint, Paint::Fill(_));
        let Some(path) = path(drawing, &shape.paths, scale, closed) else { continue };
        match &shape.paint {
            Paint::Fill(colour) => {
                canvas.fill_path(&path, &brush(*colour), FillRule::EvenOdd, Transform::identity(), None)
            }
            Paint::Line { colour, width, dash, round } => {
                let stroke = Stroke {
                    width: (width * scale) as f32,
                    dash: dash.and_then(|lengths| StrokeDash::new(lengths.map(|l| (l * scale) as f32).to_vec(), 0.0)),
                    line_cap: if *round { LineCap::Round } else { LineCap::Butt },
                    line_join: LineJoin::Round,
                    ..Stroke::default()
                };
                canvas.stroke_path(&path, &brush(*colour), &stroke, Transform::identity(), None);
            }
            _ => {}
        }
    }
    drawing.texts.iter().for_each(|text| name(&mut canvas, drawing, text, scale));
    legend(&mut canvas, drawing, scale);
    Ok(canvas)
}

pub(crate) fn brush(colour: Colour) -> Brush<'static> {
    let mut brush = Brush::default();
    brush.set_color_rgba8(colour[0], colour[1], colour[2], 255);
    brush.anti_alias = true;
    brush
}

fn path(drawing: &Drawing, paths: &[Vec<Point>], scale: f64, closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for points in paths {
        for (index, point) in points.iter().enumerate() {
            let [x, y] = drawing.pixel(point, scale);
            if index == 0 { builder.move_to(x as f32, y as f32) } else { builder.line_to(x as f32, y as f32) }
        }
        if closed {
            builder.close();
        }
    }
    builder.finish()
}

/// A text of letters of eight by eight squares, turned about the middle of its base line.
fn letters(canvas: &mut Pixmap, text: &str, [x, y]: [f64; 2], degrees: f64, size: f64, colour: Colour, centred: bool) {
    let unit = size / 8.0;
    let count = text.chars().count() as f64;
    let left = if centred { -count * size * 0.5 } else { 0.0 };
    let turn = Transform::from_rotate(degrees as f32).post_translate(x as f32, y as f32);
    for (index, character) in text.chars().enumerate() {
        let latin = font8x8::LATIN_FONTS.get(character);
        let Some(rows) = font8x8::BASIC_FONTS.get(character).or(latin).or(font8x8::BASIC_FONTS.get('?')) else {
            continue;
        };
        for (row, bits) in rows.iter().enumerate() {
            for column in (0..8).filter(|column| bits >> column & 1 == 1) {
                let at = [left + (index as f64) * size + f64::from(column) * unit, (row as f64 - 7.0) * unit];
                let side = (unit * 1.05) as f32;
                if let Some(square) = Rect::from_xywh(at[0] as f32, at[1] as f32, side, side) {
                    canvas.fill_rect(square, &brush(colour), turn, None);
                }
            }
        }
    }
}

/// The name of a street with a light edge; names that would be too small to read are left out.
fn name(canvas: &mut Pixmap, drawing: &Drawing, text: &Text, scale: f64) {
    let size = text.size * scale;
    if size < 6.0 {
        return;
    }
    let [x, y] = drawing.pixel(&text.at, scale);
    let degrees = -text.heading.to_degrees();
    for [dx, dy] in [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
        letters(canvas, &text.text, [x + dx, y + dy], degrees, size, [255, 255, 255], true);
    }
    letters(canvas, &text.text, [x, y], degrees, size, text.colour, true);
}

fn legend(canvas: &mut Pixmap, drawing: &Drawing, scale: f64) {
    let (step, size) = (16.0, 8.0);
    let tall = step * (drawing.legend.len() as f64 + 2.0);
    let top = f64::from(canvas.height()) - tall - 8.0;
    let rect = |canvas: &mut Pixmap, [x, y, w, h]: [f64; 4], colour| {
        if let Some(rect) = Rect::from_xywh(x as f32, y as f32, w as f32, h as f32) {
            canvas.fill_rect(rect, &brush(colour), Transform::identity(), None);
        }
    };
    rect(canvas, [8.0, top, (drawing.bar * scale + 60.0).max(250.0), tall], [255, 255, 255]);
    for (row, entry) in drawing.legend.iter().enumerate() {
        let y = top + step * row as f64 + 4.0;
        rect(canvas, [14.0, y, 14.0, 11.0], entry.colour);
        letters(canvas, entry.meaning, [34.0, y + 9.5], 0.0, size, [32, 32, 36], false);
    }
    let bottom = f64::from(canvas.height()) - 16.0;
    rect(canvas, [14.0, bottom, drawing.bar * scale, 3.0], [32, 32, 36]);
    letters(canvas, &format!("{} m", drawing.bar), [14.0, bottom - 4.0], 0.0, size, [32, 32, 36], false);
}

fn encode(canvas: &Pixmap) -> Result<Vec<u8>, Complaint> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, canvas.width(), canvas.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let pixels: Vec<u8> = canvas.pixels().iter().flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect();
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(file)
}
