//! Places for flats in buildings: their outline, the places in their facades where windows may be, and where their door is.

use super::{Rect, cells};
use crate::error::SpecificationError;

/// A side of a site, as it lies on the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// Least X.
    West,
    /// Greatest X.
    East,
    /// Least Y: the main facade.
    South,
    /// Greatest Y: the corridor or landing.
    North,
}

/// A place in a facade where a window may be: the room behind it has it, or nobody.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowPlace {
    /// The facade; never the north, where the corridor is.
    pub side: Side,
    /// Where it begins along its facade, from the south-west corner, cells.
    pub from: i32,
    /// Where it ends, cells.
    pub to: i32,
    /// The height of its sill above the floor, metres.
    pub sill: f32,
    /// The height of its upper edge, metres.
    pub head: f32,
}

/// A place for a flat: a rectangle with its main facade in the south and the corridor in the north, in cells of five
/// centimetres from its south-west corner. Its borders are the centre lines of partitions as in every plan, and the outer walls
/// stand outside them.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::plan::{FloorPlan, OpeningKind, Side, Site, WindowPlace};
/// let window = |from| WindowPlace { side: Side::South, from, to: from + 26, sill: 0.9, head: 2.3 };
/// let windows = vec![window(17), window(73), window(129)];
/// let site = Site { width: 172, depth: 218, windows, door: (50, 130), ceiling: 2.7, shell: 4 };
/// let plan = FloorPlan::on(&site, Seed(5))?;
/// // Each window is one of the places, and no room reaches over the border.
/// let places: Vec<i32> = site.windows.iter().map(|place| place.from).collect();
/// let windows = plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window);
/// assert!(windows.clone().count() > 0 && windows.clone().all(|window| places.contains(&window.from)));
/// assert_eq!((plan.hull().x1, plan.hull().y1), (172, 218));
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Site {
    /// Its length along the main facade, cells.
    pub width: i32,
    /// Its depth from the main facade to the corridor, cells.
    pub depth: i32,
    /// The places where windows may be.
    pub windows: Vec<WindowPlace>,
    /// The stretch of the north side within which the front door has to be, cells.
    pub door: (i32, i32),
    /// The height of the ceiling, metres.
    pub ceiling: f32,
    /// The thickness of outer walls outside the border, cells.
    pub shell: i32,
}

/// The least and the greatest measures of a site, metres and square metres.
const WIDTH: (f32, f32) = (3.2, 40.0);
const DEPTH: (f32, f32) = (5.3, 12.3);
const AREA: (f32, f32) = (30.0, 400.0);
/// The height of rooms, metres, and the thickness of outer walls, cells.
const CEILING: (f32, f32) = (2.3, 6.0);
const SHELL: (i32, i32) = (2, 12);
/// The front door with its frame and room for its leaf, cells.
const DOOR: i32 = 26;

impl Site {
    /// Its rectangle.
    pub fn rect(&self) -> Rect {
        Rect::sized(0, 0, self.width, self.depth)
    }

    /// Whether a facade has places for windows.
    pub(super) fn is_open(&self, side: Side) -> bool {
        self.windows.iter().any(|place| place.side == side)
    }

    /// The same site seen in a mirror: west is east.
    pub(super) fn mirrored(&self) -> Self {
        let place = |place: &WindowPlace| {
            let (from, to) = (self.width - place.to, self.width - place.from);
            match place.side {
                Side::West => WindowPlace { side: Side::East, ..*place },
                Side::East => WindowPlace { side: Side::West, ..*place },
                Side::South | Side::North => WindowPlace { from, to, ..*place },
            }
        };
        let windows = self.windows.iter().map(place).collect();
        Self { windows, door: (self.width - self.door.1, self.width - self.door.0), ..self.clone() }
    }

    /// Checks that a flat can be on it.
    ///
    /// # Errors
    /// [`SpecificationError::OutOfRange`] names the number.
    pub fn check(&self) -> Result<(), SpecificationError> {
        let within = |what, value: f32, (low, high): (f32, f32)| match value >= low && value <= high {
            true => Ok(()),
            false => Err(SpecificationError::OutOfRange { what, value, low, high }),
        };
        let (width, depth) = (self.width as f32, self.depth as f32);
        within("width of the site in cells", width, (cells(WIDTH.0) as f32, cells(WIDTH.1) as f32))?;
        within("depth of the site in cells", depth, (cells(DEPTH.0) as f32, cells(DEPTH.1) as f32))?;
        within("area of the site in square metres", self.rect().area(), AREA)?;
        within("ceiling of the site", self.ceiling, CEILING)?;
        within("shell of the site in cells", self.shell as f32, (SHELL.0 as f32, SHELL.1 as f32))?;
        within("start of the door's stretch", self.door.0 as f32, (0.0, width))?;
        within("end of the door's stretch", self.door.1 as f32, ((self.door.0.saturating_add(DOOR)) as f32, width))?;
        for place in &self.windows {
            let length = if place.side == Side::South { width } else { depth };
            within("start of a window", place.from as f32, (0.0, length))?;
            within("end of a window", place.to as f32, ((place.from + 1) as f32, length))?;
            within("sill of a window", place.sill, (0.0, self.ceiling))?;
            within("head of a window", place.head, (place.sill, self.ceiling))?;
            within("side of a window (the north is the corridor's)", place.side as usize as f32, (0.0, 2.0))?;
        }
        let daylight = self.windows.iter().filter(|place| place.side == Side::South).count();
        within("number of windows in the main facade", daylight as f32, (1.0, 64.0))
    }
}
