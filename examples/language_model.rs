//! Lets a language model tidy up after breakfast.
//!
//! `cargo run --release --example language_model` needs no network: the model's answers were recorded,
//! including its mistakes, and are read from `examples/data/language_model.txt`. The example
//! `language_endpoint` asks a local server.

#[path = "support/breakfast.rs"]
mod breakfast;
mod support;

use std::path::PathBuf;

use breakfast::{BREAK, tidy_up};
use clap::Parser;
use support::Complaint;

const RECORDED: &str = include_str!("data/language_model.txt");

/// Lets a language model tidy up after breakfast, with recorded answers.
#[derive(Parser)]
struct Options {
    /// A file with other answers, separated by lines of `---`.
    #[arg(long)]
    answers: Option<PathBuf>,
    /// Show the prompts.
    #[arg(long)]
    prompts: bool,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let text = options.answers.as_deref().map_or_else(|| Ok(RECORDED.to_owned()), virtualcity::read_text)?;
    by_recorded(&text, options.prompts)
}

fn by_recorded(text: &str, prompts: bool) -> Result<(), Complaint> {
    let mut answers = text.split(BREAK);
    let next = |_: &_| answers.next().map(str::to_owned).ok_or("there are no more recorded answers".into());
    tidy_up(prompts, next).map(drop)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use super::*;

    #[test]
    fn recorded_answers_win() {
        by_recorded(RECORDED, false).unwrap();
    }

    #[test]
    fn an_episode_that_is_not_won_is_an_error() {
        let told = |text: &str| format!("{:?}", by_recorded(text, false).unwrap_err());
        assert!(told("done").starts_with("Lost after 0 steps"), "{}", told("done"));
        assert!(told("walk fridge.3").contains("no more recorded answers"));
    }
}
