//! Blinds and curtains: labels show them drawn over their window, and light passes them on its way into the
//! room.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material, part};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::Material;
use vc_graph::{NodeId, Pose, State};
use vc_render::{Camera, Daylight, Frame, Lighting, Modality, PathTracing, Renderer, Shot, Snapshot};

/// A closed room with a window at x = 2, covered from inside.
struct Room {
    renderer: Renderer,
    snapshot: Snapshot,
    window: NodeId,
    covers: Vec<NodeId>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Blinds,
    Curtains,
}

impl Room {
    fn new(kind: Kind, closed: bool) -> Self {
        let mut stage = Stage::new();
        let cloth = Material { roughness: 1.0, ..material("white_cotton", [0.8; 3]) };
        let cloth = stage.library.add_material(cloth).unwrap();
        stage.one("floor", block([2.0, 2.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 1);
        stage.one("ceiling", block([2.2, 2.2, 0.1]), Pose::translation(0.0, 0.0, 2.7), 1);
        stage.one("wall", block([0.1, 2.0, 1.3]), Pose::translation(-2.1, 0.0, 1.3), 1);
        for side in [-1.0, 1.0] {
            stage.one("wall", block([2.2, 0.1, 1.3]), Pose::translation(0.0, 2.1 * side, 1.3), 1);
            stage.one("wall", block([0.1, 0.75, 1.3]), Pose::translation(2.1, 1.25 * side, 1.3), 1);
        }
        stage.one("wall", block([0.1, 0.5, 0.45]), Pose::translation(2.1, 0.0, 0.45), 1);
        stage.one("wall", block([0.1, 0.5, 0.25]), Pose::translation(2.1, 0.0, 2.35), 1);
        let window = stage.one("window", block([0.003, 0.5, 0.6]), Pose::translation(2.1, 0.0, 1.5), 2);
        // The covers face into the room.
        let at = |y: f32, z: f32| common::pose([1.95, y, z], std::f32::consts::PI, 0.0);
        let covers = match kind {
            Kind::Blinds => vec![stage.one("blinds", block([0.004, 0.53, 0.15]), at(0.0, 1.97), cloth)],
            Kind::Curtains => {
                let shape = block([0.004, 0.14, 0.7]);
                [-1.0, 1.0].map(|side| stage.one("curtain", shape.clone(), at(0.66 * side, 1.5), cloth)).to_vec()
            }
        };
        let mut graph = stage.build();
        let mut edit = graph.edit();
        for cover in &covers {
            edit.enter_state(*cover, if closed { State::Closed } else { State::Open }).unwrap();
        }
        edit.commit();
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(&graph).unwrap();
        Self { renderer, snapshot, window, covers }
    }

    fn drawn(&self, closed: bool) -> Snapshot {
        let mut snapshot = self.snapshot.clone();
        self.covers.iter().for_each(|cover| snapshot.draw_cover(*cover, closed).unwrap());
        snapshot
    }

    fn frame(&self, snapshot: &Snapshot, lighting: &Lighting, camera: &Camera) -> Frame {
        let mut frame = Frame::new();
        let wanted = Modality::Rgb | Modality::Instance | Modality::Depth | Modality::Boxes | Modality::Position;
        self.renderer.render(&Shot::new(snapshot, camera, wanted).lit(lighting), &mut frame).unwrap();
        frame
    }

    fn reference(&self, lighting: &Lighting, camera: &Camera) -> f64 {
        let how = PathTracing { samples: 200, brightest: f32::INFINITY, denoise: false, ..PathTracing::default() };
        let light = self.renderer.reference_picture(lighting, &camera.resized(24, 18), &how, |_| true).unwrap().light;
        light.iter().map(|c| f64::from(c[1])).sum::<f64>() / light.len() as f64
    }
}

fn at_the_window() -> Camera {
    Camera::with_fov(96, 72, 1.0).looking(Point3::new(-1.0, 0.1, 1.5), Point3::new(2.1, 0.0, 1.5))
}

fn at_the_floor() -> Camera {
    Camera::with_fov(48, 36, 1.2).looking(Point3::new(-1.6, -0.4, 2.2), Point3::new(0.4, 0.2, 0.0))
}

fn sunny() -> Daylight {
    Daylight { towards_sun: Vector3::new(1.0, 0.1, 0.9).normalize(), ..Daylight::noon() }
}

fn is_same(a: &Frame, b: &Frame) -> bool {
    a.rgb == b.rgb && a.instance == b.instance && a.depth == b.depth && a.boxes == b.boxes
}

#[test]
fn a_drawn_cover_hides_its_window_and_an_open_one_is_as_it_was() {
    for kind in [Kind::Blinds, Kind::Curtains] {
        let room = Room::new(kind, false);
        let lighting = room.renderer.light(&room.snapshot, &sunny());
        let camera = at_the_window();
        let count = |frame: &Frame, node: NodeId| frame.instance.iter().filter(|id| **id == node).count();
        let open = room.frame(&room.snapshot, &lighting, &camera);
        let closed = room.frame(&room.drawn(true), &lighting, &camera);
        assert!(count(&open, room.window) > 300);
        assert_eq!(count(&closed, room.window), 0);
        for cover in &room.covers {
            assert!(count(&closed, *cover) > 2 * count(&open, *cover));
            let wide = |frame: &Frame| frame.boxes.iter().find(|b| b.node == *cover).unwrap().visible;
            assert!(wide(&closed) != wide(&open));
        }
        // Everything else stays visible where it was.
        let around = |f: &Frame| f.instance.iter().filter(|id| !room.covers.contains(id)).count();
        assert!(around(&open) > around(&closed));
        let mut again = room.drawn(true);
        room.covers.iter().for_each(|cover| again.draw_cover(*cover, false).unwrap());
        assert!(is_same(&room.frame(&again, &lighting, &camera), &open));
        // A graph's states draw covers, too.
        let made = Room::new(kind, true);
        let lighting = made.renderer.light(&made.snapshot, &sunny());
        assert_eq!(made.frame(&made.snapshot, &lighting, &camera).instance, closed.instance);
    }
}

/// Scenes of others have several curtains in one place.
#[test]
fn covers_in_the_same_place_are_one_behind_the_other() {
    let mut stage = Stage::new();
    let cloth = stage.library.add_material(material("white_cotton", [0.8; 3])).unwrap();
    stage.one("window", block([0.003, 0.5, 0.6]), Pose::translation(2.1, 0.0, 1.5), 2);
    let at = common::pose([1.9, 0.6, 1.5], std::f32::consts::PI, 0.0);
    // The second would be in front of the first by half a millimetre.
    let [first, second] = [0.02, 0.0205].map(|deep| stage.one("curtain", block([deep, 0.14, 0.7]), at, cloth));
    let mut graph = stage.build();
    let mut renderer = Renderer::new();
    for closed in [false, true] {
        let mut edit = graph.edit();
        let state = if closed { State::Closed } else { State::Open };
        for cover in [first, second] {
            edit.enter_state(cover, state).unwrap();
        }
        edit.commit();
        let snapshot = renderer.snapshot(&graph).unwrap();
        let [front, back] = [first, second].map(|cover| snapshot.bounds(cover).unwrap());
        assert!(front.max.x < back.min.x + 1e-3 && front.min.x < back.min.x - 0.01, "{front:?} {back:?}");
        let mut frame = Frame::new();
        let camera = Camera::with_fov(96, 72, 1.0).looking(Point3::new(-1.0, 0.6, 1.5), Point3::new(2.1, 0.6, 1.5));
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance), &mut frame).unwrap();
        assert!(frame.instance.contains(&first) && !frame.instance.contains(&second));
    }
}

#[test]
fn drawn_covers_darken_reference_pictures_but_not_to_black() {
    for (kind, day) in [(Kind::Blinds, sunny()), (Kind::Curtains, Daylight::overcast())] {
        let room = Room::new(kind, false);
        let lit = |closed: bool| room.reference(&room.renderer.light(&room.drawn(closed), &day), &at_the_floor());
        let (open, closed) = (lit(false), lit(true));
        eprintln!("{open:.4} open, {closed:.4} closed");
        assert!(closed < 0.4 * open && closed > 0.02 * open, "{open} open, {closed} closed");
        assert!(lit(false) == open, "the same light when it is opened again");
    }
}

/// Mean brightness of the floor in the sun, and beside it.
fn floor(frame: &Frame) -> [f64; 2] {
    let mean = |from: f32, to: f32, aside: f32| {
        let here = |p: &[f32; 3]| p[2].abs() < 0.01 && (from..to).contains(&p[0]) && (p[1] - aside).abs() < 0.2;
        let all = frame.position.iter().zip(&frame.rgb).filter(|(p, _)| here(p));
        let sums = all.fold((0.0, 0), |(s, n), (_, c)| (s + c.iter().map(|v| f64::from(*v)).sum::<f64>(), n + 1));
        assert!(sums.1 > 5);
        sums.0 / f64::from(sums.1)
    };
    [mean(0.3, 0.7, -0.15), mean(0.3, 0.7, 0.8)]
}

#[test]
fn fast_light_follows_a_blind_when_it_is_made_anew() {
    let room = Room::new(Kind::Blinds, false);
    let (open, closed) = (room.drawn(false), room.drawn(true));
    let camera = at_the_floor();
    let mut lighting = room.renderer.light(&open, &sunny());
    let before = room.frame(&open, &lighting, &camera);
    let [sun, shade] = floor(&before);
    assert!(sun > 1.2 * shade, "{sun} in the sun, {shade} beside it");
    room.renderer.relight(&mut lighting, &closed).unwrap();
    let dark = room.frame(&closed, &lighting, &camera);
    let [there, beside] = floor(&dark);
    eprintln!("{sun} {shade} open, {there} {beside} closed");
    assert!((there / beside - 1.0).abs() < 0.25, "{there} where the sun was, {beside} beside it");
    let fresh = room.frame(&closed, &room.renderer.light(&closed, &sunny()), &camera);
    let off = dark.rgb.as_flattened().iter().zip(fresh.rgb.as_flattened()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    assert!(off <= 2, "off by {off} from light that is made of the closed blind");
    room.renderer.relight(&mut lighting, &open).unwrap();
    let again = room.frame(&open, &room.renderer.light(&open, &sunny()), &camera);
    assert!(is_same(&again, &before), "the same bytes when it is opened again");
    let again = room.frame(&open, &lighting, &camera);
    let off = again.rgb.as_flattened().iter().zip(before.rgb.as_flattened()).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(off <= Some(2), "off by {off:?}");
}

#[test]
fn fast_light_through_a_drawn_cover_is_about_that_of_the_reference() {
    // Both pictures are exposed for the fast light: if it were too bright behind a cover, the reference would
    // be too dark.
    for (kind, day) in [(Kind::Blinds, Daylight::overcast()), (Kind::Curtains, Daylight::overcast())] {
        let room = Room::new(kind, false);
        let level = |closed: bool| {
            let snapshot = room.drawn(closed);
            let lighting = room.renderer.light(&snapshot, &day);
            // The tone curve would turn noise into a loss of brightness.
            let how = PathTracing { samples: 256, brightest: f32::INFINITY, ..PathTracing::default() };
            let reference_picture =
                room.renderer.reference_picture(&lighting, &at_the_floor().resized(24, 18), &how, |_| true).unwrap();
            let mean = |pixels: &[[u8; 3]]| {
                pixels.as_flattened().iter().map(|v| f64::from(*v)).sum::<f64>() / (3 * pixels.len()) as f64
            };
            mean(&room.frame(&snapshot, &lighting, &at_the_floor()).rgb) - mean(&reference_picture.picture().pixels)
        };
        let (open, closed) = (level(false), level(true));
        eprintln!("fast brighter by {open:.1} when open, {closed:.1} when closed");
        assert!((open - closed).abs() < 12.0, "{open} brighter when open, {closed} when closed");
    }
}

#[test]
fn few_paths_find_the_light_behind_a_drawn_cover() {
    for (kind, day) in [(Kind::Blinds, sunny()), (Kind::Curtains, Daylight::overcast())] {
        let room = Room::new(kind, true);
        let lighting = room.renderer.light(&room.snapshot, &day);
        let made = |samples: u32, seed: u32, brightest: f32| {
            let how = PathTracing { samples, seed, brightest, denoise: false, ..PathTracing::default() };
            let made =
                room.renderer.reference_picture(&lighting, &at_the_floor().resized(16, 12), &how, |_| true).unwrap();
            made.light.iter().map(|c| f64::from(c[1])).collect::<Vec<f64>>()
        };
        let mean = |light: &[f64]| light.iter().sum::<f64>() / light.len() as f64;
        let (many, few) = (made(1500, 0, f32::INFINITY), made(200, 1, f32::INFINITY));
        let usual = made(64, 2, PathTracing::default().brightest);
        let off: f64 = usual.iter().zip(&many).map(|(a, b)| (a - b) * (a - b)).sum();
        let ([few, usual], many, count) = ([&few, &usual].map(|l| mean(l)), mean(&many), usual.len() as f64);
        let noise = (off / count).sqrt() / many;
        eprintln!("{many:.4} of many paths, {few:.4} of few, {usual:.4} of those cut off, noise {noise:.3}");
        assert!((few / many - 1.0).abs() < 0.06, "{few} of few paths, {many} of many");
        assert!(usual > 0.7 * many, "{usual} where bright paths are cut off, {many} where they are not");
        assert!(noise < 1.0, "noise {noise} with 64 paths");
    }
}

#[test]
fn drawn_covers_glow_in_fast_pictures_as_in_the_reference() {
    for (kind, day) in [(Kind::Blinds, sunny()), (Kind::Curtains, Daylight::overcast())] {
        let room = Room::new(kind, true);
        let lighting = room.renderer.light(&room.snapshot, &day);
        let camera = at_the_window().resized(32, 24);
        let frame = room.frame(&room.snapshot, &lighting, &camera);
        let how = PathTracing { samples: 256, brightest: f32::INFINITY, ..PathTracing::default() };
        let reference = room.renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap().picture();
        let mean = |pixels: &[[u8; 3]], cover: bool| {
            let of = |id: &NodeId| room.covers.contains(id) == cover;
            let all = pixels.iter().zip(&frame.instance).filter(|(_, id)| of(id));
            let (sum, count) =
                all.fold((0.0, 0), |(s, n), (c, _)| (s + c.iter().map(|v| f64::from(*v)).sum::<f64>(), n + 3));
            sum / f64::from(count)
        };
        let levels = [&frame.rgb, &reference.pixels].map(|p| [mean(p, true), mean(p, false)]);
        eprintln!("covers and what is around them: {levels:?}");
        let [[fast, around], [slow, _]] = levels;
        assert!(fast > around && (fast - slow).abs() < 25.0, "{levels:?}");
    }
}

#[test]
fn what_hangs_at_no_window_stays_as_it_is() {
    let mut stage = Stage::new();
    let asset = stage.asset(vec![part("cloth", block([0.01, 0.2, 0.8]), [0.0; 3], 0)]);
    let curtain = stage.put("curtain", asset, Pose::translation(2.0, 0.0, 0.0));
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let mut drawn = snapshot.clone();
    drawn.draw_cover(curtain, true).unwrap();
    assert!(drawn.draw_cover(NodeId(999), true).is_err());
    let camera = Camera::with_fov(48, 36, 1.2);
    let of = |snapshot: &Snapshot| {
        let mut frame = Frame::new();
        renderer.render(&Shot::new(snapshot, &camera, Modality::Depth), &mut frame).unwrap();
        frame.depth
    };
    assert_eq!(of(&drawn), of(&snapshot));
}
