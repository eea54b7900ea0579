//! Where and how an action is done: a point, a heading, a seat, a slot, a side.

mod number;
mod text;

use nalgebra::{Point2, UnitQuaternion, Vector3};

use crate::portable::Portable;
use crate::vocabulary::{Set, UnknownWord, vocabulary};

pub use number::{AimPoint, Heading};

vocabulary! {
    /// A word with which an [`Aim`] is written.
    ///
    /// | word | followed by |
    /// |---|---|
    /// | `at` | X and Y of a point of the world, and Z if its height matters, metres |
    /// | `yaw` | a heading, degrees counter-clockwise from the world's X |
    /// | `seat` | the number of a place to sit, counted from 1 |
    /// | `slot` | the number of a shelf, drawer, rack or burner, counted from 1 |
    /// | `by` | a [`Side`] |
    #[non_exhaustive]
    AimWord, "word of an aim" {
        /// A point.
        At = "at",
        /// A heading.
        Yaw = "yaw",
        /// A place to sit.
        Seat = "seat",
        /// A shelf, drawer, rack or burner.
        Slot = "slot",
        /// A side of a thing.
        By = "by",
    }
}

vocabulary! {
    /// A side of a thing by the thing's own axes: X points to its front, Y to its left.
    Side, "side" {
        /// The side to which its X points.
        Front = "front",
        /// The opposite of the front.
        Back = "back",
        /// The side to which its Y points.
        Left = "left",
        /// The opposite of the left.
        Right = "right",
        /// Its upper side.
        Top = "top",
    }
}

impl Side {
    /// The direction in which it lies, in the thing's own frame.
    pub fn direction(self) -> Vector3<f32> {
        match self {
            Self::Front => Vector3::x(),
            Self::Back => -Vector3::x(),
            Self::Left => Vector3::y(),
            Self::Right => -Vector3::y(),
            Self::Top => Vector3::z(),
        }
    }
}

/// A part of a thing that an action names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum AimPart {
    /// A place to sit, counted from 1 in the order of `BodyView::seats`.
    Seat(u16),
    /// One of the level surfaces in or on a thing, counted from 1 in the order of its asset.
    Slot(u16),
    /// A side.
    Side(Side),
}

/// Where and how an action is done, as far as it says: the coordinate and the rotation of an action.
///
/// Points are in the world's frame, metres, Z up; headings are degrees counter-clockwise from X. An aim holds whole
/// millimetres and hundredths of a degree, far below what bodies keep to, so that actions can be compared and their
/// texts are exact. [`ActionRule::aims`](crate::ActionRule) says which verbs take which aims.
///
/// The point of a thing is that of its origin as seen from above, which is the middle of the base of generated things;
/// its height, if stated, is that of the surface below the thing; else the thing comes to the highest surface there that has
/// room. The heading is that of its X, which points to its
/// front. Those of an agent are of its feet, and a height only tells on which storey they are.
///
/// ```
/// use vc_graph::{Action, AimPart, NodeId, Verb};
/// let place = Action::place(NodeId(12), NodeId(3)).at(1.2, 0.4)?.turned(90.0)?;
/// assert_eq!(place, "place cup.12 table.3 at 1.20 0.40 yaw 90".parse()?);
/// assert_eq!(place.to_string(), "place #12 #3 at 1.20 0.40 yaw 90");
/// assert_eq!("walk at 3.2 1.5".parse::<Action>()?, Action::zero(Verb::Walk).at(3.2, 1.5)?);
/// let sit: Action = "sit sofa.7 seat 2".parse()?;
/// assert_eq!(sit.aim.part(), Some(AimPart::Seat(2)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Aim {
    point: Option<AimPoint>,
    heading: Option<Heading>,
    part: Option<AimPart>,
}

/// An aim that cannot be read, or a number that no aim has.
///
/// ```
/// use vc_graph::{Action, ActionTextError, AimError};
/// let error = "walk at 1.0".parse::<Action>().unwrap_err();
/// assert!(matches!(error, ActionTextError::Aim(AimError::Missing(_))));
/// assert!(error.to_string().starts_with("`at` is followed by two or three numbers"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AimError {
    /// A word that is no number.
    #[error("`{0}` is not a number, as in `at 1.20 0.40 yaw 90`")]
    Number(String),
    /// A number of a seat or slot that is none.
    #[error("`{0}` is no seat or slot: these are whole numbers from 1 to 65535, as in `seat 2`")]
    Whole(String),
    /// A number that is not finite, or a point that is more than 1,000 km away.
    #[error("{0} is not finite, or more than 1,000 km away")]
    OutOfRange(String),
    /// Nothing follows a word that says more.
    #[error("`{}` is followed by {}", .0, follows(*.0))]
    Missing(AimWord),
    /// A word that belongs to no aim.
    #[error("`{0}` is neither an object nor one of `at`, `yaw`, `seat`, `slot`, `by`")]
    Unexpected(String),
    /// A word comes twice, or several parts are named.
    #[error("`{0}` is one too many: an aim has each word once, and one of `seat`, `slot` and `by`")]
    Again(AimWord),
    /// No side has this name.
    #[error(transparent)]
    Side(#[from] UnknownWord),
}

fn follows(word: AimWord) -> &'static str {
    match word {
        AimWord::At => "two or three numbers, X, Y and perhaps Z in metres",
        AimWord::Yaw => "a number of degrees",
        AimWord::Seat | AimWord::Slot => "a whole number, counted from 1",
        AimWord::By => "a side: front, back, left, right or top",
    }
}

impl Aim {
    /// No aim: the action is done wherever and however it can be.
    pub const NOTHING: Self = Self { point: None, heading: None, part: None };

    /// Whether it says nothing.
    pub fn is_nothing(&self) -> bool {
        *self == Self::NOTHING
    }

    /// The point.
    pub fn point(&self) -> Option<AimPoint> {
        self.point
    }

    /// The heading.
    pub fn heading(&self) -> Option<Heading> {
        self.heading
    }

    /// The part of the thing.
    pub fn part(&self) -> Option<AimPart> {
        self.part
    }

    /// The aim with another point.
    #[must_use]
    pub fn with_point(self, point: AimPoint) -> Self {
        Self { point: Some(point), ..self }
    }

    /// The aim with another heading.
    #[must_use]
    pub fn with_heading(self, heading: Heading) -> Self {
        Self { heading: Some(heading), ..self }
    }

    /// The aim with another part.
    #[must_use]
    pub fn with_part(self, part: AimPart) -> Self {
        Self { part: Some(part), ..self }
    }

    /// The words with which it is written.
    pub fn words(&self) -> Set<AimWord> {
        let part = self.part.map(|part| match part {
            AimPart::Seat(_) => AimWord::Seat,
            AimPart::Slot(_) => AimWord::Slot,
            AimPart::Side(_) => AimWord::By,
        });
        let (at, yaw) = (self.point.map(|_| AimWord::At), self.heading.map(|_| AimWord::Yaw));
        [at, yaw, part].into_iter().flatten().collect()
    }

    /// The rotation of somebody who stands at a place and is turned so: by the heading, else towards the point.
    ///
    /// ```
    /// use vc_graph::Action;
    /// let turn: Action = "turn_to at 0 2".parse()?;
    /// let front = turn.aim.turn_from(&[0.0, 0.0].into()).ok_or("no heading")? * nalgebra::Vector3::x();
    /// assert!((front.y - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn turn_from(&self, place: &Point2<f32>) -> Option<UnitQuaternion<f32>> {
        let towards = || {
            let way = self.point?.plan() - place;
            (way.norm() > 1e-3).then(|| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), way.y.angle_to(way.x)))
        };
        self.heading.map(|heading| heading.rotation()).or_else(towards)
    }
}
