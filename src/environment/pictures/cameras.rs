//! The cameras of an environment, by number and name.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};
use vc_graph::{Label, did_you_mean};
use vc_render::RenderError;

use super::{JsonFault, Lens, Mount, Named, Register, Viewpoint};
use crate::Environment;

/// The number of a camera of an environment: [`Environment::cameras`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct CameraId(pub u32);

impl fmt::Display for CameraId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "camera {}", self.0)
    }
}

/// A camera of an environment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NamedCamera {
    /// Its name, which no other camera of the environment has.
    pub name: String,
    /// Where it is.
    pub mount: Mount,
    /// Which part of the view it shows.
    #[serde(default)]
    pub lens: Lens,
}

impl Named for NamedCamera {
    const KIND: &'static str = "camera";

    fn name(&self) -> &str {
        &self.name
    }
}

/// Why a camera or another sensor was not added, found, changed or removed; then nothing has changed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// Heads and hands are those of agents.
    #[error("{0} is no agent: mount it on a thing (`Mount::Thing`), or name one of `agents()`")]
    NotAnAgent(Label),
    /// Corners and places above are those of rooms.
    #[error("{0} is not a room, or has no bounding box: name one of `graph().rooms()`")]
    NotARoom(Label),
    /// The thing is nowhere.
    #[error("{0} is not there or has no pose: nothing can be mounted on it")]
    NoBody(Label),
    /// Numbers of a pose.
    #[error("a pose is to be finite, within 1,000 km, and its rotation of unit length")]
    Pose,
    /// Numbers of a camera that follows.
    #[error(
        "a camera cannot follow {behind} m behind and {above} m above: the first is to be above 0, and both at most {most}"
    )]
    Tether {
        /// Distance behind, metres.
        behind: f32,
        /// Height above the shoulders, metres.
        above: f32,
        /// The most of both, metres.
        most: f32,
    },
    /// A field of view.
    #[error("a field of view of {0} rad cannot be shown: it is to be above 0 and below half a turn, 3.14159")]
    FieldOfView(f32),
    /// Numbers of a calibrated camera; the text says which, and the range.
    #[error("the intrinsics cannot be used: their {0}")]
    Intrinsics(&'static str),
    /// The name of another.
    #[error("there is a {kind} `{name}` already: `{free}` is free")]
    NameTaken {
        /// `camera` or `sensor`.
        kind: &'static str,
        /// The name.
        name: String,
        /// A name like it that is free.
        free: String,
    },
    /// No name.
    #[error("the name of a {kind} is one line of 1 to {most} bytes, without spaces around it")]
    BadName {
        /// `camera` or `sensor`.
        kind: &'static str,
        /// Its longest name, bytes.
        most: usize,
    },
    /// Nothing has this name.
    #[error("there is no {kind} `{name}`{}", did_you_mean(.name, .nearest.iter().map(String::as_str)))]
    NoSuchName {
        /// `camera` or `sensor`.
        kind: &'static str,
        /// The name of none.
        name: String,
        /// The names that are nearest to it.
        nearest: Vec<String>,
    },
    /// Nothing has this number.
    #[error("there is no {kind} {number}: it was never added, or was removed")]
    NoSuchNumber {
        /// `camera` or `sensor`.
        kind: &'static str,
        /// The number of none.
        number: u32,
    },
    /// A camera that every environment has.
    #[error("`{0}` is there in every environment and stays as it is: add a camera of your own")]
    BuiltIn(String),
    /// The numbers are used up.
    #[error("no number is left for another {0}")]
    TooMany(&'static str),
    /// A text that lists no cameras.
    #[error("this is no list of cameras: {0}")]
    NotAList(#[source] JsonFault),
}

impl CameraError {
    /// The error for a number that no camera has.
    pub(super) fn unknown(camera: CameraId) -> Self {
        Self::NoSuchNumber { kind: NamedCamera::KIND, number: camera.0 }
    }
}

/// The reason why there is no picture.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// There is no such camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The renderer cannot make it.
    #[error(transparent)]
    Render(#[from] RenderError<Label>),
}

impl From<RenderError> for PictureError {
    fn from(error: RenderError) -> Self {
        Self::Render(error.into())
    }
}

/// The cameras that were added to an environment.
#[derive(Debug, Clone, Default)]
pub(in crate::environment) struct Cameras(Register<NamedCamera>);

/// How these are saved.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct CamerasFile {
    next: u32,
    cameras: BTreeMap<u32, NamedCamera>,
}

impl Cameras {
    /// All and the next number, as text; nothing if no camera was ever added.
    pub(in crate::environment) fn saved(&self) -> Option<String> {
        let cameras = self.0.iter().map(|(number, camera)| (number, camera.clone())).collect();
        let file = CamerasFile { next: self.0.next(), cameras };
        (file.next > 0).then(|| serde_json::to_string(&file).unwrap_or_default())
    }

    /// Reads that text. Things on which cameras are mounted may have gone since.
    pub(in crate::environment) fn restored(text: &str) -> Result<Self, CameraError> {
        let file: CamerasFile = serde_json::from_str(text).map_err(|e| CameraError::NotAList(e.into()))?;
        for camera in file.cameras.values() {
            camera.mount.check()?;
            camera.lens.check()?;
        }
        Ok(Self(Register::of(file.next, file.cameras)))
    }
}

impl Environment {
    /// All cameras with their numbers: the eyes of each agent, one in a corner of each room and one above each, one
    /// above the home, and then those that were [added](Self::add_camera).
    ///
    /// ```
    /// use virtualcity::{CameraId, Environment, Viewpoint, render::Modality};
    /// let home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let cameras = home.cameras();
    /// assert_eq!(cameras.len(), 1 + 2 * home.graph().rooms().len() + 1);
    /// assert_eq!(cameras[0].1.name, format!("eyes of character.{}", me.0));
    /// // Any of them makes pictures, and has matrices.
    /// let frame = home.render(Viewpoint::Camera(CameraId(0)), Modality::Depth, 64, 48)?;
    /// let projection = home.camera(Viewpoint::Camera(CameraId(0)), 64, 48)?.projection();
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cameras(&self) -> Vec<(CameraId, NamedCamera)> {
        let built_in = self.built_in().filter_map(|view| {
            let name = view.describe(self.start());
            Some(NamedCamera { name, mount: Mount::of(view)?, lens: Lens::Options })
        });
        let built_in = (0..).map(CameraId).zip(built_in);
        let own = self.own_cameras().iter().map(|(number, camera)| (CameraId(number), camera.clone()));
        built_in.chain(own).collect()
    }

    /// The number of the camera with a name.
    ///
    /// # Errors
    /// [`CameraError::NoSuchName`], with the nearest names.
    pub fn camera_named(&self, name: &str) -> Result<CameraId, CameraError> {
        let views = self.built_in().zip(0..).find(|(view, _)| view.describe(self.start()) == name);
        let number = views.map(|(_, number)| number).or_else(|| self.own_cameras().find(name));
        number.map(CameraId).ok_or_else(|| self.own_cameras().unknown(name, &self.built_in_names()))
    }

    /// Adds a camera, which then makes pictures as [`Viewpoint::Camera`], also in clones that are made from now on and
    /// in environments that are [saved](Self::save). Neither the state of the home nor the [`digest`](Self::digest)
    /// depends on cameras.
    ///
    /// ```
    /// use virtualcity::graph::Pose;
    /// use virtualcity::physics::Hand;
    /// use virtualcity::{Environment, Lens, Mount, Viewpoint, render::Modality};
    ///
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// // Calibrated for 640 by 480 pixels, two metres up, looking along X.
    /// let lens = Lens::Intrinsics { size: (640, 480), focal: (525.0, 525.0), centre: (319.5, 239.5) };
    /// home.add_camera("shelf", Mount::Fixed(Pose::translation(1.0, 2.0, 2.0)), lens)?;
    /// let wrist = home.add_camera("wrist", Mount::wrist(me, Hand::Right), Lens::FieldOfView(1.4))?;
    /// let frame = home.render(Viewpoint::Camera(wrist), Modality::Depth, 64, 48)?;
    ///
    /// assert_eq!(home.camera_named("wrist")?, wrist);
    /// let error = home.camera_named("wirst").unwrap_err();
    /// assert_eq!(error.to_string(), "there is no camera `wirst` (did you mean `wrist`?)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CameraError`] if the name is taken, the mount is on something that is not there or is no place, or no picture can
    /// be made with the lens.
    pub fn add_camera(&mut self, name: impl Into<String>, mount: Mount, lens: Lens) -> Result<CameraId, CameraError> {
        let camera = NamedCamera { name: name.into(), mount, lens };
        Ok(self.with_cameras([camera])?[0])
    }

    /// Adds cameras, all or none.
    pub(in crate::environment) fn with_cameras(
        &mut self,
        cameras: impl IntoIterator<Item = NamedCamera>,
    ) -> Result<Vec<CameraId>, CameraError> {
        let names = self.built_in_names();
        let (first, mut own) = (names.len() as u32, self.own_cameras().clone());
        let mut add = |camera: NamedCamera| {
            self.check_mount(&camera.mount)?;
            camera.lens.check()?;
            own.add(first, &names, camera).map(CameraId)
        };
        let added = cameras.into_iter().map(&mut add).collect::<Result<Vec<CameraId>, CameraError>>()?;
        self.cameras = std::sync::Arc::new(Cameras(own));
        Ok(added)
    }

    /// Puts a camera elsewhere, or gives it another lens; number and name stay.
    ///
    /// # Errors
    /// As [`add_camera`](Self::add_camera); [`CameraError::BuiltIn`], [`CameraError::NoSuchNumber`].
    pub fn change_camera(&mut self, id: CameraId, mount: Mount, lens: Lens) -> Result<(), CameraError> {
        self.check_mount(&mount)?;
        lens.check()?;
        self.check_own(id)?;
        if let Some(camera) = std::sync::Arc::make_mut(&mut self.cameras).0.get_mut(id.0) {
            (camera.mount, camera.lens) = (mount, lens);
        }
        Ok(())
    }

    /// Removes a camera that was added; no other gets its number.
    ///
    /// # Errors
    /// [`CameraError::BuiltIn`], [`CameraError::NoSuchNumber`].
    pub fn remove_camera(&mut self, id: CameraId) -> Result<NamedCamera, CameraError> {
        self.check_own(id)?;
        let removed = std::sync::Arc::make_mut(&mut self.cameras).0.remove(id.0);
        removed.ok_or_else(|| CameraError::unknown(id))
    }

    /// The cameras that were added as a JSON list, for [`add_cameras`](Self::add_cameras) in this or another environment.
    ///
    /// ```
    /// use virtualcity::{Environment, Lens, Mount};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let kitchen = home.graph().of_class("kitchen")[0];
    /// home.add_camera("plan", Mount::Above(kitchen), Lens::FieldOfView(1.0))?;
    /// let text = home.cameras_json();
    ///
    /// let mut other = Environment::make("apartment/42", 1)?;
    /// other.add_cameras(&text)?;
    /// assert_eq!(other.cameras(), home.cameras());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cameras_json(&self) -> String {
        let own: Vec<&NamedCamera> = self.own_cameras().iter().map(|(_, camera)| camera).collect();
        serde_json::to_string_pretty(&own).unwrap_or_default()
    }

    /// Adds the cameras of a JSON list, all or none: `[{"name": "door", "mount": "overhead", "lens": "options"}]`; a lens
    /// may be left out. Returns their numbers.
    ///
    /// # Errors
    /// As [`add_camera`](Self::add_camera); [`CameraError::NotAList`].
    pub fn add_cameras(&mut self, json: &str) -> Result<Vec<CameraId>, CameraError> {
        let cameras: Vec<NamedCamera> = serde_json::from_str(json).map_err(|e| CameraError::NotAList(e.into()))?;
        self.with_cameras(cameras)
    }

    /// The mount and lens of a camera.
    pub(super) fn device(&self, id: CameraId) -> Option<(Mount, Lens)> {
        let built_in = self.built_in().nth(id.0 as usize).and_then(Mount::of).map(|mount| (mount, Lens::Options));
        built_in.or_else(|| self.own_cameras().get(id.0).map(|camera| (camera.mount, camera.lens)))
    }

    /// The camera of a viewpoint by number.
    pub(crate) fn placed(&self, view: Viewpoint) -> Option<NamedCamera> {
        let Viewpoint::Camera(id) = view else { return None };
        self.cameras().into_iter().find(|(known, _)| *known == id).map(|(_, camera)| camera)
    }

    fn own_cameras(&self) -> &Register<NamedCamera> {
        &self.cameras.0
    }

    /// The viewpoints that every environment has. Those of the start, so that numbers stay.
    fn built_in(&self) -> impl Iterator<Item = Viewpoint> {
        let start = self.start();
        let rooms = || start.rooms().iter().copied();
        let eyes = start.agents().iter().copied().map(Viewpoint::Agent);
        eyes.chain(rooms().map(Viewpoint::Room)).chain(rooms().map(Viewpoint::Above)).chain([Viewpoint::Overhead])
    }

    fn built_in_names(&self) -> Vec<String> {
        self.built_in().map(|view| view.describe(self.start())).collect()
    }

    fn check_own(&self, id: CameraId) -> Result<(), CameraError> {
        match self.built_in().nth(id.0 as usize) {
            Some(view) => Err(CameraError::BuiltIn(view.describe(self.start()))),
            None if self.own_cameras().get(id.0).is_some() => Ok(()),
            None => Err(CameraError::NoSuchNumber { kind: NamedCamera::KIND, number: id.0 }),
        }
    }
}
