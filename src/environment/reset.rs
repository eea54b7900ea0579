//! Putting a graph of the environment in force.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;
use vc_graph::{EditError, Label, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneGraph, State};
use vc_physics::{BodyRole, Floor, PhysicsError, PhysicsWorld, SpotOrder, SpotSearch};
use vc_relations::Relations;

use super::clock::Clock;
use super::settle::come_to_rest;
use super::{Environment, Past, ResetError, astray, boxes, observe, scene, seats, stale};

/// How far below a thing its support may be, metres.
const HOVER: f32 = 0.02;
/// Where things without a pose are until they have a place, metres: so high, and so far from each
/// other.
pub(super) const BELOW: f32 = -200.0;
const APART: f32 = 5.0;

/// The report of a reset.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResetReport {
    /// Things and agents that are elsewhere than where the environment began, because the graph has them there, and
    /// what came along on or in them.
    pub moved: Vec<NodeId>,
    /// Things that the environment did not begin with.
    pub added: Vec<NodeId>,
    /// Things the environment began with that the graph does not have.
    pub removed: Vec<NodeId>,
    /// Things for which there was no place; they are not in the scene.
    pub unplaced: Vec<Unplaced>,
    /// Things that are not where the graph has them, with the reason if they could not be put there, agents who stand
    /// beside what they are to sit or lie on, and agents who were put onto the floor or apart, as nobody can stand where
    /// the graph has them.
    pub elsewhere: Vec<Displaced>,
}

/// A thing for which there was no place.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{thing} has no place there: {why}")]
pub struct Unplaced {
    /// Which.
    pub thing: Label,
    /// Why.
    pub why: UnplacedReason,
}

/// Why there was no place for a thing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum UnplacedReason {
    /// No spot on or in what it is to be at is free.
    #[error(
        "no spot {relation} {at} is free and large enough for its {:.2} x {:.2} x {:.2} m: make room there, or name \
         another place",
        .size[0], .size[1], .size[2]
    )]
    NoSpot {
        /// On or inside.
        relation: Relation,
        /// The place where it is to be.
        at: Label,
        /// Its depth, width and height as it stands, metres.
        size: [f32; 3],
    },
    /// It is where nothing can be, and the scene does not say where else it belongs.
    #[error("it is below, beside or far from all floors, and the scene has it on or in nothing")]
    Astray,
    /// Neither the graph says where it is, nor does it have a pose.
    #[error("it has neither a pose nor a place on or in anything")]
    Nowhere,
    /// The thing that it is to be at is not in the scene.
    #[error("{0} has no body")]
    NoSupport(Label),
    /// Nobody can stand in the room.
    #[error("there is no free floor in {0}")]
    NoFloor(Label),
    /// Things of its class are not put elsewhere.
    #[error("it cannot be put elsewhere: {0}")]
    NotMovable(&'static str),
    /// It fell out of the home: nothing is below where it is to be.
    #[error("it fell out of the home: nothing is below it")]
    FellOut,
    /// No body can be made of it.
    #[error("it has no shape, and there is no generator for its class")]
    NoShape,
}

/// A thing that is elsewhere than it was to be. Prints as `novel.182 is not on coffee_table.104: ` and the reason.
#[derive(Debug, Clone, PartialEq)]
pub struct Displaced {
    /// Which.
    pub thing: Label,
    /// Where it was to be.
    pub wanted: Place,
    /// The label of the thing or room where it was to be.
    pub at: Label,
    /// Where it is.
    pub now: Option<Place>,
    /// The reason why it was not put there; `None` if it was, and has come to rest elsewhere.
    pub why: Option<UnplacedReason>,
}

impl Displaced {
    pub(super) fn new(graph: &SceneGraph, id: NodeId, wanted: Place, now: Option<Place>) -> Self {
        Self { thing: graph.label(id), wanted, at: graph.label(wanted.at), now, why: None }
    }
}

impl std::fmt::Display for Displaced {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} is not {} {}", self.thing, self.wanted.relation, self.at)?;
        self.why.as_ref().map_or(Ok(()), |why| write!(f, ": {why}"))
    }
}

impl Environment {
    /// Puts a graph in force: the environment's own, or one in which things have been
    /// moved, added and removed by hand or by a program. Agents are where the graph has
    /// them, states are the graph's, what was done is forgotten.
    ///
    /// | | after a reset |
    /// |---|---|
    /// | clock | at [tick](Self::tick) 0, the day and time of day at which the environment [began](crate::EnvironmentBuilder::begins_at) |
    /// | actions that were [given](Self::give), and those that go on | gone, without an ending; endings that no [`step`](Self::step) has returned are lost |
    /// | [control](Self::control) of bodies | ended |
    /// | [history](Self::history) and [changes](Self::changes) | empty |
    /// | [processes](Self::processes) | begin anew, by the states that the graph has: soup that is half cooled takes its whole time |
    /// | settings, options of pictures, cameras, sensors, threads | as they were |
    /// | [saves](Self::save) and [states](Self::save_state) from before | good |
    ///
    /// The start itself comes back bit for bit: `reset(&home.start().clone())`.
    ///
    /// It starts from the bodies as they were made, at rest, and moves only what differs
    /// (`PhysicsWorld::reset`); a thing that the graph has where it is now stays there. New things, and things with a new pose
    /// on or in something else than at the start, keep their pose if it is free and something is right below;
    /// otherwise they get the free spot nearest to it (`SpotSearch`), and if there
    /// is none, they are left out and reported. A thing that hovers by less than two centimetres is let
    /// down (`PhysicsWorld::lower`). Then all comes to rest (`PhysicsWorld::step`, `PhysicsWorld::put_to_sleep`)
    /// and is observed (`Relations::update_with`).
    ///
    /// A thing or agent that the graph has on or in something else, or in another room, with the pose that it had at
    /// the start or has now, is put there, together with what it carries: [`Edit::place`](vc_graph::Edit::place) and
    /// [`Edit::move_to_room`](vc_graph::Edit::move_to_room) suffice, and need no pose. A room stands for its floor. If
    /// there is no room for it, it stays where it was, and [`ResetReport::elsewhere`] says why.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::{Draft, Place, Relation};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let mut graph = home.start().clone();
    /// let table = graph.of_class("coffee_table")[0];
    /// let mut edit = graph.edit();
    /// let apple = edit.add(Draft::new("apple"))?;
    /// edit.place(apple, Place { relation: Relation::On, at: table })?;
    /// edit.commit();
    /// let report = home.reset(&graph)?;
    /// assert_eq!(report.added, [apple]);
    /// assert!(report.unplaced.is_empty(), "{:?}", report.unplaced);
    /// assert!(home.world().supports(apple).contains(&table));
    ///
    /// // Somebody is about to wave, and is there no more.
    /// use virtualcity::graph::clock::{Span, Tick};
    /// home.give(home.agents()[0], "wave".parse()?);
    /// home.step(Span(10));
    /// home.reset(&home.start().clone())?;
    /// assert_eq!((home.tick(), home.is_busy(), home.step(Span(0)).len()), (Tick(0), false, 0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ResetError`]; then nothing has changed.
    pub fn reset(&mut self, graph: &SceneGraph) -> Result<ResetReport, ResetError> {
        let (started, agents) = (self.start.graph.agents(), graph.agents());
        if started != agents {
            let labels = |graph: &SceneGraph, ids: &[NodeId]| ids.iter().map(|a| graph.label(*a)).collect();
            let (expected, found) = (labels(&self.start.graph, started), labels(graph, agents));
            return Err(ResetError::OtherAgents { expected, found });
        }
        if *graph == self.start.graph {
            self.begin_anew();
            return Ok(ResetReport::default());
        }
        if *graph == self.graph && self.world.awake() == 0 && self.clock.controls.is_empty() {
            self.world.differ();
            (self.past, self.poses) = (Past::default(), BTreeMap::new());
            self.clock = Clock::at(&self.world);
            return Ok(Plan::of(&[&self.start.graph], graph).report(&self.start.graph, graph, graph));
        }
        let shaped = scene::shaped(graph)?;
        let shaped = boxes::shaped(shaped.as_ref().unwrap_or(graph), self.start.assets)?.or(shaped);
        let new_shapes = shaped.is_some();
        let mut wanted = shaped.unwrap_or_else(|| graph.clone());
        let start = self.start.clone();
        let known = [&start.graph, &self.graph];
        let mut plan = Plan::of(&known, &wanted);
        let standing = self.still_there(&wanted);
        plan.open.retain(|(id, _)| standing.binary_search(id).is_err());
        plan.lend_poses(&mut wanted)?;
        stale::lend_agents(&start.graph, &mut wanted)?;
        let (mut world, how) = self.start.world.reset(&wanted, &self.start.shapes)?;
        if how.built {
            boxes::hold_as(&self.start, &mut world, &wanted)?;
        }
        undress(&mut world, &wanted)?;
        self.leave_as_they_are(&mut world, &standing)?;
        plan.settle_places(&mut world, &mut wanted)?;
        plan.lower(&mut world, &standing)?;
        let mut floor = self.start.floor.clone();
        floor.update(&world);
        let (moved, told) = stale::move_agents((&start, &known), &mut world, &mut wanted, &floor)?;
        plan.report.moved.extend(moved);
        plan.report.elsewhere.extend(told);
        plan.report.elsewhere.extend(settle_agents(&mut world, &mut wanted, &floor)?);
        come_to_rest(&mut world);
        let held = [standing.as_slice(), &plan.in_open_things(&world, &wanted)].concat();
        if boxes::hold_moved(&mut world, &wanted, &held, true)? {
            come_to_rest(&mut world);
        }
        plan.take_out(&mut world, &mut wanted)?;
        boxes::rest_as(&mut world, &wanted, &standing)?;
        plan.forget_places(&mut wanted)?;
        let relations = self.observed(&mut wanted, &world, new_shapes)?;
        floor.update(&world);
        let report = plan.report(&start.graph, graph, &wanted);
        (self.graph, self.world) = (wanted, world.into());
        (self.relations, self.floor) = (relations.into(), floor.into());
        (self.past, self.clock) = (Past::default(), Clock::at(&self.world));
        self.poses = BTreeMap::new();
        #[cfg(feature = "render")]
        if new_shapes || !report.added.is_empty() || !report.removed.is_empty() {
            self.picture_cache = std::sync::Arc::default();
        }
        Ok(report)
    }

    /// The things that a graph has where they are now, by number.
    fn still_there(&self, graph: &SceneGraph) -> Vec<NodeId> {
        let placed = |id: NodeId, graph: &SceneGraph| graph.places(id).collect::<BTreeSet<Place>>();
        let stands = |node: &&Node| {
            let now = self.graph.node(node.id()).and_then(Node::pose);
            let same =
                now.is_some() && now == node.pose() && placed(node.id(), graph) == placed(node.id(), &self.graph);
            same && self.world.role(node.id()).is_some_and(|role| role != BodyRole::Carried)
        };
        let things = graph.nodes().filter(|n| n.kind() == NodeKind::Object);
        things.filter(stands).map(Node::id).collect()
    }

    /// Opens doors and drawers of things that stay as far as they are open now, and puts all that stays where it is.
    fn leave_as_they_are(&self, world: &mut PhysicsWorld, standing: &[NodeId]) -> Result<(), PhysicsError> {
        let free = |id: &&NodeId| world.role(**id).is_some_and(|role| role != BodyRole::Carried);
        let standing: Vec<NodeId> = standing.iter().filter(free).copied().collect();
        for &id in &standing {
            if world.parts(id).state() != self.world.parts(id).state() {
                continue;
            }
            for (part, now) in self.world.parts(id).all().iter().enumerate() {
                if world.parts(id).all().get(part).is_some_and(|p| p.position != now.position) {
                    world.put_open(id, Some(part), now.open)?;
                }
            }
        }
        let pose = |id: NodeId| self.world.pose(id).filter(|pose| world.pose(id) != Some(*pose));
        let moved: Vec<(NodeId, Pose)> = standing.iter().filter_map(|id| Some((*id, pose(*id)?))).collect();
        moved.into_iter().try_for_each(|(id, pose)| world.place(id, pose))
    }

    /// Back to the start itself, bit for bit.
    fn begin_anew(&mut self) {
        let start = self.start.clone();
        if !self.has_first_shapes() {
            self.look_anew();
        }
        (self.graph, self.world) = (start.graph.clone(), start.world.clone().into());
        (self.relations, self.floor) = (start.relations.clone().into(), start.floor.clone().into());
        (self.past, self.poses) = (Past::default(), BTreeMap::new());
        self.clock = Clock::at(&self.world);
    }

    /// Reads the relations of a scene that differs from the start and writes them.
    fn observed(&self, graph: &mut SceneGraph, world: &PhysicsWorld, anew: bool) -> Result<Relations, ResetError> {
        let mut relations = self.start.relations.clone();
        let wanted = graph.clone();
        let (moved, _) = observe::write_poses(graph, world)?;
        let mut changed = moved.clone();
        let same = graph.len() == self.start.graph.len()
            && graph.nodes().map(vc_graph::Node::id).eq(self.start.graph.nodes().map(vc_graph::Node::id));
        let differs = |n: &&vc_graph::Node| self.start.graph.node(n.id()) != Some(*n);
        changed.extend(graph.nodes().filter(differs).map(vc_graph::Node::id));
        let evidence = observe::evidence(world);
        let met = if same && !anew {
            relations.update_with(graph, &changed, evidence)?
        } else {
            relations.rebuild(graph)?;
            relations.set_evidence(graph, evidence)?;
            graph.nodes().map(vc_graph::Node::id).collect()
        };
        relations.write_except(graph, &met, |graph, id| {
            let scene = boxes::still_at(&self.start, graph, world, id);
            let unmoved = || boxes::unmoved_at(graph, world, id, &moved);
            scene.or_else(unmoved).or_else(|| boxes::fixed_at(graph, world, id, &moved))
        })?;
        let kept: Vec<NodeId> = self.start.elsewhere.iter().map(|e| e.thing.id).collect();
        boxes::keep(&wanted, graph, world, &kept)?;
        Ok(relations)
    }
}

/// Takes away the bodies of worn things, which have none.
pub(super) fn undress(world: &mut PhysicsWorld, graph: &SceneGraph) -> Result<(), PhysicsError> {
    let worn = graph.agents().iter().flat_map(|&agent| graph.relating(Relation::WornBy, agent));
    let bodies: Vec<NodeId> = worn.filter(|id| world.pose(*id).is_some()).collect();
    bodies.into_iter().try_for_each(|id| world.remove(id))
}

/// Lets agents sit, lie or stand as the graph has them, and tells who does not.
fn settle_agents(world: &mut PhysicsWorld, graph: &mut SceneGraph, floor: &Floor) -> Result<Vec<Displaced>, EditError> {
    let mut told = seats::take(world, graph)?;
    let without_way = seats::leave_ways(world, graph, floor);
    let moved = astray::stand_on_floor(world, graph, floor);
    told.extend(astray::told(graph, &moved));
    told.extend(seats::stand(graph, &without_way)?);
    Ok(told)
}

/// The things to be placed, and what has become of them.
struct Plan {
    /// Things to be placed, what carries others first, and those of them that have no pose.
    open: Vec<(NodeId, Option<Place>)>,
    unposed: BTreeSet<NodeId>,
    /// Poses that things have kept from where they no longer are to be.
    stale: BTreeMap<NodeId, Pose>,
    /// Why things are not where they were to be.
    because: BTreeMap<NodeId, UnplacedReason>,
    report: ResetReport,
}

impl Plan {
    /// The plan for a graph, given graphs whose poses are known to be right, of which the first is the start.
    fn of(known: &[&SceneGraph], wanted: &SceneGraph) -> Self {
        let start = known[0];
        let (mut report, mut stale, mut because) = (ResetReport::default(), BTreeMap::new(), BTreeMap::new());
        let mut open: Vec<(usize, NodeId, Option<Place>)> = Vec::new();
        for node in wanted.nodes().filter(|n| n.kind() == NodeKind::Object) {
            let id = node.id();
            let place = wanted.place(id);
            let told = stale::place(known, wanted, id);
            if let (Some(why), true) = (stale::is_fixed(wanted, id), told.is_some()) {
                because.insert(id, UnplacedReason::NotMovable(why));
            } else if let (Some(place), Some(pose)) = (told, node.pose()) {
                stale.insert(id, *pose);
                report.moved.push(id);
                open.push((wanted.support_chain(id).len(), id, Some(place)));
                continue;
            }
            let Some(before) = start.node(id) else {
                report.added.push(id);
                open.push((wanted.support_chain(id).len(), id, place.or_else(|| unposed_in(wanted, node))));
                continue;
            };
            let replaced = start.place(id) != place;
            if replaced || before.pose() != node.pose() {
                report.moved.push(id);
            }
            let held = place.is_some_and(|p| !matches!(p.relation, Relation::On | Relation::Inside));
            if (replaced && !held) || node.pose().is_none() {
                open.push((wanted.support_chain(id).len(), id, place.or_else(|| unposed_in(wanted, node))));
            }
        }
        report.removed = start.nodes().map(vc_graph::Node::id).filter(|id| wanted.node(*id).is_none()).collect();
        open.sort_by_key(|(depth, id, _)| (*depth, *id));
        let open: Vec<_> = open.into_iter().map(|(_, id, place)| (id, place)).collect();
        let unposed = |id: &NodeId| wanted.node(*id).is_some_and(|n| n.pose().is_none());
        let mut unposed: BTreeSet<NodeId> = open.iter().map(|(id, _)| *id).filter(unposed).collect();
        unposed.extend(stale.keys());
        Self { open, unposed, stale, because, report }
    }

    /// Things without a pose get one for the time being, far below, each its own.
    fn lend_poses(&self, graph: &mut SceneGraph) -> Result<(), ResetError> {
        let mut edit = graph.edit();
        for (index, id) in self.unposed.iter().enumerate() {
            edit.set_pose(*id, Some(Pose::translation(APART * index as f32, 0.0, BELOW)))?;
        }
        edit.commit();
        Ok(())
    }

    /// Things that the graph has in something open: how far its doors and drawers are open the graph does not say, so
    /// these things may stand on none of them.
    fn in_open_things(&self, world: &PhysicsWorld, graph: &SceneGraph) -> Vec<NodeId> {
        let open = |id: &NodeId| {
            let inside = graph.place(*id).filter(|p| p.relation == Relation::Inside);
            inside.is_some_and(|p| world.parts(p.at).state() == Some(State::Open)) && !self.unposed.contains(id)
        };
        self.report.moved.iter().copied().filter(open).collect()
    }

    /// Lets down what hovers a little.
    fn lower(&self, world: &mut PhysicsWorld, standing: &[NodeId]) -> Result<(), ResetError> {
        let there = |id: &&NodeId| world.pose(**id).is_some() && standing.binary_search(id).is_err();
        let moved: Vec<NodeId> = self.report.moved.iter().filter(there).copied().collect();
        moved.into_iter().try_for_each(|id| world.lower(id, HOVER).map(drop))?;
        Ok(())
    }

    /// Puts what is to be placed where there is room, and takes out the rest.
    fn settle_places(&mut self, world: &mut PhysicsWorld, graph: &mut SceneGraph) -> Result<(), ResetError> {
        let all = std::mem::take(&mut self.open);
        let open: BTreeSet<NodeId> = all.iter().map(|(id, _)| *id).collect();
        for (id, place) in all {
            let posed = !self.unposed.contains(&id);
            let place = place.map(|place| stale::on_floor(graph, place));
            match (settle_place(world, graph, (id, posed), place)?, self.stale.get(&id).copied()) {
                (Ok(()), None) => {}
                (Ok(()), Some(before)) => {
                    let load = stale::bring_load(world, graph, (id, before), |load| open.contains(&load))?;
                    self.report.moved.extend(load);
                }
                (Err(why), Some(before)) if stays_free(world, id, &before, &open)? => {
                    world.place(id, before)?;
                    stale::set_pose(graph, id, before)?;
                    self.because.insert(id, why);
                }
                (Err(why), _) => self.leave_out(world, graph, id, why)?,
            }
        }
        Ok(())
    }

    /// Takes places out of the graph where things could not be put: what has not moved would keep them.
    fn forget_places(&self, graph: &mut SceneGraph) -> Result<(), EditError> {
        let mut edit = graph.edit();
        self.because.keys().try_for_each(|id| edit.place_as_seen(*id, &[], None))?;
        edit.commit();
        Ok(())
    }

    /// Takes out the things that have fallen out of the home, and those that fall when these are gone.
    fn take_out(&mut self, world: &mut PhysicsWorld, graph: &mut SceneGraph) -> Result<(), ResetError> {
        let mut outside = world.outside();
        while !outside.is_empty() {
            outside.into_iter().try_for_each(|id| self.leave_out(world, graph, id, UnplacedReason::FellOut))?;
            come_to_rest(world);
            outside = world.outside();
        }
        Ok(())
    }

    fn leave_out(
        &mut self,
        world: &mut PhysicsWorld,
        graph: &mut SceneGraph,
        id: NodeId,
        why: UnplacedReason,
    ) -> Result<(), ResetError> {
        self.report.unplaced.push(Unplaced { thing: graph.label(id), why });
        if world.pose(id).is_some() {
            world.remove(id)?;
        }
        let mut edit = graph.edit();
        edit.remove(id)?;
        edit.commit();
        Ok(())
    }

    fn report(mut self, start: &SceneGraph, wanted: &SceneGraph, now: &SceneGraph) -> ResetReport {
        for id in now.nodes().filter(|n| n.kind() == NodeKind::Object).map(Node::id) {
            let asked = self.because.contains_key(&id) || self.unposed.contains(&id);
            let in_room = || Some(Place { relation: Relation::InRoom, at: wanted.room_of(id).filter(|_| asked)? });
            let Some(place) = wanted.place(id).or_else(in_room) else { continue };
            let is_there = place.relation == Relation::InRoom && now.room_of(id) == Some(place.at);
            if !is_there && !now.places(id).any(|p| p == place) {
                let why = self.because.remove(&id);
                self.report.elsewhere.push(Displaced { why, ..Displaced::new(now, id, place, now.place(id)) });
            }
        }
        let differs = |id: &NodeId| {
            let at = |graph: &SceneGraph| Some((*graph.node(*id)?.pose()?, graph.place(*id)));
            now.node(*id).is_some() && at(start) != at(now)
        };
        self.report.moved.retain(differs);
        self.report.moved.sort_unstable();
        self.report.moved.dedup();
        self.report
    }
}

/// Puts one thing, which has a pose of its own or not, where there is room for it.
pub(super) fn settle_place(
    world: &mut PhysicsWorld,
    graph: &SceneGraph,
    (id, posed): (NodeId, bool),
    place: Option<Place>,
) -> Result<Result<(), UnplacedReason>, PhysicsError> {
    let Some(pose) = world.pose(id) else { return Ok(Err(UnplacedReason::NoShape)) };
    if posed && is_at_rest(world, id, &pose)? {
        return Ok(Ok(()));
    }
    let Some(place) = place else {
        return Ok(if posed { Ok(()) } else { Err(UnplacedReason::Nowhere) });
    };
    if world.aabb(place.at).is_none() {
        return Ok(Err(UnplacedReason::NoSupport(graph.label(place.at))));
    }
    let order = if posed { SpotOrder::Near(Point3::from(pose.translation.vector)) } else { SpotOrder::Middle };
    let inside = place.relation == Relation::Inside;
    // Furniture on a floor stands in no door's way where that can be.
    let is_furniture = !inside && graph.node(id).is_some_and(|n| !n.affords(Property::Graspable));
    let leaves_free = |spot: &Pose| !is_furniture || world.body(id).is_ok_and(|thing| thing.leaves_openings_free(spot));
    let mut spot = SpotSearch::new(id, place.at, inside).order(order).find_where(world, leaves_free)?;
    if spot.is_none() && is_furniture {
        spot = SpotSearch::new(id, place.at, inside).order(order).find(world)?;
    }
    let Some(spot) = spot else {
        return Ok(Err(no_spot(world, graph, id, place)));
    };
    world.place(id, spot)?;
    Ok(Ok(()))
}

/// Why there is no room for a thing at a place.
pub(super) fn no_spot(world: &PhysicsWorld, graph: &SceneGraph, id: NodeId, place: Place) -> UnplacedReason {
    let size = world.aabb(id).map_or([0.0; 3], |b| (b.max - b.min).into());
    UnplacedReason::NoSpot { relation: place.relation, at: graph.label(place.at), size }
}

/// The room of a thing that has no pose; parts of the building are not put into one.
fn unposed_in(graph: &SceneGraph, node: &Node) -> Option<Place> {
    let unposed = node.pose().is_none() && stale::is_fixed(graph, node.id()).is_none();
    stale::said(graph, node.id()).filter(|_| unposed)
}

/// Whether nothing that has been placed since is where a thing was.
fn stays_free(world: &PhysicsWorld, id: NodeId, pose: &Pose, placed: &BTreeSet<NodeId>) -> Result<bool, PhysicsError> {
    Ok(world.overlaps(id, pose)?.iter().all(|other| !placed.contains(other)))
}

/// Whether a thing overlaps nothing at a pose and something is right below it.
fn is_at_rest(world: &PhysicsWorld, id: NodeId, pose: &Pose) -> Result<bool, PhysicsError> {
    let below = Pose::translation(0.0, 0.0, -HOVER) * pose;
    Ok(world.overlaps(id, pose)?.is_empty() && !world.overlaps(id, &below)?.is_empty())
}
