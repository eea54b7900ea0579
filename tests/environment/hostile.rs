//! Hostile requests to an environment give an error, and never a panic.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use nalgebra::Vector2;
use virtualcity::graph::{Action, Bounds, Draft, NodeId, Pose, SceneBuilder, SceneGraph, Seed, Verb};
use virtualcity::render::{Camera, Modality};
use virtualcity::{Environment, MakeError, SaveError, Steering, Viewpoint};

/// A kitchen with a dishwasher, a table and a mug.
fn kitchen() -> SceneGraph {
    let mut scene = SceneBuilder::new("kitchen");
    let size = |size: [f32; 3]| Bounds::standing(size.into());
    let room = Draft::new("kitchen").bounds(size([5.0, 5.0, 2.5])).at(Pose::identity());
    let room = scene.add(room).unwrap();
    let floor = Draft::new("floor").bounds(size([5.0, 5.0, 0.1])).at(Pose::translation(0.0, 0.0, -0.1));
    scene.add_in(room, floor).unwrap();
    for (class, x, y, z) in [("dishwasher", 0.0, 1.0, 0.0), ("kitchen_table", 1.5, 0.0, 0.0), ("mug", 1.5, 0.0, 1.0)] {
        scene.add_in(room, Draft::new(class).at(Pose::translation(x, y, z))).unwrap();
    }
    scene.build()
}

fn home() -> (Environment, NodeId) {
    let home = Environment::from_scene(kitchen(), 1).unwrap();
    let me = home.agents()[0];
    (home, me)
}

/// Acts and observes in an environment made from a broken file.
fn is_lived_in(mut home: Environment) {
    for agent in home.agents().to_vec() {
        let _ = home.room_observation(agent);
        for id in home.graph().nodes().map(|n| n.id()).collect::<Vec<_>>() {
            let _ = home.set_action(agent, Action::one(Verb::Walk, id));
        }
    }
    let _ = home.render(Viewpoint::Overhead, Modality::Depth, 16, 12);
    let _ = (home.digest(), home.save());
}

#[test]
fn saved_files_may_be_cut_off_and_altered() {
    let (mut home, me) = home();
    let table = home.graph().of_class("kitchen_table")[0];
    home.set_action(me, Action::one(Verb::Walk, table)).unwrap();
    let saved = home.save().unwrap();
    assert_eq!(home.restore(&saved).unwrap().digest(), home.digest());
    for end in (0..saved.len()).step_by(saved.len() / 97 + 1) {
        assert!(home.restore(&saved[..end]).is_err(), "cut off at {end} of {}", saved.len());
    }
    let mut stream = Seed(5).stream();
    for _ in 0..160 {
        let mut altered = saved.clone();
        let (at, bit) = (stream.below(altered.len()), stream.below(8));
        altered[at] ^= 1 << bit;
        if let Ok(home) = home.restore(&altered) {
            is_lived_in(home);
        }
    }
    let other = Environment::make("apartment/42", 1).unwrap();
    assert!(matches!(other.restore(&saved), Err(SaveError::OtherStart { .. })));
}

#[test]
fn numbers_may_be_none() {
    let (mut home, me) = home();
    for radius in [f32::NAN, f32::NEG_INFINITY, -1.0, 0.0, f32::MAX, f32::INFINITY] {
        let _ = home.observation(me, radius);
        let _ = home.observation(NodeId(u32::MAX), radius);
    }
    let nan = f32::NAN;
    for (velocity, heading) in [(Vector2::new(nan, 0.0), 0.0), (Vector2::zeros(), nan), (Vector2::new(1e30, 0.0), 1e30)]
    {
        let _ = home.steer(me, &Steering { velocity, heading, jump: true });
    }
    assert!(home.steer(NodeId(u32::MAX), &Steering::default()).is_err());
    let good = Camera::with_fov(32, 24, 1.0);
    for camera in [Camera { near: nan, ..good }, Camera { focal: (0.0, nan), ..good }, Camera { near: 0.0, ..good }] {
        assert!(home.render(Viewpoint::Free(camera), Modality::Rgb, 32, 24).is_err(), "{camera:?}");
    }
    for view in [Viewpoint::Agent(NodeId(u32::MAX)), Viewpoint::Room(me), Viewpoint::Above(NodeId(u32::MAX))] {
        for (width, height) in [(32, 24), (0, 0), (1, u32::MAX), (u32::MAX, 1)] {
            let _ = home.render(view, Modality::Rgb, width, height);
        }
        assert!(home.render(view, Modality::Rgb, 0, 0).is_err());
    }
}

#[test]
fn scenes_may_be_of_something_else() {
    let (mut home, me) = home();
    for graph in [SceneBuilder::new("nothing").build(), Environment::make("apartment/3", 2).unwrap().graph().clone()] {
        let before = home.digest();
        match home.reset(&graph) {
            Ok(_) => is_lived_in(home.clone()),
            Err(_) => assert_eq!(home.digest(), before, "a refusal changes nothing"),
        }
        // The removed objects exist again, although with other bodies.
        home.reset(&home.start().clone()).unwrap();
        assert_eq!(home.graph().digest(), home.start().digest());
    }
    let _ = home.set_action(me, Action::one(Verb::Walk, NodeId(u32::MAX)));
    let empty = Environment::from_scene(SceneBuilder::new("nothing").build(), 1);
    assert!(matches!(empty, Err(MakeError::NoPoses { .. })));
}
