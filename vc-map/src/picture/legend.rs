//! Colours and their meanings.

use super::{Colour, Entry};

pub(super) const ROAD: Colour = [96, 98, 102];
pub(super) const BUS: Colour = [122, 84, 80];
pub(super) const CYCLE: Colour = [168, 84, 70];
pub(super) const PARKING: Colour = [140, 148, 170];
pub(super) const PAVEMENT: Colour = [205, 200, 190];
pub(super) const PATH: Colour = [222, 196, 150];
pub(super) const STEPS: Colour = [214, 130, 110];
pub(super) const RAIL: Colour = [70, 60, 90];
pub(super) const MARK: Colour = [245, 245, 240];
pub(super) const BUILDING: Colour = [196, 178, 164];
pub(super) const WALL: Colour = [140, 120, 105];
pub(super) const GREEN: Colour = [176, 208, 150];
pub(super) const WATER: Colour = [150, 192, 222];
pub(super) const SQUARE: Colour = [228, 222, 210];
pub(super) const LOT: Colour = [234, 228, 220];
pub(super) const BRIDGE: Colour = [30, 30, 34];
pub(super) const SIGNAL: Colour = [210, 30, 35];
pub(super) const DOOR: Colour = [120, 40, 140];
pub(super) const STOP: Colour = [0, 85, 165];
pub(super) const TUNNEL: Colour = [150, 150, 156];

pub(super) fn entries() -> Vec<Entry> {
    [
        (ROAD, "road, crossings in white"),
        (TUNNEL, "tunnel"),
        (BRIDGE, "edge of a bridge"),
        (BUS, "bus lane"),
        (CYCLE, "lane or way for bicycles"),
        (PARKING, "parking"),
        (PAVEMENT, "pavement"),
        (PATH, "path"),
        (STEPS, "steps"),
        (RAIL, "tram, rail"),
        (BUILDING, "building"),
        (GREEN, "green"),
        (WATER, "water"),
        (SQUARE, "square, car park, platform"),
        (LOT, "ground of one owner"),
        (SIGNAL, "signal"),
        (DOOR, "door"),
        (STOP, "stop"),
    ]
    .into_iter()
    .map(|(colour, meaning)| Entry { colour, meaning })
    .collect()
}
