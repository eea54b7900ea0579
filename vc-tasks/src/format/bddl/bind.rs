//! Activities in a scene: the declared objects are bound to things of their classes.

use std::collections::HashMap;

use vc_graph::goal::{Comparison, Goal, Quantified, Term};
use vc_graph::{NodeId, NodeKind, SceneGraph};

use super::ActivityDefinition;
use crate::format::ReadError;

/// The objects of an activity as things of a scene, and the goal about these.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bound {
    /// The declared objects, in the order of the text, each with its thing.
    pub objects: Vec<(String, NodeId)>,
    /// The goal. Its quantifiers range over the things of the declared objects, as BDDL's do.
    pub goal: Goal,
}

/// The reason why an activity cannot be bound to a scene.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_tasks::format::bddl::{ActivityDefinition, BindError};
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("kitchen"))?;
/// let text = "(define (problem p) (:objects apple.n.01_1 - apple.n.01) (:goal (broken apple.n.01_1)))";
/// let error = ActivityDefinition::read(text)?.bind(&scene.build()).unwrap_err();
/// assert!(matches!(error, BindError::Missing(objects) if objects[0].0 == "apple.n.01_1"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BindError {
    /// The goal cannot be converted.
    #[error(transparent)]
    Goal(#[from] ReadError),
    /// The scene has no thing left for some objects.
    #[error(
        "the scene has no thing for {}; add things of these classes, or take another scene",
        .0.iter().map(|(object, class)| format!("`{object}` of class `{class}`")).collect::<Vec<_>>().join(", ")
    )]
    Missing(Vec<(String, String)>),
}

impl ActivityDefinition {
    /// Finds a thing of a scene for each declared object, and gives the goal about these things.
    ///
    /// A class `coffee_cup.n.01` is that of the class table which its words name, or else a class of the scene with that
    /// name. Each object gets a thing of its own, if possible one in a room of the kind that the initial facts name;
    /// among these the lowest numbers are taken. `agent.n.01` is an agent, and a floor is the room where the scene has
    /// no floors. Where things are at first is not asked: the initial facts are left to the caller.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::format::bddl::ActivityDefinition;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let apple = scene.add_in(fridge, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let scene = scene.build();
    ///
    /// let activity = ActivityDefinition::read("(define (problem tidy-0) (:domain omnigibson)
    ///     (:objects apple.n.01_1 - apple.n.01  electric_refrigerator.n.01_1 - electric_refrigerator.n.01)
    ///     (:init (inroom electric_refrigerator.n.01_1 kitchen))
    ///     (:goal (forall (?apple.n.01 - apple.n.01) (inside ?apple.n.01 ?electric_refrigerator.n.01_1))))")?;
    /// let bound = activity.bind(&scene)?;
    /// assert_eq!(bound.objects[1], ("electric_refrigerator.n.01_1".to_owned(), fridge));
    /// assert_eq!(bound.goal.to_string(), "Inside(apple.3, fridge.2)");
    /// assert!(bound.goal.holds(&Situation::new(&scene, me, &History::default())));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BindError::Missing`] names all objects for which there is no thing; [`BindError::Goal`] as
    /// [`ActivityDefinition::to_goal`].
    pub fn bind(&self, graph: &SceneGraph) -> Result<Bound, BindError> {
        let goal = self.to_goal()?;
        let mut declared: Vec<(&str, &str)> = Vec::new();
        for object in self.objects().filter(|object| !object.name.is_empty()) {
            if declared.iter().all(|(name, _)| *name != object.name) {
                declared.push((object.name, object.class));
            }
        }
        let rooms: HashMap<&str, &str> = self.rooms().collect();
        let choices = declared.iter().map(|(name, class)| candidates(graph, class, rooms.get(name).copied()));
        let things = assigned(&choices.collect::<Vec<_>>());
        let missing = |((name, class), thing): (&(&str, &str), &Option<NodeId>)| {
            thing.is_none().then(|| ((*name).to_owned(), (*class).to_owned()))
        };
        let missing: Vec<(String, String)> = declared.iter().zip(&things).filter_map(missing).collect();
        if !missing.is_empty() {
            return Err(BindError::Missing(missing));
        }
        // Declared twice, an object has the number of the first time.
        let number = |name: &str| self.objects().position(|object| object.name == name).map_or(0, |at| at as u32 + 1);
        let found = || declared.iter().zip(things.iter().flatten());
        let places = Places {
            graph,
            nodes: found().map(|((name, _), thing)| (NodeId(number(name)), *thing)).collect(),
            classes: found().map(|((_, class), thing)| (*class, *thing)).collect(),
        };
        let objects = found().map(|((name, _), thing)| ((*name).to_owned(), *thing)).collect();
        Ok(Bound { objects, goal: places.goal(&goal) })
    }
}

/// The things that an object can be: of its class, in a room of a kind if there are such.
fn candidates(graph: &SceneGraph, class: &str, room: Option<&str>) -> Vec<NodeId> {
    let word = class.split('.').next().unwrap_or(class);
    let rooms = room.map(|kind| graph.of_class(kind)).unwrap_or_default();
    let all = match (word, graph.of_class(word)) {
        ("agent", _) => graph.agents().to_vec(),
        ("floor", found) if found.is_empty() => graph.rooms().to_vec(),
        (_, found) => found,
    };
    let is_there = |id: &NodeId| graph.room_of(*id).is_some_and(|at| rooms.contains(&at));
    let there: Vec<NodeId> = all.iter().copied().filter(is_there).collect();
    if there.is_empty() { all } else { there }
}

/// For each list one of its things, none twice, for as many lists as possible: augmenting paths (Kuhn 1955).
fn assigned(choices: &[Vec<NodeId>]) -> Vec<Option<NodeId>> {
    let mut taken: HashMap<NodeId, usize> = HashMap::new();
    for row in 0..choices.len() {
        augment(row, choices, &mut taken, &mut Vec::new());
    }
    let mut things = vec![None; choices.len()];
    taken.into_iter().for_each(|(thing, row)| things[row] = Some(thing));
    things
}

fn augment(row: usize, choices: &[Vec<NodeId>], taken: &mut HashMap<NodeId, usize>, tried: &mut Vec<NodeId>) -> bool {
    // A free thing is taken before another object has to take another one.
    if let Some(&free) = choices[row].iter().find(|thing| !taken.contains_key(thing)) {
        taken.insert(free, row);
        return true;
    }
    for &thing in &choices[row] {
        let Some(owner) = taken.get(&thing).copied().filter(|_| !tried.contains(&thing)) else { continue };
        tried.push(thing);
        if augment(owner, choices, taken, tried) {
            taken.insert(thing, row);
            return true;
        }
    }
    false
}

/// The nodes of a scene that stand for the objects of an activity.
struct Places<'a> {
    graph: &'a SceneGraph,
    nodes: HashMap<NodeId, NodeId>,
    /// The classes of the declared objects, with their things.
    classes: Vec<(&'a str, NodeId)>,
}

impl Places<'_> {
    fn goal(&self, goal: &Goal) -> Goal {
        let named = |term: &Term| match term {
            Term::Node(_, id) => self.nodes.get(id).map_or_else(|| term.clone(), |thing| self.term(*thing)),
            other => other.clone(),
        };
        self.ranged(&goal.with_terms(&named))
    }

    fn term(&self, thing: NodeId) -> Term {
        let class = self.graph.node(thing).filter(|n| n.kind() != NodeKind::Agent).map(|n| n.class().to_string());
        Term::Node(class, thing)
    }

    fn of_class(&self, class: Option<&str>) -> Vec<NodeId> {
        let is_of = |(of, _): &&(&str, NodeId)| class.is_none_or(|class| *of == class);
        self.classes.iter().filter(is_of).map(|(_, thing)| *thing).collect()
    }

    /// The goal with quantifiers that range over the declared objects only.
    fn ranged(&self, goal: &Goal) -> Goal {
        let of = |part: &Goal| self.ranged(part);
        let boxed = |part: &Goal| Box::new(of(part));
        let all = |parts: &[Goal]| parts.iter().map(of).collect::<Vec<_>>();
        match goal {
            Goal::And(parts) => Goal::And(all(parts)),
            Goal::Or(parts) => Goal::Or(all(parts)),
            Goal::Not(part) => Goal::Not(boxed(part)),
            Goal::Imply(a, b) => Goal::Imply(boxed(a), boxed(b)),
            Goal::ForAll(q) => joined(self.each(q), Goal::And),
            Goal::Exists(q) => joined(self.each(q), Goal::Or),
            Goal::ForN { comparison, number, of } => {
                let body = Box::new(self.among(&of.variable, of.class.as_deref(), self.ranged(&of.body)));
                let of = Quantified { variable: of.variable.clone(), class: None, body };
                Goal::ForN { comparison: *comparison, number: *number, of }
            }
            Goal::ForPairs(pairs) => {
                let mut pairs = pairs.clone();
                let sides = [&pairs.first, &pairs.second].map(|v| self.of_class(v.class.as_deref()).len());
                pairs.number = pairs.number.or(Some((Comparison::AtLeast, sides[0].min(sides[1]) as u32)));
                let body = self.among(&pairs.first.name, pairs.first.class.as_deref(), self.ranged(&pairs.body));
                pairs.body = Box::new(self.among(&pairs.second.name, pairs.second.class.as_deref(), body));
                (pairs.first.class, pairs.second.class) = (None, None);
                Goal::ForPairs(pairs)
            }
            other => other.clone(),
        }
    }

    fn each(&self, q: &Quantified) -> Vec<Goal> {
        let with = |thing: NodeId| {
            let named = |term: &Term| match term {
                Term::Variable(name) if *name == q.variable => self.term(thing),
                other => other.clone(),
            };
            self.ranged(&q.body.with_terms(&named))
        };
        self.of_class(q.class.as_deref()).into_iter().map(with).collect()
    }

    /// A body that also says that a variable is one of the declared objects of a class.
    fn among(&self, variable: &str, class: Option<&str>, body: Goal) -> Goal {
        let is = |thing| Goal::Same(Term::Variable(variable.to_owned()), self.term(thing));
        Goal::And(vec![joined(self.of_class(class).into_iter().map(is).collect(), Goal::Or), body])
    }
}

fn joined(mut parts: Vec<Goal>, join: fn(Vec<Goal>) -> Goal) -> Goal {
    if parts.len() == 1 { parts.swap_remove(0) } else { join(parts) }
}
