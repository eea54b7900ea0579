//! Reachability for a person: a disc on a grid of five centimetres, flood-filled from the front
//! door on.

use std::collections::VecDeque;

use vc_procgen::plan::{OpeningKind, PlanOpening, metres};

use super::thing::{Piece, Thing};
use super::{House, Rule};

const CELL: f64 = 0.05;
const RADIUS: f64 = 0.25;
const TALL: f64 = 1.7;
/// The height that a person steps over: rugs, door thresholds.
const STEP: f64 = 0.035;
const ARM: f64 = 1.0;
/// The height above which objects may be out of reach.
const HIGH: f64 = 2.0;

/// The grid around the plan, with the cells where a person can stand.
pub(super) struct Floor {
    west: f64,
    south: f64,
    columns: usize,
    rows: usize,
    standing: Vec<bool>,
}

pub(super) fn look(house: &mut House<'_>) {
    let floor = Floor::new(house);
    let mut found = Vec::new();
    for (room, id) in house.scene.rooms().iter().enumerate() {
        if !floor.stands(|x, y| house.is_within(room, x, y, 0.0)) {
            let class = house.scene.label(*id).class.to_string();
            found.push((Rule::UnreachableRoom, class, format!("nobody gets into {}", house.scene.label(*id))));
        }
    }
    for thing in house.things.iter().filter(|t| t.used && !t.is_building() && t.low.z <= HIGH) {
        let near = floor.nearest(house, thing, true);
        if near > ARM {
            let any = floor.nearest(house, thing, false);
            let text =
                format!("{} is {near:.2} m from where one stands in its room, {any:.2} m from anywhere", thing.label);
            let carrier = thing.carriers.first().and_then(|c| house.at.get(c)).map_or("", |&i| &house.things[i].class);
            found.push((Rule::UnreachableObject, format!("{} at {carrier}", thing.class), text));
        }
    }
    found.into_iter().for_each(|(rule, group, text)| house.note(rule, group, text));
}

impl Floor {
    fn new(house: &House<'_>) -> Self {
        let hull = house.plan.hull();
        let (west, south) = (f64::from(metres(hull.x0)) - 0.5, f64::from(metres(hull.y0)) - 0.5);
        let cells = |n: i32| n as usize + 20;
        let (columns, rows) = (cells(hull.width()), cells(hull.depth()));
        let mut floor = Self { west, south, columns, rows, standing: Vec::new() };
        let mut free: Vec<bool> = (0..columns * rows).map(|c| floor.is_indoors(house, c)).collect();
        for thing in &house.things {
            let opened = |p: &&Piece| !(thing.is_door() && p.joint.is_some());
            let hinders = |p: &&Piece| p.low.z < TALL && p.high.z > STEP;
            thing.pieces.iter().filter(opened).filter(hinders).for_each(|p| floor.shut(&mut free, p));
        }
        floor.flood(house, free);
        floor
    }

    fn point(&self, cell: usize) -> (f64, f64) {
        let (x, y) = ((cell % self.columns) as f64, (cell / self.columns) as f64);
        (self.west + (x + 0.5) * CELL, self.south + (y + 0.5) * CELL)
    }

    /// Whether a cell is within a room or in an opening between two.
    fn is_indoors(&self, house: &House<'_>, cell: usize) -> bool {
        let (x, y) = self.point(cell);
        let room = (0..house.plan.rooms.len()).any(|r| house.is_within(r, x, y, 0.0));
        let mut ways = house.plan.openings.iter().filter(|o| o.is_way() && o.kind != OpeningKind::Entrance);
        room || ways.any(|o| is_in(o, x, y, 0.4))
    }

    /// Blocks the cells at which a disc would overlap the box of a part.
    fn shut(&self, free: &mut [bool], p: &Piece) {
        let range = |low: f64, high: f64, from: f64, most: usize| {
            let cell = |v: f64| (((v - from) / CELL).floor().max(0.0) as usize).min(most);
            cell(low - RADIUS)..cell(high + RADIUS + CELL)
        };
        for row in range(p.low.y, p.high.y, self.south, self.rows) {
            for column in range(p.low.x, p.high.x, self.west, self.columns) {
                let (x, y) = self.point(row * self.columns + column);
                let dx = (p.low.x - x).max(x - p.high.x).max(0.0);
                let dy = (p.low.y - y).max(y - p.high.y).max(0.0);
                if dx.hypot(dy) < RADIUS - 1e-6 {
                    free[row * self.columns + column] = false;
                }
            }
        }
    }

    /// Fills from inside the front door.
    fn flood(&mut self, house: &House<'_>, mut free: Vec<bool>) {
        self.standing = vec![false; free.len()];
        let Some(door) = house.plan.openings.iter().find(|o| o.kind == OpeningKind::Entrance) else { return };
        let room = door.low.or(door.high).unwrap_or(0);
        let start = (0..free.len()).find(|&c| {
            let (x, y) = self.point(c);
            free[c] && is_in(door, x, y, 0.8) && house.is_within(room, x, y, 0.0)
        });
        let mut open: VecDeque<usize> = start.into_iter().collect();
        open.iter().for_each(|&s| free[s] = false);
        while let Some(cell) = open.pop_front() {
            self.standing[cell] = true;
            for next in [cell - 1, cell + 1, cell - self.columns, cell + self.columns] {
                if std::mem::take(&mut free[next]) {
                    open.push_back(next);
                }
            }
        }
    }

    fn stands(&self, here: impl Fn(f64, f64) -> bool) -> bool {
        (0..self.standing.len()).filter(|&c| self.standing[c]).any(|c| {
            let (x, y) = self.point(c);
            here(x, y)
        })
    }

    /// The least distance over the floor from a standing position to an object's box.
    fn nearest(&self, house: &House<'_>, thing: &Thing, in_its_room: bool) -> f64 {
        let room = thing.room.and_then(|r| house.room_index(r));
        let mut nearest = f64::INFINITY;
        for cell in (0..self.standing.len()).filter(|&c| self.standing[c]) {
            let (x, y) = self.point(cell);
            let dx = (thing.low.x - x).max(x - thing.high.x).max(0.0);
            let dy = (thing.low.y - y).max(y - thing.high.y).max(0.0);
            let away = dx.hypot(dy);
            if away < nearest && (!in_its_room || room.is_some_and(|r| near_room(house, r, x, y))) {
                nearest = away;
            }
        }
        nearest
    }
}

/// Whether a point is in a room or in one of its openings.
fn near_room(house: &House<'_>, room: usize, x: f64, y: f64) -> bool {
    house.is_within(room, x, y, 0.0)
        || house.plan.openings.iter().any(|o| o.is_way() && o.touches(room) && is_in(o, x, y, 0.3))
}

/// Whether a point is in the strip of the given depth before and behind an opening.
fn is_in(o: &PlanOpening, x: f64, y: f64, far: f64) -> bool {
    let (across, along) = if o.vertical { (x, y) } else { (y, x) };
    let along_it = along >= metres(o.from).into() && along <= metres(o.to).into();
    along_it && (across - f64::from(metres(o.at))).abs() <= far
}
