//! VirtualHome's five scenes and the bundled apartment, read, written and checked.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

#[cfg(feature = "procgen")]
mod dressed;

use std::collections::BTreeSet;
use std::io::{Read, Write};

use vc_graph::format::virtualhome::EnvironmentGraph;
use vc_graph::format::{native, read_scene, thesis, virtualhome};
use vc_graph::{ClassTable, NodeKind, Relation, SceneGraph, Violation};
use virtualcity::ResumableRun;

/// Nodes and edges of each scene, by its file.
const SIZES: [(u32, usize, usize); 5] =
    [(1, 437, 14_157), (2, 310, 7_059), (3, 392, 8_830), (5, 354, 11_980), (6, 337, 8_742)];

#[test]
fn virtualhome_scenes_round_trip() {
    let classes = ClassTable::builtin();
    for (number, nodes, edges) in SIZES {
        let Some(text) = vc_testkit::data::text(&format!("virtualhome/scene{number}.json.gz")) else { return };
        let graph = virtualhome::read(&text, &classes).unwrap();
        assert_eq!((graph.len(), graph.edges().count()), (nodes, edges), "scene {number}");
        let again = virtualhome::read(&virtualhome::write(&graph), &classes).unwrap();
        assert_eq!(graph, again, "scene {number}");
        assert_eq!(graph.digest(), again.digest());
    }
}

/// Not only the graph but the file itself has the same content before and after.
#[test]
fn nothing_of_the_file_is_lost() {
    for number in vc_testkit::data::SCENES {
        let Some(text) = vc_testkit::data::text(&format!("virtualhome/scene{number}.json.gz")) else { return };
        let file: EnvironmentGraph = serde_json::from_str(&text).unwrap();
        let written = EnvironmentGraph::from_scene(&file.build("scene", &ClassTable::builtin()).unwrap());
        assert!(written.difference(&file).is_empty(), "scene {number}: {:?}", written.difference(&file));
        for (before, after) in file.nodes.iter().zip(&written.nodes) {
            let set = |words: &[String]| words.iter().cloned().collect::<BTreeSet<_>>();
            assert_eq!(set(&before.properties), set(&after.properties), "node {}", before.id);
            assert_eq!(before.bounding_box, after.bounding_box, "node {}", before.id);
            assert_eq!((&before.class_name, &before.category), (&after.class_name, &after.category));
            assert_eq!(before.prefab_name, after.prefab_name);
        }
    }
}

#[test]
fn every_scene_goes_through_the_native_format() {
    let classes = ClassTable::builtin();
    let scenes = vc_testkit::data::SCENES.iter().filter_map(|&n| vc_testkit::data::scene(n));
    for graph in scenes.chain([vc_testkit::data::apartment()]) {
        let text = native::write(&graph);
        let again = native::read(&text, &classes).unwrap();
        assert_eq!(graph, again);
        assert_eq!(text, native::write(&again));
    }
}

#[test]
fn every_class_of_the_scenes_is_known() {
    let classes = ClassTable::builtin();
    for graph in vc_testkit::data::SCENES.iter().filter_map(|&n| vc_testkit::data::scene(n)) {
        let unknown: BTreeSet<&str> =
            graph.nodes().map(|n| &*n.spec().spelling).filter(|name| classes.get(name).is_none()).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
    }
}

/// All classes in the programs' scenes: a class counts as known only by its whole name, not by a guess from a
/// part of it.
#[test]
fn every_class_of_the_programs_is_known() {
    let Some(text) = vc_testkit::data::text("eai/programs_dev.jsonl.gz") else { return };
    let classes = ClassTable::builtin();
    let records = text.lines().map(|line| vc_graph::format::eai::read_record(line).unwrap());
    let names: BTreeSet<String> = records.flat_map(|r| r.initial.nodes.into_iter().map(|n| n.class_name)).collect();
    let same = |a: &str, b: &str| a.replace(['_', '-'], "").eq_ignore_ascii_case(&b.replace(['_', '-'], ""));
    let called = |class: &vc_graph::Class, name: &str| {
        same(&class.name, name) || class.aliases.iter().any(|alias| same(alias, name))
    };
    let unknown: Vec<&String> = names.iter().filter(|n| !classes.get(n).is_some_and(|c| called(c, n))).collect();
    assert!(names.len() > 200, "{}", names.len());
    assert!(unknown.is_empty(), "{unknown:?}");
}

/// Violations in scenes of others are listed, not refused.
#[test]
fn violations_of_the_scenes_are_of_known_kinds() {
    for graph in vc_testkit::data::SCENES.iter().filter_map(|&n| vc_testkit::data::scene(n)) {
        for violation in graph.validate() {
            let known = matches!(
                violation,
                // Pairs of curtains lie on each other, rugs extend into the next room, and many objects hang on
                // walls or are built into counters.
                Violation::SupportCycle(_)
                    | Violation::RoomApart(..)
                    | Violation::NotASurface(..)
                    | Violation::NotAContainer(..)
            );
            assert!(known, "{violation}");
        }
    }
}

#[test]
fn the_apartment_is_sound_and_large_enough() {
    let home = vc_testkit::data::apartment();
    assert!(home.rooms().len() >= 5);
    let objects = home.nodes().filter(|n| n.kind() == NodeKind::Object).count();
    assert!(objects >= 120, "{objects}");
    assert_eq!(home.validate(), []);
}

/// Objects with the relation `on` are also on their supports by their boxes.
#[test]
fn the_apartment_means_what_it_says() {
    let home = vc_testkit::data::apartment();
    for edge in home.edges().filter(|e| e.relation == Relation::On) {
        let boxes = (home.node(edge.from).unwrap().aabb().unwrap(), home.node(edge.to).unwrap().aabb().unwrap());
        let gap = boxes.0.min.z - boxes.1.max.z;
        assert!(gap.abs() < 0.02, "{} is {gap} m above {}", home.label(edge.from), home.label(edge.to));
        let mut centre = boxes.0.centre();
        centre.z = boxes.1.centre().z;
        assert!(boxes.1.contains(&centre), "{} is beside {}", home.label(edge.from), home.label(edge.to));
    }
}

/// The thesis's format keeps names, states, places and poses.
#[test]
fn the_apartment_round_trips_in_the_thesis_format() {
    let home = vc_testkit::data::apartment();
    let again = thesis::read(&thesis::write(&home), &ClassTable::builtin()).unwrap();
    let edges = |g: &SceneGraph| g.edges().collect::<Vec<_>>();
    assert_eq!(edges(&home), edges(&again));
    for (a, b) in home.nodes().zip(again.nodes()) {
        assert_eq!((a.id(), a.class(), a.states()), (b.id(), b.class(), b.states()));
        let motion = a.pose().unwrap().inverse() * b.pose().unwrap();
        assert!(motion.translation.vector.norm() < 1e-5 && motion.rotation.angle() < 1e-3, "{}", a.label());
    }
}

/// A file with the given bytes in the folder for tests, compressed or not.
fn file(name: &str, bytes: &[u8], packed: bool) -> std::path::PathBuf {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let mut written = bytes.to_vec();
    if packed {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(bytes).unwrap();
        written = encoder.finish().unwrap();
    }
    std::fs::write(&path, written).unwrap();
    path
}

#[test]
fn files_are_read_packed_marked_and_of_any_name() {
    let text = "[WALK] <kitchen> (11)\n";
    let marked = format!("\u{feff}{text}");
    for (name, bytes, packed) in [
        ("plain.txt", text, false),
        ("packed.txt.gz", text, true),
        ("packed.txt", text, true),
        ("plain.txt.gz", text, false),
        ("marked.txt", &marked, false),
        ("marked.txt.gz", &marked, true),
    ] {
        assert_eq!(virtualcity::read_text(file(name, bytes.as_bytes(), packed)).unwrap(), text, "{name}");
    }
    // Two concatenated compressed files read as one.
    let twice =
        [std::fs::read(file("one.gz", b"[WAL", true)).unwrap(), std::fs::read(file("two.gz", b"K]", true)).unwrap()];
    assert_eq!(virtualcity::read_text(file("both.gz", &twice.concat(), false)).unwrap(), "[WALK]");
}

#[test]
fn a_file_that_is_no_scene_is_named() {
    let broken = file("no_scene.json", b"{\"nodes\": 3}", false);
    let told = virtualcity::read_scene(&broken, &ClassTable::builtin()).unwrap_err().to_string();
    assert!(told.starts_with(&format!("{}: ", broken.display())), "{told}");
}

#[test]
fn runs_go_on_after_their_last_whole_result() {
    let at = file("resumable.jsonl", b"", false);
    let open = |recipe: &str| ResumableRun::<Vec<f32>>::open(&at, &recipe);
    let run = open("halves").unwrap();
    assert_eq!(run.add("1", &vec![0.5]).unwrap(), [0.5]);
    run.add("2", &vec![0.5, 1.0]).unwrap();
    drop(run);
    let whole = std::fs::read(&at).unwrap();
    for cut in 1..whole.len() {
        std::fs::write(&at, &whole[..cut]).unwrap();
        let run = open("halves").unwrap();
        let there = ["1", "2"].map(|key| run.get(key).cloned());
        let lines = whole[..cut].iter().filter(|byte| **byte == b'\n').count();
        let expected = [vec![0.5], vec![0.5, 1.0]];
        assert_eq!(there.iter().flatten().count(), lines.saturating_sub(1), "cut off after {cut} bytes");
        for (index, key) in ["1", "2"].into_iter().enumerate().skip(lines.saturating_sub(1)) {
            run.add(key, &expected[index]).unwrap();
        }
        assert!(std::fs::read(&at).unwrap() == whole, "cut off after {cut} bytes");
    }
    let other = open("thirds").unwrap_err().to_string();
    assert!(other.contains("resumable.jsonl: this is of another run"), "{other}");
    let run = open("halves").unwrap();
    run.remove().unwrap();
    assert!(run.remove().unwrap_err().to_string().contains("another run writes to the same folder"));
}

#[test]
fn what_is_no_text_or_too_long_is_refused() {
    let told = |path: &std::path::Path| virtualcity::read_text(path).unwrap_err().to_string();
    let utf16 = file("utf16.json", &[0xff, 0xfe, b'{', 0], false);
    assert_eq!(told(&utf16), format!("{}: this is no text in UTF-8: save it in that encoding", utf16.display()));
    assert!(told(&file("broken.gz", &[0x1f, 0x8b, 8, 0, 1], false)).contains("broken.gz: "));
    assert!(told(std::path::Path::new("no/such/file")).starts_with("no/such/file: "));
    // A few hundred kilobytes that decompress to one byte more than the limit.
    let bomb = file("bomb.gz", b"", false);
    let mut encoder = flate2::write::GzEncoder::new(std::fs::File::create(&bomb).unwrap(), flate2::Compression::fast());
    std::io::copy(&mut std::io::repeat(b' ').take(vc_graph::format::LARGEST as u64 + 1), &mut encoder).unwrap();
    encoder.finish().unwrap();
    assert!(std::fs::metadata(&bomb).unwrap().len() < 3 << 20);
    assert!(told(&bomb).contains("more than 268435456 bytes"), "{}", told(&bomb));
    if std::path::Path::new("/dev/zero").exists() {
        assert!(told(std::path::Path::new("/dev/zero")).contains("more than"));
    }
}

/// A scene read from an odd file is written in a form that can be read again.
#[test]
fn what_is_read_of_odd_files_is_read_again() {
    let Some(folder) = vc_testkit::data::folder() else { return };
    let classes = ClassTable::builtin();
    let listed = |name: &str| std::fs::read_dir(folder.join("cases").join(name)).unwrap().map(|e| e.unwrap().path());
    let mut files: Vec<_> = ["vh", "odd", "bodies"].into_iter().flat_map(listed).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "json"));
    files.push(folder.join("cases/native_sorted.json.gz"));
    let scenes: Vec<_> = files.iter().filter_map(|file| Some((file, scene_of(file, &classes)?))).collect();
    assert!(scenes.len() >= 80, "{}", scenes.len());
    let mut lost = Vec::new();
    for (file, graph) in scenes {
        let own = native::read(&native::write(&graph), &classes).is_ok_and(|again| again == graph);
        let others =
            [virtualhome::read(&virtualhome::write(&graph), &classes), thesis::read(&thesis::write(&graph), &classes)];
        let others = others.map(|other| other.map(|other| other.len() == graph.len()));
        if !own || others != [Ok(true), Ok(true)] {
            lost.push((file, own, others));
        }
    }
    assert!(lost.is_empty(), "{lost:#?}");
}

fn scene_of(file: &std::path::Path, classes: &std::sync::Arc<ClassTable>) -> Option<SceneGraph> {
    read_scene(&virtualcity::read_text(file).ok()?, classes).ok()
}
