//! Files for other programs.

use std::path::{Path, PathBuf};

use virtualcity::gltf::{LightPlace, Stage, StageCamera, StageLight, staged_scene};
use virtualcity::graph::{SceneGraph, State};
use virtualcity::render::{Camera, Frame, Lighting, ReferencePicture, Snapshot, Source, format};

use crate::support::{Complaint, say};

/// Writes depth and flow, boxes and masks, and the scene, in files with a common prefix.
pub(crate) fn all(
    name: &Path,
    (scene, snapshot): (&SceneGraph, &Snapshot),
    camera: &Camera,
    lighting: &Lighting,
    frame: &Frame,
) -> Result<(), Complaint> {
    let flow = |i: usize| frame.flow_forward.iter().map(|f| f[i]).collect::<Vec<f32>>();
    let (u, v) = (flow(0), flow(1));
    let channels = [("Z", frame.depth.as_slice()), ("forward.u", &u), ("forward.v", &v)];
    write(name, "exr", &format::exr(frame.width, frame.height, &channels).map_err(Complaint::new)?)?;
    let shape = [frame.height, frame.width];
    write(name, "depth.npy", &format::npy(&frame.depth, &shape).map_err(Complaint::new)?)?;
    let flow = format::npy(frame.flow_forward.as_flattened(), &[frame.height, frame.width, 2]);
    write(name, "flow.npy", &flow.map_err(Complaint::new)?)?;
    let picture = name.with_extension("png");
    let picture = picture.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let mut coco = format::Coco::default();
    coco.add(picture.clone(), frame, snapshot).map_err(Complaint::new)?;
    let coco = coco.document().map_err(Complaint::new)?;
    write(name, "coco.json", coco.as_bytes())?;
    let stage = Stage { cameras: vec![seen(camera)], lights: lights(scene, lighting) };
    write(name, "glb", &staged_scene(&lit(scene, lighting)?, &stage).map_err(Complaint::new)?)
}

/// The scene with those lamps on that are part of the lighting.
fn lit(scene: &SceneGraph, lighting: &Lighting) -> Result<SceneGraph, Complaint> {
    let mut scene = scene.clone();
    let mut edit = scene.edit();
    for source in lighting.sources() {
        if let Source::Lamp { node, .. } = source {
            edit.enter_state(node, State::On).map_err(Complaint::new)?;
        }
    }
    edit.commit();
    Ok(scene)
}

/// Writes the radiance of a reference picture.
pub(crate) fn light(name: &Path, reference_picture: &ReferencePicture) -> Result<(), Complaint> {
    let [r, g, b] = [0, 1, 2].map(|i: usize| reference_picture.light.iter().map(|c| c[i]).collect::<Vec<f32>>());
    let channels = [("R", r.as_slice()), ("G", &g), ("B", &b)];
    write(
        name,
        "exr",
        &format::exr(reference_picture.width, reference_picture.height, &channels).map_err(Complaint::new)?,
    )
}

fn seen(camera: &Camera) -> StageCamera {
    use virtualcity::graph::portable::Portable;
    StageCamera {
        name: "camera".into(),
        pose: camera.pose,
        vertical_fov: 2.0 * (0.5 * camera.height as f32).angle_to(camera.focal.1),
        aspect: camera.width as f32 / camera.height as f32,
        near: camera.near,
    }
}

/// The sun and the lamps that are on.
fn lights(scene: &SceneGraph, lighting: &Lighting) -> Vec<StageLight> {
    let light = |source: &Source| match *source {
        Source::Sun { towards, colour, lux } => {
            Some(StageLight { name: "sun".into(), colour, place: LightPlace::Directional { towards, lux } })
        }
        Source::Lamp { node, at, colour, candela } => {
            let name = format!("light of {}", scene.label(node));
            Some(StageLight { name, colour, place: LightPlace::Point { point: at, candela } })
        }
        _ => None,
    };
    lighting.sources().iter().filter_map(light).collect()
}

fn write(name: &Path, ending: &str, bytes: &[u8]) -> Result<(), Complaint> {
    let path = PathBuf::from(format!("{}.{ending}", name.display()));
    virtualcity::files::write(&path, bytes)?;
    say!("wrote {}", path.display());
    Ok(())
}
