//! The parts of a goal that hold if there is nothing of what they name.

use vc_graph::goal::{Comparison, Goal, Literal, Pairs, Quantified, Term, Variable};

/// The terms of the parts that must not hold, or must hold for all of a class.
pub(crate) fn terms(goal: &Goal) -> Vec<Term> {
    let mut found = Terms(Vec::new());
    found.visit(goal, true);
    found.0
}

struct Terms(Vec<Term>);

impl Terms {
    /// Looks at a part that is to hold, or is not to hold.
    fn visit(&mut self, goal: &Goal, wanted: bool) {
        match goal {
            Goal::Literal(literal) => self.literal(literal, !wanted),
            Goal::Count { literal, comparison, number } => {
                self.literal(literal, !wanted || is_bounded(*comparison, *number));
            }
            Goal::Not(part) => self.visit(part, !wanted),
            Goal::Imply(a, b) | Goal::Before(b, a) => {
                self.visit(a, !wanted);
                self.visit(b, wanted);
            }
            Goal::Until(a, b) => [a, b].into_iter().for_each(|part| self.visit(part, wanted)),
            Goal::And(parts) | Goal::Or(parts) | Goal::Then(parts) => {
                parts.iter().for_each(|part| self.visit(part, wanted));
            }
            Goal::Eventually(part) | Goal::Always(part) | Goal::Within(_, part) | Goal::AtEnd(part) => {
                self.visit(part, wanted);
            }
            Goal::ForAll(q) => self.quantified(q, wanted, wanted),
            Goal::Exists(q) => self.quantified(q, !wanted, wanted),
            Goal::ForN { comparison, number, of } => {
                self.quantified(of, !wanted || is_bounded(*comparison, *number), wanted);
            }
            Goal::ForPairs(Pairs { first, second, body, .. }) => {
                self.0.extend([first, second].into_iter().filter_map(class_of));
                self.visit(body, wanted);
            }
            _ => {}
        }
    }

    fn literal(&mut self, literal: &Literal, counts: bool) {
        self.0.extend(literal.terms.iter().filter(|_| counts).cloned());
    }

    fn quantified(&mut self, of: &Quantified, counts: bool, wanted: bool) {
        self.0.extend(of.class.clone().filter(|_| counts).map(Term::Class));
        self.visit(&of.body, wanted);
    }
}

/// Whether none at all may be enough.
fn is_bounded(comparison: Comparison, number: u32) -> bool {
    comparison.admits(0, number)
}

fn class_of(variable: &Variable) -> Option<Term> {
    variable.class.clone().map(Term::Class)
}
