//! Actions on things at their places: doors, switches, done actions and postures.

use vc_graph::{Action, Condition, NodeId, Property, Relation, State as Word, Verb, rule};

use super::{Compiler, Lack, Result, SPARE, anchor};
use crate::demand::Demand;
use crate::open_condition::Unreachable;
use crate::packed::{BITS, MOST, Way};
use crate::small_list::SmallList;

impl Compiler<'_> {
    pub(super) fn state(&mut self, demand: &Demand<'_>, short: usize, word: Word) -> Result<()> {
        // If several things would do, the choice is made at once: first things that are in the state already
        // and that nothing else changes, then things that are handled anyway.
        let problem = &self.out.problem;
        let touched = |id: NodeId| match word {
            Word::Open | Word::Closed => problem.doors.iter().any(|d| d.node == id),
            _ => problem.switches.iter().any(|s| s.node == id),
        };
        let away = matches!(word, Word::Closed | Word::Off);
        let mut chosen = demand.subjects().to_vec();
        chosen.sort_by_cached_key(|&id| (!demand.holds(self.now, id), touched(id) == away));
        chosen.truncate(demand.number);
        chosen.retain(|id| word == Word::Open || !self.leave.awaited.contains(id));
        match word {
            Word::Open | Word::Closed => {
                for id in chosen {
                    if !self.affords(id, Property::Openable) {
                        return Err(Unreachable::NotOpenable(demand.part.to_string()));
                    }
                    let Some(spot) = self.spot(anchor(self.now.graph, id)) else { continue };
                    match self.door(id, spot) {
                        Some(d) => {
                            let wanted = &mut self.out.problem.doors[d as usize].wanted;
                            settle(wanted, word == Word::Open, demand)?;
                        }
                        None => self.out.rest = true,
                    }
                }
                Ok(())
            }
            Word::On | Word::Off => {
                for id in chosen {
                    if !self.affords(id, Property::Switchable) {
                        return Err(Unreachable::NotSwitchable(demand.part.to_string()));
                    }
                    match self.switch(id) {
                        Some(w) => {
                            let wanted = &mut self.out.problem.switches[w as usize].wanted;
                            settle(wanted, word == Word::On, demand)?;
                        }
                        None => self.out.rest = true,
                    }
                }
                Ok(())
            }
            _ if short == 0 => Ok(()),
            _ => self.uses(demand, short, word),
        }
    }

    /// States that one action at the thing brings about.
    fn uses(&mut self, demand: &Demand<'_>, short: usize, word: Word) -> Result<()> {
        let (graph, me) = (self.now.graph, self.now.agent);
        let mut ways = Vec::new();
        for &id in demand.subjects() {
            if !self.is_located(id) || demand.holds(self.now, id) || ways.len() >= short + SPARE {
                continue;
            }
            let found = rule::regress::achievers(graph, me, &Condition::In(id, word));
            let simple = found.iter().find(|a| a.object == Some(id) && a.target.is_none() && self.is_simple(a));
            if let Some(way) = simple.and_then(|a| self.use_way(a.verb, Some(id))) {
                ways.push(way);
            }
        }
        self.use_need(demand, short, ways)
    }

    pub(super) fn use_need(&mut self, _: &Demand<'_>, short: usize, ways: Vec<Way>) -> Result<()> {
        if ways.len() < short || self.out.problem.needs.len() == MOST {
            self.out.more |= ways.len() >= short;
            self.out.rest = true;
            return Ok(());
        }
        self.push_need(short, ways);
        Ok(())
    }

    /// Whether an action requires no more than being at the thing.
    fn is_simple(&self, action: &Action) -> bool {
        let (graph, me) = (self.now.graph, self.now.agent);
        rule::preconditions(graph.vocabulary(), action).iter().all(|c| match c {
            Condition::Near(_) | Condition::Accessible(_) => true,
            c if c.is_lasting() => c.holds(graph, me),
            Condition::In(..) | Condition::NotIn(..) => c.holds(graph, me),
            _ => false,
        })
    }

    fn use_way(&mut self, verb: Verb, on: Option<NodeId>) -> Option<Way> {
        let site = match on {
            Some(id) => Some(self.site(id)?),
            None => None,
        };
        let (spot, door) = (site.map(|s| s.0), site.and_then(|s| s.1));
        if self.bits as usize == BITS {
            return None;
        }
        self.bits += 1;
        Some(Way::Use { verb, on, spot, door, bit: self.bits - 1 })
    }

    /// Sitting or lying at the end. It is done last, since an agent that rests cannot walk.
    pub(super) fn posture(&mut self, demand: &Demand<'_>, verb: Verb) -> Result<()> {
        let (graph, me) = (self.now.graph, self.now.agent);
        let rests = [Relation::SittingOn, Relation::LyingOn].iter().any(|&r| graph.related(me, r).next().is_some());
        if rests || self.regress_postures || self.out.problem.last != 0 {
            self.out.rest = true;
            return Ok(());
        }
        let free = |id: &&NodeId| {
            let all = rule::preconditions(graph.vocabulary(), &Action::one(verb, **id));
            all.iter().all(|c| matches!(c, Condition::Near(_) | Condition::Accessible(_)) || c.holds(graph, me))
        };
        let seats = demand.things[1].iter().filter(|id| self.is_located(**id)).filter(free);
        let mut seats: Vec<NodeId> = seats.copied().collect();
        seats.sort_by_cached_key(|&id| !graph.near(me, id));
        seats.truncate(1 + SPARE);
        let ways: Vec<Way> = seats.into_iter().filter_map(|id| self.use_way(verb, Some(id))).collect();
        let number = self.out.problem.needs.len();
        self.use_need(demand, 1, ways)?;
        self.out.problem.last = self.out.problem.needs.get(number).map_or(0, |need| need.units);
        Ok(())
    }

    /// Leaves resting to the general planner if the goal has more parts than are packed.
    pub(super) fn rest_last(&mut self) {
        let last = self.out.problem.last;
        if last != 0 && (self.out.rest || !self.out.lacks.is_empty()) {
            self.out.start.needs &= !last;
            self.out.rest = true;
        }
    }

    /// An action that is to be done.
    pub(super) fn done_action(&mut self, demand: &Demand<'_>, short: usize, verb: Verb) -> Result<()> {
        let (graph, me) = (self.now.graph, self.now.agent);
        if verb.arity() == 0 {
            let free = rule::preconditions(graph.vocabulary(), &Action::zero(verb)).is_empty();
            let way = free.then(|| self.use_way(verb, None)).flatten();
            return self.use_need(demand, 1, way.into_iter().collect());
        }
        if verb.arity() != 1 || short != 1 || demand.subjects().is_empty() {
            self.out.rest = true;
            return Ok(());
        }
        let action = |id| Action::one(verb, id);
        let lasting = |id: &NodeId| {
            let needs = rule::preconditions(graph.vocabulary(), &action(*id));
            needs.iter().filter(|c| c.is_lasting()).all(|c| c.holds(graph, me))
        };
        let fit: Vec<NodeId> = demand.subjects().iter().copied().filter(lasting).collect();
        if fit.is_empty() {
            return Err(Unreachable::NotAfforded(demand.part.to_string()));
        }
        let needs = rule::preconditions(graph.vocabulary(), &action(fit[0]));
        let held = needs.iter().any(|c| matches!(c, Condition::Holding(_)));
        if held && needs.iter().all(|c| c.is_lasting() || matches!(c, Condition::Holding(_))) {
            let narrowed = Demand { things: [SmallList::Many(fit), SmallList::NONE], ..demand.clone() };
            return self.need(&narrowed, short, vec![Way::UseHeld { verb }]);
        }
        let known: Vec<NodeId> = fit.iter().copied().filter(|id| self.is_located(*id)).collect();
        if known.is_empty() {
            self.out.lacks.push(Lack { subjects: fit, number: 1, ways: Vec::new() });
            return Ok(());
        }
        let simple: Vec<NodeId> = known.into_iter().filter(|&id| self.is_simple(&action(id))).collect();
        let ways: Vec<Way> = simple.iter().take(1 + SPARE).filter_map(|&id| self.use_way(verb, Some(id))).collect();
        self.use_need(demand, short, ways)
    }
}

/// Sets the final state of a door or switch: a goal cannot ask for both states.
fn settle(wanted: &mut Option<bool>, to: bool, demand: &Demand<'_>) -> Result<()> {
    if *wanted == Some(!to) {
        return Err(Unreachable::Conflicting(demand.part.to_string()));
    }
    *wanted = Some(to);
    Ok(())
}
