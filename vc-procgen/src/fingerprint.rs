//! A digest that tells whether two apartments are the same up to rotation and mirroring.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use vc_graph::hash::splitmix;

use crate::apartment::Apartment;
use crate::item::Support;
use crate::plan::{CELLS, FloorPlan, PlanOpening, Rect, Room};

/// A 128-bit fingerprint: equal for apartments that differ only by a rotation or mirroring. Written as 32
/// hexadecimal digits.
///
/// It serves to detect duplicates (two of 100,000 different homes have the same one with a probability of
/// about 10⁻²⁹) but offers no protection against an adversary.
///
/// ```
/// use vc_procgen::Fingerprint;
/// let fingerprint: Fingerprint = "000000000000000000000000000000ff".parse()?;
/// assert_eq!((fingerprint, fingerprint.to_string().len()), (Fingerprint(255), 32));
/// assert!("ff".parse::<Fingerprint>().is_err());
/// # Ok::<(), vc_procgen::FingerprintError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Fingerprint(pub u128);

/// A text that is not a fingerprint.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a fingerprint: a fingerprint has 32 hexadecimal digits")]
pub struct FingerprintError(String);

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl FromStr for Fingerprint {
    type Err = FingerprintError;

    fn from_str(text: &str) -> Result<Self, FingerprintError> {
        let digits = text.len() == 32 && text.bytes().all(|b| b.is_ascii_hexdigit());
        let number = if digits { u128::from_str_radix(text, 16).ok() } else { None };
        number.map(Self).ok_or_else(|| FingerprintError(text.to_owned()))
    }
}

impl From<Fingerprint> for String {
    fn from(fingerprint: Fingerprint) -> Self {
        fingerprint.to_string()
    }
}

impl TryFrom<String> for Fingerprint {
    type Error = FingerprintError;

    fn try_from(text: String) -> Result<Self, FingerprintError> {
        text.parse()
    }
}

impl Fingerprint {
    /// The fingerprint of bytes, to detect changed files.
    ///
    /// ```
    /// use vc_procgen::Fingerprint;
    /// assert_ne!(Fingerprint::from_bytes(b"home"), Fingerprint::from_bytes(b"homes"));
    /// ```
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut mixer = Mixer::new(bytes.len() as u64);
        mixer.bytes(bytes);
        Self(mixer.value())
    }
}

impl FloorPlan {
    /// The fingerprint of rooms and openings on the plan's grid: the same for all eight rotations and
    /// mirrorings of the plan. The thickness of walls and the height of the ceiling do not count.
    ///
    /// Costs some tens of microseconds.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::FloorPlan;
    /// let plan = FloorPlan::generate(&Specification::default(), Seed(3))?;
    /// assert_eq!(plan.fingerprint(), plan.turned(5).fingerprint());
    /// assert_ne!(plan.fingerprint(), FloorPlan::generate(&Specification::default(), Seed(4))?.fingerprint());
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn fingerprint(&self) -> Fingerprint {
        smallest(|way| seen(self, way))
    }
}

impl Apartment {
    /// The fingerprint of the plan and of all items: their classes and the centres of their boxes,
    /// rounded to five centimetres. Materials, shapes and states do not count, so homes with different
    /// fingerprints differ in more than those.
    ///
    /// Costs some tens of microseconds, and some hundred nanoseconds for each item.
    pub fn fingerprint(&self) -> Fingerprint {
        let hull = self.plan.hull();
        let movable = self.items.iter().filter(|i| i.support != Support::Built);
        let things: Vec<Thing> = movable
            .map(|item| {
                let (low, high) = item.corners();
                let centre = nalgebra::center(&low, &high);
                Thing::new(item.object.class, [centre.x, centre.y, centre.z], &hull)
            })
            .collect();
        let size = [2 * hull.width(), 2 * hull.depth()];
        smallest(|way| {
            let content = things.iter().fold(0, |sum: u128, t| sum.wrapping_add(t.seen(way, size)));
            let mut mixer = Mixer::new(3);
            mixer.wide(seen(&self.plan, way));
            mixer.wide(content);
            mixer.value()
        })
    }
}

/// The smallest of the values for all eight orientations.
fn smallest(value: impl Fn(usize) -> u128) -> Fingerprint {
    Fingerprint((0..8).map(value).min().unwrap_or_default())
}

/// The value of a plan in one orientation. The values of rooms and openings are added up, so that their
/// order does not matter.
fn seen(plan: &FloorPlan, way: usize) -> u128 {
    let turned = plan.turned(way);
    let rooms = turned.rooms.iter().map(room);
    let sum = rooms.chain(turned.openings.iter().map(opening)).fold(0, u128::wrapping_add);
    let mut mixer = Mixer::new(turned.rooms.len() as u64);
    mixer.wide(sum);
    mixer.value()
}

fn room(room: &Room) -> u128 {
    let mut mixer = Mixer::new(1);
    mixer.word(room.kind as u64);
    mixer.wide(room.rects.iter().map(rect).fold(0, u128::wrapping_add));
    mixer.value()
}

fn rect(rect: &Rect) -> u128 {
    let mut mixer = Mixer::new(4);
    [rect.x0, rect.y0, rect.x1, rect.y1].into_iter().for_each(|v| mixer.word(v as u64));
    mixer.value()
}

fn opening(opening: &PlanOpening) -> u128 {
    let mut mixer = Mixer::new(2);
    [opening.at, opening.from, opening.to].into_iter().for_each(|v| mixer.word(v as u64));
    // Only an opening with a leaf has a hinge.
    let leaf =
        if opening.has_leaf() { 1 + u64::from(opening.opens_high) + 2 * u64::from(opening.hinge_low) } else { 0 };
    mixer.word(opening.kind as u64 | u64::from(opening.vertical) << 8 | leaf << 16);
    mixer.value()
}

/// An item's class, and its position in half cells from the plan's south-west corner.
struct Thing {
    class: u128,
    at: [i32; 3],
}

impl Thing {
    fn new(class: &str, centre: [f32; 3], hull: &Rect) -> Self {
        let from = [hull.x0 as f32, hull.y0 as f32, 0.0];
        let at = std::array::from_fn(|i| half_cells(centre[i] * CELLS - from[i]));
        Self { class: Fingerprint::from_bytes(class.as_bytes()).0, at }
    }

    /// Its value in one orientation of the plan; `size` is the plan's size in half cells.
    fn seen(&self, way: usize, size: [i32; 2]) -> u128 {
        let [x, y, z] = self.at;
        let x = if way & 1 != 0 { size[0] - x } else { x };
        let y = if way & 2 != 0 { size[1] - y } else { y };
        let (x, y) = if way & 4 != 0 { (y, x) } else { (x, y) };
        let mut mixer = Mixer::new(5);
        mixer.wide(self.class);
        [x, y, z].into_iter().for_each(|v| mixer.word(v as u64));
        mixer.value()
    }
}

/// Rounds cells to half cells: even for the nearest whole cell, odd for a value midway between two, so
/// that a position and its mirror image are rounded alike.
fn half_cells(cells: f32) -> i32 {
    let whole = cells.round();
    let off = cells - whole;
    let between = if off > 0.45 { 1 } else { -i32::from(off < -0.45) };
    2 * whole as i32 + between
}

/// Two 64-bit states, each mixed by `splitmix`.
struct Mixer([u64; 2]);

impl Mixer {
    fn new(start: u64) -> Self {
        Self([splitmix(start ^ 0x243f_6a88_85a3_08d3), splitmix(start ^ 0x1319_8a2e_0370_7344)])
    }

    fn word(&mut self, word: u64) {
        let [a, b] = self.0;
        self.0 = [splitmix(a ^ word), splitmix(b.rotate_left(23) ^ word.wrapping_mul(0x9e37_79b9_7f4a_7c15))];
    }

    fn wide(&mut self, value: u128) {
        self.word(value as u64);
        self.word((value >> 64) as u64);
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.word(u64::from_le_bytes(word));
        }
    }

    fn value(&self) -> u128 {
        let [a, b] = self.0;
        u128::from(splitmix(a ^ b.rotate_left(32))) << 64 | u128::from(splitmix(b ^ a))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::Specification;
    use std::collections::HashSet;
    use vc_graph::Seed;

    /// The plans of seeds; some seeds have none.
    fn plans(seeds: std::ops::Range<u64>) -> Vec<FloorPlan> {
        seeds.filter_map(|seed| FloorPlan::generate(&Specification::default(), Seed(seed)).ok()).collect()
    }

    #[test]
    fn turned_plans_are_the_same() {
        for (i, plan) in plans(0..50).iter().enumerate() {
            let all: HashSet<_> = (0..8).map(|way| plan.turned(way).fingerprint()).collect();
            assert_eq!(all, HashSet::from([plan.fingerprint()]), "plan {i}");
        }
    }

    #[test]
    fn other_seeds_are_other_plans() {
        let plans = plans(0..400);
        let all: HashSet<_> = plans.iter().map(FloorPlan::fingerprint).collect();
        assert!(plans.len() > 300);
        assert_eq!(all.len(), plans.len());
    }

    #[test]
    fn order_does_not_matter_but_a_hinge_does() {
        let plan = plans(0..5).remove(0);
        let mut other = plan.clone();
        other.openings.reverse();
        assert_eq!(other.fingerprint(), plan.fingerprint());
        let door = other.openings.iter_mut().find(|o| o.has_leaf()).unwrap();
        door.hinge_low ^= true;
        assert_ne!(other.fingerprint(), plan.fingerprint());
    }

    #[test]
    fn mirrored_things_are_the_same_things() {
        let hull = Rect::sized(-7, 3, 200, 150);
        let (west, east, wide) = (-7.0 / CELLS, 193.0 / CELLS, [400, 300]);
        for i in 0..400 {
            // Steps of a quarter cell, which include all ties.
            let x = west + i as f32 * 0.0125;
            let there = Thing::new("cup", [x, 1.0, 0.5], &hull);
            let mirrored = Thing::new("cup", [west + east - x, 1.0, 0.5], &hull);
            assert_eq!(there.seen(0, wide), mirrored.seen(1, wide), "{i}");
        }
    }

    #[test]
    fn texts_are_read_back() {
        let mark = Fingerprint(0x0123_4567_89ab_cdef_0011_2233_4455_6677);
        assert_eq!(mark.to_string().parse(), Ok(mark));
        assert!("xyz".parse::<Fingerprint>().is_err());
        assert!("+1234567890123456789012345678901".parse::<Fingerprint>().is_err());
    }
}
