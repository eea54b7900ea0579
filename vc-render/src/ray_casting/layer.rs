//! Layers of triangles: standing ones in one tree, moved ones in trees of their own.

use std::sync::Arc;

use pulp::{Simd, WithSimd};

use crate::bvh::{Beam, Bvh, Hit, Node, Ray, over, walk};
use crate::math::{self, Bounds, three};
use crate::mesh::Mesh;
use crate::scene::Instance;

/// The opaque triangles of a scene, or the clear ones.
#[derive(Debug, Clone, Default)]
pub(super) struct Layer {
    standing: Arc<Bvh>,
    /// Origin of each triangle in that tree.
    origins: Arc<Vec<Origin>>,
    /// Nodes over the instances that have moved.
    moving: Vec<Node>,
    /// Whether its triangles are the clear ones.
    clear: bool,
}

/// The instance that a triangle belongs to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Origin {
    pub(super) instance: u32,
    /// Index of the triangle in the mesh.
    pub(super) triangle: u32,
    /// Index of its part in the asset.
    pub(super) part: u16,
}

/// A hit with edges in the world, and the origin of its triangle.
pub(super) type Found = (Hit, Origin);

impl Mesh {
    /// Trees of its opaque and its clear triangles, in the mesh's frame; built on first use, a microsecond for
    /// each triangle, and shared by all instances.
    pub(super) fn trees(&self) -> &[Bvh; 2] {
        self.trees.get_or_init(|| {
            let tree = |clear: bool| {
                let corners: Vec<_> = self.of_kind(clear).map(|(_, corners)| corners).collect();
                Bvh::build(&corners)
            };
            [tree(false), tree(true)]
        })
    }

    /// Its opaque or its clear triangles: numbers and corners.
    fn of_kind(&self, clear: bool) -> impl Iterator<Item = (u32, [[f32; 3]; 3])> + '_ {
        let clusters = if clear { &self.clusters[self.opaque..] } else { &self.clusters[..self.opaque] };
        let each = move |cluster| move |triangle: u32| (triangle, self.triangle(cluster, triangle as usize));
        clusters.iter().flat_map(move |cluster| cluster.triangles.clone().map(each(cluster)))
    }

    /// Number of its first clear triangle.
    fn first_clear(&self) -> u32 {
        self.clusters.get(self.opaque).map_or(0, |c| c.triangles.start)
    }
}

impl Layer {
    /// Puts all triangles into one tree. Takes about a microsecond for each triangle.
    pub(super) fn new(instances: &[Instance], clear: bool) -> Self {
        let (mut corners, mut origins) = (Vec::new(), Vec::new());
        for (instance, at) in (0..).zip(instances) {
            let world = at.world.narrow();
            let mesh = &*at.link.levels[0];
            for (triangle, own) in mesh.of_kind(clear) {
                corners.push(own.map(|p| math::point(&world, p)));
                origins.push(Origin { instance, triangle, part: mesh.faces[triangle as usize].part });
            }
        }
        Self { standing: Arc::new(Bvh::build(&corners)), origins: Arc::new(origins), moving: Vec::new(), clear }
    }

    /// Removes instances from the tree of standing triangles.
    pub(super) fn loosen(&mut self, gone: &[bool]) {
        let origins = &self.origins;
        Arc::make_mut(&mut self.standing).remove(|number| gone[origins[number as usize].instance as usize]);
    }

    /// Rebuilds the nodes over moved instances at their present places.
    pub(super) fn arrange(&mut self, instances: &[Instance], moving: &[bool]) {
        let has = |mesh: &Mesh| if self.clear { mesh.opaque < mesh.clusters.len() } else { mesh.opaque > 0 };
        let moving = (0..).zip(instances).zip(moving).filter(|((_, i), moves)| **moves && has(&i.link.levels[0]));
        self.moving = over(moving.map(|((number, instance), _)| (number, reach(instance))));
    }
}

/// The first hit of a ray in several layers.
#[inline]
pub(super) fn first<const LAYERS: usize>(layers: [&Layer; LAYERS], instances: &[Instance], ray: &Ray) -> Option<Found> {
    let mut found = crate::math::simd::dispatch(Standing::<false, LAYERS> { layers, ray });
    for layer in layers.into_iter().filter(|layer| !layer.moving.is_empty()) {
        let ray = Ray { end: found.map_or(ray.end, |(hit, _)| hit.t), ..*ray };
        found = crate::math::simd::dispatch(Among::<false> { layer, instances, ray: &ray }).or(found);
    }
    found
}

/// Whether a ray hits anything in a layer.
#[inline]
pub(super) fn any(layer: &Layer, instances: &[Instance], ray: &Ray) -> bool {
    let among = || crate::math::simd::dispatch(Among::<true> { layer, instances, ray });
    let standing = crate::math::simd::dispatch(Standing::<true, 1> { layers: [layer], ray });
    standing.is_some() || !layer.moving.is_empty() && among().is_some()
}

/// A search among standing triangles, in several layers.
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

/// A search among moved instances.
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
                // Lengths along the ray are the same in both frames.
                let own = Ray { from: math::point(back, ray.from), along: math::vector(back, ray.along), end };
                let hit = mesh.trees()[kind].meet::<S, ANY>(simd, (&own, end), &Beam::new(simd, &own))?;
                let world = instance.world.narrow();
                let edges = hit.edges.map(|edge| math::vector(&world, edge));
                let triangle = hit.number + if layer.clear { mesh.first_clear() } else { 0 };
                let part = mesh.faces[triangle as usize].part;
                Some((hit.t, (Hit { edges, ..hit }, Origin { instance: number, triangle, part })))
            },
        );
        met.map(|(_, found)| found)
    }
}

/// The bounding box of an instance, enlarged a little to allow for rounding.
fn reach(instance: &Instance) -> Bounds {
    let around = instance.link.levels[0].bounds.mapped(&instance.world.narrow());
    let half = three(|i| around.half[i] + 1e-5 * (1.0 + around.centre[i].abs() + around.half[i]));
    Bounds { half, ..around }
}
