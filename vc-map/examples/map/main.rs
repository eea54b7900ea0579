//! Reads a map and says what it has.
use vc_map::osm::{ImportOptions, OsmData};
use vc_map::{Control, Users};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        let file = std::fs::read(&path)?;
        let begun = std::time::Instant::now();
        let data = OsmData::from_xml(&file)?;
        let read = begun.elapsed();
        let (draft, report) = data.draft(&ImportOptions::default())?;
        let drafted = begun.elapsed();
        let map = draft.build()?;
        let built = begun.elapsed();
        println!("{path}: {} bytes, read {read:?}, drafted {drafted:?}, built {built:?}; data {} bytes", file.len(), data.bytes());
        println!(
            " {:?} junctions {} roads {} lanes {} movements {} crossings {} buildings {} entrances {} areas {} stops {} bays {}",
            map.side(), map.junctions().len(), map.roads().len(), map.lanes().len(), map.movements().len(), map.crossings().len(),
            map.buildings().len(), map.entrances().len(), map.areas().len(), map.stops().len(), map.bays().len()
        );
        let car = map.length_of(|lane, road| lane.users.has(Users::CAR) && road.draft.class.is_through());
        let lit = map.junctions().iter().filter(|j| j.draft.control == Control::Signals).count();
        println!(" car lanes {car:.0} m, signalled {lit} ({} with signal), guessed {} dropped {}", map.signals().len(), report.guessed.len(), report.dropped.len());
        let stem = std::path::Path::new(&path).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if let Some(out) = std::env::var_os("OUT") {
            let out = std::path::PathBuf::from(out);
            std::fs::create_dir_all(&out)?;
            for (end, text) in vc_map::format::sumo::write(&map, &stem).all() {
                std::fs::write(out.join(format!("{stem}.{end}")), text)?;
            }
            std::fs::write(out.join(format!("{stem}.xodr")), vc_map::format::opendrive::write(&map))?;
            let text = vc_map::format::native::write(&map);
            assert!(vc_map::format::native::read(&text)? == map);
            std::fs::write(out.join(format!("{stem}.map.json")), text)?;
        }
        let parts = map.walk_parts();
        let all: f64 = parts.iter().map(|part| part.1).sum();
        println!(" walkable: {} parts, main {:.0} of {all:.0} m", parts.len(), parts[0].1);
        let mut kinds = std::collections::BTreeMap::<String, u32>::new();
        for violation in map.validate() {
            let text = format!("{violation:?}");
            *kinds.entry(text.split(' ').next().unwrap_or_default().to_owned()).or_default() += 1;
        }
        println!(" {kinds:?}");
    }
    Ok(())
}
