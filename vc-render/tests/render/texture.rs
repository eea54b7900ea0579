//! Image textures follow their coordinates, in fast colours and in reference pictures.

#![allow(clippy::unwrap_used)]

use crate::common;

use std::sync::Arc;

use common::{Stage, material};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape, Texture};
use vc_graph::{Draft, Pose, SceneGraph};
use vc_render::{Adaptation, Camera, Daylight, Frame, Lighting, Modality, PathTracing, Renderer, Shot, Snapshot};

/// Colours of blocks of texels, rows from the top.
const BLOCKS: [[[u8; 3]; 4]; 3] = [
    [[250, 20, 20], [20, 250, 20], [20, 20, 250], [250, 250, 250]],
    [[90, 90, 90], [250, 250, 20], [20, 250, 250], [250, 20, 250]],
    [[20, 20, 20], [160, 90, 40], [40, 90, 160], [200, 140, 200]],
];
/// Number of texels along a side of a block.
const SIDE: usize = 8;

fn linear(byte: u8) -> f32 {
    let v = f32::from(byte) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

fn blocks() -> Texture {
    let (width, height) = (4 * SIDE, 3 * SIDE);
    let pixels = (0..width * height).map(|i| BLOCKS[i / width / SIDE][i % width / SIDE]).collect();
    Texture { name: "blocks".into(), width: width as u32, height: height as u32, pixels }
}

/// A board of 0.8 by 0.6 metres that faces -x, its texture upright and not mirrored.
fn board(uvs: bool) -> Shape {
    // Seen from -x, +y is to the left.
    let corner = |u: f32, v: f32| Point3::new(0.0, 0.4 - 0.8 * u, 0.3 - 0.6 * v);
    let (a, b, c, d) = ([0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]);
    let vertices = [a, b, c, d].map(|[u, v]| corner(u, v)).to_vec();
    let uvs = if uvs { vec![[a, b, c], [a, c, d]] } else { Vec::new() };
    Shape::Mesh { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]], uvs }
}

/// A scene with nothing but one shape of a material.
fn alone(shape: Shape, made: Material, texture: Option<Texture>, scale: f32) -> SceneGraph {
    let mut stage = Stage::new();
    let texture = texture.map(|t| stage.library.add_texture(Arc::new(t)).unwrap());
    let number = stage.library.add_material(Material { texture, ..made }).unwrap();
    let asset = stage.asset(vec![common::part("board", shape, [0.0; 3], number)]);
    let mut draft = Draft::new("painting").at(Pose::translation(0.1, -0.05, 0.02));
    (draft.asset, draft.scale) = (Some(asset), Some(Vector3::repeat(scale)));
    stage.builder.add_in(stage.room, draft).unwrap();
    stage.build()
}

/// A board that glows with an image texture, and beside it only a matt wall.
fn screen(texture: Option<Texture>) -> Shown {
    let mut stage = Stage::new();
    let texture = texture.map(|t| stage.library.add_texture(Arc::new(t)).unwrap());
    let glowing = Material { emission: [60.0; 3], texture, ..matt([0.3; 3]) };
    let number = stage.library.add_material(glowing).unwrap();
    let made = stage.asset(vec![common::part("screen", board(true), [0.0; 3], number)]);
    let made = stage.put("tv", made, Pose::translation(0.1, -0.05, 0.02));
    let white = stage.library.add_material(matt([0.8; 3])).unwrap();
    let wall = Shape::Box { half: Vector3::new(0.4, 0.01, 0.4) };
    stage.one("wall", wall, Pose::translation(-0.45, 0.45, 0.0), white);
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    snapshot.switch(made, true).unwrap();
    let none = Vector3::zeros();
    let dark = Daylight { zenith: none, horizon: none, ground: none, ..Daylight::night() };
    let lighting = renderer.light(&snapshot, &dark);
    Shown { renderer, snapshot, lighting }
}

fn traced(shown: &Shown, camera: &Camera) -> Vec<[f32; 3]> {
    let how = PathTracing { samples: 16, denoise: false, brightest: f32::INFINITY, ..PathTracing::default() };
    shown.renderer.reference_picture(&shown.lighting, camera, &how, |_| true).unwrap().light
}

#[test]
fn what_a_picture_takes_from_a_glow_is_missing_on_the_wall_beside_it() {
    let grey = Texture { name: "grey".into(), width: 2, height: 2, pixels: vec![[188, 137, 99]; 4] };
    let camera = Camera::with_fov(16, 12, 0.4).looking(Point3::new(-0.6, -0.4, 0.0), Point3::new(-0.35, 0.44, 0.0));
    let [full, part] = [None, Some(grey)].map(|texture| traced(&screen(texture), &camera));
    let sum = |light: &[[f32; 3]], c: usize| light.iter().map(|l| l[c]).sum::<f32>();
    for (c, byte) in [188, 137, 99].into_iter().enumerate() {
        let share = sum(&part, c) / sum(&full, c);
        assert!((share / linear(byte) - 1.0).abs() < 0.02, "channel {c}: {share}, not {}", linear(byte));
    }
}

/// Each block has the light that its colour implies, in path tracing and in fast pictures.
#[test]
fn pictures_that_glow_give_their_own_light() {
    let shown = screen(Some(blocks()));
    let camera = Camera::with_fov(64, 48, 0.6).looking(Point3::new(-0.9, -0.05, 0.02), Point3::new(0.1, -0.05, 0.02));
    let light_at = traced(&shown, &camera);
    let fast = shown.fast(&camera);
    let (mut most, mut compared) = (0.0_f32, 0);
    // A nearly white block.
    let white = light_at[pixel(&camera, 3, 0)].map(|v| v / linear(250));
    for (block, colour) in BLOCKS.as_flattened().iter().enumerate() {
        let at = pixel(&camera, block % 4, block / 4);
        let light = light_at[at];
        for c in 0..3 {
            let wanted = white[c] * linear(colour[c]);
            assert!(
                (light[c] - wanted).abs() < 0.05 * white[c],
                "block {block}: {light:?}, not {colour:?} of {white:?}"
            );
        }
        most = most.max(light[1]);
        // Fast pictures rank the channels in the same order.
        let near = fast[at];
        for (a, b) in [(0, 1), (1, 2), (0, 2)].into_iter().filter(|(a, b)| light[*a] > 1.5 * light[*b]) {
            assert!(near[a] > near[b], "block {block}: {near:?} for {light:?}");
            compared += 1;
        }
    }
    assert!(most > 0.0 && compared > 8, "{most}, {compared}");
}

fn matt(colour: [f32; 3]) -> Material {
    Material { roughness: 1.0, ..material("plain", colour) }
}

fn even() -> Daylight {
    let one = Vector3::repeat(1.0);
    Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() }
}

struct Shown {
    renderer: Renderer,
    snapshot: Snapshot,
    lighting: Lighting,
}

impl Shown {
    fn new(scene: &SceneGraph) -> Self {
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(scene).unwrap();
        let lighting = renderer.light(&snapshot, &even());
        Self { renderer, snapshot, lighting }
    }

    fn fast(&self, camera: &Camera) -> Vec<[u8; 3]> {
        self.exposed(camera, None).rgb
    }

    /// A fast picture with the exposure of another one, or with its own.
    fn exposed(&self, camera: &Camera, exposure: Option<[f32; 3]>) -> Frame {
        let mut frame = Frame::new();
        let adapts = exposure.map(|from| Adaptation { from, share: 0.0 });
        let shot = Shot { adaptation: adapts, ..Shot::new(&self.snapshot, camera, Modality::Rgb).lit(&self.lighting) };
        self.renderer.render(&shot, &mut frame).unwrap();
        frame
    }

    /// Light with a single bounce, so that only the board's own colour matters.
    fn reference_picture(&self, camera: &Camera) -> Vec<[f32; 3]> {
        let how = PathTracing { samples: 16, bounces: 1, denoise: false, ..PathTracing::default() };
        self.renderer.reference_picture(&self.lighting, camera, &how, |_| true).unwrap().light
    }
}

/// Cameras head on, and obliquely from below.
fn cameras() -> [Camera; 2] {
    let camera = Camera::with_fov(96, 72, 0.7);
    let target = Point3::new(0.1, -0.05, 0.02);
    [[-1.0, -0.05, 0.02], [-0.7, 0.55, -0.4]].map(|eye| camera.looking(eye.into(), target))
}

/// Index of the pixel at the centre of a block.
fn pixel(camera: &Camera, column: usize, row: usize) -> usize {
    let (u, v) = ((column as f32 + 0.5) / 4.0, (row as f32 + 0.5) / 3.0);
    let at = Point3::new(0.1, -0.05 + 0.4 - 0.8 * u, 0.02 + 0.3 - 0.6 * v);
    let seen = camera.project(&at).unwrap();
    seen.y as usize * camera.width as usize + seen.x as usize
}

#[test]
fn every_texel_is_where_its_coordinates_say() {
    let tint = [0.8, 0.6, 0.9];
    // The texture multiplies the material's colour.
    let pictured = Shown::new(&alone(board(true), matt(tint), Some(blocks()), 1.0));
    for camera in cameras() {
        let (fast, reference_picture) = (pictured.exposed(&camera, None), pictured.reference_picture(&camera));
        for (row, column) in (0..3).flat_map(|row| (0..4).map(move |column| (row, column))) {
            let texel = BLOCKS[row][column].map(linear);
            let colour = [0, 1, 2].map(|i: usize| tint[i] * texel[i]);
            let plain = Shown::new(&alone(board(false), matt(colour), None, 1.0));
            let at = pixel(&camera, column, row);
            let (own, wanted) = (fast.rgb[at], plain.exposed(&camera, Some(fast.exposure)).rgb[at]);
            // Light reflected by the board lights it a little, and differs.
            assert!((0..3).all(|i| own[i].abs_diff(wanted[i]) <= 6), "{row} {column}: {own:?}, not {wanted:?}");
            let (own, wanted) = (reference_picture[at], plain.reference_picture(&camera)[at]);
            let off = (0..3).map(|i| (own[i] - wanted[i]).abs()).fold(0.0, f32::max);
            assert!(off < 0.002, "{row} {column}: {own:?}, not {wanted:?}");
        }
    }
}

#[test]
fn far_away_a_fine_board_is_grey() {
    let pixels = (0..256 * 256).map(|i| if (i % 256 + i / 256) % 2 == 0 { [255; 3] } else { [0; 3] }).collect();
    let fine = Texture { name: "fine".into(), width: 256, height: 256, pixels };
    let scale = 4.0;
    let pictured = Shown::new(&alone(board(true), matt([0.8; 3]), Some(fine), scale));
    let plain = Shown::new(&alone(board(false), matt([0.4; 3]), None, scale));
    // Some ten texels to a pixel, head on and obliquely.
    let camera = Camera::with_fov(64, 48, 1.0);
    for eye in [[-6.0, 0.0, 0.0], [-5.0, 2.0, 2.0]] {
        let camera = camera.looking(eye.into(), Point3::origin());
        let (own, wanted) = (pictured.fast(&camera), plain.fast(&camera));
        // The outermost pixels are mixed with the background.
        let middle = |p: &usize| (20..44).contains(&(p % 64)) && (16..32).contains(&(p / 64));
        let off = (0..64 * 48).filter(middle).map(|p| own[p][1].abs_diff(wanted[p][1])).max().unwrap();
        assert!(off <= 12, "{off}");
    }
}

#[test]
fn what_has_no_coordinates_has_the_mean() {
    let mean = [0, 1, 2].map(|i: usize| BLOCKS.iter().flatten().map(|b| linear(b[i])).sum::<f32>() / 12.0);
    let ball = || Shape::Sphere { radius: 0.3 };
    let own = Shown::new(&alone(ball(), matt([0.7; 3]), Some(blocks()), 1.0));
    let wanted = Shown::new(&alone(ball(), matt(mean.map(|m| 0.7 * m)), None, 1.0));
    let (own, wanted) = (own.fast(&cameras()[0]), wanted.fast(&cameras()[0]));
    let at = 36 * 96 + 48;
    assert!((0..3).all(|i| own[at][i].abs_diff(wanted[at][i]) <= 2), "{:?}, not {:?}", own[at], wanted[at]);
}

#[test]
fn any_coordinates_are_taken() {
    let Shape::Mesh { vertices, triangles, .. } = board(true) else { unreachable!() };
    for far in [0.0, 1e-30, -3.7e8, f32::MAX, f32::MIN] {
        let uvs = vec![[[far; 2], [0.3, far], [far, -far]]; 2];
        let shape = Shape::Mesh { vertices: vertices.clone(), triangles: triangles.clone(), uvs };
        let shown = Shown::new(&alone(shape, matt([0.8; 3]), Some(blocks()), 1.0));
        assert_eq!(shown.fast(&cameras()[1]).len(), 96 * 72);
        assert!(shown.reference_picture(&cameras()[1]).iter().flatten().all(|v| v.is_finite()));
    }
}

/// Courses of bricks are level on a pillar as well as on a long wall.
#[test]
fn bricks_lie_level_however_long_their_wall_is() {
    for (half, made) in [([0.05, 0.3, 1.2], "wall"), ([0.05, 1.5, 0.4], "wall"), ([0.05, 0.3, 1.2], "chimney")] {
        let mut stage = Stage::new();
        let brick = stage.library.add_material(material("brick", [0.4, 0.2, 0.15])).unwrap();
        let asset = stage.asset(vec![common::part(made, common::block(half), [0.0; 3], brick)]);
        stage.put(made, asset, Pose::identity());
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(&stage.build()).unwrap();
        let lighting = renderer.light(&snapshot, &Daylight::overcast());
        let camera = Camera::with_fov(96, 96, 0.4).looking(Point3::new(-1.0, 0.0, 0.0), Point3::origin());
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        // Joints run along courses: means of rows differ more than means of columns.
        let mean = |at: &dyn Fn(usize, usize) -> usize, i: usize| {
            (0..96).map(|j| f32::from(frame.rgb[at(i, j)][1])).sum::<f32>() / 96.0
        };
        let spread = |at: &dyn Fn(usize, usize) -> usize| {
            let means: Vec<f32> = (0..96).map(|i| mean(at, i)).collect();
            let middle = means.iter().sum::<f32>() / 96.0;
            means.iter().map(|m| (m - middle).powi(2)).sum::<f32>() / 96.0
        };
        let (rows, columns) = (spread(&|i, j| 96 * i + j), spread(&|i, j| 96 * j + i));
        assert!(rows > 2.0 * columns, "{made} of {half:?}: {rows} between rows, {columns} between columns");
    }
}
