//! Writing goals of the Embodied Agent Interface. They are read by [`vc_graph::format::eai`] and
//! [`Goal::from_eai`].
//!
//! ```
//! use vc_graph::Goal;
//! use vc_tasks::format::eai;
//! let text = "(exists x0. (TOUCH(x0)) then NEXT_TO(character.1, cat.1000))";
//! assert_eq!(eai::formula(&Goal::from_eai(text)?)?, text);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde_json::{Value, json};
use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Term};
use vc_graph::{NodeId, Relation, Verb, Word};

use super::{ReadError, Unwritable};

const FORMULA: &str = "EAI formula";
const GOAL: &str = "EAI goal";

/// Reads a formula and reports errors with their line.
///
/// ```
/// use vc_tasks::format::eai;
/// let goal = eai::read_formula("ON(light.3)")?;
/// assert_eq!(eai::formula(&goal).ok().as_deref(), Some("ON(light.3)"));
/// assert_eq!(eai::read_formula("ON(light.3").unwrap_err().line, 1);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the place and what was expected there.
pub fn read_formula(text: &str) -> Result<Goal, ReadError> {
    Goal::from_eai(text).map_err(|error| {
        let byte = text.char_indices().nth(error.at.saturating_sub(1)).map_or(text.len(), |(i, _)| i);
        let message = error.problem.to_string();
        let parts = message.strip_prefix("expected ").and_then(|rest| rest.split_once(", found "));
        let (expected, found) = parts.unwrap_or(("a formula", &message));
        ReadError::at(FORMULA, text, byte, expected, found)
    })
}

/// Writes a goal as a formula.
///
/// # Errors
/// [`Unwritable`] for parts that formulas cannot express: classes without a variable, counts of
/// literals, pairs, temporal operators other than `then`.
pub fn formula(goal: &Goal) -> Result<String, Unwritable> {
    let text = part(goal)?;
    match Goal::from_eai(&text) {
        Ok(again) if again == *goal => Ok(text),
        _ => Err(Unwritable::new(FORMULA, goal, "it would be read otherwise")),
    }
}

fn part(goal: &Goal) -> Result<String, Unwritable> {
    match goal {
        Goal::Literal(literal) => atom(literal),
        Goal::And(parts) => list(goal, parts, " and "),
        Goal::Or(parts) => list(goal, parts, " or "),
        Goal::Then(parts) => list(goal, parts, " then "),
        Goal::Not(inner) => Ok(format!("not {}", part(inner)?)),
        Goal::ForAll(q) => quantified(goal, "forall", q),
        Goal::Exists(q) => quantified(goal, "exists", q),
        Goal::ForN { comparison: Comparison::Exactly, number, of } => quantified(goal, &format!("forn {number}."), of),
        _ => Err(Unwritable::new(FORMULA, goal, "it has and, or, not, then, forall, exists and forn")),
    }
}

fn list(goal: &Goal, parts: &[Goal], sign: &str) -> Result<String, Unwritable> {
    if parts.is_empty() {
        return Err(Unwritable::new(FORMULA, goal, "it has no empty lists"));
    }
    let parts = parts.iter().map(part).collect::<Result<Vec<_>, _>>()?;
    Ok(format!("({})", parts.join(sign)))
}

fn quantified(goal: &Goal, word: &str, q: &Quantified) -> Result<String, Unwritable> {
    if q.class.is_some() {
        return Err(Unwritable::new(FORMULA, goal, "its variables have no class"));
    }
    Ok(format!("{word} {}. ({})", q.variable, bare(part(&q.body)?)))
}

/// Removes the brackets around the whole text.
fn bare(text: String) -> String {
    let whole = text.starts_with('(') && {
        let mut depth = 0_i64;
        let closes = text.bytes().position(|b| {
            depth += i64::from(b == b'(') - i64::from(b == b')');
            depth == 0
        });
        closes == Some(text.len() - 1)
    };
    if whole { text[1..text.len() - 1].to_owned() } else { text }
}

fn atom(literal: &Literal) -> Result<String, Unwritable> {
    let word = word(literal.predicate).ok_or_else(|| Unwritable::new(FORMULA, literal, "it has no such predicate"))?;
    let terms = literal.terms.iter().map(|term| match term {
        Term::Node(Some(class), id) => Ok(format!("{class}.{}", id.0)),
        Term::Variable(name) => Ok(name.clone()),
        Term::Me => Ok("character.1".to_owned()),
        Term::Class(class) => Ok(class.clone()),
        _ => Err(Unwritable::new(FORMULA, literal, "things are written `class.12`")),
    });
    Ok(format!("{word}({})", terms.collect::<Result<Vec<_>, _>>()?.join(", ")))
}

fn word(predicate: Predicate) -> Option<String> {
    Some(match predicate {
        Predicate::State(state) => state.as_str().to_uppercase(),
        Predicate::Relation(Relation::On) => "ONTOP".to_owned(),
        Predicate::Relation(Relation::Inside) => "INSIDE".to_owned(),
        Predicate::Relation(Relation::Near) => "NEXT_TO".to_owned(),
        Predicate::Relation(Relation::Facing) => "FACING".to_owned(),
        Predicate::Relation(Relation::Between) => "BETWEEN".to_owned(),
        Predicate::Relation(Relation::HoldsRight) => "HOLDS_RH".to_owned(),
        Predicate::Relation(Relation::HoldsLeft) => "HOLDS_LH".to_owned(),
        Predicate::Did(verb) => virtual_home(verb)?.to_owned(),
        _ => return None,
    })
}

/// VirtualHome's name for a verb.
fn virtual_home(verb: Verb) -> Option<&'static str> {
    verb.virtualhome()
}

/// Writes a goal as JSON lists of states, edges and actions.
///
/// # Errors
/// [`Unwritable`] for all but conjunctions of actions on anything and of states and relations of
/// given nodes.
pub fn goal(goal: &Goal) -> Result<String, Unwritable> {
    let (mut actions, mut parts) = (Vec::new(), Vec::new());
    for part in goal.conjuncts() {
        match (done(part), held(part)) {
            (Some(action), _) if parts.is_empty() => actions.push(Value::String(action)),
            (None, Some(value)) => parts.push(value),
            _ => return Err(Unwritable::new(GOAL, part, "it lists what is done, then states and relations of nodes")),
        }
    }
    Ok(json!({ "actions": actions, "goal": parts }).to_string())
}

/// `TOUCH|PUSH`.
fn done(goal: &Goal) -> Option<String> {
    match goal {
        Goal::Literal(Literal { predicate: Predicate::Did(verb), terms }) => {
            terms.iter().all(|t| *t == Term::Anything).then(|| virtual_home(*verb).map(str::to_owned)).flatten()
        }
        Goal::Or(parts) if !parts.is_empty() => {
            let words = parts.iter().map(|p| if matches!(p, Goal::Literal(_)) { done(p) } else { None });
            Some(words.collect::<Option<Vec<_>>>()?.join("|"))
        }
        _ => None,
    }
}

fn held(goal: &Goal) -> Option<Value> {
    let Goal::Literal(literal) = goal else { return None };
    match (literal.predicate, &*literal.terms) {
        (Predicate::State(state), [Term::Node(Some(class), NodeId(id))]) => {
            Some(json!({ "id": id, "class_name": class, "state": state.as_str().to_uppercase() }))
        }
        (Predicate::Relation(relation), [Term::Node(None, NodeId(from)), Term::Node(None, NodeId(to))]) => {
            let word = match relation {
                Relation::On => "ON",
                Relation::Inside => "INSIDE",
                Relation::Between => "BETWEEN",
                Relation::Near => "CLOSE",
                Relation::Facing => "FACING",
                Relation::HoldsRight => "HOLDS_RH",
                Relation::HoldsLeft => "HOLDS_LH",
                Relation::SittingOn => "SITTING",
                _ => return None,
            };
            Some(json!({ "from_id": from, "relation_type": word, "to_id": to }))
        }
        _ => None,
    }
}
