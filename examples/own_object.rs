//! An object class of your own: a row of the class table and a function that builds its parts.
//!
//! `cargo run --release --example own_object -- out/own_object.png` puts a samovar on a table and draws both.

#[path = "support/output.rs"]
mod output;
mod support;

use std::path::Path;

use support::{Complaint, say};
use virtualcity::graph::{Bounds, ClassTable, Draft, Pose, SceneBuilder, Seed};
use virtualcity::nalgebra::Point3;
use virtualcity::procgen::dress;
use virtualcity::render::{Camera, Daylight, Frame, Modality, Renderer, Shot, picture};
use virtualcity::shapes::material::{BLACK_PLASTIC, BRASS, CHROME};
use virtualcity::shapes::{Build, Generator, Generators, Realm};

/// Name, kind, category, affordances, size in metres, mass in kilograms, and where it is kept.
const ROW: &str = "samovar | appliance | | appliance | graspable | 0.24-0.30 0.24-0.30 0.4-0.5 | 4 | | | \
                   kitchen/on/kitchen_counter:1";

/// Builds within `b.size`: X forward, Y to the left, Z up, the origin at the centre of the base.
fn samovar(b: &mut Build<'_>) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let metal = b.choose(&[BRASS, CHROME]);
    b.lathe("urn", [0.0; 3], &[(0.7 * r, 0.0), (0.4 * r, 0.2 * h), (0.8 * r, 0.5 * h), (0.5 * r, 0.9 * h)], metal);
    b.ball("knob", [0.0, 0.0, 0.95 * h], 0.05 * h, BLACK_PLASTIC);
    b.pipe("tap", &[[0.5 * r, 0.0, 0.35 * h], [0.9 * r, 0.0, 0.35 * h], [0.9 * r, 0.0, 0.28 * h]], 0.06 * r, metal);
}

fn main() -> Result<(), Complaint> {
    let path = output::output("own_object", "out/own_object.png")?;
    let classes = ClassTable::builtin().extended("own_object.txt", ROW).map_err(Complaint::new)?;
    let mut generators = Generators::default();
    let own = Generator::new("samovar", Realm::Indoor, 1, samovar);
    generators.register(&classes, own).map_err(Complaint::new)?;

    let mut scene = SceneBuilder::with_classes("kitchen", classes.into());
    let room = scene.add(Draft::new("kitchen")).map_err(Complaint::new)?;
    for (class, size, z) in [
        ("floor", [2.5, 2.5, 0.1], -0.1),
        ("kitchen_table", [0.8, 1.2, 0.75], 0.0),
        ("samovar", [0.28, 0.28, 0.45], 0.75),
    ] {
        let thing = Draft::new(class).bounds(Bounds::standing(size.into())).at(Pose::translation(0.0, 0.0, z));
        scene.add_in(room, thing).map_err(Complaint::new)?;
    }
    let scene = dress::dressed_by(&scene.build(), &generators, Seed(7)).map_err(Complaint::new)?;
    let samovar = scene.of_class("samovar")[0];
    say!("{}: {:?}", scene.label(samovar), scene.node(samovar).and_then(|n| n.aabb()));

    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene).map_err(Complaint::new)?;
    let lighting = renderer.light(&snapshot, &Daylight::clear(0.9, 0.6));
    let camera = Camera::with_fov(640, 480, 0.8);
    let camera = camera.around(Point3::new(0.0, 0.0, 0.7), 2.4, 0.4, 8)[1];
    let mut frame = Frame::new();
    let shot = Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting);
    renderer.render(&shot, &mut frame).map_err(Complaint::new)?;
    let image = picture::png(&picture::rgb(&frame)).map_err(Complaint::new)?;
    virtualcity::files::write(Path::new(&path), image)?;
    say!("{}", path.display());
    Ok(())
}
