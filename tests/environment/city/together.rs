//! Several agents, and cities that are made otherwise.

use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, SceneBuilder};
use virtualcity::{City, CityError, CitySaveError, Environment, SaveError};

use super::{YARD, city, house, landing, of_class};

/// Two who come into one region at once stand apart there.
#[test]
fn two_who_are_sent_to_one_place_end_apart() {
    let mut city = city(2);
    let agents: Vec<NodeId> = city.agents().collect();
    city.go(agents[0], YARD).ok();
    city.go(agents[1], YARD).ok();
    for agent in &agents {
        city.send(*agent, landing(0)).unwrap();
    }
    assert!(agents.iter().all(|agent| city.is_busy(*agent)) && city.current_action(agents[0]).is_none());
    let endings = city.step_until_idle(Span::from_seconds(300.0));
    assert!(endings.iter().all(|ending| ending.outcome.is_ok()) && !agents.iter().any(|agent| city.is_busy(*agent)));
    assert!(agents.iter().all(|agent| city.region_of(*agent) == Some(landing(0))));
    let there = city.environment(landing(0)).unwrap();
    let feet = |agent: NodeId| there.world().pose(agent).unwrap().translation.vector;
    assert!((feet(agents[0]) - feet(agents[1])).norm() > 0.5);
}

#[test]
fn a_city_passes_time_until_nobody_has_anything_to_do() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    assert!(city.step_until_idle(Span::from_seconds(10.0)).is_empty() && city.tick().0 == 0);
    let table = of_class(&city, YARD, "table");
    city.give(me, Action::walk(table)).unwrap();
    let ended = city.step_until_idle(Span::from_seconds(100.0));
    assert!(ended.len() == 1 && city.tick().0 - ended[0].tick.0 <= 1, "it goes on no longer than it has to");
    city.send(me, landing(1)).unwrap();
    assert!(city.step_until_idle(Span(60)).is_empty() && city.is_busy(me), "a second is not enough");
    assert_eq!(city.step_until_idle(Span::from_seconds(300.0)).len(), 1);
    assert_eq!(city.region_of(me), Some(landing(1)));
}

#[test]
fn a_city_that_is_made_otherwise_restores_nothing() {
    let saved = city(1).save().unwrap();
    let others = city(2).restore(&saved).err().unwrap();
    assert!(matches!(others, CitySaveError::OtherAgents { saved: 1, here: 2 }));
    let settings = Environment::builder_from_scene(SceneBuilder::new("").build()).gravity(3.71);
    let moon = City::of(house()).settings(settings).make().unwrap();
    let CitySaveError::Region { why, .. } = moon.restore(&saved).err().unwrap() else { panic!("not the setting") };
    assert!(matches!(&*why, SaveError::OtherSetting { setting, .. } if setting.contains("gravity")), "{why}");
}

#[test]
fn seeds_are_digits() {
    for name in ["building/+7", "apartment/+42", "building/", "building/-7", "building/7 "] {
        assert!(matches!(City::make(name, 1), Err(CityError::Name(_))), "{name}");
    }
}
