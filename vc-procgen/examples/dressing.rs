//! The things that dressing adds to rooms: visible ones by kind of room, beside estimates of real homes; rooms with what they always
//! have; classes in use.
//!
//! `cargo run --release -p vc-procgen --example dressing -- 200 42` counts 200 homes from seed 42 on, without and with the
//! built-in table; a third argument is a table of your own.

#![allow(clippy::print_stdout, reason = "an example prints its result")]

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

use vc_graph::Seed;
use vc_procgen::plan::RoomKind;
use vc_procgen::{Apartment, Dressing, Item, Specification, Support};

/// Estimates of visible things in real homes, and of things on their walls.
const REAL: [(RoomKind, [usize; 2], [usize; 2]); 6] = [
    (RoomKind::Living, [60, 150], [5, 10]),
    (RoomKind::Kitchen, [50, 100], [3, 8]),
    (RoomKind::Bedroom, [40, 80], [3, 6]),
    (RoomKind::Kids, [80, 150], [3, 8]),
    (RoomKind::Bathroom, [30, 50], [3, 6]),
    (RoomKind::Hall, [20, 40], [3, 6]),
];

/// Things on walls that no estimate counts.
const FIXED: [&str; 7] =
    ["powersocket", "lightswitch", "curtain", "curtain_rod", "blinds", "kitchen_wall_cabinet", "extractor"];

/// Things that rooms of a kind usually have: a room has one if it has any of the classes.
const USUAL: [(RoomKind, &[&[&str]]); 6] = [
    (
        RoomKind::Bathroom,
        &[
            &["towel", "bath_towel"],
            &["toilet_paper"],
            &["toilet_brush"],
            &["soap", "bar_soap", "hand_soap"],
            &["shampoo", "shower_gel"],
            &["toothbrush", "electric_toothbrush"],
            &["bath_mat"],
        ],
    ),
    (
        RoomKind::Kitchen,
        &[
            &["dish_soap"],
            &["sponge"],
            &["dish_towel"],
            &["kettle"],
            &["toaster"],
            &["cutting_board"],
            &["bread", "bread_roll", "baguette"],
            &["dish_rack"],
        ],
    ),
    (
        RoomKind::Living,
        &[&["rug"], &["photo_frame", "frame"], &["blanket"], &["remote_control"], &["magazine", "novel"]],
    ),
    (
        RoomKind::Hall,
        &[&["doormat", "rug", "mat"], &["keys"], &["coat", "jacket"], &["umbrella"], &["envelope", "mail"]],
    ),
    (RoomKind::Bedroom, &[&["rug"], &["slippers"], &["alarm_clock", "clock"], &["mirror", "standing_mirror"]]),
    (RoomKind::Kids, &[&["teddy_bear", "plush_toy"], &["rug"], &["drawing"], &["cookbook"], &["suit"], &["homework"]]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let count = words.first().map_or(Ok(50), |word| word.parse())?;
    let first: u64 = words.get(1).map_or(Ok(42), |word| word.parse())?;
    let dressing = match words.get(2) {
        Some(path) => Dressing::parse(path, &std::fs::read_to_string(path)?)?,
        None => Dressing::builtin(),
    };
    let dressed = Specification { dressing: Some(dressing), ..Specification::default() };
    let plain = Tally::count(&Specification::default(), first..first + count)?;
    let dressed = Tally::count(&dressed, first..first + count)?;
    println!("{:<14}{:>22}{:>22}{:>12}", "visible things", "plain: 10/50/90 %", "dressed: 10/50/90 %", "real");
    for (kind, real, walls) in REAL {
        let [low, high] = real;
        println!(
            "{:<14}{:>22}{:>22}{:>12}",
            kind.title(),
            plain.shares(kind, false),
            dressed.shares(kind, false),
            format!("{low}-{high}")
        );
        let [low, high] = walls;
        let (before, after) = (plain.shares(kind, true), dressed.shares(kind, true));
        println!("{:<14}{before:>22}{after:>22}{:>12}", "  on walls", format!("{low}-{high}"));
    }
    println!("\nrooms that have at least one, % plain and dressed");
    for (kind, things) in USUAL {
        let cell = |classes: &&[&str]| {
            format!("{} {:.0} {:.0}", classes[0], plain.having(kind, classes), dressed.having(kind, classes))
        };
        println!("{:<14}{}", kind.title(), things.iter().map(cell).collect::<Vec<_>>().join(", "));
    }
    println!(
        "\n{} and {} classes in use, {} and {} things a home",
        plain.classes.len(),
        dressed.classes.len(),
        plain.mean(),
        dressed.mean()
    );
    Ok(())
}

/// The things of many homes.
#[derive(Default)]
struct Tally {
    homes: usize,
    things: usize,
    classes: BTreeSet<&'static str>,
    rooms: BTreeMap<RoomKind, Vec<Room>>,
}

/// The things of a room.
#[derive(Default)]
struct Room {
    visible: usize,
    on_walls: usize,
    classes: BTreeSet<&'static str>,
}

impl Tally {
    fn count(wishes: &Specification, seeds: std::ops::Range<u64>) -> Result<Self, Box<dyn Error>> {
        let mut tally = Self::default();
        for seed in seeds {
            let home = Apartment::generate(wishes, Seed(seed))?;
            tally.homes += 1;
            tally.things += home.items.len();
            tally.classes.extend(home.items.iter().map(|item| item.object.class));
            let mut rooms: Vec<Room> = home.plan.rooms.iter().map(|_| Room::default()).collect();
            for item in home.items.iter().filter(|item| item.support != Support::Built) {
                let room = &mut rooms[item.room];
                room.classes.insert(item.object.class);
                room.visible += usize::from(is_visible(&home, item));
                room.on_walls += usize::from(item.support == Support::Wall && !FIXED.contains(&item.object.class));
            }
            for (room, plan) in rooms.into_iter().zip(&home.plan.rooms) {
                tally.rooms.entry(plan.kind).or_default().push(room);
            }
        }
        Ok(tally)
    }

    fn shares(&self, kind: RoomKind, walls: bool) -> String {
        let number = |room: &Room| if walls { room.on_walls } else { room.visible };
        let mut all: Vec<usize> = self.rooms.get(&kind).into_iter().flatten().map(number).collect();
        all.sort_unstable();
        let at = |share: usize| all.get(all.len() * share / 100).copied().unwrap_or(0);
        format!("{} / {} / {}", at(10), at(50), at(90))
    }

    fn having(&self, kind: RoomKind, classes: &[&str]) -> f64 {
        let rooms = self.rooms.get(&kind).map_or(&[][..], Vec::as_slice);
        let having = rooms.iter().filter(|room| classes.iter().any(|class| room.classes.contains(class)));
        100.0 * having.count() as f64 / rooms.len().max(1) as f64
    }

    fn mean(&self) -> usize {
        self.things / self.homes.max(1)
    }
}

/// Whether nothing that holds it, holds it inside.
fn is_visible(home: &Apartment, item: &Item) -> bool {
    match item.support {
        Support::Inside(..) => false,
        Support::On(at, _) => is_visible(home, &home.items[at]),
        _ => true,
    }
}
