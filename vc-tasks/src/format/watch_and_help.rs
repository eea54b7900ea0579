//! Goals of Watch-And-Help: predicates and counts, `{"on_plate_kitchentable": 2}`.
//!
//! | key | holds if at least this many |
//! |---|---|
//! | `on_A_B`, `inside_A_B` | A are on, are inside B |
//! | `offOn_A_B`, `offInside_A_B` | whatever the count: no A is on, is inside B |
//! | `holds_A_agent` | A are held |
//! | `sit_agent_A` | agents sit on A |
//! | `turnOn_A_1` | A are switched on |
//!
//! A and B are a class, `plate`, or the number of a node, `73`; an agent is `character`, the agent
//! that does the task, or a number. The count may be the first element of a list with whether it is
//! required and its reward, as in the environments; only the count is read.
//!
//! ```
//! use vc_tasks::format::watch_and_help;
//! let goal = watch_and_help::read(r#"{"on_plate_kitchentable": 2, "turnOn_12_1": 1}"#)?;
//! assert_eq!(goal.to_string(), "On(plate, kitchentable), 2 & SwitchedOn(#12)");
//! assert_eq!(watch_and_help::write(&goal)?, r#"{"on_plate_kitchentable": 2, "turnOn_12_1": 1}"#);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde_json::Value;
use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Term};
use vc_graph::{NodeId, Relation, State, clip};

use super::error::Entries;
use super::{ReadError, Unwritable};

const FORMAT: &str = "Watch-And-Help goal";

/// Reads a goal.
///
/// ```
/// use vc_tasks::format::watch_and_help::read;
/// assert_eq!(read(r#"{"inside_apple_fridge": 2}"#)?.to_string(), "Inside(apple, fridge), 2");
/// assert!(read(r#"{"juggle_apple": 2}"#).is_err());
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the invalid key.
pub fn read(text: &str) -> Result<Goal, ReadError> {
    let Entries(entries) = super::error::from_json(FORMAT, text)?;
    let parts = entries.iter().map(|(key, value)| {
        part(key, value).map_err(|(expected, found)| {
            let at = text.find(&format!("\"{key}\"")).unwrap_or(0);
            ReadError::at(FORMAT, text, at, expected, found)
        })
    });
    let mut parts = parts.collect::<Result<Vec<Goal>, ReadError>>()?;
    Ok(if parts.len() == 1 { parts.remove(0) } else { Goal::And(parts) })
}

type Fault = (&'static str, String);

fn part(key: &str, value: &Value) -> Result<Goal, Fault> {
    let first = value.as_array().and_then(|list| list.first()).unwrap_or(value);
    let number = first.as_u64().and_then(|n| u32::try_from(n).ok());
    let number = number.ok_or_else(|| ("a number", format!("`{}`", clip(&value.to_string()))))?;
    let (word, rest) = key.split_once('_').ok_or_else(|| (KEY, format!("`{}`", clip(key))))?;
    let (a, b) = rest.rsplit_once('_').ok_or_else(|| (KEY, format!("`{}`", clip(key))))?;
    let [first, second] = [a, b].map(term);
    let (literal, absent) = match word {
        "on" | "offOn" => (literal(Relation::On, first, second), word == "offOn"),
        "inside" | "offInside" => (literal(Relation::Inside, first, second), word == "offInside"),
        "holds" => (Literal { predicate: Predicate::Holds, terms: vec![second, first] }, false),
        "sit" => (literal(Relation::SittingOn, first, second), false),
        "turnOn" => (Literal { predicate: Predicate::State(State::On), terms: vec![first] }, false),
        _ => return Err((KEY, format!("`{}`", clip(key)))),
    };
    Ok(match number {
        _ if absent => Goal::Count { literal, comparison: Comparison::AtMost, number: 0 },
        1 => Goal::Literal(literal),
        _ => Goal::Count { literal, comparison: Comparison::AtLeast, number },
    })
}

const KEY: &str =
    "`on_A_B`, `inside_A_B`, `offOn_A_B`, `offInside_A_B`, `holds_A_agent`, `sit_agent_A` or `turnOn_A_1`";

fn literal(relation: Relation, first: Term, second: Term) -> Literal {
    Literal { predicate: Predicate::Relation(relation), terms: vec![first, second] }
}

fn term(word: &str) -> Term {
    match word.parse() {
        Ok(id) => Term::Node(None, NodeId(id)),
        Err(_) if word == "character" => Term::Me,
        Err(_) => Term::Class(word.to_owned()),
    }
}

/// Writes a goal.
///
/// # Errors
/// [`Unwritable`] for all but conjunctions of the predicates above, with "at least" counts or as
/// absent.
pub fn write(goal: &Goal) -> Result<String, Unwritable> {
    let entries = goal.conjuncts().iter().map(entry).collect::<Result<Vec<_>, _>>()?;
    let text = format!("{{{}}}", entries.join(", "));
    match read(&text) {
        Ok(again) if again == *goal => Ok(text),
        _ => Err(Unwritable::new(FORMAT, goal, "its keys would be read otherwise")),
    }
}

fn entry(part: &Goal) -> Result<String, Unwritable> {
    let (literal, number, absent) = match part {
        Goal::Literal(literal) => (literal, 1, false),
        Goal::Count { literal, comparison: Comparison::AtLeast, number } => (literal, *number, false),
        Goal::Count { literal, comparison: Comparison::AtMost, number: 0 } => (literal, 1, true),
        _ => return Err(Unwritable::new(FORMAT, part, "it lists predicates and how often they hold")),
    };
    let terms = literal.terms.iter().map(word).collect::<Option<Vec<String>>>();
    let key = terms.and_then(|terms| key(literal.predicate, &terms, absent));
    let key = key.ok_or_else(|| Unwritable::new(FORMAT, part, "it has no such predicate"))?;
    Ok(format!("{}: {number}", Value::String(key)))
}

fn key(predicate: Predicate, terms: &[String], absent: bool) -> Option<String> {
    Some(match (predicate, terms) {
        (Predicate::Relation(Relation::On), [a, b]) => format!("{}_{a}_{b}", if absent { "offOn" } else { "on" }),
        (Predicate::Relation(Relation::Inside), [a, b]) => {
            format!("{}_{a}_{b}", if absent { "offInside" } else { "inside" })
        }
        _ if absent => return None,
        (Predicate::Holds, [agent, a]) => format!("holds_{a}_{agent}"),
        (Predicate::Relation(Relation::SittingOn), [agent, a]) => format!("sit_{agent}_{a}"),
        (Predicate::State(State::On), [a]) => format!("turnOn_{a}_1"),
        _ => return None,
    })
}

fn word(term: &Term) -> Option<String> {
    match term {
        Term::Class(class) => Some(class.clone()),
        Term::Node(None, id) => Some(id.0.to_string()),
        Term::Me => Some("character".to_owned()),
        _ => None,
    }
}
