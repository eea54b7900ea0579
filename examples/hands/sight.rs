//! A camera beside the agent and one near its hand, which keep a film and a strip.

use nalgebra::{Point3, Vector3};
use virtualcity::physics::Hand;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Modality};
use virtualcity::{Environment, Viewpoint};

use crate::support::{Complaint, say};
use crate::target::Target;

/// Size of pictures, and of those of the film.
const SIZE: (u32, u32) = (480, 360);
const SMALL: (u32, u32) = (240, 180);
/// Every how many decisions the film has a picture, and its pictures per second.
const EVERY: u32 = 4;
const RATE: u16 = 5;

/// Directions from which to look, ahead and to the left of the agent, and distances, metres.
const SIDES: [Vector3<f32>; 4] = [
    Vector3::new(-0.8, 0.6, 0.0),
    Vector3::new(-0.8, -0.6, 0.0),
    Vector3::new(-0.1, 1.0, 0.0),
    Vector3::new(-0.1, -1.0, 0.0),
];
const FAR: [f32; 4] = [0.9, 1.2, 1.5, 1.8];

/// Somebody who watches.
pub(crate) struct Witness {
    camera: Camera,
    strip: Vec<Picture>,
    film: Vec<Picture>,
    looks: u32,
}

impl Witness {
    /// A camera beside the place where the agent is going to stand, as far away as nothing is between.
    pub(crate) fn new(home: &Environment, target: &Target) -> Self {
        let (stand, handle) = (target.stand(home), target.handle(home).translation.vector);
        let middle = Point3::from((stand.translation.vector + handle) / 2.0);
        let to = Point3::new(middle.x, middle.y, 0.9);
        let eye = |way: Vector3<f32>, far: f32| {
            let eye = middle + stand.rotation * way * far;
            Point3::new(eye.x, eye.y, 1.75)
        };
        let free = |far: &f32, way: Vector3<f32>| home.world().ray(to, eye(way, far + 0.15), home.agents()).is_none();
        let room = |way: &Vector3<f32>| FAR.into_iter().take_while(|far| free(far, *way)).last().unwrap_or(FAR[0]);
        let way = SIDES.into_iter().max_by(|a, b| room(a).total_cmp(&room(b))).unwrap_or(SIDES[0]);
        let camera = Camera::with_fov(SIZE.0, SIZE.1, 1.1).looking(eye(way, room(&way)), to);
        Self { camera, strip: Vec::new(), film: Vec::new(), looks: 0 }
    }

    /// Looks now and then.
    pub(crate) fn look(&mut self, home: &Environment) -> Result<(), Complaint> {
        self.looks += 1;
        if self.looks.is_multiple_of(EVERY) {
            self.film.push(picture_of(home, Viewpoint::Free(self.camera), SMALL)?);
        }
        Ok(())
    }

    /// Keeps two pictures of a stage: from the side, and of the hand, or from the eyes.
    pub(crate) fn keep(&mut self, home: &Environment) -> Result<(), Complaint> {
        self.strip.push(picture_of(home, Viewpoint::Free(self.camera), SIZE)?);
        self.strip.push(picture_of(home, self.near(home), SIZE)?);
        Ok(())
    }

    /// A view of the right hand from the same side.
    fn near(&self, home: &Environment) -> Viewpoint {
        let me = home.agents()[0];
        let Some(hand) = home.controlled_hand(me, Hand::Right) else { return Viewpoint::Agent(me) };
        let hand = Point3::from(hand.body.pose.translation.vector);
        let way = (self.camera.eye() - hand).xy().push(0.0).normalize();
        Viewpoint::Free(self.camera.looking(hand + way * 0.35 + Vector3::z() * 0.25, hand))
    }

    /// Writes the strip and the film.
    pub(crate) fn write(&self, seed: u64) -> Result<(), Complaint> {
        let folder = std::path::Path::new("out/hands");
        virtualcity::files::create_folder(folder)?;
        let (strip, film) = (folder.join(format!("{seed}.png")), folder.join(format!("{seed}_film.png")));
        virtualcity::files::write(&strip, picture::png(&Picture::sheet(&self.strip, 4, 4))?)?;
        virtualcity::files::write(&film, picture::apng(&self.film, RATE)?)?;
        say!("  look at {} and {}", strip.display(), film.display());
        Ok(())
    }
}

fn picture_of(home: &Environment, view: Viewpoint, (width, height): (u32, u32)) -> Result<Picture, Complaint> {
    Ok(picture::rgb(&home.render(view, Modality::Rgb, width, height)?))
}
