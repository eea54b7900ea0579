//! Writing a vocabulary as text.

use std::fmt;

use super::{OwnState, Used, Vocabulary};
use crate::rule::{ActionRule, Motion};
use crate::{Property, Word};

impl Vocabulary {
    /// The own words as lines, from which [`Vocabulary::parse`] makes the same vocabulary: properties, states, verbs and
    /// predicates, each by name.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        let properties = self.properties.iter().map(|property| format!("property {property}"));
        let predicates = self.predicates.iter().map(ToString::to_string);
        properties.chain(self.states.iter().map(state)).chain(self.rules.iter().map(verb)).chain(predicates)
    }
}

impl fmt::Display for Vocabulary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lines().try_for_each(|line| writeln!(f, "{line}"))
    }
}

/// A field with its name, or nothing if it is empty.
fn field(name: &str, text: &str) -> String {
    if text.is_empty() { String::new() } else { format!(" | {name}: {text}") }
}

fn state(own: &OwnState) -> String {
    let needs = own.needs.map_or("", Property::as_str);
    format!("state {}{}{}", own.state, field("excludes", &own.excludes.to_string()), field("needs", needs))
}

fn verb(rule: &ActionRule) -> String {
    let needs = entries(rule.preconditions.iter().map(|need| need.words()));
    let effects = entries(rule.effects.iter().map(|effect| effect.words()));
    let motion = if rule.motion == usual(rule.arity) { "" } else { rule.motion.as_str() };
    let fields = [
        field("needs", &needs),
        field("effects", &effects),
        field("aims", rule.aims.name()),
        field("motion", motion),
        field("says", &rule.description),
    ];
    format!("verb {} {}{}", rule.verb, rule.arity, fields.concat())
}

fn entries(all: impl Iterator<Item = (&'static str, Vec<Used>)>) -> String {
    all.map(|(name, parts)| entry(name, &parts)).collect::<Vec<_>>().join("; ")
}

/// A condition or effect as text.
pub(crate) fn entry(name: &str, parts: &[Used]) -> String {
    let words: Vec<&str> = std::iter::once(name).chain(parts.iter().map(|part| part.as_str())).collect();
    words.join(" ")
}

/// The motion of a verb whose text names none.
pub(super) fn usual(things: usize) -> Motion {
    if things == 0 { Motion::Nothing } else { Motion::Reach }
}
