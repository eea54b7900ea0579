//! Panels of walls around holes.

/// A part of a wall, or a hole in it: from where to where along it, and from which height to which.
pub(crate) type Panel = [(f32, f32); 2];

/// The parts of a panel around some holes.
pub(crate) fn around([(from, to), (low, high)]: Panel, holes: &[Panel]) -> Vec<Panel> {
    let mut holes: Vec<Panel> = holes.iter().filter(|[(a, b), _]| *b > from && *a < to).copied().collect();
    holes.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
    let (mut found, mut at) = (Vec::new(), from);
    for [(a, b), (sill, head)] in holes {
        let (a, b) = (a.max(at), b.min(to));
        found.extend([[(at, a), (low, high)], [(a, b), (low, sill)], [(a, b), (head, high)]]);
        at = b.max(at);
    }
    found.push([(at, to), (low, high)]);
    found.retain(|panel| panel.iter().all(|(from, to)| to - from > 1e-3));
    found
}
