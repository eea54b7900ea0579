//! Surfaces: over the object, supported by it, with free space above.

use vc_graph::Property;
use vc_graph::asset::{Hold, Surface};

use crate::cases::{Case, Rule};
use crate::solid::{P, Solid, V};

type Say<'a> = &'a mut dyn FnMut(Rule, String);

/// The margin by which the free space is tested smaller than declared on every side, metres.
const SHRUNK: f64 = 0.005;

/// The number of points tested along each side.
const POINTS: usize = 7;

pub(crate) fn check(case: &Case, say: Say<'_>) {
    affordances(case, say);
    for surface in &case.object.asset.surfaces {
        within(case, surface, say);
        let link: Vec<&Solid> = case.solids.iter().filter(|s| s.joint == surface.joint).collect();
        match surface.hold {
            Hold::Hook => below(surface, &link, say),
            Hold::On | Hold::Inside => {
                carried(surface, &link, say);
                let link: Vec<&Solid> = link.into_iter().filter(|s| !s.liquid).collect();
                above(case, surface, &link, say);
            }
        }
    }
}

fn affordances(case: &Case, say: Say<'_>) {
    let holds = |hold| case.object.asset.surfaces.iter().any(|s| s.hold == hold);
    let affords = |p| case.class.affordances.contains(p);
    if affords(Property::Surface) && !holds(Hold::On) {
        say(Rule::Affordance, "affords `surface` and has no surface that holds things on it".into());
    }
    if affords(Property::Container) && !holds(Hold::Inside) {
        say(Rule::Affordance, "affords `container` and has no surface that holds things inside".into());
    }
    let moves = case.solids.iter().any(|s| s.joint.is_some());
    if affords(Property::Container) && affords(Property::Openable) && !moves {
        say(Rule::Affordance, "affords `container openable` and no part moves".into());
    }
}

/// The rectangle is over the object.
fn within(case: &Case, surface: &Surface, say: Say<'_>) {
    let extents = case.solids.iter().map(|s| (s.low, s.high));
    let Some((low, high)) = extents.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))) else { return };
    let centre: P = surface.centre.cast();
    let half = V::new(surface.half.0.into(), surface.half.1.into(), 0.0);
    let (from, to) = (centre - half, centre + half);
    if (0..3).any(|k| from[k] < low[k] - 1e-3 || to[k] > high[k] + 1e-3) {
        say(Rule::Surface, format!("surface `{}` goes beyond the object: {from:.3} to {to:.3}", surface.name));
    }
    let small = surface.hold != Hold::Hook && half.x.min(half.y) < 0.004;
    if small {
        say(Rule::Surface, format!("surface `{}` is {:.4} by {:.4} m", surface.name, 2.0 * half.x, 2.0 * half.y));
    }
}

/// Points of the rectangle, which is shrunk a little.
fn grid(surface: &Surface) -> Vec<P> {
    let centre: P = surface.centre.cast();
    let along = |half: f32, i: usize| {
        let half = (f64::from(half) - SHRUNK).max(0.0);
        half * (2.0 * i as f64 / (POINTS - 1) as f64 - 1.0)
    };
    let cells = (0..POINTS).flat_map(|i| (0..POINTS).map(move |j| (i, j)));
    cells.map(|(i, j)| centre + V::new(along(surface.half.0, i), along(surface.half.1, j), 0.0)).collect()
}

/// The first and last points of all rows and columns of a grid.
fn rows(points: &[P]) -> Vec<(P, P)> {
    let last = POINTS - 1;
    let ends = (0..POINTS).flat_map(|i| [(i, last * POINTS + i), (i * POINTS, i * POINTS + last)]);
    ends.map(|(a, b)| (points[a], points[b])).collect()
}

/// The object is right below the surface.
fn carried(surface: &Surface, link: &[&Solid], say: Say<'_>) {
    let stands = |p: &P| {
        let (from, to) = (p + V::z() * 0.001, p - V::z() * 0.012);
        link.iter().any(|s| s.blocks(&from, &to))
    };
    let points = grid(surface);
    let share = points.iter().filter(|p| stands(p)).count();
    // Wires support at some points only; lines just below the surface cross them.
    let down = |p: &P| p - V::z() * 0.002;
    let wires = rows(&points).iter().filter(|(a, b)| link.iter().any(|s| s.blocks(&down(a), &down(b)))).count();
    if share * 8 < POINTS * POINTS && wires < POINTS - 1 {
        say(
            Rule::Surface,
            format!("surface `{}` at {:.3} is not carried by parts of its link", surface.name, surface.centre),
        );
    }
}

/// No part of the surface's own link is in the space above it.
fn above(case: &Case, surface: &Surface, link: &[&Solid], say: Say<'_>) {
    let top = case.solids.iter().map(|s| s.high.z).fold(0.0, f64::max);
    let tall = surface.clearance.map_or(top - f64::from(surface.centre.z), f64::from) - SHRUNK;
    let points = grid(surface);
    let at = |p: &P, z: f64| p + V::z() * z;
    let upright = |s: &&&Solid| points.iter().any(|p| s.blocks(&at(p, SHRUNK), &at(p, tall)));
    let levels = [0.25, 0.5, 0.75].map(|share| SHRUNK + (tall - SHRUNK) * share);
    let ways = rows(&points);
    let level = |s: &&&Solid| levels.iter().any(|&z| ways.iter().any(|(a, b)| s.blocks(&at(a, z), &at(b, z))));
    if tall <= SHRUNK {
        return;
    }
    let in_the_way: Vec<&str> = link.iter().filter(|s| upright(s) || level(s)).map(|s| &*s.name).collect();
    if !in_the_way.is_empty() {
        let shown = in_the_way[..in_the_way.len().min(3)].join(", ");
        say(Rule::Surface, format!("{shown} in the {tall:.3} m above surface `{}`", surface.name));
    }
}

/// No part of the hook's own link is right below it.
fn below(surface: &Surface, link: &[&Solid], say: Say<'_>) {
    let centre: P = surface.centre.cast();
    let drop = surface.clearance.map_or(0.0, f64::from) - SHRUNK;
    let (from, to) = (centre - V::z() * 0.02, centre - V::z() * drop);
    if let Some(solid) = link.iter().find(|s| drop > 0.02 && s.blocks(&from, &to)) {
        say(Rule::Surface, format!("{} in the {drop:.3} m below hook `{}`", solid.name, surface.name));
    }
}
