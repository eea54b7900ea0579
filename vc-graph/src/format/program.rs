//! VirtualHome's programs: one action per line.
//!
//! ```text
//! Make coffee
//! Lines before the first action are title and description, up to a blank line.
//!
//! # A comment.
//! [WALK] <kitchen> (11)
//! <char0> [GRAB] <cup> (12) | <char1> [WALK] <kitchen> (11)
//! ```
//!
//! Simultaneous actions of several characters share a line. A line that looks like an action but is invalid is
//! an error, wherever it stands; a title that is also a verb, `Sleep`, is a title if a blank line follows.

use super::{FormatError, FormatProblem, LARGEST, unmarked};
use crate::simulator::Event;
use crate::{Action, ActionTextError, AimWord, Label, NameMismatch, ParsedAction, SceneGraph, Verb, Word};

/// A program: a sequence of actions of one or more characters.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Program {
    /// Title and description; may be empty.
    pub heading: Vec<String>,
    /// The actions, step by step: each step has one action, or one for each of several characters.
    pub steps: Vec<Vec<ParsedAction>>,
}

/// The reason why a program does not match a scene, regardless of its actions' preconditions.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CastError {
    /// A character of the program does not exist in the scene.
    #[error("action {step}: there is no `<char{character}>`, the scene has {}", characters(*.agents))]
    NoSuchCharacter {
        /// The step, counted from one.
        step: usize,
        /// The character's number.
        character: u32,
        /// The number of characters in the scene.
        agents: usize,
    },
    /// An object is of another class than its label says.
    #[error("action {step}: {mismatch}")]
    NameMismatch {
        /// The step, counted from one.
        step: usize,
        /// The object's label in the program and in the scene.
        #[source]
        mismatch: NameMismatch,
    },
}

fn characters(number: usize) -> String {
    match number {
        0 => "no character".into(),
        1 => "one character, `<char0>`".into(),
        n => format!("{n} characters, `<char0>` to `<char{}>`", n - 1),
    }
}

impl Program {
    /// A program of one character, without title.
    ///
    /// ```
    /// use vc_graph::format::program::{self, Program};
    /// use vc_graph::{Action, Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// let program = Program::from_actions([Action::walk(apple), Action::grab(apple)]);
    /// assert_eq!(program::write(&program, &graph)?, "[WALK] <apple> (3)\n[GRAB] <apple> (3)\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_actions(actions: impl IntoIterator<Item = Action>) -> Self {
        Self { heading: Vec::new(), steps: actions.into_iter().map(|action| vec![action.into()]).collect() }
    }

    /// The actions of all characters in the order in which they are written.
    pub fn actions(&self) -> impl Iterator<Item = Action> + '_ {
        self.steps.iter().flatten().map(|parsed| parsed.action)
    }

    /// The actions with the agents of a scene that perform them, step by step: `<char0>` is the scene's first
    /// agent, `<char1>` its second.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator, format::program};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("cup"))?;
    /// let agents = [scene.add_in(kitchen, Draft::new("character"))?, scene.add_in(kitchen, Draft::new("character"))?];
    /// let mut world = Simulator::new(scene.build());
    /// let program = program::read("<char0> [WALK] <cup> (2) | <char1> [STANDUP]\n<char1> [WALK] <cup> (2)")?;
    /// let cast = program.cast(world.graph())?;
    /// assert_eq!((cast[0][0].agent, cast[1][0].agent), (agents[0], agents[1]));
    /// assert!(world.step_together(&cast[1]).is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CastError`]: a missing character, or an object of another class than its label says.
    pub fn cast(&self, graph: &SceneGraph) -> Result<Vec<Vec<Event>>, CastError> {
        let agents = graph.agents();
        let event = |step: usize, parsed: &ParsedAction| {
            let missing =
                || CastError::NoSuchCharacter { step: step + 1, character: parsed.character, agents: agents.len() };
            let agent = *agents.get(parsed.character as usize).ok_or_else(missing)?;
            parsed.check(graph).map_err(|mismatch| CastError::NameMismatch { step: step + 1, mismatch })?;
            Ok(Event { agent, action: parsed.action })
        };
        let step = |(i, actions): (usize, &Vec<ParsedAction>)| actions.iter().map(|parsed| event(i, parsed)).collect();
        self.steps.iter().enumerate().map(step).collect()
    }
}

/// Parses a program in VirtualHome's notation or VirtualCity's.
///
/// ```
/// use vc_graph::format::program;
/// let program = program::read("Drink\n\n[WALK] <kitchen> (11)\n[GRAB] <cup> (12)\n")?;
/// assert_eq!(program.heading, ["Drink"]);
/// assert_eq!(program.steps.len(), 2);
/// # Ok::<(), vc_graph::format::FormatError>(())
/// ```
///
/// # Errors
/// [`FormatError`], with the line that is not an action.
pub fn read(text: &str) -> Result<Program, FormatError> {
    let fail = |line: usize, problem: FormatProblem| FormatError {
        format: "program",
        line: Some(line + 1),
        field: String::new(),
        problem: Box::new(problem),
    };
    if text.len() > LARGEST {
        return Err(fail(0, FormatProblem::TooLarge(text.len())));
    }
    let lines = text.lines().map(|line| unmarked(line.trim_start()).trim()).enumerate();
    let lines: Vec<(usize, &str)> = lines.filter(|(_, line)| !line.starts_with('#')).collect();
    let (heading, rest) = lines.split_at(heading(&lines));
    let written = |line: &&(usize, &str)| !line.1.is_empty();
    let mut program = Program::default();
    program.heading.extend(heading.iter().filter(written).map(|(_, line)| (*line).to_owned()));
    for (index, line) in rest.iter().filter(written) {
        program.steps.push(step(line).map_err(|problem| fail(*index, problem))?);
    }
    Ok(program)
}

/// Parses the actions in a line, of one character or of several: `<char0> [..] | <char1> [..]`.
pub(super) fn step(line: &str) -> Result<Vec<ParsedAction>, FormatProblem> {
    let actions: Vec<ParsedAction> = line.split('|').map(str::parse).collect::<Result<_, ActionTextError>>()?;
    let twice = |(i, parsed): (usize, &ParsedAction)| actions[..i].iter().any(|d| d.character == parsed.character);
    match actions.iter().enumerate().find(|&(i, parsed)| twice((i, parsed))) {
        Some((_, parsed)) => Err(FormatProblem::ActsTwice(parsed.character)),
        None => Ok(actions),
    }
}

/// The number of lines before the first action.
fn heading(lines: &[(usize, &str)]) -> usize {
    let blank = |line: &&(usize, &str)| line.1.is_empty();
    let start = lines.iter().take_while(blank).count();
    let end = start + lines[start..].iter().take_while(|line| !blank(line)).count();
    let (first, rest) = (&lines[start..end], &lines[end..]);
    let is_step = |line: &(usize, &str)| step(line.1).is_ok();
    let title = !rest.is_empty()
        && !first.iter().any(|line| is_meant_as_step(line.1))
        && (!first.iter().all(is_step) || !rest.iter().all(|line| blank(&line)));
    let sure = if title { end } else { start };
    let more = lines[sure..].iter().take_while(|line| blank(line) || !is_meant_as_step(line.1) && !is_step(line));
    sure + more.count()
}

/// The most numbers of a point.
const POINT: usize = 3;

/// Whether a line has the form of an action, valid or not: in VirtualHome's brackets, or as a verb with labels.
fn is_meant_as_step(line: &str) -> bool {
    let verb = |text: &str| {
        let word = text.split(']').next().unwrap_or_default().trim();
        Verb::from_virtualhome(word).is_some() || Verb::parse(word).is_ok()
    };
    let labelled = |line: &str| {
        let thing = |word: &str| word.parse::<Label>().is_ok() || word.strip_prefix('#').is_some_and(is_number);
        let names = line.split_whitespace().nth(1).is_some_and(thing);
        let mut words = line.split_whitespace().skip(1).skip_while(|word| thing(word));
        let aim = words.next();
        // `Walk at night` is a title; `walk at x 2.0` is a point with a fault.
        let values: Vec<&str> = words.take_while(|word| !AimWord::is_one(word)).collect();
        let counts = |word: &&str| word.parse::<f64>().is_ok();
        let acts = || line.split_whitespace().next().is_some_and(|word| Verb::parse(word).is_ok());
        let point = values.len() <= POINT && values.iter().any(counts) && acts();
        let says = names || point || values.first().is_some_and(counts);
        says && aim.map_or(names, AimWord::is_one)
    };
    // One whose opening bracket was lost: `WALK] <cup> (12)`.
    let unopened = |line: &str| line.split_once(']').is_some_and(|(word, _)| verb(word));
    line.starts_with(['[', '<'])
        || line.split('[').skip(1).any(verb)
        || unopened(unnumbered(line))
        || names_thing(line)
        || labelled(unnumbered(line))
}

/// Whether a line names an object in VirtualHome's notation, `<cup> (12)`.
fn names_thing(line: &str) -> bool {
    let number = |after: &str| {
        let inner = after.trim_start().strip_prefix('(').and_then(|text| text.split(')').next());
        inner.is_some_and(|number| is_number(number.trim()))
    };
    line.split('<').skip(1).any(|text| text.split_once('>').is_some_and(|(_, after)| number(after)))
}

/// The line without a leading number, `1. `.
fn unnumbered(line: &str) -> &str {
    let number = line.split_whitespace().next().unwrap_or_default();
    let counts = is_number(number.trim_end_matches(['.', ')', ':']));
    if counts { line[number.len()..].trim_start() } else { line }
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Writes a program in VirtualHome's notation, with a scene's class names. Characters are written unless the
/// first one performs all actions.
///
/// # Errors
/// [`ActionTextError::NotInVirtualHome`] for a verb that VirtualHome does not have,
/// [`ActionTextError::AimNotInVirtualHome`] for an action with a point, say: [`write_native`] writes these.
pub fn write(program: &Program, graph: &SceneGraph) -> Result<String, ActionTextError> {
    written(program, |action| action.to_virtualhome(graph))
}

/// Writes a program in VirtualCity's notation, with a scene's labels; otherwise as [`write`](fn@write).
///
/// ```
/// use vc_graph::format::program;
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let graph = scene.build();
/// let program = program::read("walk at 3.2 1.5 yaw 90\nturn_to #1")?;
/// let text = program::write_native(&program, &graph);
/// assert_eq!(text, "walk at 3.20 1.50 yaw 90\nturn_to kitchen.1\n");
/// assert!(program::read(&text)?.actions().eq(program.actions()));
/// assert!(program::write(&program, &graph).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_native(program: &Program, graph: &SceneGraph) -> String {
    let text = written(program, |action| Ok::<_, std::convert::Infallible>(action.describe(graph).to_string()));
    text.unwrap_or_else(|never| match never {})
}

fn written<E>(program: &Program, action: impl Fn(&Action) -> Result<String, E>) -> Result<String, E> {
    let mut text: String = program.heading.iter().map(|line| format!("{line}\n")).collect();
    if !text.is_empty() {
        text.push('\n');
    }
    let several = program.steps.iter().flatten().any(|parsed| parsed.character > 0);
    let written = |parsed: &ParsedAction| {
        let action = action(&parsed.action)?;
        Ok(if several { format!("<char{}> {action}", parsed.character) } else { action })
    };
    for step in &program.steps {
        let actions: Vec<String> = step.iter().map(written).collect::<Result<_, E>>()?;
        text.push_str(&actions.join(" | "));
        text.push('\n');
    }
    Ok(text)
}
