//! Sets of users and of directions, written as lists of words.

use std::fmt;
use std::ops::BitOr;

use serde::{Deserialize, Serialize};

macro_rules! masks {
    ($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $flag:ident = $bit:literal, $word:literal;)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(try_from = "Vec<String>", into = "Vec<String>")]
        pub struct $name(u8);

        impl $name {
            $($(#[$of])* pub const $flag: Self = Self(1 << $bit);)*
            /// None of them.
            pub const NONE: Self = Self(0);
            const WORDS: &'static [(Self, &'static str)] = &[$((Self::$flag, $word)),*];

            /// Whether all of these are among them.
            pub const fn has(self, other: Self) -> bool {
                self.0 & other.0 == other.0
            }

            /// Whether any of these is among them.
            pub const fn any(self, other: Self) -> bool {
                self.0 & other.0 != 0
            }

            /// Whether there are none.
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }

            /// Those in both.
            #[must_use]
            pub const fn and(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }

            /// Those that are not among the others.
            #[must_use]
            pub const fn without(self, other: Self) -> Self {
                Self(self.0 & !other.0)
            }

            /// Their words.
            pub fn words(self) -> impl Iterator<Item = &'static str> {
                Self::WORDS.iter().filter(move |(flag, _)| self.has(*flag)).map(|(_, word)| *word)
            }
        }

        impl BitOr for $name {
            type Output = Self;
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl TryFrom<Vec<String>> for $name {
            type Error = String;

            fn try_from(words: Vec<String>) -> Result<Self, String> {
                words.iter().try_fold(Self::NONE, |all, word| {
                    let known = Self::WORDS.iter().find(|(_, known)| known == word);
                    let words = || Self::WORDS.iter().map(|(_, known)| *known).collect::<Vec<_>>().join(", ");
                    let flag = known.map(|(flag, _)| *flag);
                    flag.map(|flag| all | flag).ok_or_else(|| format!("`{}` is none of: {}", vc_graph::clip(word), words()))
                })
            }
        }

        impl From<$name> for Vec<String> {
            fn from(set: $name) -> Self {
                set.words().map(str::to_owned).collect()
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let words = self.words().collect::<Vec<_>>().join("|");
                f.write_str(if words.is_empty() { "none" } else { &words })
            }
        }
    };
}

masks! {
    /// Those who may use a lane.
    ///
    /// ```
    /// use vc_map::Users;
    /// let lane = Users::BUS | Users::BICYCLE;
    /// assert!(lane.has(Users::BUS) && !lane.any(Users::CAR | Users::FOOT));
    /// ```
    Users {
        /// Cars, vans and lorries.
        CAR = 0, "car";
        /// Buses.
        BUS = 1, "bus";
        /// Bicycles.
        BICYCLE = 2, "bicycle";
        /// People on foot.
        FOOT = 3, "foot";
        /// Trams.
        TRAM = 4, "tram";
        /// Trains, underground ones included.
        TRAIN = 5, "train";
    }
}

masks! {
    /// Directions in which a lane goes on beyond a junction; none means that nothing is marked.
    ///
    /// ```
    /// use vc_map::Turns;
    /// let marks = Turns::LEFT | Turns::THROUGH;
    /// assert_eq!(marks.words().collect::<Vec<_>>(), ["through", "left"]);
    /// ```
    Turns {
        /// Straight on.
        THROUGH = 0, "through";
        /// To the left.
        LEFT = 1, "left";
        /// To the right.
        RIGHT = 2, "right";
        /// Back.
        BACK = 3, "back";
    }
}

impl Users {
    /// Vehicles on tyres: everybody who drives on a carriageway.
    pub const TRAFFIC: Self = Self(1 | 2 | 4);
    /// Trams and trains.
    pub const RAILS: Self = Self(16 | 32);
}
