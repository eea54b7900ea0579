//! Tables of costs: a bench prints them, and with `VC_BENCH=write` it puts them into `benches/README.md`, between
//! the markers of its name.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde_json::Value;

/// The tables that one bench makes.
pub struct Page {
    bench: &'static str,
    begun: SystemTime,
    machine: String,
    tables: Vec<String>,
}

/// A time that criterion measured.
struct Measured {
    name: String,
    /// The parameter of the bench, such as a number of objects.
    parameter: Option<String>,
    cell: String,
}

impl Page {
    /// The tables of a bench that begins now. Results that criterion wrote earlier do not count.
    pub fn new(bench: &'static str) -> Self {
        Self { bench, begun: SystemTime::now(), machine: machine(), tables: Vec::new() }
    }

    /// Adds a table and prints it; one without rows is left out.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        if rows.is_empty() {
            return;
        }
        let line = |cells: Vec<&str>| format!("| {} |\n", cells.join(" | "));
        let rule = line(vec!["---"; head.len()]).replace(' ', "");
        let rows = rows.iter().map(|row| line(row.iter().map(String::as_str).collect()));
        let table: String = [line(head.to_vec()), rule].into_iter().chain(rows).collect();
        print(&table);
        self.tables.push(table);
    }

    /// Adds the medians of everything that criterion has measured since the bench began: in columns by the
    /// parameters of benches that have some.
    pub fn criterion(&mut self) {
        let (by_parameter, plain): (Vec<_>, Vec<_>) =
            self.measured().into_iter().partition(|one| one.parameter.is_some());
        self.by_parameter(&by_parameter);
        let rows: Vec<_> = plain.into_iter().map(|one| vec![one.name, one.cell]).collect();
        self.table(&["", "median"], &rows);
    }

    fn by_parameter(&mut self, measured: &[Measured]) {
        let mut columns: Vec<&str> = measured.iter().filter_map(|one| one.parameter.as_deref()).collect();
        let mut seen = BTreeSet::new();
        columns.retain(|parameter| seen.insert(*parameter));
        let mut rows: Vec<Vec<String>> = Vec::new();
        for one in measured {
            let Some(column) = columns.iter().position(|c| Some(*c) == one.parameter.as_deref()) else { continue };
            if !rows.iter().any(|row| row[0] == one.name) {
                rows.push([vec![one.name.clone()], vec![String::new(); columns.len()]].concat());
            }
            rows.iter_mut().filter(|row| row[0] == one.name).for_each(|row| row[column + 1].clone_from(&one.cell));
        }
        let head: Vec<&str> = std::iter::once("median").chain(columns).collect();
        self.table(&head, &rows);
    }

    /// The results of criterion in the order in which they were written.
    fn measured(&self) -> Vec<Measured> {
        let mut files = Vec::new();
        let program = std::env::current_exe().unwrap();
        let target = program.ancestors().nth(3).unwrap_or(Path::new("target"));
        let folder = std::env::var_os("CRITERION_HOME").map_or_else(|| target.join("criterion"), PathBuf::from);
        find(&folder, &mut files);
        let written = |file: &PathBuf| file.metadata().and_then(|of| of.modified()).unwrap_or(SystemTime::UNIX_EPOCH);
        files.retain(|file| written(file) >= self.begun);
        files.sort_by_key(written);
        files.iter().filter_map(|file| Measured::read(file)).collect()
    }

    /// Writes the tables into the page if `VC_BENCH=write`.
    ///
    /// # Panics
    /// If the page has no markers of this bench.
    pub fn finish(self) {
        print(&format!("{}\n", self.machine));
        if self.tables.is_empty() || !std::env::var("VC_BENCH").is_ok_and(|v| v == "write") {
            return;
        }
        let tables: String = self.tables.iter().map(|table| format!("\n{table}")).collect();
        let made = format!("{}\n{tables}", self.machine);
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/README.md");
        let page = std::fs::read_to_string(&path).unwrap();
        let page = replaced(&page, self.bench, &made).unwrap_or_else(|| panic!("the page has no {}", self.bench));
        std::fs::write(&path, page).unwrap();
    }
}

impl Measured {
    /// Reads `estimates.json` and the `benchmark.json` beside it.
    fn read(file: &Path) -> Option<Self> {
        let json = |path: &Path| -> Option<Value> { serde_json::from_slice(&std::fs::read(path).ok()?).ok() };
        let (times, of) = (json(file)?, json(&file.with_file_name("benchmark.json"))?);
        let median = times["median"]["point_estimate"].as_f64()? * 1e-9;
        let each = of["throughput"]["Elements"].as_f64().map(|count| format!(" ({} each)", time(median / count)));
        let names = [of["group_id"].as_str(), of["function_id"].as_str()];
        Some(Self {
            name: names.into_iter().flatten().collect::<Vec<_>>().join(": "),
            parameter: of["value_str"].as_str().map(str::to_owned),
            cell: format!("{}{}", time(median), each.unwrap_or_default()),
        })
    }
}

/// All results of criterion below a folder.
fn find(folder: &Path, files: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        if path.is_dir() {
            find(&path, files);
        } else if path.ends_with("new/estimates.json") {
            files.push(path);
        }
    }
}

/// The page with other tables between the markers of a bench; nothing without these.
fn replaced(page: &str, bench: &str, made: &str) -> Option<String> {
    let [open, close] = [format!("<!-- bench: {bench} -->\n"), format!("<!-- /bench: {bench} -->")];
    let (before, rest) = page.split_once(&open)?;
    let (_, after) = rest.split_once(&close)?;
    Some(format!("{before}{open}{made}{close}{after}"))
}

/// The processors, and how busy the machine is.
fn machine() -> String {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let info = read("/proc/cpuinfo");
    let named = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let model = named.map_or(std::env::consts::ARCH, |(_, name)| name.trim());
    let count = std::thread::available_parallelism().map_or(1, usize::from);
    let busy = read("/proc/loadavg");
    let load = busy.split(' ').next().filter(|load| !load.is_empty()).unwrap_or("unknown");
    format!("{model}, {count} processors; load at the start: {load}")
}

/// A time in three digits, with its unit.
pub fn time(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    let (unit, name) = units.into_iter().find(|(unit, _)| seconds >= *unit).unwrap_or((1e-9, "ns"));
    let number = seconds / unit;
    let digits = if number < 9.995 { 2 } else { usize::from(number < 99.95) };
    format!("{number:.digits$} {name}")
}

fn print(text: &str) {
    std::io::stdout().write_all(text.as_bytes()).unwrap();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_stand_between_their_markers() {
        let page = "a\n<!-- bench: x -->\nold\n<!-- /bench: x -->\nb\n<!-- bench: y -->\n<!-- /bench: y -->\n";
        let new = replaced(page, "x", "new\n").unwrap();
        assert_eq!(new, page.replace("old", "new"));
        assert_eq!(replaced(&new, "x", "old\n").unwrap(), page);
        assert_eq!(replaced(page, "z", "new\n"), None);
    }

    #[test]
    fn times_have_three_digits() {
        assert_eq!([4.2, 0.0123, 9.996e-6, 1.5e-7].map(time), ["4.20 s", "12.3 ms", "10.0 µs", "150 ns"]);
    }
}
