//! The journal of an unfinished data set: it lists the finished pictures, so that an interrupted run can be
//! resumed.

use std::collections::VecDeque;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use vc_render::format::CocoPicture;

/// A file of JSON Lines: the subject of each picture, and the annotations of what it shows. Each line is
/// written as soon as its picture is.
#[derive(Debug)]
pub(super) struct Journal {
    path: PathBuf,
    file: File,
    /// Pictures of an interrupted run that have not been requested again yet, with the ends of their lines.
    left: VecDeque<((String, CocoPicture), u64)>,
    /// The end of the last valid line.
    end: u64,
}

impl Journal {
    /// Opens the journal of an interrupted run, or begins one. An incomplete last line is ignored.
    pub(super) fn open(path: PathBuf) -> io::Result<Self> {
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes)?;
        let (mut left, mut end) = (VecDeque::new(), 0);
        for line in bytes.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n")) {
            let Ok(picture) = serde_json::from_slice(line) else { break };
            end += line.len() as u64;
            left.push_back((picture, end));
        }
        Ok(Self { path, file, left, end: 0 })
    }

    /// The next picture with its annotations, if the earlier run made it with the same home, view, size and
    /// light and its files are in the folder. From the first picture for which this does not hold, all are
    /// rendered anew.
    pub(super) fn next(&mut self, of: &str, folder: &Path) -> Option<CocoPicture> {
        let is_there = |picture: &CocoPicture| picture.files().all(|name| folder.join(name).is_file());
        let same = |(known, picture): &(String, CocoPicture)| known == of && is_there(picture);
        match self.left.pop_front().filter(|(known, _)| same(known)) {
            Some(((_, picture), end)) => {
                self.end = end;
                Some(picture)
            }
            None => {
                self.left.clear();
                None
            }
        }
    }

    /// Records a picture whose file is written.
    pub(super) fn note(&mut self, of: &str, picture: &CocoPicture) -> io::Result<()> {
        let line = format!("{}\n", serde_json::to_string(&(of, picture))?);
        self.file.set_len(self.end)?;
        self.file.seek(SeekFrom::Start(self.end))?;
        self.file.write_all(line.as_bytes())?;
        self.end += line.len() as u64;
        Ok(())
    }

    /// Removes the journal file once the document is written.
    pub(super) fn remove(self) -> io::Result<()> {
        std::fs::remove_file(&self.path)
    }
}
