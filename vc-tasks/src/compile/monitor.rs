//! Temporal goals, evaluated step by step.

use std::sync::Arc;

use vc_graph::Goal;
use vc_graph::goal::{EpisodeTrace, Situation};

use super::course::Course;
use super::{Bits, CompileError, Compiler, GoalProgram};

/// A compiled goal, temporal or not, with the trace so far: it gives the results of
/// [`Goal::holds_by`] without reading any scene twice.
///
/// The non-temporal parts are one [`GoalProgram`] over the atoms that matter, and for each step only
/// the truth values of these atoms are stored. The temporal operators are then evaluated for all
/// steps at once, from the last to the first, by the unfolding of linear temporal logic on finite
/// traces (De Giacomo and Vardi, IJCAI 2013): `a until b` holds at a step if b does, or if a does
/// and `a until b` holds at the next one.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::compile::Monitor;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
///
/// let goal = "eventually Open(fridge) & Closed(fridge)".parse()?;
/// let mut monitor = Monitor::new(&goal, &Situation::new(world.graph(), me, world.history()))?;
/// for line in ["walk fridge.2", "open fridge.2", "close fridge.2"] {
///     world.step(me, &line.parse()?).map_err(|refusals| refusals[0].clone())?;
///     monitor.push(&Situation::new(world.graph(), me, world.history()));
/// }
/// assert!(monitor.holds());
/// assert_eq!(monitor.first_held(), [Some(2), Some(0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Monitor {
    program: Arc<GoalProgram>,
    /// The goal's conjuncts.
    courses: Arc<Vec<Course>>,
    /// The atoms about executed actions.
    action_atoms: Bits,
    /// For each step the atoms that are true after it; of those about actions, the ones executed in
    /// it.
    atoms: Vec<Bits>,
    /// For each step the heads of the program that are true for these atoms.
    heads: Vec<Bits>,
    /// For each conjunct whether it holds now; `first` has the step at which it first did.
    now: Vec<bool>,
    first: Vec<Option<usize>>,
    /// The number of events processed.
    events: usize,
}

impl Monitor {
    /// Compiles a goal for the objects of a situation and reads this as the state before the first
    /// step; earlier actions do not count.
    ///
    /// # Errors
    /// [`CompileError::TooLarge`]: there are too many choices of objects.
    pub fn new(goal: &Goal, now: &Situation<'_>) -> Result<Self, CompileError> {
        let (courses, program) = Compiler::new().courses(goal, now)?;
        let mut action_atoms = program.bits();
        program.atoms().iter().enumerate().for_each(|(index, atom)| action_atoms.set(index, atom.is_about_action()));
        let (now_held, first) = (vec![false; courses.len()], vec![None; courses.len()]);
        let mut monitor = Self {
            program: Arc::new(program),
            courses: Arc::new(courses),
            action_atoms,
            atoms: Vec::new(),
            heads: Vec::new(),
            now: now_held,
            first,
            events: now.events.len(),
        };
        monitor.push(now);
        Ok(monitor)
    }

    /// Evaluates a whole trace; the objects are those of its start. `None` where [`Monitor::new`]
    /// fails.
    ///
    /// ```
    /// use vc_graph::goal::EpisodeTrace;
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_tasks::compile::Monitor;
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.add(Draft::new("fridge"))?;
    /// let me = scene.add(Draft::new("character"))?;
    /// let trace = EpisodeTrace::new(scene.build(), me);
    /// let monitor = Monitor::from_trace(&"always Closed(fridge)".parse()?, &trace).ok_or("too large")?;
    /// assert!(monitor.holds());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_trace(goal: &Goal, trace: &EpisodeTrace) -> Option<Self> {
        let mut situations = (0..=trace.steps()).filter_map(|step| trace.situation(step));
        let mut monitor = Self::new(goal, &situations.next()?).ok()?;
        situations.for_each(|now| {
            monitor.push(&now);
        });
        Some(monitor)
    }

    /// As [`Monitor::from_trace`]; `None` also if nodes are added or removed on the way.
    pub(crate) fn from_constant_nodes(goal: &Goal, trace: &EpisodeTrace) -> Option<Self> {
        let mut graphs = (0..=trace.steps()).filter_map(|step| trace.graph(step));
        let first = graphs.next()?;
        graphs.all(|graph| graph.has_same_nodes(first)).then(|| Self::from_trace(goal, trace)).flatten()
    }

    /// Adds a step: the state after it, whose events continue those of the last step with the ones
    /// of this step. Returns whether the goal holds on the trace so far. Objects that appear or
    /// disappear are ignored.
    ///
    /// Costs one read of the scene per atom, and one visit of every step so far per temporal
    /// operator; `then` may cost its square.
    pub fn push(&mut self, now: &Situation<'_>) -> bool {
        let events = now.events.get(self.events..).unwrap_or_default();
        self.events = now.events.len();
        let atoms = self.program.read(&Situation { events, ..*now });
        self.heads.push(self.program.heads_in(&atoms));
        self.atoms.push(atoms);
        let (end, courses) = (self.steps(), self.courses.clone());
        for (index, course) in courses.iter().enumerate() {
            self.now[index] = self.judge(course, Stretch { since: 0, from: 0, end });
            if self.now[index] {
                self.first[index].get_or_insert(end);
            }
        }
        self.holds()
    }

    /// The program of the goal's non-temporal parts.
    pub fn program(&self) -> &GoalProgram {
        &self.program
    }

    /// The number of steps.
    pub fn steps(&self) -> usize {
        self.atoms.len() - 1
    }

    /// Whether the goal holds on the trace so far. Takes constant time in the length of the trace.
    pub fn holds(&self) -> bool {
        self.now.iter().all(|held| *held)
    }

    /// For each of the goal's conjuncts, whether it holds on the trace so far.
    pub fn heads(&self) -> &[bool] {
        &self.now
    }

    pub(super) fn courses(&self) -> &[Course] {
        &self.courses
    }

    /// For each step whether a head of the program is true in it.
    pub(super) fn held(&self, head: usize) -> impl Iterator<Item = bool> + '_ {
        self.heads.iter().map(move |heads| heads.has(head))
    }

    /// For each conjunct the first step after which it held, if there was one.
    pub fn first_held(&self) -> &[Option<usize>] {
        &self.first
    }
}

/// The part of the trace on which a goal is evaluated.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// Actions executed after this step count.
    since: usize,
    /// The first step that temporal operators consider.
    from: usize,
    /// The last step.
    end: usize,
}

impl Monitor {
    /// Whether a goal holds on a stretch; parts under no temporal operator are evaluated at its
    /// end.
    fn judge(&self, course: &Course, on: Stretch) -> bool {
        match course {
            Course::State(head) => self.program.head_holds(&self.whole(on), *head),
            Course::Not(part) => !self.judge(part, on),
            Course::Count(parts, comparison, number) => {
                comparison.admits(parts.iter().filter(|part| self.judge(part, on)).count(), *number)
            }
            Course::Pairs(parts, table, comparison, number) => {
                comparison.admits(table.number(&mut |cell| self.judge(&parts[cell], on)), *number)
            }
            Course::Then(parts) => self.in_order(parts, on),
            Course::AtEnd(part) => self.judge(part, on),
            _ => self.moments(course, on).first().is_some_and(|held| *held),
        }
    }

    /// The atoms at the end of a stretch, with all actions executed on it.
    fn whole(&self, on: Stretch) -> Bits {
        let mut bits = self.atoms[on.end].clone();
        bits.remove(&self.action_atoms);
        self.atoms[on.since + 1..on.end + 1].iter().for_each(|step| bits.add_of(step, &self.action_atoms));
        bits
    }

    /// Whether a goal holds at each single step of a stretch.
    fn moments(&self, course: &Course, on: Stretch) -> Vec<bool> {
        let of = |part: &Course| self.moments(part, on);
        match course {
            Course::State(head) => self.states(*head, on),
            Course::Not(part) => of(part).into_iter().map(|held| !held).collect(),
            Course::Count(parts, comparison, number) => {
                let parts: Vec<Vec<bool>> = parts.iter().map(of).collect();
                let count = |step: usize| parts.iter().filter(|part| part[step]).count();
                (0..=on.end - on.from).map(|step| comparison.admits(count(step), *number)).collect()
            }
            Course::Pairs(parts, table, comparison, number) => {
                let parts: Vec<Vec<bool>> = parts.iter().map(of).collect();
                let count = |step: usize| table.number(&mut |cell| parts[cell][step]);
                (0..=on.end - on.from).map(|step| comparison.admits(count(step), *number)).collect()
            }
            Course::Then(parts) => {
                let rest = |from: usize| Stretch { since: on.since.max(from.saturating_sub(1)), from, end: on.end };
                (on.from..=on.end).map(|from| self.in_order(parts, rest(from))).collect()
            }
            Course::AtEnd(part) => vec![self.judge(part, on); on.end - on.from + 1],
            Course::Eventually(part) => backwards(of(part), |here, later| here || later, false),
            Course::Always(part) => backwards(of(part), |here, later| here && later, true),
            Course::Within(steps, part) => within(&of(part), *steps as usize),
            Course::Until(a, b) => unfold(of(a), of(b), |a, b, later| b || (a && later)),
            Course::Before(a, b) => unfold(of(a), of(b), |a, b, later| !b && (a || later)),
        }
    }

    /// For each step of a stretch, whether a conjunct is true; actions of the first step may not
    /// belong to the stretch.
    fn states(&self, head: usize, on: Stretch) -> Vec<bool> {
        let mut steps: Vec<bool> = self.heads[on.from..=on.end].iter().map(|heads| heads.has(head)).collect();
        if on.from == on.since {
            steps[0] = self.program.head_holds(&self.whole(Stretch { end: on.from, ..on }), head);
        }
        steps
    }

    /// Splits a stretch into one for each part, each as short as possible.
    fn in_order(&self, parts: &[Course], on: Stretch) -> bool {
        let Some((last, others)) = parts.split_last() else { return true };
        let mut rest = on;
        for part in others {
            match (rest.from..=rest.end).find(|&end| self.judge(part, Stretch { end, ..rest })) {
                Some(end) => rest = Stretch { since: end, from: end, end: on.end },
                None => return false,
            }
        }
        self.judge(last, rest)
    }
}

/// Computes from the last step to the first whether a goal holds there, given whether it holds
/// later.
fn backwards(mut steps: Vec<bool>, holds: impl Fn(bool, bool) -> bool, after: bool) -> Vec<bool> {
    let mut later = after;
    for step in steps.iter_mut().rev() {
        later = holds(*step, later);
        *step = later;
    }
    steps
}

/// The same for two parts; after the last step the goal counts as false.
fn unfold(mut a: Vec<bool>, b: Vec<bool>, holds: impl Fn(bool, bool, bool) -> bool) -> Vec<bool> {
    let mut later = false;
    for (a, b) in a.iter_mut().zip(b).rev() {
        later = holds(*a, b, later);
        *a = later;
    }
    a
}

/// The steps from which a part holds at most the given number of steps later.
fn within(part: &[bool], steps: usize) -> Vec<bool> {
    let mut next = None;
    let mut held = vec![false; part.len()];
    for (at, here) in part.iter().enumerate().rev() {
        next = if *here { Some(at) } else { next };
        held[at] = next.is_some_and(|next| next - at <= steps);
    }
    held
}
