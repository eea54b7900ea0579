//! Scores: the degree to which a goal is satisfied.

use super::judge::Judge;
use super::trace::{Course, Stretch};
use super::{Comparison, EpisodeTrace, Goal, Quantified, Situation};

impl Goal {
    /// The degree to which the goal is satisfied, 0 to 1; 1 if and only if it holds. The parts of a conjunction
    /// have equal weight, a count is scored by the number of objects found, a disjunction by its best part.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, Goal, History, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let history = History::default();
    /// let now = Situation::new(&graph, me, &history);
    /// assert_eq!("On(apple, kitchen_table) & Holds(apple)".parse::<Goal>()?.score(&now), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn score(&self, now: &Situation<'_>) -> f64 {
        self.scored(Course::new(now))
    }

    /// The degree to which the goal is satisfied on a trace; a part that must hold at some step is scored by
    /// its best step, one that must hold at all steps by the mean over the steps.
    pub fn score_on(&self, trace: &EpisodeTrace) -> f64 {
        self.scored(trace.course())
    }

    fn scored(&self, course: Course<'_>) -> f64 {
        Judge { course, bound: Vec::new() }.score(&self.expanded(course.vocabulary()), Stretch::all(&course))
    }
}

impl<'g> Judge<'g, '_> {
    fn score(&mut self, goal: &'g Goal, on: Stretch) -> f64 {
        if self.holds(goal, on) {
            return 1.0;
        }
        let partial = match goal {
            Goal::Count { literal, comparison: Comparison::AtLeast, number } => share(self.count(literal, on), *number),
            Goal::ForN { comparison: Comparison::AtLeast, number, of } => share(self.found(of, on), *number),
            Goal::ForPairs(pairs) => {
                let (first, second, found) = self.pairs(pairs, on);
                match pairs.number {
                    Some((Comparison::AtLeast, number)) => share(found, number),
                    Some(_) => 0.0,
                    None => found as f64 / first.min(second) as f64,
                }
            }
            Goal::And(parts) | Goal::Then(parts) => mean(parts.iter().map(|p| self.score(p, on))),
            Goal::Or(parts) => best(parts.iter().map(|p| self.score(p, on))),
            Goal::Imply(_, part) => self.score(part, on),
            Goal::ForAll(q) => mean(self.each(q, on).into_iter().map(|id| self.score_of(q, id, on))),
            Goal::Exists(q) => best(self.each(q, on).into_iter().map(|id| self.score_of(q, id, on))),
            Goal::Eventually(part) | Goal::Until(_, part) | Goal::Before(part, _) => {
                best(on.moments().map(|m| self.score(part, m)))
            }
            Goal::Always(part) => mean(on.moments().map(|m| self.score(part, m))),
            Goal::Within(steps, part) => best(on.moments_within(*steps).map(|m| self.score(part, m))),
            Goal::AtEnd(part) => self.score(part, on.alone()),
            Goal::Literal(_) | Goal::Count { .. } | Goal::ForN { .. } | Goal::Same(..) | Goal::Not(_) => 0.0,
        };
        // All parts of a `then` may hold although their order is wrong.
        partial.min(1.0 - f64::EPSILON)
    }

    fn score_of(&mut self, q: &'g Quantified, id: crate::NodeId, on: Stretch) -> f64 {
        self.with(&q.variable, id, |judge| judge.score(&q.body, on))
    }
}

fn share(found: usize, of: u32) -> f64 {
    found as f64 / f64::from(of)
}

fn mean(scores: impl Iterator<Item = f64>) -> f64 {
    let (sum, number) = scores.fold((0.0, 0.0), |(sum, number), s| (sum + s, number + 1.0));
    if number > 0.0 { sum / number } else { 1.0 }
}

fn best(scores: impl Iterator<Item = f64>) -> f64 {
    scores.fold(0.0, f64::max)
}
