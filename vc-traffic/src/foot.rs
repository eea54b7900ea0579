//! People on the map: their walks from door to door, and crossings, which they and vehicles leave to each other.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::Seed;
use vc_map::route::Router;
use vc_map::{CrossingId, DrivingSide, Light, StreetMap};

use crate::Traffic;
use crate::advance::STUCK;
use crate::block::Block;
use crate::bytes::{Reader, Writer};
use crate::crossing::KERB;
use crate::crowd::{Crowd, RADIUS, Walker, Way};
use crate::ground::{Ground, Links, Over};
use crate::journey::{self, Journey, Passage};
use crate::network::{NONE, Network};
use crate::save::SaveError;
use crate::trip::{PersonId, TrafficEvent, Walk};

/// The speed of people with nobody around, its deviation, and its bounds, metres per second (Weidmann, 1993).
const SPEED: f32 = 1.34;
const DEVIATION: f32 = 0.26;
const SPEEDS: [f32; 2] = [0.6, 2.0];
/// Those who cross walk at least so fast, metres per second: lights give time for less.
const HURRY: f32 = 1.2;
/// Vehicles yield to whoever is so near to a crossing's kerb, and one begins to cross from so near, metres.
const CLAIMS: f32 = 2.0;
const BEGINS: f32 = 0.5;
/// One who has waited so long where there is no crossing asks vehicles to stop, and lets them go on by turns of so long, seconds.
const CLAIMS_AFTER: f32 = 5.0;
const CLAIMS_FOR: f32 = 20.0;
/// Lights of two crossings that have not shown green at once for so long never do, seconds.
const NEVER: f32 = 150.0;
/// Somebody has arrived who is so near to their door, metres; those who set out wait for room, and try once in so many seconds.
const THERE: f32 = 0.4;
const TRIES: f32 = 1.0;

/// The speed at which somebody walks with nobody around, by their seed, metres per second.
pub(crate) fn free_speed(seed: Seed) -> f32 {
    seed.stream().normal(SPEED, DEVIATION).clamp(SPEEDS[0], SPEEDS[1])
}

/// Those on foot, and the crossings.
#[derive(Clone)]
pub(crate) struct Foot {
    pub(crate) crowd: Crowd,
    pub(crate) walks: Arc<Vec<Walk>>,
    router: Option<Arc<Router>>,
    ground: Option<Arc<Ground>>,
    /// The walks in the order of their departure, and the next of these.
    order: Arc<Vec<u32>>,
    coming: usize,
    /// Those who wait for room at their door.
    pending: BTreeMap<PersonId, (Arc<Way>, Arc<[Passage]>)>,
    pub(crate) journeys: BTreeMap<PersonId, Journey>,
    /// For each crossing: the number of those who may cross or do, whether somebody is about to, and whether a vehicle has waited for too long.
    on: Vec<u16>,
    claimed: Vec<bool>,
    pub(crate) late: Vec<bool>,
    /// For each junction: whether one of its crossings is claimed.
    pub(crate) claims: Vec<bool>,
}

impl Foot {
    /// Nobody on foot.
    pub(crate) fn none(map: &StreetMap, step: f32) -> Self {
        let crowd = Crowd::new(step);
        let crossings = map.crossings().len();
        Self {
            crowd: if map.side() == DrivingSide::Left { crowd.keeping_left() } else { crowd },
            walks: Arc::default(),
            router: None,
            ground: None,
            order: Arc::default(),
            coming: 0,
            pending: BTreeMap::new(),
            journeys: BTreeMap::new(),
            on: vec![0; crossings],
            claimed: vec![false; crossings],
            late: vec![false; crossings],
            claims: vec![false; map.junctions().len()],
        }
    }

    /// Sets the walks of those who are to come.
    pub(crate) fn set(&mut self, network: &Network, links: Arc<Links>, walks: Vec<Walk>) {
        let mut order: Vec<u32> = (0..walks.len() as u32).collect();
        order.sort_by(|a, b| walks[*a as usize].departs.total_cmp(&walks[*b as usize].departs).then(a.cmp(b)));
        (self.walks, self.order) = (Arc::new(walks), Arc::new(order));
        let ground = Ground::new(network, links);
        self.router = Some(Arc::new(Router::on_foot(&network.map, |edge| ground.reluctance(edge.index()))));
        self.ground = Some(Arc::new(ground));
    }

    /// The number of those who are on a crossing, or may begin to cross.
    pub(crate) fn on(&self, crossing: u32) -> u16 {
        self.on[crossing as usize]
    }

    /// Counts one more or one fewer there.
    pub(crate) fn count(&mut self, crossing: u32, more: bool) -> u16 {
        let on = &mut self.on[crossing as usize];
        *on = if more { *on + 1 } else { *on - 1 };
        *on
    }

    /// The number of walks that have not begun.
    pub(crate) fn waiting(&self) -> usize {
        self.pending.len() + self.order.len() - self.coming
    }

    /// The way of a walk.
    fn way(&self, network: &Network, walk: &Walk) -> Option<(Arc<Way>, Arc<[Passage]>)> {
        journey::way(network, self.ground.as_ref()?, self.router.as_ref()?, walk)
    }

    /// Writes those on foot.
    pub(crate) fn save(&self, to: &mut Writer) {
        to.long(self.crowd.steps());
        to.word(self.coming as u32);
        to.list(self.pending.keys(), |to, id| to.word(id.0));
        let late: Vec<u32> = (0..self.late.len() as u32).filter(|c| self.late[*c as usize]).collect();
        to.list(late.iter(), |to, crossing| to.word(*crossing));
        to.list(self.journeys.iter(), |to, (id, journey)| {
            to.word(id.0);
            self.crowd.save(*id, to);
            journey.save(to);
        });
    }

    /// All that decides on what follows, as numbers.
    pub(crate) fn words(&self) -> impl Iterator<Item = u64> {
        let of =
            |journey: &Journey| [journey.next as u64 * 2 + u64::from(journey.on), u64::from(journey.waits.to_bits())];
        let journeys = self.journeys.values().flat_map(of);
        let pending = self.pending.keys().map(|id| u64::from(id.0));
        [self.crowd.digest().0, self.coming as u64].into_iter().chain(journeys).chain(pending)
    }
}

impl Traffic {
    /// People ask to cross, as they stand, and leave the crossings that are behind them.
    pub(crate) fn cross(&mut self) {
        self.blocks.clone_from(&self.obstructed);
        self.cross_all();
        self.blocks.sort_by(|a, b| a.span.link.cmp(&b.span.link).then(a.span.from.total_cmp(&b.span.from)));
    }

    fn cross_all(&mut self) {
        if self.foot.crowd.is_empty() && !self.foot.claims.contains(&true) {
            return;
        }
        self.foot.claimed.fill(false);
        self.foot.claims.fill(false);
        let mut journeys = std::mem::take(&mut self.foot.journeys);
        for (journey, slot) in journeys.values_mut().zip(self.foot.crowd.slots()) {
            if journey.next < journey.passages.len() {
                self.come_to(journey, slot);
            }
        }
        self.foot.journeys = journeys;
    }

    /// One on foot before or on a passage asks, goes, or leaves it.
    fn come_to(&mut self, journey: &mut Journey, slot: u32) {
        let passages = journey.passages.clone();
        let Passage { crossings, over: Over { from, to, spans }, kerb } = &passages[journey.next];
        let station = self.foot.crowd.station(slot);
        let walk = |crossing: &u32| self.network.crosswalks[*crossing as usize];
        let lit = |crossing: &u32| {
            let walk = walk(crossing);
            matches!(
                self.light_of(walk.junction as usize, walk.row as usize),
                None | Some(Light::Green | Light::GreenYield)
            )
        };
        // Where two that have no room between them never show green at once people heed the first.
        let heeded = if journey.waits > NEVER { crossings.len().min(1) } else { crossings.len() };
        let lit = crossings[..heeded].iter().all(lit);
        // One who has not come over the kerb yet waits.
        let begun = station + RADIUS > kerb + KERB;
        let mut leaves = false;
        let mut claims = false;
        if journey.on {
            leaves = station > to + RADIUS;
            if leaves || (!lit && !begun) {
                journey.on = false;
                crossings.iter().for_each(|c| self.foot.on[*c as usize] -= 1);
            }
            if leaves {
                self.foot.crowd.keep(slot, to + RADIUS);
            }
        } else if station > from - CLAIMS - RADIUS {
            journey.waits += self.dt;
            // Whoever stands on the way has to go first.
            let empty = lit && self.is_empty_on(spans);
            let turn = ((journey.waits / CLAIMS_FOR) as u32).is_multiple_of(2);
            claims = empty && journey.waits > CLAIMS_AFTER && turn;
            if empty {
                for c in crossings.iter() {
                    self.foot.claimed[*c as usize] = true;
                    self.foot.claims[self.network.crosswalks[*c as usize].junction as usize] = true;
                }
            }
            let free = |c: &u32| {
                let walk = walk(c);
                !self.foot.late[*c as usize] && self.is_clear(walk.junction as usize, walk.row as usize, NONE, false)
            };
            let near = station > from - BEGINS - RADIUS;
            if near && empty && crossings.iter().all(free) && self.is_open(spans) {
                (journey.on, journey.waits) = (true, 0.0);
                crossings.iter().for_each(|c| self.foot.on[*c as usize] += 1);
            }
        }
        for c in crossings.iter() {
            let walk = self.network.crosswalks[*c as usize];
            self.roads.cross(walk.junction as usize, walk.row, self.foot.on[*c as usize] > 0);
        }
        if journey.on || claims {
            self.blocks.extend(spans.iter().map(|span| Block { span: *span, firm: journey.on }));
        }
        journey.next += usize::from(leaves);
        let ahead = journey.next + usize::from(journey.on);
        let stop = passages.get(ahead).map_or(f32::INFINITY, |next| next.over.from);
        let speed = if journey.on { journey.speed.max(HURRY) } else { journey.speed };
        self.foot.crowd.lead_slot(slot, stop, speed);
    }

    /// Whether somebody is about to cross where a row of a junction leads.
    pub(crate) fn is_claimed(&self, junction: usize, row: usize) -> bool {
        if !self.foot.claims[junction] {
            return false;
        }
        let of = &self.network.map.junctions()[junction];
        let met = |(place, id): (usize, &CrossingId)| {
            self.foot.claimed[id.index()] && of.conflicts.has(row, of.movements.len() + place)
        };
        of.crossings.iter().enumerate().any(met)
    }

    /// Nobody else begins to cross where a vehicle has waited for too long.
    pub(crate) fn keep_clear(&mut self, junction: usize, row: usize) {
        let of = &self.network.map.junctions()[junction];
        for (place, id) in of.crossings.iter().enumerate() {
            if of.conflicts.has(row, of.movements.len() + place) {
                self.foot.late[id.index()] = true;
            }
        }
    }

    /// Reads those on foot.
    pub(crate) fn read_foot(&mut self, from: &mut Reader) -> Result<(), SaveError> {
        let wrong = |name| SaveError::Wrong(name);
        let network = self.network.clone();
        let foot = &mut self.foot;
        let walks = foot.walks.clone();
        foot.crowd.clear(from.long()?);
        foot.coming = from.below(walks.len() + 1, "next walk")? as usize;
        let way = |foot: &Foot, id: u32| foot.way(&network, &walks[id as usize]).ok_or(wrong("walk"));
        let waiting = from.list(|from| from.below(walks.len(), "walk"))?;
        foot.pending.clear();
        for id in waiting {
            let way = way(foot, id)?;
            foot.pending.insert(PersonId(id), way);
        }
        foot.late.fill(false);
        for crossing in from.list(|from| from.below(network.crosswalks.len(), "crossing"))? {
            foot.late[crossing as usize] = true;
        }
        foot.claimed.fill(false);
        foot.claims.fill(false);
        foot.on.fill(0);
        foot.journeys.clear();
        for _ in 0..from.word()? {
            let id = from.below(walks.len(), "walk")?;
            let (way, passages) = way(foot, id)?;
            let walker = Walker::read(PersonId(id), way, from)?;
            let journey = Journey::read(passages, from)?;
            if foot.pending.contains_key(&walker.id) || foot.journeys.contains_key(&walker.id) {
                return Err(wrong("walk"));
            }
            if journey.on {
                let crossings = journey.passages[journey.next].crossings.iter();
                crossings.for_each(|c| foot.on[*c as usize] += 1);
            }
            foot.crowd.insert(walker);
            foot.journeys.insert(PersonId(id), journey);
        }
        for (walk, on) in network.crosswalks.iter().zip(&foot.on) {
            self.roads.cross(walk.junction as usize, walk.row, *on > 0);
        }
        Ok(())
    }

    /// A step on foot: people walk, arrive, and set out.
    pub(crate) fn walk(&mut self) {
        if self.foot.walks.is_empty() {
            return;
        }
        self.foot.crowd.step();
        let now = (self.step + 1) as f32 * self.dt;
        let stuck = |walker: &Walker| (STUCK..STUCK + self.dt).contains(&walker.stood);
        let stuck: Vec<PersonId> = self.foot.crowd.people().filter(stuck).map(|walker| walker.id).collect();
        self.events.extend(stuck.into_iter().map(|person| TrafficEvent::StuckOnFoot { person }));
        let there = |walker: &Walker| walker.station() > walker.way.length() - THERE;
        let arrived: Vec<Walker> = self.foot.crowd.people().filter(there).collect();
        for walker in arrived {
            self.foot.crowd.remove(walker.id);
            if let Some(journey) = self.foot.journeys.remove(&walker.id) {
                let (person, metres) = (walker.id, walker.way.length());
                self.events.push(TrafficEvent::Reached { person, seconds: now - journey.since, metres });
            }
        }
        self.set_off(now);
    }

    fn set_off(&mut self, now: f32) {
        while let Some(number) = self.foot.order.get(self.foot.coming).copied() {
            let walk = self.foot.walks[number as usize];
            if walk.departs > now {
                break;
            }
            self.foot.coming += 1;
            let person = PersonId(number);
            match self.foot.way(&self.network, &walk) {
                Some(way) => _ = self.foot.pending.insert(person, way),
                None => self.events.push(TrafficEvent::NoWalk { person }),
            }
        }
        let every = (TRIES / self.dt).round().max(1.0) as u64;
        let seed: Seed = self.seed.child("people");
        let step = self.step;
        let trying = self.foot.pending.iter().filter(|(id, _)| (step + u64::from(id.0)).is_multiple_of(every));
        let trying: Vec<PersonId> = trying.map(|(id, _)| *id).collect();
        for id in trying {
            let Some((way, passages)) = self.foot.pending.remove(&id) else { continue };
            let speed = free_speed(seed.nth(u64::from(id.0)));
            let mut walker = Walker::new(id, way.clone(), 0.0, 0.0, speed);
            walker.stop = passages.first().map_or(f32::INFINITY, |passage| passage.over.from);
            // Whose door is on the road waits for a gap there.
            let on = walker.stop < RADIUS;
            let open = !on
                || passages.first().is_none_or(|first| first.crossings.is_empty() && self.is_open(&first.over.spans));
            if open && self.foot.crowd.add(walker) {
                self.foot.journeys.insert(id, Journey { passages, next: 0, on, waits: 0.0, since: now, speed });
                self.events.push(TrafficEvent::SetOff { person: id });
            } else {
                self.foot.pending.insert(id, (way, passages));
            }
        }
    }
}
