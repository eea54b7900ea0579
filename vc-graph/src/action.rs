//! What an agent can do, and how it is written.

use std::fmt;

use crate::called::Called;
use crate::vocabulary::{same_word, vocabulary};
use crate::{Deed, NodeId, SceneGraph};

vocabulary! {
    /// A verb. [`Verb::rule`](crate::Verb::rule) says what each needs and does.
    Verb, "verb" {
        /// Go to a room or a thing, seen or not: the rule knows where everything is.
        Walk = "walk",
        /// Go there fast.
        Run = "run",
        /// Go to a thing unless it is near, seen or not.
        Find = "find",
        /// Turn towards a thing.
        TurnTo = "turn_to",
        /// Look at a thing one faces.
        LookAt = "look_at",
        /// Point at a thing one faces.
        PointAt = "point_at",
        /// Watch a screen or picture.
        Watch = "watch",
        /// Take a thing into a free hand.
        Grab = "grab",
        /// Put a held thing on a surface.
        Place = "place",
        /// Put a held thing into a container.
        PutIn = "put_in",
        /// Put a held thing back where it was taken from.
        PutBack = "put_back",
        /// Let a held thing go; it lands in the room.
        Drop = "drop",
        /// Open a door, lid or cover.
        Open = "open",
        /// Close it.
        Close = "close",
        /// Switch on.
        SwitchOn = "switch_on",
        /// Switch off.
        SwitchOff = "switch_off",
        /// Put the plug into a socket.
        PlugIn = "plug_in",
        /// Pull the plug.
        PlugOut = "plug_out",
        /// Sit down on something.
        Sit = "sit",
        /// Lie down on something.
        Lie = "lie",
        /// Stand up.
        Stand = "stand",
        /// Fall asleep, seated or lying.
        Sleep = "sleep",
        /// Wake up.
        WakeUp = "wake_up",
        /// Eat something, or what is on it.
        Eat = "eat",
        /// Drink something, or what is in it.
        Drink = "drink",
        /// Touch a thing.
        Touch = "touch",
        /// Read something held.
        Read = "read",
        /// Wipe a thing with something held.
        Wipe = "wipe",
        /// Wash a thing.
        Wash = "wash",
        /// Rinse anything near, with nothing.
        Rinse = "rinse",
        /// Scrub a thing.
        Scrub = "scrub",
        /// Pour what is held into something.
        Pour = "pour",
        /// Fill a held vessel at running water.
        Fill = "fill",
        /// Cut food with a knife in hand.
        Cut = "cut",
        /// Cook what is on or in a heater that is on.
        Cook = "cook",
        /// Put on clothes that are held.
        Wear = "wear",
        /// Take worn clothes off, into a hand.
        TakeOff = "take_off",
        /// Fold cloth or paper.
        Fold = "fold",
        /// Spread it out.
        Unfold = "unfold",
        /// Push a thing.
        Push = "push",
        /// Pull a thing.
        Pull = "pull",
        /// Move a thing a little.
        Move = "move",
        /// Squeeze a thing.
        Squeeze = "squeeze",
        /// Type on a keyboard, or on anything with a switch.
        Type = "type",
        /// Greet a person.
        Greet = "greet",
        /// Play an instrument, game or toy.
        Play = "play",
        /// Get into a vehicle.
        Enter = "enter",
        /// Get out of the vehicle one is in.
        Leave = "leave",
        /// Drive the vehicle one is in to a place.
        Drive = "drive",
        /// Dance.
        Dance = "dance",
        /// Wave.
        Wave = "wave",
        /// Do exercises.
        Exercise = "exercise",
        /// Stretch.
        Stretch = "stretch",
        /// Smile.
        Smile = "smile",
        /// Heat what is on or in a heater that is on.
        Heat = "heat",
        /// Cool what is in a cooler that is on.
        Cool = "cool",
        /// Dry a thing with a cloth held.
        Dry = "dry",
        /// Make a thing dirty.
        Soil = "soil",
    }
}

/// VirtualHome's name of each verb it has, and other spellings that are read.
const VIRTUALHOME: &[(Verb, &str)] = &[
    (Verb::Walk, "WALK"),
    (Verb::Run, "RUN"),
    (Verb::Find, "FIND"),
    (Verb::TurnTo, "TURNTO"),
    (Verb::LookAt, "LOOKAT"),
    (Verb::PointAt, "POINTAT"),
    (Verb::Watch, "WATCH"),
    (Verb::Grab, "GRAB"),
    (Verb::Place, "PUTBACK"),
    (Verb::PutIn, "PUTIN"),
    (Verb::PutBack, "PUTOBJBACK"),
    (Verb::Drop, "DROP"),
    (Verb::Drop, "RELEASE"),
    (Verb::Open, "OPEN"),
    (Verb::Close, "CLOSE"),
    (Verb::SwitchOn, "SWITCHON"),
    (Verb::SwitchOff, "SWITCHOFF"),
    (Verb::PlugIn, "PLUGIN"),
    (Verb::PlugOut, "PLUGOUT"),
    (Verb::Sit, "SIT"),
    (Verb::Lie, "LIE"),
    (Verb::Stand, "STANDUP"),
    (Verb::Sleep, "SLEEP"),
    (Verb::WakeUp, "WAKEUP"),
    (Verb::Eat, "EAT"),
    (Verb::Drink, "DRINK"),
    (Verb::Touch, "TOUCH"),
    (Verb::Read, "READ"),
    (Verb::Wipe, "WIPE"),
    (Verb::Wash, "WASH"),
    (Verb::Rinse, "RINSE"),
    (Verb::Scrub, "SCRUB"),
    (Verb::Pour, "POUR"),
    (Verb::Cut, "CUT"),
    (Verb::Wear, "PUTON"),
    (Verb::TakeOff, "PUTOFF"),
    (Verb::Push, "PUSH"),
    (Verb::Pull, "PULL"),
    (Verb::Move, "MOVE"),
    (Verb::Squeeze, "SQUEEZE"),
    (Verb::Type, "TYPE"),
    (Verb::Greet, "GREET"),
];

impl Verb {
    /// VirtualHome's name of the verb, `SWITCHON`; `None` if it has none.
    pub fn virtualhome(self) -> Option<&'static str> {
        VIRTUALHOME.iter().find(|(verb, _)| *verb == self).map(|(_, name)| *name)
    }

    /// The verb of a VirtualHome name. Note that its `PUTBACK` is to place on.
    pub fn from_virtualhome(name: &str) -> Option<Self> {
        VIRTUALHOME.iter().find(|(_, other)| same_word(other, name)).map(|(verb, _)| *verb)
    }

    /// How many things the verb takes, 0 to 2.
    pub fn arity(self) -> usize {
        self.rule().arity
    }
}

/// A verb with the things it is done to.
///
/// Prints with plain numbers, `grab #12`; [`Action::describe`] adds the classes,
/// `grab cup.12`. Both read back. An action that is read with labels is refused
/// where a thing is not what its label says: [`Called`].
///
/// ```
/// use vc_graph::{Action, NodeId, Verb};
/// let action: Action = "put_in cup.12 dishwasher.3".parse()?;
/// assert_eq!(action, Action::two(Verb::PutIn, NodeId(12), NodeId(3)));
/// assert_eq!("[PUTIN] <cup> (12) <dishwasher> (3)".parse::<Action>()?, action);
/// # Ok::<(), vc_graph::ActionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Action {
    /// What is done.
    pub verb: Verb,
    /// What it is done to.
    pub object: Option<NodeId>,
    /// With, on or into what.
    pub target: Option<NodeId>,
    /// The names of its things in the text it was read from.
    pub called: Called,
}

/// Text that is no action.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ActionError {
    /// Nothing there.
    #[error("an action begins with a verb, as in `grab cup.12`")]
    Empty,
    /// An unknown verb.
    #[error(transparent)]
    Verb(#[from] crate::vocabulary::UnknownWord),
    /// A thing that is not written as one.
    #[error(transparent)]
    Label(#[from] crate::BadLabel),
    /// Too few or too many things.
    #[error("`{verb}` takes {takes} things, {given} are given")]
    Arity {
        /// The verb.
        verb: Verb,
        /// How many it takes.
        takes: usize,
        /// How many there are.
        given: usize,
    },
    /// VirtualHome notation that is not well formed.
    #[error("`{0}` is not of the form `[VERB] <class> (number)`")]
    Notation(String),
    /// A character is named where only an action is asked for.
    #[error("an action does not say who acts, as `<char{0}>` does; a program's line may")]
    Character(u32),
    /// A verb that VirtualHome does not know.
    #[error("VirtualHome has no verb for `{0}`")]
    NotInVirtualHome(Verb),
}

impl Action {
    /// An action on nothing: `stand`.
    pub const fn zero(verb: Verb) -> Self {
        Self { verb, object: None, target: None, called: Called::NOTHING }
    }

    /// An action on one thing: `grab #12`.
    pub const fn one(verb: Verb, object: NodeId) -> Self {
        Self { object: Some(object), ..Self::zero(verb) }
    }

    /// An action on two things: `place #12 #3`.
    pub const fn two(verb: Verb, object: NodeId, target: NodeId) -> Self {
        Self { object: Some(object), target: Some(target), ..Self::zero(verb) }
    }

    /// An action on as many things as are given.
    ///
    /// # Errors
    /// [`ActionError::Arity`] if the verb takes another number of things.
    pub fn with(verb: Verb, things: &[NodeId]) -> Result<Self, ActionError> {
        let (takes, given) = (verb.arity(), things.len());
        // VirtualHome writes `[SLEEP]` and `[SLEEP] <bed> (1)` alike.
        let optional = matches!(verb, Verb::Sleep | Verb::WakeUp | Verb::Stand | Verb::Leave) && given <= 1;
        if takes != given && !optional {
            return Err(ActionError::Arity { verb, takes, given });
        }
        let (object, target) = (things.first().copied(), things.get(1).copied());
        Ok(Self { object: object.filter(|_| takes > 0), target, ..Self::zero(verb) })
    }

    /// The things it is done to.
    pub fn things(&self) -> impl Iterator<Item = NodeId> {
        self.object.into_iter().chain(self.target)
    }

    /// The action with the classes of its things: `grab cup.12`.
    pub fn describe<'a>(&'a self, graph: &'a SceneGraph) -> impl fmt::Display + 'a {
        Described { action: self, graph }
    }

    /// The action in VirtualHome's notation, `[GRAB] <cup> (12)`, with the classes
    /// as the scene's author spelled them.
    ///
    /// # Errors
    /// [`ActionError::NotInVirtualHome`].
    pub fn to_virtualhome(&self, graph: &SceneGraph) -> Result<String, ActionError> {
        let verb = self.verb.virtualhome().ok_or(ActionError::NotInVirtualHome(self.verb))?;
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
        self.action.things().try_for_each(|id| write!(f, " {}", self.graph.label(id)))
    }
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.verb)?;
        self.things().try_for_each(|id| write!(f, " {id}"))
    }
}

impl std::str::FromStr for Action {
    type Err = ActionError;

    fn from_str(text: &str) -> Result<Self, ActionError> {
        let deed: Deed = text.parse()?;
        match deed.character {
            0 => Ok(Self { called: Called::of(&deed.action, &deed.labels), ..deed.action }),
            someone => Err(ActionError::Character(someone)),
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
