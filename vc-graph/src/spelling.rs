//! How words and names are compared: case and separators do not count, and a misspelt word gets suggestions.

use std::borrow::Cow;

use unicode_normalization::UnicodeNormalization;

/// The largest number of suggestions.
const MOST: usize = 3;

/// Longest word that is compared, characters: a longer one is not a misspelling.
const LONGEST: usize = 40;

/// Strips the byte order mark that some editors write at the start of a text. All readers strip it.
///
/// ```
/// assert_eq!(vc_graph::format::unmarked("\u{feff}[WALK] <kitchen> (11)"), "[WALK] <kitchen> (11)");
/// ```
pub fn unmarked(text: &str) -> &str {
    text.trim_start_matches('\u{feff}')
}

/// Shortens a text, which may be hostile or huge, for a message: to sixty characters.
///
/// ```
/// assert_eq!(vc_graph::clip(&"ha".repeat(1000)).len(), 63);
/// assert_eq!(vc_graph::clip("short"), "short");
/// ```
pub fn clip(text: &str) -> String {
    const LIMIT: usize = 60;
    match text.char_indices().nth(LIMIT) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// The text with each accent and its letter as one character, where Unicode has one: `é` may be written as one
/// character or as two, and looks the same.
pub(crate) fn composed(text: &str) -> Cow<'_, str> {
    if text.is_ascii() { Cow::Borrowed(text) } else { Cow::Owned(text.nfc().collect()) }
}

/// The characters of [`composed`] without the text.
fn letters(text: &str) -> impl Iterator<Item = char> + '_ {
    let (plain, other) = if text.is_ascii() { (text, "") } else { ("", text) };
    plain.chars().chain(other.nfc())
}

/// Letters, digits and symbols of a spelling in lower case, which matching compares; ASCII punctuation separates
/// words. In a number, `-1`, hyphens count too, and in a name of symbols only, all of them.
pub(crate) fn folded(text: &str) -> impl Iterator<Item = char> + '_ {
    let (number, signs) = (!text.chars().any(char::is_alphabetic), !text.chars().any(char::is_alphanumeric));
    let sign = move |c: &char| !c.is_ascii() || number && matches!(c, '-' | '_') || signs;
    letters(text).filter(move |c| c.is_alphanumeric() || sign(c) && !c.is_whitespace()).flat_map(char::to_lowercase)
}

/// The folded spelling as a table key.
pub(crate) fn key(text: &str) -> String {
    if !text.is_ascii() || !text.bytes().any(|b| b.is_ascii_alphabetic()) {
        return folded(text).collect();
    }
    let mut key = String::with_capacity(text.len());
    key.extend(text.bytes().filter(u8::is_ascii_alphanumeric).map(|b| char::from(b.to_ascii_lowercase())));
    key
}

/// Whether two spellings are equal up to case and separators.
pub(crate) fn same_word(a: &str, b: &str) -> bool {
    folded(a).eq(folded(b))
}

/// The known words nearest to a misspelt one, three at most: those with the smallest edit distance. An edit
/// inserts, deletes or replaces a letter, or swaps two neighbouring letters; one edit is allowed, or one for
/// every three letters. Among equally near words those come first that begin with the misspelt one, or with which it
/// begins. Case and separators do not count.
///
/// ```
/// let verbs = ["grab", "walk", "wake_up", "switch_on"];
/// assert_eq!(vc_graph::nearest("garb", verbs), ["grab"]);
/// assert_eq!(vc_graph::nearest("SwichOn", verbs), ["switch_on"]);
/// assert!(vc_graph::nearest("teleport", verbs).is_empty());
/// ```
pub fn nearest<'w>(word: &str, known: impl IntoIterator<Item = &'w str>) -> Vec<&'w str> {
    let word: Vec<char> = folded(word).take(LONGEST + 1).collect();
    if word.len() > LONGEST {
        return Vec::new();
    }
    let most = (word.len() / 3).max(1);
    let near = known.into_iter().filter_map(|other| {
        let folded: Vec<char> = folded(other).take(LONGEST).collect();
        let slips = if folded.len().abs_diff(word.len()) > most { usize::MAX } else { slips(&word, &folded) };
        let apart = !folded.starts_with(&word) && !word.starts_with(&folded);
        (slips <= most && slips < word.len().max(folded.len())).then_some((slips, apart, other))
    });
    let mut near: Vec<(usize, bool, &str)> = near.collect();
    near.sort_unstable();
    near.dedup();
    let best = near.first().map_or(0, |(slips, ..)| *slips);
    near.into_iter().filter(|(slips, ..)| *slips <= best).take(MOST).map(|(.., word)| word).collect()
}

/// The nearest words in brackets, to be appended to the misspelt word: ``(did you mean `grab`?)`` with a space
/// before it. Empty if no word is near.
///
/// ```
/// use vc_graph::did_you_mean;
/// assert_eq!(did_you_mean("mugg", ["mug"]), " (did you mean `mug`?)");
/// assert_eq!(did_you_mean("mugg", []), "");
/// ```
pub fn did_you_mean<'w>(word: &str, known: impl IntoIterator<Item = &'w str>) -> String {
    let near: Vec<String> = nearest(word, known).iter().map(|w| format!("`{w}`")).collect();
    if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", near.join(" or ")) }
}

/// A number of things: `one thing`.
pub(crate) fn things(number: usize) -> String {
    match number {
        0 => "no things".to_owned(),
        1 => "one thing".to_owned(),
        2 => "two things".to_owned(),
        more => format!("{more} things"),
    }
}

/// How many things something takes, and how many it is given: `one thing, none is given`.
pub(crate) fn takes_and_given(takes: usize, given: usize) -> String {
    let takes = things(takes);
    match given {
        0 => format!("{takes}, none is given"),
        1 => format!("{takes}, one is given"),
        2 => format!("{takes}, two are given"),
        more => format!("{takes}, {more} are given"),
    }
}

/// The edit distance of two words (optimal string alignment).
fn slips(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, y) in b.iter().enumerate() {
            let mut least = (last[j] + usize::from(x != y)).min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && a[i - 1] == *y && b[j - 1] == *x {
                least = least.min(before[j - 1] + 1);
            }
            row.push(least);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}
