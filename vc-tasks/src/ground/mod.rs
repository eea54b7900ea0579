//! Goals as formulas over the things there are.

mod formula;
mod solve;

pub(crate) use formula::Formula;
use formula::{Gate, Number, Wire};
pub(crate) use solve::satisfiable;
use vc_graph::goal::{Comparison, Goal, Literal, Pairs, Predicate, Quantified, Term};
use vc_graph::{NodeId, State};

/// Which things there are.
pub(crate) trait Things {
    /// Those of a class; all, if none is named. `None` if that is not known.
    fn of_class(&self, class: Option<&str>) -> Option<Vec<NodeId>>;
}

/// Makes a formula of goals that must all hold. States that exclude each other are
/// known to. `None` where that takes time into account, things that are not known,
/// or more than [`LARGEST`] parts.
pub(crate) fn formula(goals: &[Goal], things: &impl Things) -> Option<Formula> {
    let mut ground = Ground { things, formula: Formula::default(), bound: Vec::new(), left: LARGEST };
    let mut parts = goals.iter().map(|g| ground.goal(g)).collect::<Option<Vec<Wire>>>()?;
    let Ground { mut formula, .. } = ground;
    let heads = parts.clone();
    parts.extend(exclusions(&mut formula));
    let root = formula.wire(Gate::All(parts));
    formula.finish(root, heads);
    Some(formula)
}

/// Most parts, counted for every choice of things: BEHAVIOR's largest goal has some
/// hundred.
const LARGEST: usize = 100_000;

fn exclusions(formula: &mut Formula) -> Vec<Wire> {
    let atoms: Vec<(Wire, Literal)> = formula.atoms().map(|(w, l)| (w, l.clone())).collect();
    let mut both = Vec::new();
    let mut states: Vec<&(Wire, Literal)> =
        atoms.iter().filter(|(_, l)| matches!(l.predicate, Predicate::State(_))).collect();
    states.sort_by_key(|(wire, l)| (l.terms.first().map(node), *wire));
    for same_thing in states.chunk_by(|(_, a), (_, b)| a.terms == b.terms) {
        for (i, (a, x)) in same_thing.iter().enumerate() {
            let others = same_thing[i + 1..].iter().filter(|(_, y)| exclude(x, y));
            both.extend(others.map(|(b, _)| [*a, *b]));
        }
    }
    let apart = |pair: [Wire; 2]| {
        let both = formula.wire(Gate::All(pair.to_vec()));
        formula.wire(Gate::Not(both))
    };
    both.into_iter().map(apart).collect()
}

/// Whether things said of the same things exclude each other.
fn exclude(a: &Literal, b: &Literal) -> bool {
    match (a.predicate, b.predicate) {
        (Predicate::State(x), Predicate::State(y)) => a.terms == b.terms && x.opposites().contains(y),
        _ => false,
    }
}

fn node(term: &Term) -> Option<NodeId> {
    if let Term::Node(_, id) = term { Some(*id) } else { None }
}

struct Ground<'g, T> {
    things: &'g T,
    formula: Formula,
    bound: Vec<(&'g str, NodeId)>,
    /// How many parts may still be looked at.
    left: usize,
}

impl<'g, T: Things> Ground<'g, T> {
    fn goal(&mut self, goal: &'g Goal) -> Option<Wire> {
        self.left = self.left.checked_sub(1)?;
        let gate = match goal {
            Goal::Literal(literal) => return self.literal(literal, None),
            Goal::Count { literal, comparison, number } => {
                return self.literal(literal, Some(Number { comparison: *comparison, number: *number }));
            }
            Goal::Same(a, b) => self.constant(self.meant(a)? == self.meant(b)?),
            Goal::And(parts) => Gate::All(self.list(parts)?),
            Goal::Or(parts) => Gate::Any(self.list(parts)?),
            Goal::Not(part) => Gate::Not(self.goal(part)?),
            Goal::Imply(a, b) => {
                let a = self.goal(a)?;
                Gate::Any(vec![self.formula.wire(Gate::Not(a)), self.goal(b)?])
            }
            Goal::ForAll(q) => Gate::All(self.each(q)?),
            Goal::Exists(q) => Gate::Any(self.each(q)?),
            Goal::ForN { comparison, number, of } => {
                Gate::Count(self.each(of)?, Number { comparison: *comparison, number: *number })
            }
            Goal::ForPairs(pairs) => self.pairs(pairs)?,
            _ => return None,
        };
        Some(self.formula.wire(gate))
    }

    fn constant(&self, value: bool) -> Gate {
        if value { Gate::All(Vec::new()) } else { Gate::Any(Vec::new()) }
    }

    fn list(&mut self, parts: &'g [Goal]) -> Option<Vec<Wire>> {
        parts.iter().map(|p| self.goal(p)).collect()
    }

    fn with(&mut self, variable: &'g str, id: NodeId, body: &'g Goal) -> Option<Wire> {
        self.bound.push((variable, id));
        let wire = self.goal(body);
        self.bound.pop();
        wire
    }

    fn each(&mut self, q: &'g Quantified) -> Option<Vec<Wire>> {
        let things = self.things.of_class(q.class.as_deref())?;
        things.into_iter().map(|id| self.with(&q.variable, id, &q.body)).collect()
    }

    fn pairs(&mut self, pairs: &'g Pairs) -> Option<Gate> {
        let of = |class: &Option<String>| self.things.of_class(class.as_deref());
        let (firsts, seconds) = (of(&pairs.first.class)?, of(&pairs.second.class)?);
        let mut rows = Vec::with_capacity(firsts.len());
        for &first in &firsts {
            let mut row = Vec::with_capacity(seconds.len());
            for (column, &second) in seconds.iter().enumerate().filter(|(_, s)| **s != first) {
                self.bound.push((&pairs.first.name, first));
                let wire = self.with(&pairs.second.name, second, &pairs.body);
                self.bound.pop();
                row.push((column, wire?));
            }
            rows.push(row);
        }
        let (comparison, number) =
            pairs.number.unwrap_or((Comparison::AtLeast, firsts.len().min(seconds.len()) as u32));
        let number = Number { comparison, number };
        Some(Gate::Pairs { rows, columns: seconds.len(), number, pairing: pairs.pairing })
    }

    fn meant(&self, term: &Term) -> Option<Option<NodeId>> {
        match term {
            Term::Variable(name) => self.bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| Some(id)),
            Term::Node(_, id) => Some(Some(*id)),
            Term::Me => Some(None),
            Term::Class(_) | Term::Anything => None,
        }
    }

    /// A literal: some of the things in its open places, or so many in the first.
    fn literal(&mut self, literal: &'g Literal, number: Option<Number>) -> Option<Wire> {
        let counted = literal.counted();
        let lists = literal.terms.iter().map(|t| self.choices(t)).collect::<Option<Vec<_>>>()?;
        let first = counted.unwrap_or(0);
        let one_of_first = |this: &mut Self, thing: Option<Term>| {
            let mut choices = lists.clone();
            if let (Some(place), Some(thing)) = (choices.get_mut(first), thing) {
                *place = vec![thing];
            }
            let choices = combined(&choices);
            this.left = this.left.checked_sub(choices.len())?;
            let atoms: Vec<Wire> = choices.into_iter().map(|terms| this.atom(literal.predicate, terms)).collect();
            Some(if atoms.len() == 1 { atoms[0] } else { this.formula.wire(Gate::Any(atoms)) })
        };
        let things: Vec<Option<Term>> = match lists.get(first) {
            Some(things) => things.iter().cloned().map(Some).collect(),
            None => vec![None],
        };
        let wires = things.into_iter().map(|t| one_of_first(self, t)).collect::<Option<Vec<Wire>>>()?;
        Some(match number {
            Some(number) => self.formula.wire(Gate::Count(wires, number)),
            None if wires.len() == 1 => wires[0],
            None => self.formula.wire(Gate::Any(wires)),
        })
    }

    /// What a term can stand for, each without the name of its class.
    fn choices(&self, term: &Term) -> Option<Vec<Term>> {
        let nodes = |ids: Vec<NodeId>| ids.into_iter().map(|id| Term::Node(None, id)).collect();
        match term {
            Term::Class(class) => self.things.of_class(Some(class)).map(nodes),
            Term::Anything => self.things.of_class(None).map(nodes),
            Term::Me => Some(vec![Term::Me]),
            _ => self.meant(term)?.map(|id| nodes(vec![id])),
        }
    }

    fn atom(&mut self, predicate: Predicate, terms: Vec<Term>) -> Wire {
        // What is real is what is not still to come.
        if predicate == Predicate::Real {
            let future = self.atom(Predicate::State(State::Future), terms);
            return self.formula.wire(Gate::Not(future));
        }
        self.formula.wire(Gate::Atom(Literal { predicate, terms }))
    }
}

/// One of each list, in all ways.
fn combined(lists: &[Vec<Term>]) -> Vec<Vec<Term>> {
    lists.iter().fold(vec![Vec::new()], |all, list| {
        let extend = |one: &Vec<Term>| {
            list.iter().map(|t| one.iter().cloned().chain([t.clone()]).collect()).collect::<Vec<Vec<Term>>>()
        };
        all.iter().flat_map(extend).collect()
    })
}
