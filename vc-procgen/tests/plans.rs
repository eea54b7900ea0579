//! Floor plans, and digests that must be the same on every machine.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::sync::Arc;

use vc_graph::{ClassTable, ObjectRole, Seed};
use vc_procgen::plan::{FloorPlan, OpeningKind, Rect, Room, RoomKind, Scheme};
use vc_procgen::{Apartment, Layout, Specification};
use vc_shapes::material::OAK;
use vc_shapes::{Build, Generator, Generators, Realm};

/// The digests of the scenes of seeds 0, 1, 2 and so on. They are the same on every machine; a
/// change of the generated content must update them.
const DIGESTS: [&str; 4] = ["371caef36b3aeff1", "09e7305e0dc22465", "4e7bf32d76577fb2", "af83e1d08054e63a"];

#[test]
fn every_machine_makes_the_same_bytes() {
    let digest = |seed| Apartment::from_seed(Seed(seed)).unwrap().scene().digest().to_string();
    let made: Vec<String> = (0..DIGESTS.len() as u64).map(digest).collect();
    assert_eq!(made, DIGESTS);
}

const OWN: &str = "samovar | appliance | | appliance | graspable | 0.25 0.25 0.3 | 4 | | | kitchen/on/kitchen_counter:90\n\
                   plinth | decoration | | furniture | surface | 0.3 0.3 0.9 | 9 | | | living_room:1 bedroom:1\n\
                   urn | decoration | | prop | graspable | 0.15 0.15 0.3 | 1 | | | */on/plinth:1";

fn block(b: &mut Build<'_>) {
    let (x, y, z) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    b.block("block", [-x, -y, 0.0], [x, y, z], OAK);
    b.top("top", [0.0, 0.0, z], (x, y));
}

/// Homes with the furniture and the things of a program's own classes, as sound as others.
#[test]
fn things_of_own_classes_stand_in_generated_homes() {
    let classes = Arc::new(ClassTable::builtin().extended("own.txt", OWN).unwrap());
    let (names, mut generators) = (["samovar", "plinth", "urn"], Generators::default());
    for class in names {
        generators.register(&classes, Generator::new(class, Realm::Indoor, 1, block)).unwrap();
    }
    let mut found = [0; 3];
    for seed in (0..5).map(Seed) {
        let home = Apartment::generate_by(&Specification::default(), &generators, seed).unwrap();
        assert!(home.check().is_empty(), "{:?}", home.check());
        let scene = home.scene_with_classes(classes.clone());
        assert!(scene.validate().is_empty());
        let of = names.map(|class| scene.of_class(class));
        assert!(of[1].iter().all(|id| scene.node(*id).is_some_and(|node| node.role() == ObjectRole::Furniture)));
        found = std::array::from_fn(|i| found[i] + of[i].len());
    }
    assert!(found.iter().all(|count| *count > 1), "{found:?}");
    let layout = Layout::generate_by(&Specification::default(), &generators, Seed(0)).unwrap();
    assert!(layout.furniture.iter().any(|item| item.object.class == "plinth"));
    let none = Apartment::generate_by(&Specification::default(), &Generators::default(), Seed(0));
    assert_eq!(none, Apartment::from_seed(Seed(0)));
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
