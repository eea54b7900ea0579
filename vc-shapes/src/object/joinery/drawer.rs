//! Drawers of furniture.

use super::{BOARD, GAP, Handle, gapped, handle};
use crate::material::MaterialId;
use crate::solid::{Build, P};

/// A drawer that fills the space `low..high`: its front at the high X, its tray behind; it slides
/// out by three quarters of its depth.
pub(in crate::object) fn drawer(
    b: &mut Build<'_>,
    name: &str,
    low: P,
    high: P,
    kind: Handle,
    mats: (MaterialId, MaterialId, MaterialId),
) {
    let (front, tray, metal) = mats;
    let (fl, fh) = gapped([high[0] - BOARD, low[1], low[2]], high, GAP / 2.0);
    let t = 0.012;
    let (x0, x1) = (low[0] + 0.02, high[0] - BOARD);
    let (y0, y1) = (low[1] + 0.022, high[1] - 0.022);
    let (z0, z1) = (low[2] + 0.012, high[2] - 0.03);
    b.slide([1.0, 0.0, 0.0], (x1 - x0) * 0.75, |b| {
        b.block(name, fl, fh, front);
        b.block("tray", [x0, y0, z0], [x1, y1, z0 + t], tray);
        b.block("tray", [x0, y0, z0 + t], [x1, y0 + t, z1], tray);
        b.block("tray", [x0, y1 - t, z0 + t], [x1, y1, z1], tray);
        b.block("tray", [x0, y0 + t, z0 + t], [x0 + t, y1 - t, z1], tray);
        let length = ((fh[1] - fl[1]) * 0.4).min(0.2);
        handle(b, kind, [fh[0], f32::midpoint(fl[1], fh[1]), f32::midpoint(fl[2], fh[2])], length, false, metal);
        let centre = [(x0 + t + x1) / 2.0, (y0 + y1) / 2.0, z0 + t];
        let half = ((x1 - x0 - t) / 2.0 - 0.005, (y1 - y0) / 2.0 - t - 0.005);
        b.inside(name, centre, half, (high[2] - z0 - t - 0.02).max(0.0));
    });
}
