//! Writing domains and problems.

use std::fmt::{self, Display, Formatter};

use super::{
    AtomicFormula, Domain, Formula, Metric, NumericExpression, Operator, OperatorEffect, PlanningProblem, Signature,
    TypeUnion, TypedName,
};

/// `?a ?b - node ?h - hand`; adjacent names of one type share it.
struct List<'l>(&'l [TypedName]);

impl Display for List<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (i, group) in self.0.chunk_by(|a, b| a.kind == b.kind).enumerate() {
            f.write_str(if i == 0 { "" } else { " " })?;
            for typed in group {
                write!(f, "{} ", typed.name)?;
            }
            write!(f, "- {}", group[0].kind)?;
        }
        Ok(())
    }
}

impl Display for TypeUnion {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.any.as_slice() {
            [one] => f.write_str(one),
            any => joined(f, "either", any),
        }
    }
}

impl Display for Signature {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let gap = if self.parameters.is_empty() { "" } else { " " };
        write!(f, "({}{gap}{})", self.name, List(&self.parameters))
    }
}

impl Display for NumericExpression {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => f.write_str(number.as_str()),
            Self::Of(function) => write!(f, "{function}"),
        }
    }
}

impl Display for Metric {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let direction = if self.maximize { "maximize" } else { "minimize" };
        write!(f, "(:metric {direction} {})", self.of)
    }
}

fn joined<T: Display>(f: &mut Formatter<'_>, head: &str, parts: &[T]) -> fmt::Result {
    write!(f, "({head}")?;
    parts.iter().try_for_each(|part| write!(f, " {part}"))?;
    f.write_str(")")
}

impl Display for AtomicFormula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        joined(f, &self.predicate, &self.arguments)
    }
}

impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Atom(atom) => write!(f, "{atom}"),
            Self::Equal(a, b) => write!(f, "(= {a} {b})"),
            Self::And(parts) => joined(f, "and", parts),
            Self::Or(parts) => joined(f, "or", parts),
            Self::Not(part) => write!(f, "(not {part})"),
            Self::Imply(a, b) => write!(f, "(imply {a} {b})"),
            Self::ForAll(variables, body) => write!(f, "(forall ({}) {body})", List(variables)),
            Self::Exists(variables, body) => write!(f, "(exists ({}) {body})", List(variables)),
        }
    }
}

impl Display for OperatorEffect {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Add(atom) => write!(f, "{atom}"),
            Self::Delete(atom) => write!(f, "(not {atom})"),
            Self::Increase(function, by) => write!(f, "(increase {function} {by})"),
            Self::ForAll(variables, changes) => {
                write!(f, "(forall ({}) ", List(variables))?;
                joined(f, "and", changes)?;
                f.write_str(")")
            }
            Self::When(condition, changes) => {
                write!(f, "(when {condition} ")?;
                joined(f, "and", changes)?;
                f.write_str(")")
            }
        }
    }
}

impl Display for Operator {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "  (:action {}", self.name)?;
        writeln!(f, "    :parameters ({})", List(&self.parameters))?;
        writeln!(f, "    :precondition {}", self.precondition)?;
        f.write_str("    :effect ")?;
        joined(f, "and", &self.effect)?;
        writeln!(f, ")")
    }
}

impl Display for Domain {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "(define (domain {})", self.name)?;
        write!(f, "  ")?;
        joined(f, ":requirements", &self.requirements)?;
        if !self.types.is_empty() {
            write!(f, "\n  (:types {})", List(&self.types))?;
        }
        if !self.constants.is_empty() {
            write!(f, "\n  (:constants {})", List(&self.constants))?;
        }
        writeln!(f, "\n  (:predicates")?;
        self.predicates.iter().try_for_each(|predicate| writeln!(f, "    {predicate}"))?;
        if !self.functions.is_empty() {
            writeln!(f, "  )\n  (:functions")?;
            self.functions.iter().try_for_each(|function| writeln!(f, "    {function} - number"))?;
        }
        writeln!(f, "  )\n")?;
        self.operators.iter().try_for_each(|operator| write!(f, "{operator}"))?;
        writeln!(f, ")")
    }
}

impl Display for PlanningProblem {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "(define (problem {})\n  (:domain {})\n  (:objects", self.name, self.domain)?;
        for group in self.objects.chunk_by(|a, b| a.kind == b.kind) {
            writeln!(f, "    {}", List(group))?;
        }
        writeln!(f, "  )\n  (:init")?;
        self.initial.iter().try_for_each(|atom| writeln!(f, "    {atom}"))?;
        self.denied.iter().try_for_each(|atom| writeln!(f, "    (not {atom})"))?;
        self.values.iter().try_for_each(|(function, n)| writeln!(f, "    (= {function} {})", n.as_str()))?;
        writeln!(f, "  )\n  (:goal {})", self.goal)?;
        self.metric.iter().try_for_each(|metric| writeln!(f, "  {metric}"))?;
        writeln!(f, ")")
    }
}
