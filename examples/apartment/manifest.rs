//! Metadata of a data set: a sidecar file beside each file, and for the whole set the manifest, statistics and
//! plots.

use std::collections::HashSet;

use serde::{Deserialize, Serialize};
use virtualcity::procgen::Fingerprint;
use virtualcity::procgen::picture::Canvas;
use virtualcity::procgen::statistics::Statistics;

use crate::record::FORMAT;
use crate::set::{Set, Volume};
use crate::support::{Complaint, say};
use crate::wishes::Recipe;

/// A home's seed and the fingerprints of the whole and of its plan.
#[derive(Serialize, Deserialize, Clone)]
pub(crate) struct Mark(pub(crate) u64, pub(crate) Fingerprint, pub(crate) Fingerprint);

/// A seed for which no home was found.
#[derive(Serialize, Deserialize, Clone)]
pub(crate) struct Failure {
    pub(crate) seed: u64,
    pub(crate) reason: String,
}

/// Statistics of some homes.
#[derive(Serialize, Deserialize, Default, Clone)]
pub(crate) struct Figures {
    pub(crate) failed: Vec<Failure>,
    pub(crate) marks: Vec<Mark>,
    pub(crate) statistics: Statistics,
}

impl Figures {
    pub(crate) fn merge(&mut self, mut other: Self) {
        self.failed.append(&mut other.failed);
        self.marks.append(&mut other.marks);
        self.statistics.merge(&other.statistics);
    }
}

/// Metadata of a file.
#[derive(Serialize, Deserialize)]
pub(crate) struct Sidecar {
    /// The recipe as text, so that reading and writing cannot change its numbers.
    recipe: String,
    file: String,
    first: u64,
    pub(crate) seeds: u64,
    bytes: u64,
    digest: Fingerprint,
    figures: Figures,
}

impl Sidecar {
    pub(crate) fn new(set: &Set, volume: &Volume, packed: &[u8], figures: Figures) -> Result<Self, Complaint> {
        Ok(Self {
            recipe: recipe(set)?,
            file: volume.name(),
            first: volume.first,
            seeds: volume.seeds,
            bytes: packed.len() as u64,
            digest: Fingerprint::from_bytes(packed),
            figures,
        })
    }

    pub(crate) fn write(&self, set: &Set) -> Result<(), Complaint> {
        let text = serde_json::to_vec(self).map_err(Complaint::new)?;
        Ok(virtualcity::files::write(set.out.join(sidecar_name(&self.file)), &text)?)
    }
}

fn recipe(set: &Set) -> Result<String, Complaint> {
    serde_json::to_string(&set.recipe).map_err(Complaint::new)
}

fn sidecar_name(file: &str) -> String {
    file.replace(".jsonl.gz", ".meta.json")
}

/// The sidecar of a complete file; `None` if the file must be made.
///
/// # Errors
/// If the file belongs to a set with another recipe.
pub(crate) fn complete(set: &Set, volume: &Volume) -> Result<Option<Sidecar>, Complaint> {
    let path = set.out.join(sidecar_name(&volume.name()));
    let Ok(text) = std::fs::read(&path) else { return Ok(None) };
    let Ok(sidecar) = serde_json::from_slice::<Sidecar>(&text) else { return Ok(None) };
    if sidecar.recipe != recipe(set)? {
        let (path, made) = (path.display(), &sidecar.recipe);
        return Err(Complaint::new(format!(
            "{path} is of another set, made after {made}: choose another --out, or delete that set"
        )));
    }
    if sidecar.seeds > volume.seeds {
        return Err(Complaint::new(format!(
            "{} is of another set, of {} seeds and not of {}: choose another --out, or delete that set",
            path.display(),
            sidecar.seeds,
            volume.seeds
        )));
    }
    // A disk may keep the length of a file and lose what is in it.
    let is_whole = |packed: Vec<u8>| Fingerprint::from_bytes(&packed) == sidecar.digest;
    let whole = sidecar.seeds == volume.seeds && std::fs::read(set.out.join(volume.name())).is_ok_and(is_whole);
    Ok(whole.then_some(sidecar))
}

/// Metadata of a data set.
#[derive(Serialize)]
struct Manifest<'a> {
    recipe: &'a Recipe,
    about: &'static str,
    first_seed: u64,
    seeds: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    shard: Option<String>,
    homes: usize,
    failed: Vec<Failure>,
    distinct_homes: usize,
    distinct_plans: usize,
    /// Seeds of homes that are equal up to rotation and mirroring.
    duplicates: Vec<[u64; 2]>,
    format: &'static str,
    files: Vec<Entry<'a>>,
}

/// A file of a data set.
#[derive(Serialize)]
struct Entry<'a> {
    name: &'a str,
    first_seed: u64,
    seeds: u64,
    homes: usize,
    bytes: u64,
    digest: Fingerprint,
}

const ABOUT: &str = "\
Every home is a function of its seed and the wishes: Apartment::generate(&wishes, Seed(seed)) of the crate vc-procgen, \
in the version named, makes it again with all shapes, materials and surfaces; the lines of the files say what is where. \
Fingerprints are equal for homes (or plans) that differ by turning and mirroring only. `digest` is \
Fingerprint::from_bytes of the file.";

/// Writes the manifest, and for a whole set also statistics and plots.
pub(crate) fn write(set: &Set, sidecars: &[Sidecar]) -> Result<(), Complaint> {
    let manifest = Manifest::new(set, sidecars);
    let name = match set.shard {
        Some(shard) => format!("manifest_{}_of_{}.json", shard.index, shard.of),
        None => "manifest.json".to_owned(),
    };
    virtualcity::files::write(set.out.join(&name), serde_json::to_vec_pretty(&manifest).map_err(Complaint::new)?)?;
    if set.shard.is_none() {
        write_statistics(set, sidecars)?;
    } else {
        say!("once all shards are made, the same command without --shard writes manifest and statistics of the whole");
    }
    let Manifest { homes, distinct_homes, distinct_plans, duplicates, failed, .. } = &manifest;
    say!(
        "{homes} homes, {distinct_homes} distinct, {distinct_plans} distinct plans; see {}",
        set.out.join(name).display()
    );
    if let Some([one, other]) = duplicates.first() {
        say!("seeds {one} and {other} made the same home, {} such pairs in all", duplicates.len());
    }
    match failed.first() {
        None => Ok(()),
        Some(Failure { seed, reason }) => {
            let count = failed.len();
            Err(Complaint::new(format!(
                "{count} seeds made no home, {seed} the first: {reason}; the others are written"
            )))
        }
    }
}

impl<'a> Manifest<'a> {
    fn new(set: &'a Set, sidecars: &'a [Sidecar]) -> Self {
        let marks = || sidecars.iter().flat_map(|s| &s.figures.marks);
        Self {
            recipe: &set.recipe,
            about: ABOUT,
            first_seed: set.seed,
            seeds: set.count,
            shard: set.shard.map(|s| format!("{}/{}", s.index, s.of)),
            homes: marks().count(),
            failed: sidecars.iter().flat_map(|s| s.figures.failed.iter().cloned()).collect(),
            distinct_homes: marks().map(|m| m.1).collect::<HashSet<_>>().len(),
            distinct_plans: marks().map(|m| m.2).collect::<HashSet<_>>().len(),
            duplicates: duplicates(marks()),
            format: FORMAT,
            files: sidecars.iter().map(Entry::new).collect(),
        }
    }
}

impl<'a> Entry<'a> {
    fn new(sidecar: &'a Sidecar) -> Self {
        let Sidecar { file, first, seeds, bytes, digest, figures, .. } = sidecar;
        let homes = figures.marks.len();
        Self { name: file, first_seed: *first, seeds: *seeds, homes, bytes: *bytes, digest: *digest }
    }
}

/// Pairs of consecutive seeds with the same fingerprint.
fn duplicates<'a>(marks: impl Iterator<Item = &'a Mark>) -> Vec<[u64; 2]> {
    let mut all: Vec<(Fingerprint, u64)> = marks.map(|m| (m.1, m.0)).collect();
    all.sort_unstable();
    let mut pairs: Vec<[u64; 2]> = all.windows(2).filter(|w| w[0].0 == w[1].0).map(|w| [w[0].1, w[1].1]).collect();
    pairs.sort_unstable();
    pairs
}

/// Statistics as JSON and Markdown, plots as SVG and PNG.
fn write_statistics(set: &Set, sidecars: &[Sidecar]) -> Result<(), Complaint> {
    let mut all = Statistics::default();
    sidecars.iter().for_each(|s| all.merge(&s.figures.statistics));
    let file = serde_json::json!({ "statistics": all, "comparison": all.compare() });
    virtualcity::files::write(
        set.out.join("statistics.json"),
        serde_json::to_vec_pretty(&file).map_err(Complaint::new)?,
    )?;
    virtualcity::files::write(set.out.join("statistics.md"), all.report().as_bytes())?;
    for (name, plot) in [("areas", all.area_plot()), ("pairs", all.pair_plot()), ("homes", all.mix_plot())] {
        write_plot(set, name, &plot)?;
    }
    Ok(())
}

fn write_plot(set: &Set, name: &str, plot: &Canvas) -> Result<(), Complaint> {
    virtualcity::files::write(set.out.join(format!("{name}.svg")), plot.to_svg(1100).as_bytes())?;
    Ok(virtualcity::files::write(set.out.join(format!("{name}.png")), plot.to_png(1100).map_err(Complaint::new)?)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duplicates_are_found() {
        let mark = |seed, print| Mark(seed, Fingerprint(print), Fingerprint(0));
        let marks = [mark(1, 5), mark(2, 6), mark(3, 5), mark(4, 5)];
        assert_eq!(duplicates(marks.iter()), [[1, 3], [3, 4]]);
    }
}
