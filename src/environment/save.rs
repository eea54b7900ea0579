//! Environments as bytes.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::format::native;
use vc_graph::{AssetLibrary, Digest, Event, NodeId, SceneBuilder, SceneGraph};
use vc_physics::{Floor, PhysicsWorld};
use vc_relations::Relations;

use super::{Environment, Past, SaveError};
use crate::parts::{self, Magic};

/// The bytes with which saved environments begin.
const MAGIC: &Magic = b"VCENV 6\n";

impl Environment {
    /// The environment as bytes, for [`restore`](Self::restore), at any time, also in the middle of actions: the settings
    /// that change what follows, the scene (`format::native::write`) and, once a thing of another shape has come, all shapes
    /// (megabytes); the bodies (`PhysicsWorld::save`), the history, the actions that agents were given and do with the
    /// tick at which each goes on, controls, processes, and cameras that were added. Sensors, options of pictures and
    /// threads are not in it. `clone` is a much cheaper copy in memory, [`save_state`](Self::save_state) a much smaller one
    /// of a home at rest.
    ///
    /// Costs some ten milliseconds, and three megabytes in the middle.
    ///
    /// # Errors
    /// [`SaveError::Unread`] if endings of actions wait for the next [`step`](Self::step), which would be lost;
    /// [`SaveError::World`], [`SaveError::Clock`], [`SaveError::Settings`] if something cannot be written.
    pub fn save(&self) -> Result<Vec<u8>, SaveError> {
        match self.unread_endings() {
            0 => {}
            unread => return Err(SaveError::Unread(unread)),
        }
        let history = self.written_history();
        let (shapes, scene, world) = (self.own_shapes(), without_shapes(&self.graph), self.world.save()?);
        let (clock, cameras) = (self.saved_clock()?, self.saved_cameras().unwrap_or_default());
        let head = [self.start.graph.digest().0, u64::from(self.graph.next_number())].map(u64::to_le_bytes).concat();
        let settings = self.saved_settings()?;
        let texts = [&settings, &shapes, &scene, &history, &clock, &cameras].map(|text| text.as_bytes());
        let parts: Vec<&[u8]> = [head.as_slice()].into_iter().chain(texts).chain([world.as_slice()]).collect();
        Ok(parts::joined(MAGIC, &parts))
    }

    /// Restores a saved environment, which then evolves as the saved one does, bit for bit. `self` has to have
    /// been made in the same way as the saved environment, of the same scene and with the same settings, and is not changed:
    /// anything may have happened in it. Options of pictures, sensors and threads are those of `self`.
    ///
    /// Uses `format::native::read`, `PhysicsWorld::restore`, `Relations::rebuild` and `Floor::update`. Costs some tens of
    /// milliseconds.
    ///
    /// # Errors
    /// [`SaveError::NotSaved`], [`SaveError::More`], [`SaveError::Damaged`] if the bytes are not those of a saved
    /// environment; [`SaveError::OtherSetting`] with the name of a setting that was another; [`SaveError::OtherStart`] if
    /// the scene was another; otherwise the error of the part that cannot be read.
    ///
    /// ```
    /// use virtualcity::graph::clock::Span;
    /// use virtualcity::{Environment, SaveError};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// home.give(me, format!("walk fridge.{}", fridge.0).parse()?);
    /// home.step(Span(20));
    /// // On its way, a third of a second after it has set out.
    /// let saved = home.save()?;
    /// let mut other = Environment::make("apartment/42", 1)?.restore(&saved)?;
    /// let minute = Span::from_seconds(60.0);
    /// assert_eq!(home.step_until_idle(minute), other.step_until_idle(minute));
    /// assert_eq!(home.digest(), other.digest());
    ///
    /// let moon = Environment::builder("apartment/42").gravity(1.62).make()?;
    /// assert!(matches!(moon.restore(&saved), Err(SaveError::OtherSetting { setting, .. }) if setting == "gravity"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn restore(&self, bytes: &[u8]) -> Result<Self, SaveError> {
        let parts = parts::split(MAGIC, bytes)?;
        let parts: [&[u8]; 8] = parts.try_into().map_err(|_| SaveError::NotSaved)?;
        let [head, settings, shapes, scene, history, clock, cameras, world] = parts;
        let (digest, next) = parts::number(head)?;
        let (next, _) = parts::number(next)?;
        let text = |bytes| std::str::from_utf8(bytes).map_err(|_| SaveError::NotSaved);
        self.check_settings(text(settings)?)?;
        let (expected, found) = (self.start.graph.digest(), Digest(digest));
        if expected != found {
            return Err(SaveError::OtherStart { expected, found });
        }
        let next = u32::try_from(next).map_err(|_| SaveError::NotSaved)?;
        let graph = self.read_scene(text(scene)?, self.read_shapes(text(shapes)?)?, next)?;
        let world = PhysicsWorld::restore(world, &graph, &self.start.shapes)?;
        let relations = self.start.relations.clone();
        let mut floor = self.start.floor.clone();
        floor.update(&world);
        self.resumed((graph, world, relations, floor), [clock, cameras, history])
    }

    /// An environment that was made in the same way, with another scene and other bodies, in which that goes on which was going
    /// on there: its clock, cameras and history.
    pub(super) fn resumed(
        &self,
        (graph, world, relations, floor): (SceneGraph, PhysicsWorld, Relations, Floor),
        texts: [&[u8]; 3],
    ) -> Result<Self, SaveError> {
        let [clock, cameras, history] = texts.map(|bytes| std::str::from_utf8(bytes).map_err(|_| SaveError::NotSaved));
        let (world, relations, floor) = (world.into(), relations.into(), floor.into());
        let mut copy = Self { graph, world, relations, floor, past: Past::default(), ..self.clone() };
        copy.poses = BTreeMap::new();
        copy.restore_clock(clock?)?;
        copy.restore_cameras(Some(cameras?).filter(|text| !text.is_empty()))?;
        copy.read_history(history?)?;
        Ok(copy)
    }

    pub(super) fn written_history(&self) -> String {
        let line = |e: &Event| format!("{} {}\n", e.agent.0, e.action);
        self.history().events().iter().map(line).collect()
    }

    pub(super) fn read_history(&mut self, text: &str) -> Result<(), SaveError> {
        for line in text.lines() {
            let (agent, action) = line.split_once(' ').ok_or(SaveError::NotSaved)?;
            let agent = NodeId(agent.parse().map_err(|_| SaveError::NotSaved)?);
            self.past.push(Event { agent, action: action.parse()? });
        }
        Ok(())
    }

    /// The bytes of which saves of environments that were made like this one consist for the most part: its own save and all
    /// its shapes.
    pub(crate) fn reference(&self) -> Result<Vec<u8>, SaveError> {
        let mut bytes = self.save()?;
        bytes.extend(shapes_as_text(self.start.graph.assets()).bytes());
        Ok(bytes)
    }

    /// All shapes as text; nothing if they are those of the start.
    pub(super) fn own_shapes(&self) -> String {
        let (own, first) = (self.graph.assets(), self.start.graph.assets());
        if Arc::ptr_eq(own, first) || own == first { String::new() } else { shapes_as_text(own) }
    }

    pub(super) fn read_shapes(&self, text: &str) -> Result<Arc<AssetLibrary>, SaveError> {
        if text.is_empty() {
            return Ok(self.start.graph.assets().clone());
        }
        Ok(native::read(text, self.start.graph.classes())?.assets().clone())
    }

    /// Reads a scene of this environment that was written [without shapes](without_shapes), in which the next node gets
    /// a number.
    fn read_scene(&self, text: &str, shapes: Arc<AssetLibrary>, next: u32) -> Result<SceneGraph, SaveError> {
        let mut builder = SceneBuilder::from_graph(native::read(text, self.start.graph.classes())?);
        builder.assets(shapes).number_from(next);
        Ok(builder.build())
    }
}

/// Shapes as text: that of a scene without nodes.
pub(crate) fn shapes_as_text(shapes: &Arc<AssetLibrary>) -> String {
    let mut scene = SceneBuilder::new("shapes");
    scene.assets(shapes.clone());
    native::write(&scene.build())
}

/// A scene as text, but for the shapes of its things.
fn without_shapes(graph: &SceneGraph) -> String {
    let mut bare = SceneBuilder::from_graph(graph.clone());
    bare.assets(Arc::default());
    native::write(&bare.build())
}

#[cfg(feature = "render")]
impl Environment {
    pub(super) fn saved_cameras(&self) -> Option<String> {
        self.cameras.saved()
    }

    pub(super) fn restore_cameras(&mut self, saved: Option<&str>) -> Result<(), SaveError> {
        let cameras = saved.map(super::pictures::Cameras::restored).transpose()?;
        self.cameras = std::sync::Arc::new(cameras.unwrap_or_default());
        Ok(())
    }
}

/// Without pictures there are no cameras, and those of a file are passed over.
#[cfg(not(feature = "render"))]
impl Environment {
    pub(super) fn saved_cameras(&self) -> Option<String> {
        None
    }

    #[allow(clippy::unnecessary_wraps, reason = "with pictures it may fail")]
    pub(super) fn restore_cameras(&mut self, _: Option<&str>) -> Result<(), SaveError> {
        Ok(())
    }
}
