//! A building as regions: the plan of each storey, its regions and portals as text, and a picture from outside.
//!
//! `cargo run --release --example storeys -- --seed 7 --storeys 3 --out out/storeys`

#[path = "support/seed.rs"]
mod seed;
#[path = "support/mod.rs"]
mod support;

use std::path::PathBuf;
use std::sync::Arc;

use clap::Parser;
use nalgebra::{Point3, Vector3};
use support::{Complaint, say};
use virtualcity::graph::asset::{Part, Shape};
use virtualcity::graph::space::{Region, RegionFrame};
use virtualcity::graph::{Asset, Draft, Edge, Pose, SceneBuilder, SceneGraph, Seed};
use virtualcity::procgen::{Building, BuildingSpecification};
use virtualcity::render::{Camera, Daylight, Frame, Modality, Renderer, Shot, picture};
use virtualcity::shapes::material::{self, GRASS};

/// Draws a building.
#[derive(Parser)]
struct Options {
    /// The seed.
    #[arg(long, default_value_t = 7, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Storeys, 2 to 8.
    #[arg(long, default_value_t = 3)]
    storeys: usize,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/storeys")]
    out: PathBuf,
    /// The direction from which it is seen, degrees to the left of the east.
    #[arg(long, default_value_t = -65.0, allow_negative_numbers = true)]
    from: f32,
}

/// Width of the drawings, and of the picture with its height, pixels.
const PLAN: usize = 1600;
const PICTURE: (u32, u32) = (1280, 960);

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let wishes = BuildingSpecification { storeys: options.storeys, ..BuildingSpecification::default() };
    let building = Building::generate(&wishes, Seed(options.seed))?;
    virtualcity::files::create_folder(&options.out)?;
    tell(&building);
    let name = |what: &str| options.out.join(format!("building_{}_{what}.png", options.seed));
    for storey in 0..options.storeys {
        let drawing = building.floor_plan(storey)?.to_png(PLAN)?;
        virtualcity::files::write(name(&format!("storey_{storey}")), drawing)?;
    }
    let picture = outside(&whole(&building)?, options.from.to_radians(), options.storeys as f32)?;
    virtualcity::files::write(name("outside"), picture)?;
    say!("{} pictures in {}", options.storeys + 1, options.out.display());
    let violations = building.violations();
    violations.iter().for_each(|violation| say!("{violation}"));
    if violations.is_empty() { Ok(()) } else { Err(Complaint::new("the building is not sound")) }
}

/// Prints regions and portals.
fn tell(building: &Building) {
    let space = building.space();
    for (id, _) in space.regions().filter(|(_, region)| region.has_scene()) {
        let beyond = space.portals_of(id).filter_map(|portal| {
            let plan = space.portal(portal)?;
            Some(format!("{} to {}", plan.kind, space.region(plan.across(id)?.region)?.name))
        });
        say!("{}: {}", space.path(id), beyond.collect::<Vec<_>>().join(", "));
    }
}

/// All scenes as one, for pictures only: things keep their numbers, and stand on a meadow.
fn whole(building: &Building) -> Result<SceneGraph, Complaint> {
    let (mut scene, mut library) = (SceneBuilder::new("building"), material::library());
    let (mut drafts, mut edges): (Vec<(_, Draft)>, Vec<Edge>) = (Vec::new(), Vec::new());
    for (id, region) in building.space().regions().filter(|(_, region)| region.has_scene()) {
        let (part, shift) = (building.scene(id)?, there(region));
        for node in part.nodes() {
            let asset = node.spec().asset.map(|asset| library.import(part.assets(), asset)).transpose()?;
            let pose = node.pose().map(|pose| shift * pose);
            drafts.push((node.id(), Draft { pose, asset, ..Draft::from_node(node) }));
        }
        edges.extend(part.edges());
    }
    let meadow = library.add(Asset { name: "meadow".into(), parts: vec![ground()], ..Asset::default() })?;
    scene.assets(Arc::new(library));
    let room = drafts.first().map(|(id, _)| *id);
    for (id, draft) in drafts {
        scene.add_with_id(id, draft)?;
    }
    scene.link_all(&edges)?;
    if let Some(room) = room {
        scene.add_in(room, Draft { asset: Some(meadow), ..Draft::new("floor").at(Pose::identity()) })?;
    }
    Ok(scene.build())
}

/// Where a region is; one that moves, at its first stop.
fn there(region: &Region) -> Pose {
    region.frame.to(&RegionFrame::WORLD)
}

fn ground() -> Part {
    let (half, pose) = (Vector3::new(60.0, 60.0, 0.1), Pose::translation(0.0, 0.0, -0.32));
    Part { name: "meadow".into(), shape: Shape::Box { half }, material: GRASS.0, pose, joint: None }
}

/// A picture of a building of some storeys from one side, from above its roofs.
fn outside(scene: &SceneGraph, from: f32, storeys: f32) -> Result<Vec<u8>, Complaint> {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(scene)?;
    let lighting = renderer.light(&snapshot, &Daylight::clear(0.8, -1.1));
    let (distance, target) = (21.0 + 4.0 * storeys, Point3::new(0.0, 1.0, 1.2 * storeys));
    let eye = target + Vector3::new(distance * from.cos(), distance * from.sin(), 0.45 * distance);
    let camera = Camera::with_fov(PICTURE.0, PICTURE.1, 0.7).looking(eye, target);
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting).supersampled(2), &mut frame)?;
    Ok(picture::png(&picture::rgb(&frame))?)
}
