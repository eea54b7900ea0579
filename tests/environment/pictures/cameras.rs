//! Cameras by number and name: where they are, what they show, and how they are kept.

use nalgebra::{Point3, Vector3};
use virtualcity::graph::{Action, NodeId, Pose, Property, Relation, Verb};
use virtualcity::physics::Hand;
use virtualcity::render::{Frame, Modality};
use virtualcity::{CameraError, CameraId, Environment, Lens, Mount, NamedCamera, SaveError, Viewpoint};

use super::{act, home};

fn seen(home: &Environment, id: CameraId) -> Frame {
    home.render(Viewpoint::Camera(id), Modality::Instance, 64, 48).unwrap()
}

/// Every home has the same cameras first, others get numbers of their own and names that differ.
#[test]
fn cameras_have_numbers_and_names() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let rooms = home.graph().rooms().to_vec();
    let before = home.cameras();
    assert_eq!(before.len(), 2 + 2 * rooms.len());
    assert!(before.iter().zip(0..).all(|((id, _), number)| id.0 == number));
    let views = std::iter::once(Viewpoint::Agent(me)).chain(rooms.iter().copied().map(Viewpoint::Room));
    for (view, (id, camera)) in views.zip(&before) {
        assert_eq!(home.camera_named(&camera.name), Ok(*id));
        let both = [view, Viewpoint::Camera(*id)].map(|view| home.camera(view, 64, 48).unwrap());
        assert_eq!(both[0], both[1], "{}", camera.name);
    }
    let digest = home.digest();
    let first = home.add_camera("one", Mount::Above(rooms[0]), Lens::Options).unwrap();
    let second = home.add_camera("two", Mount::head(me), Lens::FieldOfView(0.8)).unwrap();
    assert_eq!((first.0 as usize, second.0), (before.len(), first.0 + 1));
    assert_eq!(home.digest(), digest);
    let taken = home.add_camera("one", Mount::Overhead, Lens::Options).unwrap_err().to_string();
    assert_eq!(taken, "there is a camera `one` already: `one 2` is free");
    assert_eq!(home.clone().cameras(), home.cameras());
    assert_eq!(home.remove_camera(first).unwrap().name, "one");
    assert_eq!(
        home.render(Viewpoint::Camera(first), Modality::Depth, 8, 8).err(),
        Some(CameraError::NoSuchNumber { kind: "camera", number: first.0 }.into())
    );
    let third = home.add_camera("one", Mount::Overhead, Lens::Options).unwrap();
    assert_eq!(third.0, second.0 + 1, "numbers are not given again");
    assert!(matches!(home.remove_camera(CameraId(0)), Err(CameraError::BuiltIn(name)) if name == before[0].1.name));
    assert!(matches!(home.remove_camera(first), Err(CameraError::NoSuchNumber { .. })));
    home.change_camera(third, Mount::Above(rooms[0]), Lens::FieldOfView(1.0)).unwrap();
    assert_ne!(home.camera(Viewpoint::Camera(third), 64, 48), home.camera(Viewpoint::Overhead, 64, 48));
}

/// Pictures of a calibrated camera have its numbers, whatever their size.
#[test]
fn intrinsics_are_kept() {
    let mut home = home(42, 1);
    let lens = Lens::Intrinsics { size: (640, 480), focal: (525.0, 520.0), centre: (319.5, 239.5) };
    let pose = Pose::new(Vector3::new(1.0, 2.0, 1.5), Vector3::new(0.0, 0.2, 0.7));
    let id = home.add_camera("calibrated", Mount::Fixed(pose), lens).unwrap();
    let camera = |width, height| home.camera(Viewpoint::Camera(id), width, height).unwrap();
    let whole = camera(640, 480);
    assert_eq!((whole.focal, whole.centre), ((525.0, 520.0), (319.5, 239.5)));
    assert_eq!(camera(320, 240).focal, (262.5, 260.0));
    let ahead = whole.unproject(319.5, 239.5, 2.0) - pose * Point3::new(2.0, 0.0, 0.0);
    assert!(ahead.norm() < 1e-4, "it looks along X: {ahead}");
}

/// The first thing that can be taken from where it lies.
fn take(home: &mut Environment, me: NodeId) -> NodeId {
    let open = |id: &NodeId| home.graph().related(*id, Relation::On).next().is_some();
    let things = home.graph().nodes().filter(|n| n.affords(Property::Graspable)).map(|n| n.id()).filter(open);
    for thing in things.collect::<Vec<_>>() {
        let mut tried = home.clone();
        let [walk, grab] = [Verb::Walk, Verb::Grab].map(|verb| Action::one(verb, thing));
        if tried.set_action(me, walk).is_ok() && tried.set_action(me, grab).is_ok() {
            *home = tried;
            return thing;
        }
    }
    panic!("nothing can be taken");
}

/// A camera on a wrist sees the hand and the thing in it.
#[test]
fn wrists_see_what_hands_hold() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let cameras = [Hand::Right, Hand::Left]
        .map(|hand| home.add_camera(format!("{hand:?}"), Mount::wrist(me, hand), Lens::FieldOfView(1.4)).unwrap());
    let pixels = |home: &Environment, camera, of| seen(home, camera).instance.iter().filter(|id| **id == of).count();
    let thing = take(&mut home, me);
    let shown = cameras.map(|camera| pixels(&home, camera, thing));
    assert!(shown[0] > 30 && shown[0] > shown[1], "{} in {shown:?} pixels", home.graph().label(thing));
    assert!(cameras.iter().all(|camera| pixels(&home, *camera, me) < 64 * 48 / 2));
    // Hands move with the body.
    let before = home.camera(Viewpoint::Camera(cameras[0]), 64, 48).unwrap().eye();
    let bed = home.graph().of_class("wardrobe")[0];
    act(&mut home, me, Verb::Walk, &[bed]);
    assert!((home.camera(Viewpoint::Camera(cameras[0]), 64, 48).unwrap().eye() - before).norm() > 0.5);
}

/// A camera that follows sees its agent wherever it is, standing, sitting and lying, and nothing is between them.
#[test]
fn followers_keep_agents_in_view() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    // Close behind, and farther away than rooms are wide.
    let followers = [(2.0, 0.6), (6.0, 1.0)].map(|(behind, above)| {
        home.add_camera(format!("{behind}"), Mount::Following { agent: me, behind, above }, Lens::Options).unwrap()
    });
    let one = |class: &str| home.graph().of_class(class)[0];
    let (fridge, sofa, bed) = (one("fridge"), one("sofa"), one("double_bed"));
    let way = [(Verb::Walk, fridge), (Verb::Walk, sofa), (Verb::Sit, sofa), (Verb::Walk, bed), (Verb::Lie, bed)];
    for (verb, thing) in way {
        if home.posture(me) != Some(virtualcity::physics::Posture::Standing) {
            act(&mut home, me, Verb::Stand, &[]);
        }
        if verb == Verb::Lie || verb == Verb::Sit {
            act(&mut home, me, Verb::Walk, &[thing]);
        }
        act(&mut home, me, verb, &[thing]);
        for follower in followers {
            let frame = seen(&home, follower);
            let count = frame.instance.iter().filter(|id| **id == me).count();
            let label = home.graph().label(thing);
            assert!((8..64 * 48 / 2).contains(&count), "{verb} {label}: {count} pixels");
            let eye = home.camera(Viewpoint::Camera(follower), 64, 48).unwrap().eye();
            assert!(home.room_at(eye.xy()).is_some(), "{verb} {label}: outside at {eye}");
        }
    }
}

/// Cameras that cannot be are refused with the reason, and nothing has changed.
#[test]
fn impossible_cameras_are_refused() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    let label = home.graph().label(fridge).to_string();
    let (nan, before) = (f32::NAN, home.cameras());
    let hand = Mount::wrist(fridge, Hand::Left);
    let lens = |focal, size| Lens::Intrinsics { size, focal, centre: (1.0, 1.0) };
    let refused = [
        ("a", hand, Lens::Options, format!("{label} is no agent")),
        (
            "a",
            Mount::Following { agent: fridge, behind: 1.0, above: 0.0 },
            Lens::Options,
            format!("{label} is no agent"),
        ),
        ("a", Mount::Room(me), Lens::Options, format!("{} is not a room", home.graph().label(me))),
        ("a", Mount::Thing { thing: NodeId(99_999), offset: Pose::identity() }, Lens::Options, "is not there".into()),
        ("a", Mount::Fixed(Pose::translation(nan, 0.0, 0.0)), Lens::Options, "pose is to be finite".into()),
        ("a", Mount::Following { agent: me, behind: 0.0, above: 0.0 }, Lens::Options, "cannot follow 0 m".into()),
        ("a", Mount::Following { agent: me, behind: 1.0, above: nan }, Lens::Options, "cannot follow".into()),
        ("a", Mount::Overhead, Lens::FieldOfView(0.0), "field of view of 0 rad".into()),
        ("a", Mount::Overhead, Lens::FieldOfView(nan), "field of view of NaN rad".into()),
        ("a", Mount::Overhead, lens((0.0, 1.0), (64, 48)), "focal lengths".into()),
        ("a", Mount::Overhead, lens((9.0, 9.0), (0, 48)), "size is to be".into()),
        ("", Mount::Overhead, Lens::Options, "name of a camera".into()),
        ("two\nlines", Mount::Overhead, Lens::Options, "name of a camera".into()),
        ("overhead", Mount::Overhead, Lens::Options, "a camera `overhead` already".into()),
    ];
    for (name, mount, lens, why) in refused {
        let told = home.add_camera(name, mount, lens).unwrap_err().to_string();
        assert!(told.contains(&why), "{told}");
    }
    assert_eq!(home.cameras(), before);
    let built = Environment::builder("apartment/42").camera("a", Mount::Room(NodeId(99_999)), Lens::Options).make();
    assert!(built.unwrap_err().to_string().contains("not a room"));
    // One on a thing that is gone later.
    let mount = Mount::Thing { thing: take(&mut home, me), offset: Pose::translation(0.0, 0.0, 0.3) };
    let id = home.add_camera("thing", mount, Lens::Options).unwrap();
    for (width, height) in [(1, 1), (0, 0), (1, u32::MAX)] {
        let made = home.render(Viewpoint::Camera(id), Modality::Rgb | Modality::Instance, width, height);
        assert_eq!(made.is_ok(), (width, height) == (1, 1));
    }
}

/// Cameras are saved with the environment and as a list of their own.
#[test]
fn cameras_are_saved() {
    let mut home = home(42, 1);
    let (me, plain) = (home.agents()[0], home.save().unwrap());
    home.add_camera("gone", Mount::Overhead, Lens::Options).unwrap();
    let lens = Lens::Intrinsics { size: (64, 48), focal: (50.0, 50.0), centre: (32.0, 24.0) };
    let pose = Pose::new(Vector3::new(1.0, 2.0, 1.5), Vector3::new(0.0, 0.2, 0.7));
    let mounts = [
        Mount::Fixed(pose),
        Mount::head(me),
        Mount::wrist(me, Hand::Left),
        Mount::Thing { thing: home.graph().of_class("fridge")[0], offset: pose },
        Mount::Following { agent: me, behind: 2.0, above: 0.5 },
        Mount::Room(home.graph().rooms()[0]),
        Mount::Above(home.graph().rooms()[1]),
        Mount::Overhead,
    ];
    for (mount, lens) in mounts.into_iter().zip([lens, Lens::FieldOfView(0.9), Lens::Options].into_iter().cycle()) {
        home.add_camera(format!("{mount:?}").chars().take(20).collect::<String>(), mount, lens).unwrap();
    }
    home.remove_camera(home.camera_named("gone").unwrap()).unwrap();
    let saved = home.save().unwrap();
    let fresh = Environment::make("apartment/42", 1).unwrap();
    let mut restored = fresh.restore(&saved).unwrap();
    assert_eq!(restored.cameras(), home.cameras());
    assert_eq!((restored.digest(), restored.save().unwrap()), (home.digest(), saved.clone()));
    let [next, again] = [&mut restored, &mut home].map(|h| h.add_camera("next", Mount::Overhead, Lens::Options));
    assert_eq!(next, again);
    // The saved state says which cameras there are.
    assert_eq!(home.restore(&plain).unwrap().cameras(), fresh.cameras());
    for end in (plain.len()..saved.len()).step_by(7) {
        assert!(fresh.restore(&saved[..end]).is_err(), "cut off at {end}");
    }
    let mut altered = saved.clone();
    let field = saved.windows(4).rposition(|text| text == b":0.9").unwrap();
    altered[field + 1] = b'9';
    assert!(matches!(fresh.restore(&altered), Err(SaveError::Damaged)));

    let list = home.cameras_json();
    let mut other = fresh.clone();
    assert_eq!(other.add_cameras(&list).unwrap().len(), 9);
    let names = |home: &Environment| home.cameras().into_iter().map(|(_, camera)| camera).collect::<Vec<NamedCamera>>();
    assert_eq!(names(&other), names(&home));
    for wrong in [
        "",
        "{}",
        "[{}]",
        r#"[{"name": "a", "mount": "nowhere"}]"#,
        r#"[{"name": "a", "mount": {"above": 1}, "x": 1}]"#,
    ] {
        assert!(matches!(other.add_cameras(wrong), Err(CameraError::NotAList(_))), "{wrong}");
    }
    let two = r#"[{"name": "a", "mount": "overhead"}, {"name": "a", "mount": "overhead"}]"#;
    assert!(matches!(other.add_cameras(two), Err(CameraError::NameTaken { .. })));
    assert_eq!(names(&other), names(&home), "all or none");
}
