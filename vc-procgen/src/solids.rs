//! Objects built from boxes in world coordinates: walls, floors, ceilings.

use nalgebra::{Point3, Vector3};
use vc_graph::{Bounds, Stream};
use vc_shapes::Style;
use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Object};

/// Boxes in world coordinates that become one object.
pub(crate) struct Solids {
    class: &'static str,
    boxes: Vec<(&'static str, [f32; 3], [f32; 3], MaterialId)>,
    tops: Vec<Top>,
}

/// A surface at height zero: its middle and its half lengths.
struct Top {
    name: &'static str,
    middle: (f32, f32),
    half: (f32, f32),
}

impl Solids {
    pub(crate) fn new(class: &'static str) -> Self {
        Self { class, boxes: Vec::new(), tops: Vec::new() }
    }

    pub(crate) fn block(&mut self, name: &'static str, low: [f32; 3], high: [f32; 3], mat: MaterialId) {
        self.boxes.push((name, low, high, mat));
    }

    /// A surface for objects at height zero, by its middle and its half lengths.
    pub(crate) fn top(&mut self, name: &'static str, middle: (f32, f32), half: (f32, f32)) {
        self.tops.push(Top { name, middle, half });
    }

    /// The object and the centre of its base; `None` without boxes.
    pub(crate) fn finish(self) -> Option<(Object, Vector3<f32>)> {
        let corners = self.boxes.iter().map(|b| (Point3::from(b.1), Point3::from(b.2)));
        let (low, high) = corners.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))?;
        let at = Vector3::new(f32::midpoint(low.x, high.x), f32::midpoint(low.y, high.y), low.z);
        let style = Style::from_seed(vc_graph::Seed(0));
        let mut build = Build::new(self.class, high - low, &style, stream());
        for (name, low, high, mat) in &self.boxes {
            let local = |p: &[f32; 3]| [p[0] - at.x, p[1] - at.y, p[2] - at.z];
            build.block(name, local(low), local(high), *mat);
        }
        for Top { name, middle: (x, y), half } in &self.tops {
            build.top(name, [x - at.x, y - at.y, -at.z], *half);
        }
        let (asset, _) = build.finish();
        Some((Object::new(self.class, asset, Bounds::standing(high - low)), at))
    }
}

/// Walls have no random choices.
fn stream() -> Stream {
    vc_graph::Seed(0).stream()
}
