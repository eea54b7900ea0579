//! Frames rendered as viewable pictures, and image files of them: PNG, animated PNG, GIF, JPEG.
//!
//! All functions are linear in the pixels, mostly with a few operations each; a picture takes three bytes a
//! pixel. If the frame lacks the modality to show, the picture is black.
//!
//! ```
//! # use nalgebra::{Point3, Vector3};
//! # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
//! use vc_render::picture::{self, Picture};
//! use vc_render::{Camera, Daylight, Frame, Modalities, Modality, Renderer, Shot};
//! # let mut scene = SceneBuilder::new("flat");
//! # let kitchen = scene.add(Draft::new("kitchen"))?;
//! # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
//! # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
//! # let scene = scene.build();
//! # let mut renderer = Renderer::new();
//! # let snapshot = renderer.snapshot(&scene)?;
//! # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
//! # let lighting = renderer.light(&snapshot, &Daylight::overcast());
//! let wanted = Modalities::SIX | Modality::Normal;
//! let mut frame = Frame::new();
//! renderer.render(&Shot::new(&snapshot, &camera, wanted).lit(&lighting).after(&snapshot, &camera), &mut frame)?;
//! let rgb = picture::rgb(&frame);
//! let all = [
//!     rgb.clone(),
//!     picture::instances(&frame),
//!     picture::classes(&frame),
//!     picture::depth(&frame, 8.0),
//!     picture::flow(&frame, 25.0),
//!     picture::normals(&frame),
//!     picture::with_boxes(rgb, &frame, 20),
//!     picture::masks(&frame),
//! ];
//! let sheet = Picture::sheet(&all, 4, 4);
//! assert_eq!((sheet.width, sheet.height), (4 * 68 + 4, 2 * 52 + 4));
//! let file = picture::png(&sheet)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod canvas;
mod colours;
mod encode;

pub use canvas::Picture;
pub use colours::{Palette, classes, depth, flow, instances, masks, normals, parts, rgb, with_boxes};
pub use encode::{apng, gif, jpeg, png};
