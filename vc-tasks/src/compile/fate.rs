//! The verdict of a trace on a temporal goal, whatever follows.

use vc_graph::goal::Comparison;

use super::course::Course;
use super::{Monitor, Verdict};

/// Kleene's strong logic: the lesser and the greater of two verdicts, false before unknown before true.
fn both(a: Verdict, b: Verdict) -> Verdict {
    match (a, b) {
        (Verdict::False, _) | (_, Verdict::False) => Verdict::False,
        (Verdict::True, Verdict::True) => Verdict::True,
        _ => Verdict::Unknown,
    }
}

fn either(a: Verdict, b: Verdict) -> Verdict {
    both(a.negated_if(true), b.negated_if(true)).negated_if(true)
}

impl Monitor {
    /// The first of the goal's conjuncts that cannot hold any more, whatever happens from now on. `None` if there is
    /// none, and also where only a closer look at the goal would tell: `then`, pairs, and what the scene allows are
    /// not considered.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::Monitor;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "always Dirty(apple) & On(apple, kitchen_table)".parse()?;
    /// let monitor = Monitor::new(&goal, &now)?; // the apple is clean from the start
    /// assert_eq!(monitor.broken(), Some(0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn broken(&self) -> Option<usize> {
        self.courses().iter().position(|course| self.at_the_end(course) == Verdict::False)
    }

    /// The verdict on a goal at the end of the trace, wherever that will be.
    fn at_the_end(&self, course: &Course) -> Verdict {
        match course {
            Course::State(_) | Course::Pairs(..) | Course::Then(_) => Verdict::Unknown,
            Course::AtEnd(part) => self.at_the_end(part),
            Course::Not(part) => self.at_the_end(part).negated_if(true),
            Course::Count(parts, comparison, number) => {
                counted(parts.iter().map(|part| self.at_the_end(part)), *comparison, *number)
            }
            _ => self.foreseen(course).first().copied().unwrap_or(Verdict::Unknown),
        }
    }

    /// The verdict on a goal at each step so far.
    fn foreseen(&self, course: &Course) -> Vec<Verdict> {
        let of = |part: &Course| self.foreseen(part);
        match course {
            Course::State(head) => self.held(*head).map(Verdict::from_bool).collect(),
            Course::Not(part) => of(part).into_iter().map(|v| v.negated_if(true)).collect(),
            Course::Count(parts, comparison, number) => {
                let parts: Vec<Vec<Verdict>> = parts.iter().map(of).collect();
                let at = |step: usize| counted(parts.iter().map(|part| part[step]), *comparison, *number);
                (0..=self.steps()).map(at).collect()
            }
            Course::Pairs(..) | Course::Then(_) | Course::AtEnd(_) => vec![Verdict::Unknown; self.steps() + 1],
            Course::Eventually(part) => backwards(of(part), either),
            Course::Always(part) => backwards(of(part), both),
            Course::Within(steps, part) => within(&of(part), *steps as usize),
            Course::Until(a, b) => unfold(&of(a), &of(b), |a, b, later| either(b, both(a, later))),
            Course::Before(a, b) => unfold(&of(a), &of(b), |a, b, later| both(b.negated_if(true), either(a, later))),
        }
    }
}

/// The verdict on a number of parts that hold.
fn counted(parts: impl Iterator<Item = Verdict>, comparison: Comparison, number: u32) -> Verdict {
    let (mut least, mut most) = (0, 0);
    for part in parts {
        least += usize::from(part == Verdict::True);
        most += usize::from(part != Verdict::False);
    }
    let admitted = (least..=most).filter(|count| comparison.admits(*count, number)).count();
    match admitted {
        0 => Verdict::False,
        all if all == most - least + 1 => Verdict::True,
        _ => Verdict::Unknown,
    }
}

/// Joins each step with all later ones, of which those to come are unknown.
fn backwards(mut steps: Vec<Verdict>, join: impl Fn(Verdict, Verdict) -> Verdict) -> Vec<Verdict> {
    let mut later = Verdict::Unknown;
    for step in steps.iter_mut().rev() {
        later = join(*step, later);
        *step = later;
    }
    steps
}

/// The same for two parts.
fn unfold(a: &[Verdict], b: &[Verdict], join: impl Fn(Verdict, Verdict, Verdict) -> Verdict) -> Vec<Verdict> {
    let mut later = Verdict::Unknown;
    let back = a.iter().zip(b).rev().map(|(a, b)| {
        later = join(*a, *b, later);
        later
    });
    let mut steps: Vec<Verdict> = back.collect();
    steps.reverse();
    steps
}

/// The verdict on a part that is to hold at most so many steps later.
fn within(part: &[Verdict], steps: usize) -> Vec<Verdict> {
    let at = |from: usize| {
        let last = from.saturating_add(steps);
        let to_come = if last < part.len() { Verdict::False } else { Verdict::Unknown };
        part[from..].iter().take(steps.saturating_add(1)).fold(to_come, |found, step| either(found, *step))
    };
    (0..part.len()).map(at).collect()
}
