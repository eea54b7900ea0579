//! The verbs, with their names in VirtualHome.

use crate::Word;
use crate::rule::table::RULES;
use crate::spelling::same_word;
use crate::vocabulary::open_vocabulary;

open_vocabulary! {
    /// A verb. [`Vocabulary::rule`](crate::Vocabulary::rule) gives the arity, preconditions and effects of each.
    ///
    /// ```
    /// use vc_graph::{Verb, Word};
    /// assert_eq!(Verb::parse("put in")?, Verb::PutIn);
    /// assert_eq!(Verb::PutIn.as_str(), "put_in");
    /// assert!(Verb::parse("juggle").is_err());
    /// # Ok::<(), vc_graph::UnknownWord>(())
    /// ```
    Verb, "verb" {
        /// Go to a room or an object, visible or not: the rule knows where everything is.
        Walk = "walk",
        /// Go there fast.
        Run = "run",
        /// Go to an object unless it is near already; it need not be visible.
        Find = "find",
        /// Turn towards an object.
        TurnTo = "turn_to",
        /// Look at an object that the agent faces.
        LookAt = "look_at",
        /// Point at an object that the agent faces.
        PointAt = "point_at",
        /// Watch a screen or picture.
        Watch = "watch",
        /// Take an object into a free hand.
        Grab = "grab",
        /// Put a held object on a surface.
        Place = "place",
        /// Put a held object into a container.
        PutIn = "put_in",
        /// Put a held object back where it was taken from.
        PutBack = "put_back",
        /// Let go of a held object; it lands in the room.
        Drop = "drop",
        /// Open a door, lid or cover.
        Open = "open",
        /// Close a door, lid or cover.
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
        /// Eat an object, or the food on it.
        Eat = "eat",
        /// Drink an object, or the drink in it.
        Drink = "drink",
        /// Touch an object.
        Touch = "touch",
        /// Read a held object.
        Read = "read",
        /// Wipe an object with a held object.
        Wipe = "wipe",
        /// Wash an object.
        Wash = "wash",
        /// Rinse any near object, without a tool.
        Rinse = "rinse",
        /// Scrub an object.
        Scrub = "scrub",
        /// Pour the contents of a held object into another.
        Pour = "pour",
        /// Fill a held vessel at running water.
        Fill = "fill",
        /// Cut food with a knife in hand.
        Cut = "cut",
        /// Cook the food on or in a heater that is on.
        Cook = "cook",
        /// Put on held clothes.
        Wear = "wear",
        /// Take off worn clothes, into a hand.
        TakeOff = "take_off",
        /// Fold cloth or paper.
        Fold = "fold",
        /// Unfold cloth or paper.
        Unfold = "unfold",
        /// Push an object.
        Push = "push",
        /// Pull an object.
        Pull = "pull",
        /// Move an object a little.
        Move = "move",
        /// Squeeze an object.
        Squeeze = "squeeze",
        /// Type on a keyboard, or on anything with a switch.
        Type = "type",
        /// Greet a person.
        Greet = "greet",
        /// Play an instrument, game or toy.
        Play = "play",
        /// Get into a vehicle.
        Enter = "enter",
        /// Get out of the vehicle.
        Leave = "leave",
        /// Drive to a place in the vehicle that the agent is in.
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
        /// Heat the objects on or in a heater that is on.
        Heat = "heat",
        /// Cool the objects in a cooler that is on.
        Cool = "cool",
        /// Dry an object with a held cloth.
        Dry = "dry",
        /// Make an object dirty.
        Soil = "soil",
    }
}

/// VirtualHome's names of the verbs it has, and further spellings that are accepted on reading.
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
    ///
    /// ```
    /// use vc_graph::Verb;
    /// assert_eq!(Verb::SwitchOn.virtualhome(), Some("SWITCHON"));
    /// assert_eq!(Verb::from_virtualhome("SWITCHON"), Some(Verb::SwitchOn));
    /// ```
    pub fn virtualhome(self) -> Option<&'static str> {
        VIRTUALHOME.iter().find(|(verb, _)| *verb == self).map(|(_, name)| *name)
    }

    /// The verb of a VirtualHome name. Note that VirtualHome's `PUTBACK` means to place on a surface.
    pub fn from_virtualhome(name: &str) -> Option<Self> {
        VIRTUALHOME.iter().find(|(_, other)| same_word(other, name)).map(|(verb, _)| *verb)
    }

    /// The number of objects that the verb takes, 0 to 2. An [`Aim`](crate::Aim) may stand for the only one:
    /// `walk at 3.20 1.50`.
    ///
    /// ```
    /// use vc_graph::Verb;
    /// assert_eq!([Verb::Stand, Verb::Grab, Verb::Place].map(Verb::arity), [0, 1, 2]);
    /// ```
    pub fn arity(self) -> usize {
        match (RULES.get(self.index()), self.own_name()) {
            (Some(rule), _) => rule.arity,
            (None, own) => own.map_or(0, |(_, things)| usize::from(things)),
        }
    }
}
