//! L-shaped rooms keep their floors, however often they are read.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::sync::Arc;

use vc_graph::asset::{Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Bounds, Draft, NodeId, Pose, SceneBuilder};
use vc_relations::{Evidence, RelationRule, Relations};

/// The centre of an L-shaped floor is in the other room.
#[test]
fn a_floor_is_of_its_own_room() {
    let mut library = AssetLibrary::default();
    let stone = library
        .add_material(Material {
            density: 2000.0,
            friction: 0.6,
            restitution: 0.0,
            roughness: 0.8,
            ..Material::new("stone", [0.5; 3])
        })
        .unwrap();
    let mut scene = SceneBuilder::new("flat");
    let corner = [(0.0, 0.0), (6.0, 0.0), (6.0, 1.0), (1.0, 1.0), (1.0, 6.0), (0.0, 6.0)];
    let square = [(1.0, 1.0), (6.0, 1.0), (6.0, 6.0), (1.0, 6.0)];
    let rooms = [("kitchen", corner.to_vec()), ("bathroom", square.to_vec())].map(|(class, outline)| {
        let shape = Shape::Extrusion { outline, height: 0.1 };
        let part = Part { name: class.into(), shape, material: stone, pose: Pose::identity(), joint: None };
        let asset = library.add(Asset { name: class.into(), parts: vec![part], ..Asset::default() }).unwrap();
        let room = scene.add(Draft::new(class)).unwrap();
        let draft = Draft { asset: Some(asset), ..Draft::new("floor").at(Pose::translation(0.0, 0.0, -0.1)) };
        (room, scene.add_in(room, draft).unwrap())
    });
    let size = Bounds::standing([0.6, 0.6, 1.8].into());
    let places = [("fridge", 0.5, 4.0, 0), ("fridge", 4.0, 0.5, 0), ("washing_machine", 3.0, 3.0, 1)];
    let things: Vec<(NodeId, NodeId)> = places
        .into_iter()
        .map(|(class, x, y, room)| {
            let draft = Draft::new(class).bounds(size).at(Pose::translation(x, y, 0.0));
            (scene.add(draft).unwrap(), rooms[room].0)
        })
        .collect();
    scene.assets(Arc::new(library));
    let mut graph = scene.build();
    let all: Vec<NodeId> = graph.nodes().map(vc_graph::Node::id).collect();
    let mut relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
    for _ in 0..3 {
        relations.write(&mut graph, &all).unwrap();
        for (room, floor) in rooms {
            assert_eq!(graph.room_of(floor), Some(room));
        }
        for &(thing, room) in &things {
            assert_eq!(graph.room_of(thing), Some(room), "{thing}");
        }
        relations.rebuild(&graph).unwrap();
    }
}
