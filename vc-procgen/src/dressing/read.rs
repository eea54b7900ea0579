//! Reads tables of dressing.

use std::sync::Arc;

use vc_graph::class::Category;
use vc_graph::format::unmarked;
use vc_graph::{Class, ClassTable, Property, clip, did_you_mean};
use vc_shapes::Realm;
use vc_shapes::object::generator;

use super::error::{DressingError, DressingFault as Fault};
use super::household::KNOWN;
use super::rule::{Anchor, Condition, Place, Rule, Side, Table, Things, Trait, WallAt, bit};
use crate::plan::RoomKind;

/// The most traits of a table beside the known ones.
const TRAITS: usize = 64 - KNOWN.len();
/// The most things of a rule.
const MOST: usize = 40;

const ROOMS: [(&str, RoomKind); 11] = [
    ("living_room", RoomKind::Living),
    ("kitchen", RoomKind::Kitchen),
    ("bedroom", RoomKind::Bedroom),
    ("kids_room", RoomKind::Kids),
    ("bathroom", RoomKind::Bathroom),
    ("wc", RoomKind::Wc),
    ("hallway", RoomKind::Hall),
    ("home_office", RoomKind::Study),
    ("laundry_room", RoomKind::Laundry),
    ("storage_room", RoomKind::Storage),
    ("balcony", RoomKind::Balcony),
];

/// Reads a text on top of a table.
pub(super) fn table(table: Table, (file, text): (&str, &str), classes: &ClassTable) -> Result<Table, DressingError> {
    let mut reader = Reader { table, classes, rooms: 0 };
    for (index, line) in unmarked(text).lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim_end();
        let fault = |fault| DressingError { file: file.to_owned(), line: index + 1, fault };
        if !line.is_empty() {
            reader.line(line).map_err(fault)?;
        }
    }
    Ok(reader.table)
}

struct Reader<'t> {
    table: Table,
    classes: &'t ClassTable,
    /// The rooms of the lines to come.
    rooms: u16,
}

impl Reader<'_> {
    fn line(&mut self, line: &str) -> Result<(), Fault> {
        if let Some(text) = line.strip_prefix("trait ") {
            return self.household_trait(text);
        }
        if let Some((name, text)) = line.strip_prefix("list ").and_then(|text| text.split_once('=')) {
            let all: Result<Vec<_>, Fault> = text.split(',').map(|word| self.things(word.trim())).collect();
            self.table.lists.push((name.trim().to_owned(), all?.concat()));
            return Ok(());
        }
        if let Some(text) = line.strip_prefix('[') {
            let words = text.trim_end_matches(']').split_whitespace();
            self.rooms = words.map(room).try_fold(0, |all, kind| Ok(all | bit(kind?)))?;
            return Ok(());
        }
        self.rule(line)
    }

    fn household_trait(&mut self, text: &str) -> Result<(), Fault> {
        let (name, when) = text.split_once('|').ok_or(Fault::Columns(1))?;
        let (chance, when) = self.when(when)?;
        if self.table.traits.len() == TRAITS {
            return Err(Fault::TooManyTraits(TRAITS));
        }
        self.table.traits.push(Trait { name: name.trim().to_owned(), chance, when });
        Ok(())
    }

    fn rule(&mut self, line: &str) -> Result<(), Fault> {
        let text = line.trim_start();
        let spaces = line.len() - text.len();
        let cells: Vec<&str> = text.split('|').map(str::trim).collect();
        let [when, things, place] = cells[..] else { return Err(Fault::Columns(cells.len())) };
        if self.rooms == 0 {
            return Err(Fault::NoRoom);
        }
        let (chance, when) = self.when(when)?;
        let words = format!("{things} | {place}").split_whitespace().collect::<Vec<_>>().join(" ");
        let (things, place) = (self.counted(things)?, self.place(place)?);
        let rule = Rule { chance, when, rooms: self.rooms, things, place, words: (words, 0), then: Vec::new() };
        self.add(rule, spaces)
    }

    /// Adds a rule below the one it is about.
    fn add(&mut self, mut rule: Rule, spaces: usize) -> Result<(), Fault> {
        let is_it = matches!(
            &rule.place,
            Place::On { anchor: Anchor::It, .. }
                | Place::In(Anchor::It)
                | Place::Hang(Anchor::It)
                | Place::Row(Anchor::It)
                | Place::Beside(_)
        );
        match (spaces, is_it) {
            (0, true) => return Err(Fault::NoIt),
            (1.., false) => return Err(Fault::NotIt),
            _ => {}
        }
        let mut rules = &mut self.table.rules;
        for step in (0..spaces / 2).rev() {
            let above = rules.last_mut().filter(|above| above.rooms == self.rooms).ok_or(Fault::Orphan)?;
            if step == 0 && above.place.is_furniture() && matches!(rule.place, Place::Beside(_)) {
                return Err(Fault::NotBeside);
            }
            rules = &mut above.then;
        }
        if !spaces.is_multiple_of(2) {
            return Err(Fault::Orphan);
        }
        let alike = rules.iter().filter(|other| other.rooms & rule.rooms != 0 && other.words.0 == rule.words.0);
        rule.words.1 = alike.count() as u64;
        rules.push(rule);
        Ok(())
    }

    /// A chance and the traits after it.
    fn when(&self, text: &str) -> Result<(f32, Condition), Fault> {
        let mut words = text.split_whitespace();
        let number = words.next().unwrap_or_default();
        let chance = number.parse().ok().filter(|chance| (0.0..=1.0).contains(chance));
        let chance = chance.ok_or_else(|| Fault::Chance(clip(number)))?;
        let mut when = Condition::default();
        for word in words {
            match word.strip_prefix('!') {
                Some(barred) => when.bars |= self.trait_bit(barred)?,
                None => when.needs |= self.trait_bit(word)?,
            }
        }
        Ok((chance, when))
    }

    fn trait_bit(&self, word: &str) -> Result<u64, Fault> {
        let names = || KNOWN.into_iter().chain(self.table.traits.iter().map(|row| &*row.name));
        let at = names().position(|name| name == word);
        let unknown = || Fault::UnknownTrait { word: clip(word), near: did_you_mean(&clip(word), names()) };
        at.map(|at| 1 << at).ok_or_else(unknown)
    }

    /// `4x plate`, `1-2 mug/cup`, `teapot`.
    fn counted(&self, text: &str) -> Result<Things, Fault> {
        let (number, classes) = text.split_once(' ').unwrap_or(("1", text));
        let alike = number.ends_with('x');
        let bad = || Fault::Count(clip(number));
        let digits = number.trim_end_matches('x');
        let (low, high) = digits.split_once('-').unwrap_or((digits, digits));
        let read = |text: &str| text.parse::<usize>().ok().filter(|n| *n <= MOST).ok_or_else(bad);
        let count = (read(low)?, read(high)?);
        if count.0 > count.1 {
            return Err(bad());
        }
        Ok(Things { count, alike, classes: self.things(classes.trim())? })
    }

    /// The classes of things that can be made: classes, groups and lists, separated by `/`.
    fn things(&self, text: &str) -> Result<Vec<Arc<str>>, Fault> {
        let mut all = Vec::new();
        for word in text.split('/').map(str::trim) {
            if let Some(list) = word.strip_prefix('@') {
                all.extend(self.list(list)?.iter().cloned());
                continue;
            }
            let class = self.class(word)?;
            if class.category == Category::Group {
                let kinds = self.classes.kinds_of(class).filter(|kind| self.is_small(kind));
                all.extend(kinds.map(|kind| Arc::from(&*kind.name)));
                continue;
            }
            let built_in = ClassTable::builtin().get(word).is_some();
            if built_in && generator(&class.name).is_none() {
                return Err(Fault::NoGenerator(clip(word)));
            }
            all.push(Arc::from(&*class.name));
        }
        Ok(all)
    }

    fn list(&self, name: &str) -> Result<&[Arc<str>], Fault> {
        let found = self.table.lists.iter().rev().find(|(known, _)| known == name);
        found.map(|(_, classes)| &**classes).ok_or_else(|| Fault::UnknownList(clip(name)))
    }

    /// Whether things of a class are meant where a group is named: carried by a hand, and used indoors.
    fn is_small(&self, class: &Class) -> bool {
        let indoors = generator(&class.name).is_some_and(|made| made.realm == Realm::Indoor);
        indoors && class.category != Category::Group && class.affordances.contains(Property::Graspable)
    }

    /// Classes of furniture with all their kinds, separated by `/`.
    fn pieces(&self, text: &str) -> Result<Vec<Arc<str>>, Fault> {
        let mut all = Vec::new();
        for word in text.split('/').map(str::trim) {
            if let Some(list) = word.strip_prefix('@') {
                all.extend(self.list(list)?.iter().cloned());
                continue;
            }
            let class = self.class(word)?;
            all.extend(self.classes.kinds_of(class).map(|kind| Arc::from(&*kind.name)));
        }
        all.sort_unstable();
        all.dedup();
        Ok(all)
    }

    fn class(&self, word: &str) -> Result<&Class, Fault> {
        self.classes.get(word).ok_or_else(|| {
            let near = self.classes.nearest(&clip(word));
            let near: Vec<String> = near.iter().map(|word| format!("`{word}`")).collect();
            let near = if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", near.join(" or ")) };
            Fault::UnknownClass { word: clip(word), near }
        })
    }

    fn place(&self, text: &str) -> Result<Place, Fault> {
        let (text, each) = text.strip_prefix("each ").map_or((text, false), |rest| (rest, true));
        let (text, back) = text.strip_prefix("back ").map_or((text, false), |rest| (rest, true));
        let words: Vec<&str> = text.split_whitespace().collect();
        let bad = || Fault::Place(clip(text));
        let height = |text: &str| text.parse::<f32>().ok().filter(|z| (0.0..=3.0).contains(z)).ok_or_else(bad);
        let anchor = |what: &str| match what {
            "it" => Ok(Anchor::It),
            _ => Ok(Anchor::Piece { classes: self.pieces(what)?, each }),
        };
        Ok(match words[..] {
            ["on", what] => Place::On { anchor: anchor(what)?, back },
            ["in", what] => Place::In(anchor(what)?),
            ["hang", what] => Place::Hang(anchor(what)?),
            ["row", what] => Place::Row(anchor(what)?),
            ["seat", what] => Place::Seat(Anchor::Piece { classes: self.pieces(what)?, each: false }),
            ["beside", "it"] => Place::Beside(Side::Near),
            ["left", "it"] => Place::Beside(Side::Left),
            ["right", "it"] => Place::Beside(Side::Right),
            ["far", "it"] => Place::Beside(Side::Far),
            ["wall"] => Place::Against,
            ["corner"] => Place::Corner,
            ["floor"] => Place::Floor,
            ["before", "entrance"] => Place::BeforeEntrance,
            ["before", what] => Place::Before(self.pieces(what)?),
            ["next", what] => Place::Next(self.pieces(what)?),
            ["at", z] => Place::Wall { height: height(z)?, at: WallAt::Anywhere },
            ["over", what, z] => Place::Wall { height: height(z)?, at: WallAt::Over(self.pieces(what)?) },
            ["near", what, z] => Place::Wall { height: height(z)?, at: WallAt::Near(self.pieces(what)?) },
            ["within", what, z] => Place::Wall { height: height(z)?, at: WallAt::Within(self.pieces(what)?) },
            ["ceiling"] => Place::Ceiling,
            ["ceiling", what] => Place::CeilingBefore(self.pieces(what)?),
            ["instead", what] => Place::Instead(self.pieces_only(what)?),
            _ => return Err(bad()),
        })
    }

    /// Classes without their kinds: a kind of chair is not replaced because chairs are.
    fn pieces_only(&self, text: &str) -> Result<Vec<Arc<str>>, Fault> {
        text.split('/').map(|word| Ok(Arc::from(&*self.class(word.trim())?.name))).collect()
    }
}

fn room(word: &str) -> Result<RoomKind, Fault> {
    let near = || did_you_mean(&clip(word), ROOMS.iter().map(|(name, _)| *name));
    let found = ROOMS.iter().find(|(name, _)| *name == word).map(|(_, kind)| *kind);
    found.ok_or_else(|| Fault::UnknownRoom { word: clip(word), near: near() })
}
