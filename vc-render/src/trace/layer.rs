//! Triangles of one kind: those that stand in one tree, what has moved since in trees of its own.

use std::sync::Arc;

use pulp::{Simd, WithSimd};

use super::build::over;
use super::bvh::{Bvh, Hit, Node, Ray};
use super::walk::{Beam, walk};
use crate::affine::{self, three};
use crate::mesh::{Bounds, Mesh};
use crate::scene::{Instance, turned};

/// Solid triangles, or clear ones.
#[derive(Debug, Clone, Default)]
pub(super) struct Layer {
    standing: Arc<Bvh>,
    /// By number in that tree.
    origins: Arc<Vec<Origin>>,
    /// Nodes over the instances that have moved.
    moving: Vec<Node>,
    /// Whether it is of clear triangles.
    clear: bool,
}

/// Whose a triangle is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Origin {
    pub(super) instance: u32,
    /// Its triangle in the mesh.
    pub(super) triangle: u32,
    /// Its part of the asset.
    pub(super) part: u16,
}

/// What a ray has met: where, edges in the world, and whose it is.
pub(super) type Found = (Hit, Origin);

impl Mesh {
    /// Trees of its solid and of its clear triangles, in its own frame; built when they are
    /// asked for first, a microsecond a triangle, and shared by all its instances.
    pub(super) fn trees(&self) -> &[Bvh; 2] {
        self.trees.get_or_init(|| {
            let tree = |clear: bool| {
                let corners: Vec<_> = self.of_kind(clear).map(|(_, corners)| corners).collect();
                Bvh::build(&corners)
            };
            [tree(false), tree(true)]
        })
    }

    /// Its solid or its clear triangles: numbers and corners.
    fn of_kind(&self, clear: bool) -> impl Iterator<Item = (u32, [[f32; 3]; 3])> + '_ {
        let clusters = if clear { &self.clusters[self.opaque..] } else { &self.clusters[..self.opaque] };
        let each = move |cluster| move |triangle: u32| (triangle, self.triangle(cluster, triangle as usize));
        clusters.iter().flat_map(move |cluster| cluster.triangles.clone().map(each(cluster)))
    }

    /// The number of its first clear triangle.
    fn first_clear(&self) -> u32 {
        self.clusters.get(self.opaque).map_or(0, |c| c.triangles.start)
    }
}

impl Layer {
    /// All of one tree. Takes about a microsecond a triangle.
    pub(super) fn new(instances: &[Instance], clear: bool) -> Self {
        let (mut corners, mut origins) = (Vec::new(), Vec::new());
        for (instance, at) in (0..).zip(instances) {
            let world = at.world.narrow();
            let mesh = &*at.link.levels[0];
            for (triangle, own) in mesh.of_kind(clear) {
                corners.push(own.map(|p| affine::point(&world, p)));
                origins.push(Origin { instance, triangle, part: mesh.faces[triangle as usize].part });
            }
        }
        Self { standing: Arc::new(Bvh::build(&corners)), origins: Arc::new(origins), moving: Vec::new(), clear }
    }

    /// Takes instances out of the tree of what stands.
    pub(super) fn loosen(&mut self, gone: &[bool]) {
        let origins = &self.origins;
        Arc::make_mut(&mut self.standing).remove(|number| gone[origins[number as usize].instance as usize]);
    }

    /// Puts the nodes over what moves to where it is.
    pub(super) fn arrange(&mut self, instances: &[Instance], moving: &[bool]) {
        let has = |mesh: &Mesh| if self.clear { mesh.opaque < mesh.clusters.len() } else { mesh.opaque > 0 };
        let moving = (0..).zip(instances).zip(moving).filter(|((_, i), moves)| **moves && has(&i.link.levels[0]));
        self.moving = over(moving.map(|((number, instance), _)| (number, reach(instance))));
    }
}

/// What is met first along a ray in several layers.
#[inline]
pub(super) fn first<const LAYERS: usize>(layers: [&Layer; LAYERS], instances: &[Instance], ray: &Ray) -> Option<Found> {
    let mut found = crate::simd::dispatch(Standing::<false, LAYERS> { layers, ray });
    for layer in layers.into_iter().filter(|layer| !layer.moving.is_empty()) {
        let ray = Ray { end: found.map_or(ray.end, |(hit, _)| hit.t), ..*ray };
        found = crate::simd::dispatch(Among::<false> { layer, instances, ray: &ray }).or(found);
    }
    found
}

/// Whether anything is met along a ray in a layer.
#[inline]
pub(super) fn any(layer: &Layer, instances: &[Instance], ray: &Ray) -> bool {
    let among = || crate::simd::dispatch(Among::<true> { layer, instances, ray });
    let standing = crate::simd::dispatch(Standing::<true, 1> { layers: [layer], ray });
    standing.is_some() || !layer.moving.is_empty() && among().is_some()
}

/// A search among what stands, in several layers.
struct Standing<'a, const ANY: bool, const LAYERS: usize> {
    layers: [&'a Layer; LAYERS],
    ray: &'a Ray,
}

impl<const ANY: bool, const LAYERS: usize> WithSimd for Standing<'_, ANY, LAYERS> {
    type Output = Option<Found>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<Found> {
        let Self { layers, ray } = self;
        let beam = Beam::new(simd, ray);
        let (mut found, mut end) = (None, ray.end);
        for layer in layers {
            if let Some(hit) = layer.standing.meet::<S, ANY>(simd, (ray, end), &beam) {
                end = hit.t;
                found = Some((hit, layer.origins[hit.number as usize]));
            }
        }
        found
    }
}

/// A search among what moves.
struct Among<'a, const ANY: bool> {
    layer: &'a Layer,
    instances: &'a [Instance],
    ray: &'a Ray,
}

impl<const ANY: bool> WithSimd for Among<'_, ANY> {
    type Output = Option<Found>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<Found> {
        let Self { layer, instances, ray } = self;
        let kind = usize::from(layer.clear);
        let met = walk::<S, Found, ANY>(
            simd,
            &layer.moving,
            (&Beam::new(simd, ray), ray.end),
            #[inline(always)]
            |number, end| {
                let instance = &instances[number as usize];
                let (mesh, back) = (&*instance.link.levels[0], &instance.inverse);
                // Lengths along the ray stay what they are.
                let own = Ray { from: affine::point(back, ray.from), along: affine::vector(back, ray.along), end };
                let hit = mesh.trees()[kind].meet::<S, ANY>(simd, (&own, end), &Beam::new(simd, &own))?;
                let world = instance.world.narrow();
                let edges = hit.edges.map(|edge| affine::vector(&world, edge));
                let triangle = hit.number + if layer.clear { mesh.first_clear() } else { 0 };
                let part = mesh.faces[triangle as usize].part;
                Some((hit.t, (Hit { edges, ..hit }, Origin { instance: number, triangle, part })))
            },
        );
        met.map(|(_, found)| found)
    }
}

/// The box around an instance, a little larger against rounding.
fn reach(instance: &Instance) -> Bounds {
    let around = turned(&instance.world.narrow(), &instance.link.levels[0].bounds);
    let half = three(|i| around.half[i] + 1e-5 * (1.0 + around.centre[i].abs() + around.half[i]));
    Bounds { half, ..around }
}
