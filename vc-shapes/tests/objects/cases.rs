//! The objects that are tested, and their violations.

use std::panic::catch_unwind;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::Vector3;
use vc_graph::{AssetLibrary, ClassTable, Seed};
use vc_shapes::object::{Generator, Object, generators};
use vc_shapes::{Style, material};

use crate::solid::{Solid, solids};
use crate::{faces, motion, places, whole};

/// The rules for every object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rule {
    Panic,
    Accepted,
    Same,
    Closed,
    Size,
    Base,
    Floating,
    Stable,
    Triangles,
    Faces,
    Surface,
    Affordance,
    Motion,
}

/// A violation of a rule.
pub(crate) struct Finding {
    pub(crate) rule: Rule,
    pub(crate) class: &'static str,
    pub(crate) text: String,
}

/// A generated object, and its parts as triangles.
pub(crate) struct Case {
    pub(crate) class: &'static vc_graph::Class,
    /// The size that was requested.
    pub(crate) asked: Vector3<f32>,
    pub(crate) object: Object,
    pub(crate) solids: Vec<Solid>,
}

/// The violations of all objects.
pub(crate) static FINDINGS: LazyLock<Vec<Finding>> = LazyLock::new(all);

static CLASSES: LazyLock<std::sync::Arc<ClassTable>> = LazyLock::new(ClassTable::builtin);

/// Whether a class is to be tested.
pub(crate) fn chosen(class: &str) -> bool {
    std::env::var("OBJECT_CLASSES").map_or(true, |list| list.split(',').any(|c| c == class))
}

fn all() -> Vec<Finding> {
    let generators: Vec<&'static Generator> = generators().filter(|g| chosen(g.class)).collect();
    let (next, library) = (AtomicUsize::new(0), material::library());
    let work = || {
        let mut found = Vec::new();
        while let Some(generator) = generators.get(next.fetch_add(1, Ordering::Relaxed)) {
            examine(generator, &library, &mut |rule, text| found.push(Finding { rule, class: generator.class, text }));
        }
        found
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|w| w.join().unwrap()).collect()
    })
}

/// Sizes by name and seed: usual ones of the class, half and double, out of proportion.
fn sizes(class: &vc_graph::Class) -> Vec<(String, u64, Vector3<f32>)> {
    let Some(range) = class.size else { return Vec::new() };
    let (low, high) = (Vector3::from(range.map(|r| r.low)), Vector3::from(range.map(|r| r.high)));
    let seeds = std::env::var("OBJECT_SEEDS").ok().and_then(|s| s.parse().ok()).unwrap_or(3);
    let mut sizes: Vec<_> = (0..seeds).map(|s| (format!("seed {s}"), s, usual(class, s))).collect();
    let mut more = |name: &str, seed, size| sizes.push((format!("seed {seed}, {name} size"), seed, size));
    more("least", 100, low);
    more("largest", 101, high);
    more("half", 102, (low + high) / 4.0);
    more("double", 103, low + high);
    more("long", 104, high.component_mul(&Vector3::new(0.6, 1.7, 1.0)));
    more("tall", 105, low.component_mul(&Vector3::new(1.3, 0.7, 1.6)));
    sizes
}

/// A size within the class's range.
fn usual(class: &vc_graph::Class, seed: u64) -> Vector3<f32> {
    let mut rng = Seed(seed).child("within").stream();
    class.size.map_or_else(|| Vector3::repeat(0.3), |range| range.map(|r| rng.between(r.low, r.high)).into())
}

/// Sizes that nobody should request.
const EXTREMES: [[f32; 3]; 5] =
    [[1e-3, 1e-3, 1e-3], [0.05, 0.05, 0.05], [30.0, 30.0, 30.0], [2.0, 2.0, 0.01], [0.01, 0.01, 3.0]];

/// Tests one class.
fn examine(generator: &'static Generator, library: &AssetLibrary, found: &mut dyn FnMut(Rule, String)) {
    let Some(class) = CLASSES.get(generator.class) else { return };
    for (name, seed, asked) in sizes(class) {
        let Some(object) = made(generator, asked, seed, &name, found) else { continue };
        let mut say = |rule: Rule, text: String| found(rule, format!("({name}): {text}"));
        accepted(library, &object, &mut say);
        if object.asset.parts.is_empty() {
            say(Rule::Closed, "no parts".into());
            continue;
        }
        let solids = solids(&object);
        let case = Case { class, asked, object, solids };
        whole::check(&case, &mut say);
        faces::check(&case, &mut say);
        places::check(&case, &mut say);
        motion::check(&case, &mut say);
    }
    // Generation is cheap compared with the tests, so many more objects are generated and only
    // checked for acceptance.
    let usual = (300..340).map(|seed| (usual(class, seed), seed));
    for (size, seed) in EXTREMES.map(Vector3::from).into_iter().zip(200..).chain(usual) {
        let name = format!("seed {seed}, size {:?}", size.as_slice());
        if let Some(object) = made(generator, size, seed, &name, found) {
            accepted(library, &object, &mut |rule, text| found(rule, format!("({name}): {text}")));
        }
    }
    same(generator, found);
}

fn made(
    generator: &'static Generator,
    size: Vector3<f32>,
    seed: u64,
    name: &str,
    found: &mut dyn FnMut(Rule, String),
) -> Option<Object> {
    let object = catch_unwind(|| generator.sized(size, &Style::from_seed(Seed(seed)), Seed(seed)));
    object.inspect_err(|_| found(Rule::Panic, format!("({name}): panics at size {size:?}"))).ok()
}

fn accepted(library: &AssetLibrary, object: &Object, say: &mut dyn FnMut(Rule, String)) {
    if let Err(error) = library.clone().add(object.asset.clone()) {
        say(Rule::Accepted, error.to_string());
    }
}

/// Whether the usual object is generated twice with the same bytes.
fn same(generator: &'static Generator, found: &mut dyn FnMut(Rule, String)) {
    let once = || {
        let instance = generator.instance(Seed(7), 0);
        serde_json::to_vec(&instance.object.asset).unwrap()
    };
    match catch_unwind(|| once() == once()) {
        Ok(true) => {}
        Ok(false) => found(Rule::Same, "(catalogue seed 7, instance 0): made twice it differs".into()),
        Err(_) => found(Rule::Panic, "(catalogue seed 7, instance 0): panics".into()),
    }
}

/// The smallest and largest corner of parts as they are drawn, joints at zero.
pub(crate) fn around<'a>(parts: impl IntoIterator<Item = &'a vc_graph::asset::Part>) -> [nalgebra::Point3<f32>; 2] {
    let points = parts.into_iter().flat_map(|p| p.shape.mesh(0.0005).positions.into_iter().map(|at| p.pose * at));
    let start = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]].map(nalgebra::Point3::from);
    points.fold(start, |[low, high], p| [low.inf(&p), high.sup(&p)])
}
