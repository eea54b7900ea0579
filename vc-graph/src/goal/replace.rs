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
        let of = |part: &Self| part.with_terms(replace);
        let boxed = |part: &Self| Box::new(of(part));
        let all = |parts: &[Self]| parts.iter().map(of).collect::<Vec<_>>();
        match self {
            Self::Literal(literal) => Self::Literal(literal.with_terms(replace)),
            Self::Count { literal, comparison, number } => {
                Self::Count { literal: literal.with_terms(replace), comparison: *comparison, number: *number }
            }
            Self::Same(a, b) => Self::Same(replace(a), replace(b)),
            Self::And(parts) => Self::And(all(parts)),
            Self::Or(parts) => Self::Or(all(parts)),
            Self::Then(parts) => Self::Then(all(parts)),
            Self::Not(part) => Self::Not(boxed(part)),
            Self::Imply(a, b) => Self::Imply(boxed(a), boxed(b)),
            Self::ForAll(q) => Self::ForAll(q.with_terms(replace)),
            Self::Exists(q) => Self::Exists(q.with_terms(replace)),
            Self::ForN { comparison, number, of } => {
                Self::ForN { comparison: *comparison, number: *number, of: of.with_terms(replace) }
            }
            Self::ForPairs(pairs) => {
                let names = [&*pairs.first.name, &*pairs.second.name];
                let body = Box::new(pairs.body.with_terms(&except(&names, replace)));
                Self::ForPairs(Pairs { body, ..pairs.clone() })
            }
            Self::Eventually(part) => Self::Eventually(boxed(part)),
            Self::Always(part) => Self::Always(boxed(part)),
            Self::Within(steps, part) => Self::Within(*steps, boxed(part)),
            Self::AtEnd(part) => Self::AtEnd(boxed(part)),
            Self::Until(a, b) => Self::Until(boxed(a), boxed(b)),
            Self::Before(a, b) => Self::Before(boxed(a), boxed(b)),
        }
    }
}

impl Literal {
    fn with_terms(&self, replace: &dyn Fn(&Term) -> Term) -> Self {
        Self { predicate: self.predicate, terms: self.terms.iter().map(replace).collect() }
    }
}

impl Quantified {
    fn with_terms(&self, replace: &dyn Fn(&Term) -> Term) -> Self {
        let names = [&*self.variable];
        Self { body: Box::new(self.body.with_terms(&except(&names, replace))), ..self.clone() }
    }
}

/// A replacement that leaves some variables alone.
fn except<'a>(names: &'a [&'a str], replace: &'a dyn Fn(&Term) -> Term) -> impl Fn(&Term) -> Term + 'a {
    move |term| match term {
        Term::Variable(name) if names.contains(&name.as_str()) => term.clone(),
        other => replace(other),
    }
}
