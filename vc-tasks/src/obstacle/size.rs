//! Goals that range over more objects than anybody would wait for.

use vc_graph::SceneGraph;
use vc_graph::goal::{Goal, Literal, Term};

use super::Obstacle;

/// The largest number of choices of objects for which a part is evaluated: some seconds each time.
const MOST: f64 = 1e8;

/// The parts of a goal that range over too many choices of objects.
pub(crate) fn too_large(goal: &Goal, graph: &SceneGraph) -> impl Iterator<Item = Obstacle> {
    let sized = goal.conjuncts().iter().map(|part| (part, choices(part, graph)));
    sized
        .filter(|(_, choices)| *choices > MOST)
        .map(|(part, choices)| Obstacle::TooManyChoices { part: part.to_string(), choices })
}

/// The number of choices of objects for the literals of a goal.
fn choices(goal: &Goal, graph: &SceneGraph) -> f64 {
    let of_class = |class: Option<&str>| class.map_or(graph.len(), |class| graph.of_class(class).len()) as f64;
    match goal {
        Goal::Literal(literal) | Goal::Count { literal, .. } => of_literal(literal, graph),
        Goal::ForAll(q) | Goal::Exists(q) | Goal::ForN { of: q, .. } => {
            of_class(q.class.as_deref()) * choices(&q.body, graph)
        }
        Goal::ForPairs(pairs) => {
            let both = [&pairs.first, &pairs.second].map(|variable| of_class(variable.class.as_deref()));
            both.iter().product::<f64>() * choices(&pairs.body, graph)
        }
        _ => goal.parts().into_iter().map(|part| choices(part, graph)).sum(),
    }
}

fn of_literal(literal: &Literal, graph: &SceneGraph) -> f64 {
    let of_term = |term: &Term| match term {
        Term::Class(class) => graph.of_class(class).len(),
        Term::Anything => graph.len(),
        _ => 1,
    };
    literal.terms.iter().map(|term| of_term(term) as f64).product()
}
