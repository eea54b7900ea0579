//! The data types of domains and problems.

/// A type, or a union of types: `(either cup plate)`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct TypeUnion {
    /// The types it can be.
    pub any: Vec<String>,
}

impl From<&str> for TypeUnion {
    fn from(name: &str) -> Self {
        Self { any: vec![name.to_owned()] }
    }
}

/// A name with its type.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct TypedName {
    /// The name; for a variable with its `?`.
    pub name: String,
    /// The type; `object` if none is given.
    pub kind: TypeUnion,
}

impl TypedName {
    /// A name of a type.
    pub fn new(name: impl Into<String>, kind: impl Into<TypeUnion>) -> Self {
        Self { name: name.into(), kind: kind.into() }
    }
}

/// A predicate or a function, with its parameters.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Signature {
    /// Its name.
    pub name: String,
    /// The parameters.
    pub parameters: Vec<TypedName>,
}

/// A predicate applied to objects or variables.
///
/// ```
/// use vc_tasks::format::pddl::AtomicFormula;
/// let fact = AtomicFormula::new("on", &["apple_3", "kitchen_table_2"]);
/// assert_eq!(fact.arguments.len(), 2);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AtomicFormula {
    /// The predicate.
    pub predicate: String,
    /// The arguments.
    pub arguments: Vec<String>,
}

impl AtomicFormula {
    /// A predicate with arguments.
    pub fn new(predicate: impl Into<String>, arguments: &[&str]) -> Self {
        Self { predicate: predicate.into(), arguments: arguments.iter().map(|&a| a.to_owned()).collect() }
    }
}

/// A number as written in the text: `1`, `2.5`.
///
/// ```
/// use vc_tasks::format::pddl::NumericLiteral;
/// assert_eq!(NumericLiteral::new("2.50").map(|number| number.value()), Some(2.5));
/// assert_eq!(NumericLiteral::new("NaN"), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct NumericLiteral(String);

impl NumericLiteral {
    /// Parses a number; `None` if the text is not a finite number.
    pub fn new(text: &str) -> Option<Self> {
        text.parse::<f64>().ok().filter(|number| number.is_finite()).map(|_| Self(text.to_owned()))
    }

    /// The number as written in the text.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The number's value.
    pub fn value(&self) -> f64 {
        self.0.parse().unwrap_or_default()
    }
}

/// An amount: a number, or the value of a function of objects.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum NumericExpression {
    /// A number.
    Number(NumericLiteral),
    /// The value of a function.
    Of(AtomicFormula),
}

/// A quality measure of plans.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Metric {
    /// Whether the amount is to be maximised rather than minimised.
    pub maximize: bool,
    /// The measured amount: `(total-cost)`.
    pub of: NumericExpression,
}

/// A condition.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Formula {
    /// A predicate of objects or variables.
    Atom(AtomicFormula),
    /// Two names denote the same object.
    Equal(String, String),
    /// All formulas hold.
    And(Vec<Formula>),
    /// Some formula holds.
    Or(Vec<Formula>),
    /// The formula does not hold.
    Not(Box<Formula>),
    /// The second holds if the first does.
    Imply(Box<Formula>, Box<Formula>),
    /// The formula holds for all values.
    ForAll(Vec<TypedName>, Box<Formula>),
    /// The formula holds for some value.
    Exists(Vec<TypedName>, Box<Formula>),
}

/// An effect.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum OperatorEffect {
    /// The atom becomes true.
    Add(AtomicFormula),
    /// The atom becomes false.
    Delete(AtomicFormula),
    /// The value of a function increases by an amount: a cost.
    Increase(AtomicFormula, NumericExpression),
    /// The effects, for all values.
    ForAll(Vec<TypedName>, Vec<OperatorEffect>),
    /// The effects, if the condition holds.
    When(Formula, Vec<OperatorEffect>),
}

/// An action schema.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Operator {
    /// Its name.
    pub name: String,
    /// The parameters.
    pub parameters: Vec<TypedName>,
    /// The precondition.
    pub precondition: Formula,
    /// The effects.
    pub effect: Vec<OperatorEffect>,
}

/// A domain: its predicates, functions and actions.
///
/// ```
/// use vc_tasks::format::pddl::Domain;
/// let text = "(define (domain lamps) (:predicates (on ?lamp))
///     (:action light :parameters (?lamp) :precondition (not (on ?lamp)) :effect (on ?lamp)))";
/// let domain: Domain = text.parse()?;
/// assert_eq!((domain.name.as_str(), domain.operators.len()), ("lamps", 1));
/// assert_eq!(domain.to_string().parse::<Domain>()?, domain);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Domain {
    /// Its name.
    pub name: String,
    /// `:strips`, `:typing`, ...
    pub requirements: Vec<String>,
    /// The types, each with its parent type.
    pub types: Vec<TypedName>,
    /// Objects that exist in every problem.
    pub constants: Vec<TypedName>,
    /// The predicates.
    pub predicates: Vec<Signature>,
    /// Functions of objects: costs.
    pub functions: Vec<Signature>,
    /// The action schemas.
    pub operators: Vec<Operator>,
}

/// A problem: its objects, initial facts and goal.
///
/// ```
/// use vc_tasks::format::pddl::PlanningProblem;
/// let text = "(define (problem p) (:domain lamps) (:objects a b) (:init (on a)) (:goal (on b)))";
/// let problem: PlanningProblem = text.parse()?;
/// assert_eq!((problem.objects.len(), problem.initial.len()), (2, 1));
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct PlanningProblem {
    /// Its name.
    pub name: String,
    /// The name of its domain.
    pub domain: String,
    /// The objects.
    pub objects: Vec<TypedName>,
    /// The facts that hold at the start.
    pub initial: Vec<AtomicFormula>,
    /// Facts explicitly written as not holding at the start; unwritten facts do not hold either.
    pub denied: Vec<AtomicFormula>,
    /// The values of functions at the start.
    pub values: Vec<(AtomicFormula, NumericLiteral)>,
    /// The goal.
    pub goal: Formula,
    /// The quality measure of plans, if there is one.
    pub metric: Option<Metric>,
}
