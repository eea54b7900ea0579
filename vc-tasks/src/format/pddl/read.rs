//! Reading domains and problems.

use std::collections::BTreeSet;
use std::str::FromStr;

use super::parts::{amount, atom, changes, formula, number, one, signature, two, typed, word};
use super::{AtomicFormula, Domain, FORMAT, Formula, Metric, NumericLiteral, Operator, PlanningProblem, Signature};
use crate::format::ReadError;
use crate::format::sexpr::{Expr, SexprTree};

/// The name and the sections of `(define (kind name) ...)`.
fn sections<'t>(tree: &'t SexprTree, kind: &str) -> Result<(String, Vec<Expr<'t>>), ReadError> {
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

/// The names read so far, each of which may occur once.
#[derive(Default)]
struct Once<'t>(BTreeSet<(&'static str, &'t str)>);

impl<'t> Once<'t> {
    /// Records a name of some kind; an error if it is already recorded.
    fn note(&mut self, kind: &'static str, name: &'t str, at: Expr<'t>) -> Result<(), ReadError> {
        if self.0.insert((kind, name)) { Ok(()) } else { Err(at.error(format!("{kind} `{name}` only once"))) }
    }

    /// Records a section; all but actions may occur once.
    fn section(&mut self, at: Expr<'t>) -> Result<Option<&'t str>, ReadError> {
        match at.head() {
            Some(":action") | None => Ok(at.head()),
            Some(head) => self.note("a section", head, at).map(|()| Some(head)),
        }
    }

    /// Records all names of a typed list.
    fn names(&mut self, kind: &'static str, list: Expr<'t>) -> Result<(), ReadError> {
        let mut after_dash = false;
        for item in list.items().skip(1) {
            let is_type = std::mem::replace(&mut after_dash, item.word() == Some("-"));
            if let Some(name) = item.word().filter(|_| !is_type && !after_dash) {
                self.note(kind, name, item)?;
            }
        }
        Ok(())
    }

    fn heads(&mut self, kind: &'static str, list: Expr<'t>) -> Result<(), ReadError> {
        let signatures = list.items().skip(1).filter_map(|item| Some((item.head()?, item)));
        signatures.into_iter().try_for_each(|(name, item)| self.note(kind, name, item))
    }
}

impl FromStr for Domain {
    type Err = ReadError;

    fn from_str(text: &str) -> Result<Self, ReadError> {
        let tree = SexprTree::read(FORMAT, text)?;
        let (name, sections) = sections(&tree, "domain")?;
        let (mut domain, mut once) = (Self { name, ..Self::default() }, Once::default());
        for section in sections {
            let rest = || section.items().skip(1);
            match once.section(section)? {
                Some(":requirements") => domain.requirements = rest().map(word).collect::<Result<_, _>>()?,
                Some(":types") => {
                    once.names("the type", section)?;
                    domain.types = typed(rest())?;
                }
                Some(":constants") => {
                    once.names("the constant", section)?;
                    domain.constants = typed(rest())?;
                }
                Some(":predicates") => {
                    once.heads("the predicate", section)?;
                    domain.predicates = rest().map(signature).collect::<Result<_, _>>()?;
                }
                Some(":functions") => {
                    once.heads("the function", section)?;
                    domain.functions = functions(section)?;
                }
                Some(":action") => {
                    let name = section.items().nth(1).and_then(Expr::word).unwrap_or_default();
                    once.note("the action", name, section)?;
                    domain.operators.push(operator(section)?);
                }
                _ => {
                    let known = "`:requirements`, `:types`, `:constants`, `:predicates`, `:functions` or `:action`";
                    return Err(section.error(known));
                }
            }
        }
        Ok(domain)
    }
}

/// Functions; their type `number` may be omitted.
fn functions(section: Expr<'_>) -> Result<Vec<Signature>, ReadError> {
    let (mut found, mut items) = (Vec::new(), section.items().skip(1));
    while let Some(item) = items.next() {
        if item.word() != Some("-") {
            found.push(signature(item)?);
            continue;
        }
        match items.next() {
            Some(kind) if kind.word() == Some("number") => {}
            other => return Err(other.unwrap_or(item).error("`- number`: of functions costs are read")),
        }
    }
    Ok(found)
}

impl FromStr for PlanningProblem {
    type Err = ReadError;

    fn from_str(text: &str) -> Result<Self, ReadError> {
        let tree = SexprTree::read(FORMAT, text)?;
        let (name, sections) = sections(&tree, "problem")?;
        let (mut domain, mut objects, mut goal, mut metric) = (None, Vec::new(), None, None);
        let (mut start, mut once) = (Start::default(), Once::default());
        for section in sections {
            match once.section(section)? {
                Some(":domain") => domain = Some(word(one(section, "the domain's name")?)?),
                Some(":objects") => {
                    once.names("the object", section)?;
                    objects = typed(section.items().skip(1))?;
                }
                Some(":init") => section.items().skip(1).try_for_each(|fact| start.read(fact))?,
                Some(":goal") => goal = Some(formula(one(section, "a condition")?)?),
                Some(":metric") => metric = Some(measure(section)?),
                Some(":requirements") => {}
                _ => return Err(section.error("`:domain`, `:objects`, `:init`, `:goal` or `:metric`")),
            }
        }
        let missing = |what: &str| tree.root().error_at_end(what);
        let domain = domain.ok_or_else(|| missing("a `(:domain ...)`"))?;
        let goal = goal.ok_or_else(|| missing("a `(:goal ...)`"))?;
        let Start { initial, denied, values, .. } = start;
        Ok(Self { name, domain, objects, initial, denied, values, goal, metric })
    }
}

/// The facts and function values at the start.
#[derive(Default)]
struct Start {
    initial: Vec<AtomicFormula>,
    denied: Vec<AtomicFormula>,
    values: Vec<(AtomicFormula, NumericLiteral)>,
    /// The facts stated so far, and those denied.
    said: [BTreeSet<AtomicFormula>; 2],
}

impl Start {
    /// Reads a fact, a negated fact, or the value of a function.
    fn read(&mut self, fact: Expr<'_>) -> Result<(), ReadError> {
        let (denies, atom) = match fact.head() {
            Some("not") => (true, atom(one(fact, "a predicate of things")?)?),
            Some("=") => {
                let (function, worth) = two(fact)?;
                self.values.push((atom(function)?, number(worth)?));
                return Ok(());
            }
            _ => (false, atom(fact)?),
        };
        if self.said[usize::from(!denies)].contains(&atom) {
            return Err(fact.error("a fact that is not both said and denied"));
        }
        self.said[usize::from(denies)].insert(atom.clone());
        if denies {
            self.denied.push(atom)
        } else {
            self.initial.push(atom)
        }
        Ok(())
    }
}

/// `(:metric minimize (total-cost))`.
fn measure(section: Expr<'_>) -> Result<Metric, ReadError> {
    let (direction, of) = two(section)?;
    let maximize = match direction.word() {
        Some("minimize") => false,
        Some("maximize") => true,
        _ => return Err(direction.error("`minimize` or `maximize`")),
    };
    Ok(Metric { maximize, of: amount(of)? })
}

fn operator(at: Expr<'_>) -> Result<Operator, ReadError> {
    let name = at.items().nth(1).ok_or_else(|| at.error_at_end("the action's name"))?;
    let nothing = Formula::And(Vec::new());
    let (parameters, effect) = (Vec::new(), Vec::new());
    let mut operator = Operator { name: word(name)?, parameters, precondition: nothing, effect };
    let (mut once, mut items) = (Once::default(), at.items().skip(2));
    while let Some(key) = items.next() {
        let value = items.next().ok_or_else(|| at.error_at_end("what the key stands for"))?;
        once.note("the key", key.word().unwrap_or_default(), key)?;
        match key.word() {
            Some(":parameters") => operator.parameters = typed(value.items())?,
            Some(":precondition") => operator.precondition = formula(value)?,
            Some(":effect") => operator.effect = changes(value)?,
            _ => return Err(key.error("`:parameters`, `:precondition` or `:effect`")),
        }
    }
    Ok(operator)
}
