//! Plans as drawings: the map over the colours of zones, buildings by their use, trees and cars.

use vc_map::Point;
use vc_map::picture::{Colour, Drawing, Entry, Paint, Shape};

use super::{BuildingType, CityBuilding, CityPlan, CityZone, ParkFeature};

/// The legend stands beside the plan, in a margin of this width, metres.
const LEGEND: f64 = 130.0;

const TREE: Colour = [104, 158, 92];
const CAR: Colour = [52, 74, 122];
const LAMP: Colour = [250, 208, 70];
const SHOPS: Colour = [226, 116, 92];
const SAND: Colour = [240, 224, 176];
const WALL: Colour = [96, 78, 70];
const PAVEMENT: Colour = [205, 200, 190];
const WATER: Colour = [150, 192, 222];
const PATH: Colour = [232, 220, 190];
const PLAY: Colour = [222, 150, 112];

fn ground(zone: CityZone) -> (Colour, &'static str) {
    match zone {
        CityZone::Core => ([240, 226, 214], "core"),
        CityZone::Flats => ([232, 232, 214], "flats, with their courts"),
        CityZone::Homes => ([216, 232, 198], "homes, with their gardens"),
        CityZone::Work => ([226, 222, 236], "work"),
        CityZone::Civic => ([244, 232, 180], "school, library"),
        CityZone::Park => ([168, 208, 146], "park"),
    }
}

fn mass(kind: BuildingType) -> (Colour, &'static str) {
    match kind {
        BuildingType::Detached | BuildingType::Row => ([196, 166, 138], "houses"),
        BuildingType::Slab | BuildingType::Perimeter => ([190, 150, 130], "flats"),
        BuildingType::Tower => ([128, 88, 96], "tower"),
        BuildingType::Office => ([140, 148, 178], "offices"),
        BuildingType::Hall => ([160, 150, 166], "halls"),
        BuildingType::Civic => ([206, 160, 60], "public buildings"),
    }
}

/// A drawing under construction.
struct Layers {
    shapes: Vec<Shape>,
    legend: Vec<Entry>,
}

impl Layers {
    fn fill(&mut self, (colour, meaning): (Colour, &'static str), ring: &[Point]) {
        self.shape(colour, meaning, Shape { paths: vec![ring.to_vec()], paint: Paint::Fill(colour) });
    }

    fn line(&mut self, (colour, meaning): (Colour, &'static str), width: f64, points: &[Point]) {
        let paint = Paint::Line { colour, width, dash: None, round: false };
        self.shape(colour, meaning, Shape { paths: vec![points.to_vec()], paint });
    }

    fn shape(&mut self, colour: Colour, meaning: &'static str, shape: Shape) {
        self.shapes.push(shape);
        if !self.legend.iter().any(|entry| entry.colour == colour) {
            self.legend.push(Entry { colour, meaning });
        }
    }
}

/// A circle of twelve corners.
fn circle(at: &Point, radius: f64) -> Vec<Point> {
    let corner = |i: u32| {
        let (sine, cosine) = vc_graph::portable::Portable::sine_cosine(f64::from(i) * std::f64::consts::TAU / 12.0);
        Point::new(at.x + radius * cosine, at.y + radius * sine)
    };
    (0..12).map(corner).collect()
}

impl CityPlan {
    /// The plan as a drawing with a legend: [`Drawing::svg`] is its picture, the example `city` makes pixels of it. Costs some
    /// shapes for each building, tree and car.
    ///
    /// ```
    /// use vc_procgen::city::{CityPlan, CitySpecification};
    /// let small = CitySpecification { area: 0.2, ..CitySpecification::default() };
    /// let drawing = CityPlan::generate(&small, vc_graph::Seed(7))?.drawing();
    /// assert!(drawing.legend.iter().any(|entry| entry.meaning == "park"));
    /// # Ok::<(), vc_procgen::city::CityPlanError>(())
    /// ```
    pub fn drawing(&self) -> Drawing {
        let mut drawing = Drawing::of(&self.map);
        drawing.bounds[0].x -= LEGEND;
        let mut below = Layers { shapes: Vec::new(), legend: Vec::new() };
        for block in &self.blocks {
            below.fill((PAVEMENT, "pavement"), &block.kerb);
            below.fill(ground(block.zone), block.land.corners());
        }
        let mut above = Layers { shapes: Vec::new(), legend: Vec::new() };
        self.draw_parks(&mut above);
        if let Some(sand) = self.shore.as_ref().and_then(|shore| shore.sand.as_ref()) {
            above.fill((SAND, "sand"), sand);
        }
        self.trees.iter().for_each(|tree| above.fill((TREE, "tree"), &circle(tree, 2.2)));
        self.buildings.iter().for_each(|building| self.draw_building(&mut above, building));
        self.cars.iter().for_each(|car| above.fill((CAR, "parked car"), car.outline().corners()));
        for item in &self.items {
            match item.class {
                "tree" => above.fill((TREE, "tree"), &circle(&item.at, 1.8)),
                "street_lamp" => above.fill((LAMP, "street lamp"), &circle(&item.at, 0.6)),
                _ => {}
            }
        }
        // The ground lies below all that the map has.
        let map = std::mem::replace(&mut drawing.shapes, below.shapes);
        drawing.shapes.extend(map.into_iter().chain(above.shapes));
        drawing.legend.retain(|entry| entry.meaning != "building" && entry.meaning != "green");
        let known: Vec<&str> = drawing.legend.iter().map(|entry| entry.meaning).collect();
        let new: Vec<Entry> =
            below.legend.into_iter().chain(above.legend).filter(|entry| !known.contains(&entry.meaning)).collect();
        drawing.legend.extend(new);
        drawing
    }

    fn draw_parks(&self, layers: &mut Layers) {
        for park in &self.parks {
            park.gates.iter().for_each(|gate| layers.line((PATH, "path of a park"), park.path, &[*gate, park.middle]));
            layers.fill((PATH, "path of a park"), &circle(&park.middle, park.path * 1.6));
            for (kind, ring) in &park.features {
                let colour = match kind {
                    ParkFeature::Pond => (WATER, "water"),
                    ParkFeature::Playground | ParkFeature::Court => (PLAY, "playground, court"),
                };
                layers.fill(colour, ring);
            }
            park.trees.iter().for_each(|tree| layers.fill((TREE, "tree"), &circle(tree, 2.4)));
        }
    }

    fn draw_building(&self, layers: &mut Layers, building: &CityBuilding) {
        let (colour, meaning) = mass(building.kind);
        for wing in &building.wings {
            layers.fill((colour, meaning), wing.plan.corners());
            let closed: Vec<Point> = wing.plan.corners().iter().chain(wing.plan.corners().first()).copied().collect();
            layers.line((WALL, "walls"), 0.35, &closed);
        }
        for unit in building.units(0).iter().filter(|unit| unit.kind.place() == super::UnitPlace::Shop) {
            if let Some((a, b, _)) = super::building::street_side(&unit.outline) {
                layers.line((SHOPS, "shop fronts"), 1.6, &[a, b]);
            }
        }
    }
}
