//! Building of a world from a scene graph, and insertion and removal of single bodies.

use std::collections::BTreeMap;

use rapier3d::dynamics::{RigidBodyBuilder, RigidBodyHandle};
use rapier3d::geometry::SharedShape;
use rapier3d::math::Pose as EnginePose;
use vc_graph::{Node, NodeId, NodeKind, ObjectRole, Property, SceneGraph};

use crate::engine::Engine;
use crate::ground::Storeys;
use crate::role::Roles;
use crate::shapes::{Session, ShapeCache};
use crate::state::{Places, Thing, ThingState, Waters};
use crate::world::{PhysicsWorld, rooms};
use crate::{BodyRole, PhysicsError, Settings, convert, group, joints, rolling};

/// # Building
impl PhysicsWorld {
    /// A world with a body for every object that has a pose and an asset or a box, and for every agent that has
    /// a pose; nodes without are listed in [`skipped`](Self::skipped). Things that are open in the graph are
    /// open here, and things that agents hold are in their hands.
    ///
    /// Bodies are awake: call [`settle`](Self::settle), or [`rest`](Self::rest) for a scene that is known to be
    /// at rest. Costs about 3 µs per body, and some hundred microseconds for each asset that is not in `shapes`
    /// yet.
    ///
    /// # Errors
    /// [`PhysicsError::BadSettings`].
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_physics::{Settings, ShapeCache, PhysicsWorld};
    /// let mut scene = SceneBuilder::new("flat");
    /// let size = |x, y, z| Bounds::standing([x, y, z].into());
    /// scene.add(Draft::new("floor").at(Pose::translation(0.0, 0.0, -0.1)).bounds(size(4.0, 4.0, 0.1)))?;
    /// let apple = scene.add(Draft::new("apple").at(Pose::translation(0.0, 0.0, 1.0)).bounds(size(0.1, 0.1, 0.1)))?;
    /// let mut world = PhysicsWorld::build(&scene.build(), &ShapeCache::new(), Settings::default())?;
    /// let report = world.settle(200);
    /// assert!(report.at_rest && report.fell == [apple]);
    /// assert!(world.pose(apple).is_some_and(|p| p.translation.z.abs() < 0.005));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn build(graph: &SceneGraph, shapes: &ShapeCache, settings: Settings) -> Result<Self, PhysicsError> {
        if let Some(fault) = settings.fault() {
            return Err(PhysicsError::BadSettings(fault));
        }
        let mut world = Self::empty(graph, settings);
        let rules = Rules::new(graph, settings);
        shapes.session(graph.assets(), |session| {
            for node in graph.nodes().filter(|n| n.kind() == NodeKind::Object) {
                if !world.embody_node(graph, node, &rules, session) {
                    world.skipped.push(node.id());
                }
            }
        });
        world.find_bottom();
        world.add_agents(graph);
        Ok(world)
    }

    fn empty(graph: &SceneGraph, settings: Settings) -> Self {
        Self {
            settings,
            engine: Engine::new(settings.dt / settings.substeps as f32, settings.gravity),
            things: Vec::with_capacity(graph.len()),
            agents: BTreeMap::new(),
            effectors: BTreeMap::new(),
            vehicles: BTreeMap::new(),
            waters: Waters::default(),
            driven: Vec::new(),
            rooms: rooms(graph),
            bottom: f32::NEG_INFINITY,
            ticks: 0,
            stopped: Vec::new(),
            skipped: Vec::new(),
            bars: Vec::new(),
        }
    }

    /// Adds the body of a node of a scene graph, awake. Check first whether the spot is free, with
    /// [`overlaps`](Self::overlaps).
    ///
    /// # Errors
    /// [`PhysicsError::NoSuchNode`], [`PhysicsError::Duplicate`], and
    /// [`PhysicsError::NoBody`] for a node without pose, or without asset and box,
    /// and for rooms and agents.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.remove(home.cup)?;
    /// world.insert(&home.graph, home.cup, &vc_physics::ShapeCache::new())?;
    /// assert!(world.pose(home.cup).is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn insert(&mut self, graph: &SceneGraph, id: NodeId, shapes: &ShapeCache) -> Result<(), PhysicsError> {
        let node = graph.node(id).ok_or(PhysicsError::NoSuchNode(id))?;
        if self.index(id).is_ok() {
            return Err(PhysicsError::Duplicate(id));
        }
        let rules = Rules::new(graph, self.settings);
        let done = shapes.session(graph.assets(), |session| self.embody_node(graph, node, &rules, session));
        if !done {
            return Err(PhysicsError::NoBody(id));
        }
        let bodies: Vec<_> = self.thing(id)?.bodies().collect();
        bodies.into_iter().for_each(|b| self.engine.refresh(b));
        if self.thing(id)?.state.role == BodyRole::Fixed {
            self.find_bottom();
        }
        Ok(())
    }

    /// Removes a node's body from the world; things that rested on it, hung from it or were pinned to it fall, and
    /// agents on it get up, to the nearest free place or where they are.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.remove(home.cup)?;
    /// assert_eq!(world.pose(home.cup), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remove(&mut self, id: NodeId) -> Result<(), PhysicsError> {
        self.index(id)?;
        self.let_go_of(id);
        self.clear_seat(id);
        let index = self.index(id)?;
        let thing = self.things.remove(index);
        self.stopped.retain(|other| *other != id);
        thing.bodies().for_each(|b| self.engine.remove(b));
        self.driven.retain(|(d, _)| *d != id);
        self.vehicles.remove(&id);
        self.drain(id);
        let on_it = |state: &ThingState| match state.rides {
            Some((carrier, _)) => carrier == id,
            None => state.rests.is_some_and(|place| place.at == id),
        };
        let hung = |t: &&Thing| t.state.role == BodyRole::Hung && on_it(&t.state);
        let hung: Vec<NodeId> = self.things.iter().filter(hung).map(|t| t.id).collect();
        if thing.state.role == BodyRole::Fixed {
            self.find_bottom();
        }
        hung.into_iter().try_for_each(|id| self.set_role(id, BodyRole::Loose))
    }

    fn embody_node(&mut self, graph: &SceneGraph, node: &Node, rules: &Rules<'_>, session: &mut Session<'_>) -> bool {
        let Some(&pose) = node.pose().filter(|p| convert::is_sound(p)) else { return false };
        let class = graph.classes().get(node.class());
        let Some(form) = session.form(graph, node).filter(|f| f.is_of_this_world()) else { return false };
        let mass_range = class.and_then(|c| c.mass).filter(|_| self.settings.class_masses);
        let mass_factor = form.mass_factor(mass_range, node.spec().scale.product());
        let Some(role) = rules.roles.role(node, class, &form, form.mass() * mass_factor) else { return false };
        let below = || rules.storeys.ground_below(node, &form, &pose);
        let ground = if role == BodyRole::Fixed { below() } else { 0.0 };
        let deepened = if ground > 0.0 { form.links[0].deepened(ground) } else { None };
        let state = ThingState {
            role,
            base: RigidBodyHandle::invalid(),
            moving: Vec::new(),
            mass_factor,
            asset: node.spec().asset,
            scale: [node.spec().scale.x, node.spec().scale.y, node.spec().scale.z].map(f32::to_bits),
            written: pose,
            watch: Default::default(),
            slept: None,
            rides: None,
            rests: graph.place(node.id()),
            structure: node.role().is_built_in(),
            door: node.role() == ObjectRole::Door,
            graspable: node.affords(Property::Graspable),
            rolling: rolling::resistance(graph.classes(), node.class()),
            ground: deepened.as_ref().map_or(0.0, |_| ground),
        };
        let mut thing = Thing { id: node.id(), form, places: Places::new(node), state };
        thing.state.base = self.add_base(&thing, deepened, &convert::pose(&pose));
        joints::add(&mut self.engine, &mut thing, &self.settings, node.is(vc_graph::State::Open));
        let at = self.things.partition_point(|t| t.id < thing.id);
        self.things.insert(at, thing);
        true
    }

    /// Adds the body of a thing's base, with another shape in place of its own if one is given.
    pub(crate) fn add_base(
        &mut self,
        thing: &Thing,
        instead: Option<(SharedShape, EnginePose)>,
        pose: &EnginePose,
    ) -> RigidBodyHandle {
        let builder = match thing.state.role {
            BodyRole::Loose => RigidBodyBuilder::dynamic(),
            BodyRole::Carried => RigidBodyBuilder::kinematic_position_based(),
            _ => RigidBodyBuilder::fixed(),
        };
        let link = &thing.form.links[0];
        let builder = builder.pose(*pose).user_data(group::mark(thing.id, 0));
        let body = self.engine.add_body(builder);
        if let Some((shape, at)) = instead.as_ref().or(link.solid.as_ref()) {
            let collider =
                link.collider(shape, at, thing.state.mass_factor).collision_groups(group::base(thing.state.role));
            self.engine.add_collider(collider.user_data(group::mark(thing.id, 0)).build(), body);
        }
        body
    }

    /// Nodes of the graph that got no body when the world was built or [reset](Self::reset): they have no pose, or
    /// neither asset nor box.
    pub fn skipped(&self) -> &[NodeId] {
        &self.skipped
    }
}

/// The data that determine the roles of a scene's nodes.
struct Rules<'a> {
    roles: Roles<'a>,
    storeys: Storeys,
}

impl<'a> Rules<'a> {
    fn new(graph: &'a SceneGraph, settings: Settings) -> Self {
        Self { roles: Roles::new(graph, settings), storeys: Storeys::new(graph) }
    }
}
