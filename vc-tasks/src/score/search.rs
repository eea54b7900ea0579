//! The best way to a goal, without enumerating the ways.

use super::Options;
use super::pass::{Memory, Met, Pass};
use super::way::{LONGEST, WORTHLESS, Way, Worth};
use crate::compile::{Bits, GoalProgram, Ref};

/// The number of fulfilled conditions of the best way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Credit {
    /// The fulfilled conditions.
    pub satisfied: u32,
    /// All conditions of the way; 0 if it has none, or if there is no way.
    pub conditions: u32,
    /// Whether there is any way to the goal without a contradiction.
    pub possible: bool,
    /// Whether it is proved that no better way exists; `false` only if a goal contradicts itself so
    /// often that the search was cut off, or has more than 1,073,741,823 conditions.
    pub exact: bool,
}

impl Credit {
    /// The share, 0 to 1; 0 if there is no way.
    pub fn value(self) -> f64 {
        match (self.possible, self.conditions) {
            (false, _) => 0.0,
            (true, 0) => 1.0,
            (true, conditions) => f64::from(self.satisfied) / f64::from(conditions),
        }
    }

    /// Full credit if the goal holds: a pairing by margins may hold although none of its ways does.
    fn whole_if(self, holds: bool) -> Self {
        match holds {
            true => Self { satisfied: self.conditions, possible: true, ..self },
            false => self,
        }
    }
}

/// The limit of gate visits in a search: about a second. The hardest goal of the 1,016 of
/// BEHAVIOR-1K takes some thousand.
const VISITS: u64 = 1 << 24;

/// The maximal depth of the search, in fixed atoms and gates.
const DEEPEST: u32 = 512;

/// Computes credits and reuses its memory.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// use vc_tasks::compile::GoalProgram;
/// use vc_tasks::score::Scorer;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let mut scorer = Scorer::new();
/// let program = GoalProgram::new(&"On(apple, kitchen_table)".parse()?, &now)?;
/// assert_eq!(scorer.credit(&program, &program.read(&now)).value(), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Scorer {
    memory: Memory,
    sides: Vec<u8>,
}

impl Scorer {
    /// A new scorer.
    pub fn new() -> Self {
        Self::default()
    }

    /// See [`GoalProgram::credit`].
    pub fn credit(&mut self, program: &GoalProgram, bits: &Bits) -> Credit {
        let holds = program.holds(bits);
        self.best(program, Options::Sound, Met { now: bits, start: None }, holds).whole_if(holds)
    }

    /// See [`GoalProgram::bddl_reward`].
    pub fn bddl_reward(&mut self, program: &GoalProgram, bits: &Bits) -> Credit {
        self.best(program, Options::Bddl, Met { now: bits, start: None }, false)
    }

    /// See [`GoalProgram::q_score`].
    pub fn q_score(&mut self, program: &GoalProgram, start: &Bits, now: &Bits) -> f64 {
        match program.holds(now) {
            true => 1.0,
            false => self.best(program, Options::Bddl, Met { now, start: Some(start) }, false).value(),
        }
    }

    /// The best share of fulfilled conditions, by Dinkelbach's method. It starts from the way with
    /// the fewest unfulfilled conditions; where the goal holds, that way is the best one, and it
    /// contains no contradiction because all its conditions are true.
    fn best(&mut self, program: &GoalProgram, options: Options, met: Met<'_>, holds: bool) -> Credit {
        let pass = Pass::new(program, options, met, std::mem::take(&mut self.memory));
        let mut search = Search { pass, sides: &mut self.sides, visits: 0, depth: 0, exact: true };
        let mut found = if holds { search.relaxed(WORTHLESS) } else { search.solve(Worth { p: 1, q: 1 }, WORTHLESS) };
        while let Some(way) = found.filter(|way| way.met < way.of) {
            match search.solve(Worth { p: way.met, q: way.of }, 0) {
                None => break,
                better => found = better,
            }
        }
        let way = found.unwrap_or(Way::NONE);
        let exact = search.exact && way.of < LONGEST;
        self.memory = search.pass.into_memory();
        Credit { satisfied: way.met, conditions: way.of, possible: way.possible, exact }
    }
}

/// Branch and bound: the best value when contradictions are ignored bounds that of ways without
/// any. Parts of the goal that share no contested atom are searched separately.
struct Search<'a, 's> {
    pass: Pass<'a>,
    /// For each atom and gate the truth values wanted of it.
    sides: &'s mut Vec<u8>,
    visits: u64,
    depth: u32,
    exact: bool,
}

/// Parts connected by contested atoms.
struct Group {
    parts: Vec<u32>,
    /// An atom or gate that the best ways to the parts want both true and false.
    torn: Option<Ref>,
}

impl Search<'_, '_> {
    /// The way to the goal with the highest value, if that exceeds the floor.
    fn solve(&mut self, worth: Worth, floor: i64) -> Option<Way> {
        self.pass.worth = worth;
        let number = self.pass.program.shape().parts().len() as u32;
        if number == 0 { self.relaxed(floor) } else { self.parts(&(0..number).collect::<Vec<u32>>(), floor) }
    }

    /// The same, ignoring contradictions.
    fn relaxed(&mut self, floor: i64) -> Option<Way> {
        self.pass.run();
        let way = self.pass.way(self.pass.program.root());
        (way.possible && self.pass.worth.value(way) > floor).then_some(way)
    }

    /// The best way to some parts of the goal.
    fn parts(&mut self, parts: &[u32], floor: i64) -> Option<Way> {
        let bound = self.recompute(parts);
        let mut value = self.pass.worth.value(bound);
        if !bound.possible || value <= floor {
            return None;
        }
        let mut sum = Way::NOTHING;
        // Ways are read before atoms are fixed for a search in one of the groups.
        let groups = self.groups(parts).into_iter().map(|group| (self.sum(&group.parts), group));
        for (way, group) in groups.collect::<Vec<_>>() {
            let way = match group.torn {
                None => way,
                Some(torn) => {
                    value -= self.pass.worth.value(way);
                    let best = self.branch(&group.parts, torn, floor.saturating_sub(value))?;
                    value += self.pass.worth.value(best);
                    best
                }
            };
            sum = sum.and(way);
        }
        Some(sum)
    }

    /// Computes the ways to some parts anew.
    fn recompute(&mut self, parts: &[u32]) -> Way {
        let program = self.pass.program;
        for &part in parts {
            let gates = &program.shape().parts()[part as usize].gates;
            self.visits += gates.len() as u64 + 1;
            gates.iter().for_each(|&gate| self.pass.run_gate(gate as usize));
        }
        self.sum(parts)
    }

    fn sum(&self, parts: &[u32]) -> Way {
        let all = self.pass.program.shape().parts();
        parts.iter().fold(Way::NOTHING, |sum, &part| sum.and(self.pass.way(all[part as usize].of)))
    }

    /// Fixes an atom or gate to true and to false in turn, its current truth value first.
    fn branch(&mut self, parts: &[u32], torn: Ref, mut floor: i64) -> Option<Way> {
        if self.visits > VISITS || self.depth == DEEPEST {
            self.exact = false;
            return None;
        }
        self.depth += 1;
        let mut best = None;
        let so = torn.negated_if(!self.pass.program.value(self.pass.met.now, torn));
        for barred in [!so, so] {
            self.pass.bar(barred, true);
            if let Some(way) = self.parts(parts, floor) {
                (floor, best) = (self.pass.worth.value(way), Some(way));
            }
            self.pass.bar(barred, false);
        }
        self.depth -= 1;
        best
    }

    /// Groups the parts connected by contested atoms, and finds where their best ways contradict
    /// each other or themselves.
    fn groups(&mut self, parts: &[u32]) -> Vec<Group> {
        let program = self.pass.program;
        let all = program.shape().parts();
        self.sides.clear();
        self.sides.resize(program.atoms().len() + program.gates().len(), 0);
        let mut groups: Vec<Group> = Vec::new();
        let mut owner: Vec<u32> = vec![u32::MAX; program.atoms().len()];
        let mut place: Vec<usize> = (0..parts.len()).collect();
        for (i, &part) in parts.iter().enumerate() {
            for &atom in all[part as usize].contested.iter().filter(|&&atom| !self.pass.is_settled(atom as usize)) {
                match owner[atom as usize] {
                    u32::MAX => owner[atom as usize] = i as u32,
                    other => join(&mut place, i, other as usize),
                }
            }
        }
        let mut number = vec![usize::MAX; parts.len()];
        for (i, &part) in parts.iter().enumerate() {
            let root = top(&mut place, i);
            if number[root] == usize::MAX {
                number[root] = groups.len();
                groups.push(Group { parts: Vec::new(), torn: None });
            }
            let group = &mut groups[number[root]];
            group.parts.push(part);
            if group.torn.is_none() {
                group.torn = self.tear(all[part as usize].of);
            }
        }
        groups
    }

    /// An atom or gate for which the way to a part requires another truth value than an earlier
    /// way. Only parts of one group share atoms on which they can disagree.
    fn tear(&mut self, of: Ref) -> Option<Ref> {
        let mut open = vec![of];
        let mut order = Vec::new();
        while let Some(r) = open.pop() {
            if r.is_constant() || self.pass.is_lack_of_pairs(r) {
                continue;
            }
            if r.is_atom() || self.is_decided_by_its_ways(r) {
                let sides = &mut self.sides[self.pass.place(r)];
                *sides |= 1 << u8::from(r.is_negated());
                if *sides == 3 {
                    return Some(r.plain());
                }
            }
            if r.is_atom() {
                continue;
            }
            // Adjacent equal inputs are followed once.
            self.pass.choose(r.index(), r.is_negated(), &mut order, &mut |input| {
                if open.last() != Some(&input) {
                    open.push(input);
                }
            });
        }
        None
    }
}

impl Search<'_, '_> {
    /// Whether every way to a gate's truth contradicts every way to its falsehood, so that a search
    /// can fix the gate itself.
    fn is_decided_by_its_ways(&self, r: Ref) -> bool {
        self.pass.options == Options::Sound && self.pass.program.shape().is_pure(r.index())
    }
}

fn top(place: &mut [usize], mut at: usize) -> usize {
    while place[at] != at {
        place[at] = place[place[at]];
        at = place[at];
    }
    at
}

fn join(place: &mut [usize], a: usize, b: usize) {
    let (a, b) = (top(place, a), top(place, b));
    place[a.max(b)] = a.min(b);
}
