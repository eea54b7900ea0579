//! Formulas over ground atoms, as circuits: equal parts are one gate.

use std::collections::HashMap;

use vc_graph::goal::{Comparison, Literal, Pairing};

/// Index of a gate.
pub(crate) type Wire = u32;

/// How many of some gates, or of pairs, must be true.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Number {
    pub(super) comparison: Comparison,
    pub(super) number: u32,
}

impl Number {
    pub(super) fn admits(self, found: usize) -> bool {
        self.comparison.admits(found, self.number)
    }

    /// Whether some number from `least` to `most` is admitted.
    pub(super) fn admits_between(self, least: usize, most: usize) -> bool {
        let number = self.number as usize;
        match self.comparison {
            Comparison::AtLeast => most >= number,
            Comparison::AtMost => least <= number,
            Comparison::Exactly => (least..=most).contains(&number),
        }
    }

    /// Whether all numbers from `least` to `most` are admitted.
    pub(super) fn admits_all(self, least: usize, most: usize) -> bool {
        self.admits(least) && self.admits(most)
    }
}

/// Part of a formula, of parts before it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Gate {
    /// What is said of given things.
    Atom(Literal),
    Not(Wire),
    All(Vec<Wire>),
    Any(Vec<Wire>),
    /// So many of these are true.
    Count(Vec<Wire>, Number),
    /// So many pairs, one row with one column: for each row the columns it goes
    /// with and the gate that says whether.
    Pairs {
        rows: Vec<Vec<(usize, Wire)>>,
        columns: usize,
        number: Number,
        pairing: Pairing,
    },
}

/// A formula: gates, those they are made of first.
#[derive(Debug, Default)]
pub(crate) struct Formula {
    gates: Vec<Gate>,
    known: HashMap<Gate, Wire>,
    root: Wire,
    heads: Vec<Wire>,
}

impl Formula {
    /// The wire of a gate, which is made if there is none like it.
    pub(super) fn wire(&mut self, gate: Gate) -> Wire {
        if let Some(&wire) = self.known.get(&gate) {
            return wire;
        }
        let wire = self.gates.len() as Wire;
        self.gates.push(gate.clone());
        self.known.insert(gate, wire);
        wire
    }

    /// Says which gate is the formula, and which its goals.
    pub(super) fn finish(&mut self, root: Wire, heads: Vec<Wire>) {
        (self.root, self.heads) = (root, heads);
    }

    pub(super) fn root(&self) -> Wire {
        self.root
    }

    pub(super) fn gates(&self) -> &[Gate] {
        &self.gates
    }

    /// The atoms and their wires.
    pub(crate) fn atoms(&self) -> impl Iterator<Item = (Wire, &Literal)> {
        (0..).zip(&self.gates).filter_map(|(wire, gate)| match gate {
            Gate::Atom(literal) => Some((wire, literal)),
            _ => None,
        })
    }

    /// Which of the goals are true when these atoms are.
    pub(crate) fn heads(&self, is_true: impl Fn(&Literal) -> bool) -> Vec<bool> {
        let mut values: Vec<bool> = Vec::with_capacity(self.gates.len());
        for gate in &self.gates {
            let at = |wire: &Wire| values[*wire as usize];
            let value = match gate {
                Gate::Atom(literal) => is_true(literal),
                Gate::Not(part) => !at(part),
                Gate::All(parts) => parts.iter().all(at),
                Gate::Any(parts) => parts.iter().any(at),
                Gate::Count(parts, number) => number.admits(parts.iter().filter(|p| at(p)).count()),
                Gate::Pairs { rows, columns, number, pairing } => {
                    number.admits(pairing.number(&table(rows, at), *columns))
                }
            };
            values.push(value);
        }
        self.heads.iter().map(|&head| values[head as usize]).collect()
    }
}

/// The columns that go with each row.
pub(super) fn table(rows: &[Vec<(usize, Wire)>], goes: impl Fn(&Wire) -> bool) -> Vec<Vec<usize>> {
    let row = |row: &Vec<(usize, Wire)>| row.iter().filter(|(_, wire)| goes(wire)).map(|(column, _)| *column).collect();
    rows.iter().map(row).collect()
}
