//! Code shared by the examples: reading and writing files, printing, and error messages.

#![allow(dead_code, reason = "no example reads, writes and prints at once")]

use std::fmt;
use std::io::Write;
use std::path::Path;

/// An error message for the user.
pub(crate) struct Complaint(String);

impl Complaint {
    pub(crate) fn new(message: impl fmt::Display) -> Self {
        Self(message.to_string())
    }
}

// `main` prints its error with Debug.
impl fmt::Debug for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Reads a text file, compressed or not.
pub(crate) fn read(path: &Path) -> Result<String, Complaint> {
    virtualcity::read_text(path).map_err(Complaint::new)
}

/// Writes a file completely or not at all, and creates its folder if necessary.
pub(crate) fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Complaint> {
    virtualcity::files::write(path, bytes.as_ref()).map_err(|e| unwritten(path, &e))
}

/// Creates a folder, and those that it is in.
pub(crate) fn create(folder: &Path) -> Result<(), Complaint> {
    std::fs::create_dir_all(folder).map_err(|e| unwritten(folder, &e))
}

/// The error for a file that cannot be written, with advice.
pub(crate) fn unwritten(path: &Path, error: &std::io::Error) -> Complaint {
    use std::io::ErrorKind;
    let advice = match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            "make room or choose another --out; runs that can be resumed go on where they stopped when started again"
        }
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => "choose an --out that you may write to",
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => "--out must be a folder, and this is a file",
        _ => "choose another --out",
    };
    Complaint::new(format!("{}: {error}; {advice}", path.display()))
}

/// Prints a line; exits quietly if the output is closed, as by `| head`.
pub(crate) fn say_line(line: fmt::Arguments<'_>) {
    if writeln!(std::io::stdout(), "{line}").is_err() {
        std::process::exit(0);
    }
}

/// `println!` that does not panic on a closed pipe.
macro_rules! say {
    ($($text:tt)*) => { $crate::support::say_line(format_args!($($text)*)) };
}
pub(crate) use say;
