//! How long actions take that a body's motion does not time.

use std::sync::{Arc, LazyLock};

use super::error::ClockError;
use super::kind::Kinds;
use super::text::{Line, lines, span};
use super::tick::Span;
use crate::class::ClassTable;
use crate::vocabulary::Word;
use crate::{Action, SceneGraph, Verb};

const COLUMNS: [&str; 3] = ["verb", "things", "takes"];

/// A line of the table.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    verb: Verb,
    /// `None` for all things, and for actions without one.
    kinds: Option<Kinds>,
    takes: Span,
}

/// How long actions take that are not timed by a body's motion, as walking is, nor by a process, as cooking is.
///
/// The built-in table is `data/durations.txt`; [`Durations::parse`] describes its form and [`Durations::extended`] adds
/// lines.
///
/// ```
/// use vc_graph::clock::{Durations, Span};
/// use vc_graph::{Action, Draft, SceneBuilder, Verb};
/// let mut scene = SceneBuilder::new("flat");
/// let [pizza, apple] = [scene.add(Draft::new("pizza"))?, scene.add(Draft::new("apple"))?];
/// let (graph, durations) = (scene.build(), Durations::builtin());
/// let takes = |action| durations.takes(&graph, &action).map(Span::seconds);
/// assert_eq!(takes(Action::one(Verb::Eat, pizza)), Some(600.0));
/// assert_eq!(takes(Action::one(Verb::Eat, apple)), Some(120.0));
/// assert_eq!(takes(Action::one(Verb::Walk, apple)), None);
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Durations {
    rows: Vec<Row>,
}

impl Durations {
    /// The built-in durations, read once per process.
    pub fn builtin() -> Arc<Self> {
        static TABLE: LazyLock<Arc<Durations>> = LazyLock::new(|| {
            let text = include_str!("../../data/durations.txt");
            let table = Durations::parse("durations.txt", text, &ClassTable::builtin());
            // A test reads the built-in text and shows its errors.
            Arc::new(table.unwrap_or_default())
        });
        TABLE.clone()
    }

    /// Parses a table of durations.
    ///
    /// One line each, three columns separated by `|`; `#` starts a comment line:
    ///
    /// `verb | things | takes`
    ///
    /// Things are kinds of the first object as in [`ProcessTable::parse`](super::ProcessTable::parse); `*` is
    /// everything and also an action without an object. If several lines apply to an action, **the last one counts**.
    ///
    /// ```
    /// use vc_graph::clock::Durations;
    /// use vc_graph::ClassTable;
    /// let error = Durations::parse("mine.txt", "\neat | aple | 2 min", &ClassTable::builtin()).unwrap_err();
    /// assert_eq!((error.line, error.column), (2, "things"));
    /// assert!(error.to_string().contains("there is no class `aple` (did you mean `apple`"));
    /// ```
    ///
    /// # Errors
    /// [`ClockError`], with line, column and the expected form.
    pub fn parse(file: &str, text: &str, classes: &ClassTable) -> Result<Self, ClockError> {
        Self::default().extended(file, text, classes)
    }

    /// This table extended by the lines of another text: they come last and therefore count before those of this table.
    ///
    /// # Errors
    /// As [`Durations::parse`].
    pub fn extended(&self, file: &str, text: &str, classes: &ClassTable) -> Result<Self, ClockError> {
        let new = lines((file, text), &COLUMNS, classes, row)?;
        Ok(Self { rows: self.rows.iter().cloned().chain(new).collect() })
    }

    /// The time that an action takes; `None` if no line applies: then a body's motion or a process has to say. Costs at
    /// most a look-up of the class for each line of the verb.
    pub fn takes(&self, graph: &SceneGraph, action: &Action) -> Option<Span> {
        let object = action.object.and_then(|id| graph.node(id));
        let fits = |kinds: &Kinds| object.is_some_and(|node| kinds.have(graph, node));
        let applies = |row: &&Row| row.verb == action.verb && row.kinds.as_ref().is_none_or(fits);
        self.rows.iter().rev().find(applies).map(|row| row.takes)
    }
}

fn row(line: &Line<'_, 3>) -> Result<Row, ClockError> {
    let kinds = |text: &str| if text == "*" { Ok(None) } else { Kinds::parse(text, line.classes).map(Some) };
    Ok(Row {
        verb: line.read(0, |text| Ok(Verb::parse(text)?))?,
        kinds: line.read(1, kinds)?,
        takes: line.read(2, span)?,
    })
}
