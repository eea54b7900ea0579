//! Homes made from files and graphs, altered through graphs, and exported.

use flate2::Compression;
use flate2::write::GzEncoder;
use virtualcity::graph::format::native;
use virtualcity::graph::{Draft, NodeId, Place, Pose, Relation, Seed, State, Verb, Violation};
use virtualcity::physics::Role;
use virtualcity::procgen::Apartment;
use virtualcity::{Environment, MakeError, Why, check_environment};

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

#[test]
fn names_that_are_none_are_refused() {
    assert!(matches!(Environment::make("house/1", 1), Err(MakeError::UnknownName(_))));
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

/// A reset reports the objects that it moved, added and removed, those that found no place and why, those that
/// came to rest elsewhere, and the agents that could not sit where the graph says.
#[test]
fn resets_report() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let start = home.start().clone();
    let (table, sofa) = (start.of_class("coffee_table")[0], start.of_class("sofa")[0]);
    let lamp = start.of_class("ceiling_lamp")[0];
    let loose = |id: &NodeId| home.world().role(*id) == Some(Role::Loose);
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
    assert!(matches!(why(bed), Some(Why::NoSpot { at, .. }) if at.id == table), "{:?}", why(bed));
    assert_eq!(why(idea), Some(Why::NoShape));
    assert!(matches!(why(apple), Some(Why::NoSupport(at)) if at.id == idea), "{:?}", why(apple));
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
