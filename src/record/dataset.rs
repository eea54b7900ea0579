//! Data sets: pictures and their annotations, in formats that other tools read.

use std::path::{Path, PathBuf};

use vc_render::format::Coco;
use vc_render::{Modalities, Modality, picture};

use super::{RecordError, save};
use crate::{Environment, Viewpoint};

/// Pictures of one home or of many with boxes and masks of everything seen in them, as a folder: PNG files in
/// `frames`, and one COCO document for `pycocotools`, `annotations.json`.
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
}

impl Dataset {
    /// Begins a dataset in a folder, which is made.
    ///
    /// # Errors
    /// [`RecordError::File`] if the folder cannot be made.
    pub fn create(folder: impl AsRef<Path>) -> Result<Self, RecordError> {
        let folder = folder.as_ref().to_path_buf();
        let frames = folder.join("frames");
        std::fs::create_dir_all(&frames).map_err(|error| RecordError::File { path: frames, error })?;
        Ok(Self { folder, seen: Coco::default() })
    }

    /// Writes a picture of a home as it is, `width` by `height` pixels, and keeps its annotations.
    ///
    /// # Errors
    /// [`RecordError`]; then the dataset is as before.
    pub fn add(&mut self, home: &Environment, view: Viewpoint, width: u32, height: u32) -> Result<(), RecordError> {
        let wanted: Modalities = Modality::Rgb | Modality::Boxes | Modality::Masks;
        let frame = home.render(view, wanted, width, height)?;
        let name = format!("frames/{:06}.png", self.seen.pictures());
        save(&self.folder.join(&name), &picture::png(&picture::rgb(&frame))?)?;
        Ok(self.seen.add(name, &frame, &home.snapshot()?)?)
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
        let path = self.folder.join("annotations.json");
        save(&path, self.seen.document()?.as_bytes())?;
        Ok(path)
    }
}
