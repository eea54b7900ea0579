//! Agents that leave a world and arrive in another, with what they hold.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, turned};
use nalgebra::Vector3;
use vc_graph::{NodeId, Pose};
use vc_physics::{AgentError, Hand, PhysicsError, PhysicsWorld};

#[test]
fn travellers_take_along_what_they_hold() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let tray = scene.solid("tray", block([0.2, 0.15, 0.01]), scene.wood);
    let tray = scene.add("tray", tray, at(0.5, 0.0, 0.01));
    let cubes = [-0.1_f32, 0.0, 0.1].map(|y| scene.cube(0.03, at(0.5, y, 0.051)));
    let ball = scene.cube(0.03, at(0.2, 0.3, 0.03));
    let (me, other) = (scene.agent(at(0.0, 0.0, 0.0)), scene.agent(at(3.0, 3.0, 0.0)));
    let mut here = scene.world();
    here.run(60);
    let mut there = here.clone();
    there.depart(me).unwrap();
    cubes.into_iter().chain([tray, ball]).for_each(|id| there.remove(id).unwrap());
    let start = here.clone();

    here.grab(me, Hand::Right, tray).unwrap();
    here.grab(me, Hand::Left, ball).unwrap();
    let carried: Vec<NodeId> = cubes.into_iter().chain([tray, ball]).collect();
    let held = |world: &PhysicsWorld| {
        let feet = world.pose(me).unwrap();
        carried.iter().map(|id| feet.inverse() * world.pose(*id).unwrap()).collect::<Vec<Pose>>()
    };
    let before = held(&here);
    here.teleport(other, at(-3.0, 3.0, 0.0)).unwrap();
    for (number, (x, y, heading)) in [(1.0, 2.0, 0.4), (-2.0, 0.5, 2.0), (4.0, -4.0, -1.2)].into_iter().enumerate() {
        let traveller = here.depart(me).unwrap();
        assert_eq!(traveller.agent(), me);
        assert!(carried.iter().all(|id| traveller.things().any(|thing| thing == *id) && here.pose(*id).is_none()));
        assert_eq!((here.held(me, Hand::Right), here.agents().collect::<Vec<_>>()), (None, vec![other]));
        here.run(30);
        there.arrive(&traveller, turned(x, y, 0.0, Vector3::z(), heading)).unwrap();
        assert_eq!((there.held(me, Hand::Right), there.held(me, Hand::Left)), (Some(tray), Some(ball)), "{number}");
        there.run(30);
        for (was, is) in before.iter().zip(held(&there)) {
            let moved = (was.translation.vector - is.translation.vector).norm();
            assert!(moved < 1e-4 && was.rotation.angle_to(&is.rotation) < 1e-3, "{was} {is}");
        }
        std::mem::swap(&mut here, &mut there);
    }
    // It is put down as if it had never been away.
    here.teleport(me, at(0.0, 0.0, 0.0)).unwrap();
    here.put(me, Hand::Right, at(0.6, 0.0, 0.011)).unwrap();
    here.run(120);
    assert!(cubes.iter().all(|cube| here.supports(*cube) == [tray]), "the load stays on the tray");

    let twice = there.clone().depart(other).map(|traveller| there.arrive(&traveller, at(0.0, 0.0, 0.0)));
    assert_eq!(twice.unwrap(), Err(PhysicsError::Duplicate(other)));
    assert_eq!(here.clone().depart(tray).err(), Some(AgentError::NoSuchAgent(tray)));
    let traveller = start.clone().depart(me).unwrap();
    let nowhere = Pose::translation(f32::NAN, 0.0, 0.0);
    assert!(matches!(
        there.clone().arrive(&traveller, nowhere),
        Err(PhysicsError::Duplicate(_) | PhysicsError::NotFinite(..))
    ));
}
