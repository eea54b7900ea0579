//! Fitted kitchens: units side by side along one, two or three walls, made to measure, with wall cabinets, a hood and a
//! backsplash above them.

use vc_graph::Seed;
use vc_shapes::object::fitted::{Purpose, Unit};

use super::Furnisher;
use super::kitchen_plan::{Base, DEPTH, FRONT, Layout, Piece, TOP, layouts};
use super::place::{Need, Spot};
use super::space::OFF_WALL;
use crate::area::Area;
use crate::draft::Draft;
use crate::item::Support;

/// The depth of wall cabinets, metres.
const UPPER: f32 = 0.35;
/// The fixed strip beside a corner that lets doors pass handles, metres.
const STRIP: f32 = 0.05;
/// The thickness of a backsplash: it covers the gap behind the units, metres.
const SPLASH: f32 = 0.022;
/// The gap between things that are hung one above the other, metres.
const GAP: f32 = 0.003;
/// The distance of a backsplash from a sill above it, and its least height, metres.
const BELOW_SILL: f32 = 0.08;
const LEAST: f32 = 0.06;
/// The lower edge of a hood, metres.
const HOOD: f32 = 1.6;
/// The layouts tried, the best first.
const TRIED: usize = 40;

/// Furnishes a kitchen with fitted units; `false` if the room has no space for them.
pub(super) fn furnish(s: &mut Furnisher<'_>) -> bool {
    let fridge = [0.62, 0.6, s.rng.between(1.7, 1.95)];
    let Some(cold) = s.make("fridge", fridge) else { return false };
    let mut spots = s.spots(&cold, Need::front(FRONT));
    s.rng.shuffle(&mut spots);
    let found = layouts(s, fridge).into_iter().take(TRIED).find_map(|layout| {
        let mut areas: Vec<Area> = layout.bases.iter().map(|base| base.area).collect();
        if layout.has_fridge() {
            return s.space.walk.stays_open(&areas).then_some((layout, None));
        }
        let free = |spot: &&Spot| layout.leaves(&spot.area, &spot.facing.before(&spot.area, FRONT));
        let spot = *spots.iter().find(free)?;
        areas.push(spot.area);
        s.space.walk.stays_open(&areas).then_some((layout, Some(spot)))
    });
    let Some((layout, apart)) = found else { return false };
    let kitchen = s.seed.child("fitted");
    for base in &layout.bases {
        stand(s, base, &cold, kitchen);
    }
    if let Some(spot) = apart {
        let index = s.settle(&cold, spot.area, spot.facing, Need::front(FRONT));
        s.item(index).required = true;
    }
    let bottom = s.rng.between(1.42, 1.48);
    upper(s, &layout, bottom, kitchen);
    backsplash(s, &layout, bottom, kitchen);
    true
}

/// Stands a unit or the fridge on the floor.
fn stand(s: &mut Furnisher<'_>, base: &Base, fridge: &Draft, kitchen: Seed) {
    let draft = match base.piece {
        Piece::Fridge => Some(fridge.clone()),
        _ => fitted(s, unit(base), [DEPTH, base.to - base.from, TOP], kitchen),
    };
    let Some(draft) = draft else { return };
    s.space.zones.push(base.zone);
    let index = s.add(&draft, base.area.centre(), 0.0, base.facing, Support::Floor);
    // A run without one of its units is none.
    s.item(index).required = true;
}

/// The fitted unit of a base.
fn unit(base: &Base) -> Unit {
    let purpose = match base.piece {
        Piece::Sink => Purpose::Sink,
        Piece::Cooker => Purpose::Cooker,
        Piece::Dishwasher => Purpose::Dishwasher,
        Piece::Drawers => Purpose::Drawers,
        Piece::Cabinet | Piece::Fridge => Purpose::Doors,
    };
    let corner = |behind: bool, before: bool| match (behind, before) {
        (true, _) => DEPTH + STRIP,
        (_, true) => STRIP,
        _ => 0.0,
    };
    let blank = [0, 1].map(|end| corner(base.behind[end], base.before[end]));
    Unit { purpose, blank, ends: base.ends }
}

fn fitted(s: &mut Furnisher<'_>, unit: Unit, size: [f32; 3], kitchen: Seed) -> Option<Draft> {
    s.made += 1;
    let own = s.seed.child("object").nth(s.made);
    let role = s.generators.get(unit.purpose.class())?.role();
    Some(Draft::fitted(unit, role, size.into(), (kitchen, own)))
}

/// Hangs wall cabinets over units, up to the corners, and a hood over the hob.
fn upper(s: &mut Furnisher<'_>, layout: &Layout, bottom: f32, kitchen: Seed) {
    let height = (s.space.ceiling - bottom - 0.25).clamp(0.5, 0.75);
    for base in layout.bases.iter().filter(|base| base.piece != Piece::Fridge) {
        if base.piece == Piece::Cooker {
            let tall = (s.space.ceiling - HOOD - 0.03).min(1.2);
            let hood = s.make("extractor", [0.45, (base.to - base.from).min(0.6), tall]);
            hood.and_then(|hood| s.hang(&hood, base.side, base.middle(), HOOD));
            continue;
        }
        // Over the first unit after a corner the cabinet goes on to the cabinets around the corner.
        let more = DEPTH + OFF_WALL - UPPER - 2.0 * GAP;
        let reach = [0, 1].map(|end| if base.before[end] { more } else { 0.0 });
        for reach in [reach, [0.0; 2]] {
            let blank = [0, 1].map(|end| match (base.behind[end], base.before[end] && reach[end] > 0.0) {
                (true, _) => UPPER + STRIP,
                (_, true) => STRIP,
                _ => 0.0,
            });
            let (from, to) = base.widened(reach);
            let unit = Unit { blank, ..Unit::new(Purpose::Wall) };
            let Some(cabinet) = fitted(s, unit, [UPPER, to - from, height], kitchen) else { continue };
            if s.hang(&cabinet, base.side, f32::midpoint(from, to), bottom).is_some() {
                break;
            }
        }
    }
}

/// Covers the wall over the worktop, higher behind the hob, and sets sockets in.
fn backsplash(s: &mut Furnisher<'_>, layout: &Layout, bottom: f32, kitchen: Seed) {
    for base in layout.bases.iter().filter(|base| base.piece != Piece::Fridge) {
        let top = if base.piece == Piece::Cooker { HOOD } else { bottom };
        // In a corner it ends before that of the next wall.
        let inwards = |end: usize| if base.behind[end] { OFF_WALL / 4.0 } else { 0.0 };
        let reach = [0, 1].map(|end| if base.before[end] { DEPTH - SPLASH } else { inwards(end) });
        let (from, to) = base.widened(reach);
        // Under a window it ends below the sill.
        let sill = s.space.sides[base.side].sill(from, to).map(|sill| sill - BELOW_SILL);
        let top = sill.map_or(top, |sill| sill.min(top));
        let Some(generator) = s.generators.get("backsplash").filter(|_| top > TOP + LEAST) else { continue };
        let splash = Draft::sized(generator, [SPLASH, to - from, top - TOP - 2.0 * GAP].into(), kitchen);
        let hung = s.hang(&splash, base.side, f32::midpoint(from, to), TOP + GAP);
        if hung.is_some() && matches!(base.piece, Piece::Drawers | Piece::Cabinet) && s.rng.chance(0.6) {
            socket(s, base);
        }
    }
}

/// Sets a socket on the backsplash over a unit.
fn socket(s: &mut Furnisher<'_>, base: &Base) {
    let Some(socket) = s.make("powersocket", [0.012, 0.08, 0.08]) else { return };
    let wall = &s.space.sides[base.side];
    let (facing, size) = (wall.facing, socket.size());
    let area = facing.area(wall.point(base.middle(), 0.001 + SPLASH), size.x, size.y);
    s.add(&socket, area.centre(), 1.1, facing, Support::Wall);
}
