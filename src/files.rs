//! Files that are written whole or not at all: what is broken off leaves none that looks complete.

use std::io;
use std::path::{Path, PathBuf};

/// Writes a file whole or not at all: under another name first (`NAME.part`), which is then renamed. Its folder is made
/// if need be.
///
/// ```
/// let path = std::env::temp_dir().join("virtualcity-files").join("note.txt");
/// virtualcity::files::write(&path, b"whole")?;
/// assert_eq!(std::fs::read(&path)?, b"whole");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// That of the system: the folder or the file cannot be written, or the disk is full. What was there is left as it was.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        std::fs::create_dir_all(folder)?;
    }
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let part = PathBuf::from(part);
    let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    written.inspect_err(|_| {
        // It takes space; if it cannot be removed either, so be it.
        let _ = std::fs::remove_file(&part);
    })
}

/// Removes the files of a folder that are named by a number and have this ending: `000.jpg`, `001.jpg`. A folder that is
/// not there has none.
///
/// # Errors
/// That of the system.
pub fn remove_numbered(folder: &Path, ending: &str) -> io::Result<()> {
    let entries = match std::fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries?,
    };
    for entry in entries {
        let path = entry?.path();
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        let is_number = !stem.is_empty() && stem.bytes().all(|b| b.is_ascii_digit());
        if is_number && path.extension().is_some_and(|e| e == ending) {
            std::fs::remove_file(&path)?;
        }
    }
    Ok(())
}
