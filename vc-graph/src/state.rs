//! States of objects and agents: open, on, clean, ...

use crate::Property;
use crate::vocabulary::{Set, open_vocabulary};

open_vocabulary! {
    /// A state of an object or agent. Opposites exclude each other, see [`State::opposites`].
    State, "state" {
        /// Its door, lid or cover is open.
        Open = "open",
        /// Its door, lid or cover is closed.
        Closed = "closed",
        /// It runs or emits light.
        On = "on",
        /// It does not run.
        Off = "off",
        /// Nothing sticks to it.
        Clean = "clean",
        /// It needs washing or wiping.
        Dirty = "dirty",
        /// Its plug is in a socket.
        PluggedIn = "plugged_in",
        /// Its plug is out.
        PluggedOut = "plugged_out",
        /// The agent sits.
        Sitting = "sitting",
        /// The agent lies.
        Lying = "lying",
        /// The agent sleeps.
        Asleep = "asleep",
        /// It is hot to the touch.
        Hot = "hot",
        /// It is cold to the touch.
        Cold = "cold",
        /// It has been cooked.
        Cooked = "cooked",
        /// It can be cooked but has not been.
        Raw = "raw",
        /// It has been cut up.
        Sliced = "sliced",
        /// It is broken.
        Broken = "broken",
        /// It is folded.
        Folded = "folded",
        /// It is unfolded.
        Unfolded = "unfolded",
        /// It is wet.
        Wet = "wet",
        /// It is dry.
        Dry = "dry",
        /// It has contents that can be poured, see `Node::contents`.
        Filled = "filled",
        /// It has no contents that can be poured.
        Empty = "empty",
        /// It is frozen hard.
        Frozen = "frozen",
        /// It burns.
        OnFire = "on_fire",
        /// Dust lies on it.
        Dusty = "dusty",
        /// It has a stain.
        Stained = "stained",
        /// It does not exist yet: an action will create it, as baking creates a cake.
        Future = "future",
    }
}

/// A set of [`State`]s.
pub type StateSet = Set<State>;

/// Groups of mutually exclusive states.
const EXCLUSIVE: &[&[State]] = &[
    &[State::Open, State::Closed],
    &[State::On, State::Off],
    &[State::Clean, State::Dirty],
    &[State::PluggedIn, State::PluggedOut],
    &[State::Sitting, State::Lying],
    &[State::Hot, State::Cold],
    &[State::Hot, State::Frozen],
    &[State::Cooked, State::Raw],
    &[State::Folded, State::Unfolded],
    &[State::Wet, State::Dry],
    &[State::Filled, State::Empty],
];

impl State {
    /// The built-in states that this state excludes; [`Vocabulary::opposites`](crate::Vocabulary::opposites) knows own ones.
    ///
    /// ```
    /// use vc_graph::State;
    /// assert!(State::Open.opposites().contains(State::Closed));
    /// assert!(State::Broken.opposites().is_empty());
    /// ```
    pub fn opposites(self) -> StateSet {
        let groups = EXCLUSIVE.iter().filter(|group| group.contains(&self));
        groups.fold(StateSet::EMPTY, |set, group| set.union(StateSet::from_words(group))).without(self)
    }

    /// The affordance without which no action brings a thing into the state; `None` for a state of all sorts of things. For
    /// own states [`Vocabulary::needs`](crate::Vocabulary::needs) says it.
    ///
    /// ```
    /// use vc_graph::{Property, State};
    /// assert_eq!(State::Closed.needs(), Some(Property::Openable));
    /// assert_eq!(State::Dirty.needs(), None);
    /// ```
    pub fn needs(self) -> Option<Property> {
        Some(match self {
            Self::Open | Self::Closed => Property::Openable,
            Self::On | Self::Off => Property::Switchable,
            Self::PluggedIn | Self::PluggedOut => Property::Plug,
            Self::Cooked | Self::Raw => Property::Cookable,
            Self::Sliced => Property::Cuttable,
            Self::Folded | Self::Unfolded => Property::Foldable,
            _ => return None,
        })
    }
}

impl StateSet {
    /// This set with the state added and its built-in opposites removed;
    /// [`Vocabulary::entering`](crate::Vocabulary::entering) removes own ones as well.
    ///
    /// ```
    /// use vc_graph::{State, StateSet};
    /// let closed = StateSet::from_words(&[State::Closed, State::Dirty]);
    /// assert_eq!(closed.entering(State::Open), StateSet::from_words(&[State::Open, State::Dirty]));
    /// ```
    #[must_use]
    pub fn entering(self, state: State) -> Self {
        self.minus(state.opposites()).with(state)
    }

    /// The groups of built-in exclusive states from which the set has more than one.
    pub fn conflicts(self) -> impl Iterator<Item = StateSet> {
        EXCLUSIVE.iter().filter_map(move |group| {
            let both: StateSet = group.iter().copied().filter(|&s| self.contains(s)).collect();
            (both.len() > 1).then_some(both)
        })
    }
}
