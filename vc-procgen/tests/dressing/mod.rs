//! Homes dressed by a table: sound, the same for a seed, with what rooms always have; tables of a program's own, and broken
//! ones.

use vc_graph::format::native;
use vc_graph::{ClassTable, NodeId, SceneGraph, Seed};
use vc_procgen::{Apartment, Area, Dressing, DressingFault, Item, Specification};

use crate::checker::{Finding, examine, report};
use crate::{findings, number};

/// The number of dressed homes that are examined, usually and in the long run.
const FEW: u64 = 4;
const MANY: u64 = 100;

fn dressed(dressing: Dressing, seed: u64) -> Apartment {
    let wishes = Specification { dressing: Some(dressing), ..Specification::default() };
    Apartment::generate(&wishes, Seed(seed)).unwrap()
}

fn parsed(text: &str) -> Dressing {
    Dressing::parse("mine.txt", text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_built_in_table_is_read() {
    let read = Dressing::parse("dressing.txt", include_str!("../../data/dressing.txt"));
    let read = read.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(read, Dressing::builtin());
    assert!(read.classes().len() > 300);
}

#[test]
fn the_checkers_find_nothing_in_dressed_homes() {
    let first = number("VC_FIRST_SEED", 0);
    let found = findings(first..first + number("VC_SEEDS", vc_testkit::amount(FEW, MANY)), |seed| {
        let home = dressed(Dressing::builtin(), seed);
        assert!(home.check().is_empty(), "seed {seed}: {:?}", home.check());
        examine(seed, &home)
    });
    let found: Vec<&Finding> = found.iter().collect();
    assert!(found.is_empty(), "{} violations\n{}", found.len(), report(&found));
}

#[test]
fn the_same_seed_is_dressed_the_same_on_any_thread() {
    let written = |seed| native::write(&dressed(Dressing::builtin(), seed).scene());
    for seed in 0..4 {
        let other = std::thread::spawn(move || written(seed)).join().unwrap();
        assert!(written(seed) == other, "seed {seed}");
    }
}

/// The rooms of a class in some homes, each with the classes of all that is in it.
fn rooms(class: &str, homes: &[SceneGraph]) -> Vec<Vec<String>> {
    let of =
        |scene: &SceneGraph, room: NodeId| scene.in_room(room).map(|id| scene.label(id).class.to_string()).collect();
    homes.iter().flat_map(|scene| scene.of_class(class).into_iter().map(move |room| of(scene, room))).collect()
}

#[test]
fn rooms_have_what_rooms_of_their_kind_have() {
    let homes: Vec<SceneGraph> = (0..12).map(|seed| dressed(Dressing::builtin(), seed).scene()).collect();
    let share = |room: &str, classes: &[&str]| {
        let rooms = rooms(room, &homes);
        let having = rooms.iter().filter(|room| room.iter().any(|class| classes.contains(&class.as_str()))).count();
        having as f32 / rooms.len() as f32
    };
    let usual: [(&str, &[&str]); 9] = [
        ("bathroom", &["towel", "bath_towel"]),
        ("bathroom", &["toilet_paper"]),
        ("bathroom", &["soap", "hand_soap", "bar_soap"]),
        ("kitchen", &["dish_soap"]),
        ("kitchen", &["kettle"]),
        ("kitchen", &["sponge"]),
        ("living_room", &["remote_control"]),
        ("kids_room", &["teddy_bear", "plush_toy", "doll", "toy_robot", "toy_dinosaur", "toy_animal", "action_figure"]),
        ("hallway", &["envelope", "mail", "bills", "check", "greeting_card", "document", "form", "newspaper", "keys"]),
    ];
    for (room, classes) in usual {
        assert!(share(room, classes) >= 0.6, "{room}: {classes:?} in {:.2}", share(room, classes));
    }
    assert_eq!(share("kids_room", &["cookbook", "suit"]), 0.0);
}

/// The base units of fitted kitchens stand side by side or around a corner, none alone, and nothing is missing.
#[test]
fn kitchens_are_fitted() {
    /// The greatest gap between units, metres.
    const JOINT: f32 = 0.005;
    let meet = |a: Area, b: Area| {
        let grown = Area { x0: a.x0 - JOINT, y0: a.y0 - JOINT, x1: a.x1 + JOINT, y1: a.y1 + JOINT };
        grown.overlaps(&b)
    };
    let (mut kitchens, mut fitted) = (0, 0);
    for seed in 0..16 {
        let dressing = (seed % 2 == 0).then(Dressing::builtin);
        let wishes = Specification { dressing, fitted_kitchens: true, ..Specification::default() };
        let home = Apartment::generate(&wishes, Seed(seed)).unwrap();
        assert_eq!(home.check(), [], "seed {seed}");
        for room in 0..home.plan.rooms.len() {
            let here = home.items.iter().filter(|item| item.room == room);
            let of = |classes: &[&str]| -> Vec<Area> {
                here.clone().filter(|item| classes.contains(&item.object.class)).map(Item::area).collect()
            };
            kitchens += usize::from(!of(&["kitchen_sink"]).is_empty());
            if of(&["backsplash"]).is_empty() {
                continue;
            }
            fitted += 1;
            let mut apart = of(&["kitchen_cabinet", "kitchen_sink", "dishwasher", "stove"]);
            let mut run = vec![apart.remove(0)];
            while let Some(at) = apart.iter().position(|unit| run.iter().any(|other| meet(*other, *unit))) {
                run.push(apart.remove(at));
            }
            assert!(apart.is_empty(), "seed {seed}: {apart:?} stand apart from {run:?}");
            for class in ["kitchen_cabinet", "kitchen_sink", "stove", "fridge", "extractor"] {
                assert!(!of(&[class]).is_empty(), "seed {seed}: no {class}");
            }
        }
    }
    assert!(fitted * 4 >= kitchens * 3, "{fitted} of {kitchens} kitchens are fitted");
}

#[test]
fn dressed_rooms_have_more_things() {
    let count = |home: Apartment| home.items.len();
    let more = (0..8).map(|seed| count(dressed(Dressing::builtin(), seed))).sum::<usize>() as f32;
    let plain = (0..8).map(|seed| count(Apartment::from_seed(Seed(seed)).unwrap())).sum::<usize>() as f32;
    assert!(more > 1.2 * plain, "{more} and {plain}");
}

/// A table of a program's own decides alone what is added, and where.
#[test]
fn a_table_of_ones_own_is_followed() {
    let text = "trait never | 0\n[kitchen]\n1 | kitchen_scale | on kitchen_cabinet\n  1 | rolling_pin | beside it\n\
                1 never | whisk | on kitchen_cabinet\n[bathroom]\n1 | towel_rack | at 1.2\n  1 | towel | hang it";
    let mut found = 0;
    for seed in 0..6 {
        let scene = dressed(parsed(text), seed).scene();
        let pins = scene.of_class("rolling_pin").into_iter().filter_map(|pin| scene.place(pin));
        found += pins.filter(|place| &*scene.label(place.at).class == "kitchen_cabinet").count();
        let towels = scene.of_class("towel").into_iter().filter_map(|towel| scene.place(towel));
        found += towels.filter(|place| &*scene.label(place.at).class == "towel_rack").count();
    }
    assert!(found >= 6, "{found}");
    let none = Specification {
        clutter: Some(0.0),
        dressing: Some(parsed("[kitchen]\n0 | whisk | on kitchen_cabinet")),
        ..Specification::default()
    };
    let scene = Apartment::generate(&none, Seed(3)).unwrap().scene();
    assert!(scene.of_class("whisk").is_empty());
}

#[test]
fn lines_are_added_to_a_table() {
    let more = Dressing::builtin().extended("mine.txt", "[hallway]\n1 cat | @post | floor\n1 | globe | floor").unwrap();
    let globes = (0..6).map(|seed| dressed(more.clone(), seed).scene().of_class("globe").len()).sum::<usize>();
    let before = (0..6).map(|seed| dressed(Dressing::builtin(), seed).scene().of_class("globe").len()).sum::<usize>();
    assert!(globes > before, "{globes} and {before}");
}

/// One more line in the middle of a table adds its things, and all others are where they were.
#[test]
fn a_line_leaves_the_things_of_others_as_they_were() {
    let before = "[living_room]\n0.5 | 1-3 novel/magazine | on coffee_table\n";
    let after = "0.5 | 1-2 mug/cup | on sideboard\n  0.5 | spoon | beside it\n[bedroom]\n0.5 | 1-4 cushion | on bed\n\
                 0.5 | 1-3 painting | at 1.4\n[kitchen]\n0.5 | kettle/toaster | back on kitchen_cabinet\n";
    let more = "1 | bird_house | on dining_chair\n0.9 | bird_house | floor\n";
    let things = |text: &str, seed| {
        let home = dressed(parsed(text), seed);
        let others = home.items.into_iter().filter(|item| !["clothes_pile", "bird_house"].contains(&item.object.class));
        let told = others.map(|item| format!("{} {:?} {:?}", item.object.class, item.pose, item.object.size()));
        told.collect::<Vec<_>>()
    };
    for seed in 0..8 {
        assert_eq!(
            things(&format!("{before}{after}"), seed),
            things(&format!("{before}{more}{after}"), seed),
            "{seed}"
        );
    }
    let birds = |seed| dressed(parsed(&format!("{before}{more}{after}")), seed).scene().of_class("bird_house").len();
    assert!((0..8).map(birds).sum::<usize>() > 0);
}

#[test]
fn broken_lines_are_told_with_their_number() {
    let broken = [
        ("[kitchn]", "mine.txt:1: there is no kind of room `kitchn` (did you mean `kitchen`?)"),
        ("1 | mug | on desk", "mine.txt:1: this rule is for no room"),
        ("[kitchen]\n1 | mug", "mine.txt:2: a rule has three columns"),
        ("[kitchen]\n\n# x\n2 | mug | on desk", "mine.txt:4: `2` is not a chance"),
        ("[kitchen]\nnan | mug | on desk", "`nan` is not a chance"),
        ("[kitchen]\n1 cot | mug | on desk", "there is no trait `cot`"),
        ("[kitchen]\n1 | x-3 mug | on desk", "`x-3` is not a number of things"),
        ("[kitchen]\n1 | 99 mug | on desk", "`99` is not a number of things"),
        ("[kitchen]\n1 | mugg | on desk", "there is no class `mugg` (did you mean `mug`"),
        ("[kitchen]\n1 | violin | on desk", "no objects of the class `violin` can be made"),
        ("[kitchen]\n1 | @cups | on desk", "there is no list `@cups`"),
        ("[kitchen]\n1 | mug | under desk", "`under desk` is not a place"),
        ("[kitchen]\n1 | mug | at 7", "`at 7` is not a place"),
        ("[kitchen]\n1 | mug | beside it", "`it` is the thing of the line above"),
        ("[kitchen]\n1 | mug | on desk\n  1 | cup | on desk", "mine.txt:3: an indented line is about the thing above"),
        ("[kitchen]\n  1 | mug | beside it", "below no rule"),
        ("[kitchen]\n1 | mug | on desk\n    1 | cup | beside it", "below no rule"),
        ("[kitchen]\n1 | trash_can | corner\n  1 | cup | beside it", "stands on the floor or hangs"),
        ("trait a | 0.5 b", "there is no trait `b`"),
    ];
    for (text, told) in broken {
        let error = Dressing::parse("mine.txt", text).map(|_| ()).unwrap_err();
        assert!(error.to_string().contains(told), "{text:?}: `{error}` does not say `{told}`");
    }
    let many: String = (0..64).map(|n| format!("trait t{n} | 0.5\n")).collect();
    let error = Dressing::parse("mine.txt", &many).unwrap_err();
    assert!(matches!(error.fault, DressingFault::TooManyTraits(_)) && error.line == 58, "{error}");
}

#[test]
fn classes_of_a_programs_own_are_read_with_their_table() {
    let row = "plinth | decoration | | furniture | surface | 0.25 0.25 0.8-1.0 | 9 | | | living_room:1";
    let classes = ClassTable::builtin().extended("mine.txt", row).unwrap();
    let text = "[living_room]\n1 | plinth | corner\n  1 | vase | on it";
    assert!(Dressing::parse("mine.txt", text).is_err());
    assert!(Dressing::parse_with("mine.txt", text, &classes).is_ok_and(|table| table.classes() == ["plinth", "vase"]));
}
