//! How likely a thing that is not where habit puts it is at a kind of place.

use vc_graph::{NodeId, Relation, SceneGraph};

use super::Kin;
use super::kinds::PlaceKind;

/// How much less likely something is astray in a room where things like it are not kept
/// anywhere: a plate in a bathroom.
const FOREIGN: f64 = 0.2;
/// The weight that any place has beside the part of the thing's kin that is kept there.
const ANY: f64 = 0.1;
/// How much less likely a thing is at a place where it does not go in, or lies over the edge.
const MISFIT: f64 = 0.02;
/// How the chance grows with the volume: a place of eight times the volume holds twice as much.
const GROWTH: f64 = 1.0 / 3.0;
/// Room above a surface that counts, metres, and the volume of a floor, cubic metres.
const ABOVE: f64 = 0.3;
const FLOOR: f64 = 0.03;
/// The volume where none is known, cubic metres; the least, as no chance is zero, and the most that count.
const UNKNOWN: f64 = 0.1;
const LEAST: f64 = 1e-6;
const LARGEST: f64 = 1.0;

/// How likely a thing is at places of a kind, all of them together; only how it compares with
/// other kinds has a meaning.
pub(crate) fn stray(graph: &SceneGraph, kin: &Kin, id: NodeId, kind: &PlaceKind, home: bool) -> f64 {
    let classes = graph.classes();
    let thing = graph.node(id).and_then(|n| classes.get(n.class()));
    let at = (!kind.floor).then(|| classes.get(&kind.at)).flatten();
    let kept = thing.map_or(0.0, |thing| kin.part(classes, thing, kind.relation, at));
    let fits = fits(size(graph, id), kind);
    (ANY + kept) * volume(kind).powf(GROWTH) * if fits { 1.0 } else { MISFIT } * if home { 1.0 } else { FOREIGN }
}

/// The size of a thing: its own, or what is usual for its class; depth, width, height, metres.
pub(crate) fn size(graph: &SceneGraph, id: NodeId) -> Option<[f64; 3]> {
    let node = graph.node(id)?;
    let usual = || graph.classes().get(node.class())?.typical_size();
    let size = node.spec().bounds.map(|b| b.size()).or_else(usual)?;
    Some([size.x, size.y, size.z].map(f64::from))
}

/// Whether a thing goes into a container in some turn, or onto a surface.
fn fits(thing: Option<[f64; 3]>, kind: &PlaceKind) -> bool {
    let (Some(mut thing), Some(mut space)) = (thing, kind.size) else { return true };
    if kind.floor {
        return true;
    }
    if kind.relation == Relation::On {
        // It stands on its smallest side at worst.
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
