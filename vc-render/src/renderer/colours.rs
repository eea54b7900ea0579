//! Colours: exposure and shading of the visible surfaces.

use super::Renderer;
use super::scratch::{Band, Scratch, halves};
use crate::frame::{Frame, Strip};
use crate::light::{Lighting, Patch, Spot};
use crate::math::{self, dot, three, unit};
use crate::rasterization::Visible;
use crate::scene::Snapshot;
use crate::shading::{self, Shading};
use crate::shot::{Shot, View};

impl Renderer {
    /// Shades the visible surfaces of all bands.
    pub(super) fn colours(&self, lighting: &Lighting, shot: &Shot<'_>, frame: &mut Frame, scratch: &mut Scratch) {
        let view = shot.view;
        let Scratch { bands, openness, smoother, .. } = scratch;
        let drawn = bands.in_use().iter().map(|band| (&band.layers, band.rows.clone()));
        let open = (!shot.unshadowed).then(|| shading::occlusion(view.camera, drawn, openness));
        let exposure = lighting.exposure(view.camera.eye().into(), self.spots(lighting, view, bands.in_use()));
        let exposure = shot.adaptation.map_or(exposure, |adaptation| adaptation.towards(exposure));
        let shading = Shading { store: &self.store, lighting, view, open, exposure };
        shade_bands(&shading, Strip::whole(frame), bands.in_use_mut());
        frame.exposure = exposure;
        smoother.smooth(bands.in_use().iter().map(|band| band.shading.edges()), frame.width, &mut frame.rgb);
    }

    /// Meters the light at pixels scattered over a picture, of opaque surfaces, including those seen through glass.
    fn spots<'a>(
        &'a self,
        lighting: &'a Lighting,
        View { snapshot, camera }: View<'a>,
        bands: &'a [Band],
    ) -> impl Iterator<Item = Spot> + 'a {
        camera.scattered_pixels().filter_map(move |[x, y]| {
            let band = bands.iter().find(|band| band.rows.contains(&(y as i32)))?;
            let solid = band.layers.solid();
            let triangle = *solid.triangle_row(y as i32).get(x as usize)?;
            let seen = band.layers.visible.get(triangle as usize)?;
            let depth = 1.0 / *solid.inverse_row(y as i32).get(x as usize)?;
            Some(self.metered(lighting, snapshot, (seen, camera.unproject(x, y, depth).into()), camera.eye().into()))
        })
    }

    /// Meters the light at a point of a visible triangle.
    fn metered(
        &self,
        lighting: &Lighting,
        snapshot: &Snapshot,
        (seen, at): (&Visible, [f32; 3]),
        eye: [f32; 3],
    ) -> Spot {
        let instance = &snapshot.instances[seen.instance as usize];
        let (mesh, index) = (seen.mesh(&snapshot.instances), seen.index());
        let normal = unit(math::normal(&instance.inverse, mesh.normals[index][0]));
        let faces = dot(normal, three(|i| eye[i] - at[i])) >= 0.0;
        lighting.metered(&Patch {
            surface: &self.store.surfaces[usize::from(mesh.faces[index].surface)],
            coat: &instance.coat,
            body: instance.body,
            at,
            normal: if faces { normal } else { normal.map(|v| -v) },
            room: lighting.room_seen(snapshot, seen, eye),
        })
    }
}

fn shade_bands(shading: &Shading<'_>, mut strip: Strip<'_>, bands: &mut [Band]) {
    if let [band] = bands {
        return shading.band(&band.layers, &mut band.shading, &mut strip);
    }
    let [(upper, first), (lower, last)] = halves(strip, bands);
    rayon::join(|| shade_bands(shading, upper, first), || shade_bands(shading, lower, last));
}
