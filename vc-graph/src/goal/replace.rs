//! Goals with other terms in them.

use super::{Goal, Literal, Pairs, Quantified, Term};

impl Goal {
    /// The goal with each term replaced by another: a variable by the node that it stands for, a name by a node.
    /// A variable that a quantifier within the goal binds stays.
    ///
    /// ```
    /// use vc_graph::NodeId;
    /// use vc_graph::goal::{Goal, Term};
    /// let goal: Goal = "On(cup, table)".parse()?;
    /// let cup = |term: &Term| match term {
    ///     Term::Class(name) if name == "cup" => Term::Node(Some("cup".into()), NodeId(4)),
    ///     other => other.clone(),
    /// };
    /// assert_eq!(goal.with_terms(&cup).to_string(), "On(cup.4, table)");
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    #[must_use]
    pub fn with_terms(&self, replace: &dyn Fn(&Term) -> Term) -> Self {
        match self {
            Self::Literal(literal) => Self::Literal(literal.with_terms(replace)),
            Self::Count { literal, comparison, number } => {
                Self::Count { literal: literal.with_terms(replace), comparison: *comparison, number: *number }
            }
            Self::Same(a, b) => Self::Same(replace(a), replace(b)),
            Self::ForAll(Quantified { variable, .. })
            | Self::Exists(Quantified { variable, .. })
            | Self::ForN { of: Quantified { variable, .. }, .. } => {
                self.with_parts(&mut |part| part.with_terms(&except(&[variable], replace)))
            }
            Self::ForPairs(Pairs { first, second, .. }) => {
                self.with_parts(&mut |part| part.with_terms(&except(&[&first.name, &second.name], replace)))
            }
            _ => self.with_parts(&mut |part| part.with_terms(replace)),
        }
    }

    /// The goal with each of its direct parts replaced by another.
    pub(crate) fn with_parts(&self, replace: &mut dyn FnMut(&Self) -> Self) -> Self {
        let mut all = |parts: &[Self]| parts.iter().map(&mut *replace).collect::<Vec<_>>();
        match self {
            Self::And(parts) => return Self::And(all(parts)),
            Self::Or(parts) => return Self::Or(all(parts)),
            Self::Then(parts) => return Self::Then(all(parts)),
            _ => {}
        }
        let mut boxed = |part: &Self| Box::new(replace(part));
        let mut of = |q: &Quantified| Quantified { body: boxed(&q.body), ..q.clone() };
        match self {
            Self::ForAll(q) => Self::ForAll(of(q)),
            Self::Exists(q) => Self::Exists(of(q)),
            Self::ForN { comparison, number, of: q } => {
                Self::ForN { comparison: *comparison, number: *number, of: of(q) }
            }
            Self::ForPairs(pairs) => Self::ForPairs(Pairs { body: boxed(&pairs.body), ..pairs.clone() }),
            Self::Not(part) => Self::Not(boxed(part)),
            Self::Imply(a, b) => Self::Imply(boxed(a), boxed(b)),
            Self::Eventually(part) => Self::Eventually(boxed(part)),
            Self::Always(part) => Self::Always(boxed(part)),
            Self::Within(steps, part) => Self::Within(*steps, boxed(part)),
            Self::AtEnd(part) => Self::AtEnd(boxed(part)),
            Self::Until(a, b) => Self::Until(boxed(a), boxed(b)),
            Self::Before(a, b) => Self::Before(boxed(a), boxed(b)),
            Self::Literal(_) | Self::Count { .. } | Self::Same(..) | Self::And(_) | Self::Or(_) | Self::Then(_) => {
                self.clone()
            }
        }
    }
}

impl Literal {
    fn with_terms(&self, replace: &dyn Fn(&Term) -> Term) -> Self {
        Self { predicate: self.predicate, terms: self.terms.iter().map(replace).collect() }
    }
}

/// A replacement that leaves some variables alone.
fn except<'a>(names: &'a [&'a str], replace: &'a dyn Fn(&Term) -> Term) -> impl Fn(&Term) -> Term + 'a {
    move |term| match term {
        Term::Variable(name) if names.contains(&name.as_str()) => term.clone(),
        other => replace(other),
    }
}
