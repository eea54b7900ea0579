//! More light never gives darker pixels, in reference pictures and in fast ones.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Material;
use vc_render::{Adaptation, Camera, Daylight, Frame, Modality, PathTracing, ReferencePicture, Renderer, Shot};

fn even() -> Daylight {
    let one = Vector3::repeat(1.0);
    Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() }
}

/// A reference picture of a plain scene, for its exposure.
fn reference_picture() -> ReferencePicture {
    let mut stage = Stage::new();
    stage.one("box", block([0.5; 3]), Pose::translation(2.0, 0.0, 0.0), 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &even());
    let how = PathTracing { samples: 1, ..PathTracing::default() };
    renderer.reference_picture(&lighting, &Camera::with_fov(8, 6, 1.0), &how, |_| true).unwrap()
}

#[test]
fn more_light_is_never_darker_on_film() {
    let mut made = reference_picture();
    // From a millionth up, in steps of one percent.
    let steps = std::iter::successors(Some(1e-6_f32), |v| Some(1.01 * v)).take(4000);
    made.light = steps.map(|v| [v, 0.5 * v, 3.0 * v]).collect();
    (made.width, made.height) = (4000, 1);
    let picture = made.picture();
    for (i, pair) in picture.pixels.windows(2).enumerate() {
        assert!((0..3).all(|c| pair[0][c] <= pair[1][c]), "step {i}: {:?} and then {:?}", pair[0], pair[1]);
    }
    assert_eq!((picture.pixels[0], picture.pixels[3999]), ([0; 3], [255; 3]));
    // The steps are small: nearly all byte values occur.
    let bytes: std::collections::BTreeSet<u8> = picture.pixels.iter().map(|p| p[0]).collect();
    assert!(bytes.len() > 200, "{} bytes of 256", bytes.len());
}

/// Sunlit things keep their hue and shading: five to thirty times the light of the room is neither white nor flat.
#[test]
fn sunlit_walls_keep_their_hue_and_shading() {
    let mut made = reference_picture();
    made.light = vec![[1.0; 3]];
    (made.width, made.height) = (1, 1);
    // The light that a white wall reflects in the light of the room: it is displayed at about two fifths.
    let white = std::iter::successors(Some(1e-3_f32), |v| Some(1.02 * v)).find(|v| {
        made.light[0] = [*v; 3];
        made.picture().pixels[0][1] >= 175
    });
    let white = white.unwrap();
    for colour in [[0.9, 0.9, 0.9], [0.1, 0.3, 0.7], [0.8, 0.55, 0.1], [0.7, 0.2, 0.15]] {
        let shown = |light: f32| {
            let mut made = made.clone();
            made.light[0] = colour.map(|c: f32| c * light * white);
            made.picture().pixels[0].map(f32::from)
        };
        let bright = |c: [f32; 3]| c.into_iter().fold(0.0, f32::max);
        for sun in [5.0, 10.0, 20.0, 30.0] {
            let [side, front] = [0.6 * sun, sun].map(shown);
            assert!(bright(front) < 245.0, "{colour:?} in {sun} times the light is {front:?}");
            assert!(bright(front) > bright(side) + 3.0, "{colour:?}: {side:?} and {front:?} from the side");
            let order = |c: [f32; 3]| (0..2).map(|i| (c[i + 1] - c[i]).signum()).collect::<Vec<f32>>();
            let spread = bright(front) - front.into_iter().fold(255.0, f32::min);
            let hued = colour != [0.9; 3];
            assert!(!hued || (order(front) == order(colour) && spread > 60.0), "{colour:?} looks {front:?}");
        }
    }
}

/// A dark board fills the view of a lit room: it is readable, and still darker than a white one.
#[test]
fn cameras_meter_what_they_see() {
    let mut stage = Stage::new();
    let dark = stage.library.add_material(material("plain", [0.05, 0.035, 0.025])).unwrap();
    stage.one("floor", block([3.0, 3.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 1);
    for (x, board) in [(2.0, dark), (-2.0, 1)] {
        stage.one("bookcase", block([0.1, 2.5, 1.5]), Pose::translation(x, 0.0, 1.5), board);
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &even());
    let mut frame = Frame::new();
    let [dark, white] = [1.0, -1.0].map(|x| {
        let camera = Camera::with_fov(32, 24, 0.9).looking(Point3::new(0.0, 0.0, 1.5), Point3::new(2.0 * x, 0.0, 1.5));
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        (frame.rgb[12 * 32 + 16][0], frame.exposure[1])
    });
    assert!(dark.0 > 75 && white.0 > dark.0 + 40 && white.0 < 200, "{dark:?} and {white:?}");
    assert!(dark.1 > 2.0 * white.1, "{dark:?} and {white:?}");
}

/// A shade of cloth around a bulb glows, one of metal does not.
#[test]
fn light_shines_through_cloth_only() {
    let shade = |name: &str| {
        let mut stage = Stage::new();
        let cover = stage.library.add_material(material(name, [0.3, 0.25, 0.2])).unwrap();
        let bulb = common::part("bulb", vc_graph::asset::Shape::Sphere { radius: 0.04 }, [0.0; 3], 3);
        let asset = stage.asset(vec![bulb, common::part("shade", block([0.1; 3]), [0.0; 3], cover)]);
        let lamp = stage.put("pendant_lamp", asset, Pose::translation(1.5, 0.0, 1.5));
        stage.one("floor", block([3.0, 3.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 1);
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
        snapshot.switch(lamp, true).unwrap();
        let lighting = renderer.light(&snapshot, &Daylight::night());
        let camera = Camera::with_fov(32, 24, 0.5).looking(Point3::new(0.0, 0.0, 1.5), Point3::new(1.5, 0.0, 1.5));
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        frame.rgb[12 * 32 + 16][0]
    };
    let (cloth, metal) = (shade("natural_linen"), shade("black_enamelled_metal"));
    assert!(cloth > 120 && u32::from(metal) * 3 < u32::from(cloth), "{cloth} through cloth, {metal} through metal");
}

/// A camera that adapts is dazzled for a moment only; one whose share is zero keeps its exposure.
#[test]
fn a_large_step_is_adapted_to_at_once() {
    let mut stage = Stage::new();
    stage.one("box", block([0.5; 3]), Pose::translation(2.0, 0.0, 0.0), 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &even());
    let camera = Camera::with_fov(8, 6, 1.0);
    let exposure = |adapts: Option<Adaptation>| {
        let mut frame = Frame::new();
        let shot = Shot { adaptation: adapts, ..Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting) };
        renderer.render(&shot, &mut frame).unwrap();
        frame.exposure[1]
    };
    let own = exposure(None);
    for (from, least, most) in [(1e4, 1.9, 2.1), (1e-4, 0.38, 0.42)] {
        let first = exposure(Some(Adaptation::after([from * own; 3], 0.1))) / own;
        assert!((least..most).contains(&first), "{first} times the exposure");
        let kept = exposure(Some(Adaptation { from: [from * own; 3], share: 0.0 })) / own;
        assert!((kept / from - 1.0).abs() < 1e-3, "{kept}");
    }
}

#[test]
fn light_that_cannot_be_has_a_colour() {
    let mut made = reference_picture();
    made.light = vec![[f32::NAN; 3], [-1.0; 3], [f32::NEG_INFINITY; 3], [0.0; 3], [f32::MAX; 3], [f32::INFINITY; 3]];
    (made.width, made.height) = (6, 1);
    assert_eq!(made.picture().pixels, [[0; 3], [0; 3], [0; 3], [0; 3], [255; 3], [255; 3]]);
}

#[test]
fn more_light_is_never_darker_in_fast_pictures() {
    // Luminous patches side by side, each 1.8 times as bright as the one before it.
    let mut stage = Stage::new();
    let places: Vec<Point3<f32>> =
        (0..24).map(|i| Point3::new(0.0, 0.35 - 0.1 * (i % 8) as f32, 0.1 - 0.1 * (i / 8) as f32)).collect();
    let mut emission = 0.02_f32;
    for at in &places {
        let glow = Material { emission: [emission; 3], roughness: 1.0, ..material("plain", [0.0; 3]) };
        let glow = stage.library.add_material(glow).unwrap();
        stage.one("tv", block([0.01, 0.048, 0.048]), Pose::translation(at.x, at.y, at.z), glow);
        emission *= 1.8;
    }
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let lighting = renderer.light(&snapshot, &even());
    let camera = Camera::with_fov(80, 40, 0.42).looking(Point3::new(-1.0, 0.0, 0.0), Point3::origin());
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
    let shown: Vec<u8> = places
        .iter()
        .map(|at| {
            let seen = camera.project(at).unwrap();
            frame.rgb[seen.y as usize * 80 + seen.x as usize][1]
        })
        .collect();
    assert!(shown.is_sorted(), "{shown:?}");
    assert!(shown[23] - shown[0] > 150, "{shown:?}");
}

/// The sky is several times as bright as walls in the room's light, but not white: it is blue, and the horizon
/// is lighter.
#[test]
fn the_sky_is_seen_from_a_room() {
    let stage = Stage::new();
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let eye = Point3::new(0.0, 0.0, 1.5);
    let camera = Camera::with_fov(48, 48, 1.0).looking(eye, eye + Vector3::new(-1.0, -1.0, 0.9));
    let indoors = Adaptation { from: [8.0; 3], share: 0.0 };
    let shot = Shot { adaptation: Some(indoors), ..Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting) };
    let mut frame = Frame::new();
    renderer.render(&shot, &mut frame).unwrap();
    let (high, low) = (frame.rgb[2 * 48 + 24], frame.rgb[46 * 48 + 24]);
    assert!(high[2] > high[0] + 8 && high[0] + 8 < low[0], "{high:?} high up, {low:?} low");
    assert!(high.iter().chain(&low).all(|v| *v < 246), "{high:?} high up, {low:?} low");
}

/// The lower the sun, the warmer its light and the sky's, and the less of it.
#[test]
fn evenings_are_warm() {
    let warmth = |of: Vector3<f32>| of.x / of.z;
    let days: Vec<Daylight> = [12.0, 15.0, 16.5, 17.4].map(Daylight::at).to_vec();
    for pair in days.windows(2) {
        assert!(warmth(pair[1].sun) > 1.05 * warmth(pair[0].sun) && warmth(pair[1].horizon) > warmth(pair[0].horizon));
        assert!(pair[1].zenith.sum() <= pair[0].zenith.sum() && pair[1].sun.sum() < pair[0].sun.sum());
    }
}

/// A screen that is on in a dark room shows its picture: no part of it is white.
#[test]
fn screens_are_readable_in_the_dark() {
    let mut stage = Stage::new();
    let room = [([2.0, 2.0, 0.1], -0.1), ([2.0, 2.0, 0.1], 2.6)];
    for (half, z) in room {
        stage.one("floor", block(half), Pose::translation(0.0, 0.0, z), 1);
    }
    let glow = |colour: [f32; 3]| Material { emission: colour.map(|c| 40.0 * c), ..material("picture", [0.01; 3]) };
    let colours = [[0.21, 0.45, 0.69], [0.1, 0.25, 0.07]].map(|c| stage.library.add_material(glow(c)).unwrap());
    let half = |side: f32, mat| common::part("picture", block([0.01, 0.3, 0.3]), [0.0, 0.3 * side, 0.0], mat);
    let asset = stage.asset(vec![half(1.0, colours[0]), half(-1.0, colours[1])]);
    let screen = stage.put("television", asset, Pose::translation(1.5, 0.0, 1.2));
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    snapshot.switch(screen, true).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::night());
    let camera = Camera::with_fov(48, 48, 0.9).looking(Point3::new(-1.0, 0.0, 1.2), Point3::new(1.5, 0.0, 1.2));
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
    let at = |y: f32| {
        let seen = camera.project(&Point3::new(1.49, y, 1.2)).unwrap();
        frame.rgb[seen.y as usize * 48 + seen.x as usize]
    };
    let (sky, land) = (at(0.3), at(-0.3));
    assert!(sky[2] > sky[0] + 8 && land[1] > land[2] + 20, "{sky:?}, {land:?}");
    assert!(sky.iter().chain(&land).all(|v| *v < 240), "{sky:?}, {land:?}");
}
