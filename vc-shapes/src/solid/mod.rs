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
//! | box, rounded box, taper, convex hull | [`Build::block`], [`Build::soft`], [`Build::taper`], [`Build::hull`], [`blocks`] |
//! | cylinder, cone, sphere, rod, capsule | [`Build::cylinder`], [`Build::cone`], [`Build::ball`], [`Build::rod`], [`Build::bar`] |
//! | body of revolution | [`Build::lathe`], [`Build::lathe_along`], [`turn`], [`spun`], [`disc`], [`flat_ring`], [`collar`], with the profiles [`torus_profile`], [`cup_profile`], [`vessel_profile`] |
//! | extrusion | [`Build::prism`], [`ribbon`], with outlines such as [`ngon`], [`star`], [`ellipse`], [`oblong`], [`band`] |
//! | tube | [`Build::pipe`] of capsules; [`tube`] through any points; [`planar_tube`] and [`sweep`] in a plane; [`hoop`] closed; [`coil`] a spring |
//! | surface over rings | [`loft`], [`loft_columns`], [`loft_levels`], [`ring_skin`] closed in itself, [`zone`] of a sphere |
//! | sheet | [`sheet`], [`puff`] a cushion, [`plate`], [`curved_sheet`], [`hull_shell`] |
//! | hollow | [`tub`] rounded in plan, [`tapered_tub`] of slanted boards, [`walled_tray`], [`pit`], [`basket`], [`case`] open ahead, [`vessel`] round, [`ring_wall`] |
//! | plate with a hole | [`plate_with_hole`], [`plate_with_border`] |
//! | lump | [`lump`], [`boulder`], [`blob`], [`limb`], [`Sketch`] |
//!
//! Three lofts differ in the order of their triangles, and four rounded rectangles in the number of their points;
//! both are part of what a seed generates.
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

mod body;
mod build;
pub(crate) mod circle;
mod curve;
mod frame;
mod hollow;
mod lump;
mod mesh;
mod outline;
mod profile;
mod reveal;
mod sheet;
mod sketch;
mod skin;

pub use body::{boulder, ear, flat_ring, loft_columns, lump, planar_tube, spun, sweep, turn};
pub(crate) use build::P;
pub use build::{Axis, Build};
pub use curve::{arc, arch, level_oval, mix, oval, rounded_ring, spaced, spline};
pub use frame::{at_least, dims, facing, fit, half_dims, lengthwise, longwise, lying, pitched, rolled, spare};
pub use hollow::{
    basket, case, collar, floor_of, loft_levels, pit, plate_with_border, plate_with_hole, ring_wall, round_floor,
    tapered_tub, tiers, tub, vessel, walled_tray,
};
pub use mesh::{MeshBuilder, blocks, hoop, loft, puff, sheet, tube};
pub use outline::{
    CORNERS, arc_outline, band, ellipse, ngon, oblong, oval_outline, polar, polygon, rounded_between,
    rounded_by_radius, rounded_by_share, star,
};
pub use profile::{cup_profile, torus_profile, vessel_profile};
pub use sheet::{Cut, Row, curved_sheet, disc, hull_shell, leg, plate, ribbon};
pub use sketch::{Sketch, blob, limb};
pub use skin::{coil, ring_skin, seam, zone};
pub(crate) use skin::{heading, skinned};
