//! Worlds of several regions against single homes: where a region is, who has looked in and how often makes no
//! difference, and nothing is lost on the way.

use std::collections::BTreeMap;
use std::error::Error;
use std::sync::Arc;

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{Region, RegionFrame, RegionId, RegionKind, Space};
use virtualcity::graph::{Action, Bounds, Draft, NodeId, Pose, Relation, SceneBuilder, SceneGraph, Seed};
use virtualcity::procgen::{Apartment, Building, BuildingSpecification};
use virtualcity::{City, RegionScenes, legal_action};

use super::{House, YARD, house, house_of, landing, move_cup, of_class};

/// A home alone, somewhere in the world.
struct Alone(Arc<Space>);

impl RegionScenes for Alone {
    fn space(&self) -> &Arc<Space> {
        &self.0
    }

    fn scene(&self, _: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        Ok(Apartment::from_seed(Seed(42))?.scene())
    }
}

fn home_at(frame: RegionFrame) -> City {
    let home = Region::new(RegionKind::Unit, "apartment/42").at(frame);
    City::of(Alone(Arc::new(Space::single(home).unwrap()))).make().unwrap()
}

/// Whether everything is tried, which takes minutes.
fn whole() -> bool {
    std::env::var_os("VC_WHOLE").is_some()
}

/// A home far from the origin and turned is, in its own frame, the same to the bit; in the world it is where it was put.
#[test]
fn a_home_elsewhere_in_the_world_is_the_same_but_for_its_frame() {
    let frame = RegionFrame::new([4000.0, -3000.0, 60.0], 37.0_f64.to_radians());
    let (mut here, mut there) = (home_at(RegionFrame::WORLD), home_at(frame));
    let me = here.agents().next().unwrap();
    let home = here.region_of(me).unwrap();
    let mut stream = Seed(42).child("a home elsewhere").stream();
    let (mut done, all) = (0, if whole() { 1000 } else { 100 });
    for _ in 0..all {
        let action = legal_action(here.environment(home).unwrap().graph(), me, &mut stream);
        let (one, other) = (here.set_action(me, action), there.set_action(me, action));
        assert_eq!(one.as_ref().ok(), other.as_ref().ok(), "{action}");
        done += usize::from(one.is_ok());
        let (one, other) = (here.environment(home).unwrap(), there.environment(home).unwrap());
        assert!(one.graph() == other.graph() && one.digest() == other.digest(), "{action}");
    }
    assert!(done > all / 2, "{done}");
    assert_ne!(here.digest(), there.digest(), "they are elsewhere");
    let feet = there.environment(home).unwrap().world().pose(me).unwrap();
    let at = there.frame(home).unwrap().pose(&feet).translation;
    let turned = RegionFrame::new([0.0; 3], 37.0_f64.to_radians()).pose(&feet).translation;
    let off = [at.x - turned.x - 4000.0, at.y - turned.y + 3000.0, at.z - turned.z - 60.0];
    assert!(off.iter().all(|metres| metres.abs() < 1e-6), "{off:?}");
}

/// All orders of some things.
fn orders(all: &[RegionId]) -> Vec<Vec<RegionId>> {
    if all.is_empty() {
        return vec![Vec::new()];
    }
    let first = |at: usize| {
        let rest: Vec<RegionId> = [&all[..at], &all[at + 1..]].concat();
        orders(&rest).into_iter().map(move |order| [vec![all[at]], order].concat()).collect::<Vec<_>>()
    };
    (0..all.len()).flat_map(first).collect()
}

/// Four homes that somebody looks into, in every order, are as nobody had been there.
#[test]
fn homes_that_were_looked_into_are_as_they_were() {
    let wishes = BuildingSpecification { storeys: 2, ..Default::default() };
    let building = Building::generate(&wishes, Seed(5)).unwrap();
    let homes: Vec<RegionId> = building.storeys().iter().flat_map(|storey| storey.homes).collect();
    let yard = building.yard();
    let mut start = City::of(building).make().unwrap();
    let me = start.agents().next().unwrap();
    start.go(me, yard).unwrap();
    let orders = orders(&homes);
    assert_eq!(orders.len(), 24);
    for order in orders.into_iter().step_by(if whole() { 1 } else { 9 }) {
        let mut city = start.clone();
        for home in &order {
            city.go(me, *home).unwrap();
            assert!(city.environment(*home).is_some());
        }
        city.go(me, yard).unwrap();
        city.step(Span::from_seconds(30.0));
        assert_eq!(city.active().collect::<Vec<_>>(), [yard], "{order:?}");
        let left: Vec<_> = homes.iter().filter_map(|home| city.region_digest(*home)).collect();
        assert_eq!(left, [], "{order:?}");
    }
}

/// Leaving and coming back moves nothing.
#[test]
fn a_hundred_leavings_move_no_pose() {
    let mut city = City::of(house()).make().unwrap();
    let me = city.agents().next().unwrap();
    let cup = move_cup(&mut city, me);
    let poses = |city: &City| -> BTreeMap<NodeId, [u32; 7]> {
        let there = city.environment(landing(0)).unwrap();
        let things = there.graph().nodes().map(|node| node.id()).filter(|id| *id != me);
        let bits = |pose: Pose| {
            let turn = pose.rotation.coords;
            let at = pose.translation.vector;
            [at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w].map(f32::to_bits)
        };
        things.filter_map(|id| Some((id, bits(there.world().pose(id)?)))).collect()
    };
    let before = poses(&city);
    assert!(before.contains_key(&cup) && before.len() > 2);
    for leaving in 0..100 {
        city.go(me, YARD).unwrap();
        city.step(Span::from_seconds(3.0));
        assert!(city.environment(landing(0)).is_none());
        city.go(me, landing(0)).unwrap();
        assert_eq!(poses(&city), before, "{leaving}");
    }
}

/// The house with a tray of three cups on the table of its yard.
struct WithTray(House);

impl RegionScenes for WithTray {
    fn space(&self) -> &Arc<Space> {
        self.0.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let scene = self.0.scene(region)?;
        if region != YARD {
            return Ok(scene);
        }
        let table = scene.of_class("table")[0];
        let mut scene = SceneBuilder::from_graph(scene);
        let standing = |size: [f32; 3]| Bounds::standing(size.into());
        let tray = Draft::new("tray").bounds(standing([0.3, 0.4, 0.03]));
        let tray = scene.add_on(table, tray.at(Pose::translation(1.5, 0.9, 0.7)))?;
        for at in [0.78, 0.9, 1.02] {
            let cup = Draft::new("cup").bounds(standing([0.07, 0.07, 0.09]));
            scene.add_on(tray, cup.at(Pose::translation(1.5, at, 0.73)))?;
        }
        Ok(scene.build())
    }
}

/// Rides between eight storeys with a full tray: nothing falls, nothing is lost, and it arrives where it was sent.
#[test]
fn a_full_tray_rides_between_eight_storeys() {
    let rides = if whole() { 1000 } else { 10 };
    let mut city = City::of(WithTray(house_of(8))).make().unwrap();
    let me = city.agents().next().unwrap();
    let tray = of_class(&city, YARD, "tray");
    let cups: Vec<NodeId> = city.environment(YARD).unwrap().graph().relating(Relation::On, tray).collect();
    assert_eq!(cups.len(), 3);
    city.set_action(me, Action::walk(tray)).unwrap();
    city.set_action(me, Action::grab(tray)).unwrap();
    city.go(me, landing(0)).unwrap();
    city.set_ways(me, |plan| plan.stairs.is_empty());
    let (mut stream, mut storey) = (Seed(8).child("rides").stream(), 0);
    for ride in 0..rides {
        storey = (storey + 1 + stream.below(7) as u32) % 8;
        city.go(me, landing(storey)).unwrap();
        let there = city.environment(landing(storey)).unwrap();
        assert!(there.graph().held(me).eq([tray]), "{ride}");
        let mut on_it: Vec<NodeId> = there.graph().relating(Relation::On, tray).collect();
        on_it.sort_unstable();
        assert_eq!(on_it, cups, "{ride}");
        let at = |id: NodeId| there.world().pose(id).unwrap().translation.vector;
        for cup in &cups {
            let off = at(*cup) - at(tray);
            assert!(off.xy().norm() < 0.2 && (0.0..0.1).contains(&off.z), "{ride}: {off}");
        }
        assert_eq!(there.graph().validate(), [], "{ride}");
    }
}
