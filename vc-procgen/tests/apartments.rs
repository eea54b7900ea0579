//! Apartments and buildings of many seeds, the apartments tested by a checker that shares nothing with the generator.
//!
//! All violations are printed, by classes. `VC_SEEDS=1000` tests that many seeds, `VC_FIRST_SEED=500` those
//! from there on.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

mod building;
mod checker;
mod city;
mod dressing;
mod house;

use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

use checker::{Finding, Rule, examine, report};
use proptest::prelude::*;
use vc_graph::format::{native, thesis};
use vc_graph::{ClassTable, Node, Pose, SceneGraph, Seed};
use vc_procgen::plan::RoomKind;
use vc_procgen::{Apartment, Specification, SpecificationError, Support};

/// The default number of seeds that the checker examines, and of those that are only counted.
const EXAMINED: u64 = 12;
const SEEDS: u64 = 40;

/// The violations of all tested apartments, by seed.
static FINDINGS: LazyLock<Vec<Finding>> = LazyLock::new(all);

fn number(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|s| s.parse().ok()).unwrap_or(usual)
}

fn all() -> Vec<Finding> {
    let first = number("VC_FIRST_SEED", 0);
    findings(first..first + number("VC_SEEDS", vc_testkit::amount(EXAMINED, SEEDS)), look)
}

/// The findings in the homes of some seeds, on all cores.
fn findings(seeds: std::ops::Range<u64>, look: impl Fn(u64) -> Vec<Finding> + Sync) -> Vec<Finding> {
    let next = AtomicU64::new(seeds.start);
    let work = || {
        let mut found = Vec::new();
        while let Some(seed) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|s| *s < seeds.end) {
            found.extend(look(seed));
        }
        found
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut found: Vec<Finding> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|w| w.join().unwrap()).collect()
    });
    found.sort_by_key(|f| f.seed);
    found
}

fn look(seed: u64) -> Vec<Finding> {
    match Apartment::from_seed(Seed(seed)) {
        Ok(home) => examine(seed, &home),
        Err(error) => {
            vec![Finding { rule: Rule::Generated, group: "error".into(), seed, text: error.to_string() }]
        }
    }
}

/// Fails with all violations of some rules.
fn holds(rules: &[Rule]) {
    let found: Vec<&Finding> = FINDINGS.iter().filter(|f| rules.contains(&f.rule)).collect();
    assert!(found.is_empty(), "{} violations\n{}", found.len(), report(&found));
}

#[test]
fn every_seed_makes_a_valid_scene() {
    holds(&[Rule::Generated, Rule::Valid]);
}

#[test]
fn no_two_solids_share_space() {
    holds(&[Rule::Collision]);
}

#[test]
fn everything_rests_on_what_carries_it() {
    holds(&[Rule::Support]);
}

#[test]
fn nothing_is_outside_its_room() {
    holds(&[Rule::Outside]);
}

#[test]
fn a_person_reaches_all_rooms_and_things() {
    holds(&[Rule::UnreachableRoom, Rule::UnreachableObject]);
}

#[test]
fn doors_and_fronts_have_room_to_open() {
    holds(&[Rule::BlockedDoor, Rule::BlockedFront]);
}

#[test]
fn rooms_have_what_makes_them_one() {
    holds(&[Rule::Incomplete, Rule::Passage]);
}

/// The rooms that should have a window, and those that do, over all seeds.
#[test]
fn bedrooms_and_living_rooms_have_windows() {
    let first = number("VC_FIRST_SEED", 0);
    let (mut rooms, mut dark) = (0, Vec::new());
    for seed in first..first + number("VC_SEEDS", SEEDS) {
        let Ok(home) = Apartment::from_seed(Seed(seed)) else { continue };
        let (all, without) = windows(&home);
        rooms += all;
        dark.extend(without.into_iter().map(|room| format!("seed {seed}: {room}")));
    }
    println!("{} of {rooms} bedrooms and living rooms are without a window", dark.len());
    assert!(dark.len() * 100 <= rooms, "{} of {rooms} have no window:\n{}", dark.len(), dark.join("\n"));
}

/// The number of bedrooms and living rooms, and those without a window.
fn windows(home: &Apartment) -> (usize, Vec<String>) {
    let scene = home.scene();
    let lit = |room| scene.in_room(room).any(|id| matches!(&*scene.label(id).class, "window" | "balcony_door"));
    let wants = |class: &str| matches!(class, "bedroom" | "kids_room" | "living_room");
    let rooms = scene.rooms().iter().filter(|r| wants(&scene.label(**r).class));
    let dark = rooms.clone().filter(|r| !lit(**r)).map(|r| scene.label(*r).to_string()).collect();
    (rooms.count(), dark)
}

fn written(seed: u64) -> String {
    native::write(&Apartment::from_seed(Seed(seed)).unwrap().scene())
}

/// Generates many seeds on a number of threads, in a given order.
fn written_on(threads: usize, order: &[u64]) -> Vec<(u64, String)> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut made = Vec::new();
        while let Some(&seed) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            made.push((seed, written(seed)));
        }
        made
    };
    let mut all: Vec<(u64, String)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|w| w.join().unwrap()).collect()
    });
    all.sort();
    all
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let order: Vec<u64> = (0..12).collect();
    let (backwards, shuffled) =
        (order.iter().rev().copied().collect::<Vec<_>>(), [7, 2, 9, 4, 11, 0, 5, 10, 1, 8, 3, 6]);
    let one = written_on(1, &order);
    for (threads, other) in [(2, &backwards[..]), (8, &shuffled[..])] {
        for (a, b) in one.iter().zip(&written_on(threads, other)) {
            assert!(a == b, "seed {} differs on {threads} threads", a.0);
        }
    }
}

#[test]
fn different_seeds_give_different_plans_and_content() {
    let homes: Vec<Apartment> = (0..SEEDS).map(|s| Apartment::from_seed(Seed(s)).unwrap()).collect();
    let content = |home: &Apartment| {
        let mut classes: Vec<&str> = home.items.iter().map(|i| i.object.class).collect();
        classes.sort_unstable();
        classes
    };
    for (i, a) in homes.iter().enumerate() {
        for b in &homes[..i] {
            assert!(a.plan != b.plan, "seeds {} and {} have one plan", a.seed.0, b.seed.0);
            assert!(content(a) != content(b), "seeds {} and {} have the same content", a.seed.0, b.seed.0);
        }
    }
}

#[test]
fn the_thesis_format_keeps_classes_and_poses() {
    let mut wrong = Vec::new();
    for seed in 0..6 {
        let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let read = thesis::read(&thesis::write(&scene), &ClassTable::builtin()).unwrap();
        assert_eq!(scene.len(), read.len(), "seed {seed}");
        wrong.extend(changed(&scene, &read).into_iter().map(|text| format!("seed {seed}: {text}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Nodes with another class, rotated, or with their box elsewhere: the format's locations are those of its
/// base.
fn changed(scene: &SceneGraph, read: &SceneGraph) -> Vec<String> {
    let off = |a: &Node, b: &Node| {
        let shift = match a.aabb().zip(b.aabb()) {
            Some((a, b)) => (a.min - b.min).norm().max((a.max - b.max).norm()),
            None => (a.position()? - b.position()?).norm(),
        };
        Some(shift.max(a.pose()?.rotation.angle_to(&b.pose()?.rotation)))
    };
    let differs = |node: &Node| {
        let other = read.node(node.id())?;
        let by = off(node, other)?;
        let same = node.class() == other.class() && by < 2e-3;
        (!same).then(|| format!("{} became {}, off by {by}", node.label(), other.label()))
    };
    scene.nodes().filter_map(differs).collect()
}

/// The requirements of a specification that a home does not fulfil.
fn unmet(wish: &Specification, home: &Apartment) -> Vec<String> {
    let count = |is: &dyn Fn(RoomKind) -> bool| home.plan.rooms.iter().filter(|r| is(r.kind)).count();
    let number = |what: &str, wished: Option<usize>, has: usize| {
        wished.filter(|w| *w != has).map(|w| format!("{w} {what} wished for, {has} made"))
    };
    let flag = |what: &str, wished: Option<bool>, kind: RoomKind| {
        let has = count(&|k| k == kind) > 0;
        wished.filter(|w| *w != has).map(|w| format!("{what}: wished {w}, made {has}"))
    };
    let off = wish.area.filter(|a| (home.plan.area() / a - 1.0).abs() > 0.05);
    let mut unmet: Vec<String> = [
        number("bedrooms", wish.bedrooms, count(&RoomKind::is_bedroom)),
        number("bathrooms", wish.bathrooms, count(&|k| k == RoomKind::Bathroom)),
        number("balconies", wish.balconies, count(&|k| k == RoomKind::Balcony)),
        flag("study", wish.study, RoomKind::Study),
        flag("laundry", wish.laundry, RoomKind::Laundry),
        flag("storage", wish.storage, RoomKind::Storage),
        flag("wc", wish.wc, RoomKind::Wc),
        off.map(|a| format!("{a} m² wished for, {} made", home.plan.area())),
    ]
    .into_iter()
    .flatten()
    .collect();
    unmet.extend(home.check().iter().map(ToString::to_string));
    unmet
}

fn wishes() -> impl Strategy<Value = Specification> {
    let maybe = || proptest::option::of(any::<bool>());
    let numbers =
        (proptest::option::of(0_usize..7), proptest::option::of(1_usize..5), proptest::option::of(0_usize..4));
    let measures = (proptest::option::of(15.0_f32..220.0), proptest::option::of(0.0_f32..=1.0));
    (numbers, (maybe(), maybe(), maybe(), maybe(), maybe()), measures).prop_map(|(n, f, m)| Specification {
        bedrooms: n.0,
        bathrooms: n.1,
        balconies: n.2,
        open_kitchen: f.0,
        study: f.1,
        laundry: f.2,
        storage: f.3,
        wc: f.4,
        area: m.0,
        clutter: m.1,
        style: None,
        dressing: None,
        fitted_kitchens: false,
        facade: None,
        plan: None,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any specification is fulfilled or refused with a readable reason.
    #[test]
    fn any_wish_is_met_or_refused(wish in wishes(), seed in any::<u64>()) {
        match Apartment::generate(&wish, Seed(seed)) {
            Ok(home) => {
                let unmet = unmet(&wish, &home);
                prop_assert!(unmet.is_empty(), "{wish:?}: {unmet:?}");
            }
            Err(SpecificationError::Unsound { last, .. }) => prop_assert!(false, "{wish:?}: gave up at {last}"),
            Err(error) => prop_assert!(error.to_string().len() > 20, "{wish:?}: {error}"),
        }
    }
}

/// Specifications that cannot be fulfilled, and words that each refusal must contain.
fn impossible() -> Vec<(Specification, &'static [&'static str])> {
    let of = |bedrooms, area| Specification { bedrooms, area, ..Specification::default() };
    let bathrooms = |n| Specification { bathrooms: Some(n), ..Specification::with_bedrooms(1) };
    let clutter = |c| Specification { clutter: Some(c), ..Specification::default() };
    vec![
        (of(Some(5), Some(20.0)), &["rooms", "20.0 m²", "fewer rooms or more area"]),
        (of(None, Some(f32::NAN)), &["area", "NaN"]),
        (of(None, Some(-30.0)), &["area", "-30"]),
        (of(None, Some(f32::INFINITY)), &["area", "inf"]),
        (of(Some(9), None), &["bedrooms", "9"]),
        (of(Some(0), Some(390.0)), &["390.0 m²", "add rooms or reduce the area"]),
        (bathrooms(4), &["bathrooms", "4"]),
        (bathrooms(0), &["bathrooms", "0"]),
        (clutter(1.5), &["clutter", "1.5"]),
        (clutter(f32::NAN), &["clutter", "NaN"]),
        (Specification { balconies: Some(7), ..Specification::default() }, &["balconies", "7"]),
    ]
}

#[test]
fn impossible_wishes_are_named() {
    for (wish, words) in impossible() {
        for seed in 0..4 {
            let refusal = Apartment::generate(&wish, Seed(seed)).map(|_| ()).unwrap_err().to_string();
            let missing: Vec<_> = words.iter().filter(|w| !refusal.contains(**w)).collect();
            assert!(missing.is_empty(), "{wish:?}: `{refusal}` does not say {missing:?}");
        }
    }
}

#[test]
fn extremes_are_met() {
    let small = Specification { area: Some(15.0), ..Specification::studio() };
    let large = Specification { area: Some(400.0), ..Specification::with_bedrooms(6) };
    let clutter = |c| Specification { clutter: Some(c), ..Specification::with_bedrooms(2) };
    let mut wrong = Vec::new();
    for wish in [small, large, clutter(0.0), clutter(1.0)] {
        for seed in 0..3 {
            match Apartment::generate(&wish, Seed(seed)) {
                Ok(home) => wrong.extend(unmet(&wish, &home).into_iter().map(|u| format!("{wish:?} seed {seed}: {u}"))),
                Err(error) => println!("{wish:?} seed {seed}: {error}"),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The first item that rests on another.
fn carried(home: &Apartment) -> usize {
    home.items.iter().position(|item| matches!(item.support, Support::On(..))).unwrap()
}

/// The check of an edited home says which reference is broken, and its scene leaves that relation out.
#[test]
fn broken_references_are_reported() {
    let home = Apartment::from_seed(Seed(7)).unwrap();
    let (item, rooms) = (carried(&home), home.plan.rooms.len());
    let Support::On(below, _) = home.items[item].support else { unreachable!() };
    let label = home.scene().label(home.item_id(item)).to_string();
    type Edit = Box<dyn Fn(&mut Apartment)>;
    let supported = |by| -> Edit { Box::new(move |home: &mut Apartment| home.items[item].support = by) };
    let edits: [(Edit, String); 8] = [
        (supported(Support::On(item, 0)), format!("{label} rests on item {item}, which does not precede it")),
        (supported(Support::Inside(99_999, 0)), format!("{label} rests on item 99999")),
        (supported(Support::On(below, 999)), format!("{label} rests on surface 999 of ")),
        (
            Box::new(move |home: &mut Apartment| home.items[below].support = Support::On(item, 0)),
            format!("rests on item {item}"),
        ),
        (Box::new(move |home| home.items[item].room = rooms), format!("{label} is in room {rooms}")),
        (Box::new(move |home| home.items[item].between = Some(rooms)), format!("{label} is in room {rooms}")),
        (Box::new(move |home| home.plan.openings[0].low = Some(rooms)), format!("opening 0 leads into room {rooms}")),
        (Box::new(|home| home.plan.rooms[0].rects[0].x0 = i32::MIN), "farther than 200 m".into()),
    ];
    for (edit, told) in edits {
        let mut edited = home.clone();
        edit(&mut edited);
        let found: Vec<String> = edited.check().iter().map(ToString::to_string).collect();
        assert!(found.iter().any(|text| text.contains(&told)), "{told}: {found:?}");
    }
    for support in [Support::On(item, 0), Support::Inside(99_999, 0)] {
        let mut edited = home.clone();
        (edited.items[item].support, edited.items[item].room) = (support, rooms);
        let (scene, id) = (edited.scene(), edited.item_id(item));
        assert_eq!((scene.len(), scene.room_of(id), scene.place(id)), (home.scene().len(), None, None));
    }
}

/// Items may be anywhere and rooms inside out: violations name items as the scene does.
#[test]
fn violations_name_the_node() {
    let home = Apartment::from_seed(Seed(7)).unwrap();
    let item = carried(&home);
    let label = home.scene().label(home.item_id(item)).to_string();
    for far in [50.0, 1e30, -1e30, f32::INFINITY, f32::NAN] {
        let mut edited = home.clone();
        edited.items[item].pose = Pose::translation(far, far, far);
        let found: Vec<String> = edited.check().iter().map(ToString::to_string).collect();
        assert!(found.iter().any(|text| text.starts_with(&format!("{label} is not within room"))), "{far}: {found:?}");
    }
    let mut inverted = home.clone();
    let rects = inverted.plan.rooms.iter_mut().flat_map(|room| &mut room.rects);
    rects.for_each(|r| std::mem::swap(&mut r.x0, &mut r.x1));
    assert!(!inverted.check().is_empty());
}
