//! Environments at rest as what differs from their start: light enough to keep a hundred thousand of them.

mod bytes;
mod error;
mod past;
mod scene;
mod waking;

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::{Label, NodeId};
use vc_people::Activity;
use vc_physics::{BodyRole, RestError, RestRecord};

use super::clock::Clock;
use super::{Environment, Start, observe};
pub use error::StateError;
pub(super) use past::Past;
use past::SavedPast;
use scene::{PackedChanges, SceneDifference};
pub(super) use waking::Waking;
use waking::{Sleeper, read};

/// An environment at rest, as what differs from its start: [`Environment::save_state`] makes it,
/// [`Environment::restore_state`] makes an environment of it.
///
/// It is for searches, which keep many: some kilobytes each, where an environment in which somebody has acted has
/// millions. It lives in memory only; [`Environment::save`] writes bytes for files, also in motion.
#[derive(Clone)]
pub struct EnvironmentState(Arc<Saved>);

struct Saved {
    start: Arc<Start>,
    scene: SceneDifference,
    record: RestRecord,
    past: Option<Arc<SavedPast>>,
    /// Without its journal, which is packed.
    clock: Clock,
    journal: PackedChanges,
    poses: BTreeMap<NodeId, Activity>,
    #[cfg(feature = "render")]
    picture_cache: Arc<super::pictures::PictureCache>,
    #[cfg(feature = "render")]
    cameras: Arc<super::pictures::Cameras>,
}

impl EnvironmentState {
    /// The bytes that it takes beside those that it shares with its environment, with its start and with the state from
    /// which it has come. An allocator adds some tens for each of a few dozen pieces.
    pub fn bytes(&self) -> usize {
        let saved = &*self.0;
        let poses = saved.poses.len() * size_of::<(NodeId, Activity)>();
        let past = saved.past.as_ref().map_or(0, |past| past.bytes());
        size_of::<Saved>()
            + saved.scene.bytes()
            + saved.record.bytes()
            + saved.clock.bytes()
            + saved.journal.bytes()
            + poses
            + past
    }
}

impl EnvironmentState {
    /// The steps that bodies had made.
    pub(super) fn ticks(&self) -> u64 {
        self.0.record.ticks()
    }
}

impl std::fmt::Debug for EnvironmentState {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (name, things) = (self.0.start.graph.name(), self.0.record.things().count());
        write!(f, "EnvironmentState({name}, {things} things differ from the start, {} bytes)", self.bytes())
    }
}

/// # States of a search
impl Environment {
    /// The state of this environment, which is at rest: what differs from its start, some kilobytes.
    ///
    /// Bodies are built anew from what is saved (*rest is a rebuild*), here as in every environment that is restored, so
    /// that all of them evolve alike from then on, bit for bit. An environment that was not saved evolves otherwise in last
    /// digits of poses, as its contacts have another past. Nothing moves by that; a thing that would not stay when it is
    /// built anew, one in thousands, is [pinned](vc_physics::PhysicsWorld::pin).
    ///
    /// Cameras that were added are saved with it; sensors, settings of pictures and threads are not.
    ///
    /// Uses `PhysicsWorld::record`, `Relations::update_with` and `Floor::update`. Costs some milliseconds; of an
    /// environment that was just restored nothing.
    ///
    /// # Errors
    /// [`StateError`]: agents act, things move, a vehicle has driven, a hand is guided.
    ///
    /// ```
    /// use virtualcity::{Environment, StateError};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// home.set_action(me, format!("walk fridge.{}", fridge.0).parse()?)?;
    /// let state = home.save_state()?;
    /// assert!(state.bytes() < 20_000);
    /// let mut other = home.restore_state(&state)?;
    /// for home in [&mut home, &mut other] {
    ///     home.set_action(me, format!("open fridge.{}", fridge.0).parse()?)?;
    /// }
    /// assert_eq!(home.digest(), other.digest());
    /// home.give(me, "wave".parse()?);
    /// assert!(matches!(home.save_state(), Err(StateError::Busy(who)) if who == [home.graph().label(me)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn save_state(&mut self) -> Result<EnvironmentState, StateError> {
        if let Some(state) = self.unchanged_state() {
            return Ok(state);
        }
        if !self.busy().is_empty() {
            return Err(StateError::Busy(self.busy()));
        }
        let mut next = self.clone();
        let state = next.rest_as_saved()?;
        *self = next;
        Ok(state)
    }

    /// Becomes the environment of its own state, and returns that.
    fn rest_as_saved(&mut self) -> Result<EnvironmentState, StateError> {
        self.refuse_in_motion()?;
        self.read_moved()?;
        let named = |error: RestError| error.named(&|id| self.graph.label(id));
        let record = self.world.record(&self.start.world).map_err(named)?;
        if self.start.time.bodies {
            let (_, poses) = observe::write_poses(&mut self.graph, &self.world)?;
            self.clock.note(poses);
        }
        let (relations, floor, _) = read(&self.start, &mut self.world, self.clock.as_read(&self.graph))?;
        (self.relations, self.floor) = (relations.into(), floor.into());
        let scene = SceneDifference::between(&self.start.graph, &self.graph, &record);
        let again = scene.applied_to(&self.start.graph, &record)?;
        if again != self.graph || again.next_number() != self.graph.next_number() {
            return Err(StateError::OtherScene);
        }
        Ok(EnvironmentState(Arc::new(Saved {
            start: self.start.clone(),
            scene,
            record,
            past: self.past.save(),
            clock: self.clock.without_journal(),
            journal: PackedChanges::new(self.changes()),
            poses: self.poses.clone(),
            #[cfg(feature = "render")]
            picture_cache: self.picture_cache.clone(),
            #[cfg(feature = "render")]
            cameras: self.cameras.clone(),
        })))
    }

    /// The environment of a state, which evolves as every other one of that state does, bit for bit. `self` has to have
    /// the same start: it is the environment that was saved, or has been cloned or restored from the same one. It is
    /// not changed.
    ///
    /// The bodies sleep in the state until somebody asks for them: a [`step`](Self::step), an action that the rule
    /// allows, [`world`](Self::world), [`relations`](Self::relations), [`floor`](Self::floor), a
    /// [`digest`](Self::digest). Until then the environment takes some tens of kilobytes, and observations, goals and legal
    /// actions cost what they cost everywhere.
    ///
    /// Costs some hundred microseconds, and the waking of bodies some milliseconds.
    ///
    /// # Errors
    /// [`StateError::OtherStart`], [`StateError::Scene`].
    ///
    /// ```
    /// use virtualcity::{Environment, StateError};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let state = home.save_state()?;
    /// assert_eq!(home.restore_state(&state)?.graph(), home.graph());
    /// let another = Environment::make("apartment/7", 1)?;
    /// assert!(matches!(another.restore_state(&state), Err(StateError::OtherStart)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn restore_state(&self, state: &EnvironmentState) -> Result<Self, StateError> {
        let saved = &*state.0;
        if !Arc::ptr_eq(&self.start, &saved.start) {
            return Err(StateError::OtherStart);
        }
        let graph = saved.scene.applied_to(&self.start.graph, &saved.record)?;
        let sleeper = Arc::new(Sleeper::new(state.clone(), graph.clone()));
        Ok(Self {
            start: self.start.clone(),
            graph,
            world: Waking::Asleep(sleeper.clone()),
            relations: Waking::Asleep(sleeper.clone()),
            floor: Waking::Asleep(sleeper),
            past: Past::restored(saved.past.clone()),
            clock: saved.clock.with_journal(saved.journal.unpacked()),
            poses: saved.poses.clone(),
            #[cfg(feature = "render")]
            picture_cache: saved.picture_cache.clone(),
            #[cfg(feature = "render")]
            pictures: self.pictures,
            #[cfg(feature = "render")]
            cameras: saved.cameras.clone(),
            #[cfg(feature = "render")]
            sensors: self.sensors.clone(),
            #[cfg(feature = "render")]
            threads: self.threads.clone(),
        })
    }

    /// Gives the memory of bodies, relations and floor back until somebody asks for them: some megabytes of an environment that has
    /// acted, of which some tens of kilobytes stay. It is for many environments that are kept side by side, and does what
    /// [`restore_state`](Self::restore_state) of [`save_state`](Self::save_state) does.
    ///
    /// Costs what `save_state` costs.
    ///
    /// # Errors
    /// Those of `save_state`; then nothing has changed.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// let home = Environment::make("apartment/42", 1)?;
    /// let (me, sofa) = (home.agents()[0], home.graph().of_class("sofa")[0]);
    /// let mut copies = vec![home.clone(); 10];
    /// for copy in &mut copies {
    ///     copy.set_action(me, format!("walk sofa.{}", sofa.0).parse()?)?;
    ///     copy.compact()?;
    /// }
    /// assert!(copies.windows(2).all(|pair| pair[0].digest() == pair[1].digest()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compact(&mut self) -> Result<(), StateError> {
        let state = self.save_state()?;
        *self = self.restore_state(&state)?;
        Ok(())
    }

    /// The state that this environment was restored from, if nothing has happened since.
    fn unchanged_state(&self) -> Option<EnvironmentState> {
        let calm = self.busy().is_empty() && self.unread_endings() == 0 && self.clock.controls.is_empty();
        let state = self.world.asleep().filter(|_| calm)?;
        #[cfg(feature = "render")]
        let state = Some(state).filter(|state| Arc::ptr_eq(&state.0.cameras, &self.cameras))?;
        Some(state.clone())
    }

    fn refuse_in_motion(&mut self) -> Result<(), StateError> {
        let busy = self.busy_now();
        if !busy.is_empty() {
            return Err(StateError::Busy(busy));
        }
        match self.unread_endings() {
            0 if self.clock.stirred => Err(RestError::Moves(self.stirring()).into()),
            0 => Ok(()),
            unread => Err(StateError::Unread(unread)),
        }
    }

    /// Things that are awake since something was disturbed, or else what may wake some in the next tick.
    fn stirring(&self) -> Vec<Label> {
        let is_awake = |id: &NodeId| {
            self.world.role(*id) == Some(BodyRole::Loose) && self.world.body(*id).is_ok_and(|body| !body.is_asleep())
        };
        let awake: Vec<NodeId> = self.world.nodes().into_iter().filter(is_awake).collect();
        let stirring = if awake.is_empty() { &self.clock.changed } else { &awake };
        stirring.iter().map(|id| self.graph.label(*id)).collect()
    }
}
