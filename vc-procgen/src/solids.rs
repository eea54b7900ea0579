//! Objects built from boxes in world coordinates: walls, floors, ceilings.

use nalgebra::{Point3, Vector3};
use vc_graph::{Bounds, Stream};
use vc_shapes::Style;
use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Object};

use crate::plan::{Rect, metres};

/// Boxes in world coordinates that become one object.
pub(crate) struct Solids {
    class: &'static str,
    boxes: Vec<(&'static str, [f32; 3], [f32; 3], MaterialId)>,
    tops: Vec<(&'static str, Rect)>,
}

impl Solids {
    pub(crate) fn new(class: &'static str) -> Self {
        Self { class, boxes: Vec::new(), tops: Vec::new() }
    }

    pub(crate) fn block(&mut self, name: &'static str, low: [f32; 3], high: [f32; 3], mat: MaterialId) {
        self.boxes.push((name, low, high, mat));
    }

    /// A surface for objects at height zero.
    pub(crate) fn top(&mut self, name: &'static str, rect: &Rect) {
        self.tops.push((name, *rect));
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
        for (name, rect) in &self.tops {
            let area = (metres(rect.width()) / 2.0, metres(rect.depth()) / 2.0);
            let centre = [metres(rect.x0 + rect.x1) / 2.0 - at.x, metres(rect.y0 + rect.y1) / 2.0 - at.y, -at.z];
            build.top(name, centre, area);
        }
        let (asset, _) = build.finish();
        Some((Object::new(self.class, asset, Bounds::standing(high - low)), at))
    }
}

/// Walls have no random choices.
fn stream() -> Stream {
    vc_graph::Seed(0).stream()
}
