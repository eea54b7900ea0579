//! VirtualCity: a headless, deterministic simulator of homes for embodied-AI research.
//!
//! This crate is the entry point. It re-exports the other crates of the workspace:
//!
//! | module | crate | content |
//! |---|---|---|
//! | [`graph`] | `vc-graph` | scenes, object classes, actions, goals, file formats |
//! | [`tasks`] | `vc-tasks` | tasks, and the outcomes of attempts at them |
//! | [`planner`] | `vc-planner` | belief, regression planner, agents, episodes |
//! | [`relations`] | `vc-relations` | spatial relations (on, in, under, near), read from poses and shapes |
//! | `physics` | `vc-physics` | bodies, agents, navigation, vehicles, water (feature `physics`, on by default) |
//! | `render` | `vc-render` | camera images: colours, depth, flow, normals, masks, boxes (feature `render`, on by default) |
//! | `shapes` | `vc-shapes` | objects from a seed: generators, materials, styles (feature `procgen`, on by default) |
//! | `procgen` | `vc-procgen` | apartments and city plans from a seed, dressing (feature `procgen`, on by default) |
//! | `geometry` | `vc-geometry` | shapes for things of which only a box is known, doorways, outlines, hulls (feature `environment`) |
//! | `gltf` | `vc-gltf` | export and import of models (feature `gltf`, on by default) |
//! | `map` | `vc-map` | streets: lanes, junctions, pavements, routes; OpenStreetMap in, SUMO and OpenDRIVE out (feature `map`, on by default) |
//! | `people` | `vc-people` | figures of people: bones, poses, reach, clothes (feature `environment`) |
//! | `initial` | this crate | initial environments for tasks in generated homes (feature `procgen`) |
//!
//! An agent that observes only its own room fetches the milk:
//!
//! ```
//! use virtualcity::graph::{Draft, SceneBuilder, Simulator};
//! use virtualcity::planner::{PlannerPolicy, run_episode};
//! use virtualcity::tasks::{Outcome, Task};
//!
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
//! scene.add_in(fridge, Draft::new("milk"))?;
//! scene.add_in(kitchen, Draft::new("character"))?;
//!
//! let task = Task::new("fetch the milk", "Holds(milk) & Closed(fridge)".parse()?);
//! let mut world = Simulator::new(scene.build());
//! let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut world);
//! assert_eq!(episode.outcome, Outcome::Won);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same works in a generated home with bodies. An [`Environment`] has five endpoints: make, reset, observe,
//! render, and set an action. Like the symbolic simulator it is a [`tasks::World`].
//!
//! ```no_run
//! use virtualcity::render::{Modality, picture};
//! use virtualcity::{Environment, Viewpoint};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let fridge = home.graph().of_class("fridge")[0];
//! home.set_action(me, format!("walk fridge.{}", fridge.0).parse()?)?;
//! let frame = home.render(Viewpoint::Agent(me), Modality::Rgb, 640, 480)?;
//! std::fs::write("fridge.png", picture::png(&picture::rgb(&frame))?)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | item | content |
//! |---|---|
//! | [`Environment`] | make, reset, observation, render, set action; the clock (`give`, `step`, `interrupt`); save and restore |
//! | [`EnvironmentBuilder`] | settings: bodies, gravity, hour, fields of view, classes, relations, durations, cameras, threads |
//! | [`City`], [`RegionScenes`] | several environments joined by doors, stairs and lifts (begun): going between them, things that roll from one into the next, seeing through doors, goals with a scope, save and restore, records ([`CityRecord`]), validation |
//! | [`Ending`], [`ActionError`], [`Interruption`], [`PhysicalRefusal`] | how an action ended, and why it was not done |
//! | [`EnvironmentState`] | a home at rest in some kilobytes, for searches that keep many |
//! | [`Control`] | velocity, head and hands of a body in every tick, beside actions |
//! | [`Batch`] | many environments, stepped on all cores |
//! | [`check_environment`] | a test of the contract that environments keep |
//! | [`Viewpoint`] | the position of a camera; [`Mount`] and [`Lens`] of your own |
//! | [`sensors`] | a fisheye, noisy depth, a lidar, and the trait for others |
//! | [`Recorder`] | an episode as a folder: trajectory, film, map, page, COCO and glTF |
//! | [`Dataset`] | pictures of many homes as one COCO data set |
//! | [`Page`] | an episode in any world as an HTML page |
//! | [`JsonLines`], [`ResumableRun`] | results of long runs, written one by one; a run that was broken off goes on |
//! | [`files`] | reading files, gzipped or not, up to a size limit, and writing them whole or not at all |
//!
//! [`guide`] has recipes: [homes and settings](guide::homes), [acting](guide::acting), [the clock, saving and
//! restoring](guide::clock), [searches](guide::search), [policies and teams](guide::policies),
//! [pictures and sensors](guide::pictures), [streets](guide::streets).
//!
//! # Limitations
//!
//! Agents do not get into vehicles yet. Cloth, liquids and flames are states, not bodies: dirty, wet, cooked
//! and sliced things look so, and vessels show what is in them, but neither how full they are nor the shape of a cut is
//! visible. Worn clothes have no body.

#![warn(clippy::disallowed_methods)]

#[cfg(feature = "environment")]
mod batch;
#[cfg(feature = "procgen")]
mod catalogue;
#[cfg(feature = "environment")]
mod check;
#[cfg(feature = "environment")]
mod city;
#[cfg(feature = "environment")]
mod delta;
#[cfg(feature = "environment")]
mod environment;
pub mod files;
mod json_lines;
mod page;
#[cfg(feature = "environment")]
mod parts;
#[cfg(all(feature = "environment", feature = "render"))]
mod record;

#[cfg(feature = "environment")]
pub use batch::Batch;
#[cfg(feature = "environment")]
pub use check::{ContractViolation, Tally, check_environment, legal_action, random_action, run};
#[cfg(all(feature = "environment", feature = "render"))]
pub use city::CityView;
#[cfg(feature = "environment")]
pub use city::{
    Beyond, City, CityBuilder, CityEnding, CityError, CityObservation, CityRecord, CitySaveError, CityViolation,
    GoalScope, LiftState, RegionLabel, RegionScenes, ReplayError,
};
#[cfg(feature = "environment")]
pub use environment::{
    ActionError, AlterError, Assets, Attempt, Control, ControlledHand, Difference, Disagreement, Displaced, Ending,
    Environment, EnvironmentBuilder, EnvironmentState, Interruption, MakeError, NoRoom, PhysicalRefusal, ResetError,
    ResetReport, SaveError, Spot, SpotRefusal, StateError, Steering, TravelError, Unplaced, UnplacedReason,
};
#[cfg(all(feature = "environment", feature = "render"))]
pub use environment::{
    CameraError, CameraId, JsonFault, Lens, Mount, NamedCamera, PictureError, PictureOptions, Viewpoint,
};
pub use files::{FileError, FileProblem, read_bytes, read_scene, read_text};
pub use json_lines::{JsonLines, ResumableRun};
pub use page::{Page, PageAction, PageFigure, PageFilm};
#[cfg(all(feature = "environment", feature = "render"))]
pub use record::{Dataset, OwnFiles, RecordError, RecordOptions, Recorder};

#[cfg(all(feature = "environment", feature = "render"))]
pub mod guide;
#[cfg(feature = "procgen")]
pub mod initial;
#[cfg(all(feature = "environment", feature = "render"))]
pub mod sensors;

/// The programs of the README, as tests.
#[cfg(all(doctest, feature = "environment", feature = "render"))]
#[doc = include_str!("../README.md")]
mod readme {}

#[cfg(feature = "environment")]
pub use vc_geometry as geometry;
#[cfg(feature = "gltf")]
pub use vc_gltf as gltf;
pub use vc_graph as graph;
/// Vectors, points and poses: the version of nalgebra that all crates of the workspace use.
pub use vc_graph::nalgebra;
#[cfg(feature = "map")]
pub use vc_map as map;
#[cfg(feature = "environment")]
pub use vc_people as people;
#[cfg(feature = "physics")]
pub use vc_physics as physics;
pub use vc_planner as planner;
#[cfg(feature = "procgen")]
pub use vc_procgen as procgen;
pub use vc_relations as relations;
#[cfg(feature = "render")]
pub use vc_render as render;
#[cfg(feature = "procgen")]
pub use vc_shapes as shapes;
pub use vc_tasks as tasks;
