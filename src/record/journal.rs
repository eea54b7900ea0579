//! The journal of an unfinished data set: it lists the finished pictures, so that an interrupted run can be
//! resumed.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use vc_render::format::CocoPicture;

use crate::{FileError, JsonLines};

/// The subject of each picture, and the annotations of what it shows. Each line is written as soon as its picture is.
#[derive(Debug)]
pub(super) struct Journal {
    lines: JsonLines,
    /// Pictures of an interrupted run that have not been requested again yet.
    left: VecDeque<(String, CocoPicture)>,
    /// Number of pictures that were requested so far.
    taken: usize,
}

impl Journal {
    /// Opens the journal of an interrupted run, or begins one. An incomplete last line is ignored.
    pub(super) fn open(path: PathBuf) -> Result<Self, FileError> {
        let (lines, texts) = JsonLines::resume(path)?;
        let left = texts.iter().map_while(|text| serde_json::from_str(text).ok()).collect();
        Ok(Self { lines, left, taken: 0 })
    }

    /// The next picture with its annotations, if the earlier run made it with the same home, view, size and
    /// light and its files are in the folder. From the first picture for which this does not hold, all are
    /// rendered anew.
    pub(super) fn next(&mut self, of: &str, folder: &Path) -> Option<CocoPicture> {
        let is_there = |picture: &CocoPicture| picture.files().all(|name| folder.join(name).is_file());
        let same = |(known, picture): &(String, CocoPicture)| known == of && is_there(picture);
        let Some((_, picture)) = self.left.pop_front().filter(same) else {
            self.left.clear();
            return None;
        };
        self.taken += 1;
        Some(picture)
    }

    /// Records a picture whose file is written.
    pub(super) fn note(&mut self, of: &str, picture: &CocoPicture) -> Result<(), FileError> {
        self.lines.keep(self.taken)?;
        self.lines.push(&(of, picture))?;
        self.taken += 1;
        Ok(())
    }

    /// Removes the journal file once the document is written.
    pub(super) fn remove(self) -> Result<(), FileError> {
        self.lines.remove()
    }
}
