//! No two solids overlap.

use super::shape::P;
use super::thing::{TOUCH, Thing};
use super::{House, Rule};

/// The depth by which a hanging object may overlap its support: a coat on its hook.
const HANGING: f64 = 0.02;

pub(super) fn look(house: &mut House<'_>) {
    let mut found = Vec::new();
    for (i, a) in house.things.iter().enumerate() {
        for b in &house.things[i + 1..] {
            let apart = (0..3).any(|k| a.low[k] > b.high[k] - TOUCH || b.low[k] > a.high[k] - TOUCH);
            if apart || a.is_building() && b.is_building() {
                continue;
            }
            let allowed = if hangs(a, b) || hangs(b, a) { HANGING } else { TOUCH };
            found.extend(meet(a, b, allowed).map(|text| (group(a, b), text)));
        }
    }
    found.into_iter().for_each(|(group, text)| house.note(Rule::Collision, group, text));
}

fn group(a: &Thing, b: &Thing) -> String {
    let (a, b) = (a.class.as_str().min(&b.class), a.class.as_str().max(&b.class));
    format!("{a} / {b}")
}

/// Whether one hangs from the other: from a hook, or as a curtain from its rod.
fn hangs(what: &Thing, from: &Thing) -> bool {
    let hook = what.carriers.contains(&from.id) && !from.hooks.is_empty();
    hook || what.class == "curtain" && from.class == "curtain_rod"
}

/// A description of the deepest overlap of parts.
fn meet(a: &Thing, b: &Thing, allowed: f64) -> Option<String> {
    let mut worst: Option<(f64, P, &str, &str)> = None;
    for x in &a.pieces {
        for y in &b.pieces {
            let Some((depth, at)) = x.penetration(y) else { continue };
            if depth > worst.map_or(allowed, |w| w.0) {
                worst = Some((depth, at, &x.name, &y.name));
            }
        }
    }
    let (depth, at, x, y) = worst?;
    let place = format!("({:.3}, {:.3}, {:.3})", at.x, at.y, at.z);
    Some(format!("{} ({x}) and {} ({y}) share {:.1} mm at {place}", a.label, b.label, depth * 1e3))
}
