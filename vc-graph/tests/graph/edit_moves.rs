//! Locations of objects after an edit that moves them.
#![allow(clippy::unwrap_used)]

use nalgebra::Isometry3;
use vc_graph::{Place, Pose, Relation};
use vc_testkit::flat::Flat;

#[test]
fn placing_brings_a_thing_with_all_on_it_to_the_room() {
    let mut flat = Flat::new();
    let (plate, table) = (flat.id("plate"), flat.id("coffee_table"));
    flat.edit(|edit| edit.place(plate, Place { relation: Relation::On, at: table }).unwrap());
    let living_room = flat.id("living_room");
    assert_eq!(flat.graph().room_of(plate), Some(living_room));
    assert_eq!(flat.graph().room_of(flat.id("bread")), Some(living_room));
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn carrying_moves_poses_of_all_that_rests_on_a_thing() {
    let mut flat = Flat::new();
    let (plate, bread, knife) = (flat.id("plate"), flat.id("bread"), flat.id("knife"));
    let turn = Isometry3::rotation(nalgebra::Vector3::z() * std::f32::consts::FRAC_PI_2);
    flat.edit(|edit| {
        edit.set_pose(plate, Some(Pose::translation(1.0, 0.0, 0.7))).unwrap();
        edit.set_pose(bread, Some(Pose::translation(1.1, 0.0, 0.7))).unwrap();
        edit.set_pose(knife, Some(Pose::translation(1.2, 0.0, 0.7))).unwrap();
        edit.carry_to(plate, Pose::translation(5.0, 5.0, 1.0) * turn).unwrap();
    });
    let at = |name: &str| flat.graph().node(flat.id(name)).unwrap().position().unwrap();
    assert!((at("plate") - nalgebra::Point3::new(5.0, 5.0, 1.0)).norm() < 1e-5);
    assert!((at("bread") - nalgebra::Point3::new(5.0, 5.1, 1.0)).norm() < 1e-5);
    assert!((at("knife") - nalgebra::Point3::new(1.2, 0.0, 0.7)).norm() < 1e-5, "it is not on the plate");
}

#[test]
fn moving_to_another_room_leaves_the_support_behind() {
    let mut flat = Flat::new();
    let (cup, garage) = (flat.id("cup"), flat.id("garage"));
    flat.edit(|edit| edit.move_to_room(cup, garage).unwrap());
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn a_room_is_not_moved_into_a_room() {
    let mut flat = Flat::new();
    let (kitchen, garage) = (flat.id("kitchen"), flat.id("garage"));
    flat.edit(|edit| assert!(edit.move_to_room(kitchen, garage).is_err()));
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn a_place_that_is_a_hand_is_a_hand_again() {
    let mut flat = Flat::after(&["walk cup", "grab cup"]);
    let (cup, held) = (flat.id("cup"), flat.place("cup").unwrap());
    assert_eq!(held.relation, Relation::HoldsRight);
    flat.edit(|edit| {
        edit.detach(cup).unwrap();
        let _ = edit.place(cup, held);
    });
    assert_eq!(flat.graph().validate(), [], "either it is in the hand again or the place is refused");
}

#[test]
fn a_place_is_no_other_relation() {
    let mut flat = Flat::new();
    let (cup, table) = (flat.id("cup"), flat.id("kitchen_table"));
    let garage = flat.id("garage");
    flat.edit(|edit| {
        assert!(edit.place(cup, Place { relation: Relation::Near, at: table }).is_err());
        assert!(edit.place(cup, Place { relation: Relation::InRoom, at: garage }).is_err());
    });
}

#[test]
fn things_are_placed_where_they_are_seen() {
    let mut flat = Flat::new();
    let [cup, fridge, plate, me, kitchen] = ["cup", "fridge", "plate", "me", "kitchen"].map(|n| flat.id(n));
    let seen = [Place { relation: Relation::On, at: plate }, Place { relation: Relation::Inside, at: fridge }];
    flat.edit(|edit| edit.place_as_seen(cup, &seen, Some(kitchen)).unwrap());
    assert_eq!(flat.graph().places(cup).collect::<Vec<_>>(), seen);
    let hand = Place { relation: Relation::HoldsLeft, at: me };
    flat.edit(|edit| edit.place_as_seen(cup, &[hand], Some(kitchen)).unwrap());
    assert_eq!(flat.graph().holder(cup), Some(hand));
    flat.edit(|edit| edit.place_as_seen(cup, &[], None).unwrap());
    assert_eq!(flat.graph().place(cup), None);
    flat.edit(|edit| {
        let cyclic = Place { relation: Relation::On, at: flat_bread(edit.graph()) };
        assert!(edit.place_as_seen(plate, &[cyclic], None).is_err());
    });
}

fn flat_bread(graph: &vc_graph::SceneGraph) -> vc_graph::NodeId {
    graph.of_class("bread")[0]
}
