//! Which shop, hall or public building is where: as many of each kind as the residents need, the rest by weight.

use vc_graph::Seed;

use super::building::CityBuilding;
use super::building_type::BuildingType;
use super::unit_kind::{UnitKind, UnitPlace};

/// Gives all units that are no homes and no offices of upper storeys their kinds.
pub(super) fn deal(buildings: &mut [CityBuilding], residents: f64, seed: Seed) {
    for (place, label) in [(UnitPlace::Shop, "shops"), (UnitPlace::Hall, "halls"), (UnitPlace::Civic, "civic")] {
        let slots = |building: &CityBuilding| match (place, building.kind) {
            (UnitPlace::Hall, BuildingType::Hall) | (UnitPlace::Civic, BuildingType::Civic) => 1,
            (UnitPlace::Shop, _) => building.shops,
            _ => 0,
        };
        let total = buildings.iter().map(slots).sum();
        let mut kinds = kinds(place, total, residents, seed.child(label)).into_iter();
        for building in buildings.iter_mut() {
            let count = slots(building);
            if count > 0 {
                building.places = kinds.by_ref().take(count).collect();
            }
        }
    }
}

/// Kinds for a number of units: those that are needed first, in a random order together.
fn kinds(place: UnitPlace, count: usize, residents: f64, seed: Seed) -> Vec<UnitKind> {
    let all: Vec<UnitKind> = UnitKind::all().filter(|kind| kind.place() == place).collect();
    let mut stream = seed.stream();
    let needed = |kind: &UnitKind| kind.residents().map_or(0, |each| (residents / each).ceil() as usize);
    // The kinds that most people need first, as there may not be room for all.
    let mut order = all.clone();
    order.sort_by(|a, b| a.residents().unwrap_or(0.0).total_cmp(&b.residents().unwrap_or(0.0)));
    // One of each, before there is a second of any.
    let needs: Vec<(UnitKind, usize)> = order.iter().map(|kind| (*kind, needed(kind))).collect();
    let most = needs.iter().map(|(_, count)| *count).max().unwrap_or(0);
    let rounds =
        (0..most).flat_map(|round| needs.iter().filter(move |(_, count)| round < *count).map(|(kind, _)| *kind));
    let mut dealt: Vec<UnitKind> = rounds.take(count).collect();
    while dealt.len() < count {
        let Some(index) = stream.weighted(all.iter().map(|kind| kind.weight())) else { break };
        dealt.push(all[index]);
    }
    stream.shuffle(&mut dealt);
    dealt
}
