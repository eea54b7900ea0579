//! The chassis of lorries, buses and motorhomes: a frame on axles, and a cab.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::car::pane;
use super::wheel::{Rim, wheel};
use crate::material::*;
use crate::solid::{Axis, Build, spaced};

/// Paint colours.
pub(super) const PAINTS: &[MaterialId] =
    &[WHITE_METAL, RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL, SILVER_METAL, NAVY, ORANGE];

/// Dimensions of a lorry, metres.
pub(super) struct Chassis {
    pub(super) front: f32,
    pub(super) half: f32,
    pub(super) wheel: f32,
    /// Height of the frame's upper side.
    pub(super) deck: f32,
    /// Rear end of the cab.
    pub(super) cab: f32,
    pub(super) paint: MaterialId,
}

impl Chassis {
    /// The frame and its wheels: two axles, or three for long vehicles.
    pub(super) fn build(&self, b: &mut Build<'_>) {
        let rear = -self.front;
        b.block(
            "frame",
            [rear + 0.1, -self.half * 0.45, self.deck - 0.22],
            [self.front - 0.3, self.half * 0.45, self.deck],
            IRON,
        );
        let axles = self.axles();
        let rim = Rim::plain(b);
        let width = self.half * 0.26;
        for (i, &x) in axles.iter().enumerate() {
            for (side, letter) in [(1.0, 'l'), (-1.0, 'r')] {
                let end = ["f", "r", "m"][i];
                let y = side * (self.half - 0.02 - width / 2.0);
                wheel(b, &format!("wheel_{end}{letter}"), [x, y, self.wheel], self.wheel, width, side, rim);
            }
            b.rod("axle", [x, -self.half * 0.8, self.wheel], [x, self.half * 0.8, self.wheel], self.wheel * 0.14, IRON);
            b.block(
                "spring",
                [x - 0.08, -self.half * 0.44, self.wheel - 0.05],
                [x + 0.08, self.half * 0.44, self.deck - 0.1],
                IRON,
            );
        }
    }

    pub(super) fn axles(&self) -> Vec<f32> {
        let rear = -self.front * 0.6;
        let mut axles = vec![self.front - (self.front - self.cab) * 0.5 - self.wheel * 0.4, rear];
        if self.front > 4.3 {
            axles.push(rear + self.wheel * 2.3);
        }
        axles
    }

    /// The cab: a block with a slanted windscreen, cut-out arches, windows, lights and mirrors.
    pub(super) fn cabin(&self, b: &mut Build<'_>, high: f32) {
        let (x0, x1, half) = (self.cab, self.front - 0.08, self.half * 0.96);
        let low = self.wheel * 0.75;
        let (arch, r) = (self.axles()[0], self.wheel * 1.15);
        let open = arch - r < x0 + 0.05;
        let belt = low + (high - low) * 0.48;
        let lean = (high - belt) * b.vary(0.05, 0.3);
        let mut outline =
            vec![(x0, if open { self.wheel + r } else { low }), (x0, high), (x1 - lean, high), (x1, belt), (x1, low)];
        let start = ((low - self.wheel) / r).arc_sine();
        let end = if open { PI * 0.5 } else { PI - start };
        outline.extend(
            (0..=8)
                .map(|i| start + (end - start) * i as f32 / 8.0)
                .map(|a| ((arch + r * a.cosine()).max(x0 + 0.01), self.wheel + r * a.sine())),
        );
        b.prism("cab", Axis::Y, [0.0, -half, 0.0], &outline, 2.0 * half, self.paint);
        let screen = [[x1, -half, belt], [x1, half, belt], [x1 - lean, half, high], [x1 - lean, -half, high]];
        pane(b, "windscreen", screen, (0.05, 0.95, 0.05, 0.88), BLACK_GLASS);
        for side in [1.0, -1.0] {
            let y = side * half;
            let (f, k) = ([x1 - lean * 0.5 - 0.05, y, belt], [x0 + (x1 - x0) * 0.2, y, belt]);
            let (ft, kt) = ([x1 - lean - 0.05, y, high], [k[0], y, high]);
            let face = if side > 0.0 { [f, k, kt, ft] } else { [k, f, ft, kt] };
            pane(b, "window", face, (0.04, 0.96, 0.05, 0.85), BLACK_GLASS);
            b.block(
                "seam",
                [k[0] - 0.05, y - 0.003, belt - (belt - low) * 0.5],
                [k[0] - 0.04, y + 0.003, high - 0.1],
                BLACK_PLASTIC,
            );
            b.block(
                "handle",
                [k[0] + 0.05, y - 0.02, belt - 0.14],
                [k[0] + 0.22, y + 0.02, belt - 0.11],
                BLACK_PLASTIC,
            );
            let my = side * (self.half - 0.005);
            b.block(
                "mirror",
                [x1 - 0.05, my.min(y - side * 0.02), belt + 0.1],
                [x1 + 0.05, my.max(y - side * 0.02), belt + (high - belt) * 0.65],
                BLACK_PLASTIC,
            );
            let lamp = side * half * 0.78;
            b.block(
                "headlight",
                [x1 - 0.02, lamp - 0.14, low + 0.12],
                [self.front - 0.03, lamp + 0.14, low + 0.28],
                COOL_BULB,
            );
            b.block(
                "tail_light",
                [-self.front + 0.09, lamp - 0.12, self.deck - 0.2],
                [-self.front + 0.12, lamp + 0.12, self.deck - 0.08],
                SIGNAL_RED,
            );
            b.block(
                "arm",
                [-self.front + 0.1, lamp - 0.05, self.deck - 0.18],
                [-self.front + 0.4, lamp + 0.05, self.deck - 0.1],
                IRON,
            );
            b.block(
                "arm",
                [-self.front + 0.3, (side * self.half * 0.4).min(lamp), self.deck - 0.17],
                [-self.front + 0.39, (side * self.half * 0.4).max(lamp), self.deck - 0.11],
                IRON,
            );
        }
        let bars = b.rng.count(2, 5);
        for z in spaced(bars, low + 0.36, belt - 0.12) {
            b.block("grille", [x1 - 0.01, -half * 0.55, z - 0.025], [x1 + 0.02, half * 0.55, z + 0.025], BLACK_PLASTIC);
        }
        b.rounded_block(
            "bumper",
            [x1 - 0.1, -half, low - 0.06],
            [self.front, half, low + 0.1],
            0.03,
            b.style.appliance,
        );
        b.block("plate", [self.front - 0.01, -0.26, low], [self.front + 0.0, 0.26, low + 0.08], WHITE_PLASTIC);
    }
}
