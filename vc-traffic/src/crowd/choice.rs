//! The velocity that somebody on foot chooses: by the way, the room ahead, and those around.

use nalgebra::{Point2, Vector2};
use vc_graph::portable::Portable;

use super::near::{Nearest, SIGHT, Seen};
use super::plane::HalfPlane;
use super::way::Piece;
use super::{Crowd, RADIUS, orca, plane};

/// People like to keep so much between two bodies, metres.
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
/// One who has to wait keeps to that side from so far on, metres.
const WAITS: f32 = 3.0;
/// Whoever has not come on for so long only keeps from touching others, and tries a direction for some time each, up to so much to a side, and
/// once in so many times back; seconds, and the part of their speed.
const IMPATIENT: f32 = 5.0;
const TRIES: f32 = 2.0;
const TRIED: f32 = 0.6;
const ASIDE_MOST: f32 = 1.5;
const BACK: u64 = 3;
/// A way with a smaller sine between two pieces goes straight on.
const STRAIGHT: f32 = 0.01;
/// The edge of a bend leans back by at most so much for each metre aside.
const MOST_LEAN: f32 = 2.0;

impl Crowd {
    /// The direction that somebody tries who does not come on: ahead to one side or the other, and sometimes back.
    fn tries(&self, id: u32, piece: &Piece) -> Vector2<f32> {
        let turn = self.steps / (TRIES / self.dt) as u64;
        let number = vc_graph::hash::splitmix(turn << 32 | u64::from(id));
        let side = (number >> 40) as f32 / (1 << 23) as f32 - 1.0;
        let ahead = if number.is_multiple_of(BACK) { -1.0 } else { 1.0 };
        (piece.along * ahead + piece.left() * (side * ASIDE_MOST)).normalize()
    }

    /// The velocity that somebody takes.
    pub(super) fn choose(
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
                let wide = them.radius != RADIUS;
                let near = if wide { (square.sqrt() - them.radius + RADIUS).max(0.0).powi(2) } else { square };
                nearest.add(near, other as u32, people);
                room.see(piece, &away, them);
            }
        }
        let density = room.density(piece, aside);
        let free = self.speed[i];
        let mut speed = free * (1.0 - (-FACTOR * (1.0 / density.max(1e-3) - 1.0 / DENSEST)).exponential()).max(SLOWEST);
        let stop = self.stop[i] - RADIUS - piece.station - station;
        // Whoever waits leaves half of the way to those who come over.
        room.meets |= stop < WAITS;
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
            let (away, near) = (them.at - own.at, square.sqrt());
            let distance = if them.radius == RADIUS { near } else { away.norm().max(1e-3) };
            let both = RADIUS + them.radius;
            if near < reach(most) {
                // Each comes nearer by at most half of what is between them.
                let gap = (distance - both).max(0.0);
                planes.hard.push(HalfPlane { normal: -away / distance, least: -gap / (2.0 * self.dt) });
            }
            if number < AVOIDED && !impatient {
                let apart = both + MARGIN;
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
pub(super) struct Planes {
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
