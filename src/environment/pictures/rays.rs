//! Rays in an environment.

use std::sync::{MutexGuard, PoisonError};

use vc_graph::{Label, Pose};
use vc_render::{RayCaster, RenderError};

use super::Stage;
use crate::Environment;

/// By how much things are moved to count as moved, metres.
const STIR: f32 = 1e-3;

impl Environment {
    /// A caster of rays in the home as it is now, against what pictures show: for sensors of distance.
    ///
    /// The first takes about a microsecond for each triangle of the home; the others, also those of clones, a millisecond
    /// at most. The result depends on the present state alone, to the last bit.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::nalgebra::{Point3, Vector3};
    /// let home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let feet = home.world().pose(me).ok_or("no body")?.translation.vector;
    /// let rays = home.ray_caster()?;
    /// let down = rays.first(&Point3::new(feet.x, feet.y, 2.2), &-Vector3::z(), 5.0).ok_or("nothing is met")?;
    /// assert_eq!(down.node, me);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`snapshot`](Self::snapshot).
    pub fn ray_caster(&self) -> Result<RayCaster, RenderError<Label>> {
        let mut caster = self.threads.run(|| self.first_rays())?;
        caster.follow(&self.snapshot()?).map_err(|e| self.named(e))?;
        Ok(caster)
    }

    /// The caster in the home as it begins.
    fn first_rays(&self) -> Result<RayCaster, RenderError<Label>> {
        // The lock is not held meanwhile: a thread that waits for others may be given another sensor to read.
        if let Some(caster) = self.kept_rays().as_ref() {
            return Ok(caster.clone());
        }
        let caster = self.base()?.stage.rays().map_err(|e| self.named(e))?;
        *self.kept_rays() = Some(caster.clone());
        Ok(caster)
    }

    /// A thread that panicked left nothing half done there.
    fn kept_rays(&self) -> MutexGuard<'_, Option<RayCaster>> {
        self.picture_cache().rays.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Stage {
    /// A caster for which everything that may move has moved, so that it does not matter what moves when.
    fn rays(&self) -> Result<RayCaster, RenderError> {
        let mut caster = RayCaster::new(&self.snapshot);
        let mut stirred = self.snapshot.clone();
        for &id in &self.jointed {
            stirred.articulate(id, |joint| Some(joint.limits.0 + STIR))?;
        }
        for (id, pose) in self.poses.iter().filter(|(id, _)| self.loose.contains(id)) {
            stirred.place(*id, &(Pose::translation(0.0, 0.0, STIR) * pose))?;
        }
        self.covers.iter().try_for_each(|id| stirred.draw_cover(*id, true))?;
        caster.follow(&stirred)?;
        Ok(caster)
    }
}
