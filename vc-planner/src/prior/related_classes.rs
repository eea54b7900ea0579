//! Habitual places of related classes, by the class table.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use vc_graph::portable::Portable;
use vc_graph::{Class, ClassTable, Relation};

/// On or in things of a class; `None` means on the floor.
type At = Option<(Relation, Arc<str>)>;

/// For each group of classes, the fraction of its things that is kept at each place; the fractions of a group
/// sum to one.
#[derive(Debug, Default)]
pub(crate) struct RelatedClasses(BTreeMap<Arc<str>, BTreeMap<At, f64>>);

/// The weight of a group relative to the next narrower one: cakes tell more about the place of a cake than food
/// does.
const WIDER: f64 = 0.5;

impl RelatedClasses {
    /// The table for a class table; that of the built-in one is computed once.
    pub(crate) fn new(classes: &Arc<ClassTable>) -> Arc<Self> {
        static BUILTIN: LazyLock<Arc<RelatedClasses>> =
            LazyLock::new(|| Arc::new(RelatedClasses::read(&ClassTable::builtin())));
        if Arc::ptr_eq(classes, &ClassTable::builtin()) { BUILTIN.clone() } else { Arc::new(Self::read(classes)) }
    }

    fn read(classes: &ClassTable) -> Self {
        let (mut related, mut members) = (Self::default(), BTreeMap::<Arc<str>, f64>::new());
        for class in classes.iter().filter(|c| !c.kept.is_empty()) {
            let all: f64 = class.kept.iter().map(|k| f64::from(k.weight)).sum();
            for (group, _) in groups(classes, class) {
                *members.entry(group.clone()).or_default() += 1.0;
                let parts = related.0.entry(group).or_default();
                for habit in &class.kept {
                    let known = |at: &Arc<str>| classes.get(at).map_or_else(|| at.clone(), |c| c.name.clone());
                    let at = habit.at.as_ref().map(|(relation, at)| (*relation, known(at)));
                    *parts.entry(at).or_default() += f64::from(habit.weight) / all;
                }
            }
        }
        for (group, parts) in &mut related.0 {
            parts.values_mut().for_each(|part| *part /= members[group]);
        }
        related
    }

    /// The fraction of a thing's relatives that is kept at a kind of place, with a higher weight for closer
    /// relatives.
    pub(crate) fn part(&self, classes: &ClassTable, thing: &Class, relation: Relation, at: Option<&Class>) -> f64 {
        let around: Vec<At> = match at {
            Some(at) => lineage(classes, at).into_iter().map(|(name, _)| Some((relation, name))).collect(),
            None => vec![None],
        };
        let (mut part, mut all) = (0.0, 0.0);
        for (group, far) in groups(classes, thing) {
            let weight = WIDER.raised(far);
            let parts = self.0.get(&group);
            part += weight * parts.map_or(0.0, |parts| around.iter().filter_map(|at| parts.get(at)).sum());
            all += weight;
        }
        part / f64::max(all, f64::MIN_POSITIVE)
    }
}

/// A class and its ancestors, each with its distance.
fn lineage(classes: &ClassTable, class: &Class) -> Vec<(Arc<str>, i32)> {
    let mut found = vec![(class.name.clone(), 0)];
    let mut next = 0;
    while let Some((name, far)) = found.get(next).cloned() {
        let parents = classes.get(&name).map_or(&[][..], |c| &c.parents);
        for parent in parents.iter().filter_map(|p| classes.get(p)) {
            if !found.iter().any(|(known, _)| *known == parent.name) {
                found.push((parent.name.clone(), far + 1));
            }
        }
        next += 1;
    }
    found
}

/// The groups of a class, the last being all things of its category.
fn groups(classes: &ClassTable, class: &Class) -> Vec<(Arc<str>, i32)> {
    let mut found = lineage(classes, class);
    let farthest = found.iter().map(|(_, far)| *far).max().unwrap_or(0);
    // No class has such a name.
    found.push((format!("all {}", class.category).into(), farthest + 1));
    found
}
