//! Input errors: numbers that no scene can have.

use std::fmt;
use std::sync::Arc;

use vc_graph::{Asset, AssetId, AssetLibrary, Edge, Label, Node, NodeId, Relation, SceneGraph};

use crate::evidence::{Evidence, NodeEvidence};
use crate::threshold::{BOX_GAP, ROTATION_SLACK, WORLD_REACH};

/// A flaw of a scene, or of the evidence about it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InputFlaw {
    /// A number is not finite.
    #[error("{what} of {node} is not finite")]
    NotFinite {
        /// The node.
        node: Label,
        /// The quantity.
        what: &'static str,
    },
    /// A coordinate or size at which single precision no longer resolves a millimetre.
    #[error("{what} of {node} is {} m, more than {WORLD_REACH} m", short(*.value))]
    TooFar {
        /// The node.
        node: Label,
        /// The quantity.
        what: &'static str,
        /// Its value, metres.
        value: f32,
    },
    /// A negative size, or a scale of zero.
    #[error("{what} of {node} is {}, which is not a valid size", short(*.value))]
    NoSize {
        /// The node.
        node: Label,
        /// The quantity.
        what: &'static str,
        /// Its value.
        value: f32,
    },
    /// An asset so large that single precision no longer resolves a millimetre.
    #[error("asset `{name}` reaches {} m from its origin, more than {WORLD_REACH} m", short(*.value))]
    HugeAsset {
        /// The asset's name.
        name: Arc<str>,
        /// Its greatest coordinate, metres.
        value: f32,
    },
    /// The rotation of a pose is not a unit quaternion.
    #[error("the rotation of {node} has length {length} instead of 1")]
    NoRotation {
        /// The node.
        node: Label,
        /// Length of its quaternion.
        length: f32,
    },
    /// An edge of the evidence has a relation other than holding and wearing.
    #[error("evidence: {from} {relation} {to} is neither holding nor wearing")]
    NotHolding {
        /// The node at which the edge starts.
        from: Label,
        /// Its relation.
        relation: Relation,
        /// The node at which it ends.
        to: Label,
    },
    /// A distance at which nothing, or too much, would be a support.
    #[error("a tolerance of {0} m is not from 0 to {BOX_GAP} m")]
    Tolerance(f32),
}

/// Formats a number with few digits.
fn short(value: f32) -> String {
    if value == 0.0 || (1e-3..1e7).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// All flaws that keep a scene from being read; never empty.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// let mut scene = SceneBuilder::new("hall");
/// let huge = Bounds::standing([1e9, 1.0, 1.0].into());
/// scene.add(Draft::new("table").bounds(huge).at(Pose::identity()))?;
/// assert_eq!(vc_relations::relations(&scene.build()).map_err(|error| error.flaws.len()), Err(1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct InputError {
    /// All flaws, by node.
    pub flaws: Vec<InputFlaw>,
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, flaw) in self.flaws.iter().enumerate() {
            write!(f, "{}{flaw}", if number == 0 { "" } else { "; " })?;
        }
        Ok(())
    }
}

impl std::error::Error for InputError {}

fn refuse_if_any(flaws: Vec<InputFlaw>) -> Result<(), InputError> {
    if flaws.is_empty() { Ok(()) } else { Err(InputError { flaws }) }
}

/// # Errors
/// Every flaw of every node.
pub(crate) fn check_scene(graph: &SceneGraph) -> Result<(), InputError> {
    let mut flaws = Vec::new();
    graph.nodes().for_each(|node| check_node(node, &mut flaws));
    refuse_if_any(flaws)
}

/// Checks the sizes of a scene's boxes only. This is cheap, while bodies of huge boxes are slow: check first.
///
/// # Errors
/// Every size that no box can have.
///
/// ```
/// # let home = vc_testkit::kitchen::kitchen();
/// assert_eq!(vc_relations::check_sizes(&home.graph), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_sizes(graph: &SceneGraph) -> Result<(), InputError> {
    let mut flaws = Vec::new();
    graph.nodes().for_each(|node| check_size(node, &mut flaws));
    refuse_if_any(flaws)
}

/// # Errors
/// Every flaw of these nodes; nodes that do not exist have none.
pub(crate) fn check_nodes(graph: &SceneGraph, ids: &[NodeId]) -> Result<(), InputError> {
    let mut flaws = Vec::new();
    ids.iter().filter_map(|id| graph.node(*id)).for_each(|node| check_node(node, &mut flaws));
    refuse_if_any(flaws)
}

/// # Errors
/// Every asset that is too large; the library has already checked the other numbers of its assets.
pub(crate) fn check_assets(library: &AssetLibrary) -> Result<(), InputError> {
    let asset = |i: usize| library.get(AssetId(i as u32));
    let flaw = |asset: &Arc<Asset>| {
        let (low, high) = asset.extent()?;
        let value = low.coords.abs().sup(&high.coords.abs()).max();
        (value > WORLD_REACH).then(|| InputFlaw::HugeAsset { name: asset.name.clone(), value })
    };
    refuse_if_any((0..library.len()).filter_map(asset).filter_map(flaw).collect())
}

fn check_node(node: &Node, flaws: &mut Vec<InputFlaw>) {
    let id = || node.label();
    if let Some(pose) = node.pose() {
        check(&id, "position", pose.translation.vector.as_slice(), -WORLD_REACH, flaws);
        let length = pose.rotation.norm();
        if (length - 1.0).abs() > ROTATION_SLACK || !length.is_finite() {
            flaws.push(InputFlaw::NoRotation { node: id(), length });
        }
    }
    if let Some(bounds) = node.spec().bounds {
        check(&id, "offset", bounds.offset.as_slice(), -WORLD_REACH, flaws);
    }
    check_size(node, flaws);
    let scale = node.spec().scale.abs();
    check(&id, "scale", scale.as_slice(), f32::MIN_POSITIVE, flaws);
}

fn check_size(node: &Node, flaws: &mut Vec<InputFlaw>) {
    if let Some(bounds) = node.spec().bounds {
        check(&|| node.label(), "size", bounds.half.as_slice(), 0.0, flaws);
    }
}

fn check(node: &dyn Fn() -> Label, what: &'static str, numbers: &[f32], least: f32, flaws: &mut Vec<InputFlaw>) {
    let flaw = |&value: &f32| match value {
        v if !v.is_finite() => Some(InputFlaw::NotFinite { node: node(), what }),
        v if v.abs() > WORLD_REACH => Some(InputFlaw::TooFar { node: node(), what, value }),
        v if v < least => Some(InputFlaw::NoSize { node: node(), what, value }),
        _ => None,
    };
    flaws.extend(numbers.iter().find_map(flaw));
}

/// # Errors
/// Every flaw of the evidence. Nodes that are not in the scene are ignored, as they may be added later.
pub(crate) fn check_evidence(graph: &SceneGraph, evidence: &Evidence) -> Result<(), InputError> {
    let label = |id| graph.label(id);
    let not_finite = |id, what| InputFlaw::NotFinite { node: label(id), what };
    let contacts = evidence.contacts.iter().filter(|c| !c.impulse.iter().all(|v| v.is_finite()));
    let positions = evidence.positions.iter().filter(|p| !p.1.is_finite());
    let holding = [Relation::HoldsRight, Relation::HoldsLeft, Relation::WornBy];
    let held = evidence.held.iter().filter(|e| !holding.contains(&e.relation));
    let mut flaws: Vec<InputFlaw> = contacts.map(|c| not_finite(c.between.1, "the impulse of a contact")).collect();
    flaws.extend(positions.map(|(key, _)| not_finite(key.0, "the position of a moving part")));
    let not_holding = |e: &Edge| InputFlaw::NotHolding { from: label(e.from), relation: e.relation, to: label(e.to) };
    flaws.extend(held.map(not_holding));
    refuse_if_any(flaws)
}

/// # Errors
/// Every position of a moving part that is no number.
pub(crate) fn check_positions(graph: &SceneGraph, evidence: &[NodeEvidence]) -> Result<(), InputError> {
    let flawed = evidence.iter().filter(|said| !said.positions.iter().all(|p| p.is_finite()));
    let flaw = |said: &NodeEvidence| InputFlaw::NotFinite {
        node: graph.label(said.node),
        what: "the position of a moving part",
    };
    refuse_if_any(flawed.map(flaw).collect())
}
