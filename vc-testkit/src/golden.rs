//! Golden files: the output of a test, kept to compare with. `VC_GOLDEN=write` writes them anew.

use std::path::Path;

/// The content of a golden file, or `None` if it has just been written anew from `made`.
///
/// # Panics
/// Without the file, with the command that makes it.
pub fn kept(file: &Path, made: &[u8]) -> Option<Vec<u8>> {
    if std::env::var("VC_GOLDEN").is_ok_and(|v| v == "write") {
        std::fs::write(file, made).unwrap();
        return None;
    }
    Some(std::fs::read(file).unwrap_or_else(|e| panic!("{}: {e}; VC_GOLDEN=write makes it", file.display())))
}

/// Compares text with a golden file.
///
/// # Panics
/// If they differ, with the lines that do.
pub fn same_lines(file: &Path, made: &str) {
    let Some(kept) = kept(file, made.as_bytes()) else { return };
    let kept = String::from_utf8(kept).unwrap();
    let differ: Vec<_> = kept.lines().zip(made.lines()).filter(|(kept, made)| kept != made).collect();
    assert!(kept == made, "{} differs in these lines (kept, made): {differ:#?}", file.display());
}
