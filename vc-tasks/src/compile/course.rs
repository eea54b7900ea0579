//! Ground temporal goals: their non-temporal parts are compiled, and temporal operators stand above
//! these.

use std::borrow::Cow;

use vc_graph::NodeId;
use vc_graph::goal::{Comparison, Goal, Pairs, Quantified};

use super::gate::Table;
use super::ground::{Ground, Things};
use super::{CompileError, Compiler, GoalProgram};

/// A goal whose variables have been replaced by objects.
#[derive(Debug, Clone)]
pub(super) enum Course {
    /// A head of the program: a non-temporal part, true or false in a single state.
    State(usize),
    Not(Box<Course>),
    /// A count of the parts that hold.
    Count(Vec<Course>, Comparison, u32),
    /// A count of the pairs that can be formed in a table of parts, row by row.
    Pairs(Vec<Course>, Table, Comparison, u32),
    Then(Vec<Course>),
    Eventually(Box<Course>),
    Always(Box<Course>),
    Within(u32, Box<Course>),
    AtEnd(Box<Course>),
    Until(Box<Course>, Box<Course>),
    Before(Box<Course>, Box<Course>),
}

impl Compiler {
    /// The conjuncts of a goal, and the program of their non-temporal parts.
    pub(super) fn courses(
        &mut self,
        goal: &Goal,
        things: &impl Things,
    ) -> Result<(Vec<Course>, GoalProgram), CompileError> {
        let parts: Vec<Cow<'_, Goal>> = goal.conjuncts().iter().map(|part| things.expanded(part)).collect();
        let mut ground = Ground::new(self, things);
        let courses = parts.iter().map(|part| ground.course(part)).collect::<Result<_, _>>()?;
        Ok((courses, ground.finish()?))
    }
}

impl<'g, T: Things> Ground<'_, 'g, T> {
    fn course(&mut self, goal: &'g Goal) -> Result<Course, CompileError> {
        if !goal.is_temporal() {
            let head = self.goal(goal)?;
            return Ok(Course::State(self.add_head(head)));
        }
        self.count_part()?;
        Ok(match goal {
            Goal::And(parts) => all(self.courses(parts)?),
            Goal::Or(parts) => any(self.courses(parts)?),
            Goal::Not(part) => Course::Not(self.boxed(part)?),
            Goal::Imply(a, b) => any(vec![Course::Not(self.boxed(a)?), self.course(b)?]),
            Goal::ForAll(q) => all(self.of_each(q)?),
            Goal::Exists(q) => any(self.of_each(q)?),
            Goal::ForN { comparison, number, of } => Course::Count(self.of_each(of)?, *comparison, *number),
            Goal::ForPairs(pairs) => self.of_pairs(pairs)?,
            Goal::Then(parts) => Course::Then(self.courses(parts)?),
            Goal::Eventually(part) => Course::Eventually(self.boxed(part)?),
            Goal::Always(part) => Course::Always(self.boxed(part)?),
            Goal::Within(steps, part) => Course::Within(*steps, self.boxed(part)?),
            Goal::AtEnd(part) => Course::AtEnd(self.boxed(part)?),
            Goal::Until(a, b) => Course::Until(self.boxed(a)?, self.boxed(b)?),
            Goal::Before(a, b) => Course::Before(self.boxed(a)?, self.boxed(b)?),
            _ => return Err(CompileError::Temporal(goal.to_string())),
        })
    }

    fn boxed(&mut self, part: &'g Goal) -> Result<Box<Course>, CompileError> {
        self.course(part).map(Box::new)
    }

    fn courses(&mut self, parts: &'g [Goal]) -> Result<Vec<Course>, CompileError> {
        parts.iter().map(|part| self.course(part)).collect()
    }

    fn of_each(&mut self, q: &'g Quantified) -> Result<Vec<Course>, CompileError> {
        let things = self.things_of(q.class.as_deref());
        things.into_iter().map(|thing| self.with(&q.variable, thing, |g| g.course(&q.body)).0).collect()
    }

    fn of_pairs(&mut self, pairs: &'g Pairs) -> Result<Course, CompileError> {
        let [rows, columns] = [&pairs.first, &pairs.second].map(|v| self.things_of(v.class.as_deref()));
        let mut parts = Vec::with_capacity(rows.len() * columns.len());
        for &a in &rows {
            for &b in &columns {
                parts.push(if a == b { any(Vec::new()) } else { self.of_pair(pairs, a, b)? });
            }
        }
        let (rows, columns) = (rows.len() as u32, columns.len() as u32);
        let table = Table { rows, columns, need: 0, pairing: pairs.pairing };
        let (comparison, number) = pairs.number.unwrap_or((Comparison::AtLeast, rows.min(columns)));
        Ok(Course::Pairs(parts, table, comparison, number))
    }

    fn of_pair(&mut self, pairs: &'g Pairs, a: NodeId, b: NodeId) -> Result<Course, CompileError> {
        let second = &pairs.second.name;
        self.with(&pairs.first.name, a, |g| g.with(second, b, |g| g.course(&pairs.body)).0).0
    }
}

fn all(parts: Vec<Course>) -> Course {
    let number = parts.len() as u32;
    Course::Count(parts, Comparison::AtLeast, number)
}

fn any(parts: Vec<Course>) -> Course {
    Course::Count(parts, Comparison::AtLeast, 1)
}
