//! Cities as a user keeps them: whether they are sound, records that are played again, and scenes for other programs.

use virtualcity::graph::clock::Span;
use virtualcity::graph::format::thesis;
use virtualcity::graph::space::RegionId;
use virtualcity::graph::{Action, NodeId, Verb};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::{City, CityRecord, CityViolation, ReplayError};

use super::{YARD, city, landing, move_cup, of_class};

/// Somebody opens the fridge, goes to the neighbours and back, and is told otherwise on the way.
fn lived(city: &mut City) {
    let me = city.agents().next().unwrap();
    let home = city.region_of(me).unwrap();
    let fridge = of_class(city, home, "fridge");
    city.set_action(me, Action::walk(fridge)).unwrap();
    city.set_action(me, Action::one(Verb::Open, fridge)).unwrap();
    assert!(city.set_action(me, Action::one(Verb::Open, fridge)).is_err());
    let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").unwrap().0;
    city.send(me, yard).unwrap();
    city.step(Span::from_seconds(7.0));
    city.interrupt(me);
    city.step(Span::from_seconds(2.0));
    let chair = city.peek(home).unwrap().graph().of_class("dining_chair")[0];
    let middle = city.peek(home).unwrap().world().body(chair).unwrap().centre_of_mass();
    city.push(chair, Vector3::new(4.0, 3.0, 0.0), middle).unwrap();
    city.step(Span(123));
}

/// A record that was written and read leads to the same city, bit for bit.
#[test]
fn a_record_is_played_again() {
    let start = City::make("building/7", 2).unwrap();
    let mut city = start.clone();
    city.begin_record();
    lived(&mut city);
    let text = serde_json::to_string(&city.record().unwrap()).unwrap();
    assert!(text.len() < 4000, "{}", text.len());
    let record: CityRecord = serde_json::from_str(&text).unwrap();
    let again = City::make("building/7", 2).unwrap().replay(&record).unwrap();
    assert_eq!((again.digest(), again.tick()), (city.digest(), city.tick()));
    assert!(start.record().is_none() && again.record().is_none());
    assert!(matches!(city.replay(&record), Err(ReplayError::OtherBeginning { .. })));
    let other = City::make("building/8", 2).unwrap();
    assert!(matches!(other.replay(&record), Err(ReplayError::OtherPlan)));
    let forged: CityRecord =
        serde_json::from_str(&text.replace("\"Stop\"", "\"stop\"").replace("\"stop\"", "{\"go\":3}")).unwrap();
    assert!(matches!(start.replay(&forged), Err(ReplayError::OtherEnd { .. })));
}

/// A city that is lived in is sound, where agents have been and where they are; things of one region in another count.
#[test]
fn a_city_is_validated() {
    let mut house = city(2);
    let me = house.agents().next().unwrap();
    let cup = move_cup(&mut house, me);
    house.go(me, landing(2)).unwrap();
    assert_eq!(house.validate().unwrap(), []);
    assert_eq!(house.region_of(cup), Some(landing(0)));
    let table = of_class(&house, landing(2), "table");
    let above = house.environment(landing(2)).unwrap().world().body(table).unwrap().centre_of_mass();
    house.push(table, Vector3::new(0.0, 0.0, 4000.0), above).unwrap();
    house.step(Span(60));
    let found = house.validate().unwrap();
    let flies = |violation: &CityViolation| matches!(violation, CityViolation::Outside { region, thing } if region.id == landing(2) && thing.id == table);
    assert!(found.iter().any(flies), "{found:?}");
    assert!(found.iter().all(|violation| violation.to_string().starts_with("house/landing")));
    let mut building = City::make("building/7", 2).unwrap();
    lived(&mut building);
    assert_eq!(building.validate().unwrap(), []);
}

/// A city as one scene: written in the thesis's JSON and read back, joined or region by region, all is where it is.
#[test]
fn a_city_is_written_as_one_scene() {
    let mut building = City::make("building/7", 1).unwrap();
    lived(&mut building);
    let with_scene = |(id, region): (RegionId, &virtualcity::graph::space::Region)| region.has_scene().then_some(id);
    let regions: Vec<RegionId> = building.space().regions().filter_map(with_scene).collect();
    let whole = building.scene(regions.iter().copied()).unwrap();
    let back = thesis::read(&thesis::write(&whole), whole.classes()).unwrap();
    let mut count = 0;
    for region in &regions {
        let there = building.peek(*region).unwrap();
        let alone = thesis::read(&thesis::write(there.graph()), there.graph().classes()).unwrap();
        assert_eq!(alone.len(), there.graph().len(), "{region}");
        count += there.graph().len();
        let shift = building.frame(*region).unwrap().to(&building.frame(regions[0]).unwrap());
        for node in there.graph().nodes().filter(|node| node.position().is_some()) {
            let at: Point3<f32> = shift * node.position().unwrap();
            for scene in [&whole, &back] {
                let same = scene.node(node.id()).and_then(|node| node.aabb()).unwrap().centre();
                let own = node.aabb().unwrap().centre();
                assert!((shift * own - same).norm() < 0.01, "{} at {at}", node.label());
            }
        }
    }
    assert_eq!((whole.len(), back.len()), (count, count));
    assert_eq!(whole.validate(), []);
    let me: NodeId = building.agents().next().unwrap();
    assert!(whole.room_of(me).is_some());
    let _ = YARD;
}
