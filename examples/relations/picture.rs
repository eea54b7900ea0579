//! An explanation as a drawing: the scene in an oblique view, the two objects coloured, and the traced rays
//! with their hits.

use std::fmt::Write as _;

use nalgebra::{Point3, Vector3};
use vc_graph::{Node, NodeId, SceneGraph};
use virtualcity::relations::{Explanation, Hit, TraceOutcome};

/// Size of the picture, and of the part in which the scene is drawn, pixels.
const SIZE: (f32, f32) = (1240.0, 720.0);
const STAGE: (f32, f32) = (640.0, 720.0);
/// Distance from the explained object up to which the scene is shown, metres.
const AROUND: f32 = 0.95;

/// A face with its distance from the camera.
struct Face {
    depth: f32,
    points: [(f32, f32); 4],
    fill: String,
    node: NodeId,
}

/// Projection from metres to pixels: oblique from the front right above, centred on one object. X points
/// towards the camera, Y left, Z up.
struct View {
    middle: Point3<f32>,
}

impl View {
    fn project(&self, p: &Point3<f32>) -> (f32, f32) {
        let p = p - self.middle;
        let (x, y) = (p.x * 0.5 - p.y * 0.87, p.x * 0.42 + p.y * 0.2 - p.z);
        let scale = STAGE.0 / (2.0 * AROUND);
        (STAGE.0 / 2.0 + x * scale, STAGE.1 * 0.3 + y * scale)
    }
}

fn depth(p: &Point3<f32>) -> f32 {
    p.x - 0.45 * p.y + 0.6 * p.z
}

/// The scene as SVG.
pub(crate) fn draw(graph: &SceneGraph, why: &Explanation) -> String {
    let middle = graph.node(why.from).and_then(Node::position).unwrap_or_else(Point3::origin);
    let view = View { middle };
    let mut faces: Vec<Face> = graph.nodes().flat_map(|node| faces_of(graph, node, why, &view)).collect();
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.node.cmp(&b.node)));
    let (w, h) = SIZE;
    let mut svg = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {w} {h}' font-family='sans-serif'>\n");
    svg += "<rect width='100%' height='100%' fill='#fafaf7'/>\n";
    let _ = writeln!(svg, "<clipPath id='stage'><rect width='{}' height='{}'/></clipPath>", STAGE.0, STAGE.1);
    svg += "<g clip-path='url(#stage)'>\n";
    for face in &faces {
        let points: Vec<String> = face.points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let focus = face.node == why.from || face.node == why.to;
        let (stroke, width) = if focus { ("#333", 1.2) } else { ("#999", 0.5) };
        let opacity = if focus { 0.92 } else { 0.5 };
        let _ = writeln!(
            svg,
            "<polygon points='{}' fill='{}' fill-opacity='{opacity}' stroke='{stroke}' stroke-width='{width}'/>",
            points.join(" "),
            face.fill
        );
    }
    svg += "</g>\n";
    let mut free = f32::NEG_INFINITY;
    for (hits, up) in [(&why.up, true), (&why.down, false)] {
        hits.iter().for_each(|hit| arrow(&mut svg, graph, hit, &view, up, &mut free));
    }
    caption(&mut svg, graph, why);
    svg + "</svg>\n"
}

fn faces_of(graph: &SceneGraph, node: &Node, why: &Explanation, view: &View) -> Vec<Face> {
    let Some(pose) = node.pose() else { return Vec::new() };
    let asset = node.spec().asset.and_then(|a| graph.assets().get(a));
    let mut boxes: Vec<(Point3<f32>, Point3<f32>)> = Vec::new();
    match (asset, node.spec().bounds) {
        (Some(asset), _) => boxes.extend(asset.parts.iter().map(vc_graph::asset::Part::extent)),
        (None, Some(b)) => boxes.push(((b.offset - b.half).into(), (b.offset + b.half).into())),
        _ => {}
    }
    let hue = match node.id() {
        id if id == why.from => (0xe0, 0x6c, 0x2b),
        id if id == why.to => (0x3b, 0x7d, 0xc4),
        _ => (0xcf, 0xc8, 0xbb),
    };
    let face = |low: Point3<f32>, high: Point3<f32>, side: usize| {
        let corner = |u: bool, v: bool| {
            let pick = |k: usize, up: bool| if up { high[k] } else { low[k] };
            match side {
                0 => Point3::new(high.x, pick(1, u), pick(2, v)),
                1 => Point3::new(pick(0, u), low.y, pick(2, v)),
                _ => Point3::new(pick(0, u), pick(1, v), high.z),
            }
        };
        let corners =
            [corner(false, false), corner(true, false), corner(true, true), corner(false, true)].map(|p| pose * p);
        let shade = [0.86, 0.72, 1.0][side];
        let fill = [hue.0, hue.1, hue.2].map(|c: u32| (c as f32 * shade) as u32);
        let middle = corners.iter().fold(Vector3::zeros(), |s, c| s + c.coords) / 4.0;
        Face {
            depth: depth(&middle.into()),
            points: corners.map(|c| view.project(&c)),
            fill: format!("#{:02x}{:02x}{:02x}", fill[0], fill[1], fill[2]),
            node: node.id(),
        }
    };
    boxes.iter().flat_map(|(low, high)| (0..3).map(|side| face(*low, *high, side))).collect()
}

/// Draws a ray and its hit. The names are listed below each other, no higher than `free`.
fn arrow(svg: &mut String, graph: &SceneGraph, hit: &Hit, view: &View, up: bool, free: &mut f32) {
    let start = if up { hit.at - Vector3::z() * hit.distance } else { Point3::new(hit.at.x, hit.at.y, view.middle.z) };
    let colour = match hit.outcome {
        TraceOutcome::Counts => "#1a8f3c",
        TraceOutcome::Carried | TraceOutcome::Content => "#8a6fb0",
        _ => "#c23b3b",
    };
    let ((x1, y1), (x2, y2)) = (view.project(&start), view.project(&hit.at));
    let (x3, y3) = (x2 + 70.0, y2.max(*free));
    *free = y3 + 18.0;
    let mut line = |from: (f32, f32), to: (f32, f32), width: f32| {
        let ends = format!("x1='{:.1}' y1='{:.1}' x2='{:.1}' y2='{:.1}'", from.0, from.1, to.0, to.1);
        let _ = writeln!(svg, "<line {ends} stroke='{colour}' stroke-width='{width}'/>");
    };
    line((x1, y1), (x2, y2), 2.0);
    line((x2, y2), (x3, y3), 0.7);
    let _ = writeln!(svg, "<circle cx='{x2:.1}' cy='{y2:.1}' r='4' fill='{colour}'/>");
    let (label, x, y) = (graph.label(hit.node), x3 + 4.0, y3 + 4.0);
    let _ = writeln!(svg, "<text x='{x:.1}' y='{y:.1}' font-size='13' fill='{colour}'>{label}</text>");
}

fn caption(svg: &mut String, graph: &SceneGraph, why: &Explanation) {
    let title = format!("{} and {}", graph.label(why.from), graph.label(why.to));
    let _ = writeln!(svg, "<text x='{}' y='40' font-size='20' fill='#222'>{title}</text>", STAGE.0 + 16.0);
    let text = crate::named(graph, &why.to_string());
    for (line, text) in text.lines().enumerate() {
        let y = 72.0 + 20.0 * line as f32;
        let _ = writeln!(svg, "<text x='{}' y='{y}' font-size='13' fill='#444'>{}</text>", STAGE.0 + 16.0, text.trim());
    }
    let legend = [("#1a8f3c", "the hit that counts"), ("#8a6fb0", "in it or on it"), ("#c23b3b", "does not count")];
    for (row, (colour, text)) in legend.into_iter().enumerate() {
        let y = SIZE.1 - 60.0 + 18.0 * row as f32;
        let x = STAGE.0 + 22.0;
        let _ = writeln!(svg, "<circle cx='{x}' cy='{}' r='5' fill='{colour}'/>", y - 4.0);
        let _ = writeln!(svg, "<text x='{}' y='{y}' font-size='13' fill='#444'>{text}</text>", x + 12.0);
    }
}
