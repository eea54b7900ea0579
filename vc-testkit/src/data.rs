//! Location and reading of the shared test data, which is not part of the project, and of the bundled apartment.

use std::io::Read;
use std::path::{Path, PathBuf};

use vc_graph::format::read_scene;
use vc_graph::{ClassTable, SceneGraph};

/// VirtualHome's scenes in the shared data.
pub const SCENES: [u32; 5] = [1, 2, 3, 5, 6];

/// The folder of shared data: `VC_DATA`, or `../shared/data` beside the project. Prints a message if neither
/// exists.
pub fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    let folder = std::env::var_os("VC_DATA").map_or(beside, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    crate::skipped(&format!("no shared data at {}; set VC_DATA to where it is", folder.display()));
    None
}

/// A text file of the shared data, decompressed if its name ends in `.gz`.
pub fn text(path: &str) -> Option<String> {
    Some(read(&folder()?.join(path)))
}

/// A text file, decompressed if its name ends in `.gz`.
pub fn read(path: &Path) -> String {
    let bytes = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    if path.extension().is_none_or(|e| e != "gz") {
        return String::from_utf8(bytes).unwrap();
    }
    let mut text = String::new();
    flate2::read::GzDecoder::new(&bytes[..]).read_to_string(&mut text).unwrap();
    text
}

/// One of VirtualHome's scenes.
pub fn scene(number: u32) -> Option<SceneGraph> {
    let text = text(&format!("virtualhome/scene{number}.json.gz"))?;
    Some(read_scene(&text, &ClassTable::builtin()).unwrap())
}

/// The apartment that comes with the project.
pub fn apartment() -> SceneGraph {
    read_scene(include_str!("../../examples/data/apartment.json"), &ClassTable::builtin()).unwrap()
}
