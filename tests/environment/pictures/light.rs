//! Lighting and exposure: in rooms, at windows, outside, and where objects have moved.

use nalgebra::{Point3, Vector3};
use virtualcity::graph::{Aabb, Action, NodeId, Property, Relation, Seed, State, Verb};
use virtualcity::procgen::Apartment;
use virtualcity::render::{Adaptation, Camera, Daylight, Frame, Modality, NOTHING, Renderer, Shot};
use virtualcity::{Environment, PictureOptions, Viewpoint};

use super::{act, fresh, home};

/// The median brightness, 0 to 255, of a view across each bathroom of a home at noon with all ceiling lamps on.
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
    // Some lie within the box of an L-shaped hall, beside a sunlit living room.
    for seed in [3, 7, 12] {
        for level in bathrooms(seed) {
            assert!((30..=245).contains(&level), "home {seed}: half of a bathroom's picture is below {level}");
        }
    }
}

/// A blind or curtain at a window, and a camera in its room that faces it.
fn covered(home: &Environment) -> (NodeId, Camera) {
    let graph = home.graph();
    let cover = [graph.of_class("blinds"), graph.of_class("curtain")].concat()[0];
    let room = graph.node(graph.room_of(cover).unwrap()).unwrap().aabb().unwrap();
    let at = graph.node(cover).unwrap().aabb().unwrap().centre();
    let eye = Point3::new(room.centre().x, room.centre().y, room.min.z + 1.7);
    (cover, Camera::with_fov(96, 72, 1.3).looking(eye, at))
}

/// A closed blind or curtain is visible over its window and changes the lighting; opened again, everything is
/// as before.
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
    // Earlier pictures make no difference.
    let mut other = fresh(42, 1);
    act(&mut other, me, Verb::Walk, &[cover]);
    act(&mut other, me, Verb::Close, &[cover]);
    let fresh = look(&other).unwrap();
    assert!(fresh.rgb == closed.rgb && fresh.instance == closed.instance);
    let again = look(&aside).unwrap();
    assert!(again.rgb == open.rgb && again.depth == open.depth);
}

/// A home with all lamps on, at an hour.
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

/// The mean difference of the colours of some pixels, and the fraction that differ much.
fn difference(a: &Frame, b: &Frame, which: impl Fn(usize) -> bool) -> (f32, f32) {
    let same = |i: &usize| a.instance[*i] == b.instance[*i] && which(*i);
    let off = |i: usize| a.rgb[i].iter().zip(b.rgb[i]).map(|(a, b)| f32::from(a.abs_diff(b))).fold(0.0, f32::max);
    let all: Vec<f32> = (0..a.rgb.len()).filter(same).map(off).collect();
    let count = all.len().max(1) as f32;
    (all.iter().sum::<f32>() / count, all.iter().filter(|off| **off > 40.0).count() as f32 / count)
}

/// A person that opens, takes and carries objects through rooms, and the objects themselves, look as if the
/// lighting had been computed for that moment, and as in a home with that initial state.
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
        // In lamplight, how it ends is enough.
        for (at, (home, room)) in moments.iter().enumerate().skip(if lamps { 2 } else { 0 }) {
            for view in [Viewpoint::Room(*room), Viewpoint::Agent(me)].into_iter().take(2 - at.min(1)) {
                let now = home.render(view, wanted, 160, 120).unwrap();
                let anew = home.render_relit(view, wanted, 160, 120).unwrap();
                let (mean, much) = difference(&now, &anew, |_| true);
                let moved = |i: usize| [me, thing, fridge].contains(&now.instance[i]);
                let own = difference(&now, &anew, moved);
                // The eyes look directly into the fridge, whose inside keeps the lighting computed while it was
                // closed.
                let (most, own_most) =
                    if at == 0 && view == Viewpoint::Agent(me) { (22.0, 28.0) } else { (16.0, 25.0) };
                assert!(
                    mean < most && much < 0.03 && own.0 < own_most,
                    "{hour}, {at}, {view:?}: {mean}, {much}, {own:?}"
                );
            }
        }
        let mut fresh = Environment::from_scene(home.graph().clone(), 1).unwrap();
        fresh.set_pictures(*home.pictures());
        let camera = Viewpoint::Free(home.camera(Viewpoint::Room(room), 160, 120).unwrap());
        let [now, begun] = [&home, &fresh].map(|home| home.render(camera, wanted, 160, 120).unwrap());
        let off = difference(&now, &begun, |_| true);
        assert!(off.0 < 6.0 && off.1 < 0.02, "{hour}: {off:?} from a home that begins like that");
    }
}

/// From above no room is overexposed, and none is dark.
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

/// A camera that moves through a door adapts to the other room as it comes into view, and not at once.
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
        let camera = Camera::with_fov(48, 36, 1.15).looking(eye, eye + pose.rotation * Vector3::x());
        home.render(Viewpoint::Free(camera), Modality::Rgb, 48, 36).unwrap().exposure[1]
    };
    let all: Vec<f32> = (-40..40).map(exposure).collect();
    let step = all.windows(2).map(|pair| (pair[1] / pair[0]).max(pair[0] / pair[1])).fold(1.0, f32::max);
    // The kitchen is thirty times darker.
    assert!(step < 1.5, "in two centimetres the exposure changes by {step}");
    // An eye coming from four times as much light is adapted to that, or halfway, or to the light it sees.
    let own = home.render(Viewpoint::Room(living), Modality::Rgb, 64, 48).unwrap().exposure;
    let from = own.map(|own: f32| own / 4.0);
    for (at, share) in [0.0, 0.5, 1.0].into_iter().enumerate() {
        home.set_pictures(PictureOptions { adapts: Some(Adaptation { from, share }), ..PictureOptions::default() });
        let made = home.render(Viewpoint::Room(living), Modality::Rgb, 64, 48).unwrap().exposure;
        let wanted = own.map(|own: f32| own / [4.0, 2.0, 1.0][at]);
        assert!(
            made.iter().zip(wanted).all(|(made, wanted)| (made / wanted - 1.0).abs() < 1e-3),
            "{made:?} {wanted:?}"
        );
    }
}

/// Outer walls are lit by the daylight, whatever room is behind them, and at night the sky is darker than walls
/// in lamplight.
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

/// The colours of the eyes' picture, by the greatest part of each: their mean, and that of the sky.
fn bright(home: &Environment, adapts: Option<Adaptation>) -> (f32, Vec<[u8; 3]>, [f32; 3]) {
    let mut home = home.clone();
    home.set_pictures(PictureOptions { adapts, ..*home.pictures() });
    let room = home.graph().of_class("living_room")[0];
    let frame = home.render(Viewpoint::Room(room), Modality::Rgb | Modality::Instance, 64, 48).unwrap();
    let mean = |of: &[[u8; 3]]| of.as_flattened().iter().map(|v| f32::from(*v)).sum::<f32>() / (3 * of.len()) as f32;
    let sky = (0..frame.rgb.len()).filter(|i| frame.instance[*i] == NOTHING).map(|i| frame.rgb[i]).collect();
    (mean(&frame.rgb), sky, frame.exposure)
}

/// At night an unlit room is dim and the sky in its windows dark and blue. When a lamp is switched on, eyes that are used
/// to the dark see the room, and nothing white.
#[test]
fn eyes_get_used_to_the_night_and_to_a_lamp() {
    let mut home = home(7, 1);
    home.set_pictures(PictureOptions { daylight: Daylight::at(23.0), ..PictureOptions::default() });
    let (dark, sky, used) = bright(&home, None);
    assert!((4.0..80.0).contains(&dark), "the unlit room's picture has a mean of {dark}");
    for colour in sky {
        assert!(colour[2] < 130 && colour[2] >= colour[0], "the sky is {colour:?}");
    }
    home.switch_lamps(true).unwrap();
    let (first, _, used) = bright(&home, Some(Adaptation::after(used, 1.0 / 6.0)));
    let (later, ..) = bright(&home, Some(Adaptation::after(used, 1.0)));
    assert!(first < 215.0 && (60.0..200.0).contains(&later), "a mean of {first}, and a second later of {later}");
}

/// Lamps without a switch of their own burn with the light switch of their room.
#[test]
fn lamps_burn_with_their_rooms_light_switch() {
    let mut scene = Apartment::from_seed(Seed(7)).unwrap().scene();
    let lamps: Vec<NodeId> = scene.of_class("ceiling_lamp");
    let mut edit = scene.edit();
    lamps.iter().for_each(|lamp| edit.bar(*lamp, Property::Switchable).unwrap());
    edit.commit();
    let mut home = Environment::from_scene(scene, 1).unwrap();
    home.set_pictures(PictureOptions { daylight: Daylight::at(23.0), ..PictureOptions::default() });
    let all = home.clone().switch_lamps(true).unwrap();
    let switches = |lamp: &NodeId| home.graph().light_switches(*lamp).collect::<Vec<NodeId>>();
    for lamp in &lamps {
        let by = switches(lamp);
        assert!(if by.is_empty() { all.contains(lamp) } else { by.iter().all(|id| all.contains(id)) }, "{lamp:?}");
    }
    let (lamp, switch) = lamps.iter().find_map(|lamp| Some((*lamp, *switches(lamp).first()?))).unwrap();
    let (me, room) = (home.agents()[0], home.graph().room_of(lamp).unwrap());
    let level = |home: &Environment| home.render(Viewpoint::Room(room), Modality::Rgb, 48, 36).unwrap().exposure[1];
    act(&mut home, me, Verb::Walk, &[switch]);
    let dark = level(&home);
    act(&mut home, me, Verb::SwitchOn, &[switch]);
    assert!(home.graph().is_lit(lamp) && level(&home) < 0.2 * dark, "{dark}, then {}", level(&home));
}

/// Recomputed lighting has the shadow of an agent at its new position; labels are unchanged.
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

/// Lamps that people switch on in the evening light a home that would be dark without them.
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
    // Lamps can still be switched by hand.
    let (me, lamp) = (home.agents()[0], lamps[0]);
    act(&mut home, me, Verb::Walk, &[lamp]);
    act(&mut home, me, Verb::SwitchOff, &[lamp]);
    assert!(home.graph().node(lamp).is_some_and(|n| !n.is(State::On)));
}
