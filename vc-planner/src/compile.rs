//! From demands in a scene to a packed problem.

mod conflict;
mod piles;
mod puts;
mod site;
mod uses;

use vc_graph::goal::{Predicate, Situation};
use vc_graph::{Condition, NodeId, Property, Relation, SceneGraph, State as Word, Verb};

use crate::demand::{Demand, Demands};
use crate::manners::Leave;
use crate::open_condition::Unreachable;
use crate::packed::{MOST, Need, Problem, State, Way, bit, run_of};
use crate::small_list::SmallList;

pub(crate) use site::{anchor, is_ground};

/// So many things of a demand are not known to be anywhere.
#[derive(Debug, Clone)]
pub(crate) struct Lack {
    pub(crate) subjects: Vec<NodeId>,
    pub(crate) number: usize,
    /// The uses for which they are needed.
    pub(crate) ways: Vec<Way>,
}

/// The demands as a packed problem, and those that are left over.
#[derive(Debug, Default)]
pub(crate) struct Compiled {
    pub(crate) problem: Problem,
    pub(crate) start: State,
    /// The things that have to be found first.
    pub(crate) lacks: Vec<Lack>,
    /// Some demand is beyond packed planning.
    pub(crate) rest: bool,
    /// Some demand found no room: it can be packed when others are met.
    pub(crate) more: bool,
}

/// How many piles of a need are kept, besides its number: the rest are no better.
const SPARE: usize = 4;

pub(crate) struct Compiler<'a> {
    now: &'a Situation<'a>,
    known: &'a dyn Fn(NodeId) -> bool,
    leave: Leave<'a>,
    out: Compiled,
    /// Things that are not to be reserved, as another demand lacks them.
    contested: &'a [NodeId],
    /// Things that serve the goal where they are.
    reserved: Vec<NodeId>,
    /// Reserved things that would have to serve a demand that conflicts.
    disputed: Vec<NodeId>,
    /// Items with the needs they serve.
    items: Vec<(NodeId, u32)>,
    bits: u8,
    regress_postures: bool,
}

type Result<T> = std::result::Result<T, Unreachable>;

/// Compiles what can be packed of some demands.
///
/// # Errors
/// [`Unreachable`] if a demand cannot be met by anything there is.
pub(crate) fn compile(
    demands: &Demands<'_>,
    now: &Situation<'_>,
    known: &dyn Fn(NodeId) -> bool,
    leave: Leave<'_>,
) -> Result<Compiled> {
    if let Some(part) = demands.refuted {
        return Err(Unreachable::NoInstance(part.to_string()));
    }
    let number = demands.all.len();
    let mut contested: Vec<NodeId> = Vec::new();
    loop {
        let problem = Problem::for_demands(number);
        let mut c = Compiler {
            now,
            known,
            leave,
            out: Compiled { problem, rest: demands.rest, ..Compiled::default() },
            contested: &contested,
            reserved: Vec::new(),
            disputed: Vec::new(),
            items: Vec::with_capacity(2 * number),
            bits: 0,
            regress_postures: demands.regress_postures,
        };
        let done = c.run(demands);
        // A thing that serves one part where it is may be all there is for another.
        match (done, c.disputed) {
            (Err(Unreachable::Conflicting(_)), disputed) if !disputed.is_empty() => contested.extend(disputed),
            (done, _) => return done.map(|()| c.out),
        }
    }
}

impl Compiler<'_> {
    fn graph(&self) -> &SceneGraph {
        self.now.graph
    }

    fn run(&mut self, demands: &Demands<'_>) -> Result<()> {
        let mut open = Vec::with_capacity(demands.all.len());
        for demand in &demands.all {
            if let Some(short) = self.reserve(demand) {
                open.push((demand, short));
            }
        }
        // Packed plans do not tell the hands apart: where the goal does, what is held is left to regression.
        let in_hand =
            |d: &Demand<'_>| matches!(d.predicate, Predicate::Relation(Relation::HoldsRight | Relation::HoldsLeft));
        if demands.all.iter().any(in_hand) {
            let before = open.len();
            open.retain(|(demand, _)| demand.predicate != Predicate::Holds);
            self.out.rest |= open.len() < before;
        }
        // Which of several doors is left how is best said when it is known what is opened.
        let (words, others): (Vec<_>, Vec<_>) = open.into_iter().partition(|(d, _)| is_door_or_switch(d));
        others.into_iter().try_for_each(|(demand, short)| self.demand(demand, short))?;
        self.hands();
        self.piles();
        if self.out.more {
            // Doors are closed, and machines started, when all the rest is done.
            self.out.rest |= !words.is_empty();
        } else {
            words.into_iter().try_for_each(|(demand, short)| self.demand(demand, short))?;
        }
        if let Some(touched) = self.leave.tidy {
            self.tidy_up(touched);
        }
        self.rest_last();
        self.finish();
        Ok(())
    }

    /// Reserves the things for which the demand holds already; returns how many are short.
    fn reserve(&mut self, demand: &Demand<'_>) -> Option<usize> {
        if demand.subjects().is_empty() {
            let done = self.now.holds(demand.predicate, [None, None]);
            return (!done || demand.number == 0).then_some(1);
        }
        let mut met = 0;
        for &id in demand.subjects() {
            if met == demand.number {
                break;
            }
            let moved = moves(demand.predicate);
            let fixed = !moved || !(self.contested.contains(&id) || self.is_passing(demand, id));
            if (self.known)(id) && demand.holds(self.now, id) && fixed {
                met += 1;
                if moved {
                    self.reserved.push(id);
                }
            }
        }
        // A door or switch that is right must be so in the end as well.
        if is_door_or_switch(demand) && met == demand.number {
            return Some(0);
        }
        (met < demand.number).then_some(demand.number - met)
    }

    /// Whether a thing is carried: it is in a room only until the agent leaves it.
    fn is_passing(&self, demand: &Demand<'_>, id: NodeId) -> bool {
        demand.predicate != Predicate::Holds && self.graph().holder(id).is_some_and(|hand| hand.at == self.now.agent)
    }

    fn demand(&mut self, demand: &Demand<'_>, short: usize) -> Result<()> {
        let me = self.now.agent;
        match demand.predicate {
            Predicate::Relation(Relation::On) if !demand.things[0].contains(&me) && !demand.things[1].contains(&me) => {
                self.carry(demand, short, Verb::Place)
            }
            Predicate::Relation(Relation::Inside | Relation::InRoom) if !demand.things[0].contains(&me) => {
                self.carry(demand, short, Verb::PutIn)
            }
            Predicate::Holds if *demand.things[0] == [me] => self.keep(demand, short),
            Predicate::Relation(Relation::SittingOn) if *demand.things[0] == [me] => self.posture(demand, Verb::Sit),
            Predicate::Relation(Relation::LyingOn) if *demand.things[0] == [me] => self.posture(demand, Verb::Lie),
            Predicate::State(word) if *demand.things[0] != [me] => self.state(demand, short, word),
            Predicate::Did(verb) => self.done_action(demand, short, verb),
            _ => {
                self.out.rest = true;
                Ok(())
            }
        }
    }

    fn carry(&mut self, demand: &Demand<'_>, short: usize, verb: Verb) -> Result<()> {
        if demand.counted != 0 {
            self.out.rest = true;
            return Ok(());
        }
        let ways = self.puts(demand, verb)?;
        self.need(demand, short, ways)
    }

    fn keep(&mut self, demand: &Demand<'_>, short: usize) -> Result<()> {
        let need = self.out.problem.needs.len();
        self.need(demand, short, vec![Way::Keep])?;
        if need < MOST {
            self.out.problem.keeps |= 1 << need;
        }
        Ok(())
    }

    /// A need that items serve.
    fn need(&mut self, demand: &Demand<'_>, mut short: usize, ways: Vec<Way>) -> Result<()> {
        let number = self.out.problem.needs.len();
        if number == MOST || ways.is_empty() {
            self.out.more |= number == MOST;
            self.out.rest = true;
            return Ok(());
        }
        let keep = matches!(ways[0], Way::Keep);
        let graph = self.now.graph;
        let graspable = |id: &NodeId| Condition::Graspable(*id).holds(graph, self.now.agent);
        let free = |id: &NodeId| keep || !self.reserved.contains(id);
        let (mut known, mut missing, mut fit) = (SmallList::NONE, Vec::new(), 0);
        for &id in demand.subjects().iter().filter(|id| graspable(id)) {
            fit += 1;
            match (self.known)(id) {
                true if free(&id) => known.push(id),
                true => {}
                false => missing.push(id),
            }
        }
        if fit == 0 && !demand.subjects().is_empty() {
            return Err(Unreachable::NotGraspable(demand.part.to_string()));
        }
        if fit < demand.number {
            return Err(Unreachable::NoInstance(demand.part.to_string()));
        }
        if self.leave.in_company {
            let before = known.len();
            known = known.iter().copied().filter(|&id| !self.is_held_by_another(id)).collect();
            short = short.saturating_sub(before - known.len());
        }
        if missing.is_empty() {
            self.check_reach(demand, &known, short)?;
        }
        if known.len() < short {
            if missing.is_empty() {
                self.disputed = demand.subjects().iter().copied().filter(|id| self.reserved.contains(id)).collect();
                return Err(Unreachable::Conflicting(demand.part.to_string()));
            }
            self.out.lacks.push(Lack { subjects: missing, number: short - known.len(), ways: ways.clone() });
        }
        for &id in known.iter() {
            match self.items.iter_mut().find(|(item, _)| *item == id) {
                Some((_, serves)) => *serves |= 1 << number,
                None => self.items.push((id, 1 << number)),
            }
        }
        self.push_need(short.min(known.len()), ways);
        Ok(())
    }

    /// Whether some items can be got at, and so many are not in the hands of others.
    fn check_reach(&self, demand: &Demand<'_>, items: &[NodeId], number: usize) -> Result<()> {
        let graph = self.graph();
        let part = || demand.part.to_string();
        if items.iter().all(|&id| graph.room_of(id).is_none() && graph.holder(id).is_none()) && !items.is_empty() {
            return Err(Unreachable::NoRoute(part()));
        }
        let free = items.iter().filter(|&&id| !self.is_held_by_another(id)).take(number).count();
        if items.len() >= number && free < number {
            return Err(Unreachable::HeldByAnother(part()));
        }
        // A machine that runs and has no switch is never opened.
        let runs_on = |id: NodeId| {
            graph.node(id).is_some_and(|n| {
                let harmless = n.affords(Property::Cooler) || n.affords(Property::Heater);
                n.is(Word::On) && !harmless && !n.affords(Property::Switchable)
            })
        };
        let sealed = |id: &NodeId| graph.hidden_in(*id).is_some_and(runs_on);
        if items.iter().all(sealed) && !items.is_empty() { Err(Unreachable::Sealed(part())) } else { Ok(()) }
    }

    pub(super) fn is_held_by_another(&self, id: NodeId) -> bool {
        let (graph, me) = (self.now.graph, self.now.agent);
        graph.holder(id).is_some_and(|holder| holder.at != me)
            || Condition::NotElsewhereHeld(id).check(graph, me).is_err()
    }

    fn push_need(&mut self, number: usize, ways: Vec<Way>) {
        let spots = ways.iter().fold(0, |bits, way| match way {
            Way::Put { spot, .. } | Way::Use { spot: Some(spot), .. } => bits | bit(*spot),
            _ => bits,
        });
        let units = run_of(self.out.start.needs, number);
        // Units for which no bits are left are planned later.
        self.out.more |= units.count_ones() < number as u32;
        self.out.rest |= self.out.more;
        self.out.start.needs |= units;
        self.out.problem.needs.push(Need { ways, units, spots });
    }

    /// Whether it is known where a thing is: it has been seen, or belongs to the home.
    fn is_located(&self, id: NodeId) -> bool {
        (self.known)(id) || !self.affords(id, Property::Graspable)
    }

    fn affords(&self, id: NodeId, property: Property) -> bool {
        self.graph().node(id).is_some_and(|n| n.affords(property))
    }
}

fn is_door_or_switch(demand: &Demand<'_>) -> bool {
    matches!(demand.predicate, Predicate::State(Word::Open | Word::Closed | Word::On | Word::Off))
}

/// Whether moving a thing undoes a predicate about it.
fn moves(predicate: Predicate) -> bool {
    matches!(predicate, Predicate::Relation(Relation::On | Relation::Inside | Relation::InRoom) | Predicate::Holds)
}
