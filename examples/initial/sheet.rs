//! Pictures of the added objects with their surroundings.

use std::path::Path;

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, NodeKind, Pose, Property, SceneGraph};
use vc_tasks::initial::Purpose;
use vc_tasks::library::Activity;
use virtualcity::procgen::picture::{Anchor, Canvas, Colour, SketchView, sketch};

use crate::Home;
use crate::support::Complaint;

/// Width and height of a picture, height of its legend, pixels.
const TILE: (usize, usize) = (300, 230);
const LEGEND: usize = 34;
const COLUMNS: usize = 5;
/// Distance up to which the surroundings are shown, metres.
const AROUND: f32 = 0.55;

/// An added object and its scene.
pub(crate) struct Tile {
    scene: SceneGraph,
    id: NodeId,
    legend: [String; 2],
}

/// The objects that were added for a task, without people.
pub(crate) fn tiles(activity: &Activity, made: &Home) -> Vec<Tile> {
    let scene = &made.initial.scene;
    let things = made.initial.added.iter().filter(|a| a.purpose != Purpose::Agent);
    let tile = |added: &vc_tasks::initial::Added| {
        let place = added.place.map_or_else(String::new, |p| format!("{} {}", p.relation, scene.label(p.at)));
        let legend = [format!("{} {}", activity.id, scene.label(added.id)), place];
        Tile { scene: scene.clone(), id: added.id, legend }
    };
    things.map(tile).collect()
}

/// Writes all tiles on one sheet.
pub(crate) fn write(tiles: &[Tile], path: &Path) -> Result<(), Complaint> {
    if tiles.is_empty() {
        return Ok(());
    }
    let (wide, tall) = (TILE.0, TILE.1 + LEGEND);
    let (width, height) = (COLUMNS * wide, tiles.len().div_ceil(COLUMNS) * tall);
    let mut canvas = Canvas::new([0.0, 0.0], [width as f32, height as f32]);
    canvas.background(Colour::WHITE);
    for (index, tile) in tiles.iter().enumerate() {
        let (x, y) = (index % COLUMNS * wide, index / COLUMNS * tall + TILE.1);
        for (line, text) in tile.legend.iter().enumerate() {
            let at = [x as f32 + 4.0, height as f32 - y as f32 - 12.0 - 15.0 * line as f32];
            canvas.text(at, 12.0, Anchor::Start, Colour::BLACK, text);
        }
    }
    let mut image = canvas.to_image(width).map_err(Complaint::new)?;
    for (index, tile) in tiles.iter().enumerate() {
        image.paste(index % COLUMNS * wide, index / COLUMNS * tall, &tile.picture());
    }
    let png = image.to_png().map_err(Complaint::new)?;
    Ok(virtualcity::files::write(path, png)?)
}

impl Tile {
    /// The object, its support and the objects near it, from the support's front, with doors and drawers open.
    fn picture(&self) -> virtualcity::procgen::picture::Image {
        let node = self.scene.node(self.id);
        let aabb = node.and_then(|n| n.aabb());
        let (low, high) = aabb.map_or((Point3::origin(), Point3::origin()), |b| (b.min, b.max));
        let carrier = self.scene.place(self.id).and_then(|p| self.scene.node(p.at));
        let front = carrier.and_then(|n| n.pose()).map_or(Vector3::x(), |p| p.rotation * Vector3::x());
        let near = |p: Point3<f32>, by: f32| p.map(|v| v + by);
        let (low, high) = (near(low, -AROUND), near(high, AROUND));
        let shown = self.scene.nodes().filter(|n| {
            let floor = &**n.class() == "floor";
            let meets = n.aabb().is_some_and(|b| (0..3).all(|i| b.min[i] < high[i] && low[i] < b.max[i]));
            n.kind() == NodeKind::Object && meets && !floor && !is_built(n)
        });
        let objects: Vec<(&vc_graph::Asset, Pose)> =
            shown.filter_map(|n| Some((&**self.scene.assets().get(n.spec().asset?)?, *n.pose()?))).collect();
        let side = front.cross(&Vector3::z()) * 0.5;
        let view =
            SketchView::from_direction(front + side + Vector3::z() * 0.8, low, high, TILE.0 as f32 / TILE.1 as f32);
        sketch(&objects, self.scene.assets(), &SketchView { open: 1.0, ..view }, TILE.0 - 2, TILE.1)
    }
}

fn is_built(node: &vc_graph::Node) -> bool {
    ["wall", "ceiling", "window", "curtain", "skirting"].contains(&&**node.class()) || node.affords(Property::Person)
}
