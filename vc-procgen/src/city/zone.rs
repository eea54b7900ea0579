//! Zones: the use of each block.

use vc_graph::Seed;
use vc_map::Point;

use super::block::CityBlock;
use super::building_type::BuildingType;

/// The use of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum CityZone {
    /// The middle of the city: offices, flats and shops.
    Core,
    /// Blocks of flats.
    Flats,
    /// Houses.
    Homes,
    /// Offices and halls.
    Work,
    /// Schools and libraries.
    Civic,
    /// A park.
    Park,
}

impl CityZone {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Core, Self::Flats, Self::Homes, Self::Work, Self::Civic, Self::Park];

    /// The word in texts and pictures.
    pub fn word(self) -> &'static str {
        match self {
            Self::Core => "core",
            Self::Flats => "flats",
            Self::Homes => "homes",
            Self::Work => "work",
            Self::Civic => "civic",
            Self::Park => "park",
        }
    }
}

/// The share of the land that is core, and that is for work.
const CORE: f64 = 0.17;
const WORK: f64 = 0.1;
/// A civic block serves this many residents.
const CIVIC: f64 = 4_500.0;
/// Residents for each square metre of land, in the order of [`CityZone::ALL`].
const DENSITY: [f64; 6] = [0.026, 0.040, 0.0150, 0.0, 0.0, 0.0];

/// The zones of blocks: parks far from each other, work to the north, the core about the centre, flats around it, as far as
/// some residents need them.
pub(super) fn zones(
    blocks: &[CityBlock],
    centre: &Point,
    parks: f64,
    residents: f64,
    civic: f64,
    seed: Seed,
) -> Vec<CityZone> {
    let areas: Vec<f64> = blocks.iter().map(|block| block.land.area()).collect();
    let middles: Vec<Point> = blocks.iter().map(|block| block.land.middle()).collect();
    let all: f64 = areas.iter().sum();
    let radius = (all / std::f64::consts::PI).sqrt();
    let noise = |label: &str, index: usize| f64::from(seed.child(label).nth(index as u64).stream().between(-1.0, 1.0));
    let mut zones = vec![CityZone::Homes; blocks.len()];
    // The first park lies between the middle and the edge.
    let room = middles.iter().map(|middle| 2.0 * radius - ((middle - centre).norm() - 0.35 * radius).abs()).collect();
    spread(&mut zones, &middles, &areas, CityZone::Park, room, |_, sum| sum >= parks * all);
    let order = |key: &dyn Fn(usize) -> f64, zones: &[CityZone]| {
        let mut order: Vec<usize> = (0..blocks.len()).filter(|block| zones[*block] == CityZone::Homes).collect();
        order.sort_by(|a, b| key(*a).total_cmp(&key(*b)).then(a.cmp(b)));
        order
    };
    let away = |block: usize| (middles[block] - centre).norm() / radius + 0.1 * noise("away", block);
    let fill = |zones: &mut Vec<CityZone>, order: Vec<usize>, zone: CityZone, share: f64| {
        let mut sum = 0.0;
        for block in order {
            if sum >= share * all {
                break;
            }
            sum += areas[block];
            zones[block] = zone;
        }
    };
    let core = order(&away, &zones);
    fill(&mut zones, core, CityZone::Core, CORE);
    let north = order(&|block| -(middles[block].y - centre.y) / radius + 0.15 * noise("work", block), &zones);
    fill(&mut zones, north, CityZone::Work, WORK);
    let room = middles.iter().map(|middle| 2.0 * radius - (middle - centre).norm()).collect();
    spread(&mut zones, &middles, &areas, CityZone::Civic, room, |count, _| count as f64 * CIVIC >= civic);
    let inner = order(&away, &zones);
    let mut sum: f64 = (0..blocks.len()).map(|block| DENSITY[zones[block] as usize] * areas[block]).sum();
    for block in inner {
        if sum >= residents {
            break;
        }
        sum += (DENSITY[1] - DENSITY[2]) * areas[block];
        zones[block] = CityZone::Flats;
    }
    zones
}

/// Gives blocks of homes a zone, one after the other as far from each other as can be, until `enough` says so of their number
/// and area. `room` has the room that blocks have to begin with.
fn spread(
    zones: &mut [CityZone],
    middles: &[Point],
    areas: &[f64],
    zone: CityZone,
    mut room: Vec<f64>,
    enough: impl Fn(usize, f64) -> bool,
) {
    let (mut count, mut sum) = (0, 0.0);
    while !enough(count, sum) {
        let free = (0..zones.len()).filter(|block| zones[*block] == CityZone::Homes);
        let Some(best) = free.max_by(|a, b| room[*a].total_cmp(&room[*b]).then(b.cmp(a))) else { break };
        zones[best] = zone;
        (count, sum) = (count + 1, sum + areas[best]);
        for (room, middle) in room.iter_mut().zip(middles) {
            *room = room.min((middle - middles[best]).norm());
        }
    }
}

/// The type of the buildings of a block, the first of its zone or a later one; `None` for a park.
pub(super) fn building_type(zone: CityZone, first: bool, seed: Seed) -> Option<BuildingType> {
    let column = match zone {
        CityZone::Core => 0,
        CityZone::Flats => 1,
        CityZone::Homes => 2,
        // There are halls in every city.
        CityZone::Work if first => return Some(BuildingType::Hall),
        CityZone::Work => 3,
        CityZone::Civic => return Some(BuildingType::Civic),
        CityZone::Park => return None,
    };
    let weights = BuildingType::ALL.map(|kind| kind.measures().weights[column]);
    seed.stream().weighted(weights.into_iter()).map(|index| BuildingType::ALL[index])
}
