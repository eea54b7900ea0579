//! Regions in which nobody is: kept as what differs from how they are made.

use std::sync::Arc;

use vc_graph::Digest;
use vc_graph::clock::Span;
use vc_graph::hash::Digester;
use vc_graph::space::RegionId;

use super::measures::MADE;
use super::{City, CityError};
use crate::environment::SaveError;
use crate::{Environment, delta};

/// A region that somebody has changed, while nobody is in it.
#[derive(Clone)]
pub(super) enum Dormant {
    /// The difference from how it is made, where an environment has megabytes.
    Changes(Arc<Changes>),
    /// One that cannot be saved: all of it.
    Whole(Box<Environment>),
}

/// How the save of a region differs from its reference.
pub(super) struct Changes {
    pub(super) bytes: Vec<u8>,
    pub(super) reference: Digest,
}

/// A region as it is made, and the bytes of which its saves consist for the most part, whatever happens there: its own save,
/// its shapes, and those of the agents.
pub(super) struct Reference {
    pub(super) made: Environment,
    bytes: Vec<u8>,
}

impl Reference {
    /// A number for the bytes.
    pub(super) fn digest(&self) -> Digest {
        let mut hash = Digester::new();
        let words = self.bytes.chunks(8).map(|chunk| chunk.iter().fold(0, |word, byte| word << 8 | u64::from(*byte)));
        hash.words(words.chain([self.bytes.len() as u64]));
        hash.digest()
    }

    /// The difference of a region from how it is made.
    pub(super) fn changes(&self, environment: &Environment) -> Result<Changes, SaveError> {
        Ok(self.differing(&environment.save()?))
    }

    /// The difference of a region at rest from how it is made: where things are, and nothing of the engine. It is kept with its
    /// engine if its bodies cannot be built anew where they are.
    fn changes_at_rest(&self, environment: &Environment) -> Result<Changes, SaveError> {
        let mut rested = environment.clone();
        match rested.save_rest() {
            Ok(bytes) if rested.stands_as(environment) => Ok(self.differing(&bytes)),
            _ => self.changes(environment),
        }
    }

    fn differing(&self, bytes: &[u8]) -> Changes {
        Changes { bytes: delta::between(&self.bytes, bytes), reference: self.digest() }
    }

    /// The region with what differs in it.
    pub(super) fn restored(&self, changes: &[u8]) -> Result<Environment, SaveError> {
        let bytes = delta::applied(&self.bytes, changes).ok_or(SaveError::Damaged)?;
        if Environment::is_rest(&bytes) { self.made.restore_rest(&bytes) } else { self.made.restore(&bytes) }
    }
}

impl City {
    /// The reference of a region. Costs some tens of milliseconds.
    pub(super) fn reference(&self, region: RegionId) -> Result<Reference, CityError> {
        let made = self.first(region)?;
        let mut bytes = made.reference().map_err(|why| self.unsaved(region, why))?;
        bytes.extend(self.glances.figures().bytes());
        Ok(Reference { made, bytes })
    }

    fn unsaved(&self, region: RegionId, why: SaveError) -> CityError {
        CityError::Scene { region: self.region_label(region), why: Arc::new(why) }
    }

    /// The difference of a region from how it is made.
    pub(super) fn changes_of(&self, region: RegionId, environment: &Environment) -> Result<Changes, CityError> {
        self.reference(region)?.changes(environment).map_err(|why| self.unsaved(region, why))
    }

    /// The bytes that a region takes which somebody has changed and in which nobody is: those of its changes, a few kilobytes
    /// where somebody has opened a fridge. None while it is
    /// there, and if nothing differs in it from how it was made.
    ///
    /// ```
    /// use virtualcity::City;
    /// let city = City::make("building/7", 1)?;
    /// let regions = city.space().regions().map(|(region, _)| region);
    /// assert_eq!(regions.filter_map(|region| city.bytes_asleep(region)).sum::<usize>(), 0, "nobody has gone anywhere");
    /// # Ok::<(), virtualcity::CityError>(())
    /// ```
    pub fn bytes_asleep(&self, region: RegionId) -> Option<usize> {
        match self.asleep.get(&region)? {
            Dormant::Changes(changes) => Some(size_of::<Changes>() + changes.bytes.len()),
            Dormant::Whole(whole) => whole.save().ok().map(|bytes| bytes.len()),
        }
    }

    /// A region that goes to sleep.
    pub(super) fn asleep(&self, region: RegionId, environment: Environment) -> Dormant {
        let reference = self.reference(region).ok();
        match reference.map_or(Err(SaveError::NotSaved), |reference| reference.changes_at_rest(&environment)) {
            Ok(changes) => Dormant::Changes(changes.into()),
            Err(_) => Dormant::Whole(Box::new(environment)),
        }
    }

    /// A region that sleeps, as it fell asleep. The last that were woken are known.
    pub(super) fn as_it_fell_asleep(&self, region: RegionId, dormant: &Dormant) -> Result<Environment, CityError> {
        let changes = match dormant {
            Dormant::Whole(environment) => return Ok((**environment).clone()),
            Dormant::Changes(changes) => changes,
        };
        let mut woken = self.glances.woken();
        let known = woken.iter().position(|(own, _)| Arc::ptr_eq(own, changes));
        let known = known.map(|at| woken.remove(at).1);
        drop(woken);
        let restored = || self.reference(region)?.restored(&changes.bytes).map_err(|why| self.unsaved(region, why));
        let environment = known.map_or_else(restored, Ok)?;
        let mut woken = self.glances.woken();
        woken.insert(0, (changes.clone(), environment.clone()));
        woken.truncate(MADE);
        Ok(environment)
    }

    /// A region that sleeps, as it is now.
    pub(super) fn as_woken(&self, region: RegionId, dormant: &Dormant) -> Result<Environment, CityError> {
        let mut woken = self.as_it_fell_asleep(region, dormant)?;
        // Time has passed there as well; nobody could tell the difference.
        woken.step(Span(self.tick.0.saturating_sub(woken.tick().0)));
        Ok(woken)
    }
}
