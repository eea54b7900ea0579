//! People on foot who walk along ways without running into each other.

mod near;
mod orca;
mod plane;
mod way;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Point2, Vector2};
use vc_graph::Digest;
use vc_graph::hash::Digester;
use vc_graph::portable::Portable;

use near::{Nearest, SIGHT, Seen};
use plane::HalfPlane;
use way::Piece;
pub use way::Way;

use crate::trip::PersonId;

/// The radius of a body, and what people like to keep between two, metres.
pub(crate) const RADIUS: f32 = 0.2;
const MARGIN: f32 = 0.05;
/// People avoid the next of those near by whom they would meet within some time, seconds; the time for who is too near already.
const AVOIDED: usize = 10;
const AHEAD: f32 = 2.0;
const TOO_NEAR: f32 = 0.5;
/// They set off and slow down for a stop by so much, metres per second squared.
const SETS_OFF: f32 = 1.5;
const SLOWS: f32 = 2.0;
/// Those who evade others walk so many times as fast at most.
const FASTER: f32 = 1.15;
/// Weidmann's relation of speed and density (Transporttechnik der Fussgänger, 1993): its factor and its greatest density, for a square metre.
const FACTOR: f32 = 1.913;
const DENSEST: f32 = 5.4;
/// Nobody wants to walk slower than at this part of their free speed, so that no crowd stands for ever.
const SLOWEST: f32 = 0.05;
/// The room ahead in which others count, along and to each side, metres.
const ROOM: [f32; 2] = [4.0, 1.5];
/// Counts of others are whole numbers of these parts, so that their sum does not depend on the order.
const PARTS: f32 = 65536.0;
/// Whoever meets somebody makes way to the side on which one drives, and passes slower ones where there is more room; from so far away,
/// and so fast aside, metres, metres per second. One is slower who goes by so much less.
const MEETS: f32 = 4.0;
const ASIDE: f32 = 0.3;
const SLOWER: f32 = 0.1;
/// Whoever has not come on for so long only keeps from touching others, and tries a direction for some time each, up to so much to a side, and
/// once in so many times back; seconds, and the part of their speed. One comes on who goes so fast along the way, and waits who is so near to where one does; metres per second, metres.
const IMPATIENT: f32 = 5.0;
const TRIES: f32 = 2.0;
const TRIED: f32 = 0.6;
const ASIDE_MOST: f32 = 1.5;
const BACK: u64 = 3;
const COMES_ON: f32 = 0.2;
const WAITS: f32 = 0.3;
/// A way with a smaller sine between two pieces goes straight on.
const STRAIGHT: f32 = 0.01;
/// The edge of a bend leans back by at most so much for each metre aside.
const MOST_LEAN: f32 = 2.0;

/// Somebody on foot with all that decides how they go on: what [`Crowd::add`] takes and [`Crowd::remove`] gives back.
#[derive(Debug, Clone)]
pub struct Walker {
    /// The number of the person.
    pub id: PersonId,
    /// The way.
    pub way: Arc<Way>,
    /// The place, metres.
    pub at: [f32; 2],
    /// The velocity, metres per second.
    pub velocity: [f32; 2],
    /// The speed with nobody around, metres per second.
    pub speed: f32,
    /// The station of the way before which one waits, metres; infinity to wait nowhere.
    pub stop: f32,
    /// The station of the way behind which one does not let oneself be pushed back, metres.
    pub back: f32,
    /// For how long they have not come on, seconds.
    pub stood: f32,
    piece: u32,
}

impl Walker {
    /// Somebody who stands at a station of a way, so far to the left of its line in metres, and walks at a speed in metres per second.
    pub fn new(id: PersonId, way: Arc<Way>, station: f32, left: f32, speed: f32) -> Self {
        let (at, piece) = (way.at(station, left), way.piece(station) as u32);
        Self { id, way, at, velocity: [0.0; 2], speed, stop: f32::INFINITY, back: f32::NEG_INFINITY, stood: 0.0, piece }
    }

    /// How far along the way they are, metres.
    pub fn station(&self) -> f32 {
        let piece = &self.way.pieces[self.piece as usize];
        piece.station + piece.place(&self.at.into()).0
    }
}

/// People who walk along ways: they keep to these, avoid each other (optimal reciprocal collision avoidance), and go slower where the room
/// ahead is full. Bodies, discs of 0.2 m, never overlap by more than rounding does. The same people give the same state, bit for bit,
/// whatever the order in which they were added.
///
/// The wish to go slower is a filter of the density ahead (Best, Narang, Curtis and Manocha, Symposium on Computer Animation 2014): of the
/// others in a tent of three metres ahead, as far as it lies on the way, each sees a density, and takes the speed that Weidmann's relation
/// gives for it. Reciprocal avoidance alone walks through dense crowds at full speed.
///
/// ```
/// use std::sync::Arc;
/// use vc_map::Polyline;
/// use vc_traffic::{Crowd, PersonId, Walker, Way};
/// let line = Polyline::new([[0.0, 0.0], [20.0, 0.0]]).ok_or("too short")?;
/// let way = Arc::new(Way::new([(line.clone(), 2.0)]).ok_or("no way")?);
/// let back = Arc::new(Way::new([(line.reversed(), 2.0)]).ok_or("no way")?);
/// let mut crowd = Crowd::new(0.1);
/// for (id, way) in [(0, way), (1, back)] {
///     assert!(crowd.add(Walker::new(PersonId(id), way, 1.0, 0.0, 1.34)));
/// }
/// (0..100).for_each(|_| crowd.step());
/// // They met halfway and passed each other.
/// let stations: Vec<f32> = crowd.people().map(|walker| walker.station()).collect();
/// assert!(stations.iter().all(|station| *station > 12.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Crowd {
    dt: f32,
    /// Whether those who meet keep to the right.
    right: bool,
    slots: BTreeMap<PersonId, u32>,
    free: Vec<u32>,
    id: Vec<u32>,
    way: Vec<Arc<Way>>,
    piece: Vec<u32>,
    at: Vec<Point2<f32>>,
    velocity: Vec<Vector2<f32>>,
    speed: Vec<f32>,
    stop: Vec<f32>,
    back: Vec<f32>,
    stood: Vec<f32>,
    steps: u64,
    seen: Vec<Seen>,
}

impl Crowd {
    /// Nobody yet; a step takes so many seconds: 0.02 to 0.5, others count as the nearest of these.
    pub fn new(step: f32) -> Self {
        Self {
            dt: step.clamp(0.02, 0.5),
            right: true,
            slots: BTreeMap::new(),
            free: Vec::new(),
            id: Vec::new(),
            way: Vec::new(),
            piece: Vec::new(),
            at: Vec::new(),
            velocity: Vec::new(),
            speed: Vec::new(),
            stop: Vec::new(),
            back: Vec::new(),
            stood: Vec::new(),
            steps: 0,
            seen: Vec::new(),
        }
    }

    /// Those who meet keep to the left.
    #[must_use]
    pub fn keeping_left(mut self) -> Self {
        self.right = false;
        self
    }

    /// Adds somebody. False, and nothing happens, if their number is taken or somebody stands there. Costs a look at everybody.
    pub fn add(&mut self, walker: Walker) -> bool {
        let at = Point2::from(walker.at);
        let apart = 4.0 * RADIUS * RADIUS;
        let taken = |slot: &u32| (self.at[*slot as usize] - at).norm_squared() < apart;
        if self.slots.contains_key(&walker.id) || self.slots.values().any(taken) {
            return false;
        }
        let Walker { id, way, velocity, speed, stop, back, stood, piece, .. } = walker;
        let slot = self.free.pop().unwrap_or(self.id.len() as u32);
        let i = slot as usize;
        if i == self.id.len() {
            self.id.push(id.0);
            self.way.push(way);
            self.piece.push(piece);
            self.at.push(at);
            self.velocity.push(velocity.into());
            self.speed.push(speed);
            self.stop.push(stop);
            self.back.push(back);
            self.stood.push(stood);
        } else {
            (self.id[i], self.way[i], self.piece[i], self.at[i]) = (id.0, way, piece, at);
            (self.velocity[i], self.speed[i]) = (velocity.into(), speed);
            (self.stop[i], self.back[i], self.stood[i]) = (stop, back, stood);
        }
        self.slots.insert(id, slot);
        true
    }

    /// Takes somebody out; added again at once they go on as if nothing had been.
    pub fn remove(&mut self, id: PersonId) -> Option<Walker> {
        let slot = self.slots.remove(&id)?;
        self.free.push(slot);
        Some(self.walker(slot))
    }

    /// Somebody as they are.
    pub fn person(&self, id: PersonId) -> Option<Walker> {
        self.slots.get(&id).map(|slot| self.walker(*slot))
    }

    /// Everybody, by their numbers.
    pub fn people(&self) -> impl Iterator<Item = Walker> {
        self.slots.values().map(|slot| self.walker(*slot))
    }

    /// The number of people.
    pub fn len(&self) -> usize {
        self.slots.len()
    }

    /// Whether nobody is there.
    pub fn is_empty(&self) -> bool {
        self.slots.is_empty()
    }

    /// Sets the station before which somebody waits, metres, infinity to go on; and their speed with nobody around, metres per second.
    pub fn lead(&mut self, id: PersonId, stop: f32, speed: f32) {
        if let Some(slot) = self.slots.get(&id).copied() {
            self.lead_slot(slot, stop, speed);
        }
    }

    /// Sets the station behind which somebody is not pushed back, metres.
    pub(crate) fn keep(&mut self, slot: u32, back: f32) {
        self.back[slot as usize] = back;
    }

    pub(crate) fn lead_slot(&mut self, slot: u32, stop: f32, speed: f32) {
        (self.stop[slot as usize], self.speed[slot as usize]) = (stop, speed);
    }

    /// The slots of all, in the order of their numbers.
    pub(crate) fn slots(&self) -> Vec<u32> {
        self.slots.values().copied().collect()
    }

    /// How far along their way somebody is, metres.
    pub(crate) fn station(&self, slot: u32) -> f32 {
        let i = slot as usize;
        let piece = &self.way[i].pieces[self.piece[i] as usize];
        piece.station + piece.place(&self.at[i]).0
    }

    fn walker(&self, slot: u32) -> Walker {
        let i = slot as usize;
        Walker {
            id: PersonId(self.id[i]),
            way: self.way[i].clone(),
            at: self.at[i].into(),
            velocity: self.velocity[i].into(),
            speed: self.speed[i],
            stop: self.stop[i],
            back: self.back[i],
            stood: self.stood[i],
            piece: self.piece[i],
        }
    }

    /// One step: everybody chooses a velocity by those around as they were, then all move. Costs about a microsecond for each
    /// where people are as many as in streets, and some microseconds in dense crowds.
    pub fn step(&mut self) {
        let mut seen = std::mem::take(&mut self.seen);
        seen.clear();
        seen.extend(self.slots.iter().map(|(id, slot)| {
            let i = *slot as usize;
            Seen::new(id.0, *slot, self.at[i], self.velocity[i])
        }));
        let mut chosen = vec![Vector2::zeros(); seen.len()];
        let mut planes = Planes::default();
        near::around(&mut seen, |people, place, rows| {
            chosen[place] = self.choose(people, place, rows, &mut planes);
        });
        for (one, velocity) in seen.iter().zip(&chosen) {
            let i = one.slot as usize;
            self.velocity[i] = *velocity;
            self.at[i] += velocity * self.dt;
            let pieces = &self.way[i].pieces;
            while (self.piece[i] as usize) + 1 < pieces.len() && pieces[self.piece[i] as usize].is_behind(&self.at[i]) {
                self.piece[i] += 1;
            }
            self.stood[i] = self.stands(one.slot);
        }
        self.seen = seen;
        self.steps += 1;
    }

    /// How long somebody has not come on after a step, seconds; nothing for those who wait where they have to.
    fn stands(&self, slot: u32) -> f32 {
        let i = slot as usize;
        let along = self.velocity[i].dot(&self.way[i].pieces[self.piece[i] as usize].along);
        let waits = self.stop[i] - RADIUS - self.station(slot) < WAITS;
        if waits || along > COMES_ON { 0.0 } else { self.stood[i] + self.dt }
    }

    /// A number of everything that decides on what follows: equal for equal states.
    pub fn digest(&self) -> Digest {
        let mut hasher = Digester::new();
        hasher.word(self.steps);
        for (id, slot) in &self.slots {
            let i = *slot as usize;
            hasher.words([u64::from(id.0), u64::from(self.piece[i])]);
            hasher.reals([
                self.at[i].x,
                self.at[i].y,
                self.velocity[i].x,
                self.velocity[i].y,
                self.speed[i],
                self.stop[i],
                self.back[i],
                self.stood[i],
            ]);
        }
        hasher.digest()
    }

    /// The direction that somebody tries who does not come on: ahead to one side or the other, and sometimes back.
    fn tries(&self, id: u32, piece: &Piece) -> Vector2<f32> {
        let turn = self.steps / (TRIES / self.dt) as u64;
        let number = vc_graph::hash::splitmix(turn << 32 | u64::from(id));
        let side = (number >> 40) as f32 / (1 << 23) as f32 - 1.0;
        let ahead = if number.is_multiple_of(BACK) { -1.0 } else { 1.0 };
        (piece.along * ahead + piece.left() * (side * ASIDE_MOST)).normalize()
    }

    /// The velocity that somebody takes.
    fn choose(
        &self,
        people: &[Seen],
        place: usize,
        rows: [std::ops::Range<usize>; 3],
        planes: &mut Planes,
    ) -> Vector2<f32> {
        let own = &people[place];
        let i = own.slot as usize;
        let pieces = &self.way[i].pieces;
        let piece = &pieces[self.piece[i] as usize];
        let next = pieces.get(self.piece[i] as usize + 1);
        let (station, aside) = piece.place(&own.at);
        let mut room = Room { count: 0, before: None, meets: false };
        let mut nearest = Nearest::new();
        for other in rows.into_iter().flatten() {
            let them = &people[other];
            let away = them.at - own.at;
            let square = away.norm_squared();
            if square < SIGHT * SIGHT && other != place {
                nearest.add(square, other as u32, people);
                room.see(piece, &away, them);
            }
        }
        let density = room.density(piece, aside);
        let free = self.speed[i];
        let mut speed = free * (1.0 - (-FACTOR * (1.0 / density.max(1e-3) - 1.0 / DENSEST)).exponential()).max(SLOWEST);
        let stop = self.stop[i] - RADIUS - piece.station - station;
        if stop.is_finite() {
            speed = speed.min((2.0 * SLOWS * stop.max(0.0)).sqrt());
        }
        speed = speed.min(own.velocity.norm() + SETS_OFF * self.dt);
        let wish = wish(piece, next, station, aside) * speed + piece.left() * room.aside(speed, aside, self.right);

        let impatient = self.stood[i] > IMPATIENT;
        let wish = if impatient { self.tries(own.id, piece) * (free * TRIED) } else { wish };
        let mut most = free * FASTER;
        let reach = |most: f32| 2.0 * (RADIUS + most * self.dt);
        if let Some((square, _)) = nearest.all().last().filter(|_| nearest.is_full()) {
            // More are too near than one can heed: nobody runs into who is not seen.
            most = most.min(((square.sqrt() - 2.0 * RADIUS) / (2.0 * self.dt)).max(0.0));
        }
        planes.clear();
        planes.walls(piece, aside, self.dt);
        let last = (self.piece[i] as usize).checked_sub(1).and_then(|last| pieces.get(last));
        planes.bends(last, piece, next, &own.at, self.dt);
        if stop < 2.0 * most * self.dt + 1.0 {
            planes.hard.push(HalfPlane { normal: -piece.along, least: -stop.max(0.0) / self.dt });
        }
        let back = station + piece.station - self.back[i];
        if back < 2.0 * most * self.dt + 1.0 {
            planes.hard.push(HalfPlane { normal: piece.along, least: -back.max(0.0) / self.dt });
        }
        for (number, (square, other)) in nearest.all().iter().enumerate() {
            let them = &people[*other as usize];
            let (away, distance) = (them.at - own.at, square.sqrt());
            if distance < reach(most) {
                // Each comes nearer by at most half of what is between them.
                let gap = (distance - 2.0 * RADIUS).max(0.0);
                planes.hard.push(HalfPlane { normal: -away / distance, least: -gap / (2.0 * self.dt) });
            }
            if number < AVOIDED && !impatient {
                let apart = 2.0 * RADIUS + MARGIN;
                let time = if distance < apart { TOO_NEAR } else { AHEAD };
                planes.soft.push(orca::avoid(&own.velocity, &away, &(own.velocity - them.velocity), apart, time));
            }
        }
        plane::best(&planes.hard, &planes.soft, wish, most, &mut planes.scratch)
    }
}

/// The direction in which somebody wants to go: along the way, and to where it gets narrower.
fn wish(piece: &Piece, next: Option<&Piece>, station: f32, aside: f32) -> Vector2<f32> {
    let left = (piece.length - station).max(0.3);
    let half = next.filter(|_| left < 4.0 * piece.half).map_or(piece.half, |next| next.half.min(piece.half));
    let beyond = (aside.abs() - (half - RADIUS - MARGIN).max(0.0)).max(0.0).copysign(aside);
    if beyond == 0.0 { piece.along } else { (piece.along * left - piece.left() * beyond).normalize() }
}

/// How full it is ahead of somebody.
struct Room {
    count: u32,
    /// The nearest straight ahead: how far, the number, how far to the left, metres, and the speed along one's way, metres per second.
    before: Option<(f32, u32, f32, f32)>,
    /// Whether somebody comes towards one.
    meets: bool,
}

impl Room {
    fn see(&mut self, piece: &Piece, away: &Vector2<f32>, them: &Seen) {
        let (ahead, left) = (away.dot(&piece.along), piece.along.perp(away));
        let beside = left.abs();
        if ahead <= 0.0 {
            return;
        }
        if ahead < ROOM[0] && beside < ROOM[1] {
            self.count += ((1.0 - ahead / ROOM[0]) * (1.0 - beside / ROOM[1]) * PARTS) as u32;
        }
        self.meets |= ahead < MEETS && them.velocity.dot(&piece.along) < -SLOWER;
        let straight = ahead < MEETS && beside < 2.0 * RADIUS + MARGIN;
        if straight && self.before.is_none_or(|(nearest, id, ..)| (ahead, them.id) < (nearest, id)) {
            self.before = Some((ahead, them.id, left, them.velocity.dot(&piece.along)));
        }
    }

    /// The velocity to the left with which somebody of a speed, so far aside, makes way or passes, metres per second.
    fn aside(&self, speed: f32, aside: f32, right: bool) -> f32 {
        let side = if right { -1.0 } else { 1.0 };
        match self.before.filter(|(.., theirs)| *theirs < speed - SLOWER) {
            Some((.., theirs)) if theirs < -SLOWER => side * ASIDE,
            Some((_, _, left, _)) => -ASIDE.copysign(left),
            // On one's own half of the way.
            None if self.meets && side * aside < RADIUS + MARGIN => side * ASIDE,
            None => 0.0,
        }
    }

    /// The people on a square metre of the room as far as it lies on the way.
    fn density(&self, piece: &Piece, aside: f32) -> f32 {
        let half = |room: f32| {
            let part = (room / ROOM[1]).clamp(0.0, 1.0);
            ROOM[1] * (part - part * part / 2.0)
        };
        let across = half(piece.half - aside) + half(piece.half + aside);
        self.count as f32 / PARTS / (across.max(0.3) * ROOM[0] / 2.0)
    }
}

/// The half-planes of one choice.
#[derive(Default)]
struct Planes {
    hard: Vec<HalfPlane>,
    soft: Vec<HalfPlane>,
    scratch: Vec<HalfPlane>,
}

impl Planes {
    fn clear(&mut self) {
        self.hard.clear();
        self.soft.clear();
    }

    /// Nobody goes in some direction by more than a room in metres within a step.
    fn wall(&mut self, outward: Vector2<f32>, room: f32, dt: f32) {
        self.hard.push(HalfPlane { normal: -outward, least: -room.max(0.0) / dt });
    }

    /// The edges of the way.
    fn walls(&mut self, piece: &Piece, aside: f32, dt: f32) {
        self.wall(piece.left(), piece.half - RADIUS - aside, dt);
        self.wall(-piece.left(), piece.half - RADIUS + aside, dt);
    }

    /// The outer edges behind the bends at both ends of a piece, and the corners where the way gets narrower.
    fn bends(&mut self, last: Option<&Piece>, piece: &Piece, next: Option<&Piece>, at: &Point2<f32>, dt: f32) {
        let (station, aside) = piece.place(at);
        let near = piece.half + 1.0;
        let mut edge = |of: &Piece, half: f32, bend: f32| {
            let outward = of.left() * -bend.signum();
            if bend.abs() > STRAIGHT {
                self.wall(outward, half - RADIUS - (at - of.from).dot(&outward), dt);
            }
        };
        if let Some(last) = last.filter(|_| station < near) {
            edge(last, last.half.max(piece.half), last.along.perp(&piece.along));
        }
        let rest = piece.length - station;
        let Some(next) = next.filter(|_| rest < near) else { return };
        let bend = piece.along.perp(&next.along);
        edge(next, next.half, bend);
        if next.half < piece.half {
            // The line at which one goes on with the next leans back on the inner side.
            let lean = (bend / (1.0 + piece.along.dot(&next.along)).max(0.3)).clamp(-MOST_LEAN, MOST_LEAN);
            for (outward, aside, lean) in [(piece.left(), aside, lean), (-piece.left(), -aside, -lean)] {
                let slant = outward * (1.0 + lean) + piece.along;
                let room = next.half - RADIUS + rest - aside * (1.0 + lean);
                let length = slant.norm();
                self.wall(slant / length, room / length, dt);
            }
        }
    }
}
