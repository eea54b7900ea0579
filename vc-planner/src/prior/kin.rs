//! Where things akin to another are kept, by the class table.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use vc_graph::{Class, ClassTable, Relation};

/// On or in things of a class; on the floor, if none.
type At = Option<(Relation, Arc<str>)>;

/// For each group of classes, in what parts its things are kept where; a group's parts sum to one.
#[derive(Debug, Default)]
pub(crate) struct Kin(BTreeMap<Arc<str>, BTreeMap<At, f64>>);

/// How much less a group counts than the one within it: cakes tell more of where a cake is than
/// food does.
const WIDER: f64 = 0.5;

impl Kin {
    /// The kin of a class table; that of the built-in one is made once.
    pub(crate) fn of(classes: &Arc<ClassTable>) -> Arc<Self> {
        static BUILTIN: LazyLock<Arc<Kin>> = LazyLock::new(|| Arc::new(Kin::read(&ClassTable::builtin())));
        if Arc::ptr_eq(classes, &ClassTable::builtin()) { BUILTIN.clone() } else { Arc::new(Self::read(classes)) }
    }

    fn read(classes: &ClassTable) -> Self {
        let (mut kin, mut members) = (Self::default(), BTreeMap::<Arc<str>, f64>::new());
        for class in classes.iter().filter(|c| !c.kept.is_empty()) {
            let all: f64 = class.kept.iter().map(|k| f64::from(k.weight)).sum();
            for (group, _) in groups(classes, class) {
                *members.entry(group.clone()).or_default() += 1.0;
                let parts = kin.0.entry(group).or_default();
                for habit in &class.kept {
                    let known = |at: &Arc<str>| classes.get(at).map_or_else(|| at.clone(), |c| c.name.clone());
                    let at = habit.at.as_ref().map(|(relation, at)| (*relation, known(at)));
                    *parts.entry(at).or_default() += f64::from(habit.weight) / all;
                }
            }
        }
        for (group, parts) in &mut kin.0 {
            parts.values_mut().for_each(|part| *part /= members[group]);
        }
        kin
    }

    /// Which part of the things akin to one is kept at a kind of place, narrower kin first.
    pub(crate) fn part(&self, classes: &ClassTable, thing: &Class, relation: Relation, at: Option<&Class>) -> f64 {
        let around: Vec<At> = match at {
            Some(at) => lineage(classes, at).into_iter().map(|(name, _)| Some((relation, name))).collect(),
            None => vec![None],
        };
        let (mut part, mut all) = (0.0, 0.0);
        for (group, far) in groups(classes, thing) {
            let weight = WIDER.powi(far);
            let parts = self.0.get(&group);
            part += weight * parts.map_or(0.0, |parts| around.iter().filter_map(|at| parts.get(at)).sum());
            all += weight;
        }
        part / f64::max(all, f64::MIN_POSITIVE)
    }
}

/// A class and what it is a kind of, each with how far up.
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

/// The groups a class is in, and last all things of its sort.
fn groups(classes: &ClassTable, class: &Class) -> Vec<(Arc<str>, i32)> {
    let mut found = lineage(classes, class);
    let farthest = found.iter().map(|(_, far)| *far).max().unwrap_or(0);
    // No class is called so.
    found.push((format!("all {}", class.category).into(), farthest + 1));
    found
}
