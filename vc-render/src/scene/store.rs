//! Uploaded assets: they are built once and kept as long as the renderer lives.

use std::collections::HashMap;
use std::sync::Arc;

use vc_graph::asset::{Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Pose, Spec};

use super::liquid::Liquid;
use super::untied::Untied;
use crate::mesh::{Finish, Link, TOLERANCES, links, single};
use crate::surface::{Picture, Role, Surface};

/// Links of all assets seen so far, and their surface materials.
#[derive(Debug, Default)]
pub(crate) struct Store {
    /// Largest screen-space error of a curved outline at which a coarser mesh may be drawn, pixels.
    pub(crate) detail: f32,
    /// Identity of the store, compared by address; snapshots made with this store carry it.
    pub(crate) name: Arc<()>,
    pub(crate) surfaces: Vec<Surface>,
    /// Surfaces by library, material, role, and whether pictures are mapped onto them.
    known_surfaces: HashMap<(usize, u32, Role, bool), u16>,
    /// Pictures by library and position in it.
    pictures: HashMap<(usize, u32), Arc<Picture>>,
    /// Links by library and asset, and whether the asset is a window cover.
    assets: HashMap<(usize, usize, bool), Vec<Arc<Link>>>,
    /// Liquids that fit into vessels, by library and asset.
    liquids: HashMap<(usize, usize), Option<Contained>>,
    water: Option<u16>,
    /// Curtains without their bands, by library and asset.
    untied: HashMap<(usize, usize), Option<Loose>>,
    /// Keeps alive the libraries and assets whose addresses are keys above.
    kept: Vec<(Arc<AssetLibrary>, Arc<Asset>)>,
    /// Links of nodes without an asset, by the half lengths and the offset of their box, and the surface of
    /// these boxes.
    boxes: HashMap<[u32; 6], Vec<Arc<Link>>>,
    stand_in: Option<u16>,
}

/// A liquid that can be in a vessel, and a point in the vessel's bottom.
pub(super) type Contained = (Arc<Link>, [f64; 3]);

/// The cloth of a tied curtain as it hangs untied, and points inside the band and inside that cloth.
pub(super) type Loose = (Arc<Link>, [[f64; 3]; 2]);

impl Store {
    /// An empty store, for meshes that are off by at most so many pixels.
    pub(crate) fn new(detail: f32) -> Self {
        Self { detail, ..Self::default() }
    }

    /// The liquid that an uploaded asset can hold, if any; built on first use.
    pub(super) fn liquid(&mut self, library: &Arc<AssetLibrary>, asset: &Arc<Asset>) -> Option<Contained> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize);
        if let Some(known) = self.liquids.get(&key) {
            return known.clone();
        }
        let made = Liquid::within(asset).map(|liquid| {
            let surface = self.water();
            let mut filled = asset.as_ref().clone();
            filled.parts.push(liquid.part);
            let finish = Finish { surface, clear: false, pictured: false };
            (Arc::new(single(&filled, asset.parts.len(), finish)), liquid.bottom)
        });
        self.liquids.insert(key, made.clone());
        made
    }

    /// The cloth of an uploaded asset without its band, if it has one; built on first use.
    pub(super) fn untied(&mut self, library: &Arc<AssetLibrary>, asset: &Arc<Asset>) -> Option<Loose> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize);
        if let Some(known) = self.untied.get(&key) {
            return known.clone();
        }
        let made = Untied::new(asset).map(|Untied { cloth, index, hidden }| {
            let finish = self.surface(key.0, library, &cloth);
            let mut hanging = asset.as_ref().clone();
            hanging.parts[index] = cloth;
            (Arc::new(single(&hanging, index, finish)), hidden)
        });
        self.untied.insert(key, made.clone());
        made
    }

    fn water(&mut self) -> u16 {
        let surfaces = &mut self.surfaces;
        *self.water.get_or_insert_with(|| {
            surfaces.push(Surface { roughness: 0.03, ..Surface::plain() });
            surfaces.len() as u16 - 1
        })
    }

    /// The links of an asset, which may be a window cover; built on first use.
    pub(crate) fn links(&mut self, library: &Arc<AssetLibrary>, asset: &Arc<Asset>, cover: bool) -> Vec<Arc<Link>> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize, cover);
        if let Some(links) = self.assets.get(&key) {
            return links.clone();
        }
        self.kept.push((library.clone(), asset.clone()));
        let made: Vec<Arc<Link>> =
            links(asset, cover, |part| self.surface(key.0, library, part)).into_iter().map(Arc::new).collect();
        self.assets.insert(key, made.clone());
        made
    }

    /// A plain box for a node without an asset; none if the node has no box.
    pub(crate) fn stand_in(&mut self, spec: &Spec) -> Option<Vec<Arc<Link>>> {
        let bounds = spec.bounds?;
        let (half, offset) = (bounds.half, bounds.offset);
        let key = [half.x, half.y, half.z, offset.x, offset.y, offset.z].map(f32::to_bits);
        if let Some(links) = self.boxes.get(&key) {
            return Some(links.clone());
        }
        let surface = *self.stand_in.get_or_insert_with(|| {
            self.surfaces.push(Surface::plain());
            self.surfaces.len() as u16 - 1
        });
        let part = Part {
            name: "box".into(),
            shape: Shape::Box { half },
            material: 0,
            pose: Pose::translation(offset.x, offset.y, offset.z),
            joint: None,
        };
        let asset = Asset { name: "box".into(), parts: vec![part], ..Asset::default() };
        let finish = Finish { surface, clear: false, pictured: false };
        let made: Vec<Arc<Link>> = links(&asset, false, |_| finish).into_iter().map(Arc::new).collect();
        self.boxes.insert(key, made.clone());
        Some(made)
    }

    fn surface(&mut self, address: usize, library: &AssetLibrary, part: &Part) -> Finish {
        let role = Role::from_part(part);
        let placed = matches!(&part.shape, Shape::Mesh { uvs, .. } if !uvs.is_empty());
        let key = (address, part.material, role, placed);
        let known = self.known_surfaces.get(&key).copied();
        let index = known.unwrap_or_else(|| {
            let material = library.material(part.material);
            let made = material.map_or_else(Surface::plain, |m: &Material| Surface::new(m, role));
            let made = match material.and_then(|m| self.picture(address, library, m.texture?)) {
                Some(picture) if placed => made.with(picture),
                Some(picture) => made.tinted(&picture),
                None => made,
            };
            let same = self.surfaces.iter().position(|s| *s == made);
            let index = same.unwrap_or_else(|| {
                self.surfaces.push(made);
                self.surfaces.len() - 1
            });
            let index = index.min(usize::from(u16::MAX)) as u16;
            self.known_surfaces.insert(key, index);
            index
        });
        let made = &self.surfaces[usize::from(index)];
        Finish { surface: index, clear: made.is_clear(), pictured: made.picture.is_some() }
    }

    fn picture(&mut self, address: usize, library: &AssetLibrary, texture: u32) -> Option<Arc<Picture>> {
        let made = || library.texture(texture).map(|t| Arc::new(Picture::new(t)));
        let known = self.pictures.get(&(address, texture)).cloned().or_else(made)?;
        self.pictures.insert((address, texture), known.clone());
        Some(known)
    }

    /// Number of triangles at the finest level, and bytes of all levels.
    pub(crate) fn size(&self) -> (usize, usize) {
        let all = || self.assets.values().flatten();
        let bytes = |link: &Arc<Link>| {
            let fresh = |&i: &usize| i == 0 || !Arc::ptr_eq(&link.levels[i], &link.levels[i - 1]);
            (0..TOLERANCES.len()).filter(fresh).map(|i| link.levels[i].bytes()).sum::<usize>()
        };
        (all().map(|l| l.levels[0].len()).sum(), all().map(bytes).sum())
    }
}
