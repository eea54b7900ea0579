//! Uploaded assets: they are built once and kept as long as the renderer lives.

use std::collections::HashMap;
use std::sync::Arc;

use vc_graph::asset::{Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Pose, Spec};

use super::liquid::Liquid;
use super::untied::Untied;
use crate::RenderError;
use crate::mesh::{Finish, Link, TOLERANCES, links, single};
use crate::surface::{Picture, Role, Surface};

/// How many surfaces can be numbered.
pub(crate) const MOST_SURFACES: usize = 1 << 16;

/// Links of all assets seen so far, and their surface materials.
#[derive(Debug, Default)]
pub(crate) struct Store {
    /// Largest screen-space error of a curved outline at which a coarser mesh may be drawn, pixels.
    pub(crate) detail: f32,
    /// Identity of the store, compared by address; snapshots made with this store carry it.
    pub(crate) name: Arc<()>,
    pub(crate) surfaces: Vec<Surface>,
    known_surfaces: HashMap<SurfaceKey, u16>,
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

/// Library, material, role, and whether pictures are mapped onto the surface.
type SurfaceKey = (usize, u32, Role, bool);

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
    pub(super) fn liquid(
        &mut self,
        library: &Arc<AssetLibrary>,
        asset: &Arc<Asset>,
    ) -> Result<Option<Contained>, RenderError> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize);
        if let Some(known) = self.liquids.get(&key) {
            return Ok(known.clone());
        }
        let made = Liquid::within(asset).map(|liquid| {
            let finish = Finish { surface: self.water()?, clear: false, pictured: false };
            let mut filled = asset.as_ref().clone();
            filled.parts.push(liquid.part);
            Ok::<_, RenderError>((Arc::new(single(&filled, asset.parts.len(), finish)), liquid.bottom))
        });
        let made = made.transpose()?;
        self.liquids.insert(key, made.clone());
        Ok(made)
    }

    /// The cloth of an uploaded asset without its band, if it has one; built on first use.
    pub(super) fn untied(
        &mut self,
        library: &Arc<AssetLibrary>,
        asset: &Arc<Asset>,
    ) -> Result<Option<Loose>, RenderError> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize);
        if let Some(known) = self.untied.get(&key) {
            return Ok(known.clone());
        }
        let made = Untied::new(asset).map(|Untied { cloth, index, hidden }| {
            let finish = self.surface(key.0, library, &cloth)?;
            let mut hanging = asset.as_ref().clone();
            hanging.parts[index] = cloth;
            Ok::<_, RenderError>((Arc::new(single(&hanging, index, finish)), hidden))
        });
        let made = made.transpose()?;
        self.untied.insert(key, made.clone());
        Ok(made)
    }

    fn water(&mut self) -> Result<u16, RenderError> {
        let water = Surface { roughness: 0.03, ..Surface::plain() };
        let water = self.water.map_or_else(|| self.add(water), Ok)?;
        self.water = Some(water);
        Ok(water)
    }

    /// The surface of nodes without an asset.
    fn plain(&mut self) -> Result<u16, RenderError> {
        let plain = self.stand_in.map_or_else(|| self.add(Surface::plain()), Ok)?;
        self.stand_in = Some(plain);
        Ok(plain)
    }

    /// Adds a surface; its number.
    fn add(&mut self, made: Surface) -> Result<u16, RenderError> {
        let number = u16::try_from(self.surfaces.len()).map_err(|_| RenderError::TooManySurfaces)?;
        self.surfaces.push(made);
        Ok(number)
    }

    /// The links of an asset, which may be a window cover; built on first use.
    pub(crate) fn links(
        &mut self,
        library: &Arc<AssetLibrary>,
        asset: &Arc<Asset>,
        cover: bool,
    ) -> Result<Vec<Arc<Link>>, RenderError> {
        let key = (Arc::as_ptr(library) as usize, Arc::as_ptr(asset) as usize, cover);
        if let Some(links) = self.assets.get(&key) {
            return Ok(links.clone());
        }
        self.kept.push((library.clone(), asset.clone()));
        let made = links(asset, cover, |part| self.surface(key.0, library, part))?;
        let made: Vec<Arc<Link>> = made.into_iter().map(Arc::new).collect();
        self.assets.insert(key, made.clone());
        Ok(made)
    }

    /// A plain box for a node without an asset; no links if the node has no box.
    pub(crate) fn stand_in(&mut self, spec: &Spec) -> Result<Vec<Arc<Link>>, RenderError> {
        let Some(bounds) = spec.bounds else { return Ok(Vec::new()) };
        let (half, offset) = (bounds.half, bounds.offset);
        let key = [half.x, half.y, half.z, offset.x, offset.y, offset.z].map(f32::to_bits);
        if let Some(links) = self.boxes.get(&key) {
            return Ok(links.clone());
        }
        let finish = Finish { surface: self.plain()?, clear: false, pictured: false };
        let part = Part {
            name: "box".into(),
            shape: Shape::Box { half },
            material: 0,
            pose: Pose::translation(offset.x, offset.y, offset.z),
            joint: None,
        };
        let asset = Asset { name: "box".into(), parts: vec![part], ..Asset::default() };
        let made: Vec<Arc<Link>> =
            links(&asset, false, |_| Ok::<_, RenderError>(finish))?.into_iter().map(Arc::new).collect();
        self.boxes.insert(key, made.clone());
        Ok(made)
    }

    fn surface(&mut self, address: usize, library: &AssetLibrary, part: &Part) -> Result<Finish, RenderError> {
        let role = Role::from_part(part);
        let placed = matches!(&part.shape, Shape::Mesh { uvs, .. } if !uvs.is_empty());
        let key = (address, part.material, role, placed);
        let surface = match self.known_surfaces.get(&key) {
            Some(known) => *known,
            None => self.made_surface(key, library)?,
        };
        let made = &self.surfaces[usize::from(surface)];
        Ok(Finish { surface, clear: made.is_clear(), pictured: made.picture.is_some() })
    }

    /// The number of the surface that a material has in a role: that of an equal one, or a new one.
    fn made_surface(&mut self, key: SurfaceKey, library: &AssetLibrary) -> Result<u16, RenderError> {
        let (address, material, role, placed) = key;
        let material = library.material(material);
        let made = material.map_or_else(Surface::plain, |m: &Material| Surface::new(m, role));
        let made = match material.and_then(|m| self.picture(address, library, m.texture?)) {
            Some(picture) if placed => made.with(picture),
            Some(picture) => made.tinted(&picture),
            None => made,
        };
        let same = (0..=u16::MAX).zip(&self.surfaces).find(|(_, known)| **known == made).map(|(number, _)| number);
        let number = same.map_or_else(|| self.add(made), Ok)?;
        self.known_surfaces.insert(key, number);
        Ok(number)
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

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use vc_graph::{Bounds, Draft, SceneBuilder};

    use super::*;
    use crate::Snapshot;

    /// The snapshot of a box, taken with a store that has so many surfaces already.
    fn snapshot_after(surfaces: usize) -> Result<Snapshot, RenderError> {
        let mut scene = SceneBuilder::new("one");
        let drawn = Draft::new("crate").at(Pose::identity()).bounds(Bounds::standing(Vector3::repeat(1.0)));
        assert!(scene.add(drawn).is_ok());
        let mut store = Store { surfaces: vec![Surface::plain(); surfaces], ..Store::new(0.25) };
        Snapshot::new(&mut store, &scene.build(), &mut |_, _| None)
    }

    #[test]
    fn surfaces_without_a_number_are_refused() {
        assert!(snapshot_after(MOST_SURFACES - 1).is_ok());
        assert_eq!(snapshot_after(MOST_SURFACES).map(|_| ()), Err(RenderError::TooManySurfaces));
    }
}
