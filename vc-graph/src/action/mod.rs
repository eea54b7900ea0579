//! An agent's actions and their text forms.

mod aim;
mod named;
mod names;
mod text;
mod verb;

use std::fmt;

use crate::rule::table::RULES;
use crate::spelling::takes_and_given;
use crate::{NodeId, SceneGraph, Word};

pub use aim::{Aim, AimError, AimPart, AimPoint, AimWord, Heading, Side};
pub use names::{NameMismatch, ObjectNames};
pub use text::ParsedAction;
pub use verb::Verb;

/// A verb with the objects that it acts on, and perhaps an [`Aim`] that says where and how.
///
/// Prints with plain numbers, `grab #12`; [`Action::describe`] adds the classes, `grab cup.12`. Both forms can
/// be parsed. An action parsed from labels is refused if an object is not of the class in its label: see
/// [`ObjectNames`].
///
/// ```
/// use vc_graph::{Action, NodeId, Verb};
/// let action: Action = "put_in cup.12 dishwasher.3".parse()?;
/// assert_eq!(action, Action::two(Verb::PutIn, NodeId(12), NodeId(3)));
/// assert_eq!("[PUTIN] <cup> (12) <dishwasher> (3)".parse::<Action>()?, action);
/// # Ok::<(), vc_graph::ActionTextError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Action {
    /// The verb.
    pub verb: Verb,
    /// The object acted on.
    pub object: Option<NodeId>,
    /// The second object: the tool, the surface or the container.
    pub target: Option<NodeId>,
    /// Where and how it is done, as far as it says.
    pub aim: Aim,
    /// The names of the objects in the text that the action was parsed from.
    pub called: ObjectNames,
}

/// An error in the text of an action.
///
/// ```
/// use vc_graph::Action;
/// let error = "grab".parse::<Action>().unwrap_err();
/// assert!(error.to_string().contains("grab"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ActionTextError {
    /// The text is empty.
    #[error("an action begins with a verb, as in `grab cup.12`")]
    Empty,
    /// An unknown verb.
    #[error(transparent)]
    Verb(#[from] crate::vocabulary::UnknownWord),
    /// A badly written object.
    #[error(transparent)]
    Label(#[from] crate::LabelError),
    /// Too few or too many objects.
    #[error("`{verb}` takes {}{}", takes_and_given(*.takes, *.given), missing(*.verb, *.given))]
    Arity {
        /// The verb.
        verb: Verb,
        /// How many objects it takes.
        takes: usize,
        /// How many objects are given.
        given: usize,
    },
    /// A badly written aim, or one with numbers that no aim has.
    #[error(transparent)]
    Aim(#[from] AimError),
    /// Malformed VirtualHome notation.
    #[error("`{0}` is not of the form `[VERB] <class> (number)`")]
    Notation(String),
    /// The text names a character although it should contain only an action.
    #[error("an action names no character such as `<char{0}>`; only a program's line may")]
    Character(u32),
    /// A verb that VirtualHome does not have.
    #[error("VirtualHome has no verb for `{0}`")]
    NotInVirtualHome(Verb),
    /// An action with an aim, which VirtualHome's notation cannot say.
    #[error("VirtualHome's notation has no points, headings, seats, slots or sides: leave `{0}` out")]
    AimNotInVirtualHome(String),
}

/// An example of what a text without a thing lacks.
fn missing(verb: Verb, given: usize) -> String {
    if given > 0 {
        return String::new();
    }
    let at_point = AimPoint::new(1.2, 0.4, None).is_ok_and(|point| {
        let aim = Aim::NOTHING.with_point(point);
        RULES.get(verb.index()).is_some_and(|rule| rule.aims.stands_for_object(&aim))
    });
    let things = ["", " cup.12", " cup.12 table.3"][verb.arity().min(2)];
    let point = if at_point { format!(", or a point as in `{verb} at 1.20 0.40`") } else { String::new() };
    format!(": write its class and number, as in `{verb}{things}`{point}")
}

impl Action {
    /// An action without objects: `stand`.
    pub const fn zero(verb: Verb) -> Self {
        Self { verb, object: None, target: None, aim: Aim::NOTHING, called: ObjectNames::NOTHING }
    }

    /// An action on one object: `grab #12`.
    pub const fn one(verb: Verb, object: NodeId) -> Self {
        Self { object: Some(object), ..Self::zero(verb) }
    }

    /// An action on two objects: `place #12 #3`.
    ///
    /// ```
    /// use vc_graph::{Action, NodeId, Verb};
    /// let place = Action::two(Verb::Place, NodeId(4), NodeId(2));
    /// assert_eq!(place, "place apple.4 kitchen_table.2".parse()?);
    /// assert_eq!(place.things().collect::<Vec<_>>(), [NodeId(4), NodeId(2)]);
    /// # Ok::<(), vc_graph::ActionTextError>(())
    /// ```
    pub const fn two(verb: Verb, object: NodeId, target: NodeId) -> Self {
        Self { object: Some(object), target: Some(target), ..Self::zero(verb) }
    }

    /// An action on the given objects.
    ///
    /// ```
    /// use vc_graph::{Action, NodeId, Verb};
    /// assert_eq!(Action::with(Verb::Grab, &[NodeId(3)])?, Action::one(Verb::Grab, NodeId(3)));
    /// assert!(Action::with(Verb::Grab, &[]).is_err());
    /// # Ok::<(), vc_graph::ActionTextError>(())
    /// ```
    ///
    /// # Errors
    /// [`ActionTextError::Arity`] if the verb takes another number of objects.
    pub fn with(verb: Verb, things: &[NodeId]) -> Result<Self, ActionTextError> {
        Self::with_aim(verb, things, Aim::NOTHING)
    }

    /// An action on the given objects with an aim, which may stand for the only object: `walk at 3.20 1.50`.
    ///
    /// # Errors
    /// As [`Self::with`]. The transition rule judges whether the verb takes the aim.
    pub fn with_aim(verb: Verb, things: &[NodeId], aim: Aim) -> Result<Self, ActionTextError> {
        let (takes, given) = (verb.arity(), things.len());
        // VirtualHome writes `[SLEEP]` and `[SLEEP] <bed> (1)` alike.
        let optional = matches!(verb, Verb::Sleep | Verb::WakeUp | Verb::Stand | Verb::Leave) && given <= 1;
        let builtin = RULES.get(verb.index());
        // Which aims an own verb takes, its scene knows.
        let aimed =
            given == 0 && builtin.map_or(takes == 1 && !aim.is_nothing(), |rule| rule.aims.stands_for_object(&aim));
        if takes != given && !optional && !aimed {
            return Err(ActionTextError::Arity { verb, takes, given });
        }
        let (object, target) = (things.first().copied(), things.get(1).copied());
        Ok(Self { object: object.filter(|_| takes > 0), target, aim, ..Self::zero(verb) })
    }

    /// The action with another aim.
    #[must_use]
    pub const fn aimed(self, aim: Aim) -> Self {
        Self { aim, ..self }
    }

    /// The action at a point of the world, metres: where a thing is put, or where somebody goes.
    ///
    /// # Errors
    /// [`AimError::OutOfRange`].
    pub fn at(self, x: f64, y: f64) -> Result<Self, AimError> {
        Ok(self.aimed(self.aim.with_point(AimPoint::new(x, y, None)?)))
    }

    /// As [`Self::at`], with the height of the point, metres: on this shelf, up there.
    ///
    /// # Errors
    /// [`AimError::OutOfRange`].
    pub fn at_height(self, x: f64, y: f64, z: f64) -> Result<Self, AimError> {
        Ok(self.aimed(self.aim.with_point(AimPoint::new(x, y, Some(z))?)))
    }

    /// The action with a heading, degrees counter-clockwise from the world's X.
    ///
    /// # Errors
    /// [`AimError::OutOfRange`].
    pub fn turned(self, degrees: f64) -> Result<Self, AimError> {
        Ok(self.aimed(self.aim.with_heading(Heading::new(degrees)?)))
    }

    /// The action on a place to sit, counted from 1.
    #[must_use]
    pub fn on_seat(self, number: u16) -> Self {
        self.aimed(self.aim.with_part(AimPart::Seat(number)))
    }

    /// The action on a shelf, drawer, rack or burner, counted from 1.
    #[must_use]
    pub fn in_slot(self, number: u16) -> Self {
        self.aimed(self.aim.with_part(AimPart::Slot(number)))
    }

    /// The action by a side of the thing.
    #[must_use]
    pub fn by_side(self, side: Side) -> Self {
        self.aimed(self.aim.with_part(AimPart::Side(side)))
    }

    /// The objects that the action acts on.
    pub fn things(&self) -> impl Iterator<Item = NodeId> {
        self.object.into_iter().chain(self.target)
    }

    /// The action with the classes of its objects: `grab cup.12`.
    ///
    /// ```
    /// use vc_graph::{Action, Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// let action: Action = "grab #3".parse()?;
    /// assert_eq!(action.describe(&graph).to_string(), "grab apple.3");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn describe<'a>(&'a self, graph: &'a SceneGraph) -> impl fmt::Display + 'a {
        Described { action: self, graph }
    }

    /// The action in VirtualHome's notation, `[GRAB] <cup> (12)`, with the classes
    /// as the scene's author spelled them.
    ///
    /// ```
    /// use vc_graph::{Action, Draft, SceneBuilder, Verb};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// let action = Action::one(Verb::Grab, apple);
    /// assert_eq!(action.to_virtualhome(&graph)?, "[GRAB] <apple> (3)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ActionTextError::NotInVirtualHome`], [`ActionTextError::AimNotInVirtualHome`].
    pub fn to_virtualhome(&self, graph: &SceneGraph) -> Result<String, ActionTextError> {
        if !self.aim.is_nothing() {
            return Err(ActionTextError::AimNotInVirtualHome(self.aim.to_string().trim_start().to_owned()));
        }
        let verb = self.verb.virtualhome().ok_or(ActionTextError::NotInVirtualHome(self.verb))?;
        let spelled = |id| graph.node(id).map_or("unknown", |n| &n.spec().spelling);
        let things = self.things().map(|id| format!(" <{}> ({})", spelled(id), id.0));
        Ok(format!("[{verb}]{}", things.collect::<String>()))
    }
}

struct Described<'a> {
    action: &'a Action,
    graph: &'a SceneGraph,
}

impl fmt::Display for Described<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.action.verb)?;
        self.action.things().try_for_each(|id| write!(f, " {}", self.graph.label(id)))?;
        write!(f, "{}", self.action.aim)
    }
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.verb)?;
        self.things().try_for_each(|id| write!(f, " {id}"))?;
        write!(f, "{}", self.aim)
    }
}

impl std::str::FromStr for Action {
    type Err = ActionTextError;

    fn from_str(text: &str) -> Result<Self, ActionTextError> {
        let parsed: ParsedAction = text.parse()?;
        match parsed.character {
            0 => Ok(Self { called: ObjectNames::from_labels(&parsed.action, &parsed.labels), ..parsed.action }),
            someone => Err(ActionTextError::Character(someone)),
        }
    }
}

impl serde::Serialize for Action {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Action {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
