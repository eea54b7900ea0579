//! Pictures of generated homes show what is in them.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use virtualcity::graph::{
    Aabb, Action, Bounds, Draft, NodeId, Pose, Property, Relation, SceneBuilder, Seed, State, Verb,
};
use virtualcity::procgen::Apartment;
use virtualcity::render::{Adaptation, Camera, Daylight, Frame, Modalities, Modality, NOTHING, Renderer, Shot};
use virtualcity::{Environment, PictureOptions, Viewpoint};

/// The brightness that half of the pixels have, 0 to 255, of a view across each bathroom of a home
/// at noon, all ceiling lamps on.
fn bathrooms(seed: u64) -> Vec<u8> {
    let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    for lamp in scene.of_class("ceiling_lamp").iter().copied() {
        snapshot.switch(lamp, true).unwrap();
    }
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let rooms = scene.of_class("bathroom").to_vec().into_iter().filter_map(|room| scene.node(room)?.aabb());
    let view = |(low, high): (Point3<f32>, Point3<f32>)| {
        let eye = Point3::new(low.x + 0.3, low.y + 0.3, low.z + 1.6);
        let camera = Camera::with_fov(48, 36, 1.2).looking(eye, Point3::new(high.x, high.y, low.z + 0.8));
        let mut frame = Frame::new();
        let shot = Shot { lighting: Some(&lighting), ..Shot::new(&snapshot, &camera, Modality::Rgb) };
        renderer.render(&shot, &mut frame).unwrap();
        let mut levels: Vec<u8> = frame.rgb.iter().map(|c| c.iter().copied().max().unwrap_or(0)).collect();
        levels.sort_unstable();
        levels[levels.len() / 2]
    };
    rooms.map(|b| view((b.min, b.max))).collect()
}

#[test]
fn rooms_without_windows_are_exposed_for_their_lamps() {
    // Some lie within the box of a hall with corners, beside a living room full of sun.
    for seed in [3, 7, 12] {
        for level in bathrooms(seed) {
            assert!((30..=245).contains(&level), "home {seed}: half of a bathroom's picture is below {level}");
        }
    }
}

fn home(seed: u64, agents: usize) -> Environment {
    Environment::make(&format!("apartment/{seed}"), agents).unwrap()
}

fn act(home: &mut Environment, agent: NodeId, verb: Verb, things: &[NodeId]) {
    home.set_action(agent, Action::with(verb, things).unwrap()).unwrap();
}

/// A camera in a room stays where it is whatever moves, and what cannot be a picture is refused.
#[test]
fn cameras_in_rooms_are_fixed() {
    let mut home = home(42, 1);
    let (me, room) = (home.agents()[0], home.graph().rooms()[0]);
    let table = home.graph().of_class("coffee_table")[0];
    let camera = |home: &Environment| home.camera(Viewpoint::Room(room), 64, 48).unwrap();
    let before = camera(&home);
    act(&mut home, me, Verb::Walk, &[table]);
    assert_eq!(before, camera(&home));
    // The same in an environment in which nothing was looked at before.
    let mut other = Environment::make("apartment/42", 1).unwrap();
    act(&mut other, me, Verb::Walk, &[table]);
    assert_eq!(before, camera(&other));
    for (width, height) in [(0, 0), (1, u32::MAX), (u32::MAX, u32::MAX)] {
        assert!(home.render(Viewpoint::Room(room), Modality::Depth, width, height).is_err(), "{width} x {height}");
    }
}

/// What is rendered now does not depend on what was rendered before.
#[test]
fn pictures_have_no_history() {
    // Two of their own: clones share what was made for pictures.
    let (mut seen, mut unseen) = (home(42, 1), home(42, 1));
    let (me, table) = (seen.agents()[0], seen.graph().of_class("coffee_table")[0]);
    let door = seen.graph().of_class("door")[0];
    let picture = |home: &Environment| home.render(Viewpoint::Overhead, Modality::Rgb, 96, 72).unwrap().rgb;
    let mut pictures = vec![picture(&seen)];
    for (verb, thing) in [(Verb::Walk, table), (Verb::Walk, door), (Verb::Open, door), (Verb::Close, door)] {
        act(&mut seen, me, verb, &[thing]);
        act(&mut unseen, me, verb, &[thing]);
        pictures.push(picture(&seen));
    }
    assert!(picture(&unseen) == pictures[4]);
    assert!(pictures[3] != pictures[4], "an open door is seen");
}

/// A corner of a room in which an agent stands, holding a book in its right hand.
fn holding() -> (Environment, NodeId, NodeId, Camera) {
    let home = home(42, 2);
    let me = home.agents()[0];
    let taken = |book: NodeId| {
        let mut home = home.clone();
        let mut can = |verb| home.set_action(me, Action::one(verb, book)).is_ok();
        (can(Verb::Walk) && can(Verb::Grab)).then_some((home, book))
    };
    let (home, book) = home.graph().of_class("novel").iter().copied().find_map(taken).unwrap();
    // From the side on which least is in the way.
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

/// Agents are seen in every modality, and so is what they hold, where the hand is.
#[test]
fn agents_are_seen_in_every_modality() {
    let (mut home, me, book, camera) = holding();
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
    // Its class, its depth before the room's, its colours, its way out of the picture.
    let snapshot = home.snapshot().unwrap();
    let class = |id: NodeId| home.graph().node(id).unwrap().class().clone();
    let named = |p: &usize| snapshot.class(frame.class[*p]).cloned();
    assert!(body.iter().all(|p| named(p) == Some(class(me))) && held.iter().all(|p| named(p) == Some(class(book))));
    let nearer = body.iter().filter(|p| frame.depth[**p] < without.depth[**p]).count();
    assert!(nearer == body.len(), "{nearer} of {} pixels are before the room", body.len());
    let coloured = body.iter().filter(|p| frame.rgb[**p] != without.rgb[**p]).count();
    assert!(coloured * 10 > body.len() * 9, "{coloured} of {} pixels", body.len());
    // Flow to behind the camera is no number.
    let stays = |p: &&usize| frame.flow_forward[**p].iter().all(|f| f.abs() < 1.0);
    assert_eq!(body.iter().filter(stays).count(), 0);
    // Its box and mask are those pixels'.
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

/// What large things one holds are before the body and not in it.
#[test]
fn what_is_held_is_not_in_the_body() {
    let (home, ..) = holding();
    let me = home.agents()[1];
    let large = home.graph().nodes().filter(|n| n.affords(virtualcity::graph::Property::Graspable));
    let size = |id: NodeId| home.world().aabb(id).map(|b| (b.max - b.min).xy().norm());
    let mut large: Vec<(NodeId, f32)> = large.filter_map(|n| Some((n.id(), size(n.id())?))).collect();
    large.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut held = 0;
    for (id, _) in large.into_iter().take(40) {
        let mut home = home.clone();
        let walked = home.set_action(me, Action::one(Verb::Walk, id)).is_ok();
        if !walked || home.set_action(me, Action::one(Verb::Grab, id)).is_err() {
            continue;
        }
        held += 1;
        let (feet, bounds) = (home.world().pose(me).unwrap(), home.world().aabb(id).unwrap());
        let axis = feet * Point3::new(0.0, 0.0, 1.0);
        let ahead = feet.inverse_transform_point(&bounds.centre()).x;
        // The box along the world's axes is larger than the thing where the agent stands askew.
        let off = (bounds.nearest(&axis) - axis).norm();
        assert!(off > 0.1 && ahead > 0.2, "{} is {off} m from the middle of the body", home.graph().label(id));
    }
    assert!(held > 5, "{held} of forty large things can be held");
}

/// Above a room one sees its floor and things and no ceiling; a camera of one's own shows the same
/// at every size; what is no agent or room has no camera.
#[test]
fn cameras_are_anywhere() {
    let home = home(42, 1);
    let me = home.agents()[0];
    let room = home.graph().room_of(me).unwrap();
    let seen = |view: Viewpoint, width: u32, height: u32| {
        let frame = home.render(view, Modality::Instance, width, height).unwrap();
        let mut all: Vec<NodeId> = frame.instance.clone();
        all.sort_unstable();
        all.dedup();
        (frame, all)
    };
    let (_, above) = seen(Viewpoint::Above(room), 160, 120);
    let things = |all: &[NodeId]| all.iter().filter(|id| home.graph().room_of(**id) == Some(room)).count();
    assert!(above.contains(&me) && things(&above) > 10, "{above:?}");
    assert!(above.iter().all(|id| home.graph().node(*id).is_none_or(|n| &**n.class() != "ceiling")));
    let (_, all) = seen(Viewpoint::Overhead, 240, 180);
    assert!(all.len() > above.len());
    let camera = home.camera(Viewpoint::Agent(me), 128, 96).unwrap();
    let (large, small) = (seen(Viewpoint::Free(camera), 128, 96).0, seen(Viewpoint::Free(camera), 64, 48).0);
    let at = |frame: &Frame, x: usize, y: usize| frame.instance[y * frame.width + x];
    let same = (0..64 * 48).filter(|i| at(&small, i % 64, i / 64) == at(&large, 2 * (i % 64), 2 * (i / 64))).count();
    assert!(same * 10 > 64 * 48 * 9, "{same} of {} pixels", 64 * 48);
    for nobody in [Viewpoint::Agent(NodeId(9999)), Viewpoint::Room(me), Viewpoint::Above(NodeId(9999))] {
        assert!(home.render(nobody, Modality::Depth, 16, 16).is_err(), "{nobody:?}");
    }
    assert!(home.render(Viewpoint::Agent(me), Modality::FlowForward, 16, 16).is_err());
    // One does not see one's own head.
    let (own, _) = seen(Viewpoint::Agent(me), 160, 120);
    assert!(own.instance.iter().filter(|id| **id == me).count() < own.instance.len() / 10);
}

/// Who steps before a mirror is seen in it.
#[test]
fn mirrors_show_the_home_as_it_is() {
    let mut home = home(8, 1);
    let me = home.agents()[0];
    let mut seen = 0;
    for mirror in home.graph().of_class("mirror").to_vec() {
        let away = home.clone();
        act(&mut home, me, Verb::Walk, &[mirror]);
        let (at, facing) = (home.world().aabb(mirror).unwrap().centre(), home.world().pose(mirror).unwrap().rotation);
        for side in [-1.2_f32, -0.8, -0.4, 0.0, 0.4, 0.8, 1.2] {
            let eye = at + facing * Vector3::new(1.1, side, 0.1);
            let view = Viewpoint::Free(Camera::with_fov(96, 72, 1.0).looking(eye, at));
            let picture = |home: &Environment| home.render(view, Modality::Rgb | Modality::Instance, 96, 72).unwrap();
            let (before, now) = (picture(&away), picture(&home));
            let within = |p: &usize| now.instance[*p] == mirror && before.instance[*p] == mirror;
            seen += (0..96 * 72).filter(within).filter(|p| before.rgb[*p] != now.rgb[*p]).count();
        }
    }
    assert!(seen > 50, "in {seen} pixels of mirrors somebody is seen");
}

/// What is dirty looks so, until it is washed.
#[test]
fn dirt_is_seen() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let table = home.graph().of_class("coffee_table")[0];
    act(&mut home, me, Verb::Walk, &[table]);
    let bounds = home.world().aabb(table).unwrap();
    let eye = bounds.centre() + Vector3::new(0.4, 0.3, 1.2);
    let view = Viewpoint::Free(Camera::with_fov(64, 48, 0.9).looking(eye, bounds.centre()));
    let brightness = |home: &Environment| {
        let frame = home.render(view, Modality::Rgb | Modality::Instance, 64, 48).unwrap();
        let pixels = (0..64 * 48).filter(|p| frame.instance[*p] == table);
        pixels.map(|p| frame.rgb[p].iter().map(|c| u32::from(*c)).sum::<u32>()).sum::<u32>()
    };
    let clean = brightness(&home);
    let mut dirty = home.graph().clone();
    let mut edit = dirty.edit();
    edit.enter_state(table, State::Dirty).unwrap();
    edit.commit();
    home.reset(&dirty).unwrap();
    let soiled = brightness(&home);
    assert!(soiled * 10 < clean * 9, "{soiled} against {clean}");
    act(&mut home, me, Verb::Wash, &[table]);
    assert_eq!(brightness(&home), clean);
}

/// What somebody puts on is seen on the body, and no more where it was.
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

/// What covers a window, and a camera in its room that looks at it.
fn covered(home: &Environment) -> (NodeId, Camera) {
    let graph = home.graph();
    let cover = [graph.of_class("blinds"), graph.of_class("curtain")].concat()[0];
    let room = graph.node(graph.room_of(cover).unwrap()).unwrap().aabb().unwrap();
    let at = graph.node(cover).unwrap().aabb().unwrap().centre();
    let eye = Point3::new(room.centre().x, room.centre().y, room.min.z + 1.7);
    (cover, Camera::with_fov(96, 72, 1.3).looking(eye, at))
}

/// A blind or curtain that is closed is seen over its window, and the light knows; opened again all is as it was.
#[test]
fn covers_are_drawn_and_light_follows() {
    let mut home = home(42, 1);
    let (cover, camera) = covered(&home);
    let me = home.agents()[0];
    let look = |home: &Environment| {
        home.render(Viewpoint::Free(camera), Modality::Rgb | Modality::Instance | Modality::Depth, 96, 72)
    };
    let bright = |frame: &Frame| frame.rgb.as_flattened().iter().map(|v| u64::from(*v)).sum::<u64>();
    let seen = |frame: &Frame| frame.instance.iter().filter(|id| **id == cover).count();
    act(&mut home, me, Verb::Walk, &[cover]);
    let open = look(&home).unwrap();
    let aside = home.clone();
    act(&mut home, me, Verb::Close, &[cover]);
    let closed = look(&home).unwrap();
    assert!(seen(&closed) > 2 * seen(&open).max(20), "{} pixels, then {}", seen(&open), seen(&closed));
    assert_ne!(bright(&closed), bright(&open));
    // It does not matter what was looked at before.
    let mut other = Environment::make("apartment/42", 1).unwrap();
    act(&mut other, me, Verb::Walk, &[cover]);
    act(&mut other, me, Verb::Close, &[cover]);
    let fresh = look(&other).unwrap();
    assert!(fresh.rgb == closed.rgb && fresh.instance == closed.instance);
    let again = look(&aside).unwrap();
    assert!(again.rgb == open.rgb && again.depth == open.depth);
}

/// Switches all lamps on, at an hour.
fn lit(seed: u64, hour: f32) -> Environment {
    let mut home = home(seed, 1);
    home.set_pictures(PictureOptions { daylight: Daylight::at(hour), ..PictureOptions::default() });
    let mut graph = home.graph().clone();
    let lamps: Vec<NodeId> = graph.of_class("ceiling_lamp").to_vec();
    let mut edit = graph.edit();
    lamps.into_iter().for_each(|lamp| edit.enter_state(lamp, State::On).unwrap());
    edit.commit();
    home.reset(&graph).unwrap();
    home
}

/// By how much the colours of some pixels differ on average, and the share of them that differ much.
fn difference(a: &Frame, b: &Frame, which: impl Fn(usize) -> bool) -> (f32, f32) {
    let same = |i: &usize| a.instance[*i] == b.instance[*i] && which(*i);
    let off = |i: usize| a.rgb[i].iter().zip(b.rgb[i]).map(|(a, b)| f32::from(a.abs_diff(b))).fold(0.0, f32::max);
    let all: Vec<f32> = (0..a.rgb.len()).filter(same).map(off).collect();
    let count = all.len().max(1) as f32;
    (all.iter().sum::<f32>() / count, all.iter().filter(|off| **off > 40.0).count() as f32 / count)
}

/// A person that opens, takes and carries things through rooms, and the things, look as if the light had been made for
/// the moment, and as in a home that begins like that.
#[test]
fn what_has_moved_is_lit_where_it_is() {
    let wanted = Modality::Rgb | Modality::Instance;
    for (hour, lamps) in [(12.0, false), (19.0, true), (23.0, true)] {
        let mut home = if lamps { lit(42, hour) } else { home(42, 1) };
        let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
        let kitchen = home.graph().room_of(fridge).unwrap();
        act(&mut home, me, Verb::Walk, &[fridge]);
        act(&mut home, me, Verb::Open, &[fridge]);
        let inside = home.graph().relating(Relation::Inside, fridge);
        let graspable = |id: &NodeId| home.graph().node(*id).is_some_and(|n| n.affords(Property::Graspable));
        let thing =
            inside.filter(graspable).find(|id| home.clone().set_action(me, Action::one(Verb::Grab, *id)).is_ok());
        let thing = thing.unwrap();
        act(&mut home, me, Verb::Grab, &[thing]);
        let table = home.graph().of_class("coffee_table")[0];
        let mut moments = vec![(home.clone(), kitchen)];
        act(&mut home, me, Verb::Walk, &[table]);
        let room = home.graph().room_of(table).unwrap();
        moments.push((home.clone(), room));
        act(&mut home, me, Verb::Place, &[thing, table]);
        moments.push((home.clone(), room));
        for (at, (home, room)) in moments.iter().enumerate() {
            for view in [Viewpoint::Room(*room), Viewpoint::Agent(me)].into_iter().take(2 - at.min(1)) {
                let now = home.render(view, wanted, 160, 120).unwrap();
                let anew = home.render_relit(view, wanted, 160, 120).unwrap();
                let (mean, much) = difference(&now, &anew, |_| true);
                let moved = |i: usize| [me, thing, fridge].contains(&now.instance[i]);
                let own = difference(&now, &anew, moved);
                assert!(mean < 16.0 && much < 0.03 && own.0 < 25.0, "{hour}, {at}, {view:?}: {mean}, {much}, {own:?}");
            }
        }
        let mut fresh = Environment::of(home.graph().clone(), 1).unwrap();
        fresh.set_pictures(*home.pictures());
        let camera = Viewpoint::Free(home.camera(Viewpoint::Room(room), 160, 120).unwrap());
        let [now, begun] = [&home, &fresh].map(|home| home.render(camera, wanted, 160, 120).unwrap());
        let off = difference(&now, &begun, |_| true);
        assert!(off.0 < 6.0 && off.1 < 0.02, "{hour}: {off:?} from a home that begins like that");
    }
}

/// From above no room burns out, and none is dark.
#[test]
fn plans_show_all_rooms() {
    for seed in [7, 42] {
        let home = home(seed, 1);
        let frame = home.render(Viewpoint::Overhead, Modality::Rgb | Modality::Instance, 240, 180).unwrap();
        for room in home.graph().rooms() {
            let own = |i: &usize| home.graph().room_of(frame.instance[*i]) == Some(*room);
            let floor = |i: &usize| home.graph().node(frame.instance[*i]).is_some_and(|n| &**n.class() == "floor");
            let level = |i: usize| frame.rgb[i].iter().copied().max().unwrap_or(0);
            let mut levels: Vec<u8> = (0..frame.rgb.len()).filter(own).filter(floor).map(level).collect();
            levels.sort_unstable();
            let Some(middle) = levels.get(levels.len() / 2) else { continue };
            assert!((25..=235).contains(middle), "{}: half of its floor is below {middle}", home.graph().label(*room));
        }
    }
}

/// A camera that goes through a door gets used to the other room as it comes into view, and not at once.
#[test]
fn exposure_does_not_jump_in_doors() {
    let mut home = home(42, 1);
    let [kitchen, living] = ["kitchen", "living_room"].map(|class| home.graph().of_class(class)[0]);
    let way = home.graph().of_class("door").into_iter().chain(home.graph().of_class("sliding_door"));
    let between = |door: &NodeId| {
        let rooms: Vec<NodeId> = home.graph().related(*door, Relation::Between).collect();
        rooms.contains(&kitchen) && rooms.contains(&living)
    };
    let door = way.into_iter().find(between).unwrap();
    let me = home.agents()[0];
    act(&mut home, me, Verb::Walk, &[door]);
    if !home.graph().node(door).unwrap().is(State::Open) {
        act(&mut home, me, Verb::Open, &[door]);
    }
    let pose = *home.graph().node(door).unwrap().pose().unwrap();
    let exposure = |i: i32| {
        let eye = pose * Point3::new(0.02 * i as f32, 0.0, 0.0);
        let eye = Point3::new(eye.x, eye.y, 1.6);
        let camera = Camera::with_fov(96, 72, 1.15).looking(eye, eye + pose.rotation * Vector3::x());
        home.render(Viewpoint::Free(camera), Modality::Rgb, 96, 72).unwrap().exposure[1]
    };
    let all: Vec<f32> = (-40..40).map(exposure).collect();
    let step = all.windows(2).map(|pair| (pair[1] / pair[0]).max(pair[0] / pair[1])).fold(1.0, f32::max);
    // The kitchen is thirty times darker.
    assert!(step < 1.5, "in two centimetres the exposure changes by {step}");
    // An eye that comes from other light is used to that, or halfway, or to the light it sees.
    let (own, from) = (home.render(Viewpoint::Room(living), Modality::Rgb, 64, 48).unwrap().exposure, [8.0; 3]);
    for (at, share) in [0.0, 0.5, 1.0].into_iter().enumerate() {
        home.set_pictures(PictureOptions { adapts: Some(Adaptation { from, share }), ..PictureOptions::default() });
        let made = home.render(Viewpoint::Room(living), Modality::Rgb, 64, 48).unwrap().exposure;
        let wanted = own.map(|own: f32| [8.0, (8.0 * own).sqrt(), own][at]);
        assert!(
            made.iter().zip(wanted).all(|(made, wanted)| (made / wanted - 1.0).abs() < 1e-3),
            "{made:?} {wanted:?}"
        );
    }
}

/// Screens that are off are black, in pictures and as glTF; exported rotations have unit length.
#[test]
fn screens_that_are_off_are_dark() {
    let mut home = home(42, 1);
    let (me, screen) = (home.agents()[0], home.graph().of_class("television")[0]);
    act(&mut home, me, Verb::Walk, &[screen]);
    let middle = home.world().aabb(screen).unwrap().centre();
    let out = home.graph().node(screen).unwrap().pose().unwrap().rotation * Vector3::x();
    let view = Viewpoint::Free(Camera::with_fov(48, 36, 0.5).looking(middle + 1.2 * out, middle));
    let colours = |home: &Environment| {
        let frame = home.render(view, Modality::Rgb, 48, 36).unwrap();
        let middle = |i: &usize| (12..36).contains(&(i % 48)) && (9..27).contains(&(i / 48));
        (0..48 * 36).filter(middle).map(|i| frame.rgb[i]).collect::<Vec<[u8; 3]>>()
    };
    let spread =
        |colours: &[[u8; 3]]| colours.iter().flatten().map(|v| u32::from(*v)).sum::<u32>() / colours.len() as u32;
    let off = colours(&home);
    let glowing = |home: &Environment| {
        let json = document(&home.gltf().unwrap());
        let turns = json["nodes"].as_array().unwrap().iter().filter_map(|node| node["rotation"].as_array());
        for turn in turns {
            let parts: Vec<f32> = turn.iter().map(|v| v.as_f64().unwrap() as f32).collect();
            let norm = parts.iter().map(|v| f64::from(*v).powi(2)).sum::<f64>().sqrt();
            assert!(parts.iter().all(|v| v.abs() <= 1.0) && (norm - 1.0).abs() < 1e-6, "{parts:?}");
        }
        json["materials"].as_array().unwrap().iter().filter(|m| m.get("emissiveFactor").is_some()).count()
    };
    let dark = glowing(&home);
    act(&mut home, me, Verb::SwitchOn, &[screen]);
    let on = colours(&home);
    assert!(spread(&off) < 240 && spread(&on) > 2 * spread(&off), "{} off, {} on", spread(&off), spread(&on));
    assert!(glowing(&home) > dark, "{dark} materials glow");
}

/// The JSON of a binary glTF file.
fn document(bytes: &[u8]) -> serde_json::Value {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

/// Outer walls are in the light outside, whatever room is behind them, and at night the sky is darker than walls by
/// lamplight.
#[test]
fn outside_has_its_own_light() {
    let home = home(7, 1);
    let outdoors = |home: &Environment, turn: f32| {
        let boxes = home.graph().rooms().iter().filter_map(|room| home.graph().node(*room)?.aabb());
        let all = boxes.reduce(|a, b| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) }).unwrap();
        let (middle, way) =
            (all.centre(), nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), turn) * Vector3::x());
        let eye = middle + way * 14.0;
        home.render(
            Viewpoint::Free(Camera::with_fov(96, 72, 0.9).looking(eye, middle)),
            Modality::Rgb | Modality::Instance,
            96,
            72,
        )
        .unwrap()
    };
    let walls = |frame: &Frame| {
        let wall = |i: &usize| home.graph().node(frame.instance[*i]).is_some_and(|n| &**n.class() == "wall");
        let level = |i: usize| *frame.rgb[i].iter().max().unwrap();
        let mut levels: Vec<u8> = (0..frame.rgb.len()).filter(wall).map(level).collect();
        levels.sort_unstable();
        (levels[levels.len() / 10], levels[levels.len() / 2], levels[levels.len() * 9 / 10])
    };
    for turn in [0.7, 2.3, 3.9, 5.4] {
        let seen = walls(&outdoors(&home, turn));
        assert!(seen.0 > 60, "{turn}: a tenth of the outer walls is below {}", seen.0);
    }
    let night = lit(7, 23.0);
    let frame = outdoors(&night, 0.7);
    let sky = (0..frame.rgb.len()).filter(|i| frame.instance[*i] == NOTHING && i / 96 < 20);
    let sky = sky.map(|i| *frame.rgb[i].iter().max().unwrap()).max().unwrap();
    assert!(sky < 80, "the night's sky is as bright as {sky}");
}

/// The things that are drawn out of their boxes by more than a centimetre in a home as it begins; elbows may be by
/// three.
fn drawn_out(seed: u64) -> Vec<String> {
    let home = home(seed, 1);
    let snapshot = home.snapshot().unwrap();
    let off = |id: NodeId| {
        let node = home.graph().node(id)?;
        let (own, drawn) = (node.aabb()?, snapshot.bounds(id)?);
        let out = (own.min - drawn.min).sup(&(drawn.max - own.max)).max();
        let slack = if home.agents().contains(&id) { 0.03 } else { 0.01 };
        (out > slack).then(|| format!("home {seed}: {} is drawn {out} m out of its box", node.label()))
    };
    snapshot.nodes().filter_map(off).collect()
}

#[test]
fn things_are_drawn_within_their_boxes() {
    let all: Vec<String> = [3, 8, 42].into_par_iter().flat_map_iter(drawn_out).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// The same for many homes: `proofs/drawn_bounds`.
#[test]
#[ignore = "takes minutes; proofs/drawn_bounds runs it for ten homes at a time"]
fn things_are_drawn_within_their_boxes_in_many_homes() {
    let range = std::env::var("VC_HOMES").unwrap_or_else(|_| "0..200".into());
    let (from, to) = range.split_once("..").unwrap();
    let homes = from.parse::<u64>().unwrap()..to.parse().unwrap();
    let all: Vec<String> = homes.into_par_iter().flat_map_iter(drawn_out).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// Boxes, umbrellas and bags before a window are covers, but no curtains.
#[test]
fn lids_are_no_curtains() {
    let mut scene = SceneBuilder::new("study");
    let window = Draft::new("window").bounds(Bounds::standing([0.1, 1.2, 1.4].into()));
    scene.add(window.at(Pose::translation(0.0, 0.0, 0.9))).unwrap();
    let names = ["box", "umbrella", "bag", "curtain"];
    let things = names.map(|class| {
        let bounds = Bounds::standing([0.1, 0.3, 0.4].into());
        scene.add(Draft::new(class).bounds(bounds).at(Pose::translation(0.12, 0.3, 1.2)).state(State::Closed)).unwrap()
    });
    let snapshot = Renderer::new().snapshot(&scene.build()).unwrap();
    for (class, thing) in names.into_iter().zip(things) {
        let drawn = snapshot.bounds(thing).unwrap();
        let wide = drawn.max.y - drawn.min.y;
        assert_eq!(wide > 0.31, class == "curtain", "{class} is {wide} m wide");
    }
}

/// Light that is made anew has the shadow of who has walked where that is now; labels are the same.
#[test]
fn light_can_be_made_of_what_has_moved() {
    let mut home = home(42, 1);
    let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
    let room = home.graph().room_of(table).unwrap();
    act(&mut home, me, Verb::Walk, &[table]);
    let wanted = Modality::Rgb | Modality::Instance;
    let usual = home.render(Viewpoint::Room(room), wanted, 64, 48).unwrap();
    let anew = home.render_relit(Viewpoint::Room(room), wanted, 64, 48).unwrap();
    assert!(usual.instance == anew.instance && usual.rgb != anew.rgb);
    assert!(home.render_relit(Viewpoint::Room(room), wanted, 64, 48).unwrap().rgb == anew.rgb);
    assert!(home.render(Viewpoint::Room(room), wanted, 64, 48).unwrap().rgb == usual.rgb, "nothing is kept");
}

/// Lamps that people switch on in the evening light a home that is dark without them.
#[test]
fn lamps_are_on_in_the_evening() {
    let mut home = home(7, 1);
    home.set_pictures(PictureOptions { daylight: Daylight::at(23.0), ..PictureOptions::default() });
    let view = Viewpoint::Room(home.graph().of_class("living_room")[0]);
    let level = |home: &Environment| home.render(view, Modality::Rgb, 64, 48).unwrap().exposure[1];
    let dark = level(&home);
    let lamps = home.switch_lamps(true).unwrap();
    assert!(lamps.iter().all(|id| home.graph().node(*id).is_some_and(|n| n.is(State::On))));
    assert!(lamps.len() >= home.graph().rooms().len() / 2 && home.switch_lamps(true).unwrap().is_empty());
    assert!(level(&home) < 0.1 * dark, "the eye opens {} times as wide, {dark} without lamps", level(&home));
    // Lamps are switched by hand as ever.
    let (me, lamp) = (home.agents()[0], lamps[0]);
    act(&mut home, me, Verb::Walk, &[lamp]);
    act(&mut home, me, Verb::SwitchOff, &[lamp]);
    assert!(home.graph().node(lamp).is_some_and(|n| !n.is(State::On)));
}
