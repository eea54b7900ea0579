//! Generators that a program registers.

use vc_graph::asset::Shape;
use vc_graph::{ClassTable, ObjectRole, Seed};
use vc_shapes::material::BRASS;
use vc_shapes::object::settled;
use vc_shapes::{Build, Generator, Generators, Object, Realm, RegisterError, Style};

const ROWS: &str = "samovar | appliance | | appliance | graspable | 0.2 0.25-0.3 0.4 | 3 | | | kitchen:1\n\
                    idea | | | prop | | | | | |\n\
                    pelmet | curtain | | decor | | 0.1 0.8-2.0 0.3 | 1 | | | living_room:1 | flat\n\
                    staff | sports_gear | | sport | surface | 0.9 0.1 0.9 | 1 | | | garage:1\n\
                    icon | decoration | | decor | graspable | 0.02 0.2 0.3 | 1 | | | living_room:1";

fn samovar(b: &mut Build<'_>) {
    let (radius, height) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    b.cylinder("urn", [0.0; 3], radius, height, BRASS);
}

fn of(class: &'static str) -> Generator {
    Generator::new(class, Realm::Indoor, 1, samovar)
}

#[test]
fn a_class_of_ones_own_is_generated_in_the_size_of_its_row() {
    let classes = ClassTable::builtin().extended("mine.txt", ROWS).unwrap();
    let mut generators = Generators::default();
    let before = generators.iter().count();
    generators.register(&classes, of("samovar")).unwrap();
    assert_eq!(generators.iter().count(), before + 1);
    for seed in (0..20).map(Seed) {
        let made = generators.get("samovar").unwrap().object(&Style::from_seed(seed), seed);
        assert_eq!(made.class, "samovar");
        assert!((made.size().z - 0.4).abs() < 1e-5 && (made.size().y - 0.2).abs() < 1e-5, "{:?}", made.size());
    }
    assert!(generators.get("chair").is_some());
}

/// Two costly parts, which a simple shape can stand for.
fn beads(b: &mut Build<'_>) {
    let (x, y, z) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    for side in [-1.0, 1.0] {
        b.hull("bead", &[[-x, 0.0, 0.0], [x, 0.0, 0.0], [0.0, side * y, 0.0], [0.0, side * y, z]], BRASS);
    }
}

#[test]
fn the_row_of_a_class_decides_role_and_collision_shape() {
    let classes = ClassTable::builtin().extended("mine.txt", ROWS).unwrap();
    let mut generators = Generators::default();
    let made = |class, generators: &mut Generators| {
        generators.register(&classes, Generator::new(class, Realm::Indoor, 1, beads)).unwrap();
        generators.get(class).unwrap().object(&Style::from_seed(Seed(1)), Seed(1))
    };
    let [cover, icon] = ["pelmet", "icon"].map(|class| made(class, &mut generators));
    assert_eq!((cover.role, icon.role), (ObjectRole::Cover, ObjectRole::Loose));
    // A cover that is flat on a wall collides as a box, a thing that is carried as a hull.
    let shapes = |object: &Object| object.asset.collision.iter().map(|part| part.shape.clone()).collect::<Vec<_>>();
    assert!(matches!(shapes(&cover)[..], [Shape::Box { .. }]), "{:?}", shapes(&cover));
    assert!(matches!(shapes(&icon)[..], [Shape::Hull { .. }]), "{:?}", shapes(&icon));
}

/// A rod that leans and falls, so that it is generated again in another size: with a seam, and coarser to the touch.
fn leaning(b: &mut Build<'_>) {
    let (from, to) = ([0.0; 3], [b.size.x / 2.0, 0.0, b.size.z]);
    b.visual_only(|b| b.rod("rod", from, to, 0.01, BRASS));
    b.visual_only(|b| b.rod("seam", from, to, 0.011, BRASS));
    b.collision_only(|b| b.bar("felt", from, to, 0.01, BRASS));
}

#[test]
fn collision_shapes_settle_with_the_parts() {
    let classes = ClassTable::builtin().extended("mine.txt", ROWS).unwrap();
    let mut generators = Generators::default();
    generators.register(&classes, Generator::new("staff", Realm::Indoor, 1, |b| settled(b, leaning))).unwrap();
    let staff = generators.get("staff").unwrap().object(&Style::from_seed(Seed(1)), Seed(1));
    assert!(staff.size().z < 0.1, "it lies: {:?}", staff.size());
    assert_eq!((staff.asset.parts.len(), staff.asset.collision.len()), (2, 1));
    let (low, high) = staff.asset.collision[0].extent();
    assert!((high - low).z < 0.1 && low.z > -0.01, "{low} {high}");
}

#[test]
fn the_catalogue_has_the_instances_of_registered_classes() {
    let classes = ClassTable::builtin().extended("mine.txt", ROWS).unwrap();
    let mut generators = Generators::default();
    generators.register(&classes, Generator::new("samovar", Realm::Indoor, 3, samovar)).unwrap();
    let mut all = generators.instances(Seed(1)).filter(|instance| instance.generator.class == "samovar");
    assert_eq!(all.by_ref().map(|instance| instance.index).collect::<Vec<_>>(), [0, 1, 2]);
    assert!(generators.instances(Seed(1)).next().is_some_and(|first| first.generator.class != "samovar"));
}

#[test]
fn classes_with_a_generator_and_classes_without_a_row_are_refused() {
    let builtin = ClassTable::builtin();
    let classes = builtin.extended("mine.txt", ROWS).unwrap();
    let mut generators = Generators::default();
    assert_eq!(generators.register(&builtin, of("samovar")), Err(RegisterError::UnknownClass("samovar")));
    assert_eq!(generators.register(&classes, of("chair")), Err(RegisterError::Duplicate("chair")));
    // An alias is not the name of a class.
    assert_eq!(generators.register(&classes, of("dinner_plate")), Err(RegisterError::UnknownClass("dinner_plate")));
    assert_eq!(generators.register(&classes, of("idea")), Err(RegisterError::NoSize("idea")));
    generators.register(&classes, of("samovar")).unwrap();
    let again = generators.register(&classes, of("samovar"));
    assert_eq!(again, Err(RegisterError::Duplicate("samovar")));
    assert!(again.unwrap_err().to_string().contains("`samovar` has a generator already"));
}
