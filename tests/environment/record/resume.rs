//! Interrupted and resumed data sets have the same bytes as uninterrupted ones.

use std::path::Path;

use virtualcity::graph::{Action, Verb};
use virtualcity::planner::Episode;
use virtualcity::tasks::{Outcome, Task, World};
use virtualcity::{Dataset, Environment, RecordError, RecordOptions, Recorder, Viewpoint};

use super::{files, folder, home};

const JOURNAL: &str = "annotations.jsonl.part";

fn homes() -> Vec<Environment> {
    [42, 7].map(|seed| home(seed, 1)).to_vec()
}

/// Pictures of each home, one from each room, up to a number.
fn take(at: &Path, homes: &[Environment], most: usize) -> Result<Dataset, RecordError> {
    let mut dataset = Dataset::create(at)?;
    let rooms = homes.iter().flat_map(|home| home.graph().rooms().iter().take(3).map(move |room| (home, *room)));
    for (home, room) in rooms.take(most) {
        dataset.add(home, Viewpoint::Room(room), 32, 24)?;
    }
    Ok(dataset)
}

fn mark(at: &Path, name: &str) {
    virtualcity::files::write(at.join(name), b"mark").unwrap();
}

#[test]
fn datasets_of_many_homes_go_on_where_they_were_broken_off() {
    let homes = homes();
    let whole = folder("dataset_whole");
    take(&whole, &homes, 6).unwrap().finish().unwrap();
    let whole = files(&whole);
    assert_eq!(whole.len(), 8, "six pictures, a document and a list: {:?}", whole.keys());
    // Interrupted after the fifth picture, while a line and a file are being written.
    let at = folder("dataset_broken");
    drop(take(&at, &homes, 5).unwrap());
    let journal = std::fs::read(at.join(JOURNAL)).unwrap();
    std::fs::write(at.join(JOURNAL), &journal[..journal.len() - 7]).unwrap();
    mark(&at, "frames/000004.png.part");
    assert!(!at.join("annotations.json").exists());
    take(&at, &homes, 6).unwrap().finish().unwrap();
    assert!(files(&at) == whole);
    // Existing pictures are not made again; if one is missing, it and all later ones are.
    drop(take(&at, &homes, 6).unwrap());
    mark(&at, "frames/000001.png");
    mark(&at, "frames/000004.png");
    std::fs::remove_file(at.join("frames/000003.png")).unwrap();
    take(&at, &homes, 6).unwrap().finish().unwrap();
    let mut marked = files(&at);
    assert_eq!(
        marked.insert("frames/000001.png".into(), whole[Path::new("frames/000001.png")].clone()).unwrap(),
        b"mark"
    );
    assert!(marked == whole);
}

#[test]
fn pictures_of_something_else_are_made_anew() {
    let mut homes = homes();
    let (at, other) = (folder("dataset_other"), folder("dataset_anew"));
    drop(take(&at, &homes, 5).unwrap());
    homes.reverse();
    take(&at, &homes, 2).unwrap().finish().unwrap();
    take(&other, &homes, 2).unwrap().finish().unwrap();
    assert!(files(&at) == files(&other), "nothing of the run that was broken off is left");
}

/// Lets an agent walk through some rooms, and returns the record of it.
fn walk(at: &Path, rooms: usize) -> Recorder {
    let home = home(42, 1);
    let (me, all) = (home.agents()[0], home.graph().rooms().to_vec());
    let options = RecordOptions { width: 32, dataset: true, ..RecordOptions::default() };
    let task = Task::new("to and fro", "Holds(novel)".parse().unwrap());
    let mut recorder = Recorder::create(at, home, me, &task, options).unwrap();
    for room in all.into_iter().cycle().take(rooms) {
        recorder.step(me, &Action::one(Verb::Walk, room)).unwrap();
    }
    recorder
}

fn finish(recorder: Recorder) {
    let digest = recorder.environment().graph().digest();
    let episode = Episode { outcome: Outcome::TimedOut, score: 0.0, steps: 3, reason: None, digest };
    recorder.finish(&episode, None).unwrap();
}

#[test]
fn records_go_on_where_they_were_broken_off() {
    let (whole, at) = (folder("record_whole"), folder("record_broken"));
    finish(walk(&whole, 3));
    finish(walk(&at, 1));
    drop(walk(&at, 2));
    let begun = files(&at);
    let is_begun = |name: &Path| {
        let is_part = name.extension().is_some_and(|e| e == "part");
        name.starts_with("frames") || ["files.txt", "begin.save"].iter().any(|kept| name == Path::new(kept)) || is_part
    };
    assert!(begun.keys().all(|name| is_begun(name)), "{:?}", begun.keys());
    assert!(begun.len() > 5, "{:?}", begun.keys());
    // An existing picture is kept unchanged.
    mark(&at, "frames/000000.png");
    finish(walk(&at, 3));
    let (mut all, whole) = (files(&at), files(&whole));
    let first = whole[Path::new("frames/000000.png")].clone();
    assert_eq!(all.insert("frames/000000.png".into(), first).unwrap(), b"mark");
    assert!(all == whole);
}

/// Arrays of other modalities lie beside the pictures, and the document names them.
#[test]
fn datasets_have_arrays_on_wish() {
    use virtualcity::render::Modality;
    let home = home(42, 1);
    let at = folder("dataset_arrays");
    let room = home.graph().rooms()[0];
    let take = |wanted: bool| {
        let mut dataset = Dataset::create(&at).unwrap();
        if wanted {
            dataset = dataset.with(Modality::Depth | Modality::Instance);
        }
        dataset.add(&home, Viewpoint::Room(room), 32, 24).unwrap();
        let document = std::fs::read_to_string(dataset.finish().unwrap()).unwrap();
        let document: serde_json::Value = serde_json::from_str(&document).unwrap();
        document["images"][0]["files"].clone()
    };
    let named = take(true);
    assert_eq!(named, serde_json::json!({"depth": "depth/000000.npy", "instance": "instance/000000.npy"}));
    let frame = home.render(Viewpoint::Room(room), Modality::Depth | Modality::Instance, 32, 24).unwrap();
    let depth = virtualcity::render::format::npy(&frame.depth, &[24, 32]).unwrap();
    let instance = virtualcity::render::format::npy(&frame.instance, &[24, 32]).unwrap();
    let all = files(&at);
    assert_eq!(all.len(), 5, "{:?}", all.keys());
    assert!(all[Path::new("depth/000000.npy")] == depth && all[Path::new("instance/000000.npy")] == instance);
    // They are removed with the pictures of the data set.
    assert!(take(false).is_null());
    assert_eq!(files(&at).len(), 3, "a picture, a document and a list: {:?}", files(&at).keys());
}
