//! The text form of an action: the action, the character that performs it, and the names of its objects.

use std::str::FromStr;

use super::{Action, ActionTextError, Aim, AimWord, NameMismatch, Verb};
use crate::spelling::{clip, unmarked};
use crate::vocabulary::Word;
use crate::{Label, LabelError, NodeId, SceneGraph};

/// A parsed action with the character that performs it and the names that the text gives its objects.
///
/// ```
/// use vc_graph::{Action, ParsedAction, NodeId, Verb};
/// let parsed: ParsedAction = "<char1> [GRAB] <cup> (12)".parse()?;
/// assert_eq!((parsed.character, parsed.action), (1, Action::one(Verb::Grab, NodeId(12))));
/// assert_eq!(parsed.labels[0].to_string(), "cup.12");
/// assert_eq!("<char1> grab cup.12".parse::<ParsedAction>()?, parsed);
/// # Ok::<(), vc_graph::ActionTextError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParsedAction {
    /// The number of the character, as in `<char1>`; 0 if none is named.
    pub character: u32,
    /// The action.
    pub action: Action,
    /// The labels of the objects as they are written; `#12` has none.
    pub labels: Vec<Label>,
}

impl From<Action> for ParsedAction {
    /// An action of the first character, without labels.
    fn from(action: Action) -> Self {
        Self { character: 0, action, labels: Vec::new() }
    }
}

impl ParsedAction {
    /// Checks that the objects are of the classes in their labels, see [`SceneGraph::check_name`].
    ///
    /// # Errors
    /// The first [`NameMismatch`].
    pub fn check(&self, graph: &SceneGraph) -> Result<(), NameMismatch> {
        self.labels.iter().try_for_each(|label| graph.check_label(label))
    }
}

impl FromStr for ParsedAction {
    type Err = ActionTextError;

    fn from_str(text: &str) -> Result<Self, ActionTextError> {
        let text = unmarked(text).trim();
        let (character, rest) = character(text)?;
        let (action, labels) = if rest.contains('[') { virtualhome(rest)? } else { native(rest)? };
        Ok(Self { character, action, labels })
    }
}

/// Parses the number in `<char1> [GRAB] ...`; returns it and the rest of the text.
fn character(text: &str) -> Result<(u32, &str), ActionTextError> {
    if !text.starts_with('<') {
        return Ok((0, text));
    }
    let bad = || ActionTextError::Notation(clip(text));
    let (name, rest) = text[1..].split_once('>').ok_or_else(bad)?;
    let number = name.trim().strip_prefix("char").ok_or_else(bad)?;
    Ok((number.parse().map_err(|_| bad())?, rest.trim_start()))
}

/// Parses `grab cup.12` and `place cup.12 table.3 at 1.20 0.40`.
fn native(text: &str) -> Result<(Action, Vec<Label>), ActionTextError> {
    let mut words = text.split_whitespace().peekable();
    let verb = Verb::parse(words.next().ok_or(ActionTextError::Empty)?)?;
    let (mut labels, mut things) = (Vec::new(), Vec::new());
    while let Some(word) = words.next_if(|word| !AimWord::is_one(word)) {
        things.push(thing(word, &mut labels)?);
    }
    let aim = Aim::read(words)?;
    Ok((Action::with_aim(verb, &things, aim)?, labels))
}

/// Parses `cup.12` or `#12`.
fn thing(word: &str, labels: &mut Vec<Label>) -> Result<NodeId, LabelError> {
    if let Some(number) = word.strip_prefix('#').and_then(|number| number.parse().ok()) {
        return Ok(NodeId(number));
    }
    let label: Label = word.parse()?;
    let id = label.id;
    labels.push(label);
    Ok(id)
}

/// Parses `[GRAB] <cup> (12)`. In VirtualHome's older form, `(1.12)`, the number after the dot identifies the
/// instance. A number in brackets may follow, `[0]`.
fn virtualhome(text: &str) -> Result<(Action, Vec<Label>), ActionTextError> {
    let bad = || ActionTextError::Notation(clip(text));
    let (verb, mut rest) = text.strip_prefix('[').and_then(|t| t.split_once(']')).ok_or_else(bad)?;
    let unknown = || Verb::parse(verb.trim()).map_err(ActionTextError::Verb);
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

/// Parses `12` or `1.12`, in which the instance number follows the dot.
fn instance(number: &str) -> Option<u32> {
    match number.split_once('.') {
        Some((before, number)) => before.trim().parse::<u32>().ok().and(number.trim().parse().ok()),
        None => number.trim().parse().ok(),
    }
}

/// Whether the text is empty or a number in brackets.
fn is_tail(text: &str) -> bool {
    let number = text.strip_prefix('[').and_then(|t| t.strip_suffix(']'));
    text.is_empty() || number.is_some_and(|n| n.trim().parse::<u32>().is_ok())
}
