//! Why something cannot be done.

use vc_graph::asset::AssetError;
use vc_graph::format::FormatError;
use vc_graph::{AimPoint, EditError, Label, NodeId, Refusal, SceneGraph, Side, State};
use vc_physics::{AgentError, PhysicsError, SnapshotError};
use vc_procgen::dress::DressError;
use vc_relations::InputError;

use super::{Attempt, Disagreement, Interruption};
use crate::parts::PartsFault;

/// Why there is no environment.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MakeError {
    /// The name is of no kind that is known.
    #[error(
        "`{0}` names no environment; write `apartment/42` or `scene:FILE` (`building/7` has several: `City::make`)"
    )]
    UnknownName(String),
    /// The seed is no number.
    #[error("`{0}` is no seed: a seed is a whole number from 0 to 18446744073709551615")]
    BadSeed(String),
    /// The home could not be generated.
    #[error(transparent)]
    Generation(#[from] vc_procgen::SpecificationError),
    /// The scene file could not be read, or is no scene.
    #[error(transparent)]
    File(#[from] crate::FileError),
    /// Bodies need poses.
    #[error("scene {scene} has no poses: no body can be made of any of its {things} things")]
    NoPoses {
        /// Its name.
        scene: String,
        /// How many things it has.
        things: usize,
    },
    /// There is no free floor for so many agents.
    #[error("there is free floor for {found} agents, {asked} were asked for")]
    NoRoom {
        /// How many were asked for.
        asked: usize,
        /// How many there is floor for.
        found: usize,
    },
    /// There is no such hour.
    #[error("{0} is no hour of a day: an hour is from 0 up to 24, 24 excluded")]
    Hour(f32),
    /// Bodies would not keep step with the clock.
    #[error("a step of {0} s: the clock of an environment has ticks of 1/60 s; `PhysicsWorld` alone takes other steps")]
    TimeStep(f32),
    /// A process opens or closes things, of which their bodies know nothing.
    #[error(
        "the table of processes lets things become `{0}`: with bodies only agents open and close; leave it out, or make the environment without bodies"
    )]
    Process(State),
    /// No agent is allowed to be missing.
    #[error("an environment needs at least one agent: ask for one, or more")]
    NoAgents,
    /// The bodies cannot be made.
    #[error(transparent)]
    Physics(#[from] PhysicsError),
    /// The scene's geometry cannot be read.
    #[error(transparent)]
    Relations(#[from] InputError),
    /// The scene cannot be changed as need be.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// The agents' figure does not fit the scene's shapes.
    #[error(transparent)]
    Asset(#[from] AssetError),
    /// Shapes cannot be made for things that lack one.
    #[error(transparent)]
    Dress(#[from] DressError),
    /// An agent of the scene cannot be put on free floor.
    #[error(transparent)]
    Agent(#[from] AgentError),
    /// A camera or sensor cannot be added.
    #[cfg(feature = "render")]
    #[error(transparent)]
    Camera(#[from] crate::CameraError),
    /// There cannot be so many threads.
    #[cfg(feature = "render")]
    #[error("pictures cannot be made on {threads} threads: ask for 1 to {most}")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// The greatest number of them.
        most: usize,
    },
    /// The threads cannot be started.
    #[cfg(feature = "render")]
    #[error("pictures cannot be made on {threads} threads: {why}")]
    ThreadPool {
        /// How many were asked for.
        threads: usize,
        /// The reason of the thread pool.
        #[source]
        why: rayon::ThreadPoolBuildError,
    },
}

/// Why an environment was not reset; then it is as it was.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResetError {
    /// The graph's agents are not those of this environment.
    #[error(
        "the graph has {}, this environment has {}: its agents cannot be added, removed or replaced",
        agents(.found),
        agents(.expected)
    )]
    OtherAgents {
        /// The agents of the environment.
        expected: Vec<Label>,
        /// The agents of the graph.
        found: Vec<Label>,
    },
    /// The bodies cannot be made.
    #[error(transparent)]
    Physics(#[from] PhysicsError),
    /// The scene's geometry cannot be read.
    #[error(transparent)]
    Relations(#[from] InputError),
    /// The graph cannot be changed as need be.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// Shapes cannot be made for things that lack one.
    #[error(transparent)]
    Dress(#[from] DressError),
}

fn agents(labels: &[Label]) -> String {
    if labels.is_empty() { "no agents".to_owned() } else { format!("the agents {}", in_a_row(labels)) }
}

/// Why an action was not done. After [`Refused`](Self::Refused), [`Busy`](Self::Busy), [`Twice`](Self::Twice) and
/// [`NoEnvironment`](Self::NoEnvironment) nothing has changed. After another error the world is as it was when the action
/// could not go on, at once or in time: the agent may have walked, and a thing may have been put.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ActionError {
    /// The transition rule forbids it, for these reasons.
    #[error("refused: {}", listed(.0))]
    Refused(Vec<Refusal>),
    /// The rule allows it, the bodies cannot do it.
    #[error("{attempt}: {why}")]
    Impossible {
        /// The action or control that was to be done.
        attempt: Attempt,
        /// The reason of the bodies.
        #[source]
        why: PhysicalRefusal,
    },
    /// The bodies did it, and what came out is not what the rule says.
    #[error(transparent)]
    Disagreement(#[from] Box<Disagreement>),
    /// The batch has fewer environments than there are lists of actions.
    #[error("there is no environment {index} for this list of actions: the batch has {of}, counted from 0")]
    NoEnvironment {
        /// The position of the list.
        index: usize,
        /// The number of environments.
        of: usize,
    },
    /// An agent is to do several things at once.
    #[error("{0} is to do several things at once: give one action for each agent")]
    Twice(Label),
    /// An agent that is acting can be neither steered nor controlled, and one under control does not act.
    #[error(
        "{0} is acting or under control: `interrupt` it, which ends both; an action also ends by `step_until_idle`"
    )]
    Busy(Label),
    /// It was begun, and something came between; the world stays as it was then.
    #[error("{attempt}: {why}")]
    Interrupted {
        /// The action that was being done.
        attempt: Attempt,
        /// The reason.
        #[source]
        why: Box<Interruption>,
    },
}

fn listed(refusals: &[Refusal]) -> String {
    refusals.iter().map(Refusal::to_string).collect::<Vec<_>>().join("; ")
}

/// Names the things that are in the way.
fn in_the_way(by: &[Label]) -> String {
    match by {
        [] => "it jams".to_owned(),
        [one] => format!("{one} is in the way"),
        all => format!("{} are in the way", in_a_row(all)),
    }
}

/// Names the things that take up the room.
fn taken_up(by: &[Label]) -> String {
    match by {
        [] => String::new(),
        [one] => format!(": {one} is there"),
        all => format!(": {} are there", in_a_row(all)),
    }
}

/// The first few of some things, and how many more there are.
pub(super) fn in_a_row(labels: &[Label]) -> String {
    const NAMED: usize = 5;
    let named: Vec<String> = labels.iter().take(NAMED).map(Label::to_string).collect();
    let more = labels.len().saturating_sub(NAMED);
    if more == 0 { named.join(", ") } else { format!("{} and {more} more", named.join(", ")) }
}

/// An error: a thing has no room where it is wanted, or no way leads from it to there.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no room for {0} where it is wanted, or no way from it to there")]
pub struct NoRoom(pub Label);

/// Why bodies cannot do an action that the transition rule, which knows no shapes, allows.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PhysicalRefusal {
    /// Nowhere to stand from where it could be reached, or no way there.
    #[error("there is no spot on the floor, with a way to it, from which {0} can be reached")]
    NoStand(Label),
    /// No free spot.
    #[error("there is no free spot for {thing} {where_} {at}{}", taken_up(.by))]
    NoSpot {
        /// The thing to be put.
        thing: Label,
        /// `on` or `in`.
        where_: &'static str,
        /// The surface or container.
        at: Label,
        /// The things that are there already.
        by: Vec<Label>,
    },
    /// Wherever there is room for it, it would shut somebody in.
    #[error("{thing} would be in the way wherever it fits on {at}, and shut somebody in: put it down elsewhere")]
    ShutsIn {
        /// The thing to be put down.
        thing: Label,
        /// The floor on which there is room, but no way past it.
        at: Label,
    },
    /// Wherever there is room for it, a door, lid or drawer could not shut again.
    #[error("{thing} would keep {at} open wherever it fits in: make room for it first, or put it elsewhere")]
    KeepsOpen {
        /// The thing to be put in.
        thing: Label,
        /// The thing that could not be shut.
        at: Label,
    },
    /// It cannot be put where or as the action asks.
    #[error("{thing} cannot be put to {at} as asked: {why}")]
    NotAsAsked {
        /// The thing to be put.
        thing: Label,
        /// The surface or container.
        at: Label,
        /// The reason.
        why: SpotRefusal,
    },
    /// It came to rest elsewhere than the action asks, or turned otherwise.
    #[error("{thing} would be {metres:.2} m and {degrees:.0} degrees from what is asked for: it does not stay there")]
    OffAim {
        /// The thing, or the agent.
        thing: Label,
        /// How far from the point, metres.
        metres: f32,
        /// How far from the heading, degrees.
        degrees: f32,
    },
    /// Nobody can stand at the point.
    #[error("nobody can stand at the point {point}{}", taken_up(.by))]
    PointTaken {
        /// The point.
        point: AimPoint,
        /// The things and people there; none where there is no floor.
        by: Vec<Label>,
    },
    /// There is no way to the point.
    #[error("there is no way over the floor to the point {0}")]
    NoWay(AimPoint),
    /// Nowhere to stand from where the side could be reached.
    #[error("there is no spot on the floor from which the {side} of {thing} can be reached; take it by another side")]
    NoSide {
        /// The thing.
        thing: Label,
        /// The side.
        side: Side,
    },
    /// It rolls or slides off wherever it is put there.
    #[error("{0} does not stay where it is put there: take out or move what it would lie on")]
    Unsteady(Label),
    /// A door, lid or drawer does not open or close.
    #[error("{thing} stays {open:.0}% open: {}", in_the_way(.by))]
    Stuck {
        /// Which.
        thing: Label,
        /// How far open it is, percent.
        open: f32,
        /// The things it would meet on the rest of its way; none if it jams by itself.
        by: Vec<Label>,
    },
    /// Something would end up outside the home: over the edge of a balcony, through a gap.
    #[error("{0} would fall out of the home: move it away from the edge first")]
    FallsOut(Label),
    /// A loose thing does not keep its balance while its lid turns.
    #[error("{0} would fall over where it is: take it out first")]
    Topples(Label),
    /// It has no body.
    #[error("{0} has no body")]
    NoBody(Label),
    /// Bodies do not do this.
    #[error("{0}")]
    NotModelled(&'static str),
    /// The body refuses.
    #[error(transparent)]
    Agent(#[from] AgentError<Label>),
    /// The world refuses.
    #[error(transparent)]
    Physics(#[from] PhysicsError<Label>),
    /// Poses cannot be written into the graph after the action.
    #[error("the outcome cannot be read: {0}")]
    Poses(#[from] EditError),
    /// Relations cannot be read after the action.
    #[error("the outcome cannot be read: {0}")]
    Relations(#[from] InputError),
}

/// The reason why a thing cannot be put where or as an action asks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpotRefusal {
    /// No surface is there.
    #[error("no surface that carries things is there")]
    OffSurface,
    /// Something is too low above it.
    #[error("it is too high for that place")]
    TooLow,
    /// It would reach over an edge.
    #[error("it would not rest there, but reach too far over an edge")]
    WouldNotRest,
    /// A door, lid or drawer could not shut again.
    #[error("a door, lid or drawer could not be shut again")]
    KeepsOpen,
    /// Somebody could not get away any more.
    #[error("it would shut somebody in")]
    ShutsIn,
    /// Other things are there.
    #[error("there is no room{}", taken_up(.0))]
    Taken(Vec<Label>),
}

/// A node of which only the number is known yet.
fn numbered(id: NodeId) -> Label {
    Label { class: "node".into(), id }
}

impl From<AgentError> for PhysicalRefusal {
    fn from(error: AgentError) -> Self {
        Self::Agent(error.named(&numbered))
    }
}

impl From<PhysicsError> for PhysicalRefusal {
    fn from(error: PhysicsError) -> Self {
        Self::Physics(error.named(&numbered))
    }
}

impl PhysicalRefusal {
    /// Whether no surface is where a thing is to be put.
    pub(super) fn is_off_surface(&self) -> bool {
        matches!(self, Self::NotAsAsked { why: SpotRefusal::OffSurface, .. } | Self::Physics(PhysicsError::NoBody(_)))
    }

    /// The same error with a scene's labels for the nodes that bodies know by number.
    pub(super) fn in_scene(self, graph: &SceneGraph) -> Self {
        let label = |known: Label| graph.label(known.id);
        match self {
            Self::Agent(error) => Self::Agent(error.named(&label)),
            Self::Physics(error) => Self::Physics(error.named(&label)),
            other => other,
        }
    }
}

/// Why bytes are no saved environment, or an environment could not be saved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SaveError {
    /// The bytes do not begin as saved environments do, or are cut off.
    #[error("these bytes are not a saved environment")]
    NotSaved,
    /// More follows after a saved environment.
    #[error("{0} bytes follow after the saved environment: give the bytes of `save` alone")]
    More(usize),
    /// They were saved by an environment with another setting that changes what follows. See
    /// [`EnvironmentBuilder`](crate::EnvironmentBuilder).
    #[error(
        "the environment was saved with `{setting}` {found}, this one has {expected}: make it with the same settings"
    )]
    OtherSetting {
        /// The name of the setting, as the builder's method has it, or `physics.` and a field of its settings.
        setting: String,
        /// Its value in this environment.
        expected: String,
        /// Its value in the saved one.
        found: String,
    },
    /// They were saved by an environment that began otherwise.
    #[error(
        "the environment was saved from another start, {found} instead of {expected}: restore it in one that was made \
         of the same scene with as many agents"
    )]
    OtherStart {
        /// Digest of this environment's start.
        expected: vc_graph::Digest,
        /// Digest of the saved one's start.
        found: vc_graph::Digest,
    },
    /// Bytes have changed since they were saved.
    #[error("the saved environment is damaged: its checksum does not fit")]
    Damaged,
    /// Endings of actions have not been asked for, and would be lost.
    #[error("{0} endings of actions have not been read: `step(Span(0))` returns them")]
    Unread(usize),
    /// The settings cannot be written or read.
    #[error("the settings: {0}")]
    Settings(#[source] serde_json::Error),
    /// The clock cannot be written or read.
    #[error("the clock: {0}")]
    Clock(#[source] serde_json::Error),
    /// A scene that the clock remembers does not follow from the present one.
    #[error("the clock: {0}")]
    Remembered(#[source] vc_graph::ChangeMismatch),
    /// The scene in them cannot be read.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The actions in them cannot be read.
    #[error(transparent)]
    Action(#[from] vc_graph::ActionTextError),
    /// The bodies cannot be written or read.
    #[error(transparent)]
    World(#[from] SnapshotError),
    /// The scene's geometry cannot be read.
    #[error(transparent)]
    Relations(#[from] InputError),
    /// The cameras in them cannot be read.
    #[cfg(feature = "render")]
    #[error(transparent)]
    Cameras(#[from] crate::CameraError),
}

impl From<PartsFault> for SaveError {
    fn from(why: PartsFault) -> Self {
        match why {
            PartsFault::Foreign => Self::NotSaved,
            PartsFault::More(more) => Self::More(more),
            PartsFault::Damaged => Self::Damaged,
        }
    }
}

impl From<Disagreement> for ActionError {
    fn from(disagreement: Disagreement) -> Self {
        Self::Disagreement(Box::new(disagreement))
    }
}

impl PhysicalRefusal {
    /// Whether another body or a piece of the home is in the way, rather than the deed being beyond bodies: the same
    /// action may be possible once something has been moved. It is not where there is no floor or surface at all, where a
    /// thing would fall or tip, and where a body is too weak or its reach too short.
    ///
    /// ```
    /// use virtualcity::{ActionError, Environment, PhysicalRefusal};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let table = home.graph().of_class("coffee_table")[0];
    /// let middle = home.graph().node(table).and_then(|node| node.aabb()).ok_or("no box")?.centre();
    /// match home.set_action(me, format!("walk at {:.2} {:.2}", middle.x, middle.y).parse()?) {
    ///     Err(ActionError::Impossible { why, .. }) => assert!(why.is_in_the_way(), "{why}"),
    ///     other => return Err(format!("it stands in the table: {other:?}").into()),
    /// }
    /// let too_weak = PhysicalRefusal::NotModelled("nobody lifts that");
    /// assert!(!too_weak.is_in_the_way());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_in_the_way(&self) -> bool {
        match self {
            Self::NoStand(_)
            | Self::NoSpot { .. }
            | Self::ShutsIn { .. }
            | Self::KeepsOpen { .. }
            | Self::NoWay(_)
            | Self::NoSide { .. }
            | Self::Stuck { .. }
            | Self::Unsteady(_) => true,
            // Without a name there is no floor.
            Self::PointTaken { by, .. } => !by.is_empty(),
            Self::NotAsAsked { why, .. } => !matches!(why, SpotRefusal::OffSurface | SpotRefusal::WouldNotRest),
            Self::Agent(error) => error.is_in_the_way(),
            _ => false,
        }
    }
}
