//! Putting definitions in the place of derived predicates.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::{Comparison, Goal, Literal, Predicate, PredicateDefinition, Quantified, Term};
use crate::Vocabulary;

impl Goal {
    /// The goal with the definitions of a vocabulary in the place of its derived predicates. A class or `_` becomes a
    /// variable, as all parts of a definition are about the same object.
    ///
    /// Functions that are given a goal together with a scene do this themselves; a predicate that the vocabulary does not
    /// define stays as it is, and does not hold. Costs a copy of the goal if it has derived predicates.
    ///
    /// ```
    /// use vc_graph::{Goal, Vocabulary};
    /// let words = Vocabulary::parse("words.txt", "predicate neat ?x | is: Clean(?x) & Folded(?x)")?;
    /// let expanded = |text: &str| text.parse().map(|goal: Goal| goal.expanded(&words).to_string());
    /// assert_eq!(expanded("Neat(shirt.4)")?, "Clean(shirt.4) & Folded(shirt.4)");
    /// assert_eq!(expanded("Neat(shirt), 3")?, "at least 3 ?x: shirt. Clean(?x) & Folded(?x)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn expanded(&self, words: &Vocabulary) -> Cow<'_, Self> {
        let plain = words.own_predicates().is_empty() || self.derived_predicates().is_empty();
        if plain { Cow::Borrowed(self) } else { Cow::Owned(self.expand(words)) }
    }

    /// Ends, as no definition refers to itself.
    fn expand(&self, words: &Vocabulary) -> Self {
        let (literal, number) = match self {
            Self::Literal(literal) => (literal, None),
            Self::Count { literal, comparison, number } => (literal, Some((*comparison, *number))),
            _ => return self.with_parts(&mut |part| part.expand(words)),
        };
        let definition = words.definition(literal.predicate);
        definition.map_or_else(|| self.clone(), |of| of.applied(literal, number).expand(words))
    }

    /// The derived predicates in the goal, each once, by name.
    ///
    /// ```
    /// use vc_graph::{Goal, Vocabulary};
    /// Vocabulary::parse("words.txt", "predicate neat ?x | is: Clean(?x) & Folded(?x)")?;
    /// let goal: Goal = "Neat(shirt.4) & Open(door.2) & Neat(shirt.5)".parse()?;
    /// let names: Vec<&str> = goal.derived_predicates().iter().map(|predicate| predicate.as_str()).collect();
    /// assert_eq!(names, ["neat"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn derived_predicates(&self) -> Vec<super::DerivedPredicate> {
        let mut found = Vec::new();
        self.each_literal(&mut |literal| {
            if let Predicate::Derived(predicate) = literal.predicate {
                found.push(predicate);
            }
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Visits the literals of the goal.
    pub(crate) fn each_literal<'g>(&'g self, visit: &mut dyn FnMut(&'g Literal)) {
        match self {
            Self::Literal(literal) | Self::Count { literal, .. } => visit(literal),
            _ => self.parts().into_iter().for_each(|part| part.each_literal(visit)),
        }
    }
}

impl PredicateDefinition {
    /// The definition for the terms of a literal, which is to hold for some objects or for a number of them.
    fn applied(&self, literal: &Literal, number: Option<(Comparison, u32)>) -> Goal {
        let variables = literal.terms.iter().filter_map(variable).map(str::to_owned);
        let mut taken: Vec<String> = variables.collect();
        let mut ranges = Vec::new();
        let mut given = Vec::new();
        for (name, term) in self.variables.iter().zip(&literal.terms) {
            let class = match term {
                Term::Class(class) => Some(class.clone()),
                Term::Anything => None,
                term => {
                    given.push(term.clone());
                    continue;
                }
            };
            let name = fresh(name, &taken);
            given.push(Term::Variable(name.clone()));
            taken.push(name.clone());
            ranges.push((name, class));
        }
        let body = self.with_terms_of(&given, &taken);
        if ranges.is_empty() { counted(body, number) } else { ranged(body, ranges, number) }
    }

    /// The definition with its variables replaced. Those of its quantifiers get names that are not taken.
    fn with_terms_of(&self, given: &[Term], taken: &[String]) -> Goal {
        let place = |term: &Term| self.variables.iter().position(|name| variable(term) == Some(name));
        let put = |term: &Term| place(term).map_or_else(|| term.clone(), |place| given[place].clone());
        self.body.renamed(&self.new_names(taken)).with_terms(&put)
    }

    /// For the names of quantified variables that are taken, others that nothing has.
    fn new_names(&self, taken: &[String]) -> BTreeMap<String, String> {
        let mut bound = Vec::new();
        self.body.each_bound(&mut |name| bound.push(name.to_owned()));
        let mut avoided = [taken, &self.variables, &bound].concat();
        let mut names = BTreeMap::new();
        for name in bound.into_iter().filter(|name| taken.contains(name)) {
            names.entry(name).or_insert_with_key(|name| {
                avoided.push(fresh(name, &avoided));
                avoided[avoided.len() - 1].clone()
            });
        }
        names
    }
}

impl Goal {
    /// Visits the names of the variables that quantifiers bind.
    fn each_bound(&self, visit: &mut dyn FnMut(&str)) {
        match self {
            Self::ForAll(q) | Self::Exists(q) | Self::ForN { of: q, .. } => visit(&q.variable),
            Self::ForPairs(pairs) => [&pairs.first, &pairs.second].into_iter().for_each(|v| visit(&v.name)),
            _ => {}
        }
        self.parts().into_iter().for_each(|part| part.each_bound(visit));
    }

    /// The goal with other names for the variables that quantifiers bind.
    fn renamed(&self, names: &BTreeMap<String, String>) -> Self {
        let new = |name: &String| names.get(name).unwrap_or(name).clone();
        let of = |q: &Quantified| {
            let body = q.body.with_variable(&q.variable, &new(&q.variable)).renamed(names);
            Quantified { variable: new(&q.variable), class: q.class.clone(), body: Box::new(body) }
        };
        match self {
            Self::ForAll(q) => Self::ForAll(of(q)),
            Self::Exists(q) => Self::Exists(of(q)),
            Self::ForN { comparison, number, of: q } => {
                Self::ForN { comparison: *comparison, number: *number, of: of(q) }
            }
            Self::ForPairs(pairs) => {
                let mut pairs = pairs.clone();
                for variable in [&mut pairs.first, &mut pairs.second] {
                    pairs.body = Box::new(pairs.body.with_variable(&variable.name, &new(&variable.name)));
                    variable.name = new(&variable.name);
                }
                pairs.body = Box::new(pairs.body.renamed(names));
                Self::ForPairs(pairs)
            }
            _ => self.with_parts(&mut |part| part.renamed(names)),
        }
    }

    fn with_variable(&self, old: &str, new: &str) -> Self {
        self.with_terms(&|term| match variable(term) {
            Some(name) if name == old => Term::Variable(new.to_owned()),
            _ => term.clone(),
        })
    }
}

fn variable(term: &Term) -> Option<&str> {
    if let Term::Variable(name) = term { Some(name) } else { None }
}

/// A name, with a number after it if it is taken.
fn fresh(name: &str, taken: &[String]) -> String {
    let numbered = (1_usize..).map(|number| format!("{name}{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !taken.contains(name)).unwrap_or_default()
}

/// A goal about given objects that is to hold for a number of them: for one at most.
fn counted(goal: Goal, number: Option<(Comparison, u32)>) -> Goal {
    let admits = |found| number.is_none_or(|(comparison, number)| comparison.admits(found, number));
    match (admits(1), number.is_some() && admits(0)) {
        (true, false) => goal,
        (true, true) => Goal::And(Vec::new()),
        (false, true) => Goal::Not(Box::new(goal)),
        (false, false) => Goal::Or(Vec::new()),
    }
}

/// A goal that is to hold for some objects of the classes of its variables, or for a number of the first.
fn ranged(goal: Goal, ranges: Vec<(String, Option<String>)>, number: Option<(Comparison, u32)>) -> Goal {
    ranges.into_iter().enumerate().rev().fold(goal, |body, (place, (variable, class))| {
        let of = Quantified { variable, class, body: Box::new(body) };
        match number {
            Some((comparison, number)) if place == 0 => Goal::ForN { comparison, number, of },
            _ => Goal::Exists(of),
        }
    })
}
