//! Fixed-time signals: a green phase for each pair of opposite arms, the end of it without people, then yellow and all red.

use super::budget::Budget;
use super::conflicts::over;
use super::yields::precedence;
use crate::parts::{Junction, Lane, Movement, RoadCrossing};
use crate::signal::{Light, Phase, Signal};
use crate::{Control, JunctionId, MapDraft, MapError, SignalId, Turn, Users};

/// The time of all phases that is aimed at, seconds.
const CYCLE: f64 = 90.0;
/// The shortest green of vehicles, and of people, seconds.
const SHORTEST: f64 = 12.0;
const SHORTEST_WALK: f64 = 7.0;
/// The speed at which people who have begun to cross are given time to end, metres per second.
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
    budget: &mut Budget,
) -> Result<Vec<Signal>, MapError> {
    let mut signals = Vec::new();
    for (index, junction) in junctions.iter_mut().enumerate() {
        if junction.draft.control != Control::Signals || junction.movements.is_empty() {
            continue;
        }
        let own = junction.movements.iter().map(|id| &movements[id.index()]).collect();
        let over = junction.crossings.iter().map(|id| &crossings[id.index()]).collect();
        let plan = Plan { draft, junction, movements: own, crossings: over, lanes };
        let id = JunctionId::of(index);
        signals.push(Signal { junction: id, phases: plan.phases() });
        junction.signal = Some(SignalId::of(signals.len() - 1));
        budget.take(id, &signals[signals.len() - 1..])?;
    }
    Ok(signals)
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
        let greens = self.greens();
        if let [only] = &greens[..] {
            return vec![Phase { seconds: CYCLE, lights: only.clone() }];
        }
        let (yellow, red) = self.between();
        let share = CYCLE / greens.len() as f64 - yellow - red;
        let phase = |seconds, lights| Phase { seconds, lights };
        let mut phases = Vec::new();
        for lights in greens {
            let clearing = self.clearing(&lights, yellow + red);
            let least = if self.people(&lights).next().is_some() { SHORTEST_WALK + clearing } else { 0.0 };
            let green = share.max(SHORTEST).max(least).round();
            let vehicles: Vec<Light> = self.vehicles(&lights, |light| light);
            let ending = self.vehicles(&lights, |light| if light == Light::Red { Light::Red } else { Light::Yellow });
            phases.push(phase(green - clearing, lights));
            phases.extend((clearing > 0.0).then(|| phase(clearing, vehicles)));
            phases.push(phase(yellow, ending));
            phases.push(phase(red, vec![Light::Red; self.size()]));
        }
        phases
    }

    /// The lights of each green: those of the groups, and one for people who would have none.
    fn greens(&self) -> Vec<Vec<Light>> {
        let mut groups = self.groups();
        if let ([arms], true) = (&groups[..], self.crossings.is_empty()) {
            // Lights are there to stop somebody: those who would always go together go one after the other.
            groups = arms.iter().map(|arm| vec![*arm]).collect();
        }
        let mut greens: Vec<Vec<Light>> = groups.iter().map(|group| self.green(group)).collect();
        let never = |row: &usize| !greens.iter().any(|green| green[*row] != Light::Red);
        let people: Vec<usize> = (self.movements.len()..self.size()).filter(never).collect();
        if !people.is_empty() {
            let lit = |row: usize| if people.contains(&row) { Light::Green } else { Light::Red };
            greens.push((0..self.size()).map(lit).collect());
        }
        greens
    }

    /// The crossings that are lit.
    fn people(&self, lights: &[Light]) -> impl Iterator<Item = &RoadCrossing> {
        let walks = lights[self.movements.len()..].iter().map(|light| *light != Light::Red);
        self.crossings.iter().zip(walks.collect::<Vec<_>>()).filter(|(_, walks)| *walks).map(|(crossing, _)| *crossing)
    }

    /// The time by which people's green ends before that of vehicles, seconds: who has just begun to cross is over before
    /// others start, some time after the end of green.
    fn clearing(&self, lights: &[Light], after: f64) -> f64 {
        let longest = self.people(lights).map(|crossing| crossing.line.length()).fold(0.0, f64::max);
        (longest / WALKING - after).max(0.0).ceil()
    }

    /// The lights of vehicles changed, and red for people.
    fn vehicles(&self, lights: &[Light], change: impl Fn(Light) -> Light) -> Vec<Light> {
        let vehicle = |row: usize| row < self.movements.len();
        lights.iter().enumerate().map(|(row, light)| if vehicle(row) { change(*light) } else { Light::Red }).collect()
    }

    fn size(&self) -> usize {
        self.movements.len() + self.crossings.len()
    }

    /// Yellow and all red, seconds: a second to react and the time to stop; the time to clear the junction.
    fn between(&self) -> (f64, f64) {
        let limit = self.movements.iter().map(|m| self.lanes[m.from.index()].limit).fold(5.0, f64::max).min(20.0);
        let longest = self.movements.iter().map(|m| m.line.length()).fold(0.0, f64::max);
        let half = |seconds: f64| (seconds * 2.0).round() / 2.0;
        (half((1.0 + limit / 6.0).clamp(3.0, 5.0)), half(((longest + 5.0) / limit).clamp(1.0, 3.0)))
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
