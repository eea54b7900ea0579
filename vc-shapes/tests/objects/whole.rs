//! The object as a whole: closed parts, size, base, connectedness, triangle count.

use vc_graph::Property;
use vc_graph::class::Category;

use crate::cases::{Case, Rule};
use crate::solid::{P, Solid};

type Say<'a> = &'a mut dyn FnMut(Rule, String);

/// The widest gap between connected parts, metres; 1.5 % of the object's largest dimension where
/// that is less, but at least a millimetre.
const TOUCHING: f64 = 0.005;

/// Sets, whose pieces may each lie on the ground.
const SETS: &[&str] = &[
    "building_blocks",
    "toy_bricks",
    "toy_tool_set",
    "toy_tea_set",
    "play_dough",
    "croquet_set",
    "earrings",
    "chopsticks",
    "sand_bucket",
    "marbles",
    "darts",
    "billiard_balls",
    "dominoes",
    "mahjong",
    "chessboard",
    "checkers",
    "scrabble",
    "dice",
    "memory_game",
    "jigsaw_puzzle",
    "poker_chips",
    "deck_of_cards",
    "board_game",
    "monopoly",
    "ludo",
    "train_track",
    "shoes",
    "sneakers",
    "boots",
    "sandals",
    "high_heels",
    "slippers",
    "gloves",
    "socks",
    "gardening_gloves",
    "rubber_gloves",
    "boxing_gloves",
    "oven_mitts",
    "roller_skates",
    "ice_skates",
    "knee_pads",
    "ankle_weights",
    "push_up_bars",
    "maracas",
    "drum_kit",
    "swim_fins",
    "skis",
    "firewood",
    "notes",
    "bills",
    "mail",
    "button",
    "coin",
    "keys",
    "push_pin",
    "paper_clip",
    "nail",
    "screw",
    "band_aids",
    "cotton_pads",
    "clothespin",
    "stepping_stone",
    "stereo",
    "virtual_headset",
];

/// Objects that are generated in their hanging pose.
const HUNG: &[&str] = &["hanger", "wind_chime", "wall_clock", "wall_phone", "wreath"];

pub(crate) fn check(case: &Case, say: Say<'_>) {
    closed(case, say);
    let start = (case.solids[0].low, case.solids[0].high);
    let (low, high) = case.solids.iter().fold(start, |(l, h), s| (l.inf(&s.low), h.sup(&s.high)));
    // An object fixed in a wall has its origin there, and its trim extends beyond the wall.
    if !matches!(case.class.category, Category::Structure | Category::Door | Category::Window) {
        size(case, low, high, say);
        base(low, high, say);
    }
    floating(case, say);
    stable(case, low, say);
    triangles(case, low, high, say);
}

fn closed(case: &Case, say: Say<'_>) {
    for solid in &case.solids {
        if solid.triangles.is_empty() {
            say(Rule::Closed, format!("{} has no triangles", solid.name));
        } else if !solid.closed {
            say(Rule::Closed, format!("{} is not closed", solid.name));
        } else if solid.volume <= 0.0 {
            say(Rule::Closed, format!("{} is inside out: volume {}", solid.name, solid.volume));
        }
    }
}

fn size(case: &Case, low: P, high: P, say: Say<'_>) {
    for (k, axis) in ["deep", "wide", "high"].into_iter().enumerate() {
        let (is, may) = (high[k] - low[k], f64::from(case.asked[k]));
        if is > may + 0.001 {
            let outermost = |s: &&Solid| (s.high[k] - high[k]).abs() < 1e-6 || (s.low[k] - low[k]).abs() < 1e-6;
            let names: Vec<&str> = case.solids.iter().filter(outermost).map(|s| &*s.name).take(4).collect();
            say(Rule::Size, format!("{is:.3} m {axis} instead of {may:.3}: {}", names.join(", ")));
        }
    }
}

fn base(low: P, high: P, say: Say<'_>) {
    if low.z < -0.001 || low.z > 0.005 {
        say(Rule::Base, format!("its base is at {:.4} m", low.z));
    }
    let middle = nalgebra::center(&low, &high);
    let slack = 0.005 + 0.01 * (high - low).norm();
    if middle.x.abs() > slack || middle.y.abs() > slack {
        say(Rule::Base, format!("its middle is at ({:.3}, {:.3})", middle.x, middle.y));
    }
}

/// Reports parts that are not connected to the first (for a set, to the ground) through parts that
/// touch.
fn floating(case: &Case, say: Say<'_>) {
    let set = SETS.contains(&&*case.class.name);
    let gap = (f64::from(case.object.size().max()) * 0.015).clamp(0.001, TOUCHING);
    let starts = |i: usize| i == 0 || set && case.solids[i].low.z < gap;
    let mut held: Vec<bool> = (0..case.solids.len()).map(starts).collect();
    let mut edge: Vec<usize> = (0..held.len()).filter(|&i| held[i]).collect();
    while let Some(i) = edge.pop() {
        for (j, solid) in case.solids.iter().enumerate() {
            if !held[j] && case.solids[i].touches(solid, gap) {
                held[j] = true;
                edge.push(j);
            }
        }
    }
    // The smaller side is reported as floating.
    let most = held.iter().filter(|h| **h).count() * 2 >= held.len();
    let loose: Vec<&str> = held.iter().zip(&case.solids).filter(|(h, _)| **h != most).map(|(_, s)| &*s.name).collect();
    if !loose.is_empty() {
        let more = if loose.len() > 4 { format!(" and {} more", loose.len() - 4) } else { String::new() };
        say(Rule::Floating, format!("{}{more} touch nothing of the rest", loose[..loose.len().min(4)].join(", ")));
    }
}

/// A graspable object lies or stands as placed: its centre of mass is above the points that touch
/// the ground.
fn stable(case: &Case, low: P, say: Say<'_>) {
    if !case.class.affordances.contains(Property::Graspable) || HUNG.contains(&&*case.class.name) {
        return;
    }
    let size = f64::from(case.object.size().max());
    let ground = low.z + (0.02 * size).clamp(5e-4, 4e-3);
    let corners = || case.solids.iter().flat_map(|s| s.triangles.iter().flatten());
    let feet: Vec<&P> = corners().filter(|p| p.z <= ground).collect();
    let middle = middle(case);
    let beyond = (0..32).map(|i| {
        let (s, c) = (std::f64::consts::TAU * f64::from(i) / 32.0).sin_cos();
        let along = |p: &P| p.x * c + p.y * s;
        along(&middle) - feet.iter().map(|p| along(p)).fold(f64::NEG_INFINITY, f64::max)
    });
    let beyond = beyond.fold(f64::NEG_INFINITY, f64::max);
    if beyond > 0.01 * size {
        say(Rule::Stable, format!("its middle is {:.1} mm beyond what it stands on", beyond * 1e3));
    }
}

/// The centroid of all parts' volumes.
fn middle(case: &Case) -> P {
    let (mut sum, mut all) = (P::origin().coords, 0.0);
    for [a, b, c] in case.solids.iter().flat_map(|s| &s.triangles) {
        let volume = a.coords.dot(&b.coords.cross(&c.coords));
        sum += (a.coords + b.coords + c.coords) / 4.0 * volume;
        all += volume;
    }
    P::from(sum / all)
}

/// The limit is two thousand triangles, plus six thousand for every metre.
fn triangles(case: &Case, low: P, high: P, say: Say<'_>) {
    let count: usize = case.solids.iter().map(|s| s.triangles.len()).sum();
    let most = (2000.0 + 6000.0 * (high - low).max()).min(30_000.0) as usize;
    if count > most {
        let large = case.solids.iter().max_by_key(|s| s.triangles.len()).map_or("", |s| &s.name);
        let parts = case.solids.len();
        say(Rule::Triangles, format!("{count} triangles of {parts} parts instead of {most}, {large} most"));
    }
}
