//! From a goal and the things there are to atoms and gates.

use std::cell::Cell;

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Situation, Term};
use vc_graph::{NodeId, SceneGraph, State};

use super::gate::Ref;
use super::table::Numbers;
use super::{Atom, CompileError, Program, Shape};

/// The things a goal can be about.
pub trait Things {
    /// Adds the things of a class and of its kinds, in a fixed order and each once;
    /// all things, if there is no class.
    fn each(&self, class: Option<&str>, things: &mut Vec<NodeId>);

    /// Who `me` is.
    fn agent(&self) -> NodeId;

    /// Whether there is such a thing.
    fn has(&self, id: NodeId) -> bool;
}

impl Things for Situation<'_> {
    fn each(&self, class: Option<&str>, things: &mut Vec<NodeId>) {
        each_of(self.graph, class, things);
    }

    fn agent(&self) -> NodeId {
        self.agent
    }

    fn has(&self, id: NodeId) -> bool {
        self.graph.node(id).is_some()
    }
}

fn each_of(graph: &SceneGraph, class: Option<&str>, things: &mut Vec<NodeId>) {
    match class {
        Some(class) => things.extend(graph.of_class(class)),
        None => things.extend(graph.nodes().map(vc_graph::Node::id)),
    }
}

/// Most parts of a goal, each counted for every choice of things.
const LARGEST: usize = 1 << 24;

/// A compiler: it keeps its memory from one goal to the next.
#[derive(Debug)]
pub struct Compiler {
    largest: usize,
    atoms: Numbers,
    pub(super) gates: Numbers,
    pub(super) stack: Vec<Ref>,
    pub(super) pool: Vec<NodeId>,
}

impl Default for Compiler {
    fn default() -> Self {
        Self::limited(LARGEST)
    }
}

impl Compiler {
    /// A compiler that has compiled nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// A compiler that gives up on goals of more parts than this, each counted for
    /// every choice of things; the usual limit is 16,777,216.
    pub fn limited(largest: usize) -> Self {
        let (atoms, gates) = (Numbers::default(), Numbers::default());
        Self { largest, atoms, gates, stack: Vec::new(), pool: Vec::new() }
    }

    /// Compiles a goal for the things there are; its conjuncts are the program's
    /// heads. Costs a look at each choice of things for the variables around each
    /// literal.
    ///
    /// # Errors
    /// [`CompileError`]: the goal is about time, or there are too many choices.
    pub fn compile(&mut self, goal: &Goal, things: &impl Things) -> Result<Program, CompileError> {
        self.compile_all(goal.conjuncts(), things)
    }

    /// Compiles goals that are to hold together, each a head of the program.
    ///
    /// # Errors
    /// As [`Compiler::compile`].
    pub fn compile_all(&mut self, goals: &[Goal], things: &impl Things) -> Result<Program, CompileError> {
        let mut ground = Ground::new(self, things);
        for goal in goals {
            let head = ground.goal(goal)?;
            ground.add_head(head);
        }
        ground.finish()
    }
}

/// A choice for a literal's place: a stretch of the pool, or anything.
type Choices = std::ops::Range<usize>;

/// A variable and what it stands for.
struct Bound<'g> {
    variable: &'g str,
    thing: NodeId,
    /// Whether what stands in its scope asks for it.
    used: Cell<bool>,
}

pub(super) struct Ground<'a, 'g, T> {
    pub(super) memory: &'a mut Compiler,
    things: &'a T,
    pub(super) program: Program,
    bound: Vec<Bound<'g>>,
    /// Classes that have been looked up, and where in the pool their things are.
    ranges: Vec<(Option<&'g str>, Choices)>,
    /// How many parts may still be looked at.
    left: usize,
}

impl<'a, 'g, T: Things> Ground<'a, 'g, T> {
    pub(super) fn new(memory: &'a mut Compiler, things: &'a T) -> Self {
        memory.atoms.clear();
        memory.gates.clear();
        memory.stack.clear();
        memory.pool.clear();
        let left = memory.largest;
        Self { memory, things, program: Program::default(), bound: Vec::new(), ranges: Vec::new(), left }
    }

    /// One more part that is to hold, and its number.
    pub(super) fn add_head(&mut self, head: Ref) -> usize {
        self.program.heads.push(head);
        self.program.heads.len() - 1
    }

    pub(super) fn finish(mut self) -> Result<Program, CompileError> {
        let start = self.memory.stack.len();
        self.memory.stack.extend_from_slice(&self.program.heads);
        self.program.root = self.all(start)?;
        self.program.shape = Shape::of(&self.program);
        Ok(self.program)
    }

    pub(super) fn goal(&mut self, goal: &'g Goal) -> Result<Ref, CompileError> {
        self.look()?;
        match goal {
            Goal::Literal(literal) => self.literal(literal, Comparison::AtLeast, 1),
            Goal::Count { literal, comparison, number } => self.literal(literal, *comparison, *number),
            Goal::Same(a, b) => {
                let same = self.meant(a).is_some_and(|a| self.meant(b) == Some(a));
                Ok(Ref::constant(same))
            }
            Goal::And(parts) => self.list(parts, |g, start| g.all(start)),
            Goal::Or(parts) => self.list(parts, |g, start| g.count(start, Comparison::AtLeast, 1)),
            Goal::Not(part) => self.goal(part).map(|r| !r),
            Goal::Imply(a, b) => {
                let start = self.memory.stack.len();
                let inputs = [!self.goal(a)?, self.goal(b)?];
                self.memory.stack.extend(inputs);
                self.count(start, Comparison::AtLeast, 1)
            }
            Goal::ForAll(q) => self.quantified(q, |g, start| g.all(start)),
            Goal::Exists(q) => self.quantified(q, |g, start| g.count(start, Comparison::AtLeast, 1)),
            Goal::ForN { comparison, number, of } => {
                self.quantified(of, |g, start| g.count(start, *comparison, *number))
            }
            Goal::ForPairs(pairs) => self.pairs(pairs),
            _ => Err(CompileError::Temporal(goal.to_string())),
        }
    }

    /// One more part is looked at.
    pub(super) fn look(&mut self) -> Result<(), CompileError> {
        let left = self.left.checked_sub(1);
        self.left = left.ok_or(CompileError::TooLarge(self.memory.largest))?;
        Ok(())
    }

    fn list(
        &mut self,
        parts: &'g [Goal],
        gate: impl FnOnce(&mut Self, usize) -> Result<Ref, CompileError>,
    ) -> Result<Ref, CompileError> {
        let start = self.memory.stack.len();
        for part in parts {
            let input = self.goal(part)?;
            self.memory.stack.push(input);
        }
        gate(self, start)
    }

    fn quantified(
        &mut self,
        q: &'g Quantified,
        gate: impl FnOnce(&mut Self, usize) -> Result<Ref, CompileError>,
    ) -> Result<Ref, CompileError> {
        let start = self.memory.stack.len();
        let mut every = None;
        for at in self.range(q.class.as_deref()) {
            self.look()?;
            let input = match every {
                Some(input) => input,
                None => {
                    let (input, used) = self.with(&q.variable, self.memory.pool[at], |g| g.goal(&q.body));
                    let input = input?;
                    // A body that does not ask for its variable is the same for all.
                    every = (!used).then_some(input);
                    input
                }
            };
            self.memory.stack.push(input);
        }
        gate(self, start)
    }

    /// What comes out with a variable bound, and whether it was asked for.
    pub(super) fn with<R>(
        &mut self,
        variable: &'g str,
        thing: NodeId,
        ground: impl FnOnce(&mut Self) -> R,
    ) -> (R, bool) {
        self.bound.push(Bound { variable, thing, used: Cell::new(false) });
        let result = ground(self);
        let used = self.bound.pop().is_some_and(|b| b.used.get());
        (result, used)
    }

    /// Where the things of a class are in the pool.
    pub(super) fn range(&mut self, class: Option<&'g str>) -> Choices {
        if let Some((_, range)) = self.ranges.iter().find(|(known, _)| *known == class) {
            return range.clone();
        }
        let start = self.memory.pool.len();
        self.things.each(class, &mut self.memory.pool);
        let range = start..self.memory.pool.len();
        self.ranges.push((class, range.clone()));
        range
    }

    /// The things of a class.
    pub(super) fn things_of(&mut self, class: Option<&'g str>) -> Vec<NodeId> {
        let range = self.range(class);
        self.memory.pool[range].to_vec()
    }

    /// The thing a term stands for, if it is one thing.
    fn meant(&self, term: &Term) -> Option<NodeId> {
        match term {
            Term::Variable(name) => {
                let bound = self.bound.iter().rev().find(|b| b.variable == name)?;
                bound.used.set(true);
                Some(bound.thing)
            }
            Term::Node(_, id) => Some(*id),
            Term::Me => Some(self.things.agent()),
            Term::Class(_) | Term::Anything => None,
        }
    }
}

/// Literals.
impl<'g, T: Things> Ground<'_, 'g, T> {
    fn literal(&mut self, literal: &'g Literal, comparison: Comparison, number: u32) -> Result<Ref, CompileError> {
        let predicate = literal.predicate;
        let open = |t: &Term| {
            matches!((t, predicate), (Term::Class(_), _))
                || (*t == Term::Anything && !matches!(predicate, Predicate::Did(_)))
        };
        if (comparison, number) == (Comparison::AtLeast, 1) && !literal.terms.iter().any(open) {
            return self.single(literal);
        }
        let start = self.memory.stack.len();
        let counted = literal.counted().unwrap_or(0);
        let wild = |t: &Term| *t == Term::Anything && matches!(predicate, Predicate::Did(_));
        let first = literal.terms.get(counted);
        let other = literal.terms.get(1 - counted.min(1)).filter(|_| literal.terms.len() > 1);
        let firsts = self.choices(first, first.is_none_or(wild));
        let others = self.choices(other, other.is_none_or(wild));
        for a in firsts {
            let inner = self.memory.stack.len();
            for b in others.clone() {
                let things = [self.chosen(a), self.chosen(b)];
                let things = if counted == 0 { things } else { [things[1], things[0]] };
                let input = self.atom(predicate, things)?;
                self.memory.stack.push(input);
            }
            let input = self.count(inner, Comparison::AtLeast, 1)?;
            self.memory.stack.push(input);
        }
        self.count(start, comparison, number)
    }

    /// A literal whose terms all stand for one thing, or for none in particular.
    fn single(&mut self, literal: &Literal) -> Result<Ref, CompileError> {
        let mut things = [None; 2];
        for (thing, term) in things.iter_mut().zip(&literal.terms) {
            *thing = self.meant(term);
            if thing.is_none() && *term != Term::Anything {
                return Ok(Ref::FALSE);
            }
        }
        self.atom(literal.predicate, things)
    }

    /// What may stand in a place, as a stretch of the pool; [`Ground::ANYTHING`] for
    /// nothing in particular.
    fn choices(&mut self, term: Option<&'g Term>, anything: bool) -> Choices {
        match term {
            _ if anything => Self::ANYTHING,
            None => Self::ANYTHING,
            Some(Term::Class(class)) => self.range(Some(class)),
            Some(Term::Anything) => self.range(None),
            Some(term) => {
                let start = self.memory.pool.len();
                self.memory.pool.extend(self.meant(term));
                start..self.memory.pool.len()
            }
        }
    }

    const ANYTHING: Choices = usize::MAX - 1..usize::MAX;

    fn chosen(&self, at: usize) -> Option<NodeId> {
        self.memory.pool.get(at).copied()
    }

    fn atom(&mut self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Result<Ref, CompileError> {
        self.look()?;
        // What is real is there, and not still to come.
        if predicate == Predicate::Real {
            let there = things[0].is_some_and(|id| self.things.has(id));
            return Ok(if there { !self.numbered(Predicate::State(State::Future), things) } else { Ref::FALSE });
        }
        Ok(self.numbered(predicate, things))
    }

    fn numbered(&mut self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Ref {
        let atom = Atom { predicate, things };
        let atoms = &mut self.program.atoms;
        let next = atoms.len();
        let number = self.memory.atoms.number(atom.key(), next, |n| atoms[n] == atom, |n| atoms[n].key());
        if number == next {
            atoms.push(atom);
        }
        Ref::atom(number)
    }
}
