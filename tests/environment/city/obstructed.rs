//! Lifts with something between their doors.

use std::error::Error;
use std::sync::Arc;

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{RegionId, Space};
use virtualcity::graph::{Bounds, Draft, NodeId, Pose, SceneBuilder, SceneGraph};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::{City, LiftState, RegionScenes};

use super::{CABIN, House, house, landing};

/// The house with a box before its lift.
struct WithBox(House);

impl RegionScenes for WithBox {
    fn space(&self) -> &Arc<Space> {
        self.0.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let scene = self.0.scene(region)?;
        if region != landing(0) {
            return Ok(scene);
        }
        let floor = scene.of_class("floor")[0];
        let mut scene = SceneBuilder::from_graph(scene);
        let thing = Draft::new("box").bounds(Bounds::standing([0.2, 0.2, 0.2].into()));
        scene.add_on(floor, thing.at(Pose::translation(4.5, 2.75, 0.0)))?;
        Ok(scene.build())
    }
}

/// The middle of a thing in the frame of the first landing.
fn middle(city: &City, thing: NodeId) -> Point3<f32> {
    let region = city.region_of(thing).unwrap();
    let shift = city.frame(region).unwrap().to(&city.frame(landing(0)).unwrap());
    shift * city.peek(region).unwrap().world().body(thing).unwrap().centre_of_mass()
}

/// Pushes a thing along X, by and by, until it is somewhere.
fn push_until(city: &mut City, thing: NodeId, speed: f32, is_there: impl Fn(f32) -> bool) {
    for _ in 0..100 {
        let at = middle(city, thing);
        if is_there(at.x) {
            return;
        }
        let there = city.peek(city.region_of(thing).unwrap()).unwrap();
        let body = there.world().body(thing).unwrap();
        city.push(thing, Vector3::new(speed * body.mass(), 0.0, 0.0), body.centre_of_mass()).unwrap();
        city.step(Span(12));
    }
    panic!("it is at {}", middle(city, thing));
}

/// A lift stays with open doors while something lies across its sill, opens again for it, and goes when it is away.
#[test]
fn a_lift_does_not_go_with_something_across_its_sill() {
    let mut city = City::of(WithBox(house())).make().unwrap();
    let me = city.agents().next().unwrap();
    city.go(me, landing(0)).unwrap();
    let thing = city.environment(landing(0)).unwrap().graph().of_class("box")[0];
    city.go(me, CABIN).unwrap();
    assert_eq!(city.lift(CABIN), Some(LiftState::Open(0)));
    push_until(&mut city, thing, 0.5, |x| (x - 5.0).abs() < 0.06);
    assert_eq!(city.lift(CABIN), Some(LiftState::Open(0)), "the doors have shut before it was there");
    city.send(me, landing(2)).unwrap();
    for tick in 0..60 * 30 {
        city.step(Span(1));
        assert!(matches!(city.lift(CABIN), Some(LiftState::Open(0))), "tick {tick}");
    }
    assert_eq!(city.validate().unwrap(), []);
    let restored = City::of(WithBox(house())).make().unwrap().restore(&city.save().unwrap()).unwrap();
    assert_eq!(restored.digest(), city.digest());
    push_until(&mut city, thing, -0.5, |x| x < 4.8);
    let ended = city.step_until_idle(Span::from_seconds(120.0));
    assert!(ended.len() == 1 && ended[0].outcome.is_ok(), "{ended:?}");
    assert_eq!((city.region_of(me), city.region_of(thing)), (Some(landing(2)), Some(landing(0))));
    assert_eq!(city.validate().unwrap(), []);
}
