//! Objects that are planned before they are generated.

use std::cell::OnceCell;
use std::rc::Rc;
use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::{Asset, Bounds, ObjectRole, Seed};
use vc_shapes::object::fitted::Unit;
use vc_shapes::{Generator, Object, Style};

/// A planned object: placements are found by its size alone, and the object is generated once it
/// has one.
#[derive(Debug, Clone)]
pub(crate) struct Draft {
    pub(crate) class: &'static str,
    role: ObjectRole,
    size: Vector3<f32>,
    source: Source,
}

#[derive(Debug, Clone)]
enum Source {
    Made(Arc<Object>),
    /// Clones of a draft share the generated object.
    Planned(Generator, Seed, Rc<OnceCell<Arc<Object>>>),
    /// A unit of a fitted kitchen, with the seeds of the kitchen and its own.
    Fitted(Unit, (Seed, Seed)),
}

impl Draft {
    /// A draft no larger than `size`.
    pub(crate) fn sized(generator: &Generator, size: Vector3<f32>, seed: Seed) -> Self {
        let source = Source::Planned(*generator, seed, Rc::default());
        Self { class: generator.class, role: generator.role(), size, source }
    }

    /// A draft of the class's usual size.
    pub(crate) fn usual(generator: &Generator, seed: Seed) -> Self {
        Self::sized(generator, generator.usual_size(seed), seed)
    }

    /// A draft of a fitted unit of exactly that size, by the seeds of the kitchen and of the unit.
    pub(crate) fn fitted(unit: Unit, role: ObjectRole, size: Vector3<f32>, seeds: (Seed, Seed)) -> Self {
        Self { class: unit.purpose.class(), role, size, source: Source::Fitted(unit, seeds) }
    }

    /// A draft of an existing object.
    pub(crate) fn from_object(object: Arc<Object>) -> Self {
        Self { class: object.class, role: object.role, size: object.size(), source: Source::Made(object) }
    }

    /// Its class.
    pub(crate) fn class(&self) -> &'static str {
        self.class
    }

    /// The upper bounds of depth, width and height, metres.
    pub(crate) fn size(&self) -> Vector3<f32> {
        self.size
    }

    /// Its box without any parts, used to find a placement.
    pub(crate) fn outline(&self) -> Object {
        Object { role: self.role, ..Object::new(self.class, Asset::default(), Bounds::standing(self.size)) }
    }

    /// The object with sole ownership.
    pub(crate) fn into_object(self, style: &Style) -> Object {
        match self.source {
            Source::Made(object) => Arc::unwrap_or_clone(object),
            Source::Planned(generator, seed, _) => generator.sized(self.size, style, seed),
            Source::Fitted(unit, seeds) => unit.object(self.size, style, seeds),
        }
    }

    /// The shared object, generated on first use.
    pub(crate) fn object(&self, style: &Style) -> Arc<Object> {
        match &self.source {
            Source::Made(object) => object.clone(),
            Source::Fitted(unit, seeds) => Arc::new(unit.object(self.size, style, *seeds)),
            Source::Planned(generator, seed, made) => {
                made.get_or_init(|| Arc::new(generator.sized(self.size, style, *seed))).clone()
            }
        }
    }
}
