//! Links: groups of an asset's parts that move together.

use std::sync::Arc;

use vc_graph::asset::{Joint, Part, Shape};
use vc_graph::{Asset, TriangleMesh};

use super::simplify::Simplifier;
use super::{Mesh, Source};

/// Greatest distance of curves from their chords at each level of detail, metres; triangle meshes are unchanged
/// at the first.
pub(crate) const TOLERANCES: [f32; 5] = [0.0005, 0.001, 0.002, 0.008, 0.03];

/// Parts of an asset that move together, at every level of detail.
#[derive(Debug, Clone)]
pub(crate) struct Link {
    pub(crate) joint: Option<Joint>,
    /// Whether it is the head of a window cover: the cover hangs from it, and it does not move when the cover
    /// is drawn.
    pub(crate) head: bool,
    /// Levels of detail, the finest first.
    pub(crate) levels: [Arc<Mesh>; TOLERANCES.len()],
}

/// The surface of a part.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Finish {
    pub(crate) surface: u16,
    /// Whether it is transparent.
    pub(crate) clear: bool,
    /// Whether it has an image texture.
    pub(crate) pictured: bool,
}

/// A part's index and its surface.
type Finished = (usize, Finish);

/// Greatest distance of a head's upper end from the top of its cover, metres, and greatest share of the cover's
/// height that a head has.
const HEAD: (f32, f32) = (0.005, 0.4);

/// The links of an asset, the one without a joint first if there is one; the head of a `cover` is a separate
/// link.
///
/// `finish` gives the surface of a part; its error is returned.
pub(crate) fn links<E>(
    asset: &Asset,
    cover: bool,
    mut finish: impl FnMut(&Part) -> Result<Finish, E>,
) -> Result<Vec<Link>, E> {
    type Key = (Option<Joint>, bool);
    let whole = if cover { asset.extent().map(|(low, high)| (low.z, high.z)) } else { None };
    let mut groups: Vec<(Key, Vec<Finished>)> = vec![((None, false), Vec::new())];
    for (index, part) in asset.parts.iter().enumerate() {
        let (own, key) = ((index, finish(part)?), (part.joint, whole.is_some_and(|whole| is_head(part, whole))));
        match groups.iter_mut().find(|g| g.0 == key) {
            Some(group) => group.1.push(own),
            None => groups.push((key, vec![own])),
        }
    }
    groups.retain(|g| !g.1.is_empty());
    let link = |((joint, head), parts): (Key, Vec<Finished>)| Link { joint, head, levels: levels(asset, &parts) };
    Ok(groups.into_iter().map(link).collect())
}

/// Whether a part of a cover with these ends is its head.
fn is_head(part: &Part, (bottom, top): (f32, f32)) -> bool {
    let (low, high) = part.extent();
    high.z > top - HEAD.0 && high.z - low.z < HEAD.1 * (top - bottom)
}

/// A part of an asset as a separate link.
pub(crate) fn single(asset: &Asset, part: usize, finish: Finish) -> Link {
    Link { joint: asset.parts[part].joint, head: false, levels: levels(asset, &[(part, finish)]) }
}

fn levels(asset: &Asset, finished: &[Finished]) -> [Arc<Mesh>; TOLERANCES.len()] {
    let mut parts: Vec<Coarser> = finished.iter().map(|own| Coarser::new(asset, *own)).collect();
    let mut last: Option<Arc<Mesh>> = None;
    TOLERANCES.map(|tolerance| {
        let sources: Vec<Source> = parts.iter_mut().map(|part| part.source(tolerance)).collect();
        let count: usize = sources.iter().map(|s| s.mesh.triangles.len()).sum();
        let same = last.clone().filter(|mesh| mesh.len() == count);
        last.insert(same.unwrap_or_else(|| Arc::new(Mesh::build(&sources)))).clone()
    })
}

/// A part that becomes coarser from level to level.
struct Coarser<'a> {
    part: &'a Part,
    own: Finished,
    /// For a simplified mesh, after its first level.
    simplifier: Option<Simplifier>,
}

impl<'a> Coarser<'a> {
    fn new(asset: &'a Asset, own: Finished) -> Self {
        Self { part: &asset.parts[own.0], own, simplifier: None }
    }

    fn source(&mut self, tolerance: f32) -> Source {
        let free = matches!(self.part.shape, Shape::Mesh { .. });
        let (index, Finish { surface, clear, pictured }) = self.own;
        let mut mesh = match &mut self.simplifier {
            Some(simplifier) => {
                simplifier.collapse(tolerance);
                simplifier.mesh()
            }
            None => self.part.shape.mesh(tolerance),
        };
        if !pictured {
            mesh.uvs = Vec::new();
        }
        // Textured meshes are not simplified, as their textures would slip.
        if free && !pictured && self.simplifier.is_none() {
            self.simplifier = Some(Simplifier::new(&mesh));
        }
        mesh = mesh.transformed(&self.part.pose);
        // A mesh that is not closed gets a second side; all other shapes are closed.
        let sheet = free && !mesh.is_closed();
        if sheet {
            mesh.append(&turned_over(&mesh));
        }
        Source { mesh, part: index.min(usize::from(u16::MAX)) as u16, surface, clear, sheet }
    }
}

fn turned_over(mesh: &TriangleMesh) -> TriangleMesh {
    TriangleMesh {
        positions: mesh.positions.clone(),
        normals: mesh.normals.iter().map(|n| -n).collect(),
        triangles: mesh.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect(),
        uvs: mesh.uvs.iter().map(|&[a, b, c]| [a, c, b]).collect(),
    }
}
