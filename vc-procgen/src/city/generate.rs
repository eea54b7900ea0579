//! From a seed to a plan.

use vc_graph::Seed;
use vc_map::{AreaKind, EntranceDraft, MapDraft, Point, StopDraft, StopKind};

use super::building::{self, CityBuilding, street_side};
use super::convex::Beyond;
use super::error::CityPlanError;
use super::field::{Field, StreetPattern};
use super::net::Net;
use super::specification::CitySpecification;
use super::street_class::StreetClass;
use super::view::View;
use super::zone::{self, CityZone};
use super::{
    BuildingType, CityBlock, CityPlan, Parcel, Park, ParkFeature, Street, block, edge, garden, item, outline, parcel,
    park, parked, places, street, view, wing,
};

/// Bus stops are about this far apart, this far behind a junction, and before the next one, metres.
const STOPS: f64 = 330.0;
const BEHIND: f64 = 26.0;
const AHEAD: f64 = 30.0;
/// Blocks with half of the streets around them, short and long side: in the core and outside, metres.
const BLOCKS: [[f64; 2]; 2] = [[84.0, 146.0], [104.0, 182.0]];
/// The share of the area within which blocks are small.
const CORE: f64 = 0.18;
/// The number of residents is met within this share, in this many rounds.
const NEAR: f64 = 0.06;
const ROUNDS: usize = 5;
/// The chance that there are shops on the ground along a main street or in the core, beside shopping streets.
const SHOPS_ELSEWHERE: f32 = 0.4;

impl CityPlan {
    /// The city of a seed: a square kilometre with some 15,000 residents.
    ///
    /// ```
    /// use vc_procgen::city::CityPlan;
    /// let plan = CityPlan::from_seed(vc_graph::Seed(7))?;
    /// assert!(plan.buildings().len() > 300 && plan.residents() > 12_000.0);
    /// # Ok::<(), vc_procgen::city::CityPlanError>(())
    /// ```
    ///
    /// # Errors
    /// None that is known; those of [`Self::generate`] are for specifications out of range.
    pub fn from_seed(seed: Seed) -> Result<Self, CityPlanError> {
        Self::generate(&CitySpecification::default(), seed)
    }

    /// The city of a seed for a specification. Costs some tens of milliseconds for each square kilometre.
    ///
    /// # Errors
    /// [`CityPlanError::OutOfRange`] for absurd wishes.
    pub fn generate(specification: &CitySpecification, seed: Seed) -> Result<Self, CityPlanError> {
        specification.check()?;
        let mut stream = seed.child("city").stream();
        let drawn = StreetPattern::ALL[stream.below(StreetPattern::ALL.len())];
        let heading = f64::from(stream.between(-0.3, 0.3));
        let pattern = specification.pattern.unwrap_or(drawn);
        let area = specification.area * 1e6;
        let rim = outline::outline(pattern, heading, area, seed);
        let field = Field::new(pattern, heading, area.sqrt(), Point::origin(), seed);
        let core = (CORE * area / std::f64::consts::PI).sqrt();
        let blocks = |at: &Point| {
            let out = ((at.coords.norm() / core - 1.0) / 0.6).clamp(0.0, 1.0);
            [0, 1].map(|i| BLOCKS[0][i] + (BLOCKS[1][i] - BLOCKS[0][i]) * out)
        };
        let mut net = Net::within(&rim, &field, pattern, blocks, seed);
        street::classes(&mut net, &Point::origin(), seed);
        let (mut draft, streets) = street::draft(&net, format!("city {}", seed.0), seed);
        // Doors, areas and stops do not change what drivers see.
        let views = view::views(&draft.clone().build()?);
        let (blocks, parcels, mut buildings) = built(&net, &streets, &views, specification, seed);
        let residents = buildings.iter().map(CityBuilding::residents).sum();
        places::deal(&mut buildings, residents, seed.child("places"));
        put(&mut draft, &buildings, &streets);
        let parks = parks(&blocks, seed);
        parks.iter().for_each(|park| put_park(&mut draft, &blocks, park));
        let (shore, railway) = (edge::shore(&rim, specification.waterside, seed), edge::railway(&rim));
        edge::put(&mut draft, shore.as_ref(), railway.as_ref());
        bus_stops(&mut draft, &streets);
        let map = draft.build()?;
        let (items, cars) = (view::without(item::items(&map, seed), &views), parked::parked(&map, &views, seed));
        let trees = garden::trees(&parcels, &buildings, &items, seed);
        Ok(Self {
            seed,
            pattern,
            outline: rim,
            map,
            streets,
            blocks,
            parcels,
            buildings,
            parks,
            shore,
            railway,
            items,
            cars,
            trees,
        })
    }
}

/// Blocks, parcels and buildings for about as many residents as are wished for.
fn built(
    net: &Net,
    streets: &[Street],
    views: &[View],
    specification: &CitySpecification,
    seed: Seed,
) -> (Vec<CityBlock>, Vec<Parcel>, Vec<CityBuilding>) {
    let mut blocks = block::blocks(net);
    block::clear_views(&mut blocks, views);
    let wished = specification.area * specification.density;
    let mut planned = wished;
    let mut found = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let zones = zone::zones(&blocks, &Point::origin(), specification.parks, planned, wished, seed);
        blocks.iter_mut().zip(zones).for_each(|(block, zone)| block.zone = zone);
        found = houses(&blocks, streets, seed);
        let residents: f64 = found.1.iter().map(CityBuilding::residents).sum();
        if (residents / wished - 1.0).abs() < NEAR {
            break;
        }
        planned *= (wished / residents.max(1.0)).clamp(0.5, 2.0);
    }
    (blocks, found.0, found.1)
}

/// The parcels of blocks with their buildings.
fn houses(blocks: &[CityBlock], streets: &[Street], seed: Seed) -> (Vec<Parcel>, Vec<CityBuilding>) {
    let (mut parcels, mut buildings) = (Vec::new(), Vec::new());
    for (index, block) in blocks.iter().enumerate() {
        let seed = seed.child("block").nth(index as u64);
        let first = !blocks[..index].iter().any(|other| other.zone == block.zone);
        let Some(kind) = zone::building_type(block.zone, first, seed.child("type")) else {
            parcels.push(Parcel { block: index, land: block.land.clone() });
            continue;
        };
        for (nth, land) in
            parcel::parcels(&block.land, kind.measures().parcel, seed.child("parcel")).into_iter().enumerate()
        {
            let own = seed.child("building").nth(nth as u64);
            let storeys = building::storeys(kind, seed, own);
            let shops = shops(&land, block.zone, streets, own);
            buildings.extend(CityBuilding::on(&land, parcels.len(), kind, storeys, shops));
            parcels.push(Parcel { block: index, land });
        }
    }
    (parcels, buildings)
}

/// Whether a building on a parcel has shops on the ground.
fn shops(land: &super::Convex, zone: CityZone, streets: &[Street], seed: Seed) -> bool {
    let class = |beyond: Beyond| match beyond {
        Beyond::Street(street) => streets.get(street).map(|street| street.class),
        _ => None,
    };
    let classes: Vec<StreetClass> = land.sides().filter_map(|(_, _, beyond)| class(beyond)).collect();
    if !matches!(zone, CityZone::Core | CityZone::Flats) || street_side(land).is_none() {
        return false;
    }
    let inner = zone == CityZone::Core || classes.iter().any(|class| class.is_main());
    classes.contains(&StreetClass::Shopping) || (inner && seed.child("shops").stream().chance(SHOPS_ELSEWHERE))
}

/// Puts buildings and their doors onto a map.
fn put(draft: &mut MapDraft, buildings: &[CityBuilding], streets: &[Street]) {
    let plain = |ring: Vec<Point>| ring.into_iter().map(|point| [point.x, point.y]).collect::<Vec<[f64; 2]>>();
    for (index, own) in buildings.iter().enumerate() {
        let ground: Vec<&super::Convex> =
            own.wings.iter().filter(|wing| wing.from == 0).map(|wing| &wing.plan).collect();
        let mut rings = wing::rings(&ground).into_iter().map(plain);
        let Some(outline) = rings.next() else { continue };
        let mut building = vc_map::Building::new(outline, own.storeys as u32);
        building.courts = rings.collect();
        building.height = own.height();
        building.kind = osm(own.kind).to_owned();
        let doors = own.doors();
        building.address = doors
            .first()
            .and_then(|door| streets.get(door.street))
            .map(|street| format!("{} {}", street.name, index + 1));
        draft.buildings.push(building);
        let id = vc_map::BuildingId((draft.buildings.len() - 1) as u32);
        draft.entrances.extend(doors.iter().map(|door| EntranceDraft {
            building: id,
            at: [door.at.x, door.at.y],
            kind: "main".to_owned(),
            source: 1,
        }));
    }
}

/// The value of OpenStreetMap's key `building` for a type.
fn osm(kind: BuildingType) -> &'static str {
    match kind {
        BuildingType::Detached => "detached",
        BuildingType::Row => "terrace",
        BuildingType::Office => "office",
        BuildingType::Hall => "retail",
        BuildingType::Civic => "public",
        _ => "apartments",
    }
}

/// The parks of the blocks that are some.
fn parks(blocks: &[CityBlock], seed: Seed) -> Vec<Park> {
    let parks = blocks.iter().enumerate().filter(|(_, block)| block.zone == CityZone::Park);
    parks.map(|(index, block)| park::park(index, &block.land, seed.child("park").nth(index as u64))).collect()
}

fn put_park(draft: &mut MapDraft, blocks: &[CityBlock], park: &Park) {
    if let Some(block) = blocks.get(park.block) {
        edge::area(draft, AreaKind::Green, block.land.corners(), "park");
    }
    for (kind, ring) in &park.features {
        let (kind, name) = match kind {
            ParkFeature::Pond => (AreaKind::Water, "pond"),
            ParkFeature::Playground => (AreaKind::Square, "playground"),
            ParkFeature::Court => (AreaKind::Square, "court"),
        };
        edge::area(draft, kind, ring, name);
    }
}

/// Bus stops on both sides of main streets, behind junctions.
fn bus_stops(draft: &mut MapDraft, streets: &[Street]) {
    for street in streets.iter().filter(|street| street.class.is_main()) {
        for forward in [true, false] {
            bus_line(draft, street, forward);
        }
    }
}

/// The stops of buses that go along a street in one direction.
fn bus_line(draft: &mut MapDraft, street: &Street, forward: bool) {
    let mut since = STOPS / 2.0;
    let mut roads = street.roads.clone();
    if !forward {
        roads.reverse();
    }
    for road in roads {
        let Some(line) =
            draft.roads.get(road.index()).and_then(|road| vc_map::Polyline::new(road.line.iter().copied()))
        else {
            continue;
        };
        let line = if forward { line } else { line.reversed() };
        // Behind the junction, and clear of the next one.
        let mut station = BEHIND;
        while station + AHEAD < line.length() {
            if since + station >= STOPS {
                let right = -super::convex::left(line.direction(station));
                let at = line.at(station) + right * (street.class.kerb() + 0.5);
                draft.stops.push(StopDraft {
                    kind: StopKind::Bus,
                    at: [at.x, at.y],
                    name: Some(street.name.clone()),
                    source: 0,
                });
                since = -station;
            }
            station += 10.0;
        }
        since += line.length();
    }
}
