//! What the examples share: reading files, printing, and saying what went wrong.

use std::fmt;
use std::io::Write;
use std::path::Path;

/// Something went wrong, said to a person.
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

/// Reads a text file, packed or not.
pub(crate) fn read(path: &Path) -> Result<String, Complaint> {
    virtualcity::read_text(path).map_err(Complaint::new)
}

/// Prints a line; ends quietly when nobody reads any more, as `| head` does.
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
