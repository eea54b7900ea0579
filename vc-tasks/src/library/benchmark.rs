//! The benchmark: few base tasks, each with many variants.

use serde::Deserialize;
use vc_graph::format::unmarked;
use vc_graph::goal::GoalError;
use vc_graph::hash::fnv1a;
use vc_graph::{Digest, Goal};

use super::activity::nothing;
use super::{Activity, Need, NeedError};

const V1: &str = include_str!("../../data/library/benchmark.json");

/// A fixed list of tasks under fixed identifiers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Benchmark {
    /// Name and version, `virtualcity-145 v1`. The tasks of a version never change.
    pub version: String,
    /// The tasks; the variants of a base task are adjacent.
    pub activities: Vec<Activity>,
}

/// A mistake in the text of a benchmark.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BenchmarkError {
    /// The file does not have the expected form.
    #[error("benchmark: {0}")]
    Form(String),
    /// A base task filled in with one of its variants is not a task.
    #[error("{id}: `{text}`: {why}")]
    Variant {
        /// The task's identifier.
        id: String,
        /// The text after the variant was filled in.
        text: String,
        /// The reason why it is not a task.
        #[source]
        why: Box<VariantError>,
    },
}

/// The reason why a filled-in text is not part of a task.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum VariantError {
    /// It is not a goal.
    #[error(transparent)]
    Goal(#[from] GoalError),
    /// It is not a need.
    #[error(transparent)]
    Need(#[from] NeedError),
}

/// A base task as written in the file: `$1` to `$9` stand for the words of a variant; `each` and
/// `each_need` are repeated for each word, where `2 plate` gives `#` its number and `$` its class.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Base {
    base: String,
    title: String,
    goal: String,
    each: String,
    natural: String,
    needs: Vec<String>,
    each_need: String,
    start: String,
    places: Vec<String>,
    variants: Vec<Vec<String>>,
}

impl Benchmark {
    /// Version 1: 145 tasks from 20 bases, all in the home.
    ///
    /// ```
    /// use vc_tasks::library::Benchmark;
    /// let benchmark = Benchmark::v1();
    /// assert_eq!(benchmark.activities.len(), 145);
    /// let first = benchmark.get("put_fridge-01").ok_or("no such task")?;
    /// assert_eq!(
    ///     first.goal.to_string(),
    ///     "Inside(milk, fridge) & Inside(bread, fridge) & Inside(meal, fridge) & Inside(jug, fridge)",
    /// );
    /// # Ok::<(), &str>(())
    /// ```
    pub fn v1() -> Self {
        // A test reads the text and reports its errors.
        let activities = Self::read(V1).unwrap_or_default();
        Self { version: "virtualcity-145 v1".into(), activities }
    }

    /// Reads base tasks and expands all their variants.
    ///
    /// # Errors
    /// [`BenchmarkError`] with the text that is wrong and the reason.
    pub fn read(text: &str) -> Result<Vec<Activity>, BenchmarkError> {
        let bases: Vec<Base> = serde_json::from_str(unmarked(text)).map_err(|e| BenchmarkError::Form(e.to_string()))?;
        bases.iter().flat_map(|base| (0..base.variants.len()).map(move |i| base.variant(i))).collect()
    }

    /// Finds the task with an identifier.
    pub fn get(&self, id: &str) -> Option<&Activity> {
        self.activities.iter().find(|a| a.id == id)
    }

    /// A digest that changes whenever anything about the tasks changes.
    pub fn digest(&self) -> Digest {
        let text = serde_json::to_string(&self.activities).unwrap_or_default();
        Digest(fnv1a(text.bytes()))
    }
}

impl Activity {
    /// The base task of which it is a variant, `put_fridge`; for the thesis's tasks, their list.
    ///
    /// ```
    /// use vc_tasks::library::Benchmark;
    /// assert_eq!(Benchmark::v1().get("put_fridge-01").map(|activity| activity.group()), Some("put_fridge"));
    /// ```
    pub fn group(&self) -> &str {
        self.id.rsplit_once('-').map_or(&self.id, |(group, _)| group)
    }
}

impl Base {
    fn variant(&self, index: usize) -> Result<Activity, BenchmarkError> {
        let words = &self.variants[index];
        let id = format!("{}-{:02}", self.base, index + 1);
        let fill = |text: &String| {
            (1..).zip(words).fold(text.clone(), |text, (number, word)| text.replace(&format!("${number}"), word))
        };
        let goal = |text: String| match text.trim() {
            "" => Ok(nothing()),
            text => text.parse::<Goal>().map_err(|e| wrong(&id, text, e)),
        };
        let needs = self.needs.iter().map(fill).chain(words.iter().map(|word| numbered(&self.each_need, word)));
        let need = |text: String| text.parse::<Need>().map_err(|e| wrong(&id, &text, e));
        Ok(Activity {
            title: self.title.clone(),
            goal: goal(self.goal_text(words, fill(&self.goal)))?,
            natural: goal(fill(&self.natural))?,
            needs: needs.filter(|text| !text.is_empty()).map(need).collect::<Result<_, _>>()?,
            start: goal(fill(&self.start))?,
            places: self.places.iter().map(fill).collect(),
            id,
        })
    }

    fn goal_text(&self, words: &[String], own: String) -> String {
        let each = words.iter().map(|word| numbered(&self.each, word));
        let parts: Vec<String> = each.chain(std::iter::once(own)).filter(|part| !part.is_empty()).collect();
        parts.join(" & ")
    }
}

/// Fills a text in for one word of a variant: of `2 plate`, the number replaces `#` and the class `$`.
fn numbered(text: &str, word: &str) -> String {
    let (number, class) = word.split_once(' ').unwrap_or(("1", word));
    text.replace('#', number).replace('$', class)
}

fn wrong(id: &str, text: &str, why: impl Into<VariantError>) -> BenchmarkError {
    BenchmarkError::Variant { id: id.to_owned(), text: text.to_owned(), why: Box::new(why.into()) }
}
