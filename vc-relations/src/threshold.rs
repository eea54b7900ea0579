//! Every threshold of the rules, with its unit and why it is what it is.

/// A thing rests on what is at most so far below its lowest face, metres. People and
/// programs set things down with gaps of millimetres (VirtualHome allows 10 mm, scenes
/// made by hand have up to 20); what is further down it has yet to fall on.
pub const SUPPORT_GAP: f32 = 0.02;

/// The same where of one of the two only a box is known, metres: VirtualHome's boxes stand up
/// to 7.5 cm above the floor.
pub const BOX_GAP: f32 = 0.08;

/// A thing may have sunk so far into what it rests on, metres: a cushion gives by
/// centimetres, a resting contact by at most 3 mm.
pub const SUPPORT_SINK: f32 = 0.04;

/// Of several supports those count whose distance is at most this much larger than
/// the least, metres: more than a solver's penetration and less than a thin board.
pub const SUPPORT_TIE: f32 = 0.003;

/// Least vertical part of a supporting contact's normal. Steeper contacts (60 degrees)
/// carry less than they push aside: a book leans on its neighbour and stands on the
/// board.
pub const SUPPORT_NORMAL: f32 = 0.5;

/// Least share of all upward impulse with which a contact counts as a support: a plank
/// on two tables has two supports, a cup touched by a spoon has one.
pub const IMPULSE_SHARE: f32 = 0.1;

/// A trace starts at least so far above a part's lowest face, metres, so that a sheet of
/// paper a few millimetres deep in the table still finds it below.
pub const TRACE_START: f32 = 0.01;

/// How much narrower than the part a trace is, on every side, metres: so that what
/// stands beside it, a few millimetres into it, is not met.
pub const TRACE_SHRINK: f32 = 0.006;

/// A part whose axis is at most so far from upright is traced by its middle plane:
/// cosine of 20 degrees.
pub const UPRIGHT: f32 = 0.939_7;

/// A ball rests on a small spot: the share of its radius that is traced.
pub const BALL_SPOT: f32 = 0.5;

/// Parts that are at most so far apart touch, metres: authored scenes leave gaps of 2 mm,
/// solvers keep a margin of about as much.
pub const TOUCH_GAP: f32 = 0.005;

/// What rests on nothing hangs on what is at most so far from it, metres: nails, hooks
/// and cords are not modelled and keep pictures that far off the wall.
pub const HANG_GAP: f32 = 0.02;

/// A thing hangs on a hook if the hook is at most so far from its box, metres.
pub const HOOK_REACH: f32 = 0.05;

/// A thing is under what is at most so far above it, metres: a storey; also how far the
/// thesis's vertical traces go here.
pub const UNDER_REACH: f32 = 3.0;

/// The middle share of a thing's footprint of which something must be above for the thing
/// to be under it: a chair pushed in by a tenth is not under the table, by half it is.
pub const UNDER_CORE: f32 = 0.5;

/// Two things are near each other at most so far apart, metres: an arm's length and some;
/// also the length of the thesis's sideways traces here.
pub const NEAR_REACH: f32 = 1.0;

/// Two things that are at most so far apart are at touching distance, metres: a hand that holds one
/// touches the other.
pub const TOUCHING_DISTANCE: f32 = 0.05;

/// Two things that are at most so far apart are within arm's reach of each other, metres: a grown person's arm.
pub const ARMS_REACH: f32 = 0.75;

/// How much farther pairs are looked for than they are measured, metres: more than the rounding
/// of any coordinate up to [`WORLD_REACH`], so that which pairs are measured never depends on
/// which of the two was asked first.
pub const REACH_SLACK: f32 = 0.01;

/// A thing whose box overlaps another's is beside it only if the centres are apart by at
/// least this share of the sum of the half sizes: a tucked chair has the table in front, a
/// rug has no side towards the table on it.
pub const SIDE_SHARE: f32 = 0.5;

/// Content may stand out of an open container: its centre may be so far above the rim,
/// metres (heaped apples), while its lower corners are below it.
pub const RIM_MARGIN: f32 = 0.05;

/// Corners of a content's box are taken at this share of its half size, so that what
/// touches a wall of the container is within it.
pub const CORNER_SHARE: f32 = 0.9;

/// The same for round things, whose box's corners are empty: 0.9 by the square root of a half.
pub const ROUND_CORNER_SHARE: f32 = 0.636;

/// How many of the eight corners must be within the container, beside the centre: half
/// of them, as content may stand out.
pub const CORNERS_WITHIN: u32 = 4;

/// The least depth of a hollow that is found from geometry, metres: a plate's is less (12 mm), that
/// of a tray whose rim is three centimetres high, and a bowl's, more.
pub const HOLLOW_DEPTH: f32 = 0.018;

/// A hollow that is open at two sides goes through so much of the asset at least: a bookcase's compartment
/// through all of it, the strip between two legs of a table through a tenth.
pub const THROUGH_SHARE: f32 = 0.6;

/// The least volume of a hollow that is found from geometry, cubic metres: a shot glass has
/// twice that; less is a joint between parts.
pub const HOLLOW_VOLUME: f32 = 2e-5;

/// Least height of a compartment that is stated by an asset, metres.
pub const HOLLOW_LEAST: f32 = 0.02;

/// A compartment has a roof if a part goes at least so far above it, metres: more than its own
/// walls stand out by rounding.
pub const ROOF_LEAST: f32 = 0.005;

/// Planes along an axis of the grid in which hollows are looked for, at most: shelves have
/// fewer faces, and the third power of it is how many cells there are.
pub const GRID_PLANES: usize = 28;

/// Cells along an axis of that grid at least, for what is not made of boxes: a bowl's wall is
/// about an eighth of its width.
pub const GRID_EVENLY: usize = 8;

/// Planes of that grid that are closer are one, metres: half the thinnest board.
pub const GRID_THINNEST: f32 = 0.002;

/// A part fills a cell of that grid if it reaches in by more than this share of the cell's
/// size: what only shares a face with it does not.
pub const GRID_FILL: f32 = 0.02;

/// Into how many discs and rings a turned shape, and into how many boxes an extruded outline,
/// is cut at most: a bowl's hollow keeps its depth to a sixth.
pub const SLICES: usize = 6;

/// Slices thinner than this share of the shape's height are not made: rounding of a profile.
pub const THIN_SLICE: f32 = 0.01;

/// How many boxes stand around a ring: they are within 8% of its radius.
pub const STAVES: usize = 8;

/// A ring whose hole is a smaller share of its radius is a disc: profiles start a little off
/// the axis.
pub const AXIS_HOLE: f32 = 0.02;

/// Columns along each side over a mesh: as many as cells of the grid.
pub const COLUMNS: usize = 8;

/// A mesh that fills a larger share of its box is that box.
pub const FULL_MESH: f32 = 0.9;

/// An agent whose box's own upward axis is more than 60 degrees from upright lies.
pub const LYING_TILT: f32 = 0.5;

/// Where a seat's top may be within the box of somebody who sits on it, as shares of the
/// box's height from its bottom: below the middle of the body, above the feet.
pub const SEAT_RANGE: (f32, f32) = (0.15, 0.65);

/// Half the angle within which something is faced: cosine of 75 degrees, VirtualHome's.
pub const FACING_COSINE: f32 = 0.258_8;

/// Farthest thing that is faced, metres; VirtualHome's.
pub const FACING_REACH: f32 = 5.0;

/// A thing in a doorway or wall is in the nearest room at most so far away, metres: the
/// thickness of an outer wall.
pub const ROOM_MARGIN: f32 = 0.4;

/// How high above its floor a room goes if its box does not say, metres: a storey.
pub const STOREY: f32 = 3.0;

/// How far beside a door's leaf the rooms on both its sides are looked for, metres: out of the
/// wall it is in, and not past a corridor.
pub const BESIDE_DOOR: f32 = 0.2;

/// A door's box that is thicker than this share of its width is that of a leaf which stands
/// open; a frame with its leaf shut has less than half.
pub const DOOR_SQUARE: f32 = 0.7;

/// VirtualHome: centre to box at most so far is CLOSE, metres.
pub const VH_CLOSE: f32 = 1.5;

/// VirtualHome: pairs with centres farther apart are not looked at, metres.
pub const VH_FAR: f32 = 5.0;

/// VirtualHome: heights that differ by less are equal, metres: its floors are 9 µm thick, and
/// what stands on them has its bottom at their centre.
pub const VH_ROUNDING: f32 = 1e-7;

/// VirtualHome: how far its box cast goes up and down, metres.
pub const VH_CAST: f32 = 0.05;

/// VirtualHome: least share of the footprint that is over the support.
pub const VH_FOOTPRINT: f32 = 0.5;

/// Farther out and larger than this single precision does not resolve a millimetre, metres.
pub const WORLD_REACH: f32 = 10_000.0;

/// How much the length of a rotation's quaternion may be off one: what files round to
/// three digits passes, what is no rotation does not.
pub const ROTATION_SLACK: f32 = 0.01;
