//! The built-in class table, and tables of users.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use vc_graph::class::{Category, Class, SlotKind, Trait};
use vc_graph::format::native;
use vc_graph::{ClassError, ClassTable, Draft, ObjectRole, Property, PropertySet, Relation, SceneBuilder, Word};

#[test]
fn builtin_text_is_well_formed() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/classes");
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    names.sort();
    let all: String = names.iter().map(|p| std::fs::read_to_string(p).unwrap() + "\n").collect();
    let table =
        ClassTable::parse("all", &all).unwrap_or_else(|e| panic!("{e}\n{}", all.lines().nth(e.line - 1).unwrap()));
    assert_eq!(table.len(), ClassTable::builtin().len());
}

/// The thesis's Appendix C, by group.
const APPENDIX_C: &[&str] = &[
    "chair stool table dining_table high_table low_table",
    "printer audio_amplifier camera computer laptop tablet drone dvd_player graphic_tablet headset microphone keyboard",
    "mouse speaker television softbox tripod turntable virtual_headset webcam",
    "bookshelf treadmill dumbbell air_hockey_table arcade_machine foosball_table console controller dartboard",
    "hoverboard joystick jukebox ping_pong_table pool_table stroller swing toy_car",
    "candle frame mirror vase campfire firewood pizza_oven barbecue buoy carport composter diving_board garden_hose",
    "garden_shed gas_tank jacuzzi kennel ladder lawnmower pool pool_goal solar_shower watering_can wheelbarrow",
    "garden_chair garden_sofa garden_table",
];

#[test]
fn the_classes_of_the_thesis_are_known() {
    let table = ClassTable::builtin();
    let names: Vec<&str> = APPENDIX_C.iter().flat_map(|group| group.split(' ')).collect();
    let folded = |name: &str| name.replace('_', "");
    let known = |name: &str| {
        // By the whole name, not a part of it.
        let own = |c: &Class| std::iter::once(&c.name).chain(&c.aliases).any(|n| folded(n) == folded(name));
        table.get(name).is_some_and(own)
    };
    let missing: Vec<&&str> = names.iter().filter(|name| !known(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn there_are_many_classes() {
    let table = ClassTable::builtin();
    let count = |test: &dyn Fn(&Class) -> bool| table.iter().filter(|c| test(c)).count();
    assert!(table.len() >= 450);
    assert!(count(&|c| c.affords(Property::Drivable)) >= 13);
    assert!(count(&|c| c.category == Category::Food) >= 97);
    assert!(count(&|c| c.category == Category::Room) >= 10);
}

trait Affords {
    fn affords(&self, property: Property) -> bool;
}

impl Affords for Class {
    fn affords(&self, property: Property) -> bool {
        self.affordances.contains(property)
    }
}

#[test]
fn names_are_read_forgivingly() {
    let table = ClassTable::builtin();
    for (class, names) in [
        (
            "coffee_table",
            "coffee_table|coffeetable|SM_Coffee_Table_03|CoffeeTable|coffee table|COFFEE-TABLE|coffeeTable2",
        ),
        ("chair", "chair|chairs|Chairs|SM_Chair_12|BP_Chair|PRE_FUR_Chair_01"),
        ("milk", "milk|SM_Glass_Milk|food_milk"),
        ("kitchen_table", "kitchentable|KITCHEN_TABLE|Kitchen Tables"),
        ("fridge", "refrigerator|Fridge01|fridge"),
    ] {
        for name in names.split('|') {
            assert_eq!(table.get(name).map(|c| &*c.name), Some(class), "{name}");
        }
    }
    // Listing 1 of the thesis has such a name.
    assert!(table.get("SM_Glass").is_some() && table.get("SM_L_Table").is_some_and(|c| &*c.name == "table"));
    for name in ["", "_", "42", "SM_", "xyzzy", "🪑"] {
        assert!(table.get(name).is_none(), "{name}");
    }
}

#[test]
fn every_name_and_alias_finds_its_class() {
    let table = ClassTable::builtin();
    let mut lost = Vec::new();
    for class in table.iter() {
        for name in std::iter::once(&class.name).chain(&class.aliases) {
            for spelling in [name.to_string(), name.to_uppercase(), name.replace('_', " "), name.replace('_', "")] {
                assert_eq!(table.get(&spelling).map(|c| &c.name), Some(&class.name), "{spelling}");
            }
            let found = table.get(&format!("SM_{name}_07")).map(|c| &c.name);
            lost.extend((found != Some(&class.name)).then_some((name, found)));
        }
    }
    assert_eq!(lost, [], "as an engine writes them");
}

#[test]
fn kinds_reach_through_groups() {
    let table = ClassTable::builtin();
    for (kind, ancestor) in [
        ("apple", "food"),
        ("apple", "fruit"),
        ("CoffeeTable", "table"),
        ("mug", "dish"),
        ("sedan", "vehicle"),
        ("gizmo", "Gizmo"),
    ] {
        assert!(table.is_a(kind, ancestor), "{kind} is a {ancestor}");
    }
    assert!(!table.is_a("table", "coffee_table") && !table.is_a("apple", "vegetable") && !table.is_a("gizmo", "apple"));
    let table_class = table.get("table").unwrap();
    assert!(table.kinds_of(table_class).any(|c| &*c.name == "table"));
}

#[test]
fn every_class_has_a_size_and_a_mass() {
    for class in ClassTable::builtin().iter().filter(|c| c.category != Category::Group) {
        let size = class.size.unwrap_or_else(|| panic!("{} has no size", class.name));
        assert!(size.iter().all(|r| 0.0 < r.low && r.low <= r.high && r.high < 50.0), "{}", class.name);
        assert!(class.category == Category::Room || class.mass.is_some(), "{} has no mass", class.name);
        let typical = class.typical_size().unwrap();
        assert!(typical.iter().zip(size).all(|(t, r)| r.low <= *t && *t <= r.high));
    }
}

#[test]
fn start_states_exclude_nothing_and_fit_what_can_be_done() {
    use vc_graph::State;
    for class in ClassTable::builtin().iter() {
        assert_eq!(class.starts.conflicts().count(), 0, "{}", class.name);
        let either = |a, b| class.starts.contains(a) || class.starts.contains(b);
        let group = class.category == Category::Group && class.size.is_none();
        if !group {
            assert_eq!(class.affords(Property::Openable), either(State::Open, State::Closed), "{}", class.name);
            assert_eq!(class.affords(Property::Switchable), either(State::On, State::Off), "{}", class.name);
            assert_eq!(class.affords(Property::Plug), either(State::PluggedIn, State::PluggedOut), "{}", class.name);
        }
    }
}

#[test]
fn things_are_kept_on_surfaces_and_in_containers() {
    let table = ClassTable::builtin();
    let carry = [
        Property::Surface,
        Property::Sittable,
        Property::Lieable,
        Property::Container,
        Property::Recipient,
        Property::Heater,
    ];
    let enclose = [Property::Container, Property::Recipient, Property::Openable, Property::Drivable];
    let mut wrong = Vec::new();
    for class in table.iter() {
        for kept in &class.kept {
            let room = kept.room.as_deref().map(|r| table.get(r).unwrap());
            assert!(room.is_none_or(|r| r.category == Category::Room), "{}", class.name);
            let Some((relation, at)) = &kept.at else { continue };
            let fit: &[Property] = if *relation == Relation::On { &carry } else { &enclose };
            let at = table.get(at).unwrap();
            if !fit.iter().any(|&p| at.affords(p)) {
                wrong.push(format!("{} {relation} {}", class.name, at.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn errors_name_line_and_column() {
    let kitchen = "# a comment\n\nkitchen | | | room | | 3 3 2.5 | | | |\n";
    for (line, column, problem) in [
        ("mug", "name", "a class has 10 columns separated by `|`, this line has 1"),
        (
            " | | | prop | | | | | |",
            "name",
            "the name is missing or has characters other than letters, digits, `_` and `-`",
        ),
        (
            "my mug | | | prop | | | | | |",
            "name",
            "the name is missing or has characters other than letters, digits, `_` and `-`",
        ),
        (
            "- | | | prop | | | | | |",
            "name",
            "the name is missing or has characters other than letters, digits, `_` and `-`",
        ),
        ("Kitchen | | | room | | | | | |", "name", "`Kitchen` is the name or alias of another class already"),
        ("mug | | kitchen | prop | | | | | |", "aliases", "`kitchen` is the name or alias of another class already"),
        ("mug | dish | | prop | | | | | |", "kind of", "there is no class `dish`"),
        ("mug | mug | | prop | | | | | |", "kind of", "`mug` is a kind of itself"),
        ("mug | | | pottery | | | | | |", "category", "unknown category `pottery`; use one of: room structure"),
        (
            "mug | | | prop | grabable | | | | |",
            "affordances",
            "unknown property `grabable` (did you mean `graspable`?); use one of: surface",
        ),
        ("mug | | | prop | | 0.1 0.1 | | | |", "size", "a size is three ranges: depth, width and height in metres"),
        (
            "mug | | | prop | | 0.1 0.1 0.2-0.1 | | | |",
            "size",
            "`0.2-0.1` is no range of positive numbers such as `0.4-0.6`",
        ),
        ("mug | | | prop | | 0.1 0.1 NaN | | | |", "size", "`NaN` is no range"),
        ("mug | | | prop | | 0.1 0.1 1e39 | | | |", "size", "`1e39` is no range"),
        ("mug | | | prop | | | 0 | | |", "mass", "`0` is no range"),
        ("mug | | | prop | | | | tidy | |", "starts", "unknown state `tidy`; use one of: open"),
        ("mug | | | prop | | | | | hook |", "slots", "`hook` is no slot such as `drawer:3`"),
        ("mug | | | prop | | | | | nook:2 |", "slots", "unknown slot `nook` (did you mean `hook`?); use one of: shelf"),
        (
            "mug | | | prop | | | | | | kitchen",
            "kept",
            "`kitchen` is no place such as `kitchen/on/kitchen_table:3` or `kitchen:1`",
        ),
        ("mug | | | prop | | | | | | kitchen/under/mug:2", "kept", "`kitchen/under/mug:2` is no place"),
        ("mug | | | prop | | | | | | kitchen/on/shelf:2", "kept", "there is no class `shelf`"),
        ("mug | | | prop | | | | | | cellar:2", "kept", "there is no class `cellar`"),
    ] {
        let error = ClassTable::parse("mine.txt", &format!("{kitchen}{line}\n")).unwrap_err();
        assert_eq!((error.line, error.column), (4, column), "{error}");
        assert!(error.to_string().starts_with(&format!("mine.txt, line 4, column `{column}`: {problem}")), "{error}");
    }
}

#[test]
fn a_name_has_a_letter_or_digit() {
    for text in ["- | | | prop | | | | | |", "___ | | | prop | | | | | |", "mug | | !? | prop | | | | | |"] {
        assert!(ClassTable::parse("mine.txt", text).is_err(), "{text}: nothing is left to find it by");
    }
}

#[test]
fn cycles_are_found_between_several_classes() {
    let text = "a | b | | group | | | | | |\nb | c | | group | | | | | |\nc | a | | group | | | | | |\n";
    let error: ClassError = ClassTable::parse("mine.txt", text).unwrap_err();
    assert_eq!(error.to_string(), "mine.txt, line 1, column `kind of`: `a` is a kind of itself");
}

#[test]
fn tables_can_be_extended() {
    let builtin = ClassTable::builtin();
    let text =
        "mug_rack | furniture | | furniture | surface | 0.2 0.3 0.3 | 1 | | hook:6 | kitchen/on/kitchen_counter:1\n";
    let table = builtin.extended("mine.txt", text).unwrap();
    assert_eq!(table.len(), builtin.len() + 1);
    let rack = table.get("SM_Mug_Rack_1").unwrap();
    assert!(table.is_a("MugRack", "furniture") && rack.slots[0].kind == SlotKind::Hook);
    assert_eq!(rack.kept[0].at, Some((Relation::On, "kitchen_counter".into())));
    assert!(builtin.get("mug_rack").is_none_or(|c| &*c.name != "mug_rack"), "the built-in table is as it was");
    let taken = builtin.extended("mine.txt", "couch | | | furniture | | | | | |").unwrap_err();
    assert_eq!(
        taken.to_string(),
        "mine.txt, line 1, column `name`: `couch` is the name or alias of another class already"
    );
    assert!(builtin.extended("mine.txt", "").is_ok_and(|t| t.len() == builtin.len()));
}

/// ALFRED's classes that have other names here; the others have the same names.
const ALFRED: &str = "ArmChair:armchair BaseballBat:baseball_bat BathtubBasin:bathtub Cart:serving_trolley Cloth:washcloth \
    CoffeeMachine:coffee_maker CounterTop:kitchen_counter Curtains:curtain DishSponge:sponge Drawer:kitchen_drawer \
    Footstool:ottoman GarbageCan:trash_can Glassbottle:water_bottle HandTowel:towel HandTowelHolder:towel_rack \
    KeyChain:keys LaundryHamper:laundry_hamper Pan:frying_pan PaperTowelRoll:paper_towel PepperShaker:condiment_shaker \
    SaltShaker:condiment_shaker ScrubBrush:scrubbing_brush ShowerDoor:shower_stall ShowerGlass:shower_stall \
    SinkBasin:sink SoapBar:bar_soap SoapBottle:soap SprayBottle:all_purpose_cleaner Statue:sculpture \
    StoveBurner:stove ToiletPaperHanger:toilet_roll_holder ToiletPaperRoll:toilet_paper TowelHolder:towel_rack \
    WineBottle:wine LaundryHamperLid: StoveKnob:";

/// The other classes.
const ALFRED_SAME: &str = "AlarmClock Apple BasketBall Bathtub Bed Blinds Book Boots Bowl Box Bread ButterKnife Cabinet \
    Candle CD CellPhone Chair CreditCard Cup Desk DeskLamp Dresser Egg FloorLamp Fork Fridge HousePlant Kettle Knife \
    Ladle Laptop Lettuce LightSwitch Microwave Mirror Mug Newspaper Ottoman Painting PaperTowel Pen Pencil Pillow Plate \
    Plunger Poster Pot Potato RemoteControl Safe Shelf Sink Sofa Spatula Spoon DiningTable CoffeeTable SideTable \
    TeddyBear Television TennisRacket TissueBox Toaster Toilet ToiletPaper Tomato Towel TVStand Vase Watch WateringCan \
    Window";

#[test]
fn the_classes_of_alfred_are_known() {
    let table = ClassTable::builtin();
    let folded = |name: &str| name.replace('_', "").to_lowercase();
    for (name, class) in ALFRED.split_whitespace().map(|pair| pair.split_once(':').unwrap()) {
        assert_eq!(table.get(name).map_or("", |c| &c.name), class, "{name}");
    }
    for name in ALFRED_SAME.split_whitespace() {
        let class = table.get(name).unwrap_or_else(|| panic!("{name} is unknown"));
        let called = std::iter::once(&class.name).chain(&class.aliases).any(|n| folded(n) == folded(name));
        assert!(called, "{name} is taken for {}", class.name);
    }
}

#[test]
fn a_compound_is_what_its_last_word_says() {
    let table = ClassTable::builtin();
    for name in ["kitchen_gadget", "man_cave_sign", "fridge_magnet", "KitchenGadget", "SM_Fridge_Magnet_02"] {
        assert_eq!(table.get(name).map(|c| &c.name), None, "{name}");
    }
    for (name, class) in [
        ("toy_kitchen_table", "kitchen_table"),
        ("SM_Table_Round_White_03", "table"),
        ("SM_Chair_A", "chair"),
        ("food_milk", "milk"),
    ] {
        assert_eq!(table.get(name).map_or("", |c| &c.name), class, "{name}");
    }
}

/// The classes of each role; the table lists all but furniture and loose things.
const ROLES: &str = include_str!("roles.txt");

#[test]
fn every_class_has_the_role_that_it_plays() {
    let lines = ROLES.lines().filter(|line| !line.starts_with('#')).map(|line| line.split_once('|').unwrap());
    let pairs = |(role, classes): (&'static str, &'static str)| {
        classes.split_whitespace().map(move |class| (class, ObjectRole::parse(role.trim()).unwrap()))
    };
    let listed: BTreeMap<&str, ObjectRole> = lines.flat_map(pairs).collect();
    let table = ClassTable::builtin();
    for class in table.iter() {
        let by_use = if class.affords(Property::Graspable) { ObjectRole::Loose } else { ObjectRole::Furniture };
        assert_eq!(class.role(), *listed.get(&*class.name).unwrap_or(&by_use), "{}", class.name);
    }
    let unknown: Vec<&&str> = listed.keys().filter(|name| table.get(name).is_none()).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn a_node_has_the_role_of_its_class_or_else_of_its_category() {
    let text =
        "shoji | blinds | | decor | openable | 0.1 1 2 | 5 | closed | |\nparquet | floor | | structure | | | | | |";
    let table = ClassTable::builtin().extended("mine.txt", text).unwrap();
    let mut scene = SceneBuilder::with_classes("flat", table.into());
    for (class, category, role) in [
        ("shoji", None, ObjectRole::Cover),
        ("parquet", None, ObjectRole::Floor),
        // The class table knows better than a scene's author.
        ("doorjamb", Some("Doors"), ObjectRole::DoorFrame),
        ("curtains", Some("Furniture"), ObjectRole::Cover),
        // It lacks these classes.
        ("qwertz", Some("Walls"), ObjectRole::Wall),
        ("qwertz", Some("Floor"), ObjectRole::Floor),
        ("qwertz", Some("Floors"), ObjectRole::Floor),
        ("qwertz", Some("Ceiling"), ObjectRole::Ceiling),
        ("qwertz", Some("Windows"), ObjectRole::Window),
        ("qwertz", Some("structure"), ObjectRole::Structure),
        ("qwertz", Some("Lamps"), ObjectRole::Light),
        ("qwertz", Some("Rooms"), ObjectRole::Room),
        ("qwertz", Some("character"), ObjectRole::Person),
        ("qwertz", None, ObjectRole::Furniture),
        ("apple", None, ObjectRole::Loose),
    ] {
        let id = scene.add(Draft { category: category.map(Into::into), ..Draft::new(class) }).unwrap();
        assert_eq!(scene.graph().node(id).unwrap().role(), role, "{class} in {category:?}");
    }
    let bolted = Draft { properties: Some(Default::default()), ..Draft::new("qwertz") };
    let held = Draft { properties: Some(PropertySet::from_words(&[Property::Graspable])), ..Draft::new("qwertz") };
    let [bolted, held] = [bolted, held].map(|draft| scene.add(draft).unwrap());
    let scene = scene.build();
    let role = |id| scene.node(id).unwrap().role();
    assert_eq!([role(bolted), role(held)], [ObjectRole::Furniture, ObjectRole::Loose]);
    let again = native::read(&native::write(&scene), scene.classes()).unwrap();
    assert!(scene.nodes().all(|n| again.node(n.id()).is_some_and(|m| m.role() == n.role())), "written and read");
}

#[test]
fn traits_follow_as_an_eleventh_column() {
    let text = "stress_ball | | | toy | graspable | 0.06 0.06 0.06 | 0.1 | | | | squeezable";
    let table = ClassTable::builtin().extended("mine.txt", text).unwrap();
    let soft = |name: &str| table.get(name).unwrap().traits.contains(Trait::Squeezable);
    assert!(soft("stress_ball") && soft("sponge") && soft("cleaning_solution") && !soft("mug"));
    let error = ClassTable::parse("mine.txt", "ball | | | toy | | | | | | | bouncy").unwrap_err();
    assert!(error.to_string().starts_with("mine.txt, line 1, column `traits`: unknown trait `bouncy`"), "{error}");
}

/// An accent may be one character with its letter or a character of its own; both look the same and are the same name,
/// in tables, scenes, goals and labels.
#[test]
fn accents_are_the_same_however_they_are_written() {
    let (one, two) = ("caf\u{e9}_table", "cafe\u{301}_table");
    for (written, read) in [(one, two), (two, one)] {
        let mut scene = vc_graph::SceneBuilder::new("flat");
        let room = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
        let table = scene.add_in(room, vc_graph::Draft::new(written)).unwrap();
        let me = scene.add_in(room, vc_graph::Draft::new("character")).unwrap();
        let graph = scene.build();
        assert_eq!(graph.of_class(read), [table]);
        assert_eq!(graph.check_name(read, table), Ok(()));
        let walk: vc_graph::Action = format!("walk {read}.{}", table.0).parse().unwrap();
        assert_eq!(vc_graph::rule::refusals(&graph, me, &walk), []);
        let goal = |name: &str| format!("Near(me, {name})").parse::<vc_graph::Goal>().unwrap();
        assert_eq!(goal(read), goal(written));
        let line = format!("{written} | furniture | | furniture | surface | 0.7 0.7 0.7 | 9 | | |");
        let table = ClassTable::builtin().extended("mine.txt", &line).unwrap();
        assert_eq!(table.get(read).unwrap().name, table.get(written).unwrap().name);
        assert!(table.is_a(read, written));
    }
}
