//! Cities: agents who go from region to region, over stairs and by lift, with what they carry.

mod doors;
mod falls;
mod houses;
mod obstructed;
mod passing;
mod saves;
mod sight;
mod spots;
mod things;
mod together;
mod whole;
mod worlds;

use std::error::Error;
use std::f32::consts::PI;
use std::sync::Arc;

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{
    Portal, PortalId, PortalKind, PortalSide, Region, RegionFrame, RegionId, RegionKind, Space, SpaceBuilder,
};
use virtualcity::graph::{
    Action, Bounds, Draft, Edge, NodeId, NodeKind, Pose, Relation, SceneBuilder, SceneGraph, Seed, State, Verb,
};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::procgen::Building;
use virtualcity::{City, CityError, CitySaveError, Environment, GoalScope, LiftState, RegionScenes};

const STOREYS: u32 = 3;
const HEIGHT: f64 = 3.0;
const YARD: RegionId = RegionId(1);
const CABIN: RegionId = RegionId(2 + STOREYS);

fn landing(storey: u32) -> RegionId {
    RegionId(2 + storey)
}

/// A yard, a landing on each storey with stairs to the next, and a lift.
#[derive(Clone)]
struct House(Arc<Space>);

fn side(region: RegionId, at: [f32; 3], heading: f32) -> PortalSide {
    let pose = Pose::translation(at[0], at[1], at[2]) * Pose::rotation(Vector3::new(0.0, 0.0, heading));
    PortalSide { region, pose, room: None }
}

fn house() -> House {
    house_of(STOREYS)
}

/// The house with so many storeys; its cabin comes after the landings.
fn house_of(storeys: u32) -> House {
    let cabin = RegionId(2 + storeys);
    let mut plan = SpaceBuilder::new();
    let house = Region::new(RegionKind::Building, "house").at(RegionFrame::new([4000.0, -3000.0, 60.0], 0.65));
    let house = plan.add(house).unwrap();
    plan.add(Region::new(RegionKind::Yard, "yard").within(house).with_numbers(100)).unwrap();
    let at = |x: f64, y: f64, storey: u32| RegionFrame::new([x, y, HEIGHT * f64::from(storey)], 0.0);
    for storey in 0..storeys {
        let landing = Region::new(RegionKind::Corridor, "landing").within(house).at(at(5.0, 0.0, storey));
        plan.add(landing.with_numbers(100)).unwrap();
    }
    let stops: Vec<RegionFrame> = (0..storeys).map(|storey| at(10.0, 2.5, storey)).collect();
    plan.add(Region::new(RegionKind::Stairwell, "cabin").within(house).moving(stops).with_numbers(100)).unwrap();
    let sides = [side(YARD, [5.0, 2.5, 0.0], 0.0), side(landing(0), [0.0, 2.5, 0.0], PI)];
    plan.join(Portal::new(PortalKind::Passage, sides, 1.0, 2.1)).unwrap();
    for storey in 0..storeys {
        let sides = [side(landing(storey), [5.0, 2.5, 0.0], 0.0), side(cabin, [0.0, 0.0, 0.0], PI)];
        plan.join(Portal::new(PortalKind::Landing, sides, 0.9, 2.1).at_stop(storey)).unwrap();
    }
    for storey in 1..storeys {
        let top = [3.5, 4.2, HEIGHT as f32];
        let sides = [side(landing(storey - 1), top, 0.0), side(landing(storey), [3.5, 4.2, 0.0], PI)];
        let way = [Point3::new(0.6, 4.2, 0.0), Point3::new(3.4, 4.2, HEIGHT as f32)];
        plan.join(Portal::new(PortalKind::Landing, sides, 1.1, 2.1).over_stairs(way)).unwrap();
    }
    House(Arc::new(plan.build()))
}

impl RegionScenes for House {
    fn space(&self) -> &Arc<Space> {
        &self.0
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let plan = self.0.region(region).ok_or("no region")?;
        let is_cabin = !plan.stops.is_empty();
        let (middle, size) = if is_cabin { ([0.8, 0.0], 1.6) } else { ([2.5, 2.5], 5.0) };
        let mut scene = SceneBuilder::new(&*plan.name);
        scene.numbers(plan.numbers);
        let at = |z: f32| Pose::translation(middle[0], middle[1], z);
        let room = Bounds::standing([size, size, 2.5].into());
        let room = scene.add(Draft::new("hallway").bounds(room).at(at(0.0)))?;
        scene.add_in(room, Draft::new("floor").bounds(Bounds::standing([size, size, 0.1].into())).at(at(-0.1)))?;
        if !is_cabin {
            let table = Draft::new("table").bounds(Bounds::standing([0.6, 0.6, 0.7].into()));
            let table = scene.add_in(room, table.at(Pose::translation(1.5, 1.0, 0.0)))?;
            let cup = Draft::new("cup").bounds(Bounds::standing([0.08, 0.08, 0.1].into()));
            scene.add_on(table, cup.at(Pose::translation(1.5, 1.2, 0.7)))?;
        }
        Ok(scene.build())
    }
}

fn city(agents: usize) -> City {
    City::of(house()).agents(agents).make().unwrap()
}

fn of_class(city: &City, region: RegionId, class: &str) -> NodeId {
    city.environment(region).unwrap().graph().of_class(class)[0]
}

/// Takes the cup of the yard.
fn take_cup(city: &mut City, me: NodeId) -> NodeId {
    let cup = of_class(city, YARD, "cup");
    city.set_action(me, Action::walk(cup)).unwrap();
    city.set_action(me, Action::grab(cup)).unwrap();
    cup
}

/// Takes the cup of the yard to the table of the first landing.
fn move_cup(city: &mut City, me: NodeId) -> NodeId {
    let cup = take_cup(city, me);
    city.go(me, landing(0)).unwrap();
    let table = of_class(city, landing(0), "table");
    city.set_action(me, Action::walk(table)).unwrap();
    city.set_action(me, Action::place(cup, table)).unwrap();
    cup
}

fn holds(city: &City, me: NodeId, thing: NodeId) -> bool {
    let environment = city.environment_of(me).unwrap();
    let graph = environment.graph();
    let held = graph.held(me).any(|held| held == thing);
    assert_eq!(held, Relation::hands().iter().any(|hand| graph.has(Edge::new(me, *hand, thing))));
    held && environment.world().pose(thing).is_some()
}

#[test]
fn whoever_goes_takes_along_what_it_carries() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let start = city.region_of(me).unwrap();
    assert_eq!(start, YARD, "without flats one begins in the first region");
    let cup = take_cup(&mut city, me);
    let changes = city.go(me, landing(0)).unwrap();
    assert!(changes.nodes().any(|id| id == cup));
    assert_eq!((city.region_of(me), city.region_of(cup)), (Some(landing(0)), Some(landing(0))));
    assert!(holds(&city, me, cup));
    let environment = city.environment_of(me).unwrap();
    let feet = environment.world().pose(me).unwrap().translation;
    assert!((0.2..1.5).contains(&feet.x) && (1.5..3.5).contains(&feet.y), "{feet}");
    assert!(environment.graph().room_of(me).is_some());
    // The cup stays where it is put down.
    let table = of_class(&city, landing(0), "table");
    city.set_action(me, Action::walk(table)).unwrap();
    city.set_action(me, Action::place(cup, table)).unwrap();
    city.go(me, YARD).unwrap();
    assert_eq!((city.region_of(me), city.region_of(cup)), (Some(YARD), Some(landing(0))));
    city.step(Span::from_seconds(5.0));
    assert_eq!(city.active().collect::<Vec<_>>(), [YARD]);
    assert!(city.environment(YARD).unwrap().graph().node(cup).is_none());
    // A walk to a thing elsewhere leads there.
    city.set_action(me, Action::walk(cup)).unwrap();
    assert_eq!(city.region_of(me), Some(landing(0)));
    city.set_action(me, Action::grab(cup)).unwrap();
    assert!(holds(&city, me, cup));
}

#[test]
fn one_goes_up_by_lift_and_down_by_stairs() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let cup = take_cup(&mut city, me);
    city.go(me, landing(2)).unwrap();
    assert!(holds(&city, me, cup));
    assert_eq!(city.region_of(me), Some(landing(2)));
    let by_lift = city.lift(CABIN).unwrap();
    assert!(matches!(by_lift, LiftState::Opening(2) | LiftState::Open(2)), "{by_lift:?}");
    let top = city.frame(CABIN).unwrap().origin.z;
    assert!((top - 66.0).abs() < 1e-9, "{top}");
    city.step(Span::from_seconds(20.0));
    assert_eq!(city.lift(CABIN), Some(LiftState::Shut(2)));
    assert!(!city.portal(PortalId(3)).unwrap().passable);

    city.set_ways(me, |plan| plan.stop == 0 && plan.kind != PortalKind::Window && !is_lift(plan));
    city.go(me, landing(1)).unwrap();
    assert!(holds(&city, me, cup));
    city.go(me, YARD).unwrap();
    assert_eq!(city.lift(CABIN), Some(LiftState::Shut(2)), "it went down the stairs");
    assert!(holds(&city, me, cup));
}

fn is_lift(plan: &Portal) -> bool {
    plan.sides.iter().any(|side| side.region == CABIN)
}

#[test]
fn single_ticks_and_ways_at_once_end_alike() {
    let start = city(2);
    let agents: Vec<NodeId> = start.agents().collect();
    let mut at_once = start.clone();
    at_once.send(agents[1], landing(1)).unwrap();
    at_once.go(agents[0], landing(2)).unwrap();
    for step in [1, 7] {
        let mut stepped = start.clone();
        stepped.send(agents[1], landing(1)).unwrap();
        stepped.send(agents[0], landing(2)).unwrap();
        while stepped.tick() < at_once.tick() {
            stepped.step(Span(step.min(at_once.tick().0 - stepped.tick().0)));
        }
        assert_eq!(stepped.digest(), at_once.digest(), "in steps of {step}");
    }
}

#[test]
fn who_has_looked_in_makes_no_difference() {
    let mut digests = Vec::new();
    for order in [[0, 1, 2], [0, 2, 1], [1, 2, 0], [2, 1, 0], [2, 0, 1], [1, 0, 2]] {
        let mut city = city(1);
        let me = city.agents().next().unwrap();
        order.into_iter().for_each(|storey| drop(city.go(me, landing(storey)).unwrap()));
        city.go(me, YARD).unwrap();
        city.step(Span::from_seconds(600.0 - city.tick().0 as f64 / 60.0));
        assert_eq!(city.active().collect::<Vec<_>>(), [YARD]);
        digests.push(order.map(|storey| city.region_digest(landing(storey))));
    }
    assert!(digests.iter().flatten().all(|digest| digest.is_none()), "nobody has touched anything: {digests:?}");
}

#[test]
fn senseless_ways_are_refused() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let nobody = NodeId(7);
    assert!(matches!(city.go(nobody, YARD), Err(CityError::NoSuchAgent(_))));
    assert!(matches!(city.go(me, RegionId(0)), Err(CityError::NoWay { .. })));
    assert!(matches!(city.go(me, RegionId(99)), Err(CityError::NoWay { .. })));
    city.set_ways(me, |plan| plan.kind == PortalKind::Passage);
    city.go(me, landing(0)).unwrap();
    assert!(matches!(city.go(me, landing(1)), Err(CityError::NoWay { .. })));
    assert!(matches!(city.set_action(me, Action::grab(NodeId(5))), Err(CityError::Action(_))));
    assert_eq!(city.region_of(me), Some(landing(0)));
}

#[test]
fn neighbours_visit_each_other() {
    let mut city = City::make("building/7", 2).unwrap();
    let agents: Vec<NodeId> = city.agents().collect();
    let homes: Vec<RegionId> =
        city.space().regions().filter(|(_, region)| region.kind == RegionKind::Unit).map(|(id, _)| id).collect();
    assert_eq!(agents.iter().map(|id| city.region_of(*id).unwrap()).collect::<Vec<_>>(), homes[..2]);
    city.go(agents[0], homes[4]).unwrap();
    assert_eq!(city.region_of(agents[0]), Some(homes[4]));
    let is_landing = |plan: &Portal| plan.kind != PortalKind::Landing || !plan.stairs.is_empty();
    city.set_ways(agents[0], is_landing);
    city.go(agents[0], homes[1]).unwrap();
    let together = city.environment(homes[1]).unwrap();
    assert_eq!(together.agents().len(), 2);
}

#[test]
fn another_order_takes_the_place_of_a_walk_or_a_journey() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let you = city.add_agent(YARD).unwrap();
    let (table, tick) = (of_class(&city, YARD, "table"), city.tick());
    assert!(city.go(me, YARD).is_ok(), "it is there");
    assert_eq!(city.tick(), tick);
    let apart = [me, you].map(|id| city.environment_of(id).unwrap().world().pose(id).unwrap().translation.vector);
    assert!((apart[0] - apart[1]).norm() > 0.4, "two who begin in a region stand apart");
    // A walk, another walk, a journey; then, in its middle, something in the region where it leads.
    city.give(me, Action::walk(table)).unwrap();
    city.step(Span(10));
    city.go(me, landing(0)).unwrap();
    assert_eq!(city.region_of(me), Some(landing(0)));
    for ticks in [1, 100, 150, 300, 500] {
        let mut other = city.clone();
        other.send(me, landing(2)).unwrap();
        other.step(Span(ticks));
        other.go(me, YARD).unwrap();
        assert_eq!(other.region_of(me), Some(YARD));
        let told = other.step(Span(1));
        assert!(told.iter().all(|ending| ending.outcome.is_err()), "the first journey was broken off: {told:?}");
        assert_eq!(other.environment(YARD).unwrap().agents().len(), 2);
    }
}

/// An order has one ending, also if it is interrupted on the stairs, where one goes on to the next landing.
#[test]
fn an_interrupted_journey_ends_once() {
    for ticks in [1, 100, 200, 300, 400, 500, 600, 700] {
        let mut city = city(1);
        let me = city.agents().next().unwrap();
        city.set_ways(me, |plan| !is_lift(plan));
        city.send(me, landing(2)).unwrap();
        let told = city.step(Span(ticks)).len();
        city.interrupt(me);
        let endings = city.step(Span(3000));
        assert_eq!(told + endings.len(), 1, "{ticks}: {endings:?}");
        assert!(told == 1 || endings[0].outcome.is_err(), "{ticks}");
    }
}

/// An action that the rule refuses breaks no journey off.
#[test]
fn a_refused_action_leaves_a_journey() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let table = of_class(&city, YARD, "table");
    city.send(me, landing(1)).unwrap();
    city.step(Span(30));
    assert!(city.set_action(me, Action::one(Verb::Eat, table)).is_err());
    let endings = city.step(Span(6000));
    assert!(endings.len() == 1 && endings[0].outcome.is_ok(), "{endings:?}");
    assert_eq!(city.region_of(me), Some(landing(1)));
}

#[test]
fn a_sleeping_region_is_as_if_it_had_been_watched() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    move_cup(&mut city, me);
    city.go(me, YARD).unwrap();
    let mut ticks = city.clone();
    city.step(Span(600));
    (0..600).for_each(|_| drop(ticks.step(Span(1))));
    assert_eq!(city.digest(), ticks.digest());
}

#[test]
fn a_home_alone_is_as_it_is_elsewhere() {
    let mut city = City::make("apartment/42", 2).unwrap();
    let home = city.region_of(city.agents().next().unwrap()).unwrap();
    let (there, made) = (city.environment(home).unwrap(), Environment::make("apartment/42", 1).unwrap());
    let things = |graph: &SceneGraph| {
        let things = graph.nodes().filter(|node| node.kind() != NodeKind::Agent);
        things.map(|node| (node.id(), node.pose().copied())).collect::<Vec<_>>()
    };
    assert_eq!(things(there.graph()), things(made.graph()));
    let room = there.graph().of_class("kitchen")[0];
    let me = city.agents().last().unwrap();
    city.set_action(me, Action::walk(room)).unwrap();
    assert_eq!(city.environment(home).unwrap().graph().room_of(me), Some(room));
}

/// Buttons call the lift from outside and inside; nobody opens the door of a shaft by hand.
#[test]
fn buttons_call_the_lift() {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storeys = building.storeys().to_vec();
    let cabin = building.cabin();
    let mut city = City::of(building).make().unwrap();
    let me = city.agents().next().unwrap();
    city.set_ways(me, move |plan| plan.sides.iter().all(|side| side.region != cabin));
    city.go(me, storeys[1].gallery).unwrap();
    assert_eq!(city.lift(cabin), Some(LiftState::Shut(0)), "it came by the stairs");
    city.set_ways(me, |_| true);
    for verb in [Verb::Open, Verb::Close] {
        let error = city.give(me, Action::one(verb, storeys[1].lift_door)).unwrap_err();
        assert!(matches!(error, CityError::MovesByItself(_)), "{error}");
    }
    let push = |city: &mut City, button: NodeId| {
        city.set_action(me, Action::walk(button)).unwrap();
        city.set_action(me, Action::one(Verb::Push, button)).unwrap();
    };
    let comes = |city: &mut City, stop: u32| {
        let opens = (0..60).any(|_| {
            city.step(Span(30));
            city.lift(cabin) == Some(LiftState::Open(stop))
        });
        assert!(opens, "{stop}: {:?}", city.lift(cabin));
    };
    push(&mut city, storeys[1].call_button);
    comes(&mut city, 1);
    city.go(me, cabin).unwrap();
    push(&mut city, storeys[2].floor_button);
    comes(&mut city, 2);
    city.go(me, storeys[2].gallery).unwrap();
    assert_eq!(city.region_of(me), Some(storeys[2].gallery));
}

/// Doors of a lift that open and shut by themselves are no fault of whoever does something meanwhile.
#[test]
fn lift_doors_are_nobodys_fault() {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storey = building.storeys()[0].clone();
    let mut city = City::of(building).make().unwrap();
    let me = city.agents().next().unwrap();
    city.go(me, storey.gallery).unwrap();
    city.set_action(me, Action::walk(storey.call_button)).unwrap();
    city.set_action(me, Action::one(Verb::Push, storey.call_button)).unwrap();
    for waits in (0..240).step_by(3) {
        let mut city = city.clone();
        city.step(Span(waits));
        let done = city.set_action(me, "wave".parse().unwrap());
        assert!(done.is_ok(), "after {waits} ticks: {}", done.unwrap_err());
    }
}

/// A region where somebody has done something is remembered, though nothing differs there.
#[test]
fn done_actions_are_remembered() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let table = of_class(&city, YARD, "table");
    city.set_action(me, Action::walk(table)).unwrap();
    city.set_action(me, Action::one(Verb::Touch, table)).unwrap();
    city.go(me, landing(1)).unwrap();
    city.step(Span(120));
    assert!(city.environment(YARD).is_none());
    let goal = "Touch(table)".parse().unwrap();
    assert!(city.holds(&goal, me, GoalScope::Place(YARD)).unwrap());
}

/// In the middle of walks, on stairs, before and in the lift, with things in hand: a restored city goes on as the saved
/// one does.
#[test]
fn a_saved_city_goes_on_as_it_would_have() {
    let start = city(2);
    let agents: Vec<NodeId> = start.agents().collect();
    let mut city = start.clone();
    let cup = take_cup(&mut city, agents[0]);
    city.send(agents[0], landing(2)).unwrap();
    let table = of_class(&city, YARD, "table");
    city.go(agents[1], landing(1)).unwrap();
    city.give(agents[1], Action::walk(table)).unwrap();
    let (mut tried, mut stages) = (0, std::collections::BTreeSet::new());
    while city.agents().any(|agent| city.current_action(agent).is_some()) || city.region_of(cup) != Some(landing(2)) {
        city.step(Span(61));
        let saved = city.save().unwrap();
        stages.insert((
            city.region_of(agents[0]),
            city.region_of(agents[1]),
            city.lift(CABIN).map(|l| format!("{l:?}")),
        ));
        let mut restored = start.restore(&saved).unwrap();
        assert_eq!(restored.digest(), city.digest());
        assert_eq!(restored.save().unwrap(), saved);
        let mut goes_on = city.clone();
        let ended = |city: &mut City| {
            let endings = city.step(Span(600)).into_iter();
            endings.map(|e| (e.tick, e.agent, e.outcome.map_err(|why| why.to_string()))).collect::<Vec<_>>()
        };
        assert_eq!(ended(&mut restored), ended(&mut goes_on));
        assert_eq!(restored.digest(), goes_on.digest(), "{:?}", city.tick());
        tried += 1;
        assert!(tried < 100);
    }
    assert!(tried > 10 && stages.len() > 5, "{tried} {stages:?}");
}

#[test]
fn what_is_no_saved_city_is_refused() {
    let mut start = city(1);
    let me = start.agents().next().unwrap();
    take_cup(&mut start, me);
    let saved = start.save().unwrap();
    assert!(matches!(start.restore(b"nothing"), Err(CitySaveError::NotSaved)));
    assert!(start.restore(&saved[..saved.len() - 1]).is_err());
    for at in (0..saved.len()).step_by(saved.len() / 50) {
        let mut other = saved.clone();
        other[at] ^= 1;
        assert!(start.restore(&other).is_err(), "byte {at}");
    }
    let elsewhere = City::make("apartment/42", 1).unwrap();
    assert!(matches!(elsewhere.restore(&saved), Err(CitySaveError::OtherPlan)));
    // The same plan with another scene in a region.
    let changed = City::of(Changed(house())).make().unwrap();
    let error = changed.restore(&saved).unwrap_err();
    assert!(matches!(&error, CitySaveError::OtherRegion(region) if region.id == YARD), "{error}");
    start.send(me, landing(0)).unwrap();
    start.send(me, landing(1)).unwrap();
    assert!(matches!(start.save(), Err(CitySaveError::Unread(1))));
}

/// The house with something more in its yard.
struct Changed(House);

impl RegionScenes for Changed {
    fn space(&self) -> &Arc<Space> {
        self.0.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let mut scene = self.0.scene(region)?;
        if region == YARD {
            let cup = scene.of_class("cup")[0];
            let mut edit = scene.edit();
            edit.enter_state(cup, State::Dirty)?;
            edit.commit();
        }
        Ok(scene)
    }
}
