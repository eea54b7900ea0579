//! Lamps that are on.

use rayon::prelude::*;

use super::flux::{Leaving, leaving};
use super::shadow::Cube;
use crate::colour::luminance;
use crate::math::{self, dot, scaled, three};
use crate::ray_casting::Tracer;
use crate::scene::Store;
use crate::scene::{Body, Gives, Snapshot};

/// Lumens in one unit of luminous flux.
pub(super) const LUMENS: f32 = 5000.0;
/// Factor for the emission of luminous things that are not lamps.
const FAINT: f32 = 0.004;

/// Lumens of a candle.
const CANDLE: f32 = 40.0;

/// A lamp: all light of a body as if it came from one point.
#[derive(Debug, Clone)]
pub(crate) struct Lamp {
    pub(crate) body: u32,
    pub(crate) room: u16,
    pub(crate) at: [f32; 3],
    /// Radius of the light source, metres: light does not grow stronger nearer than this.
    pub(crate) radius: f32,
    /// Flux in each colour.
    pub(crate) flux: [f32; 3],
    /// Preferred direction, times the strength of the preference, 0 to 1.
    pub(crate) axis: [f32; 3],
    pub(crate) shadows: Cube,
}

/// The luminous bodies of a scene: lamps and screens.
pub(super) struct Shining {
    /// For each body, the factor for the emission of its luminous parts, and those for each colour of its shade's.
    pub(super) gains: Vec<[f32; 4]>,
    /// Luminous bodies that are not lamps, each with the greatest brightness of its materials.
    pub(super) screens: Vec<(u32, f32)>,
    pub(super) lamps: Vec<Lamp>,
}

/// The luminous parts of a body.
struct Glow {
    area: f32,
    most: f32,
    flux: [f32; 3],
    middle: [f32; 3],
    shade: f32,
}

/// The instances of all bodies but one.
pub(super) fn others(snapshot: &Snapshot, body: u32) -> impl Iterator<Item = u32> + Clone + '_ {
    (0..snapshot.instances.len() as u32).filter(move |i| snapshot.instances[*i as usize].body != body)
}

/// Finds the luminous bodies of a scene. Lamps in `kept` already have their shadows.
pub(super) fn lamps(store: &Store, tracer: &Tracer, kept: &[Lamp]) -> Shining {
    let snapshot = &tracer.snapshot;
    let mut gains = vec![[0.0; 4]; snapshot.bodies.len()];
    let (mut found, mut screens) = (Vec::new(), Vec::new());
    for (index, body) in snapshot.bodies.iter().enumerate().filter(|(_, b)| b.lit) {
        let glow = Glow::new(store, snapshot, body);
        let Some(target) = lumens(body, glow.area) else {
            gains[index] = [FAINT, 0.0, 0.0, 0.0];
            screens.push((index as u32, glow.most));
            continue;
        };
        if glow.area > 0.0 {
            let gain = target / LUMENS / luminance(glow.flux).max(1e-9);
            // A third of the light passes through the shade, in the bulb's colour.
            let through = 0.35 * target / LUMENS;
            let shade = if glow.shade > 0.0 { through / (std::f32::consts::PI * glow.shade) } else { 0.0 };
            let [red, green, blue] = scaled(glow.flux, shade / luminance(glow.flux).max(1e-9));
            gains[index] = [gain, red, green, blue];
            found.push((index as u32, glow));
        }
    }
    let lamp = |(body, glow): (u32, Glow)| {
        let known = kept.iter().find(|lamp| lamp.body == body).cloned();
        known.unwrap_or_else(|| Lamp::new(store, tracer, (body, &gains[body as usize]), &glow))
    };
    let lamps = found.into_par_iter().map(lamp).collect();
    Shining { gains, screens, lamps }
}

/// Lumens of a lamp, by the area of its bulbs; none for bodies that are not lamps.
fn lumens(body: &Body, area: f32) -> Option<f32> {
    match body.gives {
        Gives::Candlelight => Some(CANDLE),
        Gives::Lamplight => Some((500.0 + 9000.0 * area).clamp(400.0, 2500.0)),
        Gives::Glow => None,
    }
}

impl Glow {
    fn new(store: &Store, snapshot: &Snapshot, body: &Body) -> Self {
        let mut glow = Self { area: 0.0, most: 0.0, flux: [0.0; 3], middle: [0.0; 3], shade: 0.0 };
        for instance in &snapshot.instances[body.instances.start as usize..body.instances.end as usize] {
            let mesh = &*instance.link.levels[0];
            let world = instance.world.narrow();
            for cluster in &mesh.clusters {
                for triangle in cluster.triangles.clone() {
                    let surface = &store.surfaces[usize::from(mesh.faces[triangle as usize].surface)];
                    let corners = mesh.triangle(cluster, triangle as usize).map(|p| math::point(&world, p));
                    if surface.glows() {
                        glow.add(corners, surface.mean_emission());
                    } else if surface.role == crate::surface::Role::Shade {
                        glow.shade += area(corners).1;
                    }
                }
            }
        }
        if glow.area > 0.0 {
            glow.middle = glow.middle.map(|v| v / glow.area);
        }
        glow
    }

    fn add(&mut self, corners: [[f32; 3]; 3], emission: [f32; 3]) {
        let (_, area) = area(corners);
        self.area += area;
        self.most = self.most.max(luminance(emission));
        for i in 0..3 {
            self.flux[i] += std::f32::consts::PI * emission[i] * area;
            self.middle[i] += (corners[0][i] + corners[1][i] + corners[2][i]) / 3.0 * area;
        }
    }
}

/// Normal and area of a triangle.
pub(super) fn area([a, b, c]: [[f32; 3]; 3]) -> ([f32; 3], f32) {
    let edge = |p: [f32; 3]| three(|i| p[i] - a[i]);
    let (u, v) = (edge(b), edge(c));
    let cross = math::cross(u, v);
    let length = dot(cross, cross).sqrt();
    (if length > 0.0 { cross.map(|x| x / length) } else { [0.0; 3] }, 0.5 * length)
}

impl Lamp {
    fn new(store: &Store, tracer: &Tracer, (index, gains): (u32, &[f32; 4]), glow: &Glow) -> Self {
        let snapshot = &tracer.snapshot;
        let others: Vec<u32> = others(snapshot, index).collect();
        let radius = (glow.area / (4.0 * std::f32::consts::PI)).sqrt();
        let Leaving { flux, axis, at } = leaving(store, tracer, index, gains).unwrap_or(Leaving::none(glow.middle));
        let shadows = Cube::new(store, snapshot, &others, at, radius);
        // A ceiling just above a lamp must still be lit.
        let (room, radius) = (snapshot.bodies[index as usize].room, 0.5 * radius);
        Self { body: index, room, at, radius, flux, axis, shadows }
    }

    /// Direction to the lamp (unit length), and the irradiance at a point on a surface that faces the lamp, for
    /// a unit of flux, without shadows.
    #[inline(always)]
    pub(crate) fn falls(&self, at: [f32; 3]) -> ([f32; 3], f32) {
        let to = three(|i| self.at[i] - at[i]);
        let square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
        let over = 1.0 / square.sqrt().max(1e-6);
        let to = scaled(to, over);
        let facing = -(to[0] * self.axis[0] + to[1] * self.axis[1] + to[2] * self.axis[2]);
        let [x, y, z] = self.axis;
        let narrow = (x * x + y * y + z * z).sqrt().min(1.0);
        // Blends uniform light with cosine-distributed light in a half space.
        let even = (1.0 - narrow) / (4.0 * std::f32::consts::PI);
        let beam = facing.max(0.0) / std::f32::consts::PI;
        (to, (even + beam) / (square + self.radius * self.radius))
    }

    /// The visible share of the lamp from a point, 0 to 1.
    #[inline(always)]
    pub(crate) fn seen(&self, at: [f32; 3], normal: [f32; 3]) -> f32 {
        self.shadows.lit(self.at, at, normal)
    }
}
