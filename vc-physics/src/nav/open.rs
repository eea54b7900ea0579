//! Ways that stay open when a thing is put down.

use nalgebra::Point2;
use vc_graph::{NodeId, Pose};

use super::bands::Bands;
use super::raster::Raster;
use super::{Floor, SNAP, cover};
use crate::PhysicsError;
use crate::world::World;

/// The largest area that may be cut off, square metres: a nook in which nobody stands.
const NOOK: f32 = 0.1;

impl Floor {
    /// Whether a thing at a pose would leave all ways from some points open: from each one reaches what one reached
    /// before of the floor that the thing leaves free, except for nooks.
    ///
    /// The floor has to be [up to date](Self::update), and the thing is not on it yet: it is in a hand. Costs some ten
    /// microseconds for each point.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn stays_open(
        &self,
        world: &World,
        id: NodeId,
        pose: &Pose,
        from: &[Point2<f32>],
    ) -> Result<bool, PhysicsError> {
        let outlines = cover::outlines_at(world, world.thing(id)?, pose, &self.plan);
        let Some(before) = &self.raster else { return Ok(true) };
        let mut after = before.clone();
        outlines.iter().for_each(|o| after.paint(o, self.plan.radius, false));
        if after.count() == before.count() {
            return Ok(true);
        }
        let bands = Bands::of(&after);
        let most = NOOK / (before.cell * before.cell);
        let is_open = |point: &Point2<f32>| {
            let (was, is) = (reached(before, &self.bands, point), reached(&after, &bands, point));
            after.count_of(|word, i| word & was.word(i) & !is.word(i)) as f32 <= most
        };
        Ok(from.iter().all(is_open))
    }
}

/// The cells to which there is a way from a point.
fn reached(raster: &Raster, bands: &Bands, from: &Point2<f32>) -> Raster {
    let mut reached = raster.clone();
    reached.clear();
    let start = raster.nearest(from, SNAP).and_then(|start| raster.cell_of(&start));
    let first = start.and_then(|(column, row)| bands.at(column, row));
    for band in first.map(|first| bands.joined(first)).unwrap_or_default() {
        reached.fill(band.x0 as usize..band.x1 as usize, band.y0 as usize..band.y1 as usize);
    }
    reached
}
