//! The generator for an object: chosen by its class, and by hints from its name, size and position.

use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::{Aabb, ClassTable, NodeId};
use vc_shapes::Generators;

use super::house::House;

/// The facts about an object that determine its appearance.
struct Facts {
    /// The name in lower case, without separators.
    name: String,
    /// The longer and the shorter side of its footprint, and its height, metres.
    long: f32,
    short: f32,
    high: f32,
    /// The height of its bottom above the floor, metres.
    lift: f32,
}

impl Facts {
    fn named(&self, word: &str) -> bool {
        self.name.contains(word)
    }
}

/// A class, a condition, and the class used instead; the first rule that holds applies.
type Rule = (&'static str, fn(&Facts) -> bool, &'static str);

const RULES: [Rule; 16] = [
    ("chair", |f| f.named("cpu") || f.named("office"), "office_chair"),
    ("chair", |f| f.named("recliner") || f.short.max(f.long) > 0.8, "armchair"),
    ("sofa", |f| f.short > 1.5, "corner_sofa"),
    ("bed", |f| f.high < 0.24, "mattress"),
    ("bed", |f| f.short > 1.3, "double_bed"),
    ("sink", |f| f.named("kitchen"), "kitchen_sink"),
    ("kitchen_cabinet", |f| f.lift > 0.6, "kitchen_wall_cabinet"),
    ("bathroom_cabinet", |f| f.short < 0.25, "medicine_cabinet"),
    ("kitchen_counter", |f| f.high > 0.5, "kitchen_cabinet"),
    ("bathroom_counter", |f| f.high > 0.3, "bathroom_vanity"),
    ("bookshelf", |f| f.high < 1.0, "low_bookcase"),
    ("table", |f| f.high < 0.55, "coffee_table"),
    ("table", |_| true, "dining_table"),
    ("trash_can", |f| f.high < 0.38, "wastebasket"),
    ("picture", |f| f.lift > 0.3, "wall_picture_frame"),
    ("window", |_| true, "window"),
];

/// The class whose generator makes an object; its own class if there is no generator.
pub(super) fn generated_class(house: &House, id: NodeId, size: Vector3<f32>, around: &Aabb) -> Arc<str> {
    let Some(node) = house.graph.node(id) else { return "".into() };
    let (classes, generators) = (house.graph.classes(), house.generators);
    let name = node.spec().name.as_deref().unwrap_or(&node.spec().spelling);
    let facts = Facts {
        name: name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect(),
        long: size.x.max(size.y),
        short: size.x.min(size.y),
        high: size.z,
        lift: around.min.z - house.level(around),
    };
    let own = node.class();
    // A name may be more specific than the class: a kitchen chair is a chair.
    let said = classes.get(name).map(|c| &c.name).filter(|c| *c != own && classes.is_a(c, own));
    let class = said.filter(|c| generators.get(c).is_some()).unwrap_or(own);
    let rule = RULES.iter().find(|(of, holds, _)| **of == **class && holds(&facts));
    match rule {
        Some((_, _, like)) => (*like).into(),
        None if generators.get(class).is_some() => class.clone(),
        None => related(classes, generators, class, id).unwrap_or_else(|| class.clone()),
    }
}

/// A subclass that has a generator, or else the nearest superclass with one: any toy for a toy.
fn related(classes: &ClassTable, generators: &Generators, class: &str, id: NodeId) -> Option<Arc<str>> {
    let own = classes.get(class)?;
    let kinds: Vec<&str> = generators.iter().map(|g| g.class).filter(|c| classes.is_a(c, class)).collect();
    if !kinds.is_empty() {
        return Some(kinds[id.0 as usize % kinds.len()].into());
    }
    let above = generators.iter().filter_map(|g| classes.get(g.class)).filter(|c| classes.is_a(&own.name, &c.name));
    // The nearest one has the fewest subclasses.
    above.min_by_key(|c| classes.kinds_of(c).count()).map(|c| c.name.clone())
}
