//! Ways that stay open when a thing is put down.

use nalgebra::Point2;
use vc_geometry::grid::{BitGrid, Raster};
use vc_graph::{NodeId, Pose};

use super::{Floor, SNAP, cover};
use crate::PhysicsError;
use crate::world::PhysicsWorld;

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
        world: &PhysicsWorld,
        id: NodeId,
        pose: &Pose,
        from: &[Point2<f32>],
    ) -> Result<bool, PhysicsError> {
        let outlines = cover::outlines_at(world, world.thing(id)?, pose, &self.options);
        let Some(before) = &self.raster else { return Ok(true) };
        let mut after = before.clone();
        outlines.iter().for_each(|o| after.paint(o, self.options.radius, false));
        if after.cells().count() == before.cells().count() {
            return Ok(true);
        }
        let most = NOOK / (before.cell() * before.cell());
        let is_open = |point: &Point2<f32>| {
            let (was, is) = (reached(before, point), reached(&after, point));
            after.cells().and(&was).and(&is.inverted()).count() as f32 <= most
        };
        Ok(from.iter().all(is_open))
    }
}

/// The cells to which there is a way from a point.
fn reached(raster: &Raster, from: &Point2<f32>) -> BitGrid {
    let start = raster.nearest(from, SNAP).and_then(|start| raster.cell_of(&start));
    start.map_or_else(|| raster.cells().empty(), |(column, row)| raster.cells().flood(column, row))
}
