//! The same errands in the same homes, with things placed by different rules.

#![allow(dead_code, clippy::unwrap_used, reason = "each user takes a part, and tests may unwrap")]

use vc_graph::{Draft, NodeId, Place, Relation, SceneBuilder, SceneGraph, Seed, Stream};
use vc_planner::Belief;

/// The rule by which things are placed.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Rule {
    /// On any surface, in any container, on any floor: all places are equally likely.
    Anywhere,
    /// In and on ten kinds of furniture, all kinds equally likely, whatever the thing: the rule of
    /// Watch-And-Help.
    Foreign,
    /// In furniture of one class.
    In(&'static str),
}

/// The furniture that [`Rule::Foreign`] uses.
const FURNITURE: [(Relation, &str); 10] = [
    (Relation::Inside, "kitchen_cabinet"),
    (Relation::Inside, "cabinet"),
    (Relation::Inside, "fridge"),
    (Relation::Inside, "microwave"),
    (Relation::Inside, "dishwasher"),
    (Relation::Inside, "stove"),
    (Relation::On, "cabinet"),
    (Relation::On, "coffee_table"),
    (Relation::On, "bench"),
    (Relation::On, "kitchen_table"),
];

/// The things of the errands, and the furniture to which the agent is to bring them.
const DISHES: [&str; 4] = ["plate", "water_glass", "wine_glass", "fork"];
const FOOD: [&str; 7] = ["cupcake", "juice", "pancake", "pound_cake", "wine", "pudding", "apple"];
const ERRANDS: [(&str, &str, &[&str]); 4] = [
    ("On", "kitchen_table", &DISHES),
    ("Inside", "dishwasher", &DISHES),
    ("Inside", "fridge", &FOOD),
    ("On", "kitchen_table", &FOOD),
];

/// A scene with things placed by a rule, and a goal about `number` of them.
pub(crate) fn errand(scene: &SceneGraph, rule: Rule, number: usize, seed: u64) -> (SceneGraph, String) {
    let mut stream = Seed(seed).child("errand").stream();
    let feasible: Vec<_> = ERRANDS.iter().filter(|(_, at, _)| !scene.of_class(at).is_empty()).collect();
    let (relation, at, classes) = **stream.pick(&feasible).unwrap();
    let target = scene.of_class(at)[0];
    let mut wanted = vec![0; classes.len()];
    (0..number).for_each(|_| wanted[stream.below(classes.len())] += 1);
    let mut home = cleared(scene, classes);
    for (class, wanted) in classes.iter().zip(&wanted).filter(|(_, wanted)| **wanted > 0) {
        for _ in 0..wanted + stream.below(2) {
            let place = place(home.graph(), rule, target, &mut stream);
            put(&mut home, class, place);
        }
    }
    let goal = classes.iter().zip(&wanted).filter(|(_, wanted)| **wanted > 0);
    let goal: Vec<String> =
        goal.map(|(class, wanted)| format!("{relation}({class}, {}), {wanted}", scene.label(target))).collect();
    (home.build(), goal.join(" & "))
}

/// A scene without things of some classes.
fn cleared(scene: &SceneGraph, classes: &[&str]) -> SceneBuilder {
    let mut home = SceneBuilder::from_graph(scene.clone());
    for id in classes.iter().flat_map(|class| scene.of_class(class)) {
        let mut edit = home.edit();
        edit.remove(id).unwrap();
        edit.commit();
    }
    home
}

fn put(home: &mut SceneBuilder, class: &str, place: Place) {
    let draft = Draft::new(class);
    match place.relation {
        Relation::Inside | Relation::InRoom => home.add_in(place.at, draft),
        _ => home.add_on(place.at, draft),
    }
    .unwrap();
}

/// The initial place of a thing: never its target.
fn place(scene: &SceneGraph, rule: Rule, target: NodeId, stream: &mut Stream) -> Place {
    let all = match rule {
        Rule::Anywhere => Belief::in_known_home(scene, scene.agents()[0], 0).possible_places().collect(),
        Rule::In(class) => of_class(scene, Relation::Inside, class),
        Rule::Foreign => {
            let kinds = FURNITURE.iter().map(|(relation, class)| of_class(scene, *relation, class));
            let kinds: Vec<Vec<Place>> = kinds.filter(|kind| kind.iter().any(|p| p.at != target)).collect();
            stream.pick(&kinds).unwrap().clone()
        }
    };
    let free: Vec<Place> = all.into_iter().filter(|place| place.at != target).collect();
    *stream.pick(&free).unwrap()
}

fn of_class(scene: &SceneGraph, relation: Relation, class: &str) -> Vec<Place> {
    let exact = |id: &NodeId| scene.node(*id).is_some_and(|n| &**n.class() == class);
    scene.of_class(class).into_iter().filter(exact).map(|at| Place { relation, at }).collect()
}
