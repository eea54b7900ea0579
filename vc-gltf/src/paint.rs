//! Reading and writing materials.

use vc_graph::asset::Material;

use super::document as json;
use super::note::{MaterialNote, Physics, noted, written};
use super::{GltfError, ImportOptions};

/// Quantised vertices are read whether or not a file names the extension.
const QUANTISED: &str = "KHR_mesh_quantization";
const STRENGTH: &str = "KHR_materials_emissive_strength";
const TRANSMISSION: &str = "KHR_materials_transmission";

fn share(value: f32) -> f32 {
    value.clamp(0.0, 1.0)
}

/// Writes a material, with the index of its texture in the file.
pub(super) fn write(material: &Material, texture: Option<usize>) -> json::Material {
    let [r, g, b] = material.colour.map(share);
    let most = material.emission.iter().fold(1.0f32, |a, &b| a.max(b));
    let physics = Physics { density: material.density, friction: material.friction, restitution: material.restitution };
    let glows = material.emission != [0.0; 3];
    let shown = texture.map(|index| json::TextureOf { index: Some(index), ..Default::default() });
    json::Material {
        name: material.name.to_string(),
        pbr_metallic_roughness: json::Surface {
            base_color_factor: Some([r, g, b, 1.0]),
            base_color_texture: shown.clone(),
            metallic_factor: Some(share(material.metallic)),
            roughness_factor: Some(share(material.roughness)),
        },
        emissive_factor: glows.then(|| material.emission.map(|v| share(v / most))),
        // One image is used for both.
        emissive_texture: shown.filter(|_| glows),
        alpha_mode: None,
        extensions: json::Extensions {
            strength: (most > 1.0).then_some(json::Strength { emissive_strength: Some(most) }),
            transmission: (material.transmission > 0.0)
                .then(|| json::Transmission { transmission_factor: share(material.transmission) }),
        },
        extras: written(&MaterialNote { physics: Some(physics) }),
    }
}

/// The names of the extensions that materials use.
pub(super) fn extensions(materials: &[json::Material]) -> Vec<String> {
    let any = |used: fn(&json::Extensions) -> bool| materials.iter().any(|m| used(&m.extensions));
    let all = [(STRENGTH, any(|e| e.strength.is_some())), (TRANSMISSION, any(|e| e.transmission.is_some()))];
    all.into_iter().filter(|(_, used)| *used).map(|(name, _)| name.to_owned()).collect()
}

/// The prefixes of extensions that change a model's appearance but not its shape.
const LOOKS: [&str; 6] =
    ["KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_"];

/// Whether a model that requires an extension can be read: because the extension is supported or does not
/// affect its shape.
pub(super) fn understands(extension: &str) -> bool {
    extension == QUANTISED || LOOKS.iter().any(|start| extension.starts_with(start))
}

/// Reads a material, with glTF's defaults and this texture; physical properties come from the options
/// where the file has none.
pub(super) fn read(
    material: &json::Material,
    index: usize,
    texture: Option<u32>,
    options: &ImportOptions,
) -> Result<Material, GltfError> {
    let note: MaterialNote = noted(material.extras.as_ref(), || format!("material {index}"))?;
    let physics = note.physics;
    let surface = &material.pbr_metallic_roughness;
    let [r, g, b, alpha] = surface.base_color_factor.unwrap_or([1.0; 4]).map(share);
    let strength = material.extensions.strength.as_ref().and_then(|s| s.emissive_strength).unwrap_or(1.0);
    let blended = if material.alpha_mode.as_deref() == Some("BLEND") { 1.0 - alpha } else { 0.0 };
    let transmission = material.extensions.transmission.as_ref().map(|t| share(t.transmission_factor));
    Ok(Material {
        name: if material.name.is_empty() { format!("material_{index}") } else { material.name.clone() }.into(),
        colour: [r, g, b],
        density: physics.as_ref().map_or(options.density, |p| p.density),
        friction: physics.as_ref().map_or(options.friction, |p| p.friction),
        restitution: physics.map_or(options.restitution, |p| p.restitution),
        roughness: share(surface.roughness_factor.unwrap_or(1.0)),
        metallic: share(surface.metallic_factor.unwrap_or(1.0)),
        transmission: transmission.unwrap_or(blended),
        emission: material.emissive_factor.unwrap_or([0.0; 3]).map(|v| (share(v) * strength).clamp(0.0, 1e9)),
        texture,
    })
}
