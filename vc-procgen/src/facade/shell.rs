//! The skin of a building: its walls, storey by storey, with windows, courses and cornice.

use vc_graph::{Seed, Stream};
use vc_shapes::Build;
use vc_shapes::material::{
    BEIGE_FABRIC, BLUE_CARD, GREEN_CARD, GREY_FABRIC, LINEN, MaterialId, NAVY, ORANGE_CARD, RED, TEAL_CARD,
    WHITE_COTTON, YELLOW_CARD,
};

use super::{Facade, Pane, PaneKind, Panel, Side, around};

/// How far the skin stands out of the outer walls, and ledges, with their height.
pub(super) const SKIN: f32 = 0.03;
const LEDGE: (f32, f32) = (0.1, 0.06);
/// The thickness of walls around windows that lie deep in them.
const WALL: f32 = 0.2;
/// How far a plinth stands out of the skin.
const PLINTH: f32 = 0.03;
/// The width of frames of windows.
const FRAME: f32 = 0.06;
/// The height of a door below the glass over it, and of the steps before it.
const LEAF: f32 = 2.1;
const STEP: (f32, f32) = (0.35, 0.02);
/// The sign of a shop: how far it is above the window, its height, and how far it stands out.
const FASCIA: [f32; 3] = [0.12, 0.6, 0.12];
/// An awning: how far it reaches out, and how far it falls.
const AWNING: (f32, f32) = (1.3, 0.42);
const SHOPS: [MaterialId; 8] = [NAVY, RED, BLUE_CARD, GREEN_CARD, YELLOW_CARD, ORANGE_CARD, TEAL_CARD, BEIGE_FABRIC];
const CLOTHS: [MaterialId; 4] = [WHITE_COTTON, LINEN, GREY_FABRIC, BEIGE_FABRIC];

/// A storey: its floor above the ground, and its height from floor to floor, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Level {
    pub(crate) floor: f32,
    pub(crate) storey: f32,
}

/// A building or a wing of it from outside.
pub(crate) struct Shell<'a> {
    pub(crate) sides: Vec<Side>,
    /// The place of the side at the street among them.
    pub(crate) front: usize,
    pub(crate) levels: Vec<Level>,
    pub(crate) looks: &'a Facade,
    /// How deep windows lie in the walls; zero where the rooms behind are there, with walls of their own.
    pub(crate) recess: f32,
}

impl Shell<'_> {
    /// The height of its top above the ground.
    pub(crate) fn top(&self) -> f32 {
        self.levels.last().map_or(0.0, |level| level.floor + level.storey)
    }

    /// A storey along a side, with the panes that are at it; openings are left out of the wall.
    pub(crate) fn wall(&self, b: &mut Build<'_>, side: &Side, level: usize, panes: &[Pane], openings: &[Pane]) {
        let Level { floor, storey } = self.levels[level];
        let up = |[along, (low, high)]: Panel| [along, (floor + low, floor + high)];
        let here: Vec<(Panel, Pane)> = panes.iter().filter_map(|pane| Some((side.taken(pane)?, *pane))).collect();
        let open = openings.iter().filter_map(|pane| side.taken(pane));
        let holes: Vec<Panel> = here.iter().map(|(panel, _)| *panel).chain(open).collect();
        let is_ground = floor < 0.1;
        let material = if is_ground { self.looks.ground } else { self.looks.wall };
        let deep = if self.recess > 0.0 { WALL } else { 0.0 };
        for part in around([(0.0, side.length), (0.0, storey)], &holes) {
            side.plate(b, up(part), (SKIN, deep), material);
        }
        if is_ground {
            for part in around([(0.0, side.length), (0.0, self.looks.plinth)], &holes) {
                side.plate(b, up(part), (SKIN + PLINTH, 0.0), self.looks.trim);
            }
        }
        let band = |out: f32, high: f32| up([(-out, side.length + out), (storey - high, storey)]);
        let (out, high) = if level + 1 == self.levels.len() { self.looks.cornice } else { self.looks.course };
        side.plate(b, band(out + SKIN, high), (out + SKIN, 0.0), self.looks.trim);
        for (panel, pane) in &here {
            self.pane(b, side, (floor, *panel), pane);
        }
        if self.recess > 0.0 {
            here.iter().filter(|(_, pane)| pane.kind == PaneKind::Shop).for_each(|(panel, pane)| {
                let top = floor + storey - high;
                shop_sign(b, side, (top, up(*panel)), &mut stream(pane));
            });
        }
    }

    fn pane(&self, b: &mut Build<'_>, side: &Side, (floor, panel): (f32, Panel), pane: &Pane) {
        let up = |[along, (low, high)]: Panel| [along, (floor + low, floor + high)];
        let [(from, to), (sill, head)] = panel;
        let glass = if self.recess > 0.0 { -self.recess } else { 0.01 };
        let thick = if self.recess > 0.0 { self.recess + 0.02 } else { 0.0 };
        let frame_out = if self.recess > 0.0 { glass + 0.02 } else { SKIN };
        let mut upper = panel;
        if pane.kind == PaneKind::Door {
            let leaf = head.min(LEAF);
            side.plate(b, up([(from, to), (sill, leaf)]), (glass + 0.01, thick), self.looks.door);
            upper[1].0 = leaf;
            side.plate(b, [(from - 0.15, to + 0.15), (floor - 0.12, floor + STEP.1)], (STEP.0, WALL), self.looks.trim);
        }
        let material = if pane.kind == PaneKind::Door { PaneKind::Landing } else { pane.kind }.glass();
        if upper[1].1 > upper[1].0 + 0.05 {
            side.plate(b, up(upper), (glass, thick), material);
        }
        frame(panel).into_iter().for_each(|part| side.plate(b, up(part), (frame_out, thick), self.looks.frame));
        if sill > 0.3 {
            let ledge = [(from - 0.06, to + 0.06), (sill - LEDGE.1, sill)];
            side.plate(b, up(ledge), (LEDGE.0, 0.0), self.looks.trim);
        }
        if self.recess > 0.0 && matches!(pane.kind, PaneKind::Home | PaneKind::Office) {
            let mut stream = stream(pane);
            let cloth = CLOTHS[stream.below(CLOTHS.len())];
            let (x, z) = ((from + FRAME, to - FRAME), (sill + FRAME, head - FRAME));
            for part in covers(pane.kind, x, z, &mut stream) {
                side.plate(b, up(part), (glass + 0.006, 0.006 - glass), cloth);
            }
        }
    }

    /// The part of the walls below the ground.
    pub(crate) fn base(&self, b: &mut Build<'_>, deep: f32) {
        if self.levels.first().is_some_and(|level| level.floor < 0.1) {
            for side in &self.sides {
                side.plate(b, [(0.0, side.length), (-deep, 0.0)], (SKIN, WALL), self.looks.ground);
            }
        }
    }

    /// A storey along a side as it is seen from afar: panes on a wall without openings.
    pub(crate) fn plain_wall(&self, b: &mut Build<'_>, side: &Side, level: usize, panes: &[Pane]) {
        let Level { floor, storey } = self.levels[level];
        let material = if floor < 0.1 { self.looks.ground } else { self.looks.wall };
        side.plate(b, [(0.0, side.length), (floor, floor + storey)], (SKIN, WALL), material);
        for pane in panes {
            let Some([(from, to), (low, high)]) = side.taken(pane) else { continue };
            let quad = [(from, low), (to, low), (to, high), (from, high)];
            let corners = quad.map(|(along, z)| side.point(along, SKIN + 0.02, floor + z));
            let material = if pane.kind == PaneKind::Door { self.looks.door } else { pane.kind.glass() };
            b.mesh("window", corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], material);
        }
    }
}

/// The draws of a pane, the same from near and far.
fn stream(pane: &Pane) -> Stream {
    let place = [pane.at.0, pane.at.1, pane.height.0].map(|metres| (metres * 100.0).round() as i64 as u64);
    place.into_iter().fold(Seed(0).child("pane"), Seed::nth).stream()
}

/// The frame of a window, with a mullion in the middle of a wide one.
fn frame([(from, to), (low, high)]: Panel) -> Vec<Panel> {
    let (x, middle) = (FRAME, f32::midpoint(from, to));
    let mut parts = vec![
        [(from, from + x), (low, high)],
        [(to - x, to), (low, high)],
        [(from + x, to - x), (low, low + x)],
        [(from + x, to - x), (high - x, high)],
    ];
    if to - from > 1.0 {
        parts.push([(middle - x / 2.0, middle + x / 2.0), (low + x, high - x)]);
    }
    parts
}

/// The curtains or blinds of a window.
fn covers(kind: PaneKind, x: (f32, f32), z: (f32, f32), stream: &mut Stream) -> Vec<Panel> {
    let (wide, tall) = (x.1 - x.0, z.1 - z.0);
    let drawn = stream.between(0.12, 0.3) * wide;
    let blind = |share: f32| vec![[x, (z.1 - share * tall, z.1)]];
    match (kind, stream.below(10)) {
        (PaneKind::Home, 0..5) => vec![[(x.0, x.0 + drawn), z], [(x.1 - drawn, x.1), z]],
        (PaneKind::Home, 5) => vec![[x, z]],
        (_, 6) => blind(stream.between(0.5, 0.9)),
        (_, 7) => blind(stream.between(0.15, 0.4)),
        _ => Vec::new(),
    }
}

/// The sign over the window of a shop, in places with an awning below it.
fn shop_sign(b: &mut Build<'_>, side: &Side, (top, [(from, to), (_, head)]): (f32, Panel), stream: &mut Stream) {
    let [above, tall, out] = FASCIA;
    let (low, high) = (head + above, (head + above + tall).min(top - 0.05));
    let colour = SHOPS[stream.below(SHOPS.len())];
    if high > low + 0.2 {
        side.plate(b, [(from - 0.25, to + 0.25), (low, high)], (out, 0.0), colour);
    }
    if stream.chance(0.35) && to - from > 1.5 {
        let (reach, fall) = AWNING;
        let edge = |along: f32| {
            [(SKIN, low), (SKIN, low + 0.03), (reach, low - fall), (reach, low - fall + 0.03)]
                .map(|(out, z)| side.point(along, out, z))
        };
        b.visual_only(|b| b.hull("awning", [edge(from - 0.1), edge(to + 0.1)].as_flattened(), colour));
    }
}
