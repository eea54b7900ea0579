//! Generators that a program registers.

use vc_graph::{ClassTable, Seed};
use vc_shapes::material::BRASS;
use vc_shapes::{Build, Generator, Generators, Realm, RegisterError, Style};

const ROWS: &str = "samovar | appliance | | appliance | graspable | 0.2 0.25-0.3 0.4 | 3 | | | kitchen:1\n\
                    idea | | | prop | | | | | |";

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
