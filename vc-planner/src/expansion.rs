//! Expansion of macros into actions.

use vc_graph::{Action, NodeId, SceneGraph, Verb};

use crate::packed::{Op, Problem, State, Way, bit};

/// Whether a walk leads into another room where something is then dropped. The thing stays where the agent
/// stands, so the walk is needed although the later actions could be done without it.
pub(crate) fn drops_elsewhere(graph: &SceneGraph, agent: NodeId, walk: &Action, then: &[Action]) -> bool {
    let leads_to = walk.object.and_then(|id| graph.room_of(id));
    leads_to != graph.room_of(agent) && then.iter().any(|a| a.verb == Verb::Drop)
}

/// Expands macros, with the things that they concern.
pub(crate) struct Expansion<'a> {
    problem: &'a Problem,
    state: State,
    /// The items that are carried or put down temporarily, with their kind plus one.
    carried: Vec<(u8, NodeId)>,
    actions: Vec<Action>,
}

impl<'a> Expansion<'a> {
    /// The actions of macros from a state.
    pub(crate) fn write(problem: &'a Problem, start: State, ops: &[Op]) -> Vec<Action> {
        let carried = start.hands.iter().zip(problem.held).filter_map(|(&kind, id)| id.map(|id| (kind, id))).collect();
        let mut expansion = Self { problem, state: start, carried, actions: Vec::with_capacity(4 * ops.len()) };
        for &op in ops {
            expansion.op(op);
            let _ = expansion.problem.apply(&mut expansion.state, op);
        }
        expansion.actions
    }

    fn act(&mut self, action: Action) {
        self.actions.push(action);
    }

    fn go(&mut self, spot: u8) {
        if self.state.at & bit(spot) == 0 {
            self.act(Action::one(Verb::Walk, self.problem.spots[spot as usize].anchor));
        }
    }

    fn open(&mut self, door: Option<u8>) {
        if let Some(d) = door.filter(|d| self.state.open & bit(*d) == 0) {
            self.act(Action::one(Verb::Open, self.problem.doors[d as usize].node));
        }
    }

    /// Takes an item of a kind out of the carried ones.
    fn take(&mut self, kind: u8) -> Option<NodeId> {
        let position = self.carried.iter().position(|(k, _)| *k == kind)?;
        Some(self.carried.remove(position).1)
    }

    fn op(&mut self, op: Op) {
        match op {
            Op::Start => {}
            Op::Fetch(p) => self.fetch(p),
            Op::Deliver { hand, need, way } => self.deliver(hand, need, way),
            Op::Open(d) => {
                self.go(self.problem.doors[d as usize].spot);
                self.open(Some(d));
            }
            Op::Close(d) => {
                let door = &self.problem.doors[d as usize];
                self.go(door.spot);
                self.act(Action::one(Verb::Close, door.node));
            }
            Op::Flip(w) => {
                let switch = &self.problem.switches[w as usize];
                self.go(switch.spot);
                self.open(switch.door);
                let verb = if self.state.on & bit(w) != 0 { Verb::SwitchOff } else { Verb::SwitchOn };
                self.act(Action::one(verb, switch.node));
            }
            Op::Use { need, way } => self.make_use(need, way),
            Op::UseHeld { hand, need } => {
                let kind = self.state.hands[hand as usize];
                let held = self.carried.iter().find(|(k, _)| *k == kind).map(|c| c.1);
                let verb = self.problem.needs[need as usize].ways.iter().find_map(|w| match w {
                    Way::UseHeld { verb } => Some(*verb),
                    _ => None,
                });
                if let (Some(verb), Some(id)) = (verb, held) {
                    self.act(Action::one(verb, id));
                }
            }
            Op::PutDown { hand, spot } => self.put_down(hand, spot),
            Op::PickUp(slot) => {
                let kind = self.state.down[slot as usize];
                if let Some(&(_, id)) = self.carried.iter().rev().find(|(k, _)| *k == kind) {
                    if !self.state.fresh {
                        self.act(Action::one(Verb::Walk, id));
                    }
                    self.act(Action::one(Verb::Grab, id));
                }
            }
        }
    }

    fn fetch(&mut self, p: u8) {
        let pile = &self.problem.piles[p as usize];
        self.go(pile.spot);
        self.open(pile.door);
        let taken = (pile.units & !self.state.piles).count_ones();
        if let Some(&id) = pile.items.get(taken as usize) {
            self.carried.push((pile.kind + 1, id));
            self.act(Action::one(Verb::Grab, id));
        }
    }

    fn deliver(&mut self, hand: u8, need: u8, way: u8) {
        let Way::Put { verb, at, spot, door } = self.problem.needs[need as usize].ways[way as usize] else { return };
        self.go(spot);
        self.open(door);
        if let Some(id) = self.take(self.state.hands[hand as usize]) {
            self.act(match verb {
                Verb::Drop => Action::one(verb, id),
                _ => Action::two(verb, id, at),
            });
        }
    }

    fn make_use(&mut self, need: u8, way: u8) {
        let Way::Use { verb, on, spot, door, .. } = self.problem.needs[need as usize].ways[way as usize] else {
            return;
        };
        if let Some(spot) = spot {
            self.go(spot);
        }
        self.open(door);
        self.act(on.map_or(Action::zero(verb), |id| Action::one(verb, id)));
    }

    /// Puts an item on a surface at hand, otherwise on the floor.
    fn put_down(&mut self, hand: u8, spot: Option<u8>) {
        if let Some(spot) = spot {
            self.go(spot);
        }
        let kind = self.state.hands[hand as usize];
        let Some(position) = self.carried.iter().position(|(k, _)| *k == kind) else { return };
        let id = self.carried[position].1;
        if self.problem.kind(kind) == 0 {
            self.carried.remove(position);
        }
        let spots = &self.problem.spots;
        let reach = spot.map_or(self.state.at, |spot| spots[spot as usize].reach);
        let at_hand = |i: &usize| reach & bit(*i as u8) != 0 && spots[*i].surface;
        let itself = spot.map(usize::from).filter(at_hand);
        let surface = itself.or_else(|| (0..spots.len()).find(at_hand));
        self.act(match surface {
            Some(i) => Action::two(Verb::Place, id, spots[i].anchor),
            None => Action::one(Verb::Drop, id),
        });
    }
}
