//! Views at street level, drawn by seed, by day and by night with all modalities, and a block as glTF.

use std::path::Path;

use virtualcity::files;
use virtualcity::graph::Seed;
use virtualcity::map::Point;
use virtualcity::nalgebra::{Point3, Vector2};
use virtualcity::procgen::Outdoors;
use virtualcity::procgen::city::CityPlan;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Daylight, Frame, Modalities, Renderer, Shot};

use crate::support::{Complaint, say};

/// How far a view's scene reaches, metres, and that of a block as glTF.
const REACH: f64 = 110.0;
const BLOCK: f64 = 50.0;
/// The height of the eye above the pavement, and how far ahead it looks, metres.
const EYE: f32 = 1.6;
const AHEAD: f64 = 40.0;
/// The hours by day and by night.
const HOURS: [(&str, f32); 2] = [("day", 10.0), ("night", 22.5)];

/// Where somebody stands, and where they look.
struct View {
    at: Point,
    along: Vector2<f64>,
    street: String,
}

/// A place on a pavement of the plan.
fn view(plan: &CityPlan, number: u64) -> Option<View> {
    let mut stream = Seed(number).child("view").stream();
    let street = plan.streets().get(stream.below(plan.streets().len()))?;
    let road = plan.map().road(*street.roads.get(stream.below(street.roads.len()))?)?;
    let station = f64::from(stream.between(0.2, 0.5)) * road.line.length();
    let (at, along) = (road.line.at(station), road.line.direction(station));
    let right = Vector2::new(along.y, -along.x);
    // In the half of the pavement at the houses, where nothing stands.
    let aside = street.class.kerb() + street.class.pavement() * 0.62;
    Some(View { at: at + right * aside, along, street: format!("{}, {}", street.name, street.class.word()) })
}

/// Writes some views into a folder.
pub(crate) fn write(plan: &CityPlan, folder: &Path, count: u64) -> Result<(), Complaint> {
    for number in 0..count {
        let Some(View { at, along, street }) = view(plan, number) else { continue };
        say!("view {number}: {street}");
        for (name, hour) in HOURS {
            let daylight = Daylight::at(hour);
            let scene = Outdoors::of(plan).lamps(daylight.is_dark()).scene(&at, REACH).map_err(Complaint::new)?;
            let mut renderer = Renderer::new();
            let snapshot = renderer.snapshot(&scene).map_err(Complaint::new)?;
            let lighting = renderer.light(&snapshot, &daylight);
            let to = along * AHEAD;
            let target = Point3::new(to.x as f32, to.y as f32, EYE + 1.5);
            let camera = Camera::with_fov(640, 480, 65f32.to_radians()).looking(Point3::new(0.0, 0.0, EYE), target);
            let mut frame = Frame::new();
            let shot = Shot::new(&snapshot, &camera, Modalities::SIX).lit(&lighting).after(&snapshot, &camera);
            renderer.render(&shot.supersampled(2), &mut frame).map_err(Complaint::new)?;
            let mut shown = vec![("colours", picture::rgb(&frame))];
            if hour < 12.0 {
                shown.extend(labels(&frame));
            }
            for (what, picture) in shown {
                let path = folder.join(format!("view_{number}_{name}_{what}.png"));
                files::write(path, picture::png(&picture).map_err(Complaint::new)?)?;
            }
        }
    }
    Ok(())
}

fn labels(frame: &Frame) -> [(&'static str, Picture); 4] {
    [
        ("depth", picture::depth(frame, 80.0)),
        ("nodes", picture::instances(frame)),
        ("classes", picture::classes(frame)),
        ("normals", picture::normals(frame)),
    ]
}

/// Writes what stands around the middle of the city as glTF.
pub(crate) fn block(plan: &CityPlan, folder: &Path) -> Result<(), Complaint> {
    let middle = |block: &virtualcity::procgen::city::CityBlock| block.land.middle();
    let nearest = plan.blocks().iter().map(middle).min_by(|a, b| a.coords.norm().total_cmp(&b.coords.norm()));
    let Some(at) = nearest else { return Ok(()) };
    let scene = Outdoors::of(plan).scene(&at, BLOCK).map_err(Complaint::new)?;
    Ok(files::write(folder.join("block.glb"), virtualcity::gltf::scene(&scene).map_err(Complaint::new)?)?)
}
