//! Light through openings: the same pane as a box or as a sheet, the sun through an opening without a pane, and
//! the resulting light of rooms in fast pictures.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material, part};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::{Material, Shape};
use vc_render::{Camera, Daylight, Frame, Lighting, Modality, PathTracing, Renderer, Shot, Snapshot};

const TOWARDS: [f32; 3] = [1.0, 0.25, 0.9];

struct Lit {
    renderer: Renderer,
    snapshot: Snapshot,
    lighting: Lighting,
}

impl Lit {
    fn new(stage: Stage, daylight: &Daylight) -> Self {
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(&stage.build()).unwrap();
        let lighting = renderer.light(&snapshot, daylight);
        Self { renderer, snapshot, lighting }
    }

    /// Mean light in each colour of a reference picture.
    fn reference(&self, camera: &Camera, how: PathTracing) -> [f64; 3] {
        let light = self.renderer.reference_picture(&self.lighting, camera, &how, |_| true).unwrap().light;
        [0, 1, 2].map(|i: usize| light.iter().map(|c| f64::from(c[i])).sum::<f64>() / light.len() as f64)
    }

    fn fast(&self, camera: &Camera) -> Frame {
        let mut frame = Frame::new();
        let shot = Shot::new(&self.snapshot, camera, Modality::Rgb).lit(&self.lighting);
        self.renderer.render(&shot, &mut frame).unwrap();
        frame
    }
}

/// A closed room of 4 by 4 by 2.6 metres of one material, except for an opening of 1 by 1.2 metres at x = 2.
fn room(walls: Material, floor: Material) -> (Stage, u32) {
    let mut stage = Stage::new();
    let [walls, floor] = [walls, floor].map(|m| stage.library.add_material(m).unwrap());
    stage.one("floor", block([2.0, 2.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), floor);
    stage.one("ceiling", block([2.2, 2.2, 0.1]), Pose::translation(0.0, 0.0, 2.7), walls);
    stage.one("wall", block([0.1, 2.0, 1.3]), Pose::translation(-2.1, 0.0, 1.3), walls);
    for side in [-1.0, 1.0] {
        stage.one("wall", block([2.2, 0.1, 1.3]), Pose::translation(0.0, 2.1 * side, 1.3), walls);
        stage.one("wall", block([0.1, 0.75, 1.3]), Pose::translation(2.1, 1.25 * side, 1.3), walls);
    }
    stage.one("wall", block([0.1, 0.5, 0.45]), Pose::translation(2.1, 0.0, 0.45), walls);
    stage.one("wall", block([0.1, 0.5, 0.25]), Pose::translation(2.1, 0.0, 2.35), walls);
    (stage, walls)
}

fn matt(share: f32) -> Material {
    Material { roughness: 1.0, ..material("plain", [share; 3]) }
}

fn glazed(sheet: bool, daylight: &Daylight) -> Lit {
    let (mut stage, _) = room(matt(0.7), matt(0.7));
    let glass = Material { transmission: 0.8, roughness: 0.02, ..material("clear_glass", [0.9, 0.6, 0.3]) };
    let glass = stage.library.add_material(glass).unwrap();
    let corners = [[-0.5, -0.6], [0.5, -0.6], [0.5, 0.6], [-0.5, 0.6]].map(|[y, z]| Point3::new(0.0, y, z));
    let flat = Shape::Mesh { vertices: corners.to_vec(), triangles: vec![[0, 1, 2], [0, 2, 3]], uvs: Vec::new() };
    let pane = if sheet { flat } else { block([0.002, 0.5, 0.6]) };
    stage.one("window", pane, Pose::translation(2.1, 0.0, 1.5), glass);
    Lit::new(stage, daylight)
}

#[test]
fn a_pane_lets_in_the_same_light_as_a_box_and_as_a_sheet() {
    let sunny = Daylight { towards_sun: Vector3::from(TOWARDS).normalize(), ..Daylight::noon() };
    let camera = Camera::with_fov(16, 12, 1.0).looking(Point3::new(-1.8, -0.4, 2.0), Point3::new(0.4, 0.3, 0.0));
    for (name, day) in [("overcast", Daylight::overcast()), ("sun", sunny)] {
        let [solid, sheet] = [false, true].map(|sheet| glazed(sheet, &day));
        let how = PathTracing { samples: 600, brightest: f32::INFINITY, denoise: false, ..PathTracing::default() };
        let (a, b) = (solid.reference(&camera, how), sheet.reference(&camera, how));
        eprintln!("{name}: {a:.4?} through a box, {b:.4?} through a sheet");
        a.iter().zip(&b).for_each(|(a, b)| assert!((b / a - 1.0).abs() < 0.04, "{name}: {a} and {b}"));
        let (a, b) = (solid.fast(&camera), sheet.fast(&camera));
        let off = a.rgb.as_flattened().iter().zip(b.rgb.as_flattened()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(off <= 3, "{name}: fast colours differ by {off}");
    }
}

#[test]
fn what_is_seen_through_a_pane_is_the_same_through_a_box_and_through_a_sheet() {
    let camera = Camera::with_fov(6, 6, 0.3).looking(Point3::new(0.0, 0.0, 1.5), Point3::new(2.1, 0.0, 1.5));
    let [solid, sheet] = [false, true].map(|sheet| glazed(sheet, &Daylight::overcast()));
    let how = PathTracing { samples: 2000, brightest: f32::INFINITY, denoise: false, ..PathTracing::default() };
    let (a, b) = (solid.reference(&camera, how), sheet.reference(&camera, how));
    eprintln!("{a:.4?} through a box, {b:.4?} through a sheet");
    a.iter().zip(&b).for_each(|(a, b)| assert!((b / a - 1.0).abs() < 0.03, "{a} and {b}"));
}

/// Daylight with the sun only.
fn sun() -> Daylight {
    let (towards_sun, dark) = (Vector3::from(TOWARDS).normalize(), Vector3::zeros());
    Daylight { towards_sun, zenith: dark, horizon: dark, ground: dark, ..Daylight::noon() }
}

#[test]
fn the_sun_through_a_bare_opening_is_as_bright_as_it_is() {
    let (black, grey) = (matt(0.0), matt(0.5));
    let lit = Lit::new(room(black, grey).0, &sun());
    // The centre of the opening is 1.5 metres high; its image on the floor is where the sun's ray through it
    // ends.
    let day = sun();
    let along = day.towards_sun / day.towards_sun.z;
    let at = Point3::new(2.1 - 1.5 * along.x, -1.5 * along.y, 0.0);
    let camera = Camera::with_fov(4, 4, 0.05).looking(Point3::new(-1.0, 0.8, 2.0), at);
    let light = lit.reference(&camera, PathTracing { samples: 64, denoise: false, ..PathTracing::default() });
    for (i, light) in light.into_iter().enumerate() {
        let wanted = f64::from(0.5 / std::f32::consts::PI * day.sun[i] * day.towards_sun.z);
        assert!((light / wanted - 1.0).abs() < 0.01, "{light}, not {wanted}");
    }
}

#[test]
fn what_the_sun_lights_through_a_bare_opening_lights_the_room() {
    let lit = Lit::new(room(matt(0.7), matt(0.7)).0, &sun());
    // Measured at the ceiling, which the sun does not reach.
    let camera = Camera::with_fov(8, 6, 0.6).looking(Point3::new(-1.0, 0.0, 1.0), Point3::new(0.4, 0.0, 2.6));
    let of = |samples: u32, brightest: f32| {
        let how = PathTracing { samples, brightest, denoise: false, ..PathTracing::default() };
        lit.reference(&camera, how)[1]
    };
    let (truth, usual) = (of(4000, f32::INFINITY), of(400, PathTracing::default().brightest));
    eprintln!("{truth:.4} and {usual:.4} with specks cut off");
    assert!((usual / truth - 1.0).abs() < 0.05, "{truth}, {usual} with specks cut off");
}

#[test]
fn what_is_seen_through_a_pane_is_smooth() {
    // The pane is within a room, like the door of a cupboard.
    let noise = |pane: bool| {
        let (mut stage, _) = room(matt(0.7), matt(0.7));
        if pane {
            stage.one("cabinet", block([0.004, 0.7, 0.7]), Pose::translation(-1.0, 0.0, 1.3), 2);
        }
        let lit = Lit::new(stage, &Daylight::overcast());
        let camera = Camera::with_fov(48, 36, 0.5).looking(Point3::new(1.0, 0.2, 1.4), Point3::new(-2.0, 0.1, 1.2));
        let [a, b] = [1, 2].map(|seed| {
            let how = PathTracing { samples: 16, seed, ..PathTracing::default() };
            lit.renderer.reference_picture(&lit.lighting, &camera, &how, |_| true).unwrap().light
        });
        let square: f32 = a.iter().zip(&b).map(|(a, b)| (a[1] - b[1]) * (a[1] - b[1])).sum();
        let mean = a.iter().map(|c| c[1]).sum::<f32>() / a.len() as f32;
        (0.5 * square / a.len() as f32).sqrt() / mean
    };
    let [bare, behind] = [false, true].map(noise);
    eprintln!("noise {bare:.4} without a pane, {behind:.4} behind one");
    // Noise from its reflection of the window remains. If reflections were left to chance, it would be 26 times
    // as much.
    assert!(behind < 4.0 * bare, "{behind} behind a pane, {bare} without");
}

/// Inverts the tone curve by bisection.
fn film_undone(shown: f64) -> f64 {
    let film = |light: f64| {
        let strength = light.powf(1.2) / (1.0 + (light / 2.0).powi(4)).powf(0.15);
        strength / (1.0 + strength)
    };
    let half = |(low, high): (f64, f64)| {
        let middle = 0.5 * (low + high);
        if film(middle) < shown { (middle, high) } else { (low, middle) }
    };
    (0..60).fold((0.0, 1e3), |within, _| half(within)).0
}

/// Mean light in each colour of a picture's bytes, up to its exposure, by inverting the tone curve.
fn undone(pixels: &[[u8; 3]]) -> [f64; 3] {
    let light = |byte: u8| {
        let v = f64::from(byte) / 255.0;
        let shown = if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        film_undone(shown)
    };
    [0, 1, 2].map(|c: usize| pixels.iter().map(|p| light(p[c])).sum::<f64>() / pixels.len() as f64)
}

/// The ratio of a fast picture's brightness to the reference's, and the ratios of red and blue relative to
/// green.
fn brighter(lit: &Lit, camera: &Camera) -> [f64; 3] {
    let how = PathTracing { samples: 256, brightest: f32::INFINITY, ..PathTracing::default() };
    let reference = lit.renderer.reference_picture(&lit.lighting, camera, &how, |_| true).unwrap().picture();
    let (fast, wanted) = (undone(&lit.fast(camera).rgb), undone(&reference.pixels));
    let [red, green, blue] = [0, 1, 2].map(|c: usize| fast[c] / wanted[c]);
    [green, red / green, blue / green]
}

#[test]
fn fast_light_in_a_room_of_wood_and_cloth_has_the_references_hue() {
    // Patterns darken both, and most of the light has been reflected many times.
    let walls = Material { roughness: 0.9, ..material("linen", [0.9, 0.85, 0.75]) };
    let floor = Material { roughness: 0.5, ..material("oak", [0.6, 0.4, 0.2]) };
    let lit = Lit::new(room(walls, floor).0, &Daylight::overcast());
    let camera = Camera::with_fov(48, 36, 1.2).looking(Point3::new(1.6, 0.6, 1.6), Point3::new(-1.0, -0.4, 1.2));
    let [bright, red, blue] = brighter(&lit, &camera);
    eprintln!("{bright:.3} times as bright, red {red:.3}, blue {blue:.3}");
    assert!((0.9..1.12).contains(&bright), "{bright} times as bright");
    assert!((red - 1.0).abs() < 0.03 && (blue - 1.0).abs() < 0.03, "red {red}, blue {blue}");
}

#[test]
fn a_shade_keeps_away_as_much_of_a_lamps_fast_light_as_of_the_references() {
    let (mut stage, _) = room(matt(0.7), matt(0.5));
    let bulb = Material { emission: [30.0; 3], ..material("bulb", [0.9; 3]) };
    let [bulb, dark] = [bulb, matt(0.1)].map(|m| stage.library.add_material(m).unwrap());
    // The shade is black and open below.
    let side = |x: f32, y: f32| {
        let half = [if x == 0.0 { 0.1 } else { 0.004 }, if y == 0.0 { 0.1 } else { 0.004 }, 0.1];
        part("housing", block(half), [0.1 * x, 0.1 * y, 0.0], dark)
    };
    let mut parts = vec![part("bulb", Shape::Sphere { radius: 0.04 }, [0.0; 3], bulb)];
    parts.push(part("housing", block([0.1, 0.1, 0.004]), [0.0, 0.0, 0.1], dark));
    parts.extend([side(1.0, 0.0), side(-1.0, 0.0), side(0.0, 1.0), side(0.0, -1.0)]);
    let asset = stage.asset(parts);
    let lamp = stage.put("ceiling_lamp", asset, Pose::translation(0.0, 0.0, 1.9));
    let mut lit = Lit::new(stage, &Daylight::night());
    lit.snapshot.switch(lamp, true).unwrap();
    lit.lighting = lit.renderer.light(&lit.snapshot, &Daylight::night());
    let camera = Camera::with_fov(48, 36, 1.0).looking(Point3::new(1.7, 1.4, 1.5), Point3::new(-0.6, -0.5, 0.3));
    let [bright, red, blue] = brighter(&lit, &camera);
    eprintln!("{bright:.3} times as bright, red {red:.3}, blue {blue:.3}");
    assert!((0.88..1.14).contains(&bright), "{bright} times as bright");
}
