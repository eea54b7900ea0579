//! Environments as bytes.

use std::collections::BTreeMap;

use vc_graph::format::native;
use vc_graph::{Digest, Event, History, NodeId, SceneBuilder};
use vc_physics::PhysicsWorld;

use super::clock::Clock;
use super::undo::Undo;
use super::{Environment, SaveError, observe};

/// The bytes with which saved environments begin: without cameras that were added, and with them.
const MAGIC: [&[u8; 8]; 2] = [b"VCENV 2\n", b"VCENV 3\n"];

impl Environment {
    /// The environment as bytes, for [`restore`](Self::restore): the scene (`format::native::write`), the
    /// bodies (`PhysicsWorld::save`), the history, and cameras that were added. `clone` is a much cheaper copy in memory.
    ///
    /// # Errors
    /// [`SaveError::World`], [`SaveError::Busy`] while actions take their time.
    pub fn save(&self) -> Result<Vec<u8>, SaveError> {
        if self.is_busy() {
            return Err(SaveError::Busy(self.busy()));
        }
        let line = |e: &Event| format!("{} {}\n", e.agent.0, e.action);
        let history: String = self.history.events().iter().map(line).collect();
        let cameras = self.saved_cameras();
        let mut bytes = MAGIC[usize::from(cameras.is_some())].to_vec();
        bytes.extend(self.start.graph.digest().0.to_le_bytes());
        bytes.extend(u64::from(self.graph.next_number()).to_le_bytes());
        let (scene, world) = (native::write(&self.graph), self.world.save()?);
        let parts = [scene.as_bytes(), &world, history.as_bytes()];
        for part in parts.into_iter().chain(cameras.as_ref().map(String::as_bytes)) {
            bytes.extend((part.len() as u64).to_le_bytes());
            bytes.extend(part);
        }
        Ok(bytes)
    }

    /// Restores a saved environment, which then evolves as the saved one does, bit for bit. `self` has to have
    /// been made in the same way as the saved environment, and is not changed.
    ///
    /// Uses `format::native::read`, `PhysicsWorld::restore`, `Relations::rebuild` and `Floor::update`.
    ///
    /// # Errors
    /// [`SaveError`] if the bytes are no saved environment, or were saved by one with another start.
    pub fn restore(&self, bytes: &[u8]) -> Result<Self, SaveError> {
        let begins = |magic: &[u8; 8]| bytes.strip_prefix(magic.as_slice());
        let with_cameras = begins(MAGIC[1]).is_some();
        let rest = MAGIC.into_iter().find_map(begins).ok_or(SaveError::NotSaved)?;
        let (digest, rest) = number(rest)?;
        let (expected, found) = (self.start.graph.digest(), Digest(digest));
        if expected != found {
            return Err(SaveError::OtherStart { expected, found });
        }
        let (next, rest) = number(rest)?;
        let next = u32::try_from(next).map_err(|_| SaveError::NotSaved)?;
        let (scene, rest) = part(rest)?;
        let (world, rest) = part(rest)?;
        let (history, rest) = part(rest)?;
        let (cameras, rest) =
            if with_cameras { part(rest).map(|(own, rest)| (Some(own), rest))? } else { (None, rest) };
        if !rest.is_empty() {
            return Err(SaveError::More(rest.len()));
        }
        let text = |bytes| std::str::from_utf8(bytes).map_err(|_| SaveError::NotSaved);
        let mut graph = native::read(text(scene)?, self.start.graph.classes())?;
        let mut builder = SceneBuilder::from_graph(graph);
        if builder.graph().assets() == self.graph.assets() {
            builder.assets(self.graph.assets().clone());
        }
        builder.number_from(next);
        graph = builder.build();
        let world = PhysicsWorld::restore(world, &graph, &self.start.shapes)?;
        let mut relations = self.start.relations.clone();
        relations.rebuild(&graph)?;
        relations.set_evidence(&graph, observe::evidence(&world))?;
        let mut floor = self.start.floor.clone();
        floor.update(&world);
        let none = (History::default(), Undo::default());
        let mut copy = Self { graph, world, relations, floor, history: none.0, undo: none.1, ..self.clone() };
        (copy.poses, copy.clock) = (BTreeMap::new(), Clock::at(&copy.world));
        copy.restore_cameras(cameras.map(text).transpose()?)?;
        for line in text(history)?.lines() {
            let (agent, action) = line.split_once(' ').ok_or(SaveError::NotSaved)?;
            let agent = NodeId(agent.parse().map_err(|_| SaveError::NotSaved)?);
            copy.history.push(Event { agent, action: action.parse()? });
        }
        Ok(copy)
    }
}

#[cfg(feature = "render")]
impl Environment {
    fn saved_cameras(&self) -> Option<String> {
        self.cameras.saved()
    }

    fn restore_cameras(&mut self, saved: Option<&str>) -> Result<(), SaveError> {
        let cameras = saved.map(super::pictures::Cameras::restored).transpose()?;
        self.cameras = std::sync::Arc::new(cameras.unwrap_or_default());
        Ok(())
    }
}

/// Without pictures there are no cameras, and those of a file are passed over.
#[cfg(not(feature = "render"))]
impl Environment {
    fn saved_cameras(&self) -> Option<String> {
        None
    }

    #[allow(clippy::unnecessary_wraps, reason = "with pictures it may fail")]
    fn restore_cameras(&mut self, _: Option<&str>) -> Result<(), SaveError> {
        Ok(())
    }
}

fn number(bytes: &[u8]) -> Result<(u64, &[u8]), SaveError> {
    let (head, rest) = bytes.split_first_chunk::<8>().ok_or(SaveError::NotSaved)?;
    Ok((u64::from_le_bytes(*head), rest))
}

/// Splits off a length and as many bytes.
fn part(bytes: &[u8]) -> Result<(&[u8], &[u8]), SaveError> {
    let (length, rest) = number(bytes)?;
    let length = usize::try_from(length).map_err(|_| SaveError::NotSaved)?;
    rest.split_at_checked(length).ok_or(SaveError::NotSaved)
}
