//! An environment's settings, with their defaults, and the builder that takes them.

use std::sync::Arc;

use vc_graph::clock::{DayTime, Durations, ProcessTable, TICKS_PER_SECOND};
use vc_graph::{ClassTable, SceneGraph, State, Vocabulary};
use vc_relations::RelationRule;
use vc_relations::threshold::SUPPORT_GAP;

use super::clock::TimeSettings;
use super::{Assets, Environment, MakeError, scene};

/// The last second of a day.
const LAST_SECOND: u32 = 86_399;

/// Makes an [`Environment`] with settings of your own: [`Environment::builder`], [`Environment::builder_from_scene`].
///
/// | setting | default |
/// |---|---|
/// | [`agents`](Self::agents) | 1 |
/// | [`assets`](Self::assets) | [`Assets::Generated`] for a scene by name, [`Assets::None`] for a graph |
/// | [`classes`](Self::classes) | [`ClassTable::builtin`] |
/// | [`vocabulary`](Self::vocabulary) | that of the scene |
/// | [`bodies`](Self::bodies) | yes: bodies do the actions |
/// | [`physics`](Self::physics), [`gravity`](Self::gravity) | [`vc_physics::Settings::default`]: steps of 1/60 s, 9.81 m/s² |
/// | [`relations`](Self::relations) | [`RelationRule::Contacts`] |
/// | [`processes`](Self::processes), [`durations`](Self::durations) | [`ProcessTable::builtin`], [`Durations::builtin`] |
/// | [`processes_at_once`](Self::processes_at_once) | no: they take their time |
/// | [`begins_at`](Self::begins_at), [`hour`](Self::hour) | noon of day 0 |
/// | [`tolerance`](Self::tolerance) | [`SUPPORT_GAP`](vc_relations::threshold::SUPPORT_GAP): 0.02 m |
/// | `pictures` (feature `render`) | [`PictureOptions::default`](crate::PictureOptions): noon, a field of view of 1.15 rad, eyes at the head of each body |
/// | `camera`, `sensor` (feature `render`) | no others than [`cameras`](Environment::cameras) lists in every home |
/// | `threads` (feature `render`) | those of the rayon pool that pictures are asked for in: as many as there are cores |
///
/// ```
/// use virtualcity::Environment;
/// let mut moon = Environment::builder("apartment/42").agents(2).gravity(1.62).make()?;
/// assert_eq!(moon.agents().len(), 2);
/// assert_eq!(moon.world().settings().gravity, 1.62);
/// # Ok::<(), virtualcity::MakeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct EnvironmentBuilder {
    source: Source,
    agents: usize,
    vocabulary: Option<Arc<Vocabulary>>,
    settings: EnvironmentSettings,
}

/// The scene that an environment is made of.
#[derive(Debug, Clone)]
enum Source {
    Name(String),
    Graph(Box<SceneGraph>),
}

/// The settings of an environment.
#[derive(Debug, Clone)]
pub(super) struct EnvironmentSettings {
    pub(super) assets: Assets,
    pub(super) classes: Arc<ClassTable>,
    pub(super) physics: vc_physics::Settings,
    pub(super) relations: RelationRule,
    pub(super) time: TimeSettings,
    pub(super) tolerance: f32,
    /// Whether there may be nobody in it: agents come from elsewhere.
    pub(super) unpeopled: bool,
    /// The surroundings.
    pub(super) around: Arc<super::Around>,
    /// An hour that was asked for and is none.
    pub(super) no_hour: Option<f32>,
    #[cfg(feature = "render")]
    pub(super) pictures: crate::PictureOptions,
    #[cfg(feature = "render")]
    pub(super) cameras: Vec<crate::NamedCamera>,
    #[cfg(feature = "render")]
    pub(super) sensors: Vec<super::sensing::NamedSensor>,
    #[cfg(feature = "render")]
    pub(super) threads: Option<usize>,
}

impl EnvironmentSettings {
    fn new(assets: Assets) -> Self {
        Self {
            assets,
            classes: ClassTable::builtin(),
            physics: vc_physics::Settings::default(),
            relations: RelationRule::Contacts,
            time: TimeSettings::default(),
            tolerance: SUPPORT_GAP,
            unpeopled: false,
            around: Arc::default(),
            no_hour: None,
            #[cfg(feature = "render")]
            pictures: crate::PictureOptions::default(),
            #[cfg(feature = "render")]
            cameras: Vec::new(),
            #[cfg(feature = "render")]
            sensors: Vec::new(),
            #[cfg(feature = "render")]
            threads: None,
        }
    }
}

impl EnvironmentBuilder {
    fn new(source: Source, assets: Assets) -> Self {
        Self { source, agents: 1, vocabulary: None, settings: EnvironmentSettings::new(assets) }
    }

    /// The number of agents. Agents that the scene has are kept, others are added until there are so many.
    pub fn agents(mut self, agents: usize) -> Self {
        self.agents = agents;
        self
    }

    /// The same settings for another scene.
    pub(crate) fn scene(self, graph: SceneGraph) -> Self {
        Self { source: Source::Graph(Box::new(graph)), ..self }
    }

    /// Without agents: they come from elsewhere.
    pub(crate) fn unpeopled(mut self) -> Self {
        (self.agents, self.settings.unpeopled) = (0, true);
        self
    }

    /// With walls and floors around it that are no things of it.
    pub(crate) fn amid(mut self, around: super::Around) -> Self {
        self.settings.around = around.into();
        self
    }

    /// The shapes for things that have a class and a box and no shape.
    pub fn assets(mut self, assets: Assets) -> Self {
        self.settings.assets = assets;
        self
    }

    /// The classes that a scene is read with. A scene that is generated or given as a graph has its own.
    pub fn classes(mut self, classes: impl Into<Arc<ClassTable>>) -> Self {
        self.settings.classes = classes.into();
        self
    }

    /// The words of the scene, instead of those that come with it or with its classes.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::Vocabulary;
    /// let words = Vocabulary::parse("words.txt", "verb bow 0 | motion: stretch")?;
    /// let mut home = Environment::builder("apartment/9").vocabulary(words).make()?;
    /// home.set_action(home.agents()[0], "bow".parse()?)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn vocabulary(mut self, words: impl Into<Arc<Vocabulary>>) -> Self {
        self.vocabulary = Some(words.into());
        self
    }

    /// Whether bodies do the actions. Without, the transition rule alone says their outcome, as in a
    /// [`Simulator`](vc_graph::Simulator), with the clock, its processes and durations: an action takes the time of
    /// [`durations`](Self::durations), or 1.5 s. Bodies, poses and so pictures stay as they were; relations and states
    /// change.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// let mut home = Environment::builder("apartment/42").bodies(false).make()?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// let (feet, near) = (home.world().pose(me), home.graph().near(me, fridge));
    /// home.set_action(me, format!("walk fridge.{}", fridge.0).parse()?)?;
    /// assert!(!near && home.graph().near(me, fridge));
    /// assert_eq!(home.world().pose(me), feet);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bodies(mut self, bodies: bool) -> Self {
        self.settings.time.bodies = bodies;
        self
    }

    /// The settings of the bodies: gravity, the fixed things, friction of hinges, latches. A step is a tick of 1/60 s.
    pub fn physics(mut self, settings: vc_physics::Settings) -> Self {
        self.settings.physics = settings;
        self
    }

    /// Acceleration of free fall, metres per second squared, downwards.
    pub fn gravity(mut self, gravity: f32) -> Self {
        self.settings.physics.gravity = gravity;
        self
    }

    /// The rule by which relations are read from geometry. The transition rule expects those of
    /// [`RelationRule::Contacts`]; with the others more actions end in a disagreement of rule and bodies.
    pub fn relations(mut self, rule: RelationRule) -> Self {
        self.settings.relations = rule;
        self
    }

    /// The processes that machines and matter go through while time passes, and their times. None may open or close
    /// things that have bodies.
    pub fn processes(mut self, table: impl Into<Arc<ProcessTable>>) -> Self {
        self.settings.time.processes = table.into();
        self
    }

    /// Lets processes end in the tick in which they begin: what a machine washes is clean at once.
    pub fn processes_at_once(mut self) -> Self {
        self.settings.time.at_once = true;
        self
    }

    /// How long actions take that neither a body's motion nor a process times.
    pub fn durations(mut self, table: impl Into<Arc<Durations>>) -> Self {
        self.settings.time.durations = table.into();
        self
    }

    /// The day and time at which the environment begins. Pictures show the light of that time, which does not go on with
    /// the clock, as it is computed anew for another hour: [`Environment::set_pictures`] sets another. Whole
    /// [options of pictures](Self::pictures) that are set afterwards have an hour of their own. Day and weather change no light.
    pub fn begins_at(mut self, time: DayTime) -> Self {
        self.settings.time.begin = time;
        self.settings.no_hour = None;
        #[cfg(feature = "render")]
        {
            self.settings.pictures.daylight = vc_render::Daylight::at(time.hour());
        }
        self
    }

    /// The hour of day 0 at which the environment begins, from 0 up to 24, 24 excluded: [`begins_at`](Self::begins_at) in
    /// another form, to the second.
    ///
    /// ```
    /// use virtualcity::{Environment, MakeError};
    /// let evening = Environment::builder("apartment/42").hour(19.5).make()?;
    /// assert_eq!(evening.day_time().to_string(), "day 0, 19:30:00");
    /// let never = Environment::builder("apartment/42").hour(f32::NAN).make();
    /// assert!(matches!(never, Err(MakeError::Hour(_))));
    /// # Ok::<(), MakeError>(())
    /// ```
    pub fn hour(mut self, hour: f32) -> Self {
        if !(0.0..24.0).contains(&hour) {
            self.settings.no_hour = Some(hour);
            return self;
        }
        self.begins_at(DayTime::new(0, ((hour * 3600.0).round() as u32).min(LAST_SECOND)))
    }

    /// The distance down to a support up to which a thing is on it, metres: 0 to
    /// [`BOX_GAP`](vc_relations::threshold::BOX_GAP). With less than some millimetres, things at rest count as on nothing,
    /// and actions end in disagreements.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// let exact = Environment::builder("apartment/42").tolerance(0.01).make()?;
    /// assert_eq!(exact.relations().tolerance(), 0.01);
    /// assert!(Environment::builder("apartment/42").tolerance(-1.0).make().is_err());
    /// # Ok::<(), virtualcity::MakeError>(())
    /// ```
    pub fn tolerance(mut self, tolerance: f32) -> Self {
        self.settings.tolerance = tolerance;
        self
    }

    /// The options of pictures: [`Environment::set_pictures`]. Its daylight takes the place of that of an
    /// [`hour`](Self::hour) that was set before.
    #[cfg(feature = "render")]
    pub fn pictures(mut self, options: crate::PictureOptions) -> Self {
        self.settings.pictures = options;
        self
    }

    /// Adds a camera: [`Environment::add_camera`]. One on an agent that is still to be made is added afterwards, since
    /// its number is not known before.
    #[cfg(feature = "render")]
    pub fn camera(mut self, name: impl Into<String>, mount: crate::Mount, lens: crate::Lens) -> Self {
        self.settings.cameras.push(crate::NamedCamera { name: name.into(), mount, lens });
        self
    }

    /// Adds a sensor: [`Environment::add_sensor`].
    ///
    /// ```
    /// use virtualcity::graph::Pose;
    /// use virtualcity::sensors::Lidar;
    /// use virtualcity::{Environment, Mount};
    /// let tripod = Mount::Fixed(Pose::translation(2.0, 2.0, 1.2));
    /// let home = Environment::builder("apartment/42").sensor("lidar", tripod, Lidar::default()).threads(1).make()?;
    /// assert_eq!(home.sensors().count(), 1);
    /// # Ok::<(), virtualcity::MakeError>(())
    /// ```
    #[cfg(feature = "render")]
    pub fn sensor(
        mut self,
        name: impl Into<String>,
        mount: crate::Mount,
        sensor: impl super::Sensor + 'static,
    ) -> Self {
        self.settings.sensors.push(super::sensing::NamedSensor { name: name.into(), mount, sensor: Arc::new(sensor) });
        self
    }

    /// The number of threads on which pictures are made and sensors are read, shared with clones: 1 to 1,024. Everything
    /// else an environment does takes one thread, and no result depends on their number. [`Batch`](crate::Batch) runs
    /// environments side by side.
    #[cfg(feature = "render")]
    pub fn threads(mut self, threads: usize) -> Self {
        self.settings.threads = Some(threads);
        self
    }

    /// Makes the environment. Costs what [`Environment::make`] costs.
    ///
    /// # Errors
    /// [`MakeError`].
    pub fn make(self) -> Result<Environment, MakeError> {
        if let Some(hour) = self.settings.no_hour {
            return Err(MakeError::Hour(hour));
        }
        let step = self.settings.physics.dt;
        if (step * TICKS_PER_SECOND as f32 - 1.0).abs() > 1e-4 {
            return Err(MakeError::TimeStep(step));
        }
        let TimeSettings { bodies, processes, .. } = &self.settings.time;
        let moves = [State::Open, State::Closed].into_iter().find(|state| processes.brings_about(*state));
        if let Some(state) = moves.filter(|_| *bodies) {
            return Err(MakeError::Process(state));
        }
        let mut graph = match self.source {
            Source::Name(name) => scene::named(&name, &self.settings.classes)?,
            Source::Graph(graph) => *graph,
        };
        if let Some(words) = self.vocabulary {
            graph.set_vocabulary(words);
        }
        Environment::with_settings(graph, self.agents, &self.settings)
    }
}

impl Environment {
    /// A builder of the environment with a name, as in [`make`](Self::make), for settings other than the defaults.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// let evening = Environment::builder("apartment/42").agents(2).hour(19.5).make()?;
    /// # Ok::<(), virtualcity::MakeError>(())
    /// ```
    pub fn builder(name: impl Into<String>) -> EnvironmentBuilder {
        EnvironmentBuilder::new(Source::Name(name.into()), Assets::Generated)
    }

    /// A builder of the environment of a scene of your own, as in [`from_scene`](Self::from_scene).
    pub fn builder_from_scene(graph: SceneGraph) -> EnvironmentBuilder {
        EnvironmentBuilder::new(Source::Graph(Box::new(graph)), Assets::None)
    }
}
