//! Data sets: pictures and their annotations, in formats that other tools read.

use std::path::{Path, PathBuf};

use vc_render::format::{Coco, CocoPicture};
use vc_render::{Modality, picture};

use super::journal::Journal;
use super::{RecordError, at, save};
use crate::{Environment, Viewpoint, files};

/// The folder of a dataset's pictures.
const FRAMES: &str = "frames";
/// The COCO document.
const DOCUMENT: &str = "annotations.json";
/// The journal of a dataset that is not finished.
const JOURNAL: &str = "annotations.jsonl.part";

/// Pictures of one home or of many with boxes and masks of everything seen in them, as a folder: PNG files in
/// `frames`, and one COCO document for `pycocotools`, `annotations.json`.
///
/// A program that was broken off goes on when it is started again: a picture that is there already is not made
/// again, as long as it is of the same home in the same state, from the same viewpoint, of the same size and in the
/// same light as the one asked for. From the first other one on all are made anew. So the files are in the end
/// those of a run that was not broken off. Assets count by their numbers alone: if the shape of one changes between
/// two runs, begin in another folder.
///
/// ```no_run
/// use virtualcity::{Dataset, Environment, Viewpoint};
///
/// let mut dataset = Dataset::create("out/rooms")?;
/// for seed in 0..10 {
///     let home = Environment::make(&format!("apartment/{seed}"), 1)?;
///     for room in home.graph().rooms() {
///         dataset.add(&home, Viewpoint::Room(*room), 640, 480)?;
///     }
/// }
/// println!("{} pictures: {}", dataset.pictures(), dataset.finish()?.display());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Dataset {
    folder: PathBuf,
    seen: Coco,
    journal: Journal,
}

impl Dataset {
    /// Begins a dataset in a folder, which is made, or goes on with one that is not finished. The files of a finished
    /// one are removed.
    ///
    /// # Errors
    /// [`RecordError::File`] if the folder cannot be made or an old file not be removed.
    pub fn create(folder: impl AsRef<Path>) -> Result<Self, RecordError> {
        let folder = folder.as_ref().to_path_buf();
        let frames = folder.join(FRAMES);
        std::fs::create_dir_all(&frames).map_err(at(&frames))?;
        if !folder.join(JOURNAL).is_file() {
            Self::clear(&folder)?;
        }
        let path = folder.join(JOURNAL);
        let journal = Journal::open(path.clone()).map_err(at(&path))?;
        Ok(Self { folder, seen: Coco::default(), journal })
    }

    /// Removes the files of a dataset, finished or not; a folder without any stays as it is.
    pub(super) fn clear(folder: &Path) -> Result<(), RecordError> {
        [DOCUMENT, JOURNAL].iter().try_for_each(|name| files::remove(&folder.join(name)).map_err(at(folder)))?;
        files::remove_numbered(&folder.join(FRAMES), "png", 0).map_err(at(folder))
    }

    /// Writes a picture of a home as it is, `width` by `height` pixels, and keeps its annotations.
    ///
    /// # Errors
    /// [`RecordError`]; then the dataset is as before.
    pub fn add(&mut self, home: &Environment, view: Viewpoint, width: u32, height: u32) -> Result<(), RecordError> {
        let (version, light) = (env!("CARGO_PKG_VERSION"), home.pictures());
        let of = format!("{version} {} {view:?} {width} {height} {light:?}", home.digest());
        let picture = match self.journal.next(&of, &self.folder) {
            Some(picture) => picture,
            None => self.make(home, (view, width, height), &of)?,
        };
        self.seen.push(picture);
        Ok(())
    }

    /// Makes the next picture, and notes what it is of.
    fn make(
        &mut self,
        home: &Environment,
        wanted: (Viewpoint, u32, u32),
        of: &str,
    ) -> Result<CocoPicture, RecordError> {
        let (view, width, height) = wanted;
        let frame = home.render(view, Modality::Rgb | Modality::Boxes | Modality::Masks, width, height)?;
        let name = format!("{FRAMES}/{:06}.png", self.seen.pictures());
        save(&self.folder.join(&name), &picture::png(&picture::rgb(&frame))?)?;
        let picture = CocoPicture::of(name, &frame, &home.snapshot()?)?;
        self.journal.note(of, &picture).map_err(at(&self.folder.join(JOURNAL)))?;
        Ok(picture)
    }

    /// How many pictures it has.
    pub fn pictures(&self) -> usize {
        self.seen.pictures()
    }

    /// Writes the annotations, and gives the path of their file.
    ///
    /// # Errors
    /// [`RecordError`] if they cannot be encoded or written.
    pub fn finish(self) -> Result<PathBuf, RecordError> {
        let (path, frames) = (self.folder.join(DOCUMENT), self.folder.join(FRAMES));
        // A run that was broken off may have had more of them.
        files::remove_numbered(&frames, "png", self.seen.pictures() as u64).map_err(at(&frames))?;
        save(&path, self.seen.document()?.as_bytes())?;
        self.journal.remove().map_err(at(&self.folder.join(JOURNAL)))?;
        Ok(path)
    }
}
