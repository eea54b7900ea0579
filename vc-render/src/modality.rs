//! The modalities: kinds of images and labels that a camera can produce.

use std::fmt;
use std::ops::{BitOr, BitOrAssign};

use vc_graph::NodeId;

/// Node of a pixel where nothing is visible, in [`Frame::instance`](crate::Frame::instance).
pub const NOTHING: NodeId = NodeId(u32::MAX);

/// Class and part of a pixel where nothing is visible, in [`Frame::class`](crate::Frame::class) and
/// [`Frame::part`](crate::Frame::part).
pub const NO_LABEL: u16 = u16::MAX;

macro_rules! modalities {
    ($($(#[$doc:meta])* $name:ident = $bit:literal;)*) => {
        /// A kind of image or label that a camera produces. Sets are made with `|`.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Modality {
            $($(#[$doc])* $name,)*
        }

        impl Modality {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            const fn bit(self) -> u32 {
                match self {
                    $(Self::$name => 1 << $bit,)*
                }
            }
        }
    };
}

modalities! {
    /// Colour: [`Frame::rgb`](crate::Frame::rgb).
    Rgb = 0;
    /// Depth along the optical axis: [`Frame::depth`](crate::Frame::depth).
    Depth = 1;
    /// Distance along the ray: [`Frame::distance`](crate::Frame::distance).
    Distance = 2;
    /// Node at each pixel: [`Frame::instance`](crate::Frame::instance).
    Instance = 3;
    /// Part of the node's asset at each pixel: [`Frame::part`](crate::Frame::part).
    Part = 4;
    /// Class at each pixel: [`Frame::class`](crate::Frame::class).
    Class = 5;
    /// Normals of the surface: [`Frame::normal`](crate::Frame::normal).
    Normal = 6;
    /// Points of the world: [`Frame::position`](crate::Frame::position).
    Position = 7;
    /// Motion to the next moment: [`Frame::flow_forward`](crate::Frame::flow_forward).
    FlowForward = 8;
    /// Motion from the moment before: [`Frame::flow_backward`](crate::Frame::flow_backward).
    FlowBackward = 9;
    /// Pixels whose surface cannot be seen at the other moment, for the next and the previous one as far as the
    /// shot has them: [`Frame::occluded_forward`](crate::Frame::occluded_forward),
    /// [`Frame::occluded_backward`](crate::Frame::occluded_backward). Costs a rendering of depth at each of
    /// these.
    Occlusion = 10;
    /// Bounding boxes: [`Frame::boxes`](crate::Frame::boxes).
    Boxes = 11;
    /// Masks of the visible pixels: [`Frame::masks`](crate::Frame::masks).
    Masks = 12;
    /// Masks of whole objects as if nothing occluded them, and with them the visible fraction:
    /// [`Frame::amodal_masks`](crate::Frame::amodal_masks). Costs a rendering of every visible object alone.
    Amodal = 13;
}

/// A set of [`Modality`]s.
///
/// ```
/// use vc_render::{Modalities, Modality};
/// let wanted = Modality::Depth | Modality::Instance;
/// assert!(wanted.has(Modality::Depth) && !wanted.has(Modality::Rgb));
/// assert!(Modalities::SIX.has(Modality::Rgb));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Modalities(u32);

impl Modalities {
    /// The empty set.
    pub const NONE: Self = Self(0);

    /// The six modalities: RGB, segmentation by instance and class, flow to the next moment, depth, boxes,
    /// masks.
    pub const SIX: Self = Self(
        Modality::Rgb.bit()
            | Modality::Instance.bit()
            | Modality::Class.bit()
            | Modality::FlowForward.bit()
            | Modality::Depth.bit()
            | Modality::Boxes.bit()
            | Modality::Masks.bit(),
    );

    /// Whether a modality is in the set.
    pub const fn has(self, one: Modality) -> bool {
        self.0 & one.bit() != 0
    }

    /// Whether the two sets have a modality in common.
    pub const fn any(self, of: Self) -> bool {
        self.0 & of.0 != 0
    }

    /// The set of the modalities in a list.
    pub fn new(list: &[Modality]) -> Self {
        list.iter().fold(Self::NONE, |all, one| all | *one)
    }

    /// The set without one modality.
    ///
    /// ```
    /// use vc_render::{Modalities, Modality};
    /// let labels = Modalities::SIX.without(Modality::Rgb);
    /// assert!(labels.has(Modality::Depth) && !labels.has(Modality::Rgb));
    /// ```
    #[must_use]
    pub const fn without(self, one: Modality) -> Self {
        Self(self.0 & !one.bit())
    }
}

impl From<Modality> for Modalities {
    fn from(one: Modality) -> Self {
        Self(one.bit())
    }
}

impl<T: Into<Modalities>> BitOr<T> for Modalities {
    type Output = Self;
    fn bitor(self, other: T) -> Self {
        Self(self.0 | other.into().0)
    }
}

impl<T: Into<Modalities>> BitOr<T> for Modality {
    type Output = Modalities;
    fn bitor(self, other: T) -> Modalities {
        Modalities::from(self) | other
    }
}

impl<T: Into<Modalities>> BitOrAssign<T> for Modalities {
    fn bitor_assign(&mut self, other: T) {
        *self = *self | other;
    }
}

impl fmt::Debug for Modalities {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(Modality::ALL.iter().filter(|m| self.has(**m))).finish()
    }
}
