//! The remainder of each part of a goal with words of time.

use std::collections::VecDeque;

use vc_graph::goal::{Goal, Predicate, Quantified, Term};

use super::{Aim, Guard, Moment, negated};

/// The remainder of a part.
#[derive(Debug, Clone)]
pub(super) enum Part {
    /// It has come about.
    Met,
    /// It is to hold at the end of its stretch, by what is done after so many actions.
    End(Goal, usize),
    /// It is to hold at some step.
    Once(Box<Once>),
    /// It is to hold at every step.
    Always(Goal),
    All(Vec<Part>),
    /// The first is pursued.
    Any(Vec<Part>),
    /// The part that is pursued, and those that come after it.
    Then(Box<Part>, VecDeque<Goal>),
    /// The agent cannot plan for it.
    Beyond(Goal),
}

/// A goal of a single step.
#[derive(Debug, Clone)]
pub(super) struct Once {
    goal: Goal,
    /// The number of the last step at which it may hold.
    by: Option<usize>,
    /// A goal that holds at all steps before it.
    until: Option<Goal>,
    /// A goal that does not hold at any step up to it.
    before: Option<Goal>,
    /// The part as it is written.
    whole: Goal,
}

impl Part {
    /// A part of a goal at the first step of its stretch.
    pub(super) fn new(goal: &Goal, start: &Moment<'_>) -> Self {
        let of = |part: &Goal| Self::new(part, start);
        let once = |part: &Goal| Once { goal: part.clone(), by: None, until: None, before: None, whole: goal.clone() };
        match goal {
            now if !now.is_temporal() => Self::End(now.clone(), start.step()),
            Goal::And(parts) => Self::All(parts.iter().map(of).collect()),
            Goal::Or(parts) => Self::Any(parts.iter().map(of).collect()),
            Goal::Imply(a, b) => Self::Any(vec![Self::not(a, start), of(b)]),
            Goal::Not(part) => Self::not(part, start),
            Goal::AtEnd(part) => of(part),
            Goal::Eventually(part) if is_momentary(part) => Self::Once(Box::new(once(part))),
            Goal::Eventually(part) if matches!(**part, Goal::Then(_) | Goal::Eventually(_)) => of(part),
            Goal::Within(steps, part) if is_momentary(part) => {
                let by = start.step().saturating_add(*steps as usize);
                Self::Once(Box::new(Once { by: Some(by), ..once(part) }))
            }
            Goal::Always(part) if !part.is_temporal() => Self::Always((**part).clone()),
            Goal::Until(a, b) if !a.is_temporal() && is_momentary(b) => {
                Self::Once(Box::new(Once { until: Some((**a).clone()), ..once(b) }))
            }
            Goal::Before(a, b) if is_momentary(a) && !b.is_temporal() => {
                Self::Once(Box::new(Once { before: Some((**b).clone()), ..once(a) }))
            }
            Goal::Then(parts) => match parts.split_first() {
                Some((first, later)) => Self::Then(Box::new(of(first)), later.iter().cloned().collect()),
                None => Self::Met,
            },
            Goal::ForAll(q) => Self::All(each(q, start).iter().map(of).collect()),
            Goal::Exists(q) => Self::Any(each(q, start).iter().map(of).collect()),
            other => Self::Beyond(other.clone()),
        }
    }

    /// A part that is not to hold.
    fn not(goal: &Goal, start: &Moment<'_>) -> Self {
        let not = |part: &Goal| Self::not(part, start);
        match goal {
            now if !now.is_temporal() => Self::End(negated(now), start.step()),
            Goal::And(parts) => Self::Any(parts.iter().map(not).collect()),
            Goal::Or(parts) => Self::All(parts.iter().map(not).collect()),
            Goal::Imply(a, b) => Self::All(vec![Self::new(a, start), not(b)]),
            Goal::Not(part) => Self::new(part, start),
            Goal::AtEnd(part) => not(part),
            Goal::Eventually(part) => Self::new(&Goal::Always(Box::new(negated(part))), start),
            Goal::Always(part) => Self::new(&Goal::Eventually(Box::new(negated(part))), start),
            Goal::ForAll(q) => Self::Any(each(q, start).iter().map(not).collect()),
            Goal::Exists(q) => Self::All(each(q, start).iter().map(not).collect()),
            other => Self::Beyond(negated(other)),
        }
    }

    /// Takes note of a step.
    ///
    /// # Errors
    /// The part of the goal that can no longer hold.
    pub(super) fn note(&mut self, at: &Moment<'_>) -> Result<(), Goal> {
        match self {
            Self::Met | Self::End(..) | Self::Beyond(_) => {}
            Self::Always(goal) if at.fails(goal) => return Err(Goal::Always(Box::new(goal.clone()))),
            Self::Always(_) => {}
            Self::Once(once) => {
                if once.note(at)? {
                    *self = Self::Met;
                }
            }
            Self::All(parts) => parts.iter_mut().try_for_each(|part| part.note(at))?,
            Self::Any(parts) => note_any(parts, at)?,
            Self::Then(active, later) => {
                active.note(at)?;
                while !later.is_empty() && active.is_met(at) {
                    let start = at.anew();
                    let Some(next) = later.pop_front() else { break };
                    **active = Self::new(&next, &start);
                    active.note(&start)?;
                }
            }
        }
        Ok(())
    }

    /// Whether the stretch can end here.
    fn is_met(&self, at: &Moment<'_>) -> bool {
        match self {
            Self::Met | Self::Always(_) => true,
            Self::End(goal, since) => at.holds_since(goal, *since),
            Self::Once(_) | Self::Beyond(_) => false,
            Self::All(parts) => parts.iter().all(|part| part.is_met(at)),
            Self::Any(parts) => parts.iter().any(|part| part.is_met(at)),
            Self::Then(active, later) => later.is_empty() && active.is_met(at),
        }
    }

    /// Drops the alternative that is pursued, if there are others.
    pub(super) fn go_otherwise(&mut self) -> bool {
        match self {
            Self::All(parts) => parts.iter_mut().any(Self::go_otherwise),
            Self::Then(active, _) => active.go_otherwise(),
            Self::Any(parts) => {
                let within = parts.first_mut().is_some_and(Self::go_otherwise);
                if !within && parts.len() > 1 {
                    parts.remove(0);
                    return true;
                }
                within
            }
            _ => false,
        }
    }

    /// The next stage, after so many steps.
    pub(super) fn aim(&self, step: usize) -> Aim {
        let mut open = Open::default();
        self.gather(&mut open);
        let current = (0..open.once.len()).min_by_key(|&i| open.once[i].by.as_ref().map_or(usize::MAX, |(by, _)| *by));
        let mut guards = open.guards;
        for (i, stage) in open.once.iter().enumerate() {
            let to_the_end = |guard: &Guard| guard.to_the_end || Some(i) != current;
            guards.extend(stage.guards.iter().map(|g| Guard { to_the_end: to_the_end(g), ..g.clone() }));
        }
        let is_last = current.is_none();
        let beyond = open.beyond.map(|part| part.to_string());
        match current.map(|i| open.once.swap_remove(i)) {
            Some(Stage { goal, since, by, .. }) => {
                Aim { goal, since: since.unwrap_or(step), by, guards, is_last, beyond }
            }
            None => Aim { goal: joined(open.ends), since: open.since, by: None, guards, is_last, beyond },
        }
    }

    fn gather(&self, open: &mut Open) {
        match self {
            Self::Met => {}
            Self::End(goal, since) => {
                open.ends.push(goal.clone());
                open.since = open.since.max(*since);
            }
            Self::Once(once) => open.once.push(once.stage()),
            Self::Always(goal) => {
                let part = Goal::Always(Box::new(goal.clone())).to_string();
                open.guards.push(Guard { goal: goal.clone(), part, to_the_end: true });
            }
            Self::All(parts) => parts.iter().for_each(|part| part.gather(open)),
            Self::Any(parts) => {
                if let Some(first) = parts.first() {
                    first.gather(open);
                }
            }
            Self::Then(active, later) if later.is_empty() => active.gather(open),
            Self::Then(active, _) => {
                let mut stretch = Open::default();
                active.gather(&mut stretch);
                open.guards.extend(stretch.guards);
                open.beyond = open.beyond.take().or(stretch.beyond);
                if stretch.once.is_empty() {
                    let (goal, since) = (joined(stretch.ends), Some(stretch.since));
                    open.once.push(Stage { goal, since, by: None, guards: Vec::new() });
                } else {
                    open.once.extend(stretch.once);
                }
            }
            Self::Beyond(goal) => open.beyond = open.beyond.take().or_else(|| Some(goal.clone())),
        }
    }
}

/// Takes note of a step in each alternative, and keeps those that can still hold.
fn note_any(parts: &mut Vec<Part>, at: &Moment<'_>) -> Result<(), Goal> {
    let mut broken = None;
    parts.retain_mut(|part| part.note(at).map_err(|part| broken = Some(part)).is_ok());
    if let Some(met) = parts.iter().position(|part| matches!(part, Part::Met)) {
        parts.swap(0, met);
    }
    match broken {
        Some(part) if parts.is_empty() => Err(part),
        _ => Ok(()),
    }
}

impl Once {
    /// Whether it has come about at a step.
    fn note(&self, at: &Moment<'_>) -> Result<bool, Goal> {
        let too_late = self.by.is_some_and(|by| at.step() > by);
        if too_late || self.before.as_ref().is_some_and(|later| at.holds(later)) {
            return Err(self.whole.clone());
        }
        if at.holds(&self.goal) {
            return Ok(true);
        }
        let is_last_step = self.by.is_some_and(|by| at.step() >= by);
        if is_last_step || self.until.as_ref().is_some_and(|meanwhile| at.fails(meanwhile)) {
            return Err(self.whole.clone());
        }
        Ok(false)
    }

    fn stage(&self) -> Stage {
        let guard = |goal: Goal, to_the_end| Guard { goal, part: self.whole.to_string(), to_the_end };
        let until = self.until.iter().map(|goal| guard(goal.clone(), false));
        let before = self.before.iter().map(|goal| guard(negated(goal), true));
        let by = self.by.map(|by| (by, self.whole.to_string()));
        Stage { goal: self.goal.clone(), since: None, by, guards: until.chain(before).collect() }
    }
}

/// Something to be reached before the end.
struct Stage {
    goal: Goal,
    /// Actions before this number do not count; those before the present step, if none.
    since: Option<usize>,
    by: Option<(usize, String)>,
    guards: Vec<Guard>,
}

/// The open parts of a goal.
#[derive(Default)]
struct Open {
    once: Vec<Stage>,
    ends: Vec<Goal>,
    since: usize,
    guards: Vec<Guard>,
    beyond: Option<Goal>,
}

fn joined(mut parts: Vec<Goal>) -> Goal {
    if parts.len() == 1 { parts.swap_remove(0) } else { Goal::And(parts) }
}

/// The body of a quantifier for each thing that there is.
fn each(q: &Quantified, start: &Moment<'_>) -> Vec<Goal> {
    let body = |id| {
        let replace = move |term: &Term| match term {
            Term::Variable(name) if *name == q.variable => Term::Node(None, id),
            other => other.clone(),
        };
        q.body.with_terms(&replace)
    };
    start.range(q.class.as_deref()).into_iter().map(body).collect()
}

/// Whether a goal can hold at a single step, in which one action is done.
fn is_momentary(goal: &Goal) -> bool {
    !goal.is_temporal() && done_actions(goal) <= 1
}

/// How many actions a goal wants to have been done.
fn done_actions(goal: &Goal) -> usize {
    let parts = goal.parts().into_iter().map(done_actions);
    match goal {
        Goal::Literal(literal) => usize::from(matches!(literal.predicate, Predicate::Did(_))),
        Goal::Count { literal, number, .. } if matches!(literal.predicate, Predicate::Did(_)) => *number as usize,
        Goal::And(_) => parts.sum(),
        _ => parts.max().unwrap_or(0),
    }
}
