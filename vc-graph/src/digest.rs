//! A number that says whether two scenes are the same.

use std::fmt;

use crate::vocabulary::Set;
use crate::{Node, NodeId, Observation, SceneGraph};

/// A 64-bit digest of a scene's content, the same on every machine.
///
/// FNV-1a (Fowler, Noll, Vo) over 64-bit words: good for noticing a difference, no
/// protection against an adversary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Digest(pub u64);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// The published constants of 64-bit FNV.
const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

struct Fnv(u64);

impl Fnv {
    fn number(&mut self, number: u64) {
        // Words, not bytes: the fold brings the high bits down, which FNV's
        // multiplication alone never does.
        let mixed = (self.0 ^ number).wrapping_mul(PRIME);
        self.0 = mixed ^ (mixed >> 32);
    }

    fn text(&mut self, text: &str) {
        self.number(text.len() as u64);
        for chunk in text.as_bytes().chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.number(u64::from_le_bytes(word));
        }
    }

    fn set<W: crate::vocabulary::Word>(&mut self, set: Set<W>) {
        self.number(set.bits());
    }

    fn real(&mut self, value: f32) {
        self.number(u64::from(value.to_bits()));
    }
}

impl SceneGraph {
    /// A digest of everything in the scene: nodes, states, poses, relations.
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
        let mut hash = Fnv(OFFSET);
        hash.text(&self.name);
        self.nodes().for_each(|node| feed(&mut hash, node, |_| true));
        Digest(hash.0)
    }
}

impl Observation {
    /// A digest of all that is seen: by whom, in which room, the nodes, and the relations
    /// between them.
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
        let mut hash = Fnv(OFFSET);
        hash.number(u64::from(self.agent().0));
        hash.number(self.room().map_or(u64::MAX, |room| u64::from(room.0)));
        self.nodes().for_each(|node| feed(&mut hash, node, |to| self.sees(to)));
        Digest(hash.0)
    }
}

/// Adds a node and those of its relations whose other end is told of.
fn feed(hash: &mut Fnv, node: &Node, told: impl Fn(NodeId) -> bool) {
    let spec = node.spec();
    hash.number(u64::from(node.id.0));
    for text in [&spec.class, &spec.spelling, &spec.category] {
        hash.text(text);
    }
    hash.text(spec.name.as_deref().unwrap_or_default());
    hash.text(node.contents.as_deref().unwrap_or_default());
    hash.set(spec.properties);
    hash.set(spec.affordances);
    hash.set(node.states);
    if let Some(pose) = &node.pose {
        pose.translation.vector.iter().chain(pose.rotation.coords.iter()).for_each(|v| hash.real(*v));
    }
    if let Some(bounds) = &spec.bounds {
        bounds.offset.iter().chain(bounds.half.iter()).for_each(|v| hash.real(*v));
        hash.number(bounds.frame as u64);
    }
    spec.scale.iter().for_each(|v| hash.real(*v));
    for slot in spec.slots.iter() {
        hash.number((slot.kind as u64) << 32 | u64::from(slot.number));
    }
    hash.number(spec.asset.map_or(u64::MAX, |asset| u64::from(asset.0)));
    let links = || node.out.iter().filter(|link| told(link.node()));
    hash.number(links().count() as u64);
    for link in links() {
        hash.number((link.relation() as u64) << 32 | u64::from(link.node().0));
    }
}
