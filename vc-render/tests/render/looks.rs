//! Colours show the effects of light: mirrors, glass, the sun's patch on the floor, dark corners; and the two
//! kinds of pictures agree.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::Caster;
use common::{Stage, block, cameras, lamplit, material, part, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape};
use vc_graph::{Draft, NodeId, Pose};
use vc_render::{Camera, Daylight, Frame, Lighting, Modality, PathTracing, Renderer, Shot, Snapshot};

struct Shown {
    renderer: Renderer,
    snapshot: Snapshot,
    lighting: Lighting,
    caster: Caster,
}

impl Shown {
    /// A scene with everything switched on that can be.
    fn new(stage: Stage, daylight: &Daylight) -> Self {
        let graph = stage.build();
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&graph).unwrap();
        snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
        let lighting = renderer.light(&snapshot, daylight);
        Self { renderer, snapshot, lighting, caster: Caster::new(&graph, 0.0005) }
    }

    fn frame(&self, camera: &Camera, plain: bool) -> Frame {
        let wanted = Modality::Rgb | Modality::Instance | Modality::Position | Modality::Normal;
        let shot = Shot::new(&self.snapshot, camera, wanted).lit(&self.lighting);
        let mut frame = Frame::new();
        self.renderer.render(&if plain { shot.unshadowed() } else { shot }, &mut frame).unwrap();
        frame
    }

    /// The first hit of a ray from a point, and its distance.
    fn met(&self, from: Point3<f32>, along: Vector3<f32>) -> Option<(NodeId, f64)> {
        let camera = Camera { near: 1e-4, ..Camera::with_fov(1, 1, 0.1) }.looking(from, from + along);
        self.caster.cast(&camera, 0.5, 0.5).map(|hit| (hit.node, hit.depth))
    }
}

/// A floor, a ceiling and walls around 4 by 4 by 2.6 metres, without the wall at x = 2.
fn three_walls() -> Stage {
    let mut stage = Stage::new();
    stage.one("floor", block([2.0, 2.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 1);
    stage.one("ceiling", block([2.2, 2.2, 0.1]), Pose::translation(0.0, 0.0, 2.7), 1);
    stage.one("wall", block([0.1, 2.0, 1.3]), Pose::translation(-2.1, 0.0, 1.3), 1);
    for side in [-1.0, 1.0] {
        stage.one("wall", block([2.2, 0.1, 1.3]), Pose::translation(0.0, 2.1 * side, 1.3), 1);
    }
    stage
}

/// The same room with a wall at x = 2 that has an opening of 1 by 1.2 metres.
fn windowed() -> Stage {
    let mut stage = three_walls();
    for side in [-1.0, 1.0] {
        stage.one("wall", block([0.1, 0.75, 1.3]), Pose::translation(2.1, 1.25 * side, 1.3), 1);
    }
    stage.one("wall", block([0.1, 0.5, 0.45]), Pose::translation(2.1, 0.0, 0.45), 1);
    stage.one("wall", block([0.1, 0.5, 0.25]), Pose::translation(2.1, 0.0, 2.35), 1);
    stage
}

fn even() -> Daylight {
    let one = Vector3::repeat(1.0);
    Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() }
}

fn sum(pixel: [u8; 3]) -> f64 {
    pixel.iter().map(|v| f64::from(*v)).sum()
}

#[test]
fn mirrors_show_what_rays_say() {
    let mut stage = three_walls();
    let [red, blue] = [[0.8, 0.03, 0.03], [0.03, 0.03, 0.8]]
        .map(|c| stage.library.add_material(Material { roughness: 1.0, ..material("plain", c) }).unwrap());
    let glass = stage.one("mirror", block([0.1, 2.0, 1.3]), Pose::translation(2.1, 0.0, 1.3), 4);
    let red = stage.one("box", block([0.4, 0.3, 0.4]), pose([-1.2, 1.2, 0.9], 0.4, 0.2), red);
    let blue = stage.one("ball", Shape::Sphere { radius: 0.4 }, Pose::translation(-1.0, -1.0, 1.5), blue);
    stage.one("ceiling_lamp", block([0.3, 0.3, 0.02]), Pose::translation(0.3, 0.0, 2.55), 3);
    let shown = Shown::new(stage, &Daylight::night());
    let camera = Camera::with_fov(120, 90, 1.2).looking(Point3::new(-0.2, 0.1, 1.3), Point3::new(2.0, 0.0, 1.3));
    let frame = shown.frame(&camera, false);
    let (mut seen, mut wrong, mut all) = ([0; 2], 0, 0);
    for (i, rgb) in frame.rgb.iter().enumerate().filter(|(i, _)| frame.instance[*i] == glass) {
        let (at, normal) = (Point3::from(frame.position[i]), Vector3::from(frame.normal[i]));
        let to = (at - camera.eye()).normalize();
        let met = shown.met(at + normal * 1e-3, to - normal * (2.0 * to.dot(&normal))).map(|m| m.0);
        let (reddish, bluish) =
            (f64::from(rgb[0]) > 1.6 * f64::from(rgb[2]), f64::from(rgb[2]) > 1.6 * f64::from(rgb[0]));
        all += 1;
        wrong += usize::from((met == Some(red)) != reddish || (met == Some(blue)) != bluish);
        seen[0] += usize::from(met == Some(red));
        seen[1] += usize::from(met == Some(blue));
    }
    assert!(seen.iter().all(|n| *n > 60), "{seen:?} of {all} pixels");
    // Edges are smoothed.
    assert!(wrong * 40 < all, "{wrong} of {all} pixels of the mirror show something else; {seen:?}");
}

#[test]
fn glass_is_a_thing_that_is_seen_through() {
    let made = |pane: bool| {
        let mut stage = three_walls();
        let red =
            stage.library.add_material(Material { roughness: 1.0, ..material("plain", [0.7, 0.1, 0.1]) }).unwrap();
        stage.one("box", block([0.4, 0.4, 0.4]), Pose::translation(1.0, 0.0, 1.2), red);
        let node = pane.then(|| stage.one("window", block([0.005, 0.6, 0.6]), Pose::translation(0.0, 0.0, 1.2), 2));
        (Shown::new(stage, &even()), node)
    };
    let ((clear, node), (open, _)) = (made(true), made(false));
    let camera = Camera::with_fov(60, 60, 0.7).looking(Point3::new(-1.5, 0.0, 1.2), Point3::new(0.0, 0.0, 1.2));
    let (through, bare) = (clear.frame(&camera, false), open.frame(&camera, false));
    let middle = 30 * 60 + 30;
    assert_eq!(Some(through.instance[middle]), node);
    let (a, b) = (through.rgb[middle], bare.rgb[middle]);
    assert!(2 * i32::from(a[0]) > 3 * i32::from(a[1]) && b[0] / 2 > b[1], "{a:?} and {b:?}");
    assert!(sum(a) > 0.7 * sum(b) && sum(a) < 1.3 * sum(b), "{a:?} through glass, {b:?} without");
    // The reference picture agrees.
    let how = PathTracing { samples: 64, ..PathTracing::default() };
    let [a, b] = [&clear, &open]
        .map(|s| s.renderer.reference_picture(&s.lighting, &camera, &how, |_| true).unwrap().light[middle]);
    assert!(a[0] > 3.0 * a[1] && a[0] > 0.6 * b[0] && a[0] < 1.05 * b[0], "{a:?} through glass, {b:?} without");
}

#[test]
fn the_sun_throws_the_windows_shape_on_the_floor() {
    let towards = Vector3::new(1.0, 0.25, 0.9).normalize();
    let shown = Shown::new(windowed(), &Daylight { towards_sun: towards, ..Daylight::noon() });
    let camera = Camera::with_fov(120, 90, 1.3).looking(Point3::new(-1.7, 0.3, 2.3), Point3::new(0.6, -0.1, 0.0));
    let frame = shown.frame(&camera, false);
    let floor = frame.instance[70 * 120 + 60];
    let sunny = |p: Point3<f32>| shown.met(p + Vector3::z() * 2e-3, towards).is_none();
    let (mut lit, mut dark) = (Vec::new(), Vec::new());
    for (i, rgb) in frame.rgb.iter().enumerate().filter(|(i, _)| frame.instance[*i] == floor) {
        let at = Point3::from(frame.position[i]);
        let own = sunny(at);
        // The sun is a disc, so the edges of its patch are soft.
        let around = [(0.08, 0.0), (-0.08, 0.0), (0.0, 0.08), (0.0, -0.08)];
        if around.iter().all(|(x, y)| sunny(at + Vector3::new(*x, *y, 0.0)) == own) {
            if own { &mut lit } else { &mut dark }.push(sum(*rgb));
        }
    }
    assert!(lit.len() > 150 && dark.len() > 1000, "{} and {} pixels", lit.len(), dark.len());
    lit.sort_by(f64::total_cmp);
    dark.sort_by(f64::total_cmp);
    let (least, most) = (lit[lit.len() / 100], dark[dark.len() - 1 - dark.len() / 100]);
    assert!(least > 1.2 * most, "{least} in the sun, {most} in the shade");
}

#[test]
fn corners_are_darker_than_open_floor() {
    let mut stage = Stage::new();
    stage.one("floor", block([6.0, 6.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 1);
    stage.one("wall", block([0.1, 6.0, 1.5]), Pose::translation(2.1, 0.0, 1.5), 1);
    let shown = Shown::new(stage, &even());
    let camera = Camera::with_fov(160, 120, 0.9).looking(Point3::new(-0.5, 0.0, 1.5), Point3::new(1.6, 0.0, 0.0));
    let strip = |frame: &Frame, from: f32, to: f32| {
        let on = |i: &usize| frame.position[*i][2].abs() < 1e-3 && (from..to).contains(&(2.0 - frame.position[*i][0]));
        let levels: Vec<f64> = (0..frame.rgb.len()).filter(on).map(|i| sum(frame.rgb[i])).collect();
        assert!(levels.len() > 50);
        levels.iter().sum::<f64>() / levels.len() as f64
    };
    let [full, plain] = [false, true].map(|plain| {
        let frame = shown.frame(&camera, plain);
        strip(&frame, 0.03, 0.12) / strip(&frame, 1.0, 1.4)
    });
    assert!(full < 0.96 && full < 0.965 * plain, "{full} of the light in the corner, {plain} without occlusion");
    assert!((0.85..1.1).contains(&plain), "{plain}");
}

fn lamp_lit() -> (Renderer, Snapshot, Lighting) {
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&lamplit()).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::night());
    (renderer, snapshot, lighting)
}

#[test]
fn fast_colours_are_near_those_of_the_reference() {
    let (renderer, snapshot, lighting) = lamp_lit();
    for camera in cameras(64, 48) {
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        let how = PathTracing { samples: 64, ..PathTracing::default() };
        let picture = renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap().picture();
        let channels = || frame.rgb.as_flattened().iter().zip(picture.pixels.as_flattened());
        let count = channels().count() as f64;
        let bias = channels().map(|(a, b)| f64::from(*a) - f64::from(*b)).sum::<f64>() / count;
        let off = channels().map(|(a, b)| (f64::from(*a) - f64::from(*b)).abs()).sum::<f64>() / count;
        eprintln!("off by {off:.1} of 255, {bias:.1} too bright");
        assert!(off < 16.0 && bias.abs() < 10.0, "off by {off}, {bias} too bright");
    }
}

fn mean(light: &[[f32; 3]]) -> f64 {
    light.iter().map(|c| f64::from(c[1])).sum::<f64>() / light.len() as f64
}

#[test]
fn smoothing_takes_noise_away_and_leaves_the_light() {
    let (renderer, _, lighting) = lamp_lit();
    let camera = cameras(48, 36)[1];
    let of = |samples: u32, seed: u32, denoise: bool| {
        let how = PathTracing { samples, seed, denoise, brightest: f32::INFINITY, ..PathTracing::default() };
        renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap().light
    };
    let truth = of(512, 9, false);
    // Relative to the brightness at each pixel.
    let error = |light: &[[f32; 3]]| {
        let square = |(a, b): (&[f32; 3], &[f32; 3])| f64::from((a[1] - b[1]) / (b[1] + 0.1)).powi(2);
        light.iter().zip(&truth).map(square).sum::<f64>() / light.len() as f64
    };
    for (samples, left, loss) in [(8, 0.4, 0.12), (32, 0.8, 0.06)] {
        let (raw, smooth) = (of(samples, 1, false), of(samples, 1, true));
        eprintln!(
            "{samples} paths: error {:.4} to {:.4}, mean {:.4}, {:.4}, {:.4}",
            error(&raw),
            error(&smooth),
            mean(&truth),
            mean(&raw),
            mean(&smooth)
        );
        // Fireflies are dimmed, which takes a little light.
        assert!(error(&smooth) < left * error(&raw), "{} to {}", error(&raw), error(&smooth));
        assert!((mean(&smooth) / mean(&raw) - 1.0).abs() < loss, "{} to {}", mean(&raw), mean(&smooth));
    }
}

/// A thin closed pane, each side divided into `cuts` by `cuts` squares.
fn pane(cuts: u32, half: [f32; 2], thick: f32) -> Shape {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let row = cuts + 1;
    for x in [thick, -thick] {
        for i in 0..row * row {
            let at = |k: u32| 2.0 * k as f32 / cuts as f32 - 1.0;
            vertices.push(Point3::new(x, at(i % row) * half[0], at(i / row) * half[1]));
        }
    }
    for i in (0..row * row).filter(|i| i % row < cuts && i / row < cuts) {
        let square = [i, i + 1, i + row + 1, i + row];
        let back = square.map(|v| v + row * row);
        triangles.extend([[square[0], square[1], square[2]], [square[0], square[2], square[3]]]);
        triangles.extend([[back[2], back[1], back[0]], [back[3], back[2], back[0]]]);
        // The rim, which closes it.
        let ends = [i / row == 0, i % row == cuts - 1, i / row == cuts - 1, i % row == 0];
        for side in (0..4).filter(|side| ends[*side]) {
            let next = (side + 1) % 4;
            triangles.extend([[square[next], square[side], back[side]], [square[next], back[side], back[next]]]);
        }
    }
    Shape::Mesh { vertices, triangles, uvs: Vec::new() }
}

#[test]
fn light_through_windows_is_the_same_however_it_is_looked_for() {
    // Large pane triangles are sampled deliberately, small ones are hit by chance: the light is the same.
    let floor = |cuts: u32| {
        let mut stage = windowed();
        stage.one("window", pane(cuts, [0.5, 0.6], 0.003), Pose::translation(2.1, 0.0, 1.5), 2);
        let shown = Shown::new(stage, &Daylight::overcast());
        let camera = Camera::with_fov(8, 6, 0.5).looking(Point3::new(-1.0, 0.0, 2.0), Point3::new(0.2, 0.0, 0.0));
        let of = |seed: u32| {
            let how = PathTracing { samples: 1500, brightest: f32::INFINITY, bounces: 3, denoise: false, seed };
            mean(&shown.renderer.reference_picture(&shown.lighting, &camera, &how, |_| true).unwrap().light)
        };
        [of(1), of(2)]
    };
    let (aimed, chance) = (floor(1), floor(10));
    eprintln!("{aimed:?} {chance:?}");
    let (own, wanted) = (0.5 * (aimed[0] + aimed[1]), 0.5 * (chance[0] + chance[1]));
    assert!((own / wanted - 1.0).abs() < 0.03, "{aimed:?} on purpose, {chance:?} by chance");
}

#[test]
fn panes_dim_fast_light_as_they_dim_the_references() {
    // Both pictures are exposed for the fast light: if panes dimmed it more or less than the reference's light,
    // the difference between the two pictures would change from clear to dark glass.
    let dark = |smoked: bool, sun: bool| {
        let mut stage = windowed();
        let (transmission, share) = if smoked { (0.5, 0.8) } else { (1.0, 0.9) };
        let pane = Material { transmission, roughness: 0.02, ..material("clear_glass", [share; 3]) };
        let number = stage.library.add_material(pane).unwrap();
        stage.one("window", block([0.003, 0.5, 0.6]), Pose::translation(2.1, 0.0, 1.5), number);
        let towards_sun = Vector3::new(1.0, 0.25, 0.9).normalize();
        let day = if sun { Daylight { towards_sun, ..Daylight::noon() } } else { Daylight::overcast() };
        Shown::new(stage, &day)
    };
    let camera = Camera::with_fov(32, 24, 1.2).looking(Point3::new(-1.6, -0.4, 2.2), Point3::new(0.2, 0.8, 0.4));
    for sun in [false, true] {
        let level = |smoked: bool| {
            let shown = dark(smoked, sun);
            let how = PathTracing { samples: 256, brightest: f32::INFINITY, ..PathTracing::default() };
            let reference =
                shown.renderer.reference_picture(&shown.lighting, &camera, &how, |_| true).unwrap().picture();
            let mean = |pixels: &[[u8; 3]]| pixels.iter().map(|p| sum(*p)).sum::<f64>() / (3 * pixels.len()) as f64;
            mean(&shown.frame(&camera, false).rgb) - mean(&reference.pixels)
        };
        let (clear, smoked) = (level(false), level(true));
        eprintln!("sun {sun}: fast brighter by {clear:.1} behind clear glass, {smoked:.1} behind dark glass");
        assert!((clear - smoked).abs() < 6.0, "sun {sun}: {clear} brighter behind clear glass, {smoked} behind dark");
    }
}

#[test]
fn an_eye_that_sees_a_brighter_room_gets_used_to_it() {
    // Two rooms side by side, one with a strong lamp, one with a candle, connected only by a doorway.
    let mut stage = Stage::new();
    let dim = stage.room;
    let bright = stage.builder.add(Draft::new("kitchen")).unwrap();
    let mut put = |room: NodeId, class: &str, half: [f32; 3], at: [f32; 3], material: u32| {
        let asset = stage.asset(vec![part(class, block(half), [0.0; 3], material)]);
        let draft = Draft { asset: Some(asset), ..Draft::new(class).at(pose(at, 0.0, 0.0)) };
        stage.builder.add_in(room, draft).unwrap()
    };
    let mut lamps = Vec::new();
    for (room, x) in [(dim, -2.0), (bright, 2.0)] {
        put(room, "floor", [2.0, 2.0, 0.1], [x, 0.0, -0.1], 1);
        put(room, "ceiling", [2.0, 2.0, 0.1], [x, 0.0, 2.7], 1);
        put(room, "wall", [2.0, 0.1, 1.3], [x, 2.1, 1.3], 1);
        put(room, "wall", [2.0, 0.1, 1.3], [x, -2.1, 1.3], 1);
        put(room, "wall", [0.1, 2.0, 1.3], [2.05 * x, 0.0, 1.3], 1);
        let size = if room == bright { [0.4, 0.4, 0.02] } else { [0.03, 0.03, 0.02] };
        lamps.push(put(room, if room == bright { "ceiling_lamp" } else { "candle" }, size, [x, 0.0, 2.5], 3));
    }
    put(dim, "wall", [0.02, 0.7, 1.3], [0.0, 1.3, 1.3], 1);
    put(dim, "wall", [0.02, 0.7, 1.3], [0.0, -1.3, 1.3], 1);
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::night());
    let eye = Point3::new(-2.0, 0.0, 1.4);
    // The same piece of floor, seen with and without the doorway above it.
    let look = |target: Point3<f32>| Camera::with_fov(80, 60, 1.2).looking(eye, target);
    let mut frame = Frame::new();
    let mut seen = |camera: &Camera| {
        let wanted = Modality::Rgb | Modality::Position;
        renderer.render(&Shot::new(&snapshot, camera, wanted).lit(&lighting), &mut frame).unwrap();
        let place = |at: &[f32; 3]| at[2].abs() < 0.01 && (-0.9..-0.5).contains(&at[0]) && at[1].abs() < 0.3;
        let sums = frame.position.iter().zip(&frame.rgb).filter(|(at, _)| place(at)).map(|(_, rgb)| sum(*rgb));
        let (count, total) = sums.fold((0, 0.0), |(n, all), v| (n + 1, all + v));
        assert!(count > 10, "{count} pixels of the floor");
        total / f64::from(count)
    };
    let (down, ahead) = (seen(&look(Point3::new(-0.8, 0.0, -0.3))), seen(&look(Point3::new(-0.2, 0.0, 0.7))));
    assert!(ahead < 0.97 * down, "the floor is {ahead} beside the bright room, {down} without it");
}
