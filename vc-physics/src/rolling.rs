//! Rolling resistance: a table by class.

use std::sync::LazyLock;

use vc_graph::ClassTable;

/// The row for classes that are not listed and have no listed ancestor.
const OTHERWISE: &str = "otherwise";

/// Classes, and their rolling resistance as a fraction of the weight.
static TABLE: LazyLock<Vec<(&str, f32)>> = LazyLock::new(|| {
    let lines = include_str!("../data/rolling.txt").lines().filter(|line| !line.starts_with('#'));
    let row = |line: &'static str| {
        let mut cells = line.split('|').map(str::trim);
        Some((cells.next()?, cells.next()?.parse().ok()?))
    };
    lines.filter_map(row).collect()
});

/// The rolling resistance of a thing of a class, as a fraction of its weight: that of the class, or of its
/// nearest ancestor that has one.
pub(crate) fn resistance(classes: &ClassTable, class: &str) -> f32 {
    let of = |name: &str| TABLE.iter().find(|(class, _)| *class == name).map(|(_, part)| *part);
    let (mut names, mut next) = (vec![class], 0);
    while let Some(&name) = names.get(next) {
        if let Some(known) = of(name) {
            return known;
        }
        let parents = classes.get(name).into_iter().flat_map(|class| &class.parents);
        parents.for_each(|parent| {
            if !names.contains(&&**parent) {
                names.push(parent)
            }
        });
        next += 1;
    }
    of(OTHERWISE).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_of_balls_roll_as_balls() {
        let table = ClassTable::builtin();
        let of = |class| resistance(&table, class);
        assert_eq!((of("football"), of("tennis_ball"), of("mug"), of("no_such_class")), (0.02, 0.03, 0.03, 0.03));
        assert!(TABLE.iter().all(|(class, part)| (*class == OTHERWISE || table.get(class).is_some()) && *part > 0.0));
    }
}
