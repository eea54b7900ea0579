//! Styles of facades, from `data/facades.txt`, and what a building draws from one.

use std::sync::LazyLock;

use vc_graph::{Seed, Stream};
use vc_shapes::material::{ALL, CONCRETE, MaterialId};

use crate::city::{BuildingType, CityPlan};

/// The chance that a building has the style of its street.
const HELD: f32 = 0.7;

/// A line of the table.
struct Style {
    types: Vec<BuildingType>,
    weight: f32,
    walls: Vec<MaterialId>,
    ground: Vec<MaterialId>,
    trims: Vec<MaterialId>,
    frames: Vec<MaterialId>,
    roofs: Vec<MaterialId>,
    doors: Vec<MaterialId>,
    plinth: f32,
    course: (f32, f32),
    cornice: (f32, f32),
    pitch: f32,
}

static TABLE: LazyLock<Vec<Style>> = LazyLock::new(|| {
    let lines = include_str!("../../data/facades.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(style).collect()
});

fn style(line: &str) -> Option<Style> {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    let materials = |column: usize| -> Option<Vec<MaterialId>> {
        let id = |name: &str| ALL.iter().position(|(known, ..)| *known == name).map(|at| MaterialId(at as u32));
        columns.get(column)?.split_whitespace().map(id).collect()
    };
    let number = |column: usize| columns.get(column)?.parse::<f32>().ok();
    let pair = |column: usize| {
        let mut words = columns.get(column)?.split_whitespace().filter_map(|word| word.parse::<f32>().ok());
        Some((words.next()?, words.next()?))
    };
    let kind = |word: &str| BuildingType::ALL.into_iter().find(|kind| kind.word() == word);
    Some(Style {
        types: columns.get(1)?.split_whitespace().map(kind).collect::<Option<_>>()?,
        weight: number(2)?,
        walls: materials(3)?,
        ground: materials(4)?,
        trims: materials(5)?,
        frames: materials(6)?,
        roofs: materials(7)?,
        doors: materials(8)?,
        plinth: number(9)?,
        course: pair(10)?,
        cornice: pair(11)?,
        pitch: number(12)?.to_radians(),
    })
}

/// The facade of a building: its materials, and the measures of its courses, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Facade {
    pub(crate) wall: MaterialId,
    /// The wall of the ground storey.
    pub(crate) ground: MaterialId,
    pub(crate) trim: MaterialId,
    pub(crate) frame: MaterialId,
    pub(crate) roof: MaterialId,
    pub(crate) door: MaterialId,
    pub(crate) plinth: f32,
    /// How far courses between storeys, and the cornice below the roof, stand out, and their heights.
    pub(crate) course: (f32, f32),
    pub(crate) cornice: (f32, f32),
    /// The pitch of its roof, radians; zero for a flat one.
    pub(crate) pitch: f32,
}

impl Facade {
    /// That of a building: it follows from the seed, the street and the building alone.
    pub(crate) fn of(city: &CityPlan, building: usize) -> Self {
        let seed = city.seed().child("facade");
        let Some(house) = city.buildings().get(building) else { return Self::plain() };
        let own = seed.child("building").nth(building as u64);
        let mut stream = own.stream();
        let street = house.doors().first().map(|door| seed.child("street").nth(door.street as u64));
        let drawn = street.filter(|_| stream.chance(HELD)).unwrap_or_else(|| own.child("style"));
        Self::drawn(house.kind, drawn, &mut stream)
    }

    fn drawn(kind: BuildingType, style: Seed, stream: &mut Stream) -> Self {
        let fitting: Vec<&Style> = TABLE.iter().filter(|style| style.types.contains(&kind)).collect();
        let Some(style) = style.stream().weighted(fitting.iter().map(|style| style.weight)).map(|index| fitting[index])
        else {
            return Self::plain();
        };
        let mut one_of = |all: &[MaterialId]| stream.pick(all).copied().unwrap_or(CONCRETE);
        Self {
            wall: one_of(&style.walls),
            ground: one_of(&style.ground),
            trim: one_of(&style.trims),
            frame: one_of(&style.frames),
            roof: one_of(&style.roofs),
            door: one_of(&style.doors),
            plinth: style.plinth,
            course: style.course,
            cornice: style.cornice,
            pitch: style.pitch,
        }
    }

    fn plain() -> Self {
        let [wall, ground, trim, frame, roof, door] = [CONCRETE; 6];
        let (plinth, course, cornice, pitch) = (0.3, (0.02, 0.06), (0.06, 0.1), 0.0);
        Self { wall, ground, trim, frame, roof, door, plinth, course, cornice, pitch }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read_and_every_type_has_a_style() {
        let lines = include_str!("../../data/facades.txt").lines().filter(|line| !line.starts_with('#'));
        assert_eq!(lines.count(), TABLE.len());
        assert!(BuildingType::ALL.iter().all(|kind| TABLE.iter().any(|style| style.types.contains(kind))));
    }
}
