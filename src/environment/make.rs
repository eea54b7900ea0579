//! From a scene to an environment.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point2;
use vc_geometry::WallOpening;
use vc_graph::{AssetId, Draft, Node, NodeId, NodeKind, ObjectRole, Pose, SceneBuilder, SceneGraph};
use vc_physics::{BodyPlan, Floor, FloorOptions, PhysicsWorld, ShapeCache};
use vc_relations::Relations;

use super::clock::Clock;
use super::reset::undress;
use super::settle::come_to_rest;
use super::{
    Assets, Displaced, Environment, EnvironmentSettings, MakeError, Past, Start, Unplaced, astray, boxes, observe,
    scene, seats,
};

/// How often relations are read at most, until the rooms of floors no longer change.
const READINGS: usize = 4;
/// Floors no farther than this from zero count as at zero, metres.
const GROUND: f32 = 0.03;
/// Steps in which agents find the ground.
const LANDING: u32 = 24;
/// Free floor kept between agents, metres from middle to middle.
const APART: f32 = 0.8;
/// Rings of half a metre around the middle of each room in which somebody is to stand, and the most that are looked at.
pub(super) const RINGS: i32 = 32;
const FARTHEST: i32 = 2000;
/// How far from the middle of its room an agent may stand, metres.
const ASTRAY: f32 = 2.5;

/// The parts of an environment that is being made.
struct Made {
    world: PhysicsWorld,
    floor: Floor,
    shapes: ShapeCache,
    left_out: Vec<Unplaced>,
    /// Things that stay where the scene has them, and whether that was an environment's.
    staying: Vec<NodeId>,
    at_rest: bool,
    /// Which shapes things got of which the scene had only boxes.
    assets: Assets,
    /// Agents of the scene that are elsewhere than it has them.
    told: Vec<Displaced>,
    /// Passages opened to rooms that the scene's walls cut off.
    passages: Vec<WallOpening>,
}

impl Environment {
    /// An environment by name, with some agents at free spots from where the rooms can be
    /// reached: `apartment/42` generates a home from a seed, `scene:FILE` reads a scene of
    /// any format whose things have poses, packed by gzip or not. A thing that has a class and a box
    /// but no shape gets its class's shape ([`vc_procgen::dress`]). [`builder`](Self::builder) takes settings other
    /// than the defaults.
    ///
    /// `Apartment::from_seed(seed).scene()` or `vc_graph::format::read_scene`, then
    /// [`Environment::from_scene`].
    ///
    /// ```
    /// use virtualcity::{Environment, MakeError};
    /// let home = Environment::make("apartment/42", 2)?;
    /// assert_eq!(home.agents().len(), 2);
    /// let wrong = Environment::make("apartment/forty-two", 1).unwrap_err();
    /// assert_eq!(wrong.to_string(), "`forty-two` is no seed: a seed is a whole number from 0 to 18446744073709551615");
    /// # Ok::<(), MakeError>(())
    /// ```
    ///
    /// # Errors
    /// [`MakeError`].
    pub fn make(name: &str, agents: usize) -> Result<Self, MakeError> {
        Self::builder(name).agents(agents).make()
    }

    /// An environment of a scene of your own. Agents that the scene has are kept, others
    /// are added until there are so many. Things of which only a box is known get a shape of their
    /// class in that box ([`vc_geometry::shapes`]), and stay where the scene has them.
    ///
    /// `PhysicsWorld::build`, `PhysicsWorld::step`, `PhysicsWorld::put_to_sleep`, `Floor::new`, `PhysicsWorld::add_agent`, then relations are
    /// read (`Relations::new`) and written into the graph (`Relations::write`).
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::{Bounds, Draft, Pose, SceneBuilder};
    /// let mut scene = SceneBuilder::new("studio");
    /// let room = scene.add(Draft::new("livingroom").bounds(Bounds::standing([5.0, 5.0, 2.5].into())).at(Pose::identity()))?;
    /// let slab = Bounds::standing([5.0, 5.0, 0.1].into());
    /// scene.add_in(room, Draft::new("floor").bounds(slab).at(Pose::translation(0.0, 0.0, -0.1)))?;
    /// let table = Bounds::standing([0.8, 0.8, 0.7].into());
    /// scene.add_in(room, Draft::new("table").bounds(table).at(Pose::translation(1.0, 0.0, 0.0)))?;
    /// let home = Environment::from_scene(scene.build(), 1)?;
    /// assert_eq!(home.agents().len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MakeError`].
    pub fn from_scene(graph: SceneGraph, agents: usize) -> Result<Self, MakeError> {
        Self::builder_from_scene(graph).agents(agents).make()
    }

    pub(super) fn with_settings(
        graph: SceneGraph,
        agents: usize,
        settings: &EnvironmentSettings,
    ) -> Result<Self, MakeError> {
        vc_relations::check_sizes(&graph)?;
        // Things that had only a box stay where the scene has them, whichever shape they get; so do all that were
        // at rest.
        let (at_rest, staying) = (boxes::was_at_rest(&graph), boxes::staying(&graph));
        let graph = scene::shaped(&graph)?.unwrap_or(graph);
        let passages = vc_geometry::passages(&graph);
        let graph = boxes::shaped(&graph, settings.assets)?.unwrap_or(graph);
        let posed = |n: &&vc_graph::Node| n.kind() == NodeKind::Object && n.pose().is_some();
        if !graph.nodes().any(|n| posed(&n)) {
            return Err(MakeError::NoPoses { scene: graph.name().to_owned(), things: graph.len() });
        }
        let (mut graph, shapes) = (graph, ShapeCache::new());
        let mut world = PhysicsWorld::build(&graph, &shapes, settings.physics)?;
        settings.around.put_into(&mut world)?;
        let mut told = seats::take(&mut world, &mut graph)?;
        let mut builder = SceneBuilder::from_graph(graph);
        boxes::hold(&mut world, builder.graph(), &staying)?;
        undress(&mut world, builder.graph())?;
        let left_out = astray::calm(&mut world, &mut builder)?;
        if boxes::hold_moved(&mut world, builder.graph(), &staying, at_rest)? {
            come_to_rest(&mut world);
        }
        let level = level(builder.graph());
        let floor = Floor::new(&world, FloorOptions { level, ..FloorOptions::default() });
        if !at_rest && !staying.is_empty() {
            boxes::step_aside(&mut world, builder.graph(), &floor)?;
        }
        let without_way = seats::leave_ways(&mut world, builder.graph(), &floor);
        let put_apart = astray::stand_on_floor(&mut world, builder.graph(), &floor);
        let places = standing_places(builder.graph(), &world, &floor, agents)?;
        let mut library = builder.graph().assets().as_ref().clone();
        // Whoever is in the scene already has the first looks.
        let first = builder.graph().agents().len();
        let people = (0..places.len()).map(|i| vc_people::add_to(&mut library, first + i));
        let people: Vec<AssetId> = people.collect::<Result<_, _>>()?;
        builder.assets(Arc::new(library));
        for ((room, feet), person) in places.into_iter().zip(people) {
            let draft = Draft { asset: Some(person), ..Draft::new("character").at(feet).bounds(vc_people::bounds()) };
            let id = builder.add_in(room, draft)?;
            world.add_agent(id, BodyPlan::default(), feet)?;
        }
        world.run(LANDING);
        // Agents that land may have shaken something; a reset has to find all at rest.
        come_to_rest(&mut world);
        if at_rest {
            boxes::rest_as(&mut world, builder.graph(), &staying)?;
        }
        if builder.graph().agents().is_empty() && !settings.unpeopled {
            return Err(MakeError::NoAgents);
        }
        let mut graph = builder.build();
        told.extend(astray::told(&graph, &put_apart));
        told.extend(seats::stand(&mut graph, &without_way)?);
        let made = Made { world, floor, shapes, left_out, staying, at_rest, assets: settings.assets, told, passages };
        Self::begin(graph, made, settings)
    }

    fn begin(mut graph: SceneGraph, made: Made, settings: &EnvironmentSettings) -> Result<Self, MakeError> {
        let Made { mut world, floor, shapes, left_out, staying, at_rest, assets, told, passages } = made;
        let scene = graph.clone();
        observe::write_poses(&mut graph, &world)?;
        let relations = read_relations(&mut graph, &world, settings)?;
        world.forget_moved();
        let traced = graph.clone();
        let mut elsewhere = if at_rest {
            boxes::keep_all(&scene, &mut graph).map(|()| Vec::new())?
        } else {
            boxes::keep(&scene, &mut graph, &world, &staying)?
        };
        elsewhere.extend(told);
        let kept = boxes::kept(&traced, &graph, &staying);
        let time = settings.time.clone();
        let start = Start { graph, world, relations, floor, shapes, left_out, elsewhere, kept, assets, passages, time };
        let environment = Self::at(Arc::new(start));
        #[cfg(feature = "render")]
        let environment = environment.equipped(settings)?;
        Ok(environment)
    }

    /// The environment with what pictures and sensors of it need.
    #[cfg(feature = "render")]
    fn equipped(self, settings: &EnvironmentSettings) -> Result<Self, MakeError> {
        let threads = settings.threads.map(super::threads::Threads::new).transpose()?.unwrap_or_default();
        let mut environment = Self { pictures: settings.pictures, threads, ..self };
        environment.with_cameras(settings.cameras.iter().cloned())?;
        settings.sensors.iter().try_for_each(|sensor| environment.with_sensor(sensor.clone()).map(drop))?;
        Ok(environment)
    }

    /// The environment as it begins.
    fn at(start: Arc<Start>) -> Self {
        Self {
            graph: start.graph.clone(),
            world: start.world.clone().into(),
            relations: start.relations.clone().into(),
            floor: start.floor.clone().into(),
            past: Past::default(),
            clock: Clock::at(&start.world),
            poses: BTreeMap::new(),
            #[cfg(feature = "render")]
            picture_cache: Arc::default(),
            #[cfg(feature = "render")]
            pictures: crate::PictureOptions::default(),
            #[cfg(feature = "render")]
            cameras: Arc::default(),
            #[cfg(feature = "render")]
            sensors: Arc::default(),
            #[cfg(feature = "render")]
            threads: super::threads::Threads::default(),
            start,
        }
    }
}

/// Reads all relations and writes them into the graph. A floor that gets its room by that makes the room larger:
/// then they are read again, so that who reads them from the graph later finds the same rooms.
fn read_relations(
    graph: &mut SceneGraph,
    world: &PhysicsWorld,
    settings: &EnvironmentSettings,
) -> Result<Relations, MakeError> {
    let rooms = |graph: &SceneGraph| {
        let parts = graph.nodes().filter(|n| n.is_building());
        parts.map(|n| graph.room_of(n.id())).collect::<Vec<Option<NodeId>>>()
    };
    let all: Vec<NodeId> = graph.nodes().map(vc_graph::Node::id).collect();
    let mut relations =
        Relations::with_tolerance(graph, settings.relations, observe::evidence(world), settings.tolerance)?;
    for _ in 0..READINGS {
        let before = rooms(graph);
        relations.write(graph, &all)?;
        if rooms(graph) == before {
            break;
        }
        relations.rebuild(graph)?;
    }
    Ok(relations)
}

/// Height of the floors, metres: the middle one of their tops, and zero where that is about zero.
fn level(graph: &SceneGraph) -> f32 {
    let mut tops: Vec<f32> = graph.of_role(ObjectRole::Floor).filter_map(Node::aabb).map(|b| b.max.z).collect();
    tops.sort_by(f32::total_cmp);
    tops.get(tops.len() / 2).copied().filter(|top| top.abs() > GROUND).unwrap_or(0.0)
}

/// Rooms and feet for the agents that are still missing: in the middles of rooms that can
/// be walked between, as many rooms as possible.
fn standing_places(
    graph: &SceneGraph,
    world: &PhysicsWorld,
    floor: &Floor,
    agents: usize,
) -> Result<Vec<(NodeId, Pose)>, MakeError> {
    let missing = agents.saturating_sub(graph.agents().len());
    let there: Vec<Point2<f32>> = world.agents().filter_map(|a| Some(at(&world.pose(a)?))).collect();
    let middles: Vec<(NodeId, Point2<f32>)> = graph.rooms().iter().filter_map(|&r| middle(graph, floor, r)).collect();
    let rooms = if missing > 0 { most_joined(floor, middles) } else { Vec::new() };
    let mut taken = Spaced::new(&there);
    let mut found = Vec::new();
    if let Some(&(_, base)) = rooms.first() {
        let suits = |room: NodeId, p: &Point2<f32>, taken: &Spaced| {
            floor.is_free(*p) && taken.is_free(p) && is_in(graph, room, p) && floor.route(base, *p).is_some()
        };
        // One for each room and ring, so that all rooms have somebody; then the whole floor.
        for (ring, most) in (0..RINGS).map(|ring| (ring, 1)).chain((0..FARTHEST).map(|ring| (ring, usize::MAX))) {
            for (room, middle) in rooms.iter().filter(|(room, middle)| reaches(graph, *room, middle, ring)) {
                let mut here = 0;
                for spot in around(middle, ring) {
                    if found.len() == missing || here == most {
                        break;
                    }
                    if suits(*room, &spot, &taken) {
                        taken.take(spot);
                        here += 1;
                        found.push((*room, Pose::translation(spot.x, spot.y, floor.options().level)));
                    }
                }
            }
        }
    }
    if found.len() < missing {
        let found = graph.agents().len() + found.len();
        return Err(MakeError::NoRoom { asked: agents, found });
    }
    Ok(found)
}

/// Whether a ring around a point of a room has a part in the room's box.
fn reaches(graph: &SceneGraph, room: NodeId, middle: &Point2<f32>, ring: i32) -> bool {
    let aabb = graph.node(room).and_then(vc_graph::Node::aabb);
    let far = |b: vc_graph::Aabb| {
        [middle.x - b.min.x, b.max.x - middle.x, middle.y - b.min.y, b.max.y - middle.y].into_iter().fold(0.0, f32::max)
    };
    aabb.is_some_and(|b| 0.5 * ring as f32 <= far(b))
}

/// Points of the floor that are taken, in squares as wide as the distance to be kept.
pub(super) struct Spaced(BTreeMap<(i32, i32), Vec<Point2<f32>>>);

impl Spaced {
    pub(super) fn new(points: &[Point2<f32>]) -> Self {
        let mut all = Self(BTreeMap::new());
        points.iter().for_each(|point| all.take(*point));
        all
    }

    fn square(point: &Point2<f32>) -> (i32, i32) {
        ((point.x / APART).floor() as i32, (point.y / APART).floor() as i32)
    }

    pub(super) fn take(&mut self, point: Point2<f32>) {
        self.0.entry(Self::square(&point)).or_default().push(point);
    }

    pub(super) fn is_free(&self, point: &Point2<f32>) -> bool {
        !self.has_within(point, APART)
    }

    /// Whether a taken point is nearer than a distance, at most that to be kept.
    pub(super) fn has_within(&self, point: &Point2<f32>, distance: f32) -> bool {
        let (x, y) = Self::square(point);
        let near = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (x.saturating_add(i), y.saturating_add(j))));
        near.filter_map(|square| self.0.get(&square)).flatten().any(|taken| (taken - point).norm() < distance)
    }
}

/// A point of the floor from which most rooms can be reached.
pub(super) fn base(graph: &SceneGraph, floor: &Floor) -> Option<Point2<f32>> {
    let middles = graph.rooms().iter().filter_map(|&room| middle(graph, floor, room)).collect();
    most_joined(floor, middles).first().map(|(_, base)| *base)
}

/// The largest group of middles of rooms between which one can walk.
fn most_joined(floor: &Floor, mut middles: Vec<(NodeId, Point2<f32>)>) -> Vec<(NodeId, Point2<f32>)> {
    let mut most = Vec::new();
    // A way there is a way back, so each group is asked of one of its rooms.
    while let Some(&(_, from)) = middles.first() {
        let (joined, apart): (Vec<_>, Vec<_>) =
            middles.into_iter().partition(|(_, to)| floor.route(from, *to).is_some());
        middles = apart;
        if joined.len() > most.len() {
            most = joined;
        } else if joined.is_empty() {
            break;
        }
    }
    most
}

fn at(pose: &Pose) -> Point2<f32> {
    pose.translation.vector.xy().into()
}

/// The free floor nearest to the middle of a room, in the room.
pub(super) fn middle(graph: &SceneGraph, floor: &Floor, room: NodeId) -> Option<(NodeId, Point2<f32>)> {
    let centre = graph.node(room)?.aabb()?.centre().xy();
    let spot = floor.nearest(centre, ASTRAY)?;
    is_in(graph, room, &spot).then_some((room, spot))
}

/// Whether a point of the floor is in a room's box.
pub(super) fn is_in(graph: &SceneGraph, room: NodeId, point: &Point2<f32>) -> bool {
    let aabb = graph.node(room).and_then(vc_graph::Node::aabb);
    aabb.is_some_and(|b| (b.min.x..=b.max.x).contains(&point.x) && (b.min.y..=b.max.y).contains(&point.y))
}

/// Points on a square ring around a point, so many half-metres away.
pub(super) fn around(middle: &Point2<f32>, ring: i32) -> impl Iterator<Item = Point2<f32>> + use<> {
    let middle = *middle;
    let whole = move |x: i32| x.abs() == ring;
    let step = move |x: i32| if whole(x) || ring == 0 { 1 } else { 2 * ring as usize };
    let own = (-ring..=ring).flat_map(move |x| (-ring..=ring).step_by(step(x)).map(move |y| (x, y)));
    own.map(move |(x, y)| middle + nalgebra::Vector2::new(x as f32, y as f32) * 0.5)
}
