//! Evened light for floor plans, in which bright and dark rooms are seen at once.

use std::sync::Arc;

use super::Lighting;
use super::lamp::Lamp;
use crate::math::scaled;
use crate::scene::{Body, NO_ROOM};

/// Light levels below this count as dark.
const DARK: f32 = 1e-5;

impl Lighting {
    /// The same light with the brightness of rooms, and of the outside, brought closer together: `share` is 0
    /// for no change and 1 for equal brightness. For plans and maps, where an eye would adapt to each room
    /// separately. Shadows and patches of sun stay as they are within each room; a nearly dark room is lit from
    /// above, with half as much light as the others have. Costs a copy of the indirect light, about a
    /// millisecond. Only fast pictures use it: mirrors and reference pictures show the light unchanged.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// # let snapshot = renderer.snapshot(&scene)?;
    /// let lighting = renderer.light(&snapshot, &Daylight::noon()).equalized(0.8);
    /// let camera = Camera::with_fov(64, 48, 1.0).overhead(Point3::new(2.0, 0.0, 2.0), 4.0);
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn equalized(&self, share: f32) -> Self {
        let share = share.clamp(0.0, 1.0);
        let (middle, gains) = self.evening(share);
        let Some((outside, _)) = gains.split_last() else { return self.clone() };
        let of = |room: u16| gains.get(usize::from(room)).unwrap_or(outside);
        let lamp = |lamp: &Lamp| Lamp { flux: scaled(lamp.flux, *of(lamp.room)), ..lamp.clone() };
        let room = |body: u32| of(self.tracer.snapshot.bodies.get(body as usize).map_or(NO_ROOM, |b: &Body| b.room));
        let even = |(room, gain): (usize, &f32)| {
            let missing = 0.5 * middle - gain * self.level(room).0;
            let inside = room + 1 < gains.len();
            self.grids[room].dimmed(*gain, if inside { share * missing.max(0.0) } else { 0.0 })
        };
        let mut daylight = self.daylight;
        for sky in [&mut daylight.zenith, &mut daylight.horizon, &mut daylight.ground] {
            *sky *= *outside;
        }
        Self {
            daylight,
            lamps: Arc::new(self.lamps.iter().map(lamp).collect()),
            gains: self.gains.iter().zip(0..).map(|(gain, body)| gain.map(|g| g * room(body))).collect(),
            grids: Arc::new(gains.iter().enumerate().map(even).collect()),
            sunlight: self.sunlight.iter().zip(&gains).map(|(light, gain)| light * gain).collect(),
            cloth: self.cloth.iter().map(|(body, light)| (*body, scaled(*light, *room(*body)))).collect(),
            ..self.clone()
        }
    }

    /// The mean level of the rooms, and the factor for the light of each room, the outside last.
    fn evening(&self, share: f32) -> (f32, Vec<f32>) {
        use vc_graph::portable::Portable;
        let levels: Vec<f32> = (0..self.rooms.len()).map(|room| self.level(room).0.max(DARK)).collect();
        // The outside counts only if there are no rooms.
        let inside = &levels[..levels.len().saturating_sub(1).max(levels.len().min(1))];
        let middle = inside.iter().map(|level| level.logarithm()).sum::<f32>() / inside.len().max(1) as f32;
        let gain = |level: &f32| (share * (middle - level.logarithm())).exponential();
        (middle.exponential(), levels.iter().map(gain).collect())
    }
}
