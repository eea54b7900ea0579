//! glTF with images: written images read back, and unreadable ones are left out and reported.

use std::sync::Arc;

use nalgebra::Point3;
use proptest::prelude::*;
use serde_json::{Value, json};
use vc_gltf::{self as gltf, ImportOptions, ImportedModel};
use vc_graph::asset::{Material, Part, Shape, Texture};
use vc_graph::{Asset, AssetLibrary, Pose};
use vc_testkit::cases;

const JPEG: &[u8] = include_bytes!("../data/four.jpg");

/// Texture coordinates of two triangles; the triangles share an edge of the mesh but not of the image.
const UVS: [[[f32; 2]; 3]; 2] = [[[0.0, 1.0], [0.5, 1.0], [0.5, 0.0]], [[0.25, 0.0], [0.75, 1.0], [1.5, -0.5]]];

fn plain() -> ImportOptions {
    ImportOptions { hulls: 0, recentre: false, ..ImportOptions::default() }
}

fn picture() -> Texture {
    let pixels = (0..35).map(|i| [7 * i, 255 - 7 * i, 3 * i]).collect();
    Texture { name: "label".into(), width: 7, height: 5, pixels }
}

/// A square with an image, and a ball of the same material.
fn sign() -> (Asset, AssetLibrary) {
    let mut library = AssetLibrary::default();
    // Another texture, so that indices are not all zero.
    library.add_texture(Arc::new(Texture { name: "other".into(), ..picture() })).unwrap();
    let texture = library.add_texture(Arc::new(picture())).unwrap();
    let material = Material {
        density: 650.0,
        friction: 0.4,
        restitution: 0.3,
        roughness: 0.75,
        texture: Some(texture),
        ..Material::new("printed", [0.5, 0.25, 1.0])
    };
    library.add_material(material).unwrap();
    let corners = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from).to_vec();
    let square = Shape::Mesh { vertices: corners, triangles: vec![[0, 1, 2], [0, 2, 3]], uvs: UVS.to_vec() };
    let part = |shape| Part { name: "part".into(), shape, material: 0, pose: Pose::identity(), joint: None };
    let parts = vec![part(square), part(Shape::Sphere { radius: 0.1 })];
    (Asset { name: "sign".into(), parts, ..Asset::default() }, library)
}

/// The same, with a material whose emission uses the image.
fn screen() -> Vec<u8> {
    let (asset, mut library) = sign();
    let glowing = Material { emission: [40.0, 20.0, 10.0], ..library.material(0).unwrap().clone() };
    let number = library.add_material(glowing).unwrap();
    let parts = asset.parts.iter().map(|part| Part { material: number, ..part.clone() }).collect();
    gltf::asset(&Asset { parts, ..asset }, &library).unwrap()
}

fn written() -> Vec<u8> {
    let (asset, library) = sign();
    gltf::asset(&asset, &library).unwrap()
}

/// The corners of the triangles that have an image, with their texture coordinates.
fn corners(asset: &Asset) -> Vec<([f32; 3], [f32; 2])> {
    let mut all = Vec::new();
    for part in &asset.parts {
        let Shape::Mesh { vertices, triangles, uvs } = &part.shape else { continue };
        for (triangle, uvs) in triangles.iter().zip(uvs) {
            all.extend(triangle.iter().zip(uvs).map(|(&v, &uv)| (vertices[v as usize].into(), uv)));
        }
    }
    all
}

fn chunk(kind: &[u8; 4], mut content: Vec<u8>) -> Vec<u8> {
    content.resize(content.len().next_multiple_of(4), b' ');
    [&(content.len() as u32).to_le_bytes()[..], kind, &content].concat()
}

/// The file with its JSON edited and its first image, the last of its binary data, replaced by
/// `picture`.
fn edited(picture: Option<&[u8]>, edit: impl FnOnce(&mut Value)) -> Vec<u8> {
    changed(&written(), picture, edit)
}

fn changed(file: &[u8], picture: Option<&[u8]>, edit: impl FnOnce(&mut Value)) -> Vec<u8> {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let mut document: Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let mut bytes = file[28 + length..].to_vec();
    if let Some(picture) = picture {
        let view = document["images"][0]["bufferView"].as_u64().unwrap() as usize;
        let view = &mut document["bufferViews"][view];
        view["byteLength"] = json!(picture.len());
        bytes.truncate(view["byteOffset"].as_u64().unwrap() as usize);
        bytes.extend(picture);
        document["buffers"][0]["byteLength"] = json!(bytes.len());
    }
    edit(&mut document);
    let json = chunk(b"JSON", serde_json::to_vec(&document).unwrap());
    [&file[..12], &json, &chunk(b"BIN\0", bytes)].concat()
}

fn read(picture: Option<&[u8]>, edit: impl FnOnce(&mut Value)) -> Result<ImportedModel, String> {
    gltf::read(&edited(picture, edit), &plain()).map_err(|e| e.to_string())
}

#[test]
fn pictures_read_back() {
    let (asset, library) = sign();
    let model = gltf::read(&written(), &plain()).unwrap();
    assert_eq!(model.textures, [library.texture(1).unwrap().clone()]);
    assert_eq!(corners(&model.asset), corners(&asset));
    // The square shares its vertices again, whatever its texture coordinates.
    let squares = model.asset.parts.iter().filter_map(|p| match &p.shape {
        Shape::Mesh { vertices, uvs, .. } if !uvs.is_empty() => Some(vertices.len()),
        _ => None,
    });
    assert_eq!(squares.collect::<Vec<_>>(), [4]);
    let mut mine = library.clone();
    let id = model.add_to(&mut mine).unwrap();
    let material = mine.get(id).unwrap().parts.iter().find_map(|p| mine.material(p.material)?.texture);
    assert_eq!(mine.texture(material.unwrap()).map(|t| &**t), Some(&picture()));
    // A part without coordinates is written without the image, otherwise no program could show it.
    let text = String::from_utf8_lossy(&written()).into_owned();
    assert_eq!(text.matches("baseColorTexture").count(), 1);
    assert_eq!(text.matches("TEXCOORD_0").count(), 1);
}

#[test]
fn pictures_that_glow_read_back() {
    let file = screen();
    let is_glowing = |model: &ImportedModel| {
        let pictured: Vec<&Material> = model.materials.iter().filter(|m| m.texture.is_some()).collect();
        assert_eq!(pictured.len(), 1);
        let close = pictured[0].emission.iter().zip([40.0, 20.0, 10.0]).all(|(a, b)| (a - b).abs() < 1e-3);
        close && *model.textures[pictured[0].texture.unwrap() as usize] == picture()
    };
    let model = gltf::read(&file, &plain()).unwrap();
    assert!(is_glowing(&model) && model.textures.len() == 1);
    let text = String::from_utf8_lossy(&file).into_owned();
    assert_eq!(text.matches("emissiveTexture").count(), 1, "what has no coordinates glows evenly");
    assert!(!String::from_utf8_lossy(&written()).contains("emissiveTexture"), "what does not glow has none");
    // Other programs write screens without a base colour.
    let alone = changed(&file, None, |d| {
        for material in d["materials"].as_array_mut().unwrap() {
            material["pbrMetallicRoughness"].as_object_mut().unwrap().remove("baseColorTexture");
        }
    });
    let again = gltf::read(&alone, &plain()).unwrap();
    assert!(is_glowing(&again) && corners(&again.asset) == corners(&model.asset));
}

#[test]
fn pictures_may_be_jpeg_or_of_other_kinds_of_png() {
    let jpeg = read(Some(JPEG), |_| {}).unwrap();
    let texture = &jpeg.textures[0];
    assert_eq!((texture.width, texture.height), (16, 16));
    for (index, wanted) in [[200, 40, 30], [30, 160, 60], [40, 60, 190], [230, 220, 60_u8]].into_iter().enumerate() {
        let found = texture.pixels[(4 + index / 2 * 8) * 16 + 4 + index % 2 * 8];
        assert!((0..3).all(|i| found[i].abs_diff(wanted[i]) < 8), "{found:?}, not {wanted:?}");
    }
    type Kind = (png::ColorType, png::BitDepth, &'static [u8], [[u8; 3]; 2]);
    let kinds: [Kind; 5] = [
        (png::ColorType::Grayscale, png::BitDepth::Eight, &[10, 200], [[10; 3], [200; 3]]),
        (png::ColorType::Grayscale, png::BitDepth::One, &[0b0100_0000], [[0; 3], [255; 3]]),
        (png::ColorType::GrayscaleAlpha, png::BitDepth::Eight, &[10, 0, 200, 9], [[10; 3], [200; 3]]),
        (png::ColorType::Rgba, png::BitDepth::Eight, &[1, 2, 3, 4, 5, 6, 7, 8], [[1, 2, 3], [5, 6, 7]]),
        (png::ColorType::Rgb, png::BitDepth::Sixteen, &[1, 9, 2, 9, 3, 9, 4, 9, 5, 9, 6, 9], [[1, 2, 3], [4, 5, 6]]),
    ];
    for (colour, depth, data, wanted) in kinds {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        encoder.write_header().unwrap().write_image_data(data).unwrap();
        assert_eq!(read(Some(&bytes), |_| {}).unwrap().textures[0].pixels, wanted, "{colour:?} {depth:?}");
    }
}

#[test]
fn coordinates_are_found_and_moved_as_the_file_says() {
    let moved = read(None, |d| {
        let material = d["materials"]
            .as_array_mut()
            .unwrap()
            .iter_mut()
            .find(|m| m["pbrMetallicRoughness"].get("baseColorTexture").is_some());
        material.unwrap()["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] =
            json!({"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2.0, -1.0]}});
        d["extensionsRequired"] = json!(["KHR_texture_transform"]);
    });
    let wanted: Vec<[f32; 2]> = UVS.as_flattened().iter().map(|[u, v]| [2.0 * u + 0.5, 0.25 - v]).collect();
    let found: Vec<[f32; 2]> = corners(&moved.unwrap().asset).into_iter().map(|c| c.1).collect();
    assert_eq!(found, wanted);
    // Missing coordinates are no reason to refuse the model.
    let set = |d: &mut Value, number: u32| {
        for material in d["materials"].as_array_mut().unwrap() {
            if let Some(texture) = material["pbrMetallicRoughness"].get_mut("baseColorTexture") {
                texture["texCoord"] = json!(number);
            }
        }
    };
    assert!(corners(&read(None, |d| set(d, 1)).unwrap().asset).is_empty());
}

#[test]
fn a_model_is_plain_where_its_picture_cannot_be_used() {
    let own = written();
    let shape = |model: &ImportedModel| model.asset.parts.iter().map(|p| p.shape.clone()).collect::<Vec<_>>();
    let whole = shape(&read(None, |_| {}).unwrap());
    let start = own.windows(4).position(|w| w == b"\x89PNG").unwrap();
    let png = &own[start..];
    let huge = {
        let mut bytes = Vec::new();
        png::Encoder::new(&mut bytes, 20_000, 2).write_header().unwrap().write_image_data(&[0; 40_000]).unwrap();
        bytes
    };
    type Case<'a> = (Option<&'a [u8]>, fn(&mut Value), &'a str);
    let cases: [Case<'_>; 10] = [
        (Some(b"RIFF....WEBPVP8 "), |_| {}, "image `label` is neither PNG nor JPEG"),
        (Some(&png[..60]), |_| {}, "image `label` cannot be decoded"),
        (Some(&JPEG[..40]), |_| {}, "image `label` cannot be decoded"),
        (Some(&huge), |_| {}, "image `label` is 20000 by 2 pixels"),
        (Some(b""), |_| {}, "image `label` is neither"),
        (None, |d| d["images"][0] = json!({"uri": "wood.png"}), "image `wood.png` is not in the file"),
        (None, |d| d["images"][0]["bufferView"] = json!(99), "buffer view 99 does not exist"),
        (None, |d| d["images"] = json!([]), "image 0 does not exist"),
        (None, |d| d["textures"] = json!([]), "texture 0 does not exist"),
        (None, |d| d["textures"][0] = json!({"extensions": {}}), "texture 0 has no image that is read"),
    ];
    for (picture, edit, expected) in cases {
        let model = read(picture, edit).unwrap();
        assert_eq!(shape(&model), whole);
        assert!(model.textures.is_empty() && model.materials.iter().all(|m| m.texture.is_none()));
        let said: Vec<String> = model.missing_images.iter().map(ToString::to_string).collect();
        assert!(said.len() == 1 && said[0].contains(expected), "{said:?} does not say `{expected}`");
    }
    let cut = read(None, |d| d["bufferViews"][1]["byteLength"] = json!(8)).err().unwrap_or_default();
    assert!(cut.contains("more elements than its buffer holds"), "{cut}");
}

proptest! {
    #![proptest_config(cases(1024))]

    #[test]
    fn no_bytes_of_pictures_cause_a_panic(
        jpeg in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        keep in any::<prop::sample::Index>(),
    ) {
        let own = written();
        let start = own.windows(4).position(|w| w == b"\x89PNG").unwrap();
        let mut bytes = if jpeg { JPEG.to_vec() } else { own[start..].to_vec() };
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let _ = read(Some(&bytes), |_| {});
        let _ = read(Some(&bytes[..keep.index(bytes.len())]), |_| {});
    }
}
