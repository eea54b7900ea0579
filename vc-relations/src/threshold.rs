//! All thresholds of the rules, with units and reasons.

/// Greatest distance from a thing's lowest face down to its support, metres. People and programs set things
/// down with gaps of millimetres (VirtualHome allows 10 mm, handmade scenes have up to 20); a thing with a
/// larger gap has yet to fall.
pub const SUPPORT_GAP: f32 = 0.02;

/// The same distance if only a box is known for one of the two, metres: VirtualHome's boxes stand up to 7.5 cm
/// above the floor.
pub const BOX_GAP: f32 = 0.08;

/// Greatest depth to which a thing may have sunk into its support, metres: a cushion gives way by centimetres,
/// a resting contact by at most 3 mm.
pub(crate) const SUPPORT_SINK: f32 = 0.04;

/// Greatest difference from the least distance at which several supports count, metres: more than a solver's
/// penetration and less than a thin board.
pub const SUPPORT_TIE: f32 = 0.003;

/// Least vertical component of a supporting contact's normal. Steeper contacts (beyond 60 degrees) push aside
/// more than they carry: a book leans on its neighbour and stands on the board.
pub(crate) const SUPPORT_NORMAL: f32 = 0.5;

/// Least share of the total upward impulse with which a contact counts as a support: a plank on two tables has
/// two supports, a cup touched by a spoon has one.
pub(crate) const IMPULSE_SHARE: f32 = 0.1;

/// Least height above a part's lowest face at which a trace starts, metres, so that a sheet of paper that has
/// sunk a few millimetres into the table still finds it below.
pub(crate) const TRACE_START: f32 = 0.01;

/// Margin by which a trace is narrower than the part, on every side, metres: it does not hit things that stand
/// beside the part and overlap it by a few millimetres.
pub(crate) const TRACE_SHRINK: f32 = 0.006;

/// A part whose axis is at most 20 degrees from upright is traced by its middle plane: the cosine of that
/// angle.
pub(crate) const UPRIGHT: f32 = 0.939_7;

/// A ball rests on a small spot: the share of its radius that is traced.
pub(crate) const BALL_SPOT: f32 = 0.5;

/// Greatest gap between touching parts, metres: authored scenes leave gaps of 2 mm, and solvers keep a margin
/// of about the same size.
pub const TOUCH_GAP: f32 = 0.005;

/// Greatest gap between a hanging thing and the thing it hangs on, metres: nails, hooks and cords, which are
/// not modelled, keep pictures this far off the wall.
pub(crate) const HANG_GAP: f32 = 0.02;

pub(crate) use vc_graph::asset::HOOK_REACH;

/// Greatest height of a thing above another that is under it, metres: a storey; also the length of the thesis's
/// vertical traces here.
pub(crate) const UNDER_REACH: f32 = 3.0;

/// The central share of a thing's footprint that must have something above for the thing to be under it: a
/// chair pushed in by a tenth is not under the table, but one pushed in by half is.
pub(crate) const UNDER_CORE: f32 = 0.5;

/// Greatest distance between things that are near each other, metres: an arm's length and a little more; also
/// the length of the thesis's sideways traces here.
pub const NEAR_REACH: f32 = 1.0;

/// Greatest distance between two things at touching distance, metres: a hand that holds one touches the other.
pub const TOUCHING_DISTANCE: f32 = 0.05;

/// Greatest distance between two things within arm's reach of each other, metres: an adult's arm.
pub const ARMS_REACH: f32 = vc_graph::Anthropometry::ADULT.arm;

/// Margin by which the search for pairs reaches farther than their measurement, metres: more than the rounding
/// of any coordinate up to [`WORLD_REACH`], so that the set of measured pairs never depends on which of the two
/// came first.
pub(crate) const REACH_SLACK: f32 = 0.01;

/// If two boxes overlap, one is beside the other only if the centres are apart by at least this share of the
/// sum of the half sizes: a tucked chair has the table in front, a rug has no side towards the table on it.
pub(crate) const SIDE_SHARE: f32 = 0.5;

/// Greatest height of a content's centre above the rim of an open container, metres: content may stand out
/// (heaped apples), while its lower corners are below the rim.
pub(crate) const RIM_MARGIN: f32 = 0.05;

/// Share of the half size at which the corners of a content's box are taken, so that things that touch a wall
/// of the container are within it.
pub(crate) const CORNER_SHARE: f32 = 0.9;

/// The same share for round things, whose box's corners are empty: 0.9 times the square root of a half.
pub(crate) const ROUND_CORNER_SHARE: f32 = 0.636;

/// Number of the eight corners that must be within the container, in addition to the centre: half of them, as
/// content may stand out.
pub(crate) const CORNERS_WITHIN: u32 = 4;

/// Least depth of a hollow found from geometry, metres: more than a plate's (12 mm), less than that of a bowl
/// or of a tray with a rim three centimetres high.
pub(crate) const HOLLOW_DEPTH: f32 = 0.018;

/// Least share of the asset that a hollow open at two sides must span: a bookcase's compartment spans all of
/// it, the strip between two legs of a table a tenth.
pub(crate) const THROUGH_SHARE: f32 = 0.6;

/// Least volume of a hollow found from geometry, cubic metres: a shot glass has twice that; anything smaller is
/// a joint between parts.
pub(crate) const HOLLOW_VOLUME: f32 = 2e-5;

/// Least height of a compartment declared by an asset, metres.
pub(crate) const HOLLOW_LEAST: f32 = 0.02;

/// How far from a container's box the middle of a thing is that is no longer inside it, metres, whatever it rests on.
pub const OUTSIDE_GAP: f32 = 0.05;

/// How far below the floor of a declared compartment its space begins, metres: a plate that is pressed into the wires of a
/// rack sinks so far.
pub const COMPARTMENT_SINK: f32 = 0.025;

/// Least height of a part above a compartment's top for it to be a roof, metres: more than the compartment's
/// own walls stand out by rounding.
pub(crate) const ROOF_LEAST: f32 = 0.005;

/// Greatest number of planes along an axis of the grid in which hollows are searched: shelves have fewer faces,
/// and the number of cells is its third power.
pub(crate) const GRID_PLANES: usize = 28;

/// Least number of cells along an axis of that grid, for shapes that are not made of boxes: a bowl's wall is
/// about an eighth of its width.
pub(crate) const GRID_EVENLY: usize = 8;

/// Planes of that grid that are closer than this are merged, metres: half the thinnest board.
pub(crate) const GRID_THINNEST: f32 = 0.002;

/// A part fills a cell of that grid if it reaches in by more than this share of the cell's size; a part that
/// only shares a face with the cell does not.
pub(crate) const GRID_FILL: f32 = 0.02;

/// Greatest number of slices of a lathe shape (discs and rings) or of an extruded outline (boxes): a bowl's
/// hollow keeps its depth to a sixth.
pub(crate) const SLICES: usize = 6;

/// Slices thinner than this share of the shape's height are omitted: they come from rounding of a profile.
pub(crate) const THIN_SLICE: f32 = 0.01;

/// Number of boxes around a ring: they are within 2% of its radius, so that the rims of plates side by side do not
/// overlap by more than a trace is narrower.
pub(crate) const STAVES: usize = 16;

/// A ring whose hole is a smaller share of its radius is taken as a disc: profiles start a little off the axis.
pub(crate) const AXIS_HOLE: f32 = 0.02;

/// Number of columns along each side over a mesh: as many as cells of the grid.
pub(crate) const COLUMNS: usize = 8;

/// A mesh that fills a larger share of its box is taken as that box.
pub(crate) const FULL_MESH: f32 = 0.9;

/// An agent lies if the upward axis of its box is more than 60 degrees from vertical: the cosine of that angle.
pub(crate) const LYING_TILT: f32 = 0.5;

/// Range of a seat's top within the box of a sitting agent, as shares of the box's height from its bottom:
/// below the middle of the body, above the feet.
pub(crate) const SEAT_RANGE: (f32, f32) = (0.15, 0.65);

/// Half angle of the field of view: the cosine of 75 degrees, VirtualHome's.
pub const FACING_COSINE: f32 = 0.258_8;

/// Greatest distance of a faced thing, metres; VirtualHome's.
pub(crate) const FACING_REACH: f32 = 5.0;

/// Greatest distance of a thing in a doorway or wall from its nearest room, metres: the thickness of an outer
/// wall.
pub(crate) const ROOM_MARGIN: f32 = 0.4;

/// Height of a room above its floor if its box does not give it, metres: a storey.
pub(crate) const STOREY: f32 = 3.0;

/// Distance from a door's leaf at which the rooms on both its sides are searched, metres: outside of the wall
/// it is in, and not past a corridor.
pub(crate) const BESIDE_DOOR: f32 = 0.2;

/// A door's box that is thicker than this share of its width belongs to a leaf that stands open; a frame with
/// its leaf shut has less than half.
pub(crate) const DOOR_SQUARE: f32 = 0.7;

/// VirtualHome: greatest distance from a centre to a box for CLOSE, metres.
pub(crate) const VH_CLOSE: f32 = 1.5;

/// VirtualHome: pairs whose centres are farther apart are ignored, metres.
pub(crate) const VH_FAR: f32 = 5.0;

/// VirtualHome: heights that differ by less are equal, metres: its floors are 9 µm thick, and things on them
/// have their bottom at the floor's centre.
pub(crate) const VH_ROUNDING: f32 = 1e-7;

/// VirtualHome: reach of its box cast up and down, metres.
pub(crate) const VH_CAST: f32 = 0.05;

/// VirtualHome: least share of the footprint that must be above the support.
pub(crate) const VH_FOOTPRINT: f32 = 0.5;

/// Greatest coordinate and size, metres; beyond it single precision does not resolve a millimetre.
pub const WORLD_REACH: f32 = 10_000.0;

/// Greatest deviation of a rotation quaternion's length from one: quaternions rounded to three digits in files
/// pass, invalid ones do not.
pub(crate) const ROTATION_SLACK: f32 = 0.01;
