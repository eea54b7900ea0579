//! One attempt at an initial environment.

use std::sync::Arc;

use nalgebra::{Isometry3, Translation3};
use vc_graph::class::{Category, Class};
use vc_graph::goal::{Goal, Situation};
use vc_graph::{
    AssetLibrary, Bounds, Draft, History, NodeId, NodeKind, ObjectRole, Place, Property, PropertySet, Relation,
    SceneBuilder, SceneGraph, Seed, State, Vocabulary,
};

use super::error::{InitialError, PlacementReason};
use super::fit::{Fit, refused, turned};
use super::site::{Places, Site};
use super::solid::Solids;
use super::start;
use super::stock::Stock;
use super::walk::Walk;
use super::{Added, Purpose};
use crate::library::{Activity, Need, PlacementSpec};

/// The number of classes drawn for a distractor before it is left out.
const DRAWS: usize = 40;

/// The data shared by all attempts at a scene.
pub(super) struct Ground {
    solids: Solids,
    walk: Option<Walk>,
}

impl Ground {
    pub(super) fn from_scene(scene: &SceneGraph) -> Self {
        Self { solids: Solids::new(scene), walk: Walk::new(scene, scene.assets()) }
    }
}

/// A scene as requested of a world.
pub(super) struct Asked {
    pub(super) scene: SceneGraph,
    pub(super) agent: NodeId,
    pub(super) added: Vec<Added>,
    pub(super) states: Vec<(NodeId, State)>,
}

/// A scene under construction.
pub(super) struct Attempt<'a> {
    activity: &'a Activity,
    stock: &'a dyn Stock,
    graph: SceneGraph,
    assets: AssetLibrary,
    solids: Solids,
    walk: Option<Walk>,
    agent: NodeId,
    seed: Seed,
    added: Vec<Added>,
    /// The objects that the activity uses: all must be reachable in the end.
    used: Vec<NodeId>,
    states: Vec<(NodeId, State)>,
    drawn: u64,
}

impl<'a> Attempt<'a> {
    pub(super) fn new(
        activity: &'a Activity,
        stock: &'a dyn Stock,
        scene: &SceneGraph,
        ground: &Ground,
        seed: Seed,
    ) -> Self {
        Self {
            activity,
            stock,
            graph: scene.clone(),
            assets: AssetLibrary::clone(scene.assets()),
            solids: ground.solids.clone(),
            walk: ground.walk.clone(),
            agent: scene.agents().first().copied().unwrap_or(NodeId(0)),
            seed,
            added: Vec::new(),
            used: Vec::new(),
            states: Vec::new(),
            drawn: 0,
        }
    }

    /// Prepares the scene.
    pub(super) fn run(mut self, distractors: usize) -> Result<Asked, InitialError> {
        self.check_rooms()?;
        if self.graph.agents().is_empty() {
            self.add_agent()?;
        }
        for need in self.ordered_needs() {
            self.supply(&need)?;
        }
        (0..distractors).for_each(|_| self.distract());
        self.begin()?;
        self.check()?;
        let mut scene = SceneBuilder::from_graph(self.graph);
        scene.assets(Arc::new(self.assets));
        let scene = scene.build();
        Ok(Asked { scene, agent: self.agent, added: self.added, states: self.states })
    }

    /// A sub-seed for each random draw.
    fn draw(&mut self, what: &str) -> Seed {
        self.drawn += 1;
        self.seed.child(what).nth(self.drawn)
    }

    fn check_rooms(&self) -> Result<(), InitialError> {
        let classes = self.graph.classes();
        let is = |room: &NodeId, class: &str| self.graph.node(*room).is_some_and(|n| classes.is_a(n.class(), class));
        let missing = self.activity.places.iter().find(|place| !self.graph.rooms().iter().any(|room| is(room, place)));
        missing.map_or(Ok(()), |place| Err(InitialError::NoRoom(place.clone())))
    }

    /// The needs, first those that other objects are put on or in, then large objects, then
    /// graspable ones.
    fn ordered_needs(&self) -> Vec<Need> {
        let mut needs = self.activity.all_needs();
        let carries = |class: &str| {
            let spots = self.activity.needs.iter().flat_map(|n| &n.spots);
            spots.filter_map(|s| s.at.as_ref()).any(|(_, at)| at == class)
        };
        let carried = |need: &Need| {
            let class = self.graph.classes().get(&need.class);
            !carries(&need.class) && class.is_some_and(|c| c.affordances.contains(Property::Graspable))
        };
        // The sort is stable: the written needs are counted before those that only the goal names,
        // so that a carrot counts as a vegetable.
        needs.sort_by_key(carried);
        needs
    }

    fn add_agent(&mut self) -> Result<(), InitialError> {
        let mut stream = self.draw("agent").stream();
        let class = self.graph.classes().get("character");
        let size = class.and_then(Class::typical_size);
        let rooms = self.walk.as_ref().map_or_else(|| self.graph.rooms().to_vec(), Walk::entered);
        let nowhere = || InitialError::NoSpot {
            thing: "character".into(),
            place: "floor".into(),
            why: PlacementReason::Unreachable,
        };
        let room = *rooms.get(stream.below(rooms.len())).ok_or_else(nowhere)?;
        let mut draft = Draft::new("character");
        if let (Some(walk), Some(size)) = (&self.walk, size) {
            let at = walk.spot(Some(room), None, &mut stream).ok_or_else(nowhere)?;
            let floor = self.graph.node(room).and_then(|n| n.aabb()).map_or(0.0, |b| b.min.z);
            let turn = turned(stream.between(0.0, std::f32::consts::TAU));
            let pose = Isometry3::from_parts(Translation3::new(at.x, at.y, floor), turn);
            draft = draft.bounds(Bounds::standing(size)).at(pose);
        }
        let site = Site { relation: Relation::InRoom, at: room, surface: None, weight: 1.0 };
        self.agent = self.put(draft, &site, Purpose::Agent).map_err(|_| nowhere())?;
        Ok(())
    }

    /// Ensures that the scene has as many objects as a need asks for.
    fn supply(&mut self, need: &Need) -> Result<(), InitialError> {
        let mut things = self.present(need);
        things.truncate(need.number);
        while things.len() < need.number {
            things.push(self.add(need)?);
        }
        self.used.extend(&things);
        for &id in &things {
            self.states.extend(need.states.iter().map(|&state| (id, state)));
        }
        let mut edit = self.graph.edit();
        for &id in &things {
            need.states.iter().try_for_each(|&state| start::enter(&mut edit, id, state))?;
        }
        edit.commit();
        Ok(())
    }

    /// The objects of the scene that are reachable, allow the states that the need asks for and are
    /// in one of its spots.
    fn present(&self, need: &Need) -> Vec<NodeId> {
        let class = self.graph.classes().get(&need.class);
        let places = Places { graph: &self.graph, assets: &self.assets };
        let sites = class.filter(|_| !need.spots.is_empty()).map(|class| places.sites(class, &need.spots));
        let there = |id: &NodeId| match &sites {
            None => true,
            Some(sites) => sites.iter().any(|site| self.is_at(*id, site)),
        };
        let able = |id: &NodeId| {
            self.graph.node(*id).is_some_and(|n| allows_all(self.graph.vocabulary(), n.spec().affordances, need))
        };
        let found = self.graph.of_class(&need.class).into_iter();
        found.filter(|id| able(id) && self.is_reached(*id) && there(id)).collect()
    }

    fn is_at(&self, id: NodeId, site: &Site) -> bool {
        match site.relation {
            Relation::InRoom => self.graph.room_of(id) == Some(site.at) && self.graph.place(id).is_none(),
            relation => self.graph.places(id).any(|p| p == Place { relation, at: site.at }),
        }
    }

    fn is_reached(&self, id: NodeId) -> bool {
        let Some(walk) = &self.walk else { return true };
        let Some(node) = self.graph.node(id).filter(|n| n.kind() == NodeKind::Object) else { return true };
        node.aabb().is_none_or(|aabb| walk.reaches(&aabb, self.graph.room_of(id)) || is_overhead(node))
    }

    /// Adds an object that a need asks for.
    fn add(&mut self, need: &Need) -> Result<NodeId, InitialError> {
        let missing = || InitialError::NotInStock(need.class.clone());
        let classes = self.graph.classes().clone();
        let class = classes.get(&need.class).ok_or_else(missing)?;
        if !can_be_added(class) {
            return Err(InitialError::BuiltIn(need.class.clone()));
        }
        let seed = self.draw(&need.class);
        // Any subclass serves for a group of classes.
        let mut kinds: Vec<&Class> = classes.kinds_of(class).filter(|kind| !std::ptr::eq(*kind, class)).collect();
        seed.child("kind").stream().shuffle(&mut kinds);
        let mut choices = std::iter::once(class)
            .chain(kinds)
            .filter(|kind| allows_all(self.graph.vocabulary(), kind.affordances, need));
        let found = choices.find_map(|kind| Some((kind, self.stock.thing(kind, seed, &self.graph, &mut self.assets)?)));
        let (kind, draft) = found.ok_or_else(missing)?;
        self.place(kind, draft, &need.spots, Purpose::Need, seed)
    }

    /// Places an object at one of its sites, drawn by weight.
    fn place(
        &mut self,
        class: &Class,
        draft: Draft,
        spots: &[PlacementSpec],
        purpose: Purpose,
        seed: Seed,
    ) -> Result<NodeId, InitialError> {
        let mut sites = Places { graph: &self.graph, assets: &self.assets }.sites(class, spots);
        let mut stream = seed.child("place").stream();
        let asked = || spots.iter().map(PlacementSpec::to_string).collect::<Vec<_>>().join(" | ");
        let mut last = (asked(), PlacementReason::Absent);
        while let Some(chosen) = stream.weighted(sites.iter().map(|s| s.weight)) {
            let site = sites.swap_remove(chosen);
            match self.try_site(class, &draft, &site, purpose, &mut stream) {
                Ok(id) => return Ok(id),
                Err(why) => last = (format!("{} {}", site.relation, self.graph.label(site.at)), why),
            }
        }
        let (place, why) = last;
        Err(InitialError::NoSpot { thing: class.name.to_string(), place, why })
    }

    fn try_site(
        &mut self,
        class: &Class,
        draft: &Draft,
        site: &Site,
        purpose: Purpose,
        stream: &mut vc_graph::Stream,
    ) -> Result<NodeId, PlacementReason> {
        let fit = Fit { graph: &self.graph, assets: &self.assets, solids: &self.solids, walk: self.walk.as_ref() };
        let pose = fit.pose(class, draft.bounds, site, stream)?;
        self.put(Draft { pose, ..draft.clone() }, site, purpose)
    }

    /// Places an object at a site unless that fulfils part of the goal or blocks a way.
    fn put(&mut self, draft: Draft, site: &Site, purpose: Purpose) -> Result<NodeId, PlacementReason> {
        let agent = self.agent;
        let before = merits(&self.activity.goal, &self.graph, agent);
        let mut edit = self.graph.edit();
        let id = edit.add(draft).map_err(|_| PlacementReason::Refused)?;
        if purpose != Purpose::Agent && refused(edit.graph(), agent, id, site) {
            return Err(PlacementReason::Refused);
        }
        let place = Place { relation: site.relation, at: site.at };
        match site.relation {
            Relation::InRoom => edit.move_to_room(id, site.at),
            _ => edit.place(id, place),
        }
        .map_err(|_| PlacementReason::Refused)?;
        if purpose != Purpose::Agent && gains(&before, &merits(&self.activity.goal, edit.graph(), agent)) {
            return Err(PlacementReason::MeetsGoal);
        }
        let on_floor =
            edit.graph().node(site.at).is_some_and(|n| matches!(n.role(), ObjectRole::Room | ObjectRole::Floor));
        if let Some(walk) = self.walk.as_mut().filter(|_| on_floor && purpose != Purpose::Agent) {
            let after = Walk::new(edit.graph(), &self.assets).ok_or(PlacementReason::Unreachable)?;
            if after.entered() != walk.entered() {
                return Err(PlacementReason::Unreachable);
            }
            *walk = after;
        }
        let room = edit.graph().room_of(id).ok_or(PlacementReason::Absent)?;
        let aabb = edit.graph().node(id).and_then(|n| n.aabb());
        edit.commit();
        aabb.into_iter().for_each(|aabb| self.solids.add(id, aabb));
        let place = (site.relation != Relation::InRoom).then_some(place);
        self.added.push(Added { id, place, room, purpose });
        Ok(id)
    }

    /// Adds an object that the activity has no use for, if a placement is found.
    fn distract(&mut self) {
        let seed = self.draw("distractor");
        let mut stream = seed.stream();
        let classes = self.graph.classes().clone();
        let named: Vec<String> = self.activity.all_needs().into_iter().map(|n| n.class).collect();
        let useless = |class: &&Class| {
            let related = |other: &String| classes.is_a(&class.name, other) || classes.is_a(other, &class.name);
            class.affordances.contains(Property::Graspable) && class.size.is_some() && !named.iter().any(related)
        };
        let choices: Vec<&Class> = classes.iter().filter(useless).collect();
        for draw in 0..DRAWS {
            let Some(class) = choices.get(stream.below(choices.len())) else { return };
            let own = seed.nth(draw as u64);
            let made = self.stock.thing(class, own, &self.graph, &mut self.assets);
            if made.is_some_and(|draft| self.place(class, draft, &[], Purpose::Distractor, own).is_ok()) {
                return;
            }
        }
    }

    /// Sets the start states and seats the agent.
    fn begin(&mut self) -> Result<(), InitialError> {
        let mut edit = self.graph.edit();
        start::bring_about(&mut edit, self.agent, &self.activity.start)?;
        edit.commit();
        let seat = self.graph.places(self.agent).find(|p| Relation::places().contains(&p.relation));
        let room = self.graph.room_of(self.agent);
        if let (Some(mine), Some(room)) = (self.added.iter_mut().find(|a| a.id == self.agent), room) {
            (mine.place, mine.room) = (seat, room);
        }
        self.stand_beside(seat)
    }

    /// Moves the agent's body to the floor beside its seat.
    fn stand_beside(&mut self, seat: Option<Place>) -> Result<(), InitialError> {
        let aabb = seat.and_then(|seat| self.graph.node(seat.at)?.aabb());
        let (Some(aabb), Some(mut pose)) = (aabb, self.graph.node(self.agent).and_then(|n| n.pose()).copied()) else {
            return Ok(());
        };
        let room = self.graph.room_of(self.agent);
        let mut stream = self.draw("beside").stream();
        let spot = self.walk.as_ref().and_then(|walk| walk.spot(room, Some(&aabb), &mut stream));
        let Some(spot) = spot else { return Ok(()) };
        (pose.translation.x, pose.translation.y) = (spot.x, spot.y);
        let mut edit = self.graph.edit();
        edit.carry_to(self.agent, pose)?;
        edit.commit();
        Ok(())
    }

    fn check(&self) -> Result<(), InitialError> {
        let history = History::default();
        let now = Situation::new(&self.graph, self.agent, &history);
        if let Some(part) = start::unmet(&now, &self.activity.start) {
            return Err(InitialError::StartUnmet(part));
        }
        if self.activity.goal.holds(&now) {
            return Err(InitialError::AlreadyMet(self.activity.goal.to_string()));
        }
        let lost = self.used.iter().find(|&&id| !self.is_reached(id));
        lost.map_or(Ok(()), |&id| {
            let thing = self.graph.label(id).to_string();
            let place = self.graph.place(id).map_or_else(String::new, |p| self.graph.label(p.at).to_string());
            Err(InitialError::NoSpot { thing, place, why: PlacementReason::Unreachable })
        })
    }
}

/// Whether these affordances allow all the states that a need asks for.
fn allows_all(words: &Vocabulary, affordances: PropertySet, need: &Need) -> bool {
    need.states.iter().all(|&state| start::allows(words, affordances, state))
}

/// Whether an object may hang out of reach: lamps are switched elsewhere, pictures looked at from
/// afar, blinds drawn by a cord.
fn is_overhead(node: &vc_graph::Node) -> bool {
    [Property::Light, Property::Lookable, Property::Cover].into_iter().any(|p| node.affords(p))
}

/// Whether objects of a class can be added: not if they are built in, hang from ceilings or are
/// fixed to walls.
fn can_be_added(class: &Class) -> bool {
    let has = |property| class.affordances.contains(property);
    let role = class.role();
    match class.category {
        _ if role == ObjectRole::Room || role.is_built_in() => false,
        Category::Furniture => !has(Property::WaterSource),
        Category::Appliance => has(Property::Graspable) || has(Property::Movable) || has(Property::Container),
        Category::Lamp | Category::Decor => has(Property::Graspable) || has(Property::Movable),
        _ => true,
    }
}

/// How far each conjunct of a goal is fulfilled: whether it holds and, for literals and counts, its
/// score.
fn merits(goal: &Goal, graph: &SceneGraph, agent: NodeId) -> Vec<(bool, f64)> {
    let history = History::default();
    let now = Situation::new(graph, agent, &history);
    let merit = |part: &Goal| match part {
        Goal::Literal(_) | Goal::Count { .. } => (part.holds(&now), part.score(&now)),
        _ => (part.holds(&now), 0.0),
    };
    goal.conjuncts().iter().map(merit).collect()
}

fn gains(before: &[(bool, f64)], after: &[(bool, f64)]) -> bool {
    before.iter().zip(after).any(|(b, a)| (a.0 && !b.0) || a.1 > b.1)
}
