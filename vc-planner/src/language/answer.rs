//! Reading a model's answer.

use vc_graph::{Action, ActionTextError, NameMismatch, NodeId, ParsedAction, SceneGraph, Verb, Word};

/// The reason why an answer is no action.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AnswerError {
    /// The answer is empty.
    #[error("the answer is empty")]
    Empty,
    /// The answer contains no action.
    #[error("`{0}` is no action; write a verb and what it is about, such as `grab cup.12`")]
    NoAction(String),
    /// The answer names a thing that does not exist.
    #[error("there is no `{name}`; did you mean one of: {like}?")]
    NoSuchThing {
        /// The name as written.
        name: String,
        /// The existing things of that class.
        like: String,
    },
    /// The answer calls a thing what it is not.
    #[error(transparent)]
    Misnamed(#[from] NameMismatch),
    /// The verb takes a different number of things.
    #[error("`{0}`")]
    Arity(#[source] ActionTextError),
}

/// The content of a model's answer.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Answer {
    /// An action.
    Act(Action),
    /// The statement that the task is done.
    Done,
}

/// Reads a model's answer: JSON with an `action`, or text with an action on some line; the usual decorations
/// (quotes, list numbers, code fences, VirtualHome's brackets) are stripped. A class name alone denotes a thing
/// if there is only one of the class.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::language::{Answer, read_answer};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let answer = read_answer("1. I would `grab the apple`", &graph);
/// assert!(answer.is_err());
/// assert_eq!(read_answer("grab the apple", &graph)?, Answer::Act("grab apple.3".parse()?));
/// assert_eq!(read_answer(r#"{"action": "done"}"#, &graph)?, Answer::Done);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`AnswerError`] in words that a model can use.
pub fn read_answer(text: &str, graph: &SceneGraph) -> Result<Answer, AnswerError> {
    let mut problem = None;
    for line in candidate_lines(text) {
        match read_line(&line, graph) {
            Ok(answer) => return Ok(answer),
            // The first line that names a verb shows best what was meant.
            Err(error @ (AnswerError::Empty | AnswerError::NoAction(_))) => problem = problem.or(Some(error)),
            Err(error) => return Err(error),
        }
    }
    Err(problem.unwrap_or(AnswerError::Empty))
}

/// The `action` of the first JSON object, otherwise the lines.
fn candidate_lines(text: &str) -> Vec<String> {
    let object = text.find('{').and_then(|start| {
        let values = serde_json::Deserializer::from_str(&text[start..]).into_iter::<serde_json::Value>().next();
        values.and_then(Result::ok)
    });
    match object.as_ref().and_then(|o| o.get("action")) {
        Some(serde_json::Value::String(action)) => vec![action.clone()],
        _ => text.lines().map(str::to_owned).filter(|l| !l.trim().is_empty()).collect(),
    }
}

fn read_line(line: &str, graph: &SceneGraph) -> Result<Answer, AnswerError> {
    let decorations = |c: char| c.is_whitespace() || "`*\"'-.:>#".contains(c);
    let line = line.trim_matches(decorations);
    let line = line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches([')', '.', ' ']);
    let line = line.strip_prefix("Action:").or_else(|| line.strip_prefix("action:")).unwrap_or(line).trim();
    if line.eq_ignore_ascii_case("done") || line.eq_ignore_ascii_case("stop") {
        return Ok(Answer::Done);
    }
    // Actions with a point or a heading, and those of VirtualHome, are in notations of their own.
    let bracketed = line.starts_with('[');
    match line.parse::<ParsedAction>() {
        Ok(parsed) if parsed.character == 0 && (bracketed || !parsed.action.aim.is_nothing()) => {
            return checked(&parsed, graph).map(Answer::Act);
        }
        Err(_) if bracketed => return Err(AnswerError::NoAction(clip(line))),
        _ => {}
    }
    let mut words =
        line.split([' ', ',', '(', ')']).filter(|w| !w.is_empty() && !FILLERS.contains(&w.to_lowercase().as_str()));
    let verb = words.next().and_then(|w| Verb::parse(&w.to_lowercase()).ok());
    let verb = verb.ok_or_else(|| AnswerError::NoAction(clip(line)))?;
    let things: Result<Vec<NodeId>, AnswerError> = words.map(|w| thing(w, graph)).collect();
    let action = Action::with(verb, &things?).map_err(AnswerError::Arity)?;
    Ok(Answer::Act(action))
}

/// Words between a verb and its things.
const FILLERS: &[&str] = &["the", "a", "an", "to", "on", "in", "into", "onto", "from", "at", "up", "with"];

/// An action whose things exist and are what it calls them.
fn checked(parsed: &ParsedAction, graph: &SceneGraph) -> Result<Action, AnswerError> {
    if let Some(id) = parsed.action.things().find(|id| graph.node(*id).is_none()) {
        let label = parsed.labels.iter().find(|label| label.id == id);
        let name = label.map_or_else(|| id.to_string(), ToString::to_string);
        return Err(missing(&name, label.map_or("", |label| &label.class), graph));
    }
    parsed.check(graph)?;
    Ok(parsed.action)
}

/// The thing that a word names: by class and number, by number, or by a class of which there is one.
fn thing(word: &str, graph: &SceneGraph) -> Result<NodeId, AnswerError> {
    let name = word.trim_matches(|c| "<>\"'`.".contains(c));
    let (class, digits) = name.rsplit_once('.').map_or((None, name), |(class, digits)| (Some(class), digits));
    let number = digits.trim_start_matches('#').parse().ok().map(NodeId);
    match (class, number, &*graph.of_class(class.unwrap_or(name))) {
        (class, Some(id), _) if graph.node(id).is_some() => {
            class.map_or(Ok(()), |class| graph.check_name(class, id))?;
            Ok(id)
        }
        (_, None, [only]) => Ok(*only),
        (class, ..) => Err(missing(name, class.unwrap_or(name), graph)),
    }
}

/// The error for a thing that does not exist, with things of the class that do.
fn missing(name: &str, class: &str, graph: &SceneGraph) -> AnswerError {
    let like: Vec<String> = graph.of_class(class).iter().take(5).map(|&id| graph.label(id).to_string()).collect();
    let like = if like.is_empty() { "nothing of that class".into() } else { like.join(", ") };
    AnswerError::NoSuchThing { name: clip(name), like }
}

fn clip(text: &str) -> String {
    text.chars().take(60).collect()
}
