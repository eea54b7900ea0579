//! The rules that a plan keeps, checked from its geometry alone: no code of the generator decides here.

mod ground;
mod houses;
mod items;
mod lights;
mod rule;
mod streets;
mod walk;

use std::fmt;

use vc_map::{JunctionId, LaneId, Point, RoadId};

pub use rule::CityRule;

use super::CityPlan;

/// The part of a plan that breaks a rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum CityPart {
    /// The plan as a whole.
    City,
    /// A junction of its map.
    Junction(JunctionId),
    /// A road of its map.
    Road(RoadId),
    /// A lane of its map.
    Lane(LaneId),
    /// A street, by its position.
    Street(usize),
    /// A block, by its position.
    Block(usize),
    /// A parcel, by its position.
    Parcel(usize),
    /// A building, by its position.
    Building(usize),
    /// A thing beside a street, by its position.
    Item(usize),
    /// A parked car, by its position.
    Car(usize),
}

impl fmt::Display for CityPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::City => f.write_str("the city"),
            Self::Junction(id) => id.fmt(f),
            Self::Road(id) => id.fmt(f),
            Self::Lane(id) => id.fmt(f),
            Self::Street(index) => write!(f, "street {index}"),
            Self::Block(index) => write!(f, "block {index}"),
            Self::Parcel(index) => write!(f, "parcel {index}"),
            Self::Building(index) => write!(f, "building {index}"),
            Self::Item(index) => write!(f, "item {index}"),
            Self::Car(index) => write!(f, "car {index}"),
        }
    }
}

/// A rule that a plan breaks, with its place.
///
/// ```
/// use vc_map::Point;
/// use vc_procgen::city::{CityPart, CityRule, CityViolation};
/// let wrong = CityViolation { rule: CityRule::ShortArm, part: CityPart::Street(3), at: Point::new(4.0, 2.0), value: 8.5 };
/// assert_eq!(wrong.to_string(), "rule 1: street 3 at 4, 2: arm of a junction shorter than 12 m: 8.50");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CityViolation {
    /// The rule.
    pub rule: CityRule,
    /// The part that breaks it.
    pub part: CityPart,
    /// Where, metres.
    pub at: Point,
    /// The value that it should not have, in the unit of the rule.
    pub value: f64,
}

impl fmt::Display for CityViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, part, at, value } = self;
        write!(f, "rule {}: {part} at {:.0}, {:.0}: {rule}: {value:.2}", rule.number(), at.x, at.y)
    }
}

impl CityPlan {
    /// Every rule that the plan breaks, with the places. Costs several times as much as to generate it.
    ///
    /// ```
    /// use vc_procgen::city::CityPlan;
    /// assert_eq!(CityPlan::from_seed(vc_graph::Seed(7))?.violations(), []);
    /// # Ok::<(), vc_procgen::city::CityPlanError>(())
    /// ```
    pub fn violations(&self) -> Vec<CityViolation> {
        let mut found = Found { all: Vec::new() };
        streets::check(self, &mut found);
        ground::check(self, &mut found);
        houses::check(self, &mut found);
        lights::check(self, &mut found);
        walk::check(self, &mut found);
        items::check(self, &mut found);
        found.all
    }
}

/// The violations that were found so far.
struct Found {
    all: Vec<CityViolation>,
}

impl Found {
    fn add(&mut self, rule: CityRule, part: CityPart, at: Point, value: f64) {
        self.all.push(CityViolation { rule, part, at, value });
    }
}
