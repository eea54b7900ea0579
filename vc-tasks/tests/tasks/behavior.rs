//! The activities of BEHAVIOR.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::path::{Path, PathBuf};

/// The activities of BEHAVIOR under the folder `VC_BDDL`, sorted by file name; the folder holds the
/// unpacked packages bddl 3.6.0 and 1.0.1.
pub(crate) fn activities() -> Vec<(String, String)> {
    let Some(folder) = std::env::var_os("VC_BDDL") else {
        vc_testkit::skipped("set VC_BDDL to where the PyPI packages bddl 3.6.0 and 1.0.1 are unpacked");
        return Vec::new();
    };
    let mut files = Vec::new();
    collect(Path::new(&folder), &mut files);
    files.sort();
    assert!(!files.is_empty(), "no problem*.bddl under VC_BDDL");
    let read = |file: PathBuf| (file.display().to_string(), std::fs::read_to_string(&file).unwrap());
    files.into_iter().map(read).collect()
}

/// The activities of bddl 3.6.0.
pub(crate) fn activities_of_behavior_1k() -> Vec<(String, String)> {
    let all = activities().into_iter();
    all.filter(|(_, text)| text.contains("(:domain omnigibson)")).collect()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if entry.is_dir() {
            collect(&entry, files);
        } else if name.starts_with("problem") && name.ends_with(".bddl") {
            files.push(entry);
        }
    }
}
