//! How much a saved city and a region that sleeps take, and that both are what they were.

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::RegionId;
use virtualcity::graph::{Action, Change, ChangeSet, NodeId, Verb};
use virtualcity::nalgebra::Vector3;
use virtualcity::{City, CitySaveError};

use super::{Changed, YARD, city, house, landing, move_cup, of_class};

/// Four who have walked about in a building, one of whom has opened a fridge.
fn lived_in() -> City {
    let mut city = City::make("building/7", 4).unwrap();
    let agents: Vec<NodeId> = city.agents().collect();
    let home = city.region_of(agents[0]).unwrap();
    let fridge = of_class(&city, home, "fridge");
    city.set_action(agents[0], Action::walk(fridge)).unwrap();
    city.set_action(agents[0], Action::one(Verb::Open, fridge)).unwrap();
    let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").unwrap().0;
    city.go(agents[1], yard).unwrap();
    city
}

/// A save has what differs from how regions are made, not all of them.
#[test]
fn a_saved_city_takes_what_differs() {
    let city = lived_in();
    let saved = city.save().unwrap();
    let whole: usize = city.active().map(|region| city.environment(region).unwrap().save().unwrap().len()).sum();
    assert!(saved.len() < whole / 50, "{} bytes instead of {whole}", saved.len());
    let restored = City::make("building/7", 4).unwrap().restore(&saved).unwrap();
    assert_eq!(restored.digest(), city.digest());
    assert_eq!(restored.save().unwrap(), saved);
}

/// A region that sleeps keeps little, and wakes as it would have gone on in a city that was saved and restored meanwhile.
#[test]
fn a_sleeping_region_keeps_what_differs() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let cup = move_cup(&mut city, me);
    let awake = city.save().unwrap().len();
    city.go(me, YARD).unwrap();
    city.step(Span::from_seconds(10.0));
    assert!(city.environment(landing(0)).is_none());
    let asleep = city.save().unwrap();
    assert!(asleep.len() < 2 * awake, "{awake} bytes awake, {} asleep", asleep.len());
    let mut restored = super::city(1).restore(&asleep).unwrap();
    for city in [&mut city, &mut restored] {
        city.go(me, landing(0)).unwrap();
        assert_eq!(city.region_of(cup), Some(landing(0)));
        city.set_action(me, Action::walk(cup)).unwrap();
        city.set_action(me, Action::grab(cup)).unwrap();
    }
    assert_eq!(city.digest(), restored.digest());
}

/// A home that sleeps takes no more than its changes as they are written and 300 bytes, whatever it was made of.
#[test]
fn a_home_that_sleeps_takes_its_changes() {
    let mut city = lived_in();
    let agents: Vec<NodeId> = city.agents().collect();
    let home = city.home(agents[0]).unwrap();
    let yard: RegionId = city.region_of(agents[1]).unwrap();
    city.go(agents[0], yard).unwrap();
    city.step(Span::from_seconds(30.0));
    assert!(city.environment(home).is_none() && city.region_digest(home).is_some());
    let asleep = city.bytes_asleep(home).unwrap();
    let mut untouched = City::make("building/7", 4).unwrap();
    for agent in &agents[..2] {
        untouched.go(*agent, yard).unwrap();
    }
    untouched.step(Span::from_seconds(30.0));
    let changes = ChangeSet::between(untouched.peek(home).unwrap().graph(), city.peek(home).unwrap().graph());
    // Relations are read from poses again.
    let is_kept = |change: &&Change| !matches!(change, Change::Link(_) | Change::Unlink(_));
    let kept: Vec<&Change> = changes.changes().iter().filter(is_kept).collect();
    let written = serde_json::to_string(&kept).unwrap().len();
    assert!(written < 8_000 && asleep < written + 300, "{asleep} bytes for changes of {written}");
    let saved = city.save().unwrap().len();
    assert!(saved < 200_000, "{saved} bytes");
    let fridge = city.peek(home).unwrap().graph().of_class("fridge")[0];
    assert!(city.peek(home).unwrap().graph().node(fridge).unwrap().is(virtualcity::graph::State::Open));
}

/// Somebody under way goes on as in a city that was restored meanwhile, though things were pushed over the floor.
#[test]
fn restores_between_pushes_change_no_way() {
    let start = City::make("building/7", 2).unwrap();
    let agents: Vec<NodeId> = start.agents().collect();
    let homes: Vec<RegionId> = agents.iter().map(|agent| start.region_of(*agent).unwrap()).collect();
    let yard = start.space().regions().find(|(_, region)| &*region.name == "yard").unwrap().0;
    let chairs: Vec<NodeId> = homes
        .iter()
        .flat_map(|home| start.environment(*home).unwrap().graph().of_class("dining_chair").to_vec())
        .collect();
    let (mut plain, mut restored) = (start.clone(), start.clone());
    for round in 0..10 {
        let chair = chairs[round % chairs.len()];
        for city in [&mut plain, &mut restored] {
            city.go(agents[round % 2], if round % 4 < 2 { yard } else { homes[round % 2] }).ok();
            let there = city.region_of(chair).unwrap();
            let at = city.peek(there).unwrap().world().body(chair).unwrap().centre_of_mass();
            let way = [Vector3::x(), Vector3::y(), -Vector3::x(), -Vector3::y()][round % 4];
            city.push(chair, way * 9.0, at).unwrap();
            city.step(Span(31));
        }
        restored = start.restore(&restored.save().unwrap()).unwrap();
        for city in [&mut plain, &mut restored] {
            city.step(Span(47));
        }
        assert_eq!(plain.digest(), restored.digest(), "round {round}");
    }
}

/// A city that was saved whole goes on although the generator of its regions has changed: as the saved one does, after it is
/// saved again, too. One that was saved by its changes is refused.
#[test]
fn a_city_that_was_saved_whole_needs_no_generator() {
    let mut old = city(1);
    let me = old.agents().next().unwrap();
    let cup = move_cup(&mut old, me);
    old.send(me, landing(1)).unwrap();
    old.step(Span::from_seconds(3.0));
    let renewed = City::of(Changed(house())).make().unwrap();
    let refused = renewed.restore(&old.save().unwrap()).unwrap_err();
    assert!(matches!(&refused, CitySaveError::OtherRegion(region) if region.id == YARD), "{refused}");
    let whole = old.save_whole().unwrap();
    let mut restored = renewed.restore(&whole).unwrap();
    assert_eq!((restored.digest(), restored.save_whole().unwrap()), (old.digest(), whole));
    let again = renewed.restore(&restored.save_whole().unwrap()).unwrap();
    for city in [&mut old, &mut restored] {
        city.step_until_idle(Span::from_seconds(300.0));
        city.go(me, YARD).unwrap();
        city.set_action(me, Action::walk(cup)).unwrap();
    }
    assert_eq!((old.digest(), old.region_of(me)), (restored.digest(), Some(landing(0))));
    assert_eq!(again.region_of(cup), Some(landing(0)));
    // Where nobody has been near, the generator's scenes are those of today; damage is found.
    let mut damaged = restored.save_whole().unwrap();
    let last = damaged.len() - 1;
    damaged[last] ^= 1;
    assert!(renewed.restore(&damaged).is_err());
}
