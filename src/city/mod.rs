//! A city: regions joined by portals, in which agents go from one to another.
//!
//! [`source`] is where scenes come from, [`residency`] which regions are there, [`dormant`] what is kept of the
//! others, [`journey`] how agents get from one to
//! another, [`leg`] by leg, by [passages](passage) along [ways](way) on which they [heed](heed) each other from
//! [spots](spot) where they stand, [`door`] the doors between two
//! regions, [`doorway`] what is in them, [`lift`] how cabins move, [`things`] what goes through portals by itself and what is in its way at the
//! [`border`], [`time`] how all of it goes on, [`save`] cities as bytes, [`record`] what was ordered, [`whole`] cities as one
//! scene; [`measures`] has all speeds, times and sizes.

mod border;
mod door;
mod doorway;
mod dormant;
mod error;
mod fall;
mod goal;
mod heed;
mod journey;
mod leg;
mod lift;
mod make;
mod measures;
mod observation;
mod passage;
mod peek;
#[cfg(feature = "render")]
mod picture;
mod record;
mod residency;
mod save;
#[cfg(feature = "render")]
mod sight;
mod source;
mod spot;
mod things;
mod time;
mod way;
mod whole;

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::clock::Tick;
use vc_graph::hash::Digester;
use vc_graph::space::{Portal, PortalId, PortalState, RegionFrame, RegionId, Space};
use vc_graph::{Action, Digest, Label, NodeId, Pose};

use crate::{Environment, EnvironmentBuilder};

use dormant::Dormant;
pub use error::{CityError, RegionLabel};
pub use goal::GoalScope;
use journey::Journey;
pub use lift::LiftState;
use lift::Lifts;
pub use make::CityBuilder;
pub use observation::{Beyond, CityObservation};
#[cfg(feature = "render")]
pub use picture::CityView;
pub use record::{CityRecord, ReplayError};
pub use save::CitySaveError;
pub use source::RegionScenes;
pub use time::CityEnding;
pub use whole::CityViolation;

/// Regions joined by portals, each with an [`Environment`] of its own while somebody is in it: a building, a street, a city.
///
/// An agent is in one region at a time. An action with things of its region is done there as in a single home; a walk to
/// something in another region leads through portals, over stairs and by lift, and takes along what the agent carries.
/// Regions without agents go on until all in them rests, then they cost nothing: whatever happens in them with time is made
/// up for when somebody comes. No result depends on when that is.
///
/// ```
/// use virtualcity::City;
/// use virtualcity::graph::space::RegionKind;
/// let mut city = City::make("building/7", 1)?;
/// let me = city.agents().next().ok_or("somebody")?;
/// // The first home on the storey above.
/// let units = city.space().regions().filter(|(_, region)| region.kind == RegionKind::Unit);
/// let above = units.map(|(id, _)| id).nth(2).ok_or("a home")?;
/// city.go(me, above)?;
/// assert_eq!(city.region_of(me), Some(above));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct City {
    source: Arc<dyn RegionScenes>,
    /// The settings of the environments.
    settings: EnvironmentBuilder,
    tick: Tick,
    /// The regions that are there.
    active: BTreeMap<RegionId, Environment>,
    /// Those that somebody has changed.
    asleep: BTreeMap<RegionId, Dormant>,
    /// Where agents are, and things that are not where they were made.
    whereabouts: BTreeMap<NodeId, RegionId>,
    agents: Vec<NodeId>,
    /// Where they began.
    homes: BTreeMap<NodeId, RegionId>,
    journeys: BTreeMap<NodeId, Journey>,
    /// The portals that agents take, if not all.
    ways: BTreeMap<NodeId, Ways>,
    lifts: Lifts,
    /// Those who are to end what they do before time goes on, and whether that is told.
    stops: BTreeMap<NodeId, bool>,
    endings: Vec<time::CityEnding>,
    /// No part of the state: what was ordered, if it is written down.
    orders: Option<CityRecord>,
    /// No part of the state: regions for whoever looks.
    glances: Arc<peek::Glances>,
}

/// Which portals somebody takes.
type Ways = Arc<dyn Fn(&Portal) -> bool + Send + Sync>;

impl City {
    /// The plan of the regions.
    pub fn space(&self) -> &Arc<Space> {
        self.source.space()
    }

    /// The agents, in the order in which they came.
    pub fn agents(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.agents.iter().copied()
    }

    /// The time that has passed since the city was made.
    pub fn tick(&self) -> Tick {
        self.tick
    }

    /// The region of a node: where it is, or was made. A number that no node has may have a region, too.
    pub fn region_of(&self, node: NodeId) -> Option<RegionId> {
        self.whereabouts.get(&node).copied().or_else(|| self.space().made_in(node))
    }

    /// The environment of a region that is there: somebody is in it, or something in it still moves.
    pub fn environment(&self, region: RegionId) -> Option<&Environment> {
        self.active.get(&region)
    }

    /// The regions that are there, in order.
    pub fn active(&self) -> impl Iterator<Item = RegionId> + '_ {
        self.active.keys().copied()
    }

    /// The environment of the region that an agent is in.
    pub fn environment_of(&self, agent: NodeId) -> Option<&Environment> {
        self.environment(self.region_of(agent)?)
    }

    /// Class and number of a node, for messages; the class is `?` where its region is not there.
    pub fn label(&self, id: NodeId) -> Label {
        let node = self.region_of(id).and_then(|region| self.environment(region)?.graph().node(id));
        node.map_or_else(|| Label { class: "?".into(), id }, vc_graph::Node::label)
    }

    /// A region as messages name it: by its path.
    pub fn region_label(&self, region: RegionId) -> RegionLabel {
        RegionLabel::new(self.space(), region)
    }

    /// The action that an agent is doing or is about to begin: a walk to another region as it was given. One that was
    /// [sent](Self::send) to a region has none, and [is busy](Self::is_busy).
    pub fn current_action(&self, agent: NodeId) -> Option<&Action> {
        match self.journeys.get(&agent) {
            Some(journey) => journey.action.as_ref(),
            None if self.stops.contains_key(&agent) => None,
            None => self.environment_of(agent)?.current_action(agent),
        }
    }

    /// Whether an agent has something to do: an action, or a way to another region.
    pub fn is_busy(&self, agent: NodeId) -> bool {
        let acts = || self.environment_of(agent).is_some_and(|there| there.current_action(agent).is_some());
        self.journeys.contains_key(&agent) || (!self.stops.contains_key(&agent) && acts())
    }

    /// Where a region is now, in the world: the cabin of a lift moves.
    pub fn frame(&self, region: RegionId) -> Option<RegionFrame> {
        let plan = self.space().region(region)?;
        Some(self.lifts.get(region).map_or(plan.frame, |lift| lift.frame(plan, self.tick)))
    }

    /// The pose of a region's frame in that of another.
    fn pose_in(&self, of: RegionId, region: RegionId) -> Option<Pose> {
        if of == region {
            return Some(Pose::identity());
        }
        Some(self.frame(region)?.to(&self.frame(of)?))
    }

    /// The state of the lift whose cabin is a region.
    pub fn lift(&self, cabin: RegionId) -> Option<LiftState> {
        Some(self.lifts.get(cabin)?.state())
    }

    /// Whether a portal lets people, views and sounds through now. People open and shut doors as they pass; a lift lets
    /// through where its cabin stands with open doors.
    pub fn portal(&self, portal: PortalId) -> Option<PortalState> {
        let plan = self.space().portal(portal)?;
        let open = match (self.lifts.at(plan).map(|(_, lift)| lift), plan.leaf) {
            (Some(lift), _) if !lift.is_open_at(plan.stop) => return Some(PortalState::CLOSED),
            (Some(_), _) => true,
            (None, None) => false,
            (None, Some(leaf)) => self.is_open(leaf),
        };
        Some(plan.state(open))
    }

    /// A number that says whether two cities are the same and will go on alike. Regions in which nothing differs from how
    /// they were made do not count, whoever has looked into them. Costs as much as the environments' own.
    pub fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        hash.words([self.space().digest().0, self.tick.0]);
        let asleep =
            self.asleep.iter().filter_map(|(region, dormant)| Some((region, self.digest_of(*region, dormant)?)));
        let active = self.active.iter().map(|(region, environment)| (region, environment.digest()));
        for (region, digest) in active.chain(asleep).collect::<BTreeMap<_, _>>() {
            hash.words([u64::from(region.0), digest.0]);
        }
        self.whereabouts.iter().for_each(|(node, region)| _ = hash.words([u64::from(node.0), u64::from(region.0)]));
        self.journeys.iter().for_each(|(agent, journey)| journey.feed(*agent, &mut hash));
        self.lifts.all().values().for_each(|lift| lift.feed(&mut hash));
        self.stops.iter().for_each(|(agent, is_told)| _ = hash.words([u64::from(agent.0), u64::from(*is_told)]));
        hash.digest()
    }

    /// A number for what differs in a region from how it was made; none if nothing does, or nobody has been there.
    pub fn region_digest(&self, region: RegionId) -> Option<Digest> {
        let active = self.active.get(&region).filter(|environment| !environment.is_as_made()).map(Environment::digest);
        active.or_else(|| self.digest_of(region, self.asleep.get(&region)?))
    }

    fn digest_of(&self, region: RegionId, dormant: &Dormant) -> Option<Digest> {
        Some(self.as_woken(region, dormant).ok()?.digest())
    }

    /// Lets an agent take only portals of which something holds: no lifts, say. Windows are never taken. It is no part of
    /// the digest.
    pub fn set_ways(&mut self, agent: NodeId, takes: impl Fn(&Portal) -> bool + Send + Sync + 'static) {
        self.ways.insert(agent, Arc::new(takes));
    }

    fn environment_with(&self, agent: NodeId) -> Result<&Environment, CityError> {
        let known = self.agents.contains(&agent);
        let environment = self.environment_of(agent).filter(|_| known);
        environment.ok_or_else(|| CityError::NoSuchAgent(self.label(agent)))
    }

    fn environment_mut(&mut self, agent: NodeId) -> Option<&mut Environment> {
        let region = self.region_of(agent)?;
        self.active.get_mut(&region)
    }
}

impl std::fmt::Debug for City {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (regions, active, agents) = (self.space().len(), self.active.len(), self.agents.len());
        write!(f, "City({regions} regions, {active} active, {agents} agents, digest {})", self.digest())
    }
}
