//! The forms that boxes of a class get: a table.

use std::sync::LazyLock;

use vc_graph::{Node, SceneGraph};

use crate::is_a;

/// The form that a box gets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Form {
    Solid,
    Table,
    Seat,
    Slab,
    Case,
    Basin,
}

/// One line of the table.
struct Row {
    class: &'static str,
    form: Form,
    /// Level of seat or slab above the bottom at most, metres.
    level: Option<f32>,
}

static TABLE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    // A test reads the table and shows the line that cannot be read.
    rows(include_str!("../data/forms.txt")).unwrap_or_default()
});

/// The lines of a table; the error is the line that cannot be read.
fn rows(text: &'static str) -> Result<Vec<Row>, &'static str> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| row(line).ok_or(line)).collect()
}

fn row(line: &'static str) -> Option<Row> {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    let [class, form, level] = columns[..] else { return None };
    let form = match form {
        "solid" => Form::Solid,
        "table" => Form::Table,
        "seat" => Form::Seat,
        "slab" => Form::Slab,
        "case" => Form::Case,
        "basin" => Form::Basin,
        _ => return None,
    };
    let level = if level.is_empty() { None } else { Some(level.parse().ok()?) };
    Some(Row { class, form, level })
}

/// The form and level of a node's class, or of the first in the table that it is a kind of.
pub(crate) fn form_of(graph: &SceneGraph, node: &Node) -> Option<(Form, Option<f32>)> {
    TABLE.iter().find(|row| is_a(graph, node, row.class)).map(|row| (row.form, row.level))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read_and_names_a_class() {
        let table = rows(include_str!("../data/forms.txt"));
        assert_eq!(table.as_ref().err(), None);
        let classes = vc_graph::ClassTable::builtin();
        for row in table.iter().flatten() {
            assert_eq!(classes.get(row.class).map(|c| &*c.name), Some(row.class));
        }
        // Faults are found.
        for line in ["bed | slap | 0.5", "bed | slab | 0.5O", "bed | slab"] {
            assert_eq!(rows(line).err(), Some(line));
        }
    }
}
