//! Scenes that are written are read back as the same.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use proptest::prelude::*;
use vc_graph::format::{native, read_scene, thesis, virtualhome};
use vc_graph::{
    Asset, AssetLibrary, ClassTable, Draft, Edge, Node, NodeId, Place, Relation, SceneBuilder, SceneGraph, State,
};
use vc_testkit::cases;
use vc_testkit::scenes::{pose, scene, steps};

fn reread_native(graph: &SceneGraph) -> SceneGraph {
    native::read(&native::write(graph), &ClassTable::builtin()).unwrap()
}

fn reread_thesis(graph: &SceneGraph) -> SceneGraph {
    thesis::read(&thesis::write(graph), &ClassTable::builtin()).unwrap()
}

fn reread_virtualhome(graph: &SceneGraph) -> SceneGraph {
    virtualhome::read(&virtualhome::write(graph), &ClassTable::builtin()).unwrap()
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn random_scenes_are_sound(steps in steps(25), posed: bool) {
        prop_assert_eq!(scene(&steps, posed).validate(), []);
    }

    #[test]
    fn native_keeps_everything(steps in steps(25), posed: bool) {
        let graph = scene(&steps, posed);
        let text = native::write(&graph);
        let again = native::read(&text, &ClassTable::builtin()).unwrap();
        prop_assert!(again == graph, "{text}");
        prop_assert_eq!(native::write(&again), text);
        prop_assert_eq!(again.digest(), graph.digest());
    }

    #[test]
    fn virtualhome_keeps_what_it_has_words_for(steps in steps(25), posed: bool) {
        let once = reread_virtualhome(&scene(&steps, posed));
        let text = virtualhome::write(&once);
        let twice = virtualhome::read(&text, &ClassTable::builtin()).unwrap();
        prop_assert!(twice == once, "{text}\n{}", virtualhome::write(&twice));
    }

    #[test]
    fn thesis_keeps_who_is_where_and_how(steps in steps(25), posed: bool) {
        let graph = scene(&steps, posed);
        let again = reread_thesis(&graph);
        prop_assert_eq!(again.len(), graph.len());
        for (old, new) in graph.nodes().zip(again.nodes()) {
            prop_assert_eq!(old.id(), new.id());
            prop_assert_eq!(old.class(), new.class());
            prop_assert_eq!(old.kind(), new.kind());
            prop_assert_eq!(old.states(), new.states());
            prop_assert_eq!(places(&graph, old.id()), places(&again, old.id()));
            prop_assert_eq!(graph.room_of(old.id()), again.room_of(old.id()));
            let kept = |n: &Node| (n.spec().category.clone(), n.spec().properties, n.contents().cloned(), n.pose().is_some());
            prop_assert_eq!(kept(old), kept(new));
            prop_assert_eq!(old.spec().name.as_ref().unwrap_or(&old.spec().spelling), new.spec().name.as_ref().unwrap());
            prop_assert!(is_same_box(old, new), "{:?} {:?}", old.spec(), new.spec());
            let Some((was, is)) = old.pose().zip(new.pose()) else { continue };
            prop_assert!((was.translation.vector - is.translation.vector).norm() < 1e-4, "{} {}", was, is);
            prop_assert!(was.rotation.angle_to(&is.rotation) < 1e-3, "{was} {is}");
        }
    }

    #[test]
    fn the_format_is_told_from_the_text(steps in steps(10)) {
        let (graph, classes) = (scene(&steps, true), ClassTable::builtin());
        prop_assert_eq!(read_scene(&native::write(&graph), &classes).unwrap(), reread_native(&graph));
        prop_assert_eq!(read_scene(&thesis::write(&graph), &classes).unwrap(), reread_thesis(&graph));
        prop_assert_eq!(read_scene(&virtualhome::write(&graph), &classes).unwrap(), reread_virtualhome(&graph));
    }

    #[test]
    fn digests_are_equal_when_scenes_are(one in steps(6), two in steps(6), posed: bool) {
        let (a, b) = (scene(&one, posed), scene(&two, posed));
        prop_assert_eq!(a == b, a.digest() == b.digest());
        prop_assert_eq!(a.digest(), scene(&one, posed).digest());
    }

    #[test]
    fn poses_survive_the_thesis_at_any_turn(numbers in prop::array::uniform7(-2000_i16..2000)) {
        prop_assert!(worst_turn(numbers) < 1e-3);
    }
}

fn is_same_box(one: &Node, other: &Node) -> bool {
    match (one.spec().bounds, other.spec().bounds) {
        (Some(a), Some(b)) => {
            (a.offset - b.offset).norm() < 1e-3 && (a.half - b.half).norm() < 1e-3 && a.frame == b.frame
        }
        (a, b) => a == b,
    }
}

fn places(graph: &SceneGraph, id: NodeId) -> BTreeSet<Place> {
    graph.places(id).collect()
}

fn worst_turn(numbers: [i16; 7]) -> f32 {
    let mut scene = SceneBuilder::new("turned");
    let turned = pose(numbers, true);
    scene.add(Draft::new("cup").at(turned)).unwrap();
    let again = reread_thesis(&scene.build());
    again.node(NodeId(1)).unwrap().pose().unwrap().rotation.angle_to(&turned.rotation)
}

#[test]
fn straight_up_and_down_survive_the_thesis() {
    for (j, w) in [(1, 1), (-1, 1), (1000, 1001), (1, 0), (0, 1)] {
        for (i, k) in [(0, 0), (1, -1), (1, 1)] {
            assert!(worst_turn([0, 0, 0, i, j, k, w]) < 1e-3, "{i} {j} {k} {w}");
        }
    }
}

/// A kitchen with a mug, changed in one way.
fn mug(change: impl FnOnce(Draft) -> Draft) -> SceneGraph {
    let mut scene = SceneBuilder::new("one");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, change(Draft::new("mug"))).unwrap();
    scene.build()
}

#[test]
fn digest_tells_every_difference() {
    use vc_graph::class::{Slot, SlotKind};
    use vc_graph::{Bounds, BoundsFrame, Pose};
    let size = nalgebra::Vector3::new(0.1, 0.2, 0.3);
    let turned = Bounds { frame: BoundsFrame::Object, ..Bounds::centred(size) };
    let all = [
        ("plain", mug(|d| d)),
        ("name", mug(|d| d.named("SM_Mug"))),
        ("state", mug(|d| d.state(State::Dirty))),
        ("pose", mug(|d| d.at(Pose::translation(1.0, 0.0, 0.0)))),
        ("bounds", mug(|d| d.bounds(Bounds::centred(size)))),
        ("frame", mug(|d| d.bounds(turned))),
        ("category", mug(|d| Draft { category: Some("Props".into()), ..d })),
        ("contents", mug(|d| Draft { contents: Some("water".into()), ..d })),
        ("properties", mug(|d| Draft { properties: Some(vc_graph::PropertySet::EMPTY), ..d })),
        ("scale", mug(|d| Draft { scale: Some(size), ..d })),
        ("slots", mug(|d| Draft { slots: Some(vec![Slot { kind: SlotKind::Hook, number: 2 }]), ..d })),
        ("asset", mug(|d| Draft { asset: Some(vc_graph::AssetId(3)), ..d })),
    ];
    let mut same = Vec::new();
    for (i, (what, one)) in all.iter().enumerate() {
        for (other_what, other) in &all[..i] {
            assert_ne!(one, other);
            same.extend((one.digest() == other.digest()).then_some((what, other_what)));
        }
    }
    assert_eq!(same, []);
}

#[test]
fn native_keeps_assets_and_materials() {
    let asset: Asset = serde_asset();
    let mut library = AssetLibrary::default();
    library.add_material(material()).unwrap();
    library.add(asset).unwrap();
    let mut scene = SceneBuilder::new("with shapes");
    scene.assets(std::sync::Arc::new(library.clone()));
    scene.add(Draft { asset: Some(vc_graph::AssetId(0)), ..Draft::new("mug") }).unwrap();
    let graph = scene.build();
    let again = reread_native(&graph);
    assert_eq!(**again.assets(), library);
    assert_eq!(native::write(&again), native::write(&graph));
}

fn material() -> vc_graph::asset::Material {
    vc_graph::asset::Material {
        density: 700.0,
        roughness: 0.6,
        ..vc_graph::asset::Material::new("oak", [0.4, 0.3, 0.1])
    }
}

fn serde_asset() -> Asset {
    use vc_graph::asset::{Joint, JointKind, Part, Shape};
    let joint = Joint {
        kind: JointKind::Hinge,
        anchor: nalgebra::Point3::new(0.1, 0.0, 0.0),
        axis: nalgebra::Vector3::z(),
        limits: (0.0, 1.5),
    };
    let shape = Shape::Lathe { profile: vec![(0.03, 0.0), (0.04, 0.1)] };
    let part = Part { name: "lid".into(), shape, material: 0, pose: vc_graph::Pose::identity(), joint: Some(joint) };
    Asset { name: "mug_1".into(), parts: vec![part], ..Asset::default() }
}

#[test]
fn a_scene_without_poses_survives_native_and_virtualhome() {
    let mut scene = SceneBuilder::new("VirtualHome");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let chair = scene.add_in(kitchen, Draft::new("chair")).unwrap();
    let shirt = scene.add_in(kitchen, Draft::new("shirt")).unwrap();
    let mut edit = scene.edit();
    edit.place(me, Place { relation: Relation::SittingOn, at: chair }).unwrap();
    edit.enter_state(me, State::Sitting).unwrap();
    edit.place(shirt, Place { relation: Relation::WornBy, at: me }).unwrap();
    edit.relate(Edge::new(me, Relation::Facing, kitchen)).unwrap();
    edit.commit();
    let graph = scene.build();
    assert_eq!(reread_native(&graph), graph);
    let again = reread_virtualhome(&graph);
    assert_eq!(again.edges().collect::<Vec<_>>(), graph.edges().collect::<Vec<_>>());
}
