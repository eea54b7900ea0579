//! Goals as the thesis writes them: a predicate and its count, one a line.
//!
//! ```text
//! On(breakfast, kitchen table), 1
//! Sit(kitchen chair), 1
//! Eat(breakfast), 1
//! ```
//!
//! Lines may be joined by commas. A missing count means one.

use vc_graph::format::unmarked;
use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Term};
use vc_graph::{Relation, State, Verb, Word};

use super::{ReadError, Unwritable};

const FORMAT: &str = "thesis goal";

/// Reads a goal.
///
/// ```
/// use vc_tasks::format::thesis;
/// let goal = thesis::read("On(apple, kitchentable), 3\nSit(kitchen chair), 1\n")?;
/// assert_eq!(thesis::write(&goal)?, "On(apple, kitchentable), 3\nSit(kitchen_chair), 1\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the line.
pub fn read(text: &str) -> Result<Goal, ReadError> {
    let mut parts = Vec::new();
    for (index, line) in unmarked(text).lines().enumerate().filter(|(_, l)| !l.trim().is_empty()) {
        let goal: Goal = line.parse().map_err(|error| read_error(index + 1, &error))?;
        parts.extend(goal.conjuncts().iter().cloned());
    }
    match parts.iter().find(|part| !counts(part)) {
        Some(other) => {
            let line = text.lines().position(|l| l.parse::<Goal>().is_ok_and(|g| g.conjuncts().contains(other)));
            let at = line.unwrap_or(0) + 1;
            let (expected, found) = ("a predicate and how often, `On(a, b), 3`".to_owned(), format!("`{other}`"));
            Err(ReadError { format: FORMAT, file: None, line: at, column: 1, expected, found })
        }
        None => Ok(if parts.len() == 1 { parts.remove(0) } else { Goal::And(parts) }),
    }
}

/// Whether a part is a literal or an "at least" count of one.
fn counts(part: &Goal) -> bool {
    matches!(part, Goal::Literal(_) | Goal::Count { comparison: Comparison::AtLeast, .. })
}

fn read_error(line: usize, error: &vc_graph::goal::GoalError) -> ReadError {
    let message = error.problem.to_string();
    let unexpected = message.strip_prefix("expected ").and_then(|rest| rest.split_once(", found "));
    let (expected, found) = unexpected.unwrap_or(("a goal such as `On(a, b), 3`", &message));
    ReadError {
        format: FORMAT,
        file: None,
        line,
        column: error.at,
        expected: expected.to_owned(),
        found: found.to_owned(),
    }
}

/// Writes a goal, one part a line.
///
/// ```
/// use vc_tasks::format::thesis;
/// let text = thesis::write(&"On(apple, table)".parse()?)?;
/// assert_eq!(thesis::read(&text)?.to_string(), "On(apple, table)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Unwritable`] for all but conjunctions of literals and "at least" counts of them.
pub fn write(goal: &Goal) -> Result<String, Unwritable> {
    let lines = goal.conjuncts().iter().map(line).collect::<Result<Vec<_>, _>>()?;
    let text: String = lines.concat();
    match read(&text) {
        Ok(again) if again == *goal => Ok(text),
        _ => Err(Unwritable::new(FORMAT, goal, "it would be read otherwise")),
    }
}

fn line(part: &Goal) -> Result<String, Unwritable> {
    let (literal, number) = match part {
        Goal::Literal(literal) => (literal, 1),
        Goal::Count { literal, comparison: Comparison::AtLeast, number } => (literal, *number),
        _ => return Err(Unwritable::new(FORMAT, part, "it lists predicates and how often they hold")),
    };
    Ok(format!("{}, {number}\n", words(literal)))
}

/// The thesis's form of a literal, if it is read as the same literal: `Sit(chair)`.
fn words(literal: &Literal) -> String {
    let full = literal.to_string();
    let name = match literal.predicate {
        Predicate::Relation(Relation::SittingOn) => "Sit".to_owned(),
        Predicate::Relation(Relation::LyingOn) => "Lie".to_owned(),
        Predicate::Relation(Relation::Inside) => "In".to_owned(),
        Predicate::Relation(Relation::Near) => "Walk".to_owned(),
        Predicate::Holds => "Grab".to_owned(),
        Predicate::State(State::On) => "SwitchOn".to_owned(),
        Predicate::Did(verb) => titled(verb),
        _ => return full,
    };
    let others = literal.terms.iter().skip_while(|t| **t == Term::Me).map(Term::to_string);
    let short = format!("{name}({})", others.collect::<Vec<_>>().join(", "));
    let same = short.parse() == Ok(Goal::Literal(literal.clone()));
    if same { short } else { full }
}

/// `put_in` becomes `PutIn`.
fn titled(verb: Verb) -> String {
    verb.as_str().split('_').map(|part| part[..1].to_uppercase() + &part[1..]).collect()
}
