//! The home that is drawn, its room, and where the camera stands in it.

use std::path::Path;

use virtualcity::graph::class::Category;
use virtualcity::graph::{ClassTable, NodeId, SceneGraph, Seed, did_you_mean};
use virtualcity::procgen::{Apartment, Dressing, Specification, dress};
use virtualcity::render::{Camera, Renderer, Snapshot};
use virtualcity::{Assets, Environment, PictureOptions, Viewpoint};

use crate::support::{Complaint, say};

/// A scene, and the environment that was made of it if it was read from a file.
pub(crate) struct Home {
    pub(crate) scene: SceneGraph,
    environment: Option<Environment>,
}

impl Home {
    pub(crate) fn generated(seed: u64, dressing: Option<Dressing>, fitted_kitchens: bool) -> Result<Self, Complaint> {
        let wishes = Specification { dressing, fitted_kitchens, ..Specification::default() };
        let home = Apartment::generate(&wishes, Seed(seed)).map_err(Complaint::new)?;
        Ok(Self { scene: home.scene(), environment: None })
    }

    /// The home of a file as an environment has it: things have shapes, people have figures, all rests. A scene in which
    /// nobody can stand, such as a table without a floor, is drawn as it is.
    pub(crate) fn read(path: &Path) -> Result<Self, Complaint> {
        let scene = virtualcity::read_scene(path, &ClassTable::builtin())?;
        match Environment::builder_from_scene(scene.clone()).assets(Assets::Generated).make() {
            Ok(home) => Ok(Self { scene: without_guests(&home, &scene)?, environment: Some(home) }),
            Err(error) => {
                say!("remark {}: drawn as it is; {error}", path.display());
                Ok(Self { scene: shaped(scene)?, environment: None })
            }
        }
    }

    /// The first room of a class.
    pub(crate) fn room(&self, class: &str) -> Result<NodeId, Complaint> {
        let classes = ClassTable::builtin();
        if classes.get(class).is_none_or(|class| class.category != Category::Room) {
            let rooms = classes.iter().filter(|class| class.category == Category::Room).map(|class| &*class.name);
            let near = did_you_mean(class, rooms);
            return Err(Complaint::new(format!("--room: there is no class of rooms `{class}`{near}")));
        }
        self.scene.of_class(class).first().copied().ok_or_else(|| {
            let names: Vec<String> =
                self.scene.rooms().iter().map(|r| self.scene.label(*r).class.to_string()).collect();
            Complaint::new(format!("the home has no {class}; it has {}", names.join(", ")))
        })
    }

    /// The camera that shows most of a room.
    pub(crate) fn camera(
        &self,
        room: NodeId,
        (renderer, snapshot): (&Renderer, &Snapshot),
        (width, height): (u32, u32),
    ) -> Result<Camera, Complaint> {
        match &self.environment {
            Some(home) => home.camera(Viewpoint::Room(room), width, height).map_err(Complaint::new),
            None => {
                let camera = Camera::with_fov(width, height, PictureOptions::default().field_of_view);
                renderer.viewpoint(snapshot, room, &camera).map_err(Complaint::new)
            }
        }
    }
}

/// An environment's scene without the people that the file does not have.
fn without_guests(home: &Environment, file: &SceneGraph) -> Result<SceneGraph, Complaint> {
    let mut scene = home.graph().clone();
    let mut edit = scene.edit();
    let guests = home.agents().iter().filter(|agent| !file.agents().contains(agent));
    guests.into_iter().try_for_each(|guest| edit.remove(*guest).map(drop)).map_err(Complaint::new)?;
    edit.commit();
    Ok(scene)
}

/// A scene of boxes with the shapes of its classes; a scene with shapes as it is.
fn shaped(scene: SceneGraph) -> Result<SceneGraph, Complaint> {
    let bare = scene.assets().is_empty();
    if bare { dress::dressed(&scene, dress::seed_of(&scene)).map_err(Complaint::new) } else { Ok(scene) }
}
