//! Ownership of files: those of an earlier record or data set are removed before another one is written, those of
//! other programs are not.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{RecordError, at};
use crate::files;

/// Bytes of a file that are looked at.
const HEAD: u64 = 1 << 20;

/// The first line of a file as JSON.
pub(super) fn first_line(path: &Path) -> Option<Value> {
    let mut line = String::new();
    BufReader::new(File::open(path).ok()?.take(HEAD)).read_line(&mut line).ok()?;
    serde_json::from_str(&line).ok()
}

/// Whether the beginning of a file contains some words.
pub(super) fn begins_with(path: &Path, words: &str) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    read.is_ok() && String::from_utf8_lossy(&head).contains(words)
}

/// Refuses a folder that has one of these files, or pictures numbered in these folders.
pub(super) fn refuse(folder: &Path, names: &[&str], numbered: &[(&str, &str)]) -> Result<(), RecordError> {
    let named = names.iter().map(|name| folder.join(name)).filter(|path| path.exists());
    let mut all: Vec<PathBuf> = named.collect();
    for (name, ending) in numbered {
        let within = folder.join(name);
        all.extend(files::numbered(&within, ending, 0).map_err(at(&within))?);
    }
    all.sort();
    match all.into_iter().next() {
        Some(path) => Err(RecordError::Foreign { path: path.display().to_string() }),
        None => Ok(()),
    }
}
