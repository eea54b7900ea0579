//! Shapes for things of which only a box is known.

use vc_graph::{Bounds, Draft, Pose, SceneBuilder};

#[test]
fn a_case_of_any_height_has_a_limited_number_of_shelves() {
    let shelves = |height: f32| {
        let mut scene = SceneBuilder::new("hall");
        let case = Draft::new("bookshelf").bounds(Bounds::standing([0.4, 1.0, height].into())).at(Pose::identity());
        let case = scene.add(case).unwrap();
        vc_geometry::shapes(&scene.build())[&case].surfaces.len()
    };
    assert!((4..7).contains(&shelves(2.0)), "{}", shelves(2.0));
    assert!((10..100).contains(&shelves(1e6)), "{}", shelves(1e6));
}

/// The floors of two rooms share their boxes whatever their classes are called.
#[test]
fn floors_of_two_classes_are_rivals() {
    let mut scene = SceneBuilder::new("two rooms");
    let [hall, closet] = ["hallway", "storage_room"].map(|room| scene.add(Draft::new(room)).unwrap());
    let slab = |class: &str, side: f32| Draft {
        category: Some("Floors".into()),
        ..Draft::new(class).bounds(Bounds::standing([side, side, 0.1].into()))
    };
    let outer = scene.add_in(hall, slab("parquet", 4.0).at(Pose::identity())).unwrap();
    scene.add_in(closet, slab("lino", 1.0).at(Pose::translation(1.5, 1.5, 0.0))).unwrap();
    let asset = &vc_geometry::shapes(&scene.build())[&outer];
    let area = |(low, high): (nalgebra::Point3<f32>, nalgebra::Point3<f32>)| (high - low).xy().product();
    let all: f32 = asset.parts.iter().map(|part| area(part.extent())).sum();
    assert!((all - 15.0).abs() < 1e-3, "{all} square metres");
}
