//! Snapshots and digests of worlds.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{Digest, NodeId, SceneGraph};

use crate::engine::Engine;
use crate::shapes::ShapeCache;
use crate::state::{Agent, Effector, Hand, Places, Thing, ThingState, Vehicle, Waters};
use crate::world::PhysicsWorld;
use crate::{Settings, SnapshotError};

/// The first bytes of a snapshot.
const MAGIC: &[u8; 8] = b"VCWORLD\n";
/// The format version, increased whenever the content changes.
const VERSION: u32 = 8;
/// Bytes before the content: magic, version, checksum.
const HEAD: usize = 20;

/// The content of a snapshot. Forms and rooms are reconstructed from the scene graph.
#[derive(Serialize, Deserialize)]
struct Content {
    settings: Settings,
    engine: Engine,
    things: Vec<(NodeId, ThingState)>,
    agents: BTreeMap<NodeId, Agent>,
    vehicles: BTreeMap<NodeId, Vehicle>,
    waters: Waters,
    driven: Vec<(NodeId, usize)>,
    ticks: u64,
    stopped: Vec<NodeId>,
    skipped: Vec<NodeId>,
}

/// # Snapshots
impl PhysicsWorld {
    /// The world as bytes, for [`restore`](Self::restore), about 3 KiB per body. A copy in memory by `clone` is
    /// several times cheaper.
    ///
    /// # Errors
    /// [`SnapshotError::Unwritable`].
    pub fn save(&self) -> Result<Vec<u8>, SnapshotError> {
        let copy = self.clone();
        let content = Content {
            settings: copy.settings,
            engine: copy.engine,
            things: copy.things.into_iter().map(|t| (t.id, t.state)).collect(),
            agents: copy.agents,
            vehicles: copy.vehicles,
            waters: copy.waters,
            driven: copy.driven,
            ticks: copy.ticks,
            stopped: copy.stopped,
            skipped: copy.skipped,
        };
        let unwritable = |e: postcard::Error| SnapshotError::Unwritable(e.to_string());
        let mut body = postcard::to_allocvec(&content).map_err(unwritable)?;
        // They follow only where there are any.
        if !copy.effectors.is_empty() {
            body.extend(postcard::to_allocvec(&copy.effectors).map_err(unwritable)?);
        }
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(checksum(&body).to_le_bytes());
        bytes.extend(body);
        Ok(bytes)
    }

    /// Restores a saved world. It evolves as the saved one does, bit for bit.
    ///
    /// `graph` is the scene from which the world was built; nodes that were inserted later have to be in it.
    /// The checksum detects damage, not malice: forged bytes may pass it without being a valid world, so
    /// restore only snapshots from a trusted source.
    ///
    /// # Errors
    /// [`SnapshotError`] if the bytes are no snapshot, are damaged, or belong to another scene.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::{PhysicsWorld, ShapeCache};
    /// let mut copy = PhysicsWorld::restore(&world.save()?, &home.graph, &ShapeCache::new())?;
    /// copy.run(10);
    /// world.run(10);
    /// assert_eq!(copy.digest(), world.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn restore(bytes: &[u8], graph: &SceneGraph, shapes: &ShapeCache) -> Result<Self, SnapshotError> {
        let (content, effectors) = decoded(bytes)?;
        let other = |id: NodeId| SnapshotError::OtherScene(graph.label(id));
        let things = shapes.session(graph.assets(), |session| {
            let form = |(id, state): (NodeId, ThingState)| {
                let node = graph.node(id).ok_or_else(|| other(id))?;
                let form = session.form(graph, node);
                let form = form.filter(|f| f.links.len() == state.moving.len() + 1);
                Ok(Thing { id, form: form.ok_or_else(|| other(id))?, places: Places::new(node), state })
            };
            content.things.into_iter().map(form).collect::<Result<Vec<Thing>, SnapshotError>>()
        })?;
        let mut world = Self {
            settings: content.settings,
            engine: content.engine,
            things,
            agents: content.agents,
            effectors,
            vehicles: content.vehicles,
            waters: content.waters,
            driven: content.driven,
            rooms: crate::world::rooms(graph),
            bottom: f32::NEG_INFINITY,
            ticks: content.ticks,
            stopped: content.stopped,
            skipped: content.skipped,
            bars: Vec::new(),
        };
        world.find_bottom();
        world.find_bars();
        Ok(world)
    }

    /// A 64-bit digest of the dynamic state: poses, velocities and sleep of all bodies, parts on joints,
    /// agents, vehicles, water, fill levels and the time. Equal worlds have equal digests, whatever their
    /// history.
    pub fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        hash.word(self.ticks);
        for (handle, body) in self.engine.bodies.iter() {
            let (pose, linear, spin) = (body.position(), body.linvel(), body.angvel());
            hash.word(u64::from(handle.into_raw_parts().0) << 1 | u64::from(body.is_sleeping()));
            hash.reals(pose.translation.to_array());
            hash.reals(pose.rotation.to_array());
            hash.reals(linear.to_array());
            hash.reals(spin.to_array());
        }
        for thing in &self.things {
            hash.word(u64::from(thing.id.0) << 8 | thing.state.role as u64);
            for moving in &thing.state.moving {
                hash.reals([moving.position, moving.target.unwrap_or(f32::MAX)]);
                hash.word(u64::from(moving.locked) << 1 | u64::from(moving.latched));
            }
        }
        self.agents.iter().for_each(|(id, agent)| agent.feed(*id, &mut hash));
        self.effectors.values().for_each(|effector| effector.feed(&mut hash));
        self.waters.feed(&mut hash);
        self.vehicles.iter().for_each(|(id, vehicle)| vehicle.feed(*id, &mut hash));
        hash.digest()
    }
}

/// The guided hands of a world.
type Effectors = BTreeMap<(NodeId, Hand), Effector>;

fn decoded(bytes: &[u8]) -> Result<(Content, Effectors), SnapshotError> {
    let head = bytes.get(..HEAD).filter(|h| h.starts_with(MAGIC)).ok_or(SnapshotError::NotASnapshot)?;
    let number = |from: usize, to: usize| head[from..to].iter().rev().fold(0_u64, |n, b| n << 8 | u64::from(*b));
    let found = number(8, 12) as u32;
    if found != VERSION {
        return Err(SnapshotError::Version { found, expected: VERSION });
    }
    let body = &bytes[HEAD..];
    if checksum(body) != number(12, 20) {
        return Err(SnapshotError::Damaged);
    }
    let (content, rest) = postcard::take_from_bytes(body).map_err(|_| SnapshotError::Damaged)?;
    let effectors = (!rest.is_empty()).then(|| postcard::from_bytes(rest)).transpose();
    Ok((content, effectors.map_err(|_| SnapshotError::Damaged)?.unwrap_or_default()))
}

fn checksum(bytes: &[u8]) -> u64 {
    Digester::new().bytes(bytes).digest().0
}
