//! Grounding: from a goal and the objects of a scene to atoms and gates.

use std::borrow::Cow;
use std::cell::Cell;

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Situation, Term};
use vc_graph::{NodeId, SceneGraph, State};

use super::gate::Ref;
use super::table::Numbers;
use super::{CompileError, GoalProgram, GroundAtom, Shape};

/// The objects that a goal can refer to.
pub trait Things {
    /// Adds the objects of a class and its subclasses, in a fixed order and each once; all objects
    /// if no class is given.
    fn each(&self, class: Option<&str>, things: &mut Vec<NodeId>);

    /// The node that `me` denotes.
    fn agent(&self) -> NodeId;

    /// Whether there is an object with this identifier.
    fn has(&self, id: NodeId) -> bool;

    /// A goal with the definitions of derived predicates in their place, as far as they are known.
    fn expanded<'g>(&self, goal: &'g Goal) -> Cow<'g, Goal> {
        Cow::Borrowed(goal)
    }
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

    fn expanded<'g>(&self, goal: &'g Goal) -> Cow<'g, Goal> {
        goal.expanded(self.graph.vocabulary())
    }
}

fn each_of(graph: &SceneGraph, class: Option<&str>, things: &mut Vec<NodeId>) {
    match class {
        Some(class) => things.extend(graph.of_class(class)),
        None => things.extend(graph.nodes().map(vc_graph::Node::id)),
    }
}

/// The default limit of a goal's parts, each counted for every choice of objects.
const LARGEST: usize = 1 << 24;

/// A compiler that reuses its memory from one goal to the next.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, Goal, History, SceneBuilder};
/// use vc_tasks::compile::Compiler;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let mut compiler = Compiler::new();
/// for text in ["On(apple, kitchen_table)", "!Holds(apple)"] {
///     let program = compiler.compile(&text.parse::<Goal>()?, &now)?;
///     assert!(program.holds(&program.read(&now)), "{text}");
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
    /// A compiler with the default limit.
    pub fn new() -> Self {
        Self::default()
    }

    /// A compiler that rejects goals with more than `largest` parts, each counted for every choice
    /// of objects; the default limit is 16,777,216.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::{CompileError, Compiler};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "On(apple, kitchen_table) & Holds(apple)".parse()?;
    /// assert!(matches!(Compiler::limited(1).compile(&goal, &now), Err(CompileError::TooLarge(1))));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn limited(largest: usize) -> Self {
        let (atoms, gates) = (Numbers::default(), Numbers::default());
        Self { largest, atoms, gates, stack: Vec::new(), pool: Vec::new() }
    }

    /// Compiles a goal for the given objects; its conjuncts are the program's heads. The time is
    /// proportional to the number of choices of objects for the variables around each literal.
    ///
    /// # Errors
    /// [`CompileError`]: the goal is temporal, or there are too many choices.
    pub fn compile(&mut self, goal: &Goal, things: &impl Things) -> Result<GoalProgram, CompileError> {
        self.compile_all(goal.conjuncts(), things)
    }

    /// Compiles the conjunction of several goals, each of them a head of the program.
    ///
    /// # Errors
    /// As [`Compiler::compile`].
    pub(crate) fn compile_all(&mut self, goals: &[Goal], things: &impl Things) -> Result<GoalProgram, CompileError> {
        let goals: Vec<Cow<'_, Goal>> = goals.iter().map(|goal| things.expanded(goal)).collect();
        let mut ground = Ground::new(self, things);
        for goal in &goals {
            let head = ground.goal(goal)?;
            ground.add_head(head);
        }
        ground.finish()
    }
}

/// The candidates for an argument of a literal: a range of the pool, or anything.
type Choices = std::ops::Range<usize>;

/// A variable and the object bound to it.
struct Bound<'g> {
    variable: &'g str,
    thing: NodeId,
    /// Whether the body in its scope uses the variable.
    used: Cell<bool>,
}

pub(super) struct Ground<'a, 'g, T> {
    pub(super) memory: &'a mut Compiler,
    things: &'a T,
    pub(super) program: GoalProgram,
    bound: Vec<Bound<'g>>,
    /// The classes already looked up, and the ranges of their objects in the pool.
    ranges: Vec<(Option<&'g str>, Choices)>,
    /// The number of parts that may still be visited.
    left: usize,
}

impl<'a, 'g, T: Things> Ground<'a, 'g, T> {
    pub(super) fn new(memory: &'a mut Compiler, things: &'a T) -> Self {
        memory.atoms.clear();
        memory.gates.clear();
        memory.stack.clear();
        memory.pool.clear();
        let left = memory.largest;
        Self { memory, things, program: GoalProgram::default(), bound: Vec::new(), ranges: Vec::new(), left }
    }

    /// Adds a conjunct and returns its index.
    pub(super) fn add_head(&mut self, head: Ref) -> usize {
        self.program.heads.push(head);
        self.program.heads.len() - 1
    }

    pub(super) fn finish(mut self) -> Result<GoalProgram, CompileError> {
        let start = self.memory.stack.len();
        self.memory.stack.extend_from_slice(&self.program.heads);
        self.program.root = self.all(start)?;
        self.program.shape = Shape::new(&self.program);
        Ok(self.program)
    }

    pub(super) fn goal(&mut self, goal: &'g Goal) -> Result<Ref, CompileError> {
        self.count_part()?;
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

    /// Counts one more visited part.
    pub(super) fn count_part(&mut self) -> Result<(), CompileError> {
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
            self.count_part()?;
            let input = match every {
                Some(input) => input,
                None => {
                    let (input, used) = self.with(&q.variable, self.memory.pool[at], |g| g.goal(&q.body));
                    let input = input?;
                    // A body that does not use its variable is the same for all objects.
                    every = (!used).then_some(input);
                    input
                }
            };
            self.memory.stack.push(input);
        }
        gate(self, start)
    }

    /// Grounds with a variable bound; also returns whether the variable was used.
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

    /// The range of a class's objects in the pool.
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

    /// The objects of a class.
    pub(super) fn things_of(&mut self, class: Option<&'g str>) -> Vec<NodeId> {
        let range = self.range(class);
        self.memory.pool[range].to_vec()
    }

    /// The object that a term denotes, if it denotes a single one.
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

/// Grounding of literals.
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

    /// A literal whose terms each denote a single object, or anything.
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

    /// The candidates for an argument, as a range of the pool; [`Ground::ANYTHING`] if the argument
    /// may be anything.
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
        self.count_part()?;
        // A real object is present and not still to come.
        if predicate == Predicate::Real {
            let there = things[0].is_some_and(|id| self.things.has(id));
            return Ok(if there { !self.numbered(Predicate::State(State::Future), things) } else { Ref::FALSE });
        }
        Ok(self.numbered(predicate, things))
    }

    fn numbered(&mut self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Ref {
        let atom = GroundAtom { predicate, things };
        let atoms = &mut self.program.atoms;
        let next = atoms.len();
        let number = self.memory.atoms.number(atom.key(), next, |n| atoms[n] == atom, |n| atoms[n].key());
        if number == next {
            atoms.push(atom);
        }
        Ref::atom(number)
    }
}
