//! The supports of a body, from its pairs and the evidence.

use std::borrow::Cow;
use std::cell::Cell;

use vc_graph::{Edge, NodeId};

use crate::body::Body;
use crate::facts::Facts;
use crate::pair::Pair;
use crate::threshold::{HANG_GAP, IMPULSE_SHARE, SUPPORT_SINK, SUPPORT_TIE, TOUCH_GAP};
use crate::world::World;

/// The reason why one thing is known to rest on another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum SupportKind {
    /// A joint holds it.
    Joint,
    /// A contact pushes it up.
    Contact,
    /// The trace down hits it.
    Trace,
    /// It hangs on a hook.
    Hook,
    /// It is inside, and nothing is found below: only the container's box is known.
    Container,
    /// Nothing is below, and it touches this at the side or above.
    Hanging,
}

/// A thing on which another rests.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Support {
    /// The supporting thing.
    pub by: NodeId,
    /// How the support is known.
    pub kind: SupportKind,
    /// Its share of the upward impulse if contacts are known, otherwise an equal share.
    pub share: f32,
    /// Gap between the two, metres; negative if one has sunk into the other. Zero for joints and contacts.
    pub gap: f32,
}

/// A possible support, before cycles are excluded. A `soft` one does not lead downwards and could close a
/// cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) support: Support,
    pub(crate) index: usize,
    pub(crate) soft: bool,
}

/// Possible supports of all bodies, one after the other.
#[derive(Debug, Default)]
struct Known {
    list: Vec<Candidate>,
    /// End of each body's supports in the list.
    ends: Vec<u32>,
}

impl Known {
    fn of(&self, index: usize) -> &[Candidate] {
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.list[start as usize..self.ends[index] as usize]
    }
}

pub(crate) struct Supports<'w> {
    pub(crate) world: &'w World,
    pub(crate) facts: &'w Facts,
    /// The supports of all bodies, if they were requested together.
    known: Option<Known>,
    /// Work list, reused between searches.
    met: Cell<Vec<usize>>,
}

impl<'w> Supports<'w> {
    /// For a few bodies, whose supports are found on request.
    pub(crate) fn new(world: &'w World, facts: &'w Facts) -> Self {
        Self { world, facts, known: None, met: Cell::default() }
    }

    /// For all bodies, whose supports are found once.
    pub(crate) fn for_all(world: &'w World, facts: &'w Facts) -> Self {
        let mut supports = Self::new(world, facts);
        let mut known = Known::default();
        for index in 0..world.bodies.len() {
            supports.find(index, &mut known.list);
            known.ends.push(known.list.len() as u32);
        }
        supports.known = Some(known);
        supports
    }

    pub(crate) fn candidates(&self, index: usize) -> Cow<'_, [Candidate]> {
        if let Some(known) = &self.known {
            return known.of(index).into();
        }
        let mut found = Vec::new();
        self.find(index, &mut found);
        found.into()
    }

    /// The edges by which a thing is held or worn, by nodes that are in the scene.
    pub(crate) fn held(&self, thing: NodeId) -> impl Iterator<Item = &'w Edge> {
        let is_there = |id: NodeId| self.world.index(id).is_some();
        self.facts.held(thing).iter().filter(move |e| is_there(e.from) && is_there(e.to))
    }

    /// Finds the supports of a body: by joint, otherwise by contact, otherwise by trace. Held and worn things
    /// rest on nothing, nor does the building.
    fn find(&self, index: usize, out: &mut Vec<Candidate>) {
        let Some(body) = &self.world.bodies[index] else { return };
        if self.held(body.id).next().is_some() {
            return;
        }
        let is_there = |id: &NodeId| self.world.index(*id).is_some();
        let attached = self.facts.attached.get(&body.id).into_iter().flatten();
        let parents: Vec<NodeId> = attached.copied().filter(is_there).collect();
        if !parents.is_empty() {
            let share = 1.0 / parents.len() as f32;
            let support = |&by| Support { by, kind: SupportKind::Joint, share, gap: 0.0 };
            return self.put(index, parents.iter().map(support), out);
        }
        if body.traits.fixed {
            return;
        }
        let start = out.len();
        if let Some(pushes) = self.facts.pushed.get(&body.id) {
            let is_content = |by: NodeId| self.world.index(by).is_some_and(|by| self.contains(index, by));
            let up = || pushes.iter().filter(|(by, v)| **v > 0.0 && is_there(by) && !is_content(**by));
            let sum: f32 = up().map(|p| p.1).sum();
            let carries = up().filter(|(_, v)| **v >= IMPULSE_SHARE * sum);
            let support = |(&by, v): (_, &f32)| Support { by, kind: SupportKind::Contact, share: v / sum, gap: 0.0 };
            self.put(index, carries.map(support), out);
        }
        if out.len() == start {
            self.traced(index, out);
        }
    }

    fn put(&self, index: usize, supports: impl Iterator<Item = Support>, out: &mut Vec<Candidate>) {
        let candidate = |support: Support| Some(self.candidate(index, self.world.index(support.by)?, support));
        out.extend(supports.filter_map(candidate));
    }

    fn candidate(&self, index: usize, other: usize, support: Support) -> Candidate {
        let base = |i: usize| self.world.bodies[i].as_deref().map_or(f32::NEG_INFINITY, Body::base);
        Candidate { support, index: other, soft: base(other) >= base(index) }
    }

    fn traced(&self, index: usize, out: &mut Vec<Candidate>) {
        let stands = self.stands(index);
        let may = |p: &&Pair| self.may_carry(index, p) && !(stands && self.is_held(p.other as usize));
        let pairs = || self.world.pairs[index].iter().filter(|p| p.rest.is_finite()).filter(may);
        let best = pairs().map(|p| p.rest.abs()).fold(f32::INFINITY, f32::min);
        if best.is_infinite() {
            return self.hung(index, out);
        }
        let start = out.len();
        let tied = pairs().filter(|p| p.rest.abs() <= best + SUPPORT_TIE);
        out.extend(tied.map(|p| self.found(index, p, SupportKind::Trace, p.rest)));
        if out.len() > start + 1 {
            let uncovered = self.uncovered(&out[start..]);
            out.truncate(start);
            out.extend(uncovered);
        }
        let share = 1.0 / (out.len() - start) as f32;
        out[start..].iter_mut().for_each(|c| c.support.share = share);
    }

    /// Whether one body contains another, and so does not rest on it: a lamp wedged in a drawer carries no nightstand.
    fn contains(&self, index: usize, other: usize) -> bool {
        self.world.pair(other, index).is_some_and(|pair| pair.inside)
    }

    /// Whether one body may rest on the other of a pair. Only movable things are carried in hands: not the
    /// light switch that a full laundry basket brushes, nor the chair that a cushion touches. If it is known
    /// what hands carry, then nothing else rests on people or on the things in their hands.
    fn may_carry(&self, index: usize, pair: &Pair) -> bool {
        let other = pair.other as usize;
        let is_agent = || self.world.bodies[other].as_deref().is_some_and(|b| b.traits.agent);
        if self.facts.is_left(self.world.ids[index]) && (self.facts.is_carried(self.world.ids[other]) || is_agent()) {
            return false;
        }
        let Some(body) = self.world.bodies[index].as_deref().filter(|b| b.traits.moves) else {
            return !self.is_in_hand(other);
        };
        let furniture = body.traits.sittable || body.traits.lieable;
        !furniture || !self.is_held(other)
    }

    /// Whether a body is an agent, or an agent holds or wears it or something below it.
    fn is_in_hand(&self, index: usize) -> bool {
        let (mut below, mut next) = (vec![index], 0);
        while let Some(&at) = below.get(next) {
            next += 1;
            let Some(body) = self.world.bodies[at].as_deref().filter(|b| b.traits.moves) else { continue };
            if body.traits.agent || self.held(body.id).next().is_some() {
                return true;
            }
            let further =
                self.candidates(at).iter().map(|c| c.index).filter(|i| !below.contains(i)).collect::<Vec<_>>();
            below.extend(further);
        }
        false
    }

    /// The supports that have no other one of them between themselves and the body.
    fn uncovered(&self, tied: &[Candidate]) -> Vec<Candidate> {
        let is_covered = |c: &&Candidate| tied.iter().any(|other| self.covers(other, c));
        tied.iter().filter(|c| !is_covered(c)).copied().collect()
    }

    /// Whether something that is not held carries a body: a hand does not carry things that also rest
    /// elsewhere.
    fn stands(&self, index: usize) -> bool {
        self.world.pairs[index].iter().any(|p| p.rest.is_finite() && !self.is_held(p.other as usize))
    }

    fn is_held(&self, index: usize) -> bool {
        self.held(self.world.ids[index]).next().is_some()
    }

    /// Whether one support lies between and rests on the other: the cup is on the saucer, however thin, and not
    /// on the table.
    fn covers(&self, between: &Candidate, deeper: &Candidate) -> bool {
        between.support.gap < deeper.support.gap
            && self.world.pair(between.index, deeper.index).is_some_and(|p| p.rest.is_finite())
    }

    fn found(&self, index: usize, pair: &Pair, kind: SupportKind, gap: f32) -> Candidate {
        let other = pair.other as usize;
        self.candidate(index, other, Support { by: self.world.ids[other], kind, share: 1.0, gap })
    }

    /// The support of a hanging thing: a hook, otherwise its container, otherwise the wall or ceiling,
    /// otherwise the nearest thing it touches that is itself supported.
    fn hung(&self, index: usize, out: &mut Vec<Candidate>) {
        if self.world.bodies[index].as_deref().is_none_or(|b| b.traits.agent) {
            return;
        }
        let ranked = self.world.pairs[index].iter().filter_map(|p| Some((self.rank(index, p)?, p)));
        let order = |a: &(u8, &Pair), b: &(u8, &Pair)| {
            a.0.cmp(&b.0).then(a.1.gap.total_cmp(&b.1.gap)).then(a.1.other.cmp(&b.1.other))
        };
        let Some((rank, pair)) = ranked.min_by(order) else { return };
        let ground = [SupportKind::Hook, SupportKind::Container, SupportKind::Hanging][usize::from(rank.min(2))];
        let gap = if pair.gap.is_finite() { pair.gap } else { 0.0 };
        out.push(self.found(index, pair, ground, gap));
    }

    /// Rank of another body as a thing to hang on; `None` if it is unsuitable.
    fn rank(&self, index: usize, pair: &Pair) -> Option<u8> {
        let other = pair.other as usize;
        let back = self.world.pair(other, index);
        if back.is_some_and(|b| b.inside || b.hooked) {
            return None;
        }
        match pair {
            p if !self.may_carry(index, p) => None,
            p if p.hooked => Some(0),
            p if p.inside => Some(1),
            p if self.is_building(p) => Some(2),
            p if (-SUPPORT_SINK..=TOUCH_GAP).contains(&p.gap) && self.may_hang(index, other) => Some(3),
            _ => None,
        }
    }

    fn is_building(&self, pair: &Pair) -> bool {
        let other = self.world.bodies[pair.other as usize].as_deref();
        pair.gap <= HANG_GAP && other.is_some_and(|b| b.traits.structure)
    }

    /// Whether a body that merely touches another may hang on it: a towel on a shelf, but no shelf on a towel.
    fn may_hang(&self, index: usize, other: usize) -> bool {
        let body = |i: usize| self.world.bodies[i].as_deref();
        let moves = |i: usize| body(i).is_some_and(|b| b.traits.moves);
        let larger = || {
            let size = |i: usize| body(i).map_or(0.0, |b| (b.region.max - b.region.min).product());
            size(index) > size(other)
        };
        (moves(index) || !moves(other) || !larger()) && self.is_firm(other)
    }

    /// Whether a body is supported by more than mere touch.
    fn is_firm(&self, index: usize) -> bool {
        let id = self.world.ids[index];
        self.world.bodies[index].as_deref().is_some_and(|b| b.traits.fixed)
            || self.facts.attached.contains_key(&id)
            || self.facts.pushed.contains_key(&id)
            || self.world.pairs[index].iter().any(|p| p.rest.is_finite() || p.hooked || self.is_building(p))
    }

    /// Whether one body rests on another, directly or through others.
    pub(crate) fn reaches(&self, from: usize, goal: usize) -> bool {
        let mut met = self.met.take();
        met.clear();
        met.push(from);
        let mut next = 0;
        let mut found = false;
        while next < met.len() && !found {
            for step in self.candidates(met[next]).iter() {
                found |= step.index == goal;
                if !met.contains(&step.index) {
                    met.push(step.index);
                }
            }
            next += 1;
        }
        self.met.set(met);
        found
    }

    /// Whether a candidate is valid: it closes no cycle.
    pub(crate) fn is_sound(&self, index: usize, candidate: &Candidate) -> bool {
        !(candidate.soft && self.reaches(candidate.index, index))
    }

    /// The supports of a body, without those that would close a cycle.
    pub(crate) fn of(&self, index: usize) -> Vec<Support> {
        let all = self.candidates(index);
        all.iter().filter(|c| self.is_sound(index, c)).map(|c| c.support).collect()
    }
}
