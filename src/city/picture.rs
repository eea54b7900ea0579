//! Pictures in a city: what is seen from a region, through open and glazed portals.

use std::sync::{Arc, MutexGuard, PoisonError};

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::space::RegionId;
use vc_render::{Daylight, Frame, Modalities};

use super::sight::InSight;
use super::{City, CityError};
use crate::environment::{Beside, Extent, JoinedHomes};
use crate::{Environment, PictureOptions, Viewpoint};

/// The groups of regions that are kept ready to be drawn.
const KEPT: usize = 4;

/// A viewpoint in a city: in the region of its agent or room, or in one that is named.
///
/// ```
/// use virtualcity::render::Modality;
/// use virtualcity::{City, Viewpoint};
/// let city = City::make("building/7", 1)?;
/// let me = city.agents().next().ok_or("nobody")?;
/// let home = city.region_of(me).ok_or("nowhere")?;
/// let own = city.render(Viewpoint::Agent(me), Modality::Instance, 64, 48)?;
/// let said = city.render((home, Viewpoint::Agent(me)), Modality::Instance, 64, 48)?;
/// assert_eq!(own.instance, said.instance);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CityView {
    /// The region in whose frame the camera is; that of the viewpoint's agent or room if it is not said.
    pub region: Option<RegionId>,
    /// Where it is in this region.
    pub view: Viewpoint,
}

impl From<Viewpoint> for CityView {
    fn from(view: Viewpoint) -> Self {
        Self { region: None, view }
    }
}

impl From<(RegionId, Viewpoint)> for CityView {
    fn from((region, view): (RegionId, Viewpoint)) -> Self {
        Self { region: Some(region), view }
    }
}

impl City {
    /// A picture of the city as it is: of the region of a viewpoint, and of the regions that are seen from there, through
    /// at most three open doors or windows, none farther than 60 m away. Made as the region's
    /// [`pictures`](Environment::pictures) say; changes nothing.
    ///
    /// | | |
    /// |---|---|
    /// | frame | all regions are placed in that of the viewpoint's region, from the `f64` origins of both; depth, normals and flow are as in [`Environment::render`] |
    /// | ids | node numbers, which no two regions share: [`region_of`](Self::region_of) says the region of one, [`peek`](Self::peek) has its node, wherever it is |
    /// | regions where nobody is | are made from their seed and what has changed there, for the picture only |
    /// | shut doors | the region behind is drawn from outside: its walls, floors, doors, windows, curtains and blinds, without what is within. Behind the shut door of the region itself so are all that are seen from there: they shade its windows |
    /// | light | goes through open portals as through the doors of a home, both ways, and shadows fall from region to region; beyond the regions that are drawn there is the sky |
    /// | the sun | stands in the world, wherever a region is turned |
    /// | from above | a region alone, as [`Environment::render`] has it |
    ///
    /// A region from which nothing else is seen is drawn as [`Environment::render`] draws it. With others, light is made for
    /// all of them, which takes a second for each home; it is kept for the last four groups of regions, as is that of an
    /// environment.
    ///
    /// ```
    /// use virtualcity::procgen::Building;
    /// use virtualcity::render::Modality;
    /// use virtualcity::{City, Viewpoint};
    /// let building = Building::from_seed(virtualcity::graph::Seed(7))?;
    /// let gallery = building.storeys()[0].gallery;
    /// let mut city = City::of(building).make()?;
    /// let me = city.agents().next().ok_or("nobody")?;
    /// city.go(me, gallery)?;
    /// let frame = city.render(Viewpoint::Agent(me), Modality::Instance, 160, 120)?;
    /// assert!(frame.instance.iter().any(|id| city.region_of(*id) == Some(gallery)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoRegion`] for a viewpoint without agent or room if no region is said, [`CityError::Picture`],
    /// [`CityError::NoScene`] and other reasons for which a region cannot be made.
    pub fn render(
        &self,
        view: impl Into<CityView>,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, CityError> {
        self.picture(None, view.into(), wanted.into(), (width, height))
    }

    /// As [`render`](Self::render), with the optical flow from this moment to a later one of the same city. The same regions
    /// are drawn in both.
    ///
    /// # Errors
    /// As [`render`](Self::render); [`RenderError::OtherScene`](vc_render::RenderError::OtherScene) if somebody has come into
    /// one of them or gone in between.
    pub fn render_until(
        &self,
        later: &Self,
        view: impl Into<CityView>,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, CityError> {
        self.picture(Some(later), view.into(), wanted.into(), (width, height))
    }

    /// The city as it is seen in this tick: [`Environment::moment`] of all regions that are there. Pictures of it show people
    /// on their way, hands at what they take and doors as they swing.
    #[must_use]
    pub fn moment(&self) -> Self {
        let active = self.active.iter().map(|(region, environment)| (*region, environment.moment()));
        Self { active: active.collect(), ..self.clone() }
    }

    fn picture(
        &self,
        later: Option<&Self>,
        CityView { region, view }: CityView,
        wanted: Modalities,
        (width, height): (u32, u32),
    ) -> Result<Frame, CityError> {
        let region = region.or_else(|| self.region_of_view(view)).ok_or(CityError::NoRegion)?;
        let fault =
            |why: crate::PictureError| CityError::Picture { region: self.region_label(region), why: why.into() };
        let here = self.seen(region)?;
        let how = self.outside(region, here.pictures());
        let camera = here.camera(view, width, height).map_err(fault)?;
        let in_sight = match here.is_plan(view) {
            true => Vec::new(),
            false => self.in_sight(region, &camera.eye()),
        };
        if in_sight.len() < 2 {
            let later = later.map(|later| later.seen(region)).transpose()?;
            return here.picture(&how, later.as_deref(), (view, wanted), (width, height)).map_err(fault);
        }
        let now = self.all_seen(&in_sight)?;
        let then = later.map(|later| later.all_seen(&in_sight)).transpose()?;
        let homes = beside(&in_sight, &now);
        let joined = self.joined(&homes).map_err(|why| fault(why.into()))?;
        let after = match then.as_ref().and_then(|then| then.first()) {
            Some(there) => Some(there.camera(view, width, height).map_err(fault)?),
            None => None,
        };
        let then = then.as_ref().map(|then| beside(&in_sight, then));
        let later = then.as_deref().zip(after.as_ref());
        here.threads.run(|| joined.picture(&how, (&homes, &camera), later, wanted)).map_err(fault)
    }

    fn region_of_view(&self, view: Viewpoint) -> Option<RegionId> {
        match view {
            Viewpoint::Agent(node) | Viewpoint::Room(node) | Viewpoint::Above(node) => self.region_of(node),
            _ => None,
        }
    }

    /// The options of pictures in a region, with the sun where it stands in the world.
    fn outside(&self, region: RegionId, how: &PictureOptions) -> PictureOptions {
        let heading = self.frame(region).map_or(0.0, |frame| frame.heading);
        if heading == 0.0 {
            return *how;
        }
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -heading as f32);
        let daylight = Daylight { towards_sun: turn * how.daylight.towards_sun, ..how.daylight };
        PictureOptions { daylight, ..*how }
    }

    fn all_seen(&self, in_sight: &[InSight]) -> Result<Vec<std::borrow::Cow<'_, Environment>>, CityError> {
        in_sight.iter().map(|seen| self.seen(seen.region)).collect()
    }

    /// A group of regions, ready to be drawn.
    fn joined(&self, homes: &[Beside<'_>]) -> Result<Arc<JoinedHomes>, vc_render::RenderError<vc_graph::Label>> {
        // The lock is not held meanwhile: a thread that waits for others may be given a picture to make.
        let known = || self.groups().iter().find(|known| known.is_of(homes)).cloned();
        let group = known().map_or_else(|| JoinedHomes::new(homes).map(Arc::new), Ok)?;
        let mut kept = self.groups();
        kept.retain(|known| !known.is_of(homes));
        kept.insert(0, group.clone());
        kept.truncate(KEPT);
        Ok(group)
    }

    /// A thread that panicked left nothing half done there.
    fn groups(&self) -> MutexGuard<'_, Vec<Arc<JoinedHomes>>> {
        self.glances.joined.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Environments of regions where they are seen.
fn beside<'a>(in_sight: &[InSight], environments: &'a [std::borrow::Cow<'_, Environment>]) -> Vec<Beside<'a>> {
    let beside = |(seen, environment): (&InSight, &'a std::borrow::Cow<'_, Environment>)| Beside {
        environment,
        pose: seen.pose,
        extent: if seen.is_open { Extent::Whole } else { Extent::Shell },
    };
    in_sight.iter().zip(environments).map(beside).collect()
}
