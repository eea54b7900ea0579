//! The dataset: pictures, what is in them, and the scene, in the formats that others read.

use std::path::{Path, PathBuf};

use vc_render::format::coco;
use vc_render::picture;
use vc_render::{Frame, Modalities, Modality};

use super::{RecordError, save};
use crate::Environment;

/// Frames so far, and where they are.
pub(super) struct Dataset {
    folder: PathBuf,
    frames: Vec<(String, Frame)>,
}

impl Dataset {
    pub(super) fn begin(folder: &Path) -> Result<Self, RecordError> {
        let frames = folder.join("frames");
        std::fs::create_dir_all(&frames).map_err(|error| RecordError::File { path: frames, error })?;
        Ok(Self { folder: folder.to_path_buf(), frames: Vec::new() })
    }

    /// What a frame has to hold.
    pub(super) fn wanted() -> Modalities {
        Modality::Rgb | Modality::Boxes | Modality::Masks
    }

    /// Writes a frame as a picture, and keeps what is seen in it.
    pub(super) fn add(&mut self, frame: Frame) -> Result<(), RecordError> {
        let name = format!("frames/{:06}.png", self.frames.len());
        save(&self.folder.join(&name), &picture::png(&picture::rgb(&frame))?)?;
        self.frames.push((name, frame));
        Ok(())
    }

    /// Writes boxes and masks of all frames, and the scene.
    pub(super) fn end(&self, home: &Environment) -> Result<(), RecordError> {
        let named: Vec<(&str, &Frame)> = self.frames.iter().map(|(name, frame)| (&**name, frame)).collect();
        save(&self.folder.join("annotations.json"), coco(&named, &home.snapshot()?)?.as_bytes())?;
        save(&self.folder.join("scene.glb"), &home.gltf()?)
    }
}
