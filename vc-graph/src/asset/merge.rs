//! One library of two: the content of another is added, or found where it is there already.

use std::sync::Arc;

use super::{Asset, AssetError, AssetId, AssetLibrary, Material, Part};

/// The numbers of a [merged](AssetLibrary::merge) library's content in the library that took it over: each is the own
/// number plus that of the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Merged {
    /// The number of its first texture.
    pub textures: u32,
    /// The number of its first material.
    pub materials: u32,
    /// The number of its first asset.
    pub assets: u32,
}

impl Merged {
    /// The identifier of one of its assets.
    pub fn asset(self, own: AssetId) -> AssetId {
        AssetId(own.0.saturating_add(self.assets))
    }

    /// An asset that uses its materials, with the numbers of these in the library that took them over.
    pub fn renumbered(self, mut asset: Asset) -> Asset {
        let parts = asset.parts.iter_mut().chain(&mut asset.collision);
        parts.for_each(|part| part.material = part.material.saturating_add(self.materials));
        asset
    }
}

/// The index at which a list has all of another in its order.
fn run<T: PartialEq>(list: &[T], wanted: &[T]) -> Option<u32> {
    match wanted.len() {
        0 => Some(0),
        length => list.windows(length).position(|window| window == wanted).map(|at| at as u32),
    }
}

/// The first number of several things that are added.
fn first(added: impl Iterator<Item = Result<u32, AssetError>>) -> Result<u32, AssetError> {
    let numbers = added.collect::<Result<Vec<u32>, _>>()?;
    Ok(numbers.first().copied().unwrap_or(0))
}

impl AssetLibrary {
    /// Adds the textures, materials and assets of another library, and tells how their numbers change.
    ///
    /// Content is not added again where this library already has all of a kind in the same order: two things made from
    /// one table of materials share it.
    ///
    /// ```
    /// use vc_graph::AssetLibrary;
    /// use vc_graph::asset::Material;
    /// let [mut home, mut table] = [AssetLibrary::default(), AssetLibrary::default()];
    /// home.add_material(Material::new("paint", [0.9; 3]))?;
    /// table.add_material(Material::new("oak", [0.5, 0.4, 0.3]))?;
    /// assert_eq!(home.merge(&table)?.materials, 1);
    /// assert_eq!(home.merge(&table)?.materials, 1, "the second time it is there");
    /// # Ok::<(), vc_graph::asset::AssetError>(())
    /// ```
    ///
    /// # Errors
    /// [`AssetError`] if the other library has content that this one would refuse; nothing is added then.
    pub fn merge(&mut self, other: &Self) -> Result<Merged, AssetError> {
        let before = (self.textures.len(), self.materials.len(), self.assets.len());
        let merged = self.take_over(other);
        if merged.is_err() {
            self.textures.truncate(before.0);
            self.materials.truncate(before.1);
            self.assets.truncate(before.2);
        }
        merged
    }

    /// The asset that is the same as one of another library: equal parts of equal materials.
    ///
    /// Costs a comparison of names with all assets, and of shapes where names are equal.
    pub fn find(&self, from: &Self, id: AssetId) -> Option<AssetId> {
        let wanted = from.get(id)?;
        let here = self.assets.iter().position(|known| self.is_same(known, from, wanted))?;
        Some(AssetId(here as u32))
    }

    /// Takes over one asset of another library with its materials and their textures, each unless it is here already.
    ///
    /// # Errors
    /// [`AssetError`] if the other library has no such asset, or content that this one would refuse.
    pub fn import(&mut self, from: &Self, id: AssetId) -> Result<AssetId, AssetError> {
        if let Some(here) = self.find(from, id) {
            return Ok(here);
        }
        let asset = from.get(id).ok_or(AssetError::NoSuchAsset { asset: id.0, count: from.len() })?;
        let mut copy = Asset::clone(asset);
        for part in copy.parts.iter_mut().chain(&mut copy.collision) {
            part.material = self.import_material(from, part)?;
        }
        self.add(copy)
    }

    fn import_material(&mut self, from: &Self, part: &Part) -> Result<u32, AssetError> {
        let (name, count) = (part.name.clone(), from.materials.len());
        let missing = AssetError::NoSuchMaterial { part: name, material: part.material, count };
        let mut material = from.material(part.material).ok_or(missing)?.clone();
        if let Some(at) = self.materials.iter().position(|known| self.is_same_material(known, from, &material)) {
            return Ok(at as u32);
        }
        if let Some(texture) = material.texture.and_then(|texture| from.texture(texture)) {
            let here = self.textures.iter().position(|known| known == texture);
            material.texture = Some(here.map_or_else(|| self.add_texture(texture.clone()), |at| Ok(at as u32))?);
        }
        self.add_material(material)
    }

    fn is_same(&self, known: &Asset, from: &Self, wanted: &Asset) -> bool {
        let parts = |mine: &[Part], theirs: &[Part]| {
            mine.len() == theirs.len()
                && mine.iter().zip(theirs).all(|(mine, theirs)| self.is_same_part(mine, from, theirs))
        };
        known.name == wanted.name
            && known.surfaces == wanted.surfaces
            && parts(&known.parts, &wanted.parts)
            && parts(&known.collision, &wanted.collision)
    }

    fn is_same_part(&self, mine: &Part, from: &Self, theirs: &Part) -> bool {
        let materials = self.material(mine.material).zip(from.material(theirs.material));
        (&mine.name, mine.pose, mine.joint, &mine.shape) == (&theirs.name, theirs.pose, theirs.joint, &theirs.shape)
            && materials.is_some_and(|(mine, theirs)| self.is_same_material(mine, from, theirs))
    }

    fn is_same_material(&self, mine: &Material, from: &Self, theirs: &Material) -> bool {
        let plain = |of: &Material| Material { texture: None, ..of.clone() };
        let mine_drawn = mine.texture.and_then(|index| self.texture(index));
        let theirs_drawn = theirs.texture.and_then(|index| from.texture(index));
        mine.name == theirs.name && plain(mine) == plain(theirs) && mine_drawn == theirs_drawn
    }

    fn take_over(&mut self, other: &Self) -> Result<Merged, AssetError> {
        let textures = match run(&self.textures, &other.textures) {
            Some(at) => at,
            None => first(other.textures.iter().map(|t| self.add_texture(t.clone())))?,
        };
        let moved = |m: &Material| Material { texture: m.texture.map(|t| t + textures), ..m.clone() };
        let materials: Vec<Material> = other.materials.iter().map(moved).collect();
        let materials = match run(&self.materials, &materials) {
            Some(at) => at,
            None => first(materials.into_iter().map(|m| self.add_material(m)))?,
        };
        let merged = Merged { textures, materials, assets: 0 };
        let renumbered = |asset: &Arc<Asset>| match merged.materials {
            0 => asset.clone(),
            _ => Arc::new(merged.renumbered(Asset::clone(asset))),
        };
        let assets: Vec<Arc<Asset>> = other.assets.iter().map(renumbered).collect();
        let assets = match run(&self.assets, &assets) {
            Some(at) => at,
            None => first(assets.into_iter().map(|a| self.share(a).map(|id| id.0)))?,
        };
        Ok(Merged { assets, ..merged })
    }
}
