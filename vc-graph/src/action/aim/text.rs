//! The text form of an aim: `at 1.20 0.40 yaw 90`.

use std::fmt;
use std::iter::Peekable;

use super::{Aim, AimError, AimPart, AimPoint, AimWord, Heading, Side};
use crate::spelling::{clip, same_word};
use crate::vocabulary::Word;

impl Aim {
    /// Reads the words of an aim to their end.
    pub(in crate::action) fn read<'a>(words: impl Iterator<Item = &'a str>) -> Result<Self, AimError> {
        let (mut words, mut aim) = (words.peekable(), Self::NOTHING);
        while let Some(text) = words.next() {
            let word = AimWord::parse(text).map_err(|_| AimError::Unexpected(clip(text)))?;
            let is_part = matches!(word, AimWord::Seat | AimWord::Slot | AimWord::By);
            if aim.words().contains(word) || is_part && aim.part.is_some() {
                return Err(AimError::Again(word));
            }
            aim = aim.with_word(word, &mut words)?;
        }
        Ok(aim)
    }

    fn with_word<'a>(
        self,
        word: AimWord,
        words: &mut Peekable<impl Iterator<Item = &'a str>>,
    ) -> Result<Self, AimError> {
        let mut next = || words.next().ok_or(AimError::Missing(word));
        Ok(match word {
            AimWord::Yaw => self.with_heading(Heading::new(number(next()?)?)?),
            AimWord::Seat => self.with_part(AimPart::Seat(count(next()?)?)),
            AimWord::Slot => self.with_part(AimPart::Slot(count(next()?)?)),
            AimWord::By => self.with_part(AimPart::Side(Side::parse(next()?)?)),
            AimWord::At => {
                let (x, y) = (number(next()?)?, number(next()?)?);
                let z = words.next_if(|text| !AimWord::is_one(text)).map(number).transpose()?;
                self.with_point(AimPoint::new(x, y, z)?)
            }
        })
    }
}

impl AimWord {
    /// Whether a text is one of these words, in any spelling.
    pub(crate) fn is_one(text: &str) -> bool {
        Self::ALL.iter().any(|word| same_word(word.as_str(), text))
    }
}

fn number(text: &str) -> Result<f64, AimError> {
    text.parse().map_err(|_| AimError::Number(clip(text)))
}

fn count(text: &str) -> Result<u16, AimError> {
    text.parse().map_err(|_| AimError::Whole(clip(text)))
}

/// As in the text of an action, with a space before each word.
impl fmt::Display for Aim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.point.map_or(Ok(()), |point| write!(f, " at {point}"))?;
        self.heading.map_or(Ok(()), |heading| write!(f, " yaw {heading}"))?;
        self.part.map_or(Ok(()), |part| match part {
            AimPart::Seat(number) => write!(f, " seat {number}"),
            AimPart::Slot(number) => write!(f, " slot {number}"),
            AimPart::Side(side) => write!(f, " by {side}"),
        })
    }
}

/// The text, as in an action.
impl serde::Serialize for Aim {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Aim {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <String as serde::Deserialize>::deserialize(d)?;
        Self::read(text.split_whitespace()).map_err(serde::de::Error::custom)
    }
}
