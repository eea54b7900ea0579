//! Actions: the rule is asked, bodies move, the scene is observed again, both are
//! compared.

use nalgebra::Vector3;
use vc_graph::{Action, ChangeSet, Edge, Event, NodeId, Place, Property, Relation, SceneGraph, State, Verb, rule};
use vc_physics::BodyRole;
use vc_relations::threshold::FACING_COSINE;

use super::astray;
use super::compare::Outcome;
use super::course::Course;
use super::execute::{Execution, off_aim};
use super::settle::come_to_rest;
use super::step::{RetryOptions, Step};
use super::{ActionError, Disagreement, Environment, PhysicalRefusal, observe};

/// What is no farther away over the floor is straight above or below: one looks up, metres.
const ABOVE: f32 = 0.1;

/// What came of an action.
pub(super) struct Done {
    pub(super) changes: ChangeSet,
    pub(super) course: Course,
}

impl Environment {
    /// Lets an agent act, at once.
    ///
    /// 1. `rule::step` on a copy of the graph: what the transition rule says, or why not.
    /// 2. Bodies do each of its effects: `Floor::standing_pose` and a walk, `World::grab_with_load`,
    ///    `World::free_spot_at` and `World::put`, `World::drive`, `World::sit` ...
    /// 3. `PhysicsWorld::step`, `PhysicsWorld::put_to_sleep`: what was disturbed comes to rest.
    /// 4. `Relations::update_with` and `Relations::write`: what has moved is observed again.
    /// 5. What is observed is held against what the rule says.
    ///
    /// Takes some tenths of a millisecond in the middle; where bodies have to be pushed aside, some tens of
    /// milliseconds.
    ///
    /// ```no_run
    /// use virtualcity::{ActionError, Environment};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// match home.set_action(me, format!("open fridge.{}", fridge.0).parse()?) {
    ///     Ok(changes) => println!("{} changes", changes.changes().len()),
    ///     Err(ActionError::Refused(reasons)) => println!("it may not: {}", reasons[0]),
    ///     Err(other) => println!("it cannot: {other}"),
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// The coordinate and the rotation of an action are its [`Aim`](vc_graph::Aim): a point of the world, metres, and a
    /// heading, degrees counter-clockwise from X; see the [guide](crate::guide#actions-at-points).
    ///
    /// # Errors
    /// [`ActionError`]; then nothing has changed.
    pub fn set_action(&mut self, agent: NodeId, action: Action) -> Result<ChangeSet, ActionError> {
        self.act(agent, &action).map(|done| done.changes)
    }

    /// Lets several agents act, at once. They act in the order of their numbers, whatever
    /// the order of the list; the outcomes come in the order of the list. Who is to do two
    /// things does neither. It is [`set_action`](Self::set_action) for each.
    ///
    /// ```no_run
    /// use virtualcity::Environment;
    /// let mut home = Environment::make("apartment/42", 2)?;
    /// let agents = home.agents().to_vec();
    /// let fridge = home.graph().of_class("fridge")[0];
    /// let outcomes = home.set_actions(&[
    ///     (agents[1], "dance".parse()?),
    ///     (agents[0], format!("walk fridge.{}", fridge.0).parse()?),
    /// ]);
    /// for outcome in outcomes {
    ///     println!("{} changes", outcome?.changes().len());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_actions(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, ActionError>> {
        let done = self.in_order(actions, |home, agent, action| home.act(agent, action));
        done.into_iter().map(|d| d.map(|d| d.changes)).collect()
    }

    /// Does something for each action, in the order of the agents' numbers.
    pub(super) fn in_order<T>(
        &mut self,
        actions: &[(NodeId, Action)],
        mut act: impl FnMut(&mut Self, NodeId, &Action) -> Result<T, ActionError>,
    ) -> Vec<Result<T, ActionError>> {
        let mut order: Vec<usize> = (0..actions.len()).collect();
        order.sort_by_key(|&i| actions[i].0);
        let twice = |agent| actions.iter().filter(|(a, _)| *a == agent).count() > 1;
        let mut all: Vec<(usize, Result<T, ActionError>)> = Vec::with_capacity(actions.len());
        for index in order {
            let (agent, action) = actions[index];
            let outcome =
                if twice(agent) { Err(ActionError::Twice(self.graph.label(agent))) } else { act(self, agent, &action) };
            all.push((index, outcome));
        }
        all.sort_by_key(|(index, _)| *index);
        all.into_iter().map(|(_, outcome)| outcome).collect()
    }

    /// Does an action; once more, and with more care, where bodies failed for no fault of its own.
    pub(super) fn act(&mut self, agent: NodeId, action: &Action) -> Result<Done, ActionError> {
        if self.is_busy() {
            return Err(ActionError::Busy(self.busy()));
        }
        let done = self.attempt(agent, action, RetryOptions::default());
        match self.heeding(agent, action, done.as_ref().err()) {
            Some(care) => self.attempt(agent, action, care),
            None => done,
        }
    }

    /// What would have to be heeded for an action not to fail as it did.
    ///
    /// What lies on an edge may fall when something beside it is moved, though nobody touches it.
    /// The rule knows nothing of that, all is taken back, and from then on every action would end so:
    /// it is held where it is. Drawers that go by themselves may leave behind what leans on something
    /// in them, which is then in the way of the door: they are pushed. And an agent that turns to a thing
    /// at the edge of its reach may no longer reach it then: it stays as it stands.
    fn heeding(&self, agent: NodeId, action: &Action, failed: Option<&ActionError>) -> Option<RetryOptions> {
        match failed? {
            ActionError::Disagreement(disagreement) => {
                let astray: Vec<NodeId> = disagreement.differences.iter().map(|d| d.thing.id).collect();
                if astray.iter().all(|id| *id == agent) {
                    return Some(RetryOptions { stays: true, ..RetryOptions::default() });
                }
                let bystanders = astray.iter().all(|id| self.is_bystander(*id, agent, action));
                bystanders.then(|| RetryOptions { steadied: astray, ..RetryOptions::default() })
            }
            ActionError::Impossible { why: PhysicalRefusal::FallsOut(thing), .. } => {
                let bystander = self.is_bystander(thing.id, agent, action);
                bystander.then(|| RetryOptions { steadied: vec![thing.id], ..RetryOptions::default() })
            }
            ActionError::Impossible { why: PhysicalRefusal::Stuck { .. }, .. } => {
                Some(RetryOptions { pushes: true, ..RetryOptions::default() })
            }
            _ => None,
        }
    }

    /// Whether a thing is loose and no part of what an action is about: neither one of its things nor
    /// on or in one, nor with the agent. A thing on one that is only opened or closed has no part in that.
    pub(super) fn is_bystander(&self, id: NodeId, agent: NodeId, action: &Action) -> bool {
        let opens = matches!(action.verb, Verb::Open | Verb::Close);
        let carried = |about: NodeId| (!opens || about == agent) && self.graph.rests_at(id, about);
        let of_it = |about: NodeId| id == about || carried(about) || self.graph.rests_at(about, id);
        self.world.role(id) == Some(BodyRole::Loose) && !action.things().chain([agent]).any(of_it)
    }

    fn attempt(&mut self, agent: NodeId, action: &Action, care: RetryOptions) -> Result<Done, ActionError> {
        let mut ruled = self.graph.clone();
        let changes = rule::step(&mut ruled, agent, action).map_err(ActionError::Refused)?;
        self.undo.keep(&self.world);
        let (before, after) = (self.graph.clone(), ruled.clone());
        let step = Step { before, after, agent, action: *action, care, claims: Vec::new() };
        // The floor follows the bodies whenever it is asked.
        let (course, outcome) = Execution::new(&mut self.world, &mut self.floor, &self.start, &step).all();
        let folded = course.folded();
        let done = outcome.and_then(|()| self.finish(agent, action, ruled, changes, &folded));
        let done = done.map_err(|error| unsteady(error, course.balanced()));
        match &done {
            Ok(changes) => {
                self.clock.changed_by(changes);
                self.history.push(Event { agent, action: *action });
                self.undo.push(step);
                if !folded.is_empty() {
                    self.look_anew();
                }
            }
            Err(_) => self.undo.take_back(&mut self.world, &mut self.floor, &self.start),
        }
        if done.as_ref().is_err_and(was_looked_at) {
            self.look_at_all();
        }
        done.map(|changes| Done { changes, course })
    }

    /// Lets bodies come to rest, observes, compares, and keeps what is observed.
    fn finish(
        &mut self,
        agent: NodeId,
        action: &Action,
        ruled: SceneGraph,
        changes: ChangeSet,
        folded: &[(NodeId, Vector3<f32>)],
    ) -> Result<ChangeSet, ActionError> {
        come_to_rest(&mut self.world);
        if let Some(why) = off_aim(&self.world, &self.graph, agent, action) {
            return Err(ActionError::Impossible { action: action.describe(&self.graph).to_string(), why });
        }
        let mut observed = ruled.clone();
        let mut edit = observed.edit();
        // They are there, and their scales are sound.
        folded.iter().for_each(|(id, scale)| drop(edit.set_scale(*id, *scale)));
        let sizes = edit.commit();
        // An agent that only waves is where it was, and so is all around it.
        let acted = (!changes.changes().is_empty()).then_some(agent);
        let changed: Vec<NodeId> = changes.changes().iter().filter_map(holder).chain(acted).collect();
        let looked = observe::look_again(&mut observed, &self.start, &self.world, &mut self.relations, &changed);
        let action_text = action.describe(&self.graph).to_string();
        let impossible = |why| ActionError::Impossible { action: action_text.clone(), why };
        let (met, seen) = looked.map_err(impossible)?;
        if let Some(id) = astray::fell_out(&self.world, &seen) {
            return Err(impossible(PhysicalRefusal::FallsOut(ruled.label(id))));
        }
        let faced = keep_facing(&mut observed, &ruled, agent).then(lay_through(&mut observed, &ruled, &changed));
        let outcome = Outcome { before: &self.graph, ruled: &ruled, observed: &observed, world: &self.world };
        let differences = outcome.differences(agent, action, &changes, &met);
        if !differences.is_empty() {
            return Err(Disagreement { action: action_text, differences }.into());
        }
        self.graph = observed;
        Ok(changes.then(sizes).then(seen).then(faced))
    }

    /// Reads all relations anew from the graph and the bodies as they are.
    pub(super) fn look_at_all(&mut self) {
        let mut relations = self.start.relations.clone();
        let read = relations.rebuild(&self.graph);
        // All of it was read before, so it can be read again.
        if read.and_then(|()| relations.set_evidence(&self.graph, observe::evidence(&self.world))).is_ok() {
            self.relations = relations;
        }
    }
}

/// Adds the places that the rule expects below a cover: a plate on a tablecloth is on the table too, as
/// the rule knows no cloth.
pub(super) fn lay_through(observed: &mut SceneGraph, ruled: &SceneGraph, changed: &[NodeId]) -> ChangeSet {
    let is_cover = |id: NodeId| observed.node(id).is_some_and(|n| n.affords(Property::Cover));
    let on = |id: NodeId, graph: &SceneGraph| graph.related(id, Relation::On).collect::<Vec<NodeId>>();
    let through = |&id: &NodeId| {
        let (wanted, found) = (on(id, ruled), on(id, observed));
        let covered =
            |at: &NodeId| found.iter().any(|c| is_cover(*c) && observed.has(Edge::new(*c, Relation::On, *at)));
        let more: Vec<NodeId> = wanted.into_iter().filter(|at| !found.contains(at) && covered(at)).collect();
        let places = found.into_iter().chain(more.iter().copied()).map(|at| Place { relation: Relation::On, at });
        (!more.is_empty()).then(|| (id, places.collect::<Vec<Place>>()))
    };
    let laid: Vec<(NodeId, Vec<Place>)> = changed.iter().filter_map(through).collect();
    let mut edit = observed.edit();
    // The nodes are there and carry one another already, so this cannot fail.
    laid.into_iter().for_each(|(id, places)| drop(edit.place_as_seen(id, &places, None)));
    edit.commit()
}

/// The error of an action after which only a thing that would not stay where it was put is elsewhere: bodies know
/// that they cannot do this.
pub(super) fn unsteady(error: ActionError, balanced: Option<NodeId>) -> ActionError {
    let ActionError::Disagreement(both) = error else { return error };
    match both.differences.iter().find(|d| Some(d.thing.id) == balanced) {
        Some(own) if both.differences.iter().all(|d| d.thing.id == own.thing.id) => {
            let why = PhysicalRefusal::Unsteady(own.thing.clone());
            ActionError::Impossible { action: both.action, why }
        }
        _ => ActionError::Disagreement(both),
    }
}

/// Whether an action failed after its outcome had been observed, so that relations still are those of the
/// outcome that was taken back.
fn was_looked_at(error: &ActionError) -> bool {
    use PhysicalRefusal::{FallsOut, Unreadable, Unsteady};
    match error {
        ActionError::Impossible { why, .. } => matches!(why, FallsOut(_) | Unreadable(_) | Unsteady(_)),
        _ => true,
    }
}

/// What is somewhere else by the rule.
pub(super) fn holder(change: &vc_graph::Change) -> Option<NodeId> {
    use vc_graph::Change::{Link, Unlink};
    match change {
        Link(e) | Unlink(e) if matches!(e.relation, Relation::HoldsRight | Relation::HoldsLeft) => Some(e.to),
        Link(e) | Unlink(e) if Relation::places().contains(&e.relation) => Some(e.from),
        _ => None,
    }
}

/// Keeps what an agent has turned to, as long as it is before it. Relations know of screens and
/// pictures only that they are faced: one turns to anything.
pub(super) fn keep_facing(observed: &mut SceneGraph, ruled: &SceneGraph, agent: NodeId) -> ChangeSet {
    let before =
        |id: &NodeId| !observed.has(Edge::new(agent, Relation::Facing, *id)) && is_before(observed, agent, *id);
    let kept: Vec<NodeId> = ruled.related(agent, Relation::Facing).filter(before).collect();
    let mut edit = observed.edit();
    // Both are there.
    kept.into_iter().for_each(|id| drop(edit.relate(Edge::new(agent, Relation::Facing, id))));
    edit.commit()
}

/// Whether a thing is on the side of an agent to which its body is turned; who sits or lies turns
/// the head.
fn is_before(graph: &SceneGraph, agent: NodeId, id: NodeId) -> bool {
    let (Some(body), Some(node)) = (graph.node(agent), graph.node(id)) else { return false };
    let Some(feet) = body.pose() else { return true };
    let Some(at) = node.aabb().map(|b| b.centre()).or_else(|| node.position()) else { return true };
    let way = feet.inverse_transform_point(&at).xy().coords;
    let seated = body.is(State::Sitting) || body.is(State::Lying);
    seated || way.norm() < ABOVE || way.x >= FACING_COSINE * way.norm()
}

impl From<Disagreement> for ActionError {
    fn from(disagreement: Disagreement) -> Self {
        Self::Disagreement(Box::new(disagreement))
    }
}

impl PhysicalRefusal {
    /// Whether another body or a piece of the home is in the way, rather than the deed
    /// being beyond bodies.
    pub fn is_in_the_way(&self) -> bool {
        matches!(
            self,
            Self::NoStand(_)
                | Self::NoSpot { .. }
                | Self::ShutsIn { .. }
                | Self::KeepsOpen { .. }
                | Self::Stuck { .. }
                | Self::Unsteady(_)
        )
    }
}
