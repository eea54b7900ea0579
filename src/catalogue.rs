//! Objects from the generators, for tasks and for things that appear.

use std::sync::LazyLock;

use vc_graph::class::Class;
use vc_graph::{AssetLibrary, Draft, SceneGraph, Seed};
use vc_shapes::{Generators, material};
use vc_tasks::initial::Stock;

/// The catalogue of every object that generators can make, in any number; by default the generators of `vc-shapes`.
///
/// ```
/// use virtualcity::graph::{AssetLibrary, ClassTable, SceneBuilder, Seed};
/// use virtualcity::initial::Catalogue;
/// use virtualcity::shapes::{Build, Generator, Generators, Realm, material::BRASS};
/// use virtualcity::tasks::initial::Stock;
///
/// fn samovar(b: &mut Build<'_>) {
///     b.cylinder("urn", [0.0; 3], b.size.x / 2.0, b.size.z, BRASS);
/// }
///
/// let row = "samovar | appliance | | appliance | graspable | 0.3 0.3 0.4 | 4 | | | kitchen:1";
/// let classes = ClassTable::builtin().extended("mine.txt", row)?;
/// let mut generators = Generators::default();
/// generators.register(&classes, Generator::new("samovar", Realm::Indoor, 1, samovar))?;
/// let (scene, mut assets) = (SceneBuilder::new("home").build(), AssetLibrary::default());
/// let class = classes.get("samovar").ok_or("no class")?;
/// assert!(Catalogue::new(generators).thing(class, Seed(1), &scene, &mut assets).is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    generators: Generators,
}

impl Catalogue {
    /// The catalogue of what generators make.
    pub const fn new(generators: Generators) -> Self {
        Self { generators }
    }
}

impl Stock for Catalogue {
    fn thing(&self, class: &Class, seed: Seed, _: &SceneGraph, assets: &mut AssetLibrary) -> Option<Draft> {
        static MATERIALS: LazyLock<AssetLibrary> = LazyLock::new(material::library);
        let object = self.generators.get(&class.name)?.instance(seed, 0).object;
        let merged = assets.merge(&MATERIALS).ok()?;
        let asset = assets.add(merged.renumbered(object.asset)).ok()?;
        Some(Draft { asset: Some(asset), ..Draft::new(class.name.clone()).bounds(object.bounds) })
    }
}
