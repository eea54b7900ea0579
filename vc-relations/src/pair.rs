//! Pair facts: everything that depends on just two bodies.
//!
//! All other modules only read these facts. After a body has moved, it therefore suffices to measure its own
//! pairs again, and the result is that of a full rebuild.

use nalgebra::Vector3;
use vc_graph::Aabb;

use crate::body::{Body, Posture};
use crate::containment::{holds, is_within};
use crate::near::{self, NearSide};
use crate::solid::{Solid, gap, sweep_upright};
use crate::threshold::{
    BOX_GAP, HANG_GAP, HOOK_REACH, NEAR_REACH, SEAT_RANGE, SUPPORT_GAP, SUPPORT_NORMAL, SUPPORT_SINK, TRACE_START,
    UNDER_CORE, UNDER_REACH,
};
use crate::walls::Among;

/// Facts about one body in relation to another. Fields that do not apply are infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    /// Index of the other body.
    pub(crate) other: u32,
    /// Gap between their parts, metres; known up to [`HANG_GAP`].
    pub(crate) gap: f32,
    /// Distance between their boxes, metres; known up to [`NEAR_REACH`].
    pub(crate) distance: f32,
    /// Distance from this body down to the other that it may rest on, metres; negative if sunk in.
    pub(crate) rest: f32,
    /// Distance of the other above the centre of this body, metres.
    pub(crate) over: f32,
    /// The side of this body at which the other is.
    pub(crate) side: Option<NearSide>,
    /// Whether the other is below this body.
    pub(crate) is_below: bool,
    pub(crate) inside: bool,
    pub(crate) hooked: bool,
    /// Whether this body's hips are on the other's seat.
    pub(crate) seated: bool,
}

impl Pair {
    fn new(other: usize) -> Self {
        let none = f32::INFINITY;
        Self {
            other: other as u32,
            gap: none,
            distance: none,
            rest: none,
            over: none,
            side: None,
            is_below: false,
            inside: false,
            hooked: false,
            seated: false,
        }
    }

    /// Whether the two are more than near each other, so that the supports of one may depend on the other.
    pub(crate) fn is_bound(&self) -> bool {
        let known = [self.gap, self.rest, self.over].iter().any(|f| f.is_finite());
        known || self.is_below || self.inside || self.hooked || self.seated
    }

    fn says_something(self) -> bool {
        let known = [self.gap, self.distance, self.rest, self.over].iter().any(|f| f.is_finite());
        known || self.inside || self.hooked || self.seated
    }
}

/// Greatest distance down to a support, metres, where shapes are known.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tolerance(pub(crate) f32);

impl Default for Tolerance {
    fn default() -> Self {
        Self(SUPPORT_GAP)
    }
}

/// Measures two bodies, each from its own point of view; `None` if there are no facts for either. `walls` are
/// those that can be between the two.
pub(crate) fn measure(
    (i, a): (usize, &Body),
    (j, b): (usize, &Body),
    (walls, tolerance): (&Among<'_>, Tolerance),
) -> Option<(Pair, Pair)> {
    if a.traits.fixed && b.traits.fixed {
        return None;
    }
    let is_near = a.region.distance_squared(&b.region) <= NEAR_REACH * NEAR_REACH;
    let columns_meet = a.region.meets_in_plan(&b.region);
    if !is_near && !columns_meet {
        return None;
    }
    let (mut ab, mut ba) = (Pair::new(j), Pair::new(i));
    if is_near && a.region.grown(HANG_GAP, BOX_GAP).meets(&b.region) {
        touch((a, b), (&mut ab, &mut ba), tolerance);
    }
    if columns_meet {
        let way = |above: Option<(f32, usize)>| above.map_or(f32::INFINITY, |a| a.0);
        (ab.over, ba.over) = (way(over(a, b)), way(over(b, a)));
        (ab.is_below, ba.is_below) = (ba.over.is_finite(), ab.over.is_finite());
    }
    if is_near
        && !(a.traits.structure || b.traits.structure)
        && let Some(found) = near::beside(a, b).filter(|_| !walls.between(a, b))
    {
        (ab.distance, ba.distance) = (found.distance, found.distance);
        [ab.side, ba.side] = found.sides;
    }
    (ab.says_something() || ba.says_something()).then_some((ab, ba))
}

/// Measures all facts that require the two to be in contact or nearly so.
fn touch((a, b): (&Body, &Body), (ab, ba): (&mut Pair, &mut Pair), tolerance: Tolerance) {
    (ab.inside, ba.inside) = (holds(b, a), holds(a, b));
    let apart = parts_gap(a, b);
    (ab.gap, ba.gap) = (apart, apart);
    if !ba.inside && !is_within(b, a) {
        ab.rest = rest(a, b, tolerance);
    }
    if !ab.inside && !is_within(a, b) {
        ba.rest = rest(b, a, tolerance);
    }
    (ab.hooked, ba.hooked) = (hooked(a, b), hooked(b, a));
    (ab.seated, ba.seated) = (seated(a, b), seated(b, a));
}

/// The least gap between parts, up to [`HANG_GAP`]; negative if they overlap.
fn parts_gap(a: &Body, b: &Body) -> f32 {
    let mut least = f32::INFINITY;
    let near: Vec<&Solid> = b.solids.iter().filter(|t| t.meets(&a.region, HANG_GAP)).collect();
    if near.is_empty() {
        return least;
    }
    for s in a.solids.iter().filter(|s| s.meets(&b.region, HANG_GAP)) {
        for t in near.iter().filter(|t| t.meets(&s.region(), HANG_GAP)) {
            // The exact value matters only below the least gap so far.
            let apart = gap(s, t, least.min(HANG_GAP));
            if apart <= HANG_GAP {
                least = least.min(apart);
            }
        }
    }
    least
}

/// A contact of one body's part on another's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Contact {
    /// Distance down to the contact, metres; negative if sunk in.
    pub(crate) down: f32,
    /// The two parts.
    pub(crate) parts: (usize, usize),
    pub(crate) normal: Vector3<f32>,
}

/// The contact nearest to zero with which one body rests on another.
pub(crate) fn rest(a: &Body, b: &Body, tolerance: Tolerance) -> f32 {
    let limit = if a.traits.boxed || b.traits.boxed { BOX_GAP } else { tolerance.0 };
    if a.traits.fixed || a.region.min.z - b.region.max.z > limit {
        return f32::INFINITY;
    }
    let mut best = f32::INFINITY;
    contacts(a, b, limit, |c| {
        let counts = (-SUPPORT_SINK..=limit).contains(&c.down) && c.normal.z >= SUPPORT_NORMAL;
        if counts && c.down.abs() < best.abs() {
            best = c.down;
        }
    });
    // If only the box of a sofa is known, its seat is somewhere in the upper half.
    if best.is_infinite() && b.traits.vague && is_over_middle(a, b) { -SUPPORT_SINK } else { best }
}

fn is_over_middle(a: &Body, b: &Body) -> bool {
    let own = b.whole.axes.tr_mul(&(a.whole.centre - b.whole.centre)).abs();
    own.x <= b.whole.half.x && own.y <= b.whole.half.y && (b.whole.centre.z..=b.region.max.z).contains(&a.base())
}

/// Calls `found` with every contact that a trace down from a part finds, within `limit`, with a part whose
/// centre is lower.
pub(crate) fn contacts(a: &Body, b: &Body, limit: f32, mut found: impl FnMut(Contact)) {
    let over = |s: &Solid| s.region().meets_in_plan(&b.region) && s.low.z - b.region.max.z <= limit;
    let under = |t: &Solid| t.region().meets_in_plan(&a.region) && a.region.min.z - t.high.z <= limit;
    let lower: Vec<(usize, &Solid)> = b.solids.iter().enumerate().filter(|(_, t)| under(t)).collect();
    if lower.is_empty() {
        return;
    }
    for (p, s) in a.solids.iter().enumerate().filter(|(_, s)| over(s)) {
        let mut core = None;
        for &(q, t) in &lower {
            let is_below = t.centre.z < s.centre.z && s.low.z - t.high.z <= limit;
            if !is_below || plans_apart(s, t) {
                continue;
            }
            let core = core.get_or_insert_with(|| s.core());
            let hit = below(s, core, t, limit);
            hit.into_iter().for_each(|(down, normal)| found(Contact { down, parts: (p, q), normal }));
        }
    }
}

fn plans_apart(s: &Solid, t: &Solid) -> bool {
    s.low.x > t.high.x || s.high.x < t.low.x || s.low.y > t.high.y || s.high.y < t.low.y
}

/// Height of a part above another and the contact's normal, by a vertical trace of its core.
fn below(part: &Solid, core: &Solid, other: &Solid, limit: f32) -> Option<(f32, Vector3<f32>)> {
    let (full, thin) = ((part.high.z - part.low.z) / 2.0, (core.high.z - core.low.z) / 2.0);
    let raise = (TRACE_START - (full - thin)).max(0.0);
    let start = core.moved(Vector3::z() * raise);
    let strike = sweep_upright(&start, other, -1.0, limit + raise + full)?;
    (strike.way >= 0.0).then_some((strike.way - raise - (full - thin), strike.normal))
}

/// Distance of another body above the centre of this one, and the piece of it that is hit, by a trace of the
/// middle of this body's box straight up.
pub(crate) fn over(a: &Body, b: &Body) -> Option<(f32, usize)> {
    let middle = a.whole.centre.z;
    if a.traits.structure || b.region.max.z <= middle || b.region.min.z > a.region.max.z + UNDER_REACH {
        return None;
    }
    let middle_half = (a.whole.high - a.whole.low) * (UNDER_CORE / 2.0);
    let middle_region = Aabb { min: (a.whole.centre - middle_half).into(), max: (a.whole.centre + middle_half).into() };
    if !middle_region.meets_in_plan(&b.region) {
        return None;
    }
    let core = middle_of(a);
    let meets = |t: &Solid| {
        if plans_apart(&core, t) || t.high.z <= middle {
            return None;
        }
        sweep_upright(&core, t, 1.0, a.whole.half.norm() + UNDER_REACH).filter(|s| s.way >= 0.0)
    };
    let met = b.solids.iter().enumerate().filter_map(|(piece, t)| Some((meets(t)?.way, piece)));
    met.reduce(|best, other| if other.0 < best.0 { other } else { best })
}

/// The shape swept by the trace up: the middle of the box, flattened.
pub(crate) fn middle_of(a: &Body) -> Solid {
    let mut half = a.whole.half * UNDER_CORE;
    half[a.whole.axes.row(2).abs().transpose().imax()] = 0.0;
    Solid::new(a.whole.centre, a.whole.axes, half, a.whole.round)
}

/// A hook of one body, relative to another body that may hang on it.
pub(crate) struct Hooked {
    pub(crate) at: Vector3<f32>,
    /// Its distance from the other's box, metres.
    pub(crate) distance: f32,
    /// Whether it is at the upper half of that box.
    pub(crate) is_high: bool,
}

impl Hooked {
    pub(crate) fn holds(&self) -> bool {
        self.distance <= HOOK_REACH && self.is_high
    }
}

/// The hooks of body `b` relative to body `a`.
pub(crate) fn hooks(a: &Body, b: &Body) -> impl Iterator<Item = Hooked> {
    b.hooks().map(|at| {
        let distance = (a.whole.nearest(&at) - at).norm();
        Hooked { at, distance, is_high: at.z >= a.whole.centre.z }
    })
}

/// Whether a body hangs on a hook of another: the hook is at the upper half of its box.
fn hooked(a: &Body, b: &Body) -> bool {
    !b.form.hooks.is_empty() && !a.traits.fixed && hooks(a, b).any(|h| h.holds())
}

/// Whether an agent's box has a seat of the other at hip height, under its centre.
fn seated(a: &Body, b: &Body) -> bool {
    let may = a.traits.agent && b.traits.sittable && a.posture != Posture::Lying;
    may && seat_share(a, b).is_some_and(|share| past_hips(share) == 0.0)
}

/// Height of the top of the other body under this one's centre, as a share of this one's height; if there are
/// several pieces, the one nearest to the hips.
pub(crate) fn seat_share(a: &Body, b: &Body) -> Option<f32> {
    let (low, height, centre) = (a.region.min.z, a.region.max.z - a.region.min.z, a.whole.centre);
    let is_below = |s: &&Solid| (s.low.x..=s.high.x).contains(&centre.x) && (s.low.y..=s.high.y).contains(&centre.y);
    let shares = b.solids.iter().filter(is_below).map(|s| (s.high.z - low) / height.max(1e-3));
    shares.reduce(|best, other| if past_hips(other) < past_hips(best) { other } else { best })
}

/// Distance of a share of the height from the range of seats.
fn past_hips(share: f32) -> f32 {
    (SEAT_RANGE.0 - share).max(share - SEAT_RANGE.1).max(0.0)
}
