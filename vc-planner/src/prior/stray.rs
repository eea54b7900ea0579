//! Probability of a kind of place for a thing that is not at a habitual place.

use vc_graph::portable::Portable;
use vc_graph::{NodeId, Relation, SceneGraph};

use super::RelatedClasses;
use super::kinds::PlaceKind;

/// Factor for a room in which related things are not kept anywhere, such as a bathroom for a plate.
const FOREIGN: f64 = 0.2;
/// Weight of any place besides the fraction of the thing's relatives that is kept there.
const ANY: f64 = 0.1;
/// Factor for a place into which the thing does not fit, or over whose edge it would stick out.
const MISFIT: f64 = 0.02;
/// Exponent of the volume: a place of eight times the volume holds twice as much.
const GROWTH: f64 = 1.0 / 3.0;
/// Usable height above a surface, metres, and the effective volume of a floor, cubic metres.
const ABOVE: f64 = 0.3;
const FLOOR: f64 = 0.03;
/// The volume if none is known, the lower limit (no probability is zero), and the upper limit, cubic metres.
const UNKNOWN: f64 = 0.1;
const LEAST: f64 = 1e-6;
const LARGEST: f64 = 1.0;

/// The unnormalized probability that a thing is at any of the places of a kind.
pub(crate) fn stray(graph: &SceneGraph, related: &RelatedClasses, id: NodeId, kind: &PlaceKind, home: bool) -> f64 {
    let classes = graph.classes();
    let thing = graph.node(id).and_then(|n| classes.get(n.class()));
    let at = (!kind.floor).then(|| classes.get(&kind.at)).flatten();
    let kept = thing.map_or(0.0, |thing| related.part(classes, thing, kind.relation, at));
    let fits = fits(size(graph, id), kind);
    (ANY + kept) * volume(kind).power(GROWTH) * if fits { 1.0 } else { MISFIT } * if home { 1.0 } else { FOREIGN }
}

/// The size of a thing, its own or the typical size of its class: depth, width, height, metres.
pub(crate) fn size(graph: &SceneGraph, id: NodeId) -> Option<[f64; 3]> {
    let node = graph.node(id)?;
    let usual = || graph.classes().get(node.class())?.typical_size();
    let size = node.spec().bounds.map(|b| b.size()).or_else(usual)?;
    Some([size.x, size.y, size.z].map(f64::from))
}

/// Whether a thing fits into a container in some orientation, or onto a surface.
fn fits(thing: Option<[f64; 3]>, kind: &PlaceKind) -> bool {
    let (Some(mut thing), Some(mut space)) = (thing, kind.size) else { return true };
    if kind.floor {
        return true;
    }
    if kind.relation == Relation::On {
        // The thing may stand on its smallest side.
        space[2] = f64::INFINITY;
    }
    thing.sort_unstable_by(f64::total_cmp);
    space.sort_unstable_by(f64::total_cmp);
    thing.iter().zip(space).all(|(thing, space)| *thing <= space)
}

fn volume(kind: &PlaceKind) -> f64 {
    let volume = match (kind.size, kind.relation) {
        _ if kind.floor => FLOOR,
        (None, _) => UNKNOWN,
        (Some([x, y, z]), Relation::Inside) => x * y * z,
        (Some([x, y, _]), _) => x * y * ABOVE,
    };
    volume.clamp(LEAST, LARGEST)
}
