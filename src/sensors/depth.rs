//! A depth camera with the noise of structured light.

use nalgebra::Vector3;
use vc_graph::Stream;
use vc_graph::portable::Portable;
use vc_render::{Camera, Frame, Modality};

use super::{Reading, Sensor, SensorError, SensorView};
use crate::Lens;

/// A depth camera that sees as a structured-light camera does: depth is noisy, and missing (infinite) where something is
/// too near, too far, or seen at a grazing angle.
///
/// ```
/// use virtualcity::sensors::NoisyDepth;
/// use virtualcity::{Environment, Mount};
/// let mut home = Environment::make("apartment/42", 1)?;
/// let id = home.add_sensor("depth", Mount::head(home.agents()[0]), NoisyDepth::default())?;
/// let (first, again) = (home.sense(id)?, home.sense(id)?);
/// let depth = |reading: &virtualcity::sensors::Reading| reading.picture().map(|frame| frame.depth.clone());
/// assert!(depth(&first) == depth(&again), "noise is that of the moment");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoisyDepth {
    /// Pixels across; 640 by default.
    pub width: u32,
    /// Pixels down; 480 by default.
    pub height: u32,
    /// The lens; by default a vertical field of view of 0.75 rad, about the first Kinect's.
    pub lens: Lens,
    /// Least depth, metres; 0.4 by default.
    pub nearest: f32,
    /// Greatest depth, metres; 4.5 by default.
    pub farthest: f32,
    /// The noise.
    pub noise: DepthNoise,
}

impl Default for NoisyDepth {
    fn default() -> Self {
        let lens = Lens::FieldOfView(0.75);
        Self { width: 640, height: 480, lens, nearest: 0.4, farthest: 4.5, noise: DepthNoise::default() }
    }
}

/// Noise of depth: the standard deviation at depth z and at angle a between the ray and the surface's normal is
/// `base + square * (z - from)^2 + grazing / sqrt(z) * a^2 / (pi/2 - a)^2` metres. The form and the defaults are those
/// measured by Nguyen, Izadi and Lovell (2012) for the first Kinect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthNoise {
    /// Standard deviation at the best depth, metres; 0.0012 by default.
    pub base: f32,
    /// How it grows with the square of the depth, 1/metre; 0.0019 by default.
    pub square: f32,
    /// The best depth, metres; 0.4 by default.
    pub from: f32,
    /// How it grows with the angle; 0.0001 by default.
    pub grazing: f32,
    /// The angles from which on pixels begin to be missing, and from which on all are, radians; 1.05 and 1.4 by default:
    /// 60 and 80 degrees.
    pub lost: (f32, f32),
}

impl Default for DepthNoise {
    fn default() -> Self {
        Self { base: 0.0012, square: 0.0019, from: 0.4, grazing: 0.0001, lost: (1.05, 1.4) }
    }
}

impl DepthNoise {
    /// No noise, and nothing missing.
    pub const NONE: Self =
        Self { base: 0.0, square: 0.0, from: 0.0, grazing: 0.0, lost: (std::f32::consts::PI, std::f32::consts::PI) };

    /// Standard deviation at a depth in metres and an angle in radians, metres.
    ///
    /// ```
    /// let noise = virtualcity::sensors::DepthNoise::default();
    /// assert!((noise.deviation(0.4, 0.0) - 0.0012).abs() < 1e-6);
    /// assert!(noise.deviation(4.0, 0.0) > 10.0 * noise.deviation(0.8, 0.0));
    /// ```
    pub fn deviation(&self, depth: f32, angle: f32) -> f32 {
        let away = depth - self.from;
        let left = (std::f32::consts::FRAC_PI_2 - angle).max(1e-3);
        let grazing = self.grazing / depth.max(1e-3).sqrt() * (angle / left) * (angle / left);
        self.base + self.square * away * away + grazing
    }

    /// The share of pixels that are missing at an angle.
    fn missing(&self, angle: f32) -> f32 {
        let (some, all) = self.lost;
        if all > some { ((angle - some) / (all - some)).clamp(0.0, 1.0) } else { f32::from(u8::from(angle >= all)) }
    }

    fn fault(&self) -> Option<&'static str> {
        let numbers = [self.base, self.square, self.from, self.grazing, self.lost.0, self.lost.1];
        let sound = numbers.iter().all(|v| v.is_finite() && *v >= 0.0);
        (!sound).then_some("noise is to be finite and not negative")
    }
}

impl Sensor for NoisyDepth {
    fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
        let range = self.nearest >= 0.0 && self.nearest < self.farthest;
        let wrong =
            (!range).then_some("least depth is to be from 0 to below the greatest").or_else(|| self.noise.fault());
        if let Some(wrong) = wrong {
            return Err(SensorError::Settings { sensor: "depth camera", wrong });
        }
        self.lens.check()?;
        let camera = view.camera(self.lens, self.width, self.height)?;
        let mut frame = view.render(&camera, Modality::Depth | Modality::Normal)?;
        for row in 0..frame.height {
            self.blur(&camera, &mut frame, row, &mut view.seed().nth(row as u64).stream());
        }
        frame.normal = Vec::new();
        frame.modalities = Modality::Depth.into();
        Ok(Reading::Picture(Box::new(frame)))
    }
}

impl NoisyDepth {
    /// Adds noise to a row.
    fn blur(&self, camera: &Camera, frame: &mut Frame, row: usize, stream: &mut Stream) {
        for column in 0..frame.width {
            let pixel = row * frame.width + column;
            let ahead = camera.unproject(column as f32 + 0.5, row as f32 + 0.5, 1.0) - camera.eye();
            let cosine = ahead.normalize().dot(&Vector3::from(frame.normal[pixel])).abs().min(1.0);
            let (depth, angle) = (frame.depth[pixel], cosine.arc_cosine());
            // Each pixel draws as many numbers, whatever it sees.
            let (luck, error) = (stream.unit(), stream.normal(0.0, 1.0));
            let noisy = depth + self.noise.deviation(depth, angle) * error;
            let seen = (self.nearest..=self.farthest).contains(&depth) && luck >= self.noise.missing(angle);
            frame.depth[pixel] = if seen { noisy.max(0.0) } else { f32::INFINITY };
        }
    }
}
