//! Objects that rest on each other in a cycle.

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::Relation;

/// Whether a relation means that its first object rests on or in the second.
pub(super) fn rests(relation: Relation) -> bool {
    matches!(relation, Relation::On | Relation::Inside)
}

/// The index of the first pair in a cycle, among pairs of an object and another that it rests on; `None` if
/// there is no cycle. An object on itself does not count.
pub(super) fn first_in_cycle<T: Ord + Copy>(pairs: &[(T, T)]) -> Option<usize> {
    let grounded = grounded(pairs);
    let floats = |i: &usize| pairs[*i].0 != pairs[*i].1 && !grounded.contains(&pairs[*i].1);
    // In reverse order, so that of several pairs of an object the first one stays in the map.
    let next: BTreeMap<T, usize> = (0..pairs.len()).rev().filter(floats).map(|i| (pairs[i].0, i)).collect();
    let mut met = BTreeSet::new();
    let mut here = *next.values().min()?;
    while met.insert(here) {
        here = *next.get(&pairs[here].1)?;
    }
    let around = |&i: &usize| next.get(&pairs[i].1).copied().filter(|&i| i != here);
    std::iter::successors(Some(here), around).min()
}

/// The objects from which every chain of supports ends at one that rests on nothing.
fn grounded<T: Ord + Copy>(pairs: &[(T, T)]) -> BTreeSet<T> {
    let (mut ways, mut above): (BTreeMap<T, usize>, BTreeMap<T, Vec<T>>) = Default::default();
    for &(thing, at) in pairs.iter().filter(|(thing, at)| thing != at) {
        *ways.entry(thing).or_default() += 1;
        ways.entry(at).or_default();
        above.entry(at).or_default().push(thing);
    }
    let mut open: Vec<T> = ways.iter().filter(|(_, ways)| **ways == 0).map(|(thing, _)| *thing).collect();
    let mut grounded = BTreeSet::new();
    while let Some(at) = open.pop() {
        grounded.insert(at);
        for thing in above.get(&at).into_iter().flatten() {
            let left = ways.entry(*thing).and_modify(|ways| *ways -= 1).or_default();
            if *left == 0 {
                open.push(*thing);
            }
        }
    }
    grounded
}
