//! Regions as they are now for whoever looks, whether or not anybody is there: from a cache that nothing else reads.

use std::borrow::Cow;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use vc_graph::AssetLibrary;
use vc_graph::clock::Span;
use vc_graph::space::RegionId;

use super::dormant::Changes;
use super::measures::{FIGURES, MADE};
use super::{City, CityError, time};
use crate::Environment;
#[cfg(feature = "render")]
use crate::environment::JoinedHomes;
use crate::environment::shapes_as_text;

/// Whatever it costs to look at regions where nobody is; clones of a city share it.
#[derive(Default)]
pub(super) struct Glances {
    /// Regions as they were made, the last one first.
    made: Mutex<Vec<(RegionId, Environment)>>,
    /// The regions that were woken last, by what differs in them.
    woken: Mutex<Vec<(Arc<Changes>, Environment)>>,
    figures: OnceLock<String>,
    #[cfg(feature = "render")]
    pub(super) joined: Mutex<Vec<Arc<JoinedHomes>>>,
}

impl Glances {
    /// A thread that panicked left nothing half done there.
    pub(super) fn woken(&self) -> MutexGuard<'_, Vec<(Arc<Changes>, Environment)>> {
        self.woken.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The shapes of the first agents as text.
    pub(super) fn figures(&self) -> &str {
        self.figures.get_or_init(|| {
            let mut library = AssetLibrary::default();
            // Whoever cannot be added is written with a region instead.
            (0..FIGURES).for_each(|looks| drop(vc_people::add_to(&mut library, looks)));
            shapes_as_text(&Arc::new(library))
        })
    }
}

impl City {
    /// The environment of any region as it is now: a copy, made from the region's seed and what has changed there if nobody
    /// is in it. Looking changes nothing: no region is there afterwards that was not before, and no digest differs.
    ///
    /// ```
    /// use virtualcity::City;
    /// let city = City::make("building/7", 1)?;
    /// let digest = city.digest();
    /// let (region, _) = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?;
    /// assert!(city.environment(region).is_none(), "nobody is there");
    /// assert!(!city.peek(region)?.graph().is_empty());
    /// assert_eq!(city.digest(), digest);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoScene`], [`CityError::Scene`], [`CityError::Make`].
    pub fn peek(&self, region: RegionId) -> Result<Environment, CityError> {
        Ok(self.seen(region)?.into_owned())
    }

    /// The environment of a region as it is now.
    pub(super) fn seen(&self, region: RegionId) -> Result<Cow<'_, Environment>, CityError> {
        if let Some(environment) = self.active.get(&region) {
            return Ok(Cow::Borrowed(environment));
        }
        let mut environment = match self.asleep.get(&region) {
            Some(dormant) => self.as_it_fell_asleep(region, dormant)?,
            None => self.first(region)?,
        };
        environment.step(Span(self.tick.0.saturating_sub(environment.tick().0)));
        let doors = self.lift_doors(region, environment.graph());
        time::set_lift_doors(&mut environment, &doors);
        Ok(Cow::Owned(environment))
    }

    /// The environment of a region as it is before anybody has been there: a copy of one that is kept.
    pub(super) fn first(&self, region: RegionId) -> Result<Environment, CityError> {
        let known = || self.kept().iter().find(|(known, _)| *known == region).map(|(_, kept)| kept.clone());
        let environment = known().map_or_else(|| self.made(region), Ok)?;
        let mut kept = self.kept();
        kept.retain(|(known, _)| *known != region);
        kept.insert(0, (region, environment.clone()));
        kept.truncate(MADE);
        Ok(environment)
    }

    /// A thread that panicked left nothing half done there.
    fn kept(&self) -> MutexGuard<'_, Vec<(RegionId, Environment)>> {
        self.glances.made.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
