//! The sets of aims that verbs take, by name.

use crate::AimWord::{self, At, By, Seat, Slot, Yaw};
use crate::VocabularyProblem;
use crate::rule::aim::{AimForm, AimRule, Aimed};
use crate::vocabulary::unknown;

const fn with(words: &'static [AimWord]) -> AimForm {
    AimForm { alone: false, words }
}

const fn alone(words: &'static [AimWord]) -> AimForm {
    AimForm { alone: true, words }
}

/// To a point, or up to an object and turned so, or to this point beside an object.
pub(super) const GOING: AimRule = AimRule {
    forms: &[alone(&[At]), alone(&[At, Yaw]), with(&[At]), with(&[Yaw]), with(&[At, Yaw])],
    places: Some(Aimed::Feet),
};
/// To a point or to a heading.
pub(super) const TURNING: AimRule = AimRule { forms: &[alone(&[At]), alone(&[Yaw])], places: Some(Aimed::Front) };
/// To a place.
pub(super) const POINTING: AimRule = AimRule { forms: &[alone(&[At])], places: Some(Aimed::Front) };
/// At a point of the surface, turned so, or on this shelf of it.
pub(super) const PUTTING: AimRule = AimRule {
    forms: &[with(&[At]), with(&[Yaw]), with(&[At, Yaw]), with(&[Slot]), with(&[Yaw, Slot])],
    places: Some(Aimed::Object),
};
/// At a point of the floor, turned so.
pub(super) const DROPPING: AimRule = AimRule { forms: &[with(&[At]), with(&[At, Yaw])], places: Some(Aimed::Object) };
/// By a side.
pub(super) const TAKING: AimRule = AimRule { forms: &[with(&[By])], places: None };
/// On this seat.
pub(super) const SITTING: AimRule = AimRule { forms: &[with(&[Seat])], places: None };

/// The aims that the rules of a text can name, with the number of things that they are for.
const NAMED: &[(&str, usize, AimRule)] = &[
    ("going", 1, GOING),
    ("turning", 1, TURNING),
    ("pointing", 1, POINTING),
    ("putting", 2, PUTTING),
    ("dropping", 1, DROPPING),
    ("taking", 1, TAKING),
    ("sitting", 1, SITTING),
];

impl AimRule {
    /// No aims.
    pub(super) const NONE: Self = Self { forms: &[], places: None };

    /// The aims of a name, for a verb with so many things; without a name there are none.
    pub(crate) fn named(name: &str, things: usize) -> Result<Self, VocabularyProblem> {
        match NAMED.iter().find(|(known, ..)| *known == name) {
            _ if name.is_empty() => Ok(Self::NONE),
            Some((_, needed, rule)) if *needed == things => Ok(*rule),
            Some((aims, needed, _)) => Err(VocabularyProblem::Aims { aims, needed: *needed }),
            None => Err(unknown("set of aims", name, &NAMED.iter().map(|(name, ..)| *name).collect::<Vec<_>>())),
        }
    }

    /// The name of the aims; empty if there are none.
    pub(crate) fn name(&self) -> &'static str {
        NAMED.iter().find(|(.., rule)| rule == self).map_or("", |(name, ..)| name)
    }
}
