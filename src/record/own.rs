//! Ownership of files: a list in the folder names those that this program wrote. They alone are removed before
//! another record or data set is written.

use std::collections::BTreeSet;
use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

use super::{Dataset, RecordError, at, save};
use crate::files;

/// The list of the files of a folder.
const LIST: &str = "files.txt";
/// The first line of a list.
const HEAD: &str = "# Files that VirtualCity wrote here. Another run into this folder may remove them, and no others.";
/// The ending of a file that is not whole yet.
const PART: &str = ".part";

/// The files of a folder that this program wrote, as the folder's `files.txt` lists them. A name is listed before its
/// file is written, and only if there was no such file: a file that is not listed belongs to somebody else, and is neither
/// overwritten nor removed.
///
/// ```
/// use virtualcity::OwnFiles;
/// let folder = std::env::temp_dir().join("virtualcity-own-files");
/// # let _ = std::fs::remove_dir_all(&folder);
/// virtualcity::files::write(folder.join("notes.txt"), "mine")?;
/// for _ in 0..2 {
///     let mut own = OwnFiles::begin(&folder, &["index.html"])?;
///     own.write("index.html", b"a page")?;
///     own.settle()?;
/// }
/// assert!(OwnFiles::begin(&folder, &["notes.txt"]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct OwnFiles {
    folder: PathBuf,
    names: BTreeSet<String>,
}

impl OwnFiles {
    /// Begins another run in a folder, which will write files of these names: the files that an earlier one wrote are
    /// removed, unless a data set is among them.
    ///
    /// # Errors
    /// [`RecordError::Foreign`] if one of these names is taken, [`RecordError::OfDataset`], [`RecordError::File`].
    /// Nothing is removed then.
    pub fn begin(folder: impl AsRef<Path>, names: &[&str]) -> Result<Self, RecordError> {
        let mut own = Self::open(folder.as_ref())?;
        Dataset::spare(&own)?;
        own.refuse(names, &[])?;
        own.remove(|_| true)?;
        Ok(own)
    }

    /// Reads the list of a folder; none counts as an empty one.
    pub(super) fn open(folder: &Path) -> Result<Self, RecordError> {
        let mut own = Self { folder: folder.to_path_buf(), names: BTreeSet::new() };
        own.read()?;
        Ok(own)
    }

    /// Reads the list again, to which others may have added names.
    fn read(&mut self) -> Result<(), RecordError> {
        let path = self.folder.join(LIST);
        let text = if path.exists() { files::read_text(&path)? } else { format!("{HEAD}\n") };
        let Some(names) = text.strip_prefix(HEAD) else { return Err(foreign(&path)) };
        // A line without an end was broken off.
        let whole = names.split_inclusive('\n').filter_map(|line| line.strip_suffix('\n'));
        self.names = whole.filter(|name| is_within(name)).map(str::to_owned).collect();
        Ok(())
    }

    /// The folder.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The names that are listed, relative to the folder.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// Whether a file is there that this program wrote.
    pub(super) fn has(&self, name: &str) -> bool {
        self.names.contains(name) && self.folder.join(name).is_file()
    }

    /// Refuses files of others that have one of these names, or a number in one of these folders.
    pub(super) fn refuse(&self, names: &[&str], numbered: &[(&str, &str)]) -> Result<(), RecordError> {
        let mut needed: Vec<String> = names.iter().flat_map(|name| with_part(name)).collect();
        for (within, ending) in numbered {
            let folder = self.folder.join(within);
            let there = numbered_files(&folder, ending).map_err(at(&folder))?;
            let names = there.iter().filter_map(|path| path.file_name()?.to_str());
            needed.extend(names.map(|name| format!("{within}/{name}")));
        }
        needed.sort();
        self.refuse_taken(&needed)
    }

    fn refuse_taken(&self, needed: &[String]) -> Result<(), RecordError> {
        let paths = needed.iter().filter(|name| !self.names.contains(*name)).map(|name| self.folder.join(name));
        // A link that leads nowhere is somebody's as well.
        let taken = paths.into_iter().find(|path| path.symlink_metadata().is_ok());
        taken.map_or(Ok(()), |path| Err(foreign(&path)))
    }

    /// Lists names whose files will be written.
    ///
    /// # Errors
    /// [`RecordError::Foreign`] if somebody else's file has one of these names; [`RecordError::File`].
    pub fn claim<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) -> Result<(), RecordError> {
        let all = names.into_iter().flat_map(with_part);
        let new: Vec<String> = all.filter(|name| !self.names.contains(name)).collect();
        self.refuse_taken(&new)?;
        self.add(&new)?;
        self.names.extend(new);
        Ok(())
    }

    /// Adds lines to the list, which is made if there is none.
    fn add(&self, new: &[String]) -> Result<(), RecordError> {
        if new.is_empty() {
            return Ok(());
        }
        files::create_folder(&self.folder)?;
        let path = self.folder.join(LIST);
        let head = if path.exists() { String::new() } else { format!("{HEAD}\n") };
        let text = format!("{head}{}\n", new.join("\n"));
        let file = OpenOptions::new().create(true).append(true).open(&path);
        file.and_then(|mut file| file.write_all(text.as_bytes())).map_err(at(&path))
    }

    /// Lists a name and writes its file, whole or not at all.
    ///
    /// # Errors
    /// [`RecordError::Foreign`] if somebody else's file has this name; [`RecordError::File`].
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), RecordError> {
        self.claim([name])?;
        save(&self.folder.join(name), bytes)
    }

    /// Removes those of the listed files that are meant.
    pub(super) fn remove(&mut self, is_meant: impl Fn(&str) -> bool) -> Result<(), RecordError> {
        self.read()?;
        for name in self.names.iter().filter(|name| is_meant(name)) {
            let path = self.folder.join(name);
            files::remove(&path).map_err(at(&path))?;
        }
        self.keep(|name| !is_meant(name))
    }

    /// Ends a run whose files are all whole: names of files that were not are listed no more.
    ///
    /// # Errors
    /// [`RecordError::File`] if the list cannot be written.
    pub fn settle(&mut self) -> Result<(), RecordError> {
        self.read()?;
        self.keep(|name| !name.ends_with(PART))
    }

    /// Writes the list anew with some of its names, in alphabetical order; an empty one is removed.
    fn keep(&mut self, is_kept: impl Fn(&str) -> bool) -> Result<(), RecordError> {
        self.names.retain(|name| is_kept(name));
        let path = self.folder.join(LIST);
        if self.names.is_empty() {
            return files::remove(&path).map_err(at(&path));
        }
        let lines: String = self.names.iter().map(|name| format!("{name}\n")).collect();
        save(&path, format!("{HEAD}\n{lines}").as_bytes())
    }
}

/// A name, and that of its file until it is whole.
fn with_part(name: &str) -> Vec<String> {
    let part = (!name.ends_with(PART)).then(|| format!("{name}{PART}"));
    std::iter::once(name.to_owned()).chain(part).collect()
}

/// Whether a name leads to a file within the folder: a list may have been changed by hand.
fn is_within(name: &str) -> bool {
    !name.is_empty() && Path::new(name).components().all(|part| matches!(part, Component::Normal(_)))
}

/// The files of a folder whose names are a number with the given extension: `000.jpg`, `001.jpg` for `jpg`. A folder
/// that does not exist counts as empty.
fn numbered_files(folder: &Path, ending: &str) -> io::Result<Vec<PathBuf>> {
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries?,
    };
    let is_meant = |path: &PathBuf| {
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        !stem.is_empty() && stem.bytes().all(|b| b.is_ascii_digit()) && path.extension().is_some_and(|e| e == ending)
    };
    let paths = entries.map(|entry| Ok(entry?.path()));
    paths.filter(|path: &io::Result<PathBuf>| path.as_ref().map_or(true, &is_meant)).collect()
}

fn foreign(path: &Path) -> RecordError {
    RecordError::Foreign { path: path.display().to_string() }
}
