//! Reading a vocabulary from text.

use super::line::{Line, error, lines};
use super::write::usual;
use super::{OwnState, Used, Vocabulary, VocabularyError, VocabularyProblem as Problem};
use crate::goal::{DerivedPredicate, PredicateDefinition, is_predicate};
use crate::rule::{self, ActionRule, AimRule, Argument, Condition, Effect, Motion};
use crate::{NameProblem, Property, State, Verb, Word, clip};

impl Vocabulary {
    /// Parses own words.
    ///
    /// One word a line, with fields separated by `|`; `#` starts a comment line, and the order of the lines does not matter:
    ///
    /// ```text
    /// property polishable
    /// state waxed | excludes: dusty dirty | needs: polishable
    /// verb polish 2 | needs: affords x polishable; holding y; near x | effects: enter x waxed | motion: use_at
    /// predicate spotless ?x | is: Waxed(?x) & !exists ?y. On(?y, ?x)
    /// ```
    ///
    /// | field of | | |
    /// |---|---|---|
    /// | a state | `excludes` | states that it ends, and that end it |
    /// | | `needs` | the affordance of things that can be in it |
    /// | a verb | `needs` | preconditions, separated by `;`, in the order in which a planner would bring them about |
    /// | | `effects` | effects, separated by `;` |
    /// | | `aims` | `going`, `turning`, `pointing`, `putting`, `dropping`, `taking` or `sitting`; none if left out |
    /// | | `motion` | a [`Motion`]; if left out, `reach` for a verb with things, else `none` |
    /// | | `says` | a description in one sentence |
    /// | a predicate | `is` | a [`Goal`](crate::Goal) without words of time, about the variables after the name, of which there are at most two |
    ///
    /// A definition is the rest of its line, `|` for "or" included; a bare word in it that is the name of a variable is that
    /// variable, unless it is quoted. It names no nodes.
    ///
    /// All but `is` may be left out. A verb is followed by the number of its things, 0 to 2: `x` is the first, `y` the second.
    /// Preconditions and effects are those of [`Condition`] and [`Effect`], with their names in lower case: `near x`,
    /// `not_in x hot`, `holding_kind wiper` (a property of what is held, no class), `related x on y`, `put_into x y`,
    /// `enter_own asleep`.
    ///
    /// Bodies do what effects say, so an effect has the needs of the built-in verb with that effect, written or not: `hold x`
    /// those of `grab`, `sit_on y` those of `sit`, but for what an earlier effect brings about. Sitting, lying, open and
    /// closed are told by bodies: `sit_on`, `lie_on`, `stand_up` and `enter x open` bring them about, nothing else does.
    ///
    /// Names are of lower-case letters, digits and single `_`. A name belongs to the process from its declaration on, also
    /// if the text has an error elsewhere; there is room for 192 of a kind.
    ///
    /// ```
    /// use vc_graph::Vocabulary;
    /// let words = Vocabulary::parse("words.txt", "verb bow 0 | says: Bows.\n")?;
    /// assert_eq!(words.to_string(), "verb bow 0 | says: Bows.\n");
    /// let error = Vocabulary::parse("words.txt", "\nverb bow 0 | needs: naer x").unwrap_err();
    /// assert!(error.to_string().starts_with("words.txt, line 2: unknown condition `naer` (did you mean `near`"));
    /// # Ok::<(), vc_graph::VocabularyError>(())
    /// ```
    ///
    /// # Errors
    /// [`VocabularyError`], with the line.
    pub fn parse(file: &str, text: &str) -> Result<Self, VocabularyError> {
        Self::builtin().extended(file, text)
    }

    /// This vocabulary with the words of another text, which may use those of this one. A word may be declared again if it
    /// means the same.
    ///
    /// # Errors
    /// As [`Vocabulary::parse`].
    pub fn extended(&self, file: &str, text: &str) -> Result<Self, VocabularyError> {
        let lines = lines(file, text)?;
        let at = |line: &Line| {
            let number = line.number;
            move |problem| error(file, number, problem)
        };
        // All names come first, so that lines may refer to later ones.
        let words = lines.iter().map(|line| declared(line).map_err(at(line))).collect::<Result<Vec<_>, _>>()?;
        let mut all = Drawer {
            states: self.states.clone(),
            properties: self.properties.clone(),
            rules: self.rules.clone(),
            predicates: self.predicates.clone(),
        };
        for (line, word) in lines.iter().zip(words) {
            all.add(word, line).map_err(at(line))?;
        }
        let words = all.into_vocabulary();
        for line in &lines {
            words.check(line).map_err(at(line))?;
        }
        Ok(words)
    }
}

/// A declared word.
#[derive(Clone, Copy)]
enum Declared {
    State(State),
    Property(Property),
    Verb(Verb),
    Predicate(DerivedPredicate),
}

/// The word that a line declares.
fn declared(line: &Line) -> Result<Declared, Problem> {
    let name = line.name.as_str();
    let free = |taken: bool| if taken { Err(NameProblem::BuiltIn(clip(name))) } else { Ok(()) };
    Ok(match line.kind {
        "state" => free(is_predicate(name) || DerivedPredicate::find(name).is_some())
            .and_then(|()| State::declare(name, 0))
            .map(Declared::State)?,
        "property" => {
            free(Property::builtin(name).is_some()).and_then(|()| Property::declare(name, 0)).map(Declared::Property)?
        }
        "predicate" => {
            let variables = PredicateDefinition::variables(&line.rest)?;
            free(is_predicate(name) || State::declared(name).is_some())?;
            Declared::Predicate(DerivedPredicate::declare(name, variables.len() as u8)?)
        }
        _ => {
            let things = things(&line.rest)?;
            free(Verb::builtin(name).is_some() || Verb::from_virtualhome(name).is_some())?;
            Declared::Verb(Verb::declare(name, things)?)
        }
    })
}

fn things(text: &str) -> Result<u8, Problem> {
    text.parse().ok().filter(|things| *things <= 2).ok_or_else(|| Problem::Things(clip(text)))
}

/// The words read so far.
struct Drawer {
    states: Vec<OwnState>,
    properties: Vec<Property>,
    rules: Vec<ActionRule>,
    predicates: Vec<PredicateDefinition>,
}

impl Drawer {
    fn add(&mut self, word: Declared, line: &Line) -> Result<(), Problem> {
        match word {
            Declared::Property(property) => {
                put(&mut self.properties, property, |known| *known == property, property.as_str())
            }
            Declared::State(state) => {
                put(&mut self.states, own_state(state, line)?, |known| known.state == state, state.as_str())
            }
            Declared::Verb(verb) => put(&mut self.rules, rule(verb, line)?, |known| known.verb == verb, verb.as_str()),
            Declared::Predicate(predicate) => {
                let variables = PredicateDefinition::variables(&line.rest)?;
                let new = PredicateDefinition::read(predicate, variables, line.field("is"))?;
                put(&mut self.predicates, new, |known| known.predicate == predicate, predicate.as_str())
            }
        }
    }

    fn into_vocabulary(self) -> Vocabulary {
        Vocabulary::from_parts(self.states, self.properties, self.rules, self.predicates)
    }
}

/// Adds a word unless it is there with the same meaning.
fn put<T: PartialEq>(all: &mut Vec<T>, new: T, same: impl Fn(&T) -> bool, name: &'static str) -> Result<(), Problem> {
    match all.iter().find(|known| same(known)) {
        Some(known) if *known != new => Err(Problem::Redeclared(name)),
        Some(_) => Ok(()),
        None => {
            all.push(new);
            Ok(())
        }
    }
}

fn own_state(state: State, line: &Line) -> Result<OwnState, Problem> {
    let words = |name| line.field(name).split_whitespace();
    let excludes = words("excludes").map(State::parse).collect::<Result<crate::StateSet, _>>()?;
    let needs = Some(line.field("needs")).filter(|text| !text.is_empty()).map(Property::parse).transpose()?;
    let ended = excludes.iter().find(|ended| rule::is_of_bodies(*ended));
    ended.map_or(Ok(OwnState { state, excludes: excludes.without(state), needs }), |word| Err(Problem::OfBodies(word)))
}

fn rule(verb: Verb, line: &Line) -> Result<ActionRule, Problem> {
    let arity = verb.arity();
    let motion = Some(line.field("motion")).filter(|text| !text.is_empty()).map(Motion::parse).transpose()?;
    let rule = ActionRule {
        verb,
        arity,
        preconditions: line.entries("needs", Condition::read)?.into(),
        effects: line.entries("effects", Effect::read)?.into(),
        aims: AimRule::named(line.field("aims"), arity)?,
        motion: motion.unwrap_or_else(|| usual(arity)),
        description: line.field("says").to_owned().into(),
    };
    let missing = used(&rule).find_map(|used| match used {
        Used::Thing(Argument::X) if arity == 0 => Some("x"),
        Used::Thing(Argument::Y) if arity < 2 => Some("y"),
        _ => None,
    });
    let no_such = |thing| Problem::NoSuchThing { verb: verb.to_string(), things: arity, thing };
    if let Some(thing) = missing {
        return Err(no_such(thing));
    }
    match rule.effects.iter().find_map(rule::bodiless) {
        Some(state) => Err(Problem::OfBodies(state)),
        None => Ok(rule::with_implied(rule)),
    }
}

/// The parts of a rule's preconditions and effects.
fn used(rule: &ActionRule) -> impl Iterator<Item = Used> {
    let needs = rule.preconditions.iter().flat_map(|need| need.words().1);
    needs.chain(rule.effects.iter().flat_map(|effect| effect.words().1))
}

impl Vocabulary {
    /// Checks that this vocabulary has the words that the declaration of a line uses.
    fn check(&self, line: &Line) -> Result<(), Problem> {
        let used: Vec<Used> = match declared(line)? {
            Declared::Property(_) => Vec::new(),
            Declared::State(state) => self.used_by(state),
            Declared::Verb(verb) => self.rule(verb).into_iter().flat_map(used).collect(),
            Declared::Predicate(predicate) => {
                self.own_predicate(predicate).map(PredicateDefinition::used).unwrap_or_default()
            }
        };
        let strange = used.into_iter().find(|used| match used {
            Used::State(state) => !self.has_state(*state),
            Used::Property(property) => !self.has_property(*property),
            Used::Verb(verb) => self.rule(*verb).is_none(),
            Used::Predicate(predicate) => self.own_predicate(*predicate).is_none(),
            _ => false,
        });
        strange.map_or(Ok(()), |word| Err(Problem::Undeclared(word.as_str())))?;
        match declared(line)? {
            Declared::Predicate(predicate) => self.own_predicate(predicate).map_or(Ok(()), |own| own.check(self)),
            _ => Ok(()),
        }
    }

    fn used_by(&self, state: State) -> Vec<Used> {
        let own = self.states.iter().filter(|own| own.state == state);
        own.flat_map(|own| own.excludes.iter().map(Used::State).chain(own.needs.map(Used::Property))).collect()
    }
}
