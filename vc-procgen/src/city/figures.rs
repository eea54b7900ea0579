//! Figures of a plan beside those of real cities, from `data/city_figures.txt`.

use std::collections::BTreeMap;

use super::{BuildingType, CityBuilding, CityPlan, CityZone, StreetClass, UnitPlace};

/// The crown of a tree along a street and in a garden or park, square metres: 6 and 7.2 m wide.
const CROWNS: [f64; 2] = [28.0, 41.0];

/// A figure of a plan, with the band in which those of real cities lie.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CityFigure {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
    /// The least and the greatest value of real cities.
    pub band: [f64; 2],
    /// The source of the band.
    pub source: &'static str,
}

impl CityFigure {
    /// Whether it lies within its band.
    pub fn is_within(&self) -> bool {
        (self.band[0]..=self.band[1]).contains(&self.value)
    }
}

fn rows() -> impl Iterator<Item = [&'static str; 5]> {
    let lines = include_str!("../../data/city_figures.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| <[&str; 5]>::try_from(line.split('|').map(str::trim).collect::<Vec<_>>()).ok())
}

impl CityPlan {
    /// Its figures beside those of real cities. Costs the units of all ground storeys.
    ///
    /// ```
    /// use vc_procgen::city::CityPlan;
    /// let figures = CityPlan::from_seed(vc_graph::Seed(7))?.figures();
    /// let parks = figures.iter().find(|figure| figure.name == "parks").ok_or("parks")?;
    /// assert!(parks.is_within() && figures.iter().filter(|figure| figure.is_within()).count() > 12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn figures(&self) -> Vec<CityFigure> {
        let mut values: BTreeMap<&str, f64> = BTreeMap::new();
        self.network(&mut values);
        self.land(&mut values);
        self.shopping(&mut values);
        let figure = |[name, unit, least, greatest, source]: [&'static str; 5]| {
            let band = [least.parse().ok()?, greatest.parse().ok()?];
            Some(CityFigure { name, unit, value: *values.get(name)?, band, source })
        };
        rows().filter_map(figure).collect()
    }

    /// The area within the middle of its outermost street, square metres.
    pub fn area(&self) -> f64 {
        self.blocks.iter().map(|block| block.face.area()).sum()
    }

    fn network(&self, values: &mut BTreeMap<&str, f64>) {
        let square = self.area() / 1e6;
        let arms: Vec<usize> =
            self.map.junctions().iter().map(|junction| junction.arms.len()).filter(|arms| *arms > 0).collect();
        // The two ends of the railway are no junctions of streets.
        let ends = if self.railway.is_some() { 2 } else { 0 };
        let count = arms.len().saturating_sub(ends) as f64;
        let dead = arms.iter().filter(|arms| **arms == 1).count().saturating_sub(ends) as f64;
        let streets = self.map.roads().iter().filter(|road| road.draft.class.is_street());
        let mut lengths: Vec<f64> = streets.clone().map(|road| road.line.length()).collect();
        let straight: f64 = streets.map(|road| (road.line.end() - road.line.start()).norm()).sum();
        lengths.sort_by(f64::total_cmp);
        let all: f64 = lengths.iter().sum();
        let degrees = arms.iter().sum::<usize>().saturating_sub(ends) as f64;
        let land: f64 = self.blocks.iter().map(|block| block.land.area()).sum();
        values.extend([
            ("junctions", count / square),
            ("streets", all / 1000.0 / square),
            ("street land", 100.0 * (1.0 - land / self.area())),
            ("four-way junctions", 100.0 * arms.iter().filter(|arms| **arms == 4).count() as f64 / count),
            ("mean node degree", degrees / count),
            ("dead ends", 100.0 * dead / count),
            ("median segment", lengths.get(lengths.len() / 2).copied().unwrap_or(0.0)),
            ("circuity", all / straight),
        ]);
    }

    fn land(&self, values: &mut BTreeMap<&str, f64>) {
        let zone = |building: &CityBuilding| {
            self.parcels.get(building.parcel).and_then(|parcel| self.blocks.get(parcel.block)).map(|block| block.zone)
        };
        let face = |of: CityZone| {
            self.blocks.iter().filter(|block| block.zone == of).map(|block| block.face.area()).sum::<f64>()
        };
        for (of, names) in [
            (CityZone::Core, ["coverage, core", "floor area, core", "storeys, core"]),
            (CityZone::Homes, ["coverage, homes", "floor area, homes", "storeys, homes"]),
        ] {
            let own = self.buildings.iter().filter(|building| zone(building) == Some(of));
            let [covered, floors] = own
                .clone()
                .map(CityBuilding::areas)
                .fold([0.0; 2], |sum, areas| [sum[0] + areas[0], sum[1] + areas[1]]);
            let mut storeys: Vec<usize> = own.map(|building| building.storeys).collect();
            storeys.sort_unstable();
            let land = face(of).max(1.0);
            let median = storeys.get(storeys.len() / 2).map_or(0.0, |storeys| *storeys as f64);
            values.extend([(names[0], covered / land), (names[1], floors / land), (names[2], median)]);
        }
        let street = self.items.iter().filter(|item| item.class == "tree").count() as f64;
        let other = (self.trees.len() + self.parks.iter().map(|park| park.trees.len()).sum::<usize>()) as f64;
        values.insert("canopy", 100.0 * (street * CROWNS[0] + other * CROWNS[1]) / self.area());
        values.insert("parks", 100.0 * face(CityZone::Park) / self.area());
        values.insert("residents", self.residents() / (self.area() / 1e6));
    }

    /// Fronts of shops along shopping streets, as a share of all fronts there, and the distance from door to door.
    fn shopping(&self, values: &mut BTreeMap<&str, f64>) {
        let class = |street: usize| self.streets.get(street).map(|street| street.class);
        let (mut all, mut shops, mut doors) = (0.0, 0.0, 0.0);
        for building in self.buildings.iter().filter(|building| building.kind != BuildingType::Civic) {
            let ground = building.wings.iter().filter(|wing| wing.from == 0);
            let sides = ground.flat_map(|wing| wing.plan.sides().collect::<Vec<_>>());
            all += sides.filter(|side| shopping(side.2, class)).map(|(a, b, _)| (b - a).norm()).sum::<f64>();
            for unit in building.units(0).iter().filter(|unit| unit.kind.place() == UnitPlace::Shop) {
                let front: f64 =
                    unit.outline.sides().filter(|side| shopping(side.2, class)).map(|(a, b, _)| (b - a).norm()).sum();
                shops += front;
                doors += f64::from(front > 0.0);
            }
        }
        values.insert("shop fronts", 100.0 * shops / f64::max(all, 1.0));
        values.insert("shop doors", shops / f64::max(doors, 1.0));
    }
}

fn shopping(beyond: super::Beyond, class: impl Fn(usize) -> Option<StreetClass>) -> bool {
    matches!(beyond, super::Beyond::Street(street) if class(street) == Some(StreetClass::Shopping))
}
