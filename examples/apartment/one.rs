//! A single apartment with all its files.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use virtualcity::gltf;
use virtualcity::graph::format::{native, thesis};
use virtualcity::graph::{SceneGraph, Seed};
use virtualcity::procgen::ApartmentViolation;
use virtualcity::procgen::Support;
use virtualcity::procgen::{Apartment, Specification};

use crate::support::{Complaint, say};

/// Width of the floor plan's picture, pixels.
const WIDTH: usize = 1400;

/// Generates the apartment of a seed and writes its files.
pub(crate) fn write(specification: &Specification, seed: u64, out: &Path) -> Result<(), Complaint> {
    let start = Instant::now();
    let home =
        Apartment::generate(specification, Seed(seed)).map_err(|e| Complaint::new(format!("seed {seed}: {e}")))?;
    let spent = start.elapsed();
    let scene = home.scene();
    let plan = home.floor_plan();
    let report = Report::new(&home, &scene);
    let files = [
        ("thesis.json", thesis::write(&scene).into_bytes()),
        ("json", native::write(&scene).into_bytes()),
        ("svg", plan.to_svg(WIDTH).into_bytes()),
        ("png", plan.to_png(WIDTH).map_err(Complaint::new)?),
        ("glb", gltf::scene(&scene).map_err(Complaint::new)?),
        ("report.txt", report.text().into_bytes()),
        ("report.json", report.json()?.into_bytes()),
    ];
    for (ending, bytes) in &files {
        virtualcity::files::write(out.join(format!("apartment_{seed}.{ending}")), bytes)?;
    }
    say!("{}", report.text());
    say!("made in {:.1} ms; {} files in {}", 1e3 * spent.as_secs_f64(), files.len(), out.display());
    if report.violations.is_empty() { Ok(()) } else { Err(Complaint::new("the apartment is not sound")) }
}

/// A summary of an apartment.
#[derive(serde::Serialize)]
struct Report {
    seed: u64,
    scheme: &'static str,
    fingerprint: String,
    /// Net area without balconies, m².
    area: f32,
    /// Floor area that a person can reach, m².
    standing_area: f32,
    rooms: Vec<Room>,
    /// Objects by class, without walls, floors and ceilings.
    objects: BTreeMap<&'static str, usize>,
    /// The number of objects that rest on or in others.
    small_objects: usize,
    /// The number of nodes of the scene.
    nodes: usize,
    /// Rooms and objects that a person can reach, and how many there are.
    reached: [[usize; 2]; 2],
    violations: Vec<String>,
}

#[derive(serde::Serialize)]
struct Room {
    name: &'static str,
    area: f32,
    ways: usize,
    windows: usize,
    objects: usize,
}

impl Report {
    fn new(home: &Apartment, scene: &SceneGraph) -> Self {
        let found = home.check();
        let count = |f: fn(&ApartmentViolation) -> bool| found.iter().filter(|v| f(v)).count();
        let things = || home.items.iter().filter(|i| !is_building(i.object.class));
        let mut objects = BTreeMap::new();
        things().for_each(|i| *objects.entry(i.object.class).or_default() += 1);
        let (rooms, total) = (home.plan.rooms.len(), things().count());
        let shut = count(|v| matches!(v, ApartmentViolation::UnreachableRoom(..)));
        let far = count(|v| matches!(v, ApartmentViolation::Unreachable(..)));
        let invalid = scene.validate().into_iter().map(|p| format!("scene: {p}"));
        Self {
            seed: home.seed.0,
            scheme: home.plan.scheme.title(),
            fingerprint: home.fingerprint().to_string(),
            area: home.plan.area(),
            standing_area: home.standing_area(),
            rooms: (0..rooms).map(|r| Room::new(home, r)).collect(),
            objects,
            small_objects: things().filter(|i| matches!(i.support, Support::On(..) | Support::Inside(..))).count(),
            nodes: scene.len(),
            reached: [[rooms - shut, rooms], [total - far, total]],
            violations: found.iter().map(ToString::to_string).chain(invalid).collect(),
        }
    }

    fn json(&self) -> Result<String, Complaint> {
        serde_json::to_string_pretty(self).map_err(Complaint::new)
    }

    fn text(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write(&mut text);
        text
    }

    fn write(&self, text: &mut String) -> std::fmt::Result {
        let [[rooms, of_rooms], [objects, of_objects]] = self.reached;
        writeln!(
            text,
            "apartment {}: {}, {:.1} m², fingerprint {}",
            self.seed, self.scheme, self.area, self.fingerprint
        )?;
        writeln!(text, "\n{:<14}{:>8}{:>16}{:>9}{:>9}", "room", "m²", "doors, passages", "windows", "objects")?;
        for room in &self.rooms {
            let Room { name, area, ways, windows, objects } = room;
            writeln!(text, "{name:<14}{area:>8.1}{ways:>16}{windows:>9}{objects:>9}")?;
        }
        writeln!(text, "\n{of_objects} objects, {} of them on or in others; {} nodes", self.small_objects, self.nodes)?;
        let words =
            self.objects.iter().map(|(class, n)| if *n > 1 { format!("{class} x{n}") } else { (*class).into() });
        writeln!(text, "{}", words.collect::<Vec<String>>().join(", "))?;
        writeln!(text, "\nreached: {rooms} of {of_rooms} rooms, {objects} of {of_objects} objects,")?;
        writeln!(text, "         {:.1} m² to stand on", self.standing_area)?;
        match self.violations.as_slice() {
            [] => writeln!(text, "violations: none"),
            all => all.iter().try_for_each(|v| writeln!(text, "violation: {v}")),
        }
    }
}

impl Room {
    fn new(home: &Apartment, index: usize) -> Self {
        let (plan, room) = (&home.plan, &home.plan.rooms[index]);
        let objects = home.items.iter().filter(|i| i.room == index && !is_building(i.object.class));
        Self {
            name: room.kind.title(),
            area: room.area(),
            ways: plan.doors_of(index).count(),
            windows: plan.openings.iter().filter(|o| !o.is_way() && o.touches(index)).count(),
            objects: objects.count(),
        }
    }
}

/// Whether objects of a class follow from the floor plan alone.
pub(crate) fn is_building(class: &str) -> bool {
    matches!(class, "wall" | "floor" | "ceiling" | "railing")
}
