//! Conversion between the conditions of activities and goals.

use std::collections::HashMap;

use vc_graph::goal::{self, Comparison, Goal, Literal, Pairing, Pairs, Quantified, Term};
use vc_graph::{NodeId, Relation};

use super::predicate::word;
use super::{ActivityDefinition, AppliedPredicate, ConditionNode, FORMAT, Fact, TypedVariable, meaning};
use crate::format::sexpr::Expr;
use crate::format::{ReadError, Unwritable};

/// The objects of an activity as nodes: the first declared object is `#1`.
struct Names<'t> {
    nodes: HashMap<&'t str, (NodeId, &'t str)>,
    pairing: Pairing,
}

impl ActivityDefinition {
    /// The goal; pairs are one-to-one matchings.
    ///
    /// The first declared object is node 1, the next node 2. A scene has other numbers and classes:
    /// [`ActivityDefinition::bind`] gives the goal for a scene.
    ///
    /// ```
    /// use vc_tasks::format::bddl::ActivityDefinition;
    /// let text = "(define (problem p) (:objects a - cup t - table) (:goal (ontop a t)))";
    /// assert_eq!(ActivityDefinition::read(text)?.to_goal()?.to_string(), "On(cup.1, table.2)");
    /// # Ok::<(), vc_tasks::format::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// [`ReadError`] for an unknown predicate or object.
    pub fn to_goal(&self) -> Result<Goal, ReadError> {
        Ok(joined(self.to_heads(Pairing::Matching)?, Goal::And))
    }

    /// The goals of [`ActivityDefinition::heads`]. [`Pairing::Marginal`] evaluates pairs as the reference
    /// implementation does, [`Pairing::Matching`] as its documentation says: `fornpairs` then asks
    /// for exactly the given number.
    ///
    /// # Errors
    /// [`ReadError`] for an unknown predicate or object.
    pub(crate) fn to_heads(&self, pairing: Pairing) -> Result<Vec<Goal>, ReadError> {
        let names = Names::new(self, pairing);
        self.heads().into_iter().map(|head| names.goal(head, &mut Vec::new())).collect()
    }

    /// The initial facts: literals of nodes, and whether they hold. The rooms of objects are
    /// returned by [`ActivityDefinition::rooms`].
    ///
    /// # Errors
    /// [`ReadError`] for an unknown predicate or object.
    pub(crate) fn to_facts(&self) -> Result<Vec<(Literal, bool)>, ReadError> {
        let names = Names::new(self, Pairing::Matching);
        let facts = self.initial().filter(|f| f.atom.predicate != "inroom");
        facts.map(|f| Ok((names.literal(f.atom, f.at, &[])?, f.holds))).collect()
    }

    /// The objects with the kinds of rooms they are in.
    pub fn rooms(&self) -> impl Iterator<Item = (&str, &str)> {
        let rooms = self.initial().filter(|f| f.atom.predicate == "inroom");
        rooms.filter_map(|Fact { atom, .. }| Some((atom.first, atom.second?)))
    }
}

impl<'t> Names<'t> {
    fn new(activity: &'t ActivityDefinition, pairing: Pairing) -> Self {
        let mut nodes = HashMap::with_capacity(activity.objects.len());
        for (object, id) in activity.objects().zip(1..) {
            nodes.entry(object.name).or_insert((NodeId(id), object.class));
        }
        Self { nodes, pairing }
    }

    fn goal(&self, at: Expr<'t>, bound: &mut Vec<TypedVariable<'t>>) -> Result<Goal, ReadError> {
        let mut list = |parts: &mut dyn Iterator<Item = Expr<'t>>| {
            parts.map(|part| self.goal(part, bound)).collect::<Result<Vec<Goal>, ReadError>>()
        };
        Ok(match ConditionNode::new(at)? {
            ConditionNode::And(mut parts) => joined(list(&mut parts)?, Goal::And),
            ConditionNode::Or(mut parts) => joined(list(&mut parts)?, Goal::Or),
            ConditionNode::Not(part) => Goal::Not(Box::new(self.goal(part, bound)?)),
            ConditionNode::Imply(a, b) => Goal::Imply(Box::new(self.goal(a, bound)?), Box::new(self.goal(b, bound)?)),
            ConditionNode::ForAll(v, body) => Goal::ForAll(self.quantified(v, body, bound)?),
            ConditionNode::Exists(v, body) => Goal::Exists(self.quantified(v, body, bound)?),
            ConditionNode::ForN(number, v, body) => {
                let of = self.quantified(v, body, bound)?;
                Goal::ForN { comparison: Comparison::Exactly, number, of }
            }
            ConditionNode::Pairs(number, variables, body) => self.pairs(number, variables, body, bound)?,
            ConditionNode::Atom(atom) => Goal::Literal(self.literal(atom, at, bound)?),
        })
    }

    fn quantified(
        &self,
        variable: TypedVariable<'t>,
        body: Expr<'t>,
        bound: &mut Vec<TypedVariable<'t>>,
    ) -> Result<Quantified, ReadError> {
        bound.push(variable);
        let body = self.goal(body, bound);
        bound.pop();
        Ok(Quantified {
            variable: variable.name.to_owned(),
            class: Some(variable.class.to_owned()),
            body: Box::new(body?),
        })
    }

    fn pairs(
        &self,
        number: Option<u32>,
        [first, second]: [TypedVariable<'t>; 2],
        body: Expr<'t>,
        bound: &mut Vec<TypedVariable<'t>>,
    ) -> Result<Goal, ReadError> {
        bound.extend([first, second]);
        let body = self.goal(body, bound);
        bound.truncate(bound.len() - 2);
        let comparison = match self.pairing {
            Pairing::Marginal => Comparison::AtLeast,
            Pairing::Matching => Comparison::Exactly,
        };
        let named = |v: TypedVariable<'_>| goal::Variable { name: v.name.to_owned(), class: Some(v.class.to_owned()) };
        Ok(Goal::ForPairs(Pairs {
            first: named(first),
            second: named(second),
            number: number.map(|n| (comparison, n)),
            pairing: self.pairing,
            body: Box::new(body?),
        }))
    }

    fn literal(
        &self,
        atom: AppliedPredicate<'t>,
        at: Expr<'t>,
        bound: &[TypedVariable<'t>],
    ) -> Result<Literal, ReadError> {
        let predicate = meaning(atom.predicate).ok_or_else(|| at.error("a predicate of BEHAVIOR"))?;
        let terms = atom.things().map(|thing| self.term(thing, at, bound)).collect::<Result<Vec<Term>, _>>()?;
        match terms.len() == predicate.arity() {
            true => Ok(Literal { predicate, terms }),
            false => Err(at.error(format!("`{}` of {} things", atom.predicate, predicate.arity()))),
        }
    }

    fn term(&self, thing: &'t str, at: Expr<'t>, bound: &[TypedVariable<'t>]) -> Result<Term, ReadError> {
        if bound.iter().any(|v| v.name == thing) {
            return Ok(Term::Variable(thing.to_owned()));
        }
        let node = self.nodes.get(thing);
        let (id, class) = node.ok_or_else(|| at.error(format!("only objects that are declared, not `{thing}`")))?;
        Ok(Term::Node(Some((*class).to_owned()), *id))
    }
}

/// A list of one element is that element.
fn joined(mut parts: Vec<Goal>, list: fn(Vec<Goal>) -> Goal) -> Goal {
    if parts.len() == 1 { parts.remove(0) } else { list(parts) }
}

/// Writes a goal as a condition. `objects` are the names of the nodes; the first is that of node 1.
///
/// ```
/// use vc_tasks::format::bddl;
/// let goal = "forall ?p: plate. !Covered(?p, stain.2)".parse()?;
/// let text = bddl::condition(&goal, &["plate_1", "stain_1"])?;
/// assert_eq!(text, "(forall (?p - plate) (not (covered ?p ?stain_1)))");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Unwritable`] for parts that BDDL cannot express: classes without a quantifier, counts other
/// than `exactly`, executed actions, temporal operators, the agent itself.
pub fn condition(goal: &Goal, objects: &[&str]) -> Result<String, Unwritable> {
    Writer { objects }.goal(goal)
}

struct Writer<'o> {
    objects: &'o [&'o str],
}

impl Writer<'_> {
    fn goal(&self, goal: &Goal) -> Result<String, Unwritable> {
        let no = |why: &str| Err(Unwritable::new(FORMAT, goal, why));
        Ok(match goal {
            Goal::Literal(literal) => self.literal(literal)?,
            Goal::And(parts) => self.list("and", parts)?,
            Goal::Or(parts) => self.list("or", parts)?,
            Goal::Not(part) => format!("(not {})", self.goal(part)?),
            Goal::Imply(a, b) => format!("(imply {} {})", self.goal(a)?, self.goal(b)?),
            Goal::ForAll(q) => self.quantified("forall", q)?,
            Goal::Exists(q) => self.quantified("exists", q)?,
            Goal::ForN { comparison: Comparison::Exactly, number, of } => {
                self.quantified(&format!("forn ({number})"), of)?
            }
            Goal::ForPairs(pairs) => self.pairs(goal, pairs)?,
            Goal::ForN { .. } => return no("it counts exactly (`forn`) or not at all"),
            Goal::Count { .. } => return no("it counts with a quantifier (`forn`)"),
            Goal::Same(..) => return no("it does not compare things"),
            _ => return no("it knows no time"),
        })
    }

    fn list(&self, head: &str, parts: &[Goal]) -> Result<String, Unwritable> {
        let parts = parts.iter().map(|p| self.goal(p)).collect::<Result<Vec<_>, _>>()?;
        Ok(format!("({head}{}{})", if parts.is_empty() { "" } else { " " }, parts.join(" ")))
    }

    fn quantified(&self, head: &str, q: &Quantified) -> Result<String, Unwritable> {
        Ok(format!("({head} {} {})", variable(&q.variable, q.class.as_deref())?, self.goal(&q.body)?))
    }

    fn pairs(&self, goal: &Goal, pairs: &Pairs) -> Result<String, Unwritable> {
        let head = match (pairs.number, pairs.pairing) {
            (None, Pairing::Matching) => "forpairs".to_owned(),
            (Some((Comparison::Exactly, n)), Pairing::Matching) => format!("fornpairs ({n})"),
            _ => return Err(Unwritable::new(FORMAT, goal, "its pairs are as many as can be, or exactly so many")),
        };
        let [first, second] = [&pairs.first, &pairs.second].map(|v| variable(&v.name, v.class.as_deref()));
        Ok(format!("({head} {} {} {})", first?, second?, self.goal(&pairs.body)?))
    }

    fn literal(&self, literal: &Literal) -> Result<String, Unwritable> {
        // `meaning` decides which words mean the same there; the room relation is the exception.
        let known =
            word(literal.predicate).filter(|_| literal.predicate != goal::Predicate::Relation(Relation::InRoom));
        let word = known.ok_or_else(|| Unwritable::new(FORMAT, literal, "it has no such predicate"))?;
        let terms = literal.terms.iter().map(|t| self.term(t)).collect::<Result<Vec<_>, _>>()?;
        Ok(format!("({word} {})", terms.join(" ")))
    }

    fn term(&self, term: &Term) -> Result<String, Unwritable> {
        match term {
            Term::Variable(name) => Ok(format!("?{}", plain(name)?)),
            Term::Node(_, id) => {
                let name = (id.0 as usize).checked_sub(1).and_then(|i| self.objects.get(i));
                let name = name.ok_or_else(|| Unwritable::new(FORMAT, term, "no object is declared for the node"))?;
                Ok(format!("?{}", plain(name)?))
            }
            Term::Class(_) => Err(Unwritable::new(FORMAT, term, "some thing of a class takes an `exists`")),
            _ => Err(Unwritable::new(FORMAT, term, "every thing is an object or a variable")),
        }
    }
}

fn variable(name: &str, class: Option<&str>) -> Result<String, Unwritable> {
    let class = class.ok_or_else(|| Unwritable::new(FORMAT, format!("?{name}"), "variables have a class"))?;
    Ok(format!("(?{} - {})", plain(name)?, plain(class)?))
}

/// A name that reads back unchanged.
fn plain(name: &str) -> Result<&str, Unwritable> {
    let fits = |c: char| c > ' ' && !c.is_ascii_uppercase() && !"();".contains(c);
    let fine = !name.is_empty() && name != "-" && !name.starts_with('?') && name.chars().all(fits);
    if fine { Ok(name) } else { Err(Unwritable::new(FORMAT, name, "names have no capitals, spaces and brackets")) }
}
