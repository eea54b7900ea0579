//! The data types of domains and problems.

/// A type, or a union of types: `(either cup plate)`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Type {
    /// The types it can be.
    pub any: Vec<String>,
}

impl From<&str> for Type {
    fn from(name: &str) -> Self {
        Self { any: vec![name.to_owned()] }
    }
}

/// A name with its type.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Typed {
    /// The name; for a variable with its `?`.
    pub name: String,
    /// The type; `object` if none is given.
    pub kind: Type,
}

impl Typed {
    /// A name of a type.
    pub fn new(name: impl Into<String>, kind: impl Into<Type>) -> Self {
        Self { name: name.into(), kind: kind.into() }
    }
}

/// A predicate or a function, with its parameters.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Signature {
    /// Its name.
    pub name: String,
    /// The parameters.
    pub parameters: Vec<Typed>,
}

/// A predicate applied to objects or variables.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Atom {
    /// The predicate.
    pub predicate: String,
    /// The arguments.
    pub arguments: Vec<String>,
}

impl Atom {
    /// A predicate with arguments.
    pub fn new(predicate: impl Into<String>, arguments: &[&str]) -> Self {
        Self { predicate: predicate.into(), arguments: arguments.iter().map(|&a| a.to_owned()).collect() }
    }
}

/// A number as written in the text: `1`, `2.5`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Number(String);

impl Number {
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
pub enum Amount {
    /// A number.
    Number(Number),
    /// The value of a function.
    Of(Atom),
}

/// A quality measure of plans.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Metric {
    /// Whether the amount is to be maximised rather than minimised.
    pub maximize: bool,
    /// The measured amount: `(total-cost)`.
    pub of: Amount,
}

/// A condition.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Formula {
    /// A predicate of objects or variables.
    Atom(Atom),
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
    ForAll(Vec<Typed>, Box<Formula>),
    /// The formula holds for some value.
    Exists(Vec<Typed>, Box<Formula>),
}

/// An effect.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Change {
    /// The atom becomes true.
    Add(Atom),
    /// The atom becomes false.
    Delete(Atom),
    /// The value of a function increases by an amount: a cost.
    Increase(Atom, Amount),
    /// The effects, for all values.
    ForAll(Vec<Typed>, Vec<Change>),
    /// The effects, if the condition holds.
    When(Formula, Vec<Change>),
}

/// An action schema.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Operator {
    /// Its name.
    pub name: String,
    /// The parameters.
    pub parameters: Vec<Typed>,
    /// The precondition.
    pub precondition: Formula,
    /// The effects.
    pub effect: Vec<Change>,
}

/// A domain: its predicates, functions and actions.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Domain {
    /// Its name.
    pub name: String,
    /// `:strips`, `:typing`, ...
    pub requirements: Vec<String>,
    /// The types, each with its parent type.
    pub types: Vec<Typed>,
    /// Objects that exist in every problem.
    pub constants: Vec<Typed>,
    /// The predicates.
    pub predicates: Vec<Signature>,
    /// Functions of objects: costs.
    pub functions: Vec<Signature>,
    /// The action schemas.
    pub operators: Vec<Operator>,
}

/// A problem: its objects, initial facts and goal.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Problem {
    /// Its name.
    pub name: String,
    /// The name of its domain.
    pub domain: String,
    /// The objects.
    pub objects: Vec<Typed>,
    /// The facts that hold at the start.
    pub initial: Vec<Atom>,
    /// Facts explicitly written as not holding at the start; unwritten facts do not hold either.
    pub denied: Vec<Atom>,
    /// The values of functions at the start.
    pub values: Vec<(Atom, Number)>,
    /// The goal.
    pub goal: Formula,
    /// The quality measure of plans, if there is one.
    pub metric: Option<Metric>,
}
