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

static TABLE: LazyLock<Vec<Row>> =
    LazyLock::new(|| include_str!("../data/forms.txt").lines().filter_map(row).collect());

fn row(line: &'static str) -> Option<Row> {
    let mut columns = line.split('|').map(str::trim);
    let (class, form) = (columns.next()?, columns.next()?);
    let form = match form {
        "solid" => Form::Solid,
        "table" => Form::Table,
        "seat" => Form::Seat,
        "slab" => Form::Slab,
        "case" => Form::Case,
        "basin" => Form::Basin,
        _ => return None,
    };
    (!class.starts_with('#')).then(|| Row { class, form, level: columns.next().and_then(|l| l.parse().ok()) })
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
        let lines = include_str!("../data/forms.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty());
        assert_eq!(lines.count(), TABLE.len());
        let classes = vc_graph::ClassTable::builtin();
        for row in TABLE.iter() {
            assert_eq!(classes.get(row.class).map(|c| &*c.name), Some(row.class));
        }
    }
}
