//! Files: reading them, gzipped or not, up to a size limit, and writing them whole or not at all.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use flate2::bufread::MultiGzDecoder;
use vc_graph::format::{self, FormatError, LARGEST, unmarked};
use vc_graph::{ClassTable, SceneGraph};

/// The first bytes of gzipped files.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// The error of a file that was not read or not written.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {problem}")]
pub struct FileError {
    /// The file's path.
    pub path: String,
    /// The reason.
    pub problem: FileProblem,
}

impl FileError {
    pub(crate) fn new(path: &Path, problem: FileProblem) -> Self {
        at(path, problem)
    }

    /// The error of a file or folder that cannot be written, with advice.
    pub fn unwritten(path: &Path, error: io::Error) -> Self {
        at(path, FileProblem::Unwritten { advice: advice(error.kind()), error })
    }
}

/// Creates a folder, and those that it is in.
///
/// # Errors
/// [`FileError`] with the system's error and advice.
pub fn create_folder(folder: &Path) -> Result<(), FileError> {
    std::fs::create_dir_all(folder).map_err(|e| FileError::unwritten(folder, e))
}

fn advice(problem: io::ErrorKind) -> &'static str {
    use io::ErrorKind;
    match problem {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            "make room or choose another folder; runs that can be resumed go on where they stopped"
        }
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => "choose a folder that you may write to",
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => "this has to be a folder, and is a file",
        _ => "choose another folder",
    }
}

/// The reason why a file was not read or not written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileProblem {
    /// The file cannot be opened, read or unpacked.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The file is larger than [`LARGEST`] bytes, packed or unpacked.
    #[error("the file has more than {LARGEST} bytes, which is the largest size that is read")]
    TooLarge,
    /// The file is not text in UTF-8.
    #[error("this is no text in UTF-8: save it in that encoding")]
    NoText,
    /// The text is no scene.
    #[error(transparent)]
    Scene(#[from] FormatError),
    /// The file has unfinished results of a run with another recipe.
    #[error("this is of another run that was broken off: choose another folder, or delete this file")]
    OtherRun,
    /// The file is gone although a run still needs it.
    #[error("this file is gone: another run writes to the same folder; choose another one")]
    Gone,
    /// The file cannot be written.
    #[error("{error}; {advice}")]
    Unwritten {
        /// The system's error.
        #[source]
        error: io::Error,
        /// A way out.
        advice: &'static str,
    },
}

/// Reads the text of a file, unpacked if its content is gzipped, whatever its name, and without a byte order
/// mark. At most [`LARGEST`] bytes are read, also from pipes and devices.
///
/// ```no_run
/// let text = virtualcity::read_text("scene1.json.gz")?;
/// # Ok::<(), virtualcity::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] names the file.
pub fn read_text(path: impl AsRef<Path>) -> Result<String, FileError> {
    let path = path.as_ref();
    let text = String::from_utf8(read_bytes(path)?).map_err(|_| at(path, FileProblem::NoText))?;
    let marked = unmarked(&text).len() < text.len();
    Ok(if marked { unmarked(&text).to_owned() } else { text })
}

/// Reads the bytes of a file under the same rules as [`read_text`].
///
/// # Errors
/// [`FileError`] names the file.
pub fn read_bytes(path: impl AsRef<Path>) -> Result<Vec<u8>, FileError> {
    let path = path.as_ref();
    unpacked(path).map_err(|problem| at(path, problem))
}

/// Reads a scene from a file of any format ([`format::read_scene`]), gzipped or not.
///
/// ```no_run
/// use virtualcity::graph::ClassTable;
/// let scene = virtualcity::read_scene("scene1.json.gz", &ClassTable::builtin())?;
/// # Ok::<(), virtualcity::FileError>(())
/// ```
///
/// # Errors
/// [`FileError`] names the file, also if its text is no scene.
pub fn read_scene(path: impl AsRef<Path>, classes: &Arc<ClassTable>) -> Result<SceneGraph, FileError> {
    let path = path.as_ref();
    format::read_scene(&read_text(path)?, classes).map_err(|error| at(path, FileProblem::Scene(error)))
}

fn at(path: &Path, problem: FileProblem) -> FileError {
    FileError { path: path.display().to_string(), problem }
}

fn unpacked(path: &Path) -> Result<Vec<u8>, FileProblem> {
    let mut file = BufReader::new(File::open(path)?);
    if file.fill_buf()?.starts_with(&GZIP) { limited(MultiGzDecoder::new(file)) } else { limited(file) }
}

/// Reads all bytes unless they are too many: one byte beyond the limit is enough to know.
fn limited(from: impl Read) -> Result<Vec<u8>, FileProblem> {
    let mut bytes = Vec::new();
    from.take(LARGEST as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > LARGEST { Err(FileProblem::TooLarge) } else { Ok(bytes) }
}

/// Writes a file whole or not at all: it is written under another name first (`NAME.part`) and then renamed.
/// Its folder is created if it does not exist.
///
/// ```
/// let path = std::env::temp_dir().join("virtualcity-files").join("note.txt");
/// virtualcity::files::write(&path, b"whole")?;
/// assert_eq!(std::fs::read(&path)?, b"whole");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] with the system's error and advice if the folder or the file cannot be written, or the disk is
/// full. An existing file stays as it was.
pub fn write(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> Result<(), FileError> {
    let path = path.as_ref();
    whole(path, bytes.as_ref()).map_err(|error| FileError::unwritten(path, error))
}

fn whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // A link's file is written, and a device or pipe is written to, not replaced.
    let path = &std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if std::fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        return std::fs::write(path, bytes);
    }
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        std::fs::create_dir_all(folder)?;
    }
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let part = PathBuf::from(part);
    let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    written.inspect_err(|_| {
        // The partial file takes up space. If removing it fails, the first error is still the one to report.
        let _ = std::fs::remove_file(&part);
    })
}

/// Removes a file. A missing file is not an error.
///
/// # Errors
/// The system's error if it cannot be removed.
pub fn remove(path: &Path) -> io::Result<()> {
    std::fs::remove_file(path).or_else(|error| match error.kind() {
        io::ErrorKind::NotFound => Ok(()),
        _ => Err(error),
    })
}
