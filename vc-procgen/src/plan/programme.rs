//! The room programme of an apartment: its rooms, their areas and their adjacency.

use vc_graph::portable::Portable;
use vc_graph::{Seed, Stream};

use super::{RoomKind, Scheme, Topology};
use crate::error::SpecificationError;
use crate::specification::Specification;

/// A requested room.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wish {
    /// Its purpose.
    pub(crate) kind: RoomKind,
    /// The net area, square metres.
    pub(crate) area: f32,
    /// For an en-suite bathroom: the index of its bedroom's request.
    pub(crate) of: Option<usize>,
}

/// The rooms of an apartment before its layout. Halls are not requested: each scheme adds those it
/// needs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Programme {
    /// The rooms: living room first, then kitchen, bedrooms, study, and service rooms.
    pub(crate) wishes: Vec<Wish>,
    /// Whether the kitchen is open to the living room.
    pub(crate) open_kitchen: bool,
    /// The requested adjacency of rooms.
    pub(crate) topology: Topology,
    /// Whether there is a balcony at the living room, and one at a bedroom.
    pub(crate) balconies: (bool, bool),
    /// The number of additional balconies.
    pub(crate) more_balconies: usize,
    /// The requested net area, square metres.
    pub(crate) wished_area: Option<f32>,
}

/// The area of a room in real homes: median, standard deviation of the logarithm, and the least and
/// largest sensible values, square metres.
///
/// Medians and deviations are those of a public set of real plans and of common practice: bedrooms
/// 14.6 (10.1-22.7), kitchens 8.6 (5.5-13.0), bathrooms 3.8 (2.4-8.7), living rooms with halls 33
/// (22.6-57.4), studies 9 (6-14), laundries 4 (2.5-6), stores 2.6 (2.0-4), separate toilets 1.5
/// (1.1-2.2).
fn areas(kind: RoomKind) -> (f32, f32, f32, f32) {
    match kind {
        RoomKind::Living => (21.5, 0.24, 12.0, 60.0),
        RoomKind::Kitchen => (8.6, 0.22, 5.2, 16.0),
        RoomKind::Bedroom => (15.6, 0.17, 9.5, 28.0),
        RoomKind::Kids => (13.4, 0.15, 8.5, 22.0),
        RoomKind::Bathroom => (3.8, 0.2, 3.2, 9.0),
        RoomKind::Wc => (1.65, 0.12, 1.5, 2.4),
        RoomKind::Hall => (6.0, 0.3, 2.5, 16.0),
        RoomKind::Study => (9.0, 0.2, 6.0, 15.0),
        RoomKind::Laundry => (4.0, 0.18, 2.6, 7.0),
        RoomKind::Storage => (2.6, 0.2, 1.8, 6.0),
        RoomKind::Balcony => (4.2, 0.3, 1.6, 9.0),
    }
}

/// Draws the area of a room, square metres.
pub(super) fn draw_area(kind: RoomKind, rng: &mut Stream) -> f32 {
    let (median, spread, low, high) = areas(kind);
    (median * rng.normal(0.0, spread).exponential()).clamp(low, high)
}

impl Programme {
    /// Draws everything that the specification leaves open.
    ///
    /// # Errors
    /// [`SpecificationError`] if the requirements contradict each other.
    pub(crate) fn draw(specification: &Specification, seed: Seed) -> Result<Self, SpecificationError> {
        specification.check()?;
        let mut rng = seed.child("programme").stream();
        let bedrooms = specification.bedrooms.unwrap_or_else(|| draw_bedrooms(specification, &mut rng));
        let open = rng.chance(0.73);
        let mut programme = Self {
            wishes: Vec::new(),
            open_kitchen: bedrooms == 0 || specification.open_kitchen.unwrap_or(open),
            topology: Topology::draw(&mut rng),
            balconies: (rng.chance(0.58), rng.chance(0.67)),
            more_balconies: 0,
            wished_area: specification.area,
        };
        programme.set_balconies(specification.balconies, bedrooms);
        programme.draw_rooms(specification, bedrooms, &mut rng);
        programme.fit_area(specification.area)?;
        Ok(programme)
    }

    fn set_balconies(&mut self, wished: Option<usize>, bedrooms: usize) {
        match wished {
            Some(0) => self.balconies = (false, false),
            Some(1) => self.balconies = (self.balconies.0 || bedrooms == 0, !self.balconies.0 && bedrooms > 0),
            Some(more) => {
                self.balconies = (true, bedrooms > 0);
                self.more_balconies = more - 1 - usize::from(bedrooms > 0);
            }
            None => self.balconies.1 &= bedrooms > 0,
        }
    }

    fn draw_rooms(&mut self, specification: &Specification, bedrooms: usize, rng: &mut Stream) {
        let wish = |kind, of, rng: &mut Stream| Wish { kind, area: draw_area(kind, rng), of };
        let mut living = wish(RoomKind::Living, None, rng);
        living.area *= [1.25, 0.86, 1.0, 1.08, 1.15][bedrooms.min(4)];
        if bedrooms == 0 {
            // Bed, kitchen, table and seats are all in this room.
            living.area = living.area.max(20.0);
        }
        self.wishes.push(living);
        if bedrooms > 0 {
            self.wishes.push(wish(RoomKind::Kitchen, None, rng));
        }
        let first_bedroom = self.wishes.len();
        for i in 0..bedrooms {
            let kids = i > 0 && rng.chance(0.45);
            self.wishes.push(wish(if kids { RoomKind::Kids } else { RoomKind::Bedroom }, None, rng));
        }
        let mut optional = |wished: Option<bool>, chance: f32, kind: RoomKind| {
            if wished.unwrap_or_else(|| rng.chance(chance)) && (bedrooms > 0 || wished == Some(true)) {
                self.wishes.push(wish(kind, None, rng));
            }
        };
        let b = bedrooms as f32;
        optional(specification.study, 0.06 + 0.04 * b, RoomKind::Study);
        optional(specification.laundry, 0.05 + 0.08 * b, RoomKind::Laundry);
        optional(specification.storage, 0.25 + 0.1 * b, RoomKind::Storage);
        optional(specification.wc, 0.04 * b, RoomKind::Wc);
        self.draw_bathrooms(specification.bathrooms, bedrooms, first_bedroom, rng);
    }

    fn draw_bathrooms(&mut self, wished: Option<usize>, bedrooms: usize, first_bedroom: usize, rng: &mut Stream) {
        let usual = match bedrooms {
            0 | 1 => 1,
            2 => 1 + usize::from(rng.chance(0.65)),
            3 => 2 + usize::from(rng.chance(0.55)),
            _ => 3,
        };
        let count = wished.unwrap_or(usual);
        // A shared bathroom is not needed where every bedroom has its own.
        let common = count.saturating_sub(bedrooms).max(usize::from(count < bedrooms || rng.chance(0.67)));
        for i in 0..count {
            let of = (i >= common && bedrooms > 0).then(|| first_bedroom + (i - common) % bedrooms);
            let area = draw_area(RoomKind::Bathroom, rng);
            self.wishes.push(Wish { kind: RoomKind::Bathroom, area, of });
        }
    }

    /// The net area of all requested rooms, square metres; halls are extra.
    pub(crate) fn area(&self) -> f32 {
        self.wishes.iter().map(|w| w.area).sum()
    }

    /// Scales the rooms to a requested total, within the limits of each kind.
    fn fit_area(&mut self, wished: Option<f32>) -> Result<(), SpecificationError> {
        let Some(wished) = wished else { return Ok(()) };
        let bounds = |w: &Wish| (areas(w.kind).2, areas(w.kind).3);
        let hall = if self.wishes.len() > 2 { (self.wishes.len() as f32 * 0.9).max(2.5) } else { 0.0 };
        let needed = hall + self.wishes.iter().map(|w| bounds(w).0).sum::<f32>();
        let most = 1.4 * hall + self.wishes.iter().map(|w| bounds(w).1).sum::<f32>();
        let rooms = self.wishes.len();
        if wished < needed {
            let largest = self.wishes.iter().max_by(|a, b| bounds(a).0.total_cmp(&bounds(b).0));
            let (largest, share) = largest.map_or(("", 0.0), |w| (w.kind.title(), bounds(w).0));
            return Err(SpecificationError::TooSmall { rooms, needed, wished, largest, share });
        }
        if wished > most {
            return Err(SpecificationError::TooLarge { rooms, most, wished });
        }
        // Rooms at a limit leave the rest to the others.
        for _ in 0..8 {
            let factor = (wished - hall) / self.area();
            for wish in &mut self.wishes {
                let (low, high) = (areas(wish.kind).2, areas(wish.kind).3);
                wish.area = (wish.area * factor).clamp(low, high);
            }
        }
        Ok(())
    }

    /// The schemes to try: first one drawn by likelihood, then others as fallback.
    pub(super) fn schemes(&self, rng: &mut Stream) -> Vec<Scheme> {
        let bedrooms = self.wishes.iter().filter(|w| w.kind.is_bedroom()).count();
        if bedrooms == 0 {
            return vec![Scheme::Studio; 20];
        }
        let small = bedrooms == 1;
        let weights = [
            (Scheme::Bar, if small { 4.0 } else { 0.8 }),
            (Scheme::Corridor, if small { 0.5 } else { 3.0 }),
            (Scheme::CentralHall, if small { 0.5 } else { 1.6 }),
            (Scheme::OpenPlan, if self.open_kitchen { 2.0 } else { 0.3 }),
            (Scheme::LPlan, if small { 0.5 } else { 1.5 }),
            (Scheme::Irregular, 0.35),
        ];
        let first = rng.weighted(weights.iter().map(|w| w.1)).unwrap_or(0);
        // Growing rooms draws hundreds of candidates of its own each time.
        let times = if weights[first].0 == Scheme::Irregular { 1 } else { 4 };
        let mut order = vec![weights[first].0; times];
        let rest =
            [Scheme::OpenPlan, Scheme::Corridor, Scheme::LPlan, Scheme::CentralHall, Scheme::Bar, Scheme::Irregular];
        order.extend(rest.into_iter().flat_map(|s| [s; 2]));
        order.extend([Scheme::Annealed; 3]);
        order
    }
}

/// The number of bedrooms where none is specified: the number that the other requirements need,
/// else the usual mix.
fn draw_bedrooms(specification: &Specification, rng: &mut Stream) -> usize {
    let usual = rng.weighted([10.0, 30.0, 35.0, 20.0, 5.0].into_iter()).unwrap_or(1);
    let bathrooms = specification.bathrooms.map_or(0, |b| b.saturating_sub(1));
    // A specified area determines the number, by the area that homes of that size usually have.
    let by_area = specification.area.map(|a| match a {
        a if a < 38.0 => 0,
        a if a < 60.0 => 1,
        a if a < 88.0 => 2,
        a if a < 125.0 => 3,
        a if a < 170.0 => 4,
        _ => 5,
    });
    by_area.unwrap_or(usual).max(bathrooms)
}
