//! A data set of homes in files, made by several threads.
//!
//! Threads take batches of seeds; the thread that makes the last batch of a file compresses and writes the
//! file. Its bytes depend on the seeds alone. Batches of an incomplete file are kept in `NAME.unfinished`, so
//! that an interrupted run loses at most one batch per thread.

use std::io::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use flate2::Compression;
use flate2::write::GzEncoder;
use indicatif::{ProgressBar, ProgressStyle};
use serde::{Deserialize, Serialize};
use virtualcity::ResumableRun;
use virtualcity::graph::Seed;
use virtualcity::procgen::{Apartment, Fingerprint, Specification};

use crate::manifest::{self, Failure, Figures, Mark, Sidecar};
use crate::record::Record;
use crate::support::{Complaint, say};
use crate::wishes::Recipe;

/// Homes per batch.
const BATCH: u64 = 20;
/// The largest useful number of files in one folder.
const MOST_FILES: u64 = 1_000_000;

/// The data set to be made.
pub(crate) struct Set {
    pub(crate) specification: Specification,
    pub(crate) recipe: Recipe,
    pub(crate) seed: u64,
    pub(crate) count: u64,
    pub(crate) per_file: u64,
    pub(crate) shard: Option<Shard>,
    pub(crate) jobs: usize,
    pub(crate) out: PathBuf,
}

/// Every n-th file of a set, from an index counted from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shard {
    pub(crate) index: u64,
    pub(crate) of: u64,
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        let (index, of) = numbers.ok_or("write it as 0/8, 1/8 and so on")?;
        if index < of {
            Ok(Self { index, of })
        } else {
            Err(format!("shards of {of} are numbered from 0 up, {of} excluded"))
        }
    }
}

/// A file of a set: a number of consecutive seeds.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Volume {
    pub(crate) first: u64,
    pub(crate) seeds: u64,
}

impl Volume {
    /// The file's name.
    pub(crate) fn name(&self) -> String {
        format!("{}{:012}{}", Self::NAME.0, self.first, Self::NAME.1)
    }

    /// The parts of a file name around the first seed.
    const NAME: (&str, &str) = ("homes_", ".jsonl.gz");

    fn batches(&self) -> usize {
        self.seeds.div_ceil(BATCH) as usize
    }

    /// The seeds of a batch. The last seed there is may be among them, so that none follows.
    fn batch(&self, index: usize) -> RangeInclusive<u64> {
        let from = BATCH * index as u64;
        self.first + from..=self.first + ((from + BATCH).min(self.seeds) - 1)
    }
}

/// The first seed of a file according to its name, if it belongs to a data set.
fn first_of(name: &str) -> Option<u64> {
    name.strip_prefix(Volume::NAME.0)?.strip_suffix(Volume::NAME.1)?.parse().ok()
}

/// Makes the missing files, then writes the manifest.
pub(crate) fn run(set: &Set) -> Result<(), Complaint> {
    let start = Instant::now();
    let volumes = set.volumes()?;
    set.stands_alone()?;
    let total: u64 = volumes.iter().map(|v| v.seeds).sum();
    let progress = ProgressBar::new(total);
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} homes, {per_sec}, {eta} left");
    progress.set_style(style.map_err(Complaint::new)?);
    let mut sidecars = volumes.iter().map(|v| manifest::complete(set, v)).collect::<Result<Vec<_>, _>>()?;
    let there: u64 = sidecars.iter().flatten().map(|s| s.seeds).sum();
    progress.set_position(there);
    progress.reset_eta();
    let missing: Vec<Volume> = volumes.iter().zip(&sidecars).filter(|(_, s)| s.is_none()).map(|(v, _)| *v).collect();
    let (made, resumed) = Workshop::new(set, &missing, &progress).run()?;
    let mut made = made.into_iter();
    sidecars.iter_mut().filter(|s| s.is_none()).for_each(|s| *s = made.next());
    progress.finish_and_clear();
    let sidecars: Vec<Sidecar> = sidecars.into_iter().flatten().collect();
    let spent = start.elapsed().as_secs_f64();
    let there = there + resumed;
    say!("{} homes made in {spent:.1} s, {there} were there", total - there);
    manifest::write(set, &sidecars)
}

impl Set {
    /// The files that this run must make.
    fn volumes(&self) -> Result<Vec<Volume>, Complaint> {
        let files = self.count.div_ceil(self.per_file);
        if files > MOST_FILES {
            return Err(Complaint::new(format!("these would be {files} files: choose a higher --per-file")));
        }
        let mine = |i: &u64| self.shard.is_none_or(|s| i % s.of == s.index);
        Ok((0..files).filter(mine).map(|i| self.volume(i)).collect())
    }

    fn volume(&self, index: u64) -> Volume {
        let before = index * self.per_file;
        Volume { first: self.seed + before, seeds: self.per_file.min(self.count - before) }
    }

    /// Refuses a folder with files of a set of other seeds or other file lengths, since its manifest and this
    /// set's would contradict them.
    fn stands_alone(&self) -> Result<(), Complaint> {
        let Ok(entries) = std::fs::read_dir(&self.out) else { return Ok(()) };
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        let mut others: Vec<String> =
            names.filter(|name| first_of(name).is_some_and(|first| !self.has(first))).collect();
        others.sort();
        let Some(other) = others.first() else { return Ok(()) };
        let path = self.out.join(other);
        Err(Complaint::new(format!("{} is of another set: choose another --out, or delete that set", path.display())))
    }

    /// Whether a file of this set, of any shard, begins with a seed.
    fn has(&self, first: u64) -> bool {
        let after = first.checked_sub(self.seed);
        after.is_some_and(|after| after < self.count && after.is_multiple_of(self.per_file))
    }

    /// The finished batches of a file from an interrupted run.
    fn unfinished(&self, volume: &Volume) -> Result<ResumableRun<Part>, Complaint> {
        let path = self.out.join(format!("{}.unfinished", volume.name()));
        Ok(ResumableRun::open(path, &(&self.recipe, volume.first, volume.seeds))?)
    }

    /// Homes of some seeds: their lines and statistics.
    fn part(&self, seeds: RangeInclusive<u64>) -> Result<Part, Complaint> {
        let mut part = Part::default();
        for seed in seeds {
            match Apartment::generate(&self.specification, Seed(seed)) {
                Ok(home) => part.add(&home)?,
                Err(error) => part.figures.failed.push(Failure { seed, reason: error.to_string() }),
            }
        }
        Ok(part)
    }

    /// Compresses and writes a file, then its sidecar.
    fn bind(&self, volume: &Volume, parts: Vec<Part>) -> Result<Sidecar, Complaint> {
        let mut figures = Figures::default();
        let mut packer = GzEncoder::new(Vec::new(), Compression::new(1));
        for part in parts {
            packer.write_all(part.lines.as_bytes()).map_err(Complaint::new)?;
            figures.merge(part.figures);
        }
        let packed = packer.finish().map_err(Complaint::new)?;
        virtualcity::files::write(self.out.join(volume.name()), &packed)?;
        let sidecar = Sidecar::new(self, volume, &packed, figures)?;
        sidecar.write(self)?;
        Ok(sidecar)
    }
}

/// Some homes of a file.
#[derive(Default, Clone, Serialize, Deserialize)]
struct Part {
    lines: String,
    figures: Figures,
}

impl Part {
    fn add(&mut self, home: &Apartment) -> Result<(), Complaint> {
        let (whole, plan): (Fingerprint, Fingerprint) = (home.fingerprint(), home.plan.fingerprint());
        let line = serde_json::to_string(&Record::new(home, whole, plan)).map_err(Complaint::new)?;
        self.lines.push_str(&(line + "\n"));
        self.figures.statistics.add(home);
        self.figures.marks.push(Mark(home.seed.0, whole, plan));
        Ok(())
    }
}

/// State shared by the threads that make the files.
struct Workshop<'a> {
    set: &'a Set,
    volumes: &'a [Volume],
    progress: &'a ProgressBar,
    /// Batches per file; the longest file's number is used for all.
    batches: usize,
    next: AtomicUsize,
    /// Homes of an interrupted run.
    resumed: AtomicU64,
    files: Vec<Mutex<File>>,
    error: Mutex<Option<Complaint>>,
}

/// An unfinished file.
#[derive(Default)]
struct File {
    parts: Vec<Option<Part>>,
    unfinished: Option<Arc<ResumableRun<Part>>>,
    sidecar: Option<Sidecar>,
}

impl<'a> Workshop<'a> {
    fn new(set: &'a Set, volumes: &'a [Volume], progress: &'a ProgressBar) -> Self {
        let batches = volumes.iter().map(Volume::batches).max().unwrap_or(0);
        let files = volumes.iter().map(|_| Mutex::default()).collect();
        let (next, resumed) = (AtomicUsize::new(0), AtomicU64::new(0));
        Self { set, volumes, progress, batches, next, resumed, files, error: Mutex::new(None) }
    }

    /// Makes all files. Returns their sidecars in order, and the number of homes that an interrupted run had made.
    fn run(self) -> Result<(Vec<Sidecar>, u64), Complaint> {
        std::thread::scope(|scope| {
            for _ in 0..self.set.jobs {
                scope.spawn(|| self.work());
            }
        });
        let error = self.error.into_inner().unwrap_or_else(PoisonError::into_inner);
        match error {
            Some(error) => Err(error),
            None => {
                let sidecars = self.files.iter().filter_map(|f| locked(f).sidecar.take()).collect();
                Ok((sidecars, self.resumed.into_inner()))
            }
        }
    }

    /// Takes batches until there are none left or an error occurred.
    fn work(&self) {
        let _alarm = Alarm(&self.error);
        while locked(&self.error).is_none() {
            let index = self.next.fetch_add(1, Ordering::Relaxed);
            let (file, batch) = (index / self.batches.max(1), index % self.batches.max(1));
            let Some(volume) = self.volumes.get(file) else { return };
            if batch < volume.batches()
                && let Err(error) = self.batch(file, volume, batch)
            {
                locked(&self.error).get_or_insert(error);
            }
        }
    }

    /// Makes a batch, and writes the file if it was the last.
    fn batch(&self, file: usize, volume: &Volume, batch: usize) -> Result<(), Complaint> {
        let (seeds, unfinished) = (volume.batch(batch), self.unfinished(file, volume)?);
        let (count, key) = (seeds.end() - seeds.start() + 1, seeds.start().to_string());
        let part = match unfinished.get(&key) {
            Some(there) => {
                self.resumed.fetch_add(count, Ordering::Relaxed);
                there.clone()
            }
            None => unfinished.add(&key, &self.set.part(seeds)?)?,
        };
        self.progress.inc(count);
        let parts = locked(&self.files[file]).put(batch, part, volume.batches());
        if let Some(parts) = parts {
            let sidecar = self.set.bind(volume, parts)?;
            unfinished.remove()?;
            let mut done = locked(&self.files[file]);
            (done.sidecar, done.unfinished) = (Some(sidecar), None);
        }
        Ok(())
    }

    /// The finished batches of a file, opened by the first thread that needs them.
    fn unfinished(&self, file: usize, volume: &Volume) -> Result<Arc<ResumableRun<Part>>, Complaint> {
        let mut file = locked(&self.files[file]);
        match &file.unfinished {
            Some(open) => Ok(open.clone()),
            None => Ok(file.unfinished.insert(Arc::new(self.set.unfinished(volume)?)).clone()),
        }
    }
}

/// Stops the other threads if one panics, since the set would be incomplete.
struct Alarm<'a>(&'a Mutex<Option<Complaint>>);

impl Drop for Alarm<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            locked(self.0).get_or_insert_with(|| Complaint::new("a thread that made homes panicked"));
        }
    }
}

impl File {
    /// Stores a batch; returns all batches once none is missing.
    fn put(&mut self, batch: usize, part: Part, batches: usize) -> Option<Vec<Part>> {
        self.parts.resize_with(batches, || None);
        self.parts[batch] = Some(part);
        let whole = self.parts.iter().all(Option::is_some);
        whole.then(|| self.parts.iter_mut().filter_map(Option::take).collect())
    }
}

/// Locks a mutex, poisoned or not: a thread that panicked ends the whole run anyway.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::wishes::Wishes;
    use std::collections::BTreeMap;
    use std::path::Path;

    fn set(out: &Path, jobs: usize, shard: Option<&str>) -> Set {
        let wishes = Wishes::default();
        Set {
            specification: wishes.specification().unwrap(),
            recipe: wishes.recipe(),
            seed: 7,
            count: 50,
            per_file: 23,
            shard: shard.map(|s| s.parse().unwrap()),
            jobs,
            out: out.to_owned(),
        }
    }

    fn folder(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("virtualcity_{}_{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        path
    }

    fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
        entries.map(|e| (e.file_name().into_string().unwrap(), std::fs::read(e.path()).unwrap())).collect()
    }

    #[test]
    fn threads_shards_and_interruptions_change_nothing() {
        let [one, three, shards] = ["one", "three", "shards"].map(folder);
        run(&set(&one, 1, None)).unwrap();
        let whole = files(&one);
        assert_eq!(whole.keys().filter(|n| n.ends_with(".jsonl.gz")).count(), 3);

        run(&set(&three, 3, None)).unwrap();
        assert_eq!(files(&three), whole);

        // A file with only some batches, the last of which is truncated.
        let broken = set(&three, 1, None);
        let volume = broken.volumes().unwrap()[0];
        let unfinished = broken.unfinished(&volume).unwrap();
        unfinished.add(&volume.first.to_string(), &broken.part(volume.batch(0)).unwrap()).unwrap();
        drop(unfinished);
        let path = three.join("homes_000000000007.jsonl.gz.unfinished");
        let mut cut = std::fs::read(&path).unwrap();
        cut.extend_from_slice(b"[\"27\",{\"lines\":\"{");
        std::fs::write(&path, cut).unwrap();
        let there = broken.unfinished(&volume).unwrap();
        assert_eq!(["7", "27"].map(|key| there.get(key).is_some()), [true, false]);
        drop(there);
        std::fs::remove_file(three.join("homes_000000000007.meta.json")).unwrap();
        run(&broken).unwrap();
        assert_eq!(files(&three), whole);

        // A file with a flipped bit.
        let mut flipped = whole["homes_000000000030.jsonl.gz"].clone();
        let middle = flipped.len() / 2;
        flipped[middle] ^= 1;
        std::fs::write(three.join("homes_000000000030.jsonl.gz"), flipped).unwrap();
        run(&set(&three, 2, None)).unwrap();
        assert_eq!(files(&three), whole);

        // A truncated file, one without its sidecar, and one that was never finished.
        let cut = &whole["homes_000000000007.jsonl.gz"];
        std::fs::write(three.join("homes_000000000007.jsonl.gz"), &cut[..cut.len() / 2]).unwrap();
        std::fs::remove_file(three.join("homes_000000000030.meta.json")).unwrap();
        std::fs::remove_file(three.join("homes_000000000053.jsonl.gz")).unwrap();
        run(&set(&three, 2, None)).unwrap();
        assert_eq!(files(&three), whole);

        run(&set(&shards, 1, Some("1/2"))).unwrap();
        run(&set(&shards, 1, Some("0/2"))).unwrap();
        run(&set(&shards, 1, None)).unwrap();
        let mut joined = files(&shards);
        assert!(joined.remove("manifest_0_of_2.json").is_some() && joined.remove("manifest_1_of_2.json").is_some());
        assert_eq!(joined, whole);
        [one, three, shards].iter().for_each(|f| std::fs::remove_dir_all(f).unwrap());
    }

    #[test]
    fn another_set_is_not_mixed_in() {
        let folder = folder("other");
        let small = Set { count: 3, ..set(&folder, 1, None) };
        run(&small).unwrap();
        let wishes = Wishes { clutter: Some(0.3), ..Wishes::default() };
        let other = Set { recipe: wishes.recipe(), ..small };
        let complaint = format!("{:?}", run(&other).unwrap_err());
        assert!(complaint.contains("another set"), "{complaint}");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_set_grows_and_is_not_overwritten_by_another() {
        let folder = folder("grows");
        let first = Set { count: 4, per_file: 2, ..set(&folder, 1, None) };
        run(&first).unwrap();
        let whole = files(&folder);
        let others = [
            Set { count: 2, ..set(&folder, 1, None) },
            Set { count: 4, per_file: 1, ..set(&folder, 1, None) },
            Set { count: 4, per_file: 4, ..set(&folder, 1, None) },
            Set { count: 4, per_file: 2, seed: 8, ..set(&folder, 1, None) },
            Set { count: 4, per_file: 2, seed: 50, ..set(&folder, 1, None) },
        ];
        for other in others {
            let complaint = format!("{:?}", run(&other).unwrap_err());
            assert!(complaint.contains("another set"), "{complaint}");
            assert_eq!(files(&folder), whole);
        }
        run(&Set { count: 5, per_file: 2, ..set(&folder, 1, None) }).unwrap();
        assert!(whole.keys().filter(|n| n.starts_with("homes_")).all(|n| files(&folder)[n] == whole[n]));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_set_may_end_with_the_last_seed() {
        let folder = folder("last");
        let last = Set { seed: u64::MAX - 2, count: 3, per_file: 2, ..set(&folder, 2, None) };
        run(&last).unwrap();
        let manifest: serde_json::Value =
            serde_json::from_slice(&std::fs::read(folder.join("manifest.json")).unwrap()).unwrap();
        assert_eq!(files(&folder).keys().filter(|n| n.ends_with(".jsonl.gz")).count(), 2);
        assert!(manifest.to_string().contains(&(u64::MAX - 2).to_string()), "{manifest}");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn shards_are_read() {
        assert_eq!("3/16".parse(), Ok(Shard { index: 3, of: 16 }));
        for wrong in ["", "3", "16/16", "1/0", "-1/2", "a/b"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
