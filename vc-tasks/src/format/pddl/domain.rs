//! What domains and problems are made of.

/// A type, or a choice of types: `(either cup plate)`.
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
    /// The name; of a variable with its `?`.
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
    /// What it is about.
    pub parameters: Vec<Typed>,
}

/// A predicate of given things or variables.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Atom {
    /// The predicate.
    pub predicate: String,
    /// What it is said of.
    pub arguments: Vec<String>,
}

impl Atom {
    /// A predicate of some things.
    pub fn new(predicate: impl Into<String>, arguments: &[&str]) -> Self {
        Self { predicate: predicate.into(), arguments: arguments.iter().map(|&a| a.to_owned()).collect() }
    }
}

/// A number as it is written: `1`, `2.5`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Number(String);

impl Number {
    /// The number of a text; `None` if it is no finite number.
    pub fn new(text: &str) -> Option<Self> {
        text.parse::<f64>().ok().filter(|number| number.is_finite()).map(|_| Self(text.to_owned()))
    }

    /// The number as it is written.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The number's value.
    pub fn value(&self) -> f64 {
        self.0.parse().unwrap_or_default()
    }
}

/// An amount: a number, or the value of a function of things.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Amount {
    /// A number.
    Number(Number),
    /// The value of a function.
    Of(Atom),
}

/// A measure of plans.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Metric {
    /// Whether the greatest amount is best, not the least.
    pub maximize: bool,
    /// The amount that counts: `(total-cost)`.
    pub of: Amount,
}

/// A condition.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Formula {
    /// A predicate of given things.
    Atom(Atom),
    /// Two names mean the same thing.
    Equal(String, String),
    /// All of these.
    And(Vec<Formula>),
    /// Some of these.
    Or(Vec<Formula>),
    /// Not this.
    Not(Box<Formula>),
    /// The second, if the first.
    Imply(Box<Formula>, Box<Formula>),
    /// This, for all values.
    ForAll(Vec<Typed>, Box<Formula>),
    /// This, for some values.
    Exists(Vec<Typed>, Box<Formula>),
}

/// An effect.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Change {
    /// It becomes true.
    Add(Atom),
    /// It becomes false.
    Delete(Atom),
    /// A function's value grows by an amount: a cost.
    Increase(Atom, Amount),
    /// These, for all values.
    ForAll(Vec<Typed>, Vec<Change>),
    /// These, if the condition holds.
    When(Formula, Vec<Change>),
}

/// What can be done.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Operator {
    /// Its name.
    pub name: String,
    /// What it takes.
    pub parameters: Vec<Typed>,
    /// What must hold.
    pub precondition: Formula,
    /// What it does.
    pub effect: Vec<Change>,
}

/// What can be said and done.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Domain {
    /// Its name.
    pub name: String,
    /// `:strips`, `:typing`, ...
    pub requirements: Vec<String>,
    /// Types, each with the one it belongs to.
    pub types: Vec<Typed>,
    /// Things that are in every problem.
    pub constants: Vec<Typed>,
    /// What can be said.
    pub predicates: Vec<Signature>,
    /// Functions of things: costs.
    pub functions: Vec<Signature>,
    /// What can be done.
    pub operators: Vec<Operator>,
}

/// What there is, holds, and shall hold.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Problem {
    /// Its name.
    pub name: String,
    /// The name of its domain.
    pub domain: String,
    /// The things.
    pub objects: Vec<Typed>,
    /// What holds at the start.
    pub initial: Vec<Atom>,
    /// Facts that are written as not holding at the start; facts that are not written do not hold either.
    pub denied: Vec<Atom>,
    /// The values of functions at the start.
    pub values: Vec<(Atom, Number)>,
    /// What shall hold.
    pub goal: Formula,
    /// How plans are measured, if they are.
    pub metric: Option<Metric>,
}
