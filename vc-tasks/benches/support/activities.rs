//! Activities of BEHAVIOR.

use std::path::{Path, PathBuf};

/// The texts of all activities of bddl 3.6.0, in the order of their paths; `None`, with a message,
/// if the package is missing.
pub(crate) fn texts() -> Option<Vec<String>> {
    let Some(folder) = std::env::var_os("VC_BDDL") else {
        eprintln!("SKIPPED: set VC_BDDL to where the PyPI package bddl 3.6.0 is unpacked");
        return None;
    };
    let mut files = Vec::new();
    collect(Path::new(&folder), &mut files);
    files.sort();
    let texts = files.iter().filter_map(|file| std::fs::read_to_string(file).ok());
    Some(texts.filter(|text| text.contains("(:domain omnigibson)")).collect())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if entry.is_dir() {
            collect(&entry, files);
        } else if name.starts_with("problem") && name.ends_with(".bddl") {
            files.push(entry);
        }
    }
}
