//! A number that says whether two scenes are the same.

use std::fmt;
use std::hash::Hasher;

use crate::vocabulary::Set;
use crate::{Node, SceneGraph};

/// A 64-bit digest of a scene's content, the same on every machine.
///
/// FNV-1a: good for noticing a difference, no protection against an adversary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Digest(pub u64);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// FNV-1a (Fowler, Noll, Vo), with its published constants.
struct Fnv(u64);

impl Hasher for Fnv {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

impl Fnv {
    fn text(&mut self, text: &str) {
        self.number(text.len() as u64);
        self.write(text.as_bytes());
    }

    fn number(&mut self, number: u64) {
        self.write(&number.to_le_bytes());
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
        let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
        hash.text(&self.name);
        self.nodes().for_each(|node| feed(&mut hash, node));
        Digest(hash.finish())
    }
}

fn feed(hash: &mut Fnv, node: &Node) {
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
    }
    hash.number(node.out.len() as u64);
    for link in &node.out {
        hash.number(link.relation as u64);
        hash.number(u64::from(link.node.0));
    }
}
