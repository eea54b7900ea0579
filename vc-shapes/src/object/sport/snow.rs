//! Skates, skis, boards and sleds.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, band};

/// A pair of ice skates.
pub(super) fn skates(b: &mut Build<'_>) {
    let boot = b.choose(&[WHITE_LEATHER, BLACK_LEATHER, BROWN_LEATHER]);
    for y in SIDES {
        let at = y * 0.54;
        b.within([-1.0, at - 0.44, 0.0], [1.0, at + 0.44, 1.0], |b| {
            b.side_outline(
                "blade",
                (-0.06, 0.06),
                &[(-0.95, 0.03), (-0.9, 0.0), (0.8, 0.0), (0.98, 0.06), (0.95, 0.1), (-0.95, 0.08)],
                STEEL,
            );
            for x in [-0.55, 0.5] {
                b.slab("post", [x - 0.12, -0.05, 0.06], [x + 0.12, 0.05, 0.22], STEEL);
            }
            super::boot(b, 0.22, boot, BROWN_LEATHER);
        });
    }
}

/// A pair of upright skis with bindings, and two poles.
pub(super) fn skis(b: &mut Build<'_>) {
    let (deck, trim) = (b.one_of(PAINTS), b.choose(&[WHITE, BLACK, YELLOW]));
    let t = 0.1;
    for y in SIDES {
        let (low, high) = (y * 0.44 - 0.3, y * 0.44 + 0.3);
        let at = y * 0.44;
        let outline = [
            (at - 0.24, 0.0),
            (at + 0.24, 0.0),
            (high - 0.06, 0.12),
            (at + 0.2, 0.45),
            (high, 0.86),
            (at + 0.15, 0.955),
            (at - 0.15, 0.955),
            (low, 0.86),
            (at - 0.2, 0.45),
            (low + 0.06, 0.12),
        ];
        b.front_outline("ski", (-0.45 - t, -0.45 + t), &outline, deck);
        b.chunk(
            "tip",
            &[
                [-0.55, at + 0.2, 0.93],
                [-0.35, at + 0.2, 0.93],
                [-0.55, at - 0.2, 0.93],
                [-0.35, at - 0.2, 0.93],
                [0.0, at + 0.08, 0.998],
                [0.1, at + 0.08, 0.993],
                [0.0, at - 0.08, 0.998],
                [0.1, at - 0.08, 0.993],
            ],
            deck,
        );
        b.slab("stripe", [-0.36, at - 0.08, 0.55], [-0.33, at + 0.08, 0.9], trim);
        b.slab("toe", [-0.4, at - 0.2, 0.5], [0.35, at + 0.2, 0.54], BLACK_PLASTIC);
        b.slab("heel", [-0.4, at - 0.18, 0.33], [0.5, at + 0.18, 0.39], BLACK_PLASTIC);
        b.slab("plate", [-0.42, at - 0.15, 0.34], [-0.2, at + 0.15, 0.53], GREY_PLASTIC);
        let pole = y * 0.86;
        b.pole("pole", [0.6, pole, 0.0], [0.6, pole, 0.7], 0.006, ALUMINIUM);
        b.pole("grip", [0.6, pole, 0.63], [0.6, pole, 0.71], (b.size.y * 0.06).min(0.013), RUBBER);
        b.wheel("basket", Axis::Z, [0.6, pole, 0.04], ((b.size.y * 0.07).min(b.size.x * 0.2), 0.006), trim);
    }
    b.slab("strap", [-0.6, -0.6, 0.75], [-0.3, 0.6, 0.765], BLACK_FABRIC);
    b.slab("rest", [-0.5, -0.92, 0.0], [0.7, 0.92, 0.006], BLACK_PLASTIC);
}

/// A snowboard with bindings or a surfboard with fins, upright.
pub(super) fn board(b: &mut Build<'_>) {
    let surf = b.class == "surfboard";
    let (deck, trim) = (b.choose(&[WHITE, RED, BLUE, YELLOW, SKY, ORANGE, BLACK]), b.one_of(PAINTS));
    let side: &[(f32, f32)] = if surf {
        &[(0.45, 0.0), (0.8, 0.14), (0.98, 0.4), (0.97, 0.6), (0.7, 0.85), (0.3, 0.97), (0.0, 1.0)]
    } else {
        &[(0.5, 0.0), (0.85, 0.05), (1.0, 0.14), (0.82, 0.5), (1.0, 0.86), (0.85, 0.95), (0.5, 1.0)]
    };
    let mirrored = side.iter().rev().filter(|p| p.0 > 0.0).map(|&(y, z)| (-y, z));
    let outline: Vec<_> = side.iter().copied().chain(mirrored).collect();
    let (back, front) = if surf { (-0.5, 0.1) } else { (-0.95, -0.72) };
    b.front_outline("board", (back, front), &outline, deck);
    let smaller: Vec<_> = outline.iter().map(|&(y, z)| (y * 0.95, 0.5 + (z - 0.5) * 0.97)).collect();
    b.front_outline("deck", (back + 0.1, front + 0.06), &smaller, if surf { deck } else { trim });
    if surf {
        b.slab("stringer", [0.0, -0.015, 0.02], [0.18, 0.015, 0.96], trim);
        b.slab("band", [0.0, -0.97, 0.42], [0.175, 0.97, 0.52], trim);
        b.slab("grip", [0.02, -0.35, 0.08], [0.2, 0.35, 0.2], BLACK_PLASTIC);
        for y in [-0.4, 0.0, 0.4] {
            b.within([-1.0, y - 0.02, 0.0], [1.0, y + 0.02, 1.0], |b| {
                b.side_outline("fin", (-1.0, 1.0), &[(-0.45, 0.06), (-1.0, 0.05), (-0.9, 0.08), (-0.45, 0.14)], trim)
            });
        }
        b.slab("strap", [0.05, -0.1, 0.03], [0.98, 0.1, 0.06], BLACK_FABRIC);
        return;
    }
    for z in [0.32, 0.66] {
        b.slab("plate", [-0.72, -0.8, z - 0.05], [-0.4, 0.8, z + 0.05], BLACK_PLASTIC);
        b.slab("highback", [-0.45, 0.5, z - 0.05], [0.98, 0.72, z + 0.05], BLACK_PLASTIC);
        for (x, y) in [(0.5, 0.1), (0.2, -0.4)] {
            b.slab("strap", [x - 0.12, y - 0.14, z - 0.06], [x + 0.12, y + 0.14, z + 0.06], trim);
            for s in SIDES {
                b.slab(
                    "ladder",
                    [-0.5, y - 0.08, z + s * 0.052 - 0.006],
                    [x + 0.11, y + 0.08, z + s * 0.052 + 0.006],
                    BLACK_PLASTIC,
                );
            }
        }
    }
}

/// A wooden sledge on runners, or a plastic one with brakes.
pub(super) fn sled(b: &mut Build<'_>) {
    if b.rng.chance(0.5) {
        let (mat, brake) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
        let side = [
            (-1.0, 0.06),
            (-0.9, 0.0),
            (0.6, 0.0),
            (0.85, 0.2),
            (1.0, 0.8),
            (0.9, 0.8),
            (0.7, 0.35),
            (0.5, 0.2),
            (-0.9, 0.2),
            (-0.95, 0.3),
        ];
        b.side_outline("shell", (-0.9, 0.9), &side, mat);
        for y in SIDES {
            b.side_outline(
                "wall",
                (y * 0.93 - 0.07, y * 0.93 + 0.07),
                &[(-0.98, 0.1), (0.6, 0.1), (0.9, 0.55), (0.5, 0.6), (-0.9, 0.8)],
                mat,
            );
            b.pole("brake", [0.05, y * 0.9, 0.35], [0.2, y * 0.9, 0.99], 0.012_f32.min(b.size.y * 0.03), brake);
        }
        b.slab("seat", [-0.95, -0.86, 0.18], [0.1, 0.86, 0.42], mat);
        b.slab("backrest", [-0.97, -0.86, 0.4], [-0.85, 0.86, 0.9], mat);
        b.deck("seat", [-0.35, 0.0, 0.42], (0.4, 0.7));
        return;
    }
    let wood = b.choose(&[ASH, BEECH, PINE]);
    for y in SIDES {
        let edge = (y * 0.8 - 0.06, y * 0.8 + 0.06);
        let curve = [(-0.95, 0.012), (0.55, 0.012), (0.8, 0.1), (0.95, 0.35), (0.99, 0.7)];
        b.side_outline("runner", edge, &band(&curve, (-0.04, 0.12)), wood);
        b.side_outline(
            "steel",
            (edge.0 + 0.02, edge.1 - 0.02),
            &[(-0.94, 0.0), (0.5, 0.0), (0.5, 0.03), (-0.94, 0.03)],
            STEEL,
        );
        for x in [-0.7, 0.0, 0.5] {
            b.slab("post", [x - 0.04, edge.0 + 0.02, 0.08], [x + 0.04, edge.1 - 0.02, 0.88], wood);
        }
    }
    for x in [-0.7, 0.0, 0.5] {
        b.slab("crossbar", [x - 0.06, -0.86, 0.8], [x + 0.06, 0.86, 0.88], wood);
    }
    let count = 5;
    for i in 0..count {
        let y = -0.98 + 1.96 * (i as f32 + 0.1) / count as f32;
        b.pad("slat", [-0.98, y, 0.88], [0.75, y + 1.96 * 0.8 / count as f32, 0.998], 0.003, wood);
    }
    b.pole("pull", [0.93, -0.8, 0.62], [0.93, 0.8, 0.62], 0.006, JUTE);
    b.deck("seat", [-0.1, 0.0, 0.998], (0.8, 0.9));
}
