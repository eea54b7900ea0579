//! Numbered things with names of their own: cameras and sensors.

use std::collections::BTreeMap;

use vc_graph::nearest;

use super::CameraError;

/// Longest name, bytes.
const LONGEST: usize = 100;

/// A thing with a name.
pub(crate) trait Named {
    /// The kind in messages, such as `camera`.
    const KIND: &'static str;
    /// The name.
    fn name(&self) -> &str;
}

/// Things by number, which is never given again, with names that differ.
#[derive(Debug, Clone)]
pub(crate) struct Register<T> {
    next: u32,
    all: BTreeMap<u32, T>,
}

impl<T> Default for Register<T> {
    fn default() -> Self {
        Self { next: 0, all: BTreeMap::new() }
    }
}

impl<T: Named> Register<T> {
    /// A register of things that have numbers already.
    pub(super) fn of(next: u32, all: BTreeMap<u32, T>) -> Self {
        let past = all.last_key_value().map_or(0, |(last, _)| last.saturating_add(1));
        Self { next: next.max(past), all }
    }

    pub(crate) fn next(&self) -> u32 {
        self.next
    }

    /// All with their numbers, in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (u32, &T)> {
        self.all.iter().map(|(number, item)| (*number, item))
    }

    pub(crate) fn get(&self, number: u32) -> Option<&T> {
        self.all.get(&number)
    }

    pub(crate) fn get_mut(&mut self, number: u32) -> Option<&mut T> {
        self.all.get_mut(&number)
    }

    pub(crate) fn remove(&mut self, number: u32) -> Option<T> {
        self.all.remove(&number)
    }

    /// Adds something with a name of its own; `others` are names that are taken besides, and `first` is the least number.
    pub(crate) fn add(&mut self, first: u32, others: &[String], item: T) -> Result<u32, CameraError> {
        self.check_name(item.name(), others)?;
        let number = self.next.max(first);
        self.next = number.checked_add(1).ok_or(CameraError::TooMany(T::KIND))?;
        self.all.insert(number, item);
        Ok(number)
    }

    fn check_name(&self, name: &str, others: &[String]) -> Result<(), CameraError> {
        if name.trim() != name || name.is_empty() || name.len() > LONGEST || name.chars().any(char::is_control) {
            return Err(CameraError::BadName { kind: T::KIND, most: LONGEST });
        }
        let taken = |name: &str| self.names(others).any(|known| known == name);
        if !taken(name) {
            return Ok(());
        }
        let free = (2..).map(|i: u32| format!("{name} {i}")).find(|other| !taken(other)).unwrap_or_default();
        Err(CameraError::NameTaken { kind: T::KIND, name: name.to_owned(), free })
    }

    fn names<'a>(&'a self, others: &'a [String]) -> impl Iterator<Item = &'a str> {
        self.all.values().map(T::name).chain(others.iter().map(String::as_str))
    }

    /// The number of a name.
    pub(crate) fn find(&self, name: &str) -> Option<u32> {
        self.iter().find(|(_, item)| item.name() == name).map(|(number, _)| number)
    }

    /// The error about a name that nothing has.
    pub(crate) fn unknown(&self, name: &str, others: &[String]) -> CameraError {
        let nearest = nearest(name, self.names(others)).into_iter().map(str::to_owned).collect();
        CameraError::NoSuchName { kind: T::KIND, name: name.chars().take(LONGEST).collect(), nearest }
    }
}
