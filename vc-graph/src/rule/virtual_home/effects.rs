//! The effects of actions in VirtualHome's simulator, change by change and in its order.

use super::Memory;
use super::view::{Link, View};
use crate::node::NodeKind;
use crate::{Action, Edge, Edit, EditError, NodeId, Property, Relation, State, Verb};

type Done = Result<(), EditError>;

/// An acting agent, and the scene as its action changes it.
struct Doing<'e, 'g> {
    edit: &'e mut Edit<'g>,
    agent: NodeId,
}

impl Memory {
    pub(super) fn carry_out(&mut self, edit: &mut Edit<'_>, agent: NodeId, action: &Action) -> Done {
        let mut doing = Doing { edit, agent };
        match (action.object, action.target) {
            (None, _) => doing.stand(action.verb),
            (Some(x), None) => self.do_to(&mut doing, action.verb, x),
            (Some(x), Some(y)) => {
                match action.verb {
                    Verb::Pour => doing.pour(x, y),
                    Verb::Place => self.put(&mut doing, x, y, Link::On),
                    _ => self.put(&mut doing, x, y, Link::Inside),
                }
                Ok(())
            }
        }
    }

    fn do_to(&mut self, doing: &mut Doing<'_, '_>, verb: Verb, x: NodeId) -> Done {
        match verb {
            Verb::Walk | Verb::Run => doing.walk(x),
            Verb::Find if doing.view().stays_to_find(x) => doing.find(x),
            Verb::Find => doing.walk(x),
            Verb::TurnTo => doing.turn_to(x),
            Verb::Grab => self.grab(doing, x),
            Verb::PutBack => self.put_back(doing, x),
            Verb::Drop => self.drop(doing, x),
            Verb::Wear => doing.wear(x),
            Verb::TakeOff => doing.cut(x, Link::On, doing.agent),
            Verb::Open => return doing.change(x, State::Closed, State::Open),
            Verb::Close => return doing.change(x, State::Open, State::Closed),
            Verb::SwitchOn => return doing.change(x, State::Off, State::On),
            Verb::SwitchOff => return doing.change(x, State::On, State::Off),
            Verb::PlugIn => return doing.change(x, State::PluggedOut, State::PluggedIn),
            Verb::PlugOut => return doing.change(x, State::PluggedIn, State::PluggedOut),
            Verb::Wipe | Verb::Wash | Verb::Rinse | Verb::Scrub => return doing.change(x, State::Dirty, State::Clean),
            Verb::Sit => return doing.rest(x, Relation::SittingOn, (State::Lying, State::Sitting)),
            Verb::Lie => return doing.rest(x, Relation::LyingOn, (State::Sitting, State::Lying)),
            _ => {}
        }
        Ok(())
    }

    fn grab(&mut self, doing: &mut Doing<'_, '_>, x: NodeId) {
        let view = doing.view();
        let (hand, room, origin) = (view.free_hand(), view.room(doing.agent), view.origin(x));
        doing.cut_all(x, &[Link::On, Link::Inside, Link::Close]);
        doing.add(doing.agent, Link::Close, x);
        hand.into_iter().for_each(|hand| doing.add(doing.agent, hand, x));
        room.into_iter().for_each(|room| doing.add(x, Link::Inside, room));
        if let Some((at, link)) = origin {
            doing.add(doing.agent, Link::Close, at);
            self.taken.insert(x, (at, link));
        }
    }

    fn put(&mut self, doing: &mut Doing<'_, '_>, x: NodeId, y: NodeId, link: Link) {
        doing.let_go(x);
        doing.add(doing.agent, Link::Close, y);
        doing.add(x, Link::Close, y);
        doing.add(x, link, y);
        self.taken.remove(&x);
    }

    fn put_back(&mut self, doing: &mut Doing<'_, '_>, x: NodeId) {
        if let Some((at, link)) = self.taken.get(&x).copied() {
            self.put(doing, x, at, link);
        }
    }

    fn drop(&mut self, doing: &mut Doing<'_, '_>, x: NodeId) {
        doing.let_go(x);
        if let Some(room) = doing.view().room(doing.agent) {
            doing.add(x, Link::Inside, room);
        }
        self.taken.remove(&x);
    }
}

impl Doing<'_, '_> {
    fn view(&self) -> View<'_> {
        View { graph: self.edit.graph(), agent: self.agent }
    }

    /// Adds a relation, as VirtualCity's corresponding relation.
    fn add(&mut self, from: NodeId, link: Link, to: NodeId) {
        let is = |kind| self.view().node(to).is_some_and(|n| n.kind() == kind);
        let relation = match link {
            Link::On if is(NodeKind::Agent) => Relation::WornBy,
            Link::Inside if is(NodeKind::Room) => Relation::InRoom,
            _ => link.relations()[0],
        };
        if !self.view().has(from, link, to) {
            self.edit.link(Edge::new(from, relation, to));
        }
    }

    fn cut(&mut self, from: NodeId, link: Link, to: NodeId) {
        for &relation in link.relations() {
            self.edit.unlink(Edge::new(from, relation, to));
        }
    }

    /// Removes an object's relations of some kinds with all others, in both directions.
    fn cut_all(&mut self, id: NodeId, links: &[Link]) {
        for &link in links {
            let (from, to) = (self.view().targets(id, link), self.view().sources(link, id));
            from.into_iter().for_each(|other| self.cut(id, link, other));
            to.into_iter().for_each(|other| self.cut(other, link, id));
        }
    }

    fn let_go(&mut self, x: NodeId) {
        Link::HANDS.into_iter().for_each(|hand| self.cut(self.agent, hand, x));
    }

    fn change(&mut self, x: NodeId, leave: State, enter: State) -> Done {
        let before = self.view().node(x).map(crate::Node::states).unwrap_or_default();
        self.edit.set_states(x, before.without(leave).with(enter))
    }

    fn find(&mut self, x: NodeId) {
        self.turn_away();
        self.add(self.agent, Link::Close, x);
    }

    fn turn_to(&mut self, x: NodeId) {
        self.turn_away();
        self.add(self.agent, Link::Facing, x);
    }

    fn turn_away(&mut self) {
        let faced = self.view().targets(self.agent, Link::Facing);
        faced.into_iter().for_each(|id| self.cut(self.agent, Link::Facing, id));
    }

    /// Held objects move along but stay in the room that the agent came from, and their contents fall out.
    fn walk(&mut self, x: NodeId) {
        let Some(room) = self.view().room(x) else { return };
        let (me, before) = (self.agent, self.view().room(self.agent));
        let moving = [Link::Inside, Link::Close, Link::Facing];
        self.cut_all(me, &moving);
        let around = self.view().targets(x, Link::Inside);
        self.come_close(around.into_iter().filter(|&at| !self.view().is_room(at)).collect());
        self.come_close(self.body());
        self.add(me, Link::Inside, room);
        self.add(me, Link::Close, x);
        let held = self.view().held();
        held.iter().for_each(|&id| self.cut_all(id, &moving));
        for id in held {
            self.add(me, Link::Close, id);
            before.into_iter().for_each(|room| self.add(id, Link::Inside, room));
        }
        if self.view().is_any(x, &[Property::Surface]) {
            self.come_close(self.view().sources(Link::On, x));
        }
    }

    fn come_close(&mut self, things: Vec<NodeId>) {
        things.into_iter().for_each(|id| self.add(self.agent, Link::Close, id));
    }

    /// The body parts of all agents.
    fn body(&self) -> Vec<NodeId> {
        let graph = self.edit.graph();
        graph.nodes().map(crate::Node::id).filter(|&id| self.view().is_any(id, &[Property::BodyPart])).collect()
    }

    fn wear(&mut self, x: NodeId) {
        self.add(x, Link::On, self.agent);
        self.let_go(x);
    }

    /// The object itself, such as a bottle, is then inside; only water leaves the hand.
    fn pour(&mut self, x: NodeId, y: NodeId) {
        self.add(x, Link::Inside, y);
        if self.view().name(x) == "water" {
            self.let_go(x);
        }
    }

    /// Sits or lies down; a previous seat or bed is kept.
    fn rest(&mut self, x: NodeId, relation: Relation, (leave, enter): (State, State)) -> Done {
        self.rise();
        self.edit.unlink(Edge::new(self.agent, Relation::On, x));
        self.edit.link(Edge::new(self.agent, relation, x));
        if relation == Relation::SittingOn {
            let faced = self.view().targets(x, Link::Facing);
            faced.into_iter().for_each(|id| self.add(self.agent, Link::Facing, id));
        }
        self.change(self.agent, leave, enter)
    }

    /// The agent is then simply on the objects on which it sat or lay.
    fn rise(&mut self) {
        for relation in [Relation::SittingOn, Relation::LyingOn] {
            let seats: Vec<NodeId> = self.edit.graph().related(self.agent, relation).collect();
            for seat in seats {
                self.edit.unlink(Edge::new(self.agent, relation, seat));
                self.edit.link(Edge::new(self.agent, Relation::On, seat));
            }
        }
    }

    fn stand(&mut self, verb: Verb) -> Done {
        if verb != Verb::Stand {
            return Ok(());
        }
        self.rise();
        let before = self.view().node(self.agent).map(crate::Node::states).unwrap_or_default();
        self.edit.set_states(self.agent, before.without(State::Sitting).without(State::Lying))
    }
}
