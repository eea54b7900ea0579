//! The text form of a class table.

use std::collections::HashMap;
use std::sync::Arc;

use super::{Category, Class, ClassTable, Kept, Range, Slot, SlotKind, Trait};
use crate::spelling::{clip, composed, key, unmarked};
use crate::vocabulary::{Set, Word};
use crate::{ObjectRole, Property, Relation, State};

const COLUMNS: [&str; 11] =
    ["name", "kind of", "aliases", "category", "affordances", "size", "mass", "starts", "slots", "kept", "traits"];

/// The largest number of ancestors of a class, direct and indirect.
const DEEPEST: usize = 64;

/// An error in a class table, with its location.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}, line {line}, column `{column}`: {problem}")]
pub struct ClassError {
    /// Name of the text, as given.
    pub file: String,
    /// Line, counted from one.
    pub line: usize,
    /// The column.
    pub column: &'static str,
    /// The error.
    pub problem: ClassProblem,
}

/// An error in an entry of a class table.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ClassProblem {
    /// Wrong number of columns.
    #[error("a class has 10 columns separated by `|`, this line has {0}; its traits may follow as an 11th")]
    Columns(usize),
    /// The name is in use already.
    #[error("`{0}` is the name or alias of another class already")]
    Taken(String),
    /// A reference to a class that does not exist.
    #[error("there is no class `{0}`")]
    NoSuchClass(String),
    /// A word that is not in its vocabulary.
    #[error(transparent)]
    Word(#[from] crate::vocabulary::UnknownWord),
    /// Not a number or range.
    #[error("`{0}` is no range of positive numbers such as `0.4-0.6`")]
    Range(String),
    /// Not three ranges.
    #[error("a size is three ranges: depth, width and height in metres")]
    Size,
    /// Not a slot.
    #[error("`{0}` is no slot such as `drawer:3`")]
    Slot(String),
    /// Not a place.
    #[error("`{0}` is no place such as `kitchen/on/kitchen_table:3` or `kitchen:1`")]
    Kept(String),
    /// A class is its own ancestor.
    #[error("`{0}` is a kind of itself")]
    Cycle(String),
    /// A class has too many ancestors.
    #[error("`{0}` has more than {DEEPEST} ancestors")]
    TooDeep(String),
    /// No name, or one with other characters than letters, digits, `_` and `-`.
    #[error("the name is missing or has characters other than letters, digits, `_` and `-`")]
    Name,
}

impl ClassTable {
    /// Parses a class table.
    ///
    /// One class a line, ten or eleven columns separated by `|`; `#` starts a comment line:
    ///
    /// `name | kind of | aliases | category | affordances | size | mass | starts | slots | kept | traits`
    ///
    /// Lists are separated by spaces. A size is three ranges in metres (depth, width, height), a mass is a
    /// range in kilograms, a slot is written `drawer:3`, and a place `room/on/class:weight`,
    /// `room/in/class:weight` or `room:weight`, with `*` for any room. All columns except the first and the
    /// fourth may be empty, and the traits may be left out.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// let text = "mug_rack | | | furniture | surface | 0.2 0.3 0.3 | 1 | | hook:6 | kitchen:1";
    /// let classes = ClassTable::builtin().extended("mine.txt", text)?;
    /// assert!(classes.get("MugRack").is_some());
    /// # Ok::<(), vc_graph::ClassError>(())
    /// ```
    ///
    /// # Errors
    /// [`ClassError`], with line, column and the expected form.
    pub fn parse(file: &str, text: &str) -> Result<Self, ClassError> {
        parse(Self::default(), &[(file, text)])
    }

    /// This table extended by the classes of another text, which may refer to the classes of this table.
    ///
    /// # Errors
    /// As [`ClassTable::parse`].
    pub fn extended(&self, file: &str, text: &str) -> Result<Self, ClassError> {
        parse(self.clone(), &[(file, text)])
    }
}

/// The location of a class in the text, for errors found after all classes are read.
struct Origin<'a> {
    file: &'a str,
    line: usize,
}

impl Origin<'_> {
    fn error(&self, column: usize, problem: impl Into<ClassProblem>) -> ClassError {
        ClassError { file: self.file.to_owned(), line: self.line, column: COLUMNS[column], problem: problem.into() }
    }
}

pub(super) fn parse(mut table: ClassTable, texts: &[(&str, &str)]) -> Result<ClassTable, ClassError> {
    let first_new = table.classes.len();
    let mut origins = Vec::new();
    for (file, text) in texts {
        for (index, line) in unmarked(text).lines().enumerate() {
            let line = composed(line);
            let line_text = line.trim();
            if line_text.is_empty() || line_text.starts_with('#') {
                continue;
            }
            let origin = Origin { file, line: index + 1 };
            let class = parse_class(line_text, &origin, table.classes.len())?;
            add(&mut table, class, &origin)?;
            origins.push(origin);
        }
    }
    resolve(&mut table, first_new, &origins)?;
    Ok(table)
}

fn add(table: &mut ClassTable, class: Class, origin: &Origin<'_>) -> Result<(), ClassError> {
    let names = std::iter::once((0, &class.name)).chain(class.aliases.iter().map(|a| (2, a)));
    for (column, name) in names {
        let key = key(name);
        match table.by_name.get(&key) {
            Some(&other) if other != class.index => {
                return Err(origin.error(column, ClassProblem::Taken(name.to_string())));
            }
            _ => table.by_name.insert(key, class.index),
        };
    }
    table.written.insert(class.name.clone(), class.index);
    table.classes.push(class);
    Ok(())
}

fn parse_class(line: &str, origin: &Origin<'_>, index: usize) -> Result<Class, ClassError> {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    let traits = match columns.len() {
        10 => "",
        11 => columns[10],
        number => return Err(origin.error(0, ClassProblem::Columns(number))),
    };
    if !is_name(columns[0]) {
        return Err(origin.error(0, ClassProblem::Name));
    }
    let aliases: Vec<&str> = columns[2].split([' ', ',']).filter(|a| !a.is_empty()).collect();
    if !aliases.iter().all(|a| is_name(a)) {
        return Err(origin.error(2, ClassProblem::Name));
    }
    Ok(Class {
        name: columns[0].into(),
        parents: columns[1].split_whitespace().map(Arc::from).collect(),
        aliases: aliases.into_iter().map(Arc::from).collect(),
        category: Category::parse(columns[3]).map_err(|e| origin.error(3, e))?,
        affordances: words::<Property>(columns[4]).map_err(|e| origin.error(4, e))?,
        size: size(columns[5]).map_err(|e| origin.error(5, e))?,
        mass: mass(columns[6]).map_err(|e| origin.error(6, e))?,
        starts: words::<State>(columns[7]).map_err(|e| origin.error(7, e))?,
        slots: list(columns[8], slot).map_err(|e| origin.error(8, e))?.into(),
        kept: list(columns[9], kept).map_err(|e| origin.error(9, e))?,
        traits: words::<Trait>(traits).map_err(|e| origin.error(10, e))?,
        listed: None,
        index,
    })
}

/// Whether a name is well formed, so that a class can be found by it.
fn is_name(name: &str) -> bool {
    name.chars().any(char::is_alphanumeric) && name.chars().all(crate::id::is_class_char)
}

fn list<T>(text: &str, item: impl Fn(&str) -> Result<T, ClassProblem>) -> Result<Vec<T>, ClassProblem> {
    text.split_whitespace().map(item).collect()
}

fn words<W: Word>(text: &str) -> Result<Set<W>, ClassProblem> {
    let words: Result<Set<W>, _> = text.split_whitespace().map(W::parse).collect();
    Ok(words?)
}

fn range(text: &str) -> Result<Range, ClassProblem> {
    let bad = || ClassProblem::Range(clip(text));
    let (low, high) = text.split_once('-').unwrap_or((text, text));
    let low: f32 = low.parse().map_err(|_| bad())?;
    let high: f32 = high.parse().map_err(|_| bad())?;
    if low > 0.0 && low <= high && high.is_finite() { Ok(Range { low, high }) } else { Err(bad()) }
}

fn size(text: &str) -> Result<Option<[Range; 3]>, ClassProblem> {
    let ranges = list(text, range)?;
    if ranges.is_empty() {
        return Ok(None);
    }
    <[Range; 3]>::try_from(ranges).map(Some).map_err(|_| ClassProblem::Size)
}

fn mass(text: &str) -> Result<Option<Range>, ClassProblem> {
    if text.is_empty() { Ok(None) } else { range(text).map(Some) }
}

fn slot(text: &str) -> Result<Slot, ClassProblem> {
    let bad = || ClassProblem::Slot(clip(text));
    let (kind, number) = text.split_once(':').ok_or_else(bad)?;
    let number = number.parse().ok().filter(|&n| n > 0).ok_or_else(bad)?;
    Ok(Slot { kind: SlotKind::parse(kind)?, number })
}

fn kept(text: &str) -> Result<Kept, ClassProblem> {
    let bad = || ClassProblem::Kept(clip(text));
    let (place, weight) = text.split_once(':').ok_or_else(bad)?;
    let weight = weight.parse().ok().filter(|&w| w > 0).ok_or_else(bad)?;
    let parts: Vec<&str> = place.split('/').collect();
    let (room, at) = match parts.as_slice() {
        [room] => (*room, None),
        [room, "on", class] => (*room, Some((Relation::On, Arc::from(*class)))),
        [room, "in", class] => (*room, Some((Relation::Inside, Arc::from(*class)))),
        _ => return Err(bad()),
    };
    let room = (room != "*").then(|| Arc::from(room));
    Ok(Kept { room, at, weight })
}

/// Replaces references by canonical names and lists every class's descendants.
fn resolve(table: &mut ClassTable, first_new: usize, origins: &[Origin<'_>]) -> Result<(), ClassError> {
    let by_name = &table.by_name;
    let names: Vec<Arc<str>> = table.classes.iter().map(|c| c.name.clone()).collect();
    let find = |name: &Arc<str>| find(by_name, &names, name);
    for (class, origin) in table.classes[first_new..].iter_mut().zip(origins) {
        for parent in &mut class.parents {
            *parent = find(parent).map_err(|e| origin.error(1, e))?;
        }
        for kept in &mut class.kept {
            if let Some(room) = &mut kept.room {
                *room = find(room).map_err(|e| origin.error(9, e))?;
            }
            if let Some((_, at)) = &mut kept.at {
                *at = find(at).map_err(|e| origin.error(9, e))?;
            }
        }
    }
    table.kinds = kinds(table, first_new, origins)?;
    give_roles(table);
    Ok(())
}

/// Gives each class the role of the first listed class that it is a kind of, or else that of its category.
fn give_roles(table: &mut ClassTable) {
    for class in &mut table.classes {
        class.listed = None;
    }
    for (name, role) in ObjectRole::classes() {
        let kinds = table.by_name.get(&key(name)).map_or(&[][..], |&index| table.kinds[index].as_slice());
        for &index in kinds {
            table.classes[index].listed.get_or_insert(role);
        }
    }
    for class in &mut table.classes {
        class.listed = class.listed.or_else(|| ObjectRole::of_category(class.category.as_str()));
    }
}

fn find(by_name: &HashMap<String, usize>, names: &[Arc<str>], name: &str) -> Result<Arc<str>, ClassProblem> {
    let key = key(name);
    by_name.get(&key).map(|&i| names[i].clone()).ok_or_else(|| ClassProblem::NoSuchClass(clip(name)))
}

fn kinds(table: &ClassTable, first_new: usize, origins: &[Origin<'_>]) -> Result<Vec<Vec<usize>>, ClassError> {
    let mut kinds: Vec<Vec<usize>> = (0..table.classes.len()).map(|i| vec![i]).collect();
    let parents_of = |c: &Class| c.parents.iter().filter_map(|p| table.by_name.get(&key(p)).copied()).collect();
    let parents: Vec<Vec<usize>> = table.classes.iter().map(parents_of).collect();
    for class in &table.classes {
        let mut open = parents[class.index].clone();
        let mut seen: Vec<usize> = Vec::new();
        while let Some(index) = open.pop() {
            if index == class.index {
                let origin = &origins[index.saturating_sub(first_new)];
                return Err(origin.error(1, ClassProblem::Cycle(class.name.to_string())));
            }
            if seen.len() > DEEPEST {
                let origin = &origins[class.index.saturating_sub(first_new)];
                return Err(origin.error(1, ClassProblem::TooDeep(class.name.to_string())));
            }
            if !seen.contains(&index) {
                seen.push(index);
                kinds[index].push(class.index);
                open.extend(&parents[index]);
            }
        }
    }
    Ok(kinds)
}
