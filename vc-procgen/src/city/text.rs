//! Plans as text: a line for each part, so that two can be compared, and one be looked into.

use std::fmt::Write;

use vc_map::Point;

use super::{CityBuilding, CityPlan, Unit};

fn ring(points: &[Point]) -> String {
    let words: Vec<String> = points.iter().map(|point| format!("{:.3},{:.3}", point.x, point.y)).collect();
    words.join(" ")
}

impl Unit {
    /// The unit in a line: kind, storey, hours, door, windows, outline.
    fn line(&self) -> String {
        let hours = self.kind.hours().map_or("-".to_owned(), |[from, to]| format!("{from}-{to}"));
        let (door, windows) = (ring(&[self.door]), self.windows.len());
        format!(
            "unit {} storey {} hours {hours} door {door} windows {windows} outline {}",
            self.kind.word(),
            self.storey,
            ring(self.outline.corners())
        )
    }
}

impl CityBuilding {
    fn lines(&self, index: usize, text: &mut String) -> std::fmt::Result {
        let (kind, storeys, height) = (self.kind.word(), self.storeys, self.height());
        writeln!(text, "building {index} {kind} parcel {} storeys {storeys} height {height:.1}", self.parcel)?;
        for wing in &self.wings {
            writeln!(text, "  wing {}-{} {}", wing.from, wing.to, ring(wing.plan.corners()))?;
        }
        for unit in (0..self.storeys).flat_map(|storey| self.units(storey)) {
            writeln!(text, "  {}", unit.line())?;
        }
        Ok(())
    }
}

impl CityPlan {
    /// The whole plan as text, with a line for each street, block, parcel, wing, unit, thing and car: some megabytes for a square
    /// kilometre. Equal plans have equal texts, and coordinates are in millimetres.
    ///
    /// ```
    /// use vc_procgen::city::{CityPlan, CitySpecification};
    /// let small = CitySpecification { area: 0.2, ..CitySpecification::default() };
    /// let text = CityPlan::generate(&small, vc_graph::Seed(7))?.text();
    /// assert!(text.lines().any(|line| line.starts_with("  unit home storey 2 hours - door ")));
    /// # Ok::<(), vc_procgen::city::CityPlanError>(())
    /// ```
    pub fn text(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write(&mut text);
        text
    }

    fn write(&self, text: &mut String) -> std::fmt::Result {
        writeln!(text, "city {} {} outline {}", self.seed.0, self.pattern.word(), ring(&self.outline))?;
        for (index, street) in self.streets.iter().enumerate() {
            writeln!(text, "street {index} {} \"{}\" {}", street.class.word(), street.name, ring(&street.line))?;
        }
        for (index, block) in self.blocks.iter().enumerate() {
            writeln!(text, "block {index} {} {}", block.zone.word(), ring(block.land.corners()))?;
        }
        for (index, parcel) in self.parcels.iter().enumerate() {
            writeln!(text, "parcel {index} block {} {}", parcel.block, ring(parcel.land.corners()))?;
        }
        self.buildings.iter().enumerate().try_for_each(|(index, building)| building.lines(index, text))?;
        for park in &self.parks {
            writeln!(text, "park block {} gates {} trees {}", park.block, ring(&park.gates), ring(&park.trees))?;
            for (feature, outline) in &park.features {
                writeln!(text, "  {feature:?} {}", ring(outline))?;
            }
        }
        for item in &self.items {
            writeln!(
                text,
                "{} {} heading {:.4}{}",
                item.class,
                ring(&[item.at]),
                item.heading,
                item.sign.map_or(String::new(), |sign| format!(" {sign:?}"))
            )?;
        }
        for car in &self.cars {
            writeln!(text, "{} {} heading {:.4}", car.class, ring(&[car.at]), car.heading)?;
        }
        writeln!(text, "trees {}", ring(&self.trees))
    }
}
