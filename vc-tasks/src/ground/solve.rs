//! Whether a formula can be true.
//!
//! Davis, Logemann and Loveland's search (CACM 1962) on the circuit itself: what
//! follows from what is known is carried up from parts to wholes and down again;
//! then some gate nearest the whole is tried true, and if that fails, false.

use super::formula::{Formula, Gate, Number, Wire, table};

/// How many gates are tried before giving up. The hardest goal of the 1,016 of
/// BEHAVIOR-1K takes some hundred.
const TRIES: usize = 20_000;

/// Whether the formula can be true; `None` if that was not found out.
pub(crate) fn satisfiable(formula: &Formula) -> Option<bool> {
    if formula.gates().is_empty() {
        return Some(true);
    }
    let mut values = Values { formula, known: vec![None; formula.gates().len()] };
    if !values.set(formula.root(), true) || !values.propagate() {
        return Some(false);
    }
    let mut tries = 0;
    // What is to be tried: known values, and the gate that is false there next.
    let mut open: Vec<(Vec<Option<bool>>, Wire)> = Vec::new();
    loop {
        let Some(gate) = values.undecided() else { return Some(true) };
        tries += 1;
        if tries > TRIES {
            return None;
        }
        open.push((values.known.clone(), gate));
        let mut fits = values.set(gate, true) && values.propagate();
        while !fits {
            let Some((known, gate)) = open.pop() else { return Some(false) };
            values.known = known;
            fits = values.set(gate, false) && values.propagate();
        }
    }
}

struct Values<'f> {
    formula: &'f Formula,
    known: Vec<Option<bool>>,
}

impl Values<'_> {
    fn at(&self, wire: Wire) -> Option<bool> {
        self.known[wire as usize]
    }

    /// Whether a gate may have a value; it has it then.
    fn set(&mut self, wire: Wire, value: bool) -> bool {
        let known = &mut self.known[wire as usize];
        *known.get_or_insert(value) == value
    }

    /// The gate nearest the whole of which nothing is known.
    fn undecided(&self) -> Option<Wire> {
        self.known.iter().rposition(Option::is_none).map(|i| i as Wire)
    }

    /// Carries what is known up and down until nothing changes; false if it
    /// contradicts itself.
    fn propagate(&mut self) -> bool {
        let gates = self.formula.gates();
        loop {
            let before = self.known.iter().flatten().count();
            for (wire, gate) in (0..).zip(gates) {
                if self.up(gate).is_some_and(|value| !self.set(wire, value)) {
                    return false;
                }
            }
            for (index, gate) in gates.iter().enumerate().rev() {
                if self.at(index as Wire).is_some_and(|value| !self.down(gate, value)) {
                    return false;
                }
            }
            if self.known.iter().flatten().count() == before {
                return true;
            }
        }
    }

    /// What follows for a gate from its parts.
    fn up(&self, gate: &Gate) -> Option<bool> {
        match gate {
            Gate::Atom(_) => None,
            Gate::Not(part) => self.at(*part).map(|v| !v),
            Gate::All(parts) => self.shortcut(parts, false),
            Gate::Any(parts) => self.shortcut(parts, true),
            Gate::Count(parts, number) => self.between(*number, self.count(parts)),
            Gate::Pairs { rows, columns, number, pairing } => {
                let pairs = |maybe: bool| pairing.number(&table(rows, |w| self.at(*w).unwrap_or(maybe)), *columns);
                self.between(*number, (pairs(false), pairs(true)))
            }
        }
    }

    /// The decisive value if some part has it, the other one if all parts do.
    fn shortcut(&self, parts: &[Wire], decisive: bool) -> Option<bool> {
        if parts.iter().any(|&p| self.at(p) == Some(decisive)) {
            return Some(decisive);
        }
        parts.iter().all(|&p| self.at(p).is_some()).then_some(!decisive)
    }

    /// How many parts are true, and how many can be.
    fn count(&self, parts: &[Wire]) -> (usize, usize) {
        let number = |value: Option<bool>| parts.iter().filter(|&&p| self.at(p) == value).count();
        let certain = number(Some(true));
        (certain, certain + number(None))
    }

    fn between(&self, number: Number, (least, most): (usize, usize)) -> Option<bool> {
        match () {
            () if number.admits_all(least, most) => Some(true),
            () if !number.admits_between(least, most) => Some(false),
            () => None,
        }
    }

    /// What follows for a gate's parts from its value.
    fn down(&mut self, gate: &Gate, value: bool) -> bool {
        match gate {
            Gate::Not(part) => self.set(*part, !value),
            Gate::All(parts) if value => parts.iter().all(|&p| self.set(p, true)),
            Gate::Any(parts) if !value => parts.iter().all(|&p| self.set(p, false)),
            Gate::All(parts) => self.last_one(parts, false),
            Gate::Any(parts) => self.last_one(parts, true),
            Gate::Count(parts, number) if value => self.fill(parts, *number),
            Gate::Atom(_) | Gate::Count(..) | Gate::Pairs { .. } => true,
        }
    }

    /// If all parts but one have the other value, that one must have this.
    fn last_one(&mut self, parts: &[Wire], value: bool) -> bool {
        if parts.iter().any(|&p| self.at(p) == Some(value)) {
            return true;
        }
        let mut unknown = parts.iter().filter(|&&p| self.at(p).is_none());
        match (unknown.next().copied(), unknown.next()) {
            (Some(one), None) => self.set(one, value),
            _ => true,
        }
    }

    /// When as many as may be are true the others are not, and the other way round.
    fn fill(&mut self, parts: &[Wire], number: Number) -> bool {
        let (least, most) = self.count(parts);
        if least == most {
            return true;
        }
        let rest = match () {
            () if !number.admits_between(least + 1, most) => false,
            () if !number.admits_between(least, most - 1) => true,
            () => return true,
        };
        let unknown: Vec<Wire> = parts.iter().copied().filter(|&p| self.at(p).is_none()).collect();
        unknown.into_iter().all(|p| self.set(p, rest))
    }
}
