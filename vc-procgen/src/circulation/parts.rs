//! Parts of a building as items.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{Pose, Seed};
use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Object, Style, object};

use crate::area::Area;
use crate::item::{Item, Support, standing};
use crate::solids::Solids;

/// A point, metres.
pub(crate) type P = [f32; 3];

/// A box: two corners and the material.
pub(crate) type Block = (P, P, MaterialId);

/// A box between the intervals along the three axes.
pub(crate) fn block((x0, x1): (f32, f32), (y0, y1): (f32, f32), (z0, z1): (f32, f32), material: MaterialId) -> Block {
    ([x0, y0, z0], [x1, y1, z1], material)
}

/// A part of the building made of boxes.
pub(crate) fn solid(class: &'static str, blocks: &[Block]) -> Option<Item> {
    solid_with(class, blocks, &[])
}

/// A floor made of boxes, on whose areas things can be put at height zero.
pub(crate) fn floor(blocks: &[Block], areas: &[Area]) -> Option<Item> {
    solid_with("floor", blocks, areas)
}

fn solid_with(class: &'static str, blocks: &[Block], areas: &[Area]) -> Option<Item> {
    let mut solids = Solids::new(class);
    blocks.iter().for_each(|(low, high, material)| solids.block(class, *low, *high, *material));
    for area in areas {
        let (width, depth) = area.size();
        solids.top(class, area.centre(), (width / 2.0, depth / 2.0));
    }
    let (object, at) = solids.finish()?;
    Some(fixed(object, Pose::translation(at.x, at.y, at.z)))
}

/// A part of the building with its origin at a point; it is built around that point.
pub(crate) fn built(class: &'static str, at: P, style: &Style, build: impl FnOnce(&mut Build<'_>)) -> Item {
    let mut made = Build::new(class, Vector3::repeat(1.0), style, Seed(0).stream());
    made.anchored();
    build(&mut made);
    let (asset, bounds) = made.finish();
    fixed(Object::new(class, asset, bounds), Pose::translation(at[0], at[1], at[2]))
}

/// Draws objects of classes: in one style, the same for the same seed.
#[derive(Clone, Copy)]
pub(crate) struct Maker<'a> {
    pub(crate) style: &'a Style,
    pub(crate) seed: Seed,
}

impl Maker<'_> {
    /// An object of the class's usual size.
    pub(crate) fn usual(self, class: &str, nth: u64) -> Option<Object> {
        Some(object::generator(class)?.object(self.style, self.seed.child(class).nth(nth)))
    }

    /// An object of a size: depth, width, height.
    pub(crate) fn sized(self, class: &str, size: [f32; 3]) -> Option<Object> {
        Some(object::generator(class)?.sized(size.into(), self.style, self.seed.child(class)))
    }
}

/// A part of the building with its own origin at a point.
pub(crate) fn mounted(object: Object, at: P, yaw: f32) -> Item {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
    fixed(object, Pose::from_parts(Vector3::from(at).into(), turn))
}

/// An object whose base is centred at a point.
pub(crate) fn placed(object: Object, at: P, yaw: f32, support: Support) -> Item {
    shared(&Arc::new(object), at, yaw, support)
}

/// The same of an object that stands in several places.
pub(crate) fn shared(object: &Arc<Object>, at: P, yaw: f32, support: Support) -> Item {
    let pose = standing(object, (at[0], at[1]), at[2], yaw);
    Item { object: object.clone(), pose, support, room: 0, states: Vec::new(), between: None, required: false }
}

fn fixed(object: Object, pose: Pose) -> Item {
    let object = Arc::new(object);
    Item { object, pose, support: Support::Built, room: 0, states: Vec::new(), between: None, required: true }
}
