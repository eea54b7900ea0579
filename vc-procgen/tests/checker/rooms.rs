//! Rooms have their required contents, and paths to them do not lead through private rooms.

use vc_procgen::plan::{OpeningKind, RoomKind};

use super::{House, Rule};

type Need = (&'static str, &'static [&'static str]);

const BED: Need = ("bed", &["double_bed", "single_bed", "kids_bed", "bed", "bunk_bed"]);
const TOILET: Need = ("toilet", &["toilet"]);
const BASIN: Need = ("basin", &["washbasin"]);
const BATHING: Need = ("shower or bath", &["shower", "bathtub"]);
const COOKING: [Need; 4] = [
    ("sink", &["kitchen_sink"]),
    ("hob", &["stove", "hob", "cooktop"]),
    ("fridge", &["fridge"]),
    ("worktop", &["kitchen_cabinet", "kitchen_counter"]),
];
const SEAT: Need =
    ("seat", &["sofa", "sofa_bed", "loveseat", "armchair", "recliner", "rocking_chair", "chair", "dining_chair"]);
const TABLE: Need = ("table", &["table", "dining_table", "coffee_table", "low_table", "side_table", "kitchen_table"]);
const DESK: Need = ("desk", &["desk", "computer_desk"]);

pub(super) fn look(house: &mut House<'_>) {
    complete(house);
    passages(house);
}

fn complete(house: &mut House<'_>) {
    let studio = !house.plan.rooms.iter().any(|r| r.kind.is_bedroom());
    let mut found = Vec::new();
    for (index, id) in house.scene.rooms().iter().enumerate() {
        let here: Vec<&str> = house.things.iter().filter(|t| t.room == Some(*id)).map(|t| &*t.class).collect();
        let lacks =
            needs(house.plan.rooms[index].kind, studio).into_iter().filter(|n| !n.1.iter().any(|c| here.contains(c)));
        let room = house.scene.label(*id);
        found
            .extend(lacks.map(|(what, _)| (format!("{} without {what}", room.class), format!("{room} has no {what}"))));
    }
    found.into_iter().for_each(|(group, text)| house.note(Rule::Incomplete, group, text));
}

fn needs(kind: RoomKind, studio: bool) -> Vec<Need> {
    match kind {
        RoomKind::Bedroom | RoomKind::Kids => vec![BED],
        RoomKind::Bathroom => vec![TOILET, BASIN, BATHING],
        RoomKind::Wc => vec![TOILET, BASIN],
        RoomKind::Kitchen => COOKING.to_vec(),
        RoomKind::Living if studio => [SEAT, TABLE, BED].into_iter().chain(COOKING).collect(),
        RoomKind::Living => vec![SEAT, TABLE],
        RoomKind::Study => vec![DESK],
        _ => Vec::new(),
    }
}

/// Rooms reached only through bedrooms or bathrooms, and rooms behind bathrooms. A bedroom's own
/// bathroom, dressing room and balcony may be reached from it.
fn passages(house: &mut House<'_>) {
    let rooms = &house.plan.rooms;
    let wet = |r: usize| matches!(rooms[r].kind, RoomKind::Bathroom | RoomKind::Wc);
    let all = reached(house, |r| !wet(r));
    let public = reached(house, |r| !wet(r) && !rooms[r].kind.is_bedroom());
    let own = |r: usize| rooms[r].of.is_some() || rooms[r].kind == RoomKind::Balcony;
    let wrong = |r: &usize| !all[*r] || !public[*r] && !own(*r);
    let found: Vec<(String, String)> = (0..rooms.len())
        .filter(wrong)
        .map(|r| (rooms[r].kind.title().to_owned(), format!("room {r} is reached only through a private room")))
        .collect();
    found.into_iter().for_each(|(group, text)| house.note(Rule::Passage, group, text));
}

/// The rooms that can be reached where only some may be passed through.
fn reached(house: &House<'_>, leads: impl Fn(usize) -> bool) -> Vec<bool> {
    let ways = || house.plan.openings.iter().filter(|o| o.kind != OpeningKind::Window);
    let mut seen = vec![false; house.plan.rooms.len()];
    let mut open: Vec<usize> =
        ways().filter(|o| o.kind == OpeningKind::Entrance).filter_map(|o| o.low.or(o.high)).collect();
    while let Some(room) = open.pop() {
        if std::mem::replace(&mut seen[room], true) || !leads(room) {
            continue;
        }
        open.extend(ways().filter(|o| o.low == Some(room)).filter_map(|o| o.high));
        open.extend(ways().filter(|o| o.high == Some(room)).filter_map(|o| o.low));
    }
    seen
}
