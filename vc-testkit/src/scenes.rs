//! Random small scenes, sound by construction.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use vc_graph::class::SlotKind;
use vc_graph::{
    Bounds, Draft, Edge, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneBuilder, SceneGraph, State, Word,
};

/// One node to be: which class, which place, which state, flags, and its pose.
pub type Step = (usize, usize, usize, u8, [i16; 7]);

/// The classes of random scenes.
pub const CLASSES: &[&str] = &[
    "kitchen",
    "living_room",
    "bedroom",
    "character",
    "kitchen_table",
    "fridge",
    "sofa",
    "single_bed",
    "bookshelf",
    "stove",
    "sink",
    "car",
    "chair",
    "cup",
    "plate",
    "apple",
    "tray",
    "box",
    "book",
    "shirt",
    "pot",
    "knife",
    "water",
    "milk",
    "laptop",
    "gizmo",
];

/// At most so many random nodes.
pub fn steps(most: usize) -> impl Strategy<Value = Vec<Step>> {
    let pose = prop::array::uniform7(-2000_i16..2000);
    prop::collection::vec((0..CLASSES.len(), any::<usize>(), any::<usize>(), any::<u8>(), pose), 0..most)
}

/// A scene of these steps; with poses for all nodes or for none.
pub fn scene(steps: &[Step], posed: bool) -> SceneGraph {
    let mut scene = SceneBuilder::new("random");
    let origin = [0; 7];
    for (class, step) in [(0, (0, 0, 0, 0, origin)), (1, (0, 0, 0, 0, origin)), (3, (0, 0, 0, 0, origin))] {
        add(&mut scene, (class, step.1, step.2, step.3, step.4), posed);
    }
    steps.iter().for_each(|step| add(&mut scene, *step, posed));
    scene.build()
}

fn add(scene: &mut SceneBuilder, step: Step, posed: bool) {
    let (class, place, state, flags, numbers) = step;
    let draft = draft(CLASSES[class], state, flags, numbers, posed);
    let id = scene.add(draft).unwrap();
    let kind = scene.graph().node(id).unwrap().kind();
    if kind != NodeKind::Room {
        let rooms = scene.graph().rooms();
        let room = rooms[place % rooms.len()];
        let mut edit = scene.edit();
        edit.move_to_room(id, room).unwrap();
        edit.commit();
        settle(scene, id, kind, place / 8, flags);
    }
    relate(scene, id, place);
}

fn draft(class: &str, state: usize, flags: u8, numbers: [i16; 7], posed: bool) -> Draft {
    let mut draft = Draft::new(class);
    if flags & 1 != 0 {
        draft = draft.named(format!("SM_{class}_{:02}", state % 7));
    }
    let state = State::ALL[state % State::ALL.len()];
    if flags & 2 != 0 && ![State::Sitting, State::Lying, State::Asleep].contains(&state) {
        draft = draft.state(state);
    }
    if flags & 4 != 0 {
        draft.contents = Some("juice".into());
    }
    if posed {
        let size = Vector3::new(numbers[0], numbers[1], numbers[2]).map(|v| 0.1 + f32::from(v.abs()) / 997.0);
        draft.pose = Some(pose(numbers, flags & 8 != 0));
        let around = if flags & 64 != 0 { Bounds::centred(size) } else { Bounds::standing(size) };
        draft.bounds = (flags & 16 != 0).then_some(around);
        draft.scale = (flags & 32 != 0).then_some(size);
    }
    draft
}

/// A pose within 20 m, turned somehow.
pub fn pose([x, y, z, i, j, k, w]: [i16; 7], turned: bool) -> Pose {
    let [i, j, k, w] = [i, j, k, w].map(f32::from);
    let turn = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 1e-3).filter(|_| turned);
    let at = Vector3::new(x, y, z).map(|v| f32::from(v) / 99.0);
    Isometry3::from_parts(Translation3::from(at), turn.unwrap_or_else(UnitQuaternion::identity))
}

/// Puts a node on, in or with something that is there already.
fn settle(scene: &mut SceneBuilder, id: NodeId, kind: NodeKind, choice: usize, flags: u8) {
    let places = places_for(scene.graph(), id, kind);
    let Some(place) = places.get(choice % (places.len() + 1)) else { return };
    let mut edit = scene.edit();
    match place.relation {
        Relation::HoldsRight => edit.hold(place.at, id).unwrap(),
        _ => edit.place(id, *place).unwrap(),
    }
    match place.relation {
        Relation::SittingOn => edit.enter_state(id, State::Sitting).unwrap(),
        Relation::LyingOn => edit.enter_state(id, State::Lying).unwrap(),
        Relation::HoldsRight if flags & 64 != 0 => {
            let from = edit.graph().rooms()[0];
            edit.relate(Edge::new(id, Relation::TakenOff, from)).unwrap();
        }
        _ => {}
    }
    edit.commit();
}

/// The places that a node can have in a sound scene.
pub fn places_for(graph: &SceneGraph, id: NodeId, kind: NodeKind) -> Vec<Place> {
    let free = |n: &Node, slot, relation| graph.relating(relation, n.id()).count() < n.capacity(slot) as usize;
    let mut found = Vec::new();
    for node in graph.nodes().filter(|n| n.id() != id && n.kind() != NodeKind::Room && !graph.rests_at(n.id(), id)) {
        let mut offer = |yes: bool, relation| found.extend(yes.then_some(Place { relation, at: node.id() }));
        if kind == NodeKind::Agent {
            offer(
                node.affords(Property::Sittable) && free(node, SlotKind::Seat, Relation::SittingOn),
                Relation::SittingOn,
            );
            offer(node.affords(Property::Lieable) && free(node, SlotKind::Lie, Relation::LyingOn), Relation::LyingOn);
        } else {
            offer(node.affords(Property::Surface), Relation::On);
            offer(node.affords(Property::Container), Relation::Inside);
            offer(node.kind() == NodeKind::Agent && graph.free_hand(node.id()).is_some(), Relation::HoldsRight);
            let clothes = graph.node(id).is_some_and(|n| n.affords(Property::Wearable));
            offer(node.kind() == NodeKind::Agent && clothes, Relation::WornBy);
        }
    }
    found
}

const LOOSE: [Relation; 6] =
    [Relation::Near, Relation::Touching, Relation::Facing, Relation::Under, Relation::NearLeft, Relation::PouredInto];

fn relate(scene: &mut SceneBuilder, id: NodeId, choice: usize) {
    let ids: Vec<NodeId> = scene.graph().nodes().map(Node::id).collect();
    let to = ids[choice / 64 % ids.len()];
    if choice.is_multiple_of(3) && to != id {
        let mut edit = scene.edit();
        edit.relate(Edge::new(id, LOOSE[choice / 3 % LOOSE.len()], to)).unwrap();
        edit.commit();
    }
}
