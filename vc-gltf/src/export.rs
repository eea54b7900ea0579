//! Assets and scenes as binary glTF.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use vc_graph::asset::{Joint, Surface};
use vc_graph::{Asset, AssetId, AssetLibrary, Node, NodeId, Pose, SceneGraph};

use super::GltfError;
use super::document as json;
use super::note::{JointNote, NodeNote, SurfaceNote, written};
use super::stage::Stage;
use super::write::{Link, Writer};

/// The greatest distance between curves and the triangles written for them, metres.
pub const TOLERANCE: f32 = 0.001;

/// The rotation from Z up, X forward to Y up, Z forward: a third of a turn.
const UPRIGHT: [f32; 4] = [-0.5, -0.5, -0.5, 0.5];

/// An asset as a binary glTF file, its joints at zero. Moving links and surfaces are nodes of their own.
///
/// ```
/// # use vc_graph::asset::{Material, Part, Shape};
/// # use vc_graph::{Asset, AssetLibrary, Pose};
/// # let mut library = AssetLibrary::default();
/// # let material = library.add_material(Material::new("red", [0.56, 0.03, 0.03]))?;
/// # let shape = Shape::Sphere { radius: 0.11 };
/// # let part = Part { name: "ball".into(), shape, material, pose: Pose::identity(), joint: None };
/// # let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
/// let file = vc_gltf::asset(&ball, &library)?;
/// assert!(file.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GltfError::NoSuchMaterial`], [`GltfError::TooLarge`].
pub fn asset(asset: &Asset, library: &AssetLibrary) -> Result<Vec<u8>, GltfError> {
    written_asset(asset, library, None)
}

/// The same, with an annotation of its class, which [`read`](super::read) understands.
///
/// ```
/// # use vc_graph::asset::{Material, Part, Shape};
/// # use vc_graph::{Asset, AssetLibrary, Pose};
/// # let mut library = AssetLibrary::default();
/// # let material = library.add_material(Material::new("red", [0.56, 0.03, 0.03]))?;
/// # let shape = Shape::Sphere { radius: 0.11 };
/// # let part = Part { name: "ball".into(), shape, material, pose: Pose::identity(), joint: None };
/// # let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
/// let file = vc_gltf::asset_of_class("football", &ball, &library)?;
/// let model = vc_gltf::read(&file, &vc_gltf::ImportOptions::default())?;
/// assert_eq!(model.class.as_deref(), Some("football"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GltfError::NoSuchMaterial`], [`GltfError::TooLarge`].
pub fn asset_of_class(class: &str, asset: &Asset, library: &AssetLibrary) -> Result<Vec<u8>, GltfError> {
    written_asset(asset, library, Some(class.to_owned()))
}

fn written_asset(asset: &Asset, library: &AssetLibrary, class: Option<String>) -> Result<Vec<u8>, GltfError> {
    let mut writer = Writer::new(library, TOLERANCE);
    let mut links = writer.links(asset)?;
    let mut at: Vec<Vec<usize>> = Vec::new();
    for surface in &asset.surfaces {
        let link = links.iter().position(|l| l.joint == surface.joint).unwrap_or_else(|| {
            links.push(Link { joint: surface.joint, name: surface.name.to_string(), mesh: None });
            links.len() - 1
        });
        at.resize(links.len().max(at.len()), Vec::new());
        at[link].push(writer.node(surface_node(surface)));
    }
    at.resize(links.len(), Vec::new());
    let mut children: Vec<usize> = Vec::new();
    for (link, surfaces) in links.iter().zip(at) {
        match link.joint {
            None => children.extend(surfaces),
            Some(joint) => children.push(writer.node(link_node(link, &joint, surfaces))),
        }
    }
    let root = json::Node {
        name: asset.name.to_string(),
        mesh: links.iter().find(|l| l.joint.is_none()).and_then(|l| l.mesh),
        rotation: Some(UPRIGHT),
        children,
        extras: written(&NodeNote { class, ..NodeNote::default() }),
        ..json::Node::default()
    };
    let root = writer.node(root);
    writer.finish(&asset.name, vec![root])
}

/// A scene as a binary glTF file: each node that has an asset and a pose becomes a glTF node, named by its
/// label. Nodes with the same asset share its meshes; if the asset has emissive materials, only nodes that are
/// all on or all off share them. Joints are at zero, whatever the nodes' states.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("kitchen"))?;
/// let file = vc_gltf::scene(&scene.build())?;
/// assert!(file.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GltfError::NoSuchAsset`], [`GltfError::NoSuchMaterial`], [`GltfError::TooLarge`].
pub fn scene(graph: &SceneGraph) -> Result<Vec<u8>, GltfError> {
    staged_scene(graph, &Stage::default())
}

/// The same with cameras and lights (`KHR_lights_punctual`). Those with non-finite values are left out.
///
/// # Errors
/// As [`scene`].
pub fn staged_scene(graph: &SceneGraph, stage: &Stage) -> Result<Vec<u8>, GltfError> {
    posed_scene(graph, stage, |_, _| None)
}

/// The same with joints in given positions: for a node and a joint, `moved` returns the motion of the joint's
/// link relative to its place in the asset, in the asset's frame, as [`Joint::motion`] does; `None` leaves it
/// in place.
///
/// # Errors
/// As [`scene`].
pub fn posed_scene(
    graph: &SceneGraph,
    stage: &Stage,
    mut moved: impl FnMut(NodeId, &Joint) -> Option<Pose>,
) -> Result<Vec<u8>, GltfError> {
    let library = graph.assets();
    let mut writer = Writer::new(library, TOLERANCE);
    let mut shared: BTreeMap<(AssetId, bool), Vec<Link>> = BTreeMap::new();
    let mut children = Vec::new();
    for node in graph.nodes() {
        let Some(id) = node.spec().asset else { continue };
        let asset = library.get(id).ok_or(GltfError::NoSuchAsset(id))?;
        // An asset with emissive materials has other materials when it is on than when it is off.
        let key = (id, graph.is_lit(node.id()) && writer.glows(asset));
        if let std::collections::btree_map::Entry::Vacant(vacant) = shared.entry(key) {
            writer.lit = key.1;
            vacant.insert(writer.links(asset)?);
        }
        children.extend(placed(&mut writer, node, &shared[&key], &mut moved));
    }
    children.extend(super::stage::write(&mut writer, stage));
    let root = json::Node { name: graph.name().to_owned(), rotation: Some(UPRIGHT), children, ..json::Node::default() };
    let root = writer.node(root);
    writer.finish(graph.name(), vec![root])
}

fn placed(
    writer: &mut Writer<'_>,
    node: &Node,
    links: &[Link],
    moved: &mut dyn FnMut(NodeId, &Joint) -> Option<Pose>,
) -> Option<usize> {
    let pose = node.pose()?;
    let mut children = Vec::new();
    for link in links {
        let Some(joint) = link.joint else { continue };
        let mut own = link_node(link, &joint, Vec::new());
        if let Some(moved) = moved(node.id(), &joint) {
            own.translation = Some((moved * joint.anchor).into());
            own.rotation = Some(turned(&moved));
        }
        children.push(writer.node(own));
    }
    let note = NodeNote { class: Some(node.class().to_string()), ..NodeNote::default() };
    let scale = node.spec().scale;
    Some(writer.node(json::Node {
        name: node.label().to_string(),
        mesh: links.iter().find(|l| l.joint.is_none()).and_then(|l| l.mesh),
        translation: Some(pose.translation.vector.into()),
        rotation: Some(turned(pose)),
        scale: (scale != Vector3::repeat(1.0)).then(|| scale.into()),
        children,
        extras: written(&note),
        ..json::Node::default()
    }))
}

/// A pose's rotation as glTF requires it: of unit length, with no component above one.
pub(super) fn turned(pose: &Pose) -> [f32; 4] {
    pose.rotation.into_inner().normalize().coords.into()
}

fn link_node(link: &Link, joint: &Joint, children: Vec<usize>) -> json::Node {
    let note = JointNote { kind: joint.kind, axis: joint.axis.into(), limits: joint.limits };
    json::Node {
        name: link.name.clone(),
        mesh: link.mesh,
        translation: Some(joint.anchor.into()),
        children,
        extras: written(&NodeNote { joint: Some(note), ..NodeNote::default() }),
        ..json::Node::default()
    }
}

fn surface_node(surface: &Surface) -> json::Node {
    let anchor = surface.joint.map_or(Vector3::zeros(), |j| j.anchor.coords);
    let note = SurfaceNote { hold: surface.hold, half: Some(surface.half), clearance: surface.clearance };
    json::Node {
        name: surface.name.to_string(),
        translation: Some((surface.centre - anchor).into()),
        extras: written(&NodeNote { surface: Some(note), ..NodeNote::default() }),
        ..json::Node::default()
    }
}
