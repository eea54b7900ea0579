//! Objects that belong to a piece of furniture: bedding, taps, screens, rows of books.

use nalgebra::{Isometry3, Matrix3, Rotation3, UnitQuaternion, Vector3};
use vc_graph::asset::Hold;
use vc_graph::{State, Stream};

use super::surface_filler::SurfaceFiller;
use crate::draft::Draft;

/// Adds the objects that a piece needs, and those it usually has.
pub(super) fn dress(k: &mut SurfaceFiller<'_>, amount: f32) {
    equip(k);
    match k.class() {
        "kitchen_cabinet" => worktop(k, amount),
        "wall_hook_rack" | "coat_rack" | "hall_stand" => {
            coats(k, &["jacket", "coat", "hat", "bag", "umbrella", "scarf", "backpack"], 0.6 * amount.max(0.3))
        }
        "towel_rack" | "heated_towel_rail" => coats(k, &["towel", "bath_towel"], 0.8),
        "wardrobe" => coats(k, &["coat", "jacket", "shirt", "dress", "suit"], amount),
        "bookshelf" | "low_bookcase" => books(k, amount),
        "wall_shelf" => books(k, amount * 0.6),
        "stove" => cookware(k, amount),
        _ => {}
    }
}

/// Adds the objects without which a piece is not one: bedding, a tap, a television.
pub(super) fn equip(k: &mut SurfaceFiller<'_>) {
    match k.class() {
        "double_bed" => bedding(k, 2),
        "single_bed" | "kids_bed" => bedding(k, 1),
        "sofa" | "loveseat" => cushions(k),
        "tv_stand" => television(k),
        "desk" => workplace(k),
        "nightstand" => lamp(k, "table_lamp", 0.8),
        "side_table" => lamp(k, "table_lamp", 0.4),
        "kitchen_sink" | "washbasin" => tap(k),
        _ => {}
    }
}

/// How many more objects of a class are kept beside the first.
pub(super) fn together(class: &str, rng: &mut Stream) -> usize {
    match class {
        "plate" | "dessert_plate" | "soup_plate" | "bowl" | "mug" | "cup" | "water_glass" | "wine_glass"
        | "beer_glass" | "beer" => rng.count(1, 4),
        "fork" | "knife" | "spoon" | "teaspoon" => rng.count(2, 5),
        "apple" | "orange" | "banana" | "lemon" | "tomato" | "potato" | "onion" | "egg" | "yogurt" | "toilet_paper" => {
            rng.count(1, 3)
        }
        "shoes" | "canned_food" | "box" | "jar" | "soda" | "bottled_water" => rng.count(0, 2),
        _ => 0,
    }
}

/// Places a duvet, spread over the bed or turned back, and pillows at the head.
fn bedding(k: &mut SurfaceFiller<'_>, pillows: usize) {
    let Some(surface) = k.first(Hold::On) else { return };
    let Some((centre, half)) = k.surface(surface).map(|s| (s.centre, s.half)) else { return };
    let (length, width) = (2.0 * half.0, 2.0 * half.1);
    let head = centre.x - half.0;
    let pillow_depth = 0.42;
    let made = k.rng.chance(0.7);
    let each = width / pillows as f32;
    for i in 0..pillows {
        let Some(pillow) = k.make("pillow", Some([pillow_depth, (each - 0.06).min(0.7), 0.14])) else { break };
        let y = centre.y - half.1 + each * (i as f32 + 0.5);
        k.place(&pillow, surface, (head + pillow.size().x / 2.0 + 0.03, y), 0.0);
    }
    // A made bed is covered up to the pillows; otherwise the duvet lies at the foot.
    let cover =
        if made { length - pillow_depth - 0.1 } else { (length - pillow_depth - 0.1) * k.rng.between(0.4, 0.6) };
    let thick = if made { 0.07 } else { 0.14 };
    if let Some(duvet) = k.make("duvet", Some([cover, width - 0.02, thick])) {
        let x = centre.x + half.0 - duvet.size().x / 2.0 - 0.01;
        if let Some(index) = k.place(&duvet, surface, (x, centre.y), 0.0) {
            k.enter(index, if made { State::Unfolded } else { State::Folded });
        }
    }
}

fn cushions(k: &mut SurfaceFiller<'_>) {
    let Some(surface) = k.first(Hold::On) else { return };
    let Some((centre, half)) = k.surface(surface).map(|s| (s.centre, s.half)) else { return };
    for side in [-1.0_f32, 1.0] {
        if !k.rng.chance(0.7) {
            continue;
        }
        let Some(cushion) = k.make("cushion", Some([0.42, 0.42, 0.14])) else { return };
        let size = cushion.size();
        let y = centre.y + side * (half.1 - size.y / 2.0 - 0.02);
        k.place(&cushion, surface, (centre.x - half.0 + size.x / 2.0 + 0.02, y), 0.0);
    }
}

/// Places a television as wide as its stand allows.
fn television(k: &mut SurfaceFiller<'_>) {
    let Some(surface) = k.first(Hold::On) else { return };
    let Some((centre, half)) = k.surface(surface).map(|s| (s.centre, s.half)) else { return };
    let width = (2.0 * half.1 - 0.02).min(1.45);
    let depth = (2.0 * half.0 - 0.01).min(0.28);
    if let Some(screen) = k.make("television", Some([depth, width, width * 0.62])) {
        k.place(&screen, surface, (centre.x - half.0 + screen.size().x / 2.0 + 0.005, centre.y), 0.0);
    }
}

/// Places a laptop, or a monitor with keyboard and mouse, and a lamp.
fn workplace(k: &mut SurfaceFiller<'_>) {
    let Some(surface) = k.first(Hold::On) else { return };
    let Some((centre, half)) = k.surface(surface).map(|s| (s.centre, s.half)) else { return };
    // A person at the desk faces its back, so screens face its front.
    if k.rng.chance(0.5) {
        if let Some(laptop) = k.make("laptop", None) {
            let index = k.place(&laptop, surface, (centre.x + half.0 - laptop.size().x / 2.0 - 0.06, centre.y), 0.0);
            if let Some(index) = index.filter(|_| k.rng.chance(0.5)) {
                k.enter(index, State::Open);
            }
        }
    } else {
        if let Some(monitor) = k.make("monitor", Some([0.2, 0.56, 0.45])) {
            k.place(&monitor, surface, (centre.x - half.0 + monitor.size().x / 2.0 + 0.03, centre.y), 0.0);
        }
        let front = centre.x + half.0 - 0.14;
        if let Some(keyboard) = k.make("keyboard", None) {
            k.place(&keyboard, surface, (front, centre.y), 0.0);
        }
        if let Some(mouse) = k.make("mouse", None) {
            k.place(&mouse, surface, (front, centre.y + 0.32), 0.0);
        }
    }
    lamp(k, "desk_lamp", 0.7);
}

fn lamp(k: &mut SurfaceFiller<'_>, class: &str, chance: f32) {
    let Some(surface) = k.first(Hold::On) else { return };
    if !k.rng.chance(chance) {
        return;
    }
    let Some((centre, half)) = k.surface(surface).map(|s| (s.centre, s.half)) else { return };
    let side = (2.0 * half.0.min(half.1)).min(0.3);
    let Some(lamp) = k.make(class, Some([side, side, 0.45])) else { return };
    let size = lamp.size();
    let y = centre.y + (half.1 - size.y / 2.0 - 0.01) * if k.rng.chance(0.5) { 1.0 } else { -1.0 };
    k.place(&lamp, surface, (centre.x - half.0 + size.x / 2.0 + 0.01, y), 0.0);
}

/// Places a tap on the ledge behind a bowl.
fn tap(k: &mut SurfaceFiller<'_>) {
    let Some(&ledge) = k.named("ledge").first() else { return };
    let Some(centre) = k.surface(ledge).map(|s| s.centre) else { return };
    let Some(tap) = k.make("faucet", Some([0.2, 0.06, 0.3])) else { return };
    k.place_over(&tap, ledge, (centre.x, centre.y));
}

/// Places the usual appliances on a worktop.
fn worktop(k: &mut SurfaceFiller<'_>, amount: f32) {
    let Some(surface) = k.first(Hold::On) else { return };
    for (class, chance) in [
        ("kettle", 0.35),
        ("toaster", 0.3),
        ("microwave", 0.3),
        ("coffee_maker", 0.3),
        ("knife_block", 0.2),
        ("cutting_board", 0.3),
    ] {
        if k.rng.chance(chance * amount.max(0.4)) {
            k.put(class, surface);
        }
    }
}

fn cookware(k: &mut SurfaceFiller<'_>, amount: f32) {
    let burners = k.named("burner");
    for surface in burners {
        if k.rng.chance(0.25 * amount) {
            let class = if k.rng.chance(0.5) { "pot" } else { "frying_pan" };
            k.put(class, surface);
        }
    }
}

/// Hangs objects on hooks and rods.
fn coats(k: &mut SurfaceFiller<'_>, classes: &[&str], chance: f32) {
    for surface in 0..k.surfaces() {
        // Nothing hangs from bars by habit.
        let hook = k.surface(surface).is_some_and(|s| s.hold == Hold::Hook && !s.name.starts_with("bar"));
        if !hook || !k.rng.chance(chance) {
            continue;
        }
        let class = classes[k.rng.below(classes.len())];
        hang(k, class, surface);
    }
}

/// Hangs an object of a class from a hook or a rod.
fn hang(k: &mut SurfaceFiller<'_>, class: &str, surface: usize) -> Option<usize> {
    let drop = k.surface(surface).and_then(|s| s.clearance).unwrap_or(1.0);
    let size = hung_size(class);
    if size[2] >= drop {
        return None;
    }
    let object = k.make(class, Some(size))?;
    k.hang(&object, surface)
}

/// The size of a hung object: depth, width, height, metres.
pub(super) fn hung_size(class: &str) -> [f32; 3] {
    match class {
        "coat" | "dress" | "bathrobe" | "raincoat" | "pants" | "jeans" => [0.1, 0.4, 1.05],
        "jacket" | "suit" | "shirt" | "sweater" | "hoodie" | "t_shirt" | "skirt" => [0.1, 0.4, 0.75],
        "towel" | "bath_towel" => [0.05, 0.4, 0.6],
        "scarf" => [0.05, 0.15, 0.8],
        "umbrella" => [0.08, 0.1, 0.8],
        "hat" => [0.12, 0.26, 0.28],
        _ => [0.14, 0.3, 0.42],
    }
}

/// The classes of the books on shelves.
const BOOKS: [&str; 4] = ["novel", "novel", "textbook", "cookbook"];

/// Places rows of standing books, from a shelf's left side.
fn books(k: &mut SurfaceFiller<'_>, amount: f32) {
    for surface in 0..k.surfaces() {
        if is_bookshelf(k, surface) && k.rng.chance(amount.min(0.9)) {
            let filled = k.rng.between(0.3, 0.8);
            row(k, surface, &BOOKS, filled);
        }
    }
}

/// Whether books stand upright on a surface.
fn is_bookshelf(k: &SurfaceFiller<'_>, surface: usize) -> bool {
    k.surface(surface).is_some_and(|s| s.half.0 >= 0.07 && s.clearance.unwrap_or(0.3) >= 0.16)
}

/// Places a row of standing books of some classes over a share of a shelf's width; returns the last of them.
pub(super) fn row<C: AsRef<str>>(
    k: &mut SurfaceFiller<'_>,
    surface: usize,
    classes: &[C],
    filled: f32,
) -> Option<usize> {
    if !is_bookshelf(k, surface) {
        return None;
    }
    let (centre, half, clearance) = k.surface(surface).map(|s| (s.centre, s.half, s.clearance.unwrap_or(0.3)))?;
    let fill = filled * 2.0 * half.1;
    let mut y = 0.01;
    let mut book: Option<Draft> = None;
    let mut last = None;
    while y < fill {
        if book.is_none() || k.rng.chance(0.7) {
            let class = classes.get(k.rng.below(classes.len()))?.as_ref();
            book = k.make(class, None).map(|b| k.upright(b, on_edge()));
        }
        let Some(standing) = &book else { break };
        let size = standing.size();
        if size.z > clearance - 0.01 || size.x > 2.0 * half.0 - 0.01 {
            book = None;
            y += 0.02;
            continue;
        }
        let at = (centre.x + half.0 - size.x / 2.0 - 0.006, centre.y + half.1 - y - size.y / 2.0);
        let Some(item) = k.place(standing, surface, at, 0.0) else { break };
        last = Some(item);
        y += size.y + 0.005;
    }
    last
}

/// The rotation of a book from lying flat, with the spine at -Y and the head at -X, to standing
/// with the spine in front and the head up: the front cover faces to the viewer's right.
fn on_edge() -> vc_graph::Pose {
    let axes = Matrix3::from_columns(&[-Vector3::z(), -Vector3::x(), Vector3::y()]);
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    Isometry3::from_parts(Vector3::zeros().into(), turn)
}
