//! The vocabulary of shapes: solids, surfaces, outlines and frames, from which generators build objects.
//!
//! # Coordinates
//!
//! Lengths are metres and angles radians. Z is up, X forward (towards who uses the object), Y to the left. Points
//! are in the frame of the [`Build`]: the origin is at the centre of the base of the size to fill, unless
//! [`Build::at`] or [`Build::posed`] has moved it. Boxes are given by two corners `low` and `high`, upright bodies by
//! the centre of their `base`, bodies between two points by `from` and `to`, rings and outlines by their points,
//! counter-clockwise seen from where their normal points. The finished asset is moved so that its own base is
//! centred on the origin.
//!
//! # Words
//!
//! | shape | functions |
//! |---|---|
//! | box, rounded box, taper, convex hull | [`Build::block`], [`Build::rounded_block`], [`Build::taper`], [`Build::hull`], [`blocks`] |
//! | cylinder, cone, sphere, rod, capsule | [`Build::cylinder`], [`Build::cone`], [`Build::ball`], [`Build::rod`], [`Build::bar`] |
//! | body of revolution | [`Build::lathe`], [`Build::lathe_along`], [`turn`], [`disc`], [`flat_ring`], [`collar`], with the profiles [`torus_profile`], [`cup_profile`], [`vessel_profile`] |
//! | extrusion | [`Build::prism`], [`ribbon`], with outlines such as [`ngon`], [`star`], [`ellipse`], [`oblong`], [`band`] |
//! | tube | [`Build::pipe`] of capsules; [`tube`] through any points; [`sweep`] in a plane; [`hoop`] closed; [`coil`] a spring |
//! | surface over rings | [`loft`], [`zone`] of a sphere |
//! | sheet | [`sheet`], [`cushion`], [`plate`], [`curved_sheet`] |
//! | hollow | [`tub`] rounded in plan, [`tapered_tub`] of slanted boards, [`basket`], [`case`] open ahead, [`vessel`] round, [`ring_wall`] |
//! | plate with a hole | [`plate_with_hole`] |
//! | lump | [`lump`], [`boulder`], [`blob`], [`limb`], [`Sketch`] |
//!
//! ```
//! use vc_graph::Seed;
//! use vc_graph::nalgebra::Vector3;
//! use vc_shapes::material::POTTERY;
//! use vc_shapes::solid::{Build, tub};
//! use vc_shapes::Style;
//! let style = Style::from_seed(Seed(1));
//! let mut b = Build::new("planter", Vector3::new(0.3, 0.6, 0.25), &style, Seed(1).stream());
//! // Height, half depth, half width of the outside, from the bottom up.
//! tub(&mut b, "tub", &[(0.0, 0.12, 0.27), (0.25, 0.15, 0.3)], 0.4, 0.015, POTTERY);
//! let (asset, bounds) = b.finish();
//! assert_eq!(asset.parts.len(), 1);
//! assert!((bounds.size().z - 0.25).abs() < 1e-4);
//! ```

// Three lofts differ in the order of their triangles, and four rounded rectangles in the number of their points: both
// are part of what a seed generates.
mod body;
mod build;
pub(crate) mod circle;
mod collision;
mod curve;
mod flush;
mod frame;
mod hollow;
mod mesh;
mod outline;
mod profile;
mod proportional;
mod sheet;
mod sketch;
mod skin;

pub use body::{boulder, ear, flat_ring, lump, sweep, turn};
pub(crate) use body::{loft_columns, planar_tube, spun};
pub(crate) use build::P;
pub use build::{Axis, Build};
pub(crate) use curve::rounded_ring;
pub use curve::{arc, arch, level_oval, mix, oval, spaced, spline};
pub use frame::{at_least, facing, fit, lying};
pub(crate) use frame::{dims, half_dims, lengthwise, longwise, pitched, rolled, spare};
pub use hollow::{basket, case, collar, plate_with_hole, ring_wall, tapered_tub, tiers, tub, vessel};
pub(crate) use hollow::{floor_of, loft_levels, pit, plate_with_border, round_floor, walled_tray};
pub use mesh::{MeshBuilder, blocks, cushion, hoop, loft, sheet, tube};
pub(crate) use outline::{
    CORNERS, arc_outline, evenly_spaced_ellipse, oval_outline, polar, rounded_between, rounded_by_share,
};
pub use outline::{band, ellipse, ngon, oblong, polygon, rounded_by_radius, star};
pub use profile::{cup_profile, torus_profile, vessel_profile};
pub(crate) use proportional::{Proportional, Ring, SIDES};
pub(crate) use sheet::hull_shell;
pub use sheet::{Cut, SheetRow, curved_sheet, disc, leg, plate, ribbon};
pub use sketch::{Sketch, blob, limb};
pub(crate) use skin::ring_skin;
pub use skin::{coil, seam, zone};
