//! Impossible requests are reported, and possible ones are fulfilled.

use virtualcity::graph::{Bounds, Draft, NodeId, Place, Pose, Relation, SceneBuilder, SceneGraph};
use virtualcity::{ActionError, AlterError, Environment, MakeError, SaveError};

use super::home;

/// One kitchen with a floor and a chair.
fn hall(side: f32) -> SceneGraph {
    let mut scene = SceneBuilder::new("hall");
    let room = Draft::new("kitchen").bounds(Bounds::standing([side, side, 3.0].into())).at(Pose::identity());
    let room = scene.add(room).unwrap();
    let slab = Bounds::standing([side, side, 0.1].into());
    scene.add_in(room, Draft::new("floor").bounds(slab).at(Pose::translation(0.0, 0.0, -0.1))).unwrap();
    let chair = Bounds::standing([0.5, 0.5, 0.9].into());
    scene.add_in(room, Draft::new("chair").bounds(chair).at(Pose::translation(1.0, 1.0, 0.0))).unwrap();
    scene.build()
}

/// The whole floor is used for agents: more than one in each ring around the middle, and all apart from each
/// other.
#[test]
fn agents_find_room_on_all_the_floor() {
    let home = Environment::from_scene(hall(12.0), 60).unwrap();
    let at = |id: &NodeId| home.world().pose(*id).unwrap().translation.vector.xy();
    let feet: Vec<_> = home.agents().iter().map(at).collect();
    assert_eq!(feet.len(), 60);
    let apart = |i: usize| feet[i + 1..].iter().all(|other| (other - feet[i]).norm() > 0.75);
    assert!((0..feet.len()).all(apart));
    assert_eq!(Environment::from_scene(hall(60.0), 1000).unwrap().agents().len(), 1000);
    match Environment::from_scene(hall(4.0), 100).unwrap_err() {
        MakeError::NoRoom { asked: 100, found } => assert!((9..=25).contains(&found), "{found}"),
        other => panic!("{other}"),
    }
}

#[test]
fn what_is_not_set_down_in_a_home_is_refused_at_once() {
    let mut home = home(42, 1);
    let (kitchen, table) = (home.graph().of_class("kitchen")[0], home.graph().of_class("coffee_table")[0]);
    let on = |at| Place { relation: Relation::On, at };
    for class in ["door", "window", "wall", "water", "car", "character", "kitchen"] {
        for at in [kitchen, table] {
            assert!(matches!(home.spawn(class, on(at)), Err(AlterError::NoThing { .. })), "{class}");
        }
    }
    let me = home.agents()[0];
    let told = home.spawn("apple", on(me)).unwrap_err();
    assert_eq!(told, AlterError::OnAgent(home.graph().label(me)));
    assert!(matches!(
        home.spawn("apple", Place { relation: Relation::InRoom, at: table }),
        Err(AlterError::NotAPlace(Relation::InRoom))
    ));
    let chair = home.spawn("chair", Place { relation: Relation::InRoom, at: kitchen }).unwrap();
    assert_eq!(home.graph().room_of(chair), Some(kitchen));
}

/// Trailing bytes after a saved environment are refused, and agents are named one by one.
#[test]
fn errors_say_which_and_how_much() {
    let mut home = Environment::from_scene(hall(6.0), 1).unwrap();
    let mut bytes = home.save().unwrap();
    assert!(home.restore(&bytes).is_ok());
    bytes.extend(b"more");
    assert!(matches!(home.restore(&bytes), Err(SaveError::More(4))));
    let told = home.reset(&hall(6.0)).unwrap_err().to_string();
    let me = home.graph().label(home.agents()[0]);
    assert!(told.starts_with(&format!("the graph has no agents, this environment has the agents {me}")), "{told}");
    assert!(home.observation(NodeId(9999), 3.0).is_empty());
}

/// The class in a label is checked when the action is performed.
#[test]
fn actions_with_labels_of_other_things_are_refused() {
    let mut home = Environment::from_scene(hall(6.0), 1).unwrap();
    let (me, chair) = (home.agents()[0], home.graph().of_class("chair")[0]);
    let before = home.digest();
    let wrong = home.set_action(me, format!("walk apple.{}", chair.0).parse().unwrap());
    assert!(matches!(wrong, Err(ActionError::Refused(_))), "{wrong:?}");
    assert_eq!(home.digest(), before);
    assert!(home.set_action(me, format!("walk chair.{}", chair.0).parse().unwrap()).is_ok());
}
