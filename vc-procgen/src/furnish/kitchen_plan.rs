//! Layouts of fitted kitchens: where along the walls of a room the fridge, the sink, the hob and cabinets may stand.
//!
//! A run is a chain of one to three stretches of wall that meet in corners. The fridge is at its beginning; sink and hob
//! are tried at many places, and cabinets made to measure fill the rest, so that the run has no gap.

use super::Furnisher;
use super::kitchen_walls::{Leg, chains, shortened, stretches};
use super::space::{OFF_WALL, Solid};
use crate::area::{Area, Facing};

/// The depth of units, metres.
pub(super) const DEPTH: f32 = 0.6;
/// The free depth in front of units, metres.
pub(super) const FRONT: f32 = 0.9;
/// The height of units, metres.
pub(super) const TOP: f32 = 0.9;
/// The rasters of free stretches and of the places of sink and hob along a wall, metres.
pub(super) const STEP: f32 = 0.05;
const PLACES: f32 = 0.1;
/// The places of sink and hob of a run that are looked at closely, the best first, and those that are kept.
const LOOKED_AT: usize = 12;
const KEPT: usize = 1;
/// The lengths to which runs are shortened where longer ones are in the way, metres.
const SHORTER: [f32; 2] = [3.6, 2.8];
/// How much worse a kitchen is whose fridge stands apart.
const APART: f32 = 0.7;
/// The width of the narrowest cabinet, which is the least worktop beside a hob, and the usual one, metres.
const NARROW: f32 = 0.3;
const USUAL: f32 = 0.6;
/// The least width of a corner unit: what is behind the next run, a strip, a door of 40 cm; and the width from which it
/// has another cabinet beside it, metres.
pub(super) const CORNER: f32 = 1.05;
const CORNER_AND_MORE: f32 = 1.35;
/// The length of runs by the area of the room, metres per square metre, and its range in metres.
const RUN_SHARE: f32 = 0.5;
const RUN: (f32, f32) = (2.6, 6.0);

/// A piece of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece {
    Fridge,
    Sink,
    Cooker,
    Dishwasher,
    Cabinet,
    Drawers,
}

/// A piece of a run at its place.
#[derive(Debug, Clone)]
pub(super) struct Base {
    pub(super) piece: Piece,
    pub(super) side: usize,
    pub(super) facing: Facing,
    /// Its ends along the wall.
    pub(super) from: f32,
    pub(super) to: f32,
    pub(super) area: Area,
    /// The floor before it that stays free.
    pub(super) zone: Area,
    /// Whether its right and left end, as it faces, are behind the next run.
    pub(super) behind: [bool; 2],
    /// Whether they touch the front of the run before.
    pub(super) before: [bool; 2],
    /// Whether they are seen.
    pub(super) ends: [bool; 2],
}

impl Base {
    pub(super) fn middle(&self) -> f32 {
        f32::midpoint(self.from, self.to)
    }

    /// Its ends along the wall, moved outwards at its right and left end.
    pub(super) fn widened(&self, [right, left]: [f32; 2]) -> (f32, f32) {
        if left_is_up(self.facing) { (self.from - right, self.to + left) } else { (self.from - left, self.to + right) }
    }
}

/// The pieces of a kitchen, none in the way of another.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    pub(super) bases: Vec<Base>,
    score: f32,
}

impl Layout {
    /// Whether a fridge that needs free floor before it may stand on an area beside the run.
    pub(super) fn leaves(&self, area: &Area, zone: &Area) -> bool {
        self.bases.iter().all(|base| {
            let clear = !base.area.overlaps(area) && !base.area.overlaps(zone);
            clear && !base.zone.overlaps(area)
        })
    }

    pub(super) fn has_fridge(&self) -> bool {
        self.bases.iter().any(|base| base.piece == Piece::Fridge)
    }
}

/// Whether the left of one who faces away from a wall is up along it.
fn left_is_up(facing: Facing) -> bool {
    matches!(facing.0 % 4, 0 | 3)
}

/// The layouts that a room has space for, the best first; the fridge has a size. In some the fridge is not in the run.
pub(super) fn layouts(s: &mut Furnisher<'_>, fridge: [f32; 3]) -> Vec<Layout> {
    let longest = (s.space.square_metres * RUN_SHARE).clamp(RUN.0, RUN.1);
    let washes = s.rng.chance(0.75);
    let free = stretches(s);
    let mut found = Vec::new();
    for chain in chains(s, &free) {
        let bonus = s.rng.between(0.0, 0.8);
        for legs in std::iter::once(longest).chain(SHORTER).flat_map(|longest| shortened(&chain, longest)) {
            for (fridge, less) in [(Some(fridge), 0.0), (None, APART)] {
                let laid = filled(s, &legs, fridge, washes);
                found.extend(laid.into_iter().map(|laid| Layout { score: laid.score + bonus - less, ..laid }));
            }
        }
    }
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    found
}

/// A fixed piece on a leg: from one distance to another.
#[derive(Debug, Clone, Copy)]
struct Fixed {
    piece: Piece,
    leg: usize,
    from: f32,
    to: f32,
    /// Whether it is under a window.
    window: bool,
}

/// The layouts of a chain, with sink and hob wherever they may be, and with the fridge at its beginning if there is one.
fn filled(s: &Furnisher<'_>, legs: &[Leg], fridge: Option<[f32; 3]>, washes: bool) -> Vec<Layout> {
    let cold = fridge.map(|size| Fixed { piece: Piece::Fridge, leg: 0, from: 0.0, to: size[1], window: false });
    let begun = cold.map_or(0.0, |fridge| fridge.to);
    let sinks = [0.8, 0.6].map(|wide| places(s, legs, begun, Piece::Sink, wide));
    let mut cookers = places(s, legs, begun, Piece::Cooker, USUAL);
    cookers.retain(|cooker| !cooker.window && (cooker.leg > 0 || cooker.from > begun));
    let mut found = Vec::new();
    for sink in sinks.into_iter().flatten() {
        let rate = |cooker: &Fixed| Some((rated(&sink, cooker)? + 0.1 * (sink.to - sink.from), (sink, *cooker)));
        found.extend(cookers.iter().filter_map(rate));
    }
    let length: f32 = legs.iter().map(Leg::length).sum();
    let laid = best(found, LOOKED_AT).into_iter().filter_map(|(score, (sink, cooker))| {
        let fixed: Vec<Fixed> = cold.into_iter().chain([sink, cooker]).collect();
        let mut bases = bases(s, legs, &fixed)?;
        let machines = bases.iter_mut().filter(|base| base.piece == Piece::Dishwasher);
        machines.skip(usize::from(washes)).for_each(|spare| spare.piece = Piece::Cabinet);
        let score = score + length.min(4.5) * 0.6;
        let high = fridge.map_or(TOP, |size| size[2]);
        are_free(s, &bases, high).then_some(Layout { bases, score })
    });
    laid.take(KEPT).collect()
}

/// The best of some things with scores, in order; of equal ones the first. Sorting thousands for a few takes long.
fn best<T>(things: Vec<(f32, T)>, count: usize) -> Vec<(f32, T)> {
    let mut rated: Vec<(usize, (f32, T))> = things.into_iter().enumerate().collect();
    let better = |a: &(usize, (f32, T)), b: &(usize, (f32, T))| b.1.0.total_cmp(&a.1.0).then(a.0.cmp(&b.0));
    if rated.len() > count {
        rated.select_nth_unstable_by(count, better);
        rated.truncate(count);
    }
    rated.sort_unstable_by(better);
    rated.into_iter().map(|(_, thing)| thing).collect()
}

/// The places of a piece along a chain that leave space for a cabinet before and after it.
fn places(s: &Furnisher<'_>, legs: &[Leg], begun: f32, piece: Piece, width: f32) -> Vec<Fixed> {
    let mut all = Vec::new();
    for (index, leg) in legs.iter().enumerate() {
        let mut from = if index == 0 { begun } else { NARROW + STEP };
        let after = if leg.corner[1] { CORNER } else { NARROW };
        while from + width + after <= leg.length() + 1e-3 {
            let (low, high) = leg.between(from, from + width);
            let window = s.space.sides[leg.side].sill(low, high).is_some();
            all.push(Fixed { piece, leg: index, from, to: from + width, window });
            // Before the first place there is nothing, or a cabinet.
            from = if index == 0 && from < begun + NARROW { begun + NARROW } else { from + PLACES };
        }
    }
    all
}

/// How good the places of sink and hob are; `None` if they are too near each other.
fn rated(sink: &Fixed, cooker: &Fixed) -> Option<f32> {
    let apart = match sink.leg == cooker.leg {
        true => (cooker.from - sink.to).max(sink.from - cooker.to),
        false => 1.0,
    };
    if apart < NARROW - 1e-3 {
        return None;
    }
    let view = if sink.window { 0.8 } else { 0.0 };
    // Sixty to ninety centimetres between sink and hob are best.
    let distance = 0.5 - (apart - 0.8).abs().min(1.0) * 0.5;
    let first = if sink.leg <= cooker.leg && sink.from <= cooker.from { 0.2 } else { 0.0 };
    Some(view + distance + first)
}

/// All pieces of a chain: the fixed ones, and cabinets between them; `None` if a gap cannot be filled.
fn bases(s: &Furnisher<'_>, legs: &[Leg], fixed: &[Fixed]) -> Option<Vec<Base>> {
    let mut all = Vec::new();
    for (index, leg) in legs.iter().enumerate() {
        let mut here: Vec<Fixed> = fixed.iter().filter(|f| f.leg == index).copied().collect();
        here.sort_by(|a, b| a.from.total_cmp(&b.from));
        let mut pieces = Vec::new();
        let (mut at, mut before) = (0.0, None);
        for f in &here {
            pieces.extend(between(index, (at, f.from), (before, Some(f.piece)), leg.corner[0] && at == 0.0, false)?);
            pieces.push(*f);
            (at, before) = (f.to, Some(f.piece));
        }
        let first = leg.corner[0] && at == 0.0;
        pieces.extend(between(index, (at, leg.length()), (before, None), first, leg.corner[1])?);
        let last = pieces.len() - 1;
        let is_run = |p: &Fixed| p.piece != Piece::Fridge;
        for (i, piece) in pieces.iter().enumerate() {
            let touches = [i == 0 && leg.corner[0], i == last && leg.corner[1]];
            let seen = [i == 0 && !leg.corner[0] && !leg.walled[0], i == last && !leg.corner[1] && !leg.walled[1]];
            // Beside the fridge, which is taller, nothing is seen.
            all.push(base(s, leg, piece, touches, seen.map(|seen| seen && is_run(piece))));
        }
    }
    Some(all)
}

/// Cabinets that fill the space between two distances on a leg, a dishwasher beside the sink if there is space.
fn between(
    leg: usize,
    (from, to): (f32, f32),
    beside: (Option<Piece>, Option<Piece>),
    first: bool,
    corner: bool,
) -> Option<Vec<Fixed>> {
    let gap = to - from;
    let cabinet = |piece, from, to| Fixed { piece, leg, from, to, window: false };
    let mut pieces = Vec::new();
    if gap < 1e-3 {
        return (!first && !corner).then_some(pieces);
    }
    let (mut low, mut high) = (from, to);
    if corner {
        if gap < CORNER - 1e-3 {
            return None;
        }
        low = if gap < CORNER_AND_MORE { from } else { to - CORNER };
        pieces.push(cabinet(Piece::Cabinet, low, to));
        (low, high) = (from, low);
    }
    let spare = |low: f32, high: f32| high - low - USUAL >= NARROW - 1e-3 || (high - low - USUAL).abs() < 1e-3;
    let least = if first { NARROW + STEP } else { 0.0 };
    if beside.0 == Some(Piece::Sink)
        && spare(low, high)
        && !(beside.1 == Some(Piece::Cooker) && high - low < 0.9 - 1e-3)
    {
        pieces.push(cabinet(Piece::Dishwasher, low, low + USUAL));
        low += USUAL;
    } else if beside.1 == Some(Piece::Sink) && spare(low, high) && high - low - USUAL >= least - 1e-3 {
        pieces.push(cabinet(Piece::Dishwasher, high - USUAL, high));
        high -= USUAL;
    }
    let gap = high - low;
    if gap > 1e-3 {
        if gap < NARROW - 1e-3 {
            return None;
        }
        let count = (gap / USUAL).round().max(1.0);
        for i in 0..count as usize {
            let (a, b) = (low + gap * i as f32 / count, low + gap * (i as f32 + 1.0) / count);
            // Drawers beside the hob.
            let hob = (i == 0 && beside.0 == Some(Piece::Cooker) && low == from)
                || (i + 1 == count as usize && beside.1 == Some(Piece::Cooker) && high == to);
            let piece = if hob { Piece::Drawers } else { Piece::Cabinet };
            pieces.push(cabinet(piece, a, b));
        }
    }
    pieces.sort_by(|a, b| a.from.total_cmp(&b.from));
    Some(pieces)
}

/// A piece at its place, by whether its beginning and end touch a corner or are seen.
fn base(s: &Furnisher<'_>, leg: &Leg, piece: &Fixed, touches: [bool; 2], seen: [bool; 2]) -> Base {
    let wall = &s.space.sides[leg.side];
    let facing = wall.facing;
    let (from, to) = leg.between(piece.from, piece.to);
    let area = facing.area(wall.point(f32::midpoint(from, to), OFF_WALL), DEPTH, to - from);
    // Beginning and end as right and left.
    let begins_left = left_is_up(facing) != (leg.end > leg.start);
    let sided = |pair: [bool; 2]| if begins_left { [pair[1], pair[0]] } else { pair };
    let (behind, before) = (sided([false, touches[1]]), sided([touches[0], false]));
    let reach = DEPTH + STEP;
    let narrow = |end: usize| if behind[end] { -reach } else { 0.0 };
    let zone = facing.before(&facing.widened(&area, narrow(1), narrow(0)), FRONT);
    Base { piece: piece.piece, side: leg.side, facing, from, to, area, zone, behind, before, ends: sided(seen) }
}

/// Whether all pieces have their space and none is in the way of another.
fn are_free(s: &Furnisher<'_>, bases: &[Base], fridge: f32) -> bool {
    let shrunk = |area: &Area| area.grown(-2e-3);
    bases.iter().all(|base| {
        let wall = &s.space.sides[base.side];
        let tall = base.piece == Piece::Fridge;
        let high = if tall { fridge } else { TOP };
        let shaded = tall && wall.sill(base.from, base.to).is_some();
        let solid = Solid { area: shrunk(&base.area), low: 0.0, high };
        let others = || bases.iter().map(|other| shrunk(&other.area));
        let apart = others().filter(|other| other.overlaps(&solid.area)).count() == 1;
        !shaded
            && apart
            && s.space.is_free(&solid)
            && s.space.is_clear(&base.zone)
            && !others().any(|other| other.overlaps(&base.zone))
    })
}
