//! Fridges, freezers and commercial cooling equipment.

use vc_graph::asset::JointKind;
use vc_graph::portable::Portable;

use super::fitting::*;
use super::heat::{foot_row, glass_door};
use crate::material::*;
use crate::object::joinery::{Fitted, Handle, Panel, Swing, drawers, gapped, lid, swing};
use crate::solid::{Build, CORNERS, P, basket, case, fit, floor_of, half_dims, pit, tiers};

/// The compartment behind a door.
#[derive(Debug, Clone, Copy)]
struct Cold {
    /// The name of its surfaces.
    name: &'static str,
    shelves: usize,
    drawers: usize,
    door_shelves: usize,
    /// Wire racks instead of glass shelves.
    wire: bool,
    /// Whether the door is of glass.
    pane: bool,
    /// The colour of the digits on the door's display, if it has one.
    display: Option<MaterialId>,
}

const LARDER: Cold =
    Cold { name: "shelf", shelves: 4, drawers: 1, door_shelves: 3, wire: false, pane: false, display: None };
const FREEZER: Cold =
    Cold { name: "freezer", shelves: 0, drawers: 3, door_shelves: 0, wire: false, pane: false, display: None };
const RACKS: Cold =
    Cold { name: "shelf", shelves: 4, drawers: 0, door_shelves: 0, wire: true, pane: false, display: None };

/// A fridge above or below a freezer, or both side by side.
pub(super) fn fridge(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.4, 1.12]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[b.style.appliance, b.style.appliance, STEEL]);
    let (feet, face, door) = (0.03 * u, x - 0.035 * u, 0.05 * u);
    let back = face - door;
    foot_row(b, (x * 0.75, y * 0.85), 0.025 * u, feet);
    let at = b.choose(&[Swing::Left, Swing::Right]);
    let gap = 0.002 * u;
    if y > 0.37 {
        let split = y * b.vary(-0.15, 0.1);
        chamber(b, &LARDER, ([-x, split, feet], [back, y, h]), door, Swing::Left, body, u);
        let frozen = Cold { shelves: 3, drawers: 2, door_shelves: 2, ..FREEZER };
        chamber(b, &frozen, ([-x, -y, feet], [back, split - gap, h]), door, Swing::Right, body, u);
        return;
    }
    let low_freezer = b.rng.chance(0.6);
    let split = feet + (h - feet) * if low_freezer { b.vary(0.3, 0.42) } else { b.vary(0.66, 0.72) };
    let (below, above) = (([-x, -y, feet], [back, y, split]), ([-x, -y, split + gap], [back, y, h]));
    let count = if low_freezer { b.rng.count(2, 3) } else { 0 };
    let frozen = Cold { drawers: count, shelves: usize::from(!low_freezer) * 2, ..FREEZER };
    let (cold, ice) = if low_freezer { (above, below) } else { (below, above) };
    let shelves = if split > 0.9 || low_freezer { b.rng.count(3, 5) } else { 3 };
    let display = b.rng.chance(0.4).then_some(COOL_BULB);
    let larder = Cold { shelves, display: display.filter(|_| low_freezer), ..LARDER };
    chamber(b, &larder, cold, door, at, body, u);
    chamber(b, &Cold { display: display.filter(|_| !low_freezer), ..frozen }, ice, door, at, body, u);
}

/// One door in front of two shelves and an ice compartment.
pub(super) fn mini_fridge(b: &mut Build<'_>) {
    let u = fit(b, [0.352, 0.336, 0.4]);
    let (x, y, _) = half_dims(b);
    let h = under_worktop(b, u);
    let body = b.choose(&[b.style.appliance, BLACK_METAL, RED_METAL, WHITE_METAL]);
    let (feet, door) = (0.02 * u, 0.04 * u);
    foot_row(b, (x * 0.75, y * 0.85), 0.02 * u, feet);
    let cold = Cold { shelves: b.rng.count(2, 3), drawers: 0, door_shelves: 2, pane: b.rng.chance(0.25), ..LARDER };
    let at = b.choose(&[Swing::Left, Swing::Right]);
    chamber(b, &cold, ([-x, -y, feet], [x - 0.035 * u - door, y, h]), door, at, body, u);
    if !in_run(b) {
        b.top("top", [0.0, 0.0, h], (x - 0.04 * u, y - 0.01 * u));
    }
}

/// Drawers behind one door.
pub(super) fn freezer(b: &mut Build<'_>) {
    let u = fit(b, [0.448, 0.432, 0.64]);
    let (x, y, _) = half_dims(b);
    let h = under_worktop(b, u);
    let body = b.style.appliance;
    let (feet, door) = (0.03 * u, 0.05 * u);
    foot_row(b, (x * 0.75, y * 0.85), 0.02 * u, feet);
    let drawers = (h / 0.24).round().clamp(2.0, 7.0) as usize;
    let at = b.choose(&[Swing::Left, Swing::Right]);
    let frozen = Cold { drawers, display: Some(LED), ..FREEZER };
    chamber(b, &frozen, ([-x, -y, feet], [x - 0.035 * u - door, y, h]), door, at, body, u);
}

/// A chest with a lid hinged at the back; narrow baskets hang in it.
pub(super) fn chest_freezer(b: &mut Build<'_>) {
    let u = fit(b, [0.448, 0.48, 0.64]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_METAL, WHITE_METAL, SILVER_METAL]);
    let (feet, cover, wall) = (0.025 * u, 0.05 * u, 0.05 * u);
    let front = x - 0.025 * u;
    foot_row(b, (x * 0.8, y * 0.85), 0.025 * u, feet);
    pit(b, "chest", [-x, -y, feet], [front, y, h - cover], wall, body);
    let step = h * 0.25;
    let motor = [front - wall - 0.001 * u, y - wall - (y * 0.45).min(0.28), feet + wall];
    b.block("motor", [-x + wall, motor[1], motor[2]], [front - wall, y - wall, feet + wall + step], body);
    floor_of(b, "compartment_1", [-x + wall, -y + wall, feet + wall], [front - wall, motor[1], h - cover]);
    let raised = [-x + wall, motor[1], feet + wall + step];
    floor_of(b, "compartment_2", raised, [front - wall, y - wall, h - cover]);
    b.block(
        "grille",
        [front - 0.001 * u, y * 0.55, feet + 0.04 * u],
        [front + 0.003 * u, y * 0.92, feet + 0.12 * u],
        BLACK_PLASTIC,
    );
    b.block("badge", [front - 0.001 * u, -y * 0.9, h * 0.8], [front + 0.002 * u, -y * 0.65, h * 0.83], GREY_PLASTIC);
    lid(b, [-x, 0.0, h], 1.35, |b| {
        b.rounded_block("lid", [-x, -y, h - cover + 0.002 * u], [x - 0.01 * u, y, h], 0.015 * u, body);
        let w = y * 0.25;
        b.block("grip", [x - 0.02 * u, -w, h - cover * 0.8], [x, w, h - cover * 0.3], GREY_PLASTIC);
        b.top("lid", [0.0, 0.0, h], (x - 0.04 * u, y - 0.03 * u));
    });
}

/// A steel cupboard for restaurants: one or two doors, wire shelves, machinery on top.
pub(super) fn commercial_fridge(b: &mut Build<'_>) {
    let u = fit(b, [0.56, 0.512, 1.44]);
    let (x, y, h) = half_dims(b);
    let (feet, door) = (0.12 * u, 0.05 * u);
    let face = x - 0.035 * u;
    let back = face - door;
    let castors = b.rng.chance(0.5);
    steel_legs(b, (x * 0.8, y * 0.88), feet, castors, u);
    let head = 0.22 * u;
    let on_top = b.rng.chance(0.6);
    let (z0, z1) = if on_top { (feet, h - head) } else { (feet + head, h) };
    let hood = if on_top { (z1, h) } else { (feet, z0) };
    b.block("machine", [-x, -y, hood.0], [face - 0.005 * u, y, hood.1], STEEL);
    grille(b, face - 0.005 * u, (-y * 0.9, hood.0 + head * 0.2), (y * 0.2, hood.0 + head * 0.8), 6);
    display(b, face - 0.005 * u, (y * 0.4, hood.0 + head * 0.35), (y * 0.75, hood.0 + head * 0.7), SIGNAL_RED);
    let pane = b.rng.chance(0.4);
    let racks = Cold { shelves: b.rng.count(4, 5), pane, ..RACKS };
    if y > 0.42 {
        chamber(b, &racks, ([-x, -y, z0], [back, -0.002, z1]), door, Swing::Right, STEEL, u);
        let other = Cold { name: "left_shelf", ..racks };
        chamber(b, &other, ([-x, 0.002, z0], [back, y, z1]), door, Swing::Left, STEEL, u);
    } else {
        let at = b.choose(&[Swing::Left, Swing::Right]);
        chamber(b, &racks, ([-x, -y, z0], [back, y, z1]), door, at, STEEL, u);
    }
}

/// A steel blast chiller for trays, low or tall, with a display of the probe's temperature above
/// the door.
pub(super) fn blast_chiller(b: &mut Build<'_>) {
    let u = fit(b, [0.512, 0.56, 0.64]);
    let (x, y, h) = half_dims(b);
    let (feet, door, head) = (0.1 * u, 0.05 * u, 0.12 * u);
    let face = x - 0.035 * u;
    let castors = b.rng.chance(0.4);
    steel_legs(b, (x * 0.8, y * 0.85), feet, castors, u);
    b.block("head", [-x, -y, h - head], [face, y, h], STEEL);
    let board = b.choose(&[BLACK_GLASS, BLUE_METAL]);
    b.block(
        "board",
        [face - 0.001 * u, -y * 0.95, h - head * 0.9],
        [face + 0.002 * u, y * 0.95, h - head * 0.1],
        board,
    );
    display(b, face + 0.002 * u, (-y * 0.3, h - head * 0.72), (y * 0.1, h - head * 0.28), COOL_BULB);
    knob(b, [face + 0.002 * u, y * 0.6, h - head * 0.5], head * 0.25, 0.014 * u, (STEEL, BLACK));
    let racks = Cold { name: "rack", shelves: ((h - feet - head) / 0.13).clamp(3.0, 8.0) as usize, ..RACKS };
    let at = b.choose(&[Swing::Left, Swing::Right]);
    chamber(b, &racks, ([-x, -y, feet], [face - door, y, h - head]), door, at, STEEL, u);
    b.top("top", [0.0, 0.0, h], (x - 0.045 * u, y - 0.01 * u));
}

/// A glass door in front of bottle racks.
pub(super) fn wine_cooler(b: &mut Build<'_>) {
    let u = fit(b, [0.352, 0.24, 0.4]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_METAL, BLACK_METAL, STEEL]);
    let (feet, door, head) = (0.02 * u, 0.035 * u, 0.05 * u);
    let face = x - 0.035 * u;
    let back = face - door;
    foot_row(b, (x * 0.75, y * 0.8), 0.018 * u, feet);
    let wall = 0.035 * u;
    let (low, high) = ([-x, -y, feet], [back, y, h]);
    case(b, low, high, wall, body);
    let hollow = ([-x + wall, -y + wall, feet + wall], [back - 0.012 * u, y - wall, h - wall - head]);
    b.block("lamp", [-x + wall, -y + wall, h - wall - head * 0.6], [-x + wall * 1.6, y - wall, h - wall], COOL_BULB);
    let racks = (h / 0.13).clamp(3.0, 9.0) as usize;
    let wood = b.choose(&[BEECH, OAK, STEEL]);
    tiers(b, "rack", hollow, racks, 0.02 * u, |b, l, h| {
        rack(b, l, h, 6, STEEL);
        b.block("rack_front", [h[0] + 0.0005 * u, l[1], l[2]], [h[0] + 0.011 * u, h[1], h[2] + 0.01 * u], wood);
    });
    let at = b.choose(&[Swing::Left, Swing::Right]);
    let glass = b.choose(&[GLASS, BROWN_GLASS]);
    glass_door(b, at, ([back, -y, feet], [face, y, h]), (body, glass), 0.03 * u);
}

/// A machine that makes ice, with a flap in front of the bin; small ones stand on a counter.
pub(super) fn ice_machine(b: &mut Build<'_>) {
    let u = fit(b, [0.272, 0.208, 0.256]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, BLACK_METAL, RED_METAL]);
    let (feet, wall) = (h * 0.05, 0.02 * u);
    foot_row(b, (x * 0.78, y * 0.8), 0.018 * u, feet);
    let face = x - 0.03 * u;
    let (sill, lintel) = (h * b.vary(0.2, 0.3), h * b.vary(0.62, 0.7));
    let back = face - 0.02 * u;
    b.block("base", [-x, -y, feet], [face, y, sill], body);
    grille(b, face, (-y * 0.8, feet + (sill - feet) * 0.15), (y * 0.8, sill - (sill - feet) * 0.15), 5);
    case(b, [-x, -y, sill], [back, y, lintel], wall, body);
    let hollow = ([-x + wall, -y + wall, sill + wall], [back, y - wall, lintel - wall]);
    let ice = hollow.0[2] + (lintel - sill) * 0.25;
    b.block("ice", hollow.0, [back - 0.03 * u, hollow.1[1], ice], FROSTED_GLASS);
    floor_of(b, "basin", [hollow.0[0], hollow.0[1], ice], [back - 0.03 * u, hollow.1[1], hollow.1[2]]);
    b.block("head", [-x, -y, lintel], [face, y, h], body);
    display(b, face, (-y * 0.4, h - (h - lintel) * 0.65), (y * 0.4, h - (h - lintel) * 0.3), COOL_BULB);
    let (low, high) = gapped([back, -y, sill], [face, y, lintel], 0.001);
    let pane = b.choose(&[body, BROWN_GLASS]);
    swing(b, Swing::Up, low, high, 1.4, |b| {
        b.block("flap", low, high, pane);
        grab(b, [face, 0.0, sill + (lintel - sill) * 0.14], y * 0.9, false, 0.028 * u, BLACK_PLASTIC);
    });
    b.top("top", [0.0, 0.0, h], (x - 0.035 * u, y - 0.01 * u));
}

/// A steel bench with cold cupboards or drawers below and machinery at one end.
pub(super) fn refrigerated_counter(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.8, 0.64]);
    let (x, y, h) = half_dims(b);
    let (feet, door, slab) = (0.12 * u, 0.045 * u, 0.03 * u);
    let face = x - 0.035 * u;
    let back = face - door;
    let castors = b.rng.chance(0.3);
    steel_legs(b, (x * 0.8, y * 0.93), feet, castors, u);
    let splash = if b.rng.chance(0.5) { 0.05 * u } else { 0.0 };
    let top = h - splash;
    b.block("top", [-x, -y, top - slab], [x, y, top], STEEL);
    if splash > 0.0 {
        b.block("splashback", [-x, -y, top], [-x + 0.015 * u, y, h], STEEL);
    }
    b.top("top", [0.008 * u, 0.0, top], (x - 0.025 * u, y - 0.01 * u));
    let machine = y - y * 0.36;
    b.block("machine", [-x, machine, feet], [face - 0.01 * u, y, top - slab], STEEL);
    grille(b, face - 0.01 * u, (machine + 0.03 * u, feet + 0.05 * u), (y - 0.03 * u, top * 0.62), 8);
    display(b, face - 0.01 * u, (machine + 0.05 * u, top * 0.74), (y - 0.05 * u, top * 0.8), SIGNAL_RED);
    let count = ((machine + y) / 0.5).round().clamp(1.0, 3.0) as usize;
    let step = (machine + y) / count as f32;
    let pulls = b.rng.below(count + 1);
    let names = ["shelf", "middle_shelf", "far_shelf"];
    for i in 0..count {
        let (y0, y1) = (-y + step * i as f32, -y + step * (i + 1) as f32);
        let bay = ([-x, y0, feet], [back, y1, top - slab]);
        if i < pulls && i > 0 {
            let look = Fitted { panel: Panel::Slab, handle: Handle::Bar, mat: STEEL, metal: STEEL, t: door };
            case(b, bay.0, bay.1, 0.02 * u, STEEL);
            drawers(
                b,
                &look,
                ["drawer", "middle_drawer", "far_drawer"][i.min(2)],
                ([-x + 0.03 * u, y0, feet + 0.012 * u], [face, y1, top - slab]),
                (2, 1.0),
            );
        } else {
            let racks = Cold { name: names[i.min(2)], shelves: 2, ..RACKS };
            let at = if i % 2 == 0 { Swing::Right } else { Swing::Left };
            chamber(b, &racks, bay, door, at, STEEL, u);
        }
    }
}

/// Legs of steel tube, or castors.
pub(super) fn steel_legs(b: &mut Build<'_>, half: (f32, f32), height: f32, castors: bool, u: f32) {
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * half.0, sy * half.1);
        if castors {
            let r = height * 0.38;
            b.rod("wheel", [cx, cy - 0.014 * u, r], [cx, cy + 0.014 * u, r], r, RUBBER);
            b.rod("castor", [cx, cy, r], [cx, cy, height], 0.012 * u, STEEL);
        } else {
            b.lathe("leg", [cx, cy, 0.0], &[(0.02 * u, 0.0), (0.02 * u, height * 0.25), (0.026 * u, height)], STEEL);
        }
    }
}

/// Dark slots on a plane at X.
pub(super) fn grille(b: &mut Build<'_>, x: f32, low: (f32, f32), high: (f32, f32), count: usize) {
    let step = (high.1 - low.1) / count as f32;
    for i in 0..count {
        let z = low.1 + step * i as f32;
        b.block("slot", [x - 0.001, low.0, z + step * 0.25], [x + 0.001, high.0, z + step * 0.75], BLACK_PLASTIC);
    }
}

/// An insulated compartment `low..high` behind a door `door` thick: shelves, drawers at the bottom,
/// shelves in the door.
fn chamber(b: &mut Build<'_>, cold: &Cold, (low, high): (P, P), door: f32, at: Swing, body: MaterialId, u: f32) {
    let skin = 0.012 * u;
    case(b, low, high, skin, body);
    let steel = body == STEEL && cold.wire;
    let liner = if steel { ALUMINIUM } else { WHITE_PLASTIC };
    let wall = 0.025 * u;
    let shell = ([low[0] + skin, low[1] + skin, low[2] + skin], [high[0] - 0.001 * u, high[1] - skin, high[2] - skin]);
    case(b, shell.0, shell.1, wall, liner);
    let pocket = if cold.door_shelves > 0 { ((high[0] - low[0]) * 0.2).min(0.1) } else { 0.0 };
    let from = [shell.0[0] + wall, shell.0[1] + wall, shell.0[2] + wall];
    let to = [shell.1[0] - pocket - 0.012 * u, shell.1[1] - wall, shell.1[2] - wall];
    let tall = to[2] - from[2];
    let spaces = cold.shelves + cold.drawers;
    let split = from[2] + tall * cold.drawers as f32 / spaces.max(1) as f32 * if cold.shelves > 0 { 0.85 } else { 1.0 };
    crispers(b, cold, (from, [to[0], to[1], split]), u);
    if cold.shelves > 0 {
        let t = 0.008 * u;
        let floor = if cold.drawers > 0 { split + t } else { from[2] };
        if cold.drawers > 0 {
            b.block("shelf", [from[0], from[1], split], [to[0], to[1], floor], GLASS);
        }
        let wire = cold.wire;
        tiers(b, cold.name, ([from[0], from[1], floor], to), cold.shelves, t, |b, l, h| {
            if wire { rack(b, l, h, 6, STEEL) } else { b.block("shelf", l, h, GLASS) }
        });
    }
    let front = ([high[0], low[1], low[2]], [high[0] + door, high[1], high[2]]);
    if cold.pane {
        glass_door(b, at, front, (body, GLASS), 0.03 * u);
        return;
    }
    let (dl, dh) = gapped(front.0, front.1, 0.002 * u);
    let grip = if at == Swing::Left { dl[1] + 0.045 * u } else { dh[1] - 0.045 * u };
    let (z, length) = (f32::midpoint(dl[2], dh[2]), (dh[2] - dl[2]) * 0.45);
    let metal = if body == STEEL { STEEL } else { CHROME };
    swing(b, at, dl, dh, 1.8, |b| {
        b.rounded_block("door", dl, dh, 0.012 * u, body);
        grab(b, [dh[0], grip, z], length.min(0.5), true, 0.032 * u, metal);
        if let Some(light) = cold.display {
            let (middle, wide) = (f32::midpoint(dl[1], dh[1]), (dh[1] - dl[1]) * 0.1);
            display(b, dh[0], (middle - wide, dh[2] - 0.09 * u), (middle + wide, dh[2] - 0.05 * u), light);
        }
        let inset = skin + wall + 0.004 * u;
        // Their free end reaches in only as far as the swing of the door allows.
        let reach = ((dh[1] - dl[1] - inset).raised(2) - (pocket + door).raised(2)).max(0.0).sqrt();
        let (left, right) =
            if at == Swing::Left { (dh[1] - inset, dh[1] - reach) } else { (dl[1] + reach, dl[1] + inset) };
        let space = (dh[2] - dl[2] - 2.0 * inset) / cold.door_shelves.max(1) as f32;
        for i in 0..cold.door_shelves {
            let z = dl[2] + inset + space * i as f32 + 0.005 * u;
            let shelf_low = [dl[0] - pocket, right, z];
            let shelf_high = [dl[0] + 0.002 * u, left, z + (space * 0.3).min(0.09)];
            let name = format!("{}_door_{}", cold.name, i + 1);
            pit(b, &name, shelf_low, shelf_high, 0.004 * u, CLEAR_PLASTIC);
            let wall = 0.004 * u;
            let room = [shelf_high[0] - wall * 1.5, shelf_high[1] - wall, z + space * 0.9];
            floor_of(b, &name, [shelf_low[0] + wall, shelf_low[1] + wall, z + wall], room);
        }
    });
}

/// Clear drawers one above the other.
fn crispers(b: &mut Build<'_>, cold: &Cold, (low, high): (P, P), u: f32) {
    let pitch = (high[2] - low[2]) / cold.drawers.max(1) as f32;
    let gap = 0.003 * u;
    for i in 0..cold.drawers {
        let z = low[2] + pitch * i as f32;
        let from = [low[0] + gap, low[1] + gap, z + gap];
        let to = [high[0], high[1] - gap, z + pitch * 0.94];
        b.jointed(JointKind::Slide, from, [1.0, 0.0, 0.0], (0.0, (high[0] - low[0]) * 0.75), |b| {
            basket(b, &format!("{}_drawer_{}", cold.name, i + 1), from, to, 0.004 * u, CLEAR_PLASTIC);
            let y = (to[1] - from[1]) * 0.25;
            let middle = f32::midpoint(from[1], to[1]);
            let lip = [to[0] - 0.001 * u, middle - y, to[2] - 0.03 * u];
            b.block("lip", lip, [to[0] + 0.008 * u, middle + y, to[2] - 0.01 * u], WHITE_PLASTIC);
        });
    }
}
