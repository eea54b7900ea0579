//! A task with everything it needs.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use vc_graph::class::Category;
use vc_graph::format::unmarked;
use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Term};
use vc_graph::{ClassTable, Relation, State, Verb, Vocabulary};

use super::Need;
use crate::Task;

/// A goal, the objects it needs and the scene in which it begins.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Activity {
    /// The permanent identifier, `indoor-4`, `put_fridge-01`.
    pub id: String,
    /// The task in a few words.
    pub title: String,
    /// The goal, which is to hold at the end.
    pub goal: Goal,
    /// The conditions of a natural end: closed again, switched off again.
    pub natural: Goal,
    /// The objects it needs in addition to those that the goal names.
    pub needs: Vec<Need>,
    /// The conditions at the start: states of all objects of a class, and the seat or bed that the
    /// agent sits or lies on.
    pub start: Goal,
    /// The classes of the rooms and regions where it takes place.
    pub places: Vec<String>,
}

/// A mistake in a list of activities.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {message}")]
pub struct ActivityError {
    /// The name given to the list.
    pub file: String,
    /// The message, with line and column.
    pub message: String,
}

/// An activity as written in the lists.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    number: usize,
    title: String,
    goal: Goal,
    #[serde(default = "nothing")]
    natural: Goal,
    #[serde(default)]
    needs: Vec<Need>,
    #[serde(default = "nothing")]
    start: Goal,
    #[serde(default)]
    places: Vec<String>,
}

/// The goal that always holds.
pub(super) fn nothing() -> Goal {
    Goal::And(Vec::new())
}

impl Activity {
    /// Reads a list: JSON, an array of objects with `number`, `title`, `goal` and,
    /// as needed, `natural`, `needs`, `start` and `places`. Ids are `list-number`.
    ///
    /// ```
    /// use vc_tasks::library::Activity;
    /// let text = r#"[{"number": 7, "title": "tidy up", "goal": "Closed(fridge)", "needs": ["2 plate"]}]"#;
    /// let activities = Activity::read_list("own", text)?;
    /// assert_eq!((activities[0].id.as_str(), activities[0].needs[0].number), ("own-7", 2));
    /// # Ok::<(), vc_tasks::library::ActivityError>(())
    /// ```
    ///
    /// # Errors
    /// [`ActivityError`] with line, column and what was expected.
    pub fn read_list(list: &str, text: &str) -> Result<Vec<Self>, ActivityError> {
        let fail = |e: serde_json::Error| ActivityError { file: list.to_owned(), message: e.to_string() };
        let written: Vec<Written> = serde_json::from_str(unmarked(text)).map_err(fail)?;
        Ok(written.into_iter().map(|w| w.named(list)).collect())
    }

    /// The activity with the definitions of a vocabulary in the place of derived predicates: see [`Goal::expanded`].
    pub fn expanded(&self, words: &Vocabulary) -> Cow<'_, Self> {
        if words.own_predicates().is_empty() {
            return Cow::Borrowed(self);
        }
        let of = |goal: &Goal| goal.expanded(words).into_owned();
        let (goal, natural, start) = (of(&self.goal), of(&self.natural), of(&self.start));
        Cow::Owned(Self { goal, natural, start, ..self.clone() })
    }

    /// The task: the goal and the natural end as one goal.
    ///
    /// ```
    /// use vc_tasks::library::Benchmark;
    /// let benchmark = Benchmark::v1();
    /// let task = benchmark.get("put_fridge-01").ok_or("no such task")?.task();
    /// assert!(task.goal.to_string().starts_with("Inside(milk, fridge)"));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn task(&self) -> Task {
        Task::new(&self.title, all_of(&[&self.goal, &self.natural]))
    }

    /// Everything that must be in the scene: the needs as written, and those objects that the goal,
    /// the natural end and the start name in addition, as many as they ask for.
    ///
    /// Negations and universally quantified parts need nothing, nor do states at the start.
    pub fn all_needs(&self) -> Vec<Need> {
        let mut named = BTreeMap::new();
        [&self.goal, &self.natural].into_iter().for_each(|goal| named_things(goal, 1, &mut named));
        needed_classes(&self.start).into_iter().for_each(|class| {
            named.entry(class).or_insert(1);
        });
        let written = |class: &str| self.needs.iter().any(|n| n.class == class);
        let more = named.into_iter().filter(|(class, _)| !written(class));
        self.needs.iter().cloned().chain(more.map(|(class, number)| Need::new(class, number))).collect()
    }

    /// The places that are not rooms in a class table, so have yet to be built.
    pub fn unknown_places<'a>(&'a self, classes: &'a ClassTable) -> impl Iterator<Item = &'a str> {
        let known = |place: &str| classes.get(place).is_some_and(|c| c.category == Category::Room);
        self.places.iter().map(String::as_str).filter(move |place| !known(place))
    }

    /// The verbs that the goal and the natural end require: each literal's own verb, and `grab` before a
    /// placement. Plans contain more: the agent walks to everything.
    ///
    /// ```
    /// use vc_graph::Verb;
    /// use vc_tasks::library::Benchmark;
    /// let benchmark = Benchmark::v1();
    /// assert!(benchmark.get("put_fridge-01").ok_or("no such task")?.verbs().contains(&Verb::PutIn));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn verbs(&self) -> Vec<Verb> {
        let mut verbs = Vec::new();
        [&self.goal, &self.natural].into_iter().for_each(|goal| asked_verbs(goal, &mut verbs));
        verbs.sort_unstable();
        verbs.dedup();
        verbs
    }
}

impl Written {
    fn named(self, list: &str) -> Activity {
        let Self { number, title, goal, natural, needs, start, places } = self;
        Activity { id: format!("{list}-{number}"), title, goal, natural, needs, start, places }
    }
}

/// The conjunction of goals; temporal goals remain conjuncts of their own.
fn all_of(goals: &[&Goal]) -> Goal {
    let mut parts: Vec<Goal> = goals.iter().flat_map(|g| g.conjuncts().iter().cloned()).collect();
    if parts.len() == 1 { parts.remove(0) } else { Goal::And(parts) }
}

/// Collects the classes of the objects that a goal needs, with their numbers.
fn named_things(goal: &Goal, number: usize, named: &mut BTreeMap<String, usize>) {
    let mut name = |class: &str, number: usize| {
        let most = named.entry(class.to_owned()).or_insert(0);
        *most = number.max(*most);
    };
    match goal {
        Goal::Literal(literal) => {
            let counted = literal.counted();
            for (position, term) in literal.terms.iter().enumerate() {
                if let Term::Class(class) = term {
                    name(class, if Some(position) == counted { number } else { 1 });
                }
            }
        }
        Goal::Count { literal, comparison: Comparison::AtLeast | Comparison::Exactly, number } if *number > 0 => {
            named_things(&Goal::Literal(literal.clone()), *number as usize, named);
        }
        Goal::And(parts) | Goal::Then(parts) => parts.iter().for_each(|p| named_things(p, 1, named)),
        // One alternative is enough: the first is taken.
        Goal::Or(parts) => parts.iter().take(1).for_each(|p| named_things(p, 1, named)),
        Goal::Exists(q) => {
            q.class.iter().for_each(|class| name(class, 1));
            named_things(&q.body, 1, named);
        }
        Goal::ForN { comparison: Comparison::AtLeast | Comparison::Exactly, number, of } => {
            of.class.iter().for_each(|class| name(class, *number as usize));
            named_things(&of.body, 1, named);
        }
        Goal::Eventually(part) | Goal::Within(_, part) | Goal::AtEnd(part) | Goal::Until(_, part) => {
            named_things(part, 1, named);
        }
        Goal::Before(part, _) => named_things(part, 1, named),
        _ => {}
    }
}

fn asked_verbs(goal: &Goal, verbs: &mut Vec<Verb>) {
    use vc_graph::goal::Predicate as P;
    match goal {
        Goal::Literal(literal) | Goal::Count { literal, .. } => match literal.predicate {
            P::Did(verb) => verbs.push(verb),
            P::Holds => verbs.push(Verb::Grab),
            P::State(state) => verbs.extend(verb_of_state(state)),
            P::Relation(relation) => verbs.extend_from_slice(verbs_of_relation(relation)),
            // Other predicates describe what is there already and call for no action.
            _ => {}
        },
        Goal::Not(_) => {}
        _ => goal.parts().into_iter().for_each(|part| asked_verbs(part, verbs)),
    }
}

fn verb_of_state(state: State) -> Option<Verb> {
    Some(match state {
        State::Open => Verb::Open,
        State::Closed => Verb::Close,
        State::On => Verb::SwitchOn,
        State::Off => Verb::SwitchOff,
        State::Cooked => Verb::Cook,
        State::Sliced => Verb::Cut,
        State::Folded => Verb::Fold,
        State::Unfolded => Verb::Unfold,
        State::Filled => Verb::Fill,
        State::Clean => Verb::Wash,
        State::Dirty => Verb::Soil,
        State::Dry => Verb::Dry,
        State::Hot => Verb::Heat,
        State::Cold => Verb::Cool,
        _ => return None,
    })
}

fn verbs_of_relation(relation: Relation) -> &'static [Verb] {
    match relation {
        Relation::On => &[Verb::Grab, Verb::Place],
        Relation::Inside => &[Verb::Grab, Verb::PutIn],
        Relation::WornBy => &[Verb::Grab, Verb::Wear],
        Relation::SittingOn => &[Verb::Sit],
        Relation::LyingOn => &[Verb::Lie],
        Relation::Near | Relation::InRoom => &[Verb::Walk],
        Relation::Facing => &[Verb::TurnTo],
        _ => &[],
    }
}

/// The classes that a start names as seats and as held objects, and therefore needs.
fn needed_classes(start: &Goal) -> Vec<String> {
    let named = |part: &Goal| match part {
        Goal::Literal(Literal { predicate: Predicate::Relation(_) | Predicate::Holds, terms }) => {
            terms.iter().find_map(|t| if let Term::Class(class) = t { Some(class.clone()) } else { None })
        }
        _ => None,
    };
    start.conjuncts().iter().filter_map(named).collect()
}
