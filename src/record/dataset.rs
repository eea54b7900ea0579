//! Data sets: pictures and their annotations, in formats that other tools read.

use std::path::{Path, PathBuf};

use vc_render::format::{Coco, CocoPicture, npy};
use vc_render::{Frame, Modalities, Modality, RenderError, picture};

use super::journal::Journal;
use super::{OwnFiles, RecordError, at, save};
use crate::{Environment, Viewpoint};

/// The folder of a data set's pictures.
const FRAMES: &str = "frames";
/// The modalities that can be written as arrays, and their folders.
const ARRAYS: [(Modality, &str); 4] = [
    (Modality::Depth, "depth"),
    (Modality::Distance, "distance"),
    (Modality::Instance, "instance"),
    (Modality::Class, "class"),
];
/// The COCO document.
const DOCUMENT: &str = "annotations.json";
/// The journal of an unfinished data set.
const JOURNAL: &str = "annotations.jsonl.part";

/// Pictures of one or many homes with the bounding boxes and masks of everything visible in them, as a folder:
/// PNG files in `frames`, one COCO document for `pycocotools`, `annotations.json`, and a list of all that was written,
/// `files.txt` ([`OwnFiles`]).
///
/// An interrupted program resumes when it is started again: an existing picture is not rendered again if it
/// shows the same home in the same state, from the same viewpoint, in the same size and the same light as
/// requested. From the first picture that differs, all are rendered anew. The final files are therefore those
/// of an uninterrupted run. Assets are compared by their numbers alone: if the shape of one changes between two
/// runs, begin in another folder.
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
    own: OwnFiles,
    seen: Coco,
    journal: Journal,
    arrays: Modalities,
}

impl Dataset {
    /// Begins a data set in a folder, which is created, or resumes an unfinished one. The files of a finished
    /// data set are removed.
    ///
    /// # Errors
    /// [`RecordError::Foreign`] if the folder has files of a data set's names that no data set of this program wrote;
    /// [`RecordError::File`] if the folder cannot be created or an old file cannot be removed.
    pub fn create(folder: impl AsRef<Path>) -> Result<Self, RecordError> {
        let folder = folder.as_ref();
        let mut own = OwnFiles::open(folder)?;
        Self::check(&own)?;
        let frames = folder.join(FRAMES);
        std::fs::create_dir_all(&frames).map_err(at(&frames))?;
        if !own.has(JOURNAL) {
            own.remove(Self::is_of_one)?;
        }
        own.claim([JOURNAL, DOCUMENT])?;
        let journal = Journal::open(folder.join(JOURNAL))?;
        Ok(Self { own, seen: Coco::default(), journal, arrays: Modalities::NONE })
    }

    /// Also writes these modalities of each picture: depth, distance, instance and class, as NumPy arrays beside the
    /// pictures, `depth/000000.npy`. The document names them in `files` of its `images`. Depth and distance are in
    /// metres, infinite where nothing is; instances are numbers of nodes, classes those of the class table. Other
    /// modalities are not written.
    ///
    /// ```no_run
    /// use virtualcity::render::Modality;
    /// let dataset = virtualcity::Dataset::create("out/rooms")?.with(Modality::Depth | Modality::Instance);
    /// # Ok::<(), virtualcity::RecordError>(())
    /// ```
    #[must_use]
    pub fn with(self, modalities: impl Into<Modalities>) -> Self {
        Self { arrays: modalities.into(), ..self }
    }

    /// Whether a file of this name is of a data set.
    pub(super) fn is_of_one(name: &str) -> bool {
        // The journal's name begins as the document's does.
        name.starts_with(DOCUMENT) || number(name).is_some()
    }

    /// Refuses a folder with files of a data set's names that are of no data set.
    pub(super) fn check(own: &OwnFiles) -> Result<(), RecordError> {
        own.refuse(&[DOCUMENT, JOURNAL], &numbered().collect::<Vec<_>>())
    }

    /// Refuses a folder with a data set, which is more than what a run without one writes anew.
    pub(super) fn spare(own: &OwnFiles) -> Result<(), RecordError> {
        let found = own.names().find(|name| Self::is_of_one(name) && own.has(name));
        let path = found.map(|name| own.folder().join(name).display().to_string());
        path.map_or(Ok(()), |path| Err(RecordError::OfDataset { path }))
    }

    /// Renders a picture of a home in its present state, `width` by `height` pixels, and keeps its annotations.
    ///
    /// # Errors
    /// [`RecordError`]; the data set is then unchanged.
    pub fn add(&mut self, home: &Environment, view: Viewpoint, width: u32, height: u32) -> Result<(), RecordError> {
        let (version, light) = (env!("CARGO_PKG_VERSION"), home.pictures());
        let camera = home.placed(view).map(|camera| format!(" {camera:?}")).unwrap_or_default();
        let mut of = format!("{version} {} {view:?}{camera} {width} {height} {light:?}", home.digest());
        self.wanted().for_each(|(_, name)| of = format!("{of} {name}"));
        let picture = match self.journal.next(&of, self.own.folder()) {
            Some(picture) => picture,
            None => self.make(home, (view, width, height), &of)?,
        };
        self.seen.push(picture);
        Ok(())
    }

    /// Renders the next picture, and records its subject.
    fn make(
        &mut self,
        home: &Environment,
        wanted: (Viewpoint, u32, u32),
        of: &str,
    ) -> Result<CocoPicture, RecordError> {
        let (view, width, height) = wanted;
        let all = self.wanted().fold(Modality::Rgb | Modality::Boxes | Modality::Masks, |all, (one, _)| all | one);
        let frame = home.render(view, all, width, height)?;
        let number = self.seen.pictures();
        let name = format!("{FRAMES}/{number:06}.png");
        self.own.write(&name, &picture::png(&picture::rgb(&frame))?)?;
        let picture = CocoPicture::new(name, &frame, &home.snapshot()?)?;
        let name = home.placed(view).map_or_else(|| view.describe(home.graph()), |camera| camera.name);
        let mut picture = picture.taken(home.graph().name(), name);
        for (modality, kind) in self.wanted() {
            let name = format!("{kind}/{number:06}.npy");
            self.own.write(&name, &array(&frame, modality)?)?;
            picture = picture.with_file(kind, name);
        }
        self.journal.note(of, &picture)?;
        Ok(picture)
    }

    /// The modalities that are written as arrays, and their folders.
    fn wanted(&self) -> impl Iterator<Item = (Modality, &'static str)> + use<> {
        let arrays = self.arrays;
        ARRAYS.into_iter().filter(move |(modality, _)| arrays.has(*modality))
    }

    /// The number of pictures.
    pub fn pictures(&self) -> usize {
        self.seen.pictures()
    }

    /// Writes the annotations, and returns the path of their file.
    ///
    /// # Errors
    /// [`RecordError`] if they cannot be encoded or written.
    pub fn finish(mut self) -> Result<PathBuf, RecordError> {
        let path = self.own.folder().join(DOCUMENT);
        // An interrupted run may have left more pictures.
        let count = self.seen.pictures();
        self.own.remove(|name| number(name).is_some_and(|number| number >= count))?;
        save(&path, self.seen.document()?.as_bytes())?;
        self.journal.remove()?;
        self.own.settle()?;
        Ok(path)
    }
}

/// The folders of numbered files, with their endings.
fn numbered() -> impl Iterator<Item = (&'static str, &'static str)> {
    ARRAYS.iter().map(|(_, name)| (*name, "npy")).chain([(FRAMES, "png")])
}

/// The number of the picture that a file belongs to.
fn number(name: &str) -> Option<usize> {
    let (folder, file) = name.split_once('/')?;
    let number = file.split('.').next()?.parse().ok()?;
    numbered().any(|(known, _)| known == folder).then_some(number)
}

/// A modality of a frame as an array of rows.
fn array(frame: &Frame, modality: Modality) -> Result<Vec<u8>, RenderError> {
    let shape = [frame.height, frame.width];
    match modality {
        Modality::Distance => npy(&frame.distance, &shape),
        Modality::Instance => npy(&frame.instance, &shape),
        Modality::Class => npy(&frame.class, &shape),
        _ => npy(&frame.depth, &shape),
    }
}
