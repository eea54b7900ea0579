//! Plans of the storeys of a building: its homes, and what they are entered from.

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{ObjectRole, Pose};

use super::canvas::{Anchor, Canvas, Colour, Ink, Point};
use super::{floor_plan, top};
use crate::apartment::Apartment;
use crate::area::{Area, Facing};
use crate::building::{Building, BuildingError, StoreyView};
use crate::item::Item;

/// The orientation of plans for each number of quarter turns: the bits of [`FloorPlan::turned`](crate::plan::FloorPlan::turned).
const WAYS: [usize; 4] = [0, 6, 3, 5];

impl Building {
    /// Draws a storey seen from above, in metres: both homes with their furniture, gallery, stairs, shaft and, on the
    /// ground, the lift and the yard. Makes the homes.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Building;
    /// let building = Building::from_seed(Seed(7))?;
    /// assert!(building.floor_plan(1)?.to_svg(1000).contains("Building 7, storey 1"));
    /// # Ok::<(), vc_procgen::BuildingError>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildingError::NoStorey`].
    pub fn floor_plan(&self, storey: usize) -> Result<Canvas, BuildingError> {
        let view = self.storey_view(storey)?;
        let title = format!("Building {}, storey {storey}", self.seed().0);
        Ok(draw(&view, &title))
    }
}

fn draw(view: &StoreyView, title: &str) -> Canvas {
    let around = view.ground.grown(floor_plan::MARGIN);
    let (low, high) = ([around.x0, around.y0 - floor_plan::STRIP], [around.x1, around.y1 + floor_plan::STRIP]);
    let mut canvas = Canvas::new(low, high);
    for (home, turn, origin) in &view.homes {
        let (home, corner) = turned(home, *turn);
        let mut drawn = Canvas::new(low, high);
        floor_plan::home(&mut drawn, &home);
        canvas.paste(&drawn, [origin.0 + corner[0], origin.1 + corner[1]]);
    }
    let is_wall = |item: &&Item| item.object.role == ObjectRole::Wall;
    let is_shown = |item: &&Item| !is_wall(item) && item.object.role != ObjectRole::Ceiling;
    top::paint(&mut canvas, view.items.iter().filter(is_shown));
    for wall in view.items.iter().filter(is_wall) {
        top::outlines(wall).iter().for_each(|Area { x0, y0, x1, y1 }| {
            canvas.rectangle([*x0, *y0], [*x1, *y1], Ink::filled(floor_plan::WALL));
        });
    }
    for (name, at) in &view.names {
        canvas.text(*at, 0.26, Anchor::Middle, Colour::BLACK, name);
    }
    floor_plan::heading(&mut canvas, low, high, title);
    floor_plan::scale(&mut canvas, [low[0] + floor_plan::MARGIN, low[1] + 0.4]);
    canvas
}

/// A home turned by quarters with its south-west corner at the origin, and where that corner was.
fn turned(home: &Apartment, turn: Facing) -> (Apartment, Point) {
    let plan = home.plan.turned(WAYS[usize::from(turn.0 % 4)]);
    let hull = Area::from_rect(&home.plan.hull()).turned(turn);
    let corner = [hull.x0, hull.y0];
    let rotation = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn.yaw());
    let way = Pose::from_parts(Vector3::new(-corner[0], -corner[1], 0.0).into(), rotation);
    let items = home.items.iter().map(|item| Item { pose: way * item.pose, ..item.clone() }).collect();
    (Apartment { plan, items, ..home.clone() }, corner)
}
