//! Activities of BEHAVIOR in BDDL.
//!
//! ```
//! use vc_tasks::format::bddl::ActivityDefinition;
//! let text = "(define (problem tea-0) (:domain omnigibson)
//!     (:objects cup.n.01_1 cup.n.01_2 - cup.n.01  table.n.02_1 - table.n.02)
//!     (:init (inside cup.n.01_1 sink.n.01_1) (inroom table.n.02_1 kitchen))
//!     (:goal (and (forall (?cup.n.01 - cup.n.01) (ontop ?cup.n.01 ?table.n.02_1)))))";
//! let activity = ActivityDefinition::read(text)?;
//! assert_eq!((activity.name(), activity.objects().count()), ("tea-0", 3));
//! assert_eq!(ActivityDefinition::read(&activity.to_string())?, activity);
//! # Ok::<(), vc_tasks::format::ReadError>(())
//! ```
//!
//! Conditions are `and`, `or`, `not`, `imply a b`, `forall (?v - class) c`,
//! `exists (?v - class) c`, `forn (N) (?v - class) c`,
//! `forpairs (?v - class) (?w - class) c`, `fornpairs (N) (?v - class) (?w - class) c`
//! and atoms with one or two arguments. A `?` before a name is allowed and has no meaning.
//!
//! [`ActivityDefinition::to_goal`] numbers the declared objects; [`ActivityDefinition::bind`] finds things of a scene for
//! them, so that the goal can be pursued and judged there.

mod bind;
mod condition;
mod facts;
mod goal;
mod predicate;

use std::fmt;

use super::ReadError;
use super::sexpr::{Expr, SexprTree};
pub use bind::{BindError, Bound};
pub use condition::AppliedPredicate;
pub(crate) use condition::{ConditionNode, TypedVariable};
use condition::{check, only};
pub use facts::{Facts, Objects};
pub use goal::condition;
pub(crate) use predicate::DOMAINS;
pub use predicate::meaning;

/// The format's name in errors.
pub(crate) const FORMAT: &str = "BDDL";

/// A household activity: its objects, the initial facts and the goal.
///
/// Two activities are equal if their names, domains, objects, initial facts and goals read the
/// same.
#[derive(Debug, Clone)]
pub struct ActivityDefinition {
    tree: SexprTree,
    name: Option<u32>,
    domain: Option<u32>,
    objects: Vec<Declared>,
    initial: Vec<u32>,
    goal: u32,
    strays: Vec<u32>,
}

/// The indices of an object's name and of its class in the tree; an object without a class has the
/// class `object`.
#[derive(Debug, Clone, Copy)]
struct Declared {
    name: u32,
    class: Option<u32>,
}

/// An object of an activity.
#[derive(Debug, Clone, Copy)]
pub struct DeclaredObject<'t> {
    /// Its name, `cup.n.01_1`.
    pub name: &'t str,
    /// Its class, `cup.n.01`.
    pub class: &'t str,
    /// The place of its declaration.
    pub at: Expr<'t>,
}

/// A fact that holds at the start, or does not.
#[derive(Debug, Clone, Copy)]
pub struct Fact<'t> {
    /// Whether it holds.
    pub holds: bool,
    /// The predicate and its arguments.
    pub atom: AppliedPredicate<'t>,
    /// Its place in the text.
    pub at: Expr<'t>,
}

impl ActivityDefinition {
    /// Reads an activity. Costs 3 to 5 ns a byte.
    ///
    /// # Errors
    /// [`ReadError`] with the place and what was expected there.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        let tree = SexprTree::read(FORMAT, text)?;
        let mut found = Sections::default();
        let root = tree.root();
        let mut items = root.items();
        match items.next() {
            Some(first) if first.word() == Some("define") => {}
            first => return Err(first.unwrap_or(root).error("`(define ...`")),
        }
        items.try_for_each(|section| found.take(section))?;
        let goal = found.goal.ok_or_else(|| root.error_at_end("a `(:goal ...)`"))?;
        let Sections { name, domain, objects, initial, strays, .. } = found;
        Ok(Self { name, domain, objects, initial, goal, strays, tree })
    }

    /// The name, `sorting_mail-0`; empty if it has none.
    pub fn name(&self) -> &str {
        self.name.and_then(|i| self.tree.expr(i).word()).unwrap_or_default()
    }

    /// The domain, `omnigibson` or `igibson`; empty if it has none.
    pub fn domain(&self) -> &str {
        self.domain.and_then(|i| self.tree.expr(i).word()).unwrap_or_default()
    }

    /// The objects, in the order of the text.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = DeclaredObject<'_>> {
        self.objects.iter().map(|o| {
            let at = self.tree.expr(o.name);
            let class = o.class.and_then(|i| self.tree.expr(i).word()).unwrap_or("object");
            DeclaredObject { name: at.word().unwrap_or_default(), class, at }
        })
    }

    /// The initial facts, in the order of the text.
    ///
    /// ```
    /// use vc_tasks::format::bddl::ActivityDefinition;
    /// let text = "(define (problem p) (:objects a - cup) (:init (not (dusty a))) (:goal (dusty a)))";
    /// let activity = ActivityDefinition::read(text)?;
    /// let facts: Vec<_> = activity.initial().map(|fact| (fact.atom.predicate, fact.holds)).collect();
    /// assert_eq!(facts, [("dusty", false)]);
    /// # Ok::<(), vc_tasks::format::ReadError>(())
    /// ```
    pub fn initial(&self) -> impl Iterator<Item = Fact<'_>> {
        self.initial.iter().filter_map(|&i| Fact::new(self.tree.expr(i)).ok())
    }

    /// The goal.
    pub fn goal(&self) -> Expr<'_> {
        self.tree.expr(self.goal)
    }

    /// The parts of the goal that BEHAVIOR counts: the conjuncts of an `and`, or the
    /// goal itself.
    pub fn heads(&self) -> Vec<Expr<'_>> {
        match ConditionNode::new(self.goal()) {
            Ok(ConditionNode::And(parts)) => parts.collect(),
            _ => vec![self.goal()],
        }
    }

    /// The other parts of the text, which the reference implementation ignores: stray words,
    /// unknown sections, conditions after the goal's first.
    pub(crate) fn strays(&self) -> impl Iterator<Item = Expr<'_>> {
        self.strays.iter().map(|&i| self.tree.expr(i))
    }
}

impl PartialEq for ActivityDefinition {
    fn eq(&self, other: &Self) -> bool {
        let objects = |a: &Self| a.objects().map(|o| (o.name.to_owned(), o.class.to_owned())).collect::<Vec<_>>();
        let alike = |(&mine, &theirs): (&u32, &u32)| self.tree.expr(mine).same(other.tree.expr(theirs));
        self.name() == other.name()
            && self.domain() == other.domain()
            && objects(self) == objects(other)
            && self.initial.len() == other.initial.len()
            && self.initial.iter().zip(&other.initial).all(alike)
            && self.goal().same(other.goal())
    }
}

/// The sections of an activity read so far.
#[derive(Default)]
struct Sections {
    name: Option<u32>,
    domain: Option<u32>,
    objects: Vec<Declared>,
    initial: Vec<u32>,
    goal: Option<u32>,
    strays: Vec<u32>,
}

impl Sections {
    fn take(&mut self, section: Expr<'_>) -> Result<(), ReadError> {
        let rest = || section.items().skip(1);
        match section.head().filter(|_| section.is_list()) {
            Some("problem") => self.name = Some(last_word(section, "the activity's name")?),
            Some(":domain") => self.domain = Some(last_word(section, "the domain's name")?),
            Some(":objects") => self.declare(section)?,
            Some(":init") => {
                for fact in rest() {
                    Fact::new(fact)?;
                    self.initial.push(fact.index());
                }
            }
            Some(":goal") if self.goal.is_some() => return Err(section.error("no second goal")),
            Some(":goal") => {
                let mut parts = rest();
                let goal = parts.next().ok_or_else(|| section.error_at_end("a condition"))?;
                check(goal)?;
                self.goal = Some(goal.index());
                for extra in parts {
                    if extra.is_list() {
                        check(extra)?;
                    }
                    self.strays.push(extra.index());
                }
            }
            Some(":requirements") => {}
            _ => self.strays.push(section.index()),
        }
        Ok(())
    }

    /// `cup.n.01_1 cup.n.01_2 - cup.n.01`, any number of times.
    fn declare(&mut self, section: Expr<'_>) -> Result<(), ReadError> {
        let mut items = section.items().skip(1);
        let mut untyped = self.objects.len();
        while let Some(item) = items.next() {
            if item.word() != Some("-") {
                item.word().ok_or_else(|| item.error("an object"))?;
                self.objects.push(Declared { name: item.index(), class: None });
                continue;
            }
            let class = items.next().ok_or_else(|| section.error_at_end("a class after the `-`"))?;
            class.word().ok_or_else(|| class.error("a class"))?;
            self.objects[untyped..].iter_mut().for_each(|o| o.class = Some(class.index()));
            untyped = self.objects.len();
        }
        Ok(())
    }
}

fn last_word(section: Expr<'_>, expected: &str) -> Result<u32, ReadError> {
    let last = section.items().skip(1).last().ok_or_else(|| section.error_at_end(expected))?;
    last.word().map(|_| last.index()).ok_or_else(|| last.error(expected))
}

impl<'t> Fact<'t> {
    fn new(at: Expr<'t>) -> Result<Self, ReadError> {
        let inner = if at.head() == Some("not") { Some(only(at)?) } else { None };
        let atom = AppliedPredicate::from_expr(inner.unwrap_or(at))?;
        Ok(Self { holds: inner.is_none(), atom, at })
    }
}

impl fmt::Display for ActivityDefinition {
    /// As BDDL, one object class, one fact and one part of the goal a line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("(define")?;
        // A missing name or domain stays missing.
        for (head, word) in [("problem", self.name()), (":domain", self.domain())] {
            if !word.is_empty() {
                write!(f, " ({head} {word})")?;
            }
        }
        writeln!(f, "\n\n    (:objects")?;
        let objects: Vec<DeclaredObject<'_>> = self.objects().collect();
        for of_class in objects.chunk_by(|a, b| a.class == b.class) {
            let names: Vec<&str> = of_class.iter().map(|o| o.name).collect();
            writeln!(f, "        {} - {}", names.join(" "), of_class[0].class)?;
        }
        writeln!(f, "    )\n\n    (:init")?;
        for fact in &self.initial {
            writeln!(f, "        {}", self.tree.expr(*fact))?;
        }
        writeln!(f, "    )\n\n    (:goal")?;
        match ConditionNode::new(self.goal()) {
            Ok(ConditionNode::And(parts)) => {
                writeln!(f, "        (and")?;
                for part in parts {
                    writeln!(f, "            {part}")?;
                }
                writeln!(f, "        )")?;
            }
            _ => writeln!(f, "        {}", self.goal())?,
        }
        writeln!(f, "    )\n)")
    }
}
