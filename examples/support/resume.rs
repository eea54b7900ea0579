//! The finished part of a long run, as JSON Lines, so that an interrupted run can be continued.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;
use virtualcity::FileError;

use crate::support::Complaint;

/// Results by key, each written to a file as soon as it exists.
pub(crate) struct Resume<T> {
    path: PathBuf,
    file: Mutex<File>,
    /// Results of the interrupted run.
    pub(crate) there: BTreeMap<String, T>,
}

impl<T: Serialize + DeserializeOwned> Resume<T> {
    /// Opens the file of a run, or creates it. Its first line gives the recipe of the results; an incomplete
    /// last line is cut off.
    ///
    /// # Errors
    /// If the file belongs to another recipe, or cannot be read or written.
    pub(crate) fn open(path: &Path, recipe: &impl Serialize) -> Result<Self, Complaint> {
        let fail = |e: std::io::Error| FileError::unwritten(path, e);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(fail)?;
        }
        let open = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
        let mut file = open.map_err(fail)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(fail)?;
        let recipe = serde_json::to_string(recipe).map_err(Complaint::new)?;
        let (mut there, mut whole) = (BTreeMap::new(), 0);
        for (number, line) in bytes.split_inclusive(|b| *b == b'\n').enumerate() {
            let text = std::str::from_utf8(line).ok().and_then(|text| text.strip_suffix('\n'));
            if number == 0 && text.is_some_and(|text| text != recipe) {
                let path = path.display();
                return Err(Complaint::new(format!(
                    "{path} is of another run that was broken off: choose another --out, or delete that file"
                )));
            }
            if number > 0 {
                let Some((key, value)) = text.and_then(|text| serde_json::from_str(text).ok()) else { break };
                there.insert(key, value);
            }
            whole += text.map_or(0, |text| text.len() + 1);
        }
        file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0))).map_err(fail)?;
        if whole == 0 {
            writeln!(file, "{recipe}").map_err(fail)?;
        }
        Ok(Self { path: path.to_owned(), file: Mutex::new(file), there })
    }

    /// Writes a result, and returns it as it will be read back: numbers may differ in their last digit.
    pub(crate) fn add(&self, key: &str, value: &T) -> Result<T, Complaint> {
        let text = serde_json::to_string(value).map_err(Complaint::new)?;
        let line = format!("[{},{text}]\n", serde_json::to_string(key).map_err(Complaint::new)?);
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(line.as_bytes()).map_err(|e| FileError::unwritten(&self.path, e))?;
        serde_json::from_str(&text).map_err(Complaint::new)
    }

    /// Removes the file once all results are written elsewhere.
    pub(crate) fn remove(&self) -> Result<(), Complaint> {
        std::fs::remove_file(&self.path).map_err(|e| match e.kind() {
            std::io::ErrorKind::NotFound => {
                let path = self.path.display();
                Complaint::new(format!("{path} is gone: another run writes to the same folder; choose another --out"))
            }
            _ => FileError::unwritten(&self.path, e).into(),
        })
    }
}
