//! Suggestions for misspelt words: the nearest known words.

use crate::vocabulary::folded;

/// The largest number of suggestions.
const MOST: usize = 3;

/// Longest word that is compared, characters: a longer one is not a misspelling.
const LONGEST: usize = 40;

/// The known words nearest to a misspelt one, three at most: those with the smallest edit distance. An edit
/// inserts, deletes or replaces a letter, or swaps two neighbouring letters; one edit is allowed, or one for
/// every three letters. Case and separators do not count.
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
        (slips <= most && slips < word.len().max(folded.len())).then_some((slips, other))
    });
    let mut near: Vec<(usize, &str)> = near.collect();
    near.sort_unstable();
    near.dedup();
    let best = near.first().map_or(0, |(slips, _)| *slips);
    near.into_iter().filter(|(slips, _)| *slips <= best).take(MOST).map(|(_, word)| word).collect()
}

/// The nearest words in brackets, to be appended to the misspelt word: ``(did you mean `grab`?)`` with a space
/// before it. Empty if no word is near.
pub fn did_you_mean<'w>(word: &str, known: impl IntoIterator<Item = &'w str>) -> String {
    let near: Vec<String> = nearest(word, known).iter().map(|w| format!("`{w}`")).collect();
    if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", near.join(" or ")) }
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
