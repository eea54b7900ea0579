//! Windows and glass doors as one sees them from outside.

use nalgebra::Point3;
use vc_graph::space::RegionFrame;
use vc_map::Point;
use vc_shapes::material::{BLACK_GLASS, FROSTED_GLASS, MaterialId};

use crate::city::{Unit, UnitPlace};
use crate::plan::{FloorPlan, OpeningKind, metres};
use crate::reach::doorway;

/// The width and height of the doors of shops.
const SHOP_DOOR: (f32, f32) = (1.1, 2.3);

/// A window or door in the frame of a building.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pane {
    pub(crate) at: (f32, f32),
    pub(crate) width: f32,
    /// Above the floor of its storey.
    pub(crate) height: (f32, f32),
    pub(crate) kind: PaneKind,
}

/// The kind of a window or door.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PaneKind {
    Home,
    Landing,
    Shop,
    Office,
    /// A door of a building.
    Door,
}

impl PaneKind {
    pub(crate) fn glass(self) -> MaterialId {
        if self == Self::Landing { FROSTED_GLASS } else { BLACK_GLASS }
    }
}

/// The windows of a flat whose plan has a frame.
pub(crate) fn of_flat<'a>(plan: &'a FloorPlan, frame: &'a RegionFrame) -> impl Iterator<Item = Pane> + 'a {
    let windows = plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window);
    windows.map(|window| {
        let hole = doorway(plan, window);
        let (middle, at) = (f32::midpoint(metres(window.from), metres(window.to)), |cells| metres(cells));
        let is_high = window.high.is_none();
        let edge = match (window.vertical, is_high) {
            (true, true) => (at(hole.x1), middle),
            (true, false) => (at(hole.x0), middle),
            (false, true) => (middle, at(hole.y1)),
            (false, false) => (middle, at(hole.y0)),
        };
        let place = frame.point(&Point3::new(f64::from(edge.0), f64::from(edge.1), 0.0));
        Pane {
            at: (place.x as f32, place.y as f32),
            width: metres(window.width()),
            height: (window.sill, window.head),
            kind: PaneKind::Home,
        }
    })
}

/// The door and windows of a unit, each with its storey.
pub(crate) fn of_unit(unit: &Unit, local: impl Fn(&Point) -> (f32, f32)) -> Vec<(usize, Pane)> {
    let kind = match unit.kind.place() {
        UnitPlace::Home => PaneKind::Home,
        UnitPlace::Shop => PaneKind::Shop,
        _ => PaneKind::Office,
    };
    let door = || Pane { at: local(&unit.door), width: SHOP_DOOR.0, height: (0.0, SHOP_DOOR.1), kind };
    let door = (kind == PaneKind::Shop).then(|| (unit.storey, door()));
    let windows = unit.windows.iter().map(|window| {
        let height = (window.sill as f32, (window.sill + window.size[1]) as f32);
        (window.storey, Pane { at: local(&window.at), width: window.size[0] as f32, height, kind })
    });
    door.into_iter().chain(windows).collect()
}
