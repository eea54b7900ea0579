//! Cities as bytes.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use vc_graph::clock::Tick;
use vc_graph::format::native;
use vc_graph::space::RegionId;
use vc_graph::{ClassTable, Digest, NodeId, ObjectNames, SceneBuilder, SceneGraph};

use super::dormant::{Changes, Dormant};
use super::journey::Journey;
use super::lift::{Lift, Lifts};
use super::{City, CityError, RegionLabel, source};
use crate::Environment;
use crate::environment::SaveError;
use crate::parts::{self, Magic, PartsFault};

/// The bytes with which saved cities begin.
const MAGIC: &Magic = b"VCCITY2\n";

/// All of a city but its regions.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SavedCity {
    /// The digest of the plan.
    plan: u64,
    tick: Tick,
    agents: Vec<NodeId>,
    /// Where agents began; missing in saves from before this was known.
    #[serde(default)]
    homes: BTreeMap<NodeId, RegionId>,
    whereabouts: BTreeMap<NodeId, RegionId>,
    journeys: BTreeMap<NodeId, Journey>,
    /// The changes of each journey so far, as text: it takes classes to read them.
    changes: BTreeMap<NodeId, String>,
    /// The names by which the actions of journeys call their things.
    called: BTreeMap<NodeId, ObjectNames>,
    lifts: BTreeMap<RegionId, Lift>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    stops: BTreeMap<NodeId, bool>,
    /// The settings of the regions.
    settings: Option<String>,
    /// The regions in the order of the parts that follow.
    regions: Vec<SavedRegion>,
    /// Regions whose scenes as they are made are in the parts after that, and the next number of each; none unless it was saved whole.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    scenes: Vec<(RegionId, u32)>,
}

/// A region of a saved city. Its difference from its reference is a part of its own.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SavedRegion {
    region: RegionId,
    is_active: bool,
    /// Digest of its scene as it is made.
    start: u64,
    /// Digest of the bytes from which it differs.
    reference: u64,
}

/// Why a city cannot be saved or restored.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum CitySaveError {
    /// Endings of actions would be lost.
    #[error("{0} endings of actions would be lost: let `step` return them first, by `step(Span(0))`")]
    Unread(usize),
    /// The bytes are no saved city.
    #[error("these bytes are no saved city, or of another version")]
    NotSaved,
    /// The bytes have changed since they were saved, or some are missing.
    #[error("the saved city is damaged")]
    Damaged,
    /// The city was made of another plan.
    #[error("the city was saved with another plan of regions: make this one of the same name or source")]
    OtherPlan,
    /// The city has another number of agents.
    #[error("the city was saved with {saved} agents, and this one has {here}: make it with as many")]
    OtherAgents {
        /// The number of those that were saved.
        saved: usize,
        /// The number of those of the city that was to restore it.
        here: usize,
    },
    /// The scene of a region is another one than when the city was saved.
    #[error(
        "{0} is made otherwise than when the city was saved: its generator or the settings have changed; \
         a city that `save_whole` saved does not need the generator"
    )]
    OtherRegion(RegionLabel),
    /// A region cannot be saved or restored.
    #[error("{region}: {why}")]
    Region {
        /// The region.
        region: RegionLabel,
        /// The reason.
        #[source]
        why: Arc<SaveError>,
    },
    /// A region cannot be made.
    #[error(transparent)]
    City(#[from] Box<CityError>),
    /// The text of a part cannot be read.
    #[error("the saved city cannot be read: {0}")]
    Text(Arc<serde_json::Error>),
}

impl From<serde_json::Error> for CitySaveError {
    fn from(why: serde_json::Error) -> Self {
        Self::Text(Arc::new(why))
    }
}

impl From<PartsFault> for CitySaveError {
    fn from(why: PartsFault) -> Self {
        if why == PartsFault::Foreign { Self::NotSaved } else { Self::Damaged }
    }
}

impl City {
    /// The city as bytes, for [`restore`](Self::restore), at any time, also in the middle of journeys: what differs in each
    /// region from how it is made, with bodies and actions as [`Environment::save`] has them, who is where, ways and lifts.
    /// Regions that are as they are made and have nobody in them take nothing. [`set_ways`](Self::set_ways) is not in it.
    ///
    /// A home in which somebody lives takes some tens of kilobytes (seven megabytes whole), and the time to make and write it.
    ///
    /// ```
    /// use virtualcity::City;
    /// use virtualcity::graph::clock::Span;
    /// use virtualcity::graph::space::RegionId;
    /// let mut city = City::make("building/7", 1)?;
    /// let me = city.agents().next().ok_or("somebody")?;
    /// let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("a yard")?.0;
    /// city.send(me, yard)?;
    /// city.step(Span::from_seconds(5.0));
    /// // On the way.
    /// let mut other = City::make("building/7", 1)?.restore(&city.save()?)?;
    /// let minutes = Span::from_seconds(120.0);
    /// assert_eq!(city.step(minutes).len(), other.step(minutes).len());
    /// assert_eq!(city.digest(), other.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CitySaveError::Unread`] if endings wait for the next [`step`](Self::step), [`CitySaveError::Region`].
    pub fn save(&self) -> Result<Vec<u8>, CitySaveError> {
        self.saved(&BTreeMap::new())
    }

    /// The city as bytes as by [`save`](Self::save), with the scenes as they are made of all regions of which something is saved,
    /// and of those beyond their portals: it is restored although their generator makes others now. The plan has
    /// to be the same. Regions that nobody has been near are made by the generator as it is.
    ///
    /// A home takes some megabytes.
    ///
    /// # Errors
    /// As [`save`](Self::save); [`CitySaveError::City`] if a scene cannot be made.
    pub fn save_whole(&self) -> Result<Vec<u8>, CitySaveError> {
        let known: BTreeSet<RegionId> = self.active.keys().chain(self.asleep.keys()).copied().collect();
        let beyond = known.iter().flat_map(|region| self.gates(*region).map(|(.., across)| across.region));
        let all: BTreeSet<RegionId> = beyond.chain(known.iter().copied()).collect();
        let fault = |region, why: source::SceneFault| {
            Box::new(CityError::Scene { region: self.region_label(region), why: why.into() })
        };
        let scene = |region| Ok((region, self.source.scene(region).map_err(|why| fault(region, why))?));
        self.saved(&all.into_iter().map(scene).collect::<Result<_, CitySaveError>>()?)
    }

    fn saved(&self, scenes: &BTreeMap<RegionId, SceneGraph>) -> Result<Vec<u8>, CitySaveError> {
        let unread = self.endings.len() + self.active.values().map(Environment::unread_endings).sum::<usize>();
        if unread > 0 {
            return Err(CitySaveError::Unread(unread));
        }
        let mut regions = Vec::new();
        for (region, environment) in &self.active {
            let changes = self.changes_of(*region, environment).map_err(Box::new)?;
            regions.push((self.saved_region(*region, true, &changes)?, Arc::new(changes)));
        }
        for (region, dormant) in &self.asleep {
            let changes = match dormant {
                Dormant::Changes(changes) => changes.clone(),
                Dormant::Whole(environment) => self.changes_of(*region, environment).map_err(Box::new)?.into(),
            };
            regions.push((self.saved_region(*region, false, &changes)?, changes));
        }
        let settings = self.active.iter().next().map(|(region, environment)| {
            let fault = |why| CitySaveError::Region { region: self.region_label(*region), why: Arc::new(why) };
            environment.saved_settings().map_err(fault)
        });
        let changes =
            self.journeys.iter().map(|(agent, journey)| Ok((*agent, serde_json::to_string(&journey.changes)?)));
        let called = self.journeys.iter().filter_map(|(agent, journey)| Some((*agent, journey.action?.called)));
        let saved = SavedCity {
            plan: self.space().digest().0,
            tick: self.tick,
            agents: self.agents.clone(),
            homes: self.homes.clone(),
            whereabouts: self.whereabouts.clone(),
            changes: changes.collect::<Result<_, serde_json::Error>>()?,
            called: called.collect(),
            journeys: self.journeys.clone(),
            lifts: self.lifts.all().clone(),
            stops: self.stops.clone(),
            settings: settings.transpose()?,
            regions: regions.iter().map(|(saved, _)| *saved).collect(),
            scenes: scenes.iter().map(|(region, scene)| (*region, scene.next_number())).collect(),
        };
        let head = serde_json::to_vec(&saved)?;
        let changes = regions.iter().map(|(_, changes)| changes.bytes.as_slice());
        let texts: Vec<String> = scenes.values().map(native::write).collect();
        let scenes = texts.iter().map(String::as_bytes);
        let parts: Vec<&[u8]> = std::iter::once(head.as_slice()).chain(changes).chain(scenes).collect();
        Ok(parts::joined(MAGIC, &parts))
    }

    /// Restores a saved city, which then goes on as the saved one does, bit for bit. `self` has to have been made of the
    /// same plan with the same settings, and is not changed; [ways](Self::set_ways) are those of `self`. Makes the regions
    /// that were saved anew, some milliseconds each, and holds their scenes against those of the saved city.
    ///
    /// # Errors
    /// [`CitySaveError`]; [`CitySaveError::OtherRegion`] names a region whose generator has changed, unless the city was
    /// [saved whole](Self::save_whole).
    pub fn restore(&self, bytes: &[u8]) -> Result<Self, CitySaveError> {
        let parts = parts::split(MAGIC, bytes)?;
        let (head, regions) = parts.split_first().ok_or(CitySaveError::NotSaved)?;
        let mut saved: SavedCity = serde_json::from_slice(head)?;
        if !saved.scenes.is_empty() {
            let (regions, texts) = regions.split_at_checked(saved.regions.len()).ok_or(CitySaveError::NotSaved)?;
            let scenes = std::mem::take(&mut saved.scenes);
            let known = self.with_scenes(&scenes, texts)?;
            return known.restored(saved, regions);
        }
        self.restored(saved, regions)
    }

    /// This city, in which the scenes of some regions are those of a save and not the generator's.
    fn with_scenes(&self, scenes: &[(RegionId, u32)], texts: &[&[u8]]) -> Result<Self, CitySaveError> {
        if scenes.len() != texts.len() {
            return Err(CitySaveError::NotSaved);
        }
        let scene = |((region, next), text): (&(RegionId, u32), &&[u8])| {
            let fault = |why| CitySaveError::Region { region: self.region_label(*region), why: Arc::new(why) };
            let classes =
                self.source.scene(*region).map_or_else(|_| ClassTable::builtin(), |now| now.classes().clone());
            let text = std::str::from_utf8(text).map_err(|_| CitySaveError::NotSaved)?;
            let mut builder = SceneBuilder::from_graph(native::read(text, &classes).map_err(|why| fault(why.into()))?);
            builder.number_from(*next);
            Ok((*region, builder.build()))
        };
        let known = scenes.iter().zip(texts).map(scene).collect::<Result<_, CitySaveError>>()?;
        let source = Arc::new(source::Known { known, others: self.source.clone() });
        // Whatever was made of the generator's scenes is of no use.
        Ok(Self { source, glances: Arc::default(), ..self.clone() })
    }

    fn restored(&self, mut saved: SavedCity, regions: &[&[u8]]) -> Result<Self, CitySaveError> {
        if saved.plan != self.space().digest().0 {
            return Err(CitySaveError::OtherPlan);
        }
        if saved.agents.len() != self.agents.len() {
            return Err(CitySaveError::OtherAgents { saved: saved.agents.len(), here: self.agents.len() });
        }
        if saved.regions.len() != regions.len() {
            return Err(CitySaveError::NotSaved);
        }
        let (mut active, mut asleep) = (BTreeMap::new(), BTreeMap::new());
        for (saved_region, bytes) in saved.regions.iter().zip(regions) {
            let restored = self.restored_region(saved_region, saved.settings.as_deref(), bytes)?;
            if saved_region.is_active {
                active.insert(saved_region.region, restored);
            } else {
                let changes = Changes { bytes: bytes.to_vec(), reference: Digest(saved_region.reference) };
                asleep.insert(saved_region.region, Dormant::Changes(changes.into()));
            }
        }
        if !self.is_sound(&saved, &active) {
            return Err(CitySaveError::Damaged);
        }
        for (agent, journey) in &mut saved.journeys {
            // Somebody under way is somewhere.
            let at = saved.whereabouts.get(agent).and_then(|region| Some((*region, active.get(region)?)));
            let (region, environment): (RegionId, &Environment) = at.ok_or(CitySaveError::NotSaved)?;
            let changes = saved.changes.get(agent).map_or("[]", String::as_str);
            let changes = native::read_changes(changes, environment.graph().classes()).map_err(|why| {
                CitySaveError::Region { region: self.region_label(region), why: Arc::new(why.into()) }
            })?;
            journey.take_up(saved.called.get(agent).copied(), changes);
        }
        let lifts = Lifts::restored(saved.lifts, self.space()).ok_or(CitySaveError::NotSaved)?;
        Ok(Self {
            tick: saved.tick,
            active,
            asleep,
            whereabouts: saved.whereabouts,
            agents: saved.agents,
            homes: if saved.homes.is_empty() { self.homes.clone() } else { saved.homes },
            journeys: saved.journeys,
            lifts,
            stops: saved.stops,
            endings: Vec::new(),
            orders: None,
            ..self.clone()
        })
    }

    /// Whether everybody is somewhere once, all regions are at the tick, and ways lead through portals.
    fn is_sound(&self, saved: &SavedCity, active: &BTreeMap<RegionId, Environment>) -> bool {
        let is_there = |agent: &NodeId| {
            let region = saved.whereabouts.get(agent).and_then(|region| active.get(region));
            region.is_some_and(|environment| environment.agents().contains(agent))
        };
        let once = saved.agents.iter().collect::<BTreeSet<_>>().len() == saved.agents.len();
        let known = |region: &RegionId| self.space().region(*region).is_some();
        once && saved.agents.iter().all(is_there)
            && saved.journeys.keys().all(|agent| saved.agents.contains(agent))
            && saved.homes.values().all(known)
            && active.values().all(|environment| environment.tick() == saved.tick)
            && saved.journeys.values().all(|journey| journey.is_sound(self.space(), saved.tick))
    }

    fn saved_region(&self, region: RegionId, is_active: bool, changes: &Changes) -> Result<SavedRegion, CitySaveError> {
        let start = self.first(region).map_err(Box::new)?.start().digest().0;
        Ok(SavedRegion { region, is_active, start, reference: changes.reference.0 })
    }

    /// A region with its changes, if it is still made as when it was saved.
    fn restored_region(
        &self,
        saved: &SavedRegion,
        settings: Option<&str>,
        changes: &[u8],
    ) -> Result<Environment, CitySaveError> {
        let reference = self.reference(saved.region).map_err(Box::new)?;
        let fault = |why| CitySaveError::Region { region: self.region_label(saved.region), why: Arc::new(why) };
        settings.map_or(Ok(()), |settings| reference.made.check_settings(settings)).map_err(fault)?;
        let is_same = reference.made.start().digest().0 == saved.start && reference.digest().0 == saved.reference;
        if !is_same {
            return Err(CitySaveError::OtherRegion(self.region_label(saved.region)));
        }
        reference.restored(changes).map_err(fault)
    }
}
