//! Floor plans, and digests that must be the same on every machine.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::Seed;
use vc_procgen::plan::{FloorPlan, OpeningKind, Rect, Room, RoomKind, Scheme};
use vc_procgen::{Apartment, Specification};

/// The digests of the scenes of seeds 0, 1, 2 and so on. They are the same on every machine; a
/// change of the generated content must update them.
const DIGESTS: [&str; 4] = ["9768b7f454d8c436", "894482d315a528c7", "c135de3f64496f5d", "900c80250760436e"];

#[test]
fn every_machine_makes_the_same_bytes() {
    let digest = |seed| Apartment::from_seed(Seed(seed)).unwrap().scene().digest().to_string();
    let made: Vec<String> = (0..DIGESTS.len() as u64).map(digest).collect();
    assert_eq!(made, DIGESTS);
}

#[test]
fn what_no_template_holds_is_annealed() {
    let plans = (0..1500).filter_map(|seed| FloorPlan::generate(&Specification::default(), Seed(seed)).ok());
    let annealed: Vec<FloorPlan> = plans.filter(|p| p.scheme == Scheme::Annealed).collect();
    assert!(!annealed.is_empty(), "none of 1500 plans was annealed");
    for plan in &annealed {
        for (index, room) in plan.rooms.iter().enumerate() {
            let has = |f: fn(OpeningKind) -> bool| plan.openings.iter().any(|o| f(o.kind) && o.touches(index));
            assert!(has(|k| k != OpeningKind::Window), "{:?} has no door", room.kind);
            let lit = matches!(room.kind, RoomKind::Living | RoomKind::Bedroom | RoomKind::Kids);
            assert!(!lit || has(|k| matches!(k, OpeningKind::Window | OpeningKind::BalconyDoor)), "{:?}", room.kind);
        }
    }
}

#[test]
fn a_room_no_wider_than_its_walls_has_no_area() {
    for rect in [Rect::sized(0, 0, 1, 40), Rect::sized(0, 0, 40, 2), Rect::sized(3, 3, 1, 1)] {
        let room = Room { kind: RoomKind::Storage, rects: vec![rect], of: None };
        assert_eq!((room.net(), room.area()), (Vec::new(), 0.0));
    }
}
