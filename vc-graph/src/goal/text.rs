//! Reading goals.

use std::str::FromStr;

use super::{Comparison, Goal, Literal, Predicate, Quantified, Term};
use crate::vocabulary::{Word, clip, same_word};
use crate::{NodeId, Relation, State, Verb};

/// Longest goal that is read, bytes.
const LONGEST: usize = 64 * 1024;
/// Deepest goal that is read: parts within parts.
const DEEPEST: usize = 60;
/// Deepest nesting in the text: a goal that is written may have a bracket for each
/// part.
const NESTED: usize = 2 * DEEPEST + 2;

/// Where a goal is wrong.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("goal, character {at}: {problem}")]
pub struct GoalError {
    /// Character, counted from one.
    pub at: usize,
    /// What is wrong there.
    pub problem: GoalProblem,
}

/// What is wrong with a goal.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalProblem {
    /// Something else should stand here.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// No such predicate.
    #[error("unknown predicate `{0}`; use a state (Open, Clean), a relation (On, Inside, Near) or a verb (Sit, Eat)")]
    Predicate(String),
    /// A predicate with the wrong number of things.
    #[error("`{predicate}` takes {takes} things, {given} are given")]
    Arity {
        /// The predicate.
        predicate: String,
        /// How many it takes.
        takes: usize,
        /// How many there are.
        given: usize,
    },
    /// A variable no quantifier binds.
    #[error("no forall or exists binds the variable `?{0}`")]
    Unbound(String),
    /// Too long.
    #[error("goals are at most {LONGEST} bytes long, this one has {0}")]
    TooLong(usize),
    /// Too deep.
    #[error("goals nest at most {DEEPEST} levels deep")]
    TooDeep,
}

impl FromStr for Goal {
    type Err = GoalError;

    fn from_str(text: &str) -> Result<Self, GoalError> {
        read(text, Dialect::Native)
    }
}

impl Goal {
    /// Reads a goal formula of the Embodied Agent Interface, such as
    /// `(exists x0. (TYPE(x0)) then ON(computer.417))`. Its verbs are things done,
    /// its `ONTOP` is our `On`, its `NEXT_TO` our `Near`, and `character` the agent.
    ///
    /// ```
    /// use vc_graph::Goal;
    /// let goal = Goal::from_eai("(exists x0. (TOUCH(x0)) then NEXT_TO(character.65, cat.1000))")?;
    /// assert_eq!(goal.to_string(), "(exists ?x0. did touch(?x0)) then Near(me, cat.1000)");
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    ///
    /// # Errors
    /// [`GoalError`] says where and what was expected.
    pub fn from_eai(text: &str) -> Result<Self, GoalError> {
        read(text, Dialect::Eai)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dialect {
    Native,
    Eai,
}

fn read(text: &str, dialect: Dialect) -> Result<Goal, GoalError> {
    if text.len() > LONGEST {
        return Err(GoalError { at: 1, problem: GoalProblem::TooLong(text.len()) });
    }
    let tokens = scan(text)?;
    let mut reader = Reader { tokens, next: 0, end: text.chars().count() + 1, dialect, bound: Vec::new(), depth: 0 };
    let goal = reader.goal()?;
    match reader.peek() {
        None if goal.depth() > DEEPEST => Err(GoalError { at: 1, problem: GoalProblem::TooDeep }),
        None => Ok(goal),
        Some(_) => Err(reader.expected("`&`, `|`, `then` or the end")),
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    /// A name, number, `?variable`, `#12` or `cup.12`.
    Name(String),
    /// `(`, `)`, `,`, `:`, `.`, `!`, `&`, `|`, `=`, `<=`, `>=`.
    Sign(&'static str),
}

const SIGNS: [&str; 15] = ["<=", ">=", "==", "&&", "||", "(", ")", ",", ":", ".", "!", "&", "|", "=", ";"];

fn scan(text: &str) -> Result<Vec<(usize, Token)>, GoalError> {
    let chars: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        let start = at;
        let sign = SIGNS.iter().find(|s| s.chars().enumerate().all(|(i, c)| chars.get(at + i) == Some(&c)));
        if chars[at].is_whitespace() {
            at += 1;
        } else if let Some(sign) = sign {
            at += sign.len();
            tokens.push((start + 1, Token::Sign(sign)));
        } else if is_name(chars[at]) || matches!(chars[at], '?' | '#' | '*') {
            at += 1;
            while at < chars.len() && (is_name(chars[at]) || number_follows(&chars, at)) {
                at += 1;
            }
            tokens.push((start + 1, Token::Name(chars[start..at].iter().collect())));
        } else {
            let found = format!("`{}`", chars[at]);
            let problem = GoalProblem::Expected { expected: "a name, a number or one of `( ) , : . ! & |`", found };
            return Err(GoalError { at: start + 1, problem });
        }
    }
    Ok(tokens)
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '-'
}

/// Whether a dot at this place joins a class and a number, `cup.12`.
fn number_follows(chars: &[char], at: usize) -> bool {
    chars[at] == '.' && chars.get(at + 1).is_some_and(char::is_ascii_digit)
}

struct Reader {
    tokens: Vec<(usize, Token)>,
    next: usize,
    end: usize,
    dialect: Dialect,
    bound: Vec<String>,
    depth: usize,
}

impl Reader {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next).map(|(_, token)| token)
    }

    fn at(&self) -> usize {
        self.tokens.get(self.next).map_or(self.end, |(at, _)| *at)
    }

    fn error(&self, problem: GoalProblem) -> GoalError {
        GoalError { at: self.at(), problem }
    }

    fn expected(&self, expected: &'static str) -> GoalError {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some(Token::Name(name)) => format!("`{}`", clip(name)),
            Some(Token::Sign(sign)) => format!("`{sign}`"),
        };
        self.error(GoalProblem::Expected { expected, found })
    }

    /// Takes one of some signs or keywords.
    fn take(&mut self, any: &[&str]) -> bool {
        let found = match self.peek() {
            Some(Token::Sign(sign)) => any.contains(sign),
            Some(Token::Name(name)) => any.iter().any(|word| name.eq_ignore_ascii_case(word)),
            None => false,
        };
        self.next += usize::from(found);
        found
    }

    fn demand(&mut self, sign: &'static str, expected: &'static str) -> Result<(), GoalError> {
        if self.take(&[sign]) { Ok(()) } else { Err(self.expected(expected)) }
    }

    fn name(&mut self, expected: &'static str) -> Result<String, GoalError> {
        match self.peek() {
            Some(Token::Name(name)) => {
                let name = name.clone();
                self.next += 1;
                Ok(name)
            }
            _ => Err(self.expected(expected)),
        }
    }

    fn goal(&mut self) -> Result<Goal, GoalError> {
        self.list(&["then"], Goal::Then, |r| {
            r.list(&["|", "||", "or"], Goal::Or, |r| r.list(&["&", "&&", ";", "and"], Goal::And, Self::unary))
        })
    }

    fn list(
        &mut self,
        signs: &[&str],
        build: fn(Vec<Goal>) -> Goal,
        mut part: impl FnMut(&mut Self) -> Result<Goal, GoalError>,
    ) -> Result<Goal, GoalError> {
        let first = part(self)?;
        let mut parts = vec![first];
        while self.take(signs) || (signs.contains(&"&") && self.comma_before_predicate()) {
            parts.push(part(self)?);
        }
        let single = parts.len() == 1;
        Ok(if single { parts.remove(0) } else { build(parts) })
    }

    /// `On(a, b), 1, Sit(c), 1`: the comma after a literal joins the next.
    fn comma_before_predicate(&mut self) -> bool {
        let rest = &self.tokens[self.next.min(self.tokens.len())..];
        let joins = matches!(rest, [(_, Token::Sign(",")), (_, Token::Name(_)), (_, Token::Sign("(")), ..]);
        self.next += usize::from(joins);
        joins
    }

    fn unary(&mut self) -> Result<Goal, GoalError> {
        self.depth += 1;
        if self.depth > NESTED {
            return Err(self.error(GoalProblem::TooDeep));
        }
        let goal = self.simple();
        self.depth -= 1;
        goal
    }

    fn simple(&mut self) -> Result<Goal, GoalError> {
        if self.take(&["!", "not"]) {
            return Ok(Goal::Not(Box::new(self.unary()?)));
        }
        if self.take(&["forall"]) {
            return self.quantified().map(Goal::ForAll);
        }
        if self.take(&["exists"]) {
            return self.quantified().map(Goal::Exists);
        }
        if self.take(&["("]) {
            let goal = self.goal()?;
            self.demand(")", "`)`")?;
            return Ok(goal);
        }
        if self.take(&["true"]) {
            return Ok(Goal::And(Vec::new()));
        }
        if self.take(&["false"]) {
            return Ok(Goal::Or(Vec::new()));
        }
        self.counted()
    }

    fn quantified(&mut self) -> Result<Quantified, GoalError> {
        let not_a_variable = self.expected("a variable such as `?x`");
        let name = self.name("a variable such as `?x`")?;
        let variable = name.strip_prefix('?').unwrap_or(&name).to_owned();
        if variable.is_empty() || !variable.chars().all(is_name) {
            return Err(not_a_variable);
        }
        let class = if self.take(&[":"]) { Some(self.name("a class")?) } else { None };
        self.demand(".", "`.` after the variable")?;
        self.bound.push(variable.clone());
        // EAI's quantifiers end with the bracket that follows them.
        let body = if self.dialect == Dialect::Eai { self.unary() } else { self.goal() };
        self.bound.pop();
        Ok(Quantified { variable, class, body: Box::new(body?) })
    }

    fn counted(&mut self) -> Result<Goal, GoalError> {
        let literal = self.literal()?;
        let rest = &self.tokens[self.next.min(self.tokens.len())..];
        let counts = match rest {
            [(_, Token::Sign(",")), (_, Token::Sign("=" | "==" | "<=" | ">=")), ..] => true,
            [(_, Token::Sign(",")), (_, Token::Name(name)), ..] => name.chars().all(|c| c.is_ascii_digit()),
            _ => false,
        };
        if !counts {
            return Ok(Goal::Literal(literal));
        }
        self.next += 1;
        let comparison = match self.peek() {
            Some(Token::Sign("=" | "==")) => Comparison::Exactly,
            Some(Token::Sign("<=")) => Comparison::AtMost,
            _ => Comparison::AtLeast,
        };
        self.take(&["=", "==", "<=", ">="]);
        let not_a_number = self.expected("a number");
        let number = self.name("a number")?.parse().map_err(|_| not_a_number)?;
        match (comparison, number) {
            (Comparison::AtLeast, 1) => Ok(Goal::Literal(literal)),
            _ => Ok(Goal::Count { literal, comparison, number }),
        }
    }

    fn literal(&mut self) -> Result<Literal, GoalError> {
        let start = self.at();
        let did = self.take(&["did"]);
        let name = self.name("a predicate such as `On(apple, table)`")?;
        self.demand("(", "`(` after the predicate")?;
        let mut terms = Vec::new();
        while !self.take(&[")"]) {
            if !terms.is_empty() {
                self.demand(",", "`,` or `)`")?;
            }
            terms.push(self.term()?);
        }
        let fail = |problem| GoalError { at: start, problem };
        let predicate =
            self.predicate(&name, did, terms.len()).ok_or_else(|| fail(GoalProblem::Predicate(clip(&name))))?;
        let takes = predicate.arity();
        if terms.len() + 1 == takes {
            match predicate {
                Predicate::Relation(Relation::WornBy) => terms.push(Term::Me),
                _ if agent_is_meant(predicate) => terms.insert(0, Term::Me),
                _ => {}
            }
        }
        let given = terms.len();
        if given == takes {
            Ok(Literal { predicate, terms })
        } else {
            Err(fail(GoalProblem::Arity { predicate: clip(&name), takes, given }))
        }
    }

    fn term(&mut self) -> Result<Term, GoalError> {
        let unbound_at = self.at();
        let mut name = self.name("a thing: a class, `cup.12`, `me`, `?x` or `_`")?;
        // `kitchen table` is written in two words as well.
        let plain = |word: &str| word.chars().all(is_name);
        while let Some(Token::Name(more)) = self.peek().filter(|_| plain(&name)) {
            if !plain(more) {
                break;
            }
            name = format!("{name}_{more}");
            self.next += 1;
        }
        let variable = name.trim_start_matches('?');
        if self.bound.iter().any(|b| b == variable) {
            return Ok(Term::Variable(variable.to_owned()));
        }
        if name.starts_with('?') {
            return Err(GoalError { at: unbound_at, problem: GoalProblem::Unbound(variable.to_owned()) });
        }
        let number = |digits: &str| digits.parse().ok().map(NodeId);
        Ok(match name.as_str() {
            "_" | "*" => Term::Anything,
            "me" | "character" => Term::Me,
            other => match (other.strip_prefix('#').and_then(number), other.rsplit_once('.')) {
                (Some(id), _) => Term::Node(None, id),
                (_, Some((class, _))) if self.dialect == Dialect::Eai && class == "character" => Term::Me,
                (_, Some((class, digits))) => match number(digits) {
                    Some(id) => Term::Node(Some(class.to_owned()), id),
                    None => Term::Class(name),
                },
                _ => Term::Class(name),
            },
        })
    }

    fn predicate(&self, name: &str, did: bool, given: usize) -> Option<Predicate> {
        if did {
            return Verb::parse(name).ok().or_else(|| Verb::from_virtualhome(name)).map(Predicate::Did);
        }
        match self.dialect {
            Dialect::Eai => eai_predicate(name, given),
            Dialect::Native => native_predicate(name, given),
        }
    }
}

/// Predicates that may leave the agent out: `Near(table)`.
fn agent_is_meant(predicate: Predicate) -> bool {
    use Relation::{Facing, HoldsLeft, HoldsRight, LyingOn, Near, SittingOn};
    match predicate {
        Predicate::Holds => true,
        Predicate::Relation(r) => [Near, Facing, HoldsLeft, HoldsRight, LyingOn, SittingOn].contains(&r),
        _ => false,
    }
}

/// Names of predicates besides those of states and relations.
const NAMES: &[(&str, Predicate)] = &[
    ("in", Predicate::Relation(Relation::Inside)),
    ("room", Predicate::Relation(Relation::InRoom)),
    ("close_to", Predicate::Relation(Relation::Near)),
    ("next_to", Predicate::Relation(Relation::Near)),
    ("walk", Predicate::Relation(Relation::Near)),
    ("find", Predicate::Relation(Relation::Near)),
    ("face", Predicate::Relation(Relation::Facing)),
    ("sit", Predicate::Relation(Relation::SittingOn)),
    ("lie", Predicate::Relation(Relation::LyingOn)),
    ("wear", Predicate::Relation(Relation::WornBy)),
    ("holds", Predicate::Holds),
    ("held", Predicate::Holds),
    ("grab", Predicate::Holds),
    ("close", Predicate::State(State::Closed)),
    ("switched_on", Predicate::State(State::On)),
    ("switch_on", Predicate::State(State::On)),
    ("turn_on", Predicate::State(State::On)),
    ("switched_off", Predicate::State(State::Off)),
    ("switch_off", Predicate::State(State::Off)),
    ("turn_off", Predicate::State(State::Off)),
    ("plug_in", Predicate::State(State::PluggedIn)),
    ("plug_out", Predicate::State(State::PluggedOut)),
    ("cook", Predicate::State(State::Cooked)),
    ("cut", Predicate::State(State::Sliced)),
    ("fold", Predicate::State(State::Folded)),
    ("fill", Predicate::State(State::Filled)),
];

fn native_predicate(name: &str, given: usize) -> Option<Predicate> {
    let state = State::parse(name).ok().map(Predicate::State);
    let relation = Relation::parse(name).ok().map(Predicate::Relation);
    let by_number = if given == 1 { state.or(relation) } else { relation.or(state) };
    let named = || NAMES.iter().find(|(n, _)| same_word(n, name)).map(|(_, p)| *p);
    by_number.or_else(named).or_else(|| Verb::parse(name).ok().map(Predicate::Did))
}

fn eai_predicate(name: &str, given: usize) -> Option<Predicate> {
    let relation = match name {
        "ONTOP" => Some(Relation::On),
        "NEXT_TO" | "CLOSE" if given == 2 => Some(Relation::Near),
        "INSIDE" => Some(Relation::Inside),
        "FACING" => Some(Relation::Facing),
        "BETWEEN" => Some(Relation::Between),
        "HOLDS_RH" => Some(Relation::HoldsRight),
        "HOLDS_LH" => Some(Relation::HoldsLeft),
        _ => None,
    };
    let state = || State::parse(name).ok().filter(|_| given == 1).map(Predicate::State);
    let done = || Verb::from_virtualhome(name).map(Predicate::Did);
    // A verb such as OPEN is a state when it has one thing, as in their vocabulary.
    relation.map(Predicate::Relation).or_else(state).or_else(done)
}
