//! Examples that take no options.

use clap::Parser;

/// This example takes no options: the first lines of its source say what it does.
#[derive(Parser)]
struct NoOptions {}

/// Refuses options, and answers `--help`.
pub(crate) fn no_options() {
    NoOptions::parse();
}
