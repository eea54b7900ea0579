//! Properties of every generated object: closed, connected, within its size, with free surfaces and
//! movable joints.
//!
//! All violations are printed, by class. `OBJECT_CLASSES=chair,stool` tests only these classes,
//! `OBJECT_SEEDS=20` more seeds of each.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

mod appendix;
mod cases;
mod faces;
mod motion;
mod own;
mod places;
mod solid;
mod whole;

use std::collections::{BTreeMap, HashSet};

use cases::{FINDINGS, Rule, chosen};
use vc_graph::Seed;
use vc_graph::hash::Digester;
use vc_shapes::material::{Family, MaterialId};
use vc_shapes::object::{self, Realm, generators};
use vc_shapes::{Style, catalogue};

/// Fails with all violations of a rule, some of each class.
fn holds(rule: Rule) {
    const SHOWN: usize = 3;
    let mut classes: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for finding in FINDINGS.iter().filter(|f| f.rule == rule) {
        classes.entry(finding.class).or_default().push(&finding.text);
    }
    let mut report = String::new();
    for (class, texts) in &classes {
        texts.iter().take(SHOWN).for_each(|t| report += &format!("  {class} {t}\n"));
        let more = texts.len().saturating_sub(SHOWN);
        report += &if more > 0 { format!("  {class} and {more} more\n") } else { String::new() };
    }
    assert!(classes.is_empty(), "{rule:?}: {} classes\n{report}", classes.len());
}

#[test]
fn no_size_makes_a_generator_panic() {
    holds(Rule::Panic);
}

#[test]
fn libraries_accept_every_asset() {
    holds(Rule::Accepted);
}

#[test]
fn the_same_seed_makes_the_same_bytes() {
    holds(Rule::Same);
}

#[test]
fn every_part_is_a_closed_solid() {
    holds(Rule::Closed);
}

#[test]
fn objects_keep_within_the_size_asked_for() {
    holds(Rule::Size);
}

#[test]
fn objects_stand_on_the_middle_of_their_base() {
    holds(Rule::Base);
}

#[test]
fn no_part_floats() {
    holds(Rule::Floating);
}

#[test]
fn what_one_grasps_lies_or_stands() {
    holds(Rule::Stable);
}

#[test]
fn triangles_keep_within_a_budget() {
    holds(Rule::Triangles);
}

#[test]
fn no_two_faces_lie_in_one_place() {
    holds(Rule::Faces);
}

#[test]
fn surfaces_lie_on_the_object_and_are_free() {
    holds(Rule::Surface);
}

#[test]
fn what_holds_things_has_a_place_for_them() {
    holds(Rule::Affordance);
}

#[test]
fn what_opens_moves_through_nothing() {
    holds(Rule::Motion);
}

#[test]
fn every_class_has_one_generator_and_is_known() {
    let table = vc_graph::ClassTable::builtin();
    let unknown = |class: &str| table.get(class).is_none_or(|c| &*c.name != class);
    let bad: Vec<_> = generators().filter(|g| unknown(g.class) || g.instances == 0).map(|g| g.class).collect();
    assert_eq!(bad, [""; 0], "not in the class table, or no instances");
    let mut seen = HashSet::new();
    let twice: Vec<_> = generators().filter(|g| !seen.insert(g.class)).map(|g| g.class).collect();
    assert_eq!(twice, [""; 0], "two generators");
}

#[test]
fn the_catalogue_is_large_enough() {
    let mut shapes: BTreeMap<&str, HashSet<u64>> = BTreeMap::new();
    for instance in catalogue::instances(Seed(0)).filter(|i| chosen(i.generator.class)) {
        shapes.entry(instance.generator.class).or_default().insert(instance.object.shape_key().0);
    }
    let of = |realm| generators().filter(move |g| g.realm == realm);
    let distinct = |realm| of(realm).filter_map(|g| shapes.get(g.class)).map(HashSet::len).sum::<usize>();
    let (indoor, outdoor) = (distinct(Realm::Indoor), distinct(Realm::Outdoor));
    let counts = shapes.iter().map(|(class, keys)| format!("{class} {}", keys.len()));
    println!("{}", counts.collect::<Vec<_>>().join(", "));
    println!("{indoor} distinct indoor objects, {outdoor} outdoor ones");
    let all = generators().all(|g| chosen(g.class));
    assert!(indoor >= 2400 || !all, "{indoor} indoor objects instead of 2400");
    assert!(outdoor >= 4500 || !all, "{outdoor} outdoor objects instead of 4500");
}

#[test]
fn every_class_has_the_instances_it_names() {
    let mut shapes: BTreeMap<&str, HashSet<u64>> = BTreeMap::new();
    for instance in catalogue::instances(Seed(0)).filter(|i| chosen(i.generator.class)) {
        shapes.entry(instance.generator.class).or_default().insert(instance.object.shape_key().0);
    }
    let few = generators().filter(|g| shapes.get(g.class).is_some_and(|s| s.len() < g.instances));
    let mut short: Vec<String> =
        few.map(|g| format!("{}: {} shapes of {} instances", g.class, shapes[g.class].len(), g.instances)).collect();
    if generators().all(|g| chosen(g.class)) {
        short.extend(appendix::missing(&shapes));
    }
    assert!(short.is_empty(), "too few:\n  {}", short.join("\n  "));
}

/// The digest of all objects of the catalogue of seed 0, parts and surfaces. It is the same on every machine; a
/// change of a generator must update it.
const DIGEST: &str = "010063d95ab85efa";

#[test]
fn every_machine_makes_the_same_objects() {
    let mut all = Digester::new();
    for instance in catalogue::instances(Seed(0)) {
        let bytes = serde_json::to_vec(&instance.object.asset).unwrap();
        let mut one = Digester::new();
        one.words(bytes.into_iter().map(u64::from));
        all.word(one.digest().0);
    }
    assert_eq!(all.digest().to_string(), DIGEST);
}

/// The single convex body that physics uses is as large as the visible object.
#[test]
fn lumps_are_as_large_as_what_is_seen() {
    let mut lumps = 0;
    for instance in catalogue::instances(Seed(0)).filter(|i| chosen(i.generator.class)) {
        let asset = &instance.object.asset;
        for lump in asset.collision.iter().filter(|p| &*p.name == "lump") {
            lumps += 1;
            let seen = asset.parts.iter().filter(|p| p.joint == lump.joint);
            let (around, own) = (cases::around(seen), cases::around([lump]));
            for axis in 0..3 {
                let (size, far) = (around[1][axis] - around[0][axis], |i: usize| own[i][axis]);
                let slack = 0.001 + 0.04 * size;
                let within = far(0) >= around[0][axis] - 0.001 && far(1) <= around[1][axis] + 0.001;
                let reaches = far(0) <= around[0][axis] + slack && far(1) >= around[1][axis] - slack;
                assert!(within && reaches, "{}, axis {axis}: {own:?} of {around:?}", instance.generator.class);
            }
        }
    }
    assert!(lumps > 100 || !generators().all(|g| chosen(g.class)), "{lumps}");
}

/// The whole picture of a screen is dark when the screen is off.
#[test]
fn pictures_of_screens_are_of_light() {
    for class in ["television", "monitor", "laptop", "tablet", "digital_photo_frame"] {
        let generator = object::generator(class).unwrap();
        for seed in 0..40 {
            let made = generator.object(&Style::from_seed(Seed(seed)), Seed(seed));
            for part in made.asset.parts.iter().filter(|part| &*part.name == "picture") {
                let mat = MaterialId(part.material);
                assert_eq!(mat.family(), Some(Family::Screen), "{class} {seed}: {} in its picture", mat.name());
            }
        }
    }
}

/// A panel behind the slats of a louvred door hides the contents.
#[test]
fn louvred_doors_are_closed_behind_their_slats() {
    let generator = object::generator("wardrobe").unwrap();
    let mut louvred = 0;
    for seed in 0..40 {
        let asset = generator.object(&Style::from_seed(Seed(seed)), Seed(seed)).asset;
        let named = |name: &'static str| asset.parts.iter().filter(move |p| &*p.name == name && p.joint.is_some());
        let joints: Vec<_> = named("slat").filter_map(|p| p.joint).collect();
        for joint in joints.iter().enumerate().filter(|(i, j)| !joints[..*i].contains(j)).map(|(_, j)| *j) {
            let around = |name| cases::around(named(name).filter(|p| p.joint == Some(joint)));
            let (slats, panel) = (around("slat"), around("panel"));
            for axis in 1..3 {
                assert!(panel[0][axis] <= slats[0][axis] + 1e-4 && panel[1][axis] >= slats[1][axis] - 1e-4, "{seed}");
            }
            assert!(panel[1].x < slats[1].x, "{seed}: the panel is in front of the slats");
            louvred += 1;
        }
    }
    assert!(louvred > 0);
}
