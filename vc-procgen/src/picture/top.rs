//! Furniture seen from above: the parts of all objects, lower ones first.

use std::f32::consts::TAU;

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::asset::{Part, Shape};
use vc_graph::portable::Portable;
use vc_graph::{Aabb, Pose};
use vc_shapes::material::{self, Family};

use super::canvas::{Canvas, Colour, Ink, Point};
use crate::apartment::Apartment;
use crate::area::Area;
use crate::item::{Item, Support};

/// The height of an object's base above which it hangs over the floor and is drawn dashed, metres.
const OVERHEAD: f32 = 1.3;
/// The size below which only an object's largest part is drawn, metres.
const SMALL: f32 = 0.3;
/// The size below which a part is left out, metres.
const SPECK: f32 = 0.03;
/// The width of outlines, metres.
const HAIR: f32 = 0.008;

/// A part's outline and the height of its top.
struct Top {
    outline: Vec<Point>,
    /// The smallest and largest corner.
    low: Point,
    high: Point,
    z: f32,
    material: u32,
    /// Whether it hides everything within its corners.
    solid: bool,
}

/// Draws all objects that are neither part of the building nor inside others.
pub(super) fn draw(canvas: &mut Canvas, home: &Apartment) {
    let hidden = hidden(&home.items);
    let seen = || home.items.iter().zip(&hidden).filter(|(_, hidden)| !**hidden).map(|(item, _)| item);
    let (over, below): (Vec<&Item>, Vec<&Item>) = seen().partition(|i| i.corners().0.z > OVERHEAD);
    paint(canvas, below);
    for item in over.into_iter().filter(|i| i.support == Support::Ceiling || i.support == Support::Wall) {
        let area = item.area();
        let dashes = Ink::line(Colour::hex(0x9aa0a8), HAIR).dashed(0.05);
        canvas.rectangle([area.x0, area.y0], [area.x1, area.y1], dashes);
    }
}

/// Draws the parts of items that one sees from above.
pub(super) fn paint<'a>(canvas: &mut Canvas, items: impl IntoIterator<Item = &'a Item>) {
    let mut tops: Vec<Top> = items.into_iter().flat_map(tops).collect();
    tops.sort_by(|a, b| a.z.total_cmp(&b.z));
    tops.iter().for_each(|top| canvas.polygon(&top.outline, ink(top.material)));
}

/// The rectangles around the parts of an item.
pub(super) fn outlines(item: &Item) -> Vec<Area> {
    let around = |top: Top| Area { x0: top.low[0], y0: top.low[1], x1: top.high[0], y1: top.high[1] };
    item.object.asset.parts.iter().map(|part| around(top(part, &item.pose))).collect()
}

/// The objects that stand on the floors, which names should not cover: neither rugs nor objects
/// high above the floor.
pub(super) fn areas(home: &Apartment) -> Vec<Area> {
    let stands = |item: &&Item| {
        let (low, high) = item.corners();
        matches!(item.support, Support::Floor | Support::Wall) && low.z < OVERHEAD && high.z > 0.1
    };
    home.items.iter().filter(stands).map(Item::area).collect()
}

/// For each item whether it is part of the building, inside another, or on a hidden one.
fn hidden(items: &[Item]) -> Vec<bool> {
    let mut hidden: Vec<bool> = Vec::with_capacity(items.len());
    for item in items {
        hidden.push(match item.support {
            Support::Built | Support::Inside(..) => true,
            Support::On(at, _) => hidden.get(at).copied().unwrap_or(false),
            Support::Floor | Support::Wall | Support::Ceiling => false,
        });
    }
    hidden
}

/// The colour of a part's material, paled, with a darker outline.
fn ink(material: u32) -> Ink {
    let (_, family, rgb) = material::ALL.get(material as usize).copied().unwrap_or(("", Family::Paint, 0xcccccc));
    let colour = Colour::hex(rgb);
    let mixed = |towards: u8, share: f32| Colour {
        rgb: colour.rgb.map(|c| (f32::from(c) * (1.0 - share) + f32::from(towards) * share).round() as u8),
        opacity: 1.0,
    };
    let line = Colour { rgb: mixed(0, 0.5).rgb.map(|c| c.min(150)), opacity: 1.0 };
    match family {
        Family::Glass => Ink::filled(Colour::hex(0xbfd8e6).faded(0.35)).outlined(Colour::hex(0x7d98a8), HAIR),
        _ => Ink::filled(mixed(255, 0.45)).outlined(line, HAIR),
    }
}

/// The parts of an item visible from above.
fn tops(item: &Item) -> Vec<Top> {
    let mut tops: Vec<Top> = item.object.asset.parts.iter().map(|p| top(p, &item.pose)).collect();
    let size = |t: &Top| (t.high[0] - t.low[0]).max(t.high[1] - t.low[1]);
    let area = |t: &Top| (t.high[0] - t.low[0]) * (t.high[1] - t.low[1]);
    let own = item.area();
    if (own.x1 - own.x0).max(own.y1 - own.y0) < SMALL {
        return tops.into_iter().reduce(|a, b| if area(&b) > area(&a) { b } else { a }).into_iter().collect();
    }
    tops.retain(|t| size(t) >= SPECK);
    tops.sort_by(|a, b| b.z.total_cmp(&a.z));
    let mut seen: Vec<Top> = Vec::new();
    for top in tops {
        if !seen.iter().any(|above| above.hides(&top)) {
            seen.push(top);
        }
    }
    seen
}

impl Top {
    fn hides(&self, other: &Self) -> bool {
        let inside = |i: usize| other.low[i] > self.low[i] - 0.002 && other.high[i] < self.high[i] + 0.002;
        self.solid && inside(0) && inside(1)
    }
}

fn top(part: &Part, pose: &Pose) -> Top {
    let pose = pose * part.pose;
    let outline = outline(&part.shape, &pose);
    let start = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
    let (low, high) =
        outline.iter().fold(start, |(l, h), p| ([l[0].min(p[0]), l[1].min(p[1])], [h[0].max(p[0]), h[1].max(p[1])]));
    let boxed = matches!(part.shape, Shape::Box { .. } | Shape::RoundedBox { .. });
    let turned = (pose.rotation * Vector3::x()).abs().max() < 0.999;
    let clear = material::ALL.get(part.material as usize).is_some_and(|m| m.1 == Family::Glass);
    let z = corners(&part.shape).map(|c| (pose * c).z).into_iter().fold(f32::NEG_INFINITY, f32::max);
    Top { outline, low, high, z, material: part.material, solid: boxed && !turned && !clear }
}

/// The corners of a shape's bounding box, in its own frame.
fn corners(shape: &Shape) -> [Point3<f32>; 8] {
    let (min, max) = shape.extent();
    Aabb { min, max }.corners()
}

/// A shape's outline seen from above; its convex hull for lying round shapes and for tilted ones.
fn outline(shape: &Shape, pose: &Pose) -> Vec<Point> {
    let upright = (pose.rotation * Vector3::z()).z.abs() > 0.999;
    let flat = |p: Point3<f32>| {
        let p = pose * p;
        [p.x, p.y]
    };
    match shape {
        Shape::RoundedBox { half, radius } if upright && *radius > 0.015 => {
            rounded(half.x, half.y, *radius).into_iter().map(|[x, y]| flat(Point3::new(x, y, 0.0))).collect()
        }
        Shape::Extrusion { outline, .. } if upright => {
            outline.iter().map(|&(x, y)| flat(Point3::new(x, y, 0.0))).collect()
        }
        Shape::Hull { points: all } | Shape::Mesh { vertices: all, .. } => hull(all.iter().map(|&p| flat(p))),
        Shape::Cylinder { .. }
        | Shape::Cone { .. }
        | Shape::Capsule { .. }
        | Shape::Sphere { .. }
        | Shape::Lathe { .. }
            if upright =>
        {
            let radius = shape.extent().1.x;
            rounded(radius, radius, radius).into_iter().map(|[x, y]| flat(Point3::new(x, y, 0.0))).collect()
        }
        _ => hull(corners(shape).map(flat)),
    }
}

/// A rectangle with rounded corners around the origin.
fn rounded(hx: f32, hy: f32, radius: f32) -> Vec<Point> {
    let radius = radius.min(hx).min(hy);
    let steps = if radius < 0.05 { 2 } else { 6 };
    let corner = |quarter: usize| {
        let (sx, sy) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][quarter];
        let centre = [sx * (hx - radius), sy * (hy - radius)];
        (0..=steps).map(move |i| {
            let angle = (quarter as f32 + i as f32 / steps as f32) * TAU / 4.0;
            [centre[0] + radius * angle.cosine(), centre[1] + radius * angle.sine()]
        })
    };
    (0..4).flat_map(corner).collect()
}

/// The convex hull of points, counter-clockwise.
fn hull(points: impl IntoIterator<Item = Point>) -> Vec<Point> {
    vc_geometry::outline::hull(points.into_iter().map(Point2::from)).into_iter().map(Point::from).collect()
}
