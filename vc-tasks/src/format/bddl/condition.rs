//! Conditions, parsed one level at a time.

use crate::format::ReadError;
use crate::format::sexpr::{Expr, Items};

/// A predicate with one or two arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct AppliedPredicate<'t> {
    /// The predicate, `ontop`.
    pub predicate: &'t str,
    /// The first argument.
    pub first: &'t str,
    /// The second argument, for predicates that take two.
    pub second: Option<&'t str>,
}

/// A variable with the class it ranges over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TypedVariable<'t> {
    /// Its name, without `?`.
    pub(crate) name: &'t str,
    /// The class.
    pub(crate) class: &'t str,
}

/// One level of a condition.
#[derive(Clone)]
pub(crate) enum ConditionNode<'t> {
    /// All conditions hold.
    And(Items<'t>),
    /// Some condition holds.
    Or(Items<'t>),
    /// The condition does not hold.
    Not(Expr<'t>),
    /// The second holds if the first does.
    Imply(Expr<'t>, Expr<'t>),
    /// The condition holds for every value.
    ForAll(TypedVariable<'t>, Expr<'t>),
    /// The condition holds for some value.
    Exists(TypedVariable<'t>, Expr<'t>),
    /// The condition holds for exactly this many values.
    ForN(u32, TypedVariable<'t>, Expr<'t>),
    /// The condition holds for pairs of values: for this many, or as many as possible.
    Pairs(Option<u32>, [TypedVariable<'t>; 2], Expr<'t>),
    /// A predicate of objects or variables.
    Atom(AppliedPredicate<'t>),
}

/// The single argument of a list.
pub(super) fn only(list: Expr<'_>) -> Result<Expr<'_>, ReadError> {
    let mut items = list.items().skip(1);
    let one = items.next().ok_or_else(|| list.error_at_end("a condition"))?;
    items.next().map_or(Ok(one), |extra| Err(extra.error("`)`")))
}

impl<'t> AppliedPredicate<'t> {
    pub(super) fn from_expr(at: Expr<'t>) -> Result<Self, ReadError> {
        let mut items = at.items();
        let predicate = items.next().and_then(Expr::word).ok_or_else(|| at.error("a predicate of things"))?;
        if is_keyword(predicate) {
            return Err(at.error("a predicate of things"));
        }
        let thing = |item: Expr<'t>| {
            let word = item.word().ok_or_else(|| item.error("an object or a variable"))?;
            Ok(word.trim_start_matches('?'))
        };
        let first = items.next().ok_or_else(|| at.error_at_end("an object or a variable"))?;
        let (first, second) = (thing(first)?, items.next().map(thing).transpose()?);
        items.next().map_or(Ok(Self { predicate, first, second }), |extra| Err(extra.error("`)`")))
    }

    /// The arguments.
    pub fn things(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        [Some(self.first), self.second].into_iter().flatten()
    }
}

impl<'t> TypedVariable<'t> {
    /// `(?cup.n.01 - cup.n.01)`.
    fn new(at: Expr<'t>) -> Result<Self, ReadError> {
        let expected = "a variable and its class, `(?x - class)`";
        let mut words = at.items().map(Expr::word);
        match (words.next(), words.next(), words.next(), words.next()) {
            (Some(Some(name)), Some(Some("-")), Some(Some(class)), None) => {
                Ok(Self { name: name.trim_start_matches('?'), class })
            }
            _ => Err(at.error(expected)),
        }
    }
}

/// Whether a word forms a condition from other conditions.
fn is_keyword(word: &str) -> bool {
    matches!(word, "and" | "or" | "not" | "imply" | "forall" | "exists" | "forn" | "forpairs" | "fornpairs")
}

impl<'t> ConditionNode<'t> {
    /// Splits one level off a condition.
    ///
    /// # Errors
    /// [`ReadError`] if it is not a condition; never for the conditions of
    /// [`ActivityDefinition::goal`](super::ActivityDefinition::goal).
    pub(crate) fn new(at: Expr<'t>) -> Result<Self, ReadError> {
        let mut rest = at.items();
        let Some(head) = rest.next().and_then(Expr::word) else {
            return Err(at.error("a condition"));
        };
        if !is_keyword(head) {
            return AppliedPredicate::from_expr(at).map(Self::Atom);
        }
        let all = rest.clone();
        let mut next = |expected: &str| rest.next().ok_or_else(|| at.error_at_end(expected));
        let part = match head {
            "and" => return Ok(Self::And(all)),
            "or" => return Ok(Self::Or(all)),
            "not" => Self::Not(next("a condition")?),
            "imply" => Self::Imply(next("a condition")?, next("a condition")?),
            "forall" => Self::ForAll(TypedVariable::new(next(VARIABLE)?)?, next("a condition")?),
            "exists" => Self::Exists(TypedVariable::new(next(VARIABLE)?)?, next("a condition")?),
            "forn" => Self::ForN(number(next(NUMBER)?)?, TypedVariable::new(next(VARIABLE)?)?, next("a condition")?),
            counted => {
                let number = if counted == "fornpairs" { Some(number(next(NUMBER)?)?) } else { None };
                let variables = [TypedVariable::new(next(VARIABLE)?)?, TypedVariable::new(next(VARIABLE)?)?];
                Self::Pairs(number, variables, next("a condition")?)
            }
        };
        rest.next().map_or(Ok(part), |extra| Err(extra.error("`)`")))
    }

    /// The conditions that it consists of.
    pub(crate) fn conditions(&self) -> Vec<Expr<'t>> {
        match self {
            Self::And(parts) | Self::Or(parts) => parts.clone().collect(),
            Self::Not(body) | Self::ForAll(_, body) | Self::Exists(_, body) => vec![*body],
            Self::ForN(_, _, body) | Self::Pairs(_, _, body) => vec![*body],
            Self::Imply(first, second) => vec![*first, *second],
            Self::Atom(_) => Vec::new(),
        }
    }

    /// The variables it binds.
    pub(crate) fn variables(&self) -> &[TypedVariable<'t>] {
        match self {
            Self::ForAll(variable, _) | Self::Exists(variable, _) | Self::ForN(_, variable, _) => {
                std::slice::from_ref(variable)
            }
            Self::Pairs(_, variables, _) => variables,
            _ => &[],
        }
    }
}

const VARIABLE: &str = "a variable and its class, `(?x - class)`";
const NUMBER: &str = "a number in brackets, `(2)`";

/// `(2)`.
fn number(at: Expr<'_>) -> Result<u32, ReadError> {
    let mut items = at.items();
    let number = items.next().and_then(Expr::word).and_then(|w| w.parse().ok());
    number.filter(|_| items.next().is_none()).ok_or_else(|| at.error(NUMBER))
}

/// Checks a condition at all levels. Nesting is bounded by that of the tree.
pub(super) fn check(condition: Expr<'_>) -> Result<(), ReadError> {
    match ConditionNode::new(condition)? {
        ConditionNode::And(mut parts) | ConditionNode::Or(mut parts) => parts.try_for_each(check),
        ConditionNode::Imply(first, second) => check(first).and_then(|()| check(second)),
        ConditionNode::Not(body) | ConditionNode::ForAll(_, body) | ConditionNode::Exists(_, body) => check(body),
        ConditionNode::ForN(_, _, body) | ConditionNode::Pairs(_, _, body) => check(body),
        ConditionNode::Atom(_) => Ok(()),
    }
}
