//! Agents, and cameras in rooms, see carried objects and open containers, and look into rooms rather than at
//! walls.

use virtualcity::graph::{Action, NodeId, Property, Relation, Verb};
use virtualcity::nalgebra::Vector3;
use virtualcity::render::{Frame, Modality};
use virtualcity::{Environment, Viewpoint};

const SIZE: (u32, u32) = (80, 60);

fn home(seed: u64) -> Environment {
    super::home(seed, 1)
}

fn seen(home: &Environment, view: Viewpoint) -> Frame {
    home.render(view, Modality::Instance | Modality::Depth, SIZE.0, SIZE.1).unwrap()
}

/// The rows of the picture, from the top, in which some nodes are visible, one entry per pixel.
fn rows(frame: &Frame, which: impl Fn(NodeId) -> bool) -> Vec<u32> {
    let all = (0..).zip(&frame.instance).filter(|(_, id)| which(**id));
    all.map(|(pixel, _): (u32, _)| pixel / SIZE.0).collect()
}

fn done(home: &mut Environment, verb: Verb, thing: NodeId) -> bool {
    home.set_action(home.agents()[0], Action::with(verb, &[thing]).unwrap()).is_ok()
}

/// An agent that carries an object sees it below the middle of the picture, and sees past it.
#[test]
fn what_is_carried_is_in_view() {
    for seed in [3, 42] {
        let start = home(seed);
        let graph = start.graph();
        let on_it = |id: &NodeId| graph.place(*id).is_some_and(|p| p.relation == Relation::On);
        let carried = graph.nodes().filter(|n| n.affords(Property::Graspable)).map(|n| n.id()).filter(on_it);
        let mut count = 0;
        for id in carried.step_by(9) {
            let mut home = start.clone();
            if !(done(&mut home, Verb::Walk, id) && done(&mut home, Verb::Grab, id)) {
                continue;
            }
            let label = home.graph().label(id);
            let rows = rows(&seen(&home, Viewpoint::Agent(home.agents()[0])), |other| other == id);
            let pixels = SIZE.0 * SIZE.1;
            assert!(!rows.is_empty(), "{label} is not in view");
            assert!(rows.len() as u32 * 5 < pixels * 2, "{label} hides {} of {pixels} pixels", rows.len());
            let middle = rows.iter().sum::<u32>() as f32 / rows.len() as f32;
            assert!(middle > 0.5 * SIZE.1 as f32, "{label} is in row {middle}");
            count += 1;
        }
        assert!(count > 3, "{count} things were carried in home {seed}");
    }
}

/// An agent that opens a fridge or a wardrobe sees its contents.
#[test]
fn who_opens_something_sees_into_it() {
    for (seed, class) in
        [(55053, "fridge"), (61482, "fridge"), (98341, "fridge"), (7123, "wardrobe"), (98341, "wardrobe")]
    {
        let mut home = home(seed);
        let Some(&thing) = home.graph().of_class(class).first() else { continue };
        assert!(done(&mut home, Verb::Walk, thing) && done(&mut home, Verb::Open, thing), "{class} in {seed}");
        let frame = seen(&home, Viewpoint::Agent(home.agents()[0]));
        let graph = home.graph();
        let inside = rows(&frame, |id| id != thing && graph.rests_at(id, thing));
        assert!(!inside.is_empty(), "nothing in {class} of home {seed} is seen");
    }
}

/// Whoever has opened something sees it, however low it is, and who turns away from it looks ahead again.
#[test]
fn what_is_acted_on_is_in_view() {
    let mut count = 0;
    for class in ["nightstand", "dishwasher", "toilet", "trash_can", "drawer", "kitchen_cabinet", "sideboard"] {
        let mut home = home(42);
        let me = home.agents()[0];
        let Some(&thing) = home.graph().of_class(class).first() else { continue };
        if !(done(&mut home, Verb::Walk, thing) && done(&mut home, Verb::Open, thing)) {
            continue;
        }
        let all = rows(&seen(&home, Viewpoint::Agent(me)), |id| id == thing || home.graph().rests_at(id, thing));
        assert!(all.len() as u32 * 50 > SIZE.0 * SIZE.1, "{class}: {} pixels of it are seen", all.len());
        let way = |home: &Environment| home.camera(Viewpoint::Agent(me), SIZE.0, SIZE.1).unwrap().pose.rotation;
        let feet = home.world().pose(me).unwrap();
        let behind = feet * nalgebra::Point3::new(-1.0, 0.0, 0.0);
        let heading = (behind.y - feet.translation.y).atan2(behind.x - feet.translation.x);
        home.steer(me, &virtualcity::Steering { heading, ..Default::default() }).unwrap();
        let ahead = way(&home) * nalgebra::Vector3::z();
        assert!(ahead.z.abs() < 0.05, "{class}: the eyes look {ahead:?}");
        count += 1;
    }
    assert!(count > 3, "{count} things were opened");
}

/// An agent that enters a room looks into it, not at a wall.
#[test]
fn who_comes_into_a_room_faces_it() {
    for seed in [42, 7123] {
        let mut home = home(seed);
        let me = home.agents()[0];
        for room in home.graph().rooms().to_vec() {
            if home.teleport(me, room).is_err() {
                continue;
            }
            let frame = seen(&home, Viewpoint::Agent(me));
            let close = frame.depth.iter().filter(|d| **d < 0.8).count();
            let label = home.graph().label(room);
            assert!(close * 2 < frame.depth.len(), "{label} of home {seed}: {close} pixels are close");
        }
    }
}

/// Cameras in rooms look across the room: not steeply down, and not at something directly in front of them.
#[test]
fn cameras_in_rooms_look_over_them() {
    for seed in [12, 61482] {
        let home = home(seed);
        for room in home.graph().rooms() {
            let view = Viewpoint::Room(*room);
            let way = home.camera(view, SIZE.0, SIZE.1).unwrap().pose.rotation * Vector3::z();
            let label = home.graph().label(*room);
            assert!(way.z > -0.46, "{label} of home {seed} is looked at from above: {way:?}");
            let frame = seen(&home, view);
            let close = frame.depth.iter().filter(|d| **d < 0.6).count();
            assert!(close * 3 < frame.depth.len(), "{label} of home {seed}: {close} pixels are close");
        }
    }
}
