//! Pictures of generated homes show their contents.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod bounds;
mod cameras;
mod light;
mod people;
mod seen;
mod sensors;

use nalgebra::Vector3;
use virtualcity::graph::{NodeId, State, Verb};
use virtualcity::render::{Adaptation, Camera, Frame, Modality};
use virtualcity::{Environment, PictureOptions, Viewpoint};

use super::{act, fresh, home};

/// A camera in a room keeps its place whatever moves, and impossible picture sizes are refused.
#[test]
fn cameras_in_rooms_are_fixed() {
    let mut home = home(42, 1);
    let (me, room) = (home.agents()[0], home.graph().rooms()[0]);
    let table = home.graph().of_class("coffee_table")[0];
    let camera = |home: &Environment| home.camera(Viewpoint::Room(room), 64, 48).unwrap();
    let before = camera(&home);
    act(&mut home, me, Verb::Walk, &[table]);
    assert_eq!(before, camera(&home));
    // The same in an environment without earlier pictures.
    let mut other = fresh(42, 1);
    act(&mut other, me, Verb::Walk, &[table]);
    assert_eq!(before, camera(&other));
    // The options' lens is wider, and a robot's eyes are lower.
    let (eyes, options) = (home.camera(Viewpoint::Agent(me), 64, 48).unwrap(), *home.pictures());
    home.set_pictures(PictureOptions { field_of_view: 1.6, eye_height: Some(0.6), ..options });
    let (robot, wide) = (home.camera(Viewpoint::Agent(me), 64, 48).unwrap(), camera(&home));
    assert!(wide.focal.0 < before.focal.0 && wide.pose == before.pose);
    let (high, low) = (eyes.pose.translation.z, robot.pose.translation.z);
    assert!((0.5..0.7).contains(&low) && (1.4..1.8).contains(&high), "{low} {high}");
    home.set_pictures(PictureOptions { field_of_view: f32::NAN, ..options });
    assert!(home.render(Viewpoint::Agent(me), Modality::Depth, 64, 48).is_err());
    home.set_pictures(options);
    for (width, height) in [(0, 0), (1, u32::MAX), (u32::MAX, u32::MAX)] {
        assert!(home.render(Viewpoint::Room(room), Modality::Depth, width, height).is_err(), "{width} x {height}");
    }
}

/// A picture does not depend on earlier pictures.
#[test]
fn pictures_have_no_history() {
    // Two separate environments, since clones share what was computed for pictures.
    let (mut seen, mut unseen) = (home(42, 1), fresh(42, 1));
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

/// A camera above a room sees its floor and objects and no ceiling; a free camera shows the same at every size;
/// a node that is not an agent or a room has no camera.
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
    // Agents do not see their own heads.
    let (own, _) = seen(Viewpoint::Agent(me), 160, 120);
    assert!(own.instance.iter().filter(|id| **id == me).count() < own.instance.len() / 10);
}

/// An agent in front of a mirror is seen in it.
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

/// A dirty object looks dirty until it is washed.
#[test]
fn dirt_is_seen() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let table = home.graph().of_class("coffee_table")[0];
    act(&mut home, me, Verb::Walk, &[table]);
    let bounds = home.world().aabb(table).unwrap();
    let eye = bounds.centre() + Vector3::new(0.4, 0.3, 1.2);
    let view = Viewpoint::Free(Camera::with_fov(64, 48, 0.9).looking(eye, bounds.centre()));
    // All with the exposure of the first.
    let from = home.render(view, Modality::Rgb, 64, 48).unwrap().exposure;
    let brightness = |home: &Environment| {
        let frame = exposed(home, from).render(view, Modality::Rgb | Modality::Instance, 64, 48).unwrap();
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
    assert!(soiled * 20 < clean * 19, "{soiled} against {clean}");
    act(&mut home, me, Verb::Wash, &[table]);
    assert_eq!(brightness(&home), clean);
}

/// An environment whose pictures have a given exposure.
fn exposed(home: &Environment, from: [f32; 3]) -> Environment {
    let mut home = home.clone();
    home.set_pictures(PictureOptions { adapts: Some(Adaptation { from, share: 0.0 }), ..*home.pictures() });
    home
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
    let room = home.graph().room_of(screen).unwrap();
    let from = home.render(Viewpoint::Room(room), Modality::Rgb, 48, 36).unwrap().exposure;
    let colours = |home: &Environment| {
        let frame = exposed(home, from).render(view, Modality::Rgb, 48, 36).unwrap();
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

/// A room, its viewpoint's instances and depths.
fn from_viewpoint(seed: u64, class: &str) -> (Frame, f32) {
    use virtualcity::render::{NOTHING, Renderer, Shot};
    let scene = virtualcity::procgen::Apartment::from_seed(virtualcity::graph::Seed(seed)).unwrap().scene();
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene).unwrap();
    let view = renderer.viewpoint(&snapshot, scene.of_class(class)[0], &Camera::with_fov(120, 90, 1.15)).unwrap();
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &view, Modality::Instance | Modality::Depth), &mut frame).unwrap();
    let sky = frame.instance.iter().filter(|id| **id == NOTHING).count() as f32 / frame.instance.len() as f32;
    (frame, sky)
}

#[test]
fn viewpoints_are_not_beside_a_blank_wall() {
    for (seed, class) in [(92547, "kitchen"), (56320, "kitchen"), (56320, "bedroom")] {
        let (frame, _) = from_viewpoint(seed, class);
        let near = frame.instance.iter().zip(&frame.depth).filter(|(_, depth)| **depth < 1.5);
        let mut count = std::collections::BTreeMap::<NodeId, usize>::new();
        near.for_each(|(id, _)| *count.entry(*id).or_default() += 1);
        let most = count.into_values().max().unwrap_or(0) as f32 / frame.depth.len() as f32;
        assert!(most < 0.25, "{class} of {seed}: a near thing fills {most} of the picture");
    }
}

#[test]
fn viewpoints_on_balconies_look_outwards() {
    for seed in [56320, 67806] {
        let (_, sky) = from_viewpoint(seed, "balcony");
        assert!(sky > 0.05, "balcony of {seed}: the sky fills {sky} of the picture");
    }
}
