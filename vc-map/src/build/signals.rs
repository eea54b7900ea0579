//! Fixed-time signals: a green phase for each pair of opposite arms, between them yellow and all red.

use super::conflicts::over;
use super::yields::precedence;
use crate::parts::{Junction, Lane, Movement, RoadCrossing};
use crate::signal::{Light, Phase, Signal};
use crate::{Control, JunctionId, MapDraft, SignalId, Turn, Users};

/// The time of all phases that is aimed at, seconds.
const CYCLE: f64 = 90.0;
/// The shortest green, seconds.
const SHORTEST: f64 = 12.0;
/// The speed at which people cross, metres per second.
const WALKING: f64 = 1.07;
/// Arms whose directions have a smaller product are opposite: its cosine, for 135 degrees.
const OPPOSITE: f64 = -0.7;
/// Arms whose directions have a greater product are side by side: its cosine, for 25 degrees.
const BESIDE: f64 = 0.9;

pub(super) fn signals(
    draft: &MapDraft,
    junctions: &mut [Junction],
    movements: &[Movement],
    crossings: &[RoadCrossing],
    lanes: &[Lane],
) -> Vec<Signal> {
    let mut signals = Vec::new();
    for (index, junction) in junctions.iter_mut().enumerate() {
        if junction.draft.control != Control::Signals || junction.movements.is_empty() {
            continue;
        }
        let own = junction.movements.iter().map(|id| &movements[id.index()]).collect();
        let over = junction.crossings.iter().map(|id| &crossings[id.index()]).collect();
        let plan = Plan { draft, junction, movements: own, crossings: over, lanes };
        signals.push(Signal { junction: JunctionId::of(index), phases: plan.phases() });
        junction.signal = Some(SignalId::of(signals.len() - 1));
    }
    signals
}

struct Plan<'a> {
    draft: &'a MapDraft,
    junction: &'a Junction,
    movements: Vec<&'a Movement>,
    crossings: Vec<&'a RoadCrossing>,
    lanes: &'a [Lane],
}

impl Plan<'_> {
    fn phases(&self) -> Vec<Phase> {
        let mut greens: Vec<Vec<Light>> = self.groups().iter().map(|group| self.green(group)).collect();
        let never = |row: &usize| !greens.iter().any(|green| green[*row] != Light::Red);
        let people: Vec<usize> = (self.movements.len()..self.size()).filter(never).collect();
        if !people.is_empty() {
            let lit = |row: usize| if people.contains(&row) { Light::Green } else { Light::Red };
            greens.push((0..self.size()).map(lit).collect());
        }
        let (yellow, clearance) = self.between();
        let share = (CYCLE - greens.len() as f64 * (yellow + clearance)) / greens.len() as f64;
        let long = |green: &[Light]| share.max(SHORTEST).max(self.walking(green)).round();
        let lone = greens.len() == 1;
        greens
            .iter()
            .flat_map(|green| {
                let mut phases = vec![Phase { seconds: long(green), lights: green.clone() }];
                if !lone {
                    phases.push(Phase {
                        seconds: yellow,
                        lights: green.iter().enumerate().map(|(row, l)| self.ending(row, *l)).collect(),
                    });
                    phases.push(Phase { seconds: clearance, lights: vec![Light::Red; self.size()] });
                }
                phases
            })
            .collect()
    }

    fn size(&self) -> usize {
        self.movements.len() + self.crossings.len()
    }

    /// After green comes yellow for vehicles; people who cross have red already.
    fn ending(&self, row: usize, light: Light) -> Light {
        if light == Light::Red || row >= self.movements.len() { Light::Red } else { Light::Yellow }
    }

    /// Yellow and all red, seconds: a second to react and the time to stop; the time to clear the junction.
    fn between(&self) -> (f64, f64) {
        let limit = self.movements.iter().map(|m| self.lanes[m.from.index()].limit).fold(5.0, f64::max).min(20.0);
        let longest = self.movements.iter().map(|m| m.line.length()).fold(0.0, f64::max);
        let half = |seconds: f64| (seconds * 2.0).round() / 2.0;
        (half((1.0 + limit / 6.0).clamp(3.0, 5.0)), half(((longest + 5.0) / limit).clamp(1.0, 3.0)))
    }

    /// The time that people need in a phase, seconds.
    fn walking(&self, green: &[Light]) -> f64 {
        let lit = |(row, _): &(usize, &&RoadCrossing)| green[self.movements.len() + row] != Light::Red;
        let time = |crossing: &RoadCrossing| 7.0 + crossing.line.length() / WALKING;
        self.crossings.iter().enumerate().filter(lit).map(|(_, c)| time(c)).fold(0.0, f64::max).min(CYCLE)
    }

    /// The arms that have green together: opposite ones, and carriageways side by side.
    fn groups(&self) -> Vec<Vec<usize>> {
        let arms = &self.junction.arms;
        let comes = |arm: &usize| self.movements.iter().any(|movement| self.arm(movement) == Some(*arm));
        let mut left: Vec<usize> = (0..arms.len()).filter(comes).collect();
        let mut groups = Vec::new();
        while let Some(first) = left.first().copied() {
            let with = |arm: &usize| {
                let product = arms[first].away.dot(&arms[*arm].away);
                *arm == first || !(OPPOSITE..=BESIDE).contains(&product)
            };
            let (group, rest) = left.into_iter().partition(with);
            groups.push(group);
            left = rest;
        }
        groups
    }

    /// The arm that a movement comes from.
    fn arm(&self, movement: &Movement) -> Option<usize> {
        let lane = &self.lanes[movement.from.index()];
        self.junction.arms.iter().position(|arm| arm.road == lane.road && arm.start != lane.forward)
    }

    /// The lights while some arms have green.
    fn green(&self, group: &[usize]) -> Vec<Light> {
        let goes = |movement: &&Movement| self.arm(movement).is_some_and(|arm| group.contains(&arm));
        let mut lights: Vec<Light> =
            self.movements.iter().map(|m| if goes(m) { Light::Green } else { Light::Red }).collect();
        let people: Vec<Light> = self.crossings.iter().map(|crossing| self.walk(crossing, &lights)).collect();
        lights.extend(people);
        let lit: Vec<usize> = (0..lights.len()).filter(|row| lights[*row] != Light::Red).collect();
        for one in &lit {
            for other in &lit {
                if one != other && self.junction.conflicts.has(*one, *other) && self.gives_way(*one, *other) {
                    lights[*one] = Light::GreenYield;
                }
            }
        }
        lights
    }

    /// People cross while only those drive over the crossing who turn out of the junction there.
    fn walk(&self, crossing: &RoadCrossing, lights: &[Light]) -> Light {
        let in_the_way = |(movement, light): (&&Movement, &Light)| {
            let leaves = !crossing.roads.contains(&self.lanes[movement.from.index()].road);
            let yields = leaves && movement.turn != Turn::Through && !movement.users.any(Users::RAILS);
            *light != Light::Red && over(movement, crossing, self.lanes) && !yields
        };
        if self.movements.iter().zip(lights).any(in_the_way) { Light::Red } else { Light::Green }
    }

    /// Whether the first of two that conflict in a phase gives way: vehicles to people, those that turn to those that do not.
    fn gives_way(&self, one: usize, other: usize) -> bool {
        let (Some(mine), Some(theirs)) = (self.movements.get(one), self.movements.get(other)) else {
            return one < other;
        };
        let key = |movement: &Movement| (movement.users.any(Users::RAILS), precedence(movement.turn, self.draft.side));
        (key(mine), other) < (key(theirs), one)
    }
}
