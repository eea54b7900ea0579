//! No object leaves the world silently: objects that are or fall below or beside the floor, or that overlap
//! others, are put back where the scene has them, or left out and reported.

use virtualcity::graph::format::read_scene;
use virtualcity::graph::{
    Action, Bounds, ClassTable, Draft, NodeId, NodeKind, Place, Pose, Relation, SceneBuilder, Verb,
};
use virtualcity::physics::BodyRole;
use virtualcity::{Environment, MakeError, UnplacedReason};

use super::home;

/// A kitchen five metres wide with a table, optionally a floor, and mugs on the table at given positions.
struct Kitchen {
    scene: SceneBuilder,
    room: NodeId,
    table: NodeId,
}

fn kitchen(floor: bool) -> Kitchen {
    let mut scene = SceneBuilder::new("kitchen");
    let size = |size: [f32; 3]| Bounds::standing(size.into());
    let room = scene.add(Draft::new("kitchen").bounds(size([5.0, 5.0, 2.5])).at(Pose::identity())).unwrap();
    if floor {
        let slab = Draft::new("floor").bounds(size([5.0, 5.0, 0.1])).at(Pose::translation(0.0, 0.0, -0.1));
        scene.add_in(room, slab).unwrap();
    }
    let table = scene.add_in(room, Draft::new("kitchen_table").at(Pose::translation(1.5, 0.0, 0.0))).unwrap();
    Kitchen { scene, room, table }
}

impl Kitchen {
    fn mug(&mut self, at: [f32; 3], on: Option<NodeId>) -> NodeId {
        let draft = Draft::new("mug").at(Pose::translation(at[0], at[1], at[2]));
        let mug = self.scene.add_in(self.room, draft).unwrap();
        if let Some(at) = on {
            let mut edit = self.scene.edit();
            edit.place(mug, Place { relation: Relation::On, at }).unwrap();
            edit.commit();
        }
        mug
    }

    fn home(self) -> Environment {
        Environment::from_scene(self.scene.build(), 1).unwrap()
    }
}

/// Checks that every node with a body is in the home, and that none is below it.
fn is_whole(home: &Environment) {
    let world = home.world();
    assert!(world.outside().is_empty() && world.stopped().is_empty());
    for id in home.graph().nodes().filter(|n| n.kind() == NodeKind::Object).map(|n| n.id()) {
        let low = world.aabb(id).map_or(0.0, |b| b.max.z);
        assert!(low > -0.05, "{} is at {low} m", home.graph().label(id));
    }
}

#[test]
fn what_is_below_or_beside_the_floor_is_put_back() {
    for at in [[1.5, 0.0, -0.5], [1.5, 0.0, -5.0], [2.7, 0.0, 0.2], [40.0, 0.0, 1.0], [1.5, 0.0, -0.15]] {
        let mut kitchen = kitchen(true);
        let (table, mug) = (kitchen.table, kitchen.mug(at, Some(kitchen.table)));
        let home = kitchen.home();
        assert!(home.left_out().is_empty(), "{at:?}");
        assert!(home.world().supports(mug).contains(&table), "{at:?}");
        assert!(home.graph().place(mug).is_some_and(|p| p.at == table));
        is_whole(&home);
    }
}

#[test]
fn what_has_no_place_to_go_back_to_is_named() {
    for at in [[1.5, 0.0, -0.5], [2.7, 0.0, 0.2], [40.0, 0.0, 1.0]] {
        let mut kitchen = kitchen(true);
        let mug = kitchen.mug(at, None);
        let home = kitchen.home();
        let [left] = home.left_out() else { panic!("{:?}", home.left_out()) };
        // Beside the floor's edge it falls; elsewhere it is nowhere from the start.
        let told = matches!(left.why, UnplacedReason::Astray | UnplacedReason::FellOut);
        assert!(left.thing.id == mug && told, "{at:?}: {left}");
        assert!(home.graph().node(mug).is_none());
        is_whole(&home);
    }
}

/// Without a floor nothing is supported: no home is made, or the objects left in it stand.
#[test]
fn a_home_without_floor_is_none() {
    let mut kitchen = kitchen(false);
    kitchen.mug([1.5, 0.0, 0.9], Some(kitchen.table));
    match Environment::from_scene(kitchen.scene.build(), 1) {
        Ok(home) => is_whole(&home),
        Err(error) => assert!(matches!(error, MakeError::NoRoom { .. }), "{error}"),
    }
}

/// Many objects at one position are spread over their support; those that do not fit are reported.
#[test]
fn many_in_one_place_are_spread() {
    let mut kitchen = kitchen(true);
    let (table, at) = (kitchen.table, [1.5, 0.0, 0.78]);
    let mugs: Vec<NodeId> = (0..40).map(|_| kitchen.mug(at, Some(table))).collect();
    let home = kitchen.home();
    let there = mugs.iter().filter(|id| home.graph().node(**id).is_some());
    assert!(there.clone().count() > 8, "{} left out", home.left_out().len());
    assert_eq!(there.clone().count() + home.left_out().len(), mugs.len());
    // No more stand there than there is room for, and the reason says where there is none.
    assert!(
        home.left_out().iter().all(|left| matches!(&left.why, UnplacedReason::NoSpot { at, .. } if at.id == table))
    );
    for id in there {
        let p = home.world().pose(*id).unwrap().translation.vector;
        assert!((p.x - 1.5).abs() < 1.5 && p.y.abs() < 1.5, "{p}");
    }
    is_whole(&home);
}

/// Prints the time for making homes with an increasing number of objects at one position.
#[test]
#[ignore = "measures"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn many_in_one_place_cost() {
    for number in [5, 10, 20, 40, 100, 200] {
        let mut kitchen = kitchen(true);
        let table = kitchen.table;
        for _ in 0..number {
            kitchen.mug([1.5, 0.0, 0.78], Some(table));
        }
        let start = cpu_time::ThreadTime::now();
        let home = kitchen.home();
        let (seconds, left) = (start.elapsed().as_secs_f64(), home.left_out().len());
        println!("{number} mugs in one place: {seconds:.2} s, {} on the table, {left} left out", number - left);
    }
}

/// An agent that the scene has beside the floor, or in a home without one, stands on it.
#[test]
fn agents_stand_on_floors() {
    for at in [[4.0, 0.0, 0.0], [0.0, 3.5, 1.0], [0.0, 0.0, -3.0]] {
        let mut kitchen = kitchen(true);
        let agent = Draft::new("character").at(Pose::translation(at[0], at[1], at[2]));
        let agent = kitchen.scene.add_in(kitchen.room, agent).unwrap();
        let home = kitchen.home();
        let feet = home.world().pose(agent).unwrap().translation.vector;
        assert!(feet.z.abs() < 0.05 && feet.xy().amax() < 2.6, "{at:?}: {feet}");
        is_whole(&home);
    }
}

/// Objects that hung in a wardrobe which a reset removes do not stay in the air.
#[test]
fn what_loses_its_support_falls() {
    let (mut clothes, mut seed) = (0, 1);
    while clothes < 3 && seed < 12 {
        let mut home = home(seed, 1);
        let hangs = |id: &NodeId| home.world().role(*id) == Some(BodyRole::Hung);
        let wardrobe = home.graph().of_class("wardrobe").into_iter().find(|w| {
            home.graph().nodes().any(|n| home.graph().place(n.id()).is_some_and(|p| p.at == *w) && hangs(&n.id()))
        });
        seed += 1;
        let Some(wardrobe) = wardrobe else { continue };
        let start = home.graph().clone();
        let inside = |n: &virtualcity::graph::Node| start.place(n.id()).is_some_and(|p| p.at == wardrobe);
        let hung: Vec<NodeId> = start
            .nodes()
            .filter(|n| inside(n))
            .map(|n| n.id())
            .filter(|id| home.world().role(*id) == Some(BodyRole::Hung))
            .collect();
        let mut wanted = start.clone();
        let mut edit = wanted.edit();
        edit.remove(wardrobe).unwrap();
        edit.commit();
        home.reset(&wanted).unwrap();
        for id in hung {
            clothes += 1;
            let before = start.node(id).and_then(|n| n.position()).unwrap();
            let fell = home.graph().node(id).and_then(|n| n.position()).is_none_or(|now| before.z - now.z > 0.1);
            assert!(fell, "{} floats", home.graph().label(id));
        }
        is_whole(&home);
    }
    assert!(clothes > 0, "no wardrobe with clothes in twelve homes");
}

/// In a scene of boxes an object that is far from its place in the scene, above, below or beside it, is put
/// back; an object whose only place is the room is left out and reported.
#[test]
fn what_is_far_from_its_place_is_put_back() {
    let text = include_str!("../data/boxes_table.json");
    let made = |text: &str| {
        let scene = read_scene(text, &ClassTable::builtin()).unwrap();
        Environment::from_scene(scene, 1).unwrap()
    };
    for at in ["1.5, -5, 0", "1.5, -3, 0", "1.5, 20, 0", "1.5, 9000, 0", "60, 0.84, 0"] {
        let home = made(&text.replace("\"center\": [1.5, 0.84, 0]", &format!("\"center\": [{at}]")));
        let [apple, table] = ["apple", "kitchen_table"].map(|class| home.graph().of_class(class)[0]);
        assert!(home.graph().places(apple).eq([Place { relation: Relation::On, at: table }]), "{at}");
        let (own, below) = (home.world().aabb(apple).unwrap(), home.world().aabb(table).unwrap());
        assert!((own.min.z - below.max.z).abs() < 0.02, "{at}: {own:?}");
        is_whole(&home);
    }
    let text = text.replace("  {\"from_id\": 4, \"relation_type\": \"ON\", \"to_id\": 3},\n", "");
    let home = made(&text.replace("\"center\": [1.5, 0.84, 0]", "\"center\": [10, 0.9, 10]"));
    assert!(home.graph().of_class("apple").is_empty());
    assert!(home.left_out().iter().any(|left| &*left.thing.class == "apple"), "{:?}", home.left_out());
}

/// Agents that a graph has in the void, or several at one position, are put onto the floor, apart, and
/// reported.
#[test]
fn agents_in_the_void_or_in_one_place_are_put_apart() {
    let mut home = home(3, 3);
    let agents = home.agents().to_vec();
    for [x, y] in [[500.0, 0.0], [9000.0, -9000.0]] {
        let mut graph = home.start().clone();
        let mut edit = graph.edit();
        edit.set_pose(agents[0], Some(Pose::translation(x, y, 1.0))).unwrap();
        edit.commit();
        let report = home.reset(&graph).unwrap();
        assert!(report.elsewhere.iter().any(|e| e.thing.id == agents[0]), "{:?}", report.elsewhere);
        assert!(!home.world().agent(agents[0]).is_ok_and(|agent| agent.is_off_floor()));
        let room = home.graph().room_of(agents[0]).unwrap();
        home.set_action(agents[0], Action::one(Verb::Walk, room)).unwrap();
    }
    let mut graph = home.start().clone();
    let first = *graph.node(agents[0]).unwrap().pose().unwrap();
    let mut edit = graph.edit();
    agents.iter().for_each(|agent| edit.set_pose(*agent, Some(first)).unwrap());
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert_eq!(report.elsewhere.iter().map(|e| e.thing.id).collect::<Vec<_>>(), agents[1..]);
    let at = |agent: NodeId| home.world().pose(agent).unwrap().translation.vector.xy();
    for (i, a) in agents.iter().enumerate() {
        assert!(agents[..i].iter().all(|b| (at(*a) - at(*b)).norm() > 0.5));
    }
}
