//! The environment: a home with bodies, in which agents act.

mod alter;
mod around;
mod astray;
mod attempt;
mod body;
mod boxes;
mod builder;
mod clock;
mod compare;
mod control;
mod error;
mod execute;
mod export;
mod feasible;
mod freight;
mod gaze;
mod make;
mod motion;
mod observe;
mod outlook;
#[cfg(feature = "render")]
mod pictures;
mod reset;
mod save;
mod scene;
mod seats;
#[cfg(feature = "render")]
mod sensing;
mod settings;
mod settle;
mod stale;
mod state;
mod steer;
mod survey;
#[cfg(feature = "render")]
mod threads;
mod travel;
mod whereabouts;

use std::sync::Arc;

use nalgebra::{Point2, Point3};
use vc_graph::hash::Digester;
use vc_graph::{Action, ChangeSet, Digest, History, NodeId, Observation, SceneGraph, Scope};
use vc_physics::{Floor, PhysicsWorld, Posture, ShapeCache};
use vc_relations::Relations;

pub use alter::{AlterError, Spot};
pub(crate) use around::{Around, Bar, Walls};
pub use attempt::Attempt;
pub use builder::EnvironmentBuilder;
use builder::EnvironmentSettings;
pub use clock::{Ending, Interruption};
pub use compare::{Difference, Disagreement};
pub use control::{Control, ControlledHand};
pub use error::{ActionError, MakeError, NoRoom, PhysicalRefusal, ResetError, SaveError, SpotRefusal};
#[cfg(feature = "render")]
pub(crate) use export::position;
#[cfg(feature = "render")]
pub(crate) use pictures::{Beside, Extent, GLANCE, JoinedHomes, sight_of};
#[cfg(feature = "render")]
pub use pictures::{
    CameraError, CameraId, JsonFault, Lens, Mount, NamedCamera, PictureError, PictureOptions, Viewpoint,
};
#[cfg(feature = "render")]
pub(crate) use pictures::{Named, Register};
pub use reset::{Displaced, ResetReport, Unplaced, UnplacedReason};
pub(crate) use save::shapes_as_text;
pub use scene::Assets;
#[cfg(feature = "render")]
pub use sensing::{LidarScan, Reading, Sensor, SensorError, SensorId, SensorView};
pub use state::{EnvironmentState, StateError};
use state::{Past, Waking};
pub use steer::Steering;
pub use travel::TravelError;
pub(crate) use travel::{APART, BEYOND, Departure, apart_after};

/// At which height somebody is in a room, metres.
const WAIST: f32 = 0.9;

/// A home with bodies, in which agents act: the five endpoints.
///
/// It holds four things that are kept in step: a [`SceneGraph`] that says what is the
/// case, a [`PhysicsWorld`] that says where everything is, [`Relations`] that are read
/// from where things are, and the walkable [`Floor`].
///
/// | endpoint | made of |
/// |---|---|
/// | [`make`](Self::make) | `Apartment::from_seed`, `PhysicsWorld::build`, `PhysicsWorld::step`, `PhysicsWorld::put_to_sleep`, `Floor::new`, `PhysicsWorld::add_agent`, `Relations::new`, `Relations::write` |
/// | [`reset`](Self::reset) | `PhysicsWorld::reset`, `SpotSearch`, `PhysicsWorld::lower`, `PhysicsWorld::step`, `PhysicsWorld::put_to_sleep`, `Relations::update_with` |
/// | [`observation`](Self::observation) | `SceneGraph::observe` |
/// | [`render`](Self::render) | `Renderer::snapshot`, `Snapshot::place`, `Renderer::light`, `Renderer::follow`, `Renderer::render` |
/// | [`set_action`](Self::set_action) | `rule::refusals`, then the clock with `Floor::standing_pose_where`, `PhysicsWorld::grab_with_load`, `SpotSearch`, `PhysicsWorld::put` ..., then `Relations::update_nodes` |
///
/// Beside these:
///
/// | for | there are |
/// |---|---|
/// | settings: bodies, gravity, hour, fields of view, classes, relations, durations ... | [`builder`](Self::builder), [`builder_from_scene`](Self::builder_from_scene) ([recipe](crate::guide::homes#settings-of-a-home)) |
/// | the clock: agents that act at the same time, in ticks of 1/60 s | [`give`](Self::give), [`step`](Self::step), [`step_until_idle`](Self::step_until_idle), [`interrupt`](Self::interrupt), [`moment`](Self::moment), [`tick`](Self::tick), [`day_time`](Self::day_time), [`processes`](Self::processes), [`set_actions`](Self::set_actions) ([recipes](crate::guide::clock)) |
/// | copies: in memory, as states of a search, as bytes | `clone`, [`save_state`](Self::save_state) and [`restore_state`](Self::restore_state), [`save`](Self::save) and [`restore`](Self::restore) ([which for what](crate::guide::clock#saved-in-the-middle-of-actions)) |
/// | velocity, head and hands in every tick | [`control`](Self::control) ([recipe](crate::guide::acting#control-in-every-tick)) |
/// | what is possible | [`legal_actions`](Self::legal_actions), [`can_do`](Self::can_do), [`objects`](Self::objects), [`occupancy`](Self::occupancy) |
/// | arranging a home | [`spawn`](Self::spawn), [`put`](Self::put), [`teleport`](Self::teleport), [`switch_lamps`](Self::switch_lamps) ([recipe](crate::guide::homes#placing-things-and-agents)) |
/// | cameras and sensors (feature `render`) | [`cameras`](Self::cameras), [`add_camera`](Self::add_camera), [`add_sensor`](Self::add_sensor), [`sense`](Self::sense) ([recipe](crate::guide::pictures#cameras-and-sensors-of-your-own)) |
///
/// `Clone` is the snapshot: what is constant is shared, and a clone goes on as the
/// original does, bit for bit, also in the middle of actions.
///
/// ```no_run
/// use virtualcity::Environment;
/// use virtualcity::graph::Verb;
///
/// let mut home = Environment::make("apartment/42", 1)?;
/// let me = home.agents()[0];
/// let seen = home.observation(me, 3.0);
/// println!("{} things within three metres", seen.len());
/// let fridge = home.graph().of_class("fridge")[0];
/// home.set_action(me, format!("walk fridge.{}", fridge.0).parse()?)?;
/// home.set_action(me, format!("open fridge.{}", fridge.0).parse()?)?;
/// assert!(home.world().parts(fridge).openness() > Some(0.9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Environment {
    start: Arc<Start>,
    graph: SceneGraph,
    world: Waking<PhysicsWorld>,
    relations: Waking<Relations>,
    floor: Waking<Floor>,
    past: Past,
    clock: clock::Clock,
    /// The activities in which bodies are shown while an action takes its time.
    poses: std::collections::BTreeMap<NodeId, vc_people::Activity>,
    #[cfg(feature = "render")]
    picture_cache: Arc<pictures::PictureCache>,
    #[cfg(feature = "render")]
    pub(crate) pictures: PictureOptions,
    #[cfg(feature = "render")]
    cameras: Arc<pictures::Cameras>,
    #[cfg(feature = "render")]
    pub(crate) sensors: Arc<Register<sensing::NamedSensor>>,
    #[cfg(feature = "render")]
    pub(crate) threads: threads::Threads,
}

/// How an environment began; its resets start from here.
struct Start {
    graph: SceneGraph,
    world: PhysicsWorld,
    relations: Relations,
    floor: Floor,
    shapes: ShapeCache,
    left_out: Vec<Unplaced>,
    elsewhere: Vec<Displaced>,
    /// Places that the scene gives to things and geometry does not: they hold while these have not moved.
    kept: std::collections::BTreeMap<NodeId, Vec<vc_graph::Place>>,
    /// Which shapes things get that have only boxes.
    assets: Assets,
    passages: Vec<vc_geometry::WallOpening>,
    /// How time goes.
    time: clock::TimeSettings,
}

impl Start {
    /// Floors stay where they are.
    fn room_at(&self, point: Point2<f32>) -> Option<NodeId> {
        let level = self.floor.options().level;
        self.relations.room_at(&Point3::new(point.x, point.y, level + WAIST))
    }
}

impl Environment {
    /// The scene as it is.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// The bodies as they are.
    pub fn world(&self) -> &PhysicsWorld {
        &self.world
    }

    /// The relations that the bodies' places make.
    pub fn relations(&self) -> &Relations {
        &self.relations
    }

    /// The walkable floor, as it was when somebody last went somewhere.
    pub fn floor(&self) -> &Floor {
        &self.floor
    }

    /// The actions done since the last reset.
    pub fn history(&self) -> &History {
        self.past.history()
    }

    /// The scene as it was made, at rest: what [`reset`](Self::reset) goes back to.
    pub fn start(&self) -> &SceneGraph {
        &self.start.graph
    }

    /// The things that [`make`](Self::make) took out of the scene, and why: they were or fell
    /// outside the home, or were in the place of another, and there was no free spot where the scene has
    /// them. There are hardly ever any.
    pub fn left_out(&self) -> &[Unplaced] {
        &self.start.left_out
    }

    /// Things of a scene of boxes that geometry places elsewhere than the scene does: coats that stick
    /// out of the wardrobe they are in, a table in the box around a corner sofa. A thing that people
    /// carry and that has not moved counts as where the scene has it until it is moved; `now` is its
    /// place by geometry. Agents too, who stand beside what they are to sit or lie on, or who were put onto free floor.
    pub fn elsewhere(&self) -> &[Displaced] {
        &self.start.elsewhere
    }

    /// Passages that were opened in the walls of a scene of boxes, since no door leads to the rooms behind them: boxes
    /// have no holes, so the places are guesses ([`vc_geometry::passages`]).
    pub fn opened_passages(&self) -> &[vc_geometry::WallOpening] {
        &self.start.passages
    }

    /// The agents, by number.
    pub fn agents(&self) -> &[NodeId] {
        self.graph.agents()
    }

    /// Returns the part of the scene that an agent sees within a radius, metres: [`SceneGraph::observe`]. A negative
    /// radius or NaN covers nothing: the agent sees only the rooms, itself and the objects it carries. Changes nothing.
    pub fn observation(&self, agent: NodeId, radius: f32) -> Observation {
        self.graph.observe(agent, Scope::Radius(radius))
    }

    /// Returns the part of its room that an agent sees, as the planner's belief uses it: [`SceneGraph::observe`].
    /// Changes nothing.
    pub fn room_observation(&self, agent: NodeId) -> Observation {
        self.graph.observe(agent, Scope::Room)
    }

    /// A number that says whether two environments are the same and will go on alike: of
    /// the graph, the bodies, what has been done, each action, and what is going on. Costs as much as the graph's and
    /// the bodies' own, a millisecond, and a microsecond for each action done.
    pub fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        hash.words([self.graph.digest().0, self.world.digest().0]);
        for event in self.history().events() {
            hash.word(u64::from(event.agent.0)).words(event.action.to_string().bytes().map(u64::from));
        }
        self.digest_clock(&mut hash);
        hash.digest()
    }

    /// The room whose floor is at a point of the ground, metres: [`Relations::room_at`].
    pub fn room_at(&self, point: Point2<f32>) -> Option<NodeId> {
        self.start.room_at(point)
    }

    /// The posture of an agent's body: it stands, sits or lies.
    pub fn posture(&self, agent: NodeId) -> Option<Posture> {
        self.world.posture(agent)
    }

    /// The activity that a body is shown in now.
    pub(crate) fn doing(&self, agent: NodeId) -> vc_people::Activity {
        self.poses.get(&agent).cloned().unwrap_or_default()
    }

    /// Forgets what pictures know of shapes: some have become others.
    fn look_anew(&mut self) {
        #[cfg(feature = "render")]
        {
            self.picture_cache = Arc::default();
        }
    }

    /// Whether the things in the scene are those it began with, in the same shapes.
    fn has_first_shapes(&self) -> bool {
        let looks = |n: &vc_graph::Node| (n.spec().asset, n.spec().scale);
        let was = |n: &vc_graph::Node| self.start.graph.node(n.id()).is_some_and(|was| looks(was) == looks(n));
        self.graph.len() == self.start.graph.len() && self.graph.nodes().all(was)
    }

    /// The scene and the bodies as they began, if they are still the same things; else as they are.
    /// Pictures start from these, so that it does not matter when the first was asked for.
    #[cfg(feature = "render")]
    pub(crate) fn origin(&self) -> (&SceneGraph, &PhysicsWorld) {
        if self.has_first_shapes() { (&self.start.graph, &self.start.world) } else { (&self.graph, &self.world) }
    }

    #[cfg(feature = "render")]
    fn picture_cache(&self) -> &pictures::PictureCache {
        &self.picture_cache
    }
}

impl std::fmt::Debug for Environment {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (name, nodes, agents) = (self.graph.name(), self.graph.len(), self.agents().len());
        write!(f, "Environment({name}, {nodes} nodes, {agents} agents, digest {})", self.digest())
    }
}

impl From<ActionError> for vc_tasks::WorldError {
    fn from(error: ActionError) -> Self {
        match error {
            ActionError::Refused(reasons) => Self::Refused(reasons),
            other => Self::failed(other),
        }
    }
}

/// Tasks are done and judged in an environment as in the symbolic simulator.
impl vc_tasks::World for Environment {
    fn graph(&self) -> &SceneGraph {
        Environment::graph(self)
    }

    fn history(&self) -> &History {
        Environment::history(self)
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, vc_tasks::WorldError> {
        self.set_action(agent, *action).map_err(vc_tasks::WorldError::from)
    }

    fn step_together(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, vc_tasks::WorldError>> {
        self.set_actions(actions).into_iter().map(|outcome| outcome.map_err(vc_tasks::WorldError::from)).collect()
    }

    fn has_clock(&self) -> bool {
        true
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), vc_tasks::WorldError> {
        let report = Environment::reset(self, graph);
        report.map(drop).map_err(vc_tasks::WorldError::failed)
    }
}
