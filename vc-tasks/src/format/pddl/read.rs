//! Reading domains and problems.

use std::str::FromStr;

use super::{Atom, Change, Domain, FORMAT, Formula, Operator, Problem, Signature, Typed};
use crate::format::ReadError;
use crate::format::sexpr::{Expr, Tree};

/// The sections of `(define (kind name) ...)`, and the name.
fn sections<'t>(tree: &'t Tree, kind: &str) -> Result<(String, Vec<Expr<'t>>), ReadError> {
    let root = tree.root();
    let mut items = root.items();
    match items.next() {
        Some(first) if first.word() == Some("define") => {}
        first => return Err(first.unwrap_or(root).error("`(define ...`")),
    }
    let title = items.next().ok_or_else(|| root.error_at_end(format!("`({kind} name)`")))?;
    let words: Vec<&str> = title.items().filter_map(Expr::word).collect();
    match *words {
        [head, name] if head == kind => Ok((name.to_owned(), items.collect())),
        _ => Err(title.error(format!("`({kind} name)`"))),
    }
}

impl FromStr for Domain {
    type Err = ReadError;

    fn from_str(text: &str) -> Result<Self, ReadError> {
        let tree = Tree::read(FORMAT, text)?;
        let (name, sections) = sections(&tree, "domain")?;
        let mut domain = Self { name, ..Self::default() };
        for section in sections {
            let rest = || section.items().skip(1);
            match section.head() {
                Some(":requirements") => domain.requirements = rest().map(word).collect::<Result<_, _>>()?,
                Some(":types") => domain.types = typed(rest())?,
                Some(":constants") => domain.constants = typed(rest())?,
                Some(":predicates") => domain.predicates = rest().map(signature).collect::<Result<_, _>>()?,
                Some(":action") => domain.operators.push(operator(section)?),
                _ => {
                    let known = "`:requirements`, `:types`, `:constants`, `:predicates` or `:action`";
                    return Err(section.error(known));
                }
            }
        }
        Ok(domain)
    }
}

impl FromStr for Problem {
    type Err = ReadError;

    fn from_str(text: &str) -> Result<Self, ReadError> {
        let tree = Tree::read(FORMAT, text)?;
        let (name, sections) = sections(&tree, "problem")?;
        let (mut domain, mut objects, mut initial, mut goal) = (None, Vec::new(), Vec::new(), None);
        for section in sections {
            let rest = || section.items().skip(1);
            match section.head() {
                Some(":domain") => domain = Some(word(first(section, "the domain's name")?)?),
                Some(":objects") => objects = typed(rest())?,
                Some(":init") => initial = rest().map(atom).collect::<Result<_, _>>()?,
                Some(":goal") => goal = Some(formula(first(section, "a condition")?)?),
                Some(":requirements") => {}
                _ => return Err(section.error("`:domain`, `:objects`, `:init` or `:goal`")),
            }
        }
        let missing = |what: &str| tree.root().error_at_end(what);
        let domain = domain.ok_or_else(|| missing("a `(:domain ...)`"))?;
        let goal = goal.ok_or_else(|| missing("a `(:goal ...)`"))?;
        Ok(Self { name, domain, objects, initial, goal })
    }
}

fn word(at: Expr<'_>) -> Result<String, ReadError> {
    at.word().map(str::to_owned).ok_or_else(|| at.error("a name"))
}

/// The first thing after a list's head.
fn first<'t>(list: Expr<'t>, expected: &str) -> Result<Expr<'t>, ReadError> {
    list.items().nth(1).ok_or_else(|| list.error_at_end(expected))
}

/// `a b - kind c`.
fn typed<'t>(mut items: impl Iterator<Item = Expr<'t>>) -> Result<Vec<Typed>, ReadError> {
    let (mut found, mut untyped): (Vec<Typed>, usize) = (Vec::new(), 0);
    while let Some(item) = items.next() {
        if item.word() != Some("-") {
            found.push(Typed::new(word(item)?, "object"));
            continue;
        }
        let kind = items.next().ok_or_else(|| item.error("a type after the `-`, and before it a name"))?;
        let kind = word(kind)?;
        found[untyped..].iter_mut().for_each(|t| t.kind.clone_from(&kind));
        untyped = found.len();
    }
    Ok(found)
}

fn signature(at: Expr<'_>) -> Result<Signature, ReadError> {
    let name = at.head().ok_or_else(|| at.error("a predicate, `(name ?x ?y)`"))?;
    Ok(Signature { name: name.to_owned(), parameters: typed(at.items().skip(1))? })
}

fn atom(at: Expr<'_>) -> Result<Atom, ReadError> {
    let predicate = at.head().ok_or_else(|| at.error("a predicate of things, `(name a b)`"))?;
    let arguments = at.items().skip(1).map(word).collect::<Result<_, _>>()?;
    Ok(Atom { predicate: predicate.to_owned(), arguments })
}

/// The two things a list takes after its head.
fn two(at: Expr<'_>) -> Result<(Expr<'_>, Expr<'_>), ReadError> {
    let mut items = at.items().skip(1);
    match (items.next(), items.next(), items.next()) {
        (Some(a), Some(b), None) => Ok((a, b)),
        (_, _, Some(extra)) => Err(extra.error("`)`")),
        _ => Err(at.error_at_end("two parts")),
    }
}

fn formula(at: Expr<'_>) -> Result<Formula, ReadError> {
    let parts = || at.items().skip(1).map(formula).collect::<Result<Vec<Formula>, ReadError>>();
    Ok(match at.head() {
        Some("and") => Formula::And(parts()?),
        Some("or") => Formula::Or(parts()?),
        Some("not") => Formula::Not(Box::new(formula(first(at, "a condition")?)?)),
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

fn changes(at: Expr<'_>) -> Result<Vec<Change>, ReadError> {
    match at.head() {
        Some("and") => {
            let parts = at.items().skip(1).map(changes).collect::<Result<Vec<_>, _>>()?;
            Ok(parts.into_iter().flatten().collect())
        }
        Some("not") => Ok(vec![Change::Delete(atom(first(at, "a predicate of things")?)?)]),
        Some("forall") => {
            let (variables, body) = two(at)?;
            Ok(vec![Change::ForAll(typed(variables.items())?, changes(body)?)])
        }
        Some("when") => {
            let (condition, body) = two(at)?;
            Ok(vec![Change::When(formula(condition)?, changes(body)?)])
        }
        Some("increase" | "decrease" | "assign") => Err(at.error("an effect without numbers")),
        None if at.is_list() && at.items().next().is_none() => Ok(Vec::new()),
        _ => Ok(vec![Change::Add(atom(at)?)]),
    }
}

fn operator(at: Expr<'_>) -> Result<Operator, ReadError> {
    let name = word(first(at, "the action's name")?)?;
    let nothing = Formula::And(Vec::new());
    let mut operator = Operator { name, parameters: Vec::new(), precondition: nothing, effect: Vec::new() };
    let mut items = at.items().skip(2);
    while let Some(key) = items.next() {
        let value = items.next().ok_or_else(|| at.error_at_end("what the key stands for"))?;
        match key.word() {
            Some(":parameters") => operator.parameters = typed(value.items())?,
            Some(":precondition") => operator.precondition = formula(value)?,
            Some(":effect") => operator.effect = changes(value)?,
            _ => return Err(key.error("`:parameters`, `:precondition` or `:effect`")),
        }
    }
    Ok(operator)
}
