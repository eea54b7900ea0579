//! Files as they lie about: packed or not, marked or not, and of any length.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use flate2::bufread::MultiGzDecoder;
use vc_graph::format::{LARGEST, unmarked};

/// What packed files begin with.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// Why a file was not read.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {problem}")]
pub struct FileError {
    /// Which file.
    pub path: String,
    /// What is wrong with it.
    pub problem: FileProblem,
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileProblem {
    /// It cannot be opened, read or unpacked.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// It is too large, or what is packed in it.
    #[error("there are more than {LARGEST} bytes in it, which is the most that is read")]
    TooLarge,
    /// It is no text.
    #[error("this is no text in UTF-8: save it in that encoding")]
    NoText,
}

/// The text of a file, unpacked if it is packed by gzip, whatever its name, and without a byte
/// order mark. Of pipes and devices too no more is taken than fits: [`LARGEST`] bytes.
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

/// The bytes of a file, as [`read_text`] reads them.
///
/// # Errors
/// [`FileError`] names the file.
pub fn read_bytes(path: impl AsRef<Path>) -> Result<Vec<u8>, FileError> {
    let path = path.as_ref();
    unpacked(path).map_err(|problem| at(path, problem))
}

fn at(path: &Path, problem: FileProblem) -> FileError {
    FileError { path: path.display().to_string(), problem }
}

fn unpacked(path: &Path) -> Result<Vec<u8>, FileProblem> {
    let mut file = BufReader::new(File::open(path)?);
    if file.fill_buf()?.starts_with(&GZIP) { limited(MultiGzDecoder::new(file)) } else { limited(file) }
}

/// All there is, unless it is too much: one byte more than fits is enough to know.
fn limited(from: impl Read) -> Result<Vec<u8>, FileProblem> {
    let mut bytes = Vec::new();
    from.take(LARGEST as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > LARGEST { Err(FileProblem::TooLarge) } else { Ok(bytes) }
}
