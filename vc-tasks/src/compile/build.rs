//! Building gates: equal gates are stored once, and constants are folded.

use vc_graph::goal::{Comparison, Pairs, Variable};

use super::gate::{Gate, GateKind, Ref, Table};
use super::ground::{Ground, Things};
use super::{CompileError, GoalProgram};

impl<'g, T: Things> Ground<'_, 'g, T> {
    pub(super) fn all(&mut self, start: usize) -> Result<Ref, CompileError> {
        let number = self.memory.stack.len() - start;
        self.count(start, Comparison::AtLeast, number as u32)
    }

    /// Makes a gate of the inputs on the stack from `start` on, which are popped.
    pub(super) fn count(&mut self, start: usize, comparison: Comparison, number: u32) -> Result<Ref, CompileError> {
        let stack = &mut self.memory.stack;
        let sure = stack[start..].iter().filter(|&&r| r == Ref::TRUE).count() as u32;
        let mut kept = start;
        for at in start..stack.len() {
            if !stack[at].is_constant() {
                stack[kept] = stack[at];
                kept += 1;
            }
        }
        stack.truncate(kept);
        let open = (kept - start) as u32;
        let at_least = |g: &mut Self, k: u32| match k.saturating_sub(sure) {
            0 => Ok(Ref::TRUE),
            k if k > open => Ok(Ref::FALSE),
            1 if open == 1 => Ok(g.memory.stack[start]),
            k if k == open => g.gate(start, GateKind::All),
            1 => g.gate(start, GateKind::Any),
            k => g.gate(start, GateKind::AtLeast(k)),
        };
        let result = match comparison {
            Comparison::AtLeast => at_least(self, number),
            Comparison::AtMost => at_least(self, number.saturating_add(1)).map(|r| !r),
            Comparison::Exactly if number < sure || number - sure > open => Ok(Ref::FALSE),
            Comparison::Exactly if number == sure => at_least(self, number.saturating_add(1)).map(|r| !r),
            Comparison::Exactly if number - sure == open => at_least(self, number),
            Comparison::Exactly => self.gate(start, GateKind::Exactly(number - sure)),
        };
        self.memory.stack.truncate(start);
        result
    }

    /// Returns the gate with the inputs on the stack from `start` on; an equal existing gate is
    /// reused.
    pub(super) fn gate(&mut self, start: usize, kind: GateKind) -> Result<Ref, CompileError> {
        let inputs = &self.memory.stack[start..];
        let GoalProgram { gates, inputs: all, .. } = &mut self.program;
        let next = gates.len();
        let of = |n: usize| &all[Gate::inputs(gates[n])];
        let same = |n: usize| gates[n].kind == kind && of(n) == inputs;
        let number =
            self.memory.gates.number(kind.key(inputs), next, same, |n| gates[n].kind.key(&all[Gate::inputs(gates[n])]));
        if number == next {
            gates.push(Gate::new(kind, all.len(), inputs));
            all.extend_from_slice(inputs);
        }
        Ok(Ref::gate(number))
    }

    pub(super) fn pairs(&mut self, pairs: &'g Pairs) -> Result<Ref, CompileError> {
        let start = self.memory.stack.len();
        let range = |g: &mut Self, v: &'g Variable| g.range(v.class.as_deref());
        let (rows, columns) = (range(self, &pairs.first), range(self, &pairs.second));
        for row in rows.clone() {
            for column in columns.clone() {
                self.count_part()?;
                let (a, b) = (self.memory.pool[row], self.memory.pool[column]);
                let input = match a == b {
                    true => Ref::FALSE,
                    false => {
                        let second = &pairs.second.name;
                        self.with(&pairs.first.name, a, |g| g.with(second, b, |g| g.goal(&pairs.body)).0).0?
                    }
                };
                self.memory.stack.push(input);
            }
        }
        let table = Table { rows: rows.len() as u32, columns: columns.len() as u32, need: 0, pairing: pairs.pairing };
        let result = self.enough(start, table, pairs.number);
        self.memory.stack.truncate(start);
        result
    }

    fn enough(&mut self, start: usize, table: Table, number: Option<(Comparison, u32)>) -> Result<Ref, CompileError> {
        let most = table.rows.min(table.columns);
        let at_least = |g: &mut Self, need: u32| match need {
            0 => Ok(Ref::TRUE),
            need if need > most => Ok(Ref::FALSE),
            need => g.gate(start, GateKind::Pairs(Table { need, ..table })),
        };
        match number {
            None => at_least(self, most),
            Some((Comparison::AtLeast, number)) => at_least(self, number),
            Some((Comparison::AtMost, number)) => at_least(self, number.saturating_add(1)).map(|r| !r),
            Some((Comparison::Exactly, number)) => {
                let both = [at_least(self, number)?, !at_least(self, number.saturating_add(1))?];
                self.memory.stack.truncate(start);
                self.memory.stack.extend(both);
                self.all(start)
            }
        }
    }
}
