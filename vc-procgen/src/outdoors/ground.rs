//! The ground: carriageways, pavements, land, parks, water.

use vc_graph::portable::Portable;
use vc_map::{Point, RoadId, StripKind};
use vc_shapes::Build;
use vc_shapes::material::{
    ASPHALT, CONCRETE, GRASS, GRAVEL, HAY, MaterialId, POOL_WATER, SAND_TILE, TERRACOTTA, WATER,
};

use super::strip::{slabs, strip};
use super::{KERB, Outdoors, Place};
use crate::circulation::parts::built;
use crate::city::{Beyond, CityZone, Convex, Park, ParkFeature, StreetDoor};
use crate::item::Item;

/// How deep pavements and land go into the ground, and how far the country around the city lies below, metres.
const DEEP: f32 = 0.4;
const COUNTRY: f32 = 0.5;
/// Surfaces that lie on others are so much higher, metres.
const ABOVE: f32 = 0.012;
/// The width of a path from a door to the street, metres.
const PATH: f64 = 1.5;
/// The country goes on beyond the reach of a place so many times.
const HORIZON: f64 = 4.0;

/// All of it within the reach of a place.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place) -> Vec<Item> {
    let blocks = outdoors.blocks.around(&place.at, place.reach);
    let mut items = vec![country(outdoors, place)];
    items.extend(blocks.iter().flat_map(|block| of_block(outdoors, place, *block)));
    let roads = outdoors.roads.around(&place.at, place.reach);
    items.extend(roads.into_iter().filter_map(|road| of_road(outdoors, place, road, &blocks)));
    let parks = outdoors.city.parks().iter().filter(|park| blocks.contains(&park.block));
    items.extend(parks.map(|park| of_park(outdoors, place, park)));
    items.extend(paths(outdoors, place));
    items.extend(shore(outdoors, place));
    items
}

fn item(outdoors: &Outdoors<'_>, class: &'static str, build: impl FnOnce(&mut Build<'_>)) -> Item {
    built(class, [0.0; 3], &outdoors.style, build)
}

/// A flat piece of ground, or a solid one.
fn solid(b: &mut Build<'_>, place: &Place, ring: &[Point], (low, high): (f32, f32), name: &str, material: MaterialId) {
    let corners = ring.iter().flat_map(|at| [low, high].map(|z| place.point(at, z)));
    b.hull(name, &corners.collect::<Vec<[f32; 3]>>(), material);
}

fn flat(b: &mut Build<'_>, place: &Place, ring: &[Point], z: f32, name: &str, material: MaterialId) {
    let corners: Vec<[f32; 3]> = ring.iter().map(|at| place.point(at, z)).collect();
    let triangles = (2..corners.len() as u32).map(|i| [0, i - 1, i]).collect();
    b.mesh(name, corners, triangles, material);
}

/// The parts of a polygon outside another one within it.
fn outside(around: &Convex, hole: &Convex) -> Vec<Convex> {
    let (mut rest, mut parts) = (Some(around.clone()), Vec::new());
    for (a, b, _) in hole.sides() {
        let along = (b - a).normalize();
        let Some(whole) = rest else { break };
        parts.extend(whole.cut(&a, &-along, Beyond::Court));
        rest = whole.cut(&a, &along, Beyond::Court);
    }
    parts
}

fn country(outdoors: &Outdoors<'_>, place: &Place) -> Item {
    let far = place.reach * HORIZON;
    let corner = |i: u32| {
        let (sine, cosine) = (f64::from(i) * std::f64::consts::TAU / 16.0).sine_cosine();
        Point::new(place.at.x + far * cosine, place.at.y + far * sine)
    };
    let ring: Vec<Point> = (0..16).map(corner).collect();
    item(outdoors, "lawn", |b| solid(b, place, &ring, (-COUNTRY - 0.1, -COUNTRY), "country", GRASS))
}

/// The surface of the land of a zone.
fn surface(zone: CityZone) -> (&'static str, MaterialId) {
    match zone {
        CityZone::Core => ("pavement", SAND_TILE),
        CityZone::Flats | CityZone::Homes | CityZone::Park => ("lawn", GRASS),
        CityZone::Work => ("road", ASPHALT),
        CityZone::Civic => ("pavement", CONCRETE),
    }
}

/// Carriageway, pavement and land of a block.
fn of_block(outdoors: &Outdoors<'_>, place: &Place, number: usize) -> Vec<Item> {
    let block = &outdoors.city.blocks()[number];
    let kerb = Convex::new(block.kerb.clone(), vec![Beyond::Court; block.kerb.len()]);
    let mut items = vec![
        item(outdoors, "road", |b| {
            for part in outside(&block.face, &kerb) {
                solid(b, place, part.corners(), (-KERB - DEEP, -KERB), "asphalt", ASPHALT);
            }
        }),
        item(outdoors, "pavement", |b| {
            for part in outside(&kerb, &block.land) {
                solid(b, place, part.corners(), (-DEEP, 0.0), "pavement", CONCRETE);
            }
        }),
    ];
    let (class, material) = surface(block.zone);
    items.push(item(outdoors, class, |b| solid(b, place, block.land.corners(), (-DEEP, 0.0), "land", material)));
    items
}

/// Paths from doors to the street where houses stand back from it.
fn paths(outdoors: &Outdoors<'_>, place: &Place) -> Option<Item> {
    let near = outdoors.buildings.around(&place.at, place.reach);
    let houses = near.into_iter().map(|number| &outdoors.city.buildings()[number]);
    let paths: Vec<[Point; 2]> = houses
        .filter(|house| house.kind.setback() > 0.3)
        .flat_map(|house| {
            let ends = |door: StreetDoor| [door.at, door.at + door.out * house.kind.setback()];
            house.doors().into_iter().map(ends).collect::<Vec<_>>()
        })
        .collect();
    (!paths.is_empty()).then(|| {
        item(outdoors, "pavement", |b| {
            paths.iter().for_each(|path| strip(b, place, path, (PATH, ABOVE), "path", CONCRETE));
        })
    })
}

/// The surface of a road where no block has it, its median and its cycle lanes.
fn of_road(outdoors: &Outdoors<'_>, place: &Place, number: usize, blocks: &[usize]) -> Option<Item> {
    let map = outdoors.city.map();
    let road = map.road(RoadId(number as u32)).filter(|road| road.draft.class.is_street())?;
    let section = &road.draft.section;
    let lanes = || road.lanes.iter().filter_map(|id| map.lane(*id));
    let is_in_block = |at: &Point| blocks.iter().any(|block| outdoors.city.blocks()[*block].face.contains(at, -0.01));
    let between = road.line.part(road.cuts[0], road.line.length() - road.cuts[1]);
    Some(item(outdoors, "road", |b| {
        strip(b, place, road.line.points(), (section.surface(), -KERB - 0.02), "asphalt", ASPHALT);
        if let Some(line) = between.filter(|_| section.median > 0.5) {
            slabs(b, place, line.points(), (section.median - 0.3, -KERB - DEEP, 0.0), "median", GRASS);
        }
        for lane in lanes() {
            match lane.kind {
                StripKind::Cycle => {
                    strip(b, place, lane.line.points(), (lane.width, 0.005 - KERB), "cycle lane", TERRACOTTA);
                }
                StripKind::Pavement if !is_in_block(&lane.line.at(lane.line.length() / 2.0)) => {
                    slabs(b, place, lane.line.points(), (lane.width, -KERB - DEEP, 0.0), "pavement", CONCRETE);
                }
                _ => {}
            }
        }
    }))
}

/// Paths and features of a park.
fn of_park(outdoors: &Outdoors<'_>, place: &Place, park: &Park) -> Item {
    item(outdoors, "pavement", |b| {
        for gate in &park.gates {
            strip(b, place, &[*gate, park.middle], (park.path, ABOVE), "path", GRAVEL);
        }
        for (feature, ring) in &park.features {
            let material = match feature {
                ParkFeature::Pond => POOL_WATER,
                ParkFeature::Playground => HAY,
                ParkFeature::Court => TERRACOTTA,
            };
            flat(b, place, ring, 2.0 * ABOVE, "feature", material);
        }
    })
}

fn shore(outdoors: &Outdoors<'_>, place: &Place) -> Vec<Item> {
    let Some(shore) = outdoors.city.shore() else { return Vec::new() };
    let is_near = |ring: &[Point]| ring.iter().any(|at| place.distance(at) < place.reach + 150.0);
    let mut items = Vec::new();
    if is_near(&shore.water) {
        items.push(item(outdoors, "pavement", |b| {
            flat(b, place, &shore.water, ABOVE - COUNTRY, "water", WATER);
            shore.sand.iter().for_each(|sand| flat(b, place, sand, 2.0 * ABOVE - COUNTRY, "sand", HAY));
        }));
    }
    items
}
