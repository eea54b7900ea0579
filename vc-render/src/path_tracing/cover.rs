//! Covers drawn over windows. Light comes through them only on paths that go there, so some paths are sent
//! there deliberately: a path continues in a direction sampled either by its surface or towards a cover, and is
//! weighted by the combined density of both (one-sample multiple importance sampling, Veach 1997).

use super::source::{Pane, Place, Triangle};
use super::walk::Walk;
use crate::colour::luminance;
use crate::light::Lighting;
use crate::math;

/// Share of paths that are sent to covers where there is no other light.
const SENT: f32 = 0.3;
/// Probability that a path is reflected by a face, relative to the reflected share of light: more paths pass
/// through, towards the light, and each counts less.
const BACK: f32 = 0.5;
/// Rough share of the light behind a cover that comes through.
const THROUGH: f32 = 0.1;

/// The covers of a scene as rectangles, which need not match the cloth exactly.
#[derive(Default)]
pub(super) struct Covers {
    halves: Vec<Pane>,
    /// Rough estimate of their brightness.
    light: f32,
}

impl Covers {
    pub(super) fn new(lighting: &Lighting) -> Self {
        let (snapshot, daylight) = (&lighting.tracer.snapshot, &lighting.daylight);
        let mut covers = Self::default();
        for body in snapshot.bodies.iter().filter(|body| body.covers(&snapshot.instances)) {
            let (centre, [_, wide, high]) = (body.bounds.centre, body.bounds.half);
            let corner = |y: f32, z: f32| {
                let at = nalgebra::Point3::new(centre[0], centre[1] + y * wide, centre[2] + z * high);
                (body.pose * at).into()
            };
            let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
            let halves = [[a, b, c], [a, c, d]].map(Triangle::new).into_iter().filter(|half| half.area > 0.0);
            covers.halves.extend(halves.map(|triangle| Pane { room: body.room, triangle }));
        }
        let sky = 0.5 * luminance((daylight.horizon + daylight.zenith).into());
        covers.light = THROUGH * (sky + luminance(daylight.sun.into()) / std::f32::consts::PI);
        covers
    }

    fn of_room(&self, room: u16) -> impl Iterator<Item = &Pane> {
        self.halves.iter().filter(move |half| half.room == room)
    }

    /// Estimated solid angle of the covers in the point's room; zero if there is none.
    pub(super) fn weight(&self, from: &Place) -> f32 {
        self.of_room(from.room).map(|half| half.weight(from)).sum()
    }

    /// The share of paths that are sent from a point towards covers.
    fn share(&self, from: &Place) -> f32 {
        let light = self.light * from.covers;
        if light > 0.0 { SENT * light / (light + from.lamps) } else { 0.0 }
    }

    /// The direction to a point of a cover, sampled by estimated solid angle; none if the path is not sent
    /// there.
    pub(super) fn towards(&self, from: &Place, which: f32, square: [f32; 2]) -> Option<[f32; 3]> {
        let mut left = which * from.covers / self.share(from);
        let half = self.of_room(from.room).find(|half| {
            left -= half.weight(from);
            left < 0.0
        })?;
        let at = half.triangle.point(square);
        Some(crate::math::unit(math::three(|i| at[i] - from.at[i])))
    }

    /// The probability density over solid angle that a path continues in a direction, given the density of its
    /// surface's own sampling.
    pub(super) fn mixed(&self, own: f32, from: &Place, along: [f32; 3]) -> f32 {
        let share = self.share(from);
        if share == 0.0 {
            return own;
        }
        let seen = |half: &Pane| half.triangle.density(from.at, along) * half.weight(from);
        own + share * (self.of_room(from.room).map(seen).sum::<f32>() / from.covers - own)
    }
}

impl Walk {
    /// Decides whether a path passes a face that transmits a share of light, and adjusts the path's weight.
    pub(super) fn passes(&mut self, share: f32, choice: f32) -> bool {
        let often = 1.0 - BACK * (1.0 - share);
        let passes = choice < often;
        let counts = if passes { share / often } else { 1.0 / BACK };
        self.share = self.share.map(|v| v * counts);
        if passes {
            self.dimmed = self.greatest().max(1e-6);
        }
        passes
    }
}
