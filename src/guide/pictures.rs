//! Pictures, cameras, sensors and data sets.
//!
//! # Pictures as data
//!
//! Frames hold plain lists, one value for each pixel, row by row: node and class numbers, depths in metres,
//! colours.
//!
//! ```
//! use virtualcity::render::{Modality, format, picture};
//! use virtualcity::{Environment, Viewpoint};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let wanted = Modality::Rgb | Modality::Instance | Modality::Depth;
//! let frame = home.render(Viewpoint::Agent(me), wanted, 64, 48)?;
//! let seen: std::collections::BTreeSet<_> = frame.instance.iter().collect();
//! println!("{} things are seen; the middle is {:.2} m away", seen.len(), frame.depth[24 * 64 + 32]);
//! let png: Vec<u8> = picture::png(&picture::rgb(&frame))?;
//! let npy: Vec<u8> = format::npy(&frame.depth, &[frame.height, frame.width])?;
//! assert!(png.starts_with(b"\x89PNG") && npy.len() > 4 * 64 * 48);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Cameras and sensors of your own
//!
//! [`cameras`](crate::Environment::cameras) lists all cameras by number and name. Others are added at a pose, on a head, a
//! hand or a thing, behind an agent, or above; by a field of view or by intrinsics. [`sensors`](crate::sensors) has a
//! fisheye, noisy depth and a lidar, and the trait for sensors of your own.
//!
//! ```
//! use virtualcity::graph::Pose;
//! use virtualcity::physics::Hand;
//! use virtualcity::render::Modality;
//! use virtualcity::sensors::Lidar;
//! use virtualcity::{Environment, Lens, Mount, Viewpoint};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! home.add_camera("behind", Mount::Following { agent: me, behind: 1.8, above: 0.7 }, Lens::FieldOfView(1.1))?;
//! home.add_camera("wrist", Mount::wrist(me, Hand::Right), Lens::Options)?;
//! for (id, camera) in home.cameras() {
//!     let frame = home.render(Viewpoint::Camera(id), Modality::Depth, 32, 24)?;
//!     println!("{id}, {}: {:.2} m in the middle", camera.name, frame.depth[12 * 32 + 16]);
//! }
//! // Cameras are kept with `save`, and as a list of their own.
//! let list: String = home.cameras_json();
//!
//! let hat = Mount::Head { agent: me, offset: Pose::translation(-0.14, 0.0, 0.25) };
//! let lidar = home.add_sensor("lidar", hat, Lidar { columns: 90, ..Lidar::default() })?;
//! let points = home.sense(lidar)?.scan().map_or(0, |scan| scan.in_home().count());
//! assert!(points > 1000, "{points} of 1440 rays come back");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A data set of several homes
//!
//! One COCO document for all homes, with identifiers that are unique across them: `pycocotools` reads it.
//!
//! ```
//! use virtualcity::{Dataset, Environment, Viewpoint};
//!
//! # let folder = std::env::temp_dir().join(format!("vc-guide-{}", std::process::id()));
//! # let out = folder.join("rooms");
//! let mut dataset = Dataset::create(&out)?;
//! for seed in [1, 2] {
//!     let home = Environment::make(&format!("apartment/{seed}"), 1)?;
//!     for room in home.graph().rooms().iter().take(2) {
//!         dataset.add(&home, Viewpoint::Room(*room), 64, 48)?;
//!     }
//! }
//! assert_eq!(dataset.pictures(), 4);
//! let annotations = dataset.finish()?;
//! assert!(std::fs::read_to_string(annotations)?.contains("supercategory"));
//! # std::fs::remove_dir_all(folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
