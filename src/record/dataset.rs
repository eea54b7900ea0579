//! The dataset: pictures, what is in them, and the scene, in the formats that others read.

use std::path::{Path, PathBuf};

use vc_render::format::Coco;
use vc_render::picture;
use vc_render::{Frame, Modalities, Modality};

use super::{RecordError, save};
use crate::Environment;

/// What is seen in the frames so far, and where these are.
pub(super) struct Dataset {
    folder: PathBuf,
    seen: Coco,
}

impl Dataset {
    pub(super) fn begin(folder: &Path) -> Result<Self, RecordError> {
        let frames = folder.join("frames");
        std::fs::create_dir_all(&frames).map_err(|error| RecordError::File { path: frames, error })?;
        Ok(Self { folder: folder.to_path_buf(), seen: Coco::default() })
    }

    /// What a frame has to hold.
    pub(super) fn wanted() -> Modalities {
        Modality::Rgb | Modality::Boxes | Modality::Masks
    }

    /// Writes a frame as a picture, and keeps what is seen in it.
    pub(super) fn add(&mut self, frame: &Frame) -> Result<(), RecordError> {
        let name = format!("frames/{:06}.png", self.seen.pictures());
        save(&self.folder.join(&name), &picture::png(&picture::rgb(frame))?)?;
        Ok(self.seen.add(name, frame)?)
    }

    /// Writes boxes and masks of all frames, and the scene.
    pub(super) fn end(&self, home: &Environment) -> Result<(), RecordError> {
        save(&self.folder.join("annotations.json"), self.seen.document(&home.snapshot()?)?.as_bytes())?;
        save(&self.folder.join("scene.glb"), &home.gltf()?)
    }
}
