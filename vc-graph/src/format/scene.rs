//! Reading a scene in any supported format, which is recognised by the structure of the JSON.

use std::fmt;
use std::sync::Arc;

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::{FormatError, FormatProblem, eai, native, thesis, unmarked, virtualhome};
use crate::{ClassTable, SceneGraph};

/// Reads a scene in any supported format: VirtualCity's, the thesis's, VirtualHome's, or a pair of VirtualHome
/// graphs before and after a program, of which the first is read.
///
/// ```
/// use vc_graph::format::{native, read_scene, virtualhome};
/// use vc_graph::{ClassTable, Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let classes = ClassTable::builtin();
/// assert_eq!(read_scene(&native::write(&graph), &classes)?.len(), 3);
/// assert_eq!(read_scene(&virtualhome::write(&graph), &classes)?.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The [`FormatError`] of the most similar format; for a text that is no JSON, one that names the known formats.
pub fn read_scene(text: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, FormatError> {
    if !unmarked(text).trim_start().starts_with(['{', '[']) {
        let problem = Box::new(unknown(text.trim().is_empty()));
        return Err(FormatError { format: "scene", line: None, field: String::new(), problem });
    }
    let mut outline = Outline::default();
    let mut json = serde_json::Deserializer::from_str(unmarked(text));
    // If the scan ends early, the outline has the keys up to that point.
    let _ = Scan { outline: &mut outline, top: true }.deserialize(&mut json);
    outline.reader()(text, classes)
}

fn unknown(empty: bool) -> FormatProblem {
    let formats = "VirtualCity's scenes, VirtualHome's graphs and the thesis's scenes";
    let fault = if empty { "the text is empty" } else { "the text is no scene in any known format" };
    FormatProblem::Shape(format!("{fault}; scenes are the JSON of {formats}"))
}

type Reader = fn(&str, &Arc<ClassTable>) -> Result<SceneGraph, FormatError>;

/// The structure by which formats are recognised: the top-level keys, and for each whether its value is a list
/// and the keys of the first object below it.
#[derive(Default)]
struct Outline {
    keys: Vec<(String, bool, Vec<String>)>,
}

impl Outline {
    /// Returns an error, which ends the scan, as soon as the last key determines the format.
    fn check_decided<E: Error>(&self) -> Result<(), E> {
        let known = |key: &String| key == "class_name" || key == "transform";
        let decided = self
            .keys
            .last()
            .is_some_and(|(name, list, below)| name == "virtualcity" && !list || below.iter().any(known));
        if decided { Err(E::custom("decided")) } else { Ok(()) }
    }

    fn reader(&self) -> Reader {
        let has = |key: &str| self.keys.iter().any(|(name, ..)| name == key);
        let no_list = |key: &str| self.keys.iter().any(|(name, list, _)| name == key && !list);
        let below =
            |any: &[&str]| self.keys.iter().flat_map(|(.., below)| below).any(|key| any.contains(&key.as_str()));
        match self.keys.as_slice() {
            _ if no_list("virtualcity") => native::read,
            _ if no_list("init_graph") || no_list("final_graph") => eai::read_start,
            // A scene of the thesis has a single key, its name, which is arbitrary.
            [(_, true, objects)] if objects.is_empty() || below(&["name", "transform"]) => thesis::read,
            _ if has("nodes") || has("edges") || below(&["class_name"]) => virtualhome::read,
            _ => thesis::read,
        }
    }
}

/// A scan of a value, at the top level or below.
struct Scan<'o> {
    outline: &'o mut Outline,
    top: bool,
}

impl<'de> DeserializeSeed<'de> for Scan<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, json: D) -> Result<(), D::Error> {
        json.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Scan<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if self.top {
                self.outline.keys.push((key, false, Vec::new()));
                map.next_value_seed(Scan { outline: &mut *self.outline, top: false })?;
                self.outline.check_decided::<A::Error>()?;
            } else {
                if let Some((.., below)) = self.outline.keys.last_mut() {
                    below.push(key);
                }
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        match self.outline.keys.last_mut() {
            Some((_, list, _)) => *list = true,
            // A top-level list counts as a key without a name.
            None => self.outline.keys.push((String::new(), true, Vec::new())),
        }
        seq.next_element_seed(Scan { outline: &mut *self.outline, top: false })?;
        self.outline.check_decided::<A::Error>()?;
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(())
    }

    fn visit_bool<E>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_i64<E>(self, _: i64) -> Result<(), E> {
        Ok(())
    }

    fn visit_u64<E>(self, _: u64) -> Result<(), E> {
        Ok(())
    }

    fn visit_f64<E>(self, _: f64) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }
}
