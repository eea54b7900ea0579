//! Environments: generated homes with bodies, in which agents act.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod agreement;
#[path = "environment/astray.rs"]
mod astray;
mod common;
#[path = "environment/stays.rs"]
mod stays;

use flate2::Compression;
use flate2::write::GzEncoder;
use virtualcity::graph::format::{native, read_scene, thesis};
use virtualcity::graph::{
    Action, ClassTable, Draft, Kind, Node, NodeId, Place, Pose, Property, Relation, SceneGraph, Seed, State, Verb,
    Violation,
};
use virtualcity::physics::{Hand, Posture};
use virtualcity::planner::{Newcomer, Run};
use virtualcity::procgen::Apartment;
use virtualcity::relations::{Relations, Rule};
use virtualcity::tasks::{Outcome, Task, World as _};
use virtualcity::{ActionError, AlterError, Batch, Environment, MakeError, Spot, Why, check_environment, run};

fn home(seed: u64, agents: usize) -> Environment {
    Environment::make(&format!("apartment/{seed}"), agents).unwrap()
}

fn act(home: &mut Environment, agent: NodeId, verb: Verb, things: &[NodeId]) {
    let action = Action::with(verb, things).unwrap();
    let done = home.set_action(agent, action);
    assert!(done.is_ok(), "{}: {}", action.describe(home.graph()), done.unwrap_err());
}

/// Random actions, legal and not, do no harm, and the bodies do what the rule says.
#[test]
fn random_actions_do_no_harm() {
    for seed in [8, 42] {
        let mut home = home(seed, 2);
        let tally = run(&mut home, 80, Seed(seed));
        assert!(tally.breaches.is_empty(), "{:?}", tally.breaches);
        assert!(tally.done > 20, "{tally:?}");
        assert_eq!(tally.disagreements, [""; 0]);
    }
}

/// As many as are asked of a release; `HOMES`, `ACTIONS` and `FROM` choose others.
#[test]
#[ignore = "takes long"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn many_random_actions() {
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    let (from, homes, actions) = (number("FROM", 1), number("HOMES", 20), number("ACTIONS", 10_000));
    let (mut done, mut breaches, mut disagreements, mut impossible) = (0, 0, 0, 0);
    for seed in from..from + homes {
        let mut home = home(seed, 2);
        let tally = run(&mut home, actions as usize, Seed(seed));
        println!("{}: {} done, {} refused", home.graph().name(), tally.done, tally.refused);
        let show = |what: &str, all: &[String]| all.iter().take(12).for_each(|text| println!("  {what}: {text}"));
        show("impossible", &tally.impossible);
        show("disagreement", &tally.disagreements);
        tally.breaches.iter().take(4).for_each(|breach| println!("  breach: {breach}"));
        done += tally.done;
        breaches += tally.breaches.len();
        disagreements += tally.disagreements.len();
        impossible += tally.impossible.len();
    }
    println!("{done} done, {impossible} impossible, {disagreements} disagreements, {breaches} breaches");
    assert_eq!(breaches, 0);
}

/// Of equal scenes and bodies those are not the same in which other things were done.
#[test]
fn digests_tell_what_was_done() {
    let (mut first, mut second) = (home(42, 1), home(42, 1));
    let me = first.agents()[0];
    act(&mut first, me, Verb::Dance, &[]);
    act(&mut second, me, Verb::Wave, &[]);
    assert_ne!(first.digest(), second.digest());
}

/// More agents than there is floor for are refused before anything is made for them.
#[test]
fn crowds_are_refused() {
    let crowd = Environment::make("apartment/42", 1_000_000_000);
    assert!(matches!(crowd, Err(MakeError::NoRoom { .. })));
}

/// Plates, bowls and spoons come out with the racks, and go in again with them.
#[test]
fn what_is_in_racks_comes_along() {
    let mut home = home(5, 1);
    let (me, dishwasher) = (home.agents()[0], home.graph().of_class("dishwasher")[0]);
    let inside = home.graph().carried_with(dishwasher);
    let things: Vec<NodeId> = inside.into_iter().filter(|id| *id != dishwasher).collect();
    assert!(things.len() > 3, "{things:?}");
    let places = |home: &Environment| things.iter().map(|id| home.world().pose(*id).unwrap()).collect::<Vec<_>>();
    let far = |a: &[Pose], b: &[Pose]| -> Vec<f32> {
        a.iter().zip(b).map(|(a, b)| (a.translation.vector - b.translation.vector).norm()).collect()
    };
    let shut = places(&home);
    act(&mut home, me, Verb::Walk, &[dishwasher]);
    act(&mut home, me, Verb::Open, &[dishwasher]);
    let open = places(&home);
    assert!(far(&shut, &open).iter().all(|d| *d > 0.3), "{:?}", far(&shut, &open));
    act(&mut home, me, Verb::Close, &[dishwasher]);
    let again = places(&home);
    assert!(far(&shut, &again).iter().all(|d| *d < 0.08), "{:?}", far(&shut, &again));
}

/// The contract of Gymnasium's checker and more.
#[test]
fn the_contract_is_kept() {
    for (name, agents) in [("apartment/8", 2), ("apartment/5", 1), ("apartment/21", 3)] {
        let breaches = check_environment(|| Environment::make(name, agents), 40, Seed(3)).unwrap();
        assert!(breaches.is_empty(), "{name}: {breaches:?}");
    }
}

/// A home that was written to a file and read again.
#[test]
fn scenes_are_made_of_files() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("apartment_42.json");
    std::fs::write(&file, native::write(&Apartment::from_seed(Seed(42)).unwrap().scene())).unwrap();
    let name = format!("scene:{}", file.display());
    let (read, made) = (Environment::make(&name, 1).unwrap(), home(42, 1));
    assert_eq!(read.graph().len(), made.graph().len());
    assert_eq!(read.left_out().len(), made.left_out().len());
    let breaches = check_environment(|| Environment::make(&name, 2), 20, Seed(4)).unwrap();
    assert!(breaches.is_empty(), "{breaches:?}");
    let packed = file.with_extension("json.gz");
    let mut encoder = GzEncoder::new(std::fs::File::create(&packed).unwrap(), Compression::fast());
    std::io::copy(&mut std::fs::File::open(&file).unwrap(), &mut encoder).unwrap();
    encoder.finish().unwrap();
    let unpacked = Environment::make(&format!("scene:{}", packed.display()), 1).unwrap();
    assert_eq!(unpacked.digest(), read.digest());
}

#[test]
fn names_that_are_none_are_refused() {
    assert!(matches!(Environment::make("house/1", 1), Err(MakeError::UnknownName(_))));
    assert!(matches!(Environment::make("apartment/one", 1), Err(MakeError::BadSeed(_))));
    assert!(matches!(Environment::make("scene:no/such/file", 1), Err(MakeError::File { .. })));
    assert!(matches!(Environment::make("apartment/8", 100_000), Err(MakeError::NoRoom { .. })));
    assert!(matches!(Environment::make("apartment/8", 0), Err(MakeError::NoAgents)));
}

/// What is refused says why and changes nothing.
#[test]
fn refusals_change_nothing() {
    let mut home = home(8, 1);
    let (me, before) = (home.agents()[0], home.digest());
    let far = home.graph().nodes().filter(|n| n.kind() == Kind::Object).map(|n| n.id());
    let far = far.filter(|id| !home.graph().near(me, *id)).last().unwrap();
    let refused = home.set_action(me, Action::one(Verb::Touch, far)).unwrap_err();
    assert!(matches!(&refused, ActionError::Refused(why) if !why.is_empty()), "{refused}");
    assert!(home.set_action(NodeId(u32::MAX), Action::zero(Verb::Dance)).is_err());
    assert!(home.set_action(me, Action::one(Verb::Grab, NodeId(u32::MAX))).is_err());
    let twice = home.set_actions(&[(me, Action::zero(Verb::Wave)), (me, Action::zero(Verb::Dance))]);
    assert!(twice.iter().all(|o| matches!(o, Err(ActionError::Twice(_)))));
    assert_eq!(home.digest(), before);
}

/// A thing inside something that opens, both in one home.
fn kept_thing(home: &Environment) -> Option<(NodeId, NodeId)> {
    let graph = home.graph();
    let moves = |id: NodeId| !home.world().moving_parts(id).is_empty();
    let small = |id: &NodeId| home.world().role(*id) == Some(virtualcity::physics::Role::Loose);
    let inside = |at: NodeId| graph.relating(Relation::Inside, at).find(small).map(|id| (id, at));
    graph.nodes().filter(|n| n.hides_contents() && moves(n.id())).find_map(|n| inside(n.id()))
}

/// Fetching a thing out of what is shut: the door really opens, the thing is in the hand,
/// and then it stands on a table at rest.
#[test]
fn a_thing_is_fetched_and_put_on_a_table() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (thing, cupboard) = kept_thing(&home).unwrap();
    act(&mut home, me, Verb::Walk, &[cupboard]);
    act(&mut home, me, Verb::Open, &[cupboard]);
    assert!(home.world().openness(cupboard).unwrap() > 0.3);
    act(&mut home, me, Verb::Grab, &[thing]);
    assert_eq!(home.world().held(me, Hand::Right), Some(thing));
    let (body, held) = (home.world().pose(me).unwrap(), home.world().aabb(thing).unwrap().centre());
    let local = body.inverse_transform_point(&held);
    assert!(local.x > 0.2 && local.x < 0.8 && local.z > 0.7, "{local:?}");
    act(&mut home, me, Verb::Close, &[cupboard]);
    assert_eq!(home.world().open_state(cupboard), Some(State::Closed));
    let table = ["kitchen_table", "dining_table", "coffee_table", "desk"];
    let table = table.iter().find_map(|c| home.graph().of_class(c).first().copied()).unwrap();
    act(&mut home, me, Verb::Walk, &[table]);
    act(&mut home, me, Verb::Place, &[thing, table]);
    assert!(home.graph().places(thing).any(|p| p == Place { relation: Relation::On, at: table }));
    assert!(home.world().supports(thing).contains(&table) && home.world().is_asleep(thing));
    assert_eq!(home.history().events().len(), 6);
    // Back to the beginning.
    let start = home.start().clone();
    home.reset(&start).unwrap();
    assert_eq!(home.graph(), &start);
    assert!(home.history().events().is_empty());
}

/// In time and at once lead to the same end, and nobody walks faster than people do.
#[test]
fn time_changes_nothing_but_what_is_seen() {
    let (mut at_once, mut in_time) = (home(42, 2), home(42, 2));
    let agents = at_once.agents().to_vec();
    let (_, cupboard) = kept_thing(&at_once).unwrap();
    let room = at_once.graph().room_of(cupboard).unwrap();
    let both = [(agents[0], Action::one(Verb::Walk, cupboard)), (agents[1], Action::one(Verb::Walk, room))];
    let open = [(agents[0], Action::one(Verb::Open, cupboard)), (agents[1], Action::zero(Verb::Wave))];
    let mut ticks = 0;
    for actions in [both, open] {
        assert!(at_once.set_actions(&actions).iter().all(Result::is_ok));
        let mut last = in_time.world().pose(agents[0]).unwrap().translation.vector;
        let outcomes = in_time.set_actions_in_time(&actions, |now| {
            let at = now.world().pose(agents[0]).unwrap().translation.vector;
            assert!((at - last).norm() < 0.1, "a leap of {} m", (at - last).norm());
            (last, ticks) = (at, ticks + 1);
        });
        assert!(outcomes.iter().all(Result::is_ok));
        assert_eq!(at_once.digest(), in_time.digest());
    }
    assert!(ticks > 100, "{ticks}");
}

/// Things that are added and moved in the graph get places in the home; what has none is
/// left out and reported.
#[test]
fn graphs_are_put_in_force() {
    let mut home = home(42, 1);
    let mut graph = home.start().clone();
    let table = graph.of_class("table").into_iter().find(|t| home.world().aabb(*t).is_some()).unwrap();
    let room = graph.room_of(table).unwrap();
    let mut edit = graph.edit();
    let apple = edit.add(Draft::new("apple")).unwrap();
    edit.move_to_room(apple, room).unwrap();
    edit.place(apple, Place { relation: Relation::On, at: table }).unwrap();
    let lost = edit.add(Draft::new("apple")).unwrap();
    edit.move_to_room(lost, room).unwrap();
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert_eq!(report.added, [apple, lost]);
    assert_eq!(report.unplaced.len(), 1);
    assert_eq!((report.unplaced[0].thing.id, &report.unplaced[0].why), (lost, &Why::Nowhere));
    assert!(home.graph().node(lost).is_none());
    assert!(home.graph().places(apple).any(|p| p.at == table), "{:?}", home.graph().place(apple));
    assert!(home.world().supports(apple).contains(&table));
}

/// A reset tells what it moved, added and took away, what found no place and why, what came to rest
/// elsewhere, and who could not sit down where the graph says.
#[test]
fn resets_report() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let start = home.start().clone();
    let (table, sofa) = (start.of_class("coffee_table")[0], start.of_class("sofa")[0]);
    let lamp = start.of_class("ceiling_lamp")[0];
    let loose = |id: &NodeId| home.world().role(*id) == Some(virtualcity::physics::Role::Loose);
    let on_table: Vec<NodeId> = start.relating(Relation::On, table).filter(loose).collect();
    let [gone, moved] = on_table[..2] else { panic!("{on_table:?} on the table") };
    let mut graph = start.clone();
    let mut edit = graph.edit();
    edit.remove(gone).unwrap();
    // Above another spot: it falls down there.
    let up = start.node(moved).unwrap().pose().unwrap();
    edit.set_pose(moved, Some(Pose::translation(0.0, 0.0, 0.4) * up)).unwrap();
    // Nothing as large as a bed is free on a coffee table, and nothing is on what has no body.
    let bed = edit.add(Draft::new("bed")).unwrap();
    edit.place(bed, Place { relation: Relation::On, at: table }).unwrap();
    let idea = edit.add(Draft::new("thought")).unwrap();
    let apple = edit.add(Draft::new("apple")).unwrap();
    edit.place(apple, Place { relation: Relation::On, at: idea }).unwrap();
    // One who is far away cannot sit there.
    edit.place(other, Place { relation: Relation::SittingOn, at: sofa }).unwrap();
    edit.enter_state(other, State::Sitting).unwrap();
    edit.place(me, Place { relation: Relation::SittingOn, at: lamp }).unwrap();
    edit.enter_state(me, State::Sitting).unwrap();
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert_eq!((report.removed, report.added), (vec![gone], vec![bed, idea, apple]));
    assert!(report.moved.contains(&moved) && report.moved.len() <= 2, "{:?}", report.moved);
    let why = |id: NodeId| report.unplaced.iter().find(|u| u.thing.id == id).map(|u| u.why.clone());
    assert!(matches!(why(bed), Some(Why::NoSpot(Relation::On, at)) if at.id == table), "{:?}", why(bed));
    assert_eq!(why(idea), Some(Why::NoShape));
    assert!(matches!(why(apple), Some(Why::NoSupport(at)) if at.id == idea), "{:?}", why(apple));
    // A lamp is no seat: one stands, the graph says so, and the report says what was wanted.
    let stands = report.elsewhere.iter().find(|e| e.thing.id == me).unwrap();
    assert_eq!(stands.wanted, Place { relation: Relation::SittingOn, at: lamp });
    let sits = |id: NodeId| home.graph().node(id).unwrap().is(State::Sitting);
    let seated = |id: NodeId| home.posture(id) != Some(virtualcity::physics::Posture::Standing);
    assert!(!sits(me) && !seated(me));
    assert_eq!(sits(other), seated(other), "graph and body say the same of who sits on the sofa");
    // What falls comes to lie on whatever is there.
    let known = home.start().validate();
    let news = home.graph().validate().into_iter().filter(|v| !known.contains(v));
    let broken: Vec<Violation> = news.filter(|v| !matches!(v, Violation::NotASurface(..))).collect();
    assert_eq!(broken, []);
    // Nothing of it is left after the next one.
    let again = home.reset(&start).unwrap();
    assert_eq!(again, virtualcity::ResetReport::default());
    assert_eq!(home.graph(), &start);
}

/// Of a glTF file, how the nodes below the node of a name are turned: the scalars of their rotations.
fn turns(file: &[u8], name: &str) -> Vec<f64> {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let document: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let nodes = document["nodes"].as_array().unwrap();
    let node = nodes.iter().find(|n| n["name"] == name).unwrap();
    let children = node["children"].as_array().unwrap().iter().map(|child| &nodes[child.as_u64().unwrap() as usize]);
    children.map(|n| n["rotation"][3].as_f64().unwrap_or(1.0).abs()).collect()
}

/// In the glTF of a home doors are as far open as they are, and people sit who do.
#[test]
fn homes_are_exported_as_they_are() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    let names = [fridge, me].map(|id| home.graph().label(id).to_string());
    let before = home.gltf().unwrap();
    let sofa = home.graph().of_class("sofa")[0];
    for (verb, thing) in [(Verb::Walk, fridge), (Verb::Open, fridge), (Verb::Walk, sofa), (Verb::Sit, sofa)] {
        act(&mut home, me, verb, &[thing]);
    }
    let now = home.gltf().unwrap();
    for name in names {
        let (was, is) = (turns(&before, &name), turns(&now, &name));
        let turned = was.iter().zip(&is).filter(|(a, b)| (*a - *b).abs() > 0.1).count();
        assert!(turned >= 2, "{name}: {was:?}, then {is:?}");
    }
}

/// The same bytes in any thread, in a batch or alone, whatever the order.
#[test]
fn threads_change_nothing() {
    let actions = |home: &Environment| -> Vec<(NodeId, Action)> {
        let cupboard = kept_thing(home).map(|(_, at)| at).unwrap_or(home.graph().rooms()[0]);
        vec![(home.agents()[1], Action::zero(Verb::Dance)), (home.agents()[0], Action::one(Verb::Walk, cupboard))]
    };
    let names = || [8_u64, 42, 8].map(|s| format!("apartment/{s}"));
    let mut batch = Batch::make(names(), 2).unwrap();
    let all: Vec<_> = batch.environments().iter().map(&actions).collect();
    assert!(batch.set_actions(&all).iter().flatten().all(Result::is_ok));
    let handles = names().map(|name| {
        std::thread::spawn(move || {
            let mut home = Environment::make(&name, 2).unwrap();
            let mut own = actions(&home);
            own.reverse();
            home.set_actions(&own);
            home.digest()
        })
    });
    let alone: Vec<_> = handles.into_iter().map(|h| h.join().unwrap()).collect();
    let together: Vec<_> = batch.environments().iter().map(Environment::digest).collect();
    assert_eq!(alone, together);
    assert_eq!(alone[0], alone[2]);
}

/// The planner's human-like agent does a task in a home with bodies, through `World`.
#[test]
fn the_planner_works_with_bodies() {
    use virtualcity::graph::Scope;
    use virtualcity::planner::{Agent, Decision};
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (thing, _) = kept_thing(&home).unwrap();
    let goal = format!("Holds({})", home.graph().node(thing).unwrap().class()).parse().unwrap();
    let mut agent = Agent::newcomer(home.graph(), me, goal, 7);
    let world: &mut dyn virtualcity::tasks::World = &mut home;
    for _ in 0..120 {
        agent.see(&world.graph().observe(me, Scope::Room));
        let Decision::Act(action, _) = agent.decide() else { break };
        let words = action.describe(world.graph()).to_string();
        let done = world.step(me, &action);
        assert!(done.is_ok(), "{words}: {}", done.unwrap_err());
        agent.did(&action);
    }
    let class = home.start().node(thing).unwrap().class().clone();
    assert!(SceneGraph::held(home.graph(), me).any(|id| home.graph().node(id).unwrap().class() == &class));
    let start = home.start().clone();
    home.step(me, &Action::zero(Verb::Dance)).unwrap();
    virtualcity::tasks::World::reset(&mut home, &start).unwrap();
    assert_eq!(home.graph(), &start);
}

/// Blinds hang higher than hands reach: their cords hang down.
#[test]
fn blinds_are_let_down_by_their_cords() {
    let mut let_down = 0;
    for seed in 0..3 {
        let mut home = home(seed, 1);
        let me = home.agents()[0];
        for id in home.graph().of_class("blinds") {
            act(&mut home, me, Verb::Walk, &[id]);
            act(&mut home, me, Verb::Close, &[id]);
            assert!(home.graph().node(id).is_some_and(|n| n.is(State::Closed)));
            let_down += 1;
        }
    }
    assert!(let_down >= 3, "{let_down} blinds");
}

/// Bowls that hop on a rack come back with it.
#[test]
fn a_dishwasher_shuts_however_its_bowls_lie() {
    let mut home = Environment::make("apartment/5", 1).unwrap();
    let me = home.agents()[0];
    let dishwasher = home.graph().of_class("dishwasher")[0];
    let inside = |home: &Environment| {
        let mut all: Vec<NodeId> = home.graph().relating(Relation::Inside, dishwasher).collect();
        all.sort_unstable();
        all
    };
    let full = inside(&home);
    assert!(full.len() > 4, "{full:?}");
    let plate = home.graph().of_class("soup_plate")[0];
    let cabinet = home.graph().hidden_in(plate).unwrap();
    for (verb, thing) in [(Verb::Walk, dishwasher), (Verb::Open, cabinet), (Verb::Grab, plate)] {
        home.set_action(me, Action::one(verb, thing)).unwrap();
    }
    for _ in 0..3 {
        for verb in [Verb::Open, Verb::Close] {
            home.set_action(me, Action::one(verb, dishwasher)).unwrap();
            assert_eq!(inside(&home), full, "{verb:?}");
        }
    }
}

/// The thesis's JSON carries no shapes: a home that is written in it comes back with the same boxes
/// in the same places, and stands.
#[test]
fn a_home_comes_back_from_the_thesis_form() {
    for seed in [42, 3] {
        let made = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let read = thesis::read(&thesis::write(&made), made.classes()).unwrap();
        for (old, new) in made.nodes().zip(read.nodes()) {
            assert_eq!((old.id(), old.class(), old.states()), (new.id(), new.class(), new.states()));
            let (Some(was), Some(is)) = (old.aabb(), new.aabb()) else { continue };
            let off = (was.min - is.min).norm().max((was.max - is.max).norm());
            assert!(off < 2e-3, "{}: {was:?} {is:?}", old.label());
        }
        let home = Environment::of(read, 1).unwrap();
        assert_eq!(home.left_out(), []);
        let stays = |n: &&Node| {
            let now = home.graph().node(n.id()).and_then(|n| n.position());
            n.position().zip(now).is_none_or(|(was, is)| (was - is).norm() < 0.25)
        };
        let strayed: Vec<_> = made.nodes().filter(|n| n.kind() == Kind::Object && !stays(n)).map(Node::label).collect();
        assert!(strayed.is_empty(), "{strayed:?}");
        let at = |graph: &SceneGraph, id| graph.place(id).filter(|p| p.relation == Relation::Inside);
        let carried = || made.nodes().filter(|n| n.affords(Property::Graspable) && at(&made, n.id()).is_some());
        let same = carried().filter(|n| at(&made, n.id()) == at(home.graph(), n.id())).count();
        assert_eq!(same, carried().count());
    }
}

/// A scene of which only boxes are known.
fn boxes(text: &str) -> Environment {
    Environment::of(read_scene(text, &ClassTable::builtin()).unwrap(), 1).unwrap()
}

fn one(home: &Environment, class: &str) -> NodeId {
    home.graph().of_class(class)[0]
}

/// Tables of boxes carry, fridges of boxes hold.
#[test]
fn things_are_put_on_and_into_boxes() {
    let mut home = boxes(include_str!("data/boxes_table.json"));
    let [me, table, apple, fridge, milk] =
        [home.agents()[0], one(&home, "kitchen_table"), one(&home, "apple"), one(&home, "fridge"), one(&home, "milk")];
    assert!(home.elsewhere().is_empty(), "{:?}", home.elsewhere());
    assert_eq!(home.graph().hidden_in(milk), Some(fridge));
    assert!(home.graph().places(milk).eq([Place { relation: Relation::Inside, at: fridge }]));
    act(&mut home, me, Verb::Walk, &[apple]);
    act(&mut home, me, Verb::Grab, &[apple]);
    act(&mut home, me, Verb::Place, &[apple, table]);
    assert!(home.world().supports(apple).contains(&table));
    act(&mut home, me, Verb::Grab, &[apple]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    act(&mut home, me, Verb::Open, &[fridge]);
    act(&mut home, me, Verb::PutIn, &[apple, fridge]);
    act(&mut home, me, Verb::Close, &[fridge]);
    assert_eq!(home.graph().hidden_in(apple), Some(fridge));
}

/// A mug in a closed box is in the box only, and goes along when that is carried.
#[test]
fn contents_of_boxes_go_along() {
    let mut home = boxes(include_str!("data/boxes_mug.json"));
    let [me, carton, mug, fridge] =
        [home.agents()[0], one(&home, "cardboard_box"), one(&home, "mug"), one(&home, "fridge")];
    assert!(home.graph().places(mug).eq([Place { relation: Relation::Inside, at: carton }]));
    let within = |home: &Environment| {
        let at = |id| home.world().pose(id).unwrap().translation.vector;
        (at(mug) - at(carton)).norm()
    };
    let was = within(&home);
    act(&mut home, me, Verb::Walk, &[carton]);
    act(&mut home, me, Verb::Grab, &[carton]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    assert!((within(&home) - was).abs() < 1e-3);
    assert_eq!(home.graph().hidden_in(mug), Some(carton));
    act(&mut home, me, Verb::Drop, &[carton]);
    assert!((within(&home) - was).abs() < 0.02);
    assert!(home.graph().places(mug).eq([Place { relation: Relation::Inside, at: carton }]));
    let start = home.start().clone();
    let report = home.reset(&start).unwrap();
    assert!(report.elsewhere.is_empty(), "{:?}", report.elsewhere);
    assert_eq!(home.graph().digest(), start.digest());
}

/// VirtualHome's scenes: one walks to every room that they have, doors lead where the scenes say, and
/// things are taken and put back.
#[test]
fn scenes_of_boxes_are_lived_in() {
    for number in common::SCENES {
        let Some(data) = common::data() else { return };
        let file = data.join(format!("virtualhome/scene{number}.json.gz"));
        let home = Environment::make(&format!("scene:{}", file.display()), 1).unwrap();
        let scene = common::scene(number).unwrap();
        assert_eq!(home.left_out(), []);
        let off = |n: &&Node| {
            let now = home.graph().node(n.id()).and_then(Node::position);
            n.kind() == Kind::Object && n.position().zip(now).is_none_or(|(was, is)| (was - is).norm() > 0.05)
        };
        let moved: Vec<_> = scene.nodes().filter(off).map(Node::label).collect();
        assert!(moved.is_empty(), "{number}: {moved:?}");
        let me = home.agents()[0];
        for &room in home.graph().rooms() {
            act(&mut home.clone(), me, Verb::Walk, &[room]);
        }
        let doors = scene.edges().filter(|e| e.relation == Relation::Between);
        doors.for_each(|edge| assert!(home.graph().has(edge), "{number}: {edge}"));
    }
}

/// The planner, which does not know the home, does everyday things in a scene of boxes.
#[test]
fn the_planner_lives_in_boxes() {
    let Some(data) = common::data() else { return };
    let file = data.join("virtualhome/scene1.json.gz");
    let home = Environment::make(&format!("scene:{}", file.display()), 1).unwrap();
    let goals = Task::read_list(include_str!("../examples/data/box_goals.txt")).unwrap();
    assert_eq!(goals.len(), 40);
    for title in ["bread in the fridge", "a book on the bed", "listen to the radio"] {
        let task = goals.iter().find(|t| t.title == title).unwrap();
        let episode = Run::seeded(1).episode(&mut Newcomer::best(), task, &mut home.clone(), &mut |_| {});
        assert_eq!(episode.outcome, Outcome::Won, "{title}: {:?}", episode.reason);
    }
}

/// Relations are those that a home as it is would be read to have.
fn is_as_read(home: &Environment) {
    let read = Relations::new(home.graph(), Rule::Repaired, home.relations().evidence().clone()).unwrap();
    assert_eq!(home.relations().edges(), read.edges());
}

/// A spawned thing is there as if it had always been: it stands, is related, is taken, saved and restored.
#[test]
fn things_appear_where_they_are_wanted() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let first = |home: &Environment, class: &str| home.graph().of_class(class)[0];
    let (table, fridge, kitchen) = (first(&home, "coffee_table"), first(&home, "fridge"), first(&home, "kitchen"));
    let on = |at| Place { relation: Relation::On, at };
    let apple = home.spawn("apple", on(table)).unwrap();
    let milk = home.spawn("milk", Place { relation: Relation::Inside, at: fridge }).unwrap();
    let chair = home.spawn("chair", on(kitchen)).unwrap();
    assert!(home.graph().has(virtualcity::graph::Edge::new(apple, Relation::On, table)));
    assert_eq!((home.graph().hidden_in(milk), home.graph().room_of(milk)), (Some(fridge), Some(kitchen)));
    assert_eq!(home.graph().room_of(chair), Some(kitchen));
    is_as_read(&home);
    // The apple is put into a basket, and comes along when the basket is put elsewhere.
    let bedroom = first(&home, "bedroom");
    let basket = home.spawn("laundry_basket", on(kitchen)).unwrap();
    home.put(apple, Place { relation: Relation::Inside, at: basket }).unwrap();
    home.put(basket, on(bedroom)).unwrap();
    let where_it_is = (home.graph().place(apple).map(|p| p.at), home.graph().room_of(apple));
    assert_eq!(
        where_it_is,
        (Some(basket), Some(bedroom)),
        "{:?} {:?}",
        home.world().pose(apple),
        home.world().aabb(basket)
    );
    is_as_read(&home);
    let mut restored = home.restore(&home.save().unwrap()).unwrap();
    assert_eq!(restored.digest(), home.digest());
    for home in [&mut home, &mut restored] {
        act(home, me, Verb::Walk, &[apple]);
        act(home, me, Verb::Grab, &[apple]);
        assert!(home.graph().held(me).eq([apple]));
        assert_eq!(home.history().events().len(), 2);
    }
    assert_eq!(restored.digest(), home.digest());
    let start = home.start().clone();
    assert_eq!(home.reset(&start).unwrap().removed, []);
    assert!(home.graph().node(apple).is_none());
}

#[test]
fn what_cannot_appear_is_said_and_changes_nothing() {
    let mut home = home(42, 1);
    let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
    let sofa = home.graph().of_class("sofa")[0];
    let before = home.digest();
    let place = |relation, at| Place { relation, at };
    let spawned = [
        home.spawn("flooble", place(Relation::On, table)).unwrap_err(),
        home.spawn("apple", place(Relation::WornBy, me)).unwrap_err(),
        home.spawn("apple", place(Relation::On, NodeId(9_999_999))).unwrap_err(),
        home.spawn("double_bed", place(Relation::Inside, table)).unwrap_err(),
    ];
    assert!(matches!(&spawned[0], AlterError::NoSuchClass(name) if name == "flooble"), "{:?}", spawned[0]);
    assert_eq!(spawned[1], AlterError::NotAPlace(Relation::WornBy));
    assert_eq!(spawned[2], AlterError::NoSuchNode(NodeId(9_999_999)));
    assert!(matches!(spawned[3], AlterError::Unplaced(_)), "{:?}", spawned[3]);
    let wall = home.graph().of_class("wall")[0];
    assert!(matches!(home.put(wall, place(Relation::On, table)), Err(AlterError::NotLoose(_))));
    assert!(matches!(home.teleport(sofa, table), Err(AlterError::NotAnAgent(_))));
    let middle = home.graph().node(table).unwrap().position().unwrap();
    let refused = home.teleport(me, middle.xy()).unwrap_err();
    assert!(refused.to_string().contains("the free floor nearest to it is at"), "{refused}");
    assert_eq!(home.digest(), before);
}

/// An agent that is put elsewhere stands there, still holds its things, and can go on.
#[test]
fn agents_are_elsewhere_at_once() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let seen = home.room_observation(me);
    let novel = seen.nodes().find(|n| &**n.class() == "novel").unwrap().id();
    act(&mut home, me, Verb::Walk, &[novel]);
    act(&mut home, me, Verb::Grab, &[novel]);
    let sofa = home.graph().of_class("sofa")[0];
    act(&mut home, me, Verb::Walk, &[sofa]);
    act(&mut home, me, Verb::Sit, &[sofa]);
    for room in home.graph().rooms().to_vec() {
        match home.teleport(me, room) {
            Ok(()) => {}
            Err(AlterError::FullRoom(_)) => continue,
            Err(other) => panic!("{other}"),
        }
        assert_eq!(home.posture(me), Some(Posture::Standing));
        assert!(home.graph().related(me, Relation::SittingOn).next().is_none());
        assert_eq!((home.graph().room_of(me), home.graph().room_of(novel)), (Some(room), Some(room)));
        assert!(home.graph().held(me).eq([novel]));
        is_as_read(&home);
    }
    // Nobody stands where somebody else does.
    let taken = home.world().pose(other).unwrap().translation.vector.xy();
    assert!(home.teleport(me, Spot::At(taken.into())).is_err());
    let table = home.graph().of_class("coffee_table")[0];
    act(&mut home, me, Verb::Walk, &[table]);
    act(&mut home, me, Verb::Place, &[novel, table]);
}

/// Times of actions, by five hundred, and figures that could make actions slower; `HOMES`, `ACTIONS` and
/// `FROM` choose how many.
#[test]
#[ignore = "takes a minute: proofs/drift"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn actions_cost_what_the_first_did() {
    const PART: u64 = 500;
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    let (from, homes, actions) = (number("FROM", 42), number("HOMES", 1), number("ACTIONS", 5_000));
    for seed in from..from + homes {
        let (mut home, mut stream) = (home(seed, 2), Seed(seed).stream());
        for part in 0..actions / PART {
            let (mut times, mut done, ticks) = (Vec::new(), 0, home.world().ticks());
            for _ in 0..PART {
                let agent = *stream.pick(home.agents()).unwrap();
                let action = virtualcity::legal_action(home.graph(), agent, &mut stream);
                let start = cpu_time::ThreadTime::now();
                done += u64::from(home.set_action(agent, action).is_ok());
                times.push(start.elapsed());
            }
            times.sort_unstable();
            let mean = times.iter().sum::<std::time::Duration>().as_secs_f64() * 1e3 / PART as f64;
            let median = times[times.len() / 2].as_secs_f64() * 1e3;
            let (steps, contacts) = (home.world().ticks() - ticks, home.world().contacts().len());
            let bytes = home.world().save().unwrap().len() / 1000;
            println!(
                "home {seed}, actions {} : {done} done, mean {mean:.2} ms, median {median:.2} ms, {steps} steps, \
                 {contacts} contacts, {bytes} kB",
                part * PART
            );
        }
    }
}
