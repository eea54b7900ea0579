//! Digests, which tell whether two scenes are the same.

use crate::hash::{Digest, Digester};
use crate::{Node, NodeId, Observation, SceneGraph};

impl SceneGraph {
    /// A digest of everything in the scene: own words, nodes, states, poses, relations.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.add(Draft::new("kitchen"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.digest(), graph.clone().digest());
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        hash.text(&self.name);
        self.vocabulary().lines().for_each(|line| _ = hash.text(&line));
        self.nodes().for_each(|node| feed(&mut hash, node, |_| true));
        hash.digest()
    }
}

impl Observation {
    /// A digest of the whole observation: the agent, its room, the visible nodes, and the relations between
    /// them.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// let mut scene = SceneBuilder::new("flat");
    /// let [kitchen, bedroom] = ["kitchen", "bedroom"];
    /// let (kitchen, bedroom) = (scene.add(Draft::new(kitchen))?, scene.add(Draft::new(bedroom))?);
    /// let bed = scene.add_in(bedroom, Draft::new("bed"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let before = scene.build();
    /// let mut after = before.clone();
    /// let mut edit = after.edit();
    /// edit.move_to_room(bed, kitchen)?;
    /// edit.commit();
    /// let seen = |graph: &vc_graph::SceneGraph, by| graph.observe(me, by).digest();
    /// assert_eq!(seen(&before, Scope::Room), seen(&before.clone(), Scope::Room));
    /// assert_ne!(seen(&before, Scope::Room), seen(&after, Scope::Room));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        hash.word(u64::from(self.agent().0));
        hash.word(self.room().map_or(u64::MAX, |room| u64::from(room.0)));
        self.nodes().for_each(|node| feed(&mut hash, node, |to| self.sees(to)));
        hash.digest()
    }
}

/// Feeds a node and its relations to nodes for which `told` is true.
fn feed(hash: &mut Digester, node: &Node, told: impl Fn(NodeId) -> bool) {
    let spec = node.spec();
    hash.word(u64::from(node.id.0));
    hash.text(&spec.class).text(&spec.spelling).text(&spec.category);
    hash.text(spec.name.as_deref().unwrap_or_default());
    hash.text(node.contents.as_deref().unwrap_or_default());
    hash.words([spec.properties.builtin_bits(), spec.affordances.builtin_bits(), node.states.builtin_bits()]);
    for own in [spec.properties, spec.affordances] {
        own.feed_own(hash);
    }
    node.states.feed_own(hash);
    if let Some(pose) = &node.pose {
        hash.reals(pose.translation.vector.iter().chain(pose.rotation.coords.iter()).copied());
    }
    if let Some(bounds) = &spec.bounds {
        hash.reals(bounds.offset.iter().chain(bounds.half.iter()).copied());
        hash.word(bounds.frame as u64);
    }
    hash.reals(spec.scale.iter().copied());
    hash.words(spec.slots.iter().map(|slot| (slot.kind as u64) << 32 | u64::from(slot.number)));
    hash.word(spec.asset.map_or(u64::MAX, |asset| u64::from(asset.0)));
    let links = || node.out.iter().filter(|link| told(link.node()));
    hash.word(links().count() as u64);
    hash.words(links().map(|link| (link.relation() as u64) << 32 | u64::from(link.node().0)));
}
