//! Signals: phases free of conflict, time to end, a green and a red for everybody.

use super::{MapViolation, short_clearances, unsafe_phases};
use crate::{ConflictTable, Light, Signal, SignalId, StreetMap};

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let mut found = Vec::new();
    for (index, signal) in map.signals().iter().enumerate() {
        let id = SignalId::of(index);
        let Some(junction) = map.junction(signal.junction) else { continue };
        let pairs = unsafe_phases(signal, &junction.conflicts);
        found.extend(pairs.into_iter().map(|(phase, pair)| MapViolation::UnsafePhase { signal: id, phase, pair }));
        let short = short_clearances(map, signal);
        found.extend(short.into_iter().map(|(phase, crossing, seconds)| MapViolation::ShortClearance {
            signal: id,
            phase,
            crossing,
            seconds,
        }));
        found.extend(dark(signal, &junction.conflicts).map(|row| MapViolation::NeverGreen { signal: id, row }));
        if !stops(signal, junction.movements.len()) {
            found.push(MapViolation::NeverRed { signal: id });
        }
    }
    found
}

/// The movements and crossings that never get green.
fn dark(signal: &Signal, table: &ConflictTable) -> impl Iterator<Item = usize> {
    let green = |light: &Light| matches!(light, Light::Green | Light::GreenYield);
    (0..table.size()).filter(move |row| !signal.phases.iter().any(|phase| phase.lights.get(*row).is_some_and(green)))
}

/// Whether a signal stops a vehicle at any time: the first rows are those of movements.
fn stops(signal: &Signal, movements: usize) -> bool {
    signal.phases.iter().any(|phase| phase.lights.iter().take(movements).any(|light| *light == Light::Red))
}
