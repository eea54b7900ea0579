//! Where a short example writes: its only argument.

use std::path::PathBuf;

use crate::support::Complaint;

/// The path that a program was given, or the default.
///
/// # Errors
/// More arguments, or an option.
pub(crate) fn output(program: &str, default: &str) -> Result<PathBuf, Complaint> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.as_slice() {
        [] => Ok(default.into()),
        [path] if !path.starts_with('-') && !path.is_empty() => Ok(path.into()),
        _ => Err(Complaint::new(format!("usage: {program} [PATH], not `{}`", words.join(" ")))),
    }
}
