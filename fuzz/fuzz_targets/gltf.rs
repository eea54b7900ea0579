//! A model that parses is accepted by a library, and can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::AssetLibrary;
use vc_gltf::{self as gltf, ImportOptions};

fuzz_target!(|file: &[u8]| {
    let options = ImportOptions { hulls: 0, ..ImportOptions::default() };
    let Ok(model) = gltf::read(file, &options) else { return };
    let mut library = AssetLibrary::default();
    let Ok(id) = model.add_to(&mut library) else { return };
    let Some(asset) = library.get(id) else { return };
    let Ok(written) = gltf::asset(asset, &library) else { return };
    let _ = gltf::read(&written, &options);
});
