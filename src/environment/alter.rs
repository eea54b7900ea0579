//! Changes that are no actions: things appear or are put elsewhere, agents are elsewhere at once.

use std::sync::Arc;

use nalgebra::Point2;
use vc_graph::{
    ChangeSet, Class, Draft, EditError, Effect, Label, Node, NodeId, ObjectRole, Place, Pose, Property, Relation,
    SceneBuilder, SceneGraph, Seed, State, did_you_mean, rule,
};
use vc_physics::{BodyRole, Floor, Posture};
use vc_tasks::initial::Stock;

use super::settle::come_to_rest;
use super::{
    Displaced, Environment, PhysicalRefusal, Unplaced, UnplacedReason, execute, make, observe, outlook, reset, stale,
};
use crate::catalogue::Catalogue;

/// Number of rings, half a metre apart, around the middle of a room in which a free place is sought.
const RINGS: i32 = 12;
/// How far from a point that is not free the nearest free floor is sought, metres.
const INSTEAD: f32 = 2.0;

/// Why something was not put where it was to be; then nothing has changed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AlterError {
    /// The class table knows no such class.
    #[error(
        "there is no class `{class}`{}: `graph().classes()` lists them",
        did_you_mean(.class, .nearest.iter().map(String::as_str))
    )]
    NoSuchClass {
        /// The name of none.
        class: String,
        /// The names of classes that are nearest to it.
        nearest: Vec<String>,
    },
    /// There is no generator for things of the class.
    #[error("there is no generator for the class `{0}`: `shapes::object::generators` lists those that have one")]
    NoGenerator(String),
    /// Things of the class are not set down in a home.
    #[error("no {class} is set down in a home: {why}")]
    NoThing {
        /// The class.
        class: String,
        /// Why not, and what to do instead.
        why: &'static str,
    },
    /// Things are not put on people.
    #[error("{0} is an agent: things get into its hands by `grab`, onto its body by `wear`")]
    OnAgent(Label),
    /// The node is not there.
    #[error("there is no node {0}")]
    NoSuchNode(NodeId),
    /// Things are put on or in others; nothing else can be asked for.
    #[error("a thing is put `on` or `inside` something, or `in_room` a room, not `{0}` something")]
    NotAPlace(Relation),
    /// The thing is part of the home, or held or worn by somebody.
    #[error("{0} cannot be put elsewhere: it is fixed, held or worn")]
    NotLoose(Label),
    /// There is no place for the thing.
    #[error(transparent)]
    Unplaced(Unplaced),
    /// The thing does not stay there.
    #[error("it does not stay there: {0}")]
    Elsewhere(Displaced),
    /// Agents are doing something that takes time or are under control, and would be disturbed.
    #[error("{} acting or under control: let them finish with `step_until_idle`, or `interrupt` them", are(.0))]
    Busy(Vec<Label>),
    /// The node is no agent of this environment.
    #[error("{0} is no agent of this environment")]
    NotAnAgent(Label),
    /// An agent was to be put into something that is no room.
    #[error("{0} is no room: name a room, or a point of the floor")]
    NotARoom(Label),
    /// Nobody can stand there.
    #[error("nobody can stand at {:.2}, {:.2}{}", .at[0], .at[1], instead(.nearest))]
    NoFloor {
        /// Where somebody was to stand, metres.
        at: [f32; 2],
        /// Where the free floor nearest to it is, metres.
        nearest: Option<[f32; 2]>,
    },
    /// There is no free floor in a room.
    #[error("there is no free floor in {0}")]
    FullRoom(Label),
    /// The bodies do not allow it.
    #[error(transparent)]
    Bodies(#[from] PhysicalRefusal),
    /// The graph does not allow it.
    #[error(transparent)]
    Edit(#[from] EditError),
}

fn are(labels: &[Label]) -> String {
    format!("{} {}", super::error::in_a_row(labels), if labels.len() == 1 { "is" } else { "are" })
}

fn instead(nearest: &Option<[f32; 2]>) -> String {
    nearest.map_or_else(String::new, |[x, y]| format!(": the free floor nearest to it is at {x:.2}, {y:.2}"))
}

/// Where an agent is put.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Spot {
    /// At a point of the floor, metres.
    At(Point2<f32>),
    /// Somewhere in a room, near its middle.
    Room(NodeId),
}

impl From<Point2<f32>> for Spot {
    fn from(point: Point2<f32>) -> Self {
        Self::At(point)
    }
}

impl From<NodeId> for Spot {
    fn from(room: NodeId) -> Self {
        Self::Room(room)
    }
}

impl Environment {
    /// Adds a thing of a class at a place: on or in something, or on the floor of a room, for which a room stands
    /// with any of these relations. It looks as the generator makes it, the same in the same scene, and comes to
    /// rest. The history is kept, and other things stay as they are: [`reset`](Self::reset) with an edited graph
    /// begins anew instead.
    ///
    /// `PhysicsWorld::insert`, `SpotSearch`, `PhysicsWorld::step`, `Relations::rebuild`. Costs some
    /// milliseconds.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::{Place, Relation};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let table = home.graph().of_class("coffee_table")[0];
    /// let apple = home.spawn("apple", Place { relation: Relation::On, at: table })?;
    /// assert_eq!(home.graph().label(apple).to_string(), format!("apple.{}", apple.0));
    /// assert!(home.world().supports(apple).contains(&table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`AlterError`]; then nothing has changed.
    pub fn spawn(&mut self, class: &str, place: Place) -> Result<NodeId, AlterError> {
        self.altered(|home| home.add(class, place))
    }

    fn add(&mut self, class: &str, place: Place) -> Result<NodeId, AlterError> {
        let known = self.graph.classes().get(class).ok_or_else(|| self.no_such_class(class))?;
        if let Some(why) = no_thing(known) {
            return Err(AlterError::NoThing { class: known.name.to_string(), why });
        }
        let place = self.checked(place)?;
        let mut library = self.graph.assets().as_ref().clone();
        let seed = Seed(self.graph.len() as u64).child("spawn");
        let draft = Catalogue::default().thing(known, seed, &self.graph, &mut library);
        let draft: Draft = draft.ok_or_else(|| AlterError::NoGenerator(known.name.to_string()))?;
        let mut builder = SceneBuilder::from_graph(self.graph.clone());
        builder.assets(Arc::new(library));
        // Somewhere far below, until it has a spot.
        let id = builder.add(draft.at(Pose::translation(0.0, 0.0, reset::BELOW)))?;
        let mut edit = builder.edit();
        edit.place(id, place)?;
        edit.commit();
        self.graph = builder.build();
        let inserted = self.world.insert(&self.graph, id, &self.start.shapes);
        inserted.map_err(|e| self.impossible(e))?;
        self.set_down(id, place)?;
        observe::write_poses_of(&mut self.graph, &self.world, &[id], &[id])?;
        self.relations.rebuild(&self.graph).map_err(PhysicalRefusal::from)?;
        self.settle(&[id])?;
        self.stays(id, place)?;
        self.look_anew();
        Ok(id)
    }

    /// Puts a thing at a place at once, together with its load: on or in something, or on the floor of a room.
    /// A thing that hung or was held in place is taken down. The history is kept, and other things stay as they are.
    ///
    /// `SpotSearch`, `PhysicsWorld::place`, `PhysicsWorld::step`, `Relations::update_nodes`. Costs a
    /// millisecond or two.
    ///
    /// # Errors
    /// [`AlterError`]; then nothing has changed.
    pub fn put(&mut self, thing: NodeId, place: Place) -> Result<(), AlterError> {
        self.altered(|home| home.move_to(thing, place))
    }

    fn move_to(&mut self, thing: NodeId, place: Place) -> Result<(), AlterError> {
        self.graph.node(thing).ok_or(AlterError::NoSuchNode(thing))?;
        let place = self.checked(place)?;
        let moves = |role| matches!(role, BodyRole::Loose | BodyRole::Hung);
        let Some(before) = self.world.pose(thing).filter(|_| self.world.role(thing).is_some_and(moves)) else {
            return Err(AlterError::NotLoose(self.graph.label(thing)));
        };
        let load =
            self.graph.carried_with(thing).into_iter().filter(|id| execute::comes_along(&self.graph, *id, thing));
        let load: Vec<(NodeId, Pose)> = load.filter_map(|id| Some((id, self.world.pose(id)?))).collect();
        self.set_down(thing, place)?;
        // A thing that hung is taken down.
        self.world.wake(thing).map_err(|e| self.impossible(e))?;
        let motion = self.world.pose(thing).map_or_else(Pose::identity, |pose| pose * before.inverse());
        for (id, pose) in &load {
            let along = stale::take_along(&mut self.world, (*id, motion * pose), thing);
            along.map_err(|e| self.impossible(e))?;
        }
        // The contents change rooms with it before relations are read.
        let mut edit = self.graph.edit();
        edit.place(thing, place)?;
        edit.commit();
        let moved: Vec<NodeId> = load.into_iter().map(|(id, _)| id).chain([thing]).collect();
        self.settle(&moved)?;
        self.stays(thing, place)
    }

    /// Puts an agent elsewhere at once: at a point of the free floor, facing the same way as before, or near the
    /// middle of a room, facing where most of it is in view. The things it holds and wears come along. Where one can
    /// stand only in an open doorway, the door stands open then. The history does not contain this.
    ///
    /// `Floor::is_free`, `PhysicsWorld::teleport`, `Relations::update_nodes`. Costs a millisecond or two.
    ///
    /// ```
    /// use virtualcity::nalgebra::Point2;
    /// use virtualcity::{AlterError, Environment};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let kitchen = home.graph().of_class("kitchen")[0];
    /// home.teleport(me, kitchen)?;
    /// assert_eq!(home.graph().room_of(me), Some(kitchen));
    /// let outside = home.teleport(me, Point2::new(-90.0, 0.0));
    /// assert!(matches!(outside, Err(AlterError::NoFloor { nearest: None, .. })));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`AlterError`]; then nothing has changed.
    pub fn teleport(&mut self, agent: NodeId, to: impl Into<Spot>) -> Result<(), AlterError> {
        let to = to.into();
        self.altered(|home| home.transfer(agent, to))
    }

    fn transfer(&mut self, agent: NodeId, to: Spot) -> Result<(), AlterError> {
        let Some(before) = self.world.pose(agent).filter(|_| self.agents().contains(&agent)) else {
            return Err(AlterError::NotAnAgent(self.graph.label(agent)));
        };
        self.floor.update(&self.world);
        let point = self.standing(agent, to)?;
        let feet = nalgebra::Translation3::new(point.x, point.y, self.floor.options().level);
        self.make_way(agent, &point)?;
        let turn = match to {
            Spot::Room(room) => outlook::into_room(&self.world, &self.graph, room, (agent, feet.vector.into())),
            Spot::At(_) => before.rotation,
        };
        if self.is_seated(agent) {
            rule::carry_out(&mut self.graph, agent, &Effect::StandUp)?;
        }
        self.world.teleport(agent, Pose::from_parts(feet, turn)).map_err(|e| self.impossible(e))?;
        if let Some(room) = self.room_at(point) {
            // Nothing that it was near is near any more.
            rule::carry_out(&mut self.graph, agent, &Effect::GoTo(room))?;
        }
        let held: Vec<NodeId> = self.graph.held(agent).collect();
        self.settle(&[vec![agent], held].concat())
    }

    fn no_such_class(&self, class: &str) -> AlterError {
        let nearest = self.graph.classes().nearest(class).into_iter().map(str::to_owned).collect();
        AlterError::NoSuchClass { class: class.to_owned(), nearest }
    }

    /// Opens a door, or moves what stands open, where an agent is to stand.
    fn make_way(&mut self, agent: NodeId, point: &Point2<f32>) -> Result<(), AlterError> {
        for (id, part, open) in self.gives_way(agent, point).unwrap_or_default() {
            self.world.put_open(id, Some(part), open).map_err(|e| self.impossible(e))?;
            if self.world.parts(id).state() == Some(State::Open)
                && !self.graph.node(id).is_some_and(|n| n.is(State::Open))
            {
                rule::carry_out(&mut self.graph, agent, &Effect::Enter(id, State::Open))?;
            }
        }
        Ok(())
    }

    /// Switches the home's lamps on or off at once, as people who are at home in the evening have them: all that can be
    /// switched, but those that lie about without being plugged in, as torches and spare bulbs do. Lamps without a
    /// switch of their own, as in VirtualHome's scenes, are switched by the light switches of their room, and if it has
    /// none, themselves. Gives the lamps and light switches that were switched. The history does not contain this.
    ///
    /// `Edit::enter_state`. Costs some microseconds.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let lamps = home.switch_lamps(true)?;
    /// assert!(!lamps.is_empty());
    /// assert_eq!(home.switch_lamps(false)?, lamps);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`AlterError`]; then nothing has changed.
    pub fn switch_lamps(&mut self, on: bool) -> Result<Vec<NodeId>, AlterError> {
        self.switch_lamps_where(on, |_| true)
    }

    /// As [`switch_lamps`](Self::switch_lamps), those of which a condition holds: of the rooms without a window, say.
    ///
    /// # Errors
    /// [`AlterError`]; then nothing has changed.
    pub fn switch_lamps_where(&mut self, on: bool, which: impl Fn(NodeId) -> bool) -> Result<Vec<NodeId>, AlterError> {
        let state = if on { State::On } else { State::Off };
        let lamps = self.graph.nodes().filter(|n| lights(n)).map(Node::id).filter(|id| which(*id));
        let mut lamps: Vec<NodeId> = lamps.flat_map(|lamp| self.switches(lamp)).collect();
        lamps.retain(|id| self.graph.node(*id).is_some_and(|n| n.is(State::On) != on));
        lamps.sort_unstable();
        lamps.dedup();
        self.world.differ();
        let mut edit = self.graph.edit();
        lamps.iter().try_for_each(|id| edit.enter_state(*id, state))?;
        let changes = edit.commit();
        self.clock.note(changes);
        Ok(lamps)
    }

    /// The things that switch a lamp: the light switches of its room, or itself.
    fn switches(&self, lamp: NodeId) -> Vec<NodeId> {
        let switches: Vec<NodeId> = self.graph.light_switches(lamp).collect();
        if switches.is_empty() { vec![lamp] } else { switches }
    }

    /// A place where something can be put; a room stands for its floor.
    fn checked(&self, place: Place) -> Result<Place, AlterError> {
        let in_room = place.relation == Relation::InRoom && self.graph.rooms().contains(&place.at);
        if !in_room && !matches!(place.relation, Relation::On | Relation::Inside) {
            return Err(AlterError::NotAPlace(place.relation));
        }
        self.graph.node(place.at).ok_or(AlterError::NoSuchNode(place.at))?;
        if self.agents().contains(&place.at) {
            return Err(AlterError::OnAgent(self.graph.label(place.at)));
        }
        Ok(stale::on_floor(&self.graph, place))
    }

    /// Puts a body at a free spot of a place.
    fn set_down(&mut self, id: NodeId, place: Place) -> Result<(), AlterError> {
        let placed = reset::settle_place(&mut self.world, &self.graph, (id, false), Some(place));
        let refuse = |why: UnplacedReason| AlterError::Unplaced(Unplaced { thing: self.graph.label(id), why });
        placed.map_err(|e| self.impossible(e))?.map_err(refuse)
    }

    /// Why bodies cannot do it, with the labels of the scene.
    fn impossible(&self, why: impl Into<PhysicalRefusal>) -> AlterError {
        AlterError::Bodies(why.into().in_scene(&self.graph))
    }

    /// Changes the environment, or leaves it as it is: not while agents act or are under control, since bodies come to
    /// rest here without the clock.
    fn altered<T>(&mut self, change: impl FnOnce(&mut Self) -> Result<T, AlterError>) -> Result<T, AlterError> {
        let mut next = self.clone();
        let busy = next.busy_now();
        if !busy.is_empty() {
            return Err(AlterError::Busy(busy));
        }
        let made = change(&mut next)?;
        next.clock.note(ChangeSet::between(&self.graph, &next.graph));
        *self = next;
        Ok(made)
    }

    /// Lets all come to rest and observes it. Where bodies do nothing, only what was changed is where bodies have it, and
    /// all else as the rule has it.
    fn settle(&mut self, changed: &[NodeId]) -> Result<(), AlterError> {
        come_to_rest(&mut self.world);
        if self.start.time.bodies {
            observe::look_again(&mut self.graph, &self.start, &mut self.world, &mut self.relations, changed)?;
        } else {
            observe::write_poses_of(&mut self.graph, &self.world, changed, changed)?;
            self.world.forget_moved();
        }
        self.floor.update(&self.world);
        self.clock.scene_changed();
        Ok(())
    }

    fn is_seated(&self, agent: NodeId) -> bool {
        let said = self.graph.node(agent).is_some_and(|node| node.is(State::Sitting) || node.is(State::Lying));
        said || self.world.posture(agent) != Some(Posture::Standing)
    }

    fn stays(&self, id: NodeId, wanted: Place) -> Result<(), AlterError> {
        let there = self.graph.places(id).any(|place| place == wanted);
        let told = || AlterError::Elsewhere(Displaced::new(&self.graph, id, wanted, self.graph.place(id)));
        there.then_some(()).ok_or_else(told)
    }

    /// The point at which an agent is to stand.
    fn standing(&self, agent: NodeId, spot: Spot) -> Result<Point2<f32>, AlterError> {
        match spot {
            Spot::At(at) if self.floor.is_free(at) && self.gives_way(agent, &at).is_some() => Ok(at),
            Spot::At(at) => Err(AlterError::NoFloor { at: at.into(), nearest: self.free_near(agent, &at) }),
            Spot::Room(room) if !self.graph.rooms().contains(&room) => {
                Err(AlterError::NotARoom(self.graph.label(room)))
            }
            Spot::Room(room) => {
                let free = |p: &Point2<f32>| self.room_at(*p) == Some(room) && self.stands_at(agent, p);
                let found = spot_in(&self.graph, &self.floor, room, free);
                found.ok_or_else(|| AlterError::FullRoom(self.graph.label(room)))
            }
        }
    }

    /// The middle of the cell nearest to a point where an agent can stand.
    fn free_near(&self, agent: NodeId, at: &Point2<f32>) -> Option<[f32; 2]> {
        self.free_near_where(agent, at, |_| true)
    }

    /// As [`Self::free_near`], of the points for which something holds.
    pub(super) fn free_near_where(
        &self,
        agent: NodeId,
        at: &Point2<f32>,
        holds: impl Fn(&Point2<f32>) -> bool,
    ) -> Option<[f32; 2]> {
        let grid = self.floor.occupancy();
        let cells = (0..grid.rows).flat_map(|row| (0..grid.columns).map(move |column| (column, row)));
        let free = cells.filter(|(column, row)| grid.is_free(*column, *row));
        let mut near: Vec<Point2<f32>> = free.map(|(column, row)| grid.centre(column, row)).collect();
        let far = |p: &Point2<f32>| (p - at).norm();
        near.retain(|p| far(p) <= INSTEAD && holds(p));
        near.sort_by(|a, b| far(a).total_cmp(&far(b)));
        near.into_iter().find(|p| self.stands_at(agent, p)).map(Into::into)
    }

    pub(super) fn stands_at(&self, agent: NodeId, at: &Point2<f32>) -> bool {
        let feet = Pose::translation(at.x, at.y, self.floor.options().level);
        // No body can be tried of somebody who is not here yet.
        let fits = || self.world.standing(agent, &feet).is_ok_and(|there| there.is_free());
        self.floor.is_free(*at) && (self.world.pose(agent).is_none() || fits())
    }
}

/// Where an agent can stand in a room, near its middle.
pub(super) fn spot_in(
    graph: &SceneGraph,
    floor: &Floor,
    room: NodeId,
    free: impl Fn(&Point2<f32>) -> bool,
) -> Option<Point2<f32>> {
    let (_, middle) = make::middle(graph, floor, room)?;
    (0..RINGS).flat_map(|ring| make::around(&middle, ring)).find(free)
}

/// Why things of a class are not set down in a home, if so.
pub(super) fn no_thing(class: &Class) -> Option<&'static str> {
    match class.role() {
        role if role == ObjectRole::Room || role.is_built_in() => {
            Some("it is part of the building; edit the scene and make an environment of it")
        }
        ObjectRole::Person => Some("agents are there from the start; ask `make` for more"),
        _ if class.affordances.contains(Property::Drivable) => Some("vehicles stay outdoors"),
        // A thing that can be poured and not grasped is a liquid: only vessels hold it.
        _ if class.affordances.contains(Property::Pourable) && !class.affordances.contains(Property::Graspable) => {
            Some("it is a liquid; let an agent `fill` a vessel")
        }
        _ => None,
    }
}

/// Whether something is a lamp that lights a home where it is.
fn lights(node: &Node) -> bool {
    let lies_about = node.affords(Property::Graspable) && !node.is(State::PluggedIn);
    node.role() == ObjectRole::Light && !lies_about
}
