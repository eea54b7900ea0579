//! Sensors measure what pictures and rays show, with noise that is that of the moment.

use nalgebra::{Point3, Vector3};
use virtualcity::graph::{NodeId, Place, Pose, Relation, Verb};
use virtualcity::physics::Hand;
use virtualcity::render::{Modality, NOTHING};
use virtualcity::sensors::{
    DepthNoise, Fisheye, Lidar, LidarScan, NoisyDepth, Reading, Sensor, SensorError, SensorId, SensorView,
};
use virtualcity::{CameraError, Environment, Lens, Mount, Viewpoint};

use super::{act, home};

/// Above the head, so that the wearer is not around it.
fn hat(me: NodeId) -> Mount {
    Mount::Head { agent: me, offset: Pose::translation(-0.14, 0.0, 0.25) }
}

fn scan(home: &Environment, id: SensorId) -> LidarScan {
    home.sense(id).unwrap().scan().unwrap().clone()
}

/// A lidar without noise measures what a picture from its place has as distances.
#[test]
fn lidars_agree_with_pictures() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let lidar = Lidar { noise: 0.0, columns: 180, ..Lidar::default() };
    let id = home.add_sensor("lidar", hat(me), lidar).unwrap();
    let eyes = home.add_camera("hat", hat(me), Lens::FieldOfView(1.2)).unwrap();
    let view = Viewpoint::Camera(eyes);
    let (camera, scan) = (home.camera(view, 320, 240).unwrap(), scan(&home, id));
    let frame = home.render(view, Modality::Distance | Modality::Instance, 320, 240).unwrap();
    let (mut same, mut all) = (0, 0);
    for ((point, node), distance) in scan.in_home().zip(scan.distance.iter().filter(|d| d.is_finite())) {
        let Some(seen) = camera.project(&point).filter(|p| (0.0..320.0).contains(&p.x) && (0.0..240.0).contains(&p.y))
        else {
            continue;
        };
        let pixel = seen.y as usize * 320 + seen.x as usize;
        let close = (frame.distance[pixel] - distance).abs() < 0.02 + 0.02 * distance;
        (same, all) = (same + usize::from(close && frame.instance[pixel] == node), all + 1);
    }
    assert!(all > 300 && same * 20 > all * 19, "{same} of {all} rays");
    assert!(!scan.instance.contains(&me));
    // Angles are those that were asked for.
    let up = scan.points.iter().zip(&scan.distance).filter(|(_, d)| d.is_finite()).map(|(p, d)| (p[2] / d).asin());
    let (low, high) = up.fold((0.0_f32, 0.0_f32), |(low, high), angle| (low.min(angle), high.max(angle)));
    assert!((low + 15_f32.to_radians()).abs() < 1e-3 && (high - 15_f32.to_radians()).abs() < 1e-3, "{low} {high}");
}

/// A thing that came into the home after the first scan is met where it is, and a thing that was taken is no more there.
#[test]
fn rays_meet_things_where_they_are() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let table = home.graph().of_class("coffee_table")[0];
    let down = |home: &Environment, id: NodeId| {
        let middle = home.world().aabb(id).unwrap().centre();
        let rays = home.ray_caster().unwrap();
        rays.first(&Point3::new(middle.x, middle.y, middle.z + 0.5), &-Vector3::z(), 2.0).map(|hit| hit.node)
    };
    assert!(down(&home, table).is_some());
    let apple = home.spawn("apple", Place { relation: Relation::On, at: table }).unwrap();
    assert_eq!(down(&home, apple), Some(apple));
    let at = home.world().aabb(apple).unwrap().centre();
    act(&mut home, me, Verb::Walk, &[apple]);
    act(&mut home, me, Verb::Grab, &[apple]);
    let rays = home.ray_caster().unwrap();
    let met = rays.first(&(at + Vector3::z() * 0.3), &-Vector3::z(), 2.0).map(|hit| hit.node);
    assert_ne!(met, Some(apple));
}

/// A fisheye's pixels are at angles in proportion to their distance from the middle, also behind the camera.
#[test]
fn fisheyes_are_equidistant() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (side, field) = (96_usize, 4.4_f32);
    let wanted = Modality::Instance | Modality::Distance | Modality::Rgb;
    let id = home.add_sensor("eye", hat(me), Fisheye { side: side as u32, field, wanted }).unwrap();
    let reading = home.sense(id).unwrap();
    let frame = reading.picture().unwrap();
    let view = home.add_camera("hat", hat(me), Lens::Options).unwrap();
    let pose = home.camera(Viewpoint::Camera(view), 8, 8).unwrap().body();
    let rays = home.ray_caster().unwrap();
    let (mut same, mut all, mut dark) = (0, 0, 0);
    for pixel in 0..side * side {
        let (right, down) = (pixel % side, pixel / side);
        let [x, y] = [right, down].map(|at| at as f32 + 0.5 - side as f32 / 2.0);
        let angle = x.hypot(y) / (side as f32 / field);
        if angle > field / 2.0 {
            assert_eq!((frame.instance[pixel], frame.rgb[pixel]), (NOTHING, [0; 3]), "outside of the disc");
            continue;
        }
        // X is ahead, Y to the left, Z up.
        let aside = Vector3::new(0.0, -x, -y).normalize();
        let way = pose.rotation * (Vector3::x() * angle.cos() + aside * angle.sin());
        let met = rays.first(&pose.translation.vector.into(), &way, 100.0);
        let close = met.is_some_and(|hit| {
            hit.node == frame.instance[pixel] && (hit.distance - frame.distance[pixel]).abs() < 0.05 * hit.distance
        });
        (same, all) = (same + usize::from(close), all + 1);
        dark += usize::from(frame.rgb[pixel] == [0; 3]);
    }
    assert!(same * 10 > all * 9, "{same} of {all} pixels");
    assert!(dark * 20 < all, "{dark} of {all} pixels are black");
}

/// Depth is as noisy as the formula says, and missing beyond the range.
#[test]
fn noise_grows_with_depth() {
    let mut home = home(42, 1);
    let room = home.graph().of_class("living_room")[0];
    let depth = |noise| NoisyDepth { width: 160, height: 120, noise, ..NoisyDepth::default() };
    let noisy = home.add_sensor("noisy", Mount::Room(room), depth(DepthNoise::default())).unwrap();
    let exact = home.add_sensor("exact", Mount::Room(room), depth(DepthNoise::NONE)).unwrap();
    let [noisy, exact] = [noisy, exact].map(|id| home.sense(id).unwrap().picture().unwrap().depth.clone());
    let deviation = |low: f32, high: f32| {
        let pairs = exact.iter().zip(&noisy).filter(|(z, n)| (low..high).contains(*z) && n.is_finite());
        let squares: Vec<f32> = pairs.map(|(z, n)| (z - n) * (z - n)).collect();
        assert!(squares.len() > 200, "{} pixels from {low} to {high} m", squares.len());
        (squares.iter().sum::<f32>() / squares.len() as f32).sqrt()
    };
    let formula = |z: f32| 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    for (low, high) in [(2.0, 2.5), (3.5, 4.0)] {
        let (measured, [least, most]) = (deviation(low, high), [low, high].map(formula));
        assert!(measured > 0.8 * least && measured < 1.3 * most, "{measured} m from {low} to {high} m");
    }
    assert!(exact.iter().chain(&noisy).all(|z| z.is_infinite() || *z < 4.7));
    let missing = noisy.iter().zip(&exact).filter(|(n, z)| n.is_infinite() && z.is_finite()).count();
    assert!(missing > 0 && missing * 2 < noisy.len(), "{missing} pixels seen at grazing angles are missing");
}

/// The bytes of a reading.
fn bytes(reading: &Reading) -> Vec<u32> {
    match reading {
        Reading::Picture(frame) => {
            let colours = frame.rgb.iter().flatten().map(|c| u32::from(*c));
            colours.chain(frame.depth.iter().map(|z| z.to_bits())).collect()
        }
        Reading::Scan(scan) => scan.distance.iter().map(|d| d.to_bits()).collect(),
        _ => Vec::new(),
    }
}

/// The same state gives the same bytes on any number of threads, whatever was sensed before; after an action noise is
/// another.
#[test]
fn readings_are_those_of_the_state() {
    let equipped = |threads| {
        let mut home = Environment::builder("apartment/42").threads(threads).make().unwrap();
        let me = home.agents()[0];
        home.add_sensor("fisheye", Mount::head(me), Fisheye { side: 48, ..Fisheye::default() }).unwrap();
        home.add_sensor("depth", Mount::head(me), NoisyDepth { width: 40, height: 30, ..NoisyDepth::default() })
            .unwrap();
        home.add_sensor("lidar", hat(me), Lidar { columns: 60, ..Lidar::default() }).unwrap();
        home
    };
    let all = |home: &Environment| -> Vec<Vec<u32>> {
        home.sense_all().unwrap().iter().map(|(_, reading)| bytes(reading)).collect()
    };
    let (mut one, mut other) = (equipped(1), equipped(3));
    let (me, sofa) = (one.agents()[0], one.graph().of_class("sofa")[0]);
    let first = all(&one);
    assert_eq!(first, all(&one.clone()));
    for home in [&mut one, &mut other] {
        act(home, me, Verb::Walk, &[sofa]);
        act(home, me, Verb::Sit, &[sofa]);
    }
    let second = all(&other);
    assert!(all(&one) == second, "earlier readings and threads change nothing");
    act(&mut one, me, Verb::Stand, &[]);
    let start = one.start().clone();
    one.reset(&start).unwrap();
    assert!(all(&one) == first, "a reset brings the first readings back");
    act(&mut one, me, Verb::Wave, &[]);
    let again = all(&one);
    assert!(again[0] == first[0] && again[1] != first[1] && again[2] != first[2], "noise is that of the moment");
}

/// Settings that make no sense are refused, and any small or odd size is measured.
#[test]
fn impossible_sensors_are_refused() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    let (lidar, depth, fisheye, nan) = (Lidar::default(), NoisyDepth::default(), Fisheye::default(), f32::NAN);
    let lidars = [
        Lidar { lines: 0, ..lidar },
        Lidar { lines: 10_000, ..lidar },
        Lidar { columns: 0, ..lidar },
        Lidar { elevation: (0.2, 0.1), ..lidar },
        Lidar { elevation: (nan, 0.1), ..lidar },
        Lidar { farthest: nan, ..lidar },
        Lidar { noise: -1.0, ..lidar },
    ];
    let depths = [
        NoisyDepth { width: 0, ..depth },
        NoisyDepth { height: 10_000, ..depth },
        NoisyDepth { nearest: 5.0, ..depth },
        NoisyDepth { lens: Lens::FieldOfView(4.0), ..depth },
        NoisyDepth { noise: DepthNoise { square: nan, ..DepthNoise::default() }, ..depth },
    ];
    let fisheyes = [
        Fisheye { side: 0, ..fisheye },
        Fisheye { side: 9000, ..fisheye },
        Fisheye { field: 0.0, ..fisheye },
        Fisheye { field: 7.0, ..fisheye },
        Fisheye { wanted: Modality::Depth.into(), ..fisheye },
    ];
    let sensors = lidars.into_iter().map(|s| Box::new(s) as Box<dyn Sensor>);
    let sensors = sensors.chain(depths.into_iter().map(|s| Box::new(s) as Box<dyn Sensor>));
    for sensor in sensors.chain(fisheyes.into_iter().map(|s| Box::new(s) as Box<dyn Sensor>)) {
        let told = format!("{sensor:?}");
        let id = home.add_sensor("wrong", Mount::head(me), std::sync::Arc::<dyn Sensor>::from(sensor)).unwrap();
        assert!(home.sense(id).is_err(), "{told}");
        home.remove_sensor(id).unwrap();
        assert!(matches!(home.sense(id), Err(SensorError::Mounted(CameraError::NoSuchNumber { .. }))));
    }
    let odd: [std::sync::Arc<dyn Sensor>; 4] = [
        std::sync::Arc::new(Lidar { lines: 1, columns: 1, ..lidar }),
        std::sync::Arc::new(NoisyDepth { width: 1, height: 1, ..depth }),
        std::sync::Arc::new(Fisheye { side: 1, field: 6.2, ..fisheye }),
        std::sync::Arc::new(Fisheye { side: 7, field: 0.01, ..fisheye }),
    ];
    let mounts = [Mount::head(me), Mount::wrist(me, Hand::Left), Mount::Overhead, Mount::Fixed(Pose::identity())];
    for (mount, sensor) in mounts.iter().flat_map(|mount| odd.iter().map(move |sensor| (mount, sensor.clone()))) {
        let id = home.add_sensor("odd", *mount, sensor).unwrap();
        home.sense(id).unwrap();
        home.remove_sensor(id).unwrap();
    }
    let told = home.add_sensor("a", Mount::head(fridge), lidar).unwrap_err().to_string();
    assert!(told.starts_with(&format!("{} is no agent", home.graph().label(fridge))), "{told}");
    let id = home.add_sensor("lidar", hat(me), lidar).unwrap();
    assert_eq!(
        home.add_sensor("lidar", hat(me), lidar),
        Err(CameraError::NameTaken { kind: "sensor", name: "lidar".into(), free: "lidar 2".into() })
    );
    assert_eq!(home.sensor_named("lidar"), Ok(id));
    assert_eq!(
        home.sensor_named("lydar").unwrap_err().to_string(),
        "there is no sensor `lydar` (did you mean `lidar`?)"
    );
    assert!(Environment::builder("apartment/42").threads(0).make().is_err());
}

/// A sensor of one's own says why it fails, and may look around.
#[test]
fn sensors_of_ones_own_are_sensors() {
    #[derive(Debug)]
    struct Smoke;
    impl Sensor for Smoke {
        fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
            let at = view.pose()?.translation.vector;
            let room = view.environment().room_at(at.xy().into());
            room.map(|room| Reading::Numbers { values: vec![room.0 as f32], shape: vec![1] })
                .ok_or_else(|| SensorError::Own("it hangs in no room".into()))
        }
    }
    let mut home = home(42, 1);
    let room = home.graph().rooms()[0];
    let middle = home.graph().node(room).unwrap().aabb().unwrap().centre();
    let inside = home.add_sensor("in", Mount::Fixed(Pose::translation(middle.x, middle.y, 2.0)), Smoke).unwrap();
    let outside = home.add_sensor("out", Mount::Fixed(Pose::translation(900.0, 0.0, 2.0)), Smoke).unwrap();
    let Reading::Numbers { values, .. } = home.sense(inside).unwrap() else { panic!("no numbers") };
    assert_eq!(values, [room.0 as f32]);
    assert_eq!(home.sense(outside).unwrap_err(), SensorError::Own("it hangs in no room".into()));
    assert_eq!(home.sense_all().unwrap_err(), SensorError::Own("it hangs in no room".into()));
    let error: SensorError = CameraError::NoSuchNumber { kind: "camera", number: 3 }.into();
    assert!(error.to_string().contains("no camera 3"));
}
