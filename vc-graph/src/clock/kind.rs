//! Kinds of things: a class with all its kinds, a category, what affords something, or all things.

use std::sync::Arc;

use super::error::ClockProblem;
use crate::class::{Category, ClassTable};
use crate::spelling::clip;
use crate::vocabulary::Word;
use crate::{Node, NodeKind, Property, SceneGraph};

/// One kind of things.
#[derive(Debug, Clone, PartialEq)]
enum Kind {
    All,
    Class(Arc<str>),
    Category(Category),
    Affords(Property),
}

/// A thing is of these kinds if it is of one of them. Rooms and agents are no things.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Kinds(Vec<Kind>);

impl Kinds {
    /// Reads kinds that are separated by spaces.
    pub(super) fn parse(text: &str, classes: &ClassTable) -> Result<Self, ClockProblem> {
        let kinds: Result<Vec<Kind>, ClockProblem> = text.split_whitespace().map(|word| kind(word, classes)).collect();
        match kinds? {
            kinds if kinds.is_empty() => Err(ClockProblem::NoKind),
            kinds => Ok(Self(kinds)),
        }
    }

    pub(super) fn have(&self, graph: &SceneGraph, node: &Node) -> bool {
        node.kind() == NodeKind::Object && self.0.iter().any(|kind| kind.has(graph.classes(), node))
    }
}

impl Kind {
    fn has(&self, classes: &ClassTable, node: &Node) -> bool {
        match self {
            Self::All => true,
            Self::Class(name) => classes.is_a(node.class(), name),
            Self::Category(category) => match classes.get(node.class()) {
                Some(class) => class.category == *category,
                None => Category::parse(&node.spec().category) == Ok(*category),
            },
            Self::Affords(property) => node.affords(*property),
        }
    }
}

fn kind(word: &str, classes: &ClassTable) -> Result<Kind, ClockProblem> {
    match word.split_once(':') {
        Some(("category", name)) => Ok(Kind::Category(Category::parse(name)?)),
        Some(("affords", name)) => Ok(Kind::Affords(Property::parse(name)?)),
        _ if word == "*" => Ok(Kind::All),
        _ => match classes.exact(word) {
            Some(class) => Ok(Kind::Class(class.name.clone())),
            None => Err(no_such_class(word, classes)),
        },
    }
}

fn no_such_class(word: &str, classes: &ClassTable) -> ClockProblem {
    let near = classes.nearest(word).into_iter().map(str::to_owned).collect();
    ClockProblem::NoSuchClass { name: clip(word), near }
}
