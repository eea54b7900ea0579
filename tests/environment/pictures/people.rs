//! Agents in pictures, with the objects they hold and wear.

use std::sync::LazyLock;

use nalgebra::Point3;
use vc_testkit::amount;
use virtualcity::graph::{Action, NodeId, Verb};
use virtualcity::render::{Camera, Frame, Modalities, Modality};
use virtualcity::{Environment, Viewpoint};

use super::{act, home};

/// A corner of a room in which an agent stands, holding a book in its right hand.
static HOLDING: LazyLock<(Environment, NodeId, NodeId, Camera)> = LazyLock::new(holding);

fn holding() -> (Environment, NodeId, NodeId, Camera) {
    let home = home(42, 2);
    let me = home.agents()[0];
    let taken = |book: NodeId| {
        let mut home = home.clone();
        let mut can = |verb| home.set_action(me, Action::one(verb, book)).is_ok();
        (can(Verb::Walk) && can(Verb::Grab)).then_some((home, book))
    };
    let (home, book) = home.graph().of_class("novel").iter().copied().find_map(taken).unwrap();
    // From the side with the fewest occluders.
    let feet = home.world().pose(me).unwrap();
    let cameras = (0..16).map(|i| {
        let (sin, cos) = (i as f32 * std::f32::consts::TAU / 16.0).sin_cos();
        let (eye, target) = (feet * Point3::new(1.3 * cos, 1.3 * sin, 1.5), feet * Point3::new(0.2, 0.0, 1.0));
        Camera::with_fov(160, 160, 1.1).looking(eye, target)
    });
    let seen = |camera: &Camera| {
        let frame = home.render(Viewpoint::Free(*camera), Modality::Instance, 160, 160).unwrap();
        let count = |id: NodeId| frame.instance.iter().filter(|seen| **seen == id).count();
        count(me).min(50 * count(book))
    };
    let camera = cameras.max_by_key(seen).unwrap();
    (home, me, book, camera)
}

/// Agents are visible in every modality, and so are held objects at the hand.
#[test]
fn agents_are_seen_in_every_modality() {
    let (mut home, me, book, camera) = HOLDING.clone();
    let view = Viewpoint::Free(camera);
    let before = home.clone();
    act(&mut home, me, Verb::Wave, &[]);
    let room = home.graph().room_of(me).unwrap();
    let away = home.graph().rooms().iter().copied().find(|r| *r != room).unwrap();
    let mut gone = home.clone();
    act(&mut gone, me, Verb::Walk, &[away]);
    let frame = before.render_until(&gone, view, Modalities::SIX, 160, 160).unwrap();
    let without = gone.render(view, Modality::Rgb | Modality::Depth, 160, 160).unwrap();
    let pixels = |id: NodeId| (0..frame.instance.len()).filter(|p| frame.instance[*p] == id).collect::<Vec<usize>>();
    let (body, held) = (pixels(me), pixels(book));
    assert!(body.len() > 800 && held.len() > 10, "{} and {} pixels", body.len(), held.len());
    // Its class, its depth in front of the room's, its colours, its flow out of the picture.
    let snapshot = home.snapshot().unwrap();
    let class = |id: NodeId| home.graph().node(id).unwrap().class().clone();
    let named = |p: &usize| snapshot.class(frame.class[*p]).cloned();
    assert!(body.iter().all(|p| named(p) == Some(class(me))) && held.iter().all(|p| named(p) == Some(class(book))));
    let nearer = body.iter().filter(|p| frame.depth[**p] < without.depth[**p]).count();
    assert!(nearer == body.len(), "{nearer} of {} pixels are before the room", body.len());
    let coloured = body.iter().filter(|p| frame.rgb[**p] != without.rgb[**p]).count();
    assert!(coloured * 10 > body.len() * 9, "{coloured} of {} pixels", body.len());
    // Flow to a point behind the camera is NaN.
    let stays = |p: &&usize| frame.flow_forward[**p].iter().all(|f| f.abs() < 1.0);
    assert_eq!(body.iter().filter(stays).count(), 0);
    // Its box and mask match those pixels.
    for (id, pixels) in [(me, &body), (book, &held)] {
        let found = frame.boxes.iter().find(|b| b.node == id).unwrap();
        assert_eq!(found.area as usize, pixels.len());
        let mask = frame.masks().find(|m| m.node() == id).unwrap();
        assert_eq!(mask.area() as usize, pixels.len());
    }
    // The hand is at the book: some of their pixels are neighbours.
    let beside = |p: &usize| [p.wrapping_sub(1), p + 1, p.wrapping_sub(160), p + 160];
    assert!(held.iter().any(|p| beside(p).iter().any(|n| frame.instance.get(*n) == Some(&me))));
}

/// Large held objects are in front of the body and not in it.
#[test]
fn what_is_held_is_not_in_the_body() {
    let (home, ..) = &*HOLDING;
    let me = home.agents()[1];
    let large = home.graph().nodes().filter(|n| n.affords(virtualcity::graph::Property::Graspable));
    let size = |id: NodeId| home.world().aabb(id).map(|b| (b.max - b.min).xy().norm());
    let mut large: Vec<(NodeId, f32)> = large.filter_map(|n| Some((n.id(), size(n.id())?))).collect();
    large.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut held = 0;
    for (id, _) in large.into_iter().take(40).step_by(amount(2, 1)) {
        let mut home = home.clone();
        let walked = home.set_action(me, Action::one(Verb::Walk, id)).is_ok();
        if !walked || home.set_action(me, Action::one(Verb::Grab, id)).is_err() {
            continue;
        }
        held += 1;
        let (feet, bounds) = (home.world().pose(me).unwrap(), home.world().aabb(id).unwrap());
        let axis = feet * Point3::new(0.0, 0.0, 1.0);
        let ahead = feet.inverse_transform_point(&bounds.centre()).x;
        // The world-aligned box is larger than the object if the agent stands askew.
        let off = (bounds.nearest(&axis) - axis).norm();
        assert!(off > 0.1 && ahead > 0.2, "{} is {off} m from the middle of the body", home.graph().label(id));
    }
    assert!(held > amount(2, 5), "{held} of forty large things can be held");
}

/// Clothes that an agent puts on are visible on its body, and no longer at their former place.
#[test]
fn clothes_are_worn() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let jacket = home.graph().of_class("jacket")[0];
    act(&mut home, me, Verb::Walk, &[jacket]);
    let bare = home.clone();
    act(&mut home, me, Verb::Grab, &[jacket]);
    act(&mut home, me, Verb::Wear, &[jacket]);
    let feet = home.world().pose(me).unwrap();
    let around = [(1.5, 0.9), (1.5, -0.9), (0.2, 1.7), (0.2, -1.7), (-1.5, 0.9), (-1.5, -0.9)];
    let cameras = around.map(|(x, y)| {
        Camera::with_fov(96, 96, 1.0).looking(feet * Point3::new(x, y, 1.4), feet * Point3::new(0.0, 0.0, 1.1))
    });
    let look = |home: &Environment, camera: &Camera| {
        home.render(Viewpoint::Free(*camera), Modality::Rgb | Modality::Instance, 96, 96).unwrap()
    };
    let seen = |frame: &Frame, id: NodeId| frame.instance.iter().filter(|i| **i == id).count();
    let best = cameras.iter().max_by_key(|camera| seen(&look(&home, camera), me)).unwrap();
    let [before, after] = [look(&bare, best), look(&home, best)];
    assert!(seen(&after, me) > 300);
    assert!(cameras.iter().all(|camera| seen(&look(&home, camera), jacket) == 0), "it is the wearer's");
    let changed = |(a, b): (&[u8; 3], &[u8; 3])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 30);
    let of_me = |i: &usize| before.instance[*i] == me && after.instance[*i] == me;
    let both: Vec<usize> = (0..before.instance.len()).filter(of_me).collect();
    let dyed = both.iter().filter(|i| changed((&before.rgb[**i], &after.rgb[**i]))).count();
    assert!(3 * dyed > both.len() && dyed < both.len(), "{dyed} of {} pixels", both.len());
}
