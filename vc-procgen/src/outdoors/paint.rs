//! Markings on carriageways.

use vc_map::Marking;
use vc_shapes::material::WHITE;

use super::strip::{dashes, strip};
use super::{KERB, Outdoors, Place};
use crate::circulation::parts::built;
use crate::item::Item;

/// How far markings lie above the asphalt, metres: more than depths of pictures err at 100 m.
const ABOVE: f32 = 0.008;

/// Markings within the reach of a place, each a thing of its own.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place) -> Vec<Item> {
    let near = outdoors.painted.around(&place.at, place.reach).into_iter().map(|number| &outdoors.markings[number]);
    near.map(|Marking { points, width, dashes: lengths, .. }| {
        built("road_marking", [0.0; 3], &outdoors.style, |b| {
            let lines = lengths.map_or_else(|| vec![points.clone()], |lengths| dashes(points, lengths));
            lines.iter().for_each(|line| strip(b, place, line, (*width, ABOVE - KERB), "marking", WHITE));
        })
    })
    .collect()
}
