//! Code shared by the examples: printing, and error messages.

use std::fmt;
use std::io::Write;

/// An error message for the user.
pub(crate) struct Complaint(String);

impl Complaint {
    pub(crate) fn new(message: impl fmt::Display) -> Self {
        Self(message.to_string())
    }
}

impl<E: std::error::Error> From<E> for Complaint {
    fn from(error: E) -> Self {
        Self::new(error)
    }
}

// `main` prints its error with Debug.
impl fmt::Debug for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Prints a line; exits quietly if the output is closed, as by `| head`.
pub(crate) fn say_line(line: fmt::Arguments<'_>) {
    match writeln!(std::io::stdout(), "{line}") {
        Ok(()) => {}
        // The reader has seen enough.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => std::process::exit(0),
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "the output cannot be written: {error}");
            std::process::exit(1);
        }
    }
}

/// `println!` that does not panic on a closed pipe.
macro_rules! say {
    ($($text:tt)*) => { $crate::support::say_line(format_args!($($text)*)) };
}
pub(crate) use say;
