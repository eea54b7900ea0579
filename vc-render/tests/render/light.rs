//! Energy is conserved: furnace tests, and a box whose light is known from a radiosity solution.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material, part, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape};
use vc_graph::{NodeId, Pose};
use vc_render::{Camera, Daylight, PathTracing, Renderer, Snapshot};

/// Settings that find all light of paths, without denoising.
fn exact(samples: u32) -> PathTracing {
    PathTracing { samples, bounces: 200, brightest: f32::INFINITY, denoise: false, seed: 1 }
}

/// Equal light from all directions.
fn even() -> Daylight {
    let one = Vector3::repeat(1.0);
    Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() }
}

fn mean(light: &[[f32; 3]]) -> f32 {
    light.iter().map(|c| c[1]).sum::<f32>() / light.len() as f32
}

/// Mean light from the centre of a ball of a material in uniform light.
fn ball(made: Material) -> f32 {
    let mut stage = Stage::new();
    let number = stage.library.add_material(made).unwrap();
    stage.one("ball", Shape::Sphere { radius: 0.5 }, Pose::identity(), number);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &even());
    let camera = Camera::with_fov(8, 8, 0.2).looking(Point3::new(-3.0, 0.0, 0.0), Point3::origin());
    mean(&renderer.reference_picture(&lighting, &camera, &exact(256), |_| true).unwrap().light)
}

#[test]
fn balls_in_even_light_are_as_bright_as_their_material_says() {
    for roughness in [0.1, 0.3, 0.5, 0.7, 1.0] {
        for share in [0.0, 0.4, 0.8] {
            let plain = Material { roughness, ..material("plain", [share; 3]) };
            let dull = ball(plain.clone());
            // The coat reflects some light, and the base its share of the rest.
            let coat = if roughness == 1.0 { 0.0..0.001 } else { 0.02..0.065 };
            let wanted = share + coat.start * (1.0 - share)..share + coat.end * (1.0 - share);
            assert!(
                (wanted.start - 0.01..wanted.end + 0.01).contains(&dull),
                "share {share}, roughness {roughness}: {dull}, not in {wanted:?}"
            );
            let metal = ball(Material { metallic: 1.0, ..plain });
            // Between facets light hits the metal twice or more often.
            let least = if roughness < 0.4 { 0.95 * share } else { 0.9 * share * share };
            let wanted = least..share + 0.12 * (1.0 - share);
            assert!(
                (wanted.start - 0.01..wanted.end + 0.02).contains(&metal),
                "metal of {share}, roughness {roughness}: {metal}, not in {wanted:?}"
            );
        }
    }
}

/// Lengths of the box-shaped room.
const SIZE: [f32; 3] = [3.0, 2.0, 2.5];

/// A closed box of matt walls from the origin to [`SIZE`], with its renderer. Either the wall at x = 0 glows or
/// all of them do.
fn closed(share: f32, all: bool) -> (Renderer, Snapshot) {
    let mut stage = Stage::new();
    let glow = Material { roughness: 1.0, emission: [300.0; 3], ..material("plain", [share; 3]) };
    let dark = Material { emission: [0.0; 3], ..glow.clone() };
    let [glow, dark] = [glow, dark].map(|m| stage.library.add_material(m).unwrap());
    let mut lit: Vec<NodeId> = Vec::new();
    for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]) {
        let mut half = SIZE.map(|s| 0.5 * s + 0.1);
        half[axis] = 0.1;
        let mut at = SIZE.map(|s| 0.5 * s);
        at[axis] = if end == 1 { SIZE[axis] + 0.1 } else { -0.1 };
        let glows = all || (axis, end) == (0, 0);
        let asset = stage.asset(vec![part("slab", block(half), [0.0; 3], if glows { glow } else { dark })]);
        lit.push(stage.put("wall", asset, pose(at, 0.0, 0.0)));
    }
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    lit.iter().for_each(|n| snapshot.switch(*n, true).unwrap());
    (renderer, snapshot)
}

/// Light at pixels of a picture taken inside the box.
fn seen((renderer, snapshot): &(Renderer, Snapshot), camera: &Camera, samples: u32) -> Vec<f32> {
    let lighting = renderer.light(snapshot, &Daylight::night());
    let reference_picture = renderer.reference_picture(&lighting, camera, &exact(samples), |_| true).unwrap();
    reference_picture.light.iter().map(|c| c[1]).collect()
}

fn inside(target: [f32; 3]) -> Camera {
    Camera::with_fov(6, 4, 1.0).looking(Point3::new(2.0, 1.0, 1.2), Point3::from(target))
}

#[test]
fn a_furnace_of_glowing_walls_is_as_bright_as_the_sum_of_all_its_light() {
    let camera = inside([0.0, 1.2, 1.0]);
    let black = seen(&closed(0.0, true), &camera, 4);
    let own = black[0];
    assert!(own > 0.1 && black.iter().all(|v| (v - own).abs() < 1e-4 * own), "walls glow evenly: {black:?}");
    for share in [0.3, 0.6, 0.85] {
        // Emission plus all its reflections.
        let wanted = own / (1.0 - share);
        let light = seen(&closed(share, true), &camera, 512);
        let mean = light.iter().sum::<f32>() / light.len() as f32;
        assert!((mean / wanted - 1.0).abs() < 0.015, "share {share}: {mean}, not {wanted}");
    }
}

/// Patches of the box's walls.
struct Patches {
    places: Vec<([f64; 3], usize, f64)>,
    /// Light that leaves each patch, where the emission of a glowing one is one.
    light: Vec<f64>,
}

/// Number of patches along each side of a wall.
const CUTS: usize = 10;

/// Unnormalized form factor from a patch to a point whose normal is along an axis; the nearer the patch, the
/// finer it is subdivided.
fn sees(at: [f64; 3], axis: usize, (middle, facing, area): &([f64; 3], usize, f64)) -> f64 {
    let (u, v) = ((facing + 1) % 3, (facing + 2) % 3);
    if *facing == axis && (middle[axis] - at[axis]).abs() < 1e-9 {
        return 0.0;
    }
    let away: f64 = (0..3).map(|i| (middle[i] - at[i]).powi(2)).sum();
    let cuts = if away > 30.0 * area { 1 } else { 10 };
    let side = |axis: usize| f64::from(SIZE[axis]) / CUTS as f64 / f64::from(cuts);
    let piece = |i: i32| {
        let mut to = [0, 1, 2].map(|k: usize| middle[k] - at[k]);
        to[u] += (f64::from(i % cuts) - 0.5 * f64::from(cuts - 1)) * side(u);
        to[v] += (f64::from(i / cuts) - 0.5 * f64::from(cuts - 1)) * side(v);
        let square: f64 = to.iter().map(|v| v * v).sum();
        to[axis].abs() * to[*facing].abs() / (std::f64::consts::PI * square * square)
    };
    (0..cuts * cuts).map(piece).sum::<f64>() * area / f64::from(cuts * cuts)
}

impl Patches {
    /// Solves for the light of the box's patches by iteration (radiosity; Goral and others 1984).
    fn solved(share: f64) -> Self {
        let mut places = Vec::new();
        for (axis, end) in (0..3).flat_map(|axis| [(axis, 0.0), (axis, 1.0)]) {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            for i in 0..CUTS * CUTS {
                let mut at = [0.0; 3];
                at[axis] = end * f64::from(SIZE[axis]);
                at[u] = ((i % CUTS) as f64 + 0.5) / CUTS as f64 * f64::from(SIZE[u]);
                at[v] = ((i / CUTS) as f64 + 0.5) / CUTS as f64 * f64::from(SIZE[v]);
                places.push((at, axis, f64::from(SIZE[u] * SIZE[v]) / (CUTS * CUTS) as f64));
            }
        }
        let own = |i: usize| if i < CUTS * CUTS { 1.0 } else { 0.0 };
        let mut made = Self { light: (0..places.len()).map(own).collect(), places };
        let row = |(at, axis, _): &([f64; 3], usize, f64)| {
            let row: Vec<f64> = made.places.iter().map(|patch| sees(*at, *axis, patch)).collect();
            let total: f64 = row.iter().sum();
            row.iter().map(|v| v / total).collect::<Vec<f64>>()
        };
        let factors: Vec<Vec<f64>> = made.places.iter().map(row).collect();
        for _ in 0..40 {
            let falls = factors.iter().map(|row| row.iter().zip(&made.light).map(|(f, l)| f * l).sum::<f64>());
            made.light = falls.enumerate().map(|(i, f)| own(i) + share * f).collect();
        }
        made
    }

    /// Cosine-weighted mean of the light that a point on a wall receives.
    fn falls(&self, at: [f64; 3], axis: usize) -> f64 {
        let (mut sum, mut total) = (0.0, 0.0);
        for (patch, light) in self.places.iter().zip(&self.light) {
            let weight = sees(at, axis, patch);
            sum += weight * light;
            total += weight;
        }
        sum / total
    }
}

#[test]
fn a_box_with_one_glowing_wall_has_the_light_that_radiosity_finds() {
    let share = 0.7;
    let own = seen(&closed(0.0, true), &inside([0.0, 1.2, 1.0]), 1)[0];
    let patches = Patches::solved(f64::from(share));
    let made = closed(share, false);
    let eye = Point3::new(2.0, 1.0, 1.2);
    let places =
        [([0.3, 2.0, 1.0], 1), ([1.2, 2.0, 2.2], 1), ([3.0, 1.3, 0.4], 0), ([0.9, 0.7, 0.0], 2), ([0.0, 0.9, 1.1], 0)];
    for (at, axis) in places {
        let camera = Camera::with_fov(2, 2, 0.01).looking(eye, Point3::from(at));
        let light = seen(&made, &camera, 2048);
        let light = light.iter().sum::<f32>() / light.len() as f32;
        let glows = if at[0] == 0.0 { 1.0 } else { 0.0 };
        let wanted = own * (glows + f64::from(share) * patches.falls(at.map(f64::from), axis)) as f32;
        assert!((light / wanted - 1.0).abs() < 0.03, "at {at:?}: {light}, not {wanted}");
    }
}

#[test]
fn seeds_differ_in_noise_alone() {
    let made = closed(0.5, false);
    let camera = inside([0.0, 1.2, 1.0]);
    let lighting = made.0.light(&made.1, &Daylight::night());
    let of =
        |seed: u32| made.0.reference_picture(&lighting, &camera, &PathTracing { seed, ..exact(64) }, |_| true).unwrap();
    let (one, again, other) = (of(1), of(1), of(2));
    assert!(one == again && one != other);
    assert!((mean(&one.light) / mean(&other.light) - 1.0).abs() < 0.03);
}

#[test]
fn progress_is_told_and_may_end_it() {
    let made = closed(0.5, true);
    let lighting = made.0.light(&made.1, &Daylight::night());
    let mut told = Vec::new();
    let ended = made.0.reference_picture(&lighting, &inside([0.0; 3]), &exact(100), |made| {
        let so_far = made.reference_picture();
        assert_eq!((so_far.width, so_far.height), (6, 4));
        told.push((made.rounds, so_far));
        made.rounds < 3
    });
    assert_eq!(told.iter().map(|t| t.0).collect::<Vec<_>>(), [1, 2, 3]);
    // Without denoising, the last one is the final picture.
    assert!(ended.as_ref().is_ok_and(|made| *made == told[2].1) && told[0].1 != told[1].1);
    let three = made.0.reference_picture(&lighting, &inside([0.0; 3]), &exact(3), |_| true);
    assert!(ended == three, "what is there counts");
}

#[test]
fn smoothing_keeps_the_light_there_is() {
    let graph = common::lamplit();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&graph).unwrap();
    let lamps: Vec<NodeId> = snapshot.lamps().collect();
    lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::night());
    for camera in &common::cameras(96, 72)[..2] {
        let of = |denoise: bool| {
            let how = PathTracing { samples: 8, denoise, ..PathTracing::default() };
            renderer.reference_picture(&lighting, camera, &how, |_| true).unwrap().light
        };
        let (noisy, smooth) = (of(false), of(true));
        assert!((mean(&smooth) / mean(&noisy) - 1.0).abs() < 0.01, "{} and {}", mean(&smooth), mean(&noisy));
        // It does smooth: neighbouring pixels differ far less.
        let rough = |light: &[[f32; 3]]| light.windows(2).map(|w| (w[0][1] - w[1][1]).abs()).sum::<f32>();
        assert!(rough(&smooth) < 0.6 * rough(&noisy), "{} and {}", rough(&smooth), rough(&noisy));
    }
}
