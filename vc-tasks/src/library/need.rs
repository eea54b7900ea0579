//! The objects that a task needs, and where they may be at its start.

use std::fmt;
use std::str::FromStr;

use vc_graph::{Relation, State, UnknownWord, Word};

/// Objects of one class that must be in the scene, written `2 plate [dirty] on dining_table | in
/// kitchen_cabinet of kitchen`.
///
/// ```
/// use vc_tasks::library::Need;
/// let need: Need = "2 plate [dirty] on dining_table | in dishwasher of kitchen".parse()?;
/// assert_eq!((need.number, &*need.class, need.spots.len()), (2, "plate", 2));
/// assert_eq!(need.to_string(), "2 plate [dirty] on dining_table | in dishwasher of kitchen");
/// # Ok::<(), vc_tasks::library::NeedError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Need {
    /// The class of the objects.
    pub class: String,
    /// The number of objects.
    pub number: usize,
    /// The states they are in.
    pub states: Vec<State>,
    /// The allowed placements; if empty, the habitual places of the class.
    pub spots: Vec<PlacementSpec>,
}

/// A kind of placement for an object.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacementSpec {
    /// The relation and the class of the support or container; `None` for anywhere in the room.
    pub at: Option<(Relation, String)>,
    /// The class of the room; `None` for any room.
    pub room: Option<String>,
}

/// A text that cannot be parsed as a [`Need`].
///
/// ```
/// use vc_tasks::library::{Need, NeedProblem};
/// let error = "2 plate [dirtyy]".parse::<Need>().unwrap_err();
/// assert!(matches!(error.why, NeedProblem::State(_)));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a need such as `2 plate [dirty] on dining_table of kitchen`: {why}")]
pub struct NeedError {
    /// The text.
    pub text: String,
    /// The reason.
    #[source]
    pub why: NeedProblem,
}

/// The reason why a text is not a [`Need`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NeedProblem {
    /// The list of states is not closed.
    #[error("`[` without `]`")]
    OpenBracket,
    /// The first of two words is not a number.
    #[error("`{0}` is no number")]
    Number(String),
    /// There are no words, or more than two.
    #[error("expected a number and a class")]
    Words,
    /// A state is unknown.
    #[error(transparent)]
    State(#[from] UnknownWord),
    /// A placement is not written as one.
    #[error("`{0}` is no place such as `on desk`, `in fridge of kitchen` or `of kitchen`")]
    Place(String),
}

impl Need {
    /// Objects of a class in their habitual places.
    pub fn new(class: impl Into<String>, number: usize) -> Self {
        Self { class: class.into(), number, states: Vec::new(), spots: Vec::new() }
    }
}

impl FromStr for Need {
    type Err = NeedError;

    fn from_str(text: &str) -> Result<Self, NeedError> {
        read(text).map_err(|why| NeedError { text: text.to_owned(), why })
    }
}

fn read(text: &str) -> Result<Need, NeedProblem> {
    let (head, states, tail) = match text.split_once('[') {
        Some((head, rest)) => {
            let (states, tail) = rest.split_once(']').ok_or(NeedProblem::OpenBracket)?;
            (head, states, tail)
        }
        None => {
            let words = [" on ", " in ", " of "].into_iter().filter_map(|word| text.find(word));
            let (head, tail) = text.split_at(words.min().unwrap_or(text.len()));
            (head, "", tail)
        }
    };
    let words: Vec<&str> = head.split_whitespace().collect();
    let (number, class) = match words.as_slice() {
        [class] => (1, *class),
        [number, class] => (number.parse().map_err(|_| NeedProblem::Number((*number).to_owned()))?, *class),
        _ => return Err(NeedProblem::Words),
    };
    let states: Result<Vec<State>, _> = states.split_whitespace().map(State::parse).collect();
    let spots = tail.split('|').map(str::trim).filter(|spot| !spot.is_empty()).map(read_spot);
    Ok(Need { class: class.to_owned(), number, states: states?, spots: spots.collect::<Result<_, _>>()? })
}

fn read_spot(text: &str) -> Result<PlacementSpec, NeedProblem> {
    let own = |class: &str| Some(class.to_owned());
    match *text.split_whitespace().collect::<Vec<_>>() {
        ["on", at] => Ok(PlacementSpec { at: Some((Relation::On, at.to_owned())), room: None }),
        ["in", at] => Ok(PlacementSpec { at: Some((Relation::Inside, at.to_owned())), room: None }),
        ["on", at, "of", room] => Ok(PlacementSpec { at: Some((Relation::On, at.to_owned())), room: own(room) }),
        ["in", at, "of", room] => Ok(PlacementSpec { at: Some((Relation::Inside, at.to_owned())), room: own(room) }),
        ["of", room] => Ok(PlacementSpec { at: None, room: own(room) }),
        _ => Err(NeedProblem::Place(text.to_owned())),
    }
}

impl fmt::Display for PlacementSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = self.at.as_ref().map(|(relation, class)| {
            let word = if *relation == Relation::Inside { "in" } else { "on" };
            format!("{word} {class}")
        });
        let room = self.room.as_ref().map(|room| format!("of {room}"));
        let parts: Vec<String> = at.into_iter().chain(room).collect();
        f.write_str(&parts.join(" "))
    }
}

impl fmt::Display for Need {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.number != 1 {
            write!(f, "{} ", self.number)?;
        }
        f.write_str(&self.class)?;
        if !self.states.is_empty() {
            let states: Vec<&str> = self.states.iter().map(|s| s.as_str()).collect();
            write!(f, " [{}]", states.join(" "))?;
        }
        let spots: Vec<String> = self.spots.iter().map(PlacementSpec::to_string).collect();
        if spots.is_empty() { Ok(()) } else { write!(f, " {}", spots.join(" | ")) }
    }
}

impl serde::Serialize for Need {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Need {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
