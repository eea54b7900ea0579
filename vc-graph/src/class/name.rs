//! Forgiving names: which class a spelling might mean, best guess first.

use crate::vocabulary::key;

/// Words that engines and artists put around a name.
const NOISE: &[&str] = &["sm", "bp", "pre", "mod", "fur", "pro", "dec", "ele", "app", "lam", "prefab", "mesh", "ingir"];

/// Longest name that is taken apart; longer ones are only matched whole.
const LONGEST: usize = 12;

/// The folded spellings to look up, best first: the whole name, the name without
/// noise and numbers, then its parts, longer before shorter and later before
/// earlier (in English the last word says what a thing is).
pub(super) fn candidates(name: &str) -> impl Iterator<Item = String> {
    let whole = key(name);
    std::iter::once(whole).chain(std::iter::once_with(|| parts(name)).flatten())
}

fn parts(name: &str) -> Vec<String> {
    let mut found = with_singular(unnumbered(name));
    found.extend(spans(name));
    found
}

/// The name without an engine's prefixes and numbers: `SM_3D_Printer_02` as
/// `3dprinter`.
fn unnumbered(name: &str) -> String {
    let pieces = name.split(|c: char| !c.is_alphanumeric()).map(key);
    pieces.filter(|p| !NOISE.contains(&p.as_str()) && !p.chars().all(|c| c.is_ascii_digit())).collect()
}

/// Runs of words of a name, longer before shorter and later before earlier.
fn spans(name: &str) -> Vec<String> {
    let words = words(name);
    let meaning: Vec<&str> = words.iter().map(String::as_str).filter(|w| !NOISE.contains(w)).collect();
    if meaning.len() > LONGEST {
        return Vec::new();
    }
    let spans = (1..=meaning.len()).rev().flat_map(|len| (0..=meaning.len() - len).rev().map(move |at| (at, len)));
    spans.flat_map(|(at, len)| with_singular(meaning[at..at + len].concat())).collect()
}

/// A name and, if it looks like a plural, its singular.
fn with_singular(name: String) -> Vec<String> {
    let singular = name.strip_suffix("es").or(name.strip_suffix('s')).filter(|s| s.len() > 2).map(str::to_owned);
    let short = name.strip_suffix('s').filter(|s| s.len() > 2).map(str::to_owned);
    std::iter::once(name).chain(short).chain(singular).collect()
}

/// Lower-case words: split at separators, digits and capitals.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut after_lower = false;
    for c in name.chars() {
        let starts = c.is_uppercase() && after_lower;
        if !c.is_alphabetic() || starts {
            words.push(String::new());
        }
        if c.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            word.extend(c.to_lowercase());
        }
        after_lower = c.is_lowercase();
    }
    words.retain(|w| !w.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::candidates;

    #[test]
    fn whole_name_comes_first_and_later_words_before_earlier() {
        let all: Vec<String> = candidates("SM_Kitchen_Table_03").collect();
        assert_eq!(all[0], "smkitchentable03");
        assert_eq!(all[1], "kitchentable");
        let table = all.iter().position(|c| c == "table");
        let kitchen = all.iter().position(|c| c == "kitchen");
        assert!(table < kitchen);
    }
}
