//! A lidar: rays in rings around the vertical.

use nalgebra::{Point3, Vector3};
use vc_graph::Stream;
use vc_graph::portable::Portable;
use vc_render::camera::MAX_SIDE;
use vc_render::{NOTHING, RayCaster, RenderError};

use super::{LidarScan, Reading, Sensor, SensorError, SensorView};

/// A lidar that turns: lines of rays at even angles above the horizon, all around, at one moment. By default sixteen
/// lines as Velodyne's VLP-16 has them: 15 degrees up and down, 900 columns, up to 100 m, 3 cm of noise.
///
/// Glass is met as everything else is. Mount it where what carries it is not around it: a ray that meets something
/// nearer than `nearest` returns nothing.
///
/// ```
/// use virtualcity::graph::Pose;
/// use virtualcity::sensors::Lidar;
/// use virtualcity::{Environment, Mount};
/// let mut home = Environment::make("apartment/42", 1)?;
/// let hat = Mount::Head { agent: home.agents()[0], offset: Pose::translation(-0.14, 0.0, 0.25) };
/// let id = home.add_sensor("lidar", hat, Lidar { columns: 90, ..Lidar::default() })?;
/// let reading = home.sense(id)?;
/// let scan = reading.scan().ok_or("no scan")?;
/// assert_eq!(scan.distance.len(), 16 * 90);
/// std::fs::write(std::env::temp_dir().join("scan.ply"), scan.ply()?)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lidar {
    /// Lines of rays, one above the other.
    pub lines: u32,
    /// Rays of each line, all around: the first ahead, the others anticlockwise from above.
    pub columns: u32,
    /// Angles of the lowest and the highest line above the horizon, radians. A single line is in their middle.
    pub elevation: (f32, f32),
    /// Least distance, metres.
    pub nearest: f32,
    /// Greatest distance, metres.
    pub farthest: f32,
    /// Standard deviation of distances, metres.
    pub noise: f32,
}

impl Default for Lidar {
    fn default() -> Self {
        let elevation = (-15_f32.to_radians(), 15_f32.to_radians());
        Self { lines: 16, columns: 900, elevation, nearest: 0.1, farthest: 100.0, noise: 0.03 }
    }
}

impl Sensor for Lidar {
    fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
        self.check()?;
        let (pose, rays) = (view.pose()?, view.environment().ray_caster()?);
        let (lines, columns) = (self.lines as usize, self.columns as usize);
        let mut scan =
            LidarScan { lines, columns, pose, distance: Vec::new(), instance: Vec::new(), points: Vec::new() };
        for line in 0..self.lines {
            self.sweep(line, &rays, &mut view.seed().nth(u64::from(line)).stream(), &mut scan);
        }
        Ok(Reading::Scan(scan))
    }
}

impl Lidar {
    fn check(&self) -> Result<(), SensorError> {
        if !(1..=MAX_SIDE).contains(&self.lines) || !(1..=MAX_SIDE).contains(&self.columns) {
            let bad = RenderError::BadSize { width: self.columns, height: self.lines, longest: MAX_SIDE };
            return Err(bad.into());
        }
        let (low, high) = self.elevation;
        let upright = std::f32::consts::FRAC_PI_2;
        let rules = [
            (
                low >= -upright && low <= high && high <= upright,
                "elevation is to rise from -1.5708 rad at least to 1.5708 at most",
            ),
            (
                self.nearest >= 0.0 && self.nearest < self.farthest,
                "least distance is to be from 0 to below the greatest",
            ),
            (self.farthest.is_finite(), "greatest distance is to be finite"),
            (self.noise.is_finite() && self.noise >= 0.0, "noise is to be finite and not negative"),
        ];
        let broken = rules.into_iter().find(|(holds, _)| !holds);
        broken.map_or(Ok(()), |(_, wrong)| Err(SensorError::Settings { sensor: "lidar", wrong }))
    }

    /// Direction of a ray in the lidar's frame.
    fn way(&self, line: u32, column: u32) -> Vector3<f32> {
        let (low, high) = self.elevation;
        let share = if self.lines > 1 { line as f32 / (self.lines - 1) as f32 } else { 0.5 };
        let (rise, level) = (low + share * (high - low)).sine_cosine();
        let (sine, cosine) = (std::f32::consts::TAU * column as f32 / self.columns as f32).sine_cosine();
        Vector3::new(level * cosine, level * sine, rise)
    }

    /// Measures a line.
    fn sweep(&self, line: u32, rays: &RayCaster, stream: &mut Stream, scan: &mut LidarScan) {
        let from = Point3::from(scan.pose.translation.vector);
        let ways: Vec<Vector3<f32>> = (0..self.columns).map(|column| self.way(line, column)).collect();
        let beams: Vec<_> = ways.iter().map(|way| (from, scan.pose.rotation * way)).collect();
        for (way, met) in ways.iter().zip(rays.first_of_each(&beams, self.farthest)) {
            // Each ray draws as many numbers, whatever it meets.
            let error = stream.normal(0.0, self.noise);
            let hit = met.filter(|hit| hit.distance >= self.nearest);
            let distance = hit.map_or(f32::INFINITY, |hit| (hit.distance + error).max(0.0));
            scan.distance.push(distance);
            scan.instance.push(hit.map_or(NOTHING, |hit| hit.node));
            scan.points.push(hit.map_or([f32::INFINITY; 3], |_| (way * distance).into()));
        }
    }
}
