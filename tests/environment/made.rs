//! Homes made from files and graphs, altered through graphs, and exported.

use std::error::Error;

use flate2::Compression;
use flate2::write::GzEncoder;
use virtualcity::graph::clock::Span;
use virtualcity::graph::format::native;
use virtualcity::graph::{
    Action, ClassTable, Draft, Node, NodeId, Place, Pose, Property, Relation, Seed, State, Verb, Violation,
};
use virtualcity::physics::{BodyRole, PhysicsError};
use virtualcity::procgen::Apartment;
use virtualcity::relations::RelationRule;
use virtualcity::render::Daylight;
use virtualcity::{ActionError, Environment, MakeError, UnplacedReason, check_environment};

use super::{act, home};

/// A home that is written to a file and read again.
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

/// Errors hold the action that they are about, and the error that they come from.
#[test]
fn errors_hold_their_source() {
    let mut home = home(42, 1);
    let (me, table) = (home.agents()[0], home.graph().first_of_class("coffee_table").unwrap());
    let middle = home.world().aabb(table).unwrap().centre();
    let into = Action::zero(Verb::Walk).at(f64::from(middle.x), f64::from(middle.y)).unwrap();
    let impossible = home.set_action(me, into).unwrap_err();
    let ActionError::Impossible { attempt, why } = &impossible else { panic!("{impossible}") };
    assert_eq!(attempt.action(), Some(into));
    assert_eq!(impossible.source().and_then(|source| source.downcast_ref()), Some(why));
    assert_eq!(impossible.to_string(), format!("{}: {why}", into.describe(home.graph())));

    let away = Action::walk(home.graph().first_of_class("fridge").unwrap());
    home.give(me, away);
    home.step(Span(5));
    home.interrupt(me);
    let interrupted = home.step(Span(1)).remove(0).outcome.unwrap_err();
    let ActionError::Interrupted { attempt, why } = &interrupted else { panic!("{interrupted}") };
    assert_eq!(attempt.action(), Some(away));
    assert_eq!(interrupted.source().map(ToString::to_string), Some(why.to_string()));

    let no_list = home.add_cameras("[1]").unwrap_err();
    let source = no_list.source().map(ToString::to_string).unwrap();
    assert_eq!(no_list.to_string(), format!("this is no list of cameras: {source}"));
    let none = Environment::builder("apartment/5").threads(0).make().unwrap_err();
    assert!(matches!(none, MakeError::Threads { threads: 0, most: 1024 }), "{none}");
}

/// A cup that hangs a centimetre and a half above a table rests on it by the tolerance of a builder that bridges this.
#[test]
fn tolerance_says_what_is_on_what() {
    let mut home = home(42, 1);
    let table = home.graph().first_of_class("coffee_table").unwrap();
    let cup = home.spawn("cup", Place { relation: Relation::On, at: table }).unwrap();
    let mut graph = home.graph().clone();
    let raised = Pose::translation(0.0, 0.0, 0.015) * graph.node(cup).and_then(Node::pose).unwrap();
    let room = graph.room_of(cup);
    let mut edit = graph.edit();
    edit.place_as_seen(cup, &[], room).unwrap();
    edit.set_pose(cup, Some(raised)).unwrap();
    edit.commit();
    for (tolerance, expected) in [(0.02, true), (0.01, false), (0.016, true), (0.014, false)] {
        let mut home = Environment::builder_from_scene(graph.clone()).tolerance(tolerance).make().unwrap();
        let is_on = |home: &Environment| home.relations().supports(cup).iter().any(|support| support.by == table);
        assert_eq!(home.world().pose(cup), Some(raised), "it hangs there");
        assert_eq!(is_on(&home), expected, "{tolerance}");
        home.reset(&graph).unwrap();
        assert_eq!(is_on(&home), expected, "{tolerance} after a reset");
    }
}

/// The builder's settings reach the parts that they are for, a reset keeps them, and senseless ones are refused.
#[test]
fn environments_have_the_settings_of_their_builder() {
    let builder = || Environment::builder("apartment/5").agents(2);
    let (plain, made) = (builder().make().unwrap(), home(5, 2));
    assert_eq!(plain.digest(), made.digest());
    let mut moon = builder().gravity(1.62).relations(RelationRule::VirtualHome).hour(23.0).make().unwrap();
    moon.reset(&moon.start().clone()).unwrap();
    assert_eq!((moon.agents().len(), moon.world().settings().gravity), (2, 1.62));
    assert_eq!(moon.relations().rule(), RelationRule::VirtualHome);
    assert_eq!(moon.pictures().daylight, Daylight::night());
    assert!(matches!(builder().gravity(f32::NAN).make(), Err(MakeError::Physics(PhysicsError::BadSettings(_)))));
    assert!(matches!(builder().agents(0).make(), Err(MakeError::NoAgents)));
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("own_classes.json");
    let scene = include_str!("../data/boxes_table.json").replace("apple", "moon_apple");
    std::fs::write(&file, scene).unwrap();
    let table = "moon_apple | fruit | | food | graspable surface | 0.08 0.08 0.08 | 0.2 | | | kitchen/on/table:1";
    let classes = ClassTable::builtin().extended("mine.txt", table).unwrap();
    let own = Environment::builder(format!("scene:{}", file.display())).classes(classes).make().unwrap();
    assert!(own.graph().node(own.graph().of_class("moon_apple")[0]).unwrap().affords(Property::Surface));
}

#[test]
fn names_that_are_none_are_refused() {
    for name in ["house/1", "scene:", ""] {
        assert!(matches!(Environment::make(name, 1), Err(MakeError::UnknownName(_))), "{name}");
    }
    assert!(matches!(Environment::make("apartment/one", 1), Err(MakeError::BadSeed(_))));
    assert!(matches!(Environment::make("scene:no/such/file", 1), Err(MakeError::File { .. })));
    assert!(matches!(Environment::make("apartment/8", 100_000), Err(MakeError::NoRoom { .. })));
    assert!(matches!(Environment::make("apartment/8", 0), Err(MakeError::NoAgents)));
}

/// Objects that are added and moved in the graph get positions in the home; those without a free place are left
/// out and reported.
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
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert_eq!(report.added, [apple, lost]);
    assert_eq!(report.unplaced.len(), 1);
    assert_eq!((report.unplaced[0].thing.id, &report.unplaced[0].why), (lost, &UnplacedReason::Nowhere));
    assert!(home.graph().node(lost).is_none());
    assert!(home.graph().places(apple).any(|p| p.at == table), "{:?}", home.graph().place(apple));
    assert!(home.world().supports(apple).contains(&table));
}

/// A reset reports the objects that it moved, added and removed, those that found no place and why, those that
/// came to rest elsewhere, and the agents that could not sit where the graph says.
#[test]
fn resets_report() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let start = home.start().clone();
    let (table, sofa) = (start.of_class("coffee_table")[0], start.of_class("sofa")[0]);
    let lamp = start.of_class("ceiling_lamp")[0];
    let loose = |id: &NodeId| home.world().role(*id) == Some(BodyRole::Loose);
    let on_table: Vec<NodeId> = start.relating(Relation::On, table).filter(loose).collect();
    let [gone, moved] = on_table[..2] else { panic!("{on_table:?} on the table") };
    let mut graph = start.clone();
    let mut edit = graph.edit();
    edit.remove(gone).unwrap();
    // Above another spot, so that it falls down there.
    let up = start.node(moved).unwrap().pose().unwrap();
    edit.set_pose(moved, Some(Pose::translation(0.0, 0.0, 0.4) * up)).unwrap();
    // A coffee table has no space for a bed, and nothing can be on a node without a body.
    let bed = edit.add(Draft::new("bed")).unwrap();
    edit.place(bed, Place { relation: Relation::On, at: table }).unwrap();
    let idea = edit.add(Draft::new("thought")).unwrap();
    let apple = edit.add(Draft::new("apple")).unwrap();
    edit.place(apple, Place { relation: Relation::On, at: idea }).unwrap();
    // An agent far away cannot sit there.
    edit.place(other, Place { relation: Relation::SittingOn, at: sofa }).unwrap();
    edit.enter_state(other, State::Sitting).unwrap();
    edit.place(me, Place { relation: Relation::SittingOn, at: lamp }).unwrap();
    edit.enter_state(me, State::Sitting).unwrap();
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert_eq!((report.removed, report.added), (vec![gone], vec![bed, idea, apple]));
    assert!(report.moved.contains(&moved) && report.moved.len() <= 2, "{:?}", report.moved);
    let why = |id: NodeId| report.unplaced.iter().find(|u| u.thing.id == id).map(|u| u.why.clone());
    assert!(matches!(why(bed), Some(UnplacedReason::NoSpot { at, .. }) if at.id == table), "{:?}", why(bed));
    assert_eq!(why(idea), Some(UnplacedReason::NoShape));
    assert!(matches!(why(apple), Some(UnplacedReason::NoSupport(at)) if at.id == idea), "{:?}", why(apple));
    // A lamp is not a seat: the agent stands, the graph says so, and the report has the requested place.
    let stands = report.elsewhere.iter().find(|e| e.thing.id == me).unwrap();
    assert_eq!(stands.wanted, Place { relation: Relation::SittingOn, at: lamp });
    let sits = |id: NodeId| home.graph().node(id).unwrap().is(State::Sitting);
    let seated = |id: NodeId| home.posture(id) != Some(virtualcity::physics::Posture::Standing);
    assert!(!sits(me) && !seated(me));
    assert_eq!(sits(other), seated(other), "graph and body say the same of who sits on the sofa");
    // A falling object comes to rest on whatever is below.
    let known = home.start().validate();
    let news = home.graph().validate().into_iter().filter(|v| !known.contains(v));
    let broken: Vec<Violation> = news.filter(|v| !matches!(v, Violation::NotASurface(..))).collect();
    assert_eq!(broken, []);
    // Nothing of it remains after the next reset.
    let again = home.reset(&start).unwrap();
    assert_eq!(again, virtualcity::ResetReport::default());
    assert_eq!(home.graph(), &start);
}

/// The rotations of the nodes below a named node in a glTF file: their scalar parts.
fn turns(file: &[u8], name: &str) -> Vec<f64> {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let document: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let nodes = document["nodes"].as_array().unwrap();
    let node = nodes.iter().find(|n| n["name"] == name).unwrap();
    let children = node["children"].as_array().unwrap().iter().map(|child| &nodes[child.as_u64().unwrap() as usize]);
    children.map(|n| n["rotation"][3].as_f64().unwrap_or(1.0).abs()).collect()
}

/// A home's glTF has doors at their present openings, and seated people.
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

/// An edited graph moves things and agents without poses of its own: onto and into things, and into rooms, together
/// with what lies on or in them; `moved` has those that have moved.
#[test]
fn an_edited_graph_moves_what_it_places() {
    let mut home = home(42, 1);
    let (start, me) = (home.start().clone(), home.agents()[0]);
    let one = |class: &str| start.of_class(class)[0];
    let (table, fridge, sofa, kitchen) = (one("coffee_table"), one("fridge"), one("sofa"), one("kitchen"));
    let novels = start.of_class("novel");
    let on_sofa: Vec<NodeId> = start.relating(Relation::On, sofa).collect();
    let mut graph = start.clone();
    let mut edit = graph.edit();
    let on_table = Place { relation: Relation::On, at: table };
    let in_fridge = Place { relation: Relation::Inside, at: fridge };
    edit.place(novels[0], on_table).unwrap();
    edit.place(novels[10], in_fridge).unwrap();
    edit.move_to_room(sofa, kitchen).unwrap();
    edit.move_to_room(me, kitchen).unwrap();
    edit.commit();
    let report = home.reset(&graph).unwrap();
    assert!(report.unplaced.is_empty() && report.elsewhere.is_empty(), "{report:?}");
    let mut moved = [vec![novels[0], novels[10], sofa, me], on_sofa.clone()].concat();
    moved.sort_unstable();
    assert_eq!(report.moved, moved);
    assert!(home.graph().places(novels[0]).any(|p| p == on_table));
    assert!(home.graph().places(novels[10]).any(|p| p == in_fridge));
    assert!(home.world().supports(novels[0]).contains(&table));
    for id in [sofa, me].into_iter().chain(on_sofa.iter().copied()) {
        assert_eq!(home.graph().room_of(id), Some(kitchen), "{}", start.label(id));
    }
    assert!(on_sofa.iter().all(|id| home.graph().rests_at(*id, sofa)));
    let at = home.world().pose(me).unwrap().translation.vector.xy();
    assert!(home.floor().is_free(at.into()));
    assert_eq!(home.reset(&start).unwrap(), virtualcity::ResetReport::default());
    // The same from a graph of now, for things that are elsewhere than at the start.
    home.put(novels[0], on_table).unwrap();
    let mut graph = home.graph().clone();
    let mut edit = graph.edit();
    edit.place(novels[0], in_fridge).unwrap();
    edit.commit();
    assert!(home.reset(&graph).unwrap().moved.contains(&novels[0]));
    assert!(home.graph().places(novels[0]).any(|p| p == in_fridge));
    // The room alone is a place for things without a pose.
    let mut graph = start.clone();
    let mut edit = graph.edit();
    edit.move_to_room(novels[0], kitchen).unwrap();
    edit.set_pose(novels[0], None).unwrap();
    edit.commit();
    assert!(home.reset(&graph).unwrap().unplaced.is_empty());
    assert_eq!(home.graph().room_of(novels[0]), Some(kitchen));
}

/// A thing for which there is no room stays where it was, and the report says why; parts of the building stay.
#[test]
fn what_cannot_be_moved_is_told() {
    let mut home = home(42, 1);
    let start = home.start().clone();
    let one = |class: &str| start.of_class(class)[0];
    let (sofa, table, door) = (one("sofa"), one("coffee_table"), one("door"));
    let mut graph = start.clone();
    let mut edit = graph.edit();
    edit.place(sofa, Place { relation: Relation::On, at: table }).unwrap();
    edit.place(door, Place { relation: Relation::On, at: sofa }).unwrap();
    edit.commit();
    let report = home.reset(&graph).unwrap();
    let told = |id: NodeId| report.elsewhere.iter().find(|e| e.thing.id == id).unwrap_or_else(|| panic!("{report:?}"));
    assert!(matches!(told(sofa).why, Some(UnplacedReason::NoSpot { .. })), "{:?}", told(sofa));
    assert!(matches!(told(door).why, Some(UnplacedReason::NotMovable(_))), "{:?}", told(door));
    let begins = format!("{} is not on {}: no spot", start.label(sofa), start.label(table));
    assert!(told(sofa).to_string().starts_with(&begins), "{}", told(sofa));
    assert!(report.unplaced.is_empty() && report.moved.is_empty(), "{report:?}");
    let pose = |graph: &virtualcity::graph::SceneGraph| graph.node(sofa).unwrap().pose().copied();
    assert_eq!(pose(home.graph()), pose(&start));
    assert_eq!(home.graph().room_of(sofa), start.room_of(sofa));
}

/// Errors name a thing that is no agent or room as such, and actions without an environment.
#[test]
fn errors_name_what_is_not_there() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let fridge = home.graph().of_class("fridge")[0];
    let told = home.teleport(me, fridge).unwrap_err().to_string();
    assert!(told.contains("is no room"), "{told}");
    #[cfg(feature = "render")]
    for (view, why) in [
        (virtualcity::Viewpoint::Agent(fridge), "is no agent"),
        (virtualcity::Viewpoint::Room(fridge), "is not a room"),
        (virtualcity::Viewpoint::Above(fridge), "is not a room"),
    ] {
        let told = home.render(view, virtualcity::render::Modality::Rgb, 8, 8).err().unwrap().to_string();
        assert!(told.starts_with(&format!("{} {why}", home.graph().label(fridge))), "{told}");
    }
    let dance: virtualcity::graph::Action = "dance".parse().unwrap();
    let mut batch = virtualcity::Batch::new(vec![home]);
    let outcomes = batch.set_actions(&vec![vec![(me, dance)]; 3]);
    assert_eq!(outcomes.len(), 3);
    assert!(outcomes[0][0].is_ok());
    let told = outcomes[2][0].as_ref().unwrap_err().to_string();
    assert!(told.contains("no environment 2") && told.contains("the batch has 1"), "{told}");
}

/// Agents greet, touch and play with each other, and not with themselves.
#[test]
fn people_are_no_playthings_of_their_own() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    home.set_action(me, virtualcity::graph::Action::one(Verb::Walk, other)).unwrap();
    for verb in [Verb::Touch, Verb::Push, Verb::Play] {
        let action = virtualcity::graph::Action::one(verb, other);
        home.set_action(me, action).unwrap_or_else(|e| panic!("{}: {e}", action.describe(home.graph())));
    }
    let legal = home.legal_actions(me);
    assert!(legal.iter().all(|a| ![Verb::Play, Verb::Push, Verb::Walk].contains(&a.verb) || a.object != Some(me)));
    assert!(legal.contains(&virtualcity::graph::Action::one(Verb::Wash, me)));
}
