//! JSON Lines that are written while a long run goes on: a run that is broken off keeps the lines that it wrote, and
//! can go on from them.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::files::{FileError, FileProblem};

/// A file of JSON Lines that grows line by line. Each line is on the disk before the next one is written.
///
/// ```
/// use virtualcity::JsonLines;
/// let path = std::env::temp_dir().join("virtualcity-json-lines").join("steps.jsonl");
/// let mut lines = JsonLines::create(&path)?;
/// lines.push(&("walk fridge.12", 1.5))?;
/// lines.push(&("open fridge.12", 2.0))?;
/// drop(lines);
/// let (mut lines, there) = JsonLines::resume(&path)?;
/// assert_eq!(there, [r#"["walk fridge.12",1.5]"#, r#"["open fridge.12",2.0]"#]);
/// lines.keep(1)?;
/// assert_eq!(std::fs::read_to_string(&path)?, "[\"walk fridge.12\",1.5]\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct JsonLines {
    path: PathBuf,
    file: File,
    /// The end of each line, bytes.
    ends: Vec<u64>,
}

impl JsonLines {
    /// Creates the file, and its folder. An existing file is emptied.
    ///
    /// # Errors
    /// [`FileError`] with the system's error and advice.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let (mut lines, _) = Self::resume(path)?;
        lines.keep(0)?;
        Ok(lines)
    }

    /// Opens the file of a run that was broken off, or creates it, and gives the lines that are there, without their
    /// ends. An incomplete last line is cut off.
    ///
    /// # Errors
    /// [`FileError`] with the system's error and advice.
    pub fn resume(path: impl AsRef<Path>) -> Result<(Self, Vec<String>), FileError> {
        let path = path.as_ref();
        let (file, bytes) = open(path).map_err(|error| FileError::unwritten(path, error))?;
        let text = |line: &[u8]| String::from_utf8(line.strip_suffix(b"\n")?.to_vec()).ok();
        let there: Vec<String> = bytes.split_inclusive(|byte| *byte == b'\n').map_while(text).collect();
        let mut lines = Self { path: path.to_owned(), file, ends: Vec::new() };
        there.iter().for_each(|line| lines.ends.push(lines.end() + line.len() as u64 + 1));
        lines.keep(there.len())?;
        Ok((lines, there))
    }

    /// Cuts the file off after its first lines, as many as `count` says.
    ///
    /// # Errors
    /// [`FileError`] with the system's error and advice.
    pub fn keep(&mut self, count: usize) -> Result<(), FileError> {
        self.ends.truncate(count);
        let end = self.end();
        let cut = self.file.set_len(end).and_then(|()| self.file.seek(SeekFrom::Start(end)));
        cut.map(drop).map_err(|error| FileError::unwritten(&self.path, error))
    }

    /// Appends a value as one line.
    ///
    /// # Errors
    /// [`FileError`] if the value is not JSON or the line cannot be written.
    pub fn push(&mut self, value: &impl Serialize) -> Result<(), FileError> {
        let text = json(value).map_err(|error| FileError::unwritten(&self.path, error))?;
        let written = self.file.write_all(format!("{text}\n").as_bytes());
        if let Err(error) = written {
            // A part of the line may have been written; the disk may take no more.
            let _ = self.keep(self.ends.len());
            return Err(FileError::unwritten(&self.path, error));
        }
        self.ends.push(self.end() + text.len() as u64 + 1);
        Ok(())
    }

    /// Removes the file, once its content is written elsewhere.
    ///
    /// # Errors
    /// [`FileError`], also if the file is gone: then another run uses the same folder.
    pub fn remove(&self) -> Result<(), FileError> {
        std::fs::remove_file(&self.path).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => FileError::new(&self.path, FileProblem::Gone),
            _ => FileError::unwritten(&self.path, error),
        })
    }

    /// The end of the last line, bytes.
    fn end(&self) -> u64 {
        self.ends.last().copied().unwrap_or(0)
    }
}

/// Opens a file for reading and writing, and reads it.
fn open(path: &Path) -> io::Result<(File, Vec<u8>)> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok((file, bytes))
}

fn json(value: &impl Serialize) -> io::Result<String> {
    Ok(serde_json::to_string(value)?)
}

/// The results of a long run that can be broken off and started again: each is written to a file of JSON Lines as soon
/// as it exists, under a key. Threads may share it.
///
/// ```
/// use virtualcity::ResumableRun;
/// let path = std::env::temp_dir().join("virtualcity-run").join("unfinished.jsonl");
/// let recipe = ("squares", 1);
/// for attempt in 0..2 {
///     let run = ResumableRun::<u64>::open(&path, &recipe)?;
///     assert_eq!(run.get("7"), (attempt == 1).then_some(&49));
///     let square = match run.get("7") {
///         Some(known) => *known,
///         None => run.add("7", &(7 * 7))?,
///     };
///     assert_eq!(square, 49);
/// }
/// // Results of another recipe do not get mixed in.
/// assert!(ResumableRun::<u64>::open(&path, &("cubes", 1)).is_err());
/// ResumableRun::<u64>::open(&path, &recipe)?.remove()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ResumableRun<T> {
    path: PathBuf,
    lines: Mutex<JsonLines>,
    there: BTreeMap<String, T>,
}

impl<T: Serialize + DeserializeOwned> ResumableRun<T> {
    /// Opens the file of a run, or creates it. Its first line is the recipe: everything on which the results depend.
    /// An incomplete last line is cut off.
    ///
    /// # Errors
    /// [`FileProblem::OtherRun`] if the file has another recipe; [`FileError`] if it cannot be read or written.
    pub fn open(path: impl AsRef<Path>, recipe: &impl Serialize) -> Result<Self, FileError> {
        let path = path.as_ref();
        let (mut lines, texts) = JsonLines::resume(path)?;
        let own = json(recipe).map_err(|error| FileError::unwritten(path, error))?;
        match texts.first() {
            Some(first) if *first != own => return Err(FileError::new(path, FileProblem::OtherRun)),
            Some(_) => {}
            None => lines.push(recipe)?,
        }
        let results = texts.iter().skip(1).map_while(|text| serde_json::from_str::<(String, T)>(text).ok());
        let results: Vec<(String, T)> = results.collect();
        lines.keep(1 + results.len())?;
        Ok(Self { path: path.to_owned(), lines: Mutex::new(lines), there: results.into_iter().collect() })
    }

    /// A result of the run that was broken off.
    pub fn get(&self, key: &str) -> Option<&T> {
        self.there.get(key)
    }

    /// Writes a result, and returns it as it will be read back: numbers may differ in their last digit.
    ///
    /// # Errors
    /// [`FileError`] if it cannot be written or would not be read back.
    pub fn add(&self, key: &str, value: &T) -> Result<T, FileError> {
        self.lines.lock().unwrap_or_else(PoisonError::into_inner).push(&(key, value))?;
        let read_back = json(value).and_then(|text| Ok(serde_json::from_str(&text)?));
        read_back.map_err(|error| FileError::unwritten(&self.path, error))
    }

    /// Removes the file once all results are written elsewhere.
    ///
    /// # Errors
    /// [`FileProblem::Gone`] if another run has removed it; [`FileError`] if it cannot be removed.
    pub fn remove(&self) -> Result<(), FileError> {
        self.lines.lock().unwrap_or_else(PoisonError::into_inner).remove()
    }
}
