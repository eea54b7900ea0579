//! Deeds as they are written: an action, the character that does it, and the names of its things.

use std::str::FromStr;

use crate::format::unmarked;
use crate::vocabulary::{Word, clip};
use crate::{Action, ActionError, BadLabel, Label, Misnomer, NodeId, SceneGraph, Verb};

/// An action as a text has it: with the character that does it, and the names that its things have there.
///
/// ```
/// use vc_graph::{Action, Deed, NodeId, Verb};
/// let deed: Deed = "<char1> [GRAB] <cup> (12)".parse()?;
/// assert_eq!((deed.character, deed.action), (1, Action::one(Verb::Grab, NodeId(12))));
/// assert_eq!(deed.labels[0].to_string(), "cup.12");
/// assert_eq!("<char1> grab cup.12".parse::<Deed>()?, deed);
/// # Ok::<(), vc_graph::ActionError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deed {
    /// The number of the character that does it, as in `<char1>`; 0 where none is named.
    pub character: u32,
    /// The action.
    pub action: Action,
    /// The labels of its things as they are written; `#12` has none.
    pub labels: Vec<Label>,
}

impl From<Action> for Deed {
    /// A deed of the first character, without labels.
    fn from(action: Action) -> Self {
        Self { character: 0, action, labels: Vec::new() }
    }
}

impl Deed {
    /// Checks that the things are of the classes in their labels, see [`SceneGraph::check_name`].
    ///
    /// # Errors
    /// The first [`Misnomer`].
    pub fn check(&self, graph: &SceneGraph) -> Result<(), Misnomer> {
        self.labels.iter().try_for_each(|label| graph.check_label(label))
    }
}

impl FromStr for Deed {
    type Err = ActionError;

    fn from_str(text: &str) -> Result<Self, ActionError> {
        let text = unmarked(text).trim();
        let (character, deed) = character(text)?;
        let (action, labels) = if deed.contains('[') { virtualhome(deed)? } else { native(deed)? };
        Ok(Self { character, action, labels })
    }
}

/// The number in front of `<char1> [GRAB] ...`, and the rest.
fn character(text: &str) -> Result<(u32, &str), ActionError> {
    if !text.starts_with('<') {
        return Ok((0, text));
    }
    let bad = || ActionError::Notation(clip(text));
    let (name, rest) = text[1..].split_once('>').ok_or_else(bad)?;
    let number = name.trim().strip_prefix("char").ok_or_else(bad)?;
    Ok((number.parse().map_err(|_| bad())?, rest.trim_start()))
}

/// `grab cup.12`.
fn native(text: &str) -> Result<(Action, Vec<Label>), ActionError> {
    let mut words = text.split_whitespace();
    let verb = Verb::parse(words.next().ok_or(ActionError::Empty)?)?;
    let mut labels = Vec::new();
    let things = words.map(|word| thing(word, &mut labels)).collect::<Result<Vec<NodeId>, BadLabel>>()?;
    Ok((Action::with(verb, &things)?, labels))
}

/// `cup.12` or `#12`.
fn thing(word: &str, labels: &mut Vec<Label>) -> Result<NodeId, BadLabel> {
    if let Some(number) = word.strip_prefix('#').and_then(|number| number.parse().ok()) {
        return Ok(NodeId(number));
    }
    let label: Label = word.parse()?;
    let id = label.id;
    labels.push(label);
    Ok(id)
}

/// `[GRAB] <cup> (12)`; numbers as `(1.12)`, VirtualHome's older form, name the
/// instance after the dot. A number in brackets may follow, `[0]`.
fn virtualhome(text: &str) -> Result<(Action, Vec<Label>), ActionError> {
    let bad = || ActionError::Notation(clip(text));
    let (verb, mut rest) = text.strip_prefix('[').and_then(|t| t.split_once(']')).ok_or_else(bad)?;
    let unknown = || Verb::parse(verb.trim()).map_err(ActionError::Verb);
    let verb = Verb::from_virtualhome(verb.trim()).map_or_else(unknown, Ok)?;
    let mut labels: Vec<Label> = Vec::new();
    while let Some((name, after)) = rest.split_once('(') {
        let name = name.trim().strip_prefix('<').ok_or_else(bad)?;
        let (number, tail) = after.split_once(')').ok_or_else(bad)?;
        let id = instance(number).map(NodeId).ok_or_else(bad)?;
        labels.push(Label { class: name.trim_end_matches('>').trim().into(), id });
        rest = tail;
    }
    let things: Vec<NodeId> = labels.iter().map(|label| label.id).collect();
    if things.len() > 2 || !is_tail(rest.trim()) { Err(bad()) } else { Ok((Action::with(verb, &things)?, labels)) }
}

/// `12`, or `1.12`, where the instance comes after the dot.
fn instance(number: &str) -> Option<u32> {
    match number.split_once('.') {
        Some((before, number)) => before.trim().parse::<u32>().ok().and(number.trim().parse().ok()),
        None => number.trim().parse().ok(),
    }
}

/// Nothing, or a number in brackets.
fn is_tail(text: &str) -> bool {
    let number = text.strip_prefix('[').and_then(|t| t.strip_suffix(']'));
    text.is_empty() || number.is_some_and(|n| n.trim().parse::<u32>().is_ok())
}
