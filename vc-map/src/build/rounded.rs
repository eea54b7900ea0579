//! Numbers of a description, rounded so that what is written is read back as the same map.

use crate::MapDraft;

/// Parts of a metre that are kept.
const FINE: f64 = 1e4;
/// Parts of a degree that are kept.
const DEGREES: f64 = 1e7;

fn round(value: &mut f64) {
    *value = (*value * FINE).round() / FINE;
}

fn ring(points: &mut [[f64; 2]]) {
    points.iter_mut().flatten().for_each(round);
}

/// Rounds lengths and speeds to a tenth of a millimetre, the origin to a centimetre.
pub(super) fn rounded(draft: &mut MapDraft) {
    for degrees in [&mut draft.origin.latitude, &mut draft.origin.longitude] {
        *degrees = (*degrees * DEGREES).round() / DEGREES;
    }
    draft.junctions.iter_mut().flat_map(|junction| &mut junction.at).for_each(round);
    for road in &mut draft.roads {
        ring(&mut road.line);
        road.line.shrink_to_fit();
        round(&mut road.section.median);
        for strip in road.section.forward.iter_mut().chain(&mut road.section.backward) {
            [&mut strip.width, &mut strip.limit].into_iter().for_each(round);
        }
    }
    for building in &mut draft.buildings {
        ring(&mut building.outline);
        building.courts.iter_mut().for_each(|court| ring(court));
        [&mut building.height, &mut building.base].into_iter().for_each(round);
    }
    for area in &mut draft.areas {
        ring(&mut area.outline);
        area.holes.iter_mut().for_each(|hole| ring(hole));
    }
    draft.entrances.iter_mut().flat_map(|entrance| &mut entrance.at).for_each(round);
    draft.stops.iter_mut().flat_map(|stop| &mut stop.at).for_each(round);
}
