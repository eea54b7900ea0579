//! Homes side by side, drawn as one scene: what is seen through their open doors, and the light that falls through them.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use vc_graph::{Label, Pose};
use vc_render::{Camera, Daylight, Frame, Lighting, Modalities, Modality, RenderError, Renderer, Shot, Snapshot};

use super::light::{LIGHTS, Lit};
use super::stage::{Extent, Stage};
use super::{PictureCache, PictureError, PictureOptions};
use crate::Environment;

/// An environment beside others.
pub(crate) struct Beside<'a> {
    pub(crate) environment: &'a Environment,
    /// The pose of its frame in that of the first.
    pub(crate) pose: Pose,
    pub(crate) extent: Extent,
}

/// The scene that is drawn, and the camera.
pub(crate) type JoinedView<'a> = (&'a [Beside<'a>], &'a Camera);

/// Environments as pictures of all of them begin, and the light in them.
#[derive(Debug)]
pub(crate) struct JoinedHomes {
    renderer: Renderer,
    homes: Vec<Joined>,
    /// Light that was made, the last one first.
    light: Mutex<Vec<(Vec<Standing>, Lighting)>>,
}

#[derive(Debug)]
struct Joined {
    /// The cache of its environment, which is another one when things have come or gone.
    of: Arc<PictureCache>,
    extent: Extent,
    stage: Stage,
}

/// On what the light of an environment depends, and where it is.
type Standing = (Lit, Pose);

impl JoinedHomes {
    /// Uploads what these environments have.
    pub(crate) fn new(homes: &[Beside<'_>]) -> Result<Self, RenderError<Label>> {
        let mut renderer = Renderer::new();
        let joined = |home: &Beside<'_>| {
            let stage = Stage::new(home.environment, &mut renderer, home.extent);
            let stage = stage.and_then(|stage| stage.begun(home.environment));
            let stage = stage.map_err(|why| home.environment.named(why))?;
            Ok::<_, RenderError<Label>>(Joined {
                of: home.environment.picture_cache.clone(),
                extent: home.extent,
                stage,
            })
        };
        let homes = homes.iter().map(joined).collect::<Result<Vec<Joined>, _>>()?;
        Ok(Self { renderer, homes, light: Mutex::default() })
    }

    /// Whether it is of these environments, with the things that they have now.
    pub(crate) fn is_of(&self, homes: &[Beside<'_>]) -> bool {
        let is_of = |(known, home): (&Joined, &Beside<'_>)| {
            Arc::ptr_eq(&known.of, &home.environment.picture_cache) && known.extent == home.extent
        };
        self.homes.len() == homes.len() && self.homes.iter().zip(homes).all(is_of)
    }

    /// A picture of environments as they are, with the optical flow to a later moment if there is one.
    pub(crate) fn picture(
        &self,
        how: &PictureOptions,
        now: JoinedView<'_>,
        later: Option<JoinedView<'_>>,
        wanted: Modalities,
    ) -> Result<Frame, PictureError> {
        let snapshot = self.as_now(now.0)?;
        let then = later.map(|(homes, camera)| Ok::<_, PictureError>((self.as_now(homes)?, camera))).transpose()?;
        let light = wanted.has(Modality::Rgb).then(|| self.lighting(now.0, &how.daylight, &snapshot)).transpose()?;
        let mut shot = Shot::new(&snapshot, now.1, wanted).supersampled(how.finer);
        (shot.lighting, shot.adaptation) = (light.as_ref(), how.adapts);
        if let Some((snapshot, camera)) = &then {
            shot = shot.after(snapshot, camera);
        }
        let mut frame = Frame::new();
        self.renderer.render(&shot, &mut frame)?;
        Ok(frame)
    }

    fn as_now(&self, homes: &[Beside<'_>]) -> Result<Snapshot, RenderError<Label>> {
        self.whole(homes, self.homes.iter().zip(homes).map(|(joined, home)| joined.stage.now(home.environment)))
    }

    /// Snapshots of all of them as one.
    fn whole(
        &self,
        homes: &[Beside<'_>],
        parts: impl Iterator<Item = Result<Snapshot, RenderError>>,
    ) -> Result<Snapshot, RenderError<Label>> {
        let mut parts = parts.zip(homes).map(|(part, home)| match part {
            Ok(part) => Ok((part, home.pose)),
            Err(why) => Err(home.environment.named(why)),
        });
        let (first, _) = parts.next().ok_or(RenderError::<Label>::OtherRenderer("snapshot"))??;
        let others = parts.collect::<Result<Vec<_>, _>>()?;
        Ok(first.joined(&others)?)
    }

    /// The light as it is: that of the environments as they begin, from scene to scene, and shadows as they are now.
    fn lighting(
        &self,
        homes: &[Beside<'_>],
        daylight: &Daylight,
        now: &Snapshot,
    ) -> Result<Lighting, RenderError<Label>> {
        let standing =
            |(joined, home): (&Joined, &Beside<'_>)| (home.environment.lit(&joined.stage, daylight), home.pose);
        let standing: Vec<Standing> = self.homes.iter().zip(homes).map(standing).collect();
        let known = self.lights().iter().find(|(known, _)| *known == standing).map(|(_, light)| light.clone());
        let mut light = known.map_or_else(|| self.made(homes, &standing, daylight), Ok)?;
        self.renderer.follow(&mut light, now)?;
        // The lock is not held meanwhile: a thread that waits for others may be given a picture to make.
        let mut made = self.lights();
        made.retain(|(known, _)| *known != standing);
        made.insert(0, (standing, light.clone()));
        made.truncate(LIGHTS);
        Ok(light)
    }

    fn made(
        &self,
        homes: &[Beside<'_>],
        standing: &[Standing],
        daylight: &Daylight,
    ) -> Result<Lighting, RenderError<Label>> {
        let lit = || self.homes.iter().zip(standing.iter().map(|(lit, _)| lit));
        let begins = self.whole(homes, lit().map(|(joined, lit)| joined.stage.as_lit(lit)))?;
        let mut light = self.renderer.light(&begins, daylight);
        // As for one home: it does not matter what moved when.
        light.follow(&self.whole(homes, lit().map(|(joined, lit)| joined.stage.stirred(lit)))?)?;
        Ok(light)
    }

    /// Light that was made. A thread that panicked left nothing half done there.
    fn lights(&self) -> MutexGuard<'_, Vec<(Vec<Standing>, Lighting)>> {
        self.light.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
