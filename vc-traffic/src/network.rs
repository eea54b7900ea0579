//! A map as vehicles see it: links, which are lanes and the movements over junctions, with what decides who goes.

use vc_graph::portable::Portable;
use vc_map::{Control, Light, Movement, Polyline, StreetMap, Users};

use crate::crossing::{self, Crosswalk};

/// No link, no vehicle.
pub(crate) const NONE: u32 = u32::MAX;
/// The sideways acceleration at which vehicles go through turns, metres per second squared, and the slowest that they do.
const SIDEWAYS: f64 = 2.5;
const SLOWEST: f64 = 2.5;
/// Ways that come nearer than this are in each other's way where they meet, metres.
const NEAR: f64 = 2.6;
/// Vehicles that wait within a junction stand so far before the first way that it gives way to, and so far into the junction at least, metres.
const BEFORE: f64 = 1.5;
const INSIDE: f64 = 3.0;
/// One stops this far before a line, but this far on its lane, metres.
const BEFORE_LINE: f64 = 1.0;
const ON_LANE: f64 = 0.3;
/// Those who stand at a line are so far from the ways of others, metres, which are looked at so far back.
const APART: f64 = 2.2;
const BACK: f64 = 12.0;
/// Ways over a junction are compared at points so far apart, metres.
const STEP: f64 = 0.5;

/// The links of a map: its lanes, then its movements.
pub(crate) struct Network {
    pub(crate) map: StreetMap,
    /// The number of lanes; links from here on are movements.
    pub(crate) lanes: usize,
    /// Metres, metres per second, and who may drive there, of each link.
    pub(crate) length: Vec<f32>,
    pub(crate) limit: Vec<f32>,
    pub(crate) users: Vec<Users>,
    /// For each lane: its line, where vehicles come to a stop before that, its side of its road, its neighbours, and the movements at its end.
    pub(crate) stop: Vec<f32>,
    pub(crate) halt: Vec<f32>,
    pub(crate) side: Vec<u32>,
    pub(crate) inner: Vec<u32>,
    pub(crate) outer: Vec<u32>,
    pub(crate) next: Vec<Vec<u32>>,
    /// For each lane: whether everybody comes to a stop at its end.
    pub(crate) stops: Vec<bool>,
    /// For each movement: its lanes, its junction and its row in the table there.
    pub(crate) from: Vec<u32>,
    pub(crate) to: Vec<u32>,
    pub(crate) junction: Vec<u32>,
    pub(crate) row: Vec<u32>,
    /// For each movement: whether nothing is ever in its way.
    pub(crate) free: Vec<bool>,
    /// For each movement: where one waits within the junction for those to whom one gives way in one's green; 0 where one does not.
    pub(crate) hold: Vec<f32>,
    /// For each movement: the rows that it meets beyond that place.
    pub(crate) beyond: Vec<Vec<bool>>,
    /// For each movement: how far beyond it a rear is clear of crossings, metres; and for each lane the most of those that lead to it.
    pub(crate) clear: Vec<f32>,
    pub(crate) begin: Vec<f32>,
    /// The crossings.
    pub(crate) crosswalks: Vec<Crosswalk>,
    /// For each lane: the movements that lead to it.
    pub(crate) before: Vec<Vec<u32>>,
    /// For each junction: the links of its movements by row, and the lanes from which one asks to go.
    pub(crate) rows: Vec<Vec<u32>>,
    pub(crate) ways_in: Vec<Vec<u32>>,
    /// For each road's side: its lanes for motor vehicles.
    pub(crate) sides: Vec<Vec<u32>>,
}

impl Network {
    pub(crate) fn new(map: &StreetMap) -> Self {
        let lanes = map.lanes().len();
        let number = |id: Option<vc_map::LaneId>| id.map_or(NONE, |id| id.0);
        let mut sides = vec![Vec::new(); map.roads().len() * 2];
        for (index, lane) in map.lanes().iter().enumerate() {
            if lane.users.any(Users::CAR | Users::BUS) {
                sides[side(lane) as usize].push(index as u32);
            }
        }
        let mut row = vec![0; map.movements().len()];
        let rows: Vec<Vec<u32>> = map
            .junctions()
            .iter()
            .map(|junction| junction.movements.iter().map(|id| lanes as u32 + id.0).collect())
            .collect();
        for links in &rows {
            links.iter().enumerate().for_each(|(number, link)| row[*link as usize - lanes] = number as u32);
        }
        let all = || map.lanes().iter();
        let moves = || map.movements().iter();
        let mut network = Self {
            map: map.clone(),
            lanes,
            length: all().map(|l| l.line.length()).chain(moves().map(|m| m.line.length())).map(|m| m as f32).collect(),
            limit: all().map(|lane| lane.limit).chain(moves().map(|m| speed(map, m))).map(|v| v as f32).collect(),
            users: all().map(|lane| lane.users).chain(moves().map(|m| m.users)).collect(),
            stop: all().map(|lane| lane.stop_line.unwrap_or(lane.line.length()) as f32).collect(),
            halt: all()
                .map(|lane| (lane.line.length(), lane.stop_line))
                .map(|(all, line)| halt(line.unwrap_or(all), all))
                .collect(),
            side: all().map(side).collect(),
            inner: all().map(|lane| number(lane.inner)).collect(),
            outer: all().map(|lane| number(lane.outer)).collect(),
            next: all().map(|lane| lane.next.iter().map(|id| lanes as u32 + id.0).collect()).collect(),
            stops: all().map(|lane| lane.sign == Some(vc_map::SignKind::Stop)).collect(),
            from: moves().map(|m| m.from.0).collect(),
            to: moves().map(|m| m.to.0).collect(),
            junction: moves().map(|m| m.junction.0).collect(),
            row,
            free: vec![false; map.movements().len()],
            hold: vec![0.0; map.movements().len()],
            beyond: vec![Vec::new(); map.movements().len()],
            clear: vec![0.0; map.movements().len()],
            begin: vec![0.0; lanes],
            crosswalks: crossing::crosswalks(map),
            before: all().map(|lane| lane.before.iter().map(|id| lanes as u32 + id.0).collect()).collect(),
            ways_in: vec![Vec::new(); rows.len()],
            rows,
            sides,
        };
        for junction in 0..map.junctions().len() {
            network.junction(junction);
            network.keep_back(junction);
        }
        network
    }

    /// Moves the lines of lanes back to where those who stand there are beside the ways of others: streets that meet at a sharp angle, lanes that
    /// become one.
    fn keep_back(&mut self, number: usize) {
        let map = self.map.clone();
        let junction = &map.junctions()[number];
        let lane = |id: vc_map::MovementId| map.movement(id).and_then(|movement| map.lane(movement.from));
        for (row, id) in junction.movements.iter().enumerate() {
            let Some(own) = lane(*id) else { continue };
            let from = self.from[id.index()] as usize;
            let length = own.line.length();
            let others = junction.movements.iter().enumerate().filter(|(other, _)| junction.conflicts.has(row, *other));
            let mut ways: Vec<Polyline> = Vec::new();
            for other in others.filter_map(|(_, id)| map.movement(*id)) {
                let theirs = map.lane(other.from).filter(|lane| side(lane) != side(own)).map(|lane| &lane.line);
                ways.extend(theirs.and_then(|line| line.part(line.length() - BACK, line.length())));
                ways.push(other.line.clone());
            }
            let near = |station: &f64| ways.iter().any(|way| way.project(&own.line.at(*station)).left.abs() < APART);
            let steps = (0..=(BACK / STEP) as u32).map(|step| length - f64::from(step) * STEP);
            let Some(last) = steps.take_while(|station| *station > 0.0).filter(near).last() else { continue };
            let stop = self.stop[from].min((last - STEP) as f32).max(0.0);
            self.stop[from] = stop;
            self.halt[from] = self.halt[from].min(halt(f64::from(stop), length));
        }
    }

    /// Moves the line of a lane back to a station.
    pub(crate) fn stop_at(&mut self, lane: u32, station: f32) {
        let length = self.length[lane as usize];
        self.stop[lane as usize] = station;
        self.halt[lane as usize] = self.halt[lane as usize].min(halt(f64::from(station), f64::from(length)));
    }

    /// Has vehicles ask to go by a movement of a junction.
    pub(crate) fn asks_at(&mut self, junction: usize, link: u32) {
        let movement = self.movement(link);
        self.free[movement] = false;
        let from = self.from[movement];
        let lanes = &mut self.ways_in[junction];
        if self.users[link as usize].any(Users::CAR | Users::BUS)
            && let Err(place) = lanes.binary_search(&from)
        {
            lanes.insert(place, from);
        }
    }

    /// Sets what a junction decides of its movements.
    fn junction(&mut self, number: usize) {
        let map = self.map.clone();
        let junction = &map.junctions()[number];
        for (row, id) in junction.movements.iter().enumerate() {
            let met: Vec<usize> =
                (0..junction.conflicts.size()).filter(|other| junction.conflicts.has(row, *other)).collect();
            let clear = crossing::clear(&map, vc_map::JunctionId(number as u32), row);
            let begin = &mut self.begin[self.to[id.index()] as usize];
            (self.clear[id.index()], *begin) = (clear, begin.max(clear));
            let from = map.movement(*id).map_or(0, |movement| movement.from.index());
            if junction.draft.control == Control::AllWayStop {
                self.stops[from] = true;
            }
            self.free[id.index()] = junction.signal.is_none() && met.is_empty() && !self.stops[from];
            self.wait_inside(junction, row, &met);
            let asks = !self.free[id.index()] && self.users[self.lanes + id.index()].any(Users::CAR | Users::BUS);
            if asks && !self.ways_in[number].contains(&(from as u32)) {
                self.ways_in[number].push(from as u32);
            }
        }
        self.ways_in[number].sort_unstable();
    }

    /// Sets where those wait within a junction with lights who give way to oncoming traffic in their green.
    fn wait_inside(&mut self, junction: &vc_map::Junction, row: usize, met: &[usize]) {
        let Some(signal) = junction.signal.and_then(|id| self.map.signal(id)) else { return };
        let yields = |other: &usize| {
            signal.phases.iter().any(|phase| {
                let light = |row: usize| phase.lights.get(row).copied();
                light(row) == Some(Light::GreenYield) && matches!(light(*other), Some(Light::Green | Light::GreenYield))
            })
        };
        let map = self.map.clone();
        let line = |row: usize| junction.movements.get(row).and_then(|id| map.movement(*id)).map(|m| &m.line);
        let Some(own) = line(row) else { return };
        let first = |other: &usize| line(*other).and_then(|theirs| meets(own, theirs));
        let before = met.iter().filter(|other| yields(other)).filter_map(first).reduce(f64::min);
        let Some(hold) = before.map(|station| station - BEFORE).filter(|hold| *hold >= INSIDE) else { return };
        let movement = junction.movements[row].index();
        let lane = vc_map::LaneId(self.from[movement]);
        let crossing = |other: usize| {
            junction.crossings.get(other.checked_sub(junction.movements.len())?).and_then(|id| map.crossing(*id))
        };
        let beyond = |other: usize| match crossing(other) {
            Some(crossing) => !crossing::is_before(&map, crossing, lane, own, hold + BEFORE / 2.0),
            None => first(&other).is_none_or(|station| station > hold + BEFORE / 2.0),
        };
        self.hold[movement] = hold as f32;
        self.beyond[movement] =
            (0..junction.conflicts.size()).map(|other| met.contains(&other) && beyond(other)).collect();
    }

    /// Whether a link is a lane.
    pub(crate) fn is_lane(&self, link: u32) -> bool {
        (link as usize) < self.lanes
    }

    /// The position of a movement among those of the map.
    pub(crate) fn movement(&self, link: u32) -> usize {
        link as usize - self.lanes
    }

    /// The line of a link.
    pub(crate) fn line(&self, link: u32) -> &Polyline {
        let index = link as usize;
        if index < self.lanes { &self.map.lanes()[index].line } else { &self.map.movements()[index - self.lanes].line }
    }

    /// The station on a lane beside another one, metres.
    pub(crate) fn across(&self, station: f32, lane: u32, beside: u32) -> f32 {
        station * self.length[beside as usize] / self.length[lane as usize]
    }

    /// The station on a link, or on a lane beside it, metres.
    pub(crate) fn on_or_across(&self, station: f32, link: u32, other: u32) -> f32 {
        if link == other { station } else { self.across(station, link, other) }
    }

    /// A movement from a lane to a side of a road: the first, if there are several.
    pub(crate) fn towards(&self, lane: u32, side: u32, users: Users) -> Option<u32> {
        let fits = |link: &&u32| {
            let to = self.to[self.movement(**link)] as usize;
            self.side[to] == side && self.users[**link as usize].has(users)
        };
        self.next[lane as usize].iter().find(fits).copied()
    }
}

/// Where vehicles come to a stop before the line of a lane: on it, where it is short.
fn halt(line: f64, length: f64) -> f32 {
    (line - BEFORE_LINE).max(ON_LANE.min(length / 2.0)) as f32
}

/// The number of a lane's side of its road.
fn side(lane: &vc_map::Lane) -> u32 {
    lane.road.0 * 2 + u32::from(!lane.forward)
}

/// The speed at which vehicles go over a junction, metres per second.
fn speed(map: &StreetMap, movement: &Movement) -> f64 {
    let limit = |id| map.lane(id).map_or(SLOWEST, |lane| lane.limit);
    let line = &movement.line;
    let [from, to] = [line.direction(0.0), line.direction(line.length())];
    let angle = from.perp(&to).angle_to(from.dot(&to)).abs();
    let turn = (SIDEWAYS * line.length() / angle.max(0.01)).sqrt().max(SLOWEST);
    limit(movement.from).min(limit(movement.to)).min(turn)
}

/// How far along a way one first comes near another, metres.
pub(crate) fn meets(way: &Polyline, other: &Polyline) -> Option<f64> {
    let steps = (way.length() / STEP) as u32;
    let mut stations = (0..=steps).map(|step| f64::from(step) * STEP);
    stations.find(|station| other.project(&way.at(*station)).left.abs() < NEAR)
}
