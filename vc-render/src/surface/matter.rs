//! The matter of a material, as far as it shows: a table by words of names.

use std::sync::LazyLock;

/// A kind of matter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Matter {
    Smooth,
    Wood,
    Bark,
    Leather,
    Textile,
    Brick,
    Tile,
    Granular,
    Marble,
    WallPaint,
    Mineral,
    Paper,
}

const NAMES: [(&str, Matter); 12] = [
    ("smooth", Matter::Smooth),
    ("wood", Matter::Wood),
    ("bark", Matter::Bark),
    ("leather", Matter::Leather),
    ("textile", Matter::Textile),
    ("brick", Matter::Brick),
    ("tile", Matter::Tile),
    ("granular", Matter::Granular),
    ("marble", Matter::Marble),
    ("wall_paint", Matter::WallPaint),
    ("mineral", Matter::Mineral),
    ("paper", Matter::Paper),
];

static TABLE: LazyLock<Vec<(Matter, Vec<&str>)>> = LazyLock::new(|| {
    let lines = include_str!("../../data/matter.txt").lines().filter(|line| !line.starts_with('#'));
    let row = |line: &'static str| {
        let (matter, words) = line.split_once('|')?;
        let (_, matter) = NAMES.iter().find(|(name, _)| *name == matter.trim())?;
        Some((*matter, words.split_whitespace().collect()))
    };
    lines.filter_map(row).collect()
});

impl Matter {
    /// The matter of a material with this name, if the table has one of its words.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        // A word counts only at its beginning: "washed" is not ash.
        let begins = |at: usize| !name[..at].ends_with(|c: char| c.is_alphabetic());
        let has = |word: &&str| name.match_indices(*word).any(|(at, _)| begins(at));
        TABLE.iter().find(|(_, words)| words.iter().any(&has)).map(|(matter, _)| *matter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_the_table_is_read() {
        let lines = include_str!("../../data/matter.txt").lines().filter(|line| !line.starts_with('#')).count();
        assert_eq!(TABLE.len(), lines);
        assert_eq!([Matter::from_name("roof_tile"), Matter::from_name("red_roof")], [Some(Matter::Brick), None]);
    }
}
