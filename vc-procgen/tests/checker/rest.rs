//! Everything rests on the supports that the graph names, hangs from them, or is fixed to the
//! building.

use super::shape::{P, V, hit};
use super::thing::{Piece, TOUCH, Thing};
use super::{House, Rule};

/// The greatest gap between a base and its support.
const GAP: f64 = 0.005;
/// The greatest distance of an object fixed to a wall from the wall.
const OFF_WALL: f64 = 0.03;
/// The greatest distance of a hung object's top from its hook.
const HOOK: f64 = 0.02;
/// The greatest distance of an object's centre beyond the points it rests on.
const TIP: f64 = 0.015;
/// The tilt by which objects may settle: a ladle on its rim.
const SETTLE: f64 = 0.02;

pub(super) fn look(house: &mut House<'_>) {
    let mut found = Vec::new();
    for thing in house.things.iter().filter(|t| !t.is_building()) {
        let carriers: Vec<&Thing> =
            thing.carriers.iter().filter_map(|c| house.at.get(c)).map(|&i| &house.things[i]).collect();
        let wrong = if carriers.is_empty() { floats(house, thing) } else { falls(thing, &carriers) };
        found.extend(wrong.map(|(group, text)| (Rule::Support, group, text)));
        found.extend(outside(house, thing).map(|text| (Rule::Outside, thing.class.clone(), text)));
    }
    found.into_iter().for_each(|(rule, group, text)| house.note(rule, group, text));
}

/// An object without a support must be at a wall or the ceiling.
fn floats(house: &House<'_>, thing: &Thing) -> Option<(String, String)> {
    let ceiling = f64::from(house.plan.ceiling) - thing.high.z;
    let walls = house.things.iter().filter(|t| t.class == "wall" || t.class == "railing").flat_map(|t| &t.pieces);
    let gap = |low: &P, high: &P, p: &Piece| (p.low - high).sup(&(low - p.high)).sup(&V::zeros()).norm();
    let nearest = walls
        .filter(|w| gap(&thing.low, &thing.high, w) <= OFF_WALL)
        .flat_map(|w| thing.pieces.iter().map(move |p| gap(&p.low, &p.high, w)))
        .fold(f64::INFINITY, f64::min);
    let fixed = nearest <= OFF_WALL || ceiling.abs() <= GAP;
    let text = format!("{}: {nearest:.3} m off walls, {ceiling:.3} m below the ceiling", thing.label);
    (!fixed).then(|| (format!("{} floats", thing.class), text))
}

/// A supported object must be close above a surface of a carrier, with its centre above the points
/// it touches, or hang from a hook.
fn falls(thing: &Thing, carriers: &[&Thing]) -> Option<(String, String)> {
    if carriers.iter().any(|c| c.hooks.iter().any(|h| hangs(thing, h))) {
        return None;
    }
    let (on, middle) = (carriers[0], middle(thing));
    let below = contacts(thing, carriers);
    let gap = below.iter().map(|c| c.1).fold(f64::INFINITY, |a, b| if b.abs() < a.abs() { b } else { a });
    if gap.abs() > GAP {
        let text = format!("{}: nearest surface of {} is {:.1} mm below", thing.label, on.label, gap * 1e3);
        return Some((format!("{} on {}", thing.class, on.class), text));
    }
    // A fixed object need not balance.
    let fixed = matches!(&*thing.class, "faucet" | "radiator");
    let touched: Vec<P> = below.into_iter().filter(|c| c.1.abs() <= SETTLE).map(|c| c.0).collect();
    let beyond = beyond(&middle, &touched);
    let text = format!("{}: its middle is {:.0} mm beyond what it touches of {}", thing.label, beyond * 1e3, on.label);
    (beyond > TIP && !fixed).then(|| (format!("{} tips on {}", thing.class, on.class), text))
}

/// Points of its underside with their gaps to a carrier, tested from below and from above: a bottle
/// stands between the wires of a rack.
fn contacts(thing: &Thing, carriers: &[&Thing]) -> Vec<(P, f64)> {
    let mut found = Vec::new();
    for carrier in carriers {
        found.extend(feet(thing).into_iter().filter_map(|foot| Some((foot, gap_below(&foot, carrier)?))));
    }
    let touched: Vec<P> = found.iter().filter(|c| c.1.abs() <= GAP).map(|c| c.0).collect();
    if beyond(&middle(thing), &touched) > 0.0 || touched.is_empty() {
        for carrier in carriers {
            found.extend(ridges(thing, carrier).into_iter().filter_map(|top| Some((top, gap_above(&top, thing)?))));
        }
    }
    found
}

fn hangs(thing: &Thing, hook: &P) -> bool {
    let beside = (thing.low.x - hook.x).max(hook.x - thing.high.x).max(thing.low.y - hook.y).max(hook.y - thing.high.y);
    (thing.high.z - hook.z).abs() <= HOOK && beside <= HOOK
}

/// Points of its underside: the low ones, the same drawn in, and their centre.
fn feet(thing: &Thing) -> Vec<P> {
    let low = thing.low.z + SETTLE;
    let pieces = thing.pieces.iter().filter(|p| p.low.z < low);
    // Only some points of each piece: a notebook's spiral has a thousand, its cover four.
    let mut feet: Vec<P> = pieces.flat_map(|piece| some_of(piece.points.iter().filter(|p| p.z < low))).collect();
    let centre = P::from(feet.iter().map(|p| p.coords).sum::<V>() / feet.len() as f64);
    let drawn_in: Vec<P> = feet.iter().map(|p| p + (centre - p).component_mul(&V::new(0.15, 0.15, 0.0))).collect();
    feet.extend(drawn_in);
    feet.push(P::new(centre.x, centre.y, thing.low.z));
    feet
}

/// At most about a hundred points, including the lowest.
fn some_of<'a>(points: impl Iterator<Item = &'a P>) -> Vec<P> {
    let all: Vec<P> = points.copied().collect();
    let step = all.len().div_ceil(100).max(1);
    let lowest = all.iter().copied().min_by(|a, b| a.z.total_cmp(&b.z));
    all.into_iter().step_by(step).chain(lowest).collect()
}

/// Points along the edges of a carrier at the height of an object's base and below it.
fn ridges(thing: &Thing, carrier: &Thing) -> Vec<P> {
    let level = |z: f64| (z - thing.low.z).abs() <= SETTLE;
    let under = |p: &P| (0..2).all(|k| p[k] >= thing.low[k] && p[k] <= thing.high[k]);
    let near = |p: &&Piece| p.high.z >= thing.low.z - SETTLE && p.low.z <= thing.low.z + SETTLE;
    let beside = |p: &&Piece| (0..2).all(|k| p.low[k] <= thing.high[k] && p.high[k] >= thing.low[k]);
    let mut points = Vec::new();
    for [a, b, c] in carrier.pieces.iter().filter(near).filter(beside).flat_map(Piece::triangles) {
        for (from, to) in [(a, b), (b, c), (c, a)].into_iter().filter(|e| level(e.0.z) && level(e.1.z)) {
            let steps = ((to - from).norm() / 0.01).ceil().max(1.0) as usize;
            points.extend((0..=steps).map(|i| from + (to - from) * (i as f64 / steps as f64)).filter(under));
        }
    }
    points
}

/// The distance from a point up to an object's underside (also found up to 2 cm below).
fn gap_above(top: &P, thing: &Thing) -> Option<f64> {
    let from = top - V::new(0.0, 0.0, 0.02);
    let over = |p: &&Piece| (0..2).all(|k| p.low[k] <= from[k] && p.high[k] >= from[k]);
    let hits = thing.pieces.iter().filter(over).flat_map(Piece::triangles).filter_map(|t| hit(&t, &from, &V::z()));
    hits.map(|h| h.0).filter(|h| *h >= 0.0).map(|h| h - 0.02).reduce(f64::min)
}

/// The distance from a foot down to the highest surface (also found up to 2 cm above).
fn gap_below(foot: &P, carrier: &Thing) -> Option<f64> {
    let from = foot + V::new(0.0, 0.0, 0.02);
    let over = |p: &&Piece| {
        p.low.x <= from.x && p.high.x >= from.x && p.low.y <= from.y && p.high.y >= from.y && p.low.z < from.z
    };
    let down = -V::z();
    let hits = carrier.pieces.iter().filter(over).flat_map(|p| {
        let near = |t: &[P; 3]| t[0].inf(&t[1]).inf(&t[2]).z < from.z;
        p.triangles().filter(near).filter_map(|t| hit(&t, &from, &down)).map(|h| h.0).collect::<Vec<_>>()
    });
    hits.filter(|h| *h >= 0.0).map(|h| h - 0.02).reduce(f64::min)
}

/// The centroid of its volume.
fn middle(thing: &Thing) -> P {
    let (mut sum, mut all) = (V::zeros(), 0.0);
    for [a, b, c] in thing.pieces.iter().flat_map(Piece::triangles) {
        let (a, b, c) = (a - thing.low, b - thing.low, c - thing.low);
        let volume = a.dot(&b.cross(&c));
        sum += (a + b + c) / 4.0 * volume;
        all += volume;
    }
    if all > 0.0 { thing.low + sum / all } else { nalgebra::center(&thing.low, &thing.high) }
}

/// The distance of a point outside the hull of others, seen from above.
fn beyond(p: &P, of: &[P]) -> f64 {
    let ways = (0..48).map(|i| (f64::from(i) * std::f64::consts::TAU / 48.0).sin_cos());
    let out = ways.map(|(s, c)| {
        let along = |q: &P| q.x * c + q.y * s;
        along(p) - of.iter().map(along).fold(f64::NEG_INFINITY, f64::max)
    });
    out.fold(f64::NEG_INFINITY, f64::max)
}

/// Whether an object is outside its room's walls, floor and ceiling.
fn outside(house: &House<'_>, thing: &Thing) -> Option<String> {
    let room = thing.room.and_then(|r| house.room_index(r));
    let Some(room) = room else { return Some(format!("{} is in no room", thing.label)) };
    let (low, high) = (thing.low, thing.high);
    let ceiling = f64::from(house.plan.ceiling);
    if low.z < -TOUCH || high.z > ceiling + TOUCH {
        return Some(format!(
            "{} reaches from {:.3} to {:.3} m, the ceiling is at {ceiling}",
            thing.label, low.z, high.z
        ));
    }
    let out = |x: f64, y: f64| !house.is_within(room, x, y, TOUCH);
    let corners = [(low.x, low.y), (low.x, high.y), (high.x, low.y), (high.x, high.y)];
    if !corners.iter().any(|c| out(c.0, c.1)) {
        return None;
    }
    let points = thing.pieces.iter().flat_map(|p| p.points.iter());
    let wrong = points.filter(|p| out(p.x, p.y)).max_by(|a, b| a.z.total_cmp(&b.z))?;
    Some(format!("{} is at ({:.3}, {:.3}), not between the walls of room {room}", thing.label, wrong.x, wrong.y))
}
