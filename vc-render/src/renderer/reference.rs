//! Reference pictures, as a renderer makes them.

use super::Renderer;
use crate::RenderError;
use crate::camera::Camera;
use crate::light::Lighting;
use crate::path_tracing::{self, PathTracing, ReferencePicture, RenderProgress};

impl Renderer {
    /// Renders the reference picture of a lighting's scene by path tracing.
    ///
    /// `progress` is called after each round of one path for every pixel, with the number of rounds so far; it
    /// may look at the picture so far, and stops rendering by returning false. The picture is the same for any
    /// number of threads. Costs a microsecond or two for each path and surface hit, and 132 bytes for each
    /// pixel while paths are traced, more at edges. [`PathTracing`], [`ReferencePicture`] and [`RenderProgress`] have
    /// examples.
    ///
    /// Direct sampling of light sources and chance hits are combined by multiple importance sampling (Veach
    /// 1997), with Sobol points scrambled for each pixel (Burley 2020). Surfaces have a matt base under
    /// microfacets (Trowbridge and Reitz; sampled by Heitz 2018; base and gloss share the light as in Ashikhmin
    /// and Shirley 2000, and the light lost between facets is compensated by Turquin 2019). Noise is smoothed
    /// by an edge-avoiding wavelet filter (Dammertz and others 2010), guided by the noise of each pixel (Schied
    /// and others 2017).
    ///
    /// # Errors
    /// [`RenderError::BadSize`], [`RenderError::BadCamera`], [`RenderError::OtherRenderer`],
    /// [`RenderError::BadDaylight`].
    pub fn reference_picture(
        &self,
        lighting: &Lighting,
        camera: &Camera,
        how: &PathTracing,
        progress: impl FnMut(&RenderProgress<'_>) -> bool,
    ) -> Result<ReferencePicture, RenderError> {
        camera.check()?;
        lighting.check(&self.store)?;
        Ok(path_tracing::traced(&self.store, lighting, camera, how, progress))
    }
}
