//! Records of episodes: the contents of the folder, and its reproducibility.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod resume;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::Value;
use virtualcity::graph::{Action, NodeId, Verb};
use virtualcity::planner::{Episode, PlannerPolicy, run_episode};
use virtualcity::render::Daylight;
use virtualcity::tasks::{Outcome, Task, World};
use virtualcity::{Environment, OwnFiles, PictureOptions, RecordError, RecordOptions, Recorder};

use super::{fresh, home};

const SMALL: RecordOptions = RecordOptions { width: 64, dataset: true, finer: 2, daylight: None };

/// A folder for this test only.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

/// An agent in a home is given the goal of holding a novel.
fn record(folder: &Path, home: Environment) -> (Episode, Environment) {
    let me = home.agents()[0];
    let task = Task::new("fetch <a novel>", "Holds(novel)".parse().unwrap());
    let mut recorder = Recorder::create(folder, home, me, &task, SMALL).unwrap();
    let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut recorder);
    let home = recorder.environment().clone();
    assert!(recorder.metres() > 0.5 && recorder.seconds() > 0.5, "{episode:?}");
    assert_eq!(recorder.finish(&episode, Some("<svg/>")).unwrap(), folder.join("index.html"));
    (episode, home)
}

/// Every file under a folder.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            let own = PathBuf::from(path.file_name().unwrap());
            found.extend(files(&path).into_iter().map(|(name, bytes)| (own.join(name), bytes)));
        } else {
            found.insert(path.file_name().unwrap().into(), std::fs::read(&path).unwrap());
        }
    }
    found
}

/// The first view is shown where nothing has to be done.
#[test]
fn an_episode_without_actions_shows_the_home() {
    let at = folder("nothing");
    let home = home(42, 1);
    let me = home.agents()[0];
    let task = Task::new("nothing", "InRoom(me, living_room)".parse().unwrap());
    let mut recorder = Recorder::create(&at, home, me, &task, RecordOptions { dataset: false, ..SMALL }).unwrap();
    let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut recorder);
    assert_eq!(episode.outcome, Outcome::Won);
    assert_eq!(episode.steps, 0);
    recorder.finish(&episode, None).unwrap();
    let bytes = std::fs::read(at.join("strip.png")).unwrap();
    let image = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    assert!(image.info().width > 2 * SMALL.width, "two views beside each other");
}

#[test]
fn an_episode_is_written_down_and_read_again() {
    let at = folder("record");
    // Remains of a longer record, and a file of the user's.
    virtualcity::files::write(at.join("film/notes.txt"), b"before").unwrap();
    let mut longer = OwnFiles::begin(&at, &[]).unwrap();
    for name in ["film/900.jpg", "frames/000900.png", "trajectory.jsonl", "annotations.json"] {
        longer.write(name, b"before").unwrap();
    }
    longer.settle().unwrap();
    let (episode, home) = record(&at, home(42, 1));
    assert_eq!(episode.outcome, Outcome::Won);
    let all = files(&at);
    let lines: Vec<Value> = std::str::from_utf8(&all[Path::new("trajectory.jsonl")])
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines.len(), episode.steps + 2, "one about the run, one for each action, one about the end");
    assert_eq!(lines[0]["task"], "fetch <a novel>");
    let last = &lines[episode.steps];
    assert_eq!(last["digest"], home.digest().to_string());
    assert!(last["held"][0].as_str().unwrap().starts_with("novel"), "{last}");
    assert_eq!(lines[episode.steps + 1]["outcome"], "won");
    // Pictures can be decoded, and the page refers only to existing files.
    for (name, bytes) in all.iter().filter(|(name, _)| name.extension().is_some_and(|e| e == "png")) {
        let mut image = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; image.output_buffer_size().unwrap()];
        image.next_frame(&mut pixels).unwrap_or_else(|e| panic!("{}: {e}", name.display()));
    }
    let page = std::str::from_utf8(&all[Path::new("index.html")]).unwrap();
    assert!(page.contains("fetch &lt;a novel&gt;") && page.contains("100% of the goal holds"), "{page}");
    assert_eq!(all.get(Path::new("film/notes.txt")).map(Vec::as_slice), Some(&b"before"[..]));
    let film: Vec<&Path> = all
        .keys()
        .filter(|name| name.starts_with("film") && name.extension().is_some_and(|e| e == "jpg"))
        .map(PathBuf::as_path)
        .collect();
    assert!(film.len() > 5 && film.iter().all(|name| all[*name].starts_with(&[0xff, 0xd8])), "{film:?}");
    assert!(film.iter().all(|name| page.contains(name.to_str().unwrap())), "the page plays all of it");
    assert!(!all.keys().any(|name| name.extension().is_some_and(|e| e == "part")), "nothing half written is left");
    for shown in page.split("src=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
        assert!(all.contains_key(Path::new(shown)), "{shown}");
    }
    // The data set: each image of the annotations exists, each annotation belongs to one of them.
    let coco: Value = serde_json::from_slice(&all[Path::new("annotations.json")]).unwrap();
    let images = coco["images"].as_array().unwrap();
    assert!(!images.is_empty() && !coco["annotations"].as_array().unwrap().is_empty());
    assert!(images.iter().all(|image| all.contains_key(Path::new(image["file_name"].as_str().unwrap()))));
    assert_eq!(&all[Path::new("scene.glb")][..4], b"glTF");
    // The list names what the record wrote, and nothing else.
    let listed = std::str::from_utf8(&all[Path::new("files.txt")]).unwrap();
    let listed: BTreeSet<&Path> = listed.lines().skip(1).map(Path::new).collect();
    let others = ["film/notes.txt", "files.txt"].map(Path::new);
    let written: BTreeSet<&Path> = all.keys().map(PathBuf::as_path).filter(|name| !others.contains(name)).collect();
    assert_eq!(listed, written);
}

/// Files of other programs stay, whether a record or a data set would have one of that name.
#[test]
fn files_of_others_are_not_removed() {
    let home = home(42, 1);
    let me = home.agents()[0];
    let task = Task::new("nothing", "InRoom(me, living_room)".parse().unwrap());
    for name in ["index.html", "film/000.jpg", "trajectory.jsonl", "annotations.json", "frames/000000.png"] {
        let at = folder("others");
        virtualcity::files::write(at.join(name), b"{}").unwrap();
        let record = Recorder::create(&at, home.clone(), me, &task, SMALL).err().map(|e| e.to_string());
        let dataset = virtualcity::Dataset::create(&at).err().map(|e| e.to_string());
        assert!(record.is_some_and(|why| why.contains(name) && why.contains("choose another folder")), "{name}");
        let is_of_dataset = name.starts_with("frames") || name.starts_with("annotations");
        assert_eq!(dataset.is_some_and(|why| why.contains(name)), is_of_dataset, "{name}");
        assert_eq!(std::fs::read(at.join(name)).unwrap(), b"{}");
    }
}

/// In the folder of an earlier run as in a fresh one.
#[test]
fn files_of_others_stay_beside_those_of_an_earlier_run() {
    let home = home(42, 1);
    let me = home.agents()[0];
    let task = Task::new("nothing", "InRoom(me, living_room)".parse().unwrap());
    let at = folder("others_later");
    let mut own = OwnFiles::begin(&at, &[]).unwrap();
    own.write("index.html", b"earlier").unwrap();
    own.settle().unwrap();
    let record = |dataset| {
        let options = RecordOptions { dataset, ..SMALL };
        Recorder::create(&at, home.clone(), me, &task, options).map(drop).map_err(|e| e.to_string())
    };
    for name in ["film/500.jpg", "film/012345.jpg", "frames/999999.png", "index.html.part"] {
        virtualcity::files::write(at.join(name), b"mine").unwrap();
        let refused = record(true).unwrap_err();
        assert!(refused.contains(name) && refused.contains("is in the way"), "{refused}");
        assert_eq!(std::fs::read(at.join(name)).unwrap(), b"mine");
        assert_eq!(std::fs::read(at.join("index.html")).unwrap(), b"earlier");
        std::fs::remove_file(at.join(name)).unwrap();
    }
    // A run without a data set does not remove one.
    own.write("annotations.json", b"boxes").unwrap();
    assert!(record(false).unwrap_err().contains("annotations.json is of a data set"));
    assert!(matches!(OwnFiles::begin(&at, &[]), Err(RecordError::OfDataset { .. })));
    assert!(at.join("index.html").exists() && at.join("annotations.json").exists());
    // Names that lead out of the folder are not believed, whoever wrote them into the list.
    let outside = at.with_extension("txt");
    std::fs::write(&outside, "mine").unwrap();
    let listed = std::fs::read_to_string(at.join("files.txt")).unwrap();
    let leading_out = format!("{listed}../others_later.txt\n{}\n", outside.display());
    std::fs::write(at.join("files.txt"), leading_out).unwrap();
    record(true).unwrap();
    assert!(outside.exists() && !at.join("index.html").exists());
    // A list of somebody else is none.
    std::fs::write(at.join("files.txt"), "index.html\n").unwrap();
    assert!(record(true).unwrap_err().contains("files.txt is in the way"));
}

/// Independent of the length of an episode and of its film, a data set has six pictures per second.
#[test]
fn datasets_go_on_as_they_began() {
    let home = home(42, 1);
    let me = home.agents()[0];
    let task = Task::new("to and fro", "Holds(novel)".parse().unwrap());
    let rooms = home.graph().rooms().to_vec();
    let options = RecordOptions { width: 16, dataset: true, ..RecordOptions::default() };
    let at = folder("record_long");
    let mut recorder = Recorder::create(&at, home, me, &task, options).unwrap();
    let mut actions = 0.0;
    for room in rooms.into_iter().cycle() {
        recorder.step(me, &Action::one(Verb::Walk, room)).unwrap();
        actions += 1.0;
        // The film has become sparser.
        if recorder.seconds() > 32.0 {
            break;
        }
    }
    let seconds = recorder.seconds();
    let digest = recorder.environment().graph().digest();
    let episode = Episode { outcome: Outcome::TimedOut, score: 0.0, steps: 0, reason: None, digest };
    recorder.finish(&episode, None).unwrap();
    let frames = files(&at).keys().filter(|name| name.starts_with("frames")).count();
    // The last look at an action may come earlier.
    assert!((0.0..=actions + 1.0).contains(&(frames as f64 - 6.0 * seconds)), "{frames} frames of {seconds} s");
}

#[test]
fn the_same_run_writes_the_same_files() {
    let (first, second) = (folder("record_first"), folder("record_second"));
    record(&first, home(42, 1));
    record(&second, fresh(42, 1));
    assert!(files(&first) == files(&second));
}

/// The daylight and supersampling of a record are the given ones, or the environment's.
#[test]
fn records_are_made_in_the_light_that_is_asked_for() {
    let mut home = home(42, 1);
    let (me, evening) = (home.agents()[0], Daylight::at(19.0));
    home.set_pictures(PictureOptions { daylight: evening, ..PictureOptions::default() });
    let task = Task::new("nothing", "Holds(novel)".parse().unwrap());
    let recorded = |options: RecordOptions| {
        let recorder = Recorder::create(folder("record_light"), home.clone(), me, &task, options).unwrap();
        *recorder.environment().pictures()
    };
    let told = recorded(RecordOptions { finer: 3, daylight: Some(Daylight::night()), ..SMALL });
    assert_eq!((told.finer, told.daylight), (3, Daylight::night()));
    assert_eq!((recorded(SMALL).finer, recorded(SMALL).daylight), (2, evening));
}

#[test]
fn what_cannot_be_written_is_named() {
    let home = home(42, 1);
    let task = Task::new("nothing", "Holds(novel)".parse().unwrap());
    let me = home.agents()[0];
    let nobody = Recorder::create(folder("record_nobody"), home.clone(), NodeId(u32::MAX), &task, SMALL);
    assert!(matches!(nobody, Err(RecordError::NoSuchAgent { there, .. }) if there.iter().map(|l| l.id).eq([me])));
    let in_the_way = folder("record_file");
    std::fs::write(&in_the_way, "a file").unwrap();
    let refused = Recorder::create(in_the_way.join("episode"), home, me, &task, SMALL).err().unwrap();
    assert!(refused.to_string().contains("record_file"), "{refused}");
}
