//! Machines for running, rowing, climbing and gliding; the user faces the front.

use super::bike::{display, feet};
use crate::material::*;
use crate::solid::{Axis, Build, Proportional, SIDES, oval_outline, rounded_between, spare};

/// A treadmill with handrails and console, or a flat walking pad.
pub(super) fn treadmill(b: &mut Build<'_>) {
    let pad = b.class == "walking_pad";
    let (case, trim) = (
        b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC, ALUMINIUM]),
        b.choose(&[RED_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC]),
    );
    if !pad {
        spare(b, 0.0, 0.0, 0.02);
    }
    let deck = if pad { 0.86 } else { (0.19 / b.size.z).min(0.2) };
    let ahead = if pad { 0.7 } else { 0.52 };
    for y in SIDES {
        b.pad("side_rail", [-0.99, y * 0.9 - 0.1, deck * 0.3], [ahead + 0.05, y * 0.9 + 0.1, deck], 0.012, case);
        for x in [-0.9, ahead - 0.1] {
            b.pole("foot", [x, y * 0.86, 0.0], [x, y * 0.86, deck * 0.5], 0.03, RUBBER);
        }
    }
    b.slab("deck", [-0.96, -0.8, deck * 0.45], [ahead, 0.8, deck * 0.86], GREY_PLASTIC);
    b.slab("belt", [-0.97, -0.76, deck * 0.5], [ahead + 0.02, 0.76, deck * 0.93], RUBBER);
    b.pole("roller", [-0.96, -0.78, deck * 0.68], [-0.96, 0.78, deck * 0.68], b.size.z * deck * 0.22, BLACK_PLASTIC);
    b.slab("line", [-0.9, -0.02, deck * 0.9], [ahead - 0.1, 0.02, deck * 0.945], WHITE_PLASTIC);
    if pad {
        b.side_outline(
            "hood",
            (-0.99, 0.99),
            &[(ahead, deck * 0.3), (0.97, deck * 0.3), (0.99, deck * 0.6), (0.9, 0.99), (ahead + 0.06, 0.99)],
            case,
        );
        b.slab("display", [ahead + 0.08, -0.3, 0.98], [0.86, 0.3, 1.0], PICTURE_DARK);
        return;
    }
    b.side_outline(
        "hood",
        (-0.92, 0.92),
        &[(ahead, deck * 0.2), (0.96, deck * 0.2), (0.98, deck * 0.9), (0.86, deck * 1.5), (ahead + 0.04, deck * 1.25)],
        case,
    );
    b.slab("stripe", [ahead + 0.1, -0.5, deck * 1.2], [0.88, 0.5, deck * 1.42], trim);
    for y in SIDES {
        b.plank("upright", [0.75, y * 0.88, deck * 0.5], [0.56, y * 0.88, 0.8], (0.06, 0.08), case);
        b.plank("arm", [0.6, y * 0.88, 0.76], [0.0, y * 0.88, 0.7], (0.05, 0.045), trim);
        b.pole("grip", [0.1, y * 0.88, 0.73], [0.5, y * 0.88, 0.78], 0.022, RUBBER);
    }
    b.plank("dash", [0.44, 0.0, 0.76], [0.64, 0.0, 0.82], (b.size.y * 0.94, 0.05), case);
    let tall = b.size.z * 0.1;
    display(b, [0.62, 0.0, 0.885], (b.size.y * 0.42, tall), 0.3, BLACK_PLASTIC);
    b.slab("stop", [0.46, -0.08, 0.77], [0.54, 0.08, 0.815], RED_PLASTIC);
}

/// A rowing machine: a rail with a sliding seat, footplates, and a flywheel or water tank.
pub(super) fn rower(b: &mut Build<'_>) {
    let water = b.rng.chance(0.4);
    let frame =
        if water { b.choose(&[OAK, WALNUT, CHERRY]) } else { b.choose(&[BLACK_METAL, SILVER_METAL, GREY_PLASTIC]) };
    feet(b, (-0.93, 0.8), if water { frame } else { BLACK_METAL });
    let rail = 0.34;
    for y in SIDES {
        b.plank(
            "rail",
            [-0.95, y * 0.12, rail],
            [0.45, y * 0.12, rail],
            (0.03, 0.06),
            if water { frame } else { ALUMINIUM },
        );
        b.plank("leg", [-0.93, y * 0.12, 0.04], [-0.9, y * 0.12, rail], (0.04, 0.05), frame);
        b.plank(
            "strut",
            [0.8, y * 0.12, 0.05],
            [0.42, y * 0.12, rail + 0.02],
            ((b.size.y * 0.1).min(0.04), 0.05),
            frame,
        );
    }
    let r = (b.size.z * 0.27).min(b.size.x * 0.13).min(b.size.y * 0.48);
    let at = [0.99 - 2.0 * r / b.size.x, 0.0, rail + 0.1];
    if water {
        b.wheel("tank", Axis::Z, [at[0], 0.0, rail + 0.02], (r, b.size.z * 0.22), BLUE_GLASS);
        b.wheel("water", Axis::Z, [at[0], 0.0, rail + 0.01], (r * 0.94, b.size.z * 0.15), POOL_WATER);
    } else {
        b.wheel("flywheel", Axis::Y, at, (r, b.size.y * 0.2), BLACK_PLASTIC);
        b.wheel("vent", Axis::Y, at, (r * 0.75, b.size.y * 0.22), GREY_PLASTIC);
        b.wheel("hub", Axis::Y, at, (r * 0.3, b.size.y * 0.24), frame);
    }
    b.plank("stay", [at[0], 0.0, rail], [0.7, 0.0, 0.08], (0.06, 0.05), frame);
    let seat = b.vary(-0.5, -0.1);
    let over = rail + 0.028 / b.size.z;
    b.plank("boom", [0.36, 0.0, rail], [at[0], 0.0, rail], (b.size.y * 0.12, 0.05), frame);
    b.slide([1.0, 0.0, 0.0], (0.3 - seat).max(0.05) * b.size.x / 2.0 * 0.6, |b| {
        b.slab("carriage", [seat - 0.1, -0.25, over], [seat + 0.1, 0.25, over + 0.04], BLACK_PLASTIC);
        b.pad("seat", [seat - 0.13, -0.5, over + 0.03], [seat + 0.13, 0.5, over + 0.09], 0.02, BLACK_LEATHER);
    });
    let wide = (b.size.y * 0.38).min(0.13);
    for y in SIDES {
        b.plank("footplate", [0.36, y * 0.42, rail - 0.02], [0.5, y * 0.42, rail + 0.2], (wide, 0.02), BLACK_PLASTIC);
        let (low, high) = ([0.42, y * 0.42, rail + 0.075], [0.449, y * 0.42, rail + 0.12]);
        b.layer("strap", low, high, (wide * 1.05, 0.012), 0.014, GREY_FABRIC);
    }
    b.pole("foot_axle", [0.376, -0.6, rail + 0.005], [0.376, 0.6, rail + 0.005], 0.015, STEEL);
    b.plank("mast", [0.6, 0.0, rail], [0.52, 0.0, 0.92], (0.04, 0.05), frame);
    let grip = 0.62 + 0.022 / b.size.z;
    b.pole("handle", [0.48, -0.85, grip], [0.48, 0.85, grip], 0.016, RUBBER);
    b.plank("hook", [0.48, 0.0, 0.62], [0.6, 0.0, 0.62], (0.05, 0.02), frame);
    display(b, [0.5, 0.0, 0.92], (b.size.y * 0.22, b.size.z * 0.07), 0.2, BLACK_PLASTIC);
}

/// An elliptical trainer: wheel case, two gliding pedals, two swinging arms.
pub(super) fn elliptical(b: &mut Build<'_>) {
    spare(b, 0.0, 0.0, 0.01);
    let (case, trim) =
        (b.choose(&[GREY_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC]), b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC]));
    feet(b, (-0.9, 0.9), BLACK_METAL);
    b.plank("frame", [-0.9, 0.0, 0.045], [0.9, 0.0, 0.045], (0.08, 0.05), BLACK_METAL);
    let ahead = b.rng.chance(0.5);
    let x = if ahead { 0.55 } else { -0.55 };
    let shell: Vec<_> = oval_outline((x, 0.22), (0.4, 0.18), 16);
    b.side_outline("case", (-0.24, 0.24), &shell, case);
    b.wheel("wheel", Axis::Y, [x, 0.0, 0.22], (b.size.z * 0.12, b.size.y * 0.27), trim);
    let mast = 0.42;
    b.plank("mast", [mast + 0.12, 0.0, 0.06], [mast, 0.0, 0.86], (0.07, 0.08), case);
    for y in SIDES {
        let (lift, shift) = (0.17 + y * 0.05, y * 0.08);
        let end = x + y * 0.16;
        let pin = if ahead { 0.22 } else { 0.17 } + y * 0.05;
        b.plank("crank", [x, y * 0.28, 0.22], [end, y * 0.34, pin], (0.02, 0.04), STEEL);
        b.pole("pin", [end, y * 0.28, pin], [end, y * 0.48, pin], 0.015, STEEL);
        let joint = if ahead { [mast + shift, 0.215] } else { [mast - 0.02 + shift, 0.22] };
        b.pole(
            "pin",
            [joint[0], y * 0.38, joint[1] + y * 0.05],
            [joint[0], y * 0.54, joint[1] + y * 0.05],
            0.018,
            STEEL,
        );
        let (rear, front) = if ahead { (-0.85, end) } else { (end, mast - 0.02 + shift) };
        b.plank("link", [rear, y * 0.42, lift], [front, y * 0.42, 0.22 + y * 0.05], (0.04, 0.04), BLACK_METAL);
        b.pad(
            "pedal",
            [-0.35 + shift, y * 0.48 - 0.2, lift + 0.015],
            [0.1 + shift, y * 0.48 + 0.2, lift + 0.06],
            0.015,
            BLACK_PLASTIC,
        );
        b.plank("lever", [mast + shift, y * 0.5, 0.2 + y * 0.05], [mast + 0.02, y * 0.6, 0.6], (0.035, 0.04), case);
        b.bent_rod(
            "arm",
            &[
                [mast + 0.02, y * 0.6, 0.58],
                [mast - 0.12 - shift, y * 0.76, 0.85],
                [mast - 0.2 - shift, y * 0.7, 0.955],
            ],
            0.02,
            BLACK_METAL,
        );
        b.pole("grip", [mast - 0.12 - shift, y * 0.76, 0.85], [mast - 0.2 - shift, y * 0.7, 0.96], 0.026, RUBBER);
    }
    b.pole("pivot", [mast + 0.02, -0.64, 0.6], [mast + 0.02, 0.64, 0.6], 0.022, STEEL);
    if ahead {
        b.plank("track", [-0.9, 0.0, 0.1], [-0.2, 0.0, 0.1], (b.size.y * 0.6, 0.02), ALUMINIUM);
        b.plank("track_post", [-0.86, 0.0, 0.04], [-0.86, 0.0, 0.11], (b.size.y * 0.3, 0.03), BLACK_METAL);
    }
    display(b, [mast, 0.0, 0.92], (b.size.y * 0.26, b.size.z * 0.065), 0.3, BLACK_PLASTIC);
}

/// A stair climber: endless steps between side walls, with rails and console.
pub(super) fn stairs(b: &mut Build<'_>) {
    spare(b, 0.0, 0.0, 0.01);
    let (case, trim) = (
        b.choose(&[GREY_PLASTIC, BLACK_PLASTIC, SILVER_METAL]),
        b.choose(&[RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]),
    );
    for y in SIDES {
        let side = [(-0.85, 0.0), (0.95, 0.0), (0.98, 0.5), (0.8, 0.56), (-0.8, 0.14)];
        b.side_outline("side", (y * 0.87 - 0.1, y * 0.87 + 0.1), &side, case);
        let rail = [[-0.7, y * 0.88, 0.14], [-0.5, y * 0.88, 0.56], [0.55, y * 0.88, 0.78], [0.62, y * 0.88, 0.5]];
        b.bent_rod("rail", &rail, 0.02, BLACK_METAL);
        b.plank("mast", [0.8, y * 0.8, 0.5], [0.72, y * 0.8, 0.9], (0.05, 0.07), case);
    }
    for i in 0..4 {
        let (x, z) = (-0.78 + 0.38 * i as f32, 0.1 + 0.11 * i as f32);
        b.slab("step", [x, -0.8, z - 0.02], [x + 0.42, 0.8, z], BLACK_PLASTIC);
        b.slab("edge", [x - 0.01, -0.74, z - 0.022], [x + 0.05, 0.74, z + 0.003], trim);
        b.slab("riser", [x + 0.36, -0.76, z - 0.01], [x + 0.4, 0.76, z + 0.09], case);
    }
    b.slab("base", [-0.98, -0.79, 0.0], [0.9, 0.79, 0.05], case);
    b.plank("dash", [0.6, 0.0, 0.86], [0.82, 0.0, 0.9], (b.size.y * 0.84, 0.05), case);
    display(b, [0.76, 0.0, 0.936], (b.size.y * 0.3, b.size.z * 0.052), 0.3, BLACK_PLASTIC);
}

/// A ski ergometer: a tall board with a fan on top and two pull handles.
pub(super) fn ski(b: &mut Build<'_>) {
    let frame = b.choose(&[BLACK_METAL, SILVER_METAL, WHITE_METAL]);
    let ahead = 1.0 - (0.3 / b.size.x).min(1.2);
    b.slab("platform", [-0.98, -0.9, 0.0], [ahead, 0.9, 0.03], BLACK_PLASTIC);
    b.slab("tread", [-0.9, -0.8, 0.02], [ahead - 0.1, 0.8, 0.035], GREY_RUBBER);
    b.slab("base", [ahead - 0.02, -1.0, 0.0], [0.98, 1.0, 0.04], frame);
    let (low, high) = (ahead + (1.0 - ahead) * 0.25, ahead + (1.0 - ahead) * 0.7);
    b.slab("column", [low, -0.2, 0.03], [high, 0.2, 0.95], frame);
    let r = (b.size.y * 0.42).min(b.size.z * 0.13);
    let z = 0.998 - r / b.size.z;
    let wide = (b.size.x * 0.3).min(0.2);
    let x = (low + high) / 2.0;
    b.wheel("fan", Axis::X, [x, 0.0, z], (r, wide.min(b.size.x * (1.0 - x) * 0.9)), BLACK_PLASTIC);
    b.wheel("vent", Axis::X, [x, 0.0, z], (r * 0.7, wide.min(b.size.x * (1.0 - x) * 0.9) + 0.006), GREY_PLASTIC);
    for y in SIDES {
        b.plank("arm", [low, y * 0.1, 0.84], [low - 0.1, y * 0.6, 0.88], (0.03, 0.03), frame);
        b.pole("cord", [low - 0.1, y * 0.6, 0.88], [low - 0.1, y * 0.6, 0.74], 0.005, BLACK_FABRIC);
        b.pole("handle", [low - 0.1, y * 0.78, 0.73], [low - 0.1, y * 0.42, 0.75], 0.015, RUBBER);
    }
    display(b, [low - 0.03, 0.0, 0.68], (b.size.y * 0.2, b.size.z * 0.045), 0.2, BLACK_PLASTIC);
}

/// A vibration plate, flat or with a column and handles.
pub(super) fn vibration_plate(b: &mut Build<'_>) {
    let (case, trim) =
        (b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]), b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC]));
    let tall = b.size.z > 0.5;
    let deck = (0.14 / b.size.z).min(0.92);
    let high = if tall { deck } else { 0.93 };
    let outline = rounded_between((-0.98, -0.98), (0.98, 0.98), (0.4, 0.3));
    let foot: Vec<_> = outline.iter().map(|&(x, y)| (x * 0.9, y * 0.9)).collect();
    b.plan_outline("base", (0.0, high * 0.4), &foot, BLACK_PLASTIC);
    b.plan_outline("plate", (high * 0.35, high), &outline, case);
    let ahead = if tall { 0.5 } else { 0.85 };
    b.plan_outline(
        "tread",
        (high * 0.9, high * 1.05),
        &rounded_between((-0.85, -0.85), (ahead, 0.85), (0.3, 0.3)),
        RUBBER,
    );
    let place = [(ahead - 0.85) / 2.0, 0.0, high * 1.05];
    b.deck("plate", place, ((ahead + 0.85) / 2.0 - 0.12, 0.7));
    if !tall {
        b.slab("display", [0.87, -0.2, high * 0.9], [0.95, 0.2, high * 1.03], LED);
        return;
    }
    b.side_outline("column", (-0.2, 0.2), &[(0.55, high * 0.8), (0.95, high * 0.8), (0.85, 0.9), (0.65, 0.9)], case);
    b.slab("stripe", [0.52, -0.06, high * 1.2], [0.66, 0.06, 0.8], trim);
    for y in SIDES {
        b.bent_rod("handle", &[[0.75, 0.0, 0.84], [0.6, y * 0.75, 0.84], [0.56, y * 0.75, 0.72]], 0.016, RUBBER);
    }
    display(b, [0.7, 0.0, 0.93], (b.size.y * 0.24, b.size.z * 0.06), 0.3, BLACK_PLASTIC);
}
