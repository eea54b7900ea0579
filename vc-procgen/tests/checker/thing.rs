//! The objects of a scene as solids in the world.

use std::collections::HashMap;
use std::rc::Rc;

use nalgebra::Isometry3;
use vc_graph::asset::{Hold, Joint};
use vc_graph::{AssetId, Node, NodeId, NodeKind, Property, Relation, SceneGraph};

use super::shape::{Form, P, V};

/// The depth by which solids may overlap, metres.
pub(crate) const TOUCH: f64 = 0.003;

/// One part of an object, in the world.
#[derive(Clone)]
pub(crate) struct Piece {
    pub(crate) name: Rc<str>,
    form: Rc<Form>,
    back: Isometry3<f64>,
    pub(crate) points: Rc<Vec<P>>,
    pub(crate) low: P,
    pub(crate) high: P,
    pub(crate) joint: Option<Joint>,
}

/// A node that is not a room.
pub(crate) struct Thing {
    pub(crate) id: NodeId,
    pub(crate) label: String,
    pub(crate) class: String,
    pub(crate) room: Option<NodeId>,
    pub(crate) pose: Isometry3<f64>,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) low: P,
    pub(crate) high: P,
    /// The objects it rests on or is in.
    pub(crate) carriers: Vec<NodeId>,
    /// The positions of its hooks.
    pub(crate) hooks: Vec<P>,
    pub(crate) used: bool,
    pub(crate) sits: bool,
}

impl Piece {
    fn new(name: Rc<str>, form: Rc<Form>, pose: &Isometry3<f64>, joint: Option<Joint>) -> Self {
        let points: Vec<P> = form.points.iter().map(|p| pose * p).collect();
        let (low, high) = hull(points.iter().map(|p| (*p, *p)));
        Self { name, form, back: pose.inverse(), points: Rc::new(points), low, high, joint }
    }

    /// The piece after a motion in the world.
    pub(crate) fn moved(&self, by: &Isometry3<f64>) -> Self {
        let name = self.name.clone();
        Self::new(name, self.form.clone(), &(by * self.back.inverse()), self.joint)
    }

    /// The depth of a world point inside it.
    pub(crate) fn depth(&self, p: &P) -> f64 {
        self.form.depth(&(self.back * p))
    }

    pub(crate) fn triangles(&self) -> impl Iterator<Item = [P; 3]> + '_ {
        self.form.triangles.iter().map(|t| t.map(|v| self.points[v as usize]))
    }

    /// The depth by which the surface of one is inside the other, where that is more than the
    /// tolerance.
    pub(crate) fn penetration(&self, other: &Self) -> Option<(f64, P)> {
        let (low, high) = (self.low.sup(&other.low), self.high.inf(&other.high));
        if (high - low).min() <= TOUCH {
            return None;
        }
        let (mine, theirs) = (self.deepest_of(other, (low, high)), other.deepest_of(self, (low, high)));
        let deepest = if mine.0 >= theirs.0 { mine } else { theirs };
        (deepest.0 > TOUCH).then_some(deepest)
    }

    /// The deepest point of another piece's surface in this one, sampled at distances of some share
    /// of the space that both may have in common.
    fn deepest_of(&self, other: &Self, space: (P, P)) -> (f64, P) {
        let pitch = ((space.1 - space.0).max() / 10.0).clamp(0.008, 0.06);
        let mut deepest = (0.0, P::origin());
        for triangle in other.triangles() {
            self.search(triangle, &space, pitch, &mut deepest);
        }
        deepest
    }

    /// Tests corners, midpoints of edges and the centroid, and those of its quarters.
    fn search(&self, t: [P; 3], space: &(P, P), pitch: f64, deepest: &mut (f64, P)) {
        let (low, high) = (t[0].inf(&t[1]).inf(&t[2]), t[0].sup(&t[1]).sup(&t[2]));
        if (0..3).any(|k| low[k] > space.1[k] || high[k] < space.0[k]) {
            return;
        }
        let middle = |a: usize, b: usize| nalgebra::center(&t[a], &t[b]);
        let (ab, bc, ca) = (middle(0, 1), middle(1, 2), middle(2, 0));
        let centroid = P::from((t[0].coords + t[1].coords + t[2].coords) / 3.0);
        for p in [t[0], t[1], t[2], ab, bc, ca, centroid] {
            if (0..3).all(|k| p[k] >= space.0[k] && p[k] <= space.1[k]) {
                let depth = self.depth(&p);
                if depth > deepest.0 {
                    *deepest = (depth, p);
                }
            }
        }
        let longest = (t[1] - t[0]).norm().max((t[2] - t[1]).norm()).max((t[0] - t[2]).norm());
        if longest > pitch {
            let quarters = [[t[0], ab, ca], [ab, t[1], bc], [ca, bc, t[2]], [ab, bc, ca]];
            quarters.into_iter().for_each(|q| self.search(q, space, pitch, deepest));
        }
    }
}

/// The bounding box of boxes.
pub(crate) fn hull(boxes: impl Iterator<Item = (P, P)>) -> (P, P) {
    let none = (P::from(V::repeat(f64::INFINITY)), P::from(V::repeat(f64::NEG_INFINITY)));
    boxes.fold(none, |a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
}

/// All objects of a scene that have a shape.
pub(crate) fn things(scene: &SceneGraph) -> Vec<Thing> {
    let mut forms: HashMap<AssetId, Vec<Rc<Form>>> = HashMap::new();
    let nodes = scene.nodes().filter(|n| n.kind() == NodeKind::Object);
    nodes.filter_map(|n| thing(scene, n, &mut forms)).collect()
}

fn thing(scene: &SceneGraph, node: &Node, forms: &mut HashMap<AssetId, Vec<Rc<Form>>>) -> Option<Thing> {
    let (id, pose) = (node.spec().asset?, node.pose()?.cast::<f64>());
    let asset = scene.assets().get(id)?;
    let made = || asset.parts.iter().map(|p| Rc::new(Form::new(&p.shape))).collect();
    let forms = forms.entry(id).or_insert_with(made);
    let parts = asset.parts.iter().zip(forms);
    let piece = |(p, f): (&vc_graph::asset::Part, &mut Rc<Form>)| {
        Piece::new((&*p.name).into(), f.clone(), &(pose * p.pose.cast()), p.joint)
    };
    let pieces: Vec<Piece> = parts.map(piece).collect();
    let (low, high) = hull(pieces.iter().map(|p| (p.low, p.high)));
    let hooks = asset.surfaces.iter().filter(|s| s.hold == Hold::Hook).map(|s| pose * s.centre.cast());
    let related = |r| scene.related(node.id(), r);
    Some(Thing {
        id: node.id(),
        label: node.label().to_string(),
        class: node.class().to_string(),
        room: related(Relation::InRoom).next(),
        pose,
        low,
        high,
        carriers: related(Relation::On).chain(related(Relation::Inside)).collect(),
        hooks: hooks.collect(),
        used: USES.iter().any(|&way| node.affords(way)),
        sits: node.affords(Property::Sittable) || node.affords(Property::Movable),
        pieces,
    })
}

/// The affordances that people use.
const USES: [Property; 7] = [
    Property::Graspable,
    Property::Openable,
    Property::Switchable,
    Property::Sittable,
    Property::Lieable,
    Property::Container,
    Property::Surface,
];

impl Thing {
    pub(crate) fn is_building(&self) -> bool {
        const BUILDING: [&str; 7] = ["wall", "floor", "ceiling", "door", "main_door", "balcony_door", "window"];
        BUILDING.contains(&self.class.as_str()) || self.class == "railing"
    }

    pub(crate) fn is_door(&self) -> bool {
        matches!(self.class.as_str(), "door" | "main_door" | "balcony_door")
    }
}
