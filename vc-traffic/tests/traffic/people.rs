//! Checks on people for tests.

use std::collections::BTreeMap;

/// Two bodies, discs of 0.2 m, that overlap by more than a centimetre.
pub(crate) fn overlap(people: impl Iterator<Item = [f32; 2]>) -> Option<([f32; 2], [f32; 2])> {
    let mut cells: BTreeMap<[i32; 2], Vec<[f32; 2]>> = BTreeMap::new();
    for at in people {
        let [x, y] = at.map(|metres| metres.floor() as i32);
        for other in
            (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y])).filter_map(|cell| cells.get(&cell))
        {
            let near = |other: &&[f32; 2]| (at[0] - other[0]).powi(2) + (at[1] - other[1]).powi(2) < 0.39 * 0.39;
            if let Some(other) = other.iter().find(near) {
                return Some((at, *other));
            }
        }
        cells.entry([x, y]).or_default().push(at);
    }
    None
}
