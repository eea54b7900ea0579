//! The part that bodies have in an action, besides what its effects ask of them.

use crate::vocabulary::vocabulary;

vocabulary! {
    /// The motion by which a body shows an action. The effects ask for the rest: feet go, hands take and put, doors open.
    /// A gesture takes 1.5 s, or as long as the action. It is seen in the moments of the clock and changes nothing else.
    ///
    /// ```
    /// use vc_graph::{Motion, Verb, Vocabulary};
    /// let words = Vocabulary::builtin();
    /// assert_eq!(words.rule(Verb::Wipe).map(|rule| rule.motion), Some(Motion::UseAt));
    /// ```
    #[non_exhaustive]
    Motion, "motion" {
        /// Nothing more is seen.
        Nothing = "none",
        /// Feet go there, as far as an effect says so; without such an effect, up to what is near already.
        Go = "go",
        /// As `go`, running.
        Run = "run",
        /// Eyes are on it.
        Look = "look",
        /// A hand points to it.
        Point = "point",
        /// A hand goes to it.
        Reach = "reach",
        /// A hand takes it, or lets it go, as the effects say. Without such an effect it is in the hand in the middle of
        /// the gesture and then where it was, if one reaches it and `grab` is allowed; otherwise a hand goes to it.
        Hold = "hold",
        /// A hand goes to it, or to its switch on the wall.
        Switch = "switch",
        /// The body sits or lies down on it, as the effects say. Without such an effect it does for the time of the
        /// gesture, if it stands within a step of a free place; otherwise a hand goes to it.
        Sit = "sit",
        /// A hand, with what it holds, moves to and fro on it.
        UseAt = "use_at",
        /// A hand, with what it holds, moves up and down on it.
        Cut = "cut",
        /// A hand tilts what it holds above the second object.
        Pour = "pour",
        /// A hand has what it holds at the second object.
        Fill = "fill",
        /// A hand goes to it and to the mouth.
        Eat = "eat",
        /// A hand has it at the mouth.
        Drink = "drink",
        /// A hand has it before the eyes.
        Read = "read",
        /// Both hands move on it.
        Play = "play",
        /// A hand waves.
        Wave = "wave",
        /// Both arms swing.
        Dance = "dance",
        /// Both arms go up and down.
        Exercise = "exercise",
        /// Both arms go up.
        Stretch = "stretch",
    }
}
