//! Edits keep the invariants, are undone completely, and never reuse a number.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use proptest::prelude::*;
use vc_graph::format::native;
use vc_graph::{ChangeSet, Draft, Edge, EditError, NodeId, Place, Pose, Relation, SceneBuilder, SceneGraph, State};
use vc_testkit::edits::{apply, make, plans};
use vc_testkit::flat::Flat;
use vc_testkit::scenes::{scene, steps};
use vc_testkit::{cases, flat};

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_committed_edit_leaves_a_sound_scene(steps in steps(12), plans in plans(25), posed: bool) {
        let mut graph = scene(&steps, posed);
        for plan in plans {
            apply(&mut graph, plan);
            prop_assert_eq!(graph.validate(), [], "after {:?}", plan);
        }
    }

    #[test]
    fn a_dropped_edit_has_done_nothing(steps in steps(12), plans in plans(12)) {
        let mut graph = scene(&steps, true);
        let before = graph.clone();
        let mut edit = graph.edit();
        for plan in plans {
            make(&mut edit, plan).unwrap();
        }
        drop(edit);
        prop_assert!(graph == before);
        prop_assert_eq!(graph.digest(), before.digest());
    }

    #[test]
    fn changes_go_back_and_forth(steps in steps(12), plans in plans(12)) {
        let mut graph = scene(&steps, true);
        let mut past = vec![graph.clone()];
        let mut sets = Vec::new();
        for plan in plans {
            sets.push(apply(&mut graph, plan));
            past.push(graph.clone());
        }
        for (set, before) in sets.iter().zip(&past).rev() {
            set.undo(&mut graph).unwrap();
            prop_assert!(graph == *before);
        }
        for (set, after) in sets.iter().zip(&past[1..]) {
            set.apply(&mut graph).unwrap();
            prop_assert!(graph == *after);
            prop_assert!(set.inverse().inverse() == *set);
        }
    }

    #[test]
    fn what_lies_between_two_states_leads_from_one_to_the_other(steps in steps(12), plans in plans(25), middle in 0_usize..25) {
        let mut graph = scene(&steps, true);
        let mut past = vec![graph.clone()];
        for plan in plans {
            apply(&mut graph, plan);
            past.push(graph.clone());
        }
        let before = &past[middle.min(past.len() - 1)];
        let changes = ChangeSet::between(before, &graph);
        let mut again = before.clone();
        changes.apply(&mut again).unwrap();
        prop_assert!(again == graph);
        changes.undo(&mut again).unwrap();
        prop_assert!(again == *before);
        prop_assert!(ChangeSet::between(&graph, &graph.clone()).is_empty());
        // A scene that shares nothing with the other says the same.
        let apart = native::read(&native::write(&graph), graph.classes()).unwrap();
        prop_assert!(ChangeSet::between(&apart, &graph).is_empty());
    }

    #[test]
    fn a_clone_stays_as_it_was(steps in steps(12), plans in plans(12)) {
        let mut graph = scene(&steps, true);
        let (copy, digest) = (graph.clone(), graph.digest());
        let text = vc_graph::format::native::write(&copy);
        plans.into_iter().for_each(|plan| { apply(&mut graph, plan); });
        prop_assert_eq!(copy.digest(), digest);
        prop_assert_eq!(vc_graph::format::native::write(&copy), text);
    }

    #[test]
    fn a_misfit_changes_nothing(steps in steps(10), other in steps(10), plans in plans(6)) {
        let mut graph = scene(&steps, true);
        let sets: Vec<_> = plans.into_iter().map(|plan| apply(&mut graph, plan)).collect();
        let mut wrong = scene(&other, true);
        let before = wrong.clone();
        for set in sets {
            match set.apply(&mut wrong) {
                Err(misfit) => {
                    prop_assert!(wrong == before);
                    prop_assert!(misfit.index < misfit.total && misfit.total == set.changes().len());
                    prop_assert_eq!(&*misfit.change, &set.changes()[misfit.index]);
                }
                Ok(()) => {
                    set.undo(&mut wrong).unwrap();
                    prop_assert!(wrong == before);
                }
            }
        }
    }

    #[test]
    fn numbers_are_never_used_again(steps in steps(8), plans in plans(25)) {
        let mut graph = scene(&steps, false);
        let mut used: BTreeSet<NodeId> = graph.nodes().map(|n| n.id()).collect();
        for plan in plans {
            let before: BTreeSet<NodeId> = graph.nodes().map(|n| n.id()).collect();
            apply(&mut graph, plan);
            for node in graph.nodes().filter(|n| !before.contains(&n.id())) {
                prop_assert!(used.insert(node.id()), "{} was used before", node.id());
            }
        }
    }
}

/// A kitchen with a table, a cup on it and a person.
fn small() -> (SceneGraph, [NodeId; 4]) {
    let mut scene = SceneBuilder::new("small");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let cup = scene.add_on(table, Draft::new("cup")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), [kitchen, table, cup, me])
}

#[test]
fn a_room_goes_only_when_it_is_empty() {
    let (mut graph, [kitchen, table, cup, me]) = small();
    let mut edit = graph.edit();
    let refused = edit.remove(kitchen).unwrap_err();
    let text = "kitchen.1 still contains 3 nodes, kitchen_table.2 among them; move or remove them first";
    assert_eq!(refused.to_string(), text);
    [table, cup, me, kitchen].into_iter().for_each(|id| edit.remove(id).unwrap());
    edit.commit();
    assert!(graph.is_empty() && graph.rooms().is_empty() && graph.of_class("cup").is_empty());
    let mut edit = graph.edit();
    assert_eq!(edit.add(Draft::new("cup")), Ok(NodeId(5)), "numbers go on");
}

#[test]
fn what_rested_on_a_removed_thing_stays_in_the_room() {
    let (mut graph, [kitchen, table, cup, _]) = small();
    let mut edit = graph.edit();
    edit.remove(table).unwrap();
    edit.commit();
    assert_eq!((graph.place(cup), graph.room_of(cup)), (None, Some(kitchen)));
    assert_eq!(graph.validate(), []);
}

#[test]
fn edits_refuse_what_cannot_be() {
    let (mut graph, [kitchen, table, cup, me]) = small();
    let before = graph.clone();
    let (none, on) = (NodeId(99), |at| Place { relation: Relation::On, at });
    let mut edit = graph.edit();
    assert_eq!(
        edit.place(table, on(cup)).unwrap_err().to_string(),
        "kitchen_table.2 cannot rest at cup.3: cup.3 itself rests on or in kitchen_table.2"
    );
    assert!(matches!(edit.place(cup, on(cup)), Err(EditError::SupportCycle { .. })));
    assert_eq!(edit.place(cup, on(none)), Err(EditError::NoSuchNode(none)));
    assert_eq!(edit.add_with_id(cup, Draft::new("cup")), Err(EditError::Duplicate(cup)));
    assert_eq!(edit.move_to_room(cup, table).unwrap_err().to_string(), "kitchen_table.2 is no room");
    assert_eq!(edit.hold(table, cup).unwrap_err().to_string(), "kitchen_table.2 is no agent");
    assert_eq!(edit.relate(Edge::new(cup, Relation::On, table)), Err(EditError::NotFree(Relation::On)));
    assert_eq!(edit.relate(Edge::new(cup, Relation::InRoom, kitchen)), Err(EditError::NotFree(Relation::InRoom)));
    assert_eq!(edit.relate(Edge::new(me, Relation::HoldsLeft, cup)), Err(EditError::NotFree(Relation::HoldsLeft)));
    assert_eq!(
        edit.set_pose(cup, Some(Pose::translation(f32::NAN, 0.0, 0.0))).unwrap_err().to_string(),
        "the pose of cup.3 is not finite"
    );
    assert!(matches!(
        edit.add(Draft::new("cup").at(Pose::translation(f32::INFINITY, 0.0, 0.0))),
        Err(EditError::NotFinite(_))
    ));
    for failing in [edit.remove(none), edit.detach(none), edit.enter_state(none, State::Open), edit.fill(none, None)] {
        assert_eq!(failing, Err(EditError::NoSuchNode(none)));
    }
    assert!(edit.commit().is_empty());
    assert_eq!(graph, before);
}

#[test]
fn hands_hold_one_thing_each() {
    let mut flat = Flat::new();
    let [me, cup, plate, knife] = ["me", "cup", "plate", "knife"].map(|n| flat.id(n));
    flat.edit(|edit| {
        edit.hold(me, cup).unwrap();
        edit.hold(me, cup).unwrap();
        edit.hold(me, plate).unwrap();
        assert!(matches!(edit.hold(me, knife), Err(EditError::HandsFull { .. })));
    });
    assert!(flat.has("me", Relation::HoldsRight, "cup") && flat.has("me", Relation::HoldsLeft, "plate"));
    assert_eq!(flat.graph().held(me).collect::<Vec<_>>(), [cup, plate]);
    assert_eq!(flat.graph().validate(), []);
    let flat::Flat { other, .. } = flat;
    flat.edit(|edit| edit.hold(other, cup).unwrap());
    assert_eq!(flat.graph().holder(cup), Some(Place { relation: Relation::HoldsRight, at: other }));
}

#[test]
fn states_end_their_opposites() {
    let (mut graph, [_, _, cup, _]) = small();
    let mut edit = graph.edit();
    for (state, gone) in [(State::Dirty, State::Clean), (State::Hot, State::Cold), (State::Clean, State::Dirty)] {
        edit.enter_state(cup, state).unwrap();
        let states = edit.graph().node(cup).unwrap().states();
        assert!(states.contains(state) && !states.contains(gone));
    }
    edit.fill(cup, Some("tea".into())).unwrap();
    assert!(edit.graph().node(cup).unwrap().is(State::Filled));
    edit.fill(cup, None).unwrap();
    assert!(edit.graph().node(cup).unwrap().is(State::Empty));
}

#[test]
fn the_last_number_is_not_passed() {
    let mut scene = SceneBuilder::new("full");
    scene.add_with_id(NodeId(u32::MAX), Draft::new("kitchen")).unwrap();
    assert_eq!(scene.add(Draft::new("cup")), Err(EditError::NumbersExhausted));
}

#[test]
fn a_node_is_given_another_scale() {
    let mut scene = SceneBuilder::new("flat");
    let room = scene.add(Draft::new("bedroom")).unwrap();
    let bed = scene.add_in(room, Draft::new("bed")).unwrap();
    let size = nalgebra::Vector3::new(0.1, 0.4, 0.8);
    let shirt = Draft::new("shirt").bounds(vc_graph::Bounds::standing(size)).at(vc_graph::Pose::identity());
    let shirt = scene.add_on(bed, shirt).unwrap();
    let mut graph = scene.build();
    let before = graph.clone();
    let mut edit = graph.edit();
    edit.set_scale(shirt, nalgebra::Vector3::new(2.0, 0.5, 0.25)).unwrap();
    let changes = edit.commit();
    let node = graph.node(shirt).unwrap();
    assert_eq!(node.spec().scale, nalgebra::Vector3::new(2.0, 0.5, 0.25));
    assert!((node.spec().bounds.unwrap().size() - nalgebra::Vector3::new(0.2, 0.2, 0.2)).norm() < 1e-6);
    assert!(node.aabb().unwrap().min.z.abs() < 1e-6, "it stands where it stood");
    assert_eq!((graph.room_of(shirt), graph.place(shirt)), (Some(room), before.place(shirt)));
    assert!(graph.validate().is_empty());
    // Like every change it can be undone and redone.
    changes.undo(&mut graph).unwrap();
    assert_eq!(graph, before);
    for wrong in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let mut edit = graph.edit();
        assert!(edit.set_scale(shirt, nalgebra::Vector3::new(1.0, wrong, 1.0)).is_err(), "{wrong}");
    }
    assert!(graph.edit().set_scale(NodeId(99), nalgebra::Vector3::repeat(1.0)).is_err());
    assert_eq!(graph, before);
}
