//! An explanation as a drawing: the scene from above one corner, the two things coloured, and
//! the traces with what they met.

use std::fmt::Write as _;

use nalgebra::{Point3, Vector3};
use vc_graph::{Node, NodeId, SceneGraph};
use virtualcity::relations::{Explanation, Hit, Verdict};

/// Pixels a metre, and the picture's size.
const SCALE: f32 = 260.0;
const SIZE: (f32, f32) = (1180.0, 760.0);

/// A face with its distance from the eye.
struct Face {
    depth: f32,
    points: [(f32, f32); 4],
    fill: String,
    node: NodeId,
}

/// Oblique from the front right above: X comes towards the eye, Y goes left, Z up.
fn project(p: &Point3<f32>) -> (f32, f32) {
    let (x, y) = (p.x * 0.5 - p.y * 0.87, p.x * 0.42 + p.y * 0.2 - p.z);
    (SIZE.0 * 0.36 + x * SCALE, SIZE.1 * 0.62 + y * SCALE)
}

fn depth(p: &Point3<f32>) -> f32 {
    p.x - 0.45 * p.y + 0.6 * p.z
}

/// The scene as SVG.
pub(crate) fn draw(graph: &SceneGraph, why: &Explanation) -> String {
    let mut faces: Vec<Face> = graph.nodes().flat_map(|node| faces_of(graph, node, why)).collect();
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.node.cmp(&b.node)));
    let (w, h) = SIZE;
    let mut svg = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {w} {h}' font-family='sans-serif'>\n");
    svg += "<rect width='100%' height='100%' fill='#fafaf7'/>\n";
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
    why.down.iter().for_each(|hit| arrow(&mut svg, graph, why, hit, false));
    why.up.iter().for_each(|hit| arrow(&mut svg, graph, why, hit, true));
    caption(&mut svg, graph, why);
    svg + "</svg>\n"
}

fn faces_of(graph: &SceneGraph, node: &Node, why: &Explanation) -> Vec<Face> {
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
            points: corners.map(|c| project(&c)),
            fill: format!("#{:02x}{:02x}{:02x}", fill[0], fill[1], fill[2]),
            node: node.id(),
        }
    };
    boxes.iter().flat_map(|(low, high)| (0..3).map(|side| face(*low, *high, side))).collect()
}

fn arrow(svg: &mut String, graph: &SceneGraph, why: &Explanation, hit: &Hit, up: bool) {
    let centre = graph.node(why.from).and_then(Node::aabb).map(|a| a.centre());
    let start = match (up, centre) {
        (true, _) => hit.at - Vector3::z() * hit.distance,
        (false, Some(c)) => Point3::new(hit.at.x, hit.at.y, c.z),
        (false, None) => hit.at + Vector3::z() * hit.distance.max(0.12),
    };
    let colour = match hit.verdict {
        Verdict::Counts => "#1a8f3c",
        Verdict::Carried | Verdict::Content => "#8a6fb0",
        _ => "#c23b3b",
    };
    let ((x1, y1), (x2, y2)) = (project(&start), project(&hit.at));
    let _ =
        writeln!(svg, "<line x1='{x1:.1}' y1='{y1:.1}' x2='{x2:.1}' y2='{y2:.1}' stroke='{colour}' stroke-width='2'/>");
    let _ = writeln!(svg, "<circle cx='{x2:.1}' cy='{y2:.1}' r='4' fill='{colour}'/>");
    let label = graph.label(hit.what);
    let _ =
        writeln!(svg, "<text x='{:.1}' y='{:.1}' font-size='12' fill='{colour}'>{label}</text>", x2 + 7.0, y2 + 4.0);
}

fn caption(svg: &mut String, graph: &SceneGraph, why: &Explanation) {
    let title = format!("{} and {}", graph.label(why.from), graph.label(why.to));
    let _ = writeln!(svg, "<text x='20' y='34' font-size='20' fill='#222'>{title}</text>");
    let text = crate::named(graph, &why.to_string());
    for (line, text) in text.lines().enumerate() {
        let y = 60.0 + 18.0 * line as f32;
        let _ = writeln!(svg, "<text x='20' y='{y}' font-size='13' fill='#444'>{}</text>", text.trim());
    }
    let legend = [("#1a8f3c", "the hit that counts"), ("#8a6fb0", "in it or on it"), ("#c23b3b", "does not count")];
    for (row, (colour, text)) in legend.into_iter().enumerate() {
        let y = SIZE.1 - 60.0 + 18.0 * row as f32;
        let _ = writeln!(svg, "<circle cx='26' cy='{}' r='5' fill='{colour}'/>", y - 4.0);
        let _ = writeln!(svg, "<text x='38' y='{y}' font-size='13' fill='#444'>{text}</text>");
    }
}
