//! Cameras and other sensors of your own: one that follows, one on a wrist, a fisheye, noisy depth and a lidar.
//!
//! `cargo run --release --example sensors -- out/sensors` lets an agent fetch something, and writes what each saw, the
//! lidar's points on a plan of the home and as a file for MeshLab or CloudCompare, and the cameras as JSON.

#[path = "support/output.rs"]
mod output;
mod support;

use std::path::Path;

use support::{Complaint, say};
use virtualcity::graph::{Action, NodeId, Pose, Property, Relation, Verb};
use virtualcity::physics::Hand;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Modality};
use virtualcity::sensors::{Fisheye, Lidar, LidarScan, NoisyDepth, Reading};
use virtualcity::{Environment, Lens, Mount, Viewpoint, files};

/// Size of pictures, pixels.
const SIZE: (u32, u32) = (320, 240);

fn main() -> Result<(), Complaint> {
    let folder = output::output("sensors", "out/sensors")?;
    files::create_folder(&folder)?;
    let mut home = Environment::make("apartment/42", 1)?;
    let me = home.agents()[0];
    mount(&mut home, me)?;
    fetch(&mut home, me)?;

    for name in ["behind", "wrist", "plan"] {
        let view = Viewpoint::Camera(home.camera_named(name)?);
        let frame = home.render(view, Modality::Rgb, SIZE.0, SIZE.1)?;
        write(&folder, name, &picture::rgb(&frame))?;
    }
    for (name, reading) in home.sense_all()? {
        match &reading {
            Reading::Picture(frame) if frame.rgb.is_empty() => write(&folder, &name, &picture::depth(frame, 5.0))?,
            Reading::Picture(frame) => write(&folder, &name, &picture::rgb(frame))?,
            Reading::Scan(scan) => {
                files::write(folder.join(format!("{name}.ply")), scan.ply()?)?;
                write(&folder, &name, &plan(&home, scan)?)?;
            }
            other => say!("{name}: {other:?}"),
        }
    }
    files::write(folder.join("cameras.json"), home.cameras_json())?;
    say!("{} cameras and {} sensors; written to {}", home.cameras().len(), home.sensors().count(), folder.display());
    Ok(())
}

fn mount(home: &mut Environment, me: NodeId) -> Result<(), Complaint> {
    let room = home.graph().room_of(me).ok_or_else(|| Complaint::new("the agent is in no room"))?;
    home.add_camera("behind", Mount::Following { agent: me, behind: 1.8, above: 0.7 }, Lens::FieldOfView(1.1))?;
    home.add_camera("wrist", Mount::wrist(me, Hand::Right), Lens::FieldOfView(1.4))?;
    // A calibrated camera for 640 by 480 pixels.
    let lens = Lens::Intrinsics { size: (640, 480), focal: (525.0, 525.0), centre: (319.5, 239.5) };
    home.add_camera("plan", Mount::Above(room), lens)?;

    let hat = Mount::Head { agent: me, offset: Pose::translation(-0.14, 0.0, 0.25) };
    home.add_sensor("fisheye", Mount::head(me), Fisheye { side: 256, field: 3.3, ..Fisheye::default() })?;
    home.add_sensor("depth", Mount::head(me), NoisyDepth { width: SIZE.0, height: SIZE.1, ..NoisyDepth::default() })?;
    home.add_sensor("lidar", hat, Lidar::default())?;
    Ok(())
}

/// Takes the first thing that lies openly on something and can be reached.
fn fetch(home: &mut Environment, me: NodeId) -> Result<(), Complaint> {
    let graph = home.graph();
    let lies = |id: &NodeId| graph.related(*id, Relation::On).next().is_some() && graph.hidden_in(*id).is_none();
    let things = graph.nodes().filter(|n| n.affords(Property::Graspable)).map(|n| n.id()).filter(lies);
    for thing in things.collect::<Vec<NodeId>>() {
        let walked = home.set_action(me, Action::one(Verb::Walk, thing));
        if walked.is_ok() && home.set_action(me, Action::one(Verb::Grab, thing)).is_ok() {
            say!("{} holds {}", home.graph().label(me), home.graph().label(thing));
            return Ok(());
        }
    }
    Err(Complaint::new("there is nothing to take"))
}

/// A plan of the home with the points that a lidar measured.
fn plan(home: &Environment, scan: &LidarScan) -> Result<Picture, Complaint> {
    let (width, height) = (2 * SIZE.0, 2 * SIZE.1);
    let camera: Camera = home.camera(Viewpoint::Overhead, width, height)?;
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, width, height)?;
    let mut picture = picture::rgb(&frame);
    for seen in scan.in_home().filter_map(|(point, _)| camera.project(&point)) {
        let (x, y) = (seen.x as usize, seen.y as usize);
        if seen.x >= 0.0 && seen.y >= 0.0 && x < picture.width && y < picture.height {
            picture.pixels[y * picture.width + x] = [220, 20, 20];
        }
    }
    Ok(picture)
}

fn write(folder: &Path, name: &str, picture: &Picture) -> Result<(), Complaint> {
    Ok(files::write(folder.join(format!("{name}.png")), picture::png(picture)?)?)
}
