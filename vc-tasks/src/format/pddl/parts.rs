//! The parts of domains and problems.

use super::{
    AtomicFormula, Formula, NumericExpression, NumericLiteral, OperatorEffect, Signature, TypeUnion, TypedName,
};
use crate::format::ReadError;
use crate::format::sexpr::Expr;

pub(super) fn word(at: Expr<'_>) -> Result<String, ReadError> {
    at.word().map(str::to_owned).ok_or_else(|| at.error("a name"))
}

/// The single argument of a list.
pub(super) fn one<'t>(list: Expr<'t>, expected: &str) -> Result<Expr<'t>, ReadError> {
    let mut items = list.items().skip(1);
    match (items.next(), items.next()) {
        (Some(only), None) => Ok(only),
        (_, Some(extra)) => Err(extra.error(format!("`)` after {expected}; `and` joins several"))),
        _ => Err(list.error_at_end(expected)),
    }
}

/// `a b - kind c`.
pub(super) fn typed<'t>(mut items: impl Iterator<Item = Expr<'t>>) -> Result<Vec<TypedName>, ReadError> {
    let (mut found, mut untyped): (Vec<TypedName>, usize) = (Vec::new(), 0);
    while let Some(item) = items.next() {
        if item.word() != Some("-") {
            found.push(TypedName::new(word(item)?, "object"));
            continue;
        }
        let kind = items.next().ok_or_else(|| item.error("a type after the `-`, and before it a name"))?;
        let kind = kind_of(kind)?;
        found[untyped..].iter_mut().for_each(|t| t.kind.clone_from(&kind));
        untyped = found.len();
    }
    Ok(found)
}

/// `cup` or `(either cup plate)`.
fn kind_of(at: Expr<'_>) -> Result<TypeUnion, ReadError> {
    let any = match at.head() {
        Some("either") => at.items().skip(1).map(word).collect::<Result<Vec<_>, _>>()?,
        _ => vec![word(at)?],
    };
    if any.is_empty() { Err(at.error_at_end("a type")) } else { Ok(TypeUnion { any }) }
}

pub(super) fn signature(at: Expr<'_>) -> Result<Signature, ReadError> {
    let name = at.head().ok_or_else(|| at.error("a predicate, `(name ?x ?y)`"))?;
    Ok(Signature { name: name.to_owned(), parameters: typed(at.items().skip(1))? })
}

pub(super) fn atom(at: Expr<'_>) -> Result<AtomicFormula, ReadError> {
    let predicate = at.head().ok_or_else(|| at.error("a predicate of things, `(name a b)`"))?;
    let arguments = at.items().skip(1).map(word).collect::<Result<_, _>>()?;
    Ok(AtomicFormula { predicate: predicate.to_owned(), arguments })
}

/// The two arguments of a list.
pub(super) fn two(at: Expr<'_>) -> Result<(Expr<'_>, Expr<'_>), ReadError> {
    let mut items = at.items().skip(1);
    match (items.next(), items.next(), items.next()) {
        (Some(a), Some(b), None) => Ok((a, b)),
        (_, _, Some(extra)) => Err(extra.error("`)`")),
        _ => Err(at.error_at_end("two parts")),
    }
}

pub(super) fn formula(at: Expr<'_>) -> Result<Formula, ReadError> {
    let parts = || at.items().skip(1).map(formula).collect::<Result<Vec<Formula>, ReadError>>();
    Ok(match at.head() {
        Some("and") => Formula::And(parts()?),
        Some("or") => Formula::Or(parts()?),
        Some("not") => Formula::Not(Box::new(formula(one(at, "a condition")?)?)),
        Some("imply") => {
            let (a, b) = two(at)?;
            Formula::Imply(Box::new(formula(a)?), Box::new(formula(b)?))
        }
        Some(head @ ("forall" | "exists")) => {
            let (variables, body) = two(at)?;
            let (variables, body) = (typed(variables.items())?, Box::new(formula(body)?));
            if head == "forall" { Formula::ForAll(variables, body) } else { Formula::Exists(variables, body) }
        }
        Some("=") => {
            let (a, b) = two(at)?;
            Formula::Equal(word(a)?, word(b)?)
        }
        // `()` is the condition that always holds.
        None if at.is_list() && at.items().next().is_none() => Formula::And(Vec::new()),
        _ => Formula::Atom(atom(at)?),
    })
}

pub(super) fn changes(at: Expr<'_>) -> Result<Vec<OperatorEffect>, ReadError> {
    match at.head() {
        Some("and") => {
            let parts = at.items().skip(1).map(changes).collect::<Result<Vec<_>, _>>()?;
            Ok(parts.into_iter().flatten().collect())
        }
        Some("not") => Ok(vec![OperatorEffect::Delete(atom(one(at, "a predicate of things")?)?)]),
        Some("forall") => {
            let (variables, body) = two(at)?;
            Ok(vec![OperatorEffect::ForAll(typed(variables.items())?, changes(body)?)])
        }
        Some("when") => {
            let (condition, body) = two(at)?;
            Ok(vec![OperatorEffect::When(formula(condition)?, changes(body)?)])
        }
        Some("increase") => {
            let (function, by) = two(at)?;
            Ok(vec![OperatorEffect::Increase(atom(function)?, amount(by)?)])
        }
        Some("decrease" | "assign" | "scale-up" | "scale-down") => Err(at.error("`increase`: numbers are costs")),
        None if at.is_list() && at.items().next().is_none() => Ok(Vec::new()),
        _ => Ok(vec![OperatorEffect::Add(atom(at)?)]),
    }
}

pub(super) fn number(at: Expr<'_>) -> Result<NumericLiteral, ReadError> {
    at.word().and_then(NumericLiteral::new).ok_or_else(|| at.error("a number"))
}

/// A number, or a function of objects.
pub(super) fn amount(at: Expr<'_>) -> Result<NumericExpression, ReadError> {
    if !at.is_list() {
        return number(at).map(NumericExpression::Number);
    }
    match at.head() {
        Some("+" | "-" | "*" | "/") => Err(at.error("a number or one function, not a sum")),
        _ => atom(at).map(NumericExpression::Of),
    }
}
