//! Tolerant name matching: the classes that a spelling might mean, best guess first.

use crate::spelling::{composed, key};

/// Prefixes and other words that engines and artists add to a name.
const NOISE: &[&str] = &["sm", "bp", "pre", "mod", "fur", "pro", "dec", "ele", "app", "lam", "prefab", "mesh", "ingir"];

/// Words that may follow an object's name and describe it: `Table_Round_White`.
const QUALIFIERS: &[&str] = &[
    "small", "medium", "large", "big", "mini", "tall", "short", "long", "wide", "narrow", "high", "low", "left",
    "right", "front", "back", "top", "bottom", "upper", "lower", "inner", "outer", "open", "closed", "old", "new",
    "modern", "classic", "antique", "vintage", "round", "square", "oval", "single", "double", "black", "white", "grey",
    "gray", "red", "green", "blue", "yellow", "brown", "pink", "purple", "beige", "dark", "bright", "wood", "wooden",
    "metal", "plastic", "leather", "fabric", "marble", "steel", "gold", "silver", "copy", "clone", "variant",
    "version", "var", "ver", "lod",
];

/// The largest number of words for which a name is split; longer names are only matched whole.
const LONGEST: usize = 12;

/// The folded spellings to look up, best first: the whole name, the name without noise words and numbers, then
/// its ends, longer before shorter: in English the last word names the object, and a fridge magnet is not a
/// fridge.
pub(super) fn candidates(name: &str) -> impl Iterator<Item = String> {
    let whole = key(name);
    std::iter::once(whole).chain(std::iter::once_with(|| parts(name)).flatten())
}

fn parts(name: &str) -> Vec<String> {
    let name = &*composed(name);
    let mut found = with_singular(unnumbered(name));
    let words = words(name);
    let mut meaning: Vec<&str> = words.iter().map(String::as_str).filter(|w| !NOISE.contains(w)).collect();
    if meaning.len() <= LONGEST {
        found.extend(ends(&meaning));
        while meaning.len() > 1 && meaning.last().is_some_and(|w| w.len() == 1 || QUALIFIERS.contains(w)) {
            meaning.pop();
            found.extend(ends(&meaning));
        }
    }
    found
}

/// The name without an engine's prefixes and numbers: `SM_3D_Printer_02` as
/// `3dprinter`.
fn unnumbered(name: &str) -> String {
    let pieces = name.split(|c: char| !c.is_alphanumeric()).map(key);
    pieces.filter(|p| !NOISE.contains(&p.as_str()) && !p.chars().all(|c| c.is_ascii_digit())).collect()
}

/// The ends of a name, from all its words to the last word.
fn ends(words: &[&str]) -> Vec<String> {
    (0..words.len()).flat_map(|from| with_singular(words[from..].concat())).collect()
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
    fn whole_name_comes_first_and_then_its_ends() {
        let all: Vec<String> = candidates("SM_Kitchen_Table_Round_03").collect();
        assert_eq!(all[0], "smkitchentableround03");
        assert_eq!(all[1], "kitchentableround");
        let place = |name: &str| all.iter().position(|c| c == name);
        assert!(place("round") < place("kitchentable") && place("kitchentable") < place("table"));
        assert_eq!(place("kitchen"), None, "a kitchen table is no kitchen");
    }
}
