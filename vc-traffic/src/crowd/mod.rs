//! People on foot who walk along ways without running into each other.

mod choice;
mod near;
mod orca;
mod plane;
mod way;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Point2, Vector2};
use vc_graph::Digest;
use vc_graph::hash::Digester;

use choice::Planes;
use near::Seen;
pub use way::Way;

use crate::bytes::{Reader, Writer};
use crate::network::NONE;
use crate::save::SaveError;
use crate::trip::PersonId;

/// The radius of a body, metres.
pub(crate) const RADIUS: f32 = 0.2;
/// Bodies may overlap by so much, metres.
const ROUNDING: f32 = 0.005;
/// One comes on who goes so fast along the way, and waits who is so near to where one does; metres per second, metres.
const COMES_ON: f32 = 0.2;
const WAITS: f32 = 0.3;

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

    /// Finds the piece of the way on which they are; false if they are beside it.
    pub(crate) fn is_put_on_way(&mut self) -> bool {
        let at = Point2::from(self.at);
        let on = |piece: &way::Piece| {
            let (station, aside) = piece.place(&at);
            (0.0..=piece.length).contains(&station) && aside.abs() <= piece.half - RADIUS
        };
        let piece = self.way.pieces.iter().position(on);
        self.piece = piece.unwrap_or(0) as u32;
        piece.is_some() && self.velocity.iter().all(|metres| metres.is_finite())
    }

    pub(crate) fn read(id: PersonId, way: Arc<Way>, from: &mut Reader) -> Result<Self, SaveError> {
        let [x, y, vx, vy, speed, stood] = from.reals("number of a person")?;
        let (stop, back) = (from.bound("number of a person")?, from.bound("number of a person")?);
        let piece = from.below(way.pieces.len(), "place on a way")?;
        Ok(Self { id, way, at: [x, y], velocity: [vx, vy], speed, stop, back, stood, piece })
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
/// others in a tent of four metres ahead, as far as it lies on the way, each sees a density, and takes the speed that Weidmann's relation
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
    /// Discs that people walk around: places and radii, metres.
    discs: Vec<(Point2<f32>, f32)>,
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
            discs: Vec::new(),
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
        let apart = (2.0 * RADIUS - ROUNDING) * (2.0 * RADIUS - ROUNDING);
        let taken = |slot: &u32| (self.at[*slot as usize] - at).norm_squared() < apart;
        if self.slots.contains_key(&walker.id) || self.slots.values().any(taken) {
            return false;
        }
        self.insert(walker);
        true
    }

    /// Puts somebody where they are.
    pub(crate) fn insert(&mut self, walker: Walker) {
        let Walker { id, way, at, velocity, speed, stop, back, stood, piece } = walker;
        let at = Point2::from(at);
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
    }

    /// The number of steps since it began.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// Takes everybody out, and counts steps from a number on.
    pub(crate) fn clear(&mut self, steps: u64) {
        (self.slots, self.free, self.steps) = (BTreeMap::new(), (0..self.id.len() as u32).collect(), steps);
    }

    /// Writes somebody.
    pub(crate) fn save(&self, id: PersonId, to: &mut Writer) {
        let Some(i) = self.slots.get(&id).map(|slot| *slot as usize) else { return };
        let (at, velocity) = (self.at[i], self.velocity[i]);
        to.reals([at.x, at.y, velocity.x, velocity.y, self.speed[i], self.stood[i], self.stop[i], self.back[i]]);
        to.word(self.piece[i]);
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

    /// Sets the discs that people walk around.
    pub(crate) fn set_discs(&mut self, discs: Vec<(Point2<f32>, f32)>) {
        self.discs = discs;
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
        seen.extend(
            self.discs.iter().enumerate().map(|(number, (at, radius))| Seen::disc(number as u32, *at, *radius)),
        );
        let mut chosen = vec![Vector2::zeros(); seen.len()];
        let mut planes = Planes::default();
        near::around(&mut seen, |people, place, rows| {
            if people[place].slot != NONE {
                chosen[place] = self.choose(people, place, rows, &mut planes);
            }
        });
        for (one, velocity) in seen.iter().zip(&chosen).filter(|(one, _)| one.slot != NONE) {
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
}
