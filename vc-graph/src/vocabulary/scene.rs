//! The vocabulary of a scene: the built-in words, and its own with their meaning.

use std::sync::{Arc, LazyLock};

use super::{OwnWords, Word};
use crate::goal::{DerivedPredicate, Predicate, PredicateDefinition};
use crate::rule::table::RULES;
use crate::rule::{ActionRule, Needs};
use crate::{Node, Property, State, StateSet, Verb};

/// The states, properties, verbs and predicates of a scene with their meaning: the built-in ones, and own ones that a text
/// declares.
///
/// An own word is a word like any other: classes and nodes have it, actions and goals say it, the transition rule, the
/// planner and bodies go by it, files keep it. Its name is known to the whole process from its declaration on; its
/// meaning belongs to the vocabulary, so two scenes can have different rules for one verb. A scene has the vocabulary of
/// its class table ([`ClassTable::with_vocabulary`](crate::ClassTable::with_vocabulary),
/// [`SceneGraph::set_vocabulary`](crate::SceneGraph::set_vocabulary)). [`Vocabulary::parse`] describes the text.
///
/// ```
/// use vc_graph::{Action, ClassTable, Draft, SceneBuilder, Verb, Vocabulary, Word, rule};
/// let words = "
///     property polishable
///     state shiny | excludes: dusty dirty | needs: polishable
///     verb polish 1 | needs: affords x polishable; holding_kind wiper; near x | effects: enter x shiny | motion: use_at";
/// let words = Vocabulary::parse("words.txt", words)?;
/// let boots = "leather_boots | boots | | clothing | graspable polishable | 0.3 0.3 0.3 | 1 | dirty | | ";
/// let classes = ClassTable::builtin().with_vocabulary(words).extended("classes.txt", boots)?;
/// let mut scene = SceneBuilder::with_classes("flat", classes.into());
/// let hall = scene.add(Draft::new("hallway"))?;
/// let [boots, rag, me] = ["leather_boots", "rag", "character"].map(|class| scene.add_in(hall, Draft::new(class)));
/// let (boots, me, mut scene) = (boots?, me?, scene.build());
/// for action in ["walk rag.3", "grab rag.3", "walk leather_boots.2", "polish leather_boots.2"] {
///     rule::step(&mut scene, me, &action.parse()?).map_err(|why| why[0].clone())?;
/// }
/// assert_eq!(scene.node(boots).map(|node| node.states().to_string()), Some("shiny".into()));
/// # let _ = rag;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Vocabulary {
    pub(super) states: Vec<OwnState>,
    pub(super) properties: Vec<Property>,
    pub(super) rules: Vec<ActionRule>,
    pub(super) predicates: Vec<PredicateDefinition>,
    /// The own states that a state excludes, both ways.
    excludes: Vec<(State, StateSet)>,
    /// The places of own verbs in `rules`, by their numbers.
    places: Vec<Option<usize>>,
    needs: Arc<Needs>,
}

/// An own state with its meaning.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct OwnState {
    /// The state.
    pub state: State,
    /// The states that it excludes.
    pub excludes: StateSet,
    /// The affordance of things that can be in the state. Goals and activities are checked by it; a verb that leads to the
    /// state says so in its own `needs`.
    pub needs: Option<Property>,
}

impl Vocabulary {
    /// The built-in words alone.
    pub fn builtin() -> Arc<Self> {
        static WORDS: LazyLock<Arc<Vocabulary>> =
            LazyLock::new(|| Arc::new(Vocabulary::from_parts(Vec::new(), Vec::new(), Vec::new(), Vec::new())));
        WORDS.clone()
    }

    /// The vocabulary with some own words.
    pub(super) fn from_parts(
        mut states: Vec<OwnState>,
        mut properties: Vec<Property>,
        mut rules: Vec<ActionRule>,
        mut predicates: Vec<PredicateDefinition>,
    ) -> Self {
        states.sort_by_key(|own| own.state);
        properties.sort_unstable();
        rules.sort_by_key(|rule| rule.verb);
        predicates.sort_by_key(|definition| definition.predicate);
        let excludes = excluded(&states);
        let mut places = vec![None; rules.iter().map(|rule| own_number(rule.verb) + 1).max().unwrap_or(0)];
        for (place, rule) in rules.iter().enumerate() {
            places[own_number(rule.verb)] = Some(place);
        }
        let needs = Arc::new(Needs::read(|| RULES.iter().chain(&rules)));
        Self { states, properties, rules, predicates, excludes, places, needs }
    }

    /// Whether there are only built-in words.
    pub fn is_builtin(&self) -> bool {
        self.states.is_empty() && self.properties.is_empty() && self.rules.is_empty() && self.predicates.is_empty()
    }

    /// The own states, by name.
    pub fn own_states(&self) -> &[OwnState] {
        &self.states
    }

    /// The own properties, by name.
    pub fn own_properties(&self) -> &[Property] {
        &self.properties
    }

    /// The rules of the own verbs, by name.
    pub fn own_rules(&self) -> &[ActionRule] {
        &self.rules
    }

    /// The definitions of derived predicates, by name.
    ///
    /// ```
    /// use vc_graph::Vocabulary;
    /// let words = Vocabulary::parse("words.txt", "predicate neat ?x | is: Clean(?x) & Folded(?x)")?;
    /// let neat = &words.own_predicates()[0];
    /// assert_eq!((neat.predicate.as_str(), neat.body.to_string()), ("neat", "Clean(?x) & Folded(?x)".to_owned()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn own_predicates(&self) -> &[PredicateDefinition] {
        &self.predicates
    }

    /// The definition of a predicate; `None` if it is built in or of other vocabularies.
    pub fn definition(&self, predicate: Predicate) -> Option<&PredicateDefinition> {
        if let Predicate::Derived(predicate) = predicate { self.own_predicate(predicate) } else { None }
    }

    pub(super) fn own_predicate(&self, predicate: DerivedPredicate) -> Option<&PredicateDefinition> {
        self.predicates.iter().find(|definition| definition.predicate == predicate)
    }

    /// The rules of all verbs: built-in ones in declaration order, then own ones by name.
    ///
    /// ```
    /// use vc_graph::{Verb, Vocabulary};
    /// let words = Vocabulary::builtin();
    /// assert_eq!(words.rules().next().map(|rule| rule.verb), Some(Verb::Walk));
    /// ```
    pub fn rules(&self) -> impl Iterator<Item = &ActionRule> {
        RULES.iter().chain(&self.rules)
    }

    /// All verbs, in the order of their rules.
    pub fn verbs(&self) -> impl Iterator<Item = Verb> {
        self.rules().map(|rule| rule.verb)
    }

    /// The rule of a verb; `None` for an own verb of other vocabularies. Costs a look-up.
    ///
    /// ```
    /// use vc_graph::{Verb, Vocabulary};
    /// let words = Vocabulary::builtin();
    /// assert!(words.rule(Verb::Grab).is_some_and(|rule| !rule.preconditions.is_empty()));
    /// ```
    pub fn rule(&self, verb: Verb) -> Option<&ActionRule> {
        RULES.get(verb.index()).or_else(|| self.rules.get((*self.places.get(own_number(verb))?)?))
    }

    /// Whether a state is built in or one of this vocabulary.
    pub fn has_state(&self, state: State) -> bool {
        state.is_builtin() || self.states.iter().any(|own| own.state == state)
    }

    /// Whether a property is built in or one of this vocabulary.
    pub fn has_property(&self, property: Property) -> bool {
        property.is_builtin() || self.properties.contains(&property)
    }

    /// The states that a state excludes, own ones as well.
    ///
    /// ```
    /// use vc_graph::{State, Vocabulary, Word};
    /// let words = Vocabulary::parse("words.txt", "state waxed | excludes: dusty")?;
    /// assert!(words.opposites(State::Dusty).contains(State::parse("waxed")?));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn opposites(&self, state: State) -> StateSet {
        let own = self.excludes.iter().find(|(other, _)| *other == state);
        own.map_or_else(|| state.opposites(), |(_, own)| state.opposites().union(*own))
    }

    /// The affordance without which no action brings a thing into a state; `None` for a state of all sorts of things.
    pub fn needs(&self, state: State) -> Option<Property> {
        state.needs().or_else(|| self.states.iter().find(|own| own.state == state)?.needs)
    }

    /// A set with a state added and its opposites removed.
    ///
    /// ```
    /// use vc_graph::{State, StateSet, Vocabulary, Word};
    /// let words = Vocabulary::parse("words.txt", "state waxed | excludes: dusty")?;
    /// let dusty = StateSet::from_words(&[State::Dusty, State::Open]);
    /// assert_eq!(words.entering(dusty, State::parse("waxed")?).to_string(), "open waxed");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn entering(&self, states: StateSet, state: State) -> StateSet {
        states.minus(self.opposites(state)).with(state)
    }

    /// The groups of exclusive states from which a set has more than one.
    pub fn conflicts(&self, states: StateSet) -> impl Iterator<Item = StateSet> {
        let apart =
            move |own: &OwnState| own.excludes.iter().filter(|other| states.contains(*other)).collect::<StateSet>();
        let here = self.states.iter().filter(move |own| states.contains(own.state));
        let own = here.map(move |own| (apart(own), own.state)).filter(|(others, _)| !others.is_empty());
        states.conflicts().chain(own.map(|(others, state)| others.with(state)))
    }

    /// An own word of a node that this vocabulary lacks.
    pub(crate) fn word_lacking(&self, node: &Node) -> Option<&'static str> {
        let spec = node.spec();
        let state = node.states().own().find(|state| !self.has_state(*state)).map(State::as_str);
        let property = || {
            let all = spec.properties.union(spec.affordances);
            all.own().find(|property| !self.has_property(*property)).map(Property::as_str)
        };
        state.or_else(property)
    }

    /// The preconditions of all verbs, each once.
    pub(crate) fn shared_needs(&self) -> &Needs {
        &self.needs
    }
}

/// The number of an own verb, from zero.
fn own_number(verb: Verb) -> usize {
    verb.index().wrapping_sub(OwnWords::FIRST)
}

fn excluded(states: &[OwnState]) -> Vec<(State, StateSet)> {
    let mut all: Vec<(State, StateSet)> = Vec::new();
    let mut note = |state: State, other: State| match all.iter_mut().find(|(known, _)| *known == state) {
        Some((_, set)) => *set = set.with(other),
        None => all.push((state, StateSet::from_words(&[other]))),
    };
    for own in states {
        own.excludes.iter().for_each(|other| {
            note(own.state, other);
            note(other, own.state);
        });
    }
    all
}

impl Default for Vocabulary {
    fn default() -> Self {
        Self::clone(&Self::builtin())
    }
}

/// Two vocabularies are equal if the same words mean the same.
impl PartialEq for Vocabulary {
    fn eq(&self, other: &Self) -> bool {
        let same_words = self.states == other.states && self.properties == other.properties;
        same_words && self.rules == other.rules && self.predicates == other.predicates
    }
}

impl std::fmt::Debug for Vocabulary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.lines()).finish()
    }
}
