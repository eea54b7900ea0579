//! Values that are computed once for each asset of a library, and shared by worlds, clones and threads.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use vc_graph::AssetLibrary;

/// Values by asset library and key: an asset's number, with its scale or whatever else a value depends on.
///
/// The values of a library are dropped after it is. A value has to depend on nothing but its key and the library,
/// so that it does not matter who asks first.
///
/// ```
/// use std::sync::Arc;
/// use vc_geometry::cache::AssetCache;
/// use vc_graph::{Asset, AssetLibrary};
/// let mut library = AssetLibrary::default();
/// let id = library.add(Asset { name: "cup".into(), ..Asset::default() })?;
/// let (library, cache) = (Arc::new(library), AssetCache::new());
/// let parts = || cache.get(&library, id, |library| library.get(id).map_or(0, |asset| asset.parts.len()));
/// assert!(Arc::ptr_eq(&parts(), &parts()));
/// assert_eq!(cache.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct AssetCache<K, T> {
    libraries: Mutex<HashMap<usize, Library<K, T>>>,
}

/// The values of one library. It is identified by its address, which is unique as long as the weak pointer lives.
struct Library<K, T> {
    alive: Weak<AssetLibrary>,
    known: HashMap<K, Arc<T>>,
}

impl<K, T> Default for AssetCache<K, T> {
    fn default() -> Self {
        Self { libraries: Mutex::default() }
    }
}

impl<K, T> std::fmt::Debug for AssetCache<K, T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "AssetCache({} values)", self.len())
    }
}

impl<K, T> AssetCache<K, T> {
    /// An empty cache.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of values.
    pub fn len(&self) -> usize {
        self.lock().values().map(|l| l.known.len()).sum()
    }

    /// Whether the cache is empty.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<usize, Library<K, T>>> {
        // The map is consistent even if a thread panicked while it held the lock.
        self.libraries.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Gives access to all values of a library under one lock. Values of libraries that are no more are dropped. Other
    /// threads wait for `work`, which must not ask the same cache again.
    pub fn session<R>(&self, library: &Arc<AssetLibrary>, work: impl FnOnce(&mut HashMap<K, Arc<T>>) -> R) -> R {
        let mut libraries = self.lock();
        libraries.retain(|_, l| l.alive.strong_count() > 0);
        let address = Arc::as_ptr(library) as usize;
        let fresh = || Library { alive: Arc::downgrade(library), known: HashMap::new() };
        work(&mut libraries.entry(address).or_insert_with(fresh).known)
    }
}

impl<K: Eq + Hash, T> AssetCache<K, T> {
    /// The value of a key, computed if nobody has asked for it. Other threads wait for `make`, which must not ask the
    /// same cache again.
    pub fn get(&self, library: &Arc<AssetLibrary>, key: K, make: impl FnOnce(&AssetLibrary) -> T) -> Arc<T> {
        self.session(library, |known| known.entry(key).or_insert_with(|| Arc::new(make(library))).clone())
    }
}
