//! The catalogue: numbered instances of every class.

use vc_graph::asset::{Part, Shape};
use vc_graph::hash::Digester;
use vc_graph::{Digest, Pose, Seed};

use crate::Style;
use crate::object::{Generator, Generators, Object, generators};

/// One object of the catalogue.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Instance {
    /// The generator that made it.
    pub generator: Generator,
    /// Its index within the class, from zero.
    pub index: usize,
    /// The style it is made in.
    pub style: Style,
    /// The object.
    pub object: Object,
}

impl Generator {
    /// Generates the catalogue's instance of this class with the given index: of the class's usual
    /// size, in a style of its own. Any index is allowed, also beyond `instances`.
    pub fn instance(&self, seed: Seed, index: usize) -> Instance {
        let seed = seed.child(self.class).nth(index as u64);
        let style = Style::from_seed(seed);
        Instance { generator: *self, index, style, object: self.object(&style, seed) }
    }

    fn instances_of(&self, seed: Seed) -> impl Iterator<Item = Instance> {
        let generator = *self;
        (0..self.instances).map(move |index| generator.instance(seed, index))
    }
}

/// All objects of the catalogue of built-in classes for a seed: the number of `instances` of every generator, by
/// family. [`Generators::instances`] has those of a program's own classes, too.
///
/// Each step costs the generation of one object, some microseconds.
///
/// ```
/// use std::collections::HashSet;
/// use vc_graph::Seed;
/// use vc_shapes::catalogue;
///
/// let tables = catalogue::instances(Seed(1)).filter(|i| i.generator.class == "dining_table");
/// let shapes: HashSet<_> = tables.map(|i| i.object.shape_key()).collect();
/// assert!(shapes.len() >= 37);
/// ```
pub fn instances(seed: Seed) -> impl Iterator<Item = Instance> {
    generators().flat_map(move |g| g.instances_of(seed))
}

impl Generators {
    /// All objects of the catalogue for a seed, those of built-in classes first.
    pub fn instances(&self, seed: Seed) -> impl Iterator<Item = Instance> {
        self.iter().flat_map(move |g| g.instances_of(seed))
    }
}

impl Object {
    /// A digest of the object's shape, independent of its materials: two objects with the same
    /// digest are the same object in other colours.
    ///
    /// Dimensions are rounded to a centimetre, or to a twentieth of the object's largest dimension
    /// where that is less; names and order of parts count, too.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_shapes::{Style, object};
    /// let generator = object::generator("chair").ok_or("no generator")?;
    /// let chair = |style| generator.object(&Style::from_seed(Seed(style)), Seed(1));
    /// // Another style changes the materials and not the shape.
    /// assert_eq!(chair(1).shape_key(), chair(1).shape_key());
    /// # Ok::<(), &str>(())
    /// ```
    pub fn shape_key(&self) -> Digest {
        let step = (self.size().max() * 0.05).min(0.01);
        let mut key = Key { hash: Digester::new(), step };
        key.text(self.class);
        self.asset.parts.iter().for_each(|p| key.part(p));
        key.hash.digest()
    }
}

/// A digest of measures that are rounded.
struct Key {
    hash: Digester,
    step: f32,
}

impl Key {
    fn text(&mut self, text: &str) {
        self.hash.words(text.bytes().map(u64::from));
    }

    fn rounded(&mut self, value: f32, step: f32) {
        self.hash.word((value / step).round() as i64 as u64);
    }

    fn measures(&mut self, values: impl IntoIterator<Item = f32>) {
        values.into_iter().for_each(|v| self.rounded(v, self.step));
    }

    fn part(&mut self, part: &Part) {
        self.text(&part.name);
        self.pose(&part.pose);
        self.shape(&part.shape);
    }

    fn pose(&mut self, pose: &Pose) {
        self.measures(pose.translation.vector.iter().copied());
        let turn = pose.rotation.to_rotation_matrix();
        turn.matrix().iter().for_each(|v| self.rounded(*v, 0.05));
    }

    fn shape(&mut self, shape: &Shape) {
        let (low, high) = shape.extent();
        self.measures((high - low).iter().copied());
        match shape {
            Shape::Hull { points } => self.measures(points.iter().flat_map(|p| [p.x, p.y, p.z])),
            Shape::Mesh { vertices, .. } => self.measures(vertices.iter().flat_map(|p| [p.x, p.y, p.z])),
            Shape::Lathe { profile: pairs } | Shape::Extrusion { outline: pairs, .. } => {
                self.measures(pairs.iter().flat_map(|&(a, b)| [a, b]));
            }
            // The others are their extent, but a cone is no cylinder.
            Shape::Cone { .. } => _ = self.hash.word(1),
            Shape::Cylinder { .. } => _ = self.hash.word(2),
            Shape::Capsule { .. } => _ = self.hash.word(3),
            Shape::Sphere { .. } => _ = self.hash.word(4),
            Shape::RoundedBox { radius, .. } => self.measures([*radius]),
            _ => _ = self.hash.word(5),
        }
    }
}
