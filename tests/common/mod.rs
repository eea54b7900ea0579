//! Location and reading of the shared test data.

#![allow(dead_code, clippy::unwrap_used, reason = "each test file uses a part, and tests may unwrap")]

use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use vc_graph::format::read_scene;
use vc_graph::{ClassTable, SceneGraph};

/// VirtualHome's scenes in the shared data.
pub(crate) const SCENES: [u32; 5] = [1, 2, 3, 5, 6];

/// The folder of shared data: `VC_DATA`, or `../shared/data` beside the project. Prints a message if neither
/// exists.
pub(crate) fn data() -> Option<PathBuf> {
    // Crates of the workspace that share this file are one folder deeper.
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().skip(1).take(2).map(|at| at.join("shared/data"));
    let beside = beside.clone().find(|at| at.is_dir()).or_else(|| beside.last());
    let folder = std::env::var_os("VC_DATA").map(PathBuf::from).or(beside)?;
    if folder.is_dir() {
        return Some(folder);
    }
    // Written past the test harness, which captures the output of passing tests.
    let told = format!("SKIPPED: no shared data at {}; set VC_DATA to where it is\n", folder.display());
    std::io::stderr().write_all(told.as_bytes()).unwrap();
    None
}

/// A text file of the shared data, decompressed if its name ends in `.gz`.
pub(crate) fn text(path: &str) -> Option<String> {
    let path = data()?.join(path);
    let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    if path.extension().is_none_or(|e| e != "gz") {
        return Some(String::from_utf8(bytes).unwrap());
    }
    let mut text = String::new();
    flate2::read::GzDecoder::new(&bytes[..]).read_to_string(&mut text).unwrap();
    Some(text)
}

/// One of VirtualHome's scenes.
pub(crate) fn scene(number: u32) -> Option<SceneGraph> {
    let text = text(&format!("virtualhome/scene{number}.json.gz"))?;
    Some(read_scene(&text, &ClassTable::builtin()).unwrap())
}

/// The apartment that comes with the project.
pub(crate) fn apartment() -> SceneGraph {
    read_scene(include_str!("../../examples/data/apartment.json"), &ClassTable::builtin()).unwrap()
}
