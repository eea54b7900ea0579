//! The lights of signals with fixed times, as functions of the time.

use vc_map::{Light, Signal};

/// The phase at a time in seconds, and for how long it lasts from then on.
pub(crate) fn phase(signal: &Signal, seconds: f64) -> (usize, f64) {
    let mut left = seconds.rem_euclid(signal.cycle().max(1e-3));
    for (number, of) in signal.phases.iter().enumerate() {
        if left < of.seconds {
            return (number, of.seconds - left);
        }
        left -= of.seconds;
    }
    (signal.phases.len().saturating_sub(1), 0.0)
}

/// The light of a row of its junction in a phase.
pub(crate) fn light(signal: &Signal, phase: usize, row: usize) -> Option<Light> {
    signal.phases.get(phase)?.lights.get(row).copied()
}

fn is_green(signal: &Signal, phase: usize, row: usize) -> bool {
    matches!(light(signal, phase, row), Some(Light::Green | Light::GreenYield))
}

/// For how long a row is still not green at a time, seconds: 0 if it is. `None` if it never is.
pub(crate) fn wait(signal: &Signal, row: usize, seconds: f64) -> Option<f64> {
    let (first, left) = phase(signal, seconds);
    let count = signal.phases.len();
    let mut waits = 0.0;
    for number in 0..count {
        let phase = (first + number) % count;
        if is_green(signal, phase, row) {
            return Some(waits);
        }
        waits += if number == 0 { left } else { signal.phases[phase].seconds };
    }
    None
}

/// For how long a row has been green at a time, seconds; `None` if it is not.
pub(crate) fn since(signal: &Signal, row: usize, seconds: f64) -> Option<f64> {
    let (first, left) = phase(signal, seconds);
    let count = signal.phases.len();
    if !is_green(signal, first, row) {
        return None;
    }
    let mut green = signal.phases[first].seconds - left;
    for number in 1..count {
        let phase = (first + count - number) % count;
        if !is_green(signal, phase, row) {
            break;
        }
        green += signal.phases[phase].seconds;
    }
    Some(green)
}
