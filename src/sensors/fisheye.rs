//! A fisheye camera, made of flat pictures.

use nalgebra::{UnitQuaternion, Vector3};
use rayon::prelude::*;
use vc_graph::portable::Portable;
use vc_render::camera::MAX_SIDE;
use vc_render::{Adaptation, Camera, Frame, Modalities, Modality, NO_LABEL, NOTHING, RenderError};

use super::{Reading, Sensor, SensorError, SensorView};
use crate::{Lens, PictureOptions};

/// The widest angle that a flat picture shows, radians: a little more than a sixth of all around, as shades at the edges of a
/// picture are less exact.
const FACE: f32 = 1.65;
/// Pixels of flat pictures for each of the fisheye's where they are widest.
const FINER: f32 = 1.25;
/// The modalities that a fisheye can show.
const SHOWN: [Modality; 7] = [
    Modality::Rgb,
    Modality::Distance,
    Modality::Instance,
    Modality::Part,
    Modality::Class,
    Modality::Normal,
    Modality::Position,
];

/// A fisheye camera with the equidistant projection: the distance from the middle of the picture is the angle from the
/// optical axis. It shows a disc; outside of it nothing is visible.
///
/// It is made of up to six flat pictures with one exposure, and costs what these cost. Labels and distances are those of
/// the nearest pixel of a flat picture.
///
/// ```
/// use virtualcity::render::Modality;
/// use virtualcity::sensors::Fisheye;
/// use virtualcity::{Environment, Mount};
/// let mut home = Environment::make("apartment/42", 1)?;
/// let wide = Fisheye { side: 96, field: 3.8, wanted: Modality::Instance | Modality::Distance };
/// let id = home.add_sensor("wide", Mount::head(home.agents()[0]), wide)?;
/// let reading = home.sense(id)?;
/// let frame = reading.picture().ok_or("no picture")?;
/// assert!(frame.distance[48 * 96 + 48].is_finite() && frame.distance[0].is_infinite());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fisheye {
    /// Pixels across and down; 512 by default.
    pub side: u32,
    /// The angle that the disc shows, radians: half a turn by default, at most a whole one.
    pub field: f32,
    /// The modalities: colours by default; also distance, nodes, parts, classes, normals and positions.
    pub wanted: Modalities,
}

impl Default for Fisheye {
    fn default() -> Self {
        Self { side: 512, field: std::f32::consts::PI, wanted: Modality::Rgb.into() }
    }
}

/// The directions of the six flat pictures in the optical frame: turns around an axis, by quarters. The first is ahead.
const FACES: [(Vector3<f32>, f32); 6] = [
    (Vector3::new(0.0, 1.0, 0.0), 0.0),
    (Vector3::new(0.0, 1.0, 0.0), 1.0),
    (Vector3::new(0.0, 1.0, 0.0), -1.0),
    (Vector3::new(1.0, 0.0, 0.0), 1.0),
    (Vector3::new(1.0, 0.0, 0.0), -1.0),
    (Vector3::new(0.0, 1.0, 0.0), 2.0),
];

/// A place in a flat picture: which one, and pixels across and down.
type Place = (usize, [f32; 2]);

impl Sensor for Fisheye {
    fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
        self.check()?;
        let turns = FACES
            .map(|(axis, quarters)| UnitQuaternion::from_scaled_axis(axis * quarters * std::f32::consts::FRAC_PI_2));
        let flat = view.camera(Lens::FieldOfView(self.face()), self.face_side(), self.face_side())?;
        let places = self.places(&flat, &turns);
        let mut faces: Vec<Frame> = Vec::new();
        let mut how = *view.environment().pictures();
        for (number, turn) in turns.iter().enumerate() {
            let camera = Camera { pose: flat.pose * turn, ..flat };
            let seen = number == 0 || places.iter().flatten().any(|(face, _)| *face == number);
            faces.push(if seen { view.render_as(&how, &camera, self.wanted)? } else { Frame::new() });
            if number == 0 {
                how = PictureOptions { adapts: Some(Adaptation { from: faces[0].exposure, share: 0.0 }), ..how };
            }
        }
        Ok(Reading::Picture(Box::new(self.joined(&faces, &places))))
    }
}

impl Fisheye {
    fn check(&self) -> Result<(), SensorError> {
        if !(1..=MAX_SIDE).contains(&self.side) {
            let bad = RenderError::BadSize { width: self.side, height: self.side, longest: MAX_SIDE };
            return Err(bad.into());
        }
        let wrong = |wrong| Err(SensorError::Settings { sensor: "fisheye", wrong });
        if !(self.field > 0.0 && self.field <= std::f32::consts::TAU) {
            return wrong("field of view is to be above 0 and at most a whole turn, 6.28318 rad");
        }
        let others = SHOWN.into_iter().fold(self.wanted, Modalities::without);
        if others == Modalities::NONE && self.wanted != Modalities::NONE {
            return Ok(());
        }
        wrong("modalities are to be colours, distance, nodes, parts, classes, normals or positions")
    }

    /// Pixels for each radian.
    fn scale(&self) -> f32 {
        self.side as f32 / self.field
    }

    /// The angle that a flat picture shows, radians: one ahead is enough for a narrow field.
    fn face(&self) -> f32 {
        FACE.min(1.02 * self.field)
    }

    /// Pixels along each side of a flat picture.
    fn face_side(&self) -> u32 {
        let side = 2.0 * FINER * self.scale() * (0.5 * self.face()).tangent();
        (side.ceil() as u32).clamp(2, MAX_SIDE)
    }

    /// Where each pixel is found in the flat pictures; nowhere outside of the disc.
    fn places(&self, flat: &Camera, turns: &[UnitQuaternion<f32>]) -> Vec<Option<Place>> {
        let side = self.side as usize;
        let back: Vec<UnitQuaternion<f32>> = turns.iter().map(UnitQuaternion::inverse).collect();
        let place = |pixel: usize| {
            let way = self.way(pixel % side, pixel / side)?;
            let ways = back.iter().map(|turn| turn * way).enumerate();
            let (face, way) = ways.reduce(|best, other| if other.1.z > best.1.z { other } else { best })?;
            let across = flat.focal.0 * way.x / way.z + flat.centre.0;
            let down = flat.focal.1 * way.y / way.z + flat.centre.1;
            Some((face, [across, down]))
        };
        (0..side * side).into_par_iter().map(place).collect()
    }

    /// The direction of a pixel in the optical frame.
    fn way(&self, column: usize, row: usize) -> Option<Vector3<f32>> {
        let middle = 0.5 * self.side as f32;
        let (x, y) = (column as f32 + 0.5 - middle, row as f32 + 0.5 - middle);
        let radius = x.hypotenuse(y);
        let angle = radius / self.scale();
        if radius > middle {
            return None;
        }
        let (sine, cosine) = angle.sine_cosine();
        let by = if radius > 0.0 { sine / radius } else { 0.0 };
        Some(Vector3::new(x * by, y * by, cosine))
    }

    /// The picture that the flat ones make.
    fn joined(&self, faces: &[Frame], places: &[Option<Place>]) -> Frame {
        let mut frame = Frame::new();
        (frame.width, frame.height) = (self.side as usize, self.side as usize);
        (frame.modalities, frame.exposure) = (self.wanted, faces[0].exposure);
        if self.wanted.has(Modality::Rgb) {
            frame.rgb = places.par_iter().map(|place| place.map_or([0; 3], |at| colour(faces, at))).collect();
        }
        frame.distance = self.picked(Modality::Distance, faces, places, f32::INFINITY, |f| &f.distance);
        frame.instance = self.picked(Modality::Instance, faces, places, NOTHING, |f| &f.instance);
        frame.part = self.picked(Modality::Part, faces, places, NO_LABEL, |f| &f.part);
        frame.class = self.picked(Modality::Class, faces, places, NO_LABEL, |f| &f.class);
        frame.normal = self.picked(Modality::Normal, faces, places, [0.0; 3], |f| &f.normal);
        frame.position = self.picked(Modality::Position, faces, places, [f32::INFINITY; 3], |f| &f.position);
        frame
    }

    /// The values at the nearest pixels; none of a modality that is not wanted.
    fn picked<T: Copy>(
        &self,
        modality: Modality,
        faces: &[Frame],
        places: &[Option<Place>],
        none: T,
        of: impl Fn(&Frame) -> &Vec<T>,
    ) -> Vec<T> {
        if !self.wanted.has(modality) {
            return Vec::new();
        }
        let value = |(face, at): Place| of(&faces[face]).get(nearest(&faces[face], at)).copied();
        places.iter().map(|place| place.and_then(value).unwrap_or(none)).collect()
    }
}

/// The pixel around a place.
fn nearest(face: &Frame, [across, down]: [f32; 2]) -> usize {
    let within = |at: f32, size: usize| (at.max(0.0) as usize).min(size.saturating_sub(1));
    within(down, face.height) * face.width + within(across, face.width)
}

/// The colour at a place, between the four pixels around it.
fn colour(faces: &[Frame], (number, [across, down]): Place) -> [u8; 3] {
    let face = &faces[number];
    let (x, y) = ((across - 0.5).max(0.0), (down - 0.5).max(0.0));
    let (u, v) = (x.fract(), y.fract());
    let corners =
        [(0.0, 0.0, (1.0 - u) * (1.0 - v)), (1.0, 0.0, u * (1.0 - v)), (0.0, 1.0, (1.0 - u) * v), (1.0, 1.0, u * v)];
    let mut sum = [0.5; 3];
    for (right, below, weight) in corners {
        let pixel = face.rgb.get(nearest(face, [x.floor() + right, y.floor() + below])).copied().unwrap_or_default();
        sum = [0, 1, 2].map(|i: usize| sum[i] + weight * f32::from(pixel[i]));
    }
    sum.map(|v| v as u8)
}
